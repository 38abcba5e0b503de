// Mechanisms in space as a case writes them. Expected numbers are those of the text, and hand
// formulas of rods and turns.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "project/small_chain.hpp"
#include "support/program.hpp"

namespace read_chain_test {

using namespace boxbeam;
using namespace small_chain;
using Eigen::Matrix3d;
using Eigen::Vector3d;

TEST_CASE("bodies and joints in any order become a tree, parents first") {
  const Project project = read(weld + hinge + swing);
  const spatial::Mechanism& mechanism = spatial_of(project);
  REQUIRE(mechanism.bodies.size() == 2);
  CHECK(mechanism.bodies[0].name == "arm");
  CHECK(mechanism.bodies[1].name == "load");
  CHECK(mechanism.joints[0].name == "hinge");
  CHECK(mechanism.joints[0].parent == spatial::ground);
  CHECK(mechanism.joints[1].parent == 0);
  CHECK(mechanism.joints[1].at == Vector3d(1, 0, 0));
  CHECK(mechanism.gravity == Vector3d(0, 0, -10));
  CHECK(mechanism.bodies[1].centre == Vector3d(0, 0, 0.1));
  CHECK(mechanism.bodies[1].inertia == Matrix3d(Vector3d(1, 2, 2.5).asDiagonal()));
  CHECK(project.beam_body == 0);
}

TEST_CASE("the beam's body has the beam's mass properties, a thin tube's by hand") {
  const Project project = read(weld + hinge + swing);
  const spatial::Body& arm = spatial_of(project).bodies[0];
  const double area = std::numbers::pi / 4.0 * (0.1 * 0.1 - 0.09 * 0.09);
  const double mass = 7850.0 * area;
  CHECK(arm.mass == Approx(mass).epsilon(1e-5));  // the round is a polygon of many sides
  CHECK((arm.centre - Vector3d(0.5, 0, 0)).norm() < 1e-12);
  CHECK(arm.inertia(1, 1) == Approx(mass / 12.0).epsilon(1e-5));
  CHECK(arm.inertia(2, 2) == Approx(mass / 12.0).epsilon(1e-5));
  CHECK(arm.inertia(0, 0) == 0.0);
  const double I = std::numbers::pi / 64.0 * (std::pow(0.1, 4) - std::pow(0.09, 4));
  const Project counted =
      parse_project("small.toml", bodies + weld + hinge + swing, {"beam.rotary_inertia=true"});
  const Matrix3d& inertia = spatial_of(counted).bodies[0].inertia;
  CHECK(inertia(0, 0) == Approx(7850.0 * 2.0 * I).epsilon(1e-4));
  CHECK(inertia(1, 1) == Approx(mass / 12.0 + 7850.0 * I).epsilon(1e-5));
}

TEST_CASE("axis and turn of a joint are in the axes of the body that it carries") {
  const Project project =
      read(heel("revolute") +
           "at = [\"1 m\", \"2 m\", \"3 m\"]\nturn = [[\"x\", \"90 deg\"], [\"z\", \"30 deg\"]]\n"
           "axis = [0, 3, 4]\n" +
           swing + weld);
  const spatial::Joint& hinge_joint = joint(project, "hinge");
  // First about x, then about the turned z: R = Rx(90) Rz(30), written out.
  const double c = std::cos(std::numbers::pi / 6), s = 0.5;
  Matrix3d turn;
  turn << c, -s, 0, 0, 0, -1, s, c, 0;
  CHECK((hinge_joint.turn - turn).norm() < 1e-15);
  CHECK((hinge_joint.axis - turn * Vector3d(0, 0.6, 0.8)).norm() < 1e-15);
  CHECK(hinge_joint.at == Vector3d(1, 2, 3));
  const Project one = read(
      "[joints.hinge]\nkind = \"prismatic\"\nconnect = [\"ground\", \"arm.B\"]\n"
      "turn = [\"z\", \"90 deg\"]\naxis = \"-x\"\n"
      "[drivers.push]\njoint = \"hinge\"\nkind = \"smooth step\"\nfrom = \"0 m\"\nto = \"1 m\"\n"
      "end = \"2 s\"\n" +
      weld);
  CHECK((joint(one, "hinge").axis - Vector3d(0, -1, 0)).norm() < 1e-15);
  CHECK(joint(one, "hinge").point == Vector3d(1, 0, 0));
}

TEST_CASE("a joint's driver is called as the case calls it") {
  const Project project = read_project(test::project_file("sections/landing-gear/retraction.toml"));
  CHECK(spatial::driver_text(joint(project, "hinge")) == "retraction (joint hinge)");
  CHECK(spatial::driver_text(joint(project, "yaw")) == "yawing (joint yaw)");
  CHECK(spatial::driver_text(joint(project, "foot")) == "foot");
}

TEST_CASE("a spherical joint is three revolutes through one point") {
  const std::string drivers = [] {
    std::string lines;
    for (const char* k : {"1", "2", "3"}) {
      lines += std::string("[drivers.d") + k + "]\njoint = \"ball." + k +
               "\"\nkind = \"hold\"\nvalue = \"" + k + "0 deg\"\n";
    }
    return lines;
  }();
  const Project project =
      read(hinge + swing +
           "[joints.ball]\nkind = \"spherical\"\nconnect = [\"arm.B\", \"load.D\"]\n"
           "axes = [\"z\", \"x\", \"z\"]\nturn = [\"y\", \"90 deg\"]\n" +
           drivers);
  REQUIRE(spatial_of(project).bodies.size() == 4);
  const spatial::State state = spatial::Chain(spatial_of(project)).at(0.0);
  const auto load = static_cast<std::size_t>(body_index(spatial_of(project), "load"));
  const auto about = [](const Vector3d& axis, double degrees) {
    return Matrix3d(Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis));
  };
  const Matrix3d expected = about(Vector3d::UnitY(), 90.0) * about(Vector3d::UnitZ(), 10.0) *
                            about(Vector3d::UnitX(), 20.0) * about(Vector3d::UnitZ(), 30.0);
  CHECK((state.bodies[load].R_WB - expected).norm() < 1e-14);
  CHECK((position_of(state, {static_cast<int>(load), {0, 2, 0}}) - Vector3d(1, 0, 0)).norm() <
        1e-14);
}

