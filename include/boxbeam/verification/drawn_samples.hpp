#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace boxbeam {

/// Which of `n` samples a picture shows: all, or of many the extremes of every value within equal
/// stretches, which look the same. Ascending, the first and the last among them.
std::vector<std::size_t> drawn_samples(
    std::size_t n, const std::vector<std::function<double(std::size_t)>>& values);

}  // namespace boxbeam
