// Stresses of warping that no check counts: against closed forms of bars in torsion.

#include "boxbeam/verification/warping_notes.hpp"

#include <cmath>

#include "catch.hpp"

namespace warping_notes_test {

using namespace boxbeam;

TEST_CASE("no bar in torsion has a larger bimoment than the bound", "[warping]") {
  // As of a welded I of 400 x 200 x 14 x 8 mm.
  const double GI_T = 81e9 * 0.43e-6, EI_w = 210e9 * 0.695e-6, T = 3e3;
  const double k = std::sqrt(GI_T / EI_w);
  for (const double length : {0.5, 2.0, 6.0, 20.0}) {
    const double bound = largest_bimoment(T, GI_T, EI_w, length);
    // Between forks, 2 T in the middle; clamped at one end, T at the free one; clamped at both.
    CHECK(bound >= T / k * std::tanh(0.5 * k * length));
    CHECK(bound == Approx(T / k * std::tanh(k * length)).epsilon(1e-12));
    CHECK(bound <= T * length);
  }
}

}  // namespace warping_notes_test
