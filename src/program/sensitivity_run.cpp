#include "program/sensitivity_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/case_document.hpp"
#include "boxbeam/study/case_keys.hpp"
#include "program/design_trial.hpp"

namespace boxbeam::program {
namespace {

/// The governing factor of every criterion that is judged, the least of all beams.
std::map<Criterion, double> factors_of(const std::vector<VerifiedBeam>& beams) {
  std::map<Criterion, double> factors;
  for (const VerifiedBeam& beam : beams) {
    for (const CheckResult& result : beam.verification.checks) {
      const Check& check = result.check;
      if (!std::isfinite(check.safety_factor)) continue;
      const auto [at, first] = factors.emplace(check.criterion, check.safety_factor);
      if (!first) at->second = std::min(at->second, check.safety_factor);
    }
  }
  return factors;
}

/// Criteria that are judged, the most used first.
std::vector<Criterion> criteria_of(const std::vector<VerifiedBeam>& beams) {
  std::vector<std::pair<double, Criterion>> all;
  for (const auto& [criterion, factor] : factors_of(beams)) {
    double use = 0.0;
    for (const VerifiedBeam& beam : beams)
      if (const CheckResult* const worst = beam.verification.governing(criterion))
        use = std::max(use, worst->check.utilisation());
    all.emplace_back(use, criterion);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Criterion> order;
  for (const auto& [use, criterion] : all) order.push_back(criterion);
  return order;
}

}  // namespace

Sensitivities sensitivities_of(const CaseOptions& options, const std::vector<VerifiedBeam>& beams,
                               Progress& progress) {
  const std::map<Criterion, double> as_it_is = factors_of(beams);
  const std::vector<std::string> keys = number_keys(read_document(options.file, options.set).root);
  const CaseDocument document = read_document(options.file, options.set);
  std::vector<Sensitivity> inputs;
  for (const std::string& key : keys) {
    const WrittenQuantity value = *quantity_written_in(*value_at(document.root, key));
    if (value.value != 0.0) inputs.push_back({key, value, {}});
  }
  const DesignTrials trials(options);
  std::atomic<std::size_t> next{0}, done{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < inputs.size(); i = next++) {
      Sensitivity& input = inputs[i];
      input.slopes = slopes_of(as_it_is, [&](double factor) {
        std::optional<std::map<Criterion, double>> factors;
        trouble_of([&] {
          const WrittenQuantity changed{factor * input.value.value, input.value.unit};
          factors =
              factors_of(trials.verify({fmt::format("{}={}", input.key, to_text(changed))}).beams);
        });
        return factors;
      });
      ++done;
    }
  };
  {
    std::vector<std::jthread> workers;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
      workers.emplace_back(work);
    while (done < inputs.size()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      progress.now(fmt::format("sensitivities, {} of {} inputs", done.load(), inputs.size()));
    }
  }
  Sensitivities of;
  of.criteria = criteria_of(beams);
  for (Sensitivity& input : inputs) {
    if (input.slopes.empty())
      of.not_verified.push_back(input.key);
    else if (input.has_no_effect())
      ++of.without_effect;
    else
      of.inputs.push_back(std::move(input));
  }
  const auto slope = [&](const Sensitivity& input) {
    const auto found =
        of.criteria.empty() ? input.slopes.end() : input.slopes.find(of.criteria.front());
    return found == input.slopes.end() ? 0.0 : std::abs(found->second.value());
  };
  std::stable_sort(of.inputs.begin(), of.inputs.end(),
                   [&](const Sensitivity& a, const Sensitivity& b) { return slope(a) > slope(b); });
  return of;
}

}  // namespace boxbeam::program
