#include "boxbeam/mechanism/spatial/loops.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/forced_motion.hpp"
#include "boxbeam/numerics/singular_values.hpp"
#include "loop_factors.hpp"
#include "loop_rows.hpp"

namespace boxbeam::spatial {
namespace {

/// Of a predicted position, without units: beyond it another branch may be near.
constexpr double largest_correction = 0.02;
/// From one followed position to the next.
constexpr double largest_move = 0.3;

/// Taylor's series up to the acceleration.
Eigen::VectorXd predicted(const auto& from, double time) {
  const double dt = time - from.time;
  return from.q + dt * (from.rate + 0.5 * dt * from.acceleration);
}

}  // namespace

void Loops::set(State& state, const Sample& sample) const {
  for (std::size_t k = 0; k < free_.joints.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    state.coordinates[free_.joints[k]] = {
        sample.q[i], sample.rate.size() ? sample.rate[i] : 0.0,
        sample.acceleration.size() ? sample.acceleration[i] : 0.0};
  }
}

SparsePattern Loops::pattern_of(const Rows& rows) const {
  SparsePattern pattern;
  pattern.rows = static_cast<Eigen::Index>(rows.size());
  pattern.cols = static_cast<Eigen::Index>(free_.joints.size());
  pattern.row_start.push_back(0);
  for (const std::size_t row : rows) {
    for (const Between& between : free_.between[rows_[row].joint])
      pattern.col.push_back(static_cast<int>(between.column));
    pattern.row_start.push_back(static_cast<int>(pattern.col.size()));
  }
  return pattern;
}

std::vector<double> Loops::entries(const Tree& tree, const State& state, const Rows& rows,
                                   const Columns& columns) const {
  const Mechanism& mechanism = tree.mechanism();
  std::vector<Eigen::Vector3d> axes;
  axes.reserve(columns.joints.size());
  for (const std::size_t i : columns.joints)
    axes.push_back(in_world(state, mechanism.joints[i].parent, mechanism.joints[i].axis));
  std::vector<double> values;
  values.reserve(pattern_.entries());
  for (const std::size_t r : rows) {
    const LoopRow& row = rows_[r];
    const Wrench wrench = wrench_of(mechanism, row, state);
    const Eigen::Vector3d place = position_of(state, place_of(mechanism.closing[row.joint]));
    const double scale = row_scale_[static_cast<Eigen::Index>(r)];
    for (const Between& between : columns.between[row.joint]) {
      const auto column = static_cast<std::size_t>(between.column);
      const std::size_t i = columns.joints[column];
      const double power = along_coordinate(
          mechanism.joints[i], axes[column],
          {wrench.force, wrench.moment + (place - state.bodies[i].joint).cross(wrench.force)});
      values.push_back(between.sign * scale * power * columns.scale[between.column]);
    }
  }
  return values;
}

Eigen::SparseMatrix<double> Loops::jacobian(const Tree& tree, const State& state,
                                            const Rows& rows) const {
  const SparsePattern pattern = pattern_of(rows);
  return pattern.scaled(entries(tree, state, rows, free_), Eigen::VectorXd::Ones(pattern.rows),
                        Eigen::VectorXd::Ones(pattern.cols));
}

LoopFactors Loops::factors(const Tree& tree, const State& state) const {
  return {pattern_, entries(tree, state, chosen_, free_), orders_};
}

Eigen::MatrixXd Loops::following(const Tree& tree, const State& state, const LoopFactors& J) const {
  const auto rows = static_cast<Eigen::Index>(chosen_.size());
  const auto columns = static_cast<Eigen::Index>(led_.joints.size());
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(rows, columns);
  const std::vector<double> values = entries(tree, state, chosen_, led_);
  auto value = values.begin();
  for (Eigen::Index r = 0; r < rows; ++r) {
    for (const Between& between : led_.between[rows_[chosen_[static_cast<std::size_t>(r)]].joint])
      moved(r, between.column) = *value++;
  }
  for (Eigen::Index k = 0; k < columns; ++k)
    moved.col(k) = free_.scale.cwiseProduct(J.solve(-moved.col(k))) / led_.scale[k];
  return moved;
}

Eigen::VectorXd Loops::open(const Tree& tree, const State& state, const Rows& rows) const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    values[static_cast<Eigen::Index>(r)] = row_scale_[static_cast<Eigen::Index>(rows[r])] *
                                           motion_of(tree.mechanism(), rows_[rows[r]], state).value;
  }
  return values;
}

/// Newton's method from the state's free coordinates; whether it converges to the branch of the
/// start. `first`: its first correction.
bool Loops::converge(const Tree& tree, State& state, Eigen::VectorXd& q, double& first) const {
  constexpr int most = 12;
  constexpr double converged = 1e-11;  // squared by the step that follows it
  first = 0.0;
  for (int step = 0; step < most; ++step) {
    tree.place(state);
    if (free_.joints.empty()) return true;
    const LoopFactors J = factors(tree, state);
    const Eigen::VectorXd correction = J.solve(-open(tree, state, chosen_));
    const double size = correction.cwiseAbs().maxCoeff();
    if (!(size < 1.0)) return false;
    if (step == 0) first = size;
    q += free_.scale.cwiseProduct(correction);
    set(state, {state.time, q, {}, {}});
    if (size < converged) return branch_ == 0 || J.sign_of_determinant() == branch_;
  }
  return false;
}

