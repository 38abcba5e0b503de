#include <fmt/format.h>

#include <iterator>

#include "blocks.hpp"
#include "report_parts.hpp"

namespace boxbeam::report {
namespace {

using text::Quantity;

/// How long a motion is looked at, and how densely.
std::string period_text(const Project& project, const MotionSummary& motion) {
  const Situation& situation = project.situations[motion.situation];
  if (is_flexible(project) && flexible_in(project, situation).frequency == 0.0) {
    return "none: the loads stand still" + in_brackets(situation.name);
  }
  return fmt::format("{}, {} instants solved, extremes refined between them{}",
                     text::seconds(motion.period.value()), motion.instants,
                     in_brackets(situation.name));
}

/// The functions of time that move the beam.
Entries drivers_of(const Project& project) {
  Entries entries = in_space(project)      ? spatial_entries(project)
                    : is_flexible(project) ? flexible_entries(flexible_of(project))
                                           : planar_entries(planar_of(project));
  std::erase_if(entries, [](const auto& entry) { return entry.first != "driver"; });
  return entries;
}

Quantity quantity_of(const CriticalInstant& instant) {
  if (instant.quantity == "stress") return Quantity::stress;
  const bool moment = instant.quantity.starts_with("M") || instant.quantity == "T";
  return moment ? Quantity::moment : Quantity::force;
}

Table critical_table(const Source& source) {
  const Project& project = source.project;
  const bool several = project.situations.size() > 1;
  Table table = table_of("Critical instants: the extremes over the beam and all situations",
                         {"extreme of", "value", "s [m]", "t [s]"});
  if (several) table.header.emplace_back("situation");
  for (const CriticalInstant& instant : source.verification.critical_instants) {
    std::vector<Cell> row = row_of(
        instant.quantity, Cell{text::with_unit(quantity_of(instant), instant.value), instant.value},
        to_text(instant.station), cell(Quantity::time, instant.time.value()));
    if (several) row.push_back(cell(project.situations[instant.situation].name));
    add_row(table, std::move(row));
  }
  return table;
}

}  // namespace

Chapter motion_chapter(const Source& source) {
  const Project& project = source.project;
  const Verification& verification = source.verification;
  Chapter chapter{"Motion", {}};
  if (source.level == ReportLevel::summary) return chapter;
  Facts facts{drivers_of(project)};
  for (const MotionSummary& motion : verification.motions) {
    facts.entries.emplace_back("period", period_text(project, motion));
  }
  chapter.blocks.emplace_back(std::move(facts));
  if (verification.cycle) {
    chapter.blocks.emplace_back(
        MovingPicture{*verification.cycle,
                      "The mechanism, the forces on the beam and its cut forces over one "
                      "cycle" +
                          in_brackets(verification.cycle->situation) + "."});
  }
  add_pictures(source, {"motion"}, chapter.blocks);
  chapter.blocks.emplace_back(critical_table(source));
  if (verification.elastic) {
    std::vector<Block> blocks = vibration_blocks(*verification.elastic, verification.model.chosen);
    chapter.blocks.insert(chapter.blocks.end(), std::make_move_iterator(blocks.begin()),
                          std::make_move_iterator(blocks.end()));
    add_pictures(source, {"modes", "frequency-response", "joint-forces", "sudden-start"},
                 chapter.blocks);
  }
  return chapter;
}

}  // namespace boxbeam::report
