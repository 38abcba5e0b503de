#include "boxbeam/mechanism/flexible/beam_loads.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "catch.hpp"
#include "support/elastic_beams.hpp"

namespace boxbeam::flexible {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

/// A uniform link along x from the origin, without rotary inertia.
Link uniform_link(double length, double EI, double mass, int parts) {
  Link link;
  link.name = "beam";
  link.length = length;
  link.parts = parts;
  LinkStretch stretch;
  stretch.length = length;
  stretch.EA.c[0] = 1e9;
  stretch.GA.c[0] = 1e30;
  stretch.EI.c[0] = EI;
  stretch.mass.c[0] = mass;
  link.stretches = {stretch};
  return link;
}

Joint joint_to_ground(const std::string& name, double s, std::array<double, 3> stiffness) {
  Joint joint;
  joint.name = name;
  joint.a.link = 0;
  joint.a.p = {s, 0.0};
  joint.b.p = {s, 0.0};
  joint.stiffness = stiffness;
  return joint;
}

/// Held at the start in both directions and at the end across.
Mechanism pinned_beam(double length, double EI, double mass, int parts) {
  Mechanism mechanism;
  mechanism.links = {uniform_link(length, EI, mass, parts)};
  mechanism.joints = {joint_to_ground("left", 0.0, {infinity, infinity, 0.0}),
                      joint_to_ground("right", length, {0.0, infinity, 0.0})};
  return mechanism;
}

BeamResponse response_of_beam(const Structure& structure, int link, const TaperedBeam& beam) {
  const Response response = boxbeam::flexible::response_of(structure);
  return beam_response_of(structure, link, beam, response, response.harmonic.motion);
}

double largest_force(const BeamLoads& loads) {
  double largest = 0.0;
  for (const PointLoad& load : loads.points) largest = std::max(largest, load.force.norm());
  return largest;
}

/// A chain of three links in any posture with joints off their axes, tapered, damped at random;
/// the second is the beam.
Mechanism random_mechanism(std::mt19937& random, LinkKind kind, Element element) {
  const auto any = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Mechanism mechanism;
  mechanism.element = element;
  mechanism.nodes_at_joints = any(0.0, 1.0) < 0.5;
  mechanism.gravity = {any(-3.0, 3.0), any(-10.0, 10.0)};
  mechanism.frequency = any(1.0, 80.0);
  Eigen::Vector2d origin(0.0, 0.0);
  for (int k = 0; k < 3; ++k) {
    Link link;
    link.name = "link " + std::to_string(k);
    link.kind = k == 1 ? kind : LinkKind::full;
    link.origin = origin;
    link.angle = any(-pi, pi);
    link.parts = 2 + static_cast<int>(any(0.0, 8.0));
    link.retardation = k == 0 ? 1e-4 : 0.0;
    for (int i = 0; i < 2; ++i) {
      LinkStretch stretch;
      stretch.start = link.length;
      stretch.length = any(0.5, 2.0);
      stretch.EA.c = {any(4e8, 8e8), any(-1e8, 1e8)};
      stretch.GA.c = {any(1e8, 2e8), any(-2e7, 2e7)};
      stretch.EI.c = {any(1e7, 2e7), any(-2e6, 2e6)};
      stretch.mass.c = {any(40.0, 80.0), any(-10.0, 10.0), any(-2.0, 2.0)};
      stretch.rotary.c = {any(0.2, 0.4), any(-0.05, 0.05)};
      link.stretches.push_back(stretch);
      link.length += stretch.length;
    }
    if (link.kind == LinkKind::rigid)
      link.rigid = [&] {
        Link elastic = link;
        elastic.kind = LinkKind::full;
        return rigid_mass_of(elastic);
      }();
    mechanism.links.push_back(link);
    origin = in_world(mechanism, {k, {link.length, 0.0}});
  }
  const auto connect = [&](const Attachment& a, const Attachment& b) {
    Joint joint;
    joint.name = "joint " + std::to_string(mechanism.joints.size());
    joint.a = a;
    joint.b = b;
    joint.angle = any(-pi, pi);
    joint.stiffness = {any(1e7, 1e9), any(1e7, 1e9), any(1e5, 1e7)};
    joint.damping = {any(0.0, 1e4), any(0.0, 1e4), 0.0};
    mechanism.joints.push_back(joint);
  };
  const auto off_axis = [&](int link) -> Attachment {
    const double length = mechanism.links[static_cast<std::size_t>(link)].length;
    return {link, {any(0.1, 0.9) * length, any(-0.3, 0.3)}};
  };
  for (const int k : {0, 1, 2}) {
    const Attachment place = off_axis(k);
    connect(place, {ground, in_world(mechanism, place)});
  }
  connect({0, {mechanism.links[0].length, 0.0}}, {1, {0.0, 0.0}});
  connect({2, {0.0, 0.0}}, {1, {mechanism.links[1].length, 0.0}});
  for (const int k : {1, 2}) {
    Load load;
    load.name = "load";
    load.at = off_axis(k);
    load.constant = {any(-1e4, 1e4), any(-1e4, 1e4), any(-1e3, 1e3)};
    load.amplitude = {any(-1e4, 1e4), any(-1e4, 1e4), any(-1e3, 1e3)};
    load.phase = any(0.0, 2.0 * pi);
    mechanism.loads.push_back(load);
  }
  return mechanism;
}

}  // namespace

