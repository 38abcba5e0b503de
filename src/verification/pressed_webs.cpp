#include "pressed_webs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "section_gate.hpp"

namespace boxbeam {

bool PressedWebs::name(const PressedPlace& place, CheckResult& result) const {
  const auto& [names, most, turned] = forces_.by(place);
  constexpr std::size_t few = 3;
  const std::string all = names.size() > few ? names.front() + " to " + names.back()
                                             : fmt::format("{}", fmt::join(names, " and "));
  Check& check = result.check;
  PressedBasis& basis = *result.pressed;
  const std::string web = project_->in_space || is_flange(place.web) ? to_text(place.web) : "web";
  if (place.diaphragm != nullptr) {
    basis.welds = most->weld.welds;
    basis.throat = most->weld.throat;
    basis.loaded = most->weld.length - 2.0 * basis.throat;
    basis.force =
        abs(most->stress) * static_cast<double>(basis.welds) * basis.throat * basis.loaded;
    check.point = fmt::format("{} under {}",
                              most->weld.to_flange ? "weld of flange and diaphragm beside " + web
                                                   : fmt::format("weld of {} and diaphragm", web),
                              all);
    check.id = id_of(check.criterion, check.station, check.point);
    return turned;
  }
  check.point = fmt::format("{}{} under {}", basis.throat > Length{} ? "seam of " : "", web, all);
  check.id = id_of(check.criterion, check.station, check.point);
  basis.loaded = most->before + most->behind;
  basis.force = abs(most->stress) * basis.thickness * basis.loaded;
  return turned;
}

std::optional<CheckResult> PressedWebs::check_at(const PressedPlace& place, Turns turns,
                                                 bool unsaid_as_fillets) const {
  const PressedEdge edge{place.s, place.web, unsaid_as_fillets};
  const PressedEdges::Resisting& resisting =
      place.diaphragm != nullptr ? PressedEdges::weld() : edges_.at(edge);
  const double factor = resisting.detail->stress_factor;
  for (SituationTurns& of : turns) {
    of.begin *= factor;
    of.end *= factor;
    for (TurningPoint& turn : of.turns) turn.value *= factor;
  }
  LifeChannel channel{{}, curve_of(resisting.detail->detail)};
  double largest = 0.0;
  for (const SituationCycles& of : life_cycles_of(*project_, turns, false)) {
    for (SpectrumRow& row :
         rows_of(project_->situations[of.situation].name, StressKind::direct, of.cycles)) {
      largest = std::max(largest, row.cycle.range.value());
      channel.spectrum.push_back(std::move(row));
    }
  }
  if (largest < PressedEdges::no_stress) return std::nullopt;
  std::vector<LifeChannel> channels{std::move(channel)};
  ChannelLife life = life_of(*project_, channels);
  std::vector<LifeChannel> both{channels.front(), {}};
  static const std::vector<LifeChannel> none;
  const bool sheared = place.diaphragm == nullptr && edges_.shear_may_count(edge, life.factor);
  for (const LifeChannel& shear : sheared ? edges_.shear_at(edge) : none) {
    both.back() = shear;
    if (ChannelLife of = life_of(*project_, both); of.factor < life.factor) {
      life = of;
      channels = both;
    }
  }
  const auto [highest, lowest] = extremes_in(*project_, life.governing, turns);
  const Extreme& larger = std::abs(highest.value) >= std::abs(lowest.value) ? highest : lowest;
  CheckResult result;
  Check& check = result.check;
  check.criterion = Criterion::patch_fatigue;
  check.station = {si<Length>(place.s), Side::both};
  check.situation = project_->situations[life.governing].name;
  check.time = larger.time;
  PressedBasis& basis = result.pressed.emplace();
  basis.thickness = resisting.thickness;
  basis.throat = resisting.throat;
  basis.life.point.in_plate = resisting.detail;
  basis.life.point.detail = resisting.detail.get();
  basis.life.stress_factor = factor;
  basis.life.highest = highest;
  basis.life.lowest = lowest;
  take_life(*project_, channels, life, check, basis.life);
  const Stress range = si<Stress>(highest.value - lowest.value);
  check.acting = range;
  check.resisting = Stress(check.safety_factor * range);
  return result;
}

std::vector<PressedWebs::Found> PressedWebs::worst_of(PressedPlace place,
                                                      const std::vector<double>& places,
                                                      bool any_unsaid,
                                                      std::vector<Used>& used) const {
  const std::vector<bool> ways = any_unsaid ? std::vector{false, true} : std::vector{false};
  std::map<std::pair<bool, bool>, CheckResult> worst;
  for (const double s : places) {
    place.s = s;
    const Turns& turns = forces_.turns_at(place);
    const auto presses = [](const TurningPoint& turn) { return turn.value != 0.0; };
    const auto pressed = [&](const SituationTurns& of) {
      return std::any_of(of.turns.begin(), of.turns.end(), presses);
    };
    if (std::none_of(turns.begin(), turns.end(), pressed)) continue;
    for (const bool as_fillets : ways) {
      auto at = check_at(place, turns, as_fillets);
      if (!at) continue;
      if (!as_fillets) used.push_back({place, at->check.utilisation()});
      const bool given = place.diaphragm != nullptr || search_->is_given_at(si<Length>(s));
      const auto key = std::pair(given, as_fillets);
      const auto known = worst.find(key);
      if (known == worst.end())
        worst.emplace(key, *std::move(at));
      else if (at->check.utilisation() > known->second.check.utilisation())
        known->second = *std::move(at);
    }
  }
  std::vector<Found> found;
  for (auto& [key, of] : worst) {
    place.s = of.check.station.s.value();
    // A kink comes in on an edge whatever the case says of its loads, but where a diaphragm is.
    const bool turned = name(place, of) && place.diaphragm == nullptr;
    found.push_back({std::move(of), key.first && !turned, key.second, turned});
  }
  return found;
}

std::optional<Gate> PressedWebs::square_of(std::vector<Used> used) const {
  const double near = 1e-3 * project_->beam.length().value();
  std::sort(used.begin(), used.end(),
            [](const Used& a, const Used& b) { return a.place.s < b.place.s; });
  const Used* worst = nullptr;
  double most = 1.0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    for (std::size_t j = i + 1; j < used.size() && used[j].place.s - used[i].place.s <= near; ++j) {
      const Used &one = used[i], &other = used[j];
      const double use = std::hypot(one.use, other.use);
      if (is_flange(one.place.web) == is_flange(other.place.web) || !(use > most)) continue;
      most = use;
      worst = one.use > other.use ? &one : &other;
    }
  }
  if (worst == nullptr) return std::nullopt;
  auto result = check_at(worst->place, forces_.turns_at(worst->place), false);
  name(worst->place, *result);
  const Check& check = result->check;
  return section_gate_at(
      *project_, check.station,
      fmt::format("{} at s = {} m: with what presses there square to it at every cycle used by up "
                  "to {:.3g} in fatigue, which is not judged together",
                  check.point, to_text(check.station), most));
}

