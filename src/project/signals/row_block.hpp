#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "boxbeam/project/signal_file.hpp"

namespace boxbeam {

/// What is wrong with a row.
struct RowTrouble {
  static constexpr std::size_t time = static_cast<std::size_t>(-1);

  std::size_t row = 0;    ///< of those given
  std::size_t value = 0;  ///< which of the wanted channels, or `time`
  std::string message;
  std::string hint;
};

/// Collects rows of the wanted channels, looks whether they can be meant, converts them and hands
/// them on in blocks. The readers of formats know the place of a trouble; what is one stands here.
class RowBlock {
 public:
  static constexpr std::size_t most_rows = 8192;

  /// `factors`: to what is wanted, one for each channel.
  RowBlock(std::vector<double> factors, const SignalSink& sink);

  std::size_t width() const { return factors_.size(); }

  /// Takes one row: a time [s] and a value for each channel in the file's unit. Nothing is taken of
  /// a row with a trouble.
  std::optional<RowTrouble> take(double time, const double* values);

  /// The same of a time or a value alone, where parts of a row stand in different lines.
  std::optional<RowTrouble> trouble_of_time(double time) const;
  static std::optional<RowTrouble> trouble_of_value(double value);

  /// Room for so many rows, of a reader that fills columns: time [s] and values in file's units.
  double* time() { return time_.data(); }
  double* column(std::size_t channel) { return columns_[channel].data(); }
  /// Takes as many rows as have been filled in there, at most `most_rows`; none of a block with a
  /// trouble. Not to be mixed with `take`.
  std::optional<RowTrouble> take_filled(std::size_t rows);

  /// Hands on what has been taken and is still here.
  void finish();

  const SignalSummary& summary() const { return summary_; }

 private:
  void deliver(std::size_t rows);

  std::vector<double> factors_;
  const SignalSink* sink_;
  std::size_t filled_ = 0;
  std::optional<double> last_time_;
  std::vector<double> time_;
  std::vector<std::vector<double>> columns_;
  std::vector<std::span<const double>> spans_;
  SignalSummary summary_;
};

}  // namespace boxbeam
