// Vibration of the beam in motions of mechanisms in space, against the plane, closed forms, finite
// elements that share nothing with the program, and what must hold in every motion.

#include "src/verification/elastic_motion_in_space.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/elastic_motion.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "catch.hpp"
#include "support/slender_beam.hpp"
#include "support/space_arm.hpp"
#include "support/space_elements.hpp"
#include "support/swung_arm.hpp"

namespace elastic_motion_in_space_test {

using namespace boxbeam;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using namespace test::space_arm;

namespace {

constexpr double pi = std::numbers::pi, E = 210e9;

}  // namespace

// The definition: the virtual work of a body's masses times their accelerations, by differences,
// where it turns as exp(theta) in axes that turn with omega and alpha.
TEST_CASE("what turning adds is the virtual work of a body's masses", "[elastic_motion]") {
  std::mt19937 chance(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto vector = [&] { return Vector3d(any(chance), any(chance), any(chance)); };
  std::vector<Vector3d> masses;
  for (int i = 0; i < 6; ++i) masses.push_back(vector());
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& r : masses) mean += r / 6.0;
  Matrix3d inertia = Matrix3d::Zero();
  for (Vector3d& r : masses) {
    r -= mean;
    inertia += r.squaredNorm() * Matrix3d::Identity() - r * r.transpose();
  }
  const Vector3d omega = vector(), alpha = vector();
  const auto turned = [](const Vector3d& v) -> Matrix3d {
    return v.norm() == 0.0 ? Matrix3d::Identity()
                           : Eigen::AngleAxisd(v.norm(), v.normalized()).toRotationMatrix();
  };
  // Axes whose rate of turn is omega + alpha t in themselves, to the second order in t.
  const auto axes = [&](double t) -> Matrix3d { return turned(omega * t + 0.5 * alpha * t * t); };
  // Generalised inertia force against theta_i, of turns theta + rate t.
  const auto force = [&](const Vector3d& theta, const Vector3d& rate) {
    const double h = 1e-3, e = 1e-5;
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& r : masses) {
      const auto x = [&](double t, const Vector3d& v) -> Vector3d {
        return axes(t) * (turned(v + rate * t) * r);
      };
      // Of the fourth order in h.
      const Vector3d acceleration = (-x(2 * h, theta) + 16.0 * x(h, theta) - 30.0 * x(0.0, theta) +
                                     16.0 * x(-h, theta) - x(-2 * h, theta)) /
                                    (12.0 * h * h);
      for (int i = 0; i < 3; ++i) {
        const Vector3d d = e * Vector3d::Unit(i);
        sum[i] += acceleration.dot(x(0.0, theta + d) - x(0.0, theta - d)) / (2.0 * e);
      }
    }
    return sum;
  };
  const frame::TurningTerms terms = frame::turning_terms_of(inertia, {omega, alpha});
  const double small = 1e-3;
  for (int j = 0; j < 3; ++j) {
    const Vector3d d = small * Vector3d::Unit(j), none = Vector3d::Zero();
    const Vector3d of_size = (force(d, none) - force(-d, none)) / (2.0 * small);
    const Vector3d of_rate = (force(none, d) - force(none, -d)) / (2.0 * small);
    CHECK((of_size - terms.of_size.col(j)).norm() < 1e-4 * inertia.norm());
    CHECK((of_rate - terms.of_rate.col(j)).norm() < 1e-4 * inertia.norm());
  }
}

