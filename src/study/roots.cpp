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
    if (question_->whole) return whole_ones();
    for (const double value : scanned()) tried_.push_back({value, above_at(value)});
    for (std::size_t i = 0; i < tried_.size(); ++i) {
      if (tried_[i].above == 0.0) add_root(tried_[i].value, 0.0);
      if (i + 1 < tried_.size()) close_in(tried_[i], tried_[i + 1]);
      if (i + 1 < tried_.size() && tried_[i].above.has_value() != tried_[i + 1].above.has_value())
        look_at_border(tried_[i], tried_[i + 1]);
      look_for_touch(i > 0 ? tried_[i - 1] : Tried{}, tried_[i],
                     i + 1 < tried_.size() ? tried_[i + 1] : Tried{});
    }
    std::sort(found_.roots.begin(), found_.roots.end(),
              [](const Root& a, const Root& b) { return a.value < b.value; });
    return found_;
  }

 private:
  Roots whole_ones() {
    const double first = std::ceil(question_->from), last = std::floor(question_->to);
    constexpr double most = 1000.0;
    const double stride = std::max(1.0, std::ceil((last - first) / most));
    const int steps = last < first ? -1 : static_cast<int>(std::ceil((last - first) / stride));
    Tried before;
    for (int step = 0; step <= steps; ++step) {
      const double value = std::min(first + step * stride, last);
      const Tried now{value, above_at(value)};
      if (!now.above) continue;
      if (std::abs(*now.above) <= tolerance(before.above ? std::abs(*before.above) : 0.0))
        add_root(value, *now.above);
      else if (before.above && *before.above * *now.above < 0.0)
        add_whole_between(before, now);
      before = now;
    }
    return found_;
  }

  /// Down to neighbours, as far as there are results between.
  void add_whole_between(Tried low, Tried high) {
    while (high.value - low.value > 1.5) {
      const double middle = std::floor(0.5 * (low.value + high.value));
      const Tried now{middle, above_at(middle)};
      if (!now.above) break;
      if (std::abs(*now.above) <= tolerance(std::abs(*low.above)))
        return add_root(middle, *now.above);
      (*now.above * *low.above < 0.0 ? high : low) = now;
    }
    found_.jumps.push_back({0.5 * (low.value + high.value), question_->wanted + *low.above,
                            question_->wanted + *high.above, high.value - low.value});
  }

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
    found_.changes = found_.changes || (found_.nearest && found_.nearest->result != *trial.result);
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
    std::optional<double> without;
    const auto above = [&](double value) {
      const std::optional<double> at = above_at(value);
      if (at) return *at;
      without = value;
      return value - a.value < b.value - value ? *a.above : *b.above;
    };
    std::uintmax_t most = 200;
    const auto adjacent = [](double low, double high) {
      return high - low <=
             2.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(low), std::abs(high));
    };
    const auto [low, high] = boost::math::tools::toms748_solve(above, a.value, b.value, *a.above,
                                                               *b.above, adjacent, most);
    const std::optional<double> at_low = above_at(low), at_high = above_at(high);
    const bool lower = at_low && (!at_high || std::abs(*at_low) <= std::abs(*at_high));
    const std::optional<double> nearer = lower ? at_low : at_high;
    if (without) {
      // Where results end on the way, each side of that has its own.
      const std::size_t before = found_.roots.size();
      look_at_border(a, {*without, {}});
      look_at_border({*without, {}}, b);
      if (found_.roots.size() > before) return;
    }
    if (nearer && std::abs(*nearer) <= tolerance(std::abs(*a.above)))
      add_root(lower ? low : high, *nearer);
    else if (!without)
      found_.jumps.push_back(
          {0.5 * (low + high), question_->wanted + *at_low, question_->wanted + *at_high, 0.0});
  }

  /// Between a value that has a result and one that has none: up to where results end.
  void look_at_border(const Tried& a, const Tried& b) {
    constexpr int most_borders = 8, halvings = 12;
    if (borders_++ >= most_borders) return;
    const Tried first = a.above ? a : b;
    Tried last = first;
    double without = a.above ? b.value : a.value;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (last.value + without);
      const std::optional<double> above = above_at(middle);
      if (above)
        last = {middle, above};
      else
        without = middle;
    }
    if (last.value == first.value) return;
    if (last.above == 0.0) add_root(last.value, 0.0);
    if (first.value < last.value)
      close_in(first, last);
    else
      close_in(last, first);
  }

  /// Of three neighbours on one side of the wanted result, the middle one the nearest to it. Where
  /// there is no neighbour, or none with a result, the one on the other side.
  void look_for_touch(const Tried& a, const Tried& b, const Tried& c) {
    if (!b.above || *b.above == 0.0 || (!a.above && !c.above)) return;
    const double sign = *b.above > 0.0 ? 1.0 : -1.0;
    const bool at_end = !a.above || !c.above;
    double most_fallen = 0.0;
    for (const Tried& beside : {a, c}) {
      if (!beside.above) continue;
      const double fallen = sign * (*beside.above - *b.above);
      if (fallen < 0.0 || (at_end && fallen == 0.0) || sign * *beside.above <= 0.0) return;
      most_fallen = std::max(most_fallen, fallen);
    }
    // Nor does it fall more beside the middle one than it has fallen towards it.
    if (sign * *b.above > most_fallen) return;
    const Tried from = a.above ? a : b, to = c.above ? c : b;
    constexpr int bits = 26;
    std::uintmax_t most = 60;
    const auto height = [&](double value) {
      const std::optional<double> above = above_at(value);
      return above ? sign * *above : std::numeric_limits<double>::max();
    };
    const auto [value, least] =
        boost::math::tools::brent_find_minima(height, from.value, to.value, bits, most);
    if (std::abs(least) <= tolerance(std::abs(*from.above))) {
      add_root(value, sign * least);
    } else if (least < 0.0) {
      close_in(from, {value, sign * least});
      close_in({value, sign * least}, to);
    }
  }

  const RootQuestion* question_;
  Roots found_;
  std::vector<Tried> tried_;
  int borders_ = 0;  ///< of values without a result that were looked at
};

}  // namespace

Roots roots_of(const RootQuestion& question) { return RootSearch(question).run(); }

}  // namespace boxbeam
