// The motion of a body by few instants: no place of it astray by more than the tolerance, at any
// instant, by exhaustive comparison with the motion itself.

#include "boxbeam/report/pose_track.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/verification/cycle_figure.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/pictures.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace pose_track_test {

using namespace boxbeam;
using report::pose_at;
using report::PoseSteps;
using report::PoseTrack;
using report::track_of;

namespace {

Eigen::AlignedBox3d room_of_points(const DrawnBody& drawn) {
  Eigen::AlignedBox3d room;
  for (const Eigen::Vector3d& point : drawn.points) room.extend(point);
  for (const auto& [from, to] : drawn.strokes) {
    room.extend(from);
    room.extend(to);
  }
  return room;
}

/// The largest distance between where places of a body are and where the track leads them: its
/// corners and places within, at every instant.
double farthest_off(const PoseTrack& track, const PoseSteps& steps,
                    const std::vector<double>& times, const std::vector<BodyPose>& poses,
                    const Eigen::AlignedBox3d& room) {
  double worst = 0.0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const Eigen::Isometry3d shown = pose_at(track, steps, times, times[k]);
    for (int x = 0; x <= 2; ++x) {
      for (int y = 0; y <= 2; ++y) {
        for (int z = 0; z <= 2; ++z) {
          const Eigen::Vector3d part = 0.5 * Eigen::Vector3d(x, y, z);
          const Eigen::Vector3d p = room.min() + part.cwiseProduct(room.sizes());
          worst = std::max(worst, (shown * p - poses[k].origin - poses[k].axes * p).norm());
        }
      }
    }
  }
  return worst;
}

/// A screw about a skew axis, uneven in time: two and a half turns.
struct Screw {
  std::vector<double> times;
  std::vector<BodyPose> poses;
  Screw() {
    const Eigen::Vector3d axis = Eigen::Vector3d(1.0, -2.0, 0.5).normalized();
    for (int k = 0; k <= 500; ++k) {
      const double t = k / 500.0;
      const double angle = 5.0 * std::numbers::pi * (t + 0.3 * std::sin(4.0 * t));
      const Eigen::AngleAxisd turn(angle, axis);
      times.push_back(t);
      poses.push_back({turn * Eigen::Vector3d(0.7, 0.1, 0.4) + 0.5 * t * axis,
                       turn.toRotationMatrix(), Eigen::Vector3d::Zero()});
    }
  }
};

const Eigen::AlignedBox3d box(Eigen::Vector3d(-0.4, -0.1, -0.2), Eigen::Vector3d(0.8, 0.3, 0.2));

}  // namespace

TEST_CASE("keys of a motion lead every place within the tolerance, and fewer do for more of it",
          "[space]") {
  const Screw screw;
  std::size_t before = screw.times.size() + 1;
  for (const double tolerance : {1e-3, 4e-3, 16e-3}) {
    const PoseTrack track = track_of(screw.times, screw.poses, box, {1e-4, 1e-4}, tolerance);
    CHECK(farthest_off(track, {1e-4, 1e-4}, screw.times, screw.poses, box) <= tolerance);
    // Chords of a circle of radius r are r angle^2/8 off: four times as much for twice the angle.
    CHECK(track.keys.size() < before);
    if (before <= screw.times.size())
      CHECK(std::abs(static_cast<double>(track.keys.size()) / static_cast<double>(before) - 0.5) <
            0.2);
    before = track.keys.size();
  }
}

TEST_CASE("what stands still, or moves evenly, has two keys", "[space]") {
  std::vector<double> times;
  std::vector<BodyPose> still, even;
  for (int k = 0; k <= 1000; ++k) {
    times.push_back(0.01 * k);
    still.push_back({{0.1, 0.2, 0.3}, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()});
    even.push_back(
        {{0.1 * k, 0.0, -0.3 * k}, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()});
  }
  CHECK(track_of(times, still, box, {}, 1e-3).keys == std::vector<std::size_t>{0, 1000});
  CHECK(track_of(times, even, box, {}, 1e-3).keys == std::vector<std::size_t>{0, 1000});
  CHECK(track_of(times, even, box, {}, 1e-3, 314).keys == std::vector<std::size_t>{0, 314, 1000});
}

TEST_CASE("one instant is one key", "[space]") {
  const std::vector<BodyPose> poses{{{0.1, 0.2, 0.3}, Eigen::Matrix3d::Identity(), {}}};
  const PoseTrack track = track_of({0.0}, poses, box, {}, 1e-3);
  CHECK(track.keys == std::vector<std::size_t>{0});
  CHECK((pose_at(track, {}, {0.0}, 0.0).translation() - Eigen::Vector3d(0.1, 0.2, 0.3)).norm() <
        1e-12);
}

