// Models of MuJoCo as robots and cases in space. Expected numbers are those of the texts and hand
// formulas written out here: products of elementary rotations, moments of inertia of solids by
// their integrals, Steiner's rule, and a parallelogram whose loop closes by its lengths.
// tests/benchmarks/outside/mjcf.py compares with MuJoCo itself.

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/project/robot.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"

namespace mjcf_test {

using namespace boxbeam;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::contains;

namespace {

constexpr double pi = std::numbers::pi;

robots::Robot robot_of(const std::string& inside) {
  return robots::parse_mjcf("m.xml", "<mujoco model=\"m\">" + inside + "</mujoco>");
}

/// A model of one body in the world, with a second one so that a beam moves beside it.
robots::Robot body_of(const std::string& attributes, const std::string& inside,
                      const std::string& settings = "") {
  return robot_of(settings + "<worldbody><body name=\"a\" " + attributes + ">" + inside +
                  "</body></worldbody>");
}

const robots::Joint& joint_of(const robots::Robot& robot, const std::string& name) {
  for (const robots::Joint& joint : robot.joints)
    if (joint.name == name) return joint;
  FAIL("there is no joint " << name);
  return robot.joints.front();
}

const robots::Inertial& mass_of(const robots::Robot& robot, std::size_t link = 1) {
  REQUIRE(robot.links.at(link).inertial);
  return *robot.links[link].inertial;
}

Matrix3d turned_x(double q) {
  Matrix3d R;
  R << 1, 0, 0, 0, std::cos(q), -std::sin(q), 0, std::sin(q), std::cos(q);
  return R;
}
Matrix3d turned_y(double q) {
  Matrix3d R;
  R << std::cos(q), 0, std::sin(q), 0, 1, 0, -std::sin(q), 0, std::cos(q);
  return R;
}
Matrix3d turned_z(double q) {
  Matrix3d R;
  R << std::cos(q), -std::sin(q), 0, std::sin(q), std::cos(q), 0, 0, 0, 1;
  return R;
}

const std::string ball = "<geom type=\"sphere\" size=\"0.1\" mass=\"2\"/>";

}  // namespace

TEST_CASE("every way to say an orientation gives the matrix of its definition") {
  const std::string radian = "<compiler angle=\"radian\"/>";
  const auto check = [](const robots::Robot& robot, const Matrix3d& expected) {
    const robots::Pose pose = robots::reference_poses(robot).at(1);
    INFO(pose.R);
    CHECK((pose.R - expected).norm() < 1e-14);
  };
  // Axes that turn with the body: X Y Z; in capitals those of the outside, Z Y X.
  const Matrix3d X = turned_x(0.3), Y = turned_y(-0.4), Z = turned_z(0.5);
  check(body_of("euler=\"0.3 -0.4 0.5\"", ball, radian), X * Y * Z);
  check(body_of("euler=\"0.3 -0.4 0.5\"", ball, "<compiler angle=\"radian\" eulerseq=\"XYZ\"/>"),
        Z * Y * X);
  // Mixed: x of the body, then y of the outside before it, then z of the body behind both.
  check(body_of("euler=\"0.3 -0.4 0.5\"", ball, "<compiler angle=\"radian\" eulerseq=\"xYz\"/>"),
        Y * X * Z);
  // Degrees where nothing is said: 60 and 90.
  check(body_of("euler=\"60 0 90\"", ball), turned_x(pi / 3) * turned_z(pi / 2));
  check(body_of("axisangle=\"0 2 0 30\"", ball), turned_y(pi / 6));
  // Of any length: cos and sin of half of 2 atan2(4, 3).
  check(body_of("quat=\"0.3 0 0 0.4\"", ball), turned_z(2 * std::atan2(4.0, 3.0)));
  // z goes to (1, 0, 1)/sqrt 2 by 45 degrees about y, the shortest way.
  check(body_of("zaxis=\"1 0 1\"", ball), turned_y(pi / 4));
  // x to y; the second axis is made square to it: (1, 1, 0) leaves x.
  Matrix3d swapped;
  swapped << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  check(body_of("xyaxes=\"0 2 0 1 1 0\"", ball), swapped);
}

TEST_CASE("masses of shapes are their volumes, moments those of their integrals") {
  const auto of = [](const std::string& shape) {
    return mass_of(body_of("", "<geom density=\"1000\" " + shape + "/>"));
  };
  const auto check = [&](const std::string& shape, double mass, const Vector3d& moments) {
    CAPTURE(shape);
    const robots::Inertial found = of(shape);
    CHECK(found.mass == Approx(mass).epsilon(1e-13));
    CHECK(found.centre.norm() == 0.0);
    CHECK((found.inertia - Matrix3d(moments.asDiagonal())).norm() < 1e-13 * moments.norm());
  };
  const double ball_mass = 1000 * 4.0 / 3.0 * pi * 0.008;
  check("size=\"0.2\"", ball_mass, Vector3d::Constant(0.4 * ball_mass * 0.04));
  // Half lengths 0.1, 0.2, 0.3: m/12 of the whole ones squared.
  const double box = 1000 * 0.2 * 0.4 * 0.6;
  check("type=\"box\" size=\"0.1 0.2 0.3\"", box,
        box / 12 * Vector3d(0.16 + 0.36, 0.04 + 0.36, 0.04 + 0.16));
  const double egg = 1000 * 4.0 / 3.0 * pi * 0.006;
  check("type=\"ellipsoid\" size=\"0.1 0.2 0.3\"", egg, egg / 5 * Vector3d(0.13, 0.10, 0.05));
  const double rod = 1000 * pi * 0.01 * 0.8;
  check("type=\"cylinder\" size=\"0.1 0.4\"", rod,
        rod * Vector3d(0.0025 + 0.64 / 12, 0.0025 + 0.64 / 12, 0.005));
  // A capsule by its slices of z: disks of area A with A^2/(4 pi) each about a diameter.
  double mass = 0.0, along = 0.0, across = 0.0;
  constexpr int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double z = 0.5 * (i + 0.5) / n, beyond = std::max(0.0, z - 0.4);
    const double A = pi * (0.01 - beyond * beyond), m = 2 * 1000 * A * 0.5 / n;
    mass += m;
    along += m * A / (2 * pi);
    across += m * (A / (4 * pi) + z * z);
  }
  const robots::Inertial capsule = of("type=\"capsule\" size=\"0.1 0.4\"");
  CHECK(capsule.mass == Approx(mass).epsilon(1e-8));
  CHECK(capsule.inertia(2, 2) == Approx(along).epsilon(1e-8));
  CHECK(capsule.inertia(0, 0) == Approx(across).epsilon(1e-8));
  CHECK(capsule.inertia(1, 1) == Approx(across).epsilon(1e-8));
  // From (1, 0, 0) to (1, 0.8, 0): the same, about y.
  const robots::Inertial lying = of("type=\"capsule\" size=\"0.1\" fromto=\"1 0 0 1 0.8 0\"");
  CHECK((lying.centre - Vector3d(1, 0.4, 0)).norm() < 1e-15);
  CHECK(lying.inertia(1, 1) == Approx(along).epsilon(1e-8));
  CHECK(lying.inertia(0, 0) == Approx(across).epsilon(1e-8));
  CHECK(std::abs(lying.inertia(0, 1)) < 1e-13);
}

