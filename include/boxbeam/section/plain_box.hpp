#pragma once

#include <optional>

#include "boxbeam/core/derivation.hpp"
#include "boxbeam/section/section.hpp"

namespace boxbeam {

/// A box of equal flanges and equal webs without anything inside: B x H outside, b x h inside.
struct PlainBox {
  Length B, H, b, h;
  Length flange, web;  ///< thicknesses
};

/// Nothing for sections that are none.
std::optional<PlainBox> plain_box_of(const Section& section);

/// Area and second moments, as expressions.
struct TracedSection {
  Traced A, I_y, I_z;
};

/// By formulas of a few letters, step by step; I_z in space only.
///
///     A = B H - b h,  I_y = (B H^3 - b h^3)/12,  I_z = (H B^3 - h b^3)/12
///
/// They are what properties_of comes to along the border.
TracedSection derive_plain_box(Derivation& steps, const PlainBox& box, bool in_space);

/// The same less strips of a width in the middle of each flange and of each web; a constant zero
/// for no strip.
///
///     A_eff = A - 2 b_i t_f - 2 h_i t_w
///     I_y,eff = I_y - b_i (H^3 - h^3)/12 - t_w h_i^3/6,  I_z,eff likewise
void derive_box_less_strips(Derivation& steps, const PlainBox& box, const TracedSection& whole,
                            const Traced& of_flanges, const Traced& of_webs, bool in_space);

}  // namespace boxbeam
