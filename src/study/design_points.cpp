#include "design_points.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "boxbeam/study/distribution.hpp"

namespace boxbeam {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double farthest = 38.0;  // Phi(-38) is the smallest number that is not zero
constexpr std::size_t most_points = 20;
constexpr std::uint32_t stream_of_starts = 1;

/// g and its gradient at a point.
struct Linear {
  VectorXd u;
  double g = 0.0;
  VectorXd gradient;
};

/// Where a search from one start ended.
struct Attempt {
  std::optional<DesignPoint> point;
  std::string reason;  ///< why there is none
};

class Search {
 public:
  Search(LimitState& limit_state, const ReliabilityDemand& demand, std::uint64_t seed)
      : limit_state_(&limit_state), demand_(&demand), n_(limit_state.dimension()), seed_(seed) {}

  DesignPoints run() {
    DesignPoints found;
    const double middle = limit_state_->at(VectorXd::Zero(n_));
    found.mean_fails = middle < 0.0;
    sign_ = found.mean_fails ? -1.0 : 1.0;
    if (!std::isfinite(middle)) {
      const std::string trouble = limit_state_->first_trouble();
      found.reason =
          "the design of all medians cannot be judged: " +
          (trouble.empty() ? "its margin is no finite number, as where nothing is used" : trouble);
      return found;
    }
    look_from(VectorXd::Zero(n_));
    for (std::size_t i = 0; i < demand_->starts; ++i) {
      const VectorXd direction = normal_point(seed_, stream_of_starts, i, n_);
      constexpr double radius = 3.0;
      look_from(radius / direction.norm() * direction);
    }
    keep_what_counts();
    found.reason = reason();
    if (found.reason.empty()) found.points = std::move(points_);
    return found;
  }

 private:
  std::vector<double> at(const std::vector<VectorXd>& points) {
    std::vector<double> values = limit_state_->at(points);
    for (double& value : values) value *= sign_;
    return values;
  }

  std::optional<Linear> linear_at(const VectorXd& u) {
    std::vector<VectorXd> around{u};
    for (Index k = 0; k < n_; ++k)
      for (const double side : {-1.0, 1.0}) {
        around.push_back(u);
        around.back()[k] += side * demand_->step;
      }
    const std::vector<double> g = at(around);
    Linear of{u, g[0], VectorXd(n_)};
    for (Index k = 0; k < n_; ++k)
      of.gradient[k] =
          (g[static_cast<std::size_t>(2 * k + 2)] - g[static_cast<std::size_t>(2 * k + 1)]) /
          (2.0 * demand_->step);
    if (!std::isfinite(of.g) || !of.gradient.allFinite()) return std::nullopt;
    return of;
  }

  /// The next point of the search, nothing where none is nearer; "nearer" by the merit
  /// |u|^2/2 + c |g|, c above |u|/|grad g|.
  std::optional<VectorXd> step_from(const Linear& of) {
    const double norm = of.gradient.norm(), away = of.g / norm;
    const VectorXd alpha = -of.gradient / norm;
    const VectorXd target = (alpha.dot(of.u) + away) * alpha;
    VectorXd way = target - of.u;
    constexpr double longest = 8.0;
    if (way.norm() > longest) way *= longest / way.norm();
    double c = 2.0 * of.u.norm() / norm + 1e-3 / norm;
    if (std::abs(away) > 1e-3) c = std::max(c, target.squaredNorm() / std::abs(of.g));
    const double merit = 0.5 * of.u.squaredNorm() + c * std::abs(of.g);
    for (int halved = 0; halved < 14; ++halved) {
      const VectorXd next = of.u + std::ldexp(1.0, -halved) * way;
      const double g = at({next}).front();
      if (0.5 * next.squaredNorm() + c * std::abs(g) < merit) return next;
    }
    return std::nullopt;
  }

