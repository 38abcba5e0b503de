#include <fmt/format.h>

#include <algorithm>

#include "blocks.hpp"
#include "boxbeam/section/torsion.hpp"
#include "report_parts.hpp"

namespace boxbeam::report {
namespace {

using text::Quantity;

/// The stress points of the checks, one for every station, in order along the beam.
std::vector<const StressPoint*> points_per_station(const Verification& verification) {
  std::vector<const StressPoint*> points;
  for (const CheckResult& result : verification.checks) {
    if (!result.basis) continue;
    const StressPoint& point = result.basis->point;
    const bool known = std::any_of(points.begin(), points.end(), [&](const StressPoint* other) {
      return other->station == point.station;
    });
    if (!known) points.push_back(&point);
  }
  std::sort(points.begin(), points.end(), [](const StressPoint* a, const StressPoint* b) {
    return std::pair(a->station.s, a->station.side) < std::pair(b->station.s, b->station.side);
  });
  return points;
}

Cell area(Area A) { return cell(Quantity::area, A.value()); }
Cell moment(SecondMoment I) { return cell(Quantity::second_moment, I.value()); }
Cell modulus(SectionModulus W) { return cell(Quantity::section_modulus, W.value()); }

std::string in(const char* symbol, Quantity quantity) {
  return fmt::format("{} [{}]", symbol, text::unit_of(quantity));
}

Table planar_table(const std::vector<const StressPoint*>& points) {
  Table table =
      table_of("", {"s [m]", "h [mm]", in("A", Quantity::area), in("I_y", Quantity::second_moment),
                    in("W_y", Quantity::section_modulus), in("A_eff", Quantity::area),
                    in("I_y,eff", Quantity::second_moment)});
  for (const StressPoint* point : points) {
    const SectionProperties& gross = point->gross;
    add_row(table, row_of(to_text(point->station),
                          cell(Quantity::length, (gross.z_top - gross.z_bottom).value()),
                          area(gross.area), moment(gross.I_y), modulus(gross.W_y),
                          area(point->net.area), moment(point->net.I_y)));
  }
  return table;
}

Table spatial_table(const std::vector<const StressPoint*>& points) {
  Table table =
      table_of("", {"s [m]", "h [mm]", "b [mm]", in("A", Quantity::area),
                    in("I_y", Quantity::second_moment), in("I_z", Quantity::second_moment),
                    in("I_T", Quantity::second_moment), in("W_y", Quantity::section_modulus),
                    in("W_z", Quantity::section_modulus), in("A_eff", Quantity::area)});
  for (const StressPoint* point : points) {
    const SectionProperties& gross = point->gross;
    const std::optional<SecondMoment> I_T = torsion_properties_of(point->section).I_T;
    add_row(table,
            row_of(to_text(point->station),
                   cell(Quantity::length, (gross.z_top - gross.z_bottom).value()),
                   cell(Quantity::length, (gross.y_left - gross.y_right).value()), area(gross.area),
                   moment(gross.I_y), moment(gross.I_z), I_T ? moment(*I_T) : cell("not known"),
                   modulus(gross.W_y), modulus(gross.W_z), area(point->net.area)));
  }
  return table;
}

}  // namespace

Chapter section_chapter(const Source& source) {
  Chapter chapter{"Sections", {}};
  if (source.level == ReportLevel::summary) return chapter;
  const std::vector<const StressPoint*> points = points_per_station(source.verification);
  if (points.empty()) return chapter;
  add_pictures(source, FigurePlace::sections, chapter.blocks);
  chapter.blocks.emplace_back(source.project.in_space ? spatial_table(points)
                                                      : planar_table(points));
  chapter.blocks.emplace_back(
      Paragraph{"eff: without holes and without what shear lag leaves idle of the flanges."});
  return chapter;
}

}  // namespace boxbeam::report
