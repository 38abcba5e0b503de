// Torsional and torsional-flexural buckling: closed forms, and sums of sines and of clamped shapes
// as an independent Ritz solution of the energy.

#include "boxbeam/strength/twisting_buckling.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "support/uniform.hpp"

namespace twisting_buckling_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;

/// A bar of length 1 under N = 1: its stiffnesses, and its shear centre from the centroid.
struct Bar {
  double EI_y, EI_z, EI_yz, GI_T, EI_w, y_0, z_0, polar;  ///< (I_y + I_z)/A
  double radius_squared() const { return polar + y_0 * y_0 + z_0 * z_0; }
};

/// 1/N_cr by the energy of Timoshenko and Gere with the finite elements of Hermite's cubics: v, w
/// (clamped at both ends where asked), phi (forks, free to warp) of the shear centre.
double by_energy(const Bar& bar, bool clamped_v, int elements = 40) {
  const int nodes = elements + 1, size = 6 * nodes;
  const double l = 1.0 / elements;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size), G = K;
  Eigen::Matrix4d bending, slope, work;
  bending << 12, 6 * l, -12, 6 * l, 6 * l, 4 * l * l, -6 * l, 2 * l * l, -12, -6 * l, 12, -6 * l,
      6 * l, 2 * l * l, -6 * l, 4 * l * l;
  bending /= l * l * l;
  slope << 36, 3 * l, -36, 3 * l, 3 * l, 4 * l * l, -3 * l, -l * l, -36, -3 * l, 36, -3 * l, 3 * l,
      -l * l, -3 * l, 4 * l * l;
  slope /= 30.0 * l;
  // By field: v, w, phi.
  Eigen::Matrix3d curved, sloped, loaded;
  curved << bar.EI_z, bar.EI_yz, 0, bar.EI_yz, bar.EI_y, 0, 0, 0, bar.EI_w;
  sloped << 0, 0, 0, 0, 0, 0, 0, 0, bar.GI_T;
  loaded << 1, 0, bar.z_0, 0, 1, -bar.y_0, bar.z_0, -bar.y_0, bar.radius_squared();
  for (int e = 0; e < elements; ++e) {
    for (int f = 0; f < 3; ++f) {
      for (int g = 0; g < 3; ++g) {
        for (int i = 0; i < 4; ++i) {
          for (int j = 0; j < 4; ++j) {
            const int a = 6 * (e + i / 2) + 2 * f + i % 2, b = 6 * (e + j / 2) + 2 * g + j % 2;
            K(a, b) += curved(f, g) * bending(i, j) + sloped(f, g) * slope(i, j);
            G(a, b) += loaded(f, g) * slope(i, j);
          }
        }
      }
    }
  }
  std::vector<int> free;
  for (int k = 0; k < size; ++k) {
    const int node = k / 6, field = (k % 6) / 2;
    const bool end = node == 0 || node == nodes - 1, turn = k % 2 == 1;
    if (end && (!turn || (clamped_v && field == 0))) continue;
    free.push_back(k);
  }
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd K_f(n, n), G_f(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      K_f(i, j) = K(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(j)]);
      G_f(i, j) = G(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(j)]);
    }
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(G_f, K_f,
                                                                         Eigen::EigenvaluesOnly);
  return solver.eigenvalues().maxCoeff();
}

TwistingLoad load_of(const Bar& bar, bool clamped_v) {
  const double radius = std::sqrt(bar.radius_squared());
  return {1.0 / (pi * pi * bar.EI_y),
          1.0 / ((clamped_v ? 4.0 : 1.0) * pi * pi * bar.EI_z),
          twisting_per_force(bar.GI_T, bar.EI_w, 1.0, bar.radius_squared()),
          bar.y_0 / radius,
          bar.z_0 / radius,
          bar.EI_yz / std::sqrt(bar.EI_y * bar.EI_z)};
}

}  // namespace

