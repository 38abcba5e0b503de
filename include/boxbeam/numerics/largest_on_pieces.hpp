#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace boxbeam {

/// Values of several functions at one place. One that is not there has the value 0; later places
/// may have more functions than earlier ones.
using FunctionValues = std::vector<double>;

/// What is searched: pieces of a line between whose ends functions are smooth or have kinks, while
/// they may jump at the ends. At the ends of a piece `at` gives the limits from inside.
struct PieceSearch {
  /// Of each piece, ascending: its ends, and the borders of parts that are looked at apart.
  std::vector<std::vector<double>> pieces;
  std::function<FunctionValues(std::size_t piece, double at)> at;
  /// The group of a function; the largest of each group is searched.
  std::function<std::size_t(std::size_t function)> group_of;
  double tolerance = 1e-4;    ///< relative to the largest of the group
  std::vector<double> known;  ///< by group: values there are elsewhere, below which none matters
  std::size_t most_evaluations = 100000;
};

/// A place that was looked at.
struct SearchedPlace {
  double at = 0.0;
  FunctionValues values;
};

struct PieceSearchResult {
  std::vector<std::vector<SearchedPlace>> pieces;  ///< all places looked at, ascending
  std::vector<double> largest;                     ///< by group
  std::size_t evaluations = 0;
  /// By group: how much more than the largest found it may have, relative; at most the tolerance,
  /// unless the evaluations or the digits of a place came to their end.
  std::vector<double> left_open;
};

/// The largest value of each group of functions, on all pieces.
///
/// Every part is looked at in five places at equal distances. What a function may have between them
/// is bounded by
///
///     the top of the parabolas through neighbouring places + 3 e
///
/// e the largest difference between the function in the second and the fourth place and the
/// parabola through the other three. Of a smooth function the error of the narrow parabolas is
/// about an eighth of e; a roof (two slopes of any steepness that meet in a ridge, wherever between
/// the places) stays below the bound, which 2 e would not give; a jump inside a part is of the size
/// of e. The part with the largest bound over the
/// largest value found is halved until no bound of any group exceeds it by more than the tolerance.
/// Not seen is what is narrower than a quarter of a part and vanishes at all five places: the parts
/// given must be short enough for what can vary in them.
PieceSearchResult largest_on_pieces(const PieceSearch& search);

}  // namespace boxbeam
