#include <numbers>

#include "project/small_case.hpp"

namespace read_joints_test {

// Points are written in the axes of the drawing and stand from the centre of mass when read: the
// arm's centre lies 0.5 m from A, the rod's 0.5 m from P.
using namespace small_case;
using namespace boxbeam::planar;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

Slider slider(const std::string& lines) {
  return joint<Slider>("[joints.X]\nkind = \"slider\"\n" + lines);
}

}  // namespace

TEST_CASE("a pin joins two bodies, or a body and a point of the ground") {
  const Pin two = joint<Pin>("[joints.X]\nkind = \"pin\"\nconnect = [\"arm.B\", \"rod.P\"]\n");
  CHECK(at(two.a, arm, 0.5, 0.0));
  CHECK(at(two.b, rod, -0.5, 0.0));
  const Pin one = joint<Pin>(
      "[joints.X]\nkind = \"pin\"\nconnect = [\"ground\", \"rod.Q\"]\nat = [\"3 m\", \"4 m\"]\n");
  CHECK(at(one.a, ground, 3.0, 4.0));
  CHECK(at(one.b, rod, 1.5, 0.0));
}

TEST_CASE("a pin with clearance is a contact of its points") {
  const std::string pin =
      "[joints.X]\nkind = \"pin\"\nconnect = [\"arm.B\", \"rod.P\"]\nclearance = \"0.2 mm\"\n";
  const std::string contact = "contact_stiffness = \"500 kN/mm\"\nrestitution = 0.7\n";
  const auto loose = [&](const std::string& lines) {
    const Mechanism mechanism =
        boxbeam::planar_of(read(pivot + pin + contact + lines + for_a_second));
    CHECK(mechanism.joints.size() == 1);
    REQUIRE(mechanism.forces.size() == 1);
    CHECK(mechanism.forces[0].name == "X");
    return std::get<PinWithClearance>(mechanism.forces[0].kind);
  };
  const PinWithClearance middle = loose("");
  CHECK(at(middle.a, arm, 0.5, 0.0));
  CHECK(at(middle.b, rod, -0.5, 0.0));
  CHECK(middle.clearance == Approx(0.2e-3).epsilon(1e-14));
  CHECK(middle.stiffness == Approx(500e6).epsilon(1e-14));
  CHECK(middle.impact.restitution == 0.7);
  CHECK(middle.start.isZero(0.0));
  const PinWithClearance below = loose("start_offset = [\"0 mm\", \"-0.2 mm\"]\n");
  CHECK(below.start.y() == Approx(-0.2e-3).epsilon(1e-14));

  struct Broken {
    std::string lines;
    const char *message, *hint;
  };
  const std::string fits = "[joints.X]\nkind = \"pin\"\nconnect = [\"arm.B\", \"rod.P\"]\n";
  for (const Broken& of : {
           Broken{pin + "restitution = 0.7\n", "wants the stiffness of its contact", "pi E* L/9"},
           Broken{pin + contact + "start_offset = [\"0 mm\", \"0.4 mm\"]\n",
                  "begins outside of its bearing", "at most the clearance"},
           Broken{pin + contact + "stiffness = \"1 kN/mm\"\n", "is of a pin that fits",
                  "contact_stiffness"},
           Broken{fits + "restitution = 0.7\n", "is of a joint with clearance",
                  "clearance = \"0.2 mm\""},
           Broken{fits + "start_offset = [\"0 mm\", \"0 mm\"]\n", "begins where it is",
                  "clearance = \"0.2 mm\""},
           Broken{pin + contact +
                      "[forces.X]\nkind = \"couple\"\npoints = [\"arm.A\"]\n"
                      "size = \"1 N m\"\n",
                  "\"X\" is already the name of a joint", "another name"},
       }) {
    CAPTURE(of.lines);
    const boxbeam::Problem problem = problem_of(pivot + of.lines + for_a_second);
    CHECK(contains(problem.message, of.message));
    CHECK(contains(problem.hint, of.hint));
  }
}

