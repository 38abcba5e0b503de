// Joints of the plane that give way beside the verified beam: closed forms of a lever on springs,
// and joints of no flexibility, which are rigid ones.

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "boxbeam/verification/elastic_motion.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "catch.hpp"
#include "support/lever.hpp"
#include "support/refusals.hpp"

namespace elastic_joints_test {

using namespace boxbeam;
using namespace test::lever;

namespace {

ElasticBody stiff_lever(const Project& project, double factor = 1e7) {
  ElasticBody elastic = elastic_body_of(project, 32);
  stiffen(elastic, factor, factor, factor);
  return elastic;
}

double moment_at(const BeamLoads& loads, double s) {
  return cut_forces_of(loads).at({si<Length>(s), Side::behind}).M_y.value();
}

}  // namespace

TEST_CASE("pins that give way and a rod are springs in series", "[elastic_joints]") {
  Scene scene;
  hold_by_body(scene, 1e-6, L, -2.0, 2.0);
  constexpr double k1 = 3e5, k2 = 7e5;
  give(scene, "head", stiffness(k1));
  give(scene, "foot", stiffness(k2));
  const Solved of(scene);
  const ElasticBody elastic = stiff_lever(of.project);
  REQUIRE(elastic.joints.size() == 2);
  const double k3 = E * scene.side * scene.side / 2.0;
  const double k = 1.0 / (1.0 / k1 + 1.0 / k2 + 1.0 / k3);
  CHECK(of.frequencies(elastic, 1).front() ==
        Approx(std::sqrt(3.0 * k / M) / (2 * pi)).epsilon(1e-4));
}

TEST_CASE("a stiff lever on a hinge and a stay that give way", "[elastic_joints]") {
  // Along it k/M, both ends alike 2 k/M, one against the other k L^2/2 over M L^2/12.
  constexpr double k = 2e5;
  for (const double angle : {0.0, 35.0}) {
    Scene scene;
    scene.angle = angle;
    scene.hinge += stiffness(k);
    const double c = std::cos(angle * pi / 180.0), s = std::sin(angle * pi / 180.0);
    hold_by_link(scene, L * c + 2.0 * s, L * s - 2.0 * c, 2.0);
    give(scene, "stay", stiffness(k));
    const Solved of(scene);
    const ElasticBody elastic = stiff_lever(of.project);
    // Its own stiffness counts, not that of the section.
    REQUIRE(elastic.lines.empty());
    const std::vector<double> found = of.frequencies(elastic, 3);
    const double squares[] = {k / M, 2.0 * k / M, 6.0 * k / M};
    for (std::size_t i = 0; i < 3; ++i) {
      CAPTURE(angle, i);
      CHECK(found[i] == Approx(std::sqrt(squares[i]) / (2 * pi)).epsilon(1e-4));
    }
  }
}

TEST_CASE("a lever in a clamp that gives way", "[elastic_joints]") {
  // omega^2 = 3 k/(M L^2); P_cr = k/L, M_0 = H L/(1 - P/P_cr) under H across its end: Timoshenko,
  // Gere, Theory of Elastic Stability (1961), section 2.1.
  constexpr double k = 5e4, P = 4000.0, H = 50.0;
  Scene scene;
  scene.angle = 90.0;
  scene.hinge =
      fmt::format("kind = \"rigid\"\nangle = \"90 deg\"\nturning_stiffness = \"{} N m/rad\"\n", k) +
      at_ground;
  scene.forces = force_at_end(H, -P);
  const Solved of(scene);
  const ElasticBody elastic = stiff_lever(of.project);
  REQUIRE(elastic.joints.size() == 1);
  CHECK(of.critical_factor(elastic) == Approx(k / (L * P)).epsilon(1e-5));
  CHECK(of.frequencies(elastic, 1).front() ==
        Approx(std::sqrt(3.0 * (k - P * L) / (M * L * L)) / (2 * pi)).epsilon(1e-4));
  const BeamLoads straight = of.loads(of.motion.states.front());
  const BeamLoads bent = bent_statically(of.rigid(), elastic)(Time{});
  CHECK(std::abs(moment_at(straight, 0.0)) == Approx(H * L).epsilon(1e-9));
  CHECK(moment_at(bent, 0.0) == Approx(moment_at(straight, 0.0) / (1.0 - P * L / k)).epsilon(1e-4));
  CHECK(imbalance_of(bent).force.norm() < 1e-6 * P);
  CHECK(imbalance_of(bent).moment.norm() < 1e-6 * P * L);
}

TEST_CASE("each kind of joint gives way where it holds", "[elastic_joints]") {
  constexpr double k = 3e5, turning = 8e4;
  const std::string both =
      stiffness(k) + fmt::format("turning_stiffness = \"{} N m/rad\"\n", turning);
  // Across and about its start: K = diag(k, k_phi), M = [M, M L/2; M L/2, M L^2/3].
  Eigen::Matrix2d mass;
  mass << M, M * L / 2.0, M * L / 2.0, M * L * L / 3.0;
  const Eigen::Matrix2d held = Eigen::Vector2d(k, turning).asDiagonal();
  const Eigen::Vector2d squares =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(held, mass).eigenvalues();
  const auto expect = [](const Scene& scene, std::vector<double> expected) {
    const Solved of(scene);
    const std::vector<double> found = of.frequencies(stiff_lever(of.project), expected.size());
    std::sort(expected.begin(), expected.end());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      CAPTURE(scene.hinge, i);
      CHECK(found[i] == Approx(std::sqrt(expected[i]) / (2 * pi)).epsilon(1e-4));
    }
  };
  Scene clamped;
  clamped.hinge = "kind = \"rigid\"\n" + at_ground + both;
  expect(clamped, {k / M, squares[0], squares[1]});
  Scene guided;
  guided.hinge =
      "kind = \"slider\"\npoint = \"lever.A\"\nthrough = [\"0 m\", \"0 m\"]\n"
      "direction = \"0 deg\"\n" +
      both;
  guided.joints =
      "[drivers.along]\ncoordinate = \"x\"\npoint = \"lever.A\"\nkind = \"hold\"\n"
      "value = \"0 m\"\n";
  expect(guided, {squares[0], squares[1]});
  Scene slotted;
  slotted.joints =
      "[joints.slot]\nkind = \"pin in slot\"\npoint = \"lever.B\"\n"
      "through = [\"0 m\", \"0 m\"]\ndirection = \"0 deg\"\n" +
      stiffness(k);
  expect(slotted, {3.0 * k / M});
}

