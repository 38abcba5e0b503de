#include "boxbeam/verification/plate_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "below_yield.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/path_checks.hpp"
#include "plate_panels.hpp"
#include "slender_check.hpp"

namespace boxbeam {
namespace {

/// The uses of a station's plates under cut forces, with gamma_M0 and gamma_M1.
class PlateUses {
 public:
  PlateUses(const Project& project, const SlenderPlates& plates)
      : gamma_M0_(project.strength.gamma_M0),
        gamma_M1_(project.strength.gamma_M1),
        rule_(project.strength.effective_widths),
        plates_(&plates) {}

  double normal(const CutForces& cut) const { return normal(corner(cut)); }
  double normal(const CornerUse& corner) const { return gamma_M0_ * corner.use; }
  WebInteraction together(const ShearedPlate& plate, const CutForces& cut) const {
    return together(plate, corner(cut), cut);
  }
  WebInteraction together(const ShearedPlate& plate, const CornerUse& corner,
                          const CutForces& cut) const {
    return interaction_of(plate, plates_->plastic, corner, cut, gamma_M0_);
  }
  double reduced(const ReducedPlate& plate, const CutForces& cut) const {
    return plate.use(cut, gamma_M1_);
  }
  CornerUse corner(const CutForces& cut) const {
    CornerUse at_yield = plates_->box.worst_corner(cut);
    const auto below = lower_section(plates_->box, cut, rule_, at_yield.use);
    return below ? below->worst_corner(cut) : at_yield;
  }

 private:
  double gamma_M0_, gamma_M1_;
  WidthRule rule_;
  const SlenderPlates* plates_;
};

/// Whether what acts leaves a plate that does not work whole. `idle`: whether what acts alone does.
template <class Idle>
bool buckles_under(const CutForces& cut, const SectionUse& worst, const Idle& idle) {
  const auto bent = [&](bool about_y, Moment moment) {
    return moment.value() != 0.0 && idle(moment_alone(about_y, moment.value() < 0.0));
  };
  return (cut.N.value() < 0.0 && idle(ActingAlone::compression)) || bent(true, worst.M_y) ||
         bent(false, worst.M_z);
}

bool buckles_under(const EffectiveBox& box, const CutForces& cut) {
  return buckles_under(cut, box.worst_corner(cut), [&](ActingAlone acting) {
    const auto& walls = box.alone(acting).walls;
    return std::any_of(walls.begin(), walls.end(),
                       [](const WallAlone& wall) { return wall.buckles(); });
  });
}

bool buckles_under(const EffectivePath& path, const CutForces& cut) {
  return buckles_under(cut, path.worst_place(cut), [&](ActingAlone acting) {
    const std::vector<PlateAlone>& plates = path.alone(acting).plates;
    return std::any_of(plates.begin(), plates.end(),
                       [](const PlateAlone& of) { return of.idle() > 0.0; });
  });
}

/// The checks of a station's plates as they are gathered.
class StationPlates {
 public:
  StationPlates(const Project& project, const Station& station,
                const std::shared_ptr<const SlenderPlates>& plates,
                const std::vector<SituationHistory>& histories)
      : project_(&project),
        station_(station),
        plates_(plates),
        histories_(&histories),
        uses_(project, *plates) {}

  std::vector<CheckResult> by_effective_widths() {
    const WorstInstant section = worst([&](const CutForces& cut) { return uses_.normal(cut); });
    add(Criterion::effective_section, section);
    WorstInstant together{&histories_->front(), {}, 0.0};
    const ShearedPlate* in_plate = nullptr;
    double most_shear = 0.0;
    for (const ShearedPlate& plate : plates_->sheared) {
      const auto shear = [&](const CutForces& cut) { return shear_use_of(plate, cut); };
      if (plate.may_buckle) add(Criterion::shear_buckling, worst(shear), &plate);
      const WorstInstant of =
          worst([&](const CutForces& cut) { return uses_.together(plate, cut).use; });
      if (!(of.use > no_use)) continue;
      // Where shear is small all plates are alike: the one that has most of it is named.
      const double sheared = shear(of.at->history.at(of.largest.time));
      constexpr double same = 1e-9;
      const bool less = of.use < (1.0 - same) * together.use;
      const bool alike = !less && of.use <= (1.0 + same) * together.use;
      if (in_plate != nullptr && (less || (alike && sheared <= most_shear))) continue;
      most_shear = sheared;
      together = of;
      in_plate = &plate;
    }
    if (in_plate != nullptr) add(Criterion::interaction, together, in_plate);
    return std::exchange(results_, {});
  }

