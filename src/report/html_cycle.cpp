#include "html_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <vector>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/report/format.hpp"
#include "cycle_drawing.hpp"
#include "drawing_forms.hpp"
#include "html_text.hpp"
#include "json_number.hpp"
#include "mechanism_drawing.hpp"

namespace boxbeam::report::html {
namespace {

struct Quantity {
  cut_force::Index which;
  const char* plane_name;  ///< nullptr: only in space
  const char* space_name;
  const char* unit;
};

constexpr Quantity quantities[] = {
    {cut_force::N, "N", "N", "kN"},         {cut_force::V_z, "V", "V_z", "kN"},
    {cut_force::M_y, "M", "M_y", "kN m"},   {cut_force::T, nullptr, "T", "kN m"},
    {cut_force::V_y, nullptr, "V_y", "kN"}, {cut_force::M_z, nullptr, "M_z", "kN m"}};

double largest_of(const CycleFigure& cycle, cut_force::Index which) {
  double largest = 0.0;
  for (const auto* line : {&cycle.smallest, &cycle.largest}) {
    for (const CutForces& cut : *line) largest = std::max(largest, std::abs(value_of(cut, which)));
  }
  return largest;
}

/// Numbers as integer multiples of a power of ten, so that the largest has five digits.
class Digits {
 public:
  explicit Digits(double largest)
      : exponent_(largest > 0.0 ? static_cast<int>(std::floor(std::log10(largest))) - 4 : 0),
        unit_(std::pow(10.0, exponent_)) {}
  long of(double value) const { return std::lround(finite(value) / unit_); }
  /// As a JSON number.
  Json unit() const { return Json::parse(fmt::format("1e{}", exponent_)); }

 private:
  int exponent_;
  double unit_;
};

Json row_of(const std::vector<CutForces>& line, cut_force::Index which, const Digits& digits) {
  Json row = Json::array();
  for (const CutForces& cut : line) row.push_back(digits.of(1e-3 * value_of(cut, which)));
  return row;
}

/// The cut forces that are not zero everywhere; in the plane N, V and M in any case.
struct Shown {
  const Quantity* of;
  const char* name;
  Digits digits;
};

std::vector<Shown> cut_forces_of(const CycleFigure& cycle, bool in_space) {
  double largest_force = 0.0;
  double largest_moment = 0.0;
  for (const Quantity& of : quantities) {
    double& largest = std::string_view(of.unit) == "kN" ? largest_force : largest_moment;
    largest = std::max(largest, largest_of(cycle, of.which));
  }
  std::vector<Shown> shown;
  for (const Quantity& of : quantities) {
    const double largest = largest_of(cycle, of.which);
    const double group = std::string_view(of.unit) == "kN" ? largest_force : largest_moment;
    const bool zero = largest <= 1e-9 * group;
    if (in_space ? zero : of.plane_name == nullptr) continue;
    shown.push_back(
        {&of, in_space ? of.space_name : of.plane_name, Digits(zero ? 0.0 : 1e-3 * largest)});
  }
  return shown;
}

/// A coordinate in tenths of a pixel.
long tenths(double value) { return std::lround(10.0 * value); }

/// Numbers as their steps from those of a row before.
void subtract(Json& row, const Json& before, std::size_t first) {
  for (std::size_t i = first; i < row.size(); ++i) {
    if (row[i].is_number()) row[i] = row[i].get<long>() - before[i].get<long>();
  }
}

/// Whether two frames hold the same shapes, at other places.
bool alike(const Json& a, const Json& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Json& one, const Json& other) {
    return one[0] == other[0] && one.size() == other.size();
  });
}

