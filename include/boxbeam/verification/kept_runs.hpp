#pragma once

#include <memory>
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
  /// is asked for. The first design runs. Precondition of those behind it: they differ from it in
  /// nothing that `runs_depend_on`. Throws AnalysisError; behind that no further design is to be
  /// asked for.
  std::vector<VerifiedBeam> verify(std::vector<Project> beams);

 private:
  struct OfBeam {
    explicit OfBeam(const Project& project);
    OfBeam(const OfBeam&) = delete;
    OfBeam& operator=(const OfBeam&) = delete;

    Project seen;  ///< at which motions look, as they see it
    ModelledRuns moved;
    BeamMemory memory{moved.runs};
    bool has_run = false;
  };
  Verification judge_by(OfBeam& beam, const Project& project);

  SharedMotions shared_;
  std::vector<std::unique_ptr<OfBeam>> beams_;
};

/// Whether the model and the loads depend on what stands under a key of the case. They do not on
/// what resists: [fatigue] and the partial factors of [strength].
bool runs_depend_on(std::string_view key);

/// A case as the choice of its model and its runs see it: without what these do not depend on.
Project as_runs_see(const Project& project);

}  // namespace boxbeam
