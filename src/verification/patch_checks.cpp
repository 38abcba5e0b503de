#include "boxbeam/verification/patch_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/verification/distorted_stretch.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "hollow_forces.hpp"
#include "nested_profiles.hpp"
#include "patch_notes.hpp"
#include "patch_search.hpp"
#include "patched_holes.hpp"
#include "patched_path.hpp"
#include "pressed_solids.hpp"
#include "tube_borders.hpp"

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
};

/// Looks at one run.
class PatchRun {
 public:
  PatchRun(const Project& project, PatchSearch& search, const SituationRun& run,
           std::map<BorneKey, WorstPatch>& worst, OnPaths& on_paths, PatchNotes& notes,
           PatchedHoles& holes, PressedWebs* pressed)
      : project_(&project),
        search_(&search),
        run_(&run),
        worst_(&worst),
        on_paths_(&on_paths),
        notes_(&notes),
        holes_(&holes),
        pressed_(pressed) {}

  void look() {
    const LoadHistory& history = run_->loads;
    struct Highest {
      double use;
      std::size_t at;
      double lowest;
    };
    std::map<BorneKey, Highest> highest;
    std::vector<Length> before;
    if (pressed_ != nullptr) pressed_->begin(*run_);
    for (std::size_t i = 0; i < history.instants(); ++i) {
      const Time time = history.time_of(i);
      const BeamLoads loads = history.loads_at(time);
      const CutForceDiagram& diagram = history.diagram(i);
      const std::vector<Patch> patches = search_->patches_of(loads, diagram);
      if (pressed_ != nullptr) pressed_->take(time, i > 0 && !history.begins_piece(i), patches);
      note_torque(loads);
      note_places(loads);
      for (const auto& [key, use] : look_at(time, patches, diagram)) {
        Highest& known = highest.try_emplace(key, Highest{use, i, use}).first->second;
        known.lowest = std::min(known.lowest, use);
        if (use > known.use) known = {use, i, known.lowest};
      }
      std::vector<Length> places = places_in(loads);
      if (i > 0 && !history.is_recorded() && !history.begins_piece(i))
        look_at_passages(history.time_of(i - 1), time, before, places);
      before = std::move(places);
    }
    if (pressed_ != nullptr) pressed_->end(history.period());
    // Of recorded loads the largest of what is convex in them stands at an instant.
    if (history.is_recorded()) return;
    // What does not change has its largest anywhere.
    constexpr double constant = 1e-9;
    for (const auto& [key, of] : highest)
      if (of.use - of.lowest > constant * of.use) refine(key, of.at);
  }

 private:
  /// The use of each patch at an instant, or of one alone; the worst is kept.
  std::map<BorneKey, double> look_at(Time time, const std::vector<Patch>& patches,
                                     const CutForceDiagram& diagram,
                                     const BorneKey* only = nullptr) {
    std::map<BorneKey, double> uses;
    notes_->take_instant(diagram, *run_->situation, only == nullptr);
    for (const Patch& patch : patches) {
      if (only != nullptr && BorneKey{patch.key(), only->second} != *only) continue;
      note_on_path(patch);
      std::vector<Borne> ways = search_->worst_of(patch, patches, diagram);
      notes_->take(patch, ways, *run_->situation, only == nullptr);
      for (Borne& borne : ways) {
        const double load_factor = run_->situation->load_factor;
        const double use =
            project_->strength.required * load_factor / search_->factor_of(borne.basis);
        if (borne.part == Borne::Part::plate) holes_->take(patch, borne.basis, load_factor, use);
        const BorneKey key{patch.key(), borne.part};
        double& most = uses[key];
        most = std::max(most, use);
        WorstPatch& worst = (*worst_)[key];
        if (worst.run != nullptr && use <= worst.use) continue;
        borne.basis.load_factor = load_factor;
        worst = {patch, std::move(borne), run_, time, use};
      }
    }
    return uses;
  }

