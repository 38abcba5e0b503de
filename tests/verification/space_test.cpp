// Beams loaded in space: cantilevers of 2 m under forces and a torque at their free end, by hand
// formulas and by what turning or mirroring a beam with its loads must leave as it is.

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/worst_place.hpp"
#include "catch.hpp"
#include "support/beam_checks.hpp"
#include "support/cantilever.hpp"

namespace space_test {

using namespace boxbeam;

namespace {

constexpr double length = 2.0;

std::vector<CheckResult> checks_of(const Project& project) {
  return test::beam_checks_of(project).checks;
}

const CheckResult& check_at(const std::vector<CheckResult>& checks, Criterion criterion,
                            const std::string& point, double s = 0.0) {
  for (const CheckResult& result : checks) {
    const Check& check = result.check;
    if (check.criterion == criterion && check.point == point && check.station.s.value() == s)
      return result;
  }
  FAIL("no check of " << point);
  return checks.front();
}

/// The smallest safety factor of a criterion; 0 where nothing is checked by it.
double governing(const std::vector<CheckResult>& checks, Criterion criterion) {
  double least = 0.0;
  for (const CheckResult& result : checks) {
    if (result.check.criterion != criterion) continue;
    const double factor = result.check.safety_factor;
    if (least == 0.0 || factor < least) least = factor;
  }
  return least;
}

constexpr Criterion of_plates[] = {Criterion::yield, Criterion::fatigue, Criterion::shear_fatigue,
                                   Criterion::combined_fatigue, Criterion::stress_range};

/// A box of 160 x 240 mm, flanges of 8 mm, webs of 6 mm.
const std::string box_lines =
    "kind = \"box\"\nwidth = \"160 mm\"\nheight = \"240 mm\"\nflange = \"8 mm\"\nweb = \"6 mm\"\n";
/// The same turned by 90 degrees about the axis.
const std::string turned_box_lines =
    "kind = \"box\"\nwidth = \"240 mm\"\nheight = \"160 mm\"\nflange = \"6 mm\"\nweb = \"8 mm\"\n";

std::string tube_lines(const std::string& width, const std::string& height) {
  return "kind = \"rectangular tube\"\nwidth = \"" + width + "\"\nheight = \"" + height +
         "\"\nwall = \"6 mm\"\nouter_radius = \"0 mm\"\ninner_radius = \"0 mm\"\n";
}

const std::string round_lines = "kind = \"round tube\"\ndiameter = \"140 mm\"\nwall = \"8 mm\"\n";

/// Turned by 90 degrees about the axis: y becomes z, z becomes -y.
std::vector<test::EndLoad> turned(std::vector<test::EndLoad> loads) {
  for (test::EndLoad& load : loads)
    load.force = Eigen::Vector3d(load.force.x(), -load.force.z(), load.force.y());
  return loads;
}

/// Two loads of different direction, mean and phase.
std::vector<test::EndLoad> two_loads() {
  return {{{8e3, 3e3, -5e3}, 4e3, 1.0, 0.5, 0.0}, {{-3e3, 4e3, 2e3}, -2e3, 0.3, 0.8, 1.0}};
}

}  // namespace

TEST_CASE("box under N, V_y, V_z, T: corners by N/A + M_y z/I_y - M_z y/I_z, faces by Bredt") {
  const double N = 40e3, F_y = 6e3, F_z = -9e3, T = 5e3;
  Project project = test::cantilever(box_lines, {{{N, F_y, F_z}, T, 1.0, 0.5, 0.0}});
  project.strength.shear_lag = false;
  const auto checks = checks_of(project);
  const double b = 0.16, h = 0.24, t_f = 0.008, t_w = 0.006;
  const double b_i = b - 2 * t_w, h_i = h - 2 * t_f;
  const double A = b * h - b_i * h_i;
  const double I_y = (b * h * h * h - b_i * h_i * h_i * h_i) / 12;
  const double I_z = (h * b * b * b - h_i * b_i * b_i * b_i) / 12;
  // A force F at the end bends its clamp by M_y = -F_z L and M_z = F_y L. Largest: 1.5 times.
  const double M_y = -F_z * length, M_z = F_y * length;
  const auto sigma = [&](double y, double z) { return N / A + M_y * z / I_y - M_z * y / I_z; };
  for (const auto& [name, y, z] : {std::tuple{"corner +y +z", 0.5 * b, 0.5 * h},
                                   {"corner +y -z", 0.5 * b, -0.5 * h},
                                   {"corner -y +z", -0.5 * b, 0.5 * h},
                                   {"corner -y -z", -0.5 * b, -0.5 * h}}) {
    CAPTURE(name);
    const CheckResult& yield = check_at(checks, Criterion::yield, name);
    CHECK(yield.basis->stress_at_time.normal.value() == Approx(1.5 * sigma(y, z)).epsilon(1e-9));
    CHECK(yield.check.acting.value() == Approx(1.5 * std::abs(sigma(y, z))).epsilon(1e-9));
    // From 0.5 to 1.5 times.
    CHECK(check_at(checks, Criterion::fatigue, name).check.acting.value() ==
          Approx(std::abs(sigma(y, z))).epsilon(1e-9));
  }
  // Shear in the middle of the faces: V S/(I 2t), Bredt's T/(2 A_m t), and T t/I_T of the wall
  // itself on its outer face. Up along both webs and to +y along both flanges is positive; the
  // torque runs up along the left web and to -y along the top.
  const double A_m = (b - t_w) * (h - t_f);
  const double I_T = torsion_constant_of_box(
                         symmetric_box(0.16 * metre, 0.24 * metre, 0.008 * metre, 0.006 * metre))
                         .value();
  CHECK(I_T == Approx(4 * A_m * A_m / (2 * (b - t_w) / t_f + 2 * (h - t_f) / t_w)).epsilon(0.02));
  const double S_y = (b * h * h - b_i * h_i * h_i) / 8, S_z = (h * b * b - h_i * b_i * b_i) / 8;
  const double V_web = F_z * S_y / (I_y * 2 * t_w), V_flange = F_y * S_z / (I_z * 2 * t_f);
  const auto torsion = [&](double t) { return T / (2 * A_m * t) + T * t / I_T; };
  for (const auto& [name, y, z, tau] : {std::tuple{"fibre +y", 0.5 * b, 0.0, V_web + torsion(t_w)},
                                        {"fibre -y", -0.5 * b, 0.0, V_web - torsion(t_w)},
                                        {"fibre +z", 0.0, 0.5 * h, V_flange - torsion(t_f)},
                                        {"fibre -z", 0.0, -0.5 * h, V_flange + torsion(t_f)}}) {
    CAPTURE(name);
    const CheckResult& yield = check_at(checks, Criterion::yield, name);
    const double normal = 1.5 * sigma(y, z), shear = 1.5 * tau;
    CHECK(yield.basis->stress_at_time.normal.value() == Approx(normal).epsilon(1e-9));
    // What the walls' own torsion takes from Bredt's flow is below 2 %.
    CHECK(std::abs(yield.basis->stress_at_time.shear.value()) ==
          Approx(std::abs(shear)).epsilon(0.02));
    CHECK(yield.check.acting.value() ==
          Approx(std::hypot(normal, std::sqrt(3.0) * shear)).epsilon(0.01));
  }
  // Seams lie on the outer faces of the webs, where the flanges begin.
  CHECK(check_at(checks, Criterion::fatigue, "web end -y +z").check.acting.value() ==
        Approx(std::abs(sigma(-0.5 * b, 0.5 * h_i))).epsilon(1e-9));
}

TEST_CASE("no place between the named ones is worse than the worst on its wall") {
  Project project = test::cantilever(box_lines, two_loads());
  const std::deque<SituationRun> runs = run_situations(project);
  const Station clamp{Length{}, Side::behind};
  const auto histories = histories_at(runs, clamp);
  const auto zones = bending_zones_of(project, runs);
  int walls = 0;
  for (const StressPoint& point : stress_points_at(project, zones, clamp)) {
    if (!point.stretch) continue;
    ++walls;
    const double worst = check_yield(project, histories,
                                     at_worst_on_stretch(StationSamples(project, histories), point,
                                                         Criterion::yield))
                             ->check.acting.value();
    StressPoint at = point;
    double largest = 0.0;
    for (int k = 0; k <= 500; ++k) {
      at.influence = influence_in(
          point, point_on_stretch(*point.stretch->field, point.stretch->wall, k / 500.0));
      largest = std::max(largest, check_yield(project, histories, at)->check.acting.value());
    }
    CAPTURE(point.name);
    CHECK(worst >= largest * (1.0 - 1e-6));
    CHECK(worst <= largest * (1.0 + 1e-3));
  }
  CHECK(walls == 4);
}

TEST_CASE("a square tube with y and z exchanged, the torque mirrored, has the same factors") {
  const std::string square = tube_lines("120 mm", "120 mm");
  std::vector<test::EndLoad> loads = two_loads();
  const auto checks = checks_of(test::cantilever(square, loads));
  for (test::EndLoad& load : loads) {
    std::swap(load.force.y(), load.force.z());
    load.torque = -load.torque;
  }
  const auto exchanged = checks_of(test::cantilever(square, loads));
  for (const Criterion criterion : of_plates) {
    CAPTURE(to_text(criterion));
    REQUIRE(governing(checks, criterion) > 0.0);
    CHECK(governing(exchanged, criterion) == Approx(governing(checks, criterion)).epsilon(1e-9));
  }
}

TEST_CASE("a round tube has no favoured direction: loads turned by any angle, the same factors") {
  const auto checks = checks_of(test::cantilever(round_lines, two_loads()));
  std::mt19937 random(20);
  std::uniform_real_distribution<double> angle(0.0, 2.0 * std::numbers::pi);
  for (int k = 0; k < 20; ++k) {
    const double turn = angle(random);
    CAPTURE(turn);
    std::vector<test::EndLoad> loads = two_loads();
    for (test::EndLoad& load : loads)
      load.force = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitX()) * load.force;
    const auto turned_checks = checks_of(test::cantilever(round_lines, loads));
    for (const Criterion criterion : of_plates) {
      CAPTURE(to_text(criterion));
      CHECK(governing(turned_checks, criterion) ==
            Approx(governing(checks, criterion)).epsilon(1e-9));
    }
  }
}

