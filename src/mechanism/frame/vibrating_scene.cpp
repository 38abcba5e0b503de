#include <Eigen/Geometry>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "boxbeam/section/cut_forces.hpp"
#include "lowest_modes.hpp"
#include "moved_scene.hpp"
#include "rigid_arms.hpp"

namespace boxbeam::frame {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

using Matrix12 = VibratingBeam::Matrix12;
using Vector12 = Eigen::Matrix<double, 12, 1>;

/// Of a rigid body in its frame, a row and column for each component of its motion.
struct BodyTerms {
  Matrix6 of_rate = Matrix6::Zero(), of_size = Matrix6::Zero();
};

BodyTerms body_terms(double mass, const Matrix3d& inertia, const Turning& frame) {
  const Matrix3d w = skew(frame.omega);
  const TurningTerms turned = turning_terms_of(inertia, frame);
  BodyTerms terms;
  terms.of_rate.topLeftCorner<3, 3>() = 2.0 * mass * w;
  terms.of_size.topLeftCorner<3, 3>() = mass * (skew(frame.alpha) + w * w);
  terms.of_rate.bottomRightCorner<3, 3>() = turned.of_rate;
  terms.of_size.bottomRightCorner<3, 3>() = turned.of_size;
  return terms;
}

/// The motion as a mode, from its coordinates, of modal mass one: its work and energy.
BeamMode mode_of_coordinates(const VibratingScene& scene, const SceneRows& rows,
                             const VectorXd& coordinates, double omega) {
  constexpr Index N = cut_force::N, V_y = cut_force::V_y, V_z = cut_force::V_z, T = cut_force::T,
                  M_y = cut_force::M_y, M_z = cut_force::M_z;
  BeamMode mode;
  mode.frequency = omega / full_turn;
  Index values = 0;
  for (const PosedBeam& posed : scene.beams)
    values += static_cast<Index>(6 * posed.beam->stations().size());
  mode.work = VectorXd(values);
  Index at = 0;
  for (std::size_t b = 0; b < scene.beams.size(); ++b) {
    const PosedBeam& posed = scene.beams[b];
    Index row = rows.beams[b];
    for (const VibratingBeam::Piece& piece : posed.beam->pieces()) {
      const Vector12 ends = coordinates.segment<12>(row);
      row += 6;
      for (const VibratingBeam::Sample& sample : piece.samples) {
        const Vector6 strain = sample.strain * ends, force = sample.cut * ends;
        mode.work.segment<6>(at) = sample.weight * strain;
        at += 6;
        const Vector6 energy =
            omega > 0.0 ? Vector6(sample.weight * force.cwiseProduct(strain) / (omega * omega))
                        : Vector6(Vector6::Zero());
        if (b > 0) {
          mode.energy[5] += energy.sum();
          continue;
        }
        mode.energy[0] += energy[N];
        mode.energy[1] += energy[M_y] + energy[V_z];
        mode.energy[2] += energy[M_z] + energy[V_y];
        mode.energy[3] += energy[T];
      }
    }
  }
  return mode;
}

/// What moves without force is not strained, but by round-off.
void unload(BeamMode& mode) {
  mode.work.setZero();
  unload(mode.loads);
  for (CutForcePiece& piece : mode.cut.pieces) {
    piece.N = {};
    piece.T = {};
    piece.V_y = piece.V_z = {};
    piece.M_y = piece.M_z = {};
  }
}

/// Its loads and what viscosity does in it, the energy in its ties and the work on those that give
/// way.
void add_forces(const HeldScene& held, const VectorXd& coordinates, double omega, BeamMode& mode) {
  const SceneTies& ties = held.ties();
  const ForcesOfMotion of = forces_of(held, coordinates);
  mode.drag = in_scene_axes(held.scene(), held.rows(), of.viscous);
  mode.damping = coordinates.dot(of.viscous);
  if (omega > 0.0) {
    for (const Tied& tied : ties.elastic)
      mode.energy[4] +=
          tied.tie->stiffness * std::pow(tied.gap.of(coordinates), 2) / (omega * omega);
  }
  const Index on_beams = mode.work.size();
  mode.work.conservativeResize(on_beams + static_cast<Index>(6 * ties.giving.size()));
  mode.work.tail(mode.work.size() - on_beams).setZero();
  for (std::size_t t = 0; t < ties.giving.size(); ++t)
    mode.work[on_beams + static_cast<Index>(6 * t) + ties.giving[t].tie->way()] =
        ties.giving[t].gap.of(coordinates);
  add_loads_on_first(
      held, {coordinates, -omega * omega * coordinates, VectorXd::Zero(coordinates.size())},
      of.elastic, mode.loads, mode.cut);
}

}  // namespace

