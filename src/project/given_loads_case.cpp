#include "boxbeam/project/given_loads_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "boxbeam/project/toml_text.hpp"
#include "several_beams.hpp"

namespace boxbeam {
namespace {

constexpr std::array cut_words{"N", "V_y", "V_z", "T", "M_y", "M_z"};

Node text_node(std::string text) {
  Node node;
  node.kind = Node::Kind::text;
  node.text = std::move(text);
  return node;
}

Node number_node(double number) {
  Node node;
  node.kind = Node::Kind::number;
  node.number = number;
  return node;
}

Node metres(Length s) { return text_node(fmt::format("{} m", s.value())); }

Node array_node(std::vector<Node> items) {
  Node node;
  node.kind = Node::Kind::array;
  node.items = std::move(items);
  return node;
}

void put(Node& table, const std::string& key, Node value) {
  const auto old = std::find_if(table.members.begin(), table.members.end(),
                                [&](const Node::Member& member) { return member.key == key; });
  if (old != table.members.end())
    old->value = std::move(value);
  else
    table.members.push_back({key, {}, std::move(value)});
}

/// A table of the case with only the named keys, or nothing.
void keep(const Node& root, const char* name, std::initializer_list<std::string_view> keys,
          Node& to) {
  const Node* const table = root.find(name);
  if (table == nullptr) return;
  Node kept = *table;
  std::erase_if(kept.members, [&](const Node::Member& member) {
    return std::find(keys.begin(), keys.end(), member.key) == keys.end();
  });
  if (!kept.members.empty()) put(to, name, std::move(kept));
}

Node case_of(const Project& project, const Node& root) {
  Node of = *root.find("case");
  std::erase_if(of.members, [](const Node::Member& member) { return member.key == "dynamics"; });
  // A folder of its own for the report.
  put(of, "name", text_node((project.name + "-loads").substr(0, 80)));
  put(of, "kind", text_node("loads"));
  return of;
}

/// Where the line is that a deflection is measured from, said in stations.
Node deflection_of(const DeflectionInput& deflection) {
  Node of;
  put(of, "limit", metres(deflection.limit));
  if (const auto* chord = std::get_if<Chord>(&deflection.against)) {
    put(of, "against", text_node("chord"));
    put(of, "from", metres(chord->from));
    put(of, "to", metres(chord->to));
  } else if (const auto* tangent = std::get_if<Tangent>(&deflection.against)) {
    put(of, "against", text_node("tangent"));
    put(of, "at", metres(tangent->at));
  }
  Node factor;
  factor.kind = Node::Kind::boolean;
  factor.boolean = deflection.load_factor;
  put(of, "load_factor", std::move(factor));
  const auto modulus = [](Stress of_it) { return text_node(fmt::format("{} Pa", of_it.value())); };
  put(of, "youngs_modulus", modulus(deflection.youngs_modulus));
  put(of, "shear_modulus", modulus(deflection.shear_modulus));
  return of;
}

Node situations_of(const Project& project, const std::vector<std::string>& files) {
  std::vector<Node> all;
  std::size_t run = 0;
  for (const Situation& situation : project.situations) {
    Node of;
    put(of, "name", text_node(situation.name));
    if (project.fatigue.asked && !situation.spectrum.empty()) {
      std::vector<Node> levels;
      for (const SpectrumLevel& level : situation.spectrum) {
        Node& one = levels.emplace_back();
        put(one, "share", number_node(level.share));
        put(one, "cycles", number_node(level.cycles));
      }
      put(of, "spectrum", array_node(std::move(levels)));
    } else if (project.fatigue.asked && situation.cycles > 0.0) {
      put(of, "cycles", number_node(situation.cycles));
    }
    if (situation.runs()) {
      put(of, "load_factor", number_node(situation.load_factor));
      if (run > 0) {
        Node set;
        put(set, "files.cut_forces.path", text_node(files[run]));
        put(of, "set", std::move(set));
      }
      ++run;
    } else {
      std::vector<Node> names;
      for (const std::size_t part : situation.between)
        names.push_back(text_node(project.situations[part].name));
      put(of, situation.in_order ? "sequence" : "between", array_node(std::move(names)));
    }
    all.push_back(std::move(of));
  }
  return array_node(std::move(all));
}

Node cuts_of(const std::vector<GivenCut>& cuts) {
  std::vector<Node> all;
  for (const GivenCut& cut : cuts) {
    Node of, columns;
    put(of, "station", metres(cut.s));
    for (std::size_t k = 0; k < cut_words.size(); ++k) {
      if (!cut.columns[k].empty()) put(columns, cut_words[k], text_node(cut.columns[k]));
    }
    put(of, "columns", std::move(columns));
    all.push_back(std::move(of));
  }
  return array_node(std::move(all));
}

}  // namespace

std::vector<std::string> obstacles_to_given_loads(const Project& project) {
  std::vector<std::string> obstacles;
  for (const PinInput& pin : project.pins)
    obstacles.push_back(fmt::format("pin \"{}\" is judged by the force of a joint", pin.name));
  for (const RodInput& rod : project.rods)
    obstacles.push_back(fmt::format("rod \"{}\" is judged by the forces of joints", rod.name));
  if (!project.given_stresses.empty())
    obstacles.emplace_back("its stresses are given and not those of cut forces");
  if (!project.deflection) return obstacles;
  if (std::holds_alternative<UnloadedAxis>(project.deflection->against))
    obstacles.emplace_back(
        "its deflection is measured from the unloaded axis, which needs the supports");
  if (std::any_of(project.situations.begin(), project.situations.end(),
                  [](const Situation& of) { return !of.serviceability; }))
    obstacles.emplace_back("some of its combinations do not count for its deflection");
  return obstacles;
}

std::string given_loads_case(const Project& project, const GivenLoads& loads) {
  Node root = readers::case_of_beam(
      parse_document(project.path, project.text, project.overrides).root, project.beam_index);
  if (const Node* beams = root.find("beam"); beams->kind == Node::Kind::array)
    put(root, "beam", Node(beams->items[project.beam_index]));
  Node of;
  put(of, "case", case_of(project, root));
  for (const char* name :
       {"sections", "material", "part_materials", "strength", "fatigue", "points", "welds"}) {
    if (const Node* table = root.find(name)) put(of, name, *table);
  }
  keep(root, "beam",
       {"density", "rotary_inertia", "segments", "diaphragms", "load_introductions", "places",
        "holes", "restraints"},
       of);
  keep(root, "model", {"youngs_modulus", "shear_modulus"}, of);
  if (project.deflection) put(of, "deflection", deflection_of(*project.deflection));

  Node file, files;
  put(file, "path", text_node(loads.files.front()));
  put(files, "cut_forces", std::move(file));
  put(of, "files", std::move(files));
  if (!loads.held.empty()) {
    std::vector<Node> held;
    for (const Length& s : loads.held) held.push_back(metres(s));
    Node balance;
    put(balance, "held", array_node(std::move(held)));
    put(of, "balance", std::move(balance));
  }
  const bool only = project.situations.size() == 1 && project.situations.front().name.empty();
  if (!only) put(of, "situations", situations_of(project, loads.files));
  put(of, "cut_forces", cuts_of(loads.cuts));
  return toml_text(of);
}

}  // namespace boxbeam
