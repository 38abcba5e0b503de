#include "boxbeam/mechanism/flexible/beam_loads.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "exact_inertia.hpp"
#include "frequency.hpp"

namespace boxbeam::flexible {
namespace {

/// Mass per length where it is one polynomial.
struct MassStretch {
  double start = 0.0, length = 0.0;  ///< [m]
  Polynomial<2> mass;                ///< [kg/m]
  Polynomial<4> rotary;              ///< [kg m]
};

/// How the mass of a link lies; of a rigid one that does not know, as that of the beam.
std::vector<MassStretch> mass_of(const Link& link, const TaperedBeam& beam) {
  std::vector<MassStretch> stretches;
  for (const LinkStretch& of : link.stretches) {
    stretches.push_back({of.start, of.length, of.mass, of.rotary});
  }
  if (!stretches.empty()) return stretches;
  const std::vector<SegmentMass> distribution = mass_distribution_of(beam);
  for (std::size_t i = 0; i < distribution.size(); ++i) {
    const Segment& segment = beam.segments[i];
    stretches.push_back({segment.start.value(), segment.length.value(), distribution[i].mass,
                         distribution[i].rotary_y});
  }
  return stretches;
}

/// A stretch of the beam over which all line loads are polynomials.
struct Interval {
  double from = 0.0, to = 0.0;
  std::size_t stretch = 0;  ///< of mass
  std::size_t piece = 0;    ///< classical: the rigid element; corrected: the part
};

/// Where the division puts inertia together: middles of the classical springs, nodes of the others.
std::vector<double> borders_of(const DividedLink& divided, Element element) {
  std::vector<double> borders;
  if (divided.springs.empty()) return borders;
  if (element == Element::classical) {
    for (const SpringElement& spring : divided.springs) borders.push_back(spring.place);
  } else {
    for (std::size_t i = 1; i < divided.springs.size(); ++i) {
      borders.push_back(divided.springs[i].from);
    }
  }
  return borders;
}

std::vector<Interval> intervals_of(const std::vector<MassStretch>& stretches,
                                   const std::vector<double>& borders) {
  std::vector<Interval> intervals;
  const double length = stretches.back().start + stretches.back().length;
  const double nothing = 1e-9 * length;
  std::size_t piece = 0;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const double end = stretches[k].start + stretches[k].length;
    double at = stretches[k].start;
    // A border at the start of a stretch: what lies before it is done.
    while (piece < borders.size() && borders[piece] < at + nothing) ++piece;
    while (piece < borders.size() && borders[piece] < end - nothing) {
      intervals.push_back({at, borders[piece], k, piece});
      at = borders[piece++];
    }
    intervals.push_back({at, end, k, piece});
  }
  return intervals;
}

LineLoad empty_line(const Interval& of) {
  return {si<Length>(of.from), si<Length>(of.to - of.from), {}, {}};
}

/// What the motion of a link's elements leaves along it.
class Inertia {
 public:
  Inertia(const Structure& structure, std::size_t link, const std::vector<MassStretch>& stretches,
          const Vibration& of)
      : structure_(&structure),
        link_(link),
        stretches_(&stretches),
        z_(of.square / Complex(1.0, of.omega * structure.mechanism->links[link].retardation)),
        exact_(structure.mechanism->element == Element::exact && !divided().springs.empty()),
        gathered_(structure.mechanism->element == Element::corrected &&
                  !divided().springs.empty()) {
    if (!gathered_) return;
    const Link& whole = structure.mechanism->links[link];
    for (const SpringElement& part : divided().springs) {
      parts_.push_back(lumps_of(whole, part.from, part.to));
    }
  }

  /// Of a motion times its square: of its real and of its imaginary part.
  std::array<LineLoad, 2> lines(const Interval& of, const Eigen::Matrix3Xcd& motion) const {
    if (exact_) return lines_of_exact(of, motion);
    const auto line = [&](const Eigen::Matrix3Xd& part) {
      return gathered_ ? line_of_part(of, part) : line_of_element(of, part);
    };
    return {line(motion.real()), line(motion.imag())};
  }

 private:
  const DividedLink& divided() const { return structure_->links[link_]; }