TurningTerms turning_terms_of(const Matrix3d& inertia, const Turning& frame) {
  const Matrix3d w = skew(frame.omega), spin = skew(inertia * frame.omega);
  const Vector3d change = inertia * frame.alpha + frame.omega.cross(inertia * frame.omega);
  return {inertia * w - spin + w * inertia,
          inertia * skew(frame.alpha) - spin * w + w * inertia * w - 0.5 * skew(change)};
}

std::vector<BeamMode> modes_of(const VibratingScene& scene, std::size_t count) {
  KeptTies last;
  return modes_of(FactoredScene(scene, last), count);
}

std::vector<BeamMode> modes_of(const FactoredScene& factored, std::size_t count) {
  const auto& [scene, held, shift, standing] = factored.factors();
  if (!standing) return {};
  const SceneRows& rows = held.rows();
  VectorXd unit(rows.size);
  for (Index k = 0; k < rows.size; ++k) unit[k] = unit_of_row(k, held.ties().length);
  const LowestModes found =
      lowest_modes_of({[&of = *standing](const MatrixXd& forces) { return of.moved_by(forces); },
                       [&scene = scene, &rows](const MatrixXd& motions) {
                         return inertia_of(scene, rows, motions);
                       }},
                      static_cast<Index>(count), unit);
  const double round_off = 1e-15 * standing->stiffest();
  const auto own = static_cast<Index>(6 * scene.beams.front().beam->nodes().size());
  std::vector<BeamMode> modes;
  for (Index k = 0; k < found.mu.size(); ++k) {
    // Below it a shift leaves nothing that can be told from round-off.
    constexpr double none = 1e-7;
    double square = 1.0 / found.mu[k] - shift;
    if (square <= none * shift) square = 0.0;
    if (square == 0.0 && modes.size() >= scene.may_move) refuse_to_stand(scene);
    const double omega = std::sqrt(square);
    const VectorXd coordinates = found.modes.col(k) / std::sqrt(found.mu[k]);
    // Of energy one half.
    if (round_off * found.modes.col(k).cwiseQuotient(unit).squaredNorm() > 1e-3)
      refuse_to_stand(scene);
    const VectorXd inertia = inertia_of(scene, rows, coordinates);
    BeamMode& mode = modes.emplace_back(mode_of_coordinates(scene, rows, coordinates, omega));
    mode.motion = in_scene_axes(scene, rows, coordinates);
    mode.own_mass = coordinates.head(own).dot(inertia.head(own));
    add_forces(held, coordinates, omega, mode);
    if (omega == 0.0) unload(mode);
  }
  return modes;
}

MatrixXd gaps_of(const VibratingScene& scene, const std::vector<BeamMode>& modes,
                 const std::vector<Tie>& ties) {
  const SceneRows rows = rows_of(scene);
  const MatrixXd motions = in_beam_axes(scene, rows, motions_of(modes));
  MatrixXd gaps(static_cast<Index>(ties.size()), motions.cols());
  for (std::size_t t = 0; t < ties.size(); ++t) {
    const Gap gap = gap_of(scene, rows, ties[t]);
    for (Index j = 0; j < motions.cols(); ++j)
      gaps(static_cast<Index>(t), j) = gap.of(motions.col(j));
  }
  return gaps;
}

