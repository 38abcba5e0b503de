// A case in space as a user runs it: the motion document, the report, the figures.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/project/project.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"

namespace space_case_test {

using namespace boxbeam;
using test::contains;
using Json = nlohmann::ordered_json;

namespace {

const std::string gear = "sections/landing-gear/gear.toml";
const std::string retraction = "sections/landing-gear/retraction.toml";

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

test::ProgramResult motion(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"motion", gear};
  arguments.insert(arguments.end(), more.begin(), more.end());
  test::ProgramResult result = test::run_program(arguments);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return result;
}

Json motion_document(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"--json", "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return Json::parse(motion(arguments).out);
}

Eigen::Vector3d vector(const Json& list) {
  REQUIRE(list.size() == 3);
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

/// Whether a number came through the text of the document.
bool same(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a - b).norm() <= 1e-15 * b.norm();
}

}  // namespace

TEST_CASE("motion of a case in space: keys in their order, the values of the chain", "[space]") {
  const Json document = motion_document({"--at", "0.2"});
  CHECK(keys_of(document) == std::vector<std::string>{"schema", "kind", "axes",
                                                      "degrees_of_freedom", "loops", "sticking",
                                                      "states", "hand_formulas"});
  CHECK(document["schema"] == "boxbeam.motion/1");
  CHECK(document["kind"] == "spatial");
  CHECK(document["axes"] == "world");
  CHECK(document["degrees_of_freedom"] == 4);
  REQUIRE(document["states"].size() == 1);
  const Json& at = document["states"][0];
  CHECK(keys_of(at) == std::vector<std::string>{"time", "branch", "residual", "condition", "bodies",
                                                "points", "joints"});
  CHECK(at["branch"].empty());
  CHECK(at["residual"] == 0);
  CHECK(at["condition"] == 1);

  const Project project = read_project(test::project_file(gear));
  const spatial::Mechanism& mechanism = spatial_of(project);
  const spatial::State state = spatial::Chain(mechanism).at(0.2);
  REQUIRE(at["bodies"].size() == mechanism.bodies.size());
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const Json& body = at["bodies"][mechanism.bodies[i].name];
    CHECK(keys_of(body) == std::vector<std::string>{"omega", "alpha", "position", "rotation",
                                                    "inertia_force", "inertia_moment",
                                                    "gyroscopic_moment"});
    CHECK(same(vector(body["position"]), state.bodies[i].position));
    CHECK(same(vector(body["omega"]), state.bodies[i].omega));
    CHECK(same(vector(body["alpha"]), state.bodies[i].alpha));
    for (int row = 0; row < 3; ++row) {
      CHECK(same(vector(body["rotation"][static_cast<std::size_t>(row)]),
                 state.bodies[i].R_WB.row(row)));
    }
    const spatial::InertiaLoad inertia = spatial::inertia_of(mechanism, state, i);
    CHECK(same(vector(body["inertia_force"]), inertia.force));
    CHECK(same(vector(body["inertia_moment"]), inertia.moment));
    CHECK(same(vector(body["gyroscopic_moment"]), inertia.gyroscopic));
  }
  CHECK(keys_of(at["points"]["C"]) ==
        std::vector<std::string>{"position", "velocity", "acceleration"});
  const spatial::Attachment C{spatial::body_index(mechanism, "wheel"), Eigen::Vector3d::Zero()};
  // The axle's C and the wheel's are the same to round-off; the first one is printed.
  CHECK((vector(at["points"]["C"]["acceleration"]) - spatial::acceleration_of(state, C)).norm() <
        1e-12);
  CHECK(keys_of(at["joints"]["hinge"]) == std::vector<std::string>{"on", "force", "moment", "drive",
                                                                   "friction", "coordinate", "rate",
                                                                   "unique"});
  CHECK(at["joints"]["hinge"]["friction"].is_null());
  CHECK(at["joints"]["hinge"]["on"] == "leg");
  CHECK(at["joints"]["foot"]["drive"].is_null());
}

