#include "boxbeam/verification/elastic_figures.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/verification/elastic_posture.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace boxbeam {
namespace {

constexpr ElasticModel all_elements{ModelLevel::flexible, 0, 0, {}, false};

}  // namespace

TEST_CASE("Figures of elastic links agree with the joint forces of statics and vibration",
          "[flexible][elastic_figures]") {
  const Project project = read_project(test::project_file("sections/drill-truck/truck.toml"));
  const SituationRun run(project, project.situations.front(), all_elements, {});
  const ElasticFigures figures = elastic_figures_of(project, run, all_elements);
  for (std::size_t j = 0; j < figures.motion.joints.size(); ++j) {
    const JointVibration& joint = figures.motion.joints[j];
    const double size = joint.force.magnitude + joint.force.largest;
    CAPTURE(joint.name);
    REQUIRE(figures.over_period.names[j] == joint.name);
    const std::vector<double>& period = figures.over_period.force[j];
    CHECK(period.front() == Approx(period.back()).margin(1e-9 * size));
    // The vibrating vector is never longer than its largest length.
    const auto [low, high] = std::minmax_element(period.begin(), period.end());
    CHECK(*high <= (1.0 + 1e-9) * size);
    CHECK(*low >= std::abs(joint.force.magnitude) - (1.0 + 1e-9) * joint.force.largest);
    // At rest under the static loads when the vibrating ones are switched on.
    CHECK(figures.after_start.force[j].front() ==
          Approx(joint.force.magnitude).margin(1e-6 * size));
  }
  CHECK(std::is_sorted(figures.over_frequency.at.begin(), figures.over_frequency.at.end()));
  CHECK(figures.over_frequency.at.back() > figures.motion.frequency);
}

TEST_CASE("Frequencies of links do not depend on how few of them the model counts",
          "[flexible][elastic_figures]") {
  const Project project = read_project(test::project_file("sections/drill-truck/truck.toml"));
  const auto figures_by = [&](const ElasticModel& model) {
    const SituationRun run(project, project.situations.front(), model, {});
    return elastic_figures_of(project, run, model).motion;
  };
  const FlexibleMotionResult own = flexible_motion_of(project);
  for (const FlexibleMotionResult& motion :
       {figures_by({}), figures_by({ModelLevel::modal, 3, 2, {}, false})}) {
    CHECK(motion.degrees_of_freedom == own.degrees_of_freedom);
    REQUIRE(motion.frequencies.size() == own.frequencies.size());
    for (std::size_t i = 0; i < own.frequencies.size(); ++i) {
      CHECK(motion.frequencies[i].frequency == Approx(own.frequencies[i].frequency).epsilon(1e-9));
    }
  }
  CHECK(figures_by({ModelLevel::modal, 3, 32, {}, false}).elements > own.elements);
}

TEST_CASE("Displacements are drawn 1, 2 or 5 times a power of ten as large",
          "[flexible][elastic_figures]") {
  const Project project = read_project(test::project_file("sections/drill-truck/truck.toml"));
  const flexible::Structure structure = flexible::structure_of(flexible_of(project));
  constexpr double part = 0.06;
  // From the front axle, x = -1.6 m, to the end of the feed: boom at 0.9 m, 2.6 m and 4 m at
  // 25 deg, then 3.5 m.
  const double width = 1.6 + 0.9 + 6.6 * std::cos(25.0 * std::acos(-1.0) / 180.0) + 3.5;
  for (double displacement = 1e-7; displacement < 1.0; displacement *= 1.37) {
    const double times = magnification_of(structure, displacement, part);
    CHECK(times * displacement <= (1.0 + 1e-9) * part * width);
    CHECK(times * displacement > 0.39 * part * width);
    const double digit = times / std::pow(10.0, std::floor(std::log10(times) + 1e-9));
    CAPTURE(displacement, times);
    CHECK((std::abs(digit - 1.0) < 1e-9 || std::abs(digit - 2.0) < 1e-9 ||
           std::abs(digit - 5.0) < 1e-9));
  }
  CHECK(magnification_of(structure, 0.0, part) == 1.0);
}

}  // namespace boxbeam