// The same beam as a chain of rigid finite elements of the plane and by its pieces in space, in a
// motion whose turning counts: equations, loads and basis are the plane's.
TEST_CASE("a motion of the plane written in space has the plane's vibration", "[elastic_motion]") {
  using namespace test::slender;
  const double frequency = 0.15, amplitude = 0.5;
  test::slender::Beam plane =
      tapered_and_turned(HarmonicDriver{0.0, amplitude, 2.0 * pi * frequency, 0.0});
  plane.solve(48);
  ElasticBody elastic = plane.elastic();
  elastic.parts = 384;
  const ElasticMotion vibrating(plane.rigid(), elastic, 2);
  const LoadsAt bent = bent_statically(plane.rigid(), elastic);
  const Moved of(slender({0.0, -1.0, 0.0}, swinging(amplitude, frequency), 60, 50, 81.0));
  // Two of them in the plane.
  const ElasticMotionInSpace coarse = of.by(4, 48, 48), fine = of.by(4, 96, 48);
  REQUIRE(fine.dynamic_part().cols() == 4);
  for (const double s : {0.0, 4.0, 9.0}) {
    const auto expected = [&](Time time) -> Cuts {
      return cuts_of(vibrating.loads_at(time), s) - cuts_of(bent(time), s);
    };
    const PlaneApart found(of, coarse, fine, s, 96, expected, [&](int i) {
      return si<Time>(plane.motion.begin + plane.motion.period * i / 96.0);
    });
    INFO("s = " << s << ": " << found.apart / found.rigid << ", of what vibrates "
                << found.apart / found.vibrating);
    CHECK(found.vibrating > 0.01 * found.rigid);
    CHECK(found.apart < 1e-6 * found.rigid);
    // In the plane of the others nothing moves it.
    CHECK(found.across < 1e-9 * found.rigid);
  }
}

namespace {

/// Root moment of a cantilever whose base turns by a small angle, over the one of the rigid beam:
///
///     w = a1 cos bx + a2 cosh bx + a3 sin bx + a4 sinh bx,
///     w(0) = 0, w'(0) = 1, w''(L) = w'''(L) = 0
///
/// M(0) = EI w''(0); rigid: rho A omega^2 L^3/3.
double turned_base(double EI, double mass, double L, double omega) {
  const double b = std::pow(omega * omega * mass / EI, 0.25);
  const double c = std::cos(b * L), s = std::sin(b * L), C = std::cosh(b * L), S = std::sinh(b * L);
  Eigen::Matrix4d system;
  system << 1, 1, 0, 0, 0, 0, b, b, -c, C, -s, S, s, S, -c, C;
  const Eigen::Vector4d a = system.lu().solve(Eigen::Vector4d(0, 1, 0, 0));
  return EI * b * b * (a[1] - a[0]) / (mass * omega * omega * L * L * L / 3.0);
}

}  // namespace

// Euler and Bernoulli, in both planes of the beam at once.
TEST_CASE("a beam on a hinge that swings about any axis vibrates as the closed solution says",
          "[elastic_motion]") {
  using test::slender::L;
  for (const double r : {0.2, 0.6, 1.3}) {
    const double frequency = r * test::slender::first_frequency(), small = 1e-4;
    const Vector3d axis(0.0, 0.6, 0.8);
    const Moved of(slender(axis, swinging(small, frequency), 80, 100, 1e6));
    const ElasticMotionInSpace elastic = of.by(6, 16);
    const Section& section = of.project.beam.segments.front().from;
    const SectionProperties properties = properties_of(section);
    const double mass = 7850.0 * properties.area.value(), omega = 2.0 * pi * frequency;
    const double about_y = turned_base(E * properties.I_y.value(), mass, L, omega),
                 about_z = turned_base(E * properties.I_z.value(), mass, L, omega);
    const double size = mass * omega * omega * L * L * L / 3.0 * small *
                        std::max({1.0, std::abs(about_y), std::abs(about_z)});
    for (const double part : {0.05, 0.3, 0.77}) {
      const Cuts rigid = cuts_of(of.rigid().loads_at(of.at(part)), 0.0),
                 found = cuts_of(elastic.loads_at(of.at(part)), 0.0);
      INFO("r = " << r << ", part " << part);
      CHECK(found[4] == Approx(about_y * rigid[4]).margin(2e-4 * size));
      CHECK(found[5] == Approx(about_z * rigid[5]).margin(2e-4 * size));
    }
  }
}

