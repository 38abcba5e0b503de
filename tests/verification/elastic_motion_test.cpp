// Vibration of the beam in motions of planar mechanisms, against Euler and Bernoulli's beam and
// against what must hold in every motion.

#include "boxbeam/verification/elastic_motion.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/vibration_estimate.hpp"
#include "catch.hpp"
#include "support/rig.hpp"
#include "support/slender_beam.hpp"

namespace elastic_motion_test {

using namespace boxbeam;

namespace {

using namespace test::slender;

constexpr double pi = std::numbers::pi;

/// Root moment of a cantilever whose base shakes across its axis, over the one of the rigid beam:
///
///     w = a1 cos bx + a2 cosh bx + a3 (sin bx - sinh bx),  w(0) = 1, w''(L) = w'''(L) = 0
///
/// M(0) = EI w''(0); rigid: -rho A omega^2 L^2/2.
double magnification(double frequency) {
  const double omega = 2.0 * pi * frequency;
  const double b = std::pow(omega * omega * rho * A / (E * I), 0.25);
  const double c = std::cos(b * L), s = std::sin(b * L), C = std::cosh(b * L), S = std::sinh(b * L);
  Eigen::Matrix3d system;
  system << 1, 1, 0, -c, C, -s - S, s, S, -c - C;
  const Eigen::Vector3d a = system.lu().solve(Eigen::Vector3d(1, 0, 0));
  const double moment = E * I * b * b * (a[1] - a[0]);
  return -moment / (-rho * A * omega * omega * L * L / 2.0);
}

double root_moment(const BeamLoads& loads) {
  return cut_forces_of(loads).at({Length{}, Side::behind}).M_y.value();
}

/// About its start, under gravity.
Beam on_shaft(const Driver& turn, int instants) {
  Beam of;
  of.mechanism.gravity = {0.0, -9.81};
  planar::Pin pin;
  pin.a = of.start();
  of.mechanism.joints = {{"shaft", pin}, driven(of, planar::Coordinate::angle, turn)};
  of.solve(instants);
  return of;
}

/// It turns steadily: gravity is in its axes a load that turns.
Beam turning(double r, int instants) {
  return on_shaft(RateDriver{0.0, 2 * pi * r * first_frequency()}, instants);
}

/// It swings far.
Beam swinging(double r, int instants) {
  return on_shaft(HarmonicDriver{0.3, 0.7, 2 * pi * r * first_frequency(), 0.0}, instants);
}

}  // namespace

// Independent: with twice as many instants the postures at the middles are solved, not
// interpolated, and the vibration is resolved twice as finely.
TEST_CASE("between instants the loads are those of postures that are solved there",
          "[elastic_motion]") {
  for (const double r : {0.1, 0.22}) {
    const Beam coarse = swinging(r, 96), fine = swinging(r, 192);
    const ElasticMotion between(coarse.rigid(), coarse.elastic(), 2);
    const ElasticMotion solved(fine.rigid(), fine.elastic(), 2);
    const auto cuts_in = [](const ElasticMotion& of, Time time, double s) {
      return cut_forces_of(of.loads_at(time)).at({si<Length>(s), Side::behind});
    };
    for (const double s : {0.0, 0.4 * L}) {
      double largest = 0.0;
      for (int i = 0; i < 192; ++i) {
        const Time time = si<Time>(coarse.motion.begin + coarse.motion.period * i / 192.0);
        largest = std::max(largest, std::abs(cuts_in(solved, time, s).M_y.value()));
      }
      for (int i = 1; i < 192; i += 2) {
        const Time time = si<Time>(fine.motion.states[static_cast<std::size_t>(i)].time);
        const CutForces found = cuts_in(between, time, s), expected = cuts_in(solved, time, s);
        INFO("r = " << r << ", s = " << s << ", instant " << i);
        CHECK(found.M_y.value() == Approx(expected.M_y.value()).margin(1e-6 * largest));
        CHECK(found.V_z.value() == Approx(expected.V_z.value()).margin(1e-6 * largest / L));
        CHECK(found.N.value() == Approx(expected.N.value()).margin(1e-5 * largest / L));
      }
    }
  }
}

// Euler and Bernoulli; shear and rotary inertia change the frequency by 1e-4 at L/h = 120.
TEST_CASE("a beam on a shaking base vibrates as the closed solution says", "[elastic_motion]") {
  for (const double r : {0.1, 0.3, 0.5, 0.8, 1.7}) {
    const Beam of = shaken(r, 48);
    const ElasticMotion elastic(of.rigid(), of.elastic(), 3);
    for (const double part : {0.0, 0.07, 0.3, 0.81}) {
      const Time time = si<Time>(part * of.motion.period);
      const double rigid = root_moment(of.rigid().loads(time));
      const double largest =
          0.5 * rho * A * L * L * 0.01 * std::pow(2 * pi * r * first_frequency(), 2);
      INFO("r = " << r << ", part " << part);
      CHECK(root_moment(elastic.loads_at(time)) ==
            Approx(magnification(r * first_frequency()) * rigid).margin(2e-3 * largest));
    }
  }
}

namespace {

/// A cantilever that turns steadily about its root under gravity, by Ritz's method with powers of
/// x, second order included: centrifugal and gravity's tension N stiffens,
///
///     M q'' + (K + integral of N psi' psi' - omega^2 M) q = -rho A g cos(omega t) integral of psi
///
/// and periodic by integration over a period (Runge and Kutta) from the start that repeats.
/// Source: Timoshenko, Young, Weaver, Vibration Problems in Engineering (1974), chapter 5.
class TurningCantilever {
 public:
  explicit TurningCantilever(double omega) : omega_(omega) {
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const double p = i + 2, q = j + 2;
        mass_(i, j) = rho * A * L / (p + q + 1);
        bending_(i, j) = E * I / std::pow(L, 3) * p * (p - 1) * q * (q - 1) / (p + q - 3);
        // of (L^2 - x^2)/2 and of L - x
        spun_(i, j) = rho * A * omega * omega * L * p * q / 2 * (1 / (p + q - 1) - 1 / (p + q + 1));
        hung_(i, j) = rho * A * 9.81 * p * q * (1 / (p + q - 1) - 1 / (p + q));
      }
      load_[i] = -rho * A * 9.81 * L / (i + 3);
    }
    inverse_ = mass_.inverse();
    const Vector forced = after_period(Vector::Zero(), 1.0);
    Eigen::Matrix<double, 2 * n, 2 * n> free;
    for (int i = 0; i < 2 * n; ++i) free.col(i) = after_period(Vector::Unit(i), 0.0);
    const Eigen::Matrix<double, 2 * n, 2 * n> system =
        Eigen::Matrix<double, 2 * n, 2 * n>::Identity() - free;
    after_period(system.lu().solve(forced), 1.0, &path_);
  }

