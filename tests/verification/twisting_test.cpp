// Torsional and torsional-flexural buckling of open paths, from the case to the check, by hand.

#include "boxbeam/verification/twisting.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/report/remarks.hpp"
#include "catch.hpp"
#include "support/buckling_curve.hpp"
#include "support/path_cases.hpp"

namespace twisting_test {

using namespace boxbeam;
using namespace slender_cases;
using namespace paths;
using path_cases::held;
using path_cases::section;

namespace {

constexpr double pi = std::numbers::pi;

/// A column of 3 m between a pin and a roller, held sideways and against turning as `holds` says.
std::string column(const ThinWalled& path, double kN, const std::string& holds,
                   const std::string& more = "") {
  return "[case]\nname = \"column\"\nkind = \"static\"\n[frame]\n"
         "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n" +
         section("a", path) + "[beam]\ndensity = \"7850 kg/m^3\"\n" + segment(3.0, "a") + holds +
         "[supports.left]\nkind = \"pinned\"\nat = \"0 m\"\n"
         "[supports.right]\nkind = \"roller\"\nat = \"3 m\"\n[loads.press]\nkind = "
         "\"force\"\nat = \"3 m\"\n" +
         fmt::format("force = [\"{} kN\", \"0 kN\"]\n", -kN) + more + steel +
         "[strength]\nrequired = 1.0\nshear_lag = false\n";
}

const CheckResult* twisting_of(const Verification& of) {
  for (const CheckResult& result : of.checks)
    if (result.check.id == "member-buckling/by-twisting") return &result;
  return nullptr;
}

/// Web 290 along y at z = 0, flanges of 200 down from its ends, all of one thickness, mid-lines.
ThinWalled trough(double t) {
  ThinWalled path;
  const std::size_t left = add_node(path, mm_place(145.0, 0.0));
  const std::size_t right = add_node(path, mm_place(-145.0, 0.0));
  add_wall(path, add_node(path, mm_place(145.0, -200.0)), left, t);
  add_wall(path, left, right, t);
  add_wall(path, right, add_node(path, mm_place(-145.0, -200.0)), t);
  return path;
}

}  // namespace

TEST_CASE("a trough between forks buckles sideways and by twisting at once", "[twisting]") {
  const double t = 0.018, h = 0.29, b = 0.2, L = 3.0, N = 600e3;
  const Project project = parse_project("column.toml", column(trough(18.0), 600.0, held(3.0, 1)));
  const Verification of = verify(project);
  const CheckResult* const found = twisting_of(of);
  REQUIRE(found != nullptr);
  // Mid-line formulas: the shear centre lies b^2 h^2 t/(4 I_z) above the web, the centroid b^2 t/A
  // below it.
  const double E = project.model.youngs_modulus, G = project.model.shear_modulus;
  const double A = t * (h + 2.0 * b), I_z = t * h * h * h / 12.0 + 2.0 * b * t * h * h / 4.0;
  const double low = b * b * t / A;
  const double I_y = 2.0 * t * b * b * b / 3.0 - A * low * low;
  const double z_0 = b * b * h * h * t / (4.0 * I_z) + low;
  const double i_0_2 = (I_y + I_z) / A + z_0 * z_0;
  const double I_w = t * b * b * b * h * h / 12.0 * (3.0 * b + 2.0 * h) / (6.0 * b + h);
  const double N_T = (G * A * t * t / 3.0 + pi * pi * E * I_w / (L * L)) / i_0_2;
  const double N_z = pi * pi * E * I_z / (L * L);
  const double beta = 1.0 - z_0 * z_0 / i_0_2, r = N_T / N_z;
  const double N_cr =
      N_z / (2.0 * beta) * (1.0 + r - std::sqrt((1.0 - r) * (1.0 - r) + 4.0 * (1.0 - beta) * r));
  REQUIRE(N_cr < 0.99 * std::min(N_z, N_T));
  REQUIRE(N_cr < 0.9 * pi * pi * E * I_y / (L * L));
  CHECK(found->member->load.critical == Approx(N / N_cr).epsilon(5e-3));
  // EN 1993-1-1, 6.3.1, curve c, with the moment by which N stands beside the centroid.
  const double n = N / (A * 355e6), lambda = std::sqrt(N / N_cr / n);
  const double chi = test::chi_of(lambda);
  // By 6.62 m of the straight beam counts (1 + 0.6 lambda n/chi) times (tables B.1, B.2), by which
  // it grows more here than as a bow.
  const MemberLoad& load = found->member->load;
  const double k_zz = 1.0 + 0.6 * std::min(1.0, lambda) * n / chi;
  CHECK(load.straight.m_y + k_zz * load.straight.m_z > load.bent);
  CHECK(found->check.utilisation() ==
        Approx(n / chi + load.straight.m_y + k_zz * load.straight.m_z).epsilon(5e-3));
  // Twice the force, twice the part of the critical one.
  const Verification twice =
      verify(parse_project("column.toml", column(trough(18.0), 1200.0, held(3.0, 1))));
  REQUIRE(twisting_of(twice) != nullptr);
  CHECK(twisting_of(twice)->member->load.critical ==
        Approx(2.0 * found->member->load.critical).epsilon(1e-3));
  // A fork in the middle: half the length, at least almost four times the critical force but for
  // G I_T; pulled it does not twist.
  const Verification halved =
      verify(parse_project("column.toml", column(trough(18.0), 600.0, held(3.0, 2))));
  const CheckResult* const half = twisting_of(halved);
  CHECK((half == nullptr || half->member->load.critical < 0.5 * found->member->load.critical));
  CHECK(twisting_of(verify(
            parse_project("column.toml", column(trough(18.0), -600.0, held(3.0, 1))))) == nullptr);
}

TEST_CASE("what mirrors itself twice twists only where that is the weakest way", "[twisting]") {
  // Flanges 200 x 12, web 400 x 10: between forks its N_cr,T is above N_cr across.
  const ThinWalled path = i_section(200.0, 12.0, 400.0, 10.0);
  CHECK(twisting_of(verify(parse_project("c.toml", column(path, 800.0, held(3.0, 1))))) == nullptr);
  // Held sideways every 0.3 m and against turning at its ends alone, N_cr,T by hand: I_w =
  // I_z h^2/4.
  std::string sideways = held(3.0, 1);
  for (int i = 1; i < 10; ++i) {
    sideways +=
        fmt::format("[[beam.restraints]]\nstation = \"{} m\"\nholds = [\"along y\"]\n", 0.3 * i);
  }
  const Project project = parse_project("c.toml", column(path, 800.0, sideways));
  const Verification of = verify(project);
  const CheckResult* const found = twisting_of(of);
  REQUIRE(found != nullptr);
  const double I_z = 2.0 * 0.012 * std::pow(0.2, 3) / 12.0 + 0.4 * 1e-6 / 12.0;
  const double I_y =
      2.0 * 0.0024 * (0.206 * 0.206 + 0.012 * 0.012 / 12.0) + 0.01 * std::pow(0.4, 3) / 12.0;
  const double A = 0.0048 + 0.004;
  const double I_T = (0.4 * std::pow(0.012, 3) + 0.4 * std::pow(0.01, 3)) / 3.0;
  const double N_T = (project.model.shear_modulus * I_T +
                      pi * pi / 9.0 * project.model.youngs_modulus * I_z * 0.412 * 0.412 / 4.0) /
                     ((I_y + I_z) / A);
  CHECK(found->member->load.critical == Approx(800e3 / N_T).epsilon(5e-3));
}

TEST_CASE("compression inside a segment counts, wherever its ends have none", "[twisting]") {
  // Forces against each other between 0.5 m and 2.5 m.
  const std::string pair =
      "[loads.one]\nkind = \"force\"\nat = \"0.5 m\"\nforce = [\"600 kN\", \"0 kN\"]\n"
      "[loads.other]\nkind = \"force\"\nat = \"2.5 m\"\nforce = [\"-600 kN\", \"0 kN\"]\n";
  const Verification of =
      verify(parse_project("c.toml", column(trough(18.0), 0.001, held(3.0, 1), pair)));
  REQUIRE(twisting_of(of) != nullptr);
  CHECK(twisting_of(of)->member->load.compressed > 0.9 * 600e3 / (0.018 * 0.69 * 355e6));
}

TEST_CASE("slender walls twist by their effective area", "[twisting]") {
  // Walls of 6 mm: c/t = 47 and 33 of class 4.
  const Verification of = verify(parse_project("c.toml", column(trough(6.0), 150.0, held(3.0, 1))));
  const CheckResult* const found = twisting_of(of);
  REQUIRE(found != nullptr);
  const double n = 150e3 / (0.006 * 0.69 * 355e6);
  CHECK(found->member->load.compressed > 1.3 * n);
  CHECK(std::none_of(of.gates.begin(), of.gates.end(), [](const Gate& gate) {
    return gate.finding.find("twisting") != std::string::npos ||
           gate.finding.find("class 4") != std::string::npos;
  }));
}

TEST_CASE("how a beam is held against twisting is said where nobody has said it", "[twisting]") {
  const auto texts = [](const std::string& holds) {
    const Project project = parse_project("c.toml", column(trough(18.0), 600.0, holds));
    const Verification of = verify(project);
    REQUIRE(of.model.second_order.twisting);
    std::vector<std::string> found;
    for (const Remark& remark : remarks_of(project, of)) {
      if (remark.kind == Remark::Kind::assumed && remark.text.find("twisting") != std::string::npos)
        found.push_back(remark.text);
    }
    return found;
  };
  const std::vector<std::string> assumed = texts("");
  REQUIRE(assumed.size() == 1);
  CHECK(assumed.front().find("holds = [\"turning over\"]") != std::string::npos);
  CHECK(assumed.front().find("N/N_cr = ") != std::string::npos);
  CHECK(texts(held(3.0, 1)).empty());
}

}  // namespace twisting_test