  std::vector<CheckResult> by_reduced_stresses() {
    for (const ReducedPlate& plate : plates_->reduced) {
      add(Criterion::reduced_stress,
          worst([&](const CutForces& cut) { return uses_.reduced(plate, cut); }), &plate.sheared,
          &plate);
    }
    return std::exchange(results_, {});
  }

 private:
  template <class Use>
  WorstInstant worst(const Use& use) const {
    return worst_instant_of(*histories_, use);
  }

  void add(Criterion criterion, const WorstInstant& worst, const ShearedPlate* plate = nullptr,
           const ReducedPlate* reduced = nullptr) {
    if (!(worst.use > no_use)) return;
    CheckResult result;
    PlateBasis& basis = result.plates.emplace();
    basis.plates = plates_;
    basis.cut = worst.at->history.at(worst.largest.time);
    const WidthRule rule = project_->strength.effective_widths;
    basis.box = section_under(plates_, plates_->box, basis.cut, rule);
    basis.corner = basis.box->worst_corner(basis.cut);
    basis.load_factor = worst.at->situation->load_factor;
    basis.plate = plate;
    basis.reduced = reduced;
    SlenderUse of{criterion, plate, reduced};
    of.point = plate != nullptr ? plate->name : to_text(basis.corner.corner.flange);
    if (plate == nullptr && project_->in_space)
      of.point += fmt::format(" at {}", to_text(basis.corner.corner.web));
    of.yield_strength = basis.corner.yield_strength;
    of.clause = clause_of(basis.box.get() != &plates_->box, rule);
    of.web = criterion == Criterion::interaction && uses_.together(*plate, basis.cut).share > 0.0;
    result.check = slender_check_of(*project_, station_, worst, of);
    results_.push_back(std::move(result));
  }

