// Vibration of a cantilever in motions that do not repeat, against the sum of its modes by
// Duhamel's integral, finite elements stepped through time, and its periodic motion.

#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "catch.hpp"
#include "support/slender_beam.hpp"

namespace elastic_start_test {

using namespace boxbeam;
using namespace test::slender;

namespace {

constexpr double pi = std::numbers::pi;

double root_moment(const BeamLoads& loads) {
  return cut_forces_of(loads).at({Length{}, Side::behind}).M_y.value();
}

const double first_period = 1.0 / first_frequency();

/// Modes of a cantilever of Euler and Bernoulli: mode j bears at its root, per acceleration of the
/// base, a part of the rigid moment rho A L^2/2,
///
///     2 (2 s_j/b_j) (2/b_j^2),  b_j = beta_j L,  s_j = (sinh b - sin b)/(cosh b + cos b)
///
/// its mass times its height; the parts add up to one. Source: Blevins, Formulas for Natural
/// Frequency and Mode Shape (1979), table 8-1, with the integrals of its shapes.
struct RootMode {
  double omega = 0.0, part = 0.0;
};

std::vector<RootMode> root_modes(int count) {
  std::vector<RootMode> modes;
  for (int j = 1; j <= count; ++j) {
    double b = j == 1 ? 1.875104 : (j - 0.5) * pi;
    for (int i = 0; i < 20; ++i) {  // cos b cosh b = -1, by Newton, over cosh b
      const double f = std::cos(b) + 1.0 / std::cosh(b);
      b -= f / (-std::sin(b) - std::tanh(b) / std::cosh(b));
    }
    const double first = 1.8751040687119612;
    const double s =
        (std::tanh(b) - std::sin(b) / std::cosh(b)) / (1.0 + std::cos(b) / std::cosh(b));
    modes.push_back({2 * pi * first_frequency() * std::pow(b / first, 2),
                     2.0 * (2.0 * s / b) * (2.0 / (b * b))});
  }
  return modes;
}

/// The root's moment over the rigid one of unit acceleration, at rest before `begin`, by Duhamel's
/// integral of each mode,
///
///     omega^2 int a(t - u) (h + tau h') du,  h(u) = e^(-zeta omega u) sin(omega' u)/omega'
///
/// zeta = omega tau/2: what elasticity and viscosity bear together; by Simpson's rule with 64
/// points to a period. What the rest of the modes bears follows a(t).
double moment_by_modes(const std::function<double(double)>& a, double begin, double t,
                       double tau = 0.0, int count = 12) {
  double moment = 0.0, parts = 0.0;
  for (const RootMode& mode : root_modes(count)) {
    const double zeta = 0.5 * mode.omega * tau;
    parts += mode.part;
    if (zeta >= 1.0) {
      moment += mode.part * a(t);
      continue;
    }
    const double own = mode.omega * std::sqrt(1.0 - zeta * zeta);
    const int n = 2 * static_cast<int>(std::ceil(32.0 * own * (t - begin) / (2 * pi) + 100.0));
    const double h = (t - begin) / n;
    double sum = 0.0;
    for (int i = 0; i <= n; ++i) {
      const double u = h * i;
      const double weight = i == 0 || i == n ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      const double sine = std::sin(own * u) / own;
      const double borne = sine + tau * (std::cos(own * u) - zeta * mode.omega * sine);
      sum += weight * a(t - u) * std::exp(-zeta * mode.omega * u) * borne;
    }
    moment += mode.part * mode.omega * mode.omega * sum * h / 3.0;
  }
  return moment + (1.0 - parts) * a(t);
}

/// Hermite's finite elements of a cantilever whose root is moved, by Newmark's method of constant
/// mean acceleration, which damps nothing. The root's moment is K u there.
class SteppedCantilever {
 public:
  static constexpr int elements = 24;
  static constexpr int size = 2 * elements;
  using Vector = Eigen::Matrix<double, size, 1>;

