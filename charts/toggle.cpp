#include "charts/toggle.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <numbers>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/branch.hpp"
#include "boxbeam/mechanism/planar/instant_solver.hpp"
#include "boxbeam/mechanism/planar/reach.hpp"

namespace boxbeam::charts {
namespace {

using LongVector = InstantIn<long double>::Vector;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

planar::Driven* only_driver_of(planar::Mechanism& mechanism) {
  planar::Driven* only = nullptr;
  for (planar::Joint& joint : mechanism.joints) {
    auto* driven = std::get_if<planar::Driven>(&joint.kind);
    if (driven == nullptr) continue;
    if (only != nullptr) return nullptr;
    only = driven;
  }
  return only;
}

/// The curve of assembled positions with one coordinate as its parameter: the driver's value is an
/// unknown.
class CoordinateCurve {
 public:
  CoordinateCurve(const planar::Mechanism& mechanism, const planar::Reach& reach)
      : equations_(mechanism),
        n_(mechanism.coordinates()),
        row_(equations_.driver_rows().front()),
        x_(n_ + 1) {
    equations_.set_driver_values({0.0});
    x_ << reach.q.cast<long double>(), static_cast<long double>(reach.values.front());
    linearise();
    const Eigen::MatrixXd scaled = equations_.row_scale().asDiagonal() *
                                   LongMatrix(matrix_.topLeftCorner(n_, n_)).cast<double>() *
                                   equations_.col_scale().asDiagonal();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(scaled, Eigen::ComputeFullV);
    svd.matrixV().col(n_ - 1).cwiseAbs().maxCoeff(&parameter_);
  }

  /// To where the driver turns back; false where it does not get there.
  bool turn_back() {
    for (int i = 0; i < 30; ++i) {
      linearise();
      const Eigen::PartialPivLU<LongMatrix> factors(matrix_);
      LongVector right = LongVector::Zero(n_ + 1);
      right.head(n_) = phi_;
      x_ -= factors.solve(right);  // back to the curve, the parameter kept
      linearise();
      const Eigen::PartialPivLU<LongMatrix> at(matrix_);
      const LongVector first = at.solve(LongVector::Unit(n_ + 1, n_));
      LongVector gamma(n_);
      equations_.acceleration_right_side(first.head(n_), gamma);
      right.head(n_) = gamma;
      const LongVector second = at.solve(right);
      const long double step = first[n_] / second[n_];
      if (!std::isfinite(step)) return false;
      x_ -= step * first;
      if (std::abs(step) < 1e-17L * (1.0L + std::abs(x_[parameter_])) && i > 2) return true;
    }
    return phi_.lpNorm<Eigen::Infinity>() < 1e-15L;
  }

  long double driver() const { return x_[n_]; }
  Eigen::VectorXd position() const { return x_.head(n_).cast<double>(); }

 private:
  void linearise() {
    equations_.set_position(x_.head(n_));
    phi_.resize(n_);
    equations_.evaluate(phi_, values_);
    phi_[row_] -= x_[n_];
    matrix_ = LongMatrix::Zero(n_ + 1, n_ + 1);
    matrix_.topLeftCorner(n_, n_) = equations_.pattern().dense(values_);
    matrix_(row_, n_) = -1.0L;
    matrix_(n_, parameter_) = 1.0L;
  }

