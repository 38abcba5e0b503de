#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "boxbeam/verification/elastic_model.hpp"
#include "charts/points.hpp"
#include "charts/reference_beam.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

using flexible::Complex;
using flexible::ModalModel;
using flexible::Structure;

constexpr double round_off = std::numeric_limits<double>::epsilon();
constexpr int parts = 32;

/// The lowest modes of a model that has more.
ModalModel truncated(const ModalModel& model, std::size_t count) {
  const auto size = static_cast<Eigen::Index>(count);
  return {model.structure,
          {model.modes.begin(), model.modes.begin() + size},
          model.damping.topLeftCorner(size, size)};
}

std::string modes_text(std::size_t count) {
  return fmt::format("{} mode{}", count, count == 1 ? "" : "s");
}

/// 1, 2, 3, 4, 6, 8, 12, ... as long as there are so many.
std::vector<std::size_t> counts_up_to(std::size_t most) {
  std::vector<std::size_t> counts{1};
  for (std::size_t power = 2; power <= most; power *= 2) {
    counts.push_back(power);
    if (power + power / 2 <= most) counts.push_back(power + power / 2);
  }
  return counts;
}

/// The cantilever and its modes; the chart's works look at it.
struct Beam {
  flexible::Mechanism mechanism = unit_cantilever(parts, flexible::Element::corrected);
  Structure structure = structure_of(mechanism);
  long double first = ChainReference(structure).first_omega(std::pow(cantilever_root(1), 2));

  Beam() = default;
  Beam(const Beam&) = delete;
  Beam& operator=(const Beam&) = delete;
};

double root_moment(const Structure& structure, const flexible::Deformation<Complex>& of) {
  return joint_force(structure, 0, of).z().real();
}

/// Error of the modes with and without static correction at some frequencies, and of the direct
/// solution at the last of them.
Chart root_moment_chart(const std::string& name, const std::string& title,
                        const std::vector<double>& ratios, const Effort& effort) {
  const Beam beam;
  Chart chart;
  chart.name = name;
  chart.title = title;
  chart.scene = fmt::format("cantilever of {} parts, force at its end", parts);
  chart.error = "relative error of the moment at the root";
  chart.reference = "the same elements by initial values, long double";
  chart.operations = "equations of motion";
  chart.unit = "one frequency, modes included";
  chart.floor = {round_off, "round-off of double"};
  const std::vector<std::size_t> counts = counts_up_to(effort.quick ? 8 : 24);
  const ModalModel all = flexible::modal_model_of(beam.structure, counts.back());
  std::vector<TriedMethod> methods;
  for (const double ratio : ratios) {
    constexpr long double full_turn = 2.0L * std::numbers::pi_v<long double>;
    const auto frequency = static_cast<double>(ratio * beam.first / full_turn);
    const auto exact = static_cast<double>(
        ChainReference(beam.structure).root_moment(full_turn * frequency).real());
    const auto error_of = [&](const flexible::Deformation<Complex>& response) {
      return std::abs(root_moment(beam.structure, response) / exact - 1.0);
    };
    for (const bool correction : {true, false}) {
      TriedMethod& method = methods.emplace_back();
      method.method =
          fmt::format("modes {}, r = {}", correction ? "with static correction" : "alone", ratio);
      method.yardstick = !correction;
      for (const std::size_t count : counts) {
        const auto size = static_cast<double>(count);
        const double error =
            error_of(flexible::harmonic_response(truncated(all, count), frequency, correction));
        method.trials.push_back(
            {solved_point(modes_text(count), size, size, error),
             [&beam, count, frequency, correction] {
               keep(flexible::harmonic_response(flexible::modal_model_of(beam.structure, count),
                                                frequency, correction));
             }});
      }
    }
    const double error = error_of(flexible::harmonic_response(beam.structure, frequency));
    methods.push_back(
        {fmt::format("direct, r = {}", ratio),
         {{solved_point("all elements", 2.0 * parts, 2.0 * parts, error),
           [&beam, frequency] { keep(flexible::harmonic_response(beam.structure, frequency)); }}},
         false});
  }
  chart.series = timed(methods, effort);
  // Three series for each frequency.
  const std::size_t last = chart.series.size() - 3;
  const auto by_one_mode = [&](std::size_t series) {
    return chart.series[series].points.front().error;
  };
  chart.lesson = fmt::format(
      "One mode with static correction leaves {:.1e} at r = {} and {:.1e} at r = {}; without it "
      "{:.1e} and {:.1e}, and more modes mend that only slowly: {} still leave {:.1e}.",
      by_one_mode(0), ratios.front(), by_one_mode(last), ratios.back(), by_one_mode(1),
      by_one_mode(last + 1), counts.back(), chart.series[1].points.back().error);
  return chart;
}

