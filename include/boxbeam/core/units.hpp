#pragma once

#include <boost/units/cmath.hpp>
#include <boost/units/quantity.hpp>
#include <boost/units/systems/si.hpp>
#include <boost/units/systems/si/prefixes.hpp>

/// Quantities with their dimension in the type. Everything is stored in SI base units; millimetres,
/// kilonewtons and degrees exist only where text is read or printed.
///
/// `Moment` is force times length. Boost's own torque, moment of inertia and angular velocity carry
/// the plane angle as a base dimension and are not used; angles are plain radians.
namespace boxbeam {

namespace units {
namespace si = boost::units::si;
}  // namespace units

using Length = boost::units::quantity<units::si::length>;
using Area = boost::units::quantity<units::si::area>;
using Volume = boost::units::quantity<units::si::volume>;
using Mass = boost::units::quantity<units::si::mass>;
using Time = boost::units::quantity<units::si::time>;
using Force = boost::units::quantity<units::si::force>;
using Stress = boost::units::quantity<units::si::pressure>;
using Density = boost::units::quantity<units::si::mass_density>;
using Acceleration = boost::units::quantity<units::si::acceleration>;
using Dimensionless = boost::units::quantity<units::si::dimensionless>;

/// Force times length [N m]; carries no angle.
using Moment = decltype(Force{} * Length{});
/// First moment of area and section modulus [m^3].
using SectionModulus = Volume;
/// Second moment of area [m^4].
using SecondMoment = decltype(Area{} * Area{});
/// Mass moment of inertia [kg m^2]; carries no angle.
using MassMoment = decltype(Mass{} * Area{});
using MassPerLength = decltype(Mass{} / Length{});
using ForcePerLength = decltype(Force{} / Length{});

inline constexpr auto metre = units::si::metre;
inline constexpr auto newton = units::si::newton;
inline constexpr auto kilogram = units::si::kilogram;
inline constexpr auto second = units::si::second;
inline constexpr auto pascal = units::si::pascal;

/// A quantity of SI value `x`, for crossing from plain doubles: `si<Length>(0.25)` is 250 mm.
template <class Quantity>
constexpr Quantity si(double x) {
  return Quantity::from_value(x);
}

}  // namespace boxbeam
