#pragma once

namespace boxbeam {

/// What counts of a direct stress range whose compression damages less: the tensile part and 60 %
/// of the compressive part.
///
///     both tensile: d_sigma,  both compressive: 0.6 d_sigma,  else: sigma_max - 0.6 sigma_min
///
/// `range` = highest - lowest.
/// Source: EN 1993-1-9:2005, 7.2.1, figure 7.4.
template <class Value>
Value reduced_range(const Value& highest, const Value& lowest, const Value& range) {
  constexpr double counted = 0.6;
  if (lowest >= Value(0.0)) return range;
  if (highest <= Value(0.0)) return counted * range;
  return highest - counted * lowest;
}

}  // namespace boxbeam
