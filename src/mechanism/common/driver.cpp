#include "boxbeam/mechanism/common/driver.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/core/angle.hpp"

namespace boxbeam {
namespace {

void add(DriverState& state, double amplitude, double omega, double phase, double time) {
  const double angle = omega * time + phase;
  const double swing = amplitude * std::sin(angle);
  state.value += swing;
  state.rate += amplitude * omega * std::cos(angle);
  state.acceleration -= omega * omega * swing;
}

struct Evaluator {
  double time;

  DriverState operator()(const HarmonicDriver& driver) const {
    DriverState state{driver.mean, 0.0, 0.0};
    add(state, driver.amplitude, driver.omega, driver.phase, time);
    for (const Harmonic& more : driver.further) {
      add(state, more.amplitude, more.omega, more.phase, time);
    }
    return state;
  }

  DriverState operator()(const RateDriver& driver) const {
    return {driver.start + driver.rate * time, driver.rate, 0.0};
  }

  DriverState operator()(const PolynomialDriver& driver) const {
    DriverState state;
    for (std::size_t i = driver.c.size(); i-- > 0;) {
      state.acceleration = state.acceleration * time + 2.0 * state.rate;
      state.rate = state.rate * time + state.value;
      state.value = state.value * time + driver.c[i];
    }
    return state;
  }

  DriverState operator()(const StepDriver& driver) const {
    const double length = driver.end - driver.begin;
    const double u = std::clamp((time - driver.begin) / length, 0.0, 1.0);
    const double rise = driver.to - driver.from;
    // The complement is taken from the end, so that both ends are met exactly.
    const double share = u * u * u * (10.0 + u * (6.0 * u - 15.0));
    return {u < 1.0 ? driver.from + rise * share : driver.to,
            rise / length * 30.0 * u * u * (1.0 - u) * (1.0 - u),
            rise / (length * length) * 60.0 * u * (1.0 - u) * (1.0 - 2.0 * u)};
  }

  DriverState operator()(const TableDriver& driver) const {
    const Derivatives at = driver.curve.at(time);
    return {at.value, at.first, at.second};
  }
};

struct Timing {
  bool turning;

  DriverTiming operator()(const HarmonicDriver& driver) const {
    DriverTiming timing;
    const auto take = [&](double amplitude, double omega) {
      if (amplitude == 0.0 || omega == 0.0) return;
      timing.omegas.push_back(std::abs(omega));
      timing.highest_omega = std::max(timing.highest_omega, std::abs(omega));
    };
    take(driver.amplitude, driver.omega);
    for (const Harmonic& more : driver.further) take(more.amplitude, more.omega);
    return timing;
  }

  DriverTiming operator()(const RateDriver& driver) const {
    DriverTiming timing;
    if (driver.rate == 0.0) return timing;
    timing.repeats = turning;
    if (turning) {
      timing.omegas.push_back(std::abs(driver.rate));
      timing.highest_omega = std::abs(driver.rate);
    }
    return timing;
  }

  DriverTiming operator()(const PolynomialDriver& driver) const {
    DriverTiming timing;
    for (std::size_t i = 1; i < driver.c.size(); ++i) {
      if (driver.c[i] != 0.0) timing.repeats = false;
    }
    return timing;
  }

  DriverTiming operator()(const StepDriver& driver) const {
    return {{}, false, driver.end, {}, full_turn / (driver.end - driver.begin)};
  }

  DriverTiming operator()(const TableDriver& driver) const {
    const TableCurve& curve = driver.curve;
    DriverTiming timing;
    double shortest = curve.last_x() - curve.first_x();
    if (curve.beyond() == Beyond::periodic) {
      timing.omegas.push_back(full_turn / shortest);
    } else {
      timing.repeats = false;
      timing.end = curve.last_x();
    }
    if (curve.beyond() == Beyond::nothing) timing.known = {curve.first_x(), curve.last_x()};
    for (std::size_t i = 1; i < curve.points().size(); ++i) {
      shortest = std::min(shortest, curve.points()[i] - curve.points()[i - 1]);
    }
    // Between three points of a table a value can swing once.
    timing.highest_omega = 0.5 * full_turn / shortest;
    if (curve.interpolation() == Interpolation::linear ||
        curve.interpolation() == Interpolation::step) {
      const double pieces = static_cast<double>(curve.points().size()) - 1.0;
      timing.mean_omega = 0.5 * full_turn * pieces / (curve.last_x() - curve.first_x());
    }
    return timing;
  }
};

}  // namespace

DriverState driver_at(const Driver& driver, double time) {
  // The common case without the detour over the table of a variant.
  if (const auto* harmonic = std::get_if<HarmonicDriver>(&driver))
    return Evaluator{time}(*harmonic);
  return std::visit(Evaluator{time}, driver);
}

DriverTiming timing_of(const Driver& driver, bool turning) {
  return std::visit(Timing{turning}, driver);
}

std::vector<Break> breaks_of(const Driver& driver, double from, double until) {
  if (const auto* table = std::get_if<TableDriver>(&driver)) {
    return table->curve.breaks(from, until);
  }
  std::vector<Break> breaks;
  if (const auto* step = std::get_if<StepDriver>(&driver)) {
    // Rate and acceleration are zero at both ends, the third derivative is not.
    for (const double end : {step->begin, step->end}) {
      if (end >= from && end <= until) breaks.push_back({end, 3});
    }
  }
  return breaks;
}

std::optional<double> common_period_of(const std::vector<double>& omegas, int most) {
  if (omegas.empty()) return std::nullopt;
  const double fastest = *std::max_element(omegas.begin(), omegas.end());
  for (int cycles = 1; cycles <= most; ++cycles) {
    const auto whole = [&](double omega) {
      const double own = cycles * (omega / fastest);
      return std::abs(own - std::round(own)) < 1e-9 * cycles && std::round(own) > 0.0;
    };
    if (std::all_of(omegas.begin(), omegas.end(), whole)) return cycles * (full_turn / fastest);
  }
  return std::nullopt;
}

}  // namespace boxbeam
