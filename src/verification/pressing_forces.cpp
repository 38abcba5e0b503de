#include "pressing_forces.hpp"

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

bool PressingForces::counts(const Patch& patch) {
  return !patch.together && !patch.is_none() && !patch.may_come_beside_flanges() &&
         (patch.load || patch.kink != nullptr);
}

void PressingForces::begin(const SituationRun& run) {
  Run& of = runs_.emplace_back();
  of.situation = index_of(*project_, *run.situation);
  of.counted = has_cycles(*project_, *run.situation);
  of.closed = run.loads.closed();
  of.instants.reserve(run.loads.instants() + 1);
}

void PressingForces::take(Time time, bool goes_on, const std::vector<Patch>& patches) {
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
    Patch by = patch;
    for (const std::size_t side : {0U, 1U}) {
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

void PressingForces::follow(Instant& instant, const Instant& next) const {
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

void PressingForces::add(const Patch& patch, std::optional<std::size_t> side, Instant& instant) {
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

void PressingForces::end(Time period) {
  Run& of = runs_.back();
  if (!of.closed || of.instants.empty()) return;
  of.instants.push_back(of.instants.front());
  of.instants.back().time = period;
  of.instants.back().goes_on = true;
  follow(of.instants[of.instants.size() - 2], of.instants.back());
}

bool PressingForces::acts(const PressedPlace& place, std::size_t force) const {
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

std::vector<bool> PressingForces::acting_on(const PressedPlace& place) const {
  std::vector<bool> acting;
  for (std::size_t i = 0; i < sources_.size(); ++i) acting.push_back(acts(place, i));
  return acting;
}

double PressingForces::stress_at(const PressedPlace& place, const std::vector<bool>& acting,
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
void PressingForces::add_passages(const PressedPlace& place, const std::vector<bool>& acting,
                                  const Instant& before, const Instant& behind,
                                  Series& series) const {
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

PressingForces::Series PressingForces::series_at(const PressedPlace& place, const Run& run) const {
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

bool PressingForces::presses_plates(const Source& of) {
  return std::any_of(of.presses.begin(), of.presses.end(),
                     [](const auto& pressed) { return pressed.first.second == nullptr; });
}

std::vector<double> PressingForces::places() const {
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

std::vector<PressedPlace> PressingForces::senses_of(BoxPlate web,
                                                    const Diaphragm* diaphragm) const {
  std::vector<PressedPlace> all;
  const bool any = std::any_of(sources_.begin(), sources_.end(), [&](const Source& of) {
    return of.presses.find({web, diaphragm}) != of.presses.end();
  });
  if (!any) return all;
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
  const std::size_t sides = sides_differ_ ? 2 : 1;
  const std::vector<bool> known_ends = kinked ? std::vector{true, false} : std::vector{true};
  const std::vector<bool> welds = diaphragm ? std::vector{false, true} : std::vector{false};
  for (const double sense : senses) {
    for (const bool at_high : known_ends) {
      for (std::size_t side = 0; side < sides; ++side) {
        for (const bool to_flange : welds) {
          const PressedPlace of{web, 0.0, sense, at_high, side, diaphragm, to_flange};
          const std::vector<bool> acting = acting_on(of);
          if (std::find(acting.begin(), acting.end(), true) != acting.end()) all.push_back(of);
        }
      }
    }
  }
  return all;
}

bool PressingForces::have_cycles() const {
  return std::any_of(runs_.begin(), runs_.end(), [](const Run& of) { return of.counted; });
}

PressingForces::By PressingForces::by(const PressedPlace& place) const {
  By found;
  const std::vector<bool> acting = acting_on(place);
  for (const Run& run : runs_) {
    if (!run.counted) continue;
    for (const Instant& at : run.instants) {
      for (const Pressing& of : at.forces) {
        if (!acting[of.force]) continue;
        const Source& source = sources_[of.force];
        for (const PressedWeb& web : of.of(place.diaphragm)) {
          if (!place.is_of(web) || place.s < source.from - web.before.value() ||
              place.s > source.to + web.behind.value())
            continue;
          if (found.most == nullptr || abs(web.stress) > abs(found.most->stress)) found.most = &web;
          found.turned = found.turned && source.at_high.has_value();
          if (std::find(found.names.begin(), found.names.end(), source.name) == found.names.end())
            found.names.push_back(source.name);
        }
      }
    }
  }
  return found;
}

const Turns& PressingForces::turns_at(const PressedPlace& place) const {
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

}  // namespace boxbeam
