#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "boxbeam/section/cut_forces.hpp"
#include "geometric_stiffness.hpp"
#include "held_scene.hpp"
#include "lowest_modes.hpp"
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

[[noreturn]] void refuse(const char* what) { throw AnalysisError({what, "beam", {}, {}, {}}); }

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

/// The load on the beam of a tie's end, whose force is so large.
void add_tie_load(const Tie& tie, const Tie::End& end, double size, double length,
                  BeamLoads& loads) {
  const double s = std::clamp(end.at.p.x(), 0.0, length);
  const Vector3d force = size * end.per.head<3>(),
                 couple =
                     size * end.per.tail<3>() + (end.at.p - Vector3d(s, 0.0, 0.0)).cross(force);
  auto same = std::find_if(loads.points.begin(), loads.points.end(), [&](const PointLoad& of) {
    return of.name == tie.name && of.s.value() == s && of.at == end.at.p.tail<2>();
  });
  if (same == loads.points.end()) {
    PointLoad load;
    load.s = si<Length>(s);
    load.at = end.at.p.tail<2>();
    load.name = tie.name;
    same = loads.points.insert(same, load);
  }
  same->force += force;
  same->moment += couple;
}

}  // namespace

namespace {

Matrix12 into_beam_axes(const PosedBeam& posed) {
  Matrix12 into = Matrix12::Zero();
  into.topLeftCorner<6, 6>() = into.bottomRightCorner<6, 6>() = rotation(posed.axes.transpose());
  return into;
}

/// In the middle of a piece.
double axial_force_in(const PosedBeam& posed, const VibratingBeam::Piece& piece) {
  return posed.rigid.at({si<Length>(0.5 * (piece.from + piece.to))}).N.value();
}

Matrix12 pressed_stiffness_of(const VibratingScene& scene, const PosedBeam& posed,
                              const VibratingBeam::Piece& piece) {
  if (scene.may_move > 0) return Matrix12::Zero();
  return geometric_block(axial_force_in(posed, piece), piece.to - piece.from);
}

/// Line loads that keep the forces on a piece's ends in balance, and the cut forces under them.
void add_inertia_of_piece(const Vector12& forces, const Vector12& by_axial_force, double from,
                          double h, BeamMode& mode) {
  constexpr Index N = cut_force::N, V_y = cut_force::V_y, V_z = cut_force::V_z, T = cut_force::T,
                  M_y = cut_force::M_y, M_z = cut_force::M_z;
  const Vector6 first = -forces.head<6>(), last = forces.tail<6>();
  // The axial force on the bent piece is a couple per length.
  const Vector6 turning = by_axial_force.head<6>() +
                          carry(Vector3d(h, 0.0, 0.0)).transpose() * by_axial_force.tail<6>();
  const double m_y = -turning[M_y] / h, m_z = -turning[M_z] / h;
  // q = a + b x:  V = V_0 - a x - b x^2/2,  M = M_0 + (V_0 - m) x - a x^2/2 - b x^3/6 as of M_y.
  struct Across {
    double a, b;
    Polynomial<4> V;
    Polynomial<5> M;
  };
  const auto across = [&](double V_0, double V_h, double M_0, double M_h, double m) {
    const double drop = V_0 - V_h, short_of = M_0 + (V_0 - m) * h - M_h;
    const double b = 12.0 * (0.5 * drop * h - short_of) / (h * h * h), a = drop / h - 0.5 * b * h;
    return Across{a, b, {{V_0, -a, -0.5 * b}}, {{M_0, V_0 - m, -0.5 * a, -b / 6.0}}};
  };
  const Across z = across(first[V_z], last[V_z], first[M_y], last[M_y], m_y),
               y = across(first[V_y], last[V_y], -first[M_z], -last[M_z], -m_z);
  LineLoad& line = mode.loads.lines.emplace_back();
  CutForcePiece& cut = mode.cut.pieces.emplace_back();
  cut.start = line.start = si<Length>(from);
  cut.length = line.length = si<Length>(h);
  line.force[0] = {{(first[N] - last[N]) / h}};
  line.force[1] = {{y.a, y.b}};
  line.force[2] = {{z.a, z.b}};
  line.couple = {{{{(first[T] - last[T]) / h}}, {{m_y}}, {{m_z}}}};
  cut.N = {{first[N], (last[N] - first[N]) / h}};
  cut.T = {{first[T], (last[T] - first[T]) / h}};
  cut.V_y = y.V;
  cut.M_z = -1.0 * y.M;
  cut.V_z = z.V;
  cut.M_y = z.M;
}

/// The motion as a mode, from its coordinates: what acts on the first beam but for ties, work and
/// energy.
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
      if (b == 0) {
        const double h = piece.to - piece.from;
        // What its neighbours do to its ends: elasticity, axial force and inertia together.
        const Vector12 by_axial_force = pressed_stiffness_of(scene, posed, piece) * ends;
        add_inertia_of_piece((piece.stiffness - omega * omega * piece.mass) * ends + by_axial_force,
                             by_axial_force, piece.from, h, mode);
      }
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

/// Calls f(block, row) for the diagonal blocks of a scene, which overlap along beams: 12 rows of a
/// piece, 6 of a body.
template <class OfPiece, class OfBody>
void each_block(const VibratingScene& scene, const SceneRows& rows, const OfPiece& of_piece,
                const OfBody& of_body) {
  for (std::size_t b = 0; b < scene.beams.size(); ++b) {
    Index row = rows.beams[b];
    for (const VibratingBeam::Piece& piece : scene.beams[b].beam->pieces()) {
      of_piece(scene.beams[b], piece, row);
      row += 6;
    }
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    of_body(scene.bodies[b], rows.bodies + static_cast<Index>(6 * b));
}

/// Forces that give a scene these accelerations, a column for each.
MatrixXd inertia_of(const VibratingScene& scene, const SceneRows& rows, const MatrixXd& motions) {
  MatrixXd forces = MatrixXd::Zero(motions.rows(), motions.cols());
  each_block(
      scene, rows,
      [&](const PosedBeam&, const VibratingBeam::Piece& piece, Index row) {
        forces.middleRows<12>(row) += piece.mass.lazyProduct(motions.middleRows<12>(row));
      },
      [&](const RigidMass& body, Index row) {
        forces.middleRows<3>(row) = body.mass * motions.middleRows<3>(row);
        forces.middleRows<3>(row + 3) = body.inertia.lazyProduct(motions.middleRows<3>(row + 3));
      });
  return forces;
}

/// Of a piece with what is counted of its axial force.
Matrix12 stiffness_of(const VibratingScene& scene, const PosedBeam& posed,
                      const VibratingBeam::Piece& piece) {
  return piece.stiffness + pressed_stiffness_of(scene, posed, piece);
}

/// The square of the frequency of a beam of the scene that bows by a parabola, the lowest.
double square_of_bending(const VibratingScene& scene) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const PosedBeam& posed : scene.beams) {
    // Shifts along y and z and the turns that go with them.
    for (const auto& [shift, turn, sign] :
         {std::tuple<Index, Index, double>{1, 5, 1.0}, {2, 4, -1.0}}) {
      double elastic = 0.0, moved = 0.0;
      for (const VibratingBeam::Piece& piece : posed.beam->pieces()) {
        Vector12 ends = Vector12::Zero();
        for (const auto& [at, s] : {std::pair<Index, double>{0, piece.from}, {6, piece.to}}) {
          ends[at + shift] = s * s;
          ends[at + turn] = 2.0 * sign * s;
        }
        elastic += ends.dot(piece.stiffness * ends);
        moved += ends.dot(piece.mass * ends);
      }
      if (moved > 0.0) lowest = std::min(lowest, elastic / moved);
    }
  }
  return lowest;
}

