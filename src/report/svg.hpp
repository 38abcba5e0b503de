#pragma once

#include <string>

#include "drawing.hpp"

namespace boxbeam::plot {

/// A drawing as a file: white behind it, painted by its own pens.
std::string svg_of(const Drawing& drawing);

/// A drawing as an element of a page, painted by the page's styles of its kinds; `attributes` are
/// those of the element.
std::string svg_in_page(const Drawing& drawing, const std::string& attributes);

/// A coordinate with as many digits as a picture needs: a tenth of a pixel.
std::string pixels(double value);

}  // namespace boxbeam::plot
