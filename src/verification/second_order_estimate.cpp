#include "boxbeam/verification/second_order_estimate.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "beam_alone.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/design_factor.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/loaded_posture.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "lateral_instants.hpp"
#include "pressed_vibration.hpp"
#include "second_order_growth.hpp"
#include "vibration_in_space.hpp"
#include "whole_in_space.hpp"
#include "yield_shares.hpp"

namespace boxbeam {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Less than this part of N_cr counts nowhere: of a cantilever as long as the beam
/// (`cantilever_load_of`), and of the whole in space.
constexpr double hardly_compressed = 0.01;

constexpr const char* held_by_mechanism = "held as its mechanism holds it";

/// How a beam is held at an instant, in both planes.
struct Held {
  MakePosture in_plane, across;
  BeamHolds alone;
  bool whole = false;     ///< in the plane by its mechanism
  bool in_space = false;  ///< by a mechanism in space, as one
};

/// The instants of a situation that are compared.
struct LookedAt {
  BothCompared in_plane, across;  ///< of the beam held in its planes
  BothCompared in_space;          ///< of the whole in space
};

/// Where forces act: in between, the moments of beams have no peak but under loads along them. Only
/// in frames do they move.
std::vector<Length> loaded_places_of(const Project& project, const std::deque<SituationRun>& runs) {
  const bool move = std::holds_alternative<frame::Structure>(project.mechanism);
  std::vector<Length> places;
  for (const SituationRun& run : runs) {
    std::vector<std::size_t> instants{0};
    if (move) instants = instants_of(run.loads);
    for (const std::size_t i : instants) {
      const BeamLoads loads = run.loads.loads_at(run.loads.time_of(i));
      for (const PointLoad& load : loads.points) places.push_back(load.s);
    }
  }
  return places;
}

/// Whether a segment is of open thin walls, which may twist under compression.
bool may_twist(const TaperedBeam& beam) {
  return std::any_of(beam.segments.begin(), beam.segments.end(), [](const Segment& segment) {
    return std::holds_alternative<ThinWalled>(segment.from.outer);
  });
}

class Estimating {
 public:
  Estimating(const Project& project, const std::deque<SituationRun>& runs)
      : project_(&project),
        cantilever_(cantilever_load_of(project)),
        shares_(project, compared_places_of(project.beam, loaded_places_of(project, runs))),
        lateral_(project),
        in_plane_(project, Plane::z),
        across_(project, Plane::y) {
    if (std::holds_alternative<spatial::Mechanism>(project.mechanism))
      places_in_space_ = places_in_space(project.beam, loaded_places_of(project, runs));
    result_.growth = no_growth();
    result_.whole = true;
    result_.across.emplace();
    result_.change = 0.0;
  }

  void look_at(const SituationRun& run) {
    const double factor = design_factor_of(*project_, *run.situation);
    LookedAt all;
    auto& [compared, across, in_space] = all;
    const std::vector<std::size_t> few = instants_of(run.loads, few_instants);
    for (const std::size_t i : few) look_at(run, i, i == few.front(), factor, all);
    if (reaches_anything(all)) {
      for (const std::size_t i : instants_of(run.loads))
        if (std::find(few.begin(), few.end(), i) == few.end()) look_at(run, i, false, factor, all);
    }
    raise_bending(compared.design, factor);
    lateral_.look_at_all(run, factor);
    if (!result_.change) return;
    for (const BothCompared* const of : {&compared, &in_space})
      if (of->design.straight.rows() > 0)
        result_.change = std::max(*result_.change, of->design.relative());
    growth_in_space_.add(in_space.design, in_space.of_once(factor), factor);
    growth_.add(compared.design, compared.of_once(factor), factor);
    growth_across_.add(shares_.with_modulus_across(across.design),
                       shares_.with_modulus_across(across.of_once(factor)), factor);
    if (factor > 1.0) {
      add_beyond_once(compared, factor, beyond_once_);
      add_beyond_once(in_space, factor, beyond_in_space_);
    }
    look_at_sway(run, factor);
    look_at_vibration(run, factor);
    // By the section modulus of the other plane, which a ratio does not know.
    if (across.design.straight.rows() > 0) {
      result_.change = std::max(*result_.change, across.design.relative());
    }
  }

