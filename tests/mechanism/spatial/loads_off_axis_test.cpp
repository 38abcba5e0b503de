// Joints and loads beside the axis of a beam in space: cut forces against the sum of all forces on
// the part before the cut, taken anew here, body by body.

#include <Eigen/Geometry>
#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "catch.hpp"
#include "support/random_tree.hpp"

namespace loads_off_axis_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;

namespace {

constexpr int beam_body = 2;

/// Of two segments, the second tapered; unequal walls, so that I_yz is not zero.
TaperedBeam beam_of(test::Chance& chance) {
  Box from = symmetric_box(0.1 * metre, 0.2 * metre, 0.01 * metre, 0.01 * metre);
  from.stiffeners = {{BoxPlate::top_flange, 0.02 * metre, 0.03 * metre, 0.01 * metre}};
  Box to = from;
  to.height = 0.3 * metre;
  TaperedBeam beam;
  beam.density = si<Density>(800.0);
  beam.rotary_inertia = chance.one_of(2) == 0;
  const Length first = si<Length>(0.8 + chance.any(0.4)), second = si<Length>(1.2 + chance.any());
  beam.segments = {{"", 0.0 * metre, first, {from, {}}, {from, {}}},
                   {"", first, second, {from, {}}, {to, {}}}};
  return beam;
}

/// A random tree in which the beam is one body. It is held and carries others beside its axis; so
/// do forces and couples on it act, at points of its own and of bodies fixed to it, and line forces
/// run beside it.
struct LoadedBeam {
  TaperedBeam beam;
  Mechanism mechanism;
  BeamPlacement placement;

  explicit LoadedBeam(test::Chance& chance)
      : beam(beam_of(chance)), mechanism(test::random_tree(chance, 8)) {
    placement.body = beam_body;
    placement.axes = chance.rotation();
    placement.start = chance.vector();
    give_mass(mechanism.bodies[beam_body], placement, beam);
    mechanism.joints[beam_body].point = beside(chance);
    for (const std::size_t carried : {std::size_t{3}, std::size_t{4}}) {
      Joint& joint = mechanism.joints[carried];
      joint.parent = beam_body;
      joint.at = beside(chance);
      // One turns, the other is fixed.
      joint.kind = carried == 3 ? JointKind::revolute : JointKind::fixed;
    }
    for (std::size_t i = 5; i < mechanism.joints.size(); ++i) {
      if (mechanism.joints[i].parent == beam_body) mechanism.joints[i].parent = 3;
    }
    for (std::size_t i = 0; i < mechanism.loads.size(); ++i) {
      if (i >= 5 && mechanism.loads[i].on == beam_body) mechanism.loads[i].on = 0;
      if (i >= 5) continue;
      AppliedLoad& load = mechanism.loads[i];
      load.name = "on beam " + std::to_string(i);
      load.on = beam_body;
      load.at = {beam_body, beside(chance)};
      if (i != 4) continue;
      // The last at a point of the body that is fixed to the beam.
      const Joint& fixed = mechanism.joints[4];
      load.at = {4, fixed.point + fixed.turn.transpose() * (load.at.p - fixed.at)};
    }
    for (LineForce& line : mechanism.line_forces) {
      line.on = beam_body;
      const Vector3d apart = placement.axes * Vector3d(0.0, chance.any(0.3), chance.any(0.3));
      const double end = beam.segments[1].start.value();
      line.from = placement.start + apart + end * placement.axes.col(0);
      line.to = placement.start + apart +
                (chance.one_of(2) == 0 ? 0.0 : beam.length().value()) * placement.axes.col(0);
    }
  }

  Vector3d beside(test::Chance& chance) const {
    const double s = beam.length().value() * (0.5 + chance.any(0.45));
    return placement.start + placement.axes * Vector3d(s, chance.any(0.3), chance.any(0.3));
  }
};

/// Forces and moments about a place, world axes.
struct Sum {
  Vector3d about;
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();

