#include "boxbeam/mechanism/flexible/modal_response.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "boxbeam/core/error.hpp"
#include "exact_damping.hpp"
#include "frequency.hpp"
#include "modal_parts.hpp"

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

/// By the static springs of the link's parts. Of the exact form that is all that motions of nodes
/// feel of its damping, for between them they follow statically.
void add_dampers_of_link(const Structure& structure, std::size_t k, std::vector<Damper>& dampers) {
  const double retardation = structure.mechanism->links[k].retardation;
  if (retardation == 0.0) return;
  const auto link = link_stiffness_of<double>(structure, k, 0.0, 0.0);
  for (std::size_t i = 0; i + 1 < link.nodes(); ++i) {
    const PartFlexibility<double> part = link.part(i);
    Damper damper;
    if (part.axial > 0.0) damper.c(0, 0) = retardation / part.axial;
    Eigen::Matrix2d bending;
    bending << part.f11, part.f12, part.f12, part.f22;
    if (!bending.isZero(0.0)) damper.c.bottomRightCorner<2, 2>() = retardation * bending.inverse();
    for (const auto& [element, lever, sign] :
         {std::tuple(i, part.from_start, -1.0), std::tuple(i + 1, part.from_end, 1.0)}) {
      Matrix3d G = Matrix3d::Identity();
      G(1, 2) = lever;
      damper.ends.push_back({k, element, sign * G});
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
        throw AnalysisError({"the modes leave out motions without strain; take more modes", ""});
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

}  // namespace

VectorXd squares_of(const ModalModel& model) {
  VectorXd squares(static_cast<Index>(model.modes.size()));
  for (Index j = 0; j < squares.size(); ++j) {
    squares[j] = std::pow(omega_of(model.modes[static_cast<std::size_t>(j)].frequency), 2);
  }
  return squares;
}

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

namespace {

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
           ""});
    }
    A(j, j) = 1.0;  // at rest: what no load excites stays so
    loads.p[j] = 0.0;
  }
  return A.partialPivLu().solve(loads.p);
}

/// What of the modes is in a response: x and eta' of `Recovery`.
struct InModes {
  VectorXcd x, speed;
};

InModes in_modes(const ModalModel& model, const Recovery& recovery, const ModalLoads& loads,
                 double frequency) {
  const double omega = omega_of(frequency);
  const VectorXcd eta = harmonic_coordinates(model, loads, frequency);
  return {recovery.x<VectorXcd>(eta, -omega * omega * eta), Complex(0.0, omega) * eta};
}

}  // namespace

Deformation<double> static_response_of(const ModalModel& model, const LinkColumns<double>& loads) {
  return StaticSolver(model).solve(loads);
}

std::vector<DampedWay> damped_ways_of(const ModalModel& model) {
  const Structure& structure = *model.structure;
  std::vector<Damper> dampers;
  for (std::size_t j = 0; j < structure.joints.size(); ++j)
    add_damper_of_joint(structure, j, dampers);
  if (dampers.empty()) return {};
  const StaticSolver solver(model);
  std::vector<DampedWay> ways;
  for (const Damper& damper : dampers) {
    Eigen::Matrix3Xd gaps(3, static_cast<Index>(model.modes.size()));
    for (Index j = 0; j < gaps.cols(); ++j)
      gaps.col(j) = strain_of(structure, damper, model.modes[static_cast<std::size_t>(j)].shape);
    for (Index axis = 0; axis < 3; ++axis) {
      if (damper.c(axis, axis) == 0.0) continue;
      LinkColumns<double> pull = no_loads<double>(structure);
      for (const Damper::End& end : damper.ends)
        pull[end.link].col(static_cast<Index>(end.element)) -= end.G.row(axis).transpose();
      DampedWay& way = ways.emplace_back();
      way.damping = damper.c(axis, axis);
      way.gaps = gaps.row(axis).transpose();
      way.pulled = solver.solve(std::move(pull));
      way.pulled.joints(axis, static_cast<Index>(damper.joint)) += 1.0;
    }
  }
  return ways;
}

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
  if (structure.mechanism->element == Element::exact) add_damping_within(structure, model);
  return model;
}

Deformation<Complex> harmonic_response(const ModalModel& model, double frequency,
                                       bool static_correction) {
  const Recovery recovery = recovery_of(model, static_correction);
  const InModes of = in_modes(model, recovery, modal_loads_of(model), frequency);
  Deformation<Complex> result = recovery.of_loads;
  result.joints += joints_of(model, recovery, of.x, of.speed);
  for (std::size_t j = 0; j < model.modes.size(); ++j) {
    const auto at = static_cast<Index>(j);
    add(model.modes[j].shape.motion, of.x[at], result.motion);
    if (!recovery.of_speed.empty()) add(recovery.of_speed[j].motion, of.speed[at], result.motion);
  }
  return result;
}

Sweep sweep_of(const ModalModel& model, const std::vector<double>& frequencies) {
  const Recovery recovery = recovery_of(model, true);
  const ModalLoads loads = modal_loads_of(model);
  Sweep sweep{frequencies, {}};
  sweep.joints.resize(model.structure->joints.size());
  for (const double frequency : frequencies) {
    const InModes of = in_modes(model, recovery, loads, frequency);
    // Nothing but the joints is asked for: the parts of links are many.
    const Deformation<Complex> response{
        {}, recovery.of_loads.joints + joints_of(model, recovery, of.x, of.speed)};
    for (std::size_t j = 0; j < sweep.joints.size(); ++j) {
      sweep.joints[j].push_back(joint_force(*model.structure, j, response));
    }
  }
  return sweep;
}

}  // namespace boxbeam::flexible
