#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "ring.hpp"
#include "section_areas.hpp"

/// How shear flows in the walls of a section.
namespace oracle {

namespace cut_force = boxbeam::cut_force;

/// V_y, V_z and T per cut force.
using Carried = Eigen::Matrix<double, 3, 6>;

/// A profile of the section with the change of its forces along the beam, and its flows.
class Flow {
 public:
  Flow(const LocalSection& section, bool inner) {
    const boxbeam::Profile& profile = inner ? *section.here.inner : section.here.outer;
    const std::vector<boxbeam::Hole> none;
    ring_ = ring_of(profile, inner ? none : section.holes);
    plane_ = plane_for(section.here, section.holes, 1.0, 1.0);
    for (const auto& [near, weight] : section.nearby) {
      nearby_.push_back({ring_of(inner ? *near.inner : near.outer, inner ? none : section.holes),
                         plane_for(near, section.holes, 1.0, 1.0), weight});
    }
    whole_I_T_ = ring_.I_T;
    const std::optional<boxbeam::Profile> other =
        inner ? std::optional<boxbeam::Profile>(section.here.outer) : section.here.inner;
    if (other) whole_I_T_ += ring_of(*other, {}).I_T;
    total_ = ring_.total();
    bredt_ = constant_flow();
    total_change_ = change_of([](const Ring& ring) { return ring.total(); });
    close();
  }

  const Ring& ring() const { return ring_; }
  double per_whole_I_T() const { return 1.0 / whole_I_T_; }

  /// V_y, V_z and T, per cut force, that flows without twist and inclined stresses carry.
  Carried carried() const {
    Carried sum = Carried::Zero();
    const auto add = [&](const Vector2d& at, const Vector2d& way, const Factors& q) {
      for (std::size_t k = 0; k < q.size(); ++k) add_force(sum, k, at, q[k] * way);
    };
    for (std::size_t i = 0; i < ring_.pieces.size(); ++i) {
      const Piece& piece = ring_.pieces[i];
      const int steps = piece.radius > 0.0 ? 96 : 8;
      simpson(steps, [&](double f, double weight) {
        add(piece.at(f), weight * piece.length() * piece.along(f), transverse(i, f));
      });
      add(piece.node_from, piece.from - piece.node_from, transverse(i, 0.0));
      add(piece.to, piece.node_to - piece.to, transverse(i, 1.0));
    }
    for (std::size_t b = 0; b < ring_.branches.size(); ++b) {
      const Branch& branch = ring_.branches[b];
      simpson(8, [&](double f, double weight) {
        add(branch.free + f * (branch.foot - branch.free), weight * (branch.foot - branch.free),
            in_branch(b, f));
      });
      add(branch.foot, branch.node - branch.foot, in_branch(b, 1.0));
    }
    add_inclined(sum);
    return sum;
  }

  /// What walls carry by bending across their thickness: a stretch's share of such a force is
  /// t^3/12 n (n . force), in its middle. Forces as columns give V_y, V_z and T of a unit share.
  Eigen::Matrix<double, 3, 2> across() const {
    Eigen::Matrix<double, 3, 2> sum = Eigen::Matrix<double, 3, 2>::Zero();
    const auto add = [&](const Vector2d& at, const Vector2d& along, double length, double t) {
      const Vector2d n(-along.y(), along.x());
      const Eigen::RowVector2d of = length * t * t * t / 12.0 * n.transpose();
      sum.topRows<2>() += n * of;
      sum.row(2) += (at.x() * n.y() - at.y() * n.x()) * of;
    };
    for (const Piece& piece : ring_.pieces) {
      if (!piece.solid) continue;
      simpson(piece.radius > 0.0 ? 96 : 8, [&](double f, double weight) {
        add(piece.at(f), piece.along(f), weight * piece.length(), piece.thickness);
      });
    }
    for (const Branch& branch : ring_.branches) {
      const Vector2d way = branch.foot - branch.free;
      if (way.norm() == 0.0) continue;
      add(0.5 * (branch.free + branch.foot), way.normalized(), way.norm(), branch.thickness);
    }
    return sum;
  }

  /// Flow in the ring without twist, positive along it.
  Factors transverse(std::size_t index, double f) const {
    Factors q = open(index, f);
    for (std::size_t k = 0; k < q.size(); ++k) q[k] += closing_[k];
    return q;
  }

  /// Flow from the free end towards the ring.
  Factors in_branch(std::size_t index, double f) const {
    return flow_of([=](const Ring& ring) -> Vector3d { return ring.branches[index].material(f); });
  }

  /// Constant flow per torque, positive along the ring.
  double bredt() const { return bredt_; }

 private:
  double constant_flow() const {
    // T r/I_p where the ring is round.
    const Piece& first = ring_.pieces.front();
    if (first.radius > 0.0) return first.radius * first.thickness / whole_I_T_;
    double twice_area = 0.0;  // negative where the ring runs clockwise
    for (const Piece& piece : ring_.pieces) {
      twice_area +=
          piece.node_from.x() * piece.node_to.y() - piece.node_from.y() * piece.node_to.x();
    }
    return (ring_.I_T - ring_.own_torsion) / whole_I_T_ / twice_area;
  }

