#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <optional>
#include <type_traits>

#include "boxbeam/mechanism/flexible/response.hpp"
#include "exact_part.hpp"
#include "stretch_at.hpp"

namespace boxbeam::flexible {
namespace {

/// The part of a link in which a place lies inside, of the form whose springs are exact; nothing at
/// a node, and where a rigid element holds the place.
std::optional<std::size_t> part_around(const Structure& structure, std::size_t link, double s) {
  const Mechanism& mechanism = *structure.mechanism;
  if (mechanism.element == Element::classical || !mechanism.nodes_at_joints) return std::nullopt;
  const std::vector<SpringElement>& parts = structure.links[link].springs;
  const auto at = std::partition_point(parts.begin(), parts.end(),
                                       [&](const SpringElement& part) { return part.to <= s; });
  if (at == parts.end() || s <= at->from) return std::nullopt;
  return static_cast<std::size_t>(at - parts.begin());
}

/// What acts per length on a part, a parabola of the distance x from its start, and its integrals
/// from there.
template <class Scalar>
struct Along {
  Scalar c0{}, c1{}, c2{};

  /// Through values at the start, in the middle and at the end of a part of length D.
  Along(const Scalar& a, const Scalar& b, const Scalar& c, double D)
      : c0(a), c1((4.0 * b - 3.0 * a - c) / D), c2(2.0 * (a - 2.0 * b + c) / (D * D)) {}

  Scalar once(double x) const { return x * (c0 + x * (c1 / 2.0 + x * c2 / 3.0)); }
  Scalar twice(double x) const { return x * x * (c0 / 2.0 + x * (c1 / 6.0 + x * c2 / 12.0)); }
};

/// A part between the motions of its nodes.
template <class Scalar>
class BentPart {
 public:
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;

  BentPart(const Link& link, const SpringElement& part, const Vector3& from, const Vector3& to,
           const FieldAlong<Scalar>& field)
      : part_(&part),
        stretch_(&*stretch_at(link, 0.5 * (part.from + part.to))),
        stretches_(link.kind != LinkKind::bending),
        bends_(link.kind != LinkKind::axial),
        from_(from),
        along_(of_axis(0, to, field)),
        across_(of_axis(1, to, field)) {
    const double before = part.place - part.from;
    const double behind = part.to - part.place;
    // How the ends move against each other at the spring's place, less what the field does.
    const Vector3 elastic =
        Vector3(to[0] - from[0], to[1] - behind * to[2] - from[1] - before * from[2],
                to[2] - from[2]) -
        gap_up_to(part.to);
    if (stretches_ && part.axial > 0.0) force_[0] = elastic[0] / part.axial;
    if (!bends_) return;
    const Eigen::Matrix2d& F = part.bending;
    const double det = F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0);
    // A rigid part has no forces of its own shape.
    if (!(det > 1e-14 * F(0, 0) * F(1, 1))) return;
    force_[1] = (F(1, 1) * elastic[1] - F(0, 1) * elastic[2]) / det;
    force_[2] = (F(0, 0) * elastic[2] - F(1, 0) * elastic[1]) / det;
  }

  /// (u, w, phi) at a place of it.
  Vector3 at(double s) const {
    const Vector3 gap = gap_up_to(s);
    const double x = s - part_->from;
    const double lever = s - part_->place;
    return {from_[0] + gap[0], from_[1] + x * from_[2] + gap[1] + lever * gap[2],
            from_[2] + gap[2]};
  }

 private:
  Along<Scalar> of_axis(int axis, const Vector3& to, const FieldAlong<Scalar>& field) const {
    const double D = part_->to - part_->from;
    const auto load = [&](double share) -> Scalar {
      const double mass = stretch_->mass(part_->from + share * D - stretch_->start);
      // The motion between the nodes: along it linear, across it Hermite's.
      Scalar motion = (1.0 - share) * from_[axis] + share * to[axis];
      if (axis == 1 && share == 0.5) motion += D / 8.0 * (from_[2] - to[2]);
      return mass * (field.gravity[axis] + field.square * motion);
    };
    return {load(0.0), load(0.5), load(1.0), D};
  }

