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

  /// Reads all of them; notes columns that are not there, units that are not known, and files that
  /// end before others or begin after them by more than a step of theirs and do not say what is
  /// there.
  /// Where problems were noted before, or keys are only recorded, two instants without values.
  /// Throws InputError for a file that cannot be read.
  recorded::Channels read(TableReader& root, TimeTables& tables) const;

 private:
  /// What a file has before its first and after its last instant.
  enum class Beyond { unsaid, held, zero };
  struct File {
    std::string name, written;
    SignalSource source;
    std::optional<double> force_unit, moment_unit;
    std::map<std::string, ParsedQuantity> units;  ///< one of a column, by its name
    Beyond beyond = Beyond::unsaid;
    TableReader table;
  };
  /// What was read of a file.
  struct Read {
    std::size_t file = 0;
    SignalTable table;
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
  /// What cannot be read further: two instants, so that the rest has something to look at.
  recorded::Channels without_values() const {
    return {{0.0, 1.0}, std::vector<std::vector<double>>(wanted_.size(), {0.0, 0.0})};
  }
  recorded::Channels read_files(TableReader& root, TimeTables& tables) const;
  void read_units(TableReader units, File& file) const;
  /// One of a column in SI, which the file itself does not say; nothing and a problem where the
  /// case gives it as something else.
  std::optional<double> unit_of(const Wanted& of, const SignalHead& head) const;
  /// Notes a unit that holds for all columns of a dimension, of which none that is wanted is
  /// without one and one has another.
  void check_unit_of_all(std::size_t file, const SignalHead& head, const WantedDimension& dimension,
                         const char* key, const std::optional<double>& unit) const;
  /// Notes what is wrong with the columns that are wanted of a file.
  void choose(std::size_t file, const SignalHead& head, std::vector<WantedSignal>& signals) const;
  /// Notes files that do not say what they have in the time of the others.
  void refuse_unlike_times(TableReader& root, const std::vector<Read>& all) const;
  recorded::Channels on_one_time(TableReader& root, std::vector<Read> all) const;
  /// Of files that have the same instants, more than are looked at one by one.
  recorded::Channels long_channels(std::vector<Read> all) const;
  /// Where the columns of each channel are: which of those read, and which of its columns.
  std::vector<std::pair<std::size_t, std::size_t>> columns_in(const std::vector<Read>& all) const;

  std::vector<File> files_;
  std::vector<Wanted> wanted_;
};

/// [loads], [[cut_forces]] and [balance]. `in_space` becomes whether any of them leaves the plane
/// of bending about y.
recorded::Loads read_recorded(TableReader& root, const TaperedBeam& beam, TimeTables& tables,
                              bool& in_space);

}  // namespace boxbeam::readers
