#include "charts/dyads.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "charts/jet.hpp"

namespace boxbeam::charts {
namespace {

using planar::Attachment;
using planar::Coordinate;
using Kind = DyadStep::Kind;

// ---- the plan -------------------------------------------------------------------------------

/// The ends of a joint, the one on a given body first; nothing where the body has no part in it.
std::optional<std::pair<Attachment, Attachment>> seen_from(int body, const Attachment& a,
                                                           const Attachment& b) {
  if (a.body == body) return std::pair{a, b};
  if (b.body == body) return std::pair{b, a};
  return std::nullopt;
}

class Planner {
 public:
  Planner(const planar::Mechanism& mechanism, const Eigen::VectorXd& position)
      : mechanism_(mechanism), position_(position), known_(mechanism.bodies.size(), 0) {
    int drivers = 0;
    for (const planar::Joint& joint : mechanism.joints) {
      driver_of_joint_.push_back(planar::is_driver(joint) ? drivers++ : -1);
    }
  }

  DyadPlan plan() {
    bool found = true;
    while (found) {
      found = false;
      for (int body = 0; body < count() && !found; ++body) {
        if (is_known(body)) continue;
        found = turned(body) || slid(body) || single(body);
      }
      for (int first = 0; first < count() && !found; ++first) {
        for (int second = 0; second < count() && !found; ++second) {
          if (first != second && !is_known(first) && !is_known(second)) found = pair(first, second);
        }
      }
    }
    std::vector<std::string> left;
    for (int body = 0; body < count(); ++body) {
      if (!is_known(body)) left.push_back(mechanism_.bodies[static_cast<std::size_t>(body)].name);
    }
    if (!left.empty()) plan_.failure = fmt::format("no dyad: {}", fmt::join(left, ", "));
    return plan_;
  }

 private:
  int count() const { return static_cast<int>(mechanism_.bodies.size()); }
  bool is_known(int body) const {
    return body == planar::ground || known_[static_cast<std::size_t>(body)] != 0;
  }
  void take(DyadStep step) {
    if (step.kind != Kind::turned && step.kind != Kind::slid) step.side = side_of(step);
    known_[static_cast<std::size_t>(step.first)] = 1;
    if (step.second != planar::ground) known_[static_cast<std::size_t>(step.second)] = 1;
    plan_.steps.push_back(step);
  }

  /// On which side of the line between the known points, or which way along the known line.
  int side_of(const DyadStep& step) const {
    const Eigen::Vector2d from = planar::position_of(step.from, position_);
    const Eigen::Vector2d to = planar::position_of(step.to, position_);
    const Eigen::Vector2d tip = planar::position_of(step.tip, position_);
    if (step.kind == Kind::own_line) {
      const double angle = step.direction + position_[3 * step.first + 2];
      return Eigen::Vector2d(std::cos(angle), std::sin(angle)).dot(to - from) < 0.0 ? -1 : 1;
    }
    if (step.kind == Kind::circle_line || step.kind == Kind::pin_pin_line) {
      const double turn = step.to.body == planar::ground ? 0.0 : position_[3 * step.to.body + 2];
      const double angle = step.direction + turn;
      const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
      return along.dot(tip - from) < 0.0 ? -1 : 1;
    }
    const Eigen::Vector2d way = to - from;
    const Eigen::Vector2d reach = tip - from;
    return way.x() * reach.y() - way.y() * reach.x() < 0.0 ? -1 : 1;
  }

  /// A pin, or what holds like one, between a body and others for which `wanted` holds.
  template <class Wanted>
  std::optional<std::pair<Attachment, Attachment>> pin_of(int body, const Wanted& wanted) const {
    for (const planar::Joint& joint : mechanism_.joints) {
      std::optional<std::pair<Attachment, Attachment>> ends;
      if (const auto* pin = std::get_if<planar::Pin>(&joint.kind)) {
        ends = seen_from(body, pin->a, pin->b);
      } else if (const auto* rigid = std::get_if<planar::Rigid>(&joint.kind)) {
        ends = seen_from(body, rigid->a, rigid->b);
        if (ends && !is_known(ends->second.body)) ends.reset();  // a dyad's bodies turn
      }
      if (ends && wanted(ends->second.body)) return ends;
    }
    return std::nullopt;
  }
  std::optional<std::pair<Attachment, Attachment>> pin_to_known(int body) const {
    return pin_of(body, [&](int other) { return is_known(other); });
  }

