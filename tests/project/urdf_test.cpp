// Robots of URDF files as cases in space. Expected numbers are those of the texts and hand formulas
// written out here: the roll-pitch-yaw matrix of the specification, Rodrigues' formula, R I R^T in
// sums, and equilibrium of the weights.

#include "boxbeam/project/robot.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/project/project.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"

namespace urdf_test {

using namespace boxbeam;
using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;
using test::contains;

namespace {

/// An arm of two moving links on a base, all angles unlike zero.
const std::string arm_text =
    "<?xml version=\"1.0\"?>\n"
    "<!-- <link name=\"none\"/> -->\n"
    "<robot name=\"two links\">\n"
    "<joint name=\"elbow\" type=\"revolute\">\n"  // before its links, axis by default x
    "  <origin xyz=\"0.8 0.1 -0.2\" rpy=\"-0.7 0.2 1.1\"/>\n"
    "  <parent link=\"upper\"/><child link=\"fore\"/>\n"
    "  <limit lower=\"-2\" upper=\"-0.5\" effort=\"50\" velocity=\"3\"/>\n"
    "</joint>\n"
    "<link name=\"base\"><inertial><origin xyz=\"0.05 0 0.2\"/><mass value=\"30\"/>\n"
    "  <inertia ixx=\"1\" iyy=\"1.1\" izz=\"1.2\" ixy=\"0\" ixz=\"0\" "
    "iyz=\"0\"/></inertial></link>\n"
    "<joint name=\"shoulder\" type=\"revolute\">\n"
    "  <origin xyz=\"0.1 0.2 0.5\" rpy=\"0.3 -0.4 0.5\"/>\n"
    "  <parent link=\"base\"/><child link=\"upper\"/><axis xyz=\"0 3 4\"/>\n"
    "  <limit lower=\"0.2\" upper=\"2\" effort=\"100\" velocity=\"3\"/>\n"
    "</joint>\n"
    "<link name=\"upper\"><inertial><origin xyz=\"0.3 0 0.05\"/><mass value=\"40\"/>\n"
    "  <inertia ixx=\"0.4\" iyy=\"2\" izz=\"2.1\" ixy=\"0\" ixz=\"0\" "
    "iyz=\"0\"/></inertial></link>\n"
    "<link name=\"fore\"><inertial><origin xyz=\"0.2 -0.1 0.3\" rpy=\"0.4 0.5 -0.6\"/>\n"
    "  <mass value=\"5\"/>\n"
    "  <inertia ixx=\"0.3\" iyy=\"0.4\" izz=\"0.5\" ixy=\"0.02\" ixz=\"-0.03\" iyz=\"0.04\"/>\n"
    "</inertial></link>\n"
    "</robot>\n";

Project project_of(const std::string& robot, const std::vector<std::string>& overrides = {},
                   const std::string& beam = "") {
  const std::string text = robots::case_text(robots::parse_urdf("arm.urdf", robot), beam);
  INFO(text);
  return parse_project("arm.toml", text, overrides);
}

std::string text_of(const std::string& links_and_joints, const std::string& beam = "") {
  return robots::case_text(
      robots::parse_urdf("r.urdf", "<robot name=\"r\">" + links_and_joints + "</robot>"), beam);
}

/// The roll-pitch-yaw matrix, element by element.
Matrix3d turned(double r, double p, double y) {
  const double sr = std::sin(r), cr = std::cos(r), sp = std::sin(p), cp = std::cos(p);
  const double sy = std::sin(y), cy = std::cos(y);
  Matrix3d R;
  R << cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr,  //
      sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr,   //
      -sp, cp * sr, cp * cr;
  return R;
}

/// Rodrigues: v' = v cos q + (a x v) sin q + a (a.v)(1 - cos q).
Matrix3d about(const Vector3d& a, double q) {
  Matrix3d R;
  for (int k = 0; k < 3; ++k) {
    const Vector3d v = Vector3d::Unit(k);
    R.col(k) = v * std::cos(q) + a.cross(v) * std::sin(q) + a * a.dot(v) * (1.0 - std::cos(q));
  }
  return R;
}

Matrix4d frame(const Matrix3d& R, const Vector3d& at) {
  Matrix4d T = Matrix4d::Identity();
  T.topLeftCorner<3, 3>() = R;
  T.topRightCorner<3, 1>() = at;
  return T;
}

/// The frames of "upper" and "fore" at two angles.
Matrix4d upper_at(double q) {
  return frame(turned(0.3, -0.4, 0.5), {0.1, 0.2, 0.5}) *
         frame(about({0.0, 0.6, 0.8}, q), Vector3d::Zero());
}
Matrix4d fore_at(double q1, double q2) {
  return upper_at(q1) * frame(turned(-0.7, 0.2, 1.1), {0.8, 0.1, -0.2}) *
         frame(about({1.0, 0.0, 0.0}, q2), Vector3d::Zero());
}

Vector3d in(const Matrix4d& T, const Vector3d& p) { return (T * p.homogeneous()).head<3>(); }

const std::vector<std::string> at_angles{"drivers.shoulder.value=0.7 rad",
                                         "drivers.elbow.value=-1.2 rad"};

std::size_t body(const Project& project, const char* name) {
  const int index = body_index(spatial_of(project), name);
  REQUIRE(index >= 0);
  return static_cast<std::size_t>(index);
}

const spatial::Joint& joint(const Project& project, const char* name) {
  const int index = joint_index(spatial_of(project), name);
  REQUIRE(index >= 0);
  return spatial_of(project).joints[static_cast<std::size_t>(index)];
}

double held(const Project& project, const char* name) {
  return driver_at(joint(project, name).driver, 0.5).value;
}

const std::string box =
    "<inertial><mass value=\"4\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" "
    "iyz=\"0\"/></inertial>";

std::string link(const std::string& name) { return "<link name=\"" + name + "\"/>"; }

std::string joined(const std::string& name, const std::string& type, const std::string& parent,
                   const std::string& child, const std::string& more = "") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/>" + more + "</joint>";
}

}  // namespace

