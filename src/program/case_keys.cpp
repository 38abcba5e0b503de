#include "program/case_keys.hpp"

#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/study/written_quantity.hpp"

namespace boxbeam::program {
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

}  // namespace boxbeam::program
