// boxbeam init: the cases that it writes run as they are.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.hpp"
#include "support/program.hpp"

namespace init_command_test {

namespace fs = std::filesystem;

namespace {

std::string template_of(const std::string& kind) {
  return test::read_file(test::project_file("sections/templates/" + kind + ".toml"));
}

std::string changed(std::string text, const std::string& find, const std::string& instead) {
  const std::size_t at = text.find(find);
  REQUIRE(at != std::string::npos);
  return text.replace(at, find.size(), instead);
}

/// Without the "# " of the lines that begin with `first`, to the end of the paragraph.
std::string uncommented(std::string text, const std::string& first) {
  std::size_t at = text.find("\n" + first);
  REQUIRE(at != std::string::npos);
  for (++at; text.compare(at, 2, "# ") == 0; at = text.find('\n', at) + 1) text.erase(at, 2);
  return text;
}

}  // namespace

TEST_CASE("init: each kind of case runs as it is and passes", "[init]") {
  for (const std::string kind : {"planar", "spatial", "flexible", "static", "loads"}) {
    INFO(kind);
    const test::TemporaryFolder folder;
    const test::ProgramResult written = test::run_program({"init", kind, "my.toml"}, folder.path());
    CHECK(written.exit_code == 0);
    CHECK(written.out.find("boxbeam verify my.toml") != std::string::npos);
    const std::string text = test::read_file(folder.path() / "my.toml");
    CHECK(text == test::read_file(test::project_file("sections/templates/" + kind + ".toml")));
    for (std::size_t line = 0; line < text.size(); line = text.find('\n', line) + 1) {
      CHECK(text.find('\n', line) - line <= 100);
    }
    CHECK(test::run_program({"validate", "my.toml"}, folder.path()).exit_code == 0);
    // A frame at rest and given loads have no motion, and say so.
    CHECK(test::run_program({"motion", "my.toml"}, folder.path()).exit_code ==
          (kind == "static" || kind == "loads" ? 2 : 0));
    const test::ProgramResult verified = test::run_program(
        {"verify", "my.toml", "--no-plots", "--no-pdf", "--json", "-"}, folder.path());
    INFO(verified.err);
    CHECK(verified.exit_code == 0);
    const auto results = nlohmann::json::parse(verified.out);
    CHECK(results["verdict"] == "pass");
    // Neither bored nor at its limit, so that a change can be seen.
    const double use = results["checks"][0]["utilisation"].get<double>();
    CHECK(use > 0.4);
    CHECK(use < 0.9);
  }
}

TEST_CASE("init: what its comments offer instead is right as well", "[init]") {
  const test::TemporaryFolder folder;
  REQUIRE(test::run_program({"init"}, folder.path()).exit_code == 0);
  REQUIRE(fs::exists(folder.path() / "planar.toml"));
  const auto runs = [&](const std::string& text) {
    const std::string file = folder.write("changed.toml", text);
    const test::ProgramResult result =
        test::run_program({"verify", file, "--no-plots", "--no-pdf", "--quiet"}, folder.path());
    INFO(text << "\n" << result.err);
    CHECK((result.exit_code == 0 || result.exit_code == 1));
    CHECK(result.err.empty());
  };
  const std::string planar = template_of("planar");
  runs(changed(planar, "uniform_rod = \"0.3 m\" ", "inertia = \"0.3 kg m^2\" "));
  runs(changed(uncommented(planar, "# kind = \"harmonic\"\n"),
               "kind = \"constant rate\"\nstart = \"90 deg\"\nrate = \"40 rpm\"\n", ""));
  runs(uncommented(planar, "# [forces.pull]\n"));
  runs(uncommented(planar, "# [[beam.holes]]\n"));
  runs(uncommented(planar, "# centre = "));
  runs(changed(planar, "category = 80 ", "row = \"8.2/6\" "));
  runs(changed(planar, "\"spectrum\"", "\"constant amplitude\""));
  runs(changed(template_of("spatial"), "direction = \"-z\" ",
               "direction = \"-z\"\naxes = \"column\" #"));
  const std::string at_rest = template_of("static");
  runs(uncommented(at_rest, "# [members.strut]\n"));
  runs(uncommented(at_rest, "# [loads.snow]\n") +
       "\n[load_cases.snow]\nkind = \"variable\"\npsi_0 = 0.5\n");
  runs(uncommented(at_rest, "# from = [\"0 m\", \"0 m\"]"));
  folder.write("measured.csv",
               "time [s], Fload [kN], Fcylinder [kN], V1 [kN], M1 [kN m]\n0, -5, 12.5, -7.5, 0\n"
               "1, -35, 87.5, -52.5, 0\n");
  const std::string given = uncommented(template_of("loads"), "# [files.measured]\n");
  const std::string measured = changed(
      changed(given, "force = [\"0 kN\", \"0 kN\", \"-35 kN\"]", "columns = { F_z = \"Fload\" }"),
      "force = [\"0 kN\", \"0 kN\", \"87.5 kN\"]",
      "columns = { F = \"Fcylinder\" }\ndirection = [0, 0, 1]");
  runs(measured.substr(0, measured.find("[[situations]]")) +
       changed(measured.substr(measured.find("[material]")), "category = 71 ",
               "cycles = 5e4\ncategory = 71 "));
  const std::string flexible = template_of("flexible");
  runs(uncommented(flexible, "# force = "));
  runs(changed(flexible, "{ ratio = 0.01, at = \"25 Hz\" } ", "\"0.3 ms\" "));
}

TEST_CASE("init: nothing is overwritten, and standard output takes a case as well", "[init]") {
  const test::TemporaryFolder folder;
  const std::string mine = folder.write("mine.toml", "mine");
  const test::ProgramResult refused = test::run_program({"init", "planar", mine});
  CHECK(refused.exit_code == 2);
  CHECK(refused.err.find("is there already, and nothing is overwritten") != std::string::npos);
  CHECK(test::read_file(mine) == "mine");
  fs::create_symlink("nowhere.toml", folder.path() / "link.toml");
  CHECK(test::run_program({"init", "planar", "link.toml"}, folder.path()).exit_code == 2);
  CHECK(test::run_program({"init", "planer"}, folder.path()).exit_code == 2);
  const test::ProgramResult out = test::run_program({"init", "flexible", "-"}, folder.path());
  CHECK(out.out == test::read_file(test::project_file("sections/templates/flexible.toml")));
  const test::ProgramResult nowhere =
      test::run_program({"init", "planar", mine + "/case.toml"}, folder.path());
  CHECK(nowhere.exit_code == 4);
  const fs::path missing = folder.path() / "missing";
  CHECK(test::run_program({"init", "planar", (missing / "case.toml").string()}).exit_code == 4);
  CHECK_FALSE(fs::exists(missing));
}

TEST_CASE("init: the schema that the first line names stands beside the case where wanted",
          "[init]") {
  const test::TemporaryFolder folder;
  const std::string link = "#:schema ./";
  for (const std::string kind : {"planar", "spatial", "flexible", "static", "loads"}) {
    INFO(kind);
    REQUIRE(test::run_program({"init", kind, "--schema"}, folder.path()).exit_code == 0);
    // Editors read the directive in the first line, and its path from the folder of the case.
    const std::string text = test::read_file(folder.path() / (kind + ".toml"));
    REQUIRE(text.starts_with(link));
    const std::string name = text.substr(link.size(), text.find('\n') - link.size());
    const fs::path named = folder.path() / name;
    REQUIRE(fs::exists(named));
    CHECK(test::read_file(named) == test::run_program({"schema", "case"}).out);
    fs::remove(named);
  }
  REQUIRE(test::run_program({"init", "static", "alone.toml"}, folder.path()).exit_code == 0);
  CHECK_FALSE(fs::exists(folder.path() / "boxbeam-case.schema.json"));
  CHECK(test::run_program({"init", "static", "-", "--schema"}, folder.path()).exit_code == 2);
}

TEST_CASE("init: a case begun from a robot is valid, runs, and says what is a placeholder",
          "[init]") {
  const test::TemporaryFolder folder;
  folder.write("arm.urdf",
               "<robot name=\"arm\"><link name=\"world\"/>"
               "<joint name=\"hinge\" type=\"revolute\"><parent link=\"world\"/><child "
               "link=\"beam\"/><axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"1\"/></joint>"
               "<link name=\"beam\"><inertial><origin xyz=\"1 0 0\"/><mass value=\"200\"/><inertia "
               "ixx=\"1\" iyy=\"70\" izz=\"70\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
               "<joint name=\"wrist\" type=\"fixed\"><origin xyz=\"2 0 0\"/><parent "
               "link=\"beam\"/><child link=\"load\"/></joint>"
               "<link name=\"load\"><inertial><mass value=\"100\"/></inertial></link></robot>");
  const auto run = [&](std::vector<std::string> arguments) {
    return test::run_program(arguments, folder.path());
  };
  CHECK(run({"init", "--from-urdf", "arm.urdf", "arm.toml", "--schema"}).exit_code == 0);
  const std::string text = test::read_file(folder.path() / "arm.toml");
  CHECK(text.starts_with("#:schema ./boxbeam-case.schema.json\n"));
  CHECK(fs::exists(folder.path() / "boxbeam-case.schema.json"));
  CHECK(run({"validate", "arm.toml"}).exit_code == 0);
  CHECK(run({"motion", "arm.toml"}).exit_code == 0);
  const test::ProgramResult verified =
      run({"verify", "arm.toml", "--no-plots", "--no-pdf", "--json", "-"});
  INFO(verified.err);
  REQUIRE(verified.exit_code == 0);
  const auto results = nlohmann::json::parse(verified.out);
  CHECK(results["verdict"] == "pass");
  CHECK(results["case"] == "arm-with-placeholders");
  // Nothing is overwritten, and every way to name the case is that of other kinds.
  CHECK(run({"init", "--from-urdf", "arm.urdf", "arm.toml"}).exit_code == 2);
  CHECK(test::read_file(folder.path() / "arm.toml") == text);
  CHECK(run({"init", "spatial", "-", "--from-urdf", "arm.urdf"}).out == text);
  CHECK(run({"init", "--from-urdf", "arm.urdf"}).exit_code == 0);
  CHECK(test::read_file(folder.path() / "spatial.toml") == text);
  const test::ProgramResult load =
      run({"init", "spatial", "-", "--from-urdf", "arm.urdf", "--beam", "load"});
  CHECK(load.out.find("[beam]\nbody = \"load\"") != std::string::npos);
  // What cannot be is refused, and leaves no file.
  CHECK(run({"init", "planar", "p.toml", "--from-urdf", "arm.urdf"}).exit_code == 2);
  CHECK(run({"init", "p.toml", "--from-urdf", "no.urdf"}).exit_code == 2);
  CHECK(run({"init", "p.toml", "--from-urdf", "arm.urdf", "--beam", "hand"}).exit_code == 2);
  CHECK(run({"init", "p.toml", "--beam", "load"}).exit_code == 2);
  // A model of MuJoCo likewise, but not both at once.
  folder.write("arm.xml",
               "<mujoco model=\"press\"><worldbody><body name=\"beam\"><joint name=\"hinge\" "
               "axis=\"0 1 0\"/><geom type=\"box\" size=\"1 0.1 0.1\" pos=\"1 0 0\" "
               "mass=\"200\"/></body></worldbody></mujoco>");
  CHECK(run({"init", "press.toml", "--from-mjcf", "arm.xml"}).exit_code == 0);
  CHECK(run({"verify", "press.toml", "--no-plots", "--no-pdf"}).exit_code == 0);
  CHECK(run({"init", "spatial", "-", "--from-mjcf", "arm.xml", "--beam", "beam"}).exit_code == 0);
  CHECK(run({"init", "p.toml", "--from-mjcf", "arm.xml", "--from-urdf", "arm.urdf"}).exit_code ==
        2);
  CHECK(run({"init", "p.toml", "--from-mjcf", "arm.urdf"}).exit_code == 2);
  folder.write("far.urdf",
               "<robot name=\"far\"><link name=\"world\"/><link name=\"a\"/><joint name=\"j\" "
               "type=\"revolute\"><parent link=\"world\"/><child link=\"a\"/><origin xyz=\"1e9 0 "
               "0\"/></joint></robot>");
  const test::ProgramResult far = run({"init", "p.toml", "--from-urdf", "far.urdf"});
  CHECK(far.exit_code == 2);
  CHECK(far.err.find("far.urdf as a case:") != std::string::npos);
  CHECK_FALSE(fs::exists(folder.path() / "p.toml"));
}

TEST_CASE("init: a file alone is that of a planar case", "[init]") {
  const test::TemporaryFolder folder;
  CHECK(test::run_program({"init", "my.toml"}, folder.path()).exit_code == 0);
  CHECK(test::read_file(folder.path() / "my.toml") == template_of("planar"));
  CHECK(test::run_program({"init", "my.toml", "other.toml"}, folder.path()).exit_code == 2);
  CHECK_FALSE(fs::exists(folder.path() / "other.toml"));
}

}  // namespace init_command_test
