#include "boxbeam/study/roots.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

namespace boxbeam {
namespace {

constexpr double close = 1e-9;  ///< of the wanted result, that a root is one

/// A value on the way and by how much its result is above the wanted one.
struct Tried {
  double value = 0.0;
  std::optional<double> above;
};

class RootSearch {
 public:
  explicit RootSearch(const RootQuestion& question) : question_(&question) {}

  Roots run() {
    for (const double value : scanned()) tried_.push_back({value, above_at(value)});
    for (std::size_t i = 0; i + 1 < tried_.size(); ++i) {
      if (tried_[i].above == 0.0) add_root(tried_[i].value, 0.0);
      close_in(tried_[i], tried_[i + 1]);
      if (i > 0) look_for_touch(tried_[i - 1], tried_[i], tried_[i + 1]);
    }
    if (tried_.back().above == 0.0) add_root(tried_.back().value, 0.0);
    std::sort(found_.roots.begin(), found_.roots.end(),
              [](const Root& a, const Root& b) { return a.value < b.value; });
    return found_;
  }

 private:
  std::vector<double> scanned() const {
    const auto [from, to] = std::pair{question_->from, question_->to};
    constexpr double far = 10.0;
    const bool by_ratio = from > 0.0 ? to > far * from : to < 0.0 && from < far * to;
    std::vector<double> values;
    for (int k = 0; k <= question_->scan; ++k) {
      const double part = static_cast<double>(k) / question_->scan;
      values.push_back(k == question_->scan ? to
                       : by_ratio           ? from * std::pow(to / from, part)
                                            : from + part * (to - from));
    }
    return values;
  }

  /// Nothing where there is no result.
  std::optional<double> above_at(double value) {
    ++found_.trials;
    const Trial trial = question_->at(value);
    if (!trial.result || !std::isfinite(*trial.result)) {
      if (found_.failed++ == 0) {
        found_.first_trouble = trial.trouble.empty() ? "the result is infinite" : trial.trouble;
        found_.failed_at = value;
      }
      return std::nullopt;
    }
    const double above = *trial.result - question_->wanted;
    if (!found_.nearest || std::abs(above) < std::abs(found_.nearest->result - question_->wanted))
      found_.nearest = Root{value, *trial.result};
    return above;
  }

  /// `apart`: how far results nearby are from the wanted one, which may be zero.
  double tolerance(double apart) const {
    const double wanted = std::abs(question_->wanted);
    return close * (wanted > 0.0 ? wanted : apart);
  }

  void add_root(double value, double above) {
    found_.roots.push_back({value, question_->wanted + above});
  }

  void close_in(const Tried& a, const Tried& b) {
    if (!a.above || !b.above || *a.above * *b.above >= 0.0) return;
    // A result that fails on the way has its sign by the end that it is nearer to.
    const auto above = [&](double value) {
      const std::optional<double> at = above_at(value);
      if (at) return *at;
      return value - a.value < b.value - value ? *a.above : *b.above;
    };
    std::uintmax_t most = 200;
    const auto adjacent = [](double low, double high) {
      return high - low <=
             2.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(low), std::abs(high));
    };
    const auto [low, high] = boost::math::tools::toms748_solve(above, a.value, b.value, *a.above,
                                                               *b.above, adjacent, most);
    const double at_low = above(low), at_high = above(high);
    const bool lower = std::abs(at_low) <= std::abs(at_high);
    if (std::min(std::abs(at_low), std::abs(at_high)) <= tolerance(std::abs(*a.above)))
      add_root(lower ? low : high, lower ? at_low : at_high);
    else
      found_.jumps.push_back(
          {0.5 * (low + high), question_->wanted + at_low, question_->wanted + at_high});
  }

  /// Of three neighbours on one side of the wanted result, the middle one the nearest to it.
  void look_for_touch(const Tried& a, const Tried& b, const Tried& c) {
    if (!a.above || !b.above || !c.above) return;
    const double sign = *b.above > 0.0 ? 1.0 : -1.0;
    if (*b.above == 0.0 || sign * *a.above <= 0.0 || sign * *c.above <= 0.0) return;
    const double before = sign * (*a.above - *b.above), behind = sign * (*c.above - *b.above);
    // Nor does it fall more beside the middle one than it has fallen towards it.
    if (before < 0.0 || behind < 0.0 || sign * *b.above > std::max(before, behind)) return;
    constexpr int bits = 26;
    std::uintmax_t most = 60;
    const auto height = [&](double value) {
      const std::optional<double> above = above_at(value);
      return above ? sign * *above : std::numeric_limits<double>::max();
    };
    const auto [value, least] =
        boost::math::tools::brent_find_minima(height, a.value, c.value, bits, most);
    if (std::abs(least) <= tolerance(std::abs(*a.above))) {
      add_root(value, sign * least);
    } else if (least < 0.0) {
      close_in(a, {value, sign * least});
      close_in({value, sign * least}, c);
    }
  }

  const RootQuestion* question_;
  Roots found_;
  std::vector<Tried> tried_;
};

}  // namespace

Roots roots_of(const RootQuestion& question) { return RootSearch(question).run(); }

}  // namespace boxbeam
