#include "boxbeam/strength/plate_slenderness.hpp"

#include <algorithm>
#include <utility>

#include "boxbeam/section/polygon_walls.hpp"
#include "boxbeam/strength/path_plates.hpp"

namespace boxbeam {
namespace {

/// How a plate is held and stressed.
enum class PanelKind { compressed, bent, outstand, round_tube };
using enum PanelKind;

/// A plate between its supports.
struct Panel {
  std::string name;
  Length clear, thickness;
  PanelKind kind;
  PlateKind plate = PlateKind::wall;
};

ClassLimits limits_of(PanelKind kind, double epsilon) {
  switch (kind) {
    case compressed: return internal_part_limits(1.0, 1.0, epsilon);
    case bent: return internal_part_limits(0.5, -1.0, epsilon);
    case outstand: return outstand_flange_limits(epsilon);
    case round_tube: return round_tube_limits(epsilon);
  }
  return {};
}

/// The panels of a plate of a box between its stiffeners, the widest one.
Length widest_panel(const Box& box, BoxPlate plate, Length low, Length high) {
  std::vector<const Stiffener*> bars;
  for (const Stiffener& bar : box.stiffeners) {
    if (bar.plate == plate) bars.push_back(&bar);
  }
  std::sort(bars.begin(), bars.end(),
            [](const Stiffener* a, const Stiffener* b) { return a->place < b->place; });
  Length widest, from = low;
  for (const Stiffener* bar : bars) {
    widest = std::max(widest, bar->place - 0.5 * bar->thickness - from);
    from = bar->place + 0.5 * bar->thickness;
  }
  return std::max(widest, high - from);
}

std::vector<Panel> panels_of(const Box& box, const PlateMaterials& materials) {
  const Length right = box.right_web - 0.5 * box.width, left = 0.5 * box.width - box.left_web;
  const Length low = clear_bottom_of(box), high = clear_top_of(box);
  const auto flange = [&](const char* name, BoxPlate plate, Length t, PlateKind kind) {
    return Panel{name, widest_panel(box, plate, right, left), t, compressed, kind};
  };
  const auto web = [&](const char* name, BoxPlate plate, Length t, PlateKind kind) {
    const Length widest = widest_panel(box, plate, low, high);
    // A part of a web, near a flange, may be compressed all over.
    return Panel{name, widest, t, widest < high - low ? compressed : bent, kind};
  };
  const auto alike = [&](PlateKind a, PlateKind b) { return &materials.of(a) == &materials.of(b); };
  using enum PlateKind;
  std::vector<Panel> panels;
  const bool stiffened = !box.stiffeners.empty();
  if (box.top_flange == box.bottom_flange && !stiffened && alike(top_flange, bottom_flange)) {
    panels.push_back(flange("flange", BoxPlate::top_flange, box.top_flange, top_flange));
  } else {
    panels.push_back(flange("top flange", BoxPlate::top_flange, box.top_flange, top_flange));
    panels.push_back(
        flange("bottom flange", BoxPlate::bottom_flange, box.bottom_flange, bottom_flange));
  }
  if (box.left_web == box.right_web && !stiffened && alike(left_web, right_web)) {
    panels.push_back(web("web", BoxPlate::left_web, box.left_web, left_web));
  } else {
    panels.push_back(web("left web", BoxPlate::left_web, box.left_web, left_web));
    panels.push_back(web("right web", BoxPlate::right_web, box.right_web, right_web));
  }
  for (std::size_t i = 0; i < box.stiffeners.size(); ++i) {
    panels.push_back({"stiffener " + std::to_string(i + 1), box.stiffeners[i].depth,
                      box.stiffeners[i].thickness, outstand, stiffener});
  }
  return panels;
}

std::vector<Panel> panels_of(const RectangularTube& tube, const PlateMaterials&) {
  // A rolled tube's plate counts with half of each corner, whatever its radii: b - 3 t, EN
  // 1993-1-5:2006, 4.4(2); between corners sharper than that it is as long as it is.
  const Length corners = std::min(3.0 * tube.wall, 2.0 * (tube.wall + tube.inner_radius));
  return {{"flange", tube.width - corners, tube.wall, compressed},
          {"web", tube.height - corners, tube.wall, bent}};
}

std::vector<Panel> panels_of(const RoundTube& tube, const PlateMaterials&) {
  return {{"round wall", tube.diameter, tube.wall, round_tube}};
}

std::vector<Panel> panels_of(const ThinWalled& path, const PlateMaterials& materials) {
  std::vector<Panel> panels;
  for (const PathPlate& plate : plates_of(path, materials))
    panels.push_back(
        {plate.name, plate.clear(), plate.thickness, plate.outstand() ? outstand : compressed});
  return panels;
}

// Solids have no plate that could buckle.
std::vector<Panel> panels_of(const Plate&, const PlateMaterials&) { return {}; }

// Of a polygon the thinnest part is a plate, held at both edges where it is a wall of a cell.
std::vector<Panel> panels_of(const Polygon& polygon, const PlateMaterials&) {
  const auto wall = most_slender_wall_of(polygon);
  if (!wall) return {};
  return {{"thinnest wall of the polygon", wall->length, wall->thickness,
           wall->of_cell ? compressed : outstand}};
}

}  // namespace

std::optional<Stress> class_yield_of(const Profile& profile, const PlateMaterials& materials,
                                     PlateKind plate, Length thickness) {
  std::optional<Stress> yield = yield_strength_of(materials.of(plate), thickness);
  const auto* const box = std::get_if<Box>(&profile);
  const bool web = plate == PlateKind::left_web || plate == PlateKind::right_web;
  if (!yield || box == nullptr || !web) return yield;
  for (const auto& [kind, of] : {std::pair{PlateKind::top_flange, box->top_flange},
                                 {PlateKind::bottom_flange, box->bottom_flange}}) {
    const Material& material = materials.of(kind);
    if (&material == &materials.of(plate)) continue;
    if (const auto flange = yield_strength_of(material, of)) yield = std::max(*yield, *flange);
  }
  return yield;
}

std::vector<SlenderPlate> plate_slenderness_of(const Profile& profile,
                                               const PlateMaterials& materials) {
  std::vector<SlenderPlate> plates;
  for (const Panel& panel :
       std::visit([&](const auto& shape) { return panels_of(shape, materials); }, profile)) {
    const auto yield = class_yield_of(profile, materials, panel.plate, panel.thickness);
    if (!yield) continue;
    const ClassLimits limits = limits_of(panel.kind, epsilon_of(*yield));
    plates.push_back({panel.name, panel.clear / panel.thickness, limits.class_3, limits});
  }
  return plates;
}

std::vector<SlenderPlate> slender_plates_of(const Profile& profile,
                                            const PlateMaterials& materials) {
  std::vector<SlenderPlate> plates = plate_slenderness_of(profile, materials);
  std::erase_if(plates, [](const SlenderPlate& plate) { return plate.ratio <= plate.limit; });
  return plates;
}

}  // namespace boxbeam
