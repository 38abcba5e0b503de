#include "boxbeam/mechanism/flexible/mechanism.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>

namespace boxbeam::flexible {
namespace {

template <int Degree>
bool is_constant(const Polynomial<Degree>& p) {
  return std::all_of(p.c.begin() + 1, p.c.end(), [](double c) { return c == 0.0; });
}

}  // namespace

bool is_uniform(const LinkStretch& of) {
  return is_constant(of.EA) && is_constant(of.GA) && is_constant(of.EI) && is_constant(of.mass) &&
         is_constant(of.rotary);
}

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
