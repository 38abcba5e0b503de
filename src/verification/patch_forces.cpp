// What comes into webs: forces and couples, and those that stand together.
#include <algorithm>
#include <cmath>
#include <map>

#include "boxbeam/verification/slender_path.hpp"
#include "lines_along.hpp"
#include "patch_search.hpp"
#include "patched_path.hpp"

namespace boxbeam {
namespace {

/// Whether one patch stands so near another that a web feels both. What one diaphragm takes, it
/// takes together.
bool stand_beside(const Patch& a, const Patch& b, Length depth) {
  return a.along_z == b.along_z && a.diaphragm == b.diaphragm &&
         (a.diaphragm != nullptr || abs(b.s - a.s) <= depth);
}

/// Whether a force hangs from the flange that it pulls at: of what stands near the middle of the
/// section, which may come in anywhere, it is not known.
std::optional<bool> hangs_in(const Extent& extent, const PointLoad& load, bool along_z) {
  constexpr double near_middle = 0.125;  // of the depth
  const double height = along_z ? load.at.y() : load.at.x(),
               force = along_z ? load.force.z() : load.force.y();
  const Length depth = along_z ? extent.z_high - extent.z_low : extent.y_high - extent.y_low;
  if (!(std::abs(height) > near_middle * depth.value())) return std::nullopt;
  return (force > 0.0) == (height > 0.0);
}

bool pushes(const Patch& of) { return of.force.value() > 0.0; }

/// The name of several as one: of very many the first and the last.
std::string name_of(const Patch& first, const Patch& sum, const Patch& added, int count) {
  constexpr int few = 3;
  if (sum.name == added.name || sum.name.ends_with(" together")) return first.name + " together";
  return count <= few ? sum.name + " and " + added.name : first.name + " to " + added.name;
}

}  // namespace

std::vector<Patch> PatchSearch::forces_of(const BeamLoads& loads) const {
  const TaperedBeam& beam = project_->beam;
  std::vector<Patch> patches;
  patches.reserve(loads.points.size() * (project_->in_space ? 2 : 1));
  std::map<std::string_view, std::size_t> of_name;
  for (const PointLoad& load : loads.points) {
    const std::size_t number = of_name[load.name]++;
    if (is_at_end(load.s) && kinds_.clamps(load.name)) {
      // The plates of another body bring the torque as forces, too.
      for (const bool along_z : {true, false})
        if (project_->in_space && kinds_.leads_on(load.name)) add_torque(load, along_z, patches);
      continue;
    }
    for (const bool along_z : {true, false}) {
      if (!along_z && !project_->in_space) continue;
      Patch patch;
      patch.force = si<Force>(along_z ? load.force.z() : load.force.y());
      if (patch.force == Force{}) {
        if (project_->in_space) add_torque(load, along_z, patches);
        continue;
      }
      patch.name = load.name.empty() ? std::string("a force") : std::string(load.name);
      patch.s = std::clamp(load.s, Length{}, beam.length());
      patch.along_z = along_z;
      patch.couple = couple_along(load, along_z);
      patch.standing = {
          {patch.force, {si<Length>(along_z ? load.at.x() : load.at.y()), patch.stands_at()}}};
      patch.hangs = hangs_in(extent_at(load.s), load, along_z);
      patch.moves = kinds_.moves(load.name, load.part > 0 ? load.part : number);
      patch.load = load.part > 0 ? load.part : number;
      patches.push_back(std::move(patch));
    }
  }
  return patches;
}

Extent PatchSearch::extent_at(Length s) const {
  const TaperedBeam& beam = project_->beam;
  return extent_of(section_at(beam, {std::clamp(s, Length{}, beam.length()), Side::both}).outer);
}

Moment PatchSearch::couple_along(const PointLoad& load, bool along_z) const {
  const Extent extent = extent_at(load.s);
  const double y = load.at.x(), z = load.at.y();
  // What the force across gives within the section goes round it in shear.
  const double across =
      along_z ? -(z - std::clamp(z, extent.z_low.value(), extent.z_high.value())) * load.force.y()
              : (y - std::clamp(y, extent.y_low.value(), extent.y_high.value())) * load.force.z();
  const double along = along_z ? y * load.force.z() : -z * load.force.y();
  const double couple = torque_of(load) + along + across;
  constexpr double round_off = 1e-9;
  const double size =
      std::max((extent.y_high - extent.y_low).value(), (extent.z_high - extent.z_low).value());
  return si<Moment>(std::abs(couple) > round_off * size * load.force.norm() ? couple : 0.0);
}

void PatchSearch::add_torque(const PointLoad& load, bool along_z,
                             std::vector<Patch>& patches) const {
  const LoadIntroduction* const by = introduction_at(load.s);
  const bool said = by != nullptr && by->torque_by;
  if (said && *by->torque_by != (along_z ? TorqueBy::webs : TorqueBy::flanges)) return;
  const Moment torque = said ? si<Moment>(load.moment.x()) : couple_along(load, along_z);
  if (torque == Moment{}) return;
  const Length s = std::clamp(load.s, Length{}, project_->beam.length());
  const auto apart = webs_apart_at(s, along_z);
  if (!apart) return;
  for (const double sense : {1.0, -1.0}) {
    Patch& patch = patches.emplace_back();
    patch.name = "the torque of " + (load.name.empty() ? "a couple" : std::string(load.name));
    patch.s = s;
    patch.along_z = along_z;
    patch.torque = torque;
    patch.force = sense * abs(patch.torque) / *apart;
  }
}

std::optional<Length> PatchSearch::webs_apart_at(Length s, bool along_z) const {
  return webs_apart_.of({s.value(), along_z ? 1.0 : 0.0},
                        [&] { return find_webs_apart(s, along_z); });
}

std::optional<Length> PatchSearch::find_webs_apart(Length s, bool along_z) const {
  const Station station{s, Side::both};
  using enum BoxPlate;
  if (const auto walls = walls_at(station)) {
    return along_z ? walls->of(left_web).middle - walls->of(right_web).middle
                   : walls->of(top_flange).middle - walls->of(bottom_flange).middle;
  }
  const auto path = judged_path_at(*project_, *zones_, station);
  if (!path) return std::nullopt;
  const PathWebs of = webs_of_path(*path, along_z, true);
  if (of.webs.size() != 2) return std::nullopt;
  return of.apart();
}

bool PatchSearch::lacks_diaphragm(Length s) {
  const Length at = std::clamp(s, Length{}, project_->beam.length());
  const PressedPlates& of = plates_.near(at);
  return (of.path ? of.web_along_z : of.along_z) && diaphragm_at(at) == nullptr;
}

bool PatchSearch::lacks_diaphragm_along_y(Length s, Force along_y) {
  const Length at = std::clamp(s, Length{}, project_->beam.length());
  const PressedPlates& of = plates_.near(at);
  return abs(along_y) > of.none && (of.path ? of.web_along_y : of.along_y) &&
         diaphragm_at(at) == nullptr;
}

bool PatchSearch::feels_couple(Length s, Moment couple, bool about_y) {
  Patch at;
  at.s = std::clamp(s, Length{}, project_->beam.length());
  at.along_z = about_y;
  const Length depth = depth_at(at);
  if (!(depth > Length{})) return false;
  const Force force = couple / depth;
  const PressedPlates& near = plates_.near(at.s);
  // Stout webs are spared what they hardly feel, slender ones what is no more than weight.
  return force > near.none &&
         near.meet(about_y, {about_y ? force : Force{}, about_y ? Force{} : force, {}, false});
}

std::optional<Moment> PatchSearch::unjudged_moment_of(const PointLoad& load) {
  const bool at_end = is_at_end(load.s);
  // At an end of the beam by joints alone; those in line with it, or judged as knees, lead all on.
  if (at_end && (!kinds_.leads_on(load.name) ||
                 std::find(knees_.begin(), knees_.end(), load.name) != knees_.end()))
    return std::nullopt;
  std::optional<Moment> most;
  for (const bool about_y : {true, false}) {
    if (!about_y && !project_->in_space) continue;
    const Moment couple = si<Moment>(std::abs(about_y ? load.moment.y() : load.moment.z()));
    if (feels_couple(load.s, couple, about_y)) most = std::max(most.value_or(Moment{}), couple);
  }
  return most;
}

void PatchSearch::add_beside_diaphragms(std::vector<Patch>& patches) {
  const std::size_t singles = patches.size();
  for (const Diaphragm& of : project_->beam.diaphragms) {
    for (std::size_t i = 0; i < singles; ++i) {
      const Length near = 0.5 * patches[i].stiff_length + of.thickness;
      if (patches[i].diaphragm != nullptr || patches[i].kink != nullptr ||
          abs(patches[i].s - of.s) > near || !holds(of, patches[i].along_z))
        continue;
      Patch taken = patches[i];
      taken.s = of.s;
      taken.diaphragm = &of;
      taken.given = true;
      taken.stout = false;
      taken.together = true;  // with what leads it there
      taken.led_onto = true;
      taken.led_there =
          patches[i].may_come_beside_flanges();  // else counted in cycles where it stands
      patches.push_back(std::move(taken));
    }
  }
}

void PatchSearch::mark_opposed(const std::vector<LineLoad>& lines, const std::vector<Patch>& all,
                               std::vector<Patch>& some) {
  std::vector<Length> depths;
  for (const Patch& of : all) depths.push_back(depth_at(of));
  for (Patch& of : some) {
    const Length depth = depth_at(of);
    Force against = across_on(lines, of.along_z, !pushes(of), of.s - depth, of.s + depth);
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (pushes(of) != pushes(all[j]) && stand_beside(of, all[j], std::max(depth, depths[j])))
        against += abs(all[j].force);
    }
    of.opposed = against > plates_.near(of.s).none;
  }
}

