#include "boxbeam/strength/effective_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/strength/section_class.hpp"
#include "boxbeam/strength/stiffened_plate.hpp"
#include "effective_parts.hpp"

namespace boxbeam {
namespace {

using Eigen::Vector2d;

/// Takes a straight strip on a mid-line out.
void take_out(AreaSums& sums, const Vector2d& from, const Vector2d& to, double thickness) {
  const double length = (to - from).norm(), area = length * thickness;
  if (!(area > 0.0)) return;
  const Vector2d centre = 0.5 * (from + to), along = (to - from) / length;
  const double own_along = area * length * length / 12.0;
  const double own_across = area * thickness * thickness / 12.0;
  const double y = along.x(), z = along.y();
  sums.area -= area;
  sums.y -= area * centre.x();
  sums.z -= area * centre.y();
  sums.yy -= area * centre.x() * centre.x() + own_along * y * y + own_across * z * z;
  sums.zz -= area * centre.y() * centre.y() + own_along * z * z + own_across * y * y;
  sums.yz -= area * centre.x() * centre.y() + (own_along - own_across) * y * z;
}

/// Takes out what of a plate does not work, of each of its walls.
void take_out(AreaSums& sums, const PathSection& path, const PathPlate& plate,
              const PlateAlone& of) {
  for (const PathPlate::Part& part : plate.parts) {
    const auto [low, high] = std::minmax(part.from, part.to);
    const double from = std::max(low, of.idle_low), to = std::min(high, of.idle_high);
    if (to > from)
      take_out(sums, plate.at(from), plate.at(to), path.graph.walls[part.wall].thickness);
  }
}

/// Compression of the plates' ends per moment of one sense; none but for round-off at the axis.
std::vector<std::array<double, 2>> compressions_of(const AreaSums& sums, const PathSection& path,
                                                   ActingAlone acting, bool coupled) {
  const double sense = is_positive(acting) ? -1.0 : 1.0;
  double most = 0.0;
  const auto at = [&](const PathPlate& plate, double along) {
    const Vector2d place = plate.at(along);
    const double stress = coupled
                              ? normal_influence(sums, place.x(), place.y())
                                    .normal[is_about_y(acting) ? cut_force::M_y : cut_force::M_z]
                              : stress_per_moment(sums, acting, place.x(), place.y());
    most = std::max(most, std::abs(stress));
    return sense * stress;
  };
  std::vector<std::array<double, 2>> ends;
  for (const PathPlate& plate : path.plates)
    ends.push_back({at(plate, plate.low), at(plate, plate.high)});
  constexpr double rounding = 1e-9;
  for (std::array<double, 2>& of : ends)
    for (double& stress : of)
      if (std::abs(stress) < rounding * most) stress = 0.0;
  return ends;
}

/// Leaves that share of what works of a plate.
void narrow(const PathPlate& plate, double lag, PlateAlone& of) {
  of.lag = lag;
  if (of.idle() > 0.0) {
    of.idle_low -= (1.0 - lag) * (of.idle_low - plate.low);
    of.idle_high += (1.0 - lag) * (plate.high - of.idle_high);
    return;
  }
  const double idle = (1.0 - lag) * (plate.high - plate.low);
  of.idle_low = plate.outstand() ? (plate.held_at_high() ? plate.low : plate.high - idle)
                                 : 0.5 * (plate.low + plate.high - idle);
  of.idle_high = of.idle_low + idle;
}

double largest_change(const PathAlone& a, const PathAlone& b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.plates.size(); ++k) {
    if (a.plates[k].pressed != b.plates[k].pressed) return 1.0;
    most = std::max(most, std::abs(a.plates[k].psi - b.plates[k].psi));
  }
  return most;
}

std::string place_name_of(const PathSection& path, const std::vector<std::size_t>& walls) {
  std::vector<std::size_t> numbers;
  for (const std::size_t wall : walls) numbers.push_back(path.numbers[wall]);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  if (walls.size() == 1) return fmt::format("end of wall {}", numbers.front());
  return fmt::format("node of walls {}", fmt::join(numbers, ", "));
}

}  // namespace

std::optional<PathSection> path_section_of(const ThinWalled& path,
                                           const PlateMaterials& materials) {
  PathSection of;
  const Section section{path, {}};
  of.graph = *wall_graph_of(section, {});
  for (const Wall& wall : of.graph.walls) {
    const auto yield = yield_strength_of(materials.of(PlateKind::wall), si<Length>(wall.thickness));
    if (!yield) return std::nullopt;
    of.yield_strengths.push_back(*yield);
    const bool stub = wall.to >= path.nodes.size();
    of.numbers.push_back(of.numbers.empty() ? 1 : of.numbers.back() + (stub ? 0 : 1));
  }
  of.gross = sums_of(outline_of(section, {}));
  of.plates = plates_of(path, materials);
  return of;
}

