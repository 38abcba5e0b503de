// The published Newton chain, kept for comparison.

#include "boxbeam/mechanism/planar/newton_chain.hpp"

#include "catch.hpp"
#include "support/csv.hpp"
#include "support/rig.hpp"

namespace newton_chain_test {

using namespace boxbeam;
using namespace boxbeam::planar;

namespace {

const Project& published() {
  static const Project project =
      read_project(test::project_file("sections/sledge-rig/published.toml"));
  return project;
}

}  // namespace

TEST_CASE(
    "thesis 3.1: the chain of the published accelerations gives the published forces and mass") {
  const test::CsvTable table =
      test::read_csv(test::project_file("tests/validation/data/thesis_accelerations.csv"));
  const std::vector<double>& row = table.rows[2];
  REQUIRE(row[0] == 1.071);
  std::vector<Eigen::Vector2d> accelerations;
  for (const std::size_t body : {3, 2, 1, 4, 5, 6}) {
    accelerations.emplace_back(row[3 * (body - 1) + 1], row[3 * (body - 1) + 2]);
  }
  const NewtonChain& chain = published().chain.value();
  const ChainForces forces = chain_of(chain, accelerations);
  // Published to 0.2 %; the vertical force of the lower beam is a small difference of large terms
  // and -47.1 N as well.
  CHECK(forces.g[0].x() == Approx(96.8e3).epsilon(2e-3));
  CHECK(forces.g[1].x() == Approx(97.3e3).epsilon(2e-3));
  CHECK(forces.g[1].y() == Approx(22.8).epsilon(2e-3));
  CHECK(forces.g[2].x() == Approx(102885.0).epsilon(2e-3));
  CHECK(forces.g[2].y() == Approx(460.1).epsilon(2e-3));
  CHECK(forces.g[3].x() == Approx(96350.0).epsilon(2e-3));
  CHECK(forces.g[3].y() == Approx(-47.1).epsilon(1e-2));
  CHECK(forces.g[4].x() == Approx(95.5e3).epsilon(2e-3));
  CHECK(forces.g[4].y() == Approx(-77.8).epsilon(1e-2));
  CHECK(forces.sought_mass == Approx(18627.0).epsilon(2e-3));
}

TEST_CASE("the chain's loads on the beam are in balance, with a couple at the pivot") {
  const Project& project = published();
  InstantSolver solver(planar_of(project));
  const State state = solver.solve_from_sketch(1.071, sketch_of(planar_of(project)));
  const BeamLoads loads =
      beam_loads_of(project.chain.value(), project.beam, mass_distribution_of(project.beam),
                    planar_of(project).gravity, state);
  const Imbalance open = imbalance_of(loads);
  CHECK(open.force.norm() < 1e-8);
  CHECK(open.moment.norm() < 1e-8);
  CHECK(std::abs(loads.points.back().moment.y()) > 1.0);
}

TEST_CASE("the chain through the pieces of one beam body uses their own masses") {
  const NewtonChain& chain = test::rig().chain.value();
  // By hand from the rig's areas: 7800 (0.5 (0.13 + 0.09) 1 + 0.09 0.5 + (0.09 + A_t) 0.5 + A_t)
  // above the pivot, 7800 (0.09 1.5 + 0.11 1.7) below; A_t = 0.29 0.49 - 0.178 0.378.
  const double A_t = 0.29 * 0.49 - 0.178 * 0.378;
  CHECK(chain.steps[2].mass == Approx(7800.0 * (0.11 + 0.045 + 0.045 + 1.5 * A_t)).epsilon(1e-12));
  CHECK(chain.steps[3].mass == Approx(7800.0 * (0.135 + 0.187)).epsilon(1e-12));
}

}  // namespace newton_chain_test
