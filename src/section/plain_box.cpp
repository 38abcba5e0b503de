#include "boxbeam/section/plain_box.hpp"

namespace boxbeam {
namespace {

template <class Value>
auto cube(const Value& x) {
  return x * x * x;
}

/// The letters of a box.
struct Letters {
  Letters(Derivation& steps, const PlainBox& box)
      : B(steps.known("B", box.B)),
        H(steps.known("H", box.H)),
        b(steps.known("b", box.b)),
        h(steps.known("h", box.h)) {}
  Traced B, H, b, h;
};

}  // namespace

std::optional<PlainBox> plain_box_of(const Section& section) {
  const auto* box = std::get_if<Box>(&section.outer);
  if (box == nullptr || section.inner || !box->stiffeners.empty()) return std::nullopt;
  if (box->top_flange != box->bottom_flange || box->left_web != box->right_web) return std::nullopt;
  return PlainBox{box->width,
                  box->height,
                  box->width - 2.0 * box->left_web,
                  box->height - 2.0 * box->top_flange,
                  box->top_flange,
                  box->left_web};
}

TracedSection derive_plain_box(Derivation& steps, const PlainBox& box, bool in_space) {
  const auto [B, H, b, h] = Letters(steps, box);
  const Traced A = steps.define("A", B * H - b * h, "box, outside B x H, inside b x h");
  const Traced I_y = steps.define("I_y", (B * cube(H) - b * cube(h)) / 12.0);
  if (!in_space) return {A, I_y, 0.0};
  return {A, I_y, steps.define("I_z", (H * cube(B) - h * cube(b)) / 12.0)};
}

void derive_box_less_strips(Derivation& steps, const PlainBox& box, const TracedSection& whole,
                            const Traced& of_flanges, const Traced& of_webs, bool in_space) {
  const auto [B, H, b, h] = Letters(steps, box);
  const Traced t_f = steps.known("t_f", box.flange), t_w = steps.known("t_w", box.web);
  steps.define("A_eff", whole.A - 2.0 * of_flanges * t_f - 2.0 * of_webs * t_w);
  steps.define("I_y,eff",
               whole.I_y - of_flanges * (cube(H) - cube(h)) / 12.0 - t_w * cube(of_webs) / 6.0);
  if (!in_space) return;
  steps.define("I_z,eff",
               whole.I_z - of_webs * (cube(B) - cube(b)) / 12.0 - t_f * cube(of_flanges) / 6.0);
}

}  // namespace boxbeam
