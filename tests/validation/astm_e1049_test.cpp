// ASTM E1049-85 (2017), Standard practices for cycle counting in fatigue analysis: figures 6 and 7.

#include "catch.hpp"
#include "validation/counted.hpp"

namespace astm_e1049_test {

using namespace boxbeam;
using namespace published;

namespace {

const std::vector<double> figure_6{-2, 1, -3, 5, -1, 3, -4, 4, -2};

}  // namespace

TEST_CASE("ASTM E1049, figure 6: ranges, means and halves in the order of the standard") {
  const Rows printed{{3, -0.5, 0.5},  // A-B
                     {4, -1.0, 0.5},  // B-C
                     {4, 1.0, 1.0},   // E-F
                     {8, 1.0, 0.5},   // C-D
                     {9, 0.5, 0.5},   // D-G
                     {8, 0.0, 0.5},   // G-H
                     {6, 1.0, 0.5}};  // H-I
  CHECK(counted(figure_6, {Counting::astm}) == printed);
}

TEST_CASE("ASTM E1049, figure 6 by four points: E-F closes, the rest are the same halves") {
  const Rows rows = counted(figure_6, {Counting::four_point, Residue::half_cycles});
  CHECK(rows == joined({full(-1, 3)}, halves({-2, 1, -3, 5, -4, 4, -2})));
}

TEST_CASE("ASTM E1049, figure 7, a repeating history: full cycles of 4, 3, 7 and 9") {
  const Rows from_highest{full(-1, 3), full(-2, 1), full(-3, 4), full(5, -4)};
  CHECK(counted({5, -1, 3, -4, 4, -2, 1, -3, 5}, {Counting::periodic}) == from_highest);
  // The same period as figure 6 cuts it.
  CHECK(counted(figure_6, {Counting::periodic}) == from_highest);
}

}  // namespace astm_e1049_test
