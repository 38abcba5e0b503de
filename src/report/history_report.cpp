#include "boxbeam/report/history_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "document_fields.hpp"
#include "text_layout.hpp"
#include "version.hpp"

namespace boxbeam {
namespace {

using report::Fields;

const char* word_of(Residue residue) {
  switch (residue) {
    case Residue::half_cycles: return "as half cycles";
    case Residue::repeated: return "repeated";
    case Residue::discard: return "discarded";
  }
  return "";
}

/// "m = 3 to 5e6, m = 5 to 1e8".
std::string slopes_of(const SnCurve& curve) {
  std::string text;
  for (const SnBranch& branch : curve.branches) {
    text += fmt::format("{}m = {:g}", text.empty() ? "" : ", ", branch.slope);
    if (std::isfinite(branch.until)) text += " to " + text::cycles(branch.until);
  }
  return text;
}

std::string curve_text(const SnCurve& curve) {
  std::string out = fmt::format("{}, {} ({}): {} at {}; {}", curve.code, curve.name,
                                curve.kind == StressKind::direct ? "direct" : "shear",
                                text::MPa(curve.reference.value()),
                                text::cycles(curve.reference_cycles), slopes_of(curve));
  if (curve.constant_amplitude_limit) {
    out += fmt::format("; constant-amplitude limit {}", text::MPa(knee_of(curve).value()));
  }
  if (curve.cut_off) out += fmt::format("; cut-off {}", text::MPa(cut_off_of(curve).value()));
  if (curve.unconfirmed) out += "; UNCONFIRMED figures";
  return out;
}

/// What the result leaves out, or takes beyond what its source says.
std::vector<std::string> remarks_of(const HistoryDemand& demand, const HistoryFatigue& fatigue) {
  constexpr double shortest_life = 1e4;
  std::vector<std::string> remarks;
  const auto add = [&](const ChannelFatigue& channel) {
    const NamedResistance& resistance = channel.resistance;
    const char* stress = resistance.curve.kind == StressKind::direct ? "normal" : "shear";
    if (!resistance.not_applied.empty()) {
      remarks.push_back(fmt::format("{} stress: {}", stress, resistance.not_applied));
    }
    if (!channel.range_passes(demand.demand.gamma_Ff)) {
      remarks.push_back(fmt::format(
          "{} stress: the largest range, {}, is above its limit {}: fatigue strengths do not hold "
          "there (EN 1993-1-9, 8(1))",
          stress, text::MPa(demand.demand.gamma_Ff * channel.largest.value()),
          text::MPa(channel.range_limit->value())));
    }
    if (channel.fewest_endured < shortest_life) {
      remarks.push_back(fmt::format(
          "{} stress: the largest range endures {:.3g} cycles: the lines of the code begin at 1e4, "
          "its damage is extrapolated",
          stress, channel.fewest_endured));
    }
    if (channel.cycles < shortest_life) {
      remarks.push_back(fmt::format(
          "{} stress: {:.6g} cycles in all, fewer than the 1e4 from which fatigue is judged by "
          "these lines: the static strength may decide",
          stress, channel.cycles));
    }
  };
  add(fatigue.direct);
  if (fatigue.shear) add(*fatigue.shear);
  if (!demand.yield_strength) {
    remarks.push_back(
        "ranges are not held against 1.5 f_y (EN 1993-1-9, 8(1)): neither --yield nor --steel is "
        "given");
  }
  return remarks;
}

/// ", of 0.5 that IIW allows for ranges of many sizes"; "" where it is the whole.
std::string allowed_text(const ChannelFatigue& channel) {
  if (channel.damage_limit == 1.0) return "";
  return fmt::format(", of {} that {} allows for ranges of many sizes",
                     text::significant(channel.damage_limit), channel.resistance.curve.code);
}

std::string channel_text(const std::string& title, const ChannelFatigue& channel, double gamma_Ff) {
  std::string out = layout::heading(title);
  out += layout::entry("curve", curve_text(channel.resistance.curve));
  if (!channel.resistance.row.empty()) {
    out += layout::entry("detail", "row " + channel.resistance.row + " of EN 1993-1-9");
  }
  if (!channel.resistance.size_rule.empty()) {
    out += layout::entry("size", fmt::format("{}, {}; in the curve above",
                                             text::significant(channel.resistance.size_factor),
                                             channel.resistance.size_rule));
  }
  out += layout::entry("cycles", fmt::format("{:.12g}, largest range {}", channel.cycles,
                                             text::MPa(channel.largest.value())));
  if (channel.range_limit) {
    out += layout::entry(
        "limit",
        fmt::format(
            "of a range {}, {} (EN 1993-1-9, 8(1)): {}", text::MPa(channel.range_limit->value()),
            channel.resistance.curve.kind == StressKind::direct ? "1.5 f_y" : "1.5 f_y/sqrt(3)",
            channel.range_passes(gamma_Ff) ? "held" : "EXCEEDED"));
  }
  out += layout::entry("damage", text::significant(channel.damage) + allowed_text(channel));
  out += layout::entry("range", fmt::format("{} at 2e6 cycles does the same damage",
                                            text::MPa(channel.equivalent_range.value())));
  out += "\n";
  layout::Table table({channel.binned ? "range, mean of bin [MPa]" : "range [MPa]",
                       channel.binned ? "largest [MPa]" : "mean [MPa]", "cycles", "damage",
                       "share"});
  const double whole = std::max(channel.damage, 1e-300);
  for (const SpectrumBin& bin : channel.spectrum) {
    const double damage = channel.damage == 0.0 ? 0.0 : bin.damage;
    const Stress second = channel.binned ? bin.largest : bin.mean;
    table.row({text::significant(bin.range.value() * 1e-6, 5),
               text::significant(second.value() * 1e-6, 5), fmt::format("{:.9g}", bin.count),
               text::significant(damage), text::percent(damage / whole)});
  }
  return out + table.text() + "\n";
}

/// The library writes NaN and infinity as null; none may stand in a result.
void put_curve(Fields& to, const SnCurve& curve) {
  to.text("code", curve.code);
  to.text("name", curve.name);
  to.word("kind", curve.kind == StressKind::direct ? "direct" : "shear", {"direct", "shear"});
  to.number("reference", "Pa", curve.reference.value());
  to.number("reference_cycles", "1", curve.reference_cycles);
  to.list("branches", "", curve.branches, [](Fields& of, const SnBranch& branch) {
    of.number("slope", "1", branch.slope);
    of.number_or_null({"until", "cycles; null: never ends"}, "1",
                      std::isfinite(branch.until) ? std::optional(branch.until) : std::nullopt);
  });
  to.number_or_null(
      "constant_amplitude_limit", "Pa",
      curve.constant_amplitude_limit ? std::optional(knee_of(curve).value()) : std::nullopt);
  to.number_or_null("cut_off", "Pa",
                    curve.cut_off ? std::optional(cut_off_of(curve).value()) : std::nullopt);
  to.boolean({"unconfirmed", "its figures are recalled, not read in the code"}, curve.unconfirmed);
}

void put_cycles(Fields& to, const ChannelFatigue& channel) {
  to.list("cycles", "", channel.spectrum, [&](Fields& of, const SpectrumBin& bin) {
    of.number("range", "Pa", bin.range.value());
    of.number("mean", "Pa", bin.mean.value());
    of.number("count", "1", bin.count);
    of.number("damage", "1", channel.damage == 0.0 ? 0.0 : bin.damage);
  });
}

/// The curve, and what the largest range may be.
void put_resistance(Fields& to, const ChannelFatigue& channel) {
  const NamedResistance& resistance = channel.resistance;
  to.object("curve", [&](Fields& of) { put_curve(of, resistance.curve); });
  to.object("resistance", [&](Fields& of) {
    of.text({"row", "of the tables of EN 1993-1-9; empty where none was named"}, resistance.row);
    of.number({"size_factor", "in the curve"}, "1", resistance.size_factor);
    of.text({"not_applied", "what of the size is left out, and why"}, resistance.not_applied);
    of.number("largest_range", "Pa", channel.largest.value());
    of.number_or_null(
        {"range_limit", "1.5 f_y or 1.5 f_y/sqrt(3)"}, "Pa",
        channel.range_limit ? std::optional(channel.range_limit->value()) : std::nullopt);
  });
}

void put_channel(Fields& to, const ChannelFatigue& channel) {
  put_cycles(to, channel);
  to.boolean("binned", channel.binned);
  to.number("damage", "1", channel.damage);
  to.number({"damage_limit", "what its code allows"}, "1", channel.damage_limit);
  to.number("equivalent_range", "Pa", channel.equivalent_range.value());
  put_resistance(to, channel);
}

}  // namespace

std::string to_text(const CountingRule& rule) {
  switch (rule.counting) {
    case Counting::astm: return "rainflow, ASTM E1049 (what never closes as half cycles)";
    case Counting::four_point:
      return fmt::format("rainflow by four points, residue {}", word_of(rule.residue));
    case Counting::periodic:
      return "rainflow of a periodic history, rotated to its highest point (no residue)";
  }
  return "";
}

report::MarkedText history_text(const HistoryDemand& demand, const HistoryFatigue& fatigue) {
  report::MarkedText out = fatigue.passes() ? report::MarkedText("PASS", report::Mark::passes)
                                            : report::MarkedText("FAIL", report::Mark::fails);
  out += fmt::format("  damage {}{}{}\n", text::significant(fatigue.damage),
                     fatigue.shear ? "" : allowed_text(fatigue.direct),
                     demand.repetitions == 1.0
                         ? ""
                         : fmt::format(" in {} repetitions", text::cycles(demand.repetitions)));
  out += fatigue.life ? fmt::format("      life {} repetitions of the history\n",
                                    text::significant(*fatigue.life))
                      : std::string("      life unlimited: no range does damage\n");
  out += "\n";
  const StressHistory& history = fatigue.history;
  out += layout::entry(
      "history",
      fmt::format("{}, {} samples{}", demand.source.path, history.samples,
                  history.first_time ? fmt::format(", t = {:.6g} to {:.6g} s", *history.first_time,
                                                   *history.last_time)
                                     : ""));
  out += layout::entry("counting", to_text(demand.rule));
  out += layout::entry(
      "factors",
      fmt::format("gamma_Ff = {}, gamma_Mf = {}, {}{}",
                  text::significant(demand.demand.gamma_Ff, 3),
                  text::significant(demand.demand.gamma_Mf, 3),
                  demand.demand.loading == Loading::spectrum
                      ? "spectrum"
                      : "constant amplitude: no damage while all ranges are below the limit",
                  demand.compression_reduced ? "; compression counts 60 % (7.2.1)" : ""));
  const double gamma_Ff = demand.demand.gamma_Ff;
  out += "\n" + channel_text("Normal stress", fatigue.direct, gamma_Ff);
  if (fatigue.shear) {
    out += channel_text("Shear stress", *fatigue.shear, gamma_Ff);
    out += layout::paragraph(fmt::format("Together: {} + {} = {} (EN 1993-1-9, 8(3), equation 8.3)",
                                         text::significant(fatigue.direct.damage),
                                         text::significant(fatigue.shear->damage),
                                         text::significant(fatigue.damage)));
  }
  const std::vector<std::string> remarks = remarks_of(demand, fatigue);
  if (!remarks.empty()) out += layout::heading("Remarks");
  for (const std::string& remark : remarks) out += layout::entry("-", remark);
  return out;
}

void report::put_history(Fields& to, const HistoryDemand& demand, const HistoryFatigue& fatigue) {
  to.constant("schema", "boxbeam.fatigue/1");
  to.text({"version", "of the program"}, version);
  to.text("history", demand.source.path);
  to.whole("samples", fatigue.history.samples, "1");
  to.text("counting", to_text(demand.rule));
  to.number("repetitions", "1", demand.repetitions);
  to.number("gamma_Ff", "1", demand.demand.gamma_Ff);
  to.number("gamma_Mf", "1", demand.demand.gamma_Mf);
  to.word("verdict", fatigue.passes() ? "pass" : "fail", {"pass", "fail"});
  put_cycles(to, fatigue.direct);
  to.boolean("binned", fatigue.direct.binned);
  to.number({"damage", "of normal and shear stress together"}, "1", fatigue.damage);
  to.number({"damage_limit",
             "what its code allows, of normal stress; less than 1 for ranges of many "
             "sizes"},
            "1", fatigue.direct.damage_limit);
  to.number({"use", "damage by what is allowed, of both together"}, "1", fatigue.use);
  to.number({"equivalent_range", "of 2e6 cycles, normal stress"}, "Pa",
            fatigue.direct.equivalent_range.value());
  to.number_or_null({"life", "repetitions; null: unlimited"}, "1", fatigue.life);
  put_resistance(to, fatigue.direct);
  to.texts("remarks", [&] { return remarks_of(demand, fatigue); });
  to.object_or_null("shear", fatigue.shear, put_channel);
}

std::string history_json(const HistoryDemand& demand, const HistoryFatigue& fatigue) {
  return report::document_text(
      [&](report::Fields fields) { report::put_history(fields, demand, fatigue); });
}

}  // namespace boxbeam
