// Stresses of warping that no check counts: against closed forms of bars in torsion.

#include "boxbeam/verification/warping_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/verify.hpp"
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

TEST_CASE("in the plane a channel whose web is loaded is said to warp by what turns it",
          "[warping]") {
  // A force in the middle of the web's mid-line, V_z beside the shear centre.
  const double P = 170e3;
  const std::string text = fmt::format(R"([case]
name = "channel"
kind = "static"
[frame]
gravity = ["0 m/s^2", "0 m/s^2"]
[sections.channel]
kind = "thin-walled"
nodes = {{ a = ["90 mm", "140 mm"], b = ["0 mm", "140 mm"], c = ["0 mm", "-140 mm"], d = ["90 mm", "-140 mm"] }}
walls = [
  {{ from = "a", to = "b", thickness = "14 mm" }},
  {{ from = "b", to = "c", thickness = "10 mm" }},
  {{ from = "c", to = "d", thickness = "14 mm" }}
]
[beam]
density = "7850 kg/m^3"
[[beam.segments]]
length = "2 m"
section = "channel"
[supports.a]
kind = "pinned"
at = "0 m"
[supports.b]
kind = "roller"
at = "2 m"
[loads.p]
kind = "force"
at = "1 m"
force = ["0 N", "-{} N"]
moment = "0 N m"
[material]
steel = "S355"
[strength]
required = 1.0
shear_lag = false
)",
                                       P);
  const Verification of = verify(parse_project("channel.toml", text));
  const auto said = std::find_if(of.not_judged.begin(), of.not_judged.end(), [](const auto& what) {
    return what.what == "warping of open sections";
  });
  REQUIRE(said != of.not_judged.end());
  // The shear centre of a channel of thin walls lies e = b^2 h^2 t_f/(4 I_y) behind its web's
  // mid-line (Megson, 17.2.1), b = 90 mm, h = 280 mm: P/2 e is the torque.
  const double I_y = 2.0 * 0.09 * 0.014 * 0.14 * 0.14 + 0.010 * std::pow(0.28, 3) / 12.0;
  const double e = 0.09 * 0.09 * 0.28 * 0.28 * 0.014 / (4.0 * I_y);
  CHECK(said->reason.find(fmt::format("{:.3g} kN m about their shear centre", 0.5e-3 * P * e)) !=
        std::string::npos);
}

}  // namespace warping_notes_test