  std::array<LineLoad, 2> lines_of_exact(const Interval& of,
                                         const Eigen::Matrix3Xcd& motion) const {
    const Link& link = structure_->mechanism->links[link_];
    const SpringElement& spring = divided().springs[of.piece];
    const auto at = static_cast<Eigen::Index>(of.piece);
    return exact_inertia_of(ExactPart<Complex>(link, spring.from, spring.to, z_),
                            link.stretches[of.stretch], of.from, of.to, motion.col(at),
                            motion.col(at + 1));
  }

  LineLoad line_of_element(const Interval& of, const Eigen::Matrix3Xd& motion) const {
    const MassStretch& stretch = (*stretches_)[of.stretch];
    const Eigen::Vector3d q = motion.col(static_cast<Eigen::Index>(of.piece));
    const double by = of.from - stretch.start;
    const Polynomial<2> mass = shifted(stretch.mass, by);
    LineLoad line = empty_line(of);
    line.force[0] = q[0] * mass + Polynomial<3>{};
    line.force[2] =
        mass * Polynomial<1>{{q[1] + q[2] * (of.from - divided().elements[of.piece].node), q[2]}};
    // y points into the plane: counter-clockwise is negative about it.
    line.couple[1] = -q[2] * shifted(stretch.rotary, by);
    return line;
  }

  /// What an element has of inertia beyond its masses' rotary one, of that the share of a part
  /// beside it: as the squares of their first moments about the node, so that a short part beside a
  /// long one has next to nothing.
  double added_inertia(std::size_t element, std::size_t part) const {
    double rotary = 0.0, all = 0.0, own = 0.0;
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      if (element < end || element - end >= parts_.size()) continue;
      const std::size_t beside = element - end;
      const double first_moment = parts_[beside].first_moment[end];
      rotary += parts_[beside].rotary[end];
      all += first_moment * first_moment;
      if (beside == part) own = first_moment * first_moment;
    }
    return all > 0.0 ? (divided().elements[element].inertia - rotary) * own / all : 0.0;
  }

  LineLoad line_of_part(const Interval& of, const Eigen::Matrix3Xd& motion) const {
    const std::size_t i = of.piece;
    const PartLumps& lumps = parts_[i];
    const SpringElement& part = divided().springs[i];
    const double D = part.to - part.from;
    const Eigen::Vector3d q0 = motion.col(static_cast<Eigen::Index>(i));
    const Eigen::Vector3d q1 = motion.col(static_cast<Eigen::Index>(i) + 1);
    const auto& [m0, m1] = lumps.mass;
    const auto& [S0, S1] = lumps.first_moment;
    const double P0 = m0 * q0[1] + S0 * q0[2];
    const double P1 = m1 * q1[1] + S1 * q1[2];
    const double Q = S0 * q0[1] + S1 * q1[1] + D * P1 + added_inertia(i, i) * q0[2] +
                     added_inertia(i + 1, i) * q1[2];
    const double slope = (12.0 * Q - 6.0 * (P0 + P1) * D) / (D * D * D);
    const double from = of.from - part.from;
    const auto linear = [&](double at_start, double per_length) {
      return Polynomial<1>{{at_start + per_length * from, per_length}};
    };
    // Between the values a and b at the ends: a D/2 + b D/2 in all.
    const auto between = [&](double a, double b) {
      return linear(2.0 * a / D, 2.0 * (b - a) / (D * D));
    };
    LineLoad line = empty_line(of);
    line.force[0] = between(m0 * q0[0], m1 * q1[0]) + Polynomial<3>{};
    line.force[2] = linear((P0 + P1) / D - 0.5 * slope * D, slope) + Polynomial<3>{};
    line.couple[1] =
        -1.0 * between(lumps.rotary[0] * q0[2], lumps.rotary[1] * q1[2]) + Polynomial<4>{};
    return line;
  }

  const Structure* structure_;
  std::size_t link_;
  const std::vector<MassStretch>* stretches_;
  Complex z_;  ///< of the exact form between its nodes
  bool exact_, gathered_;
  std::vector<PartLumps> parts_;
};

