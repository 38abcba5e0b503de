#include "axial_forces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "force_kinds.hpp"

namespace boxbeam {
namespace {

struct AxialForce {
  double use = 0.0, size = 0.0;  ///< [N], with its load factor
  Length s;
  const SituationRun* run = nullptr;
  std::size_t instant = 0;
};

bool has_plates(const Section& section) {
  return !std::holds_alternative<Plate>(section.outer) &&
         !std::holds_alternative<Polygon>(section.outer);
}

/// Looks for the largest of all instants.
class AxialForces {
 public:
  explicit AxialForces(const Project& project) : project_(&project) {}

  void look_at(const SituationRun& run) {
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const CutForceDiagram diagram = run.loads.diagram(i);
      for (std::size_t k = 1; k < diagram.pieces.size(); ++k) {
        const CutForcePiece &before = diagram.pieces[k - 1], &behind = diagram.pieces[k];
        const double size =
            run.situation->load_factor * std::abs(behind.N(0.0) - before.N(before.length.value()));
        // What a long beam bears anywhere is not looked up for round-off.
        if (!(size > 1e-6 * run.loads.largest_force())) continue;
        if (stands_at_end(project_->beam, behind.start)) continue;
        const double use = size / borne_at(behind.start);
        if (use > most.use) most = {use, size, behind.start, &run, i};
      }
    }
  }

  AxialForce most;

 private:
  /// What a quarter of the section bears, of the weaker side [N]; endless of solids.
  double borne_at(Length s) {
    const auto known = borne_.find(s.value());
    if (known != borne_.end()) return known->second;
    double least = std::numeric_limits<double>::infinity();
    for (const Side side : {Side::before, Side::behind}) {
      const Section section = section_at(project_->beam, {s, side});
      if (!has_plates(section)) continue;
      const std::vector<Length> plates = thicknesses_of(section);
      const PlateOf weakest = first_to_yield(
          plates_around(*project_, s, *std::max_element(plates.begin(), plates.end())));
      const auto strength = yield_strength_of(*weakest.material, weakest.thickness);
      const StrengthDemand& demand = project_->strength;
      if (strength)
        least = std::min(least, 0.25 * properties_of(section).area.value() * strength->value() /
                                    (demand.required * demand.gamma_M0));
    }
    return borne_[s.value()] = least;
  }

  const Project* project_;
  std::map<double, double> borne_;
};

/// Of the loads there the one that pulls or pushes most.
std::string name_of(const Project& project, const AxialForce& of) {
  const BeamLoads loads = of.run->loads.loads_at(of.run->loads.time_of(of.instant));
  const PointLoad* most = nullptr;
  for (const PointLoad& load : loads.points) {
    if (abs(load.s - of.s) > 1e-6 * project.beam.length()) continue;
    if (most == nullptr || std::abs(load.force.x()) > std::abs(most->force.x())) most = &load;
  }
  return most == nullptr || most->name.empty() ? "a force" : std::string(most->name);
}

}  // namespace

std::vector<NotJudged> axial_forces_not_judged(const Project& project,
                                               const std::deque<SituationRun>& runs) {
  AxialForces forces(project);
  for (const SituationRun& run : runs) forces.look_at(run);
  const AxialForce& of = forces.most;
  constexpr double hardly_felt = 0.3;
  if (!(of.use > hardly_felt)) return {};
  return {{Criterion::yield,
           fmt::format("plates under {} at s = {} m", name_of(project, of),
                       to_text(Station{of.s, Side::both})),
           fmt::format("its force along the beam, {:.4g} kN, is taken as spread over the whole "
                       "section at once; how it comes in is not judged (EN 1993-1-5, 3.2.3)",
                       1e-3 * of.size)}};
}

}  // namespace boxbeam
