#include "verdict_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

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
    const LoadHistory& loads = run.loads;
    if (loads.is_recorded()) return look_at_recorded(run);
    for (std::size_t i = 0; i < loads.instants(); ++i) {
      for (const Jump& jump : jumps_of(loads.kept_diagram(i))) take(run, jump, i);
    }
  }

  AxialForce most;

 private:
  struct Jump {
    Length s;
    double N = 0.0;
  };

  std::vector<Jump> jumps_of(const CutForceDiagram& diagram) const {
    std::vector<Jump> jumps;
    for (std::size_t k = 1; k < diagram.pieces.size(); ++k) {
      const CutForcePiece &before = diagram.pieces[k - 1], &behind = diagram.pieces[k];
      if (stands_at_end(project_->beam, behind.start)) continue;
      jumps.push_back({behind.start, behind.N(0.0) - before.N(before.length.value())});
    }
    return jumps;
  }

  /// Linear in the channels.
  void look_at_recorded(const SituationRun& run) {
    const recorded::ChannelLoads& of = run.loads.recorded_loads();
    const std::vector<Jump> constant = jumps_of(cut_forces_of(of.constant));
    std::vector<std::vector<Jump>> units;
    for (const BeamLoads& unit : of.units) units.push_back(jumps_of(cut_forces_of(unit)));
    for (std::size_t p = 0; p < constant.size(); ++p) {
      const bool jumps = std::any_of(units.begin(), units.end(),
                                     [&](const auto& unit) { return unit[p].N != 0.0; });
      for (std::size_t i = 0; i < (jumps ? run.loads.instants() : 1); ++i) {
        Jump jump = constant[p];
        for (std::size_t k = 0; k < units.size(); ++k)
          jump.N += of.channels->values[k][i] * units[k][p].N;
        take(run, jump, i);
      }
    }
  }

  void take(const SituationRun& run, const Jump& jump, std::size_t instant) {
    // What a long beam bears anywhere is not looked up for round-off.
    if (!(std::abs(jump.N) > 1e-6 * run.loads.largest_force())) return;
    const double size = run.situation->load_factor * std::abs(jump.N);
    const double use = size / borne_at(jump.s);
    if (use > most.use) most = {use, size, jump.s, &run, instant};
  }

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
