// Charts and maps on paper: data that are read back as they were, pictures that show every setting,
// legible whatever is in them, and a document that judges nothing.

#include "charts/accuracy.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "boxbeam/report/html_writer.hpp"
#include "boxbeam/report/latex_writer.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "catch.hpp"
#include "src/report/drawing_forms.hpp"
#include "support/invented_charts.hpp"
#include "support/program.hpp"
#include "support/svg_text.hpp"

namespace accuracy_test {

using namespace boxbeam;
using charts::Chart;
using charts::Map;
using charts::MapPanel;
using charts::Outcome;
using charts::Point;
using charts::Series;
using test::all_charts;
using test::all_maps;
using test::crowded_chart;
using test::invented_chart;
using test::invented_map;
namespace fs = std::filesystem;

namespace {

std::vector<TopicShown> all_topics() {
  const std::span<const charts::Topic> topics = charts::topics();
  return {{&topics[0], {all_charts(), {}, ""}},
          {&topics[1], {{}, all_maps(), ""}},
          {&topics[2], {{}, {}, "the case has no elastic links"}}};
}

/// All of these, drawn once.
const fs::path& drawn() {
  static const test::TemporaryFolder folder;
  static const bool done = [] {
    draw_charts(all_topics(), folder.path().string(), (folder.path() / "tex").string());
    return true;
  }();
  static const fs::path path = folder.path();
  REQUIRE(done);
  return path;
}

std::string svg_of(const std::string& name) { return test::read_file(drawn() / (name + ".svg")); }

/// Fields of each record. Source: RFC 4180.
std::vector<std::vector<std::string>> records_of(const std::string& csv) {
  std::vector<std::vector<std::string>> records{{""}};
  bool quotes = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    std::string& field = records.back().back();
    if (quotes && csv[i] == '"' && i + 1 < csv.size() && csv[i + 1] == '"')
      field += csv[++i];
    else if (csv[i] == '"')
      quotes = !quotes;
    else if (quotes)
      field += csv[i];
    else if (csv[i] == ',')
      records.back().emplace_back();
    else if (csv[i] == '\n' && i + 1 < csv.size())
      records.push_back({""});
    else if (csv[i] != '\n')
      field += csv[i];
  }
  return records;
}

std::size_t matches_in(const std::string& svg, const char* pattern) {
  const std::regex wanted(pattern);
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(svg.begin(), svg.end(), wanted), {}));
}

std::size_t discs_in(const std::string& svg) {
  return matches_in(svg, "<circle fill[^>]* r=\"[1-9]");
}
std::size_t rings_in(const std::string& svg) { return matches_in(svg, "<circle stroke"); }

/// Strokes of a path that go as far down as to the right and no further: one of each cross.
std::size_t crosses_in(const std::string& svg) {
  static const std::regex stroke("M[^a-zM\"]*l([0-9.]+?) ?([0-9]+|[0-9]*\\.[0-9])(?=[M\"])");
  std::size_t count = 0;
  for (std::sregex_iterator at(svg.begin(), svg.end(), stroke), end; at != end; ++at) {
    constexpr double rounding = 0.15;
    if (std::abs(std::stod((*at)[1]) - std::stod((*at)[2])) < rounding) ++count;
  }
  return count;
}

std::size_t panels_of(const Chart& chart) {
  bool work = false, time = false;
  for (const Series& series : chart.series) {
    for (const Point& point : series.points) {
      work = work || point.operations.has_value();
      time = time || point.time.has_value();
    }
  }
  return work && time ? 2 : 1;
}

