#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/common/sticking.hpp"
#include "boxbeam/mechanism/spatial/forced_equations.hpp"

namespace boxbeam::spatial {

/// The coordinates that forces move, from their start at t = 0 on, as `ForcedEquations` say.
/// Integrated by a Runge-Kutta method of order 8 with a step chosen by its error (Fehlberg 7(8),
/// Boost.Odeint), which sees its first and last stages only: each step must agree with its two
/// halves. Steps end where drivers or loads bend or jump, where a stop or a cable begins or ends to
/// act, and where a contact without a creep velocity begins to stick or to slide
/// (`decide_sticking`). Between, by Hermite's polynomial from positions, rates and accelerations at
/// two times (degree 5) or also halfway (degree 8), so near each other that it differs from a step
/// by no more than a hundred times its tolerance: where it does most, what it leaves of the
/// accelerations says by how much. Source: Fehlberg, NASA TR R-287 (1968); Enright, J. Comput.
/// Appl. Math. 27 (1989), of what polynomials leave.
class ForcedMotion {
 public:
  /// Over the time that is looked at. `loops`: assembled at t = 0, or nothing; keeps it.
  /// `tolerance`: error of a step in coordinates and their rates, [rad] and the mechanism's size.
  /// Throws AnalysisError where accelerations are not determined, friction locks, loops cannot be
  /// followed, or steps fall below what arithmetic can tell apart.
  ForcedMotion(const Tree& tree, const Loops* loops, double tolerance = 1e-11);

  /// Sets the coordinates that forces move, with their rates, at a state's time; no accelerations.
  /// Throws AnalysisError as the constructor.
  void set(const Tree& tree, State& state) const;

  /// Of a state with all positions and rates, and the accelerations without those that forces give
  /// (`Loops::close`, `Tree::move`): these, of all bodies, and what rubs.
  void accelerate(const Tree& tree, State& state, const Loops::Sample& closed) const;

  std::size_t freedoms() const { return equations_.freedoms(); }

  /// When a stop or a cable begins or ends to act, or a contact to stick, ascending, over the time
  /// that is looked at and what goes before it.
  const std::vector<double>& changes() const { return changes_; }
  /// What contacts that can stick do at t = 0, and where they change.
  std::vector<FirstSlip> first_slips() const {
    return first_slips_of(equations_.laws(), equations_.names(), samples_.front().slips);
  }
  const std::vector<SlipChange>& slip_changes() const { return slip_changes_; }

 private:
  /// Where it has come to; y: coordinates and rates without units.
  struct Sample {
    double time = 0.0;
    std::vector<double> y;
    std::vector<double> accelerations = {};  ///< without units
    /// Of each coordinate what is added to the polynomial of degree 5 from the sample before
    /// (`course`), three numbers; empty: nothing.
    std::vector<double> added = {};
    Loops::Sample loops = {};
    std::vector<Touch> touches = {};  ///< of every spring, of that from here on
    std::vector<Slip> slips = {};     ///< of contacts that can stick, from there on
  };
  struct Step {
    Sample end;
    bool followed = true;  ///< the loops, and accelerations are determined
    std::optional<ForcedEquations::Unsolved> unsolved = {};  ///< why they are not
    double error = 0.0;                                      ///< in tolerances
    bool changes = false;  ///< others act at its end than at its beginning, or contacts change
    std::optional<Sample> before = {};  ///< just before those do, where a force jumps
    double change = 1.0;  ///< of the step, where a stage first has others acting than its beginning
  };

  /// What has been spent on following, in bodies moved, and the steps.
  struct Effort {
    double bodies = 0.0;
    int steps = 0;
  };

  /// What contacts do at a time.
  const std::vector<Slip>& slips_at(double time) const;
  /// A coordinate between two positions, with its rate and acceleration, without units.
  DriverState course(const Sample& from, const Sample& to, std::size_t k, double time) const;
  std::vector<double> between(const Sample& from, const Sample& to, double time) const;
  /// What is added so that the polynomial between two meets a position halfway.
  std::vector<double> added_to_meet(const Sample& middle, const Sample& from,
                                    const Sample& to) const;
  /// Whether the polynomial between two is near the motion, by the accelerations there.
  bool follows(const Tree& tree, const Sample& from, const Sample& to) const;
  /// Whether an error of a coordinate, and what it makes of its rate, are next to nothing.
  bool is_near(double off, double to_rate, double value, double rate) const;
  void know_accelerations(const Tree& tree, Sample& at) const;
  /// Adds positions between two until those between are known by polynomials.
  void refine(const Tree& tree, const Sample& from, Sample& to, int depth, Effort& effort,
              std::vector<Sample>& kept) const;

  /// Decides how contacts go on from a sample, where they do not go on, or nothing is known of them
  /// yet; those that stick slide no more. What changes is added to `found`.
  void settle_contacts(const Tree& tree, Sample& at, std::vector<SlipChange>* found) const;

  // forced_steps.cpp
  Sample advanced(const Tree& tree, Sample from, double until, Effort& effort,
                  std::vector<Sample>* kept = nullptr, std::vector<double>* changes = nullptr,
                  std::vector<SlipChange>* slip_changes = nullptr) const;
  Step step_from(const Tree& tree, const Sample& from, double dt, Effort& effort) const;
  /// A step of no more than `dt` that is good, or nothing, with a shorter `dt`.
  std::optional<Step> good_step(const Tree& tree, Sample& from, double smallest, Effort& effort,
                                double& dt) const;
  /// Which of the springs that only pull or only push do so.
  static std::vector<char> acting_in(const Mechanism& mechanism, const State& state);
  /// How long it takes at least until another one acts, by its tension and the rate of that, and a
  /// twentieth more.
  double until_another_acts(const Tree& tree, const Sample& from) const;
  /// How far into a step another one acts, by the polynomial between its ends; 0: none does.
  double acts_within(const Tree& tree, Sample& from, Sample& end) const;
  /// Whether a contact that slides has turned round, by positions between two.
  bool any_turns_back(const Mechanism& mechanism, const State& state,
                      const std::vector<Slip>& slips) const;
  /// The step of no more than `dt` that ends where another one begins or ends to act; nothing where
  /// a shorter one must tell.
  std::optional<Step> step_to_change(const Tree& tree, const Sample& from, Step step,
                                     Effort& effort, double& dt) const;
  /// Of springs that begin to act at the end of a step, what their impacts lose.
  void touch(const Tree& tree, const Sample& from, Sample& end) const;
  /// Whether a step ends where both its halves do.
  bool agrees_with_halves(const Tree& tree, const Sample& from, const Step& step, double dt,
                          Effort& effort) const;

  ForcedEquations equations_;
  const Loops* loops_;
  double tolerance_;
  bool one_sided_ = false;     ///< whether any spring only pulls or only pushes
  std::vector<double> stops_;  ///< times at which steps end
  std::vector<Sample> samples_;
  std::vector<double> changes_;
  std::vector<SlipChange> slip_changes_;
  double gap_ = 0.0;  ///< from one side of a break to the other, and twice that [s]
};

}  // namespace boxbeam::spatial