  SteppedCantilever() {
    const double l = L / elements;
    Eigen::MatrixXd all_mass = Eigen::MatrixXd::Zero(size + 2, size + 2), all_stiffness = all_mass;
    Eigen::Matrix4d k, m;
    k << 12, 6 * l, -12, 6 * l, 6 * l, 4 * l * l, -6 * l, 2 * l * l, -12, -6 * l, 12, -6 * l, 6 * l,
        2 * l * l, -6 * l, 4 * l * l;
    m << 156, 22 * l, 54, -13 * l, 22 * l, 4 * l * l, 13 * l, -3 * l * l, 54, 13 * l, 156, -22 * l,
        -13 * l, -3 * l * l, -22 * l, 4 * l * l;
    for (int i = 0; i < elements; ++i) {
      all_stiffness.block<4, 4>(2 * i, 2 * i) += E * I / (l * l * l) * k;
      all_mass.block<4, 4>(2 * i, 2 * i) += rho * A * l / 420.0 * m;
    }
    mass_ = all_mass.bottomRightCorner(size, size);
    stiffness_ = all_stiffness.bottomRightCorner(size, size);
    root_ = all_stiffness.row(1).tail(size).transpose();
    Eigen::VectorXd lift(size + 2), turn(size + 2);
    for (int i = 0; i <= elements; ++i) {
      lift.segment<2>(2 * i) << 1.0, 0.0;
      turn.segment<2>(2 * i) << l * i, 1.0;
    }
    of_lift_ = (all_mass * lift).tail(size);
    of_turn_ = (all_mass * turn).tail(size);
    tip_ = Vector::Unit(size - 2);
  }

  /// What loads it at a time: acceleration of the root up, angular acceleration, force at the tip.
  struct Loading {
    double up = 0.0, turn = 0.0, tip = 0.0;
  };

  /// The moment at the root by the elements alone, at the ends of steps, from rest.
  std::vector<double> moments(const std::function<Loading(double)>& loading, double end,
                              int steps) const {
    const double h = end / steps;
    const auto load_at = [&](double t) -> Vector {
      const Loading at = loading(t);
      return -at.up * of_lift_ - at.turn * of_turn_ + at.tip * tip_;
    };
    const Eigen::PartialPivLU<Eigen::MatrixXd> step(mass_ + 0.25 * h * h * stiffness_);
    Vector u = Vector::Zero(), v = u;
    Vector a = mass_.partialPivLu().solve(load_at(0.0));
    std::vector<double> moments{0.0};
    for (int i = 1; i <= steps; ++i) {
      const Vector u_now = u + h * v + 0.25 * h * h * a;
      const Vector next = step.solve(load_at(h * i) - stiffness_ * u_now);
      v += 0.5 * h * (a + next);
      u = u_now + 0.25 * h * h * next;
      a = next;
      moments.push_back(root_.dot(u));
    }
    return moments;
  }

