// How far torques distort the boxes of a case: hand values, an exhaustive search of the ways in
// which they may come, what passes it on, and where it stops a verdict.

#include "boxbeam/verification/distortion_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <string>
#include <vector>

#include "catch.hpp"
#include "support/distorted_boxes.hpp"

namespace distortion_estimates_test {

using namespace boxbeam;
using namespace distorted_boxes;

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
  CHECK(of.bending.value() == Approx(1e5 * 0.606 / I_y).epsilon(1e-6));
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

  const DistortionSolver solver =
      solver_of({0.0, 48.0, 50.0, 51.0, 53.5, 100.0}, cell(), {{0.0, 0.05}, {50.0, 0.001}});
  const DistortedBeam& model = solver.beam();
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

TEST_CASE("a case may say by which plates torque comes", "[distortion]") {
  const auto by = [](double s, const std::string& word) {
    return fmt::format(
        "[[beam.load_introductions]]\nstation = \"{} m\"\ninto = \"webs\"\ntorque_by = \"{}\"\n", s,
        word);
  };
  const std::string wall = diaphragm(0.0, "50 mm");
  const std::string two = twist("a", 50.0, 400e3) + twist("b", 52.0, -400e3) + wall;
  const auto across = [&](const std::string& more) {
    return estimates_of(stout_beam(two + more)).front().across.value();
  };
  CHECK(estimates_of(stout_beam(two + by(50.0, "flow") + by(52.0, "flow"))).empty());
  const double unknown = across("");
  // By the same plates they act against each other, by unlike ones as where nothing is said.
  CHECK(across(by(50.0, "webs") + by(52.0, "webs")) < 0.9 * unknown);
  CHECK(across(by(50.0, "flanges") + by(52.0, "flanges")) ==
        Approx(across(by(50.0, "webs") + by(52.0, "webs"))));
  CHECK(across(by(50.0, "webs") + by(52.0, "flanges")) == Approx(unknown));
  // One alone does not ask by which.
  const std::string one = twist("a", 50.0, 400e3) + wall;
  CHECK(estimates_of(stout_beam(one + by(50.0, "webs"))).front().across.value() ==
        Approx(estimates_of(stout_beam(one)).front().across.value()));
}

TEST_CASE("flow is of couples alone: forces beside the axis come by their own plates",
          "[distortion]") {
  // The same torque, F y, distorts as by the webs, however it is said to come.
  const auto force = [](double y, double z, double F_y, double F_z) {
    return fmt::format(
        "[loads.beside]\nkind = \"force\"\nat = [\"50 m\", \"{} m\", \"{} m\"]\n"
        "force = [\"0 N\", \"{} N\", \"{} N\"]\n",
        y, z, F_y, F_z);
  };
  const auto by = [](const std::string& word) {
    return "[[beam.load_introductions]]\nstation = \"50 m\"\ninto = \"webs\"\ntorque_by = \"" +
           word + "\"\n" + diaphragm(0.0, "50 mm");
  };
  const auto across = [&](const std::string& more) {
    return estimate_of(stout_beam(more)).across.value();
  };
  const double by_webs = across(twist("couple", 50.0, 200e3) + by("webs"));
  CHECK(across(force(0.25, 0.0, 0.0, -800e3) + by("webs")) == Approx(by_webs).epsilon(1e-6));
  CHECK(across(force(0.25, 0.0, 0.0, -800e3) + by("flow")) == Approx(by_webs).epsilon(1e-6));
  // Turned by 90 degrees, by the flanges.
  CHECK(across(force(0.0, 0.25, 800e3, 0.0) + by("flow")) == Approx(by_webs).epsilon(1e-6));
  // With the couple that takes the torque off again, which flows in, it distorts all the same.
  const Project none =
      stout_beam(force(0.25, 0.0, 0.0, -800e3) + twist("couple", 50.0, 200e3) + by("flow"));
  CHECK(estimate_of(none).across.value() == Approx(by_webs).epsilon(1e-6));
  // A couple flows where a diaphragm spreads it; else the verdict line says that none does.
  const auto words = [&](const std::string& more) {
    const Project project = stout_beam(twist("couple", 50.0, 200e3) + by("flow") + more);
    const std::deque<SituationRun> runs = run_situations(project);
    return check_distortion(project, runs, bending_zones_of(project, runs), {}).not_judged.size();
  };
  CHECK(words("") == 1);
  CHECK(words(diaphragm(50.0, "50 mm")) == 0);
}

TEST_CASE("diaphragms every 0.5/lambda leave a third of what stretches edges", "[distortion]") {
  // Rigid, with the torque between two: a beam over many supports without foundation, M = 0.171 P L
  // (three equal spans in the middle of many; EI alone), of P/(4 lambda): 0.34 at L = 0.5/lambda.
  const double torque = 400e3;
  const DistortionEstimate open =
      estimate_of(stout_beam(twist("eccentric", 50.0, torque) + diaphragm(0.0, "50 mm")));
  std::string many;
  const double apart = open.spacing.value();
  for (double s = 50.0 - 7.5 * apart; s < 50.0 + 8.0 * apart; s += apart)
    many += diaphragm(s, "500 mm");
  const DistortionEstimate held =
      estimate_of(stout_beam(twist("eccentric", 50.0, torque) + diaphragm(0.0, "50 mm") + many));
  CHECK(held.along.value() == Approx(0.34 * open.along.value()).epsilon(0.15));
  CHECK(held.across.value() < 0.1 * open.across.value());
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

TEST_CASE("a box that an eccentric load distorts gets no verdict without diaphragms",
          "[distortion]") {
  // 23 MPa along, 50 MPa across in the middle and four times that at the wall.
  const std::string load = twist("eccentric", 50.0, 40e3);
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

TEST_CASE("what stands beside the checks of distortion stops a verdict", "[distortion]") {
  const Project full =
      beam(twist("eccentric", 50.0, 60e3) + diaphragm(0.0, "50 mm"), one_segment, -20e3);
  const std::vector<DistortionEstimate> estimates = estimates_of(full);
  REQUIRE(estimates.size() == 1);
  // The webs of this box may buckle everywhere.
  CHECK(estimates.front().used_where_slender == estimates.front().used);
  const auto blocks_beside = [&](const DistortionEstimate& of, Criterion criterion, double use) {
    CheckResult result;
    result.check.criterion = criterion;
    result.check.safety_factor = 1.0 / use;
    result.check.station = {si<Length>(50.0)};
    const std::vector<Gate> gates = distortion_gates_of(full, {of}, {result});
    return !gates.empty() && gates.front().blocks;
  };
  DistortionEstimate of = estimates.front();
  CHECK(blocks_beside(of, Criterion::yield, 0.1));
  // But not up to a tenth of the strength, which is added to the checks of plates.
  of.used_where_slender = 0.101;
  CHECK(blocks_beside(of, Criterion::yield, 0.1));
  of.used_where_slender = 0.099;
  CHECK_FALSE(blocks_beside(of, Criterion::yield, 0.1));
  for (const Criterion criterion : {Criterion::effective_section, Criterion::shear_buckling,
                                    Criterion::interaction, Criterion::reduced_stress}) {
    CHECK(blocks_beside(of, criterion, 0.902));
    CHECK_FALSE(blocks_beside(of, criterion, 0.9));
  }
  // 0.31 of the strength by distortion: 34 + 77 MPa of 355, beside forces in webs and buckling.
  of.used_where_slender = 0.0;
  for (const Criterion criterion : {Criterion::patch_loading, Criterion::member}) {
    CHECK(blocks_beside(of, criterion, 0.8));
    CHECK_FALSE(blocks_beside(of, criterion, 0.6));
  }
  CHECK_FALSE(blocks_beside(of, Criterion::pin, 0.9));
}

}  // namespace distortion_estimates_test
