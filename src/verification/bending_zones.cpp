#include "boxbeam/verification/bending_zones.hpp"

#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

constexpr int samples_per_piece = 32;
/// Moments below this part of the largest are zero.
constexpr double nothing = 1e-6;

const Polynomial<5>& moment_of(const CutForcePiece& piece, BendingAxis about) {
  return about == BendingAxis::y ? piece.M_y : piece.M_z;
}

/// The diagram with the largest bending moment of all instants.
struct LargestBending {
  const LoadHistory* loads = nullptr;
  std::size_t instant = 0;
  double moment = 0.0;
};

double largest_moment_of(const CutForceDiagram& diagram, BendingAxis about) {
  double largest = 0.0;
  for (const CutForcePiece& piece : diagram.pieces) {
    for (int j = 0; j <= samples_per_piece; ++j) {
      const double x = piece.length.value() * j / samples_per_piece;
      largest = std::max(largest, std::abs(moment_of(piece, about)(x)));
    }
  }
  return largest;
}

LargestBending largest_bending_of(const std::deque<SituationRun>& runs, BendingAxis about) {
  LargestBending largest;
  for (const SituationRun& run : runs) {
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const double moment = largest_moment_of(run.loads.diagram(i), about);
      if (largest.loads == nullptr || moment > largest.moment) largest = {&run.loads, i, moment};
    }
  }
  return largest;
}

/// Places where the moment is zero or changes its sign, ascending.
std::vector<double> zeros_of(const CutForceDiagram& diagram, double largest, BendingAxis about) {
  std::vector<double> zeros;
  double s_before = 0.0;
  double m_before = 0.0;
  for (const CutForcePiece& piece : diagram.pieces) {
    for (int j = 0; j <= samples_per_piece; ++j) {
      const double x = piece.length.value() * j / samples_per_piece;
      const double s = piece.start.value() + x;
      const double m = moment_of(piece, about)(x) / largest;
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
bool peaks_at(const CutForceDiagram& diagram, BendingAxis about, double from, double to,
              double end) {
  double largest = 0.0;
  double at_end = 0.0;
  for (const CutForcePiece& piece : diagram.pieces) {
    for (int j = 0; j <= samples_per_piece; ++j) {
      const double x = piece.length.value() * j / samples_per_piece;
      const double s = piece.start.value() + x;
      const double slack = nothing * (to - from);
      if (s < from - slack || s > to + slack) continue;
      const double moment = std::abs(moment_of(piece, about)(x));
      largest = std::max(largest, moment);
      if (std::abs(s - end) <= slack) at_end = std::max(at_end, moment);
    }
  }
  return at_end >= (1.0 - nothing) * largest;
}

/// Nothing where the moment is nowhere above `least`.
std::vector<BendingZone> zones_about(BendingAxis about, const Project& project,
                                     const LargestBending& largest, double least) {
  if (largest.loads == nullptr || largest.moment <= least) return {};
  const double length = project.beam.length().value();
  const CutForceDiagram& diagram = largest.loads->diagram(largest.instant);
  std::vector<double> borders = zeros_of(diagram, largest.moment, about);
  const bool free_start = !borders.empty() && borders.front() < nothing * length;
  const bool free_end = !borders.empty() && borders.back() > (1.0 - nothing) * length;
  if (!free_start) borders.insert(borders.begin(), 0.0);
  if (!free_end) borders.push_back(length);

  const BeamLoads loads = largest.loads->loads_at(largest.loads->time_of(largest.instant));
  const Eigen::Index across = about == BendingAxis::y ? 2 : 1;
  std::vector<BendingZone> zones;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    const double from = borders[i];
    const double to = borders[i + 1];
    // Neighbouring samples of a stretch that is not bent.
    if (to - from < 1e-3 * length) continue;
    const bool clamped =
        (i == 0 && !free_start && peaks_at(diagram, about, from, to, from)) ||
        (i + 2 == borders.size() && !free_end && peaks_at(diagram, about, from, to, to));
    const bool peak =
        std::any_of(loads.points.begin(), loads.points.end(), [&](const PointLoad& load) {
          const double s = load.s.value();
          return s > from + 1e-6 * length && s < to - 1e-6 * length &&
                 std::abs(load.force[across]) * length > 1e-3 * largest.moment;
        });
    zones.push_back({si<Length>(from), si<Length>(to),
                     si<Length>((clamped ? 2.0 : 1.0) * (to - from)),
                     clamped ? BendingRegion::cantilever
                             : (peak ? BendingRegion::hogging : BendingRegion::sagging),
                     about});
  }
  return zones;
}

/// The plates that shear lag works in: width between supports, thickness, area of stiffeners.
struct WidePlates {
  Length clear, middles, thickness;
  Area stiffeners;  ///< within half of the width, of the plate with more of them
};

std::optional<WidePlates> wide_plates_of(const Profile& profile, BendingAxis axis) {
  const bool flanges = axis == BendingAxis::y;
  WidePlates plates;
  if (const auto* box = std::get_if<Box>(&profile)) {
    const Length width = flanges ? box->width : box->height;
    const Length one = flanges ? box->left_web : box->top_flange;
    const Length other = flanges ? box->right_web : box->bottom_flange;
    plates.clear = width - one - other;
    plates.middles = width - 0.5 * (one + other);
    plates.thickness = flanges ? std::min(box->top_flange, box->bottom_flange)
                               : std::min(box->left_web, box->right_web);
    for (const BoxPlate plate : {flanges ? BoxPlate::top_flange : BoxPlate::left_web,
                                 flanges ? BoxPlate::bottom_flange : BoxPlate::right_web}) {
      Area of;
      for (const Stiffener& bar : box->stiffeners) {
        if (bar.plate == plate) of += bar.depth * bar.thickness;
      }
      plates.stiffeners = std::max(plates.stiffeners, 0.5 * of);
    }
    return plates;
  }
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    const Length width = flanges ? tube->width : tube->height;
    plates.clear = width - 2.0 * tube->wall;
    plates.middles = width - tube->wall;
    plates.thickness = tube->wall;
    return plates;
  }
  return std::nullopt;
}

}  // namespace

