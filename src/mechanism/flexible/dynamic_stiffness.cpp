#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <type_traits>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/response.hpp"

namespace boxbeam::flexible {
namespace {

/// Smallest pivot of the scaled border over the largest, below which it is singular.
constexpr double no_pivot = 1e-14;

/// Between two neighbouring elements: the part, and from the nodes of both to its spring.
template <class Scalar>
struct Between {
  PartFlexibility<Scalar> part;
  Scalar to_place;    ///< lever from the node of the element that is gathered
  Scalar from_other;  ///< and from the node of the other
};

/// `i` is gathered towards `next`, its neighbour.
template <class Scalar>
Between<Scalar> between(const LinkStiffness<Scalar>& link, std::size_t i, std::size_t next) {
  const PartFlexibility<Scalar> part = link.part(std::min(i, next));
  if (i < next) return {part, part.from_start, part.from_end};
  return {part, part.from_end, part.from_start};
}

/// The elements of a link in the order in which they are gathered, with the neighbour each goes to.
template <class Function>
void inward(std::size_t elements, std::size_t retained, const Function& f) {
  for (std::size_t i = 0; i < retained; ++i) f(i, i + 1);
  for (std::size_t i = elements - 1; i > retained; --i) f(i, i - 1);
}

template <class Function>
void outward(std::size_t elements, std::size_t retained, const Function& f) {
  for (std::size_t i = retained; i-- > 0;) f(i, i + 1);
  for (std::size_t i = retained + 1; i < elements; ++i) f(i, i - 1);
}

/// A part behind a spring may be in resonance by itself, the spring's far side held, though the
/// whole is not: its pivot is taken for no less than this, relative, and what that changes is given
/// back by refinement. So are digits where a pivot is less than `safe_pivot`. Source: Li, Demmel,
/// ACM Transactions on Mathematical Software 29 (2003), static pivoting.
constexpr double least_pivot = 1e-8;
constexpr double safe_pivot = 1e-2;
constexpr int refinements = 2;

/// What a pivot lacks to be at least `least_pivot`, its sign kept.
template <class Scalar>
Scalar missing(const Scalar& of, double size) {
  if (std::abs(of) >= least_pivot * size) return Scalar(0.0);
  if constexpr (std::is_same_v<Scalar, double>) {
    return std::copysign(least_pivot * size, of) - of;
  } else {
    return least_pivot * size - of;
  }
}

/// I + F D of bending.
template <class Scalar>
struct Pivot {
  Scalar a11, a12, a21, a22, det;
  double size;

