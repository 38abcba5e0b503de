#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>

#include "boxbeam/report/format.hpp"
#include "boxbeam/report/formula_tree.hpp"
#include "boxbeam/report/report.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "catch.hpp"
#include "support/clamped_beam.hpp"
#include "support/formula_value.hpp"
#include "support/held_bar.hpp"
#include "support/program.hpp"
#include "support/rig.hpp"

namespace sheet_test {

using namespace boxbeam;
using report::Sheet;
using report::Step;

namespace {

/// A shipped case with its result, which points into the case.
struct Verified {
  explicit Verified(const std::string& path)
      : name(path), project(read_project(path)), verification(verify(project)) {}
  std::string name;
  Project project;
  Verification verification;
};

const std::deque<Verified>& shipped_cases() {
  static const std::deque<Verified> cases = [] {
    std::vector<std::string> paths;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(test::project_file("sections"))) {
      const std::filesystem::path& path = entry.path();
      const std::filesystem::path folder = path.parent_path().filename();
      if (path.extension() != ".toml" || folder == "catalogue" || folder == "studies") continue;
      paths.push_back(path.string());
    }
    std::sort(paths.begin(), paths.end());
    return std::deque<Verified>(paths.begin(), paths.end());
  }();
  return cases;
}

/// The sheet of a check of a shipped case, and both in words.
struct ShippedSheet {
  Sheet sheet;
  const Check* check = nullptr;
  std::string words;
};

const std::vector<ShippedSheet>& shipped_sheets() {
  static const std::vector<ShippedSheet> sheets = [] {
    std::vector<ShippedSheet> all;
    for (const Verified& of : shipped_cases()) {
      for (const CheckResult& result : of.verification.checks) {
        Sheet sheet = sheet_of(of.project, of.verification, result);
        std::string words = of.name + "\n" + report::text_of(sheet).text;
        all.push_back({std::move(sheet), &result.check, std::move(words)});
      }
    }
    return all;
  }();
  return sheets;
}

/// Does something with the sheet of every check of every shipped case.
template <class Action>
void for_all_sheets(const Action& action) {
  REQUIRE(shipped_cases().size() >= 10);
  for (const ShippedSheet& of : shipped_sheets()) {
    INFO(of.words);
    action(of.sheet, *of.check);
  }
}

const Step* find(const Sheet& sheet, const std::string& symbol) {
  const auto found = std::find_if(sheet.steps.begin(), sheet.steps.end(),
                                  [&](const Step& step) { return step.symbol == symbol; });
  return found == sheet.steps.end() ? nullptr : &*found;
}

/// How the values of a sheet hang together.
struct Recalculation {
  int compared = 0;   ///< pairs of formulas of one chain that have values
  int by_symbol = 0;  ///< among them formulas of symbols that earlier steps gave
  std::vector<std::string> wrong;
};

Recalculation recalculated(const Sheet& sheet) {
  Recalculation result;
  test::FormulaValues known;
  for (const Step& step : sheet.steps) {
    std::optional<test::FormulaValue> before;
    std::string formula_before;
    for (const std::string& formula : step.formulas) {
      const auto value = test::value_of(formula, known);
      if (!value) continue;
      if (before) {
        ++result.compared;
        if (formula_before == step.formulas.front()) ++result.by_symbol;
        if (!test::agree(*before, *value))
          result.wrong.push_back(step.symbol + ": " + formula_before + " = " + formula);
      }
      before = value;
      formula_before = formula;
    }
    if (before) known[step.symbol] = *before;
  }
  return result;
}

/// Every formula is one, and each comes to what the next one of its chain says.
void check_by_calculator(const Sheet& sheet) {
  INFO(report::text_of(sheet).text);
  for (const Step& step : sheet.steps) {
    CHECK(report::parse_formula(step.symbol));
    for (const std::string& formula : step.formulas) {
      INFO(formula);
      CHECK(report::parse_formula(formula));
    }
  }
  const Recalculation again = recalculated(sheet);
  CHECK(again.compared >= 2);
  CHECK(again.wrong == std::vector<std::string>{});
}

}  // namespace

