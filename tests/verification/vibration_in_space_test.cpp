// Vibration of the beam of mechanisms in space, against closed forms, the plane and a model of
// finite elements that shares nothing with the program.

#include "src/verification/vibration_in_space.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_area.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/unsaid.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/slender_beam.hpp"
#include "support/space_arm.hpp"
#include "support/space_elements.hpp"

namespace vibration_in_space_test {

using namespace boxbeam;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

namespace {

constexpr double pi = std::numbers::pi, E = 210e9, G = 81e9, length = 4.0;

/// An arm with what is at its tip; `joints` hold it, and it may narrow from a larger section.
std::string arm(const std::string& joints, const std::string& tip, const char* density,
                const char* from = "arm") {
  std::string text = test::space_arm::arm(
      joints + tip, fmt::format("density = \"{} kg/m^3\"\n", density),
      "[sections.root]\nkind = \"box\"\nwidth = \"160 mm\"\nheight = \"240 mm\"\n"
      "flange = \"8 mm\"\nweb = \"6 mm\"\n");
  const std::string even = "section = \"arm\"";
  return text.replace(text.find(even), even.size(),
                      fmt::format("from = \"{}\"\nto = \"arm\"", from));
}

/// A mass beside the tip, in axes of its own.
const std::string beside = R"(
[bodies.load]
mass = "120 kg"
centre = ["0.3 m", "0.4 m", "-0.2 m"]
inertia = [["9 kg m^2", "1 kg m^2", "-2 kg m^2"], ["1 kg m^2", "6 kg m^2", "0.5 kg m^2"], ["-2 kg m^2", "0.5 kg m^2", "11 kg m^2"]]
points = { c = ["0 m", "0 m", "0 m"] }

[joints.tip]
kind = "fixed"
connect = ["arm.tip", "load.c"]
turn = [["z", "40 deg"]]
)";

const std::string luffed = R"(
[joints.heel]
kind = "revolute"
connect = ["ground", "arm.heel"]
at = ["0 m", "0 m", "0 m"]
axis = "-y"
start = "0 deg"
)";

const std::string light_point = test::space_arm::with_load(200.0);

std::string slewing(const std::string& ground_turn) {
  return test::space_arm::slewing(ground_turn, R"(kind = "harmonic"
mean = "10 deg"
amplitude = "40 deg"
frequency = "0.3 Hz"
)");
}

ModelChoice chosen(const std::string& text) {
  return choose_model(parse_project("arm.toml", text));
}

/// Of a beam clamped at its start with a rigid body at its tip, in its axes [Hz].
std::vector<double> by_elements(const TaperedBeam& beam, double m, const Vector3d& c,
                                const Matrix3d& J) {
  const auto [K, M] = test::space_elements::assembled(beam, m, c, J);
  const Eigen::Index free = K.rows() - 6;
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(M.bottomRightCorner(free, free),
                                                                 K.bottomRightCorner(free, free));
  std::vector<double> found;
  for (Eigen::Index k = 0; k < 4; ++k)
    found.push_back(1.0 / (2.0 * pi * std::sqrt(modes.eigenvalues()[free - 1 - k])));
  return found;
}

/// The first frequencies in the posture at the begin of the first situation, without what presses.
std::vector<double> frequencies(const std::string& text, int parts = 32) {
  const Project project = parse_project("arm.toml", text);
  const std::deque<SituationRun> runs = run_situations(project);
  const spatial::Chain& chain = chain_of(runs.front());
  StoppedVibration stopped(project, chain, parts);
  std::vector<double> found;
  for (const frame::BeamMode& mode : stopped.modes(chain.at(0.0), {}, 4))
    found.push_back(mode.frequency);
  return found;
}

}  // namespace

TEST_CASE("an arm with a body beside its tip has the frequencies of a model of finite elements",
          "[vibration]") {
  Matrix3d J;
  J << 9, 1, -2, 1, 6, 0.5, -2, 0.5, 11;
  const Matrix3d R = Eigen::AngleAxisd(40.0 * pi / 180.0, Vector3d::UnitZ()).toRotationMatrix();
  for (const char* from : {"arm", "root"}) {
    const std::string text = arm(slewing(""), beside, "7850", from);
    const Project project = parse_project("arm.toml", text);
    const auto expected =
        by_elements(project.beam, 120.0, R * Vector3d(0.3, 0.4, -0.2), R * J * R.transpose());
    const auto found = frequencies(text);
    REQUIRE(found.size() == 4);
    // Sixty even elements of a taper miss it by their steps, 1e-4.
    const double within = std::string(from) == "arm" ? 2e-5 : 3e-4;
    for (std::size_t k = 0; k < 4; ++k) {
      INFO(from << ", mode " << k);
      CHECK(found[k] == Approx(expected[k]).epsilon(within));
    }
  }
}