TEST_CASE("several shapes, frames and classes make one mass, by Steiner's rule") {
  // 2 kg at x = 1 and 6 kg at x = -1 (a frame's origin there): centre -0.5, between them m d^2 of
  // 2 1.5^2 + 6 0.5^2 = 6 about y and z, and of balls 0.4 m r^2 = 0.4 8 0.01 about all.
  const robots::Robot robot = robot_of(
      "<default><geom size=\"0.1\"/><default class=\"heavy\"><geom mass=\"6\"/></default></default>"
      "<worldbody><body name=\"a\"><geom pos=\"1 0 0\" mass=\"2\"/>"
      "<frame pos=\"0 0 1\" childclass=\"heavy\" euler=\"0 90 0\"><geom pos=\"1 0 -1\"/></frame>"
      "<geom type=\"mesh\" mesh=\"skin\" mass=\"0\"/>"
      "<geom pos=\"9 9 9\" mass=\"1\" group=\"3\"/></body></worldbody>"
      "<compiler inertiagrouprange=\"0 2\"/>");
  // A quarter turn about y takes (1, 0, -1) to (-1, 0, -1), and 1 m up to z = 0.
  const robots::Inertial& mass = mass_of(robot);
  CHECK(mass.mass == 8.0);
  CHECK((mass.centre - Vector3d(-0.5, 0, 0)).norm() < 1e-15);
  CHECK((mass.inertia - Matrix3d(Vector3d(0.032, 6.032, 6.032).asDiagonal())).norm() < 1e-13);
}

