#pragma once

#include "modal_problem.hpp"

namespace boxbeam::flexible {

/// The lowest modes, by Lanczos, shifted and inverted (Spectra); none is left out below the last:
/// the frequencies below it are counted. `patient`: however long it takes; else it gives up where
/// all modes by dense matrices are sooner. Throws AnalysisError where they are not found.
FoundModes lowest_modes(const ModalProblem& problem, Eigen::Index count, bool patient = true);

}  // namespace boxbeam::flexible
