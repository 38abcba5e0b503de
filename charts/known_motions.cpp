#include "charts/known_motions.hpp"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include <cmath>
#include <cstddef>
#include <string>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::charts {
namespace {

using planar::Attachment, planar::Pin, planar::ground;

constexpr double g = 9.81;

/// Of the turning N-four-bar: theta/2 = pi/2 + am(rate t - K), modulus kappa.
struct Turning {
  long double rate, modulus, K;
};

Turning turning_of(int loops) {
  const auto N = static_cast<long double>(loops);
  const long double k =
      static_cast<long double>(g) * ((N + 1.0L) / 2.0L + N) / ((N + 1.0L) / 3.0L + N);
  const long double modulus = std::sqrt(4.0L * k / (1.0L + 4.0L * k));
  return {std::sqrt(1.0L + 4.0L * k) / 2.0L, modulus, boost::math::ellint_1(modulus)};
}

Eigen::Vector2d turned(double angle, const Eigen::Vector2d& p) {
  return {std::cos(angle) * p.x() - std::sin(angle) * p.y(),
          std::sin(angle) * p.x() + std::cos(angle) * p.y()};
}

/// Angles of the bodies K1 to K7 of Andrews' mechanism.
std::array<double, 7> absolute_of(const std::array<double, 7>& r) {
  return {r[0], r[0] + r[1], r[2], r[3] + r[4], r[4], r[5] + r[6], r[6]};
}

}  // namespace

planar::Mechanism simple_pendulum() {
  planar::Mechanism mechanism;
  mechanism.gravity = {0.0, -g};
  mechanism.bodies = {Body{"point", 1.0, 0.0, {}, {{-1.0, 0.0}, 0.0}}};
  mechanism.joints = {{"pin", Pin{{0, {1.0, 0.0}}, {ground, {0.0, 0.0}}}}};
  return mechanism;
}

Eigen::Vector2d simple_pendulum_at(double time) {
  const long double k = std::sqrt(0.5L);
  const long double u = std::sqrt(static_cast<long double>(g)) * static_cast<long double>(time);
  long double cn = 0.0L, dn = 0.0L;
  boost::math::jacobi_elliptic(k, u, &cn, &dn);
  // theta/2 never reaches a right angle: its cosine is positive.
  const long double half_sine = -k * cn / dn;
  const long double half_cosine = std::sqrt(1.0L - half_sine * half_sine);
  return {static_cast<double>(2.0L * half_sine * half_cosine),
          static_cast<double>(2.0L * half_sine * half_sine - 1.0L)};
}

double simple_pendulum_period() {
  return static_cast<double>(4.0L * boost::math::ellint_1(std::sqrt(0.5L)) /
                             std::sqrt(static_cast<long double>(g)));
}

planar::Mechanism n_four_bar(int loops) {
  planar::Mechanism mechanism;
  mechanism.gravity = {0.0, -g};
  const double quarter = std::acos(0.0);
  for (int i = 0; i <= loops; ++i) {
    mechanism.bodies.push_back(
        {"crank " + std::to_string(i), 1.0, 1.0 / 12.0, {}, {{i, 0.5}, quarter}, {0.5, 0.0, -1.0}});
    mechanism.joints.push_back(
        {"A" + std::to_string(i), Pin{{i, {-0.5, 0.0}}, {ground, {i, 0.0}}}});
  }
  for (int i = 0; i < loops; ++i) {
    const int coupler = loops + 1 + i;
    mechanism.bodies.push_back({"coupler " + std::to_string(i),
                                1.0,
                                1.0 / 12.0,
                                {},
                                {{i + 0.5, 1.0}, 0.0},
                                {1.0, 0.0, 0.0}});
    mechanism.joints.push_back(
        {"left " + std::to_string(i), Pin{{i, {0.5, 0.0}}, {coupler, {-0.5, 0.0}}}});
    mechanism.joints.push_back(
        {"right " + std::to_string(i), Pin{{i + 1, {0.5, 0.0}}, {coupler, {0.5, 0.0}}}});
  }
  return mechanism;
}

Eigen::Vector2d n_four_bar_tip_at(int loops, double time) {
  const Turning turning = turning_of(loops);
  long double cn = 0.0L, dn = 0.0L;
  const long double sn = boost::math::jacobi_elliptic(
      turning.modulus, turning.rate * static_cast<long double>(time) - turning.K, &cn, &dn);
  // theta = pi + 2 am: sine and cosine of the doubled angle, turned by pi.
  return {static_cast<double>(-2.0L * sn * cn), static_cast<double>(2.0L * sn * sn - 1.0L)};
}

double n_four_bar_period(int loops) {
  const Turning turning = turning_of(loops);
  return static_cast<double>(2.0L * turning.K / turning.rate);
}

std::array<double, 7> andrews_start() {
  return {-0.0617138900142764496358948458001, 0.0,
          0.455279819163070380255912382449,   0.222668390165885884674473185609,
          0.487364979543842550225598953530,   -0.222668390165885884674473185609,
          1.23054744454982119249735015568};
}

