#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/verification/station_samples.hpp"

namespace boxbeam {

class AlongStretch;

/// How far criteria are used up on a grid along the stretch of a point, and near its places. Found
/// once for all who ask, the search and the checks at the same station.
class StretchUses {
 public:
  StretchUses(const StationSamples& samples, const StressPoint& point);

  const std::vector<double>& parts() const { return parts_; }  ///< of the stretch, ascending
  bool round() const { return round_; }
  /// At one of the parts.
  double at(std::size_t part, Criterion criterion) const { return judged_[part].of(criterion); }

  /// The largest between the neighbours of one of the parts. Precondition: samples and point are
  /// those of before.
  Extremum largest_near(std::size_t part, Criterion criterion, const StationSamples& samples,
                        const StressPoint& point) const;

 private:
  struct Top {
    std::size_t part;
    Criterion criterion;
    Extremum found;
  };

  std::shared_ptr<const AlongStretch> along_;
  bool round_ = false;
  std::vector<double> parts_;
  std::vector<Utilisations> judged_;
  mutable std::vector<Top> tops_;
};

/// Of all stretches among points.
std::vector<StretchUses> stretch_uses_of(const StationSamples& samples,
                                         std::span<const StressPoint> points);

/// A place on a stretch of wall, and how far a criterion is used up there.
struct WorstOnWall {
  double utilisation = 0.0;
  const StressPoint* point = nullptr;  ///< with the stretch; nothing where no place is worse
  double part = 0.0;                   ///< of the stretch
};

/// By each criterion the worst place on the stretches among the points of a station, as far as it
/// is worse than `named`, what is known already. On straight walls a coarse grid, whose local
/// maxima are followed where the parabola through them comes within 2 % of what is known: normal
/// stress is linear along such a wall and shear flow a parabola.
class WallSearch {
 public:
  /// `along`: of the stretches among the points.
  WallSearch(const StationSamples& samples, std::span<const StressPoint> points,
             std::span<const StretchUses> along, const Utilisations& named);

  const WorstOnWall& worst(Criterion criterion) const {
    return worst_[static_cast<std::size_t>(criterion)];
  }

 private:
  void look_along(const StationSamples& samples, const StressPoint& point,
                  const StretchUses& along);

  std::array<WorstOnWall, criteria.size()> worst_;
};

}  // namespace boxbeam
