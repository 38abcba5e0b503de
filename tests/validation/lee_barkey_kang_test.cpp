// Lee, Barkey and Kang, Metal fatigue analysis handbook (2012), the four-point example.

#include "catch.hpp"
#include "validation/counted.hpp"

namespace lee_barkey_kang_test {

using namespace boxbeam;
using namespace published;

namespace {

const std::vector<double> history{2, -1, 3, -5, 1, -3, 4, -4, 2};

}  // namespace

TEST_CASE("Lee, Barkey, Kang: only (1, -3) closes, the residue is 2, -1, 3, -5, 4, -4, 2") {
  const Rows rows = counted(history, {Counting::four_point, Residue::half_cycles});
  CHECK(rows == joined({full(1, -3)}, halves({2, -1, 3, -5, 4, -4, 2})));
}

TEST_CASE("Lee, Barkey, Kang: the residue behind itself closes (2, -1), (-4, 3) and (4, -5)") {
  const Rows closed{full(1, -3), full(2, -1), full(-4, 3), full(4, -5)};
  CHECK(counted(history, {Counting::four_point, Residue::repeated}) == closed);
  CHECK(counted(history, {Counting::periodic}) == closed);
}

}  // namespace lee_barkey_kang_test
