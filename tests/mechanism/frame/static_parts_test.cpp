// What a scene does statically beside its modes, which must not depend on how it is held while it
// is solved.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "boxbeam/beam/beam_loads.hpp"
#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "catch.hpp"

namespace static_parts_test {

using namespace boxbeam;
using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double E = 2.1e11, G = 8.1e10, L = 4.0;

TaperedBeam even_beam() {
  TaperedBeam beam;
  beam.density = si<Density>(7850.0);
  const Section box{symmetric_box(0.12 * metre, 0.2 * metre, 0.006 * metre, 0.006 * metre), {}};
  beam.segments = {{"", Length{}, si<Length>(L), box, box}};
  return beam;
}

frame::Tie tied(int a, int b, const Vector3d& at, Index way) {
  frame::Tie of;
  const frame::Vector6 per = frame::Vector6::Unit(way);
  of.ends = {{{a, at}, -per}, {{b, at}, per}};
  return of;
}

/// A beam on a hub that moves along z alone, on a spring and a damper; another spring with a damper
/// stands below the tip, a third beside the middle.
frame::VibratingScene falling(const frame::VibratingBeam& beam, double below,
                              std::size_t may_move) {
  frame::VibratingScene scene{{{&beam, {}}}, {}, {}, may_move};
  frame::RigidMass hub;
  hub.mass = 200.0;
  hub.centre = {-0.1, 0.05, 0.2};
  hub.inertia = Vector3d(2.0, 1.0, 1.5).asDiagonal();
  scene.bodies.push_back(hub);
  for (Index way = 0; way < 6; ++way) {
    scene.ties.push_back(tied(0, 1, Vector3d::Zero(), way));
    if (way != 2) scene.ties.push_back(tied(frame::ground, 1, Vector3d::Zero(), way));
  }
  const auto add_spring = [&](int on, const Vector3d& at, Index way, double k, double c) {
    frame::Tie& spring = scene.ties.emplace_back(tied(frame::ground, on, at, way));
    spring.stiffness = k;
    spring.damping = c;
  };
  add_spring(1, Vector3d::Zero(), 2, below, 50.0);
  add_spring(0, {L, 0.0, 0.0}, 2, 0.1 * below, 20.0);
  add_spring(0, {0.5 * L, 0.0, 0.0}, 1, 2e5, 10.0);
  return scene;
}

/// Of no order, as large as bending moments are, along one beam.
VectorXd some_cuts(const frame::VibratingBeam& beam) {
  VectorXd cuts(static_cast<Index>(6 * beam.stations().size()));
  for (Index k = 0; k < cuts.size(); ++k) cuts[k] = 1e3 * std::sin(1.0 + 0.7 * double(k * k % 97));
  return cuts;
}

frame::StaticParts parts_of(const frame::VibratingBeam& beam, double below, std::size_t may_move) {
  frame::KeptTies last;
  const frame::FactoredScene scene(falling(beam, below, may_move), last);
  return static_parts_of(scene, frame::modes_of(scene, 3), some_cuts(beam));
}

/// How far two loads are apart, relative to the largest point load.
double apart(const BeamLoads& one, const BeamLoads& other) {
  REQUIRE(one.points.size() == other.points.size());
  double largest = 0.0, most = 0.0;
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    const PointLoad &a = one.points[i], &b = other.points[i];
    largest = std::max({largest, b.force.norm(), b.moment.norm() / L});
    most = std::max({most, (a.force - b.force).norm(), (a.moment - b.moment).norm() / L});
  }
  return most / largest;
}

double imbalance(const BeamLoads& loads) {
  double largest = 0.0;
  for (const PointLoad& of : loads.points) largest = std::max(largest, of.force.norm());
  const Imbalance left = imbalance_of(loads);
  return (left.force.norm() + left.moment.norm() / L) / largest;
}

}  // namespace

// Independent computation: K y = f by K itself, which stands on its springs.
TEST_CASE("what may move without force and stands on springs is moved as what must stand",
          "[frame][vibration]") {
  const TaperedBeam beam = even_beam();
  const frame::VibratingBeam vibrating(beam, E, G, {0.0, 0.5 * L, L}, 8);
  for (const auto& [below, round_off] : {std::pair{1e6, 1e-9}, {1e3, 1e-8}, {1.0, 1e-5}}) {
    CAPTURE(below);
    const frame::StaticParts stands = parts_of(vibrating, below, 0),
                             moves = parts_of(vibrating, below, 1);
    REQUIRE(stands.dampers.size() == 3);
    REQUIRE(moves.dampers.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(apart(moves.dampers[i].loads, stands.dampers[i].loads) < round_off);
      CHECK(imbalance(moves.dampers[i].loads) < round_off);
      CHECK(moves.dampers[i].gaps.norm() == Approx(stands.dampers[i].gaps.norm()).epsilon(1e-7));
    }
    CHECK(apart(*moves.taken_over, *stands.taken_over) < round_off);
  }
}

// The limit of ever softer springs.
TEST_CASE("what moves without force is moved beside its modes as on springs that hardly hold it",
          "[frame][vibration]") {
  const TaperedBeam beam = even_beam();
  const frame::VibratingBeam vibrating(beam, E, G, {0.0, 0.5 * L, L}, 8);
  const frame::StaticParts free = parts_of(vibrating, 0.0, 1), softly = parts_of(vibrating, 1.0, 1);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(apart(free.dampers[i].loads, softly.dampers[i].loads) < 1e-6);
  CHECK(apart(*free.taken_over, *softly.taken_over) < 1e-6);
}

}  // namespace static_parts_test
