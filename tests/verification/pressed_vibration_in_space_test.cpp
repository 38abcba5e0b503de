// Vibration in space of a beam that is pressed, or held by springs: how it bends statically.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/gates.hpp"
#include "support/hub_and_arm.hpp"

namespace pressed_vibration_in_space_test {

using namespace boxbeam;
using namespace test::space_arm;

namespace {

constexpr double pi = std::numbers::pi, E = 210e9, L = 4.0, mass = 100.0, amplitude = 0.01;

/// Without weight and, but for a point at the tip, without mass.
test::hub_and_arm::HubAndArm light(double at_tip) {
  test::hub_and_arm::HubAndArm of;
  of.hub = 1.0;
  of.load = at_tip;
  of.centre.setZero();
  of.inertia.setConstant(1e-6);
  of.density = 1e-3;
  of.gravity = 0.0;
  return of;
}

/// What moves the hub.
std::string shaken(double size, double frequency) {
  return fmt::format(
      "[drivers.fall]\njoint = \"fall\"\nkind = \"harmonic\"\nmean = \"0 m\"\namplitude = "
      "\"{:.17g} m\"\nfrequency = \"{:.17g} Hz\"\n",
      size, frequency);
}

/// A light arm on a hub that is shaken across it, along y or z, with a mass on its tip, which is
/// pressed by a part of the critical force and pushed aside.
struct Pressed {
  bool along_z = true;
  double part = 0.3;     ///< of the critical force
  double ratio = 0.5;    ///< of frequencies
  double aside = 500.0;  ///< [N]

  double EI() const {
    const SectionProperties of = properties_of(
        {symmetric_box(0.12 * metre, 0.16 * metre, 0.008 * metre, 0.006 * metre), {}});
    return E * (along_z ? of.I_y : of.I_z).value();
  }
  double press() const { return part * std::pow(pi / (2.0 * L), 2) * EI(); }
  /// tan u/u, by which a force across and the pressing one on the bent arm make more at the root.
  double grown() const {
    const double u = 0.5 * pi * std::sqrt(part);
    return std::tan(u) / u;
  }
  /// P/(L (tan u/u - 1)), Timoshenko and Gere, Theory of Elastic Stability (1961), section 1.3.
  double omega_1() const { return std::sqrt(press() / (L * (grown() - 1.0)) / mass); }
  double omega() const { return ratio * omega_1(); }
  /// At the root.
  double moment(double time) const {
    const double shaken =
        mass * omega() * omega() * amplitude / (1.0 - ratio * ratio) * std::sin(omega() * time);
    return grown() * L * (aside + shaken);
  }

  std::string text() const {
    test::hub_and_arm::HubAndArm scene = light(mass);
    scene.across = along_z ? "z" : "y";
    return scene.text(fmt::format(R"(
[forces.press]
kind = "force"
point = "arm.tip"
direction = [-1, 0, 0]
size = "{:.17g} N"
[forces.aside]
kind = "force"
point = "arm.tip"
direction = [0, {}, {}]
size = "{:.17g} N"
)",
                                  press(), along_z ? 0 : 1, along_z ? 1 : 0, aside) +
                          shaken(amplitude, omega() / (2.0 * pi)),
                      true);
  }
};

/// As stiff in shear as nothing is.
Project without_shear(const Pressed& of) {
  Project project = parse_project("arm.toml", of.text());
  project.model.youngs_modulus = E;
  project.model.shear_modulus = 1e6 * 8.1e10;
  return project;
}

}  // namespace

// One degree of freedom: m d'' + k_P d = -m x'' + Q. The moment at the root is tan u/u L times the
// force across, k_P d.
TEST_CASE("a pressed arm whose hub is shaken across it vibrates as the beam-column says",
          "[pressed_vibration]") {
  for (const bool along_z : {true, false}) {
    for (const double part : {0.05, 0.3, 0.6}) {
      // Across it would buckle.
      if (along_z && part > 0.5) continue;
      for (const double ratio : {0.3, 0.7, 1.6}) {
        const Pressed pressed{along_z, part, ratio};
        const Moved moved(without_shear(pressed));
        const ElasticMotionInSpace straight = moved.by(4, 16), bent = moved.bent_by(4, 16);
        const int at = along_z ? 4 : 5;
        const double sign = cuts_of(moved.rigid().loads_at(Time()), 0.0)[at] > 0.0 ? 1.0 : -1.0;
        double largest = 0.0, apart = 0.0, first = 0.0;
        for (int i = 0; i < 24; ++i) {
          const Time time = moved.at(i / 24.0);
          const double expected = sign * pressed.moment(time.value());
          largest = std::max(largest, std::abs(expected));
          apart = std::max(apart, std::abs(cuts_of(bent.loads_at(time), 0.0)[at] - expected));
          first = std::max(first, std::abs(cuts_of(straight.loads_at(time), 0.0)[at] - expected));
        }
        INFO("along " << (along_z ? "z" : "y") << ", pressed by " << part << ", at " << ratio
                      << ": largest " << largest << ", apart " << apart << ", without " << first);
        CHECK(apart < 1e-6 * largest);
        // Of the force aside alone what the second order adds.
        CHECK(first > 0.9 * pressed.aside * L * (pressed.grown() - 1.0));
      }
    }
  }
}

