#include "local_optimum.hpp"

#include <nlopt.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace boxbeam {

void Tally::add(const Tally& other) {
  if (troubled == 0) first_trouble = other.first_trouble;
  evaluations += other.evaluations;
  troubled += other.troubled;
}

Worth worth_at(const OptimumQuestion::Function& function, const std::vector<double>& values,
               Tally& tally) {
  Worth worth = function(values);
  ++tally.evaluations;
  const auto is_number = [](double number) { return std::isfinite(number); };
  if (worth.trouble.empty() &&
      !(is_number(worth.goal) &&
        std::all_of(worth.margins.begin(), worth.margins.end(), is_number)))
    worth.trouble = "the goal or a limit is no number";
  if (!worth.trouble.empty() && tally.troubled++ == 0) tally.first_trouble = worth.trouble;
  return worth;
}

double violation_of(const Worth& worth) {
  if (!worth.trouble.empty()) return std::numeric_limits<double>::infinity();
  double beyond = 0.0;
  for (const double margin : worth.margins) beyond += std::max(0.0, -margin);
  return beyond;
}

bool keeps_limits(const Worth& worth) { return violation_of(worth) == 0.0; }

Eigen::VectorXd nearest_by_nonnegative(const Eigen::MatrixXd& columns, const Eigen::VectorXd& to) {
  const Eigen::Index count = columns.cols();
  Eigen::VectorXd found = Eigen::VectorXd::Zero(count);
  std::vector<Eigen::Index> used;
  const auto solved = [&] {
    Eigen::MatrixXd of_used(columns.rows(), static_cast<Eigen::Index>(used.size()));
    for (std::size_t i = 0; i < used.size(); ++i)
      of_used.col(static_cast<Eigen::Index>(i)) = columns.col(used[i]);
    return Eigen::VectorXd(of_used.colPivHouseholderQr().solve(to));
  };
  for (Eigen::Index step = 0; step < 3 * count; ++step) {
    Eigen::VectorXd gain = columns.transpose() * (to - columns * found);
    for (const Eigen::Index i : used) gain[i] = 0.0;
    Eigen::Index best = 0;
    constexpr double nothing = 1e-12;
    if (count == 0 || gain.maxCoeff(&best) <= nothing * to.norm() * columns.norm()) break;
    used.push_back(best);
    for (Eigen::VectorXd wanted = solved(); !used.empty(); wanted = solved()) {
      double part = 1.0;
      for (std::size_t i = 0; i < used.size(); ++i) {
        const double now = found[used[i]], then = wanted[static_cast<Eigen::Index>(i)];
        if (then <= 0.0) part = std::min(part, now > 0.0 ? now / (now - then) : 0.0);
      }
      for (std::size_t i = 0; i < used.size(); ++i)
        found[used[i]] += part * (wanted[static_cast<Eigen::Index>(i)] - found[used[i]]);
      if (part == 1.0) break;
      std::erase_if(used, [&](Eigen::Index i) {
        if (found[i] > nothing * found.maxCoeff()) return false;
        found[i] = 0.0;
        return true;
      });
    }
  }
  return found;
}

namespace {

/// Limits are kept with so much to spare, because the last digits of two evaluations may differ.
constexpr double spare = 1e-10;
constexpr double step = 1e-5;  ///< of differences, of the distance between the bounds

/// Goal and margins where all bounds are 0 and 1.
class Scaled {
 public:
  Scaled(const OptimumQuestion& question, const OptimumQuestion::Function& function,
         const std::vector<double>& start, Tally& tally)
      : question_(&question), function_(&function), values_(start), tally_(&tally) {
    for (std::size_t i = 0; i < question.choices.size(); ++i)
      if (question.choices[i].values.empty()) free_.push_back(i);
    const Worth first = worth_at(function, start, tally);
    if (first.trouble.empty() && first.goal != 0.0) goal_unit_ = std::abs(first.goal);
    best_ = first;
    best_values_ = start;
  }

  std::size_t size() const { return free_.size(); }
  std::size_t limits() const { return question_->limits.size(); }
  double goal_unit() const { return goal_unit_; }
  const Choice& choice(std::size_t i) const { return question_->choices[free_[i]]; }

  std::vector<double> scaled(const std::vector<double>& values) const {
    std::vector<double> z;
    for (const std::size_t i : free_) {
      const Choice& of = question_->choices[i];
      z.push_back(std::clamp((values[i] - of.from) / (of.to - of.from), 0.0, 1.0));
    }
    return z;
  }

