// The test series of the C99 library rainflow by A. Martin (https://github.com/a-ma72/rainflow);
// ffpack counts the first of them alike.

#include "catch.hpp"
#include "validation/counted.hpp"

namespace c99_rainflow_test {

using namespace boxbeam;
using namespace published;

namespace {

const Rows none;

}  // namespace

TEST_CASE("C99 rainflow: the long series closes seven cycles and leaves 2, 6, 1, 5, 2") {
  const Rows rows = counted({2, 5, 3, 6, 2, 4, 1, 6, 1, 4, 1, 5, 3, 6, 3, 6, 1, 5, 2},
                            {Counting::four_point, Residue::half_cycles});
  const Rows closed{full(5, 3), full(2, 4), full(1, 6), full(1, 4),
                    full(5, 3), full(6, 3), full(1, 6)};
  CHECK(rows == joined(closed, halves({2, 6, 1, 5, 2})));
}

TEST_CASE("C99 rainflow: 2, 5, 3, 7 closes 5-3, and 7-2 with the residue repeated") {
  CHECK(counted({2, 5, 3, 7}, {Counting::four_point, Residue::repeated}) ==
        Rows{full(5, 3), full(7, 2)});
}

TEST_CASE("C99 rainflow: a series that is all residue") {
  const std::vector<double> series{4.9, 6, 4, 7, 3, 9, 5, 8, 6.9};
  CHECK(counted(series, {Counting::four_point, Residue::discard}) == none);
  CHECK(counted(series, {Counting::four_point, Residue::half_cycles}) == halves(series));
  CHECK(counted(series, {Counting::astm}) == halves(series));
}

}  // namespace c99_rainflow_test
