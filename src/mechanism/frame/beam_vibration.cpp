#include "boxbeam/mechanism/frame/beam_vibration.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/section/cut_forces.hpp"
#include "geometric_stiffness.hpp"
#include "rigid_arms.hpp"

namespace boxbeam::frame {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Matrix6x12 = Eigen::Matrix<double, 6, 12>;

struct QuadraturePoint {
  double at, weight;
};

/// Five Gauss points, in order.
std::vector<QuadraturePoint> five_points(double from, double to) {
  using Rule = boost::math::quadrature::gauss<double, 5>;
  std::vector<QuadraturePoint> points;
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    const double u = Rule::abscissa()[i], weight = half * Rule::weights()[i];
    points.push_back({middle + half * u, weight});
    if (u > 0.0) points.push_back({middle - half * u, weight});
  }
  std::sort(points.begin(), points.end(),
            [](const QuadraturePoint& a, const QuadraturePoint& b) { return a.at < b.at; });
  return points;
}

Matrix6 carry_along(double distance) { return carry(Vector3d(distance, 0.0, 0.0)); }

/// The integral of carry(to - s) f(s) carry(end - s)^T from `from` to `to`, on a piece of the
/// profile.
Matrix6 give_between(const FlexibilityProfile& profile, std::size_t piece, double from, double to,
                     double end) {
  Matrix6 sum = Matrix6::Zero();
  for (const QuadraturePoint& point : five_points(from, to)) {
    sum += point.weight * carry_along(to - point.at) * profile.at(piece, point.at) *
           carry_along(end - point.at).transpose();
  }
  return sum;
}

/// Mass per length against shifts and turns.
Matrix6 inertia_at(const SegmentMass& mass, double x, bool rotary) {
  Matrix6 of = Matrix6::Zero();
  of.topLeftCorner<3, 3>().diagonal().setConstant(mass.mass(x));
  const double y = mass.rotary_y(x), z = mass.rotary_z(x), yz = mass.rotary_yz(x);
  of(3, 3) = y + z;
  if (!rotary) return of;
  of(4, 4) = y;
  of(5, 5) = z;
  of(4, 5) = of(5, 4) = -yz;
  return of;
}

std::vector<SegmentMass> with_rotary_inertia(TaperedBeam beam) {
  beam.rotary_inertia = true;
  return mass_distribution_of(beam);
}

[[noreturn]] void refuse(const char* what) { throw AnalysisError({what, "beam", {}, {}, {}}); }

/// The cubic with these values and slopes at both ends of [0, h].
Polynomial<5> cubic_between(double first, double first_slope, double last, double last_slope,
                            double h) {
  const double mean = (last - first) / h;
  return {{first, first_slope, (3.0 * mean - 2.0 * first_slope - last_slope) / h,
           (first_slope + last_slope - 2.0 * mean) / (h * h)}};
}

Polynomial<4> line_between(double first, double last, double h) {
  return {{first, (last - first) / h}};
}

}  // namespace

VibratingBeam::VibratingBeam(const TaperedBeam& beam, double youngs_modulus, double shear_modulus,
                             std::vector<double> held, int parts)
    : beam_(&beam), length_(beam.length().value()), rotary_(beam.rotary_inertia) {
  bool twisted = true;
  for (const Segment& segment : beam.segments)
    twisted = twisted && twists(segment.from) && twists(segment.to);
  const FlexibilityProfile profile(beam, youngs_modulus, shear_modulus, twisted);
  const std::vector<SegmentMass> masses = with_rotary_inertia(beam);
  held.insert(held.end(), {0.0, length_});
  for (const Segment& segment : beam.segments) held.push_back(segment.start.value());
  for (double& s : held) s = std::clamp(s, 0.0, length_);
  std::sort(held.begin(), held.end());
  // What is nearer to each other than this is tied by an arm along the axis.
  const double least = 1e-3 * length_;
  std::vector<double> borders;
  for (const double s : held)
    if (borders.empty() || s - borders.back() > least) borders.push_back(s);
  borders.back() = length_;
  nodes_ = {0.0};
  for (std::size_t k = 1; k < borders.size(); ++k) {
    const double h = borders[k] - borders[k - 1];
    const int count = std::max(1, static_cast<int>(std::ceil(parts * h / length_ - 1e-9)));
    for (int i = 1; i <= count; ++i) {
      nodes_.push_back(i == count ? borders[k] : borders[k - 1] + h * i / count);
      add_piece(nodes_[nodes_.size() - 2], nodes_.back(), profile, masses, twisted);
    }
  }
}

