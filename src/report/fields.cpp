#include "fields.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace boxbeam::report {
namespace {

/// "3.2", "1.0714": as stations and instants stand in keys.
std::string number_in_key(double value) {
  std::string text = fmt::format("{:.4f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// "{s}{side}" with the entry's fields put in; a side "0", both, is nothing.
std::string name_of_entry(const Json& entry, std::string_view pattern) {
  std::string name;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    if (pattern[at] != '{') {
      name += pattern[at];
      continue;
    }
    const std::size_t end = pattern.find('}', at);
    const Json& member = entry.at(std::string(pattern.substr(at + 1, end - at - 1)));
    if (member.is_number()) {
      name += number_in_key(member.get<double>());
    } else if (member != "0") {
      name += member.get<std::string>();
    }
    at = end;
  }
  return name;
}

Json object_schema() {
  return {{"type", "object"},
          {"properties", Json::object()},
          {"required", Json::array()},
          {"additionalProperties", false}};
}

Json words_schema(FieldNames words, bool may_be_null) {
  Json schema;
  for (const char* word : words) schema["enum"].push_back(word);
  if (may_be_null) schema["enum"].push_back(nullptr);
  return schema;
}

}  // namespace

bool WantedKeys::lead_to(std::string_view name) const {
  return all_ || std::any_of(keys_.begin(), keys_.end(), [&](std::string_view key) {
           return key.starts_with(name) &&
                  (key.size() == name.size() || key[name.size()] == '.' || key[name.size()] == '[');
         });
}

WantedKeys WantedKeys::below(std::string_view name) const {
  if (all_) return {};
  std::vector<std::string_view> rest;
  for (const std::string_view key : keys_) {
    if (key.size() > name.size() && key.starts_with(name) && key[name.size()] == '.')
      rest.push_back(key.substr(name.size() + 1));
  }
  return WantedKeys(std::move(rest));
}

Fields Fields::describing(Json& schema) {
  schema.update(object_schema());
  Fields fields;
  fields.schema_ = &schema;
  return fields;
}

void Fields::either(std::initializer_list<FieldNames> groups) {
  if (!is_describing()) return;
  for (const FieldNames& group : groups) {
    Json names = Json::array();
    for (const char* name : group) names.push_back(name);
    (*schema_)["oneOf"].push_back({{"required", names}});
  }
}

Json& Fields::put(const Field& field, Json value) {
  optional_ = false;
  // Behind the last: no field stands twice.
  Json& all = *out_;
  const std::string name(field.name);
  return all[name] = std::move(value);
}

void Fields::put_number(const Field& field, std::string_view unit, double value) {
  put(field, finite(value));
  if (values_ != nullptr && !unit.empty())
    values_->push_back({std::string(field.name), std::string(unit), value});
}

void Fields::put_whole(const Field& field, long long value, std::string_view unit) {
  put(field, value);
  if (values_ != nullptr && !unit.empty())
    values_->push_back({std::string(field.name), std::string(unit), static_cast<double>(value)});
}

void Fields::describe(const Field& field, Json schema) {
  if (!field.meaning.empty()) schema["description"] = field.meaning;
  const std::string name(field.name);
  (*schema_)["properties"][name] = std::move(schema);
  if (!std::exchange(optional_, false)) (*schema_)["required"].push_back(name);
}

void Fields::describe_number(const Field& field, std::string_view unit, bool may_be_null) {
  Json schema;
  schema["type"] = may_be_null ? Json::array({"number", "null"}) : Json("number");
  if (!unit.empty()) schema["x-unit"] = unit;
  describe(field, std::move(schema));
}

void Fields::describe_whole(const Field& field, std::string_view unit) {
  Json schema{{"type", "integer"}};
  if (!unit.empty()) schema["x-unit"] = unit;
  describe(field, std::move(schema));
}

void Fields::number_or_null(const Field& field, std::string_view unit,
                            std::optional<double> value) {
  if (is_describing()) return describe_number(field, unit, true);
  if (value)
    put_number(field, unit, *value);
  else
    put(field, Json());
}

void Fields::number_in(const Field& field, std::string_view unit, const char* said_by, double value,
                       const Json& units) {
  if (!is_describing()) return put_number(field, unit, value);
  Json schema{{"type", "number"}, {"x-unit-in", said_by}};
  if (!units.is_null()) schema["x-units"] = units;
  describe(field, std::move(schema));
}

void Fields::text_or_null(const Field& field, const std::optional<std::string>& value) {
  if (is_describing()) return describe(field, {{"type", Json::array({"string", "null"})}});
  put(field, value ? Json(*value) : Json());
}

void Fields::word(const Field& field, std::string_view value, FieldNames words) {
  if (is_describing()) return describe(field, words_schema(words, false));
  put(field, Json(value));
}

void Fields::word_or_null(const Field& field, std::optional<std::string_view> value,
                          FieldNames words) {
  if (is_describing()) return describe(field, words_schema(words, true));
  put(field, value ? Json(*value) : Json());
}

void Fields::constant(const Field& field, const char* value) {
  if (is_describing()) return describe(field, {{"const", value}});
  put(field, value);
}

void Fields::boolean(const Field& field, bool value) {
  if (is_describing()) return describe(field, {{"type", "boolean"}});
  put(field, value);
}

void Fields::numbers(const Field& field, std::string_view unit, std::span<const double> values,
                     FieldNames names, std::size_t fewest) {
  if (is_describing()) {
    Json schema{{"type", "array"}, {"items", {{"type", "number"}}}};
    if (!unit.empty()) schema["items"]["x-unit"] = unit;
    if (names.size() > 0) {
      schema["minItems"] = fewest > 0 ? fewest : names.size();
      schema["maxItems"] = names.size();
      for (const char* name : names) schema["x-names"].push_back(name);
    }
    return describe(field, std::move(schema));
  }
  Json& all = put(field, Json::array());
  for (std::size_t i = 0; i < values.size(); ++i) {
    all.push_back(finite(values[i]));
    if (values_ == nullptr || unit.empty()) continue;
    values_->push_back({names.size() > 0 ? fmt::format("{}.{}", field.name, names.begin()[i])
                                         : fmt::format("{}[{}]", field.name, i),
                        std::string(unit), values[i]});
  }
}

void Fields::wholes(const Field& field, std::initializer_list<int> values) {
  if (is_describing())
    return describe(field, {{"type", "array"}, {"items", {{"type", "integer"}}}});
  put(field, Json(values));
}

void Fields::rows(const Field& field, std::string_view unit, const Eigen::Matrix3d& value) {
  if (is_describing()) {
    Json row;
    Fields::describing(row).numbers("row", unit, {}, {"x", "y", "z"});
    Json schema{{"type", "array"}, {"minItems", 3}, {"maxItems", 3}};
    schema["items"] = row["properties"]["row"];
    return describe(field, std::move(schema));
  }
  Json& all = put(field, Json::array());
  for (int i = 0; i < 3; ++i) {
    Json row = Json::object();
    const Eigen::Vector3d numbers_of_row = value.row(i);
    std::vector<ResultValue> values;
    Fields(row, values_ != nullptr ? &values : nullptr).vector("row", unit, numbers_of_row);
    all.push_back(row["row"]);
    for (const ResultValue& each : values) {
      values_->push_back(
          {fmt::format("{}[{}]{}", field.name, i, each.key.substr(3)), each.unit, each.value});
    }
  }
}

void Fields::named_words(const Field& field,
                         const std::vector<std::pair<std::string, std::string>>& values,
                         FieldNames words) {
  if (is_describing()) {
    return describe(field,
                    {{"type", "object"}, {"additionalProperties", words_schema(words, false)}});
  }
  Json& all = put(field, Json::object());
  for (const auto& [name, word] : values) all[name] = word;
}

void Fields::named_numbers(const Field& field,
                           const std::vector<std::pair<std::string, double>>& values) {
  if (is_describing())
    return describe(field, {{"type", "object"},
                            {"additionalProperties", {{"type", "number"}, {"x-unit", "1"}}}});
  Json& all = put(field, Json::object());
  for (const auto& [name, value] : values) all[name] = finite(value);
}

void Fields::take(const std::string& prefix, const std::vector<ResultValue>& values) {
  for (const ResultValue& value : values)
    values_->push_back({fmt::format("{}.{}", prefix, value.key), value.unit, value.value});
}

void Fields::below(const Field& field, bool may_be_null, const Fill& fill) {
  if (is_describing()) {
    Json schema;
    Fields fields = describing(schema);
    fill(fields);
    if (may_be_null) schema = {{"oneOf", {{{"type", "null"}}, schema}}};
    return describe(field, std::move(schema));
  }
  if (leaves_out(field)) return;
  std::vector<ResultValue> values;
  Json& object = put(field, Json::object());
  Fields fields(object, values_ != nullptr ? &values : nullptr, wanted_.below(field.name));
  fill(fields);
  if (values_ != nullptr) take(std::string(field.name), values);
}

void Fields::describe_list(const Field& field, const char* key, const Fill& fill) {
  Json items;
  Fields fields = describing(items);
  fill(fields);
  Json schema{{"type", "array"}};
  if (*key != '\0') schema["x-key"] = key;
  schema["items"] = std::move(items);
  describe(field, std::move(schema));
}

void Fields::describe_named(const Field& field, const Fill& fill) {
  Json members;
  Fields fields = describing(members);
  fill(fields);
  describe(field, {{"type", "object"}, {"additionalProperties", std::move(members)}});
}

void Fields::entry(const Field& field, const char* key, Json& all, std::vector<std::string>& names,
                   const Fill& fill) {
  std::vector<ResultValue> values;
  Json& object = all.emplace_back(Json::object());
  Fields fields(object, values_ != nullptr ? &values : nullptr);
  fill(fields);
  if (values_ == nullptr) return;
  if (*key != '\0') {
    // Of entries with the same name the first has it.
    const std::string name = name_of_entry(object, key);
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      names.push_back(name);
      take(fmt::format("{}[{}]", field.name, name), values);
    }
  }
  take(fmt::format("{}[{}]", field.name, all.size() - 1), values);
}

void Fields::member(const Field& field, const std::string& name, Json& all, const Fill& fill) {
  std::vector<ResultValue> values;
  // What is many is named by tables of the case, no name twice: not sought among the others.
  constexpr std::size_t few = 64;
  auto& members = all.get_ref<Json::object_t&>();
  Json& object = members.size() < few ? all[name] : members.emplace_back(name, Json()).second;
  object = Json::object();
  Fields fields(object, values_ != nullptr ? &values : nullptr);
  fill(fields);
  if (values_ != nullptr) take(fmt::format("{}.{}", field.name, name), values);
}

}  // namespace boxbeam::report