TEST_CASE("a slider runs on a line of the ground or of a body") {
  const Slider on_ground = slider(
      "point = \"rod.P\"\nthrough = [\"1 m\", \"2 m\"]\ndirection = \"30 deg\"\nangle = \"90 "
      "deg\"\n");
  CHECK(at(on_ground.point, rod, -0.5, 0.0));
  CHECK(at(on_ground.guide, ground, 1.0, 2.0));
  CHECK(on_ground.direction == Approx(30.0 * degree).epsilon(1e-14));
  CHECK(on_ground.angle == Approx(90.0 * degree).epsilon(1e-14));

  // The point of the guide moves to the centre of its body; the direction stays in its axes.
  const Slider on_body = slider("point = \"wheel.C\"\nguide = \"rod.Q\"\ndirection = \"30 deg\"\n");
  CHECK(at(on_body.point, wheel, 0.0, 0.0));
  CHECK(at(on_body.guide, rod, 1.5, 0.0));
  CHECK(on_body.direction == Approx(30.0 * degree).epsilon(1e-14));
  CHECK(on_body.angle == 0.0);

  const Slider moving_guide = slider(
      "point = \"ground\"\nat = [\"1 m\", \"2 m\"]\nguide = \"rod.Q\"\ndirection = \"0 deg\"\n");
  CHECK(at(moving_guide.point, ground, 1.0, 2.0));
  CHECK(at(moving_guide.guide, rod, 1.5, 0.0));
}

TEST_CASE("friction of a slider: given values, and what is not given as in the struct") {
  const std::string line =
      "point = \"rod.P\"\nthrough = [\"0 m\", \"0 m\"]\ndirection = \"0 deg\"\n";
  const Friction none = slider(line).friction;
  CHECK(none.coulomb == 0.0);
  CHECK(none.viscous == 0.0);
  const Friction some = slider(line + "friction = { coefficient = 0.1 }\n").friction;
  CHECK(some.coulomb == 0.1);
  CHECK(some.viscous == Friction{}.viscous);
  CHECK(some.creep == 0.0);  // forces move it: it sticks
  CHECK(some.guide == Friction{}.guide);
  CHECK(some.standing == 0.0);
  CHECK(slider(line + "friction = { coefficient = 0.1, static_coefficient = 0.2 }\n")
            .friction.standing == 0.2);
  CHECK(contains(
      problem_of("[joints.X]\nkind = \"slider\"\n" + line +
                 "friction = { coefficient = 0.3, static_coefficient = 0.2 }\n" + for_a_second)
          .message,
      "at least the coefficient of what slides"));
  const Friction all = slider(line +
                              "[joints.X.friction]\ncoefficient = 2\nviscous = \"0.5 kN s/m\"\n"
                              "creep = \"2 mm/s\"\nguide_length = \"200 mm\"\n")
                           .friction;
  CHECK(all.coulomb == 2.0);
  CHECK(all.viscous == Approx(500.0).epsilon(1e-14));
  CHECK(all.creep == Approx(0.002).epsilon(1e-14));
  CHECK(all.guide == Approx(0.2).epsilon(1e-14));
}

TEST_CASE("a pin in a slot is a slider that may turn") {
  const auto slot = joint<PinInSlot>(
      "[joints.X]\nkind = \"pin in slot\"\npoint = \"arm.B\"\nguide = \"rod.P\"\n"
      "direction = \"-10 deg\"\nfriction = { viscous = \"3 N s/m\" }\n");
  CHECK(at(slot.point, arm, 0.5, 0.0));
  CHECK(at(slot.guide, rod, -0.5, 0.0));
  CHECK(slot.direction == Approx(-10.0 * degree).epsilon(1e-14));
  CHECK(slot.friction.viscous == 3.0);
  const std::string angle =
      "[joints.X]\nkind = \"pin in slot\"\npoint = \"arm.B\"\nguide = \"rod.P\"\n"
      "direction = \"0 deg\"\nangle = \"0 deg\"\n";
  CHECK(contains(problem_of(angle + for_a_second).message, "unknown key \"angle\""));
}

TEST_CASE("a rigid joint keeps an angle, a distance a length") {
  const auto rigid = joint<Rigid>(
      "[joints.X]\nkind = \"rigid\"\nconnect = [\"arm.B\", \"rod.P\"]\nangle = \"-90 deg\"\n");
  CHECK(at(rigid.a, arm, 0.5, 0.0));
  CHECK(at(rigid.b, rod, -0.5, 0.0));
  CHECK(rigid.angle == Approx(-90.0 * degree).epsilon(1e-14));
  const auto clamped = joint<Rigid>(
      "[joints.X]\nkind = \"rigid\"\nconnect = [\"rod.P\", \"ground\"]\nat = [\"1 m\", \"0 m\"]\n");
  CHECK(at(clamped.b, ground, 1.0, 0.0));
  CHECK(clamped.angle == 0.0);
  const auto distance = joint<Distance>(
      "[joints.X]\nkind = \"distance\"\nconnect = [\"arm.B\", \"ground\"]\nat = [\"0 m\", \"2 "
      "m\"]\n"
      "length = \"1500 mm\"\n");
  CHECK(at(distance.a, arm, 0.5, 0.0));
  CHECK(at(distance.b, ground, 0.0, 2.0));
  CHECK(distance.length == Approx(1.5).epsilon(1e-14));
}

