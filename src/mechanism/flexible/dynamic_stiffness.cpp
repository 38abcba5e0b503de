#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>

#include "boxbeam/mechanism/flexible/response.hpp"
#include "gathering.hpp"

namespace boxbeam::flexible {
namespace {

/// Digits are lost where a pivot is less than this: they are given back by so many refinements.
constexpr double safe_pivot = 1e-2;
constexpr int refinements = 2;

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

template class DynamicStiffness<double>;
template class DynamicStiffness<Complex>;

}  // namespace boxbeam::flexible
