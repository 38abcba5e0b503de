#include "distorted_paths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/distorted_stretch.hpp"
#include "holding_diaphragm.hpp"
#include "patch_search.hpp"

namespace boxbeam {
namespace {

/// As wide and high as the outline and all over as thick as its thickest plate: of no box like it
/// does distortion fade out faster.
BoxCell box_around(const Section& section) {
  const Extent extent = extent_of(section.outer);
  const std::vector<Length> plates = thicknesses_of(section);
  const Length t = *std::max_element(plates.begin(), plates.end());
  return {extent.y_high - extent.y_low, extent.z_high - extent.z_low, {t, t, t, t}};
}

/// ln(h/b) of the outline.
double shape_of(const Section& section) {
  const BoxCell box = box_around(section);
  return std::log((box.height / box.width).value());
}

constexpr double one_shape = 1e-6;

/// Searches one stretch of them.
class OtherCells {
 public:
  OtherCells(const Project& project, const std::deque<SituationRun>& runs,
             const std::vector<std::vector<TorquesIn>>& torques, const BoxStretch& segments)
      : project_(&project),
        near_(1e-6 * project.beam.length()),
        segments_(segments),
        from_(first().start),
        to_(last().end()) {
    for (std::size_t r = 0; r < runs.size(); ++r) {
      const SituationRun& run = runs[r];
      factor_ = run.situation->load_factor;
      for (std::size_t i = 0; i < run.loads.instants(); ++i) {
        const CutForceDiagram diagram = run.loads.diagram(i);
        take(torques_between(torques[r][i], diagram, from_.value(), to_.value(), near_.value()),
             least_torque(run));
        look_at(diagram, least_torque(run));
      }
    }
  }

  void report(DistortionChecks& found) {
    if (!(largest_ > 0.0)) return;
    std::vector<std::string> reasons;
    if (unheld_.torque > 0.0)
      reasons.push_back(fmt::format(
          "at s = {:.4g} m {:.4g} kN m {}", unheld_.s.value() + 0.0, 1e-3 * unheld_.torque,
          diaphragm_at(unheld_.s) == nullptr
              ? "come in or pass an end without a diaphragm"
              : "come in or pass an end where the diaphragm is too weak to keep it in shape"));
    const Length apart = (line_.torque > 0.0 || taper_.torque > 0.0) ? farthest() : Length{};
    const Length limit = spacing();
    if (apart > limit) {
      if (line_.torque > 0.0)
        reasons.push_back(fmt::format("near s = {:.4g} m {:.4g} kN m come along the beam",
                                      line_.s.value() + 0.0, 1e-3 * line_.torque));
      if (taper_.torque > 0.0)
        reasons.push_back(fmt::format("behind s = {:.4g} m it tapers under {:.4g} kN m",
                                      taper_.s.value() + 0.0, 1e-3 * taper_.torque));
    }
    if (reasons.empty())
      say(found);
    else
      found.gates.push_back(
          {first().name, "",
           fmt::format("a torque of {:.4g} kN m in a path around cells that are no rectangle, "
                       "between s = {:.4g} m and {:.4g} m: {}: how it distorts it is not judged; "
                       "[[beam.diaphragms]] where torque comes, and no farther apart than {:.3g} m "
                       "where it comes between them or tapers, keep it in shape",
                       1e-3 * largest_, from_.value() + 0.0, to_.value(), fmt::join(reasons, "; "),
                       limit.value()),
           true});
    if (unsaid_ && project_->strength.required * unsaid_->needed > least_throat())
      found.not_judged.push_back(unsaid_welds(*project_, *unsaid_));
  }

 private:
  struct Worst {
    double torque = 0.0;  ///< with its load factor [N m]
    Length s;

    void take(double more, Length at) {
      if (more > torque) *this = {more, at};
    }
  };

  const Segment& first() const { return project_->beam.segments[segments_.first]; }
  const Segment& last() const { return project_->beam.segments[segments_.last]; }

  void say(DistortionChecks& found) const {
    found.not_judged.push_back(
        {Criterion::distortion,
         fmt::format("distortion of {} between s = {:.4g} m and {:.4g} m", first().name,
                     from_.value() + 0.0, to_.value()),
         fmt::format(
             "a path around cells that are no rectangle under {:.4g} kN m, taken to be kept "
             "in shape by its diaphragms",
             1e-3 * largest_)});
  }

  const Diaphragm* diaphragm_at(Length s) const {
    for (const Diaphragm& of : project_->beam.diaphragms)
      if (abs(of.s - s) <= near_) return &of;
    return nullptr;
  }

  /// What of a torque comes into the path at a place: unheld where nothing keeps it in shape there.
  void take(Length s, double torque, double least) {
    if (!(torque > least)) return;
    const Diaphragm* const of = diaphragm_at(s);
    if (of == nullptr || !bears(*of, factor_ * torque)) unheld_.take(factor_ * torque, s);
  }

  /// All that come in at one place, those that cancel as well.
  void take(const TorquesIn& torques, double least) {
    std::map<double, double> at_places;
    for (const TorqueIn& of : torques) at_places[of.s] += std::abs(of.torque);
    for (const auto& [s, torque] : at_places) {
      if (torque > least) largest_ = std::max(largest_, factor_ * torque);
      take(si<Length>(s), torque, least);
    }
  }

  bool is_rigid(const Diaphragm& of) {
    const auto known = rigid_.find(&of);
    if (known != rigid_.end()) return known->second;
    const bool rigid = is_firm(*project_, of, true) && is_firm(*project_, of, false);
    return rigid_.emplace(&of, rigid).first->second;
  }

