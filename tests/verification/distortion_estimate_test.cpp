// Distortion of the boxes of a case: hand values, an exhaustive search of the ways in which torques
// may come, and where it stops a verdict.

#include "boxbeam/verification/distortion_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/strength/box_distortion.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"

namespace distortion_estimate_test {

using namespace boxbeam;

namespace {

constexpr double E = 210e9, G = 81e9, nu = 0.5 * E / G - 1.0;

/// The mid-lines of the box of the case: 600 x 1200, flanges 12, webs 8.
BoxCell cell(double height = 1.2) {
  return {si<Length>(0.6),
          si<Length>(height),
          {si<Length>(0.012), si<Length>(0.012), si<Length>(0.008), si<Length>(0.008)}};
}

std::string box(const std::string& name, double height, int flange = 12, int web = 8) {
  return fmt::format(
      "[sections.{}]\nkind = \"box\"\nwidth = \"{} mm\"\nheight = \"{} mm\"\n"
      "flange = \"{} mm\"\nweb = \"{} mm\"\n",
      name, 600 + web, 1e3 * height + flange, flange, web);
}

std::string twist(const std::string& name, double at, double torque) {
  return fmt::format(
      "[loads.{}]\nkind = \"force\"\nat = \"{} m\"\nforce = [\"0 N\", \"0 N\", \"0 N\"]\n"
      "moment = [\"{} N m\", \"0 N m\", \"0 N m\"]\n",
      name, at, torque);
}

std::string diaphragm(double at, const std::string& thickness = "10 mm") {
  return fmt::format("[[beam.diaphragms]]\nstation = \"{} m\"\nthickness = \"{}\"\n", at,
                     thickness);
}

const std::string one_segment = "[[beam.segments]]\nlength = \"100 m\"\nsection = \"a\"\n";

/// A box of 100 m in space, clamped at its start and without weight, with a force at its end.
Project beam(const std::string& more, const std::string& segments = one_segment,
             double tip = -1e3) {
  return parse_project(
      "box.toml",
      "[case]\nname = \"box\"\nkind = \"static\"\n[frame]\nspace = true\n"
      "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n[material]\nsteel = \"S355\"\n"
      "[strength]\nrequired = 1.0\nshear_lag = false\n" +
          box("a", 1.2) + box("b", 0.6) + box("stout", 1.2, 40, 40) +
          "[sections.round]\nkind = \"round tube\"\ndiameter = \"600 mm\"\nwall = \"12 mm\"\n"
          "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n"
          "[loads.tip]\nkind = \"force\"\nat = \"100 m\"\nforce = [\"0 N\", \"0 N\", " +
          fmt::format("\"{} N\"]\n", tip) +
          "[beam]\ndensity = \"7850 kg/m^3\"\nfrom = [\"0 m\", \"0 m\", \"0 m\"]\naxis = \"x\"\n"
          "z = \"z\"\n" +
          segments + more);
}

std::vector<DistortionEstimate> estimates_of(const Project& project) {
  return estimate_distortion(project, run_situations(project));
}

DistortionEstimate estimate_of(const Project& project) {
  const std::vector<DistortionEstimate> all = estimates_of(project);
  REQUIRE(all.size() == 1);
  return all.front();
}

const Gate* gate_of(const Verification& of) {
  for (const Gate& gate : of.gates)
    if (gate.finding.find("distortion") != std::string::npos) return &gate;
  return nullptr;
}

}  // namespace

TEST_CASE("an eccentric load distorts a long box as by hand", "[distortion]") {
  // 60 kN m at 50 m, by two web forces of 100 kN: M_D = P/(4 lambda) of a web, v = P lambda/(2 k),
  // far from both ends. At the wall a diaphragm takes what comes there.
  const double b = 0.6, h = 1.2, P = 100e3;
  const auto D = [](double t) { return E * t * t * t / (12.0 * (1.0 - nu * nu)); };
  const double per_corner = 1.0 / (h / D(0.008) + b / D(0.012));
  const double k = 192.0 / (b * b) * per_corner, I_D = h * h * (b * 0.012 + h * 0.008) / 12.0;
  const double lambda = std::pow(k / (4.0 * E * I_D), 0.25);
  const DistortionEstimate of =
      estimate_of(beam(twist("eccentric", 50.0, P * b) + diaphragm(0.0, "50 mm")));
  // Shear of the plates, left out by hand, changes less than 2 %.
  CHECK(of.along.value() == Approx(P / (4.0 * lambda) * h / (2.0 * I_D)).epsilon(0.02));
  const double m = 6.0 * (4.0 * P * lambda / (2.0 * k) / b) * per_corner;
  CHECK(of.across.value() == Approx(6.0 * m / (0.008 * 0.008)).epsilon(0.02));
  CHECK(of.station.s.value() == Approx(50.0));
  CHECK(of.introduced.value() == Approx(50.0));
  CHECK(of.torque.value() == Approx(60e3));
  CHECK(of.spacing.value() == Approx(0.5 / lambda).epsilon(1e-6));
  CHECK(of.used == Approx((of.along + of.across).value() / 355e6).epsilon(1e-3));
  // M = 1 kN 100 m at the wall.
  const double I_y = (0.608 * std::pow(1.212, 3) - 0.592 * std::pow(1.188, 3)) / 12.0;
  CHECK(of.bending.value() == Approx(1e5 * 0.5 * h / I_y).epsilon(1e-6));
  REQUIRE(of.places.size() == 2);
  CHECK(of.places.back().value() == Approx(50.0));

  // At the free end by the wall four times as much across.
  const DistortionEstimate open = estimate_of(beam(twist("eccentric", 50.0, P * b)));
  CHECK(open.across.value() == Approx(4.0 * of.across.value()).epsilon(0.02));
  CHECK(open.station.s.value() == 0.0);

  const DistortionEstimate twice =
      estimate_of(beam(twist("eccentric", 50.0, 2.0 * P * b) + diaphragm(0.0, "50 mm")));
  CHECK(twice.along.value() == Approx(2.0 * of.along.value()).epsilon(1e-9));
  CHECK(twice.across.value() == Approx(2.0 * of.across.value()).epsilon(1e-9));
}

TEST_CASE("what torques do together is the most of all ways in which they come", "[distortion]") {
  // By webs or by flanges, each: every sign of every d, by exhaustion.
  const std::vector<double> at{48.0, 51.0, 53.5}, torques{60e3, -25e3, 80e3};
  std::string loads = diaphragm(0.0, "50 mm") + diaphragm(50.0, "1 mm");
  for (std::size_t i = 0; i < at.size(); ++i)
    loads += twist("t" + std::to_string(i), at[i], torques[i]);
  const DistortionEstimate of = estimate_of(beam(loads));

  DistortedBeam model = distorted_beam(
      {0.0, 48.0, 50.0, 51.0, 53.5, 100.0}, [](double) { return cell(); }, E, nu);
  for (const auto& [s, t] : {std::pair{0.0, 0.05}, std::pair{50.0, 0.001}})
    model.diaphragms[model.nearest(s)] = G * t * 0.6 * 1.2;
  const DistortionSolver solver(model);
  const CellDistortion stiffness = cell_distortion_of(cell(), E, nu);
  double along = 0.0, across = 0.0;
  for (int ways = 0; ways < 16; ++ways) {
    std::vector<double> loads_at(model.nodes.size(), 0.0);
    for (std::size_t i = 0; i < at.size(); ++i)
      loads_at[model.nearest(at[i])] = ((ways >> i) & 1 ? 0.5 : -0.5) * torques[i];
    loads_at.front() = (ways & 8 ? 0.5 : -0.5) * 115e3;  // at the wall
    const Distortion found = solver.solve(loads_at);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      along =
          std::max(along, std::abs(found.warping_stress(i, stiffness, CellCorner::bottom_right)));
      across = std::max(across, found.frame_stress(i, stiffness, cell(), CellCorner::top_left));
    }
  }
  CHECK(of.along.value() == Approx(along).epsilon(1e-6));
  CHECK(of.across.value() == Approx(across).epsilon(1e-6));
}

