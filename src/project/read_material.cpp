#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/project/plate_material.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

Material read_own_material(TableReader& table) {
  Material own;
  own.name = table.text({"name", "of a material that is not in the catalogue"});
  const auto read_step = [](TableReader& of) {
    ThicknessStep step;
    step.up_to =
        si<Length>(of.positive({"up_to", "thickness to which the strengths hold"}, wanted::length));
    step.yield_strength =
        si<Stress>(of.positive({"fy", "yield or 0.2 % proof strength"}, wanted::stress));
    step.tensile_strength =
        si<Stress>(of.positive({"fu", "tensile strength, its lower end"}, wanted::stress));
    if (step.tensile_strength < step.yield_strength) {
      of.problem("fu", "the tensile strength is below the yield strength",
                 "write the lower end of R_m, and check fy");
    }
    return step;
  };
  own.steps.push_back(read_step(table));
  for (TableReader& thicker : table.tables({"thicker", "strengths of thicker plates"})) {
    const ThicknessStep step = read_step(thicker);
    if (step.up_to <= own.steps.back().up_to) {
      thicker.problem("up_to", "each further thickness is above the one before",
                      "write them in ascending order");
    }
    own.steps.push_back(step);
    thicker.finish();
  }
  own.source = table.text({"source", "standard or certificate of the strengths, for the report"});
  own.beta_w =
      table.number({"beta_w", "correlation factor of its fillet welds, EN 1993-1-8"}, own.beta_w);
  if (own.beta_w < 0.8) {
    table.problem("beta_w", "EN 1993-1-8, table 4.1 begins at 0.8", "write 0.8 to 1.0");
  }
  return own;
}

Material read_catalogue_steel(TableReader& table) {
  std::string source;
  if (table.has("fy_source")) {
    const std::vector<std::string>& all = steel_sources();
    source = all[table.choice(
        {"fy_source",
         "standard of the strengths; the lower of its product's and the design code's where not "
         "said"},
        all)];
  }
  return named_steel(table, {"steel", "\"S355\", \"S690QL\"; a steel of the catalogue"}, source);
}

/// A steel of the catalogue or a material of one's own; a problem and nothing where it is neither.
std::optional<Material> read_material_of(TableReader& table) {
  if (!table.says_one_of({{{"steel"}}, {{"name", "fy", "fu", "up_to", "source"}}})) {
    table.problem("steel", "a material is either a steel of the catalogue or one of your own",
                  "steel = \"S355\", or name, fy, fu, up_to and source");
    return std::nullopt;
  }
  return table.has("steel") ? read_catalogue_steel(table) : read_own_material(table);
}

std::vector<bool> read_segments(TableReader& table, const std::vector<Segment>& segments) {
  const Key of{"segments", "names of those it holds for; all where not said"};
  if (!table.has(of.name)) return std::vector<bool>(segments.size(), true);
  std::vector<bool> listed(segments.size(), false);
  const std::vector<std::string> said = table.texts(of, true);
  if (table.problems().empty() && said.empty())
    table.problem(of.name, "no segment is of this material",
                  "name some, or leave the key out for all");
  for (const std::string& name : said) {
    const int found = index_by_name(segments, name);
    if (found >= 0)
      listed[static_cast<std::size_t>(found)] = true;
    else
      table.problem(of.name, fmt::format("the beam has no segment \"{}\"", name),
                    unknown_hint(name, names_of(segments)));
  }
  return listed;
}

std::array<bool, plate_kinds> read_plates(TableReader& table, const PartMaterial& part,
                                          const std::vector<Segment>& segments) {
  const Key of{
      "plates",
      "those it holds for: \"top flange\", \"bottom flange\", \"left web\", \"right web\", "
      "\"stiffeners\", \"inner profile\", \"walls\" of tubes; all where not said"};
  std::array<bool, plate_kinds> listed{};
  if (!table.has(of.name)) {
    listed.fill(true);
    return listed;
  }
  std::array<bool, plate_kinds> there{};
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!part.segments[i]) continue;
    for (const PlateAt& plate : plates_of(segments[i].from))
      there[static_cast<std::size_t>(plate.kind)] = true;
  }
  const std::vector<std::string>& names = plate_kind_names();
  const std::vector<std::string> said = table.texts(of, true);
  if (table.problems().empty() && said.empty())
    table.problem(of.name, "no plate is of this material",
                  "name some, or leave the key out for all");
  for (const std::string& name : said) {
    const auto found = std::find(names.begin(), names.end(), name);
    const auto kind = static_cast<std::size_t>(found - names.begin());
    if (found == names.end()) {
      table.problem(of.name, fmt::format("\"{}\" is no plate of a section", name),
                    unknown_hint(name, names));
    } else if (!there[kind] && table.problems().empty()) {
      table.problem(of.name, fmt::format("no section of these segments has a plate \"{}\"", name),
                    "name plates that are there, or leave the key out for all");
    } else {
      listed[kind] = true;
    }
  }
  return listed;
}

