#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <variant>
#include <vector>

namespace boxbeam::recorded {

/// The values of a channel at all instants, in the precision of its file: offset + value.
struct RecordColumn {
  std::variant<std::vector<float>, std::vector<double>> values;
  double offset = 0.0;
};

/// A history of so many instants that only some of them are kept in working memory as numbers of
/// their own; linear between its instants.
class Record {
 public:
  /// At equal steps from a start [s], or at given instants.
  Record(double start, double step, std::vector<double> instants,
         std::vector<RecordColumn> columns);

  std::size_t instants() const { return count_; }
  std::size_t channels() const { return columns_.size(); }
  double time_of(std::size_t instant) const {
    return instants_.empty() ? start_ + static_cast<double>(instant) * step_ : instants_[instant];
  }
  double value(std::size_t channel, std::size_t instant) const;
  /// The values of a channel from an instant on, as many as there is room for.
  void copy(std::size_t channel, std::size_t from, std::span<double> to) const;
  /// Leaves the first channels only.
  void keep(std::size_t channels) { columns_.resize(channels); }

 private:
  double start_, step_;
  std::vector<double> instants_;  ///< empty: equal steps
  std::vector<RecordColumn> columns_;
  std::size_t count_ = 0;
};

/// The instants of a record that lie far out, among which the extremes of sums of channels are.
///
/// With any positive definite M and centre c the Cauchy-Schwarz inequality bounds a sum u by
///
///     u (x - c) <= sqrt(u M u) sqrt(q),   q = (x - c) M^-1 (x - c)
///
/// so that where u (x - c) >= sqrt(least u M u) at some instant, no instant with q < least has
/// more: the largest among the instants kept, all those with q >= least, is that of the record.
struct OuterInstants {
  std::vector<std::size_t> instants;        ///< ascending
  std::vector<std::vector<double>> values;  ///< of each channel at these, less the centre
  Eigen::VectorXd centre;                   ///< mean of each channel
  Eigen::MatrixXd metric;                   ///< M: their covariance
  double least = 0.0;                       ///< smallest q kept

  /// Whether a largest value of a sum, found among these instants, is that of the whole record.
  bool proves(const Eigen::VectorXd& sum, double largest) const;
};

/// Those with the largest q, some ten thousand.
OuterInstants outer_instants_of(const Record& record);

}  // namespace boxbeam::recorded
