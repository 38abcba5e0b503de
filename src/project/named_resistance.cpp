#include "boxbeam/project/named_resistance.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/detail_catalogue.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/project/sn_catalogue.hpp"

namespace boxbeam {
namespace {

std::string mm(Length length) { return fmt::format("{:.6g} mm", length.value() * 1e3); }

/// The lengths, beside the plate's thickness, that the size effect of a row asks for.
const char* other_lengths(SizeEffect effect) {
  switch (effect) {
    case SizeEffect::none:
    case SizeEffect::butt: return "";
    case SizeEffect::eccentric_butt: return "the other plate's thickness and the eccentricity";
    case SizeEffect::bolt: return "the bolt's diameter";
  }
  return "";
}

void take_size(const DetailRow& row, const Facts& facts, NamedResistance& resistance) {
  if (row.size_effect == SizeEffect::none) return;
  const std::string others = other_lengths(row.size_effect);
  if (const auto factor = size_factor_of(row, facts)) {
    const Length thickness = si<Length>(std::get<double>(facts.at("thickness")));
    resistance.size_factor = *factor;
    resistance.size_rule =
        *factor == 1.0 ? fmt::format("1 up to 25 mm (7.2.2, row {})", row.id)
                       : fmt::format("(25 mm/{})^0.2 (7.2.2, row {})", mm(thickness), row.id);
    resistance.curve = scaled(resistance.curve, *factor);
    return;
  }
  resistance.not_applied =
      others.empty()
          ? fmt::format("the size effect of row {} is not applied: --thickness is not given",
                        row.id)
          : fmt::format(
                "the size effect of row {} is not applied: it asks for {}, which a case "
                "gives in its facts",
                row.id, others);
}

NamedResistance row_named(const std::string& id, StressKind kind, std::optional<Length> thickness) {
  std::vector<std::string> ids;
  std::vector<DetailRow> lines;
  for (const DetailRow& row : detail_rows()) {
    ids.push_back(row.id);
    if (row.id == id && row.kind == kind) lines.push_back(row);
  }
  if (lines.empty()) {
    const std::string near = nearest_word(id, ids);
    throw InputError(
        fmt::format("there is no row \"{}\" for this stress in the tables", id),
        near.empty() ? "write table and row, 8.2/6" : fmt::format("did you mean {}?", near));
  }
  Facts facts;
  if (thickness) facts.emplace("thickness", thickness->value());
  const DetailAssessment assessment = assess(lines, kind, facts);
  if (assessment.candidates.empty()) {
    throw InputError(fmt::format("row {} has no line for a plate of {}", id, mm(*thickness)),
                     "look again at --thickness");
  }
  const DetailRow& weakest = assessment.candidates.front();
  NamedResistance resistance;
  resistance.curve = curve_of(weakest);
  resistance.curve.unconfirmed = resistance.curve.unconfirmed || weakest.unconfirmed;
  resistance.row = id;
  take_size(weakest, facts, resistance);
  return resistance;
}

}  // namespace

NamedResistance resistance_named(const std::string& text, StressKind kind,
                                 std::optional<Length> thickness) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos && text.find('/') != std::string::npos) {
    return row_named(text, kind, thickness);
  }
  const std::string family = colon == std::string::npos ? "EN 1993-1-9" : text.substr(0, colon);
  const std::string name = colon == std::string::npos ? text : text.substr(colon + 1);
  const std::vector<std::string> all = families();
  if (std::find(all.begin(), all.end(), family) == all.end()) {
    throw InputError(fmt::format("there are no curves \"{}\"", family),
                     fmt::format("one of {}", fmt::join(all, ", ")));
  }
  const auto curve = find_curve(family, name, kind);
  if (!curve) {
    const std::vector<std::string> names = names_of(family, kind);
    throw InputError(
        fmt::format("{} has no {} curve \"{}\"", family,
                    kind == StressKind::direct ? "direct" : "shear", name),
        names.empty() ? "take another code" : fmt::format("one of {}", fmt::join(names, ", ")));
  }
  NamedResistance resistance;
  resistance.curve = *curve;
  resistance.damage_limit = damage_limit_of(family);
  // Of a category that is given as such nobody knows the row, and with it the size effect.
  if (family.starts_with("EN 1993-1-9")) {
    if (kind == StressKind::direct) {
      resistance.not_applied =
          "a size effect, where the detail's row has one, is not applied: a category is given, no "
          "row";
    }
    return resistance;
  }
  const auto rule = thickness_rule_of(family, *curve, "");
  if (!rule) return resistance;
  if (!thickness) {
    resistance.not_applied = fmt::format(
        "the thickness correction of {} is not applied: --thickness is not given", curve->code);
    return resistance;
  }
  resistance.size_factor = factor_of(*rule, *thickness);
  resistance.size_rule = to_text(*rule, *thickness);
  resistance.curve = scaled(resistance.curve, resistance.size_factor);
  resistance.curve.unconfirmed = resistance.curve.unconfirmed || rule->unconfirmed;
  return resistance;
}

}  // namespace boxbeam
