#include "boxbeam/strength/plate_slenderness.hpp"

#include <cmath>

namespace boxbeam {

std::vector<SlenderPlate> slender_plates_of(const Profile& profile, const Material& material) {
  std::vector<SlenderPlate> slender;
  // `power`: eps for plates, eps^2 for tubes.
  const auto look = [&](const char* name, Length clear, Length thickness, double factor,
                        int power) {
    const auto yield = yield_strength_of(material, thickness);
    if (!yield) return;
    const double eps = std::sqrt(235e6 / yield->value());
    const double limit = factor * std::pow(eps, power);
    const double ratio = clear / thickness;
    if (ratio > limit) slender.push_back({name, ratio, limit});
  };
  if (const auto* box = std::get_if<HollowRectangle>(&profile)) {
    look("flange", box->width - 2.0 * box->web, box->flange, 42.0, 1);
    look("web", box->height - 2.0 * box->flange, box->web, 124.0, 1);
  } else {
    const auto& tube = std::get<RoundTube>(profile);
    look("round wall", tube.diameter, tube.wall, 90.0, 2);
  }
  return slender;
}

}  // namespace boxbeam
