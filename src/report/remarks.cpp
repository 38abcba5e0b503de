#include "boxbeam/report/remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "attachment_places.hpp"
#include "boxbeam/report/format.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/strength/weld_throat.hpp"
#include "boxbeam/verification/patch_checks.hpp"
#include "boxbeam/verification/plausibility.hpp"
#include "boxbeam/verification/verdict_text.hpp"
#include "front_end_text.hpp"

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

void add_details(const Project& project, std::vector<std::string>& remarks) {
  const FatigueInput& fatigue = project.fatigue;
  const auto add = [&](const BeamDetail& of, const std::string& where) {
    const Detail& detail = of.detail;
    if (!of.assumed.empty()) {
      remarks.push_back(fmt::format("detail category {} is assumed for the {} at {}: {}",
                                    detail.curve.name, detail.name, where, of.assumed));
    }
    if (detail.unconfirmed) {
      remarks.push_back(fmt::format(
          "unconfirmed: the figures of {} {} for the {} at {} are recalled, not read in the code",
          detail.row.empty() ? detail.curve.code : "row " + detail.row,
          detail.row.empty() ? detail.curve.name : "(category " + detail.curve.name + ")",
          detail.name, where));
    }
    if (detail.deciding.empty()) return;
    remarks.push_back(fmt::format(
        "the {} at {} can be {} rows of the tables; the weakest, {} (category {}), is taken; to "
        "know: {}",
        detail.name, where, detail.candidates.size(), detail.row, detail.curve.name,
        fmt::join(detail.deciding, ", ")));
  };
  const auto place = [](const BeamDetail& of) {
    std::string where = "s = " + text::significant(of.from.value(), 3);
    if (of.to > of.from) where += " to " + text::significant(of.to.value(), 3);
    return where + " m";
  };
  add(fatigue.beam, "the whole beam");
  for (const BeamDetail& detail : fatigue.details) add(detail, place(detail));
  for (const report::AlikeWelds& of : report::alike_welds_of(fatigue)) add(*of.detail, of.where);
  for (const BeamHole& at : project.holes) {
    if (at.detail) add(*at.detail, "hole " + at.hole.name);
  }
  for (const WeldInput& weld : project.welds) {
    if (fatigue.asked) add(weld.toe, "weld " + weld.name);
  }
  for (const PinInput& pin : project.pins) {
    for (const LugInput& lug : pin.lugs) {
      if (fatigue.asked)
        add(lug.detail,
            fmt::format("pin {}, {}", pin.name, lug.inner ? "inner plate" : "outer plates"));
    }
  }
}

/// Rows that judge what forces press into webs.
void add_pressed(const Verification& verification, std::vector<std::string>& remarks) {
  for (const CheckResult& result : verification.checks) {
    if (!result.pressed) continue;
    const Detail& detail = result.pressed->life.point.detail->detail;
    if (!detail.unconfirmed) continue;
    std::string remark = fmt::format(
        "unconfirmed: the figures of row {} (category {}) for the {} under forces are recalled, "
        "not read in the code",
        detail.row, detail.curve.name, detail.name);
    if (std::find(remarks.begin(), remarks.end(), remark) == remarks.end())
      remarks.push_back(std::move(remark));
  }
}

/// Plates of pins of which the case does not say what their fatigue asks for.
void add_lugs(const Project& project, std::vector<std::string>& remarks) {
  if (!project.fatigue.asked) return;
  for (const PinInput& pin : project.pins) {
    const auto said = [&](bool inner) {
      return std::any_of(pin.lugs.begin(), pin.lugs.end(),
                         [&](const LugInput& lug) { return lug.inner == inner; });
    };
    if (said(true) && said(false)) continue;
    remarks.push_back(fmt::format(
        "pin {}: the fatigue of its {} is not judged, nor what stands beside and before the hole "
        "(EN 1993-1-8, table 3.9): [[pins.lugs]] say how wide they are",
        pin.name,
        said(true)    ? "outer plates"
        : said(false) ? "inner plate"
                      : "plates"));
  }
}

