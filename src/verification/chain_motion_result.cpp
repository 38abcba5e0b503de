#include "boxbeam/verification/chain_motion_result.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/branch.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/project/quantity_text.hpp"

namespace boxbeam {
namespace {

using spatial::Mechanism;

/// The body that was asked for by name.
int axes_named(const Mechanism& mechanism, const std::string& name) {
  const int body = name == "world" ? spatial::ground : spatial::body_index(mechanism, name);
  if (name == "world" || body != spatial::ground) return body;
  std::vector<std::string> known{"world"};
  for (const spatial::Body& of : mechanism.bodies) known.push_back(of.name);
  const std::string near = nearest_word(name, known);
  throw InputError(fmt::format("there is no body \"{}\" for --axes", name),
                   near.empty() ? fmt::format("one of {}", fmt::join(known, ", "))
                                : fmt::format("did you mean {}?", near));
}

std::vector<double> twelve_instants_of(const Mechanism& mechanism) {
  const TimeSpan span = spatial::time_span_of(mechanism);
  std::vector<double> times;
  // What repeats is at its end where it began.
  const double steps = span.closed ? 12.0 : 11.0;
  for (int i = 0; i < 12; ++i) times.push_back(span.begin + span.length * i / steps);
  return times;
}

/// The same place on the body nearest to the ground to which it is fixed: through fixed joints,
/// and through revolute ones where it lies on their axis.
spatial::Attachment seat_of(const Mechanism& mechanism, spatial::Attachment at) {
  while (at.body != spatial::ground) {
    const spatial::Joint& joint = mechanism.joints[static_cast<std::size_t>(at.body)];
    const Eigen::Vector3d arm = joint.turn * (at.p - joint.point);
    const double size = std::max({at.p.norm(), joint.point.norm(), joint.at.norm(), 1e-3});
    const bool on_axis = joint.axis.cross(arm).norm() <= 1e-9 * size;
    const bool stays = joint.kind == spatial::JointKind::fixed ||
                       (joint.kind == spatial::JointKind::revolute && on_axis);
    if (!stays) break;
    at = {joint.parent, joint.at + arm};
  }
  return at;
}

struct NamedPlace {
  std::string name;
  spatial::Attachment at;
};

/// All named points, each place once.
std::vector<NamedPlace> named_places_of(const Mechanism& mechanism) {
  std::vector<NamedPlace> points;  // of all bodies, under their plain names
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    for (const spatial::BodyPoint& point : mechanism.bodies[i].points) {
      points.push_back({point.name, {static_cast<int>(i), point.p}});
    }
  }
  const auto one_place = [&](const NamedPlace& a, const NamedPlace& b) {
    const spatial::Attachment p = seat_of(mechanism, a.at);
    const spatial::Attachment q = seat_of(mechanism, b.at);
    return p.body == q.body && (p.p - q.p).norm() <= 1e-9 * std::max(p.p.norm(), 1e-3);
  };
  std::vector<NamedPlace> places;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const NamedPlace& point = points[i];
    bool alone = true;
    bool first = true;
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (points[k].name != point.name) continue;
      alone = alone && one_place(points[k], point);
      first = first && k >= i;
    }
    if (alone && !first) continue;
    const std::string& body = mechanism.bodies[static_cast<std::size_t>(point.at.body)].name;
    places.push_back({alone ? point.name : body + "." + point.name, point.at});
  }
  return places;
}

ChainBody body_of(const Mechanism& mechanism, const spatial::State& state, std::size_t i) {
  const spatial::BodyMotion& motion = state.bodies[i];
  const spatial::InertiaLoad inertia = spatial::inertia_of(mechanism, state, i);
  return {mechanism.bodies[i].name,
          motion.position,
          motion.R_WB,
          motion.omega,
          motion.alpha,
          inertia.force,
          inertia.moment,
          inertia.gyroscopic};
}

