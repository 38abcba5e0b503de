#include "neighbours.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/fatigue/damage.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "rules.hpp"

namespace oracle {

using namespace boxbeam;

namespace {

/// The force on a pin at every instant of every situation, as it is seen from somewhere.
using Seen = std::vector<std::vector<Eigen::Vector3d>>;

/// A pin: the forces that its strength is judged by, times their load factors, and what they are in
/// axes in which they turn.
struct PinForces {
  double largest = 0.0;
  std::vector<Seen> seen;
  bool flat = true;  ///< all of them lie across one axis, z of every frame
};

/// Takes down the forces of one instant: of each frame one.
void note_instant(PinForces& of, std::size_t situation, std::size_t situations, double factor,
                  double size, const std::vector<Eigen::Vector3d>& seen) {
  of.largest = std::max(of.largest, factor * size);
  of.seen.resize(seen.size(), Seen(situations));
  for (std::size_t k = 0; k < seen.size(); ++k) of.seen[k][situation].push_back(seen[k]);
}

Eigen::Vector3d flat(const Eigen::Vector2d& force) { return {force.x(), force.y(), 0.0}; }

/// Two axes across a pin and the pin.
Eigen::Matrix3d axes_of_pin(const Eigen::Vector3d& pin) {
  Eigen::Matrix3d axes;
  axes.row(2) = pin.normalized();
  axes.row(0) = pin.unitOrthogonal();
  axes.row(1) = pin.normalized().cross(axes.row(0).transpose());
  return axes;
}

class Beside {
 public:
  Beside(const Project& project, const Life& life, Findings& found)
      : project_(project), life_(life), found_(found), rules_(project) {
    pins_.resize(project.pins.size());
  }

  void look_in_plane(const SituationRun& run, const Run& sampled);
  void look_in_space(const SituationRun& run, const Run& sampled);
  void judge() {
    for (std::size_t i = 0; i < pins_.size(); ++i) {
      const PinInput& pin = project_.pins[i];
      found_.note(Criterion::pin, pin_utilisation(pins_[i].largest, pin, project_.strength), {},
                  pin.name);
      for (const LugInput& lug : pin.lugs) {
        found_.note(Criterion::pin, lug_utilisation(pins_[i].largest, pin, lug, project_.strength),
                    {}, pin.name + " lug");
        if (project_.fatigue.asked) tire(pin, lug, pins_[i]);
      }
    }
  }

 private:
  void note_rod(double push, double factor, const RodInput& rod) {
    found_.note(push > 0.0 ? Criterion::buckling : Criterion::rod,
                rod_utilisation(factor * push, rod, project_.strength), {}, rod.name);
  }

