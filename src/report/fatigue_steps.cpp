#include "sheet_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/fatigue/sn_corners.hpp"
#include "boxbeam/report/format.hpp"
#include "derivation_text.hpp"

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
    row.symbol = symbol_of(*row.curve) + (row.index.empty() && reduced ? "_red" : row.index);
  }
}

/// The partial factors that a range is multiplied by, gamma_Ff gamma_Mf.
Traced gammas_of(const FatigueDemand& demand) {
  return Derivation::known("gamma_Ff", demand.gamma_Ff, {ValueKind::factor}) *
         Derivation::known("gamma_Mf", demand.gamma_Mf, {ValueKind::factor});
}

Traced range_of(const Row& row) {
  return Derivation::known({row.symbol, ""}, row.row->cycle.range);
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
  SnCorner limit;
};

std::optional<Reached> limit_reached(const std::vector<Row>& rows, double k, const Traced& gammas) {
  std::optional<Reached> reached;
  for (const Row& row : rows) {
    const double range = k * gammas.value() * row.row->cycle.range.value();
    for (const SnCorner& corner : corners_of(*row.curve)) {
      constexpr double round_off = 1e-9;
      const bool reference = corner.kind == SnCorner::Kind::reference;
      if (reference || std::abs(range - corner.strength.value()) > round_off * range) continue;
      if (reached && reached->row->row->cycle.count >= row.row->cycle.count) continue;
      reached = Reached{&row, corner};
    }
  }
  return reached;
}

/// Where the cycles of one size alone decide: strength at their number over their range.
Steps alone_steps(const Project& project, const Row& row, const Traced& gammas) {
  Derivation steps;
  const double n = row.row->cycle.count;
  steps.given({"n", row.index}, n, {ValueKind::cycles});
  steps.note([&] { return "cycles in the wanted life" + in_situation(*row.row); });
  const Traced strength = derive_strength(steps, *row.curve, n, project.fatigue.demand.loading);
  const Traced allowed = steps.define({symbol_of(*row.curve), "_Rd"}, strength / gammas,
                                      "limit: the range that the life allows");
  steps.define("factor", allowed / range_of(row));
  return steps_of(steps);
}

/// A damage sum: under the loads taken k times, or as they are.
struct Sum {
  double (Row::*harm)() const;
  std::optional<double> k;
  const Traced* gammas;

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
Steps endured_steps(const Row& row, const Sum& sum) {
  Derivation steps;
  const Traced k = sum.k ? steps.known("k", *sum.k) : Traced(1.0);
  derive_endurance(steps, *row.curve, {sum.N(row), ""}, k * *sum.gammas * range_of(row),
                   sum.endured(row));
  steps.note([&] { return "cycles to failure; " + counted(row); });
  return steps_of(steps);
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
    append(steps, endured_steps(row, of));
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
Steps damage_steps(const CheckBasis& basis, const std::vector<Row>& rows, const Traced& gammas) {
  Steps steps = damage_sum_steps(
      rows, {&Row::harm_as_is, {}, &gammas},
      {"D", {"sum n_i/N_i"}, {"damage in the wanted life, loads as they are"}}, basis.damage);
  if (basis.equivalent.value() <= 0.0 || basis.damage <= 0.0) return steps;
  const SnCurve& curve = basis.curves.front();
  Derivation of;
  derive_equivalent_range(of, curve, basis.damage, gammas);
  append(steps, steps_of(of));
  return steps;
}

/// The row whose range reaches the limit that all must stay below under constant amplitude.
const Row* constant_amplitude_row(const CheckBasis& basis, const std::vector<Row>& rows,
                                  const Traced& gammas, double factor) {
  const SnCurve& curve = basis.curves.front();
  const double k = basis.constant_amplitude_factor;
  // Before the knee both are the same.
  if (!curve.constant_amplitude_limit || text::significant(k) == text::significant(factor))
    return nullptr;
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& at) {
    return at.row->kind == curve.kind &&
           nearly(k * gammas.value() * at.range(), knee_of(curve).value());
  });
  return row == rows.end() ? nullptr : &*row;
}

/// The factor under constant amplitude, for comparison.
Steps constant_amplitude_steps(const CheckBasis& basis, const Row* row, const Traced& gammas,
                               double factor) {
  const SnCurve& curve = basis.curves.front();
  const double k = basis.constant_amplitude_factor;
  if (!curve.constant_amplitude_limit || text::significant(k) == text::significant(factor))
    return {};
  Derivation steps;
  constexpr const char* note = "beside: under constant amplitude, 7.1(2)";
  if (row != nullptr) {
    const Traced limit = steps.known({symbol_of(curve), "_D"}, knee_of(curve));
    steps.define("factor_CA", limit / (gammas * range_of(*row)), note);
  } else {
    steps.given("factor_CA", k, {}, note);
  }
  return steps_of(steps);
}

/// The largest k, by which the loads may be taken: where a range reaches a limit, as its quotient.
Steps taken_steps(double k, const std::optional<Reached>& reached, const Traced& gammas) {
  Derivation steps;
  if (!reached) {
    steps.given("k", k, {}, "loads taken k times: the largest k with D_k <= 1");
    return steps_of(steps);
  }
  const Row& row = *reached->row;
  const Traced limit = steps.known({reached->limit.symbol, ""}, reached->limit.strength);
  steps.define("k", limit / (gammas * range_of(row)));
  steps.note(
      [&] {
        return fmt::format(
            "loads taken k times: this range reaches the {}; above it its {{}} cycles do damage, "
            "and D_k > 1",
            to_text(reached->limit.kind));
      },
      Derivation::literal(row.row->cycle.count, ValueKind::cycles));
  return steps_of(steps);
}

}  // namespace

Steps life_steps(const Project& project, const Check& check, const CheckBasis& basis) {
  const Traced gammas = gammas_of(project.fatigue.demand);
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
    append(steps, alone_steps(project, *alone, gammas));
    if (rows.size() > 1) {
      steps.back().notes.push_back(
          "with it these cycles alone use up the life; no other range does damage yet");
    }
    return steps;
  }
  append(steps, taken_steps(k, reached, gammas));
  double total = 0.0;
  for (const Row& row : rows) total += row.harm();
  append(steps, damage_sum_steps(
                    rows, {&Row::harm, k, &gammas},
                    {"D_k", {"sum n_i/N_i,k"}, {"damage in the wanted life, loads taken k times"}},
                    total));
  steps.push_back({"factor", {"k", text::significant(k, 4)}, {}});
  return steps;
}

}  // namespace boxbeam::report
