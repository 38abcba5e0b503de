#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/beam_loads.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/report/remarks.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/flexible_motion_result.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace boxbeam {
namespace {

const std::string truck = test::project_file("sections/drill-truck/truck.toml");

/// N, V and M at s from the forces of the joints before s and weight and inertia per length there,
/// summed over midpoints of narrow strips.
Eigen::Vector3d by_free_body(const BeamLoads& loads, double s) {
  Eigen::Vector3d cut = Eigen::Vector3d::Zero();
  const auto add = [&](double at, double along, double across, double couple) {
    cut -= Eigen::Vector3d(along, across, couple + across * (s - at));
  };
  for (const PointLoad& load : loads.points) {
    const double at = load.s.value();
    if (at < s) add(at, load.force.x(), load.force.z(), load.moment.y());
  }
  for (const LineLoad& line : loads.lines) {
    const double start = line.start.value();
    const double length = std::min(line.length.value(), s - start);
    constexpr int strips = 4000;
    for (int i = 0; length > 0.0 && i < strips; ++i) {
      const double x = (i + 0.5) * length / strips;
      const double width = length / strips;
      add(start + x, width * line.force[0](x), width * line.force[2](x), width * line.couple[1](x));
    }
  }
  return cut;
}

/// The stress at a fibre without reduction by shear lag or holes.
double stress_of(const CutForces& cut, const SectionProperties& section, double z) {
  return cut.N.value() / section.area.value() + cut.M_y.value() * z / section.I_y.value();
}

}  // namespace

TEST_CASE("Drill truck: the boom's cut forces are those of its free bodies",
          "[drill_truck][boom][whole]") {
  const Project project = read_project(truck);
  const SituationRun run(project, project.situations.front(),
                         {ModelLevel::flexible, 0, 0, {}, false}, {});
  CHECK(run.imbalance < 1e-11);
  for (const double part : {0.0, 0.13, 0.5, 0.77}) {
    const Time time = part * run.loads.period();
    const BeamLoads loads = run.loads.loads_at(time);
    const CutForceDiagram diagram = run.loads.diagram_at(time);
    for (const double s : {0.4, 1.49, 1.51, 2.2, 2.7, 4.1}) {
      const Eigen::Vector3d expected = by_free_body(loads, s);
      const CutForces cut = diagram.at({si<Length>(s)});
      CAPTURE(part, s);
      CHECK(cut.N.value() == Approx(expected[0]).epsilon(1e-7));
      CHECK(cut.V_z.value() == Approx(expected[1]).epsilon(1e-7));
      CHECK(cut.M_y.value() == Approx(expected[2]).epsilon(1e-7));
    }
  }
}

// The posture determines the static forces: moments about w1, and the boom's weight 329.7 kg by
// hand, A = 10000 mm^2.
TEST_CASE("Drill truck: what acts on the boom follows from moments about its hinge",
          "[drill_truck][boom][whole]") {
  const Project project = read_project(truck, {"loads.drill.amplitude_force=[\"0 N\", \"0 N\"]",
                                               "loads.drill.amplitude_moment=\"0 N m\""});
  const SituationRun run(project, project.situations.front(), {}, {});
  const BeamLoads loads = run.loads.loads_at(Time{});
  double moment = 0.0;
  double across = 0.0;
  for (const PointLoad& load : loads.points) {
    moment += load.s.value() * load.force.z() - load.moment.y();
    across += load.force.z();
  }
  const double weight = 0.01 * 4.2 * 7850.0 * 9.81 * std::cos(25.0 * std::numbers::pi / 180.0);
  CHECK(across == Approx(weight).epsilon(1e-9));
  CHECK(moment == Approx(2.1 * weight).epsilon(1e-9));
}

// A stress that is linear in the cut forces vibrates as Im(sigma e^(i omega t)): its range over a
// period is 2 |sigma|.
TEST_CASE("Drill truck: the range of stress is twice the size of its complex amplitude",
          "[drill_truck][boom][whole]") {
  const Project project = read_project(truck);
  const SituationRun run(project, project.situations.front(),
                         {ModelLevel::flexible, 0, 0, {}, false}, {});
  const FlexibleMotion& motion = flexible_motion_of(run);
  const flexible::BeamResponse response = flexible::beam_response_of(
      *motion.structure, project.beam_body, project.beam, motion.response, motion.inertial);
  const CutForceDiagram sine = cut_forces_of(response.sine);
  const CutForceDiagram cosine = cut_forces_of(response.cosine);
  for (const double s : {0.7, 1.49, 1.51, 2.59, 2.61, 3.5}) {
    const Station station{si<Length>(s)};
    const SectionProperties section = properties_of(section_at(project.beam, station));
    for (const double z : {-0.15, 0.15}) {
      const std::complex<double> amplitude(stress_of(sine.at(station), section, z),
                                           stress_of(cosine.at(station), section, z));
      const StationHistory history(run.loads, station);
      const auto stress = [&](const CutForces& cut) { return stress_of(cut, section, z); };
      const double highest = history.largest(stress).value;
      const double lowest =
          -history.largest([&](const CutForces& cut) { return -stress(cut); }).value;
      CAPTURE(s, z);
      CHECK(highest - lowest == Approx(2.0 * std::abs(amplitude)).epsilon(1e-9));
    }
  }
}

