#pragma once

#include "boxbeam/mechanism/flexible/modes.hpp"
#include "modal_problem.hpp"

namespace boxbeam::flexible {

/// The lowest modes, by Lanczos, shifted and inverted (Spectra); none is left out below the last:
/// the frequencies below it are counted. `patient`: however long it takes; else it gives up where
/// all modes by dense matrices are sooner. Throws AnalysisError where they are not found.
FoundModes lowest_modes(const ModalProblem& problem, Eigen::Index count, bool patient = true);

/// The lowest modes of a structure of the exact form, whose elastic links have mass: frequencies
/// are counted (`DynamicStiffness::frequencies_below`) and bracketed until no more than those that
/// agree lie between two counts, then refined by Rayleigh's quotient of the motion that inverse
/// iteration finds, with the mass of the links between the nodes.
///
///     D(lambda_c) Y = M(lambda_c) X,  lambda = lambda_c + theta,  Y^T M X v = theta Y^T M Y v
///
/// Each step moves lambda_c there, and the last takes the change of M into account,
/// theta (3 - m)/2 with the mass m at lambda of a mode that has mass one at lambda_c. None is
/// missed or found twice: as many as were counted, within their bracket. Source: Wittrick,
/// Williams, Quarterly Journal of Mechanics and Applied Mathematics 24 (1971).
std::vector<Mode> exact_modes_of(const Structure& structure, std::size_t count);

}  // namespace boxbeam::flexible