planar::Mechanism andrews() {
  const double m[] = {.04325, .00365, .02373, .00706, .07050, .00706, .05498};
  const double inertia[] = {2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5};
  const Eigen::Vector2d O(0.0, 0.0);
  const Eigen::Vector2d A(-.06934, -.00227);
  const Eigen::Vector2d B(-.03635, .03273);
  const Eigen::Vector2d C(.014, .072);
  const double d = .028, da = .0115, e = .02, ea = .01421, rr = .007, ra = .00092;
  const double ss = .035, sa = .01874, sb = .01043, sc = .018, sd = .02;
  const double ta = .02308, tb = .00916, u = .04, ua = .01228, ub = .00449;
  const double zf = .02, zt = .04, fa = .01421;

  // Points of the bodies from their centres of mass: the point nearest to the ground, and the other
  // end.
  const Attachment crank_O{0, {-ra, 0.0}}, crank_P{0, {rr - ra, 0.0}};
  const Attachment K2_P{1, {da, 0.0}}, K2_F{1, {da - d, 0.0}};
  const Attachment K3_B{2, {-sb, sa}}, K3_F{2, {-sb, sa - ss}}, K3_D{2, {sd - sb, sa - sc}};
  const Attachment K4_G{3, {0.0, e - ea}}, K4_F{3, {0.0, -ea}};
  const Attachment K5_A{4, {-ta, -tb}}, K5_G{4, {zt - ta, -tb}};
  const Attachment K6_H{5, {fa - zf, 0.0}}, K6_F{5, {fa, 0.0}};
  const Attachment K7_A{6, {ub, ua}}, K7_H{6, {ub, ua - u}};

  const std::array<double, 7> angle = absolute_of(andrews_start());
  const auto end = [&](std::size_t i, const Eigen::Vector2d& from, const Eigen::Vector2d& p) {
    return Eigen::Vector2d(from + turned(angle[i], p));
  };
  const Eigen::Vector2d P = end(0, O, {rr, 0.0});
  const Eigen::Vector2d G = end(4, A, {zt, 0.0});
  const Eigen::Vector2d H = end(6, A, {0.0, -u});
  const std::array<Eigen::Vector2d, 7> centres = {end(0, O, {ra, 0.0}), end(1, P, {-da, 0.0}),
                                                  end(2, B, {sb, -sa}), end(3, G, {0.0, -(e - ea)}),
                                                  end(4, A, {ta, tb}),  end(5, H, {zf - fa, 0.0}),
                                                  end(6, A, {-ub, -ua})};

  planar::Mechanism mechanism;
  const char* names[] = {"K1", "K2", "K3", "K4", "K5", "K6", "K7"};
  for (std::size_t i = 0; i < 7; ++i) {
    mechanism.bodies.push_back({names[i], m[i], inertia[i], {}, {centres[i], angle[i]}});
  }
  mechanism.joints = {{"F3", Pin{K2_F, K3_F}},        {"F4", Pin{K2_F, K4_F}},
                      {"F6", Pin{K2_F, K6_F}},        {"O", Pin{crank_O, {ground, O}}},
                      {"P", Pin{crank_P, K2_P}},      {"B", Pin{K3_B, {ground, B}}},
                      {"A5", Pin{K5_A, {ground, A}}}, {"G", Pin{K5_G, K4_G}},
                      {"A7", Pin{K7_A, {ground, A}}}, {"H", Pin{K7_H, K6_H}}};
  mechanism.forces = {
      {"spring", planar::Spring{K3_D, {ground, C}, 4530.0, .07785, 0.0}},
      {"motor",
       planar::Couple{{0, {0.0, 0.0}}, {ground, O}, HarmonicDriver{.033, 0.0, 0.0, 0.0, {}}}}};
  return mechanism;
}

std::array<double, 7> andrews_angles_of(const Eigen::VectorXd& q) {
  const auto angle = [&](Eigen::Index body) { return q[3 * (body - 1) + 2]; };
  return {angle(1), angle(2) - angle(1), angle(3), angle(4) - angle(5),
          angle(5), angle(6) - angle(7), angle(7)};
}

std::array<double, 7> andrews_angles_at_end() {
  return {15.8107711951537,  -15.7563710584118, 0.040822240119646, -0.534730116342080,
          0.524409965879954, 0.534730116342080, 1.04808074104194};
}

std::array<double, 6> andrews_forces_at_end() {
  return {199.1753481045386, -29.7553099749717, 23.0665436116221,
          31.4527252757712,  22.6424947863944,  11.6173923526112};
}

double energy_of(const planar::Mechanism& mechanism, const Eigen::VectorXd& q,
                 const Eigen::VectorXd& v) {
  double energy = 0.0;
  Eigen::Index k = 0;
  for (const Body& body : mechanism.bodies) {
    energy +=
        0.5 * (body.mass * v.segment<2>(k).squaredNorm() + body.inertia * v[k + 2] * v[k + 2]);
    energy -= body.mass * mechanism.gravity.dot(q.segment<2>(k));
    k += 3;
  }
  for (const planar::AppliedForce& force : mechanism.forces) {
    const auto* spring = std::get_if<planar::Spring>(&force.kind);
    if (spring == nullptr) continue;
    const double stretch =
        (planar::position_of(spring->a, q) - planar::position_of(spring->b, q)).norm() -
        spring->free_length;
    energy += 0.5 * spring->stiffness * stretch * stretch;
  }
  return energy;
}

}  // namespace boxbeam::charts