void PatchSearch::add_groups(std::vector<Patch>& patches) {
  if (!project_->beam.diaphragms.empty()) add_beside_diaphragms(patches);
  std::stable_sort(patches.begin(), patches.end(),
                   [](const Patch& a, const Patch& b) { return a.s < b.s; });
  const std::size_t singles = patches.size();
  std::vector<Length> depths;
  for (const Patch& of : patches) depths.push_back(depth_at(of));
  bool kinked = false, turned = false;
  for (std::size_t i = 0; i < singles; ++i) {
    kinked = kinked || patches[i].at_high.has_value();
    turned = turned || patches[i].is_torque();
  }
  if (kinked) add_through_diaphragms(singles, patches);
  using Ends = std::vector<std::optional<bool>>;
  for (const std::optional<bool>& high : kinked ? Ends{true, false} : Ends{std::nullopt}) {
    for (const double turning :
         turned ? std::vector<double>{0.0, 1.0, -1.0} : std::vector<double>{0.0})
      add_groups_at(high, turning, singles, depths, patches);
  }
}

void PatchSearch::add_through_diaphragms(std::size_t singles, std::vector<Patch>& patches) const {
  for (const Diaphragm& of : project_->beam.diaphragms) {
    for (const bool along_z : {true, false}) {
      for (const bool up : {true, false}) {
        std::optional<Patch> sum;
        std::array<bool, 2> ends{};
        for (std::size_t i = 0; i < singles; ++i) {
          const Patch& other = patches[i];
          if (other.diaphragm != &of || other.along_z != along_z || other.is_torque() ||
              other.is_none() || pushes(other) != up)
            continue;
          if (other.at_high) ends[*other.at_high ? 1 : 0] = true;
          if (!sum) {
            sum = other;
            continue;
          }
          sum->name += " and " + other.name;
          sum->force += other.force;
          sum->couple += other.couple;
          sum->given = sum->given && other.given;
        }
        if (!sum || !ends[0] || !ends[1]) continue;
        sum->through = sum->together = true;
        sum->kink = nullptr;
        sum->at_high.reset();
        sum->standing.clear();
        patches.push_back(*std::move(sum));
      }
    }
  }
}