// A point mass beside the tip of an arm without mass whose base shakes along z: one freedom of
// flexibility L^3/(3 E I) + L/(G A_s) + e^2 L/(G I_T), all of it 1/(1 - r^2) times.
TEST_CASE("an eccentric mass twists an arm as an oscillator of one freedom", "[elastic_motion]") {
  const double L = 4.0, e = 0.7, m = 150.0, r = 0.5;
  const auto text = [&](double frequency) {
    return arm(on_rail(fmt::format("kind = \"harmonic\"\nmean = \"0 m\"\namplitude = \"1 mm\"\n"
                                   "frequency = \"{:.12g} Hz\"\n",
                                   frequency)) +
                   with_load(m, fmt::format("centre = [\"0 m\", \"{} m\", \"0 m\"]\n", e)),
               light);
  };
  const Project project = parse_project("arm.toml", text(1.0));
  const double give = give_of(project.beam.segments.front().from, L, e);
  const Moved of(text(r / (2.0 * pi * std::sqrt(m * give))));
  const ElasticMotionInSpace elastic = of.by(3, 8);
  for (const double part : {0.1, 0.6}) {
    const Cuts rigid = cuts_of(of.rigid().loads_at(of.at(part)), 1.0),
               found = cuts_of(elastic.loads_at(of.at(part)), 1.0);
    REQUIRE(std::abs(rigid[3]) > 0.1 * std::abs(rigid[4]));
    check_alike(found, rigid / (1.0 - r * r), rigid, 1e-4);
  }
}

// A hinge that swings by a small angle about any axis, and sixty elements with the same body:
// (K - omega^2 M) u = omega^2 M R, and the forces on the root of u and of R together.
TEST_CASE("an L on a swinging hinge vibrates as a model of finite elements", "[elastic_motion]") {
  const double small = 1e-6;
  Matrix3d J;
  J << 9, 1, -2, 1, 6, 0.5, -2, 0.5, 11;
  const Vector3d centre(0.1, 1.2, -0.4);
  for (const auto& [axis, frequency] : {std::pair{Vector3d(0.48, -0.6, 0.64), 2.0},
                                        {Vector3d(0.48, -0.6, 0.64), 6.0},
                                        {Vector3d(1.0, 0.0, 0.0), 3.0},
                                        {Vector3d(0.0, 0.0, 1.0), 1.0}}) {
    const Moved of(arm(hinge(axis, small, frequency) + beside, steel));
    const ElasticMotionInSpace elastic = of.by(8, 16);
    auto [K, M] = test::space_elements::assembled(of.project.beam, 120.0, centre, J);
    const Eigen::Index nodes = K.rows() / 6, free = K.rows() - 6;
    // Rotary inertia of the beam across its axis, at the nodes.
    const SectionProperties section = properties_of(of.project.beam.segments.front().from);
    const double h = 4.0 / static_cast<double>(nodes - 1), rho = 7850.0;
    VectorXd R(K.rows());
    for (Eigen::Index i = 0; i < nodes; ++i) {
      const double share = i == 0 || i == nodes - 1 ? 0.5 : 1.0;
      M(6 * i + 4, 6 * i + 4) += share * h * rho * section.I_y.value();
      M(6 * i + 5, 6 * i + 5) += share * h * rho * section.I_z.value();
      R.segment<3>(6 * i) = axis.cross(Vector3d(h * static_cast<double>(i), 0.0, 0.0));
      R.segment<3>(6 * i + 3) = axis;
    }
    const double square = std::pow(2.0 * pi * frequency, 2);
    const MatrixXd dynamic = K - square * M;
    VectorXd u = VectorXd::Zero(K.rows());
    u.tail(free) = dynamic.bottomRightCorner(free, free).lu().solve(square * (M * R).tail(free));
    const Cuts root = -(dynamic * u - square * M * R).head<6>();
    INFO("axis " << axis.transpose() << ", " << frequency << " Hz against "
                 << elastic.lowest_frequency());
    for (const double part : {0.2, 0.55}) {
      const double turn = small * std::sin(2.0 * pi * part);
      check_alike(cuts_of(elastic.loads_at(of.at(part)), 0.0), turn * root, turn * root, 5e-4);
    }
    // The rigid arm is far from it.
    const double turn = small * std::sin(2.0 * pi * 0.2);
    const Cuts rigid = cuts_of(of.rigid().loads_at(of.at(0.2)), 0.0);
    CHECK((rigid - turn * root).tail<3>().norm() > 0.01 * std::abs(turn) * root.tail<3>().norm());
  }
}

