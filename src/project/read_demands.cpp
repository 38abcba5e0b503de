#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

StrengthDemand read_strength(TableReader table) {
  StrengthDemand demand;
  demand.gamma_M0 = table.number({"gamma_M0", "on yielding, EN 1993-1-1"}, 1.0);
  demand.gamma_M1 = table.number(
      {"gamma_M1",
       "on members that buckle, EN 1993-1-1, and plates, in shear and by reduced stresses, EN "
       "1993-1-5"},
      1.0);
  demand.gamma_M2 = table.number({"gamma_M2", "on welds, pins and net sections"}, 1.25);
  const auto moment_factor = [&](const char* name, const char* meaning) {
    const double C_m = table.number({name, meaning}, 1.0);
    if (C_m < 0.4 || C_m > 1.0)
      table.problem(name, "an equivalent uniform moment factor lies between 0.4 and 1",
                    "EN 1993-1-1, table B.3; 1 is on the safe side");
    return C_m;
  };
  demand.C_my = moment_factor("C_my",
                              "of M_y of the beam as a member, EN 1993-1-1, table B.3, by how M_y "
                              "runs along it: 0.6 from an end to none; 0.9 where it sways");
  demand.C_mz = moment_factor("C_mz", "the same of M_z");
  demand.shear_lag =
      table.boolean({"shear_lag", "wide flanges are reduced, EN 1993-1-5, 3.2"}, true);
  demand.plates = static_cast<PlateRoute>(table.choice(
      {"plates",
       "how boxes and rectangular tubes whose plates buckle are judged: by effective widths (EN "
       "1993-1-5, 4 to 7), or plate by plate on the gross section (10); segments whose edges are "
       "inclined by more than 10 deg by reduced stresses anyway"},
      {"effective widths", "reduced stresses"}, 0));
  constexpr std::array rules{WidthRule::at_yield, WidthRule::below_yield, WidthRule::annex_E};
  demand.effective_widths =
      rules[table.choice({"effective_widths", "stress by which plates buckle, EN 1993-1-5, 4.4(4)"},
                         {"at yield", "below yield", "annex E"}, 0)];
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
    if (root.problems().empty()) {
      const Material& weakest =
          *first_to_yield(plates_around(project, given.s, given.thickness)).material;
      if (!yield_strength_of(weakest, given.thickness)) {
        table.problem("thickness",
                      fmt::format("{} has no yield strength for this thickness", weakest.name),
                      thickest_hint(weakest));
      }
    }
    project.given_stresses.push_back(std::move(given));
  }
  const std::vector<BeamDetail>& details = project.fatigue.details;
  const bool elsewhere = std::any_of(details.begin(), details.end(), [](const BeamDetail& of) {
    return of.on == DetailPlace::webs || of.on == DetailPlace::seams;
  });
  if (elsewhere && !project.given_stresses.empty() && root.problems().empty()) {
    root.problem("given_stresses",
                 "given stresses are those of fibres, and a detail of webs or seams resists none",
                 "write on = \"section\" in [[fatigue.details]]");
  }
}

}  // namespace

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
  read_given_stresses(root, project);
}

}  // namespace boxbeam::readers
