// Rods without mass that are elastic beside the beam of a mechanism in space: closed forms, cases
// of the plane written in space, and rods and joints of no flexibility, which are rigid ones.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <string>

#include "boxbeam/verification/elastic_beside.hpp"
#include "boxbeam/verification/elastic_motion.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "catch.hpp"
#include "src/verification/elastic_motion_in_space.hpp"
#include "src/verification/vibration_in_space.hpp"
#include "support/lever_in_space.hpp"
#include "support/refusals.hpp"

namespace elastic_rods_in_space_test {

using namespace boxbeam;
using namespace test::lever_in_space;
using Eigen::Vector3d;
using test::space_arm::check_alike;
using test::space_arm::Cuts;
using test::space_arm::cuts_of;

// EI (z/L)^3 (sin z coth z - cos z) = 2 k sin z: an even beam on a hinge with a spring at its end,
// w = sin(z x/L) + sin z/sinh z sinh(z x/L), EI w''' = k w there.
TEST_CASE("a beam on a hinge and a rod in space vibrates as on a spring EA/l",
          "[elastic_rods_in_space]") {
  for (const double side : {0.0005, 0.002, 0.01}) {
    Scene scene;
    scene.side = side;
    hold_by_link(scene, {L, 0.0, -2.0});
    const Moved of = moved(scene, without_shear);
    const double k = E * side * side / 2.0;
    const std::vector<double> z = roots_of(
        [&](double at) {
          return E * I * std::pow(at / L, 3) * (std::sin(at) / std::tanh(at) - std::cos(at)) -
                 2.0 * k * std::sin(at);
        },
        3);
    const std::vector<double> found = of.in_plane(32, 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CAPTURE(side, i);
      CHECK(found[i] ==
            Approx(std::pow(z[i] / L, 2) * std::sqrt(E * I / (rho * A)) / (2 * pi)).epsilon(2e-5));
    }
  }
}

// The restoring moment k L^2 phi of a rod across the end of a stiff lever against P L phi: k L.
TEST_CASE("a stiff lever in space on an elastic rod buckles at k L", "[elastic_rods_in_space]") {
  constexpr double P = 1.0, side = 7e-5;
  Scene scene;
  scene.side = side;
  hold_by_link(scene, {L, 0.0, -2.0});
  scene.forces = fmt::format(
      "[forces.push]\nkind = \"force\"\npoint = \"lever.B\"\naxes = \"base\"\n"
      "direction = \"-x\"\nsize = \"{} N\"\n",
      P);
  const double k = E * side * side / 2.0;
  CHECK(moved(scene, stiff_lever).critical_factor() == Approx(k * L / P).epsilon(3e-3));
}

namespace {

/// A shoe that a driver moves up and down below the lever's end.
void drive_shoe(Scene& scene, double x, const std::string& driver, const std::string& keys = "") {
  scene.moves = true;
  scene.bodies +=
      "[bodies.shoe]\nmass = \"5 kg\"\npoints = { S = [\"0 m\", \"0 m\", \"0 m\"] }\n"
      "[bodies.post]\npoints = { O = [\"0 m\", \"0 m\", \"0 m\"], F = " +
      vector({x, 0.0, 0.0}, "m") + " }\n";
  scene.joints +=
      "[joints.post]\nkind = \"fixed\"\nconnect = [\"base.O\", \"post.O\"]\n"
      "[joints.guide]\nkind = \"prismatic\"\nconnect = [\"post.F\", \"shoe.S\"]\naxis = \"z\"\n" +
      keys;
  scene.drivers += "[drivers.shake]\njoint = \"guide\"\n" + driver;
}

double moment_at(const BeamLoads& loads, double s) {
  return cut_forces_of(loads).at({si<Length>(s), Side::behind}).M_y.value();
}

}  // namespace

// m = M/3 at its end: the end follows the shoe as (k + i c w)/(k - m w^2 + i c w), and what bends
// the lever follows its end. Timoshenko, Young, Weaver, Vibration Problems in Engineering (1974),
// section 1.10. What rigid bodies miss: 1/(1 - r^2) - 1.
TEST_CASE("a lever in space that is shaken by way of a stay with a damper",
          "[elastic_rods_in_space]") {
  using Complex = std::complex<double>;
  constexpr double k = 400.0;
  for (const auto& [r, zeta] : {std::pair(0.3, 0.0), std::pair(0.7, 0.1), std::pair(1.0, 0.2)}) {
    Scene scene;
    const double m = M / 3.0, omega = r * std::sqrt(k / m), c = 2.0 * zeta * std::sqrt(k * m);
    drive_shoe(scene, L,
               fmt::format("kind = \"harmonic\"\nmean = \"-2 m\"\namplitude = \"0.0002 m\"\n"
                           "angular_frequency = \"{:.17g} rad/s\"\n",
                           omega));
    scene.joints +=
        "[joints.stay]\nkind = \"distance\"\nconnect = [\"shoe.S\", \"lever.B\"]\n"
        "length = \"2 m\"\n" +
        stiffness(k, c);
    const Moved of = moved(scene, stiff_lever);
    const ElasticMotionInSpace motion = of.by(1, 8);
    const Complex follows = Complex(k, c * omega) / Complex(k - m * omega * omega, c * omega) *
                            moment_at(of.rigid().loads_at(of.at(0.25)), 0.5 * L);
    for (const double part : {0.1, 0.25, 0.7}) {
      CAPTURE(r, zeta, part);
      CHECK(moment_at(motion.loads_at(of.at(part)), 0.5 * L) ==
            Approx((follows * std::polar(1.0, 2 * pi * part)).imag())
                .margin(3e-3 * std::abs(follows)));
    }
    if (zeta > 0.0) continue;
    CHECK(estimate_vibration_in_space(of.project, of.runs.front()).estimate.without_modes.front() ==
          Approx(r * r / (1.0 - r * r)).epsilon(5e-3));
  }
}

namespace {

const std::string shaking =
    "kind = \"harmonic\"\nmean = \"0.2 m\"\namplitude = \"0.05 m\"\nfrequency = \"1.1 Hz\"\n";
/// So small a motion that the posture stays and no axial force counts.
const std::string slightly =
    "kind = \"harmonic\"\nmean = \"0.2 m\"\namplitude = \"0.000001 m\"\nfrequency = \"3 Hz\"\n";
const std::string lifting =
    "kind = \"smooth step\"\nfrom = \"0.2 m\"\nto = \"0.4 m\"\nend = \"0.8 s\"\n";

/// The lever at 30 deg, loaded at its end and moved by a shoe by way of an inclined rod, in the
/// plane x z.
Scene in_the_plane(bool body, const std::string& driver, bool loaded = true) {
  Scene scene;
  scene.gravity = loaded ? 9.81 : 0.0;
  scene.hinge += "start = \"30 deg\"\n";
  const Eigen::Vector2d end(L * std::cos(pi / 6), L * std::sin(pi / 6)), foot(3.0, 0.2);
  const double l = (end - foot).norm();
  drive_shoe(scene, foot.x(), driver);
  if (body) {
    scene.side = 0.03;
    const Eigen::Vector2d line = (foot - end) / l;
    // Angle of the rod's x from that of the lever, positive upwards, about -y.
    const double angle = std::atan2(line.y(), line.x()) - pi / 6;
    scene.bodies += fmt::format(
        "[bodies.stay]\nmass = \"12 kg\"\ncentre = [\"{0:.17g} m\", \"0 m\", \"0 m\"]\n"
        "inertia = [\"0 kg m^2\", \"{1:.17g} kg m^2\", \"{1:.17g} kg m^2\"]\n"
        "points = {{ Q = [\"0 m\", \"0 m\", \"0 m\"], P = [\"{2:.17g} m\", \"0 m\", \"0 m\"] }}\n",
        0.5 * l, l * l, l);
    scene.joints += fmt::format(
        "[joints.head]\nkind = \"revolute\"\naxis = \"-y\"\nconnect = [\"lever.B\", \"stay.Q\"]\n"
        "start = \"{:.17g} rad\"\n"
        "[joints.foot]\nkind = \"slot\"\nconnect = [\"shoe.S\", \"stay.P\"]\naxis = \"y\"\n",
        angle);
    scene.rod =
        "[[rods]]\nname = \"stay\"\nfrom = \"stay.Q\"\nto = \"stay.P\"\nsection = \"bar\"\n"
        "curve = \"c\"\n";
  } else {
    scene.joints += fmt::format(
        "[joints.stay]\nkind = \"distance\"\nconnect = [\"shoe.S\", \"lever.B\"]\n"
        "length = \"{:.17g} m\"\n",
        l);
    scene.rod = "[[rods]]\nname = \"stay\"\nlink = \"stay\"\nsection = \"bar\"\ncurve = \"c\"\n";
  }
  if (loaded)
    scene.forces =
        "[forces.across]\nkind = \"force\"\npoint = \"lever.B\"\ndirection = \"-x\"\nsize = \"150 "
        "N\"\n[forces.down]\nkind = \"force\"\npoint = \"lever.B\"\ndirection = \"-z\"\nsize = "
        "\"400 N\"\n";
  return scene;
}

/// The same written in the plane.
std::string of_the_plane(bool body, const std::string& driver, double side, bool loaded) {
  const Eigen::Vector2d end(L * std::cos(pi / 6), L * std::sin(pi / 6)), foot(3.0, 0.2);
  const Eigen::Vector2d line = foot - end, middle = 0.5 * (end + foot);
  const double l = line.norm();
  std::string text =
      "[case]\nname = \"lever\"\nkind = \"planar\"\n[mechanism]\n" +
      fmt::format("gravity = [\"0 m/s^2\", \"{} m/s^2\"]\n", loaded ? -9.81 : 0.0) +
      "[bodies.lever]\npoints = { A = [\"0 m\", \"0 m\"], B = [\"4 m\", \"0 m\"] }\n"
      "sketch = { at = [\"0 m\", \"0 m\"], angle = \"30 deg\" }\n"
      "[bodies.shoe]\nmass = \"5 kg\"\npoints = { S = [\"0 m\", \"0 m\"] }\n"
      "sketch = { at = [\"3 m\", \"0.2 m\"] }\n"
      "[joints.hinge]\nkind = \"pin\"\nconnect = [\"lever.A\", \"ground\"]\nat = [\"0 m\", \"0 "
      "m\"]\n[joints.guide]\nkind = \"slider\"\npoint = \"shoe.S\"\nthrough = [\"3 m\", \"0 m\"]\n"
      "direction = \"90 deg\"\nangle = \"-90 deg\"\n"
      "[drivers.shake]\ncoordinate = \"y\"\npoint = \"shoe.S\"\n" +
      driver;
  std::string rod;
  if (body) {
    text += fmt::format(
        "[bodies.stay]\nmass = \"12 kg\"\ninertia = \"{0:.17g} kg m^2\"\npoints = {{ Q = "
        "[\"{1:.17g} m\", \"0 m\"], P = [\"{2:.17g} m\", \"0 m\"] }}\nsketch = {{ at = [\"{3:.17g} "
        "m\", \"{4:.17g} m\"], angle = \"{5:.17g} rad\" }}\n"
        "[joints.head]\nkind = \"pin\"\nconnect = [\"stay.Q\", \"lever.B\"]\n"
        "[joints.foot]\nkind = \"pin\"\nconnect = [\"stay.P\", \"shoe.S\"]\n",
        l * l, -0.5 * l, 0.5 * l, middle.x(), middle.y(), std::atan2(line.y(), line.x()));
    rod =
        "[[rods]]\nname = \"stay\"\nfrom = \"stay.Q\"\nto = \"stay.P\"\nsection = \"bar\"\n"
        "curve = \"c\"\n";
  } else {
    text += fmt::format(
        "[joints.stay]\nkind = \"distance\"\nconnect = [\"lever.B\", \"shoe.S\"]\n"
        "length = \"{:.17g} m\"\n",
        l);
    rod = "[[rods]]\nname = \"stay\"\nlink = \"stay\"\nsection = \"bar\"\ncurve = \"c\"\n";
  }
  if (loaded)
    text +=
        "[forces.across]\nkind = \"force\"\npoint = \"lever.B\"\ndirection = \"0 deg\"\nsize = "
        "\"-150 N\"\n[forces.down]\nkind = \"force\"\npoint = \"lever.B\"\ndirection = \"90 "
        "deg\"\nsize = \"-400 N\"\n";
  return text +
         "[sections.box]\nkind = \"box\"\nwidth = \"60 mm\"\nheight = \"80 mm\"\n"
         "flange = \"4 mm\"\nweb = \"4 mm\"\n" +
         fmt::format("[sections.bar]\nkind = \"plate\"\nwidth = \"{0} m\"\nheight = \"{0} m\"\n",
                     side) +
         "[beam]\nbody = \"lever\"\ndensity = \"7850 kg/m^3\"\n[[beam.segments]]\nlength = \"4 "
         "m\"\nsection = \"box\"\n[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n" +
         rod;
}

}  // namespace

// The same lever and rod as chains of rigid finite elements of the plane and by pieces in space, in
// a motion so small that the posture stays; what is estimated is relative.
TEST_CASE("a lever of the plane on an elastic rod has its frequencies and its estimate in space",
          "[elastic_rods_in_space]") {
  for (const bool body : {false, true}) {
    CAPTURE(body);
    const Scene scene = in_the_plane(body, slightly, false);
    const Project plane =
        parse_project("plane.toml", of_the_plane(body, slightly, scene.side, false));
    const std::deque<SituationRun> runs = run_situations(plane);
    const LoadHistory& of_plane = runs.front().loads;
    const RigidMotion motion{&planar_of(plane), &planar_motion_of(runs.front()), &plane.beam,
                             [&](Time time) { return of_plane.loads_at(time); }};
    const VibrationEstimate expected =
        estimate_vibration(motion, elastic_body_of(plane, 128), of_plane);
    const Moved of = moved(scene);
    REQUIRE(elastic_beside_text(of.project) == " (stay elastic as well)");
    // The loads of the rigid motion are the same.
    for (const double part : {0.1, 0.6}) {
      CHECK(moment_at(of.rigid().loads_at(of.at(part)), 2.0) ==
            Approx(moment_at(of_plane.loads_at(of_plane.begin() + part * of_plane.period()), 2.0))
                .epsilon(1e-6));
    }
    const std::vector<double> found = of.in_plane(32, 2);
    for (std::size_t i = 0; i < 2; ++i) {
      CAPTURE(i);
      CHECK(found[i] == Approx(expected.frequencies[i]).epsilon(i == 0 ? 1e-5 : 5e-5));
    }
    const VibrationInSpace estimate = estimate_vibration_in_space(of.project, of.runs.front(), 32);
    REQUIRE(estimate.obstacle.empty());
    REQUIRE(expected.without_modes.front() > 0.01);
    CHECK(estimate.estimate.without_modes.front() ==
          Approx(expected.without_modes.front()).epsilon(5e-4));
    const Moved rigid = alone(scene);
    CHECK(estimate_vibration_in_space(rigid.project, rigid.runs.front(), 32)
              .estimate.without_modes.front() < 0.995 * expected.without_modes.front());
  }
}

// The limit: rods and joints so stiff that they do not give way.
TEST_CASE("rods and joints in space of no flexibility are rigid", "[elastic_rods_in_space]") {
  for (const bool body : {false, true}) {
    for (const std::string& driver : {shaking, lifting}) {
      CAPTURE(body, driver);
      Scene scene = in_the_plane(body, driver);
      scene.hinge += stiffness(1e16) + turning(1e16);
      scene.model = "[model]\ndamping = { ratio = 0.02, at = \"10 Hz\" }\n";
      const Moved stiff = moved(scene, [&](Project& project) {
        std::erase_if(project.elastic_beside, [](const ElasticBeside& of) {
          return !std::holds_alternative<spatial::ElasticJoint>(of.place);
        });
      });
      REQUIRE(stiff.project.elastic_beside.size() == 1);
      const Moved rigid = moved(scene, rigid_beside);
      const std::vector<double> found = stiff.frequencies(8, 4), expected = rigid.frequencies(8, 4);
      for (std::size_t i = 0; i < 4; ++i) CHECK(found[i] == Approx(expected[i]).epsilon(1e-9));
      const ElasticMotionInSpace one = stiff.by(2, 8), other = rigid.by(2, 8);
      for (const double s : {0.5, 2.5}) {
        const Cuts expects = cuts_of(other.loads_at(si<Time>(0.4)), s);
        check_alike(cuts_of(one.loads_at(si<Time>(0.4)), s), expects, expects, 1e-8);
      }
    }
  }
  // What is left falls as the flexibility.
  const auto apart = [](double k) {
    Scene scene = in_the_plane(false, shaking);
    scene.hinge += stiffness(k);
    const auto joint_alone = [](Project& project) {
      std::erase_if(project.elastic_beside, [](const ElasticBeside& of) {
        return !std::holds_alternative<spatial::ElasticJoint>(of.place);
      });
    };
    return 1.0 - moved(scene, joint_alone).frequencies(8, 1).front() /
                     moved(scene, rigid_beside).frequencies(8, 1).front();
  };
  const double once = apart(1e7), ten_times = apart(1e8);
  CHECK(once > 1e-6);
  CHECK(ten_times == Approx(0.1 * once).epsilon(0.05));
}

TEST_CASE("a rod in space of a stout section is a rigid rod", "[elastic_rods_in_space]") {
  for (const bool body : {false, true}) {
    CAPTURE(body);
    const Scene scene = in_the_plane(body, slightly, false);
    const auto of_side = [&](double side) {
      return moved(scene, [&](Project& project) {
        const Section section{Plate{si<Length>(side), si<Length>(side)}, {}};
        Segment& rod = project.elastic_beside.front().beam.segments.front();
        rod.from = rod.to = section;
      });
    };
    const Moved stout = of_side(body ? 1.0 : 10.0), rigid = alone(scene);
    const double within = body ? 1e-4 : 1e-8;
    const std::vector<double> found = stout.frequencies(8, 3), expected = rigid.frequencies(8, 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(found[i] == Approx(expected[i]).epsilon(within));
    const ElasticMotionInSpace one = stout.by(2, 8), other = rigid.by(2, 8);
    for (const double s : {0.5, 2.5}) {
      const Cuts expects = cuts_of(other.loads_at(si<Time>(0.1)), s);
      check_alike(cuts_of(one.loads_at(si<Time>(0.1)), s), expects, expects, within);
    }
  }
}

TEST_CASE("a model in space is chosen with the rods and joints of the case",
          "[elastic_rods_in_space]") {
  Scene scene = in_the_plane(false, shaking);
  scene.side = 0.001;
  scene.hinge += stiffness(5e5);
  const ModelChoice of = choose_model(parse_project("lever.toml", scene.text()));
  CHECK_THAT(of.reason, Catch::Contains("(joint hinge, stay elastic as well)"));
  Project alone = parse_project("lever.toml", scene.text());
  alone.elastic_beside.clear();
  CHECK(choose_model(alone).frequencies.front() > 1.01 * of.frequencies.front());
}

TEST_CASE("bad input of joints in space that give way", "[elastic_rods_in_space]") {
  const auto problems = [](const Scene& scene) {
    return test::refusal_of([&] { return parse_project("lever.toml", scene.text()); });
  };
  Scene damped = in_the_plane(false, shaking);
  damped.hinge += "turning_damping = \"1 N m s/rad\"\n";
  CHECK_THAT(problems(damped), Catch::Contains("without \"turning_stiffness\" nothing does"));
  Scene ball;
  ball.hinge = "kind = \"spherical\"\n" + turning(1e3);
  CHECK_THAT(problems(ball), Catch::Contains("turning_stiffness"));
  Scene changed = in_the_plane(false, shaking);
  changed.hinge += stiffness(5e5);
  changed.rod +=
      "[[situations]]\nname = \"one\"\n[[situations]]\nname = \"other\"\n"
      "set = { \"joints.hinge.stiffness\" = \"6e5 N/m\" }\n";
  CHECK_THAT(problems(changed), Catch::Contains("those of all situations"));
}

}  // namespace elastic_rods_in_space_test
