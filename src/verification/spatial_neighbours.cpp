#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <variant>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/rest.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "even_beam.hpp"
#include "front_ends.hpp"
#include "neighbour_loads.hpp"

namespace boxbeam {
namespace {

/// As much bending as a second order that does not count (EN 1993-1-1, 6.3.1.2(4)), over f_y.
constexpr double hardly = 0.04;

/// Two axes across a unit vector.
Eigen::Matrix<double, 2, 3> across(const Eigen::Vector3d& axis) {
  Eigen::Matrix<double, 2, 3> of;
  of.row(0) = axis.unitOrthogonal();
  of.row(1) = axis.cross(of.row(0).transpose());
  return of;
}

/// A rod that is a body.
struct RodBeam : EvenBeam {
  double modulus = 0.0;  ///< least of its section [m^3]
};

class SpatialNeighbours : public NeighbourLoads {
 public:
  explicit SpatialNeighbours(const SituationRun& run)
      : NeighbourLoads(run),
        chain_(&chain_of(run)),
        mechanism_(&chain_->mechanism()),
        states_(states_around(run)) {}

  bool determines(int joint) const override {
    return chain_->loops() == nullptr ||
           chain_->loops()->unique()[static_cast<std::size_t>(joint)] != 0;
  }

  std::string joint_name(int joint) const override {
    return closes(joint) ? closing(joint).name : carrying(joint).name;
  }

  std::vector<PinFrame> frames_of(int joint) const override {
    std::vector<PinFrame> frames;
    const int ways = keeps_axis(joint) ? 2 : 3;
    for (const int body : indices_of(joint)) frames.push_back({name_of(body), ways});
    if (is_rod(joint)) frames.push_back({"the rod", 1});
    return frames;
  }

  std::vector<int> joints_of(const RodInput& rod) const override {
    const int first = static_cast<int>(mechanism_->joints.size());
    if (const auto* const link = std::get_if<RodLink>(&rod.place)) {
      if (link->spring) return {};
      return {first + static_cast<int>(link->index)};
    }
    const int body = std::get<SpatialRod>(rod.place).from.body;
    std::vector<int> joints;
    for (int i = 0; i < first + static_cast<int>(mechanism_->closing.size()); ++i) {
      const std::array<int, 2> of = indices_of(i);
      if (of[0] == body || of[1] == body) joints.push_back(i);
    }
    return joints;
  }

  double force_in(int joint, double time) override {
    look_at(time);
    const Eigen::Vector3d& force = wrenches_[static_cast<std::size_t>(joint)].force;
    const auto axis = axis_of(joint);
    return axis ? (force - axis->dot(force) * *axis).norm() : force.norm();
  }

  Eigen::Vector3d force_seen(int joint, std::size_t frame, double time) override {
    look_at(time);
    const std::array<int, 2> bodies = indices_of(joint);
    if (frame == bodies.size()) {
      const std::size_t closing = static_cast<std::size_t>(joint) - mechanism_->joints.size();
      return {tension_of(RodLink{false, closing}), 0.0, 0.0};
    }
    Eigen::Vector3d force =
        spatial::in_axes(state_, bodies[frame], wrenches_[static_cast<std::size_t>(joint)].force);
    if (!keeps_axis(joint)) return force;
    // The axis is the same in both bodies' own axes at every time.
    const Eigen::Matrix3d& turn = closes(joint) ? closing(joint).turn : carrying(joint).turn;
    const Eigen::Vector3d& axis = closes(joint) ? closing(joint).axis : carrying(joint).axis;
    const Eigen::Vector2d own =
        across(frame == 0 ? axis : Eigen::Vector3d(turn.transpose() * axis)) * force;
    return {own.x(), own.y(), 0.0};
  }

  BesidePin beside_pin(int joint, double time) override {
    look_at(time);
    const auto axis = axis_of(joint);
    if (!axis) return {};
    const spatial::Wrench& of = wrenches_[static_cast<std::size_t>(joint)];
    return {std::abs(axis->dot(of.force)), (of.moment - axis->dot(of.moment) * *axis).norm()};
  }