  /// Whether a diaphragm keeps the path in shape: by Bredt's flow of all of the torque in its
  /// plate, as of a box around the same area.
  bool bears(const Diaphragm& of, double torque) {
    if (!is_rigid(of)) return false;
    bool all = true;
    for (const Side side : {Side::before, Side::behind}) {
      if (side == Side::before ? !(of.s > from_ + near_) : !(of.s < to_ - near_)) continue;
      const Section section = section_at(project_->beam, {of.s, side});
      BoxCell cell = box_around(section);
      cell.width = enclosed_area_of(section.outer) / cell.height;
      const auto holding = holding_of(*project_, of, cell, 0.5 * torque);
      all = all && holding && project_->strength.required * holding->used() <= 1.0;
      if (holding && (!unsaid_ || holding->needed > unsaid_->needed)) unsaid_ = holding;
    }
    return all;
  }

  void look_at(const CutForceDiagram& diagram, double least) {
    double line = 0.0, most = 0.0;
    Length where;
    for (const CutForcePiece& piece : diagram.pieces) {
      const Length start = std::max(piece.start, from_), end = std::min(piece.end(), to_);
      const auto T = [&](Length s) { return piece.T((s - piece.start).value()); };
      if (!(end > start + near_)) continue;
      const Length middle = 0.5 * (start + end);
      const double change = std::abs(T(middle) - T(start)) + std::abs(T(end) - T(middle));
      if (change > most) where = start;
      most = std::max(most, change);
      line += change;
      for (const Length& s : {start, middle, end})
        if (std::abs(T(s)) > least) largest_ = std::max(largest_, factor_ * std::abs(T(s)));
    }
    if (line > least) line_.take(factor_ * line, where);
    look_at_shapes(diagram, least);
  }

  void look_at_shapes(const CutForceDiagram& diagram, double least) {
    for (std::size_t i = segments_.first; i <= segments_.last; ++i) {
      const Segment& of = project_->beam.segments[i];
      const double at_end = std::abs(diagram.at({of.end(), Side::before}).T.value());
      if (std::abs(shape_of(of.to) - shape_of(of.from)) > one_shape) {
        const double T =
            std::max({std::abs(diagram.at({of.start, Side::behind}).T.value()), at_end,
                      std::abs(diagram.at({of.start + 0.5 * of.length, Side::both}).T.value())});
        if (T > least) taper_.take(factor_ * T, of.start);
      }
      if (i == segments_.last) continue;
      const double jump = std::abs(shape_of(project_->beam.segments[i + 1].from) - shape_of(of.to));
      if (jump > one_shape) take(of.end(), jump * at_end, least);
    }
  }

  /// Between rigid diaphragms, and from the ends to the first of them.
  Length farthest() {
    std::vector<Length> places = {from_, to_};
    for (const Diaphragm& of : project_->beam.diaphragms)
      if (of.s > from_ && of.s < to_ && is_rigid(of)) places.push_back(of.s);
    std::sort(places.begin(), places.end());
    Length most;
    for (std::size_t i = 1; i < places.size(); ++i)
      most = std::max(most, Length(places[i] - places[i - 1]));
    return most;
  }

  Length spacing() const {
    const double E = project_->model.youngs_modulus;
    const double nu = 0.5 * E / project_->model.shear_modulus - 1.0;
    double decay = 0.0;
    for (std::size_t i = segments_.first; i <= segments_.last; ++i) {
      const Segment& of = project_->beam.segments[i];
      for (const Section& section : {of.from, of.to})
        decay = std::max(decay, cell_distortion_of(box_around(section), E, nu).decay);
    }
    return si<Length>(0.5 / decay);
  }

  const Project* project_;
  Length near_;
  BoxStretch segments_;
  Length from_, to_;
  double factor_ = 1.0, largest_ = 0.0;
  Worst unheld_, line_, taper_;
  std::optional<DistortionEstimate::Holding> unsaid_;
  std::map<const Diaphragm*, bool> rigid_;
};

}  // namespace

bool is_closed_path(const Segment& segment) {
  const auto* const path = std::get_if<ThinWalled>(&segment.from.outer);
  return path != nullptr && enclosed_area_of(*path).value() > 0.0;
}

bool has_cell(const Segment& segment) {
  if (!std::holds_alternative<ThinWalled>(segment.from.outer))
    return box_cell_of(segment.from.outer).has_value();
  // Plates that are straight at three places of a taper are so everywhere.
  constexpr std::array parts = {0.0, 0.37, 1.0};
  return std::all_of(parts.begin(), parts.end(), [&](double part) {
    return box_cell_of(interpolate(segment.from, segment.to, part).outer).has_value();
  });
}

void look_at_other_cells(const Project& project, const std::deque<SituationRun>& runs,
                         const std::vector<std::vector<TorquesIn>>& torques,
                         DistortionChecks& found) {
  const std::vector<Segment>& segments = project.beam.segments;
  const auto is_one = [&](std::size_t i) {
    return is_closed_path(segments[i]) && !has_cell(segments[i]);
  };
  for (std::size_t i = 0; i < segments.size(); ++i) {
    if (!is_one(i)) continue;
    BoxStretch stretch{i, i};
    while (stretch.last + 1 < segments.size() && is_one(stretch.last + 1)) ++stretch.last;
    OtherCells(project, runs, torques, stretch).report(found);
    i = stretch.last;
  }
}

}  // namespace boxbeam