void PatchSearch::add_groups_at(std::optional<bool> high, double turning, std::size_t singles,
                                const std::vector<Length>& depths,
                                std::vector<Patch>& patches) const {
  const auto comes_in_here = [&](const Patch& of) {
    return !high || !of.at_high || *of.at_high == *high;
  };
  const auto turns_here = [&](const Patch& of) { return of.torque.value() * turning > 0.0; };
  // Every group of few; of more those of some numbers, each with all its forces on the length of
  // the smallest group for which it stands, so that none between is used more.
  constexpr int few = 8;
  for (std::size_t i = 0; i < singles; ++i) {
    const bool of_torques = patches[i].is_torque();
    if (!comes_in_here(patches[i]) || (of_torques && !turns_here(patches[i]))) continue;
    Patch sum = patches[i];
    const Length first = sum.s;
    Length length, shortest;
    int count = 1, kept = 1;
    bool turned = of_torques;
    const auto keep = [&] {
      kept = count;
      // Without a kink it is the same at either end of the section, without a torque in any sense.
      if ((high && !sum.at_high && !*high) || turned != (turning != 0.0)) return;
      patches.push_back(sum);
      patches.back().stiff_length = shortest;
    };
    length = sum.stiff_length;
    const auto add = [&](const Patch& other) {
      const Length from = std::min(first, other.s), to = std::max(first, other.s);
      length = std::max({Length(to - from), length, other.stiff_length});
      if (++count == kept + 1) shortest = length;
      if (other.is_torque() && !of_torques) {
        sum.couple += other.torque;
        sum.turns += other.torque;
        turned = true;
      } else {
        sum.force += other.force;
        sum.torque += other.torque;
        sum.couple += other.couple;
      }
      sum.standing.insert(sum.standing.end(), other.standing.begin(), other.standing.end());
      sum.bent = std::max(sum.bent, other.bent);
      sum.kink = sum.kink != nullptr ? other.kink : nullptr;
      if (other.at_high) sum.at_high = other.at_high;
      if (other.hangs.value_or(false)) sum.hangs = true;
      sum.given = sum.given && other.given;
      sum.opposed = sum.opposed || other.opposed;
      sum.stout = sum.stout || other.stout;
      sum.s = 0.5 * (from + to);
      sum.together = true;
      sum.name = name_of(patches[i], sum, other, count);
      if (count <= few || 2 * count >= 3 * kept) keep();
    };
    for (std::size_t j = 0; j < singles; ++j) {
      const Patch& other = patches[j];  // until more are added, which is the last of it
      // A torque stands for either of its two senses once beside forces, and on both sides of them.
      const bool beside_force = other.is_torque() && !of_torques;
      if (beside_force ? !turns_here(other) || !pushes(other)
                       : j <= i || other.is_torque() != of_torques ||
                             pushes(sum) != pushes(other) || (of_torques && !turns_here(other)))
        continue;
      if (stand_beside(patches[i], other, std::max(depths[i], depths[j])) && comes_in_here(other))
        add(other);
    }
    if (count > kept) keep();
  }
}

}  // namespace boxbeam
