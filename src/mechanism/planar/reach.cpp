#include "boxbeam/mechanism/planar/reach.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace boxbeam::planar {
namespace {

/// The curve of assembled positions along the drivers: unknowns are the scaled coordinates and,
/// last, the share s of the way of the drivers.
class DriverCurve {
 public:
  DriverCurve(const Mechanism& mechanism, std::vector<double> from, std::vector<double> to)
      : equations_(mechanism), from_(std::move(from)), to_(std::move(to)), phi_(equations_.rows()) {
    // The share is weighed like the scaled driver values it stands for.
    for (std::size_t i = 0; i < from_.size(); ++i) {
      const double way = (to_[i] - from_[i]) * equations_.row_scale()[equations_.driver_rows()[i]];
      weight_ = std::max(weight_, std::abs(way));
    }
    if (weight_ == 0.0) weight_ = 1.0;
  }

  Eigen::VectorXd point_of(const Eigen::VectorXd& q, double share) const {
    Eigen::VectorXd x(q.size() + 1);
    x.head(q.size()) = q.cwiseQuotient(equations_.col_scale());
    x[q.size()] = share * weight_;
    return x;
  }
  Eigen::VectorXd position_of(const Eigen::VectorXd& x) const {
    return x.head(x.size() - 1).cwiseProduct(equations_.col_scale());
  }
  double share_of(const Eigen::VectorXd& x) const { return x[x.size() - 1] / weight_; }

  std::vector<double> values_at(double share) const {
    std::vector<double> values(from_.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = from_[i] + share * (to_[i] - from_[i]);
    }
    return values;
  }

  /// Back to the curve by the shortest way; false where that does not converge.
  bool correct(Eigen::VectorXd& x) {
    for (int i = 0; i < 20; ++i) {
      linearise(x);
      const Eigen::VectorXd step = svd_.solve(residual_);
      x -= step;
      if (!step.allFinite() || step.norm() > 1.0) return false;
      if (step.norm() < 1e-14 * std::max(1.0, x.norm())) return true;
    }
    linearise(x);
    return residual_.lpNorm<Eigen::Infinity>() < 1e-11;
  }

  /// The direction of the curve, with a positive component along `along`.
  Eigen::VectorXd tangent(const Eigen::VectorXd& x, const Eigen::VectorXd& along) {
    linearise(x);
    const Eigen::VectorXd direction = svd_.matrixV().rightCols(1);
    return direction.dot(along) < 0.0 ? Eigen::VectorXd(-direction) : direction;
  }

 private:
  void linearise(const Eigen::VectorXd& x) {
    equations_.set_driver_values(values_at(share_of(x)));
    equations_.set_position(position_of(x));
    equations_.evaluate(phi_, values_);
    residual_ = phi_.cwiseProduct(equations_.row_scale());
    Eigen::MatrixXd matrix(equations_.rows(), x.size());
    matrix.leftCols(x.size() - 1) = equations_.row_scale().asDiagonal() *
                                    equations_.pattern().dense(values_) *
                                    equations_.col_scale().asDiagonal();
    matrix.rightCols(1).setZero();
    for (std::size_t i = 0; i < from_.size(); ++i) {
      const Eigen::Index row = equations_.driver_rows()[i];
      matrix(row, x.size() - 1) = -(to_[i] - from_[i]) * equations_.row_scale()[row] / weight_;
    }
    svd_.setThreshold(1e-10);
    svd_.compute(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  }

  ConstraintEquations equations_;
  std::vector<double> from_, to_;
  double weight_ = 0.0;
  Eigen::VectorXd phi_, residual_;
  std::vector<double> values_;
  Eigen::JacobiSVD<Eigen::MatrixXd> svd_;
};

std::string value_text(const Driven& driven, double value) {
  if (driven.coordinate == Coordinate::angle) {
    return fmt::format("{:.9g} deg", value * 180.0 / std::numbers::pi);
  }
  return fmt::format("{:.9g} m", value);
}

/// "driver exciter: wanted 5 m, reachable 1.302776 m", per driver.
std::vector<std::string> driver_lines(const Mechanism& mechanism, const std::vector<double>& wanted,
                                      const Reach* reach) {
  std::vector<std::string> lines;
  std::size_t i = 0;
  for (const Joint& joint : mechanism.joints) {
    const auto* driven = std::get_if<Driven>(&joint.kind);
    if (driven == nullptr) continue;
    std::string line =
        fmt::format("driver {}: wanted {}", joint.name, value_text(*driven, wanted[i]));
    if (reach != nullptr && reach->limited) {
      line += fmt::format(", reachable on this way {}", value_text(*driven, reach->values[i]));
    }
    lines.push_back(line);
    ++i;
  }
  return lines;
}

void add_position(const Mechanism& mechanism, const Eigen::VectorXd& q, const std::string& title,
                  std::vector<std::string>& lines) {
  constexpr std::size_t most = 8;
  lines.push_back(title);
  for (std::size_t i = 0; i < mechanism.bodies.size() && i < most; ++i) {
    const auto k = static_cast<Eigen::Index>(3 * i);
    lines.push_back(fmt::format("  {}: centre of mass ({:.6g}, {:.6g}) m, angle {:.6g} deg",
                                mechanism.bodies[i].name, q[k], q[k + 1],
                                q[k + 2] * 180.0 / std::numbers::pi));
  }
  if (mechanism.bodies.size() > most) {
    lines.push_back(fmt::format("  and {} bodies more", mechanism.bodies.size() - most));
  }
}

std::vector<double> values_at_time(const Mechanism& mechanism, double time) {
  std::vector<double> values;
  for (const Joint& joint : mechanism.joints) {
    const auto* driven = std::get_if<Driven>(&joint.kind);
    if (driven != nullptr) values.push_back(driver_at(driven->driver, time).value);
  }
  return values;
}

}  // namespace

std::vector<double> driver_values_at(const Mechanism& mechanism, const Eigen::VectorXd& q) {
  ConstraintEquations equations(mechanism);
  equations.set_driver_values(std::vector<double>(equations.driver_rows().size(), 0.0));
  equations.set_position(q);
  Eigen::VectorXd phi(equations.rows());
  equations.evaluate(phi);
  std::vector<double> values;
  for (const Eigen::Index row : equations.driver_rows()) values.push_back(phi[row]);
  return values;
}

Reach find_reach(const Mechanism& mechanism, const Eigen::VectorXd& q,
                 const std::vector<double>& wanted) {
  Reach reach{false, wanted, q, 1.0};
  DriverCurve curve(mechanism, driver_values_at(mechanism, q), wanted);
  Eigen::VectorXd x = curve.point_of(q, 0.0);
  if (!curve.correct(x)) return reach;
  const Eigen::Index last = x.size() - 1;
  Eigen::VectorXd direction = curve.tangent(x, Eigen::VectorXd::Unit(x.size(), last));
  double length = 0.02;
  constexpr int most = 4000;
  for (int i = 0; i < most && curve.share_of(x) < 1.0; ++i) {
    Eigen::VectorXd next = x + length * direction;
    const bool corrected = curve.correct(next);
    const double gone = (next - x).norm();
    Eigen::VectorXd turned;
    if (corrected && gone < 1.5 * length) turned = curve.tangent(next, direction);
    if (turned.size() == 0 || turned.dot(direction) < 0.97) {
      length *= 0.5;
      if (length < 1e-12) return reach;
      continue;
    }
    if (turned[last] < 0.0) {
      // Behind a fold: where the share's rate along the curve is zero, by bisection of the step.
      double low = 0.0;
      double high = length;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        next = x + middle * direction;
        if (!curve.correct(next)) break;
        (curve.tangent(next, direction)[last] > 0.0 ? low : high) = middle;
      }
      if (curve.share_of(next) >= 1.0) return reach;  // the fold lies behind what is wanted
      reach.limited = true;
      reach.q = curve.position_of(next);
      reach.share = curve.share_of(next);
      reach.values = curve.values_at(reach.share);
      return reach;
    }
    x = next;
    direction = turned;
    length = std::min(0.1, 1.3 * length);
  }
  return reach;
}

