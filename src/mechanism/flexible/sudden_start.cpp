#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "boxbeam/core/error.hpp"
#include "frequency.hpp"
#include "modal_parts.hpp"

namespace boxbeam::flexible {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

namespace {

/// The equations of motion of the modes under the harmonic loads, state' = A state with the state
/// omega_j eta_j, eta_j', sin(omega t), cos(omega t) and the loads of size one.
struct StartEquations {
  MatrixXd A;
  VectorXd scale;
  double size = 1.0;

  Index modes() const { return scale.size(); }
  auto accelerations() const { return A.middleRows(modes(), modes()); }
};

StartEquations start_equations_of(const ModalModel& model) {
  const VectorXcd loads = modal_loads_of(model).p;
  const VectorXd squares = squares_of(model);
  const double omega = omega_of(model.structure->mechanism->frequency);
  const Index count = squares.size();
  StartEquations equations;
  equations.scale = squares.cwiseSqrt();
  for (double& of : equations.scale) {
    if (of == 0.0) of = 1.0;
  }
  const double largest = loads.size() > 0 ? loads.cwiseAbs().maxCoeff() : 0.0;
  if (largest > 0.0) equations.size = largest;
  MatrixXd& A = equations.A;
  A = MatrixXd::Zero(2 * count + 2, 2 * count + 2);
  A.topRows(count).middleCols(count, count) = equations.scale.asDiagonal();
  auto rates = A.middleRows(count, count);
  rates.leftCols(count) = -squares.cwiseQuotient(equations.scale).asDiagonal().toDenseMatrix();
  rates.middleCols(count, count) = -model.damping;
  rates.col(2 * count) = loads.real() / equations.size;
  rates.col(2 * count + 1) = loads.imag() / equations.size;
  A(2 * count, 2 * count + 1) = omega;
  A(2 * count + 1, 2 * count) = -omega;
  return equations;
}

}  // namespace

StartShares start_shares_of(const ModalModel& model) {
  const VectorXcd loads = modal_loads_of(model).p;
  const VectorXd squares = squares_of(model);
  const double omega = omega_of(model.structure->mechanism->frequency);
  StartShares shares{VectorXd::Zero(squares.size()), VectorXd::Zero(squares.size())};
  for (Index j = 0; j < squares.size(); ++j) {
    if (!(squares[j] > 0.0)) continue;
    const double own = std::sqrt(squares[j]), r = omega / own;
    const double to = own * std::abs(Complex(1.0 - r * r, model.damping(j, j) * r / own));
    if (!(to > 0.0)) continue;
    shares.free[j] = std::hypot(r * loads[j].real(), loads[j].imag()) / to;
    shares.driven[j] = std::abs(loads[j]) / to;
  }
  const double largest =
      squares.size() == 0 ? 0.0 : std::max(shares.free.maxCoeff(), shares.driven.maxCoeff());
  if (largest > 0.0) {
    shares.free /= largest;
    shares.driven /= largest;
  }
  return shares;
}

SuddenStart sudden_start_of(const ModalModel& model, double length, std::size_t steps) {
  assert(steps > 0);
  const Structure& structure = *model.structure;
  const Recovery recovery = recovery_of(model, true);
  const StartEquations equations = start_equations_of(model);
  const Index count = equations.modes();
  const MatrixXd step = (length / static_cast<double>(steps) * equations.A).exp();

  VectorXd state = VectorXd::Zero(2 * count + 2);
  state[2 * count + 1] = 1.0;
  const Deformation<double> constant = static_response(structure);
  SuddenStart start;
  start.joints.resize(structure.joints.size());
  for (std::size_t i = 0; i <= steps; ++i) {
    start.times.push_back(length * static_cast<double>(i) / static_cast<double>(steps));
    const VectorXd place = equations.size * state.head(count).cwiseQuotient(equations.scale);
    const VectorXd speed = equations.size * state.segment(count, count);
    const VectorXd acceleration = equations.size * (equations.accelerations() * state);
    const Complex turn(state[2 * count + 1], state[2 * count]);
    Deformation<double> now;
    now.joints = constant.joints + (turn * recovery.of_loads.joints).imag() +
                 joints_of(model, recovery, recovery.x(place, acceleration), speed);
    for (std::size_t j = 0; j < start.joints.size(); ++j) {
      start.joints[j].push_back(joint_force(structure, j, now));
    }
    state = step * state;
  }
  return start;
}

SuddenStartModes::SuddenStartModes(const ModalModel& model)
    : modes_(model.modes),
      constant_(static_response(*model.structure)),
      omega_(omega_of(model.structure->mechanism->frequency)) {
  const VectorXd squares = squares_of(model);
  if (squares.size() > 0 && squares.minCoeff() <= 0.0) {
    throw AnalysisError(
        {"the structure can move without strain: a sudden start of it is not known; hold it, or "
         "leave out sudden_start",
         "mechanism"});
  }
  Recovery recovery = recovery_of(model, true);
  of_loads_ = std::move(recovery.of_loads);
  of_speeds_ = std::move(recovery.of_speed);
  const StartEquations equations = start_equations_of(model);
  // No mode is without strain and none in resonance: the eigenvectors span the state.
  const Eigen::EigenSolver<MatrixXd> solver(equations.A);
  const VectorXcd& all = solver.eigenvalues();
  const Index size = all.size(), count = squares.size();
  VectorXcd start = VectorXcd::Zero(size);
  start[size - 1] = 1.0;
  const MatrixXcd vectors = solver.eigenvectors();
  MatrixXcd parts = vectors * vectors.partialPivLu().solve(start).asDiagonal();
  // Of each pair that is conjugate, whose sum is real, twice the real part of one.
  std::vector<Index> kept;
  for (Index k = 0; k < size; ++k) {
    if (all[k].imag() < 0.0) continue;
    if (all[k].imag() > 0.0) parts.col(k) *= 2.0;
    kept.push_back(k);
  }
  exponents_ = all(kept);
  const auto waves = static_cast<Index>(kept.size());
  MatrixXd states(size, 2 * waves);  // of the waves' real and imaginary parts
  states << parts.real()(Eigen::all, kept), -parts.imag()(Eigen::all, kept);
  of_waves_.resize(2 * count, 2 * waves);
  of_waves_ << -(squares.cwiseInverse().asDiagonal() * (equations.accelerations() * states)),
      states.middleRows(count, count);
  of_waves_ *= equations.size;
}

StartNow SuddenStartModes::at(double time) const {
  const VectorXcd waves = (time * exponents_).array().exp();
  VectorXd parts(2 * waves.size());
  parts << waves.real(), waves.imag();
  const VectorXd values = of_waves_ * parts;
  const Index count = values.size() / 2;
  return {std::polar(1.0, omega_ * time), values.head(count), values.tail(count)};
}

}  // namespace boxbeam::flexible
