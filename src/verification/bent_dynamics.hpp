#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxbeam/verification/bent_axis.hpp"

namespace boxbeam {

/// Cut forces of the beam in a link's axes: N, V and the couple counter-clockwise.
struct ElementCut {
  double N = 0.0, V = 0.0, from = 0.0, to = 0.0;  ///< the couple at both ends of an element
  double couple() const { return 0.5 * (from + to); }
};

inline ElementCut operator-(const ElementCut& a, const ElementCut& b) {
  return {a.N - b.N, a.V - b.V, a.from - b.from, a.to - b.to};
}

/// Middles of the elements in the world and angles of their sections, three numbers each.
Eigen::VectorXd places_of(const BentAxis& axis, int body, const Eigen::VectorXd& q);

/// What a planar mechanism bears whose beam is bent, however far, by d'Alembert's principle.
class BentDynamics {
 public:
  /// `straight`: with the beam as a rigid body; it and the axis stay.
  BentDynamics(const planar::Mechanism& straight, int beam, const DividedAxis& axis)
      : straight_(&straight), beam_(beam), axis_(&axis) {}

  /// Of every element. `mechanism`: as `DividedAxis::with` has it; `state`: positions, velocities
  /// and accelerations of its bodies; `accelerations`: those of `places_of`.
  std::vector<ElementCut> cuts_of(const planar::Mechanism& mechanism, planar::State state,
                                  const BentAxis& axis, const Eigen::VectorXd& accelerations) const;

 private:
  /// Multipliers of the joints. `own`: weight and inertia of the elements, `where` they are.
  Eigen::VectorXd multipliers_of(const planar::Mechanism& mechanism, const planar::State& state,
                                 const Eigen::Matrix3Xd& own, const Eigen::VectorXd& where) const;
  /// Forces on the beam, and their moments about its origin, at every node.
  Eigen::Matrix3Xd acting_at_nodes(const planar::Mechanism& mechanism,
                                   const planar::State& state) const;

  const planar::Mechanism* straight_;
  int beam_;
  const DividedAxis* axis_;
};

}  // namespace boxbeam
