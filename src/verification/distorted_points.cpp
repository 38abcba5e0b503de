#include "distorted_points.hpp"

#include <cmath>
#include <utility>

#include "boxbeam/verification/worst_place.hpp"

namespace boxbeam {

Length fillet_of(const Profile& profile) {
  const auto* const box = std::get_if<Box>(&profile);
  return box == nullptr ? Length{} : box->seam_throat;
}

std::vector<DistortedPoint> distorted_points_at(const Project& project,
                                                const std::vector<BendingZone>& zones,
                                                const DistortedStretch& stretch,
                                                std::size_t place) {
  const Station& station = stretch.places()[place].station;
  const Profile outer = section_at(project.beam, station).outer;
  const Length fillet = fillet_of(outer);
  std::vector<DistortedPoint> points;
  const auto add = [&](StressPoint point) {
    DistortedPoint of{std::move(point), {}, 0.0, 0.0, {}};
    for (const CellPlace& at : places_in_cell(outer, of.point.y, of.point.z))
      of.at.push_back(distortion_at(stretch.cell(place), stretch.stiffness(place), at));
    if (of.at.empty()) return;
    const StrengthDemand& strength = project.strength;
    if (!of.point.on_throat) {
      of.resisting = of.point.yield_strength.value() / strength.gamma_M0;
    } else {
      of.at = {of.at.front().in_throat(seam_throat_of(of.point))};
      const Material& joined = *of.point.joined.material;
      const auto tensile = tensile_strength_of(joined, of.point.joined.thickness);
      // One that penetrates fully is the plate itself.
      if (tensile && fillet.value() > 0.0) {
        constexpr double of_tensile = 0.9;
        of.weld = {*tensile, joined.beta_w, strength.gamma_M2};
        of.resisting = weld_strength(plainly, of.weld).value();
        of.resisting_across = of_tensile * tensile->value() / strength.gamma_M2;
      }
    }
    points.push_back(std::move(of));
  };
  for (const StressPoint& point : stress_points_at(project, zones, station)) {
    if (!point.edges.empty()) continue;
    if (!point.stretch) {
      add(point);
    } else if (!point.stretch->wall.inner) {
      for (const double part : {0.0, 0.5, 1.0}) add(moved_along(point, part));
    }
  }
  return points;
}

PointUse use_of(const DistortedPoint& of, const PointStress& alone, const DistortionSize& size,
                double load_factor) {
  PointUse worst;
  const auto take = [&](double stress, double resisting, const DistortionInfluence& at) {
    const PointUse use{load_factor * stress, resisting, &at};
    if (worst.at == nullptr || use.use() > worst.use()) worst = use;
  };
  for (const DistortionInfluence& at : of.at) {
    const double sigma_t = at.across * size.angle;
    const double tau = std::abs(alone.shear.value()) + std::abs(at.shear) * size.shear;
    if (of.point.on_throat) {
      take(bent_throat_stress(sigma_t, tau), of.resisting, at);
      take(sigma_t, of.resisting_across, at);
    } else {
      const double sigma_x = std::abs(alone.normal.value()) + std::abs(at.along) * size.moment;
      take(bent_across_stress(sigma_x, sigma_t, tau), of.resisting, at);
    }
  }
  return worst;
}

}  // namespace boxbeam
