#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "boxbeam/mechanism/planar/equivalent_mass.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/closure_summary.hpp"
#include "boxbeam/verification/code_comparison.hpp"
#include "boxbeam/verification/cycle_figure.hpp"
#include "boxbeam/verification/elastic_figures.hpp"
#include "boxbeam/verification/figures.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "boxbeam/verification/model_choice.hpp"
#include "boxbeam/verification/neighbours.hpp"
#include "boxbeam/verification/posture.hpp"

namespace boxbeam {

/// `not_applicable`: no check fails, but a gate says that the stresses cannot be believed.
enum class Verdict { pass, fail, not_applicable };

const char* to_text(Verdict verdict);

/// Smallest and largest value over all situations, with their instants.
struct Envelope {
  Extreme smallest, largest;
};

/// A cut force that a case looks at, and what it is called there.
struct CutForceName {
  cut_force::Index which;
  const char* name;

  bool is_moment() const { return which >= cut_force::T; }
  bool bends() const { return which == cut_force::M_y || which == cut_force::M_z; }
};

/// N, V and M (V_z and M_y) in the plane, all six in space.
std::span<const CutForceName> cut_forces_looked_at(const Project& project);

/// Extremes of the cut forces at a station [N, N m], by cut_force::Index; zero where not looked at.
struct StationEnvelope {
  Station station;
  std::array<Envelope, cut_force::count> of;
};

/// Which extreme of its quantity an instant is.
enum class End {
  largest,
  smallest,
  neither,  ///< the stress where a yield check governs, which looks at the equivalent stress
};

/// Where and when a quantity has its extreme: a cut force over the whole beam and all situations,
/// the stress at the governing place only.
struct CriticalInstant {
  std::optional<CutForceName> force;  ///< nothing: the stress
  Station station;
  Time time;
  double value = 0.0;         ///< SI: N, N m, Pa
  std::size_t situation = 0;  ///< index in the case
  End end = End::largest;

  /// The name of its cut force, or "stress".
  std::string quantity() const { return force ? force->name : "stress"; }
};

/// The same loads by the Newton chain, beside the rigorous ones.
struct ChainComparison {
  Time time;
  Eigen::Vector2d chain_first, chain_second;        ///< at the chain's two stations, world [N]
  Eigen::Vector2d rigorous_first, rigorous_second;  ///< zero where not computed
  Mass chain_mass;                                  ///< that the chain yields for its last body
  Moment moment_gap;                                ///< couple left over at the pivot
};

/// How far the flanges of a tapered segment are inclined to the axis.
struct TaperSlope {
  std::string segment;
  double angle = 0.0;  ///< [rad]
};

/// The published concentration formula, evaluated for a hole that uses it.
struct PublishedConcentration {
  std::string hole;
  double diameter_to_width = 0.0;
  double factor = 0.0;
};

/// Something that a case asks for and that could not be judged.
struct NotJudged {
  Criterion by;        ///< what would have judged it
  std::string what;    ///< "fatigue", "rod hanger"
  std::string reason;  ///< "no stress range"
};

/// What is to be known of the motion in a situation.
struct MotionSummary {
  std::size_t situation = 0;  ///< index in the case
  std::size_t instants = 0;
  Time begin;
  Time period;
  bool closed = true;         ///< the motion repeats by itself after its period
  bool stands_still = false;  ///< nothing moves, and the loads are always the same
  double imbalance = 0.0;     ///< of force and moment on the beam, relative to the largest load
  /// Nothing for a chain, whose motion is explicit, and for elastic links.
  std::optional<ClosureSummary> closure;
};

/// The result of a verification.
struct Verification {
  Verdict verdict = Verdict::fail;
  ModelChoice model;
  std::vector<NotJudged> not_judged;
  SearchSummary search;             ///< of the governing places along the beam
  std::vector<CheckResult> checks;  ///< worst utilisation first
  std::vector<CriticalInstant> critical_instants;
  std::vector<StationEnvelope> stations;
  std::vector<CutForceLine> lines;     ///< at the critical instants
  std::vector<CutForceLine> envelope;  ///< smallest and largest, along the beam
  std::vector<BeamLoadRow> loads;
  std::vector<PostureFigure> postures;           ///< the first at the beginning or without load
  std::optional<LoadsOverTime> loads_over_time;  ///< at the governing station, in space
  std::optional<ElasticFigures> elastic;         ///< of elastic links
  MassProperties beam_mass;
  std::vector<MotionSummary> motions;  ///< at least one; the first situation runs
  std::optional<planar::EquivalentMass> equivalent_mass;
  std::optional<ChainComparison> chain;
  std::vector<Gate> gates;        ///< what stands against believing the stresses, or changes them
  std::vector<CodeResult> codes;  ///< the governing fatigue check under several codes
  std::vector<NeighbourResult> neighbours;  ///< what the checks of pins and rods rest on
  std::vector<TaperSlope> tapers;
  std::vector<PublishedConcentration> published_concentrations;
  std::optional<SnFigure> sn;
  // Where figures are wanted:
  std::vector<CycleFigure> cycles;  ///< of every situation that runs, the first first
  std::vector<DriverLine> drivers;
  std::optional<SectionFigure> section;  ///< where the governing check rests on cut forces

  /// The check with the highest utilisation of a criterion, or nullptr.
  const CheckResult* governing(Criterion criterion) const;
};

/// The situation, as an index in the case, in which the worst check that rests on cut forces is
/// worst.
std::size_t governing_situation_of(const Verification& verification);

/// Whether a verification brings what only pictures need.
enum class Figures { without, with };

/// Verifies a case: mechanism -> motion -> loads on the beam -> cut forces -> stress -> fatigue ->
/// checks. Throws AnalysisError where a step cannot be done.
Verification verify(const Project& project, Figures figures = Figures::without);

}  // namespace boxbeam
