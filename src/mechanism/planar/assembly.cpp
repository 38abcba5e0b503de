#include "boxbeam/mechanism/planar/assembly.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/numerics/halton.hpp"

namespace boxbeam::planar {
namespace {

constexpr int most_iterations = 400;

/// The distance over which the mechanism spreads [m].
double reach_of(const Mechanism& mechanism) {
  std::vector<double> longest(mechanism.bodies.size(), 0.0);
  double beside = 0.0;
  for (const Joint& joint : mechanism.joints) {
    const auto [a, b] = ends_of(joint);
    for (const Attachment& end : {a, b}) {
      if (end.body == ground) continue;
      double& own = longest[static_cast<std::size_t>(end.body)];
      own = std::max(own, end.p.norm());
    }
    if (const auto* distance = std::get_if<Distance>(&joint.kind)) beside += distance->length;
  }
  for (const double own : longest) beside += own;
  return beside > 0.0 ? beside : 1.0;
}

}  // namespace

Assembler::Assembler(const Mechanism& mechanism)
    : mechanism_(&mechanism),
      equations_(mechanism),
      phi_(mechanism.equations()),
      scaled_(mechanism.equations()),
      gradient_(mechanism.coordinates()),
      step_(mechanism.coordinates()),
      trial_(mechanism.coordinates()),
      jacobian_(mechanism.equations(), mechanism.coordinates()) {
  const SparsePattern& pattern = equations_.pattern();
  std::vector<Eigen::Triplet<double>> triplets;
  for (Eigen::Index r = 0; r < pattern.rows; ++r) {
    pattern.in_row(r, [&](std::size_t entry, int column) {
      triplets.emplace_back(r, column, static_cast<double>(entry) + 1.0);
    });
  }
  // The numbers of the entries, sorted into columns: where each value goes.
  jacobian_.setFromTriplets(triplets.begin(), triplets.end());
  for (Eigen::Index c = 0; c < jacobian_.outerSize(); ++c) {
    for (Eigen::SparseMatrix<double>::InnerIterator it(jacobian_, c); it; ++it) {
      order_.push_back(static_cast<std::size_t>(it.value()) - 1);
      scale_.push_back(equations_.row_scale()[it.row()] * equations_.col_scale()[c]);
    }
  }
}

double Assembler::merit_at(const Eigen::VectorXd& q) {
  equations_.set_position(q);
  equations_.evaluate(phi_);
  scaled_ = phi_.cwiseProduct(equations_.row_scale());
  return scaled_.squaredNorm();
}

void Assembler::linearise() {
  equations_.evaluate(phi_, values_);
  scaled_ = phi_.cwiseProduct(equations_.row_scale());
  double* const value = jacobian_.valuePtr();
  for (std::size_t i = 0; i < order_.size(); ++i) {
    value[i] = values_[order_[i]] * scale_[i];
  }
  gradient_ = jacobian_.transpose() * scaled_;
  normal_ = jacobian_.transpose() * jacobian_;
}

Assembly Assembler::assemble(double time, const Eigen::VectorXd& start) {
  equations_.set_time(time);
  return search(start);
}

Assembly Assembler::assemble_at(const std::vector<double>& driver_values,
                                const Eigen::VectorXd& start) {
  equations_.set_driver_values(driver_values);
  return search(start);
}

Assembly Assembler::search(const Eigen::VectorXd& start) {
  constexpr double closed = 1e-13;  // scaled residual that is round-off
  constexpr double good = 1e-11;    // and what counts as closed when no step helps any more
  Eigen::SparseMatrix<double> identity(mechanism_->coordinates(), mechanism_->coordinates());
  identity.setIdentity();
  Assembly result;
  result.q = start;
  double merit = merit_at(result.q);
  linearise();
  double damping = 1e-3 * std::max(1.0, merit);
  double increase = 2.0;
  bool analysed = false;
  for (; result.iterations < most_iterations; ++result.iterations) {
    if (scaled_.lpNorm<Eigen::Infinity>() < closed) break;
    const Eigen::SparseMatrix<double> damped = normal_ + damping * identity;
    if (!analysed) solver_.analyzePattern(damped);
    analysed = true;
    solver_.factorize(damped);
    step_ = solver_.solve(gradient_);
    if (solver_.info() != Eigen::Success || !step_.allFinite()) {
      damping *= 100.0;
      continue;
    }
    if (step_.lpNorm<Eigen::Infinity>() < 1e-15) break;
    const double predicted = step_.dot(damping * step_ + gradient_);
    trial_ = result.q - step_.cwiseProduct(equations_.col_scale());
    const double trial_merit = merit_at(trial_);
    const double gain = (merit - trial_merit) / predicted;
    if (trial_merit < merit) {
      result.q = trial_;
      const bool settled = merit - trial_merit < 1e-14 * merit;
      merit = trial_merit;
      linearise();
      const double slower = 2.0 * gain - 1.0;
      damping *= std::max(1.0 / 3.0, 1.0 - slower * slower * slower);
      // Towards a zero the damping must vanish as the residual does, for quadratic convergence.
      damping = std::min(damping, std::max(1e-2 * std::sqrt(merit), 1e-16));
      increase = 2.0;
      if (settled && merit > good * good) break;  // a closest approach that is none
    } else {
      equations_.set_position(result.q);
      equations_.evaluate(phi_);
      scaled_ = phi_.cwiseProduct(equations_.row_scale());
      damping = std::max(damping, 1e-14) * increase;
      increase *= 2.0;
      if (damping > 1e8) break;
    }
  }
  double largest = -1.0;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < mechanism_->joints.size(); ++i) {
    const int count = equations_of(mechanism_->joints[i]);
    const double open = scaled_.segment(row, count).norm();
    if (open > largest) {
      largest = open;
      result.joint = static_cast<int>(i);
      result.gap = phi_.segment(row, count).norm();
    }
    row += count;
  }
  result.closed = scaled_.lpNorm<Eigen::Infinity>() < good;
  return result;
}

