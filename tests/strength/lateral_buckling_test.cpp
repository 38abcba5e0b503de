// Lateral torsional buckling: closed forms, and an eigenvalue problem by finite differences.

#include "boxbeam/strength/lateral_buckling.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "catch.hpp"

namespace lateral_buckling_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;
using AlongBeam = std::function<double(double)>;

struct Case {
  double length;
  AlongBeam GI_T, EI, moment;
  bool fork_at_end = true;
  double tip_height = 0.0;  ///< of a force of one newton at the end, or in the middle between forks
  double EI_w = 0.0;
  /// E I_w behind the middle, where warping is free then.
  double EI_w_behind = -1.0;
};

double part_of(const Case& of, std::size_t elements = 64) {
  TurningBeam beam;
  for (std::size_t i = 0; i <= elements; ++i)
    beam.nodes.push_back(of.length * static_cast<double>(i) / static_cast<double>(elements));
  beam.held.assign(elements + 1, false);
  beam.held.front() = true;
  beam.held.back() = of.fork_at_end;
  std::vector<std::array<double, 2>> twisting;
  for (std::size_t e = 0; e < elements; ++e) {
    const auto at = gauss_places(beam, e);
    beam.turning_stiffness.push_back({of.GI_T(at[0]), of.GI_T(at[1])});
    const auto twist = [&](double s) { return std::pow(of.moment(s), 2) / of.EI(s); };
    twisting.push_back({twist(at[0]), twist(at[1])});
    if (of.EI_w > 0.0)
      beam.warping_stiffness.push_back(of.EI_w_behind < 0.0 || 2 * e < elements ? of.EI_w
                                                                                : of.EI_w_behind);
  }
  std::vector<double> tipping(elements + 1, 0.0);
  (of.fork_at_end ? tipping[elements / 2] : tipping.back()) = of.tip_height;
  return lateral_buckling_part(beam, twisting, tipping);
}

AlongBeam constant(double value) {
  return [value](double) { return value; };
}

constexpr double L = 7.0, GI = 3.0, EI = 8.0;
const double root = std::sqrt(GI * EI);

struct ByDifferences {
  double alpha;       ///< smallest
  double per_height;  ///< of a force of one newton: by how much it falls, by perturbation
};

/// (G I_T phi')' - (E I_w phi'')'' + alpha^2 M^2/(E I) phi = 0 by central differences, of the
/// energy of phi'' at all nodes but those where warping is free, and Eigen's dense solver.
ByDifferences by_differences(const Case& of, int n) {
  const double h = of.length / n;
  const int count = of.fork_at_end ? n - 1 : n;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(count, count), B = K;
  for (int i = 1; i <= count; ++i) {
    const double left = of.GI_T((i - 0.5) * h) / h,
                 right = i < n ? of.GI_T((i + 0.5) * h) / h : 0.0;
    K(i - 1, i - 1) = left + right;
    if (i > 1) K(i - 1, i - 2) = -left;
    if (i < count) K(i - 1, i) = -right;
    B(i - 1, i - 1) = std::pow(of.moment(i * h), 2) / of.EI(i * h) * (i < n ? h : 0.5 * h);
  }
  for (int i = 1; i < n; ++i) {
    const bool behind = of.EI_w_behind >= 0.0 && 2 * i > n;
    if (of.EI_w_behind >= 0.0 && 2 * i == n) continue;
    Eigen::VectorXd bend = Eigen::VectorXd::Zero(count);
    if (i > 1) bend[i - 2] = 1.0;
    bend[i - 1] = -2.0;
    if (i < count) bend[i] = 1.0;
    K += (behind ? of.EI_w_behind : of.EI_w) / (h * h * h) * bend * bend.transpose();
  }
  // B may vanish somewhere, K does not.
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> found(B, K);
  const Eigen::VectorXd phi = found.eigenvectors().col(count - 1);
  const double alpha = 1.0 / std::sqrt(found.eigenvalues()[count - 1]);
  const double at_force = of.fork_at_end ? phi[n / 2 - 1] : phi[n - 1];
  return {alpha, at_force * at_force / (2.0 * phi.dot(B * phi))};
}

/// From two grids by Richardson.
double by_differences(const Case& of) {
  const double coarse = by_differences(of, 120).alpha, fine = by_differences(of, 240).alpha;
  return fine + (fine - coarse) / 3.0;
}

}  // namespace

