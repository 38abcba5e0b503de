#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace boxbeam {

/// What a result is at a value, or why it is none.
struct Trial {
  std::optional<double> result;
  std::string trouble;  ///< "" where there is a result
};

/// A question: at which values of an interval is a result what is wanted?
struct RootQuestion {
  double from = 0.0, to = 0.0;  ///< from < to
  double wanted = 0.0;
  std::function<Trial(double)> at;
  int scan = 48;       ///< parts into which the interval is divided at first
  bool whole = false;  ///< the value can be a whole number only: each is looked at
};

/// A value at which the result is the wanted one.
struct Root {
  double value = 0.0;
  double result = 0.0;  ///< there
};

/// A place between two values, next to each other, where the result passes the wanted one by a
/// jump.
struct JumpOver {
  double value = 0.0;                 ///< in their middle
  double before = 0.0, behind = 0.0;  ///< the result on both sides
  double apart = 0.0;  ///< of the two, where whole numbers lie between which nothing is
};

struct Roots {
  std::vector<Root> roots;  ///< ascending
  std::vector<JumpOver> jumps;
  std::size_t trials = 0;
  std::size_t failed = 0;       ///< of them
  std::string first_trouble;    ///< of the first one that failed
  double failed_at = 0.0;       ///< its value
  std::optional<Root> nearest;  ///< of all trials, where there is no root
  bool changes = false;         ///< the result is not everywhere the same
};

/// Looks for all values. The interval is scanned in equal parts (in equal ratios where it spans
/// more than a factor of ten on one side of zero); where the result passes the wanted one between
/// two neighbours it is closed in on to the last digits (Alefeld, Potra, Shi, ACM TOMS 748, 1995),
/// and where it comes near among three without passing, its extremum is searched for, in case it
/// touches (Brent, 1973). Two values between neighbours of the scan are missed where the result
/// falls more between these than from either side towards them. Where one of two neighbours has no
/// result it is looked up to where results end, to a 4096th of the way, at no more than eight such
/// places. A value counts where the result is the wanted one to 1e-9 of it; what passes it
/// otherwise is a jump. Whole numbers are all looked at, of more than a thousand as many evenly.
Roots roots_of(const RootQuestion& question);

}  // namespace boxbeam
