#include "boxbeam/project/limits.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace boxbeam::limits {
namespace {

constexpr Count table_of_counts[] = {
    {"bodies", 3000},
    {"bodies.*.points", 300},
    {"joints", 6000},
    {"drivers", 300},
    {"forces", 600},
    {"loads", 600},
    {"loops", 300},
    {"links", 300},
    {"links.*.points", 300},
    {"sections", 2000},
    {"sections.*.outer", 500},
    {"sections.*.stiffeners", 60},
    {"beam.segments", 500},
    {"beam.holes", 200},
    {"beam.restraints", 100},
    {"beam.points", 300},
    {"fatigue.details", 500},
    {"situations", 500},
    {"pins", 300},
    {"rods", 300},
    {"given_stresses", 1000},
    {"hand_formulas", 1000},
    {"assumptions", 1000},
    {"*", 5000},
};

/// Whether a key is one of a pattern, part by part.
bool fits(std::string_view key, std::string_view pattern) {
  while (true) {
    const std::string_view part = key.substr(0, key.find('.'));
    const std::string_view wanted = pattern.substr(0, pattern.find('.'));
    if (wanted != "*" && wanted != part) return false;
    const bool last = part.size() == key.size();
    if (last || wanted.size() == pattern.size()) return last && wanted.size() == pattern.size();
    key.remove_prefix(part.size() + 1);
    pattern.remove_prefix(wanted.size() + 1);
  }
}

struct OfDimension {
  DimensionExponents exponents;
  double smallest, largest;
  const char* unit;
};

/// Beyond these nothing is meant that moves a welded beam: a length that no beam has, a mass of a
/// mountain, a modulus a thousand times that of diamond.
constexpr OfDimension table_of_ranges[] = {
    {wanted::length.exponents, 1e-9, 1e4, "m"},
    {wanted::mass.exponents, 1e-12, 1e12, "kg"},
    {wanted::time.exponents, 1e-12, 1e9, "s"},
    {wanted::angle.exponents, 1e-12, 1e6, "rad"},
    {wanted::frequency.exponents, 1e-9, 1e6, "Hz"},
    {wanted::angular_frequency.exponents, 1e-9, 1e7, "rad/s"},
    {wanted::velocity.exponents, 1e-12, 1e6, "m/s"},
    {wanted::acceleration.exponents, 1e-12, 1e9, "m/s^2"},
    {wanted::force.exponents, 1e-9, 1e15, "N"},
    {wanted::moment.exponents, 1e-9, 1e16, "N m"},
    {wanted::stress.exponents, 1e-3, 1e15, "Pa"},
    {wanted::density.exponents, 1e-9, 1e6, "kg/m^3"},
    {wanted::line_mass.exponents, 1e-12, 1e9, "kg/m"},
    {wanted::bending_stiffness.exponents, 1e-9, 1e18, "N m^2"},
    {wanted::inertia.exponents, 1e-15, 1e15, "kg m^2"},
    {wanted::stiffness.exponents, 1e-9, 1e16, "N/m"},
    {wanted::torsional_stiffness.exponents, 1e-9, 1e16, "N m/rad"},
    {wanted::damping.exponents, 1e-12, 1e15, "N s/m"},
    {wanted::torsional_damping.exponents, 1e-12, 1e15, "N m s/rad"},
};

}  // namespace

std::span<const Count> counts() { return table_of_counts; }

std::size_t most_entries(std::string_view key) {
  const auto* const found = std::find_if(std::begin(table_of_counts), std::end(table_of_counts),
                                         [&](const Count& of) { return fits(key, of.key); });
  return found != std::end(table_of_counts) ? found->most : std::rbegin(table_of_counts)->most;
}

Range range_of(const WantedDimension& wanted) {
  for (const OfDimension& of : table_of_ranges) {
    if (of.exponents == wanted.exponents) {
      return {of.smallest, of.largest, fmt::format("{:g} {}", of.largest, of.unit)};
    }
  }
  // Products of these, as the coefficients of a polynomial.
  return {1e-20, 1e16, "1e+16 in SI units"};
}

}  // namespace boxbeam::limits
