#include "boxbeam/verification/gates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/strength/effective_width.hpp"
#include "boxbeam/strength/plate_slenderness.hpp"
#include "boxbeam/strength/section_class.hpp"
#include "boxbeam/strength/shear_buckling.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/model_ladder.hpp"

namespace boxbeam {
namespace {

/// Below this part of its largest stress a plate's compression has no class.
constexpr double negligible = 0.01;

/// A plate of a box or tube between its neighbours, seen as a web: what bends it in its plane.
struct Web {
  std::string name;
  SectionPlace low, high;  ///< ends of its clear width, on its mid-line
  Length thickness;
  bool flange = false;

  Length depth() const { return flange ? high.y - low.y : high.z - low.z; }
};

Web upright(const std::string& name, double y, Length low, Length high, Length thickness) {
  return {name, {si<Length>(y), low}, {si<Length>(y), high}, thickness};
}

/// One web where both are stressed alike, which they are in a section that mirrors itself.
std::vector<Web> webs_of(const Profile& profile, bool alike) {
  const Length low = clear_bottom_of(profile);
  const Length high = clear_top_of(profile);
  if (const auto* box = std::get_if<Box>(&profile)) {
    const double left = (0.5 * box->width - 0.5 * box->left_web).value();
    const double right = (0.5 * box->right_web - 0.5 * box->width).value();
    if (alike) return {upright("web", left, low, high, box->left_web)};
    return {upright("left web", left, low, high, box->left_web),
            upright("right web", right, low, high, box->right_web)};
  }
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    const double left = 0.5 * (tube->width - tube->wall).value();
    if (alike) return {upright("web", left, low, high, tube->wall)};
    return {upright("left web", left, low, high, tube->wall),
            upright("right web", -left, low, high, tube->wall)};
  }
  return {};
}

/// All four plates: under M_z and N the webs are stressed unlike, and the flanges are the webs of
/// V_y.
std::vector<Web> plates_of(const Profile& profile) {
  Box box;
  if (const auto* of = std::get_if<Box>(&profile))
    box = *of;
  else if (const auto* tube = std::get_if<RectangularTube>(&profile))
    box = symmetric_box(tube->width, tube->height, tube->wall, tube->wall);
  else
    return {};
  const Length low = clear_bottom_of(profile), high = clear_top_of(profile);
  const Length left = 0.5 * box.width - box.left_web, right = box.right_web - 0.5 * box.width;
  const Length top = 0.5 * (box.height - box.top_flange);
  const Length bottom = 0.5 * (box.bottom_flange - box.height);
  const double left_middle = 0.5 * (box.width - box.left_web).value();
  const double right_middle = 0.5 * (box.right_web - box.width).value();
  return {upright("left web", left_middle, low, high, box.left_web),
          upright("right web", right_middle, low, high, box.right_web),
          {"top flange", {right, top}, {left, top}, box.top_flange, true},
          {"bottom flange", {right, bottom}, {left, bottom}, box.bottom_flange, true}};
}

/// The stress distribution over a web with the lowest limit of class 3.
struct WorstStress {
  double psi = -1.0;
  double limit = 0.0;
  bool compressed = false;
};

WorstStress worst_over(const std::vector<SituationHistory>& histories,
                       const StressInfluence& at_low, const StressInfluence& at_high,
                       double epsilon) {
  double largest = 0.0;
  for (const SituationHistory& at : histories) {
    for (const CutForces& cut : at.history.samples()) {
      largest = std::max({largest, std::abs(stress_at(at_low, cut).normal.value()),
                          std::abs(stress_at(at_high, cut).normal.value())});
    }
  }
  WorstStress worst;
  for (const SituationHistory& at : histories) {
    for (const CutForces& cut : at.history.samples()) {
      const double low = -stress_at(at_low, cut).normal.value();
      const double high = -stress_at(at_high, cut).normal.value();
      const double most = std::max(low, high);
      if (most <= negligible * largest) continue;
      const double psi = std::min(low, high) / most;
      const double limit = internal_part_limits(1.0, psi, epsilon).class_3;
      if (worst.compressed && limit >= worst.limit) continue;
      worst = {psi, limit, true};
    }
  }
  return worst;
}

/// Gates by segment and plate, the worst of each with how far it is beyond its limit.
class GateList {
 public:
  void add(const std::string& kind, Gate gate, double excess) {
    const std::string key = kind + "/" + gate.segment + "/" + gate.plate;
    const auto found = worst_.find(key);
    if (found != worst_.end() && found->second.second >= excess) return;
    if (found == worst_.end()) order_.push_back(key);
    worst_[key] = {std::move(gate), excess};
  }
  std::vector<Gate> gates() const {
    std::vector<Gate> gates;
    for (const std::string& key : order_) gates.push_back(worst_.at(key).first);
    return gates;
  }

