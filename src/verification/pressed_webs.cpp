#include "pressed_webs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/verification/turning_samples.hpp"

namespace boxbeam {
namespace {

/// Forces whose places are so near each other, by the beam's length, stand at one.
constexpr double at_one_place = 1e-6;

bool reaches(const PressedWeb& web, double s, double at) {
  return at >= s - web.before.value() && at <= s + web.behind.value();
}

}  // namespace

bool has_cycles(const Project& project, const Situation& situation) {
  const std::size_t index = index_of(project, situation);
  const auto has = [&](const Situation& of) {
    const auto& parts = of.between;
    return of.cycles > 0.0 &&
           (&of == &situation || std::find(parts.begin(), parts.end(), index) != parts.end());
  };
  return std::any_of(project.situations.begin(), project.situations.end(), has);
}

bool PressedWebs::counts(const Patch& patch) {
  return !patch.together && !patch.is_none() && !patch.may_come_beside_flanges() &&
         (patch.load || patch.kink != nullptr);
}

void PressedWebs::begin(const SituationRun& run) {
  Run& of = runs_.emplace_back();
  of.situation = index_of(*project_, *run.situation);
  of.counted = has_cycles(*project_, *run.situation);
  of.closed = run.loads.closed();
}

void PressedWebs::take(Time time, bool goes_on, const std::vector<Patch>& patches) {
  Instant& instant = runs_.back().instants.emplace_back();
  instant.time = time;
  instant.goes_on = goes_on;
  for (const Patch& patch : patches) {
    if (!counts(patch)) continue;
    if (patch.kink == nullptr) {
      add(patch, {}, instant);
      continue;
    }
    // By the one side in all instants, or by the other.
    for (const std::size_t side : {0U, 1U}) {
      Patch by = patch;
      by.force = patch.by_sides[side].force;
      by.couple = patch.by_sides[side].couple;
      constexpr double same = 1e-9;
      sides_differ_ = sides_differ_ || abs(by.force - patch.force) > same * abs(patch.force);
      if (!by.is_none()) add(by, side, instant);
    }
  }
  if (goes_on) {
    std::vector<Instant>& instants = runs_.back().instants;
    follow(instants[instants.size() - 2], instant);
  }
}

void PressedWebs::follow(Instant& instant, const Instant& next) const {
  const double near = at_one_place * project_->beam.length().value();
  for (std::size_t i = 0; i < instant.forces.size(); ++i) {
    Pressing& of = instant.forces[i];
    of.next.reset();
    // Mostly the same forces come in the same order.
    const bool same_order = i < next.forces.size() && next.forces[i].force == of.force;
    const auto same = same_order
                          ? next.forces.begin() + static_cast<std::ptrdiff_t>(i)
                          : std::find_if(next.forces.begin(), next.forces.end(),
                                         [&](const Pressing& at) { return at.force == of.force; });
    if (same != next.forces.end() && std::abs(same->s - of.s) > near)
      of.next = static_cast<std::size_t>(same - next.forces.begin());
  }
}

void PressedWebs::add(const Patch& patch, std::optional<std::size_t> side, Instant& instant) {
  // What a kink turns off stands still.
  const double place = std::round(patch.s.value() / at_one_place);
  const std::tuple key(patch.name, patch.along_z, patch.load ? 0.0 : place,
                       patch.load.value_or(side.value_or(0)));
  const auto [found, is_new] = numbers_.try_emplace(key, sources_.size());
  if (is_new) {
    sources_.emplace_back().name = patch.name;
    sources_.back().at_high = patch.at_high;
    sources_.back().side = side;
  }
  Source& source = sources_[found->second];
  Pressing pressing{found->second, patch.s.value(), search_->pressed_by(patch),
                    search_->welds_stressed_by(patch)};
  if (source.presses.empty()) source.from = source.to = pressing.s;
  source.from = std::min(source.from, pressing.s);
  source.to = std::max(source.to, pressing.s);
  const auto note = [&](const PressedWeb& web) {
    auto& [least, most] = source.presses[{web.plate, web.diaphragm}];
    least = std::min(least, web.stress.value());
    most = std::max(most, web.stress.value());
  };
  const auto reach = [&](const PressedWeb& web) {
    note(web);
    pressing.before = std::max(pressing.before, web.before.value());
    pressing.behind = std::max(pressing.behind, web.behind.value());
  };
  for (const PressedWeb& web : pressing.webs) reach(web);
  source.before = std::max(source.before, pressing.before);
  source.behind = std::max(source.behind, pressing.behind);
  for (const PressedWeb& weld : pressing.welds) reach(weld);
  instant.from = std::min(instant.from, pressing.s - pressing.before);
  instant.to = std::max(instant.to, pressing.s + pressing.behind);
  instant.forces.push_back(std::move(pressing));
}

void PressedWebs::end(Time period) {
  Run& of = runs_.back();
  if (!of.closed || of.instants.empty()) return;
  of.instants.push_back(of.instants.front());
  of.instants.back().time = period;
  of.instants.back().goes_on = true;
  follow(of.instants[of.instants.size() - 2], of.instants.back());
}

bool PressedWebs::acts(const Place& place, std::size_t force) const {
  const Source& source = sources_[force];
  const auto presses = source.presses.find({place.web, place.diaphragm});
  if (presses == source.presses.end()) return false;
  // What comes in by either flange goes by the same weld with the web.
  const bool by_either = place.diaphragm != nullptr && !place.to_flange;
  if (source.at_high && *source.at_high != place.at_high && !by_either) return false;
  if (source.side && *source.side != place.side) return false;
  if (place.sense == 0.0) return true;
  const auto& [least, most] = presses->second;
  return place.sense > 0.0 ? most > 0.0 : least < 0.0;
}

std::vector<bool> PressedWebs::acting_on(const Place& place) const {
  std::vector<bool> acting;
  for (std::size_t i = 0; i < sources_.size(); ++i) acting.push_back(acts(place, i));
  return acting;
}

double PressedWebs::stress_at(const Place& place, const std::vector<bool>& acting,
                              std::span<const Pressing> forces) {
  double stress = 0.0;
  for (const Pressing& of : forces) {
    if (!acting[of.force] || of.s - of.before > place.s || of.s + of.behind < place.s) continue;
    double own = 0.0;
    for (const PressedWeb& web : of.of(place.diaphragm))
      if (place.is_of(web) && reaches(web, of.s, place.s)) own += web.stress.value();
    stress += own;
  }
  return stress;
}

/// Between two instants the stress changes where a loaded length begins or ends to reach the place:
/// it is looked at just beside all of these.
void PressedWebs::add_passages(const Place& place, const std::vector<bool>& acting,
                               const Instant& before, const Instant& behind, Series& series) const {
  struct Moving {
    double from, to;  // [m]
    PressedWeb web;   // the one pressed more
  };
  std::vector<Moving> moving;
  std::vector<double> parts;
  const double near = at_one_place * project_->beam.length().value();
  for (const Pressing& of : before.forces) {
    if (!of.next || !acting[of.force]) continue;
    const Pressing* const same = &behind.forces[*of.next];
    // It does not come to reach the place.
    if (std::min(of.s, same->s) - std::max(of.before, same->before) > place.s + near ||
        std::max(of.s, same->s) + std::max(of.behind, same->behind) < place.s - near)
      continue;
    // The larger stress over all that it loads at either instant; where it comes in otherwise at
    // both, that of the nearer one. On a diaphragm it presses no web.
    const bool later = std::abs(same->s - place.s) < std::abs(of.s - place.s);
    std::optional<PressedWeb> most;
    for (const std::vector<PressedWeb>* const webs :
         {&(later ? *same : of).of(place.diaphragm), &(later ? of : *same).of(place.diaphragm)}) {
      for (const PressedWeb& web : *webs) {
        if (!place.is_of(web)) continue;
        if (!most) most = web;
        if (web.stiff_length != most->stiff_length) continue;
        if (abs(web.stress) > abs(most->stress)) most->stress = web.stress;
        most->before = std::max(most->before, web.before);
        most->behind = std::max(most->behind, web.behind);
      }
    }
    if (!most) continue;
    moving.push_back({of.s, same->s, *most});
    for (const double edge : {place.s + most->before.value(), place.s - most->behind.value()})
      parts.push_back((edge - of.s) / (same->s - of.s));
  }
  std::sort(parts.begin(), parts.end());
  constexpr double aside = 1e-9;
  for (const double edge : parts) {
    for (const double part : {edge - aside, edge + aside}) {
      if (!(part > 0.0 && part < 1.0)) continue;
      // What does not move is as before.
      double stress = 0.0;
      for (const Pressing& of : before.forces)
        if (!of.next) stress += stress_at(place, acting, {&of, 1});
      for (const Moving& of : moving) {
        if (reaches(of.web, of.from + part * (of.to - of.from), place.s))
          stress += of.web.stress.value();
      }
      series.times.push_back((before.time + part * (behind.time - before.time)).value());
      series.values.push_back(stress);
    }
  }
}

PressedWebs::Series PressedWebs::series_at(const Place& place, const Run& run) const {
  const std::vector<bool> acting = acting_on(place);
  const double near = at_one_place * project_->beam.length().value();
  Series series;
  series.times.reserve(run.instants.size());
  series.values.reserve(run.instants.size());
  for (std::size_t i = 0; i < run.instants.size(); ++i) {
    const Instant& instant = run.instants[i];
    // At most instants all is far from the place.
    if (instant.goes_on) {
      const Instant& before = run.instants[i - 1];
      if (place.s >= std::min(before.from, instant.from) - near &&
          place.s <= std::max(before.to, instant.to) + near)
        add_passages(place, acting, before, instant, series);
    }
    const bool far = place.s < instant.from || place.s > instant.to;
    series.times.push_back(instant.time.value());
    series.values.push_back(far ? 0.0 : stress_at(place, acting, instant.forces));
  }
  return series;
}

bool PressedWebs::presses_plates(const Source& of) {
  return std::any_of(of.presses.begin(), of.presses.end(),
                     [](const auto& pressed) { return pressed.first.second == nullptr; });
}

/// Where forces stand, and some along the ways of those that move, of all of a name together; where
/// the lengths overlap that forces load which stand apart, their ends.
std::vector<double> PressedWebs::places() const {
  constexpr int along = 60;
  const double near = at_one_place * project_->beam.length().value();
  std::vector<double> places;
  std::map<std::string, std::pair<double, double>> ways;
  // Where webs and seams become others, and what bears the forces: within the length that one
  // loads as well.
  std::vector<double> borders;
  for (const Segment& of : project_->beam.segments) borders.push_back(of.end().value());
  for (const Diaphragm& of : project_->beam.diaphragms) borders.push_back(of.s.value());
  for (const LoadIntroduction& of : project_->beam.introductions)
    borders.push_back(0.5 * (of.from + of.to).value());
  for (const Source& of : sources_) {
    if (!presses_plates(of)) continue;
    places.push_back(of.from);
    if (of.to - of.from <= near) {
      for (const double s : borders) {
        if (std::abs(s - of.from) <= 3.0 * near) continue;  // both its sides are looked at there
        for (const double at : {s - 2.0 * near, s, s + 2.0 * near})
          if (at > of.from - of.before && at < of.to + of.behind) places.push_back(at);
      }
      for (const Source& other : sources_) {
        const bool apart = std::abs(other.from - of.from) > near || other.to - other.from > near;
        if (!apart || !presses_plates(other) || other.from - other.before > of.to + of.behind ||
            other.to + other.behind < of.from - of.before)
          continue;
        const double length = project_->beam.length().value();
        for (const double end : {of.from - of.before + near, of.to + of.behind - near})
          if (end >= 0.0 && end <= length) places.push_back(end);
        break;
      }
      continue;
    }
    places.push_back(of.to);
    auto& [from, to] = ways.try_emplace(of.name, of.from, of.to).first->second;
    from = std::min(from, of.from);
    to = std::max(to, of.to);
  }
  for (const auto& [name, way] : ways) {
    for (int i = 1; i < along; ++i)
      places.push_back(way.first + static_cast<double>(i) / along * (way.second - way.first));
    for (const double s : borders) {
      for (const double at : {s - 2.0 * near, s, s + 2.0 * near})
        if (at > way.first && at < way.second) places.push_back(at);
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(
      std::unique(places.begin(), places.end(), [&](double a, double b) { return b - a <= near; }),
      places.end());
  return places;
}

template <class Look>
void PressedWebs::for_all_at(const Place& place, const Look& look) const {
  const std::vector<bool> acting = acting_on(place);
  for (const Run& run : runs_) {
    if (!run.counted) continue;
    for (const Instant& at : run.instants) {
      for (const Pressing& of : at.forces) {
        if (!acting[of.force]) continue;
        const Source& source = sources_[of.force];
        for (const PressedWeb& web : of.of(place.diaphragm)) {
          const bool there = place.s >= source.from - web.before.value() &&
                             place.s <= source.to + web.behind.value();
          if (place.is_of(web) && there) look(source, web);
        }
      }
    }
  }
}

bool PressedWebs::name(const Place& place, CheckResult& result) const {
  std::vector<std::string> names;
  const PressedWeb* most = nullptr;
  bool turned = true;
  const Source* last = nullptr;
  for_all_at(place, [&](const Source& source, const PressedWeb& web) {
    if (most == nullptr || abs(web.stress) > abs(most->stress)) most = &web;
    if (&source == last) return;
    last = &source;
    turned = turned && source.at_high.has_value();
    if (std::find(names.begin(), names.end(), source.name) == names.end())
      names.push_back(source.name);
  });
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

const Turns& PressedWebs::turns_at(const Place& place) const {
  const auto [known, is_new] = turns_.try_emplace(place);
  Turns& turns = known->second;
  if (!is_new) return turns;
  turns.resize(project_->situations.size());
  TurningSamples samples;
  for (const Run& run : runs_) {
    const Series series = series_at(place, run);
    SituationTurns& of = turns[run.situation];
    of.begin = series.values.front();
    of.end = run.closed ? of.begin : series.values.back();
    find_turning_samples(series.values, samples);
    const auto add = [&](std::size_t i, bool maximum) {
      of.turns.push_back({si<Time>(series.times[i]), series.values[i], maximum});
    };
    if (samples.turns.empty()) add(samples.highest, true);
    for (const auto& [i, maximum] : samples.turns) add(i, maximum);
  }
  return turns;
}

std::optional<CheckResult> PressedWebs::check_at(const Place& place, Turns turns,
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

template <class Take>
void PressedWebs::look(Place place, const std::vector<double>& places, bool any_unsaid,
                       std::vector<Used>& used, const Take& take) const {
  const std::vector<bool> acting = acting_on(place);
  if (std::find(acting.begin(), acting.end(), true) == acting.end()) return;
  const std::vector<bool> ways = any_unsaid ? std::vector{false, true} : std::vector{false};
  std::map<std::pair<bool, bool>, CheckResult> worst;
  for (const double s : places) {
    place.s = s;
    const Turns& turns = turns_at(place);
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
  for (auto& [key, of] : worst) {
    place.s = of.check.station.s.value();
    // A kink comes in on an edge whatever the case says of its loads, but where a diaphragm is.
    const bool turned = name(place, of) && place.diaphragm == nullptr;
    take(Found{std::move(of), key.first && !turned, key.second, turned});
  }
}

template <class Take>
void PressedWebs::look_at(BoxPlate web, const Diaphragm* diaphragm, bool any_unsaid,
                          const std::vector<double>& places, std::vector<Used>& used,
                          const Take& take) const {
  const bool any = std::any_of(sources_.begin(), sources_.end(), [&](const Source& of) {
    return of.presses.find({web, diaphragm}) != of.presses.end();
  });
  if (!any) return;
  const bool kinked = std::any_of(sources_.begin(), sources_.end(),
                                  [](const Source& of) { return of.at_high.has_value(); });
  // All of them together are one more only where some push and others pull.
  const auto has_own = [&](double sense) {
    return std::any_of(sources_.begin(), sources_.end(), [&](const Source& of) {
      return std::any_of(of.presses.begin(), of.presses.end(), [&](const auto& pressed) {
        const auto& [least, most] = pressed.second;
        return sense > 0.0 ? most > 0.0 && !(least < 0.0) : least < 0.0 && !(most > 0.0);
      });
    });
  };
  std::vector<double> senses{1.0, -1.0};
  if (has_own(1.0) && has_own(-1.0)) senses.push_back(0.0);
  const std::vector<std::size_t> sides =
      sides_differ_ ? std::vector<std::size_t>{0, 1} : std::vector<std::size_t>{0};
  const std::vector<bool> known_ends = kinked ? std::vector{true, false} : std::vector{true};
  for (const double sense : senses) {
    for (const bool at_high : known_ends) {
      for (const std::size_t side : sides)
        for (const bool to_flange :
             diaphragm != nullptr ? std::vector{false, true} : std::vector{false})
          look({web, 0.0, sense, at_high, side, diaphragm, to_flange}, places, any_unsaid, used,
               take);
    }
  }
}

std::optional<std::pair<Check, double>> PressedWebs::square_of(std::vector<Used> used) const {
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
  auto result = check_at(worst->place, turns_at(worst->place), false);
  name(worst->place, *result);
  return std::pair(result->check, most);
}

PressedWebs::Checks PressedWebs::checks() const {
  Checks all;
  std::vector<Found>& found = all.found;
  if (std::none_of(runs_.begin(), runs_.end(), [](const Run& of) { return of.counted; }))
    return all;
  std::vector<Used> used;
  const std::vector<double> at = places();
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
  for (const BoxPlate web : box_plates) {
    look_at(web, nullptr, unsaid, at, used, take);
    for (const Diaphragm& of : project_->beam.diaphragms)
      if (of.throat > Length{}) look_at(web, &of, false, {of.s.value()}, used, take);
  }
  all.square = square_of(std::move(used));
  return all;
}

}  // namespace boxbeam
