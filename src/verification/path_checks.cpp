#include "boxbeam/verification/path_checks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "below_yield.hpp"
#include "slender_check.hpp"

namespace boxbeam {
namespace {

/// The uses of a station's path under cut forces, with gamma_M0 and gamma_M1.
class PathUses {
 public:
  PathUses(const Project& project, const SlenderPath& path)
      : gamma_M0_(project.strength.gamma_M0),
        gamma_M1_(project.strength.gamma_M1),
        rule_(project.strength.effective_widths),
        path_(&path) {}

  double normal(const CutForces& cut) const { return gamma_M0_ * place(cut).use; }
  WebInteraction together(const ShearedWall& wall, const CutForces& cut) const {
    return interaction_of(*path_, wall, place(cut), cut, gamma_M0_);
  }
  double reduced(const ReducedPlate& plate, const CutForces& cut) const {
    return plate.use(cut, gamma_M1_);
  }

 private:
  PathUse place(const CutForces& cut) const {
    PathUse at_yield = path_->section.worst_place(cut);
    const auto below = lower_section(path_->section, cut, rule_, at_yield.use);
    return below ? below->worst_place(cut) : at_yield;
  }

  double gamma_M0_, gamma_M1_;
  WidthRule rule_;
  const SlenderPath* path_;
};

/// The checks of a station's path as they are gathered.
class StationPath {
 public:
  StationPath(const Project& project, const Station& station,
              const std::shared_ptr<const SlenderPath>& path,
              const std::vector<SituationHistory>& histories)
      : project_(&project),
        station_(station),
        path_(path),
        histories_(&histories),
        uses_(project, *path) {}

  std::vector<CheckResult> checks() {
    add(Criterion::effective_section,
        worst([&](const CutForces& cut) { return uses_.normal(cut); }), nullptr);
    WorstInstant together{&histories_->front(), {}, 0.0};
    const ShearedWall* in_wall = nullptr;
    for (const ShearedWall& wall : path_->sheared) {
      if (wall.may_buckle) {
        add(Criterion::shear_buckling,
            worst([&](const CutForces& cut) { return shear_use_of(wall, cut); }), &wall);
      }
      const WorstInstant of =
          worst([&](const CutForces& cut) { return uses_.together(wall, cut).use; });
      if (in_wall != nullptr && of.use <= together.use) continue;
      together = of;
      in_wall = &wall;
    }
    if (in_wall != nullptr) add(Criterion::interaction, together, in_wall);
    return std::move(results_);
  }

  std::vector<CheckResult> reduced_checks() {
    for (const ReducedPlate& plate : path_->reduced) {
      add(Criterion::reduced_stress,
          worst([&](const CutForces& cut) { return uses_.reduced(plate, cut); }), &plate.sheared,
          &plate);
    }
    return std::move(results_);
  }

 private:
  template <class Use>
  WorstInstant worst(const Use& use) const {
    return worst_instant_of(*histories_, use);
  }

  void add(Criterion criterion, const WorstInstant& worst, const ShearedWall* wall,
           const ReducedPlate* reduced = nullptr) {
    if (!(worst.use > no_use)) return;
    CheckResult result;
    PathBasis& basis = result.path.emplace();
    basis.path = path_;
    basis.wall = wall;
    basis.reduced = reduced;
    basis.cut = worst.at->history.at(worst.largest.time);
    const WidthRule rule = project_->strength.effective_widths;
    basis.section = section_under(path_, path_->section, basis.cut, rule);
    basis.use = basis.section->worst_place(basis.cut);
    basis.load_factor = worst.at->situation->load_factor;
    SlenderUse of{criterion, wall, reduced};
    of.point = wall != nullptr ? wall->name : path_->section.places()[basis.use.place].name;
    of.yield_strength = basis.use.yield_strength;
    of.clause = clause_of(basis.section.get() != &path_->section, rule);
    of.web = criterion == Criterion::interaction && uses_.together(*wall, basis.cut).share > 0.0;
    result.check = slender_check_of(*project_, station_, worst, of);
    results_.push_back(std::move(result));
  }

  const Project* project_;
  Station station_;
  std::shared_ptr<const SlenderPath> path_;
  const std::vector<SituationHistory>* histories_;
  PathUses uses_;
  std::vector<CheckResult> results_;
};

}  // namespace

double shear_use_of(const ShearedWall& wall, const CutForces& cut) {
  return wall.force_of(cut) / wall.resists.resistance;
}

WebInteraction interaction_of(const SlenderPath& path, const ShearedWall& wall,
                              const PathUse& normal, const CutForces& cut, double gamma_M0) {
  const double eta_1 = gamma_M0 * normal.use, eta_3 = shear_use_of(wall, cut);
  const std::vector<PathPlate>& plates = path.section.path().plates;
  const bool web =
      path.plastic && std::any_of(plates.begin(), plates.end(), [&](const PathPlate& of) {
        return of.name == wall.name && std::abs(of.direction.x()) <= 1e-9;
      });
  if (web) return path.plastic->web_under(cut, normal, gamma_M0, eta_1, eta_3);
  const double factor = interaction_factor(eta_1, eta_3);
  return {1.0 / factor, 0.0, factor, normal.M_y};
}

Utilisations path_uses_of(const Project& project, const SlenderPath& path,
                          const StationSamples& samples) {
  const PathUses uses(project, path);
  Utilisations found;
  const auto look = [&](Criterion criterion, const auto& use) {
    double& of = found.of(criterion);
    of = std::max(of, project.strength.required * samples.largest_use(use));
  };
  look(Criterion::effective_section, [&](const CutForces& cut) { return uses.normal(cut); });
  for (const ShearedWall& wall : path.sheared) {
    if (wall.may_buckle) {
      look(Criterion::shear_buckling,
           [&](const CutForces& cut) { return shear_use_of(wall, cut); });
    }
    look(Criterion::interaction,
         [&](const CutForces& cut) { return uses.together(wall, cut).use; });
  }
  for (const ReducedPlate& plate : path.reduced) {
    look(Criterion::reduced_stress, [&](const CutForces& cut) { return uses.reduced(plate, cut); });
  }
  return found;
}

std::vector<CheckResult> check_reduced_path(const Project& project, const Station& station,
                                            const std::shared_ptr<const SlenderPath>& path,
                                            const std::vector<SituationHistory>& histories) {
  return StationPath(project, station, path, histories).reduced_checks();
}

std::vector<CheckResult> check_path(const Project& project, const Station& station,
                                    const std::shared_ptr<const SlenderPath>& path,
                                    const std::vector<SituationHistory>& histories) {
  return StationPath(project, station, path, histories).checks();
}

}  // namespace boxbeam
