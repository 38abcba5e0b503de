#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/modes.hpp"
#include "boxbeam/verification/elastic_model.hpp"
#include "charts/hermite_beam.hpp"
#include "charts/points.hpp"
#include "charts/reference_beam.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

using flexible::Element;
using flexible::Structure;

constexpr double round_off = std::numeric_limits<double>::epsilon();

/// Parts of a link unless the case says otherwise.
int default_parts() { return flexible::Link{}.parts; }

/// 2, 4, 8, ...
std::vector<int> divisions_up_to(int most) {
  std::vector<int> divisions;
  for (int n = 2; n <= most; n *= 2) divisions.push_back(n);
  return divisions;
}

std::string parts_text(int parts) { return fmt::format("{} parts", parts); }

/// What a chart asks of the cantilever.
struct Question {
  double exact = 0.0;
  std::function<double(const flexible::Mechanism&)> by_rigid_elements;
  std::function<double(const HermiteBeam&)> by_finite_elements;
};

double error_of(double value, const Question& question) {
  return std::abs(std::abs(value) / question.exact - 1.0);
}

double by_parts(const Question& question, int parts, Element element) {
  return question.by_rigid_elements(unit_cantilever(parts, element));
}

/// (4 f_2n - f_n)/3.
double extrapolated(const Question& question, int parts) {
  return (4.0 * by_parts(question, parts, Element::classical) -
          by_parts(question, parts / 2, Element::classical)) /
         3.0;
}

/// Two coordinates for every part of a cantilever that bends.
double unknowns(int parts) { return 2.0 * parts; }

Trial trial_of(const Question& question, const std::string& setting, int parts, double operations,
               const std::function<double()>& value) {
  return {solved_point(setting, parts, operations, error_of(value(), question)),
          [value] { keep(value()); }};
}

TriedMethod rigid_elements_over(const Question& question, Element element,
                                const std::vector<int>& divisions, const std::string& where = "") {
  TriedMethod method{
      (element == Element::corrected ? "corrected" : "classical") + where, {}, false};
  for (const int n : divisions) {
    method.trials.push_back(
        trial_of(question, parts_text(n), n, unknowns(n),
                 [question, n, element] { return by_parts(question, n, element); }));
  }
  return method;
}

TriedMethod richardson_over(const Question& question, const std::vector<int>& divisions) {
  TriedMethod method{"classical, extrapolated (Richardson)", {}, true};
  for (const int n : divisions) {
    if (n < 4) continue;
    method.trials.push_back(trial_of(question, fmt::format("{} and {} parts", n / 2, n), n,
                                     unknowns(n) + unknowns(n / 2),
                                     [question, n] { return extrapolated(question, n); }));
  }
  return method;
}

TriedMethod finite_elements_over(const Question& question, const std::vector<int>& divisions,
                                 const std::string& where = "") {
  TriedMethod method{"Hermite finite elements" + where, {}, true};
  for (const int n : divisions) {
    method.trials.push_back(
        trial_of(question, fmt::format("{} elements", n), n, unknowns(n),
                 [question, n] { return question.by_finite_elements(hermite_cantilever(n)); }));
  }
  return method;
}

/// The exact form, in as many pieces as it takes at a square of omega.
TriedMethod exact_at(const Question& question, double square, const std::string& where = "") {
  const flexible::Mechanism whole = unit_cantilever(1, Element::exact);
  const int pieces = flexible::pieces_at(structure_of(whole), square);
  TriedMethod method{"exact" + where, {}, false};
  method.trials.push_back(trial_of(
      question, fmt::format("{} piece{}", pieces, pieces == 1 ? "" : "s"), pieces, unknowns(pieces),
      [question, pieces] { return by_parts(question, pieces, Element::exact); }));
  return method;
}

/// Classical and corrected elements, the former extrapolated, the outside yardstick, and the exact
/// form at a square of omega.
std::vector<TriedMethod> methods_over(const Question& question, const std::vector<int>& divisions,
                                      double square) {
  return {rigid_elements_over(question, Element::classical, divisions),
          rigid_elements_over(question, Element::corrected, divisions),
          richardson_over(question, divisions), finite_elements_over(question, divisions),
          exact_at(question, square)};
}

void mark_default(TriedMethod& corrected) {
  for (Trial& trial : corrected.trials) {
    trial.point.is_default = trial.point.parameter == static_cast<double>(default_parts());
  }
}

Chart cantilever_chart(const std::string& name, const std::string& title) {
  Chart chart;
  chart.name = name;
  chart.title = title;
  chart.scene = "uniform cantilever without shear (Euler and Bernoulli)";
  chart.operations = "unknowns of the division";
  chart.floor = {round_off, "round-off of double"};
  chart.off_front =
      "The exact form (element = \"exact\") leaves no error in a single link: its cost is a search "
      "of frequencies by counts, each of which is a factorisation. Corrected elements stay the "
      "default, for sudden starts and second order forces are sums over a division.";
  return chart;
}

