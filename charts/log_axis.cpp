#include "charts/log_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/canvas.hpp"

namespace boxbeam::plot {
namespace {

constexpr double strip = 28.0;  ///< of zero, of what is beyond [px]

double decade_below(double value) { return std::pow(10.0, std::floor(std::log10(value) + 1e-9)); }
double decade_above(double value) { return std::pow(10.0, std::ceil(std::log10(value) - 1e-9)); }

/// "0.2", "300", "10^{5}", "2·10^{5}".
std::string number_text(int digit, int power) {
  constexpr int most = 3;  // decades that are written out
  if (power >= -1 && power <= most) return fmt::format("{:.6g}", digit * std::pow(10.0, power));
  const std::string ten = fmt::format("10^{{{}}}", power);
  return digit == 1 ? ten : fmt::format("{}\xC2\xB7{}", digit, ten);
}

/// "20 ms".
std::string time_text(int digit, int power) {
  constexpr const char* units[] = {"ns", "\xC2\xB5s", "ms", "s"};
  constexpr int smallest = -9;
  constexpr int largest = 0;
  const int thousands = 3 * static_cast<int>(std::floor(power / 3.0));
  const int unit = std::clamp(thousands, smallest, largest);
  const double number = digit * std::pow(10.0, power - unit);
  if (number < 1e-3 || number >= 1e5) return number_text(digit, power) + " s";
  return fmt::format("{:.6g} {}", number, units[(unit - smallest) / 3]);
}

/// About how wide an enhanced text is [px]: what makes an index takes no room.
double width_of(std::string text) {
  std::erase_if(text, [](char c) { return c == '{' || c == '}' || c == '^'; });
  return text_width(text);
}

}  // namespace

double LogAxis::at(double number) const {
  if (number <= 0.0) return zero.value_or(low);
  return std::clamp(number, low, high);
}

LogAxis log_axis(const LogContent& content, double length, double least, double most, bool whole) {
  LogAxis axis{most, least, 1.0, 10.0, {}, {}};
  for (const double number : content.numbers) {
    if (!(number > 0.0) || !std::isfinite(number)) continue;
    const double shown = std::clamp(number, least, most);
    axis.low = std::min(axis.low, shown);
    axis.high = std::max(axis.high, shown);
  }
  if (axis.low > axis.high) axis.low = axis.high = std::clamp(1.0, least, most);
  if (whole) {
    axis.low = decade_below(axis.low);
    axis.high = decade_above(axis.high);
    if (axis.high < 5.0 * axis.low) axis.high = 10.0 * axis.low;
  } else {
    // A little more on both sides, and so much in all that two marks have room.
    constexpr double narrowest = 12.0;
    const double room = std::max(std::pow(axis.high / axis.low, 0.06),
                                 std::sqrt(std::max(1.0, narrowest * axis.low / axis.high)));
    axis.low /= room;
    axis.high *= room;
  }
  const int strips = (content.zero ? 1 : 0) + (content.beyond ? 1 : 0);
  const double per_pixel = std::pow(axis.high / axis.low, 1.0 / (length - strips * strip));
  const double whole_strip = std::pow(per_pixel, strip);
  const double half_strip = std::sqrt(whole_strip);
  axis.first = content.zero ? axis.low / whole_strip : axis.low;
  axis.last = content.beyond ? axis.high * whole_strip : axis.high;
  if (content.zero) axis.zero = axis.low / half_strip;
  if (content.beyond) axis.beyond = axis.high * half_strip;
  return axis;
}

std::vector<Tic> tics_of(const LogAxis& axis, double length, TicStyle style, bool lies) {
  const double decade = length * std::log(10.0) / std::log(axis.last / axis.first);
  const auto tics_at = [&](int digit, int power) {
    const std::string text =
        style == TicStyle::time ? time_text(digit, power) : number_text(digit, power);
    return Tic{digit * std::pow(10.0, power), text, width_of(text)};
  };
  const auto first = static_cast<int>(std::floor(std::log10(axis.low)));
  const auto last = static_cast<int>(std::ceil(std::log10(axis.high)));
  double widest = 0.0;
  for (int power = first; power <= last; ++power)
    widest = std::max(widest, tics_at(1, power).width);
  const double apart = lies ? widest + 10.0 : 21.0;
  // 1, 2 and 5 are at least 0.3 of a decade apart, 1 and 3 are 0.47.
  const bool close = 0.3 * decade >= apart + 6.0;
  const bool half = !close && 0.47 * decade >= apart + 6.0;
  const auto has_text = [&](int digit) {
    return (close && (digit == 2 || digit == 5)) || (half && digit == 3);
  };
  const int step = std::max(1, static_cast<int>(std::ceil(apart / decade)));
  constexpr double finest = 40.0;  // decade with small marks [px]
  std::vector<Tic> tics;
  for (int power = first; power <= last; ++power) {
    for (const int digit : {1, 2, 3, 4, 5, 6, 7, 8, 9}) {
      Tic tic = tics_at(digit, power);
      if (tic.at < axis.low * (1.0 - 1e-9) || tic.at > axis.high * (1.0 + 1e-9)) continue;
      const bool named = digit == 1 ? power % step == 0 : has_text(digit);
      if (!named && (digit == 1 || step > 1 || decade < finest)) continue;
      if (!named) tic = {tic.at, "", 0.0, true};
      tics.push_back(tic);
    }
  }
  return tics;
}

std::string list_of(const std::vector<Tic>& tics, bool named) {
  std::string out;
  for (const Tic& tic : tics) {
    if (!out.empty()) out += ", ";
    out += fmt::format("'{}' {:.9g}{}", named ? tic.text : "", tic.at, tic.small ? " 1" : "");
  }
  return "(" + out + ")";
}

}  // namespace boxbeam::plot
