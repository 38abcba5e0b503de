#include "boxbeam/verification/distorted_stretch.hpp"

#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

constexpr std::size_t most_places = 64;  ///< where torque comes that get nodes: wheels move

/// -dT/ds, what comes per length.
double line_torque_at(const CutForceDiagram& diagram, double s) {
  for (const CutForcePiece& piece : diagram.pieces) {
    if (s <= piece.end().value()) return -derivative_of(piece.T)(s - piece.start.value());
  }
  return 0.0;
}

/// a + factor |b|, each for itself.
void add_size(DistortionSize& a, const DistortionSize& b, double factor = 1.0) {
  a.angle += factor * std::abs(b.angle);
  a.moment += factor * std::abs(b.moment);
  a.shear += factor * std::abs(b.shear);
}

}  // namespace

DistortedStretch::DistortedStretch(const Project& project, const std::deque<SituationRun>& runs,
                                   const std::vector<std::vector<TorquesIn>>& torques,
                                   const BoxStretch& stretch, const std::vector<Station>& stations)
    : project_(&project),
      runs_(&runs),
      torques_(&torques),
      stretch_(stretch),
      from_(project.beam.segments[stretch.first].start.value()),
      to_(project.beam.segments[stretch.last].end().value()),
      near_(one_place_of(project.beam)),
      solver_(beam_under(stations)) {
  add_places();
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const SituationRun& run = runs[r];
    std::vector<Loads>& of = loads_.emplace_back();
    for (std::size_t i = 0; i < run.loads.instants(); ++i) {
      of.push_back(loads_of(run.loads.diagram(i), torques_at(r, i), least_torque(run)));
      if (any_comes_by_flow())
        note_flow(run.loads.loads_at(run.loads.time_of(i)), least_torque(run));
      distorted_ = distorted_ || !of.back().nodes.empty() || of.back().lines || of.back().tapers;
    }
  }
}

TorquesIn DistortedStretch::torques_at(std::size_t run, std::size_t instant) const {
  return torques_between((*torques_)[run][instant], (*runs_)[run].loads.diagram(instant), from_,
                         to_, near_);
}

TorquesIn DistortedStretch::torques_of(const BeamLoads& beam_loads) const {
  return torques_between(torques_in(beam_loads, line_levers_of(*project_), near_, 0.0),
                         cut_forces_of(beam_loads), from_, to_, near_);
}

void DistortedStretch::find_introduced() {
  for (std::size_t r = 0; r < runs_->size(); ++r) {
    const double least = least_torque((*runs_)[r]);
    for (std::size_t i = 0; i < (*runs_)[r].loads.instants(); ++i) {
      for (const TorqueIn& of : torques_at(r, i)) {
        const auto same = [&](Length s) { return std::abs(s.value() - of.s) <= near_; };
        if (std::abs(of.torque) <= least ||
            std::any_of(introduced_.begin(), introduced_.end(), same))
          continue;
        slides_ = introduced_.size() >= most_places;
        if (slides_) return;
        introduced_.push_back(si<Length>(of.s));
      }
    }
  }
}

