#include <cmath>

#include "boxbeam/project/sn_catalogue.hpp"
#include "catch.hpp"

namespace en_1993_1_9_curves_test {

using namespace boxbeam;

namespace {

SnCurve direct(const char* name) { return find_curve("EN 1993-1-9", name).value(); }

SnCurve shear(const char* name) {
  return find_curve("EN 1993-1-9", name, StressKind::shear).value();
}

double MPa(Stress stress) { return stress.value() * 1e-6; }

/// log C of the branch on which a curve is after so many cycles: C = N S^m.
double log_C(const SnCurve& curve, double cycles, double slope) {
  return std::log10(cycles) +
         slope * std::log10(MPa(strength_at(curve, cycles, Loading::spectrum)));
}

struct Line {
  const char* category;
  double limit, cut_off;  ///< MPa
  double log_C3, log_C5;
};

// From 7.1(2) and 7.1(3) by hand: d_sigma_D = (2/5)^(1/3) d_sigma_C, d_sigma_L = (5/100)^(1/5)
// d_sigma_D, C = 2e6 d_sigma_C^3 and 5e6 d_sigma_D^5.
constexpr Line lines[] = {
    {"160", 117.89, 64.75, 12.9134, 17.0563}, {"140", 103.15, 56.66, 12.7394, 16.7664},
    {"125", 92.10, 50.59, 12.5918, 16.5203},  {"112", 82.52, 45.33, 12.4487, 16.2818},
    {"100", 73.68, 40.47, 12.3010, 16.0357},  {"90", 66.31, 36.42, 12.1638, 15.8069},
    {"80", 58.94, 32.38, 12.0103, 15.5512},   {"71", 52.31, 28.73, 11.8548, 15.2920},
    {"63", 46.42, 25.50, 11.6991, 15.0324},   {"56", 41.26, 22.66, 11.5456, 14.7767},
    {"50", 36.84, 20.24, 11.3979, 14.5306},   {"45", 33.16, 18.21, 11.2607, 14.3018},
    {"40", 29.47, 16.19, 11.1072, 14.0460},   {"36", 26.53, 14.57, 10.9699, 13.8172},
};

}  // namespace

TEST_CASE("EN 1993-1-9 figure 7.1: limit, cut-off and constants of all fourteen categories",
          "[sn_catalogue]") {
  REQUIRE(std::size(lines) == 14);
  for (const Line& line : lines) {
    CAPTURE(line.category);
    const SnCurve curve = direct(line.category);
    CHECK(MPa(curve.reference) == std::stod(line.category));
    CHECK(MPa(knee_of(curve)) == Approx(line.limit).margin(0.0051));
    CHECK(MPa(cut_off_of(curve)) == Approx(line.cut_off).margin(0.0051));
    CHECK(log_C(curve, 1e5, 3.0) == Approx(line.log_C3).margin(5.1e-5));
    CHECK(log_C(curve, 2e7, 5.0) == Approx(line.log_C5).margin(5.1e-5));
  }
}

TEST_CASE("EN 1993-1-9 7.1(3): the cut-off is 0.4047 of the category, not 0.549 of it",
          "[sn_catalogue]") {
  const double of_category = std::cbrt(2.0 / 5.0) * std::pow(5.0 / 100.0, 0.2);
  CHECK(of_category == Approx(0.4047).margin(5e-5));
  for (const Line& line : lines) {
    const SnCurve curve = direct(line.category);
    CHECK(cut_off_of(curve) / curve.reference == Approx(of_category).epsilon(1e-12));
    CHECK(cut_off_of(curve) / knee_of(curve) == Approx(0.5493).margin(5e-5));
  }
}

TEST_CASE("EN 1993-1-9 figure 7.2: shear has one slope of 5 and a cut-off, no limit",
          "[sn_catalogue]") {
  CHECK(names_of("EN 1993-1-9", StressKind::shear) == std::vector<std::string>{"100", "80"});
  CHECK(MPa(cut_off_of(shear("100"))) == Approx(45.73).margin(0.0051));
  CHECK(MPa(cut_off_of(shear("80"))) == Approx(36.58).margin(0.0051));
  CHECK(log_C(shear("100"), 1e4, 5.0) == Approx(16.3010).margin(5.1e-5));
  CHECK(log_C(shear("80"), 9e7, 5.0) == Approx(15.8165).margin(5.1e-5));
  CHECK_FALSE(shear("80").constant_amplitude_limit);
}

TEST_CASE("EN 1993-1-9 7.1 note 3: a category with an asterisk raised by one, its limit at 1e7",
          "[sn_catalogue]") {
  const struct {
    const char *name, *strict, *raised;
    double limit, strict_limit;
  } cases[] = {{"36*", "36", "40", 23.39, 26.53},
               {"45*", "45", "50", 29.24, 33.16},
               {"50*", "50", "56", 32.75, 36.84}};
  for (const auto& each : cases) {
    CAPTURE(each.name);
    const SnCurve curve = direct(each.name);
    CHECK(curve.reference == direct(each.raised).reference);
    CHECK(MPa(knee_of(curve)) == Approx(each.limit).margin(0.0051));
    CHECK(MPa(knee_of(direct(each.strict))) == Approx(each.strict_limit).margin(0.0051));
    CHECK(curve.constant_amplitude_limit == 1e7);
    // Under ranges of many sizes the raised curve is above the strict one at every life.
    for (double cycles = 1e4; cycles <= 2e8; cycles *= 1.7) {
      CHECK(strength_at(curve, cycles, Loading::spectrum) >
            strength_at(direct(each.strict), cycles, Loading::spectrum));
    }
  }
}

TEST_CASE("the strongest curves are direct 160 and shear 100, as Altair HyperLife presets them",
          "[sn_catalogue]") {
  const SnCurve strongest = direct(names_of("EN 1993-1-9").front().c_str());
  CHECK(MPa(strongest.reference) == 160.0);
  REQUIRE(strongest.branches.size() == 2);
  CHECK(strongest.branches[0].slope == 3.0);
  CHECK(strongest.branches[0].until == 5e6);
  CHECK(strongest.branches[1].slope == 5.0);
  CHECK(strongest.branches[1].until == 1e8);
  CHECK(MPa(shear("100").reference) == 100.0);
}

}  // namespace en_1993_1_9_curves_test