/// Drawings as lists of shapes: the number of a kind, then places, y downwards, or a place and
/// words; coordinates in tenths of a pixel. A kind is a class with what ends its lines: "z", or
/// from their one place all the rest of an outline that is drawn again and again.
class Shapes {
 public:
  Json of(const plot::Drawing& drawing) {
    Json list = Json::array();
    for (const plot::Shape& shape : drawing.shapes) {
      list.push_back(std::visit([&](const auto& one) { return row(one, drawing.height); }, shape));
    }
    return list;
  }
  /// One drawing behind the other, each by its steps from the one before where both hold the same.
  Json of(const std::vector<plot::Drawing>& drawings) {
    Json frames = Json::array();
    for (const plot::Drawing& drawing : drawings) frames.push_back(of(drawing));
    for (std::size_t f = frames.size(); f-- > 1;) {
      if (!alike(frames[f], frames[f - 1])) continue;
      for (std::size_t i = 0; i < frames[f].size(); ++i)
        subtract(frames[f][i], frames[f - 1][i], 1);
    }
    return frames;
  }
  const Json& kinds() const { return kinds_; }

 private:
  Json begin(const std::string& style, const std::string& ending) {
    const auto [known, is_new] = numbers_.try_emplace({style, ending}, numbers_.size());
    if (is_new) kinds_.push_back({style, ending});
    return Json::array({known->second});
  }
  static void add(Json& row, const plot::Pixel& place, double height) {
    row.push_back(tenths(place.x()));
    row.push_back(tenths(height - place.y()));
  }

  Json row(const plot::Line& line, double height) {
    constexpr std::size_t long_one = 4;
    const std::vector<plot::Pixel>& places = line.points;
    const bool is_outline = places.size() >= long_one;
    std::string ending;
    for (std::size_t i = 1; is_outline && i < places.size(); ++i) {
      const plot::Pixel from = places[i - 1] - places[0];
      const plot::Pixel to = places[i] - places[0];
      // From rounded place to rounded place, so that roundings do not add up.
      ending +=
          fmt::format("{}{} {}", i == 1 ? "l" : " ",
                      plot::pixels(0.1 * static_cast<double>(tenths(to.x()) - tenths(from.x()))),
                      plot::pixels(0.1 * static_cast<double>(tenths(from.y()) - tenths(to.y()))));
    }
    if (line.closed) ending += 'z';
    Json row = begin(line.pen.kind, ending);
    for (std::size_t i = 0; i < (is_outline ? 1 : places.size()); ++i) add(row, places[i], height);
    return row;
  }
  Json row(const plot::Dot& dot, double height) {
    Json row = begin(dot.pen.kind, "");
    add(row, dot.at, height);
    return row;
  }
  Json row(const plot::Words& words, double height) {
    static constexpr const char* sides[] = {"", " middle", " end"};
    Json row = begin(words.kind + sides[static_cast<int>(words.anchor)], "");
    add(row, words.at, height);
    row.push_back(visible(words.runs.front().text));
    return row;
  }

  Json kinds_ = Json::array();
  std::map<std::pair<std::string, std::string>, std::size_t> numbers_;
};

/// In every view what stands still, and a list of shapes for each frame.
Json views_of(const CycleFigure& cycle, Shapes& shapes) {
  Json views = Json::array();
  for (const plot::MovingView& view : plot::moving_views_of(cycle)) {
    views.push_back({{"name", view.name},
                     {"width", view.back.width},
                     {"height", view.back.height},
                     {"back", shapes.of(view.back)},
                     {"frames", shapes.of(view.frames)}});
  }
  return views;
}

