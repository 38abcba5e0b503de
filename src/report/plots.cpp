#include "boxbeam/report/plots.hpp"

#include <fmt/format.h>

#include <gnuplot-iostream.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <tuple>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/format.hpp"
#include "gnuplot_process.hpp"

namespace boxbeam {
namespace {

namespace fs = std::filesystem;

constexpr const char* colours[] = {"#1f5fa8", "#c8551b", "#3f8f4f",
                                   "#7a4fa0", "#8a6d1d", "#4a4a4a"};
constexpr std::size_t colour_count = std::size(colours);

const char* colour(std::size_t i) { return colours[i % colour_count]; }

/// A user's text inside a gnuplot string in single quotes.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    out += c == '\'' ? std::string("''") : (c == '\n' ? " " : std::string(1, c));
  return out + "'";
}

/// The house style: quiet axes, light grid behind, one font.
void begin(Gnuplot& gp, const std::string& name, int width, int height) {
  gp << std::setprecision(9);
  gp << "# Redraw with: gnuplot " << name << ".gp\n"
     << "set terminal svg size " << width << "," << height
     << " dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'\n"
     << "set output '" << name << ".svg'\n"
     << "set encoding utf8\n"
     << "set border 3 lc rgb '#505050'\n"
     << "set tics out nomirror\n"
     << "set grid lc rgb '#e2e2e2' lw 0.7 lt 1\n"
     << "set key noenhanced samplen 2.5 spacing 1.2\n";
}

/// A data block of rows of numbers.
template <class Rows>
void block(Gnuplot& gp, const std::string& name, const Rows& rows) {
  gp << "$" << name << " << e\n";
  gp.send1d(rows);
}

using Row2 = std::tuple<double, double>;
using Row4 = std::tuple<double, double, double, double>;

std::string time_label(Time time) { return fmt::format("t = {}", text::seconds(time.value())); }

// --- cut forces ------------------------------------------------------------------------------

void draw_outline(Gnuplot& gp, const Project& project, const Verification& verification) {
  std::vector<Row2> outline;
  const auto& segments = project.beam.segments;
  for (const Segment& segment : segments) {
    outline.emplace_back(segment.start.value(), 500.0 * height_of(segment.from.outer).value());
    outline.emplace_back(segment.end().value(), 500.0 * height_of(segment.to.outer).value());
  }
  for (std::size_t i = outline.size(); i-- > 0;) {
    outline.emplace_back(std::get<0>(outline[i]), -std::get<1>(outline[i]));
  }
  outline.push_back(outline.front());
  block(gp, "outline", outline);
  double tallest = 0.0;
  for (const Row2& row : outline) tallest = std::max(tallest, std::get<1>(row));
  gp << "set ylabel 'beam z [mm]'\nset yrange [" << -1.6 * tallest << ":" << 1.9 * tallest << "]\n"
     << "set ytics " << (tallest > 300 ? "500" : (tallest > 100 ? "100" : "autofreq")) << "\n";
  int label = 0;
  for (const BeamPoint& point : project.beam.points) {
    gp << "set label " << ++label << " " << quoted(point.name) << " at " << point.s.value() << ","
       << 1.25 * tallest << " center noenhanced\n";
    gp << "set arrow " << label << " from " << point.s.value() << "," << 1.15 * tallest << " to "
       << point.s.value() << "," << -1.15 * tallest << " nohead lc rgb '#909090' dt 3\n";
  }
  // The one legend of the figure stands here, where no curve is.
  gp << "set key top right horizontal\n"
     << "plot $outline using 1:2 with filledcurves closed fc rgb '#dde6ef' notitle, "
        "$outline using 1:2 with lines lc rgb '#505050' lw 1.5 notitle, "
        "NaN with filledcurves fc rgb '#e9e9e9' title 'envelope'";
  for (std::size_t k = 0; k < verification.lines.size(); ++k) {
    gp << ", NaN with lines lw 1.8 lc rgb '" << colour(k) << "' title '"
       << time_label(verification.lines[k].time) << "'";
  }
  gp << "\nunset key\nunset label\nunset arrow\nset ytics autofreq\n";
}

void draw_panel(Gnuplot& gp, const Verification& verification, const std::string& symbol,
                const std::string& label, const std::function<double(const CutForces&)>& value) {
  const auto rows_of = [&](const CutForceLine& line) {
    std::vector<Row2> rows;
    for (std::size_t i = 0; i < line.stations.size(); ++i) {
      rows.emplace_back(line.stations[i].s.value(), value(line.values[i]) * 1e-3);
    }
    return rows;
  };
  std::vector<std::tuple<double, double, double>> band;
  const std::vector<Row2> low = rows_of(verification.envelope[0]);
  const std::vector<Row2> high = rows_of(verification.envelope[1]);
  double bottom = 0.0;
  double top = 0.0;
  for (std::size_t i = 0; i < low.size(); ++i) {
    band.emplace_back(std::get<0>(low[i]), std::get<1>(low[i]), std::get<1>(high[i]));
    bottom = std::min(bottom, std::get<1>(low[i]));
    top = std::max(top, std::get<1>(high[i]));
  }
  const double room = 0.18 * (top - bottom);
  block(gp, "band_" + symbol, band);
  std::string plot = fmt::format(
      "plot $band_{} using 1:2:3 with filledcurves fc rgb '#e9e9e9', "
      "0 with lines lc rgb '#505050' lw 1",
      symbol);
  int label_number = 0;
  std::vector<Row2> labelled;
  // Whether a value already stands so near that two labels would overlap.
  const auto crowded = [&](const Row2& at) {
    return std::any_of(labelled.begin(), labelled.end(), [&](const Row2& other) {
      return std::abs(std::get<0>(at) - std::get<0>(other)) < 0.08 * std::get<0>(low.back()) &&
             std::abs(std::get<1>(at) - std::get<1>(other)) < 0.12 * (top - bottom);
    });
  };
  for (std::size_t k = 0; k < verification.lines.size(); ++k) {
    const CutForceLine& line = verification.lines[k];
    const std::vector<Row2> rows = rows_of(line);
    block(gp, fmt::format("{}{}", symbol, k), rows);
    plot += fmt::format(", ${}{} using 1:2 with lines lw 1.8 lc rgb '{}'", symbol, k, colour(k));
    const auto extreme =
        std::max_element(rows.begin(), rows.end(), [](const Row2& a, const Row2& b) {
          return std::abs(std::get<1>(a)) < std::abs(std::get<1>(b));
        });
    const double y = std::get<1>(*extreme);
    if (crowded(*extreme)) continue;
    labelled.push_back(*extreme);
    gp << "set label " << ++label_number << " '" << text::significant(y) << "' at "
       << std::get<0>(*extreme) << "," << y << " offset "
       << (std::get<0>(*extreme) > 0.8 * std::get<0>(rows.back()) ? "-1" : "0.5") << ","
       << (y > 0 ? 0.6 : -0.6)
       << (std::get<0>(*extreme) > 0.8 * std::get<0>(rows.back()) ? " right" : " left")
       << " tc rgb '" << colour(k) << "' front\n";
  }
  gp << "set ylabel '" << label << "'\nset yrange [" << bottom - room << ":" << top + room << "]\n"
     << plot << "\nunset label\n";
}

void cut_forces(Gnuplot& gp, const Project& project, const Verification& verification) {
  begin(gp, "cut-forces", 860, 980);
  gp << "set multiplot layout 4,1 margins 0.11,0.97,0.06,0.95 spacing 0,0.035 title "
     << quoted("Cut forces along the beam: " + project.name) << " noenhanced\n"
     << "set xrange [" << -0.02 * project.beam.length().value() << ":"
     << 1.02 * project.beam.length().value() << "]\n"
     << "set format x ''\n";
  draw_outline(gp, project, verification);
  draw_panel(gp, verification, "N", "N [kN]", [](const CutForces& cut) { return cut.N.value(); });
  draw_panel(gp, verification, "V", "V [kN]", [](const CutForces& cut) { return cut.V_z.value(); });
  gp << "set format x '%g'\nset xlabel 's [m], from the start of the beam'\n";
  draw_panel(gp, verification, "M", "M [kN m], on the tension side",
             [](const CutForces& cut) { return cut.M_y.value(); });
  gp << "unset multiplot\n";
}

// --- mechanism -------------------------------------------------------------------------------

/// Bodies of one posture as lines and blocks, with rods, guides and bearings; returns the plot
/// commands.
std::string draw_bodies(Gnuplot& gp, const Project& project, const PostureFigure& posture,
                        const std::string& prefix, const std::string& ink, double guide_length) {
  std::vector<std::string> plots;
  const auto strokes = [&](const std::string& name, const std::vector<PostureFigure::Stroke>& lines,
                           const std::string& style) {
    if (lines.empty()) return;
    std::vector<Row4> rows;
    for (const auto& line : lines) {
      const Eigen::Vector2d along = line.to - line.from;
      rows.emplace_back(line.from.x(), line.from.y(), along.x(), along.y());
    }
    block(gp, name, rows);
    plots.push_back(
        fmt::format("${} using 1:2:3:4 with vectors nohead {} lc rgb '{}'", name, style, ink));
  };
  const auto points = [&](const std::string& name, const std::vector<Eigen::Vector2d>& places,
                          const std::string& style, const std::string& rgb) {
    if (places.empty()) return;
    std::vector<Row2> rows;
    for (const Eigen::Vector2d& place : places) rows.emplace_back(place.x(), place.y());
    block(gp, name, rows);
    plots.push_back(fmt::format("${} using 1:2 with {} lc rgb '{}'", name, style, rgb));
  };
  std::vector<PostureFigure::Stroke> guides;
  for (const auto& guide : posture.guides) {
    guides.push_back({guide.from - guide_length * guide.to, guide.from + guide_length * guide.to});
  }
  strokes(prefix + "_guides", guides, "lw 1 dt 3");
  strokes(prefix + "_rods", posture.rods, "lw 2 dt 2");
  for (std::size_t b = 0; b < posture.bodies.size(); ++b) {
    const auto& body = posture.bodies[b];
    const std::string name = fmt::format("{}_{}", prefix, b);
    if (static_cast<int>(b) == project.beam_body) {
      strokes(name + "_axis", body.strokes, "lw 5");
      points(name, body.points, "points pt 7 ps 0.6", ink);
    } else if (body.points.size() == 1) {
      points(name, body.points, "points pt 5 ps 1.6", ink);
    } else {
      points(name, body.points, "linespoints lw 2 pt 7 ps 0.5", ink);
    }
  }
  points(prefix + "_grounds", posture.grounds, "points pt 9 ps 1.2", "#505050");
  return fmt::format("{}", fmt::join(plots, ", "));
}

/// The loads of a posture as arrows that end where they act, with their sizes.
void draw_loads(Gnuplot& gp, const PostureFigure& posture, double metres_per_newton,
                const char* ink) {
  int number = 0;
  for (const BeamLoadRow& row : posture.loads) {
    const Eigen::Vector2d tail = row.place - metres_per_newton * row.world;
    const bool from_left = row.world.x() > 0.0;
    ++number;
    const std::string name =
        row.name.empty() ? fmt::format("s = {} m", text::significant(row.s.value(), 3)) : row.name;
    gp << "set arrow " << number << " from " << tail.x() << "," << tail.y() << " to "
       << row.place.x() << "," << row.place.y() << " lw 2 lc rgb '" << ink << "' front\n";
    gp << "set label " << number << " " << quoted(name + "  " + text::kN(row.world.norm()))
       << " at " << tail.x() << "," << tail.y()
       << (from_left ? " right offset -0.3,0.9" : " left offset 0.3,0.9") << " tc rgb '" << ink
       << "' front noenhanced\n";
  }
}

/// The corners of all postures [m].
struct Extent {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e300);
  Eigen::Vector2d high = Eigen::Vector2d::Constant(-1e300);
};

