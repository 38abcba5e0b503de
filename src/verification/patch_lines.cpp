// Loads along the beam as what comes into webs.
#include <algorithm>
#include <array>
#include <cmath>

#include "patch_search.hpp"
#include "patched_path.hpp"

namespace boxbeam {
namespace {

/// Of a load along the beam at a place: what pushes along the axis and what pushes against it,
/// each with its size, and the couple about the beam's axis [N/m, N].
struct PerLength {
  std::array<double, 2> pushes{};
  double couple = 0.0;
};

PerLength per_length_of(const LineLoad& line, bool along_z, double x) {
  PerLength of;
  const std::size_t axis = along_z ? 2 : 1;
  const auto& outside = line.outside[axis - 1];
  const double along = outside[0](x), against = outside[1](x);
  // Weight and inertia act within the plates, which is on the safe side here.
  const double own = line.force[axis](x) - (along - against);
  of.pushes = {along + std::max(0.0, own), against + std::max(0.0, -own)};
  of.couple = line.couple[0](x);
  return of;
}

/// Whether it is the same everywhere, but for weight and inertia.
bool is_steady(const LineLoad& line, bool along_z) {
  const auto& outside = line.outside[along_z ? 1 : 0];
  return outside[0].c[1] == 0.0 && outside[1].c[1] == 0.0;
}

}  // namespace

Force across_on(const std::vector<LineLoad>& lines, bool along_z, bool pushing, Length from,
                Length to) {
  double sum = 0.0;
  constexpr int pieces = 4;
  for (const LineLoad& line : lines) {
    const Length low = std::max(from, line.start),
                 high = std::min(to, Length(line.start + line.length));
    if (!(high > low)) continue;
    for (int i = 0; i < pieces; ++i) {
      const double x = ((low - line.start) + (i + 0.5) / pieces * (high - low)).value();
      sum +=
          per_length_of(line, along_z, x).pushes[pushing ? 0 : 1] * (high - low).value() / pieces;
    }
  }
  return si<Force>(sum);
}

/// What stands on a length of the beam.
struct PatchSearch::OnLength {
  Length from, to;                   ///< of what is loaded
  std::array<double, 2> forces{};    ///< along the axis and against it, sizes [N]
  double turns = 0.0;                ///< the couple alone [N m]
  const std::vector<Patch>* others;  ///< forces and torques by themselves
  Length begin, end;                 ///< the length itself
};

void PatchSearch::add_lines(const std::vector<LineLoad>& lines, bool along_z,
                            std::vector<Patch>& patches) {
  constexpr std::array parts{0.0, 0.25, 0.5, 0.75, 1.0};
  // Most beams bear their weight alone.
  PressedPlates all;
  for (const PressedPlates& of : plates_.of_segments()) all.add(of);
  double most = 0.0, most_couple = 0.0;
  for (const LineLoad& line : lines) {
    for (const double part : parts) {
      const PerLength at = per_length_of(line, along_z, part * line.length.value());
      most = std::max({most, at.pushes[0], at.pushes[1]});
      most_couple = std::max(most_couple, std::abs(at.couple));
    }
  }
  ForcesAcross largest{along_z ? si<Force>(most * all.depth.value()) : Force{},
                       along_z ? Force{} : si<Force>(most * all.depth.value()),
                       si<Moment>(most_couple * all.depth.value()), false};
  const Force size = along_z ? largest.along_z : largest.along_y;
  const bool turns = project_->in_space && most_couple > 0.0;
  if (!(size > all.none) && !turns) return;
  const std::vector<Patch> others = [&] {
    std::vector<Patch> of;
    for (const Patch& patch : patches) {
      // A torque stands for either of its two senses once.
      const bool counts = !patch.is_torque() || patch.force > Force{};
      if (patch.along_z == along_z && !patch.together && counts && patch.diaphragm == nullptr)
        of.push_back(patch);
    }
    return of;
  }();
  // What they hardly feel of it counts beside the forces there.
  for (const Patch& of : others) (along_z ? largest.along_z : largest.along_y) += abs(of.force);
  if (!all.meet(along_z, largest)) return;
  // The largest on a length of the webs' depth begins or ends where a load does, or is about its
  // middle where it is steady or grows.
  std::vector<Length> edges, middles;
  for (const LineLoad& line : lines) {
    const PerLength middle = per_length_of(line, along_z, 0.5 * line.length.value());
    if (middle.pushes[0] == 0.0 && middle.pushes[1] == 0.0 && middle.couple == 0.0) continue;
    edges.insert(edges.end(), {line.start, Length(line.start + line.length)});
    for (const double part : parts) middles.push_back(line.start + part * line.length);
  }
  for (const Patch& of : others) {
    edges.push_back(of.s);
    middles.push_back(of.s);
  }
  for (const Segment& of : project_->beam.segments) edges.push_back(of.end());
  const Length end = project_->beam.length();
  const auto stands_on = [&](Length begin, Length depth) {
    begin = std::clamp(begin, Length{}, std::max(Length{}, Length(end - depth)));
    OnLength of;
    of.begin = begin;
    of.end = std::min(end, Length(begin + depth));
    of.from = of.end;
    of.to = of.begin;
    of.others = &others;
    for (const LineLoad& line : lines) {
      const Length from = std::max(of.begin, line.start),
                   to = std::min(of.end, Length(line.start + line.length));
      if (!(to > from)) continue;
      // By Gauss with three places.
      const double half = 0.5 * (to - from).value(),
                   centre = 0.5 * (from + to - 2.0 * line.start).value();
      bool any = false;
      for (const auto& [at, weight] : {std::pair{-0.7745966692414834, 5.0 / 9.0},
                                       {0.0, 8.0 / 9.0},
                                       {0.7745966692414834, 5.0 / 9.0}}) {
        const PerLength here = per_length_of(line, along_z, centre + half * at);
        for (const std::size_t k : {0U, 1U}) of.forces[k] += weight * half * here.pushes[k];
        of.turns += weight * half * here.couple;
        any = any || here.pushes[0] > 0.0 || here.pushes[1] > 0.0 || here.couple != 0.0;
      }
      if (!any) continue;
      of.from = std::min(of.from, from);
      of.to = std::max(of.to, to);
    }
    return of;
  };
  const auto look = [&](Length begin, Length depth) {
    add_length(stands_on(begin, depth), along_z, patches);
  };
  const auto depth_near = [&](Length s) {
    Patch at;
    at.s = std::clamp(s, Length{}, end);
    at.along_z = along_z;
    return depth_at(at);
  };
  const auto drawn_to_heavier_end = [&](OnLength of) {
    const Length middle = 0.5 * (of.from + of.to), length = of.to - of.from;
    std::array<double, 2> at_ends{};
    const std::size_t sense = of.forces[1] > of.forces[0] ? 1 : 0;
    for (const LineLoad& line : lines) {
      if (!(middle > line.start && middle < line.start + line.length)) continue;
      at_ends[0] += per_length_of(line, along_z, (of.from - line.start).value()).pushes[sense];
      at_ends[1] += per_length_of(line, along_z, (of.to - line.start).value()).pushes[sense];
    }
    const bool at_start = at_ends[0] > at_ends[1];
    const double peak = at_ends[at_start ? 0 : 1];
    if (!(of.forces[sense] < peak * length.value())) return of;
    const Length drawn = si<Length>(of.forces[sense] / peak);
    if (at_start)
      of.to = of.from + drawn;
    else
      of.from = of.to - drawn;
    return of;
  };
  // Of what is heavier than the loads beside it a shorter length is pressed more: from every edge,
  // and where loads grow from every quarter of them, to every other.
  std::vector<Length> ends = edges;
  for (const LineLoad& line : lines) {
    constexpr double short_one = 0.1;  // of the depth
    if (is_steady(line, along_z) || line.length < short_one * depth_near(line.start)) continue;
    for (const double part : parts) ends.push_back(line.start + part * line.length);
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
      OnLength of = stands_on(ends[i], ends[last] - ends[i]);
      of.to = std::min(of.to, Length(of.from + (ends[j] - ends[i])));
      add_length(of, along_z, patches);
      // The seam bears what stands on each piece of it: as much as at the heavier end.
      if (j == i + 1 && of.to > of.from) add_length(drawn_to_heavier_end(of), along_z, patches);
      j = next;
    }
  }
  for (const Diaphragm& of : project_->beam.diaphragms) {
    const Length strip = strip_beside(of, along_z);
    if (!(strip > Length{}) || !holds(of, along_z)) continue;
    const Length from = std::max(Length{}, Length(of.s - strip));
    add_onto_diaphragm(stands_on(from, std::min(end, Length(of.s + strip)) - from), of, along_z,
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

void PatchSearch::add_length(const OnLength& of, bool along_z, std::vector<Patch>& patches) {
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
  const auto presses = [&](Force force) {
    return force > near.none &&
           near.meet(along_z, {along_z ? force : Force{}, along_z ? Force{} : force, {}, false});
  };
  bool any = false;
  // With the torques of each sense there, and without.
  Moment torques;
  std::array<Moment, 2> turning{};
  for (const Patch& other : *of.others) {
    if (other.s < of.begin || other.s > of.end || !other.is_torque()) continue;
    turning[other.torque > Moment{} ? 0 : 1] += other.torque;
    if (other.torque.value() * of.turns > 0.0) torques += other.torque;
  }
  // With what kinks turn off from one flange, and from the other.
  using Ends = std::vector<std::optional<bool>>;
  const bool kinked = std::any_of(of.others->begin(), of.others->end(), [&](const Patch& other) {
    return other.s >= of.begin && other.s <= of.end && other.at_high;
  });
  for (const std::size_t k : {0U, 1U}) {
    const Force force = si<Force>(of.forces[k]);
    Force against = si<Force>(of.forces[1 - k]);
    for (const Patch& other : *of.others) {
      const bool here = other.s >= of.begin && other.s <= of.end && !other.is_torque();
      if (here && (other.force.value() > 0.0) != (k == 0)) against += abs(other.force);
    }
    line.opposed = against > near.none;
    line.force = k == 0 ? force : Force(-force);
    line.couple = si<Moment>(of.turns);
    line.standing = {{line.force, {line.stands_at(), line.stands_at()}}};
    if (!(force > 1e-6 * near.none)) continue;
    if (presses(force)) {
      patches.push_back(line);
      any = true;
    }
    for (const std::optional<bool>& high : kinked ? Ends{true, false} : Ends{std::nullopt}) {
      Patch sum = line;
      for (const Patch& other : *of.others) {
        if (other.s < of.begin || other.s > of.end || other.is_torque() ||
            (other.force.value() > 0.0) != (k == 0) ||
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
      // Without a kink it is the same at either end of the section.
      if ((high && !sum.at_high && !*high) || !presses(abs(sum.force))) continue;
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
  // Torque along the beam, as couples at one place are.
  const auto apart = webs_apart_at(line.s, along_z);
  if (!apart) return;
  if (by != nullptr && by->torque_by &&
      *by->torque_by != (along_z ? TorqueBy::webs : TorqueBy::flanges))
    return;
  const Moment torque = si<Moment>(of.turns) + torques;
  if (!presses(abs(torque) / *apart)) return;
  line.name = "a torque along the beam";
  line.opposed = true;
  line.couple = {};
  line.standing.clear();
  line.torque = torque;
  for (const double sense : {1.0, -1.0}) {
    line.force = sense * abs(torque) / *apart;
    patches.push_back(line);
  }
}

}  // namespace boxbeam
