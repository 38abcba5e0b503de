// Cases with values and counts that no machine has: each ends with a verdict, or with a cause, and
// never with an abort, a hang or a number that is none.
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/limits.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/report/json.hpp"
#include "boxbeam/report/remarks.hpp"
#include "boxbeam/verification/plausibility.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/refusals.hpp"

namespace extreme_cases_test {

using namespace boxbeam;
using Json = nlohmann::json;

namespace {

std::string template_text(const char* kind) {
  return test::read_file(test::project_file(std::string("sections/templates/") + kind + ".toml"));
}

Project lever(const std::vector<std::string>& set) {
  return parse_project("case.toml", template_text("planar"), set);
}

std::string refused(const std::string& text, const std::vector<std::string>& set = {}) {
  return test::refusal_of([&] { return parse_project("case.toml", text, set); });
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

double governing_factor(const Verification& verification) {
  return verification.checks.front().check.safety_factor;
}

}  // namespace

TEST_CASE("a mass beyond all meaning is refused, the largest possible one changes no held crank",
          "[extreme]") {
  const std::string words = refused(template_text("planar"), {"bodies.crank.mass=9.99e19 kg"});
  CHECK(has(words, "9.99e19 kg is too large to be meant"));
  CHECK(has(words, "at most 1e+12 kg"));
  // The crank is driven about its own centre at a constant rate: its mass loads nothing but its
  // pin, and takes no part in the vibration of the lever.
  const Verification usual = verify(lever({}));
  const Verification heavy = verify(lever({"bodies.crank.mass=9.99e11 kg"}));
  CHECK(governing_factor(heavy) == Approx(governing_factor(usual)).epsilon(1e-6));
  REQUIRE(usual.model.frequencies.size() == heavy.model.frequencies.size());
  REQUIRE_FALSE(usual.model.frequencies.empty());
  CHECK(heavy.model.frequencies.front() == Approx(usual.model.frequencies.front()).epsilon(1e-6));
}

TEST_CASE("a flywheel on the beam's end is a low frequency, not none", "[extreme]") {
  const auto with_inertia = [](const std::string& inertia) {
    return verify(lever({"bodies.load.inertia=" + inertia + " kg m^2", "model.demand=rigid"}));
  };
  const Verification usual = verify(lever({}));
  const Verification heavy = with_inertia("3e5");
  REQUIRE_FALSE(heavy.model.frequencies.empty());
  CHECK(heavy.model.frequencies.front() > 0.0);
  CHECK(heavy.model.frequencies.front() < 0.5 * usual.model.frequencies.front());
  CHECK(heavy.model.weighed.front().error > 0.1);
  // Accelerated, one of 3e12 kg m^2 presses the beam beyond all buckling loads: that is said.
  const Verification huge = with_inertia("3e12");
  CHECK(huge.verdict != Verdict::pass);
  CHECK(huge.model.reason.find("the beam buckles") != std::string::npos);
}

TEST_CASE("without mass there is no frequency, and a verdict all the same", "[extreme]") {
  for (const char* density : {"1e-6 kg/m^3", "1e-9 kg/m^3"}) {
    CAPTURE(density);
    const Project project =
        lever({"bodies.load.mass=0 kg", "bodies.load.inertia=0 kg m^2", "bodies.rod.mass=0 kg",
               "bodies.rod.uniform_rod=0.001 m", "bodies.crank.mass=0 kg",
               std::string("beam.density=") + density});
    Json results;
    try {
      results = Json::parse(results_json(project, verify(project)));
    } catch (const AnalysisError& error) {
      CHECK_FALSE(std::string(error.what()).empty());
      continue;
    }
    CHECK(results["checks"].front()["safety_factor"].get<double>() > 0.0);
  }
}

TEST_CASE("many bodies are as good as their sum in one", "[extreme]") {
  // 40 bodies of 2 kg at the end of the lever are 80 kg more of its load; all rigid together.
  std::string text = template_text("planar");
  for (int i = 0; i < 40; ++i) {
    const std::string n = std::to_string(i);
    text += "\n[bodies.extra" + n +
            "]\nmass = \"2 kg\"\ninertia = \"0.1 kg m^2\"\npoints = { P = [\"0 m\", \"0 m\"] }\n"
            "sketch = { at = [\"2 m\", \"1.3 m\"], angle = \"90 deg\" }\n[joints.extra" +
            n + "]\nkind = \"rigid\"\nconnect = [\"extra" + n + ".P\", \"load.D\"]\n";
  }
  const Verification many = verify(parse_project("case.toml", text));
  const Verification one =
      verify(lever({"bodies.load.mass=480 kg", "bodies.load.inertia=16 kg m^2"}));
  CHECK(governing_factor(many) == Approx(governing_factor(one)).epsilon(1e-8));
  REQUIRE(many.model.frequencies.size() == one.model.frequencies.size());
  for (std::size_t i = 0; i < many.model.frequencies.size(); ++i) {
    CHECK(many.model.frequencies[i] == Approx(one.model.frequencies[i]).epsilon(1e-6));
  }
}

TEST_CASE("counts have limits that the message names", "[extreme]") {
  const std::string parts = refused(template_text("flexible"), {"links.boom.parts=1000000"});
  CHECK(has(parts, "a link has 1 to " + std::to_string(limits::most_parts) + " parts"));

  std::string segments = template_text("planar");
  for (int i = 0; i < 1000; ++i)
    segments += "\n[[situations]]\nname = \"s" + std::to_string(i) + "\"\ncycles = 1\n";
  const std::string words = refused(segments, {});
  CHECK(has(words, "situations has 1000 entries"));
  CHECK(has(words, "at most " + std::to_string(limits::most_entries("situations"))));

  // Each limit is found by its key, and a key of the user's own naming by its place.
  CHECK(limits::most_entries("bodies.crank.points") == limits::most_entries("bodies.rod.points"));
  CHECK(limits::most_entries("bodies") != limits::most_entries("something else"));
  for (const limits::Count& count : limits::counts()) {
    CAPTURE(count.key);
    CHECK(limits::most_entries(count.key) == count.most);
  }
}

TEST_CASE("instants and places have a limit together that the message names", "[extreme]") {
  CHECK_NOTHROW(require_moderate_work(24576, 40));
  try {
    require_moderate_work(24576, 41);
    FAIL("nothing was said");
  } catch (const AnalysisError& error) {
    CHECK(has(error.what(), "24576 instants"));
    CHECK(has(error.what(), "41 places"));
  }
}

TEST_CASE("more cycles than there are seconds in the age of mountains are refused", "[extreme]") {
  CHECK(has(refused(template_text("planar"), {"fatigue.cycles=1e16"}), "at most 1e+15"));
  CHECK(refused(template_text("planar"), {"fatigue.cycles=1e15"}).empty());
}

TEST_CASE("what can hardly be meant is remarked, what is usual is not", "[extreme]") {
  const auto remarks = [](const std::vector<std::string>& set) {
    const Project project = lever(set);
    std::string all;
    for (const std::string& line : odd_things(project, verify(project))) all += line + "\n";
    return all;
  };
  CHECK(remarks({}).empty());
  // 1 g in the place of 400 kg, and gravity alone: a factor of some millions.
  CHECK(has(remarks({"beam.density=1e-3 kg/m^3", "bodies.load.mass=1e-6 kg",
                     "bodies.load.inertia=1e-9 kg m^2", "bodies.rod.mass=1e-3 kg"}),
            "next to nothing loads the beam"));
  CHECK(has(remarks({"beam.density=78500 kg/m^3"}), "the density of the beam"));
  CHECK(has(remarks({"bodies.load.inertia=3e12 kg m^2", "model.demand=rigid"}),
            "more than any solid bears"));
  CHECK(has(remarks({"strength.gamma_M1=0.1"}), "odd: gamma_M1 = 0.1 of [strength] is below 1"));
  CHECK(has(remarks({"fatigue.required=0.5"}), "odd: required = 0.5 of [fatigue] is below 1"));
}

TEST_CASE("a pipe or a device in the place of a table is refused at once", "[extreme]") {
  const test::TemporaryFolder folder;
  const std::string pipe = (folder.path() / "pipe.csv").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const std::string press =
      test::read_file(test::project_file("sections/slider-crank-press/press.toml"));
  for (const std::string& table : {pipe, std::string("/dev/zero"), std::string("/dev/stdin")}) {
    CAPTURE(table);
    const std::string file = folder.write("case.toml", press);
    const test::ProgramResult result =
        test::run_program({"validate", file, "--set", "forces.press.law.file=\"" + table + "\""});
    CHECK(result.exit_code == 2);
    CHECK((has(result.err, "a pipe or a device") || has(result.err, "there is no such file")));
  }
}

TEST_CASE("a pipe that nobody writes is no history and no table of comparison", "[extreme]") {
  const test::TemporaryFolder folder;
  const std::string pipe = (folder.path() / "pipe.csv").string();
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const std::string press = test::project_file("sections/slider-crank-press/press.toml");
  for (const std::string& file : {pipe, std::string("/dev/zero")}) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"compare", press, file}, {"fatigue", file, "--detail", "100"}}) {
      CAPTURE(file, arguments.front());
      const test::ProgramResult result = test::run_program(arguments);
      CHECK(result.exit_code == 2);
      CHECK(has(result.err, "this is a pipe or a device, no file"));
    }
  }
  // Named in a case it is refused as what it is.
  const std::string of_files = folder.write(
      "loads.toml", test::read_file(test::project_file("sections/templates/loads.toml")) +
                        "\n[files.run]\npath = \"pipe.csv\"\n[loads.more]\nstation = \"0 m\"\n"
                        "file = \"run\"\ncolumns = { F_z = \"F\" }\n");
  const test::ProgramResult result = test::run_program({"validate", of_files});
  CHECK(result.exit_code == 2);
  INFO(result.err);
  CHECK(has(result.err, "pipe.csv: this is a pipe or a device, no file"));
}

