#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/shear_flow.hpp"
#include "boxbeam/section/torsion.hpp"
#include "charts/stress_function.hpp"
#include "charts/topics.hpp"
#include "charts/trials.hpp"

namespace boxbeam::charts {
namespace {

using std::numbers::pi;

/// A rectangular box of one wall [m].
struct PlainBox {
  double width = 0.4, height = 1.0, wall = 0.01;
};

Box box_of(const PlainBox& of) {
  return symmetric_box(si<Length>(of.width), si<Length>(of.height), si<Length>(of.wall),
                       si<Length>(of.wall));
}

/// The box nearest to a beam's section: the first box or rectangular tube of it, with its thinnest
/// wall.
std::optional<PlainBox> box_in(const TaperedBeam& beam) {
  for (const Segment& segment : beam.segments) {
    const Profile& profile = segment.from.outer;
    if (const auto* box = std::get_if<Box>(&profile)) {
      const Length wall =
          std::min({box->top_flange, box->bottom_flange, box->left_web, box->right_web});
      return PlainBox{box->width.value(), box->height.value(), wall.value()};
    }
    if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
      return PlainBox{tube->width.value(), tube->height.value(), tube->wall.value()};
    }
  }
  return std::nullopt;
}

/// The same outside with another ratio of its smaller side to the wall.
PlainBox with_ratio(PlainBox box, double ratio) {
  box.wall = std::min(box.width, box.height) / ratio;
  return box;
}

double ratio_of(const PlainBox& box) { return std::min(box.width, box.height) / box.wall; }

// ---- what is computed, exactly and by the formulas of thin walls -----------------------------

/// In long double by closed forms.
struct Exact {
  long double I, W, shear;  ///< second moment, section modulus, S/(I b) at the neutral axis
};

Exact exact_of(const PlainBox& of) {
  const long double b = of.width, h = of.height, t = of.wall;
  const long double c = b - 2 * t, d = h - 2 * t;  // clear
  const long double I = (b * h * h * h - c * d * d * d) / 12;
  const long double S = b * t * (h - t) / 2 + t * d * d / 4;
  return {I, 2 * I / h, S / (I * 2 * t)};
}

/// By mid-lines.
struct Thin {
  double I, W, shear, I_T;
};

Thin thin_of(const PlainBox& of) {
  const double t = of.wall, b = of.width - t, h = of.height - t;
  const double I = t * h * h * (b / 2.0 + h / 6.0);
  const double S = t * h * (b / 2.0 + h / 4.0);
  return {I, 2.0 * I / h, S / (I * 2.0 * t), 2.0 * t * b * b * h * h / (b + h)};
}

double relative(double value, long double truth) {
  return static_cast<double>(std::abs(static_cast<long double>(value) / truth - 1.0L));
}

/// A box as a polygon with a hollow.
Section polygon_of(const PlainBox& of) {
  const auto rectangle = [](double b, double h) {
    const auto corner = [&](double y, double z) {
      return SectionPlace{si<Length>(y * b), si<Length>(z * h)};
    };
    return std::vector{corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5), corner(-0.5, -0.5)};
  };
  const double two = 2.0 * of.wall;
  return {Polygon{rectangle(of.width, of.height), {rectangle(of.width - two, of.height - two)}},
          {}};
}

/// Four plates along their mid-lines; the webs butt against the flanges.
ThinWalled walls_of(const PlainBox& of) {
  const double y = 0.5 * (of.width - of.wall), z = 0.5 * (of.height - of.wall);
  const auto node = [](double at_y, double at_z) {
    return SectionPlace{si<Length>(at_y), si<Length>(at_z)};
  };
  const Length t = si<Length>(of.wall), none{};
  const Length half = 0.5 * t, out = -0.5 * t;
  return {{node(-y, -z), node(y, -z), node(y, z), node(-y, z)},
          {{0, 1, t, out, out}, {1, 2, t, half, half}, {2, 3, t, out, out}, {3, 0, t, half, half}}};
}

