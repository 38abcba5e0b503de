#include "program/optimise_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/files.hpp"
#include "boxbeam/report/optimum_report.hpp"
#include "boxbeam/report/study_document.hpp"
#include "program/best_design.hpp"
#include "program/exit_code.hpp"
#include "program/outputs.hpp"
#include "program/progress.hpp"
#include "program/terminal.hpp"
#include "report/text_layout.hpp"
#include "report/unfinished.hpp"

namespace boxbeam::program {
namespace {

/// Designs that were judged, so that none is twice.
class Memory {
 public:
  std::optional<Judged> find(const std::vector<double>& chosen) {
    const std::lock_guard lock(mutex_);
    const auto found = known_.find(chosen);
    return found == known_.end() ? std::nullopt : std::optional(found->second);
  }
  const std::map<std::vector<double>, Judged>& all() const { return known_; }
  /// How many there are.
  std::size_t keep(const std::vector<double>& chosen, const Judged& judged) {
    constexpr std::size_t most = 200'000;
    const std::lock_guard lock(mutex_);
    if (known_.size() < most) known_.emplace(chosen, judged);
    return ++count_;
  }

 private:
  std::mutex mutex_;
  std::map<std::vector<double>, Judged> known_;
  std::size_t count_ = 0;
};

class Optimising {
 public:
  Optimising(const BestDesign& problem, std::size_t threads, Progress& progress)
      : problem_(&problem), threads_(threads), progress_(&progress) {}

  /// The least of one goal, of the other no more than so much.
  Optimum least(std::size_t goal, std::optional<double> of_other = {}) {
    OptimumQuestion question;
    question.choices = problem_->choices();
    question.limits = problem_->limits();
    if (of_other) question.limits.push_back("the other goal");
    question.threads = threads_;
    question.starts = problem_->demand().starts;
    question.designs = problem_->demand().designs;
    question.seed = problem_->study().seed;
    question.make = [=, this] {
      return [=, this,
              judge = std::make_shared<DesignJudge>(*problem_)](const std::vector<double>& chosen) {
        return worth(*judge, chosen, goal, of_other);
      };
    };
    return optimum_of(question);
  }

  /// All designs that were judged, by their values.
  DesignRows judged() const {
    std::vector<Column> columns;
    for (std::size_t i = 0; i < problem_->choices().size(); ++i)
      columns.push_back({problem_->choices()[i].name, problem_->units()[i]});
    const std::size_t variables = columns.size();
    for (const std::string& goal : problem_->demand().minimise)
      columns.push_back({goal, problem_->goal_unit(goal)});
    if (problem_->demand().checks) columns.push_back({"utilisation", ""});
    columns.push_back({"verdict", ""});
    DesignSample sample(columns, variables, memory_.all().size(), problem_->study().seed);
    std::size_t place = 0;
    for (const auto& [values, judged] : memory_.all()) {
      if (!sample.wants(place++)) continue;
      std::vector<std::string> cells;
      for (const double value : values) cells.push_back(fmt::format("{}", value));
      cells.resize(columns.size());
      if (judged.trouble.empty()) put_results(judged, variables, cells);
      sample.take(place, cells, judged.trouble.empty() ? "ok" : judged.trouble);
    }
    return sample.rows();
  }

  /// Between the least of the one and the least of the other in equal steps of the second.
  std::vector<FrontPoint> front(const Optimum& first) {
    std::vector<FrontPoint> points;
    const Optimum second = least(1);
    if (!first.best || !second.best) return points;
    const double most = goals_at(*first.best)[1], fewest = second.best->goal;
    const std::size_t count = problem_->demand().points;
    for (std::size_t k = 0; k < count; ++k) {
      const double part = static_cast<double>(k) / static_cast<double>(count - 1);
      const Optimum between = k == 0           ? first
                              : k + 1 == count ? second
                                               : least(0, most + part * (fewest - most));
      if (between.best) points.push_back({between.best->values, goals_at(*between.best)});
    }
    std::sort(points.begin(), points.end(),
              [](const FrontPoint& a, const FrontPoint& b) { return a.goals < b.goals; });
    std::vector<FrontPoint> kept;
    for (FrontPoint& point : points)
      if (kept.empty() || point.goals[1] < kept.back().goals[1]) kept.push_back(std::move(point));
    return kept;
  }

 private:
  void put_results(const Judged& judged, std::size_t place, std::vector<std::string>& cells) const {
    for (const double goal : judged.goals) cells[place++] = fmt::format("{}", goal);
    if (problem_->demand().checks) {
      const auto end = judged.margins.begin() + static_cast<std::ptrdiff_t>(std::size(criteria));
      const double margin = *std::min_element(judged.margins.begin(), end);
      cells[place++] = fmt::format("{}", margin >= 0.0 ? 1.0 - margin : std::exp(-margin));
    }
    constexpr double rounding = -1e-9;
    const bool keeps = std::all_of(judged.margins.begin(), judged.margins.end(),
                                   [](double margin) { return margin >= rounding; });
    cells[place] = keeps ? "pass" : "fail";
  }

