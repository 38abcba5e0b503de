#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "readers.hpp"

namespace boxbeam::readers {
namespace {

/// The dimension of the k-th derivative by time, with words of its own for messages.
class Derivative {
 public:
  Derivative(const FunctionOf& of, int k) : exponents_(of.value.exponents) {
    const std::string seconds = k == 1 ? "s" : fmt::format("s^{}", k);
    exponents_.time -= k;
    name_ = k == 0 ? of.value.name : fmt::format("{} per {}", of.value.name, seconds);
    example_ =
        k == 0 ? fmt::format("\"1 {}\"", of.unit) : fmt::format("\"1 {}/{}\"", of.unit, seconds);
    if (k == 1 && of.value.exponents == wanted::angle.exponents) {
      example_ = wanted::angular_velocity.example;
    }
  }
  WantedDimension wanted() const { return {exponents_, name_.c_str(), example_.c_str()}; }

 private:
  DimensionExponents exponents_;
  std::string name_;
  std::string example_;
};

/// A cubic curve may leave its points by this share of their range without a word of the case.
constexpr double most_overshoot = 0.02;

/// What stands still is no function of time.
void refuse_still(TableReader& table, const FunctionOf& of, std::string_view key,
                  std::string_view wish) {
  table.problem(key, of.still, fmt::format("give {}", wish));
}

double angular_frequency_of(TableReader& table) {
  const bool one = table.says_one_of({{{"angular_frequency"}}, {{"frequency"}}});
  if (!one && table.has("frequency")) {
    table.problem("frequency", "\"angular_frequency\" says it already", "write one of the two");
  }
  if (table.has("angular_frequency")) {
    return table.positive({"angular_frequency", "instead of the frequency"},
                          wanted::angular_frequency);
  }
  return full_turn * table.positive({"frequency", "cycles per time"}, wanted::frequency);
}

HarmonicDriver read_harmonic(TableReader& table, const FunctionOf& of) {
  HarmonicDriver driver;
  driver.mean = table.quantity({"mean", "about which it swings"}, of.value);
  driver.amplitude = table.quantity({"amplitude", "of the swing"}, of.value);
  driver.phase = table.quantity({"phase", "at t = 0: mean + amplitude sin(omega t + phase)"},
                                wanted::angle, 0.0);
  driver.omega = angular_frequency_of(table);
  for (TableReader& row : table.tables({"further", "further harmonics"})) {
    Harmonic& harmonic = driver.further.emplace_back();
    harmonic.amplitude = row.quantity({"amplitude", "of the harmonic"}, of.value);
    harmonic.phase = row.quantity({"phase", "of the harmonic"}, wanted::angle, 0.0);
    harmonic.omega = angular_frequency_of(row);
    row.finish();
  }
  const bool further_still = std::all_of(driver.further.begin(), driver.further.end(),
                                         [](const Harmonic& h) { return h.amplitude == 0.0; });
  if (driver.amplitude == 0.0 && further_still) {
    refuse_still(table, of, "amplitude", "an amplitude other than zero");
  }
  return driver;
}

RateDriver read_constant_rate(TableReader& table, const FunctionOf& of) {
  return {table.quantity({"start", "at t = 0"}, of.value),
          table.not_zero({"rate", "per time, constant"}, Derivative(of, 1).wanted())};
}

PolynomialDriver read_polynomial(TableReader& table, const FunctionOf& of) {
  constexpr int most = 8;
  std::vector<Derivative> derivatives;
  for (int k = 0; k < most; ++k) derivatives.emplace_back(of, k);
  std::vector<WantedDimension> dimensions;
  for (const Derivative& derivative : derivatives) dimensions.push_back(derivative.wanted());
  const std::size_t before = table.problems().size();
  PolynomialDriver driver{
      table.quantities({"coefficients", "c_0 + c_1 t + c_2 t^2 + .."}, dimensions)};
  const bool still = std::all_of(driver.c.begin() + (driver.c.empty() ? 0 : 1), driver.c.end(),
                                 [](double c) { return c == 0.0; });
  if (still && table.problems().size() == before) {
    refuse_still(
        table, of, "coefficients",
        fmt::format("one other than zero behind the first: [\"0 {0}\", \"1 {0}/s\"]", of.unit));
  }
  return driver;
}

StepDriver read_step(TableReader& table, const FunctionOf& of) {
  StepDriver driver;
  driver.from = table.quantity({"from", "before the step"}, of.value);
  driver.to = table.quantity({"to", "behind the step"}, of.value);
  driver.begin = table.quantity({"begin", "of the step"}, wanted::time, 0.0);
  driver.end = table.positive({"end", "of the step"}, wanted::time);
  if (driver.end - driver.begin < 1e-9) {
    table.problem("end", "the step must end after it begins",
                  fmt::format("write a time behind {:.6g} s", driver.begin));
  }
  if (driver.from == driver.to) refuse_still(table, of, "to", "another value than \"from\"");
  return driver;
}

/// Sets the last value of a table that repeats to its first, from which rounding may keep it.
void close(TableReader& reader, TimeTable& table) {
  const auto [low, high] = std::minmax_element(table.value.begin(), table.value.end());
  const double gap = table.value.back() - table.value.front();
  if (std::abs(gap) <= 1e-9 * (*high - *low)) {
    table.value.back() = table.value.front();
    return;
  }
  reader.problems().add(
      table.end,
      fmt::format("the table is to repeat, but its last value misses its first "
                  "by {:.6g} in SI units",
                  gap),
      "end it with the first value once more, or write beyond = \"hold\" for what does not repeat");
}

/// Motions are twice continuously differentiable; of a force straight lines are what a reader of
/// the table sees in it.
Interpolation read_interpolation(TableReader& table, const FunctionOf& of) {
  constexpr std::array kinds{Interpolation::linear, Interpolation::pchip, Interpolation::cubic,
                             Interpolation::step};
  if (!table.has("interpolation")) return of.moves ? Interpolation::cubic : Interpolation::linear;
  const std::size_t before = table.problems().size();
  const Interpolation chosen = kinds[table.choice(
      {"interpolation", "between the points; of what moves a coordinate cubic, the only one"},
      {"linear", "pchip", "cubic", "step"})];
  if (of.moves && chosen != Interpolation::cubic && table.problems().size() == before) {
    table.problem("interpolation",
                  "what moves a coordinate needs accelerations everywhere, which only a cubic "
                  "curve has",
                  "leave \"interpolation\" out; more rows keep the curve near the points");
  }
  return chosen;
}

Beyond read_beyond(TableReader& table) {
  const bool periodic =
      table.boolean({"periodic", "the table repeats: beyond = \"periodic\""}, false);
  if (!table.has("beyond")) return periodic ? Beyond::periodic : Beyond::nothing;
  const Beyond beyond =
      table.choice(
          {"beyond", "before the first and behind the last point; an error where not said"},
          {"hold", "periodic"}) == 0
          ? Beyond::hold
          : Beyond::periodic;
  if (periodic && beyond == Beyond::hold) {
    table.problem("beyond", "a table that repeats does not keep its end values",
                  "write one of periodic = true and beyond = \"hold\"");
  }
  return beyond;
}

/// Notes a spline that leaves its points by more than what a reader of the table would take as one.
void check_overshoot(TableReader& table, const FunctionOf& of, const TableCurve& curve) {
  const bool accepted = table.has("overshoot");
  if (accepted)
    table.choice(
        {"overshoot", "a cubic curve may leave its points by more than 2 % of their range"},
        {"accept"});
  const Overshoot overshoot = curve.overshoot();
  if (accepted || overshoot.share <= most_overshoot) return;
  table.problem(
      "file",
      fmt::format("between two points the cubic curve leaves them by {:.3g} {}, {:.3g} % of the "
                  "table's range, at t = {:.6g} s",
                  overshoot.beyond, of.unit, 100.0 * overshoot.share, overshoot.at),
      fmt::format("{}, or write overshoot = \"accept\"",
                  of.moves ? "give more rows where it bends"
                           : "write interpolation = \"linear\" or \"pchip\", or give more rows"));
}

Driver read_table(TableReader& table, const FunctionOf& of, TimeTables& tables) {
  const std::size_t before = table.problems().size();
  const Interpolation interpolation = read_interpolation(table, of);
  const Beyond beyond = read_beyond(table);
  auto points = tables.read(table, "file", of.value, of.column);
  const bool readable = points.has_value();
  if (readable && beyond == Beyond::periodic) close(table, *points);
  if (!readable || table.problems().size() != before) {
    static_cast<void>(table.has("overshoot"));
    return {};
  }
  TableDriver driver{
      TableCurve(std::move(points->time), std::move(points->value), interpolation, beyond)};
  check_overshoot(table, of, driver.curve);
  return driver;
}

}  // namespace

std::optional<Driver> read_function(TableReader& table, const FunctionOf& of, TimeTables& tables) {
  const std::size_t before = table.problems().size();
  const std::size_t kind =
      table.kind({"kind", "of function"},
                 {"harmonic", "constant rate", "polynomial", "smooth step", "table", "hold"});
  if (table.problems().size() != before) return std::nullopt;
  switch (kind) {
    case 0: return read_harmonic(table, of);
    case 1: return read_constant_rate(table, of);
    case 2: return read_polynomial(table, of);
    case 3: return read_step(table, of);
    case 5: return PolynomialDriver{{table.quantity({"value", "constant"}, of.value)}};
    default: return read_table(table, of, tables);
  }
}

}  // namespace boxbeam::readers
