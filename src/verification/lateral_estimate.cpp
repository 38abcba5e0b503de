#include "lateral_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/polygon_walls.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_flow.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/section/warping.hpp"

namespace boxbeam {
namespace {

constexpr int elements = 48;  ///< at least
constexpr double same_place = 1e-4;

/// Where something stands, and even steps between.
std::vector<double> nodes_of(double length, std::vector<double> places) {
  places.insert(places.end(), {0.0, length});
  std::sort(places.begin(), places.end());
  const auto alike = [&](double a, double b) { return b - a < same_place * length; };
  places.erase(std::unique(places.begin(), places.end(), alike), places.end());
  places.back() = length;
  std::vector<double> nodes{places.front()};
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const double gap = places[k + 1] - places[k];
    const int steps = std::max(1, static_cast<int>(std::ceil(elements * gap / length - 1e-9)));
    for (int i = 1; i < steps; ++i) nodes.push_back(places[k] + gap * i / steps);
    nodes.push_back(places[k + 1]);
  }
  return nodes;
}

std::size_t nearest_of(const std::vector<double>& nodes, double s) {
  const auto above = std::lower_bound(nodes.begin(), nodes.end(), s);
  if (above == nodes.begin()) return 0;
  const auto index = static_cast<std::size_t>(above - nodes.begin());
  if (above == nodes.end() || s - nodes[index - 1] < nodes[index] - s) return index - 1;
  return index;
}

/// I_T, of polygons no less than it has. What is nested in others counts where its I_T is known.
double least_torsion_constant_in(const Section& section) {
  if (const auto* const polygon = std::get_if<Polygon>(&section.outer))
    return least_torsion_constant_of(*polygon).value();
  const auto whole = torsion_constant_of(section);
  return (whole ? *whole : *torsion_constant_of(section.outer)).value();
}

/// int sigma r^2 dA about the shear centre, per M_y and per M_z, of walls along their mid-lines;
/// none of sections around cells, which resist so much more. Exact: sigma is linear and r^2
/// quadratic along a wall, which Simpson's rule integrates. Source: Timoshenko, Gere, section 6.6
/// (beta_1).
std::array<double, 2> turned_stresses_of(const Section& section) {
  const auto* const path = std::get_if<ThinWalled>(&section.outer);
  if (path == nullptr || section.inner) return {};
  const auto centre = shear_centre_of(section);
  if (!centre || enclosed_area_of(section.outer).value() > 0.0) return {};
  const AreaSums sums = sums_of(outline_of(section, {}));
  const double y_s = centre->y.value(), z_s = centre->z.value();
  std::array<double, 2> turned{};
  double largest = 0.0;
  for (const ThinWall& wall : path->walls) {
    const SectionPlace &a = path->nodes[wall.from], &b = path->nodes[wall.to];
    const double weight =
        std::hypot((b.y - a.y).value(), (b.z - a.z).value()) * wall.thickness.value();
    for (const auto& [part, share] : {std::pair{0.0, 1.0 / 6}, {0.5, 4.0 / 6}, {1.0, 1.0 / 6}}) {
      const double y = (a.y + part * (b.y - a.y)).value(), z = (a.z + part * (b.z - a.z)).value();
      const StressInfluence of = normal_influence(sums, y, z);
      const double r2 = (y - y_s) * (y - y_s) + (z - z_s) * (z - z_s);
      turned[0] += share * weight * of.normal[cut_force::M_y] * r2;
      turned[1] += share * weight * of.normal[cut_force::M_z] * r2;
      largest = std::max(largest, std::sqrt(r2));
    }
  }
  constexpr double round_off = 1e-9;
  for (double& of : turned)
    if (std::abs(of) < round_off * largest) of = 0.0;
  return turned;
}

/// Whether the section at a node is one and the same on both sides, in outline and place: only then
/// does it warp on alike, whatever its I_w.
bool goes_on_at(const TaperedBeam& beam, double s) {
  const Section before = section_at(beam, {si<Length>(s), Side::before});
  const Section behind = section_at(beam, {si<Length>(s), Side::behind});
  if (before == behind) return true;
  if (!same_kind(before, behind)) return false;
  const std::vector<Length> of = dimensions_of(before), next = dimensions_of(behind);
  constexpr double round_off = 1e-9;
  const double close = round_off * height_of(before.outer).value();
  return std::equal(of.begin(), of.end(), next.begin(), next.end(),
                    [&](Length a, Length b) { return std::abs((a - b).value()) <= close; });
}

/// How far a section reaches from its shear centre, and its centroid, along z and y.
SectionReach reach_of(const Section& section) {
  const Extent extent = extent_of(section.outer);
  const SectionProperties of = properties_of(section);
  const SectionPlace centre =
      shear_centre_of(section).value_or(SectionPlace{of.centroid_y, of.centroid_z});
  return {{(extent.z_low - centre.z).value(), (extent.y_low - centre.y).value()},
          {(extent.z_high - centre.z).value(), (extent.y_high - centre.y).value()},
          {(of.centroid_z - centre.z).value(), (of.centroid_y - centre.y).value()}};
}

/// Of both sides of a node the farther reach.
SectionReach reach_at(const TaperedBeam& beam, double s) {
  SectionReach of = reach_of(section_at(beam, {si<Length>(s), Side::before}));
  const SectionReach behind = reach_of(section_at(beam, {si<Length>(s), Side::behind}));
  for (std::size_t axis = 0; axis < 2; ++axis) {
    of.low[axis] = std::min(of.low[axis], behind.low[axis]);
    of.high[axis] = std::max(of.high[axis], behind.high[axis]);
  }
  return of;
}

/// What a section does against turning over, and how it bends.
struct SectionTurning {
  double upright, sideways;  ///< 1/(E I), as in bending along the webs and across them
  double stiffness;          ///< G I_T
  std::array<double, 2> turned;
  SectionReach reach;
};

SectionTurning turning_of(const Section& section, double E, double G) {
  const SectionProperties of = properties_of(section);
  const double I_y = of.I_y.value(), I_z = of.I_z.value(), I_yz = of.I_yz.value();
  // The section is free to bend both ways.
  return {1.0 / (E * (I_y - I_yz * I_yz / I_z)), 1.0 / (E * (I_z - I_yz * I_yz / I_y)),
          G * least_torsion_constant_in(section), turned_stresses_of(section), reach_of(section)};
}

/// Force, along z and y, times its height above the shear centre at the edge where it turns the
/// beam over; at none does it count as righting it.
double tipping_at_edges(const std::array<double, 2>& force, const SectionReach& reach) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis)
    sum += std::max({0.0, -force[axis] * reach.low[axis], -force[axis] * reach.high[axis]});
  return sum;
}

