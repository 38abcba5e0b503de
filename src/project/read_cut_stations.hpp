#pragma once

#include <array>
#include <vector>

#include "recorded_terms.hpp"

namespace boxbeam::readers {

/// Cut forces that files give at stations along the beam.
class CutStations {
 public:
  /// Reads [[cut_forces]] into terms; notes stations that do not ascend from end to end, and cut
  /// forces that are given at some of them only or without what changes them along the beam.
  void read(TableReader& root, const TaperedBeam& beam, ChannelFiles& files, RecordedTerms& into);

  /// Loads whose cut forces are those, for each channel's unit, and how far the shear forces are
  /// from the slope of the bending moments.
  void put_together(const TaperedBeam& beam, const std::vector<Term>& terms,
                    const recorded::Channels& channels, recorded::Loads& loads) const;

  /// Of a term's place [m].
  double station(std::size_t place) const { return stations_[place]; }

 private:
  void check(TableReader& root, const TaperedBeam& beam);

  std::vector<double> stations_;
  std::vector<std::array<bool, 6>> given_;  ///< which cut forces each station has
};

}  // namespace boxbeam::readers
