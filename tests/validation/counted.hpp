#pragma once

#include <cmath>
#include <vector>

#include "boxbeam/fatigue/rainflow.hpp"

/// Published cycle counts against ours.
namespace published {

/// A cycle as tables print it.
struct Row {
  double range;
  double mean;
  double count;

  friend bool operator==(const Row&, const Row&) = default;
};
using Rows = std::vector<Row>;

inline Rows counted(const std::vector<double>& history, boxbeam::CountingRule rule) {
  Rows rows;
  for (const boxbeam::Cycle& cycle : boxbeam::count_cycles(history, rule)) {
    rows.push_back({cycle.range.value(), cycle.mean.value(), cycle.count});
  }
  return rows;
}

/// A full cycle between two stresses, "5-3".
inline Row full(double a, double b) { return {std::abs(a - b), 0.5 * (a + b), 1.0}; }

/// The ranges of a residue, each half a cycle.
inline Rows halves(const std::vector<double>& residue) {
  Rows rows;
  for (std::size_t i = 1; i < residue.size(); ++i) {
    rows.push_back(full(residue[i - 1], residue[i]));
    rows.back().count = 0.5;
  }
  return rows;
}

inline Rows joined(Rows rows, const Rows& more) {
  rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

}  // namespace published
