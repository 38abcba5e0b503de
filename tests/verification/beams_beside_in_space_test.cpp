// Several elastic beams of one case in space: an arm cut in two beams that are joined rigidly is
// the whole arm, whichever half is verified; a case of the plane written in space.

#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/shear_area.hpp"
#include "boxbeam/verification/elastic_motion.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/second_order_estimate.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/unsaid.hpp"
#include "catch.hpp"
#include "src/verification/elastic_motion_in_space.hpp"
#include "src/verification/fast_loads.hpp"
#include "src/verification/vibration_in_space.hpp"
#include "support/cut_arm.hpp"

namespace beams_beside_in_space_test {

using namespace boxbeam;
using namespace test::cut_arm;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::space_arm::check_alike;
using test::space_arm::Cuts;
using test::space_arm::cuts_of;

// Invariant: both are cut into the same pieces, so that modes, work and turning terms are the same.
TEST_CASE("an arm in two beams joined rigidly vibrates as one", "[beams_beside]") {
  const auto text = [](bool cut) {
    return arm(cut, hinge({0.48, -0.6, 0.64}, 0.3, 1.0) + load_at(tip_of(cut)), "root", "thin",
               "[model]\ndamping = { ratio = 0.02, at = \"4 Hz\" }\n");
  };
  const Moved whole = moved(text(false));
  const std::vector<frame::BeamMode> modes = whole.modes(16, 6);
  const ElasticMotionInSpace expected = whole.by(5, 16);
  REQUIRE(modes.size() == 6);
  for (const std::size_t half : {std::size_t{0}, std::size_t{1}}) {
    CAPTURE(half);
    const Moved of = moved(text(true), half);
    REQUIRE(of.project.elastic_beside.size() == 1);
    const std::vector<frame::BeamMode> found = of.modes(8, 6);
    REQUIRE(found.size() == 6);
    for (std::size_t k = 0; k < 6; ++k) {
      CHECK(found[k].frequency == Approx(modes[k].frequency).epsilon(1e-8));
      CHECK(found[k].damping == Approx(modes[k].damping).epsilon(1e-7));
    }
    const ElasticMotionInSpace elastic = of.by(5, 8);
    REQUIRE(elastic.coordinates().cols() == expected.coordinates().cols());
    const double from = half == 0 ? 0.0 : 2.0;
    for (const double part : {0.0, 0.13, 0.5, 0.81}) {
      for (const double s : {0.0, 0.3, 1.1, 1.9}) {
        const Cuts by_whole = cuts_of(expected.loads_at(whole.at(part)), from + s);
        check_alike(cuts_of(elastic.loads_at(of.at(part)), s), by_whole, by_whole, 1e-6);
      }
    }
    // With the other half rigid it is stiffer.
    CHECK(alone(text(true), half).modes(8, 1).front().frequency > 1.02 * modes.front().frequency);
  }
}

TEST_CASE("an arm in four beams vibrates as one, whichever is verified", "[beams_beside]") {
  const char* const names[] = {"inner", "second", "third", "last"};
  const auto text = [&](bool cut) {
    std::string of = mechanism(9.81), beams;
    const char* const of_parts[] = {"root", "thin", "root", "thin"};
    if (cut) {
      for (std::size_t k = 0; k < 4; ++k) {
        of += body(names[k], 1.0);
        if (k > 0)
          of += fmt::format("[joints.cut{0}]\nkind = \"fixed\"\nconnect = [\"{1}.B\", \"{2}.A\"]\n",
                            k, names[k - 1], names[k]);
        beams += beam(names[k], segment(1.0, of_parts[k]));
      }
    } else {
      of += body("inner", 4.0);
      std::string segments;
      for (const char* section : of_parts) segments += segment(1.0, section);
      beams = beam("inner", segments);
    }
    return of + hinge({0.48, -0.6, 0.64}, 0.3, 1.0) + load_at(cut ? "last.B" : "inner.B") +
           sections + beams + demands;
  };
  const Moved whole = moved(text(false));
  const std::vector<frame::BeamMode> modes = whole.modes(16, 6);
  const ElasticMotionInSpace expected = whole.by(3, 16);
  for (std::size_t k = 0; k < 4; ++k) {
    CAPTURE(names[k]);
    const Moved of = moved(text(true), k);
    const std::vector<frame::BeamMode> found = of.modes(4, 6);
    REQUIRE(found.size() == 6);
    for (std::size_t j = 0; j < 6; ++j)
      CHECK(found[j].frequency == Approx(modes[j].frequency).epsilon(1e-8));
    if (k % 2 == 0) continue;
    const ElasticMotionInSpace elastic = of.by(3, 4);
    const Cuts by_whole = cuts_of(expected.loads_at(whole.at(0.13)), static_cast<double>(k) + 0.6);
    check_alike(cuts_of(elastic.loads_at(of.at(0.13)), 0.6), by_whole, by_whole, 1e-6);
  }
}

TEST_CASE("what rigid bodies miss of an arm in two beams is what they miss of the whole",
          "[beams_beside]") {
  const auto text = [](bool cut) {
    return arm(cut, hinge({0.48, -0.6, 0.64}, 0.05, 1.0) + load_at(tip_of(cut)));
  };
  const Moved whole = moved(text(false)), inner = moved(text(true)), rigid = alone(text(true));
  const auto estimated = [](const Moved& of, int parts) {
    return estimate_vibration_in_space(of.project, of.runs.front(), parts).estimate;
  };
  const VibrationEstimate expected = estimated(whole, 16), found = estimated(inner, 8);
  REQUIRE(found.frequencies.size() == 6);
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(found.frequencies[k] == Approx(expected.frequencies[k]).epsilon(1e-7));
  // The largest stress and range are at the heel.
  CHECK(found.without_modes.front() == Approx(expected.without_modes.front()).epsilon(1e-5));
  CHECK(expected.without_modes.front() > 0.01);
  CHECK(estimated(rigid, 8).without_modes.front() < 0.98 * found.without_modes.front());
}

// Invariant: the axial force of each beam softens that beam, as it does both halves of the whole.
// Of the whole f^2 falls by N/N_cr, nearly: the modes of vibration and of buckling are alike.
TEST_CASE("a column in two beams is softened by what presses both", "[beams_beside]") {
  const Project project =
      parse_beams("arm.toml", arm(false, hinge({0.0, 0.0, 1.0}, 0.1, 1.0), "thin", "thin"))[0];
  const double I_z = properties_of(project.beam.segments.front().from).I_z.value();
  const double N_cr = pi * pi * E * I_z / (4.0 * 4.0 * 4.0);
  const auto text = [&](bool cut, double part) {
    return arm(cut, clamp + push_at(tip_of(cut), "[-1, 0, 0]", part * N_cr, 1.0), "thin", "thin",
               "", 0.0);
  };
  const auto first = [](const Moved& of, int parts) {
    return of.modes(parts, 1).front().frequency;
  };
  const double free = first(moved(text(false, 0.0)), 16),
               pressed = first(moved(text(false, 0.5)), 16);
  CHECK(std::pow(pressed / free, 2) == Approx(0.5).epsilon(0.05));
  for (const std::size_t half : {std::size_t{0}, std::size_t{1}})
    CHECK(first(moved(text(true, 0.5), half), 8) == Approx(pressed).epsilon(1e-8));
  // Beyond N_cr it does not stand.
  CHECK_THROWS_AS(moved(text(true, 1.02)).modes(8, 1), AnalysisError);
}

// Euler's cantilever, less what shear gives: N_cr/(1 + N_cr/(G A_y)). The bisection is within 1e-3.
TEST_CASE("a column in two beams buckles as the whole, whichever is verified", "[beams_beside]") {
  const double P = 20e3;
  const auto text = [&](bool cut) {
    return arm(cut, clamp + push_at(tip_of(cut), "[-1, 0, 0]", P, 1.0), "thin", "thin", "", 0.0);
  };
  const Moved whole = moved(text(false));
  const Section& section = whole.project.beam.segments.front().from;
  const double Euler = pi * pi * E * properties_of(section).I_z.value() / (4.0 * 4.0 * 4.0),
               N_cr = Euler / (1.0 + Euler / (G * shear_areas_of(section).y.value()));
  const auto critical = [](const Moved& of) {
    return of.runs.front().motion->critical_factor_at(of.rigid().time_of(0), of.rigid().diagram(0),
                                                      1e4);
  };
  const double largest = P + 1.0;
  const double part_of_whole = estimate_second_order(whole.project, whole.runs).across.value().part;
  CHECK(part_of_whole == Approx(largest / N_cr).epsilon(2e-3));
  for (const std::size_t half : {std::size_t{0}, std::size_t{1}}) {
    CAPTURE(half);
    const Moved of = moved(text(true), half);
    const auto factor = critical(of);
    REQUIRE(factor);
    CHECK(*factor * P == Approx(N_cr).epsilon(2e-3));
    const SecondOrderEstimate estimate = estimate_second_order(of.project, of.runs);
    CHECK(estimate.across.value().part == Approx(part_of_whole).epsilon(3e-3));
    // How it bends is known: pressed along its axis alone it stays straight.
    CHECK(estimate.sway == 0.0);
    CHECK(estimate.whole);
    CHECK(estimate.change.value() < 1e-6);
    const auto stiff = critical(alone(text(true), half));
    REQUIRE(stiff);
    CHECK(*stiff > 1.1 * *factor);
  }
}

namespace {

/// Two beams, the second driven about a hinge at the tip of the first, on a ground that is turned.
std::string elbow(const std::string& ground_turn) {
  return mechanism(0.0) + body("inner", 2.5) + body("outer", 2.0) +
         "[bodies.base]\npoints = { o = [\"0 m\", \"0 m\", \"0 m\"] }\n"
         "[joints.base]\nkind = \"fixed\"\nconnect = [\"ground\", \"base.o\"]\n"
         "at = [\"1 m\", \"-2 m\", \"3 m\"]\n" +
         ground_turn + R"(
[joints.heel]
kind = "revolute"
connect = ["base.o", "inner.A"]
axis = [0.48, -0.6, 0.64]
[drivers.heel]
joint = "heel"
kind = "harmonic"
mean = "0 rad"
amplitude = "0.5 rad"
frequency = "0.7 Hz"
[joints.elbow]
kind = "revolute"
connect = ["inner.B", "outer.A"]
axis = [0, 0.8, 0.6]
[drivers.elbow]
joint = "elbow"
kind = "harmonic"
mean = "0.4 rad"
amplitude = "0.6 rad"
frequency = "0.7 Hz"
phase = "1 rad"
)" + load_at("outer.B") +
         sections + beam("inner", segment(2.5, "root")) + beam("outer", segment(2.0, "thin")) +
         demands + "[model]\ndamping = { ratio = 0.02, at = \"6 Hz\" }\n";
}

}  // namespace

