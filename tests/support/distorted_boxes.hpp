#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/strength/box_distortion.hpp"
#include "boxbeam/verification/distortion_checks.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"

/// Long boxes that torques distort, as cases and by themselves.
namespace distorted_boxes {

using namespace boxbeam;

constexpr double E = 210e9, G = 81e9, nu = 0.5 * E / G - 1.0;

/// The mid-lines of the box of the case: 600 x 1200, flanges 12, webs 8.
inline BoxCell cell(double height = 1.2) {
  return {si<Length>(0.6),
          si<Length>(height),
          {si<Length>(0.012), si<Length>(0.012), si<Length>(0.008), si<Length>(0.008)}};
}

inline std::string box(const std::string& name, double height, int flange = 12, int web = 8) {
  return fmt::format(
      "[sections.{}]\nkind = \"box\"\nwidth = \"{} mm\"\nheight = \"{} mm\"\n"
      "flange = \"{} mm\"\nweb = \"{} mm\"\n",
      name, 600 + web, 1e3 * height + flange, flange, web);
}

inline std::string twist(const std::string& name, double at, double torque) {
  return fmt::format(
      "[loads.{}]\nkind = \"force\"\nat = \"{} m\"\nforce = [\"0 N\", \"0 N\", \"0 N\"]\n"
      "moment = [\"{} N m\", \"0 N m\", \"0 N m\"]\n",
      name, at, torque);
}

inline std::string diaphragm(double at, const std::string& thickness = "10 mm") {
  return fmt::format("[[beam.diaphragms]]\nstation = \"{} m\"\nthickness = \"{}\"\n", at,
                     thickness);
}

inline const std::string one_segment = "[[beam.segments]]\nlength = \"100 m\"\nsection = \"a\"\n";

/// A box of 100 m in space, clamped at its start and without weight, with a force at its end.
inline Project beam(const std::string& more, const std::string& segments = one_segment,
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

inline std::vector<DistortionEstimate> estimates_of(const Project& project) {
  const std::deque<SituationRun> runs = run_situations(project);
  return check_distortion(project, runs, bending_zones_of(project, runs), {}).estimates;
}

inline DistortionEstimate estimate_of(const Project& project) {
  const std::vector<DistortionEstimate> all = estimates_of(project);
  REQUIRE(all.size() == 1);
  return all.front();
}

inline const Gate* gate_of(const Verification& of) {
  for (const Gate& gate : of.gates)
    if (gate.finding.find("distortion") != std::string::npos) return &gate;
  return nullptr;
}

/// A beam of one cell with diaphragms, their places and thicknesses [m], solved by itself.
inline DistortionSolver solver_of(const std::vector<double>& places, const BoxCell& cell,
                                  const std::vector<std::pair<double, double>>& diaphragms) {
  DistortedBeam model = distorted_beam(
      places, [&](double) { return cell; }, E, nu);
  for (const auto& [s, t] : diaphragms)
    model.diaphragms[model.nearest(s)] = G * t * (cell.width * cell.height).value();
  return DistortionSolver(model);
}

/// A square cell that does not buckle: mid-lines 600 x 600, all plates 20 mm.
constexpr double side = 0.6, thick = 0.02;

inline BoxCell stout_cell() {
  const Length t = si<Length>(thick);
  return {si<Length>(side), si<Length>(side), {t, t, t, t}};
}

/// `more`: further keys of its section.
inline std::string stout_segment(const std::string& more = "") {
  return "[sections.square]\nkind = \"box\"\nwidth = \"620 mm\"\nheight = \"620 mm\"\n"
         "flange = \"20 mm\"\nweb = \"20 mm\"\n" +
         more + "[[beam.segments]]\nlength = \"100 m\"\nsection = \"square\"\n";
}

inline Project stout_beam(const std::string& more, double tip = -1e3,
                          const std::string& segment = stout_segment()) {
  return beam(more, segment, tip);
}

/// Of the stout box by hand, without shear: couple P/b on the webs, far from both ends.
struct ByHand {
  double along = 0.0, across = 0.0, moment = 0.0;
};

inline ByHand by_hand(double torque) {
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

inline const CheckResult& result_of(const Verification& of, Criterion criterion,
                                    bool across = false) {
  for (const CheckResult& result : of.checks) {
    if (result.check.criterion == criterion && result.distortion->across == across) return result;
  }
  FAIL("no check of " << to_text(criterion));
  return of.checks.front();
}

}  // namespace distorted_boxes