TEST_CASE("Drill truck: models of the boom differ by what they leave out, and all are in balance",
          "[drill_truck][boom][whole]") {
  const Project project = read_project(truck);
  const auto moment_range = [&](const ElasticModel& model) {
    const SituationRun run(project, project.situations.front(), model, {});
    CHECK(run.imbalance < 1e-10);
    const StationHistory history(run.loads, {si<Length>(1.5), Side::before});
    const auto M = [](const CutForces& cut) { return cut.M_y.value(); };
    return history.largest(M).value +
           history.largest([&](const CutForces& cut) { return -M(cut); }).value;
  };
  const double all = moment_range({ModelLevel::flexible, 0, 0, {}, false});
  CHECK(moment_range({ModelLevel::modal, 40, 0, {}, false}) == Approx(all).epsilon(1e-4));
  CHECK(moment_range({ModelLevel::flexible, 0, 32, {}, false}) == Approx(all).epsilon(0.01));
  // 25 Hz is above most natural frequencies: statics alone miss it by far.
  const double quasi_static = moment_range({ModelLevel::quasi_static, 0, 0, {}, false});
  CHECK(std::abs(quasi_static / all - 1.0) > 0.2);
}

TEST_CASE("Drill truck: the boom is verified for 5e7 cycles at category 100",
          "[drill_truck][boom][whole]") {
  Project project = read_project(truck);
  // The drilling alone: one range.
  REQUIRE(project.situations.back().sudden_start);
  project.situations.pop_back();
  const Verification result = verify(project);
  CHECK(result.verdict == Verdict::pass);
  const CheckResult* fatigue = result.governing(Criterion::fatigue);
  REQUIRE(fatigue != nullptr);
  REQUIRE(fatigue->basis);
  CHECK(fatigue->check.required == 1.5);
  // 100 MPa at 2e6, slope 3 to 5e6, slope 5 beyond. Source: EN 1993-1-9:2005, 7.1(3).
  const double at_5e6 = 100.0 * std::cbrt(2.0 / 5.0);
  const double at_5e7 = at_5e6 * std::pow(0.1, 0.2);
  const double range = fatigue->basis->highest.value - fatigue->basis->lowest.value;
  CHECK(fatigue->check.safety_factor == Approx(at_5e7 * 1e6 / range).epsilon(1e-3));
  REQUIRE(result.pictures.elastic);
  CHECK(result.pictures.elastic->modes.size() == 6);
  CHECK(result.pictures.elastic->over_period.names.size() == 10);
  CHECK(result.pictures.postures.front().magnified == 1.0);
  CHECK(result.pictures.postures.size() == result.pictures.lines.size() + 1);
}

TEST_CASE("Drill truck: the sudden start counts, and more than the steady vibration",
          "[drill_truck][boom][whole]") {
  const Project project = read_project(truck);
  const Verification result = verify(project);
  CHECK(result.verdict == Verdict::pass);
  const CheckResult* yield = result.governing(Criterion::yield);
  REQUIRE(yield != nullptr);
  CHECK(yield->check.situation == "start");
  Project steady = project;
  steady.situations.pop_back();
  const Verification drilling = verify(steady);
  const CheckResult* without = drilling.governing(Criterion::yield);
  REQUIRE(without != nullptr);
  CHECK(yield->check.safety_factor < without->check.safety_factor);
  // The steady amplitude is some 2 MPa of 53 MPa; free vibrations that start with it at rest are of
  // its size: no more than a few times as much.
  CHECK(yield->check.safety_factor > 0.85 * without->check.safety_factor);
}