  /// The largest of all instants, where the beam as a member counts or may twist; of the bent beam
  /// as a bow's.
  void take_extremes(const std::deque<SituationRun>& runs) {
    const auto counts = [](double part) { return part > no_buckling_below; };
    if (!may_twist(project_->beam) && !counts(result_.in_plane.part) &&
        !(result_.across && counts(result_.across->part)) &&
        !(lateral_.most().part > no_turning_over_below))
      return;
    double& straight = result_.straight;
    // What is counted across grows as a bow across does; the excess by the plane that is worse, and
    // as under N beside the axis all along, by sec(pi/2 sqrt(n)), which (1 + 0.28 n)/(1 - n) is not
    // below (Timoshenko, Gere, section 1.13).
    const double bow = result_.across ? result_.across->part : 0.0;
    const double nearer = std::max(bow, result_.in_plane.part);
    const double ahead =
        nearer < 1.0 && bow < 1.0 ? (1.0 - bow) * (1.0 + 0.28 * nearer) / (1.0 - nearer) : 1.0;
    for (const SituationRun& run : runs) {
      const double factor = design_factor_of(*project_, *run.situation);
      for (std::size_t i = 0; i < run.loads.instants(); ++i) {
        const CutForceDiagram diagram = run.loads.diagram(i);
        result_.compressed = std::max(result_.compressed, factor * shares_.compression(diagram));
        straight = std::max(straight, factor * shares_.bending(diagram));
        const double across = project_->in_space ? shares_.bending_across(diagram) : 0.0;
        result_.bending_across =
            std::max(result_.bending_across, factor * (across + ahead * shares_.excess(diagram)));
      }
    }
    const double grown = result_.in_plane.part < 1.0 ? 1.0 / (1.0 - result_.in_plane.part) : 1.0;
    result_.bending = std::max(result_.bending, grown * straight);
  }

  SecondOrderEstimate result() {
    growth_.add_to(result_.growth);
    growth_across_.add_to(result_.growth);
    growth_in_space_.add_to(result_.growth);
    if (!result_.growth.empty()) raise_by_vibration();
    result_.lateral = lateral_.most();
    for (StressGrowth& of : result_.growth) of.range = std::max(of.range, sway_of_range_);
    return std::move(result_);
  }

  /// What design loads add to the stress of a beam that is bent by its loads times one.
  std::vector<StressGrowth> beyond_once() const {
    std::vector<StressGrowth> growth = no_growth();
    beyond_once_.add_to(growth);
    beyond_in_space_.add_to(growth);
    for (StressGrowth& of : growth) of.range = 0.0;
    return growth;
  }

 private:
  /// Of each place.
  std::vector<StressGrowth> no_growth() const {
    std::vector<StressGrowth> growth;
    for (const ComparedPlace& place : shares_.places()) growth.push_back({place.station});
    return growth;
  }