DistortedBeam DistortedStretch::beam_under(const std::vector<Station>& stations) {
  const TaperedBeam& beam = project_->beam;
  jumps_ = {from_, to_};
  for (std::size_t i = stretch_.first; i < stretch_.last; ++i)
    jumps_.push_back(beam.segments[i].end().value());
  for (const Diaphragm& of : beam.diaphragms)
    if (of.s.value() >= from_ - near_ && of.s.value() <= to_ + near_)
      jumps_.push_back(std::clamp(of.s.value(), from_, to_));
  find_introduced();
  for (const Length& s : introduced_) jumps_.push_back(s.value());
  std::sort(introduced_.begin(), introduced_.end());
  std::sort(jumps_.begin(), jumps_.end());
  const auto alike = [&](double a, double b) { return b - a <= near_; };
  jumps_.erase(std::unique(jumps_.begin(), jumps_.end(), alike), jumps_.end());
  jumps_.back() = to_;
  // Elements far shorter than the others would spoil the elimination.
  constexpr double apart = 1e-4;
  std::vector<double> places = jumps_;
  for (const Station& at : stations) {
    const double s = at.s.value();
    if (s <= from_ || s >= to_) continue;
    const auto close = [&](double other) { return std::abs(other - s) < apart * (to_ - from_); };
    if (std::none_of(places.begin(), places.end(), close)) {
      places.push_back(s);
      jumps_.push_back(s);
    }
  }
  std::sort(places.begin(), places.end());
  std::sort(jumps_.begin(), jumps_.end());

  const double E = project_->model.youngs_modulus;
  const double nu = 0.5 * E / project_->model.shear_modulus - 1.0;
  const auto cell_at = [&](double s) {
    const Side side = s > to_ - near_ ? Side::before : Side::behind;
    return *box_cell_of(section_at(beam, {si<Length>(s), side}).outer);
  };
  DistortedBeam of = distorted_beam(places, cell_at, E, nu);
  for (const Diaphragm& diaphragm : beam.diaphragms) {
    const double s = diaphragm.s.value();
    if (s < from_ - near_ || s > to_ + near_) continue;
    of.diaphragms[of.nearest(s)] += diaphragm_stiffness(
        cell_at(std::clamp(s, from_, to_)), diaphragm.thickness, diaphragm.opening, E, nu);
  }
  return of;
}

void DistortedStretch::add_places() {
  const std::vector<double>& nodes = solver_.beam().nodes;
  const double E = project_->model.youngs_modulus;
  const double nu = 0.5 * E / project_->model.shear_modulus - 1.0;
  const auto add = [&](double s, Side side, std::size_t element, std::size_t end) {
    places_.push_back({{si<Length>(s), side}, element, end});
    cells_.push_back(*box_cell_of(section_at(project_->beam, places_.back().station).outer));
    stiffness_.push_back(cell_distortion_of(cells_.back(), E, nu));
  };
  for (std::size_t e = 0; e + 1 < nodes.size(); ++e) {
    add(nodes[e], Side::behind, e, 0);
    const double end = nodes[e + 1];
    const bool jumps = std::binary_search(jumps_.begin(), jumps_.end(), end);
    if (jumps || slides_) add(end, Side::before, e, 1);
  }
}

std::vector<DistortedStretch::NodeLoad> DistortedStretch::shared(double s, double load,
                                                                 const TorqueSource& from) const {
  const std::vector<double>& at = solver_.beam().nodes;
  const auto above =
      std::clamp<std::ptrdiff_t>(std::lower_bound(at.begin(), at.end(), s - near_) - at.begin(), 1,
                                 static_cast<std::ptrdiff_t>(at.size()) - 1);
  const auto next = static_cast<std::size_t>(above);
  const double part = std::clamp((s - at[next - 1]) / (at[next] - at[next - 1]), 0.0, 1.0);
  constexpr double all = 1e-6;
  std::vector<NodeLoad> loads;
  if (part < 1.0 - all) loads.push_back({next - 1, from, (1.0 - part) * load});
  if (part > all) loads.push_back({next, from, part * load});
  return loads;
}

/// Of the narrowest stretch.
const LoadIntroduction* DistortedStretch::introduction_at(double s) const {
  const LoadIntroduction* narrowest = nullptr;
  for (const LoadIntroduction& of : project_->beam.introductions) {
    if (!of.torque_by || s < of.from.value() - near_ || s > of.to.value() + near_) continue;
    if (narrowest == nullptr || of.to - of.from < narrowest->to - narrowest->from) narrowest = &of;
  }
  return narrowest;
}

bool DistortedStretch::comes_by_flow(double s) const {
  const LoadIntroduction* const by = introduction_at(s);
  return by != nullptr && *by->torque_by == TorqueBy::flow;
}