  Attempt attempt_from(VectorXd u) {
    constexpr int most_steps = 100;
    for (int step = 0; step < most_steps; ++step) {
      const std::optional<Linear> of = linear_at(u);
      if (!of) return {{}, "the search comes to designs that cannot be judged"};
      const double norm = of->gradient.norm();
      if (!(norm > 1e-9 * std::abs(of->g)) || norm == 0.0)
        return {{}, "the limit state does not change where the search comes to"};
      const VectorXd alpha = -of->gradient / norm;
      const double along = alpha.dot(u), off = (u - along * alpha).norm();
      const double size = std::max(1.0, u.norm());
      const bool is_near = std::abs(of->g) / norm <= 0.1 * demand_->tolerance * size;
      const bool is_straight = off <= demand_->tolerance * size;
      if (is_near && is_straight) return {point_of(*of), ""};
      const std::optional<VectorXd> next = step_from(*of);
      if (!next)
        return {{},
                fmt::format("the search stops {:.2g} standard deviations from the limit state "
                            "and {:.2g} aside, perhaps at a kink",
                            std::abs(of->g) / norm, off)};
      u = *next;
      if (u.norm() > farthest)
        return {{}, fmt::format("no failure within {} standard deviations", farthest)};
    }
    return {{}, fmt::format("not converged in {} steps", most_steps)};
  }

  /// Of the plane that touches the limit state.
  DesignPoint point_of(const Linear& of) const {
    DesignPoint point;
    const double norm = of.gradient.norm();
    point.alpha = -of.gradient / norm;
    point.beta = point.alpha.dot(of.u) + of.g / norm;
    point.u = point.beta * point.alpha;
    point.slope = norm;
    return point;
  }

  /// Directions along the limit state, one a column: the rest of an orthogonal basis.
  MatrixXd tangents_at(const DesignPoint& point) const {
    const MatrixXd alpha = point.alpha;
    const MatrixXd basis = Eigen::HouseholderQR<MatrixXd>(alpha).householderQ();
    return basis.rightCols(n_ - 1);
  }

  /// Principal curvatures by second differences, and the directions that belong to them. False
  /// where a neighbour cannot be judged.
  bool curve(DesignPoint& point, MatrixXd& directions) {
    const MatrixXd tangents = tangents_at(point);
    const Index m = n_ - 1;
    const double h = 10.0 * demand_->step;
    std::vector<VectorXd> around{point.u};
    const auto add = [&](double a, Index i, double b, Index j) {
      around.emplace_back(point.u + h * (a * tangents.col(i) + b * tangents.col(j)));
    };
    for (Index i = 0; i < m; ++i)
      for (const double side : {-1.0, 1.0, -2.0, 2.0}) add(side, i, 0.0, i);
    for (Index i = 0; i < m; ++i)
      for (Index j = 0; j < i; ++j)
        for (const double a : {-1.0, 1.0})
          for (const double b : {-1.0, 1.0}) add(a, i, b, j);
    const std::vector<double> g = at(around);
    if (!std::all_of(g.begin(), g.end(), [](double value) { return std::isfinite(value); }))
      return false;
    MatrixXd bent(m, m);
    std::size_t next = 1;
    const double unit = 1.0 / (h * h * point.slope);
    for (Index i = 0; i < m; ++i, next += 4) {
      bent(i, i) = (g[next] + g[next + 1] - 2.0 * g[0]) * unit;
      const double wide = (g[next + 2] + g[next + 3] - 2.0 * g[0]) * unit / 4.0;
      // In parts of the curvature that would matter.
      if (std::abs(wide - bent(i, i)) > 0.1 * std::abs(wide) + 0.1 / std::max(1.0, point.beta))
        point.kinked = true;
    }
    for (Index i = 0; i < m; ++i)
      for (Index j = 0; j < i; ++j, next += 4)
        bent(i, j) = bent(j, i) = (g[next] - g[next + 1] - g[next + 2] + g[next + 3]) * unit / 4.0;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> principal(bent);
    point.curvatures = principal.eigenvalues();
    directions = tangents * principal.eigenvectors();
    return true;
  }

  bool is_known(const DesignPoint& point) const {
    const auto is_same = [&](const DesignPoint& other) {
      return (point.u - other.u).norm() < 0.05 * std::max(1.0, point.beta);
    };
    return std::any_of(points_.begin(), points_.end(), is_same) ||
           std::any_of(saddles_.begin(), saddles_.end(), is_same);
  }