TEST_CASE("Drill truck: what a sudden start adds is remarked, without vibration it is not",
          "[drill_truck][boom][whole]") {
  const auto remarked = [](const Project& project) {
    const std::vector<Remark> remarks = remarks_of(project, verify(project));
    return std::any_of(remarks.begin(), remarks.end(), [](const Remark& remark) {
      return remark.text.find("after a sudden start joint") != std::string::npos;
    });
  };
  Project project = read_project(truck);
  // Where the start counts, nothing is left to remark.
  CHECK_FALSE(remarked(project));
  project.situations.pop_back();
  CHECK(remarked(project));
  flexible::Mechanism& mechanism = flexible_of(project);
  mechanism.frequency = 0.0;
  for (flexible::Load& load : mechanism.loads) load.amplitude.setZero();
  CHECK_FALSE(remarked(project));
}

TEST_CASE("Drill truck: by the exact form the boom has what fine divisions tend to",
          "[drill_truck][boom][whole][exact]") {
  Project project = read_project(truck);
  project.situations.pop_back();  // the sudden start, by itself below
  Project exact = project;
  flexible_of(exact).element = flexible::Element::exact;
  const auto run_of = [](const Project& of, int parts) {
    return std::make_unique<const SituationRun>(
        of, of.situations.front(), ElasticModel{ModelLevel::flexible, 0, parts, {}, true},
        SharedMotions{});
  };
  const auto by_exact = run_of(exact, 0);
  CHECK(by_exact->imbalance < 1e-10);
  const auto moments = [](const SituationRun& run) {
    std::vector<double> M;
    for (const double part : {0.0, 0.13, 0.5, 0.77}) {
      const CutForceDiagram diagram = run.loads.diagram_at(part * run.loads.period());
      for (const double s : {0.4, 1.49, 1.51, 2.2, 2.7, 4.1})
        M.push_back(diagram.at({si<Length>(s)}).M_y.value());
    }
    return M;
  };
  const std::vector<double> expected = moments(*by_exact);
  const auto error_of = [&](int parts) {
    double largest = 0.0;
    const auto run = run_of(project, parts);
    const std::vector<double> M = moments(*run);
    for (std::size_t i = 0; i < M.size(); ++i)
      largest = std::max(largest, std::abs(M[i] - expected[i]));
    return largest / *std::max_element(expected.begin(), expected.end());
  };
  const double coarse = error_of(16), fine = error_of(128);
  CAPTURE(coarse, fine);
  CHECK(fine < 0.1 * coarse);
  CHECK(fine < 1e-5);

  // The program chooses no division, but the elasticity along the axes, which counts here.
  const Verification result = verify(exact);
  CHECK(result.model.chosen.axial);
  CHECK(result.model.reason.find("no error of division") != std::string::npos);
  const Verification divided = verify(project);
  for (const Criterion criterion : {Criterion::yield, Criterion::fatigue}) {
    const CheckResult* own = result.governing(criterion);
    const CheckResult* other = divided.governing(criterion);
    REQUIRE(own != nullptr);
    REQUIRE(other != nullptr);
    CHECK(own->check.safety_factor ==
          Approx(other->check.safety_factor).epsilon(project.model.tolerance));
  }
}

TEST_CASE("Drill truck: after a sudden start the boom has what fine divisions tend to",
          "[drill_truck][boom][whole][exact]") {
  Project project = read_project(truck);
  REQUIRE(project.situations.back().sudden_start);
  Project exact = project;
  flexible_of(exact).element = flexible::Element::exact;
  // The largest moments over the time that is looked at, at places beside the joints.
  const auto largest_moments = [](const Project& of, int parts) {
    const SituationRun run(of, of.situations.back(),
                           ElasticModel{ModelLevel::flexible, 0, parts, {}, true}, SharedMotions{});
    std::vector<double> largest(4, 0.0);
    for (int i = 0; i <= 1500; ++i) {
      const CutForceDiagram diagram = run.loads.diagram_at(si<Time>(1.5e-3 * i));
      std::size_t k = 0;
      for (const double s : {0.4, 1.49, 2.2, 4.1}) {
        largest[k] = std::max(largest[k], std::abs(diagram.at({si<Length>(s)}).M_y.value()));
        ++k;
      }
    }
    return largest;
  };
  const std::vector<double> expected = largest_moments(exact, 0);
  const auto error_of = [&](int parts) {
    const std::vector<double> M = largest_moments(project, parts);
    double worst = 0.0;
    for (std::size_t k = 0; k < M.size(); ++k)
      worst = std::max(worst, std::abs(M[k] / expected[k] - 1.0));
    return worst;
  };
  // The peak of long beats: frequencies that are a little off add up in it.
  const double coarse = error_of(8), fine = error_of(64);
  CAPTURE(coarse, fine);
  CHECK(fine < 0.2 * coarse);
  CHECK(fine < 1e-3);
}

}  // namespace boxbeam
