#pragma once

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "boxbeam/section/section.hpp"
#include "section_stress.hpp"

/// Sections as sums of rectangles, and the plane of stress in them.
namespace oracle {

/// A box, or a sharp rectangular tube as one.
std::optional<boxbeam::Box> box_of(const boxbeam::Profile& profile);

/// The numbers of a box.
struct BoxSizes {
  double W, H, top, bottom, left, right;
  double y_left, y_right, z_top, z_bottom;      ///< mid-lines
  double in_left, in_right, in_top, in_bottom;  ///< inner faces

  explicit BoxSizes(const boxbeam::Box& box)
      : W(box.width.value()),
        H(box.height.value()),
        top(box.top_flange.value()),
        bottom(box.bottom_flange.value()),
        left(box.left_web.value()),
        right(box.right_web.value()),
        y_left(0.5 * (W - left)),
        y_right(-0.5 * (W - right)),
        z_top(0.5 * (H - top)),
        z_bottom(-0.5 * (H - bottom)),
        in_left(0.5 * W - left),
        in_right(-0.5 * W + right),
        in_top(0.5 * H - top),
        in_bottom(-0.5 * H + bottom) {}
};

/// A stiffener as a rectangle, with the end of its mid-line and its foot on the ring.
struct Bar {
  boxbeam::BoxPlate plate;
  double place, thickness;
  Eigen::Vector2d foot_mid, root,
      tip;  ///< on the plate's mid-line, on its inner face, the free edge
};

std::vector<Bar> bars_of(const boxbeam::Box& box);

/// The plane (a, b, c) of stress per N, M_y, M_z as columns, of what holes and shear lag leave.
Eigen::Matrix3d plane_for(const boxbeam::Section& section, const std::vector<boxbeam::Hole>& holes,
                          double flange_part, double web_part);

Factors normal_at(const Eigen::Matrix3d& plane, double y, double z);

}  // namespace oracle
