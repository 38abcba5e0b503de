#include "boxbeam/verification/critical_instants.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace boxbeam {
namespace {

double size_of(const CriticalInstant& instant) { return std::abs(instant.value); }

/// What is so small beside the largest force, moments over the length of the beam, is the rounding
/// of sums or no load to speak of.
constexpr double nothing = 1e-5;

void drop_nothing(const Project& project, std::vector<CriticalInstant>& cut) {
  const double length = project.beam.length().value();
  const auto as_force = [&](const CriticalInstant& instant) {
    return size_of(instant) / (instant.force->is_moment() ? length : 1.0);
  };
  double largest = 0.0;
  for (const CriticalInstant& instant : cut) largest = std::max(largest, as_force(instant));
  std::erase_if(
      cut, [&](const CriticalInstant& instant) { return as_force(instant) < nothing * largest; });
}

/// What to call an extreme; "" where it is smaller than a share of the other of its quantity.
std::string name_of_extreme(const std::vector<CriticalInstant>& instants,
                            const CriticalInstant& instant, double share) {
  if (!instant.force) {
    const std::string end = instant.end == End::largest    ? "highest"
                            : instant.end == End::smallest ? "lowest"
                                                           : "largest equivalent";
    return end + " stress at the governing place";
  }
  double size = 0.0;
  for (const CriticalInstant& other : instants) {
    if (other.quantity() == instant.quantity()) size = std::max(size, size_of(other));
  }
  if (size_of(instant) < share * size) return "";
  if (instant.end == End::largest)
    return (instant.value > 0.0 ? "largest " : "least negative ") + instant.quantity();
  return (instant.value > 0.0 ? "smallest " : "most negative ") + instant.quantity();
}

/// An instant at which one or more quantities have their extremes.
struct Shared {
  std::size_t situation;
  Time time;
  std::vector<std::pair<const CriticalInstant*, std::string>> reasons;

  /// Of a quantity that is there with both extremes, at different places, the larger counts.
  void add(const CriticalInstant& instant, const std::string& why) {
    for (auto& [other, other_why] : reasons) {
      if (other->quantity() != instant.quantity()) continue;
      if (size_of(instant) <= size_of(*other)) return;
      other = &instant;
      other_why = why;
      return;
    }
    reasons.emplace_back(&instant, why);
  }

  double largest_moment() const {
    double largest = 0.0;
    for (const auto& [instant, why] : reasons) {
      if (instant->force) largest = std::max(largest, size_of(*instant));
    }
    return largest;
  }

  bool has_stress() const {
    return std::any_of(reasons.begin(), reasons.end(),
                       [](const auto& reason) { return !reason.first->force; });
  }

  std::string why() const {
    std::string all;
    for (const auto& [instant, reason] : reasons) all += (all.empty() ? "" : ", ") + reason;
    return all;
  }
};

}  // namespace

std::vector<CriticalInstant> critical_instants_of(const Project& project,
                                                  const std::vector<StationEnvelope>& stations,
                                                  const std::vector<CheckResult>& checks) {
  std::vector<CriticalInstant> instants;
  const auto add = [&](const CutForceName& quantity, Extreme Envelope::*end) {
    // Outside the beam, at the first and the last of the stations, nothing is cut.
    const std::span inside = std::span(stations).subspan(1, stations.size() - 2);
    const bool largest = end == &Envelope::largest;
    const StationEnvelope* best = &inside.front();
    for (const StationEnvelope& station : inside) {
      const double value = (station.of[quantity.which].*end).value;
      const double so_far = (best->of[quantity.which].*end).value;
      if (largest ? value > so_far : value < so_far) best = &station;
    }
    const Extreme& at = best->of[quantity.which].*end;
    instants.push_back({quantity, best->station, at.time, at.value, at.situation,
                        largest ? End::largest : End::smallest});
  };
  for (const auto end : {&Envelope::largest, &Envelope::smallest}) {
    for (const CutForceName& quantity : cut_forces_looked_at(project)) add(quantity, end);
  }
  drop_nothing(project, instants);
  const CheckResult* governing = governing_of(checks, Criterion::fatigue);
  if (governing == nullptr || !governing->basis) governing = governing_of(checks, Criterion::yield);
  if (governing != nullptr && governing->basis) {
    const auto add_stress = [&](const Extreme& at, End end) {
      instants.push_back({{}, governing->check.station, at.time, at.value, at.situation, end});
    };
    const bool ranges = governing->check.criterion == Criterion::fatigue;
    add_stress(governing->basis->highest, ranges ? End::largest : End::neither);
    if (ranges) add_stress(governing->basis->lowest, End::smallest);
  }
  return instants;
}

std::vector<ShownInstant> instants_to_show(const Project& project,
                                           const std::vector<CriticalInstant>& instants,
                                           const std::vector<MotionSummary>& motions) {
  // In space two moments and several situations compete for the place.
  const double share = project.in_space ? 1e-2 : nothing;
  std::vector<Shared> found;
  for (const CriticalInstant& instant : instants) {
    if (instant.force && !instant.force->bends()) continue;
    const std::string why = name_of_extreme(instants, instant, share);
    if (why.empty()) continue;
    const auto motion = std::find_if(motions.begin(), motions.end(), [&](const MotionSummary& of) {
      return of.situation == instant.situation;
    });
    const auto same = std::find_if(found.begin(), found.end(), [&](const Shared& other) {
      return other.situation == instant.situation &&
             abs(other.time - instant.time) < 0.01 * motion->period;
    });
    if (same == found.end())
      found.push_back({instant.situation, instant.time, {{&instant, why}}});
    else
      same->add(instant, why);
  }
  std::vector<ShownInstant> shown;
  double largest = 0.0;
  for (const Shared& at : found) largest = std::max(largest, at.largest_moment());
  for (const Shared& at : found) {
    const double moment = largest > 0.0 ? at.largest_moment() / largest : 0.0;
    shown.push_back({at.situation, at.time, at.why(), moment + (at.has_stress() ? 1.0 : 0.0)});
  }
  std::sort(shown.begin(), shown.end(), [](const ShownInstant& a, const ShownInstant& b) {
    return std::pair(a.situation, a.time) < std::pair(b.situation, b.time);
  });
  return shown;
}

}  // namespace boxbeam
