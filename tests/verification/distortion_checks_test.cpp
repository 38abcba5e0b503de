// Distortion of the boxes of a case: hand values, exhaustive searches of the ways in which torques
// may come, in strength and in fatigue, and where it stops a verdict.

#include "boxbeam/verification/distortion_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/fatigue/rainflow.hpp"
#include "boxbeam/strength/box_distortion.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"

namespace distortion_checks_test {

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
  const std::deque<SituationRun> runs = run_situations(project);
  return check_distortion(project, runs, bending_zones_of(project, runs), {}).estimates;
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

namespace {

/// A square cell that does not buckle: mid-lines 600 x 600, all plates 20 mm.
constexpr double side = 0.6, thick = 0.02;

BoxCell stout_cell() {
  const Length t = si<Length>(thick);
  return {si<Length>(side), si<Length>(side), {t, t, t, t}};
}

const std::string stout_segment =
    "[sections.square]\nkind = \"box\"\nwidth = \"620 mm\"\nheight = \"620 mm\"\n"
    "flange = \"20 mm\"\nweb = \"20 mm\"\n"
    "[[beam.segments]]\nlength = \"100 m\"\nsection = \"square\"\n";

Project stout_beam(const std::string& more, double tip = -1e3,
                   const std::string& segment = stout_segment) {
  return beam(more, segment, tip);
}

/// Of the stout box by hand, without shear: couple P/b on the webs, far from both ends.
struct ByHand {
  double along = 0.0, across = 0.0, moment = 0.0;
};

ByHand by_hand(double torque) {
  const double P = torque / side;
  const double D = E * thick * thick * thick / (12.0 * (1.0 - nu * nu));
  const double per_corner = 1.0 / (2.0 * side / D);
  const double k = 192.0 / (side * side) * per_corner;
  const double I_D = side * side * 2.0 * side * thick / 12.0;
  const double lambda = std::pow(k / (4.0 * E * I_D), 0.25);
  ByHand of;
  of.along = P / (4.0 * lambda) * side / (2.0 * I_D);
  of.moment = 6.0 * (4.0 * P * lambda / (2.0 * k) / side) * per_corner;
  of.across = 6.0 * of.moment / (thick * thick);
  return of;
}

constexpr double I_stout = (0.62 * 0.62 * 0.62 * 0.62 - 0.58 * 0.58 * 0.58 * 0.58) / 12.0;

const CheckResult& result_of(const Verification& of, Criterion criterion, bool across = false) {
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion == criterion && result.distortion->across == across) return result;
  }
  FAIL("no check of " << to_text(criterion));
  return of.checks.front();
}

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

  DistortedBeam model = distorted_beam(
      {0.0, 48.0, 50.0, 51.0, 53.5, 100.0}, [](double) { return stout_cell(); }, E, nu);
  for (const auto& [s, t] : {std::pair{0.0, 0.05}, std::pair{50.0, 0.001}})
    model.diaphragms[model.nearest(s)] = G * t * side * side;
  const DistortionSolver solver(model);
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
  const std::string segment =
      "[sections.square]\nkind = \"box\"\nwidth = \"620 mm\"\nheight = "
      "\"620 mm\"\nflange = \"20 mm\"\nweb = \"20 mm\"\nseam_throat = "
      "\"6 mm\"\n[[beam.segments]]\nlength = \"100 m\"\nsection = "
      "\"square\"\n";
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
  const std::string segment =
      "[sections.square]\nkind = \"box\"\nwidth = \"620 mm\"\nheight = \"620 mm\"\n"
      "flange = \"20 mm\"\nweb = \"20 mm\"\nseam_throat = \"6 mm\"\n"
      "[[beam.segments]]\nlength = \"100 m\"\nsection = \"square\"\n";
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

namespace {

/// Situations "0", "1", .. with factors of the loads "tip" and "eccentric".
std::string in_situations(const std::vector<std::pair<double, double>>& factors) {
  std::string text;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    text += fmt::format("[[situations]]\nname = \"{}\"\nloads = {{ tip = {}, eccentric = {} }}\n",
                        i, factors[i].first, factors[i].second);
  }
  return text;
}

const std::string by_category_100 =
    "[fatigue]\ncategory = 100\nloading = \"spectrum\"\ngamma_Ff = 1.0\ngamma_Mf = "
    "1.0\nrequired = 1.0\n";

}  // namespace

TEST_CASE("ranges of distortion join those of their point, and bend corners across",
          "[distortion]") {
  const double torque = 400e3, tip = -2e3;
  const std::string load = twist("eccentric", 50.0, torque) + diaphragm(0.0, "50 mm");
  const Verification of = verify(
      stout_beam(load + by_category_100 + in_situations({{1.0, 1.0}, {0.0, 0.0}}) +
                     "[[situations]]\nname = \"change\"\nbetween = [\"0\", \"1\"]\ncycles = 1e5\n",
                 tip));
  const CheckResult& joined = result_of(of, Criterion::distortion_fatigue);
  const DistortionEstimate estimate = estimate_of(stout_beam(load, tip));
  REQUIRE(joined.distortion->stress.spectrum.size() >= 1);
  CHECK(joined.check.station.s.value() == Approx(50.0));
  const double bending = -tip * 50.0 * 0.31 / I_stout;
  double largest = 0.0;
  for (const SpectrumRow& row : joined.distortion->stress.spectrum)
    if (row.kind == StressKind::direct) largest = std::max(largest, row.cycle.range.value());
  // The end of a web lies 10 mm inside the corner.
  CHECK(largest == Approx(bending + estimate.along.value()).epsilon(0.05));
  // 36 at 1e5 cycles: 36 (2e6/1e5)^(1/3).
  const CheckResult& across = result_of(of, Criterion::distortion_fatigue, true);
  CHECK(across.check.safety_factor ==
        Approx(36e6 * std::cbrt(20.0) / estimate.across.value()).epsilon(1e-6));
  const Verification better = verify(
      stout_beam(load + by_category_100 + "corner = { category = 71 }\n" +
                     in_situations({{1.0, 1.0}, {0.0, 0.0}}) +
                     "[[situations]]\nname = \"change\"\nbetween = [\"0\", \"1\"]\ncycles = 1e5\n",
                 tip));
  CHECK(result_of(better, Criterion::distortion_fatigue, true).check.safety_factor ==
        Approx(71.0 / 36.0 * across.check.safety_factor));
  // A torque that stays does no damage.
  const Verification steady = verify(
      stout_beam(load + by_category_100 + in_situations({{1.0, 1.0}, {0.0, 1.0}}) +
                     "[[situations]]\nname = \"change\"\nbetween = [\"0\", \"1\"]\ncycles = 1e5\n",
                 tip));
  CHECK(steady.governing(Criterion::distortion_fatigue) == nullptr);
  CHECK(steady.governing(Criterion::distortion) != nullptr);
}

