// Vibration of a beam in space whose mechanism forces move, against ordinary finite elements, a
// double pendulum of rigid bodies and what must hold in every motion.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"
#include "support/space_arm.hpp"
#include "support/space_elements.hpp"

namespace elastic_by_forces_test {

using namespace boxbeam;
using namespace test::space_arm;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double g = 9.81;

/// The arm on a hub that falls along z, on a spring below it, with a load beside its tip.
struct Falling {
  double hub = 300.0, load = 30.0;  ///< [kg]
  double stiffness = 2e5;           ///< of what is below [N/m]
  double start = 0.0, rate = 0.0;   ///< above its free length [m, m/s]
  std::string acts = "both ways";
  double damping = 0.0, at_tip = 0.0;  ///< of the spring, and of a damper below the tip [N s/m]
  double under_tip = 1e-3;             ///< stiffness there [N/m]
  double duration = 1.0;               ///< [s]
  std::string driver = "";             ///< moves the hub instead of forces
  Vector3d centre{0.1, 0.3, -0.2};
  Vector3d inertia{2.0, 1.0, 1.5};

  std::string text() const {
    return fmt::format(
        R"(
[bodies.hub]
mass = "{:.15g} kg"
points = {{ o = ["0 m", "0 m", "0 m"] }}
[bodies.load]
mass = "{:.15g} kg"
centre = ["{:.15g} m", "{:.15g} m", "{:.15g} m"]
inertia = ["{:.15g} kg m^2", "{:.15g} kg m^2", "{:.15g} kg m^2"]
points = {{ c = ["0 m", "0 m", "0 m"] }}
[joints.fall]
kind = "prismatic"
connect = ["ground", "hub.o"]
at = ["0 m", "0 m", "0 m"]
axis = "z"
{}
[joints.root]
kind = "fixed"
connect = ["hub.o", "arm.heel"]
[joints.tip]
kind = "fixed"
connect = ["arm.tip", "load.c"]
[forces.below]
kind = "spring"
connect = ["ground", "hub.o"]
at = ["0 m", "0 m", "-1 m"]
stiffness = "{:.15g} N/m"
free_length = "1 m"
damping = "{:.15g} N s/m"
acts = "{}"
[forces.tip]
kind = "spring"
connect = ["ground", "arm.tip"]
at = ["4 m", "0 m", "-1 m"]
stiffness = "{:.15g} N/m"
free_length = "1 m"
damping = "{:.15g} N s/m"
{}
)",
        hub, load, centre.x(), centre.y(), centre.z(), inertia.x(), inertia.y(), inertia.z(),
        driver.empty() ? fmt::format("moved_by = \"forces\"\nstart = \"{:.15g} "
                                     "m\"\nstart_rate = \"{:.15g} m/s\"",
                                     start, rate)
                       : "",
        stiffness, damping, acts, under_tip, at_tip,
        driver.empty() ? fmt::format("[motion]\nduration = \"{:.15g} s\"", duration) : driver);
  }
  Moved moved() const {
    std::string all = arm(text(), "density = \"7850 kg/m^3\"\n");
    const std::string weightless = "\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"";
    all.replace(all.find(weightless), weightless.size(),
                "\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"");
    return Moved(all);
  }
};

/// The same by ordinary elements: nodes from the heel on, of which the heel only falls.
class FallingElements {
 public:
  FallingElements(const TaperedBeam& beam, const Falling& of)
      : of_(of),
        whole_(test::space_elements::assembled(beam, of.load, of.centre, of.inertia.asDiagonal())) {
    whole_.M(2, 2) += of.hub;
    h_ = beam.length().value() / 60.0;
    element_ = test::space_elements::element(section_at(beam, {si<Length>(0.5 * h_)}), h_,
                                             beam.density.value());
    for (Index i = 0; i < whole_.M.rows(); ++i)
      if (i == 2 || i > 5) free_.push_back(i);
    up_ = VectorXd::Zero(whole_.M.rows());
    for (Index i = 2; i < up_.size(); i += 6) up_[i] = 1.0;
    mass_ = up_.dot(whole_.M * up_);
  }

  double mass() const { return mass_; }
  const VectorXd& up() const { return up_; }

