#include "boxbeam/mechanism/recorded/channel_loads.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "boxbeam/mechanism/recorded/derivatives.hpp"

namespace boxbeam::recorded {
namespace {

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

/// What acts where cut forces jump: those before are in `load`, less those behind.
void add_jump(PointLoad& load, const SixForces& behind) {
  load.force -= Eigen::Vector3d(behind[0], behind[1], behind[2]);
  load.moment -= Eigen::Vector3d(behind[3], behind[4], behind[5]);
}

}  // namespace

void add(CutForceDiagram& sum, double factor, const CutForceDiagram& diagram) {
  assert(diagram.pieces.size() == sum.pieces.size());
  for (std::size_t i = 0; i < sum.pieces.size(); ++i) {
    const CutForcePiece& of = diagram.pieces[i];
    CutForcePiece& to = sum.pieces[i];
    add(to.N, factor, of.N);
    add(to.V_y, factor, of.V_y);
    add(to.V_z, factor, of.V_z);
    add(to.T, factor, of.T);
    add(to.M_y, factor, of.M_y);
    add(to.M_z, factor, of.M_z);
  }
}

Channels at_instants(std::shared_ptr<const Record> record, std::vector<std::size_t> instants) {
  std::sort(instants.begin(), instants.end());
  instants.erase(std::unique(instants.begin(), instants.end()), instants.end());
  Channels channels;
  for (const std::size_t i : instants) channels.times.push_back(record->time_of(i));
  for (std::size_t k = 0; k < record->channels(); ++k) {
    std::vector<double>& values = channels.values.emplace_back();
    for (const std::size_t i : instants) values.push_back(record->value(k, i));
  }
  channels.record = std::move(record);
  return channels;
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
  for (std::size_t k = 0; k < values.size(); ++k) add(loads, values[k], of.units[k]);
  return loads;
}

BeamLoads loads_of_cuts(const TaperedBeam& beam, std::span<const double> stations,
                        std::span<const SixForces> values) {
  assert(stations.size() >= 2 && stations.size() == values.size());
  BeamLoads loads;
  const auto add_end = [&](double s, double sign, const SixForces& of) {
    PointLoad load{
        si<Length>(s), {of[0], of[1], of[2]}, {of[3], of[4], of[5]}, {0.0, 0.0}, "cut forces"};
    load.force *= sign;
    load.moment *= sign;
    loads.points.push_back(load);
  };
  add_end(0.0, -1.0, values.front());
  add_end(beam.length().value(), 1.0, values.back());
  for (std::size_t j = 1; j < stations.size(); ++j) {
    if (stations[j] != stations[j - 1]) continue;
    add_end(stations[j], 1.0, values[j - 1]);
    add_jump(loads.points.back(), values[j]);
  }
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

MotionChannels motion_of_path(const std::vector<double>& times, const std::vector<double>& x,
                              const std::vector<double>& z, const std::vector<double>& angle,
                              double gravity) {
  assert(times.size() >= 3);
  const std::vector<double> a_x = derivatives_of(times, x).second;
  const std::vector<double> a_z = derivatives_of(times, z).second;
  auto [turning, turned] = derivatives_of(times, angle);
  MotionChannels motion;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double c = std::cos(angle[i]), s = std::sin(angle[i]), up = a_z[i] + gravity;
    motion.acceleration[0].push_back(c * a_x[i] + s * up);
    motion.acceleration[2].push_back(c * up - s * a_x[i]);
    // The angle grows from x to z, which is about -y.
    motion.omega[1].push_back(-turning[i]);
    motion.alpha[1].push_back(-turned[i]);
  }
  return motion;
}

void add_inertia(const TaperedBeam& beam, const MotionChannels& motion, Channels& channels,
                 ChannelLoads& loads) {
  const std::vector<SegmentMass> masses = mass_distribution_of(beam);
  const auto lines_of = [&](const BeamMotion& of) {
    return weight_and_inertia(beam, masses, Eigen::Vector3d::Zero(), of);
  };
  const auto add_channel = [&](std::vector<double> values, std::vector<LineLoad> lines) {
    BeamLoads& unit = loads.units.emplace_back(loads.constant);
    for (PointLoad& point : unit.points) point.force = point.moment = Eigen::Vector3d::Zero();
    unit.lines = std::move(lines);
    channels.values.push_back(std::move(values));
  };
  const auto axis = [](std::size_t k) { return Eigen::Vector3d::Unit(static_cast<int>(k)); };
  for (std::size_t k = 0; k < 3; ++k) {
    if (!motion.acceleration[k].empty())
      add_channel(motion.acceleration[k], lines_of({.acceleration = axis(k)}));
    if (!motion.alpha[k].empty()) add_channel(motion.alpha[k], lines_of({.alpha = axis(k)}));
  }
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = j; k < 3; ++k) {
      if (motion.omega[j].empty() || motion.omega[k].empty()) continue;
      std::vector<double> product;
      for (std::size_t i = 0; i < channels.times.size(); ++i)
        product.push_back(motion.omega[j][i] * motion.omega[k][i]);
      BeamLoads of{{}, lines_of({.omega = axis(j)})};
      if (j != k) {  // what both do together beyond what each does
        of.lines = lines_of({.omega = axis(j) + axis(k)});
        add(of.lines, -1.0, lines_of({.omega = axis(j)}));
        add(of.lines, -1.0, lines_of({.omega = axis(k)}));
      }
      add_channel(std::move(product), std::move(of.lines));
    }
  }
}

PointLoad balance_at(Length s, const BeamLoads& loads) {
  const Imbalance open = imbalance_of(loads);
  const Eigen::Vector3d arm(s.value(), 0.0, 0.0);
  return {s, -open.force, -open.moment + arm.cross(open.force), {0.0, 0.0}, {}};
}

}  // namespace boxbeam::recorded
