#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/mechanism/common/time_span.hpp"
#include "boxbeam/mechanism/recorded/channel_loads.hpp"

namespace boxbeam::recorded {

/// What a channel does to the beam, and from where it is.
struct ChannelSource {
  std::string load;    ///< "lug", or "s = 1.2 m" of cut forces
  std::string what;    ///< "F_z", "times [0, 0, -10] kN"
  std::string column;  ///< as the file calls it
  std::string file;
  std::string unit;  ///< of `low` and `high`
  double low = 0.0, high = 0.0;
  bool has_moment = false;  ///< about its place
};

/// Where what the given loads lack to be in balance acts.
struct Balance {
  std::string name;
  double s = 0.0;         ///< [m]
  std::size_t point = 0;  ///< its index among the points of the loads
};

/// The loads of a beam over time, as a case gives them. What acts is in balance.
struct Loads {
  ChannelLoads acting;
  bool as_cuts = false;                               ///< cut forces are given, not what acts
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();  ///< beam axes; zero: contained in the loads
  bool inertia = false;                               ///< the beam's own is added, by its motion
  std::optional<Balance> balance;
  std::vector<double> held;  ///< places that hold the beam against buckling [m]
  std::vector<ChannelSource> sources;
  /// Where V given and V by the slope of M differ most, as a part of the largest V; of cut forces.
  double shear_defect = 0.0;
  std::string shear_defect_at;  ///< "V_z between s = 1 m and 1.5 m at t = 3.2 s"
  Duration duration;
  std::shared_ptr<const std::vector<std::string>> names;  ///< of the points, which look at them
};

}  // namespace boxbeam::recorded
