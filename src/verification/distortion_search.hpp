#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <vector>

#include "boxbeam/section/cut_forces.hpp"
#include "boxbeam/verification/distortion_checks.hpp"
#include "distortion_ranges.hpp"

namespace boxbeam {

/// Between which each cut force of a station lies, over instants: what a stress that is linear in
/// them has at most, whose instants then need no look where even that would not count.
class CutForceHull {
 public:
  struct Bounds {
    double lowest = 0.0, highest = 0.0;

    double size() const { return std::max(std::abs(lowest), std::abs(highest)); }
  };

  void take(const CutForces& cut) {
    for (std::size_t k = 0; k < cut_force::count; ++k) {
      const double value = value_of(cut, static_cast<cut_force::Index>(k));
      lowest_[k] = std::min(lowest_[k], value);
      highest_[k] = std::max(highest_[k], value);
    }
  }

  /// Of what each cut force does by `factors`, those before `first` left out; not a number where a
  /// factor of one that is there is not known. Nothing taken: none.
  Bounds of(const std::array<double, cut_force::count>& factors, std::size_t first = 0) const {
    // Sums of the same products in another order differ by less.
    constexpr double round_off = 1e-12;
    Bounds bounds;
    double size = 0.0;
    for (std::size_t k = first; k < cut_force::count; ++k) {
      if (!(highest_[k] >= lowest_[k]) || (lowest_[k] == 0.0 && highest_[k] == 0.0)) continue;
      const double a = factors[k] * lowest_[k], b = factors[k] * highest_[k];
      if (std::isnan(a) || std::isnan(b))
        return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
      bounds.lowest += std::min(a, b);
      bounds.highest += std::max(a, b);
      size += std::max(std::abs(a), std::abs(b));
    }
    bounds.lowest -= round_off * size;
    bounds.highest += round_off * size;
    return bounds;
  }

 private:
  static constexpr std::array<double, cut_force::count> all(double value) {
    return {value, value, value, value, value, value};
  }

  std::array<double, cut_force::count> lowest_ = all(std::numeric_limits<double>::infinity());
  std::array<double, cut_force::count> highest_ = all(-std::numeric_limits<double>::infinity());
};

/// Searches one stretch for the places that distortion uses most.
///
/// First every place is looked over: how much is distorted there, and what each of its points could
/// be used at most. Points are then judged instant by instant at the places that may be used most
/// first, and where even the most is less than what was found, not at all.
class DistortionSearch {
 public:
  DistortionSearch(const Project& project, const std::deque<SituationRun>& runs,
                   const std::vector<BendingZone>& zones, const DistortedStretch& stretch,
                   const BoxStretch& segments);

  const DistortionEstimate& estimate() const { return found_; }

  std::vector<CheckResult> checks();

 private:
  struct Worst {
    double used = 0.0;
    std::size_t place = 0, run = 0, instant = 0, point = 0;
    Time time;
    PointUse use;
  };
  /// A place as it was looked over.
  struct LookedOver {
    std::vector<DistortedPoint> points;
    std::vector<double> most;    ///< that each of them can be used
    DistortionStresses of_unit;  ///< the largest along and across, of M_D = 1 and gamma = 1 [Pa]
    double shear = 0.0;          ///< the same along a wall
    double yield = 0.0;          ///< the least strength [Pa]

    double largest() const;
  };

  const Station& station_of(std::size_t place) const { return stretch_->places()[place].station; }
  std::vector<std::vector<CutForces>> cuts_at(std::size_t place) const;
  LookedOver look_over(std::size_t place);
  /// What distorts a place at an instant; none where that is no effect.
  std::optional<DistortionSize> size_at(const LookedOver& of, std::size_t place, std::size_t run,
                                        std::size_t instant) const;
  void look_at(std::size_t place, const LookedOver& of);
  void look_at(std::size_t place, std::size_t point, const DistortedPoint& of,
               const std::vector<std::vector<CutForces>>& cuts,
               const std::vector<std::vector<std::optional<DistortionSize>>>& sizes);
  void look_at(const Diaphragm& of);
  /// Its fillets and its plate in shear, strips beside an opening bent in its plane as corners are.
  void look_at_life(std::size_t place, const Diaphragm& of, double stiffness,
                    DistortionEstimate::Holding& holding) const;
  void note_size(std::size_t place, std::size_t run, std::size_t instant,
                 const DistortionStresses& of, double yield, bool slender);
  void note_bending(const std::vector<DistortedPoint>& points,
                    const std::vector<std::vector<CutForces>>& cuts,
                    const std::vector<CutForceHull>& hulls);
  /// The maximum between the instants beside the worst, at its place.
  void refine();
  PointUse use_in(const BeamLoads& loads) const;
  CheckResult strength_check();

  const Project* project_;
  const std::deque<SituationRun>* runs_;
  const std::vector<BendingZone>* zones_;
  const DistortedStretch* stretch_;
  DistortionRanges ranges_;
  DistortionEstimate found_;
  Worst worst_;
  std::vector<DistortedPoint> points_;  ///< at the worst place
};

}  // namespace boxbeam
