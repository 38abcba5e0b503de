#include "boxbeam/verification/critical_instants.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace boxbeam {
namespace {

/// Whether an extreme is the upper or the lower one of its quantity, and what to call it; "" where
/// it is smaller than a share of the other, `nothing`.
std::string name_of_extreme(const std::vector<CriticalInstant>& instants,
                            const CriticalInstant& instant, double nothing) {
  double highest = instant.value;
  double size = 0.0;
  for (const CriticalInstant& other : instants) {
    if (other.quantity != instant.quantity) continue;
    highest = std::max(highest, other.value);
    size = std::max(size, std::abs(other.value));
  }
  if (std::abs(instant.value) < nothing * size) return "";
  const bool upper = instant.value == highest;
  if (upper) return (instant.value > 0.0 ? "largest " : "least negative ") + instant.quantity;
  return (instant.value > 0.0 ? "smallest " : "most negative ") + instant.quantity;
}

}  // namespace

std::vector<CriticalInstant> critical_instants_of(const Project& project,
                                                  const Verification& verification) {
  std::vector<CriticalInstant> instants;
  const auto add = [&](const CutForceName& quantity, Extreme Envelope::*end) {
    // Outside the beam, at the first and the last of the stations, nothing is cut.
    const std::span inside =
        std::span(verification.stations).subspan(1, verification.stations.size() - 2);
    const StationEnvelope* best = &inside.front();
    for (const StationEnvelope& station : inside) {
      const double value = (station.of[quantity.which].*end).value;
      const double so_far = (best->of[quantity.which].*end).value;
      if (end == &Envelope::largest ? value > so_far : value < so_far) best = &station;
    }
    const Extreme& at = best->of[quantity.which].*end;
    instants.push_back({quantity.name, best->station, at.time, at.value, at.situation});
  };
  for (const auto end : {&Envelope::largest, &Envelope::smallest}) {
    for (const CutForceName& quantity : cut_forces_looked_at(project)) add(quantity, end);
  }
  const CheckResult* governing = verification.governing(Criterion::fatigue);
  if (governing == nullptr || !governing->basis)
    governing = verification.governing(Criterion::yield);
  if (governing != nullptr && governing->basis) {
    const auto add_stress = [&](const Extreme& at) {
      instants.push_back({"stress", governing->check.station, at.time, at.value, at.situation});
    };
    add_stress(governing->basis->highest);
    if (governing->check.criterion == Criterion::fatigue) add_stress(governing->basis->lowest);
  }
  return instants;
}

std::vector<ShownInstant> instants_to_show(const Project& project,
                                           const Verification& verification) {
  // In space two moments and several situations compete for the place.
  const double nothing = in_space(project) ? 1e-2 : 1e-6;
  std::vector<ShownInstant> shown;
  for (const CriticalInstant& instant : verification.critical_instants) {
    if (!instant.quantity.starts_with("M") && instant.quantity != "stress") continue;
    const std::string why = name_of_extreme(verification.critical_instants, instant, nothing);
    if (why.empty()) continue;
    const auto motion =
        std::find_if(verification.motions.begin(), verification.motions.end(),
                     [&](const MotionSummary& of) { return of.situation == instant.situation; });
    const auto same = std::find_if(shown.begin(), shown.end(), [&](const ShownInstant& other) {
      return other.situation == instant.situation &&
             abs(other.time - instant.time) < 0.01 * motion->period;
    });
    if (same == shown.end())
      shown.push_back({instant.situation, instant.time, why});
    else
      same->why += ", " + why;
  }
  std::sort(shown.begin(), shown.end(), [](const ShownInstant& a, const ShownInstant& b) {
    return std::pair(a.situation, a.time) < std::pair(b.situation, b.time);
  });
  return shown;
}

}  // namespace boxbeam
