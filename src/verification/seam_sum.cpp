#include "boxbeam/verification/seam_sum.hpp"

#include <array>
#include <cmath>
#include <variant>

namespace boxbeam {
namespace {

/// Outer edges of the webs where they meet the flanges.
std::array<SectionPlace, 4> seam_places_of(const Box& box) {
  const Length y = 0.5 * box.width, z = 0.5 * box.height;
  const Length top = z - box.top_flange, bottom = box.bottom_flange - z;
  return {{{y, top}, {-y, top}, {y, bottom}, {-y, bottom}}};
}

}  // namespace

SeamSum seams_of(const TaperedBeam& beam) {
  SeamSum sum{};
  for (const Segment& segment : beam.segments) {
    const Box* const from = std::get_if<Box>(&segment.from.outer);
    const Box* const to = std::get_if<Box>(&segment.to.outer);
    if (from == nullptr || to == nullptr) continue;
    const auto begins = seam_places_of(*from), ends = seam_places_of(*to);
    const double a = from->seam_throat.value(), b = to->seam_throat.value();
    for (std::size_t k = 0; k < begins.size(); ++k) {
      const double length = std::hypot(segment.length.value(), (ends[k].y - begins[k].y).value(),
                                       (ends[k].z - begins[k].z).value());
      (a > 0.0 || b > 0.0 ? sum.fillets : sum.full) += si<Length>(length);
      // The throat changes in proportion to the way.
      sum.deposit += si<Volume>(length * (a * a + a * b + b * b) / 3.0);
    }
  }
  return sum;
}

}  // namespace boxbeam
