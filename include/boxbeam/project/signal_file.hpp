#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "boxbeam/project/quantity_text.hpp"

/// Load histories that other programs write: signals over a common time.
///
/// A file is read in two steps. `list_signals` reads its head: which channels there are, with their
/// units. `read_signals` then goes once through its rows and hands the wanted channels on in
/// blocks, so that the memory stays the same however long the file is. `read_signal_file` keeps all
/// rows in a table instead: 4 bytes a value where the file itself holds 16-bit integers or single
/// precision (which loses nothing), 8 otherwise, and no array for a time of equal steps. Ten
/// million rows of six channels are 240 MB as such a table and a few MB as a stream.
namespace boxbeam {

enum class SignalFormat {
  /// Columns between commas, semicolons, tabs or blanks; decimals with a point or, but for commas
  /// between them, a comma; names in quotation marks or not, with units in brackets behind them or
  /// in a row below; "#" begins a comment. The SAE head "#TIMEstep= 120 Seconds" gives the time
  /// step
  /// of a table without time column (0: the first column is the time [s]).
  csv,
  /// OpenFAST's .out: any lines, names from "Time" on, units in parentheses, rows, closing words.
  openfast_text,
  /// OpenFAST's .outb of ids 1 to 4.
  openfast_binary,
  /// MBDyn's .jnt, .frc, .act: no head, a row for each label and step, no time. Channels are
  /// "2.local.Fx" and "2.global.Mz" (.jnt), "7.I.Fx" and "7.II.Mz" (.act: beam of two or three
  /// nodes, section axes, at the evaluation points), "5@1002.Fx" (.frc of an external element), and
  /// "2.c14" by the file's own column for the others. The time is that of the .out file of the same
  /// stem, or has a given step.
  mbdyn,
  /// Exudyn's sensor files: "#" lines, rows with commas, no units.
  exudyn,
  /// Tables of a request of Adams or RecurDyn (.tab, .out): words, of which the last ones before
  /// the
  /// numbers name the columns, from TIME on; no units.
  request_table,
  /// Request files of RecurDyn and Adams (.req): the requests, and for each step the time and a row
  /// of six values for each of them. Channels are "4711.FX" (type 4, forces); no units.
  request_steps,
  /// RPC III (.rpc, .rsp, .tim): 16-bit integers or single precision. An integer is
  /// SCALE INT_FULL_SCALE/32768 units, as rpc_reader has it; rpc3-file writes and reads it as SCALE
  /// units, which with its full scale of 32752 is 0.05 % more. What fills the last frame up is read
  /// as if it were measured, unless the head gives SAMPLES.
  rpc3,
  /// NetCDF as MBDyn writes it (.nc), classic and NetCDF-4: all numbers over the dimension of
  /// "time",
  /// "elem.beam.7.F_I.x" of a vector. Read by libnetcdf, where it is installed.
  netcdf,
};

inline constexpr SignalFormat all_signal_formats[] = {
    SignalFormat::csv,           SignalFormat::openfast_text, SignalFormat::openfast_binary,
    SignalFormat::mbdyn,         SignalFormat::exudyn,        SignalFormat::request_table,
    SignalFormat::request_steps, SignalFormat::rpc3,          SignalFormat::netcdf};

/// The word by which a user asks for it: "csv", "openfast-text".
std::string_view word_of(SignalFormat format);
/// What messages call it: "CSV", "OpenFAST text".
std::string_view name_of(SignalFormat format);

/// A file, and what it does not say itself.
struct SignalSource {
  std::string path;
  std::optional<SignalFormat> format = {};  ///< none: by content and name
  std::optional<double> time_step = {};     ///< [s], above zero, of a file without time
  /// One of the unit of the time, in seconds, where the file has a time without unit. Without it,
  /// the time of a CSV file must have a unit; that of the programs is in seconds.
  std::optional<double> time_unit = {};
};

/// A signal as the file names it.
struct SignalChannel {
  std::string name;  ///< without unit
  std::string unit;  ///< as written, without brackets; "" where the file has none
  /// Whether a float holds what the file holds: to a sixteenth of a step of its integers, or, of a
  /// file of floats, to one rounding.
  bool single_precision = false;
};

/// What is known before a row is read.
struct SignalHead {
  std::string path;
  SignalFormat format = SignalFormat::csv;
  std::vector<SignalChannel> channels;     ///< all but the time, in the order of the file
  std::optional<std::uint64_t> rows = {};  ///< where the head tells
  std::optional<double> time_step = {};    ///< [s], where the steps are equal
  int names_line = 0;                      ///< in which the channels are named; 0: in none
  std::string names_text;                  ///< that line
};

/// A wanted channel. Without `dimension` its values stay in the file's unit; with it they are
/// converted to SI, by the file's unit where that is known here, else by `scale`.
struct WantedSignal {
  std::string name;
  std::optional<WantedDimension> dimension = {};
  /// What one of the file's unit is in SI, where the file gives none or one that is not known.
  /// Without `dimension` a plain factor.
  std::optional<double> scale = {};
};

/// Wanted channels found in a file.
struct ChosenSignals {
  std::vector<std::size_t> columns;  ///< index into the channels, for each wanted one
  std::vector<double> factors;       ///< by which the file's values are multiplied
  struct Trouble {
    std::size_t wanted = 0;  ///< index of the wanted channel
    std::string message;
    std::string hint;
  };
  std::vector<Trouble> troubles;  ///< where any: the rest is not to be used
};

/// Looks for channels by name; a name that is not there is answered with the nearest one. Throws
/// nothing, so that a reader of cases can put each trouble to the key that it came from.
ChosenSignals choose_signals(const SignalHead& head, const std::vector<WantedSignal>& wanted);

/// Rows in their order, valid during the call only: one value of each wanted channel for each time.
/// All are finite and of a magnitude that can be meant; the time ascends strictly.
struct SignalRows {
  std::span<const double> time;                     ///< [s]
  std::span<const std::span<const double>> values;  ///< for each wanted channel
};
using SignalSink = std::function<void(const SignalRows&)>;

/// What was read.
struct SignalSummary {
  std::uint64_t rows = 0;
  double first_time = 0.0;  ///< [s]
  double last_time = 0.0;   ///< [s]
};

/// Which channels a file has. Throws InputError for a file that is none, with line or byte.
SignalHead list_signals(const SignalSource& source);

/// Reads the wanted channels; all, in the units of the file, where none is wanted. Throws
/// InputError at the first thing that is wrong, with file, line or byte, and what to write.
SignalSummary read_signals(const SignalSource& source, const std::vector<WantedSignal>& wanted,
                           const SignalSink& sink);

/// The values of a channel, in the precision of the file, or in single precision about its first.
class SignalColumn {
 public:
  using Values = std::variant<std::vector<float>, std::vector<double>>;