  Pivot(const Scalar& f11, const Scalar& f12, const Scalar& f22, const NodeStiffness<Scalar>& D)
      : a11(1.0 + f11 * D.ww + f12 * D.wp),
        a12(f11 * D.wp + f12 * D.pp),
        a21(f12 * D.ww + f22 * D.wp),
        a22(1.0 + f12 * D.wp + f22 * D.pp),
        det(a11 * a22 - a12 * a21),
        size(std::abs(a11 * a22) + std::abs(a12 * a21)) {}
};

template <class Scalar>
void add(const NodeStiffness<Scalar>& of, NodeStiffness<Scalar>& sum) {
  sum.uu += of.uu;
  sum.up += of.up;
  sum.ww += of.ww;
  sum.wp += of.wp;
  sum.pp += of.pp;
}

/// Of a symmetric matrix that is nearly singular, where pivots lose a digit that turns do not:
/// those of a tridiagonal one, which are as many as its negative pivots. Source: Givens (1954);
/// Parlett, The Symmetric Eigenvalue Problem, 3.3 and 7.3.
std::size_t negative_eigenvalues_of(const Eigen::MatrixXd& matrix) {
  const Eigen::Tridiagonalization<Eigen::MatrixXd> tridiagonal(matrix);
  const Eigen::VectorXd diagonal = tridiagonal.diagonal(), beside = tridiagonal.subDiagonal();
  const double least = std::numeric_limits<double>::min();
  std::size_t negative = 0;
  double pivot = diagonal[0];
  for (Eigen::Index i = 0;;) {
    if (pivot < 0.0) ++negative;
    // Zero is taken for the least there is, as if the matrix were moved by that.
    if (std::abs(pivot) < least) pivot = least;
    if (++i == diagonal.size()) return negative;
    pivot = diagonal[i] - beside[i - 1] / pivot * beside[i - 1];
  }
}

/// What the nodes themselves do in a motion: (square M - K_g) q.
template <class Scalar>
LinkColumns<Scalar> resistance_of(const std::vector<LinkStiffness<Scalar>>& links,
                                  const LinkColumns<Scalar>& motion) {
  LinkColumns<Scalar> forces(motion.size());
  for (std::size_t k = 0; k < forces.size(); ++k) {
    forces[k].resize(3, motion[k].cols());
    for (std::size_t i = 0; i < links[k].nodes(); ++i) {
      const NodeStiffness<Scalar> node = links[k].node(i);
      const auto column = static_cast<Eigen::Index>(i);
      const auto q = motion[k].col(column);
      forces[k](0, column) = -(node.uu * q[0] + node.up * q[2]);
      forces[k](1, column) = -(node.ww * q[1] + node.wp * q[2]);
      forces[k](2, column) = -(node.up * q[0] + node.wp * q[1] + node.pp * q[2]);
    }
  }
  return forces;
}

}  // namespace

template <class Scalar>
DynamicStiffness<Scalar>::DynamicStiffness(const Structure& structure, double square, double omega)
    : structure_(&structure), square_(square), omega_(omega) {
  const int pieces = pieces_at(structure, square);
  if (pieces > 1) {
    finer_ = std::make_shared<const FinerStructure>(cut(structure, pieces));
    structure_ = &finer_->structure;
  }
  const std::size_t links = structure.links.size();
  for (std::size_t k = 0; k < links; ++k) {
    links_.push_back(link_stiffness_of<Scalar>(*structure_, k, square, omega));
  }
  retained_.assign(links, 0);
  list_ports();
  steps_.resize(links);
  stiffness_.resize(links);
  for (std::size_t k = 0; k < links; ++k) factor_link(k);
  factor_border();
}

template <class Scalar>
void DynamicStiffness<Scalar>::list_ports() {
  const Mechanism& mechanism = *structure_->mechanism;
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
    const Joint& joint = mechanism.joints[j];
    const Structure::Ends& ends = structure_->joints[j];
    for (int axis = 0; axis < 3; ++axis) {
      const auto of = static_cast<std::size_t>(axis);
      Scalar stiffness(joint.stiffness[of]);
      if constexpr (!std::is_same_v<Scalar, double>) {
        // An infinite stiffness stays real: its damping means nothing.
        if (std::isfinite(joint.stiffness[of])) {
          stiffness = Complex(joint.stiffness[of], omega_ * joint.damping[of]);
        }
      }
      if (stiffness == Scalar(0.0)) continue;
      const Scalar flexibility =
          std::isfinite(joint.stiffness[of]) ? Scalar(1.0) / stiffness : Scalar(0.0);
      const std::size_t row = rows_.size();
      rows_.push_back({j, axis, flexibility});
      for (const auto& [grip, sign] : {std::pair(&ends.a, 1.0), std::pair(&ends.b, -1.0)}) {
        if (grip->link == ground) continue;
        ports_.push_back({row, static_cast<std::size_t>(grip->link), grip->element, sign,
                          (ends.axes.row(axis) * grip->motion).transpose()});
      }
    }
  }
  // The element that most joints hold stays: their forces need not be taken along the link.
  std::vector<std::vector<int>> held(structure_->links.size());
  for (std::size_t k = 0; k < held.size(); ++k) {
    held[k].assign(structure_->links[k].elements.size(), 0);
  }
  for (const Port& port : ports_) ++held[port.link][port.element];
  for (std::size_t k = 0; k < held.size(); ++k) {
    retained_[k] = static_cast<std::size_t>(std::max_element(held[k].begin(), held[k].end()) -
                                            held[k].begin());
  }
}

