#include "boxbeam/mechanism/planar/forces.hpp"

#include <cmath>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::planar {
namespace {

double angle_in(const Eigen::VectorXd& x, int body) {
  return body == ground ? 0.0 : x[3 * static_cast<Eigen::Index>(body) + 2];
}

Eigen::Vector2d unit_of(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Hands every load of an applied force on a body to `sink`.
template <class Sink>
struct Applier {
  double time;
  const Eigen::VectorXd& q;
  const Eigen::VectorXd& v;
  const std::vector<Touch>& touches;
  const Sink& sink;
  int force = 0;

  void add(const Attachment& at, const Eigen::Vector2d& vector, double moment) const {
    if (at.body != ground) sink(AppliedLoad{force, at.body, vector, moment, at.p});
  }

  void operator()(const Spring& spring) const {
    const Eigen::Vector2d d = position_of(spring.b, q) - position_of(spring.a, q);
    const double distance = d.norm();
    // Ends that coincide pull in no direction.
    if (!(distance > 0.0)) return;
    const Eigen::Vector2d u = d / distance;
    const double rate = u.dot(velocity_of(spring.b, q, v) - velocity_of(spring.a, q, v));
    const LineLaw law = law_of(spring);
    const Touch touch = touches.empty() ? Touch{inward(law, distance - law.free_length) > 0.0, 0.0}
                                        : touches[static_cast<std::size_t>(force)];
    const double pull = tension_of(law, distance, rate, touch);
    add(spring.a, pull * u, 0.0);
    add(spring.b, -pull * u, 0.0);
  }

  void operator()(const PinWithClearance& pin) const { (*this)(spring_of(pin)); }

  void operator()(const TorsionSpring& spring) const {
    const double turn = angle_in(q, spring.a.body) - angle_in(q, spring.b.body);
    const double rate = angle_in(v, spring.a.body) - angle_in(v, spring.b.body);
    const double moment = spring.stiffness * (turn - spring.free_angle) + spring.damping * rate;
    add(spring.a, Eigen::Vector2d::Zero(), -moment);
    add(spring.b, Eigen::Vector2d::Zero(), moment);
  }

  void operator()(const PointForce& point) const {
    const double direction = point.direction + (point.turns ? angle_in(q, point.at.body) : 0.0);
    add(point.at, driver_at(point.size, time).value * unit_of(direction), 0.0);
  }

  void operator()(const Couple& couple) const {
    const double moment = driver_at(couple.size, time).value;
    add(couple.a, Eigen::Vector2d::Zero(), moment);
    add(couple.b, Eigen::Vector2d::Zero(), -moment);
  }
};

template <class Sink>
void for_each_load(const Mechanism& mechanism, double time, const Eigen::VectorXd& q,
                   const Eigen::VectorXd& v, const std::vector<Touch>& touches, const Sink& sink) {
  Applier<Sink> applier{time, q, v, touches, sink};
  for (const AppliedForce& force : mechanism.forces) {
    std::visit(applier, force.kind);
    ++applier.force;
  }
}

/// What a contact's guide carries by multipliers, or its change by a change of them: all of it in
/// one plane.
GuideLoad guide_load_of(const FrictionContact& contact, const Eigen::VectorXd& lambda) {
  GuideLoad load = GuideLoad::Zero();
  load[0] = lambda[contact.row];
  if (contact.moment) load[3] = lambda[contact.row + 1];
  return load;
}

}  // namespace

std::vector<AppliedLoad> applied_loads_of(const Mechanism& mechanism, double time,
                                          const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                          const std::vector<Touch>& touches) {
  std::vector<AppliedLoad> loads;
  for_each_load(mechanism, time, q, v, touches,
                [&](const AppliedLoad& load) { loads.push_back(load); });
  return loads;
}

void add_applied_forces(const Mechanism& mechanism, double time, const Eigen::VectorXd& q,
                        const Eigen::VectorXd& v, Eigen::VectorXd& Q,
                        const std::vector<Touch>& touches) {
  for_each_load(mechanism, time, q, v, touches, [&](const AppliedLoad& load) {
    const Eigen::Index i = 3 * static_cast<Eigen::Index>(load.on);
    const Eigen::Vector2d arm = position_of({load.on, load.point}, q) - q.segment<2>(i);
    Q.segment<2>(i) += load.vector;
    Q[i + 2] += load.moment + arm.x() * load.vector.y() - arm.y() * load.vector.x();
  });
}

std::vector<OneSided> one_sided_in(const Mechanism& mechanism) {
  std::vector<OneSided> found;
  for (std::size_t i = 0; i < mechanism.forces.size(); ++i) {
    const auto take = [&](const Spring& spring) {
      const LineLaw law = law_of(spring);
      if (begins_at_length(law)) found.push_back({i, spring.a, spring.b, law});
    };
    const ForceKind& kind = mechanism.forces[i].kind;
    if (const auto* const spring = std::get_if<Spring>(&kind)) take(*spring);
    if (const auto* const pin = std::get_if<PinWithClearance>(&kind)) take(spring_of(*pin));
  }
  return found;
}

ValueAndRate depth_of(const OneSided& of, const Eigen::VectorXd& q, const Eigen::VectorXd& v) {
  const Eigen::Vector2d d = position_of(of.b, q) - position_of(of.a, q);
  const double length = d.norm();
  const double rate =
      length > 0.0 ? d.dot(velocity_of(of.b, q, v) - velocity_of(of.a, q, v)) / length : 0.0;
  return {inward(of.law, length - of.law.free_length), inward(of.law, rate)};
}

namespace {

/// k d + c d' of a spring, also where it is none, and its rate [N, N/s].
ValueAndRate force_of(const OneSided& of, const State& state) {
  const ValueAndRate depth = depth_of(of, state.q, state.v);
  const Eigen::Vector2d d = position_of(of.b, state.q) - position_of(of.a, state.q);
  const Eigen::Vector2d w =
      velocity_of(of.b, state.q, state.v) - velocity_of(of.a, state.q, state.v);
  const Eigen::Vector2d a = acceleration_of(of.b, state.q, state.v, state.a) -
                            acceleration_of(of.a, state.q, state.v, state.a);
  const double length = d.norm();
  // l l'' = |w|^2 - l'^2 + d a
  const double second =
      length > 0.0 ? (w.squaredNorm() - depth.rate * depth.rate + d.dot(a)) / length : 0.0;
  return {of.law.stiffness * depth.value + of.law.damping * depth.rate,
          of.law.stiffness * depth.rate + of.law.damping * inward(of.law, second)};
}

}  // namespace

std::vector<double> changes_by_drivers(const Mechanism& mechanism, double begin, double length,
                                       const std::function<const State&(double)>& at) {
  std::vector<double> changes;
  for (std::size_t i = 0; i < mechanism.forces.size(); ++i) {
    const auto* const spring = std::get_if<Spring>(&mechanism.forces[i].kind);
    if (spring == nullptr || spring->acts == Acts::both) continue;
    const OneSided of{i, spring->a, spring->b, law_of(*spring)};
    const auto depth_at = [&](double time) {
      const State& state = at(time);
      return depth_of(of, state.q, state.v);
    };
    const auto force_at = [&](double time) { return force_of(of, at(time)); };
    if (begins_at_length(of.law)) add_sign_changes(begin, length, depth_at, changes);
    if (of.law.damping != 0.0) add_sign_changes(begin, length, force_at, changes);
  }
  return changes;
}

bool rubs(const Joint& joint) {
  return std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.friction; })
          return boxbeam::rubs(kind.friction);
        else
          return false;
      },
      joint.kind);
}