/// What a line of force does per length: weight and inertia at the centroid, all else at the edges,
/// each load by itself, for what rights the beam at one height need not at the other. Of cut forces
/// nothing tells them apart.
double tipping_of(const LineLoad& line, double x, const SectionReach& reach, bool of_cuts) {
  std::array own{line.force[2](x), line.force[1](x)};
  double sum = 0.0;
  if (of_cuts) {
    sum = tipping_at_edges(own, reach);
  } else {
    for (const std::size_t against : {0U, 1U}) {
      const double sense = against == 0 ? 1.0 : -1.0;
      const std::array outside{sense * line.outside[1][against](x),
                               sense * line.outside[0][against](x)};
      sum += tipping_at_edges(outside, reach);
      for (std::size_t axis = 0; axis < 2; ++axis) own[axis] -= outside[axis];
    }
  }
  const double by_own = -own[0] * reach.centroid[0] - own[1] * reach.centroid[1];
  return of_cuts ? std::max(sum, by_own) : sum + by_own;
}

/// Whether lines of force follow from cut forces that the case gives.
bool lines_are_cut(const AnyMechanism& mechanism) {
  const auto* const recorded = std::get_if<recorded::Loads>(&mechanism);
  return recorded != nullptr && recorded->as_cuts;
}

/// I_w of a segment; none of one that tapers, whose flanges, no longer parallel, make it bend
/// otherwise, nor of what is not open.
double warping_constant_in(const Segment& segment) {
  if (segment.from.inner || !(segment.from == segment.to)) return 0.0;
  return warping_constant_of(segment.from.outer).value_or(0.0);
}

}  // namespace

LateralEstimate::LateralEstimate(const Project& project)
    : project_(&project), lines_are_cut_(lines_are_cut(project.mechanism)) {}

