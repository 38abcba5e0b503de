// How the loops of a mechanism are closed for the first time, and what they determine.

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/branch.hpp"
#include "boxbeam/numerics/halton.hpp"
#include "boxbeam/numerics/singular_values.hpp"
#include "loop_factors.hpp"
#include "loop_rows.hpp"

namespace boxbeam::spatial {
namespace {

using Jacobian = Eigen::SparseMatrix<double>;

constexpr double closed = 1e-8;  ///< largest error of an equation, without units
/// Starts tried beside those that are given, in rounds of which each reaches twice as far.
constexpr int other_starts = 128, rounds = 4;

bool all_stand_right(const Mechanism& mechanism, const State& state) {
  return std::all_of(mechanism.closing.begin(), mechanism.closing.end(),
                     [&](const ClosingJoint& joint) { return stands_right(joint, state); });
}

/// Rows that are as independent of each other as they can be, as many as columns.
std::vector<std::size_t> independent_rows(const Jacobian& J) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(Eigen::MatrixXd(J.transpose()));
  const auto& order = qr.colsPermutation().indices();
  std::vector<std::size_t> rows;
  for (Eigen::Index k = 0; k < J.cols(); ++k) rows.push_back(static_cast<std::size_t>(order[k]));
  return rows;
}

AnalysisError undetermined(const Mechanism& mechanism, std::size_t freedoms,
                           const std::vector<std::size_t>& joints) {
  std::vector<std::string> names;
  for (const std::size_t i : joints) names.push_back(mechanism.joints[i].name);
  return AnalysisError(
      {fmt::format(
           "the loops leave {} freedom{} that nothing drives, in joint{} {}; drive as many "
           "of them, let forces move them (moved_by = \"forces\"), or take freedom away where a "
           "body only turns about the line between two ball joints (one of them universal). In a "
           "dead point at t = 0 begin at another posture",
           freedoms, freedoms == 1 ? "" : "s", names.size() == 1 ? "" : "s",
           fmt::join(names, ", ")),
       "joint " + names.front(), 0.0});
}

/// Time in which the fastest driver turns an eighth of a radian, where it is not known how long the
/// motion is looked at.
double short_time_of(const Mechanism& mechanism) {
  double omega = 1.0;
  for (const DriverUse& use : functions_of(mechanism))
    omega = std::max(omega, timing_of(*use.driver, use.turning).highest_omega);
  return 0.125 / omega;
}

/// Whether two states have all bodies at the same place.
bool alike(const State& one, const State& other, double size) {
  constexpr double near = 1e-6;
  for (std::size_t i = 0; i < one.bodies.size(); ++i) {
    const BodyMotion& a = one.bodies[i];
    const BodyMotion& b = other.bodies[i];
    if ((a.R_WB - b.R_WB).norm() > near || (a.position - b.position).norm() > near * size)
      return false;
  }
  return true;
}

}  // namespace

Loops::Loops(const Tree& tree) : rows_(rows_of(tree.mechanism())) {
  const Mechanism& mechanism = tree.mechanism();
  size_ = size_of(mechanism);
  all_.resize(rows_.size());
  std::iota(all_.begin(), all_.end(), std::size_t{0});
  free_ = columns_of(mechanism, MovedBy::loops);
  led_ = columns_of(mechanism, MovedBy::forces);
  const auto rows = static_cast<Eigen::Index>(rows_.size());
  const auto columns = static_cast<Eigen::Index>(free_.joints.size());
  row_scale_.resize(rows);
  for (Eigen::Index r = 0; r < rows; ++r) {
    const LoopRow& row = rows_[static_cast<std::size_t>(r)];
    row_scale_[r] = row.kind == LoopRow::Kind::square ? 1.0 : 1.0 / size_;
  }
  for (const ClosingJoint& joint : mechanism.closing)
    if (joint.kind == ClosingKind::screw) screws_.push_back(joint);
  for (std::size_t i = 0; i < mechanism.joints.size() && !screws_.empty(); ++i)
    if (is_angle(mechanism.joints[i].kind)) angles_.push_back(i);
  State state;
  tree.begin(state);
  assemble(tree, state);
  choose_rows(tree, state);
  judge_uniqueness(tree, state);
  Eigen::VectorXd q(columns);
  for (Eigen::Index k = 0; k < columns; ++k)
    q[k] = state.coordinates[free_.joints[static_cast<std::size_t>(k)]].value;
  double first = 0.0;
  static_cast<void>(converge(tree, state, q, first));
  samples_.push_back(with_rates(tree, state, q));
}

Loops::Columns Loops::columns_of(const Mechanism& mechanism, MovedBy moved_by) const {
  Columns columns;
  std::vector<double> scale;
  std::vector<Eigen::Index> number(mechanism.joints.size(), -1);  // among them
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    if (joint.kind == JointKind::fixed || joint.moved_by != moved_by) continue;
    number[i] = static_cast<Eigen::Index>(columns.joints.size());
    columns.joints.push_back(i);
    scale.push_back(is_angle(joint.kind) ? 1.0 : size_);
  }
  columns.scale =
      Eigen::Map<Eigen::VectorXd>(scale.data(), static_cast<Eigen::Index>(scale.size()));
  for (const ClosingJoint& joint : mechanism.closing) {
    std::vector<Between>& between = columns.between.emplace_back();
    each_between(mechanism, joint, [&](std::size_t i, double sign) {
      if (number[i] >= 0) between.push_back({number[i], sign});
    });
  }
  return columns;
}

