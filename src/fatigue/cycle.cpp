#include "boxbeam/fatigue/cycle.hpp"

#include <algorithm>
#include <cstddef>

namespace boxbeam {
namespace {

Cycle cycle_between(Stress a, Stress b) { return {abs(a - b), 0.5 * (a + b), 1.0}; }

/// Drops points that are no turning points of the periodic sequence (equal neighbours, passages).
std::vector<Stress> true_turns(const std::vector<Stress>& points) {
  std::vector<Stress> distinct;
  for (const Stress& point : points) {
    if (distinct.empty() || point != distinct.back()) distinct.push_back(point);
  }
  while (distinct.size() > 1 && distinct.front() == distinct.back()) distinct.pop_back();
  const std::size_t n = distinct.size();
  std::vector<Stress> turns;
  for (std::size_t i = 0; i < n && n > 1; ++i) {
    const Stress before = distinct[(i + n - 1) % n];
    const Stress after = distinct[(i + 1) % n];
    if ((distinct[i] > before) == (distinct[i] > after)) turns.push_back(distinct[i]);
  }
  return turns;
}

}  // namespace

std::vector<Cycle> count_periodic_cycles(const std::vector<Stress>& turning_points) {
  std::vector<Stress> turns = true_turns(turning_points);
  std::vector<Cycle> cycles;
  if (turns.size() < 2) return cycles;
  std::rotate(turns.begin(), std::max_element(turns.begin(), turns.end()), turns.end());
  turns.push_back(turns.front());

  std::vector<Stress> stack;
  for (const Stress& turn : turns) {
    stack.push_back(turn);
    while (stack.size() >= 4) {
      const std::size_t n = stack.size();
      const Stress inner = abs(stack[n - 2] - stack[n - 3]);
      if (inner > abs(stack[n - 3] - stack[n - 4]) || inner > abs(stack[n - 1] - stack[n - 2]))
        break;
      cycles.push_back(cycle_between(stack[n - 3], stack[n - 2]));
      stack.erase(stack.end() - 3, stack.end() - 1);
    }
  }
  // What is left is highest, lowest, highest: the outermost cycle.
  cycles.push_back(cycle_between(stack[0], stack[1]));
  return cycles;
}

}  // namespace boxbeam
