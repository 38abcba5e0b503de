#include "scene_matrices.hpp"

#include <algorithm>

namespace boxbeam::frame {
namespace {

using Eigen::Index;

/// The largest of the diagonal of a beam's stiffness, shifts by this length.
double stiffest_entry_of(const VibratingBeam& beam, double length) {
  double largest = 0.0;
  Vector6 before = Vector6::Zero();
  const auto look = [&](const Vector6& diagonal) {
    largest = std::max(
        {largest, diagonal.head<3>().maxCoeff() * length * length, diagonal.tail<3>().maxCoeff()});
  };
  for (const VibratingBeam::Piece& piece : beam.pieces()) {
    look(before + piece.stiffness.diagonal().head<6>());
    before = piece.stiffness.diagonal().tail<6>();
  }
  look(before);
  return largest;
}

/// Of an end that may stand anywhere along its beam.
void add_between_nodes(const VibratingScene& scene, const SceneRows& rows, const Tie::End& end,
                       Gap& gap) {
  const auto member = static_cast<std::size_t>(end.at.member);
  const PosedBeam& posed = scene.beams[member];
  const Eigen::Vector3d along = posed.axes.col(0);
  const double s = std::clamp(along.dot(end.at.p - posed.start), 0.0, posed.beam->length());
  const std::size_t piece = posed.beam->piece_at(s);
  const Vector6 there = carry(end.at.p - posed.start - s * along).transpose() * end.per;
  Vector6 per;
  per << posed.axes.transpose() * there.head<3>(), posed.axes.transpose() * there.tail<3>();
  const Eigen::Vector<double, 12> ends = posed.beam->pieces()[piece].motion_at(s).transpose() * per;
  const Index row = rows.beams[member] + static_cast<Index>(6 * piece);
  gap.add(row, ends.head<6>());
  gap.add(row + 6, ends.tail<6>());
}

}  // namespace

SceneRows rows_of(const VibratingScene& scene) {
  SceneRows rows;
  for (const PosedBeam& posed : scene.beams) {
    rows.beams.push_back(rows.bodies);
    rows.bodies += static_cast<Index>(6 * posed.beam->nodes().size());
  }
  rows.size = rows.bodies + static_cast<Index>(6 * scene.bodies.size());
  return rows;
}

Followed followed_by(const VibratingScene& scene, const SceneRows& rows, const Place& at) {
  const auto member = static_cast<std::size_t>(at.member);
  if (member >= scene.beams.size()) {
    const std::size_t body = member - scene.beams.size();
    return {rows.bodies + static_cast<Index>(6 * body), scene.bodies[body].centre};
  }
  const PosedBeam& posed = scene.beams[member];
  const std::size_t node = posed.beam->node_of(posed.axes.col(0).dot(at.p - posed.start));
  return {rows.beams[member] + static_cast<Index>(6 * node),
          posed.start + posed.beam->nodes()[node] * posed.axes.col(0), posed.axes};
}

Eigen::VectorXd in_scene_axes(const VibratingScene& scene, const SceneRows& rows,
                              Eigen::VectorXd coordinates) {
  for (std::size_t b = 0; b < scene.beams.size(); ++b) {
    const auto triples = static_cast<Index>(2 * scene.beams[b].beam->nodes().size());
    auto own = coordinates.segment(rows.beams[b], 3 * triples).reshaped(3, triples);
    own = (scene.beams[b].axes * own).eval();
  }
  return coordinates;
}

Gap gap_of(const VibratingScene& scene, const SceneRows& rows, const Tie& tie) {
  Gap gap;
  for (const Tie::End& end : tie.ends) {
    if (end.at.member == ground) continue;
    if (end.slides && static_cast<std::size_t>(end.at.member) < scene.beams.size()) {
      add_between_nodes(scene, rows, end, gap);
      continue;
    }
    const Followed by = followed_by(scene, rows, end.at);
    const Vector6 there = carry(end.at.p - by.from).transpose() * end.per;
    Vector6 per;
    per << by.axes.transpose() * there.head<3>(), by.axes.transpose() * there.tail<3>();
    gap.add(by.row, per);
  }
  return gap;
}

SceneTies ties_of(const VibratingScene& scene, const SceneRows& rows) {
  SceneTies all;
  double stiffest = 0.0;
  for (const PosedBeam& posed : scene.beams)
    all.length = std::max(all.length, posed.beam->length());
  for (const PosedBeam& posed : scene.beams)
    stiffest = std::max(stiffest, stiffest_entry_of(*posed.beam, all.length));
  for (const Tie& tie : scene.ties) {
    Gap gap = gap_of(scene, rows, tie);
    if (tie.rigid) all.giving.push_back({&tie, gap});
    const double unit = tie.way() == 0 ? all.length * all.length : 1.0;
    auto& kind = tie.stiffness * unit > stiff_as_rigid * stiffest ? all.held : all.elastic;
    kind.push_back({&tie, std::move(gap)});
  }
  return all;
}

}  // namespace boxbeam::frame
