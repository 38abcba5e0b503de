#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "boxbeam/project/detail_reader.hpp"
#include "boxbeam/section/section_defect.hpp"
#include "boxbeam/strength/effective_box.hpp"
#include "boxbeam/strength/hole_concentration.hpp"
#include "readers.hpp"

namespace boxbeam::readers {

Segment read_segment(TableReader table, std::size_t number, Length start,
                     const Sections& sections) {
  Segment segment;
  segment.name = table.text({"name", "of the segment; its number where not said"}, "");
  if (segment.name.empty()) segment.name = fmt::format("{}", number);
  segment.start = start;
  segment.length = si<Length>(table.positive({"length", "along the axis"}, wanted::length));
  if (!table.says_one_of({{{"section"}}, {{"from", "to"}}})) {
    table.text("section", "");
    table.text("from", "");
    table.text("to", "");
    table.problem("length", "a segment wants either \"section\" or \"from\" and \"to\"",
                  "section = \"A1\" for a constant one, from = \"A1\" and to = \"A2\" for a taper");
  } else if (table.has("section")) {
    segment.from = segment.to = named_section(table, {"section", "a constant section"}, sections);
  } else {
    segment.from = named_section(table, {"from", "a taper from this section"}, sections);
    segment.to = named_section(table, {"to", "to this one"}, sections);
    const bool both_known = !defect_of(segment.from) && !defect_of(segment.to);
    if (both_known && !same_kind(segment.from, segment.to)) {
      table.problem("to", "a segment tapers between two sections of the same kind",
                    "split the segment where the kind of section changes");
    }
    // What is read after it may look at the beam.
    if (!same_kind(segment.from, segment.to)) segment.to = segment.from;
  }
  table.finish();
  return segment;
}

namespace {

/// How far from its middle the plate of a hole is flat, on the narrower side.
Length room_for_holes(const Profile& profile, HoleWalls walls) {
  const Extent extent = extent_of(profile);
  if (const auto* box = std::get_if<Box>(&profile)) {
    return walls == HoleWalls::webs ? std::min(clear_top_of(profile), -clear_bottom_of(profile))
                                    : 0.5 * box->width - std::max(box->left_web, box->right_web);
  }
  Length corner;
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    corner = std::max(tube->wall + tube->inner_radius, tube->outer_radius);
  }
  return (walls == HoleWalls::webs ? extent.z_high : extent.y_high) - corner;
}

/// The plate of a box whose flat a hole cuts; nothing where it cuts none.
std::optional<BoxPlate> plate_of_cut_flat(const Profile& profile, const Hole& hole) {
  const auto* box = std::get_if<Box>(&profile);
  if (box == nullptr) return std::nullopt;
  for (const Stiffener& flat : box->stiffeners) {
    const bool flange = is_flange(flat.plate);
    if (flange != (hole.walls == HoleWalls::flanges)) continue;
    const Length place = flange ? abs(flat.place) : flat.place;
    if (abs(place - hole.position) <= 0.5 * (hole.diameter + flat.thickness)) return flat.plate;
  }
  return std::nullopt;
}

/// The sections that a hole goes through: at its station, and on both sides of borders within it.
std::vector<Section> sections_within(const TaperedBeam& beam, Length s, const Hole& hole) {
  std::vector<Length> places{s};
  for (const Segment& of : beam.segments) {
    if (of.end() != s && abs(of.end() - s) < 0.5 * hole.diameter) places.push_back(of.end());
  }
  std::vector<Section> sections;
  for (const Length& place : places) {
    if (place > Length{}) sections.push_back(section_at(beam, {place, Side::before}));
    if (place < beam.length()) sections.push_back(section_at(beam, {place, Side::behind}));
  }
  return sections;
}

/// What is wrong with a hole in the sections that it goes through, or nothing.
std::optional<std::string> misplacement_of(const TaperedBeam& beam, Length s, const Hole& hole) {
  for (const Section& section : sections_within(beam, s, hole)) {
    if (!takes_holes(section.outer)) {
      return "holes are known in boxes, rectangular tubes and plates only";
    }
    const Length room = room_for_holes(section.outer, hole.walls);
    if (abs(hole.position) + 0.5 * hole.diameter >= room) {
      return fmt::format(
          "the hole at {:.4g} mm reaches {:.4g} mm from the middle of a plate that reaches {:.4g} "
          "mm",
          hole.position.value() * 1e3, (abs(hole.position) + 0.5 * hole.diameter).value() * 1e3,
          room.value() * 1e3);
    }
    if (const auto plate = plate_of_cut_flat(section.outer, hole)) {
      return fmt::format("the hole at {:.4g} mm cuts a stiffener of the {}",
                         hole.position.value() * 1e3, to_text(*plate));
    }
  }
  return std::nullopt;
}

/// Whether a hole cuts into one that is already there, or into its own mirror image, or leaves
/// nothing between.
bool overlaps(const Project& project, Length s, const Hole& hole) {
  constexpr double touching = 1.0 + 1e-9;
  const bool own_pair = hole.walls == HoleWalls::flanges && hole.position > Length{} &&
                        2.0 * hole.position < touching * hole.diameter;
  return own_pair ||
         std::any_of(project.holes.begin(), project.holes.end(), [&](const BeamHole& other) {
           const Length along = s - other.s, across = hole.position - other.hole.position;
           const Length reach = 0.5 * touching * (other.hole.diameter + hole.diameter);
           return other.hole.walls == hole.walls && along * along + across * across < reach * reach;
         });
}

/// Whether the concentration fits the walls of the hole; notes it where not.
void check_concentration(TableReader& table, bool flanges, bool solid, HoleCase hole_case) {
  const bool out_of_plane = hole_case == HoleCase::out_of_plane_bending;
  if (out_of_plane && !(flanges && solid)) {
    table.problem("concentration",
                  "only a solid plate with a hole along z is bent out of its plane; the walls of a "
                  "hollow beam are strained evenly, or in their plane",
                  flanges ? "write concentration = \"membrane tension\""
                          : "write concentration = \"in-plane bending\"");
    return;
  }
  if (flanges && solid && hole_case == HoleCase::membrane_tension) {
    table.problem("concentration",
                  "the bending of the beam bends a solid plate out of its plane at a hole along z",
                  "write concentration = \"out-of-plane bending\", which counts N as membrane "
                  "tension");
    return;
  }
  if (!flanges && hole_case == HoleCase::membrane_tension) {
    table.problem("concentration",
                  "a hole in a web is not in membrane tension: the bending of the beam "
                  "strains it across its depth",
                  "write concentration = \"in-plane bending\"");
  }
  if (flanges && hole_case == HoleCase::in_plane_bending) {
    table.problem("concentration", "a hole in a flange is strained evenly, not bent in its plane",
                  "write concentration = \"membrane tension\"");
  }
  if (flanges && hole_case == HoleCase::published_exponential) {
    table.problem("concentration", "the published formula was used for a hole in a web",
                  "write concentration = \"membrane tension\"");
  }
}

/// Reads concentration and detail of a hole that has its place.
void read_judgement(TableReader& table, const TaperedBeam& beam, BeamHole& at) {
  if (table.has("detail")) {
    TableReader given = table.table({"detail",
                                     "for fatigue: category, row or facts; a row of the net "
                                     "section stands instead of a concentration"});
    BeamDetail detail;
    detail.from = detail.to = at.s;
    detail.detail = read_detail(given);
    detail.assumed = given.text({"assumed", "why it is taken so"}, "");
    if (given.problems().empty() && detail.detail.curve.kind == StressKind::shear) {
      given.problem("kind", "the detail of a hole is for direct stress",
                    "write a category or row for direct stress");
    }
    given.finish();
    at.detail = std::move(detail);
  }
  const bool net = at.detail && at.detail->detail.where == StressPlace::net;
  if (net && !table.has("concentration")) return;
  constexpr HoleCase cases[] = {HoleCase::in_plane_bending, HoleCase::membrane_tension,
                                HoleCase::out_of_plane_bending, HoleCase::published_exponential};
  const HoleCase hole_case = cases[table.choice(
      {"concentration", "which problem its concentration is"},
      {"in-plane bending", "membrane tension", "out-of-plane bending", "published exponential"})];
  if (!table.problems().empty()) return;
  if (net) {
    table.problem("concentration",
                  fmt::format("row {} is for the stress of the net section and contains the "
                              "concentration at the hole: K_t would count it twice",
                              at.detail->detail.row),
                  "take \"concentration\" away, or a detail of the plain plate: row = \"8.1/4\"");
  }
  const bool solid = std::holds_alternative<Plate>(section_at(beam, {at.s}).outer);
  check_concentration(table, at.hole.walls == HoleWalls::flanges, solid, hole_case);
  at.concentration = hole_case;
}

void read_hole(TableReader table, Project& project) {
  const TaperedBeam& beam = project.beam;
  BeamHole at;
  Hole& hole = at.hole;
  hole.name = table.text({"name", "of the hole"});
  hole.diameter = si<Length>(table.positive({"diameter", "of the hole"}, wanted::length));
  at.s = station_of(table, {"station", "along the beam"}, beam);
  const bool flanges =
      table.kind({"through", "the walls that it goes through"}, {"webs", "flanges"}) == 1;
  hole.walls = flanges ? HoleWalls::flanges : HoleWalls::webs;
  const Key of =
      flanges
          ? Key("offsets", "y of its centres, of holes through flanges; each stands at +y and -y")
          : Key("levels", "z of its centres, of holes through webs");
  const std::string_view where = of.name;
  const std::vector<double> positions = table.quantities(of, wanted::length);
  read_judgement(table, beam, at);
  table.finish();
  if (!table.problems().empty()) return;

  const std::string name = hole.name;
  const auto named_alike = [&](const BeamHole& other) {
    return other.hole.name == name || other.hole.name.starts_with(name + " ");
  };
  if (std::any_of(project.holes.begin(), project.holes.end(), named_alike)) {
    table.problem("name", fmt::format("there is already a hole \"{}\"", name),
                  "give every hole a name of its own");
  }
  if (positions.empty()) {
    table.problem(where, "the hole is nowhere", "write at least one place");
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double position = positions[i];
    if (positions.size() > 1) hole.name = fmt::format("{} {}", name, i + 1);
    hole.position = si<Length>(flanges ? std::abs(position) : position);
    if (auto trouble = misplacement_of(beam, at.s, hole)) {
      table.problem(where, *trouble, "move the hole, or make it smaller");
    } else if (overlaps(project, at.s, hole)) {
      table.problem(where, "the hole overlaps another one, or touches it",
                    "move them apart, or write one hole");
    }
    add_hole(project, at);
  }
}

}  // namespace

