#include "boxbeam/project/plate_material.hpp"

#include <algorithm>

namespace boxbeam {
namespace {

template <class Strength>
PlateOf weakest_by(const std::vector<PlateOf>& plates, const Strength& strength) {
  return *std::min_element(plates.begin(), plates.end(), [&](const PlateOf& a, const PlateOf& b) {
    return strength(a) < strength(b);
  });
}

}  // namespace

PlateMaterials materials_of(const Project& project, std::size_t segment) {
  PlateMaterials materials(project.material);
  for (const PartMaterial& part : project.part_materials) {
    if (!part.segments[segment]) continue;
    for (std::size_t kind = 0; kind < plate_kinds; ++kind) {
      if (part.plates[kind]) materials.give(static_cast<PlateKind>(kind), part.material);
    }
  }
  return materials;
}

std::vector<const Material*> materials_of(const Project& project) {
  std::vector<const Material*> materials{&project.material};
  for (const PartMaterial& part : project.part_materials) materials.push_back(&part.material);
  return materials;
}

std::vector<PlateOf> plates_at(const PlateMaterials& materials, const Section& section, Length y,
                               Length z) {
  std::vector<PlateOf> plates;
  for (const PlateAt& plate : plates_at(section, y, z))
    plates.push_back({&materials.of(plate.kind), plate.thickness});
  return plates;
}

std::vector<PlateOf> plates_around(const Project& project, Length s, Length thickness) {
  std::vector<PlateOf> plates;
  for (const Side side : {Side::before, Side::behind}) {
    const std::size_t segment = segment_at(project.beam, {s, side});
    const PlateMaterials materials = materials_of(project, segment);
    for (const PlateAt& plate : plates_of(project.beam.segments[segment].from))
      plates.push_back({&materials.of(plate.kind), thickness});
  }
  return plates;
}

PlateOf first_to_yield(const std::vector<PlateOf>& plates) {
  return weakest_by(plates, [](const PlateOf& plate) {
    return yield_strength_of(*plate.material, plate.thickness).value_or(Stress{}).value();
  });
}

PlateOf weakest_to_weld(const std::vector<PlateOf>& plates) {
  return weakest_by(plates, [](const PlateOf& plate) {
    return tensile_strength_of(*plate.material, plate.thickness).value_or(Stress{}).value() /
           plate.material->beta_w;
  });
}

}  // namespace boxbeam