/// By Levenberg's and Marquardt's method.
Eigen::VectorXd Loops::nearest_closed(const Tree& tree, State& state, Eigen::VectorXd q) const {
  constexpr int most = 500;
  constexpr double longest = 0.5;
  const Eigen::Index columns = q.size();
  set(state, {0.0, q, {}, {}});
  tree.move(state);
  Eigen::VectorXd values = open(tree, state, all_);
  double damping = 1e-3;
  Eigen::SimplicialLDLT<Jacobian> solver;
  for (int step = 0; step < most && columns > 0 && damping < 1e10; ++step) {
    const Jacobian J = jacobian(tree, state, all_);
    Jacobian normal = J.transpose() * J;
    for (Eigen::Index k = 0; k < columns; ++k) normal.coeffRef(k, k) += damping;
    solver.compute(normal);
    if (solver.info() != Eigen::Success) {  // freedoms that are left, and round-off
      damping *= 10.0;
      continue;
    }
    Eigen::VectorXd correction = solver.solve(-J.transpose() * values);
    const double size = correction.cwiseAbs().maxCoeff();
    if (size < 1e-15) break;
    if (size > longest) correction *= longest / size;
    const Eigen::VectorXd tried = q + free_.scale.cwiseProduct(correction);
    set(state, {0.0, tried, {}, {}});
    tree.move(state);
    const Eigen::VectorXd left = open(tree, state, all_);
    if (left.norm() < values.norm()) {
      q = tried;
      values = left;
      damping = std::max(0.1 * damping, 1e-14);
      continue;
    }
    damping *= 10.0;
    set(state, {0.0, q, {}, {}});
    tree.move(state);
  }
  return values;
}

/// Around the starts, ever wider: of the first round that finds any the one that is nearest.
bool Loops::assemble_elsewhere(const Tree& tree, State& state,
                               const Eigen::VectorXd& starts) const {
  const Mechanism& mechanism = tree.mechanism();
  double least = std::numeric_limits<double>::infinity();
  Eigen::VectorXd nearest;
  for (int index = 1; index <= other_starts; ++index) {
    const int round = (index - 1) * rounds / other_starts;
    if (nearest.size() > 0 && (index - 1) % (other_starts / rounds) == 0) break;
    const double reach = full_turn * std::pow(0.5, rounds - 1 - round);
    const std::vector<double> at = halton_point(index, static_cast<int>(starts.size()));
    Eigen::VectorXd q = starts;
    for (Eigen::Index k = 0; k < q.size(); ++k)
      q[k] += free_.scale[k] * reach * (at[static_cast<std::size_t>(k)] - 0.5);
    if (nearest_closed(tree, state, q).cwiseAbs().maxCoeff() > closed) continue;
    if (!all_stand_right(mechanism, state) || !loops_off_branch(mechanism, state).empty()) continue;
    double away = 0.0;
    q = sample_of(state).q;
    for (Eigen::Index k = 0; k < q.size(); ++k) {
      const double by = (q[k] - starts[k]) / free_.scale[k];
      const JointKind kind = mechanism.joints[free_.joints[static_cast<std::size_t>(k)]].kind;
      away = std::hypot(away, kind == JointKind::revolute ? std::remainder(by, full_turn) : by);
    }
    if (away >= least) continue;
    least = away;
    nearest = q;
  }
  if (nearest.size() == 0) return false;
  set(state, {0.0, nearest, {}, {}});
  tree.move(state);
  return true;
}

/// The position nearest to the start in which all is closed, on the branch that is wanted.
void Loops::assemble(const Tree& tree, State& state) const {
  const Mechanism& mechanism = tree.mechanism();
  const auto columns = static_cast<Eigen::Index>(free_.joints.size());
  Eigen::VectorXd starts(columns);
  for (Eigen::Index k = 0; k < columns; ++k)
    starts[k] = mechanism.joints[free_.joints[static_cast<std::size_t>(k)]].start;
  const Eigen::VectorXd values = nearest_closed(tree, state, starts);
  Eigen::Index worst = 0;
  const bool is_closed = values.cwiseAbs().maxCoeff(&worst) <= closed;
  const std::string off = loops_off_branch(mechanism, state);
  if (is_closed && off.empty() && all_stand_right(mechanism, state)) return;
  if (!mechanism.branches.empty()) {
    if (assemble_elsewhere(tree, state, starts)) return;
    if (is_closed && !off.empty())
      throw AnalysisError(
          {fmt::format("no assembly found on the wanted branch, from the starts of the free "
                       "joints and {} other ones; change the sign that is asked for, or give "
                       "starts near the position that is meant",
                       other_starts),
           off, 0.0});
  }
  if (!is_closed) {
    const LoopRow& row = rows_[static_cast<std::size_t>(worst)];
    const std::string& name = mechanism.closing[row.joint].name;
    throw AnalysisError(
        {fmt::format("the loops cannot be closed at t = 0: in the nearest position that was found, "
                     "joint \"{}\" is {}; give the free joints starts near the position that is "
                     "meant, or other lengths",
                     name, open_text(row, values[worst] / row_scale_[worst])),
         "joint " + name, 0.0, std::abs(values[worst])});
  }
  for (const ClosingJoint& joint : mechanism.closing) {
    if (stands_right(joint, state)) continue;
    throw AnalysisError(
        {fmt::format("near the given starts the loops close with joint \"{}\" turned by half a "
                     "turn; give starts near the position that is meant",
                     joint.name),
         "joint " + joint.name, 0.0});
  }
}