// Invariants: the scene turned as a whole; and what the elbow does to one beam is the opposite of
// what it does to the other, though each is verified by itself.
TEST_CASE("two beams on an elbow move alike however they lie, and bear what each does to the other",
          "[beams_beside]") {
  const std::string turn =
      "turn = [[\"x\", \"70 deg\"], [\"z\", \"-130 deg\"], [\"y\", \"15 deg\"]]\n";
  const Moved inner = moved(elbow("")), outer = moved(elbow(""), 1), turned = moved(elbow(turn));
  const ElasticMotionInSpace of_inner = inner.by(6, 8), of_outer = outer.by(6, 8),
                             of_turned = turned.by(6, 8);
  REQUIRE(of_inner.coordinates().cols() == of_outer.coordinates().cols());
  for (const double part : {0.0, 0.123, 0.4, 0.81}) {
    for (const double s : {0.0, 1.3, 2.2}) {
      const Cuts expected = cuts_of(of_inner.loads_at(inner.at(part)), s),
                 rigid = cuts_of(inner.rigid().loads_at(inner.at(part)), s);
      check_alike(cuts_of(of_turned.loads_at(turned.at(part)), s), expected, expected, 1e-7);
      CHECK((expected - rigid).norm() > 1e-4 * rigid.norm());
    }
    const spatial::State state = inner.chain().at(inner.at(part).value());
    const auto axes = [&](const char* name) -> const Matrix3d& {
      const int of = body_index(inner.chain().mechanism(), name);
      return state.bodies[static_cast<std::size_t>(of)].R_WB;
    };
    const Matrix3d into = axes("inner").transpose() * axes("outer");
    const Cuts before = cuts_of(of_inner.loads_at(inner.at(part)), 2.5, Side::before),
               behind = cuts_of(of_outer.loads_at(outer.at(part)), 0.0);
    Cuts carried;
    carried << into * behind.head<3>(), into * behind.tail<3>();
    check_alike(before, carried, carried, 1e-6);
  }
}

