#include "boxbeam/study/optimum.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <map>
#include <mutex>
#include <thread>

#include "boxbeam/study/design_space.hpp"
#include "local_optimum.hpp"

namespace boxbeam {
namespace {

using Steps = std::vector<std::size_t>;  ///< of each list, which of its values

/// `better`: keeps its limits and has less of the goal, or is less far beyond them.
bool is_better(const Worth& one, const Worth& other) {
  const double beyond = violation_of(one), of_other = violation_of(other);
  if (beyond != of_other) return beyond < of_other;
  return beyond < std::numeric_limits<double>::infinity() && one.goal < other.goal;
}

/// What is asked of one combination of lists.
class Designs {
 public:
  explicit Designs(const OptimumQuestion& question) : question_(&question) {
    for (std::size_t i = 0; i < question.choices.size(); ++i)
      (question.choices[i].values.empty() ? free_ : listed_).push_back(i);
    combinations_ = 1.0;
    for (const std::size_t i : listed_)
      combinations_ *= static_cast<double>(question.choices[i].values.size());
  }

  bool has_bounds() const { return !free_.empty(); }
  bool has_lists() const { return !listed_.empty(); }
  double combinations() const { return combinations_; }
  std::size_t lists() const { return listed_.size(); }
  std::size_t length(std::size_t list) const {
    return question_->choices[listed_[list]].values.size();
  }

  /// The last list changes first.
  Steps combination(std::size_t index) const {
    Steps steps(lists());
    for (std::size_t k = lists(); k-- > 0;) {
      steps[k] = index % length(k);
      index /= length(k);
    }
    return steps;
  }

  /// A start: the first in the middle, the others anywhere.
  std::vector<double> start(std::size_t index) const {
    std::vector<double> values(question_->choices.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Choice& of = question_->choices[i];
      constexpr double middle = 0.5;
      const double share =
          index == 0 ? middle
                     : uniform_number(question_->seed, index, static_cast<std::uint32_t>(i));
      if (of.values.empty())
        values[i] = of.from + share * (of.to - of.from);
      else
        values[i] =
            of.values[static_cast<std::size_t>(share * static_cast<double>(of.values.size()))];
    }
    return values;
  }

  Steps steps_of(const std::vector<double>& values) const {
    Steps steps;
    for (const std::size_t i : listed_) {
      const std::vector<double>& list = question_->choices[i].values;
      steps.push_back(
          static_cast<std::size_t>(std::find(list.begin(), list.end(), values[i]) - list.begin()));
    }
    return steps;
  }

  std::vector<double> with(std::vector<double> values, const Steps& steps) const {
    for (std::size_t k = 0; k < lists(); ++k)
      values[listed_[k]] = question_->choices[listed_[k]].values[steps[k]];
    return values;
  }

  /// One step in one list, or one up and one down in two.
  std::vector<Steps> neighbours(const Steps& of) const {
    std::vector<Steps> all;
    for (std::size_t k = 0; k < lists(); ++k) {
      for (const bool up : {false, true}) {
        if (up ? of[k] + 1 >= length(k) : of[k] == 0) continue;
        Steps one = of;
        one[k] = up ? of[k] + 1 : of[k] - 1;
        all.push_back(one);
        for (std::size_t other = 0; other < lists(); ++other) {
          if (other == k || (up ? of[other] == 0 : of[other] + 1 >= length(other))) continue;
          Steps both = one;
          both[other] = up ? of[other] - 1 : of[other] + 1;
          all.push_back(both);
        }
      }
    }
    return all;
  }

 private:
  const OptimumQuestion* question_;
  std::vector<std::size_t> free_, listed_;  ///< choices by index
  double combinations_ = 1.0;
};

/// Does `count` tasks on the threads of the question, each thread with a function of its own.
void share_out(const OptimumQuestion& question, std::size_t count,
               const std::function<void(const OptimumQuestion::Function&, std::size_t)>& task) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr trouble;
  std::mutex of_trouble;
  const auto work = [&] {
    try {
      const OptimumQuestion::Function function = question.make();
      for (std::size_t i = next++; i < count; i = next++) task(function, i);
    } catch (...) {
      const std::lock_guard lock(of_trouble);
      if (!trouble) trouble = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < std::min(question.threads, count); ++i) helpers.emplace_back(work);
    work();
  }
  if (trouble) std::rethrow_exception(trouble);
}

class Search {
 public:
  explicit Search(const OptimumQuestion& question) : question_(&question), designs_(question) {}

