// Statics of the second order of mechanisms in space: closed forms of beam-columns, balance on the
// bent axis and the same mechanism in the plane.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_area.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/model_gates.hpp"
#include "support/bent_in_space.hpp"
#include "support/gates.hpp"
#include "support/luffing_boom.hpp"

namespace second_order_in_space_test {

using namespace boxbeam;
using namespace test::bent;
using Eigen::Index;
using Eigen::Vector3d;
using test::luffing_in_plane;
using test::luffing_in_space;

namespace {

constexpr double pi = std::numbers::pi, L = 4.0;

/// A beam of 4 m along x clamped at its start, under forces at its tip and one beside its axis.
std::string cantilever(const Vector3d& tip, const char* to = "arm",
                       const Vector3d& beside = Vector3d::Zero(), const std::string& more = "",
                       double density = 1e-3, const Vector3d& gravity = Vector3d::Zero()) {
  std::string text = header(gravity) + R"([bodies.arm]
points = { heel = ["0 m", "0 m", "0 m"], lug = ["2.5 m", "0.3 m", "-0.4 m"], tip = ["4 m", "0 m", "0 m"] }
[joints.heel]
kind = "fixed"
connect = ["ground", "arm.heel"]
at = ["0 m", "0 m", "0 m"]
)";
  text += force_text("tip", "arm.tip", tip);
  if (beside.norm() > 0.0) text += force_text("beside", "arm.lug", beside);
  return text + sections +
         fmt::format(
             "[beam]\nbody = \"arm\"\nstart = \"heel\"\naxis = \"x\"\nz = \"z\"\ndensity = "
             "\"{} kg/m^3\"\n[[beam.segments]]\nlength = \"4 m\"\nfrom = \"arm\"\nto = \"{}\"\n",
             density, to) +
         demands + more;
}

/// Of a cantilever, k^2 of Timoshenko's column under P, whose shear is across its bent axis
/// (Engesser).
double wave_number(double P, double EI, double GA) { return std::sqrt(P / (EI * (1.0 - P / GA))); }

}  // namespace

// Timoshenko, Gere, Theory of Elastic Stability (1961), article 1.3, with shear (article 2.17):
// M'' + k^2 M = 0, M' (1 - P/GA) = Q at the clamp, so M = Q tan(k L)/(k (1 - P/GA)) there. So small
// a Q does not twist the beam.
TEST_CASE("a pressed cantilever has the moment of the beam-column about any axis",
          "[second_order]") {
  const Bent any(cantilever({0.0, 0.0, 1.0}));
  const SectionProperties of = properties_of(any.section());
  const ShearAreas shear = shear_areas_of(any.section());
  const double EI_y = E * of.I_y.value(), EI_z = E * of.I_z.value(), GA_y = G * shear.y.value(),
               GA_z = G * shear.z.value();
  const double N_cr = std::pow(pi / (2.0 * L), 2) * EI_z, Q = 1.0;
  for (const double part : {0.1, 0.4, 0.8}) {
    const double P = part * N_cr;
    for (const double angle : {0.0, 0.5 * pi, 0.7, 2.4}) {
      const double Q_y = Q * std::cos(angle), Q_z = Q * std::sin(angle);
      const CutForceDiagram diagram = Bent(cantilever({-P, Q_y, Q_z})).diagram();
      for (const double s : {0.0, 1.3, 2.77}) {
        CAPTURE(part, angle, s);
        const auto expected = [&](double load, double EI, double GA) {
          const double k = wave_number(P, EI, GA);
          return load * std::sin(k * (L - s)) / std::cos(k * L) / (k * (1.0 - P / GA));
        };
        const Vector6 found = cuts_at(diagram, s);
        // Q up lengthens -z, Q along y shortens +y: M_z = Q (L - s).
        CHECK(found[5] == Approx(expected(Q_y, EI_z, GA_y)).epsilon(1e-5).margin(1e-7));
        CHECK(found[4] == Approx(-expected(Q_z, EI_y, GA_z)).epsilon(1e-5).margin(1e-7));
        CHECK(found[0] == Approx(-P));
      }
    }
  }
}

