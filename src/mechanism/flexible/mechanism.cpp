#include "boxbeam/mechanism/flexible/mechanism.hpp"

#include <Eigen/Geometry>

#include <boost/math/quadrature/gauss.hpp>

namespace boxbeam::flexible {

Eigen::Vector2d in_world(const Mechanism& mechanism, const Attachment& at) {
  if (at.link == ground) return at.p;
  const Link& link = mechanism.links[static_cast<std::size_t>(at.link)];
  return link.origin + Eigen::Rotation2Dd(link.angle) * at.p;
}

RigidMass rigid_mass_of(const Link& link) {
  if (link.kind == LinkKind::rigid) return link.rigid;
  RigidMass of;
  double first = 0.0;  // moments about the origin
  double second = 0.0;
  for (const LinkStretch& stretch : link.stretches) {
    // Exact: the integrands are of degree 4.
    using Gauss = boost::math::quadrature::gauss<double, 3>;
    const auto over = [&](const auto& f) { return Gauss::integrate(f, 0.0, stretch.length); };
    of.mass += over([&](double x) { return stretch.mass(x); });
    first += over([&](double x) { return stretch.mass(x) * (stretch.start + x); });
    second += over([&](double x) {
      const double s = stretch.start + x;
      return stretch.mass(x) * s * s + stretch.rotary(x);
    });
  }
  if (of.mass > 0.0) of.centre.x() = first / of.mass;
  of.inertia = second - of.mass * of.centre.x() * of.centre.x();
  return of;
}

}  // namespace boxbeam::flexible
