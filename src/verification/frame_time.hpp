#pragma once

#include <optional>
#include <vector>

#include "boxbeam/mechanism/common/time_span.hpp"
#include "boxbeam/mechanism/frame/structure.hpp"

namespace boxbeam {

/// The time in which the loads of a frame change; nothing where all that act stand still.
std::optional<TimeSpan> time_of_loads(const frame::Structure& structure);

/// When a wheel passes a place at which the frame answers otherwise: nodes, ends and borders.
std::vector<Time> passages_of(const frame::Structure& structure);

/// A frame under those of its loads that change over time, or that do not.
frame::Structure acting_part_of(const frame::Structure& structure, bool that_changes);

}  // namespace boxbeam
