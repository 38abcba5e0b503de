#include "key_documents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "boxbeam/project/key_reference.hpp"
#include "boxbeam/project/limits.hpp"

namespace boxbeam::report {
namespace {

using json = nlohmann::ordered_json;

/// Whether a quantity may stand with a sign.
enum class Sign { any, none, not_zero };

constexpr const char* prefix = "[nuµmckMG]?";

/// Units of a dimension as a regular expression: exact for the plain ones, else any product.
std::string units_of(const DimensionExponents& of) {
  if (of == DimensionExponents{1, 0, 0, 0}) return fmt::format("{}m", prefix);
  if (of == DimensionExponents{2, 0, 0, 0}) return fmt::format("{}m\\^2", prefix);
  if (of == DimensionExponents{0, 1, 0, 0}) return fmt::format("({}g|t)", prefix);
  if (of == DimensionExponents{0, 0, 1, 0}) return fmt::format("({}s|min|h)", prefix);
  if (of == DimensionExponents{0, 0, 0, 1}) return fmt::format("({}rad|deg)", prefix);
  if (of == DimensionExponents{0, 0, 0, 0, 1}) return "K";
  if (of == DimensionExponents{0, 0, 0, 0, -1}) return "(1/|/)K";
  const std::string unit =
      fmt::format("({}(m|g|s|rad|Hz|N|Pa|bar|J|W)|t|min|h|deg|rpm|K)(\\^-?[1-9]|²|³)?", prefix);
  return fmt::format("{}([\\s*·/]+{})*", unit, unit);
}

/// Puts a schema among the definitions where it is not there yet, and refers to it.
using Refer = std::function<json(const json& schema, const std::string& name)>;

json quantity(const AskedKey& key, Sign sign, const Refer& refer) {
  json of;
  of["type"] = "string";
  of["pattern"] = fmt::format("^\\s*[+]?{}(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?\\s*{}\\s*$",
                              sign == Sign::any    ? "-?"
                              : sign == Sign::none ? ""
                                                   : "(?=[\\d.]*[1-9])",
                              units_of(key.exponents));
  // Of "0.25 m" or "250 mm" the examples are both.
  for (std::size_t begin = key.example.find('"'); begin != std::string::npos;
       begin = key.example.find('"', begin)) {
    const std::size_t end = key.example.find('"', begin + 1);
    of["examples"].push_back(key.example.substr(begin + 1, end - begin - 1));
    begin = end + 1;
  }
  std::string name = key.dimension.substr(key.dimension.find(' ') + 1);
  std::replace(name.begin(), name.end(), ' ', '-');
  return refer(of, name);
}

json text(bool required) {
  json of{{"type", "string"}};
  if (required) of["minLength"] = 1;
  return of;
}

json list_of(json items, std::size_t count = 0) {
  json of{{"type", "array"}, {"items", std::move(items)}};
  if (count > 0) of["minItems"] = of["maxItems"] = count;
  return of;
}

json one_of(std::initializer_list<json> several) {
  json of;
  for (const json& one : several) of["oneOf"].push_back(one);
  return of;
}

json direction() {
  const json axis{{"type", "string"}, {"pattern", "^-?[xyz]$"}};
  return one_of({axis, list_of({{"type", "number"}}, 3)});
}

/// What a key's value is, where it is neither a table nor a list of them.
json value_of(const AskedKey& key, const Refer& refer) {
  switch (key.shape) {
    case KeyShape::quantity:
    case KeyShape::not_zero: return quantity(key, Sign::any, refer);
    case KeyShape::positive: return quantity(key, Sign::not_zero, refer);
    case KeyShape::not_negative: return quantity(key, Sign::none, refer);
    case KeyShape::pair: return list_of(quantity(key, Sign::any, refer), 2);
    case KeyShape::pairs: return list_of(list_of(quantity(key, Sign::any, refer), 2));
    case KeyShape::lists_of_pairs:
      return list_of(list_of(list_of(quantity(key, Sign::any, refer), 2)));
    case KeyShape::triple: return list_of(quantity(key, Sign::any, refer), 3);
    case KeyShape::symmetric:
      return one_of({list_of(quantity(key, Sign::any, refer), 3),
                     list_of(list_of(quantity(key, Sign::any, refer), 3), 3)});
    case KeyShape::direction: return direction();
    case KeyShape::directions: return list_of(direction(), 3);
    case KeyShape::turns: {
      AskedKey angle;
      angle.exponents = wanted::angle.exponents;
      angle.example = wanted::angle.example;
      angle.dimension = wanted::angle.name;
      json turn{{"type", "array"},
                {"prefixItems", {direction(), quantity(angle, Sign::any, refer)}}};
      turn["minItems"] = turn["maxItems"] = 2;
      return one_of({turn, list_of(turn)});
    }
    case KeyShape::quantities: {
      json of = list_of(quantity(key, Sign::any, refer));
      of["minItems"] = 1;
      return of;
    }
    case KeyShape::each_quantity: {
      AskedKey any = key;  // of derivatives, each of a dimension of its own
      any.exponents = {0, 1, 1, 1};
      any.dimension = "a quantity";
      any.example.clear();
      json of = list_of(quantity(any, Sign::any, refer));
      of["minItems"] = 1;
      return of;
    }
    case KeyShape::per_direction: {
      json one = quantity(key, Sign::none, refer);
      if (!key.words.empty()) one = one_of({one, {{"const", key.words.front()}}});
      return one_of({one, list_of(one)});
    }
    case KeyShape::number:
      return {{"type", "number"}, {"exclusiveMinimum", 0}, {"maximum", limits::largest_number}};
    case KeyShape::any_number: return {{"type", "number"}};
    case KeyShape::whole_number: {
      json of{{"type", "integer"}};
      for (const std::string& word : key.words) of["enum"].push_back(std::stoi(word));
      return of;
    }
    case KeyShape::boolean: return {{"type", "boolean"}};
    case KeyShape::text: return text(key.fallback.empty() && key.required);
    case KeyShape::texts: return list_of(text(true));
    case KeyShape::choice: return {{"enum", key.words}};
    case KeyShape::as_in_case: return {{"type", {"object", "array"}}};
    case KeyShape::unknown:
    case KeyShape::table:
    case KeyShape::tables:
    case KeyShape::table_or_tables: break;
  }
  return json::object();
}

/// The schemas of all tables of one kind of case, those that are alike once.
class Definitions {
 public:
  explicit Definitions(json& defs) : defs_(&defs) {}