TEST_CASE("motion --axes: document and text are in the axes of the body", "[space]") {
  const Json world = motion_document({"--at", "0.1"});
  const Json leg = motion_document({"--at", "0.1", "--axes", "leg"});
  CHECK(leg["axes"] == "leg");
  Eigen::Matrix3d R_WL;
  const Json& rotation = world["states"][0]["bodies"]["leg"]["rotation"];
  for (int i = 0; i < 3; ++i) R_WL.row(i) = vector(rotation[static_cast<std::size_t>(i)]);
  const Eigen::Vector3d a = vector(world["states"][0]["joints"]["hinge"]["force"]);
  const Eigen::Vector3d b = vector(leg["states"][0]["joints"]["hinge"]["force"]);
  CHECK((b - R_WL.transpose() * a).norm() < 1e-14 * a.norm());
  CHECK(leg["hand_formulas"] == world["hand_formulas"]);
  CHECK(contains(motion({"--at", "0.1", "--axes", "leg"}).out, "axes of body leg"));
}

TEST_CASE("motion prints the source's closed forms beside the computed values", "[space]") {
  const Json document = motion_document({"--at", "0"});
  REQUIRE(document["hand_formulas"].size() >= 3);
  for (const Json& hand : document["hand_formulas"]) {
    CHECK(keys_of(hand) == std::vector<std::string>{"name", "time", "quantity", "of", "formula",
                                                    "value", "computed", "difference", "note"});
    const Eigen::Vector3d value = vector(hand["value"]);
    const Eigen::Vector3d open = vector(hand["difference"]);
    CHECK((value - vector(hand["computed"]) - open).norm() <= 1e-12 * value.norm());
    // Only what the source prints with slips is off.
    INFO(hand["name"]);
    const bool slips = hand["name"] == "alpha_tot as printed";
    CHECK((open.norm() > 1e-3 * value.norm()) == slips);
    if (!slips) CHECK(open.norm() < 1e-10 * value.norm());
  }
  const std::string text = motion({"--at", "0"}).out;
  CHECK(contains(text, "Hand formulas of the case, world axes"));
  CHECK(contains(text, "omega_tot: omega of wheel at t = 0 s"));
  CHECK_FALSE(contains(text, " -0 "));
  CHECK_FALSE(contains(text, "nan"));
}

TEST_CASE("the report of a case in space has all six cut forces and its figures", "[space]") {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const test::ProgramResult result = test::run_program({"verify", retraction, "--out", out});
  INFO(result.err);
  REQUIRE((result.exit_code == 0 || result.exit_code == 1));
  const std::string report = test::read_file(out + "/report.txt");
  for (const char* name : {"N", "V_y", "V_z", "T", "M_y", "M_z"}) {
    CHECK(contains(report, std::string(name) + " min"));
    CHECK(contains(report, std::string(name) + " max"));
  }
  for (const char* part : {"revolute", "prismatic", "hinge", "tyre_up", "I_T [", "M_y z/I_y",
                           "M_z y/I_z", "natural frequencies [Hz]"}) {
    INFO(part);
    CHECK(contains(report, part));
  }
  for (const char* number : {" nan", "-nan", " inf ", "-inf"})
    CHECK_FALSE(contains(report, number));
  CHECK_FALSE(contains(report, "planar"));
  const Json results = Json::parse(test::read_file(out + "/results.json"));
  CHECK(keys_of(results["beam"]["stations"][0]) ==
        std::vector<std::string>{"s", "side", "N", "V_y", "V_z", "T", "M_y", "M_z"});
  for (const char* name : {"cut-forces", "mechanism", "loads", "stress", "sn"}) {
    CHECK(std::filesystem::exists(out + "/" + name + ".svg"));
    // The mechanism is drawn by the program itself.
    CHECK(std::filesystem::exists(out + "/plots/" + name + ".gp") ==
          (std::string(name) != "mechanism"));
  }
}

}  // namespace space_case_test