TEST_CASE("Every formula of every sheet is one, and so is every symbol",
          "[report][sheet][unsanitized]") {
  int formulas = 0;
  std::set<std::string> known;  // many stand in many sheets
  const auto is_one = [&](const std::string& text) {
    return known.count(text) > 0 || (report::parse_formula(text) && known.insert(text).second);
  };
  for_all_sheets([&](const Sheet& sheet, const Check&) {
    for (const Step& step : sheet.steps) {
      if (!is_one(step.symbol)) FAIL("no symbol: " << step.symbol);
      for (const std::string& formula : step.formulas) {
        if (!is_one(formula)) FAIL("no formula: " << formula);
        ++formulas;
      }
    }
  });
  CHECK(formulas > 10000);
}

TEST_CASE("A pocket calculator comes to what the sheets of rods and deflections say",
          "[report][sheet]") {
  const auto with_rod = [](const std::string& force, const std::string& section,
                           const std::string& more) {
    return test::held_bar(
        false, "kind = \"plate\"\nwidth = \"50 mm\"\nheight = \"100 mm\"\n",
        "[forces.push]\nkind = \"force\"\npoint = \"bar.B\"\ndirection = \"-90 deg\"\nsize = \"" +
            force + "\"\n[sections.strut]\n" + section +
            "[[rods]]\nname = \"strut\"\nfrom = \"rod.P\"\nto = \"rod.Q\"\n"
            "section = \"strut\"\ncurve = \"c\"\n" +
            more);
  };
  const std::string thin =
      "kind = \"box\"\nwidth = \"600 mm\"\nheight = \"400 mm\"\nflange = \"1 mm\"\n"
      "web = \"2 mm\"\n";
  const std::string stout = "kind = \"plate\"\nwidth = \"150 mm\"\nheight = \"150 mm\"\n";
  const std::string demand =
      "[deflection]\nlimit = \"50 mm\"\nload_factor = true\n"
      "[[situations]]\nname = \"lift\"\nload_factor = 1.35\n";
  const std::vector<std::pair<Project, std::string>> of{
      {with_rod("40 kN", thin, "buckling_length = \"9 m\"\n"), "A_eff"},
      {with_rod("40 kN", stout, "gamma_M0 = 1.5\n"), "N_c,Rd"},
      {with_rod("-40 kN", stout, "net_area = \"200 cm^2\"\n"), "N_u,Rd"},
      {test::clamped_beam(test::clamped::steady, demand), "w_1"},
  };
  for (const auto& [project, symbol] : of) {
    const Verification verification = verify(project);
    bool stands = false;
    for (const CheckResult& result : verification.checks) {
      const Criterion criterion = result.check.criterion;
      if (criterion != Criterion::rod && criterion != Criterion::buckling &&
          criterion != Criterion::deflection) {
        continue;
      }
      const Sheet sheet = sheet_of(project, verification, result);
      stands = stands || find(sheet, symbol) != nullptr;
      check_by_calculator(sheet);
    }
    INFO(symbol);
    CHECK(stands);
  }
}

