#pragma once

#include "boxbeam/strength/stiffened_plate.hpp"

namespace boxbeam {

/// Second moment and centroid of a plate `width` wide and flats on it, out of the plate.
struct OutOfPlate {
  double area = 0.0, first = 0.0, second = 0.0;

  void add_plate(double width, double t) {
    area += width * t;
    second += width * t * t * t / 12.0;
  }
  void add(const FlatStiffener& flat, double t) {
    const double d = flat.depth.value(), A = d * flat.thickness.value(), at = 0.5 * (t + d);
    area += A;
    first += A * at;
    second += A * (at * at + d * d / 12.0);
  }
  double centroid() const { return first / area; }
  double inertia() const { return second - first * first / area; }
};

}  // namespace boxbeam
