#include "boxbeam/verification/torques_in.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace boxbeam {
namespace {

using Kind = TorqueSource::Kind;

/// Adds to what comes from the same source, as far as that is in the list from `first` on.
void add(TorqueIn more, std::size_t first, TorquesIn& all) {
  const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
  const auto same = std::find_if(begin, all.end(),
                                 [&](const TorqueIn& other) { return other.from == more.from; });
  if (same == all.end())
    all.push_back(more);
  else
    same->torque += more.torque;
}

/// What pushes along z with a lever along y and along y with one along z at once, each way by
/// itself, spread over some places of each stretch.
void add_lines(const BeamLoads& loads, const std::vector<LineLever>& levers, TorquesIn& all) {
  constexpr int places = 8;
  for (const LineLoad& line : loads.lines) {
    const double length = line.length.value(), middle = line.start.value() + 0.5 * length;
    double y = 0.0, z = 0.0;
    for (const LineLever& of : levers) {
      if (middle < of.from || middle > of.to) continue;
      y = std::max(y, std::abs(of.y));
      z = std::max(z, std::abs(of.z));
    }
    // Linear along the stretch: all of it is the middle times the length.
    const auto pushed = [&](std::size_t axis, std::size_t way) {
      return line.outside[axis][way](0.5 * length) * length;
    };
    const std::array torques{z * pushed(0, 0), z * pushed(0, 1), y * pushed(1, 0),
                             y * pushed(1, 1)};
    if (!(torques[0] + torques[1] > 0.0) || !(torques[2] + torques[3] > 0.0)) continue;
    for (std::size_t way = 0; way < torques.size(); ++way) {
      for (int k = 0; k < places; ++k)
        all.push_back({line.start.value() + (k + 0.5) / places * length,
                       torques[way] / places,
                       {Kind::couple, "line forces", way}});
    }
  }
}

}  // namespace

std::vector<LineLever> line_levers_of(const Project& project) {
  std::vector<LineLever> levers;
  const auto* const of = std::get_if<spatial::Mechanism>(&project.mechanism);
  if (of == nullptr) return levers;
  for (const spatial::LineForce& line : of->line_forces) {
    if (line.on != project.placement.body) continue;
    const Eigen::Vector3d from = spatial::in_beam(project.placement, line.from);
    const double to = spatial::in_beam(project.placement, line.to).x();
    levers.push_back({std::min(from.x(), to), std::max(from.x(), to), from.y(), from.z()});
  }
  return levers;
}

double least_torque(const SituationRun& run) {
  constexpr double of_moment = 1e-6;
  return of_moment * run.loads.largest_moment();
}

double one_place_of(const TaperedBeam& beam) {
  constexpr double of_length = 1e-9;
  return of_length * beam.length().value();
}

TorquesIn torques_in(const BeamLoads& loads, const std::vector<LineLever>& lines, double one_place,
                     double least) {
  std::vector<const PointLoad*> points;
  for (const PointLoad& load : loads.points) points.push_back(&load);
  std::stable_sort(points.begin(), points.end(),
                   [](const PointLoad* a, const PointLoad* b) { return a->s < b->s; });
  TorquesIn all;
  std::size_t first = 0;
  double s = 0.0;
  for (const PointLoad* const load : points) {
    if (load->s.value() - s > one_place || load == points.front()) {
      first = all.size();
      s = load->s.value();
    }
    const double by_webs = load->force.z() * load->at.x();
    const double by_flanges = -load->force.y() * load->at.y();
    const double couple = torque_of(*load);
    if (by_webs != 0.0) add({s, by_webs, {Kind::by_webs}}, first, all);
    if (by_flanges != 0.0) add({s, by_flanges, {Kind::by_flanges}}, first, all);
    if (couple != 0.0) add({s, couple, {Kind::couple, load->name, load->part}}, first, all);
  }
  if (!lines.empty()) add_lines(loads, lines, all);
  std::erase_if(all, [&](const TorqueIn& of) { return !(std::abs(of.torque) > least); });
  return all;
}

TorquesIn torques_in(const CutForceDiagram& diagram, double least) {
  TorquesIn all;
  double before = 0.0, end = 0.0;
  const auto jump = [&](double s, double behind) {
    if (std::abs(before - behind) > least) all.push_back({s, before - behind});
  };
  for (const CutForcePiece& piece : diagram.pieces) {
    jump(piece.start.value(), piece.T(0.0));
    before = piece.T(piece.length.value());
    end = piece.end().value();
  }
  jump(end, 0.0);
  return all;
}

std::vector<std::vector<TorquesIn>> torques_in(const Project& project,
                                               const std::deque<SituationRun>& runs) {
  const double one_place = one_place_of(project.beam);
  const std::vector<LineLever> lines = line_levers_of(project);
  std::vector<std::vector<TorquesIn>> all;
  for (const SituationRun& run : runs) {
    const LoadHistory& loads = run.loads;
    const double least = least_torque(run);
    std::vector<TorquesIn>& of = all.emplace_back();
    of.reserve(loads.instants());
    for (std::size_t i = 0; i < loads.instants(); ++i)
      of.push_back(loads.is_recorded()
                       ? torques_in(loads.diagram(i), least)
                       : torques_in(loads.loads_at(loads.time_of(i)), lines, one_place, least));
  }
  return all;
}

TorquesIn torques_between(const TorquesIn& all, const CutForceDiagram& diagram, double from,
                          double to, double one_place) {
  TorquesIn between;
  for (TorqueIn of : all) {
    if (of.s < from - one_place || of.s > to + one_place) continue;
    if (of.s < from + one_place) of.s = from;
    if (of.s > to - one_place) of.s = to;
    between.push_back(of);
  }
  const auto pass = [&](double s, Side side, double sense) {
    const double torque = sense * diagram.at({si<Length>(s), side}).T.value();
    if (torque != 0.0) between.push_back({s, torque});
  };
  if (from > one_place) pass(from, Side::before, -1.0);
  if (to < diagram.pieces.back().end().value() - one_place) pass(to, Side::behind, 1.0);
  return between;
}

}  // namespace boxbeam
