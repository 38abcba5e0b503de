// The instants of a motion as comma-separated values, read back by a reader of RFC 4180 of our own:
// its numbers are those of the JSON document of the same run.

#include "boxbeam/report/motion_csv.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace motion_csv_test {

using namespace boxbeam;
using Json = nlohmann::ordered_json;

namespace {

/// Records of cells. Source: RFC 4180, 2.
std::vector<std::vector<std::string>> records_of(const std::string& text) {
  std::vector<std::vector<std::string>> records(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    std::string& cell = records.back().back();
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      cell += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      records.back().emplace_back();
    } else if (!quoted && c == '\n') {
      records.emplace_back(1, std::string());
    } else {
      cell += c;
    }
  }
  REQUIRE(records.back() == std::vector<std::string>(1));  // the last line is ended
  records.pop_back();
  for (const auto& record : records) REQUIRE(record.size() == records.front().size());
  return records;
}

/// Columns by name, as text.
std::vector<std::map<std::string, std::string>> rows_of(const std::string& text) {
  const auto records = records_of(text);
  std::vector<std::map<std::string, std::string>> rows;
  for (std::size_t r = 1; r < records.size(); ++r) {
    auto& row = rows.emplace_back();
    for (std::size_t c = 0; c < records[0].size(); ++c)
      REQUIRE(row.emplace(records[0][c], records[r][c]).second);
  }
  return rows;
}

struct Written {
  std::vector<std::map<std::string, std::string>> rows;
  Json states;
};

Written written(const std::string& path) {
  const test::TemporaryFolder folder;
  const std::string csv = (folder.path() / "motion.csv").string(),
                    json = (folder.path() / "motion.json").string();
  const test::ProgramResult run =
      test::run_program({"motion", test::project_file(path), "--csv", csv, "--json", json});
  REQUIRE(run.exit_code == 0);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& file : std::filesystem::directory_iterator(folder.path()))
    ++files;
  CHECK(files == 2);  // nothing unfinished stays
  return {rows_of(test::read_file(csv)), Json::parse(test::read_file(json))["states"]};
}

/// The cell is the number, to its last bit; empty for null.
void check_same(const std::map<std::string, std::string>& row, const std::string& column,
                const Json& value) {
  INFO(column);
  const auto cell = row.find(column);
  REQUIRE(cell != row.end());
  if (value.is_null()) {
    CHECK(cell->second.empty());
  } else {
    CHECK(std::stod(cell->second) == value.get<double>());
  }
}

}  // namespace

