#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "boxbeam/verification/distortion_checks.hpp"

namespace boxbeam {
namespace {

/// What is judged without distortion in a stretch, and how much of it is used.
struct Beside {
  std::string names;
  double used = 0.0;  ///< with distortion
  bool has_ranges = false;

  void add(const std::string& name, double with) {
    if (names.find(name) == std::string::npos) names += (names.empty() ? "" : ", ") + name;
    used = std::max(used, with);
  }
};

bool judges_plates(Criterion criterion) {
  return criterion == Criterion::effective_section || criterion == Criterion::shear_buckling ||
         criterion == Criterion::interaction || criterion == Criterion::reduced_stress;
}

Beside beside(const Project& project, const DistortionEstimate& of,
              const std::vector<CheckResult>& checks) {
  constexpr double edge_of_hole = 3.0;  // of a round hole in a plate under tension
  const double distorted = project.strength.required * of.used;
  const auto lies_in = [&](Length s) { return s >= of.from && s <= of.to; };
  Beside found;
  for (const CheckResult& result : checks) {
    const Check& check = result.check;
    const double used = check.utilisation();
    if (check.criterion == Criterion::member) {
      found.add("the buckling of the beam", used + distorted);
    } else if (check.criterion == Criterion::patch_loading || result.patch) {
      if (lies_in(check.station.s)) found.add("forces that come into webs", used + distorted);
    } else if (judges_plates(check.criterion)) {
      if (lies_in(check.station.s))
        found.add("plates that may buckle",
                  used + project.strength.required * of.used_where_slender);
    } else if (result.basis && lies_in(check.station.s)) {
      const bool strength =
          check.criterion == Criterion::yield || check.criterion == Criterion::weld;
      const bool at_hole = result.basis->point.concentration.has_value();
      const bool at_weld = check.point.find("of weld ") != std::string::npos;
      if (!at_hole && !at_weld) continue;
      found.has_ranges = found.has_ranges || !strength;
      found.add(at_hole ? "edges of holes" : "welds around profiles",
                strength ? used + (at_hole ? edge_of_hole : 1.0) * distorted : 0.0);
    }
  }
  return found;
}

/// Whether a check of a stretch has distortion in it.
bool is_checked(const DistortionEstimate& of, const std::vector<CheckResult>& checks) {
  return std::any_of(checks.begin(), checks.end(), [&](const CheckResult& result) {
    const Length s = result.check.station.s;
    return result.distortion && s >= of.from && s <= of.to;
  });
}

std::string effects_text(const Project& project, const DistortionEstimate& of) {
  const std::string& name = project.situations[of.situation].name;
  return fmt::format(
      "distortion of the box between s = {:.4g} m and {:.4g} m: its torques, most of all {:.3g} "
      "kN m at s = {:.4g} m, each led in {}, bend its plates across by {:.3g} MPa and stretch its "
      "edges by {:.3g} MPa at most (t = {:.6g} s{}), bending by {:.3g} MPa",
      of.from.value() + 0.0, of.to.value(), of.torque.value() * 1e-3, of.introduced.value() + 0.0,
      std::any_of(project.beam.introductions.begin(), project.beam.introductions.end(),
                  [](const LoadIntroduction& by) { return by.torque_by.has_value(); })
          ? "as the case says, else by its webs or its flanges alone"
          : "by its webs or its flanges alone",
      of.across.value() * 1e-6, of.along.value() * 1e-6, of.when.value(),
      name.empty() ? "" : fmt::format(" of situation \"{}\"", name), of.bending.value() * 1e-6);
}

std::string remedy_text(const DistortionEstimate& of) {
  constexpr std::size_t few = 4;
  std::string where;
  if (of.places.size() <= few) {
    for (const Length& s : of.places)
      where += fmt::format("{}{:.4g} m", where.empty() ? "at s = " : ", ", s.value() + 0.0);
    where += ", ";
  }
  return fmt::format(
      "Plates across the box that keep it in shape are [[beam.diaphragms]]: {}where torque comes, "
      "no farther apart than {:.3g} m (0.5/lambda) where it comes between them",
      where, of.spacing.value());
}

}  // namespace

std::vector<Gate> distortion_gates_of(const Project& project,
                                      const std::vector<DistortionEstimate>& estimates,
                                      const std::vector<CheckResult>& checks) {
  constexpr double disregarded = 0.1, next_to_nothing = 0.01, worth_saying = 1e-3;
  // What bends slender plates across makes them bow: more than a bow that tolerances allow is no
  // matter of adding up.
  constexpr double most_where_slender = 0.1;
  // Category 36 at 1e8 cycles: (2/5)^(1/3) (5/100)^(1/5) of it. Source: EN 1993-1-9, 7.1(2), (3).
  const FatigueDemand& demand = project.fatigue.demand;
  const double cut_off = 36e6 * std::cbrt(0.4) * std::pow(0.05, 0.2) / demand.gamma_Mf;
  std::vector<Gate> gates;
  for (const DistortionEstimate& of : estimates) {
    const auto slight = [&](double used) {
      return project.strength.required * used <= next_to_nothing;
    };
    const auto small_range = [&](Stress range, double of_cut_off) {
      const double limit = of_cut_off * cut_off / (demand.gamma_Ff * project.fatigue.required);
      return range <= std::max(disregarded * of.bending_range, si<Stress>(limit), std::less<>());
    };
    const bool small_ranges = !project.fatigue.asked || (small_range(of.along_range, disregarded) &&
                                                         small_range(of.across_range, 1.0));
    const Beside without = beside(project, of, checks);
    std::vector<std::string> reasons;
    if (project.strength.required * of.used_where_slender > most_where_slender)
      reasons.push_back(
          fmt::format("plates that may buckle bear {:.3g} of their strength by it, more than the "
                      "{:.2g} that is added to their checks",
                      project.strength.required * of.used_where_slender, most_where_slender));
    if (!slight(of.used) && without.used > 1.0)
      reasons.push_back(fmt::format("it is in no check of {}, which with it would use {:.3g}",
                                    without.names, without.used));
    if (!small_ranges && !of.ranges_judged)
      reasons.push_back(fmt::format(
          "in the fatigue of a long record it is in no check, with ranges of {:.3g} and {:.3g} "
          "MPa, bending {:.3g} MPa",
          of.across_range.value() * 1e-6, of.along_range.value() * 1e-6,
          of.bending_range.value() * 1e-6));
    else if (!small_ranges && without.has_ranges)
      reasons.push_back(fmt::format("it is in no check of the fatigue of {}", without.names));
    for (const DistortionEstimate::Holding& held : of.held) {
      if (!(held.life > 1.0) || !of.ranges_judged) continue;
      gates.push_back(
          {"", "",
           fmt::format("diaphragm at s = {:.4g} m: so that the box keeps its shape under torque it "
                       "is sheared anew at every cycle, its fillets by {:.3g} MPa: these or its "
                       "plate are used by {:.3g} in fatigue (EN 1993-1-9, table 8.5, row 8): "
                       "thicker ones, or further [[beam.diaphragms]]",
                       held.s.value() + 0.0, held.range.value() * 1e-6, held.life),
           true});
    }
    if (of.holding && project.strength.required * of.holding->used() > 1.0) {
      const bool by_welds = of.holding->welds > of.holding->plate;
      gates.push_back(
          {"", "",
           fmt::format(
               "diaphragm at s = {:.4g} m: so that the box keeps its shape under torque, "
               "{:.3g} kN along each web shear its {} by {:.3g} of what {} bear{}: it keeps "
               "nothing in shape; a thicker one does, or further [[beam.diaphragms]]",
               of.holding->s.value() + 0.0, of.holding->shear.value() * 1e-3,
               by_welds ? "fillets" : "plate", project.strength.required * of.holding->used(),
               by_welds ? "they" : "it", by_welds ? "" : "s"),
           true});
    }
    const std::string effects = effects_text(project, of);
    if (!reasons.empty()) {
      gates.push_back(
          {"", "", fmt::format("{}: {}. {}", effects, fmt::join(reasons, "; "), remedy_text(of)),
           true});
    } else if (of.used >= worth_saying) {
      gates.push_back({"", "",
                       effects + (is_checked(of, checks)
                                      ? ": it is in the checks of distortion"
                                      : ": no place is used more with it than the worst without"),
                       false});
    }
  }
  return gates;
}

namespace {

using Holding = DistortionEstimate::Holding;

bool stands_at(const Holding& of, Length s) { return abs(s - of.s).value() <= 1e-6; }

double used_by_both(const Holding& held, const IntoDiaphragm& of) {
  const double others =
      held.d > Moment{} ? std::max(0.0, 1.0 - (0.5 * of.turns / held.d).value()) : 0.0;
  switch (of.part) {
    case IntoDiaphragm::Part::plate: return of.use + others * held.plate;
    case IntoDiaphragm::Part::web_weld: return of.use + others * held.welds;
    case IntoDiaphragm::Part::flange_weld: return std::hypot(of.use, others * held.welds);
  }
  return of.use;
}

const char* words_of(IntoDiaphragm::Part part) {
  switch (part) {
    case IntoDiaphragm::Part::plate: return "plate";
    case IntoDiaphragm::Part::web_weld: return "welds with the webs";
    case IntoDiaphragm::Part::flange_weld: return "welds with the flanges";
  }
  return "";
}

/// What both use of a diaphragm in strength, where that is above one and neither by itself is.
std::optional<Gate> shared_in_strength(const Project& project, const Holding& held,
                                       const std::vector<IntoDiaphragm>& into) {
  const double required = project.strength.required;
  const IntoDiaphragm* worst = nullptr;
  double most = 1.0;
  for (const IntoDiaphragm& of : into) {
    if (!stands_at(held, of.s) || required * of.use > 1.0) continue;
    const double both = required * used_by_both(held, of);
    if (!(both > most)) continue;
    most = both;
    worst = &of;
  }
  if (worst == nullptr || required * held.used() > 1.0) return std::nullopt;
  return Gate{
      "", "",
      fmt::format("diaphragm at s = {:.4g} m: so that the box keeps its shape under torque, "
                  "{:.3g} kN along each web shear it, and with what \"{}\" puts there its "
                  "{} are used by {:.3g}: a thicker one, or further [[beam.diaphragms]]",
                  held.s.value() + 0.0, held.shear.value() * 1e-3, worst->under,
                  words_of(worst->part), most),
      true};
}

std::optional<Gate> shared_in_fatigue(const Holding& held, const std::vector<CheckResult>& checks) {
  constexpr double hardly = 0.01;
  const CheckResult* worst = nullptr;
  for (const CheckResult& of : checks) {
    if (!of.pressed || of.pressed->welds == 0 || !stands_at(held, of.check.station.s)) continue;
    if (worst == nullptr || of.check.utilisation() > worst->check.utilisation()) worst = &of;
  }
  if (worst == nullptr || !(held.life > hardly) || held.life > 1.0) return std::nullopt;
  const double both = worst->check.utilisation() + held.life;
  if (!(both > 1.0) || worst->check.utilisation() > 1.0) return std::nullopt;
  return Gate{
      "", "",
      fmt::format("{} at s = {:.4g} m: with what keeps the box in shape used by up to {:.3g} "
                  "in fatigue, which is not judged together: a thicker one, or further "
                  "[[beam.diaphragms]]",
                  worst->check.point, held.s.value() + 0.0, both),
      true};
}

}  // namespace

std::vector<Gate> shared_diaphragm_gates_of(const Project& project,
                                            const std::vector<DistortionEstimate>& estimates,
                                            const std::vector<IntoDiaphragm>& into,
                                            const std::vector<CheckResult>& checks) {
  std::vector<Gate> gates;
  for (const DistortionEstimate& estimate : estimates) {
    for (const Holding& held : estimate.held) {
      if (auto gate = shared_in_strength(project, held, into)) gates.push_back(*std::move(gate));
      if (auto gate = shared_in_fatigue(held, checks)) gates.push_back(*std::move(gate));
    }
  }
  return gates;
}

}  // namespace boxbeam
