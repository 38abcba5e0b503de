#include "boxbeam/verification/beam_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "boxbeam/project/attachment_welds.hpp"
#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

/// Cuts as they are gathered. Those within round-off of each other (a billionth of the beam) are
/// one, and stand where the first of them was added.
class Gathered {
 public:
  explicit Gathered(const TaperedBeam& beam) : length_(beam.length()) {}

  void add(Length s, bool sides, bool alone = false) {
    if (s.value() >= 0.0 && s <= length_) cuts_.push_back({{s, sides, alone}, cuts_.size()});
  }

  std::vector<BeamCut> cuts() && {
    std::sort(cuts_.begin(), cuts_.end(), [](const Numbered& a, const Numbered& b) {
      return std::pair(a.cut.s, a.number) < std::pair(b.cut.s, b.number);
    });
    std::vector<BeamCut> cuts;
    std::size_t first = 0;
    for (const auto& [cut, number] : cuts_) {
      if (cuts.empty() || cut.s - cuts.back().s > 1e-9 * length_) {
        cuts.push_back(cut);
        first = number;
        continue;
      }
      cuts.back().sides = cuts.back().sides || cut.sides;
      cuts.back().alone = cuts.back().alone || cut.alone;
      if (number > first) continue;
      cuts.back().s = cut.s;
      first = number;
    }
    return cuts;
  }

 private:
  struct Numbered {
    BeamCut cut;
    std::size_t number;
  };
  Length length_;
  std::vector<Numbered> cuts_;
};

/// The places where the cut forces of an instant jump or change their law, ascending.
std::vector<Length> borders_of(const CutForceDiagram& diagram) {
  std::vector<Length> borders;
  borders.reserve(diagram.pieces.size());
  for (const CutForcePiece& piece : diagram.pieces) borders.push_back(piece.start);
  return borders;
}

/// Whether cut forces jump at a place, at any instant, by more than round-off.
bool jumps_at(const LoadHistory& loads, Length length, Length s) {
  constexpr double round_off = 1e-9;
  const auto differ = [round_off](auto a, auto b, auto scale) {
    return abs(a - b) > round_off * scale;
  };
  const std::vector<CutForces> before = loads.cuts_at({s, Side::before});
  const std::vector<CutForces> behind = loads.cuts_at({s, Side::behind});
  for (std::size_t i = 0; i < before.size(); ++i) {
    const CutForces &a = before[i], &b = behind[i];
    const Force scale =
        std::max({abs(a.N), abs(b.N), abs(a.V_y), abs(b.V_y), abs(a.V_z), abs(b.V_z),
                  abs(a.T) / length, abs(b.T) / length, abs(a.M_y) / length, abs(b.M_y) / length,
                  abs(a.M_z) / length, abs(b.M_z) / length},
                 std::less<>());
    if (differ(a.N, b.N, scale) || differ(a.V_y, b.V_y, scale) || differ(a.V_z, b.V_z, scale))
      return true;
    const Moment moment = scale * length;
    if (differ(a.T, b.T, moment) || differ(a.M_y, b.M_y, moment) || differ(a.M_z, b.M_z, moment))
      return true;
  }
  return false;
}

/// Of a motion: places where loads stand still, and the ends of the ways of those that slide.
void add_loads(const SituationRun& run, Length length, Gathered& cuts) {
  const LoadHistory& loads = run.loads;
  const std::vector<Length> first = borders_of(loads.diagram(0));
  if (loads.is_recorded()) {  // whose places never change
    for (const Length& s : first) cuts.add(s, true);
    return;
  }
  bool still = true;
  for (std::size_t i = 1; i < loads.instants() && still; ++i) {
    const std::vector<CutForcePiece>& pieces = loads.kept_diagram(i).pieces;
    still =
        std::equal(pieces.begin(), pieces.end(), first.begin(), first.end(),
                   [](const CutForcePiece& piece, const Length& s) { return piece.start == s; });
  }
  if (still) {
    // Of very many borders without jumps, as between the parts of a finely divided link, some: the
    // search sees kinks within a piece too.
    constexpr std::size_t many = 128;
    const std::size_t every = 1 + first.size() / many;
    for (std::size_t k = 0; k < first.size(); ++k) {
      const bool jumps = jumps_at(loads, length, first[k]);
      if (jumps || k % every == 0) cuts.add(first[k], jumps);
    }
    return;
  }
  // What is there at every instant stands still; of the rest, in order along the beam, each has a
  // way, whose ends are those of some load.
  std::map<double, std::size_t> visits;
  for (std::size_t i = 0; i < loads.instants(); ++i) {
    for (const CutForcePiece& piece : loads.kept_diagram(i).pieces) ++visits[piece.start.value()];
  }
  struct Way {
    Length low, high;
  };
  std::vector<Way> ways;
  for (std::size_t i = 0; i < loads.instants(); ++i) {
    std::size_t rank = 0;
    for (const CutForcePiece& piece : loads.kept_diagram(i).pieces) {
      if (visits[piece.start.value()] == loads.instants()) continue;
      if (rank == ways.size()) ways.push_back({piece.start, piece.start});
      Way& way = ways[rank++];
      way = {std::min(way.low, piece.start), std::max(way.high, piece.start)};
    }
  }
  for (const auto& [s, count] : visits) {
    if (count == loads.instants()) cuts.add(si<Length>(s), jumps_at(loads, length, si<Length>(s)));
  }
  for (const Way& way : ways) {
    cuts.add(way.low, true);
    cuts.add(way.high, true);
  }
  // Where loads stand when a history that stays open begins and ends: beyond, none of them comes.
  if (loads.closed()) return;
  for (const std::size_t i : {std::size_t{0}, loads.instants() - 1}) {
    for (const Length& s : borders_of(loads.kept_diagram(i))) cuts.add(s, true);
  }
}

