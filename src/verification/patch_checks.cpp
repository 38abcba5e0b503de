#include "boxbeam/verification/patch_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "boxbeam/numerics/extremum.hpp"
#include "patch_search.hpp"

namespace boxbeam {
namespace {

/// Where a patch is used most.
struct WorstPatch {
  Patch patch;
  Borne borne;
  const SituationRun* run = nullptr;
  Time time;
  double use = 0.0;
};

/// A force that comes into a slender path, where it is largest.
struct PathForce {
  Length s;
  Force size;
  bool open = false;  ///< without a diaphragm that takes it
};

/// Looks at one run.
class PatchRun {
 public:
  PatchRun(const Project& project, PatchSearch& search, const SituationRun& run,
           std::map<PatchKey, WorstPatch>& worst, std::map<std::string, PathForce>& on_paths)
      : project_(&project), search_(&search), run_(&run), worst_(&worst), on_paths_(&on_paths) {}

  void look() {
    const LoadHistory& history = run_->loads;
    std::map<PatchKey, std::pair<double, std::size_t>> highest;
    std::vector<Length> before;
    for (std::size_t i = 0; i < history.instants(); ++i) {
      const Time time = history.time_of(i);
      const BeamLoads loads = history.loads_at(time);
      for (const auto& [key, use] : look_at(time, loads, history.diagram(i))) {
        const auto known = highest.try_emplace(key, use, i).first;
        if (use > known->second.first) known->second = {use, i};
      }
      std::vector<Length> places = places_in(loads);
      if (i > 0 && !history.is_recorded() && !history.begins_piece(i))
        look_at_passages(history.time_of(i - 1), time, before, places);
      before = std::move(places);
    }
    // Of recorded loads the largest of what is convex in them stands at an instant.
    if (history.is_recorded()) return;
    for (const auto& [key, at] : highest) refine(key, at.second);
  }

 private:
  /// The use of each patch at an instant; the worst is kept.
  std::map<PatchKey, double> look_at(Time time, const BeamLoads& loads,
                                     const CutForceDiagram& diagram) {
    std::map<PatchKey, double> uses;
    for (const Patch& patch : search_->patches_of(loads)) {
      note_on_path(patch);
      std::optional<Borne> borne = search_->worst_of(patch, diagram);
      if (!borne) continue;
      const double load_factor = run_->situation->load_factor;
      const double use =
          project_->strength.required * load_factor / search_->factor_of(borne->basis);
      double& most = uses[patch.key()];
      most = std::max(most, use);
      WorstPatch& worst = (*worst_)[patch.key()];
      if (worst.run != nullptr && use <= worst.use) continue;
      borne->basis.load_factor = load_factor;
      worst = {patch, std::move(*borne), run_, time, use};
    }
    return uses;
  }

  void note_on_path(const Patch& patch) {
    if (!search_->bears_on_path(patch)) return;
    const Force size = run_->situation->load_factor * abs(patch.force);
    PathForce& most = (*on_paths_)[patch.name];
    if (!(size > most.size)) return;
    most = {patch.s, size, search_->comes_into_path(patch) || most.open};
  }

  std::map<PatchKey, double> look_at(Time time) {
    const BeamLoads loads = run_->loads.loads_at(time);
    return look_at(time, loads, cut_forces_of(loads));
  }

  static std::vector<Length> places_in(const BeamLoads& loads) {
    std::vector<Length> places;
    for (const PointLoad& load : loads.points) places.push_back(load.s);
    return places;
  }

