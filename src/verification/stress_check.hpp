#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "channel_life.hpp"

namespace boxbeam {

/// A check of a stress but for partial factors and the factors that are asked for, on which nothing
/// in it depends: where, when, the cycles and what resists them. Ranges are limited without
/// gamma_Mf, and with gamma_Ff.
struct StressCheck {
  CheckResult result;
  std::vector<LifeChannel> channels = {};  ///< in fatigue
  std::size_t governing = 0;               ///< the situation that it is of, then
};

/// The checks of a station that are known but for partial factors, by criterion and point; nothing
/// where it has none.
class KnownChecks {
 public:
  /// `find`: what it is where it is not known.
  template <class Find>
  const std::optional<StressCheck>& of(const Project& project, Criterion criterion,
                                       const StressPoint& point, const Find& find) {
    // A search that ends elsewhere with every design finds ever new places.
    constexpr std::size_t most = 512;
    std::string key = key_of(project, criterion, point);
    if (const auto known = checks_.find(key); known != checks_.end()) return known->second;
    if (checks_.size() >= most) checks_.clear();
    return checks_.emplace(std::move(key), find()).first->second;
  }

 private:
  /// The bits of all in which points of a station differ.
  static std::string key_of(const Project& project, Criterion criterion, const StressPoint& point) {
    std::string key = point.name;
    const auto add = [&](const auto& value) {
      key.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    add(criterion);
    if (criterion == Criterion::stress_range) add(project.fatigue.demand.gamma_Ff);
    add(point.y.value());
    add(point.z.value());
    add(point.influence.normal);
    add(point.influence.shear);
    add(point.prismatic.normal);
    add(point.prismatic.shear);
    add(point.detail);
    add(point.shear_detail);
    if (point.concentration) add(point.concentration->edge.angle);
    return key;
  }

  std::unordered_map<std::string, std::optional<StressCheck>> checks_;
};

/// The checks of checks.hpp, so far. Nothing where the point has none.
std::optional<StressCheck> plain_yield(PointHistory& of);
std::optional<StressCheck> plain_fatigue(PointHistory& of, Criterion criterion);
std::optional<StressCheck> plain_range(PointHistory& of);
std::optional<StressCheck> plain_throat(const Project& project,
                                        const std::vector<SituationHistory>& histories,
                                        const StressPoint& point);

/// Whether with the factors of a case, too, it is of the same situation: of two whose cycles take
/// as much of the life rounding decides.
bool governs_still(const Project& project, const StressCheck& of);

/// Such a check with the factors of a case.
CheckResult with_partial_factors(const Project& project, StressCheck of);

}  // namespace boxbeam