TEST_CASE("a robot's links stand where its frames, multiplied by hand, put them") {
  const Project project = project_of(arm_text, at_angles);
  const spatial::State state = spatial::Chain(spatial_of(project)).at(0.3);
  const Matrix4d upper = upper_at(0.7), fore = fore_at(0.7, -1.2);
  const auto check = [&](const char* name, const Matrix4d& T) {
    CAPTURE(name);
    const spatial::BodyMotion& motion = state.bodies[body(project, name)];
    CHECK((motion.R_WB - T.topLeftCorner<3, 3>()).norm() < 1e-14);
    CHECK((motion.position - T.topRightCorner<3, 1>()).norm() < 1e-14);
  };
  check("base", Matrix4d::Identity());
  check("upper", upper);
  check("fore", fore);
}

TEST_CASE("mass, centre and inertia of a link are those of its frame: R I R^T in sums") {
  const Project project = project_of(arm_text);
  const spatial::Body& fore = spatial_of(project).bodies[body(project, "fore")];
  CHECK(fore.mass == 5.0);
  CHECK(fore.centre == Vector3d(0.2, -0.1, 0.3));
  const double I[3][3] = {{0.3, 0.02, -0.03}, {0.02, 0.4, 0.04}, {-0.03, 0.04, 0.5}};
  const Matrix3d R = turned(0.4, 0.5, -0.6);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) sum += R(i, k) * I[k][l] * R(j, l);
      CAPTURE(i, j);
      CHECK(fore.inertia(i, j) == Approx(sum).epsilon(1e-13));
    }
  }
  // What turning leaves alone: the principal moments.
  Matrix3d given;
  given << 0.3, 0.02, -0.03, 0.02, 0.4, 0.04, -0.03, 0.04, 0.5;
  const auto moments = [](const Matrix3d& of) {
    return Eigen::SelfAdjointEigenSolver<Matrix3d>(of).eigenvalues().eval();
  };
  CHECK((moments(fore.inertia) - moments(given)).norm() < 1e-14);
}

TEST_CASE("a quarter turn about z swaps the moments about x and y, and the sign of their product") {
  const std::string half_pi = "1.5707963267948966";
  const Project project = project_of(
      "<robot name=\"r\"><link name=\"a\"/><link name=\"b\">" + box +
      "</link><link name=\"c\"><inertial><origin rpy=\"0 0 " + half_pi +
      "\"/><mass value=\"1\"/><inertia ixx=\"2\" iyy=\"3\" izz=\"4\" ixy=\"0.5\" ixz=\"0.1\" "
      "iyz=\"0.2\"/></inertial></link>" +
      joined("p", "fixed", "a", "b") + joined("q", "fixed", "b", "c") + "</robot>");
  Matrix3d expected;  // x' = -y, y' = x
  expected << 3, -0.5, -0.2, -0.5, 2, 0.1, -0.2, 0.1, 4;
  const spatial::Body& c = spatial_of(project).bodies[body(project, "c")];
  CHECK((c.inertia - expected).norm() < 1e-14);
}

