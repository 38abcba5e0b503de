#include "result_values.hpp"

#include <fmt/format.h>

#include <set>

namespace boxbeam {
namespace {

/// "3.2", "1.0714": as stations and instants stand in keys.
std::string number_in_key(double value) {
  std::string text = fmt::format("{:.4f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

class ValueCollector {
 public:
  explicit ValueCollector(const Json& schema) : whole_(&schema) {}

  void collect(const Json& node, const Json& schema, const std::string& key) {
    const Json& of = described(node, schema);
    if (node.is_object()) {
      collect_members(node, of, key);
    } else if (node.is_array()) {
      collect_entries(node, of, key);
    } else if (node.is_number() && of.contains("x-unit")) {
      values_.push_back({key, of["x-unit"].get<std::string>(), node.get<double>()});
    }
  }

  std::vector<ResultValue> take() { return std::move(values_); }

 private:
  /// The part of the schema that describes a node: behind references, and of several the one whose
  /// type and fixed members fit.
  const Json& described(const Json& node, const Json& schema) const {
    if (schema.contains("$ref")) {
      const std::string to = schema["$ref"].get<std::string>();
      return described(node, whole_->at(Json::json_pointer(to.substr(1))));
    }
    if (schema.contains("type") || !schema.contains("oneOf")) return schema;
    for (const Json& one : schema["oneOf"]) {
      const Json& of = described(node, one);
      if (fits(node, of)) return of;
    }
    return schema;
  }

  static bool fits(const Json& node, const Json& schema) {
    const std::string type = schema.value("type", "");
    if (type != (node.is_object() ? "object" : node.is_array() ? "array" : "null")) return false;
    if (!node.is_object() || !schema.contains("properties")) return true;
    for (const auto& [name, member] : schema["properties"].items()) {
      if (member.contains("const") && node.value(name, Json()) != member["const"]) return false;
    }
    return true;
  }

  void collect_members(const Json& node, const Json& schema, const std::string& key) {
    for (const auto& [name, member] : node.items()) {
      const bool named = schema.contains("properties") && schema["properties"].contains(name);
      if (!named && !schema.contains("additionalProperties")) continue;
      const Json& of = named ? schema["properties"][name] : schema["additionalProperties"];
      if (!of.is_object()) continue;
      const std::string whole = key.empty() ? name : fmt::format("{}.{}", key, name);
      if (of.contains("x-unit-in") && member.is_number()) {
        values_.push_back({whole, unit_in(node, of), member.get<double>()});
      } else {
        collect(member, of, whole);
      }
    }
  }

  /// The unit that another member of the node says.
  static std::string unit_in(const Json& node, const Json& schema) {
    const std::string said = node.at(schema["x-unit-in"].get<std::string>());
    return schema.contains("x-units") ? schema["x-units"].at(said).get<std::string>() : said;
  }

  void collect_entries(const Json& node, const Json& schema, const std::string& key) {
    if (!schema.contains("items")) return;
    std::set<std::string> names;
    for (std::size_t i = 0; i < node.size(); ++i) {
      if (schema.contains("x-names")) {
        collect(node[i], schema["items"],
                fmt::format("{}.{}", key, schema["x-names"][i].get<std::string>()));
        continue;
      }
      if (schema.contains("x-key")) {
        // Of entries with the same name the first has it.
        const std::string name = name_of_entry(node[i], schema["x-key"]);
        if (names.insert(name).second) {
          collect(node[i], schema["items"], fmt::format("{}[{}]", key, name));
        }
      }
      collect(node[i], schema["items"], fmt::format("{}[{}]", key, i));
    }
  }

  /// "{s}{side}" with the entry's members put in; a side "0", both, is nothing.
  static std::string name_of_entry(const Json& entry, const std::string& pattern) {
    std::string name;
    for (std::size_t at = 0; at < pattern.size(); ++at) {
      if (pattern[at] != '{') {
        name += pattern[at];
        continue;
      }
      const std::size_t end = pattern.find('}', at);
      const Json& member = entry.at(pattern.substr(at + 1, end - at - 1));
      if (member.is_number()) {
        name += number_in_key(member.get<double>());
      } else if (member != "0") {
        name += member.get<std::string>();
      }
      at = end;
    }
    return name;
  }

  const Json* whole_;
  std::vector<ResultValue> values_;
};

}  // namespace

std::vector<ResultValue> values_in(const Json& document, const Json& schema,
                                   const std::string& prefix) {
  ValueCollector collector(schema);
  collector.collect(document, schema, prefix);
  return collector.take();
}

}  // namespace boxbeam
