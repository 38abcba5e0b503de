// Thicker plates, and diaphragms between them.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/project/case_lists.hpp"
#include "plate_panels.hpp"
#include "remedy_search.hpp"

namespace boxbeam {
namespace {

/// Thicker plates are looked for up to so many times the thickness.
constexpr double most_thickness = 4.0;

/// How many of the first candidates are possible, where none is behind one that is not.
std::size_t count_of_first(std::size_t count, const std::function<bool(std::size_t)>& possible) {
  std::size_t low = 0;
  while (low < count) {
    const std::size_t middle = low + (count - low) / 2;
    if (possible(middle))
      low = middle + 1;
    else
      count = middle;
  }
  return low;
}

/// Upwards in growing steps until one passes, then between it and the one before: a plate that is
/// far too thick need not pass, for its weight.
std::optional<Passing> least_thickness(std::size_t count,
                                       const std::function<Outcome(std::size_t)>& outcome) {
  constexpr double growth = 1.8;
  std::size_t failing = 0;  // candidates below it do not pass
  for (double step = 2.0; failing < count; step *= growth) {
    const std::size_t upper = std::min(count, failing + static_cast<std::size_t>(step));
    const auto passing =
        first_passing(upper - failing, [&](std::size_t i) { return outcome(failing + i); });
    if (passing) return Passing{failing + passing->candidate, passing->utilisation};
    failing = upper;
  }
  return std::nullopt;
}

/// Plates of a group by one factor: the thickest in whole millimetres, the others up to them.
class ThickerPlates {
 public:
  explicit ThickerPlates(std::vector<PlateKey> keys) : keys_(std::move(keys)) {
    for (const PlateKey& key : keys_) now_ = std::max(now_, key.thickness.value() / mm);
    first_ = static_cast<int>(std::floor(now_ * (1.0 + 1e-9))) + 1;
  }

  std::size_t count() const {
    const int most = static_cast<int>(std::floor(most_thickness * now_));
    return static_cast<std::size_t>(std::max(0, most - first_ + 1));
  }

  /// The thickest of a candidate [mm].
  int thickest(std::size_t i) const { return first_ + static_cast<int>(i); }

  std::vector<int> thicknesses(std::size_t i) const {
    const double factor = (first_ + static_cast<double>(i)) / now_;
    std::vector<int> of;
    for (const PlateKey& key : keys_)
      of.push_back(static_cast<int>(std::ceil(factor * key.thickness.value() / mm - 1e-6)));
    return of;
  }

  std::vector<std::string> set(std::size_t i) const {
    const std::vector<int> of = thicknesses(i);
    std::vector<std::string> set;
    for (std::size_t k = 0; k < keys_.size(); ++k)
      set.push_back(fmt::format("{}={} mm", keys_[k].key, of[k]));
    return set;
  }

  static constexpr double mm = 1e-3;

 private:
  std::vector<PlateKey> keys_;
  double now_ = 0.0;  ///< [mm]
  int first_ = 1;
};

/// Diaphragms that divide a stretch of the beam into equal panels, beside those that are there.
struct Division {
  Length from, to;
  std::size_t panels = 1;