TEST_CASE("the root bears the weight of all links and its moment, by hand") {
  const Project project = project_of(arm_text, at_angles);
  const spatial::Chain chain(spatial_of(project));
  const spatial::State state = chain.at(0.5);
  const auto root = static_cast<std::size_t>(joint_index(spatial_of(project), "base"));
  const spatial::Wrench wrench = chain.joint_wrenches(state)[root];
  // The placeholder is as heavy as the link "upper" to the digits that are written, even from its
  // joint to the elbow: its weight acts in the middle.
  const Vector3d weight_of_1kg(0.0, 0.0, -9.81);
  const Matrix4d upper = upper_at(0.7), fore = fore_at(0.7, -1.2);
  const Vector3d moment = Vector3d(0.05, 0.0, 0.2).cross(30.0 * weight_of_1kg) +
                          in(upper, {0.4, 0.05, -0.1}).cross(40.0 * weight_of_1kg) +
                          in(fore, {0.2, -0.1, 0.3}).cross(5.0 * weight_of_1kg);
  CHECK((wrench.force + 75.0 * weight_of_1kg).norm() < 1e-5 * 75.0 * 9.81);
  CHECK((wrench.moment + moment).norm() < 1e-5 * moment.norm());
  CHECK(spatial_of(project).bodies[body(project, "upper")].mass == Approx(40.0).epsilon(1e-5));
}

TEST_CASE("joints shift, turn without end, or stand still; limits and mimics decide where held") {
  const std::string robot =
      "<robot name=\"r\">" + link("world") + "<link name=\"column\">" + box + "</link>" +
      link("carriage") + link("wheel") + link("tip") +
      joined("foot", "fixed", "world", "column", "<origin xyz=\"1 2 3\" rpy=\"0 0 0.5\"/>") +
      joined("lift", "prismatic", "column", "carriage",
             "<origin xyz=\"0.5 0 0\"/><axis xyz=\"1 2 2\"/><limit lower=\"0.3\" upper=\"2\"/>") +
      joined("spin", "continuous", "carriage", "wheel",
             "<axis xyz=\"0 0 -1\"/><limit lower=\"1\" upper=\"2\"/>"
             "<mimic joint=\"lift\" multiplier=\"-4\" offset=\"0.5\"/>") +
      joined("follow", "revolute", "wheel", "tip",
             "<axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"1\"/><mimic joint=\"spin\"/>") +
      "</robot>";
  const Project project = project_of(robot);
  CHECK(body_index(spatial_of(project), "world") < 0);  // it is the ground
  CHECK(joint(project, "foot").kind == spatial::JointKind::fixed);
  CHECK(joint(project, "foot").parent == spatial::ground);
  CHECK(joint(project, "lift").kind == spatial::JointKind::prismatic);
  CHECK(joint(project, "spin").kind == spatial::JointKind::revolute);
  // Zero where the limits allow it, else the limit; -4 0.3 + 0.5 = -0.7; a turn without end has
  // none.
  CHECK(held(project, "lift") == 0.3);
  CHECK(held(project, "spin") == Approx(-0.7).epsilon(1e-14));
  CHECK(held(project, "follow") == Approx(-0.7).epsilon(1e-14));
  const spatial::State state = spatial::Chain(spatial_of(project)).at(0.0);
  // 0.3 (1, 2, 2)/3 from (0.5, 0, 0), turned by 0.5 about z.
  const Vector3d shifted(0.6, 0.2, 0.2);
  const Vector3d expected =
      Vector3d(1, 2, 3) + Vector3d(std::cos(0.5) * shifted.x() - std::sin(0.5) * shifted.y(),
                                   std::sin(0.5) * shifted.x() + std::cos(0.5) * shifted.y(),
                                   shifted.z());
  CHECK((state.bodies[body(project, "carriage")].position - expected).norm() < 1e-15);
  // 0.5 about z and then -0.7 about -z.
  CHECK(state.bodies[body(project, "wheel")].R_WB(1, 0) == Approx(std::sin(1.2)).epsilon(1e-14));
  const std::string text = robots::case_text(robots::parse_urdf("r.urdf", robot), "");
  CHECK(contains(text, "# mimics \"lift\": -4 times its coordinate, and 0.5 more"));
  CHECK_FALSE(contains(text, "beyond its limits"));
  const std::string beyond =
      text_of(link("world") + "<link name=\"a\">" + box + "</link>" + link("b") +
              joined("s", "revolute", "world", "a") +
              joined("t", "revolute", "a", "b",
                     "<limit lower=\"-1\" upper=\"1\"/><mimic joint=\"s\" offset=\"1.5\"/>"));
  CHECK(contains(beyond, "# WARNING: this is beyond its limits"));
}

