#include "boxbeam/project/case_lists.hpp"

#include <fmt/format.h>

#include <array>
#include <set>

#include "boxbeam/project/case_document.hpp"

namespace boxbeam {
namespace {

CaseDocument document_of(const Project& project) {
  return parse_document(project.path, project.text, project.overrides);
}

/// "beam", or "beam.1" where they stand in a list.
std::string key_of_beam(const Node& root, const Project& project) {
  const Node* const beam = root.find("beam");
  const bool listed = beam != nullptr && beam->kind == Node::Kind::array;
  return listed ? fmt::format("beam.{}", project.beam_index) : "beam";
}

/// Names of the sections at the start and at the end of a segment; "" where one has none.
using EndNames = std::array<std::string, 2>;

EndNames names_at(const Node& segment) {
  const auto name = [&](const char* key) {
    const Node* const of = segment.find(segment.find("section") != nullptr ? "section" : key);
    return of != nullptr && of->kind == Node::Kind::text ? of->text : std::string();
  };
  return {name("from"), name("to")};
}

/// All names that are joined to those of one segment by segments that have one of each.
std::set<std::string> joined_to(const EndNames& first, const std::vector<EndNames>& segments) {
  std::set<std::string> names(first.begin(), first.end());
  for (std::size_t before = 0; before != names.size();) {
    before = names.size();
    for (const EndNames& ends : segments) {
      if (names.contains(ends[0]) || names.contains(ends[1]))
        names.insert(ends.begin(), ends.end());
    }
  }
  return names;
}

}  // namespace

AlikeBoxes alike_boxes_of(const Project& project, std::size_t segment) {
  const CaseDocument document = document_of(project);
  const Node* const written =
      value_at(document.root, key_of_beam(document.root, project) + ".segments");
  if (written == nullptr || written->items.size() != project.beam.segments.size()) return {};
  std::vector<EndNames> ends;
  for (const Node& of : written->items) ends.push_back(names_at(of));
  const std::set<std::string> names = joined_to(ends[segment], ends);
  AlikeBoxes alike;
  for (const std::string& name : names) {
    const bool in_reach = !name.empty() && name.find_first_of(".=\"") == std::string::npos;
    const Node* const table = in_reach ? value_at(document.root, "sections." + name) : nullptr;
    const Node* const kind = table != nullptr ? table->find("kind") : nullptr;
    if (kind == nullptr || kind->text != "box") return {};
  }
  std::set<std::string> seen;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Segment& read = project.beam.segments[i];
    alike.segments.push_back(names.contains(ends[i][0]));
    if (!alike.segments.back()) continue;
    for (const auto& [name, section] :
         {std::pair{ends[i][0], &read.from}, {ends[i][1], &read.to}}) {
      if (seen.insert(name).second) alike.boxes.push_back({name, std::get<Box>(section->outer)});
    }
  }
  return alike;
}

std::string diaphragms_key_of(const Project& project) {
  return key_of_beam(document_of(project).root, project) + ".diaphragms";
}

std::vector<std::string> added_to(const Project& project, const std::string& key,
                                  const std::vector<std::string>& tables) {
  if (tables.empty()) return {};
  const CaseDocument document = document_of(project);
  const Node* const there = value_at(document.root, key);
  if (there == nullptr) return {fmt::format("{}=[{}]", key, fmt::join(tables, ", "))};
  std::vector<std::string> added;
  for (std::size_t i = 0; i < tables.size(); ++i)
    added.push_back(fmt::format("{}.{}={}", key, there->items.size() + i, tables[i]));
  return added;
}

}  // namespace boxbeam
