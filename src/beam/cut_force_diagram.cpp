#include "boxbeam/beam/cut_force_diagram.hpp"

#include <algorithm>

namespace boxbeam {
namespace {

/// Running values of the integration, SI.
struct Running {
  double N = 0, V_y = 0, V_z = 0, T = 0, M_y = 0, M_z = 0;

  void jump(const PointLoad& load) {
    N -= load.force.x();
    V_y -= load.force.y();
    V_z -= load.force.z();
    T -= load.moment.x();
    M_y -= load.moment.y();
    M_z -= load.moment.z();
  }
};

CutForcePiece integrate(const LineLoad& line, double shift, Length start, Length length,
                        const Running& from) {
  const auto force = [&](std::size_t axis) { return -1.0 * shifted(line.force[axis], shift); };
  const auto couple = [&](std::size_t axis) { return -1.0 * shifted(line.couple[axis], shift); };
  CutForcePiece piece;
  piece.start = start;
  piece.length = length;
  piece.N = integral_of(force(0), from.N);
  piece.V_y = integral_of(force(1), from.V_y);
  piece.V_z = integral_of(force(2), from.V_z);
  piece.T = integral_of(couple(0), from.T);
  piece.M_y = integral_of(piece.V_z + couple(1), from.M_y);
  piece.M_z = integral_of(-1.0 * piece.V_y + couple(2), from.M_z);
  return piece;
}

}  // namespace

CutForceDiagram cut_forces_of(const BeamLoads& loads) {
  std::vector<const PointLoad*> points;
  points.reserve(loads.points.size());
  for (const PointLoad& load : loads.points) points.push_back(&load);
  std::stable_sort(points.begin(), points.end(),
                   [](const PointLoad* a, const PointLoad* b) { return a->s < b->s; });

  CutForceDiagram diagram;
  diagram.pieces.reserve(loads.lines.size() + points.size());
  Running running;
  std::size_t next = 0;
  for (const LineLoad& line : loads.lines) {
    const Length end = line.start + line.length;
    Length from = line.start;
    while (true) {
      for (; next < points.size() && points[next]->s <= from; ++next) running.jump(*points[next]);
      const bool inside = next < points.size() && points[next]->s < end;
      const Length to = inside ? points[next]->s : end;
      const CutForcePiece& piece = diagram.pieces.emplace_back(
          integrate(line, (from - line.start).value(), from, to - from, running));
      const double x = (to - from).value();
      running = {piece.N(x), piece.V_y(x), piece.V_z(x), piece.T(x), piece.M_y(x), piece.M_z(x)};
      if (!inside) break;
      from = to;
    }
  }
  return diagram;
}

CutForces CutForceDiagram::at(const Station& station) const {
  std::size_t piece = 0;
  return at(station, piece);
}

CutForces CutForceDiagram::at(const Station& station, std::size_t& known) const {
  const bool before = station.side == Side::before;
  if (pieces.empty() || station.s < pieces.front().start) return {};
  if (before && station.s == pieces.front().start) return {};
  // The sum of a start and a length misses the place that they come from by round-off.
  const Length end = pieces.back().end();
  constexpr double round_off = 1e-14;
  if (station.s > end * (1.0 + round_off)) return {};
  if (station.side == Side::behind && station.s >= end * (1.0 - round_off)) return {};
  const auto begins = [&](const CutForcePiece& piece) {
    return before ? piece.start < station.s : piece.start <= station.s;
  };
  const bool same = known < pieces.size() && (known == 0 || begins(pieces[known])) &&
                    (known + 1 == pieces.size() || !begins(pieces[known + 1]));
  if (!same) {
    const auto next = std::partition_point(pieces.begin() + 1, pieces.end(), begins);
    known = static_cast<std::size_t>(next - pieces.begin()) - 1;
  }
  const CutForcePiece& piece = pieces[known];
  const double x = (station.s - piece.start).value();
  return {si<Force>(piece.N(x)),  si<Force>(piece.V_y(x)),  si<Force>(piece.V_z(x)),
          si<Moment>(piece.T(x)), si<Moment>(piece.M_y(x)), si<Moment>(piece.M_z(x))};
}

}  // namespace boxbeam
