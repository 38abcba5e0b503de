#include "boxbeam/verification/gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/strength/plate_slenderness.hpp"
#include "boxbeam/strength/section_class.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "stressed_webs.hpp"

namespace boxbeam {
namespace {

std::string class_4_text(double ratio, double limit, const std::string& effective) {
  return fmt::format(
      "c/t = {:.3g} is above {:.3g}, class 4 (EN 1993-1-1, table 5.2): it may buckle "
      "before it yields, and the stress of the full section is not valid{}",
      ratio, limit, effective);
}

}  // namespace

PlateGates::PlateGates(const Project& project, const std::vector<BendingZone>& zones,
                       const ModelChoice& model)
    : project_(&project), zones_(&zones) {
  const SecondOrderEstimate& of = model.second_order;
  member_buckles_ =
      of.in_plane.part > no_buckling_below || (of.across && of.across->part > no_buckling_below);
}

void PlateGates::add(const std::string& kind, Gate gate, double excess) {
  const std::string key = kind + "/" + gate.segment + "/" + gate.plate;
  const auto found = worst_.find(key);
  if (found != worst_.end() && found->second.second >= excess) return;
  if (found == worst_.end()) order_.push_back(key);
  worst_[key] = {std::move(gate), excess};
}

std::vector<Gate> PlateGates::gates() const {
  std::vector<Gate> gates;
  for (const std::string& key : order_) gates.push_back(worst_.at(key).first);
  return gates;
}

void PlateGates::look_at_class(const std::string& segment, const Profile& profile,
                               const PlateMaterials& materials, bool alike, const AreaSums& sums,
                               const std::vector<SituationHistory>& histories,
                               const std::string& obstacle, bool judged) {
  const Project& project = *project_;
  const std::vector<StressedWeb> webs = stressed_webs_of(profile, project.in_space, alike);
  const std::string why_not = obstacle.empty() ? "" : "; its buckling is not judged: " + obstacle;
  for (const SlenderPlate& plate : slender_plates_of(profile, materials)) {
    if (!judged) {
      add("class", {segment, plate.plate, class_4_text(plate.ratio, plate.limit, why_not), true},
          plate.ratio / plate.limit);
    }
  }
  for (const StressedWeb& web : webs) {
    const auto yield = yield_strength_of(materials.of(web.kind), web.thickness);
    if (!yield) continue;
    const Class3Limit class_3(project.strength,
                              *class_yield_of(profile, materials, web.kind, web.thickness),
                              member_buckles_);
    const auto at = [&](const SectionPlace& end) {
      return normal_influence(sums, end.y.value(), end.z.value());
    };
    const double ratio = web.depth() / web.thickness;
    // A flange counts as evenly compressed, on the safe side, see slender_plates_of.
    const WorstStress worst = web.flange ? WorstStress{}
                                         : worst_over(histories, at(web.low), at(web.high),
                                                      project.strength.required, class_3);
    const auto effective =
        worst.limit > 0.0 ? internal_effective_width(web.depth(), web.thickness,
                                                     std::max(-3.0, worst.psi), class_3.epsilon())
                          : std::nullopt;
    if (worst.limit > 0.0 && ratio > worst.limit && !judged) {
      const std::string stress = fmt::format(
          "; under {:.3g} MPa, psi = {:.2f}{}", worst.most * 1e-6, worst.psi,
          member_buckles_ ? "; the member is verified for buckling (5.5.2(10))" : " (5.5.2(9))");
      const std::string widths =
          effective ? fmt::format(
                          ", rho = {:.3g} of its compressed width is effective at yield "
                          "(EN 1993-1-5, 4.4)",
                          effective->rho)
                    : "";
      add("class",
          {segment, web.name,
           class_4_text(ratio, worst.limit, fmt::format("{}{}{}", stress, widths, why_not)), true},
          ratio / worst.limit);
    }
    const ShearBucklingNeed need =
        shear_buckling_need(web.depth(), web.thickness, *yield, shear_hardening_factor(*yield));
    if (need.check_needed() && !judged) {
      add("shear buckling",
          {segment, web.name,
           fmt::format("h_w/t_w = {:.3g} is above 72 eps/eta = {:.3g}: the {} may buckle in "
                       "shear, and its resistance is that of EN 1993-1-5, clause 5 (5.1(2)){}",
                       need.ratio, need.limit, web.flange ? "flange" : "web", why_not),
           true},
          need.ratio / need.limit);
    }
  }
}

/// Says the worst of a segment, not its station, so that segments of which the same is true stand
/// together.
void PlateGates::look_at_shear_lag(const std::string& segment, const std::string& plate,
                                   const std::optional<ShearLag>& lag) {
  if (!lag) return;
  add("shear lag",
      {segment, plate,
       fmt::format("b_0 = {:.4g} mm is above L_e/50, L_e = {:.3g} m between zero moments: "
                   "shear lag counts; with kappa = {:.3g} a part of the width works, beta = "
                   "{:.3g} of it at the worst station, and the normal stresses are those of "
                   "the section so reduced (EN 1993-1-5, 3.1 and 3.2.1)",
                   lag->b_0.value() * 1e3, lag->effective_length.value(), lag->kappa, lag->beta),
       false},
      -lag->beta);
}

/// Of a path the flanges are any plates that lie along the axis of bending, within 45 degrees. Its
/// effective section counts shear lag, the stresses of the whole one do not.
void PlateGates::look_at_path_lag(const std::string& segment, const Station& station,
                                  const PathSection& section, bool counts) {
  for (const PathPlate& plate : section.plates) {
    const bool along_y = std::abs(plate.direction.x()) > std::abs(plate.direction.y());
    const auto lag = plate_lag_at(*zones_, station, along_y ? BendingAxis::y : BendingAxis::z,
                                  lagging_width_of(section, plate), plate.thickness);
    if (!lag) continue;
    const bool blocks = !counts || project_->fatigue.asked;
    add("shear lag",
        {segment, plate.name,
         fmt::format("b_0 = {:.4g} mm is above L_e/50, L_e = {:.3g} m between zero moments: shear "
                     "lag counts; with kappa = {:.3g} a part of the width works, {}{}",
                     lag->b_0.value() * 1e3, lag->effective_length.value(), lag->kappa,
                     counts ? fmt::format("beta^kappa = {:.3g} of it in the effective section at "
                                          "the worst station (EN 1993-1-5, 3.3)",
                                          ultimate_share_of(*lag))
                            : fmt::format("beta = {:.3g} (EN 1993-1-5, 3.2), which the stresses of "
                                          "walls that are not slender do not count",
                                          lag->beta),
                     counts && blocks
                         ? fmt::format("; the stresses by which fatigue is judged are those of "
                                       "the whole section, without beta = {:.3g} (3.2)",
                                       lag->beta)
                         : std::string()),
         blocks},
        -lag->beta);
  }
}

void PlateGates::look_at(const std::vector<CheckResult>& checks) {
  for (const CheckResult& result : checks) {
    const Check& check = result.check;
    if (check.criterion != Criterion::yield || check.safety_factor >= 1.0) continue;
    add("yield",
        {"", "",
         fmt::format("at s = {} m, {} the stress is above the yield strength: there the beam "
                     "is not elastic, and its fatigue factors mean nothing",
                     to_text(check.station), check.point),
         true},
        1.0 / check.safety_factor);
  }
}

double class_3_use_at(const Project& project, const Station& station,
                      const std::vector<SituationHistory>& histories) {
  const Section section = judged_section_at(project, station);
  const bool alike =
      webs_are_alike(section, materials_of(project, segment_at(project.beam, station)));
  std::optional<AreaSums> sums;
  double largest = 0.0;
  const std::size_t segment = segment_at(project.beam, station);
  const PlateMaterials outer = materials_of(project, segment);
  const PlateMaterials inner(outer.of(PlateKind::inner));
  const auto look_at = [&](const Profile& profile, const PlateMaterials& materials) {
    for (const StressedWeb& web : stressed_webs_of(profile, project.in_space, alike)) {
      const auto yield = class_yield_of(profile, materials, web.kind, web.thickness);
      if (web.flange || !yield) continue;
      const double ratio = web.depth() / web.thickness;
      if (ratio <= internal_part_limits(1.0, 1.0, epsilon_of(*yield)).class_3) continue;
      if (!sums) sums = sums_of(outline_of(section, {}));
      const auto at = [&](const SectionPlace& end) {
        return normal_influence(*sums, end.y.value(), end.z.value());
      };
      const WorstStress worst =
          worst_over(histories, at(web.low), at(web.high), project.strength.required,
                     Class3Limit(project.strength, *yield, false));
      if (worst.limit > 0.0) largest = std::max(largest, ratio / worst.limit);
    }
  };
  look_at(section.outer, outer);
  if (section.inner) look_at(*section.inner, inner);
  return largest;
}

void PlateGates::look_at(const Station& station, const std::vector<SituationHistory>& histories) {
  const Section section = judged_section_at(*project_, station);
  const TaperedBeam& beam = project_->beam;
  const std::size_t index = segment_at(beam, station);
  const std::string& segment = beam.segments[index].name;
  const PlateMaterials materials = materials_of(*project_, index);
  const AreaSums sums = sums_of(outline_of(section, {}));
  const bool alike = webs_are_alike(section, materials);
  const std::string obstacle = plates_obstacle(*project_, station);
  const auto judged = slender_plates_at(*project_, *zones_, station);
  const auto path = slender_path_at(*project_, *zones_, station);
  look_at_class(segment, section.outer, materials, alike, sums, histories, obstacle,
                judged != nullptr || path != nullptr);
  if (section.inner) {
    look_at_class(segment, *section.inner, materials.of(PlateKind::inner), alike, sums, histories,
                  obstacle, false);
  }
  if (judged != nullptr) look_at_slender(segment, *judged, sums, histories);
  if (path != nullptr) {
    look_at_slender(segment, *path, histories);
    look_at_path_lag(segment, station, path->section.path(), true);
  } else if (const auto stout = judged_path_at(*project_, *zones_, station)) {
    look_at_path_lag(segment, station, *stout, false);
  }
  for (const BoxPlate plate : {BoxPlate::top_flange, BoxPlate::bottom_flange}) {
    // Webs are looked at without their stiffeners above, under the stress that is there.
    if (judged != nullptr || !may_buckle_with_stiffeners(*project_, station, plate)) continue;
    add("stiffened",
        {segment, to_text(plate),
         fmt::format(
             "its stiffeners may buckle with it (EN 1993-1-5, 4.5), which is not judged: {}",
             obstacle),
         true},
        1.0);
  }
  const ShearLags lags = shear_lags_at(*zones_, section, station);
  look_at_shear_lag(segment, "flange", lags.flanges);
  look_at_shear_lag(segment, "web as flange of M_z", lags.webs);
}

}  // namespace boxbeam