bool has_failed(const Point& point) { return !point.failure.empty() || std::isnan(point.error); }

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the data of a chart are read back to the last digit", "[report][accuracy]") {
  for (const Chart& chart : all_charts()) {
    CAPTURE(chart.name);
    const auto records = records_of(chart_csv(chart));
    REQUIRE(records.front().size() == 11);
    CHECK(records.front()[3] == (chart.operations.empty() ? "operations" : chart.operations));
    std::size_t row = 1;
    for (const Series& series : chart.series) {
      for (const Point& point : series.points) {
        REQUIRE(row < records.size());
        const std::vector<std::string>& fields = records[row++];
        REQUIRE(fields.size() == 11);
        const auto same = [](const std::string& text, const std::optional<double>& number) {
          return number ? std::strtod(text.c_str(), nullptr) == *number : text.empty();
        };
        CHECK(fields[0] == series.method);
        CHECK(fields[1] == point.setting);
        CHECK(same(fields[2], point.parameter));
        CHECK(same(fields[3], point.operations));
        CHECK(same(fields[4], point.time ? std::optional(point.time->median) : std::nullopt));
        CHECK(same(fields[5], point.time ? std::optional(point.time->low) : std::nullopt));
        CHECK(same(fields[6], point.time ? std::optional(point.time->high) : std::nullopt));
        if (std::isnan(point.error))
          CHECK(fields[7] == "nan");
        else
          CHECK(same(fields[7], point.failure.empty() ? std::optional(point.error) : std::nullopt));
        CHECK(fields[8] == point.failure);
        CHECK(fields[9] == (point.is_default ? "yes" : ""));
        CHECK(fields[10] == (series.yardstick ? "yes" : ""));
      }
    }
    CHECK(row == records.size());
  }
}

TEST_CASE("so are those of a map", "[report][accuracy]") {
  for (const Map& map : all_maps()) {
    CAPTURE(map.name);
    const auto records = records_of(map_csv(map));
    CHECK(records.front() == std::vector<std::string>{"method", map.x.title, map.y.title, "outcome",
                                                      map.value.empty() ? "value" : map.value,
                                                      "reason"});
    std::size_t row = 1;
    for (const MapPanel& panel : map.panels) {
      for (const charts::Cell& cell : panel.cells) {
        REQUIRE(row < records.size());
        const std::vector<std::string>& fields = records[row++];
        REQUIRE(fields.size() == 6);
        CHECK(fields[0] == panel.method);
        CHECK(std::strtod(fields[1].c_str(), nullptr) == cell.x);
        CHECK(std::strtod(fields[2].c_str(), nullptr) == cell.y);
        CHECK(fields[3] == charts::to_text(cell.outcome));
        CHECK(fields[4].empty() != cell.value.has_value());
        if (cell.value) CHECK(std::strtod(fields[4].c_str(), nullptr) == *cell.value);
        CHECK(fields[5] == cell.reason);
      }
    }
    CHECK(row == records.size());
  }
}

TEST_CASE("charts and maps are drawn without a warning and can be read", "[report][accuracy]") {
  std::vector<std::string> names;
  for (const Chart& chart : all_charts()) names.push_back(chart.name);
  for (const Map& map : all_maps()) names.push_back(map.name);
  for (const std::string& name : names) {
    CAPTURE(name);
    const std::string before = svg_of(name);
    CHECK(test::words_of_gnuplot(drawn(), name).empty());
    CHECK(plot::svg_of(plot::drawing_of_gnuplot(svg_of(name))) == before);
    test::check_legible(before);
    std::ofstream(drawn() / (name + ".svg")) << before;  // as it was
    CHECK(test::read_file(drawn() / "tex" / (name + ".tex")).starts_with("\\begin{drawing}"));
  }
}

TEST_CASE("every failed setting of a chart is drawn, every reason told", "[report][accuracy]") {
  for (const Chart& chart : all_charts()) {
    CAPTURE(chart.name);
    const std::string svg = svg_of(chart.name);
    std::size_t failed = 0, defaults = 0;
    for (const Series& series : chart.series) {
      for (const Point& point : series.points) {
        failed += has_failed(point) ? 1 : 0;
        defaults += point.is_default ? 1 : 0;
      }
    }
    CHECK(crosses_in(svg) == failed * panels_of(chart));
    const std::vector<test::SvgText> texts = test::texts_of(svg);
    CHECK(test::has(texts, "failed") == (failed > 0));
    CHECK(test::has(texts, "default") == (defaults > 0));
  }
  CHECK(test::has(test::texts_of(svg_of("crowded")), "no convergence after 60 iterations"));
  CHECK(test::has(test::texts_of(svg_of("failed")), "singular matrix at setting n = 2"));
  CHECK(test::has(test::texts_of(svg_of("wide")), "its error is no number"));
}

