#include "fatigue_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "curve_steps.hpp"

namespace boxbeam::report {
namespace {

/// One size of cycle of a channel, named for the sheet.
struct Row {
  const SpectrumRow* row;
  const SnCurve* curve;
  std::string symbol;  ///< "d_sigma_2"; "d_sigma" where there is one only
  std::string index;   ///< "_2"

  double harm() const { return row->cycle.count / row->endured; }
};

std::vector<Row> rows_of(const CheckBasis& basis) {
  std::vector<Row> rows;
  int number = 0;
  const bool several = basis.spectrum.size() > 1;
  const bool reduced = basis.point.compression_reduced;
  for (const SpectrumRow& row : basis.spectrum) {
    const auto curve =
        std::find_if(basis.curves.begin(), basis.curves.end(),
                     [&](const SnCurve& candidate) { return candidate.kind == row.kind; });
    std::string index;
    if (several) index = fmt::format("_{}", ++number);
    const bool other_range = !several && reduced && row.kind == StressKind::direct;
    rows.push_back({&row, &*curve, prefix_of(*curve) + (other_range ? "_red" : index), index});
  }
  return rows;
}

/// The partial factors that a range is multiplied by, as symbols and as numbers.
struct Gammas {
  std::string symbols = "gamma_Ff gamma_Mf";
  std::string values;
  double product = 1.0;
};

Gammas gammas_of(const FatigueDemand& demand) {
  Gammas gammas;
  gammas.values = fmt::format("{} x {}", number(demand.gamma_Ff), number(demand.gamma_Mf));
  gammas.product = demand.gamma_Ff * demand.gamma_Mf;
  return gammas;
}

std::string in_situation(const SpectrumRow& row) {
  return row.situation.empty() ? "" : ", " + row.situation;
}

std::string counted(const Row& row) {
  return fmt::format("{} cycles{}", text::cycles(row.row->cycle.count), in_situation(*row.row));
}

/// A limit of a curve below which a range does no damage, and the range that reaches it with the
/// loads taken k times.
struct Reached {
  Row row;
  Corner limit;
};

std::optional<Reached> limit_reached(const std::vector<Row>& rows, double k, const Gammas& gammas) {
  std::optional<Reached> reached;
  for (const Row& row : rows) {
    const double range = k * gammas.product * row.row->cycle.range.value();
    for (const Corner& corner : corners_of(*row.curve)) {
      constexpr double round_off = 1e-9;
      if (corner.what.empty() || std::abs(range - corner.strength) > round_off * range) continue;
      if (reached && reached->row.row->cycle.count >= row.row->cycle.count) continue;
      reached = Reached{row, corner};
    }
  }
  return reached;
}

/// Where the cycles of one size alone decide: strength at their number over their range.
Steps alone_steps(const Project& project, const Check& check, const Row& row,
                  const Gammas& gammas) {
  Steps steps;
  const double n = row.row->cycle.count;
  const std::string prefix = prefix_of(*row.curve);
  steps.push_back({"n" + row.index, {text::cycles(n)}, {"cycles in the wanted life"}});
  Step strength = strength_step(*row.curve, n, project.fatigue.demand.loading);
  const std::string R = strength.formulas.back();
  const double R_value = strength_at(*row.curve, n, project.fatigue.demand.loading).value();
  steps.push_back(std::move(strength));
  const std::string allowed = text::MPa(R_value / gammas.product);
  steps.push_back({prefix + "_Rd",
                   {fmt::format("{}_R/({})", prefix, gammas.symbols),
                    fmt::format("{}/({})", R, gammas.values), allowed},
                   {"limit: the range that the life allows"}});
  steps.push_back({"factor",
                   {fmt::format("{}_Rd/{}", prefix, row.symbol),
                    fmt::format("{}/{}", allowed, text::MPa(row.row->cycle.range.value())),
                    text::significant(check.safety_factor, 4)},
                   {}});
  return steps;
}

/// Cycles to failure of a size at the loads taken k times.
Step endured_step(const Row& row, double k, const Gammas& gammas) {
  const std::vector<Corner> corners = corners_of(*row.curve);
  const double N = row.row->endured;
  const Corner corner = corner_before(corners, N);
  const double slope = slope_at(*row.curve, N);
  return {"N" + row.index,
          {fmt::format("{} ({}/(k {} {}))^{:g}", text::cycles(corner.cycles), corner.symbol,
                       gammas.symbols, row.symbol, slope),
           fmt::format("{} x ({}/({} x {} x {}))^{:g}", text::cycles(corner.cycles),
                       text::MPa(corner.strength), text::significant(k), gammas.values,
                       text::MPa(row.row->cycle.range.value()), slope),
           scientific(N, 4)},
          {counted(row)}};
}

/// The damage sum with the loads taken k times, row by row.
Steps damage_sum_steps(const std::vector<Row>& rows, double k, const Gammas& gammas) {
  std::vector<Row> harmful;
  std::size_t harmless = 0;
  double largest_harmless = 0.0;
  for (const Row& row : rows) {
    if (row.harm() > 0.0) {
      harmful.push_back(row);
    } else {
      ++harmless;
      largest_harmless = std::max(largest_harmless, row.row->cycle.range.value());
    }
  }
  std::stable_sort(harmful.begin(), harmful.end(),
                   [](const Row& a, const Row& b) { return a.harm() > b.harm(); });
  constexpr std::size_t shown = 8;
  Steps steps;
  Step sum{"D_k", {"sum n_i/N_i"}, {"damage in the wanted life, loads taken k times"}};
  std::string shares, terms;
  double total = 0.0, rest = 0.0;
  for (std::size_t i = 0; i < harmful.size(); ++i) {
    const Row& row = harmful[i];
    total += row.harm();
    if (i >= shown) {
      rest += row.harm();
      continue;
    }
    steps.push_back(endured_step(row, k, gammas));
    if (!shares.empty()) shares += " + ", terms += " + ";
    shares +=
        fmt::format("{}/{}", text::cycles(row.row->cycle.count), scientific(row.row->endured, 4));
    terms += share(row.harm());
  }
  if (rest > 0.0) {
    shares += " + " + share(rest);
    sum.notes.push_back(fmt::format("the last term: {} smaller shares", harmful.size() - shown));
  }
  if (!harmful.empty()) sum.formulas.push_back(shares);
  if (harmful.size() > 1) sum.formulas.push_back(terms);
  sum.formulas.push_back(share(total));
  if (harmless > 0) {
    sum.notes.push_back(fmt::format("{} size{} of range up to {} below the limit: no damage",
                                    harmless, harmless == 1 ? "" : "s",
                                    text::MPa(largest_harmless)));
  }
  steps.push_back(sum);
  return steps;
}

/// Ranges that are not yet named.
Steps range_rows(const std::vector<Row>& rows, const std::vector<const Row*>& wanted) {
  Steps steps;
  for (const Row& row : rows) {
    const bool is_wanted = std::any_of(wanted.begin(), wanted.end(),
                                       [&](const Row* other) { return other->row == row.row; });
    if (!is_wanted || row.index.empty()) continue;
    const bool direct = row.row->kind == StressKind::direct;
    steps.push_back(
        {row.symbol,
         {text::MPa(row.row->cycle.range.value())},
         {fmt::format("range of {} stress, {}", direct ? "direct" : "shear", counted(row))}});
  }
  return steps;
}

/// The damage under the loads as they are, and the range of 2e6 cycles that does as much.
Steps damage_steps(const CheckBasis& basis, const std::vector<Row>& rows, const Gammas& gammas) {
  Steps steps;
  Step damage{"D", {"sum n_i/N_i"}, {"damage in the wanted life, loads as they are"}};
  if (basis.damage > 0.0) {
    if (rows.size() == 1) {
      const double n = rows.front().row->cycle.count;
      const double N = n / basis.damage;
      const Corner corner = corner_before(corners_of(*rows.front().curve), N);
      const double slope = slope_at(*rows.front().curve, N);
      steps.push_back({"N",
                       {fmt::format("{} ({}/({} {}))^{:g}", text::cycles(corner.cycles),
                                    corner.symbol, gammas.symbols, rows.front().symbol, slope),
                        fmt::format("{} x ({}/({} x {}))^{:g}", text::cycles(corner.cycles),
                                    text::MPa(corner.strength), gammas.values,
                                    text::MPa(rows.front().row->cycle.range.value()), slope),
                        scientific(N, 4)},
                       {"cycles to failure"}});
      damage.formulas = {"n/N", fmt::format("{}/{}", text::cycles(n), scientific(N, 4))};
    }
    damage.formulas.push_back(share(basis.damage));
  } else {
    damage.formulas.emplace_back("0");
    damage.notes.emplace_back("every range is below the limit of damage");
  }
  steps.push_back(damage);
  if (basis.equivalent.value() <= 0.0 || basis.damage <= 0.0) return steps;
  const SnCurve& curve = basis.curves.front();
  const double m = curve.branches.front().slope;
  const std::string prefix = prefix_of(curve);
  const bool at_reference = curve.reference_cycles == 2e6;
  const std::string D = share(basis.damage);
  const std::string ratio =
      at_reference ? "" : fmt::format(" x {}/2e6", text::cycles(curve.reference_cycles));
  steps.push_back({prefix + "_E,2",
                   {fmt::format("{}_C {}^(1/{:g})/({})", prefix,
                                ratio.empty() ? "D" : "(D" + ratio + ")", m, gammas.symbols),
                    fmt::format("{} x ({}{})^(1/{:g})/({})", text::MPa(curve.reference.value()),
                                share(basis.damage), ratio, m, gammas.values),
                    text::MPa(basis.equivalent.value())},
                   {"2e6 cycles of this range do as much damage"}});
  return steps;
}

/// The factor under constant amplitude, for comparison.
Steps constant_amplitude_steps(const CheckBasis& basis, const std::vector<Row>& rows,
                               const Gammas& gammas, double factor) {
  const SnCurve& curve = basis.curves.front();
  const double k = basis.constant_amplitude_factor;
  // Before the knee both are the same.
  if (!curve.constant_amplitude_limit || text::significant(k) == text::significant(factor))
    return {};
  Step step{"factor_CA", {text::significant(k)}, {"beside: under constant amplitude, 7.1(2)"}};
  const double limit = knee_of(curve).value();
  for (const Row& row : rows) {
    const double range = gammas.product * row.row->cycle.range.value();
    constexpr double round_off = 1e-9;
    if (row.curve->kind != curve.kind || std::abs(k * range - limit) > round_off * limit) continue;
    const std::string prefix = prefix_of(curve);
    step.formulas = {fmt::format("{}_D/({} {})", prefix, gammas.symbols, row.symbol),
                     fmt::format("{}/({} x {})", text::MPa(limit), gammas.values,
                                 text::MPa(row.row->cycle.range.value())),
                     text::significant(k)};
    break;
  }
  return {step};
}

}  // namespace

Steps life_steps(const Project& project, const Check& check, const CheckBasis& basis) {
  const Gammas gammas = gammas_of(project.fatigue.demand);
  const double k = check.safety_factor;
  const std::vector<Row> rows = rows_of(basis);
  Steps steps = damage_steps(basis, rows, gammas);
  append(steps, constant_amplitude_steps(basis, rows, gammas, k));
  if (rows.size() == 1) {
    append(steps, alone_steps(project, check, rows.front(), gammas));
    return steps;
  }
  const std::optional<Reached> reached = limit_reached(rows, k, gammas);
  std::vector<const Row*> named;
  for (const Row& row : rows) {
    if (row.harm() > 0.0 && named.size() < 8) named.push_back(&row);
  }
  if (reached) named.push_back(&reached->row);
  append(steps, range_rows(rows, named));
  const std::string result = text::significant(k, 4);
  const auto alone = std::find_if(rows.begin(), rows.end(),
                                  [](const Row& row) { return row.harm() > 1.0 - 1e-9; });
  if (alone != rows.end()) {
    append(steps, alone_steps(project, check, *alone, gammas));
    steps.back().notes.push_back(
        "with it these cycles alone use up the life; no other range does damage yet");
    return steps;
  }
  if (reached) {
    const Row& row = reached->row;
    steps.push_back({"k",
                     {fmt::format("{}/({} {})", reached->limit.symbol, gammas.symbols, row.symbol),
                      fmt::format("{}/({} x {})", text::MPa(reached->limit.strength), gammas.values,
                                  text::MPa(row.row->cycle.range.value())),
                      result},
                     {fmt::format("loads taken k times: this range reaches the {}; above it its {} "
                                  "cycles do damage, and D_k > 1",
                                  reached->limit.what, text::cycles(row.row->cycle.count))}});
    append(steps, damage_sum_steps(rows, k, gammas));
  } else {
    steps.push_back({"k", {result}, {"loads taken k times: the largest k with D_k <= 1"}});
    append(steps, damage_sum_steps(rows, k, gammas));
  }
  steps.push_back({"factor", {"k", result}, {}});
  return steps;
}

}  // namespace boxbeam::report
