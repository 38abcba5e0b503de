#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "recorded_reader.hpp"

namespace boxbeam::readers {

/// A part of loads from files: what does not change, or what one of a channel's unit does.
struct Term {
  std::optional<std::size_t> channel;
  std::size_t place = 0;  ///< of the load, or the station
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
  std::string what = {};
  double shown = 1e-3;  ///< by which the channel's values are multiplied for people
  std::string unit = {};
};

/// The parts that were read.
struct RecordedTerms {
  std::vector<Term> terms;
  bool in_space = false;  ///< whether any leaves the plane of x and z
};

/// What columns of three forces and three moments are called, and mean.
struct SixColumns {
  std::array<const char*, 6> words, meanings;
};

double read_factor(TableReader& table);

/// The dimension of the first three, or of the others.
const WantedDimension& dimension_of(std::size_t k);

/// A term for each column that is there; which are. `place`: of the load, or the station.
std::array<bool, 6> read_six(TableReader& columns, const SixColumns& of, std::size_t file,
                             double factor, std::size_t place, ChannelFiles& files,
                             RecordedTerms& into);

/// The column behind a channel, whose values count so many times for people.
void add_column(const ChannelFiles& files, const recorded::Channels& channels, std::size_t channel,
                double shown, const std::string& unit, recorded::ChannelSource& source);

}  // namespace boxbeam::readers