void LateralEstimate::hold(const std::vector<double>& at, const BeamLoads& loads) {
  std::vector<double> places = at;
  for (const PointLoad& load : loads.points) places.push_back(load.s.value());
  if (at == at_ && places == places_) return;
  at_ = at;
  for (const Segment& segment : project_->beam.segments) places.push_back(segment.end().value());
  const TaperedBeam& beam = project_->beam;
  const double E = project_->model.youngs_modulus, G = project_->model.shear_modulus;
  beam_.nodes = nodes_of(beam.length().value(), places);
  places.resize(places.size() - beam.segments.size());
  places_ = std::move(places);
  const std::size_t count = beam_.nodes.size();
  beam_.held.assign(count, false);
  for (const double s : at) beam_.held[nearest_of(beam_.nodes, s)] = true;
  beam_.turning_stiffness.resize(count - 1);
  beam_.warping_stiffness.assign(count - 1, 0.0);
  std::vector<double> I_w;
  for (const Segment& segment : beam.segments) I_w.push_back(warping_constant_in(segment));
  by_M_y_.resize(count - 1);
  by_M_z_.resize(count - 1);
  turned_.assign(count - 1, {});
  bool any_turned = false;
  reach_.resize(count - 1);
  node_reach_.assign(count, std::nullopt);
  // Along a segment that does not taper all is as at the place before.
  std::optional<Section> last;
  SectionTurning of{};
  for (std::size_t e = 0; e + 1 < count; ++e) {
    const std::array<double, 2> inside = gauss_places(beam_, e);
    beam_.warping_stiffness[e] = E * I_w[segment_at(beam, {si<Length>(inside[0])})];
    for (std::size_t g = 0; g < 2; ++g) {
      Section section = section_at(beam, {si<Length>(inside[g])});
      if (!last || !(*last == section)) {
        of = turning_of(section, E, G);
        last = std::move(section);
      }
      beam_.turning_stiffness[e][g] = of.stiffness;
      by_M_y_[e][g] = std::max(0.0, of.sideways - of.upright);
      by_M_z_[e][g] = std::max(0.0, of.upright - of.sideways);
      turned_[e][g] = of.turned;
      reach_[e][g] = of.reach;
      any_turned = any_turned || turned_[e][g] != std::array{0.0, 0.0};
    }
  }
  if (!any_turned) turned_.clear();
  beam_.parted.assign(count, false);
  for (std::size_t i = 1; i + 1 < count; ++i) {
    if (beam_.warping_stiffness[i - 1] > 0.0 && beam_.warping_stiffness[i] > 0.0)
      beam_.parted[i] = !goes_on_at(beam, beam_.nodes[i]);
  }
}

void LateralEstimate::take(const CutForceDiagram& diagram, const BeamLoads& loads) {
  const std::size_t count = by_M_y_.size();
  load_.twisting.resize(count);
  load_.turned.resize(turned_.size());
  auto cut = diagram.pieces.begin();
  for (std::size_t e = 0; e < count; ++e) {
    const std::array<double, 2> places = gauss_places(beam_, e);
    for (std::size_t g = 0; g < 2; ++g) {
      while (cut + 1 != diagram.pieces.end() && (cut + 1)->start.value() <= places[g]) ++cut;
      const double x = places[g] - cut->start.value(), M_y = cut->M_y(x), M_z = cut->M_z(x);
      load_.twisting[e][g] = M_y * M_y * by_M_y_[e][g] + M_z * M_z * by_M_z_[e][g];
      if (!turned_.empty()) load_.turned[e][g] = M_y * turned_[e][g][0] + M_z * turned_[e][g][1];
    }
  }
  tip(loads);
}

double LateralEstimate::part(const CutForceDiagram& diagram, const BeamLoads& loads,
                             const std::vector<double>& at, double known) {
  screening_ = false;
  hold(at, loads);
  take(diagram, loads);
  return part_of(load_, known);
}

void LateralEstimate::screen(const std::vector<double>& at) {
  screening_ = true;
  hold(at, {});
  envelope_ = {};
}

void LateralEstimate::widen(const CutForceDiagram& diagram, const BeamLoads& loads) {
  take(diagram, loads);
  if (envelope_.tipping.empty()) {
    envelope_ = load_;
    return;
  }
  for (std::size_t e = 0; e < load_.twisting.size(); ++e) {
    for (std::size_t g = 0; g < 2; ++g) {
      envelope_.twisting[e][g] = std::max(envelope_.twisting[e][g], load_.twisting[e][g]);
      if (!turned_.empty())
        envelope_.turned[e][g] = std::min(envelope_.turned[e][g], load_.turned[e][g]);
    }
  }
  for (std::size_t i = 0; i < load_.tipping.size(); ++i)
    envelope_.tipping[i] = std::max(envelope_.tipping[i], load_.tipping[i]);
}