  planar::ConstraintEquationsOf<long double> equations_;
  Eigen::Index n_, row_;
  Eigen::Index parameter_ = 0;
  LongVector x_, phi_;
  LongMatrix matrix_;
  std::vector<long double> values_;
};

/// Whether one of the named loops stretches or folds there.
bool is_watched(const planar::Mechanism& mechanism, const Eigen::VectorXd& toggle,
                const Eigen::VectorXd& elsewhere) {
  for (const planar::Loop& loop : mechanism.loops) {
    if (std::abs(planar::measure_of(loop, toggle)) <
        1e-6 * std::abs(planar::measure_of(loop, elsewhere))) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::optional<Toggle> toggle_of(const planar::Mechanism& mechanism, const Eigen::VectorXd& q) {
  planar::Mechanism driven = mechanism;
  const planar::Driven* driver = only_driver_of(driven);
  if (driver == nullptr || mechanism.equations() != mechanism.coordinates()) return std::nullopt;
  const double now = planar::driver_values_at(mechanism, q).front();
  const double way = driver->coordinate == planar::Coordinate::angle ? 2.0 * std::numbers::pi
                                                                     : 8.0 * size_of(mechanism);
  std::optional<Toggle> nearest;
  for (const int side : {1, -1}) {
    const planar::Reach reach = planar::find_reach(mechanism, q, {now + side * way});
    if (!reach.limited) continue;
    CoordinateCurve curve(mechanism, reach);
    if (!curve.turn_back()) continue;
    const Toggle toggle{curve.driver(), side, curve.position()};
    if (!nearest || std::abs(toggle.value - now) < std::abs(nearest->value - now)) {
      nearest = toggle;
    }
  }
  return nearest;
}

std::optional<ToggleScene::Place> ToggleScene::place(double share) const {
  Place place;
  place.mechanism = mechanism;
  place.mechanism.duration = {0.0, 1.0};
  planar::Driven* const driver = only_driver_of(place.mechanism);
  const double unit = driver->coordinate == planar::Coordinate::angle ? 1.0 : size_of(mechanism);
  const auto stand_at = [&](double distance) {
    const auto value = static_cast<double>(toggle.value - toggle.side * distance);
    driver->driver = RateDriver{value, static_cast<double>(toggle.side)};
    return static_cast<double>(toggle.side * (toggle.value - static_cast<long double>(value)));
  };
  // From a regular place; the distance from the toggle's position goes with the root of the
  // driver's.
  const double regular = stand_at(std::max(share, 1e-3) * unit);
  Eigen::VectorXd known;
  try {
    planar::InstantSolver solver(place.mechanism);
    known = solver.solve_from_sketch(0.0, sketch_of(place.mechanism)).q;
  } catch (const AnalysisError&) {
    return std::nullopt;
  }
  place.distance = stand_at(share * unit);
  const Eigen::VectorXd near = toggle.q + std::sqrt(place.distance / regular) * (known - toggle.q);
  TextbookSolver<long double> solver(place.mechanism, LinearMethod::dense);
  solver.equations().set_time(0.0);
  place.exact.q = near.cast<long double>();
  if (solver.solve_position(place.exact.q, 0.0) == 0 || !solver.solve_rates(place.exact)) {
    return std::nullopt;
  }
  const DyadPlan plan = plan_dyads(place.mechanism, near);
  if (plan.failure.empty()) {
    solve_dyads(plan, solver.equations().driver_states(), near, place.exact);
  }
  if (!place.exact.a.allFinite()) return std::nullopt;
  return place;
}

ToggleScene four_bar_before_toggle() {
  const auto rod = [](const char* name, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    Body body;
    body.name = name;
    const Eigen::Vector2d way = to - from;
    body.mass = 10.0 * way.norm();
    body.inertia = body.mass * way.squaredNorm() / 12.0;
    body.sketch = {0.5 * (from + to), std::atan2(way.y(), way.x())};
    return body;
  };
  const auto on = [](int body, double x) { return planar::Attachment{body, {x, 0.0}}; };
  // The crank at 60 degrees; the tip of the coupler about where circles of 0.8 m and 0.9 m meet.
  const Eigen::Vector2d O(0.0, 0.0), A(0.5, 0.866), B(1.266, 0.861), D(1.5, 0.0);
  ToggleScene scene;
  scene.name = "four-bar of 1, 0.8, 0.9 and 1.5 m, crank driven";
  scene.mechanism.bodies = {rod("crank", O, A), rod("coupler", A, B), rod("rocker", D, B)};
  scene.mechanism.bodies[0].points = {};
  scene.mechanism.joints = {
      {"O", planar::Pin{on(0, -0.5), {planar::ground, O}}},
      {"A", planar::Pin{on(0, 0.5), on(1, -0.4)}},
      {"B", planar::Pin{on(1, 0.4), on(2, 0.45)}},
      {"D", planar::Pin{on(2, -0.45), {planar::ground, D}}},
      {"motor", planar::Driven{on(0, 0.0), planar::Coordinate::angle, RateDriver{1.0, 1.0}}}};
  scene.mechanism.gravity = {0.0, -9.81};
  scene.mechanism.loops = {
      {"coupler", planar::TurnSign{on(1, -0.4), {planar::ground, D}, on(1, 0.4)}, 1}};
  planar::InstantSolver solver(scene.mechanism);
  const planar::State state = solver.solve_from_sketch(0.0, sketch_of(scene.mechanism));
  scene.toggle = toggle_of(scene.mechanism, state.q).value();
  return scene;
}

ToggleScene toggle_scene_of(const Scenes& scenes) {
  std::string why;
  const std::optional<DrivenScene> driven = driven_scene_of(scenes, why);
  if (!driven) return four_bar_before_toggle();
  const Eigen::VectorXd& q = driven->motion.states.front().q;
  const std::optional<Toggle> toggle = toggle_of(driven->mechanism, q);
  if (!toggle || !is_watched(driven->mechanism, toggle->q, q)) return four_bar_before_toggle();
  ToggleScene scene{scenes.planar->name, driven->mechanism, *toggle};
  return scene.place(1e-2) ? scene : four_bar_before_toggle();
}

}  // namespace boxbeam::charts
