// Loads from a table may have been measured on the running machine, whose vibration they contain.

#include "boxbeam/report/summary.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/verify.hpp"
#include "support/changed_rig.hpp"
#include "support/refusals.hpp"

namespace measured_loads_test {

using namespace boxbeam;
using test::contains;

namespace {

/// The slender rig, whose beam vibrates, at 0.8 Hz, with further lines, beside a table of a small
/// force that repeats with its exciter.
Project slender_rig(const std::string& more) {
  const test::TemporaryFolder folder;
  folder.write("gust.csv", "time [s],force [N]\n0,0\n0.6,1\n1.25,0\n");
  const std::string text = test::read_file(test::project_file("sections/sledge-rig/slender.toml"));
  return parse_project((folder.path() / "slender.toml").string(), text + more,
                       {"drivers.exciter.frequency=0.8 Hz"});
}

const std::string gust =
    "[forces.gust]\nkind = \"force\"\npoint = \"beam.B\"\ndirection = \"90 deg\"\n"
    "law = { kind = \"table\", file = \"gust.csv\", periodic = true }\n";

}  // namespace

TEST_CASE("loads that are measured keep the bodies rigid, and the model says why") {
  const ModelChoice vibrating = choose_model(slender_rig(""));
  REQUIRE(vibrating.chosen.level == ModelLevel::modal);
  const Project project = slender_rig("\n[model]\nloads = \"measured\"\n");
  CHECK(project.model.measured_loads);
  const Verification verification = verify(project);
  CHECK(verification.model.chosen.level == ModelLevel::rigid);
  CHECK(verification.model.reason.starts_with(
      "rigid bodies; the loads are measured, they contain the vibration"));
  const std::string terminal = summary(project, verification).text;
  CHECK(contains(terminal.substr(0, terminal.find("criterion")),
                 "the loads are measured, they contain the vibration"));
}

TEST_CASE("an elastic model under loads from a table says that they may have been measured") {
  const ModelChoice choice = choose_model(slender_rig("\n" + gust));
  CHECK(choice.chosen.level == ModelLevel::modal);
  CHECK(contains(choice.reason, "load gust comes from a table"));
  CHECK(contains(choice.reason, "loads = \"measured\""));
  CHECK_FALSE(contains(choose_model(slender_rig("")).reason, "table"));
}

// A table bends at its points: there the acceleration of the bent beam is no function.
TEST_CASE("under loads from a table it is not known what the bent beam leaves unbalanced") {
  CHECK(contains(run_by_chosen_model(slender_rig("\n" + gust)).model.reason,
                 "on the bent beam is not known: its loads jump or bend at points of a table"));
  CHECK(contains(run_by_chosen_model(slender_rig("")).model.reason, "of the stress is unbalanced"));
}

TEST_CASE("measured loads and an elastic model contradict each other") {
  const std::string text = test::read_file(test::project_file("sections/sledge-rig/slender.toml"));
  test::check_refused(text + "\n[model]\nloads = \"measured\"\ndemand = \"flexible\" # here\n",
                      "# here", "contain the vibration", "\"rigid\"");
  test::check_refused(text + "\n[model]\nloads = \"recorded\" # here\n", "# here", "recorded",
                      "measured");
}

}  // namespace measured_loads_test
