#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/study/written_quantity.hpp"
#include "boxbeam/verification/check.hpp"

namespace boxbeam {

/// By how much of itself a result changes with an input that changes by some of itself: the slope
/// d(ln f)/d(ln x), 1 where it is in proportion, -3 where it falls with the third power.
struct Slope {
  std::optional<double> down, up;  ///< towards smaller and larger inputs; where it can be verified
  double error = 0.0;              ///< of them, by two steps

  /// Of both where they agree; else the steeper one.
  double value() const;
  /// Whether they do not: another place or clause governs on the two sides.
  bool kinks() const;
};

/// Results of a case by what they are called; nothing where it cannot be verified.
using ResultsAt = std::function<std::optional<std::map<Criterion, double>>(double factor)>;

/// Slopes of all results by the values of an input at 1, 1 -+ h and 1 -+ 2 h of itself, h = 0.5 %:
/// differences of second order on each side, and where both sides agree the central one of fourth
/// order (Richardson). Errors are how far the values with h and with 2 h are apart.
std::map<Criterion, Slope> slopes_of(const std::map<Criterion, double>& as_it_is,
                                     const ResultsAt& results_at);

/// An input of a case and what each criterion's governing factor makes of it.
struct Sensitivity {
  std::string key;
  WrittenQuantity value;
  std::map<Criterion, Slope> slopes;

  /// The steepest of all slopes, without sign.
  double steepest() const;
};

/// Of all inputs of a case that are numbers and not zero, the steepest of the governing criterion
/// first.
struct Sensitivities {
  std::vector<Criterion> criteria;        ///< that are judged, the most used first
  std::vector<Sensitivity> inputs;        ///< those that change something
  std::size_t without_effect = 0;         ///< the others
  std::vector<std::string> not_verified;  ///< keys of which neither side can be verified
};

/// Below this a slope is none: the search for the governing place is as exact.
inline constexpr double least_slope = 1e-3;

}  // namespace boxbeam
