#include "boxbeam/beam/tapered_beam.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "boxbeam/section/section_properties.hpp"

namespace boxbeam {
namespace {

/// A place in a segment as seen from the nearer end, so that near a thin end no digits are lost.
struct FromEnd {
  const Section *near, *far;
  double fraction = 0.0;  ///< of the segment, 0 to 1/2
  bool reversed = false;  ///< seen from its end

  Section at(double place) const { return interpolate(*near, *far, place); }
};

FromEnd from_nearer_end(const Segment& segment, Length s) {
  // The sum of a start and a length misses the end by round-off, which of a short piece is much.
  const double before = std::max<double>(0.0, (s - segment.start) / segment.length);
  const double behind = std::max<double>(0.0, (segment.end() - s) / segment.length);
  if (before <= behind) return {&segment.from, &segment.to, std::min(before, 0.5), false};
  return {&segment.to, &segment.from, std::min(behind, 0.5), true};
}

/// The width or the height at a fraction, by how much it changes over the segment: the smaller.
double size_over_change(const Section& from, const Section& to, double fraction) {
  const Extent a = extent_of(from.outer), b = extent_of(to.outer);
  const auto ratio = [fraction](Length one, Length other) {
    const double change = std::abs((other - one).value());
    const double size = (one + (other - one) * fraction).value();
    return change > 0.0 ? size / change : std::numeric_limits<double>::infinity();
  };
  return std::min(ratio(a.y_high - a.y_low, b.y_high - b.y_low),
                  ratio(a.z_high - a.z_low, b.z_high - b.z_low));
}

}  // namespace

const char* to_text(Side side) {
  switch (side) {
    case Side::before: return "-";
    case Side::behind: return "+";
    case Side::both: return "0";
  }
  return "0";
}

std::size_t segment_at(const TaperedBeam& beam, const Station& station) {
  assert(!beam.segments.empty());
  const bool before = station.side == Side::before;
  // A place that is written as the sum of lengths is at the border, whatever their rounding.
  const Length near = 8.0 * std::numeric_limits<double>::epsilon() * beam.length();
  const auto found = std::partition_point(
      beam.segments.begin(), beam.segments.end() - 1, [&](const Segment& segment) {
        return before ? segment.end() < station.s - near : segment.end() <= station.s + near;
      });
  return static_cast<std::size_t>(found - beam.segments.begin());
}

bool kinks_behind(const TaperedBeam& beam, std::size_t segment) {
  const Segment& one = beam.segments[segment];
  const Segment& other = beam.segments[segment + 1];
  if (!(one.to == other.from)) return true;
  // Slopes are ratios of lengths; this far apart they are round-off.
  constexpr double same = 1e-9;
  const auto slopes_of = [](const Segment& of) {
    const std::vector<Length> from = dimensions_of(of.from), to = dimensions_of(of.to);
    std::vector<double> slopes;
    for (std::size_t i = 0; i < from.size(); ++i) slopes.push_back((to[i] - from[i]) / of.length);
    return slopes;
  };
  const std::vector<double> before = slopes_of(one), behind = slopes_of(other);
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (std::abs(before[i] - behind[i]) > same) return true;
  }
  return false;
}

Section section_at(const TaperedBeam& beam, const Station& station) {
  const FromEnd here = from_nearer_end(beam.segments[segment_at(beam, station)], station.s);
  return here.at(here.fraction);
}

Taper taper_at(const TaperedBeam& beam, const Station& station) {
  const Segment& segment = beam.segments[segment_at(beam, station)];
  if (segment.from == segment.to) return {};
  const FromEnd end = from_nearer_end(segment, station.s);
  // Steps that change no size by more than 1e-5 of itself: 1e-10 of error, as small as round-off.
  const double step = 1e-5 * std::min(1.0, size_over_change(*end.near, *end.far, end.fraction));
  const double per_step = (end.reversed ? -1.0 : 1.0) / (step * segment.length.value());
  const auto near = [&](double steps, double weight) {
    return NearbySection{end.at(end.fraction + steps * step), weight * per_step};
  };
  if (end.fraction < step) return {near(0.0, -1.5), near(1.0, 2.0), near(2.0, -0.5)};
  return {near(-1.0, -0.5), near(1.0, 0.5)};
}

std::vector<Length> places_of(const TaperedBeam& beam) {
  std::vector<Length> places{Length{}};
  for (const Segment& segment : beam.segments) places.push_back(segment.end());
  places.insert(places.end(), beam.marks.begin(), beam.marks.end());
  for (const BeamPoint& point : beam.points) places.push_back(point.s);
  for (const Diaphragm& diaphragm : beam.diaphragms) places.push_back(diaphragm.s);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

Length place_near(const std::vector<Length>& places, Length s) {
  const auto nearest =
      std::min_element(places.begin(), places.end(),
                       [s](const Length& a, const Length& b) { return abs(a - s) < abs(b - s); });
  return abs(*nearest - s) < 1e-9 * places.back() ? *nearest : s;
}

std::vector<SegmentMass> mass_distribution_of(const TaperedBeam& beam) {
  std::vector<SegmentMass> distribution;
  const double density = beam.density.value();
  for (const Segment& segment : beam.segments) {
    const double length = segment.length.value();
    const auto at = [&](double x) {
      return properties_of(interpolate(segment.from, segment.to, x / length));
    };
    SegmentMass piece;
    piece.mass = interpolate<2>([&](double x) { return density * at(x).area.value(); }, length);
    if (beam.rotary_inertia) {
      const auto of = [&](SecondMoment SectionProperties::*moment) {
        return interpolate<4>([&](double x) { return density * (at(x).*moment).value(); }, length);
      };
      piece.rotary_y = of(&SectionProperties::I_y);
      piece.rotary_z = of(&SectionProperties::I_z);
      piece.rotary_yz = of(&SectionProperties::I_yz);
    }
    distribution.push_back(piece);
  }
  return distribution;
}

MassProperties mass_properties_of(const TaperedBeam& beam) {
  return mass_properties_of(beam, Length{}, beam.length());
}

MassProperties mass_properties_of(const TaperedBeam& beam, Length from, Length to) {
  const std::vector<SegmentMass> distribution = mass_distribution_of(beam);
  double mass = 0.0;
  double first_moment = 0.0;
  double second_moment = 0.0;
  double y = 0.0, z = 0.0, yz = 0.0;  // of the sections themselves
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    const Segment& segment = beam.segments[i];
    const double low = (std::max(from, segment.start) - segment.start).value();
    const double high = (std::min(to, segment.end()) - segment.start).value();
    if (high <= low) continue;
    const Polynomial<1> arm{{(segment.start - from).value(), 1.0}};
    const auto over = [&](const auto& p) {
      const auto integral = integral_of(p);
      return integral(high) - integral(low);
    };
    const SegmentMass& piece = distribution[i];
    mass += over(piece.mass);
    first_moment += over(piece.mass * arm);
    second_moment += over(piece.mass * (arm * arm));
    y += over(piece.rotary_y);
    z += over(piece.rotary_z);
    yz += over(piece.rotary_yz);
  }
  assert(mass > 0.0);
  const double centre = first_moment / mass;
  const double along = second_moment - mass * centre * centre;
  Eigen::Matrix3d tensor = Eigen::Vector3d(y + z, along + y, along + z).asDiagonal();
  tensor(1, 2) = tensor(2, 1) = -yz;
  return {si<Mass>(mass), from + si<Length>(centre), si<MassMoment>(along + y), tensor};
}

}  // namespace boxbeam
