// Statics of the second order of mechanisms in space: closed forms of beam-columns, balance on the
// bent axis, the same mechanism in the plane, and elements of the test's own whose second order is
// that of exact rotations.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_area.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/model_gates.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "src/verification/bent_in_space.hpp"
#include "src/verification/elastic_motion_in_space.hpp"
#include "support/luffing_boom.hpp"

namespace second_order_in_space_test {

using namespace boxbeam;
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::luffing_in_plane;
using test::luffing_in_space;

namespace {

constexpr double pi = std::numbers::pi, E = 210e9, G = 81e9, L = 4.0;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

constexpr ElasticModel bent(int parts) { return {ModelLevel::quasi_static, 0, parts, {}, false}; }

std::string vector_text(const Vector3d& of) {
  return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", of.x(), of.y(), of.z());
}
std::string place_text(const Vector3d& of) {
  return fmt::format("[\"{:.17g} m\", \"{:.17g} m\", \"{:.17g} m\"]", of.x(), of.y(), of.z());
}

/// Of lasting direction.
std::string force_text(const std::string& name, const std::string& point, const Vector3d& force) {
  return fmt::format(
      "[forces.{}]\nkind = \"force\"\npoint = \"{}\"\ndirection = {}\nsize = \"{:.17g} N\"\n", name,
      point, vector_text(force.normalized()), force.norm());
}

const std::string sections = R"(
[sections.arm]
kind = "box"
width = "100 mm"
height = "150 mm"
flange = "8 mm"
web = "6 mm"
[sections.tip]
kind = "box"
width = "80 mm"
height = "90 mm"
flange = "8 mm"
web = "6 mm"
)";

const std::string demands = R"(
[material]
steel = "S355"
[strength]
required = 1.0
[motion]
duration = "1 s"
)";

std::string header(const Vector3d& gravity = Vector3d::Zero()) {
  return fmt::format(
      "[case]\nname = \"s\"\nkind = \"spatial\"\n[mechanism]\ngravity = [\"{:.17g} m/s^2\", "
      "\"{:.17g} m/s^2\", \"{:.17g} m/s^2\"]\n",
      gravity.x(), gravity.y(), gravity.z());
}

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

/// The six cut forces.
Vector6 cuts_at(const CutForceDiagram& diagram, double s, Side side = Side::both) {
  const CutForces cut = diagram.at({si<Length>(s), side});
  Vector6 of;
  of << cut.N.value(), cut.V_y.value(), cut.V_z.value(), cut.T.value(), cut.M_y.value(),
      cut.M_z.value();
  return of;
}

/// A case with its rigid bodies, and bent at its first instant.
struct Bent {
  Project project;
  std::deque<SituationRun> rigid;
  int parts;

  explicit Bent(Project of, int divided = 16)
      : project(std::move(of)), rigid(run_situations(project)), parts(divided) {}
  explicit Bent(const std::string& text, int divided = 16)
      : Bent(parse_project("bent.toml", text), divided) {}
  Bent(const Bent&) = delete;

  const Section& section() const { return project.beam.segments.front().from; }
  Time time() const { return rigid.front().loads.time_of(0); }
  CutForceDiagram straight() const { return rigid.front().loads.diagram(0); }
  frame::BentScene scene(double factor = 1.0) const {
    const spatial::Chain& chain = chain_of(rigid.front());
    return BentInSpace(project, chain, parts)
        .at(chain.at(time().value()), straight(), factor)
        .value();
  }
  CutForceDiagram diagram() const {
    if (std::holds_alternative<planar::Mechanism>(project.mechanism))
      return run_situations(project, bent(parts)).front().loads.diagram(0);
    const frame::BentScene of = scene();
    REQUIRE_FALSE(of.critical);
    BeamLoads loads = rigid.front().loads.loads_at(time());
    add_bending(of.loads, loads);
    return cut_forces_of(loads);
  }
};

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
  CHECK_THROWS_AS(run_situations(buckling, bent(16)), AnalysisError);
  const Verification of = verify(parse_project("bent.toml", cantilever({-1.02 * N_cr, 1.0, 0.0})));
  CHECK(of.model.second_order.across->part == Approx(1.02).epsilon(3e-3));
  CHECK(std::any_of(of.gates.begin(), of.gates.end(), [](const Gate& gate) {
    return gate.blocks && gate.finding.find("it buckles") != std::string::npos;
  }));
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
  CHECK(std::any_of(rigid.gates.begin(), rigid.gates.end(), [](const Gate& gate) {
    return gate.blocks && gate.finding.find("theory of the first order") != std::string::npos;
  }));
}

