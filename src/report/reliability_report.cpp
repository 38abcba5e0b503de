#include "boxbeam/report/reliability_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "document_fields.hpp"
#include "study_tables.hpp"

namespace boxbeam {
namespace {

std::string number_text_of(double value) { return fmt::format("{:.5g}", value); }

std::string or_dash(const std::optional<double>& value, const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

bool is_simulation(const MethodResult& of) {
  return of.method != ReliabilityMethod::form && of.method != ReliabilityMethod::sorm;
}

std::string text_of_point(const StudyReliability& of, std::size_t place) {
  const DesignPoint& point = of.result.points[place];
  return fmt::format("\nDesign point {}, beta = {:.4f}{}:\n", place + 1, point.beta,
                     point.kinked ? ", at a kink of the limit state" : "") +
         report::point_table(of.points[place]).text();
}

const MethodResult* result_by(const StudyReliability& of, ReliabilityMethod method) {
  for (const MethodResult& by : of.result.methods)
    if (by.method == method) return &by;
  return nullptr;
}

void put_common(report::Fields& to, const MethodResult& by, const std::optional<double>& years) {
  to.boolean({"converged", "within its tolerance, or to the wanted coefficient of variation"},
             by.converged);
  to.text({"reason", "why it did not converge or says nothing; empty else"}, by.reason);
  to.number_or_null({"p_f", "probability of failure; null where it says none"}, "1", by.p_f);
  to.number_or_null({"beta", "of form that of the nearest design point, else -Phi^-1(p_f)"}, "1",
                    by.beta);
  const std::optional<double> yearly =
      by.p_f && years ? std::optional(per_year(*by.p_f, *years)) : std::nullopt;
  to.number_or_null({"p_f_per_year", "where years of service are given"}, "1", yearly);
  to.number_or_null("beta_per_year", "1", yearly ? reliability_index(*yearly) : std::nullopt);
  to.number({"p_f_low", "Ditlevsen's bounds of form and sorm, else of 95 % confidence"}, "1",
            by.low);
  to.number("p_f_high", "1", by.high);
  to.whole({"calls", "of the limit state"}, by.calls);
  to.whole({"unjudged", "designs that could not be judged; they count as failing"}, by.unjudged);
}

void put_points(report::Fields& to, const StudyReliability& of) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < of.result.points.size(); ++i) places.push_back(i);
  to.list({"design_points", "the nearest first"}, "", places,
          [&](report::Fields& fields, std::size_t place) {
            const bool none = fields.is_describing();
            const DesignPoint point = none ? DesignPoint{} : of.result.points[place];
            fields.number({"beta", "below zero where the medians fail"}, "1", point.beta);
            fields.boolean({"kinked", "curvatures say nothing there"}, point.kinked);
            fields.numbers(
                {"curvatures", "principal ones, empty of one variable"}, "1",
                {point.curvatures.data(), static_cast<std::size_t>(point.curvatures.size())});
            const std::vector<VariableAtPoint> variables =
                none ? std::vector<VariableAtPoint>{} : of.points[place];
            fields.list(
                "variables", "{variable}", variables,
                [](report::Fields& at, const VariableAtPoint& variable) {
                  at.text("variable", variable.name);
                  at.text({"unit", "as in the study; empty without"}, variable.unit);
                  at.number_in("value", "", "unit", variable.value);
                  at.number({"u", "of the independent normal variable behind it"}, "1", variable.u);
                  at.number({"alpha", "above zero of what loads"}, "1", variable.alpha);
                });
          });
}

void put_simulation(report::Fields& to, const MethodResult& by,
                    const std::optional<double>& years) {
  put_common(to, by, years);
  to.number_or_null({"cov", "coefficient of variation of p_f"}, "1",
                    by.p_f ? std::optional(by.history.back().variation) : std::nullopt);
  to.whole({"samples", "that the result rests on"}, by.samples);
  to.whole({"failing", "of them; of subset simulation in its last levels"}, by.failing);
  to.list({"history", "p_f as it came about"}, "", by.history,
          [](report::Fields& fields, const Estimate& at) {
            fields.whole("samples", at.samples);
            fields.number("p_f", "1", at.p_f);
            fields.number("cov", "1", at.variation);
            fields.number("low", "1", at.low);
            fields.number("high", "1", at.high);
          });
}

/// Of a method that was asked for; all of them where the schema is described.
template <class Put>
void put_method(report::Fields& to, const StudyReliability& of, ReliabilityMethod method,
                const Put& put) {
  const MethodResult* const by = result_by(of, method);
  if (by == nullptr && !to.is_describing()) return;
  const MethodResult none;
  to.optional().object(to_text(method),
                       [&](report::Fields& fields) { put(fields, by != nullptr ? *by : none); });
}

}  // namespace

