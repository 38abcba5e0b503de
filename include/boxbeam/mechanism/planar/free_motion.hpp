#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/mechanism/common/sticking.hpp"
#include "boxbeam/mechanism/planar/equations_of_motion.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"

namespace boxbeam::planar {

/// Integrates the freedoms that no driver moves, under the forces applied: the accelerations of the
/// equations of motion by a Runge-Kutta method of order 8 with a step chosen by its error (Fehlberg
/// 7(8), Boost.Odeint). After every step positions and velocities are projected back onto the
/// constraints, so that nothing drifts. Steps end where a stop, a cable or a pin in its clearance
/// begins or ends to act: whether it does is the same all through a step, and the time of a change
/// is found on steps that end there. While bodies press on each other by the law of an impact a
/// step must agree with its two halves, for the error of the method sees first and last stages
/// only. No step ends close to a singular position, where accelerations lose digits and another
/// branch begins: it is passed over in one step, the most accurate of many, whose error may be
/// 1e-6; states asked for within are interpolated. Contacts without a creep velocity stick or
/// slide: steps end where one that slides comes to rest and where one that sticks can bear no more,
/// and what they do then is decided (`decide_sticking`). Sources: Fehlberg, NASA TR R-287 (1968);
/// Eich, SIAM J. Numer. Anal. 30 (1993).
class FreeSolver {
 public:
  /// `tolerance`: error of a step in scaled coordinates and their rates. `project` false leaves the
  /// drift in, to show it.
  explicit FreeSolver(const Mechanism& mechanism, double tolerance = 1e-11, bool project = true);

  /// The state at a time from rough positions and velocities: both are moved onto the constraints.
  /// Throws AnalysisError where the mechanism cannot be assembled or its mass is singular.
  State start(double time, const Eigen::VectorXd& q, const Eigen::VectorXd& v);

  /// The state at a later (or earlier) time; with contacts that can stick at a later one. Throws
  /// AnalysisError where the step falls below what arithmetic can tell apart, and where it cannot
  /// be decided whether contacts stick.
  State advance(double time, const State& known);

  /// When what acts one way has begun or ended to so far, in the order of the looks at it.
  const std::vector<double>& changes() const { return changes_; }

  /// Where contacts began to stick or to slide on the ways so far, by time.
  const std::vector<SlipChange>& slip_changes() const { return slip_changes_; }

  /// Steps taken and equations solved so far.
  int steps() const { return steps_; }
  int evaluations() const { return equations_.evaluations(); }

 private:
  struct Step;
  struct Way;
  /// A step over a singular position that somebody wanted to know within.
  struct Passage {
    State before, behind;
  };

  /// Of its time, position and velocities, with what is known of its touches and slips.
  State state_of(const State& known);
  Step step_from(const State& known, double dt);
  /// How far the next step on a way is to go, no further than anything bends or jumps.
  void choose_step(Way& way, const State& state);
  /// The same after one that is refused: shorter, or from the beginning of the way otherwise.
  void shorten_step(Way& way, State& state, const Step& step, double bound, bool lost) const;
  /// Whether a pivot is that of a position close to a singular one.
  bool is_near_singular(double pivot) const;
  /// Of the steps further than one that ends close to a singular position, over it, the most
  /// accurate; nothing where none is accurate enough.
  std::optional<Step> step_over(const State& known, double dt);
  /// The passage that a state lies within; nullptr where there is none.
  const Passage* passage_of(const State& known) const;
  State between(const Passage& passage, double time);
  /// Whether contacts go on as the state's slips say.
  bool contacts_go_on(const State& state) const;
  /// How far into a step one of them does not, though all do at its end; 0: nowhere [s].
  double contact_changes_within(const State& known, const Step& step);
  /// Decides how contacts go on from a state.
  void decide_contacts(State& state);
  /// The same where they do not go on, which it notes; and takes what contacts slide that stick.
  void settle_contacts(State& state);

  /// Whether bodies press on each other by the law of an impact.
  bool in_impact(const State& state) const;
  /// How far from its end its two halves end, in tolerances.
  double beside_halves(const State& known, const Step& step);
  /// Counts that as the error of a step in an impact, unless much longer ones agreed.
  void compare_with_halves(const State& known, double bound, Step& step);
  /// The step, or as much of it as ends in front of a bend of friction, which its error does not
  /// show, and of where a contact begins to stick or to slide.
  Step before_bend(const State& known, Step step, double smallest);
  /// Ends a step where what acts one way begins or ends to act, and changes that there. False where
  /// no step leads there, which is to be tried again at half its length.
  bool stop_at_change(Way& way, const State& state, Step& step);
  /// What acts one way and has got to the other side of its length in a state.
  bool has_changed(const OneSided& of, const State& state) const;
  bool has_changed(const State& state) const;
  /// The mass that a force between its ends meets [kg].
  double mass_between(const OneSided& of, const State& state);
  /// Lets what has changed act, or no longer, and solves the rates anew.
  void change(State& state);
  /// The first change between two states of a step.
  struct Change {
    std::size_t of = 0;              ///< among what acts one way
    double from = 0.0, until = 0.0;  ///< times between which it is
  };
  std::optional<Change> first_change(const State& from, const State& end) const;
  /// The step that ends with a change.
  Step step_to(const Change& change, const State& from);

  const Mechanism* mechanism_;
  double tolerance_;
  bool project_;
  std::vector<OneSided> one_sided_;
  double touching_ = 0.0;  ///< a way that counts [m]
  std::vector<double> changes_;
  EquationsOfMotion equations_;
  double regular_ = 0.0;  ///< the largest of the smallest pivots so far
  double natural_ = 0.0;  ///< the longest step that an error allowed, whatever was looked at [s]
  std::vector<Passage> passages_;
  /// The longest step that would agree with its halves, by the last one that did [s], and what
  /// touched then.
  double agreed_ = 0.0;
  std::vector<Touch> agreed_touches_;
  int steps_ = 0;
  bool sticking_ = false;  ///< whether any contact can
  std::vector<Friction> laws_;
  std::vector<std::string> names_;
  double rest_ = 0.0;  ///< sliding velocity that is none, for the tolerance [m/s]
  std::vector<SlipChange> slip_changes_;
};

}  // namespace boxbeam::planar