  /// Both sides of every passage of a load over a place where what bears it changes.
  void look_at_passages(Time from, Time to, const std::vector<Length>& before,
                        const std::vector<Length>& behind) {
    if (before.size() != behind.size()) return;
    for (std::size_t k = 0; k < before.size(); ++k) {
      const auto [low, high] = std::minmax(before[k], behind[k]);
      for (const Length& border : borders()) {
        if (!(border > low && border < high)) continue;
        Time lower = from, upper = to;
        constexpr int halvings = 40;
        for (int i = 0; i < halvings; ++i) {
          const Time middle = 0.5 * (lower + upper);
          const BeamLoads loads = run_->loads.loads_at(middle);
          if (loads.points.size() != before.size()) return;
          ((loads.points[k].s < border) == (before[k] < border) ? lower : upper) = middle;
        }
        // Beside the place itself, where a diaphragm takes the load.
        const Time aside = 1e-4 * (to - from);
        look_at(std::max(from, Time(lower - aside)));
        look_at(std::min(to, Time(upper + aside)));
      }
    }
  }

  std::vector<Length> borders() const {
    std::vector<Length> places;
    for (const Diaphragm& of : project_->beam.diaphragms) places.push_back(of.s);
    for (const Segment& of : project_->beam.segments) places.push_back(of.end());
    for (const LoadIntroduction& of : project_->beam.introductions) {
      places.push_back(of.from);
      places.push_back(of.to);
    }
    return places;
  }

  /// The maximum between the instants beside one.
  void refine(const PatchKey& key, std::size_t i) {
    const LoadHistory& history = run_->loads;
    const std::size_t last = history.instants() - 1;
    const Time at = history.time_of(i);
    const Time low = i > 0 && !history.begins_piece(i) ? history.time_of(i - 1) : at;
    const Time high = i < last && !history.begins_piece(i + 1) ? history.time_of(i + 1) : at;
    if (!(high > low)) return;
    constexpr int bits = 14;
    find_maximum(
        [&](double time) {
          const std::map<PatchKey, double> uses = look_at(si<Time>(time));
          const auto found = uses.find(key);
          return found == uses.end() ? 0.0 : found->second;
        },
        low.value(), high.value(), bits);
  }

