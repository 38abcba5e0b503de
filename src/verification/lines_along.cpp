#include "lines_along.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

/// Of a load: where it is looked at.
constexpr std::array parts_looked_at{0.0, 0.25, 0.5, 0.75, 1.0};

}  // namespace

std::array<double, 2> LinesAlong::largest() const {
  double most = 0.0, most_couple = 0.0;
  for (const LineLoad& line : *lines_) {
    for (const double part : parts_looked_at) {
      const PerLength at = per_length_of(line, along_z_, part * line.length.value());
      most = std::max({most, at.pushes[0], at.pushes[1]});
      most_couple = std::max(most_couple, std::abs(at.couple));
    }
  }
  return {most, most_couple};
}

std::vector<Length> LinesAlong::ends() const {
  std::vector<Length> edges;
  for (const LineLoad& line : *lines_)
    if (presses(line)) edges.insert(edges.end(), {line.start, Length(line.start + line.length)});
  return edges;
}

std::vector<Length> LinesAlong::inside() const {
  std::vector<Length> places;
  for (const LineLoad& line : *lines_) {
    if (!presses(line)) continue;
    for (const double part : parts_looked_at) places.push_back(line.start + part * line.length);
  }
  return places;
}

std::vector<Length> LinesAlong::inside_if_uneven(const LineLoad& line) const {
  std::vector<Length> places;
  if (is_steady(line, along_z_)) return places;
  for (const double part : parts_looked_at) places.push_back(line.start + part * line.length);
  return places;
}

OnLength LinesAlong::on(Length begin, Length depth) const {
  begin = std::clamp(begin, Length{}, std::max(Length{}, Length(end_ - depth)));
  OnLength of;
  of.begin = begin;
  of.end = std::min(end_, Length(begin + depth));
  of.from = of.end;
  of.to = of.begin;
  for (const LineLoad& line : *lines_) {
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
      const PerLength here = per_length_of(line, along_z_, centre + half * at);
      for (const std::size_t k : {0U, 1U}) of.forces[k] += weight * half * here.pushes[k];
      of.turns += weight * half * here.couple;
      any = any || here.pushes[0] > 0.0 || here.pushes[1] > 0.0 || here.couple != 0.0;
    }
    if (!any) continue;
    of.from = std::min(of.from, from);
    of.to = std::max(of.to, to);
  }
  return of;
}

OnLength LinesAlong::drawn_to_heavier_end(OnLength of) const {
  const Length middle = 0.5 * (of.from + of.to), length = of.to - of.from;
  std::array<double, 2> at_ends{};
  const std::size_t sense = of.forces[1] > of.forces[0] ? 1 : 0;
  for (const LineLoad& line : *lines_) {
    if (!(middle > line.start && middle < line.start + line.length)) continue;
    at_ends[0] += per_length_of(line, along_z_, (of.from - line.start).value()).pushes[sense];
    at_ends[1] += per_length_of(line, along_z_, (of.to - line.start).value()).pushes[sense];
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
}

bool LinesAlong::presses(const LineLoad& line) const {
  const PerLength middle = per_length_of(line, along_z_, 0.5 * line.length.value());
  return middle.pushes[0] != 0.0 || middle.pushes[1] != 0.0 || middle.couple != 0.0;
}

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

}  // namespace boxbeam
