#include "boxbeam/strength/section_use.hpp"

#include <cmath>

#include "boxbeam/section/normal_stress.hpp"
#include "plate_formulas.hpp"

namespace boxbeam {

ActingAlone moment_alone(bool about_y, bool negative) {
  using enum ActingAlone;
  if (about_y) return negative ? M_y_negative : M_y_positive;
  return negative ? M_z_negative : M_z_positive;
}

EffectiveCentroid effective_centroid_of(const AreaSums& gross, const AreaSums& compressed,
                                        double none) {
  const auto exact = [&](double x) { return std::abs(x) < none ? Length{} : si<Length>(x); };
  return {exact(gross.y / gross.area), exact(gross.z / gross.area),
          exact(compressed.y / compressed.area - gross.y / gross.area),
          exact(compressed.z / compressed.area - gross.z / gross.area)};
}

SectionUse stress_at(const EffectivePlace& place, const EffectiveCentroid& centroid,
                     const CutForces& cut, const Shifts& shifts) {
  SectionUse of;
  of.shifts = shifts;
  of.sizes = place.sizes;
  const double N = cut.N.value();
  // N at the beam axis is N at the centroid and the moments of its lever arms.
  of.arm_z = centroid.z + (shifts.along_z ? centroid.shift_z : Length{});
  of.arm_y = centroid.y + (shifts.along_y ? centroid.shift_y : Length{});
  const double M_y = plate::shifted_moment(cut.M_y.value(), N, of.arm_z.value());
  const double M_z = plate::shifted_moment(cut.M_z.value(), N, -of.arm_y.value());
  const double area = place.areas[N < 0.0 && !shifts.whole_area ? 1 : 0];
  const double W_y = place.W_y[M_y < 0.0 ? 1 : 0], W_z = place.W_z[M_z < 0.0 ? 1 : 0];
  of.area = si<Area>(area);
  of.W_y = si<SectionModulus>(W_y);
  of.W_z = si<SectionModulus>(W_z);
  of.M_y = si<Moment>(M_y);
  of.M_z = si<Moment>(M_z);
  of.stress =
      si<Stress>(place.sizes ? plate::corner_stress(std::abs(N), area, std::abs(M_y), std::abs(W_y),
                                                    std::abs(M_z), std::abs(W_z))
                             : plate::corner_stress(N, area, M_y, W_y, M_z, W_z));
  return of;
}

double stress_per_moment(const AreaSums& sums, ActingAlone acting, double y, double z) {
  const double y_c = sums.y / sums.area, z_c = sums.z / sums.area;
  return is_about_y(acting) ? (z - z_c) / (sums.zz - sums.area * z_c * z_c)
                            : -(y - y_c) / (sums.yy - sums.area * y_c * y_c);
}

double most_per_moment(const AreaSums& sums, ActingAlone acting, double y, double z) {
  const double by_itself = stress_per_moment(sums, acting, y, z);
  const double coupled =
      normal_influence(sums, y, z).normal[is_about_y(acting) ? cut_force::M_y : cut_force::M_z];
  return std::abs(coupled) > std::abs(by_itself) ? coupled : by_itself;
}

Traced derive_modulus(Derivation& steps, const AreaSums& left, bool about_y, Length place,
                      SectionModulus used, const char* where) {
  const double centre = (about_y ? left.z : left.y) / left.area;
  const double I = (about_y ? left.zz : left.yy) - left.area * centre * centre;
  const double sign = about_y ? 1.0 : -1.0;
  const double by_itself = sign * I / (place.value() - centre);
  const char* const symbol = about_y ? "W_y,eff" : "W_z,eff";
  if (std::abs(by_itself - used.value()) > 1e-9 * std::abs(by_itself)) {
    return steps.given(symbol, used,
                       "of what is left, whose product of inertia makes it less than I/e");
  }
  const Traced inertia = steps.given(about_y ? "I_y,eff" : "I_z,eff", si<SecondMoment>(I),
                                     "of what is left, about its centroid");
  const Traced z_c =
      steps.given(about_y ? "z_c" : "y_c", si<Length>(centre), "the centroid of what is left");
  const Traced z = steps.given(about_y ? "z" : "y", place, where);
  return steps.define(symbol, about_y ? inertia / (z - z_c) : inertia / (z_c - z));
}

Traced derive_stress(Derivation& steps, const SectionUse& use, const CutForces& cut,
                     const std::function<Traced()>& W_y, const std::function<Traced()>& W_z) {
  const bool pressed = cut.N.value() < 0.0, reduced = pressed && !use.shifts.whole_area;
  const Traced N = steps.given("N", cut.N);
  const Traced A = steps.given(reduced ? "A_eff" : "A", use.area,
                               reduced   ? "gross less what is idle"
                               : pressed ? "gross: what is idle under N alone would relieve here"
                                         : "tension: gross");
  const auto moment = [&](const char* symbol, const char* of, const char* arm, Moment acting,
                          Length lever, bool shifted, bool along_z) {
    Traced M = steps.given(of, acting);
    if (lever.value() == 0.0) return M;
    // M_z turns the other way.
    const char* const from = along_z ? (shifted ? "from the beam axis to the centroid under N alone"
                                                : "from the beam axis to the gross centroid")
                                     : (shifted ? "from the centroid under N alone to the beam axis"
                                                : "from the gross centroid to the beam axis");
    const Traced e = steps.given(arm, lever, from);
    return steps.define(symbol, plate::shifted_moment(M, N, e));
  };
  const auto sized = [&](const Traced& of) { return use.sizes ? abs(of) : of; };
  const char* const how =
      use.sizes ? "axes that are no principal ones: sizes of the parts, on the safe side" : "";
  const Traced M_y = moment("M_y,E", "M_y", "e_z", cut.M_y, use.arm_z, use.shifts.along_z, true);
  const Traced by_N = N, modulus_y = W_y();
  if (use.M_z.value() == 0.0) {
    return steps.define("sigma_eff",
                        plate::corner_stress(sized(by_N), A, sized(M_y), sized(modulus_y)), how);
  }
  const Traced M_z = moment("M_z,E", "M_z", "e_y", cut.M_z, -use.arm_y, use.shifts.along_y, false);
  const Traced modulus_z = W_z();
  return steps.define("sigma_eff",
                      plate::corner_stress(sized(by_N), A, sized(M_y), sized(modulus_y), sized(M_z),
                                           sized(modulus_z)),
                      how);
}

}  // namespace boxbeam
