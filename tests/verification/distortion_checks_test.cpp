// Distortion of the boxes of a case in strength: hand values, an exhaustive search of the ways in
// which torques may come, seams, and remedies.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "catch.hpp"
#include "support/distorted_boxes.hpp"

namespace distortion_checks_test {

using namespace boxbeam;
using namespace distorted_boxes;

namespace {

double yield_at(const Verification& of, double s) {
  double most = 0.0;
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion == Criterion::yield &&
        std::abs(result.check.station.s.value() - s) < 1e-6)
      most = std::max(most, result.check.utilisation());
  }
  return most;
}

}  // namespace

TEST_CASE("a corner is used by bending, what stretches its edges and what bends it across",
          "[distortion]") {
  const double torque = 300e3, tip = -10e3;
  const Verification of =
      verify(stout_beam(twist("eccentric", 50.0, torque) + diaphragm(0.0, "50 mm") +
                            "[[beam.load_introductions]]\nstation = \"50 m\"\nstiff_length = "
                            "\"300 mm\"\n",
                        tip));
  CHECK(of.verdict == Verdict::pass);
  REQUIRE(gate_of(of) != nullptr);
  CHECK_FALSE(gate_of(of)->blocks);
  const CheckResult& result = result_of(of, Criterion::distortion);
  const Check& check = result.check;
  CHECK(check.station.s.value() == Approx(50.0));
  CHECK(std::abs(result.distortion->stress.point.y.value()) >= 0.29);
  CHECK(std::abs(result.distortion->stress.point.z.value()) >= 0.29);
  const ByHand hand = by_hand(torque);
  const double bending = -tip * 50.0 * 0.31 / I_stout;
  const double x = bending + hand.along, t = hand.across;
  const double shear = torque / (2.0 * side * side * thick);
  // Shear of distortion, left out by hand, changes 3 % here.
  CHECK(check.acting.value() ==
        Approx(std::sqrt(x * x + t * t + x * t + 3.0 * shear * shear)).epsilon(0.03));
  CHECK(check.resisting.value() == Approx(345e6));
  CHECK(result.distortion->torque.value() == Approx(torque));
  CHECK(check.utilisation() > yield_at(of, 50.0));
}

TEST_CASE("no way in which torques come uses a box more than the check says", "[distortion]") {
  // Every sign of every torque, in every situation, at every place, at all four corners.
  const std::vector<double> at{48.0, 51.0, 53.5};
  const std::vector<std::vector<double>> torques{{600e3, -250e3, 800e3}, {-300e3, 500e3, 100e3}};
  std::string text = diaphragm(0.0, "50 mm") + diaphragm(50.0, "1 mm");
  for (std::size_t k = 0; k < at.size(); ++k) text += twist("t" + std::to_string(k), at[k], 1e3);
  for (std::size_t i = 0; i < torques.size(); ++i) {
    text += fmt::format("[[situations]]\nname = \"{}\"\nload_factor = {}\nloads = {{ tip = {}", i,
                        1.0 + 0.1 * static_cast<double>(i), i == 0 ? 1.0 : -2.0);
    for (std::size_t k = 0; k < at.size(); ++k)
      text += fmt::format(", t{} = {}", k, torques[i][k] / 1e3);
    text += " }\n";
  }
  const double tip = -10e3;
  const Verification of = verify(stout_beam(text, tip));
  const Check& check = result_of(of, Criterion::distortion).check;

  const DistortionSolver solver =
      solver_of({0.0, 48.0, 50.0, 51.0, 53.5, 100.0}, stout_cell(), {{0.0, 0.05}, {50.0, 0.001}});
  const DistortedBeam& model = solver.beam();
  const CellDistortion stiffness = cell_distortion_of(stout_cell(), E, nu);
  double most = 0.0;
  for (std::size_t run = 0; run < torques.size(); ++run) {
    double all = 0.0;
    for (const double torque : torques[run]) all += torque;
    for (int ways = 0; ways < 16; ++ways) {
      std::vector<double> loads(model.nodes.size(), 0.0);
      for (std::size_t k = 0; k < at.size(); ++k)
        loads[model.nearest(at[k])] = ((ways >> k) & 1 ? 0.5 : -0.5) * torques[run][k];
      loads.front() = (ways & 8 ? 0.5 : -0.5) * all;
      const Distortion found = solver.solve(loads);
      for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const double M = tip * (run == 0 ? 1.0 : -2.0) * (100.0 - model.nodes[i]);
        for (const CellCorner corner : {CellCorner::top_left, CellCorner::bottom_left,
                                        CellCorner::bottom_right, CellCorner::top_right}) {
          const bool top = corner == CellCorner::top_left || corner == CellCorner::top_right;
          const double x =
              (top ? 1.0 : -1.0) * M * 0.31 / I_stout + found.warping_stress(i, stiffness, corner);
          const double t = found.frame_stress(i, stiffness, stout_cell(), corner);
          const double v = std::sqrt(x * x + t * t + std::abs(x) * t);
          most = std::max(most, (1.0 + 0.1 * static_cast<double>(run)) * v);
        }
      }
    }
  }
  // Shear, of torsion and of distortion, is left out here.
  CHECK(check.acting.value() >= most * (1.0 - 1e-6));
  CHECK(check.acting.value() <= most * 1.05);
}