Loops::Sample Loops::with_rates(const Tree& tree, State& state, const Eigen::VectorXd& q) const {
  const auto count = static_cast<Eigen::Index>(free_.joints.size());
  Sample sample{state.time, q, Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count)};
  set(state, sample);
  tree.place(state);
  tree.move_at_rates(state);
  sample.turned = turned(state);
  if (free_.joints.empty()) {
    tree.accelerate(state);
    return sample;
  }
  const LoopFactors J = factors(tree, state);
  if (!led_.joints.empty()) sample.following = following(tree, state, J);
  const auto solved = [&](double RowMotion::*left) -> Eigen::VectorXd {
    Eigen::VectorXd values(count);
    for (Eigen::Index r = 0; r < count; ++r) {
      const std::size_t row = chosen_[static_cast<std::size_t>(r)];
      values[r] = -row_scale_[static_cast<Eigen::Index>(row)] *
                  (motion_of(tree.mechanism(), rows_[row], state).*left);
    }
    return free_.scale.cwiseProduct(J.solve(values));
  };
  sample.rate = solved(&RowMotion::rate);
  set(state, sample);
  tree.move_at_rates(state);
  tree.accelerate(state);
  sample.acceleration = solved(&RowMotion::acceleration);
  set(state, sample);
  tree.accelerate(state);
  return sample;
}

Loops::Sample Loops::sample_of(const State& state) const {
  const auto count = static_cast<Eigen::Index>(free_.joints.size());
  Sample sample{state.time, Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::VectorXd(count)};
  for (Eigen::Index k = 0; k < count; ++k) {
    const DriverState& of = state.coordinates[free_.joints[static_cast<std::size_t>(k)]];
    sample.q[k] = of.value;
    sample.rate[k] = of.rate;
    sample.acceleration[k] = of.acceleration;
  }
  sample.turned = turned(state);
  return sample;
}

Eigen::VectorXd Loops::turned(const State& state) const {
  Eigen::VectorXd of(static_cast<Eigen::Index>(screws_.size() + angles_.size()));
  Eigen::Index next = 0;
  for (const ClosingJoint& screw : screws_) {
    const Eigen::Vector3d slide = position_of(state, screw.b) - position_of(state, screw.a);
    of[next++] = in_world(state, screw.a.body, screw.axis).dot(slide) / pitch_of(screw.lead);
  }
  for (const std::size_t i : angles_) of[next++] = state.coordinates[i].value;
  return of;
}

bool Loops::keeps_turns(const Sample& near, const State& state) const {
  constexpr double most = 1.0;  // [rad]
  if (screws_.empty()) return true;
  return (turned(state) - near.turned).cwiseAbs().maxCoeff() <= most;
}

void Loops::drive(const Tree& tree, State& state, double time) const {
  tree.drive(state, time);
  if (forced_ != nullptr) forced_->set(tree, state);
}

std::optional<Loops::Sample> Loops::close_beside(const Sample& near, const Tree& tree,
                                                 State& state) const {
  Eigen::VectorXd q = predicted(near, state.time);
  set(state, {state.time, q, {}, {}});
  double first = 0.0;
  if (!converge(tree, state, q, first) || first > largest_correction) return std::nullopt;
  if (!keeps_turns(near, state)) return std::nullopt;
  return with_rates(tree, state, q);
}

/// Step by step to another time, never so far that another branch could be taken for this one.
Loops::Sample Loops::followed(const Tree& tree, Sample from, double until,
                              std::vector<Sample>* kept) const {
  constexpr double shortest = 1e-10;  // of the longest step
  State state;
  double step = longest_step_;
  while (from.time != until) {
    const double left = until - from.time;
    step = std::min(step, std::abs(left));
    const double time = step == std::abs(left) ? until : from.time + std::copysign(step, left);
    Eigen::VectorXd q = predicted(from, time);
    const Eigen::VectorXd before = from.q;
    drive(tree, state, time);
    set(state, {time, q, {}, {}});
    double first = 0.0;
    const auto moved = [&] {
      return free_.joints.empty() ? 0.0
                                  : (q - before).cwiseQuotient(free_.scale).cwiseAbs().maxCoeff();
    };
    if (converge(tree, state, q, first) && first <= largest_correction && moved() <= largest_move &&
        keeps_turns(from, state)) {
      from = with_rates(tree, state, q);
      if (kept != nullptr) kept->push_back(from);
      if (first < 0.1 * largest_correction) step = std::min(1.5 * step, longest_step_);
      continue;
    }
    step *= 0.5;
    if (step > shortest * longest_step_) continue;
    drive(tree, state, from.time);
    set(state, from);
    tree.move(state);
    const SingularValues of = smallest_singular_values(jacobian(tree, state, chosen_), 0.0);
    const Eigen::VectorXd runs = of.vectors.rightCols(1).cwiseAbs();
    std::vector<std::string> names;
    for (Eigen::Index k = 0; k < runs.size(); ++k) {
      if (runs[k] > 0.3 * runs.maxCoeff())
        names.push_back(tree.mechanism().joints[free_.joints[static_cast<std::size_t>(k)]].name);
    }
    throw AnalysisError(
        {fmt::format("the loops cannot be followed beyond a dead point: the drivers no longer "
                     "determine joint{} {} there; the mechanism ends there, or two of its branches "
                     "meet",
                     names.size() == 1 ? "" : "s", fmt::join(names, ", ")),
         "joint " + tree.mechanism().closing.front().name,
         from.time,
         {},
         of.largest / of.smallest.tail(1)[0]});
  }
  return from;
}

