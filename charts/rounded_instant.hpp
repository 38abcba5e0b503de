#pragma once

#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

#include "charts/arithmetic.hpp"

namespace boxbeam::charts {

/// mean + amplitude sin(omega t + phase) and its derivatives with every operation rounded to
/// `Scalar`, and the argument of the sine to `Argument`: what a calculation carries that writes
/// omega t down before it goes on. Valid for one harmonic.
template <class Scalar, class Argument = Scalar>
DriverState rounded_state(const HarmonicDriver& driver, double time) {
  using std::cos;
  using std::sin;
  const auto omega = static_cast<Scalar>(driver.omega);
  Scalar argument = omega * static_cast<Scalar>(time) + static_cast<Scalar>(driver.phase);
  if constexpr (!std::is_same_v<Scalar, Argument>) {
    const Argument written(static_cast<double>(argument));
    argument = static_cast<Scalar>(static_cast<double>(written));
  }
  const auto amplitude = static_cast<Scalar>(driver.amplitude);
  const Scalar sine = sin(argument);
  const Scalar cosine = cos(argument);
  return {static_cast<double>(static_cast<Scalar>(driver.mean) + amplitude * sine),
          static_cast<double>(amplitude * omega * cosine),
          static_cast<double>(-amplitude * omega * omega * sine)};
}

/// A mechanism's positions, velocities and accelerations for given states of its drivers, in an
/// arithmetic; nothing where Newton's method does not converge from the start.
template <class Scalar>
std::optional<InstantIn<Scalar>> rounded_instant(const planar::Mechanism& mechanism,
                                                 const std::vector<DriverState>& drivers,
                                                 const Eigen::VectorXd& start) {
  TextbookSolver<Scalar> solver(mechanism, LinearMethod::dense);
  solver.equations().set_driver_states(drivers);
  InstantIn<Scalar> instant;
  instant.q = start.cast<Scalar>();
  if (solver.solve_position(instant.q, 0.0) == 0 || !solver.solve_rates(instant)) {
    return std::nullopt;
  }
  return instant;
}

}  // namespace boxbeam::charts
