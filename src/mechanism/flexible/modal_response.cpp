#include "boxbeam/mechanism/flexible/modal_response.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>
#include <unsupported/Eigen/MatrixFunctions>

#include "boxbeam/core/error.hpp"
#include "frequency.hpp"

namespace boxbeam::flexible {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXcd;
using Eigen::VectorXd;

/// A load on a mode below this part of what it could be is round-off.
constexpr double no_load = 1e-10;
/// The shift, over the lowest omega^2 with strain, by which structures that move freely are solved,
/// and the steps that take it out again.
constexpr double shift = 1e-4;
constexpr int steps_of_shift = 6;

VectorXd squares_of(const ModalModel& model) {
  VectorXd squares(static_cast<Index>(model.modes.size()));
  for (Index j = 0; j < squares.size(); ++j) {
    squares[j] = std::pow(omega_of(model.modes[static_cast<std::size_t>(j)].frequency), 2);
  }
  return squares;
}

template <class Scalar>
Scalar dot(const LinkColumns<double>& a, const LinkColumns<Scalar>& b) {
  Scalar sum{};
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k].cwiseProduct(b[k]).sum();
  return sum;
}

template <class Scalar>
void add(const LinkColumns<double>& columns, Scalar factor, LinkColumns<Scalar>& sum) {
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += factor * columns[k];
}

/// What damps: a spring of a link or a joint. Its force is c times the rate of its strain, which is
/// the sum of G q over the elements it takes hold of.
struct Damper {
  struct End {
    std::size_t link, element;
    Matrix3d G;
  };
  Matrix3d c = Matrix3d::Zero();
  std::vector<End> ends;
  bool is_joint = false;
  std::size_t joint = 0;
};

void add_dampers_of_link(const Structure& structure, std::size_t k, std::vector<Damper>& dampers) {
  const double retardation = structure.mechanism->links[k].retardation;
  if (retardation == 0.0) return;
  const DividedLink& link = structure.links[k];
  for (std::size_t i = 0; i < link.springs.size(); ++i) {
    const SpringElement& spring = link.springs[i];
    Damper damper;
    if (spring.axial > 0.0) damper.c(0, 0) = retardation / spring.axial;
    if (!spring.bending.isZero(0.0)) {
      damper.c.bottomRightCorner<2, 2>() = retardation * spring.bending.inverse();
    }
    for (const std::size_t element : {i, i + 1}) {
      Matrix3d G = Matrix3d::Identity();
      G(1, 2) = spring.place - link.elements[element].node;
      damper.ends.push_back({k, element, element == i ? Matrix3d(-G) : G});
    }
    dampers.push_back(damper);
  }
}

void add_damper_of_joint(const Structure& structure, std::size_t j, std::vector<Damper>& dampers) {
  const Joint& joint = structure.mechanism->joints[j];
  const Structure::Ends& ends = structure.joints[j];
  Damper damper;
  damper.is_joint = true;
  damper.joint = j;
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const auto at = static_cast<Index>(axis);
    if (std::isfinite(joint.stiffness[axis])) damper.c(at, at) = joint.damping[axis];
  }
  if (damper.c.isZero(0.0)) return;
  for (const auto& [grip, sign] : {std::pair(&ends.a, -1.0), std::pair(&ends.b, 1.0)}) {
    if (grip->link == ground) continue;
    damper.ends.push_back(
        {static_cast<std::size_t>(grip->link), grip->element, sign * ends.axes * grip->motion});
  }
  dampers.push_back(damper);
}

std::vector<Damper> dampers_of(const Structure& structure) {
  std::vector<Damper> dampers;
  for (std::size_t k = 0; k < structure.links.size(); ++k) {
    add_dampers_of_link(structure, k, dampers);
  }
  for (std::size_t j = 0; j < structure.joints.size(); ++j) {
    add_damper_of_joint(structure, j, dampers);
  }
  return dampers;
}

Vector3d strain_of(const Structure& structure, const Damper& damper,
                   const Deformation<double>& mode) {
  Vector3d strain = Vector3d::Zero();
  for (const Damper::End& end : damper.ends) {
    strain += end.G * mode.motion[end.link].col(static_cast<Index>(end.element));
  }
  if (!damper.is_joint) return strain;
  // The gap of a stiff joint is better known from its force.
  const Joint& joint = structure.mechanism->joints[damper.joint];
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const double stiffness = joint.stiffness[axis];
    if (stiffness == 0.0) continue;
    const auto at = static_cast<Index>(axis);
    strain[at] = mode.joints(at, static_cast<Index>(damper.joint)) / stiffness;
  }
  return strain;
}

