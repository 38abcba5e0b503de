#include "axial_bimoment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/section/warping.hpp"

namespace boxbeam {
namespace {

/// An edge of a wall, on a face of it.
struct Edge {
  StressInfluence influence;
  double omega = 0.0;  ///< [m^2]
};

/// A side of a place where forces come in.
struct OpenSection {
  Warping warping;
  std::vector<Edge> edges;
  double yield = 0.0;  ///< [Pa]
};

std::vector<Edge> edges_of(const Section& section, const Warping& warping) {
  const AreaSums sums = sums_of(properties_of(section));
  std::vector<Edge> edges;
  for (const Warping::Line& wall : warping.walls) {
    const Eigen::Vector2d along = (wall.to - wall.from).normalized();
    const Eigen::Vector2d half = 0.5 * wall.thickness * Eigen::Vector2d(-along.y(), along.x());
    for (const double face : {1.0, -1.0}) {
      for (const bool at_end : {false, true}) {
        const Eigen::Vector2d place = (at_end ? wall.to : wall.from) + face * half;
        edges.push_back({normal_influence(sums, place.x(), place.y()),
                         at_end ? wall.omega_to : wall.omega_from});
      }
    }
  }
  return edges;
}

/// What comes in at one place at an instant.
struct Place {
  const PointLoad* most = nullptr;      ///< of its loads
  std::vector<const PointLoad*> loads;  ///< beside the axis, along the beam
};

/// The largest of all that is looked at.
class Search {
 public:
  explicit Search(const Project& project) : project_(&project) {}

  void look_at(const SituationRun& run) {
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const BeamLoads loads = run.loads.loads_at(run.loads.time_of(i));
      const std::map<double, Place> places = places_in(loads);
      if (places.empty()) continue;
      const CutForceDiagram diagram = run.loads.diagram(i);
      const double factor = run.situation->load_factor;
      double sum = 0.0, most = 0.0;
      const PointLoad* by = nullptr;
      for (const auto& [s, place] : places) {
        const double here = look_at(si<Length>(s), place, diagram, factor);
        sum += here;
        if (here <= most) continue;
        most = here;
        by = place.most;
      }
      if (by == nullptr || !(factor * sum > found.largest)) continue;
      found.largest = factor * sum;
      found.words = words_of(*by, factor);
    }
  }

  AxialBimoments found;

 private:
  static std::map<double, Place> places_in(const BeamLoads& loads) {
    std::map<double, Place> places;
    for (const PointLoad& load : loads.points) {
      if (load.force.x() == 0.0 || load.at.isZero(0.0)) continue;
      Place& place = places[load.s.value()];
      place.loads.push_back(&load);
      if (place.most == nullptr || std::abs(load.force.x()) > std::abs(place.most->force.x()))
        place.most = &load;
    }
    return places;
  }

  static std::string words_of(const PointLoad& load, double factor) {
    return fmt::format("{:.4g} kN along the beam beside the axis, {} at s = {} m",
                       1e-3 * factor * std::abs(load.force.x()),
                       load.name.empty() ? "a force" : fmt::format("\"{}\"", load.name),
                       to_text(Station{load.s, Side::both}));
  }

  /// The larger bimoment of both sides [N m^2].
  double look_at(Length s, const Place& place, const CutForceDiagram& diagram, double factor) {
    double largest = 0.0;
    for (const Side side : {Side::before, Side::behind}) {
      if (side == Side::before ? s == Length{} : s == project_->beam.length()) continue;
      const std::optional<OpenSection>& open = section_on({s, side});
      if (!open) continue;
      // What acts is balanced by the cut behind it; before it the beam pulls against it.
      double B = 0.0;
      for (const PointLoad* const load : place.loads)
        B += load->force.x() * omega_near(open->warping, load->at);
      if (side == Side::behind) B = -B;
      largest = std::max(largest, std::abs(B));
      judge(*open, B, diagram.at({s, side}), {s, side}, place, factor);
    }
    return largest;
  }

  void judge(const OpenSection& open, double B, const CutForces& cut, const Station& station,
             const Place& place, double factor) {
    const StrengthDemand& demand = project_->strength;
    for (const Edge& edge : open.edges) {
      const double by_B = B * edge.omega / open.warping.I_w;
      const double all = factor * (stress_of(edge.influence.normal, cut) + by_B);
      const double use = demand.required * demand.gamma_M0 * std::abs(all) / open.yield;
      constexpr double rounded = 1.0 + 1e-9;
      // Where it stresses less than without it, others have judged.
      if (!(use > std::max(use_, rounded)) || by_B * all <= 0.0) continue;
      use_ = use;
      const std::size_t at = segment_at(project_->beam, station);
      found.gate = Gate{
          project_->beam.segments[at].name, "",
          fmt::format("{}, makes a bimoment of {:.3g} kN m^2, which no check counts: an edge has "
                      "{:.3g} MPa along the beam by it and {:.3g} MPa with N, M_y and M_z, {:.3g} "
                      "times what it may",
                      words_of(*place.most, factor), 1e-3 * factor * std::abs(B),
                      1e-6 * factor * std::abs(by_B), 1e-6 * std::abs(all), use),
          true};
    }
  }

  /// Not where it fades within the thickness of a wall, as where all walls meet in one line.
  bool warps(const Section& section, const Warping& of) const {
    const auto I_T = torsion_properties_of(section).I_T;
    double thickest = 0.0;
    for (const Warping::Line& wall : of.walls) thickest = std::max(thickest, wall.thickness);
    const ModelInput& model = project_->model;
    return I_T &&
           model.youngs_modulus * of.I_w > model.shear_modulus * I_T->value() * thickest * thickest;
  }

  const std::optional<OpenSection>& section_on(const Station& station) {
    const auto key = std::pair(station.s.value(), station.side == Side::behind);
    const auto known = sections_.find(key);
    if (known != sections_.end()) return known->second;
    std::optional<OpenSection>& open = sections_[key];
    const Section section = section_at(project_->beam, station);
    auto warping = section.inner ? std::nullopt : warping_of(section.outer);
    if (!warping || !warps(section, *warping)) return open;
    open = OpenSection{std::move(*warping), {}, 0.0};
    open->edges = edges_of(section, open->warping);
    const std::vector<Length> plates = thicknesses_of(section);
    const PlateOf weakest = first_to_yield(
        plates_around(*project_, station.s, *std::max_element(plates.begin(), plates.end())));
    if (const auto yield = yield_strength_of(*weakest.material, weakest.thickness))
      open->yield = yield->value();
    return open;
  }

  const Project* project_;
  double use_ = 0.0;
  std::map<std::pair<double, bool>, std::optional<OpenSection>> sections_;
};

}  // namespace

AxialBimoments axial_bimoments_of(const Project& project, const std::deque<SituationRun>& runs) {
  Search search(project);
  for (const SituationRun& run : runs) search.look_at(run);
  return std::move(search.found);
}

}  // namespace boxbeam
