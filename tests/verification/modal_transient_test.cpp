// Modes over a motion that does not repeat, against the closed forms of one oscillator.

#include "src/verification/modal_transient.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"

namespace modal_transient_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;

/// One mode under a static deflection that is given, with a number beside it.
struct Oscillator {
  double frequency = 1.0, damping = 0.0;  ///< [Hz], part of the critical one
  std::function<double(double)> balance;
  std::function<double(double)> beside = [](double) { return 1.0; };

  ModalTransient over(const OpenMotion& motion) const {
    const double omega = 2.0 * pi * frequency;
    const auto one = [](double value) { return Eigen::MatrixXd::Constant(1, 1, value); };
    const auto posture_at = [&](double time) -> PassedPosture {
      ModalPosture of;
      of.squares = one(omega * omega);
      of.damping = of.of_material = one(2.0 * damping * omega);
      of.of_rate = of.of_size = one(0.0);
      of.force = one(omega * omega * balance(time));
      of.turn = one(1.0);
      return {of, one(beside(time))};
    };
    return {
        motion,
        {posture_at, [](const Eigen::VectorXd& largest) { return Eigen::VectorXd(1e-9 * largest); },
         [&]() -> RestingModes {
           return {posture_at(motion.behind()).posture, one(frequency), one(3e8)};
         }}};
  }
};

LoadSpan span_of(const OpenMotion& motion) {
  return {si<Time>(motion.begin), si<Time>(motion.length), motion.instants, false};
}

}  // namespace

// Harris, Piersol, Shock and Vibration Handbook (2002), chapter 8: 1 - e^(-zeta omega t) (cos
// omega' t + zeta omega/omega' sin omega' t) after a sudden load, whose vibration is e^(-zeta omega
// t).
TEST_CASE("a sudden load is followed until a twentieth of it is left", "[transient]") {
  const double zeta = 0.02, omega = 2.0 * pi, own = omega * std::sqrt(1.0 - zeta * zeta);
  const OpenMotion motion{0.0, 1.3, 64, {0.0, 1.3}, true, true};
  const ModalTransient of =
      Oscillator{1.0, zeta, [](double time) { return time < 0.0 ? 0.0 : 1.0; }}.over(motion);
  const auto expected = [&](double t) {
    return 1.0 - std::exp(-zeta * omega * t) *
                     (std::cos(own * t) + zeta * omega / own * std::sin(own * t));
  };
  for (const double time : {0.0, 0.2, 0.77, 1.3, 1.9, 4.2})
    CHECK(of.response().at(time).eta[0] == Approx(expected(time)).margin(1e-6));
  const double last = of.response().times().back();
  const double peak = 1.0 + std::exp(-pi * zeta / std::sqrt(1.0 - zeta * zeta));
  CHECK(std::exp(-zeta * omega * last) == Approx(0.05 * peak).epsilon(2.0 * zeta));
  // Eight instants to a period of it, or as many to a second as the motion has.
  const LoadSpan span = of.span_of(span_of(motion));
  CHECK((span.begin + span.period).value() == Approx(last));
  CHECK(static_cast<double>(span.instants) == Approx(64.0 / 1.3 * last).margin(1.0));
  REQUIRE(span.breaks.size() == 1);
  CHECK(span.breaks.back().value() == Approx(1.3));
}

// Without damping three periods of it.
TEST_CASE("what does not die out is looked at for three periods", "[transient]") {
  const OpenMotion motion{2.0, 1.3, 64, {2.0, 3.3}, true, true};
  const ModalTransient of =
      Oscillator{0.8, 0.0, [](double time) { return time < 2.0 ? 0.0 : 1.0; }}.over(motion);
  CHECK(of.response().times().back() == Approx(3.3 + 3.0 / 0.8));
  CHECK(of.lowest_frequency() == Approx(0.8));
}

// eta = a + b t is a solution, which no vibration is in.
TEST_CASE("what is under way follows its balance", "[transient]") {
  const OpenMotion motion{0.5, 2.0, 64, {0.5, 2.5}, false, false};
  const ModalTransient of =
      Oscillator{1.7, 0.0, [](double time) { return 0.3 + 0.4 * time; }}.over(motion);
  CHECK(of.response().times().back() == 2.5);
  for (const double time : {0.5, 0.61, 1.4, 2.5})
    CHECK(of.response().at(time).eta[0] == Approx(0.3 + 0.4 * time).epsilon(1e-9));
  CHECK(of.span_of(span_of(motion)).breaks.empty());
}

TEST_CASE("numbers beside the equations are known at any time, on both sides of borders",
          "[transient]") {
  const OpenMotion motion{0.0, 2.0, 64, {0.0, 0.7, 2.0}, true, true};
  Oscillator oscillator{1.0, 0.01, [](double) { return 1.0; }};
  oscillator.beside = [](double time) {
    return time > 2.0 ? 5.0 : time < 0.7 ? std::sin(3.0 * time) : std::exp(-time);
  };
  const ModalTransient of = oscillator.over(motion);
  for (const double time : {0.0, 0.31, 0.699999, 0.700001, 1.4, 2.0, 2.000001, 3.0})
    CHECK(of.beside_at(time)[0] == Approx(oscillator.beside(time)).margin(1e-8));
}

TEST_CASE("more periods than instants resolve are refused", "[transient]") {
  const OpenMotion motion{0.0, 1.0, 64, {0.0, 1.0}, true, false};
  const ModalTransient of = Oscillator{1100.0, 0.0, [](double) { return 1.0; }}.over(motion);
  try {
    static_cast<void>(of.span_of(span_of(motion)));
    FAIL("not refused");
  } catch (const AnalysisError& error) {
    CHECK_THAT(error.failure().what, Catch::Contains("hold 1100 periods"));
  }
}

}  // namespace modal_transient_test
