#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/project/detail_catalogue.hpp"
#include "boxbeam/project/plate_material.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

/// The detail of row 8.5/3 for one kind of stress: the root of a weld that does not fuse it.
Detail root_detail(StressKind kind) {
  const auto row =
      std::find_if(detail_rows().begin(), detail_rows().end(),
                   [&](const DetailRow& each) { return each.id == "8.5/3" && each.kind == kind; });
  Detail detail;
  detail.name = row->what;
  detail.row = row->id;
  detail.curve = curve_of(*row);
  detail.where = row->where;
  detail.unconfirmed = row->unconfirmed || detail.curve.unconfirmed;
  detail.candidates = {*row};
  return detail;
}

/// The thickest wall at a station, of whose parts the weaker one decides.
Length thickest_at(const TaperedBeam& beam, Length s) {
  Length thickest{};
  const auto look = [&](const Profile& profile) {
    const Length half = 0.5 * height_of(profile);
    for (const Length& z : {Length{}, half, -half})
      thickest = std::max(thickest, wall_at(profile, z));
  };
  for (const Side side : {Side::before, Side::behind}) {
    const Section section = section_at(beam, {s, side});
    look(section.outer);
    if (section.inner) look(*section.inner);
  }
  return thickest;
}

WeldInput read_weld(TableReader table, const Sections& sections, const Project& project) {
  WeldInput weld;
  weld.name = table.text({"name", "of the weld"});
  weld.s = station_of(table, {"station", "along the beam"}, project.beam);
  weld.throat = si<Length>(table.positive({"throat", "of the weld"}, wanted::length));
  weld.required = table.number({"required", "wanted safety factor"}, project.strength.required);
  const std::size_t before = table.problems().size();
  const Section around =
      named_section(table, {"around", "the weld follows the outline of this section"}, sections);
  weld.around = around.outer;
  const bool known = std::holds_alternative<Box>(weld.around) ||
                     std::holds_alternative<RectangularTube>(weld.around) ||
                     std::holds_alternative<RoundTube>(weld.around);
  if (table.problems().size() == before && !known) {
    table.problem("around", "a weld is known around boxes, rectangular and round tubes",
                  "name the section of such a profile");
  }
  if (table.problems().size() == before && known) {
    // The ring of the throat has a hollow only where it is thinner than the profile that it is
    // around.
    const Extent extent = extent_of(weld.around);
    const Length size = std::min(extent.y_high - extent.y_low, extent.z_high - extent.z_low);
    if (weld.throat >= size) {
      table.problem(
          "throat",
          fmt::format("the throat is no smaller than the profile, {:.6g} mm", size.value() * 1e3),
          "write the throat of the weld, such as \"5 mm\"");
    }
  }
  if (table.problems().empty()) {
    weld.thickness = thickest_at(project.beam, weld.s);
    const Material& weakest =
        *weakest_to_weld(plates_around(project, weld.s, weld.thickness)).material;
    if (!tensile_strength_of(weakest, weld.thickness)) {
      table.problem("station",
                    fmt::format("{} has no strength for the {:.6g} mm of the parts joined here",
                                weakest.name, weld.thickness.value() * 1e3),
                    "choose another steel");
    }
    if (!holes_at(project, weld.s).empty()) {
      table.problem("station", "a hole stands in the weld",
                    "set the weld beside the hole, or leave one of them out");
    }
  }
  weld.root.from = weld.root.to = weld.s;
  weld.root.detail = root_detail(StressKind::direct);
  weld.shear = root_detail(StressKind::shear);
  table.finish();
  return weld;
}

}  // namespace

void read_welds(TableReader& root, const Sections& sections, Project& project) {
  for (TableReader& table :
       root.tables({"welds", "around profiles that join two parts of the beam"})) {
    WeldInput weld = read_weld(table, sections, project);
    if (std::any_of(project.welds.begin(), project.welds.end(),
                    [&](const WeldInput& other) { return other.name == weld.name; })) {
      table.problem("name", fmt::format("\"{}\" is there already", weld.name),
                    "give each a name of its own");
    }
    project.welds.push_back(std::move(weld));
  }
}

}  // namespace boxbeam::readers