TEST_CASE("a round tube in biaxial bending: the resultant moment over W, wherever it points") {
  // F_y and F_z of 3 and 4 kN: M = 5 kN x 2 m on the fibre at 36.9 degrees, none of the multiples
  // of 45 degrees.
  const auto checks = checks_of(test::cantilever(round_lines, {{{0.0, 3e3, 4e3}}}));
  const double I = std::numbers::pi * (std::pow(0.14, 4) - std::pow(0.124, 4)) / 64;
  const double sigma = 10e3 * 0.07 / I;
  CHECK(check_at(checks, Criterion::fatigue, "wall").check.acting.value() ==
        Approx(sigma).epsilon(1e-9));
  const CheckResult& yield = check_at(checks, Criterion::yield, "wall");
  CHECK(yield.check.acting.value() == Approx(1.5 * sigma).epsilon(1e-9));
  CHECK(std::abs(yield.basis->point.y.value()) == Approx(0.6 * 0.07).epsilon(1e-4));
  CHECK(std::abs(yield.basis->point.z.value()) == Approx(0.8 * 0.07).epsilon(1e-4));
}

TEST_CASE("boxes and tubes turned by 90 degrees with their loads have the same factors") {
  const std::vector<test::EndLoad> loads = two_loads();
  const auto tube = checks_of(test::cantilever(tube_lines("100 mm", "180 mm"), loads));
  const auto turned_tube =
      checks_of(test::cantilever(tube_lines("180 mm", "100 mm"), turned(loads)));
  for (const Criterion criterion : of_plates) {
    CAPTURE(to_text(criterion));
    REQUIRE(governing(tube, criterion) > 0.0);
    CHECK(governing(turned_tube, criterion) == Approx(governing(tube, criterion)).epsilon(1e-9));
  }
  // The seams of a box lie on other plates once it is turned: only its plates are the same. Here
  // its throats are as thick as webs, which are not those of the flanges.
  const auto box = checks_of(test::cantilever(box_lines, loads));
  const auto turned_box = checks_of(test::cantilever(turned_box_lines, turned(loads)));
  for (const Criterion criterion : {Criterion::yield, Criterion::fatigue}) {
    CAPTURE(to_text(criterion));
    CHECK(governing(turned_box, criterion) == Approx(governing(box, criterion)).epsilon(1e-9));
  }
}