void add_thin_welds(const Project& project, std::vector<std::string>& remarks) {
  for (const WeldInput& weld : project.welds) {
    if (weld.full || weld.throat >= least_throat()) continue;
    remarks.push_back(fmt::format(
        "weld {} has a throat of {}, below 3 mm, the least of a fillet weld (EN 1993-1-8, "
        "4.5.2(2))",
        weld.name, text::mm(weld.throat.value())));
  }
}

void add_unsaid_welds(const Verification& verification, std::vector<std::string>& remarks) {
  if (!verification.unsaid_welds || !verification.unsaid_welds->throat) return;
  const UnsaidWelds& of = *verification.unsaid_welds;
  const double halves = 0.5e-3 * std::ceil((1.0 - 1e-9) * of.throat->value() / 0.5e-3);
  remarks.push_back(fmt::format(
      "the welds of diaphragms that take forces are not said: throats of {:g} mm on both their "
      "faces "
      "bear them, by {} at s = {} m (EN 1993-1-8, 4.5.3.2); [[beam.diaphragms]] say their throat",
      1e3 * halves, of.under, to_text(Station{of.s, Side::both})));
}

void add_holes(const Project& project, std::vector<std::string>& remarks) {
  const bool by_beam =
      std::any_of(project.holes.begin(), project.holes.end(),
                  [](const BeamHole& at) { return at.concentration && !at.detail; });
  if (!by_beam || !project.given_stresses.empty()) return;
  remarks.push_back(
      "at hole edges without a detail of their own the largest local stress around the edge "
      "(concentration included) is compared, as modified nominal stress, with the category of the "
      "beam; where that is one for holes on the net section, this counts the hole twice");
}

bool has_fillet_seams(const Project& project) {
  const auto filleted = [](const Section& section) {
    const auto* const box = std::get_if<Box>(&section.outer);
    return box != nullptr && box->seam_throat > Length{};
  };
  return std::any_of(project.beam.segments.begin(), project.beam.segments.end(),
                     [&](const Segment& of) { return filleted(of.from) || filleted(of.to); });
}

void add_slender_plates(const Project& project, const Verification& verification,
                        std::vector<std::string>& remarks) {
  // Where nothing is used more than by yielding no plate is among the checks.
  const auto judged_by = [&](PlateRoute route) {
    const bool reduced = route == PlateRoute::reduced_stresses;
    return std::any_of(verification.checks.begin(), verification.checks.end(),
                       [&](const CheckResult& of) {
                         return of.plates && (of.plates->reduced != nullptr) == reduced;
                       });
  };
  const std::string panels =
      project.beam.diaphragms.size() > 1
          ? "as panels between diaphragms"
          : "as panels as long as the beam with end posts that are not rigid: "
            "[[beam.diaphragms]] would only help";
  if (judged_by(PlateRoute::effective_widths)) {
    remarks.push_back(
        "plates with c/t above 42 eps are judged by effective widths under N, M_y and M_z, each by "
        "the section where it acts alone (EN 1993-1-5, clause 4, one pass), and in shear (clause "
        "5), without the flanges' part, " +
        panels);
  }
  if (std::any_of(verification.checks.begin(), verification.checks.end(),
                  [](const CheckResult& of) { return of.path.has_value(); })) {
    remarks.push_back(
        "paths with walls beyond class 3 are judged by effective widths under N, M_y and M_z, each "
        "by the section where it acts alone, step by step until that stays (EN 1993-1-5, clause "
        "4), "
        "in shear (clause 5) without the flanges' part, and by both together (7.1); " +
        panels);
  }
  if (judged_by(PlateRoute::reduced_stresses)) {
    remarks.push_back(
        "boxes with plates of c/t above 42 eps are judged by reduced stresses (EN 1993-1-5, clause "
        "10): each plate on the gross section under all that acts on it at an instant, where "
        "forces come into a web with them (6.4, annex B.1, recalled), " +
        panels);
  }
  for (const SegmentRoute& of : verification.routes) {
    if (of.reason.empty()) continue;
    remarks.push_back(fmt::format(
        "segment {} is judged by reduced stresses, for {}: its plates as rectangles of their "
        "largest width between diaphragms, normal stress along the edge, sigma/cos^2",
        of.segment, of.reason));
  }
}

