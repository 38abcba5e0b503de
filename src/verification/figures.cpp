#include "boxbeam/verification/figures.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam {
namespace {

constexpr int points_per_piece = 24;

/// Stations along the beam for drawing, two at every border of the pieces.
std::vector<Station> drawn_stations(const CutForceDiagram& diagram) {
  std::vector<Station> stations{{diagram.pieces.front().start, Side::before}};
  for (const CutForcePiece& piece : diagram.pieces) {
    for (int j = 0; j <= points_per_piece; ++j) {
      const Side side = j == 0 ? Side::behind : (j == points_per_piece ? Side::before : Side::both);
      const Length s =
          j == points_per_piece
              ? piece.end()
              : piece.start + piece.length * (static_cast<double>(j) / points_per_piece);
      stations.push_back({s, side});
    }
  }
  stations.push_back({diagram.pieces.back().end(), Side::behind});
  return stations;
}

}  // namespace

CutForceLine cut_force_line(const LoadHistory& loads, Time time, const std::string& why) {
  const CutForceDiagram diagram = loads.diagram_at(time);
  CutForceLine line{time, why, drawn_stations(diagram), {}};
  for (const Station& station : line.stations) line.values.push_back(diagram.at(station));
  return line;
}

std::vector<CutForceLine> envelope_lines(const LoadHistory& loads) {
  const std::vector<Station> stations = drawn_stations(loads.diagram(0));
  std::vector<CutForceLine> lines{{Time{}, "smallest", stations, {}},
                                  {Time{}, "largest", stations, {}}};
  for (const Station& station : stations) {
    CutForces low = loads.diagram(0).at(station);
    CutForces high = low;
    for (std::size_t i = 1; i < loads.instants(); ++i) {
      const CutForces cut = loads.diagram(i).at(station);
      low = {std::min(low.N, cut.N),     low.V_y, std::min(low.V_z, cut.V_z), low.T,
             std::min(low.M_y, cut.M_y), low.M_z};
      high = {std::max(high.N, cut.N),     high.V_y, std::max(high.V_z, cut.V_z), high.T,
              std::max(high.M_y, cut.M_y), high.M_z};
    }
    lines[0].values.push_back(low);
    lines[1].values.push_back(high);
  }
  return lines;
}

std::vector<BeamLoadRow> load_rows(const Project& project, const BeamLoads& loads, Time time,
                                   double angle) {
  std::vector<BeamLoadRow> rows;
  for (const PointLoad& load : loads.points) {
    BeamLoadRow row;
    row.time = time;
    row.s = load.s;
    for (const BeamPoint& point : project.beam.points) {
      if (point.s == load.s) row.name = point.name;
    }
    row.force = load.force;
    row.couple = si<Moment>(load.moment.y());
    row.world = Eigen::Rotation2Dd(angle) * Eigen::Vector2d(load.force.x(), load.force.z());
    rows.push_back(row);
  }
  return rows;
}

PostureFigure posture_figure(const Project& project, const planar::State& state,
                             const std::string& why) {
  PostureFigure figure;
  figure.time = si<Time>(state.time);
  figure.why = why;
  for (std::size_t i = 0; i < project.mechanism.bodies.size(); ++i) {
    const Body& body = project.mechanism.bodies[i];
    PostureFigure::Line line{body.name, {}, {}};
    for (const BodyPoint& point : body.points) {
      line.points.push_back(planar::position_of({static_cast<int>(i), point.p}, state.q));
      line.names.push_back(point.name);
    }
    figure.bodies.push_back(std::move(line));
  }
  return figure;
}

SnFigure sn_figure(const Project& project, const CheckResult& governing) {
  const FatigueInput& fatigue = project.fatigue;
  SnFigure figure;
  figure.category = governing.basis ? governing.basis->point.category : fatigue.category;
  figure.kind = fatigue.curve;
  const SnCurve curve{si<Stress>(figure.category * 1e6), fatigue.curve};
  for (int i = 0; i <= 120; ++i) {
    const double cycles = std::pow(10.0, 4.0 + 5.0 * i / 120.0);
    figure.cycles.push_back(cycles);
    figure.spectrum.push_back(strength_at(curve, cycles, Loading::spectrum).value());
    figure.constant_amplitude.push_back(
        strength_at(curve, cycles, Loading::constant_amplitude).value());
  }
  figure.knee = knee_of(curve).value();
  figure.cut_off = cut_off_of(curve).value();
  figure.working_cycles = fatigue.demand.periods;
  figure.working_range =
      governing.check.acting.value() * fatigue.demand.gamma_Ff * fatigue.demand.gamma_Mf;
  figure.required = fatigue.required;
  return figure;
}

}  // namespace boxbeam