/// Calls of_joint(joint, place on the link, sign of its force there) and of_load(load) in the order
/// of the point loads.
template <class OfJoint, class OfLoad>
void each_point(const Mechanism& mechanism, int link, const OfJoint& of_joint,
                const OfLoad& of_load) {
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const Joint& joint = mechanism.joints[j];
    if (joint.a.link == link) of_joint(j, joint.a.p, 1.0);
    if (joint.b.link == link) of_joint(j, joint.b.p, -1.0);
  }
  for (const Load& load : mechanism.loads) {
    if (load.at.link == link) of_load(load);
  }
}

/// A force and couple (x, y, couple in the world) at a place of a link, as a load on its axis.
PointLoad point_load(const Link& link, std::string_view name, Length s, const Eigen::Vector2d& p,
                     const Eigen::Vector3d& world) {
  const Eigen::Vector2d force = Eigen::Rotation2Dd(-link.angle) * world.head<2>();
  PointLoad load;
  load.name = name;
  load.s = s;
  load.at.y() = p.y();
  load.force = {force.x(), 0.0, force.y()};
  load.moment.y() = -world[2] + p.y() * force.x();
  return load;
}

/// What the axial force that is there does to a part that bends, in the axes of the straight beam:
/// the load across it d/ds (N w'), which gives the shear in the bent section. `N w'` of a part as a
/// polynomial whose integral is the couple that its two nodes feel, so that all is in balance.
Polynomial<4> tension_times_slope(const SpringElement& part, const Eigen::Vector3d& q0,
                                  const Eigen::Vector3d& q1) {
  const double D = part.to - part.from;
  const std::array<double, 2> turning = turning_of(part);
  const double middle = 1.5 * (q1[1] - q0[1]) / D - 0.25 * (q0[2] + q1[2]);
  const double a = part.tension[0] * q0[2];
  const double b = part.tension[1] * middle;
  const double c = part.tension[2] * q1[2];
  // What the chord that turns more than its nodes' levers feels of the mean tension.
  const double N = (part.tension[0] + 4.0 * part.tension[1] + part.tension[2]) / 6.0;
  const double chord =
      q1[1] - q0[1] -
      part.reach * ((part.place - part.from) * q0[2] + (part.to - part.place) * q1[2]);
  const double couple = N * chord + turning[0] * q0[2] + turning[1] * q1[2];
  const double lack = couple - D / 6.0 * (a + 4.0 * b + c);
  const double bubble = 30.0 * lack / std::pow(D, 5);
  Polynomial<4> g;
  g.c = {a, (4.0 * b - 3.0 * a - c) / D, 2.0 * (a - 2.0 * b + c) / (D * D) + bubble * D * D,
         -2.0 * bubble * D, bubble};
  return g;
}

bool bears_tension(const DividedLink& link) {
  return std::any_of(link.elements.begin(), link.elements.end(),
                     [](const RigidElement& of) { return of.turning != 0.0; });
}

/// Adds the loads of second order in a motion of a link's elements to its loads, whose lines lie
/// within the link's parts. Points come in the same number and order whatever the motion.
void add_second_order(const DividedLink& link, const std::vector<Length>& places,
                      const Eigen::Matrix3Xd& motion, BeamLoads& loads) {
  std::size_t at = 0;
  for (LineLoad& line : loads.lines) {
    const double middle = (line.start + 0.5 * line.length).value();
    while (at + 1 < link.springs.size() && middle > link.springs[at].to) ++at;
    const auto i = static_cast<Eigen::Index>(at);
    const SpringElement& part = link.springs[at];
    const Polynomial<4> g = tension_times_slope(part, motion.col(i), motion.col(i + 1));
    line.force[2] = line.force[2] + shifted(derivative_of(g), line.start.value() - part.from);
  }
  double largest = 0.0;
  for (const SpringElement& part : link.springs) {
    for (const double N : part.tension) largest = std::max(largest, std::abs(N));
  }
  constexpr double nothing = 1e-10;
  for (std::size_t i = 0; i < link.elements.size(); ++i) {
    double jump = 0.0;
    double arms = link.elements[i].turning;
    if (i > 0) {
      jump -= link.springs[i - 1].tension[2];
      arms -= turning_of(link.springs[i - 1])[1];
    }
    if (i < link.springs.size()) {
      jump += link.springs[i].tension[0];
      arms -= turning_of(link.springs[i])[0];
    }
    const double size = largest * (link.elements.back().node - link.elements.front().node);
    if (std::abs(jump) <= nothing * largest && std::abs(arms) <= nothing * size) continue;
    const double turn = motion(2, static_cast<Eigen::Index>(i));
    PointLoad& load = loads.points.emplace_back();
    load.s = place_near(places, si<Length>(link.elements[i].node));
    load.force.z() = jump * turn;
    // Forces beside the axis, whose arms turn; y points into the plane.
    load.moment.y() = arms * turn;
  }
}

}  // namespace

