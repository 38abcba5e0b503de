// What closes loops in space, meshes, rubs or has clearance, as a case writes it. Expected numbers
// are those of the text, and hand formulas of the loops.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "project/small_chain.hpp"

namespace read_loops_test {

using namespace boxbeam;
using namespace small_chain;
using Eigen::Vector3d;

TEST_CASE("joints that close loops leave free what nothing drives, from near its start") {
  const std::string loop =
      heel("revolute") +
      "axis = \"y\"\n"
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
  const Project series =
      read(heel("cylindrical") +
           "axis = \"y\"\n"
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
  const boxbeam::Project project =
      read(heel("revolute") +
           "axis = \"y\"\n"
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
  const Project project =
      read(heel("screw") +
           "axis = \"x\"\n"
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

}  // namespace read_loops_test