Loops::Sample Loops::close(const Tree& tree, State& state) const {
  double time = state.time;
  if (period_ > 0.0 && time > samples_.back().time) {
    time = begin_ + std::fmod(time - begin_, period_);
  }
  const auto later =
      std::lower_bound(samples_.begin(), samples_.end(), time,
                       [](const Sample& sample, double at) { return sample.time < at; });
  auto near = later == samples_.end() ? samples_.end() - 1 : later;
  if (near != samples_.begin() && time - (near - 1)->time < near->time - time) --near;
  Eigen::VectorXd q = predicted(*near, time);
  set(state, {state.time, q, {}, {}});
  double first = 0.0;
  const bool within = time <= samples_.back().time && time >= samples_.front().time;
  if (!within || !converge(tree, state, q, first) || first > largest_correction ||
      !keeps_turns(*near, state)) {
    q = followed(tree, *near, time, nullptr).q;
    set(state, {state.time, q, {}, {}});
    static_cast<void>(converge(tree, state, q, first));
  }
  Sample sample = with_rates(tree, state, q);
  const Eigen::VectorXd values = open(tree, state, all_);
  Eigen::Index worst = 0;
  if (values.cwiseAbs().maxCoeff(&worst) <= 1e-8) return sample;
  const LoopRow& row = rows_[static_cast<std::size_t>(worst)];
  throw AnalysisError(
      {fmt::format(
           "joints contradict each other: where the others are closed, joint \"{}\" is {}; "
           "joints that repeat each other must agree to eight digits, or one of them leaves "
           "more freedom; where drivers and forces move more joints than there are freedoms, leave "
           "one "
           "to the loops",
           tree.mechanism().closing[row.joint].name,
           open_text(row, values[worst] / row_scale_[worst])),
       "joint " + tree.mechanism().closing[row.joint].name, state.time, std::abs(values[worst])});
}

void Loops::wrenches(const Tree& tree, const State& state, std::span<const BodyWrench> others,
                     std::vector<Wrench>& joints) const {
  const Mechanism& mechanism = tree.mechanism();
  // What free joints would have to carry along their axes, were the loops open.
  tree.wrenches(state, others, joints);
  const auto count = static_cast<Eigen::Index>(free_.joints.size());
  Eigen::VectorXd needed(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const std::size_t i = free_.joints[static_cast<std::size_t>(k)];
    const Joint& joint = mechanism.joints[i];
    const Eigen::Vector3d axis = in_world(state, joint.parent, joint.axis);
    needed[k] = free_.scale[k] * along_coordinate(joint, axis, joints[i]);
  }
  // Rows that others imply carry nothing: where that matters, what is carried is not unique.
  Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows_.size()));
  if (count > 0) {
    const Eigen::VectorXd of_chosen = factors(tree, state).solve_transposed(needed);
    for (Eigen::Index r = 0; r < count; ++r) {
      const auto row = static_cast<Eigen::Index>(chosen_[static_cast<std::size_t>(r)]);
      multipliers[row] = row_scale_[row] * of_chosen[r];
    }
  }
  const std::vector<Wrench> closing = closing_wrenches(mechanism, rows_, multipliers, state);
  if (count > 0) {
    std::vector<BodyWrench> acting = on_both_bodies(mechanism, closing, state);
    acting.insert(acting.end(), others.begin(), others.end());
    tree.wrenches(state, acting, joints);
  }
  joints.insert(joints.end(), closing.begin(), closing.end());
}

std::vector<std::string> names_not_unique(const Mechanism& mechanism, const Loops& loops) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < loops.unique().size(); ++i) {
    if (loops.unique()[i]) continue;
    const std::size_t carrying = mechanism.joints.size();
    names.push_back(i < carrying ? mechanism.joints[i].name : mechanism.closing[i - carrying].name);
  }
  return names;
}

double Loops::residual_of(const Tree& tree, const State& state) const {
  return open(tree, state, all_).cwiseAbs().maxCoeff();
}

double Loops::condition_of(const Tree& tree, const State& state) const {
  if (free_.joints.empty()) return 1.0;
  constexpr Eigen::Index most_whole = 50;
  const SingularValues of =
      smallest_singular_values(jacobian(tree, state, chosen_), 0.0, most_whole);
  return of.largest / of.smallest.tail(1)[0];
}

}  // namespace boxbeam::spatial
