#include "boxbeam/mechanism/planar/mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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
  const bool two =
      std::holds_alternative<Pin>(joint.kind) || std::holds_alternative<Slider>(joint.kind);
  return two ? 2 : 1;
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

double period_of(const Mechanism& mechanism) {
  for (const Joint& joint : mechanism.joints) {
    if (const auto* driven = std::get_if<Driven>(&joint.kind)) {
      return 2.0 * std::numbers::pi / std::abs(driven->driver.omega);
    }
  }
  return 0.0;
}

}  // namespace boxbeam::planar