void add_tapers(const Verification& verification, std::vector<std::string>& remarks) {
  std::vector<std::string> slopes;
  double steepest = 0.0;
  for (const TaperSlope& taper : verification.tapers) {
    const double degrees = taper.angle * 180.0 / std::numbers::pi;
    slopes.push_back(fmt::format("{} {:.1f} deg", taper.segment, degrees));
    steepest = std::max(steepest, degrees);
  }
  if (slopes.empty()) return;
  // Wedge under a tip force (Timoshenko and Goodier): M/W is 0.9939 of the exact edge stress at a
  // half-angle of 10 deg, 0.9861 at 15 deg.
  remarks.push_back(fmt::format(
      "flanges slope (segment {}): the shear is that of equilibrium, d/dx(M S/I), which leaves "
      "with "
      "them what they carry of V; V S/(I b) stands beside it in the calculation sheet{}",
      fmt::join(slopes, ", "),
      steepest > 10.0 ? "; M/W is 0.6 to 1.4 % low at the edge between 10 and 15 deg" : ""));
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

}  // namespace

namespace {

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

void add_warping(const Project& project, std::vector<std::string>& remarks) {
  const auto& segments = project.beam.segments;
  const bool path = std::any_of(segments.begin(), segments.end(), [](const Segment& segment) {
    return std::holds_alternative<ThinWalled>(segment.from.outer);
  });
  if (!project.in_space || !path) return;
  remarks.push_back(
      "torsion of thin-walled paths is Saint-Venant's, with free warping: where warping is held, "
      "as "
      "at a clamped end, an open section has normal stresses of warping besides, which are not "
      "counted");
}

/// What is taken for granted of the shape of sections and their torsion.
std::string shape_text(const Project& project) {
  const auto is_open = [](const Segment& segment) {
    const auto* const path = std::get_if<ThinWalled>(&segment.from.outer);
    return path != nullptr && !segment.from.inner && !(enclosed_area_of(*path).value() > 0.0);
  };
  const auto& segments = project.beam.segments;
  const bool all = std::all_of(segments.begin(), segments.end(), is_open);
  if (project.in_space) {
    return all ? "warping, whether open sections keep their shape"
               : "warping, distortion but of boxes, rectangular tubes and paths around one "
                 "rectangle";
  }
  std::string text =
      all ? ""
          : "warping and distortion of the box (diaphragms where forces act are taken for granted; "
            "a case in the plane has no torque, and forces beside the middle of a box, as of an "
            "eccentric rail, are a case in space)";
  if (std::any_of(segments.begin(), segments.end(), is_open)) {
    text += text.empty() ? "" : ", ";
    text +=
        "whether open sections keep their shape where forces act (a case in the plane has these on "
        "the axis, about which they turn a section whose shear centre is beside it; others are a "
        "case in space)";
  }
  return text;
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

void add_short_lives(const Project& project, std::vector<std::string>& remarks) {
  if (!project.fatigue.asked || most_cycles_of(project) >= 1e4) return;
  remarks.push_back(
      "fewer than 1e4 cycles: the S-N lines of EN 1993-1-9 begin at 1e4, the strength shown is "
      "extrapolated and the yield check decides");
}

}  // namespace

namespace {

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

}  // namespace

namespace {

/// Where one profile ends and another begins: a weld that nobody described carries what is cut.
void add_joined_profiles(const Project& project, std::vector<std::string>& remarks) {
  const std::vector<Segment>& segments = project.beam.segments;
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    if (segments[i].to.outer == segments[i + 1].from.outer) continue;
    const Length s = segments[i].end();
    const bool described = std::any_of(project.welds.begin(), project.welds.end(),
                                       [&](const WeldInput& weld) { return weld.s == s; });
    if (described) continue;
    remarks.push_back(fmt::format(
        "not checked: the weld between {} and {} at s = {:.6g} m carries all that is cut there; "
        "[[welds]] with its throat checks throat, root and toe",
        segments[i].name, segments[i + 1].name, s.value()));
  }
}

/// Of V what crosses from an outer to an inner profile that does not bend about its own centroid:
/// 1 - sum I_c/I (shear_flow.hpp), in space of V_y as well.
double share_between(const Section& section, bool space) {
  if (!section.inner) return 0.0;
  const SectionProperties whole = properties_of(section);
  const SectionProperties outer = properties_of({section.outer, {}});
  const SectionProperties inner = properties_of({*section.inner, {}});
  const double upright = 1.0 - ((outer.I_y + inner.I_y) / whole.I_y).value();
  const double across = 1.0 - ((outer.I_z + inner.I_z) / whole.I_z).value();
  return space ? std::max(upright, across) : upright;
}

/// An inner profile and the outer one count as one section; what ties them together nobody
/// described.
void add_nested_profiles(const Project& project, std::vector<std::string>& remarks) {
  std::string names;
  double share = 0.0;
  for (const Segment& segment : project.beam.segments) {
    if (!segment.from.inner) continue;
    names += (names.empty() ? "" : ", ") + segment.name;
    for (const Section* end : {&segment.from, &segment.to})
      share = std::max(share, share_between(*end, project.in_space));
  }
  if (names.empty()) return;
  // Profiles about one centroid need no tie for V.
  constexpr double nothing = 1e-6;
  remarks.push_back(fmt::format(
      "not checked: what ties the outer and the inner profile of {} to one section{}", names,
      share > nothing ? fmt::format("; their centroids differ, and it carries up to {:.2g} % of V",
                                    100.0 * share)
                      : ""));
}

}  // namespace