  /// Goal, then margins less the spare. The best design so far is kept.
  const Eigen::VectorXd& at(const std::vector<double>& z) {
    if (z == at_) return numbers_;
    at_ = z;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const Choice& of = choice(i);
      values_[free_[i]] = z[i] == 0.0   ? of.from
                          : z[i] == 1.0 ? of.to
                                        : of.from + z[i] * (of.to - of.from);
    }
    const Worth worth = worth_at(*function_, values_, *tally_);
    numbers_.resize(static_cast<Eigen::Index>(1 + limits()));
    // A design that cannot be judged is as bad as one far beyond its limits.
    constexpr double far = -10.0;
    numbers_.setConstant(far);
    numbers_[0] = -far;
    if (worth.trouble.empty()) {
      numbers_[0] = worth.goal / goal_unit_;
      for (std::size_t j = 0; j < limits(); ++j)
        numbers_[static_cast<Eigen::Index>(1 + j)] = worth.margins[j] - spare;
    }
    const double beyond = violation_of(worth), before = violation_of(best_);
    if (beyond < before || (beyond == before && worth.goal < best_.goal)) {
      best_ = worth;
      best_values_ = values_;
    }
    return numbers_;
  }

  /// Derivatives of the same, a column for each variable: central differences, at a bound those of
  /// a parabola inside.
  const Eigen::MatrixXd& slopes(const std::vector<double>& z) {
    if (z == slopes_at_) return slopes_;
    const Eigen::VectorXd here = at(z);
    slopes_.resize(here.size(), static_cast<Eigen::Index>(size()));
    for (std::size_t i = 0; i < size(); ++i) {
      const auto beside = [&](double by) {
        std::vector<double> other = z;
        other[i] += by;
        return Eigen::VectorXd(at(other));
      };
      auto column = slopes_.col(static_cast<Eigen::Index>(i));
      const double inwards = z[i] < step ? step : -step;
      if (z[i] < step || z[i] > 1.0 - step)
        column = (4.0 * beside(inwards) - beside(2.0 * inwards) - 3.0 * here) / (2.0 * inwards);
      else
        column = (beside(step) - beside(-step)) / (2.0 * step);
    }
    slopes_at_ = z;
    return slopes_;
  }

  const Worth& best() const { return best_; }
  const std::vector<double>& best_values() const { return best_values_; }

 private:
  const OptimumQuestion* question_;
  const OptimumQuestion::Function* function_;
  std::vector<std::size_t> free_;  ///< choices with bounds, by index
  std::vector<double> values_;
  Tally* tally_;
  double goal_unit_ = 1.0;
  std::vector<double> at_, slopes_at_;
  Eigen::VectorXd numbers_;
  Eigen::MatrixXd slopes_;
  Worth best_;
  std::vector<double> best_values_;
};

double goal_of(unsigned n, const double* x, double* gradient, void* data) {
  auto& scaled = *static_cast<Scaled*>(data);
  const std::vector<double> z(x, x + n);
  if (gradient != nullptr) {
    const Eigen::MatrixXd& slopes = scaled.slopes(z);
    for (unsigned i = 0; i < n; ++i) gradient[i] = slopes(0, i);
  }
  return scaled.at(z)[0];
}

/// NLopt wants them at most zero.
void margins_of(unsigned m, double* result, unsigned n, const double* x, double* gradient,
                void* data) {
  auto& scaled = *static_cast<Scaled*>(data);
  const std::vector<double> z(x, x + n);
  if (gradient != nullptr) {
    const Eigen::MatrixXd& slopes = scaled.slopes(z);
    for (unsigned j = 0; j < m; ++j)
      for (unsigned i = 0; i < n; ++i) gradient[j * n + i] = -slopes(1 + j, i);
  }
  const Eigen::VectorXd& numbers = scaled.at(z);
  for (unsigned j = 0; j < m; ++j) result[j] = -numbers[1 + j];
}

