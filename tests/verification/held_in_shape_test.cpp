// Diaphragms that keep a box in shape: their fillets and plates, in fatigue and with what forces
// put there, by hand.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/distorted_boxes.hpp"
#include "support/gates.hpp"

namespace held_in_shape_test {

using namespace boxbeam;
using distorted_boxes::estimate_of;
using distorted_boxes::twist;

namespace {

/// A box of 6 m on forks, 800 x 800 x 20, with a diaphragm of 12 mm at 3 m and such at its ends
/// as bear all; where there are cycles its load "f" comes and goes.
Project forked(const std::string& throat, const std::string& more, double cycles,
               const std::string& opening = "") {
  std::string text =
      "[case]\nname = \"a\"\nkind = \"static\"\n[frame]\nspace = true\n"
      "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n[material]\nsteel = \"S355\"\n"
      "fy_source = \"EN 1993-1-1\"\n[strength]\nrequired = 1.0\n"
      "[sections.s]\nkind = \"box\"\nwidth = \"800 mm\"\nheight = \"800 mm\"\n"
      "flange = \"20 mm\"\nweb = \"20 mm\"\nseam_throat = \"20 mm\"\n"
      "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"6 m\"\nsection = \"s\"\n"
      "[supports.a]\nkind = \"pinned\"\nat = [\"0 m\", \"0 m\", \"0 m\"]\nfork = true\n"
      "[supports.z]\nkind = \"roller\"\nat = [\"6 m\", \"0 m\", \"0 m\"]\ndirection = \"z\"\n"
      "fork = true\n[supports.y]\nkind = \"roller\"\nat = [\"6 m\", \"0 m\", \"0 m\"]\n"
      "direction = \"y\"\n";
  for (const char* end : {"0", "6"})
    text += fmt::format(
        "[[beam.diaphragms]]\nstation = \"{} m\"\nthickness = \"20 mm\"\nthroat = \"30 mm\"\n",
        end);
  text += "[[beam.diaphragms]]\nstation = \"3 m\"\nthickness = \"12 mm\"\n";
  if (!throat.empty()) text += "throat = \"" + throat + "\"\n";
  text += opening + more;
  if (cycles > 0.0)
    text += fmt::format(
        "[[situations]]\nname = \"off\"\nloads = {{  }}\n[[situations]]\nname = \"on\"\n"
        "loads = {{ f = 1.0 }}\n[[situations]]\nname = \"change\"\nbetween = [\"off\", "
        "\"on\"]\ncycles = {}\n"
        "[fatigue]\nloading = \"spectrum\"\ncategory = 71\ngamma_Ff = 1.0\ngamma_Mf = 1.35\n"
        "required = 1.0\n",
        cycles);
  return parse_project("a.toml", text);
}

std::string introduction(double from, double to, const std::string& what) {
  return fmt::format("[[beam.load_introductions]]\nfrom = \"{} m\"\nto = \"{} m\"\n{}\n", from, to,
                     what);
}

}  // namespace

TEST_CASE("welds of a diaphragm that a torque beside it stresses anew are named", "[distortion]") {
  // As where it stands on it.
  const auto named = [](double at) {
    const Verification of = verify(forked(
        "10 mm", introduction(2.0, 4.0, "stiff_length = \"1 m\"") + twist("f", at, 200e3), 1e5));
    return std::any_of(of.not_judged.begin(), of.not_judged.end(), [](const NotJudged& it) {
      return it.by == Criterion::weld && it.what.find("the torque of f") != std::string::npos;
    });
  };
  CHECK(named(3.0));
  CHECK(named(2.7));
}

TEST_CASE("what keeps a box in shape shears a diaphragm's fillets anew at every cycle",
          "[distortion]") {
  const double T = 900e3, a = 0.003, b = 0.78, cycles = 2e6;
  const auto load = [&](double torque) {
    return introduction(2.9, 3.1, "into = \"webs\"\ntorque_by = \"webs\"") +
           twist("f", 3.0, torque);
  };
  const auto held = [](const Project& project) {
    const DistortionEstimate of = estimate_of(project);
    REQUIRE(of.held.size() == 3);
    const auto middle = [](const auto& it) { return std::abs(it.s.value() - 3.0) < 1e-9; };
    const auto at = std::find_if(of.held.begin(), of.held.end(), middle);
    REQUIRE(at != of.held.end());
    return *at;
  };
  // By hand: half of the torque goes by the diaphragm to the flanges, along each edge T/(2 b); on
  // two fillets. Category 80 at 2e6 cycles.
  const auto of = held(forked("3 mm", load(T), cycles));
  CHECK(of.s.value() == Approx(3.0));
  CHECK(of.shear.value() == Approx(T / (2.0 * b)).epsilon(0.03));
  CHECK(of.range.value() == Approx(of.shear.value() / (2.0 * a * b)).epsilon(1e-6));
  CHECK(of.life == Approx(1.35 * of.range.value() / 80e6).epsilon(1e-6));
  CHECK(of.life > 2.0);
  const Verification stopped = verify(forked("3 mm", load(T), cycles));
  CHECK(stopped.verdict == Verdict::not_applicable);
  // Where nothing is said half as thick as the diaphragm.
  CHECK(held(forked("", load(T), cycles)).life ==
        Approx(held(forked("6 mm", load(T), cycles)).life));
  // What holds is said.
  const Verification holds = verify(forked("3 mm", load(0.3 * T), cycles));
  CHECK(std::any_of(holds.not_judged.begin(), holds.not_judged.end(), [](const NotJudged& it) {
    return it.by == Criterion::distortion_fatigue && it.what.find("s = 3 m") != std::string::npos;
  }));
  CHECK(held(forked("3 mm", load(T), 0.0)).life == 0.0);
  // Strips of the plate beside an opening bend: more than the fillets, of category 36.
  CHECK(held(forked("12 mm", load(0.2 * T), cycles, "opening = \"500 mm\"\n")).life >
        held(forked("12 mm", load(0.2 * T), cycles)).life);
}

TEST_CASE("a diaphragm bears what keeps the box in shape and the forces that it takes",
          "[distortion]") {
  // By hand: of both along the web the sum, across and along the flange's weld the vector; less
  // what of d a force's own couple is, T/2.
  const Project project = forked("3 mm", twist("f", 3.0, 100e3), 0.0);
  DistortionEstimate estimate;
  DistortionEstimate::Holding held;
  held.s = si<Length>(3.0);
  held.plate = 0.4;
  held.welds = 0.5;
  held.d = si<Moment>(100.0);
  estimate.held = {held};
  using Part = IntoDiaphragm::Part;
  const auto stops = [&](Part part, double use, double turns = 0.0, double s = 3.0) {
    const std::vector<Gate> gates = shared_diaphragm_gates_of(
        project, {estimate}, {{si<Length>(s), part, "g", use, si<Moment>(turns)}}, {});
    return !gates.empty() && gates.front().blocks;
  };
  CHECK(stops(Part::web_weld, 0.51));
  CHECK_FALSE(stops(Part::web_weld, 0.49));
  CHECK(stops(Part::plate, 0.61));
  CHECK_FALSE(stops(Part::plate, 0.59));
  CHECK(stops(Part::flange_weld, 0.87));
  CHECK_FALSE(stops(Part::flange_weld, 0.86));
  CHECK_FALSE(stops(Part::web_weld, 0.9, 200.0));
  CHECK(stops(Part::web_weld, 0.76, 100.0));
  CHECK_FALSE(stops(Part::web_weld, 0.9, 0.0, 2.9));

  // 400 kN on either web, 400/(2 x 3 x 754)/251 = 0.35, and a torque beside it that shears the
  // fillets by T/(2 b) at most, 1500/1.56/(2 x 3 x 780)/251 = 0.82.
  const auto stopped = [](double force, double torque) {
    std::string more = introduction(3.05, 3.15, "into = \"webs\"\ntorque_by = \"webs\"") +
                       introduction(2.9, 3.1, "stiff_length = \"100 mm\"");
    for (const double y : {0.39, -0.39})
      more += fmt::format(
          "[loads.{}]\nkind = \"force\"\nat = [\"3 m\", \"{} m\", \"0 m\"]\n"
          "force = [\"0 N\", \"0 N\", \"{} N\"]\n",
          y > 0.0 ? "left" : "right", y, -force);
    const Verification of = verify(forked("3 mm", more + twist("t", 3.1, torque), 0.0));
    return test::has_gate(of, "diaphragm at s = 3 m: so that the box");
  };
  CHECK(stopped(400e3, 1500e3));
  CHECK_FALSE(stopped(400e3, 150e3));
  CHECK_FALSE(stopped(1e3, 1500e3));
}

}  // namespace held_in_shape_test
