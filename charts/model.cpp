#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/modes.hpp"
#include "boxbeam/project/link_profile.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "charts/points.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

using flexible::Element;

constexpr double E = 2.1e11, G = 8.1e10;  ///< steel [Pa]
constexpr int reference_parts = 256;

ElasticModel all_elements(int parts) {
  return {ModelLevel::flexible, 0, parts, Element::corrected, true};
}
ElasticModel quasi_static(int parts) {
  return {ModelLevel::quasi_static, 0, parts, Element::corrected, true};
}
ElasticModel modal(int modes, int parts) {
  return {ModelLevel::modal, modes, parts, Element::corrected, true};
}

/// A beam that is a link of a mechanism; the case of the ladder looks at both.
struct Scene {
  flexible::Mechanism mechanism;
  int link = 0;
  TaperedBeam beam;
  std::string name;
  double first = 0.0;  ///< lowest natural frequency of a cantilever [Hz]

  LadderCase ladder() const { return {&mechanism, link, &beam}; }
};

double first_frequency(const flexible::Mechanism& mechanism) {
  const flexible::Mechanism fine = modelled(mechanism, all_elements(reference_parts));
  const std::vector<flexible::Mode> modes = flexible::modes_of(flexible::structure_of(fine), 1);
  return modes.empty() ? 0.0 : modes.front().frequency;
}

/// A steel box, clamped, under a force that vibrates at its end: 0.2 m high, `slenderness` times as
/// long.
Scene cantilever(double slenderness) {
  constexpr double height = 0.2;
  const double length = slenderness * height;
  Scene scene;
  scene.name = fmt::format("steel box cantilever, {:.3g} times as long as high", slenderness);
  const Section section{
      symmetric_box(si<Length>(0.15), si<Length>(height), si<Length>(0.008), si<Length>(0.008)),
      {}};
  scene.beam.segments = {{"", Length{}, si<Length>(length), section, section}};
  scene.beam.density = si<Density>(7850.0);
  scene.beam.rotary_inertia = true;
  flexible::Link link;
  link.name = "cantilever";
  link.kind = flexible::LinkKind::bending;
  link.length = length;
  link.stretches = link_stretches_of(scene.beam, E, G);
  scene.mechanism.links = {link};
  constexpr double infinite = std::numeric_limits<double>::infinity();
  flexible::Joint clamp;
  clamp.name = "root";
  clamp.a = {0, {0.0, 0.0}};
  clamp.stiffness = {infinite, infinite, infinite};
  scene.mechanism.joints = {clamp};
  const Eigen::Vector3d force(0.0, 1000.0, 0.0);
  scene.mechanism.loads = {{"end", {0, {length, 0.0}}, Eigen::Vector3d::Zero(), force, 0.0}};
  scene.first = first_frequency(scene.mechanism);
  return scene;
}

/// Of the named case, if it is one of elastic links that vibrates, else a cantilever at r = 0.3.
Scene scene_of(const Scenes& scenes) {
  if (scenes.flexible && flexible_of(*scenes.flexible).frequency > 0.0) {
    const Project& project = *scenes.flexible;
    const flexible::Mechanism& mechanism = flexible_of(project);
    return {mechanism, project.beam_body, project.beam,
            fmt::format("{}, {:.4g} Hz", project.name, mechanism.frequency)};
  }
  Scene scene = cantilever(20.0);
  scene.mechanism.frequency = 0.3 * scene.first;
  scene.name += ", 0.3 times its first frequency";
  return scene;
}

/// Stresses by which a model is judged, its own or those of the reference.
struct Judge {
  LadderCase of;
  std::vector<ComparedPlace> places;
  VibratingStress reference;

  explicit Judge(const Scene& scene)
      : of(scene.ladder()),
        places(places_of(of)),
        reference(stresses_by(of, all_elements(reference_parts), places)) {}

  double error_of(const ElasticModel& model) const {
    return difference_between(stresses_by(of, model, places), reference);
  }
};

