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

  double range() const { return row->cycle.range.value(); }
  /// Share of the life, the loads taken k times or as they are.
  double harm() const { return row->cycle.count / row->endured; }
  double harm_as_is() const { return row->damage; }
};

std::vector<Row> rows_of(const CheckBasis& basis) {
  std::vector<Row> rows;
  for (const SpectrumRow& row : basis.spectrum) {
    const auto curve =
        std::find_if(basis.curves.begin(), basis.curves.end(),
                     [&](const SnCurve& candidate) { return candidate.kind == row.kind; });
    rows.push_back({&row, &*curve, "", ""});
  }
  return rows;
}

/// So many sizes of range are shown in a sum of damage, the worst first.
constexpr std::size_t most_shown = 8;

/// The rows that do damage, the worst first.
std::vector<const Row*> harmful_of(const std::vector<Row>& rows, double (Row::*harm)() const) {
  std::vector<const Row*> harmful;
  for (const Row& row : rows) {
    if ((row.*harm)() > 0.0) harmful.push_back(&row);
  }
  std::stable_sort(harmful.begin(), harmful.end(),
                   [&](const Row* a, const Row* b) { return (a->*harm)() > (b->*harm)(); });
  return harmful;
}

bool nearly(double a, double b) {
  constexpr double round_off = 1e-9;
  return std::abs(a - b) <= round_off * std::abs(b);
}

/// Names the rows that the sheet speaks of, from 1 in their order; one alone is the range that the
/// sheet has already, where it is that one.
void name_rows(std::vector<Row>& rows, const std::vector<const Row*>& shown,
               const CheckBasis& basis) {
  const auto is_shown = [&](const Row& row) {
    return std::find(shown.begin(), shown.end(), &row) != shown.end();
  };
  const auto count = std::count_if(rows.begin(), rows.end(), is_shown);
  int number = 0;
  for (Row& row : rows) {
    if (!is_shown(row)) continue;
    const bool first_curve = row.curve == &basis.curves.front();
    const bool reduced = basis.point.compression_reduced && row.row->kind == StressKind::direct;
    const bool known =
        first_curve && (reduced || nearly(row.range(), basis.highest.value - basis.lowest.value));
    if (rows.size() > 1 && (count > 1 || !known || reduced))
      row.index = fmt::format("_{}", ++number);
    row.symbol = prefix_of(*row.curve) + (row.index.empty() && reduced ? "_red" : row.index);
  }
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
  const Row* row;
  Corner limit;
};

