#pragma once

#include <map>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/project/table_reader.hpp"

/// The parts of a case file, each read by one function. They note problems and go on; what they
/// return is only meaningful where none was noted.
namespace boxbeam::readers {

using Sections = std::map<std::string, Section>;

Sections read_sections(TableReader table);

/// Segments, holes and places of [beam]; fills the project's beam and hole cases.
void read_beam(TableReader& table, const Sections& sections, Project& project);

/// Bodies, joints, drivers and loops. Points stay in the axes in which they are written until
/// `place_at_centres` moves them; the mass of the beam body is not known before.
struct MechanismDraft {
  planar::Mechanism mechanism;
  std::vector<Eigen::Vector2d> centres;  ///< of mass, in the axes in which the points are written
};

MechanismDraft read_mechanism(TableReader& root, const std::string& beam_body);

/// Gives the beam body the beam's mass properties and moves every body's axes to its centre.
planar::Mechanism place_at_centres(MechanismDraft draft, const TaperedBeam& beam, int beam_body);

/// The nearest of the known names, or all of them where none is near.
std::string unknown_hint(std::string_view name, const std::vector<std::string>& known);

/// Index of a body or joint named by the value of a key, a problem and -1 where there is none.
int body_of(TableReader& table, std::string_view key, const planar::Mechanism& mechanism);
int joint_of(TableReader& table, std::string_view key, const planar::Mechanism& mechanism);

/// A station given as a length along the beam, within it.
Length station_of(TableReader& table, std::string_view key, const TaperedBeam& beam);

planar::NewtonChain read_newton_chain(TableReader table, const planar::Mechanism& mechanism,
                                      const TaperedBeam& beam, int beam_body);

void read_demands(TableReader& root, Project& project);

}  // namespace boxbeam::readers
