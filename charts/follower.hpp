#pragma once

#include <string>
#include <utility>
#include <vector>

#include "charts/chart.hpp"
#include "charts/driven_scene.hpp"

namespace boxbeam::charts {

/// Instant after instant by the textbook solver, each started from the one before by a Taylor
/// series of order 0, 1 or 2.
template <class Scalar>
class Follower {
 public:
  struct Setting {
    double tolerance = 0.0;
    int order = 2;
    bool reactions = false;
  };

  Follower(const DrivenScene& scene, const std::vector<double>& times, LinearMethod method)
      : solver_(scene.mechanism, method),
        times_(times),
        first_(instant_of(scene.motion.states.front()).in<Scalar>()),
        instants_(times.size()) {}

  /// "" or why it did not go on.
  std::string run(const Setting& setting) {
    iterations_ = 0;
    for (std::size_t i = 0; i < times_.size(); ++i) {
      InstantIn<Scalar>& now = instants_[i];
      solver_.equations().set_time(times_[i]);
      if (i == 0) {
        now.q = first_.q;
      } else {
        const InstantIn<Scalar>& last = instants_[i - 1];
        const auto h = static_cast<Scalar>(times_[i] - times_[i - 1]);
        now.q = last.q;
        if (setting.order > 0) now.q += h * last.v;
        if (setting.order > 1) now.q += (h * h / Scalar(2)) * last.a;
      }
      const int iterations = solver_.solve_position(now.q, i == 0 ? 0.0 : setting.tolerance);
      if (iterations == 0) return "no convergence";
      if (i > 0) iterations_ += iterations;
      if (!solver_.solve_rates(now)) return "singular";
      if (setting.reactions) solver_.solve_multipliers(times_[i], now);
    }
    return "";
  }

  double iterations_per_instant() const {
    return static_cast<double>(iterations_) / static_cast<double>(times_.size() - 1);
  }
  /// Of the linear systems, per instant.
  double operations_per_instant(bool reactions = false) const {
    const double iterations = iterations_per_instant();
    return (iterations + 1.0) * solver_.factor_operations() +
           (iterations + (reactions ? 3.0 : 2.0)) * solver_.solve_operations();
  }
  std::vector<InstantIn<long double>> instants() const {
    std::vector<InstantIn<long double>> all;
    for (const InstantIn<Scalar>& instant : instants_) {
      all.push_back(instant.template in<long double>());
    }
    return all;
  }
  const std::vector<InstantIn<Scalar>>& own_instants() const { return instants_; }

 private:
  TextbookSolver<Scalar> solver_;
  std::vector<double> times_;
  InstantIn<Scalar> first_;
  std::vector<InstantIn<Scalar>> instants_;
  int iterations_ = 0;
};

/// The program's own way along the same instants.
class ProgramFollower {
 public:
  ProgramFollower(const DrivenScene& scene, const std::vector<double>& times)
      : solver_(scene.mechanism), times_(times), states_(times.size()) {
    states_.front() = scene.motion.states.front();
  }

  void run() {
    for (std::size_t i = 1; i < times_.size(); ++i) {
      solver_.solve_near(times_[i], states_[i - 1], states_[i]);
    }
  }

  const std::vector<planar::State>& states() const { return states_; }
  std::vector<InstantIn<long double>> instants() const {
    std::vector<InstantIn<long double>> all;
    for (const planar::State& state : states_) all.push_back(instant_of(state));
    return all;
  }
  const planar::InstantSolver& solver() const { return solver_; }

 private:
  planar::InstantSolver solver_;
  std::vector<double> times_;
  std::vector<planar::State> states_;
};

/// How many instants an experiment looks at: what the program itself chooses, within bounds.
inline std::size_t instants_of(const DrivenScene& scene) {
  return std::min<std::size_t>(scene.motion.states.size(), 384);
}

/// A time of a whole motion, by its instants.
inline Timing per_instant(const Timing& timing, std::size_t instants) {
  const auto count = static_cast<double>(instants);
  return {timing.median / count, timing.low / count, timing.high / count};
}

}  // namespace boxbeam::charts