void search(Scaled& scaled, nlopt_algorithm algorithm, double close, int most) {
  const auto n = static_cast<unsigned>(scaled.size());
  const std::unique_ptr<nlopt_opt_s, decltype(&nlopt_destroy)> with(nlopt_create(algorithm, n),
                                                                    nlopt_destroy);
  nlopt_set_lower_bounds1(with.get(), 0.0);
  nlopt_set_upper_bounds1(with.get(), 1.0);
  nlopt_set_min_objective(with.get(), goal_of, &scaled);
  const std::vector<double> tolerances(scaled.limits(), 0.0);
  if (scaled.limits() > 0)
    nlopt_add_inequality_mconstraint(with.get(), static_cast<unsigned>(scaled.limits()), margins_of,
                                     &scaled, tolerances.data());
  nlopt_set_xtol_abs1(with.get(), close);
  nlopt_set_maxeval(with.get(), most);
  constexpr double first = 0.1;
  nlopt_set_initial_step1(with.get(), first);
  std::vector<double> z = scaled.scaled(scaled.best_values());
  double goal = 0.0;
  // How it ends is of no account: the best design that was met is taken, and checked.
  nlopt_optimize(with.get(), z.data(), &goal);
}

/// What holds the best design, and how far the slopes are out of balance:
///     grad goal = sum price_j grad margin_j, bounds among them, no price below zero.
void balance(Scaled& scaled, const OptimumQuestion& question, LocalOptimum& optimum) {
  constexpr double near_limit = 1e-6, near_bound = 1e-9;
  const std::vector<double> z = scaled.scaled(optimum.values);
  const Eigen::VectorXd numbers = scaled.at(z);
  const Eigen::MatrixXd slopes = scaled.slopes(z);
  const auto n = static_cast<Eigen::Index>(scaled.size());
  std::vector<Eigen::VectorXd> columns;
  std::vector<double> units;
  for (std::size_t j = 0; j < question.limits.size(); ++j) {
    const auto row = static_cast<Eigen::Index>(1 + j);
    if (numbers[row] > near_limit) continue;
    optimum.active.push_back({question.limits[j], ActiveLimit::Kind::limit, 0.0});
    columns.emplace_back(slopes.row(row).transpose());
    units.push_back(1.0);
  }
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    const bool lower = z[i] < near_bound;
    if (!lower && z[i] < 1.0 - near_bound) continue;
    const Choice& of = scaled.choice(i);
    optimum.active.push_back(
        {of.name, lower ? ActiveLimit::Kind::lower_bound : ActiveLimit::Kind::upper_bound, 0.0});
    columns.emplace_back((lower ? 1.0 : -1.0) *
                         Eigen::VectorXd::Unit(n, static_cast<Eigen::Index>(i)));
    units.push_back(of.to - of.from);
  }
  Eigen::MatrixXd all(n, static_cast<Eigen::Index>(columns.size()));
  for (std::size_t k = 0; k < columns.size(); ++k)
    all.col(static_cast<Eigen::Index>(k)) = columns[k];
  const Eigen::VectorXd goal = slopes.row(0).transpose();
  const Eigen::VectorXd prices = nearest_by_nonnegative(all, goal);
  const double size = goal.norm();
  optimum.imbalance = size > 0.0 ? (goal - all * prices).norm() / size : 0.0;
  for (std::size_t k = 0; k < columns.size(); ++k)
    optimum.active[k].price = prices[static_cast<Eigen::Index>(k)] * scaled.goal_unit() / units[k];
  std::erase_if(optimum.active, [](const ActiveLimit& of) { return *of.price == 0.0; });
}

}  // namespace

LocalOptimum rough_optimum(const OptimumQuestion& question,
                           const OptimumQuestion::Function& function,
                           const std::vector<double>& start, Tally& tally) {
  Scaled scaled(question, function, start, tally);
  const int n = static_cast<int>(scaled.size());
  constexpr double near = 1e-5;
  if (n > 0) search(scaled, NLOPT_LN_COBYLA, near, 100 * (n + 1));
  return {scaled.best_values(), scaled.best(), {}, 0.0};
}

LocalOptimum exact_optimum(const OptimumQuestion& question,
                           const OptimumQuestion::Function& function, const LocalOptimum& near,
                           Tally& tally) {
  Scaled scaled(question, function, near.values, tally);
  if (scaled.size() == 0 || !scaled.best().trouble.empty()) return near;
  constexpr double close = 1e-12;
  constexpr int rounds = 15, iterations = 20;
  for (int round = 0; round < rounds; ++round) {
    const Worth before = scaled.best();
    search(scaled, NLOPT_LD_MMA, close, iterations);
    const double gain = before.goal - scaled.best().goal;
    if (keeps_limits(before) && gain <= close * std::abs(before.goal)) break;
  }
  LocalOptimum optimum{scaled.best_values(), scaled.best(), {}, 0.0};
  if (keeps_limits(optimum.worth)) balance(scaled, question, optimum);
  return optimum;
}

}  // namespace boxbeam