// Invariant: what does not move is the ground, whatever its mass.
TEST_CASE("an arm on a body that a driver holds vibrates as one on the ground", "[vibration]") {
  const auto on = [](const std::string& carrier) {
    return arm(carrier + R"(
[joints.heel]
kind = "fixed"
connect = [")" + (carrier.empty() ? "ground" : "post.top") +
                   R"(", "arm.heel"]
)",
               beside, "7850", "root");
  };
  const auto carried = frequencies(on(R"(
[bodies.post]
mass = "500 kg"
uniform_rod = ["foot", "top"]
points = { foot = ["0 m", "0 m", "0 m"], top = ["0 m", "0 m", "2 m"] }
[joints.post]
kind = "revolute"
connect = ["ground", "post.foot"]
axis = "z"
[drivers.post]
joint = "post"
kind = "harmonic"
mean = "30 deg"
amplitude = "5 deg"
frequency = "1 Hz"
)")),
             clamped = frequencies(on("") + "[motion]\nduration = \"1 s\"\n");
  REQUIRE(carried.size() == clamped.size());
  for (std::size_t k = 0; k < carried.size(); ++k)
    CHECK(carried[k] == Approx(clamped[k]).epsilon(1e-9));
}

// Invariant: the scene turned as a whole.
TEST_CASE("however a scene lies in the world its beam vibrates alike", "[vibration]") {
  const ModelChoice straight = chosen(arm(slewing(""), beside, "7850", "root"));
  const ModelChoice turned = chosen(
      arm(slewing("turn = [[\"x\", \"70 deg\"], [\"z\", \"-130 deg\"], [\"y\", \"15 deg\"]]"),
          beside, "7850", "root"));
  REQUIRE(straight.frequencies.size() == 6);
  REQUIRE(turned.frequencies.size() == 6);
  for (std::size_t k = 0; k < 6; ++k)
    CHECK(turned.frequencies[k] == Approx(straight.frequencies[k]).epsilon(1e-7));
  CHECK(turned.weighed.front().error == Approx(straight.weighed.front().error).epsilon(1e-6));
  CHECK(straight.weighed.front().error > 0.0);
}

// Closed forms of Euler and Bernoulli; shear takes up to 2 % from a box of L/h = 25.
TEST_CASE("a strut at the tip holds an arm in the plane in which it luffs only", "[vibration]") {
  const std::string text = arm(luffed + R"([joints.strut]
kind = "distance"
connect = ["ground", "arm.tip"]
at = ["4 m", "0 m", "-2 m"]
length = "2 m"

[forces.push]
kind = "force"
point = "arm.tip"
direction = "y"
law = { kind = "harmonic", mean = "0 N", amplitude = "1 kN", frequency = "1 Hz" }
)",
                               "", "7850");
  const Project project = parse_project("arm.toml", text);
  const Section& section = project.beam.segments.front().from;
  const SectionProperties of = properties_of(section);
  const double a = 7850.0 * of.area.value(), L = length;
  const double across = std::pow(1.8751040687 / L, 2) * std::sqrt(E * of.I_z.value() / a);
  const double luffing = std::pow(pi / L, 2) * std::sqrt(E * of.I_y.value() / a);
  const auto found = frequencies(text);
  CHECK(2.0 * pi * found[0] == Approx(across).epsilon(0.02));
  CHECK(2.0 * pi * found[1] == Approx(luffing).epsilon(0.02));
  CHECK(found[0] * 2.0 * pi < across);
  CHECK(found[1] * 2.0 * pi < luffing);
  CHECK_THAT(choose_model(project).reason, Catch::Contains("bending about z"));
}