/// C times the motion of a mode.
LinkColumns<double> damping_times(const Structure& structure, const std::vector<Damper>& dampers,
                                  const Deformation<double>& mode) {
  LinkColumns<double> forces = no_loads<double>(structure);
  for (const Damper& damper : dampers) {
    const Vector3d force = damper.c * strain_of(structure, damper, mode);
    for (const Damper::End& end : damper.ends) {
      forces[end.link].col(static_cast<Index>(end.element)) += end.G.transpose() * force;
    }
  }
  return forces;
}

/// K^-1. Where motions are without strain: of what their inertia leaves of loads, the answer
/// without any part in them.
class StaticSolver {
 public:
  explicit StaticSolver(const ModalModel& model) : structure_(*model.structure) {
    double lowest = 0.0;
    for (const Mode& mode : model.modes) {
      if (mode.frequency == 0.0) free_.push_back(&mode.shape.motion);
      if (lowest == 0.0) lowest = mode.frequency;
    }
    if (!free_.empty()) {
      if (lowest == 0.0) lowest = modes_of(structure_, free_.size() + 1).back().frequency;
      below_ = lowest > 0.0 ? shift * std::pow(omega_of(lowest), 2) : 1.0;
      if (DynamicStiffness<double>(structure_, below_, 0.0).frequencies_below() > free_.size()) {
        throw AnalysisError(
            {"the modes leave out motions without strain; take more modes", "", {}, {}, {}});
      }
    }
    stiffness_.emplace(structure_, -below_, 0.0);
  }

  template <class Scalar>
  Deformation<Scalar> solve(LinkColumns<Scalar> loads) const {
    for (const LinkColumns<double>* motion : free_) {
      add(mass_times(structure_, *motion), Scalar(-dot(*motion, loads)), loads);
    }
    Deformation<Scalar> result = solved(loads);
    for (int step = 0; step < (free_.empty() ? 0 : steps_of_shift); ++step) {
      LinkColumns<Scalar> shifted = mass_times(structure_, result.motion);
      for (std::size_t k = 0; k < loads.size(); ++k) shifted[k] = loads[k] + below_ * shifted[k];
      result = solved(shifted);
    }
    return result;
  }

 private:
  template <class Scalar>
  Deformation<Scalar> solved(const LinkColumns<Scalar>& loads) const {
    Deformation<Scalar> result = by_parts(loads);
    for (const LinkColumns<double>* motion : free_) {
      add(*motion, Scalar(-dot(mass_times(structure_, *motion), result.motion)), result.motion);
    }
    return result;
  }
  Deformation<double> by_parts(const LinkColumns<double>& loads) const {
    return stiffness_->solve(loads);
  }
  Deformation<Complex> by_parts(const LinkColumns<Complex>& loads) const {
    LinkColumns<double> real, imaginary;
    for (const auto& columns : loads) {
      real.emplace_back(columns.real());
      imaginary.emplace_back(columns.imag());
    }
    const Complex i(0.0, 1.0);
    const Deformation<double> re = stiffness_->solve(real);
    const Deformation<double> im = stiffness_->solve(imaginary);
    Deformation<Complex> result;
    for (std::size_t k = 0; k < loads.size(); ++k) {
      result.motion.emplace_back(re.motion[k] + i * im.motion[k]);
    }
    result.joints = re.joints + i * im.joints;
    return result;
  }

  const Structure& structure_;
  std::vector<const LinkColumns<double>*> free_;
  double below_ = 0.0;
  std::optional<DynamicStiffness<double>> stiffness_;
};

/// How motions and joint forces follow from the coordinates eta of the modes:
///
///     q = K^-1 f + sum of phi_j x_j + sum of r_j eta_j',  x_j = -eta_j''/omega_j^2
///
/// r_j = -K^-1 C phi_j, its joint forces with those that damping itself bears. Without static
/// correction, and where a mode is without strain, x_j = eta_j.
struct Recovery {
  Deformation<Complex> of_loads;
  std::vector<Deformation<double>> of_speed;
  VectorXd flexibility;  ///< 1/omega^2 where x is of the acceleration, else 0

  template <class Vector>
  Vector x(const Vector& place, const Vector& acceleration) const {
    Vector result = -flexibility.cwiseProduct(acceleration);
    for (Index j = 0; j < flexibility.size(); ++j) {
      if (flexibility[j] == 0.0) result[j] = place[j];
    }
    return result;
  }
};

