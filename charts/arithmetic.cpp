#include "charts/arithmetic.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/forces.hpp"

namespace boxbeam::charts {

const char* to_text(LinearMethod method) {
  switch (method) {
    case LinearMethod::dense: return "dense LU";
    case LinearMethod::sparse: return "static sparse order";
    default: return "orthogonal decomposition";
  }
}

template <class Scalar>
TextbookSolver<Scalar>::TextbookSolver(const planar::Mechanism& mechanism, LinearMethod method)
    : mechanism_(&mechanism),
      method_(method),
      equations_(mechanism),
      row_scale_(equations_.row_scale().template cast<Scalar>()),
      col_scale_(equations_.col_scale().template cast<Scalar>()),
      phi_(mechanism.equations()),
      step_(mechanism.coordinates()) {}

template <class Scalar>
bool TextbookSolver<Scalar>::factor() {
  if (method_ == LinearMethod::orthogonal) {
    const Matrix scaled =
        row_scale_.asDiagonal() * equations_.pattern().dense(values_) * col_scale_.asDiagonal();
    orthogonal_.compute(scaled);
    return orthogonal_.rank() == mechanism_->coordinates();
  }
  // Equations that repeat others have no place in either elimination.
  if (mechanism_->equations() != mechanism_->coordinates()) return false;
  if (method_ == LinearMethod::dense) {
    dense_.compute(equations_.pattern().dense(values_));
    return true;
  }
  if (ordered_ && sparse_.factor(values_)) return true;
  const std::vector<double> plain = [&] {
    std::vector<double> values;
    for (const Scalar value : values_) values.push_back(static_cast<double>(value));
    return values;
  }();
  ordered_ = sparse_.analyse(equations_.pattern(), plain, equations_.row_scale(),
                             equations_.col_scale()) == mechanism_->coordinates();
  return ordered_ && sparse_.factor(values_);
}

template <class Scalar>
void TextbookSolver<Scalar>::reflect(Vector& x, bool transposed) const {
  // Eigen would gather the reflections in blocks: a matrix product to compile, for each arithmetic.
  const Matrix& reflections = orthogonal_.matrixQR();
  const Eigen::Index n = reflections.cols();
  Scalar work{};
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::Index k = transposed ? i : n - 1 - i;
    const Eigen::Index below = x.size() - k - 1;
    x.tail(below + 1).applyHouseholderOnTheLeft(reflections.col(k).tail(below),
                                                orthogonal_.hCoeffs()[k], &work);
  }
}

template <class Scalar>
void TextbookSolver<Scalar>::solve(const Vector& right, Vector& x) {
  if (method_ == LinearMethod::orthogonal) {
    // The least squares of A P = Q R; the rank is full.
    const Eigen::Index n = mechanism_->coordinates();
    Vector reflected = row_scale_.cwiseProduct(right);
    reflect(reflected, true);
    Vector pivoted = reflected.head(n);
    orthogonal_.matrixQR().topRows(n).template triangularView<Eigen::Upper>().solveInPlace(pivoted);
    x = orthogonal_.colsPermutation() * pivoted;
    x = x.cwiseProduct(col_scale_);
  } else if (method_ == LinearMethod::dense) {
    x = dense_.solve(right);
  } else {
    sparse_.solve(right, x);
  }
}

template <class Scalar>
void TextbookSolver<Scalar>::solve_transposed(const Vector& right, Vector& y) {
  if (method_ == LinearMethod::orthogonal) {
    // The shortest of all multipliers that balance.
    const Eigen::Index n = mechanism_->coordinates();
    Vector pivoted = orthogonal_.colsPermutation().transpose() * col_scale_.cwiseProduct(right);
    orthogonal_.matrixQR()
        .topRows(n)
        .template triangularView<Eigen::Upper>()
        .transpose()
        .solveInPlace(pivoted);
    y.setZero(mechanism_->equations());
    y.head(n) = pivoted;
    reflect(y, false);
    y = y.cwiseProduct(row_scale_);
  } else if (method_ == LinearMethod::dense) {
    y = dense_.transpose().solve(right);
  } else {
    sparse_.solve_transposed(right, y);
  }
}