 private:
  std::map<std::string, std::pair<Gate, double>> worst_;
  std::vector<std::string> order_;
};

std::string class_4_text(double ratio, double limit, const std::string& effective) {
  return fmt::format(
      "c/t = {:.3g} is above {:.3g}, class 4 (EN 1993-1-1, table 5.2): it may buckle "
      "before it yields, and the stress of the full section is not valid{}",
      ratio, limit, effective);
}

void look_at_class(const Project& project, const std::string& segment, const Profile& profile,
                   bool alike, const AreaSums& sums, const std::vector<SituationHistory>& histories,
                   GateList& gates) {
  const std::vector<Web> webs = in_space(project) ? plates_of(profile) : webs_of(profile, alike);
  for (const SlenderPlate& plate : slender_plates_of(profile, project.material)) {
    gates.add("class", {segment, plate.plate, class_4_text(plate.ratio, plate.limit, ""), true},
              plate.ratio / plate.limit);
  }
  for (const Web& web : webs) {
    const auto yield = yield_strength_of(project.material, web.thickness);
    if (!yield) continue;
    const double epsilon = epsilon_of(*yield);
    const auto at = [&](const SectionPlace& end) {
      return normal_influence(sums, end.y.value(), end.z.value());
    };
    const double ratio = web.depth() / web.thickness;
    // A flange counts as evenly compressed, on the safe side, see slender_plates_of.
    const WorstStress worst =
        web.flange ? WorstStress{} : worst_over(histories, at(web.low), at(web.high), epsilon);
    if (worst.compressed && ratio > worst.limit) {
      const auto effective =
          internal_effective_width(web.depth(), web.thickness, worst.psi, epsilon);
      gates.add("class",
                {segment, web.name,
                 class_4_text(ratio, worst.limit,
                              effective ? fmt::format("; with psi = {:.2f}, rho = {:.3g} of its "
                                                      "compressed width is effective (EN 1993-1-5, "
                                                      "4.4)",
                                                      worst.psi, effective->rho)
                                        : ""),
                 true},
                ratio / worst.limit);
    }
    const ShearBucklingNeed need =
        shear_buckling_need(web.depth(), web.thickness, *yield, shear_hardening_factor(*yield));
    if (need.check_needed()) {
      gates.add("shear buckling",
                {segment, web.name,
                 fmt::format("h_w/t_w = {:.3g} is above 72 eps/eta = {:.3g}: the {} may buckle in "
                             "shear, and its resistance is that of EN 1993-1-5, clause 5 (5.1(2))",
                             need.ratio, need.limit, web.flange ? "flange" : "web"),
                 true},
                need.ratio / need.limit);
    }
  }
}

/// Says the worst of a segment, not its station, so that segments of which the same is true stand
/// together.
void look_at_shear_lag(const std::string& segment, const std::string& plate,
                       const std::optional<ShearLag>& lag, GateList& gates) {
  if (!lag) return;
  gates.add(
      "shear lag",
      {segment, plate,
       fmt::format("b_0 = {:.4g} mm is above L_e/50, L_e = {:.3g} m between zero moments: "
                   "shear lag counts; with kappa = {:.3g} a part of the width works, beta = "
                   "{:.3g} of it at the worst station, and the normal stresses are those of "
                   "the section so reduced (EN 1993-1-5, 3.1 and 3.2.1)",
                   lag->b_0.value() * 1e3, lag->effective_length.value(), lag->kappa, lag->beta),
       false},
      -lag->beta);
}

void look_at_yield(const std::vector<CheckResult>& checks, GateList& gates) {
  for (const CheckResult& result : checks) {
    const Check& check = result.check;
    if (check.criterion != Criterion::yield || check.safety_factor >= 1.0) continue;
    gates.add("yield",
              {"", "",
               fmt::format("at s = {} m, {} the stress is above the yield strength: there the beam "
                           "is not elastic, and its fatigue factors mean nothing",
                           to_text(check.station), check.point),
               true},
              1.0 / check.safety_factor);
  }
}

}  // namespace