  Optimum run() {
    optimum_.exhaustive =
        designs_.has_lists() && designs_.combinations() <= static_cast<double>(question_->designs);
    const std::size_t count = optimum_.exhaustive
                                  ? static_cast<std::size_t>(designs_.combinations())
                                  : std::max<std::size_t>(1, question_->starts);
    std::vector<LocalOptimum> found(count);
    std::vector<Tally> tallies(count);
    share_out(*question_, count, [&](const OptimumQuestion::Function& function, std::size_t i) {
      found[i] = optimum_.exhaustive ? of_combination(function, designs_.combination(i), tallies[i])
                 : designs_.has_lists()
                     ? descended(function, designs_.start(i), tallies[i])
                     : rough_optimum(*question_, function, designs_.start(i), tallies[i]);
    });
    Tally tally;
    for (const Tally& one : tallies) tally.add(one);
    LocalOptimum best = *std::min_element(
        found.begin(), found.end(),
        [](const LocalOptimum& a, const LocalOptimum& b) { return is_better(a.worth, b.worth); });
    if (!optimum_.exhaustive) count_agreeing(found, best);
    if (!designs_.has_lists()) best = exact_optimum(*question_, question_->make(), best, tally);
    conclude(best, tally);
    optimum_.evaluations = tally.evaluations;
    optimum_.troubled = tally.troubled;
    optimum_.first_trouble = tally.first_trouble;
    return optimum_;
  }

 private:
  /// Of one combination of lists the best there is.
  LocalOptimum of_combination(const OptimumQuestion::Function& function, const Steps& steps,
                              Tally& tally) const {
    constexpr std::size_t starts = 2;
    LocalOptimum best;
    for (std::size_t i = 0; i < (designs_.has_bounds() ? starts : 1); ++i) {
      LocalOptimum found =
          rough_optimum(*question_, function, designs_.with(designs_.start(i), steps), tally);
      if (i == 0 || is_better(found.worth, best.worth)) best = std::move(found);
    }
    return designs_.has_bounds() ? exact_optimum(*question_, function, best, tally) : best;
  }

  /// From neighbour to better neighbour, the best of all first.
  LocalOptimum descended(const OptimumQuestion::Function& function, const std::vector<double>& from,
                         Tally& tally) const {
    std::map<Steps, LocalOptimum> known;
    const auto at = [&](const Steps& steps) -> const LocalOptimum& {
      const auto place = known.find(steps);
      if (place != known.end()) return place->second;
      return known.emplace(steps, of_combination(function, steps, tally)).first->second;
    };
    Steps here = designs_.steps_of(from);
    while (true) {
      Steps next = here;
      for (const Steps& beside : designs_.neighbours(here))
        if (is_better(at(beside).worth, at(next).worth)) next = beside;
      if (next == here) return at(here);
      here = next;
    }
  }

  void count_agreeing(const std::vector<LocalOptimum>& found, const LocalOptimum& best) {
    constexpr double same = 1e-4;  // before the last digits are found
    optimum_.starts = found.size();
    for (const LocalOptimum& one : found) {
      const double apart = std::abs(one.worth.goal - best.worth.goal);
      if (keeps_limits(one.worth) && apart <= same * std::max(1e-300, std::abs(best.worth.goal)))
        ++optimum_.agreeing;
    }
  }

  void conclude(const LocalOptimum& best, Tally& tally) {
    if (!keeps_limits(best.worth)) {
      optimum_.reason = why_none(best);
      return;
    }
    optimum_.best = ChosenDesign{best.values, best.worth.goal, best.worth.margins};
    optimum_.active = best.active;
    optimum_.confirmed = true;
    constexpr double balanced = 1e-3;
    if (designs_.has_bounds()) {
      optimum_.imbalance = best.imbalance;
      if (best.imbalance > balanced) {
        optimum_.confirmed = false;
        optimum_.reason =
            "the slopes of the goal and of what is active do not balance: a kink, or not the least "
            "yet; further starts tell";
      }
    }
    if (designs_.has_lists()) look_around(best, tally);
  }

  /// What a step along one list to less of the goal would break.
  void look_around(const LocalOptimum& best, Tally& tally) {
    const OptimumQuestion::Function function = question_->make();
    for (const Steps& beside : designs_.neighbours(designs_.steps_of(best.values))) {
      const Worth worth = worth_at(function, designs_.with(best.values, beside), tally);
      if (!worth.trouble.empty() || worth.goal >= best.worth.goal) continue;
      for (std::size_t j = 0; j < question_->limits.size(); ++j) {
        if (worth.margins[j] >= 0.0) continue;
        const std::string& name = question_->limits[j];
        const auto named = [&](const ActiveLimit& of) { return of.name == name; };
        if (std::none_of(optimum_.active.begin(), optimum_.active.end(), named))
          optimum_.active.push_back({name, ActiveLimit::Kind::limit, std::nullopt});
      }
    }
  }

  std::string why_none(const LocalOptimum& nearest) const {
    if (!nearest.worth.trouble.empty())
      return "no design that was tried can be judged: " + nearest.worth.trouble;
    std::string broken;
    for (std::size_t j = 0; j < question_->limits.size(); ++j) {
      if (nearest.worth.margins[j] >= 0.0) continue;
      broken += (broken.empty() ? "" : ", ") + question_->limits[j];
    }
    return "no design that was tried keeps all limits; the nearest does not keep " + broken;
  }

  const OptimumQuestion* question_;
  Designs designs_;
  Optimum optimum_;
};

}  // namespace

Optimum optimum_of(const OptimumQuestion& question) { return Search(question).run(); }

}  // namespace boxbeam
