#include "boxbeam/mechanism/flexible/structure.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cassert>
#include <cmath>

#include "frequency.hpp"
#include "stretch_at.hpp"

namespace boxbeam::flexible {
namespace {

/// A joint across a link this many times stiffer than the link in bending holds its end.
constexpr double holding = 1e4;

/// Calls f(stretch, from, to) for what lies of [from, to] in each stretch.
template <class Function>
void over_stretches(const Link& link, double from, double to, const Function& f) {
  for (auto at = stretch_at(link, from); at != link.stretches.end() && at->start < to; ++at) {
    const double a = std::max(from, at->start);
    const double b = std::min(to, at->start + at->length);
    if (b > a) f(*at, a, b);
  }
}

bool has_mass(const LinkStretch& of) {
  const auto is_there = [](double c) { return c != 0.0; };
  return std::any_of(of.mass.c.begin(), of.mass.c.end(), is_there) ||
         std::any_of(of.rotary.c.begin(), of.rotary.c.end(), is_there);
}

/// Integrals over a piece of a link about a place: of the mass, and of the rotary inertia.
struct PieceMass {
  double mass = 0.0, first = 0.0, second = 0.0, rotary = 0.0;
};

PieceMass mass_of(const Link& link, double from, double to, double about) {
  PieceMass sum;
  over_stretches(link, from, to, [&](const LinkStretch& stretch, double a, double b) {
    if (!has_mass(stretch)) return;  // links that only bear
    // Exact: the integrands are at most of degree 4.
    using Gauss = boost::math::quadrature::gauss<double, 3>;
    const auto over = [&](const auto& f) {
      return Gauss::integrate([&](double s) { return f(s - stretch.start, s - about); }, a, b);
    };
    sum.mass += over([&](double x, double) { return stretch.mass(x); });
    sum.first += over([&](double x, double d) { return stretch.mass(x) * d; });
    sum.second += over([&](double x, double d) { return stretch.mass(x) * d * d; });
    sum.rotary += over([&](double x, double) { return stretch.rotary(x); });
  });
  return sum;
}

SpringElement classical_spring(const Link& link, double from, double to) {
  SpringElement spring{0.5 * (from + to), from, to, 0.0, Eigen::Matrix2d::Zero()};
  const LinkStretch& stretch = *stretch_at(link, spring.place);
  const double x = spring.place - stretch.start;
  const double length = to - from;
  if (link.kind != LinkKind::bending) spring.axial = length / stretch.EA(x);
  if (link.kind != LinkKind::axial) {
    spring.bending.diagonal() << length / stretch.GA(x), length / stretch.EI(x);
  }
  return spring;
}

SpringElement corrected_spring(const Link& link, double from, double to) {
  SpringElement spring{0.5 * (from + to), from, to, 0.0, Eigen::Matrix2d::Zero()};
  const bool bends = link.kind != LinkKind::axial;
  const bool stretches = link.kind != LinkKind::bending;
  over_stretches(link, from, to, [&](const LinkStretch& stretch, double a, double b) {
    using Gauss = boost::math::quadrature::gauss<double, 7>;
    const auto over = [&](const auto& f) {
      return Gauss::integrate([&](double s) { return f(s - stretch.start, spring.place - s); }, a,
                              b);
    };
    if (stretches) spring.axial += over([&](double x, double) { return 1.0 / stretch.EA(x); });
    if (!bends) return;
    spring.bending(0, 0) += over([&](double x, double lever) {
      return 1.0 / stretch.GA(x) + lever * lever / stretch.EI(x);
    });
    spring.bending(0, 1) += over([&](double x, double lever) { return lever / stretch.EI(x); });
    spring.bending(1, 1) += over([&](double x, double) { return 1.0 / stretch.EI(x); });
  });
  spring.bending(1, 0) = spring.bending(0, 1);
  return spring;
}

/// The ends of the parts, in which `places` are kept.
std::vector<double> division_of(const Link& link, std::vector<double> places) {
  const double length = link.length;
  places.push_back(0.0);
  places.push_back(length);
  std::sort(places.begin(), places.end());
  std::vector<double> kept;
  for (const double s : places) {
    if (s < 0.0 || s > length) continue;
    if (kept.empty() || s > kept.back() + 1e-9 * length) kept.push_back(s);
  }
  kept.back() = length;
  std::vector<double> nodes{0.0};
  for (std::size_t i = 0; i + 1 < kept.size(); ++i) {
    const double share = (kept[i + 1] - kept[i]) / length * link.parts;
    const int parts = std::max(1, static_cast<int>(std::ceil(share - 1e-6)));
    for (int k = 1; k <= parts; ++k) {
      nodes.push_back(k == parts ? kept[i + 1] : kept[i] + (kept[i + 1] - kept[i]) * k / parts);
    }
  }
  return nodes;
}

DividedLink divided_rigid(const RigidMass& of) {
  RigidElement element;
  element.mass = of.mass;
  element.first_moment = of.mass * of.centre;
  element.inertia = of.inertia + of.mass * of.centre.squaredNorm();
  return {{element}, {}};
}

/// A link of one stretch without change: all parts of one length are alike.
struct PartCache {
  double length = -1.0;
  SpringElement spring;
  PartLumps lumps;
};

}  // namespace

PartLumps lumps_of(const Link& link, double from, double to) {
  const double length = to - from;
  const PieceMass of = mass_of(link, from, to, from);
  // Of the stretches within the part: its ends may be theirs, to round-off.
  const LinkStretch& first = *stretch_at(link, from + 1e-6 * length);
  const LinkStretch& last = *stretch_at(link, to - 1e-6 * length);
  PartLumps lumps;
  lumps.first_moment = {first.mass(from - first.start) * length * length / 12.0,
                        -last.mass(to - last.start) * length * length / 12.0};
  lumps.mass[1] = (of.first - lumps.first_moment[0] - lumps.first_moment[1]) / length;
  lumps.mass[0] = of.mass - lumps.mass[1];
  lumps.rotary = {0.5 * of.rotary, 0.5 * of.rotary};
  return lumps;
}

DividedLink divide(const Link& link, std::vector<double> places, Element element,
                   const HeldEnds& held) {
  if (link.kind == LinkKind::rigid) return divided_rigid(link.rigid);
  assert(!link.stretches.empty() && link.parts > 0);
  const std::vector<double> nodes = division_of(link, std::move(places));
  const std::size_t n = nodes.size() - 1;
  DividedLink divided;
  divided.elements.resize(n + 1);
  divided.springs.reserve(n);
  for (std::size_t i = 0; i <= n; ++i) divided.elements[i].node = nodes[i];

  const bool corrected = element != Element::classical;
  const bool uniform = link.stretches.size() == 1 && is_uniform(link.stretches.front());
  PartCache cache;
  for (std::size_t i = 0; i < n; ++i) {
    const double from = nodes[i];
    const double to = nodes[i + 1];
    // Parts of equal length of a uniform link differ by round-off only.
    if (!uniform || std::abs(to - from - cache.length) > 1e-9 * cache.length) {
      cache.length = to - from;
      cache.spring =
          corrected ? corrected_spring(link, from, to) : classical_spring(link, from, to);
      if (corrected) cache.lumps = lumps_of(link, from, to);
    }
    SpringElement& spring = divided.springs.emplace_back(cache.spring);
    spring.place = 0.5 * (from + to);
    spring.from = from;
    spring.to = to;
    if (!corrected) continue;
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      RigidElement& of = divided.elements[i + end];
      of.mass += cache.lumps.mass[end];
      of.first_moment.x() += cache.lumps.first_moment[end];
      of.inertia += cache.lumps.rotary[end];
    }
  }
  if (corrected) {
    // An end that moves needs as much inertia as its mass has there; within, nothing is left over
    // between equal parts. Links that do not bend move as one and need none.
    if (link.kind == LinkKind::axial) return divided;
    for (std::size_t i = 0; i <= n; ++i) {
      if ((i == 0 && held.start) || (i == n && held.end)) continue;
      RigidElement& of = divided.elements[i];
      if (of.mass <= 0.0) continue;
      of.inertia = std::max(of.inertia, of.first_moment.x() * of.first_moment.x() / of.mass);
    }
    return divided;
  }
  for (std::size_t i = 0; i <= n; ++i) {
    RigidElement& of = divided.elements[i];
    const double from = i == 0 ? 0.0 : divided.springs[i - 1].place;
    const double to = i == n ? link.length : divided.springs[i].place;
    const PieceMass piece = mass_of(link, from, to, of.node);
    of.mass = piece.mass;
    of.first_moment.x() = piece.first;
    of.inertia = piece.second + piece.rotary;
  }
  return divided;
}