Recovery recovery_of(const ModalModel& model, bool static_correction) {
  const Structure& structure = *model.structure;
  Recovery recovery;
  std::optional<StaticSolver> solver;
  if (static_correction) solver.emplace(model);
  if (solver) {
    recovery.of_loads = solver->solve(harmonic_loads(structure));
  } else {
    recovery.of_loads.motion = no_loads<Complex>(structure);
    recovery.of_loads.joints =
        Eigen::Matrix3Xcd::Zero(3, static_cast<Index>(structure.joints.size()));
  }
  const VectorXd squares = squares_of(model);
  recovery.flexibility = VectorXd::Zero(squares.size());
  for (Index j = 0; static_correction && j < squares.size(); ++j) {
    if (squares[j] > 0.0) recovery.flexibility[j] = 1.0 / squares[j];
  }
  const std::vector<Damper> dampers = dampers_of(structure);
  if (dampers.empty()) return recovery;
  for (const Mode& mode : model.modes) {
    Deformation<double>& of = recovery.of_speed.emplace_back();
    LinkColumns<double> load = damping_times(structure, dampers, mode.shape);
    for (auto& columns : load) columns = -columns;
    if (solver) {
      of = solver->solve(load);
    } else {
      of.motion = no_loads<double>(structure);
      of.joints = Eigen::Matrix3Xd::Zero(3, static_cast<Index>(structure.joints.size()));
    }
    for (const Damper& damper : dampers) {
      if (!damper.is_joint) continue;
      of.joints.col(static_cast<Index>(damper.joint)) +=
          damper.c * strain_of(structure, damper, mode.shape);
    }
  }
  return recovery;
}

/// Joint forces of the modes alone.
template <class Vector>
auto joints_of(const ModalModel& model, const Recovery& recovery, const Vector& x,
               const Vector& speed) {
  using Scalar = typename Vector::Scalar;
  Eigen::Matrix<Scalar, 3, Eigen::Dynamic> joints = Eigen::Matrix<Scalar, 3, Eigen::Dynamic>::Zero(
      3, static_cast<Index>(model.structure->joints.size()));
  for (std::size_t j = 0; j < model.modes.size(); ++j) {
    const auto at = static_cast<Index>(j);
    joints += x[at] * model.modes[j].shape.joints;
    if (!recovery.of_speed.empty()) joints += speed[at] * recovery.of_speed[j].joints;
  }
  return joints;
}

/// phi^T f, and how much it could be: with all loads where the mode moves and turns most.
struct ModalLoads {
  VectorXcd p;
  VectorXd size;
};

ModalLoads modal_loads_of(const ModalModel& model) {
  const LinkColumns<Complex> loads = harmonic_loads(*model.structure);
  Vector3d sum = Vector3d::Zero();
  for (const auto& columns : loads) sum += columns.cwiseAbs().rowwise().sum();
  const auto count = static_cast<Index>(model.modes.size());
  ModalLoads result{VectorXcd::Zero(count), VectorXd::Zero(count)};
  for (Index j = 0; j < count; ++j) {
    const LinkColumns<double>& shape = model.modes[static_cast<std::size_t>(j)].shape.motion;
    result.p[j] = dot(shape, loads);
    double moves = 0.0;
    double turns = 0.0;
    for (const auto& columns : shape) {
      moves = std::max(moves, columns.topRows<2>().cwiseAbs().maxCoeff());
      turns = std::max(turns, columns.row(2).cwiseAbs().maxCoeff());
    }
    result.size[j] = moves * (sum[0] + sum[1]) + turns * sum[2];
  }
  return result;
}

/// Coordinates of the modes in a vibration of the drive's frequency:
/// (Omega^2 - omega^2 + i omega phi^T C phi) eta = phi^T f.
VectorXcd harmonic_coordinates(const ModalModel& model, ModalLoads loads, double frequency) {
  const double omega = omega_of(frequency);
  const VectorXd distance = squares_of(model).array() - omega * omega;
  Eigen::MatrixXcd A = Complex(0.0, omega) * model.damping;
  A.diagonal() += distance;
  for (Index j = 0; j < distance.size(); ++j) {
    if (std::abs(A(j, j)) > resonance * omega * omega) continue;
    if (std::abs(loads.p[j]) > no_load * loads.size[j]) {
      throw AnalysisError(
          {fmt::format("{:.6g} Hz is the natural frequency of mode {}, which the loads excite and "
                       "{} damps: the amplitude has no limit; take another frequency or give "
                       "damping to links or joints",
                       frequency, j + 1, model.damping(j, j) > 0.0 ? "next to nothing" : "nothing"),
           "",
           {},
           {},
           {}});
    }
    A(j, j) = 1.0;  // at rest: what no load excites stays so
    loads.p[j] = 0.0;
  }
  return A.partialPivLu().solve(loads.p);
}

