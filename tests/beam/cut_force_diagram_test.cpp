#include "boxbeam/beam/cut_force_diagram.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "catch.hpp"

namespace cut_force_diagram_test {

using namespace boxbeam;
using Eigen::Vector3d;

namespace {

Length m(double x) { return si<Length>(x); }

Section box(double width, double height, double wall) {
  return {symmetric_box(m(width), m(height), m(wall), m(wall)), {}};
}

/// A uniform beam without mass of its own, in one or two segments.
TaperedBeam light(std::vector<double> lengths) {
  TaperedBeam beam;
  double s = 0.0;
  for (const double length : lengths) {
    beam.segments.push_back({"", m(s), m(length), box(0.4, 0.6, 0.05), box(0.4, 0.6, 0.05)});
    s += length;
  }
  return beam;
}

BeamLoads loads_on(const TaperedBeam& beam, std::vector<PointLoad> points) {
  return {std::move(points), unloaded_lines(beam)};
}

PointLoad push(double s, Vector3d force) { return {m(s), force, Vector3d::Zero()}; }
PointLoad couple(double s, Vector3d moment) { return {m(s), Vector3d::Zero(), moment}; }

/// Force and moment in a cut as two vectors.
struct Cut {
  Vector3d force, moment;
};

Cut cut_at(const CutForceDiagram& diagram, double s, Side side = Side::both) {
  const CutForces c = diagram.at({m(s), side});
  return {{c.N.value(), c.V_y.value(), c.V_z.value()}, {c.T.value(), c.M_y.value(), c.M_z.value()}};
}

Cut jump_at(const CutForceDiagram& diagram, double s) {
  const Cut before = cut_at(diagram, s, Side::before), behind = cut_at(diagram, s, Side::behind);
  return {behind.force - before.force, behind.moment - before.moment};
}

constexpr double rho = 7800;

/// Two tapers of a box: widths, heights and walls by hand below.
TaperedBeam tapered() {
  TaperedBeam beam;
  beam.segments = {{"a", m(0), m(2), box(0.4, 0.6, 0.05), box(0.4, 1.0, 0.05)},
                   {"b", m(2), m(3), box(0.4, 1.0, 0.05), box(0.2, 0.3, 0.02)}};
  beam.density = si<Density>(rho);
  beam.rotary_inertia = true;
  return beam;
}

struct AreaAndInertia {
  double A, I_y, I_z;
};

/// Hand formulas for the sections of `tapered`.
AreaAndInertia section_by_hand(double s) {
  const double x = s < 2 ? s / 2 : (s - 2) / 3;
  const double w = s < 2 ? 0.4 : 0.4 - 0.2 * x;
  const double h = s < 2 ? 0.6 + 0.4 * x : 1.0 - 0.7 * x;
  const double t = s < 2 ? 0.05 : 0.05 - 0.03 * x;
  const double v = w - 2 * t, g = h - 2 * t;
  return {w * h - v * g, (w * h * h * h - v * g * g * g) / 12,
          (h * w * w * w - g * v * v * v) / 12};
}

}  // namespace

TEST_CASE("N: a pull at both ends is tension") {
  const TaperedBeam beam = light({4});
  const auto diagram = cut_forces_of(loads_on(beam, {push(0, {-7, 0, 0}), push(4, {7, 0, 0})}));
  CHECK(cut_at(diagram, 1).force == Vector3d(7, 0, 0));
}

TEST_CASE("V_z: what lies behind the cut pushes the part before it along +z") {
  const TaperedBeam beam = light({4});
  const auto diagram = cut_forces_of(loads_on(beam, {push(0, {0, 0, -5}), push(4, {0, 0, 5})}));
  CHECK(cut_at(diagram, 1).force == Vector3d(0, 0, 5));
}

TEST_CASE("V_y: what lies behind the cut pushes the part before it along +y") {
  const TaperedBeam beam = light({4});
  const auto diagram = cut_forces_of(loads_on(beam, {push(0, {0, -5, 0}), push(4, {0, 5, 0})}));
  CHECK(cut_at(diagram, 1).force == Vector3d(0, 5, 0));
}

TEST_CASE("T: a couple about +x at the end, held at the start, is positive") {
  const TaperedBeam beam = light({4});
  const auto diagram = cut_forces_of(loads_on(beam, {couple(0, {-3, 0, 0}), couple(4, {3, 0, 0})}));
  CHECK(cut_at(diagram, 1).moment == Vector3d(3, 0, 0));
}

TEST_CASE("M_y: a cantilever pulled along -z at its tip has its +z side in tension") {
  // Held at s = 0; the tip goes to -z, so the fibres at +z stretch: M_y = F (L - s) > 0.
  const TaperedBeam beam = light({4});
  const auto diagram =
      cut_forces_of(loads_on(beam, {{m(0), {0, 0, 6}, {0, -24, 0}}, push(4, {0, 0, -6})}));
  CHECK(cut_at(diagram, 0, Side::behind).moment.y() == Approx(24).epsilon(1e-14));
  CHECK(cut_at(diagram, 1).moment.y() == Approx(18).epsilon(1e-14));
  CHECK(cut_at(diagram, 4).moment.y() == Approx(0).margin(1e-13));
}

TEST_CASE("M_z: a cantilever pulled along +y at its tip has its -y side in tension") {
  const TaperedBeam beam = light({4});
  const auto diagram =
      cut_forces_of(loads_on(beam, {{m(0), {0, -6, 0}, {0, 0, -24}}, push(4, {0, 6, 0})}));
  CHECK(cut_at(diagram, 0, Side::behind).moment.z() == Approx(24).epsilon(1e-14));
  CHECK(cut_at(diagram, 1).moment.z() == Approx(18).epsilon(1e-14));
}

TEST_CASE("simply supported beam under uniform load: w L/2 and w L^2/8, Timoshenko I") {
  const double L = 6, w = 1000;
  const TaperedBeam beam = light({2.5, 3.5});
  BeamLoads loads = loads_on(beam, {push(0, {0, 0, w * L / 2}), push(L, {0, 0, w * L / 2})});
  for (LineLoad& line : loads.lines) line.force[2].c[0] = -w;
  const CutForceDiagram diagram = cut_forces_of(loads);
  for (double s = 0.25; s < L; s += 0.25) {
    CHECK(cut_at(diagram, s).force.z() == Approx(w * (s - L / 2)).margin(1e-9));
    // The load acts along -z: the -z side is in tension.
    CHECK(cut_at(diagram, s).moment.y() == Approx(-w * s * (L - s) / 2).margin(1e-8));
  }
  CHECK(cut_at(diagram, 3).moment.y() == Approx(-w * L * L / 8).epsilon(1e-13));
}

TEST_CASE("cantilever under triangular load: w L/2 and w L^2/6 at the wall") {
  // Load w (1 - s/L) along -z, largest at the wall s = 0.
  const double L = 3, w = 900;
  const TaperedBeam beam = light({L});
  BeamLoads loads = loads_on(beam, {{m(0), {0, 0, w * L / 2}, {0, -w * L * L / 6, 0}}});
  loads.lines[0].force[2] = {{-w, w / L, 0, 0}};
  const CutForceDiagram diagram = cut_forces_of(loads);
  CHECK(cut_at(diagram, 0, Side::behind).force.z() == Approx(-w * L / 2).epsilon(1e-14));
  CHECK(cut_at(diagram, 0, Side::behind).moment.y() == Approx(w * L * L / 6).epsilon(1e-14));
  // w (L - s)^3/(6 L) at s.
  CHECK(cut_at(diagram, 1).moment.y() == Approx(w * 8 / (6 * L)).epsilon(1e-12));
  CHECK(cut_at(diagram, L).moment.y() == Approx(0).margin(1e-10));
}

TEST_CASE(
    "jumps equal the applied loads, taken off, also inside a segment and for several at once") {
  const TaperedBeam beam = light({2, 3});
  const BeamLoads loads = loads_on(beam, {couple(3.5, {1, 2, 3}),  // unsorted on purpose
                                          push(1.25, {4, 5, 6}), push(3.5, {7, -8, 9}),
                                          push(2, {1, 1, 1}), push(0, {-12, 2, -16})});
  const CutForceDiagram diagram = cut_forces_of(loads);
  CHECK((jump_at(diagram, 1.25).force + Vector3d(4, 5, 6)).norm() < 1e-12);
  CHECK((jump_at(diagram, 2).force + Vector3d(1, 1, 1)).norm() < 1e-12);
  CHECK((jump_at(diagram, 3.5).force + Vector3d(7, -8, 9)).norm() < 1e-12);
  CHECK((jump_at(diagram, 3.5).moment + Vector3d(1, 2, 3)).norm() < 1e-12);
  CHECK(jump_at(diagram, 1.25).moment.norm() < 1e-12);
  // `both` means behind at a jump.
  CHECK(cut_at(diagram, 3.5).force == cut_at(diagram, 3.5, Side::behind).force);
}

TEST_CASE("outside the beam and before its start nothing is cut") {
  const TaperedBeam beam = light({4});
  const auto diagram = cut_forces_of(loads_on(beam, {push(0, {-7, 0, 0}), push(4, {7, 0, 0})}));
  CHECK(cut_at(diagram, 0, Side::before).force.norm() == 0.0);
  CHECK(cut_at(diagram, 4, Side::behind).force.norm() == 0.0);
  CHECK(cut_at(diagram, -1).force.norm() == 0.0);
  CHECK(cut_at(diagram, 4.5).force.norm() == 0.0);
  CHECK(cut_at(diagram, 4, Side::before).force.x() == 7.0);
}

TEST_CASE(
    "random loads on a tapered beam: cut forces from the start equal Simpson's from the end") {
  const TaperedBeam beam = tapered();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto vector = [&](double size) -> Vector3d {
    return {size * any(random), size * any(random), size * any(random)};
  };
  for (int run = 0; run < 20; ++run) {
    const Vector3d gravity = vector(10);
    const BeamMotion motion{vector(5), vector(2), vector(3)};
    const Vector3d o = motion.omega, a = motion.alpha;
    const Vector3d gradient(-o.y() * o.y() - o.z() * o.z(), a.z() + o.x() * o.y(),
                            -a.y() + o.x() * o.z());
    std::vector<PointLoad> points;
    for (int i = 0; i < 5; ++i) {
      points.push_back({m(2.5 * (1 + any(random))), vector(1e5), vector(1e4)});
    }
    // Loads behind s, and their moment about the axis point at s, by Simpson's rule with the
    // sections' hand formulas.
    const auto behind = [&](double s) -> Cut {
      Cut sum{Vector3d::Zero(), Vector3d::Zero()};
      for (const PointLoad& load : points) {
        if (load.s.value() <= s) continue;
        sum.force += load.force;
        sum.moment += load.moment + Vector3d(load.s.value() - s, 0, 0).cross(load.force);
      }
      for (const auto& [low, high] :
           {std::pair{std::min(s, 2.0), 2.0}, std::pair{std::max(s, 2.0), 5.0}}) {
        const int steps = 60;
        for (int i = 0; i <= steps && high > low; ++i) {
          // A hair inside, for the section's formula changes at 2 m.
          const double at = std::min(low + (high - low) * i / steps, high - 1e-13);
          const double weight = (high - low) / steps / 3 *
                                (i == 0 || i == steps ? 1
                                 : i % 2 == 1         ? 4
                                                      : 2);
          const AreaAndInertia section = section_by_hand(at);
          const Vector3d q = rho * section.A * (gravity - motion.acceleration - at * gradient);
          sum.force += weight * q;
          sum.moment += weight * Vector3d(at - s, 0, 0).cross(q);
          // Euler's equations with I_x = I_y + I_z of the section.
          const double I_x = section.I_y + section.I_z;
          sum.moment -= weight * rho *
                        Vector3d(I_x * a.x() + (section.I_z - section.I_y) * o.y() * o.z(),
                                 section.I_y * a.y() + (I_x - section.I_z) * o.z() * o.x(),
                                 section.I_z * a.z() + (section.I_y - I_x) * o.x() * o.y());
        }
      }
      return sum;
    };
    // One more load, inside a segment, brings the beam into balance.
    const double support = 2.5 * (1 + any(random));
    const Cut all = behind(-1e-12);
    points.push_back(
        {m(support), -all.force, -all.moment + Vector3d(support, 0, 0).cross(all.force)});
    const BeamLoads loads{points,
                          weight_and_inertia(beam, mass_distribution_of(beam), gravity, motion)};
    CHECK(imbalance_of(loads).force.norm() < 1e-3);
    CHECK(imbalance_of(loads).moment.norm() < 1e-3);
    const CutForceDiagram diagram = cut_forces_of(loads);
    for (double s = 0.05; s < 5.0; s += 0.313) {
      const Cut expected = behind(s), cut = cut_at(diagram, s);
      CAPTURE(run, s);
      CHECK((cut.force - expected.force).norm() < 1e-8 * 1e5);
      CHECK((cut.moment - expected.moment).norm() < 1e-8 * 1e5);
    }
  }
}

TEST_CASE("dM_y/ds = V_z - m_y and dV_z/ds = -q_z on every piece, by central differences") {
  const TaperedBeam beam = tapered();
  BeamLoads loads;
  loads.lines = weight_and_inertia(beam, mass_distribution_of(beam), {2, 1, -9},
                                   {{1, 2, 3}, {2, 3, 4}, {5, -6, 7}});
  for (LineLoad& line : loads.lines) {
    line.couple[0].c[0] = 300;
    line.couple[2].c[1] = 700;
  }
  loads.points = {push(1.3, {100, 200, 300}), push(3.1, {-500, 900, -800})};
  const CutForceDiagram diagram = cut_forces_of(loads);
  const double h = 1e-3;
  for (const double s : {0.5, 1.2, 1.4, 1.9, 2.1, 3.0, 3.2, 4.9}) {
    const std::size_t i = s < 2 ? 0 : 1;
    const double x = s - beam.segments[i].start.value();
    const auto q = [&](std::size_t axis) { return loads.lines[i].force[axis](x); };
    const auto c = [&](std::size_t axis) { return loads.lines[i].couple[axis](x); };
    const Cut at = cut_at(diagram, s), low = cut_at(diagram, s - h), high = cut_at(diagram, s + h);
    const Vector3d force_slope = (high.force - low.force) / (2 * h);
    const Vector3d moment_slope = (high.moment - low.moment) / (2 * h);
    CAPTURE(s);
    const double scale = 1e-5 * 1e4;
    CHECK((force_slope + Vector3d(q(0), q(1), q(2))).norm() < scale);
    const Vector3d expected(-c(0), at.force.z() - c(1), -at.force.y() - c(2));
    CHECK((moment_slope - expected).norm() < scale);
  }
}

TEST_CASE("pieces join without gaps and begin at every load") {
  const TaperedBeam beam = light({2, 3});
  const CutForceDiagram diagram =
      cut_forces_of(loads_on(beam, {push(1.25, {1, 0, 0}), push(4, {-1, 0, 0})}));
  const double starts[] = {0, 1.25, 2, 4};
  REQUIRE(diagram.pieces.size() == std::size(starts));
  for (std::size_t i = 0; i < std::size(starts); ++i) {
    CHECK(diagram.pieces[i].start.value() == Approx(starts[i]).margin(1e-14));
    if (i > 0)
      CHECK(diagram.pieces[i].start.value() == Approx(diagram.pieces[i - 1].end().value()));
  }
  CHECK(diagram.pieces.back().end().value() == Approx(5.0));
}

}  // namespace cut_force_diagram_test
