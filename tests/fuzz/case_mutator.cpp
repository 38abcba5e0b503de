#include "fuzz/case_mutator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>

#include "boxbeam/report/case_schema.hpp"

namespace fuzz {
namespace {

using boxbeam::Node;
using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t limit) {
  return limit == 0 ? 0 : static_cast<std::size_t>(random() % limit);
}

bool chance(Random& random, std::size_t one_in) { return below(random, one_in) == 0; }

template <class Values>
const auto& one_of(Random& random, const Values& values) {
  return values[below(random, std::size(values))];
}

/// Nearly always one of the small cases, which are verified in milliseconds and together use every
/// key; so rarely a large one, such as those that are shipped, that these take no more of the time.
const Origin& some_origin(Random& random, const std::vector<Origin>& origins) {
  constexpr std::size_t one_large_in = 64;
  const auto large =
      std::find_if(origins.begin(), origins.end(), [](const Origin& of) { return !of.small; });
  const auto small_ones = static_cast<std::size_t>(large - origins.begin());
  if (small_ones == 0) return one_of(random, origins);
  if (small_ones < origins.size() && chance(random, one_large_in))
    return origins[small_ones + below(random, origins.size() - small_ones)];
  return origins[below(random, small_ones)];
}

/// A node with what stands around it.
struct Site {
  Node* node = nullptr;
  Node* parent = nullptr;
  std::size_t index = 0;  ///< in the parent's members or items
  std::string key;        ///< of a member, of an item that of its array
};

void collect(Node& node, const std::string& key, std::vector<Site>& sites) {
  for (std::size_t i = 0; i < node.members.size(); ++i) {
    Node::Member& member = node.members[i];
    sites.push_back({&member.value, &node, i, member.key});
    collect(member.value, member.key, sites);
  }
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    sites.push_back({&node.items[i], &node, i, key});
    collect(node.items[i], key, sites);
  }
}

std::vector<Site> sites_of(Node& tree) {
  std::vector<Site> sites;
  collect(tree, "", sites);
  return sites;
}

bool is_value(const Node& node) {
  return node.kind != Node::Kind::table && node.kind != Node::Kind::array;
}

constexpr std::array factors{0.0, -1.0, 0.5, 2.0,  1.001, 0.9,  1e-3, 1e3, 1e-6,
                             1e6, 1e-9, 1e9, 1e12, 1e-12, -1e3, 10.0, 0.1};
constexpr std::array units{"m",     "mm",   "kg", "t",      "s",      "Hz",    "rad",     "deg",
                           "rad/s", "rpm",  "N",  "kN",     "kN m",   "MPa",   "GPa",     "m/s^2",
                           "N/m",   "kg/m", "",   "kg m^2", "kg/m^3", "N s/m", "N m/rad", "1"};
constexpr std::array wild_texts{"",       "0",   "-0 m",     "1e308 m", "1e-300 m", "9.99e19 kg",
                                "ground", "0 m", "1e15 N/m", "rigid",   "1 mm",     "90 deg"};
constexpr std::array wild_numbers{0.0,  -1.0, 1.0,  2.0,   0.5,  1e-9,  1e9,  1e15,   -1e-3,
                                  1e20, 3.0,  16.0, 1e-20, 71.0, 1e300, 0.99, 1000.0, 2000.0};

/// What the schema of a case says of a key: its words, or what kind of value it wants.
struct SchemaKey {
  std::string name;
  nlohmann::json schema;
};

/// The keys that stand beside each other in a table, of every table of the schema.
const std::vector<std::vector<SchemaKey>>& tables_of_schema() {
  static const std::vector<std::vector<SchemaKey>> tables = [] {
    std::vector<std::vector<SchemaKey>> all;
    const std::function<void(const nlohmann::json&)> collect = [&](const nlohmann::json& schema) {
      if (schema.is_object() && schema.contains("properties")) {
        std::vector<SchemaKey>& table = all.emplace_back();
        for (const auto& [name, of] : schema["properties"].items()) table.push_back({name, of});
      }
      if (schema.is_structured()) {
        for (const nlohmann::json& part : schema) collect(part);
      }
    };
    collect(nlohmann::json::parse(boxbeam::schema_of("case")));
    return all;
  }();
  return tables;
}