  /// Moment of the root at a part of the period: of weight, inertia, and weight along the bent
  /// axis.
  double root_moment_at(double part) const {
    const auto k = static_cast<std::size_t>(std::lround(part * steps));
    const double t = part * period();
    const Vector rate = rate_of(t, path_[k], 1.0);
    double moment = rho * A * L * L / 2 * 9.81 * std::cos(omega_ * t);
    for (int i = 0; i < n; ++i) {
      moment += rho * A * L * L / (i + 4) * rate[n + i];
      moment -= rho * A * L / (i + 3) * 9.81 * std::sin(omega_ * t) * path_[k][i];
    }
    return moment;
  }

 private:
  static constexpr int n = 5;
  static constexpr int steps = 20000;
  using Vector = Eigen::Matrix<double, 2 * n, 1>;
  using Square = Eigen::Matrix<double, n, n>;

  double period() const { return 2 * pi / omega_; }

  Vector rate_of(double t, const Vector& y, double load) const {
    const Square stiffness =
        bending_ + spun_ - std::sin(omega_ * t) * hung_ - omega_ * omega_ * mass_;
    Vector rate;
    rate.head<n>() = y.tail<n>();
    rate.tail<n>() = inverse_ * (load * std::cos(omega_ * t) * load_ - stiffness * y.head<n>());
    return rate;
  }

  Vector after_period(Vector y, double load, std::vector<Vector>* path = nullptr) const {
    const double dt = period() / steps;
    for (int i = 0; i < steps; ++i) {
      if (path != nullptr) path->push_back(y);
      const double t = i * dt;
      const Vector k1 = rate_of(t, y, load);
      const Vector k2 = rate_of(t + dt / 2, y + dt / 2 * k1, load);
      const Vector k3 = rate_of(t + dt / 2, y + dt / 2 * k2, load);
      const Vector k4 = rate_of(t + dt, y + dt * k3, load);
      y += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return y;
  }

  double omega_;
  Square mass_, bending_, spun_, hung_, inverse_;
  Eigen::Matrix<double, n, 1> load_;
  std::vector<Vector> path_;
};

}  // namespace

