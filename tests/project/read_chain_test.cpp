// Mechanisms in space as a case writes them. Expected numbers are those of the text, and hand
// formulas of rods and turns.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

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
  const Project project = read(
      "[joints.hinge]\nkind = \"revolute\"\nconnect = [\"ground\", \"arm.A\"]\n"
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

TEST_CASE("joints that close loops leave free what nothing drives, from near its start") {
  const std::string loop =
      "[joints.hinge]\nkind = \"revolute\"\nconnect = [\"ground\", \"arm.A\"]\naxis = \"y\"\n"
      "start = \"-20 deg\"\n"
      "[joints.cylinder]\nkind = \"distance\"\nconnect = [\"ground\", \"arm.side\"]\n"
      "at = [\"0 m\", \"0 m\", \"-1 m\"]\n"
      "[drivers.stroke]\njoint = \"cylinder\"\nkind = \"hold\"\nvalue = \"1.3 m\"\n"
      "[motion]\nduration = \"1 s\"\n" +
      weld;
  const Project project = read(loop);
  const spatial::Mechanism& mechanism = spatial_of(project);
  CHECK(joint(project, "hinge").moved_by == spatial::MovedBy::loops);
  CHECK(joint(project, "hinge").start == Approx(-std::acos(-1.0) / 9.0));
  REQUIRE(mechanism.closing.size() == 1);
  const spatial::ClosingJoint& cylinder = mechanism.closing.front();
  CHECK(cylinder.driver_name == "stroke");
  CHECK(cylinder.a.body == spatial::ground);
  CHECK(cylinder.b.body == body_index(mechanism, "arm"));
  // 0.5^2 + 0.2^2 + 1 + 2 (0.2 cos q - 0.5 sin q) = 1.3^2 with side at 0.5 along and 0.2 above.
  const double q = spatial::Chain(mechanism).at(0.0).coordinates[0].value;
  CHECK(0.2 * std::cos(q) - 0.5 * std::sin(q) == Approx(0.5 * (1.69 - 1.29)).epsilon(1e-12));

  // In series, the last of them carries the body; the first movement is that nearest to the ground.
  const Project series = read(
      "[joints.hinge]\nkind = \"cylindrical\"\nconnect = [\"ground\", \"arm.A\"]\naxis = \"y\"\n"
      "start = [\"10 deg\"]\nstart_shift = [\"0.1 m\"]\n" +
      weld +
      "[drivers.a]\njoint = \"hinge.1\"\nkind = \"hold\"\nvalue = \"0 deg\"\n"
      "[drivers.b]\njoint = \"hinge.2\"\nkind = \"hold\"\nvalue = \"0.1 m\"\n"
      "[motion]\nduration = \"1 s\"\n");
  CHECK(joint(series, "hinge.1").kind == spatial::JointKind::revolute);
  CHECK(joint(series, "hinge.2").kind == spatial::JointKind::prismatic);
  CHECK(joint(series, "hinge.2").start == Approx(0.1));
  CHECK(joint(series, "hinge.2").moved_by == spatial::MovedBy::driver);
}

TEST_CASE("joints say what forces move, from where and how fast") {
  const std::string rest = weld + "[motion]\nduration = \"1 s\"\n";
  const Project project = read(
      "[joints.hinge]\nkind = \"revolute\"\nconnect = [\"ground\", \"arm.A\"]\naxis = \"y\"\n"
      "moved_by = \"forces\"\nstart = \"90 deg\"\nstart_rate = \"60 rpm\"\n" +
      rest);
  CHECK(joint(project, "hinge").moved_by == spatial::MovedBy::forces);
  CHECK(joint(project, "hinge").start == Approx(0.5 * std::acos(-1.0)));
  CHECK(joint(project, "hinge").start_rate == Approx(2.0 * std::acos(-1.0)));
  // Of several movements a driver may move one.
  const Project screw = read(
      "[joints.hinge]\nkind = \"cylindrical\"\nconnect = [\"ground\", \"arm.A\"]\naxis = \"y\"\n"
      "moved_by = \"forces\"\nstart_shift = [\"0.1 m\"]\nstart_shift_rate = [\"2 m/s\"]\n"
      "[drivers.a]\njoint = \"hinge.1\"\nkind = \"hold\"\nvalue = \"0 deg\"\n" +
      rest);
  CHECK(joint(screw, "hinge.1").moved_by == spatial::MovedBy::driver);
  CHECK(joint(screw, "hinge.2").moved_by == spatial::MovedBy::forces);
  CHECK(joint(screw, "hinge.2").start_rate == Approx(2.0));
}

namespace {

/// Two wheels about y on the ground, 0.3 m apart along x, the first one the beam's joint.
const std::string two_wheels =
    hinge + weld +
    "[bodies.wheel]\npoints = { C = [\"0 m\", \"0 m\", \"0 m\"] }\n"
    "[joints.wheel]\nkind = \"revolute\"\nconnect = [\"ground\", \"wheel.C\"]\n"
    "at = [\"0.3 m\", \"0 m\", \"0 m\"]\naxis = \"y\"\n";
const std::string sledge =
    "[bodies.sledge]\npoints = { C = [\"0 m\", \"0 m\", \"0 m\"] }\n"
    "[joints.sledge]\nkind = \"prismatic\"\nconnect = [\"ground\", \"sledge.C\"]\n"
    "axis = \"x\"\n";
const std::string teeth = "[joints.teeth]\nkind = \"gear\"\n";

}  // namespace

TEST_CASE("loops in space say which assembly is meant, by places and a direction") {
  const std::string turn = "turn = [\"arm.A\", \"arm.B\", \"load.D\"]\n";
  const Project project =
      read(weld + hinge + swing + "[loops.over]\n" + turn +
           "direction = [0, 3, 4]\naxes = \"arm\"\nsign = \"-\"\n" +
           "[loops.side]\nalong = [\"arm.A\", \"load.C\"]\n" + "direction = \"x\"\nsign = \"+\"\n");
  const std::vector<spatial::Branch>& branches = spatial_of(project).branches;
  REQUIRE(branches.size() == 2);
  CHECK(branches[0].name == "over");
  REQUIRE(branches[0].via);
  CHECK(branches[0].via->p == Vector3d(1, 0, 0));
  CHECK(branches[0].to.body == 1);
  CHECK(branches[0].to.p == Vector3d(0, 2, 0));
  CHECK(branches[0].axes == 0);
  CHECK((branches[0].direction - Vector3d(0, 0.6, 0.8)).norm() < 1e-15);
  CHECK(branches[0].sign == -1);
  CHECK(!branches[1].via);
  CHECK(branches[1].axes == spatial::ground);
  CHECK(branches[1].sign == 1);

  const auto wrong = [&](const std::string& loop) {
    return problem_in(bodies + weld + hinge + swing + loop).message;
  };
  CHECK(wrong("[loops.over]\ndirection = \"x\"\nsign = \"+\"\n").find("either") !=
        std::string::npos);
  CHECK(wrong("[loops.over]\nturn = [\"arm.A\", \"arm.B\"]\ndirection = \"y\"\nsign = \"+\"\n")
            .find("3 points are wanted, not 2") != std::string::npos);
  CHECK(wrong("[loops.over]\n" + turn + "sign = \"+\"\n").find("direction") != std::string::npos);
  CHECK(wrong("[loops.loops]\n" + turn + "direction = \"y\"\nsign = \"+\"\n")
            .find("no loop is called") != std::string::npos);
}

TEST_CASE("a ball with clearance is a contact of two places and closes no loop") {
  const boxbeam::Project project = read(
      "[joints.hinge]\nkind = \"revolute\"\nconnect = [\"ground\", \"arm.A\"]\naxis = \"y\"\n"
      "moved_by = \"forces\"\n" +
      weld +
      "[joints.ball]\nkind = \"spherical\"\nconnect = [\"ground\", \"arm.B\"]\n"
      "at = [\"1 m\", \"0 m\", \"0 m\"]\ncloses = true\nclearance = \"0.2 mm\"\n"
      "contact_stiffness = \"100 kN/mm\"\nrestitution = 0.8\n[motion]\nduration = \"1 s\"\n");
  const spatial::Mechanism& mechanism = spatial_of(project);
  CHECK(mechanism.closing.empty());
  REQUIRE(mechanism.springs.size() == 1);
  const spatial::Spring& ball = mechanism.springs[0];
  CHECK(ball.name == "ball");
  CHECK(ball.clearance);
  CHECK(ball.acts == boxbeam::Acts::pulling);
  CHECK(ball.free_length == Approx(0.2e-3).epsilon(1e-14));
  CHECK(ball.stiffness == Approx(100e6).epsilon(1e-14));
  REQUIRE(ball.impact);
  CHECK(ball.impact->restitution == 0.8);
  CHECK(ball.a.body == spatial::ground);
  CHECK(mechanism.bodies[static_cast<std::size_t>(ball.b.body)].name == "arm");
}

TEST_CASE("screws carry bodies and close loops, right-handed by their lead") {
  const Project project = read(
      "[joints.hinge]\nkind = \"screw\"\nconnect = [\"ground\", \"arm.A\"]\naxis = \"x\"\n"
      "lead = \"5 mm\"\n[drivers.turn]\njoint = \"hinge\"\nkind = \"hold\"\n"
      "value = \"720 deg\"\n[motion]\nduration = \"1 s\"\n" +
      weld);
  CHECK(joint(project, "hinge").kind == spatial::JointKind::screw);
  CHECK(joint(project, "hinge").lead == Approx(0.005));
  // Two turns to the right advance it by two leads.
  const spatial::State state = spatial::Chain(spatial_of(project)).at(0.0);
  CHECK((state.bodies[0].position - Vector3d(0.01, 0, 0)).norm() < 1e-15);

  const Project closed =
      read(two_wheels + swing +
           "[joints.thread]\nkind = \"screw\"\nconnect = [\"arm.A\", \"wheel.C\"]\naxis = \"y\"\n"
           "lead = \"-20 mm\"\ncloses = true\n");
  const spatial::ClosingJoint& thread = spatial_of(closed).closing.front();
  CHECK(thread.kind == spatial::ClosingKind::screw);
  CHECK(thread.lead == Approx(-0.02));
}

TEST_CASE("gears and racks name the joints of their wheels, in any order of the file") {
  const Project project =
      read(teeth + "joints = [\"hinge\", \"wheel\"]\nratio = -0.5\noffset = \"30 deg\"\n" +
           two_wheels + swing);
  const spatial::Mechanism& mechanism = spatial_of(project);
  CHECK(joint(project, "wheel").moved_by == spatial::MovedBy::loops);
  const spatial::ClosingJoint& gear = mechanism.closing.front();
  CHECK(gear.kind == spatial::ClosingKind::gear);
  CHECK(gear.a.body == body_index(mechanism, "arm"));
  CHECK(gear.b.body == body_index(mechanism, "wheel"));
  // 0.3 m divided as 0.1 m and 0.2 m; standard teeth.
  CHECK(gear.mesh.at.body == spatial::ground);
  CHECK((gear.mesh.at.p - Vector3d(0.1, 0, 0)).norm() < 1e-15);
  CHECK(gear.mesh.apart.norm() == Approx(std::tan(std::numbers::pi / 9.0)));
  const spatial::State state = spatial::Chain(mechanism).at(0.1);
  const auto at = [&](const char* name) {
    return state.coordinates[static_cast<std::size_t>(joint_index(mechanism, name))].value;
  };
  CHECK(at("wheel") == Approx(-0.5 * at("hinge") + std::numbers::pi / 6.0));

  const Project rack =
      read(two_wheels + sledge + swing +
           "[drivers.wheel]\njoint = \"wheel\"\nkind = \"hold\"\nvalue = \"0 deg\"\n"
           "[joints.teeth]\nkind = \"rack\"\npinion = \"hinge\"\nrack = \"sledge\"\n"
           "radius = \"50 mm\"\noffset = \"10 mm\"\npressure_angle = \"0 deg\"\nmesh = \"ground\"\n"
           "at = [\"0 m\", \"0.2 m\", \"50 mm\"]\n");
  const spatial::ClosingJoint& below = spatial_of(rack).closing.front();
  CHECK(below.kind == spatial::ClosingKind::rack);
  // A turn about y moves what is above the axis along x.
  CHECK((below.mesh.at.p - Vector3d(0, 0.2, 0.05)).norm() < 1e-15);
  CHECK(below.mesh.apart.norm() == 0.0);
  const spatial::State moved = spatial::Chain(spatial_of(rack)).at(0.1);
  const auto i = static_cast<std::size_t>(joint_index(spatial_of(rack), "sledge"));
  const auto k = static_cast<std::size_t>(joint_index(spatial_of(rack), "hinge"));
  CHECK(moved.coordinates[i].value == Approx(0.05 * moved.coordinates[k].value + 0.01));
}

TEST_CASE("joints that slide say what rubs in them") {
  const std::string rest = weld + "[motion]\nduration = \"1 s\"\n";
  const auto rubbing = [&](const char* kind, const std::string& friction,
                           const std::string& driver) {
    return read("[joints.hinge]\nkind = \"" + std::string(kind) +
                "\"\nconnect = [\"ground\", \"arm.A\"]\naxis = \"y\"\nfriction = { " + friction +
                " }\n" + driver + rest);
  };
  const std::string ahead =
      "[drivers.a]\njoint = \"hinge\"\nkind = \"constant rate\"\nstart = \"0 m\"\nrate = "
      "\"0.3 m/s\"\n";
  const Friction all =
      joint(rubbing("prismatic",
                    "coefficient = 0.1, viscous = \"3 N s/m\", creep = \"4 mm/s\", guide_length "
                    "= \"0.2 m\"",
                    ahead),
            "hinge")
          .friction;
  CHECK(all.coulomb == 0.1);
  CHECK(all.viscous == 3.0);
  CHECK(all.creep == Approx(0.004));
  CHECK(all.guide == Approx(0.2));
  // A creep velocity that is not said is a fiftieth of the fastest.
  CHECK(joint(rubbing("prismatic", "coefficient = 0.1", ahead), "hinge").friction.creep ==
        Approx(0.006));
  // None where forces move it: it sticks.
  const std::string forced = "prismatic\"\nmoved_by = \"forces";
  const Friction sticks =
      joint(rubbing(forced.c_str(), "coefficient = 0.1, static_coefficient = 0.2", ""), "hinge")
          .friction;
  CHECK(sticks.creep == 0.0);
  CHECK(sticks.standing == 0.2);
  CHECK(joint(rubbing(forced.c_str(), "coefficient = 0.1, creep = \"4 mm/s\"", ""), "hinge")
            .friction.creep == Approx(0.004));
  // Of a cylindrical joint what slides in it.
  const Project screw = rubbing("cylindrical", "coefficient = 0.1",
                                "[drivers.a]\njoint = \"hinge.1\"\nkind = \"hold\"\nvalue = \"0 "
                                "deg\"\n[drivers.b]\njoint = \"hinge.2\"\nkind = \"constant "
                                "rate\"\nstart = \"0 m\"\nrate = \"0.1 m/s\"\n");
  CHECK_FALSE(rubs(joint(screw, "hinge.1").friction));
  CHECK(joint(screw, "hinge.2").friction.coulomb == 0.1);
  CHECK(joint(screw, "hinge.2").friction.creep == Approx(0.002));
  // What closes a loop.
  const Project closed =
      read(hinge + weld + swing +
           "[joints.slot]\nkind = \"slot\"\nconnect = [\"ground\", \"arm.B\"]\nat = [\"1 m\", \"0 "
           "m\", \"0 m\"]\naxis = \"x\"\nfriction = { viscous = \"2 N s/m\" }\n");
  CHECK(spatial_of(closed).closing.front().friction.viscous == 2.0);
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

TEST_CASE("what is wrong in a case in space is said with what to write", "[bad_input]") {
  struct Wrong {
    std::string lines, said, hint;
  };
  const std::string all = hinge + weld + swing;
  const Wrong wrongs[] = {
      {hinge + swing, "no joint carries body \"load\"", "connect"},
      {hinge + weld + swing +
           "[joints.again]\nkind = \"fixed\"\nconnect = [\"ground\", "
           "\"load.D\"]\n",
       "carried twice, by \"weld\" and by \"again\"", "closes = true"},
      {"[joints.hinge]\nkind = \"fixed\"\nconnect = [\"load.C\", \"arm.A\"]\n" + weld,
       "is carried by what it carries itself", "the tree begins at the ground"},
      {hinge + weld, "nothing drives joint \"hinge\"", "kind = \"hold\""},
      {hinge + "friction = { coefficient = 0.1 }\n" + weld + swing,
       "friction in a revolute joint is not computed", "what slides along an axis"},
      {all + "[joints.loose]\nkind = \"revolute\"\nconnect = [\"ground\", \"arm.B\"]\n"
             "axis = \"x\"\ncloses = true\nclearance = \"0.2 mm\"\n",
       "clearance of a revolute joint is not computed", "a ball in a wider socket"},
      {all + "[joints.loose]\nkind = \"spherical\"\nconnect = [\"ground\", \"arm.B\"]\n"
             "closes = true\nclearance = \"0.2 mm\"\nrestitution = 0.8\n",
       "wants the stiffness of its contact", "Johnson"},
      {all + "[joints.slot]\nkind = \"slot\"\nconnect = [\"ground\", \"arm.B\"]\naxis = \"x\"\n"
             "friction = { coefficient = 0.1, guide_length = \"0.1 m\" }\n",
       "a slot carries no couple", "leave out guide_length"},
      {"[joints.hinge]\nkind = \"prismatic\"\nconnect = [\"ground\", \"arm.A\"]\naxis = \"y\"\n"
       "friction = { coefficient = 3.0 }\n[drivers.a]\njoint = \"hinge\"\nkind = \"hold\"\nvalue "
       "= "
       "\"0 m\"\n" +
           weld,
       "a coefficient of friction, from 0 to 2", "coefficient = 0.1"},
      {hinge + "moved_by = \"forces\"\n" + weld + swing, "forces move joint \"hinge\"",
       "or the driver"},
      {hinge + "moved_by = \"forces\"\n" + weld, "how long is not known", "duration"},
      {hinge + "start_rate = \"1 rad/s\"\n" + weld + swing, "rates at the start",
       "moved_by = \"forces\""},
      {hinge + weld + "[drivers.swing]\njoint = \"hing\"\nkind = \"hold\"\nvalue = \"0 deg\"\n",
       "there is no joint \"hing\"", "did you mean \"hinge\"?"},
      {all + "[drivers.twice]\njoint = \"hinge\"\nkind = \"hold\"\nvalue = \"0 deg\"\n",
       "has a driver already", "one driver"},
      {all + "[drivers.weld]\njoint = \"weld\"\nkind = \"hold\"\nvalue = \"0 deg\"\n",
       "is fixed and cannot move", "one driver"},
      {all + "[forces.bar]\nkind = \"torsion spring\"\njoint = \"weld\"\nstiffness = \"1 N "
             "m/rad\"\n",
       "there is no revolute joint \"weld\"", "hinge"},
      {all + "[forces.bar]\nkind = \"torsion spring\"\njoint = \"hinge\"\nstiffness = \"0 N "
             "m/rad\"\n",
       "neither stiffness nor damping", "kN m/rad"},
      {all + "[joints.rod]\nkind = \"distance\"\nconnect = [\"ground\", \"load.D\"]\n",
       "the length of \"rod\" is not known", "length ="},
      {all + "[joints.rod]\nkind = \"distance\"\nconnect = [\"ground\", \"load.D\"]\n"
             "length = \"1 m\"\n[drivers.rod]\njoint = \"rod\"\nkind = \"hold\"\n"
             "value = \"1 m\"\n",
       "the length of \"rod\" is said twice", "a cylinder a driver"},
      {all + "[joints.ball]\nkind = \"spherical\"\nconnect = [\"ground\", \"load.D\"]\n"
             "closes = true\n[drivers.ball]\njoint = \"ball\"\nkind = \"hold\"\n"
             "value = \"1 m\"\n",
       "closes a loop and follows it", "the length of a distance"},
      {all + "[joints.hook]\nkind = \"universal\"\nconnect = [\"ground\", \"load.D\"]\n"
             "closes = true\naxis = \"x\"\nsecond_axis = [1, 1, 0]\n",
       "stand square", "second_axis = \"z\""},
      {"[joints.hinge]\nkind = \"screw\"\nconnect = [\"ground\", \"arm.A\"]\naxis = \"x\"\n"
       "lead = \"0 mm\"\n" +
           weld,
       "\"lead\"", "0.25 m"},
      {two_wheels + swing + teeth + "joints = [\"hinge\", \"whel\"]\nratio = -0.5\n",
       "there is no joint \"whel\" that carries a body", "did you mean \"wheel\"?"},
      {two_wheels + swing + teeth + "joints = [\"hinge\"]\nratio = -0.5\n", "has two wheels",
       "joints = ["},
      {two_wheels + swing + teeth + "joints = [\"hinge\", \"hinge\"]\nratio = -0.5\n",
       "cannot mesh with itself", "the two wheels"},
      {two_wheels + swing + teeth + "joints = [\"hinge\", \"weld\"]\nratio = -0.5\n",
       "\"weld\" is of kind \"fixed\"", "revolute joints"},
      {two_wheels + sledge + swing + teeth + "joints = [\"hinge\", \"sledge\"]\nratio = -0.5\n",
       "\"sledge\" is of kind \"prismatic\"", "kind = \"rack\""},
      {two_wheels + swing + teeth + "joints = [\"hinge\", \"wheel\"]\nratio = 0\n",
       "must not be zero", "-0.5"},
      {two_wheels + swing + teeth + "joints = [\"hinge\", \"wheel\"]\nratio = 1\n",
       "both wheels turn alike", "negative"},
      {two_wheels + swing + teeth +
           "joints = [\"hinge\", \"wheel\"]\nratio = -0.5\npressure_angle = \"80 deg\"\n",
       "from 0 to 45 deg", "20 deg"},
      {two_wheels + swing + teeth +
           "joints = [\"hinge\", \"wheel\"]\nratio = -0.5\nmesh = \"load.D\"\n",
       "does not stand still beside both axes", "the ground"},
      {two_wheels + swing + teeth +
           "joints = [\"hinge\", \"wheel\"]\nratio = -0.5\nmesh = \"ground\"\n"
           "at = [\"0.2 m\", \"0 m\", \"0 m\"]\n",
       "0.1 m beside the line", "goes through (0.1, 0, 0) m along (0, 1, 0) of the ground"},
      {two_wheels + swing + teeth +
           "joints = [\"hinge\", \"wheel\"]\nratio = -0.5\n"
           "[drivers.teeth]\njoint = \"teeth\"\nkind = \"hold\"\n"
           "value = \"0 deg\"\n",
       "closes a loop and follows it", "one driver"},
      {"[joints.hinge]\nkind = \"revolute\"\nconnect = [\"ground\", \"arm.A\"]\naxis = \"w\"\n" +
           weld,
       "\"axis\" cannot be \"w\"", "three numbers"},
      {"[joints.hinge]\nkind = \"revolute\"\nconnect = [\"ground\", \"arm.A\"]\naxis = [0, 0, "
       "0]\n" +
           weld,
       "is no direction", "three numbers"},
      {"[joints.hinge]\nkind = \"fixed\"\nconnect = [\"ground\", \"arm.A\"]\nturn = [\"10 "
       "deg\"]\n" +
           weld,
       "wants turns about axes", "[[\"x\", \"10 deg\"]"},
      {"[joints.hinge]\nkind = \"pin\"\nconnect = [\"ground\", \"arm.A\"]\n" + weld,
       "\"kind\" cannot be \"pin\"", "revolute"},
      {"[joints.hinge]\nkind = \"fixed\"\nconnect = [\"arm.A\", \"ground\"]\n" + weld,
       "carries the second one's body", "the carrying body first"},
      {all + "[forces.f]\nkind = \"force\"\npoint = \"arm.B\"\ndirection = \"z\"\n",
       "wants either \"size\" or \"law\"", "size ="},
      {all + "[forces.f]\nkind = \"force\"\npoint = \"arm.X\"\ndirection = \"z\"\nsize = \"1 N\"\n",
       "has no point \"X\"", "did you mean"},
      {all + "[forces.f]\nkind = \"force\"\npoint = \"arm.B\"\naxes = \"lod\"\ndirection = "
             "\"z\"\nsize = \"1 N\"\n",
       "there is no body \"lod\"", "did you mean \"load\"?"},
      {all + "[forces.f]\nkind = \"line force\"\nfrom = \"arm.A\"\nto = \"arm.side\"\n"
             "direction = \"z\"\nsize = \"1 N/m\"\n",
       "reaches to s = 0.5 m of the beam", "split the segment"},
      {all + "[forces.f]\nkind = \"line force\"\nfrom = \"arm.A\"\nto = \"load.C\"\n"
             "direction = \"z\"\nsize = \"1 N/m\"\n",
       "between two points of one body", "leg.foot"},
      {all + "[bodies.world]\npoints = { A = [\"0 m\", \"0 m\", \"0 m\"] }\n[joints.w]\nkind = "
             "\"fixed\"\nconnect = [\"ground\", "
             "\"world.A\"]\n",
       "is the world and no body", "another name"},
      {all + "[bodies.rod]\nmass = \"1 kg\"\nuniform_rod = [\"P\", \"P\"]\n"
             "points = { P = [\"0 m\", \"0 m\", \"0 m\"] }\n"
             "[joints.r]\nkind = \"fixed\"\nconnect = [\"ground\", \"rod.P\"]\n",
       "the rod has no length", "two points apart"},
      {all + "[forces.f]\nkind = \"force\"\npoint = \"arm.far\"\ndirection = \"z\"\n"
             "size = \"1 N\"\n",
       "acts beyond the end of the beam, at s = 1.5 m", "fixed to the beam"},
      {all + "[hand_symbols]\n\"a b\" = 1\n", "cannot stand in a formula", "w_g"},
      {hinge + weld +
           "[drivers.swing]\njoint = \"hinge\"\nkind = \"polynomial\"\n"
           "coefficients = [\"0 rad\", \"1 rad/s\", \"1 rad/s^2\"]\n",
       "\"hinge\" neither repeats nor ends", "duration"},
      {all + "[deflection]\nlimit = \"1 mm\"\n", "does not say from which line its deflection",
       "against = \"tangent\""},
      {all + "[[hand_formulas]]\nname = \"v\"\nquantity = \"omega\"\nof = \"arm\"\n"
             "formula = [\"1/0\", \"0\", \"0\"]\n",
       "has no finite value", "division by zero"},
      {all + "[[hand_formulas]]\nname = \"v\"\nquantity = \"omega\"\nof = \"arm\"\n"
             "formula = [\"unknown*2\", \"0\", \"0\"]\n",
       "\"unknown*2\"", "hand_symbols"},
  };
  for (const Wrong& wrong : wrongs) {
    CAPTURE(wrong.lines);
    const Problem problem = problem_of(wrong.lines);
    CHECK_THAT(problem.message, Catch::Contains(wrong.said));
    CHECK_THAT(problem.hint, Catch::Contains(wrong.hint));
    CHECK(problem.line > 0);
  }
}

TEST_CASE("bodies that cannot be are refused", "[bad_input]") {
  const auto problem_with = [](const std::string& part, const std::string& with) {
    std::string text = bodies + hinge + weld + swing;
    text.replace(text.find(part), part.size(), with);
    return problem_in(text).message;
  };
  const std::string inertia = "[\"1 kg m^2\", \"2 kg m^2\", \"2.5 kg m^2\"]";
  CHECK_THAT(problem_with(inertia, "[\"1 kg m^2\", \"2 kg m^2\", \"3.5 kg m^2\"]"),
             Catch::Contains("no body has these principal moments"));
  CHECK_THAT(problem_with(inertia, "[\"-1 kg m^2\", \"2 kg m^2\", \"2 kg m^2\"]"),
             Catch::Contains("no body has these principal moments"));
  CHECK_THAT(problem_with(inertia,
                          "[[\"1 kg m^2\", \"0.1 kg m^2\", \"0 kg m^2\"], [\"0 kg m^2\", \"1 kg "
                          "m^2\", \"0 kg m^2\"], [\"0 kg m^2\", \"0 kg m^2\", \"1 kg m^2\"]]"),
             Catch::Contains("not symmetric"));
  CHECK_THAT(problem_with("mass = \"10 kg\"\n", ""), Catch::Contains("with inertia has a mass"));
  CHECK_THAT(problem_with("points = { A =", "mass = \"3 kg\"\npoints = { A ="),
             Catch::Contains("come from its sections"));
  CHECK_THAT(problem_with("axis = \"x\"\nz = \"z\"", "axis = \"x\"\nz = [1, 0, 1]"),
             Catch::Contains("square on the beam's axis"));
  CHECK_THAT(problem_with("C = [\"0 m\", \"0 m\", \"0 m\"]", "C = [\"0 m\", \"0 m\"]"),
             Catch::Contains("three values, x, y and z"));
}

}  // namespace read_chain_test