Length station_of(TableReader& table, const Key& of, const TaperedBeam& beam) {
  const std::string_view key = of.name;
  const double s = table.not_negative(of, wanted::length);
  if (beam.segments.empty()) return si<Length>(s);
  const double length = beam.length().value();
  if (s > length * (1.0 + 1e-12)) {
    table.problem(key, fmt::format("\"{}\" lies behind the end of the beam", key),
                  fmt::format("stations go from 0 to {:.6g} m", length));
  }
  // Lengths that could not be read are NaN and cannot be compared.
  if (!table.problems().empty()) return si<Length>(s);
  return place_near(places_of(beam), si<Length>(s));
}

namespace {

/// Notes holes in flat plates that take so much of the width, all at the place together, that the
/// factor of plate bending is not known.
void check_bending_widths(TableReader& table, const Project& project) {
  const TaperedBeam& beam = project.beam;
  if (!table.problems().empty()) return;
  constexpr HoleCase hole_case = HoleCase::out_of_plane_bending;
  for (const BeamHole& at : project.holes) {
    if (at.concentration != hole_case) continue;
    for (const Side side : {Side::before, Side::behind}) {
      if (side == Side::before ? at.s.value() == 0.0 : at.s == beam.length()) continue;
      const Section section = section_at(beam, {at.s, side});
      if (std::holds_alternative<Plate>(section.outer) &&
          !hole_edges_of(section, holes_at(project, at.s), {}, at.hole, hole_case).empty()) {
        continue;
      }
      table.problem("holes",
                    fmt::format("at hole \"{}\" the holes take 0.3 of a flat plate's width or "
                                "more, where the factor of plate bending is not known",
                                at.hole.name),
                    "make the holes smaller or the plate wider");
      return;
    }
  }
}

void read_diaphragm(TableReader table, TaperedBeam& beam) {
  Diaphragm diaphragm;
  diaphragm.s = station_of(table, {"station", "along the beam"}, beam);
  diaphragm.thickness = si<Length>(table.positive({"thickness", "of its plate"}, wanted::length));
  if (table.has("opening")) {
    diaphragm.opening =
        si<Length>(table.positive({"opening", "width of its access hole"}, wanted::length));
  }
  if (table.has("throat")) {
    diaphragm.throat = si<Length>(table.positive(
        {"throat", "of each of the fillet welds on both its faces"}, wanted::length));
  }
  table.finish();
  if (!table.problems().empty()) return;
  const auto same = [&](const Diaphragm& other) { return other.s == diaphragm.s; };
  if (std::any_of(beam.diaphragms.begin(), beam.diaphragms.end(), same)) {
    table.problem("station", "there is already a diaphragm at this station",
                  "write each diaphragm once");
  }
  const Extent extent = extent_of(section_at(beam, {diaphragm.s}).outer);
  if (diaphragm.opening >= extent.y_high - extent.y_low) {
    table.problem("opening", "the access hole is as wide as the beam",
                  fmt::format("the section is {:.6g} mm wide there",
                              (extent.y_high - extent.y_low).value() * 1e3));
  }
  beam.diaphragms.push_back(diaphragm);
}

void read_introduction(TableReader table, TaperedBeam& beam) {
  LoadIntroduction introduction;
  if (!table.says_one_of({{{"station"}}, {{"from", "to"}}})) {
    table.problem("", "say where the forces come in",
                  "station = \"1.2 m\", or \"from\" and \"to\"");
  } else if (table.has("station")) {
    introduction.from = station_of(table, {"station", "along the beam"}, beam);
    introduction.to = introduction.from;
  } else {
    introduction.from = station_of(table, {"from", "of the stretch where it holds"}, beam);
    introduction.to = station_of(table, {"to", "its end"}, beam);
    if (introduction.to < introduction.from) {
      table.problem("to", "the stretch ends before it begins", "exchange \"from\" and \"to\"");
    }
  }
  if (!table.says_one_of({{{"stiff_length"}}, {{"into"}}})) {
    table.problem("", "say how the forces come in",
                  "stiff_length = \"100 mm\" through a flange, into = \"webs\" by bosses");
  } else if (table.has("stiff_length")) {
    introduction.stiff_length = si<Length>(table.not_negative(
        {"stiff_length", "on the flange, along the beam (EN 1993-1-5, 6.3)"}, wanted::length));
  } else {
    table.choice({"into", "bosses or plates lead them into the webs over their depth"}, {"webs"},
                 0);
  }
  if (table.has("torque_by")) {
    constexpr TorqueBy ways[] = {TorqueBy::webs, TorqueBy::flanges, TorqueBy::flow};
    introduction.torque_by =
        ways[table.choice({"torque_by",
                           "forces of which plates of a box its torque is; the worse where not "
                           "said; \"flow\" by all four, as torsion bears it"},
                          {"webs", "flanges", "flow"})];
  }
  table.finish();
  beam.introductions.push_back(introduction);
}

}  // namespace