std::optional<Reached> limit_reached(const std::vector<Row>& rows, double k, const Gammas& gammas) {
  std::optional<Reached> reached;
  for (const Row& row : rows) {
    const double range = k * gammas.product * row.row->cycle.range.value();
    for (const Corner& corner : corners_of(*row.curve)) {
      constexpr double round_off = 1e-9;
      if (corner.what.empty() || std::abs(range - corner.strength) > round_off * range) continue;
      if (reached && reached->row->row->cycle.count >= row.row->cycle.count) continue;
      reached = Reached{&row, corner};
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
  steps.push_back(
      {"n" + row.index, {text::cycles(n)}, {"cycles in the wanted life" + in_situation(*row.row)}});
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

/// A damage sum: under the loads taken k times, or as they are.
struct Sum {
  double (Row::*harm)() const;
  std::optional<double> k;
  const Gammas* gammas;

  double endured(const Row& row) const {
    return k ? row.row->endured : row.row->cycle.count / row.row->damage;
  }
  /// "N_1", "N_1,k"; "N" and "N_k" where the row has no number.
  std::string N(const Row& row) const {
    if (!k) return "N" + row.index;
    return row.index.empty() ? "N_k" : "N" + row.index + ",k";
  }
};

/// Cycles to failure of a size.
Step endured_step(const Row& row, const Sum& sum) {
  const double N = sum.endured(row);
  const Corner corner = corner_before(corners_of(*row.curve), N);
  const double slope = slope_at(*row.curve, N);
  const std::string k = sum.k ? text::significant(*sum.k) + " x " : "";
  return {sum.N(row),
          {fmt::format("{} ({}/({}{} {}))^{:g}", text::cycles(corner.cycles), corner.symbol,
                       sum.k ? "k " : "", sum.gammas->symbols, row.symbol, slope),
           fmt::format("{} x ({}/({}{} x {}))^{:g}", text::cycles(corner.cycles),
                       text::MPa(corner.strength), k, sum.gammas->values, text::MPa(row.range()),
                       slope),
           scientific(N, 4)},
          {"cycles to failure; " + counted(row)}};
}

/// "normal running does all but 0.01 % of it", where several situations do damage.
std::string situations_text(const std::vector<const Row*>& harmful, const Sum& sum, double total) {
  std::vector<std::pair<std::string, double>> shares;
  for (const Row* row : harmful) {
    const auto of = std::find_if(shares.begin(), shares.end(), [&](const auto& share) {
      return share.first == row->row->situation;
    });
    if (of == shares.end())
      shares.emplace_back(row->row->situation, (row->*sum.harm)());
    else
      of->second += (row->*sum.harm)();
  }
  if (shares.size() < 2) return "";
  std::stable_sort(shares.begin(), shares.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  const double most = shares.front().second / total;
  constexpr double nearly_all = 0.995;
  return most > nearly_all
             ? fmt::format("{} does all but {} of it", shares.front().first,
                           text::percent(1.0 - most))
             : fmt::format("{} does {} of it", shares.front().first, text::percent(most));
}

/// The damage sum, row by row.
Steps damage_sum_steps(const std::vector<Row>& rows, const Sum& of, Step sum, double total) {
  const std::vector<const Row*> harmful = harmful_of(rows, of.harm);
  Steps steps;
  std::string symbols, shares, terms;
  double rest = 0.0;
  for (std::size_t i = 0; i < harmful.size(); ++i) {
    const Row& row = *harmful[i];
    if (i >= most_shown) {
      rest += (row.*of.harm)();
      continue;
    }
    steps.push_back(endured_step(row, of));
    if (!shares.empty()) shares += " + ", terms += " + ";
    shares +=
        fmt::format("{}/{}", text::cycles(row.row->cycle.count), scientific(of.endured(row), 4));
    terms += share((row.*of.harm)());
  }
  if (rest > 0.0) {
    shares += " + " + share(rest);
    terms += " + " + share(rest);
    sum.notes.push_back(
        fmt::format("the last term: {} smaller shares", harmful.size() - most_shown));
  }
  if (rows.size() == 1 && !of.k) sum.formulas = {"n/N"};
  if (!harmful.empty()) sum.formulas.push_back(shares);
  if (harmful.size() > 1) sum.formulas.push_back(terms);
  sum.formulas.push_back(harmful.empty() ? "0" : share(total));
  if (const std::string most = situations_text(harmful, of, total); !most.empty())
    sum.notes.push_back(most);
  std::size_t harmless = 0;
  double largest_harmless = 0.0;
  for (const Row& row : rows) {
    if ((row.*of.harm)() > 0.0) continue;
    ++harmless;
    largest_harmless = std::max(largest_harmless, row.range());
  }
  if (harmful.empty()) {
    sum.notes.emplace_back("every range is below the limit of damage");
  } else if (harmless > 0) {
    sum.notes.push_back(fmt::format("{} size{} of range up to {} below the limit: no damage",
                                    harmless, harmless == 1 ? "" : "s",
                                    text::MPa(largest_harmless)));
  }
  steps.push_back(sum);
  return steps;
}

/// The ranges with a number.
Steps range_rows(const std::vector<Row>& rows) {
  Steps steps;
  for (const Row& row : rows) {
    if (row.index.empty()) continue;
    const bool direct = row.row->kind == StressKind::direct;
    steps.push_back(
        {row.symbol,
         {text::MPa(row.range())},
         {fmt::format("range of {} stress, {}", direct ? "direct" : "shear", counted(row))}});
  }
  return steps;
}

/// The damage under the loads as they are, and the range of 2e6 cycles that does as much.
Steps damage_steps(const CheckBasis& basis, const std::vector<Row>& rows, const Gammas& gammas) {
  Steps steps = damage_sum_steps(
      rows, {&Row::harm_as_is, {}, &gammas},
      {"D", {"sum n_i/N_i"}, {"damage in the wanted life, loads as they are"}}, basis.damage);
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

/// The row whose range reaches the limit that all must stay below under constant amplitude.
const Row* constant_amplitude_row(const CheckBasis& basis, const std::vector<Row>& rows,
                                  const Gammas& gammas, double factor) {
  const SnCurve& curve = basis.curves.front();
  const double k = basis.constant_amplitude_factor;
  // Before the knee both are the same.
  if (!curve.constant_amplitude_limit || text::significant(k) == text::significant(factor))
    return nullptr;
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& at) {
    return at.row->kind == curve.kind &&
           nearly(k * gammas.product * at.range(), knee_of(curve).value());
  });
  return row == rows.end() ? nullptr : &*row;
}

/// The factor under constant amplitude, for comparison.
Steps constant_amplitude_steps(const CheckBasis& basis, const Row* row, const Gammas& gammas,
                               double factor) {
  const SnCurve& curve = basis.curves.front();
  const double k = basis.constant_amplitude_factor;
  if (!curve.constant_amplitude_limit || text::significant(k) == text::significant(factor))
    return {};
  Step step{"factor_CA", {text::significant(k)}, {"beside: under constant amplitude, 7.1(2)"}};
  if (row != nullptr) {
    step.formulas = {fmt::format("{}_D/({} {})", prefix_of(curve), gammas.symbols, row->symbol),
                     fmt::format("{}/({} x {})", text::MPa(knee_of(curve).value()), gammas.values,
                                 text::MPa(row->range())),
                     text::significant(k)};
  }
  return {step};
}

}  // namespace

Steps life_steps(const Project& project, const Check& check, const CheckBasis& basis) {
  const Gammas gammas = gammas_of(project.fatigue.demand);
  const double k = check.safety_factor;
  std::vector<Row> rows = rows_of(basis);
  const Row* alone = rows.size() == 1 ? &rows.front() : nullptr;
  for (const Row& row : rows) {
    if (alone == nullptr && row.harm() > 1.0 - 1e-9) alone = &row;
  }
  const std::optional<Reached> reached =
      alone == nullptr ? limit_reached(rows, k, gammas) : std::nullopt;
  const Row* constant = constant_amplitude_row(basis, rows, gammas, k);

  std::vector<const Row*> shown;
  const auto show = [&](const std::vector<const Row*>& harmful) {
    shown.insert(
        shown.end(), harmful.begin(),
        harmful.begin() + static_cast<std::ptrdiff_t>(std::min(harmful.size(), most_shown)));
  };
  show(harmful_of(rows, &Row::harm_as_is));
  if (alone == nullptr) show(harmful_of(rows, &Row::harm));
  for (const Row* row : {alone, reached ? reached->row : nullptr, constant}) {
    if (row != nullptr) shown.push_back(row);
  }
  name_rows(rows, shown, basis);

  Steps steps = range_rows(rows);
  append(steps, damage_steps(basis, rows, gammas));
  append(steps, constant_amplitude_steps(basis, constant, gammas, k));
  if (alone != nullptr) {
    append(steps, alone_steps(project, check, *alone, gammas));
    if (rows.size() > 1) {
      steps.back().notes.push_back(
          "with it these cycles alone use up the life; no other range does damage yet");
    }
    return steps;
  }
  const std::string result = text::significant(k, 4);
  Step taken{"k", {result}, {"loads taken k times: the largest k with D_k <= 1"}};
  if (reached) {
    const Row& row = *reached->row;
    taken.formulas = {fmt::format("{}/({} {})", reached->limit.symbol, gammas.symbols, row.symbol),
                      fmt::format("{}/({} x {})", text::MPa(reached->limit.strength), gammas.values,
                                  text::MPa(row.range())),
                      result};
    taken.notes = {
        fmt::format("loads taken k times: this range reaches the {}; above it its {} "
                    "cycles do damage, and D_k > 1",
                    reached->limit.what, text::cycles(row.row->cycle.count))};
  }
  steps.push_back(taken);
  double total = 0.0;
  for (const Row& row : rows) total += row.harm();
  append(steps, damage_sum_steps(
                    rows, {&Row::harm, k, &gammas},
                    {"D_k", {"sum n_i/N_i,k"}, {"damage in the wanted life, loads taken k times"}},
                    total));
  steps.push_back({"factor", {"k", result}, {}});
  return steps;
}

}  // namespace boxbeam::report