/// Coordinates of the mechanism as a model divides it, three for every rigid element.
double coordinates(const LadderCase& of, const ElasticModel& model) {
  const flexible::Mechanism mechanism = modelled(*of.mechanism, model);
  return 3.0 * static_cast<double>(flexible::structure_of(mechanism).elements());
}

Point judged(const Judge& judge, const ElasticModel& model, const std::string& setting,
             double parameter, double operations) {
  try {
    return solved_point(setting, parameter, operations, judge.error_of(model));
  } catch (const AnalysisError& error) {
    return failed_point(setting, parameter, operations, error.failure().what);
  }
}

constexpr double tolerance = 0.01;  ///< of a case that says nothing else

std::string chosen_text(const ModelChoice& choice) { return describe(choice.chosen); }

/// Error of the model that the program chooses.
Point chosen_point(const Judge& judge, const std::string& setting, double parameter) {
  try {
    const ModelChoice choice = climb_ladder(judge.of, tolerance);
    return judged(judge, choice.chosen, fmt::format("{}: {}", setting, chosen_text(choice)),
                  parameter, parameter);
  } catch (const AnalysisError& error) {
    return failed_point(setting, parameter, parameter, error.failure().what);
  }
}

Chart stress_chart(const std::string& name, const std::string& title) {
  Chart chart;
  chart.name = name;
  chart.title = title;
  chart.error = "relative error of the governing stress";
  chart.reference = fmt::format("all elements, {} parts per link", reference_parts);
  chart.needed_low = 1e-3;
  chart.needed_high = tolerance;
  return chart;
}

/// Error of each level over the frequency, with what theory says of statics.
Chart level_chart(const Effort& effort) {
  Chart chart = stress_chart("model-frequency", "How much elasticity a frequency needs");
  Scene scene = cantilever(20.0);
  chart.scene = scene.name;
  chart.operations = "frequency of the load over the first natural one, r";
  chart.operations_cost = false;
  struct Level {
    const char* name;
    ElasticModel model;
  };
  constexpr int parts = 32;
  const std::vector<Level> levels = {
      {"rigid bodies; elastic statics, where balance alone decides", {}},
      {"modal, 1 mode", modal(1, parts)},
      {"modal, 2 modes", modal(2, parts)},
      {"all elements", all_elements(parts)}};
  for (const Level& level : levels) chart.series.push_back({level.name, {}, false});
  chart.series.push_back({"chosen by boxbeam for 1 %", {}, false});
  chart.series.push_back({"one degree of freedom in theory, r^2", {}, true});
  constexpr double shown_default = 0.3;
  const std::vector<double> ratios =
      effort.quick ? std::vector{0.05, 0.1, shown_default, 0.9, 2.0}
                   : std::vector{0.02, 0.05, 0.1,  0.15, 0.2, shown_default, 0.4, 0.6,
                                 0.8,  0.9,  0.95, 1.2,  1.5, 2.0,           3.0, 4.0};
  for (const double ratio : ratios) {
    scene.mechanism.frequency = ratio * scene.first;
    const Judge judge(scene);
    const std::string setting = fmt::format("r = {}", ratio);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      chart.series[i].points.push_back(judged(judge, levels[i].model, setting, ratio, ratio));
    }
    chart.series[levels.size()].points.push_back(chosen_point(judge, setting, ratio));
    chart.series[levels.size()].points.back().is_default = ratio == shown_default;
    chart.series.back().points.push_back(solved_point(setting, ratio, ratio, ratio * ratio));
  }
  const auto at = [&](std::size_t series, double ratio) {
    const std::vector<Point>& points = chart.series[series].points;
    return std::find_if(points.begin(), points.end(),
                        [&](const Point& point) { return point.parameter == ratio; })
        ->error;
  };
  chart.lesson = fmt::format(
      "Rigid bodies miss r^2 of the stress, {:.1g} at r = 0.1 and {:.1g} at r = 0.3; one mode with "
      "static correction leaves {:.1e} there, and {:.1e} at r = 2, beyond its own frequency.",
      at(0, 0.1), at(0, shown_default), at(1, shown_default), at(1, 2.0));
  return chart;
}