TEST_CASE("shear lag of bending about z works in the webs, EN 1993-1-5 table 3.1") {
  // A box 160 mm wide and 240 mm high, clamped: L_e = 2 x 2 m, b_0 = 116 mm of the webs and 77 mm
  // of the flanges; b_0 counts from L_e/50 = 80 mm on.
  const Project project = test::cantilever(box_lines, {{{0.0, 5e3, 5e3}}});
  const std::deque<SituationRun> runs = run_situations(project);
  const auto zones = bending_zones_of(project, runs);
  REQUIRE(zones.size() == 2);
  CHECK(zones[0].axis == BendingAxis::y);
  CHECK(zones[1].axis == BendingAxis::z);
  for (const BendingZone& zone : zones) {
    CHECK(zone.effective_length.value() == Approx(4.0).epsilon(1e-6));
    CHECK(zone.region == BendingRegion::cantilever);
  }
  const Section section = section_at(project.beam, {si<Length>(1.0)});
  const ShearLags lags = shear_lags_at(zones, section, {si<Length>(1.0)});
  CHECK_FALSE(lags.flanges);
  REQUIRE(lags.webs);
  const double kappa = 0.116 / 4.0;
  const double beta = 1.0 / (1.0 + 6.0 * (kappa - 1.0 / (2500.0 * kappa)) + 1.6 * kappa * kappa);
  CHECK(lags.webs->beta == Approx(beta).epsilon(1e-9));
  // Left out of each web: (1 - beta) of 232 mm at mid-height.
  const SectionProperties whole = properties_of(section);
  const SectionProperties effective = effective_properties_of(section, {}, lags);
  const double idle = (1.0 - beta) * 0.232;
  CHECK((whole.area - effective.area).value() == Approx(2 * idle * 0.006).epsilon(1e-9));
  CHECK((whole.I_z - effective.I_z).value() ==
        Approx(2 * idle * 0.006 * (0.077 * 0.077 + 0.006 * 0.006 / 12)).epsilon(1e-9));
  CHECK((whole.I_y - effective.I_y).value() ==
        Approx(2 * 0.006 * idle * idle * idle / 12).epsilon(1e-9));
  // Only M_y: nothing is idle in the webs, and the flanges are too narrow.
  const Project upright = test::cantilever(box_lines, {{{0.0, 0.0, 5e3}}});
  const std::deque<SituationRun> upright_runs = run_situations(upright);
  CHECK(bending_zones_of(upright, upright_runs).size() == 1);
}