namespace {

Matrix3d cross(const Vector3d& v) {
  Matrix3d m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

Matrix3d turned(const Vector3d& theta) {
  const double angle = theta.norm();
  if (angle == 0.0) return Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, theta / angle).toRotationMatrix();
}

Vector3d turn_of(const Matrix3d& R) {
  const Eigen::AngleAxisd of(R);
  return of.angle() * of.axis();
}

/// Elements of the test's own: two nodes with shifts and exact turns, strained as a whole by what
/// the second node is moved and turned, seen from axes half between those of both. `h`: along x.
struct Element {
  static Vector6 strain(const Vector12& q, double h) {
    const Matrix3d R_1 = turned(q.segment<3>(3)), R_2 = turned(q.segment<3>(9));
    const Vector3d between = turn_of(R_1.transpose() * R_2);
    const Matrix3d middle = R_1 * turned(0.5 * between);
    Vector6 of;
    of.head<3>() =
        middle.transpose() * Vector3d(h * Vector3d::UnitX() + q.segment<3>(6) - q.head<3>()) -
        h * Vector3d::UnitX();
    of.tail<3>() = between;
    return of;
  }

  /// Second derivative of the work of cut forces, by differences of the exact strains.
  static Matrix12 stress(const Vector6& cut, double h) {
    constexpr double d = 2e-4;
    Matrix12 of;
    const auto work = [&](Index i, double a, Index j, double b) {
      Vector12 q = Vector12::Zero();
      q[i] += a;
      q[j] += b;
      return cut.dot(strain(q, h));
    };
    for (Index i = 0; i < 12; ++i)
      for (Index j = 0; j <= i; ++j)
        of(i, j) = of(j, i) =
            (work(i, d, j, d) - work(i, d, j, -d) - work(i, -d, j, d) + work(i, -d, j, -d)) /
            (4.0 * d * d);
    return of;
  }

  /// First derivative of the strains.
  static Eigen::Matrix<double, 6, 12> rates(double h) {
    Eigen::Matrix<double, 6, 12> of = Eigen::Matrix<double, 6, 12>::Zero();
    of.leftCols<6>() = -Eigen::Matrix<double, 6, 6>::Identity();
    of.rightCols<6>() = Eigen::Matrix<double, 6, 6>::Identity();
    // The vector between both nodes, seen from axes that turn by the mean.
    of.block<3, 3>(0, 3) = of.block<3, 3>(0, 9) = 0.5 * cross(h * Vector3d::UnitX());
    return of;
  }
};

/// A beam in a frame, its axes and where its nodes are.
struct OwnBeam {
  Section section;
  Vector3d start;
  Matrix3d axes;
  double length = 0.0;
};

/// A dead force on the end of a beam, beside its axis.
struct OwnForce {
  int beam = 0;
  Vector3d arm, force;  // world
};

/// Beams one after the other, joined rigidly, the first clamped.
struct Chained {
  std::vector<OwnBeam> beams;
  std::vector<OwnForce> forces;

