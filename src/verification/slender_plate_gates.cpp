#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "counts_in_fatigue.hpp"

namespace boxbeam {

bool counts_in_fatigue(const Project& project, const Situation& situation) {
  const std::size_t index = index_of(project, situation);
  return std::any_of(
      project.situations.begin(), project.situations.end(), [&](const Situation& of) {
        const bool part = &of == &situation || std::find(of.between.begin(), of.between.end(),
                                                         index) != of.between.end();
        return part && of.cycles > 0.0;
      });
}

namespace {

/// What of a plate's area works under the stress that is there, lambda_p reduced by it, as if its
/// yield strength were less. Source: EN 1993-1-5:2006, 4.4(4).
double working_share(const BoxWall& wall, std::optional<Length> length, const PlateStress& stress,
                     double part_of_yield) {
  const double part = std::min(1.0, part_of_yield);
  if (!(part > 0.0)) return 1.0;
  StiffenedPlate plate = stiffened_plate_of(wall, length);
  plate.yield_strength = part * wall.class_strength;
  const double at_low = stress.more_at_high ? stress.psi : 1.0;
  const double at_high = stress.more_at_high ? 1.0 : stress.psi;
  const auto stiffened =
      wall.stiffeners.empty() ? std::nullopt : stiffened_widths(plate, at_low, at_high);
  if (!stiffened) {
    const double rho = panel_effective_width(wall.clear(), wall.thickness, stress.psi,
                                             plate.yield_strength, length)
                           ->rho;
    return 1.0 - (1.0 - rho) / std::max(1.0, 1.0 - stress.psi);
  }
  Area all = wall.clear() * wall.thickness, works;
  for (const WorkingStrip& strip : stiffened->strips)
    works += strip.works * (strip.high - strip.low) * wall.thickness;
  for (std::size_t k = 0; k < wall.stiffeners.size(); ++k) {
    const Area bar = wall.stiffeners[k].depth * wall.stiffeners[k].thickness;
    all += bar;
    works += stiffened->stiffeners[k] * bar;
  }
  return works / all;
}

/// How far a plate that is stressed and sheared breathes, out of its plane with every cycle: 1 is
/// the limit beyond which the fatigue of its edges is not that of its stresses in the plane.
///
///     sqrt((sigma_x/(k_sigma sigma_E))^2 + (1.1 tau/(k_tau sigma_E))^2) <= 1.1,  k_tau = 5.34
///
/// Source: EN 1993-2:2006, 7.4(3) (recalled, not confirmed).
double breathing_of(double width_to_thickness, const PlateStress& stress, Stress shear) {
  const Stress sigma_E = plate_euler_stress(width_to_thickness);
  constexpr double k_tau = 5.34, limit = 1.1;
  return std::hypot(stress.compression / (*internal_buckling_factor(stress.psi) * sigma_E),
                    1.1 * shear / (k_tau * sigma_E)) /
         limit;
}

/// Whether a plate so slender is spared breathing: the border of the standard, for webs and their
/// subpanels, is one of plates that are bent in their plane. What is pressed all over buckles at a
/// sixth of their stress. Source: EN 1993-2:2006, 7.4(2) (recalled, not confirmed).
bool is_spared_breathing(double width_to_thickness, const PlateStress& stress, Stress yield) {
  constexpr double most_of_webs = 120.0, hardly_pressed = 1e-3;
  const bool all_over = stress.psi > 0.0 && stress.compression > hardly_pressed * yield;
  return width_to_thickness <= most_of_webs && !all_over;
}

}  // namespace

void PlateGates::look_at_slender(const std::string& segment, const SlenderPlates& plates,
                                 const AreaSums& sums,
                                 const std::vector<SituationHistory>& histories) {
  const StrengthDemand& strength = project_->strength;
  for (const ShearedPlate& plate : plates.sheared) {
    if (!project_->fatigue.asked) continue;
    const BoxWall& wall = plates.box.box().of(plate.plate);
    const PlateEnds ends(plates.box.box(), plate.plate, sums);
    // Between stiffeners subpanels breathe, each taken for evenly compressed.
    const bool divided = plate.panel.stiffeners.count > 0;
    const double ratio =
        (divided ? plate.panel.stiffeners.widest_subpanel : wall.clear()) / wall.thickness;
    double least = 1.0, most_breathing = 0.0;
    for (const SituationHistory& of : histories) {
      const double factor = strength.required * of.situation->load_factor * strength.gamma_M0;
      const bool repeats = counts_in_fatigue(*project_, *of.situation);
      for (const CutForces& cut : of.history.samples()) {
        PlateStress stress = ends.under(cut);
        least = std::min(least, working_share(wall, plates.box.box().length, stress,
                                              factor * (stress.compression / wall.class_strength)));
        if (!repeats || is_spared_breathing(ratio, stress, wall.class_strength)) continue;
        if (divided) stress.psi = 1.0;
        const Stress shear = plate.force_of(cut) / (wall.clear() * wall.thickness);
        most_breathing = std::max(most_breathing, breathing_of(ratio, stress, shear));
      }
    }
    add_effective_area(segment, plate.name, least);
    add_breathing(segment, plate.name, most_breathing, ratio);
  }
}

void PlateGates::look_at_slender(const std::string& segment, const SlenderPath& path,
                                 const std::vector<SituationHistory>& histories) {
  const StrengthDemand& strength = project_->strength;
  const PathSection& section = path.section.path();
  for (const PathPlate& plate : section.plates) {
    if (!project_->fatigue.asked) break;
    const auto at = [&](double along) {
      const Eigen::Vector2d place = plate.at(along);
      return normal_influence(section.gross, place.x(), place.y());
    };
    const StressInfluence low = at(plate.low), high = at(plate.high);
    const auto sheared = std::find_if(path.sheared.begin(), path.sheared.end(),
                                      [&](const ShearedWall& of) { return of.name == plate.name; });
    const double ratio = plate.clear() / plate.thickness;
    double least = 1.0, most_breathing = 0.0;
    for (const SituationHistory& of : histories) {
      const double factor = strength.required * of.situation->load_factor * strength.gamma_M0;
      const bool repeats = counts_in_fatigue(*project_, *of.situation);
      for (const CutForces& cut : of.history.samples()) {
        const double at_low = -stress_at(low, cut).normal.value();
        const double at_high = -stress_at(high, cut).normal.value();
        const double most = std::max({0.0, at_low, at_high});
        const double part = std::min(1.0, factor * most / plate.class_strength.value());
        if (part > 0.0) {
          const PlateAlone alone =
              plate_alone(plate, part * plate.class_strength, section.length, at_low, at_high);
          least = std::min(least, 1.0 - alone.idle() / plate.clear().value());
        }
        if (!repeats || sheared == path.sheared.end()) continue;
        PlateStress stress{si<Stress>(most), {}};
        if (most > 0.0) stress.psi = std::max(-3.0, std::min(at_low, at_high) / most);
        if (is_spared_breathing(ratio, stress, plate.class_strength)) continue;
        const Stress shear = sheared->force_of(cut) / (plate.clear() * plate.thickness);
        most_breathing = std::max(most_breathing, breathing_of(ratio, stress, shear));
      }
    }
    add_effective_area(segment, plate.name, least);
    add_breathing(segment, plate.name, most_breathing, ratio);
  }
  // A flange of an I has a little of it beside its web, the stem of a T all.
  for (const ShearedWall& wall : path.outstands) {
    double most = 0.0;
    for (const SituationHistory& of : histories) {
      const double factor = strength.required * of.situation->load_factor * strength.gamma_M0;
      for (const CutForces& cut : of.history.samples())
        most = std::max(most, factor * sheared_share(wall, cut));
    }
    if (most <= hardly_sheared) continue;
    add("sheared outstand", {segment, wall.name, sheared_outstand_text(most), true}, most);
  }
}

void PlateGates::add_effective_area(const std::string& segment, const std::string& plate,
                                    double share) {
  constexpr double least_area = 0.5;
  if (share >= least_area) return;
  add("effective area",
      {segment, plate,
       fmt::format("{:.3g} of its area is effective, less than 0.5: the stresses by which "
                   "fatigue is judged are not those of the full section (EN 1993-1-5, 2.2(5))",
                   share),
       true},
      1.0 / share);
}

void PlateGates::add_breathing(const std::string& segment, const std::string& plate,
                               double breathing, double ratio) {
  if (breathing <= 1.0) return;
  add("breathing",
      {segment, plate,
       fmt::format("it breathes out of its plane, {:.3g} times as much as its edges bear in "
                   "fatigue (b/t = {:.3g}, EN 1993-2, 7.4)",
                   breathing, ratio),
       true},
      breathing);
}

}  // namespace boxbeam
