#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

/// What designs of a case have in common that differ in what resists alone: the models that are
/// chosen, the situations as they run, and what their loads do at the stations of the beams. It is
/// made of cases from which the rest is taken out (`as_runs_see`), so that nothing of that can be
/// in it. Not for several threads at once.
class KeptRuns {
 public:
  KeptRuns() = default;
  KeptRuns(const KeptRuns&) = delete;
  KeptRuns& operator=(const KeptRuns&) = delete;

  /// As `verify_beams`, without figures and advice; it looks at what is kept, until the next design
  /// is asked for. `set`: what the design is read with (`CaseSource::read_beams`). The first design
  /// runs. Precondition of those behind it: they differ from it in nothing that `runs_depend_on`.
  /// Where they differ from the one before in cycles, partial factors and what is asked for in
  /// fatigue alone, points of stress are taken from it, and without cycles what happens there.
  /// Throws AnalysisError; behind that no further design is to be asked for.
  std::vector<VerifiedBeam> verify(std::vector<Project> beams, const std::vector<std::string>& set);

 private:
  struct OfBeam {
    explicit OfBeam(const Project& project);
    OfBeam(const OfBeam&) = delete;
    OfBeam& operator=(const OfBeam&) = delete;

    Project seen;                     ///< at which motions look, as they see it
    std::unique_ptr<Project> design;  ///< the last one, at which all that is kept of it looks
    ModelledRuns moved;
    BeamMemory memory{moved.runs};
    bool has_run = false;
  };
  /// What is set: where and what is looked at, how often it is repeated, partial factors.
  struct Set {
    std::string places, cycles, of_strength;
  };
  Verification judge_by(OfBeam& beam, const Project& project, StationMemory::Change change);

  SharedMotions shared_;
  std::vector<std::unique_ptr<OfBeam>> beams_;
  std::optional<Set> before_;  ///< of the last design
};

/// Whether the model and the loads depend on what stands under a key of the case. They do not on
/// what resists: [fatigue] and the partial factors of [strength].
bool runs_depend_on(std::string_view key);

/// A case as the choice of its model and its runs see it: without what these do not depend on.
Project as_runs_see(const Project& project);

}  // namespace boxbeam