  /// What the forces at the spring's place and the field between the start and s add to the motion
  /// beyond, as a rigid body's at that place.
  Vector3 gap_up_to(double s) const {
    using Gauss = boost::math::quadrature::gauss<double, 7>;
    Vector3 sum = Vector3::Zero();
    const double half = 0.5 * (s - part_->from);
    const double middle = 0.5 * (s + part_->from);
    const auto add = [&](double u, double weight) {
      const double place = middle + half * u;
      const double x = place - stretch_->start;
      const double from = place - part_->from;
      const double lever = part_->place - place;
      if (stretches_) sum[0] += weight * (force_[0] - along_.once(from)) / stretch_->EA(x);
      if (!bends_) return;
      const Scalar Q = force_[1] - across_.once(from);
      const Scalar m = force_[2] + lever * force_[1] + across_.twice(from);
      sum[1] += weight * (Q / stretch_->GA(x) + lever * m / stretch_->EI(x));
      sum[2] += weight * m / stretch_->EI(x);
    };
    for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
      const double u = Gauss::abscissa()[k];
      add(u, half * Gauss::weights()[k]);
      if (u != 0.0) add(-u, half * Gauss::weights()[k]);
    }
    return sum;
  }

  const SpringElement* part_;
  const LinkStretch* stretch_;
  bool stretches_, bends_;
  Vector3 from_;
  Along<Scalar> along_, across_;
  Vector3 force_ = Vector3::Zero();  ///< of the spring: what lies beyond does to what lies before
};

}  // namespace

namespace {

/// Of a free vibration of the exact form.
template <class Scalar>
ExactPart<Scalar> vibrating_part(const Link& link, const SpringElement& part, double square) {
  Scalar z(square);
  if constexpr (!std::is_same_v<Scalar, double>) {
    z /= Complex(1.0, std::sqrt(square) * link.retardation);
  }
  return {link, part.from, part.to, z};
}

}  // namespace

template <class Scalar>
Eigen::Matrix<Scalar, 3, 1> motion_at(const Structure& structure, const Attachment& place,
                                      const Deformation<Scalar>& of,
                                      const FieldAlong<Scalar>& field) {
  if (place.link == ground) return Eigen::Matrix<Scalar, 3, 1>::Zero();
  const auto index = static_cast<std::size_t>(place.link);
  const auto& motion = of.motion[index];
  const double s = place.p.x();
  const std::optional<std::size_t> part = part_around(structure, index, s);
  if (!part) {
    const Grip grip = grip_of(structure, place);
    return grip.motion * motion.col(static_cast<Eigen::Index>(grip.element));
  }
  const Link& link = structure.mechanism->links[index];
  const Eigen::Rotation2Dd turn(link.angle);
  FieldAlong<Scalar> own = field;
  own.gravity = (turn.inverse().toRotationMatrix() * field.gravity).eval();
  const auto node = static_cast<Eigen::Index>(*part);
  const SpringElement& spring = structure.links[index].springs[*part];
  Eigen::Matrix<Scalar, 3, 1> at;
  if (structure.mechanism->element == Element::exact && field.square > 0.0) {
    at = vibrating_part<Scalar>(link, spring, field.square)
             .at(s, motion.col(node), motion.col(node + 1));
  } else {
    at = BentPart<Scalar>(link, spring, motion.col(node), motion.col(node + 1), own).at(s);
  }
  at[0] -= place.p.y() * at[2];
  at.template head<2>() = (turn.toRotationMatrix() * at.template head<2>()).eval();
  return at;
}

template Eigen::Vector3d motion_at<double>(const Structure&, const Attachment&,
                                           const Deformation<double>&, const FieldAlong<double>&);
template Eigen::Vector3cd motion_at<Complex>(const Structure&, const Attachment&,
                                             const Deformation<Complex>&,
                                             const FieldAlong<Complex>&);

}  // namespace boxbeam::flexible
