#include "boxbeam/mechanism/planar/mechanism.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"

namespace boxbeam::planar {
namespace {

template <class Items>
int index_by_name(const Items& items, std::string_view name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.name == name; });
  return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

}  // namespace

int equations_of(const Joint& joint) {
  if (std::holds_alternative<Rigid>(joint.kind)) return 3;
  const bool two =
      std::holds_alternative<Pin>(joint.kind) || std::holds_alternative<Slider>(joint.kind);
  return two ? 2 : 1;
}

bool is_length_equation(const Joint& joint, int row) {
  if (std::holds_alternative<Slider>(joint.kind)) return row == 0;
  if (std::holds_alternative<Rigid>(joint.kind)) return row < 2;
  if (std::holds_alternative<AngleCoupling>(joint.kind)) return false;
  const auto* driven = std::get_if<Driven>(&joint.kind);
  return driven == nullptr || driven->coordinate != Coordinate::angle;
}

std::pair<Attachment, Attachment> ends_of(const Joint& joint) {
  struct Ends {
    using Pair = std::pair<Attachment, Attachment>;
    Pair operator()(const Slider& slider) const { return {slider.point, slider.guide}; }
    Pair operator()(const PinInSlot& slot) const { return {slot.point, slot.guide}; }
    Pair operator()(const Rack& rack) const { return {rack.pinion, rack.rack}; }
    Pair operator()(const Driven& driven) const { return {driven.point, driven.other}; }
    Pair operator()(const Pin& pin) const { return {pin.a, pin.b}; }
    Pair operator()(const Rigid& rigid) const { return {rigid.a, rigid.b}; }
    Pair operator()(const Distance& distance) const { return {distance.a, distance.b}; }
    Pair operator()(const AngleCoupling& coupling) const { return {coupling.a, coupling.b}; }
    Pair operator()(const Gear& gear) const { return {gear.a, gear.b}; }
  };
  return std::visit(Ends{}, joint.kind);
}

Eigen::Index Mechanism::equations() const {
  Eigen::Index sum = 0;
  for (const Joint& joint : joints) sum += equations_of(joint);
  return sum;
}

int body_index(const Mechanism& mechanism, std::string_view name) {
  return index_by_name(mechanism.bodies, name);
}

int joint_index(const Mechanism& mechanism, std::string_view name) {
  return index_by_name(mechanism.joints, name);
}

std::vector<std::string> names_of_joints(const Mechanism& mechanism,
                                         const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const int joint : joints) {
    names.push_back(mechanism.joints[static_cast<std::size_t>(joint)].name);
  }
  return names;
}

Eigen::VectorXd sketch_of(const Mechanism& mechanism) {
  Eigen::VectorXd q(mechanism.coordinates());
  Eigen::Index i = 0;
  for (const Body& body : mechanism.bodies) {
    q.segment<2>(i) = body.sketch.centre;
    q[i + 2] = body.sketch.angle;
    i += 3;
  }
  return q;
}

Eigen::VectorXd start_velocity_of(const Mechanism& mechanism) {
  Eigen::VectorXd v(mechanism.coordinates());
  Eigen::Index i = 0;
  for (const Body& body : mechanism.bodies) {
    v.segment<3>(i) = body.start_velocity;
    i += 3;
  }
  return v;
}

double size_of(const Mechanism& mechanism) {
  double size = 0.0;
  std::vector<Attachment> on_ground;
  for (const Joint& joint : mechanism.joints) {
    if (!is_length_equation(joint, 0)) continue;  // its points only say where moments act
    const auto [a, b] = ends_of(joint);
    for (const Attachment& end : {a, b}) {
      if (end.body != ground) {
        size = std::max(size, end.p.norm());
      } else if (!is_driver(joint)) {
        on_ground.push_back(end);
      }
    }
    if (const auto* distance = std::get_if<Distance>(&joint.kind)) {
      size = std::max(size, distance->length);
    }
  }
  for (const Attachment& end : on_ground) {
    size = std::max(size, (end.p - on_ground.front().p).norm());
  }
  return size > 0.0 ? size : 1.0;
}

TimeSpan time_span_of(const Mechanism& mechanism) {
  TimeSpan span;
  std::vector<double> omegas;
  double end = 0.0;
  bool endless = false;
  const auto take = [&](const Driver& driver, bool turning) {
    const DriverTiming timing = timing_of(driver, turning);
    omegas.insert(omegas.end(), timing.omegas.begin(), timing.omegas.end());
    span.closed = span.closed && timing.repeats;
    span.highest_omega = std::max(span.highest_omega, timing.highest_omega);
    end = std::max(end, timing.end);
    endless = endless || (!timing.repeats && timing.end <= 0.0);
  };
  for (const Joint& joint : mechanism.joints) {
    const auto* driven = std::get_if<Driven>(&joint.kind);
    if (driven != nullptr) take(driven->driver, driven->coordinate == Coordinate::angle);
  }
  for (const AppliedForce& force : mechanism.forces) {
    if (const auto* point = std::get_if<PointForce>(&force.kind)) take(point->size, false);
    if (const auto* couple = std::get_if<Couple>(&force.kind)) take(couple->size, false);
  }
  span.begin = mechanism.duration.settle;
  const std::optional<double> period = common_period_of(omegas);
  if (mechanism.duration.length > 0.0) {
    span.length = mechanism.duration.length;
    // A duration that holds whole periods, on drivers that repeat, is a closed motion.
    const double periods = period ? span.length / *period : 0.5;
    span.closed = span.closed && std::abs(periods - std::round(periods)) < 1e-9 * periods;
  } else if (span.closed && period) {
    span.length = *period;
  } else if (!span.closed && end > 0.0 && omegas.empty() && !endless) {
    span.length = end - span.begin;
  }
  if (!(span.length > 0.0)) {
    throw AnalysisError(
        {"it is not known how long the motion lasts: drivers and forces have no common period "
         "(within "
         "1000 cycles of the fastest), or some repeat and others end; give [motion] duration",
         "mechanism",
         {},
         {},
         {}});
  }
  return span;
}

}  // namespace boxbeam::planar
