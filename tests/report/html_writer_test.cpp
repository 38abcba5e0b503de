// A report as one HTML file: all of the document is in it, as it was written, and nothing is
// fetched.

#include "boxbeam/report/html_writer.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

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
  document.chapters = {{text,
                        {Paragraph{text}, Bullets{{text}}, report::Facts{{{text, text}}}, table,
                         Picture{"drawn", text}, sheet, Listing{text}, Subheading{text},
                         MovingPicture{{turning_beam(text)}, 0, text}}}};
  return document;
}

nlohmann::json cycle_data(const test::Markup& page) {
  for (const test::Element& script : test::elements_named(page, "script")) {
    if (script.attributes.count("type") == 0) continue;
    const nlohmann::json all = nlohmann::json::parse(script.text);
    return all.at("situations").at(all.at("first").get<std::size_t>());
  }
  return {};
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

TEST_CASE("the moving picture has the places and forces of its frames to five digits") {
  const CycleFigure cycle = turning_beam("P");
  Document document;
  document.chapters = {{"", {MovingPicture{{cycle}, 0, "Turning."}}}};
  const test::Markup page = test::read_markup(html_of(document, no_pictures));
  const nlohmann::json data = cycle_data(page);
  const nlohmann::json& mechanism = data["mechanism"];
  CHECK(mechanism["space"] == false);
  CHECK(data["repeats"] == true);
  CHECK(data["frame"] == 3);  // of the largest moment
  CHECK(data["station"] == 0);
  REQUIRE(data["cut"].size() == 3);  // N, V, M
  for (std::size_t f = 0; f < cycle.frames.size(); ++f) {
    const CycleFrame& frame = cycle.frames[f];
    CHECK(data["times"][f].get<double>() == Approx(frame.time.value()));
    // Points of the beam, its stroke, the rod, the guide and its direction, the ground.
    const double digit = mechanism["digit"];
    const double of_guide = mechanism["guideDigit"];
    const Eigen::Vector3d& end = frame.posture.bodies[0].points[1];
    const std::vector<double> places{0.0,
                                     0.0,
                                     end.x(),
                                     end.y(),
                                     0.0,
                                     0.0,
                                     end.x(),
                                     end.y(),
                                     end.x(),
                                     end.y(),
                                     3.0,
                                     -1.0,
                                     end.x(),
                                     end.y(),
                                     0.6 * digit / of_guide,
                                     0.8 * digit / of_guide,
                                     0.0,
                                     0.0};
    REQUIRE(mechanism["frames"][f].size() == places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      CHECK(mechanism["frames"][f][i].get<double>() * digit == Approx(places[i]).margin(6e-5));
    }
    const nlohmann::json& load = data["loads"]["frames"][f][0];
    CHECK(load[4].get<double>() * data["loads"]["digit"].get<double>() ==
          Approx(1e-3 * frame.posture.loads[0].world.y()).epsilon(1e-4));
    constexpr cut_force::Index order[] = {cut_force::N, cut_force::V_z, cut_force::M_y};
    for (std::size_t q = 0; q < 3; ++q) {
      const nlohmann::json& cut = data["cut"][q];
      for (std::size_t i = 0; i < 2; ++i) {
        CHECK(cut["frames"][f][i].get<double>() * cut["digit"].get<double>() ==
              Approx(1e-3 * value_of(frame.values[i], order[q])).margin(1e-5));
      }
    }
  }
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
  std::size_t rings = 0;
  for (const test::Element& path : test::elements_named(page, "path")) {
    if (path.attributes.at("class") != "couple") continue;
    ++rings;
    // Clockwise on a drawing whose y points down: the sweep of its arc is 1.
    CHECK(path.attributes.at("d").find(" 0 1 1 ") != std::string::npos);
  }
  CHECK(rings == 1);
  CHECK(test::elements_named(page, "text").at(0).text == "P  2.500 kN m");
  const nlohmann::json loads = cycle_data(page)["loads"];
  CHECK(loads["frames"][0][0][5].get<double>() * loads["coupleDigit"].get<double>() ==
        Approx(-2.5).epsilon(1e-4));
}

TEST_CASE("without script the mechanism is drawn as it stands at the largest moment") {
  const CycleFigure cycle = turning_beam("P");
  Document document;
  document.chapters = {{"", {MovingPicture{{cycle}, 0, "Turning."}}}};
  const test::Markup page = test::read_markup(html_of(document, no_pictures));
  const std::vector<test::Element> lines = test::elements_named(page, "line");
  const auto beam = std::find_if(lines.begin(), lines.end(), [](const test::Element& line) {
    return line.attributes.at("class") == "beam";
  });
  REQUIRE(beam != lines.end());
  const auto number = [&](const char* name) { return std::stod(beam->attributes.at(name)); };
  // The last frame, 1.2 rad; the y axis of a drawing points down. One decimal is written.
  const double angle = std::atan2(number("y1") - number("y2"), number("x2") - number("x1"));
  CHECK(angle == Approx(1.2).margin(0.002));
  CHECK(test::elements_named(page, "text").at(0).text == "P  4.938 kN");
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
