#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace boxbeam {

/// Index of the item of a name, -1 where there is none.
template <class Items>
int index_by_name(const Items& items, std::string_view name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

/// The names of items that have one.
template <class Items>
requires requires(const Items& items) { items.begin()->name; }
std::vector<std::string> names_of(const Items& items) {
  std::vector<std::string> names;
  for (const auto& item : items) names.push_back(item.name);
  return names;
}

}  // namespace boxbeam
