// The moments of the published Newton chain, kept for comparison.

#include "boxbeam/mechanism/planar/newton_chain.hpp"

#include "catch.hpp"
#include "support/csv.hpp"
#include "support/rig.hpp"

namespace chain_moments_test {

using namespace boxbeam;
using namespace boxbeam::planar;

TEST_CASE("thesis 3.1: the published angular accelerations give the published moments") {
  const Project project = read_project(test::project_file("sections/sledge-rig/published.toml"));
  const test::CsvTable table =
      test::read_csv(test::project_file("tests/validation/data/thesis_accelerations.csv"));
  const std::vector<double>& row = table.rows[2];
  REQUIRE(row[0] == 1.071);
  State state;
  state.a = Eigen::Map<const Eigen::VectorXd>(row.data() + 1, 18);
  const auto moments = chain_moments_at(planar_of(project), *project.chain, state);
  REQUIRE(moments.size() == 5);  // bodies 3, 2, 1, 4, 5
  CHECK(moments[0] == 0.0);
  CHECK(*moments[1] == Approx(-5.68).epsilon(1e-3));
  // -7777 is printed, which is 4825 x -1.61172 without what the rod carries on.
  CHECK(*moments[2] == Approx(-7777.0 - 5.68).epsilon(1e-4));
  CHECK(*moments[3] == Approx(-16.4e3).epsilon(1e-3));
  // Of the lower rod -10.6 is printed, without what comes before.
  CHECK(*moments[4] - *moments[3] == Approx(-10.6).epsilon(1e-2));
}

TEST_CASE("a chain through pieces of the beam has no moments from there") {
  const Project& project = test::rig();
  const auto moments = chain_moments_at(planar_of(project), *project.chain, test::rig_state(1.071));
  REQUIRE(moments.size() == project.chain->steps.size());
  bool known = true;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const ChainStep& step = project.chain->steps[i];
    known = known && step.body != project.beam_body;
    CHECK(moments[i].has_value() == known);
  }
  CHECK_FALSE(known);
}

}  // namespace chain_moments_test