template <class Scalar>
void DynamicStiffness<Scalar>::factor_link(std::size_t k) {
  const LinkStiffness<Scalar>& link = links_[k];
  const std::size_t n = link.nodes();
  std::vector<Step>& steps = steps_[k];
  steps.resize(n);
  NodeStiffness<Scalar> carried;  // what the chain at hand hands on to its next element
  NodeStiffness<Scalar> whole;    // at the element that stays
  inward(n, retained_[k], [&](std::size_t i, std::size_t next) {
    NodeStiffness<Scalar> D = carried;
    add(link.node(i), D);
    const Between<Scalar> at = between(link, i, next);
    const Scalar e = at.to_place;
    D.pp += e * (e * D.ww - 2.0 * D.wp);
    D.wp -= e * D.ww;
    Step& step = steps[i];
    const Scalar f = at.part.axial;
    const double axial_size = 1.0 + std::abs(f * D.uu);
    const Scalar axial_lack = missing(Scalar(1.0 + f * D.uu), axial_size);
    if (axial_lack != Scalar(0.0)) D.uu += axial_lack / f;
    const Scalar axial = 1.0 + f * D.uu;
    step.axial = 1.0 / axial;
    const Scalar f11 = at.part.f11;
    const Scalar f12 = at.part.f12;
    const Scalar f22 = at.part.f22;
    Pivot<Scalar> pivot(f11, f12, f22, D);
    const Scalar lack = missing(pivot.det, pivot.size);
    if (lack != Scalar(0.0)) {  // a little more or less of what D has anyway
      const Scalar by_ww = f11 * pivot.a22 - f12 * pivot.a12;
      const Scalar by_pp = f22 * pivot.a11 - f12 * pivot.a21;
      if (std::abs(by_ww * D.ww) >= std::abs(by_pp * D.pp)) {
        D.ww += lack / by_ww;
      } else {
        D.pp += lack / by_pp;
      }
      pivot = Pivot<Scalar>(f11, f12, f22, D);
    }
    const auto& [a11, a12, a21, a22, det, size] = pivot;
    smallest_pivot_ =
        std::min({smallest_pivot_, std::abs(axial) / axial_size, std::abs(det) / size});
    const Scalar inverse = 1.0 / det;
    step.b11 = a22 * inverse;
    step.b12 = -a12 * inverse;
    step.b21 = -a21 * inverse;
    step.b22 = a11 * inverse;
    if constexpr (std::is_same_v<Scalar, double>) {
      // Eigenvalues of I + F D, real for F without negative ones: the negative ones are counted.
      if (axial < 0.0) ++gathered_below_;
      if (det < 0.0) {
        ++gathered_below_;
      } else if (a11 + a22 < 0.0) {
        gathered_below_ += 2;
      }
    }
    NodeStiffness<Scalar> S;
    S.uu = D.uu * step.axial;
    S.ww = D.ww * step.b11 + D.wp * step.b21;
    S.wp = D.ww * step.b12 + D.wp * step.b22;
    S.pp = D.wp * step.b12 + D.pp * step.b22;
    const Scalar o = at.from_other;
    S.pp += o * (o * S.ww + 2.0 * S.wp);
    S.wp += o * S.ww;
    if (next == retained_[k]) {
      add(S, whole);
      carried = {};
    } else {
      carried = S;
    }
  });
  add(link.node(retained_[k]), whole);
  stiffness_[k] << whole.uu, Scalar(0.0), whole.up, Scalar(0.0), whole.ww, whole.wp, whole.up,
      whole.wp, whole.pp;
}

template <class Scalar>
typename DynamicStiffness<Scalar>::Gathered DynamicStiffness<Scalar>::gather(
    std::size_t k, const Eigen::Matrix<Scalar, 3, Eigen::Dynamic>& loads) const {
  const LinkStiffness<Scalar>& link = links_[k];
  const auto n = static_cast<std::size_t>(loads.cols());
  Gathered gathered;
  gathered.at_spring.resize(3, loads.cols());
  gathered.at_retained = loads.col(static_cast<Eigen::Index>(retained_[k]));
  Vector3 carried = Vector3::Zero();
  inward(n, retained_[k], [&](std::size_t i, std::size_t next) {
    const Between<Scalar> at = between(link, i, next);
    const Step& step = steps_[k][i];
    const auto column = static_cast<Eigen::Index>(i);
    const Scalar u = loads(0, column) + carried[0];
    const Scalar w = loads(1, column) + carried[1];
    const Scalar p = loads(2, column) + carried[2] - at.to_place * w;
    gathered.at_spring(0, column) = u;
    gathered.at_spring(1, column) = w;
    gathered.at_spring(2, column) = p;
    carried[0] = step.axial * u;
    carried[1] = step.b11 * w + step.b21 * p;
    carried[2] = step.b12 * w + step.b22 * p + at.from_other * carried[1];
    if (next != retained_[k]) return;
    gathered.at_retained += carried;
    carried.setZero();
  });
  return gathered;
}

