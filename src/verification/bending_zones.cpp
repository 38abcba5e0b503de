#include "boxbeam/verification/bending_zones.hpp"

#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

constexpr int samples_per_piece = 32;
/// Moments below this part of the largest are zero.
constexpr double nothing = 1e-6;
/// Situations whose moment at a place is below this part of the largest there govern nothing there.
constexpr double little = 0.1;
/// Steps of the beam by which the moments of situations are compared.
constexpr std::size_t steps_along = 256;

const Polynomial<5>& moment_of(const CutForcePiece& piece, BendingAxis about) {
  return about == BendingAxis::y ? piece.M_y : piece.M_z;
}

/// The diagram with the largest bending moment of all instants.
struct LargestBending {
  const LoadHistory* loads = nullptr;
  std::size_t instant = 0;
  double moment = 0.0;
};

/// Calls f(s, moment) at even steps of every piece.
template <class F>
void each_sample(const CutForceDiagram& diagram, BendingAxis about, const F& f) {
  for (const CutForcePiece& piece : diagram.pieces) {
    for (int j = 0; j <= samples_per_piece; ++j) {
      const double x = piece.length.value() * j / samples_per_piece;
      f(piece.start.value() + x, moment_of(piece, about)(x));
    }
  }
}

double largest_moment_of(const CutForceDiagram& diagram, BendingAxis about) {
  double largest = 0.0;
  each_sample(diagram, about,
              [&](double, double moment) { largest = std::max(largest, std::abs(moment)); });
  return largest;
}

LargestBending largest_bending_of(const SituationRun& run, BendingAxis about) {
  LargestBending largest;
  for (std::size_t i = 0; i < run.loads.instants(); ++i) {
    const double moment = largest_moment_of(run.loads.diagram(i), about);
    if (largest.loads == nullptr || moment > largest.moment) largest = {&run.loads, i, moment};
  }
  return largest;
}

/// Of each situation.
std::vector<LargestBending> largest_bendings_of(const std::deque<SituationRun>& runs,
                                                BendingAxis about) {
  std::vector<LargestBending> largest;
  for (const SituationRun& run : runs) largest.push_back(largest_bending_of(run, about));
  return largest;
}

/// The first of those with the largest moment.
std::size_t leading_of(const std::vector<LargestBending>& bendings) {
  const auto most = std::max_element(
      bendings.begin(), bendings.end(),
      [](const LargestBending& a, const LargestBending& b) { return a.moment < b.moment; });
  return static_cast<std::size_t>(most - bendings.begin());
}

double largest_moment_of(const std::vector<LargestBending>& bendings) {
  return bendings.empty() ? 0.0 : bendings[leading_of(bendings)].moment;
}

/// Places where the moment is zero or changes its sign, ascending.
std::vector<double> zeros_of(const CutForceDiagram& diagram, double largest, BendingAxis about) {
  std::vector<double> zeros;
  double s_before = 0.0;
  double m_before = 0.0;
  each_sample(diagram, about, [&](double s, double moment) {
    const double m = moment / largest;
    if (std::abs(m) < nothing)
      zeros.push_back(s);
    else if (m * m_before < 0.0 && std::abs(m_before) >= nothing)
      zeros.push_back(s_before + (s - s_before) * m_before / (m_before - m));
    s_before = s;
    m_before = m;
  });
  return zeros;
}

/// Whether the moment is largest at an end of a stretch, as at a clamped end of the beam; a couple
/// that the moment has fallen to there is none.
bool peaks_at(const CutForceDiagram& diagram, BendingAxis about, double from, double to,
              double end) {
  double largest = 0.0;
  double at_end = 0.0;
  const double slack = nothing * (to - from);
  each_sample(diagram, about, [&](double s, double moment) {
    if (s < from - slack || s > to + slack) return;
    largest = std::max(largest, std::abs(moment));
    if (std::abs(s - end) <= slack) at_end = std::max(at_end, std::abs(moment));
  });
  return at_end >= (1.0 - nothing) * largest;
}

