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

std::vector<CutForceLine> envelope_lines(const std::deque<SituationRun>& runs) {
  const std::vector<Station> stations = drawn_stations(runs.front().loads.diagram(0));
  std::vector<CutForceLine> lines{{Time{}, "smallest", stations, {}},
                                  {Time{}, "largest", stations, {}}};
  for (const Station& station : stations) {
    CutForces low = runs.front().loads.diagram(0).at(station);
    CutForces high = low;
    for (const SituationRun& run : runs) {
      for (std::size_t i = 0; i < run.loads.instants(); ++i) {
        const CutForces cut = run.loads.diagram(i).at(station);
        low = {std::min(low.N, cut.N), std::min(low.V_y, cut.V_y), std::min(low.V_z, cut.V_z),
               std::min(low.T, cut.T), std::min(low.M_y, cut.M_y), std::min(low.M_z, cut.M_z)};
        high = {std::max(high.N, cut.N), std::max(high.V_y, cut.V_y), std::max(high.V_z, cut.V_z),
                std::max(high.T, cut.T), std::max(high.M_y, cut.M_y), std::max(high.M_z, cut.M_z)};
      }
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

PostureFigure posture_figure(const Project& project, const planar::Mechanism& mechanism,
                             const planar::State& state, const std::string& why) {
  const auto place = [&](const planar::Attachment& at) { return planar::position_of(at, state.q); };
  PostureFigure figure;
  figure.time = si<Time>(state.time);
  figure.why = why;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const int body = static_cast<int>(i);
    PostureFigure::Line line;
    for (const BodyPoint& point : mechanism.bodies[i].points) {
      line.points.push_back(place({body, point.p}));
    }
    if (body == project.beam_body) {
      const double centre = mass_properties_of(project.beam).centre.value();
      const double length = project.beam.length().value();
      line.strokes.push_back(
          {place({body, {-centre, 0.0}}), place({body, {length - centre, 0.0}})});
      for (const BodyPoint& point : mechanism.bodies[i].points) {
        if (std::abs(point.p.y()) < 1e-9 * length) continue;
        line.strokes.push_back({place({body, {point.p.x(), 0.0}}), place({body, point.p})});
      }
    }
    figure.bodies.push_back(std::move(line));
  }
  for (const planar::Joint& joint : mechanism.joints) {
    const auto [a, b] = planar::ends_of(joint);
    const auto* driven = std::get_if<planar::Driven>(&joint.kind);
    const bool between = std::holds_alternative<planar::Distance>(joint.kind) ||
                         (driven != nullptr && driven->coordinate == planar::Coordinate::length);
    if (between) figure.rods.push_back({place(a), place(b)});
    if (between || std::holds_alternative<planar::Pin>(joint.kind)) {
      for (const planar::Attachment& end : {a, b}) {
        if (end.body == planar::ground) figure.grounds.push_back(end.p);
      }
    }
    const auto add_guide = [&](const auto& slide) {
      const double direction =
          slide.direction +
          (slide.guide.body == planar::ground ? 0.0 : state.q[3 * slide.guide.body + 2]);
      figure.guides.push_back(
          {place(slide.point), Eigen::Vector2d(std::cos(direction), std::sin(direction))});
    };
    if (const auto* slider = std::get_if<planar::Slider>(&joint.kind)) add_guide(*slider);
    if (const auto* slot = std::get_if<planar::PinInSlot>(&joint.kind)) add_guide(*slot);
  }
  return figure;
}

void place_loads(const Project& project, const planar::State& state,
                 std::vector<BeamLoadRow>& rows) {
  const double centre = mass_properties_of(project.beam).centre.value();
  for (BeamLoadRow& row : rows) {
    if (project.beam_body != planar::ground) {
      row.place = planar::position_of({project.beam_body, {row.s.value() - centre, 0.0}}, state.q);
      continue;
    }
    for (std::size_t i = 0; i < planar_of(project).bodies.size(); ++i) {
      for (const BodyPoint& point : planar_of(project).bodies[i].points) {
        if (point.name != row.name) continue;
        row.place = planar::position_of({static_cast<int>(i), point.p}, state.q);
      }
    }
  }
}

SnFigure sn_figure(const Project& project, const CheckResult& governing) {
  const FatigueInput& fatigue = project.fatigue;
  SnFigure figure;
  const SnCurve curve =
      governing.basis ? governing.basis->curves.front() : curve_of(fatigue.beam.detail);
  figure.name = curve.name;
  figure.code = curve.code;
  figure.reference = curve.reference.value();
  figure.published_step = fatigue.published_step;
  for (int i = 0; i <= 120; ++i) {
    const double cycles = std::pow(10.0, 4.0 + 5.0 * i / 120.0);
    figure.cycles.push_back(cycles);
    figure.spectrum.push_back(strength_at(curve, cycles, Loading::spectrum).value());
    figure.constant_amplitude.push_back(
        strength_at(curve, cycles, Loading::constant_amplitude).value());
  }
  figure.knee = knee_of(curve).value();
  figure.cut_off = cut_off_of(curve).value();
  const double gammas = fatigue.demand.gamma_Ff * fatigue.demand.gamma_Mf;
  if (governing.basis) {
    for (const SpectrumRow& row : governing.basis->spectrum) {
      figure.working.emplace_back(row.cycle.count, row.cycle.range.value() * gammas);
    }
  } else {
    figure.working.emplace_back(most_cycles_of(project), governing.check.acting.value() * gammas);
  }
  figure.required = fatigue.required;
  return figure;
}

}  // namespace boxbeam
