#include "modal_motion.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"

namespace boxbeam {
namespace {

/// First and second derivative at one of N equal steps of a period of 2 pi, N even: entry by the
/// number of steps between.
struct PeriodicDerivatives {
  Eigen::VectorXd first, second;
};

PeriodicDerivatives periodic_derivatives(Eigen::Index n) {
  PeriodicDerivatives d{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
  const double h = full_turn / static_cast<double>(n);
  d.second[0] = -std::numbers::pi * std::numbers::pi / (3.0 * h * h) - 1.0 / 6.0;
  for (Eigen::Index k = 1; k < n; ++k) {
    const double sign = k % 2 == 0 ? 1.0 : -1.0;
    const double half = 0.5 * h * static_cast<double>(k);
    d.first[k] = 0.5 * sign / std::tan(half);
    d.second[k] = -0.5 * sign / std::pow(std::sin(half), 2);
  }
  return d;
}

/// Where a harmonic meets a frequency that nothing damps, coordinates have no limit.
[[noreturn]] void refuse_resonance(double lowest, double period) {
  const double harmonic = std::max(1.0, std::round(lowest * period));
  refuse_vibration(fmt::format(
      "harmonic {:.0f} of the motion, {:.6g} Hz, meets the beam's natural frequency, {:.6g} Hz "
      "at lowest: without damping its vibration has no limit; give [model] a retardation time, "
      "or change the drive",
      harmonic, harmonic / period, lowest));
}

}  // namespace

double lowest_frequency_of(const Eigen::VectorXd& squares) {
  const auto lowest =
      std::find_if(squares.begin(), squares.end(), [](double of) { return of > 0.0; });
  return lowest == squares.end() ? std::numeric_limits<double>::infinity()
                                 : std::sqrt(*lowest) / full_turn;
}

Eigen::VectorXd flexibilities_of(const Eigen::VectorXd& squares) {
  return squares.unaryExpr([](double of) { return of > 0.0 ? 1.0 / of : 0.0; });
}

void require_few_instants(std::size_t instants) {
  // In each of them the bent beam is solved; and of a wave of the loads, which sixteen of them
  // hold, the collocation sees too few where it must leave out most.
  constexpr std::size_t most_instants = 4096;
  if (instants <= most_instants) return;
  refuse_vibration(fmt::format(
      "the motion has {} instants, in each of which the beam would be bent, and {} are the most: "
      "loads that swing so often in one period are not resolved; verify a faster force by "
      "itself, ask for fewer instants, or use --model rigid to have the loads of rigid bodies",
      instants, most_instants));
}

Eigen::Index stride_of(std::size_t instants, std::size_t modes) {
  constexpr std::size_t most_unknowns = 1536;
  std::size_t stride = 1;
  while (instants / stride * modes > most_unknowns && instants % (4 * stride) == 0) stride *= 2;
  return static_cast<Eigen::Index>(stride);
}

void refuse_vibration(const std::string& what) { throw AnalysisError({what, "beam"}); }

void refuse_vibration(const std::string& what, double time) {
  throw AnalysisError({what, "beam", time});
}

Eigen::VectorXd trigonometric_at(const Eigen::MatrixXd& values, double turns) {
  const Eigen::Index n = values.rows();
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(values.cols());
  double weights = 0.0;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double half =
        std::numbers::pi * (turns - static_cast<double>(i) / static_cast<double>(n));
    const double sine = std::sin(half);
    if (std::abs(sine) < 1e-12) return values.row(i).transpose();
    const double weight = (i % 2 == 0 ? 1.0 : -1.0) * std::cos(half) / sine;
    sum += weight * values.row(i).transpose();
    weights += weight;
  }
  return sum / weights;
}

std::vector<LineLoad> on_stretches_of(const std::vector<LineLoad>& lines,
                                      const std::vector<LineLoad>& finer) {
  std::vector<LineLoad> result;
  std::size_t at = 0;
  for (const LineLoad& piece : finer) {
    const Length middle = piece.start + 0.5 * piece.length;
    while (middle > lines[at].start + lines[at].length) ++at;
    const double by = (piece.start - lines[at].start).value();
    LineLoad& line = result.emplace_back();
    line.start = piece.start;
    line.length = piece.length;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      line.force[axis] = shifted(lines[at].force[axis], by);
      line.couple[axis] = shifted(lines[at].couple[axis], by);
    }
    for (std::size_t axis = 0; axis < 2; ++axis)
      for (std::size_t sense = 0; sense < 2; ++sense)
        line.outside[axis][sense] = shifted(lines[at].outside[axis][sense], by);
  }
  return result;
}