/// Refuses plates that are thicker than the table of what they are made of goes.
void check_thicknesses(TableReader& root, const Project& project) {
  const std::vector<Segment>& segments = project.beam.segments;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const PlateMaterials materials = materials_of(project, i);
    for (const Section* section : {&segments[i].from, &segments[i].to}) {
      for (const PlateAt& plate : plates_of(*section)) {
        const Material& material = materials.of(plate.kind);
        if (yield_strength_of(material, plate.thickness)) continue;
        root.problem(
            "beam",
            fmt::format("{} has no yield strength for the plate of {:.6g} mm in segment {}",
                        material.name, plate.thickness.value() * 1e3, segments[i].name),
            thickest_hint(material));
        return;
      }
    }
  }
}

}  // namespace

std::string thickest_hint(const Material& material) {
  return fmt::format("its table ends at {:.6g} mm: use thinner plates or another steel",
                     material.steps.back().up_to.value() * 1e3);
}

Material named_steel(TableReader& table, const Key& of, const std::string& source) {
  const std::string_view key = of.name;
  const std::string name = table.text(of);
  const std::vector<std::string> sources = sources_of_steel(name);
  if (!sources.empty() && !source.empty() &&
      std::find(sources.begin(), sources.end(), source) == sources.end()) {
    table.problem("fy_source", fmt::format("{} does not have {}", source, name),
                  fmt::format("write {}, or leave it out", fmt::join(sources, " or ")));
    return *find_steel(name);
  }
  if (const auto steel = source.empty() ? find_steel(name) : find_steel(name, source))
    return *steel;
  if (!name.empty()) {
    std::vector<std::string> near;
    for (const std::string& steel : steel_names()) {
      if (steel.starts_with(name)) near.push_back(fmt::format("\"{}\"", steel));
    }
    if (near.empty()) {
      const std::string nearest = nearest_word(name, steel_names());
      if (!nearest.empty()) near.push_back(fmt::format("\"{}\"", nearest));
    }
    table.problem(
        key, fmt::format("there is no steel \"{}\" in the catalogue", name),
        fmt::format("{}one of {}",
                    near.empty() ? "" : fmt::format("did you mean {}? ", fmt::join(near, " or ")),
                    fmt::join(steel_names(), ", ")));
  }
  return {};
}

void read_material(TableReader& root, Project& project) {
  TableReader table = root.table({"material", "what the beam is made of"});
  std::optional<Material> material = read_material_of(table);
  if (!material) return;
  project.material = std::move(*material);
  if (!table.has("steel")) {
    project.model.youngs_modulus = table.positive({"youngs_modulus", "of the material"},
                                                  wanted::stress, project.model.youngs_modulus);
  }
  table.finish();
}

void check_modulus(TableReader& root, const Node& tree, const Project& project) {
  const Node* const material = tree.find("material");
  if (!root.problems().empty() || material == nullptr || material->find("steel") != nullptr) return;
  for (const char* const part : {"material", "model"}) {
    const Node* const of = tree.find(part);
    if (of != nullptr && of->find("youngs_modulus") != nullptr) return;
  }
  // Carbon steel has 7850, stainless steel 7600 to 8100 kg/m^3.
  constexpr double lightest = 7500.0, heaviest = 8300.0;
  const double density = project.beam.density.value();
  if (density >= lightest && density <= heaviest) return;
  root.problem("material",
               fmt::format("the beam's density, {:.6g} kg/m^3, is not that of steel, and Young's "
                           "modulus of {} is not said",
                           density, project.material.name),
               "write youngs_modulus = \"70 GPa\" of aluminium, \"210 GPa\" of steel whatever "
               "the density stands for");
}

void read_part_materials(TableReader& root, Project& project) {
  const std::vector<Segment>& segments = project.beam.segments;
  for (TableReader& table :
       root.tables({"part_materials",
                    "of plates that are not of [material]; where several say a plate, the last; "
                    "Young's modulus stays that of [material]"})) {
    std::optional<Material> material = read_material_of(table);
    if (!material) continue;
    PartMaterial part{std::move(*material), {}, {}};
    part.segments = read_segments(table, segments);
    part.plates = read_plates(table, part, segments);
    table.finish();
    project.part_materials.push_back(std::move(part));
  }
  if (root.problems().empty()) check_thicknesses(root, project);
}

}  // namespace boxbeam::readers