/// The paper of the diagrams, and of each quantity its numbers over the cycle with where they go:
/// `zero` is the height of the value zero, `scale` so many tenths of pixels upwards per digit; each
/// frame by its steps from the one before.
Json diagrams_of(const CycleFigure& cycle, const std::vector<Shown>& cut, Shapes& shapes) {
  std::vector<double> stations;
  for (const Station& at : cycle.stations) stations.push_back(finite(at.s.value()));
  std::vector<plot::AlongBeam> along;
  for (const Shown& shown : cut) {
    plot::AlongBeam of{fmt::format("{} [{}]", shown.name, shown.of->unit), {}, {}};
    for (const CutForces& at : cycle.smallest)
      of.low.push_back(1e-3 * finite(value_of(at, shown.of->which)));
    for (const CutForces& at : cycle.largest)
      of.high.push_back(1e-3 * finite(value_of(at, shown.of->which)));
    along.push_back(std::move(of));
  }
  const plot::DiagramPaper paper = plot::diagram_paper(stations, along);
  Json x = Json::array();
  for (const double at : paper.x) x.push_back(tenths(at));
  Json all = Json::array();
  for (std::size_t k = 0; k < cut.size(); ++k) {
    const auto& [of, name, digits] = cut[k];
    Json frames = Json::array();
    for (const CycleFrame& frame : cycle.frames)
      frames.push_back(row_of(frame.values, of->which, digits));
    for (std::size_t f = frames.size(); f-- > 1;) subtract(frames[f], frames[f - 1], 0);
    all.push_back({{"name", name},
                   {"unit", of->unit},
                   {"digit", digits.unit()},
                   {"zero", tenths(paper.back.height - paper.scales[k].zero)},
                   {"scale", Json::parse(fmt::format("{:.6g}", 10.0 * paper.scales[k].per_unit *
                                                                   digits.unit().get<double>()))},
                   {"low", row_of(cycle.smallest, of->which, digits)},
                   {"high", row_of(cycle.largest, of->which, digits)},
                   {"frames", std::move(frames)}});
  }
  return {{"width", paper.back.width},
          {"height", paper.back.height},
          {"back", shapes.of(paper.back)},
          {"x", std::move(x)},
          {"cut", std::move(all)}};
}

/// Of every load its name, and in each frame which act and the sizes of force [kN] and couple
/// [kN m].
Json loads_of(const CycleFigure& cycle) {
  const auto size = [](double value) {
    return Json::parse(fmt::format("{:.4g}", 1e-3 * finite(value)));
  };
  std::vector<std::string> names;
  Json frames = Json::array();
  for (const CycleFrame& frame : cycle.frames) {
    Json& of_frame = frames.emplace_back(Json::array());
    for (const BeamLoadRow& load : frame.posture.loads) {
      const std::string name = visible(plot::name_of(load));
      const auto known = std::find(names.begin(), names.end(), name);
      const auto number = known - names.begin();
      if (known == names.end()) names.push_back(name);
      of_frame.push_back(Json::array({number, size(load.world.norm()), size(load.couple.norm())}));
    }
  }
  return {{"names", names}, {"frames", std::move(frames)}};
}

/// What is drawn of a cycle: its frames, and behind them the critical one.
CycleFigure with_critical_frame(const CycleFigure& cycle) {
  CycleFigure all{cycle.situation, cycle.repeats,  cycle.stations,
                  cycle.frames,    cycle.smallest, cycle.largest};
  if (cycle.critical) all.frames.push_back(cycle.critical->frame);
  return all;
}

/// The critical instant in frames from the first.
double critical_frame_of(const CycleFigure& cycle) {
  const double step = (cycle.frames[1].time - cycle.frames[0].time).value();
  const double at = (cycle.critical->frame.time - cycle.frames[0].time).value() / step;
  const auto count = static_cast<double>(cycle.frames.size());
  return cycle.repeats ? std::fmod(at, count) : std::clamp(at, 0.0, count - 1.0);
}

/// The station of a cycle nearest to a place, on its side of a jump.
std::size_t station_near(const CycleFigure& cycle, const Station& place) {
  const auto away = [&](const Station& at) {
    return std::pair(std::abs((at.s - place.s).value()), at.side != place.side);
  };
  const auto nearest =
      std::min_element(cycle.stations.begin(), cycle.stations.end(),
                       [&](const Station& a, const Station& b) { return away(a) < away(b); });
  return static_cast<std::size_t>(nearest - cycle.stations.begin());
}

/// The frame and station of the largest bending moment, or where there is none of the normal force;
/// those of the governing check where they are known, its own frame behind the others.
std::pair<std::size_t, std::size_t> critical_place(const CycleFigure& cycle) {
  if (cycle.critical) return {cycle.frames.size(), station_near(cycle, cycle.critical->station)};
  for (const auto which : {cut_force::M_y, cut_force::N}) {
    double largest = 0.0;
    std::pair<std::size_t, std::size_t> place;
    for (std::size_t f = 0; f < cycle.frames.size(); ++f) {
      for (std::size_t i = 0; i < cycle.stations.size(); ++i) {
        const double size = std::abs(value_of(cycle.frames[f].values[i], which));
        if (size <= largest) continue;
        largest = size;
        place = {f, i};
      }
    }
    if (largest > 0.0) return place;
  }
  return {0, 0};
}