Deformation<Complex> harmonic_by(const ModalModel& model, const Recovery& recovery,
                                 const ModalLoads& loads, double frequency) {
  const double omega = omega_of(frequency);
  const VectorXcd eta = harmonic_coordinates(model, loads, frequency);
  const VectorXcd speed = Complex(0.0, omega) * eta;
  const VectorXcd acceleration = -omega * omega * eta;
  const VectorXcd x = recovery.x(eta, acceleration);
  Deformation<Complex> result = recovery.of_loads;
  result.joints += joints_of(model, recovery, x, speed);
  for (std::size_t j = 0; j < model.modes.size(); ++j) {
    const auto at = static_cast<Index>(j);
    add(model.modes[j].shape.motion, x[at], result.motion);
    if (!recovery.of_speed.empty()) add(recovery.of_speed[j].motion, speed[at], result.motion);
  }
  return result;
}

}  // namespace

ModalModel modal_model_of(const Structure& structure, std::size_t count) {
  ModalModel model{&structure, modes_of(structure, count), {}};
  const auto size = static_cast<Index>(model.modes.size());
  model.damping = MatrixXd::Zero(size, size);
  Eigen::Matrix3Xd strains(3, size);
  for (const Damper& damper : dampers_of(structure)) {
    for (Index j = 0; j < size; ++j) {
      strains.col(j) = strain_of(structure, damper, model.modes[static_cast<std::size_t>(j)].shape);
    }
    model.damping += strains.transpose() * damper.c * strains;
  }
  return model;
}

Deformation<Complex> harmonic_response(const ModalModel& model, double frequency,
                                       bool static_correction) {
  return harmonic_by(model, recovery_of(model, static_correction), modal_loads_of(model),
                     frequency);
}

Sweep sweep_of(const ModalModel& model, const std::vector<double>& frequencies) {
  const Recovery recovery = recovery_of(model, true);
  const ModalLoads loads = modal_loads_of(model);
  Sweep sweep{frequencies, {}};
  sweep.joints.resize(model.structure->joints.size());
  for (const double frequency : frequencies) {
    const Deformation<Complex> response = harmonic_by(model, recovery, loads, frequency);
    for (std::size_t j = 0; j < sweep.joints.size(); ++j) {
      sweep.joints[j].push_back(joint_force(*model.structure, j, response));
    }
  }
  return sweep;
}

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
      omega_(omega_of(model.structure->mechanism->frequency)),
      squares_(squares_of(model)) {
  if (squares_.size() > 0 && squares_.minCoeff() <= 0.0) {
    throw AnalysisError(
        {"the structure can move without strain: a sudden start of it is not known; hold it, or "
         "leave out sudden_start",
         "mechanism",
         {},
         {},
         {}});
  }
  Recovery recovery = recovery_of(model, true);
  of_loads_ = std::move(recovery.of_loads);
  of_speeds_ = std::move(recovery.of_speed);
  const StartEquations equations = start_equations_of(model);
  rates_ = equations.accelerations();
  scale_ = equations.scale;
  size_ = equations.size;
  // No mode is without strain and none in resonance: the eigenvectors span the state.
  const Eigen::EigenSolver<MatrixXd> solver(equations.A);
  exponents_ = solver.eigenvalues();
  eigenvectors_ = solver.eigenvectors();
  VectorXcd start = VectorXcd::Zero(exponents_.size());
  start[start.size() - 1] = 1.0;
  eigenvectors_ = (eigenvectors_ * eigenvectors_.partialPivLu().solve(start).asDiagonal()).eval();
}

StartNow SuddenStartModes::at(double time) const {
  const Index count = squares_.size();
  const VectorXd state = (eigenvectors_ * (time * exponents_).array().exp().matrix()).real();
  StartNow now;
  now.turn = std::polar(1.0, omega_ * time);
  now.speed = size_ * state.segment(count, count);
  now.x = -(size_ * (rates_ * state)).cwiseQuotient(squares_);
  return now;
}

}  // namespace boxbeam::flexible