TEST_CASE("a box that an eccentric load distorts gets no verdict without diaphragms",
          "[distortion]") {
  // 34 MPa along, 75 MPa across in the middle and four times that at the wall.
  const std::string load = twist("eccentric", 50.0, 60e3);
  const Verification without = verify(beam(load, one_segment, -20e3));
  CHECK(without.verdict == Verdict::not_applicable);
  REQUIRE(gate_of(without) != nullptr);
  CHECK(gate_of(without)->blocks);
  CHECK(gate_of(without)->finding.find("[[beam.diaphragms]]: at s = 0 m, 50 m") !=
        std::string::npos);

  const Verification with =
      verify(beam(load + diaphragm(0.0) + diaphragm(50.0), one_segment, -20e3));
  CHECK(with.verdict == Verdict::pass);
  CHECK((gate_of(with) == nullptr || !gate_of(with)->blocks));

  // A diaphragm half a metre beside the load leaves what the beam between them has.
  const Verification beside =
      verify(beam(load + diaphragm(0.0) + diaphragm(50.5), one_segment, -20e3));
  REQUIRE(gate_of(beside) != nullptr);
  CHECK_FALSE(gate_of(beside)->blocks);
}

TEST_CASE("distortion for which strength leaves room is a remark, without fatigue",
          "[distortion]") {
  const std::string load = twist("eccentric", 50.0, 60e3) + diaphragm(0.0, "50 mm");
  const Verification slight =
      verify(beam(twist("eccentric", 50.0, 600e3) + diaphragm(0.0, "50 mm"),
                  "[[beam.segments]]\nlength = \"100 m\"\nsection = \"stout\"\n"));
  REQUIRE(gate_of(slight) != nullptr);
  CHECK_FALSE(gate_of(slight)->blocks);
  CHECK(slight.verdict == Verdict::pass);
  // Bending alone uses 0.8: more than a tenth of it distorts.
  const double I_y = (0.608 * std::pow(1.212, 3) - 0.592 * std::pow(1.188, 3)) / 12.0;
  const double force = 0.8 * 355e6 * I_y / 0.606 / 100.0;
  const Project full = beam(load, one_segment, -force);
  const std::vector<DistortionEstimate> estimates = estimates_of(full);
  REQUIRE(estimates.size() == 1);
  const auto gates_beside = [&](Criterion criterion, double use) {
    CheckResult result;
    result.check.criterion = criterion;
    result.check.safety_factor = 1.0 / use;
    return distortion_gates_of(full, estimates, {result});
  };
  // 0.31 of the strength by distortion: 34 + 77 MPa of 355.
  REQUIRE(gates_beside(Criterion::yield, 0.8).size() == 1);
  CHECK(gates_beside(Criterion::yield, 0.8).front().blocks);
  CHECK_FALSE(gates_beside(Criterion::yield, 0.6).front().blocks);
  // Plates that buckle have less than their yield strength for it.
  CHECK(gates_beside(Criterion::effective_section, 0.6).front().blocks);
  // But not what is next to nothing.
  std::vector<DistortionEstimate> less = estimates;
  for (const auto& [used, blocks] : {std::pair{0.009, false}, std::pair{0.011, true}}) {
    less.front().used = used;
    CheckResult result;
    result.check.criterion = Criterion::effective_section;
    result.check.safety_factor = 2.0;
    CHECK(distortion_gates_of(full, less, {result}).front().blocks == blocks);
  }
}