/// Every word that the schema knows.
const std::vector<std::string>& words_of_schema() {
  static const std::vector<std::string> words = [] {
    std::vector<std::string> all;
    for (const auto& table : tables_of_schema()) {
      for (const SchemaKey& key : table) {
        for (const nlohmann::json& word : key.schema.value("enum", nlohmann::json::array())) {
          if (word.is_string()) all.push_back(word.get<std::string>());
        }
      }
    }
    return all;
  }();
  return words;
}

Node value_for(Random& random, const SchemaKey& key) {
  constexpr std::array quantities{"10 mm", "0.2 m", "5 deg", "1 kN", "2 MPa", "1 s", "3 kg", "0 m"};
  Node node;
  const nlohmann::json words = key.schema.value("enum", nlohmann::json::array());
  const nlohmann::json type = key.schema.value("type", nlohmann::json("string"));
  if (!words.empty() && one_of(random, words).is_string()) {
    node.kind = Node::Kind::text;
    node.text = words[below(random, words.size())].get<std::string>();
  } else if (type == "boolean") {
    node.kind = Node::Kind::boolean;
    node.boolean = chance(random, 2);
  } else if (type == "number" || type == "integer") {
    node.kind = Node::Kind::number;
    node.number = one_of(random, wild_numbers);
  } else {
    node.kind = Node::Kind::text;
    node.text = one_of(random, quantities);
  }
  return node;
}

/// A key of the schema that may stand beside one of a table's own.
void add_key(Random& random, Node& table) {
  if (table.members.empty()) return;
  const std::string& beside = one_of(random, table.members).key;
  std::vector<const std::vector<SchemaKey>*> fitting;
  for (const auto& keys : tables_of_schema()) {
    if (std::any_of(keys.begin(), keys.end(), [&](const auto& key) { return key.name == beside; }))
      fitting.push_back(&keys);
  }
  if (fitting.empty()) return;
  const SchemaKey& key = one_of(random, *one_of(random, fitting));
  std::erase_if(table.members, [&](const Node::Member& of) { return of.key == key.name; });
  Node::Member& added = table.members.emplace_back();
  added.key = key.name;
  added.value = value_for(random, key);
}

/// A quantity with another number in front of its unit, any other text as a word of the schema
/// or a wild one.
void change_text(Random& random, Node& node) {
  double number = 0.0;
  const auto [end, error] =
      std::from_chars(node.text.data(), node.text.data() + node.text.size(), number);
  const bool is_word = error != std::errc{};
  if (is_word && chance(random, 2)) {
    node.text = one_of(random, words_of_schema());
    return;
  }
  if (is_word || chance(random, 12)) {
    node.text = one_of(random, wild_texts);
    return;
  }
  const std::string unit = node.text.substr(static_cast<std::size_t>(end - node.text.data()));
  switch (below(random, 8)) {
    case 0: node.text = fmt::format("{:g} {}", number, one_of(random, units)); break;
    case 1: {
      // A few per cent, to and fro.
      const double part = 0.9 + 0.2 * static_cast<double>(below(random, 1001)) / 1000.0;
      node.text = fmt::format("{:.12g}{}", number * part, unit);
      break;
    }
    case 2: {
      const double power = -12.0 + 24.0 * static_cast<double>(below(random, 1001)) / 1000.0;
      node.text = fmt::format("{:.6g}{}", std::pow(10.0, power), unit);
      break;
    }
    default: node.text = fmt::format("{:.12g}{}", number * one_of(random, factors), unit);
  }
}

void change_value(Random& random, Node& node) {
  switch (node.kind) {
    case Node::Kind::text: change_text(random, node); break;
    case Node::Kind::boolean: node.boolean = !node.boolean; break;
    case Node::Kind::number:
      node.number =
          chance(random, 2) ? one_of(random, wild_numbers) : node.number * one_of(random, factors);
      node.whole = node.whole && std::abs(node.number) < 1e15 && !chance(random, 8);
      if (node.whole) node.number = std::round(node.number);
      break;
    default: break;
  }
}