TEST_CASE("a rod between two points has its mass in the middle and m L^2/12 across") {
  const std::string rod =
      "[bodies.rod]\nmass = \"12 kg\"\nuniform_rod = [\"P\", \"Q\"]\n"
      "points = { P = [\"1 m\", \"0 m\", \"0 m\"], Q = [\"1 m\", \"0 m\", \"2 m\"] }\n"
      "[joints.rod]\nkind = \"fixed\"\nconnect = [\"arm.B\", \"rod.P\"]\n";
  const Project project = read(hinge + swing + weld + rod);
  const spatial::Mechanism& mechanism = spatial_of(project);
  const spatial::Body& body =
      mechanism.bodies[static_cast<std::size_t>(body_index(mechanism, "rod"))];
  CHECK(body.centre == Vector3d(1, 0, 1));
  CHECK((body.inertia - Matrix3d(Vector3d(4, 4, 0).asDiagonal())).norm() < 1e-14);
}

TEST_CASE("the beam lies in its body from its start along its axis; y completes") {
  const std::string text = bodies + weld + hinge + swing;
  std::string along_minus_z = text;
  const std::string axes = "axis = \"x\"\nz = \"z\"\n";
  along_minus_z.replace(along_minus_z.find(axes), axes.size(),
                        "start = \"side\"\naxis = \"-z\"\nz = \"x\"\n");
  const Project project = parse_project("small.toml", along_minus_z);
  const spatial::BeamPlacement& at = project.placement;
  CHECK(at.start == Vector3d(0.5, 0, 0.2));
  CHECK(at.axes.col(0) == Vector3d(0, 0, -1));
  CHECK(at.axes.col(2) == Vector3d(1, 0, 0));
  CHECK(at.axes.col(1) == Vector3d(0, 1, 0));
  // The body's points are places of the beam where they stand over its axis: A, B and far, in the
  // plane z = 0, 0.2 m behind "side".
  REQUIRE(project.beam.points.size() == 4);
  for (const BeamPoint& point : project.beam.points) {
    CAPTURE(point.name);
    CHECK(point.s.value() == Approx(point.name == "side" ? 0.0 : 0.2).margin(1e-15));
  }
  // Along x from A, 1 m long: "side" stands over its middle, "far" beyond its end.
  const auto points = read(weld + hinge + swing).beam.points;
  REQUIRE(points.size() == 3);
  CHECK(points[2].name == "side");
  CHECK(points[2].s == 0.5 * metre);
}

TEST_CASE("loads: where, on what, in whose axes") {
  const Project project =
      read(weld + hinge + swing +
           "[forces.push]\nkind = \"force\"\npoint = \"arm.side\"\non = \"load\"\naxes = \"arm\"\n"
           "direction = \"-z\"\nsize = \"5 kN\"\n"
           "[forces.twist]\nkind = \"couple\"\npoint = \"load.C\"\ndirection = [1, 1, 0]\n"
           "law = { kind = \"harmonic\", mean = \"0 N m\", amplitude = \"7 N m\", frequency = "
           "\"1 Hz\" }\n"
           "[forces.wind]\nkind = \"line force\"\nfrom = \"arm.B\"\nto = \"arm.A\"\n"
           "direction = \"y\"\nsize = \"250 N/m\"\n");
  const spatial::Mechanism& mechanism = spatial_of(project);
  REQUIRE(mechanism.loads.size() == 2);
  const spatial::AppliedLoad& push = mechanism.loads[0];
  CHECK(push.on == body_index(mechanism, "load"));
  CHECK(push.at.body == body_index(mechanism, "arm"));
  CHECK(push.axes == body_index(mechanism, "arm"));
  CHECK(push.direction == Vector3d(0, 0, -1));
  CHECK(driver_at(push.size, 0.3).value == 5e3);
  const spatial::AppliedLoad& twist = mechanism.loads[1];
  CHECK(twist.kind == spatial::LoadKind::couple);
  CHECK(twist.on == twist.at.body);
  CHECK(twist.axes == spatial::ground);
  CHECK(twist.direction.norm() == Approx(1.0).epsilon(1e-15));
  REQUIRE(mechanism.line_forces.size() == 1);
  CHECK(driver_at(mechanism.line_forces[0].size, 0.0).value == 250.0);
}

