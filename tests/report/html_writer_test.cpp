// A report as one HTML file: all of the document is in it, as it was written, and nothing is
// fetched.

#include "boxbeam/report/html_writer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "boxbeam/report/report.hpp"
#include "catch.hpp"
#include "support/markup.hpp"
#include "support/program.hpp"
#include "support/property.hpp"

namespace html_writer_test {

using namespace boxbeam;
using namespace boxbeam::report;

namespace {

std::optional<std::string> no_pictures(const std::string&) { return {}; }

/// A beam that turns about its start, pushed at its end; four instants.
CycleFigure turning_beam(const std::string& load) {
  CycleFigure cycle;
  cycle.stations = {{si<Length>(0.0), Side::behind}, {si<Length>(2.0), Side::before}};
  for (int i = 0; i < 4; ++i) {
    const double angle = 0.4 * i;
    const Eigen::Vector3d end(2.0 * std::cos(angle), 2.0 * std::sin(angle), 0.0);
    CycleFrame frame;
    frame.time = si<Time>(0.25 * i);
    PostureFigure::Line beam;
    beam.beam = true;
    beam.points = {Eigen::Vector3d::Zero(), end};
    beam.strokes = {{Eigen::Vector3d::Zero(), end}};
    frame.posture.bodies = {beam};
    frame.posture.rods = {{end, Eigen::Vector3d(3.0, -1.0, 0.0)}};
    frame.posture.guides = {{end, Eigen::Vector3d(0.6, 0.8, 0.0)}};
    frame.posture.grounds = {Eigen::Vector3d::Zero()};
    BeamLoadRow row;
    row.name = load;
    row.place = end;
    row.world = Eigen::Vector3d(0.0, -1234.5 * (i + 1), 0.0);
    frame.posture.loads = {row};
    for (int k = 0; k < 2; ++k) {
      CutForces cut{};
      cut.N = si<Force>(100.0 * i);
      cut.V_z = si<Force>(-50.0);
      cut.M_y = si<Moment>(k == 0 ? 1000.0 * i : 0.0);
      frame.values.push_back(cut);
    }
    cycle.frames.push_back(frame);
  }
  cycle.smallest = cycle.frames.front().values;
  cycle.largest = cycle.frames.back().values;
  return cycle;
}

/// A document with every kind of block, in all of whose texts the same stands.
Document full_of(const std::string& text) {
  Document document;
  document.title = document.subtitle = document.date = document.program = text;
  document.input_sha256 = document.verdict = text;
  document.mark = Mark::fails;
  document.facts.entries = {{text, text}};
  Table table;
  table.caption = text;
  table.header = {text, "value"};
  table.rows = {{{text, {}}, {"1.5", 1.5}}, {{"second", {}}, {"-2", -2.0}}};
  table.marks = {Mark::fails, Mark::passes};
  table.sheets = {text, ""};
  document.governing = table;
  const Sheet sheet{text, text, {{"sigma", {"N/A", text}, {text}}}, text, 1.65, Mark::fails, text};
  report::DesignTable designs;
  designs.rows = {
      2,
      {1, 2},
      {{{text, text}, true, {1.0, 2.0}, {}}, {{"verdict", ""}, false, {}, {text, "pass"}}}};
  designs.caption = designs.x = text;
  document.chapters = {{text,
                        {Paragraph{text}, Bullets{{text}}, report::Facts{{{text, text}}}, table,
                         Picture{"drawn", text}, sheet, Listing{text}, Subheading{text},
                         MovingPicture{{turning_beam(text)}, 0, text}, designs}}};
  return document;
}

/// The steps of a row added to the row before.
void add(nlohmann::json& row, const nlohmann::json& before, std::size_t first) {
  for (std::size_t i = first; i < row.size(); ++i) {
    if (row[i].is_number()) row[i] = row[i].get<long>() + before[i].get<long>();
  }
}

nlohmann::json cycle_data(const test::Markup& page) {
  for (const test::Element& script : test::elements_named(page, "script")) {
    if (script.attributes.count("type") == 0) continue;
    const nlohmann::json all = nlohmann::json::parse(script.text);
    nlohmann::json data = all.at("situations").at(all.at("first").get<std::size_t>());
    for (nlohmann::json& view : data["views"]) {
      nlohmann::json& frames = view["frames"];
      for (std::size_t f = 1; f < frames.size(); ++f) {
        const bool alike =
            std::equal(frames[f].begin(), frames[f].end(), frames[f - 1].begin(),
                       frames[f - 1].end(), [](const nlohmann::json& a, const nlohmann::json& b) {
                         return a[0] == b[0] && a.size() == b.size();
                       });
        for (std::size_t i = 0; alike && i < frames[f].size(); ++i)
          add(frames[f][i], frames[f - 1][i], 1);
      }
    }
    for (nlohmann::json& cut : data["diagrams"]["cut"]) {
      for (std::size_t f = 1; f < cut["frames"].size(); ++f)
        add(cut["frames"][f], cut["frames"][f - 1], 0);
    }
    return data;
  }
  return {};
}

/// The places of the first shape of a kind in a frame: x, y, ...
std::vector<double> places_of(const test::Markup& page, const nlohmann::json& frame,
                              const std::string& kind) {
  for (const test::Element& script : test::elements_named(page, "script")) {
    if (script.attributes.count("type") == 0) continue;
    const nlohmann::json kinds = nlohmann::json::parse(script.text).at("kinds");
    for (const nlohmann::json& shape : frame) {
      const nlohmann::json& of = kinds.at(shape.at(0).get<std::size_t>());
      if (of.at(0) != kind) continue;
      std::vector<double> places;
      for (std::size_t i = 1; i < shape.size(); ++i) places.push_back(0.1 * shape[i].get<double>());
      std::istringstream steps(of.at(1).get<std::string>().erase(0, 1));  // of an outline
      for (double step = 0.0; steps >> step;) places.push_back(places[places.size() - 2] + step);
      return places;
    }
  }
  FAIL("nothing is drawn of the kind " + kind);
  return {};
}

bool has_text(const test::Markup& page, const std::string& words) {
  const std::vector<test::Element> texts = test::elements_named(page, "text");
  return std::any_of(texts.begin(), texts.end(),
                     [&](const test::Element& text) { return text.text == words; });
}

}  // namespace

TEST_CASE("the page is well-formed and shows hostile strings as they were written") {
  // What ends elements, attributes, comments, scripts and character data.
  const std::string hostile =
      GENERATE("<script>alert(1)</script>", "\"><img src=x onerror=alert(1)>", "' onload='x", "]]>",
               "-->", "</style></title></table>", "&amp; &lt; &#65; &nosuch;", "a & b < c > d",
               "caf\xC3\xA9 \xC3\xB8 \xC5\x82 \xCE\xA3 \xE4\xB8\xAD \xF0\x9F\x94\xA9",
               "{{x}} ${x} `x`", "\\u003c/script>", "javascript:alert(1)", "O'Hara \"x\"");
  const auto pictures = [](const std::string&) { return std::optional<std::string>("<svg/>"); };
  const std::string page = html_of(full_of(hostile), pictures);
  const test::Markup markup = test::read_markup(page);
  CAPTURE(hostile);
  REQUIRE(markup.fault.empty());

  // The same elements as for a harmless text, and no attribute that runs something.
  const test::Markup plain = test::read_markup(html_of(full_of("plain"), pictures));
  const auto structure = [](const test::Markup& of) {
    std::vector<std::string> names;
    for (const test::Element& element : of.elements) {
      if (element.name.starts_with("m")) continue;  // formulas differ
      std::string name = element.name;
      for (const auto& attribute : element.attributes) name += " " + attribute.first;
      names.push_back(name);
    }
    return names;
  };
  CHECK(structure(markup) == structure(plain));

  for (const char* name : {"h1", "dd", "dt", "h3", "a", "code", "pre"}) {
    CAPTURE(name);
    const std::vector<test::Element> found = test::elements_named(markup, name);
    CHECK(std::any_of(found.begin(), found.end(), [&](const test::Element& element) {
      return element.text.find(hostile) != std::string::npos;
    }));
  }
  CHECK(cycle_data(markup)["loads"]["names"][0] == hostile);
}

TEST_CASE("what cannot be seen is shown as its code") {
  const auto shown = [](const std::string& text) {
    Document document;
    document.title = text;
    const test::Markup page = test::read_markup(html_of(document, no_pictures));
    REQUIRE(page.fault.empty());
    return test::elements_named(page, "h1").at(0).text;
  };
  CHECK(shown(std::string("a\x07") + "b\x1b[31m") == "a\\x07b\\x1B[31m");
  CHECK(shown(std::string("a\0b", 3)) == "a\\x00b");
  CHECK(shown("\x7f\xc2\x85") == "\\x7F\\x85");
  CHECK(shown("\xff\xc0\x80") == "\\xFF\\xC0\\x80");  // no UTF-8
  CHECK(shown("\xe2\x80\xae"
              "fdp") == "\\u202Efdp");             // right-to-left override
  CHECK(shown("\xef\xbf\xbe") == "\\uFFFE");       // no character of XML
  CHECK(shown("\xe2\x80\x8d") == "\xe2\x80\x8d");  // joins letters
}

TEST_CASE("any bytes make a well-formed page") {
  test::holds([](const std::string& text) {
    Document document;
    document.title = text;
    document.chapters = {{text, {Listing{text}, Picture{"x", text}}}};
    const auto picture = [&](const std::string&) { return std::optional<std::string>(text); };
    RC_ASSERT(test::read_markup(html_of(document, picture)).fault.empty());
  });
}

TEST_CASE("pictures stand inside the page in base64") {
  // RFC 4648, 10.
  const auto [bytes, code] = GENERATE(table<std::string, std::string>({{"", ""},
                                                                       {"f", "Zg=="},
                                                                       {"fo", "Zm8="},
                                                                       {"foo", "Zm9v"},
                                                                       {"foob", "Zm9vYg=="},
                                                                       {"fooba", "Zm9vYmE="},
                                                                       {"foobar", "Zm9vYmFy"}}));
  Document document;
  document.chapters = {{"", {Picture{"missing", "no"}, Picture{"drawn", "Seen"}}}};
  const std::string svg = bytes;
  const auto pictures = [&](const std::string& name) {
    return name == "drawn" ? std::optional<std::string>(svg) : std::nullopt;
  };
  const test::Markup page = test::read_markup(html_of(document, pictures));
  const std::vector<test::Element> images = test::elements_named(page, "img");
  REQUIRE(images.size() == 1);
  CHECK(images[0].attributes.at("src") == "data:image/svg+xml;base64," + code);
  CHECK(images[0].attributes.at("alt") == "Seen");
  CHECK(test::elements_named(page, "figcaption").at(0).text == "Figure 1. Seen");
}

TEST_CASE("a table is folded where its maker says so, however long it is") {
  Document document;
  const std::vector<report::Cell> row{report::Cell{"1", {}}};
  Table few{"few", {"a"}, {row, row}, {}};
  const Table many{"many", {"a"}, {99, row}, {}};
  few.folded = true;
  document.chapters = {{"", {few, many}}};
  const test::Markup page = test::read_markup(html_of(document, no_pictures));
  const std::vector<test::Element> folded = test::elements_named(page, "summary");
  REQUIRE(folded.size() == 1);
  CHECK(folded[0].text == "few 2 rows");
}

TEST_CASE("a page of a shipped case holds all numbers, links to itself only and is not large") {
  const std::string path =
      GENERATE(as<std::string>{}, "sections/sledge-rig/rig.toml", "sections/landing-gear/gear.toml",
               "sections/drill-truck/truck.toml");
  CAPTURE(path);
  const Project project = read_project(test::project_file(path));
  const Document document = report_of(project, verify(project, Figures::with), ReportLevel::full);
  const std::string text = html_of(document, no_pictures);
  const test::Markup page = test::read_markup(text);
  REQUIRE(page.fault.empty());

  // Every cell of every table, in order.
  std::vector<std::string> cells;
  const auto add = [&](const Table& table) {
    for (const auto& row : table.rows) {
      for (const report::Cell& cell : row) cells.push_back(cell.text);
    }
  };
  add(document.governing);
  std::size_t sheets = 0;
  for (const Chapter& chapter : document.chapters) {
    for (const Block& block : chapter.blocks) {
      if (const auto* table = std::get_if<Table>(&block)) add(*table);
      if (std::holds_alternative<Sheet>(block)) ++sheets;
    }
  }
  std::size_t found = 0;
  std::size_t values = 0;
  std::set<std::string> ids;
  std::set<std::string> targets;
  for (const test::Element& element : page.elements) {
    const auto of = [&](const char* name) {
      const auto at = element.attributes.find(name);
      return at == element.attributes.end() ? std::string() : at->second;
    };
    if ((element.name == "td" || of("scope") == "row") && found < cells.size() &&
        element.text == cells[found]) {
      ++found;
    }
    if (!of("data-value").empty()) ++values;
    if (!of("id").empty()) CHECK(ids.insert(of("id")).second);
    for (const char* name : {"href", "src"}) {
      const std::string address = of(name);
      if (address.empty() || address.starts_with("data:")) continue;
      CHECK(address.front() == '#');
      targets.insert(address.substr(1));
    }
  }
  CHECK(found == cells.size());
  CHECK(values > 100);
  for (const std::string& target : targets) CHECK(ids.count(target) == 1);
  for (const char* fetched : {"http:", "https:", "url(", "@import", "import("}) {
    CHECK(text.find(fetched) == std::string::npos);
  }
  for (std::size_t i = 1; i <= sheets; ++i) CHECK(ids.count("sheet-" + std::to_string(i)) == 1);
  for (std::size_t i = 1; i <= document.governing.rows.size(); ++i) {
    CHECK(targets.count("sheet-" + std::to_string(i)) == 1);
  }

  // What the drawing needs, in a size that a page can carry: so much for every situation offered.
  std::size_t offered = 0;
  for (const Situation& situation : project.situations) offered += situation.between.empty();
  for (const test::Element& script : test::elements_named(page, "script")) {
    if (script.attributes.count("type") == 1)
      CHECK(script.text.size() < 150'000 * std::max<std::size_t>(1, offered));
  }
}

TEST_CASE("the moving picture has its places to a tenth of a pixel and its forces to five digits") {
  const CycleFigure cycle = turning_beam("P");
  Document document;
  document.chapters = {{"", {MovingPicture{{cycle}, 0, "Turning."}}}};
  const test::Markup page = test::read_markup(html_of(document, no_pictures));
  const nlohmann::json data = cycle_data(page);
  REQUIRE(data["views"].size() == 1);  // in the plane
  const nlohmann::json& frames = data["views"][0]["frames"];
  CHECK(data["repeats"] == true);
  CHECK(data["frame"] == 3);  // of the largest moment
  CHECK(data["station"] == 0);
  const nlohmann::json& diagrams = data["diagrams"];
  REQUIRE(diagrams["cut"].size() == 3);  // N, V, M
  // One scale for all: the beam is 2 m long and begins on the ground.
  const std::vector<double> still = places_of(page, frames[0], "beam");
  REQUIRE(still.size() == 4);
  const double scale = 0.5 * std::hypot(still[2] - still[0], still[3] - still[1]);
  CHECK(scale > 50.0);
  for (std::size_t f = 0; f < cycle.frames.size(); ++f) {
    const CycleFrame& frame = cycle.frames[f];
    CHECK(data["times"][f].get<double>() == Approx(frame.time.value()));
    const auto check = [&](const std::vector<double>& drawn, std::size_t i, double x, double y) {
      CHECK(drawn.at(2 * i) == Approx(still[0] + scale * x).margin(0.2));
      CHECK(drawn.at(2 * i + 1) == Approx(still[1] - scale * y).margin(0.2));
    };
    const Eigen::Vector3d& end = frame.posture.bodies[0].points[1];
    check(places_of(page, frames[f], "beam"), 0, 0.0, 0.0);
    check(places_of(page, frames[f], "beam"), 1, end.x(), end.y());
    check(places_of(page, frames[f], "joint"), 0, 0.0, 0.0);
    check(places_of(page, frames[f], "rod"), 0, end.x(), end.y());
    check(places_of(page, frames[f], "rod"), 1, 3.0, -1.0);
    check(places_of(page, frames[f], "ground"), 0, 0.0, 0.0);
    // A guide has no end: it goes as far to both sides, in its direction.
    const std::vector<double> guide = places_of(page, frames[f], "guide");
    CHECK((guide[3] - guide[1]) / (guide[2] - guide[0]) == Approx(-0.8 / 0.6).epsilon(0.01));
    CHECK(0.5 * (guide[0] + guide[2]) == Approx(still[0] + scale * end.x()).margin(0.2));
    // The force pulls downwards: its arrow comes from above and ends where it acts.
    check(places_of(page, frames[f], "head"), 0, end.x(), end.y());
    const std::vector<double> arrow = places_of(page, frames[f], "load");
    CHECK(arrow[1] < arrow[3]);
    CHECK(arrow[0] == Approx(arrow[2]).margin(0.11));
    CHECK(data["loads"]["frames"][f][0][1].get<double>() ==
          Approx(-1e-3 * frame.posture.loads[0].world.y()).epsilon(1e-3));
    constexpr cut_force::Index order[] = {cut_force::N, cut_force::V_z, cut_force::M_y};
    for (std::size_t q = 0; q < 3; ++q) {
      const nlohmann::json& cut = diagrams["cut"][q];
      for (std::size_t i = 0; i < 2; ++i) {
        CHECK(cut["frames"][f][i].get<double>() * cut["digit"].get<double>() ==
              Approx(1e-3 * value_of(frame.values[i], order[q])).margin(1e-5));
      }
    }
  }
}

TEST_CASE("the diagrams' paper holds every value of the cycle") {
  Document document;
  document.chapters = {{"", {MovingPicture{{turning_beam("P")}, 0, "Turning."}}}};
  const test::Markup page = test::read_markup(html_of(document, no_pictures));
  const nlohmann::json diagrams = cycle_data(page)["diagrams"];
  const double height = diagrams["height"];
  double above = 0.0;
  for (const nlohmann::json& cut : diagrams["cut"]) {
    double top = 1e300;
    double bottom = -1e300;
    for (const char* line : {"low", "high"}) {
      for (const nlohmann::json& value : cut[line]) {
        const double y =
            cut["zero"].get<double>() - cut["scale"].get<double>() * value.get<double>();
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
    }
    CHECK(top > above);  // each below the one before
    CHECK(bottom < 10.0 * height);
    CHECK(std::max(bottom, cut["zero"].get<double>()) - std::min(top, cut["zero"].get<double>()) ==
          Approx(920.0).margin(2.0));
    above = bottom;
  }
  CHECK(diagrams["x"].size() == 2);
}

TEST_CASE("every situation has its data, and the page begins with the one that it is told") {
  CycleFigure first = turning_beam("P");
  CycleFigure second = turning_beam("Q");
  first.situation = "running";
  second.situation = "landing";
  second.repeats = false;
  Document document;
  document.chapters = {{"", {MovingPicture{{first, second}, 1, "Turning."}}}};
  const test::Markup page = test::read_markup(html_of(document, no_pictures));
  const nlohmann::json data = cycle_data(page);  // of the one that it begins with
  CHECK(data["situation"] == "landing");
  CHECK(data["repeats"] == false);
  CHECK(data["loads"]["names"][0] == "Q");
  for (const test::Element& script : test::elements_named(page, "script")) {
    if (script.attributes.count("type") == 0) continue;
    const nlohmann::json all = nlohmann::json::parse(script.text);
    REQUIRE(all["situations"].size() == 2);
    CHECK(all["situations"][0]["situation"] == "running");
    CHECK(all["situations"][0]["repeats"] == true);
  }
}

TEST_CASE("a couple is drawn as an arrow around its place, with its size") {
  CycleFigure cycle = turning_beam("P");
  for (CycleFrame& frame : cycle.frames) frame.posture.loads[0].couple.z() = -2500.0;
  cycle.frames[3].posture.loads[0].world.setZero();
  Document document;
  document.chapters = {{"", {MovingPicture{{cycle}, 0, "Turning."}}}};
  const test::Markup page = test::read_markup(html_of(document, no_pictures));
  const nlohmann::json data = cycle_data(page);
  const std::vector<double> ring = places_of(page, data["views"][0]["frames"][3], "couple");
  REQUIRE(ring.size() >= 8);
  // Clockwise on a drawing whose y points down: each place is to the right of the way to it.
  double turned = 0.0;
  for (std::size_t i = 0; i + 5 < ring.size(); i += 2) {
    turned += (ring[i + 2] - ring[i]) * (ring[i + 5] - ring[i + 3]) -
              (ring[i + 3] - ring[i + 1]) * (ring[i + 4] - ring[i + 2]);
  }
  CHECK(turned > 0.0);
  CHECK(has_text(page, "P  2.500 kN m"));
  CHECK(data["loads"]["frames"][0][0][2].get<double>() == Approx(2.5).epsilon(1e-4));
}

TEST_CASE("without script the mechanism is drawn as it stands at the largest moment") {
  const CycleFigure cycle = turning_beam("P");
  Document document;
  document.chapters = {{"", {MovingPicture{{cycle}, 0, "Turning."}}}};
  const test::Markup page = test::read_markup(html_of(document, no_pictures));
  const std::vector<test::Element> paths = test::elements_named(page, "path");
  const auto beam = std::find_if(paths.begin(), paths.end(), [](const test::Element& path) {
    return path.attributes.at("class") == "beam";
  });
  REQUIRE(beam != paths.end());
  const std::string way = beam->attributes.at("d");
  double across = 0.0;
  double down = 0.0;
  REQUIRE(std::sscanf(way.c_str() + way.find('l'), "l%lf%lf", &across, &down) == 2);
  // The last frame, 1.2 rad; the y axis of a drawing points down. One decimal is written.
  CHECK(std::atan2(-down, across) == Approx(1.2).margin(0.002));
  CHECK(has_text(page, "P  4.938 kN"));
  CHECK(test::elements_named(page, "noscript").size() == 1);
}

TEST_CASE("the bar of a sheet is drawn to 200 %, and words say what its colour says") {
  const auto [utilisation, width, style] = GENERATE(
      table<double, std::string, std::string>({{0.0, "width:0.00%", "bar fails"},
                                               {1.0, "width:50.00%", "bar fails"},
                                               {1.65, "width:82.50%", "bar fails"},
                                               {7.0, "width:100.00%", "bar fails beyond"}}));
  Document document;
  document.chapters = {
      {"", {Sheet{"id", "title", {}, "utilisation", utilisation, Mark::fails, ""}}}};
  const test::Markup page = test::read_markup(html_of(document, no_pictures));
  bool drawn = false;
  for (const test::Element& element : page.elements) {
    const auto of = element.attributes.find("style");
    if (of != element.attributes.end()) drawn = drawn || of->second == width;
  }
  CHECK(drawn);
  CHECK(test::elements_named(page, "h3").at(0).text == "title FAILS");
}

}  // namespace html_writer_test
