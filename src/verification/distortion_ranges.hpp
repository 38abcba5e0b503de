#pragma once

#include <array>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/verification/life_cycles.hpp"
#include "channel_life.hpp"
#include "distorted_points.hpp"

namespace boxbeam {

/// Stresses along and across [Pa].
using DistortionStresses = std::array<double, 2>;

/// The fatigue of a stretch that is distorted, place by place.
class DistortionRanges {
 public:
  /// Looks at what is given, which stays. Of long records no cycles are counted.
  DistortionRanges(const Project& project, const std::deque<SituationRun>& runs,
                   const DistortedStretch& stretch);

  /// Takes a place, in any order: its points, of each run the cut forces at its instants, the
  /// largest stresses of M_D = 1 and gamma = 1; ranges below `least` are none.
  void look_at(std::size_t place, const std::vector<DistortedPoint>& points,
               const std::vector<std::vector<CutForces>>& cuts, const DistortionStresses& of_unit,
               double least);

  /// Whether they are judged by checks.
  bool judged() const { return counted_; }
  /// The largest ranges.
  const DistortionStresses& largest() const { return largest_; }
  /// Of a stress that gamma causes at a place, `of_unit` for gamma = 1 [Pa]: how much of a detail
  /// it uses, with `required`, and its largest range.
  double use_of(std::size_t place, double of_unit, const Detail& detail, StressKind kind) const;
  Stress range_of(std::size_t place, double of_unit) const;
  /// The worst by the details of the points and by `corner`.
  std::vector<CheckResult> checks() const;

 private:
  /// Situations that repeat, or change into each other, in the wanted life.
  struct Sequence {
    std::size_t situation = 0;
    std::vector<std::size_t> runs;  ///< one after the other
    std::vector<DistortionTravel> travels;
  };

  const Sequence& sequence_of(std::size_t situation) const;
  std::vector<SpectrumRow> spectrum_of(
      StressKind kind,
      const std::function<std::vector<Cycle>(const Sequence&, const Situation&)>& cycles_of) const;
  /// The worst of its kind, and at which place and point; of several as bad the first one.
  struct Worst {
    std::optional<CheckResult> check;
    std::size_t place = 0, point = 0;

    bool is_worse(double factor, std::size_t at_place, std::size_t at_point) const;
  };

  bool may_be_worse(std::size_t place, const DistortedPoint& of,
                    const std::vector<std::vector<CutForces>>& cuts) const;
  /// At the instant when most of `by` comes.
  CheckResult fatigue_check(std::size_t place, const DistortedPoint& of, const std::string& name,
                            const std::vector<LifeChannel>& channels, const ChannelLife& life,
                            double DistortionSize::*by) const;
  void look_along(std::size_t place, std::size_t point, const DistortedPoint& of,
                  const std::vector<SituationHistory>& histories);
  void look_across(std::size_t place, std::size_t point, const DistortedPoint& of);

  const Project* project_;
  const std::deque<SituationRun>* runs_;
  const DistortedStretch* stretch_;
  bool counted_ = false;
  std::vector<Sequence> sequences_;
  DistortionStresses largest_{};
  Worst along_, across_;
};

/// The torque that does most of the stresses of a place.
DistortedStretch::Torque torque_at(const DistortedStretch& stretch, std::size_t place,
                                   const TorquesIn& torques);

}  // namespace boxbeam