MatrixXd geometric_stiffness_of(const VibratingScene& scene, const std::vector<BeamMode>& modes) {
  const SceneRows rows = rows_of(scene);
  const MatrixXd motions = motions_of(modes);
  MatrixXd sum = MatrixXd::Zero(motions.cols(), motions.cols());
  for (std::size_t b = 0; b < scene.beams.size(); ++b) {
    const PosedBeam& posed = scene.beams[b];
    const Matrix12 into = into_beam_axes(posed);
    Index row = rows.beams[b];
    for (const VibratingBeam::Piece& piece : posed.beam->pieces()) {
      const MatrixXd ends = into * motions.middleRows<12>(row);
      row += 6;
      sum += ends.transpose() * geometric_stiffness_of(posed, piece) * ends;
    }
  }
  return sum;
}

MatrixXd masses_between(const VibratingScene& scene, const std::vector<BeamMode>& modes,
                        const std::vector<BeamMode>& others) {
  const SceneRows rows = rows_of(scene);
  return in_beam_axes(scene, rows, motions_of(modes)).transpose() *
         inertia_of(scene, rows, in_beam_axes(scene, rows, motions_of(others)));
}

TurningTerms turning_terms_of(const VibratingScene& scene, const std::vector<BeamMode>& modes,
                              const std::vector<Turning>& frames) {
  const SceneRows rows = rows_of(scene);
  const auto count = static_cast<Index>(modes.size());
  TurningTerms sum{MatrixXd::Zero(count, count), MatrixXd::Zero(count, count)};
  /// `motions`: a column for each mode.
  const auto add = [&](const BodyTerms& of, const MatrixXd& motions) {
    sum.of_rate += motions.transpose() * of.of_rate * motions;
    sum.of_size += motions.transpose() * of.of_size * motions;
  };
  const MatrixXd motions = motions_of(modes);
  for (std::size_t b = 0; b < scene.beams.size(); ++b) {
    const PosedBeam& posed = scene.beams[b];
    const Matrix12 into = into_beam_axes(posed);
    const Turning own{posed.axes.transpose() * frames[b].omega,
                      posed.axes.transpose() * frames[b].alpha};
    Index row = rows.beams[b];
    for (const VibratingBeam::Piece& piece : posed.beam->pieces()) {
      const MatrixXd ends = into * motions.middleRows<12>(row);
      row += 6;
      for (const VibratingBeam::Sample& sample : piece.samples) {
        add(body_terms(sample.weight * sample.mass, sample.weight * sample.inertia, own),
            sample.motion * ends);
      }
    }
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    add(body_terms(scene.bodies[b].mass, scene.bodies[b].inertia, frames[scene.beams.size() + b]),
        motions.middleRows<6>(rows.bodies + static_cast<Index>(6 * b)));
  }
  return sum;
}

VectorXd shape_on_beams(const VibratingScene& scene, const BeamMode& mode) {
  const SceneRows rows = rows_of(scene);
  Index stations = 0;
  for (const PosedBeam& posed : scene.beams)
    stations += static_cast<Index>(posed.beam->stations().size());
  VectorXd shape(4 * stations);
  Index at = 0;
  for (std::size_t b = 0; b < scene.beams.size(); ++b) {
    const Matrix12 into = into_beam_axes(scene.beams[b]);
    Index row = rows.beams[b];
    for (const VibratingBeam::Piece& piece : scene.beams[b].beam->pieces()) {
      const Vector12 ends = into * mode.motion.segment<12>(row);
      row += 6;
      for (const VibratingBeam::Sample& sample : piece.samples) {
        const Vector6 motion = sample.motion * ends;
        shape.segment<3>(at) = std::sqrt(sample.weight * sample.mass) * motion.head<3>();
        shape[at + 3] = std::sqrt(sample.weight * sample.inertia(0, 0)) * motion[3];
        at += 4;
      }
    }
  }
  return shape;
}

}  // namespace boxbeam::frame
