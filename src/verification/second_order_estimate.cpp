#include "boxbeam/verification/second_order_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/link_profile.hpp"
#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/strength/column_buckling.hpp"
#include "boxbeam/strength/material.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/loaded_posture.hpp"
#include "boxbeam/verification/model_ladder.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "lateral_estimate.hpp"

namespace boxbeam {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr int parts = 16;
constexpr std::size_t spread = 48;  ///< instants looked at
constexpr std::size_t peaks = 3;    ///< and of largest compression

/// A plane of bending of the beam's own axes.
enum class Plane { z, y };

/// Stretches of a beam that bends in a plane.
std::vector<flexible::LinkStretch> stretches_in(const Project& project, Plane plane) {
  const double E = project.model.youngs_modulus;
  std::vector<flexible::LinkStretch> stretches =
      link_stretches_of(project.beam, E, project.model.shear_modulus);
  if (plane == Plane::z) return stretches;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Segment& segment = project.beam.segments[i];
    const double length = segment.length.value();
    stretches[i].EI = interpolate<4>(
        [&](double x) {
          const SectionProperties of =
              properties_of(interpolate(segment.from, segment.to, x / length));
          const double I_yz = of.I_yz.value();
          return E * (of.I_z.value() - I_yz * I_yz / of.I_y.value());
        },
        length);
    // Shear across a box bends its flanges as it does its webs: of little effect, and left out.
    for (double& c : stretches[i].GA.c) c = 0.0;
    stretches[i].GA.c[0] = 1e6 * stretches[i].EA(0.5 * length);
  }
  return stretches;
}

/// The loads of one plane as those of the plane of motion.
BeamLoads in_plane(BeamLoads loads, Plane plane) {
  if (plane == Plane::z) return loads;
  for (PointLoad& load : loads.points) {
    load.force = {load.force.x(), 0.0, load.force.y()};
    load.moment = {0.0, -load.moment.z(), 0.0};
  }
  for (LineLoad& line : loads.lines) {
    line.force[2] = line.force[1];
    line.couple[1] = -1.0 * line.couple[2];
  }
  return loads;
}

/// The beam alone on the ground, clamped at one place or pinned at two.
flexible::Mechanism beam_alone(const Project& project, Plane plane, const std::vector<double>& at) {
  flexible::Mechanism mechanism;
  flexible::Link& link = mechanism.links.emplace_back();
  link.name = "beam";
  link.length = project.beam.length().value();
  link.stretches = stretches_in(project, plane);
  link.parts = parts;
  const auto hold = [&](double s, const std::array<double, 3>& stiffness) {
    flexible::Joint& joint = mechanism.joints.emplace_back();
    joint.name = "support";
    joint.a = {0, {s, 0.0}};
    joint.b = {flexible::ground, {s, 0.0}};
    joint.stiffness = stiffness;
  };
  if (at.size() == 1) {
    hold(at.front(), {unbounded, unbounded, unbounded});
  } else {
    hold(at.front(), {unbounded, unbounded, 0.0});
    hold(at.back(), {0.0, unbounded, 0.0});
  }
  return mechanism;
}

/// The two outermost of some places, or one clamp where they are too near each other to hold.
std::vector<double> outermost(std::vector<double> places, double length) {
  if (places.empty()) return {0.0};
  const auto [low, high] = std::minmax_element(places.begin(), places.end());
  constexpr double near = 0.02;
  if (*high - *low < near * length) return {*low};
  return {*low, *high};
}

std::string words_of(const std::vector<double>& at) {
  // Without the sign of a zero.
  return at.size() == 1 ? fmt::format("clamped at s = {:.3g} m and free elsewhere", at[0] + 0.0)
                        : fmt::format("pinned at s = {:.3g} m and {:.3g} m", at[0] + 0.0, at[1]);
}

