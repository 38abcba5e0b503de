#include "boxbeam/verification/bent_axis.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <variant>

namespace boxbeam {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using planar::Attachment;

using planar::Hold;

/// Calls `f(attachment, hold)` for the ends of a force.
template <class F>
struct EndsOfForce {
  const F& f;

  void operator()(auto& of) const requires requires { of.a; }
  {
    using Of = std::remove_cvref_t<decltype(of)>;
    constexpr bool line =
        std::is_same_v<Of, planar::Spring> || std::is_same_v<Of, planar::PinWithClearance>;
    constexpr Hold hold = line ? Hold::place : Hold::clamp;
    f(of.a, hold);
    f(of.b, hold);
  }
  void operator()(auto& of) const requires requires { of.turns; }
  { f(of.at, of.turns ? Hold::clamp : Hold::place); }
};

/// Calls `f(attachment, hold)` for every end of a joint or force that is on a body.
template <class Mechanism, class F>
void for_each_end(Mechanism& mechanism, int body, const F& f) {
  const auto on_body = [&](auto& at, Hold hold) {
    if (at.body == body) f(at, hold);
  };
  for (auto& joint : mechanism.joints) {
    const auto [first, second] = planar::ends_in(joint);
    const auto [hold, other] = planar::holds_of(joint);
    on_body(*first, hold);
    on_body(*second, other);
  }
  for (auto& force : mechanism.forces)
    std::visit(EndsOfForce<decltype(on_body)>{on_body}, force.kind);
}

/// Whether the angle of the axis is wanted.
bool turns_with_axis(Hold hold) { return hold == Hold::clamp || hold == Hold::angle; }

}  // namespace

DividedAxis::DividedAxis(const planar::Mechanism& mechanism, const ElasticBody& elastic)
    : mechanism_(&mechanism), elastic_(&elastic) {
  const double length = elastic_->length;
  std::vector<double> fixed{0.0, length};
  for (const flexible::LinkStretch& stretch : elastic_->stretches) fixed.push_back(stretch.start);
  std::vector<double> held;
  std::optional<double> turned;
  for_each_end(mechanism, elastic_->body, [&](const Attachment& at, Hold hold) {
    const double s = std::clamp(at.p.x() + elastic_->centre, 0.0, length);
    held.push_back(s);
    if (turns_with_axis(hold)) turned = s;
  });
  fixed.insert(fixed.end(), held.begin(), held.end());
  std::sort(fixed.begin(), fixed.end());
  const auto near = [&](double a, double b) { return b - a < 1e-6 * length; };
  fixed.erase(std::unique(fixed.begin(), fixed.end(), near), fixed.end());
  // Of deflections the square of an element's length counts, of the defect that of a group's,
  // whose ends load the elastic links and so divide them.
  constexpr double in_all = 32.0;
  constexpr int in_group = 4;
  s_.push_back(fixed.front());
  groups_.push_back(0);
  for (std::size_t k = 1; k < fixed.size(); ++k) {
    const double gap = fixed[k] - fixed[k - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(in_all * gap / length)));
    for (int i = 1; i <= parts; ++i) {
      s_.push_back(fixed[k - 1] + gap * i / parts);
      if (i % in_group == 0 || i == parts) groups_.push_back(s_.size() - 1);
    }
  }
  for (std::size_t k = 1; k < s_.size(); ++k) {
    const double middle = 0.5 * (s_[k - 1] + s_[k]);
    const auto stretch = std::find_if(
        elastic_->stretches.begin(), elastic_->stretches.end(),
        [&](const flexible::LinkStretch& of) { return middle < of.start + of.length; });
    const double x = middle - stretch->start;
    const double h = s_[k] - s_[k - 1];
    elements_.push_back({h, stretch->EA(x), stretch->GA(x), stretch->EI(x), h * stretch->mass(x),
                         h * stretch->rotary(x)});
  }
  held_ = {node_at(held.empty() ? 0.0 : *std::min_element(held.begin(), held.end())),
           node_at(held.empty() ? length : *std::max_element(held.begin(), held.end()))};
  reference_ = node_at(turned.value_or(s_[static_cast<std::size_t>(held_.first)]));
  straight_ = bent(Strains::Zero(3, static_cast<Index>(elements_.size())));
}

Index DividedAxis::node_at(double s) const {
  const auto nearest = std::min_element(
      s_.begin(), s_.end(), [&](double a, double b) { return std::abs(a - s) < std::abs(b - s); });
  return nearest - s_.begin();
}
Index DividedAxis::node_of(const Attachment& at) const {
  return node_at(at.p.x() + elastic_->centre);
}

BentAxis DividedAxis::bent(const Strains& strains) const {
  const Index count = strains.cols();
  BentAxis axis;
  axis.node.setZero(2, count + 1);
  axis.angle.setZero(count + 1);
  axis.middle.resize(2, count);
  axis.middle_angle.resize(count);
  for (Index k = 0; k < count; ++k) {
    const double h = elements_[static_cast<std::size_t>(k)].length;
    const double angle = axis.angle[k] + 0.5 * h * strains(2, k);
    axis.angle[k + 1] = axis.angle[k] + h * strains(2, k);
    axis.middle_angle[k] = angle;
    const Vector2d step =
        h * (Eigen::Rotation2Dd(angle) * Vector2d(1.0 + strains(0, k), strains(1, k)));
    axis.middle.col(k) = axis.node.col(k) + 0.5 * step;
    axis.node.col(k + 1) = axis.node.col(k) + step;
  }
  const double turn = axis.angle[reference_];
  const Eigen::Rotation2Dd back(-turn);
  const Vector2d origin = axis.node.col(reference_);
  const Vector2d to(s_[static_cast<std::size_t>(reference_)] - elastic_->centre, 0.0);
  const auto put = [&](Eigen::Matrix2Xd& places) {
    for (Index k = 0; k < places.cols(); ++k) {
      places.col(k) = to + back * Vector2d(places.col(k) - origin);
    }
  };
  put(axis.node);
  put(axis.middle);
  axis.angle.array() -= turn;
  axis.middle_angle.array() -= turn;
  return axis;
}

planar::Mechanism DividedAxis::with(const BentAxis& axis) const {
  planar::Mechanism mechanism = *mechanism_;
  for_each_end(mechanism, elastic_->body, [&](Attachment& at, Hold) {
    const Index node = node_of(at);
    at.p = axis.node.col(node) + Eigen::Rotation2Dd(axis.angle[node]) * Vector2d(0.0, at.p.y());
  });
  return mechanism;
}

std::string obstacle_to_bent_axis(const planar::Mechanism& mechanism, int beam) {
  std::optional<double> turned;
  std::string obstacle;
  for_each_end(mechanism, beam, [&](const Attachment& at, Hold hold) {
    if (hold == Hold::guide || hold == Hold::teeth)
      obstacle = "another body moves along the bent beam";
    if (!turns_with_axis(hold)) return;
    if (turned && *turned != at.p.x()) obstacle = "the beam's angle is held at two places";
    turned = at.p.x();
  });
  return obstacle;
}

}  // namespace boxbeam
