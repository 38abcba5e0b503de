#pragma once

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace boxbeam {

template <class T>
void append(std::vector<T> more, std::vector<T>& all) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

}  // namespace boxbeam
