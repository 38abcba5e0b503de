#include "boxbeam/verification/twisting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/slender_path.hpp"

namespace boxbeam {
namespace {

/// A station of an open path.
struct OpenStation {
  Station station;
  double per_force = 0.0;  ///< i_0^2/(G I_T) [1/N]
  bool slender = false;
};

std::vector<OpenStation> open_stations(const Project& project) {
  std::vector<OpenStation> all;
  for (const Segment& segment : project.beam.segments) {
    for (const Station& at :
         {Station{segment.start, Side::behind}, Station{segment.end(), Side::before}}) {
      const Section section = judged_section_at(project, at);
      if (!std::holds_alternative<ThinWalled>(section.outer)) continue;
      const TorsionProperties torsion = torsion_properties_of(section);
      if (torsion.enclosed.value() > 0.0 || !torsion.I_T || !torsion.shear_centre) continue;
      const SectionProperties p = properties_of(section);
      const double y = (torsion.shear_centre->y - p.centroid_y).value();
      const double z = (torsion.shear_centre->z - p.centroid_z).value();
      const double radius = (p.I_y + p.I_z).value() / p.area.value() + y * y + z * z;
      all.push_back({at, radius / (project.model.shear_modulus * torsion.I_T->value()),
                     slender_path_at(project, at) != nullptr});
    }
  }
  return all;
}

}  // namespace

Twisting look_at_twisting(const Project& project, const std::deque<SituationRun>& runs,
                          const SecondOrderEstimate& estimate) {
  Twisting found;
  const std::vector<OpenStation> stations = open_stations(project);
  if (stations.empty()) return found;
  double most = 0.0;
  bool slender = false;
  for (const SituationRun& run : runs) {
    const double factor = std::max(1.0, run.situation->load_factor);
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const CutForceDiagram diagram = run.loads.diagram(i);
      for (const OpenStation& of : stations) {
        const double part = -factor * diagram.at(of.station).N.value() * of.per_force;
        if (part > no_buckling_below) slender = slender || of.slender;
        most = std::max(most, part);
      }
    }
  }
  const double sideways =
      std::max(estimate.in_plane.factored, estimate.across ? estimate.across->factored : 0.0);
  if (most <= no_buckling_below || (!slender && most <= sideways)) return found;
  const std::string text = fmt::format(
      "N is {:.3g} of G I_T/i_0^2, the critical load without warping (EN 1993-1-1, 6.3.1.4)", most);
  if (slender)
    found.gates.push_back(
        {"", "",
         "buckling by twisting of an open section whose walls may buckle is not judged: " + text,
         true});
  else
    found.not_judged.push_back({Criterion::member, "buckling by twisting", "not judged, " + text});
  return found;
}

}  // namespace boxbeam
