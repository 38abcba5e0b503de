#pragma once

#include <string>

#include "drawing.hpp"

/// A drawing in the forms that files have.
namespace boxbeam::plot {

/// A drawing for a document with the preamble of reports: lines as operators of PDF, words in its
/// own type. As wide as the text of a page where it is `figure_width` wide.
std::string latex_of(const Drawing& drawing);

/// What gnuplot 5's terminal "svg" drew: its lines, areas, marks and words. Of SVG it knows what
/// that terminal writes. Throws OutputError where something else stands.
Drawing drawing_of_gnuplot(const std::string& svg);

/// A drawing as a file: white behind it, painted by its own pens.
std::string svg_of(const Drawing& drawing);

/// A drawing as an element of a page, painted by the page's styles of its kinds; `attributes` are
/// those of the element.
std::string svg_in_page(const Drawing& drawing, const std::string& attributes);

/// A coordinate with as many digits as a picture needs: a tenth of a pixel.
std::string pixels(double value);

}  // namespace boxbeam::plot