  void add(const Vector3d& at, const Vector3d& f, const Vector3d& m = Vector3d::Zero()) {
    force += f;
    moment += m + (at - about).cross(f);
  }
};

/// The free body of everything that hangs on body `first`, itself included.
void add_carried(const Mechanism& mechanism, const State& state, int first, Sum& sum) {
  std::vector<bool> carried(mechanism.bodies.size(), false);
  for (std::size_t i = static_cast<std::size_t>(first); i < carried.size(); ++i) {
    const int parent = mechanism.joints[i].parent;
    carried[i] = static_cast<int>(i) == first ||
                 (parent != ground && carried[static_cast<std::size_t>(parent)]);
    if (!carried[i]) continue;
    const Body& body = mechanism.bodies[i];
    const BodyMotion& motion = state.bodies[i];
    const Attachment centre{static_cast<int>(i), body.centre};
    const Eigen::Matrix3d inertia = motion.R_WB * body.inertia * motion.R_WB.transpose();
    sum.add(position_of(state, centre),
            body.mass * (mechanism.gravity - acceleration_of(state, centre)),
            -(inertia * motion.alpha + motion.omega.cross(inertia * motion.omega)));
    for (const AppliedLoad& load : mechanism.loads) {
      if (load.on != static_cast<int>(i)) continue;
      const Vector3d vector =
          driver_at(load.size, state.time).value * in_world(state, load.axes, load.direction);
      if (load.kind == LoadKind::force)
        sum.add(position_of(state, load.at), vector);
      else
        sum.moment += vector;
    }
    for (const LineForce& line : mechanism.line_forces) {
      if (line.on != static_cast<int>(i)) continue;
      sum.add(position_of(state, {line.on, 0.5 * (line.from + line.to)}),
              (line.to - line.from).norm() * driver_at(line.size, state.time).value *
                  in_world(state, line.axes, line.direction));
    }
  }
}

/// What acts on the beam before a cut at s. At a load's own place: with it, or without.
Sum before_cut(const LoadedBeam& of, const State& state, double s, bool with_load) {
  const Mechanism& mechanism = of.mechanism;
  const BodyMotion& motion = state.bodies[beam_body];
  const Eigen::Matrix3d axes = motion.R_WB * of.placement.axes;
  const auto on_axis = [&](double at) {
    return Vector3d(position_of(state, {beam_body, of.placement.start}) + at * axes.col(0));
  };
  Sum sum{on_axis(s)};
  const auto is_before = [&](const Vector3d& place) {
    const double at = axes.col(0).dot(place - on_axis(0.0));
    return with_load ? at < s + 1e-9 : at < s - 1e-9;
  };
  const auto add = [&](const Vector3d& place, const Vector3d& force, const Vector3d& moment) {
    if (is_before(place)) sum.add(place, force, moment);
  };
  for (std::size_t i = 0; i < mechanism.joints.size(); ++i) {
    const bool own = static_cast<int>(i) == beam_body;
    if (!own && mechanism.joints[i].parent != beam_body) continue;
    // The joint bears the free body of all that it carries.
    const Vector3d place = position_of(state, {static_cast<int>(i), mechanism.joints[i].point});
    Sum borne{place};
    add_carried(mechanism, state, static_cast<int>(i), borne);
    const double sign = own ? -1.0 : 1.0;
    add(place, sign * borne.force, sign * borne.moment);
  }
  for (const AppliedLoad& load : mechanism.loads) {
    if (load.on != beam_body) continue;
    const Vector3d vector =
        driver_at(load.size, state.time).value * in_world(state, load.axes, load.direction);
    if (load.kind == LoadKind::force)
      add(position_of(state, load.at), vector, Vector3d::Zero());
    else
      add(position_of(state, load.at), Vector3d::Zero(), vector);
  }
  // Weight, inertia and line forces along the axis. Exact: area, place and acceleration make the
  // integrand a polynomial of degree 4, with rotary inertia 6.
  using Gauss = boost::math::quadrature::gauss<double, 7>;
  for (const Segment& segment : of.beam.segments) {
    const double low = segment.start.value(), high = std::min(s, segment.end().value());
    if (high <= low) continue;
    for (std::size_t k = 0; k < Gauss::abscissa().size(); ++k) {
      for (const double side : {-1.0, 1.0}) {
        if (side > 0.0 && Gauss::abscissa()[k] == 0.0) continue;
        const double at = 0.5 * (low + high) + 0.5 * (high - low) * side * Gauss::abscissa()[k];
        const double weight = 0.5 * (high - low) * Gauss::weights()[k];
        const SectionProperties section = properties_of(section_at(of.beam, {si<Length>(at)}));
        const double rho = of.beam.density.value();
        const Vector3d r = on_axis(at) - on_axis(0.0);
        const Vector3d acceleration = acceleration_of(state, {beam_body, of.placement.start}) +
                                      motion.alpha.cross(r) +
                                      motion.omega.cross(motion.omega.cross(r));
        sum.add(on_axis(at),
                weight * rho * section.area.value() * (mechanism.gravity - acceleration));
        if (of.beam.rotary_inertia) {
          const double I_y = section.I_y.value(), I_z = section.I_z.value();
          Eigen::Matrix3d J = Eigen::Vector3d(I_y + I_z, I_y, I_z).asDiagonal();
          J(1, 2) = J(2, 1) = -section.I_yz.value();
          J = (axes * J * axes.transpose()).eval();
          sum.moment -= weight * rho * (J * motion.alpha + motion.omega.cross(J * motion.omega));
        }
        for (const LineForce& line : mechanism.line_forces) {
          if (line.on != beam_body) continue;
          const Vector3d from = in_beam(of.placement, line.from);
          const double to = in_beam(of.placement, line.to).x();
          if (at < std::min(from.x(), to) || at > std::max(from.x(), to)) continue;
          sum.add(on_axis(at) + axes * Vector3d(0.0, from.y(), from.z()),
                  weight * driver_at(line.size, state.time).value *
                      in_world(state, line.axes, line.direction));
        }
      }
    }
  }
  // What is left to the cut, in beam axes.
  sum.force = (-axes.transpose() * sum.force).eval();
  sum.moment = (-axes.transpose() * sum.moment).eval();
  return sum;
}

/// The largest difference of the cut forces from the sum, moments by a metre.
double difference(const CutForces& cut, const Sum& sum) {
  const Vector3d force(cut.N.value(), cut.V_y.value(), cut.V_z.value());
  const Vector3d moment(cut.T.value(), cut.M_y.value(), cut.M_z.value());
  return std::max((force - sum.force).norm(), (moment - sum.moment).norm());
}

}  // namespace