TEST_CASE("A pocket calculator comes to what the sheets of distorted boxes say",
          "[report][sheet]") {
  const auto box = [](const std::string& seam) {
    return parse_project(
        "box.toml",
        "[case]\nname = \"box\"\nkind = \"static\"\n[frame]\nspace = true\ngravity = [\"0 m/s^2\", "
        "\"0 m/s^2\", \"0 m/s^2\"]\n[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n"
        "[sections.a]\nkind = \"box\"\nwidth = \"620 mm\"\nheight = \"620 mm\"\nflange = \"20 "
        "mm\"\nweb = \"20 mm\"\n" +
            seam +
            "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n[loads.tip]\nkind = \"force\"\nat = "
            "\"20 m\"\nforce = [\"0 N\", \"5 kN\", \"-20 kN\"]\n[loads.eccentric]\nkind = "
            "\"force\"\nat = \"10 m\"\nforce = [\"0 N\", \"0 N\", \"0 N\"]\nmoment = [\"150 kN "
            "m\", \"0 N m\", \"0 N m\"]\n[beam]\ndensity = \"7850 kg/m^3\"\nfrom = [\"0 m\", \"0 "
            "m\", \"0 m\"]\naxis = \"x\"\nz = \"z\"\n[[beam.segments]]\nlength = \"20 "
            "m\"\nsection = \"a\"\n[[beam.diaphragms]]\nstation = \"0 m\"\nthickness = \"20 mm\"\n"
            "[fatigue]\ncategory = 100\nloading = \"spectrum\"\ngamma_Ff = 1.0\ngamma_Mf = 1.35\n"
            "required = 1.0\n[[situations]]\nname = \"up\"\nload_factor = 1.2\nloads = { tip = "
            "1.0, "
            "eccentric = 1.0 }\n[[situations]]\nname = \"down\"\nloads = { tip = 0.0, eccentric = "
            "-0.5 }\n[[situations]]\nname = \"change\"\nbetween = [\"up\", \"down\"]\ncycles = "
            "2e5\n");
  };
  for (const char* const seam : {"", "seam_throat = \"7 mm\"\n"}) {
    const Project project = box(seam);
    const Verification verification = verify(project);
    int sheets = 0;
    for (const CheckResult& result : verification.checks) {
      if (!result.distortion) continue;
      ++sheets;
      const Sheet sheet = sheet_of(project, verification, result);
      check_by_calculator(sheet);
      const Step* const factor = find(sheet, "factor");
      REQUIRE(factor != nullptr);
      const auto said = test::value_of(factor->formulas.back());
      const auto wanted = test::value_of(text::significant(result.check.safety_factor, 4));
      REQUIRE(said);
      CHECK(test::agree(*said, *wanted));
    }
    CHECK(sheets == 3);
  }
}

TEST_CASE("A pocket calculator comes to what every step of every sheet says", "[report][sheet]") {
  // Interval arithmetic over what the rounding of the printed numbers leaves open, with units.
  int compared = 0;
  int by_symbol = 0;
  for_all_sheets([&](const Sheet& sheet, const Check&) {
    const Recalculation of = recalculated(sheet);
    for (const std::string& wrong : of.wrong) FAIL_CHECK(wrong);
    compared += of.compared;
    by_symbol += of.by_symbol;
  });
  CHECK(compared > 10000);
  CHECK(by_symbol > 1000);
}

TEST_CASE("The pocket calculator finds a number that is one percent off", "[report][sheet]") {
  int found = 0;
  int chains = 0;
  for_all_sheets([&](Sheet sheet, const Check& check) {
    if (check.criterion != Criterion::yield || chains > 200) return;
    Step& factor = sheet.steps.back();
    ++chains;
    factor.formulas.back() = text::significant(check.safety_factor * 1.01, 4);
    found += recalculated(sheet).wrong.empty() ? 0 : 1;
  });
  CHECK(chains > 100);
  CHECK(found == chains);
}

