#include "charts/digits_left.hpp"

#include <algorithm>
#include <cmath>

namespace boxbeam::charts {

double relative_error(double found, long double exact) {
  const long double off = std::abs(static_cast<long double>(found) - exact);
  return static_cast<double>(exact == 0.0L ? off : off / std::abs(exact));
}

Cell digits_cell(double x, double y, double error) {
  Cell cell;
  cell.x = x;
  cell.y = y;
  cell.outcome = error <= 1e-3 ? Outcome::solved : Outcome::wrong;
  if (cell.outcome == Outcome::solved) {
    cell.value = error > 0.0 ? std::min(most_digits, -std::log10(error)) : most_digits;
  }
  return cell;
}

}  // namespace boxbeam::charts