  Worth worth(DesignJudge& judge, const std::vector<double>& chosen, std::size_t goal,
              std::optional<double> of_other) {
    std::optional<Judged> judged = memory_.find(chosen);
    if (!judged) {
      judged = judge.at(chosen);
      const std::size_t count = memory_.keep(chosen, *judged);
      if (problem_->has_case()) say(count);
    }
    if (!judged->trouble.empty()) return {0.0, {}, judged->trouble};
    Worth worth{judged->goals[goal], judged->margins, ""};
    if (of_other) {
      const double other = judged->goals[1 - goal];
      const double size = std::max({std::abs(*of_other), std::abs(other), 1e-300});
      worth.margins.push_back((*of_other - other) / size);
    }
    return worth;
  }

  std::vector<double> goals_at(const ChosenDesign& design) {
    const std::optional<Judged> known = memory_.find(design.values);
    return known ? known->goals : DesignJudge(*problem_).at(design.values).goals;
  }

  void say(std::size_t count) {
    const std::lock_guard lock(mutex_);
    progress_->now(fmt::format("verification {}", count));
  }

  const BestDesign* problem_;
  std::size_t threads_;
  Progress* progress_;
  std::mutex mutex_;  ///< of the progress
  Memory memory_;
};

OptimumReport report_of(const BestDesign& problem, Optimum optimum, std::vector<FrontPoint> front) {
  OptimumReport report;
  report.study = problem.study().path;
  for (const std::string& goal : problem.demand().minimise)
    report.goals.push_back({goal, problem.goal_unit(goal)});
  report.choices = problem.choices();
  report.units = problem.units();
  report.optimum = std::move(optimum);
  report.front = std::move(front);
  if (!report.optimum.best) return report;
  const std::vector<Setting> design = problem.settings_of(report.optimum.best->values);
  for (std::size_t i = 0; i < design.size(); ++i) {
    const Variable& variable = problem.study().variables[i];
    if (!variable.expression.empty())
      report.following.push_back({{variable.name, variable.unit}, design[i].number});
  }
  if (!problem.has_case()) return report;
  const VerifiedDesign found = problem.verified(design);
  const Verification& worst = worst_of(found.beams).verification;
  report.verdict = to_text(worst.verdict);
  for (const VerifiedBeam& beam : found.beams)
    for (const NotJudged& missing : beam.verification.not_judged)
      report.not_judged.push_back(fmt::format("{}: {}", missing.what, missing.reason));
  if (!worst.checks.empty()) {
    report.governing = worst.checks.front().check.id;
    report.utilisation = worst.checks.front().check.utilisation();
  }
  return report;
}

void write_folder(const OptimumReport& report, const std::string& folder) {
  report::FolderUpdate update(folder);
  write_file(update.path() + "/optimum.json", optimum_json(report));
  draw_optimum(report, update.path());
  write_page("optimum.html", optimum_document(report), update.path());
  update.publish(files_of_optimum());
}

}  // namespace

int run_optimise(const OptimiseOptions& options) {
  report::clear_up_before_the_end();
  if (options.out.empty()) {
    require_file(options.json);
  } else {
    require_folder(options.out);
    require_file_beside(options.json, options.out);
  }
  const Study study = read_study(options.study);
  if (!study.optimise)
    throw InputError(fmt::format("{}: the study does not say what is to be least", study.path),
                     "write [optimise] with minimise = \"beam.mass\"");
  OptimumReport report;
  {
    Progress progress;
    if (!study.case_file.empty()) progress.now("verifying the case as it is");
    const BestDesign problem(study);
    const std::size_t threads =
        options.threads > 0 ? options.threads : std::max(1U, std::thread::hardware_concurrency());
    Optimising optimising(problem, threads, progress);
    Optimum optimum = optimising.least(0);
    std::vector<FrontPoint> front;
    if (study.optimise->minimise.size() == 2) front = optimising.front(optimum);
    report = report_of(problem, std::move(optimum), std::move(front));
    if (!options.out.empty()) report.judged = optimising.judged();
  }
  if (!options.out.empty()) write_folder(report, options.out);
  report::MarkedText text = optimum_text(report);
  if (!options.out.empty())
    text +=
        "\n" + layout::line(fmt::format("Written to {}: optimum.json, optimum.html", options.out));
  put_result(options.json, optimum_json(report), text);
  return report.optimum.best ? all_pass : check_fails;
}

}  // namespace boxbeam::program
