#include "boxbeam/fatigue/sn_curve.hpp"

#include <cmath>

#include "catch.hpp"

namespace sn_curve_test {

using namespace boxbeam;

namespace {

Stress MPa(double x) { return si<Stress>(x * 1e6); }
double in_MPa(Stress x) { return x.value() * 1e-6; }
SnCurve category(double x) { return en_1993_1_9_direct(x); }

double life(double curve, double range, Loading loading = Loading::spectrum) {
  return cycles_to_failure(category(curve), MPa(range), loading);
}

/// log10 C of a branch, C = d_sigma^slope N in MPa.
double log_C(double curve, double range, int slope) {
  return slope * std::log10(range) + std::log10(life(curve, range));
}

}  // namespace

TEST_CASE("EN 1993-1-9, 7.1: knee, cut-off and both branches of every category") {
  // d_sigma_C, then d_sigma_D, d_sigma_L and log10 C for m = 3 and 5, computed from the clauses'
  // equations apart from this program.
  const double table[][5] = {
      {160, 117.89, 64.75, 12.9134, 17.0563}, {140, 103.15, 56.66, 12.7394, 16.7664},
      {125, 92.10, 50.59, 12.5918, 16.5203},  {112, 82.52, 45.33, 12.4487, 16.2818},
      {100, 73.68, 40.47, 12.3010, 16.0357},  {90, 66.31, 36.42, 12.1638, 15.8069},
      {80, 58.94, 32.38, 12.0103, 15.5512},   {71, 52.31, 28.73, 11.8548, 15.2920},
      {63, 46.42, 25.50, 11.6991, 15.0324},   {56, 41.26, 22.66, 11.5456, 14.7767},
      {50, 36.84, 20.24, 11.3979, 14.5306},   {45, 33.16, 18.21, 11.2607, 14.3018},
      {40, 29.47, 16.19, 11.1072, 14.0460},   {36, 26.53, 14.57, 10.9699, 13.8172}};
  for (const auto& [C, D, L, log_3, log_5] : table) {
    CAPTURE(C);
    CHECK(in_MPa(knee_of(category(C))) == Approx(D).margin(0.0051));
    CHECK(in_MPa(cut_off_of(category(C))) == Approx(L).margin(0.0051));
    CHECK(log_C(C, 2 * C, 3) == Approx(log_3).margin(6e-5));
    CHECK(log_C(C, 0.6 * C, 5) == Approx(log_5).margin(6e-5));
  }
}

TEST_CASE("the categories equal the curves of DNV-RP-C203 at 2e6 cycles") {
  // Table 2-1, air, log a1 for m = 3: C, C1, C2, D, E, F, F1, F3, G, W1, W2, W3.
  const double table[][2] = {{125, 12.592}, {112, 12.449}, {100, 12.301}, {90, 12.164},
                             {80, 12.010},  {71, 11.855},  {63, 11.699},  {56, 11.546},
                             {50, 11.398},  {45, 11.261},  {40, 11.107},  {36, 10.970}};
  for (const auto& [C, log_a1] : table) {
    CAPTURE(C);
    CHECK(log_C(C, C, 3) == Approx(log_a1).margin(6e-4));
  }
}

TEST_CASE("a category is the range at two million cycles, by definition") {
  CHECK(life(90, 90) == Approx(2e6).epsilon(1e-12));
  CHECK(in_MPa(strength_at(category(90), 2e6, Loading::spectrum)) == Approx(90).epsilon(1e-12));
}

TEST_CASE("the branches meet at the knee and end at the cut-off") {
  for (const double C : {160.0, 100.0, 36.0}) {
    const double D = in_MPa(knee_of(category(C))), L = in_MPa(cut_off_of(category(C)));
    CHECK(life(C, D * (1 + 1e-12)) == Approx(5e6).epsilon(1e-9));
    CHECK(life(C, D * (1 - 1e-12)) == Approx(5e6).epsilon(1e-9));
    CHECK(life(C, L * (1 + 1e-12)) == Approx(1e8).epsilon(1e-9));
    CHECK(std::isinf(life(C, L * (1 - 1e-12))));
    // The ratios of the clause: d_sigma_L = 0.549 d_sigma_D = 0.405 d_sigma_C.
    CHECK(L / D == Approx(0.549).margin(5e-4));
    CHECK(L / C == Approx(0.4047).margin(5e-5));
  }
}

TEST_CASE("constant amplitude: no damage below the knee, 7.1(2)") {
  const double D = in_MPa(knee_of(category(100)));
  CHECK(std::isinf(life(100, 0.999 * D, Loading::constant_amplitude)));
  CHECK(life(100, 1.001 * D, Loading::constant_amplitude) == life(100, 1.001 * D));
  CHECK(in_MPa(strength_at(category(100), 1e8, Loading::constant_amplitude)) == Approx(D));
}

TEST_CASE("lives of the worked example (Miner, categories 56 and 90)") {
  CHECK(life(56, 90) == Approx(481800).margin(1));
  CHECK(life(56, 60) == Approx(1626074).margin(1));
  CHECK(life(56, 40) == Approx(5839516).margin(1));
  CHECK(life(90, 90) == Approx(2.0e6).margin(1));
  CHECK(life(90, 60) == Approx(8245044).margin(1));
  CHECK(life(90, 40) == Approx(62610799).margin(10));
  // Category 71 at 100, 60 and 40 MPa.
  CHECK(life(71, 100) == Approx(715822).margin(1));
  CHECK(life(71, 60) == Approx(3313991).margin(1));
  CHECK(life(71, 40) == Approx(19130593).margin(10));
}

TEST_CASE("strength and life are inverse to each other down to the cut-off") {
  for (double log_N = 4.0; log_N < 7.99; log_N += 0.13) {
    const double N = std::pow(10.0, log_N);
    const Stress range = strength_at(category(80), N, Loading::spectrum);
    CAPTURE(N);
    CHECK(cycles_to_failure(category(80), range, Loading::spectrum) == Approx(N).epsilon(1e-10));
  }
  // Behind 1e8 cycles the cut-off is the strength.
  CHECK(strength_at(category(80), 1e9, Loading::spectrum) == cut_off_of(category(80)));
}

TEST_CASE("a larger range never lives longer") {
  double last = std::numeric_limits<double>::infinity();
  for (double range = 1.0; range < 500.0; range *= 1.003) {
    const double N = life(63, range);
    CHECK(N <= last);
    last = N;
  }
}

TEST_CASE("the published step: 100 (5e6/1e8)^(1/5) = 54.9 MPa, as the sledge-rig thesis prints") {
  const SnCurve step = published_step(100);
  CHECK(in_MPa(strength_at(step, 1e8, Loading::spectrum)) == Approx(54.9).margin(0.05));
  CHECK(in_MPa(knee_of(step)) == Approx(100));
  // The standard gives 40.5 MPa there.
  CHECK(in_MPa(strength_at(category(100), 1e8, Loading::spectrum)) == Approx(40.5).margin(0.05));
}

}  // namespace sn_curve_test
