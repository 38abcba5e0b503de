#include "boxbeam/mechanism/frame/statics.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "rigid_arms.hpp"

namespace boxbeam::frame {
using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};

}  // namespace

Statics::Statics(const Structure& structure, int parts,
                 const std::vector<std::shared_ptr<const FlexibilityProfile>>& known)
    : structure_(&structure), profiles_(known) {
  profiles_.resize(structure.members.size());
  for (const Member& member : structure.members) {
    if (!structure.plane) {
      for (const Segment& segment : member.beam.segments) {
        if (twists(segment.from)) continue;
        throw AnalysisError(
            {fmt::format("the torsion constant of a section of member \"{}\" is not "
                         "known, which a frame in space needs; use a profile of "
                         "walls or a solid rectangle",
                         member.name),
             segment.name});
      }
    }
    std::shared_ptr<const FlexibilityProfile>& profile = profiles_[masses_.size()];
    if (!profile)
      profile = std::make_shared<const FlexibilityProfile>(member.beam, member.youngs_modulus,
                                                           member.shear_modulus, !structure.plane);
    masses_.push_back(mass_distribution_of(member.beam));
  }
  std::vector<std::vector<double>> joined(structure.members.size());  // stations
  for (const Joint& joint : structure.joints) {
    for (const Place* at : {&joint.a, &joint.b})
      if (at->member != ground) joined[static_cast<std::size_t>(at->member)].push_back(at->p.x());
  }
  for (std::size_t m = 0; m < structure.members.size(); ++m) {
    const Member& member = structure.members[m];
    const double length = member.beam.length().value();
    std::vector<double> stations = std::move(joined[m]);
    stations.insert(stations.end(), {0.0, length});
    std::sort(stations.begin(), stations.end());
    const auto same = [&](double a, double b) { return b - a < 1e-9 * length; };
    stations.erase(std::unique(stations.begin(), stations.end(), same), stations.end());
    stations.front() = 0.0;
    stations.back() = length;
    const std::vector<double> held = stations;
    stations = {0.0};
    for (std::size_t k = 1; k < held.size(); ++k) {
      for (int part = 1; part < parts; ++part)
        stations.push_back(held[k - 1] + (held[k] - held[k - 1]) * part / parts);
      stations.push_back(held[k]);
    }
    for (std::size_t k = 0; k < stations.size(); ++k) {
      if (k > 0) pieces_.push_back({static_cast<int>(m), nodes_.size() - 1, nodes_.size()});
      nodes_.push_back({static_cast<int>(m), stations[k]});
    }
    length_ = std::max(length_, length);
  }
  assemble();
}

Index Statics::row_of_node(std::size_t node) const {
  return static_cast<Index>(node * world_components(*structure_).size());
}

Index Statics::row_of_piece(std::size_t piece) const {
  return row_of_node(nodes_.size()) +
         static_cast<Index>(piece * cut_components(*structure_).size());
}

std::size_t Statics::node_of(const Place& at) const {
  const auto [first, last] =
      std::equal_range(nodes_.begin(), nodes_.end(), Node{at.member, 0.0},
                       [](const Node& a, const Node& b) { return a.member < b.member; });
  const auto nearest = std::min_element(first, last, [&](const Node& a, const Node& b) {
    return std::abs(a.s - at.p.x()) < std::abs(b.s - at.p.x());
  });
  return static_cast<std::size_t>(nearest - nodes_.begin());
}

