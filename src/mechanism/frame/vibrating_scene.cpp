#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/frame/beam_vibration.hpp"
#include "boxbeam/section/cut_forces.hpp"
#include "geometric_stiffness.hpp"
#include "rigid_arms.hpp"
#include "rigid_ties.hpp"
#include "scene_matrices.hpp"

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

SceneRows rows_of(const VibratingScene& scene) {
  SceneRows rows;
  for (const PosedBeam& posed : scene.beams) {
    rows.beams.push_back(rows.bodies);
    rows.bodies += static_cast<Index>(6 * posed.beam->nodes().size());
  }
  rows.size = rows.bodies + static_cast<Index>(6 * scene.bodies.size());
  return rows;
}

Matrix12 into_beam_axes(const PosedBeam& posed) {
  Matrix12 into = Matrix12::Zero();
  into.topLeftCorner<6, 6>() = into.bottomRightCorner<6, 6>() = rotation(posed.axes.transpose());
  return into;
}

namespace {

/// In the middle of a piece.
double axial_force_in(const PosedBeam& posed, const VibratingBeam::Piece& piece) {
  return posed.rigid.at({si<Length>(0.5 * (piece.from + piece.to))}).N.value();
}

}  // namespace

Followed followed_by(const VibratingScene& scene, const SceneRows& rows, const Place& at) {
  const auto member = static_cast<std::size_t>(at.member);
  if (member >= scene.beams.size()) {
    const std::size_t body = member - scene.beams.size();
    return {rows.bodies + static_cast<Index>(6 * body), scene.bodies[body].centre};
  }
  const PosedBeam& posed = scene.beams[member];
  const std::size_t node = posed.beam->node_of(posed.axes.col(0).dot(at.p - posed.start));
  return {rows.beams[member] + static_cast<Index>(6 * node),
          posed.start + posed.beam->nodes()[node] * posed.axes.col(0)};
}

