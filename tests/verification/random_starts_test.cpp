// Random starts and stops of four-bar linkages and arms: the model that is chosen against many
// modes and twice the parts, at the instants that those want.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/uniform.hpp"

namespace random_starts_test {

using namespace boxbeam;

namespace {

constexpr double tolerance = 0.02;

planar::Driven& driver_of(planar::Mechanism& mechanism) {
  for (planar::Joint& joint : mechanism.joints)
    if (planar::is_driver(joint)) return std::get<planar::Driven>(joint.kind);
  throw std::logic_error("no driver");
}

/// A linkage whose crank, or arm whose shaft, turns once from rest to rest, some back again. From
/// hardly to strongly vibrating; `slow` ones mostly bear their weight, which excites nothing.
Project random_start(const Project& linkage, bool arm, bool slow, test::Uniform& between) {
  Project project = linkage;
  project.model.tolerance = tolerance;
  planar::Mechanism& mechanism = planar_of(project);
  planar::Driven& driven = driver_of(mechanism);
  const double from = arm ? between(-0.5, 1.0) : driver_at(driven.driver, 0.0).value;
  const double turn = between(0.1, arm ? 0.5 : 1.2),
               length = slow ? between(6.0, 10.0) : between(0.3, 1.5);
  if (between(0.0, 1.0) < 0.6) {
    driven.driver = StepDriver{from, from + turn, 0.0, length};
  } else {
    // There, and back from where it never rests.
    driven.driver = TableDriver{TableCurve({0.0, 0.4 * length, length, 1.6 * length},
                                           {from, from + turn, from + 0.3 * turn, from},
                                           Interpolation::cubic, Beyond::hold)};
  }
  mechanism.duration = {};
  const double softer = slow ? between(-1.8, -0.8) : between(-2.6, -0.5);
  project.model.youngs_modulus *= std::pow(10.0, softer);
  project.model.shear_modulus *= project.model.youngs_modulus / linkage.model.youngs_modulus;
  project.model.retardation = between(0.0, 1.0) < 0.5 ? 0.0 : between(1e-4, 2e-3);
  return project;
}

/// Of the model that is chosen, found or else estimated; infinite where it was not weighed.
double error_of_chosen(const ModelChoice& choice) {
  double error = std::numeric_limits<double>::infinity();
  for (const ModelEstimate& of : choice.weighed)
    if (of.model.level == choice.chosen.level) error = of.found.value_or(of.error);
  return error;
}

/// How many modes, eight at most, the instants of a transient motion resolve, in eight to a period;
/// finer parts and other postures have somewhat faster ones.
int resolved_modes(const ModelledRuns& chosen) {
  constexpr double instants = 8192.0, to_a_period = 10.0, eighth_to_sixth = 2.0;
  const std::vector<double>& frequencies = chosen.model.frequencies;
  const double fastest = instants / (to_a_period * chosen.runs.front().loads.period().value());
  if (eighth_to_sixth * frequencies.back() <= fastest) return 8;
  return static_cast<int>(std::count_if(frequencies.begin(), frequencies.end(),
                                        [&](double f) { return f <= fastest; }));
}

struct Found {
  double apart = 0.0;  ///< of the stresses at any time, by the largest
  double peak = 0.0;   ///< of the largest moment at its place, by the search over time
};

Found compare_starts(const Project& project, const SituationRun& model, bool vibrates,
                     const SituationRun& better) {
  const std::vector<ComparedPlace> places = compared_places_of(project.beam);
  // Rigid bodies rest behind the end of the motion; a free vibration is known as far as it is
  // looked at, by some models longer than by others.
  const double begin = better.loads.begin().value();
  const double length = vibrates
                            ? std::min(model.loads.period().value(), better.loads.period().value())
                            : better.loads.period().value();
  constexpr int looks = 160;
  double apart = 0.0, largest = 0.0, most = -1.0;
  Station worst;
  for (int i = 0; i <= looks; ++i) {
    const Time time = si<Time>(begin + length * i / looks);
    const CutForceDiagram diagram = better.loads.diagram_at(time);
    const Eigen::ArrayXd of_better = fibre_stresses(diagram, places);
    const Eigen::ArrayXd of_model = fibre_stresses(model.loads.diagram_at(time), places);
    apart = std::max(apart, (of_model - of_better).abs().maxCoeff());
    Eigen::Index at = 0;
    const double stress = of_better.abs().maxCoeff(&at);
    largest = std::max(largest, stress);
    if (stress <= most) continue;
    most = stress;
    worst = places[static_cast<std::size_t>(at / 2)].station;
  }
  // By the search over time of both, of which the better one has many times the instants.
  const auto largest_moment = [&](const SituationRun& run) {
    const StationHistory history(run.loads, worst);
    return history.largest([](const CutForces& cut) { return std::abs(cut.M_y.value()); }).value;
  };
  const double peak = largest_moment(better), found = largest_moment(model);
  return {apart / largest, std::abs(found - peak) / peak};
}

}  // namespace

TEST_CASE("random starts are as near to many modes as the tolerance says", "[.][random_starts]") {
  const Project linkage = read_project(test::project_file("sections/four-bar-rocker/rocker.toml"));
  Project arm = linkage;
  {
    // The rocker by itself, on its pivot, with the mass at its end.
    planar::Mechanism& mechanism = planar_of(arm);
    const int pivot = planar::joint_index(mechanism, "C");
    REQUIRE(pivot >= 0);
    const planar::Joint at = mechanism.joints[static_cast<std::size_t>(pivot)];
    const auto [a, b] = planar::ends_of(at);
    planar::Driven shaft;
    shaft.point = a.body == planar::ground ? b : a;
    shaft.coordinate = planar::Coordinate::angle;
    shaft.driver = StepDriver{};
    const std::vector<std::string> kept = {"C", "D"};
    std::erase_if(mechanism.joints, [&](const planar::Joint& joint) {
      return std::find(kept.begin(), kept.end(), joint.name) == kept.end();
    });
    mechanism.joints.push_back({"shaft", shaft});
    mechanism.loops.clear();
    // Bodies that nothing holds are held where they are.
    for (const char* name : {"crank", "coupler"}) {
      const int body = planar::body_index(mechanism, name);
      REQUIRE(body >= 0);
      planar::Rigid held;
      held.a = {body, Eigen::Vector2d::Zero()};
      const Posture& sketch = mechanism.bodies[static_cast<std::size_t>(body)].sketch;
      held.b = {planar::ground, sketch.centre};
      held.angle = sketch.angle;
      mechanism.joints.push_back({name, held});
    }
  }
  test::Uniform between(7);
  std::string refusals;
  int by_rigid = 0, by_modes = 0, refused = 0;
  constexpr int sudden = 40, slow = 20;
  for (int i = 0; i < sudden + slow; ++i) {
    const bool is_arm = i % 2 == 1, is_slow = i >= sudden;
    const Project project = random_start(is_arm ? arm : linkage, is_arm, is_slow, between);
    INFO("start " << i);
    try {
      const ModelledRuns chosen = run_by_chosen_model(project);
      INFO(chosen.model.reason);
      const bool modal = chosen.model.chosen.level == ModelLevel::modal;
      // One that buckles, or whose error is not known, has no model to compare.
      if (!modal && !(error_of_chosen(chosen.model) <= tolerance)) {
        refusals += fmt::format("start {}: {}\n", i, chosen.model.reason);
        ++refused;
        continue;
      }
      const int modes = std::max(resolved_modes(chosen), chosen.model.chosen.modes + 1);
      const int parts = std::max(16, 2 * chosen.model.chosen.parts);
      const std::deque<SituationRun> better =
          run_situations(project, {ModelLevel::modal, modes, parts, {}, false});
      const Found found = compare_starts(project, chosen.runs.front(), modal, better.front());
      CHECK(found.apart < tolerance);
      CHECK(found.peak < tolerance);
      (modal ? by_modes : by_rigid) += 1;
    } catch (const AnalysisError& error) {
      refusals += fmt::format("start {}: {}\n", i, error.what());
      ++refused;
    }
  }
  INFO("rigid or bent " << by_rigid << ", modal " << by_modes << ", refused " << refused << "\n"
                        << refusals);
  CHECK(by_rigid >= 5);
  CHECK(by_modes >= 40);
  CHECK(refused <= 3);
}

}  // namespace random_starts_test
