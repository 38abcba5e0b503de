#include "boxbeam/report/motion_columns.hpp"

#include <algorithm>
#include <limits>

#include "document_fields.hpp"

namespace boxbeam {
namespace {

using Numbers = MotionColumn::Numbers;
using Words = MotionColumn::Words;
using Truths = MotionColumn::Truths;
using Below = MotionColumn::Below;

/// The lengths of a number, vector or matrix.
std::vector<std::size_t> shape_of_numbers(const Json& value) {
  std::vector<std::size_t> shape;
  for (const Json* at = &value; at->is_array() && !at->empty(); at = &at->front())
    shape.push_back(at->size());
  return shape;
}

void append_numbers(std::vector<double>& to, const Json& value) {
  if (value.is_array()) {
    for (const Json& one : value) append_numbers(to, one);
  } else {
    to.push_back(value.is_number() ? value.get<double>()
                                   : std::numeric_limits<double>::quiet_NaN());
  }
}

void append_object(Below& columns, const Json& object, std::size_t instant);

/// An empty column for what a value is.
MotionColumn column_for(const std::string& name, const Json& value) {
  MotionColumn column{name, 0, Numbers{}};
  if (value.is_object())
    column.of = Below{};
  else if (value.is_string())
    column.of = Words{};
  else if (value.is_boolean())
    column.of = Truths{};
  else
    column.of = Numbers{shape_of_numbers(value), {}};
  return column;
}

struct AppendValue {
  const Json& value;
  std::size_t instant;

  bool operator()(Numbers& column) const {
    if (value.is_object() || value.is_string() || value.is_boolean() ||
        shape_of_numbers(value) != column.shape)
      return false;
    append_numbers(column.values, value);
    return true;
  }
  bool operator()(Words& column) const {
    if (!value.is_string()) return false;
    column.push_back(value.get<std::string>());
    return true;
  }
  bool operator()(Truths& column) const {
    if (!value.is_boolean()) return false;
    column.push_back(value.get<bool>());
    return true;
  }
  bool operator()(Below& columns) const {
    if (!value.is_object()) return false;
    append_object(columns, value, instant);
    return true;
  }
};

void append_object(Below& columns, const Json& object, std::size_t instant) {
  auto next = columns.begin();
  for (const auto& [name, value] : object.items()) {
    // Keys come in the same order at every instant.
    if (next == columns.end() || next->name != name)
      next = std::ranges::find(columns, name, &MotionColumn::name);
    if (next == columns.end()) {
      if (instant > 0) continue;
      columns.push_back(column_for(name, value));
      next = columns.end() - 1;
    }
    if (next->instants == instant && std::visit(AppendValue{value, instant}, next->of))
      ++next->instants;
    ++next;
  }
}

void drop_incomplete(Below& columns, std::size_t instants) {
  std::erase_if(columns, [&](const MotionColumn& column) { return column.instants != instants; });
  for (MotionColumn& column : columns)
    if (auto* const below = std::get_if<Below>(&column.of)) drop_incomplete(*below, instants);
}

Below columns_of_states(const auto& states) {
  Below columns;
  std::size_t instant = 0;
  for (const auto& state : states) {
    Json document = Json::object();
    report::Fields to(document);
    report::put_state(to, state);
    append_object(columns, document, instant++);
  }
  drop_incomplete(columns, instant);
  return columns;
}

struct ColumnsOfKind {
  Below operator()(const MotionResult& motion) const { return columns_of_states(motion.states); }
  Below operator()(const ChainMotionResult& motion) const {
    return columns_of_states(motion.states);
  }
  Below operator()(const FlexibleMotionResult&) const { return {}; }
};

}  // namespace

std::vector<MotionColumn> motion_columns(const AnyMotionResult& motion) {
  return std::visit(ColumnsOfKind{}, motion);
}

}  // namespace boxbeam
