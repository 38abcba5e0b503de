#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/section/section_properties.hpp"
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

StrengthDemand read_strength(TableReader table) {
  StrengthDemand demand;
  demand.gamma_M0 = table.number({"gamma_M0", "on yielding, EN 1993-1-1"}, 1.0);
  demand.gamma_M2 = table.number({"gamma_M2", "on welds, pins and net sections"}, 1.25);
  demand.shear_lag =
      table.boolean({"shear_lag", "wide flanges are reduced, EN 1993-1-5, 3.2"}, true);
  demand.required = table.number({"required", "wanted safety factor"});
  table.finish();
  return demand;
}

void read_points(TableReader& root, Project& project) {
  for (TableReader& table : root.tables({"points", "places of sections to be looked at"})) {
    NamedPoint point;
    point.name = table.text({"name", "of the point"});
    const auto named_alike = [&](const NamedPoint& other) { return other.name == point.name; };
    if (std::any_of(project.points.begin(), project.points.end(), named_alike)) {
      table.problem("name", fmt::format("there is already a point \"{}\"", point.name),
                    "give every point a name of its own");
    }
    point.s = station_of(table, {"station", "along the beam"}, project.beam);
    point.z = si<Length>(
        table.quantity({"z", "of the level, from the middle of the height"}, wanted::length));
    table.finish();
    if (root.problems().empty()) {
      for (const Side side : {Side::before, Side::behind}) {
        const Section section = section_at(project.beam, {point.s, side});
        const Length half = 0.5 * height_of(section.outer);
        if (abs(point.z) > half * (1.0 + 1e-12)) {
          table.problem(
              "z",
              fmt::format("the section reaches only {:.6g} mm from its middle at this "
                          "station",
                          half.value() * 1e3),
              fmt::format("write z between -{0:.6g} mm and {0:.6g} mm", half.value() * 1e3));
          break;
        }
        if (width_at(section, holes_at(project, point.s), point.z).value() <= 0.0) {
          table.problem("z", "there is no material at this level: it lies in a hole",
                        "write a level outside the hole");
          break;
        }
      }
    }
    project.points.push_back(std::move(point));
  }
}

std::string thickest_hint(const Material& material) {
  return fmt::format("its table ends at {:.6g} mm: use thinner plates or another steel",
                     material.steps.back().up_to.value() * 1e3);
}

void read_given_stresses(TableReader& root, Project& project) {
  for (TableReader& table : root.tables(
           {"given_stresses", "stresses of a published calculation, instead of computed ones"})) {
    GivenStress given;
    given.name = table.text({"name", "of the place"});
    given.s = station_of(table, {"station", "along the beam"}, project.beam);
    given.peak =
        si<Stress>(table.positive({"peak", "largest, concentration included"}, wanted::stress));
    if (table.has("opposite")) {
      given.opposite = si<Stress>(table.positive(
          {"opposite", "largest of the other sign, as a positive number"}, wanted::stress));
    }
    given.thickness = si<Length>(
        table.positive({"thickness", "of the plate, for its yield strength"}, wanted::length));
    given.time = si<Time>(table.not_negative({"time", "of the peak"}, wanted::time));
    given.note = table.text({"note", "for the report"}, "");
    table.finish();
    if (root.problems().empty() && !yield_strength_of(project.material, given.thickness)) {
      table.problem(
          "thickness",
          fmt::format("{} has no yield strength for this thickness", project.material.name),
          thickest_hint(project.material));
    }
    project.given_stresses.push_back(std::move(given));
  }
}

void check_thicknesses(TableReader& root, const Project& project) {
  for (const Segment& segment : project.beam.segments) {
    std::vector<Length> walls;
    for (const Section* section : {&segment.from, &segment.to}) {
      walls.push_back(wall_at(section->outer, Length{}));
      walls.push_back(wall_at(section->outer, 0.5 * height_of(section->outer)));
      walls.push_back(wall_at(section->outer, -0.5 * height_of(section->outer)));
      if (const auto* box = std::get_if<Box>(&section->outer)) {
        for (const Stiffener& bar : box->stiffeners) walls.push_back(bar.thickness);
      }
      if (!section->inner) continue;
      walls.push_back(wall_at(*section->inner, Length{}));
      walls.push_back(wall_at(*section->inner, 0.5 * height_of(*section->inner)));
    }
    for (const Length& wall : walls) {
      if (yield_strength_of(project.material, wall)) continue;
      root.problem("beam",
                   fmt::format("{} has no yield strength for the plate of {:.6g} mm in segment {}",
                               project.material.name, wall.value() * 1e3, segment.name),
                   thickest_hint(project.material));
      return;
    }
  }
}

}  // namespace

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
  if (!table.says_one_of({{{"steel"}}, {{"name", "fy", "fu", "up_to", "source"}}})) {
    table.problem("steel", "a material is either a steel of the catalogue or one of your own",
                  "steel = \"S355\", or name, fy, fu, up_to and source");
    return;
  }
  if (table.has("steel")) {
    project.material = read_catalogue_steel(table);
  } else {
    project.material = read_own_material(table);
    project.model.youngs_modulus = table.positive({"youngs_modulus", "of the material"},
                                                  wanted::stress, project.model.youngs_modulus);
  }
  table.finish();
}

void read_demands(TableReader& root, Project& project) {
  project.strength = read_strength(root.table({"strength", "what is wanted against yielding"}));
  project.fatigue.asked = root.has("fatigue");
  if (project.fatigue.asked) {
    project.fatigue = read_fatigue(
        root.table({"fatigue",
                    "what is wanted against fatigue; without it the verdict is for strength only"}),
        project.beam);
  } else if (!project.beam.segments.empty()) {
    project.fatigue.beam.to = project.beam.length();
  }
  read_points(root, project);
  if (root.problems().empty()) check_thicknesses(root, project);
  read_given_stresses(root, project);
}

}  // namespace boxbeam::readers