TEST_CASE("planar and floating joints have all their movements, each held") {
  const Project project = project_of(
      "<robot name=\"r\">" + link("world") + "<link name=\"table\">" + box +
      "</link><link name=\"buoy\">" + box + "</link>" +
      joined("slide", "planar", "world", "table", "<axis xyz=\"0 0 1\"/>") +
      joined("drift", "floating", "table", "buoy", "<origin xyz=\"0 0 2\" rpy=\"0.1 0.2 0.3\"/>") +
      "</robot>");
  CHECK(spatial_of(project).joints.size() == 3 + 6);
  const spatial::State state = spatial::Chain(spatial_of(project)).at(0.0);
  const spatial::BodyMotion& buoy = state.bodies[body(project, "buoy")];
  CHECK((buoy.position - Vector3d(0, 0, 2)).norm() < 1e-15);
  CHECK((buoy.R_WB - turned(0.1, 0.2, 0.3)).norm() < 1e-15);
}

TEST_CASE("the beam is the heaviest moving link, or the one that is named, between its joints") {
  const Project heaviest = project_of(arm_text);
  CHECK(heaviest.beam_body == body_index(spatial_of(heaviest), "upper"));
  CHECK(heaviest.beam.length().value() == Approx(std::sqrt(0.69)).epsilon(1e-14));
  // A last link: from its joint through its centre of mass, (0.2, -0.1, 0.3), and as far again.
  const Project last = project_of(arm_text, {}, "fore");
  CHECK(last.beam_body == body_index(spatial_of(last), "fore"));
  CHECK(last.beam.length().value() == Approx(2.0 * std::sqrt(0.14)).epsilon(1e-14));
  CHECK(last.placement.axes.col(0).cross(Vector3d(2, -1, 3)).norm() < 1e-14);
  // A root that is not the ground may be it: fixed there as a cantilever, to the shoulder.
  const Project root = project_of(arm_text, {}, "base");
  CHECK(root.beam_body == body_index(spatial_of(root), "base"));
  CHECK(root.beam.length().value() == Approx(std::sqrt(0.3)).epsilon(1e-14));
  // Joints on both sides of that which carries it: 1 m along z and 0.25 m the other way.
  const std::string both = "<robot name=\"r\">" + link("world") + "<link name=\"a\">" + box +
                           "</link>" + link("b") + link("c") +
                           joined("j", "revolute", "world", "a") +
                           joined("k", "fixed", "a", "b", "<origin xyz=\"0 0 -0.25\"/>") +
                           joined("l", "fixed", "a", "c", "<origin xyz=\"0 0 1\"/>") + "</robot>";
  const Project two_sided = project_of(both);
  CHECK(two_sided.beam.length().value() == 1.25);
  CHECK(two_sided.placement.start == Vector3d(0, 0, -0.25));
  CHECK(two_sided.placement.axes.col(0) == Vector3d(0, 0, 1));
  // One without extent or mass has a length to be changed.
  CHECK(project_of(both, {}, "b").beam.length().value() == 1.0);
  CHECK_THROWS_WITH(project_of(arm_text, {}, "hand"),
                    Catch::Matchers::Contains("base, upper, fore"));
  CHECK_THROWS_WITH(
      text_of(link("world") + "<link name=\"a\"/>" + joined("j", "fixed", "world", "a"), "world"),
      Catch::Matchers::Contains("no link \"world\" that could be the beam"));
  CHECK_THROWS_WITH(text_of("<link name=\"a\">" + box + "</link>"),
                    Catch::Matchers::Contains("--beam a"));
}

