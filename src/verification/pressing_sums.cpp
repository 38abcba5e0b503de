#include "pressing_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "boxbeam/section/outline.hpp"
#include "boxbeam/strength/effective_box.hpp"
#include "boxbeam/strength/effective_path.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "patch_search.hpp"
#include "patched_path.hpp"
#include "plate_panels.hpp"

namespace boxbeam {
namespace {

using Eigen::VectorXd;

/// A place of the given loads, with what it brings across the beam for a value of one of each
/// channel.
struct Pressing {
  Station at;
  VectorXd force;         ///< [N]
  double constant = 0.0;  ///< of the force, beside the channels [N]
  VectorXd couple;  ///< about the beam's axis, less what goes round the section in shear [N m]
};

/// What bears forces across the beam at a place.
struct Bearing {
  double high = 0.0, low = 0.0;  ///< of the two webs along the force, across it [m]; one: the same
  double resistance = 0.0;       ///< F_Rd of the weaker one, nothing else pressing it [N]
  double depth = 0.0;            ///< [m]
  double none = 0.0;             ///< t^2 f_y of the weaker one: less is no force against others [N]
  /// Whose worst use by the stresses along the beam counts.
  std::shared_ptr<const EffectiveBox> box;
  std::shared_ptr<const EffectivePath> path;

  void add(const PatchedWeb& web, double bears) {
    const double little = (web.thickness * web.thickness * web.yield_strength).value();
    none = resistance > 0.0 ? std::min(none, little) : little;
    resistance = resistance > 0.0 ? std::min(resistance, bears) : bears;
    depth = std::max(depth, web.depth.value());
  }

  double use(const CutForces& cut) const {
    return box ? box->worst_corner(cut).use : path->use(cut);
  }
};

/// The stiff length that the case says at a place, nothing where the force comes by webs.
std::optional<Length> stiff_length_at(const Project& project, Length s) {
  const Length near = 1e-6 * project.beam.length();
  const LoadIntroduction* narrowest = nullptr;
  for (const LoadIntroduction& of : project.beam.introductions) {
    if (s < of.from - near || s > of.to + near) continue;
    if (narrowest == nullptr || of.to - of.from < narrowest->to - narrowest->from) narrowest = &of;
  }
  return narrowest == nullptr ? Length{} : narrowest->stiff_length;
}

double resistance_of(PatchedWeb web, Length stiff_length, double gamma_M1) {
  web.stiff_length = stiff_length;
  return patch_resistance_of(web, gamma_M1).resistance.value();
}

Bearing box_bearing(const Project& project, const Station& station, const FourWalls& walls,
                    bool along_z, Length stiff_length) {
  const std::array webs = webs_along(along_z);
  Bearing of;
  of.high = walls.of(webs[0]).middle.value();
  of.low = walls.of(webs[1]).middle.value();
  for (const BoxPlate plate : webs) {
    for (const BoxPlate by : webs_along(!along_z)) {
      const PatchedWeb web = web_onto(walls, plate, by);
      const double bears = resistance_of(web, stiff_length, project.strength.gamma_M1);
      of.add(web, bears);
    }
  }
  of.box = std::make_shared<const EffectiveBox>(
      walls, lag_shares_at({}, judged_section_at(project, station), station));
  return of;
}

std::optional<Bearing> path_bearing(const Project& project, const Station& station, bool along_z,
                                    Length stiff_length) {
  if (!path_obstacle(project, station).empty()) return std::nullopt;
  const auto path = judged_path_at(project, {}, station);
  if (!path) return std::nullopt;
  Bearing of;
  of.path = std::make_shared<const EffectivePath>(*path);
  const std::vector<PathWeb> webs = webs_of_path(*path, along_z, true).webs;
  if (webs.empty()) return std::nullopt;
  of.high = webs.front().place.value();
  of.low = webs.back().place.value();
  for (const PathWeb& web : webs) {
    const double bears = resistance_of(web.bears, stiff_length, project.strength.gamma_M1);
    of.add(web.bears, bears);
  }
  return of;
}

std::optional<Bearing> bearing_at(const Project& project, const Station& station, bool along_z) {
  const auto stiff_length = stiff_length_at(project, station.s);
  // What webs lead into themselves along z bends them along y.
  if (!stiff_length && along_z) return std::nullopt;
  if (const auto walls = judged_walls_at(project, station))
    return box_bearing(project, station, *walls, along_z, stiff_length.value_or(Length{}));
  return path_bearing(project, station, along_z, stiff_length.value_or(Length{}));
}

/// Of every place of the loads what it brings along z, or along y.
std::vector<Pressing> pressings_of(const Project& project, const recorded::ChannelLoads& loads,
                                   bool along_z) {
  const auto K = static_cast<Eigen::Index>(loads.units.size());
  const Length end = project.beam.length();
  std::vector<Pressing> all;
  for (std::size_t p = 0; p < loads.constant.points.size(); ++p) {
    Pressing of;
    const Length s = std::clamp(loads.constant.points[p].s, Length{}, end);
    of.at = {s, s < end ? Side::behind : Side::before};
    const Extent extent = extent_of(section_at(project.beam, of.at).outer);
    const Eigen::Vector3d& constant = loads.constant.points[p].force;
    of.constant = along_z ? constant.z() : constant.y();
    of.force = of.couple = VectorXd::Zero(K);
    for (Eigen::Index k = 0; k < K; ++k) {
      const PointLoad& load = loads.units[static_cast<std::size_t>(k)].points[p];
      const double y = std::clamp(load.at.x(), extent.y_low.value(), extent.y_high.value());
      const double z = std::clamp(load.at.y(), extent.z_low.value(), extent.z_high.value());
      of.force[k] = along_z ? load.force.z() : load.force.y();
      of.couple[k] = load.moment.x() + (along_z ? z * load.force.y() : -y * load.force.z());
    }
    if (!of.force.isZero(0.0) || (project.in_space && !of.couple.isZero(0.0))) all.push_back(of);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Pressing& a, const Pressing& b) { return a.at.s < b.at.s; });
  return all;
}

/// What stresses along the beam use there, in every sense of N, M_y and M_z.
std::vector<VectorXd> uses_along(const Project& project, const Bearing& by, const Station& station,
                                 const std::vector<CutForceDiagram>& units) {
  using enum cut_force::Index;
  const auto K = static_cast<Eigen::Index>(units.size());
  std::vector<VectorXd> uses{VectorXd::Zero(K)};
  for (const cut_force::Index of : {N, M_y, M_z}) {
    VectorXd row(K);
    for (Eigen::Index k = 0; k < K; ++k)
      row[k] = value_of(units[static_cast<std::size_t>(k)].at(station), of);
    if (row.isZero(0.0)) continue;
    std::vector<VectorXd> more;
    for (const double sense : {-1.0, 1.0}) {
      CutForces cut{};
      if (of == N) cut.N = si<Force>(sense);
      if (of == M_y) cut.M_y = si<Moment>(sense);
      if (of == M_z) cut.M_z = si<Moment>(sense);
      const double weight = project.strength.gamma_M0 * sense * by.use(cut);
      for (const VectorXd& before : uses) more.push_back(before + weight * row);
    }
    uses = std::move(more);
  }
  return uses;
}

/// The sums of one direction across the beam.
class Pressed {
 public:
  Pressed(const Project& project, const std::vector<CutForceDiagram>& units,
          std::vector<PressingSum>& sums)
      : project_(&project), units_(&units), sums_(&sums) {}