// As above, with the clamp turned by the moment there over its stiffness c: M' (1 - P/GA) =
// Q + P M/c. What is in the joint strains it as well.
TEST_CASE("a pressed cantilever on a joint that gives way has the moment of the beam-column",
          "[second_order]") {
  const Bent any(cantilever({0.0, 0.0, 1.0}));
  const SectionProperties of = properties_of(any.section());
  const ShearAreas shear = shear_areas_of(any.section());
  const double EI_y = E * of.I_y.value(), EI_z = E * of.I_z.value(), GA_y = G * shear.y.value(),
               GA_z = G * shear.z.value();
  const double c = EI_z / L, P = 0.1 * std::pow(pi / (2.0 * L), 2) * EI_z;
  const auto expected = [&](double EI, double GA) {
    const double k = wave_number(P, EI, GA);
    return std::sin(k * L) / (k * (1.0 - P / GA) * std::cos(k * L) - P * std::sin(k * L) / c);
  };
  const auto on_a_spring = [&](const Vector3d& tip) {
    std::string text = cantilever(tip);
    const std::string at = "[joints.heel]\n";
    text.insert(text.find(at) + at.size(),
                fmt::format("turning_stiffness = \"{:.17g} N m/rad\"\n", c));
    return Bent(text).diagram();
  };
  const Vector6 along_y = cuts_at(on_a_spring({-P, 1.0, 0.0}), 0.0),
                along_z = cuts_at(on_a_spring({-P, 0.0, 1.0}), 0.0);
  CHECK(along_y[5] == Approx(expected(EI_z, GA_y)).epsilon(1e-5));
  CHECK(along_z[4] == Approx(-expected(EI_y, GA_z)).epsilon(1e-5));
  CHECK(along_y[5] > 1.1 * L);
}

TEST_CASE("tension stiffens a cantilever", "[second_order]") {
  const Bent any(cantilever({0.0, 0.0, 1.0}));
  const SectionProperties of = properties_of(any.section());
  const double GA = G * shear_areas_of(any.section()).y.value(), EI = E * of.I_z.value();
  const double S = 1.5 * std::pow(pi / (2.0 * L), 2) * EI, Q = 1.0;
  const double k = std::sqrt(S / (EI * (1.0 + S / GA)));
  const Bent beam(cantilever({S, Q, 0.0}));
  CHECK(cuts_at(beam.diagram(), 0.0)[5] ==
        Approx(Q * std::tanh(k * L) / (k * (1.0 + S / GA))).epsilon(1e-5));
  CHECK(std::abs(cuts_at(beam.diagram(), 0.0)[5]) < 0.6 * Q * L);
}

// No start that is curved: what is pressed along its axis alone stays straight.
TEST_CASE("a beam that is pressed along its axis alone stays straight", "[second_order]") {
  const Bent beam(cantilever({-150e3, 0.0, 0.0}));
  for (const double s : {0.0, 1.7, 3.9})
    CHECK((cuts_at(beam.diagram(), s) - cuts_at(beam.straight(), s)).norm() < 1e-6 * 150e3);
}

// Amplification tends to that of the first mode of buckling, 1/(1 - N/N_cr) times its share of the
// deflection: of a cantilever under Q at its tip, whose part in that mode is 96/pi^4.
TEST_CASE("near its buckling load a beam deflects as its mode of buckling", "[second_order]") {
  const Bent any(cantilever({0.0, 0.0, 1.0}));
  const double EI = E * properties_of(any.section()).I_z.value(),
               GA = G * shear_areas_of(any.section()).y.value();
  const double Euler = std::pow(pi / (2.0 * L), 2) * EI, N_cr = Euler / (1.0 + Euler / GA);
  for (const double part : {0.9, 0.97, 0.99}) {
    const Bent beam(cantilever({-part * N_cr, 1.0, 0.0}));
    const double v = beam.scene().motion[6 * 16 + 1];
    CAPTURE(part);
    CHECK(v * (1.0 - part) * 3.0 * EI / std::pow(L, 3) ==
          Approx(96.0 / std::pow(pi, 4)).epsilon(0.02));
  }
  const auto beyond = Bent(cantilever({-0.5 * N_cr, 1.0, 0.0})).scene(2.04).critical;
  REQUIRE(beyond);
  CHECK(*beyond == Approx(2.0).epsilon(2e-3));
  // Verified, it does not stand.
  const Project buckling = parse_project("bent.toml", cantilever({-1.02 * N_cr, 1.0, 0.0}));
  CHECK_THROWS_AS(run_situations(buckling, bent_by(16)), AnalysisError);
  const Verification of = verify(parse_project("bent.toml", cantilever({-1.02 * N_cr, 1.0, 0.0})));
  CHECK(of.model.second_order.across->part == Approx(1.02).epsilon(3e-3));
  CHECK(test::blocks(of, "it buckles"));
}