TEST_CASE("every solved setting of a chart is drawn once in each panel where it has a cost",
          "[report][accuracy]") {
  // The first own method has round marks, the first of others hollow ones; the legend shows each
  // once, and a ring marks the default.
  const std::string svg = svg_of("plain");
  CHECK(discs_in(svg) == 2 * 8 + 1);
  CHECK(rings_in(svg) == 2 * 8 + 1 + 2 + 1);
  CHECK(discs_in(svg_of("untimed")) == 8 + 1);
  CHECK(discs_in(svg_of("uncounted")) == 8 + 1);
}

TEST_CASE("a chart names its methods, its scene, its reference and its levels",
          "[report][accuracy]") {
  const std::vector<test::SvgText> texts = test::texts_of(svg_of("plain"));
  for (const char* word :
       {"Integral of a polynomial", "a beam of three segments", "the antiderivative, long double",
        "largest relative error", "trapezoid", "Simpson", "evaluations", "time per integral",
        "round-off: 1.1e-16", "good enough for a strength check"}) {
    CAPTURE(word);
    CHECK(test::has(texts, word));
  }
  const std::vector<test::SvgText> crowded = test::texts_of(svg_of("crowded"));
  for (const Series& series : crowded_chart().series) CHECK(test::has(crowded, series.method));
  CHECK(test::has(crowded, "at 0: the same number as the reference"));
  CHECK(test::has(test::texts_of(svg_of("hostile")), "a_b^c{x}@d&e~f, '; system('touch x')"));
}

TEST_CASE("a guide falls by its order", "[report][accuracy]") {
  // A line of error ~ n^-p is straight on logarithmic axes, with slope -p in decades.
  Chart chart = invented_chart("guided");
  chart.guides = {{2.0, 0}, {4.0, 1}};
  const test::TemporaryFolder folder;
  draw_charts({{&charts::topics()[0], {{chart}, {}, ""}}}, folder.path().string());
  const std::string script = test::read_file(folder.path() / "plots/guided.gp");
  const auto number_behind = [&](const std::string& words) {
    const std::size_t at = script.find(words);
    REQUIRE(at != std::string::npos);
    return std::strtod(script.c_str() + at + words.size(), nullptr);
  };
  const auto range_of = [&](const std::string& axis) {
    std::smatch found;
    REQUIRE(std::regex_search(script, found,
                              std::regex("set " + axis + "range \\[([^:]+):([^\\]]+)\\]")));
    return std::log10(std::stod(found[2]) / std::stod(found[1]));
  };
  const double across =
      (number_behind("rmargin at screen ") - number_behind("lmargin at screen ")) / range_of("x");
  const double up =
      (number_behind("tmargin at screen ") - number_behind("bmargin at screen ")) / range_of("y");
  const std::regex line(
      "set arrow from screen ([^,]+),(\\S+) to screen ([^,]+),(\\S+) nohead lw 1 lc rgb '#404040'");
  std::vector<double> orders;
  for (std::sregex_iterator at(script.begin(), script.end(), line), end; at != end; ++at) {
    const double dx = (std::stod((*at)[3]) - std::stod((*at)[1])) / across;
    const double dy = (std::stod((*at)[4]) - std::stod((*at)[2])) / up;
    orders.push_back(-dy / dx);
  }
  REQUIRE(orders.size() == 2);
  CHECK(orders[0] == Approx(2.0).epsilon(0.01));
  CHECK(orders[1] == Approx(4.0).epsilon(0.01));
  const std::vector<test::SvgText> texts =
      test::texts_of(test::read_file(folder.path() / "guided.svg"));
  CHECK(test::has(texts, "order 2"));
  CHECK(test::has(texts, "order 4"));
}

