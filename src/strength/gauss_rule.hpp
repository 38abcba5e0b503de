#pragma once

#include <array>

namespace boxbeam {

/// Gauss' rule of four points on 0..1: exact for polynomials of degree 7.
inline constexpr double outer_point = 0.8611363115940526, inner_point = 0.3399810435848563;
inline constexpr std::array gauss_place{0.5 * (1.0 - outer_point), 0.5 * (1.0 - inner_point),
                                        0.5 * (1.0 + inner_point), 0.5 * (1.0 + outer_point)};
inline constexpr double outer_weight = 0.5 * 0.3478548451374538,
                        inner_weight = 0.5 * 0.6521451548625461;
inline constexpr std::array gauss_weight{outer_weight, inner_weight, inner_weight, outer_weight};

}  // namespace boxbeam
