// Vibration of an arm in space on a hub that forces move, against ordinary finite elements.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"
#include "support/falling_arm.hpp"

namespace elastic_by_forces_test {

using namespace boxbeam;
using namespace test::falling_arm;
using namespace test::space_arm;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// M y'' + K y = -M g of sixty elements, y = y_s + sum of modes, from the rigid motion z = -s + (z_0
// + s) cos(W t) + v_0/W sin(W t), W^2 = k/m, s = m g/k, and what follows it statically.
TEST_CASE("an arm that bounces on a spring vibrates as finite elements do", "[elastic_by_forces]") {
  Falling falling;
  falling.start = 0.03;
  falling.rate = -0.4;
  const Moved moved = falling.moved();
  const ElasticMotionInSpace elastic = moved.by(5, 16);
  const FallingElements elements(moved.project.beam, falling);
  const FallingElements::Modes modes = elements.modes(true);
  const double W = std::sqrt(falling.stiffness / elements.mass()),
               sag = elements.mass() * g / falling.stiffness;
  const auto rigid = [&](double t, int rate) {
    const double a = falling.start + sag, b = falling.rate / W, phase = W * t;
    switch (rate) {
      case 0: return -sag + a * std::cos(phase) + b * std::sin(phase);
      case 1: return W * (-a * std::sin(phase) + b * std::cos(phase));
      case 2: return -W * W * (a * std::cos(phase) + b * std::sin(phase));
      default: return -W * W * W * (-a * std::sin(phase) + b * std::cos(phase));
    }
  };
  // What the rigid motion leaves: -(M up (z'' + g) + k z at the heel).
  const VectorXd by_mass = modes.shapes.transpose() * elements.inertia(elements.up()),
                 at_heel = falling.stiffness * modes.shapes.row(2).transpose();
  const VectorXd
      balance =
          -(by_mass * (rigid(0.0, 2) + g) + at_heel * rigid(0.0, 0)).cwiseQuotient(modes.squares),
      rate = -(by_mass * rigid(0.0, 3) + at_heel * rigid(0.0, 1)).cwiseQuotient(modes.squares);
  const VectorXd omega = modes.squares.cwiseSqrt(),
                 sagged = -g * by_mass.cwiseQuotient(modes.squares);
  // Of y: by_mass is what `up` is of each mode.
  const VectorXd from = by_mass * rigid(0.0, 0) + balance - sagged,
                 speed = by_mass * rigid(0.0, 1) + rate;
  double largest = 0.0, apart = 0.0, rigidly = 0.0;
  constexpr Index node = 15;
  for (int i = 0; i <= 400; ++i) {
    const double t = falling.duration * i / 400.0;
    const VectorXd phase = omega * t;
    const VectorXd vibrating =
        from.cwiseProduct(phase.array().cos().matrix()) +
        speed.cwiseQuotient(omega).cwiseProduct(phase.array().sin().matrix());
    const VectorXd y = modes.shapes * (sagged + vibrating),
                   acceleration = -modes.shapes * modes.squares.cwiseProduct(vibrating);
    const Cuts expected = elements.cuts_at(node, y, acceleration),
               found = cuts_of(elastic.loads_at(si<Time>(t)), elements.station(node)),
               stiff = cuts_of(moved.rigid().loads_at(si<Time>(t)), elements.station(node));
    largest = std::max(largest, expected.tail<3>().norm());
    apart = std::max(apart, (found - expected).tail<3>().norm());
    rigidly = std::max(rigidly, (stiff - expected).tail<3>().norm());
    CHECK(imbalance(elastic.loads_at(si<Time>(t)), 4.0) < 1e-9);
  }
  INFO("largest " << largest << ", apart " << apart << ", of rigid bodies " << rigidly);
  CHECK(apart < 5e-3 * largest);
  CHECK(rigidly > 0.1 * largest);
}

namespace {

/// The elements on a stop that only pushes, or on a spring, by forty of their modes without it and
/// Runge and Kutta: q'' + w^2 q = -g by mass + heel f - tip c_t tip q', f = -k z - c z', z = heel
/// q, of a stop no less than zero.
struct Bounce {
  std::vector<VectorXd> q, acceleration;  ///< after every step
  double step = 0.0;