ChainJoint joint_of(const spatial::Chain& chain, const spatial::State& state, std::size_t i,
                    const spatial::Wrench& wrench, int beam) {
  const Mechanism& mechanism = chain.mechanism();
  const spatial::Joint& joint = mechanism.joints[i];
  const bool on_carrier = beam != spatial::ground && joint.parent == beam;
  const double sign = on_carrier ? -1.0 : 1.0;
  ChainJoint result{joint.name,
                    mechanism.bodies[on_carrier ? static_cast<std::size_t>(beam) : i].name,
                    sign * wrench.force,
                    sign * wrench.moment,
                    {},
                    {},
                    {}};
  if (joint.kind == spatial::JointKind::fixed) return result;
  result.coordinate = state.coordinates[i];
  result.turns = spatial::is_angle(joint.kind);
  if (spatial::is_driven(joint)) result.drive = chain.along_axis(state, i, wrench);
  return result;
}

ChainJoint joint_of(const Mechanism& mechanism, const spatial::State& state,
                    const spatial::ClosingJoint& joint, const spatial::Wrench& wrench, int beam) {
  const bool on_a =
      joint.b.body == spatial::ground || (beam != spatial::ground && joint.a.body == beam);
  const double sign = on_a ? -1.0 : 1.0;
  const int on = on_a ? joint.a.body : joint.b.body;
  ChainJoint result{joint.name,
                    mechanism.bodies[static_cast<std::size_t>(on)].name,
                    sign * wrench.force,
                    sign * wrench.moment,
                    {},
                    {},
                    {}};
  if (joint.kind != spatial::ClosingKind::distance) return result;
  result.coordinate = driver_at(joint.length, state.time);
  if (joint.driver_name.empty()) return result;
  const Eigen::Vector3d along =
      (spatial::position_of(state, joint.b) - spatial::position_of(state, joint.a)).normalized();
  result.drive = along.dot(wrench.force);
  return result;
}

/// Turns all vectors of an instant into other axes.
void turn_into(const Eigen::Matrix3d& R_AW, ChainInstant& instant) {
  const auto turn = [&](auto&... vectors) { ((vectors = (R_AW * vectors).eval()), ...); };
  for (ChainBody& body : instant.bodies) {
    turn(body.position, body.rotation, body.omega, body.alpha, body.inertia_force,
         body.inertia_moment, body.gyroscopic_moment);
  }
  for (ChainPoint& point : instant.points) turn(point.position, point.velocity, point.acceleration);
  for (ChainJoint& joint : instant.joints) turn(joint.force, joint.moment);
}

ChainInstant instant_of(const Project& project, const spatial::Chain& chain,
                        const std::vector<NamedPlace>& places, double time) {
  const Mechanism& mechanism = chain.mechanism();
  const spatial::State state = chain.at(time);
  const std::vector<spatial::Wrench> wrenches = chain.joint_wrenches(state);
  ChainInstant instant;
  instant.time = time;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    instant.bodies.push_back(body_of(mechanism, state, i));
    instant.joints.push_back(joint_of(chain, state, i, wrenches[i], project.placement.body));
  }
  for (std::size_t k = 0; k < mechanism.closing.size(); ++k) {
    instant.joints.push_back(joint_of(mechanism, state, mechanism.closing[k],
                                      wrenches[mechanism.joints.size() + k],
                                      project.placement.body));
  }
  for (std::size_t j = 0; j < state.friction.size(); ++j)
    instant.joints[chain.contacts()[j].joint].friction = state.friction[j];
  if (const spatial::Loops* loops = chain.loops()) {
    instant.branch = spatial::branch_signs_of(mechanism, state);
    if (loops->branch() != 0) instant.branch.emplace_back("loops", loops->branch());
    instant.residual = loops->residual_of(chain.tree(), state);
    instant.condition = loops->condition_of(chain.tree(), state);
    for (std::size_t i = 0; i < instant.joints.size(); ++i)
      instant.joints[i].unique = loops->unique()[i] != 0;
  }
  for (const NamedPlace& place : places) {
    instant.points.push_back({place.name, spatial::position_of(state, place.at),
                              spatial::velocity_of(state, place.at),
                              spatial::acceleration_of(state, place.at)});
  }
  return instant;
}

