#include "boxbeam/verification/elastic_posture.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/flexible/beam_loads.hpp"

namespace boxbeam {
namespace {

using flexible::Attachment;

/// Where a place of the mechanism is drawn.
Eigen::Vector3d drawn_place(const DeformedPosture& posture, const Attachment& at) {
  const flexible::Structure& structure = *posture.structure;
  const Eigen::Vector2d place =
      flexible::in_world(*structure.mechanism, at) +
      posture.magnified * flexible::motion_at(structure, at, posture.deformation).head<2>();
  return {place.x(), place.y(), 0.0};
}

/// The places of a link that joints and loads take hold of, each once.
std::vector<Eigen::Vector2d> places_on(const flexible::Mechanism& mechanism, int link) {
  std::vector<Eigen::Vector2d> places;
  const auto add = [&](const Attachment& at) {
    if (at.link != link) return;
    const bool known = std::any_of(places.begin(), places.end(),
                                   [&](const auto& other) { return (other - at.p).norm() < 1e-9; });
    if (!known) places.push_back(at.p);
  };
  for (const flexible::Joint& joint : mechanism.joints) {
    add(joint.a);
    add(joint.b);
  }
  for (const flexible::Load& load : mechanism.loads) add(load.at);
  return places;
}

/// A body without axis: its places in turn about their middle.
void draw_body(const DeformedPosture& posture, int link, PostureFigure::Line& line) {
  std::vector<Eigen::Vector2d> places = places_on(*posture.structure->mechanism, link);
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const auto& p : places) middle += p / static_cast<double>(places.size());
  std::sort(places.begin(), places.end(), [&](const auto& p, const auto& q) {
    return std::atan2(p.y() - middle.y(), p.x() - middle.x()) <
           std::atan2(q.y() - middle.y(), q.x() - middle.x());
  });
  for (const auto& p : places) line.points.push_back(drawn_place(posture, {link, p}));
  for (std::size_t i = 0; i < line.points.size() && line.points.size() > 1; ++i) {
    line.strokes.push_back({line.points[i], line.points[(i + 1) % line.points.size()]});
  }
}

/// The bent axis from node to node, with spurs to what stands off it.
void draw_axis(const DeformedPosture& posture, int link, PostureFigure::Line& line) {
  const auto index = static_cast<std::size_t>(link);
  const flexible::Mechanism& mechanism = *posture.structure->mechanism;
  const double length = mechanism.links[index].length;
  const auto on_axis = [&](double s) { return drawn_place(posture, {link, {s, 0.0}}); };
  std::vector<double> nodes{0.0, length};
  for (const flexible::RigidElement& of : posture.structure->links[index].elements) {
    nodes.push_back(of.node);
  }
  std::sort(nodes.begin(), nodes.end());
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    if (nodes[i] > nodes[i - 1]) {
      line.strokes.push_back({on_axis(nodes[i - 1]), on_axis(nodes[i])});
    }
  }
  line.points = {on_axis(0.0), on_axis(length)};
  for (const Eigen::Vector2d& p : places_on(mechanism, link)) {
    line.points.push_back(drawn_place(posture, {link, p}));
    if (std::abs(p.y()) > 1e-9 * length) {
      line.strokes.push_back({on_axis(p.x()), line.points.back()});
    }
  }
}

}  // namespace

double magnification_of(const flexible::Structure& structure, double displacement, double part) {
  Eigen::AlignedBox2d box;
  const flexible::Mechanism& mechanism = *structure.mechanism;
  for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
    const int link = static_cast<int>(k);
    for (const Eigen::Vector2d& p : places_on(mechanism, link)) {
      box.extend(flexible::in_world(mechanism, {link, p}));
    }
  }
  if (box.isEmpty() || displacement <= 0.0 || box.sizes().maxCoeff() <= 0.0) return 1.0;
  const double wanted = part * box.sizes().maxCoeff() / displacement;
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= wanted) return digit * power;
  }
  return power;
}

double largest_displacement(const flexible::LinkColumns<double>& motion) {
  double largest = 0.0;
  for (const Eigen::Matrix3Xd& link : motion) {
    largest = std::max(largest, link.topRows<2>().colwise().norm().maxCoeff());
  }
  return largest;
}

double largest_displacement(const flexible::Response& response) {
  double largest = 0.0;
  for (std::size_t k = 0; k < response.constant.motion.size(); ++k) {
    const Eigen::RowVectorXd still = response.constant.motion[k].topRows<2>().colwise().norm();
    const Eigen::RowVectorXd moving = response.harmonic.motion[k].topRows<2>().colwise().norm();
    largest = std::max(largest, (still + moving).maxCoeff());
  }
  return largest;
}

PostureFigure posture_figure(const Project& project, const DeformedPosture& posture,
                             const std::string& why) {
  const flexible::Mechanism& mechanism = *posture.structure->mechanism;
  PostureFigure figure;
  figure.why = why;
  figure.magnified = posture.magnified;
  for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
    const int link = static_cast<int>(k);
    PostureFigure::Line& line = figure.bodies.emplace_back();
    line.beam = link == project.beam_body;
    if (mechanism.links[k].length > 0.0)
      draw_axis(posture, link, line);
    else
      draw_body(posture, link, line);
  }
  for (const flexible::Joint& joint : mechanism.joints) {
    for (const Attachment& end : {joint.a, joint.b}) {
      if (end.link == flexible::ground) figure.grounds.push_back(drawn_place(posture, end));
    }
  }
  return figure;
}

std::vector<BeamLoadRow> load_rows(const Project& project, const DeformedPosture& posture,
                                   const BeamLoads& loads) {
  const flexible::Mechanism& mechanism = *posture.structure->mechanism;
  const int link = project.beam_body;
  const double angle = mechanism.links[static_cast<std::size_t>(link)].angle;
  Eigen::Matrix3d R_WS = Eigen::Matrix3d::Zero();
  R_WS.col(0) << std::cos(angle), std::sin(angle), 0.0;
  R_WS.col(1) << 0.0, 0.0, -1.0;
  R_WS.col(2) << -std::sin(angle), std::cos(angle), 0.0;
  std::vector<BeamLoadRow> rows = load_rows(loads, Time{}, R_WS);
  for (BeamLoadRow& row : rows) {
    row.place = drawn_place(posture, {link, {row.s.value(), 0.0}});
  }
  return rows;
}

}  // namespace boxbeam
