// Haibach, Betriebsfestigkeit, figure 3.3-30: cycles by four points and their residue.

#include "catch.hpp"
#include "validation/counted.hpp"

namespace haibach_rainflow_test {

using namespace boxbeam;
using namespace published;

namespace {

const std::vector<double> history{2, 5, 3, 6, 2, 3, 1, 6, 1, 4, 2, 3, 1, 4, 2, 5, 3, 4, 2};
const Rows printed{full(5, 3), full(2, 3), full(1, 6), full(2, 3),
                   full(1, 4), full(4, 2), full(3, 4)};

}  // namespace

TEST_CASE("Haibach, figure 3.3-30: cycles in their order, and the residue 2, 6, 1, 5, 2") {
  CHECK(counted(history, {Counting::four_point, Residue::discard}) == printed);
  CHECK(counted(history, {Counting::four_point, Residue::half_cycles}) ==
        joined(printed, halves({2, 6, 1, 5, 2})));
}

TEST_CASE("Haibach, figure 3.3-30 as one period: the residue closes to 5-2 and 6-1") {
  const Rows closed = joined(printed, {full(5, 2), full(6, 1)});
  CHECK(counted(history, {Counting::periodic}) == closed);
  CHECK(counted(history, {Counting::four_point, Residue::repeated}) == closed);
}

}  // namespace haibach_rainflow_test