template <class Scalar>
void DynamicStiffness<Scalar>::spread(std::size_t k, const Gathered& gathered,
                                      const Vector3& retained,
                                      Eigen::Matrix<Scalar, 3, Eigen::Dynamic>& motion) const {
  const LinkStiffness<Scalar>& link = links_[k];
  motion.resize(3, gathered.at_spring.cols());
  motion.col(static_cast<Eigen::Index>(retained_[k])) = retained;
  outward(link.nodes(), retained_[k], [&](std::size_t i, std::size_t next) {
    const Between<Scalar> at = between(link, i, next);
    const Step& step = steps_[k][i];
    const auto column = static_cast<Eigen::Index>(i);
    const auto other = static_cast<Eigen::Index>(next);
    const PartFlexibility<Scalar>& F = at.part;
    const Scalar g1 = gathered.at_spring(1, column);
    const Scalar g2 = gathered.at_spring(2, column);
    const Scalar u = motion(0, other) + F.axial * gathered.at_spring(0, column);
    const Scalar w =
        motion(1, other) + at.from_other * motion(2, other) + (F.f11 * g1 + F.f12 * g2);
    const Scalar p = motion(2, other) + (F.f12 * g1 + F.f22 * g2);
    motion(0, column) = step.axial * u;
    motion(2, column) = step.b21 * w + step.b22 * p;
    motion(1, column) = step.b11 * w + step.b12 * p - at.to_place * motion(2, column);
  });
}

template <class Scalar>
void DynamicStiffness<Scalar>::factor_border() {
  const std::size_t links = structure_->links.size();
  const auto fixed = static_cast<Eigen::Index>(3 * links);
  const auto size = fixed + static_cast<Eigen::Index>(rows_.size());
  border_ = Matrix::Zero(size, size);
  for (std::size_t k = 0; k < links; ++k) {
    const auto at = static_cast<Eigen::Index>(3 * k);
    border_.template block<3, 3>(at, at) = stiffness_[k];
  }
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    const Eigen::Index row = fixed + static_cast<Eigen::Index>(j);
    border_(row, row) -= rows_[j].flexibility;
  }
  Eigen::Matrix<Scalar, 3, Eigen::Dynamic> unit, motion;
  for (const Port& port : ports_) {
    const Eigen::Index row = fixed + static_cast<Eigen::Index>(port.row);
    const auto at = static_cast<Eigen::Index>(3 * port.link);
    Vector3 effect = port.h.template cast<Scalar>();
    if (port.element != retained_[port.link]) {
      const auto elements = static_cast<Eigen::Index>(structure_->links[port.link].elements.size());
      unit = Eigen::Matrix<Scalar, 3, Eigen::Dynamic>::Zero(3, elements);
      unit.col(static_cast<Eigen::Index>(port.element)) = port.h.template cast<Scalar>();
      const Gathered gathered = gather(port.link, unit);
      effect = gathered.at_retained;
      spread(port.link, gathered, Vector3::Zero(), motion);
      for (const Port& other : ports_) {
        if (other.link != port.link || other.element == retained_[port.link]) continue;
        const Eigen::Index to = fixed + static_cast<Eigen::Index>(other.row);
        const Vector3 there = motion.col(static_cast<Eigen::Index>(other.element));
        border_(to, row) -=
            other.sign * port.sign * (other.h.transpose().template cast<Scalar>() * there).value();
      }
    }
    border_.template block<3, 1>(at, row) -= port.sign * effect;
    border_.template block<1, 3>(row, at) -= port.sign * effect.transpose();
  }
  // Equilibrated: lengths, angles and forces become comparable, whatever the stiffnesses.
  // Begun at the joints' own stiffnesses, so that those of stiff joints side by side count.
  scale_ = Eigen::VectorXd::Ones(size);
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    const double flexibility = std::abs(rows_[j].flexibility);
    if (flexibility > 0.0) {
      scale_[fixed + static_cast<Eigen::Index>(j)] = 1.0 / std::sqrt(flexibility);
    }
  }
  const Eigen::MatrixXd rows = border_.cwiseAbs().transpose();
  bool even = false;
  for (int pass = 0; pass < 8 && !even; ++pass) {
    even = true;
    for (Eigen::Index i = 0; i < size; ++i) {
      const double largest = scale_[i] * rows.col(i).cwiseProduct(scale_).maxCoeff();
      if (!(largest > 0.0)) continue;
      scale_[i] /= std::sqrt(largest);
      even = even && 0.25 < largest && largest < 4.0;
    }
  }
  border_ = scale_.asDiagonal() * border_ * scale_.asDiagonal();
  // Full pivoting costs ten times as much and decides only where pivots are small.
  constexpr double clearly_regular = 1e-12;
  factor_.compute(border_);
  fully_pivoted_ = size > 0 && !(factor_.condition() > clearly_regular);
  if (!fully_pivoted_) return;
  lu_.compute(border_);
  const auto pivots = lu_.matrixLU().diagonal().cwiseAbs();
  if (size > 0 && !(pivots.minCoeff() > no_pivot * pivots.maxCoeff())) fail_singular();
}

