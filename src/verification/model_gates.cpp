#include "boxbeam/verification/model_gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/verification/balance_defect.hpp"
#include "boxbeam/verification/design_factor.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/planar_links.hpp"
#include "members_in_space.hpp"
#include "vibration_in_space.hpp"

namespace boxbeam {
namespace {

std::string when_text(const Project& project, Time when, std::size_t situation) {
  const std::string& name = project.situations[situation].name;
  return fmt::format(", at t = {:.6g} s{}", when.value(),
                     name.empty() ? "" : fmt::format(" of situation \"{}\"", name));
}

std::string buckling_text(const Project& project, const BucklingLoad& load, const char* plane) {
  const double factor = design_factor_of(project, project.situations[load.situation]);
  return fmt::format(
             "the beam's compression{} is {:.4g} of the elastic critical one, N_cr of the tapered "
             "beam {} with its axial force as it is distributed, {}",
             factor == 1.0 ? std::string()
                           : fmt::format(", times {:.4g} for its load factor and the safety factor "
                                         "that is asked for,",
                                         factor),
             load.part, plane, load.held) +
         when_text(project, load.when, load.situation);
}

/// Buckling of the beam, and second order where it is not in the cut forces.
void look_at_second_order(const Project& project, const ModelChoice& model,
                          std::vector<Gate>& gates) {
  const SecondOrderEstimate& of = model.second_order;
  const bool counted = model.counts_second_order;
  const auto look = [&](const BucklingLoad& load, const char* plane, bool bends) {
    if (load.part >= 1.0) {
      gates.push_back({"", "",
                       buckling_text(project, load, plane) +
                           ": it buckles, and the stresses of the straight beam mean nothing",
                       true});
    } else if (bends && !counted && load.part > first_order_below) {
      gates.push_back({"", "",
                       buckling_text(project, load, plane) +
                           fmt::format(", above {}: theory of the first order does not hold (EN "
                                       "1993-1-1, 5.2.1(3)), and that of the second is not in the "
                                       "cut forces",
                                       first_order_below),
                       true});
    }
  };
  look(of.in_plane, "in the plane of motion", true);
  if (of.across) look(*of.across, "across it", project.in_space);
  // There an error of the axial force, such as the bent beam's shortening causes by the inertia of
  // what it moves, is amplified more than threefold: 1/(1 - 0.7).
  constexpr double proven = 0.7;
  const auto look_at_vibration = [&](const BucklingLoad& load, const char* plane) {
    if (model.chosen.level != ModelLevel::modal || !(load.part > proven && load.part < 1.0)) return;
    gates.push_back({"", "",
                     buckling_text(project, load, plane) +
                         fmt::format(": above {} the beam's vibration is not proven, for the "
                                     "inertia that its shortening by bending causes is not in it",
                                     proven),
                     true});
  };
  look_at_vibration(of.in_plane, "in the plane of motion");
  if (of.across && project.in_space) look_at_vibration(*of.across, "across it");
  // sin(0.1) is 0.2 % less than 0.1, the work of a turning force 0.4 % less than its square.
  constexpr double small = 0.1;
  if (counted && of.turn > small) {
    gates.push_back({"", "",
                     fmt::format("sections of the beam turn by {:.3g} rad when it bends: beyond "
                                 "{} rad theory of the second order, for small turns, does not "
                                 "hold",
                                 of.turn, small),
                     true});
  }
}

/// The beam bending sideways and turning over.
void look_at_turning_over(const Project& project, const ModelChoice& model,
                          std::vector<Gate>& gates) {
  if (!model.second_order.lateral) return;
  const LateralLoad& load = *model.second_order.lateral;
  if (load.part >= 1.0) {
    gates.push_back(
        {"", "",
         lateral_text(load) + when_text(project, load.when, load.situation) + ": it turns over",
         true});
  }
}

/// More bodies than the elasticity of a mechanism is computed with.
void look_at_bodies(const Project& project, std::vector<Gate>& gates) {
  const auto* const mechanism = std::get_if<planar::Mechanism>(&project.mechanism);
  if (mechanism == nullptr || !has_too_many_bodies(*mechanism)) return;
  gates.push_back({"", "",
                   fmt::format("the mechanism has {} bodies: of more than {} neither the beam's "
                               "vibration nor second order is estimated; make one body of those "
                               "that are joined rigidly",
                               mechanism->bodies.size(), most_elastic_bodies),
                   true});
}

/// What its loads leave unbalanced is known of a vibrating beam only after it was chosen.
bool is_beyond_tolerance(const ModelChoice& model) {
  if (!model.bends_rigid_motion || model.weighed.empty()) return false;
  if (model.chosen.level == ModelLevel::rigid) return false;
  return model.weighed.back().found.value_or(0.0) > model.tolerance;
}

}  // namespace

std::vector<Gate> model_gates_of(const Project& project, const ModelChoice& model) {
  std::vector<Gate> gates;
  const bool neighbours = !project.pins.empty() || !project.rods.empty();
  // Where nothing takes loads over, static bending in space hardly changes forces of pins and rods,
  // which no moment reaches.
  const auto* const in_space = std::get_if<spatial::Mechanism>(&project.mechanism);
  const bool bends = model.chosen.level == ModelLevel::quasi_static && in_space != nullptr;
  if (neighbours && model.chosen.level != ModelLevel::rigid &&
      !(bends && !has_springs(*in_space))) {
    gates.push_back({"", "",
                     fmt::format("pins and rods are checked with the reactions of rigid bodies, in "
                                 "which the beam's {} is missing: their forces may be larger, and "
                                 "those that pass are not proven",
                                 bends ? "bending" : "vibration"),
                     true});
  }
  look_at_second_order(project, model, gates);
  look_at_turning_over(project, model, gates);
  look_at_bodies(project, gates);
  if (project.model.demand == ModelDemand::automatic && is_beyond_tolerance(model)) {
    const double found = *model.weighed.back().found;
    gates.push_back(
        {"", "",
         fmt::format("{} not in balance with the motion of the beam as far bent as it is, "
                     "tolerance {}: its vibration is not proven, for it is computed about the "
                     "motion of the rigid beam",
                     found < unknown_balance ? percent_text(found) + " of the governing stress is"
                                             : "the governing stress is",
                     percent_text(model.tolerance)),
         true});
  }
  // In space what rigid bodies miss counts where checks are used.
  if (std::holds_alternative<spatial::Mechanism>(project.mechanism) &&
      model.chosen.level == ModelLevel::rigid)
    return gates;
  // Rigid bodies stay where no better model is known to be one.
  if (project.model.demand == ModelDemand::automatic && !model.weighed.empty() &&
      model.chosen.level == ModelLevel::rigid) {
    const ModelEstimate& by_rigid = model.weighed.front();
    const double error = by_rigid.found.value_or(by_rigid.error);
    if (error > model.tolerance) {
      gates.push_back({"", "",
                       fmt::format("vibration and second order are estimated to change the "
                                   "governing stress by {}, tolerance {}, and how much they do is "
                                   "not known: no factor is proven unless [model] tolerance allows "
                                   "for it",
                                   percent_text(error), percent_text(model.tolerance)),
                       true});
    }
  }
  // What was chosen else is within the tolerance already.
  if (project.model.demand == ModelDemand::automatic || model.weighed.empty()) return gates;
  const ModelEstimate& demanded = model.weighed.back();
  const double error = demanded.found.value_or(demanded.error);
  if (error <= model.tolerance) return gates;
  gates.push_back({"", "",
                   fmt::format("the model that was demanded misses the governing stress by {}{}, "
                               "tolerance {}: its factors are not those of the beam; take --model "
                               "auto",
                               demanded.found ? "" : "an estimated ", percent_text(error),
                               percent_text(model.tolerance)),
                   true});
  return gates;
}

namespace {

/// Whether a check is of the stress of the beam, and of its range; those of members hold second
/// order, those of pins and rods are of forces that bending hardly changes.
enum class Judges { stress, range, neither };

Judges judges(Criterion criterion) {
  switch (criterion) {
    case Criterion::yield:
    case Criterion::weld:
    case Criterion::effective_section:
    case Criterion::shear_buckling:
    case Criterion::interaction:
    case Criterion::reduced_stress:
    case Criterion::patch_loading:
    case Criterion::deflection: return Judges::stress;
    case Criterion::fatigue:
    case Criterion::shear_fatigue:
    case Criterion::combined_fatigue:
    case Criterion::stress_range: return Judges::range;
    case Criterion::patch_fatigue:
    case Criterion::distortion:
    case Criterion::distortion_fatigue:
    case Criterion::member:
    case Criterion::pin:
    case Criterion::lug_fatigue:
    case Criterion::rod:
    case Criterion::buckling: break;
  }
  return Judges::neither;
}

/// What second order adds to a deflection, by what it adds to what the design loads bend: less, as
/// the loads of a deflection are less. Of what `check_deflection` has grown itself nothing.
double deflection_growth(const Project& project, const CheckResult& result, double designed) {
  if (!std::holds_alternative<frame::Structure>(project.mechanism) &&
      !std::holds_alternative<flexible::Mechanism>(project.mechanism))
    return 0.0;
  const auto at =
      std::find_if(project.situations.begin(), project.situations.end(),
                   [&](const Situation& of) { return of.name == result.check.situation; });
  const double share =
      at == project.situations.end() || !result.deflection
          ? 1.0
          : std::min(1.0, result.deflection->load_factor / design_factor_of(project, *at));
  if (std::isinf(designed)) return designed;
  const double part = share * designed / (1.0 + designed);
  return part / (1.0 - part);
}

}  // namespace

std::vector<Gate> second_order_gates_of(const Project& project, const ModelChoice& model,
                                        const std::vector<CheckResult>& checks) {
  if (!model.second_order.change) return {};
  const bool once = model.counts_second_order;
  const double missed = vibration_missed_in_space(project, model);
  const double vibrating = missed > model.tolerance ? missed : 0.0;
  const Check* most = nullptr;
  double grown = 1.0, growth = 0.0;
  for (const CheckResult& result : checks) {
    const Check& check = result.check;
    const Judges of = judges(check.criterion);
    if (of == Judges::neither || !check.passes()) continue;
    double adds = second_order_growth_at(model.second_order, check.station.s, of == Judges::range);
    if (check.criterion == Criterion::deflection) {
      const double& bow = model.second_order.in_plane.part;
      if (!once && bow < 1.0) adds = std::max(adds, bow / (1.0 - bow));
      adds = deflection_growth(project, result, adds);
    }
    adds += vibrating;
    if (!(check.utilisation() * (1.0 + adds) > grown)) continue;
    grown = check.utilisation() * (1.0 + adds);
    growth = adds;
    most = &check;
  }
  if (most == nullptr) return {};
  return {{"", "",
           fmt::format("{}second order (bending by N w) {} and is estimated to "
                       "add {} to the {} of {} at s = {} m, {}: {} used becomes {}, which does not "
                       "pass",
                       vibrating > 0.0 ? "vibration with " : "",
                       once ? "is in the cut forces by the loads times one, not times their load "
                              "factor and the safety factor that is asked for,"
                            : "is not in the cut forces",
                       percent_text(growth),
                       judges(most->criterion) == Judges::range ? "stress range" : "stress",
                       to_text(most->criterion), to_text(most->station), most->point,
                       percent_text(most->utilisation()), percent_text(grown)),
           true}};
}

std::vector<Gate> stability_gates_of(const Project& project, const std::deque<SituationRun>& runs) {
  constexpr double first_order_from = 10.0, worth_saying = 100.0;
  double least = worth_saying;
  std::string name;
  for (const SituationRun& run : runs) {
    // Loads of a situation that counts for fatigue or deflection only are smaller than those for
    // strength, or counted there, too.
    const double factor = std::max(run.situation->load_factor, 1.0) * project.strength.required;
    const std::optional<double> critical = run.motion->critical_factor(run.loads, least * factor);
    if (!critical) return {};
    if (*critical / factor >= least) continue;
    least = *critical / factor;
    name = run.situation->name;
  }
  if (least >= worth_saying) return {};
  const std::string where = name.empty() ? "" : fmt::format(" of situation \"{}\"", name);
  if (least <= 1.0) {
    return {{"", "",
             fmt::format("the frame buckles elastically under its loads{}, at {:.3g} times them: "
                         "stresses of theory of the first order mean nothing",
                         where, least),
             true}};
  }
  if (least < first_order_from) {
    return {{"", "",
             fmt::format("the frame buckles elastically at {:.3g} times its loads{}, below {}: "
                         "second order counts (EN 1993-1-1, 5.2.1(3)) and is not in the cut forces",
                         least, where, first_order_from),
             true}};
  }
  return {
      {"", "",
       fmt::format("the frame buckles elastically at {:.3g} times its loads{}, above {}: theory "
                   "of the first order holds (EN 1993-1-1, 5.2.1(3))",
                   least, where, first_order_from),
       false}};
}

}  // namespace boxbeam
