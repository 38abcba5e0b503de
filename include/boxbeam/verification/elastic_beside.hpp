#pragma once

#include <string>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/planar_links.hpp"

namespace boxbeam {

/// The elastic body that the verified beam of a planar case is, in at least so many parts, with
/// what is elastic beside it: other beams of the case, joints that have a stiffness, and rods by
/// their section, in the plane of motion as beams by I_y, of the softer one of the case's material
/// and structural steel. A rod between two points of a body bends and stretches between them, its
/// mass along it as `RodMass::along`; one without mass stretches. `project` stays.
ElasticBody elastic_body_of(const Project& project, int parts);

/// Why a rod counts as rigid although it has a section; "" of all that is elastic.
std::string obstacle_to_elasticity(const Project& project, const ElasticBeside& of);

/// Behind a frequency: " (arm, strut elastic as well; rod link counts as rigid: ..)"; "" where
/// nothing has a section but the beam.
std::string elastic_beside_text(const Project& project);

}  // namespace boxbeam
