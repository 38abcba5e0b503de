#include "boxbeam/verification/bending_zones.hpp"

#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

constexpr int samples_per_piece = 32;
/// Moments below this part of the largest are zero.
constexpr double nothing = 1e-6;

/// The diagram with the largest bending moment of all instants.
struct LargestBending {
  const LoadHistory* loads = nullptr;
  std::size_t instant = 0;
  double moment = 0.0;
};

double largest_moment_of(const CutForceDiagram& diagram) {
  double largest = 0.0;
  for (const CutForcePiece& piece : diagram.pieces) {
    for (int j = 0; j <= samples_per_piece; ++j) {
      const double x = piece.length.value() * j / samples_per_piece;
      largest = std::max(largest, std::abs(piece.M_y(x)));
    }
  }
  return largest;
}

LargestBending largest_bending_of(const std::deque<SituationRun>& runs) {
  LargestBending largest;
  for (const SituationRun& run : runs) {
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const double moment = largest_moment_of(run.loads.diagram(i));
      if (largest.loads == nullptr || moment > largest.moment) largest = {&run.loads, i, moment};
    }
  }
  return largest;
}

/// Places where the moment is zero or changes its sign, ascending.
std::vector<double> zeros_of(const CutForceDiagram& diagram, double largest) {
  std::vector<double> zeros;
  double s_before = 0.0;
  double m_before = 0.0;
  for (const CutForcePiece& piece : diagram.pieces) {
    for (int j = 0; j <= samples_per_piece; ++j) {
      const double x = piece.length.value() * j / samples_per_piece;
      const double s = piece.start.value() + x;
      const double m = piece.M_y(x) / largest;
      if (std::abs(m) < nothing)
        zeros.push_back(s);
      else if (m * m_before < 0.0 && std::abs(m_before) >= nothing)
        zeros.push_back(s_before + (s - s_before) * m_before / (m_before - m));
      s_before = s;
      m_before = m;
    }
  }
  return zeros;
}

/// Whether the moment is largest at an end of a stretch, as at a clamped end of the beam; a couple
/// that the moment has fallen to there is none.
bool peaks_at(const CutForceDiagram& diagram, double from, double to, double end) {
  double largest = 0.0;
  double at_end = 0.0;
  for (const CutForcePiece& piece : diagram.pieces) {
    for (int j = 0; j <= samples_per_piece; ++j) {
      const double x = piece.length.value() * j / samples_per_piece;
      const double s = piece.start.value() + x;
      const double slack = nothing * (to - from);
      if (s < from - slack || s > to + slack) continue;
      const double moment = std::abs(piece.M_y(x));
      largest = std::max(largest, moment);
      if (std::abs(s - end) <= slack) at_end = std::max(at_end, moment);
    }
  }
  return at_end >= (1.0 - nothing) * largest;
}

}  // namespace

std::vector<BendingZone> bending_zones_of(const Project& project,
                                          const std::deque<SituationRun>& runs) {
  if (!project.strength.shear_lag) return {};
  const LargestBending largest = largest_bending_of(runs);
  if (largest.loads == nullptr || largest.moment <= 0.0) return {};
  const double length = project.beam.length().value();
  const CutForceDiagram& diagram = largest.loads->diagram(largest.instant);
  std::vector<double> borders = zeros_of(diagram, largest.moment);
  const bool free_start = !borders.empty() && borders.front() < nothing * length;
  const bool free_end = !borders.empty() && borders.back() > (1.0 - nothing) * length;
  if (!free_start) borders.insert(borders.begin(), 0.0);
  if (!free_end) borders.push_back(length);

  const BeamLoads loads = largest.loads->loads_at(largest.loads->time_of(largest.instant));
  std::vector<BendingZone> zones;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    const double from = borders[i];
    const double to = borders[i + 1];
    // Neighbouring samples of a stretch that is not bent.
    if (to - from < 1e-3 * length) continue;
    const bool clamped = (i == 0 && !free_start && peaks_at(diagram, from, to, from)) ||
                         (i + 2 == borders.size() && !free_end && peaks_at(diagram, from, to, to));
    const bool peak =
        std::any_of(loads.points.begin(), loads.points.end(), [&](const PointLoad& load) {
          const double s = load.s.value();
          return s > from + 1e-6 * length && s < to - 1e-6 * length &&
                 std::abs(load.force.z()) * length > 1e-3 * largest.moment;
        });
    zones.push_back({si<Length>(from), si<Length>(to),
                     si<Length>((clamped ? 2.0 : 1.0) * (to - from)),
                     clamped ? BendingRegion::cantilever
                             : (peak ? BendingRegion::hogging : BendingRegion::sagging)});
  }
  return zones;
}

std::optional<ShearLag> shear_lag_at(const std::vector<BendingZone>& zones, const Section& section,
                                     Length s) {
  const auto zone = std::find_if(zones.begin(), zones.end(),
                                 [&](const BendingZone& z) { return s >= z.from && s <= z.to; });
  if (zone == zones.end()) return std::nullopt;
  Length clear, middles, thickness;
  Area stiffeners;
  if (const auto* box = std::get_if<Box>(&section.outer)) {
    clear = box->width - box->left_web - box->right_web;
    middles = box->width - 0.5 * (box->left_web + box->right_web);
    thickness = std::min(box->top_flange, box->bottom_flange);
    for (const BoxPlate plate : {BoxPlate::top_flange, BoxPlate::bottom_flange}) {
      Area of;
      for (const Stiffener& bar : box->stiffeners) {
        if (bar.plate == plate) of += bar.depth * bar.thickness;
      }
      stiffeners = std::max(stiffeners, 0.5 * of);
    }
  } else if (const auto* tube = std::get_if<RectangularTube>(&section.outer)) {
    clear = tube->width - 2.0 * tube->wall;
    middles = tube->width - tube->wall;
    thickness = tube->wall;
  } else {
    return std::nullopt;
  }
  ShearLag lag;
  lag.b_0 = 0.5 * middles;
  lag.effective_length = zone->effective_length;
  if (!shear_lag_counts(lag.b_0, lag.effective_length)) return std::nullopt;
  lag.kappa = shear_lag_kappa(lag.b_0, thickness, stiffeners, lag.effective_length);
  lag.beta = shear_lag_factor(lag.kappa, zone->region);
  // What is left out lies in the middle, of the width between the webs' middles.
  lag.flange_part = std::max(1e-3, 1.0 - (1.0 - lag.beta) * (middles / clear));
  return lag;
}

}  // namespace boxbeam
