#include "boxbeam/verification/transient_response.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

/// The method's nodes c, its matrix A, A^2 and weights, and of the polynomials that are one at one
/// node and zero at the others the coefficients of 1, u, u^2, a row for each.
struct GaussMethod {
  Eigen::Vector3d nodes, weights, double_weights;
  Eigen::Matrix3d once, twice, bases;
};

const GaussMethod& gauss_method() {
  static const GaussMethod method = [] {
    GaussMethod of;
    const double root = std::sqrt(15.0);
    of.nodes << 0.5 - root / 10.0, 0.5, 0.5 + root / 10.0;
    of.weights << 5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0;
    Eigen::Matrix3d powers;
    for (int j = 0; j < 3; ++j) powers.row(j) << 1.0, of.nodes[j], of.nodes[j] * of.nodes[j];
    // Row j of the inverse's transpose: the polynomial that is one at node j.
    of.bases = powers.inverse().transpose();
    for (int i = 0; i < 3; ++i) {
      const double c = of.nodes[i];
      of.once.row(i) = of.bases * Eigen::Vector3d(c, c * c / 2.0, c * c * c / 3.0);
    }
    of.twice = of.once * of.once;
    of.double_weights = of.once.transpose() * of.weights;
    return of;
  }();
  return method;
}

struct ResponseStep {
  double begin, h, end;  // [s]
};

/// Steps of equal length between neighbouring borders.
std::vector<ResponseStep> steps_between(const std::vector<double>& borders, double longest_step) {
  std::vector<ResponseStep> all;
  for (std::size_t border = 1; border < borders.size(); ++border) {
    const double from = borders[border - 1], length = borders[border] - from;
    const double steps = std::max(1.0, std::ceil(length / longest_step - 1e-9));
    const double h = length / steps;
    const auto count = static_cast<std::size_t>(steps);
    for (std::size_t step = 0; step < count; ++step)
      all.push_back(
          {from + static_cast<double>(step) * h, h,
           step + 1 < count ? from + static_cast<double>(step + 1) * h : borders[border]});
  }
  return all;
}

}  // namespace

TransientResponse::TransientResponse(const EquationsAt& equations,
                                     const std::vector<double>& borders, ModalState start,
                                     double longest_step)
    : times_{borders.front()}, states_{std::move(start)} {
  go_on(equations, borders, longest_step);
}

void TransientResponse::go_on(const EquationsAt& equations, const std::vector<double>& borders,
                              double longest_step) {
  const GaussMethod& gauss = gauss_method();
  const Eigen::Index k = states_.back().eta.size();
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(k, k);
  Eigen::MatrixXd system(stages * k, stages * k);
  Eigen::VectorXd right(stages * k);
  for (const auto& [begin, h, end] : steps_between(borders, longest_step)) {
    const ModalState& known = states_.back();
    for (Eigen::Index i = 0; i < stages; ++i) {
      const ModalEquations at = equations(begin + gauss.nodes[i] * h);
      for (Eigen::Index j = 0; j < stages; ++j) {
        system.block(i * k, j * k, k, k) =
            h * gauss.once(i, j) * at.damping + h * h * gauss.twice(i, j) * at.stiffness;
      }
      system.block(i * k, i * k, k, k) += identity;
      right.segment(i * k, k) = at.force - at.damping * known.speed -
                                at.stiffness * (known.eta + gauss.nodes[i] * h * known.speed);
    }
    const Eigen::VectorXd solved = system.partialPivLu().solve(right);
    Eigen::MatrixXd accelerations = Eigen::MatrixXd::Map(solved.data(), k, stages);
    ModalState next;
    next.eta = known.eta + h * known.speed + h * h * (accelerations * gauss.double_weights);
    next.speed = known.speed + h * (accelerations * gauss.weights);
    accelerations_.push_back(std::move(accelerations));
    states_.push_back(std::move(next));
    times_.push_back(end);
  }
}