// Invariant: the scene turned as a whole.
TEST_CASE("however a scene lies in the world its beam moves alike", "[elastic_motion]") {
  const Moved straight(arm(slewing("", swinging(0.7, 0.6, 0.2)) + beside, steel)),
      turned(arm(slewing("turn = [[\"x\", \"70 deg\"], [\"z\", \"-130 deg\"], [\"y\", \"15 deg\"]]",
                         swinging(0.7, 0.6, 0.2)) +
                     beside,
                 steel));
  const ElasticMotionInSpace one = straight.by(4, 8), other = turned.by(4, 8);
  for (const double part : {0.0, 0.123, 0.4, 0.81}) {
    for (const double s : {0.0, 1.3, 3.1}) {
      const Cuts expected = cuts_of(one.loads_at(straight.at(part)), s),
                 rigid = cuts_of(straight.rigid().loads_at(straight.at(part)), s);
      check_alike(cuts_of(other.loads_at(turned.at(part)), s), expected, expected, 1e-7);
      CHECK((expected - rigid).norm() > 1e-4 * rigid.norm());
    }
  }
}

// Invariants: nothing changes with time in axes that turn steadily; and along the arm, which its
// own pull stretches, rigid bodies miss (omega/omega_stretching)^2 alone.
TEST_CASE("steady turning vibrates nothing", "[elastic_motion]") {
  const auto spun = [](const std::string& tip) {
    return Moved(arm(
        hinge({0, 0, 1}, "kind = \"constant rate\"\nstart = \"0 rad\"\nrate = \"2 rad/s\"\n") + tip,
        steel));
  };
  const Moved plain = spun("");
  const ElasticMotionInSpace stretched = plain.by(6, 8);
  const Cuts rigid = cuts_of(plain.rigid().loads_at(plain.at(0.0)), 0.0);
  REQUIRE(rigid[0] > 0.0);
  check_alike(cuts_of(stretched.loads_at(plain.at(0.3)), 0.0), rigid, Cuts::Constant(rigid[0]),
              1e-6);
  const Moved leaning = spun(beside);
  const ElasticMotionInSpace bent = leaning.by(6, 8);
  const Cuts first = cuts_of(bent.loads_at(leaning.at(0.0)), 0.0);
  for (const double part : {0.2, 0.51, 0.9})
    check_alike(cuts_of(bent.loads_at(leaning.at(part)), 0.0), first, first, 1e-7);
}

TEST_CASE("a mass on an arm that swings far moves as integration over time says",
          "[elastic_motion]") {
  const double frequency = 1.0, amplitude = 0.8;
  const SwungArm arm(swinging(amplitude, frequency),
                     HarmonicDriver{0.0, amplitude, 2.0 * pi * frequency, 0.0});
  const MatrixXd& eta = arm.elastic.coordinates();
  REQUIRE(eta.cols() == 3);
  const auto path = arm.mass.periodic(1.0 / frequency);
  double largest = 0.0, apart = 0.0;
  for (Eigen::Index i = 0; i < eta.rows(); ++i) {
    const auto at = static_cast<std::size_t>(i * SwungMass::steps / eta.rows());
    if (static_cast<Eigen::Index>(at) * eta.rows() != i * SwungMass::steps) continue;
    const Vector3d expected = path[at].head<3>(), found = arm.tip * eta.row(i).transpose();
    largest = std::max(largest, expected.norm());
    apart = std::max(apart, (expected - found).norm());
  }
  INFO(apart / largest << " of " << largest << " m, " << arm.elastic.lowest_frequency() << " Hz");
  REQUIRE(largest > 0.0);
  CHECK(apart < 1e-4 * largest);
}

