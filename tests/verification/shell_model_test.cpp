// A beam as shells: its loads are in balance and cut what the beam's diagram cuts; the area of its
// plates is that of the section.

#include "boxbeam/verification/shell_model.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "catch.hpp"
#include "support/rig.hpp"

namespace shell_model_test {

using namespace boxbeam;

namespace {

const char* const in_space =
    "[case]\nname = \"space\"\nkind = \"static\"\n[frame]\nspace = true\n"
    "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"-9.81 m/s^2\"]\n[material]\nsteel = \"S355\"\n"
    "[strength]\nrequired = 1.0\n[sections.a]\nkind = \"box\"\nwidth = \"300 mm\"\n"
    "height = \"500 mm\"\ntop_flange = \"14 mm\"\nbottom_flange = \"10 mm\"\nleft_web = \"8 mm\"\n"
    "right_web = \"12 mm\"\n[beam]\ndensity = \"7850 kg/m^3\"\nfrom = [\"0 m\", \"0 m\", \"0 m\"]\n"
    "axis = \"x\"\nz = \"z\"\n[[beam.segments]]\nlength = \"4 m\"\nsection = \"a\"\n"
    "[supports.wall]\nkind = \"fixed\"\nat = \"0 m\"\n[loads.tip]\nkind = \"force\"\nat = \"4 m\"\n"
    "force = [\"100 kN\", \"40 kN\", \"-60 kN\"]\nmoment = [\"180 kN m\", \"7 kN m\", \"9 kN "
    "m\"]\n";

/// Force, and moment about a place of the axis, of the nodal forces from there on.
Eigen::Matrix<double, 6, 1> beyond(const ShellModel& model, double s) {
  Eigen::Matrix<double, 6, 1> sum = Eigen::Matrix<double, 6, 1>::Zero();
  for (const NodalForce& of : model.forces) {
    const Eigen::Vector3d at = model.nodes[of.node] - Eigen::Vector3d(s, 0.0, 0.0);
    if (at.x() < 0.0) continue;
    sum.head<3>() += of.force;
    sum.tail<3>() += at.cross(of.force);
  }
  return sum;
}

void check_loads(const Project& project) {
  const Verification verification = verify(project);
  const std::deque<SituationRun> runs = run_situations(project, verification.model.chosen);
  const auto shown = governing_loads(project, runs, verification);
  REQUIRE(shown);
  const BeamLoads loads = shown->run->loads.loads_at(shown->time);
  const CutForceDiagram diagram = cut_forces_of(loads);
  REQUIRE(obstacle_to_shells(project).empty());
  const ShellModel model = shell_model_of(project, loads, diagram);
  double largest = 0.0;
  for (const PointLoad& load : loads.points) largest = std::max(largest, load.force.norm());
  CHECK(largest > 0.0);
  CHECK(beyond(model, -1.0).norm() < 1e-9 * largest * project.beam.length().value());
  // Between two loaded sections the nodal forces behind are those of the cut, but for what acts per
  // length on that stretch: its weight and inertia, here below a hundredth.
  std::vector<double> places;
  for (const NodalForce& of : model.forces) places.push_back(model.nodes[of.node].x());
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  CHECK(places.size() > 10);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double s = 0.5 * (places[i] + places[i + 1]);
    const CutForces cut = diagram.at({si<Length>(s)});
    const Eigen::Matrix<double, 6, 1> sum = beyond(model, s);
    const Eigen::Matrix<double, 6, 1> wanted{cut.N.value(), cut.V_y.value(), cut.V_z.value(),
                                             cut.T.value(), cut.M_y.value(), cut.M_z.value()};
    INFO(s);
    CHECK((sum - wanted).norm() < 0.01 * largest);
  }
  // Every element has eight nodes of its own places, and every node an element.
  std::vector<bool> used(model.nodes.size(), false);
  for (const ShellElement& element : model.elements)
    for (const std::size_t node : element.nodes) used[node] = true;
  CHECK(std::all_of(used.begin(), used.end(), [](bool is) { return is; }));
}

}  // namespace

TEST_CASE("shell model: the loads of the rig are in balance and cut what is cut") {
  check_loads(test::rig());
}

TEST_CASE("shell model: likewise in space, in a box of four unlike plates") {
  const Project project = parse_project("space.toml", in_space);
  check_loads(project);
  const Verification verification = verify(project);
  const std::deque<SituationRun> runs = run_situations(project, verification.model.chosen);
  const auto shown = governing_loads(project, runs, verification);
  const BeamLoads loads = shown->run->loads.loads_at(shown->time);
  const ShellModel model = shell_model_of(project, loads, cut_forces_of(loads));
  // The plates between their mid-lines have the area of the box: 300 x 500 less 280 x 476 mm.
  double volume = 0.0;
  for (const ShellElement& element : model.elements) {
    const auto at = [&](std::size_t k) { return model.nodes[element.nodes[k]]; };
    volume += (at(1) - at(0)).cross(at(3) - at(0)).norm() * model.sets[element.set].thickness;
  }
  CHECK(volume == Approx(4.0 * (0.3 * 0.5 - 0.28 * 0.476)).epsilon(1e-9));
}

TEST_CASE("shell model: profiles that are no flat plates are named") {
  std::string text = in_space;
  const std::size_t from = text.find("kind = \"box\""), to = text.find("[beam]");
  text.replace(from, to - from, "kind = \"round tube\"\ndiameter = \"300 mm\"\nwall = \"10 mm\"\n");
  CHECK(obstacle_to_shells(parse_project("tube.toml", text)) == "round tube (segment 1)");
}

}  // namespace shell_model_test
