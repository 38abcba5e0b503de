#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace boxbeam {

/// A function of one variable with values of many components, kept as polynomials of eighth degree
/// on pieces through Chebyshev points of the first kind. Pieces are halved until the two highest
/// waves of each are within the accuracy asked for; a function that is no polynomial of few waves
/// there, for it jumps or bends, is divided down to the shortest piece.
/// Source: Trefethen, Approximation Theory and Approximation Practice (2013), chapters 3 to 5.
class ChebyshevCurve {
 public:
  /// Asked between borders only, never at one: it may jump there.
  using Function = std::function<Eigen::VectorXd(double)>;
  /// The error that each component may have, by the largest size that it has.
  using Accuracy = std::function<Eigen::VectorXd(const Eigen::VectorXd& largest)>;

  struct Division {
    std::vector<double> borders;  ///< ascending, with both ends: places where it may jump or bend
    double longest = 0.0;         ///< of the pieces to begin with
    double shortest = 0.0;        ///< pieces shorter than this are not halved
  };

  ChebyshevCurve(const Function& f, const Division& division, const Accuracy& accuracy);

  /// At a border the value behind it; outside the ends the polynomial of the end goes on.
  Eigen::VectorXd at(double x) const { return at(x, pieces_.front().values.rows()); }
  /// Of so many components, the first ones, alone.
  Eigen::VectorXd at(double x, Eigen::Index components) const;

  /// The curve of `by` times this one.
  ChebyshevCurve mapped(const Eigen::MatrixXd& by) const;

  /// The largest size of each component at the points.
  const Eigen::VectorXd& largest() const { return largest_; }
  std::size_t pieces() const { return pieces_.size(); }
  double shortest_piece() const;

 private:
  struct Piece {
    double from = 0.0, to = 0.0;
    Eigen::MatrixXd values;  ///< at the points, a column each
  };
  static Piece piece_of(const Function& f, double from, double to);

  std::vector<Piece> pieces_;
  Eigen::VectorXd largest_;
};

}  // namespace boxbeam
