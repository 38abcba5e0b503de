#include "boxbeam/verification/posture.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"

namespace boxbeam {
namespace {

Eigen::Vector3d lifted(const Eigen::Vector2d& p) { return {p.x(), p.y(), 0.0}; }

/// The beam's axes in the world, where it moves in the plane.
Eigen::Matrix3d planar_beam_axes(const Project& project, const planar::State& state) {
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

/// The rows without names and places.
std::vector<BeamLoadRow> bare_rows(const BeamLoads& loads, double time,
                                   const Eigen::Matrix3d& R_WS) {
  std::vector<BeamLoadRow> rows;
  for (const PointLoad& load : loads.points) {
    BeamLoadRow row;
    row.time = si<Time>(time);
    row.s = load.s;
    row.force = load.force;
    row.moment = load.moment;
    row.world = R_WS * load.force;
    row.couple = R_WS * load.moment;
    rows.push_back(row);
  }
  return rows;
}

/// On the beam's axis, or where the beam is no body at the body point of the load's name.
Eigen::Vector3d planar_place_of(const Project& project, const planar::State& state,
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

/// Where a joint is on the body that carries it, world [m].
Eigen::Vector3d place_of(const spatial::Joint& joint, const spatial::State& state) {
  return spatial::position_of(state, {joint.parent, joint.at});
}

/// The origin of a posture in space.
Eigen::Vector3d origin_of(const Project& project, const spatial::Mechanism& mechanism,
                          const spatial::State& state) {
  return place_of(mechanism.joints[static_cast<std::size_t>(placement_in(project, mechanism).body)],
                  state);
}

}  // namespace

std::vector<BeamLoadRow> load_rows(const Project& project, const planar::Mechanism& mechanism,
                                   const BeamLoads& loads, const planar::State& state) {
  std::vector<BeamLoadRow> rows = bare_rows(loads, state.time, planar_beam_axes(project, state));
  // The Newton chain's loads have no names of their own.
  std::vector<std::string> names;
  if (project.beam_body != planar::ground) {
    names = planar::names_of_beam_loads(mechanism, state, project.beam_body);
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    BeamLoadRow& row = rows[i];
    for (const BeamPoint& point : project.beam.points) {
      if (point.s == row.s) row.name = point.name;
    }
    if (names.size() == rows.size()) row.name = names[i];
    row.place = planar_place_of(project, state, row);
  }
  return rows;
}

std::vector<BeamLoadRow> load_rows(const Project& project, const spatial::Mechanism& mechanism,
                                   const BeamLoads& loads, const spatial::State& state) {
  const spatial::BeamPlacement beam = placement_in(project, mechanism);
  const Eigen::Matrix3d& R_WB = state.bodies[static_cast<std::size_t>(beam.body)].R_WB;
  std::vector<BeamLoadRow> rows = bare_rows(loads, state.time, R_WB * beam.axes);
  const std::vector<std::string> names = spatial::names_of_beam_loads(mechanism, beam.body);
  const Eigen::Vector3d origin = origin_of(project, mechanism, state);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].name = names[i];
    const Eigen::Vector3d on_axis = beam.start + rows[i].s.value() * beam.axes.col(0);
    rows[i].place = spatial::position_of(state, {beam.body, on_axis}) - origin;
  }
  return rows;
}

PostureFigure posture_figure(const Project& project, const planar::Mechanism& mechanism,
                             const planar::State& state, const std::string& why) {
  const auto place = [&](const planar::Attachment& at) {
    return lifted(planar::position_of(at, state.q));
  };
  PostureFigure figure;
  figure.time = si<Time>(state.time);
  figure.why = why;
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const int body = static_cast<int>(i);
    PostureFigure::Line line;
    for (const BodyPoint& point : mechanism.bodies[i].points) {
      line.points.push_back(place({body, point.p}));
    }
    line.beam = body == project.beam_body;
    if (line.beam) {
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
        if (end.body == planar::ground) figure.grounds.push_back(lifted(end.p));
      }
    }
    const auto add_guide = [&](const auto& slide) {
      const double direction =
          slide.direction +
          (slide.guide.body == planar::ground ? 0.0 : state.q[3 * slide.guide.body + 2]);
      figure.guides.push_back(
          {place(slide.point), Eigen::Vector3d(std::cos(direction), std::sin(direction), 0.0)});
    };
    if (const auto* slider = std::get_if<planar::Slider>(&joint.kind)) add_guide(*slider);
    if (const auto* slot = std::get_if<planar::PinInSlot>(&joint.kind)) add_guide(*slot);
  }
  return figure;
}

PostureFigure posture_figure(const Project& project, const spatial::Mechanism& mechanism,
                             const spatial::State& state, const std::string& why) {
  const Eigen::Vector3d origin = origin_of(project, mechanism, state);
  const spatial::BeamPlacement placement = placement_in(project, mechanism);
  const int beam = placement.body;
  const spatial::Joint& root = mechanism.joints[static_cast<std::size_t>(beam)];
  PostureFigure figure;
  figure.time = si<Time>(state.time);
  figure.why = why;
  figure.grounds.push_back(Eigen::Vector3d::Zero());

  std::vector<bool> shown(mechanism.bodies.size(), false);
  for (std::size_t i = 0; i < mechanism.bodies.size(); ++i) {
    const spatial::Joint& joint = mechanism.joints[i];
    shown[i] = joint.parent == root.parent ||
               (joint.parent != spatial::ground && shown[static_cast<std::size_t>(joint.parent)]);
    if (!shown[i]) continue;
    const int body = static_cast<int>(i);
    const auto place = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return spatial::position_of(state, {body, p}) - origin;
    };
    PostureFigure::Line line;
    line.beam = body == beam;
    const auto add_point = [&](const Eigen::Vector3d& p) {
      const bool known = std::any_of(line.points.begin(), line.points.end(), [&](const auto& of) {
        return (of - place(p)).norm() < 1e-9 * project.beam.length().value();
      });
      if (!known) line.points.push_back(place(p));
    };
    add_point(joint.point);
    for (const spatial::BodyPoint& point : mechanism.bodies[i].points) add_point(point.p);
    for (const spatial::Joint& carried : mechanism.joints) {
      if (carried.parent == body) add_point(carried.at);
    }
    if (line.beam) {
      const auto on_axis = [&](double s) {
        return place(placement.start + s * placement.axes.col(0));
      };
      const double length = project.beam.length().value();
      const Eigen::Vector3d axis = (on_axis(length) - on_axis(0.0)) / length;
      line.strokes.push_back({on_axis(0.0), on_axis(length)});
      for (const Eigen::Vector3d& point : line.points) {
        const double s = std::clamp(axis.dot(point - on_axis(0.0)), 0.0, length);
        if ((point - on_axis(s)).norm() < 1e-9 * length) continue;
        line.strokes.push_back({on_axis(s), point});
      }
    } else {
      for (std::size_t k = 1; k < line.points.size(); ++k) {
        line.strokes.push_back({line.points.front(), line.points[k]});
      }
    }
    if (joint.kind != spatial::JointKind::fixed) {
      figure.guides.push_back(
          {place_of(joint, state) - origin, spatial::in_world(state, joint.parent, joint.axis)});
    }
    figure.bodies.push_back(std::move(line));
  }
  return figure;
}

}  // namespace boxbeam
