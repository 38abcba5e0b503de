#pragma once

#include <Eigen/Core>
#include <string>

#include "boxbeam/mechanism/planar/equations_of_motion.hpp"

/// Integrators of constrained motion that others use, on the program's own equations of motion.
namespace boxbeam::charts {

/// A motion on its way.
struct Moving {
  double time = 0.0;
  Eigen::VectorXd q, v, a, lambda;
  /// The smoothed accelerations of the generalised-alpha method; empty at the start.
  Eigen::VectorXd algorithmic;
  std::string failure;  ///< why it came no further, in a few words
};

Moving moving_of(const planar::State& state);

/// The assembled start of a mechanism.
Moving start_of(const planar::Mechanism& mechanism);

/// What becomes of the constraints when only accelerations are integrated.
enum class Constraints {
  left,       ///< nothing: they drift
  projected,  ///< after every step
};

/// Classical Runge-Kutta method of order 4 on the index-1 equations, `steps` equal steps.
void runge_kutta_4(planar::EquationsOfMotion& equations, Moving& moving, double until, int steps,
                   Constraints constraints);

/// Dormand and Prince's method of order 5 with step control (Boost.Odeint) on the same equations.
/// Source: J. Comput. Appl. Math. 6 (1980) 19-26.
void dormand_prince(planar::EquationsOfMotion& equations, Moving& moving, double until,
                    double tolerance, Constraints constraints);

/// Parameters of the generalised-alpha method.
struct GeneralisedAlpha {
  double alpha_m = 0.0, alpha_f = 0.0, beta = 0.25, gamma = 0.5;
};

/// Newmark's method of constant average acceleration.
constexpr GeneralisedAlpha newmark() { return {}; }
/// With a spectral radius at high frequencies, below 1.
GeneralisedAlpha damped_by(double spectral_radius);

/// Newmark's family on the constraints as they are (index 3), `steps` equal steps, each solved by
/// Newton. Source: Arnold, Bruls, Multibody System Dynamics 18 (2007) 185-202.
void generalised_alpha(planar::EquationsOfMotion& equations, const planar::Mechanism& mechanism,
                       Moving& moving, double until, int steps, const GeneralisedAlpha& parameters);

/// Central differences on the constraints (RATTLE), `steps` equal steps; symplectic. Source:
/// Andersen, J. Comput. Phys. 52 (1983) 24-34.
void central_differences(planar::EquationsOfMotion& equations, const planar::Mechanism& mechanism,
                         Moving& moving, double until, int steps);

}  // namespace boxbeam::charts