TEST_CASE("what the drive does beyond rigid bodies is dissipated", "[elastic_motion]") {
  const Vector3d axis(0.48, -0.6, 0.64);
  const double small = 1e-4, frequency = 4.0;
  const Moved of(arm(hinge(axis, small, frequency) + beside, steel,
                     "[model]\ndamping = { ratio = 0.05, at = \"6 Hz\" }\n"));
  const ElasticMotionInSpace elastic = of.by(6, 8);
  REQUIRE(elastic.coordinates().cols() == 6);
  check_dissipated(of, elastic, axis, small, frequency, 0.05 / (pi * 6.0));
}

namespace {

/// Two wheels on the arm, whose teeth mesh there.
const std::string meshing = R"(
[bodies.pinion]
mass = "8 kg"
inertia = ["0.02 kg m^2", "0.02 kg m^2", "0.04 kg m^2"]
points = { o = ["0 m", "0 m", "0 m"] }
[bodies.wheel]
mass = "20 kg"
inertia = ["0.2 kg m^2", "0.2 kg m^2", "0.4 kg m^2"]
points = { o = ["0 m", "0 m", "0 m"] }
[joints.pinion]
kind = "revolute"
connect = ["arm.mid", "pinion.o"]
axis = "z"
[joints.wheel]
kind = "revolute"
connect = ["arm.tip", "wheel.o"]
axis = "z"
[joints.mesh]
kind = "gear"
joints = ["pinion", "wheel"]
ratio = -0.5
[drivers.pinion]
joint = "pinion"
kind = "harmonic"
mean = "0 rad"
amplitude = "0.5 rad"
frequency = "1 Hz"
)";

}  // namespace

TEST_CASE("what modes do not hold is refused with its reason", "[elastic_motion]") {
  const auto refused = [](const std::string& text, const std::string& why) {
    const Moved of(text);
    try {
      of.by(2, 8);
      FAIL("not refused: " << why);
    } catch (const AnalysisError& error) {
      CHECK_THAT(error.failure().what, Catch::Contains(why));
    }
  };
  const std::string once = arm(hinge({0, 0, 1}, 0.1, 1.0) + beside, steel);
  // Without damping, in the first frequency to seven digits.
  const double first = Moved(once).modes(8, 1).front().frequency;
  refused(arm(hinge({0, 0, 1}, 1e-6, first) + beside, steel), "without damping");
  refused(arm(hinge({0, 0, 1}, 0.1, 1.0) + meshing, steel), "the teeth of mesh mesh on the beam");
}

TEST_CASE("where modes do not hold bodies stay rigid, and elastic ones are refused",
          "[elastic_motion]") {
  const std::string fast = arm(hinge({0, 0, 1}, 0.1, 1.0) + meshing + beside, steel);
  Project project = parse_project("arm.toml", fast);
  const ModelChoice choice = choose_model(project);
  CHECK(choice.chosen.level == ModelLevel::rigid);
  CHECK_THAT(choice.reason,
             Catch::Contains("no modes of the beam are used: the teeth of mesh mesh on the beam"));
  CHECK(vibration_missed_in_space(project, choice) > choice.tolerance);
  project.model.demand = ModelDemand::flexible;
  CHECK_THROWS_WITH(choose_model(project), Catch::Contains("cannot be had"));
  project = parse_project("arm.toml", arm(hinge({0, 0, 1}, 0.1, 1.0) + beside, steel));
  project.model.demand = ModelDemand::flexible;
  const ModelledRuns runs = run_by_chosen_model(project);
  CHECK(runs.model.chosen.level == ModelLevel::modal);
  CHECK(runs.model.weighed.back().found.value() <= project.model.tolerance);
}

}  // namespace elastic_motion_in_space_test
