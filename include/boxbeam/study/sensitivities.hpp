#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/study/written_quantity.hpp"
#include "boxbeam/verification/check.hpp"

namespace boxbeam {

/// Below this a slope is none: the search for the governing place is as exact.
inline constexpr double least_slope = 1e-3;

/// Towards smaller or larger inputs.
struct SideSlope {
  double slope = 0.0;
  double error = 0.0;  ///< by how much it may be off; large where the result jumps

  /// Whether it says more than that.
  bool is_known() const { return error <= 0.3 * std::abs(slope) + 10.0 * least_slope; }
};

/// By how much of itself a result changes with an input that changes by some of itself: the slope
/// d(ln f)/d(ln x), 1 where it is in proportion, -3 where it falls with the third power.
struct Slope {
  std::optional<SideSlope> down, up;  ///< where it can be verified

  /// Of both where they agree; else the steeper one of those that are known.
  SideSlope of_both() const;
  double value() const { return of_both().slope; }
  /// Whether they do not: another place or clause governs on the two sides.
  bool kinks() const { return down && up && down->slope != up->slope; }
};

/// Results of a case by what they are called; nothing where it cannot be verified.
using ResultsAt = std::function<std::optional<std::map<Criterion, double>>(double factor)>;

/// Slopes of all results by the values of an input at 1, 1 -+ h and 1 -+ 2 h of itself, h = 0.5 %.
/// Where third and fourth differences of the five values are small they lie on a smooth curve: both
/// sides have its central slope, of fourth order (Richardson), and its error is what a kink
/// anywhere among the five may make. Else each side has its own, of second order, with an error by
/// the slope of half as far and by a further value an eighth of h away, which sees a jump or a kink
/// close by.
std::map<Criterion, Slope> slopes_of(const std::map<Criterion, double>& as_it_is,
                                     const ResultsAt& results_at);

/// An input of a case and what each criterion's governing factor makes of it.
struct Sensitivity {
  std::string key;
  WrittenQuantity value;
  std::map<Criterion, Slope> slopes;

  /// Whether every slope is known and next to nothing, on every side that can be verified.
  bool has_no_effect() const;
};

/// Of all inputs of a case that are numbers and not zero, the steepest of the governing criterion
/// first.
struct Sensitivities {
  std::vector<Criterion> criteria;        ///< that are judged, the most used first
  std::vector<Sensitivity> inputs;        ///< those that change something
  std::size_t without_effect = 0;         ///< the others
  std::vector<std::string> not_verified;  ///< keys of which neither side can be verified
};

}  // namespace boxbeam