  /// Moments that second order adds at the starts of the beams, in the axes of each: T, M_y, M_z.
  std::vector<Vector3d> added(int n) const {
    const auto per_beam = static_cast<Index>(n);
    const auto count = static_cast<Index>(beams.size());
    const Index size = 6 * per_beam * count;  // the first node is fixed
    std::vector<Eigen::Triplet<double>> entries;
    VectorXd strained = VectorXd::Zero(size);
    const auto put = [&](Index row, Index column, const MatrixXd& block) {
      for (Index i = 0; i < block.rows(); ++i)
        for (Index j = 0; j < block.cols(); ++j)
          if (row + i >= 0 && column + j >= 0)
            entries.emplace_back(row + i, column + j, block(i, j));
    };
    struct Solved {
      Matrix12 K, K_g, into;
      Vector12 f;
      Vector3d moment;
    };
    std::vector<Solved> firsts;
    for (Index b = 0; b < count; ++b) {
      const OwnBeam& of = beams[static_cast<std::size_t>(b)];
      const double h = of.length / n;
      const SectionProperties properties = properties_of(of.section);
      const ShearAreas shear = shear_areas_of(of.section);
      Vector6 stiff;
      // Stretching, which theory of the second order leaves out, is held.
      constexpr double far_stiffer = 1e3;
      stiff << far_stiffer * E * properties.area.value(), G * shear.y.value(), G * shear.z.value(),
          G * torsion_properties_of(of.section).I_T->value(), E * properties.I_y.value(),
          E * properties.I_z.value();
      const auto rates = Element::rates(h);
      const Matrix12 K = rates.transpose() * (stiff / h).asDiagonal() * rates;
      std::array<Matrix12, 6> stress;
      for (Index c = 0; c < 6; ++c)
        stress[static_cast<std::size_t>(c)] = Element::stress(Vector6::Unit(c), h);
      Matrix12 into = Matrix12::Zero();
      for (Index k = 0; k < 4; ++k) into.block<3, 3>(3 * k, 3 * k) = of.axes.transpose();
      for (Index e = 0; e < per_beam; ++e) {
        const Vector3d middle = of.start + (static_cast<double>(e) + 0.5) * h * of.axes.col(0);
        const Vector6 cut = cut_at(static_cast<int>(b), middle);
        Matrix12 K_g = Matrix12::Zero();
        for (Index c = 0; c < 6; ++c) K_g += cut[c] * stress[static_cast<std::size_t>(c)];
        // Shear forces stand across the axis that bends, not across sections (Engesser's column).
        K_g += cut[0] / h * rates.middleRows<2>(1).transpose() * rates.middleRows<2>(1);
        const Index row = 6 * (b * per_beam + e - 1);
        put(row, row, into.transpose() * (K + K_g) * into);
        const Vector12 f = rates.transpose() * cut;
        const Vector12 world = into.transpose() * f;
        for (Index i = 0; i < 12; ++i)
          if (row + i >= 0) strained[row + i] += world[i];
        if (e == 0)
          firsts.push_back({K, K_g, into, f, cut_at(static_cast<int>(b), of.start).tail<3>()});
      }
    }
    for (const OwnForce& force : forces) {
      const Index row = 6 * ((force.beam + 1) * per_beam - 1) + 3;
      // -F . exp(theta) a, twice derived: theta^2 F . a - F . theta a . theta.
      put(row, row,
          force.force.dot(force.arm) * Matrix3d::Identity() -
              0.5 * (force.force * force.arm.transpose() + force.arm * force.force.transpose()));
    }
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    REQUIRE(solver.info() == Eigen::Success);
    REQUIRE((solver.vectorD().array() > 0.0).all());
    const VectorXd motion = solver.solve(strained);
    std::vector<Vector3d> moments;
    for (Index b = 0; b < count; ++b) {
      const Solved& first = firsts[static_cast<std::size_t>(b)];
      Vector12 ends = Vector12::Zero();
      const Index row = 6 * (b * per_beam - 1);
      for (Index i = 0; i < 12; ++i)
        if (row + i >= 0) ends[i] = motion[row + i];
      ends = (first.into * ends).eval();
      const Vector12 added = (first.K + first.K_g) * ends - first.f;
      // Against the rigid beam the end forces of its first element are those of its cut forces.
      Vector3d moment = -added.segment<3>(3) - first.moment + first.moment;
      // In turned axes: half a turn more than vectors of turn have.
      moment -= 0.5 * Vector3d(ends.segment<3>(3)).cross(first.moment);
      moments.push_back(moment);
    }
    return moments;
  }

  /// Cut forces of the rigid chain in a beam's axes, of the forces beyond.
  Vector6 cut_at(int beam, const Vector3d& place) const {
    Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
    for (const OwnForce& of : forces) {
      if (of.beam < beam) continue;
      const OwnBeam& on = beams[static_cast<std::size_t>(of.beam)];
      const Vector3d at = on.start + on.length * on.axes.col(0) + of.arm;
      force += of.force;
      moment += (at - place).cross(of.force);
    }
    const Matrix3d& axes = beams[static_cast<std::size_t>(beam)].axes;
    Vector6 cut;
    cut << axes.transpose() * force, axes.transpose() * moment;
    return cut;
  }

  /// Towards endlessly many elements (Richardson).
  std::vector<Vector3d> limit(int n) const {
    std::vector<Vector3d> coarse = added(n), fine = added(2 * n);
    for (std::size_t b = 0; b < fine.size(); ++b) fine[b] += (fine[b] - coarse[b]) / 3.0;
    return fine;
  }
};

struct L_case {
  double first = 3.0, second = 2.0;
  double about_z = 0.0, about_y = -90.0;  // how the second stands on the first [degrees]
  Vector3d force = Vector3d(-4e3, 3e3, -40e3), beside = Vector3d::Zero(), arm = Vector3d::Zero();
  std::string sections = second_order_in_space_test::sections;

