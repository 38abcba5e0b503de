#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace boxbeam {

/// Exponents of metre, kilogram, second, radian and kelvin. The angle counts here, so that "0.7 Hz"
/// is not taken for "0.7 rad/s".
struct DimensionExponents {
  int length = 0, mass = 0, time = 0, angle = 0, temperature = 0;

  friend bool operator==(const DimensionExponents&, const DimensionExponents&) = default;
};

/// What a key of a case file wants, with the words and the example used in messages.
struct WantedDimension {
  DimensionExponents exponents;
  const char* name;     ///< "a length"
  const char* example;  ///< "0.25 m"
  /// Whether a radian in it may be left out ("N m" for "N m/rad").
  bool radian_optional = false;
};

/// Whether a quantity is of the wanted dimension.
constexpr bool is_of(const DimensionExponents& exponents, const WantedDimension& wanted) {
  if (exponents == wanted.exponents) return true;
  DimensionExponents without = wanted.exponents;
  without.angle = 0;
  return wanted.radian_optional && exponents == without;
}

namespace wanted {
inline constexpr WantedDimension pure_number{{0, 0, 0, 0}, "a number without unit", "\"2.0\""};
inline constexpr WantedDimension length{{1, 0, 0, 0}, "a length", "\"0.25 m\" or \"250 mm\""};
inline constexpr WantedDimension area{{2, 0, 0, 0}, "an area", "\"1200 mm^2\""};
inline constexpr WantedDimension volume{{3, 0, 0, 0}, "a volume", "\"0.5 m^3\""};
inline constexpr WantedDimension mass{{0, 1, 0, 0}, "a mass", "\"119 kg\" or \"20 t\""};
inline constexpr WantedDimension time{{0, 0, 1, 0}, "a time", "\"1.071 s\""};
inline constexpr WantedDimension angle{{0, 0, 0, 1}, "an angle", "\"25 deg\" or \"0.44 rad\""};
inline constexpr WantedDimension frequency{{0, 0, -1, 0}, "a frequency", "\"0.7 Hz\""};
inline constexpr WantedDimension angular_frequency{
    {0, 0, -1, 1}, "an angular frequency", "\"4.396 rad/s\""};
/// The same in the words of motion.
inline constexpr WantedDimension angular_velocity{
    {0, 0, -1, 1}, "an angular velocity", "\"6 rpm\" or \"0.63 rad/s\""};
inline constexpr WantedDimension acceleration{{1, 0, -2, 0}, "an acceleration", "\"9.81 m/s^2\""};
inline constexpr WantedDimension stress{{-1, 1, -2, 0}, "a stress", "\"355 MPa\""};
inline constexpr WantedDimension line_mass{{-1, 1, 0, 0}, "a mass per length", "\"60 kg/m\""};
inline constexpr WantedDimension bending_stiffness{
    {3, 1, -2, 0}, "a bending stiffness", "\"12 MN m^2\""};
inline constexpr WantedDimension density{{-3, 1, 0, 0}, "a density", "\"7850 kg/m^3\""};
inline constexpr WantedDimension inertia{{2, 1, 0, 0}, "a moment of inertia", "\"7.43 kg m^2\""};
inline constexpr WantedDimension velocity{{1, 0, -1, 0}, "a velocity", "\"10 mm/s\""};
inline constexpr WantedDimension force{{1, 1, -2, 0}, "a force", "\"10 kN\""};
inline constexpr WantedDimension moment{{2, 1, -2, 0}, "a moment", "\"12 kN m\""};
inline constexpr WantedDimension stiffness{{0, 1, -2, 0}, "a force per length", "\"200 kN/m\""};
inline constexpr WantedDimension damping{{0, 1, -1, 0}, "a force per velocity", "\"500 N s/m\""};
inline constexpr WantedDimension torsional_stiffness{
    {2, 1, -2, -1}, "a moment per angle", "\"5 kN m/rad\"", true};
inline constexpr WantedDimension torsional_damping{
    {2, 1, -1, -1}, "a moment per angular velocity", "\"20 N m s/rad\"", true};
/// Of how much warmer something is.
inline constexpr WantedDimension temperature{
    {0, 0, 0, 0, 1}, "a difference of temperature", "\"30 K\""};
inline constexpr WantedDimension temperature_gradient{
    {-1, 0, 0, 0, 1}, "a difference of temperature per length", "\"50 K/m\""};
inline constexpr WantedDimension expansion{
    {0, 0, 0, 0, -1}, "a strain per difference of temperature", "\"1.2e-5 1/K\""};
}  // namespace wanted

/// A number with its unit, in SI base units.
struct ParsedQuantity {
  double value = 0.0;
  DimensionExponents exponents;
};

/// Reads "12 kN m", "9.81 m/s^2", "355 MPa": a decimal number, a space or none, and units joined by
/// spaces, "*" or "·", behind "/" divided, with integer exponents "^2". Prefixes n, u, m, c, k, M,
/// G. Returns what is wrong as text where it cannot be read; the value is always finite.
std::variant<ParsedQuantity, std::string> parse_quantity(std::string_view text);

/// What to write where a text has a sign that only looks like the minus of a number, "\u2212" or a
/// dash; "" where it has none.
std::string look_alike_sign_in(std::string_view text);

/// "a length", "a force", or the unit in base units for a dimension without a name here.
std::string name_of(const DimensionExponents& exponents);

/// The entry of `known` nearest to `word` by edit distance, "" where none is near. Capitals count
/// only between entries that are equally near without them.
std::string nearest_word(std::string_view word, const std::vector<std::string>& known);

}  // namespace boxbeam