TEST_CASE("loads off the axis: cut forces of 200 random chains are free-body sums") {
  test::Chance chance(170);
  double worst = 0.0, largest_jump = 0.0;
  for (int chain_number = 0; chain_number < 200; ++chain_number) {
    const LoadedBeam of(chance);
    const Chain chain(of.mechanism);
    const BeamBody body = beam_body_of(of.beam, of.placement, of.mechanism);
    const std::vector<LastingPlace> lasting = lasting_places_of(of.mechanism, of.placement);
    REQUIRE(lasting.size() == 8);  // three joints, five loads
    for (const double time : {0.25, 0.7}) {
      const State state = chain.at(time);
      const CutForceDiagram diagram = cut_forces_of(beam_loads_of(chain, state, body));
      double size = 1.0;
      for (const CutForcePiece& piece : diagram.pieces) {
        const CutForces cut = diagram.at({piece.start, Side::behind});
        size = std::max({size, std::abs(cut.N.value()), std::abs(cut.V_y.value()),
                         std::abs(cut.V_z.value()), std::abs(cut.T.value()),
                         std::abs(cut.M_y.value()), std::abs(cut.M_z.value())});
      }
      for (int i = 1; i < 8; ++i) {
        const double s = of.beam.length().value() * (0.04 + 0.125 * i);
        const double off = difference(diagram.at({si<Length>(s)}), before_cut(of, state, s, false));
        worst = std::max(worst, off / size);
      }
      // Both sides of every place that something acts over.
      for (const LastingPlace& place : lasting) {
        const double s = place.at.x();
        const Length at = place_near(body.places, si<Length>(s));
        const Sum before = before_cut(of, state, s, false), behind = before_cut(of, state, s, true);
        worst = std::max({worst, difference(diagram.at({at, Side::before}), before) / size,
                          difference(diagram.at({at, Side::behind}), behind) / size});
        largest_jump = std::max(largest_jump, (behind.force - before.force).norm() / size);
      }
    }
  }
  CHECK(worst < 1e-9);
  CHECK(largest_jump > 0.1);
}

TEST_CASE("a load at a point of another body that is fixed to the beam keeps its place over time") {
  test::Chance chance(171);
  for (int chain_number = 0; chain_number < 20; ++chain_number) {
    const LoadedBeam of(chance);
    const Chain chain(of.mechanism);
    const BeamBody body = beam_body_of(of.beam, of.placement, of.mechanism);
    const BeamLoads first = beam_loads_of(chain, chain.at(0.0), body);
    for (int i = 1; i < 20; ++i) {
      const BeamLoads later = beam_loads_of(chain, chain.at(0.05 * i), body);
      REQUIRE(later.points.size() == first.points.size());
      for (std::size_t k = 0; k < first.points.size(); ++k) {
        CHECK(later.points[k].s == first.points[k].s);
      }
    }
  }
}

}  // namespace loads_off_axis_test
