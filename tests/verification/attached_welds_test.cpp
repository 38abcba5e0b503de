// Welds of diaphragms and of flats in fatigue: hand formulas at their places, and all stations of
// random beams one by one.

#include <fmt/format.h>

#include <cmath>

#include "boxbeam/report/remarks.hpp"
#include "boxbeam/report/verdict_sentence.hpp"
#include "catch.hpp"
#include "support/slender_cases.hpp"
#include "support/uniform.hpp"

namespace attached_welds_test {

using namespace boxbeam;
using namespace slender_cases;

namespace {

constexpr double length = 6.0;  // m

/// A force at the tip of a cantilever, 2e6 times from none to all of it.
std::string lifted(const std::string& sections, const std::string& segments, double force,
                   int category, const std::string& details = "") {
  return cantilever(sections, segments,
                    tip(length, -force) +
                        "[[situations]]\nname = \"empty\"\nloads = { tip = 0.0 }\n"
                        "[[situations]]\nname = \"loaded\"\nloads = { tip = 1.0 }\n"
                        "[[situations]]\nname = \"lift\"\nbetween = [\"empty\", \"loaded\"]\n"
                        "cycles = 2e6\n",
                    "",
                    fmt::format("[fatigue]\ncategory = {}\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
                                "required = 1.0\n{}",
                                category, details));
}

// Box 300 x 600, flanges 20, webs 12 mm.
const double inertia = (0.3 * std::pow(0.6, 3) - 0.276 * std::pow(0.56, 3)) / 12.0;

std::string plain_box(const std::string& name, const std::string& flats = "") {
  return box(name, 300.0, 600.0, 20.0, 12.0, flats);
}

/// Stress range [MPa] at a height [m] above the axis under a force [kN].
double stress_at_height(double force, double s, double z, double I = inertia) {
  return 1e-3 * force * (length - s) * z / I;
}

/// The fatigue check used most at a station, by direct stress alone.
const CheckResult* worst_at(const Verification& of, double s) {
  const CheckResult* worst = nullptr;
  for (const CheckResult& result : of.checks) {
    const bool there = std::abs(result.check.station.s.value() - s) < 1e-9;
    if (!there || result.check.criterion != Criterion::fatigue) continue;
    if (worst == nullptr || result.check.utilisation() > worst->check.utilisation())
      worst = &result;
  }
  return worst;
}

const CheckResult* named(const Verification& of, const std::string& point, double s) {
  const CheckResult* worst = nullptr;
  for (const CheckResult& result : of.checks) {
    const Check& check = result.check;
    const bool meant = check.criterion == Criterion::fatigue && check.point == point &&
                       std::abs(check.station.s.value() - s) < 1e-9;
    if (meant && (worst == nullptr || check.utilisation() > worst->check.utilisation()))
      worst = &result;
  }
  return worst;
}

}  // namespace

TEST_CASE("fillets of a diaphragm: category 80 where it stands, 71 where it is thick",
          "[attached_welds]") {
  constexpr double force = 100.0;
  const auto use_at = [&](double thickness, int category, const std::string& details = "") {
    const Verification of =
        verified(lifted(plain_box("a"), segment(length, "a") + diaphragms({2.0}, thickness), force,
                        category, details));
    const CheckResult* const worst = worst_at(of, 2.0);
    REQUIRE(worst != nullptr);
    return worst->check.utilisation();
  };
  // At 2e6 cycles the strength is the category.
  const double range = stress_at_height(force, 2.0, 0.3);
  CHECK(use_at(10.0, 160) == Approx(range / 80.0).epsilon(1e-6));
  // Legs as long as it is thick: 50 mm between the toes of 16.7 mm.
  CHECK(use_at(16.0, 160) == Approx(range / 80.0).epsilon(1e-6));
  CHECK(use_at(17.0, 160) == Approx(range / 71.0).epsilon(1e-6));
  CHECK(use_at(40.0, 160) == Approx(range / 71.0).epsilon(1e-6));
  // Of a throat of 16 mm the legs are 22.6 mm: 55 mm between the toes of 10 mm, 35 mm of a
  // throat of 5 mm beside 21 mm.
  const auto use_with = [&](double thickness, double throat) {
    const std::string plate =
        diaphragms({2.0}, thickness) + fmt::format("throat = \"{} mm\"\n", throat);
    const Verification of =
        verified(lifted(plain_box("a"), segment(length, "a") + plate, force, 160));
    return worst_at(of, 2.0)->check.utilisation();
  };
  CHECK(use_with(10.0, 16.0) == Approx(range / 71.0).epsilon(1e-6));
  CHECK(use_with(21.0, 5.0) == Approx(range / 80.0).epsilon(1e-6));
  // The weaker of it and of what the case has there.
  CHECK(use_at(10.0, 63) == Approx(range / 63.0).epsilon(1e-6));
  const auto own = [](int category) {
    return fmt::format(
        "[[fatigue.details]]\nname = \"own\"\nfrom = \"1.9 m\"\nto = \"2.1 m\"\ncategory = {}\n",
        category);
  };
  CHECK(use_at(10.0, 160, own(56)) == Approx(range / 56.0).epsilon(1e-6));
  CHECK(use_at(10.0, 36, own(112)) == Approx(range / 80.0).epsilon(1e-6));
  // Unless the case says what they are.
  CHECK(use_at(10.0, 160, "diaphragms = { category = 112 }\n") ==
        Approx(range / 112.0).epsilon(1e-6));
}

TEST_CASE("fillets of a diaphragm have the k_f of the beam, and count all of a range",
          "[attached_welds]") {
  constexpr double force = 100.0;
  const auto use_with = [&](const std::string& more) {
    return worst_at(verified(lifted(plain_box("a"), segment(length, "a") + diaphragms({2.0}), force,
                                    160, more)),
                    2.0)
        ->check.utilisation();
  };
  const double range = stress_at_height(force, 2.0, 0.3);
  CHECK(use_with("stress_factor = 1.2\n") == Approx(1.2 * range / 80.0).epsilon(1e-6));
  // Below the axis the beam's own compression counts 60 %, that beside the weld does not.
  CHECK(use_with("stress_relieved = true\n") == Approx(range / 80.0).epsilon(1e-6));
}

TEST_CASE("welds of diaphragms govern the verdict, are said to be assumed and can be raised",
          "[attached_welds]") {
  // At 1 m 5/80 beside 6/160 at the root and 4/80 at 2 m.
  constexpr double force = 110.0;
  const std::string text = lifted(
      plain_box("a"),
      segment(length, "a") + diaphragms({1.0, 2.0}) +
          fmt::format("[[beam.load_introductions]]\nstation = \"{} m\"\ninto = \"webs\"\n", length),
      force, 160);
  const Project project = parse_project("welds.toml", text);
  const Verification of = verify(project, Figures::without, Advice::with);
  REQUIRE(of.verdict == Verdict::fail);
  const CheckResult& worst = of.checks.front();
  CHECK(worst.check.station.s.value() == Approx(1.0));
  CHECK(use_of(of, Criterion::fatigue) ==
        Approx(stress_at_height(force, 1.0, 0.3) / 80.0).epsilon(1e-6));
  CHECK(of.not_judged.empty());
  CHECK(verdict_sentence_of(project, of).find("(weld of a diaphragm, assumed)") !=
        std::string::npos);
  bool said = false;
  for (const Remark& remark : remarks_of(project, of))
    said = said || remark.text.find(
                       "detail category 80 is assumed for the weld of a diaphragm at "
                       "s = 1, 2 m") != std::string::npos;
  CHECK(said);
  const auto category =
      std::find_if(of.remedies.found.begin(), of.remedies.found.end(),
                   [](const Remedy& remedy) { return remedy.what == Remedy::What::category; });
  REQUIRE(category != of.remedies.found.end());
  const auto with = [&](double of_welds) {
    return verify(parse_project("welds.toml", text,
                                {fmt::format("fatigue.diaphragms={{category = {}}}", of_welds)}));
  };
  const Verification raised = with(category->value);
  CHECK(raised.verdict == Verdict::pass);
  CHECK(raised.checks.front().check.utilisation() == Approx(category->utilisation).epsilon(1e-9));
}

TEST_CASE("where the beam is as weak as its attachments nothing is said of them",
          "[attached_welds]") {
  const Project project = parse_project(
      "welds.toml",
      lifted(plain_box("a"), segment(length, "a") + diaphragms({1.0, 2.0}), 50.0, 80));
  for (const Remark& remark : remarks_of(project, verify(project)))
    CHECK(remark.text.find("weld of a diaphragm") == std::string::npos);
}

TEST_CASE("flats: category 100 along them, where they stand on their plate", "[attached_welds]") {
  constexpr double force = 100.0;
  // On both webs 100 mm above the axis, 80 x 10: they move the axis up.
  const Verification of =
      verified(lifted(plain_box("a", flats("a", "left web", {100.0}, 80.0, 10.0) +
                                         flats("a", "right web", {100.0}, 80.0, 10.0)),
                      segment(length, "a"), force, 160));
  const double area = 0.3 * 0.6 - 0.276 * 0.56, flat = 2.0 * 0.08 * 0.01;
  const double z_0 = flat * 0.1 / (area + flat);
  const double I = inertia + area * z_0 * z_0 + flat * (1e-4 / 12.0 + std::pow(0.1 - z_0, 2));
  const CheckResult* const at_root = named(of, "stiffener 1 weld", 0.0);
  REQUIRE(at_root != nullptr);
  CHECK(at_root->check.utilisation() ==
        Approx(stress_at_height(force, 0.0, 0.1 - z_0, I) / 100.0).epsilon(1e-6));
  // Far from the edges of the web, it is used less than the flanges by 160.
  CHECK(worst_at(of, 0.0)->check.point != "stiffener 1 weld");
  CHECK(named(of, "stiffener 1 end", length) == nullptr);
  CHECK(named(of, "stiffener 1 start", 0.0) == nullptr);
}

TEST_CASE("the end of a flat within the beam: category 56 in the plate that goes on",
          "[attached_welds]") {
  constexpr double force = 80.0;
  const auto with = [&](const std::string& details) {
    return verified(
        lifted(plain_box("a", flats("a", "top flange", {0.0}, 100.0, 12.0)) + plain_box("b"),
               segment(2.0, "a") + segment(length - 2.0, "b"), force, 160, details));
  };
  const double range = stress_at_height(force, 2.0, 0.3);
  const Verification of = with("");
  const CheckResult* const end = named(of, "stiffener 1 end", 2.0);
  REQUIRE(end != nullptr);
  CHECK(end->check.station.side == Side::behind);
  CHECK(end->check.utilisation() == Approx(range / 56.0).epsilon(1e-6));
  const Verification given = with("flat_ends = { category = 80 }\n");
  CHECK(named(given, "stiffener 1 end", 2.0)->check.utilisation() ==
        Approx(range / 80.0).epsilon(1e-6));
  // The other flange has the beam's own detail.
  CHECK(named(of, "fibre -z", 2.0)->check.utilisation() == Approx(range / 160.0).epsilon(1e-6));
}

TEST_CASE("short flats end by their length, and flats go on from segment to segment",
          "[attached_welds]") {
  const auto attachments = [](const std::string& sections, const std::string& segments) {
    return parse_project("welds.toml", lifted(sections, segments, 50.0, 160)).fatigue.attachments;
  };
  const auto flat = [](const std::string& name, double at) {
    return plain_box(name, flats(name, "top flange", {at}, 100.0, 12.0));
  };
  // Row 8.4/1: up to 50 mm 80, 80 mm 71, 100 mm 63, beyond 56.
  for (const auto& [long_, category] :
       {std::pair{0.05, 80e6}, {0.06, 71e6}, {0.09, 63e6}, {0.2, 56e6}}) {
    const auto welds =
        attachments(plain_box("a") + flat("b", 0.0),
                    segment(2.0, "a") + segment(long_, "b") + segment(length - 2.0 - long_, "a"));
    REQUIRE(welds.size() == 3);
    CHECK(curve_of(welds[0].detail.detail).reference.value() == Approx(100e6));
    for (const std::size_t i : {1U, 2U})
      CHECK(curve_of(welds[i].detail.detail).reference.value() == Approx(category));
  }
  // Within its thickness at the same place it is the same flat.
  const auto pieces = segment(2.0, "a") + segment(length - 2.0, "b");
  CHECK(attachments(flat("a", 0.0) + flat("b", 11.0), pieces).size() == 2);
  CHECK(attachments(flat("a", 0.0) + flat("b", 13.0), pieces).size() == 4);
}

TEST_CASE("random beams, station by station: nothing is used more than what is found",
          "[attached_welds]") {
  test::Uniform draw(20261126);
  for (int n = 0; n < 6; ++n) {
    const double top = draw(100.0, 140.0);
    const auto section = [&](const char* name, double height, double flat) {
      return box(name, 300.0, height, 20.0, 12.0,
                 flats(name, "top flange", {flat}, 100.0, 12.0) +
                     flats(name, "left web", {0.3 * height}, 80.0, 10.0));
    };
    std::vector<double> at;
    for (int k = 0; k < 3; ++k) at.push_back(std::round(1e3 * draw(0.3, 5.7)) / 1e3);
    const double border = std::round(1e3 * draw(1.5, 4.5)) / 1e3;
    const std::string text =
        lifted(section("a", draw(600.0, 700.0), 0.0) + section("b", draw(350.0, 550.0), 20.0) +
                   box("c", 300.0, draw(350.0, 400.0), 20.0, 12.0),
               taper(border, "a", "b") + segment(length - border, "c") + diaphragms(at), top,
               n % 2 == 0 ? 125 : 160);
    CAPTURE(text);
    const Project project = parse_project("welds.toml", text);
    const Verification of = verify(project);
    const double own = n % 2 == 0 ? 125.0 : 160.0;
    // The force bends about y alone: sigma = M (I_z z - I_yz y)/(I_y I_z - I_yz^2).
    double most = 0.0;
    const auto look = [&](double s, Side side) {
      const Station station{si<Length>(s), side};
      const Section here = section_at(project.beam, station);
      const AreaSums sums = sums_of(outline_of(here, {}));
      const Eigen::Matrix<double, 1, 1> moment(top * 1e3 * (length - s));
      const auto stress = [&](double y, double z) {
        const StressInfluence influence = normal_influence(sums, y, z);
        return 1e-6 * std::abs(influence.normal[cut_force::M_y] * moment(0));
      };
      const auto& hull = std::get<Box>(here.outer);
      const double half = 0.5 * hull.height.value();
      const bool diaphragm =
          std::any_of(at.begin(), at.end(), [&](double place) { return place == s; });
      for (const double z : {-half, half})
        for (const double y : {-0.15, 0.0, 0.15})
          most = std::max(most, stress(y, z) / (diaphragm ? 80.0 : own));
      const Section with_flats = section_at(project.beam, {si<Length>(s), Side::before});
      const auto& bars = std::get<Box>(s > border ? here.outer : with_flats.outer).stiffeners;
      for (const Stiffener& bar : bars) {
        const bool web = bar.plate == BoxPlate::left_web;
        const double category = s == border ? 56.0 : diaphragm ? 80.0 : 100.0;
        most = std::max(
            most,
            (web ? stress(0.15, bar.place.value()) : stress(bar.place.value(), half)) / category);
      }
    };
    for (int k = 0; k <= 3000; ++k) look(length * k / 3000.0, k == 0 ? Side::behind : Side::before);
    for (const double s : at) look(s, Side::before);
    for (const Side side : {Side::before, Side::behind}) look(border, side);
    CHECK(use_of(of, Criterion::fatigue) >= most * (1.0 - 2e-4));
    CHECK(use_of(of, Criterion::fatigue) <= most * (1.0 + 5e-3));
  }
}

}  // namespace attached_welds_test
