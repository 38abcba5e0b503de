#include "beam_json.hpp"

#include <algorithm>

#include "boxbeam/verification/beam_properties.hpp"

namespace boxbeam {
namespace {

Json pair(const Envelope& envelope) {
  return Json::array({finite(envelope.smallest.value), finite(envelope.largest.value)});
}

Json section_json(const StationProperties& at) {
  const SectionProperties& gross = at.gross;
  Json lag;
  if (at.shear_lag) {
    lag = {{"b_0", finite(at.shear_lag->b_0.value())},
           {"L_e", finite(at.shear_lag->effective_length.value())},
           {"kappa", finite(at.shear_lag->kappa)},
           {"beta", finite(at.shear_lag->beta)}};
  }
  Json levels = Json::array();
  for (const LevelProperties& level : at.levels) {
    levels.push_back({{"name", level.name},
                      {"z", finite(level.z.value())},
                      {"first_moment", finite(level.first_moment.value())},
                      {"width", finite(level.width.value())}});
  }
  return {{"s", finite(at.station.s.value())},
          {"side", to_text(at.station.side)},
          {"height", finite((gross.z_top - gross.z_bottom).value())},
          {"width", finite((gross.y_left - gross.y_right).value())},
          {"area", finite(gross.area.value())},
          {"I_y", finite(gross.I_y.value())},
          {"I_z", finite(gross.I_z.value())},
          {"W_y", finite(gross.W_y.value())},
          {"W_z", finite(gross.W_z.value())},
          {"area_of_holes", finite((gross.area - at.net.area).value())},
          {"net",
           {{"area", finite(at.net.area.value())},
            {"I_y", finite(at.net.I_y.value())},
            {"W_y", finite(at.net.W_y.value())}}},
          {"weight_per_length", finite(at.weight.value())},
          {"shear_lag", std::move(lag)},
          {"levels", std::move(levels)}};
}

}  // namespace

Json beam_json(const Project& project, const Verification& verification) {
  Json stations = Json::array();
  for (const StationEnvelope& station : verification.stations) {
    Json& at = stations.emplace_back(
        Json{{"s", finite(station.station.s.value())}, {"side", to_text(station.station.side)}});
    for (const auto& [which, name] : cut_forces_looked_at(project))
      at[name] = pair(station.of[which]);
  }
  Json parts = Json::array();
  for (const BeamPart& part : parts_of(project.beam)) {
    parts.push_back({{"from", part.from},
                     {"to", part.to},
                     {"mass", finite(part.mass.mass.value())},
                     {"centre_from_start", finite((part.mass.centre - part.start).value())},
                     {"centre_from_end", finite((part.end - part.mass.centre).value())},
                     {"inertia", finite(part.mass.inertia.value())}});
  }
  return {{"length", finite(project.beam.length().value())},
          {"mass", finite(verification.beam_mass.mass.value())},
          {"centre_of_mass", finite(verification.beam_mass.centre.value())},
          {"stations", std::move(stations)},
          {"inertia", finite(verification.beam_mass.inertia.value())},
          {"parts", std::move(parts)}};
}

Json sections_json(const Project& project, const Verification& verification) {
  Json sections = Json::array();
  for (const StationProperties& at : station_properties_of(project, verification)) {
    sections.push_back(section_json(at));
  }
  return sections;
}

Json concentrations_json(const Verification& verification) {
  Json list = Json::array();
  const auto add = [&](const std::string& hole, HoleCase by, double ratio, double factor) {
    Json entry = {{"hole", hole},
                  {"case", to_text(by)},
                  {"diameter_to_width", finite(ratio)},
                  {"factor", finite(factor)}};
    if (std::find(list.begin(), list.end(), entry) == list.end()) list.push_back(std::move(entry));
  };
  for (const PublishedConcentration& of : verification.published_concentrations) {
    add(of.hole, HoleCase::published_exponential, of.diameter_to_width, of.factor);
  }
  for (const CheckResult& result : verification.checks) {
    if (!result.basis || !result.basis->point.concentration) continue;
    const EdgeConcentration& edge = *result.basis->point.concentration;
    add(edge.hole, edge.hole_case, edge.diameter_to_width, edge.factor);
  }
  return list;
}

}  // namespace boxbeam
