#pragma once

#include <cstddef>
#include <string>

#include "boxbeam/report/document.hpp"

namespace boxbeam::report::html {

/// A moving picture as a <figure>: the mechanism as it stands where the beam's bending moment is
/// largest, drawn as it is without script, and the data from which assets/cycle.js moves it.
/// It has no number, so that the figures of all forms of a report have the same.
std::string cycle_figure(const MovingPicture& picture);

/// Whether any of its situations is shown in space by assets/scene.js.
bool has_scene(const MovingPicture& picture);

}  // namespace boxbeam::report::html