TEST_CASE("a beam that turns steadily vibrates under its weight and is stiffened by its turning",
          "[elastic_motion]") {
  const double r = 0.4;
  const Beam of = turning(r, 96);
  const ElasticMotion elastic(of.rigid(), of.elastic(), 3);
  const TurningCantilever by_ritz(2 * pi * r * first_frequency());
  const double largest = 0.5 * rho * A * L * L * 9.81;
  for (const double part : {0.0, 0.11, 0.25, 0.6, 0.93}) {
    const Time time = si<Time>(part * of.motion.period);
    CHECK(root_moment(elastic.loads_at(time)) ==
          Approx(by_ritz.root_moment_at(part)).margin(2e-3 * largest));
  }
}

TEST_CASE(
    "loads of a vibrating beam are in balance, and those of a rigid one in the limit of slow "
    "motion",
    "[elastic_motion]") {
  for (const double r : {0.01, 0.1}) {
    const Beam of = shaken(r, 48);
    const ElasticMotion elastic(of.rigid(), of.elastic(), 2);
    double most = 0.0;
    double dynamic = 0.0;
    for (int i = 0; i < 7; ++i) {
      const Time time = si<Time>((0.03 + i / 7.0) * of.motion.period);
      const BeamLoads loads = elastic.loads_at(time);
      const double rigid = root_moment(of.rigid().loads(time));
      most = std::max(most, std::abs(rigid));
      dynamic = std::max(dynamic, std::abs(root_moment(loads) - rigid));
      const Imbalance left = imbalance_of(loads);
      CHECK(left.force.norm() * L < 1e-8 * most);
      CHECK(left.moment.norm() < 1e-8 * most);
    }
    // magnification - 1 = c r^2 for small r, c = 1.09 by the closed solution
    CHECK(dynamic == Approx((magnification(r * first_frequency()) - 1.0) * most).epsilon(0.02));
  }
}

TEST_CASE("what rigid bodies are estimated to miss is what they miss", "[elastic_motion]") {
  for (const double r : {0.05, 0.2, 0.5}) {
    const Beam of = shaken(r, 48);
    const VibrationEstimate estimate = estimate_vibration(of.rigid(), of.elastic(), of.history());
    CHECK(estimate.frequencies.front() == Approx(first_frequency()).epsilon(1e-3));
    REQUIRE(estimate.harmonics.size() == 1);
    CHECK(estimate.harmonics[0].frequency == Approx(r * first_frequency()));
    CHECK(estimate.without_modes.front() ==
          Approx(std::abs(magnification(r * first_frequency()) - 1.0)).epsilon(0.01));
    CHECK(estimate.without_modes[1] < 0.05 * estimate.without_modes[0]);
  }
}

TEST_CASE("damping limits the vibration, without it resonance is refused", "[elastic_motion]") {
  const Beam probe = shaken(0.5, 48);
  const double exact =
      estimate_vibration(probe.rigid(), probe.elastic(), probe.history()).frequencies.front();
  const Beam of = shaken(exact / first_frequency(), 48);
  CHECK_THROWS_AS(ElasticMotion(of.rigid(), of.elastic(), 2), AnalysisError);
  // Kelvin-Voigt: zeta = omega tau/2, and eta is p/(2 zeta omega^2) in resonance.
  const double zeta = 0.01;
  const double tau = 2.0 * zeta / (2 * pi * exact);
  const ElasticMotion damped(of.rigid(), of.elastic(E, G, tau), 1);
  const ElasticMotion more(of.rigid(), of.elastic(E, G, 2.0 * tau), 1);
  CHECK(damped.coordinates().maxCoeff() ==
        Approx(2.0 * more.coordinates().maxCoeff()).epsilon(1e-3));
}

TEST_CASE("a motion that repeats with a cable that comes and goes is refused with what to do",
          "[elastic_motion]") {
  Beam of;
  planar::Pin pin;
  pin.a = of.start();
  planar::Spring cable;
  cable.a = {0, {0.5 * L, 0.0}};
  cable.b = {planar::ground, {2.0 * L, 0.0}};
  cable.stiffness = 100.0;
  cable.free_length = 2.0 * L;
  cable.acts = Acts::pulling;
  of.mechanism.joints = {{"shaft", pin},
                         driven(of, planar::Coordinate::angle, RateDriver{0.0, 0.5})};
  of.mechanism.forces = {{"cable", cable}};
  of.solve(96);
  REQUIRE(of.motion.closed);
  CHECK_THROWS_WITH(ElasticMotion(of.rigid(), of.elastic(), 1), Catch::Contains("--model rigid"));
}