void remove(const Site& site) {
  const auto at = static_cast<std::ptrdiff_t>(site.index);
  if (site.parent->kind == Node::Kind::array)
    site.parent->items.erase(site.parent->items.begin() + at);
  else
    site.parent->members.erase(site.parent->members.begin() + at);
}

/// A copy beside the original, of a member under a name of its own.
void copy(Random& random, const Site& site) {
  const auto at = static_cast<std::ptrdiff_t>(site.index);
  // Forty of a segment take seconds.
  const std::size_t times = chance(random, 300) ? 40 : 1;
  for (std::size_t i = 0; i < times; ++i) {
    if (site.parent->kind == Node::Kind::array) {
      const Node same = site.parent->items[site.index];
      site.parent->items.insert(site.parent->items.begin() + at, same);
    } else {
      Node::Member same = site.parent->members[site.index];
      same.key += fmt::format("_{}", i);
      site.parent->members.push_back(std::move(same));
    }
  }
}

/// What stands in a tree under a key and is of a kind, items under the key of their array.
void collect_alike(const Node& node, const std::string& key, const Site& site,
                   std::vector<const Node*>& alike) {
  const auto look_at = [&](const Node& of, const std::string& its_key) {
    if (its_key == site.key && of.kind == site.node->kind) alike.push_back(&of);
    collect_alike(of, its_key, site, alike);
  };
  for (const Node::Member& member : node.members) look_at(member.value, member.key);
  for (const Node& item : node.items) look_at(item, key);
}

/// Something of another case under the same key in the place of this.
void splice(Random& random, const std::vector<Origin>& origins, const Site& site) {
  std::vector<const Node*> alike;
  collect_alike(some_origin(random, origins).tree, "", site, alike);
  if (!alike.empty()) *site.node = Node(*one_of(random, alike));
}

/// A whole part of another case, [model] or one of its forces, in a part of that name.
void take_part(Random& random, const std::vector<Origin>& origins, Node& tree) {
  const Node& other = some_origin(random, origins).tree;
  if (other.members.empty()) return;
  const Node::Member& part = one_of(random, other.members);
  const auto here = std::find_if(tree.members.begin(), tree.members.end(),
                                 [&](const Node::Member& of) { return of.key == part.key; });
  if (here == tree.members.end() || chance(random, 4)) {
    if (here != tree.members.end()) tree.members.erase(here);
    tree.members.push_back(part);
  } else if (!part.value.members.empty() && here->value.kind == Node::Kind::table) {
    const Node::Member& one = one_of(random, part.value.members);
    std::erase_if(here->value.members, [&](const Node::Member& of) { return of.key == one.key; });
    here->value.members.push_back(one);
  } else if (!part.value.items.empty() && here->value.kind == Node::Kind::array) {
    here->value.items.push_back(one_of(random, part.value.items));
  }
}

void mutate(Random& random, const std::vector<Origin>& origins, Node& tree) {
  std::vector<Site> sites = sites_of(tree);
  if (sites.empty()) return;
  std::vector<Site> values;
  std::copy_if(sites.begin(), sites.end(), std::back_inserter(values),
               [](const Site& site) { return is_value(*site.node); });
  switch (below(random, 16)) {
    case 0: remove(one_of(random, sites)); break;
    case 1: copy(random, one_of(random, sites)); break;
    case 2: splice(random, origins, one_of(random, sites)); break;
    case 3: take_part(random, origins, tree); break;
    case 4:
      if (!values.empty()) {
        // Two values change places.
        std::swap(*one_of(random, values).node, *one_of(random, values).node);
      }
      break;
    case 5:
      if (!values.empty()) splice(random, origins, one_of(random, values));
      break;
    case 6: {
      std::erase_if(sites, [](const Site& of) { return of.node->kind != Node::Kind::table; });
      if (!sites.empty()) add_key(random, *one_of(random, sites).node);
      break;
    }
    default:
      if (!values.empty()) change_value(random, *one_of(random, values).node);
  }
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) < 0x20) {
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      result += c;
    }
  }
  return result + "\"";
}