TaperedBeam read_tapered_beam(TableReader& table, const Sections& sections) {
  TaperedBeam beam;
  beam.density = si<Density>(table.positive({"density", "of its material"}, wanted::density));
  beam.rotary_inertia =
      table.boolean({"rotary_inertia", "the sections' own rotary inertia counts"}, false);
  Length start;
  for (TableReader& segment :
       table.tables({"segments", "from its start to its end, constant or tapered"}, true)) {
    beam.segments.push_back(read_segment(segment, beam.segments.size() + 1, start, sections));
    start = beam.segments.back().end();
  }
  if (table.has("segments") && beam.segments.empty()) {
    table.problem("segments", "the beam has no segment", "write at least one [[beam.segments]]");
  }
  for (TableReader& diaphragm :
       table.tables({"diaphragms", "plates across the beam, welded to all four of its plates"}))
    read_diaphragm(diaphragm, beam);
  std::sort(beam.diaphragms.begin(), beam.diaphragms.end(),
            [](const Diaphragm& a, const Diaphragm& b) { return a.s < b.s; });
  for (TableReader& introduction : table.tables(
           {"load_introductions", "how forces come into the webs where no diaphragm takes them"}))
    read_introduction(introduction, beam);
  return beam;
}

void read_beam(TableReader& table, const Sections& sections, Project& project) {
  TaperedBeam& beam = project.beam;
  beam = read_tapered_beam(table, sections);
  TableReader places = table.table({"places", "stations of interest, each by a name"}, false);
  for (const Node::Member& member : places.members("along the beam")) {
    beam.points.push_back({member.key, station_of(places, member.key, beam)});
  }
  for (TableReader& hole : table.tables({"holes", "through webs or flanges"}))
    read_hole(hole, project);
  check_bending_widths(table, project);
  project.restraints = read_restraints(table, beam);
}

}  // namespace boxbeam::readers
