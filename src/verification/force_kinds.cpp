#include "force_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "boxbeam/section/outline.hpp"
#include "boxbeam/verification/front_end.hpp"

namespace boxbeam {
namespace {

/// What is so near each other is at one place, by the beam's length.
constexpr double hardly_apart = 1e-6;

template <class Joints>
auto named(const Joints& joints, const std::string& name) {
  return std::find_if(joints.begin(), joints.end(),
                      [&](const auto& joint) { return joint.name == name; });
}

bool turns_freely_in(const planar::Mechanism& mechanism, const Project&, const std::string& name) {
  const auto at = named(mechanism.joints, name);
  return at != mechanism.joints.end() && (std::holds_alternative<planar::Pin>(at->kind) ||
                                          std::holds_alternative<planar::PinInSlot>(at->kind) ||
                                          std::holds_alternative<planar::Distance>(at->kind));
}

bool turns_freely_in(const frame::Structure& frame, const Project& project,
                     const std::string& name) {
  const auto at = named(frame.joints, name);
  if (at == frame.joints.end()) return false;
  const Eigen::Matrix3d& beam = frame.members[static_cast<std::size_t>(project.beam_body)].axes;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(at->stiffness[3 + static_cast<std::size_t>(axis)] > 0.0)) continue;
    const auto about = [&](int of) {
      return std::abs(at->axes.col(axis).dot(beam.col(of))) > hardly_apart;
    };
    if (about(1) || (project.in_space && about(2))) return false;
  }
  return true;
}

bool turns_freely_in(const flexible::Mechanism& mechanism, const Project&,
                     const std::string& name) {
  const auto at = named(mechanism.joints, name);
  return at != mechanism.joints.end() && at->stiffness[2] == 0.0;
}

/// A hinge about the beam's y that nothing drives counts as free, whatever it holds about its z:
/// what comes across is then judged as a force.
bool turns_freely_in(const spatial::Mechanism& mechanism, const Project& project,
                     const std::string& name) {
  if (named(mechanism.springs, name) != mechanism.springs.end()) return true;
  const spatial::BeamPlacement& placement = project.placement;
  const auto about_y = [&](const Eigen::Vector3d& axis_in_body) {
    return std::abs(axis_in_body.dot(placement.axes.col(1))) > 1.0 - hardly_apart;
  };
  const auto closing = named(mechanism.closing, name);
  if (closing != mechanism.closing.end()) {
    using enum spatial::ClosingKind;
    const Eigen::Vector3d axis = closing->a.body == placement.body
                                     ? closing->axis
                                     : Eigen::Vector3d(closing->turn.transpose() * closing->axis);
    switch (closing->kind) {
      case universal:
      case spherical:
      case slot:
      case distance:
      case gear:
      case rack: return true;
      case revolute:
      case cylindrical: return about_y(axis);
      case fixed:
      case prismatic:
      case planar:
      case screw: return false;
    }
  }
  const auto at = named(mechanism.joints, name);
  if (at == mechanism.joints.end() || at->kind != spatial::JointKind::revolute ||
      spatial::is_driven(*at))
    return false;
  return about_y(at->parent == placement.body ? at->axis
                                              : Eigen::Vector3d(at->turn.transpose() * at->axis));
}

/// A load of which the case gives forces at their place, and no moments of its own.
bool turns_freely_in(const recorded::Loads& loads, const Project&, const std::string& name) {
  bool known = false;
  for (const recorded::ChannelSource& of : loads.sources) {
    if (of.load != name) continue;
    known = true;
    if (of.has_moment) return false;
  }
  return known && !(loads.balance && loads.balance->name == name);
}

/// Whether a joint of that name is known to let the beam turn: its couple is that of a force with a
/// lever.
bool turns_freely(const Project& project, const std::string& name) {
  return std::visit([&](const auto& of) { return turns_freely_in(of, project, name); },
                    project.mechanism);
}

/// Whether a joint of a frame holds the turning of the beam rigidly: a clamp, however small its
/// couple.
bool clamps_rigidly(const Project& project, const std::string& name) {
  const auto* const frame = std::get_if<frame::Structure>(&project.mechanism);
  if (frame == nullptr) return false;
  const auto at = named(frame->joints, name);
  return at != frame->joints.end() && std::all_of(at->stiffness.begin() + 3, at->stiffness.end(),
                                                  [](double k) { return std::isinf(k); });
}

/// Whether a name is one of a joint, not of a load of the case (of records it may be either), and
/// whether that joins the beam to another body, not to the ground.
struct Held {
  bool by_joint = true, by_body = false;
};

/// Whether what is between two bodies brings moments into both.
struct BringsMoments {
  static bool both(const planar::Attachment& a, const planar::Attachment& b) {
    return a.body != planar::ground && b.body != planar::ground;
  }
  bool operator()(const planar::Pin&) const { return false; }
  bool operator()(const planar::PinInSlot&) const { return false; }
  bool operator()(const planar::Distance&) const { return false; }
  bool operator()(const planar::Slider& of) const { return both(of.point, of.guide); }
  bool operator()(const planar::Rigid& of) const { return both(of.a, of.b); }
  bool operator()(const planar::AngleCoupling& of) const { return both(of.a, of.b); }
  bool operator()(const planar::Gear& of) const { return both(of.a, of.b); }
  bool operator()(const planar::Rack& of) const { return both(of.pinion, of.rack); }
  bool operator()(const planar::Driven& of) const { return both(of.point, of.other); }
  bool operator()(const planar::Spring&) const { return false; }
  bool operator()(const planar::PinWithClearance&) const { return false; }
  bool operator()(const planar::TorsionSpring& of) const { return both(of.a, of.b); }
  bool operator()(const planar::PointForce&) const { return false; }
  bool operator()(const planar::Couple& of) const { return both(of.a, of.b); }
};