// From outside: the moment at a place is that of the forces beyond it about the bent axis, as far
// as all of them have moved, in axes that have turned with the section.
TEST_CASE("cut moments of a bent and twisted beam are in balance on its bent axis",
          "[second_order]") {
  const Vector3d tip(-60e3, 3e3, -9e3), beside(20e3, -2e3, 5e3), arm(0.0, 0.3, -0.4);
  for (const char* to : {"arm", "tip"}) {
    const int parts = 48;
    const Bent beam(cantilever(tip, to, beside), parts);
    const frame::BentScene scene = beam.scene();
    const CutForceDiagram diagram = beam.diagram(), straight = beam.straight();
    // Nodes are even on both sides of the lug.
    const auto nodes = static_cast<Index>(scene.motion.size() / 6);
    // Theory of the second order leaves out that a beam shortens.
    const auto shift = [&](Index k) -> Vector3d {
      return {0.0, scene.motion[6 * k + 1], scene.motion[6 * k + 2]};
    };
    const auto turn = [&](Index k) -> Vector3d { return scene.motion.segment<3>(6 * k + 3); };
    const Index before = 30;  // 2.5 m of 4 m in 48 parts
    const auto s_of = [&](Index k) {
      return k <= before ? 2.5 * static_cast<double>(k) / before
                         : 2.5 + 1.5 * static_cast<double>(k - before) /
                                     static_cast<double>(nodes - 1 - before);
    };
    REQUIRE(scene.loads.lines[30].start.value() == Approx(2.5));
    double largest = 0.0, wrong = 0.0;
    for (Index k = 0; k + 1 < nodes; ++k) {
      const double s = s_of(k);
      const auto moment_of = [&](const Vector3d& force, const Vector3d& from,
                                 const Vector3d& moved) {
        const Vector3d at = from - Vector3d(s, 0.0, 0.0);
        return std::pair<Vector3d, Vector3d>(at.cross(force), (moved - shift(k)).cross(force));
      };
      auto [rigid, added] = moment_of(tip, {L, 0.0, 0.0}, shift(nodes - 1));
      if (k < before) {
        const auto [more, moved] = moment_of(beside, Vector3d(2.5, 0.0, 0.0) + arm,
                                             shift(before) + turn(before).cross(arm));
        rigid += more;
        added += moved;
      }
      const Vector3d expected = added - turn(k).cross(rigid);
      const Vector6 found = cuts_at(diagram, s, Side::behind) - cuts_at(straight, s, Side::behind);
      largest = std::max(largest, expected.norm());
      wrong = std::max(wrong, (found.tail<3>() - expected).norm());
      // Shear forces of the forces beyond, across the turned section.
      const Vector3d sheared = -turn(k).cross(k < before ? Vector3d(tip + beside) : tip);
      CHECK(found[1] == Approx(sheared.y()).margin(1e-4 * sheared.norm() + 1e-6));
      CHECK(found[2] == Approx(sheared.z()).margin(1e-4 * sheared.norm() + 1e-6));
    }
    CAPTURE(to, largest, wrong);
    CHECK(largest > 2e3);
    // Of the moments themselves less than 5e-6.
    CHECK(wrong < (std::string(to) == "arm" ? 1e-5 : 4e-5) * largest);
    const Imbalance left = imbalance_of(scene.loads);
    CHECK(left.force.norm() < 1e-6 * tip.norm());
    CHECK(left.moment.norm() < 1e-8 * tip.norm() * L);
  }
}

// Timoshenko, Gere, article 6.4: a narrow strip clamped at its start under a force at its tip, in
// the line of its centroids, turns over at 4.0126 sqrt(EI_z G I_T)/L^2.
TEST_CASE("moments turn a strip over", "[second_order]") {
  const std::string text = [&] {
    std::string of = cantilever({0.0, 0.0, -1e3});
    for (const char* name : {"[sections.arm]", "[sections.tip]"}) {
      const std::size_t at = of.find(name);
      const std::size_t end = of.find("web = \"6 mm\"\n", at) + 13;
      of.replace(
          at, end - at,
          std::string(name) + "\nkind = \"plate\"\nheight = \"400 mm\"\nwidth = \"10 mm\"\n");
    }
    return of;
  }();
  const Bent beam(text);
  const double EI_z = E * properties_of(beam.section()).I_z.value(),
               GI_T = G * torsion_properties_of(beam.section()).I_T->value();
  const double critical = 4.0126 * std::sqrt(EI_z * GI_T) / (L * L);
  const auto found = beam.scene(1.5 * critical / 1e3).critical;
  REQUIRE(found);
  CHECK(*found * 1e3 == Approx(critical).epsilon(4e-3));
}