void add_masses_of_bodies(const HeldScene& held, double factor, MatrixSum& sum) {
  each_block(
      held.scene(), held.rows(), [](const PosedBeam&, const VibratingBeam::Piece&, Index) {},
      [&](const RigidMass& body, Index row) {
        const Index at = held.kept_row(row);
        sum.add(at, at, factor * body.mass * Matrix3d::Identity());
        sum.add(at + 3, at + 3, factor * body.inertia);
      });
}

[[noreturn]] void refuse_to_move(const VibratingScene& scene) {
  refuse(scene.may_move > 0 ? "it is free to move by more than what forces move, or without mass"
                            : "with its drivers held it is free to move, or buckles");
}

/// What moves without force is not strained, but by round-off.
void unload(BeamMode& mode) {
  mode.work.setZero();
  for (PointLoad& load : mode.loads.points) {
    load.force.setZero();
    load.moment.setZero();
  }
  for (LineLoad& line : mode.loads.lines) {
    line.force = {};
    line.couple = {};
  }
  for (CutForcePiece& piece : mode.cut.pieces) {
    piece.N = {};
    piece.T = {};
    piece.V_y = piece.V_z = {};
    piece.M_y = piece.M_z = {};
  }
}

/// A column for each mode, in the axes of the scene.
MatrixXd motions_of(const std::vector<BeamMode>& modes) {
  if (modes.empty()) return {};
  MatrixXd motions(modes.front().motion.size(), static_cast<Index>(modes.size()));
  for (Index j = 0; j < motions.cols(); ++j)
    motions.col(j) = modes[static_cast<std::size_t>(j)].motion;
  return motions;
}