Extent extent_of(const std::vector<PostureFigure>& postures) {
  Extent extent;
  for (const PostureFigure& posture : postures) {
    for (const auto& body : posture.bodies) {
      for (const Eigen::Vector2d& point : body.points) {
        extent.low = extent.low.cwiseMin(point);
        extent.high = extent.high.cwiseMax(point);
      }
    }
    for (const Eigen::Vector2d& place : posture.grounds) {
      extent.low = extent.low.cwiseMin(place);
      extent.high = extent.high.cwiseMax(place);
    }
  }
  return extent;
}

void mechanism(Gnuplot& gp, const Project& project, const Verification& verification) {
  const std::size_t panels = verification.postures.size() - 1;
  const Extent extent = extent_of(verification.postures);
  const Eigen::Vector2d size = extent.high - extent.low;
  double largest_force = 0.0;
  for (const PostureFigure& posture : verification.postures) {
    for (const BeamLoadRow& row : posture.loads) {
      largest_force = std::max(largest_force, row.world.norm());
    }
  }
  const double reach = 0.16 * size.maxCoeff();  // the longest arrow
  // Tall mechanisms stand side by side, wide ones below each other.
  const bool tall = size.y() > size.x();
  const auto count = static_cast<int>(panels);
  // As large as the mechanism's shape asks for, with room for axes and arrows.
  const double aspect = (size.y() + 1.6 * reach) / (size.x() + 3.4 * reach);
  const int width = tall ? std::clamp(static_cast<int>(720.0 / aspect), 260, 640) + 90 : 900;
  const int height = tall ? 720 : std::clamp(static_cast<int>(820.0 * aspect), 160, 720) + 110;
  begin(gp, "mechanism", tall ? width * count : width, tall ? 860 : 60 + height * count);
  gp << "set multiplot layout " << (tall ? 1 : count) << "," << (tall ? count : 1) << " title "
     << quoted("Mechanism at its critical instants, forces on the beam; grey: " +
               time_label(verification.postures.front().time))
     << " noenhanced\n"
     << "set size ratio -1\nset xlabel 'x [m]'\nset ylabel 'y [m]'\nunset key\n"
     << "set xrange [" << extent.low.x() - 1.7 * reach << ":" << extent.high.x() + 1.7 * reach
     << "]\n"
     << "set yrange [" << extent.low.y() - 0.8 * reach << ":" << extent.high.y() + 0.8 * reach
     << "]\n";
  for (std::size_t k = 1; k <= panels; ++k) {
    const PostureFigure& posture = verification.postures[k];
    const std::string ghost = draw_bodies(gp, project, verification.postures.front(),
                                          fmt::format("rest{}", k), "#c4c4c4", 0.5 * reach);
    const std::string bodies =
        draw_bodies(gp, project, posture, fmt::format("at{}", k), colour(k - 1), 0.5 * reach);
    draw_loads(gp, posture, reach / std::max(largest_force, 1e-9), "#202020");
    gp << "set title \"" << time_label(posture.time) << "\\n"
       << posture.why << "\"\n"
       << "plot " << ghost << ", " << bodies << "\nunset label\nunset arrow\n";
  }
  gp << "unset multiplot\n";
}

