// Mechanisms of elastic links as a case writes them. Expected numbers are those of the text, and
// hand formulas of the geometry.

#include <cmath>
#include <limits>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/mechanism.hpp"
#include "boxbeam/project/project.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace read_flexible_test {

using namespace boxbeam;
using Eigen::Vector2d;
using Eigen::Vector3d;
using flexible::LinkKind;

namespace {

const std::string& truck() {
  static const std::string text =
      test::read_file(test::project_file("sections/drill-truck/truck.toml"));
  return text;
}

Project read(const std::vector<std::string>& overrides = {}, const std::string& lines = {}) {
  return parse_project("truck.toml", truck() + lines, overrides);
}

const flexible::Link& link(const Project& project, const std::string& name) {
  for (const flexible::Link& of : flexible_of(project).links) {
    if (of.name == name) return of;
  }
  FAIL("no link " << name);
  return flexible_of(project).links.front();
}

const flexible::Joint& joint(const Project& project, const std::string& name) {
  for (const flexible::Joint& of : flexible_of(project).joints) {
    if (of.name == name) return of;
  }
  FAIL("no joint " << name);
  return flexible_of(project).joints.front();
}

constexpr double slope = 25.0 * std::numbers::pi / 180.0;

}  // namespace

TEST_CASE("links lie where points of others, their own points and their ends put them",
          "[flexible]") {
  const Project project = read();
  REQUIRE(std::holds_alternative<flexible::Mechanism>(project.mechanism));
  CHECK_FALSE(project.in_space);
  const flexible::Mechanism& mechanism = flexible_of(project);
  REQUIRE(mechanism.links.size() == 6);
  CHECK(mechanism.links[1].name == "boom");
  CHECK(project.beam_body == 1);
  const flexible::Link& boom = link(project, "boom");
  CHECK(boom.kind == LinkKind::bending);
  CHECK(boom.origin == Vector2d(0.9, 1.7));
  CHECK(boom.angle == Approx(slope));
  CHECK(boom.length == Approx(4.2));
  CHECK(boom.parts == 8);
  const Vector2d u(std::cos(slope), std::sin(slope));
  const flexible::Link& telescope = link(project, "telescope");
  CHECK((telescope.origin - (boom.origin + 2.6 * u)).norm() < 1e-14);
  const flexible::Link& feed = link(project, "feed");
  CHECK((feed.origin - (telescope.origin + 4.0 * u - Vector2d(1.5, 0.0))).norm() < 1e-14);
  CHECK(feed.length == 5.0);
  const flexible::Link& lift = link(project, "lift");
  const Vector2d to = boom.origin + 1.5 * u - 0.15 * Vector2d(-u.y(), u.x());
  CHECK(lift.kind == LinkKind::axial);
  CHECK(lift.origin == Vector2d(1.5, 1.0));
  CHECK(lift.length == Approx((to - lift.origin).norm()));
  CHECK(lift.angle == Approx(std::atan2(to.y() - 1.0, to.x() - 1.5)));
  CHECK((in_world(mechanism, joint(project, "w7").a) - in_world(mechanism, joint(project, "w7").b))
            .norm() < 1e-12);
}

TEST_CASE("links have the stiffness and mass that is written", "[flexible]") {
  const Project project = read();
  const flexible::Link& chassis = link(project, "chassis");
  CHECK(chassis.kind == LinkKind::rigid);
  CHECK(chassis.rigid.mass == 9000.0);
  CHECK(chassis.rigid.inertia == 18000.0);
  CHECK(chassis.rigid.centre == Vector2d(0.0, 1.0));
  const flexible::LinkStretch& lift = link(project, "lift").stretches.front();
  CHECK(lift.EA(0.3) == 1.2e8);
  CHECK(lift.mass(0.3) == 40.0);
  const flexible::LinkStretch& feed = link(project, "feed").stretches.front();
  const double area = 0.24 * 0.16 - 0.224 * 0.144;
  CHECK(feed.length == 5.0);
  CHECK(feed.EA(2.0) == Approx(2.1e11 * area));
  CHECK(feed.GA(2.0) == Approx(8.1e10 * 2.0 * 0.008 * 0.24));
  CHECK(feed.EI(2.0) ==
        Approx(2.1e11 * (0.16 * std::pow(0.24, 3) - 0.144 * std::pow(0.224, 3)) / 12.0));
  CHECK(feed.mass(2.0) == Approx(7850.0 * area + 60.0));
  const Project tapered =
      read({"links.feed.density=8 t/m^3", "links.feed.rotary_inertia=true",
            "links.feed.youngs_modulus=70 GPa", "links.telescope.damping=1 ms"});
  CHECK(link(tapered, "feed").stretches.front().EA(2.0) == Approx(7e10 * area));
  CHECK(link(tapered, "feed").stretches.front().mass(2.0) == Approx(8000.0 * area + 60.0));
  CHECK(link(tapered, "feed").stretches.front().rotary(2.0) > 0.0);
  CHECK(link(tapered, "telescope").retardation == 1e-3);
}

