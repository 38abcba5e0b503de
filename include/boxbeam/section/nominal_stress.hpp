#pragma once

/// Stresses of beams in a few letters, over values or expressions. What is verified comes from
/// `StressInfluence`, which holds for every section; where these hold they are the same.
namespace boxbeam {

/// N and M_y about the centroid.
///
///     sigma = N/A + M_y e_z/I_y
///
/// e_z  from the centroid. Valid in principal axes. Source: Navier.
template <class N, class A, class M, class L, class I>
auto bending_stress(const N& force, const A& area, const M& M_y, const L& e_z, const I& I_y) {
  return force / area + M_y * e_z / I_y;
}

/// The same with M_z, -M_z e_y/I_z.
template <class N, class A, class M, class L, class I>
auto bending_stress(const N& force, const A& area, const M& M_y, const L& e_z, const I& I_y,
                    const M& M_z, const L& e_y, const I& I_z) {
  return force / area + M_y * e_z / I_y - M_z * e_y / I_z;
}

/// Shear stress of V at a level.
///
///     tau = V S/(I_y b)
///
/// S  first moment of what lies beyond, b  width there. Source: Zhuravsky (1855).
template <class V, class S, class I, class L>
auto level_shear_stress(const V& force, const S& moment, const I& inertia, const L& width) {
  return force * moment / (inertia * width);
}

/// Shear stress per torque of the flow around a cell, of what of the torque its walls do not carry
/// themselves.
///
///     c_TB = (1 - I_w/I_T)/(2 A_m t)
///
/// I_w  sum of s t^3/3 of the walls, A_m  area inside their mid-lines. Source: Bredt (1896).
template <class I, class A, class L>
auto cell_shear(const I& of_walls, const I& of_all, const A& enclosed, const L& thickness) {
  return (1.0 - of_walls / of_all) / (2.0 * enclosed * thickness);
}

/// Shear stress per torque on the face of a thin wall, t/I_T. Source: Saint-Venant.
template <class L, class I>
auto face_shear(const L& thickness, const I& torsion_constant) {
  return thickness / torsion_constant;
}

}  // namespace boxbeam
