#include "boxbeam/verification/beam_properties.hpp"

#include <algorithm>

namespace boxbeam {
namespace {

double gravity_of(const Project& project) {
  return std::visit([](const auto& mechanism) { return mechanism.gravity.norm(); },
                    project.mechanism);
}

/// The shear lag that the checks of a station rest on.
std::optional<ShearLag> shear_lag_in(const Verification& verification, const Station& station) {
  for (const CheckResult& result : verification.checks) {
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
                                                     const Verification& verification) {
  std::vector<StationProperties> all;
  const auto gravity = si<Acceleration>(gravity_of(project));
  for (const StationEnvelope& envelope : verification.stations) {
    const Section section = section_at(project.beam, envelope.station);
    StationProperties& at = all.emplace_back();
    at.station = envelope.station;
    at.gross = properties_of(section);
    at.net = properties_of(section, holes_at(project.beam, envelope.station.s));
    at.weight = project.beam.density * at.gross.area * gravity;
    at.shear_lag = shear_lag_in(verification, envelope.station);
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

}  // namespace boxbeam