std::vector<BendingZone> bending_zones_of(const Project& project,
                                          const std::deque<SituationRun>& runs) {
  if (!project.strength.shear_lag) return {};
  const LargestBending upright = largest_bending_of(runs, BendingAxis::y);
  // Beside the other one, and beside the forces over the beam's length, it is round-off.
  double force = 0.0;
  for (const SituationRun& run : runs) force = std::max(force, run.loads.largest_force());
  double least = 1e-9 * std::max(upright.moment, force * project.beam.length().value());
  if (!project.in_space) return zones_about(BendingAxis::y, project, upright, least);
  const LargestBending sideways = largest_bending_of(runs, BendingAxis::z);
  least = std::max(least, 1e-9 * sideways.moment);
  std::vector<BendingZone> zones = zones_about(BendingAxis::y, project, upright, least);
  const std::vector<BendingZone> others = zones_about(BendingAxis::z, project, sideways, least);
  zones.insert(zones.end(), others.begin(), others.end());
  return zones;
}

std::optional<ShearLag> plate_lag_at(const std::vector<BendingZone>& zones, const Station& station,
                                     BendingAxis axis, Length b_0, Length thickness,
                                     Area stiffeners) {
  const Length s = station.s;
  const auto zone = std::find_if(zones.begin(), zones.end(), [&](const BendingZone& z) {
    if (z.axis != axis || s < z.from || s > z.to) return false;
    return station.side == Side::before ? s > z.from : station.side == Side::both || s < z.to;
  });
  if (zone == zones.end() || !shear_lag_counts(b_0, zone->effective_length)) return std::nullopt;
  ShearLag lag;
  lag.b_0 = b_0;
  lag.effective_length = zone->effective_length;
  lag.thickness = thickness;
  lag.stiffeners = stiffeners;
  lag.kappa = shear_lag_kappa(lag.b_0, lag.thickness, lag.stiffeners, lag.effective_length);
  lag.region = zone->region;
  lag.beta = shear_lag_factor(lag.kappa, zone->region);
  return lag;
}

double ultimate_share_of(const ShearLag& lag) {
  return std::max(lag.beta, std::pow(lag.beta, lag.kappa));
}

std::optional<ShearLag> shear_lag_at(const std::vector<BendingZone>& zones, const Section& section,
                                     const Station& station, BendingAxis axis) {
  const auto plates = wide_plates_of(section.outer, axis);
  if (!plates) return std::nullopt;
  auto lag = plate_lag_at(zones, station, axis, 0.5 * plates->middles, plates->thickness,
                          plates->stiffeners);
  if (!lag) return std::nullopt;
  // What is left out lies in the middle, of the width between the webs' middles.
  lag->flange_part = std::max(1e-3, 1.0 - (1.0 - lag->beta) * (plates->middles / plates->clear));
  return lag;
}

ShearLags shear_lags_at(const std::vector<BendingZone>& zones, const Section& section,
                        const Station& station) {
  return {shear_lag_at(zones, section, station, BendingAxis::y),
          shear_lag_at(zones, section, station, BendingAxis::z)};
}

SectionProperties effective_properties_of(const Section& section, const std::vector<Hole>& holes,
                                          const ShearLags& lags) {
  return properties_of(section, holes, lags.flanges ? lags.flanges->flange_part : 1.0,
                       lags.webs ? lags.webs->flange_part : 1.0);
}

}  // namespace boxbeam
