#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <variant>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/mechanism/planar/rest.hpp"
#include "neighbour_loads.hpp"

namespace boxbeam {
namespace {

/// Whether a point of a rod's body is one of its ends.
bool is_at(const Eigen::Vector2d& point, const planar::Attachment& end, const PlanarRod& rod) {
  return (point - end.p).norm() < 1e-9 * (rod.to.p - rod.from.p).norm();
}

const PlanarRod& ends_of(const RodInput& rod) { return std::get<PlanarRod>(rod.place); }

class PlanarNeighbours : public NeighbourLoads {
 public:
  PlanarNeighbours(const Project& project, const SituationRun& run)
      : NeighbourLoads(run),
        mechanism_(&planar_in(project, *run.situation)),
        motion_(&planar_motion_of(run)),
        finder_(*mechanism_, *motion_) {}

  bool determines(int joint) const override { return planar::is_unique(motion_->freedom, joint); }

  std::string joint_name(int joint) const override { return joint_at(joint).name; }

  std::vector<PinFrame> frames_of(int joint) const override {
    std::vector<PinFrame> frames;
    for (const int body : indices_of(joint)) frames.push_back({name_of(body)});
    if (planar::is_rod(joint_at(joint))) frames.push_back({"the rod", 1});
    return frames;
  }

  std::vector<int> joints_of(const RodInput& rod) const override {
    if (const auto* const link = std::get_if<RodLink>(&rod.place)) {
      if (link->spring) return {};
      return {static_cast<int>(link->index)};
    }
    std::vector<int> joints;
    for (std::size_t i = 0; i < mechanism_->joints.size(); ++i) {
      const auto [a, b] = planar::ends_of(mechanism_->joints[i]);
      const int body = ends_of(rod).from.body;
      if (a.body == body || b.body == body) joints.push_back(static_cast<int>(i));
    }
    return joints;
  }

  double force_in(int joint, double time) override { return reaction_of(joint, time).norm(); }

  Eigen::Vector3d force_seen(int joint, std::size_t frame, double time) override {
    const Eigen::Vector2d force = reaction_of(joint, time);
    const std::array<int, 2> bodies = indices_of(joint);
    if (frame == bodies.size())
      return {planar::tension_in_joint(*mechanism_, state_, static_cast<std::size_t>(joint)), 0.0,
              0.0};
    const int of = bodies[frame];
    const double angle = of == planar::ground ? 0.0 : state_.q[3 * of + 2];
    const Eigen::Vector2d own = Eigen::Rotation2Dd(-angle) * force;
    return {own.x(), own.y(), 0.0};
  }

  BesidePin beside_pin(int, double) override { return {}; }

  /// Of an even rod that turns, the tension along it is a parabola, highest above its chord, by
  /// m omega^2 L/8, in the middle; the compression is largest at an end.
  AxialForces axial_forces_in(const RodInput& input, double time) override {
    look_at(time);
    if (const auto* const link = std::get_if<RodLink>(&input.place)) {
      const double tension = link->spring
                                 ? planar::tension_in_spring(*mechanism_, state_, link->index)
                                 : planar::tension_in_joint(*mechanism_, state_, link->index);
      return {tension, -tension};
    }
    const PlanarRod& rod = ends_of(input);
    const int body = rod.from.body;
    const Eigen::Vector2d line = rod.to.p - rod.from.p;
    const Eigen::Vector2d along = Eigen::Rotation2Dd(state_.q[3 * body + 2]) * line.normalized();
    double at_from = 0.0;  // tension in the rod at either end
    double at_to = 0.0;
    const auto add = [&](int on, const Eigen::Vector2d& point, const Eigen::Vector2d& force) {
      if (on != body) return;
      if (is_at(point, rod.from, rod)) at_from -= force.dot(along);
      if (is_at(point, rod.to, rod)) at_to += force.dot(along);
    };
    for (const planar::Reaction& reaction : reactions_)
      add(reaction.on, reaction.point, reaction.force);
    for (const planar::AppliedLoad& load :
         planar::applied_loads_of(*mechanism_, state_.time, state_.q, state_.v, state_.touches))
      add(load.on, load.point, load.vector);
    const double omega = state_.v[3 * body + 2];
    const double mass = mechanism_->bodies[static_cast<std::size_t>(body)].mass;
    const double rise = 0.5 * mass * omega * omega * line.norm();
    const auto tension_at = [&](double x) {
      return at_from + (at_to - at_from) * x + rise * x * (1.0 - x);
    };
    const double highest = rise > 0.0 ? 0.5 * (1.0 + (at_to - at_from) / rise) : 0.0;
    return {std::max({at_from, at_to, tension_at(std::clamp(highest, 0.0, 1.0))}),
            std::max(-at_from, -at_to)};
  }