TEST_CASE("a link may be of segments, of a taper, or rigid with a profile's mass", "[flexible]") {
  std::string text = truck();
  const std::string old = "length = \"4 m\"\nparts = 8\nsection = \"telescope\"\n";
  REQUIRE(text.find(old) != std::string::npos);
  text.replace(text.find(old), old.size(),
               "segments = [ { length = \"1 m\", section = \"boom\" }, { length = \"3 m\", from = "
               "\"boom\", to = \"telescope\" } ]\n");
  const Project project = parse_project("truck.toml", text);
  const flexible::Link& telescope = link(project, "telescope");
  CHECK(telescope.length == 4.0);
  REQUIRE(telescope.stretches.size() == 2);
  CHECK(telescope.stretches[1].start == 1.0);
  CHECK(telescope.stretches[1].GA(3.0) == Approx(8.1e10 * 2.0 * 0.01 * 0.26));
  const double boom_area = 0.3 * 0.22 - 0.28 * 0.2, area = 0.26 * 0.18 - 0.24 * 0.16;
  CHECK(telescope.stretches[1].mass(3.0) == Approx(7850.0 * area));

  const Project rigid = read({"links.boom.kind=rigid", "links.lift.kind=rigid"});
  CHECK(link(rigid, "boom").stretches.empty());
  CHECK(link(rigid, "boom").rigid.mass == Approx(7850.0 * boom_area * 4.2));
  CHECK(link(rigid, "boom").rigid.centre.x() == Approx(2.1));
  CHECK(link(rigid, "boom").rigid.inertia == Approx(7850.0 * boom_area * 4.2 * 4.2 * 4.2 / 12.0));
  const double length = link(rigid, "lift").length;
  CHECK(link(rigid, "lift").rigid.mass == Approx(40.0 * length));
}

TEST_CASE("joints hold along their axes as is written", "[flexible]") {
  const Project project = read();
  const flexible::Joint& front = joint(project, "front_axle");
  CHECK(front.b.link == flexible::ground);
  CHECK(front.b.p == Vector2d(-1.6, 0.5));
  CHECK(front.stiffness == std::array{5e6, 4e6, 0.0});
  CHECK(joint(project, "rear_axle").stiffness == std::array{0.0, 4e6, 0.0});
  CHECK(joint(project, "w8").stiffness == std::array{3e8, 3e8, 0.0});
  CHECK(joint(project, "w8").angle == 0.0);
  const flexible::Joint& P2 = joint(project, "P2");
  CHECK(P2.angle == Approx(slope));
  CHECK(P2.stiffness == std::array{1e8, 2e8, 0.0});
  CHECK(joint(project, "P1").stiffness == std::array{0.0, 2e8, 0.0});
  const Project other =
      read({"joints.w8.stiffness=rigid", "joints.w8.damping=[\"1 kN s/m\", \"2 kN s/m\"]",
            "joints.w8.turning_stiffness=5 kN m", "joints.P1.normal_damping=3 kN s/m"});
  const double infinite = std::numeric_limits<double>::infinity();
  CHECK(joint(other, "w8").stiffness == std::array{infinite, infinite, 5e3});
  CHECK(joint(other, "w8").damping == std::array{1e3, 2e3, 0.0});
  CHECK(joint(other, "P1").damping == std::array{0.0, 3e3, 0.0});
}