/// Whether the moment is anywhere more than nothing between two of its zeros: where the beam is not
/// bent over a stretch, every sample is one.
bool bends_between(const CutForceDiagram& diagram, double largest, BendingAxis about, double from,
                   double to) {
  const double slack = nothing * (to - from);
  bool bends = false;
  each_sample(diagram, about, [&](double s, double moment) {
    bends = bends || (s > from + slack && s < to - slack && std::abs(moment) >= nothing * largest);
  });
  return bends;
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
    if (!bends_between(diagram, largest.moment, about, from, to)) continue;
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

/// The largest moment of a situation at equal steps of the beam, of all its instants, with its load
/// factor.
std::vector<double> envelope_of(const SituationRun& run, BendingAxis about, double length) {
  std::vector<double> envelope(steps_along + 1, 0.0);
  for (std::size_t i = 0; i < run.loads.instants(); ++i) {
    const CutForceDiagram diagram = run.loads.diagram(i);
    for (std::size_t k = 0; k <= steps_along; ++k) {
      const double s = length * static_cast<double>(k) / steps_along;
      for (const Side side : {Side::before, Side::behind}) {
        const CutForces cut = diagram.at({si<Length>(s), side});
        const double moment = (about == BendingAxis::y ? cut.M_y : cut.M_z).value();
        envelope[k] = std::max(envelope[k], run.situation->load_factor * std::abs(moment));
      }
    }
  }
  return envelope;
}

/// The part of a zone between two steps of the beam; nothing where it does not reach there.
std::optional<BendingZone> part_of(BendingZone zone, Length from, Length to) {
  zone.from = std::max(zone.from, from);
  zone.to = std::min(zone.to, to);
  if (zone.from >= zone.to) return std::nullopt;
  return zone;
}

/// Whether another zone leaves no more of any plate wherever this one is. Lengths as alike as the
/// search for the governing place is exact are one.
bool covered(const BendingZone& zone, const std::vector<BendingZone>& by, double length) {
  constexpr double alike = 1e-4;
  const Length slack = si<Length>(alike * length);
  const auto beta_2 = [](const BendingZone& of) { return of.region != BendingRegion::sagging; };
  return std::any_of(by.begin(), by.end(), [&](const BendingZone& other) {
    return other.axis == zone.axis && other.from <= zone.from + slack &&
           other.to >= zone.to - slack && (beta_2(other) || !beta_2(zone)) &&
           other.effective_length <= (1.0 + alike) * zone.effective_length;
  });
}

/// Adds the parts of a situation's zones where it bends the beam by more than `little`: whole
/// steps, with those beside them.
void add_where_it_counts(const std::vector<BendingZone>& zones, const std::vector<double>& own,
                         const std::vector<double>& most, double length,
                         std::vector<BendingZone>& all) {
  const auto counts = [&](std::size_t k) { return own[k] > 0.0 && own[k] >= little * most[k]; };
  const auto counts_in = [&](std::size_t k) { return counts(k) || counts(k + 1); };
  const auto at = [&](std::size_t k) {
    return si<Length>(length * static_cast<double>(k) / steps_along);
  };
  for (std::size_t k = 0; k < steps_along; ++k) {
    if (!counts_in(k)) continue;
    const std::size_t first = k;
    while (k < steps_along && counts_in(k)) ++k;
    for (const BendingZone& zone : zones) {
      const auto part = part_of(zone, at(first), at(k));
      if (part && !covered(*part, all, length)) all.push_back(*part);
    }
  }
}

/// Those of the situation with the largest moment everywhere, of the others where they bend the
/// beam noticeably: a situation's shear lag is that of its own moments (EN 1993-1-5, 3.2.1).
std::vector<BendingZone> zones_of_all(BendingAxis about, const Project& project,
                                      const std::deque<SituationRun>& runs,
                                      const std::vector<LargestBending>& bendings, double least) {
  if (bendings.empty()) return {};
  const std::size_t leading = leading_of(bendings);
  std::vector<BendingZone> all = zones_about(about, project, bendings[leading], least);
  if (runs.size() < 2 || all.empty()) return all;
  const double length = project.beam.length().value();
  // Most situations bend the beam over the same lengths: then where they count need not be known.
  std::vector<std::vector<BendingZone>> others(runs.size());
  bool all_covered = true;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i == leading) continue;
    others[i] = zones_about(about, project, bendings[i], least);
    all_covered = all_covered &&
                  std::all_of(others[i].begin(), others[i].end(),
                              [&](const BendingZone& zone) { return covered(zone, all, length); });
  }
  if (all_covered) return all;
  std::vector<std::vector<double>> envelopes;
  std::vector<double> most(steps_along + 1, 0.0);
  for (const SituationRun& run : runs) {
    envelopes.push_back(envelope_of(run, about, length));
    for (std::size_t k = 0; k <= steps_along; ++k) most[k] = std::max(most[k], envelopes.back()[k]);
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (i != leading) add_where_it_counts(others[i], envelopes[i], most, length, all);
  }
  return all;
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

