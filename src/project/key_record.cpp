#include "boxbeam/project/key_record.hpp"

#include <algorithm>

namespace boxbeam {

const AskedKey* TableVisit::find(std::string_view key) const {
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const AskedKey& of) { return of.name == key; });
  return found == keys.end() ? nullptr : &*found;
}

std::size_t KeyRecorder::visit_of(const Node& table, const std::string& pattern) {
  const auto [at, is_new] = known_.emplace(std::pair(&table, pattern), visits_.size());
  if (is_new) visits_.push_back({pattern, {}, {}, {}});
  return at->second;
}

}  // namespace boxbeam
