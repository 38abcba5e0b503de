#include "html_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/report/gltf.hpp"
#include "boxbeam/report/pose_track.hpp"

namespace boxbeam::report::html {
namespace {

/// How far a body may be drawn astray, of the scene's size.
constexpr double astray = 1e-3;

Json decimal(double value) { return Json::parse(fmt::format("{:.9g}", finite(value))); }

long in_units(double value, double unit) { return std::lround(finite(value) / unit); }

void put_place(Json& row, const Eigen::Vector3d& p, double unit) {
  for (const double x : p) row.push_back(in_units(x, unit));
}

Json place_of(const Eigen::Vector3d& p, double unit) {
  Json row = Json::array();
  put_place(row, p, unit);
  return row;
}

Json attachment_of(const spatial::Attachment& at, double unit) {
  Json row = Json::array({at.body});
  put_place(row, at.p, unit);
  return row;
}

/// Numbers as their steps from those so many places before.
Json steps_between(const std::vector<long>& numbers, std::size_t apart) {
  Json row = Json::array();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    row.push_back(i < apart ? numbers[i] : numbers[i] - numbers[i - apart]);
  return row;
}

/// The room that a body takes, in its axes.
Eigen::AlignedBox3d room_of_body(const Animation& scene, int index) {
  const AnimatedBody& body = scene.bodies[static_cast<std::size_t>(index)];
  Eigen::AlignedBox3d room;
  for (const Eigen::Vector3d& point : body.drawn.points) room.extend(point);
  for (const auto& [from, to] : body.drawn.strokes) {
    room.extend(from);
    room.extend(to);
  }
  // As large as scene.js draws a block, which shows that it turns.
  if (body.drawn.strokes.empty() && body.has_mass && !room.isEmpty()) {
    const Eigen::Vector3d half = Eigen::Vector3d::Constant(scene.size / 60.0);
    room.extend(Eigen::Vector3d(body.drawn.points.front() - half));
    room.extend(Eigen::Vector3d(body.drawn.points.front() + half));
  }
  if (!body.member) return room;
  const bool placed = index == scene.beam.body;
  for (const Eigen::Vector3d& corner : surface_of(*body.member).corners) {
    room.extend(placed ? Eigen::Vector3d(scene.beam.start + scene.beam.axes * corner) : corner);
  }
  return room;
}

class SceneData {
 public:
  SceneData(const CycleFigure& cycle, BeamShapes& shapes)
      : cycle_(&cycle),
        scene_(&*cycle.scene),
        shapes_(&shapes),
        unit_(std::pow(10.0, std::floor(std::log10(scene_->size)) - 4.0)) {}

  Json data() {
    follow_bodies();
    const Eigen::AlignedBox3d room = room_of(*scene_);
    Json joints = Json::array(), rods = Json::array();
    for (const AnimatedJoint& joint : scene_->joints)
      joints.push_back({{"name", visible(joint.name)}, {"at", attachment_of(joint.at, unit_)}});
    for (const AnimatedRod& rod : scene_->rods) {
      rods.push_back({{"name", visible(rod.name)},
                      {"a", attachment_of(rod.a, unit_)},
                      {"b", attachment_of(rod.b, unit_)}});
    }
    Json times = Json::array();
    for (const std::size_t key : keys_) times.push_back(decimal(scene_->times[key]));
    return {{"unit", decimal(unit_)},
            {"turn", decimal(steps().turn)},
            {"size", decimal(scene_->size)},
            {"room", Json::array({place_of(room.min(), unit_), place_of(room.max(), unit_)})},
            {"follows", scene_->follows},
            {"resolved", scene_->resolved},
            {"times", std::move(times)},
            {"bodies", bodies()},
            {"joints", std::move(joints)},
            {"rods", std::move(rods)},
            {"beam", beam()},
            {"forces", forces()}};
  }

 private:
  PoseSteps steps() const { return {unit_, 1e-4}; }

  void follow_bodies() {
    std::optional<std::size_t> also;
    if (cycle_->critical) {
      const double time = cycle_->critical->frame.time.value();
      const auto at = std::find(scene_->times.begin(), scene_->times.end(), time);
      if (at != scene_->times.end()) also = static_cast<std::size_t>(at - scene_->times.begin());
    }
    for (std::size_t i = 0; i < scene_->bodies.size(); ++i) {
      const Eigen::AlignedBox3d room = room_of_body(*scene_, static_cast<int>(i));
      PoseTrack& track = tracks_.emplace_back();
      if (room.isEmpty()) continue;  // nothing of it is drawn
      track = track_of(scene_->times, scene_->bodies[i].poses, room, steps(), astray * scene_->size,
                       also);
      keys_.insert(track.keys.begin(), track.keys.end());
    }
  }