  /// Frequencies and modes of modal mass one, with the spring or without it.
  struct Modes {
    VectorXd squares;
    MatrixXd shapes;
  };
  Modes modes(bool on_spring) const {
    MatrixXd K = whole_.K(free_, free_);
    if (on_spring) K(0, 0) += of_.stiffness;
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(K, whole_.M(free_, free_));
    Modes modes{solver.eigenvalues(), MatrixXd::Zero(up_.size(), K.cols())};
    for (std::size_t i = 0; i < free_.size(); ++i)
      modes.shapes.row(free_[i]) = solver.eigenvectors().row(static_cast<Index>(i));
    return modes;
  }
  /// What follows the rigid motion statically on the spring: M up times an acceleration, and forces
  /// on heel and tip; moves no mass as a whole.
  VectorXd moved_by(double acceleration, double at_heel, double at_tip) const {
    MatrixXd K = whole_.K(free_, free_);
    K(0, 0) += of_.stiffness;
    K(K.rows() - 4, K.cols() - 4) += of_.under_tip;
    VectorXd force = -acceleration * (whole_.M * up_);
    force[2] += at_heel;
    force[force.size() - 4] += at_tip;
    VectorXd moved = VectorXd::Zero(up_.size());
    const VectorXd found = K.ldlt().solve(force(free_));
    for (std::size_t i = 0; i < free_.size(); ++i) moved[free_[i]] = found[static_cast<Index>(i)];
    return moved;
  }
  /// Forces on all nodes, mass times what it is moved by.
  VectorXd inertia(const VectorXd& acceleration) const { return whole_.M * acceleration; }

  /// The six cut forces at a node.
  Cuts cuts_at(Index node, const VectorXd& y, const VectorXd& acceleration) const {
    const VectorXd ends = y.segment<12>(6 * node);
    const VectorXd moved = (acceleration + g * up_).segment<12>(6 * node);
    return -(element_.K * ends + element_.M * moved).head<6>();
  }
  /// Of a heel that moves by e^(i w t), with spring and damper at the tip.
  Eigen::VectorXcd shaken(double w) const {
    Eigen::MatrixXcd dynamic = (whole_.K - w * w * whole_.M).cast<std::complex<double>>();
    dynamic(dynamic.rows() - 4, dynamic.cols() - 4) +=
        std::complex<double>(of_.under_tip, w * of_.at_tip);
    const std::vector<Index> held(free_.begin() + 1, free_.end());
    Eigen::VectorXcd y = Eigen::VectorXcd::Zero(up_.size());
    y[2] = 1.0;
    const Eigen::MatrixXcd left = dynamic(held, held);
    const Eigen::VectorXcd by_heel = dynamic.col(2)(held),
                           moved = left.partialPivLu().solve(by_heel);
    y(held) = -moved;
    return y;
  }
  /// Under its weight, the heel held.
  VectorXd sagged() const {
    const std::vector<Index> held(free_.begin() + 1, free_.end());
    VectorXd y = VectorXd::Zero(up_.size());
    MatrixXd left = whole_.K(held, held);
    left(left.rows() - 4, left.cols() - 4) += of_.under_tip;
    const VectorXd weight = -g * (whole_.M * up_), on_held = weight(held),
                   moved = left.ldlt().solve(on_held);
    y(held) = moved;
    return y;
  }
  double station(Index node) const { return static_cast<double>(node) * h_; }

 private:
  Falling of_;
  test::space_elements::Assembled whole_;
  test::space_elements::Element element_;
  double h_ = 0.0, mass_ = 0.0;
  std::vector<Index> free_;
  VectorXd up_;
};

}  // namespace

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
namespace {

/// A stiff arm that swings under its weight and a shaken tip with a hub at its heel, to which it is
/// held by a joint that gives way, or by a hinge with a torsion spring.
struct Pendulum {
  double hub = 200.0;        ///< about the hinge [kg m^2]
  double stiffness = 1.5e5;  ///< [N m/rad]
  double duration = 3.0;     ///< [s]