  /// A set of forces, of which the first and the last stand at two stations.
  struct Set {
    std::array<Station, 2> ends;
    VectorXd force, turned;
  };

  /// The shares of both webs of a set, by themselves and with the stresses at either station, where
  /// another force is against them, or at all instants.
  void add(const Bearing& by, const Set& set, const Pressing* against) {
    const auto put = [&](VectorXd sum) {
      PressingSum of{std::move(sum)};
      if (against != nullptr) {
        of.against = against->force;
        of.constant = against->constant;
        of.least = by.none;
      }
      sums_->push_back(std::move(of));
    };
    std::vector<VectorXd> shares{set.force};
    if (by.high - by.low > 0.0) {
      const VectorXd first = (set.turned - by.low * set.force) / (by.high - by.low);
      shares = {first, set.force - first};
    }
    for (const VectorXd& share : shares) put(share);
    constexpr std::array parts{1.0, 0.5, 2.0};  // of F_Rd
    const auto counted = std::span(parts).first(against != nullptr ? 1 : 3);
    for (std::size_t end = 0; end < (set.ends[0].s == set.ends[1].s ? 1U : 2U); ++end) {
      for (const VectorXd& use : uses_along(*project_, by, set.ends[end], *units_)) {
        for (const VectorXd& share : shares) {
          for (const double part : counted)
            put(share / (part * by.resistance) + weight_of_eta_1 * use);
        }
      }
    }
  }

 private:
  static constexpr double weight_of_eta_1 = 0.8;  // 7.2(1)
  const Project* project_;
  const std::vector<CutForceDiagram>* units_;
  std::vector<PressingSum>* sums_;
};

/// Sets of forces from one on, each at most `depth` from it: all of few, of more those of
/// neighbours.
void add_sets(const std::vector<Pressing>& all, std::size_t from, double sense, const Bearing& by,
              Pressed& sums) {
  constexpr std::size_t few = 3;
  const auto apart = [&](std::size_t j) {
    return std::abs((all[j].at.s - all[from].at.s).value());
  };
  std::size_t to = from + 1;
  while (to < all.size() && apart(to) <= by.depth) ++to;
  const std::size_t others = to - from - 1;
  const auto add = [&](const auto& is_in) {
    Pressed::Set set{{all[from].at, all[from].at}, all[from].force, sense * all[from].couple};
    for (std::size_t j = from + 1; j < to; ++j) {
      if (!is_in(j - from - 1)) continue;
      set.force += all[j].force;
      set.turned += sense * all[j].couple;
      set.ends[1] = all[j].at;
    }
    sums.add(by, set, nullptr);
    for (std::size_t j = 0; j < all.size(); ++j) {
      const bool counts = j == from || (j > from && j < to && is_in(j - from - 1));
      const Length near =
          std::min(abs(all[j].at.s - set.ends[0].s), abs(all[j].at.s - set.ends[1].s));
      if (!counts && near.value() <= by.depth) sums.add(by, set, &all[j]);
    }
  };
  if (others <= few) {
    for (std::size_t set = 0; set < std::size_t{1} << others; ++set)
      add([&](std::size_t j) { return (set >> j & 1U) != 0; });
  } else {
    for (std::size_t count = 0; count <= others; ++count)
      add([&](std::size_t j) { return j < count; });
  }
}

}  // namespace

std::vector<PressingSum> pressing_sums_of(const Project& project,
                                          const recorded::ChannelLoads& loads,
                                          const std::vector<CutForceDiagram>& units) {
  std::vector<PressingSum> sums;
  for (const bool along_z : {true, false}) {
    if (!along_z && !project.in_space) continue;
    const std::vector<Pressing> all = pressings_of(project, loads, along_z);
    Pressed pressed(project, units, sums);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto by = bearing_at(project, all[i].at, along_z);
      // A couple about the axis puts a force along y below it.
      if (by) add_sets(all, i, along_z ? 1.0 : -1.0, *by, pressed);
    }
  }
  return sums;
}

}  // namespace boxbeam
