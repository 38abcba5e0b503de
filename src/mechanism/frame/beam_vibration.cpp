#include "boxbeam/mechanism/frame/beam_vibration.hpp"

#include <Eigen/Dense>
#include <algorithm>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/cut_forces.hpp"
#include "rigid_arms.hpp"
#include "rigid_ties.hpp"

namespace boxbeam::frame {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6x12 = Eigen::Matrix<double, 6, 12>;
using Matrix12 = VibratingBeam::Matrix12;

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

/// Inertia of a slice per length.
Matrix3d slice_inertia(const SegmentMass& mass, double x) {
  const double y = mass.rotary_y(x), z = mass.rotary_z(x), yz = mass.rotary_yz(x);
  Matrix3d of = Matrix3d::Zero();
  of(0, 0) = y + z;
  of(1, 1) = y;
  of(2, 2) = z;
  of(1, 2) = of(2, 1) = -yz;
  return of;
}

/// Mass per length against shifts and turns.
Matrix6 inertia_at(const SegmentMass& mass, double x, bool rotary) {
  Matrix6 of = Matrix6::Zero();
  of.topLeftCorner<3, 3>().diagonal().setConstant(mass.mass(x));
  const Matrix3d turned = slice_inertia(mass, x);
  if (rotary)
    of.bottomRightCorner<3, 3>() = turned;
  else
    of(3, 3) = turned(0, 0);
  return of;
}

std::vector<SegmentMass> with_rotary_inertia(TaperedBeam beam) {
  beam.rotary_inertia = true;
  return mass_distribution_of(beam);
}

}  // namespace

VibratingBeam::VibratingBeam(const TaperedBeam& beam, double youngs_modulus, double shear_modulus,
                             std::vector<double> held, int parts, double retardation,
                             const std::vector<SegmentMass>& own_masses)
    : beam_(&beam),
      length_(beam.length().value()),
      retardation_(retardation),
      rotary_(beam.rotary_inertia || !own_masses.empty()) {
  bool twisted = true;
  for (const Segment& segment : beam.segments)
    twisted = twisted && twists(segment.from) && twists(segment.to);
  const FlexibilityProfile profile(beam, youngs_modulus, shear_modulus, twisted);
  const std::vector<SegmentMass> masses =
      own_masses.empty() ? with_rotary_inertia(beam) : own_masses;
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
    sample.at = (s - from) / (to - from);
    sample.weight = point.on.weight;
    sample.cut = carry_along(to - s).transpose() * at_end;
    sample.strain = profile.at(point.of_profile, s) * sample.cut;
    sample.motion = motion;
    sample.mass = masses[segment].mass(x);
    sample.inertia = slice_inertia(masses[segment], x);
    stations_.push_back({si<Length>(s)});
  }
  const auto count = static_cast<Index>(piece.samples.size());
  Eigen::MatrixXd powers(count, 3), values(count, 60);
  for (Index i = 0; i < count; ++i) {
    const double u = (points[static_cast<std::size_t>(i)].on.at - from) / (to - from);
    powers.row(i) << 1.0, u, u * u;
    values.row(i) = piece.samples[static_cast<std::size_t>(i)].leaning().reshaped().transpose();
  }
  const Eigen::MatrixXd polynomials = powers.colPivHouseholderQr().solve(values);
  for (std::size_t k = 0; k < 3; ++k)
    piece.leaning[k].reshaped() = polynomials.row(static_cast<Index>(k)).transpose();
}

VibratingBeam::Leaning VibratingBeam::Sample::leaning() const {
  Leaning of;
  of.col(0) = (motion.row(5) + strain.row(cut_force::V_y)).transpose();
  of.col(1) = (-motion.row(4) + strain.row(cut_force::V_z)).transpose();
  of.rightCols<3>() = motion.bottomRows<3>().transpose();
  return of;
}

Eigen::Matrix<double, 6, 12> VibratingBeam::Piece::motion_at(double s) const {
  // A line between the ends, and what bows beside it, u (1 - u) times a cubic.
  constexpr Index bows = 4;
  const auto line = [](double u) {
    Matrix6x12 of;
    of << (1.0 - u) * Matrix6::Identity(), u * Matrix6::Identity();
    return of;
  };
  const auto powers = [](double u) {
    Eigen::Matrix<double, 1, bows> of(1.0, u, u * u, u * u * u);
    return Eigen::Matrix<double, 1, bows>(u * (1.0 - u) * of);
  };
  const auto count = static_cast<Index>(samples.size());
  Eigen::MatrixXd shapes(count, bows), values(count, 72);
  for (Index i = 0; i < count; ++i) {
    const Sample& sample = samples[static_cast<std::size_t>(i)];
    const double u = sample.at;
    shapes.row(i) = powers(u);
    const Matrix6x12 beside = sample.motion - line(u);
    values.row(i) = beside.reshaped().transpose();
  }
  const Eigen::MatrixXd cubic = shapes.colPivHouseholderQr().solve(values);
  const double u = (s - from) / (to - from);
  Matrix6x12 motion = line(u);
  motion.reshaped() += (powers(u) * cubic).transpose();
  return motion;
}

std::size_t VibratingBeam::piece_at(double s) const {
  const auto behind = std::upper_bound(nodes_.begin() + 1, nodes_.end() - 1, s);
  return static_cast<std::size_t>(behind - nodes_.begin() - 1);
}

std::size_t VibratingBeam::node_of(double s) const {
  const auto nearest = std::min_element(nodes_.begin(), nodes_.end(), [&](double a, double b) {
    return std::abs(a - s) < std::abs(b - s);
  });
  return static_cast<std::size_t>(nearest - nodes_.begin());
}

}  // namespace boxbeam::frame
