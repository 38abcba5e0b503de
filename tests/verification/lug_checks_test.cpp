// Plates of pins in fatigue: hand values, and every direction and instant looked at one by one.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/fatigue/rainflow.hpp"
#include "boxbeam/report/remarks.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/verification/motion_result.hpp"
#include "boxbeam/verification/neighbours.hpp"
#include "boxbeam/verification/verify.hpp"
#include "support/changed_rig.hpp"
#include "support/factor_of_sheet.hpp"
#include "support/held_bar.hpp"
#include "support/refusals.hpp"

namespace lug_checks_test {

using namespace boxbeam;

namespace {

const std::string flat = "kind = \"plate\"\nwidth = \"50 mm\"\nheight = \"100 mm\"\n";

std::string pin(const std::string& joint, const std::string& lugs) {
  return "[[pins]]\nname = \"p\"\njoint = \"" + joint +
         "\"\ndiameter = \"50 mm\"\nhole = \"50 mm\"\ninner_plate = \"20 mm\"\nouter_plate = \"10 "
         "mm\"\n" +
         lugs;
}

std::string lug(const std::string& plate, const std::string& more = "") {
  return "[[pins.lugs]]\nplate = \"" + plate + "\"\nwidth = \"100 mm\"\n" + more;
}

/// A force on the bar's pinned end, which goes into that pin alone.
std::string swing(const std::string& name, double degrees, double kN, double phase = 0.0) {
  return fmt::format(
      "[forces.{}]\nkind = \"force\"\npoint = \"bar.A\"\ndirection = \"{} deg\"\nlaw = {{ kind = "
      "\"harmonic\", mean = \"0 N\", amplitude = \"{} kN\", phase = \"{} deg\", frequency = "
      "\"0.001 Hz\" }}\n",
      name, degrees, kN, phase);
}

/// The bar of 800 N, half of it on each of its ends.
Project held(const std::string& behind) { return test::held_bar(true, flat, behind); }

std::vector<NeighbourResult> lugs_of(const Project& project) {
  return check_lugs(project, run_situations(project)).results;
}

}  // namespace

TEST_CASE("a lug under a force that swings: its range and its life by hand") {
  // 100 kN to and fro; of 50 of 100 mm K_t is 2.507, A_net 50 x 20 = 1000 mm^2: 501.4 MPa of
  // range. Of 1e6 cycles category 100 bears 100 MPa 2^(1/3) = 126 MPa.
  const std::vector<NeighbourResult> found =
      lugs_of(held(swing("f", 30.0, 100.0) + pin("A", lug("inner"))));
  REQUIRE(found.size() == 1);
  const Check& check = found.front().check;
  CHECK(check.id == "lug-fatigue/p-inner-plate");
  CHECK_FALSE(check.on_beam);
  const double range = 2.507125 * 200e3 / 1e-3;
  CHECK(check.acting.value() == Approx(range).epsilon(1e-5));
  CHECK(check.safety_factor == Approx(100e6 * std::cbrt(2.0) / range).epsilon(1e-5));
  CHECK(check.required == 1.0);
  const auto& tired = std::get<TiredLug>(found.front().basis);
  CHECK(tired.range.value() == Approx(200e3).epsilon(1e-5));
  // Along the force, in the axes of the ground or of the bar, which lie alike.
  CHECK(std::remainder(tired.direction - std::numbers::pi / 6.0, std::numbers::pi) ==
        Approx(0.0).margin(2e-2));
}

TEST_CASE("a force that turns with one size has the range of its diameter") {
  const std::string turning = swing("x", 0.0, 100.0) + swing("y", 90.0, 100.0, 90.0);
  const NeighbourResult found = lugs_of(held(turning + pin("A", lug("inner")))).front();
  CHECK(found.check.acting.value() == Approx(2.507125 * 200e3 / 1e-3).epsilon(1e-4));
}

TEST_CASE("a lug that turns under a weight that does not: the range is in the axes of its body") {
  // 0.05 x 0.1 x 2 m^3 of 8000 kg/m^3 weigh 800 N under 10 m/s^2; once in 1000 s the bar's own
  // centrifugal force is 80 (2 pi/1000)^2 = 3 mN. In the axes of the ground nothing changes.
  const Project project = parse_project(
      "crank.toml",
      "[case]\nname = \"crank\"\nkind = \"planar\"\n"
      "[mechanism]\ngravity = [\"0 m/s^2\", \"-10 m/s^2\"]\n"
      "[bodies.bar]\npoints = { A = [\"0 m\", \"0 m\"] }\n"
      "sketch = { at = [\"0 m\", \"0 m\"] }\n"
      "[joints.A]\nkind = \"pin\"\nconnect = [\"bar.A\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
      "[drivers.motor]\npoint = \"bar.A\"\ncoordinate = \"angle\"\nkind = \"constant rate\"\n"
      "start = \"0 deg\"\nrate = \"0.06 rpm\"\n[sections.bar]\n" +
          flat +
          "[beam]\nbody = \"bar\"\ndensity = \"8000 kg/m^3\"\n"
          "[[beam.segments]]\nlength = \"2 m\"\nsection = \"bar\"\n"
          "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n"
          "[fatigue]\ncategory = 100\ncycles = 1e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
          "required = 1.0\n" +
          pin("A", lug("inner")));
  const NeighbourResult found = lugs_of(project).front();
  const auto& tired = std::get<TiredLug>(found.basis);
  CHECK(tired.seen.find("in the axes of bar") != std::string::npos);
  CHECK(tired.range.value() == Approx(1600.0).epsilon(1e-4));
}

TEST_CASE("each outer plate takes half; the case's own factor and detail hold") {
  const std::string force = swing("f", 0.0, 100.0);
  const auto found = lugs_of(held(force + pin("A", lug("inner") + lug("outer"))));
  REQUIRE(found.size() == 2);
  CHECK(found[1].check.id == "lug-fatigue/p-outer-plates");
  // Half of the force on half of the thickness.
  CHECK(found[1].check.acting.value() == Approx(found[0].check.acting.value()).epsilon(1e-9));
  const auto own = lugs_of(held(
      force + pin("A", lug("inner", "stress_factor = 1.0\ncategory = 56\nname = \"tested\"\n"))));
  CHECK(own.front().check.acting.value() == Approx(200e6).epsilon(1e-5));
  CHECK(own.front().check.safety_factor == Approx(56.0 * std::cbrt(2.0) / 200.0).epsilon(1e-5));
}

TEST_CASE(
    "the default detail of lugs lies nowhere above category E of AISC 360 on the net section") {
  // Recalled: (11e8/N)^(1/3) ksi, threshold 4.5 ksi; of d_0/w at most 0.5.
  const Project project = held(swing("f", 0.0, 100.0) + pin("A", lug("inner")));
  const LugInput& of = project.pins.front().lugs.front();
  const SnCurve curve = curve_of(of.detail.detail);
  for (double N = 1e4; N < 1e9; N *= 1.5) {
    const double ours =
        strength_at(curve, N, Loading::constant_amplitude).value() / of.detail.stress_factor;
    CAPTURE(N);
    CHECK(ours <= 6.895e6 * std::max(std::cbrt(11e8 / N), 4.5));
  }
  CHECK(of.detail.detail.unconfirmed);
}

TEST_CASE("few cycles: the range of a lug is limited by 1.5 f_y") {
  Project project = held(swing("f", 0.0, 100.0) + pin("A", lug("inner")));
  for (Situation& situation : project.situations) situation.cycles = 1e5;
  CHECK(std::get<TiredLug>(lugs_of(project).front().basis).limit == std::nullopt);
  for (Situation& situation : project.situations) situation.cycles = 1e3;
  const NeighbourResult found = lugs_of(project).front();
  // 20 mm of S355 by EN 10025-2: 345 MPa.
  REQUIRE(std::get<TiredLug>(found.basis).limit);
  CHECK(found.check.safety_factor == Approx(1.5 * 345.0 / 501.425).epsilon(1e-5));
}

TEST_CASE("a lug whose force does not change says that it is not judged") {
  const Project project =
      test::held_bar(true, flat, pin("A", lug("inner")) + "[motion]\nduration = \"0.001 s\"\n");
  const NeighbourChecks found = check_lugs(project, run_situations(project));
  CHECK(found.results.empty());
  REQUIRE(found.not_judged.size() == 1);
  CHECK(found.not_judged.front().what == "fatigue of p inner plate");
}

TEST_CASE("the rig's hub as lugs: no direction in either body's axes is used more") {
  const std::string lines =
      "\n[[pins]]\nname = \"hub pin\"\njoint = \"A\"\ndiameter = \"80 mm\"\ninner_plate = \"60 "
      "mm\"\nouter_plate = \"30 mm\"\n[[pins.lugs]]\nplate = \"inner\"\nwidth = \"200 mm\"\n";
  const Project project = parse_project("rig.toml", test::rig_text({}, lines));
  const NeighbourResult found = lugs_of(project).front();
  const LugInput& of = project.pins.front().lugs.front();
  const double factor = of.detail.stress_factor / lug_net_area(of.plate).value();
  const auto& planar = planar_of(project);
  const auto [a, b] =
      planar::ends_of(planar.joints[static_cast<std::size_t>(project.pins.front().joint)]);
  std::vector<double> times;
  constexpr int instants = 1500;
  for (int i = 0; i < instants; ++i) times.push_back(i / 0.7 / instants);
  const MotionResult motion = motion_of(project, times);
  double most = 0.0;
  for (const int body : {a.body, b.body}) {
    for (int k = 0; k < 180; ++k) {
      std::vector<Stress> history;
      for (const InstantResult& state : motion.states) {
        double angle = 0.0;
        for (const BodyMotion& at : state.bodies) {
          if (body >= 0 && at.name == planar.bodies[static_cast<std::size_t>(body)].name)
            angle = at.position.z();
        }
        for (const JointReaction& reaction : state.reactions) {
          if (reaction.joint != "A") continue;
          const double way = angle + k * std::numbers::pi / 180.0;
          history.push_back(si<Stress>(
              factor * (reaction.force.x() * std::cos(way) + reaction.force.y() * std::sin(way))));
        }
      }
      std::vector<Cycle> cycles = count_periodic_cycles(history);
      for (Cycle& cycle : cycles) cycle.count *= project.situations.front().cycles;
      // A spectrum's damage rises with the loads without end.
      most = std::max(
          most, 1.0 / largest_factor(cycles, curve_of(of.detail.detail), project.fatigue.demand));
    }
  }
  CHECK(most > 0.0);
  CHECK(most <= 1.0 / found.check.safety_factor * (1.0 + 1e-9));
  CHECK(most >= 1.0 / found.check.safety_factor * (1.0 - 2e-3));
}

TEST_CASE("lugs in the verdict: strength by table 3.9, sheets, remarks") {
  const Project project =
      held(swing("f", 0.0, 20.0) + pin("A", lug("inner", "end = \"60 mm\"\n") + lug("outer")));
  const Verification of = verify(project);
  std::size_t seen = 0;
  for (const CheckResult& result : of.checks) {
    if (!result.check.point.starts_with("p ")) continue;
    const report::Sheet sheet = test::sheet_to_factor(project, of, result);
    for (const report::Step& step : sheet.steps) {
      if (step.symbol == "d_sigma")
        CHECK(1e6 * std::stod(step.formulas.back()) ==
              Approx(result.check.acting.value()).epsilon(6e-4));
    }
    ++seen;
    if (result.check.criterion != Criterion::pin || result.check.point != "p inner plate") continue;
    // c = 25 mm bears 2 20 345 (25 - 16.67) = 115 kN, the end 2 20 345 (60 - 33.3) more; the
    // largest force has the bar's 400 N up with the 20 kN across.
    CHECK(result.check.resisting.value() == Approx(115e3).epsilon(1e-9));
    CHECK(result.check.acting.value() == Approx(std::hypot(20e3, 400.0)).epsilon(1e-6));
  }
  CHECK(seen == 4);
  const auto said = [](const Project& at, const std::string& words) {
    const Verification result = verify(at);
    const std::vector<Remark> remarks = remarks_of(at, result);
    return std::any_of(remarks.begin(), remarks.end(), [&](const Remark& remark) {
      return remark.text.find(words) != std::string::npos;
    });
  };
  CHECK(said(held(swing("f", 0.0, 20.0) + pin("A", lug("inner"))),
             "pin p: the fatigue of its outer plates is not judged"));
  CHECK(said(project, "unconfirmed"));
  CHECK(said(held(pin("A", "")), "pin p: the fatigue of its plates is not judged"));
  CHECK_FALSE(said(held(swing("f", 0.0, 20.0) + pin("A", lug("inner") + lug("outer"))),
                   "is not judged, nor what stands"));
}

TEST_CASE("lugs of which K_t is not known want a factor of their own") {
  const auto said = [](const std::string& lines) {
    return test::refusal_of([&] { return held(pin("A", lines)); });
  };
  CHECK(said(lug("inner")).empty());
  CHECK(said(lug("inner") + lug("inner")).find("there already") != std::string::npos);
  const std::string narrow = "[[pins.lugs]]\nplate = \"inner\"\nwidth = \"95 mm\"\n";
  CHECK(said(narrow).find("write stress_factor") != std::string::npos);
  CHECK(said(narrow + "stress_factor = 3.0\n").empty());
  CHECK(said("[[pins.lugs]]\nplate = \"inner\"\nwidth = \"80 mm\"\nstress_factor = 3.0\n")
            .find("bears nothing") != std::string::npos);
  CHECK(said(lug("inner", "kind = \"shear\"\ncategory = 80\n")).find("direct stress") !=
        std::string::npos);
}

}  // namespace lug_checks_test