// --- stress over the cycle -------------------------------------------------------------------

void stress(Gnuplot& gp, const Project& project, const Verification& verification) {
  begin(gp, "stress", 860, 520);
  const CheckResult* governing = verification.governing(Criterion::fatigue);
  if (governing == nullptr) governing = &verification.checks.front();
  const std::size_t running = governing->basis->running;
  const std::vector<double>& instants = governing->basis->times;
  const std::string& situation = project.situations[running].name;
  gp << "set title "
     << quoted("Normal stress over the cycle at the places with the largest ranges: " +
               project.name + (situation.empty() ? "" : ", " + situation))
     << " noenhanced\n"
     << "set xlabel 't [s]'\nset ylabel 'sigma [MPa]'\nset xrange [" << instants.front() << ":"
     << instants.back() << "]\n"
     << "set key outside bottom center horizontal\n";
  std::vector<const CheckResult*> shown;
  for (const CheckResult& result : verification.checks) {
    if (result.check.criterion != Criterion::fatigue || !result.basis || shown.size() == 3 ||
        result.basis->running != running)
      continue;
    const bool same_station = std::any_of(
        shown.begin(), shown.end(),
        [&](const CheckResult* other) { return other->check.station == result.check.station; });
    if (!same_station) shown.push_back(&result);
  }
  std::string plot = "plot 0 with lines lc rgb '#505050' lw 1 notitle";
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const CheckBasis& basis = *shown[k]->basis;
    std::vector<Row2> rows;
    for (std::size_t i = 0; i < basis.times.size(); ++i) {
      rows.emplace_back(basis.times[i], basis.history[i] * 1e-6);
    }
    std::vector<Row2> extremes;
    for (const Extreme& extreme : {basis.highest, basis.lowest}) {
      if (extreme.situation != running) continue;
      extremes.emplace_back(extreme.time.value(), extreme.value * 1e-6);
    }
    block(gp, fmt::format("h{}", k), rows);
    block(gp, fmt::format("x{}", k), extremes);
    plot += fmt::format(
        ", $h{} using 1:2 with lines lw {} lc rgb '{}' title {}", k, k == 0 ? 2.4 : 1.6, colour(k),
        quoted(fmt::format("s = {} m, {}: range {}", to_text(shown[k]->check.station),
                           shown[k]->check.point, text::MPa(shown[k]->check.acting.value()))));
    plot +=
        fmt::format(", $x{} using 1:2 with points pt 7 ps 0.7 lc rgb '{}' notitle", k, colour(k));
    if (k > 0) continue;
    // Near the frame a label grows inwards.
    const auto side = [&](double time) {
      const double share = (time - instants.front()) / (instants.back() - instants.front());
      return share < 0.15 ? " left" : (share > 0.85 ? " right" : " center");
    };
    for (const Row2& extreme : extremes) {
      gp << "set label '" << text::significant(std::get<1>(extreme)) << " MPa at "
         << text::seconds(std::get<0>(extreme)) << "' at " << std::get<0>(extreme) << ","
         << std::get<1>(extreme) << side(std::get<0>(extreme)) << " offset 0,"
         << (std::get<1>(extreme) > 0 ? 0.9 : -0.9) << " tc rgb '" << colour(0) << "' front\n";
    }
  }
  gp << "set offsets 0,0,graph 0.12,graph 0.12\n" << plot << "\n";
}

