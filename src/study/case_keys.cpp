#include "boxbeam/study/case_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/study/written_quantity.hpp"

namespace boxbeam {
namespace {

/// A name as a part of a key: in quotes where it could not be told apart without.
std::string key_part(const std::string& name) {
  const bool plain = !name.empty() && name.front() != ' ' && name.back() != ' ' &&
                     name.find_first_of(".=\"'") == std::string::npos;
  if (plain) return name;
  const char fence = name.find('"') == std::string::npos ? '"' : '\'';
  return fence + name + fence;
}

void gather_keys(const Node& node, const std::string& before, std::vector<std::string>& keys) {
  const auto below = [&](const std::string& name, const Node& value) {
    const std::string key = before.empty() ? name : before + "." + name;
    if (quantity_written_in(value)) keys.push_back(key);
    gather_keys(value, key, keys);
  };
  for (const Node::Member& member : node.members) below(key_part(member.key), member.value);
  for (std::size_t i = 0; i < node.items.size(); ++i) below(std::to_string(i), node.items[i]);
}

/// The first thing that is wrong with a case that has these settings; "" where it can be read.
std::string obstacle_to(const std::vector<std::string>& set, const ReadWith& read) {
  try {
    read(set);
    return "";
  } catch (const InputError& error) {
    return error.problems().empty() ? error.what() : error.problems().front().message;
  }
}

/// Words have the dimension of whatever stands there.
bool has_dimension_of(std::string_view value, const Node& own) {
  if (value.size() > 1 && value.front() == '"' && value.back() == '"')
    value = value.substr(1, value.size() - 2);
  const auto first = quantity_written_in(value), written = quantity_written_in(own);
  return !first || !written || ratio_of_units(written->unit, first->unit).has_value();
}

}  // namespace

std::vector<std::string> number_keys(const Node& root) {
  std::vector<std::string> keys;
  gather_keys(root, "", keys);
  // A name with both kinds of quotes cannot be written.
  std::erase_if(keys, [&](const std::string& key) { return value_at(root, key) == nullptr; });
  return keys;
}

std::string nearest_number_key(const Node& root, const std::string& key) {
  return nearest_word(key, number_keys(root));
}

std::optional<KeyTrouble> trouble_with_key(const CaseDocument& document, const std::string& key,
                                           const std::string& first,
                                           const std::vector<std::vector<std::string>>& designs,
                                           const ReadWith& read) {
  const std::string& path = document.path;
  const Node* const own = value_at(document.root, key);
  if (own != nullptr && has_dimension_of(first, *own)) return std::nullopt;
  const std::string alone = obstacle_to({key + "=" + first}, read);
  if (alone.empty()) return std::nullopt;
  if (own != nullptr)
    return KeyTrouble{fmt::format("{} of {} cannot be \"{}\": {}", key, path, first, alone),
                      fmt::format("the case has \"{}\"", to_text(*quantity_written_in(*own)))};
  const bool can_be_read = std::any_of(designs.begin(), designs.end(), [&](const auto& design) {
    return obstacle_to(design, read).empty();
  });
  if (can_be_read) return std::nullopt;
  const std::string near = nearest_number_key(document.root, key);
  return KeyTrouble{fmt::format("{} is no key of {}: {}", key, path, alone),
                    near.empty() ? "" : fmt::format("did you mean {}?", near)};
}

}  // namespace boxbeam