  /// What fixes a body's angle against a known one.
  std::optional<DyadStep::Turn> turn_of(int body) const {
    for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
      const planar::JointKind& kind = mechanism_.joints[i].kind;
      if (const auto* driven = std::get_if<planar::Driven>(&kind)) {
        if (driven->coordinate != Coordinate::angle) continue;
        const auto ends = seen_from(body, driven->point, driven->other);
        if (!ends || !is_known(ends->second.body)) continue;
        const double sign = driven->point.body == body ? 1.0 : -1.0;
        return DyadStep::Turn{ends->second.body, 1.0, 0.0, driver_of_joint_[i], sign};
      }
      if (const auto* coupling = std::get_if<planar::AngleCoupling>(&kind)) {
        if (coupling->a.body == body && is_known(coupling->b.body)) {
          return DyadStep::Turn{coupling->b.body, coupling->ratio, coupling->offset};
        }
        if (coupling->b.body == body && is_known(coupling->a.body) && coupling->ratio != 0.0) {
          return DyadStep::Turn{coupling->a.body, 1.0 / coupling->ratio,
                                -coupling->offset / coupling->ratio};
        }
      }
      if (const auto* rigid = std::get_if<planar::Rigid>(&kind)) {
        if (rigid->a.body == body && is_known(rigid->b.body)) {
          return DyadStep::Turn{rigid->b.body, 1.0, rigid->angle};
        }
        if (rigid->b.body == body && is_known(rigid->a.body)) {
          return DyadStep::Turn{rigid->a.body, 1.0, -rigid->angle};
        }
      }
      if (const auto* slider = std::get_if<planar::Slider>(&kind)) {
        if (slider->point.body == body && is_known(slider->guide.body)) {
          return DyadStep::Turn{slider->guide.body, 1.0, slider->angle};
        }
      }
    }
    return std::nullopt;
  }

  const planar::Slider* slider_of(int body) const {
    for (const planar::Joint& joint : mechanism_.joints) {
      const auto* slider = std::get_if<planar::Slider>(&joint.kind);
      if (slider != nullptr && slider->point.body == body && is_known(slider->guide.body)) {
        return slider;
      }
    }
    return nullptr;
  }

  bool turned(int body) {
    const auto pin = pin_to_known(body);
    const auto turn = turn_of(body);
    if (!pin || !turn) return false;
    DyadStep step;
    step.first = body;
    std::tie(step.own, step.from) = *pin;
    step.turn = *turn;
    take(step);
    return true;
  }

  bool slid(int body) {
    const planar::Slider* slider = slider_of(body);
    if (slider == nullptr) return false;
    for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
      const auto* driven = std::get_if<planar::Driven>(&mechanism_.joints[i].kind);
      if (driven == nullptr || driven->point.body != body) continue;
      if (driven->coordinate != Coordinate::x && driven->coordinate != Coordinate::y) continue;
      DyadStep step;
      step.kind = Kind::slid;
      step.first = body;
      step.own = slider->point;
      step.to = slider->guide;
      step.direction = slider->direction;
      step.turn = {slider->guide.body, 1.0, slider->angle};
      step.tip = driven->point;
      step.coordinate = driven->coordinate;
      step.driver = driver_of_joint_[i];
      take(step);
      return true;
    }
    return false;
  }

  /// Pinned to a known point, with a distance or a line for its other point.
  bool single(int body) {
    const auto pin = pin_to_known(body);
    if (!pin) return false;
    DyadStep step;
    step.first = body;
    std::tie(step.own, step.from) = *pin;
    for (std::size_t i = 0; i < mechanism_.joints.size(); ++i) {
      const planar::JointKind& kind = mechanism_.joints[i].kind;
      std::optional<std::pair<Attachment, Attachment>> ends;
      if (const auto* distance = std::get_if<planar::Distance>(&kind)) {
        ends = seen_from(body, distance->a, distance->b);
        step.length = distance->length;
      } else if (const auto* driven = std::get_if<planar::Driven>(&kind)) {
        if (driven->coordinate != Coordinate::length) continue;
        ends = seen_from(body, driven->point, driven->other);
        step.driver = driver_of_joint_[i];
      }
      step.kind = Kind::two_circles;
      if (const auto* slot = std::get_if<planar::PinInSlot>(&kind)) {
        step.kind = Kind::circle_line;
        if (slot->point.body == body) ends = std::pair{slot->point, slot->guide};
        if (slot->guide.body == body) {
          step.kind = Kind::own_line;
          ends = std::pair{slot->guide, slot->point};
        }
        step.direction = slot->direction;
      }
      if (!ends || !is_known(ends->second.body)) {
        step.driver = -1;
        continue;
      }
      std::tie(step.tip, step.to) = *ends;
      take(step);
      return true;
    }
    return false;
  }

  bool pair(int first, int second) {
    const auto pin = pin_to_known(first);
    const auto between = pin_of(first, [&](int other) { return other == second; });
    if (!pin || !between) return false;
    DyadStep step;
    step.first = first;
    step.second = second;
    std::tie(step.own, step.from) = *pin;
    std::tie(step.tip, step.second_tip) = *between;
    const planar::Slider* slider = slider_of(second);
    if (slider != nullptr) {
      step.kind = Kind::pin_pin_line;
      step.second_own = slider->point;
      step.to = slider->guide;
      step.direction = slider->direction;
      step.turn = {slider->guide.body, 1.0, slider->angle};
      take(step);
      return true;
    }
    const auto far = pin_to_known(second);
    if (!far) return false;
    step.kind = Kind::pin_pin_pin;
    std::tie(step.second_own, step.to) = *far;
    take(step);
    return true;
  }

  const planar::Mechanism& mechanism_;
  const Eigen::VectorXd& position_;
  std::vector<char> known_;
  std::vector<int> driver_of_joint_;
  DyadPlan plan_;
};

// ---- the solution ---------------------------------------------------------------------------

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

DyadPlan plan_dyads(const planar::Mechanism& mechanism, const Eigen::VectorXd& position) {
  return Planner(mechanism, position).plan();
}

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