TEST_CASE("a given inertia stands before shapes, unless the shapes are to say it") {
  const std::string inertial =
      "<inertial pos=\"0.1 0.2 0.3\" mass=\"4\" quat=\"1 0 0 1\" diaginertia=\"2 3 4\"/>";
  const robots::Inertial& given = mass_of(body_of("", inertial + ball));
  CHECK(given.mass == 4.0);
  CHECK(given.centre == Vector3d(0.1, 0.2, 0.3));
  // A quarter turn about z changes x and y.
  CHECK((given.inertia - Matrix3d(Vector3d(3, 2, 4).asDiagonal())).norm() < 1e-14);
  CHECK(mass_of(body_of("", inertial + ball, "<compiler inertiafromgeom=\"true\"/>")).mass == 2.0);
  const robots::Robot none = body_of("", ball, "<compiler inertiafromgeom=\"false\"/>");
  CHECK_FALSE(none.links.at(1).inertial);
  const robots::Inertial full = mass_of(
      body_of("", "<inertial pos=\"0 0 0\" mass=\"1\" fullinertia=\"5 6 7 0.1 0.2 0.3\"/>"));
  Matrix3d I;
  I << 5, 0.1, 0.2, 0.1, 6, 0.3, 0.2, 0.3, 7;
  CHECK((full.inertia - I).norm() < 1e-15);
  // Least values: the mass, and each principal moment.
  const robots::Inertial& least =
      mass_of(body_of("", inertial, "<compiler boundmass=\"9\" boundinertia=\"3.5\"/>"));
  CHECK(least.mass == 9.0);
  CHECK(
      (Eigen::SelfAdjointEigenSolver<Matrix3d>(least.inertia).eigenvalues() - Vector3d(3.5, 3.5, 4))
          .norm() < 1e-13);
}

TEST_CASE("coordinates of a case are those of MuJoCo: a body stands as written at ref") {
  // Hinge about z through (0.5, 0, 0) of the body with ref 90 degrees, then a slide along its x
  // with ref 0.2. At 90 degrees and 0.2 m the body is at (1, 2, 3), unturned.
  const std::string model =
      "<worldbody><body name=\"base\" pos=\"5 0 0\"><geom size=\"0.5\"/></body>"
      "<body name=\"a\" pos=\"1 2 3\"><joint name=\"h\" pos=\"0.5 0 0\" axis=\"0 0 3\" ref=\"90\" "
      "range=\"-180 180\"/><joint name=\"s\" type=\"slide\" axis=\"1 0 0\" ref=\"0.2\"/>" +
      ball + "</body></worldbody>";
  const robots::Robot robot = robot_of(model);
  CHECK((robots::reference_poses(robot).back().p - Vector3d(1, 2, 3)).norm() < 1e-15);
  const Project reference = parse_project("m.toml", robots::case_text(robot, "base"));
  const auto& mechanism = spatial_of(reference);
  const auto body = static_cast<std::size_t>(body_index(mechanism, "a"));
  const spatial::State state = spatial::Chain(mechanism).at(0.0);
  CHECK((state.bodies[body].position - Vector3d(1, 2, 3)).norm() < 1e-15);
  CHECK((state.bodies[body].R_WB - Matrix3d::Identity()).norm() < 1e-15);
  // At q = 0 of both: a quarter turn back about the anchor (1.5, 2, 3), from where the origin is
  // 0.5 m back along the body's x, which is now -y of the world, and 0.2 m less along it:
  // (1.5, 2.5, 3) + (0, 0.2, 0).
  const Project zero = parse_project("m.toml", robots::case_text(robot, "base"),
                                     {"drivers.h.value=0 rad", "drivers.s.value=0 m"});
  const spatial::State moved = spatial::Chain(spatial_of(zero)).at(0.0);
  CHECK((moved.bodies[body].position - Vector3d(1.5, 2.7, 3)).norm() < 1e-15);
  CHECK((moved.bodies[body].R_WB - turned_z(-pi / 2)).norm() < 1e-15);
  const robots::Joint& hinge = joint_of(robot, "h");
  CHECK(hinge.limit.lower == Approx(-pi));
  CHECK(hinge.limit.upper == Approx(pi));
}

