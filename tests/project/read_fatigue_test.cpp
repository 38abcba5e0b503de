#include <cmath>

#include "boxbeam/verification/verify.hpp"
#include "project/small_case.hpp"
#include "support/changed_rig.hpp"

namespace read_fatigue_test {

using namespace boxbeam;

namespace {

/// The small case, moved for a second, with other lines in [fatigue].
std::string case_with(const std::string& fatigue, const std::string& section = "") {
  std::string text = small_case::bodies;
  const std::size_t begin = text.find("[fatigue]\n");
  text.erase(begin);
  if (!section.empty()) {
    const std::size_t tube = text.find("kind = \"round tube\"");
    const std::size_t end = text.find("[beam]");
    text.replace(tube, end - tube, section);
  }
  return text + "[fatigue]\n" + fatigue + small_case::pivot + small_case::for_a_second;
}

const std::string rest = "cycles = 1e6\nloading = \"spectrum\"\nrequired = 1.0\n";
const std::string factors = rest + "gamma_Mf = 1.0\n";

FatigueInput read(const std::string& fatigue, const std::string& section = "") {
  return parse_project("small.toml", case_with(fatigue, section)).fatigue;
}

const std::string plate_50 = "kind = \"plate\"\nwidth = \"50 mm\"\nheight = \"200 mm\"\n";
const std::string splice =
    "facts = { part = \"splice\", direction = \"transverse\", weld = \"butt\", sides = \"both\", "
    "shape = \"plate\", thickness_step = \"none\", ground = \"yes\", ndt = \"yes\" }\n";

}  // namespace

TEST_CASE("the detail of the beam by category, by row and by facts") {
  // Categories of EN 1993-1-9, table 8.3, and figure 7.1.
  const Detail by_category = read("category = 71\n" + factors).beam.detail;
  CHECK(by_category.curve.reference.value() == Approx(71e6));
  CHECK(by_category.row.empty());
  const Detail by_row = read("row = \"8.3/1\"\n" + factors).beam.detail;
  CHECK(by_row.row == "8.3/1");
  CHECK(by_row.curve.reference.value() == Approx(112e6));
  const Detail by_facts = read(splice + factors).beam.detail;
  CHECK(by_facts.row == "8.3/1");
  CHECK(by_facts.curve.reference.value() == Approx(112e6));
}

TEST_CASE("the detail of the whole beam reaches from its start to its end") {
  const FatigueInput input = read("category = 71\nassumed = \"not classified\"\n" + factors);
  CHECK(input.beam.from.value() == 0.0);
  CHECK(input.beam.to.value() == 1.0);
  CHECK(input.beam.assumed == "not classified");
}

TEST_CASE("a butt weld in a plate of 50 mm: (25/50)^0.2, EN 1993-1-9 7.2.2") {
  const double k_s = std::pow(25.0 / 50.0, 0.2);
  const Detail thick = read("row = \"8.3/1\"\n" + factors, plate_50).beam.detail;
  CHECK(thick.size_factor == Approx(k_s).epsilon(1e-14));
  CHECK(curve_of(thick).reference.value() == Approx(112e6 * k_s).epsilon(1e-14));
  // A thickness in the facts comes before that of the beam; up to 25 mm there is no effect.
  const Detail thin =
      read("row = \"8.3/1\"\nfacts = { thickness = \"25 mm\" }\n" + factors, plate_50).beam.detail;
  CHECK(thin.size_factor == 1.0);
  const Detail of_wall = read("row = \"8.3/1\"\n" + factors).beam.detail;  // a tube of 5 mm
  CHECK(of_wall.size_factor == 1.0);
}

TEST_CASE("the size effect lowers what resists on the beam") {
  // Fatigue strength of one range is in proportion to the reference.
  const auto factor_with = [](const std::string& lines) {
    const Project project =
        test::changed_rig({{"[fatigue]\ncategory = 100\n", "[fatigue]\n" + lines},
                           {"category = 100\nassumed", "category = 160\nassumed"}});
    const Verification verification = verify(project);
    for (const CheckResult& result : verification.checks) {
      if (result.check.id == "fatigue/4.2-/fibre+z") return result.check.safety_factor;
    }
    FAIL("no such check");
    return 0.0;
  };
  // The flange in which the fibre lies is 50 mm thick; the beam's thickest plate is none of it.
  CHECK(factor_with("row = \"8.3/1\"\n") ==
        Approx(std::pow(25.0 / 50.0, 0.2) * factor_with("category = 112\n")).epsilon(1e-12));
}

TEST_CASE("gamma_Mf by assessment and consequence, EN 1993-1-9 table 3.1") {
  const struct {
    const char *assessment, *consequence;
    double gamma_Mf;
  } rows[] = {{"damage tolerant", "low", 1.00},
              {"damage tolerant", "high", 1.15},
              {"safe life", "low", 1.15},
              {"safe life", "high", 1.35}};
  for (const auto& row : rows) {
    const FatigueInput input = read("category = 71\nassessment = \"" + std::string(row.assessment) +
                                    "\"\nconsequence = \"" + row.consequence + "\"\n" + rest);
    CHECK(input.demand.gamma_Mf == row.gamma_Mf);
    CHECK(input.gamma_Mf_source.find(row.assessment) == 0);
  }
  CHECK(read("category = 71\n" + factors).gamma_Mf_source.empty());
  const std::string safe = "category = 71\nassessment = \"safe life\"\nconsequence = \"low\"\n";
  test::check_refused(case_with(safe + factors), "gamma_Mf",
                      "follows from \"assessment\" and \"consequence\"", "either the number");
  test::check_refused(case_with("category = 71\nassessment = \"safe life\"\n" + rest), "[fatigue]",
                      "consequence", "low");
  test::check_refused(
      case_with("category = 71\nassessment = \"safe live\"\nconsequence = \"low\"\n" + rest),
      "safe live", "safe live", "safe life");
}

TEST_CASE("shear details: EN 1993-1-9 table 8.1 row 6 and table 8.5 row 8 unless said otherwise") {
  const FatigueInput usual = read("category = 71\n" + factors);
  CHECK(usual.shear.curve.reference.value() == Approx(100e6));
  CHECK(usual.throat.curve.reference.value() == Approx(80e6));
  CHECK(usual.shear.curve.kind == StressKind::shear);
  CHECK(usual.throat.curve.kind == StressKind::shear);
  const FatigueInput weak =
      read("category = 71\nshear = { kind = \"shear\", category = 80 }\n" + factors);
  CHECK(weak.shear.curve.reference.value() == Approx(80e6));
}

TEST_CASE("details of the wrong kind of stress are refused") {
  for (const std::string key : {"shear", "throat"}) {
    test::check_refused(
        case_with("category = 71\n" + key + " = { category = 80 } # here\n" + factors), "# here",
        "\"" + key + "\" wants a detail for shear stress", "kind = \"shear\"");
  }
  for (const std::string key : {"diaphragms", "flats", "flat_ends"}) {
    test::check_refused(case_with("category = 71\n" + key +
                                  " = { kind = \"shear\", category = 80 } # here\n" + factors),
                        "# here", "\"" + key + "\" wants a detail for direct stress",
                        "or a row of table 8.");
  }
  test::check_refused(
      case_with("category = 71\n" + factors +
                "[[fatigue.details]]\nname = \"rib\"\nfrom = \"0 m\"\nto = \"1 m\"\n"
                "category = 80\nkind = \"shear\" # here\n"),
      "# here", "details of stretches are for direct stress", "in [fatigue]");
}

TEST_CASE("details on stretches: where, and what is missing") {
  const std::string head = "category = 71\n" + factors + "[[fatigue.details]]\n";
  const std::string box =
      "kind = \"box\"\nwidth = \"100 mm\"\nheight = \"100 mm\"\nflange = \"6 mm\"\n"
      "web = \"6 mm\"\n";
  const FatigueInput input =
      read(head +
               "name = \"rib\"\nfrom = \"0.2 m\"\nto = \"0.4 m\"\non = \"seams\"\n"
               "row = \"8.3/1\"\n",
           box);
  REQUIRE(input.details.size() == 1);
  CHECK(input.details[0].on == DetailPlace::seams);
  CHECK(read(head + "name = \"rib\"\nfrom = \"0.2 m\"\nto = \"0.4 m\"\non = \"webs\"\n"
                    "category = 80\n",
             box)
            .details[0]
            .on == DetailPlace::webs);
  CHECK(input.details[0].from.value() == Approx(0.2));
  CHECK(input.details[0].to.value() == Approx(0.4));
  CHECK(input.details[0].detail.name == "rib");
  const std::string stretch = "from = \"0.2 m\"\nto = \"0.4 m\"\ncategory = 80\n";
  test::check_refused(case_with(head + stretch), "[[fatigue.details]]",
                      "a detail of the beam wants a name", "name = \"hub weld\"");
  test::check_refused(
      case_with(head + "name = \"rib\"\nfrom = \"0.4 m\"\nto = \"0.2 m\"\ncategory = 80\n"),
      "to = \"0.2 m\"", "the stretch ends before it begins", "exchange");
}

TEST_CASE("codes to be shown beside are known families") {
  CHECK(read("category = 71\ncodes = [\"IIW\", \"BS 7608\"]\n" + factors).codes ==
        std::vector<std::string>{"IIW", "BS 7608"});
  test::check_refused(case_with("category = 71\ncodes = [\"BS 7806\"]\n" + factors), "BS 7806",
                      "there are no curves \"BS 7806\"", "BS 7608");
}

TEST_CASE("a category of the net section stands for the hole's concentration, not beside it") {
  // EN 1993-1-9, table 8.1, row 11.
  test::check_refused(
      test::rig_text({{"levels = [\"0 mm\"]\nconcentration = \"in-plane bending\"\n",
                       "levels = [\"0 mm\"]\nconcentration = \"in-plane bending\" # of the hub\n"
                       "detail = { row = \"8.1/11\" }\n"}}),
      "# of the hub", "8.1/11 is for the stress of the net section", "");
}

TEST_CASE(
    "a hole with a category of the net section: N/A_net + M z/I_net at its edge, without K_t") {
  const Project project = test::changed_rig(
      {{"levels = [\"0 mm\"]\nconcentration = \"in-plane bending\"\n",
        "levels = [\"0 mm\"]\ndetail = { row = \"8.1/11\" }\n"},
       {"required = 2.0\n\n[fatigue]", "required = 2.0\nshear_lag = false\n\n[fatigue]"}});
  REQUIRE_FALSE(project.holes[0].concentration);
  const Verification verification = verify(project);
  // By hand: box 400 x 1000 of 50 mm plates, in both webs a hole of 145 mm on the axis and two of
  // 18 mm at +-100 mm taken out as strips.
  const double area = 0.4 * 1.0 - 0.3 * 0.9 - 0.1 * (0.145 + 2.0 * 0.018);
  const auto strip = [](double d, double z) { return 0.1 * (d * d * d / 12.0 + d * z * z); };
  const double inertia =
      (0.4 * 1.0 - 0.3 * 0.729) / 12.0 - strip(0.145, 0.0) - 2.0 * strip(0.018, 0.1);
  int looked_at = 0;
  for (const CheckResult& result : verification.checks) {
    const Check& check = result.check;
    CHECK(check.point != "hole hub edge");
    if (check.criterion != Criterion::fatigue || !check.point.starts_with("beside hole hub"))
      continue;
    const double z = check.point.ends_with("+z") ? 0.0725 : -0.0725;
    const auto stress = [&](const CutForces& cut) {
      return cut.N.value() / area + cut.M_y.value() * z / inertia;
    };
    const CheckBasis& basis = *result.basis;
    CHECK(basis.highest.value == Approx(stress(basis.cut_at_highest)).epsilon(1e-9));
    CHECK(basis.lowest.value == Approx(stress(basis.cut_at_lowest)).epsilon(1e-9));
    CHECK(basis.curves.front().reference.value() == Approx(90e6));
    // A plain part without weld: compression counts 60 % (7.2.1). The range that resists comes from
    // the reduced one.
    const double range = basis.highest.value - basis.lowest.value;
    const double reduced =
        std::max(basis.highest.value, 0.0) - 0.6 * std::min(basis.lowest.value, 0.0);
    CHECK(check.acting.value() == Approx(range).epsilon(1e-12));
    CHECK(basis.spectrum.front().cycle.range.value() == Approx(reduced).epsilon(1e-9));
    ++looked_at;
  }
  CHECK(looked_at == 4);  // above and below the hole, on both sides of the force at the hub
}

TEST_CASE("a category of the net section on a stretch with a computed concentration is refused") {
  // EN 1993-1-9, table 8.1, row 11: the concentration would count twice.
  test::check_refused(
      test::rig_text({{"[equivalent_mass]",
                       "[[fatigue.details]]\nname = \"hub\"\nfrom = \"3.2 m\"\nto = \"3.2 m\"\n"
                       "row = \"8.1/11\"\n\n[equivalent_mass]"}}),
      "[fatigue]", "that of hole \"hub\" would count twice", "detail = { row = \"8.1/11\" }");
}

TEST_CASE("a hot-spot row wants the ratio of its stress to the nominal one, and takes it") {
  const std::string detail =
      "[[fatigue.details]] # of the splice\nname = \"splice\"\nfrom = \"4.2 m\"\nto = \"4.2 m\"\n"
      "facts = { part = \"splice\", weld = \"butt\", ground = \"no\", stress = \"hot spot\" }\n";
  test::check_refused(test::rig_text({{"[equivalent_mass]", detail + "\n[equivalent_mass]"}}),
                      "# of the splice", "the structural stress at the hot spot",
                      "stress_factor = 1.3");
  // Twice the stress is twice the range: against category 100, as the beam has it, half the factor.
  const auto factor_with = [&](const char* ratio) {
    const Project project = test::changed_rig(
        {{"[equivalent_mass]", detail + "stress_factor = " + ratio + "\n\n[equivalent_mass]"}});
    const Verification verification = verify(project);
    for (const CheckResult& result : verification.checks) {
      if (result.check.id == "fatigue/4.2-/fibre+z") return result.check.safety_factor;
    }
    return 0.0;
  };
  CHECK(factor_with("2.6") == Approx(factor_with("1.3") / 2.0).epsilon(1e-12));
}

TEST_CASE("a hot spot by stresses on the surface is the one by its ratio") {
  const auto detail = [](const std::string& row, const std::string& more) {
    return "[[fatigue.details]] # of the bracket\nname = \"bracket\"\nfrom = \"4.2 m\"\n"
           "to = \"4.2 m\"\nrow = \"" +
           row + "\"\n" + more + "\n\n[equivalent_mass]";
  };
  const auto factor_with = [&](const std::string& more) {
    const Verification verification =
        verify(test::changed_rig({{"[equivalent_mass]", detail("B.1/4", more)}}));
    for (const CheckResult& result : verification.checks) {
      if (result.check.id == "fatigue/4.2-/fibre+z") return result.check.safety_factor;
    }
    return 0.0;
  };
  // (5 130 - 2 115)/3 = 140 MPa of 100.
  const std::string surface =
      "hot_spot = { near = \"130 MPa\", far = \"115 MPa\", nominal = \"100 MPa\" }";
  const double by_ratio = factor_with("stress_factor = 1.4");
  REQUIRE(by_ratio > 0.0);
  CHECK(factor_with(surface) == Approx(by_ratio).epsilon(1e-12));
  const auto refused = [&](const std::string& row, const std::string& more, const std::string& at,
                           const std::string& message, const std::string& hint) {
    test::check_refused(test::rig_text({{"[equivalent_mass]", detail(row, more)}}), at, message,
                        hint);
  };
  refused("B.1/4", surface + "\nstress_factor = 1.4", "{ near", "both say", "leave one");
  refused("8.2/6", surface, "{ near", "not judged by the stress at a hot spot", "table B.1");
  refused("B.1/4", "hot_spot = { near = \"80 MPa\", far = \"75 MPa\", nominal = \"100 MPa\" }",
          "\"80 MPa\"", "less than it", "one load");
}

}  // namespace read_fatigue_test