template <class Scalar>
void DynamicStiffness<Scalar>::fail_singular() const {
  const std::vector<Link>& links = structure_->mechanism->links;
  const auto fixed = static_cast<Eigen::Index>(3 * links.size());
  Eigen::FullPivLU<Matrix> lu = lu_;
  lu.setThreshold(no_pivot);
  const Matrix kernel = lu.kernel();
  // Forces in balance among themselves, without any motion: rigid joints that hold the same twice.
  const auto part = [&](Eigen::Index from, Eigen::Index count) {
    return count > 0 ? kernel.middleRows(from, count).cwiseAbs().maxCoeff() : 0.0;
  };
  if (part(0, fixed) < 1e-8 * part(fixed, kernel.rows() - fixed)) {
    std::vector<std::string> joints;
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      const std::string& name = structure_->mechanism->joints[rows_[j].joint].name;
      if (part(fixed + static_cast<Eigen::Index>(j), 1) < 1e-6) continue;
      if (joints.empty() || joints.back() != name) joints.push_back(name);
    }
    throw AnalysisError(
        {fmt::format("rigid joints hold the same motion more than once, so that their forces are "
                     "not determined: {}; give one of them a stiffness there",
                     fmt::join(joints, ", ")),
         joints.empty() ? "" : joints.front(),
         {},
         {},
         {}});
  }
  if (square_ != 0.0) {
    const double frequency = std::sqrt(std::abs(square_)) / full_turn;
    throw AnalysisError(
        {fmt::format("the structure is in resonance at {:.6g} Hz and has no damping: its amplitude "
                     "grows without limit; take another frequency or give damping to links or "
                     "joints",
                     frequency),
         "",
         {},
         {},
         {}});
  }
  // The motion that nothing resists.
  std::vector<std::string> names;
  for (std::size_t k = 0; k < links.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(3 * k);
    const double largest = (scale_.asDiagonal() * kernel)
                               .topRows(static_cast<Eigen::Index>(3 * links.size()))
                               .cwiseAbs()
                               .maxCoeff();
    const double own =
        (scale_.segment<3>(at).asDiagonal() * kernel.middleRows(at, 3)).cwiseAbs().maxCoeff();
    if (own > 1e-6 * largest) names.push_back(links[k].name);
  }
  throw AnalysisError(
      {fmt::format(
           "the links can move without strain ({} free): {}; hold them by a joint, a spring "
           "or a drive",
           kernel.cols() == 1 ? "one motion is" : fmt::format("{} motions are", kernel.cols()),
           fmt::join(names, ", ")),
       names.empty() ? "" : names.front(),
       {},
       {},
       {}});
}