double LateralEstimate::bound() { return part_of(envelope_, 0.0); }

double LateralEstimate::share(const CutForceDiagram& diagram, const BeamLoads& loads) {
  take(diagram, loads);
  double squared = 0.0, linear = 0.0;
  for (std::size_t e = 0; e < load_.twisting.size(); ++e) {
    for (std::size_t g = 0; g < 2; ++g) {
      const double most = envelope_.twisting[e][g];
      if (most > 0.0) squared = std::max(squared, load_.twisting[e][g] / most);
      if (!turned_.empty() && envelope_.turned[e][g] < 0.0)
        linear = std::max(linear, load_.turned[e][g] / envelope_.turned[e][g]);
    }
  }
  for (std::size_t i = 0; i < load_.tipping.size(); ++i) {
    if (envelope_.tipping[i] > 0.0)
      linear = std::max(linear, load_.tipping[i] / envelope_.tipping[i]);
  }
  return std::max(std::sqrt(squared), linear);
}

void LateralEstimate::tip(const BeamLoads& loads) {
  std::vector<double>& tipping = load_.tipping;
  tipping.assign(beam_.nodes.size(), 0.0);
  const auto tip_at = [&](std::size_t i, const PointLoad& load) {
    if (beam_.held[i]) return;
    std::optional<SectionReach>& reach = node_reach_[i];
    if (!reach) reach = reach_at(project_->beam, beam_.nodes[i]);
    tipping[i] += tipping_at_edges({load.force.z(), load.force.y()}, *reach);
  };
  for (const PointLoad& load : loads.points) {
    const double s = load.s.value();
    const std::size_t i = nearest_of(beam_.nodes, s);
    tip_at(i, load);
    if (!screening_) continue;
    if (s < beam_.nodes[i]) tip_at(i - 1, load);
    if (s > beam_.nodes[i] && i + 1 < beam_.nodes.size()) tip_at(i + 1, load);
  }
  for (const LineLoad& line : loads.lines) {
    if (line.force[1].c == Polynomial<3>{}.c && line.force[2].c == Polynomial<3>{}.c) continue;
    const double start = line.start.value(), end = start + line.length.value();
    const auto above = std::upper_bound(beam_.nodes.begin() + 1, beam_.nodes.end(), start);
    for (auto e = static_cast<std::size_t>(above - beam_.nodes.begin()) - 1;
         e < reach_.size() && beam_.nodes[e] < end; ++e) {
      const double first = beam_.nodes[e], length = beam_.nodes[e + 1] - first;
      const double from = std::max(first, start), to = std::min(first + length, end);
      if (!(from < to)) continue;
      const std::array<double, 2> places = gauss_places(beam_, e);
      for (std::size_t g = 0; g < 2; ++g) {
        const double s = from + (places[g] - first) / length * (to - from);
        const double per_length = tipping_of(line, s - start, reach_[e][g], lines_are_cut_);
        const double part = (s - first) / length, of = 0.5 * (to - from) * per_length;
        tipping[e] += (1.0 - part) * of;
        tipping[e + 1] += part * of;
      }
    }
  }
}

double LateralEstimate::part_of(const Turning& load, double known) const {
  if (turned_.empty()) return lateral_buckling_part(beam_, load.twisting, load.tipping, known);
  TurningBeam turned = beam_;
  // Whether the beam stands under so many times its load: what resists is linear in it, what turns
  // it over quadratic, so that it does up to one multiple and not beyond.
  const auto stands = [&](double times) {
    for (std::size_t e = 0; e < turned_.size(); ++e) {
      for (std::size_t g = 0; g < 2; ++g)
        turned.turning_stiffness[e][g] = beam_.turning_stiffness[e][g] + times * load.turned[e][g];
    }
    return lateral_buckling_part(turned, load.twisting, load.tipping, 1.0 / times) <= 1.0 / times;
  };
  constexpr double least = 1e-4, close = 1e-5;
  double high = 1.0 / std::max(known, least);
  if (stands(high)) return known;
  double low = 0.5 * high;
  while (low > 1e-30 && !stands(low)) {
    high = low;
    low *= 0.5;
  }
  while (high - low > close * high) {
    const double middle = 0.5 * (low + high);
    (stands(middle) ? low : high) = middle;
  }
  return 1.0 / low;
}

}  // namespace boxbeam
