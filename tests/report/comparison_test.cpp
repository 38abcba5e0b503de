// Published values beside the program's: keys, units, tolerances, reasons, and the shipped tables.

#include "boxbeam/report/comparison.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/json.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"
#include "support/rig.hpp"

namespace comparison_test {

using namespace boxbeam;
using test::contains;

namespace {

const std::string header = "result,published,tolerance,reason,source\n";

/// A case and its verification.
struct Verified {
  explicit Verified(const std::string& path)
      : project(read_project(test::project_file(path))), verification(verify(project)) {}
  Project project;
  Verification verification;
};

const Verified& rig() {
  static const Verified verified("sections/sledge-rig/rig.toml");
  return verified;
}

const Verified& published() {
  static const Verified verified("sections/sledge-rig/published.toml");
  return verified;
}

const Verified& gear() {
  static const Verified verified("sections/landing-gear/gear.toml");
  return verified;
}

Comparison compared(const Verified& with, const PublishedValues& values) {
  return compare(with.project, with.verification, values, [&](const std::vector<double>& times) {
    return any_motion_of(with.project, times);
  });
}

Comparison compared(const Verified& with, const std::string& rows) {
  const test::TemporaryFolder folder;
  return compared(with, read_published(folder.write("published.csv", header + rows)));
}

ComparedValue one(const Verified& with, const std::string& row) {
  const Comparison comparison = compared(with, row + "\n");
  REQUIRE(comparison.rows.size() == 1);
  return comparison.rows.front();
}

std::vector<Problem> problems_in(const Verified& with, const std::string& rows) {
  try {
    compared(with, rows);
  } catch (const InputError& error) {
    return error.problems();
  }
  return {};
}

Comparison shipped(const Verified& with, const std::string& table) {
  return compared(with, read_published(test::project_file(table)));
}

std::set<std::string> keys_of(const Comparison& comparison, Agreement agreement) {
  std::set<std::string> keys;
  for (const ComparedValue& row : comparison.rows) {
    if (row.agreement == agreement) keys.insert(row.key);
  }
  return keys;
}

}  // namespace

TEST_CASE("a key is a path into results.json", "[compare]") {
  const auto json = nlohmann::json::parse(results_json(rig().project, rig().verification));
  const auto ours = [](const std::string& key, const std::string& unit) {
    return one(rig(), key + ",1 " + unit + ",1 %,,").ours;
  };
  CHECK(ours("beam.mass", "kg") == json["beam"]["mass"]);
  CHECK(ours("governing.fatigue.safety_factor", "") ==
        json["governing"]["fatigue"]["safety_factor"]);
  CHECK(ours("checks[0].acting", "Pa") == json["checks"][0]["acting"]);
  const auto stress = std::find_if(json["checks"].begin() + 1, json["checks"].end(),
                                   [](const auto& check) { return check["unit"] == "Pa"; });
  REQUIRE(stress != json["checks"].end());
  const std::string id = (*stress)["id"];
  CHECK(ours("checks[" + id + "].acting", "Pa") == (*stress)["acting"]);
  CHECK(ours("model.frequencies[1]", "Hz") == json["model"]["frequencies"][1]);
  CHECK(ours("mechanism.gravity.y", "m/s^2") == json["mechanism"]["gravity"][1]);
  // Both sides of a jump, and a station without one.
  for (const auto& station : json["beam"]["stations"]) {
    const std::string side = station["side"] == "0" ? "" : station["side"];
    if (station["s"] != 3.2 && station["s"] != 1.5) continue;
    const std::string key = (station["s"] == 3.2 ? "stations[3.2" : "stations[1.5") + side + "].";
    CHECK(ours("beam." + key + "M.max", "N m") == station["M"][1]);
    CHECK(ours(key + "N.min", "N") == station["N"][0]);
  }
  for (const auto& instant : json["critical_instants"]) {
    if (instant["quantity"] == "M" && instant["value"] > 0.0) {
      CHECK(ours("critical_instants[M@1.0714].value", "N m") == instant["value"]);
    }
  }
}

TEST_CASE("a key is a path into the motion at an instant, by the instant as it is written",
          "[compare]") {
  const Comparison comparison =
      compared(rig(),
               "motion[0].points.blade.A.x,0.5 m,1e-9 m,,\n"
               "motion[1.0714285714285714].points.blade.A.x,0.25 m,1e-9 m,,\n"
               "motion[0.0].points.blade.A.vx,1.0996 m/s,1e-4 m/s,,\n"
               "motion.degrees_of_freedom,1,0,,\n");
  // The driver: 0.5 + 0.25 sin(2 pi 0.7 t), its velocity 0.25 x 2 pi 0.7 = 1.0996 m/s.
  CHECK(comparison.count(Agreement::agrees) == 4);
  CHECK(comparison.rows[1].key == "motion[1.0714285714285714].points.blade.A.x");
  // In space vectors have components.
  CHECK(one(gear(), "motion[0].bodies.climb.omega.x,0 rad/s,1e-12 rad/s,,").agreement ==
        Agreement::agrees);
}

TEST_CASE("elastic links are compared by their statics and frequencies", "[compare][unsanitized]") {
  const Verified truck("sections/drill-truck/truck.toml");
  const auto json = nlohmann::json::parse(motion_json(flexible_motion_of(truck.project)));
  CHECK(one(truck, "motion.frequencies[0],1 Hz,1 %,,").ours == json["frequencies"][0]);
  const std::string joint = json["static"]["joints"].begin().key();
  CHECK(one(truck, "motion.static.joints." + joint + ".fx,1 N,1 %,,").ours ==
        json["static"]["joints"][joint]["fx"]);
  CHECK(one(truck, "motion.harmonic.joints." + joint + ".fy.im,1 N,1 %,,").ours ==
        json["harmonic"]["joints"][joint]["fy"][1]);
  const auto problems = problems_in(truck, "motion[0].static.points.boom.lift.x,1 m,1 %,,\n");
  REQUIRE(problems.size() == 1);
  CHECK(contains(problems[0].message, "no instants to choose"));
}

TEST_CASE("a key that is no result is refused with the nearest one", "[compare][bad_input]") {
  struct Row {
    const char* row;
    int column;
    const char* message;
    const char* hint;
  };
  const Row rows[] = {
      {"beam.masss,5 t,1 %,,", 1, "no result \"beam.masss\"", "did you mean beam.mass?"},
      {"stations[3.3-].M.max,5 kN m,1 %,,", 1, "no result", "beam.stations[3.2-].M.max"},
      {"stations[3.2-].M.mx,5 kN m,1 %,,", 1, "no result", "beam.stations[3.2-].M.max"},
      {"governing.fatigue,1.69,1 %,,", 1, "no result", "Behind \"governing.fatigue\" stands"},
      {"verdict,1,1 %,,", 1, "no result \"verdict\"", "keys are paths"},
      {"motion[1.071].bodis.beam.x,1 m,1 %,,", 1, "no result", "motion[1.071].bodies.beam.x"},
      {"motion[noon].bodies.beam.x,1 m,1 %,,", 1, "\"noon\" is no instant", "motion[1.071]"},
      {"motion[1e10].bodies.beam.x,1 m,1 %,,", 1, "is no instant", "seconds"},
      {"beam.mass,5 kN,1 %,,", 11, "beam.mass is a mass, but \"5 kN\" is a force", "kg"},
      {"beam.mass,5000,1 %,,", 11, "is a number without unit", "kg"},
      {"governing.fatigue.required,2 m,1 %,,", 28, "is a length", "without unit"},
      {"motion[0].bodies.beam.omega,1 Hz,1 %,,", 29, "an angular frequency", "rad/s"},
  };
  for (const Row& row : rows) {
    INFO(row.row);
    const std::vector<Problem> problems = problems_in(rig(), std::string(row.row) + "\n");
    REQUIRE(problems.size() == 1);
    CHECK(problems[0].line == 2);
    CHECK(problems[0].column == row.column);
    INFO(problems[0].message);
    CHECK(contains(problems[0].message, row.message));
    INFO(problems[0].hint);
    CHECK(contains(problems[0].hint, row.hint));
  }
  // All at once.
  CHECK(problems_in(rig(), "beam.masss,5 t,1 %,,\nbeam.mass,5 t,1 %,,\nbeam.length,5 t,1 %,,\n")
            .size() == 2);
}

TEST_CASE("a value agrees up to its tolerance, beyond it a reason explains", "[compare]") {
  // The beam is 6.2 m long.
  const auto status = [](const std::string& value, const std::string& tolerance,
                         const std::string& reason) {
    return one(rig(), "beam.length," + value + "," + tolerance + "," + reason + ",").agreement;
  };
  CHECK(status("6.2 m", "0 m", "") == Agreement::agrees);
  CHECK(status("6150 mm", "50 mm", "") == Agreement::agrees);
  CHECK(status("6250 mm", "5 cm", "") == Agreement::agrees);
  CHECK(status("6149.99 mm", "50 mm", "") == Agreement::differs);
  CHECK(status("6149.99 mm", "50 mm", "cut too short") == Agreement::explained);
  CHECK(status("6150 mm", "50 mm", "not needed") == Agreement::agrees);
  // A part is one of the published value: 0.062/6.2 is 1 %, 0.062/6.138 more.
  CHECK(status("6.138 m", "1.02 %", "") == Agreement::agrees);
  CHECK(status("6.138 m", "1 %", "") == Agreement::differs);
  CHECK(status("6.262 m", "1 %", "") == Agreement::agrees);
  // The size of a negative value counts.
  CHECK(one(rig(), "mechanism.gravity.y,-9.81 m/s^2,0.1 %,,").agreement == Agreement::agrees);
  const ComparedValue row = one(rig(), "beam.length,6.15 m,1 %,,");
  CHECK(row.difference == Approx(0.05));
  CHECK(row.tolerance == Approx(0.0615));
  CHECK(row.unit == "m");
}

TEST_CASE("a comparison passes unless something differs without a reason", "[compare]") {
  const std::string agrees = "beam.length,6.2 m,1 %,,\n";
  const std::string explained = "beam.length,6.5 m,1 %,another beam,one\n";
  const std::string differs = "beam.length,6.6 m,1 %,,two\n";
  CHECK(compared(rig(), agrees + explained).passes());
  CHECK_FALSE(compared(rig(), agrees + explained + differs).passes());
}

TEST_CASE("the numbers of the thesis: sound ones agree, wrong ones are those known to be wrong",
          "[compare][validation]") {
  const Comparison comparison = shipped(published(), "sections/sledge-rig/thesis.csv");
  CHECK(comparison.count(Agreement::differs) == 0);
  std::set<std::string> wrong{
      // Body 5: a misprint, and a row shifted by one column.
      "motion[1.428].bodies.5.vx", "motion[1.428].bodies.5.omega", "motion[2.142].bodies.5.vx",
      "motion[2.142].bodies.5.vy", "motion[2.142].bodies.5.omega",
      // Accelerations at 1.428 s: the signs of the other side; what hardly changes there agrees.
      "motion[1.428].bodies.1.ax", "motion[1.428].bodies.1.alpha", "motion[1.428].bodies.2.ax",
      "motion[1.428].bodies.2.alpha", "motion[1.428].bodies.3.ax", "motion[1.428].bodies.4.ax",
      "motion[1.428].bodies.4.ay", "motion[1.428].bodies.4.alpha", "motion[1.428].bodies.5.ax",
      "motion[1.428].bodies.5.ay", "motion[1.428].bodies.5.alpha", "motion[1.428].bodies.6.ax",
      // Loads across, which rest on accelerations that are off by up to 7 %, and one left out.
      "motion[1.071].newton_chain.steps.2.fy", "motion[1.071].newton_chain.steps.2.moment",
      "motion[1.071].newton_chain.steps.1.fy", "motion[1.071].newton_chain.steps.4.fy",
      "motion[1.071].newton_chain.steps.5.fy", "motion[1.071].newton_chain.steps.5.moment",
      "loads[O@1.072].world.x", "loads[O@1.072].world.y",
      // The beam and the concentration.
      "sections[6.2-].area", "beam.parts[O-B].mass", "beam.parts[C-O].mass",
      "beam.parts[C-O].centre_from_end", "concentrations[hub].factor"};
  // The rows at 0.714 s are wrong throughout; the sliders' zeros stay zeros.
  for (const char* body : {"1", "2", "4", "5"}) {
    for (const char* part : {"vx", "vy", "omega", "ax", "ay", "alpha"}) {
      wrong.insert(std::string("motion[0.714].bodies.") + body + "." + part);
    }
  }
  for (const char* part : {"3.vx", "3.ax", "6.vx", "6.ax"}) {
    wrong.insert(std::string("motion[0.714].bodies.") + part);
  }
  CHECK(keys_of(comparison, Agreement::explained) == wrong);
  // Positions: 108 numbers, all right to 5e-5.
  std::size_t positions = 0;
  for (const ComparedValue& row : comparison.rows) {
    if (row.published.source != "E.1") continue;
    ++positions;
    CHECK(row.agreement == Agreement::agrees);
    CHECK(row.tolerance == 5e-5);
  }
  CHECK(positions == 108);
}

TEST_CASE("the thesis beside the rigorous answer: sound are its section and what agrees by chance",
          "[compare][validation]") {
  const Comparison comparison = shipped(rig(), "sections/sledge-rig/thesis-rigorous.csv");
  CHECK(comparison.count(Agreement::differs) == 0);
  CHECK(keys_of(comparison, Agreement::agrees) ==
        std::set<std::string>{"freedom.by_rank", "motion[1.071].reactions.C.fx",
                              "sections[3.2-].area_of_holes", "sections[3.2-].net.area",
                              "sections[3.2-].I_y", "sections[3.2-].levels[thesis B].first_moment",
                              "governing.yield.resisting"});
}

TEST_CASE("the landing gear's source: right are omega, v_C and one order of the product",
          "[compare][validation]") {
  const Comparison comparison = shipped(gear(), "sections/landing-gear/published.csv");
  CHECK(comparison.count(Agreement::differs) == 0);
  for (const ComparedValue& row : comparison.rows) {
    INFO(row.key << ", " << row.published.source);
    const std::string& source = row.published.source;
    if (source == "alpha_tot" || source == "w_i x w_w") {
      CHECK(row.agreement == Agreement::explained);
    } else if (source != "1.3 (product)") {
      CHECK(row.agreement == Agreement::agrees);
    }
  }
  CHECK(comparison.count(Agreement::agrees) == 3 + 3 + 9 + 3);
  CHECK(comparison.count(Agreement::explained) == 3 + 1 + 6);
}

TEST_CASE("the comparison's document and its JSON hold every row", "[compare]") {
  const Comparison comparison = compared(rig(),
                                         "beam.length,6.2 m,1 %,,drawing\n"
                                         "beam.mass,5 t,1 %,with paint,weighed\n"
                                         "beam.mass,5.5 t,1 %,with paint,guessed\n"
                                         "governing.fatigue.required,3,1 %,,\n");
  const report::Document document = comparison_document(rig().project, comparison);
  CHECK(document.verdict == "DIFFERS");
  CHECK(document.mark == report::Mark::fails);
  std::size_t rows = 0, reasons = 0, failing = 0;
  for (const report::Block& block : document.chapters.at(0).blocks) {
    if (const auto* table = std::get_if<report::Table>(&block)) {
      rows += table->rows.size();
      for (const auto& row : table->rows) CHECK(row.size() == table->header.size());
      failing += table->marks.size();
    }
    if (const auto* list = std::get_if<report::Bullets>(&block)) reasons += list->items.size();
  }
  CHECK(rows == 4);
  CHECK(failing == 1);
  CHECK(reasons == 1);  // said once for both

  const auto json = nlohmann::json::parse(comparison_json(rig().project, comparison));
  CHECK(json["schema"] == "boxbeam.comparison/1");
  CHECK(json["agree"] == 1);
  CHECK(json["explained"] == 2);
  CHECK(json["differ"] == 1);
  REQUIRE(json["rows"].size() == 4);
  CHECK(json["rows"][1]["result"] == "beam.mass");
  CHECK(json["rows"][1]["published"] == Approx(5000.0));
  CHECK(json["rows"][1]["status"] == "differs, explained");
  CHECK(json["rows"][1]["line"] == 3);
}

TEST_CASE("the motion is asked for where a key wants it, once for all instants", "[compare]") {
  std::vector<std::vector<double>> asked;
  const auto motion = [&](const std::vector<double>& times) {
    asked.push_back(times);
    return any_motion_of(rig().project, times);
  };
  const test::TemporaryFolder folder;
  const auto compared_rows = [&](const std::string& rows) {
    compare(rig().project, rig().verification,
            read_published(folder.write("published.csv", header + rows)), motion);
  };
  compared_rows("beam.length,6.2 m,1 %,,\n");
  CHECK(asked.empty());
  compared_rows(
      "motion[0.5].bodies.beam.x,0 m,9 m,,\nmotion[0].bodies.beam.x,0 m,9 m,,\n"
      "motion[0.5].bodies.beam.y,0 m,9 m,,\n");
  CHECK(asked == std::vector<std::vector<double>>{{0.5, 0.0}});
}

namespace {

/// The tables of a comparison by their captions.
std::map<std::string, report::Table> tables_of(const Comparison& comparison) {
  std::map<std::string, report::Table> tables;
  const report::Document document = comparison_document(rig().project, comparison);
  for (const report::Block& block : document.chapters.at(0).blocks) {
    if (const auto* table = std::get_if<report::Table>(&block)) tables[table->caption] = *table;
  }
  return tables;
}

/// What stands in a row of a table under a title.
std::string cell_of(const report::Table& table, std::size_t row, const std::string& title) {
  const auto found = std::find(table.header.begin(), table.header.end(), title);
  REQUIRE(found != table.header.end());
  return table.rows.at(row).at(static_cast<std::size_t>(found - table.header.begin())).text;
}

const std::string within = "Within the tolerance";
const std::string explained = "Beyond the tolerance, with a reason";
const std::string unexplained = "Beyond the tolerance, without a reason";

}  // namespace

TEST_CASE("a comparison shows reasons where something differs, and no empty columns", "[compare]") {
  auto tables = tables_of(compared(rig(),
                                   "beam.length,6.2 m,1 %,not needed,\n"
                                   "beam.mass,7 t,1 %,another beam,\n"
                                   "governing.fatigue.required,3,1 %,,a table\n"));
  using Header = std::vector<std::string>;
  CHECK(tables[within].header ==
        Header{"result", "published", "ours", "difference", "within", "unit"});
  CHECK(tables[explained].header ==
        Header{"result", "published", "ours", "difference", "within", "unit", "why"});
  CHECK(cell_of(tables[explained], 0, "why") == "1");
  CHECK(tables[unexplained].header ==
        Header{"result", "published", "ours", "difference", "within", "source"});
  for (const auto& [caption, table] : tables) {
    for (const auto& row : table.rows) CHECK(row.size() == table.header.size());
  }
}

TEST_CASE("a difference is in per cent up to twice the value, then in its unit", "[compare]") {
  // The beam is 6.2 m long.
  const auto difference = [](const std::string& published) {
    auto tables = tables_of(compared(rig(), "beam.length," + published + ",1 %,,\n"));
    return cell_of(tables[unexplained], 0, "difference");
  };
  CHECK(difference("3.1 m") == "+100 %");
  CHECK(difference("-6.2 m") == "+200 %");
  CHECK(difference("2.07 m") == "+200 %");  // 199.5 %
  CHECK(difference("2 m") == "+4.2 m");
  CHECK(difference("12.4 m") == "-50 %");
  CHECK(difference("1 mm") == "+6199 mm");
}

TEST_CASE("of a comparison only many values that agree are folded", "[compare]") {
  std::string rows;
  for (int i = 0; i < 40; ++i) {
    const std::string source = std::to_string(i);
    rows += "beam.length,6.2 m,1 %,," + source + "\n";
    rows += "beam.length,7 m,1 %,why,a" + source + "\n";
    rows += "beam.length,8 m,1 %,,b" + source + "\n";
  }
  auto tables = tables_of(compared(rig(), rows));
  CHECK(tables[within].folded);
  CHECK_FALSE(tables[explained].folded);
  CHECK_FALSE(tables[unexplained].folded);
  CHECK_FALSE(tables_of(compared(rig(), "beam.length,6.2 m,1 %,,\n"))[within].folded);
}

TEST_CASE("keys stay whole in the shipped comparisons", "[compare]") {
  const auto check_keys = [](const Verified& with, const std::string& table) {
    const Comparison comparison = shipped(with, table);
    const std::string text = comparison_text(with.project, comparison);
    for (const ComparedValue& row : comparison.rows) {
      INFO(row.key);
      CHECK(contains(text, row.key));
    }
  };
  check_keys(published(), "sections/sledge-rig/thesis.csv");
  check_keys(rig(), "sections/sledge-rig/thesis-rigorous.csv");
  check_keys(gear(), "sections/landing-gear/published.csv");
}

TEST_CASE("a comparison of one value is said in the singular", "[compare]") {
  const std::string text =
      comparison_text(rig().project, compared(rig(), "beam.length,6.2 m,1 %,,\n"));
  CHECK(contains(text, "1 value: 1 within"));
  CHECK_FALSE(contains(text, "1 values"));
}

}  // namespace comparison_test
