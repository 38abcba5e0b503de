#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/strength/plate_slenderness.hpp"
#include "boxbeam/strength/section_class.hpp"
#include "boxbeam/verification/model_gates.hpp"

namespace boxbeam {
namespace {

/// The first segment in which a flange is more than twice as strong as a web, or "".
std::string too_hybrid(const Project& project) {
  if (project.part_materials.empty()) return "";
  for (std::size_t i = 0; i < project.beam.segments.size(); ++i) {
    const PlateMaterials materials = materials_of(project, i);
    for (const Section* section : {&project.beam.segments[i].from, &project.beam.segments[i].to}) {
      double flange = 0.0, web = std::numeric_limits<double>::infinity();
      for (const PlateAt& plate : plates_of(*section)) {
        const auto yield = yield_strength_of(materials.of(plate.kind), plate.thickness);
        if (!yield) continue;
        if (plate.kind == PlateKind::top_flange || plate.kind == PlateKind::bottom_flange)
          flange = std::max(flange, yield->value());
        if (plate.kind == PlateKind::left_web || plate.kind == PlateKind::right_web)
          web = std::min(web, yield->value());
      }
      if (flange > 2.0 * web) return project.beam.segments[i].name;
    }
  }
  return "";
}

}  // namespace

std::vector<Gate> material_gates_of(const Project& project) {
  const double E = project.model.youngs_modulus;
  std::vector<Gate> gates;
  const std::vector<const Material*> materials = materials_of(project);
  const auto strongest_of = [](const Material& material) {
    Stress strongest{};
    for (const ThicknessStep& step : material.steps)
      strongest = std::max(strongest, step.yield_strength, std::less<>());
    return strongest;
  };
  const Material& material = **std::max_element(
      materials.begin(), materials.end(),
      [&](const Material* a, const Material* b) { return strongest_of(*a) < strongest_of(*b); });
  const Stress strongest = strongest_of(material);
  constexpr double of_steel = 210e9, near = 0.02;
  constexpr double least_stainless = 190e9, most_stainless = 225e9;
  if (E < least_stainless || E > most_stainless) {
    gates.push_back({"", "",
                     fmt::format("{} has E = {:.4g} GPa and is no steel: lines of fatigue (EN "
                                 "1993-1-9, 1.1(2)), limits of slenderness and rules of welds of "
                                 "EN 1993 are not its own",
                                 material.name, E * 1e-9),
                     true});
  } else if (std::abs(E - of_steel) > near * of_steel) {
    const auto look_at = [&](const Profile& profile, const PlateMaterials& of,
                             const std::string& segment) {
      for (const SlenderPlate& plate : plate_slenderness_of(profile, of)) {
        const double softer = std::sqrt(E / of_steel);
        const double limit = std::min(37.0 * epsilon_of(strongest), plate.limit) * softer;
        if (plate.ratio <= limit) continue;
        gates.push_back({segment, plate.plate,
                         fmt::format("c/t = {:.3g} is above 37 epsilon = {:.3g}: with E = {:.4g} "
                                     "GPa {} is judged as stainless steel, whose class there "
                                     "(EN 1993-1-4, table 5.2) is not looked at",
                                     plate.ratio, limit, E * 1e-9, material.name),
                         true});
        return;
      }
    };
    for (std::size_t i = 0; i < project.beam.segments.size(); ++i) {
      const Segment& segment = project.beam.segments[i];
      const PlateMaterials of = materials_of(project, i);
      for (const Section* section : {&segment.from, &segment.to}) {
        look_at(section->outer, of, segment.name);
        if (section->inner) look_at(*section->inner, of.of(PlateKind::inner), segment.name);
        if (!gates.empty()) return gates;
      }
    }
  }
  if (const std::string hybrid = too_hybrid(project); !hybrid.empty())
    gates.push_back(
        {hybrid, "",
         "a flange has more than twice the yield strength of a web: the rules of hybrid "
         "beams end there (EN 1993-1-5, 4.3(6))",
         true});
  if (strongest > si<Stress>(700e6)) {
    gates.push_back({"", "",
                     fmt::format("EN 1993 ends at S700 (EN 1993-1-12, 1.1): its rules are applied "
                                 "to {} beyond their range",
                                 material.name),
                     false});
  }
  if (strongest > si<Stress>(460e6)) {
    gates.push_back({"", "",
                     fmt::format("{} is above S460: filler metal of welds at least as strong as "
                                 "the plates is taken for granted (EN 1993-1-12, 2.8)",
                                 material.name),
                     false});
  }
  return gates;
}

}  // namespace boxbeam
