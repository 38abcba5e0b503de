// Drawings: fewer strokes show the same, and what is written of a drawing is that drawing.

#include "src/report/drawing.hpp"

#include <cmath>

#include "catch.hpp"
#include "src/report/drawing_forms.hpp"

namespace drawing_test {

using namespace boxbeam::plot;

namespace {

const Pen red{"#ff0000", 2.0, {}, "", "beam"};
const Pen blue{"#0000ff", 1.0, {}, "", "rod"};

Line line(const Pixel& from, const Pixel& to, const Pen& pen) { return {{from, to}, pen}; }

double distance(const Pixel& p, const Pixel& a, const Pixel& b) {
  const Eigen::Vector2d way = b - a;
  const double part = std::clamp((p - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (p - a - part * way).norm();
}

}  // namespace

TEST_CASE("a simplified curve stays within its tolerance and keeps its ends and corners") {
  std::vector<Pixel> curve;
  for (int i = 0; i <= 400; ++i) curve.emplace_back(i, 100.0 * std::sin(0.02 * i));
  curve.emplace_back(400.0, 300.0);  // a corner
  constexpr double tolerance = 0.1;
  const std::vector<Pixel> fewer = simplified(curve, tolerance);
  CHECK(fewer.size() < curve.size() / 4);
  CHECK(fewer.front() == curve.front());
  CHECK(fewer.back() == curve.back());
  CHECK(fewer[fewer.size() - 2] == curve[curve.size() - 2]);
  for (const Pixel& point : curve) {
    double nearest = 1e300;
    for (std::size_t i = 1; i < fewer.size(); ++i)
      nearest = std::min(nearest, distance(point, fewer[i - 1], fewer[i]));
    CHECK(nearest <= tolerance * (1.0 + 1e-9));
  }
}

TEST_CASE("a straight line of many points is one of two, and a loop is not lost") {
  std::vector<Pixel> straight;
  for (int i = 0; i < 50; ++i) straight.emplace_back(i, 2.0 * i);
  CHECK(simplified(straight, 0.1).size() == 2);
  const std::vector<Pixel> loop{{0, 0}, {5, 0}, {5, 5}, {0, 5}, {0, 0}};
  CHECK(simplified(loop, 0.1) == loop);
}

TEST_CASE("lines of a pen become one stroke where nothing between them touches them") {
  Drawing drawing{100.0, 100.0, {}};
  drawing.shapes = {line({0, 0}, {10, 10}, red), line({50, 50}, {60, 60}, blue),
                    line({80, 0}, {90, 10}, red)};
  CHECK(in_few_strokes(drawing).size() == 2);
  // A blue line over the first and below the second red one must stay between them.
  drawing.shapes = {line({0, 0}, {10, 10}, red), line({0, 10}, {10, 0}, blue),
                    line({2, 0}, {8, 10}, red)};
  const std::vector<Mark> marks = in_few_strokes(drawing);
  REQUIRE(marks.size() == 3);
  CHECK(std::get<PenStroke>(marks[1]).pen == blue);
}

TEST_CASE("an SVG has a tenth of a pixel, y downwards, and words made safe") {
  Drawing drawing{100.0, 50.0, {}};
  drawing.shapes = {Line{{{1.04, 49.0}, {3.0, 49.0}, {3.0, 40.0}, {4.5, 38.5}}, red},
                    Words{{{"a < b"}}, {7.0, 8.0}, Anchor::right, "#aabbcc", ""}};
  const std::string svg = svg_of(drawing);
  CHECK(svg.find("viewBox=\"0 0 100 50\"") != std::string::npos);
  CHECK(svg.find("d=\"M1 1h2v9l1.5 1.5\"") != std::string::npos);
  CHECK(svg.find("<text x=\"7\" y=\"42\" text-anchor=\"end\" fill=\"#abc\">a &lt; b</text>") !=
        std::string::npos);
  const std::string in_page = svg_in_page(drawing, "class=\"mechanism\"");
  CHECK(in_page.starts_with("<svg class=\"mechanism\" viewBox=\"0 0 100 50\">"));
  CHECK(in_page.find("<path class=\"beam\"") != std::string::npos);
  CHECK(in_page.find("#f") == std::string::npos);  // colours are the page's
}

TEST_CASE("roundings of a long line do not add up") {
  Drawing drawing{1000.0, 10.0, {}};
  Line stairs{{}, red};
  for (int i = 0; i < 300; ++i) stairs.points.emplace_back(0.34 * i, i % 2 == 0 ? 0.0 : 5.0);
  drawing.shapes = {stairs};
  const std::string svg = svg_of(drawing);
  const std::size_t begin = svg.find("d=\"M0 10l") + 9;
  const std::string data = svg.substr(begin, svg.find('"', begin) - begin);
  double x = 0.0;
  const char* at = data.c_str();
  for (int k = 0; *at != '\0'; ++k) {
    char* end = nullptr;
    // ".3-5" are two numbers, as ".3.4" would be.
    const double step = std::strtod(at, &end);
    REQUIRE(end != at);
    if (k % 2 == 0) x += step;
    at = end;
  }
  CHECK(x == Approx(0.34 * 299).margin(0.051));
}

TEST_CASE("what gnuplot's terminal writes is read as lines, areas, marks and words") {
  const std::string svg = R"svg(<?xml version="1.0" encoding="utf-8"  standalone="no"?>
<svg
 viewBox="0 0 620 100"
 xmlns="http://www.w3.org/2000/svg">
<title>Gnuplot</title>
<g id="gnuplot_canvas">
<rect x="0" y="0" width="620" height="100" fill="#ffffff"/>
<defs>
	<path id='gpPt0' stroke-width='0.222' stroke='currentColor' d='M-1,0 h2 M0,-1 v2'/>
</defs>
<g fill="none" color="black" stroke="currentColor" stroke-width="2.00" stroke-linecap="round">
	<path stroke='rgb( 11,  95, 165)' stroke-dasharray='4.0,2.0'  d='M10.00,20.00 L30.50,40.00 M5.00,5.00  '/>
	<g transform="translate(50.00,60.00)" stroke="none" fill="rgb(96,96,96)" font-family="DejaVu Sans" font-size="12.00"  text-anchor="end">
		<text><tspan font-family="DejaVu Sans" > 10</tspan><tspan font-family="DejaVu Sans"  font-size="9.6" dy="-6.00px">-4</tspan><tspan font-size="12.0" dy="6.00"></tspan></text>
	</g>
	<polygon fill = 'rgb(226, 226, 226)' points = '0.00,0.00 10.00,0.00 10.00,10.00'/>
	<use xlink:href='#gpPt6' transform='translate(70.00,30.00) scale(2.00)' color='rgb(200,  80,  10)'/>
	<use xlink:href='#gpPt1' transform='translate(90.00,30.00) scale(3.00)' color='rgb(  0,   0,   0)'/>
</g>
</g>
</svg>)svg";
  const Drawing drawing = drawing_of_gnuplot(svg);
  CHECK(drawing.width == 620.0);
  CHECK(drawing.height == 100.0);
  REQUIRE(drawing.shapes.size() == 6);
  const Line& first = std::get<Line>(drawing.shapes[0]);
  CHECK(first.points == std::vector<Pixel>{{10.0, 80.0}, {30.5, 60.0}});
  CHECK(first.pen == Pen{"#0b5fa5", 2.0, {4.0, 2.0}, "", ""});
  const Words& words = std::get<Words>(drawing.shapes[1]);
  REQUIRE(words.runs.size() == 2);
  CHECK(words.runs[0].text == "10");
  CHECK(words.runs[1].text == "-4");
  CHECK(words.runs[1].rise == 6.0);
  CHECK(words.at == Pixel(50.0, 40.0));
  CHECK(words.anchor == Anchor::right);
  CHECK(words.colour == "#606060");
  CHECK(std::get<Line>(drawing.shapes[2]).pen.fill == "#e2e2e2");
  const Dot& disc = std::get<Dot>(drawing.shapes[3]);
  CHECK(disc.at == Pixel(70.0, 70.0));
  CHECK(disc.pen.fill == "#c8500a");
  // Its stroke of 0.222 sizes lies half outside.
  CHECK(disc.radius == Approx(2.0 + 0.5 * 0.222 * 2.0));
  const Line& cross = std::get<Line>(drawing.shapes[4]);
  CHECK((cross.points[1] - cross.points[0]).norm() == Approx(std::sqrt(8.0) * 3.0));
}

TEST_CASE("an element that gnuplot's terminal is not known to write is refused") {
  CHECK_THROWS_WITH(drawing_of_gnuplot("<svg viewBox=\"0 0 10 10\"><image width=\"3\"/></svg>"),
                    Catch::Contains("<image>"));
}

TEST_CASE("a drawing in LaTeX has its lines as operators of PDF and its words escaped") {
  Drawing drawing{620.0, 50.0, {}};
  drawing.shapes = {
      Line{{{1.0, 2.0}, {3.0, 4.0}, {5.0, 2.0}}, {"#ff0000", 2.0, {3.0}, "#00ff00", ""}, true},
      Words{{{"50 % of M"}, {"y", 9.6, -2.0}}, {7.0, 8.0}, Anchor::middle, "#aabbcc", ""}};
  const std::string latex = latex_of(drawing);
  CHECK(latex.starts_with("\\begin{drawing}{620}{50}\n"));
  CHECK(latex.find("\\strokes{0 1 0 rg 1 0 0 RG 2 w [3 ] 0 d\n1 2 m 3 4 l 5 2 l h\nB}") !=
        std::string::npos);
  CHECK(latex.find("\\words{7}{8}{c}{aabbcc}{50~\\%~of~M\\run{-2}{9.6}{y}}") != std::string::npos);
}

}  // namespace drawing_test
