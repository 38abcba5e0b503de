#include "boxbeam/section/shear_area.hpp"

#include <cmath>
#include <numbers>

#include "boxbeam/section/section_properties.hpp"

namespace boxbeam {
namespace {

ShearAreas shear_areas(const Profile& profile) {
  if (const auto* box = std::get_if<Box>(&profile)) {
    return {(box->top_flange + box->bottom_flange) * box->width,
            (box->left_web + box->right_web) * box->height};
  }
  const Area area = properties_of(Section{profile, {}}).area;
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    const Length half_border = tube->width + tube->height;
    return {area * (tube->width / half_border), area * (tube->height / half_border)};
  }
  if (std::holds_alternative<RoundTube>(profile)) {
    const Area of = area * (2.0 / std::numbers::pi);
    return {of, of};
  }
  if (const auto* path = std::get_if<ThinWalled>(&profile)) {
    ShearAreas sum;
    for (const ThinWall& wall : path->walls) {
      const Length y = path->nodes[wall.to].y - path->nodes[wall.from].y;
      const Length z = path->nodes[wall.to].z - path->nodes[wall.from].z;
      const Length length = si<Length>(std::hypot(y.value(), z.value()));
      if (length == Length{}) continue;
      sum.y += wall.thickness * (y * y) / length;
      sum.z += wall.thickness * (z * z) / length;
    }
    return sum;
  }
  const Area of = area * (5.0 / 6.0);
  return {of, of};
}

}  // namespace

ShearAreas shear_areas_of(const Section& section) {
  ShearAreas areas = shear_areas(section.outer);
  if (section.inner) {
    const ShearAreas inner = shear_areas(*section.inner);
    areas.y += inner.y;
    areas.z += inner.z;
  }
  return areas;
}

}  // namespace boxbeam