void write(const Node& node, std::string& toml) {
  switch (node.kind) {
    case Node::Kind::text: toml += quoted(node.text); break;
    case Node::Kind::boolean: toml += node.boolean ? "true" : "false"; break;
    case Node::Kind::number:
      if (node.whole)
        toml += fmt::format("{:.0f}", node.number);
      else if (std::isnan(node.number))
        toml += "nan";
      else if (std::isinf(node.number))
        toml += node.number > 0.0 ? "inf" : "-inf";
      else
        toml += fmt::format("{:.15e}", node.number);
      break;
    case Node::Kind::array:
      toml += "[";
      for (const Node& item : node.items) {
        write(item, toml);
        toml += ", ";
      }
      toml += "]";
      break;
    case Node::Kind::table: {
      toml += "{";
      bool first = true;
      for (const Node::Member& member : node.members) {
        toml += fmt::format("{}{} = ", first ? "" : ", ", quoted(member.key));
        write(member.value, toml);
        first = false;
      }
      toml += "}";
      break;
    }
    case Node::Kind::other: toml += "1979-05-27"; break;
  }
}

/// Tables of the file and lists of tables stand one entry a line, for who looks at a finding.
void write_part(const std::string& name, const Node& node, std::string& toml) {
  const bool tables = node.kind == Node::Kind::array && !node.items.empty() &&
                      std::all_of(node.items.begin(), node.items.end(),
                                  [](const Node& item) { return item.kind == Node::Kind::table; });
  const auto members = [&](const Node& of) {
    for (const Node::Member& member : of.members) {
      toml += quoted(member.key) + " = ";
      write(member.value, toml);
      toml += "\n";
    }
  };
  if (node.kind == Node::Kind::table) {
    toml += fmt::format("\n[{}]\n", name);
    members(node);
  } else if (tables) {
    for (const Node& item : node.items) {
      toml += fmt::format("\n[[{}]]\n", name);
      members(item);
    }
  }
}

}  // namespace

std::string toml_of(const Node& tree) {
  std::string toml;
  const auto is_part = [](const Node& node) {
    return node.kind == Node::Kind::table ||
           (node.kind == Node::Kind::array && !node.items.empty() &&
            std::all_of(node.items.begin(), node.items.end(),
                        [](const Node& item) { return item.kind == Node::Kind::table; }));
  };
  for (const Node::Member& member : tree.members) {
    if (is_part(member.value)) continue;
    toml += quoted(member.key) + " = ";
    write(member.value, toml);
    toml += "\n";
  }
  for (const Node::Member& member : tree.members) {
    if (is_part(member.value)) write_part(quoted(member.key), member.value, toml);
  }
  return toml;
}

std::vector<Origin> origins_in(const std::vector<std::string>& folders) {
  namespace fs = std::filesystem;
  std::vector<std::string> paths;
  for (const std::string& folder : folders) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      const std::string path = entry.path().string();
      const auto in = [&](const char* name) { return path.find(name) != std::string::npos; };
      if (!path.ends_with(".toml") || in("/catalogue/") || in("/studies/")) continue;
      paths.push_back(path);
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<Origin> origins;
  for (const std::string& path : paths) {
    std::ifstream file(path, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    const bool small = path.find("/small/") != std::string::npos;
    origins.push_back({path, boxbeam::parse_document(path, text, {}).root, small});
  }
  std::stable_partition(origins.begin(), origins.end(), [](const Origin& of) { return of.small; });
  return origins;
}

Mutant mutant_of(const std::vector<Origin>& origins, std::uint64_t number) {
  Random random(number * 0x9e3779b97f4a7c15U + 1);
  const Origin& origin = some_origin(random, origins);
  Node tree = origin.tree;
  int changes = 1;
  while (changes < 6 && chance(random, 2)) ++changes;
  for (int i = 0; i < changes; ++i) mutate(random, origins, tree);
  return {origin.path, toml_of(tree), static_cast<std::size_t>(&origin - origins.data())};
}

}  // namespace fuzz
