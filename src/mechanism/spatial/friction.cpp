#include "boxbeam/mechanism/spatial/friction.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"

namespace boxbeam::spatial {
namespace {

constexpr int most_passes = 60;

const ClosingJoint* closing_of(const Mechanism& mechanism, const FrictionContact& contact) {
  const std::size_t carrying = mechanism.joints.size();
  return contact.joint < carrying ? nullptr : &mechanism.closing[contact.joint - carrying];
}

/// Where what slides has its point, in the world.
Eigen::Vector3d place_of_contact(const Mechanism& mechanism, const FrictionContact& contact,
                                 const State& state) {
  const ClosingJoint* const closing = closing_of(mechanism, contact);
  return closing != nullptr ? position_of(state, closing->b) : state.bodies[contact.joint].joint;
}

}  // namespace

std::vector<FrictionContact> friction_contacts_of(const Mechanism& mechanism) {
  std::vector<FrictionContact> contacts;
  const auto add = [&](std::size_t joint, const Friction& law) {
    if (rubs(law)) contacts.push_back({joint, law});
  };
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) add(i, mechanism.joints[i].friction);
  for (std::size_t k = 0; k < mechanism.closing.size(); ++k)
    add(mechanism.joints.size() + k, mechanism.closing[k].friction);
  return contacts;
}

Friction& friction_in(Mechanism& mechanism, std::size_t joint) {
  const std::size_t carrying = mechanism.joints.size();
  return joint < carrying ? mechanism.joints[joint].friction
                          : mechanism.closing[joint - carrying].friction;
}

const std::string& name_of_contact(const Mechanism& mechanism, const FrictionContact& contact) {
  const ClosingJoint* const closing = closing_of(mechanism, contact);
  return closing != nullptr ? closing->name : mechanism.joints[contact.joint].name;
}

std::pair<int, int> bodies_of_contact(const Mechanism& mechanism, const FrictionContact& contact) {
  const ClosingJoint* const closing = closing_of(mechanism, contact);
  if (closing != nullptr) return {closing->a.body, closing->b.body};
  return {mechanism.joints[contact.joint].parent, static_cast<int>(contact.joint)};
}

bool is_taken_by_drive(const Mechanism& mechanism, const FrictionContact& contact) {
  return closing_of(mechanism, contact) == nullptr && is_driven(mechanism.joints[contact.joint]);
}

Eigen::Vector3d axis_of_contact(const Mechanism& mechanism, const FrictionContact& contact,
                                const State& state) {
  const ClosingJoint* const closing = closing_of(mechanism, contact);
  const Eigen::Vector3d& axis =
      closing != nullptr ? closing->axis : mechanism.joints[contact.joint].axis;
  return in_world(state, bodies_of_contact(mechanism, contact).first, axis);
}

double sliding_velocity_of(const Mechanism& mechanism, const FrictionContact& contact,
                           const State& state) {
  const ClosingJoint* const closing = closing_of(mechanism, contact);
  if (closing == nullptr) return state.coordinates[contact.joint].rate;
  // The guide's body at the place of what slides.
  const BodyMotion& guide = motion_of(state, closing->a.body);
  const Eigen::Vector3d carried =
      guide.velocity + guide.omega.cross(position_of(state, closing->b) - guide.position);
  return axis_of_contact(mechanism, contact, state).dot(velocity_of(state, closing->b) - carried);
}

double sliding_acceleration_of(const Mechanism& mechanism, const FrictionContact& contact,
                               const State& state) {
  const ClosingJoint* const closing = closing_of(mechanism, contact);
  if (closing == nullptr) return state.coordinates[contact.joint].acceleration;
  // Against the guide's body, in which its axis stands:
  // a . (a_P - a_G - alpha x r - omega x (omega x r) - 2 omega x u), u the velocity against it.
  const BodyMotion& guide = motion_of(state, closing->a.body);
  const Eigen::Vector3d arm = position_of(state, closing->b) - guide.position;
  const Eigen::Vector3d carried = guide.omega.cross(arm);
  const Eigen::Vector3d against = velocity_of(state, closing->b) - guide.velocity - carried;
  return axis_of_contact(mechanism, contact, state)
      .dot(acceleration_of(state, closing->b) - guide.acceleration - guide.alpha.cross(arm) -
           guide.omega.cross(carried) - 2.0 * guide.omega.cross(against));
}

