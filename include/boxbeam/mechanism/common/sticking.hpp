#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/mechanism/common/friction.hpp"

namespace boxbeam {

/// Where a contact begins to do something else, in a motion that forces decide.
struct SlipChange {
  double time = 0.0;  ///< [s]
  std::string joint;
  Slip from = Slip::none, to = Slip::none;
};

std::vector<double> times_of(const std::vector<SlipChange>& changes);

/// How contacts without a creep velocity go on from an instant, and the friction forces of all.
struct Sticking {
  std::vector<Slip> slips;
  Eigen::VectorXd forces;  ///< [N]
};

/// Decides it: of contacts that stand (`stands`) which stick and which way the others begin to
/// slide; those that slide go on by their velocity. Coulomb's law of each that stands:
///
///     sticks:  r = 0, |f| <= mu_s P;    slides:  f = -mu_s P sign(r),  r its rate
///
/// A contact that slides so has only mu from there on, which may move others in turn. All states of
/// the contacts that stand are tried. Throws AnalysisError where none agrees with that law or
/// several do (Painleve's paradox), and where they differ only in how contacts that stick share
/// their forces, which rigid bodies do not determine. `names`: of the joints.
/// Source: Loetstedt, SIAM J. Appl. Math. 42 (1982); Pfeiffer and Glocker, Multibody Dynamics with
/// Unilateral Contacts (1996), for friction by complementarity.
Sticking decide_sticking(const std::vector<Friction>& laws, const FrictionResponse& response,
                         const std::vector<char>& stands, const std::vector<std::string>& names,
                         double time);

/// Whether contacts may go on as they do: those that slide have not turned round, by more than a
/// velocity `rest` [m/s], and those that stick bear no more than mu_s P. `forces`: friction [N].
bool slips_go_on(const std::vector<Friction>& laws, const std::vector<Slip>& slips,
                 const Eigen::VectorXd& velocity, const Eigen::VectorXd& forces,
                 const Eigen::VectorXd& pressure, double rest);

/// Of velocities that are none, below this share of them what slides has not turned round.
inline constexpr double turning_back = 1e-3;

/// Which contacts stand: those that stick, and those that slide no faster than `rest` [m/s].
/// `slips`: what they have done, empty where it is not known.
std::vector<char> standing_contacts(const std::vector<Friction>& laws,
                                    const std::vector<Slip>& slips, const Eigen::VectorXd& velocity,
                                    double rest);

/// The impulses along contacts that take the sliding velocities of the given ones to zero [N s].
Eigen::VectorXd holding_impulses(const FrictionResponse& response, const std::vector<char>& held);

/// What contacts do otherwise than before.
std::vector<SlipChange> changes_between(const std::vector<std::string>& names,
                                        const std::vector<Slip>& before,
                                        const std::vector<Slip>& after, double time);

/// Takes changes into a list of them, by time; what is in it already, but for `apart` [s], once.
void note_changes(std::vector<SlipChange>& changes, const std::vector<SlipChange>& found,
                  double apart);

/// A contact that can stick, and what it does at first.
struct FirstSlip {
  std::string joint;
  Slip slip = Slip::none;
};

/// From when until when a contact sticks [s].
struct StickingSpan {
  double from = 0.0;
  std::optional<double> until;  ///< nothing where it does at the end of the time looked at
};

/// How often and when a contact sticks.
struct StickingContact {
  std::string joint;
  std::vector<StickingSpan> spans;
};

/// The contacts that can stick, by what they do at the time `begin` and what changes then.
std::vector<StickingContact> sticking_contacts(const std::vector<FirstSlip>& first, double begin,
                                               const std::vector<SlipChange>& changes);

/// Those of laws that can stick, by name.
std::vector<FirstSlip> first_slips_of(const std::vector<Friction>& laws,
                                      const std::vector<std::string>& names,
                                      const std::vector<Slip>& slips);

/// "rail sticks 2 times: 0.21 s to 0.35 s, from 0.9 s on".
std::string to_text(const StickingContact& contact);

}  // namespace boxbeam
