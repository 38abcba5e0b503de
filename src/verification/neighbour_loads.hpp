#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/numerics/polynomial.hpp"
#include "boxbeam/verification/peak_over_time.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// The largest tension and the largest compression anywhere in a rod, below zero where it has none.
struct AxialForces {
  double tension = 0.0, compression = 0.0;  ///< [N]
};

/// What a joint bears that its pin does not.
struct BesidePin {
  double along = 0.0;   ///< force along the pin, by size [N]
  double moment = 0.0;  ///< moment across it, by size [N m]
};

/// In whose axes the force on a pin is looked at: its direction turns in those of others.
struct PinFrame {
  std::string name;  ///< of a body, "the ground", "the rod"
  /// 1: along the rod whose end the pin is; 2: across the pin's axis; 3: the joint keeps no axis.
  int ways = 2;
};

/// How the mass of a body lies about the line of a rod between two points of it.
struct RodMass {
  double mass = 0.0, length = 0.0;  ///< [kg, m]
  double centre = 0.0;              ///< of mass, along the line from its start [m]
  double beside = 0.0;              ///< of mass, beside the line [m]
  double inertia = 0.0;             ///< about the centre of mass, across the rod [kg m^2]

  /// Whether it is that of an even rod, to a percent.
  bool is_even() const;

  /// The largest moment per load per mass across a rod between pins whose mass lies unknown within
  /// its length, but by its centre and inertia: m (x_c (L - x_c) - I/m)/L, for at no place a mass
  /// dm bends by more than dm x (L - x)/L. Of an even rod 4/3 of what it is.
  double lever() const;

  /// Mass per length as a polynomial of second degree of the place along the rod that has its mass,
  /// centre and inertia [kg/m]: of an even rod a constant. Nothing where it is negative somewhere:
  /// the mass lies too near the ends, or too near one place.
  ///
  ///     a + b xi + c xi^2, xi = x/L - 1/2:  b = 12 m (x_c - L/2)/L^2,
  ///     c = 180 (J/L^3 - m/(12 L)),  a = m/L - c/12,  J = I + m (x_c - L/2)^2
  std::optional<Polynomial<2>> along() const;
};

/// Of a rod in the plane.
RodMass mass_of(const Body& body, const PlanarRod& rod);

/// What turns a rod in the plane or loads it beside its ends: the names of joints and forces.
std::vector<std::string> bending_of(const planar::Mechanism& mechanism, const PlanarRod& rod);

/// What joints with pins and rods bear in one situation, by rigid bodies: all that the checks of
/// neighbours ask of a mechanism, in the plane or in space. Looks at the run, which stays.
class NeighbourLoads {
 public:
  explicit NeighbourLoads(const SituationRun& run)
      : run_(&run), span_(sampled_time_of(run.loads)) {}
  NeighbourLoads(const NeighbourLoads&) = delete;
  NeighbourLoads& operator=(const NeighbourLoads&) = delete;
  virtual ~NeighbourLoads() = default;

  const SituationRun& run() const { return *run_; }
  const SampledTime& span() const { return span_; }

  /// Whether rigid bodies determine what a joint bears.
  virtual bool determines(int joint) const = 0;
  virtual std::string joint_name(int joint) const = 0;
  /// Of the bodies of a joint and, where it is one, of the rod without mass between them.
  virtual std::vector<PinFrame> frames_of(int joint) const = 0;
  /// Those that take hold of a rod, or are one.
  virtual std::vector<int> joints_of(const RodInput& rod) const = 0;

  /// The size of the force on the pin of a joint [N].
  virtual double force_in(int joint, double time) = 0;
  /// The same force in axes that turn with one of the joint's frames, by its ways [N].
  virtual Eigen::Vector3d force_seen(int joint, std::size_t frame, double time) = 0;
  virtual BesidePin beside_pin(int joint, double time) = 0;

  virtual AxialForces axial_forces_in(const RodInput& rod, double time) = 0;
  /// The largest moment that bends a rod at a time, by its own weight and inertia in the plane, by
  /// all that acts on it in space [N m].
  virtual double moment_in(const RodInput& rod, double time) = 0;
  /// What turns a rod or loads it beside its ends, so that it bends: the names of joints and
  /// forces.
  virtual std::vector<std::string> bending_of(const RodInput& rod) = 0;

  /// The largest force of any joint at a time [N].
  virtual double largest_force(double time) = 0;

  /// The largest value of a function of time over the motion, found between the instants.
  Extreme largest(const Project& project, const std::function<double(double)>& f) const;

 protected:
  /// A time as the motion knows it: behind the end of one that does not repeat is nothing.
  double within(double time) const;

 private:
  const SituationRun* run_;
  SampledTime span_;
};

using NeighbourRuns = std::vector<std::unique_ptr<NeighbourLoads>>;

/// Of every run, in their order. Precondition: a mechanism of rigid bodies.
NeighbourRuns neighbour_loads_of(const Project& project, const std::deque<SituationRun>& runs);

std::unique_ptr<NeighbourLoads> planar_neighbour_loads(const Project& project,
                                                       const SituationRun& run);
std::unique_ptr<NeighbourLoads> spatial_neighbour_loads(const SituationRun& run);

}  // namespace boxbeam