TEST_CASE("an angle coupling of either sense, between bodies or to the ground") {
  const auto gearbox = joint<AngleCoupling>(
      "[joints.X]\nkind = \"angle coupling\"\npoints = [\"arm.A\", \"wheel.C\"]\nratio = -2.5\n"
      "offset = \"180 deg\"\n");
  CHECK(at(gearbox.a, arm, -0.5, 0.0));
  CHECK(at(gearbox.b, wheel, 0.0, 0.0));
  CHECK(gearbox.ratio == -2.5);
  CHECK(gearbox.offset == Approx(180.0 * degree).epsilon(1e-14));
  const auto held = joint<AngleCoupling>(
      "[joints.X]\nkind = \"angle coupling\"\npoints = [\"arm.A\", \"ground\"]\n");
  CHECK(held.b.body == ground);
  CHECK(held.ratio == 1.0);
}

TEST_CASE("gears and racks with signed radii") {
  const auto gear = joint<Gear>(
      "[joints.X]\nkind = \"gear\"\nconnect = [\"wheel.C\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
      "radii = [\"0.1 m\", \"-0.3 m\"]\n");
  CHECK(at(gear.a, wheel, 0.0, 0.0));
  CHECK(at(gear.b, ground, 0.0, 0.0));
  CHECK(gear.radius_a == 0.1);
  CHECK(gear.radius_b == -0.3);
  CHECK(gear.offset == 0.0);
  const auto rack = joint<Rack>(
      "[joints.X]\nkind = \"rack\"\npinion = \"wheel.C\"\nrack = \"rod.Q\"\n"
      "direction = \"90 deg\"\nradius = \"-200 mm\"\noffset = \"0.25 m\"\n");
  CHECK(at(rack.pinion, wheel, 0.0, 0.0));
  CHECK(at(rack.rack, rod, 1.5, 0.0));
  CHECK(rack.direction == Approx(90.0 * degree).epsilon(1e-14));
  CHECK(rack.radius == Approx(-0.2).epsilon(1e-14));
  CHECK(rack.offset == 0.25);
  const auto fixed = joint<Rack>(
      "[joints.X]\nkind = \"rack\"\npinion = \"wheel.C\"\nrack = \"ground\"\n"
      "at = [\"0 m\", \"1 m\"]\ndirection = \"0 deg\"\nradius = \"0.2 m\"\n");
  CHECK(at(fixed.rack, ground, 0.0, 1.0));
}

TEST_CASE("joints that determine the motion more than once are read") {
  // The arm held twice: what is redundant is for the analysis to say.
  const std::string again =
      "[joints.again]\nkind = \"pin\"\nconnect = [\"arm.A\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
      "[joints.held]\nkind = \"rigid\"\nconnect = [\"rod.P\", \"ground\"]\nat = [\"0 m\", \"0 "
      "m\"]\n"
      "[joints.also]\nkind = \"rigid\"\nconnect = [\"wheel.C\", \"rod.P\"]\n"
      "[drivers.turn]\nkind = \"constant rate\"\npoint = \"arm.A\"\ncoordinate = \"angle\"\n"
      "start = \"0 deg\"\nrate = \"6 rpm\"\n";
  const Mechanism mechanism = planar_of(read(pivot + again));
  CHECK(mechanism.equations() == mechanism.coordinates() + 2);
}

TEST_CASE("a mechanism of too few equations wants a duration") {
  const boxbeam::Problem problem = problem_of(
      pivot +
      "[drivers.turn]\nkind = \"constant rate\"\npoint = \"arm.A\"\ncoordinate = \"angle\"\n"
      "start = \"0 deg\"\nrate = \"6 rpm\"\n");
  CHECK(contains(problem.message, "9 coordinates, joints and drivers give 3 equations"));
  CHECK(contains(problem.hint, "6 more equations are wanted"));
  CHECK(contains(problem.hint, "[motion]"));
  const Mechanism free =
      planar_of(read(pivot + "[motion]\nduration = \"4 s\"\nsettle = \"500 ms\"\n"));
  CHECK(free.duration.length == 4.0);
  CHECK(free.duration.settle == 0.5);
}

}  // namespace read_joints_test