void TransientResponse::turn(const Eigen::MatrixXd& by) {
  ModalState& last = states_.back();
  last.eta = by * last.eta;
  last.speed = by * last.speed;
}

UncoupledResponse uncoupled_response(const std::function<Eigen::VectorXd(double time)>& force,
                                     const Eigen::VectorXd& damping,
                                     const Eigen::VectorXd& stiffness,
                                     const std::vector<double>& borders, const ModalState& start,
                                     double longest_step) {
  const GaussMethod& gauss = gauss_method();
  const std::vector<ResponseStep> steps = steps_between(borders, longest_step);
  const auto rows = static_cast<Eigen::Index>(steps.size()) + 1;
  const Eigen::Index k = damping.size();
  UncoupledResponse response{{borders.front()}, {rows, k}, {rows, k}};
  Eigen::VectorXd eta = start.eta, speed = start.speed;
  response.eta.row(0) = eta.transpose();
  response.speed.row(0) = speed.transpose();
  // What the forces of a step's stages, less those of its beginning, add to each mode in it.
  Eigen::MatrixX3d shifts(k, 3), rates(k, 3), beyond(k, 3);
  double known_h = 0.0;
  for (const auto& [begin, h, end] : steps) {
    if (h != known_h) {
      for (Eigen::Index j = 0; j < k; ++j) {
        const Eigen::Matrix3d system = Eigen::Matrix3d::Identity() + h * damping[j] * gauss.once +
                                       h * h * stiffness[j] * gauss.twice;
        const Eigen::Matrix3d inverse = system.inverse();
        shifts.row(j) = h * h * gauss.double_weights.transpose() * inverse;
        rates.row(j) = h * gauss.weights.transpose() * inverse;
      }
      known_h = h;
    }
    for (Eigen::Index i = 0; i < 3; ++i) {
      beyond.col(i) = force(begin + gauss.nodes[i] * h) - damping.cwiseProduct(speed) -
                      stiffness.cwiseProduct(eta + gauss.nodes[i] * h * speed);
    }
    eta += h * speed + shifts.cwiseProduct(beyond).rowwise().sum();
    speed += rates.cwiseProduct(beyond).rowwise().sum();
    const auto row = static_cast<Eigen::Index>(response.times.size());
    response.eta.row(row) = eta.transpose();
    response.speed.row(row) = speed.transpose();
    response.times.push_back(end);
  }
  return response;
}

ModalState TransientResponse::at(double time) const {
  if (time <= times_.front()) return states_.front();
  if (time >= times_.back()) return states_.back();
  const auto step = static_cast<std::size_t>(std::upper_bound(times_.begin(), times_.end(), time) -
                                             times_.begin() - 1);
  const double h = times_[step + 1] - times_[step];
  const double u = (time - times_[step]) / h;
  const Eigen::Matrix3d& bases = gauss_method().bases;
  const Eigen::Vector3d once = bases * Eigen::Vector3d(u, u * u / 2.0, u * u * u / 3.0);
  const Eigen::Vector3d twice =
      bases * Eigen::Vector3d(u * u / 2.0, u * u * u / 6.0, u * u * u * u / 12.0);
  const ModalState& known = states_[step];
  return {known.eta + u * h * known.speed + h * h * (accelerations_[step] * twice),
          known.speed + h * (accelerations_[step] * once)};
}

ModalState resting(const ModalEquations& equations) {
  // Far below what the stiffness of a mode that is counted is beside that of another.
  constexpr double none = 1e-12;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> stiffness;
  stiffness.setThreshold(none);
  stiffness.compute(equations.stiffness);
  return {stiffness.solve(equations.force), Eigen::VectorXd::Zero(equations.force.size())};
}

ModalState moving_with(const std::array<Eigen::VectorXd, 3>& eta, double h) {
  return {eta[0], (-3.0 * eta[0] + 4.0 * eta[1] - eta[2]) / (2.0 * h)};
}

}  // namespace boxbeam