namespace {

std::string second_order_not_checked(const ModelChoice& model) {
  if (knows_second_order(model)) return "";
  const SecondOrderEstimate& of = model.second_order;
  return fmt::format(", second order (bending by N w{})",
                     of.change ? ": " + text::percent(*of.change) + " estimated" : std::string());
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
  add_details(project, remarks);
  add_pressed(verification, remarks);
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
  add_short_lives(project, remarks);
  add_beside(project, verification, remarks);
  if (project.given_stresses.empty()) add_tapers(verification, remarks);
  if (!project.strength.shear_lag) {
    remarks.push_back(
        "shear lag is left out, as the case asks: flanges count with their whole width");
  }
  add_warping(project, remarks);
  add_holes(project, remarks);
  add_lugs(project, remarks);
  add_thin_welds(project, remarks);
  add_unsaid_welds(verification, remarks);
  add_published(project, verification, remarks);
  add_joined_profiles(project, remarks);
  add_nested_profiles(project, remarks);
  add_slender_plates(project, verification, remarks);
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
  if (const auto& lateral = stability.lateral)
    remarks.push_back(
        lateral_text(*lateral) +
        (lateral->part > 0.0 && lateral->part <= no_turning_over_below
             ? fmt::format(", which does not count (up to {}, EN 1993-1-1, 6.3.2.2(4))",
                           no_turning_over_below)
             : std::string()));
  remarks.push_back(
      "not checked here: " + shape_text(project) +
      (project.given_stresses.empty() && forces_are_looked_at(project)
           ? std::string()
           : fmt::format(", webs{} where forces come in ([[beam.load_introductions]])",
                         has_fillet_seams(project) ? " and their seams" : "")) +
      std::string(verification.model.second_order.lateral ? "" : ", lateral torsional buckling") +
      std::string(project.pins.empty() ? ", pins" : "") + rods_not_checked(project, verification) +
      (project.deflection ? "" : ", deflection") + second_order_not_checked(verification.model));
  for (std::string& remark : remarks) all.push_back({Kind::other, std::move(remark)});
  return all;
}

}  // namespace boxbeam