namespace {

/// Stiffness of a joint in a direction of the world [N/m].
double stiffness_along(const Joint& joint, const Eigen::Vector2d& direction) {
  const Eigen::Rotation2Dd to_axes(-joint.angle);
  const Eigen::Vector2d in_axes = to_axes * direction;
  double sum = 0.0;
  for (const int axis : {0, 1}) {
    const double share = in_axes[axis] * in_axes[axis];
    if (share > 1e-12) sum += share * joint.stiffness[static_cast<std::size_t>(axis)];
  }
  return sum;
}

HeldEnds held_ends_of(const Mechanism& mechanism, int index) {
  const Link& link = mechanism.links[static_cast<std::size_t>(index)];
  HeldEnds held;
  if (link.kind == LinkKind::rigid) return held;
  const LinkStretch& middle = *stretch_at(link, 0.5 * link.length);
  const double own = 3.0 * middle.EI(0.5 * link.length - middle.start) / std::pow(link.length, 3);
  const Eigen::Vector2d across = Eigen::Rotation2Dd(link.angle) * Eigen::Vector2d::UnitY();
  for (const Joint& joint : mechanism.joints) {
    for (const auto& [one, other] :
         {std::pair(&joint.a, &joint.b), std::pair(&joint.b, &joint.a)}) {
      if (one->link != index || other->link != ground) continue;
      if (stiffness_along(joint, across) < holding * own) continue;
      if (std::abs(one->p.x()) < 1e-9 * link.length) held.start = true;
      if (std::abs(one->p.x() - link.length) < 1e-9 * link.length) held.end = true;
    }
  }
  return held;
}

/// The element whose node is nearest, or that holds the place (at a border the one before).
std::size_t element_at(const DividedLink& link, double s, bool nodes_at_joints) {
  if (nodes_at_joints) {
    const auto behind =
        std::lower_bound(link.elements.begin(), link.elements.end(), s,
                         [](const RigidElement& of, double place) { return of.node < place; });
    if (behind == link.elements.begin()) return 0;
    if (behind == link.elements.end()) return link.elements.size() - 1;
    const auto before = behind - 1;
    const auto nearest = s - before->node < behind->node - s ? before : behind;
    return static_cast<std::size_t>(nearest - link.elements.begin());
  }
  const auto after =
      std::lower_bound(link.springs.begin(), link.springs.end(), s,
                       [](const SpringElement& of, double place) { return of.place < place; });
  return static_cast<std::size_t>(after - link.springs.begin());
}

}  // namespace