TEST_CASE("in fatigue only what changes distorts", "[distortion]") {
  const auto of = [](const std::string& b) {
    return estimate_of(beam(
        twist("eccentric", 50.0, 60e3) + diaphragm(0.0, "50 mm") +
        "[fatigue]\ncategory = 71\nloading = \"spectrum\"\ngamma_Ff = 1.0\n"
        "gamma_Mf = 1.0\nrequired = 1.0\n[[situations]]\nname = \"a\"\nloads = { tip = 1.0, "
        "eccentric = 1.0 }\n[[situations]]\nname = \"b\"\nloads = { " +
        b + " }\n[[situations]]\nname = \"change\"\nbetween = [\"a\", \"b\"]\ncycles = 1e5\n"));
  };
  const DistortionEstimate steady = of("tip = -1.0, eccentric = 1.0");
  CHECK(steady.across_range.value() == Approx(0.0).margin(1e-6 * steady.across.value()));
  CHECK(steady.bending_range.value() == Approx(2.0 * steady.bending.value()).epsilon(1e-9));
  const DistortionEstimate off = of("tip = 1.0, eccentric = 0.0");
  CHECK(off.across_range.value() == Approx(off.across.value()).epsilon(1e-9));
  CHECK(off.along_range.value() == Approx(off.along.value()).epsilon(1e-9));
  CHECK(off.bending_range.value() == Approx(0.0).margin(1e-9 * off.bending.value()));
  const DistortionEstimate turned = of("tip = 1.0, eccentric = -1.0");
  CHECK(turned.across_range.value() == Approx(2.0 * turned.across.value()).epsilon(1e-9));
}