TEST_CASE("names that keys of TOML or points do not take are quoted or changed") {
  const Project project = project_of(
      "<robot name=\"&lt;#1&gt; \xc3\xa4\">" + link("a.b") + "<link name=\"arm &quot;1&quot;\">" +
      box + "</link>" + link("origin") + link("beam_start") + link("\\") +
      joined("base", "fixed", "a.b", "arm &quot;1&quot;") +
      joined("j.1", "revolute", "arm &quot;1&quot;", "origin", "<origin xyz=\"1 0 0\"/>") +
      joined("j_1", "revolute", "arm &quot;1&quot;", "beam_start", "<origin xyz=\"-1 0 0\"/>") +
      joined("origin", "revolute", "origin", "\\") + "</robot>");
  CHECK(project.beam_body == body_index(spatial_of(project), "arm \"1\""));
  CHECK(project.name == "--1-----with-placeholders");
  CHECK(joint(project, "j.1").at.x() - joint(project, "j_1").at.x() == 2.0);
  CHECK(body_index(spatial_of(project), "\\") >= 0);
  const spatial::Joint& last = joint(project, "origin");
  CHECK(spatial_of(project).bodies[static_cast<std::size_t>(last.parent)].name == "origin");
}

TEST_CASE("an inertia that no body has is left out with a warning, other doubts are said") {
  const auto with = [](const std::string& mass, const std::string& moments) {
    return text_of("<link name=\"world\"/><link name=\"a\">" + box +
                   "</link><link name=\"b\"><inertial><mass value=\"" + mass + "\"/><inertia " +
                   moments + "/></inertial></link>" + joined("j", "revolute", "world", "a") +
                   joined("k", "revolute", "a", "b", "<origin xyz=\"1 0 0\"/>"));
  };
  const auto warns = [](const std::string& text, const std::string& words, bool left_out) {
    INFO(text);
    CHECK(contains(text, "# WARNING: " + words));
    const Project project = parse_project("r.toml", text);
    CHECK(spatial_of(project).bodies[body(project, "b")].inertia.isZero(0.0) == left_out);
  };
  warns(with("1", "ixx=\"3\" iyy=\"1\" izz=\"1\""),
        "principal moments 1, 1 and 3 kg m^2: one is above the sum of the other two", true);
  // xy = 2 between moments of 1: 1 - 2 = -1 and 1 + 2 = 3.
  warns(with("1", "ixx=\"1\" iyy=\"1\" izz=\"2\" ixy=\"2\""),
        "principal moments -1, 2 and 3 kg m^2: one is below zero", true);
  warns(with("0", "ixx=\"1\" iyy=\"1\" izz=\"1\""), "a body without mass has no inertia", true);
  warns(with("1", "ixx=\"0\" iyy=\"1\" izz=\"1\""), "principal moments 0, 1 and 1 kg m^2", false);
  warns(with("1", "ixx=\"0\" iyy=\"0\" izz=\"0\""), "no inertia about its centre", true);
  CHECK_FALSE(contains(with("1", "ixx=\"1\" iyy=\"1\" izz=\"2\""), "WARNING"));
}

TEST_CASE("what is too small to be meant is zero, and what is not read is listed") {
  const std::string text = text_of(
      "<material name=\"m\"/><gazebo/><gazebo/>" + link("world") + "<link name=\"a\">" + box +
      "<visual/><collision/><visual/></link>" + link("b") +
      joined("j", "revolute", "world", "a", "<origin xyz=\"1e-17 0 1\" rpy=\"1e-17 0 0\"/>") +
      joined("k", "revolute", "a", "b", "<safety_controller/><dynamics damping=\"7\"/>"));
  CHECK(contains(text, "at = [\"0 m\", \"0 m\", \"1 m\"]"));
  CHECK_FALSE(contains(text, "turn ="));
  for (const char* part : {"<gazebo> (2)", "<material> (1)", "<visual> (2)", "<collision> (1)",
                           "<safety_controller> (1)", "damping = \"7 N m s/rad\""})
    CHECK(contains(text, part));
}

