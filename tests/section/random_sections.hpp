#pragma once

#include <random>
#include <vector>

#include "boxbeam/section/section.hpp"
#include "boxbeam/section/section_defect.hpp"

namespace test {

/// Sections for properties that hold for all: seeded, so that every run sees the same.
class RandomSections {
 public:
  explicit RandomSections(unsigned seed) : random_(seed) {}

  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  boxbeam::Length length(double low, double high) {
    return boxbeam::si<boxbeam::Length>(number(low, high));
  }

  /// Unlike plates, none, one or two stiffeners.
  boxbeam::Box box() {
    using namespace boxbeam;
    Box box{length(0.2, 0.6),
            length(0.3, 1.0),
            length(0.01, 0.04),
            length(0.01, 0.04),
            length(0.01, 0.04),
            length(0.01, 0.04),
            {},
            {}};
    const auto bars = static_cast<int>(number(0.0, 3.0));
    const BoxPlate plates[] = {BoxPlate::top_flange, BoxPlate::left_web};
    for (int i = 0; i < bars; ++i) {
      box.stiffeners.push_back(
          {plates[i], length(-0.04, 0.04), length(0.02, 0.05), length(0.005, 0.015)});
    }
    return box;
  }

  /// Two cells with a free plate on top: every wall of its own thickness, no symmetry.
  boxbeam::ThinWalled path() {
    using namespace boxbeam;
    const double h = number(0.2, 0.6), w = number(0.2, 0.5), m = number(0.08, 0.15);
    const auto at = [](double y, double z) { return SectionPlace{si<Length>(y), si<Length>(z)}; };
    ThinWalled path;
    path.nodes = {
        at(-w, -h), at(w, -h * number(0.7, 1.0)), at(w * number(0.7, 1.0), h), at(-w, h), at(m, h),
        at(-m, -h), at(m, h * number(1.2, 1.5))};
    // The middle wall's feet lie on the walls they divide.
    path.nodes[4].z = path.nodes[2].z;
    path.nodes[5].z = path.nodes[0].z +
                      (path.nodes[1].z - path.nodes[0].z) * ((path.nodes[5].y - path.nodes[0].y) /
                                                             (path.nodes[1].y - path.nodes[0].y));
    const auto wall = [&](std::size_t a, std::size_t b) {
      path.walls.push_back({a, b, length(0.004, 0.02), {}, {}});
    };
    wall(0, 5);
    wall(5, 1);
    wall(1, 2);
    wall(2, 4);
    wall(4, 3);
    wall(3, 0);
    wall(5, 4);
    wall(4, 6);
    return path;
  }

  /// A rolled tube with radii as EN 10210-2 has them.
  boxbeam::RectangularTube rolled() {
    using namespace boxbeam;
    const Length wall = length(0.004, 0.016);
    return {length(0.1, 0.3), length(0.1, 0.4), wall, 1.5 * wall, 1.0 * wall};
  }

 private:
  std::mt19937 random_;
};

}  // namespace test
