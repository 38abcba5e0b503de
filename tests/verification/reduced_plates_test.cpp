// Plates judged by reduced stresses, from the case to the verdict: against the clause written out
// once more, against stations looked at one by one, and beside effective widths.

#include "boxbeam/verification/reduced_plates.hpp"

#include <fmt/format.h>

#include <cmath>

#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/factor_of_sheet.hpp"
#include "support/reduced_by_hand.hpp"
#include "support/refusals.hpp"
#include "support/slender_cases.hpp"
#include "support/uniform.hpp"

namespace reduced_plates_test {

using namespace boxbeam;
using namespace slender_cases;

namespace {

const std::string reduced = "plates = \"reduced stresses\"\n";
const std::string slender = box("a", 600.0, 1224.0, 12.0, 8.0);
/// With a diaphragm where the force comes in.
const std::string held = segment(10.0, "a") + diaphragms({10.0});

double beside_of(const Verification& of, Criterion criterion) {
  const CheckResult* const found = governing_of(of.beside, criterion);
  return found == nullptr ? 0.0 : found->check.utilisation();
}

bool is_judged_by(const Verification& of, Criterion criterion) {
  return of.governing(criterion) != nullptr;
}

/// What acts on the plate of a check, as the clause written out takes it.
reduced_by_hand::Acting acting_on(const PanelStress& stress) {
  const double more = stress.compression > Stress{} ? 1e-6 * stress.compression.value()
                                                    : -1e-6 * stress.tension.value();
  return {more, stress.compression > Stress{} ? stress.psi * more : more,
          1e-6 * std::abs(stress.shear.value())};
}

/// The check of a plate at a station.
const CheckResult* check_at(const Verification& of, const std::string& id) {
  for (const CheckResult& result : of.checks)
    if (result.check.id == id) return &result;
  return nullptr;
}

}  // namespace

TEST_CASE("a cantilever by reduced stresses, plate by plate, by hand", "[plates]") {
  // M = 2000 kN m at the root, I = (600 x 1224^3 - 584 x 1200^3)/12, mm.
  const Verification of = verified(cantilever(slender, held, tip(10.0, -200.0), "", reduced));
  const double I = (600.0 * std::pow(1224.0, 3) - 584.0 * std::pow(1200.0, 3)) / 12.0;
  const CheckResult* const flange = check_at(of, "reduced-stress/0+/bottom-flange");
  REQUIRE(flange != nullptr);
  const PanelStress pressed = flange->plates->reduced->under(flange->plates->cut);
  CHECK(1e-6 * pressed.compression.value() == Approx(2000e6 * 606.0 / I).epsilon(1e-9));
  CHECK(pressed.psi == Approx(1.0));
  // Half of the largest shear flow of the flange, at the web: V (z t b/2)/(I t), mid-lines.
  CHECK(1e-6 * pressed.shear.value() == Approx(0.5 * 200e3 * 606.0 * 296.0 / I).epsilon(0.02));
  CHECK(flange->check.utilisation() ==
        Approx(reduced_by_hand::use({584.0, 12.0, 355.0}, acting_on(pressed))).epsilon(1e-6));
  const CheckResult* const web = check_at(of, "reduced-stress/0+/web");
  REQUIRE(web != nullptr);
  const PanelStress bent = web->plates->reduced->under(web->plates->cut);
  CHECK(1e-6 * bent.compression.value() == Approx(2000e6 * 600.0 / I).epsilon(1e-9));
  CHECK(bent.psi == Approx(-1.0));
  CHECK(1e-6 * std::abs(bent.shear.value()) == Approx(200e3 / (2.0 * 1200.0 * 8.0)).epsilon(0.02));
  CHECK(web->check.utilisation() ==
        Approx(reduced_by_hand::use({1200.0, 8.0, 355.0}, acting_on(bent))).epsilon(2e-3));
  CHECK(check_at(of, "reduced-stress/0+/top-flange") != nullptr);
  CHECK(of.verdict == Verdict::pass);
}

TEST_CASE("the routes are never mixed, and each stands beside the other", "[plates]") {
  const auto of = [](double kN, const std::string& strength) {
    return verified(cantilever(slender, held, tip(10.0, -kN), "", strength));
  };
  const Verification by_widths = of(200.0, ""), by_stress = of(200.0, reduced);
  for (const Criterion criterion : plate_criteria) {
    const bool of_stress = criterion == Criterion::reduced_stress;
    CAPTURE(to_text(criterion));
    CHECK((is_judged_by(by_widths, criterion) ? !of_stress : true));
    CHECK((is_judged_by(by_stress, criterion) ? of_stress : true));
    if (of_stress) {
      CHECK(beside_of(by_widths, criterion) == Approx(use_of(by_stress, criterion)).epsilon(1e-12));
    } else if (is_judged_by(by_widths, criterion)) {
      CHECK(beside_of(by_stress, criterion) == Approx(use_of(by_widths, criterion)).epsilon(1e-12));
    }
  }
  REQUIRE(by_widths.routes.size() == 1);
  CHECK(by_widths.routes.front().route == PlateRoute::effective_widths);
  CHECK(by_stress.routes.front().route == PlateRoute::reduced_stresses);
  // The weakest plate limits the section: a load between both resistances.
  const double widths = use_of(by_widths, Criterion::effective_section);
  const double stress = use_of(by_stress, Criterion::reduced_stress);
  REQUIRE(stress > 1.02 * widths);
  const double between = 200.0 / std::sqrt(stress * widths);
  CHECK(of(between, "").verdict == Verdict::pass);
  CHECK(of(between, reduced).verdict == Verdict::fail);
}

TEST_CASE("by reduced stresses no place is used more than what is reported", "[plates]") {
  test::Uniform in(23);
  int judged = 0;
  for (int i = 0; i < 20; ++i) {
    const bool space = i % 2 == 1;
    const double web = in(5.0, 9.0), flange = in(8.0, 16.0);
    const double first = in(600.0, 1300.0), last = in(250.0, 600.0);
    const auto three = [&](double most) {
      return fmt::format("[\"{} kN\", \"{} kN\"{}]", in(-most, most), in(-most, most),
                         space ? fmt::format(", \"{} kN\"", in(-most, most)) : "");
    };
    const std::string zero = space ? "\"0 kN/m\", " : "";
    std::string loads = fmt::format(
        "[loads.a]\nkind = \"force\"\nat = \"{} m\"\nforce = {}\n"
        "[loads.l]\nkind = \"line\"\nforce_per_length = [\"0 kN/m\", {}\"{} kN/m\"]\n",
        in(1.0, 6.0), three(200.0), zero, in(-60.0, 60.0));
    if (space) {
      loads += fmt::format(
          "[loads.t]\nkind = \"force\"\nat = \"{} m\"\nmoment = [\"{} kN m\", \"0 N m\", "
          "\"0 N m\"]\n",
          in(3.0, 6.0), in(-300.0, 300.0));
    }
    loads +=
        "[[situations]]\nname = \"one\"\nloads = { a = 1.0, l = 0.4 }\n"
        "[[situations]]\nname = \"other\"\nloads = { a = -0.7, l = 1.0 }\n";
    // A steep segment at the root of every fourth.
    const std::string text = cantilever(
        box("a", in(300.0, 700.0), first, flange, web) + box("b", 500.0, last, flange, web) +
            box("c", 500.0, 1.6 * first, flange, web),
        (i % 4 == 2 ? taper(0.5 * 1.2 * first / 1000.0, "c", "a") : std::string()) +
            segment(in(0.5, 2.0), "a") + taper(in(4.5, 8.0), "a", "b") + segment(1.0, "b") +
            (i % 3 == 0 ? diaphragms({0.0, in(1.0, 2.5), in(2.6, 4.0), in(4.1, 6.5)}) : ""),
        loads, space ? "space = true\n" : "", reduced);
    CAPTURE(i);
    judged += look_along(parse_project("slender.toml", text), 800);
  }
  CHECK(judged > 8'000);
}

TEST_CASE("plates with steep edges are judged as rectangles of their largest width", "[plates]") {
  // From 2000 to 1224 mm within 2 m: tan = 0.194, 10.98 deg; panels of 1 m.
  const std::string sections = slender + box("b", 600.0, 2000.0, 12.0, 8.0);
  const std::string segments = taper(2.0, "b", "a") + segment(8.0, "a");
  const Verification of = verified(
      cantilever(sections, segments + diaphragms({0.0, 1.0, 2.0, 10.0}), tip(10.0, -100.0)));
  CHECK(of.verdict == Verdict::pass);
  REQUIRE(of.routes.size() == 2);
  CHECK(of.routes[0].route == PlateRoute::reduced_stresses);
  CHECK(of.routes[0].reason.find("inclined by 11 deg") != std::string::npos);
  CHECK(of.routes[1].route == PlateRoute::effective_widths);
  CHECK(of.routes[1].reason.empty());
  const double steep = 1.0 + 0.194 * 0.194;
  // Two diaphragms at each end are end posts of the panels between them (9.3.1).
  for (const auto& [id, s, widest] : {std::tuple{"reduced-stress/0+/web", 0.0, 1976.0},
                                      {"reduced-stress/1-/web", 1.0, 1976.0},
                                      {"reduced-stress/1+/web", 1.0, 1588.0},
                                      {"reduced-stress/2-/web", 2.0, 1588.0}}) {
    CAPTURE(id);
    const CheckResult* const web = check_at(of, id);
    REQUIRE(web != nullptr);
    const double height = 2000.0 - 388.0 * s, clear = height - 24.0;
    const double I = (600.0 * std::pow(height, 3) - 584.0 * std::pow(clear, 3)) / 12.0;
    const double M = 100e3 * (10e3 - 1e3 * s);
    const PanelStress stress = web->plates->reduced->under(web->plates->cut);
    CHECK(1e-6 * stress.compression.value() == Approx(steep * M * 0.5 * clear / I).epsilon(1e-6));
    CHECK(web->plates->reduced->panel.depth.value() == Approx(1e-3 * widest));
    CHECK(web->check.utilisation() ==
          Approx(reduced_by_hand::use({widest, 8.0, 355.0, 1000.0, widest < 1900.0},
                                      acting_on(stress)))
              .epsilon(2e-3));
  }
  // The flange is as long as it is inclined.
  const CheckResult* const flange = check_at(of, "reduced-stress/0+/bottom-flange");
  REQUIRE(flange != nullptr);
  CHECK(flange->plates->reduced->panel.length->value() == Approx(std::hypot(1.0, 0.194)));
  // Without diaphragms all of the segment is the panel; with only one beyond it, up to that.
  for (const auto& at : {std::vector<double>{}, std::vector<double>{6.0}}) {
    const Verification bare =
        verified(cantilever(sections, segments + diaphragms(at), tip(10.0, -100.0)));
    const CheckResult* const web = check_at(bare, "reduced-stress/2-/web");
    REQUIRE(web != nullptr);
    CHECK(web->plates->reduced->panel.depth.value() == Approx(1.976));
  }
  // Nothing of effective widths stands beside them: they hold for rectangles.
  const Verification all = verified(cantilever(sections, taper(2.0, "b", "a"), tip(2.0, -100.0)));
  CHECK(all.beside.empty());
  CHECK(!is_judged_by(all, Criterion::effective_section));
}

TEST_CASE("just below 10 degrees effective widths judge, just above reduced stresses", "[plates]") {
  const auto route = [](double degrees) {
    const double change = 2000.0 * std::tan(degrees * std::acos(-1.0) / 180.0);
    const Verification of =
        verified(cantilever(slender + box("b", 600.0, 1224.0 + 2.0 * change, 12.0, 8.0),
                            taper(2.0, "b", "a"), tip(2.0, -100.0)));
    REQUIRE(of.routes.size() == 1);
    return of.routes.front().route;
  };
  CHECK(route(9.99) == PlateRoute::effective_widths);
  CHECK(route(10.01) == PlateRoute::reduced_stresses);
}

TEST_CASE("plates that need their stiffeners have no verdict by reduced stresses", "[plates]") {
  const std::string flat = flats("a", "bottom flange", {0.0}, 120.0, 12.0);
  const std::string wide = box("a", 1024.0, 820.0, 10.0, 12.0) + flat;
  const Verification of =
      verified(cantilever(wide, segment(8.0, "a"), tip(8.0, -20.0), "", reduced));
  CHECK(of.verdict == Verdict::not_applicable);
  CHECK(has_gate(of, "write plates = \"effective widths\""));
  CHECK(verified(cantilever(wide, segment(8.0, "a"), tip(8.0, -20.0))).verdict == Verdict::pass);
  const Verification steep = verified(cantilever(
      wide + box("b", 1024.0, 1700.0, 10.0, 12.0) + flats("b", "bottom flange", {0.0}, 120.0, 12.0),
      taper(2.0, "b", "a") + segment(6.0, "a"), tip(8.0, -20.0)));
  CHECK(steep.verdict == Verdict::not_applicable);
  CHECK(
      has_gate(steep, "needs its stiffeners, which reduced stresses do not judge, and its edges"));
}

TEST_CASE("a force that comes into a web counts with all else that acts on it, by hand",
          "[plates]") {
  // 5 m from the clamp of 10 m: k_F = 6, F_cr = 0.9 x 6 x 210 000 x 512/1200 = 483.84 kN; 100 kN a
  // web on 200 + 2 x 12 mm: 55.8 MPa.
  const std::string lead =
      "[[beam.load_introductions]]\nstation = \"5 m\"\nstiff_length = \"200 mm\"\n";
  const auto of = [&](double kN, const std::string& more) {
    return verified(
        cantilever(slender, segment(10.0, "a") + lead + more,
                   "[loads.hook]\nkind = \"force\"\nat = \"5 m\"\nforce = [\"0 kN\", \"" +
                       fmt::format("{}", kN) + " kN\"]\n",
                   "", reduced));
  };
  const Verification pushed = of(-200.0, "");
  const CheckResult* const hook = check_at(pushed, "reduced-stress/5/web-under-hook");
  REQUIRE(hook != nullptr);
  const auto& web = std::get<ReducedWeb>(hook->patch->bears);
  CHECK(web.onto_high);
  CHECK(web.stress.across->stress.value() == Approx(100e3 / (8.0 * 224.0) * 1e6));
  CHECK(web.stress.across->critical == Approx(483.84 / 100.0).epsilon(1e-6));
  reduced_by_hand::Acting on = acting_on(web.stress);
  on.z = 100e3 / (8.0 * 224.0);
  on.F_by_F_cr = 100.0 / 483.84;
  // Just before the hook there is all of V and no moment.
  CHECK(on.tau == Approx(200e3 / (2.0 * 1200.0 * 8.0)).epsilon(0.02));
  on.along_z = 1e-6 * web.stress.across->along[0].value();
  CHECK(on.along_z == Approx(0.0).margin(1e-6));
  CHECK(hook->check.utilisation() ==
        Approx(reduced_by_hand::use({1200.0, 8.0, 355.0}, on)).epsilon(1e-6));
  // More force, more use: in proportion.
  CHECK(check_at(of(-300.0, ""), "reduced-stress/5/web-under-hook")->check.utilisation() ==
        Approx(1.5 * hook->check.utilisation()).epsilon(1e-9));
  // A diaphragm takes it, as a column: no panel has the force.
  const Verification stiff = of(-200.0, diaphragms({5.0}));
  CHECK(check_at(stiff, "reduced-stress/5/web-under-hook") == nullptr);
  CHECK(is_judged_by(stiff, Criterion::patch_loading));
  // Where nothing is said of how it comes in there is no verdict but where the web bears it so.
  const Verification unsaid =
      verified(cantilever(slender, segment(5.0, "a"), tip(5.0, -500.0), "", reduced));
  CHECK(unsaid.verdict == Verdict::not_applicable);
  CHECK(has_gate(unsaid, "[[beam.load_introductions]]"));
}

TEST_CASE("wheels on webs by reduced stresses: no instant is worse than what is reported",
          "[plates]") {
  const double P = 60.0;
  const Project project = parse_project(
      "wheels.toml",
      cantilever(slender,
                 segment(6.0, "a") + diaphragms({0.0, 2.0, 4.0, 6.0}) +
                     "[[beam.load_introductions]]\nfrom = \"0 m\"\nto = \"6 m\"\n"
                     "stiff_length = \"150 mm\"\n",
                 fmt::format("[loads.crab]\nkind = \"wheels\"\nwheels = [{{ force = [\"0 kN\", "
                             "\"{} kN\"] }}]\nfrom = \"0 m\"\nto = \"6 m\"\nspeed = \"1 m/s\"\n",
                             -P),
                 "", reduced));
  const Verification of = verify(project);
  double reported = 0.0;
  for (const CheckResult& result : of.checks) {
    if (result.patch && std::holds_alternative<ReducedWeb>(result.patch->bears))
      reported = std::max(reported, result.check.utilisation());
  }
  REQUIRE(reported > 0.0);
  // The wheel at s: V = P before it, M = 0 at it. In each panel k_F = 6 + 2 (h/a)^2, a = 2 m.
  const double F = 0.5 * P * 1e3, k_F = 6.0 + 2.0 * 0.36;
  const double F_cr = 0.9 * k_F * 210e3 * 512.0 / 1200.0;
  const auto runs = run_situations(project, of.model.chosen);
  const double duration = runs.front().loads.period().value();
  double most = 0.0;
  for (int k = 1; k < 1000; ++k) {
    const double s = 6.0 * k / 1000.0;
    if (std::abs(s - 2.0) < 1e-3 || std::abs(s - 4.0) < 1e-3) continue;
    const Station station{si<Length>(s), Side::before};
    const auto plates = slender_plates_at(project, {}, station);
    const CutForces cut =
        runs.front().loads.diagram_at(si<Time>(duration * s / 6.0)).at({si<Length>(s - 1e-6)});
    for (const ReducedPlate& plate : plates->reduced) {
      if (is_flange(plate.sheared.plate)) continue;
      reduced_by_hand::Acting on = acting_on(plate.under(cut));
      on.z = F / (8.0 * 174.0);
      on.F_by_F_cr = F / F_cr;
      on.along_z = on.less;
      most = std::max(most, reduced_by_hand::use({1200.0, 8.0, 355.0, 2000.0}, on));
    }
  }
  CHECK(most > 0.05);
  CHECK(most <= reported * (1.0 + 1e-3));
}

TEST_CASE("fatigue of plates that work by less than half is not judged by this route either",
          "[plates]") {
  const auto at = [&](double force) {
    return verified(cantilever(box("a", 900.0, 1000.0, 8.0, 10.0), segment(10.0, "a"),
                               tip(10.0, -force), "", reduced) +
                    lifted_often);
  };
  CHECK(!has_gate(at(5.0), "2.2(5)"));
  CHECK(has_gate(at(260.0), "2.2(5)"));
}

TEST_CASE("sheets of reduced stresses end at the factor of the check", "[plates]") {
  const std::string lead =
      "[[beam.load_introductions]]\nstation = \"1 m\"\nstiff_length = \"100 mm\"\n";
  const std::string hook =
      "[loads.hook]\nkind = \"force\"\nat = \"1 m\"\nforce = [\"0 kN\", \"-100 kN\"]\n";
  const std::string steep = taper(2.0, "b", "a");
  const std::string sections = slender + box("b", 600.0, 2000.0, 12.0, 8.0);
  int sheets = 0;
  for (const std::string& segments :
       {segment(2.0, "a"), steep, steep + diaphragms({0.0, 0.4, 1.6, 2.0})}) {
    const Project project = parse_project(
        "slender.toml",
        cantilever(sections, segments + lead, tip(2.0, -1000.0, -500.0) + hook, "", reduced));
    const Verification of = verify(project);
    for (const CheckResult& result : of.checks) {
      if (result.check.criterion != Criterion::reduced_stress) continue;
      test::sheet_to_factor(project, of, result);
      ++sheets;
    }
  }
  CHECK(sheets > 10);
}

TEST_CASE("a route that is none is refused with those that are", "[plates]") {
  const auto said = [](const std::string& strength) {
    return test::refusal_of([&] {
      return parse_project("slender.toml",
                           cantilever(slender, segment(6.0, "a"), tip(6.0, -1.0), "", strength));
    });
  };
  CHECK(said(reduced).empty());
  CHECK(said("plates = \"effective widths\"\n").empty());
  const std::string wrong = said("plates = \"both\"\n");
  CHECK(wrong.find("plates") != std::string::npos);
  CHECK(wrong.find("reduced stresses") != std::string::npos);
}

}  // namespace reduced_plates_test
