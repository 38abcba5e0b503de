#include "boxbeam/numerics/chebyshev_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boxbeam {
namespace {

constexpr Eigen::Index curve_points = 9;

/// Of each point of a piece, the angle whose cosine it is.
double curve_angle(Eigen::Index k) {
  return std::numbers::pi * (2.0 * static_cast<double>(k) + 1.0) / (2.0 * curve_points);
}

using CurveShares = Eigen::Matrix<double, curve_points, 1>;

/// The points, ascending in [-1, 1], and what each weighs in the barycentric formula.
struct CurvePoints {
  CurveShares at, weights;
};

const CurvePoints& curve_points_on_piece() {
  static const CurvePoints points = [] {
    CurvePoints of;
    for (Eigen::Index k = 0; k < curve_points; ++k) {
      of.at[k] = -std::cos(curve_angle(k));
      of.weights[k] = (k % 2 == 0 ? 1.0 : -1.0) * std::sin(curve_angle(k));
    }
    return of;
  }();
  return points;
}

/// The two highest of the waves in a piece, by their largest size.
Eigen::VectorXd highest_waves(const Eigen::MatrixXd& values) {
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(values.rows());
  for (const double wave : {curve_points - 1.0, curve_points - 2.0}) {
    Eigen::VectorXd shares(curve_points);
    for (Eigen::Index k = 0; k < curve_points; ++k)
      shares[k] = 2.0 / curve_points * std::cos(wave * curve_angle(k));
    largest = largest.cwiseMax((values * shares).cwiseAbs());
  }
  return largest;
}

}  // namespace

ChebyshevCurve::Piece ChebyshevCurve::piece_of(const Function& f, double from, double to) {
  Piece piece{from, to, {}};
  for (Eigen::Index k = 0; k < curve_points; ++k) {
    const double u = curve_points_on_piece().at[k];
    const Eigen::VectorXd value = f(0.5 * (from + to) + 0.5 * (to - from) * u);
    if (k == 0) piece.values.resize(value.size(), curve_points);
    piece.values.col(k) = value;
  }
  return piece;
}

ChebyshevCurve::ChebyshevCurve(const Function& f, const Division& division,
                               const Accuracy& accuracy) {
  std::vector<Piece> open;  // the first of them last
  for (std::size_t i = 1; i < division.borders.size(); ++i) {
    const double from = division.borders[i - 1], length = division.borders[i] - from;
    const auto count = std::max(1L, std::lround(std::ceil(length / division.longest - 1e-9)));
    const double part = length / static_cast<double>(count);
    for (long k = 0; k < count; ++k)
      open.push_back(
          piece_of(f, from + part * static_cast<double>(k),
                   k + 1 < count ? from + part * static_cast<double>(k + 1) : division.borders[i]));
  }
  std::reverse(open.begin(), open.end());
  largest_ = Eigen::VectorXd::Zero(open.front().values.rows());
  const auto look_at = [&](const Piece& piece) {
    largest_ = largest_.cwiseMax(piece.values.cwiseAbs().rowwise().maxCoeff());
  };
  for (const Piece& piece : open) look_at(piece);
  const Eigen::VectorXd allowed = accuracy(largest_);
  while (!open.empty()) {
    Piece piece = std::move(open.back());
    open.pop_back();
    const double middle = 0.5 * (piece.from + piece.to);
    const bool halve = piece.to - piece.from > 2.0 * division.shortest &&
                       (highest_waves(piece.values).array() > allowed.array()).any();
    if (!halve) {
      pieces_.push_back(std::move(piece));
      continue;
    }
    open.push_back(piece_of(f, middle, piece.to));
    look_at(open.back());
    open.push_back(piece_of(f, piece.from, middle));
    look_at(open.back());
  }
}

Eigen::VectorXd ChebyshevCurve::at(double x, Eigen::Index components) const {
  const auto behind =
      std::upper_bound(pieces_.begin() + 1, pieces_.end(), x,
                       [](double value, const Piece& piece) { return value < piece.from; });
  const Piece& piece = *(behind - 1);
  const double u = (2.0 * x - piece.from - piece.to) / (piece.to - piece.from);
  // Barycentric formula: Berrut and Trefethen, SIAM Review 46 (2004).
  const CurvePoints& points = curve_points_on_piece();
  CurveShares shares;
  for (Eigen::Index k = 0; k < curve_points; ++k) {
    const double distance = u - points.at[k];
    if (distance == 0.0) return piece.values.col(k).head(components);
    shares[k] = points.weights[k] / distance;
  }
  shares /= shares.sum();
  return piece.values.topRows(components) * shares;
}

ChebyshevCurve ChebyshevCurve::mapped(const Eigen::MatrixXd& by) const {
  ChebyshevCurve of = *this;
  of.largest_ = Eigen::VectorXd::Zero(by.rows());
  for (Piece& piece : of.pieces_) {
    piece.values = by * piece.values;
    of.largest_ = of.largest_.cwiseMax(piece.values.cwiseAbs().rowwise().maxCoeff());
  }
  return of;
}

double ChebyshevCurve::shortest_piece() const {
  double shortest = pieces_.front().to - pieces_.front().from;
  for (const Piece& piece : pieces_) shortest = std::min(shortest, piece.to - piece.from);
  return shortest;
}

}  // namespace boxbeam
