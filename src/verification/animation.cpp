#include "boxbeam/verification/animation.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "animation_frames.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/rotation.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/motion_result.hpp"

namespace boxbeam {
namespace {

Eigen::Vector3d lifted_in_space(const Eigen::Vector2d& p) { return {p.x(), p.y(), 0.0}; }

spatial::Attachment lifted_in_space(const planar::Attachment& at) {
  return {at.body, lifted_in_space(at.p)};
}

/// From the beam's axis to what stands off it, and the axis itself.
void add_beam_strokes(const Project& project, const spatial::BeamPlacement& placement,
                      DrawnBody& drawn) {
  const double length = project.beam.length().value();
  const Eigen::Vector3d axis = placement.axes.col(0);
  drawn.strokes.push_back({placement.start, placement.start + length * axis});
  for (const Eigen::Vector3d& point : drawn.points) {
    const double s = std::clamp(axis.dot(point - placement.start), 0.0, length);
    const Eigen::Vector3d on_axis = placement.start + s * axis;
    if ((point - on_axis).norm() < 1e-9 * length) continue;
    drawn.strokes.push_back({on_axis, point});
  }
}

void add_star(DrawnBody& drawn) {
  for (std::size_t k = 1; k < drawn.points.size(); ++k)
    drawn.strokes.push_back({drawn.points.front(), drawn.points[k]});
}

void add_place(const Project& project, const Eigen::Vector3d& p, DrawnBody& drawn) {
  const bool known = std::any_of(drawn.points.begin(), drawn.points.end(), [&](const auto& of) {
    return (of - p).norm() < 1e-9 * project.beam.length().value();
  });
  if (!known) drawn.points.push_back(p);
}

/// Where the beam lies in its body of a planar mechanism, whose origin is its centre of mass.
spatial::BeamPlacement planar_placement_of(const Project& project) {
  spatial::BeamPlacement placement;
  placement.body = project.beam_body;
  if (placement.body == planar::ground) return placement;
  placement.start.x() = -mass_properties_of(project.beam).centre.value();
  placement.axes << 1.0, 0.0, 0.0,  //
      0.0, 0.0, 1.0,                //
      0.0, -1.0, 0.0;
  return placement;
}

/// What stands of a mechanism in space.
StillScene still_scene_of(const spatial::Mechanism& mechanism, const Project& project) {
  StillScene scene;
  scene.animation.beam = placement_in(project, mechanism);
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    scene.animation.bodies.push_back({mechanism.bodies[i].name,
                                      mechanism.bodies[i].mass > 0.0,
                                      drawn_body_of(project, mechanism, static_cast<int>(i)),
                                      {}});
    const spatial::Joint& joint = mechanism.joints[i];
    scene.animation.joints.push_back({joint.name, {joint.parent, joint.at}});
  }
  for (const spatial::ClosingJoint& joint : mechanism.closing) {
    if (joint.kind == spatial::ClosingKind::distance) {
      scene.add_rod(joint.name, joint.a, joint.b);
    } else {
      const bool on_a = joint.a.body == spatial::ground && !spatial::has_teeth(joint.kind);
      scene.animation.joints.push_back({joint.name, on_a ? joint.a : spatial::place_of(joint)});
    }
  }
  for (const spatial::Spring& spring : mechanism.springs) {
    if (spring.clearance)
      scene.animation.joints.push_back({spring.name, spring.a});
    else
      scene.add_rod(spring.name, spring.a, spring.b);
  }
  return scene;
}

FramesAt frames_of(const spatial::Chain& chain) {
  return [&chain](const std::vector<double>& times) {
    FramePoses frames;
    for (const double time : times) {
      const spatial::State state = chain.at(time);
      std::vector<BodyPose>& poses = frames.emplace_back();
      for (const spatial::BodyMotion& body : state.bodies)
        poses.push_back({body.position, body.R_WB, body.omega});
    }
    return frames;
  };
}

/// From the joint that carries the beam, where that travels far. `carrier`: where the joint is, on
/// the body that carries it.
void follow_what_travels(Animation& of, const spatial::Attachment& carrier) {
  constexpr double far = 4.0;
  double largest = 0.0;
  for (std::size_t k = 0; k < of.times.size(); ++k)
    largest = std::max(largest, longest_side(box_at(of, k)));
  if (carrier.body == spatial::ground || longest_side(room_of(of)) <= far * largest) return;
  of.follows = true;
  for (std::size_t k = 0; k < of.times.size(); ++k) {
    const BodyPose& pose = of.bodies[static_cast<std::size_t>(carrier.body)].poses[k];
    const Eigen::Vector3d origin = pose.origin + pose.axes * carrier.p;
    for (AnimatedBody& body : of.bodies) body.poses[k].origin -= origin;
    for (AnimatedRod& rod : of.rods) {
      rod.ends[k].from -= origin;
      rod.ends[k].to -= origin;
    }
  }
  const auto left_behind = [&](int body) {
    if (body == spatial::ground) return true;
    const std::vector<BodyPose>& poses = of.bodies[static_cast<std::size_t>(body)].poses;
    return std::any_of(poses.begin(), poses.end(),
                       [&](const BodyPose& pose) { return pose.origin.norm() > far * largest; });
  };
  for (std::size_t i = 0; i < of.bodies.size(); ++i) {
    if (!left_behind(static_cast<int>(i))) continue;
    of.bodies[i].drawn = {};
    of.bodies[i].has_mass = false;
  }
  std::erase_if(of.joints, [&](const AnimatedJoint& joint) { return left_behind(joint.at.body); });
  std::erase_if(of.rods, [&](const AnimatedRod& rod) {
    return left_behind(rod.a.body) || left_behind(rod.b.body);
  });
}

Animation animation_for(const spatial::Mechanism& mechanism, const Project& project,
                        const std::string& seen_from) {
  StillScene scene = still_scene_of(mechanism, project);
  if (!seen_from.empty() && seen_from != "world") {
    scene.seen_from = spatial::body_index(mechanism, seen_from);
    if (scene.seen_from == spatial::ground)
      throw InputError(fmt::format("there is no body \"{}\" to see the motion from", seen_from));
  }
  const spatial::Chain chain(mechanism);
  return animated(std::move(scene), spatial::time_span_of(mechanism), frames_of(chain));
}

Animation animation_for(const planar::Mechanism& mechanism, const Project& project,
                        const std::string& seen_from) {
  if (!seen_from.empty() && seen_from != "world")
    throw InputError("a planar mechanism is seen from its world only", "leave out --axes");
  StillScene scene;
  scene.animation.z_up = false;
  scene.animation.beam = planar_placement_of(project);
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    scene.animation.bodies.push_back({mechanism.bodies[i].name,
                                      mechanism.bodies[i].mass > 0.0,
                                      drawn_body_of(project, mechanism, static_cast<int>(i)),
                                      {}});
  }
  for (const planar::Joint& joint : mechanism.joints) {
    const auto [a, b] = planar::ends_of(joint);
    if (planar::is_rod(joint)) {
      scene.add_rod(joint.name, lifted_in_space(a), lifted_in_space(b));
    } else if (!planar::is_driver(joint)) {  // which moves a coordinate, and is nowhere
      scene.animation.joints.push_back(
          {joint.name, lifted_in_space(b.body == planar::ground ? b : a)});
    }
  }
  for (const planar::AppliedForce& force : mechanism.forces) {
    if (const auto* spring = std::get_if<planar::Spring>(&force.kind))
      scene.add_rod(force.name, lifted_in_space(spring->a), lifted_in_space(spring->b));
    if (const auto* pin = std::get_if<planar::PinWithClearance>(&force.kind)) {
      scene.animation.joints.push_back(
          {force.name, lifted_in_space(pin->b.body == planar::ground ? pin->b : pin->a)});
    }
  }
  return animated(std::move(scene), planar::time_span_of(mechanism),
                  [&](const std::vector<double>& times) {
                    FramePoses frames;
                    for (const InstantResult& state : motion_of(project, times).states) {
                      std::vector<BodyPose>& poses = frames.emplace_back();
                      for (const BodyMotion& body : state.bodies) {
                        const Eigen::Vector3d turn(0.0, 0.0, body.position.z());
                        poses.push_back({lifted_in_space(body.position.head<2>().eval()),
                                         spatial::rotation_about(turn),
                                         Eigen::Vector3d(0.0, 0.0, body.velocity.z())});
                      }
                    }
                    return frames;
                  });
}