  /// The number of an instant among those that are keys.
  long number_of_key(std::size_t key) const {
    return static_cast<long>(std::distance(keys_.begin(), keys_.find(key)));
  }

  Json bodies() const {
    Json all = Json::array();
    for (std::size_t i = 0; i < scene_->bodies.size(); ++i) {
      const AnimatedBody& body = scene_->bodies[i];
      const PoseTrack& track = tracks_[i];
      if (track.keys.empty()) {
        all.push_back(nullptr);
        continue;
      }
      std::vector<long> keys, poses;
      for (const std::size_t key : track.keys) keys.push_back(number_of_key(key));
      for (const auto& pose : track.poses) poses.insert(poses.end(), pose.begin(), pose.end());
      Json strokes = Json::array();
      // The axis of a beam is in its shape.
      for (std::size_t k = body.member ? 1 : 0; k < body.drawn.strokes.size(); ++k) {
        put_place(strokes, body.drawn.strokes[k].from, unit_);
        put_place(strokes, body.drawn.strokes[k].to, unit_);
      }
      Json of{{"name", visible(body.name)},
              {"keys", steps_between(keys, 1)},
              {"poses", steps_between(poses, 7)},
              {"strokes", std::move(strokes)}};
      if (body.member) {
        of["shape"] = shapes_->number_of(*body.member, unit_ / 10.0);
        Json& ends = of["ends"] = Json::array();
        put_place(ends, body.drawn.strokes.front().from, unit_);
        put_place(ends, body.drawn.strokes.front().to, unit_);
      }
      if (body.drawn.strokes.empty() && body.has_mass)
        of["block"] = place_of(body.drawn.points.front(), unit_);
      all.push_back(std::move(of));
    }
    return all;
  }

  /// Where the verified beam lies in its body, and how far its sections reach.
  Json beam() const {
    const spatial::BeamPlacement& placement = scene_->beam;
    const TaperedBeam& beam = *scene_->bodies[static_cast<std::size_t>(placement.body)].member;
    double radius = 0.0;
    for (const Eigen::Vector3d& corner : surface_of(beam).corners)
      radius = std::max(radius, corner.tail<2>().norm());
    Json axes = Json::array();
    for (const double x : placement.axes.reshaped()) axes.push_back(decimal(x));
    return {{"body", placement.body},
            {"start", place_of(placement.start, unit_)},
            {"axes", std::move(axes)},
            {"radius", decimal(radius)}};
  }

  /// Of every load of each frame its station [m] and, in thousandths of the largest force, its
  /// components.
  Json forces() const {
    std::vector<const CycleFrame*> frames;
    for (const CycleFrame& frame : cycle_->frames) frames.push_back(&frame);
    if (cycle_->critical) frames.push_back(&cycle_->critical->frame);
    double largest = 0.0;
    for (const CycleFrame* frame : frames) {
      for (const BeamLoadRow& load : frame->posture.loads)
        largest = std::max(largest, load.world.norm());
    }
    Json all = Json::array();
    for (const CycleFrame* frame : frames) {
      Json& of = all.emplace_back(Json::array());
      for (const BeamLoadRow& load : frame->posture.loads) {
        Json row = Json::array({Json::parse(fmt::format("{:.5g}", finite(load.s.value())))});
        for (const double f : load.world)
          row.push_back(largest > 0.0 ? std::lround(1e3 * finite(f) / largest) : 0L);
        of.push_back(std::move(row));
      }
    }
    return all;
  }

  const CycleFigure* cycle_;
  const Animation* scene_;
  BeamShapes* shapes_;
  double unit_;
  std::vector<PoseTrack> tracks_;
  std::set<std::size_t> keys_;
};

}  // namespace

std::size_t BeamShapes::number_of(const TaperedBeam& beam, double unit) {
  const Surface surface = surface_of(beam);
  std::vector<long> corners, triangles;
  for (const Eigen::Vector3d& corner : surface.corners) {
    for (const double x : corner) corners.push_back(in_units(x, unit));
  }
  for (const auto& triangle : surface.triangles)
    triangles.insert(triangles.end(), triangle.begin(), triangle.end());
  Json shape{{"unit", decimal(unit)},
             {"corners", steps_between(corners, 3)},
             {"triangles", steps_between(triangles, 1)}};
  const auto [known, is_new] = known_.try_emplace(shape.dump(), all_.size());
  if (is_new) all_.push_back(std::move(shape));
  return known->second;
}

Json scene_data(const CycleFigure& cycle, BeamShapes& shapes) {
  if (!cycle.scene) return nullptr;
  return SceneData(cycle, shapes).data();
}

}  // namespace boxbeam::report::html
