#include "several_beams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "boxbeam/project/limits.hpp"

namespace boxbeam::readers {
namespace {

/// What a beam may say itself, and by which key the case says it for all. Points of a beam are
/// something else in frames.
struct OwnPart {
  const char* key;
  const char* of_case;
};
constexpr std::array own_parts{
    OwnPart{"material", "material"},     OwnPart{"part_materials", "part_materials"},
    OwnPart{"strength", "strength"},     OwnPart{"fatigue", "fatigue"},
    OwnPart{"section_points", "points"}, OwnPart{"welds", "welds"},
    OwnPart{"deflection", "deflection"}};

/// What lies at stations of a beam.
constexpr std::array along_a_beam{"points", "welds", "deflection", "given_stresses",
                                  "part_materials"};

const std::vector<Node>* beams_of(const Node& root) {
  const Node* const beams = root.find("beam");
  return beams != nullptr && beams->kind == Node::Kind::array ? &beams->items : nullptr;
}

Node::Member* member_of(Node& table, const std::string& key) {
  const auto found = std::find_if(table.members.begin(), table.members.end(),
                                  [&](const Node::Member& member) { return member.key == key; });
  return found != table.members.end() ? &*found : nullptr;
}

/// Puts a value before the one that stands there; of tables key by key.
void put_before(const std::string& key, const Node::Member& own, Node& table) {
  Node::Member* const there = member_of(table, key);
  if (there == nullptr) {
    table.members.push_back({key, own.key_place, own.value});
  } else if (there->value.kind == Node::Kind::table && own.value.kind == Node::Kind::table) {
    for (const Node::Member& member : own.value.members)
      put_before(member.key, member, there->value);
  } else {
    there->value = own.value;
  }
}

}  // namespace

Node case_of_beam(const Node& root, std::size_t beam) {
  Node of = root;
  const Node* own = root.find("beam");
  if (own != nullptr && own->kind == Node::Kind::array)
    own = beam < own->items.size() ? &own->items[beam] : nullptr;
  if (own == nullptr) return of;
  for (const OwnPart& part : own_parts) {
    const auto found =
        std::find_if(own->members.begin(), own->members.end(),
                     [&](const Node::Member& member) { return member.key == part.key; });
    if (found != own->members.end()) put_before(part.of_case, *found, of);
  }
  // A material of the beam's own is another one, not a change of the case's.
  if (const Node* material = own->find("material")) member_of(of, "material")->value = *material;
  return of;
}

bool differ_in_demands(const Node& root) {
  const std::vector<Node>* const beams = beams_of(root);
  if (beams == nullptr) return false;
  return std::any_of(beams->begin(), beams->end(), [](const Node& beam) {
    return beam.find("material") != nullptr || beam.find("strength") != nullptr ||
           beam.find("fatigue") != nullptr;
  });
}

void check_beams(ProblemList& problems, const Node& root) {
  const std::vector<Node>* const beams = beams_of(root);
  if (beams == nullptr) return;
  if (beams->empty())
    problems.add(root.find("beam")->place, "the case has no beam",
                 "write [beam] and its keys below");
  if (beams->size() > limits::most_beams) {
    problems.add(root.find("beam")->place, fmt::format("{} beams are too many", beams->size()),
                 fmt::format("at most {}", limits::most_beams));
  }
  if (beams->size() < 2) return;
  std::set<std::string> names;
  for (const Node& beam : *beams) {
    const Node* const name = beam.find("name");
    if (name == nullptr || name->kind != Node::Kind::text || name->text.empty()) {
      problems.add(beam.place, "of several beams each has a name", "write name = \"boom\"");
    } else if (!is_plain_name(name->text)) {
      problems.add(name->place, "the name of a beam is also the name of its report folder",
                   "use letters, digits, \"-\" and \"_\"");
    } else if (!names.insert(name->text).second) {
      problems.add(name->place, fmt::format("there is already a beam \"{}\"", name->text),
                   "give every beam a name of its own");
    }
  }
  const auto refuse = [&](const Node& there, const std::string& key) {
    const std::string_view own = key == "points" ? std::string_view("section_points") : key;
    problems.add(there.place,
                 fmt::format("which of the {} beams \"{}\" is on is not said", beams->size(), key),
                 fmt::format("write it within its [[beam]], as \"beam.{}\"", own));
  };
  for (const char* key : along_a_beam) {
    if (const Node* there = root.find(key)) refuse(*there, key);
  }
  const Node* const fatigue = root.find("fatigue");
  if (fatigue == nullptr || fatigue->kind != Node::Kind::table) return;
  if (const Node* details = fatigue->find("details")) refuse(*details, "fatigue.details");
}

TableReader beam_table(TableReader& root, std::size_t beam) {
  TableReader table =
      root.one_of_tables({"beam", "the verified beam; [[beam]] where there are several"}, beam);
  static_cast<void>(table.text({"name", "of the beam; of several each has one"}, ""));
  for (const OwnPart& part : own_parts) {
    table.accept_as_in_case({part.key, part.key == std::string_view(part.of_case)
                                           ? "of this beam, before what the case says for all"
                                           : "[[points]] of this beam"});
  }
  return table;
}

TableReader beam_table(TableReader& root, const Project& project) {
  return beam_table(root, project.beam_index);
}

std::vector<OtherBeam> read_other_beams(TableReader& root, const Key& key, const Sections& sections,
                                        const Project& project) {
  std::vector<OtherBeam> others;
  for (std::size_t i = 0; i < root.count_of("beam"); ++i) {
    if (i == project.beam_index) continue;
    TableReader table = beam_table(root, i);
    OtherBeam& other = others.emplace_back();
    other.on = table.text(key, "");
    other.beam = read_tapered_beam(table, sections);
    table.accept_all();
  }
  return others;
}

std::vector<std::string> names_of_beams(const std::string& verified,
                                        const std::vector<OtherBeam>& others) {
  std::vector<std::string> names{verified};
  for (const OtherBeam& other : others) names.push_back(other.on);
  return names;
}

}  // namespace boxbeam::readers
