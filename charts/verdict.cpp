#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/verify.hpp"
#include "charts/points.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

constexpr double tolerance = 0.01;  ///< of a case that says nothing else
constexpr double reference_tolerance = 1e-4;

/// The factor that decides the verdict, over what is required of it.
double governing_of(const Project& project) {
  const Verification verification = verify(project);
  if (verification.checks.empty()) throw AnalysisError({"nothing is checked", project.name});
  return 1.0 / verification.checks.front().check.utilisation();
}

Project by_model(Project project, ModelDemand demand, double within = tolerance) {
  project.model.demand = demand;
  project.model.tolerance = within;
  return project;
}

/// Elastic links in so many parts.
Project divided(Project project, int parts, flexible::Element element) {
  for (flexible::Link& link : flexible_of(project).links) link.parts = parts;
  flexible_of(project).element = element;
  return by_model(std::move(project), ModelDemand::flexible);
}

/// A chart of one case against one of its models.
class VerdictChart {
 public:
  VerdictChart(const Project& of, const Project& reference, const std::string& by)
      : factor_(governing_of(reference)) {
    chart_.name = "verdict-" + of.name;
    chart_.title = fmt::format("The verdict of {}: what it costs", of.name);
    chart_.scene = of.name;
    chart_.error = "relative error of the governing factor";
    chart_.reference = fmt::format("{}: {:.4f}", by, factor_);
    chart_.unit = "verification of the case, read and without report";
    chart_.floor = {reference_tolerance, "what the reference is sure of"};
    chart_.needed_low = 1e-3;
    chart_.needed_high = tolerance;
  }

  void begin(const std::string& method) { methods_.push_back({method, {}, false}); }

  void add(const Project& project, const std::string& setting, double parameter,
           bool is_default = false) {
    Trial trial;
    try {
      const double error =
          std::max(reference_tolerance, std::abs(governing_of(project) / factor_ - 1.0));
      trial = {{setting, parameter, {}, {}, error, "", is_default},
               [project] { keep(governing_of(project)); }};
    } catch (const AnalysisError& error) {
      trial.point = {setting, parameter, {}, {}, 0.0, error.failure().what, is_default};
    }
    methods_.back().trials.push_back(std::move(trial));
  }

  Chart done(const Effort& effort) {
    chart_.series = timed(methods_, effort);
    const Point* const chosen = default_point(chart_);
    const Point& rigid = chart_.series.front().points.front();
    if (chosen != nullptr && chosen->failure.empty() && rigid.failure.empty())
      chart_.lesson = fmt::format(
          "Rigid bodies alone are off by {:.2g} of the factor; what boxbeam chooses for 1 % is off "
          "by {:.2g}, in {:.3g} times their time, in which it also finds out how far it is off.",
          rigid.error, chosen->error, chosen->time->median / rigid.time->median);
    return std::move(chart_);
  }

 private:
  double factor_;
  Chart chart_;
  std::vector<TriedMethod> methods_;
};

void add_chosen(VerdictChart& chart, const Project& project, const Effort& effort) {
  chart.begin("chosen by boxbeam for a tolerance");
  const std::vector<double> all =
      effort.quick ? std::vector{0.1, tolerance} : std::vector{0.1, tolerance, 1e-3};
  for (const double within : all)
    chart.add(by_model(project, ModelDemand::automatic, within),
              fmt::format("{:g} %", 100.0 * within), within, within == tolerance);
}

Chart of_mechanism(const Project& project, const Effort& effort) {
  VerdictChart chart(project, by_model(project, ModelDemand::flexible, reference_tolerance),
                     fmt::format("the beam elastic, within {:g} %", 100.0 * reference_tolerance));
  chart.begin("rigid bodies, not estimated");
  chart.add(by_model(project, ModelDemand::rigid), "rigid", 1.0);
  if (project.chain) {
    Project published = by_model(project, ModelDemand::rigid);
    published.dynamics = Dynamics::newton_chain;
    chart.begin("chain of a published calculation");
    chart.add(published, "chain", 1.0);
  }
  chart.begin("elastic beam, whatever it needs");
  chart.add(by_model(project, ModelDemand::flexible), "elastic", 1.0);
  add_chosen(chart, project, effort);
  return chart.done(effort);
}

Chart of_elastic_links(const Project& project, const Effort& effort) {
  using flexible::Element;
  // With the elasticity along the axis, which the links of the case leave out.
  VerdictChart chart(project, by_model(project, ModelDemand::automatic, reference_tolerance),
                     fmt::format("chosen for {:g} %", 100.0 * reference_tolerance));
  chart.begin("rigid links, elastic joints");
  chart.add(by_model(project, ModelDemand::rigid), "rigid", 1.0);
  const std::vector<int> parts = effort.quick ? std::vector{2, 8} : std::vector{2, 4, 8, 16, 32};
  for (const Element element : {Element::classical, Element::corrected}) {
    chart.begin(element == Element::classical ? "classical rigid elements"
                                              : "corrected rigid elements");
    for (const int count : parts)
      chart.add(divided(project, count, element), fmt::format("{} parts per link", count), count);
  }
  add_chosen(chart, project, effort);
  return chart.done(effort);
}

}  // namespace

TopicResult verdict(const Scenes& scenes, const Effort& effort) {
  TopicResult result;
  if (scenes.planar) result.charts.push_back(of_mechanism(*scenes.planar, effort));
  if (scenes.flexible) result.charts.push_back(of_elastic_links(*scenes.flexible, effort));
  if (result.charts.empty()) result.not_applicable = scenes.missing;
  return result;
}

}  // namespace boxbeam::charts