TEST_CASE("Loads on an elastic beam are in balance, of any kind and division",
          "[flexible][beam_loads][property]") {
  std::mt19937 random(20);
  for (const Element element : {Element::classical, Element::corrected}) {
    for (const LinkKind kind :
         {LinkKind::rigid, LinkKind::bending, LinkKind::axial, LinkKind::full}) {
      for (int trial = 0; trial < 8; ++trial) {
        const Mechanism mechanism = random_mechanism(random, kind, element);
        const Structure structure = structure_of(mechanism);
        const double length = mechanism.links[1].length;
        const BeamResponse response = response_of_beam(structure, 1, test::beam_of_length(length));
        CAPTURE(static_cast<int>(kind), static_cast<int>(element), trial);
        for (const double time : {0.0, 0.3 / mechanism.frequency, 0.71 / mechanism.frequency}) {
          const BeamLoads loads = beam_loads_at(response, time);
          const Imbalance open = imbalance_of(loads);
          const double largest = largest_force(loads);
          CHECK(open.force.norm() < 1e-11 * largest);
          CHECK(open.moment.norm() < 1e-11 * largest * length);
          const CutForces end = cut_forces_of(loads).at({si<Length>(length), Side::before});
          CHECK(std::isfinite(end.M_y.value()));
        }
        std::vector<std::string_view> names;
        for (const PointLoad& load : response.constant.points) names.push_back(load.name);
        CHECK(names == std::vector<std::string_view>{"joint 1", "joint 3", "joint 4", "load"});
      }
    }
  }
}

