#include <cmath>

#include "boxbeam/project/sn_catalogue.hpp"
#include "catch.hpp"

namespace dnv_rp_c203_test {

using namespace boxbeam;

namespace {

/// DNV-RP-C203, April 2016, table 2-1, in air, with the category of EN 1993-1-9 whose strength at
/// 2e6 cycles its curves share.
struct Line {
  const char* name;
  double m1, log_a1, log_a2, limit;  ///< limit at 1e7 cycles [MPa]
  int category;
};

constexpr Line lines[] = {
    {"B1", 4, 15.117, 17.146, 106.97, 160}, {"B2", 4, 14.885, 16.856, 93.59, 140},
    {"C", 3, 12.592, 16.320, 73.10, 125},   {"C1", 3, 12.449, 16.081, 65.50, 112},
    {"C2", 3, 12.301, 15.835, 58.48, 100},  {"D", 3, 12.164, 15.606, 52.63, 90},
    {"E", 3, 12.010, 15.350, 46.78, 80},    {"F", 3, 11.855, 15.091, 41.52, 71},
    {"F1", 3, 11.699, 14.832, 36.84, 63},   {"F3", 3, 11.546, 14.576, 32.75, 56},
    {"G", 3, 11.398, 14.330, 29.24, 50},    {"W1", 3, 11.261, 14.101, 26.32, 45},
    {"W2", 3, 11.107, 13.845, 23.39, 40},   {"W3", 3, 10.970, 13.617, 21.05, 36},
};

SnCurve curve_of(const Line& line) { return find_curve("DNV-RP-C203 air", line.name).value(); }

double MPa(Stress stress) { return stress.value() * 1e-6; }

}  // namespace

TEST_CASE("DNV-RP-C203 table 2-1: the limits at 1e7 cycles of all curves in air",
          "[sn_catalogue]") {
  for (const Line& line : lines) {
    CAPTURE(line.name);
    CHECK(MPa(knee_of(curve_of(line))) == Approx(line.limit).epsilon(5e-4));
  }
  CHECK(names_of("DNV-RP-C203 air").size() == std::size(lines));
}

TEST_CASE("DNV-RP-C203 table 2-1: cycles on both branches by the printed constants",
          "[sn_catalogue]") {
  for (const Line& line : lines) {
    CAPTURE(line.name);
    const SnCurve curve = curve_of(line);
    for (const double range : {500.0, 200.0, 120.0}) {
      CHECK(std::log10(cycles_to_failure(curve, si<Stress>(range * 1e6), Loading::spectrum)) ==
            Approx(line.log_a1 - line.m1 * std::log10(range)).margin(1e-9));
    }
    // The second constant is rounded on its own: 0.05 % of the range at most.
    for (const double range : {20.0, 5.0, 1.0}) {
      CHECK(std::log10(cycles_to_failure(curve, si<Stress>(range * 1e6), Loading::spectrum)) ==
            Approx(line.log_a2 - 5.0 * std::log10(range)).margin(5.0 * std::log10(1.0005)));
    }
  }
}

TEST_CASE("DNV-RP-C203 table 2-1: the printed branches meet at 1e7 cycles", "[sn_catalogue]") {
  for (const Line& line : lines) {
    CAPTURE(line.name);
    const double first = std::pow(10.0, (line.log_a1 - 7.0) / line.m1);
    const double second = std::pow(10.0, (line.log_a2 - 7.0) / 5.0);
    CHECK(first == Approx(second).epsilon(5e-4));
  }
}

TEST_CASE("the curves of DNV-RP-C203 and of EN 1993-1-9 are the same at 2e6 cycles",
          "[sn_catalogue]") {
  for (const Line& line : lines) {
    CAPTURE(line.name, line.category);
    const SnCurve other = find_curve("EN 1993-1-9", std::to_string(line.category)).value();
    CHECK(curve_of(line).reference / other.reference == Approx(1.0).epsilon(5e-4));
    CHECK(curve_of_same_strength("DNV-RP-C203 air", StressKind::direct, other.reference)->name ==
          line.name);
    CHECK(
        curve_of_same_strength("EN 1993-1-9", StressKind::direct, curve_of(line).reference)->name ==
        other.name);
  }
}

TEST_CASE("DNV-RP-C203 has no cut-off: a small range still damages, one below EN's does not",
          "[sn_catalogue]") {
  const Stress small = si<Stress>(30e6);
  const SnCurve C2 = find_curve("DNV-RP-C203 air", "C2").value();
  CHECK_FALSE(C2.cut_off);
  // N = 10^15.835 / 30^5 by hand.
  CHECK(cycles_to_failure(C2, small, Loading::spectrum) == Approx(2.8145e8).epsilon(3e-3));
  CHECK(std::isinf(
      cycles_to_failure(find_curve("EN 1993-1-9", "100").value(), small, Loading::spectrum)));
}

}  // namespace dnv_rp_c203_test
