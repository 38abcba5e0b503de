#include <algorithm>
#include <cmath>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "frame_time.hpp"
#include "frame_vibration.hpp"
#include "front_ends.hpp"
#include "loaded_frame.hpp"

namespace boxbeam {
namespace {

using Eigen::Vector3d;

/// Members as lines with their points, supports as grounds.
PostureFigure figure_of(const Project& project, const frame::Structure& structure, Time time,
                        const std::string& why) {
  PostureFigure figure;
  figure.time = time;
  figure.why = why;
  for (std::size_t m = 0; m < structure.members.size(); ++m) {
    const frame::Member& member = structure.members[m];
    PostureFigure::Line line;
    line.beam = static_cast<int>(m) == project.beam_body;
    const auto place = [&](const Vector3d& p) -> Vector3d {
      return member.start + member.axes * p;
    };
    const Vector3d end = place({member.beam.length().value(), 0.0, 0.0});
    for (const frame::MemberPoint& point : member.points) line.points.push_back(place(point.p));
    line.strokes.push_back({member.start, end});
    for (const frame::MemberPoint& point : member.points) {
      if (point.p.tail<2>().isZero(0.0)) continue;
      line.strokes.push_back({place({point.p.x(), 0.0, 0.0}), place(point.p)});
    }
    figure.bodies.push_back(std::move(line));
  }
  for (const frame::Joint& joint : structure.joints) {
    if (joint.b.member == frame::ground) figure.grounds.push_back(joint.b.p);
  }
  return figure;
}

/// A frame stands, its displacements too small to be seen: one instant.
Animation standing_scene_of(const Project& project, const frame::Structure& structure) {
  Animation scene;
  scene.times = {0.0};
  for (const frame::Member& member : structure.members) {
    AnimatedBody& body = scene.bodies.emplace_back();
    body.name = member.name;
    body.member = member.beam;
    body.poses.push_back({member.start, member.axes, Vector3d::Zero()});
    body.drawn.points.push_back(Vector3d::Zero());
    body.drawn.strokes.push_back({Vector3d::Zero(), {member.beam.length().value(), 0.0, 0.0}});
    for (const frame::MemberPoint& point : member.points) {
      body.drawn.points.push_back(point.p);
      if (!point.p.tail<2>().isZero(0.0))
        body.drawn.strokes.push_back({{point.p.x(), 0.0, 0.0}, point.p});
    }
  }
  for (const frame::Joint& joint : structure.joints) {
    const frame::Place& at = joint.b.member == frame::ground ? joint.b : joint.a;
    scene.joints.push_back({joint.name, {at.member, at.p}});
  }
  scene.beam.body = project.beam_body;
  scene.size = std::max(room_of(scene).sizes().maxCoeff(), 1e-3);
  return scene;
}

std::vector<BeamLoadRow> rows_of(const Project& project, const frame::Structure& structure,
                                 const BeamLoads& loads, Time time) {
  const frame::Member& beam = structure.members[static_cast<std::size_t>(project.beam_body)];
  std::vector<BeamLoadRow> rows = load_rows(loads, time, beam.axes);
  for (BeamLoadRow& row : rows)
    row.place = beam.start + beam.axes * Vector3d(row.s.value(), 0.0, 0.0);
  return rows;
}

class FrameAtRest : public SolvedMotion {
 public:
  FrameAtRest(const Project& project, const Situation& situation, const ElasticModel& model,
              const SharedMotions& shared)
      : project_(&project),
        model_(model),
        frame_(shared.once<LoadedFrame>(index_of(project, situation), [&] {
          return LoadedFrame(frame_in(project, situation));
        })) {}

  LoadHistory loads() const override {
    if (stands_still()) {
      // Loads that are always the same are looked at for a second, at a few instants.
      const LoadSpan span{Time{}, si<Time>(1.0), 2, true};
      return {span, staying_on(project_->beam, [frame = frame_, beam = project_->beam_body](Time) {
                return frame->loads_at(beam, 0.0);
              })};
    }
    const LoadSpan span = slow_span();
    if (model_.level != ModelLevel::modal) return {span, staying_on(project_->beam, slowly())};
    const std::shared_ptr<const FrameResponse> of = response();
    return {of->span_of(span),
            staying_on(project_->beam, [of](Time time) { return of->loads_at(time); })};
  }

  double gravity() const override { return frame_->structure.gravity.norm(); }

  bool stands_still() const override { return !frame_->time(); }

  PostureAt postures(const LoadHistory& loads) const override {
    return [this, &loads](Time time, const std::string& why) {
      PostureFigure figure = figure_of(*project_, frame_->structure, time, why);
      figure.loads = rows_of(*project_, frame_->structure, loads.loads_at(time), time);
      return figure;
    };
  }

  std::optional<Animation> scene(std::optional<Time>) const override {
    return standing_scene_of(*project_, frame_->structure);
  }

  std::vector<DriverLine> driver_lines(const LoadHistory&) const override { return {}; }

