#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "blocks.hpp"
#include "report_parts.hpp"

namespace boxbeam::report {
namespace {

using text::Quantity;

Mark mark_of(const Check& check) { return check.passes() ? Mark::passes : Mark::fails; }

/// "range 33.38 MPa", "17.05 MPa".
Cell acting_cell(const Check& check) {
  const bool range = check.criterion == Criterion::fatigue ||
                     check.criterion == Criterion::shear_fatigue ||
                     check.criterion == Criterion::stress_range;
  const bool damage = check.criterion == Criterion::combined_fatigue;
  return {fmt::format("{}{}",
                      range    ? "range "
                      : damage ? "damage "
                               : "",
                      text::amount(check.acting.value(), check.acting.unit())),
          check.acting.value()};
}

Cell resisting_cell(const Check& check) {
  return {text::amount(check.resisting.value(), check.resisting.unit()), check.resisting.value()};
}

Cell station_cell(const Check& check) {
  if (!check.on_beam) return cell("-");
  return {to_text(check.station), check.station.s.value()};
}

Table checks_table(const Source& source, std::string caption,
                   const std::vector<const Check*>& checks) {
  const bool several = source.project.situations.size() > 1;
  Table table = table_of(std::move(caption), {"use [%]", "factor", "required", "criterion", "s [m]",
                                              "point", "t [s]", "acting", "resisting"});
  if (several) table.header.emplace_back("situation");
  table.rows.reserve(checks.size());
  for (const Check* check : checks) {
    std::vector<Cell> row = row_of(
        cell(Quantity::utilisation, check->utilisation()),
        cell(Quantity::factor, check->safety_factor), cell(Quantity::factor, check->required),
        to_text(check->criterion), station_cell(*check), check->point,
        cell(Quantity::time, check->time.value()), acting_cell(*check), resisting_cell(*check));
    if (several) row.push_back(cell(check->situation));
    add_row(table, std::move(row));
    table.marks.push_back(mark_of(*check));
  }
  return table;
}

/// How many checks, worst first, are not below a utilisation; at least the worst.
std::size_t checks_above(const Verification& verification, double utilisation) {
  const auto below = std::find_if(
      verification.checks.begin(), verification.checks.end(),
      [&](const CheckResult& result) { return result.check.utilisation() < utilisation; });
  return std::max<std::size_t>(1, static_cast<std::size_t>(below - verification.checks.begin()));
}

/// One row per criterion for the checks from a place on in the list, worst first.
Table rest_table(const Verification& verification, std::size_t from) {
  Table table =
      table_of("Checks used less than 50 %, by criterion",
               {"criterion", "checks", "highest use [%]", "least factor", "s [m]", "point"});
  std::vector<Criterion> seen;
  for (std::size_t i = from; i < verification.checks.size(); ++i) {
    const Check& worst = verification.checks[i].check;
    if (std::find(seen.begin(), seen.end(), worst.criterion) != seen.end()) continue;
    seen.push_back(worst.criterion);
    const auto count = std::count_if(
        verification.checks.begin() + static_cast<std::ptrdiff_t>(from), verification.checks.end(),
        [&](const CheckResult& of) { return of.check.criterion == worst.criterion; });
    add_row(table,
            row_of(to_text(worst.criterion), std::to_string(count),
                   cell(Quantity::utilisation, worst.utilisation()),
                   cell(Quantity::factor, worst.safety_factor), station_cell(worst), worst.point));
  }
  return table;
}

/// The worst check of every criterion at every station, and of every neighbour of the beam; worst
/// first.
std::vector<const CheckResult*> worst_of_stations(const Verification& verification) {
  std::set<std::pair<Criterion, std::string>> seen;
  std::vector<const CheckResult*> worst;
  for (const CheckResult& result : verification.checks) {
    const Check& check = result.check;
    const std::string place = check.on_beam ? to_text(check.station) : check.point;
    if (seen.emplace(check.criterion, place).second) worst.push_back(&result);
  }
  return worst;
}

void add_sheet(const Source& source, const CheckResult& result, std::vector<Block>& blocks) {
  blocks.emplace_back(sheet_of(source.project, source.verification, result));
}

}  // namespace

std::string place_of(const Check& check) {
  if (!check.on_beam) return check.point;
  return fmt::format("s = {} m, {}", to_text(check.station), check.point);
}

std::vector<const CheckResult*> governing_checks(const Verification& verification) {
  std::vector<const CheckResult*> governing;
  for (const Criterion criterion : criteria) {
    if (const CheckResult* result = verification.governing(criterion)) governing.push_back(result);
  }
  // As they stand among all checks, of which the first is named in the verdict.
  std::sort(governing.begin(), governing.end(), std::less<>{});
  return governing;
}

Table governing_table(const Source& source) {
  const bool several = source.project.situations.size() > 1;
  Table table =
      table_of("", {"criterion", "use [%]", "factor", "required", "s [m]", "point", "t [s]"});
  if (several) table.header.emplace_back("situation");
  for (const CheckResult* result : governing_checks(source.verification)) {
    const Check& check = result->check;
    std::vector<Cell> row =
        row_of(to_text(check.criterion), cell(Quantity::utilisation, check.utilisation()),
               cell(Quantity::factor, check.safety_factor), cell(Quantity::factor, check.required),
               station_cell(check), check.point, cell(Quantity::time, check.time.value()));
    if (several) row.push_back(cell(check.situation));
    add_row(table, std::move(row));
    table.marks.push_back(mark_of(check));
    if (source.level != ReportLevel::summary) table.sheets.push_back(check.id);
  }
  drop_instants_at_rest(source.project, table);
  return table;
}

Chapter sheets_chapter(const Source& source) {
  Chapter chapter{"Governing checks", {}};
  if (source.level == ReportLevel::summary) return chapter;
  const std::vector<const CheckResult*> governing = governing_checks(source.verification);
  for (const CheckResult* result : governing) add_sheet(source, *result, chapter.blocks);
  if (source.level != ReportLevel::full) return chapter;
  chapter.blocks.emplace_back(
      Subheading{"The worst check of every criterion at every other station"});
  for (const CheckResult* result : worst_of_stations(source.verification)) {
    if (std::find(governing.begin(), governing.end(), result) != governing.end()) continue;
    add_sheet(source, *result, chapter.blocks);
  }
  return chapter;
}

Chapter checks_chapter(const Source& source) {
  constexpr double shown_above = 0.50;
  const std::vector<CheckResult>& all = source.verification.checks;
  Chapter chapter{"Checks", {}};
  if (source.level == ReportLevel::summary) return chapter;
  add_pictures(source, FigurePlace::checks, chapter.blocks);
  const std::size_t much_used = checks_above(source.verification, shown_above);
  const std::size_t shown = source.level == ReportLevel::full ? all.size() : much_used;
  std::vector<const Check*> checks;
  for (std::size_t i = 0; i < shown; ++i) checks.push_back(&all[i].check);
  chapter.blocks.emplace_back(
      Paragraph{"Worst first. The factor is the largest multiple of the whole load history that "
                "the beam endures; use is the required factor over it, and above 100 % fails."});
  const SearchSummary& search = source.verification.search;
  if (search.evaluations > 0) {
    chapter.blocks.emplace_back(Paragraph{fmt::format(
        "Searched at {} stations in the {} pieces between which something jumps or kinks: nowhere "
        "on the beam is a criterion used more than {:.2g} % above its worst check.",
        search.evaluations, search.pieces, 100.0 * search.tolerance)});
  }
  Table table = checks_table(source, "", checks);
  if (source.level == ReportLevel::full) {
    std::set<std::string> derived;
    for (const CheckResult* result : worst_of_stations(source.verification)) {
      derived.insert(result->check.id);
    }
    for (const Check* check : checks) {
      table.sheets.push_back(derived.count(check->id) == 1 ? check->id : "");
    }
  }
  chapter.blocks.emplace_back(std::move(table));
  if (much_used < all.size()) {
    chapter.blocks.emplace_back(rest_table(source.verification, much_used));
  }
  if (!source.verification.beside.empty()) {
    std::vector<const Check*> beside;
    for (const CheckResult& result : source.verification.beside) beside.push_back(&result.check);
    chapter.blocks.emplace_back(checks_table(
        source,
        "Slender plates by the route of EN 1993-1-5 that is no part of the verdict, at the "
        "stations of the checks, without forces that come into webs",
        beside));
  }
  if (shown < all.size()) {
    chapter.blocks.emplace_back(
        Paragraph{"All checks stand in results.json, and with --level full in this report."});
  }
  return chapter;
}

}  // namespace boxbeam::report