namespace {

/// Of nu: beyond it a part is half-way to buckling by itself.
constexpr double least_nu = -0.5;

double mean_tension(const SpringElement& part) {
  return (part.tension[0] + 4.0 * part.tension[1] + part.tension[2]) / 6.0;
}

}  // namespace

std::array<double, 2> turning_of(const SpringElement& part) {
  const auto& [N_0, N_m, N_1] = part.tension;
  const double per = part.reach * (part.to - part.from) / 12.0;
  return {per * (3.0 * N_0 + 4.0 * N_m - N_1), per * (3.0 * N_1 + 4.0 * N_m - N_0)};
}

void load_axially(DividedLink& link, const TensionAt& tension) {
  for (std::size_t i = 0; i < link.springs.size(); ++i) {
    SpringElement& part = link.springs[i];
    const double D = part.to - part.from;
    part.tension = {tension(part.from, Side::behind),
                    tension(0.5 * (part.from + part.to), Side::both),
                    tension(part.to, Side::before)};
    Eigen::Matrix2d& f = part.bending;
    const double shift = f(1, 1) > 0.0 ? f(0, 1) / f(1, 1) : 0.0;
    part.place -= shift;
    f(0, 0) -= shift * f(0, 1);
    f(0, 1) = f(1, 0) = 0.0;
    const double N = mean_tension(part);
    part.reach = 1.0 / (1.0 + std::max(least_nu, N * f(0, 0) / D));
    f(0, 0) *= part.reach;
    const double bow = N * f(1, 1) * D / 6.0;
    f(1, 1) *= bow > 0.0 ? 1.0 + bow : 1.0 / (1.0 - bow);
    const std::array<double, 2> turning = turning_of(part);
    link.elements[i].turning += turning[0];
    link.elements[i + 1].turning += turning[1];
  }
}