std::vector<Gate> gates_of(const Project& project, const std::deque<SituationRun>& runs,
                           const std::vector<Station>& stations,
                           const std::vector<CheckResult>& checks) {
  GateList gates;
  const std::vector<BendingZone> zones = bending_zones_of(project, runs);
  for (const Station& station : stations) {
    const Section section = judged_section_at(project, station);
    const std::string& segment = project.beam.segments[segment_at(project.beam, station)].name;
    const std::vector<SituationHistory> histories = histories_at(runs, station);
    const AreaSums sums = sums_of(outline_of(section, {}));
    const bool alike = is_symmetric_about_z(section);
    look_at_class(project, segment, section.outer, alike, sums, histories, gates);
    if (section.inner)
      look_at_class(project, segment, *section.inner, alike, sums, histories, gates);
    const ShearLags lags = shear_lags_at(zones, section, station);
    look_at_shear_lag(segment, "flange", lags.flanges, gates);
    look_at_shear_lag(segment, "web as flange of M_z", lags.webs, gates);
  }
  look_at_yield(checks, gates);
  return gates.gates();
}

namespace {

std::string buckling_text(const Project& project, const BucklingLoad& load, const char* plane) {
  const std::string& name = project.situations[load.situation].name;
  return fmt::format(
      "the beam's compression is {:.4g} of the elastic critical one, N_cr of the tapered beam {} "
      "with its axial force as it is distributed, {}, at t = {:.6g} s{}",
      load.part, plane, load.held, load.when.value(),
      name.empty() ? "" : fmt::format(" of situation \"{}\"", name));
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
    } else if (load.part > no_buckling_below &&
               (load.of_resistance + of.bending) * project.strength.required > 1.0) {
      gates.push_back(
          {"", "",
           buckling_text(project, load, plane) +
               fmt::format(
                   ": its flexural buckling counts (above {}, EN 1993-1-1, 6.3.1.2(4)), and "
                   "N/N_b,Rd = {:.3g} (6.3.1, curve c) with M/(W f_y) = {:.3g} of the bent "
                   "beam is more than 1/{:.3g}, which is required",
                   no_buckling_below, load.of_resistance, of.bending, project.strength.required),
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
  if (of.across) look(*of.across, "across it", in_space(project));
  // There an error of the axial force, such as the bent beam's shortening causes by the inertia of
  // what it moves, is amplified more than threefold: 1/(1 - 0.7).
  constexpr double proven = 0.7;
  if (model.chosen.level == ModelLevel::modal && of.in_plane.part > proven &&
      of.in_plane.part < 1.0) {
    gates.push_back(
        {"", "",
         buckling_text(project, of.in_plane, "in the plane of motion") +
             fmt::format(": above {} the beam's vibration is not proven, for the inertia "
                         "that its shortening by bending causes is not in it",
                         proven),
         true});
  }
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

}  // namespace

std::vector<Gate> model_gates_of(const Project& project, const ModelChoice& model) {
  std::vector<Gate> gates;
  const bool neighbours = !project.pins.empty() || !project.rods.empty();
  if (!is_flexible(project) && neighbours && model.chosen.level != ModelLevel::rigid) {
    gates.push_back({"", "",
                     "pins and rods are checked with the reactions of rigid bodies, in which the "
                     "beam's vibration is missing: their forces may be larger, and those that pass "
                     "are not proven",
                     true});
  }
  look_at_second_order(project, model, gates);
  // What was chosen is within the tolerance already.
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

}  // namespace boxbeam
