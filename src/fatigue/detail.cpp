#include "boxbeam/fatigue/detail.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace boxbeam {
namespace {

using Words = std::vector<std::string>;

bool contains(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool excluded(const DetailRow& row, const Facts& facts) {
  return std::any_of(row.conditions.begin(), row.conditions.end(), [&](const auto& condition) {
    const auto fact = facts.find(condition.first);
    return fact != facts.end() && !allows(condition.second, fact->second);
  });
}

/// Along the range of the fact by which a row's category grows, where it is known.
void interpolate(DetailRow& row, const Facts& facts) {
  if (!row.interpolation) return;
  const auto& [fact, from, to] = *row.interpolation;
  const auto known = facts.find(fact);
  if (known == facts.end()) return;
  const auto& range = std::get<FactRange>(row.conditions.at(fact));
  const double along = (std::get<double>(known->second) - range.from) / (range.to - range.from);
  row.category = from + (to - from) * std::clamp(along, 0.0, 1.0);
}

/// With the size effect where it is known.
double strength_of(const DetailRow& row, const Facts& facts) {
  return row.category * size_factor_of(row, facts).value_or(1.0);
}

/// The weakest first. Of equal ones that with a size effect, then the unconfirmed one comes first.
std::vector<DetailRow> candidates_of(const std::vector<DetailRow>& rows, StressKind kind,
                                     const Facts& facts) {
  std::vector<DetailRow> left;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(left),
               [&](const DetailRow& row) { return row.kind == kind && !excluded(row, facts); });
  for (DetailRow& row : left) interpolate(row, facts);
  const auto key = [&](const DetailRow& row) {
    return std::tuple(strength_of(row, facts), row.size_effect == SizeEffect::none,
                      !row.unconfirmed);
  };
  std::stable_sort(left.begin(), left.end(),
                   [&](const DetailRow& a, const DetailRow& b) { return key(a) < key(b); });
  return left;
}

/// Whether some value is in `a` but not in `b`.
bool reaches_beyond(const Allowed& a, const Allowed& b) {
  if (const auto* words = std::get_if<Words>(&a)) {
    return std::any_of(words->begin(), words->end(), [&](const std::string& word) {
      return !contains(std::get<Words>(b), word);
    });
  }
  const auto& range = std::get<FactRange>(a);
  const auto& other = std::get<FactRange>(b);
  const bool below =
      range.from < other.from || (range.from == other.from && range.with_from && !other.with_from);
  const bool above =
      range.to > other.to || (range.to == other.to && range.with_to && !other.with_to);
  return below || above;
}

/// Facts not known of which some value excludes a governing row and leaves a stronger one.
std::vector<std::string> deciding_of(const std::vector<DetailRow>& candidates, const Facts& facts) {
  const double least = strength_of(candidates.front(), facts);
  const auto governs = [&](const DetailRow& row) { return strength_of(row, facts) <= least; };
  const auto decides = [&](const std::string& fact, const Allowed& allowed) {
    return std::any_of(candidates.begin(), candidates.end(), [&](const DetailRow& other) {
      if (governs(other)) return false;
      const auto own = other.conditions.find(fact);
      return own == other.conditions.end() || reaches_beyond(own->second, allowed);
    });
  };
  std::vector<std::string> deciding;
  for (const DetailRow& row : candidates) {
    if (!governs(row)) continue;
    for (const auto& [fact, allowed] : row.conditions) {
      if (facts.contains(fact) || contains(deciding, fact)) continue;
      if (decides(fact, allowed)) deciding.push_back(fact);
    }
  }
  return deciding;
}

/// A value that is allowed, well inside a range.
FactValue value_in(const Allowed& allowed) {
  if (const auto* words = std::get_if<Words>(&allowed)) return words->front();
  const auto& range = std::get<FactRange>(allowed);
  if (std::isinf(range.to)) return std::isinf(range.from) ? 0.0 : 2.0 * range.from;
  return std::isinf(range.from) ? 0.5 * range.to : 0.5 * (range.from + range.to);
}

/// Whether every candidate says of a fact what a row allows, so that it need not be known.
bool agree_on(const std::vector<DetailRow>& candidates, const std::string& fact,
              const Allowed& allowed) {
  return std::all_of(candidates.begin(), candidates.end(), [&](const DetailRow& candidate) {
    const auto own = candidate.conditions.find(fact);
    return own != candidate.conditions.end() && !reaches_beyond(own->second, allowed);
  });
}

/// What a row asks beyond the facts; nothing where it asks for a change of a fixed one.
std::optional<std::vector<FactChange>> changes_to(const DetailRow& row,
                                                  const std::vector<DetailRow>& candidates,
                                                  const Facts& facts, const Words& fixed) {
  std::vector<FactChange> changes;
  for (const auto& [fact, allowed] : row.conditions) {
    const auto known = facts.find(fact);
    if (known != facts.end() ? allows(allowed, known->second)
                             : agree_on(candidates, fact, allowed)) {
      continue;
    }
    if (contains(fixed, fact)) return std::nullopt;
    changes.push_back({fact, allowed});
  }
  return changes;
}

/// Whether every change of `some` is one of `all`.
bool part_of(const std::vector<FactChange>& some, const std::vector<FactChange>& all) {
  return std::all_of(some.begin(), some.end(), [&](const FactChange& change) {
    return std::find(all.begin(), all.end(), change) != all.end();
  });
}

}  // namespace

