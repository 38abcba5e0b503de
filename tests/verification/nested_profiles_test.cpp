// Nested profiles whose outer one alone would not pass: a hand number.

#include <string>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/pressed_beams.hpp"

namespace nested_profiles_test {

using namespace boxbeam;
using pressed_beams::says;

namespace {

/// Under 100 kN at 1.2 m and a force at 2.8 m; from 2 m on with a profile inside [kN].
Verification nested(const char* force) {
  const auto tube = [](const char* name, const char* sizes) {
    return std::string("[sections.") + name + "]\nkind = \"rectangular tube\"\n" + sizes +
           "outer_radius = \"0 mm\"\n";
  };
  return verify(parse_project(
      "a.toml",
      "[case]\nname = \"a\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
          tube("in", "width = \"260 mm\"\nheight = \"360 mm\"\nwall = \"16 mm\"\n") +
          tube("out", "width = \"300 mm\"\nheight = \"400 mm\"\nwall = \"10 mm\"\n") +
          "[sections.both]\nkind = \"nested\"\nouter = \"out\"\ninner = \"in\"\n[beam]\ndensity = "
          "\"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"2 m\"\nsection = "
          "\"out\"\n[[beam.segments]]\nlength = \"2 m\"\nsection = "
          "\"both\"\n[supports.a]\nkind = \"pinned\"\nat = \"0 m\"\n[supports.b]\nkind = "
          "\"roller\"\nat = \"4 m\"\n[loads.p]\nkind = \"force\"\nat = \"1.2 m\"\nforce = [\"0 "
          "kN\", \"-100 kN\"]\n[loads.q]\nkind = \"force\"\nat = \"2.8 m\"\nforce = [\"0 kN\", \"" +
          force +
          "\"]\n[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n[strength]\nrequired = "
          "1.0\n"));
}

}  // namespace

// By hand: M = 520 x 1.2 = 624 kN m at 2.8 m; I = 300 x 400^3/12 - 280 x 380^3/12 = 319.7e6 mm^4:
// 390 MPa on 355, 1.10. Under 500 kN 456 kN m: 0.80.
TEST_CASE("what ties nested profiles stands in the line where the outer one alone fails") {
  CHECK(says(nested("-700 kN"), "the outer alone is used by 1.1 at s = 2.8"));
  CHECK_FALSE(says(nested("-500 kN"), "what ties"));
}

}  // namespace nested_profiles_test