TEST_CASE("a situation may change turns, loads and the kind of a driver") {
  const std::string situations =
      "[[situations]]\nname = \"swinging\"\ncycles = 1e6\n"
      "[[situations]]\nname = \"parked\"\n[situations.set]\n"
      "\"drivers.swing.kind\" = \"hold\"\n\"drivers.swing.value\" = \"90 deg\"\n"
      "\"motion.duration\" = \"1 s\"\n\"joints.hinge.turn\" = [\"z\", \"180 deg\"]\n";
  std::string text = bodies + hinge + weld + swing + situations;
  const std::string cycles = "cycles = 1e6\nloading";
  text.replace(text.find(cycles), cycles.size(), "loading");
  const Project project = parse_project("small.toml", text);
  const spatial::Mechanism& parked = spatial_in(project, project.situations[1]);
  CHECK(driver_at(parked.joints[0].driver, 0.4).value == Approx(0.5 * std::numbers::pi));
  CHECK(driver_at(parked.joints[0].driver, 0.4).rate == 0.0);
  CHECK((parked.joints[0].turn.col(0) - Vector3d(-1, 0, 0)).norm() < 1e-15);
  CHECK(parked.bodies[0].mass == spatial_of(project).bodies[0].mass);
  CHECK(parked.bodies[0].mass > 0.0);
}

TEST_CASE("hand formulas are evaluated with their symbols in SI units") {
  const Project project =
      read(weld + hinge + swing +
           "[hand_symbols]\nL = \"1000 mm\"\nw = \"60 rpm\"\nn = 2\n"
           "[[hand_formulas]]\nname = \"v\"\nquantity = \"velocity\"\nof = \"load.C\"\n"
           "time = \"0.25 s\"\nformula = [\"L*w^2\", \"sqrt(n)*cos(0)\", \"-L/4\"]\n");
  REQUIRE(project.hand_formulas.size() == 1);
  const HandFormula& hand = project.hand_formulas.front();
  const double w = 2.0 * std::numbers::pi;
  CHECK((hand.value - Vector3d(w * w, std::sqrt(2.0), -0.25)).norm() < 1e-12);
  CHECK(hand.time.value() == 0.25);
  CHECK(hand.point.body == body_index(spatial_of(project), "load"));
}

TEST_CASE("joints say what forces move, from where and how fast") {
  const std::string rest = weld + "[motion]\nduration = \"1 s\"\n";
  const Project project =
      read(heel("revolute") +
           "axis = \"y\"\n"
           "moved_by = \"forces\"\nstart = \"90 deg\"\nstart_rate = \"60 rpm\"\n" +
           rest);
  CHECK(joint(project, "hinge").moved_by == spatial::MovedBy::forces);
  CHECK(joint(project, "hinge").start == Approx(0.5 * std::acos(-1.0)));
  CHECK(joint(project, "hinge").start_rate == Approx(2.0 * std::acos(-1.0)));
  // Of several movements a driver may move one.
  const Project screw =
      read(heel("cylindrical") +
           "axis = \"y\"\n"
           "moved_by = \"forces\"\nstart_shift = [\"0.1 m\"]\nstart_shift_rate = [\"2 m/s\"]\n"
           "[drivers.a]\njoint = \"hinge.1\"\nkind = \"hold\"\nvalue = \"0 deg\"\n" +
           rest);
  CHECK(joint(screw, "hinge.1").moved_by == spatial::MovedBy::driver);
  CHECK(joint(screw, "hinge.2").moved_by == spatial::MovedBy::forces);
  CHECK(joint(screw, "hinge.2").start_rate == Approx(2.0));
}

TEST_CASE("a torsion spring in space turns back the joint that it names") {
  const boxbeam::Project project =
      read(hinge + weld + swing +
           "[forces.bar]\nkind = \"torsion spring\"\njoint = \"hinge\"\n"
           "stiffness = \"2 kN m/rad\"\nfree_angle = \"90 deg\"\ndamping = \"3 N m s/rad\"\n");
  const auto& springs = spatial_of(project).torsion_springs;
  REQUIRE(springs.size() == 1);
  CHECK(springs[0].name == "bar");
  CHECK(spatial_of(project).joints[static_cast<std::size_t>(springs[0].joint)].name == "hinge");
  CHECK(springs[0].stiffness == Approx(2000.0));
  CHECK(springs[0].free_angle == Approx(0.5 * std::numbers::pi));
  CHECK(springs[0].damping == Approx(3.0));
}

}  // namespace read_chain_test
