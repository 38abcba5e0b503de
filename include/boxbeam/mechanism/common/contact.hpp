#pragma once

#include <algorithm>
#include <limits>
#include <optional>

namespace boxbeam {

/// Which way a spring between two places acts: a cable or chain only pulls, and that where it is
/// longer than its free length; a stop or a tyre only pushes, where it is shorter.
enum class Acts { both, pulling, pushing };

/// How two bodies that touch come apart again: with d how far they are pressed into each other,
///
///     F = k d^n (1 + lambda d'),  never pulling
///
/// but beyond the depth d_v of a free impact that loses nothing, from where on lambda d' is of that
/// depth's force: what is pressed on by more than its impact is damped no more by it. lambda d'
/// takes energy away between approach and parting; lambda is set anew whenever they
/// touch, by the velocity v of their approach, so that a free impact ends with e v: see
/// `hysteresis_of`. Source: Hunt and Crossley, J. Appl. Mech. 42 (1975); Gonthier, McPhee, Lange
/// and Piedboeuf, Multibody System Dynamics 11 (2004).
struct Impact {
  double exponent = 1.0;     ///< n: 1, or 1.5 of round bodies (Hertz)
  double restitution = 1.0;  ///< e, `least_restitution` to 1
};

/// Below it the force while bodies part is all round-off: 1 - e lambda v is 1.6e-8 at 0.05.
inline constexpr double least_restitution = 0.05;

/// Approaches slower than this are damped as one of this velocity: they come apart faster than e
/// says [m/s]. The law needs a velocity, and a body that is laid down has none.
inline constexpr double slowest_approach = 1e-3;

/// x = lambda v of a free impact that ends with e v, whatever n, k and the masses are:
///
///     x (1 + e) = ln((1 + x)/(1 - e x)),  0 <= x < 1/e
///
/// the first integral of m v dv/(1 + lambda v) = -k d^n dd, from v at d = 0 back to d = 0: the
/// right side is none, and the left one is m/lambda^2 (x - ln(1 + x)) from -e x to x. None at e =
/// 1; grows without bound towards e = 0. Precondition: `least_restitution` <= e <= 1.
double hysteresis_of(double restitution);

/// Whether what acts from a length on has got there, and what it loses.
struct Touch {
  bool on = false;
  double loss = 0.0;                                       ///< lambda [s/m]
  double depth = std::numeric_limits<double>::infinity();  ///< d_v [m]
  double push = 0.0;  ///< a force besides, by which the mass is found that it meets [N]

  bool operator==(const Touch&) const = default;
};

/// What a spring does along the line of its ends: the tension k (l - l_0) + c l'; where it acts one
/// way only, with d = l - l_0 of a cable, l_0 - l of a stop, k d + c d' or the law of its impact,
/// none outside of d > 0 and none where that would act the other way.
struct LineLaw {
  double stiffness = 0.0;    ///< k [N/m, of an impact N/m^n]
  double free_length = 0.0;  ///< l_0 [m]
  double damping = 0.0;      ///< c [N s/m]
  Acts acts = Acts::both;
  std::optional<Impact> impact = {};
};

template <class Spring>
LineLaw law_of(const Spring& spring) {
  return {spring.stiffness, spring.free_length, spring.damping, spring.acts, spring.impact};
}

/// Whether it acts one way from a length on; a damper alone, without a free length, has none.
inline bool begins_at_length(const LineLaw& law) {
  return law.acts != Acts::both && (law.stiffness != 0.0 || law.free_length != 0.0);
}

/// How far it is beyond the length from which it acts one way, d [m], or of its rate d' [m/s].
inline double inward(const LineLaw& law, double longer) {
  return law.acts == Acts::pushing ? -longer : longer;
}

/// That its ends meet with a velocity [m/s]; `mass`: a force between them over how much faster it
/// parts them [kg]. For v at `slowest_approach` or above
///
///     d_v = ((n + 1) m v^2/(2 k))^(1/(n + 1))
///
/// by the work k d^(n + 1)/(n + 1) against m v^2/2.
Touch touched(const LineLaw& law, double approach, double mass);

/// Its tension [N] at a length and its rate; `touch`: of what acts from a length on.
double tension_of(const LineLaw& law, double length, double rate, const Touch& touch);

/// What its tension rises by with its length where it acts: k, of an impact n k d^(n - 1) [N/m].
double stiffness_at(const LineLaw& law, double length);

}  // namespace boxbeam