bool DistortedStretch::any_comes_by_flow() const {
  const std::vector<LoadIntroduction>& all = project_->beam.introductions;
  return std::any_of(all.begin(), all.end(),
                     [](const LoadIntroduction& of) { return of.torque_by == TorqueBy::flow; });
}

void DistortedStretch::note_flow(const BeamLoads& beam_loads, double least) {
  const std::vector<Diaphragm>& diaphragms = project_->beam.diaphragms;
  for (const PointLoad& load : beam_loads.points) {
    const double s = std::clamp(load.s.value(), from_, to_), torque = std::abs(torque_of(load));
    if (std::abs(load.s.value() - s) > near_ || !comes_by_flow(s) || torque <= least ||
        torque <= spread_by_nothing_.torque.value())
      continue;
    const BoxCell& cell = cells_[0];
    const Length near = std::max(cell.width, cell.height);
    if (std::any_of(diaphragms.begin(), diaphragms.end(),
                    [&](const Diaphragm& of) { return abs(of.s - load.s) <= near; }))
      continue;
    spread_by_nothing_ = {load.s, si<Moment>(torque)};
  }
}

void DistortedStretch::add_node(const NodeLoad& at, Loads& loads) {
  const auto same = std::find_if(
      loads.nodes.begin(), loads.nodes.end(),
      [&](const NodeLoad& other) { return other.node == at.node && other.from == at.from; });
  if (same != loads.nodes.end())
    same->d += at.d;
  else
    loads.nodes.push_back(at);
}

void DistortedStretch::add_torque(const TorqueIn& of, std::vector<double>& known,
                                  Loads& loads) const {
  using Kind = TorqueSource::Kind;
  const bool by_webs = of.from.kind == Kind::by_webs, by_flanges = of.from.kind == Kind::by_flanges;
  const LoadIntroduction* const by = introduction_at(of.s);
  const bool flows = by != nullptr && *by->torque_by == TorqueBy::flow;
  if (flows && !by_webs && !by_flanges) return;
  for (NodeLoad at : shared(of.s, 0.5 * of.torque, of.from)) {
    if (flows) {
      // T_w = F_z y by the webs and T_f = -F_y z by the flanges, d = (T_w - T_f)/2.
      add_node({at.node, {Kind::by_webs}, by_webs ? at.d : -at.d}, loads);
    } else if (by == nullptr || (*by->torque_by == TorqueBy::webs ? by_flanges : by_webs)) {
      add_node(at, loads);
    } else {
      known[at.node] += *by->torque_by == TorqueBy::webs ? at.d : -at.d;
    }
  }
}

DistortedStretch::Loads DistortedStretch::loads_of(const CutForceDiagram& diagram,
                                                   const TorquesIn& torques, double least) const {
  Loads loads;
  std::vector<double> known(solver_.beam().nodes.size(), 0.0);
  bool any = false;
  for (const TorqueIn& of : torques) {
    if (std::abs(of.torque) <= least) continue;
    any = true;
    add_torque(of, known, loads);
  }
  loads.lines = line_effects(diagram, least);
  if (any || loads.lines) loads.tapers = known_effects(diagram, std::move(known));
  return loads;
}

std::optional<DistortedStretch::Effects> DistortedStretch::line_effects(
    const CutForceDiagram& diagram, double least) const {
  const DistortedBeam& beam = solver_.beam();
  std::vector<DistortedBeam::AtGauss> lines(beam.nodes.size() - 1);
  double largest = 0.0;
  for (std::size_t e = 0; e < lines.size(); ++e) {
    const DistortedBeam::AtGauss at = beam.places(e);
    for (std::size_t g = 0; g < at.size(); ++g) {
      lines[e][g] = 0.5 * line_torque_at(diagram, at[g]);
      largest = std::max(largest, std::abs(lines[e][g]));
    }
  }
  if (largest * (to_ - from_) <= least) return std::nullopt;
  return effects_of(solver_.solve(std::vector<double>(beam.nodes.size(), 0.0), lines));
}