namespace {

/// The symbols of all sheets of a project, each of which is made of formulas and holds.
std::set<std::string> symbols_of(const Project& project) {
  const Verification verification = verify(project);
  std::set<std::string> symbols;
  for (const CheckResult& result : verification.checks) {
    const Sheet sheet = sheet_of(project, verification, result);
    INFO(report::text_of(sheet).text);
    for (const std::string& wrong : recalculated(sheet).wrong) FAIL_CHECK(wrong);
    for (const Step& step : sheet.steps) {
      // What kinks press has curves of its own, whatever the case says of its details.
      if (result.check.criterion != Criterion::patch_fatigue) symbols.insert(step.symbol);
      if (!report::parse_formula(step.symbol)) FAIL("no symbol: " << step.symbol);
      for (const std::string& formula : step.formulas) {
        if (!report::parse_formula(formula)) FAIL("no formula: " << formula);
      }
    }
    if (sheet.steps.back().formulas.back() != text::significant(result.check.safety_factor, 4))
      FAIL_CHECK("does not end with the factor");
  }
  return symbols;
}

/// Of the rig with something changed.
template <class Change>
std::set<std::string> symbols_after(const Change& change) {
  Project project = test::rig();
  change(project);
  return symbols_of(project);
}

constexpr auto mm = 1e-3 * metre;

/// The rig with the sections A1 and A2 and the inner tube replaced by one of the lines given, all
/// along, and with these lines for the holes.
Project rig_of(const std::string& section, const std::string& holes) {
  const std::string path = test::project_file("sections/sledge-rig/rig.toml");
  std::ifstream file(path);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto replace = [&](const std::string& from, const std::string& to, const std::string& by) {
    const std::size_t begin = text.find(from);
    const std::size_t end = text.find(to, begin);
    REQUIRE(begin != std::string::npos);
    REQUIRE(end != std::string::npos);
    text.replace(begin, end - begin, by);
  };
  replace("[[beam.holes]]", "# The two points", holes);
  replace("# The two points", "[material]", "");
  replace("[[beam.segments]]", "[material]",
          "[[beam.segments]]\nname = \"S\"\nlength = \"6.2 m\"\nsection = \"X\"\n" + holes);
  replace("[sections.A1]", "[beam]", "[sections.X]\n" + section + "\n");
  return parse_project(path, text);
}

}  // namespace

TEST_CASE("Sheets of unlike boxes and of inclined principal axes hold", "[report][sheet]") {
  const auto box = symbols_of(
      rig_of("kind = \"box\"\nwidth = \"400 mm\"\nheight = \"600 mm\"\ntop_flange = \"70 mm\"\n"
             "bottom_flange = \"50 mm\"\nweb = \"40 mm\"\n",
             ""));
  CHECK(box.count("M_c") == 1);
  CHECK(box.count("e_z") == 1);
  const auto angle = symbols_of(
      rig_of("kind = \"thin-walled\"\n[sections.X.nodes]\na = [\"-100 mm\", \"300 mm\"]\n"
             "b = [\"-100 mm\", \"-300 mm\"]\nc = [\"200 mm\", \"-300 mm\"]\n"
             "[[sections.X.walls]]\nfrom = \"a\"\nto = \"b\"\nthickness = \"40 mm\"\n"
             "[[sections.X.walls]]\nfrom = \"b\"\nto = \"c\"\nthickness = \"40 mm\"\n",
             ""));
  CHECK(angle.count("I_yz") == 1);
  CHECK(angle.count("k_M") == 1);
}

TEST_CASE("Sheets of every kind of hole hold", "[report][sheet]") {
  const auto web = symbols_after([](Project&) {});
  CHECK(web.count("k_M") == 1);
  CHECK(web.count("k_V") == 1);
  CHECK(web.count("z_0") == 1);
  const auto flange = symbols_after([](Project& project) {
    Hole& hole = project.holes.front().hole;
    hole.walls = HoleWalls::flanges;
    hole.position = 60.0 * mm;
    hole.diameter = 40.0 * mm;
    project.holes.front().concentration = HoleCase::membrane_tension;
  });
  CHECK(flange.count("K_g") == 1);
  const auto published = symbols_after([](Project& project) {
    for (BeamHole& at : project.holes) at.concentration = HoleCase::published_exponential;
  });
  CHECK(published.count("K_t") == 1);
  const auto plate =
      symbols_of(rig_of("kind = \"plate\"\nwidth = \"400 mm\"\nheight = \"200 mm\"\n",
                        "[[beam.holes]]\nname = \"eye\"\nstation = \"2 m\"\ndiameter = \"60 mm\"\n"
                        "through = \"flanges\"\noffsets = [\"0 mm\"]\n"
                        "concentration = \"out-of-plane bending\"\n"));
  CHECK(plate.count("K_b") == 1);
}