TEST_CASE("where distortion does nothing the plain check stands, with its own remedies",
          "[distortion]") {
  // At the wall, whose end warps freely, M_D is zero and bending largest; a plate takes the torque
  // in the middle.
  const std::string load =
      twist("eccentric", 50.0, 400e3) + diaphragm(0.0, "50 mm") + diaphragm(50.0, "50 mm");
  const auto with_cycles = [&](double cycles) {
    return verify(stout_beam(load + by_category_100 + "diaphragms = { category = 160 }\n" +
                                 in_situations({{1.0, 1.0}, {0.0, 0.0}}) +
                                 fmt::format("[[situations]]\nname = \"change\"\nbetween = "
                                             "[\"0\", \"1\"]\ncycles = {}\n",
                                             cycles),
                             -20e3),
                  Figures::without, Advice::with);
  };
  const Verification of = with_cycles(2.5e5);
  REQUIRE(of.verdict == Verdict::fail);
  const CheckResult& worst = of.checks.front();
  CHECK_FALSE(worst.distortion);
  CHECK(worst.check.station.s.value() == 0.0);
  for (const CheckResult& result : of.checks) {
    if (result.distortion) CHECK(result.check.utilisation() < worst.check.utilisation());
  }
  CHECK(std::any_of(of.remedies.found.begin(), of.remedies.found.end(),
                    [](const Remedy& remedy) { return remedy.what == Remedy::What::category; }));
}

TEST_CASE("no order of loads does more damage than the check of distortion says", "[distortion]") {
  // Two torques at the same places in every situation, one after the other: their signs, by
  // exhaustion, and the cycles of the sum counted.
  const std::vector<std::array<double, 3>> factors{
      {1.0, 1.0, 0.2}, {-0.5, -0.4, 1.0}, {0.3, 0.9, -0.6}, {-1.0, 0.1, 0.5}, {0.8, -1.0, 0.0}};
  const double tip = -2e3, torque = 400e3;
  std::string text = twist("a", 48.0, torque) + twist("b", 51.0, torque) + diaphragm(0.0, "50 mm") +
                     by_category_100;
  std::string names;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    text += fmt::format("[[situations]]\nname = \"{}\"\nloads = {{ tip = {}, a = {}, b = {} }}\n",
                        i, factors[i][0], factors[i][1], factors[i][2]);
    names += fmt::format("{}\"{}\"", i > 0 ? ", " : "", i);
  }
  text += fmt::format("[[situations]]\nname = \"all\"\nsequence = [{}]\ncycles = 1e5\n", names);
  const Project project = stout_beam(text, tip);
  const Verification of = verify(project);
  const CheckResult& result = result_of(of, Criterion::distortion_fatigue);

  DistortedBeam model = distorted_beam(
      {0.0, 48.0, 51.0, 100.0}, [](double) { return stout_cell(); }, E, nu);
  model.diaphragms.front() = G * 0.05 * side * side;
  const DistortionSolver solver(model);
  const CellDistortion stiffness = cell_distortion_of(stout_cell(), E, nu);
  const SnCurve curve = en_1993_1_9_direct(100.0);
  double most = 0.0;
  for (int ways = 0; ways < 4; ++ways) {
    std::vector<Distortion> found;
    for (const auto& at : factors) {
      std::vector<double> loads(model.nodes.size(), 0.0);
      loads[model.nearest(48.0)] = (ways & 1 ? 0.5 : -0.5) * at[1] * torque;
      loads[model.nearest(51.0)] = (ways & 2 ? 0.5 : -0.5) * at[2] * torque;
      found.push_back(solver.solve(loads));
    }
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      std::vector<Stress> history;
      for (std::size_t k = 0; k < factors.size(); ++k) {
        history.push_back(
            si<Stress>(tip * factors[k][0] * (100.0 - model.nodes[i]) * 0.3 / I_stout +
                       found[k].warping_stress(i, stiffness, CellCorner::top_left)));
      }
      std::vector<Cycle> cycles = count_periodic_cycles(history);
      for (Cycle& cycle : cycles) cycle.count *= 1e5;
      most = std::max(most, 1.0 / largest_factor(cycles, curve, project.fatigue.demand));
    }
  }
  CHECK(1.0 / result.check.safety_factor >= most);
  CHECK(1.0 / result.check.safety_factor <= 2.0 * most);
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

}  // namespace distortion_checks_test
