// Loads on a beam after a sudden start: in balance, and those of the joints' own histories.

#include "boxbeam/mechanism/flexible/start_loads.hpp"

#include <cmath>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/sudden_start.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace start_loads_test {

using namespace boxbeam;

TEST_CASE(
    "after a sudden start the loads on the truck's boom are in balance and its joints' forces") {
  const Project project = read_project(test::project_file("sections/drill-truck/truck.toml"));
  const flexible::Mechanism& mechanism = flexible_of(project);
  const VibratingModes of = modes_beyond_drive(mechanism);
  const flexible::StartLoads after(*of.structure, project.beam_body, project.beam,
                                   flexible::SuddenStartModes(of.modal));
  constexpr double length = 0.5;
  constexpr std::size_t steps = 100;
  // Another way to the same motion: steps by the exponential of the matrix.
  const flexible::SuddenStart start = flexible::sudden_start_of(of.modal, length, steps);
  for (const std::size_t i : {std::size_t{0}, std::size_t{7}, std::size_t{41}, steps}) {
    CAPTURE(i);
    const BeamLoads loads = after.at(start.times[i]);
    const Imbalance open = imbalance_of(loads);
    CHECK(open.force.norm() < 1e-6);
    CHECK(open.moment.norm() < 1e-6);
    std::size_t found = 0;
    for (const PointLoad& load : loads.points) {
      for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
        if (mechanism.joints[j].name != load.name) continue;
        const double size = start.joints[j][i].head<2>().norm();
        CHECK(load.force.norm() == Approx(size).epsilon(1e-7));
        ++found;
      }
    }
    CHECK(found > 1);
  }
}

}  // namespace start_loads_test