  AxialForces axial_forces_in(const RodInput& rod, double time) override {
    look_at(time);
    if (const auto* const link = std::get_if<RodLink>(&rod.place)) {
      const double tension = tension_of(*link);
      return {tension, -tension};
    }
    const BeamLoads loads = loads_on(rod);
    double at_end = 0.0;  // what takes hold of the far end pulls there
    const Length end = beam_of(rod).beam.length();
    for (const PointLoad& load : loads.points)
      if (load.s == end) at_end += load.force.x();
    AxialForces most{at_end, -at_end};
    for (const CutForcePiece& piece : cut_forces_of(loads).pieces) {
      each_place_of(piece, [&](double x) {
        most.tension = std::max(most.tension, piece.N(x));
        most.compression = std::max(most.compression, -piece.N(x));
      });
    }
    return most;
  }

  double moment_in(const RodInput& rod, double time) override {
    look_at(time);
    if (std::holds_alternative<RodLink>(rod.place)) return 0.0;
    const double beyond = uneven_moment(rod);
    double even = 0.0;
    for (const CutForcePiece& piece : cut_forces_of(loads_on(rod)).pieces) {
      each_place_of(
          piece, [&](double x) { even = std::max(even, std::hypot(piece.M_y(x), piece.M_z(x))); });
    }
    return even + beyond;
  }

  std::vector<std::string> bending_of(const RodInput& rod) override {
    std::vector<std::string> names;
    if (std::holds_alternative<RodLink>(rod.place)) return names;
    const auto add = [&](std::string_view name) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
    };
    const int body = std::get<SpatialRod>(rod.place).from.body;
    for (const spatial::LineForce& line : mechanism_->line_forces)
      if (line.on == body) add(line.name);
    const RodBeam& of = beam_of(rod);
    const double length = of.beam.length().value();
    const double bends = hardly * rod.yield_strength.value() * of.modulus;
    for (const SampledInstant& instant : span().instants) {
      look_at(instant.at);
      for (const PointLoad& load : loads_on(rod).points) {
        const double s = load.s.value();
        const bool between = s > 1e-6 * length && s < (1.0 - 1e-6) * length;
        if ((between && load.force.norm() > 0.0) || load.moment.norm() > bends) add(load.name);
      }
    }
    return names;
  }

  double largest_force(double time) override {
    look_at(time);
    double largest = 0.0;
    for (const spatial::Wrench& of : wrenches_) largest = std::max(largest, of.force.norm());
    return largest;
  }

 private:
  bool closes(int joint) const { return joint >= static_cast<int>(mechanism_->joints.size()); }
  const spatial::Joint& carrying(int joint) const {
    return mechanism_->joints[static_cast<std::size_t>(joint)];
  }
  const spatial::ClosingJoint& closing(int joint) const {
    return mechanism_->closing[static_cast<std::size_t>(joint) - mechanism_->joints.size()];
  }

  /// The body that carries and the one that is carried, or a and b.
  std::array<int, 2> indices_of(int joint) const {
    if (closes(joint)) return {closing(joint).a.body, closing(joint).b.body};
    return {spatial::carrier_of_ball(*mechanism_, joint).value_or(carrying(joint).parent), joint};
  }

  std::string name_of(int body) const {
    return body == spatial::ground ? "the ground"
                                   : mechanism_->bodies[static_cast<std::size_t>(body)].name;
  }

  bool keeps_axis(int joint) const {
    using Kind = spatial::ClosingKind;
    if (!closes(joint))
      return carrying(joint).kind == spatial::JointKind::revolute &&
             !spatial::carrier_of_ball(*mechanism_, joint);
    return closing(joint).kind == Kind::revolute || closing(joint).kind == Kind::cylindrical;
  }
  bool is_rod(int joint) const {
    return closes(joint) && closing(joint).kind == spatial::ClosingKind::distance;
  }

  /// The axis of a pin in the world; nothing of joints that have none.
  std::optional<Eigen::Vector3d> axis_of(int joint) const {
    if (!keeps_axis(joint)) return std::nullopt;
    if (closes(joint)) return spatial::in_world(state_, closing(joint).a.body, closing(joint).axis);
    return spatial::in_world(state_, carrying(joint).parent, carrying(joint).axis);
  }

