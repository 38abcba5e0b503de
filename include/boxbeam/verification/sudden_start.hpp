#pragma once

#include <memory>

#include "boxbeam/mechanism/flexible/modal_response.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/model_choice.hpp"

namespace boxbeam {

/// The mechanism with all its elements, its links never divided coarser than the case says.
flexible::Mechanism with_all_elements(const flexible::Mechanism& of, const ElasticModel& model);

/// Elastic links by as many modes as reach well beyond their drive; what these leave out is
/// corrected statically. The structure looks at its mechanism, and the modes at the structure.
struct VibratingModes {
  std::shared_ptr<const flexible::Mechanism> mechanism;
  std::shared_ptr<const flexible::Structure> structure;  ///< of the exact form resolved for all
  flexible::ModalModel modal;
};
VibratingModes modes_beyond_drive(flexible::Mechanism mechanism);

/// How long a sudden start is looked at.
struct StartSpan {
  double length = 0.0;  ///< [s]
  double steps = 0.0;
  double fastest = 0.0;     ///< frequency that the steps follow [Hz]
  bool is_resolved = true;  ///< not more steps than can be looked at
};

/// Eight periods of the drive and, of every mode that bears 1 % (`StartShares`), three periods and
/// what it takes to beat once with the drive, 1/|f - f_j|, or to die away to 1 %, which comes
/// first; in steps of a tenth of a period of the fastest mode whose own vibration bears as much.
/// Where these are more than 40000 it is fewer periods of the drive, 1.25 at least; where that is
/// not enough, it is not resolved.
StartSpan start_span_of(const flexible::ModalModel& model);

/// The loads on the beam over that time in a situation of elastic links, all of their elements with
/// their mass, as in the figures of a vibration. Throws AnalysisError where the structure moves
/// without strain, and where its start is not resolved (`start_span_of`).
LoadHistory loads_after_start(const Project& project, const Situation& situation,
                              const ElasticModel& model);

}  // namespace boxbeam