namespace {

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

/// The motion as a mode: what acts on the first beam but for ties, work and energy.
BeamMode mode_of_motion(const VibratingScene& scene, const SceneRows& rows, const VectorXd& motion,
                        double omega) {
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
    const Matrix12 into = into_beam_axes(posed);
    Index row = rows.beams[b];
    for (const VibratingBeam::Piece& piece : posed.beam->pieces()) {
      const Vector12 ends = into * motion.segment<12>(row);
      row += 6;
      if (b == 0) {
        const double h = piece.to - piece.from;
        // What its neighbours do to its ends: elasticity, axial force and inertia together.
        const Vector12 by_axial_force = geometric_block(axial_force_in(posed, piece), h) * ends;
        add_inertia_of_piece((piece.stiffness - omega * omega * piece.mass) * ends + by_axial_force,
                             by_axial_force, piece.from, h, mode);
      }
      for (const VibratingBeam::Sample& sample : piece.samples) {
        const Vector6 strain = sample.strain * ends, force = sample.cut * ends;
        mode.work.segment<6>(at) = sample.weight * strain;
        at += 6;
        const Vector6 energy = sample.weight * force.cwiseProduct(strain) / (omega * omega);
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

/// The largest of the diagonal, shifts by this length.
double stiffest_entry_of(const Eigen::SparseMatrix<double>& stiffness, double length) {
  const VectorXd diagonal = stiffness.diagonal();
  double largest = 0.0;
  for (Index k = 0; k < diagonal.size(); ++k)
    largest = std::max(largest, diagonal[k] * (k % 6 < 3 ? length * length : 1.0));
  return largest;
}

}  // namespace

SceneMatrices matrices_of(const VibratingScene& scene, const SceneRows& rows, bool pressed) {
  const Index size = rows.size;
  MatrixSum stiff, inert, viscous, sprung;
  double length = 0.0;
  for (std::size_t b = 0; b < scene.beams.size(); ++b) {
    const PosedBeam& posed = scene.beams[b];
    const Matrix12 into = into_beam_axes(posed);
    length = std::max(length, posed.beam->length());
    Index row = rows.beams[b];
    for (const VibratingBeam::Piece& piece : posed.beam->pieces()) {
      const auto add = [&](const Matrix12& of, MatrixSum& sum) {
        sum.add(row, row, into.transpose() * of * into);
      };
      const double N = pressed ? axial_force_in(posed, piece) : 0.0;
      add(piece.stiffness + geometric_block(N, piece.to - piece.from), stiff);
      add(piece.mass, inert);
      add(posed.beam->retardation() * piece.stiffness, viscous);
      row += 6;
    }
  }
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Index at = rows.bodies + static_cast<Index>(6 * b);
    inert.add(at, at, scene.bodies[b].mass * Matrix3d::Identity());
    inert.add(at + 3, at + 3, scene.bodies[b].inertia);
  }
  SceneMatrices all;
  const Eigen::SparseMatrix<double> of_beams = stiff.of_size(size, size);
  const double as_rigid = stiff_as_rigid * stiffest_entry_of(of_beams, length);
  for (const Tie& tie : scene.ties) {
    Gap gap;
    for (const Tie::End& end : tie.ends) {
      if (end.at.member == ground) continue;
      const Followed by = followed_by(scene, rows, end.at);
      gap.add(by.row, carry(end.at.p - by.from).transpose() * end.per);
    }
    if (tie.rigid) all.giving.push_back({&tie, gap});
    if (tie.stiffness * (tie.way() == 0 ? length * length : 1.0) > as_rigid) {
      all.held.push_back({&tie, std::move(gap)});
      continue;
    }
    for (const auto& [row, per_row] : gap.parts) {
      for (const auto& [column, per_column] : gap.parts) {
        const Matrix6 both = per_row * per_column.transpose();
        if (tie.stiffness != 0.0) sprung.add(row, column, tie.stiffness * both);
        if (tie.damping != 0.0) viscous.add(row, column, tie.damping * both);
      }
    }
    all.elastic.push_back({&tie, std::move(gap)});
  }
  all.springs = sprung.of_size(size, size);
  all.K = of_beams + all.springs;
  all.M = inert.of_size(size, size);
  all.C = viscous.of_size(size, size);
  all.unit = VectorXd::Ones(size);
  for (Index k = 0; k < size; ++k)
    if (k % 6 < 3) all.unit[k] = length;
  return all;
}

Eigen::SparseMatrix<double> equations_of(const std::vector<Tied>& held, const VectorXd& unit,
                                         VectorXd& norms) {
  const auto count_held = static_cast<Index>(held.size());
  norms = VectorXd::Ones(count_held);
  MatrixSum holding;
  for (std::size_t k = 0; k < held.size(); ++k) {
    const auto column = static_cast<Index>(k);
    const auto scaled = [&](const std::pair<Index, Vector6>& part) {
      return Vector6(part.second.cwiseProduct(unit.segment<6>(part.first)));
    };
    double square = 0.0;
    for (const auto& part : held[k].gap.parts) square += scaled(part).squaredNorm();
    // Of the ground alone: nothing moves.
    if (square > 0.0) norms[column] = std::sqrt(square);
    // Also what is zero in this posture alone: the same entries in all of them. Couples hold no
    // shifts in any.
    for (const auto& part : held[k].gap.parts) {
      const Vector6 entries = scaled(part) / norms[column];
      const Index first = entries.head<3>().isZero(0.0) ? 3 : 0;
      for (Index i = first; i < 6; ++i)
        holding.entries.emplace_back(part.first + i, column, entries[i]);
    }
  }
  return holding.of_size(unit.size(), count_held);
}

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
  const SceneRows rows = rows_of(scene);
  const SceneMatrices all = matrices_of(scene, rows);
  VectorXd norms;
  const RigidTies rigidly(equations_of(all.held, all.unit, norms), last);
  if (rigidly.free() == 0) return {};
  const auto reduced = [&](const Eigen::SparseMatrix<double>& of) {
    return rigidly.reduced(
        Eigen::SparseMatrix<double>(all.unit.asDiagonal() * of * all.unit.asDiagonal()));
  };
  const MatrixXd stiffness = reduced(all.K), mass = reduced(all.M);
  const Eigen::LLT<MatrixXd> factor(stiffness);
  if (factor.info() != Eigen::Success)
    refuse("with its drivers held it is free to move, or buckles");
  // Of M x = mu K x the largest mu are those of the lowest frequencies; what has no mass has none.
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(mass, stiffness);
  if (solver.info() != Eigen::Success) refuse("its modes are not found");
  const double round_off = 1e-15 * stiffness.norm();
  const VibratingBeam& first = *scene.beams.front().beam;
  std::vector<BeamMode> modes;
  for (Index k = stiffness.rows(); k-- > 0 && modes.size() < count;) {
    const double mu = solver.eigenvalues()[k];
    if (!(mu > 1e-12 * solver.eigenvalues()[stiffness.rows() - 1])) break;
    const VectorXd x = solver.eigenvectors().col(k);  // of elastic energy one half
    if (round_off * x.squaredNorm() > 1e-3) refuse("with its drivers held it is free to move");
    const VectorXd motion = rigidly.motion(x).cwiseProduct(all.unit) / std::sqrt(mu);
    BeamMode& mode = modes.emplace_back(mode_of_motion(scene, rows, motion, 1.0 / std::sqrt(mu)));
    mode.motion = motion;
    mode.drag = all.C * motion;
    mode.damping = motion.dot(mode.drag);
    mode.energy[4] = mu * motion.dot(all.springs * motion);
    const Index on_beams = mode.work.size();
    mode.work.conservativeResize(on_beams + static_cast<Index>(6 * all.giving.size()));
    mode.work.tail(mode.work.size() - on_beams).setZero();
    for (std::size_t t = 0; t < all.giving.size(); ++t)
      mode.work[on_beams + static_cast<Index>(6 * t) + all.giving[t].tie->way()] =
          all.giving[t].gap.of(motion);
    const auto own = static_cast<Index>(6 * first.nodes().size());
    mode.own_mass = motion.head(own).dot((all.M * motion).head(own));
    // What rigid ties do keeps the rest in motion; elastic ones oppose their gaps.
    const auto put = [&](const Tie& tie, double force) {
      for (const Tie::End& end : tie.ends)
        if (end.at.member == 0) add_tie_load(tie, end, force, first.length(), mode.loads);
    };
    const VectorXd by_ties = all.K * motion - all.M * motion / mu;
    const VectorXd sizes = rigidly.forces(by_ties.cwiseProduct(all.unit)).cwiseQuotient(norms);
    for (std::size_t t = 0; t < all.held.size(); ++t)
      put(*all.held[t].tie, sizes[static_cast<Index>(t)]);
    for (const Tied& of : all.elastic) put(*of.tie, -of.tie->stiffness * of.gap.of(motion));
  }
  return modes;
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
  MatrixXd motions(rows.size, count);
  for (Index j = 0; j < count; ++j) motions.col(j) = modes[static_cast<std::size_t>(j)].motion;
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
