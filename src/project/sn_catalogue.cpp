#include "boxbeam/project/sn_catalogue.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>

#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/table_reader.hpp"
#include "catalogue_data.hpp"

namespace boxbeam {
namespace {

constexpr double reference_cycles = 2e6;
constexpr double megapascal = 1e6;
constexpr double endless = std::numeric_limits<double>::infinity();
/// The codes print three to five digits; two of their figures further apart are a misprint.
constexpr double largest_gap = 2e-3;

/// Exponents of a family's thickness correction: by curve, or by kind of detail.
struct ThicknessExponents {
  Length reference;
  bool unconfirmed = false;
  std::map<std::string, double> by_curve;
  std::optional<double> toe, butt, flush, along;
};

struct Family {
  std::string name;
  std::vector<SnCurve> curves;
  std::optional<ThicknessExponents> thickness;
  double damage_limit = 1.0;
};

/// Curves of the same branches, each by its strength at 2e6 cycles.
std::vector<SnCurve> read_strengths(TableReader& group, SnCurve curve) {
  for (TableReader& branch : group.tables("branches", true)) {
    curve.branches.push_back({branch.number("slope"), branch.number("until", endless)});
    branch.finish();
  }
  const std::vector<double> strengths = group.quantities("strengths", wanted::stress);
  const std::vector<std::string> names = group.texts("names", false);
  if (!names.empty() && names.size() != strengths.size()) {
    group.problem("names", "there are not as many names as strengths");
    return {};
  }
  std::vector<SnCurve> curves;
  for (std::size_t i = 0; i < strengths.size(); ++i) {
    curve.name = names.empty() ? fmt::format("{:.6g}", strengths[i] / megapascal) : names[i];
    curve.reference = si<Stress>(strengths[i]);
    curves.push_back(curve);
  }
  return curves;
}

/// Strength in MPa after so many cycles on log N = log_a - m log S.
double strength_on(double log_a, double slope, double cycles) {
  return std::pow(10.0, (log_a - std::log10(cycles)) / slope);
}

void check_agreement(TableReader& line, const char* key, double printed, double follows) {
  if (std::abs(printed - follows) <= largest_gap * follows) return;
  line.problem(key, fmt::format("\"{}\" does not agree with the other figures of its line", key));
}

/// One curve by the constants of its lines.
SnCurve read_line(TableReader& line, SnCurve curve, double knee) {
  curve.name = line.text("name");
  const double m1 = line.number("m1");
  const double m2 = line.number("m2");
  double log_a1 = 0.0;
  if (line.has("K2")) {
    const double K2 = line.number("K2");
    log_a1 = std::log10(K2);
    if (line.has("K1")) {
      const double below_mean = std::pow(10.0, -2.0 * line.number("SD"));
      check_agreement(line, "K2", K2, line.number("K1") * below_mean);
    }
  } else {
    log_a1 = line.number("log_a1");
    check_agreement(line, "log_a2", strength_on(line.number("log_a2"), m2, knee),
                    strength_on(log_a1, m1, knee));
  }
  line.finish();
  curve.branches = {{m1, knee}, {m2, endless}};
  curve.reference = si<Stress>(strength_on(log_a1, m1, reference_cycles) * megapascal);
  return curve;
}

std::vector<SnCurve> read_group(TableReader& group, const std::string& code) {
  SnCurve common;
  common.code = group.has("code") ? group.text("code") : code;  // of another edition
  common.reference_cycles = reference_cycles;
  common.kind =
      group.choice("kind", {"direct", "shear"}) == 0 ? StressKind::direct : StressKind::shear;
  common.source = group.text("source");
  common.unconfirmed = group.boolean("unconfirmed", false);
  if (group.has("constant_amplitude_limit")) {
    common.constant_amplitude_limit = group.number("constant_amplitude_limit");
  }
  if (group.has("cut_off")) common.cut_off = group.number("cut_off");
  std::vector<SnCurve> curves;
  if (group.has("lines")) {
    const double knee = group.number("knee");
    for (TableReader& line : group.tables("lines")) {
      curves.push_back(read_line(line, common, knee));
    }
  } else {
    curves = read_strengths(group, common);
  }
  group.finish();
  return curves;
}

ThicknessExponents read_thickness(TableReader table) {
  ThicknessExponents exponents;
  exponents.reference = si<Length>(table.positive("reference", wanted::length));
  exponents.unconfirmed = table.boolean("unconfirmed", false);
  table.text("source");
  if (table.has("curves")) {
    TableReader curves = table.table("curves");
    for (const Node::Member& curve : curves.members()) {
      exponents.by_curve.emplace(curve.key, curves.any_number(curve.key));
    }
    curves.finish();
  } else {
    exponents.toe = table.number("toe");
    exponents.butt = table.number("butt");
    exponents.flush = table.number("flush");
    exponents.along = table.number("along");
  }
  table.finish();
  return exponents;
}

std::vector<Family> read_families() {
  const CaseDocument document = parse_document("sn-curves.toml", catalogue_data::sn_curves, {});
  ProblemList problems(document);
  std::vector<Family> all;
  for (auto& [name, table] : TableReader(problems, document.root, "").named_tables()) {
    Family family;
    family.name = name;
    const std::string code = table.text("code");
    if (table.has("thickness")) family.thickness = read_thickness(table.table("thickness"));
    family.damage_limit = table.number("damage_limit", 1.0);
    for (TableReader& group : table.tables("groups", true)) {
      for (SnCurve& curve : read_group(group, code)) family.curves.push_back(std::move(curve));
    }
    table.finish();
    all.push_back(std::move(family));
  }
  problems.raise();
  return all;
}

const std::vector<Family>& all_families() {
  static const std::vector<Family> all = read_families();
  return all;
}

const Family* family_named(std::string_view name) {
  for (const Family& each : all_families()) {
    if (each.name == name) return &each;
  }
  return nullptr;
}

const std::vector<SnCurve>& curves_of(std::string_view family) {
  static const std::vector<SnCurve> none;
  const Family* found = family_named(family);
  return found == nullptr ? none : found->curves;
}

/// The exponent for a row of EN 1993-1-9. Ground butt welds are those of category 112.
double exponent_of(const ThicknessExponents& exponents, const SnCurve& curve,
                   std::string_view row) {
  if (!exponents.by_curve.empty()) {
    const auto found = exponents.by_curve.find(curve.name);
    return found == exponents.by_curve.end() ? 0.0 : found->second;
  }
  if (row.starts_with("8.1/") || row.starts_with("8.2/")) return *exponents.along;
  if (!row.starts_with("8.3/")) return *exponents.toe;
  constexpr double ground = 112e6;
  return curve.reference.value() >= ground * (1.0 - 1e-9) ? *exponents.flush : *exponents.butt;
}

}  // namespace

std::vector<std::string> families() {
  std::vector<std::string> names;
  for (const Family& family : all_families()) names.push_back(family.name);
  return names;
}

std::vector<std::string> names_of(std::string_view family, StressKind kind) {
  std::vector<std::string> names;
  for (const SnCurve& curve : curves_of(family)) {
    if (curve.kind == kind) names.push_back(curve.name);
  }
  return names;
}

std::optional<SnCurve> find_curve(std::string_view family, std::string_view name, StressKind kind) {
  for (const SnCurve& curve : curves_of(family)) {
    if (curve.kind == kind && curve.name == name) return curve;
  }
  return std::nullopt;
}

std::optional<SnCurve> curve_of_same_strength(std::string_view family, StressKind kind,
                                              Stress strength) {
  constexpr double tolerance = 0.005;
  const SnCurve* best = nullptr;
  for (const SnCurve& curve : curves_of(family)) {
    if (curve.kind != kind || curve.reference > (1.0 + tolerance) * strength) continue;
    if (best == nullptr || curve.reference > best->reference) best = &curve;
  }
  if (best == nullptr) return std::nullopt;
  return *best;
}

std::optional<ThicknessRule> thickness_rule_of(std::string_view family, const SnCurve& curve,
                                               std::string_view row) {
  const Family* found = family_named(family);
  if (found == nullptr || !found->thickness || curve.kind != StressKind::direct) {
    return std::nullopt;
  }
  const ThicknessExponents& exponents = *found->thickness;
  return ThicknessRule{exponents.reference, exponent_of(exponents, curve, row),
                       exponents.unconfirmed};
}

double factor_of(const ThicknessRule& rule, Length thickness) {
  if (thickness <= rule.reference) return 1.0;
  return std::pow(rule.reference / thickness, rule.exponent);
}

std::string to_text(const ThicknessRule& rule, Length thickness) {
  const auto mm = [](Length length) { return fmt::format("{:.6g} mm", length.value() * 1e3); };
  if (rule.exponent == 0.0) return "none for this curve";
  if (thickness <= rule.reference) return fmt::format("1 up to {}", mm(rule.reference));
  return fmt::format("({}/{})^{:g}", mm(rule.reference), mm(thickness), rule.exponent);
}

double damage_limit_of(std::string_view family) {
  const Family* found = family_named(family);
  return found == nullptr ? 1.0 : found->damage_limit;
}

}  // namespace boxbeam
