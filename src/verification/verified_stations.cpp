#include "boxbeam/verification/verified_stations.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/span.hpp"

namespace boxbeam {
namespace {

/// Grid points inside a segment on which maxima along the beam are bracketed.
constexpr int grid = 24;

/// Whether section or loads jump at a place.
bool jumps_at(const TaperedBeam& beam, const LoadHistory& loads, Length s) {
  if (s.value() == 0.0 || s == beam.length()) return true;
  for (std::size_t i = 0; i + 1 < beam.segments.size(); ++i) {
    if (beam.segments[i].end() == s && !(beam.segments[i].to == beam.segments[i + 1].from))
      return true;
  }
  for (const PointLoad& load : loads.loads_at(loads.begin()).points) {
    if (load.s == s) return true;
  }
  return false;
}

/// What may peak inside a segment, over the instants.
using Peaks = std::vector<double>;

/// Where maxima are looked for.
struct Along {
  const TaperedBeam& beam;
  const std::vector<BendingZone>& zones;
  const LoadHistory& loads;
  bool space;
};

AreaSums working_sums_of(const Along& along, const Section& section, Length s) {
  const ShearLags lags = shear_lags_at(along.zones, section, s);
  return lags.count() ? sums_of(effective_properties_of(section, {}, lags))
                      : sums_of(outline_of(section, {}));
}

/// Stress range and largest stress of both outer fibres (without holes), the largest bending moment
/// and the largest shear force.
Peaks peaks_in_plane(const Along& along, Length s) {
  const LoadHistory& loads = along.loads;
  const Section section = section_at(along.beam, {s});
  const AreaSums sums = working_sums_of(along, section, s);
  const Extent extent = extent_of(section.outer);
  const StressInfluence high = normal_influence(sums, 0.0, extent.z_high.value());
  const StressInfluence low = normal_influence(sums, 0.0, extent.z_low.value());
  Span top, bottom, M, V;
  for (std::size_t i = 0; i < loads.instants(); ++i) {
    const CutForces cut = loads.diagram(i).at({s});
    top.add(stress_at(high, cut).normal.value());
    bottom.add(stress_at(low, cut).normal.value());
    M.add(cut.M_y.value());
    V.add(cut.V_z.value());
  }
  return {top.range(), bottom.range(), top.largest(), bottom.largest(), M.largest(), V.largest()};
}

/// The angle of the bending moment's main direction over the instants, from M_y towards M_z: of
/// largest variance, which turns with the loads.
double main_direction_of(const std::vector<CutForces>& cuts) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const CutForces& cut : cuts) mean += Eigen::Vector2d(cut.M_y.value(), cut.M_z.value());
  mean /= static_cast<double>(cuts.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const CutForces& cut : cuts) {
    const Eigen::Vector2d from = Eigen::Vector2d(cut.M_y.value(), cut.M_z.value()) - mean;
    spread += from * from.transpose();
  }
  return 0.5 * std::atan2(2.0 * spread(0, 1), spread(0, 0) - spread(1, 1));
}

/// Stress range and largest stress of any fibre, the resultants of M and V, the torque.
Peaks peaks_of_tube(const RoundTube& tube, const AreaSums& sums,
                    const std::vector<CutForces>& cuts) {
  const double radius = 0.5 * tube.diameter.value();
  const double main = main_direction_of(cuts);
  constexpr int fibres = 16;
  std::vector<StressInfluence> influences;
  for (int k = 0; k < fibres; ++k) {
    // M at an angle puts the fibre at that angle from +z towards -y in tension.
    const double angle = main + 2.0 * std::numbers::pi * k / fibres;
    influences.push_back(
        normal_influence(sums, -radius * std::sin(angle), radius * std::cos(angle)));
  }
  double range = 0.0, stress = 0.0;
  for (const StressInfluence& influence : influences) {
    Span span;
    for (const CutForces& cut : cuts) span.add(stress_at(influence, cut).normal.value());
    range = std::max(range, span.range());
  }
  Span M, V, T;
  for (const CutForces& cut : cuts) {
    const double moment = std::hypot(cut.M_y.value(), cut.M_z.value());
    // An inner profile may be stiffer about one axis: the softer one counts.
    const double bent = moment * radius / std::min(sums.yy, sums.zz);
    stress = std::max(stress, std::abs(cut.N.value()) / sums.area + bent);
    M.add(moment);
    V.add(std::hypot(cut.V_y.value(), cut.V_z.value()));
    T.add(cut.T.value());
  }
  return {range, stress, M.largest(), V.largest(), T.largest()};
}

/// The corners of a profile: no place in it has more normal stress than the worst of them.
std::vector<SectionPlace> corners_of(const Profile& profile) {
  if (const auto* polygon = std::get_if<Polygon>(&profile)) return polygon->outer;
  std::vector<SectionPlace> corners;
  if (std::holds_alternative<ThinWalled>(profile)) {
    for (const BorderPiece& piece : outline_of(profile))
      corners.push_back({si<Length>(piece.from.x()), si<Length>(piece.from.y())});
    return corners;
  }
  const Extent extent = extent_of(profile);
  for (const Length& y : {extent.y_high, extent.y_low}) {
    for (const Length& z : {extent.z_high, extent.z_low}) corners.push_back({y, z});
  }
  return corners;
}

