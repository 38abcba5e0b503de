#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "boxbeam/verification/any_motion_result.hpp"

namespace boxbeam {

/// What a motion has under one key at all of its instants, one instant after the other.
struct MotionColumn {
  /// Numbers in SI units; of a vector or matrix all of an instant together, by rows.
  struct Numbers {
    std::vector<std::size_t> shape;  ///< of one instant: {} a number, {3} a vector, {3, 3} a matrix
    std::vector<double> values;      ///< NaN where there is none
  };
  using Words = std::vector<std::string>;
  using Truths = std::vector<bool>;
  using Below = std::vector<MotionColumn>;  ///< of an object

  std::string name;
  std::size_t instants = 0;  ///< so far
  std::variant<Numbers, Words, Truths, Below> of;
};

/// The states of the motion document by columns, under its keys: those that all instants have.
/// Only one instant is there as a document at a time. None of links that vibrate.
std::vector<MotionColumn> motion_columns(const AnyMotionResult& motion);

}  // namespace boxbeam
