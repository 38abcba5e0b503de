#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "boxbeam/section/section_properties.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

/// E and G of structural steel. Source: EN 1993-1-1:2005, 3.2.6.
constexpr double youngs_modulus = 210e9;
constexpr double shear_modulus = 81e9;

/// The strength of a steel at a thickness, a problem where it has none.
Stress strength_at(TableReader& table, std::string_view key, const Material& material,
                   std::optional<Stress> (*strength_of)(const Material&, Length),
                   Length thickness) {
  if (material.steps.empty() || !table.problems().empty()) return {};
  if (const auto strength = strength_of(material, thickness)) return *strength;
  table.problem(
      key,
      fmt::format("{} has no strength for a thickness of {:.6g} mm", material.name,
                  thickness.value() * 1e3),
      fmt::format("its table ends at {:.6g} mm", material.steps.back().up_to.value() * 1e3));
  return {};
}

/// The steel under a key, or that of the beam.
Material steel_of(TableReader& table, std::string_view key, const Project& project) {
  return table.has(key) ? named_steel(table, key) : project.material;
}

PinInput read_pin(TableReader table, const Project& project) {
  PinInput pin;
  pin.name = table.text("name");
  pin.joint = joint_of(table, "joint", planar_of(project));
  PinJoint& geometry = pin.geometry;
  geometry.diameter = si<Length>(table.positive("diameter", wanted::length));
  geometry.hole = si<Length>(table.positive("hole", wanted::length, geometry.diameter.value()));
  geometry.inner_plate = si<Length>(table.positive("inner_plate", wanted::length));
  geometry.outer_plate = si<Length>(table.positive("outer_plate", wanted::length));
  geometry.gap = si<Length>(table.not_negative("gap", wanted::length, 0.0));
  if (geometry.hole < geometry.diameter) {
    table.problem("hole", "the pin does not fit its hole", "write its diameter or more");
  }
  PinStrength& strength = pin.strength;
  const Material steel = steel_of(table, "steel", project);
  const Material plates = steel_of(table, "plate_steel", project);
  strength.pin_yield = strength_at(table, "diameter", steel, yield_strength_of, geometry.diameter);
  strength.pin_tensile =
      strength_at(table, "diameter", steel, tensile_strength_of, geometry.diameter);
  strength.inner_yield =
      strength_at(table, "inner_plate", plates, yield_strength_of, geometry.inner_plate);
  strength.outer_yield =
      strength_at(table, "outer_plate", plates, yield_strength_of, geometry.outer_plate);
  strength.gamma_M0 = table.number("gamma_M0", project.strength.gamma_M0);
  strength.gamma_M2 = table.number("gamma_M2", strength.gamma_M2);
  pin.required = table.number("required", project.strength.required);
  table.finish();
  return pin;
}

/// Whether joints hold a rod at both its points, and no situation changes its body.
void check_rod_ends(TableReader& table, const RodInput& rod, const Project& project) {
  const double size = (rod.to.p - rod.from.p).norm();
  const auto held_at = [&](const planar::Attachment& end) {
    return std::any_of(planar_of(project).joints.begin(), planar_of(project).joints.end(),
                       [&](const planar::Joint& joint) {
                         const auto [a, b] = planar::ends_of(joint);
                         const auto here = [&](const planar::Attachment& at) {
                           return at.body == end.body && (at.p - end.p).norm() < 1e-9 * size;
                         };
                         return here(a) || here(b);
                       });
  };
  for (const auto& [key, end] : {std::pair{"from", rod.from}, {"to", rod.to}}) {
    if (held_at(end)) continue;
    table.problem(key, "no joint holds the rod at this point, and nothing presses it there",
                  "write the points at which joints hold it");
  }
  const std::string& body = planar_of(project).bodies[static_cast<std::size_t>(rod.from.body)].name;
  for (const Situation& situation : project.situations) {
    for (const std::string& change : situation.set) {
      if (!change.starts_with("bodies." + body + ".")) continue;
      table.problem("from",
                    fmt::format("situation \"{}\" changes the body of the rod", situation.name),
                    "leave the rod's body as it is, or take the rod out of the checks");
    }
  }
}

RodInput read_rod(TableReader table, const Sections& sections, const Project& project) {
  RodInput rod;
  rod.name = table.text("name");
  rod.from = attachment_of(table, "from", planar_of(project));
  rod.to = attachment_of(table, "to", planar_of(project));
  const std::size_t before = table.problems().size();
  rod.section = named_section(table, "section", sections);
  const double distance = (rod.to.p - rod.from.p).norm();
  if (table.problems().empty() && (rod.from.body != rod.to.body || distance == 0.0)) {
    table.problem("to", "a rod goes from one point of a body to another one of the same body",
                  "write two of its points");
  }
  rod.buckling_length = si<Length>(table.positive("buckling_length", wanted::length,
                                                  distance > 0.0 ? std::optional(distance) : 1.0));
  constexpr std::array curves{BucklingCurve::a0, BucklingCurve::a, BucklingCurve::b,
                              BucklingCurve::c, BucklingCurve::d};
  rod.curve = curves[table.choice("curve", {"a0", "a", "b", "c", "d"})];
  rod.gamma_M1 = table.number("gamma_M1", 1.0);
  rod.required = table.number("required", project.strength.required);
  const Material steel = steel_of(table, "steel", project);
  if (table.problems().size() == before && table.problems().empty()) {
    const Length half = 0.5 * height_of(rod.section.outer);
    const Length wall =
        std::max({wall_at(rod.section.outer, Length{}), wall_at(rod.section.outer, half),
                  wall_at(rod.section.outer, -half)});
    check_rod_ends(table, rod, project);
    rod.yield_strength = strength_at(table, "section", steel, yield_strength_of, wall);
  }
  table.finish();
  return rod;
}

DeflectionInput read_deflection(TableReader table, const TaperedBeam& beam) {
  DeflectionInput deflection;
  deflection.limit = si<Length>(table.positive("limit", wanted::length));
  deflection.from = station_of(table, "from", beam);
  deflection.to = station_of(table, "to", beam);
  if (table.problems().empty() && !(deflection.from < deflection.to)) {
    table.problem("to", "the line from which the deflection is measured has no length",
                  "write two stations, \"from\" before \"to\"");
  }
  deflection.youngs_modulus =
      si<Stress>(table.positive("youngs_modulus", wanted::stress, youngs_modulus));
  deflection.shear_modulus =
      si<Stress>(table.positive("shear_modulus", wanted::stress, shear_modulus));
  table.finish();
  return deflection;
}

}  // namespace

void read_neighbours(TableReader& root, const Sections& sections, Project& project) {
  const auto check_own_name = [](TableReader& table, const auto& others, const auto& item) {
    if (std::any_of(others.begin(), others.end(),
                    [&](const auto& other) { return other.name == item.name; })) {
      table.problem("name", fmt::format("\"{}\" is there already", item.name),
                    "give each a name of its own");
    }
  };
  for (TableReader& table : root.tables("pins")) {
    PinInput pin = read_pin(table, project);
    check_own_name(table, project.pins, pin);
    project.pins.push_back(std::move(pin));
  }
  for (TableReader& table : root.tables("rods")) {
    RodInput rod = read_rod(table, sections, project);
    check_own_name(table, project.rods, rod);
    project.rods.push_back(std::move(rod));
  }
  if (root.has("deflection")) {
    project.deflection = read_deflection(root.table("deflection"), project.beam);
  }
}

}  // namespace boxbeam::readers