TEST_CASE("what the drive does beyond rigid bodies both beams dissipate", "[beams_beside]") {
  const Vector3d axis(0.48, -0.6, 0.64);
  const double small = 1e-4, frequency = 3.0;
  const Moved of = moved(bent_arm(hinge(axis, small, frequency),
                                  "[model]\ndamping = { ratio = 0.05, at = \"6 Hz\" }\n"));
  const ElasticMotionInSpace elastic = of.by(6, 8);
  test::space_arm::check_dissipated(of, elastic, axis, small, frequency, 0.05 / (pi * 6.0));
}

// The limit: so much stiffer, the other beam is a rigid body of its mass; what is left falls as its
// flexibility.
TEST_CASE("a beam that is far stiffer is a rigid body beside the other", "[beams_beside]") {
  const std::string text = bent_arm(hinge({0.0, 0.0, 1.0}, 0.1, 1.0));
  const Project project = parse_beams("arm.toml", text)[0];
  const TaperedBeam& other = project.elastic_beside.front().beam;
  const MassProperties mass = mass_properties_of(other);
  const Vector3d corner(first_length, 0.0, 0.0);
  const Matrix3d axes = (Eigen::AngleAxisd(1.1, Vector3d(0.48, -0.6, 0.64))).toRotationMatrix();
  const auto tie = [](int a, int b, const Vector3d& at, Eigen::Index way) {
    frame::Tie of;
    const frame::Vector6 per = frame::Vector6::Unit(way);
    of.ends = {{{a, at}, -per}, {{b, at}, per}};
    return of;
  };
  std::vector<frame::Tie> ties;
  for (Eigen::Index way = 0; way < 6; ++way) {
    ties.push_back(tie(frame::ground, 0, Vector3d::Zero(), way));
    ties.push_back(tie(0, 1, corner, way));
  }
  const frame::VibratingBeam first(project.beam, E, G, {}, 8);
  const auto frequencies = [](const frame::VibratingScene& scene) {
    std::vector<double> found;
    for (const frame::BeamMode& mode : frame::modes_of(scene, 5)) found.push_back(mode.frequency);
    return found;
  };
  const frame::RigidMass rigid{mass.mass.value(), corner + mass.centre.value() * axes.col(0),
                               axes * mass.tensor * axes.transpose()};
  const std::vector<double> expected = frequencies({{{&first}}, {rigid}, ties});
  const auto apart = [&](double times) {
    const frame::VibratingBeam second(other, times * E, times * G, {}, 8);
    const std::vector<double> found =
        frequencies({{{&first}, {&second, {}, corner, axes}}, {}, ties});
    REQUIRE(found.size() == 5);
    double largest = 0.0;
    for (std::size_t k = 0; k < 5; ++k)
      largest = std::max(largest, std::abs(found[k] / expected[k] - 1.0));
    return largest;
  };
  const double once = apart(1.0), thousand = apart(1e3), ten_thousand = apart(1e4);
  CHECK(once > 0.02);
  CHECK(thousand < 1e-2);
  CHECK(ten_thousand == Approx(0.1 * thousand).epsilon(0.05));
}