TEST_CASE("springs and dampers of hinges act in the case, what does not is said") {
  const robots::Robot robot = robot_of(
      "<option gravity=\"0 0 0\"/><default><joint damping=\"0.5\"/></default>"
      "<worldbody><body name=\"a\"><joint name=\"h\" axis=\"0 0 1\" stiffness=\"8\" "
      "springref=\"30\" armature=\"0.1\" frictionloss=\"3\"/>" +
      ball + "<body name=\"b\" pos=\"1 0 0\"><joint name=\"s\" type=\"slide\" stiffness=\"7\"/>" +
      ball + "<body name=\"c\"><joint name=\"r\" type=\"ball\" range=\"0 40\"/>" + ball +
      "<camera/></body></body></body></worldbody>"
      "<actuator><motor joint=\"h\"/></actuator><contact><exclude/><exclude/></contact>");
  const std::string text = robots::case_text(robot, "");
  INFO(text);
  const Project project = parse_project("m.toml", text, {"drivers.h.value=0.1 rad"});
  const auto& mechanism = spatial_of(project);
  CHECK(mechanism.gravity.isZero(0.0));
  REQUIRE(mechanism.torsion_springs.size() == 1);
  CHECK(mechanism.torsion_springs[0].stiffness == 8.0);
  CHECK(mechanism.torsion_springs[0].damping == 0.5);
  CHECK(mechanism.torsion_springs[0].free_angle == Approx(pi / 6).epsilon(1e-15));
  // At rest without weight the drive holds the spring: 8 (0.1 - pi/6).
  const spatial::Chain chain(mechanism);
  const spatial::State state = chain.at(0.0);
  const auto at = static_cast<std::size_t>(joint_index(mechanism, "h"));
  CHECK(chain.along_axis(state, at, chain.joint_wrenches(state)[at]) ==
        Approx(8 * (0.1 - pi / 6)).epsilon(1e-13));
  const auto slide = static_cast<std::size_t>(joint_index(mechanism, "s"));
  CHECK(mechanism.joints[slide].friction.viscous == 0.5);
  for (const char* part : {"friction 3 N m", "inertia of its drive 0.1 kg m^2", "stiffness 7 N/m",
                           "camera", "range of ball joints", "damping of ball and free joints",
                           "actuator motor", "contact exclude", "(2)"})
    CHECK(contains(text, part));
}

