#include "patch_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "boxbeam/numerics/extremum.hpp"
#include "boxbeam/verification/torques_in.hpp"
#include "section_gate.hpp"

namespace boxbeam {

void PatchRun::look() {
  const LoadHistory& history = run_->loads;
  struct Highest {
    double use;
    std::size_t at;
    double lowest;
  };
  std::map<BorneKey, Highest> highest;
  std::vector<Length> before;
  if (pressed_ != nullptr) pressed_->begin(*run_);
  for (std::size_t i = 0; i < history.instants(); ++i) {
    const Time time = history.time_of(i);
    const BeamLoads loads = history.loads_at(time);
    std::optional<CutForceDiagram> of_record;
    const CutForceDiagram& diagram =
        history.is_recorded() ? of_record.emplace(history.diagram(i)) : history.kept_diagram(i);
    const std::vector<Patch> patches = search_->patches_of(loads, diagram);
    if (pressed_ != nullptr) pressed_->take(time, i > 0 && !history.begins_piece(i), patches);
    note_torque(loads);
    note_places(loads);
    for (const auto& [key, use] : look_at(time, patches, diagram)) {
      Highest& known = highest.try_emplace(key, Highest{use, i, use}).first->second;
      known.lowest = std::min(known.lowest, use);
      if (use > known.use) known = {use, i, known.lowest};
    }
    std::vector<Length> places = places_in(loads);
    if (i > 0 && !history.is_recorded() && !history.begins_piece(i))
      look_at_passages(history.time_of(i - 1), time, before, places);
    before = std::move(places);
  }
  if (pressed_ != nullptr) pressed_->end(history.period());
  // Of recorded loads the largest of what is convex in them stands at an instant.
  if (history.is_recorded()) return;
  // What does not change has its largest anywhere.
  constexpr double constant = 1e-9;
  for (const auto& [key, of] : highest)
    if (of.use - of.lowest > constant * of.use) refine(key, of.at);
}

std::map<BorneKey, double> PatchRun::look_at(Time time, const std::vector<Patch>& patches,
                                             const CutForceDiagram& diagram, const BorneKey* only) {
  std::map<BorneKey, double> uses;
  notes_->take_instant(diagram, *run_->situation, only == nullptr);
  for (const Patch& patch : patches) {
    if (only != nullptr && BorneKey{patch.key(), only->second} != *only) continue;
    note_on_path(patch);
    std::vector<Borne> ways = search_->worst_of(patch, patches, diagram);
    notes_->take(patch, ways, *run_->situation, only == nullptr);
    for (Borne& borne : ways) {
      const double load_factor = run_->situation->load_factor;
      const double use =
          project_->strength.required * load_factor / search_->factor_of(borne.basis);
      if (borne.part == Borne::Part::plate) holes_->take(patch, borne.basis, load_factor, use);
      const BorneKey key{patch.key(), borne.part};
      double& most = uses[key];
      most = std::max(most, use);
      WorstPatch& worst = (*worst_)[key];
      if (worst.run != nullptr && use <= worst.use) continue;
      borne.basis.load_factor = load_factor;
      worst = {patch, std::move(borne), run_, time, use};
    }
  }
  return uses;
}

void PatchRun::note_on_path(const Patch& patch) {
  if (patch.is_none()) return;
  const double load_factor = run_->situation->load_factor;
  const auto of = search_->unjudged_on_path(patch, project_->strength.required * load_factor);
  if (!of) return;
  const Force size = load_factor * abs(patch.force);
  PathForce& most = on_paths_->forces[{patch.name, of->open, of->blocks}];
  if (size > most.size) most = {patch.s, size, of->why, of->said};
}

Force PatchRun::along_y_at(const BeamLoads& loads, Length s) const {
  const Length near = 1e-6 * project_->beam.length();
  Force along_y;
  for (const PointLoad& load : loads.points)
    if (abs(load.s - s) <= near) along_y += si<Force>(load.force.y());
  return along_y;
}

void PatchRun::note_places(const BeamLoads& loads) {
  for (const double s : run_->motion->supports(loads)) {
    const Length at = si<Length>(s);
    if (search_->lacks_diaphragm(at)) notes_->take_bare_support(at, true);
    if (search_->lacks_diaphragm_along_y(at, along_y_at(loads, at)))
      notes_->take_bare_support(at, false);
  }
  for (const PointLoad& load : loads.points) {
    const auto moment = search_->unjudged_moment_of(load);
    if (!moment) continue;
    const std::string name = load.name.empty() ? "a couple" : std::string(load.name);
    const Moment size = run_->situation->load_factor * *moment;
    if (search_->is_at_end(load.s))
      notes_->take_led_on(name, load.s, size);
    else
      notes_->take_couple(name, load.s, size);
  }
}

void PatchRun::note_torque(const BeamLoads& loads) {
  const PatchSearch::PathTorque of = search_->torque_into_path(loads);
  if (of.torque.value() > least_torque(*run_) && of.torque > on_paths_->torque.torque)
    on_paths_->torque = of;
}

std::map<BorneKey, double> PatchRun::look_at(Time time, const BorneKey* only) {
  const Coming& coming = coming_at(time);
  note_torque(coming.loads);
  return look_at(time, coming.patches, coming.diagram, only);
}

const PatchRun::Coming& PatchRun::coming_at(Time time) {
  return coming_.of({time.value()}, [&] {
    Coming coming{run_->loads.loads_at(time), {}, {}};
    coming.diagram = cut_forces_of(coming.loads);
    coming.patches = search_->patches_of(coming.loads, coming.diagram);
    return coming;
  });
}

std::vector<Length> PatchRun::places_in(const BeamLoads& loads) {
  std::vector<Length> places;
  for (const PointLoad& load : loads.points) places.push_back(load.s);
  return places;
}

void PatchRun::look_at_passages(Time from, Time to, const std::vector<Length>& before,
                                const std::vector<Length>& behind) {
  if (before.size() != behind.size()) return;
  for (std::size_t k = 0; k < before.size(); ++k) {
    const auto [low, high] = std::minmax(before[k], behind[k]);
    if (low == high) continue;
    for (const Length& border : borders()) {
      // What stands on it is looked at beside it, too, as near as is another place.
      if (border == low || border == high) {
        const double beside =
            std::min(1e-2, (1e-4 * project_->beam.length() / (high - low)).value());
        if (border == before[k]) look_at(from + beside * (to - from));
        if (border == behind[k]) look_at(to - beside * (to - from));
      }
      if (!(border > low && border < high)) continue;
      Time lower = from, upper = to;
      constexpr int halvings = 40;
      for (int i = 0; i < halvings; ++i) {
        const Time middle = 0.5 * (lower + upper);
        const BeamLoads loads = run_->loads.loads_at(middle);
        if (loads.points.size() != before.size()) return;
        ((loads.points[k].s < border) == (before[k] < border) ? lower : upper) = middle;
      }
      // Beside the place itself, where a diaphragm takes the load.
      const Time aside = 1e-4 * (to - from);
      look_at(std::max(from, Time(lower - aside)));
      look_at(std::min(to, Time(upper + aside)));
    }
  }
}

std::vector<Length> PatchRun::borders() const {
  std::vector<Length> places;
  for (const Diaphragm& of : project_->beam.diaphragms) places.push_back(of.s);
  for (const Segment& of : project_->beam.segments) places.push_back(of.end());
  for (const LoadIntroduction& of : project_->beam.introductions) {
    places.push_back(of.from);
    places.push_back(of.to);
  }
  return places;
}

void PatchRun::refine(const BorneKey& key, std::size_t i) {
  const LoadHistory& history = run_->loads;
  const std::size_t last = history.instants() - 1;
  const Time at = history.time_of(i);
  const Time low = i > 0 && !history.begins_piece(i) ? history.time_of(i - 1) : at;
  const Time high = i < last && !history.begins_piece(i + 1) ? history.time_of(i + 1) : at;
  if (!(high > low)) return;
  constexpr int bits = 14;
  find_maximum(
      [&](double time) {
        const std::map<BorneKey, double> uses = look_at(si<Time>(time), &key);
        const auto found = uses.find(key);
        return found == uses.end() ? 0.0 : found->second;
      },
      low.value(), high.value(), bits);
}

namespace {

Gate gate_of_path(const Project& project, const std::string& name, bool open, bool blocks,
                  const PathForce& of) {
  const std::string what =
      fmt::format("at s = {} m \"{}\", {:.4g} kN, comes into walls of a path",
                  to_text(Station{of.s, Side::both}), name, 1e-3 * of.size.value());
  return section_gate_at(
      project, {of.s, Side::both},
      open ? what + ": what they bear of it is not judged (EN 1993-1-5, clause 6): " + of.why +
                 "; [[beam.diaphragms]] say what takes it"
           : what +
                 " where a diaphragm is taken to bear it, which is not judged (EN 1993-1-5, "
                 "9.4): " +
                 of.why,
      blocks);
}

}  // namespace

void OnPaths::add_to(PatchChecks& found, const Project& project) const {
  std::vector<Gate>& gates = found.gates;
  const std::pair<const std::tuple<std::string, bool, bool>, PathForce>* said = nullptr;
  for (const auto& named : forces) {
    const auto& [name, open, blocks] = named.first;
    if (blocks || !named.second.said)
      gates.push_back(gate_of_path(project, name, open, blocks, named.second));
    else if (said == nullptr || named.second.size > said->second.size)
      said = &named;
  }
  // Of those of the verdict line the largest one: it is to be read.
  if (said != nullptr) {
    const PathForce& force = said->second;
    found.not_judged.push_back(
        {Criterion::patch_loading,
         fmt::format("walls of a path at s = {} m", to_text(Station{force.s, Side::both})),
         fmt::format("how its diaphragm leads \"{}\", {:.4g} kN, into them is not checked{}: {}",
                     std::get<0>(said->first), 1e-3 * force.size.value(),
                     project.fatigue.asked ? ", nor in fatigue" : "", force.why)});
  }
  if (torque.torque > Moment{}) {
    const Station at{torque.s, Side::both};
    gates.push_back(section_gate_at(
        project, at,
        fmt::format("at s = {} m a torque of {:.4g} kN m comes into a path around "
                    "cells: how it distorts it is not judged; [[beam.diaphragms]] say "
                    "what keeps it in shape, or write it as kind = \"box\"",
                    to_text(at), 1e-3 * torque.torque.value())));
  }
}

}  // namespace boxbeam
