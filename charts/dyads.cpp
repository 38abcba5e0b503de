#include "charts/dyads.hpp"

#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

#include "charts/jet.hpp"

namespace boxbeam::charts {
namespace {

using planar::Attachment;
using planar::Coordinate;
using Kind = DyadStep::Kind;

template <class Scalar>
class DyadSolver {
 public:
  using J = Jet<Scalar>;
  using V = JetVector<Scalar>;

  DyadSolver(const std::vector<DriverState>& drivers, const Eigen::VectorXd& near)
      : drivers_(drivers), near_(near), bodies_(static_cast<std::size_t>(near.size()) / 3) {}

  void take(const DyadStep& step) {
    switch (step.kind) {
      case Kind::turned:
        place_turned(step.first, step.own, place_of(step.from), angle_by(step.turn));
        break;
      case Kind::slid: take_slid(step); break;
      case Kind::two_circles: {
        const J length = step.driver < 0 ? constant(step.length) : driven(step.driver);
        place_two_points(step.first, step.own, place_of(step.from), step.tip,
                         two_circles(step, length * length));
        break;
      }
      case Kind::circle_line:
        place_two_points(step.first, step.own, place_of(step.from), step.tip,
                         circle_line(step, constant(0.0)));
        break;
      case Kind::own_line: take_own_line(step); break;
      case Kind::pin_pin_pin: {
        const V tip = two_circles(step, square_of(step.second_tip, step.second_own));
        place_two_points(step.first, step.own, place_of(step.from), step.tip, tip);
        place_two_points(step.second, step.second_own, place_of(step.to), step.second_tip, tip);
        break;
      }
      case Kind::pin_pin_line: {
        // The tip lies on a line beside the guide: by the slider's own points.
        const J angle = angle_by(step.turn);
        const V arm = turned(step.second_tip.p - step.second_own.p, cos(angle), sin(angle));
        const J across = dot(left_of(along(step)), arm);
        const V tip = circle_line(step, across);
        place_two_points(step.first, step.own, place_of(step.from), step.tip, tip);
        place_turned(step.second, step.second_tip, tip, angle);
        break;
      }
    }
  }

  InstantIn<Scalar> result() const {
    InstantIn<Scalar> instant;
    const auto size = static_cast<Eigen::Index>(3 * bodies_.size());
    instant.q.resize(size);
    instant.v.resize(size);
    instant.a.resize(size);
    Eigen::Index i = 0;
    for (const Place& body : bodies_) {
      for (const J* jet : {&body.centre.x, &body.centre.y, &body.angle}) {
        instant.q[i] = jet->x;
        instant.v[i] = jet->v;
        instant.a[i++] = jet->a;
      }
    }
    return instant;
  }

 private:
  struct Place {
    V centre;
    J angle, cosine, sine;
  };

  static J constant(double value) { return {static_cast<Scalar>(value), Scalar(0), Scalar(0)}; }
  static V vector(const Eigen::Vector2d& p) { return {constant(p.x()), constant(p.y())}; }
  static V turned(const Eigen::Vector2d& p, const J& c, const J& s) {
    const auto x = static_cast<Scalar>(p.x());
    const auto y = static_cast<Scalar>(p.y());
    return {x * c - y * s, x * s + y * c};
  }
  static J square_of(const Attachment& a, const Attachment& b) {
    const V way = vector(a.p) - vector(b.p);
    return dot(way, way);
  }

  J driven(int driver) const {
    const DriverState& state = drivers_[static_cast<std::size_t>(driver)];
    return {static_cast<Scalar>(state.value), static_cast<Scalar>(state.rate),
            static_cast<Scalar>(state.acceleration)};
  }
  const Place& body(int index) const { return bodies_[static_cast<std::size_t>(index)]; }
  V place_of(const Attachment& point) const {
    if (point.body == planar::ground) return vector(point.p);
    const Place& place = body(point.body);
    return place.centre + turned(point.p, place.cosine, place.sine);
  }
  J angle_by(const DyadStep::Turn& turn) const {
    J angle = constant(turn.offset);
    if (turn.body != planar::ground) {
      angle = angle + static_cast<Scalar>(turn.factor) * body(turn.body).angle;
    }
    if (turn.driver >= 0) angle = angle + static_cast<Scalar>(turn.by_driver) * driven(turn.driver);
    return angle;
  }
  /// Unit vector along a step's line.
  V along(const DyadStep& step) const {
    J angle = constant(step.direction);
    if (step.to.body != planar::ground) angle = angle + body(step.to.body).angle;
    return {cos(angle), sin(angle)};
  }

  void place_turned(int index, const Attachment& own, const V& at, const J& angle) {
    Place& place = bodies_[static_cast<std::size_t>(index)];
    place.angle = angle;
    place.cosine = cos(angle);
    place.sine = sin(angle);
    place.centre = at - turned(own.p, place.cosine, place.sine);
  }