void add_mode(BeamLoads& sum, double factor, const BeamLoads& mode) {
  for (const PointLoad& load : mode.points) {
    auto same = std::find_if(sum.points.begin(), sum.points.end(),
                             [&](const PointLoad& other) { return other.s == load.s; });
    if (same == sum.points.end() && load.force.isZero(0.0) && load.moment.isZero(0.0)) continue;
    if (same == sum.points.end()) {
      PointLoad empty;
      empty.s = load.s;
      same = sum.points.insert(same, empty);
    }
    same->force += factor * load.force;
    same->moment += factor * load.moment;
  }
  add(sum.lines, factor, mode.lines);
}

Eigen::MatrixXd nearest_turn(const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& reference) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(shapes.transpose() * reference,
                                              Eigen::ComputeThinU | Eigen::ComputeThinV);
  return svd.matrixU() * svd.matrixV().transpose();
}

Eigen::MatrixXd turn_between(const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& reference,
                             double time) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(shapes.transpose() * reference);
  constexpr double recognised = 0.3;
  if (svd.singularValues().minCoeff() < recognised) {
    refuse_vibration(
        "the modes of the beam change beyond recognition over the motion, so that a few of them "
        "do not describe its vibration; use --model rigid to have the loads of rigid bodies",
        time);
  }
  return nearest_turn(shapes, reference);
}

ModalEquations aligned(const ModalPosture& posture) {
  const Eigen::MatrixXd& turn = posture.turn;
  const Eigen::MatrixXd stiffness = Eigen::MatrixXd(posture.squares.asDiagonal()) + posture.of_size;
  return {turn.transpose() * (posture.damping + posture.of_rate) * turn,
          turn.transpose() * stiffness * turn, turn.transpose() * posture.force};
}

ModalMotion solve_modal_motion(const std::vector<ModalPosture>& postures, double period) {
  const auto n = static_cast<Eigen::Index>(postures.size());
  const Eigen::Index k = postures.front().squares.size();
  // Unknowns: instant by instant the modal coordinates.
  const PeriodicDerivatives d = periodic_derivatives(n);
  const double rate = full_turn / period;
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n * k, n * k);
  Eigen::MatrixXd p(n, k);
  Eigen::MatrixXd statically(n, k);
  std::vector<Eigen::MatrixXd> viscous;  // K^-1 C at the instants
  double lowest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < n; ++i) {
    const ModalPosture& at = postures[static_cast<std::size_t>(i)];
    const Eigen::MatrixXd& turn = at.turn;
    lowest = std::min(lowest, std::sqrt(at.squares[0]) / full_turn);
    const ModalEquations equations = aligned(at);
    p.row(i) = equations.force.transpose();
    statically.row(i) = (turn.transpose() * at.force.cwiseQuotient(at.squares)).transpose();
    viscous.emplace_back(turn.transpose() * at.squares.cwiseInverse().asDiagonal() *
                         at.of_material * turn);
    for (Eigen::Index m = 0; m < n; ++m) {
      const Eigen::Index apart = (i - m + n) % n;
      system.block(i * k, m * k, k, k) =
          rate * d.first[apart] * equations.damping +
          rate * rate * d.second[apart] * Eigen::MatrixXd::Identity(k, k);
    }
    system.block(i * k, i * k, k, k) += equations.stiffness;
  }
  Eigen::VectorXd right(n * k);
  for (Eigen::Index i = 0; i < n; ++i) right.segment(i * k, k) = p.row(i).transpose();
  const Eigen::VectorXd solved = Eigen::PartialPivLU<Eigen::MatrixXd>(system).solve(right);
  ModalMotion motion;
  motion.eta.resize(n, k);
  for (Eigen::Index i = 0; i < n; ++i) motion.eta.row(i) = solved.segment(i * k, k).transpose();
  motion.dynamic = motion.eta - statically;
  motion.speed = Eigen::MatrixXd::Zero(n, k);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index m = 0; m < n; ++m)
      motion.speed.row(i) += rate * d.first[(i - m + n) % n] * motion.eta.row(m);
    motion.dynamic.row(i) += motion.speed.row(i) * viscous[static_cast<std::size_t>(i)].transpose();
  }
  constexpr double no_limit = 1e3;
  const double size = statically.cwiseAbs().maxCoeff();
  if (!motion.eta.allFinite() || motion.eta.cwiseAbs().maxCoeff() > no_limit * size)
    refuse_resonance(lowest, period);
  return motion;
}

}  // namespace boxbeam
