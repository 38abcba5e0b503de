#include "boxbeam/project/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/project/limits.hpp"
#include "node_kinds.hpp"

namespace boxbeam {
namespace {

const Node& empty_table() {
  static const Node node;
  return node;
}

}  // namespace

const char* kind_name(const Node& node) {
  switch (node.kind) {
    case Node::Kind::table: return "a table";
    case Node::Kind::array: return "an array";
    case Node::Kind::text: return "a text";
    case Node::Kind::number: return "a bare number";
    case Node::Kind::boolean: return "true or false";
    case Node::Kind::other: return "a date or time";
  }
  return "";
}

TableReader::TableReader(ProblemList& problems, const Node& table, std::string name,
                         std::string pattern)
    : problems_(&problems), table_(&table), name_(std::move(name)), pattern_(std::move(pattern)) {
  if (table.kind != Node::Kind::table) {
    problems_->add(table.place,
                   fmt::format("{} is wanted as a table, not {}", name_, kind_name(table)),
                   fmt::format("write [{}] and its keys below", name_));
    table_ = &empty_table();
    absent_ = true;
  }
}

std::string TableReader::pattern_below(std::string_view key) const {
  return pattern_.empty() ? std::string(key) : fmt::format("{}.{}", pattern_, key);
}

void TableReader::note(const Key& key, KeyShape shape, const Asked& asked) {
  TableVisit& visit = (*problems_->recorder)[problems_->recorder->visit_of(*table_, pattern_)];
  const std::string name = own_names_ ? "*" : std::string(key.name);
  auto at = std::find_if(visit.keys.begin(), visit.keys.end(),
                         [&](const AskedKey& of) { return of.name == name; });
  // Who asks first whether a key is there does without it.
  const bool looked_for = at != visit.keys.end();
  if (!looked_for) {
    at = visit.keys.emplace(at);
    at->name = name;
  }
  if (at->meaning.empty()) at->meaning = key.meaning;
  // What is read as something else by way of this one has been noted.
  if (at->shape != KeyShape::unknown || shape == KeyShape::unknown) return;
  at->shape = shape;
  at->required = asked.required && !looked_for;
  // What holds is not always one value.
  if (key.meaning.find("where not said") == std::string_view::npos) at->fallback = asked.fallback;
  at->words = asked.words;
  if (asked.wanted == nullptr) return;
  at->dimension = asked.wanted->name;
  at->example = asked.wanted->example;
  at->exponents = asked.wanted->exponents;
}

bool TableReader::has(const Key& of) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::unknown, {});
  asked_.emplace_back(key);
  return table_->find(key) != nullptr;
}

bool TableReader::has_misplaced(std::string_view key) {
  asked_.emplace_back(key);
  return is_there(key);
}

bool TableReader::has_choice(const Key& key, const std::vector<std::string>& words) {
  if (recording()) note(key, KeyShape::choice, {.words = words});
  return has(key);
}

bool TableReader::has_quantity(const Key& key, const WantedDimension& wanted) {
  if (recording()) note(key, KeyShape::positive, {.wanted = &wanted});
  return has(key);
}

bool TableReader::has_number(const Key& key) {
  if (recording()) note(key, KeyShape::number, {});
  return has(key);
}

bool TableReader::says_one_of(const KeyWays& ways) {
  if (recording()) {
    (*problems_->recorder)[problems_->recorder->visit_of(*table_, pattern_)].ways.push_back(ways);
  }
  std::size_t said = 0;
  bool may_be_silent = false;
  for (const KeyWay& way : ways) {
    bool any = false;
    for (const std::string& key : way.keys) any = has(key) || any;
    said += any ? 1 : 0;
    may_be_silent = may_be_silent || way.keys.empty();
  }
  return said == 1 || (said == 0 && may_be_silent);
}

void TableReader::wants_with(const Key& key, std::string_view other, std::string_view word) {
  if (!recording()) return;
  note(key, KeyShape::unknown, {});
  TableVisit& visit = (*problems_->recorder)[problems_->recorder->visit_of(*table_, pattern_)];
  const auto at = std::find_if(visit.keys.begin(), visit.keys.end(),
                               [&](const AskedKey& of) { return of.name == key.name; });
  at->required_with.emplace_back(other, word);
}

Place TableReader::place_of(std::string_view key) const {
  const Node* node = table_->find(key);
  return node != nullptr ? node->place : table_->place;
}

const Node* TableReader::take(std::string_view key, bool required, std::string_view example) {
  return take_or_say(key, required, fmt::format("write {} = {}", key, example));
}

const Node* TableReader::take_or_say(std::string_view key, bool required, std::string hint) {
  asked_.emplace_back(key);
  const Node* node = table_->find(key);
  if (node == nullptr && required && !absent_) {
    const std::string where = name_.empty() ? "the case" : "[" + name_ + "]";
    problems_->add_missing(*table_, key, fmt::format("{} has no \"{}\"", where, key),
                           std::move(hint));
  }
  return node;
}

