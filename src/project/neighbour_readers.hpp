#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

#include "readers.hpp"

/// What stands beside a beam: pins and rods.
namespace boxbeam::readers {

/// The strength of a steel at a thickness, a problem where it has none.
Stress strength_at(TableReader& table, std::string_view key, const Material& material,
                   std::optional<Stress> (*strength_of)(const Material&, Length), Length thickness);

/// The steel under a key, or that of the beam where it is of one.
Material steel_of(TableReader& table, const Key& key, const Project& project);

/// [[pins]] with their lugs.
PinInput read_pin(TableReader table, const Project& project);

/// [[rods]]. `z`: of one that is a body in space, where its section's z points in that body, if it
/// is said.
RodInput read_rod(TableReader table, const Sections& sections, const Project& project,
                  std::optional<Eigen::Vector3d>& z);

}  // namespace boxbeam::readers
