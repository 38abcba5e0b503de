#include "boxbeam/mechanism/frame/bent_scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/section/cut_forces.hpp"
#include "held_scene.hpp"
#include "rigid_arms.hpp"

namespace boxbeam::frame {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using EndMatrix = VibratingBeam::Matrix12;
using EndVector = Eigen::Matrix<double, 12, 1>;

/// N, V_y, V_z and T, M_y, M_z.
struct BornForces {
  Vector3d force, moment;
};

BornForces born_at(const PosedBeam& posed, const Station& station) {
  const CutForces cut = posed.rigid.at(station);
  return {{cut.N.value(), cut.V_y.value(), cut.V_z.value()},
          {cut.T.value(), cut.M_y.value(), cut.M_z.value()}};
}

/// A piece of a beam under what it bears.
struct BornPiece {
  EndMatrix stress = EndMatrix::Zero();    ///< second variation of the work of its cut forces
  EndVector strained = EndVector::Zero();  ///< int B^T c ds
};

BornPiece born_piece(const PosedBeam& posed, const VibratingBeam::Piece& piece,
                     const Station* stations, bool whole) {
  BornPiece of;
  EndMatrix half = EndMatrix::Zero();
  for (std::size_t i = 0; i < piece.samples.size(); ++i) {
    const VibratingBeam::Sample& sample = piece.samples[i];
    const BornForces born = born_at(posed, stations[i]);
    Vector6 cut;
    cut << born.force, born.moment;
    of.strained += sample.strain.transpose() * (sample.weight * cut);
    const VibratingBeam::Leaning leaning = sample.leaning();
    // What works on each of the columns, halved.
    VibratingBeam::Leaning on = VibratingBeam::Leaning::Zero();
    on.leftCols<2>() = 0.5 * born.force.x() * leaning.leftCols<2>();
    if (whole) {
      // theta . (M x theta')
      on.rightCols<3>() =
          sample.strain.bottomRows<3>().transpose().lazyProduct(-0.5 * skew(born.moment));
      // With v' = theta_z, w' = -theta_y, of no shear, -(V_y theta_y + V_z theta_z)/2.
      on.col(2) += born.force.y() * (0.5 * leaning.col(3) + leaning.col(1)) +
                   born.force.z() * (0.5 * leaning.col(4) - leaning.col(0));
    }
    on *= sample.weight;
    half += leaning.lazyProduct(on.transpose());
  }
  of.stress = half + half.transpose();
  return of;
}

/// theta^2 F . a - F . theta a . theta, twice over.
Matrix3d stress_of_arm(const Vector3d& force, const Vector3d& arm) {
  return force.dot(arm) * Matrix3d::Identity() -
         0.5 * (force * arm.transpose() + arm * force.transpose());
}

/// Where forces and lines take hold.
std::vector<Place> pushed_by(const SceneStress& stress) {
  std::vector<Place> places;
  for (const SceneStress::Force& force : stress.forces) places.push_back(force.at);
  for (const SceneStress::Line& line : stress.lines) places.insert(places.end(), {line.a, line.b});
  return places;
}

/// The posture of a scene under what acts in it.
class StressedScene {
 public:
  StressedScene(const VibratingScene& scene, const SceneStress& stress, KeptTies& last)
      : scene_(&scene),
        held_(scene, pushed_by(stress), last),
        strained_(VectorXd::Zero(held_.rows().size)),
        elastic_(held_.elastic_ties()),
        whole_(stress.whole.front()) {
    for (std::size_t b = 0; b < scene.beams.size(); ++b) add_beam(b, stress.whole[b]);
    // What is in joints and rods that give way strains them.
    for (const Tied& of : held_.ties().giving)
      for (const auto& [row, per] : of.gap.parts) strained_.segment<6>(row) += *of.tie->rigid * per;
    for (const SceneStress::Force& force : stress.forces) add_force(force);
    for (const SceneStress::Line& line : stress.lines) add_line(line);
  }

  std::optional<BentScene> bent(double factor) const {
    BentScene result;
    const auto standing = standing_under(factor);
    if (!standing) {
      if (!standing_under(0.0)) return {};
      double stable = 0.0, unstable = factor;
      constexpr double close = 1e-3;
      while (unstable - stable > close * unstable) {
        const double middle = 0.5 * (stable + unstable);
        (standing_under(middle) ? stable : unstable) = middle;
      }
      result.critical = 0.5 * (stable + unstable);
      return result;
    }
    const VectorXd moved = standing->moved_by(strained_);
    load_first_beam(factor, moved, result);
    result.motion = in_scene_axes(*scene_, held_.rows(), moved);
    return result;
  }

 private:
  /// Under so many times what acts.
  std::optional<StandingScene> standing_under(double factor) const {
    SceneStiffness stiffness;
    for (std::size_t b = 0; b < born_.size(); ++b) {
      std::vector<EndMatrix>& pieces = stiffness.pieces.emplace_back();
      const auto& elastic = scene_->beams[b].beam->pieces();
      for (std::size_t p = 0; p < elastic.size(); ++p)
        pieces.push_back(elastic[p].stiffness + factor * born_[b][p].stress);
    }
    stiffness.beside = elastic_;
    for (const Eigen::Triplet<double>& of : stress_.entries)
      stiffness.beside.entries.emplace_back(of.row(), of.col(), factor * of.value());
    return held_.standing(stiffness);
  }