namespace {

/// An arm of two beams that its pivot swings, in the plane and written in space; with a hinge that
/// is driven between them, or joined rigidly.
std::string in_plane(double amplitude, double elbow) {
  const auto body = [](const char* name, const char* at) {
    return fmt::format(
        "[bodies.{}]\npoints = {{ A = [\"0 m\", \"0 m\"], B = [\"2 m\", \"0 m\"] }}\n"
        "sketch = {{ at = [\"{} m\", \"0 m\"], angle = \"0 rad\" }}\n",
        name, at);
  };
  const auto beam = [](const char* name, const char* section) {
    return fmt::format(
        "[[beam]]\nname = \"{0}\"\nbody = \"{0}\"\ndensity = \"7850 kg/m^3\"\n"
        "[[beam.segments]]\nlength = \"2 m\"\nsection = \"{1}\"\n",
        name, section);
  };
  std::string text =
      "[case]\nname = \"swung\"\nkind = \"planar\"\n[mechanism]\n"
      "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
      body("inner", "0") + body("outer", "2") +
      "[joints.pivot]\nkind = \"pin\"\nconnect = [\"inner.A\", \"ground\"]\n"
      "at = [\"0 m\", \"0 m\"]\n" +
      fmt::format(
          "[drivers.swing]\ncoordinate = \"angle\"\npoint = \"inner.A\"\n"
          "kind = \"harmonic\"\nmean = \"0 rad\"\namplitude = \"{} rad\"\n"
          "frequency = \"1 Hz\"\n",
          amplitude);
  if (elbow == 0.0)
    text += "[joints.cut]\nkind = \"rigid\"\nconnect = [\"inner.B\", \"outer.A\"]\n";
  else
    text += fmt::format(
        "[joints.cut]\nkind = \"pin\"\nconnect = [\"inner.B\", \"outer.A\"]\n"
        "[drivers.elbow]\ncoordinate = \"relative angle\"\npoints = [\"outer.A\", \"inner.B\"]\n"
        "kind = \"harmonic\"\nmean = \"0 rad\"\namplitude = \"{} rad\"\nfrequency = \"1 Hz\"\n"
        "phase = \"0.8 rad\"\n",
        elbow);
  return text + sections + beam("inner", "root") + beam("outer", "thin") + demands;
}

std::string in_space(double amplitude, double elbow) {
  std::string text = arm(true, hinge({0.0, -1.0, 0.0}, amplitude, 1.0), "root", "thin", "", 0.0);
  // The plane counts no rotary inertia of slices unless asked to.
  const std::string rotary = "rotary_inertia = true\n";
  for (std::size_t at = 0; (at = text.find(rotary)) != std::string::npos;)
    text.erase(at, rotary.size());
  if (elbow == 0.0) return text;
  const std::string fixed = "kind = \"fixed\"\nconnect = [\"inner.B\", \"outer.A\"]\n";
  text.replace(text.find(fixed), fixed.size(),
               fmt::format("kind = \"revolute\"\nconnect = [\"inner.B\", \"outer.A\"]\n"
                           "axis = \"-y\"\n[drivers.elbow]\njoint = \"cut\"\n"
                           "kind = \"harmonic\"\nmean = \"0 rad\"\namplitude = \"{} rad\"\n"
                           "frequency = \"1 Hz\"\nphase = \"0.8 rad\"\n",
                           elbow));
  return text;
}

RigidMotion planar_motion(const Project& project, const SituationRun& run) {
  return {&planar_in(project, *run.situation), &planar_motion_of(run), &project.beam,
          [&run](Time time) { return run.loads.loads_at(time); }};
}

}  // namespace