double Statics::reach_along_pieces() {
  double softest = 0.0;
  for (const Piece& piece : pieces_) {
    const double from = nodes_[piece.from].s, to = nodes_[piece.to].s;
    std::vector<Reached>& reached = reached_.emplace_back();
    reached.push_back({from, Matrix6::Zero()});
    const auto reach = [&](double s) {
      const Matrix6 by = carry(Vector3d(s - reached.back().s, 0.0, 0.0));
      const Matrix6 F = by * reached.back().flexibility * by.transpose() +
                        flexibility_between(piece.member, reached.back().s, s);
      reached.push_back({s, 0.5 * (F + F.transpose())});
    };
    for (const double border : profiles_[static_cast<std::size_t>(piece.member)]->borders())
      if (border > from && border < to) reach(border);
    reach(to);
    const Matrix6& F = reached.back().flexibility;
    softest = std::max({softest, F(1, 1), F(2, 2)});
  }
  return softest;
}

void Statics::assemble() {
  const Structure& of = *structure_;
  const std::span<const Index> world = world_components(of), cut = cut_components(of);
  // Unknowns near one: a force that shifts by the length of the frame.
  force_ = length_ / reach_along_pieces();
  const auto shift_unit = [&](Index k) { return k < 3 ? length_ : 1.0; };
  const auto force_unit = [&](Index k) { return k < 3 ? force_ : force_ * length_; };

  Index rows = row_of_piece(pieces_.size());
  std::vector<Eigen::Triplet<double>> entries;
  /// Rows of a balance that fits against the motion of a node: block and its transpose.
  const auto add = [&](Index row, Index row_component, std::size_t node, const Matrix6& block) {
    for (std::size_t k = 0; k < world.size(); ++k) {
      const double value = block(row_component, world[k]);
      if (value == 0.0) continue;
      const double scaled = value * shift_unit(world[k]) / shift_unit(row_component);
      const Index column = row_of_node(node) + static_cast<Index>(k);
      entries.emplace_back(row, column, scaled);
      entries.emplace_back(column, row, scaled);
    }
  };
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const Piece& piece = pieces_[p];
    const Member& member = of.members[static_cast<std::size_t>(piece.member)];
    const double h = nodes_[piece.to].s - nodes_[piece.from].s;
    const Matrix6 into = rotation(member.axes).transpose();
    const Matrix6 at_from = -carry(Vector3d(h, 0.0, 0.0)) * into;
    for (std::size_t i = 0; i < cut.size(); ++i) {
      const Index row = row_of_piece(p) + static_cast<Index>(i);
      add(row, cut[i], piece.from, at_from);
      add(row, cut[i], piece.to, into);
      for (std::size_t j = 0; j < cut.size(); ++j) {
        const double value = reached_[p].back().flexibility(cut[i], cut[j]);
        if (value == 0.0) continue;
        entries.emplace_back(row, row_of_piece(p) + static_cast<Index>(j),
                             -value * force_unit(cut[j]) / shift_unit(cut[i]));
      }
    }
  }
  for (const Joint& joint : of.joints) {
    const Matrix6 into = rotation(joint.axes).transpose();
    for (const Index component : world) {
      const double stiffness = joint.stiffness[static_cast<std::size_t>(component)];
      joint_rows_.push_back(stiffness > 0.0 ? rows : -1);
      if (!(stiffness > 0.0)) continue;
      const auto add_end = [&](const Place& at, double sign) {
        if (at.member == ground) return;
        const Matrix3d& axes = of.members[static_cast<std::size_t>(at.member)].axes;
        add(rows, component, node_of(at),
            sign * into * carry(axes * Vector3d(0.0, at.p.y(), at.p.z())));
      };
      add_end(joint.a, -1.0);
      add_end(joint.b, 1.0);
      if (!std::isinf(stiffness)) {
        entries.emplace_back(rows, rows,
                             -force_unit(component) / (stiffness * shift_unit(component)));
      }
      ++rows;
    }
  }
  matrix_.resize(rows, rows);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  refuse_held_twice();
  solver_.compute(matrix_);
  refuse_mechanisms(matrix_);
}

