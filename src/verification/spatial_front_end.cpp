#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "bent_in_space.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/motion.hpp"
#include "boxbeam/mechanism/spatial/rest.hpp"
#include "boxbeam/verification/animation.hpp"
#include "boxbeam/verification/chain_motion_result.hpp"
#include "elastic_motion_in_space.hpp"
#include "front_ends.hpp"
#include "stopped_in_space.hpp"
#include "vibration_in_space.hpp"

namespace boxbeam {
namespace {

/// Where a joint is on the body that carries it, world [m].
Eigen::Vector3d place_of(const spatial::Joint& joint, const spatial::State& state) {
  return spatial::position_of(state, {joint.parent, joint.at});
}

/// The origin of a posture in space.
Eigen::Vector3d origin_of(const Project& project, const spatial::Mechanism& mechanism,
                          const spatial::State& state) {
  return place_of(mechanism.joints[static_cast<std::size_t>(placement_in(project, mechanism).body)],
                  state);
}

std::vector<BeamLoadRow> load_rows(const Project& project, const spatial::Mechanism& mechanism,
                                   const BeamLoads& loads, const spatial::State& state) {
  const spatial::BeamPlacement beam = placement_in(project, mechanism);
  const Eigen::Matrix3d& R_WB = state.bodies[static_cast<std::size_t>(beam.body)].R_WB;
  std::vector<BeamLoadRow> rows = load_rows(loads, si<Time>(state.time), R_WB * beam.axes);
  const Eigen::Vector3d origin = origin_of(project, mechanism, state);
  for (BeamLoadRow& row : rows) {
    const Eigen::Vector3d on_axis = beam.start + row.s.value() * beam.axes.col(0);
    row.place = spatial::position_of(state, {beam.body, on_axis}) - origin;
  }
  return rows;
}

/// The bodies that the beam's joint carries, and axes of joints.
PostureFigure posture_figure(const Project& project, const spatial::Mechanism& mechanism,
                             const spatial::State& state, const std::string& why) {
  const Eigen::Vector3d origin = origin_of(project, mechanism, state);
  const int beam = placement_in(project, mechanism).body;
  const spatial::Joint& root = mechanism.joints[static_cast<std::size_t>(beam)];
  PostureFigure figure;
  figure.time = si<Time>(state.time);
  figure.why = why;
  figure.grounds.push_back(Eigen::Vector3d::Zero());

  std::vector<bool> shown(mechanism.bodies.size(), false);
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const spatial::Joint& joint = mechanism.joints[i];
    shown[i] = joint.parent == root.parent ||
               (joint.parent != spatial::ground && shown[static_cast<std::size_t>(joint.parent)]);
    if (!shown[i]) continue;
    const int body = static_cast<int>(i);
    const auto place = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return spatial::position_of(state, {body, p}) - origin;
    };
    PostureFigure::Line line;
    line.beam = body == beam;
    const DrawnBody drawn = drawn_body_of(project, mechanism, body);
    for (const Eigen::Vector3d& point : drawn.points) line.points.push_back(place(point));
    for (const PostureFigure::Stroke& stroke : drawn.strokes)
      line.strokes.push_back({place(stroke.from), place(stroke.to)});
    // From a wheel's axis, or the rack's point, to where the teeth meet others.
    for (const spatial::ClosingJoint& closing : mechanism.closing) {
      if (!spatial::has_teeth(closing.kind)) continue;
      if (closing.a.body != body && closing.b.body != body) continue;
      const Eigen::Vector3d meet = spatial::position_of(state, closing.mesh.at) - origin;
      Eigen::Vector3d from = place(joint.point);
      if (spatial::is_angle(joint.kind)) {
        const Eigen::Vector3d axis = spatial::in_world(state, joint.parent, joint.axis);
        from += axis.dot(meet - from) * axis;
      }
      line.strokes.push_back({from, meet});
    }
    if (joint.kind != spatial::JointKind::fixed) {
      figure.guides.push_back(
          {place_of(joint, state) - origin, spatial::in_world(state, joint.parent, joint.axis)});
    }
    figure.bodies.push_back(std::move(line));
  }
  for (const spatial::ClosingJoint& closing : mechanism.closing) {
    const Eigen::Vector3d a = spatial::position_of(state, closing.a) - origin;
    if (closing.kind == spatial::ClosingKind::distance)
      figure.rods.push_back({a, spatial::position_of(state, closing.b) - origin});
    if (closing.a.body == spatial::ground) figure.grounds.push_back(a);
  }
  for (const spatial::Spring& spring : mechanism.springs) {
    if (spring.clearance) continue;
    figure.rods.push_back({spatial::position_of(state, spring.a) - origin,
                           spatial::position_of(state, spring.b) - origin});
  }
  return figure;
}