TEST_CASE("a thousand wrong names are answered in one go", "[extreme]") {
  const test::TemporaryFolder folder;
  std::string rows = "result,published,tolerance\n";
  for (int i = 0; i < 1000; ++i)
    rows += "governing.fatigue.safety_facter" + std::to_string(i) + ",1,1 %\n";
  const std::string table = folder.write("wrong.csv", rows);
  const test::ProgramResult result =
      test::run_program({"compare", test::project_file("sections/templates/planar.toml"), table});
  CHECK(result.exit_code == 2);
  CHECK(has(result.err, "did you mean governing.fatigue.safety_factor?"));
  CHECK(has(result.err, "1000 errors"));
}

TEST_CASE("factors on the command line are numbers", "[extreme]") {
  const test::TemporaryFolder folder;
  const std::string history = folder.write("history.csv", "sigma [MPa]\n-20\n110\n-35\n160\n-20\n");
  for (const char* option : {"--gamma-Mf", "--gamma-Ff", "--repetitions"}) {
    for (const char* value : {"nan", "inf", "-1", "0", "1e300", "1,35", ""}) {
      CAPTURE(option, value);
      const test::ProgramResult result =
          test::run_program({"fatigue", history, "--detail", "71", option, value});
      CHECK(result.exit_code == 2);
    }
  }
  CHECK(test::run_program({"fatigue", history, "--detail", "71", "--gamma-Mf", "1.35"}).exit_code ==
        0);
}

}  // namespace extreme_cases_test