TEST_CASE("lateral torsional buckling of uniform beams: closed forms",
          "[lateral_buckling][Timoshenko and Gere]") {
  // Theory of Elastic Stability (1961), chapter 6: strips, without warping.
  struct Published {
    const char* name;
    Case of;
    double critical;  ///< times sqrt(E I G I_T)/L for a moment, /L^2 for a force
    double within;
  };
  const double by_moment = root / L, by_force = root / (L * L);
  for (const Published& published : {
           Published{"even moment between forks",
                     {L, constant(GI), constant(EI), constant(1.0)},
                     pi * by_moment,
                     2e-5},
           {"even moment, clamped at one end",
            {L, constant(GI), constant(EI), constant(1.0), false},
            0.5 * pi * by_moment,
            2e-5},
           {"force in the middle between forks",
            {L, constant(GI), constant(EI), [](double s) { return 0.5 * std::min(s, L - s); }},
            16.94 * by_force,
            3e-4},
           {"force at the end, clamped at the other",
            {L, constant(GI), constant(EI), [](double s) { return L - s; }, false},
            4.013 * by_force,
            3e-4},
           {"even load between forks",
            {L, constant(GI), constant(EI), [](double s) { return 0.5 * s * (1.0 - s / L); }},
            28.3 * by_force,
            1e-3},
           {"even load, clamped at one end",
            {L, constant(GI), constant(EI), [](double s) { return 0.5 * std::pow(L - s, 2) / L; },
             false},
            12.85 * by_force,
            1e-3},
       }) {
    INFO(published.name);
    CHECK(1.0 / part_of(published.of) == Approx(published.critical).epsilon(published.within));
  }
}

TEST_CASE("a force above the axis turns a beam over earlier", "[lateral_buckling]") {
  for (Case of :
       {Case{L, constant(GI), constant(EI), [](double s) { return 0.5 * std::min(s, L - s); }},
        Case{L, constant(GI), constant(EI), [](double s) { return L - s; }, false}}) {
    const double level = 1.0 / part_of(of);
    of.tip_height = 0.01;
    const double above = 1.0 / part_of(of);
    of.tip_height = -0.01;
    const double below = 1.0 / part_of(of);
    CHECK(above < level);
    CHECK(0.5 * (below - above) / 0.01 == Approx(by_differences(of, 240).per_height).epsilon(0.01));
  }
}

TEST_CASE("tapered beams buckle laterally as by finite differences", "[lateral_buckling]") {
  std::mt19937 random(71);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int i = 0; i < 20; ++i) {
    const double length = 2.0 + 20.0 * any(random), deeper = 3.0 * any(random);
    const double left = 2.0 * any(random) - 1.0, right = 2.0 * any(random) - 1.0, q = any(random);
    const Case of{length, [&](double s) { return GI * std::pow(1.0 + deeper * s / length, 2); },
                  [&](double s) { return EI * (1.0 + deeper * s / length); },
                  [&](double s) {
                    const double x = s / length;
                    return left * (1.0 - x) + right * x + 4.0 * q * x * (1.0 - x);
                  }};
    CHECK(1.0 / part_of(of, 256) == Approx(by_differences(of)).epsilon(1e-4));
  }
}

TEST_CASE("what warps resists: even moment between forks, closed form",
          "[lateral_buckling][Timoshenko and Gere]") {
  // M_cr = pi/L sqrt(E I (G I_T + pi^2 E I_w/L^2)), section 6.1.
  for (const double EI_w : {1e-9, 1e-3, 1.0, 20.0, 1e4}) {
    CAPTURE(EI_w);
    const Case of{L, constant(GI), constant(EI), constant(1.0), true, 0.0, EI_w};
    const double M_cr = pi / L * std::sqrt(EI * (GI + pi * pi * EI_w / (L * L)));
    CHECK(1.0 / part_of(of) == Approx(M_cr).epsilon(2e-5));
    // Free at one end it turns as a half of that of twice the length.
    const Case half{L, constant(GI), constant(EI), constant(1.0), false, 0.0, EI_w};
    const double M_half = 0.5 * pi / L * std::sqrt(EI * (GI + 0.25 * pi * pi * EI_w / (L * L)));
    CHECK(1.0 / part_of(half) <= M_half * (1.0 + 2e-5));
  }
}

TEST_CASE("beams that warp buckle laterally as by finite differences", "[lateral_buckling]") {
  std::mt19937 random(73);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  for (int i = 0; i < 30; ++i) {
    const double length = 2.0 + 20.0 * any(random), deeper = i % 3 == 0 ? 3.0 * any(random) : 0.0;
    const double left = 2.0 * any(random) - 1.0, right = 2.0 * any(random) - 1.0, q = any(random);
    Case of{length, [&](double s) { return GI * std::pow(1.0 + deeper * s / length, 2); },
            [&](double s) { return EI * (1.0 + deeper * s / length); },
            [&](double s) {
              const double x = s / length;
              return left * (1.0 - x) + right * x + 4.0 * q * x * (1.0 - x);
            }};
    of.EI_w = GI * length * length * std::pow(10.0, 3.0 * any(random) - 2.0);
    of.fork_at_end = i % 4 != 0;
    if (i % 5 == 4) of.EI_w_behind = of.EI_w * any(random);
    CAPTURE(i, of.EI_w, of.EI_w_behind);
    CHECK(1.0 / part_of(of, 96) == Approx(by_differences(of)).epsilon(1e-4));
    // Never more than with warping held where it is free, nor less than without what warps.
    Case none = of;
    none.EI_w = 0.0;
    CHECK(part_of(of) <= part_of(none) * (1.0 + 1e-3));
    Case through = of;
    if (of.EI_w_behind >= 0.0) {
      through.EI_w_behind = -1.0;
      CHECK(part_of(through) <= part_of(of) * (1.0 + 3e-5));
    }
  }
}

