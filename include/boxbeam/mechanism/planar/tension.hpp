#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "boxbeam/mechanism/planar/mechanism.hpp"

namespace boxbeam::planar {

/// The tension in a joint that keeps or drives the distance of two points [N]. Precondition:
/// `is_rod`.
double tension_in_joint(const Mechanism& mechanism, const State& state, std::size_t joint);

/// The tension in a spring between two points, with its damper [N]; zero where they are one.
/// Precondition: the force is a `Spring`.
double tension_in_spring(const Mechanism& mechanism, const State& state, std::size_t force);

/// A spring between two points as one that acts both ways and does about a state what it does
/// there: with the stiffness of an impact's law at its depth; nothing where it acts one way and not
/// now. Precondition: the force is a `Spring`.
std::optional<Spring> spring_in(const Mechanism& mechanism, const State& state, std::size_t force);

/// Which forces are springs that act in a state.
std::vector<bool> acting_springs(const Mechanism& mechanism, const State& state);

/// Whether a spring that acts one way is damped: while its ends part it may bear nothing.
bool has_damped_touches(const Mechanism& mechanism);

}  // namespace boxbeam::planar