  /// Of an even rod between pins under its weight and inertia, mass m: the load across it per
  /// length is linear, by its mean and by how far its ends are above and below that.
  ///
  ///     M <= m L (|mean|/8 + 0.01604 |ends|)
  ///
  /// mean, ends  of g - a across the rod; of an uneven one by `RodMass::lever`, and by what acts
  /// along it beside its line. Source: equilibrium.
  double moment_in(const RodInput& input, double time) override {
    if (std::holds_alternative<RodLink>(input.place)) return 0.0;
    const PlanarRod& rod = ends_of(input);
    look_at(time);
    const Eigen::Vector2d line =
        planar::position_of(rod.to, state_.q) - planar::position_of(rod.from, state_.q);
    const double length = line.norm();
    const Eigen::Vector2d across(-line.y() / length, line.x() / length);
    const auto load_at = [&](const planar::Attachment& end) {
      return across.dot(mechanism_->gravity -
                        planar::acceleration_of(end, state_.q, state_.v, state_.a));
    };
    const double from = load_at(rod.from), to = load_at(rod.to);
    const Body& body = mechanism_->bodies[static_cast<std::size_t>(rod.from.body)];
    const RodMass of = mass_of(body, rod);
    constexpr double of_ends = 0.01604;
    if (of.is_even())
      return of.mass * length * (std::abs(from + to) / 16.0 + of_ends * std::abs(from - to) / 2.0);
    const planar::Attachment middle{rod.from.body, Eigen::Vector2d::Zero()};
    const double along = (line / length)
                             .dot(mechanism_->gravity -
                                  planar::acceleration_of(middle, state_.q, state_.v, state_.a));
    return of.lever() * std::max(std::abs(from), std::abs(to)) +
           of.mass * of.beside * std::abs(along);
  }

  std::vector<std::string> bending_of(const RodInput& input) override {
    if (std::holds_alternative<RodLink>(input.place)) return {};
    return boxbeam::bending_of(*mechanism_, ends_of(input));
  }

  double largest_force(double time) override {
    look_at(time);
    double largest = 0.0;
    for (const planar::Reaction& reaction : reactions_)
      largest = std::max(largest, reaction.force.norm());
    return largest;
  }

 private:
  const planar::Joint& joint_at(int joint) const {
    return mechanism_->joints[static_cast<std::size_t>(joint)];
  }

  std::array<int, 2> indices_of(int joint) const {
    const auto [a, b] = planar::ends_of(joint_at(joint));
    return {a.body, b.body};
  }

  std::string name_of(int body) const {
    return body == planar::ground ? "the ground"
                                  : mechanism_->bodies[static_cast<std::size_t>(body)].name;
  }

  Eigen::Vector2d reaction_of(int joint, double time) {
    look_at(time);
    for (const planar::Reaction& reaction : reactions_)
      if (reaction.joint == joint) return reaction.force;
    return Eigen::Vector2d::Zero();
  }

  void look_at(double time) {
    const double at = within(time);
    if (looked_at_ == at) return;
    state_ = finder_.at(at);
    reactions_ = planar::reactions_of(*mechanism_, state_);
    looked_at_ = at;
  }

  const planar::Mechanism* mechanism_;
  const planar::Motion* motion_;
  planar::StatesAround finder_;
  std::optional<double> looked_at_;  ///< the time of the state [s]
  planar::State state_;
  std::vector<planar::Reaction> reactions_;
};

}  // namespace

std::vector<std::string> bending_of(const planar::Mechanism& mechanism, const PlanarRod& rod) {
  std::vector<std::string> names;
  const int body = rod.from.body;
  const auto beside = [&](const planar::Attachment& at) {
    return at.body == body && !is_at(at.p, rod.from, rod) && !is_at(at.p, rod.to, rod);
  };
  for (const planar::Joint& joint : mechanism.joints) {
    const auto [a, b] = planar::ends_of(joint);
    if (a.body != body && b.body != body) continue;
    const auto [hold, other] = planar::holds_of(joint);
    // In a slot the rod's end turns; what slides along the rod bends it.
    const bool turns_freely =
        hold == planar::Hold::place &&
        (other == planar::Hold::place || (other == planar::Hold::guide && b.body != body));
    if (!turns_freely || beside(a) || beside(b)) names.push_back(joint.name);
  }
  for (const planar::AppliedForce& force : mechanism.forces) {
    const bool bends = std::visit(
        [&](const auto& kind) {
          using Kind = std::decay_t<decltype(kind)>;
          if constexpr (std::is_same_v<Kind, planar::PointForce>) {
            return beside(kind.at);
          } else if constexpr (std::is_same_v<Kind, planar::Spring> ||
                               std::is_same_v<Kind, planar::PinWithClearance>) {
            return beside(kind.a) || beside(kind.b);
          } else {
            return kind.a.body == body || kind.b.body == body;
          }
        },
        force.kind);
    if (bends) names.push_back(force.name);
  }
  return names;
}

std::unique_ptr<NeighbourLoads> planar_neighbour_loads(const Project& project,
                                                       const SituationRun& run) {
  return std::make_unique<PlanarNeighbours>(project, run);
}

}  // namespace boxbeam
