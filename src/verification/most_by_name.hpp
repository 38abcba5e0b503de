#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "boxbeam/core/units.hpp"

namespace boxbeam {

/// The largest value of each name, above none at all, and where along the beam that is.
template <class Value>
class MostByName {
 public:
  using Entry = std::pair<const std::string, std::pair<Value, Length>>;

  void take(const std::string& name, const Value& value, Length s) {
    auto& most = by_name_[name];
    if (value > most.first) most = {value, s};
  }
  auto begin() const { return by_name_.begin(); }
  auto end() const { return by_name_.end(); }
  /// The largest of all, or nullptr.
  const Entry* largest() const {
    const auto most = std::max_element(begin(), end(), [](const Entry& a, const Entry& b) {
      return a.second.first < b.second.first;
    });
    return most == end() ? nullptr : &*most;
  }

 private:
  std::map<std::string, std::pair<Value, Length>> by_name_;
};

/// Of uses of strength.
using UseByName = MostByName<double>;

}  // namespace boxbeam
