#pragma once

#include "readers.hpp"

/// The parts of a case of beams and frames at rest.
namespace boxbeam::readers {

/// What the members of a frame have in common.
struct FrameDefaults {
  const Sections* sections = nullptr;
  const Project* project = nullptr;
};

/// Of all its segments, none where reading them failed [m].
double length_of(const frame::Member& member);

/// [frame]: gravity, and whether it is looked at in space.
void read_frame(TableReader& root, frame::Structure& structure);

/// Where a member lies: "from" with "angle" or "to" in the plane, with "axis" or "to" and "z" in
/// space; its points.
void read_member_place(TableReader& table, const frame::Structure& structure,
                       frame::Member& member);

/// [members], beside the verified beam, which is member 0.
void read_members(TableReader& root, const FrameDefaults& defaults, frame::Structure& structure);

/// The member that "on" names.
int read_on(TableReader& table, const frame::Structure& structure);

/// A place of a member: "at" a station, a pair, a triple or a point "member.point", "on" a member,
/// which is the beam where not said.
frame::Place read_frame_place(TableReader& table, const frame::Structure& structure);

/// A place named "member.point" by the value of a key or in a list under it.
frame::Place frame_point(TableReader& table, std::string_view key, const std::string& reference,
                         const frame::Structure& structure);

/// [supports] and [joints].
void read_frame_joints(TableReader& root, frame::Structure& structure);

/// [loads], each in its load case.
void read_frame_loads(TableReader& root, frame::Structure& structure, TimeTables& tables);

/// [load_cases] and [combinations] of EN 1990, as situations.
std::vector<Situation> read_combinations(TableReader& root, const frame::Structure& structure);

/// "loads" of a situation: how often each load case counts.
std::vector<double> read_case_factors(TableReader& table, const frame::Structure& structure);

/// Two quantities in the plane, whose third is zero, or three in space.
Eigen::Vector3d vector_of(TableReader& table, const Key& key, const WantedDimension& wanted,
                          bool plane, std::optional<Eigen::Vector3d> fallback = {});

}  // namespace boxbeam::readers