template <class Scalar>
int TextbookSolver<Scalar>::solve_position(Vector& q, double tolerance) {
  using std::abs;
  using std::isfinite;
  constexpr int most = 60;
  // Steps that are so small and do not halve any more are round-off, whatever the condition.
  const double close = std::sqrt(static_cast<double>(Eigen::NumTraits<Scalar>::epsilon()));
  double last = 0.0;
  for (int iteration = 1; iteration <= most; ++iteration) {
    equations_.set_position(q);
    equations_.evaluate(phi_, values_);
    if (!factor()) return 0;
    solve(phi_, step_);
    double step = 0.0;
    double size = 1.0;
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      if (!isfinite(step_[i])) return 0;
      step = std::max(step, static_cast<double>(abs(step_[i]) / col_scale_[i]));
      size = std::max(size, static_cast<double>(abs(q[i]) / col_scale_[i]));
    }
    q -= step_;
    if (step <= tolerance * size) return iteration;
    if (iteration > 1 && step < close * size && step > 0.5 * last) return iteration;
    last = step;
  }
  return 0;
}

template <class Scalar>
bool TextbookSolver<Scalar>::solve_rates(InstantIn<Scalar>& instant) {
  equations_.set_position(instant.q);
  equations_.evaluate(phi_, values_);
  if (!factor()) return false;
  instant.v.resize(mechanism_->coordinates());
  instant.a.resize(mechanism_->coordinates());
  equations_.velocity_right_side(phi_);
  solve(phi_, instant.v);
  equations_.acceleration_right_side(instant.v, phi_);
  solve(phi_, instant.a);
  return instant.v.allFinite() && instant.a.allFinite();
}

template <class Scalar>
auto TextbookSolver<Scalar>::balance_of(double time, const InstantIn<Scalar>& instant) const
    -> Vector {
  Vector forces(mechanism_->coordinates());
  forces.setZero();
  if (!mechanism_->forces.empty()) {
    Eigen::VectorXd applied = Eigen::VectorXd::Zero(forces.size());
    planar::add_applied_forces(*mechanism_, time, instant.q.template cast<double>(),
                               instant.v.template cast<double>(), applied);
    forces = applied.cast<Scalar>();
  }
  Eigen::Index i = 0;
  for (const Body& body : mechanism_->bodies) {
    const auto mass = static_cast<Scalar>(body.mass);
    for (int k = 0; k < 2; ++k) {
      forces[i + k] += mass * (static_cast<Scalar>(mechanism_->gravity[k]) - instant.a[i + k]);
    }
    forces[i + 2] -= static_cast<Scalar>(body.inertia) * instant.a[i + 2];
    i += 3;
  }
  return forces;
}

template <class Scalar>
void TextbookSolver<Scalar>::solve_multipliers(double time, InstantIn<Scalar>& instant) {
  instant.lambda.resize(mechanism_->equations());
  solve_transposed(balance_of(time, instant), instant.lambda);
}

template <class Scalar>
double TextbookSolver<Scalar>::factor_operations() const {
  if (method_ == LinearMethod::sparse) return static_cast<double>(sparse_.factor_operations());
  const auto n = static_cast<double>(mechanism_->coordinates());
  const auto m = static_cast<double>(mechanism_->equations());
  // Golub and Van Loan, Matrix Computations (1996), sections 3.2 and 5.2.
  return method_ == LinearMethod::dense ? 2.0 / 3.0 * n * n * n : 2.0 * n * n * (m - n / 3.0);
}

template <class Scalar>
double TextbookSolver<Scalar>::solve_operations() const {
  if (method_ == LinearMethod::sparse) return static_cast<double>(sparse_.solve_operations());
  const auto n = static_cast<double>(mechanism_->coordinates());
  const auto m = static_cast<double>(mechanism_->equations());
  return method_ == LinearMethod::dense ? 2.0 * n * n : 4.0 * m * n;
}

template class TextbookSolver<float>;
template class TextbookSolver<double>;
template class TextbookSolver<long double>;
template class TextbookSolver<Decimal<5>>;

}  // namespace boxbeam::charts