/// Which of several laws holds at a place; where two places differ, something jumps between them.
using Choices = std::vector<int>;

/// Where the checks choose among laws by sizes that vary along a segment.
class ChoicesInSegment {
 public:
  ChoicesInSegment(const Project& project, const std::vector<BendingZone>& zones,
                   std::size_t segment)
      : project_(&project),
        limits_(thickness_limits_of(project)),
        materials_(materials_of(project, segment)),
        zones_(&zones),
        segment_(&project.beam.segments[segment]) {}

  Choices at(double fraction) const {
    const Section section = interpolate(segment_->from, segment_->to, fraction);
    Choices choices;
    for (const Length& thickness : thicknesses_of(section)) {
      choices.push_back(static_cast<int>(
          std::lower_bound(limits_.begin(), limits_.end(), thickness) - limits_.begin()));
    }
    const Length s = segment_->start + fraction * segment_->length;
    for (const BendingAxis axis : {BendingAxis::y, BendingAxis::z}) {
      const auto lag = shear_lag_at(*zones_, section, {s}, axis);
      // The laws of EN 1993-1-5, table 3.1.
      choices.push_back(law_of(lag));
    }
    add_path_lags(section, {s}, choices);
    // Of a side, a place counts a little within it: that would move the border that is sought.
    const Side inwards =
        fraction <= 0.0 ? Side::behind : (fraction >= 1.0 ? Side::before : Side::both);
    for (const int of : plate_choices_at(*project_, {s, inwards})) choices.push_back(of);
    return choices;
  }

  /// A place between two where the choices of the first end.
  double end_of(const Choices& choices, double from, double to) const {
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (from + to);
      if (middle <= from || middle >= to) break;
      (at(middle) == choices ? from : to) = middle;
    }
    return to;
  }

 private:
  static int law_of(const std::optional<ShearLag>& lag) {
    return !lag ? 0 : (lag->kappa <= 0.02 ? 1 : (lag->kappa <= 0.7 ? 2 : 3));
  }

  /// Of each plate of a path, whichever there are here.
  void add_path_lags(const Section& section, const Station& station, Choices& choices) const {
    const auto* const path = std::get_if<ThinWalled>(&section.outer);
    if (path == nullptr || section.inner || zones_->empty()) return;
    const auto of = path_section_of(*path, materials_);
    if (!of) return;
    for (const PathPlate& plate : of->plates) {
      for (const BendingAxis axis : {BendingAxis::y, BendingAxis::z})
        choices.push_back(law_of(
            plate_lag_at(*zones_, station, axis, lagging_width_of(*of, plate), plate.thickness)));
    }
  }

  const Project* project_;
  std::vector<Length> limits_;
  PlateMaterials materials_;
  const std::vector<BendingZone>* zones_;
  const Segment* segment_;
};

/// Sizes vary linearly, so that a plate crosses a limit once; shear lag's kappa may turn.
void add_choices(const Project& project, const std::vector<BendingZone>& zones, std::size_t index,
                 Gathered& cuts) {
  const Segment& segment = project.beam.segments[index];
  if (segment.from == segment.to) return;
  const ChoicesInSegment choices(project, zones, index);
  constexpr int parts = 8;
  double from = 0.0;
  Choices before = choices.at(from);
  for (int k = 1; k <= parts; ++k) {
    const double to = static_cast<double>(k) / parts;
    const Choices behind = choices.at(to);
    while (before != behind) {
      from = choices.end_of(before, from, to);
      cuts.add(segment.start + from * segment.length, true);
      before = choices.at(from);
    }
    from = to;
  }
}

}  // namespace

std::vector<BeamCut> beam_cuts_of(const Project& project, const std::deque<SituationRun>& runs,
                                  const std::vector<BendingZone>& zones) {
  const TaperedBeam& beam = project.beam;
  Gathered cuts(beam);
  cuts.add(Length{}, true);
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    const bool last = i + 1 == beam.segments.size();
    const bool jumps = last || kinks_behind(beam, i) ||
                       !(materials_of(project, i) == materials_of(project, i + 1));
    cuts.add(beam.segments[i].end(), jumps);
  }
  for (const BeamHole& hole : project.holes) {
    const Length radius = 0.5 * hole.hole.diameter;
    cuts.add(hole.s - radius, false);
    cuts.add(hole.s, false, true);
    cuts.add(hole.s + radius, false);
  }
  for (const Diaphragm& diaphragm : beam.diaphragms) cuts.add(diaphragm.s, true);
  for (const BeamPoint& point : beam.points) cuts.add(point.s, false);
  for (const NamedPoint& point : project.points) cuts.add(point.s, false, true);
  for (const BeamDetail& stretch : project.fatigue.details) {
    cuts.add(stretch.from, true, true);
    cuts.add(stretch.to, true, true);
  }
  for (const AttachmentWeld& weld : project.fatigue.attachments) {
    const bool at_a_place = weld.detail.from == weld.detail.to;
    if (at_a_place && may_govern(project.fatigue, weld)) cuts.add(weld.detail.from, true, true);
  }
  for (const SituationRun& run : runs) add_loads(run, beam.length(), cuts);
  for (const BendingZone& zone : zones) {
    cuts.add(zone.from, true);
    cuts.add(zone.to, true);
  }
  for (std::size_t i = 0; i < beam.segments.size(); ++i) add_choices(project, zones, i, cuts);
  return std::move(cuts).cuts();
}

}  // namespace boxbeam