/// The joints that move.
std::vector<DriverLine> driver_lines_of(const spatial::Chain& chain,
                                        const spatial::Motion& motion) {
  constexpr int steps = 192;
  const spatial::Mechanism& mechanism = chain.mechanism();
  const std::size_t carrying = mechanism.joints.size();
  std::vector<DriverLine> lines(carrying + mechanism.closing.size());
  for (int k = 0; k <= steps; ++k) {
    const double time = motion.begin + motion.period * (static_cast<double>(k) / steps);
    const spatial::State state = chain.at(time);
    const std::vector<spatial::Wrench> wrenches = chain.joint_wrenches(state);
    for (std::size_t i = 0; i < carrying; ++i) {
      const spatial::Joint& joint = mechanism.joints[i];
      if (!spatial::is_driven(joint) && !spatial::is_forced(joint)) continue;
      lines[i].name = spatial::driver_text(joint);
      lines[i].turns = spatial::is_angle(joint.kind);
      // Where forces move it nothing but friction acts along its axis.
      std::optional<double> force;
      if (!spatial::is_forced(joint)) force = chain.along_axis(state, i, wrenches[i]);
      add_sample(lines[i], time, state.coordinates[i], force);
    }
    for (std::size_t i = carrying; i < lines.size(); ++i) {
      const spatial::ClosingJoint& joint = mechanism.closing[i - carrying];
      if (joint.driver_name.empty()) continue;
      const Eigen::Vector3d along =
          (spatial::position_of(state, joint.b) - spatial::position_of(state, joint.a))
              .normalized();
      lines[i].name = spatial::driver_text(joint);
      add_sample(lines[i], time, driver_at(joint.length, time), along.dot(wrenches[i].force));
    }
  }
  std::erase_if(lines, [](const DriverLine& line) {
    if (line.position.empty()) return true;
    return std::all_of(line.position.begin(), line.position.end(),
                       [&](double value) { return value == line.position.front(); });
  });
  return lines;
}

/// Stops where rigid bodies do not determine what acts on the beam.
void check_unique_loads(const spatial::Chain& chain, int beam) {
  if (chain.loops() == nullptr) return;
  const spatial::Mechanism& mechanism = chain.mechanism();
  const std::size_t carrying = mechanism.joints.size();
  std::vector<std::string> on_beam;
  for (std::size_t i = 0; i < chain.loops()->unique().size(); ++i) {
    if (chain.loops()->unique()[i]) continue;
    if (i < carrying) {
      const bool holds = static_cast<int>(i) == beam || mechanism.joints[i].parent == beam;
      if (holds) on_beam.push_back(mechanism.joints[i].name);
    } else {
      const spatial::ClosingJoint& joint = mechanism.closing[i - carrying];
      if (joint.a.body == beam || joint.b.body == beam) on_beam.push_back(joint.name);
    }
  }
  if (on_beam.empty()) return;
  throw AnalysisError(
      {fmt::format("the loads on the beam are not determined by rigid bodies: joints repeat each "
                   "other ({}), and how they share their load depends on their stiffness; release "
                   "one of them (\"spherical\" or \"cylindrical\" for \"revolute\")",
                   fmt::join(spatial::names_not_unique(mechanism, *chain.loops()), ", ")),
       fmt::format("joint {}", fmt::join(on_beam, ", "))});
}

class SpatialMotion : public SolvedMotion {
 public:
  SpatialMotion(const Project& project, const Situation& situation, const ElasticModel& model,
                const SharedMotions& shared)
      : project_(&project),
        model_(model),
        chain_(shared.once<spatial::Chain>(
            index_of(project, situation),
            [&] { return spatial::Chain(spatial_in(project, situation)); })),
        motion_(*shared.once<spatial::Motion>(index_of(project, situation),
                                              [&] { return spatial::motion_of(*chain_); })),
        states_(std::make_shared<const spatial::StatesAround>(*chain_, motion_)) {
    check_unique_loads(*chain_, placement_in(project, chain_->mechanism()).body);
  }

  LoadHistory loads() const override {
    const LoadSpan looked_at = span();
    auto body = spatial::beam_body_of(project_->beam, placement_in(*project_, chain_->mechanism()),
                                      chain_->mechanism());
    LoadsAt rigid = staying_on(project_->beam, [chain = chain_, states = states_, body](Time time) {
      return spatial::beam_loads_of(*chain, states->at(time.value()), body);
    });
    return elastic_loads_in_space(*project_, *chain_, looked_at, model_, std::move(rigid));
  }