  /// A neighbour of a point that is nearer to the origin and fails; of a kink, where curvatures
  /// say nothing.
  std::optional<VectorXd> nearer_than(const DesignPoint& point, const MatrixXd& directions) {
    std::vector<VectorXd> around;
    constexpr double nearer = 1.0 - 1e-3, aside = 0.2;
    for (Index i = 0; i < directions.cols(); ++i)
      for (const double side : {-aside, aside}) {
        const VectorXd to = point.alpha + side * directions.col(i);
        around.emplace_back(nearer * point.beta / to.norm() * to);
      }
    const std::vector<double> g = at(around);
    for (std::size_t i = 0; i < g.size(); ++i)
      if (g[i] < 0.0) return around[i];
    return std::nullopt;
  }

  /// Searches from a start, and from beside a saddle that it leads to.
  void look_from(const VectorXd& start, int depth = 0) {
    if (points_.size() > most_points) return;
    Attempt attempt = attempt_from(start);
    if (!attempt.point) {
      if (first_reason_.empty()) first_reason_ = attempt.reason;
      return;
    }
    DesignPoint& point = *attempt.point;
    if (point.beta < -1e-9 || is_known(point)) return;
    MatrixXd directions;
    if (n_ > 1 && !curve(point, directions)) {
      if (first_reason_.empty())
        first_reason_ = "designs beside the point that was found cannot be judged";
      return;
    }
    constexpr double flat = 1e-2;
    const double least = n_ > 1 ? 1.0 + point.beta * point.curvatures[0] : 1.0;
    std::vector<VectorXd> escapes;
    if (point.kinked) {
      if (const auto nearer = nearer_than(point, directions)) escapes.push_back(*nearer);
    } else if (least < -flat) {
      const double aside = 0.3 * std::max(1.0, point.beta);
      for (const double side : {-aside, aside})
        escapes.emplace_back(point.u + side * directions.col(0));
    } else if (least < flat) {
      ring_ = std::min(ring_.value_or(farthest), point.beta);
    }
    if (escapes.empty()) {
      points_.push_back(point);
      return;
    }
    saddles_.push_back(point);
    constexpr int deepest = 3;
    if (depth < deepest)
      for (const VectorXd& escape : escapes) look_from(escape, depth + 1);
  }

  /// The nearest first, without those that add less than a thousandth.
  void keep_what_counts() {
    std::sort(points_.begin(), points_.end(),
              [](const DesignPoint& a, const DesignPoint& b) { return a.beta < b.beta; });
    if (points_.empty()) return;
    const double most = normal_share_below(-points_.front().beta);
    std::erase_if(points_, [&](const DesignPoint& point) {
      return normal_share_below(-point.beta) < 1e-3 * most;
    });
  }

  std::string reason() const {
    if (points_.empty())
      return !saddles_.empty() ? fmt::format(
                                     "only saddles were found, the nearest at {:.4f}, none "
                                     "of which is next to the origin",
                                     saddles_.front().beta)
                               : first_reason_;
    if (ring_ && *ring_ < points_.front().beta + 0.5)
      return fmt::format(
          "the points next to the origin are no single ones, at {:.4f}: the limit state is bent "
          "around the origin there",
          *ring_);
    if (points_.size() > most_points)
      return fmt::format("more than {} points are next to the origin", most_points);
    const auto beside = std::find_if(saddles_.begin(), saddles_.end(), [&](const DesignPoint& at) {
      return at.beta < points_.front().beta - 1e-6;
    });
    if (beside != saddles_.end())
      return fmt::format(
          "a saddle at {:.4f} is nearer than all points found, the nearest of which is at {:.4f}",
          beside->beta, points_.front().beta);
    return "";
  }

  LimitState* limit_state_;
  const ReliabilityDemand* demand_;
  Index n_;
  std::uint64_t seed_;
  double sign_ = 1.0;
  std::vector<DesignPoint> points_, saddles_;
  std::optional<double> ring_;  ///< how near it is
  std::string first_reason_;
};

}  // namespace

DesignPoints design_points_of(LimitState& limit_state, const ReliabilityDemand& demand,
                              std::uint64_t seed) {
  return Search(limit_state, demand, seed).run();
}

}  // namespace boxbeam
