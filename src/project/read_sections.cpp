#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "boxbeam/project/standard_profiles.hpp"
#include "boxbeam/section/section_defect.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

Length positive_length(TableReader& table, const Key& key) {
  return si<Length>(table.positive(key, wanted::length));
}

/// Two thicknesses under one key for both or under a key for each.
std::pair<Length, Length> pair_of_plates(TableReader& table, const Key& both, const Key& first,
                                         const Key& second) {
  if (!table.says_one_of(
          {{{std::string(first.name), std::string(second.name)}}, {{std::string(both.name)}}})) {
    for (const Key& key : {both, first, second}) table.not_negative(key, wanted::length, 0.0);
    table.problem(table.has(both) ? both.name : "kind",
                  fmt::format("a box wants either \"{}\" or \"{}\" and \"{}\"", both.name,
                              first.name, second.name),
                  fmt::format("write {} = \"10 mm\", or one thickness for each", both.name));
    return {};
  }
  if (table.has(both)) {
    const Length plate = positive_length(table, both);
    return {plate, plate};
  }
  const Length one = positive_length(table, first);
  return {one, positive_length(table, second)};
}

Stiffener read_stiffener(TableReader table) {
  constexpr BoxPlate plates[] = {BoxPlate::top_flange, BoxPlate::bottom_flange, BoxPlate::left_web,
                                 BoxPlate::right_web};
  Stiffener bar;
  bar.plate = plates[table.choice({"on", "the plate it stands on"},
                                  {"top flange", "bottom flange", "left web", "right web"})];
  bar.place = si<Length>(table.quantity({"at", "from the middle of its plate"}, wanted::length));
  bar.depth = positive_length(table, {"depth", "inwards"});
  bar.thickness = positive_length(table, {"thickness", "of the bar"});
  table.finish();
  return bar;
}

Profile read_box(TableReader& table) {
  Box box;
  box.width = positive_length(table, {"width", "over the webs"});
  box.height = positive_length(table, {"height", "over the flanges"});
  std::tie(box.top_flange, box.bottom_flange) =
      pair_of_plates(table, {"flange", "of both flanges"}, {"top_flange", "of the upper one"},
                     {"bottom_flange", "of the lower one"});
  std::tie(box.left_web, box.right_web) =
      pair_of_plates(table, {"web", "of both webs"}, {"left_web", "of the web at +y"},
                     {"right_web", "of the web at -y"});
  box.seam_throat =
      si<Length>(table.not_negative({"seam_throat",
                                     "of the fillet welds between webs and flanges, all of a seam "
                                     "together; the web's thickness where not said"},
                                    wanted::length, 0.0));
  for (TableReader& bar : table.tables({"stiffeners", "longitudinal bars on the plates"}))
    box.stiffeners.push_back(read_stiffener(bar));
  return box;
}

Profile read_rectangular_tube(TableReader& table) {
  return RectangularTube{
      positive_length(table, {"width", "overall"}), positive_length(table, {"height", "overall"}),
      positive_length(table, {"wall", "thickness"}),
      si<Length>(table.not_negative({"outer_radius", "of its corners"}, wanted::length, 0.0)),
      si<Length>(table.not_negative({"inner_radius", "of its corners"}, wanted::length, 0.0))};
}

Profile read_round_tube(TableReader& table) {
  return RoundTube{positive_length(table, {"diameter", "overall"}),
                   positive_length(table, {"wall", "thickness"})};
}

Profile read_plate(TableReader& table) {
  return Plate{positive_length(table, {"width", "along y"}),
               positive_length(table, {"height", "along z"})};
}

std::vector<SectionPlace> places_of(const std::vector<Eigen::Vector2d>& pairs) {
  std::vector<SectionPlace> places;
  for (const Eigen::Vector2d& pair : pairs) {
    places.push_back({si<Length>(pair.x()), si<Length>(pair.y())});
  }
  return places;
}

Profile read_polygon(TableReader& table) {
  Polygon polygon{places_of(table.pairs({"outer", "corners (y, z)"}, wanted::length)), {}};
  for (const auto& hole :
       table.lists_of_pairs({"holes", "further outlines that are cut out"}, wanted::length)) {
    polygon.hollows.push_back(places_of(hole));
  }
  return polygon;
}