// --- S-N diagram -----------------------------------------------------------------------------

void sn(Gnuplot& gp, const Project& project, const Verification& verification) {
  const SnFigure& figure = *verification.sn;
  begin(gp, "sn", 860, 560);
  std::vector<std::tuple<double, double, double>> rows;
  for (std::size_t i = 0; i < figure.cycles.size(); ++i) {
    rows.emplace_back(figure.cycles[i], figure.spectrum[i] * 1e-6,
                      figure.constant_amplitude[i] * 1e-6);
  }
  block(gp, "line", rows);
  std::vector<Row2> work, needed;
  double cycles = 0.0, range = 0.0;  // of the largest range
  for (const auto& [n, pascals] : figure.working) {
    work.emplace_back(n, pascals * 1e-6);
    needed.emplace_back(n, pascals * 1e-6 * figure.required);
    if (pascals * 1e-6 <= range) continue;
    cycles = n;
    range = pascals * 1e-6;
  }
  // The standard's lines begin at 1e4; rare cycles stand before them.
  double fewest = 1e4;
  for (const auto& [n, pascals] : figure.working) {
    fewest = std::min(fewest, std::pow(10.0, std::floor(std::log10(0.7 * n))));
  }
  block(gp, "work", work);
  block(gp, "needed", needed);
  const bool en = !figure.published_step;
  gp << "set title " << quoted("S-N diagram with the governing stress range: " + project.name)
     << " noenhanced\n"
     << "set logscale xy\nset format x '10^{%T}'\nset xlabel 'cycles N'\nset ylabel 'stress range "
        "[MPa]'\n"
     << "set xrange [" << fewest << ":1e9]\nset yrange [10:1000]\nset key bottom left\n"
     << "set ytics (10,20,30,50,70,100,200,300,500,1000)\n";
  gp << "set label 'knee " << text::significant(figure.knee * 1e-6, 3) << " MPa' at 5e6,"
     << figure.knee * 1e-6 << " right offset -0.6,-0.9 point pt 6\n"
     << "set label '" << (en ? "cut-off " : "at 1e8: ")
     << text::significant(figure.cut_off * 1e-6, 3) << " MPa' at 1e8," << figure.cut_off * 1e-6
     << " left offset 0.6,0.8 point pt 6\n";
  if (en) {
    gp << "set label 'm = 3' at 3e5," << 1.15e-6 * figure.reference * std::cbrt(2e6 / 3e5) << "\n"
       << "set label 'm = 5' at 2.5e7," << 1.12 * figure.knee * 1e-6 * std::pow(5e6 / 2.5e7, 0.2)
       << "\n"
       << "set label 'category " << figure.name << "' at 2e6," << figure.reference * 1e-6
       << " left offset 0.6,0.6 point pt 6\n";
  }
  gp << "set label '" << text::significant(range, 3) << " MPa' at " << cycles << "," << range
     << " left offset 1,-0.7 tc rgb '" << colour(1) << "'\n";
  gp << "plot $line using 1:2 with lines lw 2 lc rgb '" << colour(0) << "' title "
     << quoted(en ? fmt::format("{}, category {}, spectrum", figure.code, figure.name)
                  : fmt::format("published step, category {} taken at 5e6 cycles", figure.name));
  if (en) {
    gp << ", $line using 1:3 with lines lw 1.6 dt 2 lc rgb '" << colour(0)
       << "' title 'constant amplitude (7.1(2))'";
  }
  gp << ", $work using 1:2 with points pt 7 ps 1 lc rgb '" << colour(1)
     << "' title 'governing range, partial factors applied'"
     << ", $needed using 1:2 with points pt 6 ps 1.2 lc rgb '" << colour(1) << "' title '"
     << fmt::format("governing range x required factor {}", text::significant(figure.required, 3))
     << "'\n";
}

