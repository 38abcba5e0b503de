#include <algorithm>
#include <exception>
#include <memory>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/project/project.hpp"
#include "peers/answers.hpp"
#include "peers/sledge_rig.hpp"

namespace peers {
namespace {

using namespace boxbeam;
using Eigen::Vector2d;
using Forces = std::array<Vector2d, pins.size()>;

/// One way to find instants of the rig, each from the one before.
class Way {
 public:
  virtual ~Way() = default;
  /// The first instant, where the posture is known, and from a rough one. Throw where they refuse.
  virtual void start(double time, const Eigen::VectorXd& posture) = 0;
  virtual void assemble(double time, const Eigen::VectorXd& posture) = 0;
  /// Positions, velocities, accelerations and the forces of the pins. Throws where it refuses.
  virtual void advance(double time, Forces& forces) = 0;
  /// Where B and E are now.
  virtual std::array<Vector2d, 2> places() const = 0;
};

class Boxbeam final : public Way {
 public:
  Boxbeam(const SledgeRig& rig, planar::Elimination elimination)
      : rig_(&rig), solver_(rig.mechanism(), elimination) {
    for (const Pinned& pin : pins) {
      wanted_.emplace_back(planar::joint_index(rig.mechanism(), pin.joint),
                           planar::body_index(rig.mechanism(), part_names[pin.on]));
    }
  }

  void start(double time, const Eigen::VectorXd& posture) override {
    state_ = solver_.solve_from_sketch(time, posture);
  }
  void assemble(double time, const Eigen::VectorXd& posture) override { start(time, posture); }

  void advance(double time, Forces& forces) override {
    solver_.solve_near(time, state_, next_);
    std::swap(state_, next_);
    for (const planar::Reaction& reaction : planar::reactions_of(rig_->mechanism(), state_)) {
      for (std::size_t i = 0; i < wanted_.size(); ++i) {
        if (wanted_[i] == std::pair(reaction.joint, reaction.on)) forces[i] = reaction.force;
      }
    }
  }

  std::array<Vector2d, 2> places() const override {
    return {planar::position_of(rig_->at("B", "upper_rod"), state_.q),
            planar::position_of(rig_->at("E", "lower_rod"), state_.q)};
  }

 private:
  const SledgeRig* rig_;
  planar::InstantSolver solver_;
  std::vector<std::pair<int, int>> wanted_;
  planar::State state_, next_;
};

class Simbody final : public Way {
 public:
  Simbody(const SledgeRig& rig, bench::Model model, bench::Start start_at, double accuracy)
      : rig_(&rig), inside_(rig.data(), model, start_at, accuracy) {}

  void start(double time, const Eigen::VectorXd& posture) override {
    inside_.start(time, plain(posture));
  }
  void assemble(double time, const Eigen::VectorXd& posture) override {
    inside_.assemble(time, plain(posture));
  }

  void advance(double time, Forces& forces) override {
    inside_.advance(time, plain_);
    for (std::size_t i = 0; i < plain_.size(); ++i) forces[i] = {plain_[i].x, plain_[i].y};
  }

  std::array<Vector2d, 2> places() const override {
    const bench::Point b = inside_.place(bench::pin_b);
    const bench::Point e = inside_.place(bench::pin_e);
    return {Vector2d(b.x, b.y), Vector2d(e.x, e.y)};
  }

 private:
  std::array<bench::PartPosture, bench::parts> plain(const Eigen::VectorXd& posture) const {
    std::array<bench::PartPosture, bench::parts> postures;
    for (std::size_t part = bench::beam; part < bench::parts; ++part) {
      const Eigen::Index i = 3 * planar::body_index(rig_->mechanism(), part_names[part]);
      postures[part] = {{posture[i], posture[i + 1]}, posture[i + 2]};
    }
    return postures;
  }

