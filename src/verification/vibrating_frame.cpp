#include "vibrating_frame.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "frame_time.hpp"

namespace boxbeam {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using frame::Vector6;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Stations of a member at which something takes hold of it.
std::vector<double> held_stations(const frame::Structure& structure, std::size_t member) {
  std::vector<double> at;
  const auto add = [&](const frame::Place& place) {
    if (place.member == static_cast<int>(member)) at.push_back(place.p.x());
  };
  for (const frame::Joint& joint : structure.joints) {
    add(joint.a);
    add(joint.b);
  }
  for (const frame::LoadCase& in : structure.cases) {
    for (const frame::Action& action : in.actions)
      if (const auto* const driven = std::get_if<frame::DrivenAction>(&action.kind))
        add(driven->at);
  }
  return at;
}

/// Joints of a frame as ties between its members, in the axes of a scene.
std::vector<frame::Tie> ties_of_frame(const frame::Structure& structure,
                                      const std::vector<std::size_t>& place,
                                      const Matrix3d& from_world, const Vector3d& origin) {
  std::vector<frame::Tie> ties;
  for (const frame::Joint& joint : structure.joints) {
    for (std::size_t way = 0; way < 6; ++way) {
      const double stiffness = joint.stiffness[way];
      // In a plane frame joints know their plane's ways alone.
      const bool in_plane = way == 0 || way == 1 || way == 5;
      if (stiffness == 0.0 || (structure.plane && !in_plane)) continue;
      Vector6 per = Vector6::Zero();
      per.segment<3>(way < 3 ? 0 : 3) = from_world * joint.axes.col(static_cast<Index>(way % 3));
      const auto end = [&](const frame::Place& at, double sign) -> frame::Tie::End {
        const int member = at.member == frame::ground
                               ? frame::ground
                               : static_cast<int>(place[static_cast<std::size_t>(at.member)]);
        return {{member, from_world * (frame::in_world(structure, at) - origin)}, sign * per};
      };
      frame::Tie& tie = ties.emplace_back();
      tie.ends = {end(joint.a, -1.0), end(joint.b, 1.0)};
      tie.stiffness = stiffness;
      tie.name = joint.name;
    }
  }
  return ties;
}

/// Keeps a node of a member in the plane of the frame.
void keep_in_plane(int member, const Vector3d& at, const Matrix3d& from_world,
                   std::vector<frame::Tie>& ties) {
  for (const auto& [turns, axis] : {std::pair{false, 2}, {true, 0}, {true, 1}}) {
    frame::Tie& tie = ties.emplace_back();
    Vector6 per = Vector6::Zero();
    per.segment<3>(turns ? 3 : 0) = from_world.col(axis);
    tie.ends.push_back({{member, at}, per});
  }
}

}  // namespace

VibratingFrame::VibratingFrame(const Project& project, const frame::Structure& structure, int parts)
    : structure_(&structure),
      moving_(acting_part_of(structure, true)),
      statics_(structure),
      place_(structure.members.size()) {
  order_ = {static_cast<std::size_t>(project.beam_body)};
  for (std::size_t m = 0; m < structure.members.size(); ++m)
    if (m != order_.front()) order_.push_back(m);
  for (std::size_t b = 0; b < order_.size(); ++b) {
    const frame::Member& member = structure.members[order_[b]];
    place_[order_[b]] = b;
    beams_.emplace_back(member.beam, member.youngs_modulus, member.shear_modulus,
                        held_stations(structure, order_[b]), parts, project.model.retardation);
  }
}

std::vector<frame::BeamMode> VibratingFrame::modes(double time, std::size_t count) const {
  const frame::Equilibrium loaded = statics_.solve(frame::acting_at(*structure_, time));
  const frame::Member& first = structure_->members[order_.front()];
  const Matrix3d from_world = first.axes.transpose();
  frame::VibratingScene scene;
  for (std::size_t b = 0; b < order_.size(); ++b) {
    const frame::Member& member = structure_->members[order_[b]];
    scene.beams.push_back({&beams_[b], loaded.members[order_[b]].cut,
                           from_world * (member.start - first.start), from_world * member.axes});
  }
  scene.ties = ties_of_frame(*structure_, place_, from_world, first.start);
  if (structure_->plane) {
    for (std::size_t b = 0; b < order_.size(); ++b) {
      for (const double s : beams_[b].nodes())
        keep_in_plane(static_cast<int>(b), scene.beams[b].start + s * scene.beams[b].axes.col(0),
                      from_world, scene.ties);
    }
  }
  return frame::modes_of(scene, count);
}

/// Shift and turn of a member's axis, in the axes of the member. Within a piece the polynomial
/// through its ends and the places where its motion is known.
VibratingFrame::Moved VibratingFrame::moved_at(std::size_t beam, double s) const {
  const frame::VibratingBeam& of = beams_[beam];
  const std::vector<frame::VibratingBeam::Piece>& pieces = of.pieces();
  Moved moved;
  for (std::size_t b = 0; b < beam; ++b)
    moved.row += static_cast<Index>(6 * beams_[b].nodes().size());
  std::size_t station = 0, k = 0;
  for (; k + 1 < pieces.size() && s > pieces[k].to; ++k) station += pieces[k].samples.size();
  const frame::VibratingBeam::Piece& piece = pieces[k];
  moved.row += static_cast<Index>(6 * k);
  std::vector<double> places{piece.from, piece.to};
  for (std::size_t i = 0; i < piece.samples.size(); ++i)
    places.push_back(of.stations()[station + i].s.value());
  const std::vector<double> weights = lagrange_weights(places, s);
  moved.by << weights[0] * Matrix6::Identity(), weights[1] * Matrix6::Identity();
  for (std::size_t i = 0; i < piece.samples.size(); ++i)
    moved.by += weights[i + 2] * piece.samples[i].motion;
  const Matrix3d into =
      structure_->members[order_[beam]].axes.transpose() * structure_->members[order_.front()].axes;
  for (Index part = 0; part < 4; ++part)
    moved.by.middleCols<3>(3 * part) = (moved.by.middleCols<3>(3 * part) * into).eval();
  return moved;
}

VectorXd VibratingFrame::forces(const std::vector<frame::BeamMode>& modes, double time,
                                double begin, double end) const {
  VectorXd sum = VectorXd::Zero(static_cast<Index>(modes.size()));
  const frame::ActingLoads acting = frame::acting_at(moving_, std::clamp(time, begin, end));
  for (const frame::ActingLoads::Point& point : acting.points) {
    const frame::Place& at = point.action.at;
    const auto member = static_cast<std::size_t>(at.member);
    const Matrix3d into = structure_->members[member].axes.transpose();
    const Vector3d force = into * point.action.force,
                   about_axis =
                       into * point.action.moment + Vector3d(0.0, at.p.y(), at.p.z()).cross(force);
    Vector6 wrench;
    wrench << force, about_axis;
    const Moved moved = moved_at(place_[member], at.p.x());
    const Eigen::Matrix<double, 12, 1> on_nodes = moved.by.transpose() * wrench;
    for (Index j = 0; j < sum.size(); ++j)
      sum[j] += on_nodes.dot(modes[static_cast<std::size_t>(j)].motion.segment<12>(moved.row));
  }
  return sum;
}

}  // namespace boxbeam