double distance_between(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double size) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    const double difference =
        i % 3 == 2 ? std::remainder(a[i] - b[i], full_turn) : (a[i] - b[i]) / size;
    largest = std::max(largest, std::abs(difference));
  }
  return largest;
}

Eigen::VectorXd other_start(const Mechanism& mechanism, const Eigen::VectorXd& sketch, int index) {
  const double reach = reach_of(mechanism);
  Eigen::VectorXd start = sketch;
  const std::vector<double> at = halton_point(index, static_cast<int>(start.size()));
  for (Eigen::Index i = 0; i < start.size(); ++i)
    start[i] += (i % 3 == 2 ? full_turn : reach) * (at[static_cast<std::size_t>(i)] - 0.5);
  return start;
}

Eigen::VectorXd unwound(Eigen::VectorXd q, const Eigen::VectorXd& reference) {
  for (Eigen::Index i = 2; i < q.size(); i += 3) {
    q[i] -= full_turn * std::round((q[i] - reference[i]) / full_turn);
  }
  return q;
}

std::vector<Eigen::VectorXd> list_assemblies(const Mechanism& mechanism, double time, int starts) {
  const Eigen::VectorXd sketch = sketch_of(mechanism);
  const double size = size_of(mechanism);
  Assembler assembler(mechanism);
  std::vector<Eigen::VectorXd> found;
  for (int i = 0; i <= starts; ++i) {
    const Assembly assembly =
        assembler.assemble(time, i == 0 ? sketch : other_start(mechanism, sketch, i));
    if (!assembly.closed) continue;
    const bool known = std::any_of(found.begin(), found.end(), [&](const Eigen::VectorXd& other) {
      return distance_between(assembly.q, other, size) < 1e-6;
    });
    if (!known) found.push_back(unwound(assembly.q, sketch));
  }
  return found;
}

}  // namespace boxbeam::planar