// A force on a mass at the tip of an arm without mass: the rigid arm bears it as it is, the elastic
// one 1/(1 - r^2) times.
TEST_CASE("what rigid bodies miss under a force on a mass is r^2/(1 - r^2)", "[vibration]") {
  const auto under = [&](double frequency) {
    return arm(test::space_arm::clamped,
               light_point + fmt::format(R"(
[forces.push]
kind = "force"
point = "arm.tip"
direction = "y"
law = {{ kind = "harmonic", mean = "0 N", amplitude = "1 kN", frequency = "{:.12g} Hz" }}
)",
                                         frequency),
               "1e-3");
  };
  const Project project = parse_project("arm.toml", under(1.0));
  const Section& section = project.beam.segments.front().from;
  // 3 E I/L^3 and G A_s/L in series.
  const double give = std::pow(length, 3) / (3.0 * E * properties_of(section).I_z.value()) +
                      length / (G * shear_areas_of(section).y.value());
  const double first = 1.0 / (2.0 * pi * std::sqrt(200.0 * give));
  for (const double r : {0.05, 0.3, 0.8, 1.5}) {
    Project case_of = parse_project("arm.toml", under(r * first));
    case_of.model.demand = ModelDemand::rigid;
    const ModelChoice choice = choose_model(case_of);
    INFO(choice.reason);
    CHECK(choice.frequencies.front() == Approx(first).epsilon(1e-5));
    REQUIRE(choice.weighed.size() == 1);
    CHECK(choice.weighed.front().error == Approx(r * r / std::abs(1.0 - r * r)).epsilon(5e-5));
    REQUIRE(choice.harmonics.size() == 1);
    CHECK(choice.harmonics.front().frequency == Approx(r * first).epsilon(1e-9));
    // The tolerance is 1 %: r = 0.05 adds 0.25 %.
    const Verification of = verify(case_of);
    const bool said = std::any_of(of.not_judged.begin(), of.not_judged.end(),
                                  [](const NotJudged& what) { return what.what == "vibration"; });
    CHECK(said == (r > 0.1));
  }
}

// A couple on a disc at the end of a shaft without mass, of 1/omega^2 = J L/(G I_T): nothing bends.
TEST_CASE("a shaft with a disc vibrates in torsion, and that is estimated", "[vibration]") {
  const auto under = [](double frequency) {
    return arm(test::space_arm::clamped + R"([bodies.load]
mass = "1 kg"
inertia = ["80 kg m^2", "50 kg m^2", "50 kg m^2"]
points = { c = ["0 m", "0 m", "0 m"] }

[joints.tip]
kind = "fixed"
connect = ["arm.tip", "load.c"]
)",
               fmt::format(R"(
[forces.turning]
kind = "couple"
point = "load.c"
direction = "x"
law = {{ kind = "harmonic", mean = "0 N m", amplitude = "1 kN m", frequency = "{:.12g} Hz" }}
)",
                           frequency),
               "1e-3");
  };
  const Project project = parse_project("arm.toml", under(1.0));
  const Section& section = project.beam.segments.front().from;
  const double I_T = torsion_properties_of(section).I_T->value();
  const double first = std::sqrt(G * I_T / (80.0 * length)) / (2.0 * pi), r = 0.5;
  Project case_of = parse_project("arm.toml", under(r * first));
  case_of.model.demand = ModelDemand::rigid;
  const ModelChoice choice = choose_model(case_of);
  INFO(choice.reason);
  CHECK(std::any_of(choice.frequencies.begin(), choice.frequencies.end(),
                    [&](double found) { return std::abs(found / first - 1.0) < 1e-5; }));
  REQUIRE(choice.weighed.size() == 1);
  CHECK(choice.weighed.front().error == Approx(r * r / (1.0 - r * r)).epsilon(1e-4));
  const Verification of = verify(case_of);
  CHECK(std::any_of(of.not_judged.begin(), of.not_judged.end(),
                    [](const NotJudged& what) { return what.what == "vibration"; }));
}

namespace {

/// At how many ties the mechanism's own motion opens a gap, and the largest speed.
std::size_t opened_by_motion(const Project& project) {
  const spatial::Chain chain(std::get<spatial::Mechanism>(project.mechanism));
  const spatial::BeamPlacement placement = placement_in(project, chain.mechanism());
  const spatial::State state = chain.at(0.13);
  const StoppedScene scene = stopped_scene(chain.mechanism(), state, {placement});
  const auto own = static_cast<std::size_t>(placement.body);
  const Matrix3d R_WB = state.bodies[own].R_WB * placement.axes;
  const Vector3d start = state.bodies[own].position + state.bodies[own].R_WB * placement.start;
  std::vector<double> gaps;
  for (const frame::Tie& tie : scene.ties) {
    if (!std::isinf(tie.stiffness)) continue;
    double gap = 0.0;
    for (const frame::Tie::End& end : tie.ends) {
      if (end.at.member == frame::ground) continue;
      // The beam's body is member 0, the others follow in their order.
      const auto k = static_cast<std::size_t>(end.at.member);
      const std::size_t body = k == 0 ? own : (k - 1 < own ? k - 1 : k);
      const spatial::BodyMotion& of = state.bodies[body];
      const Vector3d at = start + R_WB * end.at.p;
      gap += (R_WB * end.per.head<3>()).dot(of.velocity + of.omega.cross(at - of.position)) +
             (R_WB * end.per.tail<3>()).dot(of.omega);
    }
    gaps.push_back(std::abs(gap));
  }
  const double largest = *std::max_element(gaps.begin(), gaps.end());
  REQUIRE(largest > 1e-4);
  return static_cast<std::size_t>(std::count_if(
      gaps.begin(), gaps.end(), [&](double gap) { return gap > 1e-9 * (1.0 + largest); }));
}

/// A wheel beside the heel's hinge that a driver turns.
const std::string wheel = R"(
[bodies.wheel]
points = { c = ["0 m", "0 m", "0 m"] }
[joints.wheel]
kind = "revolute"
connect = ["ground", "wheel.c"]
at = ["0 m", "0 m", "-0.9 m"]
axis = "y"
[drivers.wheel]
joint = "wheel"
kind = "harmonic"
mean = "0 deg"
amplitude = "20 deg"
frequency = "1 Hz"
)";

}  // namespace