BeamResponse beam_response_of(const Structure& structure, int link, const TaperedBeam& beam,
                              const Response& response, const Vibration& inertial) {
  const Mechanism& mechanism = *structure.mechanism;
  const auto index = static_cast<std::size_t>(link);
  const Link& of = mechanism.links[index];
  BeamResponse result;
  result.frequency = response.frequency;

  const std::vector<MassStretch> stretches = mass_of(of, beam);
  const std::vector<Interval> intervals =
      intervals_of(stretches, borders_of(structure.links[index], mechanism.element));
  // The beam's own places are met exactly: cut forces jump there.
  const std::vector<Length> places = places_of(beam);
  const auto add_point = [&](std::string_view name, const Eigen::Vector2d& p,
                             const Eigen::Vector3d& constant, const Eigen::Vector3cd& harmonic) {
    const Length s = place_near(places, si<Length>(p.x()));
    result.constant.points.push_back(point_load(of, name, s, p, constant));
    result.sine.points.push_back(point_load(of, name, s, p, harmonic.real()));
    result.cosine.points.push_back(point_load(of, name, s, p, harmonic.imag()));
  };
  each_point(
      mechanism, link,
      [&](std::size_t joint, const Eigen::Vector2d& p, double sign) {
        add_point(mechanism.joints[joint].name, p,
                  sign * joint_force(structure, joint, response.constant),
                  sign * joint_force(structure, joint, response.harmonic));
      },
      [&](const Load& load) {
        add_point(load.name, load.at.p, load.constant,
                  std::polar(1.0, load.phase) * load.amplitude);
      });

  const Eigen::Vector2d g = Eigen::Rotation2Dd(-of.angle) * mechanism.gravity;
  const Inertia inertia(structure, index, stretches, inertial);
  const Eigen::Matrix3Xcd moved = inertial.square * inertial.motion[index];
  for (const Interval& interval : intervals) {
    const MassStretch& stretch = stretches[interval.stretch];
    const Polynomial<2> mass = shifted(stretch.mass, interval.from - stretch.start);
    LineLoad& weight = result.constant.lines.emplace_back(empty_line(interval));
    weight.force[0] = g.x() * mass + Polynomial<3>{};
    weight.force[2] = g.y() * mass + Polynomial<3>{};
    const auto [real, imaginary] = inertia.lines(interval, moved);
    result.sine.lines.push_back(real);
    result.cosine.lines.push_back(imaginary);
  }
  if (!bears_tension(structure.links[index])) return result;
  const auto add_bent = [&](const Eigen::Matrix3Xd& motion, BeamLoads& loads) {
    add_second_order(structure.links[index], places, motion, loads);
  };
  add_bent(response.constant.motion[index], result.constant);
  add_bent(response.harmonic.motion[index].real(), result.sine);
  add_bent(response.harmonic.motion[index].imag(), result.cosine);
  return result;
}

BeamResponse beam_response_of(const Structure& structure, int link, const TaperedBeam& beam,
                              const Response& response, const LinkColumns<Complex>& inertial) {
  const double omega = omega_of(response.frequency);
  return beam_response_of(structure, link, beam, response,
                          Vibration{inertial, omega * omega, omega});
}

BeamLoads beam_loads_at(const BeamResponse& response, double time) {
  const double angle = omega_of(response.frequency) * time;
  BeamLoads loads = response.constant;
  if (response.frequency == 0.0) return loads;
  add(loads, std::sin(angle), response.sine);
  add(loads, std::cos(angle), response.cosine);
  return loads;
}

}  // namespace boxbeam::flexible