Profile read_thin_walled(TableReader& table) {
  ThinWalled path;
  std::vector<std::string> names;
  TableReader nodes = table.table({"nodes", "places (y, z) by name"});
  for (const Node::Member& member : nodes.members("(y, z) of a node")) {
    const Eigen::Vector2d at =
        nodes.pair_in(member.value, fmt::format("\"{}\"", member.key), wanted::length);
    names.push_back(member.key);
    path.nodes.push_back({si<Length>(at.x()), si<Length>(at.y())});
  }
  for (TableReader& wall : table.tables({"walls", "straight walls between nodes"}, true)) {
    const auto node = [&](const Key& of) -> std::size_t {
      const std::string_view key = of.name;
      const std::string name = wall.text(of);
      const auto found = std::find(names.begin(), names.end(), name);
      if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
      if (!name.empty()) {
        wall.problem(key, fmt::format("there is no node \"{}\"", name), unknown_hint(name, names));
      }
      return 0;
    };
    ThinWall read;
    read.from = node({"from", "a node"});
    read.to = node({"to", "a node"});
    read.thickness = positive_length(wall, {"thickness", "of the wall"});
    read.trim_from =
        si<Length>(wall.quantity({"trim_from", "shorter at its beginning"}, wanted::length, 0.0));
    read.trim_to =
        si<Length>(wall.quantity({"trim_to", "shorter at its end"}, wanted::length, 0.0));
    wall.finish();
    path.walls.push_back(read);
  }
  return path;
}

Profile read_standard(TableReader& table) {
  const std::string designation = table.text({"profile", "\"RHS 200x100x8\""});
  if (const auto standard = find_standard_profile(designation)) return standard->profile;
  if (!designation.empty()) {
    table.problem("profile", fmt::format("there is no standard profile \"{}\"", designation),
                  standard_profile_hint(designation));
  }
  return {};
}

std::vector<std::string> names_of(const Sections& sections) {
  std::vector<std::string> names;
  for (const auto& [name, section] : sections) names.push_back(name);
  return names;
}

/// The section if nothing is wrong with it, else one with a defect, so that what is built from it
/// knows that a problem has been noted.
Section sound_or_none(const std::string& name, TableReader& reader, std::size_t problems_before,
                      const Section& section) {
  if (reader.problems().size() != problems_before) return {};
  if (auto defect = defect_of(section)) {
    reader.problem("", fmt::format("section \"{}\": {}", name, *defect),
                   "change its dimensions so that all plates and profiles have their place");
    return {};
  }
  if (auto foil = foil_in(section)) {
    reader.problem("", fmt::format("section \"{}\" has a plate {}", name, *foil),
                   "no plate is so thin: look for a wrong unit");
    return {};
  }
  return section;
}

using ProfileReader = Profile (*)(TableReader&);

Section read_simple_section(const std::string& name, TableReader& reader, ProfileReader read) {
  const std::size_t before = reader.problems().size();
  const Section section{read(reader), {}};
  reader.finish();
  return sound_or_none(name, reader, before, section);
}

/// Two simple sections, one in the other.
Section read_nested_section(const std::string& name, TableReader& reader, const Sections& simple) {
  const std::size_t before = reader.problems().size();
  Section section = named_section(reader, {"outer", "the section outside"}, simple);
  section.inner = named_section(reader, {"inner", "the section inside"}, simple).outer;
  reader.finish();
  if (defect_of(Section{section.outer, {}}) || defect_of(Section{*section.inner, {}})) return {};
  return sound_or_none(name, reader, before, section);
}

}  // namespace

Section named_section(TableReader& table, const Key& of, const Sections& sections) {
  const std::string_view key = of.name;
  return section_called(table, key, table.text(of), sections);
}

Section section_called(TableReader& table, std::string_view key, const std::string& name,
                       const Sections& sections) {
  const auto found = sections.find(name);
  if (found != sections.end()) return found->second;
  if (!name.empty()) {
    table.problem(key, fmt::format("there is no section \"{}\"", name),
                  unknown_hint(name, names_of(sections)));
  }
  return {};
}

Sections read_sections(TableReader table) {
  const std::vector<std::string> kinds{"box",     "rectangular tube", "round tube", "plate",
                                       "polygon", "thin-walled",      "standard",   "nested"};
  constexpr ProfileReader readers[] = {read_box,     read_rectangular_tube, read_round_tube,
                                       read_plate,   read_polygon,          read_thin_walled,
                                       read_standard};
  Sections simple;
  std::vector<std::pair<std::string, TableReader>> nested;
  for (auto& [name, reader] : table.named_tables()) {
    const std::size_t before = table.problems().size();
    const std::size_t kind = reader.kind({"kind", "of profile"}, kinds);
    if (table.problems().size() != before) {
      simple.emplace(name, Section{});  // what its other keys mean is not known
    } else if (kind == std::size(readers)) {
      nested.emplace_back(name, reader);
    } else {
      simple.emplace(name, read_simple_section(name, reader, readers[kind]));
    }
  }
  Sections sections = simple;
  for (auto& [name, reader] : nested) {
    sections.emplace(name, read_nested_section(name, reader, simple));
  }
  return sections;
}

}  // namespace boxbeam::readers