TEST_CASE("what is wrong with a robot is said, with its line") {
  const std::string ab = link("a") + "\n" + link("b") + "\n";
  const auto robot = [](const std::string& inside) {
    return "<robot name=\"r\">\n" + inside + "</robot>\n";
  };
  struct Broken {
    std::string text;
    int line;
    std::string message;
  };
  const std::string j = joined("j", "revolute", "a", "b");
  const std::string deep = [] {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += "<x>";
    return text;
  }();
  const std::vector<Broken> broken{
      {"", 0, "there is no <robot>"},
      {"mass = 1\n", 1, "this is no XML"},
      {"<sdf/>", 0, "there is no <robot>"},
      {"<robot/><robot/>", 0, "there is no <robot>"},
      {"<robot>\n<link name=\"a\"", 2, "what begins here has no end"},
      {"<robot>\n<link name=\"a\">\n</robot>\n", 3, "</robot> closes nothing that is open"},
      {"<robot>\n<link name=a/>\n</robot>\n", 2, "this is no XML"},
      {robot("<link name=\"a\"/>\n<link name=\"\xff\"/>"), 3, "this is no text in UTF-8"},
      {robot(deep), 2, "elements lie too deep in each other"},
      {robot("<xacro:include filename=\"a\"/>"), 2, "this is a xacro file"},
      {robot(link("a") + "\n<link name=\"${b}\"/>"), 3, "this is a xacro file"},
      {robot(""), 0, "the robot has no <link>"},
      {robot("<link/>"), 2, "it has no name"},
      {robot(link("a&#10;b")), 2, "it has no name"},
      {robot(ab + joined("j", "revolute", "a", "c")), 4, "joint \"j\": there is no link \"c\""},
      {robot(ab + "<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/></joint>"), 4,
       "joint \"j\": it has no child"},
      {robot(ab + joined("j", "hinge", "a", "b")), 4, "\"hinge\" is no type of joint"},
      {robot(ab), 3, "link \"b\": no joint carries it, nor link \"a\""},
      {robot(link("a") + ab + j), 2, "another link has this name"},
      {robot(ab + link("c") + "\n" + j + "\n" + joined("j", "fixed", "a", "c")), 6,
       "another joint is called \"j\""},
      {robot(ab + link("c") + "\n" + joined("j", "planar", "a", "b") + "\n" +
             joined("j.2", "fixed", "a", "c")),
       6, "another joint is called \"j.2\""},
      {robot(ab + j + "\n" + joined("k", "fixed", "a", "b")), 5,
       "it carries link \"b\", which joint \"j\" carries already"},
      {robot(ab + link("c") + "\n" + joined("j", "fixed", "c", "b") + "\n" +
             joined("k", "fixed", "b", "c")),
       5, "in a ring"},
      {robot(ab + j + "\n" + joined("k", "fixed", "b", "a")), 5, "in a ring"},
      {robot("<link name=\"a\"><inertial><mass value=\"-1\"/></inertial></link>"), 2,
       "its mass is -1 kg"},
      {robot("<link name=\"a\"><inertial/></link>"), 2, "<inertial> has no mass"},
      {robot("<link name=\"a\"><inertial><mass value=\"1 kg\"/></inertial></link>"), 2,
       "value = \"1 kg\" of <mass> wants a number"},
      {robot("<link name=\"a\"><inertial><mass value=\"inf\"/></inertial></link>"), 2,
       "wants a number"},
      {robot(ab + joined("j", "fixed", "a", "b", "<origin xyz=\"1 2\"/>")), 4,
       "xyz = \"1 2\" of <origin> wants 3 numbers"},
      {robot(ab + joined("j", "fixed", "a", "b", "<origin/><origin/>")), 4,
       "<origin> stands there twice"},
      {robot(ab + joined("j", "prismatic", "a", "b", "<axis xyz=\"0 0 0\"/>")), 4,
       "its axis is no direction"},
      {robot(ab + joined("j", "revolute", "a", "b", "<limit lower=\"2\" upper=\"1\"/>")), 4,
       "its lower limit 2 is above its upper one 1"},
      {robot(ab + joined("j", "revolute", "a", "b", "<mimic joint=\"k\"/>")), 4,
       "it cannot mimic \"k\""},
      {robot(ab + joined("j", "revolute", "a", "b", "<mimic joint=\"j\"/>")), 4,
       "it mimics itself"},
      {robot(link("a") + "\n<link name=\"world\"/>\n" + joined("j", "fixed", "a", "world")), 3,
       "a case calls the fixed world so"},
      {robot("<link name=\"ground\">" + box + "</link>\n" + link("b") +
             joined("j", "fixed", "ground", "b")),
       2, "a case calls the fixed world so"},
  };
  for (const Broken& each : broken) {
    INFO(each.text.substr(0, 400));
    try {
      robots::parse_urdf("r.urdf", each.text);
      FAIL_CHECK("nothing was found wrong");
    } catch (const InputError& error) {
      INFO(std::string(error.what()).substr(0, 1000));
      REQUIRE(error.problems().size() == 1);
      const Problem& problem = error.problems().front();
      CHECK(problem.file == "r.urdf");
      CHECK(problem.line == each.line);
      CHECK(contains(problem.message, each.message));
    }
  }
  CHECK_THROWS_AS(robots::read_urdf("no/such.urdf"), InputError);
}

}  // namespace urdf_test
