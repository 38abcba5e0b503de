#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "boxbeam/section/cut_forces.hpp"
#include "boxbeam/section/outline.hpp"

/// A place of a section whose plates buckle, by the effective sections in which each cut force acts
/// alone.
namespace boxbeam {

class Derivation;
class Traced;

/// What acts alone, by which an effective section is found: each has its own.
enum class ActingAlone { compression, M_y_positive, M_y_negative, M_z_positive, M_z_negative };
inline constexpr std::size_t ways_of_acting = 5;

/// Of a moment: about which axis, and in which sense.
constexpr bool is_about_y(ActingAlone of) {
  return of == ActingAlone::M_y_positive || of == ActingAlone::M_y_negative;
}
constexpr bool is_positive(ActingAlone of) {
  return of == ActingAlone::M_y_positive || of == ActingAlone::M_z_positive;
}
/// The moment that acts; `about_y` or about z.
ActingAlone moment_alone(bool about_y, bool negative);

/// What of N's own effective section is taken: whether the centroid shifts, and whether the area is
/// the whole one.
struct Shifts {
  bool along_y = false, along_z = false;
  bool whole_area = false;
};

/// Gross centroid, and how far it shifts under N alone.
struct EffectiveCentroid {
  Length y, z, shift_y, shift_z;
};
/// What mirrors itself has no shift but round-off, which would be taken for bending: below `none`.
EffectiveCentroid effective_centroid_of(const AreaSums& gross, const AreaSums& compressed,
                                        double none);

/// What resists at a place.
struct EffectivePlace {
  std::array<double, 2> areas{};       ///< in tension, in compression [m^2]
  std::array<double, 2> W_y{}, W_z{};  ///< of positive and negative moments, signed [m^3]
  /// Axes that are no principal ones: the parts add up by their sizes.
  bool sizes = false;
};

/// The stress of a place, part by part, and how far it is used.
struct SectionUse {
  Area area;                ///< gross in tension, effective in compression
  Length arm_y, arm_z;      ///< of N, from the beam axis to the centroid
  Shifts shifts;            ///< of the centroid that these contain
  Moment M_y, M_z;          ///< about the centroid
  SectionModulus W_y, W_z;  ///< signed: stress per moment, inverted
  bool sizes = false;       ///< of `EffectivePlace`
  Stress stress;            ///< tension positive
  Stress yield_strength;
  double use = 0.0;  ///< eta_1 with gamma_M0 = 1
};

/// All but strength and use.
SectionUse stress_at(const EffectivePlace& place, const EffectiveCentroid& centroid,
                     const CutForces& cut, const Shifts& shifts);

/// What N's own effective section may be taken as: all of it, and whatever of it relieves left out.
template <class Look>
void look_at_shifts(const EffectiveCentroid& centroid, const CutForces& cut, const Look& look) {
  for (unsigned k = 0; k < 8; ++k) {
    const Shifts shifts{(k & 1U) != 0, (k & 2U) != 0, (k & 4U) != 0};
    if (k != 0 && !(cut.N.value() < 0.0)) continue;
    if (shifts.along_y && centroid.shift_y.value() == 0.0) continue;
    if (shifts.along_z && centroid.shift_z.value() == 0.0) continue;
    look(shifts);
  }
}

/// Stress per moment about an axis through the centroid, each axis by itself, as the standard has
/// its moduli [1/m^3].
double stress_per_moment(const AreaSums& sums, ActingAlone acting, double y, double z);

/// The larger one of that and of unsymmetric bending: what is left may mirror itself no more, and
/// where the axes' coupling makes more, it counts [1/m^3].
double most_per_moment(const AreaSums& sums, ActingAlone acting, double y, double z);

/// W of a place in a coordinate of it, z or y: of what is left, or, where that is less, of
/// unsymmetric bending.
Traced derive_modulus(Derivation& steps, const AreaSums& left, bool about_y, Length place,
                      SectionModulus used, const char* where);

/// The stress of a use, from moduli that are derived when their moment has been.
Traced derive_stress(Derivation& steps, const SectionUse& use, const CutForces& cut,
                     const std::function<Traced()>& W_y, const std::function<Traced()>& W_z);

}  // namespace boxbeam