using JointForces = std::vector<std::vector<Eigen::Vector3cd>>;  ///< of each joint, by frequency

/// Largest difference of a joint's force over the largest of them, of the worst frequency.
double difference(const JointForces& of, const JointForces& reference) {
  double worst = 0.0;
  for (std::size_t i = 0; i < reference.front().size(); ++i) {
    double size = 0.0;
    double apart = 0.0;
    for (std::size_t j = 0; j < reference.size(); ++j) {
      size = std::max(size, reference[j][i].head<2>().norm());
      apart = std::max(apart, (of[j][i] - reference[j][i]).head<2>().norm());
    }
    if (size > 0.0) worst = std::max(worst, apart / size);
  }
  return worst;
}

JointForces direct(const Structure& structure, const std::vector<double>& frequencies) {
  JointForces forces(structure.joints.size());
  for (const double frequency : frequencies) {
    const flexible::Deformation<Complex> response =
        flexible::harmonic_response(structure, frequency);
    for (std::size_t j = 0; j < forces.size(); ++j) {
      forces[j].push_back(joint_force(structure, j, response));
    }
  }
  return forces;
}

JointForces by_modes_alone(const ModalModel& model, const std::vector<double>& frequencies) {
  JointForces forces(model.structure->joints.size());
  for (const double frequency : frequencies) {
    const flexible::Deformation<Complex> response =
        flexible::harmonic_response(model, frequency, false);
    for (std::size_t j = 0; j < forces.size(); ++j) {
      forces[j].push_back(joint_force(*model.structure, j, response));
    }
  }
  return forces;
}

/// Equal steps up to beyond the drive, a hundredth off any natural frequency.
std::vector<double> swept(double top, std::size_t count, const std::vector<flexible::Mode>& modes) {
  constexpr double off = 1e-2;
  std::vector<double> frequencies;
  for (std::size_t i = 1; i <= count; ++i) {
    double frequency = top * static_cast<double>(i) / static_cast<double>(count);
    for (const flexible::Mode& mode : modes) {
      if (std::abs(frequency - mode.frequency) < off * mode.frequency) {
        frequency = (1.0 + off) * mode.frequency;
      }
    }
    frequencies.push_back(frequency);
  }
  return frequencies;
}

/// As many modes as the program's figures over the frequency have at least.
constexpr std::size_t modes_of_figures = 24;

struct JointChart {
  const char* name;
  std::string title, scene, unit;
  std::vector<double> frequencies;
  bool figures = false;  ///< whether the program does this with a number of modes of its own
  /// Modes say nothing of how the highest ones, left to static correction, are damped.
  bool damped = false;
};

Chart named_chart(const JointChart& asked) {
  Chart chart;
  chart.name = asked.name;
  chart.title = asked.title;
  chart.scene = asked.scene;
  chart.error = "largest error of a joint's force over the largest of them";
  chart.reference = asked.damped ? "direct solution of the same elements"
                                 : "all modes of the same elements with static correction";
  chart.operations = "equations of motion";
  chart.unit = asked.unit;
  return chart;
}

