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
/// P is what presses on the guide (`pressure_of`). Without a creep velocity it is Coulomb's law
/// itself: |F - c v| = mu P against the sliding, and a contact that stands sticks by whatever it
/// takes up to mu_s P (`sticking.hpp`). Source: Coulomb's law, smoothed where the direction
/// changes; Marques et al., Nonlinear Dynamics 86 (2016), for such smoothing.
struct Friction {
  double coulomb = 0.0;  ///< mu
  double viscous = 0.0;  ///< c [N s/m]
  /// Sliding velocity at which 71 % of the Coulomb part acts [m/s]; 0: all of it at any. A case
  /// that gives none has 0 where forces move the contact, less where drivers do so slowly
  /// (`fitted_creep`).
  double creep = 0.01;
  double guide = 0.0;     ///< l, between the two contacts of a guide [m]; 0: couples press nowhere
  double standing = 0.0;  ///< mu_s, of a contact that stands; mu where that is more
};

inline bool rubs(const Friction& law) { return law.coulomb != 0.0 || law.viscous != 0.0; }

/// Whether a contact follows Coulomb's law itself, and sticks where it stands.
inline bool can_stick(const Friction& law) { return law.coulomb != 0.0 && law.creep == 0.0; }

/// Of a contact that stands: the larger of mu and mu_s.
inline double static_coefficient_of(const Friction& law) {
  return law.standing > law.coulomb ? law.standing : law.coulomb;
}

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

/// What a contact does at an instant.
enum class Slip : signed char { back = -1, none = 0, ahead = 1 };

/// The same of a contact by its sliding velocity alone.
inline Slip slip_of(double v) { return v > 0.0 ? Slip::ahead : v < 0.0 ? Slip::back : Slip::none; }

/// What friction forces along contacts do at an instant, linear in them: a row, or of loads six,
/// and a column for each contact.
struct FrictionResponse {
  Eigen::VectorXd velocity;  ///< of sliding [m/s]
  Eigen::VectorXd load_0;    ///< a `GuideLoad` of each, without friction
  Eigen::MatrixXd load;      ///< its change per unit of each force
  Eigen::VectorXd rate_0;    ///< of the sliding velocity, without friction [m/s^2]
  Eigen::MatrixXd rate;      ///< its change per unit of each force [1/kg]

  explicit FrictionResponse(std::size_t contacts = 0);
};

/// Solves for friction forces that depend on what presses on guides, which depends on them, of
/// contacts that slide, and of those that stick for what keeps them so,
///
///     f_j = friction_j(load_0 + sum_k load_k f_k),   rate_0_j + sum_k rate_jk f_k = 0
///
/// by Newton's method from none at all: the solution that goes over into that without friction.
/// `slips`: of contacts that can stick, else not looked at; empty: none sticks, and rates are not
/// looked at. Nothing where friction locks: more pressure asks for more friction than it gives
/// (Painleve's paradox, self-locking), nor where contacts that stick repeat each other.
std::optional<Eigen::VectorXd> solve_friction(const std::vector<Friction>& laws,
                                              const std::vector<Slip>& slips,
                                              const FrictionResponse& response);

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
