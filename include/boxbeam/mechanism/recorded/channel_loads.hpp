#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "boxbeam/beam/beam_loads.hpp"
#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/mechanism/recorded/record.hpp"

/// Loads on a beam that others have measured or computed.
namespace boxbeam::recorded {

/// Values of several channels at common instants, linear between them.
struct Channels {
  std::vector<double> times;                ///< [s], strictly ascending, two at least
  std::vector<std::vector<double>> values;  ///< of each channel, one for each instant
  /// The history of which these are some instants, the first and the last among them; none where
  /// they are all.
  std::shared_ptr<const Record> record = {};
  std::shared_ptr<const OuterInstants> outer = {};  ///< of it
};

/// A long record by some of its instants, in any order, also more than once.
Channels at_instants(std::shared_ptr<const Record> record, std::vector<std::size_t> instants);

/// Loads on a beam over time: a constant part and, for each channel, loads that do not change times
/// its value. All of them have the same places and stretches, in the same order.
///
/// What is linear in the loads (a cut force, a stress) is therefore linear between instants, and
/// its turning points stand at instants.
struct ChannelLoads {
  std::shared_ptr<const Channels> channels;
  BeamLoads constant;
  std::vector<BeamLoads> units;  ///< of each channel for a value of one
};

/// Adds cut forces on the same pieces, so many times.
void add(CutForceDiagram& sum, double factor, const CutForceDiagram& diagram);

/// Index of the last instant not behind a time; the first before all. Below the last index, so that
/// an instant follows.
std::size_t instant_before(const Channels& channels, double time);

/// The values of all channels at a time, which lies between the first instant and the last.
std::vector<double> values_at(const Channels& channels, double time);

/// The loads at a time.
BeamLoads loads_at(const ChannelLoads& of, double time);

/// The six cut forces N, V_y, V_z, T, M_y, M_z of a section [N, N m].
using SixForces = std::array<double, 6>;

/// Loads whose cut forces have given values at stations and are linear between them: with Q' = -q
/// and M' = V - m (signs as in `CutForceDiagram`)
///
///     q = -(V_b - V_a)/h,   m = V - (M_b - M_a)/h,
///
/// and at both ends of the beam what is cut there. They are in balance. The stations ascend, the
/// first at the beam's start, the last at its end; one between them that stands twice has what is
/// cut before and behind it, where the loads have a point load. Else they have a stretch between
/// each two neighbours of stations and borders of segments.
BeamLoads loads_of_cuts(const TaperedBeam& beam, std::span<const double> stations,
                        std::span<const SixForces> values);

/// How a beam moves, at the instants of channels: acceleration of its start less gravity, angular
/// velocity and acceleration, in beam axes. A series that is empty is zero.
struct MotionChannels {
  std::array<std::vector<double>, 3> acceleration;  ///< [m/s^2]
  std::array<std::vector<double>, 3> omega;         ///< [rad/s]
  std::array<std::vector<double>, 3> alpha;         ///< [rad/s^2]
};

/// The same from the path of the beam's start and the turn of its axis in the plane of x and z,
/// z upwards, by `derivatives_of`. Three instants at least.
MotionChannels motion_of_path(const std::vector<double>& times, const std::vector<double>& x,
                              const std::vector<double>& z, const std::vector<double>& angle,
                              double gravity);

/// Adds the beam's own inertia (and weight, which is in the acceleration): channels for what it is
/// linear in, which are the acceleration, alpha and the products of omega.
void add_inertia(const TaperedBeam& beam, const MotionChannels& motion, Channels& channels,
                 ChannelLoads& loads);

/// What balances loads, acting at one place of the beam, as a clamp there would.
PointLoad balance_at(Length s, const BeamLoads& loads);

}  // namespace boxbeam::recorded