  const SledgeRig* rig_;
  bench::SimbodyRig inside_;
  std::array<bench::Point, bench::pins> plain_;
};

std::unique_ptr<Way> way_of(const SledgeRig& rig, const Json& request) {
  const std::string way = request.at("way");
  if (way == "boxbeam") {
    const bool dense = request.value("dense", false);
    return std::make_unique<Boxbeam>(
        rig, dense ? planar::Elimination::dense : planar::Elimination::sparse);
  }
  if (way != "simbody") throw std::runtime_error("no way to solve the rig: " + way);
  const bool tree = request.value("tree", true);
  const bool predicted = request.value("predicted", true);
  return std::make_unique<Simbody>(
      rig, tree ? bench::Model::compact_tree : bench::Model::planar_joints,
      predicted ? bench::Start::predicted : bench::Start::last, request.at("accuracy"));
}

SledgeRig rig_of(const Json& request) {
  SledgeRig rig(
      planar_of(read_project(std::string(BOXBEAM_SOURCE_DIR) + "/sections/sledge-rig/rig.toml")));
  if (request.contains("rod")) rig.set_upper_rod(request.at("rod"));
  if (request.contains("amplitude")) rig.set_amplitude(request.at("amplitude"));
  return rig;
}

/// What the reference calculation takes over, and a mass that it has its own figure of.
Json answer_data(const SledgeRig& rig) {
  const bench::RigData data = rig.data();
  return {{"beam_mass", data.content[bench::beam].mass},
          {"beam_inertia", data.content[bench::beam].inertia},
          {"omega", data.omega},
          {"period", planar::time_span_of(rig.mechanism()).length}};
}

/// One instant from a posture off in all angles.
Json answer_rough(const SledgeRig& rig, const Json& request) {
  const double time = request.at("time");
  Eigen::VectorXd posture = rig.position(time).value();
  const double off = request.at("off");
  for (const char* body : {"beam", "upper_rod", "lower_rod"}) {
    posture[3 * planar::body_index(rig.mechanism(), body) + 2] += off;
  }
  try {
    const std::unique_ptr<Way> way = way_of(rig, request);
    way->assemble(time, posture);
    const auto [b, e] = way->places();
    return {{"places", {b.x(), b.y(), e.x(), e.y()}}};
  } catch (const std::exception& error) {
    return {{"refused", error.what()}};
  }
}

/// Instants of equal distance over the period, each from the one before; the first is at t = 0.
Json answer_followed(const SledgeRig& rig, const Json& request) {
  const int count = request.at("instants");
  const double period = planar::time_span_of(rig.mechanism()).length;
  Json rows = Json::array();
  try {
    const std::unique_ptr<Way> way = way_of(rig, request);
    way->start(0.0, rig.position(0.0).value());
    for (int i = 1; i <= count; ++i) {
      Forces forces;
      way->advance(period * i / count, forces);
      const auto [b, e] = way->places();
      Json row{b.x(), b.y(), e.x(), e.y()};
      for (const Vector2d& force : forces) {
        row.push_back(force.x());
        row.push_back(force.y());
      }
      rows.push_back(std::move(row));
    }
  } catch (const std::exception& error) {
    return {{"rows", rows}, {"refused", error.what()}};
  }
  return {{"rows", rows}};
}

/// Processor time of an instant [s].
Json answer_time(const SledgeRig& rig, const Json& request) {
  const int count = request.at("instants");
  const int turns = request.at("turns");
  const double period = planar::time_span_of(rig.mechanism()).length;
  const std::unique_ptr<Way> way = way_of(rig, request);
  way->start(0.0, rig.position(0.0).value());
  Forces forces;
  const double begin = processor_time();
  for (int i = 1; i <= turns * count; ++i) way->advance(period * i / count, forces);
  return {{"seconds", (processor_time() - begin) / (turns * count)}};
}

}  // namespace

Json answer_sledge(const Json& request) {
  const SledgeRig rig = rig_of(request);
  const std::string what = request.at("what");
  if (what == "data") return answer_data(rig);
  if (what == "rough") return answer_rough(rig, request);
  if (what == "time") return answer_time(rig, request);
  return answer_followed(rig, request);
}

}  // namespace peers