TEST_CASE("motion --csv in space gives the numbers of the JSON document", "[space][program]") {
  for (const char* path : {"sections/stewart-rig/rig.toml", "sections/landing-gear/gear.toml",
                           "sections/luffing-crane/crane.toml"}) {
    const Written of = written(path);
    REQUIRE(of.rows.size() == of.states.size());
    for (std::size_t k = 0; k < of.rows.size(); ++k) {
      const auto& row = of.rows[k];
      const Json& state = of.states[k];
      std::size_t columns = 1;
      check_same(row, "time [s]", state["time"]);
      for (const auto& [name, body] : state["bodies"].items()) {
        for (std::size_t i = 0; i < 3; ++i)
          check_same(row, name + " " + "xyz"[i] + " [m]", body["position"][i]);
        const auto part = [&, body_name = name](const char* of_turn) {
          return std::stod(row.at(body_name + " " + of_turn + " [1]"));
        };
        const Eigen::Quaterniond turn(part("qw"), part("qx"), part("qy"), part("qz"));
        CHECK(turn.w() >= 0.0);
        CHECK(std::abs(turn.norm() - 1.0) < 1e-12);
        for (Eigen::Index i = 0; i < 3; ++i) {
          for (Eigen::Index j = 0; j < 3; ++j) {
            const double entry =
                body["rotation"][static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
            CHECK(std::abs(turn.toRotationMatrix()(i, j) - entry) < 1e-12);
          }
        }
        columns += 7;
      }
      for (const auto& [name, joint] : state["joints"].items()) {
        if (!joint["coordinate"].is_null()) {
          const std::string in_radians = name + " coordinate [rad]";
          check_same(row, row.contains(in_radians) ? in_radians : name + " coordinate [m]",
                     joint["coordinate"]);
          ++columns;
        }
        const std::string on = name + " on " + joint["on"].get<std::string>();
        for (std::size_t i = 0; i < 3; ++i) {
          const bool unique = joint["unique"];
          check_same(row, on + " F" + "xyz"[i] + " [N]", unique ? joint["force"][i] : Json());
          check_same(row, on + " M" + "xyz"[i] + " [N m]", unique ? joint["moment"][i] : Json());
        }
        columns += 6;
      }
      CHECK(row.size() == columns);
    }
  }
}

TEST_CASE("motion --csv in the plane gives the numbers of the JSON document", "[program]") {
  for (const char* path :
       {"sections/sledge-rig/rig.toml", "sections/four-bar-rocker/rocker.toml"}) {
    const Written of = written(path);
    REQUIRE(of.rows.size() == of.states.size());
    for (std::size_t k = 0; k < of.rows.size(); ++k) {
      const auto& row = of.rows[k];
      const Json& state = of.states[k];
      std::size_t columns = 1;
      check_same(row, "time [s]", state["time"]);
      for (const auto& [name, body] : state["bodies"].items()) {
        check_same(row, name + " x [m]", body["x"]);
        check_same(row, name + " y [m]", body["y"]);
        check_same(row, name + " angle [rad]", body["angle"]);
        columns += 3;
      }
      for (const auto& [name, reaction] : state["reactions"].items()) {
        const std::string on = name + " on " + reaction["on"].get<std::string>();
        check_same(row, on + " Fx [N]", reaction["fx"]);
        check_same(row, on + " Fy [N]", reaction["fy"]);
        check_same(row, on + " M [N m]", reaction["moment"]);
        columns += 3;
      }
      CHECK(row.size() == columns);
    }
  }
}

TEST_CASE("names that RFC 4180 wants in quotes, and what is not determined", "[space]") {
  ChainMotionResult motion;
  ChainInstant& at = motion.states.emplace_back();
  at.time = 0.25;
  // A third of a turn about (1, 1, 1): x to y to z to x; its quaternion is (1, 1, 1, 1)/2.
  Eigen::Matrix3d turn;
  turn << 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  ChainBody& body = at.bodies.emplace_back();
  body.name = "arm, \"left\"";
  body.position = {1.0, 2.0, 3.0};
  body.rotation = turn;
  ChainJoint& joint = at.joints.emplace_back();
  joint.name = "pin";
  joint.on = "arm";
  joint.force = joint.moment = Eigen::Vector3d::Ones();
  joint.unique = false;
  const auto rows = rows_of(motion_csv(motion));
  REQUIRE(rows.size() == 1);
  CHECK(rows[0].at("arm, \"left\" x [m]") == "1");
  for (const char* of : {"qw", "qx", "qy", "qz"})
    CHECK(std::abs(std::stod(rows[0].at(std::string("arm, \"left\" ") + of + " [1]")) - 0.5) <
          1e-15);
  CHECK(rows[0].at("pin on arm Fx [N]").empty());
  CHECK(rows[0].at("pin on arm Mz [N m]").empty());
  CHECK(rows[0].size() == 1 + 7 + 6);
}

TEST_CASE("what has no instants to be rows is said", "[program]") {
  const test::TemporaryFolder folder;
  const std::string csv = (folder.path() / "motion.csv").string();
  const auto refused = [&](const std::vector<std::string>& arguments, const std::string& words) {
    std::vector<std::string> all{"motion"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const test::ProgramResult run = test::run_program(all);
    CHECK(run.exit_code == 2);
    INFO(run.err);
    CHECK(run.err.find(words) != std::string::npos);
    CHECK(!std::filesystem::exists(csv));
  };
  refused({test::project_file("sections/drill-truck/truck.toml"), "--csv", csv}, "--csv");
  refused({test::project_file("sections/sledge-rig/rig.toml"), "--csv", "-"}, "--csv");
  refused({test::project_file("sections/sledge-rig/rig.toml"), "--assemblies", "--csv", csv},
          "--csv");
}

}  // namespace motion_csv_test
