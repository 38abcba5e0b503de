#include "charts/dyad_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>

#include "boxbeam/mechanism/planar/constraints.hpp"

namespace boxbeam::charts {
namespace {

using planar::Attachment;
using planar::Coordinate;
using Kind = DyadStep::Kind;

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

}  // namespace

DyadPlan plan_dyads(const planar::Mechanism& mechanism, const Eigen::VectorXd& position) {
  return Planner(mechanism, position).plan();
}

}  // namespace boxbeam::charts
