#include "boxbeam/verification/distortion_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/outline.hpp"
#include "boxbeam/section/plate_kind.hpp"
#include "boxbeam/section/point_stress.hpp"
#include "boxbeam/strength/box_distortion.hpp"
#include "boxbeam/strength/material.hpp"
#include "counts_in_fatigue.hpp"

namespace boxbeam {
namespace {

constexpr double one_place = 1e-9;       ///< of the beam's length
constexpr double no_torque = 1e-6;       ///< of the largest moment
constexpr std::size_t most_places = 64;  ///< where torque comes that get nodes: wheels move

/// Segments of boxes in a row.
struct Stretch {
  std::size_t first = 0, last = 0;
};

std::vector<Stretch> stretches_of(const TaperedBeam& beam) {
  std::vector<Stretch> stretches;
  bool before = false;
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    const bool box = box_cell_of(beam.segments[i].from.outer).has_value();
    if (box && before) stretches.back().last = i;
    if (box && !before) stretches.push_back({i, i});
    before = box;
  }
  return stretches;
}

/// A torque that comes to the beam at a place.
struct Introduced {
  double s = 0.0, torque = 0.0;
};

/// What comes between two places of a beam and, as torque that passes, at these.
std::vector<Introduced> introduced_in(const CutForceDiagram& diagram, double from, double to,
                                      double near) {
  std::vector<Introduced> all;
  const auto jump = [&](double s, double before, double behind) {
    if (before != behind) all.push_back({s, before - behind});
  };
  double before = 0.0;
  for (const CutForcePiece& piece : diagram.pieces) {
    const double start = piece.start.value(), length = piece.length.value();
    if (start > from + near && start < to - near) jump(start, before, piece.T(0.0));
    before = piece.T(length);
  }
  jump(from, 0.0, diagram.at({si<Length>(from), Side::behind}).T.value());
  jump(to, diagram.at({si<Length>(to), Side::before}).T.value(), 0.0);
  return all;
}

/// -dT/ds, what comes per length.
double line_torque_at(const CutForceDiagram& diagram, double s) {
  for (const CutForcePiece& piece : diagram.pieces) {
    if (s <= piece.end().value()) return -derivative_of(piece.T)(s - piece.start.value());
  }
  return 0.0;
}

/// Stresses of one end of an element where gamma = 1 and M_D = 1.
struct PlaceStress {
  Station station;
  std::size_t node = 0;
  double along = 0.0, across = 0.0;
  double yield_strength = 0.0;             ///< the lowest there
  std::array<StressInfluence, 4> corners;  ///< of the cut forces
};

/// Lowest and highest of a value.
struct Limits {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;

  void take(double value) {
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
  }
  double range() const { return highest > lowest ? highest - lowest : 0.0; }
};

/// What distorts at each node, as its own sum of effects.
struct Response {
  std::vector<double> angle, moment;

  explicit Response(std::size_t nodes) : angle(nodes, 0.0), moment(nodes, 0.0) {}
  void add(const Distortion& of, double factor) {
    for (std::size_t i = 0; i < angle.size(); ++i) {
      angle[i] += factor * std::abs(of.angle[i]);
      moment[i] += factor * std::abs(of.moment[i]);
    }
  }
};

/// Lowest and highest distortion at each node.
struct ResponseLimits {
  std::vector<Limits> angle, moment;

  explicit ResponseLimits(std::size_t nodes) : angle(nodes), moment(nodes) {}
  void take(const Distortion& of) {
    for (std::size_t i = 0; i < angle.size(); ++i) {
      angle[i].take(of.angle[i]);
      moment[i].take(of.moment[i]);
    }
  }
};

/// Whether anything twists the beam at any instant.
bool is_twisted(const std::deque<SituationRun>& runs) {
  for (const SituationRun& run : runs) {
    const double least = no_torque * run.loads.largest_moment();
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      for (const CutForcePiece& piece : run.loads.diagram(i).pieces) {
        for (const double part : {0.0, 0.5, 1.0})
          if (std::abs(piece.T(part * piece.length.value())) > least) return true;
      }
    }
  }
  return false;
}

