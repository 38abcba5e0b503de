#pragma once

#include "canvas.hpp"

/// What is drawn into a drawing beside its subject: words, arrows, axes.
namespace boxbeam::plot {

inline constexpr const char* quiet_ink = "#505050";

/// A text at a place, at the middle of its height.
void put_text(Drawing& drawing, const std::string& text, const Pixel& at,
              Anchor anchor = Anchor::left, const std::string& colour = "#202020",
              const std::string& kind = "");

void put_line(Drawing& drawing, const Pixel& from, const Pixel& to, const Pen& pen);

/// A filled rectangle between two opposite corners of a panel.
void put_bar(Drawing& drawing, const Panel& panel, const Eigen::Vector2d& from,
             const Eigen::Vector2d& to, const std::string& ink, double border = 0.6);

/// Of bars that lie below each other the one whose middle is at a height, from 0 to a value, with a
/// name left of it within a width.
void put_named_bar(Drawing& drawing, const Panel& panel, double middle, double value,
                   const std::string& ink, const std::string& name, double width);

/// The head of an arrow that points along a unit vector.
void put_head(Drawing& drawing, const Pixel& tip, const Eigen::Vector2d& along, double length,
              const std::string& colour);

/// An arrow that ends at a place; its head is of the pen's colour.
void put_arrow(Drawing& drawing, const Pixel& from, const Pixel& to, const Pen& pen);

/// The border of a panel at the left and below, with its grid and numbers, up the side unless they
/// stand beside it; its axes are linear.
void put_axes(Drawing& drawing, const Panel& panel, bool numbers_up = true);

/// What a panel's ordinate is, above its upper left corner.
void put_heading(Drawing& drawing, const Panel& panel, const std::string& text);

/// What a panel's abscissa is, below it.
void put_footing(Drawing& drawing, const Panel& panel, const std::string& text);

/// A legend of strokes, its lower border at a height.
void draw_legend(Drawing& drawing, const std::vector<LegendEntry>& entries, double bottom);

}  // namespace boxbeam::plot
