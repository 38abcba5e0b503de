#include "boxbeam/mechanism/common/rough_times.hpp"

#include <algorithm>

namespace boxbeam {

RoughTimes::RoughTimes(const std::vector<DriverUse>& uses, double begin, double period, bool closed,
                       const std::vector<double>& more)
    : rounding_(1e-9 * period) {
  std::vector<Break> found = breaks_of(uses, begin, begin + period);
  std::erase_if(found, [](const Break& each) { return each.order > 1; });
  for (const double at : more) found.push_back({at, 0});
  std::stable_sort(found.begin(), found.end(),
                   [](const Break& a, const Break& b) { return a.at < b.at; });
  if (!closed) {
    times_ = std::move(found);
    return;
  }
  for (const double shift : {-period, 0.0, period}) {
    for (const Break& each : found) times_.push_back({each.at + shift, each.order});
  }
}

bool RoughTimes::between(double from, double until) const {
  const auto first = std::upper_bound(times_.begin(), times_.end(), from + rounding_,
                                      [](double at, const Break& each) { return at < each.at; });
  for (auto each = first; each != times_.end(); ++each) {
    if (each->at > until + rounding_) return false;
    const bool at_end = each->at > until - rounding_;
    if (!at_end || each->order == 0) return true;
  }
  return false;
}

}  // namespace boxbeam