bool reaches(const BendingZone& zone, const Station& station) {
  const Length s = station.s;
  if (s < zone.from || s > zone.to) return false;
  return station.side == Side::before ? s > zone.from : station.side == Side::both || s < zone.to;
}

ShearLag lag_in(const BendingZone& zone, const WidePlate& plate) {
  ShearLag lag{plate};
  lag.effective_length = zone.effective_length;
  lag.kappa = shear_lag_kappa(lag.b_0, lag.thickness, lag.stiffeners, lag.effective_length);
  lag.region = zone.region;
  lag.beta = shear_lag_factor(lag.kappa, zone.region);
  return lag;
}

/// Of the zones at a station that in which least is left, by `share`.
template <class Share>
std::optional<ShearLag> least_lag_at(const std::vector<BendingZone>& zones, const Station& station,
                                     BendingAxis axis, const WidePlate& plate, const Share& share) {
  std::optional<ShearLag> least;
  for (const BendingZone& zone : zones) {
    if (zone.axis != axis || !reaches(zone, station)) continue;
    if (!shear_lag_counts(plate.b_0, zone.effective_length)) continue;
    const ShearLag lag = lag_in(zone, plate);
    if (!least || share(lag) < share(*least)) least = lag;
  }
  return least;
}

}  // namespace

std::vector<BendingZone> bending_zones_of(const Project& project,
                                          const std::deque<SituationRun>& runs) {
  if (!project.strength.shear_lag) return {};
  const std::vector<LargestBending> upright = largest_bendings_of(runs, BendingAxis::y);
  // Beside the other one, and beside the forces over the beam's length, it is round-off.
  double force = 0.0;
  for (const SituationRun& run : runs) force = std::max(force, run.loads.largest_force());
  double least = 1e-9 * std::max(largest_moment_of(upright), force * project.beam.length().value());
  if (!project.in_space) return zones_of_all(BendingAxis::y, project, runs, upright, least);
  const std::vector<LargestBending> sideways = largest_bendings_of(runs, BendingAxis::z);
  least = std::max(least, 1e-9 * largest_moment_of(sideways));
  std::vector<BendingZone> zones = zones_of_all(BendingAxis::y, project, runs, upright, least);
  const std::vector<BendingZone> others =
      zones_of_all(BendingAxis::z, project, runs, sideways, least);
  zones.insert(zones.end(), others.begin(), others.end());
  return zones;
}

std::optional<ShearLag> plate_lag_at(const std::vector<BendingZone>& zones, const Station& station,
                                     BendingAxis axis, Length b_0, Length thickness,
                                     Area stiffeners) {
  return least_lag_at(zones, station, axis, {b_0, thickness, stiffeners, {}, {}},
                      [](const ShearLag& lag) { return lag.beta; });
}

double ultimate_share_at(const std::vector<BendingZone>& zones, const Station& station,
                         BendingAxis axis, Length b_0, Length thickness, Area stiffeners) {
  const auto lag =
      least_lag_at(zones, station, axis, {b_0, thickness, stiffeners, {}, {}}, ultimate_share_of);
  return lag ? ultimate_share_of(*lag) : 1.0;
}

double ultimate_share_at(const std::vector<BendingZone>& zones, const Section& section,
                         const Station& station, BendingAxis axis) {
  const auto plates = wide_plates_of(section.outer, axis);
  if (!plates) return 1.0;
  return ultimate_share_at(zones, station, axis, 0.5 * plates->middles, plates->thickness,
                           plates->stiffeners);
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
