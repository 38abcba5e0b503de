#include "boxbeam/section/section_properties.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "boxbeam/section/outline.hpp"

namespace boxbeam {
namespace {

/// A symmetric section's round-off is no eccentricity.
double without_round_off(double value, double scale) {
  return std::abs(value) < 1e-14 * scale ? 0.0 : value;
}

SectionProperties properties_of(const AreaSums& sums, const Extent& extent) {
  const double width = (extent.y_high - extent.y_low).value();
  const double height = (extent.z_high - extent.z_low).value();
  const double y = without_round_off(sums.y / sums.area, width);
  const double z = without_round_off(sums.z / sums.area, height);
  const double I_y = sums.zz - sums.area * z * z;
  const double I_z = sums.yy - sums.area * y * y;
  const double I_yz = without_round_off(sums.yz - sums.area * y * z, std::max(I_y, I_z));
  const double mean = 0.5 * (I_y + I_z);
  const double radius = std::hypot(0.5 * (I_y - I_z), I_yz);
  SectionProperties result;
  result.area = si<Area>(sums.area);
  result.centroid_y = si<Length>(y);
  result.centroid_z = si<Length>(z);
  result.I_y = si<SecondMoment>(I_y);
  result.I_z = si<SecondMoment>(I_z);
  result.I_yz = si<SecondMoment>(I_yz);
  result.I_1 = si<SecondMoment>(mean + radius);
  result.I_2 = si<SecondMoment>(mean - radius);
  result.principal_angle =
      I_yz == 0.0 && I_y >= I_z ? 0.0 : 0.5 * std::atan2(-2.0 * I_yz, I_y - I_z);
  result.y_left = extent.y_high;
  result.y_right = extent.y_low;
  result.z_top = extent.z_high;
  result.z_bottom = extent.z_low;
  const auto farther = [](Length high, Length low, double centroid) {
    return std::max(high.value() - centroid, centroid - low.value());
  };
  result.W_y = si<SectionModulus>(I_y / farther(extent.z_high, extent.z_low, z));
  result.W_z = si<SectionModulus>(I_z / farther(extent.y_high, extent.y_low, y));
  return result;
}

/// Takes the middle of a flange out, over the depth between two levels.
void narrow(Outline& outline, double right, double left, double low, double high, double part) {
  const double middle = 0.5 * (left + right);
  const double half = 0.5 * (1.0 - part) * (left - right);
  add_rectangle(outline, middle - half, middle + half, low, high, -1.0);
}

/// The box whose stiffeners in the strips left out are gone.
Box without_idle_stiffeners(const Box& box, double flange_part) {
  Box bare = box;
  const double right = (box.right_web - 0.5 * box.width).value();
  const double left = (0.5 * box.width - box.left_web).value();
  std::erase_if(bare.stiffeners, [&](const Stiffener& bar) {
    const bool on_flange =
        bar.plate == BoxPlate::top_flange || bar.plate == BoxPlate::bottom_flange;
    return on_flange && std::abs(bar.place.value() - 0.5 * (left + right)) <
                            0.5 * (1.0 - flange_part) * (left - right);
  });
  return bare;
}

/// The holes that do not stand in the strips of the flanges that are left out.
std::vector<Hole> without_idle_holes(std::vector<Hole> holes, double clear_width,
                                     double flange_part) {
  std::erase_if(holes, [&](const Hole& hole) {
    return hole.walls == HoleWalls::flanges &&
           hole.position.value() < 0.5 * (1.0 - flange_part) * clear_width;
  });
  return holes;
}

}  // namespace

SectionProperties properties_of(const Section& section, const std::vector<Hole>& holes) {
  return properties_of(sums_of(outline_of(section, holes)), extent_of(section.outer));
}

SectionProperties properties_of(const Section& section) { return properties_of(section, {}); }

SectionProperties properties_of(const Section& section, const std::vector<Hole>& holes,
                                double flange_part) {
  assert(flange_part > 0.0 && flange_part <= 1.0);
  if (const auto* box = std::get_if<Box>(&section.outer)) {
    const double right = (box->right_web - 0.5 * box->width).value();
    const double left = (0.5 * box->width - box->left_web).value();
    Outline outline = outline_of(Section{without_idle_stiffeners(*box, flange_part), section.inner},
                                 without_idle_holes(holes, left - right, flange_part));
    const double half = 0.5 * box->height.value();
    narrow(outline, right, left, clear_top_of(*box).value(), half, flange_part);
    narrow(outline, right, left, -half, clear_bottom_of(*box).value(), flange_part);
    return properties_of(sums_of(outline), extent_of(section.outer));
  }
  if (const auto* tube = std::get_if<RectangularTube>(&section.outer)) {
    const double left = (0.5 * tube->width - tube->wall).value();
    Outline outline = outline_of(section, without_idle_holes(holes, 2.0 * left, flange_part));
    const double half = 0.5 * tube->height.value();
    const double inside = clear_top_of(*tube).value();
    narrow(outline, -left, left, inside, half, flange_part);
    narrow(outline, -left, left, -half, -inside, flange_part);
    return properties_of(sums_of(outline), extent_of(section.outer));
  }
  return properties_of(section, holes);
}

SectionModulus first_moment_beyond(const Section& section, const std::vector<Hole>& holes, Length z,
                                   Length centroid_z) {
  const AreaSums beyond = sums_beyond(outline_of(section, holes), z.value());
  return si<SectionModulus>(beyond.z - centroid_z.value() * beyond.area);
}

Length width_at(const Section& section, const std::vector<Hole>& holes, Length z) {
  return si<Length>(width_at(outline_of(section, holes), z.value()));
}

}  // namespace boxbeam
