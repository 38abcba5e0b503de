#include "exact_damping.hpp"

#include <Eigen/Dense>
#include <boost/math/quadrature/gauss.hpp>
#include <cassert>
#include <vector>

#include "boxbeam/core/angle.hpp"
#include "exact_part.hpp"
#include "stretch_at.hpp"

namespace boxbeam::flexible {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// A place of a part, as a share of its length, and its weight in an integral over it.
struct GaussPoint {
  double share, weight;
};

const std::vector<GaussPoint>& gauss_points() {
  static const std::vector<GaussPoint> points = [] {
    using Gauss = boost::math::quadrature::gauss<double, 10>;
    std::vector<GaussPoint> all;
    for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
      for (const double sign : {-1.0, 1.0})
        all.push_back({0.5 + 0.5 * sign * Gauss::abscissa()[k], 0.5 * Gauss::weights()[k]});
    }
    return all;
  }();
  return points;
}

/// Of a part: the modes' motions at its points, and their mass times what of them is not static.
class PartShapes {
 public:
  PartShapes(const Link& link, const SpringElement& of)
      : link_(&link), of_(&of), at_rest_(link, of.from, of.to, 0.0) {}

  /// Of a mode by the motions of the part's nodes: a column each.
  void write(double square, const Vector3d& q_0, const Vector3d& q_1,
             Eigen::Ref<Eigen::VectorXd> shape, Eigen::Ref<Eigen::VectorXd> beyond) const {
    const ExactPart<double> moving(*link_, of_->from, of_->to, square);
    const double length = of_->to - of_->from;
    const LinkStretch& stretch = *stretch_at(*link_, 0.5 * (of_->from + of_->to));
    Index row = 0;
    for (const GaussPoint& point : gauss_points()) {
      const double s = of_->from + point.share * length, x = s - stretch.start;
      const double mass = stretch.mass(x), weight = point.weight * length;
      const Vector3d q = moving.at(s, q_0, q_1);
      shape.segment<3>(row) = q;
      beyond.segment<3>(row) =
          weight *
          Vector3d(mass, mass, stretch.rotary(x)).cwiseProduct(q - at_rest_.at(s, q_0, q_1));
      row += 3;
    }
  }

 private:
  const Link* link_;
  const SpringElement* of_;
  ExactPart<double> at_rest_;
};

}  // namespace

void add_damping_within(const Structure& structure, ModalModel& model) {
  const auto count = static_cast<Index>(model.modes.size());
  const auto rows = 3 * static_cast<Index>(gauss_points().size());
  Eigen::VectorXd squares(count);
  for (Index j = 0; j < count; ++j) {
    const double omega = full_turn * model.modes[static_cast<std::size_t>(j)].frequency;
    squares[j] = omega * omega;
  }
  assert(count == 0 || pieces_at(structure, squares.maxCoeff()) == 1);
  MatrixXd shapes(rows, count), beyond(rows, count);
  for (std::size_t k = 0; k < structure.links.size(); ++k) {
    const Link& link = structure.mechanism->links[k];
    if (link.retardation == 0.0) continue;
    const std::vector<SpringElement>& parts = structure.links[k].springs;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const PartShapes part(link, parts[i]);
      for (Index j = 0; j < count; ++j) {
        const auto& motion = model.modes[static_cast<std::size_t>(j)].shape.motion[k];
        const auto node = static_cast<Index>(i);
        part.write(squares[j], motion.col(node), motion.col(node + 1), shapes.col(j),
                   beyond.col(j));
      }
      const MatrixXd strain = squares.asDiagonal() * (shapes.transpose() * beyond);
      // Symmetric but for round-off.
      model.damping += 0.5 * link.retardation * (strain + strain.transpose());
    }
  }
}

}  // namespace boxbeam::flexible