/// How a beam is held at an instant, in both planes.
struct Held {
  MakePosture in_plane, across;
  std::string in_plane_words, across_words;
  std::vector<double> at;  ///< alone, and across
  bool whole = false;
};

MakePosture alone(const Project& project, Plane plane, const std::vector<double>& at,
                  const BeamLoads& loads) {
  return [&project, plane, at, loads = in_plane(loads, plane)](double factor) {
    return loaded_beam(beam_alone(project, plane, at), project.beam, loads, factor);
  };
}

Held held_at(const Project& project, const SituationRun& run, Time time, const BeamLoads& loads) {
  const std::vector<double> at =
      outermost(run.motion->supports(loads), project.beam.length().value());
  Held held;
  held.at = at;
  held.across = alone(project, Plane::y, at, loads);
  held.across_words = words_of(at);
  held.in_plane = alone(project, Plane::z, at, loads);
  held.in_plane_words = words_of(at);
  if (MakePosture whole = run.motion->stopped(time, loads)) {
    held.in_plane = std::move(whole);
    held.in_plane_words = "held as its mechanism holds it";
    held.whole = true;
  }
  return held;
}

/// Whether a beam stands under so many times its loads; at the load that buckles it does not.
bool stands_under(const MakePosture& make, double factor) {
  try {
    return stands(make(factor));
  } catch (const AnalysisError&) {
    return false;
  }
}

/// N/N_cr, where it is above `known`.
double part_of_critical(const MakePosture& make, double known) {
  constexpr double least = 1e-4;
  double stable = 1.0 / std::max(known, least);
  if (stands_under(make, stable)) return known;
  double buckled = stable;
  stable *= 0.5;
  while (!stands_under(make, stable) && stable > 1e-6) {
    buckled = stable;
    stable *= 0.5;
  }
  constexpr double close = 1e-5;
  while (buckled - stable > close * buckled) {
    const double middle = 0.5 * (stable + buckled);
    (stands_under(make, middle) ? stable : buckled) = middle;
  }
  return 2.0 / (stable + buckled);
}

/// Largest compression along the beam [N].
double compression_of(const CutForceDiagram& diagram) {
  double most = 0.0;
  for (const CutForcePiece& piece : diagram.pieces) {
    const double length = piece.length.value();
    for (const double part : {0.0, 0.5, 1.0}) most = std::max(most, -piece.N(part * length));
  }
  return most;
}

/// Instants spread over the time, and those of largest compression; ascending.
std::vector<std::size_t> instants_of(const LoadHistory& history) {
  std::vector<std::pair<double, std::size_t>> compressions;
  for (std::size_t i = 0; i < history.instants(); ++i) {
    compressions.emplace_back(compression_of(history.diagram(i)), i);
  }
  std::vector<std::size_t> instants;
  const std::size_t step = std::max<std::size_t>(1, history.instants() / spread);
  for (std::size_t i = 0; i < history.instants(); i += step) instants.push_back(i);
  const std::size_t count = std::min(peaks, compressions.size());
  std::partial_sort(compressions.begin(), compressions.begin() + static_cast<std::ptrdiff_t>(count),
                    compressions.end(), std::greater<>());
  for (std::size_t i = 0; i < count; ++i) instants.push_back(compressions[i].second);
  std::sort(instants.begin(), instants.end());
  instants.erase(std::unique(instants.begin(), instants.end()), instants.end());
  return instants;
}

/// Stresses of the straight beam and what bending changes, a row for each instant.
struct Compared {
  Eigen::MatrixXd straight, change;

  void add(const Eigen::ArrayXd& of_straight, const Eigen::ArrayXd& of_change) {
    const Eigen::Index row = straight.rows();
    straight.conservativeResize(row + 1, of_straight.size());
    change.conservativeResize(row + 1, of_change.size());
    straight.row(row) = of_straight.transpose();
    change.row(row) = of_change.transpose();
  }