TEST_CASE("a shaken lever on a stay with a damper", "[elastic_joints]") {
  // m = M/3 at its end: the end follows the shoe as (k + i c w)/(k - m w^2 + i c w), and what bends
  // the lever follows its end. Timoshenko, Young, Weaver, Vibration Problems in Engineering (1974),
  // section 1.10.
  using Complex = std::complex<double>;
  constexpr double k = 4e5;
  for (const auto& [r, zeta] : {std::pair(0.3, 0.0), std::pair(0.7, 0.1), std::pair(1.0, 0.2)}) {
    Scene scene;
    const double m = M / 3.0, omega = r * std::sqrt(k / m), c = 2.0 * zeta * std::sqrt(k * m);
    drive_shoe(scene, L, -2.0,
               fmt::format("kind = \"harmonic\"\nmean = \"-2 m\"\namplitude = \"0.0002 m\"\n"
                           "angular_frequency = \"{:.17g} rad/s\"\n",
                           omega));
    scene.joints += fmt::format(
        "[joints.stay]\nkind = \"distance\"\nconnect = [\"lever.B\", \"shoe.S\"]\n"
        "length = \"2 m\"\n{}damping = \"{:.17g} N s/m\"\n",
        stiffness(k), c);
    const Solved of(scene, 48);
    const ElasticBody elastic = stiff_lever(of.project, 1e6);
    const ElasticMotion motion(of.rigid(), elastic, 1);
    const auto rigid_at = [&](double part) {
      return moment_at(of.loads(of.finder->at(part * of.motion.period)), 0.5 * L);
    };
    const Complex follows =
        Complex(k, c * omega) / Complex(k - m * omega * omega, c * omega) * rigid_at(0.25);
    for (const double part : {0.1, 0.25, 0.7}) {
      CAPTURE(r, zeta, part);
      CHECK(moment_at(motion.loads_at(si<Time>(part * of.motion.period)), 0.5 * L) ==
            Approx((follows * std::polar(1.0, 2 * pi * part)).imag())
                .margin(3e-3 * std::abs(follows)));
    }
    if (zeta > 0.0) continue;
    // What rigid bodies miss: 1/(1 - r^2) - 1.
    const LoadHistory history{{si<Time>(of.motion.begin), si<Time>(of.motion.period),
                               of.motion.states.size(), of.motion.closed},
                              of.rigid().loads};
    CHECK(estimate_vibration(of.rigid(), elastic, history).without_modes.front() ==
          Approx(r * r / (1.0 - r * r)).epsilon(5e-3));
  }
}

TEST_CASE("joints of no flexibility are rigid joints", "[elastic_joints]") {
  for (const std::string& driver : {shaking, lifting}) {
    Scene scene = moved(false, driver);
    scene.hinge += stiffness(1e16);
    give(scene, "guide", stiffness(1e16) + "turning_stiffness = \"1e16 N m/rad\"\n");
    give(scene, "stay", stiffness(1e16));
    const Solved of(scene, 48);
    const ElasticBody stiff = elastic_body_of(of.project, 8);
    REQUIRE(stiff.joints.size() == 3);
    ElasticBody alone = stiff;
    alone.joints.clear();
    const std::vector<double> found = of.frequencies(stiff, 3), rigid = of.frequencies(alone, 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(found[i] == Approx(rigid[i]).epsilon(1e-9));
    const Time time = si<Time>(0.4);
    check_same_loads(bent_statically(of.rigid(), stiff)(time),
                     bent_statically(of.rigid(), alone)(time), 1e-9);
    check_same_loads(ElasticMotion(of.rigid(), stiff, 2).loads_at(time),
                     ElasticMotion(of.rigid(), alone, 2).loads_at(time), 1e-8);
  }
}

TEST_CASE("joints that give way in a case", "[elastic_joints]") {
  Scene scene = moved(false, shaking);
  scene.hinge += stiffness(5e5);
  const ModelChoice of = choose_model(parse_project("lever.toml", scene.text()));
  CHECK(of.reason.find("(joint hinge, stay elastic as well)") != std::string::npos);
  const auto problems_of = [](const std::string& text) {
    return test::refusal_of([&] { return parse_project("lever.toml", text); });
  };
  Scene damped = moved(false, shaking);
  damped.hinge += "damping = \"1 N s/m\"\n";
  CHECK(problems_of(damped.text()).find("without \"stiffness\" nothing does") != std::string::npos);
  scene.rod +=
      "[[situations]]\nname = \"one\"\n[[situations]]\nname = \"other\"\n"
      "set = { \"joints.hinge.stiffness\" = \"6e5 N/m\" }\n";
  CHECK(problems_of(scene.text()).find("those of all situations") != std::string::npos);
}

}  // namespace elastic_joints_test
