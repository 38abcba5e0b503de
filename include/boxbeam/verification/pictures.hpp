#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "boxbeam/verification/critical_instants.hpp"
#include "boxbeam/verification/cycle_figure.hpp"
#include "boxbeam/verification/elastic_figures.hpp"
#include "boxbeam/verification/figures.hpp"
#include "boxbeam/verification/front_end.hpp"

/// What the report draws, computed from the situations of a verification that run.
namespace boxbeam {

/// Whether a verification brings what only pictures need, and scenes in space, for pages, too.
enum class Figures { without, with, with_scenes };

struct Pictures {
  std::vector<CutForceLine> lines;     ///< at the critical instants
  std::vector<CutForceLine> envelope;  ///< smallest and largest, along the beam
  std::vector<BeamLoadRow> loads;
  std::vector<PostureFigure> postures;           ///< the first at the beginning or without load
  std::optional<LoadsOverTime> loads_over_time;  ///< at the governing station, in space
  std::optional<ElasticFigures> elastic;         ///< of elastic links
  std::optional<SnFigure> sn;                    ///< of the governing fatigue check
  // Where figures are wanted:
  std::vector<CycleFigure> cycles;  ///< of every situation that runs, the first first
  std::vector<DriverLine> drivers;
  std::optional<SectionFigure> section;  ///< where the governing check rests on cut forces
};

struct BeamMemory;

/// The checks stand worst first. What is drawn of the loads alone is taken from `memory`.
Pictures pictures_of(const Project& project, const std::deque<SituationRun>& runs,
                     const ElasticModel& model, const std::vector<CheckResult>& checks,
                     const std::vector<CriticalInstant>& instants,
                     const std::vector<MotionSummary>& motions, Figures figures,
                     BeamMemory* memory = nullptr);

/// The situation, as an index in the case, in which the worst check that rests on cut forces is
/// worst; without one, the first that runs.
std::size_t governing_situation_of(const std::vector<CheckResult>& checks,
                                   const std::vector<MotionSummary>& motions);

/// The postures of a situation, with its name and that of the loads' situation in them.
PostureAt postures_of(const Project& project, const SituationRun& run);

/// 48 instants of a situation, evenly divided: of a motion that repeats without its end, of one
/// that stays open with it. `governing`: a check that rests on cut forces, or nullptr; in space its
/// instant is shown where it is of this situation and there is a scene.
CycleFigure cycle_figure_of(const Project& project, const SituationRun& run,
                            const CheckResult* governing = nullptr,
                            Figures figures = Figures::with);

/// The section where the worst check that rests on cut forces stands; nothing where none does.
std::optional<SectionFigure> section_figure_of(const Project& project,
                                               const std::deque<SituationRun>& runs,
                                               const std::vector<CheckResult>& checks);

}  // namespace boxbeam