// Invariant: the mechanism's own motion keeps all ties of its joints but that of each coordinate
// that a driver moves.
TEST_CASE("what holds a stopped mechanism lets it move as it does but for its drivers",
          "[vibration]") {
  const auto opened = [](const std::string& joints) {
    return opened_by_motion(parse_project("arm.toml", arm(joints, light_point, "7850")));
  };
  CHECK(opened(luffed + wheel + R"(
[joints.teeth]
kind = "gear"
joints = ["wheel", "heel"]
ratio = 0.5
)") == 1);
  // A spindle about x, whose thread shifts the arm on its guide.
  CHECK(opened(R"(
[joints.heel]
kind = "prismatic"
connect = ["ground", "arm.heel"]
at = ["0 m", "0 m", "0 m"]
axis = "x"
start = "0 m"
[bodies.spindle]
points = { c = ["0 m", "0 m", "0 m"] }
[joints.spindle]
kind = "revolute"
connect = ["ground", "spindle.c"]
at = ["0 m", "0 m", "0 m"]
axis = "x"
[drivers.spindle]
joint = "spindle"
kind = "harmonic"
mean = "0 deg"
amplitude = "90 deg"
frequency = "1 Hz"
[joints.thread]
kind = "screw"
connect = ["spindle.c", "arm.heel"]
axis = "x"
lead = "20 mm"
closes = true
)") == 1);
  // The platform on six cylinders; the crane slews and luffs.
  CHECK(opened_by_motion(read_project(test::project_file("sections/stewart-rig/rig.toml"))) == 6);
  CHECK(opened_by_motion(read_project(test::project_file("sections/luffing-crane/crane.toml"))) ==
        2);
}

// The same beam as a chain of rigid finite elements of the plane and by its elements in space.
TEST_CASE("a case of the plane written in space has its frequencies and its estimate",
          "[vibration]") {
  const double frequency = 0.2;
  const test::slender::Beam plane =
      test::slender::carried(HarmonicDriver{0.0, 0.01, 2 * pi * frequency, 0.0}, 48, 0.0, true);
  ElasticBody elastic = plane.elastic();
  elastic.parts = 384;
  const VibrationEstimate expected = estimate_vibration(plane.rigid(), elastic, plane.history());
  const std::string text = test::space_arm::slender_on(
      test::space_arm::on_rail(fmt::format("kind = \"harmonic\"\nmean = \"0 mm\"\namplitude = "
                                           "\"10 mm\"\nfrequency = \"{} Hz\"\n",
                                           frequency)),
      60, 50);
  const Project project = parse_project("shaken.toml", text);
  const std::deque<SituationRun> runs = run_situations(project);
  // About y alone: in the plane of the others nothing moves it, though there it has modes as well.
  StoppedVibration stopped(project, chain_of(runs.front()), 48);
  std::vector<double> in_plane;
  for (const frame::BeamMode& mode : stopped.modes(chain_of(runs.front()).at(0.0), {}, 8))
    if (mode.energy[1] > 0.5) in_plane.push_back(mode.frequency);
  REQUIRE(in_plane.size() >= 3);
  REQUIRE(expected.frequencies.size() == 3);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(in_plane[k] == Approx(expected.frequencies[k]).epsilon(k == 0 ? 1e-6 : 2e-5));
  const VibrationInSpace found = estimate_vibration_in_space(project, runs.front(), 48);
  REQUIRE(found.obstacle.empty());
  REQUIRE(expected.without_modes.front() > 0.01);
  CHECK(found.estimate.without_modes.front() ==
        Approx(expected.without_modes.front()).epsilon(1e-6));
}

}  // namespace vibration_in_space_test