  void note_on_path(const Patch& patch) {
    if (patch.is_none()) return;
    const double load_factor = run_->situation->load_factor;
    const auto of = search_->unjudged_on_path(patch, project_->strength.required * load_factor);
    if (!of) return;
    const Force size = load_factor * abs(patch.force);
    PathForce& most = on_paths_->forces[{patch.name, of->open, of->blocks}];
    if (size > most.size) most = {patch.s, size, of->why, of->said};
  }

  /// All forces along y that come in at a place.
  Force along_y_at(const BeamLoads& loads, Length s) const {
    const Length near = 1e-6 * project_->beam.length();
    Force along_y;
    for (const PointLoad& load : loads.points)
      if (abs(load.s - s) <= near) along_y += si<Force>(load.force.y());
    return along_y;
  }

  /// Of what holds slender webs, and of moments that come in between the ends.
  void note_places(const BeamLoads& loads) {
    for (const double s : run_->motion->supports(loads)) {
      const Length at = si<Length>(s);
      if (search_->lacks_diaphragm(at)) notes_->take_bare_support(at, true);
      if (search_->lacks_diaphragm_along_y(at, along_y_at(loads, at)))
        notes_->take_bare_support(at, false);
    }
    for (const PointLoad& load : loads.points) {
      const auto moment = search_->unjudged_moment_of(load);
      if (!moment) continue;
      const std::string name = load.name.empty() ? "a couple" : std::string(load.name);
      const Moment size = run_->situation->load_factor * *moment;
      if (search_->is_at_end(load.s))
        notes_->take_led_on(name, load.s, size);
      else
        notes_->take_couple(name, load.s, size);
    }
  }

  void note_torque(const BeamLoads& loads) {
    const PatchSearch::PathTorque of = search_->torque_into_path(loads);
    if (of.torque.value() > least_torque(*run_) && of.torque > on_paths_->torque.torque)
      on_paths_->torque = of;
  }

