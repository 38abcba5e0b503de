// The governing place of every criterion is found wherever it lies: hand formulas on the two sides
// of a place, and dense sampling of the exact checks along seeded random beams.

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/given_stresses.hpp"
#include "boxbeam/verification/verify.hpp"
#include "boxbeam/verification/worst_place.hpp"
#include "catch.hpp"
#include "support/beam_checks.hpp"
#include "support/cantilever.hpp"
#include "support/program.hpp"
#include "support/rig.hpp"
#include "support/tip_loaded.hpp"

namespace governing_place_test {

using namespace boxbeam;

namespace {

std::string box_section(const std::string& name, int width, int height, int flange, int web) {
  return fmt::format(
      "[sections.{}]\nkind = \"box\"\nwidth = \"{} mm\"\nheight = \"{} mm\"\nflange = \"{} mm\"\n"
      "web = \"{} mm\"\n",
      name, width, height, flange, web);
}

const std::string taper_sections =
    box_section("root", 150, 300, 12, 8) + box_section("tip", 150, 150, 12, 8);
const std::string taper_segment =
    "[[beam.segments]]\nlength = \"4 m\"\nfrom = \"root\"\nto = \"tip\"\n";

std::string fatigue_lines(int category, const std::string& cycles, double gamma_Mf) {
  return fmt::format(
      "[fatigue]\ncategory = {}\ncycles = {}\nloading = \"spectrum\"\ngamma_Mf = {}\n"
      "required = 1.0\n",
      category, cycles, gamma_Mf);
}

std::string detail_lines(const std::string& name, double from, double to, int category) {
  return fmt::format(
      "[[fatigue.details]]\nname = \"{}\"\nfrom = \"{:.17g} m\"\nto = \"{:.17g} m\"\n"
      "category = {}\n",
      name, from, to, category);
}

/// The section modulus of a box 150 mm wide with flanges of 12 mm and webs of 8 mm.
double modulus_of(double h) {
  return (0.15 * h * h * h - 0.134 * std::pow(h - 0.024, 3)) / 12.0 / (0.5 * h);
}

const CheckResult* find(const Verification& verification, Criterion criterion,
                        const std::string& point, const std::string& station) {
  for (const CheckResult& result : verification.checks) {
    const Check& check = result.check;
    if (check.criterion == criterion && check.point == point && to_text(check.station) == station)
      return &result;
  }
  return nullptr;
}

/// The smallest factor of a criterion at a station, of points whose name begins so.
double factor_at(const Verification& verification, Criterion criterion, const std::string& begins,
                 const std::string& station) {
  double least = 1e300;
  for (const CheckResult& result : verification.checks) {
    const Check& check = result.check;
    if (check.criterion != criterion || to_text(check.station) != station) continue;
    if (check.point.starts_with(begins)) least = std::min(least, check.safety_factor);
  }
  return least;
}

using Worst = std::map<Criterion, double>;

Worst worst_of(const std::vector<CheckResult>& checks) {
  Worst worst;
  for (const CheckResult& result : checks) {
    double& most = worst[result.check.criterion];
    most = std::max(most, result.check.utilisation());
  }
  return worst;
}

/// Both sides of every place that the test knows of, and `count` places at equal distances.
std::vector<Station> dense_stations(const Project& project, std::vector<double> places, int count) {
  const double length = project.beam.length().value();
  for (const Segment& segment : project.beam.segments) places.push_back(segment.end().value());
  for (const BeamDetail& detail : project.fatigue.details) {
    places.push_back(detail.from.value());
    places.push_back(detail.to.value());
  }
  std::vector<Station> stations;
  const auto add = [&](double s) {
    if (s > 0.0 && s < length) stations.push_back({si<Length>(s), Side::both});
  };
  // A hair's breadth from the place: the loss of stress over it is below 1e-6.
  const double hair = 1e-7 * length;
  add(hair);
  for (const double place : places) {
    add(place - hair);
    add(place + hair);
  }
  for (int k = 1; k < count; ++k) add(length * k / count);
  return stations;
}

void check_nothing_worse(const Project& project, const std::vector<double>& places, int count) {
  const std::deque<SituationRun> runs = run_situations(project);
  const VerifiedStations found = search_stations(project, runs, bending_zones_of(project, runs));
  Worst reported = worst_of(test::beam_checks_at(project, found.stations).checks);
  const Worst dense =
      worst_of(test::beam_checks_at(project, dense_stations(project, places, count)).checks);
  CHECK(found.search.tolerance <= 1.01e-4);
  // What plates that buckle are judged by is left out where another check says as much.
  double& section = reported[Criterion::effective_section];
  section = std::max(section, reported[Criterion::yield]);
  double& both = reported[Criterion::interaction];
  both = std::max({both, section, reported[Criterion::shear_buckling]});
  for (const auto& [criterion, utilisation] : dense) {
    CAPTURE(to_text(criterion), found.search.evaluations);
    CHECK(utilisation <= reported[criterion] * (1.0 + 2e-4));
  }
}

/// Seeded boxes, tapers, kinks, nested tubes and details on a beam of 4 m.
class RandomBeam {
 public:
  explicit RandomBeam(unsigned seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool chance(double share) { return between(0.0, 1.0) < share; }

  Section box(bool nested, bool unlike) {
    const auto mm = [&](double low, double high) { return si<Length>(1e-3 * between(low, high)); };
    Box box = symmetric_box(mm(120, 250), mm(120, 450), mm(8, 30), mm(6, 20));
    if (unlike) box.right_web = mm(6, 20);
    Section section{box, {}};
    if (nested) {
      section.inner = RectangularTube{0.8 * (box.width - box.left_web - box.right_web),
                                      0.8 * (box.height - 2.0 * box.top_flange),
                                      mm(4, 10),
                                      {},
                                      {}};
    }
    return section;
  }

  void give_shape(Project& project, double length, bool unlike) {
    project.beam.segments.clear();
    const int count = 1 + static_cast<int>(between(0.0, 3.999));
    double s = 0.0;
    Section last = box(false, unlike);
    for (int i = 0; i < count; ++i) {
      const double end = i + 1 == count ? length : s + (length - s) * between(0.2, 0.7);
      const bool nested = chance(0.3);
      const bool goes_on = !nested && !last.inner && chance(0.6);
      const Section from = goes_on ? last : box(nested, unlike);
      const Section to = chance(0.25) ? from : box(nested, unlike);
      project.beam.segments.push_back(
          {std::to_string(i), si<Length>(s), si<Length>(end - s), from, to});
      last = to;
      s = end;
    }
    for (Segment& segment : project.beam.segments) segment.name = "part " + segment.name;
    constexpr int categories[] = {36, 50, 71, 90, 112, 160};
    for (int i = 0; i < 3; ++i) {
      if (chance(0.4)) continue;
      BeamDetail detail = project.fatigue.beam;
      detail.detail.curve =
          en_1993_1_9_direct(categories[static_cast<std::size_t>(between(0.0, 5.999))]);
      const double from = between(0.0, length), to = between(0.0, length);
      detail.from = si<Length>(std::min(from, to));
      detail.to = si<Length>(std::max(from, to));
      project.fatigue.details.push_back(detail);
    }
  }

 private:
  std::mt19937 random_;
};

}  // namespace

TEST_CASE("just behind the end of a strong detail the weaker one governs, in plane and space") {
  // F = 20 kN ranges at the tip of 4 m; at 0.05 m the box is 298.125 mm high. Category 71 at 2e6
  // cycles bears 71/1.35 MPa; at 0 category 160 passes with 98.6 %.
  const double h = 0.3 - 0.15 * 0.05 / 4.0;
  const double range = 20e3 * 3.95 / modulus_of(h);
  const double expected = range / (71e6 / 1.35);
  CHECK(expected == Approx(2.21).epsilon(2e-3));
  const double at_clamp = 20e3 * 4.0 / modulus_of(0.3) / (160e6 / 1.35);
  CHECK(at_clamp == Approx(0.986).epsilon(1e-3));

  const Project plane =
      test::planar_cantilever(4.0, taper_sections, taper_segment, {{4.0}},
                              fatigue_lines(71, "2e6", 1.35) + detail_lines("hub", 0, 0.05, 160));
  Project space = test::cantilever(
      "kind = \"box\"\nwidth = \"150 mm\"\nheight = \"300 mm\"\nflange = \"12 mm\"\n"
      "web = \"8 mm\"\n",
      {{{0.0, 0.0, -10e3}, 0.0, 1.0, 1.0, 0.0}});
  space.fatigue = plane.fatigue;
  space.situations.front().cycles = 2e6;
  space.beam.segments = plane.beam.segments;
  space.beam.points.clear();
  std::get<spatial::Mechanism>(space.mechanism).loads.front().at.p = {4.0, 0.0, 0.0};
  for (const Project* project : std::initializer_list<const Project*>{&plane, &space}) {
    const Verification verification = verify(*project);
    CHECK(verification.verdict == Verdict::fail);
    const CheckResult* governing = verification.governing(Criterion::fatigue);
    REQUIRE(governing != nullptr);
    CHECK(governing->check.utilisation() == Approx(expected).epsilon(1e-4));
    CHECK(to_text(governing->check.station) == "0.05+");
    // What jumps by rounding is looked for without end.
    CHECK(verification.search.evaluations > 0);
    CHECK(verification.search.evaluations < 1000);
  }
}

TEST_CASE("a strong detail hides nothing beside it in the planar template") {
  const std::string text = test::read_file(test::project_file("sections/templates/planar.toml"));
  Project project = parse_project("planar.toml", text);
  BeamDetail strong = project.fatigue.beam;
  strong.detail.curve = en_1993_1_9_direct(160);
  strong.from = si<Length>(1.45);
  strong.to = si<Length>(1.55);
  project.fatigue.details = {strong};
  check_nothing_worse(project, {1.5}, 300);
}

TEST_CASE("at the kink of the rig both sides are checked: the shear flow jumps there") {
  // At 1.5 m a taper ends. By equilibrium its inclined flanges carry most of the shear; V S/(I t)
  // on the prismatic side is some six times as much. Factors of an independent calculation.
  const Verification verification = verify(test::rig());
  const auto factors = [&](Criterion criterion) {
    const double a = factor_at(verification, criterion, "seam +z", "1.5-");
    const double b = factor_at(verification, criterion, "seam +z", "1.5+");
    return std::pair{std::min(a, b), std::max(a, b)};
  };
  const auto [shear_low, shear_high] = factors(Criterion::shear_fatigue);
  CHECK(shear_low == Approx(13.6).epsilon(5e-3));
  CHECK(shear_high == Approx(85.2).epsilon(5e-3));
  const auto [weld_low, weld_high] = factors(Criterion::weld);
  CHECK(weld_low == Approx(178).epsilon(5e-3));
  CHECK(weld_high == Approx(1064).epsilon(5e-3));
}

TEST_CASE("the plate in which a point lies gives the size effect, in inner profiles too") {
  // Row 8.3/5, flange 20 mm, web 50 mm: k_s = (25/50)^0.2 = 0.871 in the web alone, so that what
  // would be 1.930 there is 1.680.
  const std::string sections =
      box_section("outer", 300, 400, 20, 50) +
      "[sections.core]\nkind = \"rectangular tube\"\nwidth = \"120 mm\"\nheight = \"120 mm\"\n"
      "wall = \"40 mm\"\nouter_radius = \"0 mm\"\ninner_radius = \"0 mm\"\n"
      "[sections.both]\nkind = \"nested\"\nouter = \"outer\"\ninner = \"core\"\n";
  const Project project = test::planar_cantilever(
      4.0, sections, "[[beam.segments]]\nlength = \"4 m\"\nsection = \"both\"\n", {{4.0}},
      "[fatigue]\nrow = \"8.3/5\"\ncycles = 2e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
      "required = 1.0\n");
  const double category = project.fatigue.beam.detail.curve.reference.value();
  const Verification verification = verify(project);
  const auto strength_at = [&](const std::string& point) {
    const CheckResult* found = find(verification, Criterion::fatigue, point, "0+");
    REQUIRE(found != nullptr);
    return found->basis->curves.front().reference.value();
  };
  CHECK(strength_at("fibre +z") == Approx(category).epsilon(1e-12));
  CHECK(strength_at("web end +z") == Approx(category * std::pow(0.5, 0.2)).epsilon(1e-12));
  CHECK(strength_at("inner fibre +z") ==
        Approx(category * std::pow(25.0 / 40.0, 0.2)).epsilon(1e-12));
  CHECK(1.930 * std::pow(0.5, 0.2) == Approx(1.680).epsilon(1e-3));
}

TEST_CASE("a plate that grows through 16 mm has the strength of its thicker side there") {
  // S355: 355 MPa up to 16 mm, 345 MPa beyond. Flanges grow from 12 to 20 mm over 4 m: 16 mm in
  // the middle.
  const Project project = test::planar_cantilever(
      4.0, box_section("root", 150, 300, 20, 8) + box_section("tip", 150, 300, 12, 8),
      taper_segment, {{4.0}}, fatigue_lines(71, "2e6", 1.0));
  const Verification verification = verify(project);
  const CheckResult* thick = find(verification, Criterion::yield, "fibre +z", "2-");
  const CheckResult* thin = find(verification, Criterion::yield, "fibre +z", "2+");
  REQUIRE(thick != nullptr);
  REQUIRE(thin != nullptr);
  CHECK(thick->check.resisting.value() == Approx(345e6));
  CHECK(thin->check.resisting.value() == Approx(355e6));
  CHECK(thick->check.acting.value() == Approx(thin->check.acting.value()).epsilon(1e-7));
}

TEST_CASE("a hole in unlike webs is judged in each web, at its own y and with its own plate") {
  // Axial force only: the centroid lies towards the thicker web, and the force on the axis bends
  // the box about z: sigma = N/A - N y_c (y - y_c)/I_z.
  const std::string sections =
      "[sections.box]\nkind = \"box\"\nwidth = \"200 mm\"\nheight = \"300 mm\"\n"
      "flange = \"12 mm\"\nleft_web = \"30 mm\"\nright_web = \"10 mm\"\n";
  const Project project = test::planar_cantilever(
      4.0, sections,
      "[[beam.segments]]\nlength = \"4 m\"\nsection = \"box\"\n"
      "[[beam.holes]]\nname = \"port\"\nstation = \"2 m\"\ndiameter = \"60 mm\"\n"
      "through = \"webs\"\nlevels = [\"0 mm\"]\nconcentration = \"in-plane bending\"\n",
      {{4.0, 0.0, 100.0, 100.0}}, fatigue_lines(71, "2e6", 1.0));
  const double web_height = 0.276;
  const double A_left = web_height * 0.03, A_right = web_height * 0.01;
  const double A = 2.0 * 0.2 * 0.012 + A_left + A_right;
  const double y_left = 0.1 - 0.015, y_right = -0.1 + 0.005;
  const double y_c = (A_left * y_left + A_right * y_right) / A;
  const double I_z =
      2.0 * (0.012 * std::pow(0.2, 3) / 12.0 + 0.2 * 0.012 * y_c * y_c) +
      web_height * std::pow(0.03, 3) / 12.0 + A_left * (y_left - y_c) * (y_left - y_c) +
      web_height * std::pow(0.01, 3) / 12.0 + A_right * (y_right - y_c) * (y_right - y_c);
  const double N = 200e3, a = 0.06 / web_height;
  const double K = membrane_concentration(a) / (1.0 - a);
  const Verification verification = verify(project);
  for (const auto& [name, y, yield] :
       {std::tuple{"hole port edge +y", 0.1, 345e6}, {"hole port edge -y", -0.1, 355e6}}) {
    CAPTURE(name);
    const CheckResult* found = find(verification, Criterion::yield, name, "2");
    REQUIRE(found != nullptr);
    const double sigma = N / A - N * y_c * (y - y_c) / I_z;
    CHECK(found->check.acting.value() == Approx(K * std::abs(sigma)).epsilon(1e-3));
    CHECK(found->check.resisting.value() == Approx(yield));
    CHECK(found->basis->point.y.value() == Approx(y));
  }
}

TEST_CASE("a hole in flanges of unlike thickness is judged in each flange with its own plate") {
  // Gross: sigma = K_g M z/I. S355: 355 MPa up to 16 mm, 345 MPa beyond; the size effect of the
  // thick flange belongs to it alone.
  const std::string sections =
      "[sections.box]\nkind = \"box\"\nwidth = \"200 mm\"\nheight = \"300 mm\"\n"
      "top_flange = \"12 mm\"\nbottom_flange = \"30 mm\"\nweb = \"8 mm\"\n";
  const Project project = test::planar_cantilever(
      4.0, sections,
      "[[beam.segments]]\nlength = \"4 m\"\nsection = \"box\"\n"
      "[[beam.holes]]\nname = \"port\"\nstation = \"2 m\"\ndiameter = \"30 mm\"\n"
      "through = \"flanges\"\noffsets = [\"0 mm\"]\nconcentration = \"membrane tension\"\n",
      {{4.0}},
      "[fatigue]\nrow = \"8.3/5\"\ncycles = 2e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
      "required = 1.0\n");
  const double web = 2.0 * 0.008, height = 0.258;
  const double A = 0.2 * 0.012 + 0.2 * 0.03 + web * height;
  const double z_c = (0.2 * 0.012 * 0.144 - 0.2 * 0.03 * 0.135 + web * height * 0.009) / A;
  const auto share = [&](double b, double h, double z) {
    return b * h * h * h / 12.0 + b * h * (z - z_c) * (z - z_c);
  };
  const double I = share(0.2, 0.012, 0.144) + share(0.2, 0.03, -0.135) + share(web, height, 0.009);
  const double M = 20e3 * 2.0, a = 0.03 / (0.2 - web);
  const double K = membrane_concentration(a) / (1.0 - a);
  const double category = project.fatigue.beam.detail.curve.reference.value();
  const Verification verification = verify(project);
  for (const auto& [name, z, yield, size] :
       {std::tuple{"hole port edge +z", 0.15, 355e6, 1.0},
        {"hole port edge -z", -0.15, 345e6, std::pow(25.0 / 30.0, 0.2)}}) {
    CAPTURE(name);
    const CheckResult* found = find(verification, Criterion::yield, name, "2");
    REQUIRE(found != nullptr);
    CHECK(found->check.acting.value() == Approx(K * M * std::abs(z - z_c) / I).epsilon(1e-3));
    CHECK(found->check.resisting.value() == Approx(yield));
    const CheckResult* fatigue = find(verification, Criterion::fatigue, name, "2");
    REQUIRE(fatigue != nullptr);
    CHECK(fatigue->basis->curves.front().reference.value() == Approx(category * size));
  }
}

TEST_CASE("a given stress is judged by the detail at its place") {
  Project project = read_project(test::project_file("sections/sledge-rig/published.toml"));
  REQUIRE_FALSE(project.given_stresses.empty());
  project.fatigue.round_strength_to.reset();
  const GivenStress given = project.given_stresses.front();
  REQUIRE(given.opposite);
  const auto resisting = [&] {
    for (const CheckResult& result : check_given_stresses(project)) {
      if (result.check.criterion == Criterion::fatigue && result.check.point == given.name)
        return result.check.resisting.value();
    }
    return 0.0;
  };
  BeamDetail weak = project.fatigue.beam;
  weak.detail.curve = en_1993_1_9_direct(36);
  weak.from = weak.to = given.s;
  project.fatigue.details.push_back(weak);
  // 1e8 cycles and more at the cut-off: 36 (2/5)^(1/3) (5/100)^(1/5) MPa; fewer on the second line.
  const double n = std::min(1e8, most_cycles_of(project));
  REQUIRE(n >= 5e6);
  const double knee = 36e6 * std::cbrt(0.4);
  const FatigueDemand& demand = project.fatigue.demand;
  const double strength =
      demand.loading == Loading::constant_amplitude ? knee : knee * std::pow(5e6 / n, 0.2);
  CHECK(resisting() == Approx(strength / (demand.gamma_Ff * demand.gamma_Mf)).epsilon(1e-9));
  // Elsewhere it does not count.
  project.fatigue.details.back().from = project.fatigue.details.back().to =
      given.s + si<Length>(0.01);
  CHECK(resisting() > 1.5 * strength / (demand.gamma_Ff * demand.gamma_Mf));
}

TEST_CASE("details on fibres and seams leave the webs between them to that of the beam") {
  // Bent across, F = 10 kN ranges: the webs' faces have M/W_z, with category 36 of the beam.
  const double range =
      10e3 * 2.0 / ((0.3 * std::pow(0.15, 3) - 0.276 * std::pow(0.134, 3)) / 12.0 / 0.075);
  Project project = test::cantilever(
      "kind = \"box\"\nwidth = \"150 mm\"\nheight = \"300 mm\"\nflange = \"12 mm\"\n"
      "web = \"8 mm\"\n",
      {{{0.0, 10e3, 0.0}, 0.0, 0.5, 0.5, 0.0}});
  const auto governing = [&](const std::string& webs) {
    project.fatigue =
        test::planar_cantilever(4.0, taper_sections, taper_segment, {{4.0}},
                                fatigue_lines(36, "2e6", 1.0) + detail_lines("flanges", 0, 4, 160) +
                                    "on = \"fibres\"\n" + detail_lines("seams", 0, 4, 112) +
                                    "on = \"seams\"\n" + webs)
            .fatigue;
    project.situations.front().cycles = 2e6;
    project.strength.shear_lag = false;
    return verify(project).governing(Criterion::fatigue)->check;
  };
  CHECK(governing("").utilisation() == Approx(range / 36e6).epsilon(1e-3));
  CHECK(governing(detail_lines("webs", 0, 4, 90) + "on = \"webs\"\n").utilisation() ==
        Approx(range / 90e6).epsilon(1e-3));
}

TEST_CASE("the range that is limited takes the largest stress factor of the details at a place") {
  // Category 36 resists least, 36 < 160/1.5, so fatigue is judged by it; but where the stress
  // is 1.5 times the nominal one its range is 1.5 x 20 kN x 4 m / W of 1.5 f_y.
  Project project = test::planar_cantilever(4.0, taper_sections, taper_segment, {{4.0}},
                                            fatigue_lines(160, "2e6", 1.35));
  BeamDetail weak = project.fatigue.beam;
  weak.from = si<Length>(0.0);
  weak.to = si<Length>(0.05);
  weak.detail.curve = en_1993_1_9_direct(36);
  BeamDetail concentrated = weak;
  concentrated.detail.curve = en_1993_1_9_direct(160);
  concentrated.stress_factor = 1.5;
  project.fatigue.details = {weak, concentrated};
  const double range = 20e3 * 4.0 / modulus_of(0.3);
  const double f_y = yield_strength_of(project.material, si<Length>(0.012)).value().value();
  const Verification verification = verify(project);
  const CheckResult* limited = verification.governing(Criterion::stress_range);
  REQUIRE(limited != nullptr);
  CHECK(limited->check.utilisation() == Approx(range / f_y).epsilon(1e-4));
  const CheckResult* fatigue = verification.governing(Criterion::fatigue);
  REQUIRE(fatigue != nullptr);
  CHECK(fatigue->check.utilisation() == Approx(range / (36e6 / 1.35)).epsilon(1e-4));
}

TEST_CASE("webs of which one is stiffened are two webs") {
  // c/t = 276/2 = 138, above 124 eps = 100.9 of pure bending: both are slender, and the bar on the
  // left one turns the axis of bending, so that they are not alike. The bar twists (d/t = 15), so
  // that the plates have no other verdict.
  const std::string sections =
      "[sections.box]\nkind = \"box\"\nwidth = \"200 mm\"\nheight = \"300 mm\"\n"
      "flange = \"12 mm\"\nweb = \"2 mm\"\n"
      "stiffeners = [{ on = \"left web\", at = \"60 mm\", depth = \"120 mm\", "
      "thickness = \"8 mm\" }]\n";
  Project project = test::planar_cantilever(
      4.0, sections, "[[beam.segments]]\nlength = \"4 m\"\nsection = \"box\"\n", {{4.0}},
      fatigue_lines(71, "2e6", 1.0));
  project.strength.required = 5.0;  // stressed up to f_y so far as a class is concerned
  std::map<std::string, int> plates;
  for (const Gate& gate : test::beam_checks_at(project, {{Length{}, Side::behind}}).gates) {
    if (gate.finding.find("class 4") != std::string::npos) ++plates[gate.plate];
  }
  CHECK(plates["left web"] == 1);
  CHECK(plates["right web"] == 1);
  CHECK(plates["web"] == 0);
}

TEST_CASE("shear at the flange's end counts with the bending of its fibre") {
  // A short box: at the clamp sigma = M/W over the whole flange, and beside the web its shear flow
  // is V b_i t h_m/(4 I)... of half the flange between the webs: tau = V z b_i/(2 I).
  const Project project =
      test::planar_cantilever(0.5, box_section("box", 300, 200, 10, 20),
                              "[[beam.segments]]\nlength = \"0.5 m\"\nsection = \"box\"\n",
                              {{0.5, -90.0, 200.0, 100.0}}, fatigue_lines(71, "1e5", 1.0));
  Project without_lag = project;
  without_lag.strength.shear_lag = false;
  const Verification verification = verify(without_lag);
  const double b_i = 0.26, h_i = 0.18;
  const double I = (0.3 * std::pow(0.2, 3) - b_i * std::pow(h_i, 3)) / 12.0;
  const double V = 300e3, sigma = V * 0.5 * 0.1 / I;
  const double tau = V * 0.095 * 0.5 * b_i / I;
  double most = 0.0;
  for (const CheckResult& result : verification.checks) {
    if (result.check.criterion != Criterion::yield || result.check.station.s.value() > 0.0)
      continue;
    if (result.check.point != "top flange" && result.check.point != "bottom flange") continue;
    most = std::max(most, result.check.acting.value());
  }
  // The stress at the flange's middle line and its outer fibre differ by the thickness alone.
  CHECK(most == Approx(std::sqrt(sigma * sigma + 3.0 * tau * tau)).epsilon(2e-3));
}

TEST_CASE("checks by what the search found of points are those of points found anew") {
  for (const char* const file : {"sledge-rig/rig.toml", "drill-truck/truck.toml"}) {
    const Project project = read_project(test::project_file(std::string("sections/") + file));
    const std::deque<SituationRun> runs = run_situations(project);
    const std::vector<BendingZone> zones = bending_zones_of(project, runs);
    const VerifiedStations found = search_stations(project, runs, zones);
    CHECK_FALSE(found.points.empty());
    const BeamChecks known = check_beam(project, runs, zones, found, {});
    const BeamChecks anew = check_beam(project, runs, zones, {found.stations}, {});
    REQUIRE(known.checks.size() == anew.checks.size());
    for (std::size_t i = 0; i < known.checks.size(); ++i) {
      CAPTURE(file, anew.checks[i].check.id);
      CHECK(known.checks[i].check.id == anew.checks[i].check.id);
      CHECK(known.checks[i].check.safety_factor == anew.checks[i].check.safety_factor);
      CHECK(known.checks[i].basis->point.y == anew.checks[i].basis->point.y);
      CHECK(known.checks[i].basis->point.z == anew.checks[i].basis->point.z);
    }
  }
}

TEST_CASE("no station is worse than the worst one reported, on random beams in the plane",
          "[unsanitized]") {
  for (unsigned seed = 1; seed <= 24; ++seed) {
    CAPTURE(seed);
    RandomBeam random(seed);
    std::vector<test::AxisForce> forces{{4.0, random.between(-180.0, 180.0), 10.0, 8.0}};
    std::vector<double> places;
    for (int i = 0; i < 2; ++i) {
      if (random.chance(0.4)) continue;
      const double frequency = random.chance(0.5) ? 1.0 : 3.0;
      forces.push_back({random.between(0.3, 3.7), random.between(-180.0, 180.0),
                        random.between(0.0, 10.0), random.between(1.0, 10.0), frequency,
                        random.between(0.0, 360.0)});
      places.push_back(forces.back().s);
    }
    Project project = test::planar_cantilever(4.0, taper_sections, taper_segment, forces,
                                              fatigue_lines(71, "2e6", 1.35));
    const Length centre = mass_properties_of(project.beam).centre;
    random.give_shape(project, 4.0, random.chance(0.3));
    // Points of the bar are given from its centre of mass, which another shape moves.
    const double shift = (centre - mass_properties_of(project.beam).centre).value();
    auto& mechanism = planar_of(project);
    const auto move = [&](planar::Attachment& at) {
      if (at.body == project.beam_body) at.p.x() += shift;
    };
    for (planar::Joint& joint : mechanism.joints) {
      if (auto* clamp = std::get_if<planar::Rigid>(&joint.kind)) {
        move(clamp->a);
        move(clamp->b);
      }
    }
    for (planar::AppliedForce& force : mechanism.forces)
      move(std::get<planar::PointForce>(force.kind).at);
    check_nothing_worse(project, places, 60);
  }
}

TEST_CASE("no station is worse than the worst one reported, on random beams in space") {
  for (unsigned seed = 101; seed <= 106; ++seed) {
    CAPTURE(seed);
    RandomBeam random(seed);
    std::vector<test::EndLoad> loads;
    for (int i = 0; i < 2; ++i) {
      const auto force = [&] { return random.between(-10e3, 10e3); };
      loads.push_back({{2.0 * force(), force(), force()},
                       random.chance(0.5) ? 0.5 * force() : 0.0,
                       random.between(0.0, 1.0),
                       random.between(0.3, 1.0),
                       random.between(0.0, 6.28)});
    }
    Project project = test::cantilever(
        "kind = \"box\"\nwidth = \"150 mm\"\nheight = \"300 mm\"\nflange = \"12 mm\"\n"
        "web = \"8 mm\"\n",
        loads);
    random.give_shape(project, 2.0, random.chance(0.5));
    check_nothing_worse(project, {}, 30);
  }
}

}  // namespace governing_place_test
