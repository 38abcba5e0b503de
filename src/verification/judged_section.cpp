#include "boxbeam/verification/judged_section.hpp"

#include <algorithm>

#include "boxbeam/project/plate_detail.hpp"
#include "boxbeam/project/plate_material.hpp"

namespace boxbeam {

std::vector<Length> thickness_limits_of(const Project& project) {
  std::vector<Length> limits;
  for (const Material* material : materials_of(project)) {
    for (const ThicknessStep& step : material->steps) limits.push_back(step.up_to);
  }
  const auto add = [&](const BeamDetail& detail) {
    const std::vector<Length> of = thickness_limits_of(detail.detail);
    limits.insert(limits.end(), of.begin(), of.end());
  };
  add(project.fatigue.beam);
  for (const BeamDetail& detail : project.fatigue.details) add(detail);
  std::sort(limits.begin(), limits.end());
  limits.erase(std::unique(limits.begin(), limits.end()), limits.end());
  return limits;
}

Section section_inside(const TaperedBeam& beam, const Station& station) {
  const Segment& segment = beam.segments[segment_at(beam, station)];
  if (station.side == Side::both || segment.from == segment.to) return section_at(beam, station);
  constexpr double billionth = 1e-9;
  const double step = station.side == Side::before ? -billionth : billionth;
  const double fraction = (station.s - segment.start) / segment.length + step;
  return interpolate(segment.from, segment.to, std::clamp(fraction, 0.0, 1.0));
}

Section judged_section_at(const Project& project, const Station& station) {
  Section section = section_at(project.beam, station);
  const Segment& segment = project.beam.segments[segment_at(project.beam, station)];
  if (station.side == Side::both || segment.from == segment.to) return section;
  const std::vector<Length> limits = thickness_limits_of(project);
  constexpr double near = 1e-8;
  for (const Length& thickness : thicknesses_of(section)) {
    for (const Length& limit : limits) {
      if (abs(thickness - limit) < near * limit) return section_inside(project.beam, station);
    }
  }
  return section;
}

}  // namespace boxbeam