AnalysisFailure failure_of_assembly(const Mechanism& mechanism, double time,
                                    const Assembly& closest) {
  const std::vector<double> wanted = values_at_time(mechanism, time);
  AnalysisFailure failure;
  failure.where = "joint " + mechanism.joints[static_cast<std::size_t>(closest.joint)].name;
  failure.time = time;
  failure.residual = closest.gap;
  Mechanism loose = mechanism;
  std::erase_if(loose.joints, is_driver);
  const Assembly joints_alone = Assembler(loose).assemble(time, closest.q);
  if (!joints_alone.closed) {
    failure.what =
        "the joints contradict each other: even without its drivers the mechanism cannot be "
        "assembled; at the closest approach the joint named stays open by the residual";
    add_position(mechanism, closest.q, "closest approach:", failure.details);
    return failure;
  }
  const Reach reach = find_reach(mechanism, joints_alone.q, wanted);
  failure.what =
      reach.limited
          ? "the mechanism cannot be assembled at the wanted value of its driver, which is out of "
            "reach; at the closest approach the joint named stays open by the residual"
          : "the mechanism cannot be assembled from the given sketch: the joint named stays open "
            "by the residual; check lengths and driver, or draw the sketch nearer";
  failure.details = driver_lines(mechanism, wanted, &reach);
  if (reach.limited) {
    add_position(mechanism, reach.q, "position at the end of the reach:", failure.details);
  } else {
    add_position(mechanism, closest.q, "closest approach:", failure.details);
  }
  return failure;
}

AnalysisFailure failure_of_motion(const Mechanism& mechanism, const State& reached, double time) {
  const std::vector<double> wanted = values_at_time(mechanism, time);
  AnalysisFailure failure;
  failure.where = "mechanism";
  failure.time = reached.time;
  const Reach reach = find_reach(mechanism, reached.q, wanted);
  const Assembly closest = Assembler(mechanism).assemble(time, reached.q);
  if (reach.limited && !closest.closed) {
    failure.where = "joint " + mechanism.joints[static_cast<std::size_t>(closest.joint)].name;
    failure.residual = closest.gap;
    failure.what = fmt::format(
        "the mechanism comes to the end of its reach (a dead point) and cannot follow its driver "
        "to t = {:.9g} s; there the joint named would stay open by the residual",
        time);
  } else {
    failure.what =
        "the motion cannot be followed on its branch: at a dead point or change point two branches "
        "meet; keep the driver away from it, or guide the mechanism across";
  }
  failure.details = driver_lines(mechanism, wanted, &reach);
  add_position(mechanism, reach.limited ? reach.q : reached.q,
               reach.limited ? "position at the end of the reach:" : "last position reached:",
               failure.details);
  return failure;
}

}  // namespace boxbeam::planar
