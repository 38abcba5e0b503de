#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "charts/toggle.hpp"
#include "charts/topics.hpp"

namespace boxbeam::charts {
namespace {

constexpr int directions = 5;  ///< of start errors, per cell

/// Where a trial stands: the mechanism at its distance, what is right there, and where it starts.
struct Trial {
  const planar::Mechanism& mechanism;
  const InstantIn<long double>& exact;
  double apart;  ///< half of what the two branches are apart, lengths by size
  Eigen::VectorXd start;
};

/// A fixed direction: each coordinate within -1 .. 1, the largest +1 or -1, by the fractional parts
/// of multiples of irrational numbers. Source: Weyl (1916).
Eigen::VectorXd direction_of(int index, Eigen::Index size) {
  Eigen::VectorXd direction(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double turns = (index + 1) * std::sqrt(2.0 + static_cast<double>(i * (i + 3)));
    direction[i] = 2.0 * (turns - std::floor(turns)) - 1.0;
  }
  return direction / direction.lpNorm<Eigen::Infinity>();
}

Cell judged(const Trial& trial, const Eigen::VectorXd& q) {
  Cell cell;
  const double size = size_of(trial.mechanism);
  const double off = planar::distance_between(q, trial.exact.q.cast<double>(), size);
  if (!(off < 0.3 * trial.apart)) {
    cell.outcome = Outcome::wrong;
    return cell;
  }
  InstantIn<double> there;
  there.q = q;
  TextbookSolver<double> solver(trial.mechanism, LinearMethod::dense);
  solver.equations().set_time(0.0);
  const bool found = solver.solve_rates(there);
  const double error =
      found ? static_cast<double>(
                  (there.v.cast<long double>() - trial.exact.v).lpNorm<Eigen::Infinity>() /
                  trial.exact.v.lpNorm<Eigen::Infinity>())
            : 1.0;
  cell.value = std::clamp(-std::log10(error), 0.0, 16.0);
  return cell;
}

Cell refused(const std::string& reason) {
  Cell cell;
  cell.outcome = Outcome::refused;
  cell.reason = reason;
  return cell;
}

Cell by_program(const Trial& trial) {
  try {
    planar::InstantSolver solver(trial.mechanism);
    return judged(trial, solver.solve_from_sketch(0.0, trial.start).q);
  } catch (const AnalysisError& error) {
    return refused(error.failure().what);
  }
}

Cell by_newton(const Trial& trial) {
  TextbookSolver<double> solver(trial.mechanism, LinearMethod::dense);
  solver.equations().set_time(0.0);
  Eigen::VectorXd q = trial.start;
  if (solver.solve_position(q, 1e-12) == 0) return refused("no convergence in 60 iterations");
  return judged(trial, q);
}

Cell by_least_squares(const Trial& trial) {
  const planar::Assembly assembly = planar::Assembler(trial.mechanism).assemble(0.0, trial.start);
  if (!assembly.closed) return refused("no assembly near");
  return judged(trial, assembly.q);
}

bool worse(const Cell& a, const Cell& b) {
  const auto rank = [](const Cell& cell) {
    return cell.outcome == Outcome::wrong ? 2 : cell.outcome == Outcome::refused ? 1 : 0;
  };
  if (rank(a) != rank(b)) return rank(a) > rank(b);
  return a.value && b.value && *a.value < *b.value;
}

std::vector<double> powers_of_ten(double first, double last, double step) {
  std::vector<double> all;
  const auto count = static_cast<int>(std::round((last - first) / step));
  for (int i = 0; i <= count; ++i) all.push_back(std::pow(10.0, first + i * step));
  return all;
}

}  // namespace

Map toggle_map_of(const ToggleScene& scene, const Effort& effort) {
  Map map;
  map.name = "stability-toggle";
  map.title = "Assembly near a toggle, from starts that are off";
  map.scene = scene.name;
  map.reference = fmt::format(
      "the named branch in long double; worst of {} directions of the start error", directions);
  map.x = {"distance of the driver to the toggle [m or rad]", true};
  map.y = {"error of the start, lengths by the mechanism's size [1 or rad]", true};
  map.value = "digits of the velocities that are right";
  const std::vector<std::pair<MapPanel, std::function<Cell(const Trial&)>>> methods{
      {{"boxbeam: assembly from a sketch", {}, false}, by_program},
      {{"Newton's method alone", {}, true}, by_newton},
      {{"damped least squares alone", {}, true}, by_least_squares}};
  for (const auto& [panel, method] : methods) map.panels.push_back(panel);
  const Eigen::VectorXd scale = planar::ConstraintEquations(scene.mechanism).col_scale();
  const double size = size_of(scene.mechanism);
  std::vector<ToggleScene::Place> places;
  for (const double share : powers_of_ten(-13.0, -1.0, effort.quick ? 1.5 : 0.5)) {
    std::optional<ToggleScene::Place> place = scene.place(share);
    if (place) places.push_back(std::move(*place));
  }
  for (const double error : powers_of_ten(-4.0, 0.5, effort.quick ? 0.75 : 0.25)) {
    for (const ToggleScene::Place& place : places) {
      const Eigen::VectorXd right = place.exact.q.cast<double>();
      const double apart = planar::distance_between(right, scene.toggle.q, size);
      for (std::size_t m = 0; m < methods.size(); ++m) {
        Cell cell;
        for (int k = 0; k < directions; ++k) {
          const Trial trial{place.mechanism, place.exact, apart,
                            right + error * scale.cwiseProduct(direction_of(k, scale.size()))};
          const Cell one = methods[m].second(trial);
          if (k == 0 || worse(one, cell)) cell = one;
        }
        cell.x = place.distance;
        cell.y = error;
        map.panels[m].cells.push_back(std::move(cell));
      }
    }
  }
  map.lesson = fmt::format(
      "Of {} cells boxbeam solves {} on the branch that was asked for, refuses {} and is silently "
      "wrong in {}; Newton's method alone is silently wrong in {}, damped least squares in {}. "
      "Name the branch of each loop in the case and look at the digits that are left near a "
      "toggle.",
      map.panels[0].cells.size(), map.panels[0].count(Outcome::solved),
      map.panels[0].count(Outcome::refused), map.panels[0].count(Outcome::wrong),
      map.panels[1].count(Outcome::wrong), map.panels[2].count(Outcome::wrong));
  return map;
}

Map toggle_map(const Scenes& scenes, const Effort& effort) {
  return toggle_map_of(toggle_scene_of(scenes), effort);
}

}  // namespace boxbeam::charts
