#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/verification/second_order_estimate.hpp"

/// What bending under axial force adds to the stresses of the places of a beam.
namespace boxbeam {

/// Stresses of the straight beam and what bending changes, a row for each instant [Pa]; of each
/// place both outer fibres, in space those of `stresses_at`.
struct Compared {
  Eigen::MatrixXd straight, change;

  void add(const Eigen::ArrayXd& of_straight, const Eigen::ArrayXd& of_change);
  /// Largest change by the largest stress, or of the range by the largest range.
  double relative() const;
};

/// The same instants bent by the axial force of the design loads, and by that of the loads times
/// one; of both the stresses under the loads times one.
struct BothCompared {
  Compared design, once;  ///< once: empty where both are the same

  const Compared& of_once(double factor) const { return factor == 1.0 ? design : once; }
};

/// Of one plane, or in space: the growth of the stresses of all situations that are looked at.
class GrowthByPlace {
 public:
  /// So many stresses stand for each place.
  explicit GrowthByPlace(Eigen::Index of_place = 2) : of_place_(of_place) {}

  /// `factor`: the design factor of the situation, under which `of` is bent, and which fatigue, of
  /// `once`, does not count.
  void add(const Compared& of, const Compared& once, double factor);

  /// Adds what is found to that of another plane, in which a corner is stressed as well.
  void add_to(std::vector<StressGrowth>& growth) const;

 private:
  /// Of each place, the largest.
  struct Situation {
    Eigen::ArrayXd straight, bent, range, bent_range;
  };

  Eigen::Index of_place_;
  std::vector<Situation> situations_;
  Eigen::MatrixXd straight_, bent_;  ///< smallest and largest of each situation
};

/// The larger of both, place by place.
void raise_to(const std::vector<StressGrowth>& other, std::vector<StressGrowth>& growth);

/// An estimate, and what it says of a beam whose cut forces hold the second order of its loads
/// times one already: what the design loads add to that, of the stress alone.
struct DesignedSecondOrder {
  SecondOrderEstimate estimate;
  std::vector<StressGrowth> beyond_once;
};

/// As `estimate_second_order`, with both.
DesignedSecondOrder estimate_designed_second_order(const Project& project,
                                                   const std::deque<SituationRun>& runs);

/// Largest N/N_cr of a situation in the plane of motion, in space in the weaker plane, under its
/// loads times one, at the instants that `estimate_second_order` looks at; one or more where it
/// buckles.
double pressed_part_in(const Project& project, const SituationRun& run);

}  // namespace boxbeam