Held held_in(const planar::Mechanism& mechanism, const Project&, const std::string& name) {
  const auto joint = named(mechanism.joints, name);
  if (joint != mechanism.joints.end()) return {true, std::visit(BringsMoments{}, joint->kind)};
  const auto force = named(mechanism.forces, name);
  if (force != mechanism.forces.end() &&
      std::holds_alternative<planar::PinWithClearance>(force->kind))
    return {true, false};
  return {false, force != mechanism.forces.end() && std::visit(BringsMoments{}, force->kind)};
}

Held held_in(const frame::Structure& frame, const Project&, const std::string& name) {
  const auto at = named(frame.joints, name);
  if (at == frame.joints.end()) return {false, false};
  return {true, at->a.member >= 0 && at->b.member >= 0};
}

Held held_in(const flexible::Mechanism& mechanism, const Project&, const std::string& name) {
  const auto at = named(mechanism.joints, name);
  if (at == mechanism.joints.end()) return {false, false};
  return {true, at->a.link >= 0 && at->b.link >= 0};
}

Held held_in(const spatial::Mechanism& mechanism, const Project&, const std::string& name) {
  const auto closing = named(mechanism.closing, name);
  if (closing != mechanism.closing.end())
    return {true, closing->a.body != spatial::ground && closing->b.body != spatial::ground};
  const auto carried_by_body = [&](const spatial::Joint& joint) {
    return joint.parent != spatial::ground;
  };
  const auto spring = named(mechanism.torsion_springs, name);
  if (spring != mechanism.torsion_springs.end())
    return {false, carried_by_body(mechanism.joints[static_cast<std::size_t>(spring->joint)])};
  const auto at = named(mechanism.joints, name);
  if (at == mechanism.joints.end()) return {false, false};
  return {true, carried_by_body(*at)};
}

Held held_in(const recorded::Loads&, const Project&, const std::string&) { return {}; }

Held held_by(const Project& project, const std::string& name) {
  return std::visit([&](const auto& of) { return held_in(of, project, name); }, project.mechanism);
}

}  // namespace

bool stands_at_end(const TaperedBeam& beam, Length s) {
  const Length length = beam.length(), near = hardly_apart * length;
  return s <= near || s >= length - near;
}

bool is_led_in(const TaperedBeam& beam, Length s, Length depth) {
  const Length near = 1e-6 * std::max(beam.length(), depth);
  return std::any_of(beam.introductions.begin(), beam.introductions.end(),
                     [&](const LoadIntroduction& of) {
                       return !of.stiff_length && s >= of.from - near && s <= of.to + near;
                     });
}

void ForceKinds::learn(const SituationRun& run) {
  const LoadHistory& history = run.loads;
  constexpr std::size_t looked_at = 64;
  const std::size_t step = std::max<std::size_t>(1, history.instants() / looked_at);
  struct Largest {
    double force = 0.0, couple = 0.0, half_depth = 0.0;
  };
  std::map<std::string, Largest> largest;
  std::map<std::pair<std::string, std::size_t>, Length> places;
  for (std::size_t i = 0; i < history.instants(); i += step) {
    const BeamLoads loads = history.loads_at(history.time_of(i));
    const std::vector<double> held = run.motion->supports(loads);
    const auto holds = [&](Length s) {
      const double near = hardly_apart * project_->beam.length().value();
      return std::any_of(held.begin(), held.end(),
                         [&](double at) { return std::abs(at - s.value()) <= near; });
    };
    std::map<std::string_view, std::size_t> of_name;
    for (const PointLoad& load : loads.points) {
      const std::size_t number = of_name[load.name]++;
      const std::size_t part = load.part > 0 ? load.part : number;
      const auto at = places.try_emplace({std::string(load.name), part}, load.s).first;
      if (abs(load.s - at->second) > hardly_apart * project_->beam.length())
        moving_.insert(at->first);
      if (!stands_at_end(project_->beam, load.s)) continue;
      const std::string name(load.name);
      if (held_by(*project_, name).by_body && !turns_freely(*project_, name))
        leading_on_.insert(name);
      // What nothing holds is loaded there: a force with a couple is no clamp.
      if (!holds(load.s)) continue;
      Largest& of = largest[name];
      of.force = std::max(of.force, load.force.norm());
      of.couple = std::max(of.couple, std::hypot(load.moment.y(), load.moment.z()));
      of.half_depth =
          0.5 * height_of(section_at(project_->beam, {load.s, Side::both}).outer).value();
    }
  }
  for (const auto& [name, of] : largest) {
    const bool far = held_by(*project_, name).by_joint && of.couple > of.half_depth * of.force &&
                     !turns_freely(*project_, name);
    if (far || clamps_rigidly(*project_, name)) clamps_.insert(name);
  }
}

}  // namespace boxbeam