  Moved moved(double at_hub, double between, bool hinged) const {
    const std::string joint =
        hinged
            ? fmt::format(
                  "kind = \"revolute\"\naxis = \"y\"\nmoved_by = \"forces\"\nstart = "
                  "\"{:.17g} rad\"\n",
                  between)
            : fmt::format("kind = \"fixed\"\nturning_stiffness = \"{:.15g} N m/rad\"\n", stiffness);
    const std::string spring =
        hinged ? fmt::format(
                     "[forces.spring]\nkind = \"torsion spring\"\njoint = "
                     "\"root\"\nstiffness = \"{:.15g} N m/rad\"\nfree_angle = \"0 rad\"\n",
                     stiffness)
               : "";
    std::string all = arm(fmt::format(R"(
[bodies.hub]
mass = "10 kg"
inertia = ["{0:.15g} kg m^2", "{0:.15g} kg m^2", "{0:.15g} kg m^2"]
points = {{ o = ["0 m", "0 m", "0 m"] }}
[joints.hinge]
kind = "revolute"
connect = ["ground", "hub.o"]
at = ["0 m", "0 m", "0 m"]
axis = "y"
moved_by = "forces"
start = "{1:.17g} rad"
[joints.root]
connect = ["hub.o", "arm.heel"]
{2}{3}[forces.shaking]
kind = "force"
point = "arm.tip"
direction = "z"
axes = "arm"
law = {{ kind = "harmonic", mean = "0 N", amplitude = "300 N", frequency = "4 Hz", phase = "90 deg" }}
[motion]
duration = "{4:.15g} s"
)",
                                      hub, at_hub, joint, spring, duration),
                          "density = \"7850 kg/m^3\"\n",
                          "[model]\nyoungs_modulus = \"900000 GPa\"\nshear_modulus = "
                          "\"350000 GPa\"\n");
    const std::string weightless = "\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"";
    all.replace(all.find(weightless), weightless.size(),
                "\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"");
    return Moved(all);
  }
};

double heel_moment(const BeamLoads& loads) { return cuts_of(loads, 0.0)[4]; }

}  // namespace

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

// The same as two rigid bodies, of any turns: they begin where the joint that gives way bears the
// moment of the rigid motion, and hub and arm together have not turned. What is left out is of the
// order of the square of the turning over the circular frequency of hub and arm.
TEST_CASE("an arm that swings and gives way at its heel is a double pendulum",
          "[elastic_by_forces]") {
  for (const double stiffness : {1e5, 4e5}) {
    Pendulum pendulum;
    pendulum.stiffness = stiffness;
    constexpr double begin = -1.0;
    const Moved moved = pendulum.moved(begin, 0.0, false);
    const ElasticMotionInSpace elastic = moved.by(3, 8);
    const double arm = 7850.0 * properties_of(moved.project.beam.segments[0].from).area.value() *
                       std::pow(4.0, 3) / 3.0;
    const double given = heel_moment(moved.rigid().loads_at(si<Time>(0.0))) / stiffness;
    const double turned = -given * arm / (pendulum.hub + arm);
    const Moved both = pendulum.moved(begin + turned, given, true);
    double largest = 0.0, apart = 0.0, rigidly = 0.0, turning = 0.0;
    for (int i = 0; i <= 600; ++i) {
      const double t = pendulum.duration * i / 600.0;
      const spatial::State state = both.chain().at(t);
      const double expected = stiffness * state.coordinates[1].value;
      const double found = heel_moment(elastic.loads_at(si<Time>(t)));
      largest = std::max(largest, std::abs(expected));
      apart = std::max(apart, std::abs(found - expected));
      rigidly =
          std::max(rigidly, std::abs(heel_moment(moved.rigid().loads_at(si<Time>(t))) - expected));
      turning = std::max(turning, moved.chain().at(t).bodies[0].omega.norm());
    }
    const double square = stiffness * (1.0 / pendulum.hub + 1.0 / arm);
    const double left_out = turning * turning / square;
    INFO("stiffness " << stiffness << ", largest " << largest << ", apart " << apart
                      << ", of rigid bodies " << rigidly << ", left out " << left_out);
    CHECK(apart < (1e-3 + left_out) * largest);
    CHECK(rigidly > 0.1 * largest);
  }
}
namespace {

/// A mass m that runs along an arm whose heel is shaken, w = h + sum of phi_i q_i, phi of the arm
/// alone on a heel that stands:
///
///     q_i'' + w_i^2 q_i = -(h'' + g) b_i - F phi_i(s),
///     F = m (g + h'' + sum of phi_i q_i'' + 2 s' phi_i' q_i' + (s'' phi_i' + s'^2 phi_i'') q_i)
///
/// Source: Fryba, Vibration of Solids and Structures under Moving Loads (1999), chapter 8, the
/// whole acceleration of the mass.
class Trolley {
 public:
  Trolley(const TaperedBeam& beam, double mass, Driver heel, Driver along)
      : mass_(mass),
        heel_(std::move(heel)),
        along_(std::move(along)),
        whole_(test::space_elements::assembled(beam, 1e-6, Vector3d::Zero(),
                                               1e-6 * Eigen::Matrix3d::Identity())) {
    const Index size = whole_.K.rows();
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(
        whole_.K.bottomRightCorner(size - 6, size - 6),
        whole_.M.bottomRightCorner(size - 6, size - 6));
    // Those that shift in z.
    std::vector<VectorXd> shapes;
    std::vector<double> squares;
    for (Index i = 0; shapes.size() < 14; ++i) {
      VectorXd shape = VectorXd::Zero(size);
      shape.tail(size - 6) = solver.eigenvectors().col(i);
      double z = 0.0, beside = 0.0;
      for (Index node = 0; node < size / 6; ++node) {
        z += std::pow(shape[6 * node + 2], 2);
        beside += std::pow(shape[6 * node], 2) + std::pow(shape[6 * node + 1], 2) +
                  std::pow(shape[6 * node + 3], 2);
      }
      if (z < beside) continue;
      shapes.push_back(shape);
      squares.push_back(solver.eigenvalues()[i]);
    }
    shapes_.resize(size, static_cast<Index>(shapes.size()));
    for (std::size_t i = 0; i < shapes.size(); ++i) shapes_.col(static_cast<Index>(i)) = shapes[i];
    squares_ = VectorXd::Map(squares.data(), static_cast<Index>(squares.size()));
    up_ = VectorXd::Zero(size);
    for (Index i = 2; i < size; i += 6) up_[i] = 1.0;
    by_mass_ = shapes_.transpose() * (whole_.M * up_);
    h_ = beam.length().value() / 60.0;
  }