  /// Of a joint that keeps a distance, or of a spring.
  double tension_of(const RodLink& link) const {
    const auto between = [&](const spatial::Attachment& a, const spatial::Attachment& b) {
      return (spatial::position_of(state_, b) - spatial::position_of(state_, a)).normalized();
    };
    if (link.spring) {
      const spatial::Spring& spring = mechanism_->springs[link.index];
      return -between(spring.a, spring.b).dot(spatial::force_of(*mechanism_, link.index, state_));
    }
    const spatial::ClosingJoint& joint = mechanism_->closing[link.index];
    return -between(joint.a, joint.b).dot(wrenches_[mechanism_->joints.size() + link.index].force);
  }

  /// What an uneven mass may bend a rod by beside that of an even one; zero of an even one.
  double uneven_moment(const RodInput& rod) const {
    const SpatialRod& place = std::get<SpatialRod>(rod.place);
    const int index = place.from.body;
    const spatial::Body& body = mechanism_->bodies[static_cast<std::size_t>(index)];
    const Eigen::Vector3d line = place.to.p - place.from.p;
    const Eigen::Vector3d along = line.normalized(), centre = body.centre - place.from.p;
    const Eigen::Matrix<double, 2, 3> beside = across(along);
    const Eigen::Matrix2d inertia = beside * body.inertia * beside.transpose();
    const RodMass of{body.mass, line.norm(), along.dot(centre), along.cross(centre).norm(),
                     inertia.selfadjointView<Eigen::Lower>().eigenvalues()[0]};
    if (of.is_even()) return 0.0;
    const auto load_at = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return spatial::in_axes(state_, index,
                              mechanism_->gravity - spatial::acceleration_of(state_, {index, p}));
    };
    const double most =
        std::max((beside * load_at(place.from.p)).norm(), (beside * load_at(place.to.p)).norm());
    return of.lever() * most + of.mass * of.beside * std::abs(along.dot(load_at(body.centre)));
  }

  BeamLoads loads_on(const RodInput& rod) {
    return spatial::beam_loads_of(*chain_, state_, beam_of(rod).body);
  }

  const RodBeam& beam_of(const RodInput& rod) {
    RodBeam& of = beams_[&rod];
    if (!of.beam.segments.empty()) return of;
    const SpatialRod& place = std::get<SpatialRod>(rod.place);
    of.set(*mechanism_, spatial::open_state_of(*mechanism_), place.from.body, place.from.p,
           place.to.p, rod.section);
    const SectionProperties section = properties_of(rod.section);
    of.modulus = std::min(section.W_y, section.W_z).value();
    return of;
  }

  /// At the ends of a piece and between them, where its forces may have their largest.
  template <class Visit>
  static void each_place_of(const CutForcePiece& piece, const Visit& visit) {
    constexpr int parts = 16;
    for (int i = 0; i <= parts; ++i) visit(piece.length.value() * i / parts);
  }

  void look_at(double time) {
    const double at = within(time);
    if (looked_at_ == at) return;
    state_ = states_.at(at);
    chain_->joint_wrenches(state_, wrenches_);
    looked_at_ = at;
  }

  const spatial::Chain* chain_;
  static spatial::StatesAround states_around(const SituationRun& run) {
    const LoadSpan span = span_of_motion_in_space(run);
    return {chain_of(run), {span.begin.value(), span.period.value(), span.closed, span.instants}};
  }

  const spatial::Mechanism* mechanism_;
  spatial::StatesAround states_;
  std::optional<double> looked_at_;  ///< the time of the state [s]
  spatial::State state_;
  std::vector<spatial::Wrench> wrenches_;
  std::map<const RodInput*, RodBeam> beams_;
};

}  // namespace

std::unique_ptr<NeighbourLoads> spatial_neighbour_loads(const SituationRun& run) {
  return std::make_unique<SpatialNeighbours>(run);
}

}  // namespace boxbeam
