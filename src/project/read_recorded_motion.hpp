#pragma once

#include <array>
#include <optional>
#include <vector>

#include "boxbeam/mechanism/recorded/motion_columns.hpp"
#include "recorded_reader.hpp"

namespace boxbeam::readers {

/// How a beam moves whose loads come from files: by what a sensor at its start reads, or by the
/// path of it.
class RecordedMotion {
 public:
  /// Reads [motion], behind the loads; whether the beam leaves the plane of x and z.
  bool read(TableReader& root, ChannelFiles& files, recorded::Loads& loads);

  /// What is read of it over time.
  recorded::MotionChannels motion_in(TableReader& root, const recorded::Channels& channels) const;

  /// The columns that it comes from.
  std::vector<recorded::ChannelSource> sources_in(const ChannelFiles& files,
                                                  const recorded::Channels& channels) const;

 private:
  std::array<std::optional<std::size_t>, 3> path_;    ///< x, z, angle
  std::array<std::optional<std::size_t>, 9> sensor_;  ///< acceleration, omega, alpha
  double path_gravity_ = 0.0;
};

}  // namespace boxbeam::readers
