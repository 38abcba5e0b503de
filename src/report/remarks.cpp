#include "boxbeam/report/remarks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/report/format.hpp"
#include "boxbeam/verification/plausibility.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "front_end_text.hpp"
#include "remark_parts.hpp"

namespace boxbeam {
namespace {

void add_whole_records(const Verification& verification, std::vector<std::string>& remarks) {
  const WholeSummary& whole = verification.search.whole;
  if (whole.instants == 0) return;
  std::string remark = fmt::format(
      "{} instants are given: strength is judged at those at which cut forces and "
      "stresses at the cuts of the beam are largest or smallest",
      whole.instants);
  if (whole.counted > 0) {
    remark += fmt::format(
        "; the cycles of {} stresses are counted over all instants, those of other places are "
        "estimated from these. In the last search the estimates of what was counted then, places "
        "least like others among them, were off by {:.2g} % at most, and all places within {:.2g} "
        "% of the largest of their criterion were counted. The largest range counted exceeds the "
        "one at the instants of strength by {:.2g} % at most",
        whole.counted, 100.0 * whole.estimate_error, 100.0 * whole.margin,
        100.0 * whole.extreme_error);
  }
  remarks.push_back(std::move(remark));
}

void add_published(const Project& project, const Verification& verification,
                   std::vector<std::string>& remarks) {
  if (project.dynamics == Dynamics::newton_chain && verification.chain) {
    remarks.push_back(
        fmt::format("the Newton chain leaves out lever arms: at t = {} the moments from both ends "
                    "miss each other at "
                    "the pivot by {}, taken there as a couple",
                    text::seconds(verification.chain->time.value()),
                    text::kNm(verification.chain->moment_gap.value())));
  }
  for (const GivenStress& given : project.given_stresses) {
    remarks.push_back(fmt::format("stress {} is given, not computed: {}", given.name, given.note));
  }
  if (project.given_stresses.empty()) return;
  remarks.push_back("only the given stresses are checked; the rest of the beam is not");
  for (const PublishedConcentration& hole : verification.published_concentrations) {
    remarks.push_back(fmt::format(
        "K_t = 2.68750 exp(-0.7128 d/w) gives {} for hole {} (d/w = {}); the published stresses "
        "contain 2.66",
        text::significant(hole.factor), hole.hole, text::significant(hole.diameter_to_width, 3)));
  }
}

void add_beside(const Project& project, const Verification& verification,
                std::vector<std::string>& remarks) {
  const CheckResult* fatigue = verification.governing(Criterion::fatigue);
  if (fatigue != nullptr && fatigue->basis && project.fatigue.demand.loading == Loading::spectrum) {
    remarks.push_back(
        fmt::format("beside the spectrum: as constant-amplitude loading (EN 1993-1-9 7.1(2), no "
                    "damage below {} of the "
                    "category) the governing fatigue factor would be {}",
                    "0.737", text::significant(fatigue->basis->constant_amplitude_factor, 3)));
  }
  if (verification.equivalent_mass) {
    const auto& mass = *verification.equivalent_mass;
    const auto& demand = *project.equivalent_mass;
    const auto& body = planar_of(project).bodies[static_cast<std::size_t>(demand.adjust)];
    std::string remark = fmt::format(
        "the mechanism feels like {} at {}; for {} there the {} would have to be {}",
        text::kilograms(mass.given),
        planar_of(project).joints[static_cast<std::size_t>(demand.joint)].name,
        text::kilograms(demand.wanted.value()), body.name, text::kilograms(mass.needed));
    if (mass.needed < 0.0) remark += " (below zero: this equivalent mass cannot be reached)";
    remarks.push_back(std::move(remark));
  }
}

/// Situations whose own ranges do not count in fatigue, though their loads change.
void add_uncounted(const Project& project, const std::vector<MotionSummary>& motions,
                   std::vector<std::string>& remarks) {
  const std::vector<Situation>& all = project.situations;
  if (!project.fatigue.asked || all.size() < 2) return;
  std::vector<std::string> for_strength, for_change;
  for (const MotionSummary& motion : motions) {
    const Situation& of = all[motion.situation];
    if (motion.stands_still || of.cycles != 0.0) continue;
    const auto is_part = [&](const Situation& whole) {
      return std::find(whole.between.begin(), whole.between.end(), motion.situation) !=
             whole.between.end();
    };
    const auto counts_it = [&](const Situation& whole) { return whole.in_order && is_part(whole); };
    if (std::none_of(all.begin(), all.end(), is_part))
      for_strength.push_back("\"" + of.name + "\"");
    else if (std::none_of(all.begin(), all.end(), counts_it))
      for_change.push_back("\"" + of.name + "\"");
  }
  if (!for_strength.empty())
    remarks.push_back(fmt::format("without cycles, for strength and not for fatigue: {}",
                                  fmt::join(for_strength, ", ")));
  if (!for_change.empty())
    remarks.push_back(
        fmt::format("without cycles of their own: {}; of their ranges only the "
                    "outermost count, in the change between them",
                    fmt::join(for_change, ", ")));
}

void add_motion(const Project& project, const MotionSummary& motion,
                std::vector<std::string>& remarks) {
  const Situation& situation = project.situations[motion.situation];
  report::front_end_text_of(project)->add_remarks(motion, remarks);
  // Of a situation that only its sequence counts, the sequence says how it repeats.
  const double cycles = situation.cycles;
  if (cycles == 0.0) return;
  if (duration_of(project).length > 0.0) {
    remarks.push_back(
        fmt::format("one of the {:.6g} cycles of the fatigue demand is the whole time "
                    "looked at, {}",
                    cycles, text::seconds(motion.period.value())));
  }
  if (!motion.closed) {
    remarks.push_back(
        "the motion does not repeat by itself: ranges are those of the time looked at, taken as "
        "repeated from its end to its beginning once per cycle");
  }
}

/// Elastic links: what a sudden start adds to the steady vibration, in the joint where it is most.
void add_sudden_start(const Project& project, const Verification& verification,
                      std::vector<std::string>& remarks) {
  if (!verification.pictures.elastic || verification.pictures.elastic->after_start.at.empty())
    return;
  const bool counted = std::any_of(project.situations.begin(), project.situations.end(),
                                   [](const Situation& each) { return each.sudden_start; });
  if (counted) return;
  const JointLines& steady = verification.pictures.elastic->over_period;
  const JointLines& started = verification.pictures.elastic->after_start;
  const auto largest = [](const JointLines& lines, std::size_t joint) {
    const std::vector<double>& force = lines.force[joint];
    return force.empty() ? 0.0 : *std::max_element(force.begin(), force.end());
  };
  double size = 0.0;
  for (std::size_t j = 0; j < steady.names.size(); ++j) size = std::max(size, largest(steady, j));
  // Of a joint that bears next to nothing a ratio says nothing.
  constexpr double bears = 0.01;
  std::size_t worst = 0;
  double ratio = 0.0;
  for (std::size_t j = 0; j < steady.names.size(); ++j) {
    const double force = largest(steady, j);
    if (force <= bears * size || largest(started, j) <= ratio * force) continue;
    worst = j;
    ratio = largest(started, j) / force;
  }
  if (ratio <= 1.0) return;
  const std::string& name = project.situations[verification.motions.front().situation].name;
  const std::string where = name.empty() ? "" : fmt::format("situation \"{}\": ", name);
  remarks.push_back(
      fmt::format("{}steady vibration; after a sudden start joint {} reaches {} where the steady "
                  "vibration has {}: strength and fatigue take the steady one; a situation with "
                  "sudden_start = true counts the start",
                  where, steady.names[worst], text::kN(largest(started, worst)),
                  text::kN(largest(steady, worst))));
}

void add_missing(const Project& project, const Verification& verification,
                 std::vector<std::string>& remarks) {
  if (!project.fatigue.asked) {
    remarks.push_back("the case has no [fatigue]: strength only is checked");
  } else if (verification.governing(Criterion::fatigue) == nullptr) {
    remarks.push_back("no point of the beam has a stress range: there is no fatigue check");
  }
  for (const RodInput& rod : project.rods) {
    const auto has = [&](Criterion criterion) {
      return std::any_of(verification.neighbours.begin(), verification.neighbours.end(),
                         [&](const NeighbourResult& of) {
                           return of.check.criterion == criterion && of.check.point == rod.name;
                         });
    };
    const bool pulled = has(Criterion::rod), pressed = has(Criterion::buckling);
    if (pulled && !pressed) {
      remarks.push_back(
          fmt::format("rod {} is never compressed, or its compression could not be "
                      "judged: it has no check of buckling",
                      rod.name));
    } else if (pressed && !pulled) {
      remarks.push_back(
          fmt::format("rod {} is never in tension: it has no check of tension", rod.name));
    }
  }
}

/// ", rods" where there are no checks of any, or none of some; else what their checks leave out.
std::string rods_not_checked(const Project& project, const Verification& verification) {
  if (project.rods.empty()) return ", rods";
  std::vector<std::string> missing;
  for (const RodInput& rod : project.rods) {
    const bool checked =
        std::any_of(verification.neighbours.begin(), verification.neighbours.end(),
                    [&](const NeighbourResult& of) {
                      return of.check.criterion != Criterion::pin && of.check.point == rod.name;
                    });
    if (!checked) missing.push_back(rod.name);
  }
  if (missing.size() == project.rods.size()) return ", rods";
  if (missing.empty()) return ", bending of rods by their own weight and inertia";
  return fmt::format(", rods ({}; of the others bending by their own weight and inertia)",
                     fmt::join(missing, ", "));
}

std::string second_order_not_checked(const ModelChoice& model) {
  if (knows_second_order(model)) return "";
  const SecondOrderEstimate& of = model.second_order;
  return fmt::format(", second order (bending by N w{})",
                     of.change ? ": " + text::percent(*of.change) + " estimated" : std::string());
}

/// What a case says that changes nothing.
void add_without_effect(const Project& project, const SecondOrderEstimate& stability,
                        std::vector<std::string>& remarks) {
  const bool held_in_plane =
      std::any_of(project.restraints.begin(), project.restraints.end(),
                  [](const Restraint& restraint) { return restraint.along_z; });
  if (held_in_plane && stability.whole)
    remarks.push_back(
        "what [[beam.restraints]] hold along z does not count: the mechanism holds the beam in the "
        "plane of motion");
  const bool torque_by =
      std::any_of(project.beam.introductions.begin(), project.beam.introductions.end(),
                  [](const LoadIntroduction& of) { return of.torque_by.has_value(); });
  if (torque_by && !project.in_space)
    remarks.push_back(
        "torque_by of [[beam.load_introductions]] does not count: a case in the plane has no "
        "torque");
}

}  // namespace

std::string Remark::whole() const {
  switch (kind) {
    case Kind::assumed: return "assumed: " + text;
    case Kind::not_applicable: return "not applicable: " + text;
    case Kind::other: return text;
  }
  return text;
}

std::vector<Remark> remarks_of(const Project& project, const Verification& verification) {
  using Kind = Remark::Kind;
  std::vector<Remark> all;
  for (const std::string& assumption : project.assumptions) {
    all.push_back({Kind::assumed, assumption});
  }
  const SecondOrderEstimate& stability = verification.model.second_order;
  for (std::string& assumption : assumed_holds_of(stability, project.in_space))
    all.push_back({Kind::assumed, std::move(assumption)});
  for (const std::string& remark : project.header.remarks) all.push_back({Kind::other, remark});
  for (std::string& odd : odd_things(project, verification)) {
    all.push_back({Kind::other, std::move(odd)});
  }
  for (GateText& gate : gate_texts_of(verification)) {
    all.push_back({gate.blocks ? Kind::not_applicable : Kind::other, std::move(gate.text)});
  }
  std::vector<std::string> remarks;
  report::add_details(project, remarks);
  report::add_pressed(verification, remarks);
  report::front_end_text_of(project)->add_remarks(remarks);
  for (const MotionSummary& motion : verification.motions) {
    const std::size_t before = remarks.size();
    add_motion(project, motion, remarks);
    const std::string& name = project.situations[motion.situation].name;
    for (std::size_t i = before; i < remarks.size() && !name.empty(); ++i) {
      remarks[i] = fmt::format("situation \"{}\": {}", name, remarks[i]);
    }
  }
  add_uncounted(project, verification.motions, remarks);
  add_whole_records(verification, remarks);
  add_sudden_start(project, verification, remarks);
  add_missing(project, verification, remarks);
  report::add_short_lives(project, remarks);
  add_beside(project, verification, remarks);
  if (project.given_stresses.empty()) report::add_tapers(verification, remarks);
  if (!project.strength.shear_lag) {
    remarks.push_back(
        "shear lag is left out, as the case asks: flanges count with their whole width");
  }
  report::add_warping(project, remarks);
  report::add_holes(project, remarks);
  report::add_lugs(project, remarks);
  report::add_thin_welds(project, remarks);
  report::add_unsaid_welds(verification, remarks);
  add_published(project, verification, remarks);
  report::add_joined_profiles(project, remarks);
  report::add_nested_profiles(project, remarks);
  report::add_slender_plates(project, verification, remarks);
  add_without_effect(project, stability, remarks);
  if (const auto& lateral = stability.lateral)
    remarks.push_back(
        lateral_text(*lateral) +
        (lateral->part > 0.0 && lateral->part <= no_turning_over_below
             ? fmt::format(", which does not count (up to {}, EN 1993-1-1, 6.3.2.2(4))",
                           no_turning_over_below)
             : std::string()));
  remarks.push_back(
      "not checked here: " + report::shape_text(project) +
      (project.given_stresses.empty() && forces_are_looked_at(project)
           ? std::string()
           : fmt::format(", webs{} where forces come in ([[beam.load_introductions]])",
                         report::has_fillet_seams(project) ? " and their seams" : "")) +
      std::string(verification.model.second_order.lateral ? "" : ", lateral torsional buckling") +
      std::string(project.pins.empty() ? ", pins" : "") + rods_not_checked(project, verification) +
      (project.deflection ? "" : ", deflection") + second_order_not_checked(verification.model));
  for (std::string& remark : remarks) all.push_back({Kind::other, std::move(remark)});
  return all;
}

}  // namespace boxbeam
