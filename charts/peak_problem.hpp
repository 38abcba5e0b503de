#pragma once

#include <functional>
#include <memory>
#include <string>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/verification/load_history.hpp"

namespace boxbeam::charts {

/// A quantity over a time that is looked at, whose largest value is sought.
struct PeakProblem {
  std::string name;
  LoadSpan span;    ///< with as many instants as the program solves
  LoadsAt loads;    ///< one solve
  Station station;  ///< whose cut forces are looked at
  CutForceFunction quantity;
  double peak = 0.0;       ///< the true largest value
  double peak_time = 0.0;  ///< [s]

  double period() const { return span.period.value(); }
  double at(double time) const {
    return quantity(cut_forces_of(loads(si<Time>(time))).at(station));
  }
};

/// A bar that is pulled by f(t), which repeats after a period: |f| is the quantity.
PeakProblem pulled_bar(std::string name, double period, std::size_t instants,
                       std::function<double(double)> f, double peak, double peak_time);

/// A largest value that was found, and how many solves that took.
struct FoundPeak {
  double value = 0.0;
  double solves = 0.0;
};

/// How a peak is looked for: with so many instants, which begin at a phase (part of a step).
using PeakSearch = std::function<FoundPeak(const PeakProblem&, std::size_t instants, double phase)>;

FoundPeak peak_of_samples(const PeakProblem& problem, std::size_t instants, double phase);

/// A parabola through the highest instant and its neighbours.
FoundPeak peak_by_parabola(const PeakProblem& problem, std::size_t instants, double phase);

/// Brent's method about the highest instant, every value a solve.
FoundPeak peak_by_solves(const PeakProblem& problem, std::size_t instants, double phase);

/// As the verification does it.
FoundPeak peak_by_history(const PeakProblem& problem, std::size_t instants, double phase);

/// The worst of several phases: the peak lies anywhere between the instants. An open time has one.
FoundPeak worst_of_phases(const PeakProblem& problem, const PeakSearch& search,
                          std::size_t instants, int phases);

/// |value - peak|/|peak|, not below half a last digit.
double error_of(const PeakProblem& problem, const FoundPeak& found);

}  // namespace boxbeam::charts
