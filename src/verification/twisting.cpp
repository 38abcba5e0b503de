#include "boxbeam/verification/twisting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "beam_holds.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/section/warping.hpp"
#include "boxbeam/strength/twisting_buckling.hpp"
#include "boxbeam/verification/design_factor.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/judged_section.hpp"

namespace boxbeam {
namespace {

constexpr double unheld = std::numeric_limits<double>::infinity();

/// An end of a segment of thin walls; around cells, too, for a small cell hardly resists twisting.
struct OpenEnd {
  double radius_squared = 0.0, GI_T = 0.0, EI_w = 0.0;
  double y_0 = 0.0, z_0 = 0.0, coupling = 0.0;  ///< as `TwistingLoad` has them
};

struct OpenSegment {
  double from = 0.0, to = 0.0;
  std::vector<OpenEnd> ends;
};

std::optional<OpenEnd> open_end_of(const Project& project, const Station& at) {
  const Section section = judged_section_at(project, at);
  if (!std::holds_alternative<ThinWalled>(section.outer)) return std::nullopt;
  const TorsionProperties torsion = torsion_properties_of(section);
  if (!torsion.I_T || !torsion.shear_centre) return std::nullopt;
  const SectionProperties p = properties_of(section);
  const double y = (torsion.shear_centre->y - p.centroid_y).value();
  const double z = (torsion.shear_centre->z - p.centroid_z).value();
  OpenEnd of;
  of.radius_squared = (p.I_y + p.I_z).value() / p.area.value() + y * y + z * z;
  of.GI_T = project.model.shear_modulus * torsion.I_T->value();
  if (!section.inner)
    of.EI_w = project.model.youngs_modulus * warping_constant_of(section.outer).value_or(0.0);
  const double radius = std::sqrt(of.radius_squared);
  of.y_0 = std::abs(y) / radius;
  of.z_0 = std::abs(z) / radius;
  of.coupling = std::abs(p.I_yz.value()) / std::sqrt(p.I_y.value() * p.I_z.value());
  return of;
}

std::vector<OpenSegment> open_segments_of(const Project& project) {
  std::vector<OpenSegment> all;
  for (const Segment& segment : project.beam.segments) {
    OpenSegment of{segment.start.value(), segment.end().value(), {}};
    std::vector<Station> stations{{segment.start, Side::behind}, {segment.end(), Side::before}};
    // Between unlike ends something may be largest inside.
    constexpr int inside = 8;
    for (int i = 1; i < inside && segment.from != segment.to; ++i)
      stations.push_back({segment.start + segment.length * (static_cast<double>(i) / inside)});
    for (const Station& at : stations) {
      if (const auto end = open_end_of(project, at)) of.ends.push_back(*end);
    }
    if (!of.ends.empty()) all.push_back(std::move(of));
  }
  return all;
}

/// Largest compression along a segment [N].
double compression_in(const OpenSegment& of, const CutForceDiagram& diagram) {
  double most = 0.0;
  for (const CutForcePiece& piece : diagram.pieces) {
    const double start = piece.start.value();
    const double low = std::max(of.from, start) - start;
    const double high = std::min(of.to, start + piece.length.value()) - start;
    if (!(high > low)) continue;
    for (const double part : {0.0, 0.5, 1.0})
      most = std::max(most, -piece.N(low + part * (high - low)));
  }
  return most;
}

/// The longest way between places held against turning that a segment reaches over.
double length_over(const OpenSegment& of, std::vector<double> held, double beam) {
  if (held.empty()) return unheld;
  std::sort(held.begin(), held.end());
  const double near = 1e-6 * beam;
  double longest = 0.0;
  if (of.from < held.front() - near || of.to > held.back() + near) return unheld;
  for (std::size_t k = 0; k + 1 < held.size(); ++k) {
    if (held[k + 1] > of.from + near && held[k] < of.to - near)
      longest = std::max(longest, held[k + 1] - held[k]);
  }
  if (!(longest > 0.0)) return unheld;
  return longest;
}

/// What is largest anywhere, each by itself.
TwistingLoad worst_of(const std::vector<OpenSegment>& segments, const SecondOrderEstimate& of) {
  TwistingLoad load;
  load.about_y = of.in_plane.part;
  load.about_z = of.across ? of.across->part : 0.0;
  for (const OpenSegment& segment : segments) {
    for (const OpenEnd& end : segment.ends) {
      load.y_0 = std::max(load.y_0, end.y_0);
      load.z_0 = std::max(load.z_0, end.z_0);
      load.coupling = std::max(load.coupling, end.coupling);
    }
  }
  return load;
}

}  // namespace

std::optional<BucklingLoad> twisting_load_of(const Project& project,
                                             const std::deque<SituationRun>& runs,
                                             const SecondOrderEstimate& estimate) {
  const std::vector<OpenSegment> segments = open_segments_of(project);
  if (segments.empty()) return std::nullopt;
  const double beam = project.beam.length().value();
  BucklingLoad load;
  double longest = unheld;
  for (const SituationRun& run : runs) {
    const double factor = design_factor_of(project, *run.situation);
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const CutForceDiagram diagram = run.loads.diagram(i);
      std::optional<BeamHolds> holds;
      for (const OpenSegment& of : segments) {
        const double N = factor * compression_in(of, diagram);
        if (!(N > 0.0)) continue;
        const Time time = run.loads.time_of(i);
        if (!holds) holds = holds_of(project, run.motion->supports(run.loads.loads_at(time)));
        const double length = length_over(of, holds->turning.at, beam);
        for (const OpenEnd& end : of.ends) {
          const double part =
              N * twisting_per_force(end.GI_T, end.EI_w, length, end.radius_squared);
          if (part <= load.part) continue;
          longest = length;
          load = {part, time, index_of(project, *run.situation), holds->turning.words,
                  !holds->turning.said};
        }
      }
    }
  }
  TwistingLoad worst = worst_of(segments, estimate);
  worst.twisting = load.part;
  const double x = twisting_part(worst), bending = std::max(worst.about_y, worst.about_z);
  constexpr double more = 1.0 + 1e-3;
  if (x <= no_buckling_below || x <= more * bending) return std::nullopt;
  load.held += fmt::format(", by twisting alone N/N_cr,T = {:.3g} ", load.part) +
               (std::isfinite(longest) ? fmt::format("with L_T = {:.3g} m", longest)
                                       : std::string("without what resists warping"));
  load.part = x;
  return load;
}

}  // namespace boxbeam
