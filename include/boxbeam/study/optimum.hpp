#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace boxbeam {

/// A variable that may be chosen: between two bounds, or one of a list.
struct Choice {
  std::string name;
  double from = 0.0, to = 0.0;
  std::vector<double> values;  ///< instead of the bounds, ascending
};

/// What a design is worth.
struct Worth {
  double goal = 0.0;  ///< the less the better
  std::vector<double>
      margins;          ///< of the limits in their order; it keeps them where none is below zero
  std::string trouble;  ///< why it cannot be judged; the rest counts for nothing then
};

/// Which design has the least of a goal and keeps all limits.
struct OptimumQuestion {
  using Function = std::function<Worth(const std::vector<double>&)>;

  std::vector<Choice> choices;
  std::vector<std::string> limits;  ///< names of the margins
  std::function<Function()> make;   ///< the function, once for each thread
  std::size_t threads = 1;
  std::size_t starts = 8;      ///< of searches, the first in the middle
  std::size_t designs = 2000;  ///< at most, of lists; where they have more not all are looked at
  std::uint64_t seed = 1;
};

/// What keeps the goal from being less.
struct ActiveLimit {
  std::string name;  ///< of a limit, or of a choice at a bound
  enum class Kind { limit, lower_bound, upper_bound } kind = Kind::limit;
  /// By how much the goal falls for one unit that the margin is allowed below zero, or the bound
  /// moved outwards; nothing of limits that only a step along a list would break.
  std::optional<double> price;
};

/// A design and what it is worth.
struct ChosenDesign {
  std::vector<double> values;  ///< of the choices
  double goal = 0.0;
  std::vector<double> margins;
};

struct Optimum {
  std::optional<ChosenDesign> best;  ///< nothing where no design was found that keeps all limits
  /// All designs were looked at; or the slopes of goal and active limits balance, and of lists no
  /// neighbour is better.
  bool confirmed = false;
  bool exhaustive = false;  ///< every combination of the lists was looked at
  std::string reason;       ///< why there is none, or why it is not confirmed
  std::vector<ActiveLimit> active;
  std::optional<double>
      imbalance;  ///< of the slopes, part of the goal's; where a choice has bounds
  std::size_t starts = 0,
              agreeing = 0;  ///< searches, and those that ended at the same goal to 1e-4
  std::size_t evaluations = 0, troubled = 0;
  std::string first_trouble;
};

/// The least goal. Choices with bounds: by NLopt from several starts, COBYLA and then the method of
/// moving asymptotes with differences for derivatives, and what they say is checked: the design
/// must keep its limits, and the conditions of Karush, Kuhn and Tucker must hold. Lists: all
/// combinations or, where there are too many, descent to a design that has no better neighbour (a
/// step in one list, or one up and one down in two) from several starts; choices with bounds are
/// then optimal for each. Sources: Powell (1994), COBYLA; Svanberg (2002), MMA; Johnson, NLopt.
Optimum optimum_of(const OptimumQuestion& question);

}  // namespace boxbeam
