#include <cmath>

#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/verification/animation.hpp"
#include "planar_pictures.hpp"

namespace boxbeam {
namespace {

Eigen::Vector3d lifted(const Eigen::Vector2d& p) { return {p.x(), p.y(), 0.0}; }

/// The beam's axes in the world, where it moves in the plane.
Eigen::Matrix3d beam_axes(const Project& project, const planar::State& state) {
  const int body =
      project.beam_body != planar::ground ? project.beam_body : project.chain->axis_body;
  const double angle = state.q[3 * body + 2];
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Eigen::Matrix3d R_WS;
  R_WS << c, 0.0, -s,  //
      s, 0.0, c,       //
      0.0, -1.0, 0.0;
  return R_WS;
}

/// On the beam's axis, or where the beam is no body at the body point of the load's name.
Eigen::Vector3d place_of(const Project& project, const planar::State& state,
                         const BeamLoadRow& row) {
  if (project.beam_body != planar::ground) {
    const double centre = mass_properties_of(project.beam).centre.value();
    return lifted(planar::position_of({project.beam_body, {row.s.value() - centre, 0.0}}, state.q));
  }
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < planar_of(project).bodies.size(); ++i) {
    for (const BodyPoint& point : planar_of(project).bodies[i].points) {
      if (point.name != row.name) continue;
      place = lifted(planar::position_of({static_cast<int>(i), point.p}, state.q));
    }
  }
  return place;
}

}  // namespace

std::vector<BeamLoadRow> load_rows(const Project& project, const BeamLoads& loads,
                                   const planar::State& state) {
  std::vector<BeamLoadRow> rows = load_rows(loads, si<Time>(state.time), beam_axes(project, state));
  for (BeamLoadRow& row : rows) {
    for (const BeamPoint& point : project.beam.points) {
      if (row.name.empty() && point.s == row.s) row.name = point.name;
    }
    row.place = place_of(project, state, row);
  }
  return rows;
}

PostureFigure posture_figure(const Project& project, const planar::Mechanism& mechanism,
                             const planar::State& state, const BeamLoads& loads,
                             const std::string& why) {
  const auto place = [&](const planar::Attachment& at) {
    return lifted(planar::position_of(at, state.q));
  };
  PostureFigure figure;
  figure.time = si<Time>(state.time);
  figure.why = why;
  figure.loads = load_rows(project, loads, state);
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const int body = static_cast<int>(i);
    PostureFigure::Line line;
    for (const BodyPoint& point : mechanism.bodies[i].points) {
      line.points.push_back(place({body, point.p}));
    }
    line.beam = body == project.beam_body;
    if (line.beam) {
      for (const PostureFigure::Stroke& stroke : drawn_body_of(project, mechanism, body).strokes) {
        line.strokes.push_back(
            {place({body, stroke.from.head<2>()}), place({body, stroke.to.head<2>()})});
      }
    }
    figure.bodies.push_back(std::move(line));
  }
  for (const planar::Joint& joint : mechanism.joints) {
    const auto [a, b] = planar::ends_of(joint);
    const bool between = planar::is_rod(joint);
    if (between) figure.rods.push_back({place(a), place(b)});
    const bool hinged =
        planar::holds_of(joint) == std::pair(planar::Hold::place, planar::Hold::place);
    if (between || (hinged && !planar::is_driver(joint))) {
      for (const planar::Attachment& end : {a, b}) {
        if (end.body == planar::ground) figure.grounds.push_back(lifted(end.p));
      }
    }
    const auto add_guide = [&](const auto& slide) {
      if constexpr (requires { slide.guide; }) {
        const double direction =
            slide.direction +
            (slide.guide.body == planar::ground ? 0.0 : state.q[3 * slide.guide.body + 2]);
        figure.guides.push_back(
            {place(slide.point), Eigen::Vector3d(std::cos(direction), std::sin(direction), 0.0)});
      }
    };
    std::visit(add_guide, joint.kind);
  }
  for (const planar::AppliedForce& force : mechanism.forces) {
    const auto* const pin = std::get_if<planar::PinWithClearance>(&force.kind);
    if (pin == nullptr) continue;
    for (const planar::Attachment& end : {pin->a, pin->b})
      if (end.body == planar::ground) figure.grounds.push_back(lifted(end.p));
  }
  return figure;
}

}  // namespace boxbeam