TEST_CASE("few elements with E I_w are enough", "[lateral_buckling][convergence]") {
  // A force in the middle, L^2 G I_T/(E I_w) = 16.
  const Case of{
      L,    constant(GI), constant(EI),     [](double s) { return 0.5 * std::min(s, L - s); },
      true, 0.0,          GI * L * L / 16.0};
  const double exact = 1.0 / part_of(of, 256);
  CHECK(1.0 / part_of(of, 16) == Approx(exact).epsilon(5e-5));
  CHECK(1.0 / part_of(of, 48) == Approx(exact).epsilon(3e-5));
}

// The box of webs 1200 x 8 at 600 mm, flanges 660 x 10 and 660 x 14 mm, 20 m between forks under an
// even moment: M_cr = pi/L sqrt(E I_z G I_T), I_z = 2303.09e6 mm^4, I_T = 4 A_m^2/sum(b/t); by
// W_eff = 8413e3 mm^3 lambda_LT = 0.205, a little above the 0.2 up to which nothing is taken off.
TEST_CASE("a slender box of even depth under an even moment", "[lateral_buckling][regression]") {
  const double A_m = 0.6 * 1.212, around = 0.6 / 0.010 + 0.6 / 0.014 + 2.0 * 1.212 / 0.008;
  Case of{20.0, constant(81e9 * 4.0 * A_m * A_m / around), constant(210e9 * 2303.09e-6),
          constant(1e6)};
  const double critical = 1e6 / part_of(of, 256);
  CHECK(critical == Approx(70978e3).epsilon(1e-4));
  CHECK(std::sqrt(8413e-6 * 355e6 / critical) == Approx(0.205).margin(5e-4));
}

// Box on mid-lines b = 600, h = 606 to 1212 mm, flanges 12, webs 8 mm, 20 m between forks under an
// even moment: 49384 kN m by the same equation elsewhere, ends alone 33931 and 69256 kN m.
TEST_CASE("a tapered box under an even moment", "[lateral_buckling][regression]") {
  const double b = 0.6, t_f = 0.012, t_w = 0.008;
  const auto box = [&](double from, double to) {
    const auto h = [=](double s) { return from + (to - from) * s / 20.0; };
    return Case{
        20.0,
        [=](double s) {
          return 81e9 * 4.0 * std::pow(b * h(s), 2) / (2.0 * b / t_f + 2.0 * h(s) / t_w);
        },
        [=](double s) { return 210e9 * (t_f * std::pow(b, 3) / 6.0 + 0.5 * h(s) * t_w * b * b); },
        constant(1.0)};
  };
  const auto critical = [&](Case of) {
    of.moment = constant(1e6);
    return 1e6 / part_of(of, 256);
  };
  CHECK(critical(box(0.606, 1.212)) == Approx(49384e3).epsilon(1e-4));
  CHECK(critical(box(0.606, 0.606)) == Approx(33931e3).epsilon(1e-4));
  CHECK(critical(box(1.212, 1.212)) == Approx(69256e3).epsilon(1e-4));
}

TEST_CASE("lateral buckling scales with stiffness, load and length", "[lateral_buckling]") {
  const AlongBeam M = [](double s) { return 1.0 + 0.3 * s; };
  const double part = part_of({L, constant(GI), constant(EI), M});
  CHECK(part_of({L, constant(4.0 * GI), constant(EI), M}) == Approx(0.5 * part).epsilon(3e-5));
  CHECK(part_of({L, constant(GI), constant(4.0 * EI), M}) == Approx(0.5 * part).epsilon(3e-5));
  CHECK(part_of({L, constant(GI), constant(EI), [&](double s) { return -5.0 * M(s); }}) ==
        Approx(5.0 * part).epsilon(3e-5));
  CHECK(part_of({2.0 * L, constant(GI), constant(EI), [&](double s) { return M(0.5 * s); }}) ==
        Approx(2.0 * part).epsilon(3e-5));
}

TEST_CASE("a load beyond all reason has a number, too", "[lateral_buckling]") {
  const Case of{L, constant(GI), constant(EI), constant(1e12)};
  const double part = part_of(of);
  CHECK(part == Approx(1e12 * L / (std::numbers::pi * root)).epsilon(2e-5));
  CHECK(part_of({L, constant(GI), constant(EI), constant(1e40)}) == 1e30);
}

TEST_CASE("a beam that nothing holds turns over, one that nothing bends does not",
          "[lateral_buckling]") {
  const TurningBeam beam{{0.0, 1.0, 2.0}, {false, false, false}, {{1.0, 1.0}, {1.0, 1.0}}};
  const std::vector<std::array<double, 2>> none(2, {0.0, 0.0});
  const std::vector<double> flat(3, 0.0);
  CHECK(std::isinf(lateral_buckling_part(beam, none, flat)));
  TurningBeam held = beam;
  held.held[1] = true;
  CHECK(lateral_buckling_part(held, none, flat) == 0.0);
}

}  // namespace lateral_buckling_test