const Point& point_of(const Series& series, int parts) {
  return *std::find_if(series.points.begin(), series.points.end(),
                       [&](const Point& point) { return point.parameter == parts; });
}

/// Order of convergence that a series has where its error is no round-off yet.
double order_seen(const Series& series) {
  return std::log2(point_of(series, 16).error / point_of(series, 32).error);
}

Chart frequency_chart(int k, const Effort& effort) {
  Chart chart = cantilever_chart(k == 1 ? "rfem-frequency" : fmt::format("rfem-frequency-{}", k),
                                 k == 1 ? "Rigid finite elements: lowest frequency"
                                        : "Rigid finite elements: third frequency");
  chart.error = "relative error of the frequency";
  chart.reference = "cos(x) cosh(x) = -1, long double";
  chart.unit = "frequency from the beam (Hermite: sparse Cholesky and subspace iteration)";
  const long double root = cantilever_root(k);
  const auto index = static_cast<std::size_t>(k);
  const Question question{static_cast<double>(root * root),
                          [index](const flexible::Mechanism& mechanism) {
                            const Structure structure = structure_of(mechanism);
                            return 2.0 * std::numbers::pi *
                                   flexible::modes_of(structure, index).back().frequency;
                          },
                          [k](const HermiteBeam& beam) { return hermite_omega(beam, k); }};
  std::vector<int> divisions = divisions_up_to(effort.quick ? 32 : 256);
  if (k > 1) divisions.erase(divisions.begin());  // two parts have no third frequency of a beam
  std::vector<TriedMethod> methods =
      methods_over(question, divisions, question.exact * question.exact);
  mark_default(methods[1]);
  chart.series = timed(methods, effort);
  chart.guides = {{2.0, 0}, {3.0, 1}, {4.0, 3}};
  chart.lesson = fmt::format(
      "Classical elements converge with order {:.2f}, corrected ones with {:.2f} at the same cost: "
      "{:.1e} instead of {:.1e} at {} parts. The exact form leaves {:.0e}.",
      order_seen(chart.series[0]), order_seen(chart.series[1]), default_point(chart)->error,
      point_of(chart.series[0], default_parts()).error, default_parts(),
      chart.series.back().points.front().error);
  return chart;
}

Chart deflection_chart(const Effort& effort) {
  Chart chart = cantilever_chart("rfem-deflection", "Rigid finite elements: static deflection");
  chart.error = "relative error of the end's deflection";
  chart.reference = "F L^3/(3 EI)";
  chart.unit = "deflection from the beam (Hermite: sparse Cholesky)";
  const Question question{
      1.0 / 3.0,
      [](const flexible::Mechanism& mechanism) {
        const Structure structure = structure_of(mechanism);
        const flexible::Attachment end{0, {1.0, 0.0}};
        return motion_at(structure, end, flexible::static_response(structure)).y();
      },
      hermite_deflection};
  const std::vector<int> divisions = divisions_up_to(effort.quick ? 64 : 1024);
  std::vector<TriedMethod> methods = methods_over(question, divisions, 0.0);
  mark_default(methods[1]);
  chart.series = timed(methods, effort);
  chart.guides = {{2.0, 0}};
  const auto largest = [](const Series& series) {
    return std::max_element(series.points.begin(), series.points.end(),
                            [](const Point& a, const Point& b) { return a.error < b.error; })
        ->error;
  };
  chart.lesson = fmt::format(
      "Corrected elements are statically exact, {:.0e} at most however many; classical ones are "
      "too stiff by 1/(4 n^2). Finite elements in absolute coordinates lose digits with every "
      "division, {:.0e} at {:.0f} elements.",
      largest(chart.series[1]), chart.series[3].points.back().error,
      chart.series[3].points.back().parameter);
  chart.off_front = "A deflection at rest needs no division; the default is that of vibration.";
  return chart;
}

Chart root_moment_chart(const Effort& effort) {
  Chart chart =
      cantilever_chart("rfem-root-moment", "Rigid finite elements: root moment in vibration");
  chart.error = "relative error of the moment at the root";
  chart.reference = "Euler and Bernoulli's beam, long double";
  chart.unit = "response from the beam (Hermite: sparse LU)";
  const std::vector<int> divisions = divisions_up_to(effort.quick ? 32 : 256);
  std::vector<TriedMethod> methods, exact;
  for (const double ratio : {0.3, 0.9}) {
    const long double root = cantilever_root(1);
    const auto omega = static_cast<double>(ratio * root * root);
    const double frequency = omega / (2.0 * std::numbers::pi);
    const Question question{
        static_cast<double>(cantilever_root_moment(omega)),
        [frequency](const flexible::Mechanism& mechanism) {
          const Structure structure = structure_of(mechanism);
          return joint_force(structure, 0, flexible::harmonic_response(structure, frequency))
              .z()
              .real();
        },
        [omega](const HermiteBeam& beam) { return hermite_root_moment(beam, omega); }};
    const std::string where = fmt::format(", r = {}", ratio);
    methods.push_back(rigid_elements_over(question, Element::classical, divisions, where));
    methods.push_back(rigid_elements_over(question, Element::corrected, divisions, where));
    methods.push_back(finite_elements_over(question, divisions, where));
    exact.push_back(exact_at(question, omega * omega, where));
  }
  methods.insert(methods.end(), exact.begin(), exact.end());
  for (const std::size_t i : {0U, 1U, 2U, 6U}) methods[i].other_scene = true;
  mark_default(methods[4]);
  chart.series = timed(methods, effort);
  chart.guides = {{2.0, 3}, {3.0, 4}, {4.0, 5}};
  chart.lesson = fmt::format(
      "Near resonance (r = 0.9) the error of the frequency is amplified: {} corrected parts leave "
      "{:.1e} of the moment, classical ones {:.1e}; at r = 0.3 it is {:.1e} and {:.1e}.",
      default_parts(), default_point(chart)->error,
      point_of(chart.series[3], default_parts()).error,
      point_of(chart.series[1], default_parts()).error,
      point_of(chart.series[0], default_parts()).error);
  return chart;
}