  std::string text() const {
    std::string of = header();
    of += fmt::format(
        "[bodies.inner]\npoints = {{ A = [\"0 m\", \"0 m\", \"0 m\"], B = [\"{0:.17g} m\", \"0 "
        "m\", "
        "\"0 m\"] }}\n[bodies.outer]\npoints = {{ A = [\"0 m\", \"0 m\", \"0 m\"], B = [\"{1:.17g} "
        "m\", \"0 m\", \"0 m\"], C = {2} }}\n",
        first, second, place_text(Vector3d(second, 0.0, 0.0) + arm));
    of += fmt::format(
        "[joints.heel]\nkind = \"fixed\"\nconnect = [\"ground\", \"inner.A\"]\nat = [\"0 m\", \"0 "
        "m\", \"0 m\"]\n[joints.knee]\nkind = \"fixed\"\nconnect = [\"inner.B\", "
        "\"outer.A\"]\nturn = [[\"z\", \"{:.17g} deg\"], [\"y\", \"{:.17g} deg\"]]\n",
        about_z, about_y);
    of += force_text("push", "outer.B", force);
    if (beside.norm() > 0.0) of += force_text("pull", "outer.C", beside);
    const auto beam = [&](const char* name, double length, const char* section) {
      return fmt::format(
          "[[beam]]\nname = \"{0}\"\nbody = \"{0}\"\nstart = \"A\"\naxis = \"x\"\nz = "
          "\"z\"\ndensity = \"1e-3 kg/m^3\"\n[[beam.segments]]\nlength = \"{1:.17g} m\"\nsection = "
          "\"{2}\"\n",
          name, length, section);
    };
    return of + sections + beam("inner", first, "arm") + beam("outer", second, "tip") + demands;
  }

  Chained own(const Section& inner, const Section& outer) const {
    const Matrix3d R = (Eigen::AngleAxisd(about_z * pi / 180.0, Vector3d::UnitZ()) *
                        Eigen::AngleAxisd(about_y * pi / 180.0, Vector3d::UnitY()))
                           .toRotationMatrix();
    Chained of;
    of.beams = {{inner, Vector3d::Zero(), Matrix3d::Identity(), first},
                {outer, Vector3d(first, 0.0, 0.0), R, second}};
    of.forces = {{1, Vector3d::Zero(), force}};
    if (beside.norm() > 0.0) of.forces.push_back({1, R * arm, beside});
    return of;
  }

  /// The largest moment that second order adds by the elements, and how far the program is off.
  std::pair<double, double> compared(int n, int parts) const {
    const std::vector<Project> projects = parse_beams("L.toml", text());
    REQUIRE(projects.size() == 2);
    const Chained chained =
        own(projects[0].beam.segments.front().from, projects[1].beam.segments.front().from);
    const std::vector<Vector3d> expected = chained.limit(n);
    double largest = 0.0, wrong = 0.0;
    for (std::size_t b = 0; b < 2; ++b) {
      const Bent of(projects[b], parts);
      const Vector6 found =
          cuts_at(of.diagram(), 0.0, Side::behind) - cuts_at(of.straight(), 0.0, Side::behind);
      largest = std::max(largest, expected[b].norm());
      wrong = std::max(wrong, (found.tail<3>() - expected[b]).norm());
      CAPTURE(b, expected[b].transpose(), found.tail<3>().transpose());
    }
    return {largest, wrong};
  }
};

}  // namespace

TEST_CASE("an L of two beams bends as elements with exact turns do", "[second_order]") {
  for (const bool beside : {false, true}) {
    L_case of;
    if (beside) {
      of.beside = {6e3, -2e3, -8e3};
      of.arm = {0.0, 0.35, -0.2};
    }
    const auto [largest, wrong] = of.compared(20, 32);
    CAPTURE(beside, largest, wrong);
    CHECK(largest > 300.0);
    CHECK(wrong < 3e-5 * largest);
  }
}