GuideLoad guide_load_of(const Mechanism& mechanism, const FrictionContact& contact,
                        const State& state, const std::vector<Wrench>& joints) {
  const Eigen::Vector3d a = axis_of_contact(mechanism, contact, state);
  const Wrench& of = joints[contact.joint];
  GuideLoad load;
  load << of.force - a.dot(of.force) * a, of.moment.cross(a);
  return load;
}

double couple_about_guide(const Mechanism& mechanism, const FrictionContact& contact,
                          const State& state, const std::vector<Wrench>& joints) {
  const Eigen::Vector3d a = axis_of_contact(mechanism, contact, state);
  return a.dot(joints[contact.joint].moment);
}

void wrenches_beside_friction(const Tree& tree, const Loops* loops, const State& state,
                              const std::vector<FrictionContact>& contacts,
                              const std::vector<double>& forces, std::vector<Wrench>& joints) {
  const Mechanism& mechanism = tree.mechanism();
  std::vector<BodyWrench> acting;
  for (std::size_t j = 0; j < forces.size(); ++j) {
    const auto [guide, slides] = bodies_of_contact(mechanism, contacts[j]);
    const Eigen::Vector3d place = place_of_contact(mechanism, contacts[j], state);
    const Eigen::Vector3d force = forces[j] * axis_of_contact(mechanism, contacts[j], state);
    acting.push_back({slides, place, {force, Eigen::Vector3d::Zero()}});
    acting.push_back({guide, place, {-force, Eigen::Vector3d::Zero()}});
  }
  if (loops != nullptr)
    loops->wrenches(tree, state, acting, joints);
  else
    tree.wrenches(state, acting, joints);
}

std::vector<double> friction_forces_of(const Tree& tree, const Loops* loops, const State& state,
                                       const std::vector<FrictionContact>& contacts) {
  const Mechanism& mechanism = tree.mechanism();
  const auto count = static_cast<Eigen::Index>(contacts.size());
  if (count == 0) return {};
  std::vector<Wrench> joints;
  wrenches_beside_friction(tree, loops, state, contacts, {}, joints);
  const auto loads = [&] {
    Eigen::VectorXd of(6 * count);
    for (Eigen::Index j = 0; j < count; ++j)
      of.segment<6>(6 * j) =
          guide_load_of(mechanism, contacts[static_cast<std::size_t>(j)], state, joints);
    return of;
  };
  // Of the size of what acts without friction, so that round-off of neither counts in the other.
  double unit = 1.0;
  for (const Wrench& joint : joints) unit = std::max(unit, joint.force.norm());
  FrictionResponse response(contacts.size());
  response.load_0 = loads();
  const Eigen::VectorXd load_0 = response.load_0;
  std::vector<Friction> laws;
  for (Eigen::Index j = 0; j < count; ++j) {
    const FrictionContact& contact = contacts[static_cast<std::size_t>(j)];
    laws.push_back(contact.law);
    response.velocity[j] = sliding_velocity_of(mechanism, contact, state);
    if (loops == nullptr || is_taken_by_drive(mechanism, contact)) continue;
    std::vector<double> forces(contacts.size(), 0.0);
    forces[static_cast<std::size_t>(j)] = unit;
    wrenches_beside_friction(tree, loops, state, contacts, forces, joints);
    response.load.col(j) = (loads() - load_0) / unit;
  }
  // What pushes teeth apart goes by the size of their force, along either of them: where friction
  // turns one round, loads are not what they were by steps from none.
  for (int pass = 0; pass < most_passes; ++pass) {
    const auto solved = solve_friction(laws, {}, response);
    if (!solved) break;
    std::vector<double> forces{solved->begin(), solved->end()};
    if (loops == nullptr || !has_pushing_teeth(mechanism)) return forces;
    wrenches_beside_friction(tree, loops, state, contacts, forces, joints);
    const Eigen::VectorXd missed = loads() - response.load_0 - response.load * *solved;
    if (missed.lpNorm<Eigen::Infinity>() <= 1e-11 * unit) return forces;
    response.load_0 += missed;
  }
  say_locked_contacts(mechanism, contacts, state.time);
}