  /// Of an instant. `first`: what else is pressed is looked at then, if never again.
  void look_at(const SituationRun& run, std::size_t i, bool first, double factor, LookedAt& all) {
    const Time time = run.loads.time_of(i);
    const BeamLoads loads = run.loads.loads_at(time);
    const Held held = held_at(run, time, loads);
    const std::size_t situation = index_of(*project_, *run.situation);
    const CutForceDiagram diagram = cut_forces_of(loads);
    const auto raise = [&](BucklingLoad& load, const MakePosture& make, const std::string& words,
                           bool assumed) {
      const double part = factor * part_of_critical(make, load.part / factor);
      // Of an instant whose part is not above the largest so far, no more than that is known.
      constexpr double round_off = 1e-12;
      if (part > load.part * (1.0 + round_off)) load = {part, time, situation, words, assumed};
    };
    const BeamHolds& alone = held.alone;
    const bool axial = bears_axial_force(diagram);
    const bool counts = axial && factor * compression_of(diagram) > hardly_compressed * cantilever_;
    // What else is pressed is looked at once, other beams whenever this one is.
    const bool looked = counts || first || !project_->elastic_beside.empty();
    const auto whole = looked && held.in_space
                           ? part_of_whole(run, time, diagram, factor, hardly_compressed)
                           : std::nullopt;
    if (held.whole)
      raise(result_.in_plane, held.in_plane, held_by_mechanism, false);
    else if (axial)
      raise(result_.in_plane, held.in_plane, alone.along_z.words, !alone.along_z.said && !whole);
    if (axial)
      raise(*result_.across, held.across, alone.along_y.words, !alone.along_y.said && !whole);
    const BentWhole bent = held.in_space ? bent_whole(run, time, diagram, factor) : BentWhole();
    result_.turn = std::max(result_.turn, bent.turn);
    if (!held.whole && !bent.known) result_.whole = false;
    if (whole)
      raise_by_whole({*whole, time, situation, held_by_mechanism, false}, factor, bent.known);
    if (bent.part > result_.across->part)
      *result_.across = {bent.part, time, situation, held_by_mechanism, false};
    lateral_.look_at(run, time, diagram, loads, alone.turning, factor);
    result_.bending = std::max(result_.bending, factor * shares_.bending(diagram));
    if (result_.in_plane.part >= 1.0 || result_.across->part >= 1.0) {
      result_.change.reset();
      result_.growth.clear();
      return;
    }
    if (bent.known) {
      compare_in_space(diagram, bent, factor, all.in_space);
      return;
    }
    compare(held.in_plane, held.whole, loads, factor, all.in_plane);
    if (project_->in_space)
      compare(held.across, false, in_plane(loads, Plane::y), factor, all.across);
  }

  void compare_in_space(const CutForceDiagram& diagram, const BentWhole& bent, double factor,
                        BothCompared& both) {
    const CutForceDiagram added = cut_forces_of(bent.design);
    const auto corners = [&](const CutForceDiagram& of) -> Eigen::ArrayXd {
      return stresses_at(of, places_in_space_).transpose().array();
    };
    const Eigen::ArrayXd straight = corners(diagram);
    both.design.add(straight, corners(added));
    if (factor != 1.0) both.once.add(straight, corners(cut_forces_of(bent.once)));
    Compared in_plane;
    in_plane.add(fibre_stresses(diagram, shares_.places()),
                 fibre_stresses(added, shares_.places()));
    raise_bending(in_plane, factor);
  }

  /// Whether instants between those looked at may matter: the beam's compression and bending have
  /// no higher peak there, and a tenth of what leaves a member alone, and of what is tolerated,
  /// leaves room for postures that hold it worse.
  bool reaches_anything(const LookedAt& all) const {
    constexpr double slight = 0.1;
    const auto counts = [](double part) { return part > slight * no_buckling_below; };
    const auto changes = [&](const Compared& of) {
      return of.straight.rows() > 0 && of.relative() > slight * project_->model.tolerance;
    };
    return !result_.change || counts(result_.in_plane.part) || counts(result_.across->part) ||
           result_.sway > 0.0 || changes(all.in_plane.design) || changes(all.across.design) ||
           changes(all.in_space.design);
  }

  Held held_at(const SituationRun& run, Time time, const BeamLoads& loads) {
    Held held;
    held.alone = holds_of(*project_, run.motion->supports(loads));
    held.in_space = held_by_whole(*project_, held.alone);
    held.across = across_.under(loads, held.alone.along_y.at);
    held.in_plane = run.motion->stopped(time, loads);
    held.whole = static_cast<bool>(held.in_plane);
    if (!held.whole) held.in_plane = in_plane_.under(loads, held.alone.along_z.at);
    return held;
  }

  /// The bent beam under its loads times one, and its axial force times the design factor.
  void compare(const MakePosture& make, bool whole, const BeamLoads& loads, double factor,
               BothCompared& both) {
    const Eigen::ArrayXd straight = fibre_stresses(cut_forces_of(loads), shares_.places());
    const bool unloaded = !whole && (straight == 0.0).all();
    const auto bent_by = [&](double times) -> Eigen::ArrayXd {
      if (unloaded) return Eigen::ArrayXd(straight);
      const SecondOrder bent = second_order_of(make(times));
      if (times == factor) result_.turn = std::max(result_.turn, factor * bent.turn);
      return fibre_stresses(cut_forces_of(bent.loads), shares_.places());
    };
    both.design.add(straight, bent_by(factor));
    if (factor != 1.0) both.once.add(straight, bent_by(1.0));
  }

