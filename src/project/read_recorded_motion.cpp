#include "read_recorded_motion.hpp"

#include "boxbeam/mechanism/recorded/derivatives.hpp"
#include "recorded_terms.hpp"

namespace boxbeam::readers {
namespace {

/// The columns of a motion, in the order in which their channels are kept.
constexpr std::array sensor_words{"a_x",     "a_y",     "a_z",     "omega_x", "omega_y",
                                  "omega_z", "alpha_x", "alpha_y", "alpha_z"};
constexpr std::array sensor_units{"m/s^2", "rad/s", "rad/s^2"};
constexpr std::array path_words{"x", "z", "angle"};
constexpr std::array path_units{"m", "m", "rad"};

constexpr WantedDimension angular_acceleration{
    {0, 0, -2, 1}, "an angular acceleration", "\"0.5 rad/s^2\""};

}  // namespace

bool RecordedMotion::read(TableReader& root, ChannelFiles& files, recorded::Loads& loads) {
  if (!root.has("motion")) return false;
  TableReader table =
      root.table({"motion", "of the beam, whose inertia it adds; without it it is contained"});
  loads.inertia = true;
  if (loads.as_cuts) {
    table.problem("", "cut forces contain the beam's inertia",
                  "remove [motion]; it belongs to forces at places");
  }
  if (!loads.gravity.isZero(0.0)) {
    table.problem("", "the weight would count twice: it is in the motion",
                  "remove \"gravity\" from [balance]");
  }
  const std::optional<std::size_t> file = files.file_of(table);
  TableReader columns = table.table({"columns", "of the file, by what they are"});
  const double gravity =
      table.not_negative({"gravity", "downwards, beside a path; what a sensor reads contains it"},
                         wanted::acceleration, 9.81);
  table.finish();
  if (!file) {
    columns.accept_all();
    return false;
  }
  const auto take = [&](const Key& key, const WantedDimension& wanted,
                        std::optional<std::size_t>& channel) {
    if (columns.has(key)) channel = files.channel_of(columns, key, *file, wanted);
  };
  const bool path = columns.says_one_of(
      {{{"x", "z", "angle"}},
       {{"a_x", "a_y", "a_z", "omega_x", "omega_y", "omega_z", "alpha_x", "alpha_y", "alpha_z"},
        false}});
  if (!path) {
    columns.accept_all();
    columns.problem("", "the columns of a motion are a path or the readings of a sensor",
                    "write x, z and angle of the beam's start; or a_x, a_z, omega_y, alpha_y");
    return false;
  }
  if (columns.has("x")) {
    take({"x", "of the beam's start, in the plane of motion"}, wanted::length, path_[0]);
    take({"z", "likewise, upwards"}, wanted::length, path_[1]);
    take({"angle", "of the beam, from x towards z"}, wanted::angle, path_[2]);
    for (const char* key : {"z", "angle"}) {
      if (!columns.has(key)) columns.text(key);  // says that it is missing
    }
    path_gravity_ = gravity;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    take({sensor_words[k], "acceleration of the beam's start less gravity, as a sensor reads it"},
         wanted::acceleration, sensor_[k]);
    take({sensor_words[3 + k], "angular velocity, about the beam's axes"}, wanted::angular_velocity,
         sensor_[3 + k]);
    take({sensor_words[6 + k], "angular acceleration; without it that of the angular velocity"},
         angular_acceleration, sensor_[6 + k]);
  }
  columns.finish();
  return sensor_[1] || sensor_[3] || sensor_[5] || sensor_[6] || sensor_[8];
}

recorded::MotionChannels RecordedMotion::motion_in(TableReader& root,
                                                   const recorded::Channels& channels) const {
  const auto values_of = [&](const std::optional<std::size_t>& channel) {
    return channel ? channels.values[*channel] : std::vector<double>();
  };
  if (path_[0] && path_[1] && path_[2]) {
    if (channels.times.size() < 3) {
      if (root.problems().empty() && root.problems().recorder == nullptr) {
        root.problem("motion", "a path of two instants has no acceleration",
                     "give three instants at least");
      }
      return {};
    }
    return recorded::motion_of_path(channels.times, values_of(path_[0]), values_of(path_[1]),
                                    values_of(path_[2]), path_gravity_);
  }
  recorded::MotionChannels motion;
  for (std::size_t k = 0; k < 3; ++k) {
    motion.acceleration[k] = values_of(sensor_[k]);
    motion.omega[k] = values_of(sensor_[3 + k]);
    motion.alpha[k] = values_of(sensor_[6 + k]);
    // A gyroscope reads the rate of turning alone.
    const std::size_t known = motion.omega[k].size();
    if (motion.alpha[k].empty() && known >= 2 && known == channels.times.size())
      motion.alpha[k] = recorded::derivatives_of(channels.times, motion.omega[k]).first;
  }
  return motion;
}

std::vector<recorded::ChannelSource> RecordedMotion::sources_in(
    const ChannelFiles& files, const recorded::Channels& channels) const {
  std::vector<recorded::ChannelSource> sources;
  const auto note = [&](const std::optional<std::size_t>& channel, const char* what,
                        const char* unit) {
    if (!channel || channels.values[*channel].empty()) return;
    recorded::ChannelSource& of = sources.emplace_back();
    of.load = recorded::motion_of_beam;
    of.what = what;
    add_column(files, channels, *channel, 1.0, unit, of);
  };
  for (std::size_t k = 0; k < path_.size(); ++k) note(path_[k], path_words[k], path_units[k]);
  for (std::size_t k = 0; k < sensor_.size(); ++k)
    note(sensor_[k], sensor_words[k], sensor_units[k / 3]);
  return sources;
}

}  // namespace boxbeam::readers
