#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/recorded/loads.hpp"
#include "boxbeam/project/signal_file.hpp"
#include "readers.hpp"

/// The parts of a case whose loads come from files.
namespace boxbeam::readers {

/// The channels that loads ask for, gathered while the case is read, read together, and put on one
/// time.
class ChannelFiles {
 public:
  /// Reads [files], by their names.
  ChannelFiles(TableReader& root, const TimeTables& tables);

  /// The file that a table names by "file", the only one where it names none; nothing and a problem
  /// where there is none.
  std::optional<std::size_t> file_of(TableReader& table);

  /// Index of the channel of a column, whose name a key has.
  std::size_t channel_of(TableReader& table, const Key& key, std::size_t file,
                         std::optional<WantedDimension> dimension);

  std::size_t size() const { return wanted_.size(); }
  const std::string& column(std::size_t channel) const { return wanted_[channel].signal.name; }
  const std::string& path(std::size_t channel) const {
    return files_[wanted_[channel].file].written;
  }

  /// Reads all of them; notes columns that are not there, and files that have no time in common.
  /// Where problems were noted before, or keys are only recorded, two instants without values.
  /// Throws InputError for a file that cannot be read.
  recorded::Channels read(TableReader& root, TimeTables& tables) const;

 private:
  struct File {
    std::string name, written;
    SignalSource source;
    std::optional<double> force_unit, moment_unit;
    TableReader table;
  };
  struct Wanted {
    std::size_t file = 0;
    WantedSignal signal;
    TableReader table;  ///< whose key names it
    std::string key;
  };
  /// All that the channels follow from, but for what the files hold.
  std::string description() const;
  bool is_wanted(std::size_t file) const;
  recorded::Channels read_files(TableReader& root, TimeTables& tables) const;
  recorded::Channels on_one_time(TableReader& root, std::vector<SignalTable> of) const;
  /// Of files that have the same instants, more than are looked at one by one.
  recorded::Channels long_channels(std::vector<SignalTable> of) const;

  std::vector<File> files_;
  std::vector<Wanted> wanted_;
};

/// [loads], [[cut_forces]] and [balance]. `in_space` becomes whether any of them leaves the plane
/// of bending about y.
recorded::Loads read_recorded(TableReader& root, const TaperedBeam& beam, TimeTables& tables,
                              bool& in_space);

}  // namespace boxbeam::readers