ChainLoops loops_of(const Mechanism& mechanism, const spatial::Loops& loops) {
  ChainLoops of;
  of.equations = loops.equations();
  of.freedoms = loops.freedoms();
  of.repeating = loops.repeating();
  for (const spatial::ClosingJoint& joint : mechanism.closing) of.closing.push_back(joint.name);
  of.not_unique = spatial::names_not_unique(mechanism, loops);
  return of;
}

Eigen::Vector3d computed_of(const HandFormula& formula, const spatial::State& state) {
  const auto body = [&]() -> const spatial::BodyMotion& {
    return state.bodies[static_cast<std::size_t>(formula.body)];
  };
  switch (formula.quantity) {
    case HandFormula::Quantity::omega: return body().omega;
    case HandFormula::Quantity::alpha: return body().alpha;
    case HandFormula::Quantity::position: return spatial::position_of(state, formula.point);
    case HandFormula::Quantity::velocity: return spatial::velocity_of(state, formula.point);
    case HandFormula::Quantity::acceleration: return spatial::acceleration_of(state, formula.point);
  }
  return Eigen::Vector3d::Zero();
}

/// The body or the point that a formula speaks of.
std::string subject_of(const Mechanism& mechanism, const HandFormula& formula) {
  const bool turning = formula.quantity == HandFormula::Quantity::omega ||
                       formula.quantity == HandFormula::Quantity::alpha;
  const int index = turning ? formula.body : formula.point.body;
  if (index == spatial::ground) return "ground";
  const spatial::Body& body = mechanism.bodies[static_cast<std::size_t>(index)];
  if (turning) return body.name;
  for (const spatial::BodyPoint& point : body.points) {
    if (point.p == formula.point.p) return body.name + "." + point.name;
  }
  return "point of " + body.name;
}

}  // namespace

ChainMotionResult chain_motion_of(const Project& project, std::vector<double> times,
                                  const std::string& axes) {
  const Mechanism& mechanism = spatial_of(project);
  const int asked = axes_named(mechanism, axes);
  if (times.empty()) times = twelve_instants_of(mechanism);
  const spatial::Chain chain(mechanism);
  const std::vector<NamedPlace> places = named_places_of(mechanism);

  ChainMotionResult result;
  result.axes = axes;
  const auto driven_length = [](const spatial::ClosingJoint& joint) {
    return !joint.driver_name.empty();
  };
  result.driven = static_cast<std::size_t>(
      std::count_if(mechanism.joints.begin(), mechanism.joints.end(), spatial::is_driven) +
      std::count_if(mechanism.closing.begin(), mechanism.closing.end(), driven_length));
  if (const spatial::ForcedMotion* forced = chain.forced()) {
    result.forced = forced->freedoms();
    result.sticking = sticking_contacts(forced->first_slips(), 0.0, forced->slip_changes());
  }
  if (const spatial::Loops* loops = chain.loops()) result.loops = loops_of(mechanism, *loops);
  for (const double time : times) {
    ChainInstant instant = instant_of(project, chain, places, time);
    if (asked != spatial::ground) {
      const Eigen::Matrix3d R_WA = instant.bodies[static_cast<std::size_t>(asked)].rotation;
      turn_into(R_WA.transpose(), instant);
    }
    result.states.push_back(std::move(instant));
  }
  for (const HandFormula& formula : project.hand_formulas) {
    result.hand_formulas.push_back({formula, subject_of(mechanism, formula),
                                    computed_of(formula, chain.at(formula.time.value()))});
  }
  return result;
}

const char* to_text(HandFormula::Quantity quantity) {
  switch (quantity) {
    case HandFormula::Quantity::omega: return "omega";
    case HandFormula::Quantity::alpha: return "alpha";
    case HandFormula::Quantity::position: return "position";
    case HandFormula::Quantity::velocity: return "velocity";
    case HandFormula::Quantity::acceleration: return "acceleration";
  }
  return "";
}

}  // namespace boxbeam
