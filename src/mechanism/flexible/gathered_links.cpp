// Elements of links gathered at the one that stays.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "boxbeam/mechanism/flexible/response.hpp"
#include "gathering.hpp"

namespace boxbeam::flexible {
namespace {

/// A part behind a spring may be in resonance by itself, the spring's far side held, though the
/// whole is not: its pivot is taken for no less than this, relative, and what that changes is given
/// back by refinement. Source: Li, Demmel, ACM Transactions on Mathematical Software 29 (2003),
/// static pivoting.
constexpr double least_pivot = 1e-8;

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

}  // namespace

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

template void DynamicStiffness<double>::factor_link(std::size_t);
template void DynamicStiffness<Complex>::factor_link(std::size_t);
template DynamicStiffness<double>::Gathered DynamicStiffness<double>::gather(
    std::size_t, const Eigen::Matrix<double, 3, Eigen::Dynamic>&) const;
template DynamicStiffness<Complex>::Gathered DynamicStiffness<Complex>::gather(
    std::size_t, const Eigen::Matrix<Complex, 3, Eigen::Dynamic>&) const;
template void DynamicStiffness<double>::spread(std::size_t, const Gathered&, const Vector3&,
                                               Eigen::Matrix<double, 3, Eigen::Dynamic>&) const;
template void DynamicStiffness<Complex>::spread(std::size_t, const Gathered&, const Vector3&,
                                                Eigen::Matrix<Complex, 3, Eigen::Dynamic>&) const;

}  // namespace boxbeam::flexible