  const Project* project_;
  Station station_;
  std::shared_ptr<const SlenderPlates> plates_;
  const std::vector<SituationHistory>* histories_;
  PlateUses uses_;
  std::vector<CheckResult> results_;
};

/// Whether shear and normal stress both have a part in a check of both together.
bool says_more_together(const Project& project, const CheckResult& of) {
  const bool path = of.path.has_value();
  const ShearedWall& wall = path ? *of.path->wall : *of.plates->plate;
  const CutForces& cut = path ? of.path->cut : of.plates->cut;
  const double normal = path ? project.strength.gamma_M0 * of.path->use.use
                             : PlateUses(project, *of.plates->plates).normal(cut);
  return 2.0 * shear_use_of(wall, cut) > normal && !(wall.may_buckle && normal <= no_use);
}

}  // namespace

WebInteraction interaction_of(const ShearedPlate& plate, const PlasticBox& plastic,
                              const CornerUse& corner, const CutForces& cut, double gamma_M0) {
  const double eta_1 = gamma_M0 * corner.use;
  const double eta_3 = shear_use_of(plate, cut);
  if (!is_flange(plate.plate)) return plastic.web_under(cut, corner, gamma_M0, eta_1, eta_3);
  const double factor = interaction_factor(eta_1, eta_3);
  return {1.0 / factor, 0.0, factor, corner.M_y};
}

std::shared_ptr<const SlenderPlates> slender_plates_at(const Project& project,
                                                       const std::vector<BendingZone>& zones,
                                                       const Station& station) {
  const std::optional<FourWalls> deciding = deciding_walls_at(project, station);
  const bool slender =
      deciding && std::any_of(deciding->walls.begin(), deciding->walls.end(),
                              [](const BoxWall& wall) { return may_buckle(wall); });
  if (!slender || !plates_obstacle(project, station).empty()) return nullptr;
  const std::optional<FourWalls> walls = judged_walls_at(project, station);
  if (!walls) return nullptr;
  const Section section = judged_section_at(project, station);
  const LagShares lag = lag_shares_at(zones, section, station);
  const EffectiveBox box(*walls, lag);
  auto plates = std::make_shared<SlenderPlates>(SlenderPlates{box, PlasticBox(box), lag, {}});
  plates->sheared = sheared_plates_of(section, *walls, taper_at(project.beam, station),
                                      !project.in_space, project.strength.gamma_M1);
  divide_into_panels(project, station, plates->sheared);
  for (ShearedPlate& plate : plates->sheared)
    plate.may_buckle = may_buckle_in_shear(deciding->of(plate.plate));
  const Segment& segment = project.beam.segments[segment_at(project.beam, station)];
  plates->route = plate_route_of(project, segment);
  plates->steep = is_steep(segment);
  plates->reduced = reduced_plates_at(project, zones, station, section, *walls, plates->sheared);
  if (plates->route == PlateRoute::reduced_stresses && plates->reduced.empty()) return nullptr;
  return plates;
}

Utilisations plate_uses_of(const Project& project, const SlenderPlates& plates,
                           const StationSamples& samples) {
  const PlateUses uses(project, plates);
  const double required = project.strength.required;
  Utilisations found;
  const auto look = [&](Criterion criterion, const auto& use) {
    double& of = found.of(criterion);
    of = std::max(of, required * samples.largest_use(use));
  };
  if (plates.route == PlateRoute::reduced_stresses) {
    for (const ReducedPlate& plate : plates.reduced) {
      look(Criterion::reduced_stress,
           [&](const CutForces& cut) { return uses.reduced(plate, cut); });
    }
    return found;
  }
  // Of each of the cut forces, which are asked for in the same order every time.
  std::vector<CornerUse> corners;
  look(Criterion::effective_section,
       [&](const CutForces& cut) { return uses.normal(corners.emplace_back(uses.corner(cut))); });
  for (const ShearedPlate& plate : plates.sheared) {
    if (plate.may_buckle) {
      look(Criterion::shear_buckling,
           [&](const CutForces& cut) { return shear_use_of(plate, cut); });
    }
    auto at = corners.cbegin();
    look(Criterion::interaction,
         [&](const CutForces& cut) { return uses.together(plate, *at++, cut).use; });
  }
  return found;
}

PlateChecks check_plates(const Project& project, const Station& station,
                         const std::shared_ptr<const SlenderPlates>& plates,
                         const std::vector<SituationHistory>& histories) {
  StationPlates of(project, station, plates, histories);
  std::vector<CheckResult> reduced = of.by_reduced_stresses();
  std::vector<CheckResult> effective;
  if (!plates->steep) effective = of.by_effective_widths();
  if (plates->route == PlateRoute::reduced_stresses)
    return {std::move(reduced), std::move(effective)};
  return {std::move(effective), std::move(reduced)};
}

void leave_out_covered(const Project& project, std::vector<CheckResult>& checks) {
  const auto worst_by = [&](Criterion criterion) -> const CheckResult* {
    const CheckResult* most = nullptr;
    for (const CheckResult& of : checks) {
      if (of.check.criterion == criterion &&
          (most == nullptr || of.check.utilisation() > most->check.utilisation()))
        most = &of;
    }
    return most;
  };
  const auto use_by = [&](Criterion criterion) {
    const CheckResult* const most = worst_by(criterion);
    return most == nullptr ? 0.0 : most->check.utilisation();
  };
  const auto drop = [&](Criterion criterion, double others, const auto& says_more) {
    const CheckResult* const most = worst_by(criterion);
    constexpr double round_off = 1e-9;
    if (most == nullptr || most->check.utilisation() > (1.0 + round_off) * others ||
        says_more(*most))
      return;
    std::erase_if(checks, [&](const CheckResult& of) { return of.check.criterion == criterion; });
  };
  const double yield = use_by(Criterion::yield);
  const double section = use_by(Criterion::effective_section);
  drop(Criterion::interaction, std::max({yield, section, use_by(Criterion::shear_buckling)}),
       [&](const CheckResult& of) { return says_more_together(project, of); });
  drop(Criterion::effective_section, yield, [](const CheckResult& of) {
    return of.path ? buckles_under(*of.path->section, of.path->cut)
                   : buckles_under(*of.plates->box, of.plates->cut);
  });
  drop(Criterion::reduced_stress, yield, [&](const CheckResult& of) {
    const ReducedPlate& plate = *of.plates->reduced;
    return reduced_stress_of(plate.panel, plate.under(of.plates->cut), project.strength.gamma_M1)
        .reduced();
  });
}

}  // namespace boxbeam