 private:
  Eigen::MatrixXd mass_, stiffness_;
  Vector root_, of_lift_, of_turn_, tip_;
};

}  // namespace

TEST_CASE("the parts of the modes add up to the rigid moment", "[elastic_start]") {
  double sum = 0.0;
  for (const RootMode& mode : root_modes(200)) sum += mode.part;
  CHECK(sum == Approx(1.0).epsilon(1e-4));
}

// Euler and Bernoulli; shear and rotary inertia change the first frequency by 1e-4, that of mode 3
// by 1e-3 at L/h = 120.
TEST_CASE("a beam whose base is moved once vibrates as its modes say", "[elastic_start]") {
  for (const double periods : {0.4, 1.1, 2.6}) {
    for (const double tau : {0.0, 0.004}) {
      const double end = periods * first_period;
      const StepDriver driver{0.0, 0.1, 0.0, end};
      const Beam of = carried(driver, 96);
      const ElasticMotion elastic(of.rigid(), of.elastic(E, G, tau), 5);
      const auto a = [&](double t) {
        return t < 0.0 || t > end ? 0.0 : driver_at(driver, t).acceleration;
      };
      const double rigid = 0.5 * rho * A * L * L;
      const double size = rigid * 0.1 * 5.77 / (end * end);  // 10/sqrt(3), the largest of the step
      REQUIRE(elastic.transient());
      CHECK(elastic.transient()->times().back() >= end + 1.49 * first_period);
      for (const double part : {0.05, 0.3, 0.5, 0.81, 1.0, 1.2}) {
        const double time = part * end;
        INFO("periods " << periods << ", tau " << tau << ", part " << part);
        const double sign = root_moment(of.rigid().loads(si<Time>(0.25 * end))) > 0.0 ? 1.0 : -1.0;
        CHECK(sign * root_moment(elastic.loads_at(si<Time>(time))) ==
              Approx(rigid * moment_by_modes(a, 0.0, time, tau)).margin(4e-3 * size));
      }
      // In balance at any time, behind the end too.
      for (const double part : {0.013, 0.42, 0.999, 1.3}) {
        const Imbalance left = imbalance_of(elastic.loads_at(si<Time>(part * end)));
        CHECK(left.force.norm() * L < 1e-8 * size);
        CHECK(left.moment.norm() < 1e-8 * size);
      }
    }
  }
}

// cos: the acceleration is there at once, no speed.
TEST_CASE("an acceleration that is there at once is a sudden load", "[elastic_start]") {
  const double omega = 2 * pi * 0.3 * first_frequency();
  const Beam of = carried(HarmonicDriver{0.0, 0.1, omega, 0.5 * pi}, 96, 1.7 * first_period);
  REQUIRE_FALSE(of.motion.closed);
  const ElasticMotion elastic(of.rigid(), of.elastic(), 6);
  // It does not come to rest, and nothing is looked at behind the end.
  CHECK(elastic.transient()->times().back() == Approx(1.7 * first_period));
  const auto a = [&](double t) { return -0.1 * omega * omega * std::cos(omega * t); };
  const double rigid = 0.5 * rho * A * L * L, size = rigid * 0.1 * omega * omega;
  const double sign = root_moment(of.rigid().loads(si<Time>(0.01))) * a(0.01) > 0.0 ? 1.0 : -1.0;
  double most = 0.0;
  for (double part = 0.05; part < 1.7; part += 0.15) {
    const double time = part * first_period;
    const double moment = sign * root_moment(elastic.loads_at(si<Time>(time)));
    most = std::max(most, std::abs(moment) / size);
    // Modes beyond the sixth bear 0.4 %, and shear and rotary inertia shift the phases of mode 4 to
    // 6, which bear 1.2 %.
    CHECK(moment == Approx(rigid * moment_by_modes(a, 0.0, time)).margin(0.016 * size));
  }
  CHECK(most > 1.4);
}

// The same by finite elements of another kind and a step of another method: a turn, started and
// stopped by a table, and a force at the tip that comes within a sixth of the first period. Turning
// by 0.02 rad has centrifugal terms of 1e-4.
TEST_CASE("a beam that is turned and loaded once does what finite elements do", "[elastic_start]") {
  const double end = 1.3 * first_period;
  std::vector<double> times, angles;
  for (int i = 0; i <= 6; ++i) {
    times.push_back(end * i / 6);
    const double u = i / 6.0;
    angles.push_back(0.02 * u * u * (3.0 - 2.0 * u));
  }
  const TableDriver table{TableCurve(times, angles, Interpolation::cubic, Beyond::hold)};
  const double on = 0.37 * end, force = 40.0;
  const double until = on + first_period / 6.0;
  const TableDriver push{TableCurve({0.0, on, until, end}, {0.0, 0.0, force, force},
                                    Interpolation::linear, Beyond::hold)};
  Beam of;
  planar::Pin pin;
  pin.a = of.start();
  of.mechanism.joints = {{"shaft", pin}};
  of.mechanism.joints.push_back(driven(of, planar::Coordinate::angle, table));
  planar::PointForce at_tip;
  at_tip.at = {0, {0.5 * L, 0.0}};
  at_tip.direction = pi / 2;
  at_tip.turns = true;
  at_tip.size = push;
  of.mechanism.forces.push_back({"push", at_tip});
  of.mechanism.duration.length = end;
  of.solve(96);
  const ElasticMotion elastic(of.rigid(), of.elastic(), 6);

  const int steps = 6000;
  const double watched = end + 1.4 * first_period;
  const SteppedCantilever by_elements;
  const std::vector<double> moments = by_elements.moments(
      [&](double t) -> SteppedCantilever::Loading {
        return {0.0, t <= end ? driver_at(table, t).acceleration : 0.0, driver_at(push, t).value};
      },
      watched, steps);
  double size = 0.0;
  for (const double moment : moments) size = std::max(size, std::abs(moment));
  // So fast a force bends the root nearly twice as much.
  CHECK(size > 1.5 * force * L);
  double worst = 0.0;
  for (int i = 40; i < steps; i += 53) {
    const Time time = si<Time>(watched * i / steps);
    const double moment = root_moment(elastic.loads_at(time));
    const double other = moments[static_cast<std::size_t>(i)];
    worst = std::max(worst, std::min(std::abs(moment - other), std::abs(moment + other)));
  }
  CHECK(worst < 0.01 * size);
}

// Damping takes away what the start excites, e^(-zeta omega t).
TEST_CASE("a start dies away to the vibration that repeats", "[elastic_start]") {
  const double r = 0.45, zeta = 0.08, tau = 2.0 * zeta / (2 * pi * first_frequency());
  const Beam once = shaken(r, 48);
  const ElasticMotion periodic(once.rigid(), once.elastic(E, G, tau), 3);
  const double period = once.motion.period;
  const Beam many =
      carried(HarmonicDriver{0.0, 0.01, 2 * pi * r * first_frequency(), 0.0}, 1024, 16.37 * period);
  REQUIRE_FALSE(many.motion.closed);
  const ElasticMotion started(many.rigid(), many.elastic(E, G, tau), 3);
  const double size = std::abs(root_moment(periodic.loads_at(si<Time>(0.25 * period))));
  // After 13 periods of the drive 29 of the beam: e^(-0.08 2 pi 29) = 5e-7.
  for (const double part : {0.1, 0.37, 0.5, 0.88}) {
    CHECK(root_moment(started.loads_at(si<Time>((14.0 + part) * period))) ==
          Approx(root_moment(periodic.loads_at(si<Time>(part * period)))).margin(1e-3 * size));
  }
  // At the beginning it is another one.
  CHECK(std::abs(root_moment(started.loads_at(si<Time>(0.37 * period))) -
                 root_moment(periodic.loads_at(si<Time>(0.37 * period)))) > 0.05 * size);
}

// Turning at constant speed under its weight it has turned before: what its weight does to it is a
// part r^2 of the static, r the speed over the first frequency. From rest the speed of the static
// deflection would be missing, which leaves a free vibration of r times it.
TEST_CASE("a motion that is under way begins without a free vibration", "[elastic_start]") {
  constexpr double r = 0.08;
  const double rate = 2 * pi * r * first_frequency();
  const auto turning = [&](double turns) {
    Beam of;
    planar::Pin pin;
    pin.a = of.start();
    of.mechanism.gravity = {0.0, -9.81};
    of.mechanism.joints = {{"shaft", pin}};
    of.mechanism.joints.push_back(driven(of, planar::Coordinate::angle, RateDriver{0.3, rate}));
    of.mechanism.duration.length = turns * 2 * pi / rate;
    of.solve(192);
    return of;
  };
  const Beam all = turning(1.0), part = turning(0.6);
  REQUIRE(all.motion.closed);
  REQUIRE_FALSE(part.motion.closed);
  const ElasticMotion periodic(all.rigid(), all.elastic(), 2);
  const ElasticMotion begun(part.rigid(), part.elastic(), 2);
  const double size = 0.5 * rho * A * 9.81 * L * L;
  double worst = 0.0;
  for (int i = 0; i <= 60; ++i) {
    const Time time = si<Time>(0.6 * 2 * pi / rate * i / 60.0);
    worst = std::max(
        worst, std::abs(root_moment(begun.loads_at(time)) - root_moment(periodic.loads_at(time))));
  }
  CHECK(worst < 2.0 * r * r * size);
  // What rigid bodies miss is of the same order, not of that of a sudden start.
  const VibrationEstimate estimate =
      estimate_vibration(part.rigid(), part.elastic(), part.history());
  CHECK(estimate.without_modes.front() < 3.0 * r * r);
}

// The slope of the acceleration that is there at once at the ends of a step, 60 d/T^3, leaves that
// over omega: 60/(5.77 omega T) of the largest acceleration, 2.8 % at T = 60 periods.
TEST_CASE("a slow motion leaves what rigid bodies bear", "[elastic_start]") {
  const double end = 60.0 * first_period;
  const Beam of = carried(StepDriver{0.0, 1.0, 0.0, end}, 96);
  const ElasticMotion elastic(of.rigid(), of.elastic(), 2);
  const double size = 0.5 * rho * A * L * L * 5.77 / (end * end);
  for (const double part : {0.1, 0.21, 0.77}) {
    const Time time = si<Time>(part * end);
    CHECK(root_moment(elastic.loads_at(time)) ==
          Approx(root_moment(of.rigid().loads(time))).margin(0.03 * size));
  }
}

// Rows of the estimate: what the modes' own responses miss, here by their closed form.
TEST_CASE("what rigid bodies are estimated to miss of a start is what they miss",
          "[elastic_start]") {
  for (const double periods : {0.5, 1.4, 8.0}) {
    const double end = periods * first_period;
    const StepDriver driver{0.0, 0.1, 0.0, end};
    const Beam of = carried(driver, 192);
    const VibrationEstimate estimate = estimate_vibration(of.rigid(), of.elastic(), of.history());
    CHECK(estimate.frequencies.front() == Approx(first_frequency()).epsilon(1e-3));
    CHECK(estimate.harmonics.empty());
    const auto a = [&](double t) {
      return t < 0.0 || t > end ? 0.0 : driver_at(driver, t).acceleration;
    };
    // At the root; by its peak and by its range, the larger counts.
    double low = 0.0, high = 0.0, rigid = 0.0;
    for (int i = 1; i <= 400; ++i) {
      const double t = (end + 1.5 * first_period) * i / 400;
      const double missed = moment_by_modes(a, 0.0, t, 0.0, 4) - a(t);
      low = std::min(low, missed);
      high = std::max(high, missed);
      rigid = std::max(rigid, std::abs(a(t)));
    }
    const double by_root = std::max({-low, high, 0.5 * (high - low)}) / rigid;
    INFO("periods " << periods);
    CHECK(estimate.without_modes.front() > 0.97 * by_root);
    CHECK(estimate.without_modes.front() < 1.6 * by_root);
    for (std::size_t k = 1; k < estimate.without_modes.size(); ++k)
      CHECK(estimate.without_modes[k] <= estimate.without_modes[k - 1]);
  }
}

TEST_CASE("the loads of a start are looked at with what dies out behind it", "[elastic_start]") {
  const double end = 0.9 * first_period;
  const Beam of = carried(StepDriver{0.0, 0.1, 0.0, end}, 96);
  const LoadSpan rigid = of.history().span();
  // Undamped: three periods of the lowest mode.
  const ElasticMotion undamped(of.rigid(), of.elastic(), 2);
  const LoadSpan span = undamped.span_of(rigid);
  CHECK(span.period.value() == Approx(end + 3.0 * first_period).epsilon(1e-3));
  REQUIRE(span.breaks.size() == rigid.breaks.size() + 1);
  CHECK(span.breaks.back().value() == Approx(end));
  // Eight instants to a period of mode 2, 6.267 times as fast.
  CHECK(static_cast<double>(span.instants) >= 8.0 * 6.26 * first_frequency() * span.period.value());
  // Damped: until a twentieth is left, ln(amplitude/0.05)/(zeta omega).
  const double zeta = 0.03, tau = 2.0 * zeta / (2 * pi * first_frequency());
  const ElasticMotion damped(of.rigid(), of.elastic(E, G, tau), 1);
  const double watched = damped.span_of(rigid).period.value() - end;
  CHECK(watched > std::log(10.0) / (zeta * 2 * pi * first_frequency()));
  CHECK(watched <= std::log(40.0) / (zeta * 2 * pi * first_frequency()) * 1.01);
}

}  // namespace elastic_start_test
