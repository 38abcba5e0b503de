#include <fmt/format.h>

#include <algorithm>

#include "neighbour_readers.hpp"

namespace boxbeam::readers {

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

Material steel_of(TableReader& table, const Key& key, const Project& project) {
  if (table.has(key)) return named_steel(table, key);
  if (!project.part_materials.empty()) {
    table.problem(key.name, "the beam is of several materials: which of them this is, is not said",
                  fmt::format("write {} = \"{}\"", key.name, project.material.name));
  }
  return project.material;
}

std::vector<std::optional<Eigen::Vector3d>> read_neighbours(TableReader& root,
                                                            const Sections& sections,
                                                            Project& project) {
  std::vector<std::optional<Eigen::Vector3d>> directions;
  const auto check_own_name = [](TableReader& table, const auto& others, const auto& item) {
    if (std::any_of(others.begin(), others.end(),
                    [&](const auto& other) { return other.name == item.name; })) {
      table.problem("name", fmt::format("\"{}\" is there already", item.name),
                    "give each a name of its own");
    }
  };
  for (TableReader& table : root.tables({"pins", "pins, checked for shear, bearing and bending"})) {
    PinInput pin = read_pin(table, project);
    check_own_name(table, project.pins, pin);
    project.pins.push_back(std::move(pin));
  }
  for (TableReader& table :
       root.tables({"rods", "rods between two points, checked in tension and compression"})) {
    RodInput rod = read_rod(table, sections, project, directions.emplace_back());
    check_own_name(table, project.rods, rod);
    project.rods.push_back(std::move(rod));
  }
  read_deflection_of(root, project);
  return directions;
}

}  // namespace boxbeam::readers
