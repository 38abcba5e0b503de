#include "moved_scene.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/cut_forces.hpp"
#include "geometric_stiffness.hpp"

namespace boxbeam::frame {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

using Matrix12 = VibratingBeam::Matrix12;
using Vector12 = Eigen::Matrix<double, 12, 1>;

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

/// Line loads that keep the forces on a piece's ends in balance, and the cut forces under them.
void add_inertia_of_piece(const Vector12& forces, const Vector12& by_axial_force, double from,
                          double h, BeamLoads& loads, CutForceDiagram& diagram) {
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
  LineLoad& line = loads.lines.emplace_back();
  CutForcePiece& cut = diagram.pieces.emplace_back();
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

}  // namespace

Matrix12 into_beam_axes(const PosedBeam& posed) {
  Matrix12 into = Matrix12::Zero();
  into.topLeftCorner<6, 6>() = into.bottomRightCorner<6, 6>() = rotation(posed.axes.transpose());
  return into;
}

Matrix12 geometric_stiffness_of(const PosedBeam& posed, const VibratingBeam::Piece& piece) {
  const Station middle{si<Length>(0.5 * (piece.from + piece.to))};
  return geometric_block(posed.rigid.at(middle).N.value(), piece.to - piece.from);
}

Matrix12 pressed_stiffness_of(const VibratingScene& scene, const PosedBeam& posed,
                              const VibratingBeam::Piece& piece) {
  if (!scene.pressed) return Matrix12::Zero();
  return geometric_stiffness_of(posed, piece);
}

MatrixXd inertia_of(const VibratingScene& scene, const SceneRows& rows,
                    const MatrixXd& accelerations) {
  MatrixXd forces = MatrixXd::Zero(accelerations.rows(), accelerations.cols());
  each_block(
      scene, rows,
      [&](const PosedBeam&, const VibratingBeam::Piece& piece, Index row) {
        forces.middleRows<12>(row) += piece.mass.lazyProduct(accelerations.middleRows<12>(row));
      },
      [&](const RigidMass& body, Index row) {
        forces.middleRows<3>(row) = body.mass * accelerations.middleRows<3>(row);
        forces.middleRows<3>(row + 3) =
            body.inertia.lazyProduct(accelerations.middleRows<3>(row + 3));
      });
  return forces;
}

ForcesOfMotion forces_of(const HeldScene& held, const VectorXd& moved) {
  ForcesOfMotion of{VectorXd::Zero(moved.size()), VectorXd::Zero(moved.size())};
  each_block(
      held.scene(), held.rows(),
      [&](const PosedBeam& posed, const VibratingBeam::Piece& piece, Index row) {
        const Vector12 ends = moved.segment<12>(row);
        of.elastic.segment<12>(row) +=
            (piece.stiffness + pressed_stiffness_of(held.scene(), posed, piece)) * ends;
        of.viscous.segment<12>(row) += posed.beam->retardation() * piece.stiffness * ends;
      },
      [](const RigidMass&, Index) {});
  for (const Tied& tied : held.ties().elastic) {
    const double gap = tied.gap.of(moved);
    for (const auto& [row, per] : tied.gap.parts) {
      of.elastic.segment<6>(row) += tied.tie->stiffness * gap * per;
      of.viscous.segment<6>(row) += tied.tie->damping * gap * per;
    }
  }
  return of;
}

void add_tie_load(const HeldScene& held, const Tie& tie, double force, BeamLoads& loads) {
  const double length = held.scene().beams.front().beam->length();
  for (const Tie::End& end : tie.ends)
    if (end.at.member == 0) add_tie_load(tie, end, force, length, loads);
}

void add_loads_on_first(const HeldScene& held, const MovedScene& of, const VectorXd& elastic,
                        BeamLoads& loads, CutForceDiagram& cut) {
  const VibratingScene& scene = held.scene();
  const PosedBeam& first = scene.beams.front();
  Index row = held.rows().beams.front();
  for (const VibratingBeam::Piece& piece : first.beam->pieces()) {
    const Vector12 ends = of.moved.segment<12>(row);
    // What its neighbours do to its ends: elasticity, axial force and inertia together.
    const Vector12 by_axial_force = pressed_stiffness_of(scene, first, piece) * ends;
    add_inertia_of_piece(
        piece.stiffness * ends + by_axial_force + piece.mass * of.accelerations.segment<12>(row),
        by_axial_force, piece.from, piece.to - piece.from, loads, cut);
    row += 6;
  }
  // What rigid ties do keeps the rest in motion; elastic ones oppose their gaps.
  const VectorXd sizes =
      held.tie_forces(elastic + inertia_of(scene, held.rows(), of.accelerations) - of.applied);
  const SceneTies& ties = held.ties();
  for (std::size_t t = 0; t < ties.held.size(); ++t)
    add_tie_load(held, *ties.held[t].tie, sizes[static_cast<Index>(t)], loads);
  for (const Tied& tied : ties.elastic)
    add_tie_load(held, *tied.tie, -tied.tie->stiffness * tied.gap.of(of.moved), loads);
  // Between nodes cut forces jump where a tie stands.
  const bool any_slides = std::any_of(scene.ties.begin(), scene.ties.end(), [](const Tie& tie) {
    return std::any_of(tie.ends.begin(), tie.ends.end(),
                       [](const Tie::End& end) { return end.slides && end.at.member == 0; });
  });
  if (any_slides) cut = cut_forces_of(loads);
}

double shift_of(const VibratingScene& scene) {
  return scene.may_move > 0 ? square_of_bending(scene) : 0.0;
}

std::optional<StandingScene> standing_with(const HeldScene& held, double shift,
                                           const MatrixXd& holding) {
  const VibratingScene& scene = held.scene();
  SceneStiffness stiffness;
  for (const PosedBeam& posed : scene.beams) {
    auto& pieces = stiffness.pieces.emplace_back();
    for (const VibratingBeam::Piece& piece : posed.beam->pieces())
      pieces.push_back(piece.stiffness + pressed_stiffness_of(scene, posed, piece) +
                       shift * piece.mass);
  }
  stiffness.beside = held.elastic_ties();
  if (shift > 0.0) add_masses_of_bodies(held, shift, stiffness.beside);
  return held.standing(stiffness, holding);
}

FactoredScene::Factors::Factors(VibratingScene of, KeptTies& last)
    : scene(std::move(of)), held(scene, {}, last), shift(shift_of(scene)) {
  if (held.free() == 0) return;
  standing = standing_with(held, shift);
  if (!standing) refuse_to_stand(scene);
}

FactoredScene::FactoredScene(VibratingScene scene, KeptTies& last)
    : factors_(std::make_shared<const Factors>(std::move(scene), last)) {}

const VibratingScene& FactoredScene::scene() const { return factors_->scene; }

void refuse_to_stand(const VibratingScene& scene) {
  const char* const what = scene.may_move > 0
                               ? "it is free to move by more than what forces move, or without mass"
                               : "with its drivers held it is free to move, or buckles";
  throw AnalysisError({what, "beam"});
}

MatrixXd in_beam_axes(const VibratingScene& scene, const SceneRows& rows, MatrixXd motions) {
  for (std::size_t b = 0; b < scene.beams.size(); ++b) {
    const auto triples = static_cast<Index>(2 * scene.beams[b].beam->nodes().size());
    const Matrix3d into = scene.beams[b].axes.transpose();
    for (auto motion : motions.colwise()) {
      auto own = motion.segment(rows.beams[b], 3 * triples).reshaped(3, triples);
      own = (into * own).eval();
    }
  }
  return motions;
}

MatrixXd motions_of(const std::vector<BeamMode>& modes) {
  if (modes.empty()) return {};
  MatrixXd motions(modes.front().motion.size(), static_cast<Index>(modes.size()));
  for (Index j = 0; j < motions.cols(); ++j)
    motions.col(j) = modes[static_cast<std::size_t>(j)].motion;
  return motions;
}

}  // namespace boxbeam::frame