  const Project* project_;
  PatchSearch* search_;
  const SituationRun* run_;
  std::map<PatchKey, WorstPatch>* worst_;
  std::map<std::string, PathForce>* on_paths_;
};

std::string plate_text(const Project& project, const Borne& borne) {
  const FourWalls& walls = borne.basis.box->box();
  const BoxWall &left = walls.of(BoxPlate::left_web), &right = walls.of(BoxPlate::right_web);
  const bool alike =
      left.thickness == right.thickness && left.yield_strength == right.yield_strength;
  return project.in_space || !alike ? to_text(borne.plate) : "web";
}

CheckResult check_of(const Project& project, const PatchSearch& search, WorstPatch worst) {
  CheckResult result;
  Check& check = result.check;
  const PatchBasis& basis = worst.borne.basis;
  const bool by_column = std::holds_alternative<BearingStiffener>(basis.bears);
  const bool reduced = std::holds_alternative<ReducedWeb>(basis.bears);
  check.criterion = reduced ? Criterion::reduced_stress : Criterion::patch_loading;
  check.station = {worst.patch.s, Side::both};
  check.point = fmt::format("{}{} under {}", plate_text(project, worst.borne),
                            by_column ? " with diaphragm" : "", worst.patch.name);
  check.id = id_of(check.criterion, check.station, check.point);
  check.situation = worst.run->situation->name;
  check.time = worst.time;
  check.required = project.strength.required;
  check.safety_factor = check.required / worst.use;
  const double eta_2 = basis.share * basis.force / basis.resistance;
  const double use = basis.load_factor / search.factor_of(basis);
  // By the force alone, or with the beam's own stress.
  if (reduced) {
    const auto& web = std::get<ReducedWeb>(basis.bears);
    check.resisting = Stress(web.plate->panel.yield_strength / project.strength.gamma_M1);
    check.acting = Stress(use * check.resisting.value() * pascal);
    check.source = "EN 1993-1-5:2006, clause 10, equation 10.5, with 6.4 and annex B";
  } else if (use <= (1.0 + 1e-12) * basis.load_factor * eta_2) {
    check.resisting = basis.resistance;
    check.acting = Force(basis.load_factor * basis.share * basis.force);
    check.source = by_column ? "EN 1993-1-5:2006, 9.4 (stiffener as a column)"
                             : "EN 1993-1-5:2006, 6.6, equation 6.14";
  } else {
    check.resisting = 1.0;
    check.acting = use;
    check.source = "EN 1993-1-5:2006, 7.2, equation 7.2";
  }
  result.patch = std::move(worst.borne.basis);
  return result;
}

Gate gate_of(const Project& project, const WorstPatch& worst) {
  const PatchBasis& basis = worst.borne.basis;
  const std::size_t segment = segment_at(project.beam, {worst.patch.s, Side::both});
  return {project.beam.segments[segment].name, plate_text(project, worst.borne),
          fmt::format(
              "at s = {:.4g} m it takes {:.4g} kN of \"{}\" and bears {:.4g} kN under an edge "
              "(stiff length 0, EN 1993-1-5, clause 6): [[beam.diaphragms]] take it, or "
              "[[beam.load_introductions]] say how it comes in",
              worst.patch.s.value(), 1e-3 * (basis.load_factor * basis.share * basis.force).value(),
              worst.patch.name, 1e-3 * basis.resistance.value()),
          true};
}

Gate gate_of(const Project& project, const std::string& name, const PathForce& of) {
  const std::size_t segment = segment_at(project.beam, {of.s, Side::both});
  const std::string what =
      fmt::format("at s = {:.4g} m \"{}\", {:.4g} kN, comes into walls of a path that may buckle",
                  of.s.value(), name, 1e-3 * of.size.value());
  return {project.beam.segments[segment].name, "",
          of.open ? what +
                        ": what they bear of it is not judged (EN 1993-1-5, clause 6); "
                        "[[beam.diaphragms]] say what takes it"
                  : what +
                        " where a diaphragm is taken to bear it, which is not judged (EN "
                        "1993-1-5, 9.4)",
          of.open};
}

}  // namespace

PatchChecks check_patches(const Project& project, const std::deque<SituationRun>& runs,
                          const std::vector<BendingZone>& zones) {
  PatchChecks found;
  PatchSearch search(project, zones);
  if (!search.has_something_to_do()) return found;
  std::map<PatchKey, WorstPatch> worst;
  for (const SituationRun& run : runs) search.learn_clamps(run);
  std::map<std::string, PathForce> on_paths;
  for (const SituationRun& run : runs) PatchRun(project, search, run, worst, on_paths).look();
  for (const auto& [name, force] : on_paths) found.gates.push_back(gate_of(project, name, force));
  // A use this small is none, as stress is (`no_stress_at`).
  constexpr double no_use = 1e-6;
  const auto add = [&](CheckResult result) {
    // A force that pushes to and fro comes in by either flange: the worse one stays.
    const auto same =
        std::find_if(found.checks.begin(), found.checks.end(),
                     [&](const CheckResult& of) { return of.check.id == result.check.id; });
    if (same == found.checks.end())
      found.checks.push_back(std::move(result));
    else if (result.check.utilisation() > same->check.utilisation())
      *same = std::move(result);
  };
  for (auto& [key, of] : worst) {
    if (!(of.use > no_use)) continue;
    if (!of.patch.given && of.use > 1.0)
      found.gates.push_back(gate_of(project, of));
    else
      add(check_of(project, search, std::move(of)));
  }
  for (const LoadIntroduction& of : project.beam.introductions) {
    const std::string why = of.stiff_length ? search.obstacle_of(of) : "";
    if (why.empty()) continue;
    found.not_judged.push_back({Criterion::patch_loading,
                                fmt::format("load introduction at {:.4g} m", of.from.value()),
                                why});
  }
  return found;
}

}  // namespace boxbeam
