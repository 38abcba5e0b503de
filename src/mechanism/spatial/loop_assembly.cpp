// How the loops of a mechanism are closed for the first time, and what they determine.

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "loop_rows.hpp"

namespace boxbeam::spatial {
namespace {

/// Whether a joint moves a body: it stands between the ground and the body.
bool carries(const Mechanism& mechanism, std::size_t joint, int body) {
  while (body > static_cast<int>(joint))
    body = mechanism.joints[static_cast<std::size_t>(body)].parent;
  return body == static_cast<int>(joint);
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
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    if (mechanism.joints[i].kind != JointKind::fixed &&
        mechanism.joints[i].moved_by == MovedBy::loops)
      free_.push_back(i);
  }
  const auto rows = static_cast<Eigen::Index>(rows_.size());
  const auto columns = static_cast<Eigen::Index>(free_.size());
  row_scale_.resize(rows);
  column_scale_.resize(columns);
  moves_.resize(rows, columns);
  for (Eigen::Index r = 0; r < rows; ++r) {
    const LoopRow& row = rows_[static_cast<std::size_t>(r)];
    row_scale_[r] = row.kind == LoopRow::Kind::square ? 1.0 : 1.0 / size_;
    const ClosingJoint& joint = mechanism.closing[row.joint];
    for (Eigen::Index k = 0; k < columns; ++k) {
      const std::size_t i = free_[static_cast<std::size_t>(k)];
      moves_(r, k) = (carries(mechanism, i, joint.b.body) ? 1 : 0) -
                     (carries(mechanism, i, joint.a.body) ? 1 : 0);
    }
  }
  for (Eigen::Index k = 0; k < columns; ++k) {
    const JointKind kind = mechanism.joints[free_[static_cast<std::size_t>(k)]].kind;
    column_scale_[k] = is_angle(kind) ? 1.0 : size_;
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
    q[k] = state.coordinates[free_[static_cast<std::size_t>(k)]].value;
  double first = 0.0;
  static_cast<void>(converge(tree, state, q, first));
  samples_.push_back(with_rates(tree, state, q));
}

/// The position nearest to the start in which all is closed, by Levenberg's and Marquardt's method.
void Loops::assemble(const Tree& tree, State& state) const {
  constexpr int most = 500;
  constexpr double longest = 0.5;
  const Mechanism& mechanism = tree.mechanism();
  const auto columns = static_cast<Eigen::Index>(free_.size());
  Eigen::VectorXd q(columns);
  for (Eigen::Index k = 0; k < columns; ++k)
    q[k] = mechanism.joints[free_[static_cast<std::size_t>(k)]].start;
  set(state, {0.0, q, {}, {}});
  tree.move(state);
  Eigen::VectorXd values = open(tree, state, all_);
  double damping = 1e-3;
  for (int step = 0; step < most && columns > 0 && damping < 1e10; ++step) {
    const Eigen::MatrixXd J = jacobian(tree, state, all_);
    Eigen::MatrixXd normal = J.transpose() * J;
    normal.diagonal().array() += damping;
    Eigen::VectorXd correction = normal.ldlt().solve(-J.transpose() * values);
    const double size = correction.cwiseAbs().maxCoeff();
    if (size < 1e-15) break;
    if (size > longest) correction *= longest / size;
    const Eigen::VectorXd tried = q + column_scale_.cwiseProduct(correction);
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
  Eigen::Index worst = 0;
  if (values.cwiseAbs().maxCoeff(&worst) > 1e-8) {
    const LoopRow& row = rows_[static_cast<std::size_t>(worst)];
    const std::string& name = mechanism.closing[row.joint].name;
    throw AnalysisError(
        {fmt::format("the loops cannot be closed at t = 0: in the nearest position that was found, "
                     "joint \"{}\" is {}; give the free joints starts near the position that is "
                     "meant, or other lengths",
                     name, open_text(row, values[worst] / row_scale_[worst])),
         "joint " + name,
         0.0,
         std::abs(values[worst]),
         {},
         {}});
  }
  for (const ClosingJoint& joint : mechanism.closing) {
    if (stands_right(joint, state)) continue;
    throw AnalysisError(
        {fmt::format("near the given starts the loops close with joint \"{}\" turned by half a "
                     "turn; give starts near the position that is meant",
                     joint.name),
         "joint " + joint.name,
         0.0,
         {},
         {},
         {}});
  }
}

/// The rows that determine the free coordinates, as independent of each other as they can be; what
/// the other rows ask for follows from them.
void Loops::choose_rows(const Tree& tree, const State& state) {
  constexpr double none = 1e-6;  // singular values beside the largest; data have fewer digits
  const auto columns = static_cast<Eigen::Index>(free_.size());
  if (columns == 0) return;
  const Mechanism& mechanism = tree.mechanism();
  const Eigen::MatrixXd J = jacobian(tree, state, all_);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(J, Eigen::ComputeFullV);
  const Eigen::VectorXd& values = svd.singularValues();
  const Eigen::Index rank = (values.array() > none * std::max(values[0], 1e-300)).count();
  if (rank < columns) {
    const Eigen::VectorXd moving = svd.matrixV().rightCols(columns - rank).rowwise().norm();
    std::vector<std::string> names;
    for (Eigen::Index k = 0; k < columns; ++k) {
      if (moving[k] > 1e-6)
        names.push_back(mechanism.joints[free_[static_cast<std::size_t>(k)]].name);
    }
    const Eigen::Index left = columns - rank;
    throw AnalysisError(
        {fmt::format(
             "the loops leave {} freedom{} that nothing drives, in joint{} {}; drive as many "
             "of them, let forces move them (moved_by = \"forces\"), or take freedom away where a "
             "body only turns about the line between two ball joints (one of them universal). In a "
             "dead point at t = 0 begin at another posture",
             left, left == 1 ? "" : "s", names.size() == 1 ? "" : "s", fmt::join(names, ", ")),
         "joint " + names.front(),
         0.0,
         {},
         {},
         {}});
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(J.transpose());
  const auto& order = qr.colsPermutation().indices();
  for (Eigen::Index k = 0; k < columns; ++k) chosen_.push_back(static_cast<std::size_t>(order[k]));
  std::sort(chosen_.begin(), chosen_.end());
  branch_ =
      sign_of_determinant(Eigen::PartialPivLU<Eigen::MatrixXd>(jacobian(tree, state, chosen_)));
}

/// Forces that loops can hold without any load make what they reach not unique.
void Loops::judge_uniqueness(const Tree& tree, const State& state) {
  const Mechanism& mechanism = tree.mechanism();
  const std::size_t bodies = mechanism.bodies.size();
  if (unique_.empty()) unique_.assign(bodies + mechanism.closing.size(), 1);
  const auto rows = static_cast<Eigen::Index>(rows_.size());
  const auto rank = static_cast<Eigen::Index>(chosen_.size());
  if (rank == rows) return;
  Eigen::MatrixXd held;  // columns: multipliers that leave the free joints without force
  if (rank == 0) {
    held = Eigen::MatrixXd::Identity(rows, rows);
  } else {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian(tree, state, all_), Eigen::ComputeFullU);
    held = svd.matrixU().rightCols(rows - rank);
  }
  std::vector<Wrench> without, with;
  tree.wrenches(state, {}, without);
  double largest = 1.0;
  for (const Wrench& joint : without)
    largest = std::max({largest, joint.force.norm(), joint.moment.norm() / size_});
  const double size = 1e3 * largest;  // of the forces that are tried: above round-off of the others
  for (Eigen::Index c = 0; c < held.cols(); ++c) {
    const Eigen::VectorXd multipliers = size * size_ * row_scale_.cwiseProduct(held.col(c));
    const std::vector<Wrench> closing = closing_wrenches(mechanism, rows_, multipliers, state);
    tree.wrenches(state, on_both_bodies(mechanism, closing, state), with);
    const auto judge = [&](std::size_t index, const Wrench& change) {
      if (change.force.norm() + change.moment.norm() / size_ > 1e-6 * size) unique_[index] = 0;
    };
    for (std::size_t i = 0; i < bodies; ++i)
      judge(i, {with[i].force - without[i].force, with[i].moment - without[i].moment});
    for (std::size_t i = 0; i < closing.size(); ++i) judge(bodies + i, closing[i]);
  }
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
  if (!span.closed) return;
  stand(end, state);
  if (!alike(begin, state, size_)) {
    throw AnalysisError(
        {fmt::format("after a period of the drivers, {:.6g} s, the loops stand elsewhere than "
                     "before it; give [motion] duration with the time that is to be looked at",
                     span.length),
         "joint " + mechanism.closing.front().name,
         end.time,
         {},
         {},
         {}});
  }
  begin_ = span.begin;
  period_ = span.length;
}

}  // namespace boxbeam::spatial
