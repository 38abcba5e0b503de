#pragma once

#include <optional>

#include "modal_problem.hpp"

/// All modes at once, by dense matrices.
namespace boxbeam::flexible {

/// Flexibility and mass of all motions that loads can cause, in a basis of these.
struct SmallProblem {
  Eigen::MatrixXd basis, flexibility, mass;
};

/// In the coordinates themselves.
SmallProblem whole_problem(const ModalProblem& problem);

/// Of many rigid bodies on few springs the motions that loads can cause are few, however many
/// coordinates there are: one load after the other, without pattern, until they bring nothing new.
/// Nothing where more than `most` do.
std::optional<SmallProblem> few_motions(const ModalProblem& problem, Eigen::Index most);

/// All modes, by the flexibility R R^T of the structure: R^T M R z = theta z, q = R z. R squares
/// the round-off of high modes, what it takes from low ones: made good by Rayleigh and Ritz.
FoundModes all_modes(const SmallProblem& of);

}  // namespace boxbeam::flexible