TEST_CASE("a jump of the height distorts as a taper as short", "[distortion]") {
  // T runs through; diaphragms stand where it comes. d = T/2 ln(h_2/h_1) both ways.
  const auto of = [](const std::string& segments) {
    return estimate_of(beam(
        twist("end", 100.0, 60e3) + diaphragm(0.0, "1 m") + diaphragm(100.0, "1 m"), segments));
  };
  const DistortionEstimate jump =
      of("[[beam.segments]]\nname = \"1\"\nlength = \"50 m\"\nsection = \"a\"\n[[beam.segments]]\n"
         "name = \"2\"\nlength = \"50 m\"\nsection = \"b\"\n");
  const DistortionEstimate taper = of(
      "[[beam.segments]]\nname = \"1\"\nlength = \"49.95 m\"\nsection = \"a\"\n[[beam.segments]]\n"
      "name = \"2\"\nlength = \"0.1 m\"\nfrom = \"a\"\nto = \"b\"\n[[beam.segments]]\nname = "
      "\"3\"\nlength = \"49.95 m\"\nsection = \"b\"\n");
  CHECK(jump.across.value() > 1e6);
  CHECK(taper.across.value() == Approx(jump.across.value()).epsilon(0.05));
  CHECK(jump.segments == "1, 2");
  // A box that keeps its shape bears the same torque as Bredt's flow.
  const DistortionEstimate even = of(one_segment);
  CHECK(even.across.value() < 1e-2 * jump.across.value());
}

TEST_CASE("torque that passes from a tube to a box distorts the box", "[distortion]") {
  const std::string segments =
      "[[beam.segments]]\nname = \"tube\"\nlength = \"50 m\"\nsection = \"round\"\n"
      "[[beam.segments]]\nname = \"box\"\nlength = \"50 m\"\nsection = \"a\"\n";
  const DistortionEstimate of =
      estimate_of(beam(twist("end", 100.0, 60e3) + diaphragm(100.0, "50 mm"), segments));
  CHECK(of.segments == "box");
  CHECK(of.introduced.value() == Approx(50.0));
  CHECK(of.from.value() == Approx(50.0));
  // As at the wall of a box alone.
  const DistortionEstimate alone =
      estimate_of(beam(twist("end", 100.0, 60e3) + diaphragm(100.0, "50 mm")));
  CHECK(of.across.value() == Approx(alone.across.value()).epsilon(1e-3));
}

TEST_CASE("round tubes, boxes without torque, and boxes in the plane say nothing", "[distortion]") {
  CHECK(estimates_of(beam("")).empty());
  CHECK(estimates_of(beam(twist("end", 100.0, 60e3),
                          "[[beam.segments]]\nlength = \"100 m\"\nsection = \"round\"\n"))
            .empty());
  CHECK(gate_of(verify(beam(""))) == nullptr);
  const Project plane = parse_project(
      "box.toml",
      "[case]\nname = \"box\"\nkind = \"static\"\n[material]\nsteel = \"S355\"\n[strength]\n"
      "required = 1.0\n" +
          box("a", 1.2) +
          "[beam]\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"10 m\"\nsection = "
          "\"a\"\n[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n[loads.tip]\nkind = "
          "\"force\"\nat = \"10 m\"\nforce = [\"0 N\", \"-1 kN\"]\n");
  CHECK(estimates_of(plane).empty());
}

}  // namespace distortion_estimate_test