TEST_CASE("a connected parallelogram is closed where it stands and follows its actuated crank") {
  // Cranks of 1 m, 2 m apart, coupler of 2 m; the second crank has the actuator.
  const std::string bodies =
      "<worldbody><body name=\"one\"><joint name=\"a\" axis=\"0 1 0\"/><geom type=\"box\" "
      "size=\"0.05 0.05 0.5\" pos=\"0 0 0.5\"/><body name=\"coupler\" pos=\"0 0 1\"><joint "
      "name=\"b\" axis=\"0 1 0\"/><geom type=\"box\" size=\"1 0.05 0.05\" pos=\"1 0 0\"/></body>"
      "</body><body name=\"two\" pos=\"2 0 0\"><joint name=\"c\" axis=\"0 1 0\"/><geom "
      "type=\"box\" size=\"0.05 0.05 0.5\" pos=\"0 0 0.5\"/></body></worldbody>";
  const robots::Robot robot =
      robot_of(bodies +
               "<equality><connect body1=\"coupler\" body2=\"two\" anchor=\"2 0 0\"/></equality>"
               "<actuator><motor joint=\"c\"/></actuator>");
  REQUIRE(robot.closings.size() == 1);
  CHECK((robot.closings[0].p_b - Vector3d(0, 0, 1)).norm() < 1e-15);
  const std::vector<std::vector<bool>> left = robots::left_to_closings(robot);
  CHECK(left[0][0]);
  CHECK(left[1][0]);
  CHECK_FALSE(left[2][0]);
  const Project project =
      parse_project("m.toml", robots::case_text(robot, ""), {"drivers.c.value=0.3 rad"});
  const auto& mechanism = spatial_of(project);
  const spatial::Chain chain(mechanism);
  const spatial::State state = chain.at(0.0);
  const auto place = [&](const char* name) {
    return state.bodies[static_cast<std::size_t>(body_index(mechanism, name))];
  };
  // Both cranks turn alike, the coupler stays level.
  CHECK((place("one").R_WB - turned_y(0.3)).norm() < 1e-12);
  CHECK((place("coupler").R_WB - Matrix3d::Identity()).norm() < 1e-12);
  CHECK((place("coupler").position - Vector3d(std::sin(0.3), 0, std::cos(0.3))).norm() < 1e-12);
  // Without an actuator those near the root drive; a weld would leave the three none.
  const robots::Robot plain = robot_of(
      bodies + "<equality><connect body1=\"two\" body2=\"coupler\" anchor=\"0 0 1\"/></equality>");
  CHECK_FALSE(robots::left_to_closings(plain)[0][0]);
  CHECK((plain.closings[0].p_b - Vector3d(2, 0, 0)).norm() < 1e-15);
  const robots::Robot open =
      robot_of(bodies +
               "<equality><connect active=\"false\" body1=\"two\" body2=\"coupler\" "
               "anchor=\"0 0 1\"/></equality>");
  CHECK(open.closings.empty());
  CHECK(open.left_out.count("equality connect (not active)") == 1);
}

TEST_CASE("welds hold two frames together: where they stand, as relpose says, or by sites") {
  const auto welded = [](const std::string& how) {
    return robot_of(
               "<worldbody><body name=\"a\" pos=\"1 0 0\" euler=\"0 0 90\"><freejoint "
               "name=\"f\"/>" +
               ball +
               "<site name=\"p\" pos=\"0.5 0 0\" euler=\"0 0 90\"/></body><body name=\"b\" "
               "pos=\"1 2 0\"><freejoint name=\"g\"/>" +
               ball + "<site name=\"q\" pos=\"0 0.1 0\"/></body></worldbody><equality><weld " +
               how + "/></equality>")
        .closings.at(0);
  };
  // b in the axes of a: (2, 0, 0), turned back by 90 degrees.
  const robots::Closing reference = welded("body1=\"a\" body2=\"b\" anchor=\"0 1 0\"");
  CHECK((robots::rotation_of(reference.turns) - turned_z(-pi / 2)).norm() < 1e-15);
  CHECK((reference.p_b - Vector3d(0, 1, 0)).norm() == 0.0);
  CHECK((reference.p_a - Vector3d(3, 0, 0)).norm() < 1e-15);
  const robots::Closing relative = welded("body1=\"a\" body2=\"b\" relpose=\"1 2 3 1 1 0 0\"");
  CHECK((robots::rotation_of(relative.turns) - turned_x(pi / 2)).norm() < 1e-15);
  CHECK((relative.p_a - Vector3d(1, 2, 3)).norm() < 1e-15);
  const robots::Closing sites = welded("site1=\"p\" site2=\"q\"");
  CHECK((robots::rotation_of(sites.turns) - turned_z(pi / 2)).norm() < 1e-15);
  CHECK((sites.p_a - Vector3d(0.5, 0, 0)).norm() < 1e-15);
  CHECK((sites.p_b - Vector3d(0, 0.1, 0)).norm() < 1e-15);
  // The world is the first of two: a stands at (1, 0, 0), its place (0, 1, 0) at the world's
  // (0, 0, 0).
  const robots::Closing ground = welded("body1=\"a\" anchor=\"0 0 0\"");
  CHECK(ground.a == 0);
  CHECK(ground.p_a.norm() < 1e-15);
  CHECK((ground.p_b - Vector3d(0, 1, 0)).norm() < 1e-15);
  CHECK((robots::rotation_of(ground.turns) - turned_z(pi / 2)).norm() < 1e-15);
}