std::vector<PressedWebs::Found> PressedWebs::checks(std::vector<Used>& used) const {
  std::vector<Found> found;
  if (!forces_.have_cycles()) return found;
  const auto take = [&](Found more) {
    // Forces that push to and fro are of both senses.
    const auto same = std::find_if(found.begin(), found.end(), [&](const Found& of) {
      return of.given == more.given && of.unsaid == more.unsaid &&
             of.result.check.id == more.result.check.id;
    });
    if (same == found.end())
      found.push_back(std::move(more));
    else if (more.result.check.utilisation() > same->result.check.utilisation())
      *same = std::move(more);
  };
  const auto unsaid_in = [](const Section& of) {
    const auto* const box = std::get_if<Box>(&of.outer);
    return box != nullptr && !(box->seam_throat > Length{});
  };
  const std::vector<Segment>& segments = project_->beam.segments;
  const bool unsaid = std::any_of(segments.begin(), segments.end(), [&](const Segment& of) {
    return unsaid_in(of.from) || unsaid_in(of.to);
  });
  const auto look_at = [&](BoxPlate web, const Diaphragm* diaphragm,
                           const std::vector<double>& places, bool any_unsaid) {
    for (const PressedPlace& place : forces_.senses_of(web, diaphragm))
      for (Found& of : worst_of(place, places, any_unsaid, used)) take(std::move(of));
  };
  const std::vector<double> at = forces_.places();
  for (const BoxPlate web : box_plates) {
    look_at(web, nullptr, at, unsaid);
    for (const Diaphragm& of : project_->beam.diaphragms)
      if (of.throat > Length{}) look_at(web, &of, {of.s.value()}, false);
  }
  return found;
}

Gate PressedWebs::gate_of(const Found& of) const {
  const Check& check = of.result.check;
  return section_gate_at(
      *project_, check.station,
      fmt::format("{} at s = {} m is used by {:.3g} in fatigue (stiff length 0): "
                  "[[beam.diaphragms]] take it{}",
                  check.point, to_text(check.station), check.utilisation(),
                  of.turned ? "" : ", or [[beam.load_introductions]] say how it comes in"));
}

void PressedWebs::add_to(PatchChecks& found) const {
  std::optional<Check> as_fillets;
  std::optional<Found> turned;  ///< of kinks that fail the worst: all ask for the same
  std::vector<Used> used;
  for (Found& of : checks(used)) {
    if (of.unsaid) {
      const double use = of.result.check.utilisation();
      if (use > 1.0 && (!as_fillets || use > as_fillets->utilisation()))
        as_fillets = of.result.check;
      continue;
    }
    if (of.turned && !of.result.check.passes()) {
      const double use = of.result.check.utilisation();
      if (!turned || use > turned->result.check.utilisation()) turned = std::move(of);
      continue;
    }
    if (!of.given && !of.result.check.passes())
      found.gates.push_back(gate_of(of));
    else
      found.checks.push_back(std::move(of.result));
  }
  if (turned) found.gates.push_back(gate_of(*turned));
  if (auto square = square_of(std::move(used))) found.gates.push_back(*std::move(square));
  if (as_fillets)
    found.not_judged.push_back(
        {Criterion::patch_fatigue, "seams of webs",
         fmt::format(
             "taken to penetrate fully, for seam_throat is not said; as fillets, a = t, used "
             "by {:.3g} in fatigue at s = {} m",
             as_fillets->utilisation(), to_text(as_fillets->station))});
}

}  // namespace boxbeam