TEST_CASE(
    "scenes of shipped cases: the critical instant is that of the motion, the room holds all, "
    "keys lead within a thousandth of the size",
    "[space]") {
  for (const char* path :
       {"sections/landing-gear/gear.toml", "sections/landing-gear/retraction.toml",
        "sections/stewart-rig/rig.toml", "sections/luffing-crane/crane.toml"}) {
    INFO(path);
    const Project project = read_project(test::project_file(path));
    for (const SituationRun& run : run_situations(project)) {
      const double begin = run.loads.begin().value(), period = run.loads.period().value();
      const double critical = begin + 0.3721 * period;  // between two even instants
      const std::optional<Animation> scene = run.motion->scene(si<Time>(critical));
      REQUIRE(scene.has_value());
      CHECK(scene->resolved);
      CHECK(std::is_sorted(scene->times.begin(), scene->times.end()));
      CHECK(scene->times.front() == Approx(begin));
      CHECK(scene->times.back() == Approx(begin + period));
      const spatial::Chain& chain = chain_of(run);
      const auto at = std::find(scene->times.begin(), scene->times.end(), critical);
      REQUIRE(at != scene->times.end());
      const auto k = static_cast<std::size_t>(at - scene->times.begin());
      const spatial::State state = chain.at(critical);
      const spatial::Joint& joint =
          chain.mechanism().joints[static_cast<std::size_t>(scene->beam.body)];
      const Eigen::Vector3d from = scene->follows
                                       ? spatial::position_of(state, {joint.parent, joint.at})
                                       : Eigen::Vector3d(Eigen::Vector3d::Zero());
      const Eigen::AlignedBox3d room = room_of(*scene);
      for (std::size_t i = 0; i < scene->bodies.size(); ++i) {
        const AnimatedBody& body = scene->bodies[i];
        REQUIRE(body.poses.size() == scene->times.size());
        CHECK((body.poses[k].origin + from - state.bodies[i].position).norm() < 1e-9);
        CHECK((body.poses[k].axes - state.bodies[i].R_WB).norm() < 1e-9);
        for (const BodyPose& pose : body.poses) {
          for (const Eigen::Vector3d& p : body.drawn.points)
            CHECK(room.exteriorDistance(pose.origin + pose.axes * p) < 1e-9);
        }
        const Eigen::AlignedBox3d of_body = room_of_points(body.drawn);
        if (of_body.isEmpty()) continue;
        const PoseSteps steps{1e-4 * scene->size, 1e-4};
        const PoseTrack track =
            track_of(scene->times, body.poses, of_body, steps, 1e-3 * scene->size, k);
        CHECK(std::find(track.keys.begin(), track.keys.end(), k) != track.keys.end());
        CHECK(farthest_off(track, steps, scene->times, body.poses, of_body) <= 1e-3 * scene->size);
      }
    }
  }
}

TEST_CASE("a scene that travels is seen from the joint that carries the beam", "[space]") {
  const Project project = read_project(test::project_file("sections/landing-gear/touchdown.toml"));
  const std::deque<SituationRun> runs = run_situations(project);
  const std::optional<Animation> scene = runs.front().motion->scene({});
  REQUIRE(scene.has_value());
  const spatial::Joint& joint =
      chain_of(runs.front()).mechanism().joints[static_cast<std::size_t>(scene->beam.body)];
  const double longest = room_of(*scene).sizes().maxCoeff();
  INFO("size " << scene->size << ", room " << longest << ", follows " << scene->follows);
  if (scene->follows) {
    REQUIRE(joint.parent != spatial::ground);
    const auto& carrier = scene->bodies[static_cast<std::size_t>(joint.parent)].poses;
    for (const BodyPose& pose : carrier) CHECK((pose.origin + pose.axes * joint.at).norm() < 1e-9);
  }
  CHECK(longest < 20.0 * scene->size);
}

TEST_CASE("only pages pay for scenes, and only in space", "[space]") {
  const Project gear = read_project(test::project_file("sections/landing-gear/gear.toml"));
  const std::deque<SituationRun> runs = run_situations(gear);
  CHECK(!cycle_figure_of(gear, runs.front(), nullptr, Figures::with).scene);
  CHECK(cycle_figure_of(gear, runs.front(), nullptr, Figures::with_scenes).scene);
  const Project rig = read_project(test::project_file("sections/sledge-rig/rig.toml"));
  const std::deque<SituationRun> flat = run_situations(rig);
  CHECK(!cycle_figure_of(rig, flat.front(), nullptr, Figures::with_scenes).scene);
}

}  // namespace pose_track_test
