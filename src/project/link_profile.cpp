#include "boxbeam/project/link_profile.hpp"

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_area.hpp"

namespace boxbeam {

std::vector<flexible::LinkStretch> link_stretches_of(const TaperedBeam& beam, double youngs_modulus,
                                                     double shear_modulus) {
  const std::vector<SegmentMass> masses = mass_distribution_of(beam);
  std::vector<flexible::LinkStretch> stretches;
  for (std::size_t i = 0; i < beam.segments.size(); ++i) {
    const Segment& segment = beam.segments[i];
    const double length = segment.length.value();
    const auto over_length = [&](const auto& of) {
      return interpolate<4>(
          [&](double x) { return of(interpolate(segment.from, segment.to, x / length)); }, length);
    };
    flexible::LinkStretch& stretch = stretches.emplace_back();
    stretch.start = segment.start.value();
    stretch.length = length;
    stretch.EA = over_length([&](const Section& section) {
      return youngs_modulus * properties_of(section).area.value();
    });
    stretch.GA = over_length(
        [&](const Section& section) { return shear_modulus * shear_areas_of(section).z.value(); });
    stretch.EI = over_length([&](const Section& section) {
      const SectionProperties properties = properties_of(section);
      const double I_yz = properties.I_yz.value();
      return youngs_modulus * (properties.I_y.value() - I_yz * I_yz / properties.I_z.value());
    });
    stretch.mass = masses[i].mass;
    stretch.rotary = masses[i].rotary_y;
  }
  return stretches;
}

}  // namespace boxbeam
