#include "beam_alone.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "boxbeam/core/error.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "second_order_growth.hpp"
#include "whole_in_space.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t peaks = 3;  ///< of largest compression and bending

/// Whether a beam stands under so many times its loads; at the load that buckles it does not.
bool stands_under(const MakePosture& make, double factor) {
  try {
    return stands(make(factor));
  } catch (const AnalysisError&) {
    return false;
  }
}

/// Largest size of M_y and M_z along the beam [N m].
std::array<double, 2> bending_of(const CutForceDiagram& diagram) {
  std::array<double, 2> most{};
  for (const CutForcePiece& piece : diagram.pieces) {
    const double length = piece.length.value();
    for (const double part : {0.0, 0.5, 1.0}) {
      most[0] = std::max(most[0], std::abs(piece.M_y(part * length)));
      most[1] = std::max(most[1], std::abs(piece.M_z(part * length)));
    }
  }
  return most;
}

}  // namespace

BeamLoads in_plane(BeamLoads loads, Plane plane) {
  if (plane == Plane::z) return loads;
  for (PointLoad& load : loads.points) {
    load.force = {load.force.x(), 0.0, load.force.y()};
    load.moment = {0.0, -load.moment.z(), 0.0};
  }
  for (LineLoad& line : loads.lines) {
    line.force[2] = line.force[1];
    line.couple[1] = -1.0 * line.couple[2];
  }
  return loads;
}

MakePosture BeamAlone::under(const BeamLoads& loads, const std::vector<Hold>& holds) {
  if (!mechanism_ || holds != holds_) {
    mechanism_ = beam_alone(*project_, plane_, holds);
    holds_ = holds;
  }
  return [beam = &project_->beam, mechanism = *mechanism_, loads = in_plane(loads, plane_)](
             double factor) { return loaded_beam(mechanism, *beam, loads, factor); };
}

double part_of_critical(const MakePosture& make, double known) {
  constexpr double least = 1e-4;
  double stable = 1.0 / std::max(known, least);
  if (stands_under(make, stable)) return known;
  double buckled = stable;
  stable *= 0.5;
  while (!stands_under(make, stable) && stable > 1e-6) {
    buckled = stable;
    stable *= 0.5;
  }
  constexpr double close = 1e-5;
  while (buckled - stable > close * buckled) {
    const double middle = 0.5 * (stable + buckled);
    (stands_under(make, middle) ? stable : buckled) = middle;
  }
  return 2.0 / (stable + buckled);
}

double compression_of(const CutForceDiagram& diagram) {
  double most = 0.0;
  for (const CutForcePiece& piece : diagram.pieces) {
    const double length = piece.length.value();
    for (const double part : {0.0, 0.5, 1.0}) most = std::max(most, -piece.N(part * length));
  }
  return most;
}

double cantilever_load_of(const Project& project) {
  double least = std::numeric_limits<double>::infinity();
  const double squared = std::pow(0.5 * std::numbers::pi / project.beam.length().value(), 2);
  for (const Segment& segment : project.beam.segments)
    for (const Section& section : {segment.from, segment.to})
      least = std::min(least,
                       squared * project.model.youngs_modulus * properties_of(section).I_2.value());
  return least;
}

bool bears_axial_force(const CutForceDiagram& diagram) {
  constexpr double round_off = 1e-12;
  double axial = 0.0, across = 0.0;
  for (const CutForcePiece& piece : diagram.pieces) {
    const double length = piece.length.value();
    for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      axial = std::max(axial, std::abs(piece.N(part * length)));
      across = std::max(
          {across, std::abs(piece.V_y(part * length)), std::abs(piece.V_z(part * length))});
    }
  }
  return axial > round_off * across;
}

std::vector<std::size_t> instants_of(const LoadHistory& history, std::size_t spread) {
  struct Instant {
    std::size_t index;
    double compression;
    std::array<double, 2> bending;
    bool wanted;
  };
  const std::size_t step = std::max<std::size_t>(1, history.instants() / spread);
  std::vector<Instant> all;
  for (std::size_t i = 0; i < history.instants(); ++i) {
    const CutForceDiagram diagram = history.diagram(i);
    all.push_back({i, compression_of(diagram), bending_of(diagram), i % step == 0});
  }
  const auto want_most = [&](const auto& size) {
    const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(peaks, all.size()));
    std::stable_sort(all.begin(), all.end(),
                     [&](const Instant& a, const Instant& b) { return size(a) > size(b); });
    std::for_each(all.begin(), end, [](Instant& of) { of.wanted = true; });
  };
  want_most([](const Instant& of) { return of.bending[0]; });
  want_most([](const Instant& of) { return of.bending[1]; });
  std::sort(all.begin(), all.end(),
            [](const Instant& a, const Instant& b) { return a.index < b.index; });
  want_most([](const Instant& of) { return of.compression; });
  std::vector<std::size_t> instants;
  for (const Instant& of : all)
    if (of.wanted) instants.push_back(of.index);
  return instants;
}

double pressed_part_in(const Project& project, const SituationRun& run) {
  BeamAlone alone(project, Plane::z), sideways(project, Plane::y);
  double part = 0.0;
  for (const std::size_t i : instants_of(run.loads)) {
    const Time time = run.loads.time_of(i);
    const BeamLoads loads = run.loads.loads_at(time);
    if (compression_of(cut_forces_of(loads)) <= 0.0) continue;
    const auto holds = holds_of(project, run.motion->supports(loads));
    MakePosture make = run.motion->stopped(time, loads);
    if (!make) make = alone.under(loads, holds.along_z.at);
    part = part_of_critical(make, part);
    if (!project.in_space) continue;
    part = part_of_critical(sideways.under(loads, holds.along_y.at), part);
    if (!held_by_whole(project, holds)) continue;
    constexpr double least = 1e-3;
    part = std::max(part, part_of_whole(run, time, cut_forces_of(loads), 1.0, least).value_or(0.0));
  }
  return part;
}

}  // namespace boxbeam