/// Forces of all joints, amplitudes or, where nothing vibrates, at rest: x and y of each.
Eigen::VectorXcd joint_forces(const flexible::Mechanism& mechanism) {
  const Structure structure = structure_of(mechanism);
  const flexible::Response response = flexible::response_of(structure);
  const auto count = static_cast<Eigen::Index>(mechanism.joints.size());
  Eigen::VectorXcd forces(2 * count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const auto joint = static_cast<std::size_t>(j);
    forces.segment<2>(2 * j) =
        mechanism.frequency > 0.0
            ? joint_force(structure, joint, response.harmonic).head<2>().eval()
            : joint_force(structure, joint, response.constant).head<2>().cast<flexible::Complex>();
  }
  return forces;
}

double largest_force(const Eigen::VectorXcd& forces) {
  double largest = 0.0;
  for (Eigen::Index j = 0; j + 1 < forces.size(); j += 2) {
    largest = std::max(largest, forces.segment<2>(j).norm());
  }
  return largest;
}

flexible::Mechanism divided(const flexible::Mechanism& mechanism, int parts, Element element) {
  return modelled(mechanism, {ModelLevel::flexible, 0, parts, element, false});
}

Chart reaction_chart(const Project& project, const Effort& effort) {
  const flexible::Mechanism& mechanism = flexible_of(project);
  Chart chart;
  chart.name = "rfem-reactions";
  chart.title = "Rigid finite elements: forces of the joints";
  chart.scene = mechanism.frequency > 0.0
                    ? fmt::format("{}, loads of {:.4g} Hz", project.name, mechanism.frequency)
                    : fmt::format("{}, at rest", project.name);
  chart.error = "largest error of a joint's force over the largest of them";
  chart.operations = "rigid elements";
  chart.unit = "response of the mechanism";
  constexpr int reference_parts = 512;
  chart.reference = fmt::format("corrected elements, {} parts per link", reference_parts);
  Eigen::VectorXcd reference;
  try {
    reference = joint_forces(divided(mechanism, reference_parts, Element::corrected));
  } catch (const AnalysisError& error) {
    return without_answer(std::move(chart), error.failure().what);
  }
  const double size = largest_force(reference);
  std::vector<TriedMethod> methods;
  for (const Element element : {Element::classical, Element::corrected}) {
    TriedMethod& method = methods.emplace_back();
    method.method = element == Element::corrected ? "corrected" : "classical";
    for (const int n : divisions_up_to(effort.quick ? 16 : 128)) {
      const flexible::Mechanism by = divided(mechanism, n, element);
      const auto operations = static_cast<double>(structure_of(by).elements());
      const std::string setting = fmt::format("{} parts per link", n);
      try {
        const double error = largest_force(joint_forces(by) - reference);
        method.trials.push_back(
            {solved_point(setting, n, operations, size > 0.0 ? error / size : error),
             [by] { keep(joint_forces(by)); }});
      } catch (const AnalysisError& error) {
        method.trials.push_back({failed_point(setting, n, operations, error.failure().what), {}});
      }
    }
  }
  mark_default(methods[1]);
  chart.series = timed(methods, effort);
  chart.guides = {{2.0, 0}};
  const Point& by_default = *default_point(chart);
  chart.lesson =
      by_default.failure.empty()
          ? fmt::format("{} parts per link leave {:.1e} of the largest force, {} {:.1e}.",
                        default_parts(), by_default.error, chart.series[1].points.back().setting,
                        chart.series[1].points.back().error)
          : "No response: " + by_default.failure;
  return chart;
}

}  // namespace

TopicResult rigid_elements(const Scenes& scenes, const Effort& effort) {
  TopicResult result;
  result.charts.push_back(frequency_chart(1, effort));
  result.charts.push_back(frequency_chart(3, effort));
  result.charts.push_back(deflection_chart(effort));
  result.charts.push_back(root_moment_chart(effort));
  if (scenes.flexible) result.charts.push_back(reaction_chart(*scenes.flexible, effort));
  return result;
}

}  // namespace boxbeam::charts
