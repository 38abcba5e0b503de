#include "boxbeam/study/solution.hpp"

#include <fmt/format.h>

namespace boxbeam {

std::string reason_of(const Solution& solution) {
  const auto value = [&](double at) {
    const std::string number = fmt::format("{:.6g}", at);
    return solution.from.unit.empty() ? number : number + " " + solution.from.unit;
  };
  const Roots& search = solution.search;
  std::string reason;
  if (!search.jumps.empty()) {
    const JumpOver& jump = search.jumps.front();
    const std::string place =
        jump.apart > 0.0 ? fmt::format("between {} and {}", value(jump.value - 0.5 * jump.apart),
                                       value(jump.value + 0.5 * jump.apart))
                         : "at " + value(jump.value);
    reason = fmt::format("{} the result jumps from {:.6g} to {:.6g}, past {:.6g}", place,
                         jump.before, jump.behind, solution.wanted);
  } else if (search.nearest && !search.changes) {
    reason = fmt::format("the result is {:.6g} wherever it was verified: {} does not change it",
                         search.nearest->result, solution.key);
  } else if (search.nearest) {
    reason = fmt::format("the result comes nearest at {}, where it is {:.6g}",
                         value(search.nearest->value), search.nearest->result);
  }
  if (search.failed > 0) {
    if (!reason.empty()) reason += "; ";
    reason += fmt::format("{} of {} values cannot be verified, the first at {}: {}", search.failed,
                          search.trials, value(search.failed_at), search.first_trouble);
  }
  return reason;
}

}  // namespace boxbeam