  /// Along every one of many directions, the program's largest of few.
  void tire(const PinInput& pin, const LugInput& lug, const PinForces& of) {
    constexpr int fine = 180;
    const double per_force = lug_stress(1.0, lug);
    std::vector<Eigen::Vector3d> ways;
    for (int i = 0; i < fine; ++i) {
      const double angle = std::numbers::pi * i / fine;
      ways.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    if (!of.flat) {
      // A spiral over half of a ball.
      constexpr int many = 600;
      for (int i = 0; i < many; ++i) {
        const double up = (i + 0.5) / many, angle = 2.399963229728653 * i;
        const double level = std::sqrt(1.0 - up * up);
        ways.emplace_back(level * std::cos(angle), level * std::sin(angle), up);
      }
    }
    for (const Seen& seen : of.seen) {
      for (const Eigen::Vector3d& way : ways) {
        Histories histories(seen.size());
        for (std::size_t i = 0; i < seen.size(); ++i)
          for (const Eigen::Vector3d& force : seen[i])
            histories[i].push_back(per_force * way.dot(force));
        const double range = life_.largest_range(histories);
        if (range < 1e-6 * lug.yield_strength.value()) continue;
        const FatigueDemand& demand = project_.fatigue.demand;
        found_.note(Criterion::lug_fatigue,
                    demand.gamma_Ff * range / (1.5 * lug.yield_strength.value()), {}, pin.name);
        const std::vector<FatigueChannel> channels{
            {life_.cycles_of(histories, false), curve_of(lug.detail.detail)}};
        found_.note(Criterion::lug_fatigue,
                    project_.fatigue.required / largest_factor(channels, demand), {}, pin.name);
      }
    }
  }

  const Project& project_;
  const Life& life_;
  Findings& found_;
  Rules rules_;
  std::vector<PinForces> pins_;
};

void Beside::look_in_plane(const SituationRun& run, const Run& sampled) {
  const planar::Mechanism& mechanism = planar_in(project_, *run.situation);
  planar::StateFinder finder(mechanism, planar_motion_of(run));
  for (const Time& time : sampled.times) {
    const planar::State state = finder.at(time.value());
    const auto reactions = planar::reactions_of(mechanism, state);
    const auto turned = [&](int body) {
      return body == planar::ground ? 0.0 : state.q[3 * body + 2];
    };
    for (std::size_t i = 0; i < project_.pins.size(); ++i) {
      const PinInput& pin = project_.pins[i];
      const planar::Joint& joint = mechanism.joints[static_cast<std::size_t>(pin.joint)];
      const auto [a, b] = planar::ends_of(joint);
      for (const planar::Reaction& reaction : reactions) {
        if (reaction.joint != pin.joint) continue;
        std::vector<Eigen::Vector3d> seen;
        for (const int body : {a.body, b.body})
          seen.push_back(flat(Eigen::Rotation2Dd(-turned(body)) * reaction.force));
        if (planar::is_rod(joint)) {
          const Eigen::Vector2d way =
              planar::position_of(b, state.q) - planar::position_of(a, state.q);
          seen.emplace_back(reaction.force.dot(way.normalized()), 0.0, 0.0);
        }
        note_instant(pins_[i], sampled.situation, project_.situations.size(), sampled.load_factor,
                     reaction.force.norm(), seen);
        break;
      }
    }
    for (const RodInput& input : project_.rods) {
      const auto& rod = std::get<PlanarRod>(input.place);
      const double angle = state.q[3 * rod.from.body + 2];
      const Eigen::Vector2d way = rod.to.p - rod.from.p;
      const Eigen::Vector2d along = Eigen::Rotation2Dd(angle) * way.normalized();
      double push_from = 0.0, push_to = 0.0;
      for (const planar::Reaction& reaction : reactions) {
        if (reaction.on != rod.from.body) continue;
        if ((reaction.point - rod.from.p).norm() < 1e-9 * way.norm())
          push_from += reaction.force.dot(along);
        if ((reaction.point - rod.to.p).norm() < 1e-9 * way.norm())
          push_to -= reaction.force.dot(along);
      }
      for (const double push : {push_from, push_to}) note_rod(push, sampled.load_factor, input);
    }
  }
}

void Beside::look_in_space(const SituationRun& run, const Run& sampled) {
  const spatial::Chain& chain = chain_of(run);
  const spatial::Mechanism& mechanism = chain.mechanism();
  const std::size_t carrying = mechanism.joints.size();
  for (const Time& time : sampled.times) {
    const spatial::State state = chain.at(time.value());
    const std::vector<spatial::Wrench> wrenches = chain.joint_wrenches(state);
    const auto in_axes = [&](int body, const Eigen::Vector3d& of) -> Eigen::Vector3d {
      if (body == spatial::ground) return of;
      return state.bodies[static_cast<std::size_t>(body)].R_WB.transpose() * of;
    };
    const auto along = [&](const spatial::ClosingJoint& joint) {
      return (spatial::position_of(state, joint.b) - spatial::position_of(state, joint.a))
          .normalized();
    };
    for (std::size_t i = 0; i < project_.pins.size(); ++i) {
      const auto index = static_cast<std::size_t>(project_.pins[i].joint);
      const Eigen::Vector3d& force = wrenches[index].force;
      std::vector<Eigen::Vector3d> seen;
      double size = force.norm();
      if (index < carrying) {
        // A hinge: its axis is written in the axes of the body that carries.
        const spatial::Joint& hinge = mechanism.joints[index];
        const int bodies[] = {hinge.parent, static_cast<int>(index)};
        const Eigen::Vector3d own[] = {hinge.axis, hinge.turn.transpose() * hinge.axis};
        for (const std::size_t k : {0U, 1U}) {
          Eigen::Vector3d across = axes_of_pin(own[k]) * in_axes(bodies[k], force);
          across.z() = 0.0;
          seen.push_back(across);
        }
        size = seen.front().norm();
      } else {
        const spatial::ClosingJoint& joint = mechanism.closing[index - carrying];
        pins_[i].flat = false;
        for (const int body : {joint.a.body, joint.b.body}) seen.push_back(in_axes(body, force));
        if (joint.kind == spatial::ClosingKind::distance)
          seen.emplace_back(force.dot(along(joint)), 0.0, 0.0);
      }
      note_instant(pins_[i], sampled.situation, project_.situations.size(), sampled.load_factor,
                   size, seen);
    }
    for (const RodInput& rod : project_.rods) {
      const std::size_t closing = std::get<RodLink>(rod.place).index;
      // On the body at its far end: what pushes that away presses the rod.
      note_rod(wrenches[carrying + closing].force.dot(along(mechanism.closing[closing])),
               sampled.load_factor, rod);
    }
  }
}

}  // namespace

void look_at_neighbours(const Project& project, const std::deque<SituationRun>& runs,
                        const std::vector<Run>& sampled, const Life& life, Findings& found) {
  const bool in_plane = std::holds_alternative<planar::Mechanism>(project.mechanism);
  if (!in_plane && !std::holds_alternative<spatial::Mechanism>(project.mechanism)) return;
  if (project.pins.empty() && project.rods.empty()) return;
  Beside beside(project, life, found);
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (in_plane)
      beside.look_in_plane(runs[r], sampled[r]);
    else
      beside.look_in_space(runs[r], sampled[r]);
  }
  beside.judge();
}

}  // namespace oracle