/// The largest shear stress per V_z, at the middle of a web.
double flow_stress_of(const PlainBox& of) {
  const ShearFlow flow = *shear_flow_of({box_of(of), {}}, {}, {});
  for (std::size_t i = 0; i < flow.at.graph.walls.size(); ++i) {
    const Wall& wall = flow.at.graph.walls[i];
    if (wall.part == WallPart::left_web) {
      return std::abs(flow_at(flow, i, 0.5)[cut_force::V_z]) / wall.thickness;
    }
  }
  return 0.0;
}

// ---- over wall thickness ----------------------------------------------------------------------

std::vector<double> ratios_for(const Effort& effort, double own) {
  std::vector<double> ratios =
      effort.quick ? std::vector{5.0, 20.0, 100.0, 1000.0, 10000.0}
                   : std::vector{5.0,   7.0,   10.0,   20.0,   30.0,   50.0,   100.0,
                                 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10000.0};
  if (std::find(ratios.begin(), ratios.end(), own) == ratios.end()) ratios.push_back(own);
  std::sort(ratios.begin(), ratios.end());
  return ratios;
}

TriedMethod over_ratio(std::string method, bool yardstick, const PlainBox& own,
                       const std::vector<double>& ratios,
                       const std::function<double(const PlainBox&)>& compute,
                       const std::function<long double(const PlainBox&)>& truth) {
  TriedMethod tried{std::move(method), {}, yardstick};
  for (const double ratio : ratios) {
    const PlainBox box = with_ratio(own, ratio);
    Trial trial;
    trial.point.setting = fmt::format("b/t = {:g}", ratio);
    trial.point.parameter = ratio;
    trial.point.operations = ratio;
    trial.point.error = relative(compute(box), truth(box));
    trial.work = [compute, box] { keep(compute(box)); };
    tried.trials.push_back(std::move(trial));
  }
  return tried;
}

void mark_default(TriedMethod& method, double own) {
  for (Trial& trial : method.trials) trial.point.is_default = trial.point.parameter == own;
}

/// The smallest ratio from which on a series stays within an error; nothing where it never does.
std::optional<double> ratio_within(const Series& series, double error) {
  std::optional<double> from;
  for (auto point = series.points.rbegin(); point != series.points.rend(); ++point) {
    if (!(point->error <= error)) break;
    from = point->parameter;
  }
  return from;
}

std::string from_ratio(const Series& series, double error) {
  const auto from = ratio_within(series, error);
  return from ? fmt::format("from b/t = {:g} on", *from) : std::string("beyond what was tried");
}

Chart wall_chart(const PlainBox& own, const std::string& scene, const Effort& effort) {
  const std::vector<double> ratios = ratios_for(effort, ratio_of(own));
  const auto I = [](const PlainBox& of) { return exact_of(of).I; };
  const auto W = [](const PlainBox& of) { return exact_of(of).W; };
  const auto shear = [](const PlainBox& of) { return exact_of(of).shear; };
  std::vector<TriedMethod> methods;
  methods.push_back(over_ratio(
      "I_y from the border", false, own, ratios,
      [](const PlainBox& of) {
        return properties_of({box_of(of), {}}).I_y.value();
      },
      I));
  mark_default(methods[0], ratio_of(own));
  methods.push_back(over_ratio(
      "I_y as a polygon", false, own, ratios,
      [](const PlainBox& of) { return properties_of(polygon_of(of)).I_y.value(); }, I));
  methods.push_back(over_ratio(
      "I_y as four walls", false, own, ratios,
      [](const PlainBox& of) {
        return properties_of({walls_of(of), {}}).I_y.value();
      },
      I));
  methods.push_back(
      over_ratio("shear V S/(I b) along the walls", false, own, ratios, flow_stress_of, shear));
  methods.push_back(over_ratio(
      "I_y by mid-lines", true, own, ratios, [](const PlainBox& of) { return thin_of(of).I; }, I));
  methods.push_back(over_ratio(
      "W_y by mid-lines", true, own, ratios, [](const PlainBox& of) { return thin_of(of).W; }, W));
  methods.push_back(over_ratio(
      "shear V S/(I b) by mid-lines", true, own, ratios,
      [](const PlainBox& of) { return thin_of(of).shear; }, shear));
  Chart chart;
  chart.name = "section-walls";
  chart.title = "Section: bending and shear of thin and thick walls";
  chart.scene = scene;
  chart.error = "relative error of a section property";
  chart.reference = "closed form, long double";
  chart.operations = "width over wall thickness";
  chart.operations_cost = false;
  chart.unit = "one property of one section";
  chart.series = timed(methods, effort);
  chart.guides = {{2.0, 4}, {1.0, 5}};
  chart.floor = ErrorLevel{std::numeric_limits<double>::epsilon(), "round-off"};
  chart.lesson = fmt::format(
      "Formulas of mid-lines hold to 1e-3 {} for I_y, {} for W_y and {} for the shear stress; the "
      "border's integrals need no such limit and are used for every section.",
      from_ratio(chart.series[4], 1e-3), from_ratio(chart.series[5], 1e-3),
      from_ratio(chart.series[6], 1e-3));
  return chart;
}