// The same beams as chains of rigid finite elements of the plane and by their pieces in space.
TEST_CASE("two beams of the plane written in space have its frequencies and its estimate",
          "[beams_beside]") {
  const Project plane = parse_beams("plane.toml", in_plane(1e-4, 0.0))[0];
  const std::deque<SituationRun> runs = run_situations(plane);
  const VibrationEstimate expected = estimate_vibration(
      planar_motion(plane, runs.front()), elastic_body_of(plane, 192), runs.front().loads);
  const Moved of = moved(in_space(1e-4, 0.0));
  std::vector<double> found;
  for (const frame::BeamMode& mode : of.modes(32, 12))
    if (mode.energy[1] > 0.1) found.push_back(mode.frequency);
  REQUIRE(found.size() >= 2);
  REQUIRE(expected.frequencies.size() >= 2);
  for (std::size_t k = 0; k < 2; ++k)
    CHECK(found[k] == Approx(expected.frequencies[k]).epsilon(k == 0 ? 1e-6 : 2e-5));
  const VibrationInSpace estimate = estimate_vibration_in_space(of.project, of.runs.front(), 32);
  REQUIRE(estimate.obstacle.empty());
  REQUIRE(expected.without_modes.front() > 0.005);
  CHECK(estimate.estimate.without_modes.front() ==
        Approx(expected.without_modes.front()).epsilon(1e-6));
}

