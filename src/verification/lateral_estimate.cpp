#include "lateral_estimate.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/section/warping.hpp"

namespace boxbeam {
namespace {

constexpr int elements = 48;  ///< at least
constexpr double same_place = 1e-6;

std::vector<double> nodes_of(const TaperedBeam& beam, const std::vector<double>& at) {
  const double length = beam.length().value();
  std::vector<double> nodes = at;
  for (int i = 0; i <= elements; ++i) nodes.push_back(length * i / elements);
  for (const Segment& segment : beam.segments) nodes.push_back(segment.end().value());
  std::sort(nodes.begin(), nodes.end());
  const auto alike = [&](double a, double b) { return b - a < same_place * length; };
  nodes.erase(std::unique(nodes.begin(), nodes.end(), alike), nodes.end());
  return nodes;
}

std::size_t nearest_of(const std::vector<double>& nodes, double s) {
  const auto above = std::lower_bound(nodes.begin(), nodes.end(), s);
  if (above == nodes.begin()) return 0;
  const auto index = static_cast<std::size_t>(above - nodes.begin());
  if (above == nodes.end() || s - nodes[index - 1] < nodes[index] - s) return index - 1;
  return index;
}

/// int sigma r^2 dA about the shear centre, per M_y and per M_z, of walls along their mid-lines;
/// none of sections around cells, which resist so much more. Exact: sigma is linear and r^2
/// quadratic along a wall, which Simpson's rule integrates. Source: Timoshenko, Gere, section 6.6
/// (beta_1).
std::array<double, 2> turned_stresses_of(const Section& section) {
  const auto* const path = std::get_if<ThinWalled>(&section.outer);
  if (path == nullptr || section.inner) return {};
  const TorsionProperties torsion = torsion_properties_of(section);
  if (!torsion.shear_centre || torsion.enclosed.value() > 0.0) return {};
  const AreaSums sums = sums_of(outline_of(section, {}));
  const double y_s = torsion.shear_centre->y.value(), z_s = torsion.shear_centre->z.value();
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

/// I_w of a segment; none of one that tapers, whose flanges, no longer parallel, make it bend
/// otherwise, nor of what is not open.
double warping_constant_in(const Segment& segment) {
  if (segment.from.inner || !(segment.from == segment.to)) return 0.0;
  return warping_constant_of(segment.from.outer).value_or(0.0);
}

}  // namespace

bool LateralEstimate::is_known() const {
  const std::vector<Segment>& segments = project_->beam.segments;
  return std::all_of(segments.begin(), segments.end(), [](const Segment& segment) {
    return torsion_constant_of(segment.from) && torsion_constant_of(segment.to);
  });
}

void LateralEstimate::hold(const std::vector<double>& at) {
  if (at == at_ && !beam_.nodes.empty()) return;
  at_ = at;
  const TaperedBeam& beam = project_->beam;
  const double E = project_->model.youngs_modulus, G = project_->model.shear_modulus;
  beam_.nodes = nodes_of(beam, at);
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
  twisting_.resize(count - 1);
  edges_.resize(count);
  for (std::size_t e = 0; e + 1 < count; ++e) {
    const std::array<double, 2> places = gauss_places(beam_, e);
    beam_.warping_stiffness[e] = E * I_w[segment_at(beam, {si<Length>(places[0])})];
    for (std::size_t g = 0; g < 2; ++g) {
      const Section section = section_at(beam, {si<Length>(places[g])});
      const SectionProperties of = properties_of(section);
      const double I_y = of.I_y.value(), I_z = of.I_z.value(), I_yz = of.I_yz.value();
      // As in bending along the webs and across them: the section is free to bend both ways.
      const double upright = 1.0 / (E * (I_y - I_yz * I_yz / I_z));
      const double sideways = 1.0 / (E * (I_z - I_yz * I_yz / I_y));
      beam_.turning_stiffness[e][g] = G * torsion_constant_of(section)->value();
      by_M_y_[e][g] = std::max(0.0, sideways - upright);
      by_M_z_[e][g] = std::max(0.0, upright - sideways);
      turned_[e][g] = turned_stresses_of(section);
      any_turned = any_turned || turned_[e][g] != std::array{0.0, 0.0};
    }
  }
  if (!any_turned) turned_.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const Section section = section_at(beam, {si<Length>(beam_.nodes[i])});
    const Extent extent = extent_of(section.outer);
    edges_[i] = {std::max(-extent.z_low.value(), extent.z_high.value()),
                 std::max(-extent.y_low.value(), extent.y_high.value())};
  }
}

double LateralEstimate::part(const CutForceDiagram& diagram, const BeamLoads& loads,
                             const std::vector<double>& at, double known) {
  hold(at);
  for (std::size_t e = 0; e < twisting_.size(); ++e) {
    const std::array<double, 2> places = gauss_places(beam_, e);
    for (std::size_t g = 0; g < 2; ++g) {
      const CutForces cut = diagram.at({si<Length>(places[g])});
      const double M_y = cut.M_y.value(), M_z = cut.M_z.value();
      twisting_[e][g] = M_y * M_y * by_M_y_[e][g] + M_z * M_z * by_M_z_[e][g];
    }
  }
  tipping_.assign(beam_.nodes.size(), 0.0);
  for (const PointLoad& load : loads.points) {
    const std::size_t i = nearest_of(beam_.nodes, load.s.value());
    tipping_[i] +=
        std::abs(load.force.z()) * edges_[i][0] + std::abs(load.force.y()) * edges_[i][1];
  }
  return turned_.empty() ? lateral_buckling_part(beam_, twisting_, tipping_, known)
                         : part_with_turned(diagram, known);
}

double LateralEstimate::part_with_turned(const CutForceDiagram& diagram, double known) const {
  TurningBeam turned = beam_;
  // Whether the beam stands under so many times its load: what resists is linear in it, what turns
  // it over quadratic, so that it does up to one multiple and not beyond.
  const auto stands = [&](double times) {
    for (std::size_t e = 0; e < turned_.size(); ++e) {
      const std::array<double, 2> places = gauss_places(beam_, e);
      for (std::size_t g = 0; g < 2; ++g) {
        const CutForces cut = diagram.at({si<Length>(places[g])});
        const double more = cut.M_y.value() * turned_[e][g][0] + cut.M_z.value() * turned_[e][g][1];
        turned.turning_stiffness[e][g] = beam_.turning_stiffness[e][g] + times * more;
      }
    }
    return lateral_buckling_part(turned, twisting_, tipping_, 1.0 / times) <= 1.0 / times;
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
