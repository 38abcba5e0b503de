#pragma once

#include "boxbeam/project/project.hpp"

namespace boxbeam::charts {

/// A crank of radius `ratio` m at 300 rpm, from an angle, with a rod of 1 m, a box tapered in width
/// and height, and a slide of 20 kg. What bends the rod is its own inertia, most between its ends.
/// No gravity.
Project connecting_rod(double ratio, double start = 0.0);

/// Acceleration of the slide of a crank of radius `ratio` and a rod of 1 at rate 1, over the angle
/// of the crank:
///
///     x = r cos phi + w,  w = sqrt(1 - r^2 sin^2 phi)
long double slide_acceleration(long double ratio, long double phi);

}  // namespace boxbeam::charts