namespace {

/// The slender rig's one mode over a period: squares of its angular frequency and generalised
/// force, to be integrated by another method.
struct OneMode {
  std::vector<double> square, p;
  double period = 0.0;

  static double between(const std::vector<double>& values, double part) {
    // Cubic through four neighbours (Lagrange).
    const auto n = static_cast<double>(values.size());
    const double x = (part - std::floor(part)) * n;
    const auto i = static_cast<std::size_t>(x);
    const double u = x - std::floor(x);
    const auto v = [&](std::size_t k) {
      return values[(i + k + values.size() - 1) % values.size()];
    };
    return -u * (u - 1) * (u - 2) / 6 * v(0) + (u + 1) * (u - 1) * (u - 2) / 2 * v(1) -
           (u + 1) * u * (u - 2) / 2 * v(2) + (u + 1) * u * (u - 1) / 6 * v(3);
  }

  /// eta and its rate after a period from given ones, and eta at the instants (Runge and Kutta).
  Eigen::Vector2d after_period(Eigen::Vector2d y, double load, std::vector<double>* path) const {
    const int per_instant = 40;
    const int steps = per_instant * static_cast<int>(p.size());
    const double dt = period / steps;
    const auto rate = [&](double t, const Eigen::Vector2d& at) {
      return Eigen::Vector2d(at[1],
                             load * between(p, t / period) - between(square, t / period) * at[0]);
    };
    for (int i = 0; i < steps; ++i) {
      if (path != nullptr && i % per_instant == 0) path->push_back(y[0]);
      const double t = i * dt;
      const Eigen::Vector2d k1 = rate(t, y);
      const Eigen::Vector2d k2 = rate(t + dt / 2, y + dt / 2 * k1);
      const Eigen::Vector2d k3 = rate(t + dt / 2, y + dt / 2 * k2);
      const Eigen::Vector2d k4 = rate(t + dt, y + dt * k3);
      y += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return y;
  }

  /// The periodic solution: y(0) = F + H y(0).
  std::vector<double> periodic() const {
    const Eigen::Vector2d forced = after_period(Eigen::Vector2d::Zero(), 1.0, nullptr);
    Eigen::Matrix2d free;
    free.col(0) = after_period({1.0, 0.0}, 0.0, nullptr);
    free.col(1) = after_period({0.0, 1.0}, 0.0, nullptr);
    const Eigen::Matrix2d system = Eigen::Matrix2d::Identity() - free;
    std::vector<double> path;
    after_period(system.lu().solve(forced), 1.0, &path);
    return path;
  }
};

}  // namespace

TEST_CASE("the vibration of a large motion is that of integration over time", "[elastic_motion]") {
  const Project project = read_project(test::project_file("sections/sledge-rig/slender.toml"));
  const planar::Mechanism& mechanism = planar_of(project);
  const planar::Motion motion = planar::solve_motion(mechanism);
  const planar::BeamBody body = planar::beam_body_of(project.beam, project.beam_body);
  auto finder = std::make_shared<planar::StateFinder>(mechanism, motion);
  const RigidMotion rigid{&mechanism, &motion, &project.beam, [&](Time time) {
                            return planar::beam_loads_of(mechanism, finder->at(time.value()), body);
                          }};
  const ElasticBody elastic = elastic_body_of(project, 8);
  const ElasticMotion vibration(rigid, elastic, 1);

  OneMode mode;
  mode.period = motion.period;
  Eigen::VectorXd first;
  for (const planar::State& state : motion.states) {
    const LoadedPosture posture =
        loaded_posture(mechanism, state, elastic, project.beam, rigid.loads(si<Time>(state.time)));
    const PostureModes modes = modes_in_posture(posture, 1);
    if (first.size() == 0) first = modes.shapes.col(0);
    const double sign = first.dot(modes.shapes.col(0)) > 0.0 ? 1.0 : -1.0;
    mode.square.push_back(std::pow(2 * pi * modes.frequencies.front(), 2) +
                          frame_terms(modes, state).of_size(0, 0));
    mode.p.push_back(sign * modal_loads(modes, posture)[0]);
  }
  const std::vector<double> integrated = mode.periodic();
  REQUIRE(integrated.size() == static_cast<std::size_t>(vibration.coordinates().rows()));
  const double size = vibration.coordinates().cwiseAbs().maxCoeff();
  for (std::size_t i = 0; i < integrated.size(); ++i) {
    CHECK(vibration.coordinates()(static_cast<Eigen::Index>(i), 0) ==
          Approx(integrated[i]).margin(1e-4 * size));
  }
}

}  // namespace elastic_motion_test