  BeamShift beam_shift(Time time) const override {
    frame::Vector6 start = frame_->start_at(project_->beam_body, time.value());
    if (model_.level == ModelLevel::modal && !stands_still()) start += response()->start_at(time);
    return {
        {start[1], start[2]}, {start[5], -start[4]}, frame_->heat_curvature(project_->beam_body)};
  }

  std::optional<double> critical_factor(const LoadHistory& loads, double most) const override {
    if (!pressed_) pressed_ = frame_->pressed_by(loads);
    if (most > looked_up_to_) {
      critical_ = pressed_->critical_factor(most);
      looked_up_to_ = most;
    }
    return std::min(critical_, most);
  }

  std::vector<SupportReaction> reactions(const LoadHistory& loads) const override {
    std::vector<SupportReaction> of;
    for (const frame::Joint& joint : frame_->structure.joints) {
      if (joint.b.member == frame::ground) of.push_back({joint.name, {}, {}});
    }
    for (std::size_t i = 0; i < loads.instants(); ++i) {
      const std::vector<frame::Vector6> all = frame_->reactions_at(loads.time_of(i).value());
      std::size_t next = 0;
      for (std::size_t k = 0; k < all.size(); ++k) {
        if (frame_->structure.joints[k].b.member != frame::ground) continue;
        SupportReaction& reaction = of[next++];
        for (std::size_t c = 0; c < 6; ++c) {
          const double value = all[k][static_cast<Eigen::Index>(c)];
          reaction.low[c] = i == 0 ? value : std::min(reaction.low[c], value);
          reaction.high[c] = i == 0 ? value : std::max(reaction.high[c], value);
        }
      }
    }
    return of;
  }

  std::vector<double> supports(const BeamLoads&) const override {
    std::vector<double> places;
    for (const frame::Joint& joint : frame_->structure.joints) {
      for (const frame::Place* at : {&joint.a, &joint.b}) {
        if (at->member == project_->beam_body) places.push_back(at->p.x());
      }
    }
    return places;
  }

 private:
  /// Of loads by statics.
  LoadSpan slow_span() const {
    constexpr std::size_t instants = 256;
    const TimeSpan of = *frame_->time();
    LoadSpan span{si<Time>(of.begin), si<Time>(of.length), instants, of.closed};
    span.breaks = break_times_in(functions_of(frame_->structure), of.begin, of.length);
    const std::vector<Time> passages = passages_of(frame_->structure);
    span.breaks.insert(span.breaks.end(), passages.begin(), passages.end());
    std::sort(span.breaks.begin(), span.breaks.end());
    return span;
  }
  LoadsAt slowly() const {
    return [frame = frame_, beam = project_->beam_body](Time time) {
      return frame->loads_at(beam, time.value());
    };
  }
  std::shared_ptr<const FrameResponse> response() const {
    if (!response_)
      response_ = std::make_shared<const FrameResponse>(
          *project_, frame_->structure, slow_span(), slowly(),
          static_cast<std::size_t>(model_.modes), model_.parts);
    return response_;
  }

  const Project* project_;
  ElasticModel model_;
  std::shared_ptr<const LoadedFrame> frame_;
  mutable std::shared_ptr<const FrameResponse> response_;  ///< when it is first asked for
  /// Under the loads, of which there are none other, when it is first asked for.
  mutable std::unique_ptr<const LoadedFrame::Pressed> pressed_;
  mutable double looked_up_to_ = 0.0, critical_ = 0.0;
};

class FrameFrontEnd : public FrontEnd {
 public:
  using FrontEnd::FrontEnd;

  std::unique_ptr<const SolvedMotion> solve(const Situation& situation, const ElasticModel& model,
                                            const SharedMotions& shared) const override {
    return std::make_unique<FrameAtRest>(*project_, situation, model, shared);
  }

  std::optional<ModelChoice> own_model() const override {
    ModelChoice choice;
    choice.chosen = {ModelLevel::flexible, 0, 0, {}, false};
    choice.tolerance = project_->model.tolerance;
    choice.reason = "elastic members at rest, exact, by theory of the first order";
    return choice;
  }

  std::string obstacle_to_vibration(const std::deque<SituationRun>&) const override {
    return "nothing moves: loads act slowly";
  }

  AnyMotionResult motion(const std::vector<double>&, const std::string&) const override {
    throw InputError("a frame at rest has no motion",
                     "boxbeam verify gives its reactions and what they do to the beam");
  }

  std::string obstacle_to_instants() const override {
    return "a frame at rest has no instants to choose";
  }

  std::vector<AssemblyResult> assemblies(double) const override {
    throw InputError("a frame is placed by the case, which is its only assembly",
                     "leave out --assemblies");
  }
};

}  // namespace

std::unique_ptr<const FrontEnd> front_end_for(const frame::Structure&, const Project& project) {
  return std::make_unique<FrameFrontEnd>(project);
}

}  // namespace boxbeam