constexpr const char* cost_name = "model-cost";
constexpr const char* cost_title = "Models of the elasticity: what they cost";

/// Error against size and time of the models, on the scene.
Chart cost_chart(const Scene& scene, const Judge& judge, const Effort& effort) {
  Chart chart = stress_chart(cost_name, cost_title);
  chart.scene = scene.name;
  chart.operations = "coordinates of the division, three per rigid element";
  chart.unit = "stresses of the beam by a model";
  std::vector<TriedMethod> methods;
  const auto begin = [&](const std::string& method) { methods.push_back({method, {}, false}); };
  const auto add = [&](const ElasticModel& model, const std::string& setting = "") {
    const std::string parts = fmt::format("{} parts per link", model.parts);
    methods.back().trials.push_back(
        {judged(judge, model, setting.empty() ? parts : setting, model.parts,
                coordinates(judge.of, model)),
         [&judge, model] { keep(stresses_by(judge.of, model, judge.places)); }});
  };
  begin("rigid bodies");
  add({}, "rigid");
  const std::vector<int> divisions =
      effort.quick ? std::vector{2, 4, 8, 16} : std::vector{2, 3, 4, 6, 8, 12, 16, 24, 32};
  begin("quasi-static");
  for (const int parts : divisions) add(quasi_static(parts));
  for (const int modes : {1, 2, 4, 8, 16}) {
    begin(fmt::format("modal, {} mode{}", modes, modes == 1 ? "" : "s"));
    for (const int parts : divisions) {
      const bool as_many = 3.0 * modes <= coordinates(judge.of, modal(modes, parts));
      if (as_many) add(modal(modes, parts));
    }
  }
  begin("all elements");
  for (const int parts : divisions) add(all_elements(parts));
  begin("chosen by boxbeam for 1 %");
  try {
    const ElasticModel chosen = climb_ladder(judge.of, tolerance).chosen;
    add(chosen, describe(chosen));
    Point& point = methods.back().trials.back().point;
    point.is_default = true;
    const double full = coordinates(judge.of, all_elements(64));
    chart.lesson = fmt::format(
        "For 1 % boxbeam takes {}: it leaves {:.1e} with {:.0f} coordinates where a division made "
        "fine to be safe, 64 parts per link, has {:.0f}, {:.2g} times as many. At one frequency "
        "all elements of a division are no more work than its modes, which pay over many.",
        point.setting, point.error, *point.operations, full, full / *point.operations);
  } catch (const AnalysisError& error) {
    methods.back().trials.push_back(
        {failed_point("1 %", reference_parts, coordinates(judge.of, all_elements(reference_parts)),
                      error.failure().what),
         {}});
    chart.lesson = "No model is within 1 %: " + error.failure().what;
  }
  chart.series = timed(methods, effort);
  return chart;
}

/// Whether what the program says of its model is true, over the tolerance that is asked for.
Chart tolerance_chart(const Scene& scene, const Judge& judge, const Effort& effort) {
  Chart chart = stress_chart("model-tolerance", "Models of the elasticity: error asked and found");
  chart.scene = scene.name;
  chart.operations = "tolerance that is asked for";
  chart.operations_cost = false;
  chart.series = {{"error of the model chosen", {}, false},
                  {"as boxbeam finds it, by a finer model", {}, false},
                  {"as it is estimated before", {}, false},
                  {"tolerance", {}, true}};
  const std::vector<double> tolerances =
      effort.quick ? std::vector{1e-1, tolerance, 1e-3}
                   : std::vector{1e-1, 5e-2, 2e-2, tolerance, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4};
  double nearest = 0.0;
  for (const double asked : tolerances) {
    const std::string setting = fmt::format("{:g} %", 100.0 * asked);
    chart.series[3].points.push_back(solved_point(setting, asked, asked, asked));
    try {
      const ModelChoice choice = climb_ladder(judge.of, asked);
      const ModelEstimate& last = choice.weighed.back();
      const std::string text = fmt::format("{}: {}", setting, chosen_text(choice));
      chart.series[0].points.push_back(judged(judge, choice.chosen, text, asked, asked));
      chart.series[0].points.back().is_default = asked == tolerance;
      chart.series[1].points.push_back(solved_point(text, asked, asked, *last.found));
      chart.series[2].points.push_back(solved_point(text, asked, asked, last.error));
      nearest = std::max(nearest, chart.series[0].points.back().error / asked);
    } catch (const AnalysisError& error) {
      for (std::size_t i = 0; i < 3; ++i) {
        chart.series[i].points.push_back(failed_point(setting, asked, asked, error.failure().what));
      }
    }
  }
  chart.lesson = fmt::format(
      "The model that is chosen keeps the tolerance wherever there is one, at most {:.2g} of it; "
      "what the program says of its error is no less than the error.",
      nearest);
  return chart;
}

