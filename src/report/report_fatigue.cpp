#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "blocks.hpp"
#include "report_parts.hpp"

namespace boxbeam::report {
namespace {

using text::Quantity;

/// The fatigue check with the highest utilisation, or nullptr.
const CheckResult* governing_fatigue(const Verification& verification) {
  const auto worst = std::find_if(
      verification.checks.begin(), verification.checks.end(),
      [](const CheckResult& result) { return result.basis && !result.basis->spectrum.empty(); });
  return worst == verification.checks.end() ? nullptr : &*worst;
}

Facts demand_facts(const Project& project) {
  const FatigueDemand& demand = project.fatigue.demand;
  Facts facts;
  facts.entries.emplace_back(
      "loading", demand.loading == Loading::spectrum ? "spectrum" : "constant amplitude");
  facts.entries.emplace_back(
      "partial factors",
      fmt::format("gamma_Ff = {}, gamma_Mf = {}{}", text::factor(demand.gamma_Ff),
                  text::factor(demand.gamma_Mf), in_brackets(project.fatigue.gamma_Mf_source)));
  facts.entries.emplace_back("required factor", text::factor(project.fatigue.required));
  facts.entries.emplace_back("wanted life", text::cycles(most_cycles_of(project)) +
                                                " cycles of the situation that runs most often");
  return facts;
}

/// What the cycles of the governing check do, its loads taken so many times as its factor says.
Table spectrum_table(const Source& source, const CheckResult& governing) {
  const Check& check = governing.check;
  const bool several = source.project.situations.size() > 1;
  Table table = table_of(
      fmt::format("Cycles of the governing check, {} at {}; N is endured under {} times the loads",
                  to_text(check.criterion), place_of(check), text::factor(check.safety_factor)),
      {"stress", "range [MPa]", "mean [MPa]", "n in the life", "N endured", "n/N"});
  if (several) table.header.emplace_back("situation");
  std::vector<const SpectrumRow*> rows;
  for (const SpectrumRow& row : governing.basis->spectrum) rows.push_back(&row);
  std::stable_sort(rows.begin(), rows.end(), [](const SpectrumRow* a, const SpectrumRow* b) {
    return a->cycle.range > b->cycle.range;
  });
  constexpr std::size_t most = 20;
  if (source.level != ReportLevel::full && rows.size() > most) rows.resize(most);
  for (const SpectrumRow* row : rows) {
    const double n = row->cycle.count;
    const double N = row->endured;
    std::vector<Cell> cells =
        row_of(row->kind == StressKind::direct ? "normal" : "shear",
               cell(Quantity::stress, row->cycle.range.value()),
               cell(Quantity::stress, row->cycle.mean.value()), Cell{text::cycles(n), n},
               std::isfinite(N) ? Cell{text::cycles(N), N} : cell("unlimited"),
               cell(Quantity::factor, n / N));
    if (several) cells.push_back(cell(row->situation));
    add_row(table, std::move(cells));
  }
  return table;
}

void add_codes(const Verification& verification, std::vector<Block>& blocks) {
  if (verification.codes.empty()) return;
  blocks.emplace_back(Subheading{"The same beam under several codes"});
  blocks.emplace_back(Paragraph{
      "Direct-stress fatigue: the same ranges, counts and partial factors on the curve of each "
      "code whose strength at 2e6 cycles is nearest below that of the detail."});
  Table table =
      table_of("", {"code", "curve", "factor", "required", "use [%]", "s [m]", "point", "remark"});
  for (const CodeResult& code : verification.codes) {
    if (!code.missing.empty()) {
      add_row(table, row_of(code.code, "-", "-", "-", "-", "-", "-", code.missing));
      table.marks.push_back(Mark::none);
      continue;
    }
    const double use = code.required / code.safety_factor;
    add_row(table,
            row_of(code.code, code.curve, cell(Quantity::factor, code.safety_factor),
                   cell(Quantity::factor, code.required), cell(Quantity::utilisation, use),
                   to_text(code.station), code.point, code.unconfirmed ? "UNCONFIRMED" : ""));
    table.marks.push_back(use > 1.0 ? Mark::fails : Mark::passes);
  }
  blocks.emplace_back(std::move(table));
}

}  // namespace

Chapter fatigue_chapter(const Source& source) {
  Chapter chapter{"Fatigue", {}};
  if (source.level == ReportLevel::summary) return chapter;
  add_pictures(source, {"sn"}, chapter.blocks);
  if (!source.verification.sn) return chapter;
  add_pictures(source, {"spectrum"}, chapter.blocks);
  chapter.blocks.emplace_back(demand_facts(source.project));
  if (const CheckResult* governing = governing_fatigue(source.verification)) {
    chapter.blocks.emplace_back(spectrum_table(source, *governing));
  }
  add_codes(source.verification, chapter.blocks);
  return chapter;
}

}  // namespace boxbeam::report