// The spring joins what moves as one before and behind it: its force is the cut force there.
TEST_CASE("The cut force at a classical spring is the spring's force",
          "[flexible][beam_loads][property]") {
  std::mt19937 random(21);
  for (int trial = 0; trial < 12; ++trial) {
    Mechanism mechanism = random_mechanism(random, LinkKind::full, Element::classical);
    const Structure structure = structure_of(mechanism);
    const Response response = boxbeam::flexible::response_of(structure);
    const BeamResponse loads =
        beam_response_of(structure, 1, test::beam_of_length(mechanism.links[1].length), response,
                         response.harmonic.motion);
    const double time = 0.4 / mechanism.frequency;
    const CutForceDiagram diagram = cut_forces_of(beam_loads_at(loads, time));
    const Deformation<double> now = at(response, time);
    const DividedLink& divided = structure.links[1];
    const double size = largest_force(beam_loads_at(loads, time));
    for (std::size_t i = 0; i < divided.springs.size(); ++i) {
      const SpringElement& spring = divided.springs[i];
      const auto shift_of = [&](std::size_t element) {
        const Eigen::Vector3d q = now.motion[1].col(static_cast<Eigen::Index>(element));
        return Eigen::Vector3d(q[0], q[1] + q[2] * (spring.place - divided.elements[element].node),
                               q[2]);
      };
      const Eigen::Vector3d gap = shift_of(i + 1) - shift_of(i);
      const Eigen::Vector2d across = spring.bending.inverse() * gap.tail<2>();
      const CutForces cut = diagram.at({si<Length>(spring.place)});
      CAPTURE(trial, i);
      CHECK(std::abs(cut.N.value() - gap[0] / spring.axial) < 1e-8 * size);
      CHECK(std::abs(cut.V_z.value() - across[0]) < 1e-8 * size);
      // A couple is counter-clockwise; M > 0 puts the left side in tension.
      CHECK(std::abs(cut.M_y.value() + across[1]) < 1e-8 * size);
    }
  }
}

// M = -q s (L - s)/2 with tension below. Source: statics.
TEST_CASE("Weight on a pinned beam gives its parabola for any division",
          "[flexible][beam_loads][closed_form]") {
  constexpr double L = 6.0;
  constexpr double mass = 50.0;
  constexpr double g = 9.81;
  for (const Element element : {Element::classical, Element::corrected}) {
    for (const int parts : {1, 2, 3, 8, 50}) {
      Mechanism mechanism = pinned_beam(L, 2e7, mass, parts);
      mechanism.element = element;
      mechanism.gravity = {0.0, -g};
      const Structure structure = structure_of(mechanism);
      const BeamResponse response = response_of_beam(structure, 0, test::beam_of_length(L));
      const CutForceDiagram diagram = cut_forces_of(beam_loads_at(response, 0.0));
      const double q = mass * g;
      for (const double s : {0.13, 1.0, 2.4, 3.0, 4.77, 5.9}) {
        const CutForces cut = diagram.at({si<Length>(s)});
        CAPTURE(parts, s);
        CHECK(cut.M_y.value() == Approx(-0.5 * q * s * (L - s)).epsilon(1e-12));
        CHECK(cut.V_z.value() == Approx(-q * (0.5 * L - s)).margin(1e-10 * q * L));
      }
    }
  }
}

TEST_CASE("Uniform and linear accelerations give exact inertia per length",
          "[flexible][beam_loads][property]") {
  constexpr double L = 3.0;
  for (const Element element : {Element::classical, Element::corrected}) {
    // Corrected parts of equal length: within, no inertia is added.
    Mechanism mechanism = pinned_beam(L, 2e7, 40.0, 6);
    mechanism.element = element;
    mechanism.frequency = 7.0;
    mechanism.links[0].stretches[0].rotary.c[0] = 0.3;
    const Structure structure = structure_of(mechanism);
    const Response response = boxbeam::flexible::response_of(structure);
    LinkColumns<Complex> rigid = no_loads<Complex>(structure);
    const Eigen::Vector3d at_start(0.3, -0.2, 0.5);
    for (Eigen::Index i = 0; i < rigid[0].cols(); ++i) {
      const double s = structure.links[0].elements[static_cast<std::size_t>(i)].node;
      rigid[0].col(i) =
          Eigen::Vector3d(at_start[0], at_start[1] + at_start[2] * s, at_start[2]).cast<Complex>();
    }
    const BeamResponse loads =
        beam_response_of(structure, 0, test::beam_of_length(L), response, rigid);
    const double square = std::pow(2.0 * pi * 7.0, 2);
    for (const LineLoad& line : loads.sine.lines) {
      for (const double part : {0.0, 0.4, 1.0}) {
        const double x = part * line.length.value();
        const double s = line.start.value() + x;
        CHECK(line.force[0](x) == Approx(square * 40.0 * at_start[0]).epsilon(1e-12));
        CHECK(
            line.force[2](x) ==
            Approx(square * 40.0 * (at_start[1] + at_start[2] * s)).margin(1e-10 * square * 40.0));
        CHECK(line.couple[1](x) == Approx(-square * 0.3 * at_start[2]).epsilon(1e-12));
      }
    }
  }
}