Chart torsion_chart(const PlainBox& own, const std::string& scene, const Effort& effort) {
  constexpr int parts = 32;
  std::vector<double> ratios = effort.quick ? std::vector{3.0, 5.0, 20.0, 100.0}
                                            : std::vector{2.5,  3.0,  3.5,  4.0,   5.0,   7.0,
                                                          10.0, 20.0, 50.0, 100.0, 200.0, 500.0};
  const double own_ratio = ratio_of(own);
  if (std::find(ratios.begin(), ratios.end(), own_ratio) == ratios.end()) {
    ratios.push_back(own_ratio);
  }
  std::sort(ratios.begin(), ratios.end());
  std::vector<std::pair<double, double>> truths;
  for (const double ratio : ratios) {
    const PlainBox box = with_ratio(own, ratio);
    truths.emplace_back(box.wall,
                        torsion_constant_by_elements(box.width, box.height, box.wall, parts));
  }
  const auto truth = [truths](const PlainBox& of) -> long double {
    return std::find_if(truths.begin(), truths.end(),
                        [&](const auto& known) { return known.first == of.wall; })
        ->second;
  };
  std::vector<TriedMethod> methods;
  methods.push_back(over_ratio(
      "stress function, corners matched", false, own, ratios,
      [](const PlainBox& of) { return torsion_constant_of_box(box_of(of)).value(); }, truth));
  mark_default(methods[0], own_ratio);
  methods.push_back(over_ratio(
      "four walls: Bredt and s t^3/3", false, own, ratios,
      [](const PlainBox& of) { return torsion_constant_of(walls_of(of))->value(); }, truth));
  methods.push_back(over_ratio(
      "Bredt alone", true, own, ratios, [](const PlainBox& of) { return thin_of(of).I_T; }, truth));
  Chart chart;
  chart.name = "section-torsion";
  chart.title = "Section: torsion constant of thin and thick walls";
  chart.scene = scene;
  chart.error = "relative error of I_T";
  chart.reference = "finite elements of the stress function, graded, extrapolated twice";
  chart.operations = "width over wall thickness";
  chart.operations_cost = false;
  chart.unit = "torsion constant of one section";
  chart.series = timed(methods, effort);
  chart.guides = {{1.0, 2}};
  chart.floor = ErrorLevel{2e-7, "resolution of the reference"};
  chart.lesson = fmt::format(
      "Bredt's formula holds to 1e-2 {} and to 1e-3 {}; with the corners matched to the stress "
      "function the constant holds to 1e-3 {}.",
      from_ratio(chart.series[2], 1e-2), from_ratio(chart.series[2], 1e-3),
      from_ratio(chart.series[0], 1e-3));
  return chart;
}

// ---- round tubes as polygons ------------------------------------------------------------------

constexpr double diameter = 0.2, tube_wall = 0.01;