bool may_buckle(const PathPlate& plate) {
  const double epsilon = epsilon_of(plate.class_strength);
  const ClassLimits limits =
      plate.outstand() ? outstand_flange_limits(epsilon) : internal_part_limits(1.0, 1.0, epsilon);
  return plate.clear() / plate.thickness > limits.class_3;
}

PlateAlone plate_alone(const PathPlate& plate, Stress strength, std::optional<Length> length,
                       double at_low, double at_high) {
  PlateAlone of;
  const double most = std::max(at_low, at_high);
  of.pressed = most > 0.0;
  if (!of.pressed) return of;
  of.more_at_high = at_high > at_low;
  // Even compression and pure bending but for round-off: there k jumps, by up to 0.3 %.
  constexpr double rounding = 1e-9;
  double psi = std::min(at_low, at_high) / most;
  for (const double even : {1.0, -1.0})
    if (std::abs(psi - even) < rounding) psi = even;
  const double epsilon = epsilon_of(strength), clear = plate.high - plate.low;
  if (!plate.outstand()) {
    of.psi = std::max(-3.0, psi);
    of.width = *panel_effective_width(plate.clear(), plate.thickness, of.psi, strength, length,
                                      plate.level);
    const double idle = clear / std::max(1.0, 1.0 - of.psi) - of.width.b_eff.value();
    const double first = of.width.b_e1.value();
    of.idle_low = of.more_at_high ? plate.high - first - idle : plate.low + first;
    of.idle_high = of.idle_low + idle;
    return of;
  }
  const bool held_high = plate.held_at_high();
  const bool at_support = psi < 1.0 && of.more_at_high == held_high;
  of.psi = std::max(at_support ? -1.0 : -3.0, psi);
  of.width = *outstand_effective_width(
      plate.clear(), plate.thickness, of.psi,
      at_support ? LargestCompression::at_support : LargestCompression::at_tip, epsilon,
      plate.level);
  const double pressed = clear / std::max(1.0, 1.0 - of.psi), works = of.width.b_eff.value();
  // From the support: what works, what does not, what is stretched; or from the tip: what does not.
  const double from = at_support ? works : clear - (pressed - works);
  const double to = at_support ? pressed : clear;
  of.idle_low = held_high ? plate.high - to : plate.low + from;
  of.idle_high = held_high ? plate.high - from : plate.low + to;
  return of;
}

PathAlone path_alone(const PathSection& path, ActingAlone acting, bool coupled, int most_passes) {
  PathAlone section;
  section.sums = path.gross;
  const auto judge = [&](std::size_t k, double at_low, double at_high, double lag) {
    const PathPlate& plate = path.plates[k];
    PlateAlone of = plate_alone(plate, plate.class_strength, path.length, at_low, at_high);
    if (lag < 1.0) narrow(plate, lag, of);
    take_out(section.sums, path, plate, of);
    return of;
  };
  if (acting == ActingAlone::compression) {
    for (std::size_t k = 0; k < path.plates.size(); ++k)
      section.plates.push_back(judge(k, 1.0, 1.0, 1.0));
    return section;
  }
  const auto along_axis = [&](const PathPlate& plate) {
    const double y = std::abs(plate.direction.x()), z = std::abs(plate.direction.y());
    return is_about_y(acting) ? y > z : z > y;
  };
  AreaSums known = path.gross;
  section.settled = most_passes == 1;
  for (section.passes = 0; section.passes < most_passes;) {
    ++section.passes;
    const PathAlone before = section;
    section.sums = path.gross;
    section.plates.assign(path.plates.size(), {});
    for (const bool flanges : {true, false}) {
      if (section.passes == 1 && !flanges) known = section.sums;
      const auto ends = compressions_of(known, path, acting, coupled);
      for (std::size_t k = 0; k < path.plates.size(); ++k) {
        if (along_axis(path.plates[k]) != flanges) continue;
        const bool lags = flanges && !path.lag.empty();
        section.plates[k] =
            judge(k, ends[k][0], ends[k][1], lags ? path.lag[k][is_about_y(acting) ? 0 : 1] : 1.0);
      }
    }
    known = section.sums;
    constexpr double close = 1e-10;
    if (section.passes > 1 && largest_change(section, before) < close) {
      section.settled = true;
      break;
    }
  }
  return section;
}

