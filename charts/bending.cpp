#include "charts/bending.hpp"

#include <algorithm>
#include <cmath>

#include "charts/quadrature.hpp"

namespace boxbeam::charts {
namespace {

/// A polynomial at a place, in long double.
template <int Degree>
long double at(const Polynomial<Degree>& p, long double x) {
  long double sum = 0.0L;
  for (std::size_t i = p.size; i-- > 0;) sum = sum * x + static_cast<long double>(p.c[i]);
  return sum;
}

}  // namespace

std::deque<SituationRun> bending_runs_of(const Project& project) {
  ElasticModel model;
  if (std::holds_alternative<flexible::Mechanism>(project.mechanism))
    model.level = ModelLevel::flexible;
  return run_situations(project, model);
}

std::optional<DemandingInstant> demanding_instant_of(const std::deque<SituationRun>& runs) {
  DemandingInstant found;
  constexpr int looks = 8;  // in each piece
  for (const SituationRun& run : runs) {
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      for (const CutForcePiece& piece : run.loads.diagram(i).pieces) {
        for (int j = 0; j <= looks; ++j) {
          const double x = piece.length.value() * j / looks;
          for (const cut_force::Index moment : {cut_force::M_y, cut_force::M_z}) {
            const double M = moment == cut_force::M_y ? piece.M_y(x) : piece.M_z(x);
            if (std::abs(M) <= std::abs(found.M)) continue;
            const Side side = j == 0 ? Side::behind : j == looks ? Side::before : Side::both;
            const Length s = j == looks ? piece.end() : piece.start + si<Length>(x);
            found = {&run, moment, run.loads.time_of(i), {s, side}, M};
          }
        }
      }
    }
  }
  if (found.run == nullptr) return std::nullopt;
  return found;
}

Bending bending_of(const BeamLoads& loads, cut_force::Index moment) {
  const bool about_y = moment == cut_force::M_y;
  const std::size_t across = about_y ? 2 : 1;
  const std::size_t about = about_y ? 1 : 2;
  const double sign = about_y ? 1.0 : -1.0;  // of V against V_y
  std::vector<PointLoad> points = loads.points;
  std::stable_sort(points.begin(), points.end(),
                   [](const PointLoad& a, const PointLoad& b) { return a.s < b.s; });
  Bending bending;
  std::size_t next = 0;
  for (const LineLoad& line : loads.lines) {
    Bending::Piece piece;
    piece.origin = piece.start = line.start.value();
    piece.q = sign * line.force[across];
    piece.m = line.couple[about];
    const double end = (line.start + line.length).value();
    for (;;) {
      piece.P = piece.C = 0.0;
      for (; next < points.size() && points[next].s.value() <= piece.start; ++next) {
        piece.P += sign * points[next].force[static_cast<Eigen::Index>(across)];
        piece.C += points[next].moment[static_cast<Eigen::Index>(about)];
      }
      const bool inside = next < points.size() && points[next].s.value() < end;
      const double to = inside ? points[next].s.value() : end;
      piece.length = to - piece.start;
      bending.pieces.push_back(piece);
      if (!inside) break;
      piece.start = to;
    }
  }
  return bending;
}

long double moment_before(const Bending& bending, double s) {
  static const GaussRule<long double> gauss = gauss_rule<long double>(8);
  const long double S = s;
  long double M = 0.0L;
  for (const Bending::Piece& piece : bending.pieces) {
    const long double start = piece.start;
    if (start >= S) break;
    M -= static_cast<long double>(piece.C) + static_cast<long double>(piece.P) * (S - start);
    const long double origin = piece.origin;
    const long double length = std::min(start + static_cast<long double>(piece.length), S) - start;
    for (std::size_t k = 0; k < gauss.x.size(); ++k) {
      const long double x = start + length * gauss.x[k];
      M -= length * gauss.w[k] * ((S - x) * at(piece.q, x - origin) + at(piece.m, x - origin));
    }
  }
  return M;
}

}  // namespace boxbeam::charts