void Statics::refuse_held_twice() const {
  // Between nodes everything yields, so that only rigid joints of the same nodes can hold the same:
  // their rows G are then dependent, and a pivot of G G^T vanishes.
  const std::span<const Index> world = world_components(*structure_);
  const Index moving = row_of_node(nodes_.size());
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<std::size_t> held;  // places in joint_rows_
  for (std::size_t k = 0; k < joint_rows_.size(); ++k) {
    const Joint& joint = structure_->joints[k / world.size()];
    if (!std::isinf(joint.stiffness[static_cast<std::size_t>(world[k % world.size()])])) continue;
    for (Eigen::SparseMatrix<double>::InnerIterator at(matrix_, joint_rows_[k]); at; ++at) {
      if (at.row() < moving)
        entries.emplace_back(at.row(), static_cast<Index>(held.size()), at.value());
    }
    held.push_back(k);
  }
  if (held.empty()) return;
  Eigen::SparseMatrix<double> G(moving, static_cast<Index>(held.size()));
  G.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> gram = G.transpose() * G;
  const Eigen::VectorXd sizes = gram.diagonal();
  // In the order of the joints, so that the first that is one too many is named.
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower,
                              Eigen::NaturalOrdering<int>>
      pivots(gram);
  constexpr double vanishes = 1e-12;  // axes within 1e-6 rad of each other
  for (Index k = 0; k < sizes.size(); ++k) {
    if (pivots.vectorD()[k] > vanishes * sizes[k]) continue;
    const std::size_t row = held[static_cast<std::size_t>(k)];
    const Joint& joint = structure_->joints[row / world.size()];
    const Index component = world[row % world.size()];
    throw AnalysisError(
        {fmt::format("joint \"{}\" holds rigidly {} its {} axis what rigid joints at "
                     "the same place hold already: how they share the load is not "
                     "determined; free it of one, or give it a stiffness",
                     joint.name, component < 3 ? "along" : "about", axis_names[component % 3]),
         joint.name});
  }
}

void Statics::refuse_mechanisms(const Eigen::SparseMatrix<double>& matrix) const {
  // Loads of no pattern move what nothing holds further than any load that is carried.
  const Index moving = row_of_node(nodes_.size());
  Eigen::VectorXd probe = Eigen::VectorXd::Zero(matrix.rows());
  for (Index k = 0; k < moving; ++k) probe[k] = std::cos(1.0 + 1.7 * static_cast<double>(k));
  constexpr double beyond = 1e11;
  Eigen::VectorXd motion;
  if (solver_.info() == Eigen::Success) motion = solver_.solve(probe);
  const auto moves = [&] {
    return motion.size() == 0 || !motion.allFinite() ||
           motion.head(moving).cwiseAbs().maxCoeff() > beyond;
  };
  if (!moves()) return;
  // On springs too soft to carry anything it moves as it is free to.
  Eigen::SparseMatrix<double> held = matrix;
  for (Index k = 0; k < moving; ++k) held.coeffRef(k, k) += 1e-13;
  const Eigen::SparseLU<Eigen::SparseMatrix<double>> softly(held);
  if (softly.info() == Eigen::Success) motion = softly.solve(probe);
  AnalysisFailure failure{"the frame is free to move", "", {}, {}, {}};
  if (motion.size() > 0 && motion.allFinite()) {
    Index most = 0;
    motion.head(moving).cwiseAbs().maxCoeff(&most);
    const std::span<const Index> world = world_components(*structure_);
    const std::size_t count = world.size();
    const Node& node = nodes_[static_cast<std::size_t>(most) / count];
    const Index component = world[static_cast<std::size_t>(most) % count];
    const Member& member = structure_->members[static_cast<std::size_t>(node.member)];
    failure.what = fmt::format(
        "the frame is free to move: member \"{}\" can {} {} at s = {:.6g} m, and nothing resists; "
        "add "
        "a support or a joint that holds it",
        member.name, component < 3 ? "shift along" : "turn about", axis_names[component % 3],
        node.s);
    failure.where = member.name;
  }
  throw AnalysisError(std::move(failure));
}

}  // namespace boxbeam::frame
