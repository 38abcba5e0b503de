#include "boxbeam/verification/warping_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "axial_bimoment.hpp"
#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/section/warping.hpp"

namespace boxbeam {
namespace {

/// An end of a segment of open thin walls, or a place in it.
struct WarpingEnd {
  Warping warping;
  double GI_T = 0.0, EI_w = 0.0;
  SectionPlace shear_centre;
};

struct WarpingSegment {
  const Segment* segment = nullptr;
  double least_yield = 0.0;
  std::vector<WarpingEnd> ends;
};

/// The largest torque of a segment, about its shear centre.
struct LargestTorque {
  double size = 0.0, s = 0.0;
};

double thickest_of(const ThinWalled& path) {
  Length most;
  for (const ThinWall& wall : path.walls) most = std::max(most, wall.thickness);
  return most.value();
}

/// Nothing where what warping stresses fades within the thickness of a wall, as where all walls
/// meet in one line: bars do not say it.
std::optional<WarpingEnd> warping_end_of(const Project& project, const Section& section) {
  const auto* const path = std::get_if<ThinWalled>(&section.outer);
  if (path == nullptr || section.inner) return std::nullopt;
  const auto warping = warping_of(section.outer);
  const TorsionProperties torsion = torsion_properties_of(section);
  if (!warping || !torsion.I_T || !torsion.shear_centre) return std::nullopt;
  WarpingEnd of{*warping, project.model.shear_modulus * torsion.I_T->value(),
                project.model.youngs_modulus * warping->I_w, *torsion.shear_centre};
  if (!(of.EI_w > of.GI_T * std::pow(thickest_of(*path), 2))) return std::nullopt;
  return of;
}

WarpingSegment warping_segment_of(const Project& project, std::size_t index) {
  const Segment& segment = project.beam.segments[index];
  WarpingSegment of{&segment, 0.0, {}};
  // Between unlike ends something may be largest inside.
  const int parts = segment.from == segment.to ? 1 : 8;
  for (int i = 0; i <= parts; ++i) {
    const auto end = warping_end_of(
        project, interpolate(segment.from, segment.to, static_cast<double>(i) / parts));
    if (end) of.ends.push_back(*end);
  }
  const auto* const path = std::get_if<ThinWalled>(&segment.from.outer);
  if (path == nullptr) return of;
  const auto yield = yield_strength_of(materials_of(project, index).of(PlateKind::wall),
                                       si<Length>(thickest_of(*path)));
  if (yield) of.least_yield = yield->value();
  return of;
}

LargestTorque torque_in(const WarpingSegment& of, const CutForceDiagram& diagram) {
  LargestTorque most;
  const double from = of.segment->start.value(), to = of.segment->end().value();
  for (const CutForcePiece& piece : diagram.pieces) {
    const double start = piece.start.value();
    const double low = std::max(from, start) - start;
    const double high = std::min(to, piece.end().value()) - start;
    if (!(high > low)) continue;
    for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double x = std::lerp(low, high, part);
      for (const WarpingEnd& end : of.ends) {
        const double size = std::abs(piece.T(x) + piece.V_y(x) * end.shear_centre.z.value() -
                                     piece.V_z(x) * end.shear_centre.y.value());
        if (size > most.size) most = {size, start + x};
      }
    }
  }
  return most;
}

/// The largest torque of all segments that warp, with load factors.
LargestTorque torque_of(const std::vector<WarpingSegment>& segments,
                        const std::deque<SituationRun>& runs) {
  LargestTorque most;
  for (const SituationRun& run : runs) {
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const CutForceDiagram diagram = run.loads.diagram(i);
      for (const WarpingSegment& of : segments) {
        const LargestTorque here = torque_in(of, diagram);
        const double size = run.situation->load_factor * here.size;
        if (size > most.size) most = {size, here.s};
      }
    }
  }
  return most;
}

}  // namespace

double largest_bimoment(double torque, double GI_T, double EI_w, double length) {
  const double k = std::sqrt(GI_T / EI_w);
  return torque / k * std::tanh(k * length);
}

WarpingFound look_at_warping(const Project& project, const std::deque<SituationRun>& runs) {
  WarpingFound found;
  std::vector<WarpingSegment> segments;
  for (std::size_t k = 0; k < project.beam.segments.size(); ++k) {
    WarpingSegment of = warping_segment_of(project, k);
    if (!of.ends.empty()) segments.push_back(std::move(of));
  }
  if (segments.empty()) return found;
  const LargestTorque torque = torque_of(segments, runs);
  AxialBimoments axial = axial_bimoments_of(project, runs);
  const double length = project.beam.length().value();
  double most = 0.0, most_share = 0.0;
  for (const WarpingSegment& of : segments) {
    for (const WarpingEnd& end : of.ends) {
      const double bimoment =
          largest_bimoment(torque.size, end.GI_T, end.EI_w, length) + axial.largest;
      const double stress = bimoment * end.warping.largest / end.warping.I_w;
      most = std::max(most, stress);
      most_share = std::max(most_share, project.strength.required * project.strength.gamma_M0 *
                                            stress / of.least_yield);
    }
  }
  if (axial.gate) found.gates.push_back(std::move(*axial.gate));
  constexpr double much = 0.1;
  if (!(most_share > much)) return found;
  const std::string by_torque =
      torque.size > 0.0
          ? fmt::format("{:.3g} kN m about their shear centre, at s = {} m", 1e-3 * torque.size,
                        to_text(Station{si<Length>(torque.s), Side::both}))
          : "";
  const char* const both = torque.size > 0.0 && axial.largest > 0.0 ? ", and " : "";
  found.not_judged.push_back(
      {Criterion::yield, "warping of open sections",
       fmt::format("{}{}{}, may stress their edges along the beam by up to {:.3g} MPa more, which "
                   "no check counts",
                   by_torque, both, axial.words, 1e-6 * most)});
  return found;
}

}  // namespace boxbeam
