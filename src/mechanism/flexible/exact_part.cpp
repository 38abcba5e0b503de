#include "exact_part.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/flexible/response.hpp"
#include "stretch_at.hpp"

namespace boxbeam::flexible {
namespace {

/// Coefficients about a place `by` behind the start of a polynomial, in shares of h.
template <int Degree>
Polynomial<Degree> in_shares(const Polynomial<Degree>& of, double by, double h) {
  Polynomial<Degree> result = of;
  for (std::size_t i = 0; i + 1 < of.size; ++i) {  // Horner's scheme, repeated
    for (std::size_t k = of.size - 1; k-- > i;) result.c[k] += by * result.c[k + 1];
  }
  double power = 1.0;
  for (double& c : result.c) {
    c *= power;
    power *= h;
  }
  return result;
}

/// Term n of a product with a polynomial.
template <int Degree, class Series>
auto product_term(const Polynomial<Degree>& p, const Series& of, int n) {
  typename Series::value_type sum{};
  for (int j = 0; j <= std::min(n, Degree); ++j) {
    sum += p.c[static_cast<std::size_t>(j)] * of[static_cast<std::size_t>(n - j)];
  }
  return sum;
}

/// Term n of `of` divided by a polynomial, of which the terms before are known.
template <int Degree, class Series>
auto quotient_term(const Polynomial<Degree>& p, const Series& of, const Series& quotient, int n) {
  auto rest = of[static_cast<std::size_t>(n)];
  for (int j = 1; j <= std::min(n, Degree); ++j) {
    rest -= p.c[static_cast<std::size_t>(j)] * quotient[static_cast<std::size_t>(n - j)];
  }
  return rest / p.c[0];
}

template <class Series>
auto value_at(const Series& of, int terms, double share) {
  typename Series::value_type sum{};
  for (int n = terms; n >= 0; --n) sum = sum * share + of[static_cast<std::size_t>(n)];
  return sum;
}

/// Counts terms of a sum that no longer change it. The first that counts is among the first eight.
class Idle {
 public:
  template <class... Scalar>
  bool after(const Scalar&... terms) {
    const double size = (std::abs(terms) + ...);
    largest_ = std::max(largest_, size);
    idle_ = size <= 1e-19 * largest_ ? idle_ + 1 : 0;
    return idle_ > 8;
  }