  /// By what was compared in the plane of motion.
  void raise_bending(const Compared& of, double factor) {
    result_.bending = std::max(result_.bending, shares_.bending(of, factor));
  }

  static void add_beyond_once(const BothCompared& both, double factor, GrowthByPlace& sum) {
    const Compared beyond{both.once.straight + both.once.change,
                          both.design.change - both.once.change};
    sum.add(beyond, beyond, factor);
  }

  /// Elastic links vibrate as they are when nothing presses them.
  void look_at_vibration(const SituationRun& run, double factor) {
    constexpr double unpressed = 1e-4;
    if (!std::holds_alternative<flexible::Mechanism>(project_->mechanism)) return;
    if (result_.in_plane.part < unpressed) return;
    try {
      const BothCompared both = pressed_vibration_of(*project_, run, factor, shares_.places());
      result_.change = std::max(*result_.change, both.design.relative());
      raise_bending(both.design, factor);
      vibrating_.add(both.design, both.of_once(factor), factor);
    } catch (const AnalysisError&) {
      result_.sway = sway_of_range_ = unbounded;
    }
  }

  void raise_by_vibration() {
    std::vector<StressGrowth> vibrating = no_growth();
    vibrating_.add_to(vibrating);
    raise_to(vibrating, result_.growth);
  }

  /// By the whole, whose planes are one: where it is weaker than the beam by itself in either, that
  /// is how it buckles, and what it bends grows as of a frame that sways, unless it is `bent`.
  void raise_by_whole(const BucklingLoad& whole, double factor, bool bent) {
    constexpr double alike = 1.001;
    if (!(whole.part > alike * std::max(result_.in_plane.part, result_.across->part))) return;
    *result_.across = whole;
    if (bent && whole.part < 1.0) return;
    const auto sway = [](double part) { return part < 1.0 ? part / (1.0 - part) : unbounded; };
    result_.sway = std::max(result_.sway, sway(whole.part));
    sway_of_range_ = std::max(sway_of_range_, sway(whole.part / factor));
  }

  /// The whole that carries the beam, under its design loads and, for ranges, its loads times one.
  void look_at_sway(const SituationRun& run, double factor) {
    constexpr double slight = 100.0;  // times its loads
    const auto whole = run.motion->critical_factor(run.loads, slight * factor);
    if (!whole || !(*whole < slight * factor)) return;
    const auto sway = [&](double times) { return 1.0 / std::max(*whole / times - 1.0, 0.0); };
    result_.sway = std::max(result_.sway, sway(factor));  // may be infinite
    sway_of_range_ = std::max(sway_of_range_, sway(1.0));
  }

  const Project* project_;
  double cantilever_;  ///< N_cr of one as long as the beam, of its least I [N]
  YieldShares shares_;
  std::vector<PlaceInSpace> places_in_space_;  ///< the same, of a mechanism in space
  LateralInstants lateral_;
  BeamAlone in_plane_, across_;
  GrowthByPlace growth_, growth_across_, beyond_once_, vibrating_;
  GrowthByPlace growth_in_space_{stresses_of_place}, beyond_in_space_{stresses_of_place};
  double sway_of_range_ = 0.0;
  SecondOrderEstimate result_;
};

}  // namespace

SecondOrderEstimate estimate_second_order(const Project& project,
                                          const std::deque<SituationRun>& runs) {
  return estimate_designed_second_order(project, runs).estimate;
}

DesignedSecondOrder estimate_designed_second_order(const Project& project,
                                                   const std::deque<SituationRun>& runs) {
  Estimating estimating(project, runs);
  for (const SituationRun& run : runs) estimating.look_at(run);
  estimating.take_extremes(runs);
  std::vector<StressGrowth> beyond_once = estimating.beyond_once();
  return {estimating.result(), std::move(beyond_once)};
}

}  // namespace boxbeam
