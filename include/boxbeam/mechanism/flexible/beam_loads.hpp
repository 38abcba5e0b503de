#pragma once

#include "boxbeam/beam/beam_loads.hpp"
#include "boxbeam/mechanism/flexible/response.hpp"

namespace boxbeam::flexible {

/// Loads on the beam that is a link, from the joints and loads on it, its weight and its inertia.
struct BeamResponse {
  BeamLoads constant;
  /// Amplitudes with sin(omega t) and cos(omega t); their places and stretches are those of
  /// `constant`, in the same order.
  BeamLoads sine, cosine;
  double frequency = 0.0;  ///< [Hz]
};

/// A motion with the acceleration -`square` times itself, of links that damp as they do at `omega`
/// [rad/s]: in the exact form that is its shape between the nodes.
struct Vibration {
  LinkColumns<Complex> motion;
  double square = 0.0;  ///< [1/s^2]
  double omega = 0.0;   ///< zero: undamped
};

/// The loads in a response that is in balance with the inertia of a motion: its own, or less where
/// a model counts less.
///
/// Weight is laid out as the mass is. Inertia keeps force and moment of every rigid element, so
/// that what acts is in balance to round-off: classical elements move as one,
///
///     q(s) = omega^2 mu(s) (w_i + phi_i (s - s_i))
///
/// and the masses gathered from a part between two nodes give a load that varies linearly over it.
/// Uniform and linear accelerations are exact, and the moment within a part has its local share
/// q s (D - s)/2. Where the link bears an axial force that was there before (`load_axially`), what
/// that force does to the bent link comes to it, d/ds (N w') across the straight axis: cut forces
/// are then those of the second order, V across the bent axis. Precondition: the link's axis is
/// that of the beam. Source: d'Alembert's principle.
BeamResponse beam_response_of(const Structure& structure, int link, const TaperedBeam& beam,
                              const Response& response, const Vibration& inertial);
/// Of a motion of the response's frequency.
BeamResponse beam_response_of(const Structure& structure, int link, const TaperedBeam& beam,
                              const Response& response, const LinkColumns<Complex>& inertial);

/// constant + sine sin(omega t) + cosine cos(omega t).
BeamLoads beam_loads_at(const BeamResponse& response, double time);

}  // namespace boxbeam::flexible
