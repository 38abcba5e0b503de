#include "front_end_text.hpp"

#include <fmt/format.h>

#include "boxbeam/report/format.hpp"
#include "function_text.hpp"

namespace boxbeam::report {

std::unique_ptr<const FrontEndText> front_end_text_of(const Project& project) {
  return std::visit([&](const auto& mechanism) { return text_for(mechanism, project); },
                    project.mechanism);
}

void add_duration(const Duration& duration, Entries& entries) {
  if (duration.length == 0.0) return;
  entries.emplace_back("motion", fmt::format("{} s looked at, after {} s left out",
                                             plain(duration.length), plain(duration.settle)));
}

/// Notes how far curves leave the points of their tables.
void add_overshoots(const std::vector<DriverUse>& functions,
                    std::string (*name_of)(const DriverUse&), std::vector<std::string>& remarks) {
  constexpr double rounding = 1e-6;
  for (const DriverUse& function : functions) {
    const auto* table = std::get_if<TableDriver>(function.driver);
    if (table == nullptr) continue;
    const Overshoot overshoot = table->curve.overshoot();
    if (overshoot.share <= rounding) continue;
    remarks.push_back(fmt::format(
        "{}: between two points of its table the cubic curve leaves them by {:.2g} % of the range "
        "of all points, at t = {}",
        name_of(function), 100.0 * overshoot.share, text::seconds(overshoot.at)));
  }
}

}  // namespace boxbeam::report