  void add_beam(std::size_t b, bool whole) {
    const PosedBeam& posed = scene_->beams[b];
    Index row = held_.rows().beams[b];
    const Station* station = posed.beam->stations().data();
    std::vector<BornPiece>& born = born_.emplace_back();
    for (const VibratingBeam::Piece& piece : posed.beam->pieces()) {
      const BornPiece& of = born.emplace_back(born_piece(posed, piece, station, whole));
      strained_.segment<12>(row) += of.strained;
      row += 6;
      station += piece.samples.size();
    }
  }

  /// Along a beam's axis its cut forces count already.
  void add_force(const SceneStress::Force& of) {
    if (of.at.member == ground) return;
    const Followed by = followed_by(*scene_, held_.rows(), of.at);
    Vector3d arm = of.at.p - by.from;
    if (static_cast<std::size_t>(of.at.member) < scene_->beams.size()) {
      const Vector3d axis = by.axes.col(0);
      arm -= axis.dot(arm) * axis;
    }
    const Index row = held_.kept_row(by.row) + 3;
    stress_.add(row, row, by.axes.transpose() * stress_of_arm(of.force, arm) * by.axes);
  }

  void add_line(const SceneStress::Line& of) {
    const Vector3d along = of.b.p - of.a.p;
    const double length = along.norm();
    if (length == 0.0) return;
    const Vector3d n = along / length;
    const Matrix3d across = of.tension / length * (Matrix3d::Identity() - n * n.transpose());
    struct End {
      Index row;
      Eigen::Matrix<double, 3, 6> motion;
    };
    std::vector<End> ends;
    const auto add = [&](const Place& at, double sign) {
      if (at.member == ground) return;
      const Followed by = followed_by(*scene_, held_.rows(), at);
      ends.push_back(
          {held_.kept_row(by.row), sign * carry(at.p - by.from).topRows<3>() * rotation(by.axes)});
    };
    add(of.a, -1.0);
    add(of.b, 1.0);
    for (const End& one : ends)
      for (const End& other : ends)
        stress_.add(one.row, other.row, one.motion.transpose() * across * other.motion);
  }

  /// What bending adds to the cut forces of a piece, at its start, both thirds and its end.
  struct AddedCut {
    std::array<Vector3d, 4> forces, moments;
  };

  AddedCut added_in(const VibratingBeam::Piece& piece, const BornPiece& born, const EndVector& ends,
                    double factor) const {
    const PosedBeam& posed = scene_->beams.front();
    const double h = piece.to - piece.from;
    const EndVector added = piece.stiffness * ends - born.strained + factor * (born.stress * ends);
    Eigen::Matrix<double, 5, 3> leaning;
    for (std::size_t k = 0; k < 3; ++k)
      leaning.col(static_cast<Index>(k)) = piece.leaning[k].transpose() * ends;
    const auto leaning_at = [&](double u) -> Eigen::Matrix<double, 5, 1> {
      return leaning.col(0) + u * leaning.col(1) + u * u * leaning.col(2);
    };
    const auto born_inside = [&](double u) {
      return born_at(posed, {si<Length>(piece.from + u * h)});
    };
    /// How cut forces change in axes that turn by theta; that of N is small beside N.
    const auto in_turned_axes = [&](const Vector3d& theta, const BornForces& of) {
      BornForces change{-factor * theta.cross(of.force), -factor * theta.cross(of.moment)};
      if (!whole_) {
        change.force = {0.0, -factor * theta.z() * of.force.x(), factor * theta.y() * of.force.x()};
        change.moment.setZero();
      }
      change.force.x() = 0.0;
      return change;
    };
    const BornForces at_start =
        in_turned_axes(ends.segment<3>(3), born_at(posed, {si<Length>(piece.from), Side::behind}));
    const BornForces at_end =
        in_turned_axes(ends.segment<3>(9), born_at(posed, {si<Length>(piece.to), Side::before}));
    AddedCut cut;
    // The motions' moments stand half between straight and turned axes.
    cut.moments[0] = -added.segment<3>(3) + 0.5 * at_start.moment;
    cut.moments[3] = added.tail<3>() + 0.5 * at_end.moment;
    cut.forces[0] = -added.head<3>() + at_start.force;
    cut.forces[3] = -added.head<3>() + at_end.force;
    // Couples per length of the born forces on the bent axis, summed over each third by Gauss.
    const auto couple = [&](double u) -> Vector3d {
      Vector3d force = born_inside(u).force;
      if (!whole_) force.tail<2>().setZero();
      const Eigen::Matrix<double, 5, 1> of = leaning_at(u);
      return factor * Vector3d(0.0, of[0], of[1]).cross(force);
    };
    std::array<Vector3d, 4> sum{};
    sum[0].setZero();
    for (std::size_t third = 0; third < 3; ++third) {
      const double middle = (static_cast<double>(third) + 0.5) / 3.0, half = std::sqrt(0.6) / 6.0;
      sum[third + 1] = sum[third] + h / 3.0 *
                                        (5.0 * couple(middle - half) + 8.0 * couple(middle) +
                                         5.0 * couple(middle + half)) /
                                        18.0;
    }
    for (std::size_t k = 1; k < 3; ++k) {
      const double u = static_cast<double>(k) / 3.0;
      const auto between = [&](const Vector3d& a, const Vector3d& b) -> Vector3d {
        return (1.0 - u) * a + u * b;
      };
      const BornForces inside = in_turned_axes(leaning_at(u).tail<3>(), born_inside(u));
      cut.forces[k] = -added.head<3>() + inside.force;
      cut.moments[k] = between(cut.moments[0], cut.moments[3]) - (sum[k] - u * sum[3]) +
                       inside.moment - between(at_start.moment, at_end.moment);
    }
    return cut;
  }