/// The rows that determine the free coordinates, as independent of each other as they can be; what
/// the other rows ask for follows from them.
void Loops::choose_rows(const Tree& tree, const State& state) {
  constexpr double none = 1e-6;  // singular values beside the largest; data have fewer digits
  constexpr Eigen::Index most_whole = 150;
  const auto columns = static_cast<Eigen::Index>(free_.joints.size());
  if (columns == 0) return;
  const Mechanism& mechanism = tree.mechanism();
  const Jacobian J = jacobian(tree, state, all_);
  std::vector<std::size_t> idle;
  SparseElimination order;
  if (columns > most_whole) {
    const Eigen::Index rank =
        find_order(pattern_of(all_), entries(tree, state, all_, free_), order);
    for (const int k : order.cols_left()) idle.push_back(free_.joints[static_cast<std::size_t>(k)]);
    if (rank < columns)
      throw undetermined(mechanism, static_cast<std::size_t>(columns - rank), idle);
  }
  const SingularValues of = smallest_singular_values(J, none, most_whole);
  const Eigen::Index left = (of.smallest.array() <= none * std::max(of.largest, 1e-300)).count();
  if (left > 0) {
    const Eigen::VectorXd moving = of.vectors.rightCols(left).rowwise().norm();
    for (Eigen::Index k = 0; k < columns; ++k)
      if (moving[k] > 1e-6) idle.push_back(free_.joints[static_cast<std::size_t>(k)]);
    throw undetermined(mechanism, static_cast<std::size_t>(left), idle);
  }
  if (columns > most_whole) {
    const std::vector<int>& over = order.rows_left();  // ascending
    std::set_difference(
        all_.begin(), all_.end(), over.begin(), over.end(), std::back_inserter(chosen_),
        [](auto a, auto b) { return static_cast<std::size_t>(a) < static_cast<std::size_t>(b); });
  } else {
    chosen_ = independent_rows(J);
    std::sort(chosen_.begin(), chosen_.end());
  }
  pattern_ = pattern_of(chosen_);
  keep_order(tree, state);
  branch_ = factors(tree, state).sign_of_determinant();
}

/// An order of elimination that suits a state, where none that is known does.
void Loops::keep_order(const Tree& tree, const State& state) {
  constexpr std::size_t most = 8;
  if (pattern_.rows <= LoopFactors::most_whole || orders_.size() == most) return;
  const std::vector<double> at = entries(tree, state, chosen_, free_);
  if (std::any_of(orders_.begin(), orders_.end(),
                  [&](const SparseElimination& order) { return suits(order, at); }))
    return;
  SparseElimination order;
  if (find_order(pattern_, at, order) == pattern_.cols) orders_.push_back(std::move(order));
}

void Loops::follow(const Tree& tree, const ForcedMotion* forced) {
  constexpr int at_least = 96;
  const Mechanism& mechanism = tree.mechanism();
  TimeSpan span;
  try {
    span = time_span_of(mechanism);
    longest_step_ = span.length / at_least;
  } catch (const AnalysisError&) {  // single times can be asked for all the same
    span.length = 0.0;
    longest_step_ = short_time_of(mechanism);
  }
  forced_ = forced;
  if (span.length == 0.0) return;
  State begin, state;
  const auto stand = [&](const Sample& at, State& standing) {
    drive(tree, standing, at.time);
    set(standing, at);
    tree.move(standing);
  };
  stand(span.begin > 0.0 ? followed(tree, samples_.back(), span.begin, &samples_) : samples_.back(),
        begin);
  const Sample middle = followed(tree, samples_.back(), span.begin + 0.5 * span.length, &samples_);
  stand(middle, state);
  judge_uniqueness(tree, state);
  const Sample end = followed(tree, middle, span.begin + span.length, &samples_);
  for (const Sample& sample : samples_) {
    stand(sample, state);
    keep_order(tree, state);
  }
  if (!span.closed) return;
  stand(end, state);
  if (!alike(begin, state, size_)) {
    throw AnalysisError(
        {fmt::format("after a period of the drivers, {:.6g} s, the loops stand elsewhere than "
                     "before it; give [motion] duration with the time that is to be looked at",
                     span.length),
         "joint " + mechanism.closing.front().name, end.time});
  }
  begin_ = span.begin;
  period_ = span.length;
}

}  // namespace boxbeam::spatial