TEST_CASE("Sheets of every kind of detail and curve hold", "[report][sheet]") {
  const auto factors = symbols_after([](Project& project) {
    project.fatigue.demand.gamma_Ff = 1.1;
    project.fatigue.demand.gamma_Mf = 1.15;
    project.fatigue.beam.stress_factor = 1.3;
    project.fatigue.beam.detail.size_effect = SizeEffect::butt;
    project.fatigue.beam.detail.size_factor = 0.8706;
  });
  CHECK(factors.count("k_s") == 1);
  const auto reduced = symbols_after([](Project& project) {
    project.fatigue.details.clear();
    project.fatigue.beam.detail.compression_reduced = true;
    project.fatigue.beam.stress_factor = 1.2;
    project.fatigue.demand.loading = Loading::constant_amplitude;
  });
  CHECK(reduced.count("d_sigma_red") == 1);
  const auto short_life =
      symbols_after([](Project& project) { project.situations.front().cycles = 2e4; });
  CHECK(short_life.count("factor_CA") == 0);
  // As in BS 7608: a bend at 1e7 cycles, no cut-off; and a limit that lies within a branch.
  const auto endless = symbols_after([](Project& project) {
    SnCurve& curve = project.fatigue.beam.detail.curve;
    curve = en_1993_1_9_direct(90);
    curve.branches = {{3.0, 1e7}, {5.0, std::numeric_limits<double>::infinity()}};
    curve.constant_amplitude_limit.reset();
    curve.cut_off.reset();
    curve.unconfirmed = true;
    project.fatigue.details.clear();
  });
  CHECK(endless.count("d_sigma_K1") == 1);
  CHECK(endless.count("d_sigma_L") == 0);
  const auto within = symbols_after([](Project& project) {
    project.fatigue.beam.detail.curve.constant_amplitude_limit = 2e7;
    project.fatigue.details.clear();
  });
  CHECK(within.count("d_sigma_D") == 1);
}

TEST_CASE("A sheet ends with the factor of its check", "[report][sheet]") {
  for_all_sheets([](const Sheet& sheet, const Check& check) {
    if (sheet.steps.empty()) FAIL("no steps");
    const Step& last = sheet.steps.back();
    if (last.symbol != "factor") FAIL("ends with " << last.symbol);
    if (last.formulas.back() != text::significant(check.safety_factor, 4)) {
      FAIL_CHECK(last.formulas.back() << " is not " << check.safety_factor);
    }
    if (sheet.id != check.id || sheet.source != check.source ||
        sheet.utilisation != check.utilisation()) {
      FAIL_CHECK("another check");
    }
    if (sheet.mark != (check.passes() ? report::Mark::passes : report::Mark::fails)) {
      FAIL_CHECK("marked otherwise");
    }
  });
}