  std::map<BorneKey, double> look_at(Time time, const BorneKey* only = nullptr) {
    const BeamLoads loads = run_->loads.loads_at(time);
    const CutForceDiagram diagram = cut_forces_of(loads);
    note_torque(loads);
    return look_at(time, search_->patches_of(loads, diagram), diagram, only);
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
        // What stands on it is looked at beside it, too, as near as is another place.
        if (low < high && (border == low || border == high)) {
          const double beside =
              std::min(1e-2, (1e-4 * project_->beam.length() / (high - low)).value());
          if (border == before[k]) look_at(from + beside * (to - from));
          if (border == behind[k]) look_at(to - beside * (to - from));
        }
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
  void refine(const BorneKey& key, std::size_t i) {
    const LoadHistory& history = run_->loads;
    const std::size_t last = history.instants() - 1;
    const Time at = history.time_of(i);
    const Time low = i > 0 && !history.begins_piece(i) ? history.time_of(i - 1) : at;
    const Time high = i < last && !history.begins_piece(i + 1) ? history.time_of(i + 1) : at;
    if (!(high > low)) return;
    constexpr int bits = 14;
    find_maximum(
        [&](double time) {
          const std::map<BorneKey, double> uses = look_at(si<Time>(time), &key);
          const auto found = uses.find(key);
          return found == uses.end() ? 0.0 : found->second;
        },
        low.value(), high.value(), bits);
  }

  const Project* project_;
  PatchSearch* search_;
  const SituationRun* run_;
  std::map<BorneKey, WorstPatch>* worst_;
  OnPaths* on_paths_;
  PatchNotes* notes_;
  PatchedHoles* holes_;
  PressedWebs* pressed_;  ///< nothing where no cycles are counted
};

std::string plate_text(const Project& project, const Borne& borne) {
  if (!borne.wall.empty()) return borne.wall;
  const FourWalls& walls = borne.basis.box->box();
  const BoxWall &left = walls.of(BoxPlate::left_web), &right = walls.of(BoxPlate::right_web);
  const bool alike =
      left.thickness == right.thickness && left.yield_strength == right.yield_strength;
  return project.in_space || !alike || is_flange(borne.plate) ? to_text(borne.plate) : "web";
}

/// What bears a patch, in words.
std::string borne_text(const Project& project, const Borne& borne) {
  const std::string plate = plate_text(project, borne);
  if (const auto* const seam = std::get_if<PatchedSeam>(&borne.basis.bears))
    return fmt::format("seam of {} and {}", plate, to_text(seam->flange));
  if (const auto* const weld = std::get_if<StiffenerWeld>(&borne.basis.bears)) {
    return weld->to_flange ? fmt::format("weld of flange and diaphragm beside {}", plate)
                           : fmt::format("weld of {} and diaphragm", plate);
  }
  return plate +
         (std::holds_alternative<BearingStiffener>(borne.basis.bears) ? " with diaphragm" : "");
}

/// Whether stout plates feel so little of what comes in that the checks of their section are worse:
/// with eta_2 <= 0.6 eta_1 (7.2).
bool is_hardly_felt(const Project& project, const WorstPatch& worst) {
  constexpr double little = 0.3;
  if (!worst.patch.stout) return false;
  const PatchBasis& basis = worst.borne.basis;
  if (worst.borne.part != Borne::Part::plate) return worst.use <= little;
  return project.strength.required * basis.load_factor * basis.share * basis.force <=
         little * basis.resistance;
}

Criterion criterion_of(const PatchBasis& basis) {
  if (std::holds_alternative<PatchedSeam>(basis.bears) ||
      std::holds_alternative<StiffenerWeld>(basis.bears))
    return Criterion::weld;
  return std::holds_alternative<ReducedWeb>(basis.bears) ? Criterion::reduced_stress
                                                         : Criterion::patch_loading;
}

CheckResult check_of(const Project& project, const PatchSearch& search, WorstPatch worst) {
  CheckResult result;
  Check& check = result.check;
  const PatchBasis& basis = worst.borne.basis;
  const bool by_column = std::holds_alternative<BearingStiffener>(basis.bears);
  check.criterion = criterion_of(basis);
  check.station = {worst.patch.s, Side::both};
  check.point = fmt::format("{} under {}", borne_text(project, worst.borne), worst.patch.name);
  check.id = id_of(check.criterion, check.station, check.point);
  check.situation = worst.run->situation->name;
  check.time = worst.time;
  check.required = project.strength.required;
  check.safety_factor = check.required / worst.use;
  const double eta_2 = basis.share * basis.force / basis.resistance;
  const double use = basis.load_factor / search.factor_of(basis);
  // By the force alone, or with the beam's own stress.
  if (const auto* const seam = std::get_if<PatchedSeam>(&basis.bears)) {
    constexpr NoDerivation plainly;
    check.resisting = weld_strength(plainly, seam->strength);
    check.acting = si<Stress>(use * check.resisting.value());
    check.source =
        "EN 1993-1-8:2005, 4.5.3.2(6), equation 4.1; loaded length EN 1993-1-5:2006, 6.3";
    // Both stresses in it go by one over the throat.
    result.sufficient_throat =
        std::max(least_throat(), check.utilisation() * seam_throat_of(*seam->point));
  } else if (const auto* const weld = std::get_if<StiffenerWeld>(&basis.bears)) {
    check.resisting = basis.resistance;
    check.acting = Force(basis.load_factor * basis.share * basis.force);
    check.source = "EN 1993-1-8:2005, 4.5.3.2(6), equation 4.1";
    result.sufficient_throat = sufficient_throat_of(
        *weld, project.strength.required * basis.load_factor * basis.share * basis.force);
  } else if (const auto* const web = std::get_if<ReducedWeb>(&basis.bears)) {
    check.resisting = Stress(web->plate->panel.yield_strength / project.strength.gamma_M1);
    check.acting = Stress(use * check.resisting.value() * pascal);
    check.source = "EN 1993-1-5:2006, clause 10, equation 10.5, with 6.4 and annex B";
  } else if (basis.pulls && use > (1.0 + 1e-12) * basis.load_factor * eta_2) {
    const PullingPanel& of = *basis.pulls;
    check.resisting =
        Force(basis.resistance + buckling_shear_of(of.panel, project.strength.gamma_M1));
    check.acting = Force(basis.load_factor * (basis.share * basis.force + of.shear));
    check.source = "EN 1993-1-5:2006, 9.3.3(3), 9.4 (stiffener of panels as a column)";
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
  const std::vector<Diaphragm>& all = project.beam.diaphragms;
  const bool stands = std::any_of(all.begin(), all.end(), [&](const Diaphragm& of) {
    return abs(of.s - worst.patch.s) <= 1e-6 * project.beam.length();
  });
  return {project.beam.segments[segment].name, plate_text(project, worst.borne),
          fmt::format(
              "at s = {} m it takes {:.4g} kN of \"{}\" and {} {:.4g} kN under an edge "
              "(stiff length 0, EN 1993-1-5, clause 6): {} take it{}",
              to_text(Station{worst.patch.s, Side::both}),
              1e-3 * (basis.load_factor * basis.share * basis.force).value(), worst.patch.name,
              worst.borne.part == Borne::Part::plate ? "bears" : "its seam bears",
              1e-3 * basis.resistance.value(),
              stands ? "thicker [[beam.diaphragms]], for the one there is not rigid (EN 1993-1-5, "
                       "9.3.3(3)) or twists (9.2.1(8)),"
                     : "[[beam.diaphragms]]",
              worst.patch.at_high ? "" : ", or [[beam.load_introductions]] say how it comes in"),
          true};
}

Gate gate_of(const Project& project, const PressedWebs::Found& pressed) {
  const Check& check = pressed.result.check;
  const std::size_t segment = segment_at(project.beam, check.station);
  return {project.beam.segments[segment].name, "",
          fmt::format("{} at s = {} m is used by {:.3g} in fatigue (stiff length 0): "
                      "[[beam.diaphragms]] take it{}",
                      check.point, to_text(check.station), check.utilisation(),
                      pressed.turned ? "" : ", or [[beam.load_introductions]] say how it comes in"),
          true};
}

Gate gate_of(const Project& project, const std::string& name, bool open, bool blocks,
             const PathForce& of) {
  const std::size_t segment = segment_at(project.beam, {of.s, Side::both});
  const std::string what =
      fmt::format("at s = {} m \"{}\", {:.4g} kN, comes into walls of a path",
                  to_text(Station{of.s, Side::both}), name, 1e-3 * of.size.value());
  return {project.beam.segments[segment].name, "",
          open ? what + ": what they bear of it is not judged (EN 1993-1-5, clause 6): " + of.why +
                     "; [[beam.diaphragms]] say what takes it"
               : what +
                     " where a diaphragm is taken to bear it, which is not judged (EN 1993-1-5, "
                     "9.4): " +
                     of.why,
          blocks};
}

/// Whether flats lie along a plate of the section of a station.
bool has_flats(const Project& project, Length s) {
  const Section section = section_at(project.beam, {s, Side::both});
  const auto* const box = std::get_if<Box>(&section.outer);
  return box != nullptr && !box->stiffeners.empty();
}

void note_unsaid(const Project& project, const WorstPatch& worst,
                 std::optional<UnsaidWelds>& most) {
  const PatchBasis& basis = worst.borne.basis;
  const auto throat = sufficient_throat_of(
      std::get<StiffenerWeld>(basis.bears),
      project.strength.required * basis.load_factor * basis.share * basis.force);
  if (!most || (most->throat && (!throat || *throat > *most->throat)))
    most = UnsaidWelds{worst.patch.s, worst.patch.name, throat};
}

void add_gates(const Project& project, const OnPaths& of, PatchChecks& found) {
  std::vector<Gate>& gates = found.gates;
  const std::pair<const std::tuple<std::string, bool, bool>, PathForce>* said = nullptr;
  for (const auto& named : of.forces) {
    const auto& [name, open, blocks] = named.first;
    if (blocks || !named.second.said)
      gates.push_back(gate_of(project, name, open, blocks, named.second));
    else if (said == nullptr || named.second.size > said->second.size)
      said = &named;
  }
  // Of those of the verdict line the largest one: it is to be read.
  if (said != nullptr) {
    const PathForce& force = said->second;
    found.not_judged.push_back(
        {Criterion::patch_loading,
         fmt::format("walls of a path at s = {} m", to_text(Station{force.s, Side::both})),
         fmt::format("how its diaphragm leads \"{}\", {:.4g} kN, into them is not checked{}: {}",
                     std::get<0>(said->first), 1e-3 * force.size.value(),
                     project.fatigue.asked ? ", nor in fatigue" : "", force.why)});
  }
  if (of.torque.torque > Moment{}) {
    const std::size_t segment = segment_at(project.beam, {of.torque.s, Side::both});
    gates.push_back(
        {project.beam.segments[segment].name, "",
         fmt::format("at s = {} m a torque of {:.4g} kN m comes into a path around "
                     "cells: how it distorts it is not judged; [[beam.diaphragms]] say "
                     "what keeps it in shape, or write it as kind = \"box\"",
                     to_text(Station{of.torque.s, Side::both}), 1e-3 * of.torque.torque.value()),
         true});
  }
}

Gate gate_of_square(const Project& project, const std::pair<Check, double>& of) {
  const auto& [check, use] = of;
  return {project.beam.segments[segment_at(project.beam, check.station)].name, "",
          fmt::format("{} at s = {} m: with what presses there square to it at every cycle used by "
                      "up to {:.3g} in fatigue, which is not judged together",
                      check.point, to_text(check.station), use),
          true};
}

}  // namespace

bool forces_are_looked_at(const Project& project) {
  const PressedPlatesAlong plates(project);
  const std::vector<PressedPlates>& all = plates.of_segments();
  return std::none_of(all.begin(), all.end(), [](const PressedPlates& of) {
    return std::isinf(of.stout_z.hardly.value());
  });
}

PatchChecks check_patches(const Project& project, const std::deque<SituationRun>& runs,
                          const std::vector<BendingZone>& zones) {
  PatchChecks found;
  check_hollow_forces(project, runs, found);
  const bool walls_said = !found.gates.empty() || !found.not_judged.empty();
  check_tube_kinks(project, runs, zones, found);
  check_pressed_solids(project, runs, found);
  check_nested_profiles(project, runs, zones, found);
  PatchSearch search(project, zones);
  std::vector<FlangeStep> steps = flange_steps_of(project);
  for (FlangeStep& of : tube_steps_of(project)) steps.push_back(std::move(of));
  if (!search.has_something_to_do(runs) && steps.empty()) return found;
  std::map<BorneKey, WorstPatch> worst;
  OnPaths on_paths;
  PressedWebs pressed(project, runs, zones, search);
  // Of long records not all instants are looked at.
  const bool counted = project.fatigue.asked && whole_life_of(runs) == nullptr;
  PatchNotes notes(project, std::move(steps), counted ? &pressed : nullptr);
  PatchedHoles holes(project);
  for (const SituationRun& run : runs)
    PatchRun(project, search, run, worst, on_paths, notes, holes, counted ? &pressed : nullptr)
        .look();
  add_gates(project, on_paths, found);
  // A use this small is none, as stress is (`no_stress_at`).
  constexpr double no_use = 1e-6;
  std::set<std::string> sideways, slotted;
  std::map<std::string, std::size_t> known;
  const auto add = [&](CheckResult result) {
    // A force that pushes to and fro comes in by either flange: the worse one stays.
    const auto [same, is_new] = known.try_emplace(result.check.id, found.checks.size());
    if (is_new)
      found.checks.push_back(std::move(result));
    else if (CheckResult& other = found.checks[same->second];
             result.check.utilisation() > other.check.utilisation())
      other = std::move(result);
  };
  for (NotJudged& of : not_judged_of_diaphragms(project)) found.not_judged.push_back(std::move(of));
  for (auto& [key, of] : worst) {
    if (!(of.use > no_use) || is_hardly_felt(project, of)) continue;
    if (of.borne.part == Borne::Part::unsaid_weld) {
      note_unsaid(project, of, found.unsaid_welds);
      continue;
    }
    const auto* const bears = std::get_if<BearingStiffener>(&of.borne.basis.bears);
    // What comes from panels alone asks nothing of the flanges.
    if (bears != nullptr && !bears->ends_clamped && !of.patch.is_none())
      sideways.insert(to_text({of.patch.s, Side::both}));
    if (of.patch.diaphragm != nullptr && !of.patch.is_none() && has_flats(project, of.patch.s))
      slotted.insert(to_text({of.patch.s, Side::both}));
    if (!of.patch.given && of.use > 1.0)
      found.gates.push_back(gate_of(project, of));
    else
      add(check_of(project, search, std::move(of)));
  }
  std::optional<Check> as_fillets;
  std::optional<PressedWebs::Found> turned;  ///< of kinks that fail the worst: all ask for the same
  PressedWebs::Checks again = pressed.checks();
  for (PressedWebs::Found& of : again.found) {
    if (of.unsaid) {
      const double use = of.result.check.utilisation();
      if (use > 1.0 && (!as_fillets || use > as_fillets->utilisation()))
        as_fillets = of.result.check;
      continue;
    }
    if (of.turned && !of.result.check.passes()) {
      const double use = of.result.check.utilisation();
      if (!turned || use > turned->result.check.utilisation()) turned = std::move(of);
      continue;
    }
    if (!of.given && !of.result.check.passes())
      found.gates.push_back(gate_of(project, of));
    else
      found.checks.push_back(std::move(of.result));
  }
  if (turned) found.gates.push_back(gate_of(project, *turned));
  if (again.square) found.gates.push_back(gate_of_square(project, *again.square));
  if (as_fillets)
    found.not_judged.push_back(
        {Criterion::patch_fatigue, "seams of webs",
         fmt::format(
             "taken to penetrate fully, for seam_throat is not said; as fillets, a = t, used "
             "by {:.3g} in fatigue at s = {} m",
             as_fillets->utilisation(), to_text(as_fillets->station))});
  if (!sideways.empty())
    found.not_judged.push_back(
        {Criterion::patch_loading, fmt::format("flats at s = {} m", fmt::join(sideways, ", ")),
         "L_cr = h_w takes it that both flanges are held sideways there, which no "
         "[[beam.restraints]] say (EN 1993-1-5, 9.4(2))"});
  if (!slotted.empty())
    found.not_judged.push_back(
        {Criterion::weld, fmt::format("diaphragms at s = {} m", fmt::join(slotted, ", ")),
         "slots that let flats through are not taken off their welds and edges"});
  if (found.unsaid_welds && !found.unsaid_welds->throat) {
    found.not_judged.push_back({Criterion::weld,
                                fmt::format("welds of the diaphragm at s = {} m",
                                            to_text(Station{found.unsaid_welds->s, Side::both})),
                                fmt::format("no fillet welds on its faces bear all of \"{}\"",
                                            found.unsaid_welds->under)});
  }
  found.into_diaphragms = notes.into_diaphragms();
  for (NotJudged& of : notes.not_judged()) found.not_judged.push_back(std::move(of));
  for (Gate& of : notes.gates()) found.gates.push_back(std::move(of));
  for (Gate& of : holes.gates()) found.gates.push_back(std::move(of));
  for (const LoadIntroduction& of : project.beam.introductions) {
    // What comes into walls of round tubes is said by its force.
    if (walls_said &&
        std::holds_alternative<RoundTube>(section_at(project.beam, {of.from, Side::both}).outer))
      continue;
    const std::string why = of.stiff_length ? search.obstacle_of(of) : "";
    if (why.empty()) continue;
    found.not_judged.push_back({Criterion::patch_loading,
                                fmt::format("load introduction at {:.4g} m", of.from.value()),
                                why});
  }
  return found;
}

}  // namespace boxbeam
