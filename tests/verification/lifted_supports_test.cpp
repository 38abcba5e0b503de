// Supports that pull at a beam which may only lie on them: reactions by statics.

#include "boxbeam/verification/verdict_text.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/refusals.hpp"

namespace lifted_supports_test {

using namespace boxbeam;
using test::contains;

namespace {

std::string said_of(const std::string& supports, const std::string& loads,
                    const std::string& gravity = "0 m/s^2") {
  const Project project = parse_project(
      "lifted.toml",
      "[case]\nname = \"lifted\"\nkind = \"static\"\n[frame]\ngravity = [\"0 m/s^2\", \"" +
          gravity +
          "\"]\n[sections.box]\nkind = \"box\"\nwidth = \"150 mm\"\nheight = \"300 mm\"\n"
          "flange = \"12 mm\"\nweb = \"8 mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\n"
          "[[beam.segments]]\nlength = \"6 m\"\nsection = \"box\"\n" +
          supports + loads + "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n");
  return verdict_text_of(project, verify(project)).whole();
}

std::string support(const std::string& name, const std::string& kind, const std::string& at) {
  return "[supports." + name + "]\nkind = \"" + kind + "\"\nat = \"" + at + "\"\n";
}

std::string force(const std::string& at, const std::string& F) {
  return "[loads.f]\nkind = \"force\"\nat = \"" + at + "\"\nforce = [\"0 kN\", \"" + F + "\"]\n";
}

}  // namespace

TEST_CASE("a roller that holds a beam down is said, with what it pulls", "[frame][unsaid]") {
  // 20 kN on an overhang of 2 m beyond a span of 4 m: 20 kN x 2 m/4 m = 10 kN at the far end.
  const std::string overhang = support("far", "roller", "0 m") + support("near", "pinned", "4 m");
  CHECK(contains(said_of(overhang, force("6 m", "-20 kN")), "hold the frame down: far by 10 kN"));
  CHECK(contains(said_of(overhang, force("6 m", "-20 kN"), "-0.001 m/s^2"),
                 "hold the frame down: far by 10 kN"));
  // Turned over, all of it is upside down, but where gravity says what is down.
  CHECK(contains(said_of(overhang, force("6 m", "20 kN")), "hold the frame down: far by 10 kN"));
  // Between the supports, and on a clamp, nothing is lifted off.
  CHECK(!contains(said_of(overhang, force("2 m", "-20 kN")), "hold the frame down"));
  CHECK(!contains(said_of(support("far", "fixed", "0 m") + support("near", "roller", "4 m"),
                          force("6 m", "-20 kN")),
                  "hold the frame down"));
}

TEST_CASE("a hinge beside rollers is said where it pushes and pulls, else it is made for it",
          "[frame][unsaid]") {
  const std::string overhang = support("far", "pinned", "0 m") + support("near", "roller", "4 m");
  // A wheel of 20 kN that runs over both.
  const std::string wheel =
      "[loads.f]\nkind = \"wheels\"\nwheels = [{ force = [\"0 kN\", \"-20 kN\"] }]\n";
  CHECK(contains(said_of(overhang, wheel), "hold the frame down: far by 10 kN"));
  CHECK(!contains(said_of(overhang, force("6 m", "-20 kN")), "hold the frame down"));
  CHECK(
      !contains(said_of(support("far", "pinned", "0 m") + support("near", "pinned", "4 m"), wheel),
                "hold the frame down"));
}

}  // namespace lifted_supports_test
