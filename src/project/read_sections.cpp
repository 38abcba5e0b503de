#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "boxbeam/project/standard_profiles.hpp"
#include "boxbeam/section/section_defect.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

Length positive_length(TableReader& table, std::string_view key) {
  return si<Length>(table.positive(key, wanted::length));
}

/// Two thicknesses under one key for both or under a key for each.
std::pair<Length, Length> pair_of_plates(TableReader& table, const char* both, const char* first,
                                         const char* second) {
  const bool each = table.has(first) || table.has(second);
  if (each == table.has(both)) {
    for (const char* key : {both, first, second}) table.not_negative(key, wanted::length, 0.0);
    table.problem(
        table.has(both) ? both : "kind",
        fmt::format("a box wants either \"{}\" or \"{}\" and \"{}\"", both, first, second),
        fmt::format("write {} = \"10 mm\", or one thickness for each", both));
    return {};
  }
  if (!each) {
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
  bar.plate = plates[table.choice("on", {"top flange", "bottom flange", "left web", "right web"})];
  bar.place = si<Length>(table.quantity("at", wanted::length));
  bar.depth = positive_length(table, "depth");
  bar.thickness = positive_length(table, "thickness");
  table.finish();
  return bar;
}

Profile read_box(TableReader& table) {
  Box box;
  box.width = positive_length(table, "width");
  box.height = positive_length(table, "height");
  std::tie(box.top_flange, box.bottom_flange) =
      pair_of_plates(table, "flange", "top_flange", "bottom_flange");
  std::tie(box.left_web, box.right_web) = pair_of_plates(table, "web", "left_web", "right_web");
  box.seam_throat = si<Length>(table.not_negative("seam_throat", wanted::length, 0.0));
  for (TableReader& bar : table.tables("stiffeners")) box.stiffeners.push_back(read_stiffener(bar));
  return box;
}

Profile read_rectangular_tube(TableReader& table) {
  return RectangularTube{positive_length(table, "width"), positive_length(table, "height"),
                         positive_length(table, "wall"),
                         si<Length>(table.not_negative("outer_radius", wanted::length, 0.0)),
                         si<Length>(table.not_negative("inner_radius", wanted::length, 0.0))};
}

Profile read_round_tube(TableReader& table) {
  return RoundTube{positive_length(table, "diameter"), positive_length(table, "wall")};
}

Profile read_plate(TableReader& table) {
  return Plate{positive_length(table, "width"), positive_length(table, "height")};
}

std::vector<SectionPlace> places_of(const std::vector<Eigen::Vector2d>& pairs) {
  std::vector<SectionPlace> places;
  for (const Eigen::Vector2d& pair : pairs) {
    places.push_back({si<Length>(pair.x()), si<Length>(pair.y())});
  }
  return places;
}

Profile read_polygon(TableReader& table) {
  Polygon polygon{places_of(table.pairs("outer", wanted::length)), {}};
  for (const auto& hole : table.lists_of_pairs("holes", wanted::length)) {
    polygon.hollows.push_back(places_of(hole));
  }
  return polygon;
}

Profile read_thin_walled(TableReader& table) {
  ThinWalled path;
  std::vector<std::string> names;
  TableReader nodes = table.table("nodes");
  for (const Node::Member& member : nodes.members()) {
    const Eigen::Vector2d at =
        nodes.pair_in(member.value, fmt::format("\"{}\"", member.key), wanted::length);
    names.push_back(member.key);
    path.nodes.push_back({si<Length>(at.x()), si<Length>(at.y())});
  }
  for (TableReader& wall : table.tables("walls", true)) {
    const auto node = [&](std::string_view key) -> std::size_t {
      const std::string name = wall.text(key);
      const auto found = std::find(names.begin(), names.end(), name);
      if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
      if (!name.empty()) {
        wall.problem(key, fmt::format("there is no node \"{}\"", name), unknown_hint(name, names));
      }
      return 0;
    };
    ThinWall read;
    read.from = node("from");
    read.to = node("to");
    read.thickness = positive_length(wall, "thickness");
    read.trim_from = si<Length>(wall.quantity("trim_from", wanted::length, 0.0));
    read.trim_to = si<Length>(wall.quantity("trim_to", wanted::length, 0.0));
    wall.finish();
    path.walls.push_back(read);
  }
  return path;
}

Profile read_standard(TableReader& table) {
  const std::string designation = table.text("profile");
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
  Section section = named_section(reader, "outer", simple);
  section.inner = named_section(reader, "inner", simple).outer;
  reader.finish();
  if (defect_of(Section{section.outer, {}}) || defect_of(Section{*section.inner, {}})) return {};
  return sound_or_none(name, reader, before, section);
}

}  // namespace

Section named_section(TableReader& table, std::string_view key, const Sections& sections) {
  return section_called(table, key, table.text(key), sections);
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
    const std::size_t kind = reader.choice("kind", kinds);
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
