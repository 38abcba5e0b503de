// What a table of forces means for the beam, against hand calculation of a cantilever.

#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/table_cantilever.hpp"

namespace table_loads_test {

using namespace boxbeam;

namespace {

struct Written {
  explicit Written(const std::string& table = table_cantilever::trapezoid) {
    folder.write("force.csv", table);
  }

  Project read(const std::string& law) const {
    return parse_project((folder.path() / "case.toml").string(), table_cantilever::text(law));
  }

  double factor(const std::string& law) const {
    return verify(read(law)).governing(Criterion::fatigue)->check.safety_factor;
  }

  std::string refused(const std::string& law) const {
    try {
      read(law);
    } catch (const InputError& error) {
      return error.problems().front().message + " | " + error.problems().front().hint;
    }
    return "";
  }

  test::TemporaryFolder folder;
};

/// One range of M/W from nothing, 2e6 times on category 71.
double factor_by_hand(double force) { return 71e6 / (force * 1.0 / table_cantilever::W); }

bool says(const std::string& text, const char* words) {
  return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("a trapezoid of 20 kN loads the beam with 20 kN, however steep its sides") {
  const Written gentle;
  const double right = factor_by_hand(20e3);
  CHECK(gentle.factor("periodic = true") == Approx(right).epsilon(2e-3));
  CHECK(gentle.factor("periodic = true, interpolation = \"pchip\"") == Approx(right).epsilon(2e-3));
  // A spline has a range from -15/11 ... to 20 + 45/11 kN: what it overshoots counts.
  CHECK(gentle.factor("periodic = true, interpolation = \"cubic\", overshoot = \"accept\"") <
        0.84 * right);
  const Written steep("time [s], force [kN]\n0, 0\n1, 0\n1.01, 20\n1.5, 20\n1.51, 0\n2, 0\n");
  CHECK(steep.factor("periodic = true") == Approx(right).epsilon(0.02));
  // With sides of 1 ms a spline had a use of 105 309 % in the place of 222 %.
  const Written edge("time [s], force [kN]\n0, 0\n1, 0\n1.001, 20\n1.5, 20\n1.501, 0\n2, 0\n");
  CHECK(edge.factor("periodic = true") == Approx(right).epsilon(2e-3));
}

TEST_CASE("an edge of 1 ms in 100 s is looked at at its points") {
  // Linear it is 20 kN from 20.001 s to 60 s; a step jumps at 20.001 s.
  const Written edge("time [s], force [kN]\n0, 0\n20, 0\n20.001, 20\n60, 20\n60.001, 0\n100, 0\n");
  const double right = factor_by_hand(20e3);
  for (const char* law : {"interpolation = \"linear\"", "interpolation = \"step\"",
                          "periodic = true", "interpolation = \"step\", beyond = \"hold\""}) {
    CAPTURE(law);
    CHECK(edge.factor(law) == Approx(right).epsilon(2e-3));
  }
  // A peak between two of the instants: 1 ms of 20 kN.
  const Written peak("time [s], force [kN]\n0, 0\n37.3, 0\n37.3005, 20\n37.301, 0\n100, 0\n");
  CHECK(peak.factor("interpolation = \"linear\"") == Approx(right).epsilon(2e-3));
}

TEST_CASE("an edge of 1 ms in 100 s is looked at in space as in the plane") {
  const test::TemporaryFolder folder;
  folder.write("force.csv",
               "time [s], force [kN]\n0, 0\n37.3, 0\n37.3005, 20\n37.301, 0\n100, 0\n");
  for (const char* interpolation : {"linear", "step"}) {
    const Project project = parse_project(
        (folder.path() / "case.toml").string(),
        std::string("[case]\nname = \"cantilever\"\nkind = \"spatial\"\n"
                    "[mechanism]\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n"
                    "[bodies.arm]\npoints = { A = [\"0 m\", \"0 m\", \"0 m\"], "
                    "B = [\"1 m\", \"0 m\", \"0 m\"] }\n"
                    "[joints.root]\nkind = \"fixed\"\nconnect = [\"ground\", \"arm.A\"]\n"
                    "at = [\"0 m\", \"0 m\", \"0 m\"]\n"
                    "[forces.push]\nkind = \"force\"\npoint = \"arm.B\"\ndirection = \"z\"\n"
                    "law = { kind = \"table\", file = \"force.csv\", interpolation = \"") +
            interpolation +
            "\" }\n[sections.box]\nkind = \"box\"\nwidth = \"100 mm\"\nheight = \"200 mm\"\n"
            "flange = \"10 mm\"\nweb = \"10 mm\"\n"
            "[beam]\nbody = \"arm\"\naxis = \"x\"\nz = \"z\"\ndensity = \"7850 kg/m^3\"\n"
            "[[beam.segments]]\nlength = \"1 m\"\nsection = \"box\"\n"
            "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\nshear_lag = false\n"
            "[fatigue]\ncategory = 71\ncycles = 2e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
            "required = 1.0\n");
    CAPTURE(interpolation);
    CHECK(verify(project).governing(Criterion::fatigue)->check.safety_factor ==
          Approx(factor_by_hand(20e3)).epsilon(2e-3));
  }
}

TEST_CASE("a spline that leaves its table is refused unless the case accepts it") {
  const Written written;
  const std::string refusal = written.refused("periodic = true, interpolation = \"cubic\"");
  CHECK(says(refusal, "% of the table's range"));
  CHECK(says(refusal, "overshoot = \"accept\""));
  CHECK(written.refused("periodic = true, interpolation = \"linear\"").empty());
}

TEST_CASE("beyond its ends a table says nothing unless it holds or repeats") {
  const Written written;
  // Alone it is looked at to its end, which it covers; with a longer time it does not.
  CHECK(written.refused("interpolation = \"linear\"").empty());
  const auto longer = [&](const std::string& law) {
    try {
      parse_project((written.folder.path() / "case.toml").string(),
                    table_cantilever::text(law, "[motion]\nduration = \"7 s\"\n"));
    } catch (const InputError& error) {
      return error.problems().front().message + " | " + error.problems().front().hint;
    }
    return std::string();
  };
  const std::string refusal = longer("interpolation = \"linear\"");
  CHECK(says(refusal, "goes from 0 s to 5 s"));
  CHECK(says(refusal, "to 7 s"));
  CHECK(says(refusal, "beyond = \"hold\""));
  CHECK(longer("beyond = \"hold\"").empty());
  CHECK(longer("beyond = \"periodic\"").empty());
  CHECK(says(written.refused("periodic = true, beyond = \"hold\""), "does not keep"));
  const Written late("time [s], force [kN]\n1, 0\n2, 20\n3, 0\n");
  CHECK(says(late.refused("interpolation = \"linear\""), "from 1 s to 3 s"));
}

}  // namespace table_loads_test