std::vector<FrictionContact> friction_contacts_of(const Mechanism& mechanism) {
  std::vector<FrictionContact> contacts;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const Joint& joint = mechanism.joints[i];
    const bool moment = holds_of(joint).first == Hold::clamp;
    const auto take = [&](const auto& slide) {
      if constexpr (requires { slide.friction; }) {
        contacts.push_back({static_cast<int>(i), row, moment, slide.point, slide.guide,
                            slide.direction, slide.friction});
      }
    };
    if (rubs(joint)) std::visit(take, joint.kind);
    row += equations_of(joint);
  }
  return contacts;
}

Eigen::Vector2d tangent_of(const FrictionContact& contact, const Eigen::VectorXd& q) {
  return unit_of(contact.direction + angle_in(q, contact.guide.body));
}

double sliding_velocity_of(const FrictionContact& contact, const Eigen::VectorXd& q,
                           const Eigen::VectorXd& v) {
  // The guide's body at the place of the sliding point.
  Eigen::Vector2d carried = Eigen::Vector2d::Zero();
  if (contact.guide.body != ground) {
    const Eigen::Index i = 3 * static_cast<Eigen::Index>(contact.guide.body);
    const Eigen::Vector2d arm = position_of(contact.point, q) - q.segment<2>(i);
    carried = v.segment<2>(i) + v[i + 2] * Eigen::Vector2d(-arm.y(), arm.x());
  }
  return tangent_of(contact, q).dot(velocity_of(contact.point, q, v) - carried);
}