  Length apart() const { return (to - from) / static_cast<double>(panels); }
};

/// What a division adds to the case.
struct AddedDiaphragms {
  std::vector<Length> places;
  std::vector<std::string> set;
};

bool stands_at(const TaperedBeam& beam, Length s) {
  const Length near = 1e-6 * beam.length();
  return std::any_of(beam.diaphragms.begin(), beam.diaphragms.end(),
                     [&](const Diaphragm& of) { return abs(of.s - s) <= near; });
}

/// Where the force comes in that governs, or the torque that does most of it.
std::optional<Length> place_that_governs(const CheckResult& governing) {
  if (governing.patch) return governing.check.station.s;
  if (governing.distortion) return governing.distortion->introduced;
  return std::nullopt;
}

/// As thick as those that are there, else as the plates.
Length diaphragm_thickness(const RemedySearch& search) {
  Length thickness;
  for (const Diaphragm& of : search.project.beam.diaphragms)
    thickness = std::max(thickness, of.thickness);
  if (thickness > Length{}) return thickness;
  for (const Length& plate : thicknesses_of(search.project.beam.segments[search.segment()].from))
    thickness = std::max(thickness, plate);
  return thickness;
}

AddedDiaphragms diaphragms_of(const RemedySearch& search, const Division& division,
                              Length thickness) {
  const TaperedBeam& beam = search.project.beam;
  AddedDiaphragms added;
  const auto add = [&](Length s) {
    const auto near = [&](Length other) { return abs(other - s) <= 1e-6 * beam.length(); };
    if (stands_at(beam, s) || std::any_of(added.places.begin(), added.places.end(), near)) return;
    added.places.push_back(s);
  };
  for (std::size_t i = 0; i <= division.panels; ++i)
    add(place_near(places_of(beam), division.from + static_cast<double>(i) * division.apart()));
  // One takes the force, or the torque, that governs.
  if (const auto s = place_that_governs(search.governing)) add(*s);
  std::sort(added.places.begin(), added.places.end());

  std::vector<std::string> tables;
  for (const Length& s : added.places) {
    tables.push_back(fmt::format("{{station = \"{:.12g} m\", thickness = \"{:.6g} mm\"}}",
                                 s.value(), 1e3 * thickness.value()));
  }
  added.set = added_to(search.project, diaphragms_key_of(search.project), tables);
  return added;
}

/// "a 10 mm diaphragm at 2 m", "10 mm diaphragms every 1.5 m from 3 m to 9 m".
std::string name_of(const TaperedBeam& beam, const Division& division, const AddedDiaphragms& added,
                    Length thickness, const std::optional<Length>& governing) {
  constexpr std::size_t few = 3;
  const bool one = added.places.size() == 1;
  std::string name = fmt::format("{}{:.6g} mm diaphragm{} ", one ? "a " : "",
                                 1e3 * thickness.value(), one ? "" : "s");
  if (added.places.size() <= few) {
    std::vector<std::string> at;
    for (const Length& s : added.places) at.push_back(fmt::format("{:.4g} m", s.value() + 0.0));
    return name + fmt::format("at {}", fmt::join(at, " and "));
  }
  name += fmt::format("every {:.4g} m", division.apart().value());
  if (division.from > Length{} || division.to < beam.length())
    name +=
        fmt::format(" from {:.4g} m to {:.4g} m", division.from.value() + 0.0, division.to.value());
  if (governing) {
    const double panels = ((*governing - division.from) / division.apart()).value();
    if (std::abs(panels - std::round(panels)) > 1e-6)
      name += fmt::format(" and at {:.4g} m", governing->value());
  }
  return name;
}

/// From few to many, no closer than half the depth of the beam; whether some do.
bool divide(RemedySearch& search, Length from, Length to) {
  constexpr std::size_t most_panels = 200;
  const Length thickness = diaphragm_thickness(search);
  const auto closest =
      static_cast<std::size_t>(2.0 * ((to - from) / height_of(search.profile())).value());
  const auto outcome = [&](std::size_t i) -> Outcome {
    const AddedDiaphragms added = diaphragms_of(search, {from, to, i + 1}, thickness);
    if (added.set.empty()) return std::nullopt;
    const auto changed = search.changed_by(added.set);
    return changed ? search.judged(*changed) : std::nullopt;
  };
  // More are not always better: what keeps a box in shape between two may stretch its edges more.
  constexpr std::size_t few = 6;
  const std::size_t count = std::clamp<std::size_t>(closest, 1, most_panels);
  std::optional<Passing> passing;
  for (std::size_t i = 0; i < std::min(few, count) && !passing; ++i)
    if (const Outcome at = outcome(i)) passing = Passing{i, *at};
  if (!passing) passing = first_passing(count, outcome);
  if (!passing) return false;
  const Division division{from, to, passing->candidate + 1};
  AddedDiaphragms added = diaphragms_of(search, division, thickness);
  search.remedies.found.push_back({Remedy::What::diaphragms,
                                   name_of(search.project.beam, division, added, thickness,
                                           place_that_governs(search.governing)),
                                   division.apart().value(), passing->utilisation,
                                   std::move(added.set)});
  return true;
}

}  // namespace

void look_at_diaphragms(RemedySearch& search) {
  const TaperedBeam& beam = search.project.beam;
  const Supports around = supports_around(beam, search.governing.check.station);
  const Length from = around.before.value_or(Length{});
  const Length to = around.behind.value_or(beam.length());
  if (divide(search, from, to)) return;
  const bool whole = from == Length{} && to == beam.length();
  if (!whole && divide(search, Length{}, beam.length())) return;
  search.remedies.in_vain.push_back(
      fmt::format("{:.6g} mm diaphragms at half the depth of the beam",
                  1e3 * diaphragm_thickness(search).value()));
}

void look_at_diaphragm(RemedySearch& search) {
  const Length s = search.governing.check.station.s;
  const std::vector<Diaphragm>& diaphragms = search.project.beam.diaphragms;
  const auto is_there = [&](const Diaphragm& of) { return of.s == s; };
  const auto there = std::find_if(diaphragms.begin(), diaphragms.end(), is_there);
  if (there == diaphragms.end()) return;
  const ThickerPlates plates({{"", there->thickness}});
  const auto set = [&](std::size_t number, std::size_t i) {
    return fmt::format("{}.{}.thickness={} mm", diaphragms_key_of(search.project), number,
                       plates.thickest(i));
  };
  // The case has them in an order of its own.
  std::size_t number = 0;
  for (; number < diaphragms.size(); ++number) {
    const auto changed = search.changed_by({set(number, 0)});
    if (!changed) continue;
    const auto& of = changed->beam.diaphragms;
    const auto same = std::find_if(of.begin(), of.end(), is_there);
    if (same != of.end() && same->thickness != there->thickness) break;
  }
  const auto passing = first_passing(plates.count(), [&](std::size_t i) -> Outcome {
    const auto changed = search.changed_by({set(number, i)});
    return changed ? search.judged(*changed) : std::nullopt;
  });
  if (!passing) {
    search.remedies.in_vain.push_back(
        fmt::format("a diaphragm of up to {} mm", plates.thickest(plates.count()) - 1));
    return;
  }
  const int thickness = plates.thickest(passing->candidate);
  search.remedies.found.push_back(
      {Remedy::What::diaphragm,
       fmt::format("a {} mm diaphragm at {:.4g} m", thickness, s.value() + 0.0),
       thickness * ThickerPlates::mm,
       passing->utilisation,
       {set(number, passing->candidate)}});
}

void look_at_plates(RemedySearch& search, PlateGroup group) {
  const bool box = group != PlateGroup::walls;
  const bool flanges = group == PlateGroup::flanges;
  const std::string word = flanges ? "flanges" : box ? "webs" : "walls";
  Remedies& remedies = search.remedies;
  if (search.is_elastic()) {
    remedies.not_searched.push_back(fmt::format("thicker {} (the model is elastic)", word));
    return;
  }
  std::vector<PlateKey> keys = plate_keys_of(search.project, search.segment(), group);
  if (keys.empty()) {
    remedies.not_searched.push_back(
        fmt::format("thicker {} (no key of the case says how thick they are)", word));
    return;
  }
  const ThickerPlates plates(std::move(keys));
  const std::size_t count = count_of_first(
      plates.count(), [&](std::size_t i) { return search.changed_by(plates.set(i)).has_value(); });
  const auto passing = least_thickness(count, [&](std::size_t i) -> Outcome {
    const auto changed = search.changed_by(plates.set(i));
    return changed ? RemedySearch::verified(*changed) : std::nullopt;
  });
  if (!passing) {
    const int last = plates.thickest(count) - 1;
    remedies.in_vain.push_back(
        count == 0 ? fmt::format("thicker {}, for which there is no room,", word)
        : count < plates.count()
            ? fmt::format("{} up to {} mm, the most for which there is room,", word, last)
            : fmt::format("{} up to {} mm", word, last));
    return;
  }
  std::vector<int> of = plates.thicknesses(passing->candidate);
  std::sort(of.begin(), of.end());
  of.erase(std::unique(of.begin(), of.end()), of.end());
  remedies.found.push_back({flanges ? Remedy::What::flanges
                            : box   ? Remedy::What::webs
                                    : Remedy::What::walls,
                            fmt::format("{} mm {}", fmt::join(of, " and "), word),
                            of.back() * ThickerPlates::mm, passing->utilisation,
                            plates.set(passing->candidate)});
}

}  // namespace boxbeam