/// The instant and place of the governing check; null where they are not known.
Json critical_data(const CycleFigure& cycle) {
  if (!cycle.critical) return nullptr;
  const auto number = [](double value) {
    return Json::parse(fmt::format("{:.9g}", finite(value)));
  };
  return {{"at", number(critical_frame_of(cycle))},
          {"time", number(cycle.critical->frame.time.value())},
          {"s", number(cycle.critical->station.s.value())},
          {"check", visible(cycle.critical->check)}};
}

Json data_of(const CycleFigure& cycle, Shapes& shapes, BeamShapes& beams) {
  auto [frame, station] = critical_place(cycle);
  if (cycle.critical) {
    frame = static_cast<std::size_t>(std::lround(critical_frame_of(cycle))) % cycle.frames.size();
  }
  const CycleFigure all = with_critical_frame(cycle);
  Json times = Json::array();
  for (const CycleFrame& of : cycle.frames) {
    times.push_back(Json::parse(fmt::format("{:.6g}", finite(of.time.value()))));
  }
  Json stations = Json::array();
  std::string sides;
  for (const Station& at : cycle.stations) {
    stations.push_back(Json::parse(fmt::format("{:.6g}", finite(at.s.value()))));
    sides += to_text(at.side);
  }
  const std::vector<Shown> cut = cut_forces_of(all, plot::is_in_space(all));
  return {{"repeats", cycle.repeats},
          {"frame", frame},
          {"critical", critical_data(cycle)},
          {"station", station},
          {"situation", visible(cycle.situation)},
          {"times", std::move(times)},
          {"stations", std::move(stations)},
          {"sides", sides},
          {"views", views_of(all, shapes)},
          {"loads", loads_of(all)},
          {"diagrams", diagrams_of(all, cut, shapes)},
          {"scene", scene_data(cycle, beams)}};
}

std::string data_of(const MovingPicture& picture) {
  Shapes shapes;
  Json situations = Json::array();
  BeamShapes beams;
  for (const CycleFigure& cycle : picture.cycles)
    situations.push_back(data_of(cycle, shapes, beams));
  const Json data = {{"first", picture.first},
                     {"kinds", shapes.kinds()},
                     {"beams", beams.all()},
                     {"situations", std::move(situations)}};
  return harmless(data.dump(-1, ' ', true, Json::error_handler_t::replace));
}

}  // namespace

bool has_scene(const MovingPicture& picture) {
  return std::any_of(picture.cycles.begin(), picture.cycles.end(),
                     [](const CycleFigure& cycle) { return cycle.scene.has_value(); });
}

std::string cycle_figure(const MovingPicture& picture) {
  const CycleFigure& cycle = picture.cycles[picture.first];
  assert(!cycle.frames.empty());
  const auto [frame, station] = critical_place(cycle);
  const CycleFigure all = with_critical_frame(cycle);
  const std::string time = text::seconds(all.frames[frame].time.value());
  const plot::MovingView view = plot::moving_views_of(all).front();
  plot::Drawing still = view.back;
  const std::vector<plot::Shape>& now = view.frames[frame].shapes;
  still.shapes.insert(still.shapes.end(), now.begin(), now.end());
  return fmt::format(
      "<figure class=\"cycle\" id=\"moving-figure\">\n<div class=\"pane\">\n{0}</div>\n"
      "<noscript><p>Shown at t = {1}, {4}; with scripts allowed "
      "the drawing moves over the cycle.</p></noscript>\n"
      "<script type=\"application/json\">{2}</script>\n"
      "<figcaption><b>Moving figure.</b> {3}</figcaption>\n</figure>\n",
      plot::svg_in_page(still, fmt::format("class=\"mechanism\" role=\"img\" "
                                           "aria-label=\"Mechanism at t = {}\"",
                                           time)),
      time, data_of(picture), escaped(picture.caption),
      cycle.critical ? "the instant of the governing check"
                     : "where the bending moment is largest");
}

}  // namespace boxbeam::report::html
