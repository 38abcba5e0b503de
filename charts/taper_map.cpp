#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/section/section_defect.hpp"
#include "boxbeam/section/section_points.hpp"
#include "charts/digits_left.hpp"
#include "charts/topics.hpp"

namespace boxbeam::charts {
namespace {

constexpr double height = 0.2, width = 0.05, root = 1.0;  // [m]
constexpr double density = 7850.0, gravity = 9.81;

Section plate(double h) { return {Plate{si<Length>(width), si<Length>(h)}, {}}; }

/// A plate of two pieces: one even, and behind it one that tapers to a part of the height.
TaperedBeam beam_of(double length, double ratio) {
  TaperedBeam beam;
  const Length at = si<Length>(root);
  beam.segments = {{"even", Length{}, at, plate(height), plate(height)},
                   {"taper", at, si<Length>(length), plate(height), plate(ratio * height)}};
  beam.density = si<Density>(density);
  return beam;
}

/// Places of the taper that are looked at: its ends and between them.
struct Look {
  Station station;
  long double h;  ///< height there
};

std::vector<Look> looks_of(const TaperedBeam& beam) {
  const Segment& taper = beam.segments[1];
  const long double from = height;
  const long double to = std::get<Plate>(taper.to.outer).height.value();
  const long double length = taper.length.value();
  std::vector<Look> looks{{{taper.start, Side::behind}, from}, {{taper.end(), Side::before}, to}};
  for (const double part : {0.3, 0.5, 0.9, 0.999}) {
    const Length s = taper.start + part * taper.length;
    if (s <= taper.start || s >= taper.end()) continue;
    // As far from the nearer end as the rounded stations are; of a short taper that is much.
    const long double before = static_cast<long double>(s.value()) - taper.start.value();
    const long double behind = static_cast<long double>(taper.end().value()) - s.value();
    looks.push_back({{s, Side::both},
                     before <= behind ? from + (to - from) * (before / length)
                                      : to + (from - to) * (behind / length)});
  }
  return looks;
}

double section_error(const TaperedBeam& beam) {
  double worst = 0.0;
  for (const Look& look : looks_of(beam)) {
    const double found = height_of(section_at(beam, look.station).outer).value();
    worst = std::max(worst, relative_error(found, look.h));
  }
  return worst;
}

/// Shear at the neutral axis per moment, which a change of height causes: beta = S/I = 1.5/h,
/// beta'/b = -1.5 h'/(b h^2).
double taper_error(const TaperedBeam& beam, const std::function<Taper(const Station&)>& taper_of) {
  const Segment& taper = beam.segments[1];
  const long double change =
      static_cast<long double>(std::get<Plate>(taper.to.outer).height.value()) -
      static_cast<long double>(height);
  const long double slope = change / static_cast<long double>(taper.length.value());
  double worst = 0.0;
  for (const Look& look : looks_of(beam)) {
    const StressField field =
        stress_field_of(section_at(beam, look.station), {}, taper_of(look.station));
    const auto points = points_at_level(field, "", Length{}, PointSet::in_plane);
    const double found = points.empty() ? 0.0 : points[0].influence.shear[cut_force::M_y];
    const long double exact = -1.5L * slope / (static_cast<long double>(width) * look.h * look.h);
    worst = std::max(worst, relative_error(found, exact));
  }
  return worst;
}

/// Differences over steps of a hundred-thousandth of the segment, whatever the section there.
Taper even_steps(const TaperedBeam& beam, const Station& station) {
  const Segment& segment = beam.segments[segment_at(beam, station)];
  if (segment.from == segment.to) return {};
  constexpr double step = 1e-5;
  const double here = (station.s - segment.start) / segment.length;
  const double per_step = 1.0 / (step * segment.length.value());
  const auto near = [&](double steps, double weight) {
    return NearbySection{interpolate(segment.from, segment.to, here + steps * step),
                         weight * per_step};
  };
  if (here < step) return {near(0.0, -1.5), near(1.0, 2.0), near(2.0, -0.5)};
  if (here > 1.0 - step) return {near(0.0, 1.5), near(-1.0, -2.0), near(-2.0, 0.5)};
  return {near(-1.0, -0.5), near(1.0, 0.5)};
}

/// Its own weight, held at the start: V and M on both ends of the taper, relative to the largest.
double cut_forces_error(const TaperedBeam& beam) {
  const Segment& taper = beam.segments[1];
  const long double g = gravity, rho = density, b = width, h0 = height, L = root;
  const long double h1 = std::get<Plate>(taper.to.outer).height.value();
  const long double l = taper.length.value();
  const long double even = rho * b * h0 * L * g;  // weights
  const long double tip = rho * b * l * (h0 + h1) / 2 * g;
  const long double arm = l * (h0 + 2 * h1) / (3 * (h0 + h1));           // of the tip's centre
  const long double V = even + tip, M = even * L / 2 + tip * (L + arm);  // at the start
  BeamLoads loads;
  PointLoad hold;
  hold.force.z() = static_cast<double>(V);
  hold.moment.y() = static_cast<double>(-M);
  loads.points = {hold};
  loads.lines = weight_and_inertia(beam, mass_distribution_of(beam), {0.0, 0.0, -gravity}, {});
  const CutForceDiagram diagram = cut_forces_of(loads);
  const CutForces at_start = diagram.at({taper.start, Side::behind});
  const CutForces at_end = diagram.at({taper.end(), Side::before});
  const auto off = [](double found, long double exact, long double scale) {
    return static_cast<double>(std::abs((static_cast<long double>(found) - exact) / scale));
  };
  return std::max({off(at_start.V_z.value(), -tip, V), off(at_end.V_z.value(), 0.0L, V),
                   off(at_start.M_y.value(), tip * arm, M), off(at_end.M_y.value(), 0.0L, M)});
}

MapPanel panel_of(std::string method, const std::function<double(const TaperedBeam&)>& error,
                  bool yardstick) {
  MapPanel panel;
  panel.method = std::move(method);
  panel.yardstick = yardstick;
  for (int j = -12; j <= 0; ++j) {
    for (int i = -12; i <= 1; ++i) {
      const double x = std::pow(10.0, i), y = std::pow(10.0, j);
      const TaperedBeam beam = beam_of(x * height, y);
      panel.cells.push_back(digits_cell(x, y, error(beam)));
    }
  }
  return panel;
}

}  // namespace

Map taper_map(const Scenes&, const Effort&) {
  Map map;
  map.name = "stability-taper";
  map.title = "Tapers: digits left from a gentle slope to a step, from even to a wedge";
  map.scene = "a plate 0.2 m high that tapers behind 1 m, its end and the taper's length over that";
  map.reference = "closed forms in long double";
  map.x.title = "length of the taper over its height";
  map.y.title = "height at its end over that at its start";
  map.value = "digits left";
  map.panels.push_back(panel_of("section along the taper", section_error, false));
  map.panels.push_back(panel_of("V and M from weight", cut_forces_error, false));
  map.panels.push_back(panel_of(
      "shear that the taper causes",
      [](const TaperedBeam& beam) {
        return taper_error(beam, [&](const Station& at) { return taper_at(beam, at); });
      },
      false));
  map.panels.push_back(panel_of(
      "the same, steps of 1e-5 of the length",
      [](const TaperedBeam& beam) {
        return taper_error(beam, [&](const Station& at) { return even_steps(beam, at); });
      },
      true));
  map.lesson = fmt::format(
      "Steps that follow the section keep the shear of a taper right up to a wedge; steps of a "
      "fixed part of the length are silently wrong in {} of {} tapers, the sharp ones. A height of "
      "zero is refused.",
      map.panels[3].count(Outcome::wrong), map.panels[3].cells.size());
  return map;
}

}  // namespace boxbeam::charts