/// A regular polygon; of a corner radius r.
std::vector<SectionPlace> regular(int corners, double r) {
  std::vector<SectionPlace> places;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * pi * k / corners;
    places.push_back({si<Length>(r * std::cos(angle)), si<Length>(r * std::sin(angle))});
  }
  return places;
}

/// Corners on the circle, or outside it so that the area is that of the circle.
Section tube_as_polygon(int corners, bool same_area) {
  const double x = 2.0 * pi / corners;
  const double factor = same_area ? std::sqrt(x / std::sin(x)) : 1.0;
  const double r = 0.5 * diameter;
  return {Polygon{regular(corners, factor * r), {regular(corners, factor * (r - tube_wall))}}, {}};
}

Chart tube_chart(const Effort& effort) {
  const long double D = diameter, d = D - 2.0L * static_cast<long double>(tube_wall);
  const long double truth = std::numbers::pi_v<long double> / 64 * (D * D * D * D - d * d * d * d);
  const auto tried = [&](std::string setting, double parameter, const Section& section) {
    Trial trial;
    trial.point.setting = std::move(setting);
    trial.point.parameter = parameter;
    trial.point.operations = static_cast<double>(outline_of(section, {}).size());
    trial.point.error = relative(properties_of(section).I_y.value(), truth);
    trial.work = [section] { keep(properties_of(section)); };
    return trial;
  };
  std::vector<TriedMethod> methods(3);
  methods[0].method = "exact arcs";
  methods[0].trials = {
      tried("two circles", 0.0, {RoundTube{si<Length>(diameter), si<Length>(tube_wall)}, {}})};
  methods[0].trials[0].point.is_default = true;
  methods[1].method = "polygon with its corners on the circle";
  methods[2].method = "polygon of the same area";
  const std::vector<int> corners = effort.quick
                                       ? std::vector{8, 32, 128, 512}
                                       : std::vector{8, 16, 32, 64, 128, 256, 512, 1024, 2048};
  for (std::size_t same_area : {0U, 1U}) {
    methods[1 + same_area].yardstick = true;
    for (const int n : corners) {
      methods[1 + same_area].trials.push_back(
          tried(fmt::format("{} corners", n), n, tube_as_polygon(n, same_area == 1)));
    }
  }
  Chart chart;
  chart.name = "section-tube";
  chart.title = "Section: a round tube as a polygon";
  chart.scene = "round tube 200 x 10 mm";
  chart.error = "relative error of I_y";
  chart.reference = "closed form, long double";
  chart.operations = "pieces of the border";
  chart.unit = "all properties of one section";
  chart.series = timed(methods, effort);
  chart.guides = {{2.0, 1}, {4.0, 2}};
  chart.floor = ErrorLevel{std::numeric_limits<double>::epsilon(), "round-off"};
  const auto pieces_within = [](const Series& series, double error) -> std::string {
    for (const Point& point : series.points) {
      if (point.error <= error) return fmt::format("{:.0f} pieces", *point.operations);
    }
    return "more pieces than tried";
  };
  chart.lesson = fmt::format(
      "Arcs are integrated to round-off with {:.0f} pieces of the border; for 1e-4 a polygon with "
      "its corners on the circle needs {}, one of the same area {}.",
      *chart.series[0].points[0].operations, pieces_within(chart.series[1], 1e-4),
      pieces_within(chart.series[2], 1e-4));
  return chart;
}

}  // namespace

TopicResult sections(const Scenes& scenes, const Effort& effort) {
  PlainBox own;
  std::string scene;
  if (scenes.beam) {
    const auto found = box_in(scenes.beam->beam);
    if (!found) {
      return {{}, {}, "the beam has no box section: other shapes have no formulas of thin walls"};
    }
    own = *found;
  }
  scene = fmt::format("box {:.0f} x {:.0f} mm, wall from thick to thin (own: {:.3g} mm)",
                      1e3 * own.width, 1e3 * own.height, 1e3 * own.wall);
  TopicResult result;
  result.charts = {wall_chart(own, scene, effort), torsion_chart(own, scene, effort),
                   tube_chart(effort)};
  return result;
}

}  // namespace boxbeam::charts