TEST_CASE("joints that are tied hold their ratio from their references") {
  const auto tied = [](const std::string& how) {
    return robot_of(
        "<compiler angle=\"radian\"/><worldbody><body name=\"a\"><joint name=\"x\" "
        "ref=\"0.5\"/>" +
        ball + "<body name=\"b\" pos=\"1 0 0\"><joint name=\"y\" ref=\"2\"/>" + ball +
        "</body></body></worldbody><equality><joint joint1=\"y\" " + how + "/></equality>");
  };
  // y - 2 = 0.1 + 3 (x - 0.5).
  const robots::Robot robot = tied("joint2=\"x\" polycoef=\"0.1 3 0 0 0\"");
  const robots::Joint& y = joint_of(robot, "y");
  REQUIRE(y.mimic);
  CHECK(y.mimic->multiplier == 3.0);
  CHECK(y.mimic->offset == Approx(2 + 0.1 - 1.5).epsilon(1e-15));
  const Project project = parse_project("m.toml", robots::case_text(robot, ""));
  const auto& mechanism = spatial_of(project);
  const auto held = static_cast<std::size_t>(joint_index(mechanism, "y"));
  CHECK(driver_at(mechanism.joints[held].driver, 0.0).value == Approx(2.1).epsilon(1e-15));
  // Of one alone the first number alone.
  CHECK(joint_of(tied("polycoef=\"0.25\""), "y").reference == 2.25);
}

TEST_CASE("bodies and joints without names get names of their own") {
  const robots::Robot robot =
      robot_of("<worldbody><body><joint/><joint axis=\"1 0 0\"/>" + ball +
               "</body><body name=\"body-1\">" + ball + "</body></worldbody>");
  std::vector<std::string> links, joints;
  for (const robots::Link& link : robot.links) links.push_back(link.name);
  for (const robots::Joint& joint : robot.joints) joints.push_back(joint.name);
  CHECK(links == std::vector<std::string>{"world", "body-1-2-body-1-2", "body-1-2", "body-1"});
  CHECK(joints == std::vector<std::string>{"body-1-2", "body-1-2-2", "body-1"});
  CHECK_NOTHROW(parse_project("m.toml", robots::case_text(robot, "")));
}

