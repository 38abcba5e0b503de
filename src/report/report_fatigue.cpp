#include <fmt/format.h>

#include <algorithm>

#include "blocks.hpp"
#include "report_parts.hpp"

namespace boxbeam::report {
namespace {

using text::Quantity;

/// The fatigue check that the figures show, or nullptr where its stress is given.
const CheckResult* governing_fatigue(const Verification& verification) {
  const CheckResult* governing = verification.governing(Criterion::fatigue);
  const bool counted =
      governing != nullptr && governing->basis && !governing->basis->spectrum.empty();
  return counted ? governing : nullptr;
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

/// What the cycles of the governing check do, its loads as they are, partial factors applied.
void add_spectrum(const Source& source, const CheckResult& governing, std::vector<Block>& blocks) {
  const Check& check = governing.check;
  const FatigueDemand& demand = source.project.fatigue.demand;
  const bool several = source.project.situations.size() > 1;
  const double damage = governing.basis->damage;
  Table table = table_of(
      fmt::format("Cycles of the governing check, {} at {}; N under the loads as they are, ranges "
                  "times gamma_Ff gamma_Mf = {}: {}",
                  to_text(check.criterion), place_of(check),
                  text::factor(demand.gamma_Ff * demand.gamma_Mf),
                  damage > 0.0 ? "D = sum n/N = " + text::factor(damage) : "no damage"),
      {"stress", "range [MPa]", "mean [MPa]", "n in the life", "N endured", "n/N"});
  if (several) table.header.emplace_back("situation");
  std::vector<const SpectrumRow*> rows;
  for (const SpectrumRow& row : governing.basis->spectrum) rows.push_back(&row);
  std::stable_sort(rows.begin(), rows.end(), [](const SpectrumRow* a, const SpectrumRow* b) {
    return a->cycle.range > b->cycle.range;
  });
  constexpr std::size_t most = 20;
  const std::size_t shown =
      source.level == ReportLevel::full ? rows.size() : std::min(rows.size(), most);
  double rest = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SpectrumRow& row = *rows[i];
    if (i >= shown) {
      rest += row.damage;
      continue;
    }
    Cell endured = cell("unlimited");
    if (row.damage > 0.0) {
      const double N = row.cycle.count / row.damage;
      endured = {text::cycles(N), N};
    }
    std::vector<Cell> cells = row_of(row.kind == StressKind::direct ? "normal" : "shear",
                                     cell(Quantity::stress, row.cycle.range.value()),
                                     cell(Quantity::stress, row.cycle.mean.value()),
                                     Cell{text::cycles(row.cycle.count), row.cycle.count},
                                     std::move(endured), cell(Quantity::factor, row.damage));
    if (several) cells.push_back(cell(row.situation));
    add_row(table, std::move(cells));
  }
  blocks.emplace_back(std::move(table));
  if (shown == rows.size()) return;
  blocks.emplace_back(Paragraph{fmt::format("{} smaller ranges more have together n/N = {}.",
                                            rows.size() - shown, text::factor(rest))});
}

/// What the code does with the plate's thickness.
std::string size_text(const CodeResult& code) {
  if (code.size_factor == 1.0) {
    return code.size_rule.empty() ? std::string("1") : code.size_rule;
  }
  return fmt::format("{}{}", text::factor(code.size_factor),
                     code.size_rule.empty() ? "" : " = " + code.size_rule);
}

std::string remark_of(const CodeResult& code) {
  std::string remark = code.unconfirmed ? "UNCONFIRMED" : "";
  if (code.damage_limit < 1.0) {
    remark += fmt::format("{}damage sum up to {:g}", remark.empty() ? "" : "; ", code.damage_limit);
  }
  return remark;
}

void add_codes(const Verification& verification, std::vector<Block>& blocks) {
  if (verification.codes.empty()) return;
  blocks.emplace_back(Subheading{"The same beam under several codes"});
  blocks.emplace_back(Paragraph{
      "Direct-stress fatigue: the same ranges, counts and partial factors on the curve of each "
      "code whose strength at 2e6 cycles is nearest below that of the detail, with the code's own "
      "correction for the thickness of the plate at the place. The case's own code has the size "
      "effect of the detail's row."});
  Table table = table_of("", {"code", "curve", "thickness", "factor", "required", "use [%]",
                              "s [m]", "point", "remark"});
  for (const CodeResult& code : verification.codes) {
    if (!code.missing.empty()) {
      add_row(table, row_of(code.code, "-", "-", "-", "-", "-", "-", "-", code.missing));
      table.marks.push_back(Mark::none);
      continue;
    }
    const double use = code.required / code.safety_factor;
    add_row(table, row_of(code.code, code.curve, size_text(code),
                          cell(Quantity::factor, code.safety_factor),
                          cell(Quantity::factor, code.required), cell(Quantity::utilisation, use),
                          to_text(code.station), code.point, remark_of(code)));
    table.marks.push_back(use > 1.0 ? Mark::fails : Mark::passes);
  }
  blocks.emplace_back(std::move(table));
}

}  // namespace

Chapter fatigue_chapter(const Source& source) {
  Chapter chapter{"Fatigue", {}};
  if (source.level == ReportLevel::summary) return chapter;
  if (!source.verification.pictures.sn) return chapter;
  add_pictures(source, FigurePlace::fatigue, chapter.blocks);
  chapter.blocks.emplace_back(demand_facts(source.project));
  if (const CheckResult* governing = governing_fatigue(source.verification)) {
    add_spectrum(source, *governing, chapter.blocks);
  }
  add_codes(source.verification, chapter.blocks);
  return chapter;
}

}  // namespace boxbeam::report
