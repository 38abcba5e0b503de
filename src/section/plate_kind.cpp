#include "boxbeam/section/plate_kind.hpp"

#include <algorithm>

namespace boxbeam {
namespace {

/// A plate and the rectangle that it lies in.
struct PlacedPlate {
  PlateAt plate;
  Length y_low, y_high, z_low, z_high;
};

PlacedPlate placed(const Box& box, const Stiffener& bar) {
  const Length half = 0.5 * bar.thickness;
  const PlateAt plate{PlateKind::stiffener, bar.thickness};
  const Length top = 0.5 * box.height - box.top_flange;
  const Length bottom = box.bottom_flange - 0.5 * box.height;
  const Length left = 0.5 * box.width - box.left_web;
  const Length right = box.right_web - 0.5 * box.width;
  switch (bar.plate) {
    case BoxPlate::top_flange:
      return {plate, bar.place - half, bar.place + half, top - bar.depth, top};
    case BoxPlate::bottom_flange:
      return {plate, bar.place - half, bar.place + half, bottom, bottom + bar.depth};
    case BoxPlate::left_web:
      return {plate, left - bar.depth, left, bar.place - half, bar.place + half};
    case BoxPlate::right_web: break;
  }
  return {plate, right, right + bar.depth, bar.place - half, bar.place + half};
}

std::vector<PlacedPlate> placed_plates_of(const Box& box) {
  const Length y = 0.5 * box.width, z = 0.5 * box.height;
  const Length top = z - box.top_flange, bottom = box.bottom_flange - z;
  std::vector<PlacedPlate> plates{
      {{PlateKind::top_flange, box.top_flange}, -y, y, top, z},
      {{PlateKind::bottom_flange, box.bottom_flange}, -y, y, -z, bottom},
      {{PlateKind::left_web, box.left_web}, y - box.left_web, y, bottom, top},
      {{PlateKind::right_web, box.right_web}, -y, box.right_web - y, bottom, top}};
  for (const Stiffener& bar : box.stiffeners) plates.push_back(placed(box, bar));
  return plates;
}

PlacedPlate as_one(const Profile& profile, PlateKind kind) {
  const Extent extent = extent_of(profile);
  Length thickest;
  for (const Length& thickness : thicknesses_of(Section{profile, {}}))
    thickest = std::max(thickest, thickness);
  return {{kind, thickest}, extent.y_low, extent.y_high, extent.z_low, extent.z_high};
}

std::vector<PlacedPlate> placed_plates_of(const Section& section) {
  const auto* const box = std::get_if<Box>(&section.outer);
  std::vector<PlacedPlate> plates =
      box != nullptr ? placed_plates_of(*box)
                     : std::vector<PlacedPlate>{as_one(section.outer, PlateKind::wall)};
  if (section.inner) plates.push_back(as_one(*section.inner, PlateKind::inner));
  return plates;
}

}  // namespace

const std::vector<std::string>& plate_kind_names() {
  static const std::vector<std::string> names{"top flange", "bottom flange", "left web",
                                              "right web",  "stiffeners",    "inner profile",
                                              "walls"};
  return names;
}

std::vector<PlateAt> plates_of(const Section& section) {
  std::vector<PlateAt> plates;
  for (const PlacedPlate& placed : placed_plates_of(section)) plates.push_back(placed.plate);
  return plates;
}

std::vector<PlateAt> plates_at(const Section& section, Length y, Length z) {
  const std::vector<PlacedPlate> all = placed_plates_of(section);
  // A place on the border of a plate may stand beside it by round-off.
  constexpr double rounding = 1e-9;
  const Length slack = rounding * height_of(section.outer);
  std::vector<PlateAt> plates;
  for (const PlacedPlate& at : all) {
    if (y < at.y_low - slack || y > at.y_high + slack) continue;
    if (z < at.z_low - slack || z > at.z_high + slack) continue;
    plates.push_back(at.plate);
  }
  return plates.empty() ? plates_of(section) : plates;
}

}  // namespace boxbeam
