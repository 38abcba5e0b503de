#include "mid_lines.hpp"

#include <array>

namespace boxbeam {
namespace {

MidLines four_plates(double y_left, double y_right, double z_top, double z_bottom,
                     const std::array<double, 4>& top_bottom_left_right) {
  const auto [top, bottom, left, right] = top_bottom_left_right;
  MidLines lines;
  lines.corners = {{y_right, z_bottom}, {y_left, z_bottom}, {y_left, z_top}, {y_right, z_top}};
  lines.plates = {{0, 1, bottom, WallPart::bottom_flange},
                  {1, 2, left, WallPart::left_web},
                  {2, 3, top, WallPart::top_flange},
                  {3, 0, right, WallPart::right_web}};
  return lines;
}

}  // namespace

std::optional<MidLines> mid_lines_of(const Profile& profile) {
  if (const auto* box = std::get_if<Box>(&profile)) {
    const double y = 0.5 * box->width.value(), z = 0.5 * box->height.value();
    const double top = box->top_flange.value(), bottom = box->bottom_flange.value();
    const double left = box->left_web.value(), right = box->right_web.value();
    return four_plates(y - 0.5 * left, -y + 0.5 * right, z - 0.5 * top, -z + 0.5 * bottom,
                       {top, bottom, left, right});
  }
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    const double t = tube->wall.value();
    const double y = 0.5 * (tube->width.value() - t), z = 0.5 * (tube->height.value() - t);
    return four_plates(y, -y, z, -z, {t, t, t, t});
  }
  const auto* plate = std::get_if<Plate>(&profile);
  if (plate == nullptr || plate->width > plate->height) return std::nullopt;
  MidLines lines;
  const double z = 0.5 * plate->height.value();
  lines.corners = {{0.0, -z}, {0.0, z}};
  lines.plates = {{0, 1, plate->width.value(), WallPart::path}};
  lines.closed = false;
  return lines;
}

std::vector<MidLines> mid_lines_of(const Section& section) {
  std::vector<MidLines> all{*mid_lines_of(section.outer)};
  if (section.inner) {
    all.push_back(*mid_lines_of(*section.inner));
    all.back().inner = true;
  }
  return all;
}

bool same_corners(const MidLines& a, const MidLines& b) {
  if (a.corners.size() != b.corners.size()) return false;
  for (std::size_t i = 0; i < a.corners.size(); ++i)
    if ((a.corners[i] - b.corners[i]).norm() > 1e-9) return false;
  return true;
}

}  // namespace boxbeam