/// T d(ln(h/b))/2, and `known` at the nodes; nothing where neither is there.
std::optional<DistortedStretch::Effects> DistortedStretch::known_effects(
    const CutForceDiagram& diagram, std::vector<double> known) const {
  const DistortedBeam& beam = solver_.beam();
  std::vector<DistortedBeam::AtGauss> lines = beam.of_torque;
  bool any = std::any_of(known.begin(), known.end(), [](double d) { return d != 0.0; });
  for (std::size_t e = 0; e < lines.size(); ++e) {
    const DistortedBeam::AtGauss at = beam.places(e);
    for (std::size_t g = 0; g < at.size(); ++g) {
      if (lines[e][g] == 0.0) continue;
      lines[e][g] *= diagram.at({si<Length>(at[g])}).T.value();
      any = any || lines[e][g] != 0.0;
    }
  }
  for (std::size_t i = stretch_.first; i < stretch_.last; ++i) {
    const Length s = project_->beam.segments[i].end();
    const BoxCell a = *box_cell_of(section_at(project_->beam, {s, Side::before}).outer);
    const BoxCell b = *box_cell_of(section_at(project_->beam, {s, Side::behind}).outer);
    const double jump = std::log((b.height / b.width).value() / (a.height / a.width).value());
    if (std::abs(jump) < 1e-12) continue;
    known[beam.nearest(s.value())] += 0.5 * jump * diagram.at({s, Side::before}).T.value();
    any = true;
  }
  if (!any) return std::nullopt;
  return effects_of(solver_.solve(known, lines));
}

DistortedStretch::Effects DistortedStretch::effects_of(const Distortion& of) const {
  Effects effects;
  effects.reserve(places_.size());
  for (const Place& place : places_) {
    const std::size_t node = place.element + place.end;
    effects.push_back({of.angle[node], of.moment[node], of.shear[place.element][place.end]});
  }
  return effects;
}

const DistortedStretch::Effects& DistortedStretch::of_node(std::size_t node) const {
  const auto found = of_node_.find(node);
  if (found != of_node_.end()) return found->second;
  std::vector<double> loads(solver_.beam().nodes.size(), 0.0);
  loads[node] = 1.0;
  return of_node_.emplace(node, effects_of(solver_.solve(loads))).first->second;
}

DistortionSize DistortedStretch::size_at(std::size_t place, const Loads& loads) const {
  DistortionSize size;
  for (const NodeLoad& at : loads.nodes) add_size(size, of_node(at.node)[place], std::abs(at.d));
  if (loads.lines) add_size(size, (*loads.lines)[place]);
  if (loads.tapers) add_size(size, (*loads.tapers)[place]);
  return size;
}

DistortionSize DistortedStretch::size_at(std::size_t place, std::size_t run,
                                         std::size_t instant) const {
  return size_at(place, loads_[run][instant]);
}

DistortionSize DistortedStretch::size_at(std::size_t place, const BeamLoads& beam_loads) const {
  return size_at(place, loads_of(cut_forces_of(beam_loads), torques_of(beam_loads), 0.0));
}

DistortedStretch::Torque DistortedStretch::most_at(std::size_t place, const TorquesIn& torques,
                                                   double of_moment, double of_angle) const {
  std::map<double, double> at_places;
  for (const TorqueIn& of : torques) at_places[of.s] += std::abs(of.torque);
  Torque found;
  double most = 0.0;
  for (const auto& [s, torque] : at_places) {
    double effect = 0.0;
    for (const NodeLoad& at : shared(s, torque, {})) {
      const DistortionSize& unit = of_node(at.node)[place];
      effect += at.d * (of_moment * std::abs(unit.moment) + of_angle * std::abs(unit.angle));
    }
    if (effect <= most) continue;
    most = effect;
    found = {si<Length>(s), si<Moment>(torque)};
  }
  return found;
}

}  // namespace boxbeam