layout::Table report::methods_table(const StudyReliability& of) {
  std::vector<std::string> header{"method", "beta", "p_f", "from", "to", "c.o.v.", "evaluations"};
  if (of.years) {
    header.emplace_back("p_f a year");
    header.emplace_back("beta a year");
  }
  layout::Table table(header);
  for (const MethodResult& by : of.result.methods) {
    std::optional<double> variation, yearly;
    if (by.p_f && is_simulation(by)) variation = by.history.back().variation;
    if (by.p_f && of.years) yearly = per_year(*by.p_f, *of.years);
    std::vector<std::string> row{to_text(by.method),
                                 or_dash(by.beta, "{:.4f}"),
                                 or_dash(by.p_f, "{:.4g}"),
                                 by.p_f ? fmt::format("{:.4g}", by.low) : "-",
                                 by.p_f ? fmt::format("{:.4g}", by.high) : "-",
                                 variation ? fmt::format("{:.1f} %", 100.0 * *variation) : "-",
                                 std::to_string(by.calls)};
    if (of.years) {
      row.push_back(or_dash(yearly, "{:.4g}"));
      row.push_back(or_dash(yearly ? reliability_index(*yearly) : std::nullopt, "{:.4f}"));
    }
    table.row(row);
  }
  return table;
}

std::vector<std::string> report::methods_remarks(const StudyReliability& of) {
  std::vector<std::string> remarks;
  std::size_t unjudged = 0;
  for (const MethodResult& by : of.result.methods) {
    if (!by.reason.empty()) remarks.push_back(fmt::format("{}: {}", to_text(by.method), by.reason));
    unjudged = std::max(unjudged, by.unjudged);
  }
  remarks.insert(remarks.end(), of.result.remarks.begin(), of.result.remarks.end());
  if (unjudged > 0)
    remarks.push_back(
        fmt::format("designs that could not be judged, up to {} of a method; the first: {}",
                    unjudged, of.result.first_trouble));
  return remarks;
}

layout::Table report::point_table(const std::vector<VariableAtPoint>& point) {
  layout::Table table({"variable", "value", "unit", "u", "alpha", "alpha^2 [%]"});
  for (const VariableAtPoint& at : point)
    table.row({at.name, number_text_of(at.value), at.unit, fmt::format("{:+.3f}", at.u),
               fmt::format("{:+.3f}", at.alpha),
               fmt::format("{:.1f}", 100.0 * at.alpha * at.alpha)});
  return table;
}

report::MarkedText reliability_text(const StudyReliability& of) {
  std::string text =
      layout::heading(fmt::format("{}: {}{}", of.name, fmt::join(of.limit_state, " or "),
                                  of.case_file.empty() ? "" : fmt::format(", {}", of.case_file)));
  text += report::methods_table(of).text();
  for (const std::string& remark : report::methods_remarks(of)) text += layout::item(remark);
  constexpr std::size_t most_points = 4;
  for (std::size_t i = 0; i < std::min(most_points, of.points.size()); ++i)
    text += text_of_point(of, i);
  if (of.points.size() > most_points)
    text += layout::paragraph(fmt::format("{} more design points stand in reliability.json",
                                          of.points.size() - most_points));
  if (!of.points.empty())
    text += layout::paragraph(
        fmt::format("alpha above zero: more of it leads to failure; alpha^2: its part in the "
                    "scatter that decides{}.",
                    of.correlated ? ". Variables are correlated: alpha counts each by itself, u "
                                    "that of the independent ones behind, in their order"
                                  : ""));
  text += layout::paragraph(
      fmt::format("seed {}, {} evaluations of the limit state", of.seed, of.result.calls));
  return text;
}

void report::put_reliability(Fields& to, const StudyReliability& of) {
  using enum ReliabilityMethod;
  to.constant("schema", "boxbeam.reliability/1");
  to.text("name", of.name);
  to.text({"study", "its file"}, of.study_file);
  to.text({"case", "its file; empty without"}, of.case_file);
  to.text({"input_sha256", "of the study, the case and its tables"}, of.sha256);
  to.whole({"seed", "of random numbers"}, of.seed);
  to.texts({"limit_state", "failure where any holds"}, of.limit_state);
  to.boolean({"correlated", "variables are"}, of.correlated);
  to.number_or_null({"years", "of service, over which p_f counts"}, "1", of.years);
  to.whole({"calls", "of the limit state, of all methods"}, of.result.calls);
  to.text({"first_trouble", "why the first design that could not be judged was not"},
          of.result.first_trouble);
  to.texts({"remarks", "where methods disagree"}, of.result.remarks);
  to.object({"methods", "those that were asked for"}, [&](Fields& methods) {
    put_method(methods, of, form, [&](Fields& fields, const MethodResult& by) {
      put_common(fields, by, of.years);
      std::vector<std::pair<std::string, double>> alpha;
      if (!of.points.empty())
        for (const VariableAtPoint& at : of.points.front()) alpha.emplace_back(at.name, at.alpha);
      fields.named_numbers({"alpha", "of the nearest design point by variables"}, alpha);
      put_points(fields, of);
    });
    put_method(methods, of, sorm, [&](Fields& fields, const MethodResult& by) {
      put_common(fields, by, of.years);
      fields.number_or_null(
          {"p_f_breitung", "by his formula; p_f is that of Hohenbichler, Rackwitz"}, "1",
          by.breitung);
    });
    for (const ReliabilityMethod method : {monte_carlo, importance, subset})
      put_method(methods, of, method, [&](Fields& fields, const MethodResult& by) {
        put_simulation(fields, by, of.years);
      });
  });
}

std::string reliability_json(const StudyReliability& of) {
  return report::document_text([&](report::Fields fields) { report::put_reliability(fields, of); });
}

}  // namespace boxbeam