/// Digits of the governing stress over slenderness and frequency.
Map choice_map(const Effort& effort) {
  Map map;
  map.name = "model-slenderness";
  map.title = "Digits of the governing stress by models of the elasticity";
  map.scene = "steel box cantilevers, force at the end";
  map.reference =
      fmt::format("all elements, {} parts; more than 1 % off is wrong", reference_parts);
  map.x = {"frequency of the load over the first natural one, r", true};
  map.y = {"length over height", true};
  map.value = "digits";
  map.panels = {{"chosen by boxbeam for 1 %", {}, false},
                {"rigid bodies, whatever the frequency", {}, true},
                {"one mode, whatever the frequency", {}, true}};
  const std::vector<double> slendernesses =
      effort.quick ? std::vector{5.0, 20.0, 80.0} : std::vector{5.0, 10.0, 20.0, 40.0, 80.0};
  const std::vector<double> ratios = effort.quick
                                         ? std::vector{0.03, 0.3, 0.9, 3.0}
                                         : std::vector{0.01, 0.03, 0.05, 0.08, 0.12, 0.2, 0.3, 0.5,
                                                       0.9,  0.97, 1.03, 1.5,  2.0,  3.0, 5.0};
  for (const double slenderness : slendernesses) {
    Scene scene = cantilever(slenderness);
    for (const double ratio : ratios) {
      scene.mechanism.frequency = ratio * scene.first;
      const Judge judge(scene);
      const auto cell_by = [&](const std::function<ElasticModel()>& model) {
        Cell cell{ratio, slenderness, Outcome::solved, {}, ""};
        try {
          const double error = judge.error_of(model());
          cell.value = std::clamp(-std::log10(error), 0.0, 16.0);
          if (error > tolerance) cell.outcome = Outcome::wrong;
        } catch (const AnalysisError& error) {
          cell.outcome = Outcome::refused;
          cell.reason = error.failure().what;
        }
        return cell;
      };
      map.panels[0].cells.push_back(
          cell_by([&] { return climb_ladder(judge.of, tolerance).chosen; }));
      map.panels[1].cells.push_back(cell_by([] { return ElasticModel{}; }));
      map.panels[2].cells.push_back(cell_by([] { return modal(1, 16); }));
    }
  }
  map.lesson = fmt::format(
      "Rigid bodies are off by more than 1 % in {} of {} trials, one mode in {}; what boxbeam "
      "chooses in {}. How slender the beam is matters little: what decides is the frequency.",
      map.panels[1].count(Outcome::wrong), map.panels[1].cells.size(),
      map.panels[2].count(Outcome::wrong), map.panels[0].count(Outcome::wrong));
  return map;
}

}  // namespace

TopicResult model(const Scenes& scenes, const Effort& effort) {
  const Scene scene = scene_of(scenes);
  TopicResult result;
  result.charts.push_back(level_chart(effort));
  try {
    const Judge judge(scene);
    result.charts.push_back(cost_chart(scene, judge, effort));
    result.charts.push_back(tolerance_chart(scene, judge, effort));
  } catch (const AnalysisError& error) {
    Chart chart = stress_chart(cost_name, cost_title);
    chart.scene = scene.name;
    result.charts.push_back(without_answer(std::move(chart), error.failure().what));
  }
  result.maps.push_back(choice_map(effort));
  return result;
}

}  // namespace boxbeam::charts
