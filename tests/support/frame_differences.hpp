#pragma once

#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/frame/statics.hpp"

namespace test {

inline boxbeam::frame::Vector6 vector_of(const boxbeam::CutForces& of) {
  boxbeam::frame::Vector6 cut;
  cut << of.N.value(), of.V_y.value(), of.V_z.value(), of.T.value(), of.M_y.value(), of.M_z.value();
  return cut;
}

inline boxbeam::frame::Vector6 cut_at(const boxbeam::frame::Equilibrium& at, int member, double s,
                                      boxbeam::Side side) {
  return vector_of(
      at.members[static_cast<std::size_t>(member)].cut.at({boxbeam::si<boxbeam::Length>(s), side}));
}

/// Differences of quantities of six numbers, by the largest of forces (shifts) and of couples
/// (turns); what is smaller than `least` is nothing.
class Differences {
 public:
  explicit Differences(double least) : least_(least) {}

  void add(const boxbeam::frame::Vector6& a, const boxbeam::frame::Vector6& b) {
    for (int k = 0; k < 2; ++k) {
      size_[k] = std::max(size_[k], b.segment<3>(3 * k).norm());
      const double missed = (a - b).segment<3>(3 * k).norm();
      missed_[k] = std::max(missed_[k], std::isfinite(missed) ? missed : 1e300);
    }
  }
  double largest() const {
    double worst = 0.0;
    for (int k = 0; k < 2; ++k) worst = std::max(worst, missed_[k] / std::max(size_[k], least_));
    return worst;
  }
  /// The largest of forces or shifts.
  double size() const { return size_[0]; }

 private:
  double least_;
  double size_[2] = {0.0, 0.0}, missed_[2] = {0.0, 0.0};
};

}  // namespace test