// Under P sin(omega t) in the middle of a pinned beam
//     M(L/2) = -P/(4 b) (tan(b L/2) + tanh(b L/2)),   b^4 = omega^2 mu/EI.
// Source: Bernoulli-Euler beam, forced vibration.
TEST_CASE("The bending moment under a harmonic load converges with the parts",
          "[flexible][beam_loads][convergence]") {
  constexpr double L = 4.0;
  constexpr double EI = 1e7;
  constexpr double mass = 60.0;
  constexpr double P = 1e4;
  const double first = pi / 2.0 * std::sqrt(EI / (mass * std::pow(L, 4)));  // [Hz]
  for (const double ratio : {0.5, 2.2}) {
    const double omega = 2.0 * pi * ratio * first;
    const double b = std::pow(omega * omega * mass / EI, 0.25);
    const double exact = -P / (4.0 * b) * (std::tan(0.5 * b * L) + std::tanh(0.5 * b * L));
    for (const Element element : {Element::classical, Element::corrected}) {
      std::vector<double> errors;
      for (const int parts : {8, 16, 32, 64}) {
        Mechanism mechanism = pinned_beam(L, EI, mass, parts);
        mechanism.element = element;
        mechanism.frequency = ratio * first;
        Load load;
        load.at = {0, {0.5 * L, 0.0}};
        load.amplitude = {0.0, -P, 0.0};
        mechanism.loads = {load};
        const Structure structure = structure_of(mechanism);
        const BeamResponse response = response_of_beam(structure, 0, test::beam_of_length(L));
        const CutForceDiagram diagram = cut_forces_of(response.sine);
        const double M = diagram.at({si<Length>(0.5 * L), Side::before}).M_y.value();
        errors.push_back(std::abs(M / exact - 1.0));
      }
      const double order = std::log2(errors[2] / errors[3]);
      CAPTURE(ratio, static_cast<int>(element), errors[0], errors[1], errors[2], errors[3]);
      CHECK(order > (element == Element::corrected ? 3.9 : 1.9));
      CHECK(errors[3] < (element == Element::corrected ? 1e-4 : 1e-2));
    }
  }
}

// Shear changes within a part by no more than its inertia, and that of next to nothing is as much.
TEST_CASE("A part of next to no length beside long ones bends by no shear of its own",
          "[flexible][beam_loads]") {
  constexpr double L = 4.0, place = 1.7;
  for (const double sliver : {1e-2, 1e-3, 1e-4, 1e-5}) {
    CAPTURE(sliver);
    Mechanism mechanism = pinned_beam(L, 1e7, 60.0, 8);
    mechanism.nodes_at_joints = true;
    mechanism.frequency = 25.0;
    Load load;
    load.at = {0, {place, 0.0}};
    load.amplitude = {0.0, -1e4, 0.0};
    Load none = load;
    none.at = {0, {place + sliver, 0.0}};
    none.amplitude = {0.0, -1e-3, 0.0};
    mechanism.loads = {load, none};
    const Structure structure = structure_of(mechanism);
    const CutForceDiagram diagram =
        cut_forces_of(response_of_beam(structure, 0, test::beam_of_length(L)).sine);
    const auto shear = [&](double part) {
      return diagram.at({si<Length>(place + part * sliver), Side::both}).V_z.value();
    };
    const double before = diagram.at({si<Length>(place), Side::behind}).V_z.value();
    REQUIRE(std::abs(before) > 1e3);
    for (const double part : {0.25, 0.5, 0.75}) CHECK(shear(part) == Approx(before).epsilon(0.05));
  }
}

}  // namespace boxbeam::flexible