/// Forces of elasticity and of viscosity.
struct ForcesOfMotion {
  VectorXd elastic, viscous;
};

ForcesOfMotion forces_of(const HeldScene& held, const VectorXd& coordinates) {
  ForcesOfMotion of{VectorXd::Zero(coordinates.size()), VectorXd::Zero(coordinates.size())};
  each_block(
      held.scene(), held.rows(),
      [&](const PosedBeam& posed, const VibratingBeam::Piece& piece, Index row) {
        const Vector12 ends = coordinates.segment<12>(row);
        of.elastic.segment<12>(row) += stiffness_of(held.scene(), posed, piece) * ends;
        of.viscous.segment<12>(row) += posed.beam->retardation() * piece.stiffness * ends;
      },
      [](const RigidMass&, Index) {});
  for (const Tied& tied : held.ties().elastic) {
    const double gap = tied.gap.of(coordinates);
    for (const auto& [row, per] : tied.gap.parts) {
      of.elastic.segment<6>(row) += tied.tie->stiffness * gap * per;
      of.viscous.segment<6>(row) += tied.tie->damping * gap * per;
    }
  }
  return of;
}

/// Of the ties the loads on the first beam, elastic energy and work. Modal mass one.
void add_ties(const HeldScene& held, const VectorXd& coordinates, const VectorXd& inertia,
              double omega, BeamMode& mode) {
  const SceneTies& ties = held.ties();
  const ForcesOfMotion of = forces_of(held, coordinates);
  mode.drag = in_scene_axes(held.scene(), held.rows(), of.viscous);
  mode.damping = coordinates.dot(of.viscous);
  const auto put = [&](const Tie& tie, double force) {
    for (const Tie::End& end : tie.ends)
      if (end.at.member == 0)
        add_tie_load(tie, end, force, held.scene().beams.front().beam->length(), mode.loads);
  };
  // What rigid ties do keeps the rest in motion; elastic ones oppose their gaps.
  const VectorXd sizes = held.tie_forces(of.elastic - omega * omega * inertia);
  for (std::size_t t = 0; t < ties.held.size(); ++t)
    put(*ties.held[t].tie, sizes[static_cast<Index>(t)]);
  for (const Tied& tied : ties.elastic) {
    const double gap = tied.gap.of(coordinates), force = tied.tie->stiffness * gap;
    put(*tied.tie, -force);
    if (omega > 0.0) mode.energy[4] += force * gap / (omega * omega);
  }
  const Index on_beams = mode.work.size();
  mode.work.conservativeResize(on_beams + static_cast<Index>(6 * ties.giving.size()));
  mode.work.tail(mode.work.size() - on_beams).setZero();
  for (std::size_t t = 0; t < ties.giving.size(); ++t)
    mode.work[on_beams + static_cast<Index>(6 * t) + ties.giving[t].tie->way()] =
        ties.giving[t].gap.of(coordinates);
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
  return modes_of(scene, count, last);
}