TEST_CASE("a web evenly compressed by M_z keeps its effective width, bent by M_y all of it") {
  // c/t = 184/4 = 46 above 42 eps = 34.2, below 124 eps = 100.9 of bending and 48.8 of shear.
  const std::string slender =
      "kind = \"box\"\nwidth = \"160 mm\"\nheight = \"200 mm\"\nflange = \"8 mm\"\n"
      "web = \"4 mm\"\n";
  const auto idle_under = [&](const Eigen::Vector3d& force, BoxPlate web, ActingAlone acting) {
    const Project project = test::cantilever(slender, {{force}});
    const BeamChecks found = test::beam_checks_of(project);
    CHECK(std::none_of(found.gates.begin(), found.gates.end(),
                       [](const Gate& gate) { return gate.blocks; }));
    const CheckResult* const check = governing_of(found.checks, Criterion::effective_section);
    if (check == nullptr) return 0.0;
    return check->plates->plates->box.alone(acting).of(web).idle.value();
  };
  CHECK(idle_under({0.0, 0.0, 2e4}, BoxPlate::left_web, ActingAlone::M_y_negative) == 0.0);
  // F_y > 0 compresses the left side, y > 0; rho of 46 in even compression is 0.783, and shear lag
  // takes a little.
  CHECK(idle_under({0.0, 2e4, 0.0}, BoxPlate::left_web, ActingAlone::M_z_positive) ==
        Approx(0.184 * (1.0 - 0.783)).margin(5e-4));
  CHECK(idle_under({0.0, -2e4, 0.0}, BoxPlate::right_web, ActingAlone::M_z_negative) ==
        Approx(0.184 * (1.0 - 0.783)).margin(5e-4));
}

TEST_CASE("flanges are the webs of V_y: above 72 eps/eta shear buckling is judged") {
  // 148/3 = 49.3 above 48.8.
  const Project project = test::cantilever(
      "kind = \"box\"\nwidth = \"160 mm\"\nheight = \"200 mm\"\nflange = \"3 mm\"\n"
      "web = \"6 mm\"\n",
      {{{0.0, 1e3, 0.0}}});
  std::set<std::string> found;
  for (const CheckResult& result : test::beam_checks_of(project).checks) {
    if (result.check.criterion == Criterion::shear_buckling) found.insert(result.check.point);
  }
  CHECK(found == std::set<std::string>{"bottom flange", "top flange"});
}