TEST_CASE("modes in space are chosen with statics of the second order where an arm is pressed",
          "[pressed_vibration]") {
  const Pressed pressed{true, 0.3, 0.5};
  const Verification of = verify(parse_project("arm.toml", pressed.text()));
  INFO(of.model.reason);
  CHECK(of.model.chosen.level == ModelLevel::modal);
  CHECK(of.model.chosen.bends_twice);
  CHECK(of.model.counts_second_order);
  CHECK_THAT(of.model.reason, Catch::Contains("second order"));
  for (const Gate& gate : of.gates) {
    INFO(gate.finding);
    CHECK_THAT(gate.finding, !Catch::Contains("theory of the first order does not hold"));
  }
}

// Pressed by 0.45 of what it bears along z, by 0.8 across.
TEST_CASE("near buckling about either axis of an arm in space no vibration is proven",
          "[pressed_vibration]") {
  for (const bool along_z : {true, false}) {
    const Pressed pressed{along_z, along_z ? 0.45 : 0.8, 0.5};
    const Verification of = verify(parse_project("arm.toml", pressed.text()));
    INFO(of.model.reason);
    REQUIRE(of.model.chosen.level == ModelLevel::modal);
    CHECK(test::blocks(of, "vibration is not proven"));
  }
}

// A spring k below the tip of an arm whose hub is shifted by a bears a/(1/k + L^3/(3 E I)), for the
// arm gives way. Where a joint slides along the arm, or the case says what holds it besides, no
// second order of the mechanism is known.
TEST_CASE("what a spring takes over from an arm is known where its second order is not",
          "[pressed_vibration]") {
  constexpr double k = 4e5, shift = 0.01;
  const std::string below = fmt::format(R"(
[forces.below]
kind = "spring"
connect = ["ground", "arm.tip"]
at = ["4 m", "0 m", "-1 m"]
stiffness = "{:.17g} N/m"
free_length = "1 m"
)",
                                        k);
  // Next to nothing.
  const std::string trolley = R"(
[bodies.trolley]
mass = "0.1 kg"
centre = ["0 m", "0 m", "0 m"]
inertia = ["1e-3 kg m^2", "1e-3 kg m^2", "1e-3 kg m^2"]
points = { c = ["0 m", "0 m", "0 m"] }
[joints.run]
kind = "prismatic"
connect = ["arm.heel", "trolley.c"]
axis = "x"
[drivers.run]
joint = "run"
kind = "harmonic"
mean = "2 m"
amplitude = "0.5 m"
frequency = "0.1 Hz"
)";
  const std::string said =
      "[[beam.restraints]]\nstation = \"0 m\"\nholds = [\"along y\", \"along z\", \"turning "
      "over\"]\nclamped = true\n";
  for (const auto& [running, held] : {std::pair{trolley, std::string()}, {std::string(), said}}) {
    test::hub_and_arm::HubAndArm scene = light(1e-3);
    scene.density = 1.0;
    Project project =
        parse_project("arm.toml", scene.text(below + running + shaken(shift, 0.1), true, "", held));
    project.model.youngs_modulus = E;
    project.model.shear_modulus = 1e6 * 8.1e10;
    const double bears = shift / (1.0 / k + std::pow(L, 3) / (3.0 * Pressed{}.EI()));
    const ModelledRuns chosen = run_by_chosen_model(project);
    INFO(chosen.model.reason);
    REQUIRE(!chosen.model.weighed.empty());
    CHECK(chosen.model.weighed.front().error == Approx(1.0 - bears / (k * shift)).epsilon(0.05));
    CHECK(chosen.model.chosen.level == ModelLevel::modal);
    double largest = 0.0;
    for (int i = 0; i < 64; ++i) {
      const LoadHistory& loads = chosen.runs.front().loads;
      const Time time = loads.begin() + loads.period() * (i / 64.0);
      largest = std::max(largest, std::abs(cuts_of(loads.loads_at(time), 0.0)[4]));
    }
    CHECK(largest == Approx(bears * L).epsilon(2e-3));
  }
}

}  // namespace pressed_vibration_in_space_test