template <class Scalar>
Deformation<Scalar> DynamicStiffness<Scalar>::solve(const LinkColumns<Scalar>& loads) const {
  if (!finer_) return solve_resolved(loads);
  return at_coarse_nodes(*finer_, solve_resolved(at_finer_nodes(*finer_, loads)));
}

template <class Scalar>
Deformation<Scalar> DynamicStiffness<Scalar>::solve_resolved(
    const LinkColumns<Scalar>& loads) const {
  assert(loads.size() == structure_->links.size());
  Deformation<Scalar> result =
      solve_once(loads, Vector::Zero(static_cast<Eigen::Index>(rows_.size())));
  if (smallest_pivot_ >= safe_pivot) return result;
  for (int pass = 0; pass < refinements; ++pass) refine(loads, result);
  return result;
}

template <class Scalar>
LinkColumns<Scalar> DynamicStiffness<Scalar>::with_joint_forces(
    const LinkColumns<Scalar>& loads, const Deformation<Scalar>& of) const {
  LinkColumns<Scalar> sum = loads;
  for (const Port& port : ports_) {
    const Row& row = rows_[port.row];
    sum[port.link].col(static_cast<Eigen::Index>(port.element)) +=
        port.sign * of.joints(row.axis, static_cast<Eigen::Index>(row.joint)) *
        port.h.template cast<Scalar>();
  }
  return sum;
}

/// One step of iterative refinement. Forces of the springs are those that balance load, inertia and
/// joints from the ends inwards; motion follows from them outwards, every spring's law fulfilled.
/// What this motion has of inertia more than the one before is not in balance: a load.
template <class Scalar>
void DynamicStiffness<Scalar>::refine(const LinkColumns<Scalar>& loads,
                                      Deformation<Scalar>& result) const {
  const std::size_t links = structure_->links.size();
  LinkColumns<Scalar> borne = with_joint_forces(loads, result);
  const LinkColumns<Scalar> resisted = resistance_of(links_, result.motion);
  LinkColumns<Scalar> change(links);
  for (std::size_t k = 0; k < links; ++k) {
    const LinkStiffness<Scalar>& link = links_[k];
    Eigen::Matrix<Scalar, 3, Eigen::Dynamic>& force = borne[k];
    force += resisted[k];
    inward(link.nodes(), retained_[k], [&](std::size_t i, std::size_t next) {
      const Between<Scalar> at = between(link, i, next);
      auto own = force.col(static_cast<Eigen::Index>(i));
      auto other = force.col(static_cast<Eigen::Index>(next));
      own[2] -= at.to_place * own[1];
      other += own;
      other[2] += at.from_other * own[1];
    });
    Eigen::Matrix<Scalar, 3, Eigen::Dynamic>& motion = result.motion[k];
    change[k] = motion;
    outward(link.nodes(), retained_[k], [&](std::size_t i, std::size_t next) {
      const Between<Scalar> at = between(link, i, next);
      const auto far = motion.col(static_cast<Eigen::Index>(next));
      const Vector3 own = force.col(static_cast<Eigen::Index>(i));
      const PartFlexibility<Scalar>& F = at.part;
      Vector3 moved = far;
      moved[0] += F.axial * own[0];
      moved[2] += F.f12 * own[1] + F.f22 * own[2];
      moved[1] +=
          at.from_other * far[2] + (F.f11 * own[1] + F.f12 * own[2]) - at.to_place * moved[2];
      motion.col(static_cast<Eigen::Index>(i)) = moved;
    });
    change[k] = motion - change[k];
  }
  LinkColumns<Scalar> rest = resistance_of(links_, change);
  for (std::size_t k = 0; k < links; ++k) {
    rest[k].col(static_cast<Eigen::Index>(retained_[k])) =
        borne[k].col(static_cast<Eigen::Index>(retained_[k]));
  }
  Vector gaps = Vector::Zero(static_cast<Eigen::Index>(rows_.size()));
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    gaps[static_cast<Eigen::Index>(j)] =
        rows_[j].flexibility *
        result.joints(rows_[j].axis, static_cast<Eigen::Index>(rows_[j].joint));
  }
  for (const Port& port : ports_) {
    gaps[static_cast<Eigen::Index>(port.row)] +=
        port.sign * (port.h.transpose().template cast<Scalar>() *
                     result.motion[port.link].col(static_cast<Eigen::Index>(port.element)))
                        .value();
  }
  const Deformation<Scalar> more = solve_once(rest, gaps);
  for (std::size_t k = 0; k < links; ++k) result.motion[k] += more.motion[k];
  result.joints += more.joints;
}