 private:
  double largest_ = 0.0;
  int idle_ = 0;
};

/// Largest and smallest of a polynomial, as three places tell.
template <int Degree>
std::pair<double, double> range_of(const Polynomial<Degree>& p, double from, double h) {
  const double values[] = {p(from), p(from + 0.5 * h), p(from + h)};
  const auto [least, most] = std::minmax_element(std::begin(values), std::end(values));
  return {*least, *most};
}

bool converges_when_divided(const Polynomial<4>& modulus, double by, double h) {
  const Polynomial<4> twice = in_shares(modulus, by, 2.0 * h);
  double sum = 0.0;
  for (std::size_t j = 1; j < twice.size; ++j) sum += std::abs(twice.c[j]);
  return sum <= twice.c[0];
}

}  // namespace

bool resolves(const Link& link, double from, double to, double square) {
  const LinkStretch& of = *stretch_at(link, 0.5 * (from + to));
  const double x = from - of.start;
  const double h = to - from;
  const double z = std::abs(square);
  const double mass = range_of(of.mass, x, h).second;
  if (link.kind != LinkKind::bending) {
    if (!converges_when_divided(of.EA, x, h)) return false;
    if (z * mass * h * h > range_of(of.EA, x, h).first) return false;
  }
  if (link.kind == LinkKind::axial) return true;
  if (!converges_when_divided(of.EI, x, h) || !converges_when_divided(of.GA, x, h)) return false;
  const double EI = range_of(of.EI, x, h).first;
  const double GA = range_of(of.GA, x, h).first;
  const double rotary = range_of(of.rotary, x, h).second;
  return z * h * h * (mass * h * h / EI + mass / GA + rotary / EI) <= 1.0;
}

template <class Scalar>
ExactPart<Scalar>::ExactPart(const Link& link, double from, double to, const Scalar& z)
    : from_(from),
      h_(to - from),
      z_(z),
      stretches_(link.kind != LinkKind::bending),
      bends_(link.kind != LinkKind::axial) {
  const LinkStretch& of = *stretch_at(link, 0.5 * (from + to));
  if (stretches_) {
    stretch(link, of);
  } else {
    carry_along(of);
  }
  if (bends_) {
    bend(link, of);
  } else {
    carry_across(of);
  }
}

template <class Scalar>
typename ExactPart<Scalar>::Along ExactPart<Scalar>::axial_from(const LinkStretch& of, double u,
                                                                double n) const {
  const double x = from_ - of.start;
  const Polynomial<4> EA = in_shares(of.EA, x, h_);
  const Polynomial<2> mass = in_shares(of.mass, x, h_);
  Along along;
  Series strain{}, dstrain{}, force{}, sum{};
  along.u[0] = u;
  force[0] = n;
  Idle still, moving;
  for (int k = 0; k < most_terms; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double step = h_ / (k + 1);
    strain[i] = quotient_term(EA, force, strain, k);
    dstrain[i] = quotient_term(EA, along.dforce, dstrain, k);
    sum[i] = along.u[i] + along.du[i];
    along.u[i + 1] = step * strain[i];
    along.du[i + 1] = step * dstrain[i];
    along.dforce[i + 1] = -step * z_ * product_term(mass, sum, k);
    along.terms = k + 1;
    const bool done = still.after(along.u[i + 1]);
    if (moving.after(along.du[i + 1]) && done) break;
  }
  return along;
}

template <class Scalar>
typename ExactPart<Scalar>::Along ExactPart<Scalar>::bending_from(const LinkStretch& of, double w,
                                                                  double phi, double Q,
                                                                  double m) const {
  const double x = from_ - of.start;
  const Polynomial<4> EI = in_shares(of.EI, x, h_);
  const Polynomial<4> GA = in_shares(of.GA, x, h_);
  const Polynomial<2> mass = in_shares(of.mass, x, h_);
  const Polynomial<4> rotary = in_shares(of.rotary, x, h_);
  Along along;
  Series shear{}, dshear{}, bow{}, dbow{}, force{}, moment{}, shift{}, turn{};
  along.u[0] = w;
  along.phi[0] = phi;
  force[0] = Q;
  moment[0] = m;
  moment[1] = -h_ * Q;
  Idle still, moving;
  for (int k = 0; k < most_terms; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double step = h_ / (k + 1);
    shear[i] = quotient_term(GA, force, shear, k);
    dshear[i] = quotient_term(GA, along.dforce, dshear, k);
    bow[i] = quotient_term(EI, moment, bow, k);
    dbow[i] = quotient_term(EI, along.dm, dbow, k);
    shift[i] = along.u[i] + along.du[i];
    turn[i] = along.phi[i] + along.dphi[i];
    along.u[i + 1] = step * (along.phi[i] + shear[i]);
    along.phi[i + 1] = step * bow[i];
    along.du[i + 1] = step * (along.dphi[i] + dshear[i]);
    along.dphi[i + 1] = step * dbow[i];
    along.dforce[i + 1] = -step * z_ * product_term(mass, shift, k);
    along.dm[i + 1] = -step * (along.dforce[i] + z_ * product_term(rotary, turn, k));
    along.terms = k + 1;
    const bool done = still.after(along.u[i + 1], h_ * along.phi[i + 1]);
    if (moving.after(along.du[i + 1], h_ * along.dphi[i + 1]) && done) break;
  }
  return along;
}

template <class Scalar>
void ExactPart<Scalar>::stretch(const Link&, const LinkStretch& of) {
  axial_ = {axial_from(of, 1.0, 0.0), axial_from(of, 0.0, 1.0)};
  const auto& [by_u, by_n] = axial_;
  between.axial = value_at(by_n.u, by_n.terms, 1.0) + value_at(by_n.du, by_n.terms, 1.0);
  start.uu = value_at(by_u.du, by_u.terms, 1.0) / between.axial;
  end.uu = value_at(by_n.dforce, by_n.terms, 1.0) / between.axial;
}

/// Rigid along its axis: all nodes move as one, so that each may have half.
template <class Scalar>
void ExactPart<Scalar>::carry_along(const LinkStretch& of) {
  const Polynomial<3> mass = integral_of(in_shares(of.mass, from_ - of.start, h_));
  start.uu = end.uu = -0.5 * h_ * mass(1.0) * z_;
}

/// Rigid across its axis: all that moves stands at the start.
template <class Scalar>
void ExactPart<Scalar>::carry_across(const LinkStretch& of) {
  const Polynomial<2> mass = in_shares(of.mass, from_ - of.start, h_);
  const Polynomial<4> rotary = in_shares(of.rotary, from_ - of.start, h_);
  const Polynomial<1> arm{{0.0, h_}};
  start.ww = -h_ * integral_of(mass)(1.0) * z_;
  start.wp = -h_ * integral_of(mass * arm)(1.0) * z_;
  start.pp = -h_ * integral_of(mass * arm * arm + rotary)(1.0) * z_;
  between.from_start = 0.5 * h_;
  between.from_end = -0.5 * h_;
}

template <class Scalar>
void ExactPart<Scalar>::bend(const Link&, const LinkStretch& of) {
  bending_ = {bending_from(of, 1.0, 0.0, 0.0, 0.0), bending_from(of, 0.0, 1.0, 0.0, 0.0),
              bending_from(of, 0.0, 0.0, 1.0, 0.0), bending_from(of, 0.0, 0.0, 0.0, 1.0)};
  const auto at_end = [](const Series& series, const Along& along) {
    return value_at(series, along.terms, 1.0);
  };
  const auto& [by_w, by_phi, by_Q, by_m] = bending_;
  const Scalar dB12 = at_end(by_m.du, by_m), dB21 = at_end(by_Q.dphi, by_Q);
  const Scalar dB22 = at_end(by_m.dphi, by_m);
  const Scalar B11 = at_end(by_Q.u, by_Q) + at_end(by_Q.du, by_Q);
  const Scalar B12 = at_end(by_m.u, by_m) + dB12;
  const Scalar B21 = at_end(by_Q.phi, by_Q) + dB21;
  const Scalar B22 = at_end(by_m.phi, by_m) + dB22;
  between.f22 = B22;
  between.f11 = B11 - B12 * B21 / B22;
  // Statically B_12 - B_21 = h B_22: the levers add up to the length, and to more by inertia.
  const Scalar more = (dB12 - dB21 - h_ * dB22) / B22;
  between.from_end = -B12 / B22;
  between.from_start = between.from_end + h_ + more;
  // Nodes: B^-1 (A - R) and (E - R^-T) B^-1, R the shift by both levers.
  const Scalar A[2][2] = {{at_end(by_w.du, by_w), at_end(by_phi.du, by_phi) - more},
                          {at_end(by_w.dphi, by_w), at_end(by_phi.dphi, by_phi)}};
  const Scalar E[2][2] = {{at_end(by_Q.dforce, by_Q), at_end(by_m.dforce, by_m)},
                          {at_end(by_Q.dm, by_Q) + more, at_end(by_m.dm, by_m)}};
  start.ww = (A[0][0] + between.from_end * A[1][0]) / between.f11;
  start.wp = (A[0][1] + between.from_end * A[1][1]) / between.f11;
  start.pp = between.from_start * start.wp + A[1][1] / B22;
  end.ww = (E[0][0] + between.from_start * E[0][1]) / between.f11;
  end.wp = (E[1][0] + between.from_start * E[1][1]) / between.f11;
  end.pp = between.from_end * end.wp + E[1][1] / B22;
}

template <class Scalar>
typename ExactPart<Scalar>::Vector3 ExactPart<Scalar>::at(double s, const Vector3& q_0,
                                                          const Vector3& q_1) const {
  const double share = (s - from_) / h_;
  const auto sum_at = [share](const Series& still, const Series& moving, const Along& along) {
    return value_at(still, along.terms, share) + value_at(moving, along.terms, share);
  };
  Vector3 q = q_0;
  if (stretches_) {
    const Scalar n = (q_1[0] - q_0[0]) / between.axial - start.uu * q_0[0];
    q[0] = q_0[0] * sum_at(axial_[0].u, axial_[0].du, axial_[0]) +
           n * sum_at(axial_[1].u, axial_[1].du, axial_[1]);
  }
  if (!bends_) {
    q[1] += (s - from_) * q_0[2];
    return q;
  }
  // Forces of the spring, and at the start those of its node as well.
  const Scalar gap = q_1[1] + between.from_end * q_1[2] - q_0[1] - between.from_start * q_0[2];
  const Scalar Q = gap / between.f11;
  const Scalar m = (q_1[2] - q_0[2]) / between.f22 + between.from_start * Q;
  const Scalar state[] = {q_0[1], q_0[2], Q - start.ww * q_0[1] - start.wp * q_0[2],
                          m - start.wp * q_0[1] - start.pp * q_0[2]};
  q[1] = q[2] = Scalar(0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const Along& along = bending_[i];
    q[1] += state[i] * sum_at(along.u, along.du, along);
    q[2] += state[i] * sum_at(along.phi, along.dphi, along);
  }
  return q;
}

template class ExactPart<double>;
template class ExactPart<Complex>;

}  // namespace boxbeam::flexible