TEST_CASE("nothing couples a section that mirrors itself twice: the largest of three",
          "[twisting]") {
  CHECK(twisting_part({0.1, 0.3, 0.2}) == Approx(0.3));
  CHECK(twisting_part({0.1, 0.3, 0.5}) == Approx(0.5));
  CHECK(twisting_part({}) == 0.0);
}

TEST_CASE("one axis of symmetry: the quadratic of the textbooks", "[twisting]") {
  // N_cr,TF = N_y/(2 beta) (1 + r - sqrt((1 - r)^2 + 4 (y_0/i_0)^2 r)), r = N_T/N_y, beta = 1 -
  // (y_0/i_0)^2 (EN 1993-1-3:2006, 6.2.3, equation 6.35).
  for (const double y_0 : {0.2, 0.5, 0.8}) {
    for (const double r : {0.2, 1.0, 4.0}) {
      CAPTURE(y_0, r);
      const double N_y = 1.7, beta = 1.0 - y_0 * y_0;
      const double N =
          N_y / (2.0 * beta) * (1.0 + r - std::sqrt((1.0 - r) * (1.0 - r) + 4.0 * y_0 * y_0 * r));
      CHECK(twisting_part({1.0 / N_y, 0.0, 1.0 / (r * N_y), y_0, 0.0, 0.0}) ==
            Approx(1.0 / N).epsilon(1e-9));
      // The other axis takes no part, but buckles by itself where it is weaker.
      CHECK(twisting_part({1.0 / N_y, 9.0 / N, 1.0 / (r * N_y), y_0, 0.0, 0.0}) ==
            Approx(9.0 / N).epsilon(1e-9));
    }
  }
}

TEST_CASE("bars between forks against the energy of finite elements", "[twisting]") {
  test::Uniform in(5);
  for (int i = 0; i < 20; ++i) {
    Bar bar{in(1.0, 8.0),    in(1.0, 8.0),  0.0,           in(0.01, 0.5),
            in(0.001, 0.05), in(-0.3, 0.3), in(-0.3, 0.3), in(0.02, 0.1)};
    CAPTURE(i);
    CHECK(twisting_part(load_of(bar, false)) == Approx(by_energy(bar, false)).epsilon(1e-5));
    // Where they bow unlike, it is on the safe side, and never less than any of them alone.
    CHECK(twisting_part(load_of(bar, true)) >= by_energy(bar, true) * (1.0 - 1e-5));
    // Inclined principal axes: of either sign the worse one.
    bar.EI_yz = in(-0.7, 0.7) * std::sqrt(bar.EI_y * bar.EI_z);
    const double one = by_energy(bar, false);
    Bar other = bar;
    other.EI_yz = -bar.EI_yz;
    CHECK(twisting_part(load_of(bar, false)) ==
          Approx(std::max(one, by_energy(other, false))).epsilon(1e-5));
    CHECK(twisting_part(load_of(bar, true)) >= by_energy(bar, true) * (1.0 - 1e-5));
  }
}

// IPE 200, 3 m: A = 2848, I_y = 1.943e7, I_z = 1.424e6, I_T = 69800 mm^4, I_w = 1.299e10 mm^6, G =
// 81 GPa: N_cr,T = 1180.673 kN, N_cr,z = 327.934 kN. Source: benchmark 17 of the repository
// alezen9/themis (EN 1993-1-1, 6.3.1.4).
TEST_CASE("an IPE 200 by twisting alone, published", "[twisting]") {
  const double radius_squared = (1.943e7 + 1.424e6) / 2848.0 * 1e-6;
  const double N_T =
      1.0 / twisting_per_force(81e9 * 69800e-12, 210e9 * 1.299e-8, 3.0, radius_squared);
  CHECK(N_T == Approx(1180672.73).epsilon(1e-7));
  TwistingLoad load;
  load.about_z = 1.0 / 327934.0556;
  load.about_y = load.about_z * 1.424e6 / 1.943e7;
  load.twisting = 1.0 / N_T;
  CHECK(1.0 / twisting_part(load) == Approx(327934.0556).epsilon(1e-9));
}

}  // namespace twisting_buckling_test