  double relative() const {
    const Eigen::MatrixXd bent = straight + change;
    const double peak = bent.cwiseAbs().maxCoeff();
    if (peak == 0.0) return 0.0;
    const double range = largest_range(bent);
    const double apart = change.cwiseAbs().maxCoeff() / peak;
    return range > 0.0 ? std::max(apart, largest_range(change) / range) : apart;
  }
};

class Estimating {
 public:
  explicit Estimating(const Project& project)
      : project_(&project), places_(compared_places_of(project.beam)), lateral_(project) {
    for (const ComparedPlace& place : places_) {
      const Section section = section_at(project.beam, place.station);
      const Length half = 0.5 * height_of(section.outer);
      const Length wall = std::max(wall_at(section.outer, half), wall_at(section.outer, -half));
      const PlateOf first = first_to_yield(plates_around(project, place.station.s, wall));
      const auto yield = yield_strength_of(*first.material, wall);
      yield_.push_back(yield ? yield->value() : unbounded);
      const Extent extent = extent_of(section.outer);
      const Length out = std::max(extent.y_high, Length(-extent.y_low));
      modulus_across_.push_back((properties_of(section).I_z / out).value());
    }
    result_.whole = true;
    result_.across.emplace();
    if (lateral_.is_known()) result_.lateral.emplace();
    result_.change = 0.0;
  }

  void look_at(const SituationRun& run) {
    Compared compared, across;
    const double factor = std::max(run.situation->load_factor, 1.0);
    for (const std::size_t i : instants_of(run.loads)) {
      const Time time = run.loads.time_of(i);
      const BeamLoads loads = run.loads.loads_at(time);
      const Held held = held_at(*project_, run, time, loads);
      if (!held.whole) result_.whole = false;
      const std::size_t situation = index_of(*project_, *run.situation);
      const CutForceDiagram diagram = cut_forces_of(loads);
      const auto raise = [&](BucklingLoad& load, const MakePosture& make,
                             const std::string& words) {
        const double part = part_of_critical(make, load.part);
        // Of an instant whose part is not above the largest so far, no more than that is known.
        const double factored = std::max(load.factored, factor * part);
        if (part > load.part) load = {part, time, situation, words};
        load.factored = factored;
      };
      raise(result_.in_plane, held.in_plane, held.in_plane_words);
      raise(*result_.across, held.across, held.across_words);
      look_sideways(diagram, loads, held, time, situation, factor);
      result_.bending = std::max(result_.bending, factor * bending_of_yield(diagram));
      if (result_.in_plane.part >= 1.0 || result_.across->part >= 1.0) {
        result_.change.reset();
        continue;
      }
      compare(held.in_plane, loads, factor, compared);
      if (project_->in_space) compare(held.across, in_plane(loads, Plane::y), factor, across);
    }
    if (!result_.change) return;
    result_.change = std::max(*result_.change, compared.relative());
    // By the section modulus of the other plane, which a ratio does not know.
    if (across.straight.rows() > 0) {
      result_.change = std::max(*result_.change, across.relative());
    }
  }

  /// The largest of all instants, where the beam as a member counts; of the bent beam as a bow's.
  void take_extremes(const std::deque<SituationRun>& runs) {
    const auto counts = [](double part) { return part > no_buckling_below; };
    if (!counts(result_.in_plane.part) && !(result_.across && counts(result_.across->part)) &&
        !(result_.lateral && result_.lateral->part > no_turning_over_below))
      return;
    double straight = 0.0;
    for (const SituationRun& run : runs) {
      const double factor = std::max(run.situation->load_factor, 1.0);
      for (std::size_t i = 0; i < run.loads.instants(); ++i) {
        const CutForceDiagram diagram = run.loads.diagram(i);
        result_.compressed = std::max(result_.compressed, factor * compression_of_yield(diagram));
        straight = std::max(straight, factor * bending_of_yield(diagram));
        if (!project_->in_space) continue;
        result_.bending_across =
            std::max(result_.bending_across, factor * bending_across_of_yield(diagram));
      }
    }
    const double grown = result_.in_plane.part < 1.0 ? 1.0 / (1.0 - result_.in_plane.part) : 1.0;
    result_.bending = std::max(result_.bending, grown * straight);
  }