  /// The time of the motion.
  LoadSpan span() const {
    LoadSpan span{si<Time>(motion_.begin), si<Time>(motion_.period), motion_.instants,
                  motion_.closed};
    span.breaks =
        break_times_in(spatial::functions_of(chain_->mechanism()), motion_.begin, motion_.period);
    for (const double at : motion_.changes) span.breaks.push_back(si<Time>(at));
    std::sort(span.breaks.begin(), span.breaks.end());
    return span;
  }

  double gravity() const override { return chain_->mechanism().gravity.norm(); }

  PostureAt postures(const LoadHistory& loads) const override {
    return [this, &loads](Time time, const std::string& why) {
      const spatial::State state = states_->at(time.value());
      PostureFigure posture = posture_figure(*project_, chain_->mechanism(), state, why);
      posture.loads = load_rows(*project_, chain_->mechanism(), loads.loads_at(time), state);
      return posture;
    };
  }

  std::optional<Animation> scene(std::optional<Time> also) const override {
    AnimatedSpan span{motion_.begin, motion_.period, motion_.instants, {}};
    if (also) span.also = within(also->value());
    return scene_of(*project_, *chain_, span);
  }

  std::vector<DriverLine> driver_lines(const LoadHistory&) const override {
    return driver_lines_of(*chain_, motion_);
  }

  /// The joint that carries the beam's body, which clamps it where nothing else holds it: loops do.
  std::vector<double> supports(const BeamLoads&) const override {
    const spatial::Mechanism& mechanism = chain_->mechanism();
    const spatial::BeamPlacement placement = placement_in(*project_, mechanism);
    std::vector<double> at;
    for (const Eigen::Vector3d& place : spatial::holds_of(mechanism, placement.body)) {
      at.push_back(
          std::clamp(spatial::in_beam(placement, place).x(), 0.0, project_->beam.length().value()));
    }
    return at;
  }

  std::optional<double> critical_factor_at(Time time, const CutForceDiagram& diagram,
                                           double most) const override {
    return critical_factor_in_space(*project_, *chain_, states_->at(time.value()), diagram, most,
                                    profiles_);
  }

  const spatial::Chain& chain() const { return *chain_; }

  std::optional<frame::BentScene> bent_at(Time time, const CutForceDiagram& diagram,
                                          double factor) const {
    if (!bent_) {
      if (!obstacle_to_bending_in_space(*project_, *chain_).empty()) return {};
      bent_.emplace(*project_, *chain_);
    }
    return bent_->at(states_->at(time.value()), diagram, factor);
  }

 private:
  /// Behind the end of a motion that does not repeat bodies stand where it ends.
  double within(double time) const {
    return motion_.closed ? time : std::clamp(time, motion_.begin, motion_.begin + motion_.period);
  }

  const Project* project_;
  ElasticModel model_;
  std::shared_ptr<const spatial::Chain> chain_;
  spatial::Motion motion_;
  std::shared_ptr<const spatial::StatesAround> states_;
  mutable std::optional<BentInSpace> bent_;  ///< made when first asked for
  mutable StoppedProfiles profiles_;
};

class SpatialFrontEnd : public FrontEnd {
 public:
  using FrontEnd::FrontEnd;

  std::unique_ptr<const SolvedMotion> solve(const Situation& situation, const ElasticModel& model,
                                            const SharedMotions& shared) const override {
    return std::make_unique<SpatialMotion>(*project_, situation, model, shared);
  }

  std::string obstacle_to_vibration(const std::deque<SituationRun>& rigid) const override {
    return obstacle_to_vibration_in_space(rigid);
  }

  AnyMotionResult motion(const std::vector<double>& times, const std::string& axes) const override {
    return chain_motion_of(*project_, times, axes.empty() ? "world" : axes);
  }

  std::vector<AssemblyResult> assemblies(double) const override {
    throw InputError(
        "a mechanism in space has one assembly: a chain no other, and loops stand nearest "
        "to the \"start\" of their joints",
        "leave out --assemblies");
  }
};

}  // namespace

std::unique_ptr<const FrontEnd> front_end_for(const spatial::Mechanism&, const Project& project) {
  return std::make_unique<SpatialFrontEnd>(project);
}

const spatial::Chain& chain_of(const SituationRun& run) {
  return dynamic_cast<const SpatialMotion&>(*run.motion).chain();
}

std::optional<frame::BentScene> bent_scene_in(const SituationRun& run, Time time,
                                              const CutForceDiagram& diagram, double factor) {
  const auto* const motion = dynamic_cast<const SpatialMotion*>(run.motion.get());
  if (motion == nullptr) return {};
  return motion->bent_at(time, diagram, factor);
}

LoadSpan span_of_motion_in_space(const SituationRun& run) {
  return dynamic_cast<const SpatialMotion&>(*run.motion).span();
}

}  // namespace boxbeam
