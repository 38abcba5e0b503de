#pragma once

namespace boxbeam::recorded {

/// What `ChannelSource::load` says of a column that is no load: it moves the beam. Its `what` is
/// "x", "z", "angle" of a path or "a_x" to "alpha_z" of a sensor.
inline constexpr const char* motion_of_beam = "[motion]";

}  // namespace boxbeam::recorded
