#include "hole_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "boxbeam/report/format.hpp"

namespace boxbeam::report {
namespace {

/// What the formulas of a hole's edge speak of.
struct EdgePlace {
  const StressPoint* point;
  const EdgeConcentration* edge;
  Hole hole;
  SectionProperties gross, net;
  double lag = 1.0;  ///< I_y,net/I_y,eff, by which shear lag raises the stress of bending

  std::string K_g() const { return text::significant(edge->factor); }
  std::string angle() const {
    return fmt::format("{:.10g} deg", edge->angle * 180.0 / std::numbers::pi);
  }
};

EdgePlace place_of(const Project& project, const StressPoint& point) {
  EdgePlace place{&point, &*point.concentration, {}, {}, {}};
  const std::vector<Hole> holes = holes_at(project.beam, point.station.s);
  place.hole = *std::find_if(holes.begin(), holes.end(), [&](const Hole& hole) {
    return hole.name == point.concentration->hole;
  });
  place.gross = point.gross;
  place.net = properties_of(point.section, holes);
  place.lag = place.net.I_y / point.net.I_y;
  return place;
}

bool near(double a, double b) {
  constexpr double round_off = 1e-9;
  return std::abs(a - b) <= round_off * std::max(std::abs(a), std::abs(b));
}

/// A coefficient with the formula that it follows from.
Step coefficient(const char* symbol, const std::string& formula, const std::string& values,
                 double value, bool of_moment) {
  const std::string text =
      of_moment ? scientific(value * 1e-9, 4) + " mm^-3" : scientific(value * 1e-6, 4) + " mm^-2";
  return {symbol, {formula, values, text}, {}};
}

/// d/w and the factors on the membrane part.
Steps membrane_steps(const EdgePlace& place) {
  const std::string a = text::significant(place.edge->diameter_to_width);
  const double K_t = place.edge->factor * (1.0 - place.edge->diameter_to_width);
  const std::string d = text::mm(place.hole.diameter.value());
  const std::string w = text::mm(place.hole.diameter.value() / place.edge->diameter_to_width);
  return {{"a", {"d/w", fmt::format("{}/{}", d, w), a}, {"hole diameter over width of its plate"}},
          {"K_t",
           {"2 + 0.284 (1 - a) - 0.600 (1 - a)^2 + 1.32 (1 - a)^3",
            fmt::format("2 + 0.284 x (1 - {0}) - 0.600 x (1 - {0})^2 + 1.32 x (1 - {0})^3", a),
            text::significant(K_t)},
           {"Peterson, chart 4.1, on the net section"}},
          {"K_g",
           {"K_t/(1 - a)", fmt::format("{}/(1 - {})", text::significant(K_t), a), place.K_g()},
           {"on the gross section"}}};
}

/// Kirsch's stresses around a hole in a web, per cut force.
struct AroundWebHole {
  double around = 0.0;  ///< K_g (1 - 2 cos 2theta)/3
  double across = 0.0;  ///< sin theta - sin 3theta
  double r = 0.0, z_0 = 0.0;
};

AroundWebHole around_of(const EdgePlace& place) {
  const double theta = place.edge->angle;
  return {place.edge->factor / 3.0 * (1.0 - 2.0 * std::cos(2.0 * theta)),
          std::sin(theta) - std::sin(3.0 * theta), 0.5 * place.hole.diameter.value(),
          place.hole.position.value()};
}

/// The formula of the moment's coefficient, without what is zero at mid-height.
Step web_moment_step(const EdgePlace& place, const AroundWebHole& hole, const char* symbol) {
  const std::string angle = place.angle();
  std::string formula = "r (sin theta - sin 3theta)/I_y,net";
  std::string values = fmt::format("{} x (sin({}) - sin(3 x {}))/{}", text::mm(hole.r), angle,
                                   angle, mm4(place.net.I_y.value()));
  if (hole.z_0 != 0.0) {
    formula = "K_g (1 - 2 cos 2theta) z_0/(3 I_y) + " + formula;
    values = fmt::format("{} x (1 - 2 x cos(2 x {})) x {}/(3 x {}) + {}", place.K_g(), angle,
                         term(text::mm(hole.z_0)), mm4(place.gross.I_y.value()), values);
  }
  if (place.lag != 1.0) {
    formula = "k_lag (" + formula + ")";
    values = fmt::format("{} x ({})", text::significant(place.lag), values);
  }
  return coefficient(symbol, formula, values, place.point->influence.normal[cut_force::M_y], true);
}

/// The shear of the gross section at the hole's centre, per V.
Steps web_shear_steps(const EdgePlace& place) {
  const double value = place.point->influence.normal[cut_force::V_z];
  const double sine = std::sin(2.0 * place.edge->angle);
  constexpr double nothing = 1e-9;
  if (value == 0.0 || std::abs(sine) < nothing) return {};
  const double a = place.edge->diameter_to_width;
  const std::string c_0 = scientific(-value * (1.0 - a) / (4.0 * sine) * 1e-6, 4) + " mm^-2";
  return {{"c_0", {c_0}, {"shear stress of the gross section per V at the hole's centre"}},
          coefficient("k_V", "-4 c_0 sin 2theta/(1 - a)",
                      fmt::format("-4 x {} x sin(2 x {})/(1 - {})", term(c_0), place.angle(),
                                  text::significant(a)),
                      value, false)};
}

/// A hole in a wall; formulas of the coefficients where the section's centroid lies on the axis.
Steps wall_hole_steps(const EdgePlace& place, bool space) {
  Steps steps = membrane_steps(place);
  const auto& influence = place.point->influence.normal;
  const AroundWebHole hole = around_of(place);
  const double A = place.gross.area.value(), I_y = place.gross.I_y.value();
  const double I_net = place.net.I_y.value();
  steps.push_back({"theta", {place.angle()}, {"place on the edge, from the axis of the beam"}});
  steps.push_back(
      {"sigma_edge",
       {"K_g sigma_0 (1 - 2 cos 2theta)/3 + r d/du(sigma) (sin theta - sin 3theta) - 4 "
        "tau_0 sin 2theta/(1 - a)"},
       {"by the stresses of the gross section at the hole's centre and the slope of the "
        "direct stress across it, that of moments on the net section; Kirsch"}});
  if (place.lag != 1.0) {
    steps.push_back(
        {"k_lag",
         {"I_y,net/I_y,eff", fmt::format("{}/{}", mm4(I_net), mm4(place.point->net.I_y.value())),
          text::significant(place.lag)},
         {"shear lag raises all stress of bending alike"}});
  }
  if (near(influence[cut_force::N], hole.around / A)) {
    steps.push_back({"A", {mm2(A)}, {"gross section"}});
    steps.push_back(coefficient(
        "k_N", "K_g (1 - 2 cos 2theta)/(3 A)",
        fmt::format("{} x (1 - 2 x cos(2 x {}))/(3 x {})", place.K_g(), place.angle(), mm2(A)),
        influence[cut_force::N], false));
  }
  const double k_M = place.lag * (hole.around * hole.z_0 / I_y + hole.r * hole.across / I_net);
  if (near(influence[cut_force::M_y], k_M)) {
    steps.push_back({"r", {text::mm(hole.r)}, {"radius of the hole"}});
    if (hole.z_0 != 0.0) {
      steps.push_back({"z_0", {text::mm(hole.z_0)}, {"level of its centre"}});
      steps.push_back({"I_y", {mm4(I_y)}, {"gross section"}});
    }
    steps.push_back({"I_y,net", {mm4(I_net)}, {}});
    steps.push_back(web_moment_step(place, hole, space ? "k_My" : "k_M"));
  }
  if (!space) append(steps, web_shear_steps(place));
  return steps;
}

Steps flange_hole_steps(const EdgePlace& place) {
  Steps steps = membrane_steps(place);
  const auto& influence = place.point->influence.normal;
  const double z = place.point->z.value();
  const double A = place.gross.area.value(), I_y = place.gross.I_y.value();
  const std::string ratio = place.lag == 1.0 ? "" : text::significant(place.lag) + " x ";
  if (near(influence[cut_force::N], place.edge->factor / A)) {
    steps.push_back(coefficient("k_N", "K_g/A", fmt::format("{}/{}", place.K_g(), mm2(A)),
                                influence[cut_force::N], false));
  }
  if (near(influence[cut_force::M_y], place.lag * place.edge->factor * z / I_y)) {
    steps.push_back(
        coefficient("k_M", ratio.empty() ? "K_g z/I_y" : "(I_y,net/I_y,eff) K_g z/I_y",
                    fmt::format("{}{} x {}/{}", ratio, place.K_g(), term(text::mm(z)), mm4(I_y)),
                    influence[cut_force::M_y], true));
  }
  return steps;
}

Steps flat_plate_steps(const EdgePlace& place) {
  Steps steps = membrane_steps(place);
  const auto& plate = std::get<Plate>(place.point->section.outer);
  const double width = plate.width.value(), h = plate.height.value();
  const double a = place.edge->diameter_to_width;
  const double bent = 6.0 / (width * (1.0 - a) * h * h);
  const double K_b = place.point->influence.normal[cut_force::M_y] / bent / place.lag *
                     (place.point->z.value() < 0.0 ? -1.0 : 1.0);
  steps.push_back({"K_b",
                   {"(1.79 + 0.25/(0.39 + d/h) + 0.81/(1 + (d/h)^2) - 0.26/(1 + (d/h)^3)) (1 - "
                    "1.04 a + 1.22 a^2)",
                    text::significant(K_b)},
                   {"bending of the plate, on 6 M/((1 - a) w h^2)"}});
  return steps;
}

Steps published_steps(const EdgePlace& place) {
  const std::string a = text::significant(place.edge->diameter_to_width);
  Steps steps{
      {"K_t",
       {"2.68750 exp(-0.7128 d/w)", fmt::format("2.68750 x exp(-0.7128 x {})", a), place.K_g()},
       {"as published, on the net section"}}};
  const auto& influence = place.point->influence.normal;
  const double z = place.point->z.value();
  const double A = place.net.area.value(), I_y = place.net.I_y.value();
  if (near(influence[cut_force::N], place.edge->factor / A)) {
    steps.push_back(coefficient("k_N", "K_t/A_net", fmt::format("{}/{}", place.K_g(), mm2(A)),
                                influence[cut_force::N], false));
  }
  if (place.lag == 1.0 && near(influence[cut_force::M_y], place.edge->factor * z / I_y)) {
    steps.push_back(coefficient("k_M", "K_t z/I_y,net",
                                fmt::format("{} x {}/{}", place.K_g(), term(text::mm(z)), mm4(I_y)),
                                influence[cut_force::M_y], true));
  }
  return steps;
}

}  // namespace

Steps hole_factor_steps(const Project& project, const StressPoint& point) {
  const EdgePlace place = place_of(project, point);
  switch (point.concentration->hole_case) {
    case HoleCase::in_plane_bending: return wall_hole_steps(place, project.in_space);
    case HoleCase::membrane_tension:
      return project.in_space ? wall_hole_steps(place, true) : flange_hole_steps(place);
    case HoleCase::out_of_plane_bending: return flat_plate_steps(place);
    case HoleCase::published_exponential: return published_steps(place);
  }
  return {};
}

}  // namespace boxbeam::report