std::string TableReader::name_below(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
}

bool TableReader::is_list(std::string_view key) const {
  const Node* node = table_->find(key);
  return node != nullptr && node->kind == Node::Kind::array;
}

bool TableReader::is_table(std::string_view key) const {
  const Node* node = table_->find(key);
  return node != nullptr && node->kind == Node::Kind::table;
}

TableReader TableReader::table(const Key& of, bool required) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::table, {.required = required});
  const std::string name = name_below(key);
  const Node* node = take_or_say(key, required, fmt::format("write [{}] and its keys below", name));
  TableReader reader(*problems_, node != nullptr ? *node : empty_table(), name,
                     pattern_below(own_names_ ? "*" : key));
  if (node == nullptr) reader.absent_ = true;
  return reader;
}

std::vector<TableReader> TableReader::tables(const Key& of, bool required) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::tables, {.required = required});
  std::vector<TableReader> result;
  const std::string name = name_below(key);
  const Node* node =
      take_or_say(key, required, fmt::format("write at least one [[{}]] and its keys below", name));
  if (node == nullptr) return result;
  if (node->kind != Node::Kind::array) {
    problem(key, fmt::format("\"{}\" is a list of tables", key), fmt::format("write [[{}]]", name));
    return result;
  }
  // Of too many the first are read, so that what else is wrong is said as well.
  const bool too_long = is_too_long(name, node->place, node->items.size());
  const std::size_t count = too_long ? limits::most_entries(name) : node->items.size();
  for (std::size_t i = 0; i < count; ++i) {
    result.emplace_back(*problems_, node->items[i], fmt::format("{}.{}", name, i),
                        pattern_below(key) + "[]");
  }
  return result;
}

std::size_t TableReader::count_of(std::string_view key) const {
  return is_list(key) ? table_->find(key)->items.size() : 1;
}

TableReader TableReader::one_of_tables(const Key& of, std::size_t index) {
  const std::string_view key = of.name;
  if (recording()) note(of, KeyShape::table_or_tables, {.required = true});
  const std::string name = name_below(key);
  const Node* node = take_or_say(key, true, fmt::format("write [{}] and its keys below", name));
  const bool list = node != nullptr && node->kind == Node::Kind::array;
  if (list) node = index < node->items.size() ? &node->items[index] : nullptr;
  TableReader reader(*problems_, node != nullptr ? *node : empty_table(),
                     list ? fmt::format("{}.{}", name, index) : name, pattern_below(key));
  if (node == nullptr) reader.absent_ = true;
  return reader;
}

void TableReader::accept_as_in_case(const Key& key) {
  if (recording()) note(key, KeyShape::as_in_case, {});
  asked_.emplace_back(key.name);
}

std::vector<std::pair<std::string, TableReader>> TableReader::named_tables(
    std::string_view meaning) {
  own_names_ = true;
  if (recording()) note({"*", meaning}, KeyShape::table, {});
  std::vector<std::pair<std::string, TableReader>> result;
  const bool too_long = is_too_long(name_, table_->place, table_->members.size());
  const std::size_t count = too_long ? limits::most_entries(name_) : table_->members.size();
  for (const Node::Member& member : table_->members) {
    asked_.push_back(member.key);
    if (result.size() == count) continue;
    result.emplace_back(member.key, TableReader(*problems_, member.value, name_below(member.key),
                                                pattern_below("*")));
  }
  return result;
}

const std::vector<Node::Member>& TableReader::members(std::string_view meaning) {
  own_names_ = true;
  if (recording()) note({"*", meaning}, KeyShape::unknown, {});
  return table_->members;
}

void TableReader::accept_all() {
  static_cast<void>(is_too_long(name_, table_->place, table_->members.size()));
  for (const Node::Member& member : table_->members) asked_.push_back(member.key);
}

void TableReader::problem(std::string_view key, std::string message, std::string hint) {
  if (absent_) return;
  problems_->add(place_of(key), std::move(message), std::move(hint));
}

void TableReader::finish() {
  std::vector<std::string> known;
  for (const std::string& key : asked_) {
    if (std::find(known.begin(), known.end(), key) == known.end()) known.push_back(key);
  }
  for (const Node::Member& member : table_->members) {
    if (std::find(known.begin(), known.end(), member.key) != known.end()) continue;
    const std::string near = nearest_word(member.key, known);
    const std::string shown =
        member.key.size() <= 60 ? member.key : member.key.substr(0, 57) + "...";
    problems_->add(member.key_place, fmt::format("unknown key \"{}\"", shown),
                   near.empty() ? fmt::format("known here: {}", fmt::join(known, ", "))
                                : fmt::format("did you mean \"{}\"?", near));
    if (!near.empty()) problems_->drop_missing(*table_, near);
  }
}

}  // namespace boxbeam
