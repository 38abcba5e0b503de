#include "function_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace boxbeam {
namespace {

/// Units of a value and of its derivatives by time.
struct ValueUnit {
  const char* text;

  std::string per_time(std::size_t power) const {
    if (power == 0) return text;
    return power == 1 ? fmt::format("{}/s", text) : fmt::format("{}/s^{}", text, power);
  }
};

/// A function of time as a formula, or in words.
struct FunctionText {
  ValueUnit unit;

  std::string wave(double amplitude, double omega, double phase) const {
    return fmt::format("{} {} sin({} rad/s t + {} rad)", plain(amplitude), unit.text, plain(omega),
                       plain(phase));
  }

  std::string operator()(const HarmonicDriver& driver) const {
    std::string text = fmt::format("{} {} + {}", plain(driver.mean), unit.text,
                                   wave(driver.amplitude, driver.omega, driver.phase));
    for (const Harmonic& more : driver.further) {
      text += " + " + wave(more.amplitude, more.omega, more.phase);
    }
    return text;
  }

  std::string operator()(const RateDriver& driver) const {
    return fmt::format("{} {} + {} {} t", plain(driver.start), unit.text, plain(driver.rate),
                       unit.per_time(1));
  }

  std::string operator()(const PolynomialDriver& driver) const {
    std::string text;
    for (std::size_t i = 0; i < driver.c.size(); ++i) {
      if (i > 0) text += driver.c[i] < 0.0 ? " - " : " + ";
      text += fmt::format("{} {}", plain(i > 0 ? std::abs(driver.c[i]) : driver.c[i]),
                          unit.per_time(i));
      if (i > 0) text += i == 1 ? " t" : fmt::format(" t^{}", i);
    }
    return text;
  }

  std::string operator()(const StepDriver& driver) const {
    return fmt::format("smooth step from {0} {2} to {1} {2}, from t = {3} s to {4} s",
                       plain(driver.from), plain(driver.to), unit.text, plain(driver.begin),
                       plain(driver.end));
  }

  std::string operator()(const TableDriver& driver) const {
    const TableCurve& curve = driver.curve;
    const auto [low, high] = std::minmax_element(curve.values().begin(), curve.values().end());
    return fmt::format(
        "{} through {} points of a table from t = {} s to {} s, values {} to {} {}{}",
        to_text(curve.interpolation()), curve.points().size(), plain(curve.first_x()),
        plain(curve.last_x()), plain(*low), plain(*high), unit.text, to_text(curve.beyond()));
  }

 private:
  static const char* to_text(Interpolation interpolation) {
    switch (interpolation) {
      case Interpolation::step: return "steps";
      case Interpolation::linear: return "straight lines";
      case Interpolation::pchip: return "monotone cubics (pchip)";
      case Interpolation::cubic: return "cubic spline";
    }
    return "";
  }

  static const char* to_text(Beyond beyond) {
    switch (beyond) {
      case Beyond::nothing: return "";
      case Beyond::hold: return ", its end values beyond";
      case Beyond::periodic: return ", periodic";
    }
    return "";
  }
};

}  // namespace

std::string plain(double value) { return fmt::format("{:.6g}", value + 0.0); }

std::string degrees(double angle) { return plain(angle * 180.0 / std::numbers::pi) + " deg"; }

std::string function_text(const Driver& driver, const char* unit) {
  return std::visit(FunctionText{{unit}}, driver);
}

std::string acting_text(Acts acts, const std::optional<Impact>& impact) {
  std::string text;
  switch (acts) {
    case Acts::both: return text;
    case Acts::pulling: text = ", only pulling"; break;
    case Acts::pushing: text = ", only pushing"; break;
  }
  if (!impact) return text;
  if (impact->exponent != 1.0)
    text += fmt::format(", force by its depth to the power of {}", plain(impact->exponent));
  return text +
         fmt::format(", a free impact ends with {} of its velocity", plain(impact->restitution));
}

std::string friction_text(const Friction& law) {
  std::string text;
  if (law.coulomb > 0.0) {
    text += fmt::format("friction coefficient {}", plain(law.coulomb));
    if (law.standing > law.coulomb) text += fmt::format(", {} standing", plain(law.standing));
    if (law.creep > 0.0) text += fmt::format(" above a creep of {} m/s", plain(law.creep));
    if (law.guide > 0.0) text += fmt::format(", guide {} m long", plain(law.guide));
  }
  if (law.viscous > 0.0) {
    text +=
        fmt::format("{}viscous friction {} N s/m", text.empty() ? "" : ", ", plain(law.viscous));
  }
  return text;
}

}  // namespace boxbeam
