#include "boxbeam/project/plate_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "boxbeam/project/case_document.hpp"

namespace boxbeam {
namespace {

/// A key of a section and the thickness that it says.
using Said = std::pair<const char*, Length>;

/// One key for two plates, or a key for each, as the section's table has it.
std::vector<Said> pair_of(const Node& table, const Said& both, const Said& first,
                          const Said& second) {
  if (table.find(both.first) != nullptr) return {both};
  return {first, second};
}

std::vector<Said> said_in(const Node& table, const Profile& profile, PlateGroup group) {
  if (const auto* box = std::get_if<Box>(&profile)) {
    if (group == PlateGroup::flanges)
      return pair_of(table, {"flange", box->top_flange}, {"top_flange", box->top_flange},
                     {"bottom_flange", box->bottom_flange});
    if (group == PlateGroup::webs)
      return pair_of(table, {"web", box->left_web}, {"left_web", box->left_web},
                     {"right_web", box->right_web});
    return {};
  }
  if (group != PlateGroup::walls) return {};
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) return {{"wall", tube->wall}};
  if (const auto* tube = std::get_if<RoundTube>(&profile)) return {{"wall", tube->wall}};
  return {};
}

/// The name of a section under a key of a segment; "" where it has none.
std::string name_under(const Node& segment, const char* key) {
  const Node* name = segment.find(key);
  return name != nullptr && name->kind == Node::Kind::text ? name->text : "";
}

}  // namespace

std::vector<PlateKey> plate_keys_of(const Project& project, std::size_t segment, PlateGroup group) {
  const CaseDocument document = parse_document(project.path, project.text, project.overrides);
  const Node* sections = document.root.find("sections");
  const Node* beam = document.root.find("beam");
  if (sections == nullptr || beam == nullptr) return {};
  if (beam->kind == Node::Kind::array) beam = &beam->items[project.beam_index];
  const Node* segments = beam->find("segments");
  if (segments == nullptr || segment >= segments->items.size()) return {};
  const Node& written = segments->items[segment];
  const Segment& read = project.beam.segments[segment];
  std::vector<PlateKey> keys;
  for (const auto& [key, section] :
       {std::pair{"section", &read.from}, {"from", &read.from}, {"to", &read.to}}) {
    const std::string name = name_under(written, key);
    if (name.empty()) continue;
    const Node* table = sections->find(name);
    if (table == nullptr) return {};
    const bool in_reach = name.find_first_of(".=\"") == std::string::npos;
    if (!in_reach || section->inner) return {};
    const std::vector<Said> said = said_in(*table, section->outer, group);
    if (said.empty()) return {};
    for (const auto& [plate, thickness] : said) {
      // What is no key of the table is a size of a standard profile.
      if (table->find(plate) == nullptr) return {};
      std::string full = fmt::format("sections.{}.{}", name, plate);
      if (std::any_of(keys.begin(), keys.end(),
                      [&](const PlateKey& other) { return other.key == full; })) {
        continue;
      }
      keys.push_back({std::move(full), thickness});
    }
  }
  return keys;
}

}  // namespace boxbeam
