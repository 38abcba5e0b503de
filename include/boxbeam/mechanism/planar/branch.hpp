#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/planar/mechanism.hpp"

namespace boxbeam::planar {

/// The measure whose sign tells the two assemblies of a loop apart [m^2 or m]; zero at a dead
/// point.
double measure_of(const Loop& loop, const Eigen::VectorXd& q);

/// Whether each loop is on +1 or -1 (or 0, exactly at a dead point) in a position.
std::vector<int> branch_of(const Mechanism& mechanism, const Eigen::VectorXd& q);

/// Whether every loop is on the wanted branch, also where equations stand at the position already.
bool on_branch(const Mechanism& mechanism, const Eigen::VectorXd& q);
bool on_branch(const Mechanism& mechanism, const ConstraintEquations& at);

/// The names of the loops that are not on the wanted branch, "" where all are.
std::string loops_off_branch(const Mechanism& mechanism, const Eigen::VectorXd& q);

}  // namespace boxbeam::planar
