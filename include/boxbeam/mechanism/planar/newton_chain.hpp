#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/beam/beam_loads.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"

namespace boxbeam::planar {

/// One step of a Newton chain: a body, or a piece of the beam body, taken as a mass at its centre.
struct ChainStep {
  std::string name;
  int body = ground;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of the mass, in body axes [m]
  double mass = 0.0;                                 ///< [kg]
};

/// The load model of the published sledge-rig calculation:
///
///     g_i = m_i a_i + g_(i-1),   sought mass = g_x / a_x of the last body
///
/// from the driven end, whose mass is the wanted equivalent mass, to the mass that is sought. It
/// leaves out lever arms, and the beam's inertia acts only at its two ends. Kept for comparison
/// with that calculation; the reactions of the mechanism are the rigorous loads.
struct NewtonChain {
  std::vector<ChainStep> steps;  ///< all but the last
  ChainStep last;                ///< its mass is what is found
  std::size_t first_end = 0;     ///< the step whose g loads the beam at `first_station`
  std::size_t second_end = 0;    ///< likewise `second_station`
  Length first_station, second_station, pivot;
  int axis_body = ground;  ///< body along whose x axis the beam lies
};

/// Force after each step, in world axes, and the mass that the chain yields.
struct ChainForces {
  std::vector<Eigen::Vector2d> g;  ///< [N]
  double sought_mass = 0.0;        ///< [kg]; 0 where the last body does not accelerate along x
};

/// Chain of given accelerations of the mass centres [m/s^2], the last body's behind the steps'.
ChainForces chain_of(const NewtonChain& chain, const std::vector<Eigen::Vector2d>& accelerations);

/// Chain at an instant of the mechanism.
ChainForces chain_at(const NewtonChain& chain, const State& state);

/// The chain's loads on the beam: its forces at the two ends, the weight per length, and at the
/// pivot the force that closes the balance and the couple that the missing lever arms leave over.
BeamLoads beam_loads_of(const NewtonChain& chain, const TaperedBeam& beam,
                        const std::vector<SegmentMass>& distribution,
                        const Eigen::Vector2d& gravity, const State& state);

/// The moments that the published sledge-rig calculation carries along its Newton chain, without
/// any force times arm:
///
///     n_i = J_i alpha_i + n_(i-1)
///
/// J_i      of the body about its centre of mass [kg m^2]
/// alpha_i  its angular acceleration [rad/s^2]
///
/// For comparison with that calculation only; the loads on the beam do not use them. From the first
/// step that is a piece of a body, whose J the chain does not have, there are none.
std::vector<std::optional<double>> chain_moments_at(const Mechanism& mechanism,
                                                    const NewtonChain& chain, const State& state);

}  // namespace boxbeam::planar