EffectivePath::EffectivePath(const PathSection& path) : path_(path) {
  using enum ActingAlone;
  for (std::size_t k = 0; k < sections_.size(); ++k)
    sections_[k] = path_alone(path_, static_cast<ActingAlone>(k));
  const AreaSums& gross = path_.gross;
  const double y_c = gross.y / gross.area, z_c = gross.z / gross.area;
  const double I_y = gross.zz - gross.area * z_c * z_c, I_z = gross.yy - gross.area * y_c * y_c;
  constexpr double mirrored = 1e-9;
  const bool sizes = std::abs(gross.yz - gross.area * y_c * z_c) > mirrored * std::sqrt(I_y * I_z);
  for (std::size_t k = 1; sizes && k < sections_.size(); ++k)
    coupled_.push_back(path_alone(path_, static_cast<ActingAlone>(k), true));
  centroid_ = effective_centroid_of(gross, sections_.front().sums,
                                    1e-12 * std::sqrt((I_y + I_z) / gross.area));
  least_strength_ = *std::min_element(path_.yield_strengths.begin(), path_.yield_strengths.end());

  std::vector<std::vector<std::size_t>> meeting(path_.graph.nodes.size());
  for (std::size_t i = 0; i < path_.graph.walls.size(); ++i) {
    meeting[path_.graph.walls[i].from].push_back(i);
    meeting[path_.graph.walls[i].to].push_back(i);
  }
  for (std::size_t node = 0; node < meeting.size(); ++node) {
    const std::vector<std::size_t>& walls = meeting[node];
    if (walls.empty()) continue;
    Vector2d at = path_.graph.nodes[node];
    const Wall& first = path_.graph.walls[walls.front()];
    if (walls.size() == 1) at = first.from == node ? first.start : first.end;
    places_.push_back({place_name_of(path_, walls), at.x(), at.y()});
    Place& place = resist_.emplace_back();
    const auto modulus = [&](ActingAlone acting) {
      double most = most_per_moment(alone(acting).sums, acting, at.x(), at.y());
      if (sizes) {
        const AreaSums& left = coupled_[static_cast<std::size_t>(acting) - 1].sums;
        const double other = most_per_moment(left, acting, at.x(), at.y());
        if (std::abs(other) > std::abs(most)) most = other;
      }
      return 1.0 / most;
    };
    place.areas = {gross.area, sections_.front().sums.area};
    place.W_y = {modulus(M_y_positive), modulus(M_y_negative)};
    place.W_z = {modulus(M_z_positive), modulus(M_z_negative)};
    place.sizes = sizes;
    place.yield_strength = path_.yield_strengths[walls.front()];
    for (const std::size_t wall : walls)
      place.yield_strength = std::min(place.yield_strength, path_.yield_strengths[wall]);
    for (std::size_t k = 0; k < path_.plates.size(); ++k) {
      const std::vector<PathPlate::Part>& parts = path_.plates[k].parts;
      if (std::any_of(parts.begin(), parts.end(), [&](const PathPlate::Part& part) {
            return std::find(walls.begin(), walls.end(), part.wall) != walls.end();
          }))
        place.plates.push_back(k);
    }
  }
}

bool EffectivePath::settled() const {
  const auto settles = [](const PathAlone& of) { return of.settled; };
  return std::all_of(sections_.begin(), sections_.end(), settles) &&
         std::all_of(coupled_.begin(), coupled_.end(), settles);
}

SectionModulus EffectivePath::least_modulus(bool about_y) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Place& place : resist_)
    for (const double W : about_y ? place.W_y : place.W_z) least = std::min(least, std::abs(W));
  return si<SectionModulus>(least);
}

template <class Look>
void EffectivePath::look_at_places(const CutForces& cut, const Look& look) const {
  for (std::size_t k = 0; k < resist_.size(); ++k) {
    look_at_shifts(centroid_, cut, [&](const Shifts& shifts) {
      PathUse of{stress_at(resist_[k], centroid_, cut, shifts), k};
      of.yield_strength = is_compressed(of, cut.N) ? least_strength_ : resist_[k].yield_strength;
      of.use = std::abs(of.stress.value()) / of.yield_strength.value();
      look(of);
    });
  }
}

PathUse EffectivePath::worst_place(const CutForces& cut) const {
  PathUse worst;
  worst.use = -1.0;
  look_at_places(cut, [&](const PathUse& of) {
    if (of.use > worst.use) worst = of;
  });
  return worst;
}

std::vector<double> EffectivePath::compressed_shares(const CutForces& cut) const {
  std::vector<double> most(path_.plates.size(), 0.0);
  look_at_places(cut, [&](const PathUse& of) {
    // Parts that add up by their sizes say no sense: all of it may be compression.
    const Stress pressed = of.sizes ? Stress(abs(of.stress)) : Stress(-of.stress);
    for (const std::size_t k : resist_[of.place].plates)
      most[k] = std::max(most[k], (pressed / path_.plates[k].class_strength).value());
  });
  return where_it_yields(std::move(most), use(cut));
}

std::optional<EffectivePath> EffectivePath::below_yield(const CutForces& cut, bool annex_E) const {
  EffectivePath of = *this;
  for (int i = 0; i < most_level_steps; ++i) {
    PathSection path = of.path_;
    if (settled_at(of.compressed_shares(cut), annex_E, path.plates))
      return of.settled() ? std::optional(std::move(of)) : std::nullopt;
    of = EffectivePath(path);
  }
  return std::nullopt;
}

}  // namespace boxbeam
