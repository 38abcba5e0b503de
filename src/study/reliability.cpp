#include "boxbeam/study/reliability.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <numbers>

#include "boxbeam/study/distribution.hpp"
#include "boxbeam/study/series_system.hpp"
#include "simulations.hpp"

namespace boxbeam {
namespace {

using Eigen::VectorXd;

constexpr std::uint32_t stream_of_probes = 5;

/// Puts the probability of any of several half-spaces into a result, as that of failure.
void take_union(const std::vector<HalfSpace>& of, bool mean_fails, MethodResult& result) {
  const Bounds bounds = probability_of_any(of);
  result.converged = true;
  result.p_f = mean_fails ? 1.0 - bounds.high : bounds.high;
  result.low = mean_fails ? 1.0 - bounds.high : bounds.low;
  result.high = mean_fails ? 1.0 - bounds.low : bounds.high;
}

MethodResult first_order(const DesignPoints& found) {
  MethodResult result;
  result.method = ReliabilityMethod::form;
  result.reason = found.reason;
  if (found.points.empty()) return result;
  std::vector<HalfSpace> planes;
  for (const DesignPoint& point : found.points) planes.push_back({point.beta, point.alpha});
  take_union(planes, found.mean_fails, result);
  result.beta = (found.mean_fails ? -1.0 : 1.0) * found.points.front().beta;
  return result;
}

/// Phi(-beta) prod (1 + psi kappa_i)^(-1/2), nothing where a factor is not above zero.
/// psi = beta: Breitung, Journal of Engineering Mechanics 110 (1984); psi = phi(beta)/Phi(-beta):
/// Hohenbichler, Rackwitz, ibid. 114 (1988).
std::optional<double> bent(const DesignPoint& point, double psi) {
  double share = normal_share_below(-point.beta);
  for (const double curvature : point.curvatures) {
    const double factor = 1.0 + psi * curvature;
    if (!(factor > 0.0)) return std::nullopt;
    share /= std::sqrt(factor);
  }
  if (!(share > 0.0 && share < 1.0)) return std::nullopt;
  return share;
}

MethodResult second_order(const DesignPoints& found) {
  MethodResult result;
  result.method = ReliabilityMethod::sorm;
  result.reason = found.reason;
  if (found.points.empty()) return result;
  std::vector<HalfSpace> breitung, by_both;
  for (const DesignPoint& point : found.points) {
    const double of_normal = normal_share_below(-point.beta);
    const double psi =
        std::exp(-0.5 * point.beta * point.beta) / std::sqrt(2.0 * std::numbers::pi) / of_normal;
    const std::optional<double> first = bent(point, point.beta), second = bent(point, psi);
    if (point.kinked || !first || !second) {
      result.reason =
          point.kinked
              ? fmt::format("the limit state has a kink at the design point at {:.4f}", point.beta)
              : fmt::format(
                    "1 + psi kappa is not above zero at the design point at "
                    "{:.4f}: the limit state bends too much towards the origin",
                    point.beta);
      return result;
    }
    breitung.push_back({*reliability_index(*first), point.alpha});
    by_both.push_back({*reliability_index(*second), point.alpha});
  }
  take_union(by_both, found.mean_fails, result);
  // Of the rarer side, whose probability is not lost beside 1.
  const std::optional<double> rarer = reliability_index(probability_of_any(by_both).high);
  if (rarer) result.beta = found.mean_fails ? -*rarer : *rarer;
  const double high = probability_of_any(breitung).high;
  result.breitung = found.mean_fails ? 1.0 - high : high;
  return result;
}

/// Designs as they scatter, against which design points are held.
struct Probes {
  std::size_t count = 0, failing = 0;
};

Probes probe(LimitState& limit_state, std::size_t count, std::uint64_t seed) {
  std::vector<VectorXd> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(normal_point(seed, stream_of_probes, i, limit_state.dimension()));
  const std::vector<double> g = limit_state.at(points);
  return {count, static_cast<std::size_t>(
                     std::count_if(g.begin(), g.end(), [](double value) { return value < 0.0; }))};
}

/// Refuses a result that the probes contradict: so few or many of them fail as they do in one of a
/// million such trials even if p_f were three times as far from 0 or from 1.
void hold_against(const Probes& probes, MethodResult& result) {
  if (!result.p_f) return;
  using Binomial = boost::math::binomial_distribution<>;
  constexpr double never = 1e-6, wide = 3.0;
  const double p = *result.p_f;
  const auto n = static_cast<double>(probes.count), failing = static_cast<double>(probes.failing);
  const double high = p < 0.5 ? std::min(0.5, wide * p) : 1.0 - (1.0 - p) / wide;
  const double low = p < 0.5 ? p / wide : std::max(0.5, 1.0 - wide * (1.0 - p));
  const bool too_many = failing > 0.0 && cdf(complement(Binomial(n, high), failing - 1.0)) < never;
  const bool too_few = failing < n && cdf(Binomial(n, low), failing) < never;
  if (!too_many && !too_few) return;
  MethodResult refused;
  refused.method = result.method;
  refused.reason = fmt::format(
      "of {} designs as they scatter {} fail, which is not p_f = {:.3g} as the design points have "
      "it: there are nearer ones, or the limit state is bent too much",
      probes.count, probes.failing, p);
  result = std::move(refused);
}

/// Looks whether methods say the same.
void compare(ReliabilityResult& result) {
  for (const MethodResult& a : result.methods) {
    if (!a.p_f || !a.history.empty()) continue;
    for (const MethodResult& b : result.methods) {
      if (!b.p_f || b.history.empty() || !b.converged) continue;
      if (*a.p_f >= b.low && *a.p_f <= b.high) continue;
      result.remarks.push_back(fmt::format("p_f by {} is {:.3g} times that by {}, beyond its 95 %",
                                           to_text(a.method), *a.p_f / *b.p_f, to_text(b.method)));
    }
  }
  for (const MethodResult& a : result.methods)
    for (const MethodResult& b : result.methods) {
      const bool both = a.converged && b.converged && !a.history.empty() && !b.history.empty();
      if (both && a.high < b.low)
        result.remarks.push_back(
            fmt::format("p_f by {} is below that by {}, by more than 95 % of "
                        "both allow: failure may have been missed",
                        to_text(a.method), to_text(b.method)));
    }
}

bool wants(const ReliabilityDemand& demand, ReliabilityMethod method) {
  return std::find(demand.methods.begin(), demand.methods.end(), method) != demand.methods.end();
}

}  // namespace

const char* to_text(ReliabilityMethod method) {
  switch (method) {
    case ReliabilityMethod::form: return "form";
    case ReliabilityMethod::sorm: return "sorm";
    case ReliabilityMethod::monte_carlo: return "monte-carlo";
    case ReliabilityMethod::importance: return "importance";
    case ReliabilityMethod::subset: return "subset";
  }
  return "";
}

std::optional<double> reliability_index(double p_f) {
  if (!(p_f > 0.0 && p_f < 1.0)) return std::nullopt;
  return -normal_quantile(p_f);
}

double per_year(double p_f, double years) { return -std::expm1(std::log1p(-p_f) / years); }

ReliabilityResult reliability_of(LimitState& limit_state, const ReliabilityDemand& demand,
                                 std::uint64_t seed,
                                 const std::function<void(const std::string&)>& progress) {
  using enum ReliabilityMethod;
  ReliabilityResult result;
  DesignPoints found;
  const auto counted = [&](const auto& run) {
    const std::size_t calls = limit_state.calls(), unjudged = limit_state.troubled();
    MethodResult of = run();
    of.calls += limit_state.calls() - calls;
    of.unjudged += limit_state.troubled() - unjudged;
    return of;
  };
  MethodResult search, first, second;
  if (wants(demand, form) || wants(demand, sorm) || wants(demand, importance)) {
    if (progress) progress("looking for design points");
    search = counted([&] {
      found = design_points_of(limit_state, demand, seed);
      first = first_order(found);
      second = second_order(found);
      const Probes probes =
          found.points.empty() ? Probes{} : probe(limit_state, demand.probes, seed);
      hold_against(probes, first);
      hold_against(probes, second);
      return MethodResult{};
    });
    if (!first.p_f && !second.p_f && found.reason.empty()) {
      found.reason = first.reason;
      found.points.clear();
    }
  }
  for (const ReliabilityMethod method : reliability_methods) {
    if (!wants(demand, method)) continue;
    if (progress) progress(to_text(method));
    MethodResult of = counted([&] {
      switch (method) {
        case form: return first;
        case sorm: return second;
        case monte_carlo: return boxbeam::monte_carlo(limit_state, demand, seed);
        case importance: return importance_sampling(limit_state, demand, found, seed);
        case subset: return subset_simulation(limit_state, demand, seed);
      }
      return MethodResult{};
    });
    if (method == form || method == sorm) {  // what both rest on
      of.calls = search.calls;
      of.unjudged = search.unjudged;
    }
    result.methods.push_back(std::move(of));
  }
  result.points = std::move(found.points);
  if (found.mean_fails)
    for (DesignPoint& point : result.points) {  // seen from the side that fails
      point.beta = -point.beta;
      point.alpha = -point.alpha;
      point.curvatures = -point.curvatures.reverse().eval();
    }
  compare(result);
  if (!result.points.empty() && result.points.front().kinked)
    result.remarks.emplace_back(
        "the nearest design point lies at a kink of the limit state, which form knows nothing of: "
        "ask "
        "for importance or subset");
  if (search.unjudged > 0)
    result.remarks.push_back(fmt::format(
        "{} designs on the way to design points could not be judged: how probable these are is no "
        "part of form, sorm and importance, but of monte-carlo and subset, where they count as "
        "failing",
        search.unjudged));
  result.first_trouble = limit_state.first_trouble();
  result.calls = limit_state.calls();
  return result;
}

}  // namespace boxbeam
