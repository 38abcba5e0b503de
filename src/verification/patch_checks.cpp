#include "boxbeam/verification/patch_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/distorted_stretch.hpp"
#include "hollow_forces.hpp"
#include "nested_profiles.hpp"
#include "patch_run.hpp"
#include "patched_path.hpp"
#include "pressed_solids.hpp"
#include "pressed_webs.hpp"
#include "section_gate.hpp"
#include "tube_borders.hpp"
#include "turned_runs.hpp"

namespace boxbeam {
namespace {

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
  const std::vector<Diaphragm>& all = project.beam.diaphragms;
  const bool stands = std::any_of(all.begin(), all.end(), [&](const Diaphragm& of) {
    return abs(of.s - worst.patch.s) <= 1e-6 * project.beam.length();
  });
  Gate gate = section_gate_at(
      project, {worst.patch.s, Side::both},
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
          worst.patch.at_high ? "" : ", or [[beam.load_introductions]] say how it comes in"));
  gate.plate = plate_text(project, worst.borne);
  return gate;
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

/// What is taken for granted of diaphragms that bear forces.
void say_of_diaphragms(const std::set<std::string>& sideways, const std::set<std::string>& slotted,
                       PatchChecks& found) {
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
}

/// Loads that the case says more of than can be judged.
void say_of_introductions(const Project& project, PatchSearch& search, bool walls_said,
                          PatchChecks& found) {
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
}

}  // namespace

bool forces_are_looked_at(const Project& project) {
  const PressedPlatesAlong plates(project);
  const std::vector<PressedPlates>& all = plates.of_segments();
  return std::none_of(all.begin(), all.end(), [](const PressedPlates& of) {
    return std::isinf(of.stout_z.hardly.value());
  });
}

/// What comes in and what it does, but for what resists it at every cycle.
class LookedAtPatches {
 public:
  LookedAtPatches(const Project& project, const std::deque<SituationRun>& runs,
                  const std::vector<BendingZone>& zones)
      : project_(&project),
        search_(project, zones),
        pressed_(project, runs, zones, search_),
        holes_(project) {
    std::vector<FlangeStep> steps = flange_steps_of(project);
    for (FlangeStep& of : tube_steps_of(project)) steps.push_back(std::move(of));
    if (!search_.has_something_to_do(runs) && steps.empty()) return;
    // Of long records not all instants are looked at.
    const bool counted = project.fatigue.asked && whole_life_of(runs) == nullptr;
    PressingForces* const pressed = counted ? &pressed_.forces() : nullptr;
    notes_.emplace(project, std::move(steps), counted);
    for (const SituationRun& run : runs)
      PatchRun(project, search_, run, worst_, on_paths_, *notes_, holes_, pressed).look();
  }
  LookedAtPatches(const LookedAtPatches&) = delete;
  LookedAtPatches& operator=(const LookedAtPatches&) = delete;

  void forget_resistance() { pressed_.forget_resistance(); }

  /// `walls_said`: that walls of round tubes are not judged.
  void add_to(PatchChecks& found, bool walls_said);

 private:
  const Project* project_;
  PatchSearch search_;
  PressedWebs pressed_;
  std::optional<PatchNotes> notes_;  ///< nothing where nothing comes in
  PatchedHoles holes_;
  std::map<BorneKey, WorstPatch> worst_;
  OnPaths on_paths_;
};

void LookedAtPatches::add_to(PatchChecks& found, bool walls_said) {
  if (!notes_) return;
  const Project& project = *project_;
  on_paths_.add_to(found, project);
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
  for (const auto& [key, of] : worst_) {
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
      add(check_of(project, search_, of));
  }
  pressed_.add_to(found);
  say_of_diaphragms(sideways, slotted, found);
  found.into_diaphragms = notes_->into_diaphragms();
  for (NotJudged& of : notes_->not_judged()) found.not_judged.push_back(std::move(of));
  for (Gate& of : notes_->gates()) found.gates.push_back(std::move(of));
  for (Gate& of : holes_.gates()) found.gates.push_back(std::move(of));
  say_of_introductions(project, search_, walls_said, found);
}

namespace {

/// What is found in walls and plates that are no webs of boxes or paths. Returns whether walls of
/// round tubes are said not to be judged.
bool check_beside_webs(const Project& project, const std::deque<SituationRun>& runs,
                       const std::vector<BendingZone>& zones, PatchChecks& found) {
  check_hollow_forces(project, runs, found);
  const bool walls_said = !found.gates.empty() || !found.not_judged.empty();
  check_tube_kinks(project, runs, zones, found);
  check_pressed_solids(project, runs, found);
  check_nested_profiles(project, runs, zones, found);
  return walls_said;
}

bool have_same_strength(const Project& some, const Project& other) {
  const auto& [gamma_M0, gamma_M1, gamma_M2, effective_widths, C_my, C_mz, shear_lag, plates,
               required] = some.strength;
  const StrengthDemand& of = other.strength;
  return gamma_M0 == of.gamma_M0 && gamma_M1 == of.gamma_M1 && gamma_M2 == of.gamma_M2 &&
         effective_widths == of.effective_widths && C_my == of.C_my && C_mz == of.C_mz &&
         shear_lag == of.shear_lag && plates == of.plates && required == of.required;
}

/// Whether [fatigue] of one stands where that of the other does, whatever is in it: points of
/// stress look at its details.
bool have_same_places(const FatigueInput& some, const FatigueInput& other) {
  return some.asked == other.asked && some.details.size() == other.details.size() &&
         some.attachments.size() == other.attachments.size();
}

}  // namespace

PatchChecks check_patches(const Project& project, const std::deque<SituationRun>& runs,
                          const std::vector<BendingZone>& zones) {
  PatchChecks found;
  const bool walls_said = check_beside_webs(project, runs, zones, found);
  LookedAtPatches(project, runs, zones).add_to(found, walls_said);
  return found;
}

struct KeptPatches::Looked {
  Looked(const Project& of, std::deque<SituationRun>& runs) : project(of) {
    turn_to(project, runs);
    zones = bending_zones_of(project, runs);
    patches.emplace(project, runs, zones);
  }

  Project project;
  std::vector<BendingZone> zones;
  std::optional<LookedAtPatches> patches;
};

KeptPatches::KeptPatches() = default;
KeptPatches::~KeptPatches() = default;

PatchChecks KeptPatches::of(const Project& project, std::deque<SituationRun>& runs) {
  const bool known = looked_ != nullptr && have_same_strength(looked_->project, project) &&
                     have_same_places(looked_->project.fatigue, project.fatigue);
  if (!known) looked_ = std::make_unique<Looked>(project, runs);
  Project& own = looked_->project;
  own.fatigue = project.fatigue;
  for (std::size_t i = 0; i < own.situations.size(); ++i) {
    own.situations[i].cycles = project.situations[i].cycles;
    own.situations[i].spectrum = project.situations[i].spectrum;
  }
  looked_->patches->forget_resistance();
  turn_to(own, runs);
  PatchChecks found;
  const bool walls_said = check_beside_webs(own, runs, looked_->zones, found);
  looked_->patches->add_to(found, walls_said);
  turn_to(project, runs);
  return found;
}

}  // namespace boxbeam