void VibratingBeam::add_piece(double from, double to, const FlexibilityProfile& profile,
                              const std::vector<SegmentMass>& masses, bool twisted) {
  Piece& piece = pieces_.emplace_back();
  piece.from = from;
  piece.to = to;
  /// What the end forces move the section at a point beyond where the start carries it.
  struct Point {
    QuadraturePoint on;
    std::size_t of_profile;
    Matrix6 give;
  };
  std::vector<Point> points;
  Matrix6 give = Matrix6::Zero();
  double last = from;
  const std::vector<double>& borders = profile.borders();
  for (std::size_t k = 0; k + 1 < borders.size(); ++k) {
    const double first = std::max(from, borders[k]), end = std::min(to, borders[k + 1]);
    if (!(first < end)) continue;
    const auto go_to = [&](double s) {
      give = carry_along(s - last) * give + give_between(profile, k, last, s, to);
      last = s;
    };
    for (const QuadraturePoint& point : five_points(first, end)) {
      go_to(point.at);
      points.push_back({point, k, give});
    }
    go_to(end);
  }
  Matrix6 F = 0.5 * (give + give.transpose());
  constexpr double as_good_as_rigid = 1e-6;
  if (!twisted) F(3, 3) = as_good_as_rigid * 0.5 * (F(4, 4) + F(5, 5));
  const Matrix6 stiffness = F.inverse();
  Matrix6x12 fit;
  fit << -carry_along(to - from), Matrix6::Identity();
  const Matrix6x12 at_end = stiffness * fit;
  piece.stiffness = fit.transpose() * at_end;
  piece.stiffness = (0.5 * (piece.stiffness + piece.stiffness.transpose())).eval();
  for (const Point& point : points) {
    const double s = point.on.at;
    Matrix6x12 motion = point.give * at_end;
    motion.leftCols<6>() += carry_along(s - from);
    const std::size_t segment = segment_at(*beam_, {si<Length>(s)});
    const double x = s - beam_->segments[segment].start.value();
    piece.mass +=
        point.on.weight * motion.transpose() * inertia_at(masses[segment], x, rotary_) * motion;
    Sample& sample = piece.samples.emplace_back();
    sample.weight = point.on.weight;
    sample.cut = carry_along(to - s).transpose() * at_end;
    sample.strain = profile.at(point.of_profile, s) * sample.cut;
    stations_.push_back({si<Length>(s)});
  }
}

std::size_t VibratingBeam::node_of(double s) const {
  const auto nearest = std::min_element(nodes_.begin(), nodes_.end(), [&](double a, double b) {
    return std::abs(a - s) < std::abs(b - s);
  });
  return static_cast<std::size_t>(nearest - nodes_.begin());
}