// Equations and loads are the plane's where each beam turns by itself. By one mode of the plane:
// what is left out where several change with the posture depends on how their bases are turned.
TEST_CASE("two beams on a driven elbow in the plane vibrate alike written in space",
          "[beams_beside]") {
  const double amplitude = 0.3, angle = 0.4;
  for (const std::size_t verified : {std::size_t{0}, std::size_t{1}}) {
    CAPTURE(verified);
    const Project plane = parse_beams("plane.toml", in_plane(amplitude, angle))[verified];
    const std::deque<SituationRun> runs = run_situations(plane);
    const RigidMotion rigid = planar_motion(plane, runs.front());
    const ElasticBody elastic = elastic_body_of(plane, 48);
    const ElasticMotion vibrating(rigid, elastic, 1);
    const LoadsAt bent = bent_statically(rigid, elastic);
    const Moved of = moved(in_space(amplitude, angle), verified);
    // One of them in the plane.
    const ElasticMotionInSpace coarse = of.by(2, 8), fine = of.by(2, 16);
    REQUIRE(fine.coordinates().cols() == 2);
    const auto beyond_rigid = [&](const ElasticMotionInSpace& by, Time time, double s) -> Cuts {
      return cuts_of(by.loads_at(time), s) - cuts_of(of.rigid().loads_at(time), s);
    };
    for (const double s : {0.0, 1.2}) {
      double moment = 0.0, vibrating_moment = 0.0, apart = 0.0, across = 0.0, of_rigid = 0.0;
      for (int i = 0; i < 24; ++i) {
        const Time time = of.at(i / 24.0);
        const Cuts expected = cuts_of(vibrating.loads_at(time), s) - cuts_of(bent(time), s);
        // Axial forces stand in the middles of pieces: the error falls with the square of these.
        const Cuts found =
            (4.0 * beyond_rigid(fine, time, s) - beyond_rigid(coarse, time, s)) / 3.0;
        apart = std::max(apart, std::abs(found[4] - expected[4]));
        across = std::max({across, std::abs(found[3]), std::abs(found[5])});
        const Cuts plain = cuts_of(of.rigid().loads_at(time), s);
        of_rigid = std::max(of_rigid, std::abs(plain[4] - cuts_of(rigid.loads(time), s)[4]));
        moment = std::max(moment, std::abs(plain[4]));
        vibrating_moment = std::max(vibrating_moment, std::abs(expected[4]));
      }
      INFO("s = " << s << ": " << apart / moment << ", of what vibrates "
                  << apart / vibrating_moment);
      REQUIRE(of_rigid < 1e-9 * moment);
      CHECK(vibrating_moment > 0.005 * moment);
      CHECK(apart < 1e-6 * moment);
      // In the plane of the others nothing moves it.
      CHECK(across < 1e-9 * moment);
    }
  }
}

TEST_CASE("of a case with two beams in space both are elastic in each other's model",
          "[beams_beside]") {
  const std::string text = arm(true, hinge({0.0, 0.0, 1.0}, 0.02, 1.2) + load_at("outer.B"));
  const std::string one = arm(false, hinge({0.0, 0.0, 1.0}, 0.02, 1.2) + load_at("inner.B"));
  const ModelledRuns expected = run_by_chosen_model(parse_beams("arm.toml", one)[0]);
  for (const Project& project : parse_beams("arm.toml", text)) {
    CAPTURE(project.beam_name);
    const ModelledRuns found = run_by_chosen_model(project);
    CHECK(found.model.frequencies.front() ==
          Approx(expected.model.frequencies.front()).epsilon(1e-5));
    const std::string other = project.beam_name == "inner" ? "outer" : "inner";
    CHECK_THAT(found.model.reason, Catch::Contains("(" + other + " elastic as well)"));
    // Nothing of it is left to be said.
    CHECK(unestimated_vibration_of(project, found.model, found.runs).empty());
  }
}

// Where nobody estimates vibration an oscillator bounds it. Of an arm in two beams its length, mass
// and least stiffness are those of the whole arm, and at its root so are the stresses.
TEST_CASE("an arm in two beams may vibrate where the whole arm may", "[beams_beside]") {
  int apart = 0;
  for (const double frequency : {0.1, 0.2, 0.4, 0.6, 0.8, 1.2, 1.8, 2.5, 4.0}) {
    CAPTURE(frequency);
    const std::string driven = hinge({0.0, 0.0, 1.0}, 0.02, frequency);
    const auto may = [](Project project) {
      const Moved of(std::move(project));
      return may_vibrate(of.project, of.chain().mechanism(), of.rigid());
    };
    const bool whole = may(parse_beams("arm.toml", arm(false, driven + load_at("inner.B")))[0]);
    Project inner = parse_beams("arm.toml", arm(true, driven + load_at("outer.B")))[0];
    CHECK(may(inner) == whole);
    inner.elastic_beside.clear();
    if (may(std::move(inner)) != whole) ++apart;
  }
  // The inner beam alone is stiffer.
  CHECK(apart > 0);
}

// What is found of one beam is found of all: bad input of another one is answered at once.
TEST_CASE("a joint beyond the end of another beam is refused with its place", "[beams_beside]") {
  std::string text = arm(true, hinge({0.0, 0.0, 1.0}, 0.3, 1.2) + load_at("outer.B"));
  const std::string right = "B = [\"2 m\"";
  text.replace(text.rfind(right), right.size(), "B = [\"2.5 m\"");
  CHECK_THROWS_WITH(parse_beams("arm.toml", text),
                    Catch::Contains("\"tip\" acts beyond the end of the beam, at s = 2.5 m"));
}

}  // namespace beams_beside_in_space_test