Chart joint_chart(const JointChart& asked, const ModalModel& all, const Effort& effort) {
  const Structure& structure = *all.structure;
  Chart chart = named_chart(asked);
  const JointForces reference = asked.damped ? direct(structure, asked.frequencies)
                                             : flexible::sweep_of(all, asked.frequencies).joints;
  const std::vector<double>& frequencies = asked.frequencies;
  const std::vector<std::size_t> counts =
      counts_up_to(std::min<std::size_t>(all.modes.size(), effort.quick ? 24 : 48));
  std::vector<TriedMethod> methods;
  for (const bool correction : {true, false}) {
    TriedMethod& method = methods.emplace_back();
    method.method = correction ? "modes with static correction" : "modes alone";
    method.yardstick = !correction;
    const auto forces = [&frequencies, correction](const ModalModel& model) {
      return correction ? flexible::sweep_of(model, frequencies).joints
                        : by_modes_alone(model, frequencies);
    };
    for (const std::size_t count : counts) {
      const auto size = static_cast<double>(count);
      try {
        const double error = difference(forces(truncated(all, count)), reference);
        method.trials.push_back(
            {solved_point(modes_text(count), size, size, error), [&structure, count, forces] {
               keep(forces(flexible::modal_model_of(structure, count)));
             }});
      } catch (const AnalysisError& error) {
        method.trials.push_back(
            {failed_point(modes_text(count), size, size, error.failure().what), {}});
      }
      method.trials.back().point.is_default =
          asked.figures && correction && count == modes_of_figures;
    }
  }
  const auto all_unknowns = 3.0 * static_cast<double>(structure.elements());
  const double apart = difference(direct(structure, frequencies), reference);
  methods.push_back({"direct",
                     {{solved_point("all elements", all_unknowns, all_unknowns, apart),
                       [&structure, &frequencies] { keep(direct(structure, frequencies)); }}},
                     false});
  chart.series = timed(methods, effort);
  // What the first modes above the drive bring.
  const Series& corrected = chart.series[0];
  const Series& alone = chart.series[1];
  const double top = *std::max_element(frequencies.begin(), frequencies.end());
  const auto below = static_cast<std::size_t>(
      std::count_if(all.modes.begin(), all.modes.end(),
                    [&](const flexible::Mode& mode) { return mode.frequency < top; }));
  const std::size_t last = corrected.points.size() - 1;
  chart.lesson = fmt::format(
      "Natural frequencies below {:.4g} Hz: {}. Static correction stands for modes above the "
      "drive, not for those below. {} leave {:.1e}, without correction {:.1e}.",
      top, below, corrected.points[last].setting, corrected.points[last].error,
      alone.points[last].error);
  if (const Point* by_default = default_point(chart)) {
    chart.lesson += fmt::format(" The {} of the report's figures leave {:.1e}.",
                                by_default->setting, by_default->error);
    chart.off_front =
        "The figures are those of these modes, which the report lists with their frequencies.";
  }
  return chart;
}

/// The links as the case divides them, or where these are very many parts, for which all modes are
/// too much, in the usual number.
flexible::Mechanism divided(const flexible::Mechanism& mechanism) {
  constexpr std::size_t most_elements = 200;
  if (structure_of(mechanism).elements() <= most_elements) return mechanism;
  return modelled(mechanism,
                  {ModelLevel::flexible, 0, flexible::Link{}.parts, mechanism.element, false});
}

/// Charts of the scene's joints: at its frequency, and over many.
std::vector<Chart> joint_charts(const Project& project, const Effort& effort) {
  const flexible::Mechanism mechanism = divided(flexible_of(project));
  const Structure structure = structure_of(mechanism);
  const double drive = mechanism.frequency;
  constexpr std::size_t sweep = 100;
  constexpr double beyond = 1.8;
  JointChart at_drive{"response-joints",
                      "Harmonic response: forces of the joints",
                      fmt::format("{}, loads of {:.4g} Hz", project.name, drive),
                      "one frequency, modes included",
                      {drive},
                      false,
                      is_damped(mechanism)};
  JointChart over{"response-sweep",
                  "Harmonic response: forces of the joints over the frequency",
                  fmt::format("{}, loads up to {:.4g} Hz", project.name, beyond * drive),
                  fmt::format("{} frequencies, modes included", sweep),
                  {},
                  true,
                  is_damped(mechanism)};
  std::vector<Chart> charts;
  try {
    const ModalModel all = flexible::modal_model_of(structure, 3 * structure.elements());
    over.frequencies = swept(beyond * drive, sweep, all.modes);
    charts.push_back(joint_chart(at_drive, all, effort));
    charts.push_back(joint_chart(over, all, effort));
  } catch (const AnalysisError& error) {
    const JointChart& failed = charts.empty() ? at_drive : over;
    charts.push_back(without_answer(named_chart(failed), error.failure().what));
  }
  return charts;
}

}  // namespace

TopicResult response(const Scenes& scenes, const Effort& effort) {
  TopicResult result;
  result.charts.push_back(root_moment_chart(
      "response-below-resonance", "Harmonic response below resonance", {0.1, 0.3}, effort));
  result.charts.push_back(root_moment_chart("response-beyond-resonance",
                                            "Harmonic response near and beyond resonance",
                                            {0.9, 2.0}, effort));
  const bool vibrates = scenes.flexible && flexible_of(*scenes.flexible).frequency > 0.0 &&
                        !flexible_of(*scenes.flexible).joints.empty();
  if (vibrates) {
    for (Chart& chart : joint_charts(*scenes.flexible, effort)) {
      result.charts.push_back(std::move(chart));
    }
  }
  return result;
}

}  // namespace boxbeam::charts
