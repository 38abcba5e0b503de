#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/verify.hpp"
#include "charts/points.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

constexpr double reference_tolerance = 1e-4;

/// The factor that decides the verdict, over what is required of it.
double governing_of(const Verification& verification) {
  if (verification.checks.empty()) throw AnalysisError({"nothing is checked", "beam"});
  return 1.0 / verification.checks.front().check.utilisation();
}

double governing_of(const Project& project) { return governing_of(verify(project)); }

/// The same by one model, whatever it misses and without asking: what a user pays who knows which.
double governing_by(const Project& project, const ElasticModel& model, ModelChoice choice) {
  choice.chosen = model;
  return governing_of(judge(project, run_situations(project, model), std::move(choice)));
}

Project by_model(Project project, ModelDemand demand) {
  project.model.demand = demand;
  return project;
}

Project by_model(Project project, ModelDemand demand, double within) {
  project.model.tolerance = within;
  return by_model(std::move(project), demand);
}

/// Elastic links in so many parts.
Project divided(Project project, int parts, flexible::Element element) {
  for (flexible::Link& link : flexible_of(project).links) link.parts = parts;
  flexible_of(project).element = element;
  return by_model(std::move(project), ModelDemand::flexible);
}

/// The finest that the program computes of a case, what it chose for that, and how sure it is of
/// it.
struct Finest {
  double factor = 0.0;
  ModelChoice choice;
  double within = 0.0;
};

/// Whether a choice is known, as far as it was weighed, to miss no more.
bool is_within(const ModelChoice& choice, double tolerance) {
  for (const ModelEstimate& of : choice.weighed) {
    const ElasticModel &a = of.model, &b = choice.chosen;
    if (std::tie(a.level, a.modes, a.parts, a.element, a.axial) !=
        std::tie(b.level, b.modes, b.parts, b.element, b.axial))
      continue;
    if (of.found.value_or(of.error) > tolerance) return false;
  }
  return true;
}

/// The finest of the models demanded, or what the program chooses for the case, if these are more
/// than rigid bodies; else nothing, and in `refused` why.
std::optional<Finest> finest_of(const Project& project, ModelDemand demand, std::string& refused) {
  const double own = project.model.tolerance;
  const auto found = [&](ModelDemand by, double within) -> std::optional<Finest> {
    try {
      Verification of = verify(by_model(project, by, within));
      if (of.model.chosen.level != ModelLevel::rigid && is_within(of.model, within))
        return Finest{governing_of(of), std::move(of.model), within};
      refused = of.model.reason;
    } catch (const AnalysisError& error) {
      refused = error.failure().what;
    }
    return std::nullopt;
  };
  for (const double within : {reference_tolerance, 0.1 * own, 0.3 * own, own}) {
    if (std::optional<Finest> finest = found(demand, within)) return finest;
  }
  return found(ModelDemand::automatic, own);
}

/// A chart of one case against one of its models.
class VerdictChart {
 public:
  VerdictChart(const Project& of, const Finest& finest, const std::string& by)
      : factor_(finest.factor), sure_(finest.within) {
    chart_.name = "verdict-" + of.name;
    chart_.title = fmt::format("The verdict of {}: what it costs", of.name);
    chart_.scene = of.name;
    chart_.error = "relative error of the governing factor";
    chart_.reference = fmt::format("{} {:g} %: {:.4f}", by, 100.0 * sure_, factor_);
    chart_.unit = "verification of the case, read and without report";
    chart_.floor = {sure_, "what the reference is sure of"};
    chart_.needed_low = 0.1 * of.model.tolerance;
    chart_.needed_high = of.model.tolerance;
  }

  /// Why the default is not on the front, where it is not.
  void leave_front(const std::string& why) { chart_.off_front = why; }

  /// `yardstick`: the program does not offer it.
  void begin(const std::string& method, bool yardstick = false) {
    methods_.push_back({method, {}, yardstick});
  }

  /// `governing`: finds the factor that decides.
  void add(const std::function<double()>& governing, const std::string& setting, double parameter,
           bool is_default = false) {
    Trial trial;
    try {
      const double error = std::max(sure_, std::abs(governing() / factor_ - 1.0));
      trial = {{setting, parameter, {}, {}, error, "", is_default},
               [governing] { keep(governing()); }};
    } catch (const AnalysisError& error) {
      trial.point = {setting, parameter, {}, {}, 0.0, error.failure().what, is_default};
    }
    methods_.back().trials.push_back(std::move(trial));
  }

  void add(const Project& project, const std::string& setting, double parameter,
           bool is_default = false) {
    add([project] { return governing_of(project); }, setting, parameter, is_default);
  }

