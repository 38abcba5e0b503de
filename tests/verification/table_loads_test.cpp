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
