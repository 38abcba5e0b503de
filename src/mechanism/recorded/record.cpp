#include "boxbeam/mechanism/recorded/record.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <functional>
#include <utility>

namespace boxbeam::recorded {
namespace {

constexpr std::size_t block = 2048;

/// A block of instants of all channels, one after the other.
struct Block {
  std::size_t from = 0, count = 0;
  std::vector<double> values;

  explicit Block(std::size_t channels) : values(block * channels) {}

  std::span<double> of(std::size_t channel) { return {values.data() + channel * block, count}; }
};

template <class Take>
void each_block(const Record& record, Take take) {
  Block at(record.channels());
  for (; at.from < record.instants(); at.from += block) {
    at.count = std::min(block, record.instants() - at.from);
    for (std::size_t k = 0; k < record.channels(); ++k) record.copy(k, at.from, at.of(k));
    take(at);
  }
}

/// q of each instant of a block, whose values lie about the centre.
void sizes_in(Block& at, const Eigen::MatrixXd& inverse_root, std::vector<double>& sizes) {
  sizes.assign(at.count, 0.0);
  std::vector<double> part(at.count);
  for (Eigen::Index i = 0; i < inverse_root.rows(); ++i) {
    std::fill(part.begin(), part.end(), 0.0);
    for (Eigen::Index k = 0; k <= i; ++k) {
      const double factor = inverse_root(i, k);
      const double* const values = at.of(static_cast<std::size_t>(k)).data();
      for (std::size_t j = 0; j < part.size(); ++j) part[j] += factor * values[j];
    }
    for (std::size_t j = 0; j < part.size(); ++j) sizes[j] += part[j] * part[j];
  }
}

void centre_in(Block& at, const Eigen::VectorXd& centre) {
  for (Eigen::Index k = 0; k < centre.size(); ++k) {
    for (double& value : at.of(static_cast<std::size_t>(k))) value -= centre[k];
  }
}

/// Mean and scatter of the channels.
void measure(const Record& record, OuterInstants& outer) {
  const auto K = static_cast<Eigen::Index>(record.channels());
  const auto n = static_cast<double>(record.instants());
  outer.centre = Eigen::VectorXd::Zero(K);
  each_block(record, [&](Block& at) {
    for (Eigen::Index k = 0; k < K; ++k) {
      double sum = 0.0;
      for (const double value : at.of(static_cast<std::size_t>(k))) sum += value;
      outer.centre[k] += sum;
    }
  });
  outer.centre /= n;
  outer.metric = Eigen::MatrixXd::Zero(K, K);
  each_block(record, [&](Block& at) {
    centre_in(at, outer.centre);
    const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> values(
        at.values.data(), static_cast<Eigen::Index>(at.count), K,
        Eigen::OuterStride<>(static_cast<Eigen::Index>(block)));
    outer.metric.noalias() += values.transpose() * values;
  });
  outer.metric /= n;
  // Of channels that never change, or are alike, it would not be definite.
  const double largest = outer.metric.diagonal().maxCoeff();
  for (Eigen::Index k = 0; k < K; ++k) {
    const double own = outer.metric(k, k);
    outer.metric(k, k) += 1e-9 * (own > 0.0 ? own : largest > 0.0 ? largest : 1.0);
  }
}

}  // namespace

Record::Record(double start, double step, std::vector<double> instants,
               std::vector<RecordColumn> columns)
    : start_(start), step_(step), instants_(std::move(instants)), columns_(std::move(columns)) {
  assert(!columns_.empty());
  count_ = std::visit([](const auto& of) { return of.size(); }, columns_.front().values);
  assert(count_ >= 2 && (instants_.empty() || instants_.size() == count_));
}

double Record::value(std::size_t channel, std::size_t instant) const {
  const RecordColumn& of = columns_[channel];
  return std::visit([&](const auto& own) { return of.offset + own[instant]; }, of.values);
}

void Record::copy(std::size_t channel, std::size_t from, std::span<double> to) const {
  const RecordColumn& of = columns_[channel];
  std::visit(
      [&](const auto& own) {
        const auto* const values = own.data() + from;
        for (std::size_t i = 0; i < to.size(); ++i)
          to[i] = of.offset + static_cast<double>(values[i]);
      },
      of.values);
}

bool OuterInstants::proves(const Eigen::VectorXd& sum, double largest) const {
  return largest > 0.0 && largest * largest >= least * sum.dot(metric * sum);
}

OuterInstants outer_instants_of(const Record& record) {
  constexpr std::size_t kept = 40'000, looked_at = 200'000;
  const auto K = static_cast<Eigen::Index>(record.channels());
  OuterInstants outer;
  measure(record, outer);
  const Eigen::MatrixXd lower = outer.metric.llt().matrixL();
  const Eigen::MatrixXd inverse_root =
      lower.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(K, K));

  // The border from a part of the instants, evenly taken.
  std::vector<double> sizes, some;
  const std::size_t step = std::max<std::size_t>(1, record.instants() / looked_at);
  std::vector<std::size_t> found;
  std::vector<double> size_of;
  const auto look = [&](auto take) {
    each_block(record, [&](Block& at) {
      centre_in(at, outer.centre);
      sizes_in(at, inverse_root, sizes);
      take(at);
    });
  };
  {
    Block at(record.channels());
    at.count = 1;
    for (std::size_t i = 0; i < record.instants(); i += step) {
      for (std::size_t k = 0; k < record.channels(); ++k) record.copy(k, i, at.of(k));
      centre_in(at, outer.centre);
      sizes_in(at, inverse_root, sizes);
      some.push_back(sizes.front());
    }
  }
  const std::size_t rank = std::min(some.size() - 1, kept / step);
  std::nth_element(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(rank), some.end(),
                   std::greater<>());
  double border = some[rank];
  look([&](Block& at) {
    for (std::size_t j = 0; j < at.count; ++j) {
      if (sizes[j] < border) continue;
      found.push_back(at.from + j);
      size_of.push_back(sizes[j]);
    }
  });
  if (found.size() > 4 * kept) {  // many of the same size
    std::vector<double> sorted = size_of;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(4 * kept),
                     sorted.end(), std::greater<>());
    border = sorted[4 * kept];
  }
  std::vector<bool> stays;
  for (const double size : size_of) stays.push_back(size > border || found.size() <= 4 * kept);
  outer.least = border;
  outer.values.resize(record.channels());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!stays[i]) continue;
    outer.instants.push_back(found[i]);
    for (std::size_t k = 0; k < record.channels(); ++k) {
      outer.values[k].push_back(record.value(k, found[i]) -
                                outer.centre[static_cast<Eigen::Index>(k)]);
    }
  }
  return outer;
}

}  // namespace boxbeam::recorded