  /// c_0 + c_1 x + c_2 x^2 + c_3 x^3 through values at 0, h/3, 2h/3 and h.
  static std::array<Vector3d, 4> cubic_through(const std::array<Vector3d, 4>& of, double h) {
    const auto& [a, b, c, d] = of;
    return {a, (-5.5 * a + 9.0 * b - 4.5 * c + d) / h,
            (9.0 * a - 22.5 * b + 18.0 * c - 4.5 * d) / (h * h),
            4.5 * (-a + 3.0 * b - 3.0 * c + d) / (h * h * h)};
  }

  /// The line load under which the cut forces of a piece are these.
  static LineLoad line_of(const AddedCut& cut, double from, double h) {
    LineLoad line;
    line.start = si<Length>(from);
    line.length = si<Length>(h);
    const std::array<Vector3d, 4> force = cubic_through(cut.forces, h),
                                  moment = cubic_through(cut.moments, h);
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector3d by_force = Vector3d::UnitX().cross(force[k]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<Index>(axis);
        line.couple[axis].c[k] = -by_force[i];
        if (k == 3) continue;
        const double power = static_cast<double>(k + 1);
        line.force[axis].c[k] = -power * force[k + 1][i];
        line.couple[axis].c[k] -= power * moment[k + 1][i];
      }
    }
    return line;
  }

  void load_first_beam(double factor, const VectorXd& moved, BentScene& result) const {
    const PosedBeam& posed = scene_->beams.front();
    const VibratingBeam& beam = *posed.beam;
    Index row = held_.rows().beams.front();
    const Station* station = beam.stations().data();
    double force = 0.0, moment = 0.0;
    std::vector<AddedCut> cuts;
    for (std::size_t p = 0; p < beam.pieces().size(); ++p) {
      const VibratingBeam::Piece& piece = beam.pieces()[p];
      const EndVector ends = moved.segment<12>(row);
      for (const Index at : {3, 9})
        result.turn = std::max(result.turn, ends.segment<3>(at).cwiseAbs().maxCoeff());
      const AddedCut& cut = cuts.emplace_back(added_in(piece, born_.front()[p], ends, factor));
      result.loads.lines.push_back(line_of(cut, piece.from, piece.to - piece.from));
      const BornForces born = born_at(posed, *station);
      force = std::max({force, cut.forces[0].norm(), cut.forces[3].norm(), born.force.norm()});
      moment = std::max({moment, cut.moments[0].norm(), cut.moments[3].norm(), born.moment.norm()});
      row += 6;
      station += piece.samples.size();
    }
    // What is in balance at a node but for round-off is no load.
    constexpr double round_off = 1e-10;
    for (std::size_t p = 0; p <= cuts.size(); ++p) {
      const Vector3d zero = Vector3d::Zero();
      PointLoad load;
      load.s = si<Length>(beam.nodes()[p]);
      load.force =
          (p > 0 ? cuts[p - 1].forces[3] : zero) - (p < cuts.size() ? cuts[p].forces[0] : zero);
      load.moment =
          (p > 0 ? cuts[p - 1].moments[3] : zero) - (p < cuts.size() ? cuts[p].moments[0] : zero);
      if (load.force.norm() > round_off * force || load.moment.norm() > round_off * moment)
        result.loads.points.push_back(load);
    }
  }

  const VibratingScene* scene_;
  HeldScene held_;
  std::vector<std::vector<BornPiece>> born_;  ///< of each beam
  VectorXd strained_;
  MatrixSum stress_;   ///< of forces and lines, between what is kept
  MatrixSum elastic_;  ///< ties
  bool whole_;         ///< the first beam
};

}  // namespace

std::optional<BentScene> bent_scene_of(const VibratingScene& scene, const SceneStress& stress,
                                       double factor, KeptTies& last) {
  return StressedScene(scene, stress, last).bent(factor);
}

}  // namespace boxbeam::frame
