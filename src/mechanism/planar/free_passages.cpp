// Steps over singular positions, and states asked for within them.
#include <algorithm>
#include <cmath>
#include <utility>

#include "boxbeam/mechanism/planar/assembly.hpp"
#include "free_step.hpp"

namespace boxbeam::planar {
namespace {

// Pivots of the equations of motion by that of regular positions.

constexpr double near_singular = 2e-2;    ///< no step ends there
constexpr double beside_singular = 4e-3;  ///< where a step over a singular position may end

// Error of the step over a singular position, in scaled coordinates.

constexpr double error_of_passage = 1e-6;

}  // namespace

bool FreeSolver::is_near_singular(double pivot) const { return pivot < near_singular * regular_; }

std::optional<FreeSolver::Step> FreeSolver::step_over(const State& known, double dt) {
  constexpr double longer = 1.05;
  const double longest = 4.0 * natural_;
  std::optional<Step> best;
  for (dt *= longer; std::abs(dt) < longest; dt *= longer) {
    Step step = step_from(known, dt);
    if (!step.solved || step.end_pivot < beside_singular * regular_) continue;
    if (step.error * tolerance_ > std::max(tolerance_, error_of_passage)) continue;
    // What begins or ends to act there must be passed apart from it.
    if (first_change(known, step.end)) continue;
    if (!best || step.error < best->error) best = std::move(step);
  }
  return best;
}

const FreeSolver::Passage* FreeSolver::passage_of(const State& known) const {
  constexpr double same_motion = 1e-5;
  const Eigen::VectorXd& scale = equations_.constraints().col_scale();
  for (const Passage& passage : passages_) {
    const double way = passage.behind.time - passage.before.time;
    const double share = (known.time - passage.before.time) / way;
    if (share <= 0.0 || share >= 1.0) continue;
    const Eigen::VectorXd off = known.q - interpolate(known.time, passage.before, passage.behind).q;
    if (off.cwiseQuotient(scale).lpNorm<Eigen::Infinity>() < same_motion) return &passage;
  }
  return nullptr;
}

State FreeSolver::between(const Passage& passage, double time) {
  const auto reached = [&](const State& from, double until) -> std::optional<State> {
    Step step = step_from(from, until - from.time);
    if (!step.solved || step.end_pivot < beside_singular * regular_) return std::nullopt;
    if (step.error * tolerance_ > error_near_singular) return std::nullopt;
    return std::move(step.end);
  };
  State before = passage.before;
  State behind = passage.behind;
  const double way = behind.time - before.time;
  // Where it is regular enough, from the nearer end; else between two such places.
  const bool early = (time - before.time) / way < 0.5;
  if (auto state = reached(early ? before : behind, time)) return *state;
  for (double aside = way / 64.0; std::abs(aside) < std::abs(way); aside *= 2.0) {
    const bool from_before = (time - aside - before.time) / way > 0.0;
    const bool from_behind = (behind.time - time - aside) / way > 0.0;
    const auto left = from_before ? reached(before, time - aside) : before;
    const auto right = from_behind ? reached(behind, time + aside) : behind;
    if (!left || !right) continue;
    before = *left;
    behind = *right;
    break;
  }
  State state = interpolate(time, before, behind);
  const double share = (time - before.time) / (behind.time - before.time);
  state.lambda = (1.0 - share) * before.lambda + share * behind.lambda;
  state.touches = before.touches;
  state.friction = (1.0 - share) * before.friction + share * behind.friction;
  state.slips = before.slips;
  if (project_) {
    // The way back onto the constraints that needs no regular position.
    const Assembly closed = Assembler(*mechanism_).assemble(time, state.q);
    if (closed.closed) state.q = closed.q;
  }
  equations_.evaluate_at(time, state.q);
  state.residual = equations_.residual();
  return state;
}

}  // namespace boxbeam::planar