bool has_pushing_teeth(const Mechanism& mechanism) {
  return std::any_of(mechanism.closing.begin(), mechanism.closing.end(), [](const auto& joint) {
    return has_teeth(joint.kind) && !joint.mesh.apart.isZero(0.0);
  });
}

void say_locked_contacts(const Mechanism& mechanism, const std::vector<FrictionContact>& contacts,
                         double time) {
  std::vector<std::string> names;
  for (const FrictionContact& contact : contacts)
    if (contact.law.coulomb != 0.0 && !is_taken_by_drive(mechanism, contact))
      names.push_back(name_of_contact(mechanism, contact));
  say_locked(names, time);
}

void require_known_pressure(const Mechanism& mechanism, const Loops& loops,
                            const std::vector<FrictionContact>& contacts) {
  const auto dry = std::find_if(contacts.begin(), contacts.end(),
                                [](const FrictionContact& of) { return of.law.coulomb != 0.0; });
  const bool forced = std::any_of(mechanism.joints.begin(), mechanism.joints.end(), is_forced);
  if (forced && dry != contacts.end() && has_pushing_teeth(mechanism)) {
    const std::string& name = name_of_contact(mechanism, *dry);
    throw AnalysisError(
        {fmt::format(
             "joint \"{}\" rubs in a motion by forces beside teeth that push apart, which is "
             "not solved; write pressure_angle = \"0 deg\" where that push presses nothing "
             "that rubs, or drive the mechanism",
             name),
         "joint " + name});
  }
  for (const FrictionContact& contact : contacts) {
    if (contact.law.coulomb == 0.0 || loops.unique()[contact.joint] != 0) continue;
    const std::string& name = name_of_contact(mechanism, contact);
    throw AnalysisError(
        {fmt::format("what presses on joint \"{}\", which rubs, is not determined by rigid bodies: "
                     "joints repeat each other ({}), and how they share their load depends on "
                     "their stiffness; release one of them (\"spherical\" or \"cylindrical\" for "
                     "\"revolute\")",
                     name, fmt::join(names_not_unique(mechanism, loops), ", ")),
         "joint " + name});
  }
}

void fit_creep(Mechanism& mechanism, const std::vector<std::size_t>& joints) {
  constexpr int fewest = 96, most = 24576;
  constexpr double of_a_wave = 8.0;
  const std::vector<FrictionContact> contacts = friction_contacts_of(mechanism);
  if (std::any_of(mechanism.joints.begin(), mechanism.joints.end(), is_forced)) {
    for (const FrictionContact& contact : contacts) {
      const bool chosen = std::find(joints.begin(), joints.end(), contact.joint) != joints.end();
      if (chosen && !is_taken_by_drive(mechanism, contact))
        friction_in(mechanism, contact.joint).creep = 0.0;
    }
    return;
  }
  if (joints.empty()) return;
  // Drivers decide how it moves: no force is asked for.
  Mechanism moved = mechanism;
  for (const FrictionContact& contact : contacts) friction_in(moved, contact.joint) = {};
  try {
    const TimeSpan span = time_span_of(moved);
    const double waves = waves_of(span, most);
    const int instants = std::clamp(static_cast<int>(std::ceil(of_a_wave * waves)), fewest, most);
    const Chain chain(moved);
    std::vector<double> fastest(contacts.size(), 0.0);
    State state;
    for (int k = 0; k <= instants; ++k) {
      chain.at(span.begin + span.length * k / instants, state);
      for (std::size_t j = 0; j < contacts.size(); ++j)
        fastest[j] = std::max(fastest[j], std::abs(sliding_velocity_of(moved, contacts[j], state)));
    }
    for (std::size_t j = 0; j < contacts.size(); ++j) {
      if (std::find(joints.begin(), joints.end(), contacts[j].joint) == joints.end()) continue;
      Friction& law = friction_in(mechanism, contacts[j].joint);
      law.creep = fitted_creep(law, fastest[j], waves);
    }
  } catch (const AnalysisError&) {
    // Its verification says why it cannot be followed.
  }
}

}  // namespace boxbeam::spatial