TEST_CASE("loads, frequency and model are as is written", "[flexible]") {
  const Project project = read({"loads.drill.phase=90 deg"});
  const flexible::Mechanism& mechanism = flexible_of(project);
  REQUIRE(mechanism.loads.size() == 1);
  const flexible::Load& load = mechanism.loads.front();
  CHECK(load.constant == Vector3d(-12000.0, -3000.0, 0.0));
  CHECK(load.amplitude == Vector3d(4000.0, 1500.0, 500.0));
  CHECK(load.phase == Approx(0.5 * std::numbers::pi));
  CHECK(load.at.p == Vector2d(5.0, 0.0));
  CHECK(mechanism.frequency == 25.0);
  CHECK(mechanism.gravity == Vector2d(0.0, -9.81));
  CHECK(mechanism.element == flexible::Element::corrected);
  CHECK(mechanism.nodes_at_joints);
  CHECK(project.model.demand == ModelDemand::automatic);
  CHECK(project.model.tolerance == 0.01);

  // tau = 2 zeta/(2 pi f).
  const Project other =
      read({"model.element=classical", "model.division=equal", "model.demand=flexible",
            "model.tolerance=0.05", "model.damping={ratio = 0.02, at = \"10 Hz\"}",
            "links.lift.damping=0 s"});
  CHECK(flexible_of(other).element == flexible::Element::classical);
  CHECK_FALSE(flexible_of(other).nodes_at_joints);
  CHECK(other.model.demand == ModelDemand::flexible);
  CHECK(other.model.tolerance == 0.05);
  CHECK(link(other, "boom").retardation == Approx(0.04 / (20.0 * std::numbers::pi)));
  CHECK(other.model.retardation == link(other, "boom").retardation);
  CHECK(link(other, "lift").retardation == 0.0);

  std::string exact = truck();
  const std::string corrected = "\"corrected\"";
  exact.replace(exact.find(corrected), corrected.size(), "\"exact\"");
  CHECK(flexible_of(parse_project("truck.toml", exact, {})).element == flexible::Element::exact);
}

TEST_CASE("points of the beam's link are places of the beam", "[flexible]") {
  const Project project = read();
  REQUIRE(project.beam.points.size() == 2);
  CHECK(project.beam.points[0].name == "lift");
  CHECK(project.beam.points[0].s.value() == 1.5);
  CHECK(project.beam.points[1].s.value() == 2.6);
  CHECK(project.material.name == "S355");
}

TEST_CASE("situations change how links are modelled, held and loaded", "[flexible]") {
  std::string text = truck();
  // Two situations in the place of the case's own.
  text.erase(text.find("[[situations]]"));
  text +=
      "[[situations]]\nname = \"drilling\"\ncycles = 5e7\n"
      "[[situations]]\nname = \"jammed\"\ncycles = 1e4\n"
      "set = { \"loads.drill.amplitude_force\" = [\"9 kN\", \"0 N\"], \"motion.frequency\" = "
      "\"3 Hz\", \"links.boom.kind\" = \"full\", \"links.feed.parts\" = 20, "
      "\"joints.P1.normal\" = \"50 MN/m\" }\n";
  const Project project = parse_project("truck.toml", text);
  REQUIRE(project.situations.size() == 2);
  CHECK_FALSE(project.situations[0].changed);
  const flexible::Mechanism& jammed = flexible_in(project, project.situations[1]);
  CHECK(jammed.loads.front().amplitude.x() == 9000.0);
  CHECK(jammed.frequency == 3.0);
  CHECK(jammed.links[1].kind == LinkKind::full);
  CHECK(jammed.links[4].parts == 20);
  CHECK(jammed.joints.back().stiffness[1] == 5e7);
  CHECK(flexible_of(project).joints.back().stiffness[1] == 2e8);
}

TEST_CASE("a planar case may say which model it wants", "[flexible]") {
  const std::string path = test::project_file("sections/sledge-rig/rig.toml");
  const Project project =
      read_project(path, {"model.demand=rigid", "model.tolerance=0.002",
                          "model.youngs_modulus=200 GPa", "model.damping=0.1 ms"});
  CHECK(project.model.demand == ModelDemand::rigid);
  CHECK(project.model.tolerance == 0.002);
  CHECK(project.model.youngs_modulus == 2e11);
  CHECK(project.model.shear_modulus == 8.1e10);
  CHECK(project.model.retardation == Approx(1e-4));
}

}  // namespace read_flexible_test