class DistortedStretch {
 public:
  DistortedStretch(const Project& project, const std::deque<SituationRun>& runs,
                   const Stretch& stretch)
      : project_(&project),
        stretch_(stretch),
        from_(project.beam.segments[stretch.first].start.value()),
        to_(project.beam.segments[stretch.last].end().value()),
        near_(one_place * project.beam.length().value()),
        solver_(beam_under(runs)),
        known_(nodes()),
        lines_(nodes()),
        most_(nodes()) {
    const std::size_t elements = nodes() - 1;
    for (std::size_t e = 0; e < elements; ++e) {
      add_place(e, {si<Length>(solver_.beam().nodes[e]), Side::behind});
      add_place(e + 1, {si<Length>(solver_.beam().nodes[e + 1]), Side::before});
    }
    result_.from = si<Length>(from_);
    result_.to = si<Length>(to_);
    for (std::size_t i = stretch.first; i <= stretch.last; ++i)
      result_.segments += (i > stretch.first ? ", " : "") + project.beam.segments[i].name;
  }

  void look_at(const SituationRun& run) {
    const double factor = run.situation->load_factor;
    const bool counts = project_->fatigue.asked && counts_in_fatigue(*project_, *run.situation);
    const double least = no_torque * run.loads.largest_moment();
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const CutForceDiagram diagram = run.loads.diagram(i);
      take_bending(diagram, factor, counts);
      const std::optional<Response> response = response_to(diagram, least, counts);
      if (response && factor > 0.0) take_strength(*response, run, i, diagram);
    }
  }

  /// Nothing where no torque comes.
  std::optional<DistortionEstimate> result() const {
    if (!any_) return std::nullopt;
    DistortionEstimate found = result_;
    take_ranges(found);
    return found;
  }

 private:
  std::size_t nodes() const { return solver_.beam().nodes.size(); }

  Station inside(double s) const {
    return {si<Length>(s), s > to_ - near_ ? Side::before : Side::behind};
  }
  Section section_near(const Station& station) const { return section_at(project_->beam, station); }
  BoxCell cell_at(double s) const { return *box_cell_of(section_near(inside(s)).outer); }

  DistortedBeam beam_under(const std::deque<SituationRun>& runs) {
    const TaperedBeam& beam = project_->beam;
    std::vector<double> places{from_, to_};
    for (std::size_t i = stretch_.first; i < stretch_.last; ++i)
      places.push_back(beam.segments[i].end().value());
    for (const Diaphragm& of : beam.diaphragms)
      if (of.s.value() >= from_ - near_ && of.s.value() <= to_ + near_)
        places.push_back(std::clamp(of.s.value(), from_, to_));
    std::vector<double> introduced;
    for (const SituationRun& run : runs) {
      const double least = no_torque * run.loads.largest_moment();
      for (std::size_t i = 0; i < run.loads.instants(); ++i) {
        for (const Introduced& of : introduced_in(run.loads.diagram(i), from_, to_, near_)) {
          const auto same = [&](double s) { return std::abs(s - of.s) <= near_; };
          if (std::abs(of.torque) > least && introduced.size() < most_places &&
              std::none_of(introduced.begin(), introduced.end(), same))
            introduced.push_back(of.s);
        }
      }
    }
    places.insert(places.end(), introduced.begin(), introduced.end());
    std::sort(introduced.begin(), introduced.end());
    for (const double at : introduced) result_.places.push_back(si<Length>(at));
    std::sort(places.begin(), places.end());
    const auto alike = [&](double a, double b) { return b - a <= near_; };
    places.erase(std::unique(places.begin(), places.end(), alike), places.end());
    places.back() = to_;

    const double E = project_->model.youngs_modulus;
    const double nu = 0.5 * E / project_->model.shear_modulus - 1.0;
    DistortedBeam of = distorted_beam(
        places, [&](double s) { return cell_at(s); }, E, nu);
    for (const Diaphragm& diaphragm : beam.diaphragms) {
      const double s = diaphragm.s.value();
      if (s < from_ - near_ || s > to_ + near_) continue;
      of.diaphragms[of.nearest(s)] += diaphragm_stiffness(
          cell_at(std::clamp(s, from_, to_)), diaphragm.thickness, diaphragm.opening, E, nu);
    }
    return of;
  }

  void add_place(std::size_t node, const Station& station) {
    const double E = project_->model.youngs_modulus;
    const double nu = 0.5 * E / project_->model.shear_modulus - 1.0;
    const Section section = section_near(station);
    const BoxCell cell = *box_cell_of(section.outer);
    const CellDistortion of = cell_distortion_of(cell, E, nu);
    BoxCell bent = cell;  // by which thickness a corner is bent
    if (const auto* box = std::get_if<Box>(&section.outer)) {
      if (box->seam_throat.value() > 0.0)
        for (Length& t : bent.thickness) t = std::min(t, box->seam_throat, std::less<>());
    }
    const Distortion unit{{1.0}, {1.0}, {0.0}};
    PlaceStress place{station, node, 0.0, 0.0, std::numeric_limits<double>::infinity(), {}};
    const AreaSums sums = sums_of(outline_of(section, {}));
    const double y = 0.5 * cell.width.value(), z = 0.5 * cell.height.value();
    const std::array<std::array<double, 2>, 4> corners{{{y, z}, {y, -z}, {-y, -z}, {-y, z}}};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto corner = static_cast<CellCorner>(i);
      place.along = std::max(place.along, std::abs(unit.warping_stress(0, of, corner)));
      place.across = std::max(place.across, unit.frame_stress(0, of, bent, corner));
      place.corners[i] = normal_influence(sums, corners[i][0], corners[i][1]);
    }
    const PlateMaterials materials = materials_of(*project_, segment_at(project_->beam, station));
    for (const PlateAt& plate : plates_of(section)) {
      if (const auto yield = yield_strength_of(materials.of(plate.kind), plate.thickness))
        place.yield_strength = std::min(place.yield_strength, yield->value());
    }
    result_.spacing = places_.empty()
                          ? si<Length>(0.5 / of.decay)
                          : std::min(result_.spacing, si<Length>(0.5 / of.decay), std::less<>());
    places_.push_back(place);
    bending_.emplace_back();
  }

  void take_bending(const CutForceDiagram& diagram, double factor, bool counts) {
    for (std::size_t k = 0; k < places_.size(); ++k) {
      CutForces cut = diagram.at(places_[k].station);
      cut.N = Force{};
      for (std::size_t c = 0; c < 4; ++c) {
        const Stress stress = stress_at(places_[k].corners[c], cut).normal;
        result_.bending =
            std::max(result_.bending, si<Stress>(factor * std::abs(stress.value())), std::less<>());
        if (counts) bending_[k][c].take(stress.value());
      }
    }
  }

  /// What is known of sign, T d(ln(h/b))/2; nothing where the box keeps its proportions.
  std::optional<Distortion> known_response(const CutForceDiagram& diagram) const {
    const DistortedBeam& beam = solver_.beam();
    std::vector<double> loads(nodes(), 0.0);
    std::vector<DistortedBeam::AtGauss> lines = beam.of_torque;
    bool any = false;
    for (std::size_t e = 0; e < lines.size(); ++e) {
      const DistortedBeam::AtGauss at = beam.places(e);
      for (std::size_t g = 0; g < at.size(); ++g) {
        if (lines[e][g] == 0.0) continue;
        lines[e][g] *= diagram.at({si<Length>(at[g])}).T.value();
        any = any || lines[e][g] != 0.0;
      }
    }
    for (std::size_t i = stretch_.first; i < stretch_.last; ++i) {
      const Length s = project_->beam.segments[i].end();
      const BoxCell a = *box_cell_of(section_near({s, Side::before}).outer);
      const BoxCell b = *box_cell_of(section_near({s, Side::behind}).outer);
      const double jump = std::log((b.height / b.width).value() / (a.height / a.width).value());
      if (std::abs(jump) < 1e-12) continue;
      loads[beam.nearest(s.value())] += 0.5 * jump * diagram.at({s, Side::before}).T.value();
      any = true;
    }
    if (!any) return std::nullopt;
    return solver_.solve(loads, lines);
  }

  /// What comes along the beam, by webs alone.
  std::optional<Distortion> line_response(const CutForceDiagram& diagram, double least) const {
    const DistortedBeam& beam = solver_.beam();
    std::vector<DistortedBeam::AtGauss> lines(nodes() - 1);
    double largest = 0.0;
    for (std::size_t e = 0; e < lines.size(); ++e) {
      const DistortedBeam::AtGauss at = beam.places(e);
      for (std::size_t g = 0; g < at.size(); ++g) {
        lines[e][g] = 0.5 * line_torque_at(diagram, at[g]);
        largest = std::max(largest, std::abs(lines[e][g]));
      }
    }
    if (largest * (to_ - from_) <= least) return std::nullopt;
    return solver_.solve(std::vector<double>(nodes(), 0.0), lines);
  }

  const Distortion& of_node(std::size_t node) {
    const auto found = of_node_.find(node);
    if (found != of_node_.end()) return found->second;
    std::vector<double> loads(nodes(), 0.0);
    loads[node] = 1.0;
    return of_node_.emplace(node, solver_.solve(loads)).first->second;
  }

  /// The most that the torque of an instant may distort, node by node; nothing where none comes.
  std::optional<Response> response_to(const CutForceDiagram& diagram, double least, bool counts) {
    Response response(nodes());
    std::map<std::size_t, double> loads;
    for (const Introduced& of : introduced_in(diagram, from_, to_, near_)) {
      if (std::abs(of.torque) <= least) continue;
      any_ = true;
      // Between two nodes both have their share.
      const std::vector<double>& at = solver_.beam().nodes;
      const auto above = std::clamp<std::ptrdiff_t>(
          std::lower_bound(at.begin(), at.end(), of.s - near_) - at.begin(), 1,
          static_cast<std::ptrdiff_t>(at.size()) - 1);
      const auto next = static_cast<std::size_t>(above);
      const double part = std::clamp((of.s - at[next - 1]) / (at[next] - at[next - 1]), 0.0, 1.0);
      constexpr double all = 1e-6;
      if (part < 1.0 - all) loads[next - 1] += 0.5 * (1.0 - part) * of.torque;
      if (part > all) loads[next] += 0.5 * part * of.torque;
    }
    for (const auto& [node, load] : loads) response.add(of_node(node), std::abs(load));
    if (counts) {
      for (auto& [node, limits] : of_loads_)
        if (loads.find(node) == loads.end()) limits.take(0.0);
      for (const auto& [node, load] : loads) {
        const bool is_new = of_loads_.find(node) == of_loads_.end();
        if (is_new && counted_) of_loads_[node].take(0.0);
        of_loads_[node].take(load);
      }
      counted_ = true;
    }
    const auto take = [&](const std::optional<Distortion>& of, ResponseLimits& limits) {
      if (of) response.add(*of, 1.0);
      if (!counts) return;
      if (of)
        limits.take(*of);
      else
        for (std::size_t i = 0; i < nodes(); ++i) {
          limits.angle[i].take(0.0);
          limits.moment[i].take(0.0);
        }
    };
    const auto along = line_response(diagram, least);
    if (along) any_ = true;
    take(along, lines_);
    take(any_ ? known_response(diagram) : std::nullopt, known_);
    if (counts) {
      for (std::size_t i = 0; i < nodes(); ++i) {
        most_.angle[i] = std::max(most_.angle[i], response.angle[i]);
        most_.moment[i] = std::max(most_.moment[i], response.moment[i]);
      }
    }
    if (!any_) return std::nullopt;
    return response;
  }

  void take_strength(const Response& response, const SituationRun& run, std::size_t instant,
                     const CutForceDiagram& diagram) {
    const double factor = run.situation->load_factor;
    for (const PlaceStress& place : places_) {
      const double along = factor * place.along * response.moment[place.node];
      const double across = factor * place.across * response.angle[place.node];
      result_.along = std::max(result_.along, si<Stress>(along), std::less<>());
      result_.across = std::max(result_.across, si<Stress>(across), std::less<>());
      const double used = (along + across) * project_->strength.gamma_M0 / place.yield_strength;
      if (used <= result_.used) continue;
      result_.used = used;
      result_.station = place.station;
      result_.when = run.loads.time_of(instant);
      result_.situation = index_of(*project_, *run.situation);
      double most = 0.0;
      for (const Introduced& of : introduced_in(diagram, from_, to_, near_)) {
        const Distortion& unit = of_node(solver_.beam().nearest(of.s));
        const double effect =
            std::abs(of.torque) * (place.along * std::abs(unit.moment[place.node]) +
                                   place.across * std::abs(unit.angle[place.node]));
        if (effect <= most) continue;
        most = effect;
        result_.introduced = si<Length>(of.s);
        result_.torque = si<Moment>(std::abs(of.torque));
      }
    }
  }

  /// Ranges are sums of those of the parts, whose signs stay; never above twice the most.
  void take_ranges(DistortionEstimate& found) const {
    Response ranges(nodes());
    for (const auto& [node, limits] : of_loads_) ranges.add(of_node_.at(node), limits.range());
    double along = 0.0, across = 0.0, bending = 0.0;
    for (const PlaceStress& place : places_) {
      const std::size_t i = place.node;
      const double angle = ranges.angle[i] + known_.angle[i].range() + lines_.angle[i].range();
      const double moment = ranges.moment[i] + known_.moment[i].range() + lines_.moment[i].range();
      along = std::max(along, place.along * std::min(moment, 2.0 * most_.moment[i]));
      across = std::max(across, place.across * std::min(angle, 2.0 * most_.angle[i]));
    }
    for (const auto& corners : bending_)
      for (const Limits& of : corners) bending = std::max(bending, of.range());
    found.along_range = si<Stress>(along);
    found.across_range = si<Stress>(across);
    found.bending_range = si<Stress>(bending);
  }

  const Project* project_;
  Stretch stretch_;
  double from_, to_, near_;
  DistortionEstimate result_;
  DistortionSolver solver_;
  std::vector<PlaceStress> places_;
  std::vector<std::array<Limits, 4>> bending_;  ///< of each place, at its corners
  std::map<std::size_t, Distortion> of_node_;   ///< d = 1 at a node
  std::map<std::size_t, Limits> of_loads_;      ///< d at a node, of what counts in fatigue
  ResponseLimits known_, lines_;
  Response most_;
  bool any_ = false, counted_ = false;
};