  struct Nearby {
    Ring ring;
    Eigen::Matrix3d plane;
    double weight;
  };

  template <class Visit>
  static void simpson(int steps, const Visit& visit) {
    for (int i = 0; i <= steps; ++i) {
      const double weight = (i == 0 || i == steps ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0)) / (3.0 * steps);
      visit(static_cast<double>(i) / steps, weight);
    }
  }

  /// d/ds of the force of some material per N, M_y, M_z.
  template <class Material>
  Eigen::RowVector3d change_of(const Material& material) const {
    Eigen::RowVector3d change = Eigen::RowVector3d::Zero();
    for (const Nearby& near : nearby_) {
      change += near.weight * (material(near.ring).transpose() * near.plane);
    }
    return change;
  }

  /// What leaves some material of the ring by shear: its share of what the whole ring gives to the
  /// other profile comes in, the change of its own normal force goes out.
  template <class Material>
  Factors flow_of(const Material& material) const {
    const Vector3d of = material(ring_);
    const double share = of[0] / total_[0];
    const Eigen::RowVector3d force =
        of.transpose() * plane_ - share * (total_.transpose() * plane_);
    const Eigen::RowVector3d change = change_of(material) - share * total_change_;
    Factors q{};
    q[cut_force::V_z] = -force[1];
    q[cut_force::V_y] = force[2];
    q[cut_force::N] = -change[0];
    q[cut_force::M_y] = -change[1];
    q[cut_force::M_z] = -change[2];
    return q;
  }

  Factors open(std::size_t index, double f) const {
    return flow_of([=](const Ring& ring) -> Vector3d {
      return ring.before(index) + ring.pieces[index].material(f);
    });
  }

  void close() {
    Factors around{};
    double per_flow = 0.0;
    for (std::size_t i = 0; i < ring_.pieces.size(); ++i) {
      const Piece& piece = ring_.pieces[i];
      const auto add = [&](double length, const Factors& q) {
        for (std::size_t k = 0; k < q.size(); ++k) around[k] += length / piece.thickness * q[k];
        per_flow += length / piece.thickness;
      };
      simpson(piece.radius > 0.0 ? 96 : 8,
              [&](double f, double weight) { add(weight * piece.length(), open(i, f)); });
      add((piece.from - piece.node_from).norm(), open(i, 0.0));
      add((piece.node_to - piece.to).norm(), open(i, 1.0));
    }
    for (std::size_t k = 0; k < around.size(); ++k) closing_[k] = -around[k] / per_flow;
  }

  static void add_force(Carried& sum, std::size_t of, const Vector2d& at, const Vector2d& force) {
    sum.col(static_cast<Eigen::Index>(of)) +=
        Vector3d(force.x(), force.y(), at.x() * force.y() - at.y() * force.x());
  }

  /// Normal stresses that follow the inclined material.
  void add_inclined(Carried& sum) const {
    if (nearby_.empty()) return;
    const auto add = [&](const Vector2d& at, const Vector2d& slope, double area) {
      const Eigen::RowVector3d force = area * Eigen::RowVector3d(1.0, at.x(), at.y()) * plane_;
      add_force(sum, cut_force::N, at, force[0] * slope);
      add_force(sum, cut_force::M_y, at, force[1] * slope);
      add_force(sum, cut_force::M_z, at, force[2] * slope);
    };
    for (std::size_t i = 0; i < ring_.pieces.size(); ++i) {
      const Piece& piece = ring_.pieces[i];
      if (!piece.solid) continue;
      simpson(piece.radius > 0.0 ? 96 : 8, [&](double f, double weight) {
        Vector2d slope = Vector2d::Zero();
        for (const Nearby& near : nearby_) slope += near.weight * near.ring.pieces[i].at(f);
        add(piece.at(f), slope, weight * piece.length() * piece.thickness);
      });
    }
    for (std::size_t b = 0; b < ring_.branches.size(); ++b) {
      const Branch& branch = ring_.branches[b];
      const double area = (branch.foot - branch.free).norm() * branch.thickness;
      simpson(8, [&](double f, double weight) {
        Vector2d slope = Vector2d::Zero();
        for (const Nearby& near : nearby_) {
          const Branch& other = near.ring.branches[b];
          slope += near.weight * (other.free + f * (other.foot - other.free));
        }
        add(branch.free + f * (branch.foot - branch.free), slope, weight * area);
      });
    }
  }

  Ring ring_;
  Eigen::Matrix3d plane_;
  std::vector<Nearby> nearby_;
  Vector3d total_;
  Eigen::RowVector3d total_change_;
  Factors closing_{};
  double whole_I_T_ = 0.0, bredt_ = 0.0;
};

}  // namespace oracle
