#pragma once

#include <optional>

#include "boxbeam/mechanism/common/time_span.hpp"
#include "boxbeam/mechanism/frame/structure.hpp"

namespace boxbeam {

/// The time in which the loads of a frame change; nothing where all that act stand still.
std::optional<TimeSpan> time_of_loads(const frame::Structure& structure);

}  // namespace boxbeam
