// The motion command on a case of elastic links as a user runs it: document and tables.

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "boxbeam/mechanism/flexible/response.hpp"
#include "boxbeam/project/project.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace elastic_motion_test {

using namespace boxbeam;
using Json = nlohmann::ordered_json;

namespace {

const std::string truck = "sections/drill-truck/truck.toml";

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

std::string motion(std::vector<std::string> more) {
  more.insert(more.begin(), {"motion", truck});
  const test::ProgramResult result = test::run_program(more);
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  return result.out;
}

}  // namespace

TEST_CASE("motion of elastic links: keys in their order, the values of the response",
          "[flexible]") {
  const Json document = Json::parse(motion({"--json", "-"}));
  CHECK(keys_of(document) == std::vector<std::string>{"schema", "kind", "degrees_of_freedom",
                                                      "frequencies", "static", "harmonic",
                                                      "discretisation"});
  CHECK(document["schema"] == "boxbeam.motion/1");
  CHECK(document["kind"] == "flexible");
  REQUIRE(document["frequencies"].size() == 8);
  CHECK(std::is_sorted(document["frequencies"].begin(), document["frequencies"].end()));
  CHECK(document["discretisation"]["frequencies"].size() == 8);
  CHECK(document["harmonic"]["frequency"] == 25.0);

  const Project project = read_project(test::project_file(truck));
  const flexible::Mechanism& mechanism = flexible_of(project);
  const flexible::Structure structure = flexible::structure_of(mechanism);
  const flexible::Response response = flexible::response_of(structure);
  REQUIRE(document["static"]["joints"].size() == mechanism.joints.size());
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const flexible::Joint& joint = mechanism.joints[j];
    INFO(joint.name);
    const Json& still = document["static"]["joints"][joint.name];
    const Json& moving = document["harmonic"]["joints"][joint.name];
    const bool on_b = joint.b.link == project.beam_body;  // the boom feels it
    const int on = on_b ? joint.b.link : joint.a.link;
    CHECK(still["on"] == mechanism.links[static_cast<std::size_t>(on)].name);
    CHECK(moving["on"] == still["on"]);
    const double sign = on_b ? -1.0 : 1.0;
    const Eigen::Vector3d constant = sign * flexible::joint_force(structure, j, response.constant);
    const Eigen::Vector3cd amplitude =
        sign * flexible::joint_force(structure, j, response.harmonic);
    CHECK(still["fx"].get<double>() == Approx(constant.x()).margin(1e-6));
    CHECK(still["fy"].get<double>() == Approx(constant.y()).margin(1e-6));
    CHECK(still["magnitude"].get<double>() == Approx(std::hypot(constant.x(), constant.y())));
    CHECK(moving["fx"][0].get<double>() == Approx(amplitude.x().real()).margin(1e-6));
    CHECK(moving["fx"][1].get<double>() == Approx(amplitude.x().imag()).margin(1e-6));
    CHECK(moving["fy"][0].get<double>() == Approx(amplitude.y().real()).margin(1e-6));
    // Without damping all is in phase: the longest vector is that of the phasors.
    CHECK(moving["magnitude"].get<double>() ==
          Approx(std::hypot(std::abs(amplitude.x()), std::abs(amplitude.y()))));
    CHECK(document["discretisation"]["harmonic"]["joints"][joint.name]["error"].get<double>() >=
          0.0);
  }
  const Json& end = document["static"]["points"]["feed.end"];
  CHECK(end["y"].get<double>() < 0.0);  // the feed's far end sinks
  CHECK(keys_of(end) == std::vector<std::string>{"x", "y"});
}

TEST_CASE("motion of elastic links: coordinates as the source counts them", "[flexible]") {
  const auto count = [](const std::vector<std::string>& set) {
    std::vector<std::string> arguments{"--json", "-", "--set", "model.division=equal"};
    for (const std::string& key : set) arguments.insert(arguments.end(), {"--set", key});
    return Json::parse(motion(arguments))["degrees_of_freedom"].get<int>();
  };
  // Rigid 3; bending 3 + 2 n; axial 3 + n; full 3 + 3 n.
  CHECK(count({}) == 3 + (3 + 16) + (3 + 16) + (3 + 4) + (3 + 20) + (3 + 4));
  CHECK(count({"links.feed.kind=full", "links.lift.kind=rigid"}) ==
        3 + (3 + 16) + (3 + 16) + 3 + (3 + 30) + (3 + 4));
}

TEST_CASE("motion of elastic links without harmonic loads has no such part", "[flexible]") {
  const test::TemporaryFolder folder;
  std::string text = test::read_file(test::project_file(truck));
  for (const std::string part :
       {"[motion]\nfrequency = \"25 Hz\"\n", "amplitude_force = [\"4 kN\", \"1.5 kN\"]\n",
        "amplitude_moment = \"500 N m\"\n"}) {
    REQUIRE(text.find(part) != std::string::npos);
    text.erase(text.find(part), part.size());
  }
  const std::string file = folder.write("still.toml", text);
  const test::ProgramResult json = test::run_program({"motion", file, "--json", "-"});
  REQUIRE(json.exit_code == 0);
  const Json document = Json::parse(json.out);
  CHECK_FALSE(document.contains("harmonic"));
  CHECK_FALSE(document["discretisation"].contains("harmonic"));
  CHECK(document["static"] == Json::parse(motion({"--json", "-"}))["static"]);
  CHECK(test::run_program({"motion", file}).out.find("Harmonic") == std::string::npos);
}

TEST_CASE("motion of elastic links as tables", "[flexible]") {
  const std::string text = motion({});
  for (const char* said : {"45 rigid finite elements, 88 degrees of freedom", "Natural frequencies",
                           "stated error", "Harmonic loads at 25 Hz", "(order ", "round-off"}) {
    INFO(said);
    CHECK(text.find(said) != std::string::npos);
  }
}

}  // namespace elastic_motion_test
