#pragma once

#include "canvas.hpp"

/// The beam itself above what is drawn along it.
namespace boxbeam::plot {

/// In which of its planes the beam is seen.
enum class Plane { xz, xy };

/// How high the drawing of the beam is, without its heading [px].
inline constexpr double outline_height = 76.0;

/// Draws the border of the beam to the scale of s, with its taper, the inner faces of its flanges,
/// holes, an inner profile, the named points, and a triangle where joints or loads act.
void draw_outline(Script& gp, const Project& project, const Verification& verification, Plane plane,
                  const Frame& frame);

/// The range of s of all diagrams along the beam [m].
std::pair<double, double> range_of_s(const TaperedBeam& beam);

}  // namespace boxbeam::plot