TEST_CASE("What acts and what resists stands in the sheet as in the table of checks",
          "[report][sheet]") {
  std::set<Criterion> seen;
  for_all_sheets([&](const Sheet& sheet, const Check& check) {
    seen.insert(check.criterion);
    const auto ends_with = [&](const char* symbol, const Amount& amount) {
      const Step* step = find(sheet, symbol);
      if (step == nullptr) FAIL("no step " << symbol);
      const auto value = test::value_of(step->formulas.back());
      const auto wanted = test::value_of(text::amount(amount.value(), amount.unit()));
      if (!value || !wanted || !test::agree(*value, *wanted))
        FAIL_CHECK(symbol << " is not " << amount.value());
    };
    switch (check.criterion) {
      case Criterion::yield:
        if (find(sheet, "sigma_v") != nullptr) ends_with("sigma_v", check.acting);
        break;
      case Criterion::fatigue: ends_with("d_sigma", check.acting); break;
      case Criterion::shear_fatigue: ends_with("d_tau", check.acting); break;
      case Criterion::combined_fatigue: ends_with("D", check.acting); break;
      case Criterion::stress_range: ends_with("limit", check.resisting); break;
      case Criterion::weld:
        ends_with(find(sheet, "F_w,Rd") != nullptr ? "F_w,Rd" : "limit", check.resisting);
        break;
      case Criterion::pin: ends_with("F", check.acting); break;
      case Criterion::lug_fatigue: ends_with("d_sigma", check.acting); break;
      case Criterion::rod:
        ends_with("N", check.acting);
        ends_with("N_t,Rd", check.resisting);
        break;
      case Criterion::buckling:
        ends_with("N", check.acting);
        ends_with("N_b,Rd", check.resisting);
        break;
      case Criterion::effective_section: ends_with("f_y", check.resisting); break;
      case Criterion::shear_buckling: ends_with("V_bw,Rd", check.resisting); break;
      case Criterion::interaction: ends_with("factor", check.safety_factor); break;
      case Criterion::reduced_stress: ends_with("factor", check.safety_factor); break;
      case Criterion::patch_loading: ends_with("factor", check.safety_factor); break;
      case Criterion::patch_fatigue: ends_with("d_sigma", check.acting); break;
      case Criterion::distortion: ends_with("sigma_v", check.acting); break;
      case Criterion::distortion_fatigue: ends_with("D", check.acting); break;
      case Criterion::member: ends_with("use", check.acting); break;
      case Criterion::deflection:
        ends_with("w", check.acting);
        ends_with("w_lim", check.resisting);
        break;
    }
  });
  // In no shipped case shear and normal stress together are more than either alone, none is judged
  // by reduced stresses, no beam buckles as a member and no pin has lugs; their sheets are looked
  // at beside their checks.
  seen.insert(Criterion::interaction);
  seen.insert(Criterion::reduced_stress);
  seen.insert(Criterion::member);
  seen.insert(Criterion::lug_fatigue);
  CHECK(seen.size() == criteria.size());
}

namespace {

/// The sheet of a check of a shipped case.
Sheet shipped_sheet(const std::string& file, const std::string& id) {
  for (const Verified& of : shipped_cases()) {
    if (std::filesystem::path(of.name).filename() != file) continue;
    for (const CheckResult& result : of.verification.checks) {
      if (result.check.id == id) return sheet_of(of.project, of.verification, result);
    }
  }
  FAIL("no " << id << " in " << file);
  return {};
}

/// The value of a step, in the unit that it is printed in.
double value_in(const Sheet& sheet, const std::string& symbol) {
  const Step* step = find(sheet, symbol);
  if (step == nullptr) FAIL("no step " << symbol);
  return std::stod(step->formulas.back());
}

std::string notes_of(const Sheet& sheet, const std::string& symbol) {
  const Step* step = find(sheet, symbol);
  if (step == nullptr) FAIL("no step " << symbol);
  std::string notes;
  for (const std::string& note : step->notes) notes += note + "\n";
  return notes;
}

}  // namespace

TEST_CASE("Ranges of a sheet are numbered from 1 without gaps, and never one alone twice",
          "[report][sheet]") {
  int numbered = 0;
  for_all_sheets([&](const Sheet& sheet, const Check& check) {
    if (check.criterion != Criterion::fatigue && check.criterion != Criterion::shear_fatigue &&
        check.criterion != Criterion::combined_fatigue)
      return;
    int last = 0;
    std::set<std::string> symbols;
    for (const Step& step : sheet.steps) {
      if (!symbols.insert(step.symbol).second && step.symbol != "k_s")
        FAIL_CHECK(step.symbol << " twice");
      const std::string number = step.symbol.substr(step.symbol.rfind('_') + 1);
      const bool range = step.symbol.starts_with("d_sigma_") || step.symbol.starts_with("d_tau_");
      if (!range || number.find_first_not_of("0123456789") != std::string::npos) continue;
      ++numbered;
      if (std::stoi(number) != ++last) FAIL_CHECK(step.symbol << " behind number " << last - 1);
    }
  });
  CHECK(numbered > 100);
}