double sliding_acceleration_of(const FrictionContact& contact, const Eigen::VectorXd& q,
                               const Eigen::VectorXd& v, const Eigen::VectorXd& a) {
  // Against the guide's body, in which its line stands:
  // t . (a_P - a_G - alpha x r + omega^2 r - 2 omega x u), u the velocity against it.
  const Eigen::Vector2d place = position_of(contact.point, q);
  const auto left_of = [](const Eigen::Vector2d& of) { return Eigen::Vector2d(-of.y(), of.x()); };
  Eigen::Vector2d turning = Eigen::Vector2d::Zero();
  if (contact.point.body != ground) {
    const Eigen::Index i = 3 * static_cast<Eigen::Index>(contact.point.body);
    turning = -v[i + 2] * v[i + 2] * (place - q.segment<2>(i));
  }
  if (contact.guide.body != ground) {
    const Eigen::Index i = 3 * static_cast<Eigen::Index>(contact.guide.body);
    const double omega = v[i + 2];
    const Eigen::Vector2d arm = place - q.segment<2>(i);
    const Eigen::Vector2d against =
        velocity_of(contact.point, q, v) - v.segment<2>(i) - omega * left_of(arm);
    turning += omega * omega * arm - 2.0 * omega * left_of(against);
  }
  return sliding_velocity_of(contact, q, a) + tangent_of(contact, q).dot(turning);
}

double pressure_on(const FrictionContact& contact, const Eigen::VectorXd& lambda) {
  return pressure_of(contact.law, guide_load_of(contact, lambda));
}

void unit_friction(const FrictionContact& contact, const Eigen::VectorXd& q, Eigen::VectorXd& Q) {
  Q.setZero();
  const Eigen::Vector2d tangent = tangent_of(contact, q);
  const Eigen::Vector2d place = position_of(contact.point, q);
  const auto push = [&](int body, const Eigen::Vector2d& force) {
    if (body == ground) return;
    const Eigen::Index i = 3 * static_cast<Eigen::Index>(body);
    const Eigen::Vector2d arm = place - q.segment<2>(i);
    Q.segment<2>(i) += force;
    Q[i + 2] += arm.x() * force.y() - arm.y() * force.x();
  };
  push(contact.point.body, tangent);
  push(contact.guide.body, -tangent);
}

FrictionResponse friction_response_of(const std::vector<FrictionContact>& contacts,
                                      const Eigen::VectorXd& q, const Eigen::VectorXd& v,
                                      const Eigen::VectorXd& lambda_0,
                                      const Eigen::MatrixXd& by_unit) {
  const auto count = static_cast<Eigen::Index>(contacts.size());
  FrictionResponse response(contacts.size());
  for (Eigen::Index j = 0; j < count; ++j) {
    const FrictionContact& contact = contacts[static_cast<std::size_t>(j)];
    response.velocity[j] = sliding_velocity_of(contact, q, v);
    response.load_0.segment<6>(6 * j) = guide_load_of(contact, lambda_0);
    for (Eigen::Index k = 0; k < count; ++k)
      response.load.col(k).segment<6>(6 * j) = guide_load_of(contact, by_unit.col(k));
  }
  return response;
}

Eigen::VectorXd solve_friction(const Mechanism& mechanism,
                               const std::vector<FrictionContact>& contacts, double time,
                               const std::vector<Slip>& slips, const FrictionResponse& response) {
  if (const auto forces = boxbeam::solve_friction(laws_of(contacts), slips, response))
    return *forces;
  say_locked(names_of(mechanism, contacts), time);
}

std::vector<Friction> laws_of(const std::vector<FrictionContact>& contacts) {
  std::vector<Friction> laws;
  for (const FrictionContact& contact : contacts) laws.push_back(contact.law);
  return laws;
}

std::vector<std::string> names_of(const Mechanism& mechanism,
                                  const std::vector<FrictionContact>& contacts) {
  std::vector<std::string> names;
  for (const FrictionContact& contact : contacts)
    names.push_back(mechanism.joints[static_cast<std::size_t>(contact.joint)].name);
  return names;
}

}  // namespace boxbeam::planar
