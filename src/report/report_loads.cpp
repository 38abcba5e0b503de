#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "blocks.hpp"
#include "report_parts.hpp"

namespace boxbeam::report {
namespace {

using text::Quantity;

/// One table of all critical instants.
void add_planar(const Source& source, std::vector<Block>& blocks) {
  const bool several = source.project.situations.size() > 1;
  blocks.emplace_back(
      Paragraph{"What joints and forces do to the beam; world axes x right, y up; beam axes x "
                "along the axis, z "
                "its left normal. Weight and inertia act per length in between."});
  Table table = table_of("", {"t [s]", "by", "s [m]", "world F_x", "F_y [kN]", "beam F_x",
                              "F_z [kN]", "couple M_y [kN m]"});
  if (several) table.header.emplace_back("situation");
  constexpr double nothing = 1e-6;  // N m: the lever arms' rounding
  for (const BeamLoadRow& row : source.verification.pictures.loads) {
    std::vector<Cell> cells = row_of(
        cell(Quantity::time, row.time.value()), row.name, cell(Quantity::station, row.s.value()),
        cell(Quantity::force, row.world.x()), cell(Quantity::force, row.world.y()),
        cell(Quantity::force, row.force.x()), cell(Quantity::force, row.force.z()),
        cell(Quantity::moment, row.moment.y(), nothing));
    if (several) cells.push_back(cell(source.project.situations[row.situation].name));
    add_row(table, std::move(cells));
  }
  blocks.emplace_back(std::move(table));
}

/// A table for every critical instant: what each joint and load does to the beam.
void add_spatial(const Source& source, std::vector<Block>& blocks) {
  blocks.emplace_back(Paragraph{
      "What joints and loads do to the beam; forces in world axes, then forces and moments about "
      "the axis in beam axes: x along the axis, y and z as the cut forces. Weight, inertia and "
      "line forces act per length in between."});
  const std::vector<PostureFigure>& postures = source.verification.pictures.postures;
  for (std::size_t k = 1; k < postures.size(); ++k) {
    const PostureFigure& posture = postures[k];
    Table table =
        table_of(fmt::format("t = {}: {}", text::seconds(posture.time.value()), posture.why),
                 {"by", "s [m]", "world F_x", "F_y", "F_z [kN]", "beam F_x", "F_y", "F_z [kN]",
                  "beam M_x", "M_y", "M_z [kN m]"});
    double force = 0.0;
    for (const BeamLoadRow& row : posture.loads) force = std::max(force, row.force.norm());
    const double moment = force * source.project.beam.length().value();
    constexpr double rounding = 1e-9;
    for (const BeamLoadRow& row : posture.loads) {
      std::vector<Cell> cells = row_of(row.name, cell(Quantity::station, row.s.value()));
      for (const double x : row.world) cells.push_back(cell(Quantity::force, x, rounding * force));
      for (const double x : row.force) cells.push_back(cell(Quantity::force, x, rounding * force));
      for (const double x : row.moment) {
        cells.push_back(cell(Quantity::moment, x, rounding * moment));
      }
      add_row(table, std::move(cells));
    }
    blocks.emplace_back(std::move(table));
  }
}

}  // namespace

Chapter loads_chapter(const Source& source) {
  Chapter chapter{"Loads on the beam", {}};
  if (source.level == ReportLevel::summary) return chapter;
  if (source.project.in_space) {
    add_spatial(source, chapter.blocks);
  } else {
    add_planar(source, chapter.blocks);
  }
  double imbalance = 0.0;
  for (const MotionSummary& motion : source.verification.motions) {
    imbalance = std::max(imbalance, motion.imbalance);
  }
  chapter.blocks.emplace_back(Paragraph{
      fmt::format("Balance of all loads on the beam, weight and inertia included: {:.1e} of the "
                  "largest force is left over.",
                  imbalance)});
  return chapter;
}

}  // namespace boxbeam::report