TEST_CASE("any L of two beams bends as elements with exact turns do", "[second_order]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 engine(seed);
    const auto between = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
    };
    L_case of;
    of.first = between(1.5, 4.0);
    of.second = between(1.0, 3.0);
    of.about_z = between(-170.0, 170.0);
    of.about_y = between(-80.0, 80.0);
    const auto any = [&](double size) {
      return Vector3d(between(-size, size), between(-size, size), between(-size, size));
    };
    of.force = any(25e3);
    of.beside = any(8e3);
    of.arm = {0.0, between(-0.4, 0.4), between(-0.4, 0.4)};
    CAPTURE(seed);
    const auto [largest, wrong] = of.compared(20, 32);
    CAPTURE(largest, wrong);
    CHECK(wrong < 3e-5 * largest);
  }
}

namespace {

/// Four-bars in a row, so many: the first crank is driven and is the beam.
std::string four_bars(int count) {
  const std::string rod =
      "mass = \"300 kg\"\nuniform_rod = [\"O\", \"A\"]\n"
      "points = { O = [\"0 m\", \"0 m\", \"0 m\"], A = [\"1 m\", \"0 m\", \"0 m\"] }\n";
  std::string text = header({0.0, 0.0, -9.81}) + sections + R"(
[drivers.motor]
joint = "crank-0"
kind = "harmonic"
mean = "0 deg"
amplitude = "10 deg"
frequency = "0.7 Hz"
[bodies.lever]
points = { O = ["0 m", "0 m", "0 m"], A = ["1 m", "0 m", "0 m"] }
[beam]
body = "lever"
start = "O"
axis = "x"
z = "z"
density = "7850 kg/m^3"
[[beam.segments]]
length = "1 m"
section = "arm"
)";
  for (int i = 0; i <= count; ++i) {
    const std::string crank = i == 0 ? "lever" : fmt::format("rod-{}", i);
    if (i > 0) text += fmt::format("[bodies.{}]\n{}", crank, rod);
    text += fmt::format(
        "[joints.crank-{}]\nkind = \"revolute\"\nconnect = [\"ground\", \"{}.O\"]\nat = [\"{} m\", "
        "\"0 m\", \"0 m\"]\nturn = [\"y\", \"-90 deg\"]\naxis = [{}, 1, 0]\n",
        i, crank, i, i % 2 == 0 ? 0.1 : -0.1);
    if (i == 0) continue;
    text += fmt::format("[bodies.coupler-{}]\n{}", i, rod);
    text += fmt::format(
        "[joints.left-{0}]\nkind = \"universal\"\nconnect = [\"{1}.A\", \"coupler-{0}.O\"]\nturn = "
        "[\"y\", \"90 deg\"]\naxis = \"y\"\nsecond_axis = \"z\"\n[joints.right-{0}]\nkind = "
        "\"spherical\"\ncloses = true\nconnect = [\"coupler-{0}.A\", \"{2}.A\"]\n",
        i, i == 1 ? "lever" : fmt::format("rod-{}", i - 1), crank);
  }
  return text + "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n";
}

}  // namespace

// Independent computation: the ties of every posture eliminated by themselves.
TEST_CASE("the order of ties that is kept from posture to posture changes no bending",
          "[second_order]") {
  const Bent of(four_bars(40));
  const spatial::Chain& chain = chain_of(of.rigid.front());
  const LoadHistory& loads = of.rigid.front().loads;
  BentInSpace kept(of.project, chain);
  for (const std::size_t part : {0, 1, 3, 2, 4}) {
    const Time time = loads.time_of(part * (loads.instants() - 1) / 4);
    CAPTURE(time.value());
    const auto bent_by = [&](BentInSpace& in) {
      return in.at(chain.at(time.value()), cut_forces_of(loads.loads_at(time)), 1.0).value();
    };
    BentInSpace once(of.project, chain);
    const frame::BentScene found = bent_by(kept), anew = bent_by(once);
    REQUIRE_FALSE(anew.critical);
    REQUIRE_FALSE(found.critical);
    CHECK(anew.turn > 1e-6);
    CHECK(found.turn == Approx(anew.turn).epsilon(1e-8));
    const double largest = anew.motion.cwiseAbs().maxCoeff();
    CHECK((found.motion - anew.motion).cwiseAbs().maxCoeff() < 1e-8 * largest);
    const Vector6 cut = cuts_at(cut_forces_of(anew.loads), 0.3);
    CHECK((cuts_at(cut_forces_of(found.loads), 0.3) - cut).norm() < 1e-7 * cut.norm());
  }
}

}  // namespace second_order_in_space_test