/// What of the strength of the beam its checks use at most; nothing of plates that buckle, whose
/// sections bear the stresses of distortion with less.
std::optional<double> most_used(const std::vector<CheckResult>& checks) {
  double most = 0.0;
  for (const CheckResult& of : checks) {
    switch (of.check.criterion) {
      case Criterion::yield:
      case Criterion::weld: most = std::max(most, of.check.utilisation()); break;
      case Criterion::effective_section:
      case Criterion::shear_buckling:
      case Criterion::interaction:
      case Criterion::reduced_stress:
      case Criterion::patch_loading:
      case Criterion::member: return std::nullopt;
      case Criterion::fatigue:
      case Criterion::shear_fatigue:
      case Criterion::combined_fatigue:
      case Criterion::stress_range:
      case Criterion::pin:
      case Criterion::rod:
      case Criterion::buckling:
      case Criterion::deflection: break;
    }
  }
  return most;
}

std::string effects_text(const Project& project, const DistortionEstimate& of) {
  const std::string& name = project.situations[of.situation].name;
  return fmt::format(
      "distortion of the box between s = {:.4g} m and {:.4g} m: its torques, most of all {:.3g} "
      "kN m at s = {:.4g} m, each led in by its webs or its flanges alone, bend its plates across "
      "by {:.3g} MPa and stretch its edges by {:.3g} MPa at most (t = {:.6g} s{}), bending by "
      "{:.3g} MPa",
      of.from.value() + 0.0, of.to.value(), of.torque.value() * 1e-3, of.introduced.value() + 0.0,
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

std::vector<DistortionEstimate> estimate_distortion(const Project& project,
                                                    const std::deque<SituationRun>& runs) {
  std::vector<DistortionEstimate> estimates;
  if (!project.in_space || !is_twisted(runs)) return estimates;
  for (const Stretch& stretch : stretches_of(project.beam)) {
    DistortedStretch of(project, runs, stretch);
    for (const SituationRun& run : runs) of.look_at(run);
    if (const auto found = of.result()) estimates.push_back(*found);
  }
  return estimates;
}

std::vector<Gate> distortion_gates_of(const Project& project,
                                      const std::vector<DistortionEstimate>& estimates,
                                      const std::vector<CheckResult>& checks) {
  constexpr double disregarded = 0.1, next_to_nothing = 0.01, worth_saying = 1e-3;
  // Category 36 at 1e8 cycles: (2/5)^(1/3) (5/100)^(1/5) of it. Source: EN 1993-1-9, 7.1(2), (3).
  const FatigueDemand& demand = project.fatigue.demand;
  const double cut_off = 36e6 * std::cbrt(0.4) * std::pow(0.05, 0.2) / demand.gamma_Mf;
  std::vector<Gate> gates;
  for (const DistortionEstimate& of : estimates) {
    std::optional<double> used = most_used(checks);
    if (used) *used += project.strength.required * of.used;
    const bool small = std::max(of.along, of.across, std::less<>()) <= disregarded * of.bending;
    const auto small_range = [&](Stress range, double of_cut_off) {
      const double limit = of_cut_off * cut_off / (demand.gamma_Ff * project.fatigue.required);
      return range <= std::max(disregarded * of.bending_range, si<Stress>(limit), std::less<>());
    };
    const bool small_ranges = !project.fatigue.asked || (small_range(of.along_range, disregarded) &&
                                                         small_range(of.across_range, 1.0));
    const std::string effects = effects_text(project, of);
    const bool slight = project.strength.required * of.used <= next_to_nothing;
    if ((small || slight || (used && *used <= 1.0)) && small_ranges) {
      if (of.used < worth_saying) continue;
      const std::string why = small ? "at most 10 %, and left out (EN 1993-2, 6.2.7)"
                              : slight
                                  ? "at most 1 % of the strength, and left out"
                                  : fmt::format(
                                        "not in the checks, which leave room for it: {:.3g} of the "
                                        "strength with all of it added",
                                        *used);
      gates.push_back({"", "", fmt::format("{}: {}", effects, why), false});
      continue;
    }
    std::string why = "more than 10 % of it (EN 1993-2, 6.2.7)";
    if (!small_ranges)
      why = fmt::format("in fatigue by ranges of {:.3g} and {:.3g} MPa, bending {:.3g} MPa",
                        of.across_range.value() * 1e-6, of.along_range.value() * 1e-6,
                        of.bending_range.value() * 1e-6);
    else if (used)
      why += fmt::format(", {:.3g} of the strength with all of it added to the checks", *used);
    gates.push_back({"", "",
                     fmt::format("{}: {}; it is in no check. {}", effects, why, remedy_text(of)),
                     true});
  }
  return gates;
}

}  // namespace boxbeam
