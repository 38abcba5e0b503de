// The stiff flyball governor, IFToMM library of computational benchmark problems, A05: on a shaft
// of 1 x 0.01 x 0.01 m that turns freely at 2 pi rad/s a slider (a cube of 0.1 m), and at its top
// two rods like the shaft with 5 kg at their ends, 30 degrees below the horizontal; springs of 8e5
// N/m and 0.5 m with dampers of 4e4 N s/m from their middles to the slider, 0.5 m below the top;
// steel of 3000 kg/m^3.
//
// By symmetry three coordinates are enough: the shaft's turn psi, the angle of the rods from the
// shaft theta, the slider's distance s. Lagrange's equations, written by hand, are integrated by
// the classical method of fourth order in steps far below 1/(2 C/m), independently of the program.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/mechanism/spatial/forced_motion.hpp"
#include "catch.hpp"
#include "support/spatial_balance.hpp"

namespace flyball_governor_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using Eigen::Vector3d;

namespace {

constexpr double g = 9.81, density = 3000.0, thick = 0.01, rod_length = 1.0, cube = 0.1;
constexpr double ball = 5.0, K = 8e5, C = 4e4, l0 = 0.5, middle = 0.5;
constexpr double m = density * rod_length * thick * thick, m_slider = density * cube * cube * cube;
constexpr double across = m * (rod_length * rod_length + thick * thick) / 12.0;
constexpr double about = m * thick * thick / 6.0;
constexpr double pi = std::numbers::pi;
constexpr double theta_0 = pi / 3.0, s_0 = 0.5, omega_0 = 2.0 * pi;

Mechanism governor() {
  Mechanism mechanism;
  mechanism.gravity = {0.0, -g, 0.0};
  const auto forced = [&](const char* name, JointKind kind, int parent, const Vector3d& axis,
                          double start, double rate) {
    Joint joint = test::joint_of(name, kind, parent, Vector3d::Zero(), axis);
    joint.start = start;
    joint.start_rate = rate;
    const int body = test::add(mechanism, joint, false);
    mechanism.joints.back().moved_by = MovedBy::forces;
    return body;
  };
  const int shaft = forced("shaft", JointKind::revolute, ground, Vector3d::UnitY(), 0.0, omega_0);
  test::set_mass(mechanism.bodies.back(), m, {0.0, -0.5 * rod_length, 0.0},
                 {across, about, across});
  const int slider = forced("slider", JointKind::prismatic, shaft, -Vector3d::UnitY(), s_0, 0.0);
  constexpr double of_cube = m_slider * cube * cube / 6.0;
  test::set_mass(mechanism.bodies.back(), m_slider, Vector3d::Zero(), {of_cube, of_cube, of_cube});
  for (const double side : {1.0, -1.0}) {
    const int rod = forced("rod", JointKind::revolute, shaft, side * Vector3d::UnitZ(), theta_0, 0);
    // Rod and ball: their common centre, and inertia about it.
    const double whole = m + ball;
    const double centre = (0.5 * m + ball) * rod_length / whole;
    const double J = across + m * std::pow(centre - 0.5 * rod_length, 2) +
                     ball * std::pow(rod_length - centre, 2);
    test::set_mass(mechanism.bodies.back(), whole, {0.0, -centre, 0.0}, {J, about, J});
    mechanism.springs.push_back(
        {"spring", {rod, {0.0, -middle, 0.0}}, {slider, Vector3d::Zero()}, K, l0, C, {}});
  }
  return mechanism;
}

/// psi, theta, s and their rates.
using Six = std::array<double, 6>;

Six rates_of(const Six& y) {
  const auto [psi, theta, s, psi_1, theta_1, s_1] = y;
  constexpr double J = across + 0.25 * m * rod_length * rod_length + ball * rod_length * rod_length;
  const double sine = std::sin(theta), cosine = std::cos(theta);
  const double turning =
      about + m_slider * cube * cube / 6.0 + 2.0 * (J * sine * sine + about * cosine * cosine);
  const double by_theta = middle * s * sine, by_s = s - middle * cosine;  // of l^2/2
  const double l = std::sqrt(middle * middle + s * s - 2.0 * middle * s * cosine);
  const double force = K * (l - l0) + C * (by_theta * theta_1 + by_s * s_1) / l;
  const double couple = 2.0 * (J - about) * sine * cosine;
  return {psi_1,
          theta_1,
          s_1,
          -2.0 * couple * theta_1 * psi_1 / turning,
          (couple * psi_1 * psi_1 - (m + 2.0 * ball) * rod_length * g * sine -
           2.0 * force * by_theta / l) /
              (2.0 * J),
          g - 2.0 * force * by_s / l / m_slider};
}

Six after(double time, int steps, Six y) {
  const double h = time / steps;
  const auto moved = [](const Six& from, double by, const Six& rate) {
    Six to = from;
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += by * rate[i];
    return to;
  };
  for (int n = 0; n < steps; ++n) {
    const Six a = rates_of(y), b = rates_of(moved(y, 0.5 * h, a)),
              c = rates_of(moved(y, 0.5 * h, b)), d = rates_of(moved(y, h, c));
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
  }
  return y;
}

}  // namespace

TEST_CASE("the stiff flyball governor goes as Lagrange's equations say") {
  Mechanism mechanism = governor();
  mechanism.duration.length = 1.0;
  const Chain chain(mechanism);
  CHECK(chain.forced()->freedoms() == 4);
  Six y{0.0, theta_0, s_0, omega_0, 0.0, 0.0};
  double worst = 0.0;
  for (int i = 1; i <= 10; ++i) {
    y = after(0.1, 5000, y);
    const State state = chain.at(0.1 * i);
    const auto& q = state.coordinates;
    worst = std::max({worst, std::abs(q[0].value - y[0]), std::abs(q[1].value - y[2]),
                      std::abs(q[2].value - y[1])});
    CHECK(q[3].value == Approx(q[2].value).epsilon(1e-10));
  }
  CHECK(worst < 1e-9);
}

}  // namespace flyball_governor_test
