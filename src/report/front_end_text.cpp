#include "front_end_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "blocks.hpp"
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

Table reactions_table(std::string caption, const std::vector<std::size_t>& shown,
                      const std::vector<MotionSummary>& motions) {
  Table table = table_of(std::move(caption), {"support"});
  constexpr std::array<const char*, 6> names{"F_x [kN]",   "F_y [kN]",   "F_z [kN]",
                                             "M_x [kN m]", "M_y [kN m]", "M_z [kN m]"};
  for (const std::size_t k : shown) table.header.emplace_back(names[k]);
  const std::size_t count = motions.front().reactions.size();
  double force = 0.0, couple = 0.0;
  for (const MotionSummary& motion : motions) {
    for (const SupportReaction& of : motion.reactions) {
      for (std::size_t k = 0; k < 6; ++k) {
        double& largest = k < 3 ? force : couple;
        largest = std::max({largest, std::abs(of.low[k]), std::abs(of.high[k])});
      }
    }
  }
  for (std::size_t support = 0; support < count; ++support) {
    SupportReaction all = motions.front().reactions[support];
    for (const MotionSummary& motion : motions) {
      const SupportReaction& of = motion.reactions[support];
      for (std::size_t k = 0; k < 6; ++k) {
        all.low[k] = std::min(all.low[k], of.low[k]);
        all.high[k] = std::max(all.high[k], of.high[k]);
      }
    }
    std::vector<Cell> row = row_of(all.name);
    for (const std::size_t k : shown) {
      const auto kilo = [&](double x) {
        const double size = k < 3 ? force : std::max(couple, 1e-9 * force);
        return plain(std::abs(x) <= 1e-9 * size ? 0.0 : std::stod(text::significant(x / 1e3, 5)));
      };
      row.push_back(cell(all.low[k] == all.high[k] || kilo(all.low[k]) == kilo(all.high[k])
                             ? kilo(all.high[k])
                             : kilo(all.low[k]) + " to " + kilo(all.high[k])));
    }
    add_row(table, std::move(row));
  }
  return table;
}

}  // namespace boxbeam::report