  explicit SignalColumn(bool single, bool about_first = false);

  void append(std::span<const double> values);
  void reserve(std::size_t rows);
  std::size_t size() const;
  double operator[](std::size_t row) const;
  bool is_single() const { return std::holds_alternative<std::vector<float>>(values_); }
  /// What is to be added to each of the values that `release` gives away.
  double offset() const { return offset_; }
  Values release() { return std::move(values_); }

 private:
  Values values_;
  bool about_first_;
  double offset_ = 0.0;
};

/// Instants, as equal steps where they are.
struct SignalTime {
  std::size_t count = 0;
  double start = 0.0;            ///< [s]
  double step = 0.0;             ///< [s], of equal steps
  std::vector<double> instants;  ///< [s]; empty: equal steps

  double operator[](std::size_t row) const {
    return instants.empty() ? start + static_cast<double>(row) * step : instants[row];
  }
};

/// Signals over a common time.
struct SignalTable {
  std::string path;
  std::string format;              ///< "CSV", "OpenFAST text"
  std::vector<std::string> names;  ///< of the columns, as the file says, without unit
  std::vector<std::string> units;  ///< as written, "" where the file has none
  SignalTime time;
  std::vector<SignalColumn> columns;  ///< SI where a dimension was wanted, else the file's units
};

/// The same kept as a table, one column for each wanted channel. `compact`: 4 bytes a value also of
/// what a float does not hold, about the first value: to 6e-8 of the largest distance from it.
SignalTable read_signal_file(const SignalSource& source,
                             const std::vector<WantedSignal>& wanted = {}, bool compact = false);

}  // namespace boxbeam