Animation no_animation(const Project& project) {
  throw InputError(front_end_of(project)->obstacle_to_instants(), "leave out --gltf");
}

Animation animation_for(const flexible::Mechanism&, const Project& project, const std::string&) {
  return no_animation(project);
}
Animation animation_for(const frame::Structure&, const Project& project, const std::string&) {
  return no_animation(project);
}
Animation animation_for(const recorded::Loads&, const Project& project, const std::string&) {
  return no_animation(project);
}

}  // namespace

DrawnBody drawn_body_of(const Project& project, const spatial::Mechanism& mechanism, int body) {
  DrawnBody drawn;
  const auto add = [&](const Eigen::Vector3d& p) { add_place(project, p, drawn); };
  const auto index = static_cast<std::size_t>(body);
  add(mechanism.joints[index].point);
  for (const spatial::BodyPoint& point : mechanism.bodies[index].points) add(point.p);
  for (const spatial::Joint& carried : mechanism.joints) {
    if (carried.parent == body) add(carried.at);
  }
  for (const spatial::ClosingJoint& closing : mechanism.closing) {
    if (spatial::has_teeth(closing.kind)) continue;
    if (closing.a.body == body) add(closing.a.p);
    if (closing.b.body == body) add(closing.b.p);
  }
  for (const spatial::Spring& spring : mechanism.springs) {
    if (spring.a.body == body) add(spring.a.p);
    if (spring.b.body == body) add(spring.b.p);
  }
  const spatial::BeamPlacement placement = placement_in(project, mechanism);
  if (body == placement.body) {
    add_beam_strokes(project, placement, drawn);
  } else {
    add_star(drawn);
  }
  return drawn;
}