  Chart done(const Effort& effort) {
    chart_.series = timed(methods_, effort);
    const Point* const chosen = default_point(chart_);
    const Point& rigid = chart_.series.front().points.front();
    if (chosen != nullptr && chosen->failure.empty() && rigid.failure.empty())
      chart_.lesson = fmt::format(
          "Rigid bodies alone are off by {:.2g} of the factor; what boxbeam chooses for {} is off "
          "by {:.2g}, in {:.3g} times their time, in which it also finds out how far it is off.",
          rigid.error, chosen->setting, chosen->error, chosen->time->median / rigid.time->median);
    return std::move(chart_);
  }

 private:
  double factor_, sure_;
  Chart chart_;
  std::vector<TriedMethod> methods_;
};

void add_chosen(VerdictChart& chart, const Project& project, const Effort& effort) {
  chart.begin("chosen by boxbeam for a tolerance");
  const double own = project.model.tolerance;
  const std::vector<double> all =
      effort.quick ? std::vector{10.0 * own, own} : std::vector{10.0 * own, own, 0.1 * own};
  for (const double within : all)
    chart.add(by_model(project, ModelDemand::automatic, within),
              fmt::format("{:g} %", 100.0 * within), within, within == own);
}

/// What bends statically, and ever more modes, each as if it were known to be enough.
void add_rungs(VerdictChart& chart, const Project& project, const ModelChoice& finest,
               const Effort& effort) {
  const auto add = [&](const ElasticModel& model, const std::string& setting, int parameter) {
    chart.add([=] { return governing_by(project, model, finest); }, setting, parameter);
  };
  chart.begin("bent statically, not estimated", true);
  ElasticModel model;
  model.level = ModelLevel::quasi_static;
  add(model, "bent statically", 1);
  chart.begin("so many modes, not estimated", true);
  model = finest.chosen;
  if (model.level != ModelLevel::modal) model = {ModelLevel::modal, 1, 8, {}, false, false};
  const std::vector<int> modes = effort.quick ? std::vector{1, 3} : std::vector{1, 2, 3, 4, 6, 8};
  for (const int count : modes) {
    model.modes = count;
    add(model, fmt::format("{} mode{}", count, count == 1 ? "" : "s"), count);
  }
}

Chart of_mechanism(const Project& project, const Finest& finest, const Effort& effort) {
  VerdictChart chart(project, finest, "elastic, within");
  chart.leave_front(
      "Models that are not estimated do not say how far they are off; that costs the difference.");
  chart.begin("rigid bodies, not estimated");
  chart.add(by_model(project, ModelDemand::rigid), "rigid", 1.0);
  if (project.chain) {
    Project published = by_model(project, ModelDemand::rigid);
    published.dynamics = Dynamics::newton_chain;
    chart.begin("chain of a published calculation");
    chart.add(published, "chain", 1.0);
  }
  add_rungs(chart, project, finest.choice, effort);
  chart.begin("elastic beam, whatever it needs");
  chart.add(by_model(project, ModelDemand::flexible), "elastic", 1.0);
  add_chosen(chart, project, effort);
  return chart.done(effort);
}

Chart of_elastic_links(const Project& project, const Finest& finest, const Effort& effort) {
  using flexible::Element;
  // With the elasticity along the axis, which the links of the case leave out.
  VerdictChart chart(project, finest, "chosen for");
  chart.begin("rigid links, elastic joints");
  chart.add(by_model(project, ModelDemand::rigid), "rigid", 1.0);
  const std::vector<int> parts = effort.quick ? std::vector{2, 8} : std::vector{2, 4, 8, 16, 32};
  for (const Element element : {Element::classical, Element::corrected}) {
    chart.begin(element == Element::classical ? "classical rigid elements"
                                              : "corrected rigid elements");
    for (const int count : parts)
      chart.add(divided(project, count, element), fmt::format("{} parts per link", count), count);
  }
  chart.begin("exact links, without elasticity along the axis");
  chart.add(divided(project, 2, Element::exact), "exact", 1.0);
  add_chosen(chart, project, effort);
  return chart.done(effort);
}

void add_chart(const Project& project, const Effort& effort, TopicResult& result) {
  const bool links = std::holds_alternative<flexible::Mechanism>(project.mechanism);
  const ModelDemand demand = links ? ModelDemand::automatic : ModelDemand::flexible;
  std::string refused;
  const std::optional<Finest> finest = finest_of(project, demand, refused);
  if (!finest) {
    result.not_applicable = refused;
    return;
  }
  result.charts.push_back(links ? of_elastic_links(project, *finest, effort)
                                : of_mechanism(project, *finest, effort));
}

}  // namespace

TopicResult verdict(const Scenes& scenes, const Effort& effort) {
  TopicResult result;
  for (const std::optional<Project>* scene : {&scenes.planar, &scenes.flexible})
    if (*scene) add_chart(**scene, effort, result);
  // Neither of rigid bodies in the plane nor of elastic links: the case that the user named.
  if (!scenes.planar && !scenes.flexible && scenes.beam) add_chart(*scenes.beam, effort, result);
  return result;
}

}  // namespace boxbeam::charts