TEST_CASE("a seam that is thinner than its plates is bent across in its throat", "[distortion]") {
  const double torque = 200e3, a = 0.006;
  const std::string segment = stout_segment("seam_throat = \"6 mm\"\n");
  const Verification of =
      verify(stout_beam(twist("eccentric", 50.0, torque) + diaphragm(0.0, "50 mm"), -1e3, segment));
  const CheckResult& result = result_of(of, Criterion::distortion);
  CHECK(result.check.point.find("throat") != std::string::npos);
  CHECK(result.distortion->in_throat);
  const double m = by_hand(torque).moment, tau = torque / (2.0 * side * side) / a;
  const double t = 6.0 * m / (a * a);
  // f_u = 470 MPa, beta_w = 0.9; across alone 0.9 f_u. The torque by half from both sides; shear
  // of distortion is as large.
  const double combined = std::hypot(t, std::sqrt(3.0) * tau) / (470e6 / (0.9 * 1.25));
  const double use = std::max(combined, t / (0.9 * 470e6 / 1.25));
  CHECK(result.check.utilisation() == Approx(use).epsilon(0.05));
}

TEST_CASE("a load factor is the loads times it, whichever limit of a seam decides",
          "[distortion]") {
  // Bent across alone 0.9 f_u decides (EN 1993-1-8, 4.5.3.2(6)), by 1/(0.81) of the other limit.
  const std::string segment = stout_segment("seam_throat = \"6 mm\"\n");
  const auto use = [&](double torque, double factor) {
    const std::string more =
        twist("eccentric", 50.0, torque) + diaphragm(0.0, "50 mm") +
        fmt::format(
            "[[situations]]\nname = \"s\"\nload_factor = {}\nloads = {{ tip = 1.0, "
            "eccentric = 1.0 }}\n",
            factor);
    return result_of(verify(stout_beam(more, -1.0, segment)), Criterion::distortion)
        .check.utilisation();
  };
  for (const double factor : {0.7, 1.3, 1.5, 2.0}) {
    CAPTURE(factor);
    CHECK(use(60e3, factor) == Approx(use(60e3 * factor, 1.0)).epsilon(1e-6));
  }
  const double m = by_hand(90e3).moment;
  CHECK(use(60e3, 1.5) == Approx(6.0 * m / (0.006 * 0.006) / (0.9 * 470e6 / 1.25)).epsilon(0.05));
}

TEST_CASE("distortion grows with torque and shrinks with what keeps a box in shape",
          "[distortion]") {
  const auto acting = [&](double torque, const std::string& more) {
    const Verification of = verify(stout_beam(twist("eccentric", 50.0, torque) + more, -1.0));
    for (const CheckResult& result : of.checks)
      if (result.check.criterion == Criterion::distortion) return result.check.acting.value();
    return 0.0;
  };
  const std::string wall = diaphragm(0.0, "50 mm");
  // Next to nothing bends.
  CHECK(acting(400e3, wall) == Approx(2.0 * acting(200e3, wall)).epsilon(1e-3));
  double last = acting(400e3, wall);
  for (const char* thickness : {"0.01 mm", "0.1 mm", "1 mm"}) {
    const double stiffer = acting(400e3, wall + diaphragm(50.0, thickness));
    CHECK(stiffer < last);
    last = stiffer;
  }
}

TEST_CASE("what a distorted box lacks is said", "[distortion]") {
  const std::string load = twist("eccentric", 50.0, 1e6) + diaphragm(0.0, "50 mm");
  const Project project = stout_beam(load, -1e3);
  const Verification of = verify(project, Figures::without, Advice::with);
  CHECK(of.verdict == Verdict::fail);
  CHECK(of.checks.front().check.criterion == Criterion::distortion);
  REQUIRE_FALSE(of.remedies.found.empty());
  const Remedy& remedy = of.remedies.found.front();
  CHECK(remedy.what == Remedy::What::diaphragms);
  CHECK(remedy.utilisation <= 1.0);
  std::string many;
  for (double s = remedy.value; s < 100.0 + 1e-6; s += remedy.value)
    if (std::abs(s - 50.0) > 1e-6) many += diaphragm(s, "50 mm");
  const Verification better = verify(stout_beam(load + many + diaphragm(50.0, "50 mm"), -1e3));
  CHECK(better.verdict == Verdict::pass);
  CHECK(better.checks.front().check.utilisation() == Approx(remedy.utilisation).epsilon(1e-3));
}

}  // namespace distortion_checks_test