TEST_CASE("a luffing boom of the plane bends in space as in the plane", "[second_order]") {
  for (const double degrees : {180.5, 190.0, 200.0, 20.0}) {
    const Bent plane(luffing_in_plane(degrees, 120.0), 64),
        space(luffing_in_space(degrees, 120.0), 32);
    const CutForceDiagram in_plane = plane.diagram(), straight = plane.straight(),
                          in_space = space.diagram();
    double largest = 0.0, second = 0.0, apart = 0.0;
    for (const double s : {0.0, 0.4, 1.1, 1.95, 2.3, 3.1, 3.8}) {
      const Vector6 of = cuts_at(in_plane, s), by = cuts_at(in_space, s);
      largest = std::max(largest, std::abs(of[4]));
      second = std::max(second, std::abs(of[4] - cuts_at(straight, s)[4]));
      apart = std::max(apart, std::abs(of[4] - by[4]));
      CHECK(by[0] == Approx(of[0]).epsilon(1e-5));
      CHECK(by[2] == Approx(of[2]).epsilon(1e-3).margin(1.0));
    }
    CAPTURE(degrees, largest, second, apart);
    CHECK(second > 1e-3 * largest);
    CHECK(apart < 1e-5 * largest);
    // And so do the estimates.
    const auto plane_of = estimate_second_order(plane.project, plane.rigid),
               space_of = estimate_second_order(space.project, space.rigid);
    REQUIRE(plane_of.change);
    REQUIRE(space_of.change);
    CHECK(space_of.whole);
    CHECK(*space_of.change == Approx(*plane_of.change).epsilon(2e-3));
    CHECK(space_of.turn == Approx(plane_of.turn).epsilon(2e-3));
  }
}

TEST_CASE("a turned mechanism bends alike", "[second_order]") {
  const Bent straight(luffing_in_space(190.0, 120.0, 0.0, 0.0, 0.02));
  for (const auto& [z, x] : {std::pair(37.0, 0.0), std::pair(0.0, 90.0), std::pair(-128.0, 61.0)}) {
    const Bent turned(luffing_in_space(190.0, 120.0, z, x, 0.02));
    for (const double s : {0.0, 1.1, 2.3, 3.1}) {
      const Vector6 expected = cuts_at(straight.diagram(), s), of = cuts_at(turned.diagram(), s);
      CHECK((of.head<3>() - expected.head<3>()).norm() < 1e-7 * 120e3);
      CHECK((of.tail<3>() - expected.tail<3>()).norm() < 1e-7 * 120e3 * L);
    }
  }
  // It is of second order, and twisted.
  CHECK(std::abs(cuts_at(straight.diagram(), 0.0)[5]) >
        1.01 * std::abs(cuts_at(straight.straight(), 0.0)[5]));
}

TEST_CASE("the model that is chosen bends in space where that counts, and says by how much",
          "[second_order]") {
  const Bent any(cantilever({0.0, 0.0, 1.0}));
  const double EI = E * properties_of(any.section()).I_z.value(),
               GA = G * shear_areas_of(any.section()).y.value();
  const double P = 0.3 * std::pow(pi / (2.0 * L), 2) * EI, Q = 1.5e3;
  const double k = wave_number(P, EI, GA), grown = std::tan(k * L) / (k * L * (1.0 - P / GA));
  const Verification of = verify(parse_project(
      "bent.toml", cantilever({-P, Q, 0.0}, "arm", Vector3d::Zero(),
                              "[deflection]\nlimit = \"100 mm\"\nagainst = \"tangent\"\nat = \"0 "
                              "m\"\n")));
  CHECK(of.model.chosen.level == ModelLevel::quasi_static);
  CHECK(of.model.counts_second_order);
  const SecondOrderEstimate& second = of.model.second_order;
  REQUIRE(second.change);
  const SectionProperties properties = properties_of(any.section());
  const double bending = Q * L / properties.W_z.value(), axial = P / properties.area.value();
  CHECK(*second.change ==
        Approx((grown - 1.0) * bending / (axial + grown * bending)).epsilon(1e-3));
  CHECK(of.model.reason.find("second order is estimated to change it by") != std::string::npos);
  // What is run is the beam that is bent at each instant.
  const Bent once(cantilever({-P, Q, 0.0}));
  const std::deque<SituationRun> runs = run_situations(once.project, of.model.chosen);
  CHECK(cuts_at(runs.front().loads.diagram(3), 1.1)[5] ==
        Approx(cuts_at(once.diagram(), 1.1)[5]).epsilon(1e-9));
  // Deflection: Q (tan kL/(k (1 - P/GA)) - L)/P, Timoshenko and Gere, article 1.3.
  const auto found = std::find_if(of.checks.begin(), of.checks.end(), [](const CheckResult& one) {
    return one.check.criterion == Criterion::deflection;
  });
  REQUIRE(found != of.checks.end());
  CHECK(1.0 / found->check.safety_factor * 0.1 == Approx(Q * L / P * (grown - 1.0)).epsilon(1e-3));
  // Theory of the first order does not hold, and that of the second is known.
  for (const Gate& gate : of.gates)
    CHECK(gate.finding.find("theory of the first order") == std::string::npos);
  // As demanded rigid it stops.
  const Verification rigid =
      verify(parse_project("bent.toml", cantilever({-P, Q, 0.0}, "arm", Vector3d::Zero(),
                                                   "[model]\ndemand = \"rigid\"\n")));
  CHECK(test::blocks(rigid, "theory of the first order"));
}

}  // namespace second_order_in_space_test