  const SecondOrderEstimate& result() const { return result_; }

 private:
  void look_sideways(const CutForceDiagram& diagram, const BeamLoads& loads, const Held& held,
                     Time time, std::size_t situation, double factor) {
    if (!result_.lateral) return;
    LateralLoad& load = *result_.lateral;
    const double part = factor * lateral_.part(diagram, loads, held.at, load.part / factor);
    if (part <= load.part) return;
    load = {part, time, situation, held.across_words};
  }

  void compare(const MakePosture& make, const BeamLoads& loads, double factor, Compared& compared) {
    const SecondOrder bent = second_order_of(make(1.0));
    result_.turn = std::max(result_.turn, bent.turn);
    const Eigen::ArrayXd straight = fibre_stresses(cut_forces_of(loads), places_);
    const Eigen::ArrayXd change = fibre_stresses(cut_forces_of(bent.loads), places_);
    compared.add(straight, change);
    for (std::size_t k = 0; k < places_.size(); ++k) {
      // Half the difference of the two fibres is M/W.
      const auto i = 2 * static_cast<Eigen::Index>(k);
      const double bending = 0.5 * (straight[i] + change[i] - straight[i + 1] - change[i + 1]);
      result_.bending = std::max(result_.bending, factor * std::abs(bending) / yield_[k]);
    }
  }

  /// Largest compression over A f_y.
  double compression_of_yield(const CutForceDiagram& diagram) const {
    double most = 0.0;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const double N = diagram.at(places_[k].station).N.value();
      most = std::max(most, -N * places_[k].per_N / yield_[k]);
    }
    return most;
  }

  double bending_of_yield(const CutForceDiagram& diagram) const {
    double most = 0.0;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const double M = diagram.at(places_[k].station).M_y.value();
      most = std::max(most, std::abs(M) * places_[k].per_M / yield_[k]);
    }
    return most;
  }

  double bending_across_of_yield(const CutForceDiagram& diagram) const {
    double most = 0.0;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const double M = diagram.at(places_[k].station).M_z.value();
      most = std::max(most, std::abs(M) / (modulus_across_[k] * yield_[k]));
    }
    return most;
  }

  const Project* project_;
  std::vector<ComparedPlace> places_;
  std::vector<double> yield_;           ///< of the flanges there [Pa]
  std::vector<double> modulus_across_;  ///< W_z there [m^3]
  LateralEstimate lateral_;
  SecondOrderEstimate result_;
};

}  // namespace

SecondOrderEstimate estimate_second_order(const Project& project,
                                          const std::deque<SituationRun>& runs) {
  Estimating estimating(project);
  for (const SituationRun& run : runs) estimating.look_at(run);
  estimating.take_extremes(runs);
  return estimating.result();
}

std::string lateral_text(const LateralLoad& of) {
  return fmt::format(
      "lateral torsional buckling: M/M_cr = {:.3g} at most, the beam {} sideways and "
      "against turning, forces at the edge where they turn it over",
      of.part, of.held);
}

std::string second_order_text(const SecondOrderEstimate& of) {
  if (of.in_plane.part == 0.0 && of.change.value_or(0.0) == 0.0) {
    return "second order changes nothing, for the beam bears no axial force";
  }
  std::string text = of.change ? fmt::format("second order is estimated to change it by {}",
                                             percent_text(*of.change))
                               : std::string("the beam buckles");
  if (of.in_plane.part > 0.0) {
    text += fmt::format(", N/N_cr = {:.3g} at most in the plane", of.in_plane.part);
  }
  if (of.across && of.across->part > 0.0)
    text += fmt::format(", {:.3g} across it", of.across->part);
  return text;
}

}  // namespace boxbeam
