#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "boxbeam/mechanism/spatial/forced_motion.hpp"
#include "boxbeam/mechanism/spatial/friction.hpp"
#include "boxbeam/mechanism/spatial/loops.hpp"
#include "boxbeam/mechanism/spatial/tree.hpp"

namespace boxbeam::spatial {

/// What a body's inertia puts on the mechanism (d'Alembert), about its centre of mass.
struct InertiaLoad {
  Eigen::Vector3d force;   ///< -m a
  Eigen::Vector3d moment;  ///< -(I alpha + omega x I omega)
  /// The part of the moment that there is only because the body turns in its own joint, u against
  /// the body that carries it, whose rate of turn is O:
  ///
  ///     -(I (O x u) + O x I u + u x I O + u x I u)
  ///
  /// For a wheel of inertia I_1 about its axle this is -I_1 O x u, the gyroscopic moment.
  Eigen::Vector3d gyroscopic;
};

/// A mechanism in space that its drivers and forces move, prepared for many instants. Keeps a
/// reference to it.
class Chain {
 public:
  /// Throws AnalysisError where loops cannot be closed, drivers do not determine them, forces
  /// cannot be followed, or what presses on a joint that rubs is not determined.
  explicit Chain(const Mechanism& mechanism);

  const Mechanism& mechanism() const { return tree_.mechanism(); }
  const Tree& tree() const { return tree_; }

  /// All bodies at a time, with what rubs. Throws AnalysisError where loops cannot follow their
  /// drivers until then, or friction locks the mechanism.
  State at(double time) const;
  void at(double time, State& state) const;

  /// What each joint does to the body that it carries, at the joint's point, and behind them what
  /// each closing joint does to its body b, about its place there: its drive and its friction, as
  /// the state has it, with what else it carries.
  std::vector<Wrench> joint_wrenches(const State& state) const;
  void joint_wrenches(const State& state, std::vector<Wrench>& joints) const;

  /// What rubs, in the order of a state's friction.
  const std::vector<FrictionContact>& contacts() const { return contacts_; }
  /// The friction force of each joint that carries a body or closes a loop, as the state has it, on
  /// the body that it carries or its b, along its axis [N]; zero where none rubs.
  std::vector<double> friction_by_joint(const State& state) const;
  /// What the drive of a joint does to the body that it carries along the joint's axis: what
  /// `wrench` has there but for friction [N or N m].
  double along_axis(const State& state, std::size_t joint, const Wrench& wrench) const;

  /// The closing joints, or nothing where the mechanism has none.
  const Loops* loops() const { return loops_.get(); }
  /// What forces move, or nothing.
  const ForcedMotion* forced() const { return forced_.get(); }

 private:
  Tree tree_;
  std::vector<FrictionContact> contacts_;
  std::shared_ptr<Loops> loops_;
  std::shared_ptr<const ForcedMotion> forced_;
};

InertiaLoad inertia_of(const Mechanism& mechanism, const State& state, std::size_t body);

}  // namespace boxbeam::spatial