TEST_CASE("every trial of a map is drawn in the colour and with the mark of its outcome",
          "[report][accuracy]") {
  for (const Map& map : all_maps()) {
    CAPTURE(map.name);
    const std::string svg = svg_of(map.name);
    std::size_t wrong = 0, refused = 0, solved = 0;
    for (const MapPanel& panel : map.panels) {
      wrong += panel.count(Outcome::wrong);
      refused += panel.count(Outcome::refused);
      solved += panel.count(Outcome::solved);
      CHECK(
          test::has(test::texts_of(svg), std::to_string(panel.count(Outcome::solved)) + " solved"));
    }
    // And one of each in the legend.
    CHECK(crosses_in(svg) == wrong + 1);
    CHECK(discs_in(svg) == refused + 1);
    CHECK(solved + wrong + refused == 120 * map.panels.size());
  }
}

TEST_CASE("the document of charts holds every picture and every reason, and judges nothing",
          "[report][accuracy]") {
  AccuracyRun run{all_topics(), true, true, {{"rig", std::string(64, 'a')}}};
  const report::Document document = accuracy_document(run);
  CHECK(document.verdict.empty());
  REQUIRE(document.chapters.size() == 4);
  CHECK(document.chapters[0].title == "Default settings");

  const std::string text = report::text_of(document);
  for (const char* words :
       {"Simpson's rule converges with the fourth order.", "no convergence after 60 iterations",
        "nearer than round-off", "Not applicable: the case has no elastic links",
        "quick: fewer settings", "rig, sha256 aaaa", "GCC", "Simpson, n = 32"}) {
    CAPTURE(words);
    CHECK(holds(text, words));
  }
  CHECK_FALSE(holds(text, "VERDICT"));
  // 32^-4 is 9.5e-7, below 1e-4.
  CHECK(std::regex_search(text, std::regex("plain .*9\\.5e-7 +1e-4 to 1e-3 +better")));

  const std::string page = report::html_of(document, [](const std::string& name) {
    return std::optional<std::string>(test::read_file(drawn() / (name + ".svg")));
  });
  CHECK_FALSE(holds(page, "Verdict"));
  CHECK_FALSE(holds(page, "input sha256"));
  const std::size_t pictures = all_charts().size() + all_maps().size();
  CHECK(holds(page, "Figure " + std::to_string(pictures) + "."));

  const std::string latex = report::latex_of(document, [](const std::string&) { return true; });
  CHECK_FALSE(holds(latex, "\n\\verdict{"));
  CHECK_FALSE(holds(latex, "\\signfield{prepared}"));

  // Where nothing was drawn the words stay.
  run.drawn = false;
  const std::string undrawn = report::text_of(accuracy_document(run));
  CHECK(holds(undrawn, "Simpson's rule converges with the fourth order."));
  CHECK_FALSE(holds(undrawn, ".svg"));
}

TEST_CASE("the terminal's table says how each default stands to what is needed",
          "[report][accuracy]") {
  Chart chart = invented_chart("standing");
  const auto standing = [&](double error) {
    chart.series[1].points[4].error = error;
    return accuracy_text({{&charts::topics()[0], {{chart}, {}, ""}}});
  };
  CHECK(holds(standing(0.0), "better"));
  CHECK(holds(standing(0.99e-4), "better"));
  CHECK(holds(standing(1e-4), "within"));
  CHECK(holds(standing(1e-3), "within"));
  CHECK(holds(standing(1.01e-3), "coarser"));
  chart.series[1].points[4].failure = "singular";
  CHECK(holds(standing(0.0), "failed"));
  chart.series[1].points[4].is_default = false;
  CHECK(holds(standing(0.0), "none"));
  const std::string maps =
      accuracy_text({{&charts::topics()[0], {{}, {invented_map("m", 2)}, ""}}});
  CHECK(holds(maps, "method 1 (for comparison)"));
}

}  // namespace accuracy_test