bool allows(const Allowed& allowed, const FactValue& value) {
  if (const auto* words = std::get_if<Words>(&allowed)) {
    return contains(*words, std::get<std::string>(value));
  }
  const auto& range = std::get<FactRange>(allowed);
  const double number = std::get<double>(value);
  // A length typed in millimetres may stand a bit of round-off beside the limit that it names.
  const double slack = 1e-12 * std::abs(number);
  const bool at_from = std::abs(number - range.from) <= slack;
  const bool at_to = std::abs(number - range.to) <= slack;
  if ((at_from && !range.with_from) || (at_to && !range.with_to)) return false;
  return (number >= range.from || at_from) && (number <= range.to || at_to);
}

std::string category_name_of(const DetailRow& row) {
  return fmt::format("{:.4g}{}", row.category, row.asterisk ? "*" : "");
}

std::optional<double> size_factor_of(const DetailRow& row, const Facts& facts) {
  const auto length = [&](const char* fact) -> std::optional<Length> {
    const auto found = facts.find(fact);
    if (found == facts.end()) return std::nullopt;
    return si<Length>(std::get<double>(found->second));
  };
  const auto thickness = length("thickness");
  switch (row.size_effect) {
    case SizeEffect::none: return 1.0;
    case SizeEffect::butt:
      if (!thickness) return std::nullopt;
      return size_factor_of_butt_weld(*thickness);
    case SizeEffect::eccentric_butt: {
      const auto thicker = length("thicker_thickness");
      const auto eccentricity = length("eccentricity");
      if (!thickness || !thicker || !eccentricity) return std::nullopt;
      return size_factor_of_eccentric_butt_weld(*thickness, *thicker, *eccentricity);
    }
    case SizeEffect::bolt: {
      const auto diameter = length("bolt_diameter");
      if (!diameter) return std::nullopt;
      return size_factor_of_bolt(*diameter);
    }
  }
  return std::nullopt;
}

DetailAssessment assess(const std::vector<DetailRow>& rows, StressKind kind, const Facts& facts) {
  DetailAssessment result;
  result.candidates = candidates_of(rows, kind, facts);
  if (!result.candidates.empty()) result.deciding = deciding_of(result.candidates, facts);
  return result;
}

std::vector<Raise> raises_of(const std::vector<DetailRow>& rows,
                             const std::vector<DetailRow>& candidates, const Facts& facts,
                             const std::vector<std::string>& fixed) {
  std::vector<Raise> found;
  if (candidates.empty()) return found;
  const StressKind kind = candidates.front().kind;
  const double least = strength_of(candidates.front(), facts);
  for (const DetailRow& row : rows) {
    if (row.kind != kind) continue;
    const auto changes = changes_to(row, candidates, facts, fixed);
    if (!changes || changes->size() > Raise::most_changes) continue;
    Facts changed = facts;
    for (const FactChange& change : *changes) {
      changed.insert_or_assign(change.fact, value_in(change.to));
    }
    const double strength = strength_of(row, changed);
    if (strength <= least) continue;
    // Other rows may still apply to the changed detail.
    const std::vector<DetailRow> left = candidates_of(rows, kind, changed);
    if (left.empty() || strength_of(left.front(), changed) < strength) continue;
    found.push_back({*changes, row});
  }
  std::stable_sort(found.begin(), found.end(), [](const Raise& a, const Raise& b) {
    return std::tuple(a.changes.size(), -a.row.category) <
           std::tuple(b.changes.size(), -b.row.category);
  });
  std::vector<Raise> raises;
  for (Raise& raise : found) {
    const bool beaten = std::any_of(raises.begin(), raises.end(), [&](const Raise& other) {
      return other.row.category >= raise.row.category && part_of(other.changes, raise.changes);
    });
    if (!beaten) raises.push_back(std::move(raise));
  }
  return raises;
}

}  // namespace boxbeam
