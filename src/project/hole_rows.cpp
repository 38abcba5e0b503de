#include "boxbeam/project/hole_rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace boxbeam {

namespace {

/// A hole as the chord that it takes at a station on a side; nothing of it where that is small.
std::optional<BeamHole> chord_of(const BeamHole& at, const Station& station) {
  constexpr double least_chord = 0.1;
  if (station.side == Side::both) return std::nullopt;
  const double along = 2.0 * ((station.s - at.s) / at.hole.diameter);
  if (!(std::abs(along) < 1.0)) return std::nullopt;
  const double chord = std::sqrt(1.0 - along * along);
  if (chord < least_chord) return std::nullopt;
  BeamHole cut = at;
  cut.s = station.s;
  cut.hole.diameter = chord * at.hole.diameter;
  return cut;
}

/// Puts a hole in place of what counts of it, where it is wider and overlaps no other.
void widen(const Hole& to, std::vector<Hole>& holes) {
  const auto same =
      std::find_if(holes.begin(), holes.end(), [&](const Hole& of) { return of.name == to.name; });
  const bool overlaps = std::any_of(holes.begin(), holes.end(), [&](const Hole& of) {
    return of.name != to.name && of.walls == to.walls &&
           2.0 * abs(of.position - to.position) <= 1.0001 * (of.diameter + to.diameter);
  });
  if (overlaps) return;
  if (same == holes.end())
    holes.push_back(to);
  else if (to.diameter > same->diameter)
    *same = to;
}

}  // namespace

std::vector<Hole> holes_in_section(const Project& project, const Station& station) {
  std::vector<BeamHole> all = project.holes, reaching;
  const BeamHole* nearest = nullptr;
  for (const BeamHole& at : project.holes) {
    if (at.s == station.s) nearest = &at;
    auto chord = chord_of(at, station);
    if (!chord) continue;
    if (nearest == nullptr || abs(at.s - station.s) < abs(nearest->s - station.s)) nearest = &at;
    reaching.push_back(std::move(*chord));
  }
  if (nearest == nullptr) return {};
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (project.holes[i].s != nearest->s) continue;
    if (auto chord = chord_of(project.holes[i], station)) all[i] = std::move(*chord);
  }
  std::vector<Hole> holes = holes_at(all, station.s);
  for (const BeamHole& of : reaching) widen(of.hole, holes);
  return holes;
}

std::vector<CutHole> holes_cut_at(const Project& project, const Station& station) {
  std::vector<CutHole> cut;
  std::vector<Hole> holes;
  for (const BeamHole& at : project.holes) {
    if (at.s == station.s) {
      cut.push_back({&at, at.hole, at.concentration});
      continue;
    }
    if (!chord_of(at, station)) continue;
    if (holes.empty()) holes = holes_in_section(project, station);
    const auto same = std::find_if(holes.begin(), holes.end(),
                                   [&](const Hole& of) { return of.name == at.hole.name; });
    if (same == holes.end()) continue;
    cut.push_back({&at, *same, at.concentration});
    // Near its ends a hole has no edge that is stressed as beside its middle.
    if (same->diameter < 0.5 * at.hole.diameter) cut.back().concentration.reset();
  }
  return cut;
}

double HolePost::bending_per_shear() const {
  const double s = (left + diameter).value(), radius = 0.5 * diameter.value();
  double most = 0.0;
  constexpr int parts = 200;
  for (int k = 1; k <= parts; ++k) {
    const double y = radius * k / parts;
    const double b = s - 2.0 * std::sqrt(radius * radius - y * y);
    most = std::max(most, 6.0 * pitch.value() * y / (b * b));
  }
  return most;
}

std::vector<HolePost> posts_beside(const Project& project, const BeamHole& at) {
  std::vector<HolePost> posts;
  for (const BeamHole& other : project.holes) {
    const Length s = abs(other.s - at.s), p = abs(other.hole.position - at.hole.position);
    if (other.hole.walls != at.hole.walls || !(s > Length{})) continue;
    const Length d = 0.5 * (at.hole.diameter + other.hole.diameter);
    const Length net = s - d + p * p / (4.0 * s);
    if (net >= s) continue;
    // Holes may touch.
    constexpr double least = 1e-3;
    const Length clear = std::max(Length(least * d), Length(sqrt(s * s + p * p) - d));
    posts.push_back({&other, s, std::max(net, clear), d, p < d});
  }
  return posts;
}

}  // namespace boxbeam