TEST_CASE("The damage of several ranges stands row by row, its largest share in words",
          "[report][sheet]") {
  const Sheet sheet = shipped_sheet("rig-detailed.toml", "fatigue/5.2+/fibre+z");
  INFO(report::text_of(sheet).text);
  // By hand: 5e6 (52.31/(1.35 26.23))^5 = 3.52e7 cycles of running, 1.41e7 of over-stroke.
  CHECK(value_in(sheet, "N_1") == Approx(5e6 * std::pow(52.31 / (1.35 * 26.23), 5)).epsilon(2e-3));
  CHECK(value_in(sheet, "D") == Approx(1e8 / value_in(sheet, "N_1")).epsilon(1e-3));
  CHECK(find(sheet, "D")->formulas.size() == 4);
  CHECK(notes_of(sheet, "D").find("normal running does all but 0.0") != std::string::npos);
  // Wherever there is damage its rows are there.
  for_all_sheets([&](const Sheet& of, const Check& check) {
    const Step* D = find(of, "D");
    if (D == nullptr || check.criterion == Criterion::yield) return;
    if (D->formulas.back() != "0" && D->formulas.size() < 3) FAIL_CHECK("D is not laid open");
  });
}

TEST_CASE("Torsion stands as Bredt's flow and Saint-Venant's stress on the face",
          "[report][sheet]") {
  // The foot 100 x 100 x 10: A_m = 90 x 90, T = 4.2 kN m. Bredt alone: 25.9 MPa.
  const Sheet sheet = shipped_sheet("retraction.toml", "yield/1.1-/fibre-z");
  INFO(report::text_of(sheet).text);
  CHECK(value_in(sheet, "A_m") == Approx(8100));
  const double I_T = value_in(sheet, "I_T");
  CHECK(std::abs(value_in(sheet, "c_TB")) ==
        Approx((1.0 - 1.2e5 / I_T) / (2.0 * 8100 * 10)).epsilon(1e-3));
  CHECK(std::abs(value_in(sheet, "c_TV")) == Approx(10.0 / I_T).epsilon(1e-3));
  CHECK(find(sheet, "c_T") == nullptr);
  const Sheet seam = shipped_sheet("retraction.toml", "shear-fatigue/1.1-/seam-y-z-throat");
  CHECK(find(seam, "c_TB") != nullptr);
  CHECK(find(seam, "c_TV") == nullptr);
  CHECK(notes_of(seam, "c_My").find("derivative along the axis") != std::string::npos);
}

TEST_CASE("A first moment says what it is of, and beta which of the table it is",
          "[report][sheet]") {
  // Tube 290 x 490 x 56, sharp corners: the half beyond its axis.
  const Sheet sheet = shipped_sheet("rig.toml", "shear-fatigue/6.2-/neutral-axis");
  INFO(report::text_of(sheet).text);
  CHECK(notes_of(sheet, "S").find("what lies beyond z = 0") != std::string::npos);
  std::set<std::string> factors;
  for_all_sheets([&](const Sheet& of, const Check&) {
    for (const Step& step : of.steps) {
      for (const std::string& note : step.notes) {
        if (note.find("mid-lines") != std::string::npos && step.symbol != "A_m")
          FAIL_CHECK(step.symbol << ": " << note);
      }
      if (step.symbol != "beta" && step.symbol != "beta_web") continue;
      if (step.formulas.size() == 1) continue;
      const std::string note = notes_of(of, step.symbol);
      factors.insert(note.substr(0, 6));
      // Sagging has the square of kappa only.
      if (note.starts_with("beta_1") != (step.formulas.front().find("6.4") != std::string::npos ||
                                         step.formulas.front().find("5.9") != std::string::npos))
        FAIL_CHECK(note);
    }
  });
  CHECK(factors == std::set<std::string>{"beta_1", "beta_2"});
}

}  // namespace sheet_test