  /// Describes the table of a pattern; returns a reference to it.
  json of_table(const std::vector<TableDescription>& reference, const std::string& pattern,
                const std::string& name) {
    const auto table =
        std::find_if(reference.begin(), reference.end(),
                     [&](const TableDescription& each) { return each.pattern == pattern; });
    if (table == reference.end()) return {{"type", "object"}};
    return refer(described(reference, *table), name);
  }

 private:
  json described(const std::vector<TableDescription>& reference, const TableDescription& table) {
    json schema{{"type", "object"}};
    json properties = json::object();
    std::vector<std::string> required;
    std::vector<std::pair<std::vector<KeyDescription::Only>, json>> parts;
    json wanted_with = json::array();
    bool closed = true;
    for (const KeyDescription& key : table.keys) {
      json value = of_key(reference, table.pattern, key.key);
      for (const auto& [other, word] : key.key.required_with)
        wanted_with.push_back(of_wanted_with(key.key.name, other, word));
      if (key.key.name == "*") {
        add(schema, "additionalProperties", std::move(value));
        closed = false;
        continue;
      }
      if (key.only.empty()) {
        add(properties, key.key.name, std::move(value));
        if (key.key.required &&
            std::find(required.begin(), required.end(), key.key.name) == required.end())
          required.push_back(key.key.name);
        continue;
      }
      auto part = std::find_if(parts.begin(), parts.end(),
                               [&](const auto& each) { return alike(each.first, key.only); });
      if (part == parts.end())
        part = parts.insert(parts.end(), {key.only, {{"properties", json::object()}}});
      add(part->second["properties"], key.key.name, std::move(value));
      json& wanted = part->second["required"];
      if (wanted.is_null()) wanted = json::array();
      if (key.key.required && std::find(wanted.begin(), wanted.end(), key.key.name) == wanted.end())
        wanted.push_back(key.key.name);
    }
    if (!properties.empty()) schema["properties"] = std::move(properties);
    if (!required.empty()) schema["required"] = required;
    for (auto& [only, then] : parts)
      schema["allOf"].push_back({{"if", condition(only)}, {"then", std::move(then)}});
    for (const WaysDescription& several : table.ways)
      schema["allOf"].push_back(within(several.only, of_ways(several.ways)));
    for (json& each : wanted_with) schema["allOf"].push_back(std::move(each));
    if (closed) schema[parts.empty() ? "additionalProperties" : "unevaluatedProperties"] = false;
    return schema;
  }

  /// Whether two keys are known in the same kinds of table, named in whatever order.
  static bool alike(const std::vector<KeyDescription::Only>& a,
                    const std::vector<KeyDescription::Only>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& one, const auto& other) {
                        return one.key == other.key &&
                               std::is_permutation(one.words.begin(), one.words.end(),
                                                   other.words.begin(), other.words.end());
                      });
  }

  /// A key that means several things has one of them.
  static void add(json& properties, const std::string& name, json value) {
    if (!properties.contains(name)) {
      properties[name] = std::move(value);
    } else if (properties[name].contains("anyOf")) {
      properties[name]["anyOf"].push_back(std::move(value));
    } else {
      json first = properties[name];
      properties[name] = {{"anyOf", {std::move(first), std::move(value)}}};
    }
  }

