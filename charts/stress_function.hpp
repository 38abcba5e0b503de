#pragma once

namespace boxbeam::charts {

/// The torsion constant of a rectangular box of one wall, by Prandtl's stress function alone:
/// bilinear elements on a quarter of it, graded towards the re-entrant corner, extrapolated from
/// three meshes of a family (orders 2 and 4). Walls longer than eight thicknesses are taken as
/// straight strips in their middle, which they are to 1e-10. `parts`: elements across the wall in
/// the finest mesh, a multiple of four; 32 give seven digits. For comparison.
double torsion_constant_by_elements(double width, double height, double wall, int parts);

}  // namespace boxbeam::charts
