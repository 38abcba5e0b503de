#include "boxbeam/project/plate_detail.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "boxbeam/project/detail_catalogue.hpp"

namespace boxbeam {

void take_governing(Detail& detail, const DetailAssessment& assessment, const Facts& facts,
                    const DetailInPlates& known) {
  const DetailRow& row = assessment.candidates.front();
  detail.row = row.id;
  if (!known.named) detail.name = row.what;
  detail.curve = curve_of(row, known.raise_asterisk);
  detail.where = row.where;
  detail.size_effect = row.size_effect;
  detail.size_factor = size_factor_of(row, facts).value_or(1.0);
  // Where one of the rows that it can be is welded, the detail may be.
  detail.compression_reduced =
      known.stress_relieved ||
      std::none_of(assessment.candidates.begin(), assessment.candidates.end(),
                   [](const DetailRow& candidate) { return candidate.welded; });
  detail.unconfirmed = row.unconfirmed || detail.curve.unconfirmed;
  detail.candidates = assessment.candidates;
  detail.deciding = assessment.deciding;
}

Detail detail_of_row(std::string_view row, std::string name, std::optional<Length> length) {
  const std::vector<DetailRow> rows = detail_rows_of(row);
  Facts facts;
  if (length) facts.emplace("attachment_length", length->value());
  Detail detail;
  detail.name = std::move(name);
  take_governing(detail, assess(rows, StressKind::direct, facts), facts,
                 {facts, rows, false, false, true});
  return detail;
}

std::optional<Detail> in_plate(const Detail& detail, Length plate) {
  if (!detail.in_plates) return std::nullopt;
  Facts facts = detail.in_plates->facts;
  facts.emplace("thickness", plate.value());
  DetailAssessment assessment = assess(detail.in_plates->rows, detail.curve.kind, facts);
  if (assessment.candidates.empty()) {
    const auto strength = [&](const DetailRow& row) {
      return row.category * size_factor_of(row, facts).value_or(1.0);
    };
    assessment.candidates = detail.in_plates->rows;
    std::stable_sort(
        assessment.candidates.begin(), assessment.candidates.end(),
        [&](const DetailRow& a, const DetailRow& b) { return strength(a) < strength(b); });
  }
  const DetailRow& row = assessment.candidates.front();
  const bool same = row.id == detail.row && row.category == detail.candidates.front().category &&
                    size_factor_of(row, facts).value_or(1.0) == detail.size_factor;
  if (same) return std::nullopt;
  Detail here = detail;
  take_governing(here, assessment, facts, *detail.in_plates);
  return here;
}

std::vector<Length> thickness_limits_of(const Detail& detail) {
  std::vector<Length> limits;
  if (!detail.in_plates) return limits;
  for (const DetailRow& row : detail.in_plates->rows) {
    if (row.size_effect != SizeEffect::none) limits.push_back(si<Length>(0.025));
    const auto condition = row.conditions.find("thickness");
    if (condition == row.conditions.end()) continue;
    const auto& range = std::get<FactRange>(condition->second);
    for (const double end : {range.from, range.to}) {
      if (std::isfinite(end)) limits.push_back(si<Length>(end));
    }
  }
  return limits;
}

}  // namespace boxbeam