/// Stress range and largest stress of every corner, and the largest of V_y, V_z, T, M_y and M_z.
Peaks peaks_in_space(const Along& along, Length s) {
  const Section section = section_at(along.beam, {s});
  const AreaSums sums = working_sums_of(along, section, s);
  std::vector<CutForces> cuts;
  cuts.reserve(along.loads.instants());
  for (std::size_t i = 0; i < along.loads.instants(); ++i)
    cuts.push_back(along.loads.diagram(i).at({s}));
  if (const auto* tube = std::get_if<RoundTube>(&section.outer))
    return peaks_of_tube(*tube, sums, cuts);

  Peaks peaks;
  for (const SectionPlace& corner : corners_of(section.outer)) {
    const StressInfluence influence = normal_influence(sums, corner.y.value(), corner.z.value());
    Span span;
    for (const CutForces& cut : cuts) span.add(stress_at(influence, cut).normal.value());
    peaks.push_back(span.range());
    peaks.push_back(span.largest());
  }
  for (const auto which :
       {cut_force::M_y, cut_force::M_z, cut_force::V_y, cut_force::V_z, cut_force::T}) {
    Span span;
    for (const CutForces& cut : cuts) span.add(value_of(cut, which));
    peaks.push_back(span.largest());
  }
  return peaks;
}

Peaks peaks_at(const Along& along, Length s) {
  return along.space ? peaks_in_space(along, s) : peaks_in_plane(along, s);
}

/// Brackets every inner maximum of each quantity on a grid in each piece and finds it by Brent.
void add_inner_maxima(const Along& along, std::vector<Length>& stations) {
  for (const CutForcePiece& piece : along.loads.diagram(0).pieces) {
    const auto at = [&](double j) { return piece.start + piece.length * (j / grid); };
    std::array<Peaks, grid + 1> values;
    for (std::size_t j = 0; j < values.size(); ++j) {
      // The very ends belong to the neighbours as well: look just inside.
      values[j] = peaks_at(along, at(std::clamp(static_cast<double>(j), 1e-6, grid - 1e-6)));
    }
    for (std::size_t q = 0; q < values[0].size(); ++q) {
      for (std::size_t j = 1; j < grid; ++j) {
        const double before = values[j][q] - values[j - 1][q];
        const double behind = values[j][q] - values[j + 1][q];
        // A difference within round-off is a level stretch, no maximum.
        const bool maximum =
            before >= 0.0 && behind > 0.0 && std::max(before, behind) > 1e-9 * values[j][q];
        if (!maximum) continue;
        const auto quantity = [&](double s) { return peaks_at(along, si<Length>(s))[q]; };
        const auto middle = static_cast<double>(j);
        stations.push_back(si<Length>(
            find_maximum(quantity, at(middle - 1.0).value(), at(middle + 1.0).value()).at));
      }
    }
  }
}

}  // namespace

std::vector<Station> stations_to_verify(const Project& project,
                                        const std::deque<SituationRun>& runs) {
  const std::vector<BendingZone> zones = bending_zones_of(project, runs);
  const TaperedBeam& beam = project.beam;
  std::vector<Length> places = places_of(beam);
  for (const NamedPoint& point : project.points) places.push_back(point.s);
  // The category changes at the ends of a detail's stretch; inside it is constant.
  for (const BeamDetail& stretch : project.fatigue.details) {
    places.push_back(stretch.from);
    places.push_back(stretch.to);
  }
  std::vector<Length> inner;
  for (const SituationRun& run : runs)
    add_inner_maxima({beam, zones, run.loads, in_space(project)}, inner);
  // Maxima of different quantities close together are one station, the one of the stress range
  // first: near its maximum a quantity is level, so that what the others lose is of second order.
  std::vector<Length> chosen;
  for (const Length& s : inner) {
    const auto nearer_than = [&](double part) {
      return
          [&beam, &s, part](const Length& other) { return abs(other - s) < part * beam.length(); };
    };
    if (std::any_of(places.begin(), places.end(), nearer_than(1e-4)) ||
        std::any_of(chosen.begin(), chosen.end(), nearer_than(0.01))) {
      continue;
    }
    chosen.push_back(s);
  }
  places.insert(places.end(), chosen.begin(), chosen.end());
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());

  std::vector<Station> stations;
  for (const Length& s : places) {
    const bool jump = std::any_of(runs.begin(), runs.end(), [&](const SituationRun& run) {
      return jumps_at(beam, run.loads, s);
    });
    if (!jump) {
      stations.push_back({s, Side::both});
      continue;
    }
    if (s.value() > 0.0) stations.push_back({s, Side::before});
    if (s < beam.length()) stations.push_back({s, Side::behind});
  }
  return stations;
}

}  // namespace boxbeam