  struct At {
    VectorXd q, speed;
  };
  At resting() const {
    const VectorXd phi = shape_at(driver_at(along_, 0.0).value, 0);
    return {-g * (by_mass_ + mass_ * phi).cwiseQuotient(squares_), VectorXd::Zero(phi.size())};
  }
  VectorXd acceleration(double t, const At& at) const {
    const DriverState heel = driver_at(heel_, t), s = driver_at(along_, t);
    const VectorXd phi = shape_at(s.value, 0), slope = shape_at(s.value, 1),
                   curve = shape_at(s.value, 2);
    const double borne =
        mass_ * (g + heel.acceleration + 2.0 * s.rate * slope.dot(at.speed) +
                 s.acceleration * slope.dot(at.q) + s.rate * s.rate * curve.dot(at.q));
    const MatrixXd moved =
        MatrixXd::Identity(phi.size(), phi.size()) + mass_ * phi * phi.transpose();
    return moved.ldlt().solve(-squares_.cwiseProduct(at.q) - (heel.acceleration + g) * by_mass_ -
                              borne * phi);
  }
  void step(double t, double h, At& at) const {
    const auto go = [&](double by, const VectorXd& v, const VectorXd& a) {
      return At{at.q + by * v, at.speed + by * a};
    };
    const VectorXd a = acceleration(t, at);
    const At two = go(0.5 * h, at.speed, a);
    const VectorXd b = acceleration(t + 0.5 * h, two);
    const At three = go(0.5 * h, two.speed, b);
    const VectorXd c = acceleration(t + 0.5 * h, three);
    const At four = go(h, three.speed, c);
    const VectorXd d = acceleration(t + h, four);
    at.q += h / 6.0 * (at.speed + 2.0 * two.speed + 2.0 * three.speed + four.speed);
    at.speed += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  /// What bends the arm at its heel, by the sum of the modes' strains.
  double heel_moment(const At& at) const {
    const VectorXd y = shapes_ * at.q;
    const auto element = test::space_elements::element(section_, h_, density_);
    return -(element.K * y.head<12>())[4];
  }
  void of(const Section& section, double density) {
    section_ = section;
    density_ = density;
  }

 private:
  /// Of every mode the shift in z at a place, its slope or its curvature, by the cubic of a node's
  /// neighbours.
  VectorXd shape_at(double s, int derivative) const {
    const auto element = std::min<Index>(59, static_cast<Index>(s / h_));
    const double u = s / h_ - static_cast<double>(element);
    Eigen::Vector4d of;
    switch (derivative) {
      case 0:
        of << 1 - 3 * u * u + 2 * u * u * u, h_ * (u - 2 * u * u + u * u * u),
            3 * u * u - 2 * u * u * u, h_ * (u * u * u - u * u);
        break;
      case 1:
        of << (-6 * u + 6 * u * u) / h_, 1 - 4 * u + 3 * u * u, (6 * u - 6 * u * u) / h_,
            3 * u * u - 2 * u;
        break;
      default:
        of << (-6 + 12 * u) / (h_ * h_), (-4 + 6 * u) / h_, (6 - 12 * u) / (h_ * h_),
            (6 * u - 2) / h_;
    }
    // w' = -theta_y.
    return (of[0] * shapes_.row(6 * element + 2) - of[1] * shapes_.row(6 * element + 4) +
            of[2] * shapes_.row(6 * element + 8) - of[3] * shapes_.row(6 * element + 10))
        .transpose();
  }

  double mass_;
  Driver heel_, along_;
  test::space_elements::Assembled whole_;
  MatrixXd shapes_;
  VectorXd squares_, by_mass_, up_;
  double h_ = 0.0, density_ = 0.0;
  Section section_;
};

}  // namespace

// What moves with the mass is left out in the modes of each posture: (s'/(L w_1))^2.
TEST_CASE("a trolley runs along an arm that vibrates", "[elastic_by_forces]") {
  constexpr double mass = 60.0, duration = 1.2;
  const auto step = [](double from, double to, double end, const char* unit) {
    return fmt::format(
        "kind = \"smooth step\"\nfrom = \"{0:.15g} {3}\"\nto = \"{1:.15g} "
        "{3}\"\nend = \"{2:.15g} s\"\n",
        from, to, end, unit);
  };
  for (const double end : {2.4, 1.0}) {
    const std::string text =
        arm("[bodies.trolley]\nmass = \"60 kg\"\npoints = { c = [\"0 m\", \"0 m\", \"0 m\"] }\n"
            "[joints.fall]\nkind = \"prismatic\"\nconnect = [\"ground\", \"arm.heel\"]\nat = "
            "[\"0 m\", \"0 m\", \"0 m\"]\naxis = \"z\"\n[joints.run]\nkind = "
            "\"prismatic\"\nconnect = [\"arm.heel\", \"trolley.c\"]\naxis = \"x\"\n"
            "[drivers.fall]\njoint = \"fall\"\n" +
                step(0.0, 0.02, 0.15, "m") + "[drivers.run]\njoint = \"run\"\n" +
                step(1.0, 3.7, end, "m") +
                fmt::format("[motion]\nduration = \"{:.15g} s\"\n", duration),
            "density = \"7850 kg/m^3\"\n");
    std::string heavy = text;
    const std::string weightless = "\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"";
    heavy.replace(heavy.find(weightless), weightless.size(),
                  "\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"");
    const Moved moved(heavy);
    const ElasticMotionInSpace elastic = moved.by(4, 16);
    const std::vector<spatial::Joint>& joints = moved.chain().mechanism().joints;
    const auto driver_of = [&](const char* name) {
      return std::find_if(joints.begin(), joints.end(),
                          [&](const spatial::Joint& of) { return of.name == name; })
          ->driver;
    };
    Trolley trolley(moved.project.beam, mass, driver_of("fall"), driver_of("run"));
    trolley.of(moved.project.beam.segments[0].from, moved.project.beam.density.value());
    Trolley::At at = trolley.resting();
    double largest = 0.0, apart = 0.0, rigidly = 0.0, fastest = 0.0;
    constexpr int steps = 24000;
    for (int i = 0; i < steps; ++i) {
      const double t = duration * i / steps;
      if (i % 60 == 0) {
        const BeamLoads loads = elastic.loads_at(si<Time>(t));
        const double expected = trolley.heel_moment(at), found = cuts_of(loads, 0.0)[4];
        largest = std::max(largest, std::abs(expected));
        apart = std::max(apart, std::abs(found - expected));
        rigidly = std::max(
            rigidly, std::abs(cuts_of(moved.rigid().loads_at(si<Time>(t)), 0.0)[4] - expected));
        fastest = std::max(fastest, std::abs(driver_at(driver_of("run"), t).rate));
        CHECK(imbalance(loads, 4.0) < 1e-9);
      }
      trolley.step(t, duration / steps, at);
    }
    const double passing = fastest / (4.0 * 2.0 * std::numbers::pi * elastic.lowest_frequency());
    INFO("within " << end << " s: largest " << largest << ", apart " << apart
                   << ", of rigid bodies " << rigidly << ", passing " << passing);
    CHECK(apart < (5e-3 + passing * passing) * largest);
    CHECK(rigidly > 0.2 * largest);
  }
}

}  // namespace elastic_by_forces_test
