#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "boxbeam/project/detail_catalogue.hpp"
#include "boxbeam/project/plate_detail.hpp"
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

/// Thicknesses of a profile's walls, the thickest first.
std::vector<Length> walls_of(const Profile& profile) {
  std::vector<Length> walls = thicknesses_of(Section{profile, {}});
  std::sort(walls.begin(), walls.end(), std::greater<>());
  return walls;
}

/// The toe in the walls of the profile, row 8.5/1, as long as it is known what it is welded to.
Detail toe_detail(TableReader& table, const std::vector<Length>& walls) {
  std::vector<DetailRow> rows;
  std::copy_if(detail_rows().begin(), detail_rows().end(), std::back_inserter(rows),
               [](const DetailRow& row) { return row.id == "8.5/1"; });
  Facts facts{{"stress", "nominal"}, {"part", "cruciform"}};
  const Key length{"attachment_length",
                   "of what the profile is welded to, along the stress between the weld toes: its "
                   "line of row 8.5/1; the weakest where not said"};
  if (table.has_quantity(length, wanted::length))
    facts.emplace(length.name, table.positive(length, wanted::length));
  Detail detail;
  const DetailInPlates known{facts, assess(rows, StressKind::direct, facts).candidates, false,
                             false, false};
  if (walls.empty() || known.rows.empty()) return detail;
  facts.emplace("thickness", walls.front().value());
  const DetailAssessment assessment = assess(known.rows, StressKind::direct, facts);
  take_governing(detail, assessment, facts, known);
  detail.in_plates = known;
  detail.raises = raises_of(detail_rows(), assessment.candidates, facts, fixed_facts());
  return detail;
}

/// Throat and penetration, which may be full.
void read_throat(TableReader& table, WeldInput& weld) {
  const double penetration = table.per_direction(
      {"penetration",
       "beyond the throat, as tests confirm it (EN 1993-1-8, 4.5.2(3), 4.7.2), or \"full\""},
      1, wanted::length, "full", 0.0)[0];
  weld.full = std::isinf(penetration);
  if (!weld.full) weld.penetration = si<Length>(penetration);
  const Key throat{"throat", "of the weld, wanted where it does not penetrate fully"};
  if (table.has_quantity(throat, wanted::length)) {
    weld.throat = si<Length>(table.positive(throat, wanted::length));
    if (weld.full)
      table.problem("throat", "a weld that penetrates fully has no throat of its own",
                    "take it away, or write penetration = \"2 mm\"");
  } else if (!weld.full) {
    table.problem("", "the weld has no throat",
                  "write throat = \"5 mm\", or penetration = \"full\"");
  }
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

/// How far from the centre of a hole its shadow reaches in which no force along the beam comes to a
/// weld across it: from its widest place by 45 degrees, and no less than to its edge and the
/// thickness of the parts joined beyond. Source: spread as in EN 1993-1-5:2006, 3.2.3.
Length reach_at_weld(const BeamHole& at, const WeldInput& weld) {
  return 0.5 * at.hole.diameter + std::max(weld.thickness, Length(0.5 * at.hole.diameter));
}

const BeamHole* hole_at_weld(const Project& project, const WeldInput& weld) {
  for (const BeamHole& at : project.holes) {
    if (abs(at.s - weld.s) < reach_at_weld(at, weld)) return &at;
  }
  return nullptr;
}

WeldInput read_weld(TableReader table, const Sections& sections, const Project& project) {
  WeldInput weld;
  weld.name = table.text({"name", "of the weld"});
  weld.s = station_of(table, {"station", "along the beam"}, project.beam);
  read_throat(table, weld);
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
    const Length thinnest = walls_of(weld.around).back();
    if (weld.penetration >= thinnest) {
      table.problem("penetration",
                    fmt::format("the weld penetrates through the wall of the profile, {:.6g} mm",
                                thinnest.value() * 1e3),
                    "write less, or penetration = \"full\"");
    } else if (weld.throat + 3.0 * weld.penetration >= size) {
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
    if (const BeamHole* of = hole_at_weld(project, weld)) {
      table.problem("station",
                    fmt::format("a hole stands in the weld or so near it that no force comes to "
                                "all of its length: \"{}\" at s = {:.6g} m",
                                of->hole.name, of->s.value()),
                    fmt::format("keep {:.4g} mm from its centre, or leave one of them out",
                                1e3 * reach_at_weld(*of, weld).value()));
    }
  }
  weld.root.from = weld.root.to = weld.s;
  weld.root.detail = root_detail(StressKind::direct);
  weld.shear = root_detail(StressKind::shear);
  weld.toe.from = weld.toe.to = weld.s;
  weld.toe.detail = toe_detail(table, known ? walls_of(weld.around) : std::vector<Length>{});
  weld.toe.stress_factor = table.number(
      {"stress_factor",
       "of the toe's stress over the nominal one of the profile, k_f (EN 1993-1-9, 6.3, 8.5/2)"},
      1.0);
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
