#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "blocks.hpp"
#include "front_end_text.hpp"

namespace boxbeam::report {
namespace {

using text::Quantity;

/// How long a motion is looked at, and how densely.
std::string period_text(const Project& project, const MotionSummary& motion) {
  const Situation& situation = project.situations[motion.situation];
  if (motion.stands_still) {
    return "none: the loads stand still" + in_brackets(situation.name);
  }
  return fmt::format(
      "{}, {}{}", text::seconds(motion.period.value()),
      motion.recorded
          ? fmt::format("{} instants given, linear between them", motion.instants)
          : fmt::format("{} instants solved, extremes refined between them", motion.instants),
      in_brackets(situation.name));
}

/// The functions of time that move the beam.
Entries drivers_of(const Project& project) {
  Entries entries = front_end_text_of(project)->entries();
  std::erase_if(entries, [](const auto& entry) { return entry.first != "driver"; });
  return entries;
}

Quantity quantity_of(const CriticalInstant& instant) {
  if (!instant.force) return Quantity::stress;
  return instant.force->is_moment() ? Quantity::moment : Quantity::force;
}

std::string end_text(End end) {
  switch (end) {
    case End::largest: return "largest";
    case End::smallest: return "smallest";
    case End::neither: break;
  }
  return "at the largest sigma_v";
}

Table critical_table(const Source& source) {
  const Project& project = source.project;
  const bool several = project.situations.size() > 1;
  Table table = table_of(
      "Critical instants: extremes of the cut forces over the beam and all situations, and of the "
      "stress at the governing place",
      {"quantity", "extreme", "value", "s [m]", "t [s]"});
  if (several) table.header.emplace_back("situation");
  for (const CriticalInstant& instant : source.verification.critical_instants) {
    std::vector<Cell> row = row_of(
        instant.force ? instant.quantity() : "stress, governing place", end_text(instant.end),
        Cell{text::with_unit(quantity_of(instant), instant.value), instant.value},
        to_text(instant.station), cell(Quantity::time, instant.time.value()));
    if (several) row.push_back(cell(project.situations[instant.situation].name));
    add_row(table, std::move(row));
  }
  return table;
}

MovingPicture moving_picture(const Source& source) {
  const std::vector<CycleFigure>& cycles = source.verification.pictures.cycles;
  const std::string& governing = source.project
                                     .situations[governing_situation_of(
                                         source.verification.checks, source.verification.motions)]
                                     .name;
  const auto first = std::find_if(cycles.begin(), cycles.end(), [&](const CycleFigure& cycle) {
    return cycle.situation == governing;
  });
  std::string caption = fmt::format("The {}, the loads on the beam and its cut forces over {}",
                                    front_end_text_of(source.project)->word(),
                                    cycles.front().repeats ? "one cycle" : "the time looked at");
  if (cycles.size() > 1) {
    caption +=
        fmt::format(" of each situation; it begins with the one that governs, {}", governing);
  }
  const std::size_t all = source.verification.motions.size();
  if (all > cycles.size()) {
    caption += fmt::format(" ({} of {} situations are offered)", cycles.size(), all);
  }
  return {cycles, static_cast<std::size_t>(first - cycles.begin()) % cycles.size(), caption + "."};
}

}  // namespace

Chapter motion_chapter(const Source& source) {
  const Project& project = source.project;
  const Verification& verification = source.verification;
  Chapter chapter{"Motion", {}};
  if (source.level == ReportLevel::summary) return chapter;
  Facts facts{drivers_of(project)};
  for (const MotionSummary& motion : verification.motions) {
    facts.entries.emplace_back(motion.closed ? "period" : "time looked at",
                               period_text(project, motion));
  }
  chapter.blocks.emplace_back(std::move(facts));
  if (!verification.pictures.cycles.empty()) chapter.blocks.emplace_back(moving_picture(source));
  add_pictures(source, FigurePlace::motion, chapter.blocks);
  chapter.blocks.emplace_back(critical_table(source));
  if (verification.pictures.elastic) {
    std::vector<Block> blocks = vibration_blocks(source);
    chapter.blocks.insert(chapter.blocks.end(), std::make_move_iterator(blocks.begin()),
                          std::make_move_iterator(blocks.end()));
    add_pictures(source, FigurePlace::vibration, chapter.blocks);
  }
  return chapter;
}

}  // namespace boxbeam::report
