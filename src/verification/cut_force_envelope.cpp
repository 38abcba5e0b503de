#include "boxbeam/verification/cut_force_envelope.hpp"

#include <array>

#include "linear_stress.hpp"

namespace boxbeam {
namespace {

Envelope envelope_of(const Project& project, const std::vector<SituationHistory>& histories,
                     cut_force::Index which) {
  static constexpr auto alone = [] {
    std::array<std::array<double, cut_force::count>, cut_force::count> of{};
    for (std::size_t k = 0; k < of.size(); ++k) of[k][k] = 1.0;
    return of;
  }();
  Envelope envelope;
  for (const SituationHistory& at : histories) {
    const std::size_t situation = index_of(project, *at.situation);
    const TurningPoint low = at.history.largest(LinearStress{&alone[which], -1.0});
    const TurningPoint high = at.history.largest(LinearStress{&alone[which]});
    const bool first = &at == &histories.front();
    if (first || -low.value < envelope.smallest.value)
      envelope.smallest = {low.time, -low.value, situation};
    if (first || high.value > envelope.largest.value)
      envelope.largest = {high.time, high.value, situation};
  }
  return envelope;
}

}  // namespace

std::span<const CutForceName> cut_forces_looked_at(const Project& project) {
  static constexpr CutForceName in_the_plane[] = {
      {cut_force::N, "N"}, {cut_force::V_z, "V"}, {cut_force::M_y, "M"}};
  static constexpr CutForceName all[] = {{cut_force::N, "N"},     {cut_force::V_y, "V_y"},
                                         {cut_force::V_z, "V_z"}, {cut_force::T, "T"},
                                         {cut_force::M_y, "M_y"}, {cut_force::M_z, "M_z"}};
  if (project.in_space) return all;
  return in_the_plane;
}

StationEnvelope envelope_at(const Project& project, const Station& station,
                            const std::vector<SituationHistory>& histories) {
  StationEnvelope envelope;
  envelope.station = station;
  for (const auto& [which, name] : cut_forces_looked_at(project)) {
    envelope.of[which] = envelope_of(project, histories, which);
  }
  return envelope;
}

}  // namespace boxbeam
