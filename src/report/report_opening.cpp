#include <cmath>

#include "blocks.hpp"
#include "report_parts.hpp"

namespace boxbeam::report {
namespace {

/// Of every cut force its largest size over the beam and all situations.
Table largest_cut_forces(const Source& source) {
  using text::Quantity;
  const bool several = source.project.situations.size() > 1;
  Table table = table_of("Largest cut forces over the beam and all situations",
                         {"cut force", "value", "s [m]", "t [s]"});
  if (several) table.header.emplace_back("situation");
  for (const CutForceName& name : cut_forces_looked_at(source.project)) {
    const CriticalInstant* largest = nullptr;
    for (const CriticalInstant& instant : source.verification.critical_instants) {
      if (!instant.force || instant.force->which != name.which) continue;
      if (largest == nullptr || std::abs(instant.value) > std::abs(largest->value))
        largest = &instant;
    }
    if (largest == nullptr) continue;  // too small to be an extreme
    const Quantity quantity = name.is_moment() ? Quantity::moment : Quantity::force;
    std::vector<Cell> row =
        row_of(name.name, Cell{text::with_unit(quantity, largest->value), largest->value},
               to_text(largest->station), cell(Quantity::time, largest->time.value()));
    if (several) row.push_back(cell(source.project.situations[largest->situation].name));
    add_row(table, std::move(row));
  }
  return table;
}

}  // namespace

std::vector<Block> opening_blocks(const Source& source) {
  std::vector<Block> blocks;
  // A summary is two pages, with figures of its own.
  if (source.level == ReportLevel::summary) return blocks;
  add_pictures(source, FigurePlace::opening, blocks);
  Table forces = largest_cut_forces(source);
  if (!forces.rows.empty()) blocks.emplace_back(std::move(forces));
  return blocks;
}

}  // namespace boxbeam::report