  Bounce(const FallingElements& elements, const FallingElements::Modes& free, const Falling& of,
         Index steps, Index every) {
    constexpr Index count = 40;
    const auto row = [&](Index at) -> VectorXd {
      return free.shapes.row(at).head(count).transpose();
    };
    const VectorXd squares = free.squares.head(count).cwiseMax(0.0), heel = row(2),
                   tip = row(free.shapes.rows() - 4),
                   by_mass =
                       (free.shapes.transpose() * elements.inertia(elements.up())).head(count);
    const double h = of.duration / static_cast<double>(steps);
    step = h * static_cast<double>(every);
    const auto acceleration_at = [&](const VectorXd& at, const VectorXd& speed) -> VectorXd {
      const double z = heel.dot(at);
      double pushed = -of.stiffness * z - of.damping * heel.dot(speed);
      if (of.acts == "pushing") pushed = z < 0.0 ? std::max(0.0, pushed) : 0.0;
      return -squares.cwiseProduct(at) - g * by_mass + pushed * heel -
             (of.under_tip * tip.dot(at) + of.at_tip * tip.dot(speed)) * tip;
    };
    VectorXd at = of.start * by_mass, speed = of.rate * by_mass;
    if (of.acts == "both ways") {
      // The rigid motion begins with z, z' and m z'' = -m g - k z - (c + c_t) z'.
      const double m = elements.mass(), k = of.stiffness + of.under_tip, c = of.damping + of.at_tip,
                   z = of.start, v = of.rate, a = -g - (k * z + c * v) / m,
                   j = -(k * v + c * a) / m;
      const MatrixXd weights = free.shapes.leftCols(count).transpose();
      at += weights * elements.inertia(elements.moved_by(a + g, -of.stiffness * z - of.damping * v,
                                                         -of.under_tip * z - of.at_tip * v));
      speed += weights * elements.inertia(elements.moved_by(j, -of.stiffness * v - of.damping * a,
                                                            -of.under_tip * v - of.at_tip * a));
    }
    for (Index i = 0; i <= steps; ++i) {
      const VectorXd a = acceleration_at(at, speed);
      if (i % every == 0) {
        q.push_back(at);
        acceleration.push_back(a);
      }
      const VectorXd b = acceleration_at(at + 0.5 * h * speed, speed + 0.5 * h * a),
                     c = acceleration_at(at + 0.5 * h * speed + 0.25 * h * h * a,
                                         speed + 0.5 * h * b),
                     d = acceleration_at(at + h * speed + 0.5 * h * h * b, speed + h * c);
      at += h * speed + h * h / 6.0 * (a + b + c);
      speed += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
  }
};

}  // namespace

// Elements know how far the stop is pressed by vibration itself, and when they touch it. Modes of
// the rigid motion leave out of that a second order: d^2/p^2 of the impulse, d by how much the heel
// of the elastic arm is elsewhere, p how far the rigid one presses the stop.
TEST_CASE("an arm that falls onto a stop and leaves it vibrates as finite elements do",
          "[elastic_by_forces]") {
  for (const double hub : {300.0, 3000.0}) {
    Falling falling;
    falling.hub = hub;
    falling.stiffness = 700.0 * hub;
    falling.start = 0.05;
    falling.acts = "pushing";
    falling.duration = 0.5;
    const Moved moved = falling.moved();
    REQUIRE(moved.chain().forced()->changes().size() >= 2);
    const ElasticMotionInSpace elastic = moved.by(5, 16);
    const FallingElements elements(moved.project.beam, falling);
    const FallingElements::Modes free = elements.modes(false);
    const Bounce bounce(elements, free, falling, 50000, 125);
    double largest = 0.0, apart = 0.0, rigidly = 0.0, pressed = 0.0, elsewhere = 0.0;
    constexpr Index node = 15;
    for (std::size_t i = 0; i < bounce.q.size(); ++i) {
      const double t = bounce.step * static_cast<double>(i);
      const VectorXd y = free.shapes.leftCols(40) * bounce.q[i],
                     acceleration = free.shapes.leftCols(40) * bounce.acceleration[i];
      const double z = moved.chain().at(t).coordinates.front().value;
      pressed = std::max(pressed, -z);
      elsewhere = std::max(elsewhere, std::abs(y[2] - z));
      const Cuts expected = elements.cuts_at(node, y, acceleration),
                 found = cuts_of(elastic.loads_at(si<Time>(t)), elements.station(node)),
                 stiff = cuts_of(moved.rigid().loads_at(si<Time>(t)), elements.station(node));
      largest = std::max(largest, expected.tail<3>().norm());
      apart = std::max(apart, (found - expected).tail<3>().norm());
      rigidly = std::max(rigidly, (stiff - expected).tail<3>().norm());
    }
    const double second_order = std::pow(elsewhere / pressed, 2);
    INFO("hub " << hub << ", largest " << largest << ", apart " << apart << ", of rigid bodies "
                << rigidly << ", second order " << second_order);
    CHECK(apart < (5e-3 + 3.0 * second_order) * largest);
    CHECK(rigidly > 0.2 * largest);
  }
}

TEST_CASE("vibration that lets go of a stop by itself is refused with its place and time",
          "[elastic_by_forces]") {
  Falling falling;
  falling.hub = 20.0;
  falling.load = 120.0;
  falling.start = 0.05;
  falling.stiffness = 5e6;
  falling.acts = "pushing";
  falling.duration = 0.4;
  const Moved moved = falling.moved();
  try {
    moved.by(3, 8);
    FAIL("not refused");
  } catch (const AnalysisError& error) {
    CHECK_THAT(error.failure().what,
               Catch::Contains("vibration itself") && Catch::Contains("below"));
    CHECK(error.failure().time.has_value());
  }
}

// Below the heel springs and dampers bear in series with the arm, at its tip beside it.
TEST_CASE("springs and dampers at heel and tip act where they are", "[elastic_by_forces]") {
  for (const auto& [below, tip, under_tip] : {std::tuple{4000.0, 0.0, 0.0},
                                              {0.0, 800.0, 0.0},
                                              {4000.0, 800.0, 0.0},
                                              {0.0, 0.0, 1e5},
                                              {4000.0, 800.0, 4e5}}) {
    Falling falling;
    falling.damping = below;
    falling.at_tip = tip;
    if (under_tip > 0.0) falling.under_tip = under_tip;
    falling.rate = -0.5;
    falling.duration = 0.8;
    const Moved moved = falling.moved();
    const FallingElements elements(moved.project.beam, falling);
    const FallingElements::Modes free = elements.modes(false);
    const Bounce bounce(elements, free, falling, 50000, 125);
    std::vector<double> parts;
    for (const std::size_t modes : {2, 5, 9}) {
      const ElasticMotionInSpace elastic = moved.by(modes, 16);
      double worst = 0.0;
      for (const Index node : {0, 15, 45}) {
        double largest = 0.0, apart = 0.0;
        for (std::size_t i = 0; i < bounce.q.size(); ++i) {
          const double t = bounce.step * static_cast<double>(i);
          const VectorXd y = free.shapes.leftCols(40) * bounce.q[i],
                         acceleration = free.shapes.leftCols(40) * bounce.acceleration[i];
          const BeamLoads loads = elastic.loads_at(si<Time>(t));
          const Cuts expected = elements.cuts_at(node, y, acceleration),
                     found = cuts_of(loads, elements.station(node));
          largest = std::max(largest, expected.tail<3>().norm());
          apart = std::max(apart, (found - expected).tail<3>().norm());
          // At first it falls freely, and hardly anything acts.
          if (i > 0) CHECK(imbalance(loads, 4.0) < 1e-9);
        }
        worst = std::max(worst, apart / largest);
      }
      parts.push_back(worst);
    }
    INFO("below " << below << ", tip " << tip << ", under it " << under_tip << ": " << parts[0]
                  << ", " << parts[1] << ", " << parts[2]);
    CHECK(parts[1] < 1e-2);
    CHECK(parts[2] < 5e-3);
  }
}

// (K + i w C - w^2 M) y = -(K + i w C - w^2 M) heel of the elements, whose heel a driver moves.
TEST_CASE("spring and damper at the tip of an arm whose heel is shaken act where they are",
          "[elastic_by_forces]") {
  constexpr double amplitude = 0.01, frequency = 5.0;
  for (const double under_tip : {1e-3, 2e4, 4e5}) {
    for (const double at_tip : {0.0, 1500.0}) {
      Falling falling;
      falling.under_tip = under_tip;
      falling.at_tip = at_tip;
      falling.driver = fmt::format(
          "[drivers.fall]\njoint = \"fall\"\nkind = \"harmonic\"\nmean = \"0 m\"\namplitude = "
          "\"{:.15g} m\"\nfrequency = \"{:.15g} Hz\"\n",
          amplitude, frequency);
      const Moved moved = falling.moved();
      REQUIRE(moved.rigid().closed());
      const ElasticMotionInSpace elastic = moved.by(5, 16);
      const FallingElements elements(moved.project.beam, falling);
      const double w = 2.0 * std::numbers::pi * frequency;
      const Eigen::VectorXcd y = elements.shaken(w);
      constexpr Index node = 15;
      double largest = 0.0, apart = 0.0, rigidly = 0.0;
      for (int i = 0; i < 64; ++i) {
        const double t = i / (64.0 * frequency);
        // A driver's sine.
        const std::complex<double> phase = std::polar(amplitude, w * t);
        const VectorXd at = (phase * y).imag(), acceleration = -w * w * at;
        const Cuts expected = elements.cuts_at(node, at, acceleration) +
                              elements.cuts_at(node, elements.sagged(), VectorXd::Zero(at.size())) -
                              elements.cuts_at(node, 0.0 * at, 0.0 * at),
                   found = cuts_of(elastic.loads_at(si<Time>(t)), elements.station(node)),
                   stiff = cuts_of(moved.rigid().loads_at(si<Time>(t)), elements.station(node));
        largest = std::max(largest, expected.tail<3>().norm());
        apart = std::max(apart, (found - expected).tail<3>().norm());
        rigidly = std::max(rigidly, (stiff - expected).tail<3>().norm());
      }
      INFO("under the tip " << under_tip << " N/m and " << at_tip << " N s/m: largest " << largest
                            << ", apart " << apart << ", of rigid bodies " << rigidly);
      CHECK(apart < 5e-3 * largest);
      CHECK(rigidly > 0.2 * largest);
    }
  }
}

}  // namespace elastic_by_forces_test
