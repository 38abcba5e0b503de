// Loads along the beam as what comes into webs.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "lines_along.hpp"
#include "patch_search.hpp"
#include "patched_path.hpp"

namespace boxbeam {
namespace {

/// Of patches the forces and torques by themselves that no diaphragm takes.
std::vector<Patch> alone_in(const std::vector<Patch>& patches, bool along_z) {
  std::vector<Patch> alone;
  for (const Patch& of : patches) {
    // A torque stands for either of its two senses once.
    const bool counts = !of.is_torque() || of.force > Force{};
    if (of.along_z == along_z && !of.together && counts && of.diaphragm == nullptr)
      alone.push_back(of);
  }
  return alone;
}

/// Whether plates feel a force across.
bool presses(const PressedPlates& near, bool along_z, Force force) {
  return force > near.none &&
         near.meet(along_z, {along_z ? force : Force{}, along_z ? Force{} : force, {}, false});
}

/// A load along the beam with the forces of its sense that stand on that length, of kinks those at
/// one end of the section.
Patch with_forces_of(const std::vector<Patch>& others, const OnLength& of, std::optional<bool> high,
                     const Patch& line) {
  Patch sum = line;
  for (const Patch& other : others) {
    if (other.s < of.begin || other.s > of.end || other.is_torque() ||
        (other.force > Force{}) != (line.force > Force{}) ||
        (high && other.at_high && *other.at_high != *high))
      continue;
    sum.name += " and " + other.name;
    sum.force += other.force;
    sum.couple += other.couple;
    if (other.at_high) sum.at_high = other.at_high;
    const Length from = std::min({Length(line.s - 0.5 * line.stiff_length), other.s}),
                 to = std::max({Length(line.s + 0.5 * line.stiff_length), other.s});
    sum.s = 0.5 * (from + to);
    sum.stiff_length = std::max(sum.stiff_length, Length(to - from));
    sum.standing.clear();
    sum.together = true;
  }
  return sum;
}

}  // namespace

void PatchSearch::add_lines(const std::vector<LineLoad>& loads, bool along_z,
                            std::vector<Patch>& patches) {
  const LinesAlong lines(loads, along_z, project_->beam.length());
  // Most beams bear their weight alone.
  PressedPlates all;
  for (const PressedPlates& of : plates_.of_segments()) all.add(of);
  const auto [most, most_couple] = lines.largest();
  ForcesAcross largest{along_z ? si<Force>(most * all.depth.value()) : Force{},
                       along_z ? Force{} : si<Force>(most * all.depth.value()),
                       si<Moment>(most_couple * all.depth.value()), false};
  const Force size = along_z ? largest.along_z : largest.along_y;
  const bool turns = project_->in_space && most_couple > 0.0;
  if (!(size > all.none) && !turns) return;
  const std::vector<Patch> others = alone_in(patches, along_z);
  // What they hardly feel of it counts beside the forces there.
  for (const Patch& of : others) (along_z ? largest.along_z : largest.along_y) += abs(of.force);
  if (!all.meet(along_z, largest)) return;
  // The largest on a length of the webs' depth begins or ends where a load does, or is about its
  // middle where it is steady or grows.
  std::vector<Length> edges = lines.ends(), middles = lines.inside();
  for (const Patch& of : others) {
    edges.push_back(of.s);
    middles.push_back(of.s);
  }
  for (const Segment& of : project_->beam.segments) edges.push_back(of.end());
  const Length end = project_->beam.length();
  const auto add = [&](const OnLength& of) { add_length(of, others, along_z, patches); };
  const auto look = [&](Length begin, Length depth) { add(lines.on(begin, depth)); };
  const auto depth_near = [&](Length s) {
    Patch at;
    at.s = std::clamp(s, Length{}, end);
    at.along_z = along_z;
    return depth_at(at);
  };
  // Of what is heavier than the loads beside it a shorter length is pressed more: from every edge,
  // and where loads grow from every quarter of them, to every other.
  std::vector<Length> ends = edges;
  for (const LineLoad& line : loads) {
    constexpr double short_one = 0.1;  // of the depth
    if (line.length < short_one * depth_near(line.start)) continue;
    const std::vector<Length> inside = lines.inside_if_uneven(line);
    ends.insert(ends.end(), inside.begin(), inside.end());
  }
  for (std::vector<Length>* const of : {&edges, &ends}) {
    std::sort(of->begin(), of->end());
    of->erase(std::unique(of->begin(), of->end()), of->end());
  }
  for (const Length& edge : edges) {
    const Length depth = depth_near(edge);
    look(edge, depth);
    look(edge - depth, depth);
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Length depth = depth_near(ends[i]);
    // Of many pieces those of some numbers, each with all of them on the length of the fewest for
    // which it stands, so that none between is used more.
    constexpr std::size_t exact = 8;
    for (std::size_t j = i + 1; j < ends.size() && ends[j] - ends[i] < depth;) {
      const std::size_t next = j + std::max<std::size_t>(1, (j - i) / exact);
      const std::size_t last = std::min(next, ends.size()) - 1;
      OnLength of = lines.on(ends[i], ends[last] - ends[i]);
      of.to = std::min(of.to, Length(of.from + (ends[j] - ends[i])));
      add(of);
      // The seam bears what stands on each piece of it: as much as at the heavier end.
      if (j == i + 1 && of.to > of.from) add(lines.drawn_to_heavier_end(of));
      j = next;
    }
  }
  for (const Diaphragm& of : project_->beam.diaphragms) {
    const Length strip = strip_beside(of, along_z);
    if (!(strip > Length{}) || !holds(of, along_z)) continue;
    const Length from = std::max(Length{}, Length(of.s - strip));
    add_onto_diaphragm(lines.on(from, std::min(end, Length(of.s + strip)) - from), of, along_z,
                       patches);
  }
  for (const Length& middle : middles) {
    const Length depth = depth_near(middle);
    look(middle - 0.5 * depth, depth);
  }
}

Length PatchSearch::strip_beside(const Diaphragm& of, bool along_z) {
  Length strip;
  for (const Side side : {Side::before, Side::behind}) {
    if (side == Side::before ? of.s == Length{} : of.s == project_->beam.length()) continue;
    const JudgedSection& judged = judged_at({of.s, side});
    const auto take = [&](Length thickness, Stress strength) {
      strip = std::max(strip, Length(15.0 * std::sqrt(235e6 / strength.value()) * thickness));
    };
    if (judged.box) {
      for (const BoxPlate web : webs_along(along_z)) {
        const BoxWall& wall = judged.box->box().of(web);
        take(wall.thickness, wall.yield_strength);
      }
    } else if (judged.path) {
      for (const PathWeb& web : webs_of_path(judged.path->path(), along_z, true).webs)
        take(web.bears.thickness, web.bears.yield_strength);
    }
  }
  return strip;
}

/// What stands on the part of the webs that works with a diaphragm (9.1(2)) comes into that.
void PatchSearch::add_onto_diaphragm(const OnLength& of, const Diaphragm& diaphragm, bool along_z,
                                     std::vector<Patch>& patches) {
  if (!(of.to > of.from)) return;
  Patch line;
  line.name = "a load along the beam";
  line.along_z = along_z;
  line.is_line = true;
  line.s = diaphragm.s;
  line.stiff_length = of.to - of.from;
  line.diaphragm = &diaphragm;
  line.couple = si<Moment>(of.turns);
  std::vector<Patch> found;
  for (const std::size_t k : {0U, 1U}) {
    line.force = si<Force>(k == 0 ? of.forces[0] : -of.forces[1]);
    if (!(abs(line.force) > plates_.near(line.s).none)) continue;
    line.standing = {{line.force, {line.stands_at(), line.stands_at()}}};
    Patch sum = line;
    for (const Patch& other : patches) {
      if (other.diaphragm != &diaphragm || other.along_z != along_z ||
          (other.together && !other.led_onto) || other.is_line || other.is_torque() ||
          other.force * line.force < Force{} * Force{})
        continue;
      sum.force += other.force;
      sum.couple += other.couple;
      sum.standing.insert(sum.standing.end(), other.standing.begin(), other.standing.end());
      sum.name += " and " + other.name;
      sum.stiff_length = std::max(sum.stiff_length, other.stiff_length);
      sum.together = true;
    }
    found.push_back(std::move(sum));
  }
  patches.insert(patches.end(), found.begin(), found.end());
}

void PatchSearch::add_length(const OnLength& of, const std::vector<Patch>& others, bool along_z,
                             std::vector<Patch>& patches) {
  if (!(of.to > of.from)) return;
  Patch line;
  line.name = "a load along the beam";
  line.along_z = along_z;
  line.is_line = true;
  line.s = 0.5 * (of.from + of.to);
  line.stiff_length = of.to - of.from;
  const LoadIntroduction* const by = introduction_at(line.s);
  if (by != nullptr) {
    // Bosses in webs lead into them what stands on theirs alone.
    if (!by->stiff_length && along_z && by->from <= of.from && by->to >= of.to) return;
    used_.insert(by);
  }
  const PressedPlates& near = plates_.near(line.s);
  bool any = false;
  // With the torques of each sense there, and without.
  Moment torques;
  std::array<Moment, 2> turning{};
  for (const Patch& other : others) {
    if (other.s < of.begin || other.s > of.end || !other.is_torque()) continue;
    turning[other.torque > Moment{} ? 0 : 1] += other.torque;
    if (other.torque.value() * of.turns > 0.0) torques += other.torque;
  }
  // With what kinks turn off from one flange, and from the other.
  using Ends = std::vector<std::optional<bool>>;
  const bool kinked = std::any_of(others.begin(), others.end(), [&](const Patch& other) {
    return other.s >= of.begin && other.s <= of.end && other.at_high;
  });
  for (const std::size_t k : {0U, 1U}) {
    const Force force = si<Force>(of.forces[k]);
    Force against = si<Force>(of.forces[1 - k]);
    for (const Patch& other : others) {
      const bool here = other.s >= of.begin && other.s <= of.end && !other.is_torque();
      if (here && (other.force.value() > 0.0) != (k == 0)) against += abs(other.force);
    }
    line.opposed = against > near.none;
    line.force = k == 0 ? force : Force(-force);
    line.couple = si<Moment>(of.turns);
    line.standing = {{line.force, {line.stands_at(), line.stands_at()}}};
    if (!(force > 1e-6 * near.none)) continue;
    if (presses(near, along_z, force)) {
      patches.push_back(line);
      any = true;
    }
    for (const std::optional<bool>& high : kinked ? Ends{true, false} : Ends{std::nullopt}) {
      const Patch sum = with_forces_of(others, of, high, line);
      // Without a kink it is the same at either end of the section.
      if ((high && !sum.at_high && !*high) || !presses(near, along_z, abs(sum.force))) continue;
      if (sum.together) patches.push_back(sum);
      for (const Moment& torque : turning) {
        if (torque == Moment{}) continue;
        patches.push_back(sum);
        patches.back().name += " and torques";
        patches.back().couple += torque;
        patches.back().together = true;
      }
    }
  }
  if (any || of.turns == 0.0 || !project_->in_space) return;
  add_torque_along(std::move(line), si<Moment>(of.turns) + torques, patches);
}

void PatchSearch::add_torque_along(Patch line, Moment torque, std::vector<Patch>& patches) {
  const bool along_z = line.along_z;
  const auto apart = webs_apart_at(line.s, along_z);
  if (!apart) return;
  const LoadIntroduction* const by = introduction_at(line.s);
  if (by != nullptr && by->torque_by &&
      *by->torque_by != (along_z ? TorqueBy::webs : TorqueBy::flanges))
    return;
  const Force force = abs(torque) / *apart;
  if (!presses(plates_.near(line.s), along_z, force)) return;
  line.name = "a torque along the beam";
  line.opposed = true;
  line.couple = {};
  line.standing.clear();
  line.torque = torque;
  for (const double sense : {1.0, -1.0}) {
    line.force = sense * force;
    patches.push_back(line);
  }
}

}  // namespace boxbeam
