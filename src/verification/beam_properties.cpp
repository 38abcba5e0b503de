#include "boxbeam/verification/beam_properties.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/project/hole_rows.hpp"
#include "boxbeam/strength/hole_concentration.hpp"

namespace boxbeam {
namespace {

double gravity_of(const Project& project) {
  return std::visit([](const auto& mechanism) { return mechanism.gravity.norm(); },
                    project.mechanism);
}

/// The shear lag that the checks of a station rest on.
std::optional<ShearLag> shear_lag_in(const std::vector<CheckResult>& checks,
                                     const Station& station) {
  for (const CheckResult& result : checks) {
    if (result.basis && result.basis->point.station == station && result.basis->point.lag) {
      return result.basis->point.lag;
    }
  }
  return std::nullopt;
}

std::vector<LevelProperties> levels_at(const Project& project, const Section& section, Length s) {
  std::vector<LevelProperties> levels;
  for (const NamedPoint& point : project.points) {
    if (point.s != s) continue;
    levels.push_back({point.name, point.z,
                      first_moment_beyond(section, {}, point.z, properties_of(section).centroid_z),
                      width_at(section, {}, point.z)});
  }
  return levels;
}

}  // namespace

std::vector<StationProperties> station_properties_of(const Project& project,
                                                     const std::vector<StationEnvelope>& stations,
                                                     const std::vector<CheckResult>& checks) {
  std::vector<StationProperties> all;
  const auto gravity = si<Acceleration>(gravity_of(project));
  for (const StationEnvelope& envelope : stations) {
    const Section section = section_at(project.beam, envelope.station);
    StationProperties& at = all.emplace_back();
    at.station = envelope.station;
    at.gross = properties_of(section);
    at.net = properties_of(section, holes_in_section(project, envelope.station));
    at.weight = project.beam.density * at.gross.area * gravity;
    at.shear_lag = shear_lag_in(checks, envelope.station);
    at.levels = levels_at(project, section, envelope.station.s);
  }
  return all;
}

std::vector<BeamPart> parts_of(const TaperedBeam& beam) {
  std::vector<BeamPoint> places = beam.points;
  std::stable_sort(places.begin(), places.end(),
                   [](const BeamPoint& a, const BeamPoint& b) { return a.s < b.s; });
  places.erase(std::unique(places.begin(), places.end(),
                           [](const BeamPoint& a, const BeamPoint& b) { return a.s == b.s; }),
               places.end());
  std::vector<BeamPart> parts;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Length from = places[i].s;
    const Length to = places[i + 1].s;
    parts.push_back(
        {places[i].name, places[i + 1].name, from, to, mass_properties_of(beam, from, to)});
  }
  return parts;
}

std::vector<TaperSlope> taper_slopes_of(const TaperedBeam& beam) {
  std::vector<TaperSlope> slopes;
  for (const Segment& segment : beam.segments) {
    const Length rise = 0.5 * abs(height_of(segment.to.outer) - height_of(segment.from.outer));
    if (rise.value() == 0.0) continue;
    slopes.push_back({segment.name, std::atan2(rise.value(), segment.length.value())});
  }
  return slopes;
}

std::vector<PublishedConcentration> published_concentrations_of(const Project& project) {
  constexpr HoleCase published = HoleCase::published_exponential;
  std::vector<PublishedConcentration> concentrations;
  for (const BeamHole& at : project.holes) {
    if (at.concentration != published) continue;
    const double a = at.hole.diameter / plate_width_of(section_at(project.beam, {at.s}),
                                                       holes_at(project, at.s), at.hole, published);
    concentrations.push_back({at.hole.name, a, published_concentration(a)});
  }
  return concentrations;
}

}  // namespace boxbeam
