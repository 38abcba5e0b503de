#include "boxbeam/mechanism/recorded/channel_loads.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>

namespace boxbeam::recorded {
namespace {

template <int Degree>
void add(double factor, const Polynomial<Degree>& of, Polynomial<Degree>& sum) {
  for (std::size_t i = 0; i < of.size; ++i) sum.c[i] += factor * of.c[i];
}

/// The loads between two stations within a segment, where cut forces go from `a` to `b`.
LineLoad line_between(double from, double to, const SixForces& a, const SixForces& b) {
  const double h = to - from;
  const auto slope = [&](std::size_t k) { return (b[k] - a[k]) / h; };
  enum { N, V_y, V_z, T, M_y, M_z };
  LineLoad line{si<Length>(from), si<Length>(h), {}, {}};
  for (const std::size_t k : {N, V_y, V_z}) line.force[k].c[0] = -slope(k);
  line.couple[0].c[0] = -slope(T);
  line.couple[1].c[0] = a[V_z] - slope(M_y);
  line.couple[1].c[1] = slope(V_z);
  line.couple[2].c[0] = -a[V_y] - slope(M_z);
  line.couple[2].c[1] = -slope(V_y);
  return line;
}

SixForces between(const SixForces& a, const SixForces& b, double part) {
  SixForces of{};
  for (std::size_t k = 0; k < of.size(); ++k) of[k] = a[k] + part * (b[k] - a[k]);
  return of;
}

}  // namespace

void add(double factor, const BeamLoads& loads, BeamLoads& sum) {
  assert(loads.points.size() == sum.points.size() && loads.lines.size() == sum.lines.size());
  for (std::size_t i = 0; i < sum.points.size(); ++i) {
    sum.points[i].force += factor * loads.points[i].force;
    sum.points[i].moment += factor * loads.points[i].moment;
  }
  for (std::size_t i = 0; i < sum.lines.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      add(factor, loads.lines[i].force[k], sum.lines[i].force[k]);
      add(factor, loads.lines[i].couple[k], sum.lines[i].couple[k]);
    }
  }
}

void add(double factor, const CutForceDiagram& diagram, CutForceDiagram& sum) {
  assert(diagram.pieces.size() == sum.pieces.size());
  for (std::size_t i = 0; i < sum.pieces.size(); ++i) {
    const CutForcePiece& of = diagram.pieces[i];
    CutForcePiece& to = sum.pieces[i];
    add(factor, of.N, to.N);
    add(factor, of.V_y, to.V_y);
    add(factor, of.V_z, to.V_z);
    add(factor, of.T, to.T);
    add(factor, of.M_y, to.M_y);
    add(factor, of.M_z, to.M_z);
  }
}

std::size_t instant_before(const Channels& channels, double time) {
  const std::vector<double>& times = channels.times;
  const auto behind = std::upper_bound(times.begin() + 1, times.end() - 1, time);
  return static_cast<std::size_t>(behind - times.begin()) - 1;
}

std::vector<double> values_at(const Channels& channels, double time) {
  const std::size_t i = instant_before(channels, time);
  const double from = channels.times[i], to = channels.times[i + 1];
  const double part = (time - from) / (to - from);
  std::vector<double> values;
  values.reserve(channels.values.size());
  for (const std::vector<double>& of : channels.values)
    values.push_back(of[i] + part * (of[i + 1] - of[i]));
  return values;
}

BeamLoads loads_at(const ChannelLoads& of, double time) {
  BeamLoads loads = of.constant;
  const std::vector<double> values = values_at(*of.channels, time);
  for (std::size_t k = 0; k < values.size(); ++k) add(values[k], of.units[k], loads);
  return loads;
}

BeamLoads loads_of_cuts(const TaperedBeam& beam, std::span<const double> stations,
                        std::span<const SixForces> values) {
  assert(stations.size() >= 2 && stations.size() == values.size());
  BeamLoads loads;
  const auto add_end = [&](double s, double sign, const SixForces& of) {
    PointLoad load{si<Length>(s), {of[0], of[1], of[2]}, {of[3], of[4], of[5]}, "cut forces"};
    load.force *= sign;
    load.moment *= sign;
    loads.points.push_back(load);
  };
  add_end(0.0, -1.0, values.front());
  add_end(beam.length().value(), 1.0, values.back());
  std::size_t next = 1;
  for (const Segment& segment : beam.segments) {
    double from = segment.start.value();
    const double end = segment.end().value();
    while (from < end) {
      while (next + 1 < stations.size() && stations[next] <= from) ++next;
      const bool within = next + 1 < stations.size() && stations[next] < end;
      const double to = within ? stations[next] : end;
      const double a = stations[next - 1], h = stations[next] - a;
      loads.lines.push_back(line_between(from, to,
                                         between(values[next - 1], values[next], (from - a) / h),
                                         between(values[next - 1], values[next], (to - a) / h)));
      from = to;
    }
  }
  return loads;
}

PointLoad balance_at(Length s, const BeamLoads& loads) {
  const Imbalance open = imbalance_of(loads);
  const Eigen::Vector3d arm(s.value(), 0.0, 0.0);
  return {s, -open.force, -open.moment + arm.cross(open.force), {}};
}

}  // namespace boxbeam::recorded