TEST_CASE("a web hole under M_z: K_g M_z y/I_z at its top and bottom, on either side") {
  Project project = test::cantilever(box_lines, {{{0.0, 6e3, 0.0}}});
  project.strength.shear_lag = false;
  add_hole(project, {si<Length>(1.0),
                     {"port", si<Length>(0.05), HoleWalls::webs, Length{}},
                     HoleCase::in_plane_bending,
                     {}});
  const auto checks = checks_of(project);
  const double I_z = (0.24 * std::pow(0.16, 3) - 0.224 * std::pow(0.148, 3)) / 12;
  const double a = 0.05 / 0.224;
  const double sigma = 6e3 * 1.0 * 0.08 / I_z;
  const double expected = membrane_concentration(a) / (1.0 - a) * sigma;
  for (const char* side : {"+y", "-y"}) {
    const std::string name = std::string("hole port edge ") + side;
    CHECK(check_at(checks, Criterion::fatigue, name, 1.0).check.acting.value() ==
          Approx(expected).epsilon(1e-9));
    CHECK(check_at(checks, Criterion::yield, name, 1.0).check.acting.value() ==
          Approx(1.5 * expected).epsilon(1e-9));
  }
}

TEST_CASE("what is not known of a shape in space stops with a reason and its segment") {
  Project polygon = test::cantilever(
      "kind = \"polygon\"\nouter = [[\"0 mm\", \"0 mm\"], [\"100 mm\", \"0 mm\"], [\"50 mm\", "
      "\"90 mm\"]]\n",
      {{{0.0, 1e3, 1e3}}});
  try {
    checks_of(polygon);
    FAIL("a polygon's shear is not known");
  } catch (const AnalysisError& error) {
    CHECK(error.failure().what.find("polygon") != std::string::npos);
    CHECK(error.failure().where.find("segment") != std::string::npos);
  }
  Project plate = test::cantilever("kind = \"plate\"\nwidth = \"40 mm\"\nheight = \"100 mm\"\n",
                                   {{{0.0, 1e3, 1e3}}});
  CHECK(governing(checks_of(plate), Criterion::yield) > 0.0);
  add_hole(plate, {si<Length>(1.0),
                   {"bolt", si<Length>(0.02), HoleWalls::webs, Length{}},
                   HoleCase::in_plane_bending,
                   {}});
  CHECK_THROWS_AS(checks_of(plate), AnalysisError);
  Project published = test::cantilever(box_lines, {{{0.0, 1e3, 1e3}}});
  add_hole(published, {si<Length>(1.0),
                       {"hub", si<Length>(0.05), HoleWalls::webs, Length{}},
                       HoleCase::published_exponential,
                       {}});
  CHECK_THROWS_AS(checks_of(published), AnalysisError);
}

TEST_CASE("in space every fibre has direct stress to be verified; seams have their own detail") {
  Project project = test::cantilever(box_lines, two_loads());
  BeamDetail seam = project.fatigue.beam;
  seam.from = {};
  seam.to = project.beam.length();
  seam.on = DetailPlace::seams;
  project.fatigue.details.push_back(seam);
  const std::deque<SituationRun> runs = run_situations(project);
  const auto zones = bending_zones_of(project, runs);
  int seams = 0;
  for (const StressPoint& point : stress_points_at(project, zones, {Length{}, Side::behind})) {
    CAPTURE(point.name);
    if (point.on_throat) {
      for (const double normal : point.influence.normal) CHECK(normal == 0.0);
      continue;
    }
    const bool at_seam = point.name.starts_with("web end");
    seams += at_seam ? 1 : 0;
    CHECK(point.yield);
    CHECK(point.detail == (at_seam ? &project.fatigue.details.front() : &project.fatigue.beam));
    for (std::size_t k = 0; k < cut_force::count; ++k) {
      CHECK(std::isfinite(point.influence.normal[k]));
      CHECK(std::isfinite(point.influence.shear[k]));
    }
  }
  CHECK(seams == 4);
}

}  // namespace space_test
