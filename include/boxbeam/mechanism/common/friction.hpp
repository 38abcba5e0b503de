#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace boxbeam {

/// What resists sliding, along the guide and against the sliding velocity v:
///
///     F = mu P v / sqrt(v^2 + creep^2) + c v
///
/// P is what presses on the guide (`pressure_of`). Source: Coulomb's law, smoothed where the
/// direction changes; Marques et al., Nonlinear Dynamics 86 (2016), for such smoothing.
struct Friction {
  double coulomb = 0.0;  ///< mu
  double viscous = 0.0;  ///< c [N s/m]
  /// Sliding velocity at which 71 % of the Coulomb part acts [m/s]; a case that gives none has less
  /// where drivers move the contact slowly (`fitted_creep`).
  double creep = 0.01;
  double guide = 0.0;  ///< l, between the two contacts of a guide [m]; 0: couples press nowhere
};

inline bool rubs(const Friction& law) { return law.coulomb != 0.0 || law.viscous != 0.0; }

/// What a guide along the unit vector a carries: the force N across it, then a couple M that tilts
/// what slides, as the vector M x a across the guide, which over the guide's length is the pair of
/// forces at its ends [N, N m].
using GuideLoad = Eigen::Matrix<double, 6, 1>;

/// What presses on a guide: the sizes of the contact forces at its two ends together, of a guide
/// without length |N|:
///
///     P = |N/2 + (M x a)/l| + |N/2 - (M x a)/l|
///
/// Where N and the couple act in one plane this is max(|N|, 2 |M|/l). Source: equilibrium of the
/// slide on two contacts, each with Coulomb's law.
double pressure_of(const Friction& law, const GuideLoad& load);

/// The force on what slides, along the sense in which v is positive [N].
double friction_force_of(const Friction& law, const GuideLoad& load, double v);

/// Solves for friction forces that depend on what presses on guides, which depends on them,
///
///     f_j = friction_j(load_0 + sum_k response_k f_k)
///
/// by Newton's method from none at all: the solution that goes over into that without friction.
/// `load_0`: six rows for each contact, a `GuideLoad`; `response`: their change per unit of each
/// force, a column each. Nothing where friction locks: more pressure asks for more friction than it
/// gives (Painleve's paradox, self-locking).
std::optional<Eigen::VectorXd> solve_friction(const std::vector<Friction>& laws,
                                              const Eigen::VectorXd& v,
                                              const Eigen::VectorXd& load_0,
                                              const Eigen::MatrixXd& response);

/// Throws the AnalysisError of friction in these joints that locks.
[[noreturn]] void say_locked(const std::vector<std::string>& joints, double time);

/// The creep velocity of a contact with dry friction of which a case gives none: at most
///
///     0.02 v_max
///
/// v_max its own largest sliding velocity over the time looked at, so that all but 2 % of the
/// friction acts wherever inertia or another load that turns with the motion is largest. Where that
/// time holds so many waves that the instants of a motion would not resolve it, 20 waves/24576 of
/// v_max. What is smaller already stays, and so do contacts that stand. Dry friction knows no
/// velocity: only the smoothing does. Source: Coulomb's law.
double fitted_creep(const Friction& law, double v_max, double waves);

}  // namespace boxbeam
