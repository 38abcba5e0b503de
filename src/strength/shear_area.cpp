#include "boxbeam/strength/shear_area.hpp"

#include <cmath>
#include <numbers>

#include "boxbeam/section/section_properties.hpp"

namespace boxbeam {
namespace {

Area shear_area(const Profile& profile) {
  if (const auto* box = std::get_if<Box>(&profile)) {
    return (box->left_web + box->right_web) * box->height;
  }
  const Area area = properties_of(Section{profile, {}}).area;
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    return area * (tube->height / (tube->width + tube->height));
  }
  if (std::holds_alternative<RoundTube>(profile)) return area * (2.0 / std::numbers::pi);
  if (const auto* path = std::get_if<ThinWalled>(&profile)) {
    Area sum;
    for (const ThinWall& wall : path->walls) {
      const Length y = path->nodes[wall.to].y - path->nodes[wall.from].y;
      const Length z = path->nodes[wall.to].z - path->nodes[wall.from].z;
      const double length = std::hypot(y.value(), z.value());
      if (length > 0.0) sum += wall.thickness * (z * z) / si<Length>(length);
    }
    return sum;
  }
  return area * (5.0 / 6.0);
}

}  // namespace

Area shear_area_of(const Section& section) {
  Area area = shear_area(section.outer);
  if (section.inner) area += shear_area(*section.inner);
  return area;
}

}  // namespace boxbeam
