#include "boxbeam/report/history_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "boxbeam/report/format.hpp"
#include "text_layout.hpp"
#include "version.hpp"

namespace boxbeam {
namespace {

using Json = nlohmann::ordered_json;

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
  out += layout::entry("damage", text::significant(channel.damage));
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
Json curve_json(const SnCurve& curve) {
  Json branches = Json::array();
  for (const SnBranch& branch : curve.branches) {
    branches.push_back({{"slope", branch.slope},
                        {"until", std::isfinite(branch.until) ? Json(branch.until) : Json()}});
  }
  return {{"code", curve.code},
          {"name", curve.name},
          {"kind", curve.kind == StressKind::direct ? "direct" : "shear"},
          {"reference", curve.reference.value()},
          {"reference_cycles", curve.reference_cycles},
          {"branches", std::move(branches)},
          {"constant_amplitude_limit",
           curve.constant_amplitude_limit ? Json(knee_of(curve).value()) : Json()},
          {"cut_off", curve.cut_off ? Json(cut_off_of(curve).value()) : Json()},
          {"unconfirmed", curve.unconfirmed}};
}

Json cycles_json(const ChannelFatigue& channel) {
  Json cycles = Json::array();
  for (const SpectrumBin& bin : channel.spectrum) {
    cycles.push_back({{"range", bin.range.value()},
                      {"mean", bin.mean.value()},
                      {"count", bin.count},
                      {"damage", channel.damage == 0.0 ? 0.0 : bin.damage}});
  }
  return cycles;
}

Json resistance_json(const ChannelFatigue& channel) {
  const NamedResistance& resistance = channel.resistance;
  return {{"row", resistance.row},
          {"size_factor", resistance.size_factor},
          {"not_applied", resistance.not_applied},
          {"largest_range", channel.largest.value()},
          {"range_limit", channel.range_limit ? Json(channel.range_limit->value()) : Json()}};
}

Json channel_json(const ChannelFatigue& channel) {
  return {{"cycles", cycles_json(channel)},
          {"binned", channel.binned},
          {"damage", channel.damage},
          {"equivalent_range", channel.equivalent_range.value()},
          {"curve", curve_json(channel.resistance.curve)},
          {"resistance", resistance_json(channel)}};
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

std::string history_text(const HistoryDemand& demand, const HistoryFatigue& fatigue) {
  std::string out = fmt::format(
      "{}  damage {}{}\n", fatigue.passes() ? "PASS" : "FAIL", text::significant(fatigue.damage),
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

std::string history_json(const HistoryDemand& demand, const HistoryFatigue& fatigue) {
  Json document = {{"schema", "boxbeam.fatigue/1"},
                   {"version", version},
                   {"history", demand.source.path},
                   {"samples", fatigue.history.samples},
                   {"counting", to_text(demand.rule)},
                   {"repetitions", demand.repetitions},
                   {"gamma_Ff", demand.demand.gamma_Ff},
                   {"gamma_Mf", demand.demand.gamma_Mf},
                   {"verdict", fatigue.passes() ? "pass" : "fail"},
                   {"cycles", cycles_json(fatigue.direct)},
                   {"binned", fatigue.direct.binned},
                   {"damage", fatigue.damage},
                   {"equivalent_range", fatigue.direct.equivalent_range.value()},
                   {"life", fatigue.life ? Json(*fatigue.life) : Json()},
                   {"curve", curve_json(fatigue.direct.resistance.curve)},
                   {"resistance", resistance_json(fatigue.direct)},
                   {"remarks", remarks_of(demand, fatigue)}};
  document["shear"] = fatigue.shear ? channel_json(*fatigue.shear) : Json();
  return document.dump(2) + "\n";
}

}  // namespace boxbeam
