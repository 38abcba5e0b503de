#pragma once

#include <optional>
#include <vector>

#include "boxbeam/mechanism/planar/equivalent_mass.hpp"
#include "boxbeam/verification/beam_checks.hpp"
#include "boxbeam/verification/beam_memory.hpp"
#include "boxbeam/verification/beam_properties.hpp"
#include "boxbeam/verification/chain_comparison.hpp"
#include "boxbeam/verification/code_comparison.hpp"
#include "boxbeam/verification/neighbours.hpp"
#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/pictures.hpp"
#include "boxbeam/verification/remedies.hpp"
#include "boxbeam/verification/shared_motions.hpp"
#include "boxbeam/verification/verified_stations.hpp"

namespace boxbeam {

/// `not_applicable`: no check fails, but a gate says that the stresses cannot be believed.
enum class Verdict { pass, fail, not_applicable };

const char* to_text(Verdict verdict);

/// The result of a verification.
struct Verification {
  Verdict verdict = Verdict::fail;
  ModelChoice model;
  SearchSummary search;                ///< of the governing places along the beam
  std::vector<MotionSummary> motions;  ///< at least one; the first situation runs
  std::vector<StationEnvelope> stations;
  std::vector<CheckResult> checks;  ///< worst utilisation first
  /// Slender plates by the route of EN 1993-1-5 that does not judge them, the worst of each
  /// criterion at the stations of the checks, without forces that come into webs.
  std::vector<CheckResult> beside;
  std::vector<SegmentRoute> routes;         ///< of segments with slender plates that are judged
  std::vector<NeighbourResult> neighbours;  ///< what the checks of pins and rods rest on
  std::vector<Gate> gates;  ///< what stands against believing the stresses, or changes them
  std::vector<NotJudged> not_judged;
  std::optional<UnsaidWelds> unsaid_welds;  ///< of diaphragms that take forces
  std::vector<CriticalInstant> critical_instants;
  std::vector<CodeResult> codes;  ///< the governing fatigue check under several codes
  std::optional<planar::EquivalentMass> equivalent_mass;
  std::optional<ChainComparison> chain;
  MassProperties beam_mass;
  std::vector<TaperSlope> tapers;
  std::vector<PublishedConcentration> published_concentrations;
  Pictures pictures;
  Remedies remedies;  ///< where they are wanted and the case fails

  /// The check with the highest utilisation of a criterion, or nullptr.
  const CheckResult* governing(Criterion criterion) const {
    return governing_of(checks, criterion);
  }
};

/// Whether a verification that fails says what would make it pass, for which it verifies again.
enum class Advice { without, with };

/// Verifies a case: mechanism -> motion -> loads on the beam -> cut forces -> stress -> fatigue ->
/// checks. Throws AnalysisError where a step cannot be done.
Verification verify(const Project& project, Figures figures = Figures::without,
                    Advice advice = Advice::without, const SharedMotions& shared = {});

/// The same from the cut forces on: the loads are those of situations that have run. These are the
/// project's own. `memory`: of these runs, turned to the project; what is found looks at it.
Verification judge(const Project& project, const std::deque<SituationRun>& runs, ModelChoice model,
                   Figures figures = Figures::without, BeamMemory* memory = nullptr);

/// The largest utilisation of a case that passes; nothing where it does not, which is known as soon
/// as one check along the beam fails.
std::optional<double> utilisation_if_it_passes(const Project& project);
/// The same of situations that have run.
std::optional<double> utilisation_if_it_passes(const Project& project,
                                               const std::deque<SituationRun>& runs,
                                               ModelChoice model);

/// A beam of a case and what was found of it.
struct VerifiedBeam {
  Project project;
  Verification verification;
};

/// Verifies each beam of a case; what moves or holds them all is solved once. Throws AnalysisError
/// with the name of the beam.
std::vector<VerifiedBeam> verify_beams(std::vector<Project> beams,
                                       Figures figures = Figures::without,
                                       Advice advice = Advice::without);

/// The beam that decides the verdict of the case: one that fails before one that is not judged
/// before one that passes, of these the most used. Precondition: there is one.
const VerifiedBeam& worst_of(const std::vector<VerifiedBeam>& beams);

}  // namespace boxbeam