DrawnBody drawn_body_of(const Project& project, const planar::Mechanism& mechanism, int body) {
  DrawnBody drawn;
  for (const BodyPoint& point : mechanism.bodies[static_cast<std::size_t>(body)].points)
    add_place(project, lifted_in_space(point.p), drawn);
  if (body == project.beam_body) {
    add_beam_strokes(project, planar_placement_of(project), drawn);
  } else {
    add_star(drawn);
  }
  return drawn;
}

Eigen::AlignedBox3d room_of(const Animation& animation) {
  Eigen::AlignedBox3d room;
  for (std::size_t k = 0; k < animation.times.size(); ++k) room.extend(box_at(animation, k));
  return room;
}

Animation scene_of(const Project& project, const spatial::Chain& chain, const AnimatedSpan& span) {
  const spatial::Mechanism& mechanism = chain.mechanism();
  const FramesAt frames_at = frames_of(chain);
  StillScene scene = still_scene_of(mechanism, project);
  const bool resolved =
      take_motion(scene, span.begin, span.length, std::min(span.steps, most_frames), frames_at);
  if (span.also) add_instant(scene, *span.also, frames_at);
  Animation of = std::move(scene.animation);
  of.resolved = resolved;
  of.bodies[static_cast<std::size_t>(of.beam.body)].member = project.beam;
  const spatial::Joint& joint = mechanism.joints[static_cast<std::size_t>(of.beam.body)];
  follow_what_travels(of, {joint.parent, joint.at});
  return of;
}

Animation animation_of(const Project& project, const std::string& seen_from) {
  return std::visit([&](const auto& of) { return animation_for(of, project, seen_from); },
                    project.mechanism);
}

}  // namespace boxbeam
