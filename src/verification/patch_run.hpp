#pragma once

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "boxbeam/verification/front_end.hpp"
#include "patch_notes.hpp"
#include "patch_search.hpp"
#include "patched_holes.hpp"

namespace boxbeam {

/// Where a patch is used most.
struct WorstPatch {
  Patch patch;
  Borne borne;
  const SituationRun* run = nullptr;
  Time time;
  double use = 0.0;
};

/// A patch and what bears it.
using BorneKey = std::pair<PatchKey, Borne::Part>;

/// A force into a path that is not judged, where it is largest.
struct PathForce {
  Length s;
  Force size;
  std::string why;
  bool said = false;  ///< in the verdict line, where it does not block
};

/// What is not judged of slender paths.
struct OnPaths {
  /// By the name of the force, whether a diaphragm is missing, and whether it blocks.
  std::map<std::tuple<std::string, bool, bool>, PathForce> forces;
  PatchSearch::PathTorque torque;

  /// Gates, and what is only said in the verdict line.
  void add_to(PatchChecks& found, const Project& project) const;
};

/// Looks at the patches of one run, at its instants and between them, and keeps the worst.
class PatchRun {
 public:
  PatchRun(const Project& project, PatchSearch& search, const SituationRun& run,
           std::map<BorneKey, WorstPatch>& worst, OnPaths& on_paths, PatchNotes& notes,
           PatchedHoles& holes, PressingForces* pressed)
      : project_(&project),
        search_(&search),
        run_(&run),
        worst_(&worst),
        on_paths_(&on_paths),
        notes_(&notes),
        holes_(&holes),
        pressed_(pressed) {}

  void look();

 private:
  /// The use of each patch at an instant, or of one alone; the worst is kept.
  std::map<BorneKey, double> look_at(Time time, const std::vector<Patch>& patches,
                                     const CutForceDiagram& diagram,
                                     const BorneKey* only = nullptr);
  void note_on_path(const Patch& patch);
  /// All forces along y that come in at a place.
  Force along_y_at(const BeamLoads& loads, Length s) const;
  /// Of what holds slender webs, and of moments that come in between the ends.
  void note_places(const BeamLoads& loads);
  void note_torque(const BeamLoads& loads);
  std::map<BorneKey, double> look_at(Time time, const BorneKey* only = nullptr);
  /// What comes in at a time.
  struct Coming {
    BeamLoads loads;
    CutForceDiagram diagram;
    std::vector<Patch> patches;
  };
  const Coming& coming_at(Time time);
  static std::vector<Length> places_in(const BeamLoads& loads);
  /// Both sides of every passage of a load over a place where what bears it changes.
  void look_at_passages(Time from, Time to, const std::vector<Length>& before,
                        const std::vector<Length>& behind);
  std::vector<Length> borders() const;
  /// The maximum between the instants beside one.
  void refine(const BorneKey& key, std::size_t i);

  const Project* project_;
  PatchSearch* search_;
  const SituationRun* run_;
  std::map<BorneKey, WorstPatch>* worst_;
  OnPaths* on_paths_;
  PatchNotes* notes_;
  PatchedHoles* holes_;
  PressingForces* pressed_;  ///< nothing where no cycles are counted
  /// Of several patches the search between the same instants begins alike.
  ExactMemo<1, Coming> coming_;
};

}  // namespace boxbeam
