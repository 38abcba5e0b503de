#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "boxbeam/fatigue/rainflow.hpp"

/// Cycle counting as the texts have it, slow and short, for comparison.
namespace plain {

using Numbers = std::vector<double>;

/// How often each pair of range and mean was counted.
using Tally = std::map<std::pair<double, double>, double>;

inline Tally tally(const std::vector<boxbeam::Cycle>& cycles) {
  Tally result;
  for (const boxbeam::Cycle& cycle : cycles) {
    result[{cycle.range.value(), cycle.mean.value()}] += cycle.count;
  }
  return result;
}

inline void add(std::vector<boxbeam::Cycle>& cycles, double a, double b, double count) {
  using boxbeam::si, boxbeam::Stress;
  cycles.push_back({si<Stress>(std::abs(a - b)), si<Stress>(0.5 * (a + b)), count});
}

/// First and last sample and every reversal between them; of equal neighbours one.
inline Numbers turning_points(std::span<const double> history) {
  Numbers turns;
  for (const double x : history) {
    const std::size_t n = turns.size();
    if (n > 0 && x == turns[n - 1]) continue;
    const bool passed = n > 1 && (turns[n - 1] > turns[n - 2]) == (x > turns[n - 1]);
    if (passed) turns.pop_back();
    turns.push_back(x);
  }
  if (turns.size() == 1) turns.clear();
  return turns;
}

/// ASTM E1049-85, 5.4.4, step by step: X the last range, Y the one before, S the start.
inline std::vector<boxbeam::Cycle> astm(std::span<const double> history) {
  std::vector<boxbeam::Cycle> cycles;
  Numbers points;
  for (const double turn : turning_points(history)) {
    points.push_back(turn);
    while (points.size() >= 3) {
      const std::size_t n = points.size();
      const double X = std::abs(points[n - 1] - points[n - 2]);
      const double Y = std::abs(points[n - 2] - points[n - 3]);
      if (X < Y) break;
      const bool holds_start = n == 3;
      add(cycles, points[n - 3], points[n - 2], holds_start ? 0.5 : 1.0);
      if (holds_start) {
        points.erase(points.begin());
      } else {
        points.erase(points.end() - 3, points.end() - 1);
      }
    }
  }
  for (std::size_t i = 1; i < points.size(); ++i) add(cycles, points[i - 1], points[i], 0.5);
  return cycles;
}

/// Four points (Amzallag et al. 1994): the full cycles, and what is left.
struct FourPoint {
  std::vector<boxbeam::Cycle> cycles;
  Numbers residue;
};

inline FourPoint four_point(std::span<const double> history) {
  FourPoint result;
  Numbers& points = result.residue;
  for (const double turn : turning_points(history)) {
    points.push_back(turn);
    while (points.size() >= 4) {
      const std::size_t n = points.size();
      const double inner = std::abs(points[n - 2] - points[n - 3]);
      if (inner > std::abs(points[n - 3] - points[n - 4])) break;
      if (inner > std::abs(points[n - 1] - points[n - 2])) break;
      add(result.cycles, points[n - 3], points[n - 2], 1.0);
      points.erase(points.end() - 3, points.end() - 1);
    }
  }
  return result;
}

}  // namespace plain