  json of_key(const std::vector<TableDescription>& reference, const std::string& pattern,
              const AskedKey& key) {
    const std::string below = pattern.empty() ? key.name : pattern + "." + key.name;
    json value;
    if (key.shape == KeyShape::table)
      value = of_table(reference, below, below);
    else if (key.shape == KeyShape::tables)
      value = list_of(of_table(reference, below + "[]", below));
    else if (key.shape == KeyShape::table_or_tables)
      value =
          one_of({of_table(reference, below, below), list_of(of_table(reference, below, below))});
    else
      value = value_of(
          key, [this](const json& schema, const std::string& name) { return refer(schema, name); });
    if (!key.meaning.empty()) value["description"] = key.meaning;
    return value;
  }

  static json condition(const std::vector<KeyDescription::Only>& only) {
    json of;
    for (const KeyDescription::Only& each : only) {
      if (each.words.size() == 1)
        of["properties"][each.key] = {{"const", each.words.front()}};
      else
        of["properties"][each.key] = {{"enum", each.words}};
      of["required"].push_back(each.key);
    }
    return of;
  }

  /// A schema that holds for some kinds of the table only.
  static json within(const std::vector<KeyDescription::Only>& only, json schema) {
    if (only.empty()) return schema;
    return {{"if", condition(only)}, {"then", std::move(schema)}};
  }

  /// Exactly one of several ways.
  static json of_ways(const KeyWays& ways) {
    json said = json::array();
    for (const KeyWay& way : ways) {
      json others = json::array();
      for (const KeyWay& other : ways) {
        if (&other == &way) continue;
        for (const std::string& key : other.keys) others.push_back({{"required", {key}}});
      }
      json one;
      if (way.all && !way.keys.empty()) one["required"] = way.keys;
      if (!way.all) {
        for (const std::string& key : way.keys) one["anyOf"].push_back({{"required", {key}}});
      }
      if (!others.empty()) one["not"] = {{"anyOf", others}};
      said.push_back(one);
    }
    return {{"anyOf", said}};
  }

  /// A key that is wanted where another one is a word, or has it among its words.
  static json of_wanted_with(const std::string& key, const std::string& other,
                             const std::string& word) {
    json is;
    is["properties"][other] = {
        {"anyOf", {{{"const", word}}, {{"type", "array"}, {"contains", {{"const", word}}}}}}};
    is["required"] = {other};
    return {{"if", is}, {"then", {{"required", {key}}}}};
  }

  /// A reference to a schema that is there already, or is put there now.
  json refer(const json& schema, const std::string& wanted) {
    const std::string words = schema.dump();
    const auto known = known_.find(words);
    if (known != known_.end()) return {{"$ref", "#/$defs/" + known->second}};
    std::string name = wanted.empty() ? "case" : wanted;
    for (char& c : name) {
      if (c == '.') c = '-';
    }
    std::erase_if(name, [](char c) { return c == '*' || c == '[' || c == ']'; });
    for (std::size_t at; (at = name.find("--")) != std::string::npos;) name.erase(at, 1);
    if (name.ends_with('-')) name.pop_back();
    std::string own = name;
    for (int i = 2; defs_->contains(own); ++i) own = fmt::format("{}-{}", name, i);
    (*defs_)[own] = schema;
    known_[words] = own;
    return {{"$ref", "#/$defs/" + own}};
  }

  json* defs_;
  std::map<std::string, std::string> known_;
};

}  // namespace

std::string schema_of_case() {
  json schema;
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["$id"] = "urn:boxbeam:schema:case:1";
  schema["title"] = "A case of boxbeam (TOML)";
  schema["description"] =
      "What `boxbeam verify` reads, as the tree that its TOML stands for. Every dimensional value "
      "is "
      "a text with its unit. What belongs together across tables (names of points, lengths within "
      "the beam) the program checks itself: boxbeam validate.";
  schema["type"] = "object";
  schema["required"] = {"case"};
  schema["properties"]["case"] = {{"type", "object"},
                                  {"required", {"kind"}},
                                  {"properties", {{"kind", {{"enum", case_kinds()}}}}}};
  json defs = json::object();
  Definitions definitions(defs);
  for (const std::string& kind : case_kinds()) {
    json chosen;
    chosen["properties"]["case"] = {{"properties", {{"kind", {{"const", kind}}}}},
                                    {"required", {"kind"}}};
    schema["allOf"].push_back(
        {{"if", chosen}, {"then", definitions.of_table(key_reference_of(kind), "", kind)}});
  }
  schema["$defs"] = std::move(defs);
  return schema.dump(1) + "\n";
}

}  // namespace boxbeam::report