bool parts_stand(const DividedLink& link) {
  return std::none_of(link.springs.begin(), link.springs.end(), [](const SpringElement& part) {
    return part.reach >= 1.0 / (1.0 + least_nu);
  });
}

Grip grip_of(const Structure& structure, const Attachment& at) {
  Grip grip;
  grip.link = at.link;
  if (at.link == ground) return grip;
  const auto index = static_cast<std::size_t>(at.link);
  const DividedLink& divided = structure.links[index];
  grip.element = element_at(divided, at.p.x(), structure.mechanism->nodes_at_joints);
  const Eigen::Vector2d arm(at.p.x() - divided.elements[grip.element].node, at.p.y());
  const Eigen::Matrix2d turn =
      Eigen::Rotation2Dd(structure.mechanism->links[index].angle).toRotationMatrix();
  grip.motion.topLeftCorner<2, 2>() = turn;
  grip.motion.topRightCorner<2, 1>() = turn * Eigen::Vector2d(-arm.y(), arm.x());
  return grip;
}

std::size_t Structure::elements() const {
  std::size_t sum = 0;
  for (const DividedLink& link : links) sum += link.elements.size();
  return sum;
}

Structure structure_of(const Mechanism& mechanism) {
  return structure_of(mechanism, std::pow(omega_of(mechanism.frequency), 2));
}

Structure structure_of(const Mechanism& mechanism, double square) {
  std::vector<std::vector<double>> places(mechanism.links.size());
  if (mechanism.nodes_at_joints) {
    const auto keep = [&](const Attachment& at) {
      if (at.link != ground) places[static_cast<std::size_t>(at.link)].push_back(at.p.x());
    };
    for (const Joint& joint : mechanism.joints) {
      keep(joint.a);
      keep(joint.b);
    }
    for (const Load& load : mechanism.loads) keep(load.at);
    for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
      for (const LinkStretch& stretch : mechanism.links[k].stretches) {
        places[k].push_back(stretch.start);
      }
    }
  }
  Structure structure;
  structure.mechanism = &mechanism;
  for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
    structure.links.push_back(divide(mechanism.links[k], places[k], mechanism.element,
                                     held_ends_of(mechanism, static_cast<int>(k))));
  }
  const int pieces = pieces_at(structure, square);
  if (pieces > 1) {
    const FinerStructure finer = cut(structure, pieces);
    for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
      std::vector<double> nodes;
      for (const RigidElement& of : finer.structure.links[k].elements) nodes.push_back(of.node);
      Link link = mechanism.links[k];
      link.parts = 1;
      structure.links[k] = divide(link, nodes, mechanism.element);
    }
  }
  for (const Joint& joint : mechanism.joints) {
    Structure::Ends& ends = structure.joints.emplace_back();
    ends.a = grip_of(structure, joint.a);
    ends.b = grip_of(structure, joint.b);
    ends.axes.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(-joint.angle).toRotationMatrix();
  }
  for (const Load& load : mechanism.loads) structure.loads.push_back(grip_of(structure, load.at));
  return structure;
}

}  // namespace boxbeam::flexible