  void place_two_points(int index, const Attachment& own, const V& at, const Attachment& tip,
                        const V& tip_at) {
    const V inside = vector(tip.p) - vector(own.p);
    const V outside = tip_at - at;
    const J square = dot(inside, inside);
    place_by(index, own, at, dot(inside, outside) / square, dot(left_of(inside), outside) / square);
  }

  void place_by(int index, const Attachment& own, const V& at, const J& cosine, const J& sine) {
    Place& place = bodies_[static_cast<std::size_t>(index)];
    place.cosine = cosine;
    place.sine = sine;
    place.angle = atan2(place.sine, place.cosine);
    if constexpr (std::is_floating_point_v<Scalar>) {
      const Scalar turn = Scalar(2) * std::numbers::pi_v<Scalar>;
      const auto wanted = static_cast<Scalar>(near_[3 * index + 2]);
      place.angle.x += turn * std::round((wanted - place.angle.x) / turn);
    }
    place.centre = at - turned(own.p, place.cosine, place.sine);
  }

  void take_slid(const DyadStep& step) {
    const J angle = angle_by(step.turn);
    const V line = along(step);
    const V guide = place_of(step.to);
    const V arm = turned(step.tip.p - step.own.p, cos(angle), sin(angle));
    const J wanted = driven(step.driver);
    const bool is_x = step.coordinate == Coordinate::x;
    const J way = is_x ? (wanted - guide.x - arm.x) / line.x : (wanted - guide.y - arm.y) / line.y;
    place_turned(step.first, step.own, guide + way * line, angle);
  }

  /// way = s u + h (left of u), with u along the line and h what the line passes the pin by.
  void take_own_line(const DyadStep& step) {
    const V from = place_of(step.from);
    const V way = place_of(step.to) - from;
    const J c = cos(constant(step.direction));
    const J s = sin(constant(step.direction));
    const J h = dot(left_of(V{c, s}), vector(step.tip.p) - vector(step.own.p));
    const J square = dot(way, way);
    const J along = static_cast<Scalar>(step.side) * sqrt(square - h * h);
    const V u = (constant(1.0) / square) * (along * way - h * left_of(way));
    place_by(step.first, step.own, from, c * u.x + s * u.y, c * u.y - s * u.x);
  }

  /// The tip by the circles about `from` and `to`. The distance from the line between the centres
  /// by Heron's factors.
  V two_circles(const DyadStep& step, const J& to_square) const {
    const V from = place_of(step.from);
    const V way = place_of(step.to) - from;
    const J square = dot(way, way);
    const J d = sqrt(square);
    const J r = sqrt(square_of(step.tip, step.own));
    const J s = sqrt(to_square);
    const J product = (r + s + d) * (r + s - d) * (d + r - s) * (d + s - r);
    const J forward = static_cast<Scalar>(0.5) * (square + r * r - s * s) / square;
    const J aside = static_cast<Scalar>(0.5 * step.side) * sqrt(product) / square;
    return from + forward * way + aside * left_of(way);
  }

  /// The tip by the circle about `from` and the line that lies `across` beside the guide.
  V circle_line(const DyadStep& step, const J& across) const {
    const V line = along(step);
    const V from = place_of(step.from);
    const J aside = dot(left_of(line), place_of(step.to) - from) + across;
    const J r = sqrt(square_of(step.tip, step.own));
    const J forward = static_cast<Scalar>(step.side) * sqrt((r - aside) * (r + aside));
    return from + forward * line + aside * left_of(line);
  }

  const std::vector<DriverState>& drivers_;
  const Eigen::VectorXd& near_;
  std::vector<Place> bodies_;
};

}  // namespace

template <class Scalar>
void solve_dyads(const DyadPlan& plan, const std::vector<DriverState>& drivers,
                 const Eigen::VectorXd& near, InstantIn<Scalar>& instant) {
  DyadSolver<Scalar> solver(drivers, near);
  for (const DyadStep& step : plan.steps) solver.take(step);
  const auto lambda = std::move(instant.lambda);
  instant = solver.result();
  instant.lambda = lambda;
}

template void solve_dyads(const DyadPlan&, const std::vector<DriverState>&, const Eigen::VectorXd&,
                          InstantIn<float>&);
template void solve_dyads(const DyadPlan&, const std::vector<DriverState>&, const Eigen::VectorXd&,
                          InstantIn<double>&);
template void solve_dyads(const DyadPlan&, const std::vector<DriverState>&, const Eigen::VectorXd&,
                          InstantIn<long double>&);
template void solve_dyads(const DyadPlan&, const std::vector<DriverState>&, const Eigen::VectorXd&,
                          InstantIn<Decimal<5>>&);

}  // namespace boxbeam::charts