std::vector<BeamMode> modes_of(const VibratingScene& scene, std::size_t count, KeptTies& last) {
  const HeldScene held(scene, {}, last);
  const SceneRows& rows = held.rows();
  if (held.free() == 0) return {};
  // Where motions need no force, of K + shift M: its modes are the same.
  const double shift = scene.may_move > 0 ? square_of_bending(scene) : 0.0;
  SceneStiffness stiffness;
  for (const PosedBeam& posed : scene.beams) {
    auto& pieces = stiffness.pieces.emplace_back();
    for (const VibratingBeam::Piece& piece : posed.beam->pieces())
      pieces.push_back(stiffness_of(scene, posed, piece) + shift * piece.mass);
  }
  stiffness.beside = held.elastic_ties();
  if (shift > 0.0) add_masses_of_bodies(held, shift, stiffness.beside);
  const auto standing = held.standing(stiffness);
  if (!standing) refuse_to_move(scene);
  VectorXd unit(rows.size);
  for (Index k = 0; k < rows.size; ++k) unit[k] = unit_of_row(k, held.ties().length);
  const LowestModes found =
      lowest_modes_of({[&](const MatrixXd& forces) { return standing->moved_by(forces); },
                       [&](const MatrixXd& motions) { return inertia_of(scene, rows, motions); }},
                      static_cast<Index>(count), unit);
  const double round_off = 1e-15 * standing->stiffest();
  const auto own = static_cast<Index>(6 * scene.beams.front().beam->nodes().size());
  std::vector<BeamMode> modes;
  for (Index k = 0; k < found.mu.size(); ++k) {
    // Below it a shift leaves nothing that can be told from round-off.
    constexpr double none = 1e-7;
    double square = 1.0 / found.mu[k] - shift;
    if (square <= none * shift) square = 0.0;
    if (square == 0.0 && modes.size() >= scene.may_move) refuse_to_move(scene);
    const double omega = std::sqrt(square);
    const VectorXd coordinates = found.modes.col(k) / std::sqrt(found.mu[k]);
    // Of energy one half.
    if (round_off * found.modes.col(k).cwiseQuotient(unit).squaredNorm() > 1e-3)
      refuse_to_move(scene);
    const VectorXd inertia = inertia_of(scene, rows, coordinates);
    BeamMode& mode = modes.emplace_back(mode_of_coordinates(scene, rows, coordinates, omega));
    mode.motion = in_scene_axes(scene, rows, coordinates);
    mode.own_mass = coordinates.head(own).dot(inertia.head(own));
    add_ties(held, coordinates, inertia, omega, mode);
    if (omega == 0.0) unload(mode);
  }
  return modes;
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
      sum += ends.transpose() *
             geometric_block(axial_force_in(posed, piece), piece.to - piece.from) * ends;
    }
  }
  return sum;
}

MatrixXd masses_between(const VibratingScene& scene, const std::vector<BeamMode>& modes,
                        const std::vector<BeamMode>& others) {
  const SceneRows rows = rows_of(scene);
  MatrixXd motions = motions_of(modes), moved = motions_of(others);
  for (MatrixXd* const of : {&motions, &moved}) {
    for (std::size_t b = 0; b < scene.beams.size(); ++b) {
      const auto triples = static_cast<Index>(2 * scene.beams[b].beam->nodes().size());
      for (auto column : of->colwise()) {
        auto own = column.segment(rows.beams[b], 3 * triples).reshaped(3, triples);
        own = (scene.beams[b].axes.transpose() * own).eval();
      }
    }
  }
  return motions.transpose() * inertia_of(scene, rows, moved);
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
