#include <cmath>

#include "boxbeam/project/sn_catalogue.hpp"
#include "catch.hpp"

namespace bs_7608_test {

using namespace boxbeam;

namespace {

/// BS 7608 classes B, C and D in air as IACS Common Structural Rules, part 1, chapter 9, section 3,
/// table 2, print them: mean, deviation, design line and its strengths.
struct Line {
  const char* name;
  double K1, m, SD, K2;
  double at_1e7, at_2e6;  ///< MPa
};

constexpr Line lines[] = {{"B", 2.343e15, 4.0, 0.1821, 1.013e15, 100.2, 149.9},
                          {"C", 1.082e14, 3.5, 0.2041, 4.227e13, 78.2, 123.9},
                          {"D", 3.988e12, 3.0, 0.2095, 1.519e12, 53.4, 91.3}};

SnCurve curve_of(const char* name) { return find_curve("BS 7608", name).value(); }

double strength(const SnCurve& curve, double cycles) {
  return strength_at(curve, cycles, Loading::spectrum).value() * 1e-6;
}

}  // namespace

TEST_CASE("BS 7608: strengths at 2e6 and 1e7 cycles as printed", "[sn_catalogue]") {
  // The printed strengths and the printed constants agree to 0.13 %.
  for (const Line& line : lines) {
    CAPTURE(line.name);
    CHECK(strength(curve_of(line.name), 2e6) == Approx(line.at_2e6).epsilon(1.5e-3));
    CHECK(strength(curve_of(line.name), 1e7) == Approx(line.at_1e7).epsilon(1.5e-3));
    CHECK_FALSE(curve_of(line.name).unconfirmed);
  }
}

TEST_CASE("BS 7608: the design line is the mean less two standard deviations of log N",
          "[sn_catalogue]") {
  for (const Line& line : lines) {
    CAPTURE(line.name);
    const double cycles = 1e5;
    const double range = std::pow(line.K1 * std::pow(10.0, -2.0 * line.SD) / cycles, 1 / line.m);
    CHECK(strength(curve_of(line.name), cycles) == Approx(range).epsilon(1e-3));
  }
}

TEST_CASE("BS 7608: from 1e7 cycles on the slope is larger by 2, IACS rules 5.2.1",
          "[sn_catalogue]") {
  for (const std::string& name : names_of("BS 7608")) {
    CAPTURE(name);
    const SnCurve curve = curve_of(name.c_str());
    REQUIRE(curve.branches.size() == 2);
    const double m = curve.branches[0].slope;
    CHECK(strength(curve, 1e6) / strength(curve, 1e7) == Approx(std::pow(10.0, 1 / m)));
    CHECK(strength(curve, 1e7) / strength(curve, 1e8) == Approx(std::pow(10.0, 1 / (m + 2))));
  }
}

TEST_CASE("BS 7608: classes that were not read in a source say so", "[sn_catalogue]") {
  for (const char* name : {"E", "F", "F2", "G", "W1 (2014)"}) CHECK(curve_of(name).unconfirmed);
  CHECK(curve_of("W1 (2014)").code == "BS 7608:2014");
  CHECK(curve_of("F").code == "BS 7608:1993");
}

}  // namespace bs_7608_test