std::vector<BeamMode> VibratingBeam::modes(const std::vector<RigidMass>& bodies,
                                           const std::vector<Tie>& ties,
                                           const CutForceDiagram& rigid, std::size_t count) const {
  const auto on_beam = static_cast<Index>(6 * nodes_.size());
  const Index size = on_beam + static_cast<Index>(6 * bodies.size());
  MatrixXd K = MatrixXd::Zero(size, size), M = K, C = K, springs = K;
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const Piece& piece = pieces_[p];
    const double h = piece.to - piece.from;
    const double N = rigid.at({si<Length>(0.5 * (piece.from + piece.to))}).N.value();
    const auto at = static_cast<Index>(6 * p);
    K.block<12, 12>(at, at) += piece.stiffness + geometric_block(N, h);
    M.block<12, 12>(at, at) += piece.mass;
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Index at = on_beam + static_cast<Index>(6 * b);
    M.block<3, 3>(at, at).diagonal().setConstant(bodies[b].mass);
    M.block<3, 3>(at + 3, at + 3) = bodies[b].inertia;
  }
  std::vector<VectorXd> held;
  for (const Tie& tie : ties) {
    VectorXd gap = VectorXd::Zero(size);
    for (const Tie::End& end : tie.ends) {
      if (end.at.member == ground) continue;
      Index at = 0;
      Vector3d from;
      if (end.at.member == 0) {
        const std::size_t node = node_of(end.at.p.x());
        at = static_cast<Index>(6 * node);
        from = {nodes_[node], 0.0, 0.0};
      } else {
        const auto body = static_cast<std::size_t>(end.at.member - 1);
        at = on_beam + static_cast<Index>(6 * body);
        from = bodies[body].centre;
      }
      gap.segment<6>(at) += carry(end.at.p - from).transpose() * end.per;
    }
    if (std::isinf(tie.stiffness)) {
      held.push_back(std::move(gap));
    } else {
      if (tie.stiffness != 0.0) springs += tie.stiffness * gap * gap.transpose();
      if (tie.damping != 0.0) C += tie.damping * gap * gap.transpose();
    }
  }
  K += springs;
  // Shifts by the length of the beam, as turns.
  VectorXd unit = VectorXd::Ones(size);
  for (Index k = 0; k < size; ++k)
    if (k % 6 < 3) unit[k] = length_;
  MatrixXd free = MatrixXd::Identity(size, size);
  if (!held.empty()) {
    MatrixXd G(size, static_cast<Index>(held.size()));
    for (std::size_t k = 0; k < held.size(); ++k) {
      const VectorXd row = held[k].cwiseProduct(unit);
      const double norm = row.norm();
      // Of the ground alone: nothing moves.
      G.col(static_cast<Index>(k)) = norm > 0.0 ? VectorXd(row / norm) : row;
    }
    Eigen::ColPivHouseholderQR<MatrixXd> solver;
    constexpr double repeats = 1e-9;
    solver.setThreshold(repeats);
    solver.compute(G);
    const Index left = size - solver.rank();
    if (left == 0) return {};
    const MatrixXd whole = solver.householderQ() * MatrixXd::Identity(size, size);
    free = whole.rightCols(left);
  }
  free = (unit.asDiagonal() * free).eval();
  const MatrixXd stiffness = free.transpose() * K * free, mass = free.transpose() * M * free;
  const Eigen::LLT<MatrixXd> factor(stiffness);
  if (factor.info() != Eigen::Success)
    refuse("with its drivers held it is free to move, or buckles");
  // Of M x = mu K x the largest mu are those of the lowest frequencies; what has no mass has none.
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(mass, stiffness);
  if (solver.info() != Eigen::Success) refuse("its modes are not found");
  const double round_off = 1e-15 * stiffness.norm();
  std::vector<BeamMode> modes;
  for (Index k = stiffness.rows(); k-- > 0 && modes.size() < count;) {
    const double mu = solver.eigenvalues()[k];
    if (!(mu > 1e-12 * solver.eigenvalues()[stiffness.rows() - 1])) break;
    const VectorXd x = solver.eigenvectors().col(k);  // of elastic energy one half
    if (round_off * x.squaredNorm() > 1e-3) refuse("with its drivers held it is free to move");
    const VectorXd motion = free * x / std::sqrt(mu);
    BeamMode& mode = modes.emplace_back(mode_of(motion.head(on_beam), 1.0 / std::sqrt(mu), rigid));
    mode.damping = motion.dot(C * motion);
    mode.energy.back() = mu * motion.dot(springs * motion);
  }
  return modes;
}

BeamMode VibratingBeam::mode_of(const VectorXd& motion, double omega,
                                const CutForceDiagram& rigid) const {
  constexpr Index N = cut_force::N, V_y = cut_force::V_y, V_z = cut_force::V_z, T = cut_force::T,
                  M_y = cut_force::M_y, M_z = cut_force::M_z;
  BeamMode mode;
  mode.frequency = omega / full_turn;
  mode.work = VectorXd(static_cast<Index>(6 * stations_.size()));
  Index at = 0;
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const Piece& piece = pieces_[p];
    const double h = piece.to - piece.from;
    const Eigen::Matrix<double, 12, 1> ends = motion.segment<12>(static_cast<Index>(6 * p));
    const double axial = rigid.at({si<Length>(0.5 * (piece.from + piece.to))}).N.value();
    // What its neighbours do to its ends: elasticity, axial force and inertia together.
    const Eigen::Matrix<double, 12, 1> forces =
        (piece.stiffness + geometric_block(axial, h) - omega * omega * piece.mass) * ends;
    const Vector6 first = -forces.head<6>(), last = forces.tail<6>();
    CutForcePiece& cut = mode.cut.pieces.emplace_back();
    cut.start = si<Length>(piece.from);
    cut.length = si<Length>(h);
    cut.N = line_between(first[N], last[N], h);
    cut.V_y = line_between(first[V_y], last[V_y], h);
    cut.V_z = line_between(first[V_z], last[V_z], h);
    const double twist = (last[T] - first[T]) / h;
    cut.T = {{first[T], twist}};
    cut.M_y = cubic_between(first[M_y], first[V_z], last[M_y], last[V_z], h);
    cut.M_z = cubic_between(first[M_z], -first[V_y], last[M_z], -last[V_y], h);
    for (const Sample& sample : piece.samples) {
      const Vector6 strain = sample.strain * ends, force = sample.cut * ends;
      mode.work.segment<6>(at) = sample.weight * strain;
      at += 6;
      const Vector6 energy = sample.weight * force.cwiseProduct(strain) / (omega * omega);
      mode.energy[0] += energy[N];
      mode.energy[1] += energy[M_y] + energy[V_z];
      mode.energy[2] += energy[M_z] + energy[V_y];
      mode.energy[3] += energy[T];
    }
  }
  return mode;
}

}  // namespace boxbeam::frame
