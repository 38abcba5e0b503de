#include "boxbeam/verification/warping_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/section/warping.hpp"
#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {
namespace {

/// Bimoments of forces along the beam that come in beside the axis of open sections.
struct AxialBimoments {
  double largest = 0.0;      ///< the sum of their sizes along the beam, at its largest [N m^2]
  std::string words;         ///< "400 kN along the beam beside its axis, \"p\" at s = 2 m"
  std::optional<Gate> gate;  ///< where N, M_y, M_z and B are more than the section bears
};

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

/// Precondition: in space.
AxialBimoments axial_bimoments_of(const Project& project, const std::deque<SituationRun>& runs) {
  Search search(project);
  for (const SituationRun& run : runs) search.look_at(run);
  return std::move(search.found);
}

/// An end of a segment of open thin walls, or a place in it.
struct WarpingEnd {
  Warping warping;
  double GI_T = 0.0, EI_w = 0.0;
  SectionPlace shear_centre;
};

struct WarpingSegment {
  const Segment* segment = nullptr;
  double least_yield = 0.0;
  std::vector<WarpingEnd> ends;
};

/// The largest torque of a segment, about its shear centre.
struct LargestTorque {
  double size = 0.0, s = 0.0;
};

double thickest_of(const ThinWalled& path) {
  Length most;
  for (const ThinWall& wall : path.walls) most = std::max(most, wall.thickness);
  return most.value();
}

/// Nothing where what warping stresses fades within the thickness of a wall, as where all walls
/// meet in one line: bars do not say it.
std::optional<WarpingEnd> warping_end_of(const Project& project, const Section& section) {
  const auto* const path = std::get_if<ThinWalled>(&section.outer);
  if (path == nullptr || section.inner) return std::nullopt;
  const auto warping = warping_of(section.outer);
  const TorsionProperties torsion = torsion_properties_of(section);
  if (!warping || !torsion.I_T || !torsion.shear_centre) return std::nullopt;
  WarpingEnd of{*warping, project.model.shear_modulus * torsion.I_T->value(),
                project.model.youngs_modulus * warping->I_w, *torsion.shear_centre};
  if (!(of.EI_w > of.GI_T * std::pow(thickest_of(*path), 2))) return std::nullopt;
  return of;
}

WarpingSegment warping_segment_of(const Project& project, std::size_t index) {
  const Segment& segment = project.beam.segments[index];
  WarpingSegment of{&segment, 0.0, {}};
  // Between unlike ends something may be largest inside.
  const int parts = segment.from == segment.to ? 1 : 8;
  for (int i = 0; i <= parts; ++i) {
    const auto end = warping_end_of(
        project, interpolate(segment.from, segment.to, static_cast<double>(i) / parts));
    if (end) of.ends.push_back(*end);
  }
  const auto* const path = std::get_if<ThinWalled>(&segment.from.outer);
  if (path == nullptr) return of;
  const auto yield = yield_strength_of(materials_of(project, index).of(PlateKind::wall),
                                       si<Length>(thickest_of(*path)));
  if (yield) of.least_yield = yield->value();
  return of;
}

LargestTorque torque_in(const WarpingSegment& of, const CutForceDiagram& diagram) {
  LargestTorque most;
  const double from = of.segment->start.value(), to = of.segment->end().value();
  for (const CutForcePiece& piece : diagram.pieces) {
    const double start = piece.start.value();
    const double low = std::max(from, start) - start;
    const double high = std::min(to, piece.end().value()) - start;
    if (!(high > low)) continue;
    for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double x = std::lerp(low, high, part);
      for (const WarpingEnd& end : of.ends) {
        const double size = std::abs(piece.T(x) + piece.V_y(x) * end.shear_centre.z.value() -
                                     piece.V_z(x) * end.shear_centre.y.value());
        if (size > most.size) most = {size, start + x};
      }
    }
  }
  return most;
}

/// The largest torque of all segments that warp, with load factors.
LargestTorque torque_of(const std::vector<WarpingSegment>& segments,
                        const std::deque<SituationRun>& runs) {
  LargestTorque most;
  for (const SituationRun& run : runs) {
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      const CutForceDiagram diagram = run.loads.diagram(i);
      for (const WarpingSegment& of : segments) {
        const LargestTorque here = torque_in(of, diagram);
        const double size = run.situation->load_factor * here.size;
        if (size > most.size) most = {size, here.s};
      }
    }
  }
  return most;
}

}  // namespace

double largest_bimoment(double torque, double GI_T, double EI_w, double length) {
  const double k = std::sqrt(GI_T / EI_w);
  return torque / k * std::tanh(k * length);
}

WarpingFound look_at_warping(const Project& project, const std::deque<SituationRun>& runs) {
  WarpingFound found;
  std::vector<WarpingSegment> segments;
  for (std::size_t k = 0; k < project.beam.segments.size(); ++k) {
    WarpingSegment of = warping_segment_of(project, k);
    if (!of.ends.empty()) segments.push_back(std::move(of));
  }
  if (segments.empty()) return found;
  const LargestTorque torque = torque_of(segments, runs);
  AxialBimoments axial = axial_bimoments_of(project, runs);
  const double length = project.beam.length().value();
  double most = 0.0, most_share = 0.0;
  for (const WarpingSegment& of : segments) {
    for (const WarpingEnd& end : of.ends) {
      const double bimoment =
          largest_bimoment(torque.size, end.GI_T, end.EI_w, length) + axial.largest;
      const double stress = bimoment * end.warping.largest / end.warping.I_w;
      most = std::max(most, stress);
      most_share = std::max(most_share, project.strength.required * project.strength.gamma_M0 *
                                            stress / of.least_yield);
    }
  }
  if (axial.gate) found.gates.push_back(std::move(*axial.gate));
  constexpr double much = 0.1;
  if (!(most_share > much)) return found;
  const std::string by_torque =
      torque.size > 0.0
          ? fmt::format("{:.3g} kN m about their shear centre, at s = {} m", 1e-3 * torque.size,
                        to_text(Station{si<Length>(torque.s), Side::both}))
          : "";
  const char* const both = torque.size > 0.0 && axial.largest > 0.0 ? ", and " : "";
  found.not_judged.push_back(
      {Criterion::yield, "warping of open sections",
       fmt::format("{}{}{}, may stress their edges along the beam by up to {:.3g} MPa more, which "
                   "no check counts",
                   by_torque, both, axial.words, 1e-6 * most)});
  return found;
}

}  // namespace boxbeam