TEST_CASE("what is wrong with a model is said, with its line") {
  struct Broken {
    std::string text;
    int line;
    std::string message;
  };
  const auto model = [](const std::string& inside) {
    return "<mujoco>\n" + inside + "\n</mujoco>\n";
  };
  const auto world = [&](const std::string& inside) {
    return model("<worldbody>\n" + inside + "\n</worldbody>");
  };
  const auto a = [](const std::string& inside) {
    return "<body name=\"a\">\n" + inside + "\n</body>";
  };
  const auto tie = [&](const std::string& equality) {
    return model(
        "<worldbody><body name=\"a\"><joint name=\"x\"/><geom size=\"1\"/><body "
        "name=\"b\"><joint name=\"y\" type=\"ball\"/><geom size=\"1\"/></body></body>"
        "</worldbody>\n<equality>\n" +
        equality + "\n</equality>");
  };
  std::string deep;
  for (int i = 0; i < 5000; ++i) deep += "<body>";
  const std::vector<Broken> broken{
      {"<robot/>", 0, "there is no <mujoco>"},
      {"<mujoco>\n<worldbody>\n</mujoco>", 3, "</mujoco> closes nothing that is open"},
      {world(""), 0, "the model has no <body>"},
      {world(deep), 3, "elements lie too deep in each other"},
      {model("<include file=\"b.xml\"/>"), 2, "what it stands for is not read"},
      {world(a("<replicate count=\"3\"/>")), 4, "what it stands for is not read"},
      {world("<body name=\"ground\"/>"), 3, "a case calls the fixed world so"},
      {world("<body name=\"a\"/>\n<body name=\"a\"/>"), 4, "another link has this name"},
      {world(a("<joint name=\"j\"/>\n<joint name=\"j\"/>")), 5, "another joint is called \"j\""},
      {world("<body name=\"a\" pos=\"1 2\"/>"), 3, "pos = \"1 2\" of <body> wants 3 numbers"},
      {world("<body name=\"a\" euler=\"1 2 3\" zaxis=\"0 0 1\"/>"), 3, "it says more than once"},
      {world("<body name=\"a\" quat=\"0 0 0 0\"/>"), 3, "quat says no direction"},
      {world("<body name=\"a\" childclass=\"c\"/>"), 3, "there is no class \"c\""},
      {world(a("<geom class=\"c\" size=\"1\"/>")), 4, "there is no class \"c\""},
      {world(a("<joint type=\"screw\"/>")), 4, "type = \"screw\" is no word for it"},
      {world(a("<joint axis=\"0 0 0\"/>")), 4, "its axis is no direction"},
      {world(a("<joint range=\"2 1\"/>")), 4, "its lower limit 2 is above its upper one 1"},
      {world(a("<joint damping=\"-1\"/>")), 4, "its damping is below zero"},
      {world(a("<body name=\"b\">\n<freejoint/></body>")), 5, "a free joint moves a body of the"},
      {world(a("<geom type=\"mesh\" mesh=\"m\"/>")), 4, "of type \"mesh\" is not computed"},
      {world(a("<geom type=\"box\" size=\"1 1\"/>")), 4, "of <geom> wants 3 numbers"},
      {world(a("<geom type=\"box\" size=\"1 1 0\"/>")), 4, "its sizes are not above zero"},
      {world(a("<geom/>")), 4, "it has no size"},
      {world(a("<geom size=\"1\" shellinertia=\"true\"/>")), 4, "of a shell is not computed"},
      {world(a("<geom type=\"capsule\" size=\"1\" fromto=\"1 0 0 1 0 0\"/>")), 4,
       "names one place twice"},
      {world(a("<inertial pos=\"0 0 0\"/>")), 4, "it has no mass"},
      {world(a("<inertial pos=\"0 0 0\" mass=\"-1\"/>")), 4, "its mass is -1 kg"},
      {model("<compiler eulerseq=\"xyq\"/>"), 2, "is no sequence of three axes"},
      {model("<compiler angle=\"grad\"/>"), 2, "is no word for it"},
      {model("<compiler coordinate=\"global\"/>"), 2, "is no word for it"},
      {model("<compiler settotalmass=\"3\"/>"), 2, "change masses"},
      {model("<default>\n<default>\n</default></default>"), 3, "it has no class"},
      {tie("<connect body1=\"a\" body2=\"c\" anchor=\"0 0 0\"/>"), 4, "there is no body \"c\""},
      {tie("<connect body1=\"a\" body2=\"a\" anchor=\"0 0 0\"/>"), 4, "a body with itself"},
      {tie("<connect body1=\"a\"/>"), 4, "it says not what it connects where"},
      {tie("<weld site1=\"s\" site2=\"t\"/>"), 4, "there is no site \"s\""},
      {tie("<joint joint1=\"y\"/>"), 4, "there is no joint \"y\" of one movement"},
      {tie("<joint joint1=\"x\" joint2=\"x\"/>"), 2, "it mimics itself"},
      {tie("<joint joint1=\"x\" polycoef=\"0 1 0.5 0 0\"/>"), 4, "ties joints by a curve"},
  };
  for (const Broken& each : broken) {
    INFO(each.text.substr(0, 400));
    try {
      robots::parse_mjcf("m.xml", each.text);
      FAIL_CHECK("nothing was found wrong");
    } catch (const InputError& error) {
      INFO(std::string(error.what()).substr(0, 1000));
      const Problem& problem = error.problems().front();
      CHECK(problem.file == "m.xml");
      CHECK(problem.line == each.line);
      CHECK(contains(problem.message, each.message));
    }
  }
  CHECK_THROWS_AS(robots::read_mjcf("no/such.xml"), InputError);
}

}  // namespace mjcf_test