template <class Scalar>
Deformation<Scalar> DynamicStiffness<Scalar>::solve_once(const LinkColumns<Scalar>& loads,
                                                         const Vector& gaps) const {
  const std::size_t links = structure_->links.size();
  const auto fixed = static_cast<Eigen::Index>(3 * links);
  Vector right = Vector::Zero(border_.rows());
  right.tail(gaps.size()) = gaps;
  std::vector<Gathered> gathered;
  gathered.reserve(links);
  std::vector<bool> inner(links, false);  // whether a joint holds an element that is gathered
  for (const Port& port : ports_) {
    if (port.element != retained_[port.link]) inner[port.link] = true;
  }
  Deformation<Scalar> result;
  result.motion.resize(links);
  for (std::size_t k = 0; k < links; ++k) {
    gathered.push_back(gather(k, loads[k]));
    right.template segment<3>(static_cast<Eigen::Index>(3 * k)) = gathered[k].at_retained;
    if (inner[k]) spread(k, gathered[k], Vector3::Zero(), result.motion[k]);
  }
  for (const Port& port : ports_) {
    if (port.element == retained_[port.link]) continue;
    const Vector3 there = result.motion[port.link].col(static_cast<Eigen::Index>(port.element));
    right[fixed + static_cast<Eigen::Index>(port.row)] +=
        port.sign * (port.h.transpose().template cast<Scalar>() * there).value();
  }
  const auto scaled = scale_.template cast<Scalar>();
  const auto solved = [&](const Vector& of) -> Vector {
    if (fully_pivoted_) return lu_.solve(of);
    return factor_.solve(of);
  };
  Vector unknown = solved(scaled.cwiseProduct(right));
  // One step of refinement, against what pivots of very different size lose.
  unknown += solved(scaled.cwiseProduct(right) - border_ * unknown);
  unknown = scaled.cwiseProduct(unknown).eval();

  result.joints = Eigen::Matrix<Scalar, 3, Eigen::Dynamic>::Zero(
      3, static_cast<Eigen::Index>(structure_->joints.size()));
  for (std::size_t j = 0; j < rows_.size(); ++j) {
    result.joints(rows_[j].axis, static_cast<Eigen::Index>(rows_[j].joint)) =
        unknown[fixed + static_cast<Eigen::Index>(j)];
  }
  LinkColumns<Scalar> with_joints;
  if (std::find(inner.begin(), inner.end(), true) != inner.end()) {
    with_joints = with_joint_forces(loads, result);
  }
  for (std::size_t k = 0; k < links; ++k) {
    const Vector3 retained = unknown.template segment<3>(static_cast<Eigen::Index>(3 * k));
    if (inner[k]) gathered[k] = gather(k, with_joints[k]);
    spread(k, gathered[k], retained, result.motion[k]);
  }
  return result;
}

template <class Scalar>
std::size_t DynamicStiffness<Scalar>::frequencies_below() const {
  if constexpr (std::is_same_v<Scalar, double>) {
    if (border_.rows() == 0) return 0;
    // Every force of a joint brings a negative one of its own, but one that pushes its ends apart
    // across its line.
    const auto holding = std::count_if(rows_.begin(), rows_.end(),
                                       [](const Row& row) { return row.flexibility >= 0.0; });
    constexpr double clear = 1e-8;
    const std::size_t negative =
        factor_.condition() > clear ? factor_.negative() : negative_eigenvalues_of(border_);
    return gathered_below_ + negative - static_cast<std::size_t>(holding);
  } else {
    assert(false);
    return 0;
  }
}

template class DynamicStiffness<double>;
template class DynamicStiffness<Complex>;

}  // namespace boxbeam::flexible
