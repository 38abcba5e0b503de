#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Logarithmic axes with a place for zero, which no logarithm has, and one beyond all numbers.
namespace boxbeam::plot {

struct LogAxis {
  double low = 1.0, high = 10.0;    ///< of numbers
  double first = 1.0, last = 10.0;  ///< of the axis, with the places beside the numbers
  std::optional<double> zero;       ///< where zero stands
  std::optional<double> beyond;     ///< where stands what has no number

  /// Where a number stands; one that is too small, or too large, at the end of the numbers.
  double at(double number) const;
};

/// What is to be shown on an axis.
struct LogContent {
  std::vector<double> numbers;  ///< only the positive ones count
  bool zero = false, beyond = false;
};

/// An axis of a length [px]. Numbers smaller than `least` and larger than `most` do not widen it.
/// `whole`: it ends at powers of ten.
LogAxis log_axis(const LogContent& content, double length, double least, double most, bool whole);

/// Marks of an axis and what stands at them.
struct Tic {
  double at = 1.0;
  std::string text;    ///< for gnuplot's enhanced text
  double width = 0.0;  ///< [px]
  bool small = false;  ///< without a text, between others
};

/// What a number is written as: "1000", "10^{-6}"; of a time "10 us".
enum class TicStyle { number, time };

/// Powers of ten, on short axes also 3 or 2 and 5 of them, as many as have room: at least `apart`
/// [px] from each other, and as far as their texts need on an axis that lies. Between powers of ten
/// that are far apart there are small ones.
std::vector<Tic> tics_of(const LogAxis& axis, double length, TicStyle style, bool lies);

/// "('10' 10, '100' 100)"; `named` false: without the texts.
std::string list_of(const std::vector<Tic>& tics, bool named = true);

}  // namespace boxbeam::plot
