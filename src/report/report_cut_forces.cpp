#include <fmt/format.h>

#include "blocks.hpp"
#include "report_parts.hpp"

namespace boxbeam::report {
namespace {

using text::Quantity;

Quantity quantity_of(cut_force::Index which) {
  return which < cut_force::T ? Quantity::force : Quantity::moment;
}

/// What is below is the rounding of sums [N, N m].
constexpr double nothing = 1e-6;

/// Forces and moments apart, so that a table is not wider than a page.
std::vector<std::vector<CutForceName>> groups_of(const Project& project) {
  std::vector<CutForceName> forces, moments;
  for (const CutForceName& name : cut_forces_looked_at(project)) {
    (quantity_of(name.which) == Quantity::force ? forces : moments).push_back(name);
  }
  if (project.in_space) return {forces, moments};
  forces.insert(forces.end(), moments.begin(), moments.end());
  return {forces};
}

Table envelope_table(const Verification& verification, const std::vector<CutForceName>& names) {
  Table table =
      table_of("Smallest and largest over the whole motion, in all situations", {"s [m]"});
  for (const CutForceName& of : names) {
    table.header.push_back(fmt::format("{} min", of.name));
    table.header.push_back(
        fmt::format("{} max [{}]", of.name, text::unit_of(quantity_of(of.which))));
  }
  for (const StationEnvelope& station : verification.stations) {
    std::vector<Cell> row = row_of(to_text(station.station));
    for (const CutForceName& of : names) {
      row.push_back(cell(quantity_of(of.which), station.of[of.which].smallest.value, nothing));
      row.push_back(cell(quantity_of(of.which), station.of[of.which].largest.value, nothing));
    }
    add_row(table, std::move(row));
  }
  return table;
}

/// The cut forces at one instant all along the beam.
Table line_table(const Project& project, const CutForceLine& line) {
  Table table =
      table_of(fmt::format("t = {}: {}", text::seconds(line.time.value()), line.why), {"s [m]"});
  for (const CutForceName& of : cut_forces_looked_at(project)) {
    table.header.push_back(fmt::format("{} [{}]", of.name, text::unit_of(quantity_of(of.which))));
  }
  for (std::size_t i = 0; i < line.stations.size(); ++i) {
    std::vector<Cell> row = row_of(to_text(line.stations[i]));
    for (const CutForceName& of : cut_forces_looked_at(project)) {
      row.push_back(cell(quantity_of(of.which), value_of(line.values[i], of.which), nothing));
    }
    add_row(table, std::move(row));
  }
  return table;
}

}  // namespace

Chapter cut_force_chapter(const Source& source) {
  Chapter chapter{"Cut forces", {}};
  if (source.level == ReportLevel::summary) return chapter;
  std::vector<Block>& blocks = chapter.blocks;
  blocks.emplace_back(Paragraph{
      source.project.in_space
          ? "N tension positive, V_y and V_z along +y and +z, T about +x, M_y > 0 puts +z in "
            "tension, M_z > 0 -y; - and + are the two sides of a jump."
          : "N tension positive, V along +z, M > 0 puts +z in tension; - and + are the two sides "
            "of a jump."});
  add_pictures(source, FigurePlace::cut_forces, blocks);
  for (const std::vector<CutForceName>& names : groups_of(source.project)) {
    blocks.emplace_back(envelope_table(source.verification, names));
  }
  if (source.level != ReportLevel::full) return chapter;
  for (const CutForceLine& line : source.verification.pictures.lines) {
    blocks.emplace_back(line_table(source.project, line));
  }
  return chapter;
}

}  // namespace boxbeam::report