struct Figure {
  std::string name;
  std::function<void(Gnuplot&)> draw;
};

void write_script(const fs::path& path, const Figure& figure) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr)
    throw OutputError(fmt::format("{} cannot be written: {}", path.string(), std::strerror(errno)));
  Gnuplot gp(file);  // closes the file
  figure.draw(gp);
}

}  // namespace

void remove_figures(const std::string& folder) {
  std::error_code ignored;
  for (const char* name : {"cut-forces", "mechanism", "stress", "sn"}) {
    fs::remove(fs::path(folder) / fmt::format("{}.svg", name), ignored);
    fs::remove(fs::path(folder) / "plots" / fmt::format("{}.gp", name), ignored);
  }
}

std::vector<std::string> draw_figures(const Project& project, const Verification& verification,
                                      const std::string& folder) {
  std::vector<Figure> figures{
      {"cut-forces", [&](Gnuplot& gp) { cut_forces(gp, project, verification); }},
      {"mechanism", [&](Gnuplot& gp) { mechanism(gp, project, verification); }}};
  if (project.given_stresses.empty()) {
    figures.push_back({"stress", [&](Gnuplot& gp) { stress(gp, project, verification); }});
  }
  if (verification.sn)
    figures.push_back({"sn", [&](Gnuplot& gp) { sn(gp, project, verification); }});

  const ScratchFolder scratch(folder);
  std::vector<std::string> names;
  for (const Figure& figure : figures) {
    write_script(scratch.path() / (figure.name + ".gp"), figure);
    names.push_back(figure.name);
  }
  run_gnuplot(scratch.path(), names);

  std::vector<std::string> written;
  std::error_code error;
  fs::create_directories(fs::path(folder) / "plots", error);
  for (const Figure& figure : figures) {
    const std::string script = "plots/" + figure.name + ".gp";
    const std::string drawing = figure.name + ".svg";
    fs::rename(scratch.path() / (figure.name + ".gp"), fs::path(folder) / script, error);
    if (!error) fs::rename(scratch.path() / drawing, fs::path(folder) / drawing, error);
    if (error)
      throw OutputError(
          fmt::format("{}/{} cannot be written: {}", folder, drawing, error.message()));
    written.push_back(drawing);
  }
  return written;
}

}  // namespace boxbeam
