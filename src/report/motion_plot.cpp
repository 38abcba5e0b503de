#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/report/format.hpp"
#include "canvas.hpp"

namespace boxbeam::plot {
namespace {

/// One quantity of a driver, in the unit of its diagram.
struct Quantity {
  std::string heading;
  const std::vector<double>* values;
  double unit;
};

std::vector<Quantity> quantities_of(const DriverLine& line) {
  const bool turns = line.turns;
  constexpr double degree = std::numbers::pi / 180.0;
  std::vector<Quantity> quantities{
      {turns ? "angle [deg]" : "x [mm]", &line.position, turns ? degree : 1e-3},
      {turns ? "angular velocity [rad/s]" : "v [m/s]", &line.speed, 1.0},
      {turns ? "angular acceleration [rad/s^2]" : "a [m/s^2]", &line.acceleration, 1.0},
      {turns ? "driving moment [kN m]" : "driving force [kN]", &line.force, 1e3}};
  if (line.force.empty()) quantities.pop_back();
  // Long ways are told in metres.
  double longest = 0.0;
  for (const double x : line.position) longest = std::max(longest, std::abs(x));
  if (!turns && longest >= 2.0) quantities.front() = {"x [m]", &line.position, 1.0};
  return quantities;
}

/// The instants that decide, of the situation that is drawn.
std::vector<std::pair<std::size_t, double>> instants_of(const Verification& verification) {
  std::vector<std::pair<std::size_t, double>> instants;
  for (std::size_t k = 0; k < verification.pictures.lines.size(); ++k) {
    const PostureFigure& posture = verification.pictures.postures[k + 1];
    if (posture.situation == verification.pictures.cycles.front().situation)
      instants.emplace_back(k + 1, posture.time.value());
  }
  return instants;
}

void draw_panel(Script& gp, const DriverLine& line, const Quantity& quantity,
                const std::string& data, const Frame& frame,
                const std::vector<std::pair<std::size_t, double>>& instants, bool first,
                bool last) {
  std::vector<Row2> rows;
  double low = 1e300;
  double high = -1e300;
  for (std::size_t i = 0; i < line.times.size(); ++i) {
    const double value = (*quantity.values)[i] / quantity.unit;
    rows.emplace_back(line.times[i], value);
    low = std::min(low, value);
    high = std::max(high, value);
  }
  const double size = std::max(std::abs(low), std::abs(high));
  const bool level = high - low <= 1e-9 * size;
  // What hardly changes is seen to do so, and what is zero has an axis.
  const double span = size > 0.0 ? std::max(high - low, 0.2 * size) : 1.0;
  const double middle = 0.5 * (low + high);
  const Panel panel{frame, std::get<0>(rows.front()), std::get<0>(rows.back()),
                    middle - 0.75 * span, middle + 0.75 * span};
  gp.block(data, rows);
  place(gp, panel);
  put_heading(gp, panel, quantity.heading + note_of_beginning(panel));
  if (last) put_footing(gp, panel, "t [s]");
  Labels labels;
  labels.keep_off(panel, rows);
  for (const auto& [number, time] : instants) {
    const Pixel foot = panel.at(time, panel.y_low);
    const Pixel head = panel.at(time, panel.y_high);
    put_line(gp, foot, head, "lw 0.8 dt (3,3) lc rgb '#707070'");
    labels.keep_off(foot, head);
    if (!first) continue;
    labels.put(gp, fmt::format("({})", number), head - Pixel(0.0, 10.0), frame, "#505050", 2.0);
  }
  const auto lower = [](const Row2& a, const Row2& b) { return std::get<1>(a) < std::get<1>(b); };
  std::vector<Row2> extremes{*std::max_element(rows.begin(), rows.end(), lower)};
  if (!level) extremes.push_back(*std::min_element(rows.begin(), rows.end(), lower));
  for (const Row2& at : extremes) {
    const double value = std::get<1>(at);
    labels.put(gp, std::abs(value) < 1e-9 * size ? "0" : text::significant(value),
               panel.at(std::get<0>(at), value), frame, colour(0), 3.0);
  }
  std::vector<std::string> curves;
  if (panel.y_low < 0.0 && panel.y_high > 0.0)
    curves.push_back("0 with lines lc rgb '#505050' lw 0.9");
  curves.push_back(fmt::format("${} using 1:2 with lines {}", data, line_style(0, 1.8)));
  gp.plot(curves);
}

}  // namespace

void motion(Script& gp, const Project&, const Verification& verification) {
  const std::vector<DriverLine>& drivers = verification.pictures.drivers;
  const auto instants = instants_of(verification);
  // Several drivers stand two beside each other, in blocks below each other.
  const std::size_t columns = std::clamp<std::size_t>(drivers.size(), 1, 2);
  const std::size_t blocks = (drivers.size() + columns - 1) / columns;
  const double height = blocks == 1 ? 92.0 : 58.0;
  constexpr double above = 50.0, below = footing_room;
  std::vector<LegendEntry> legend;
  for (const auto& [number, time] : instants) {
    legend.push_back({fmt::format("({}) {}, {}", number, text::seconds(time),
                                  verification.pictures.lines[number - 1].why),
                      "lw 0.8 dt (3,3) lc rgb '#707070'"});
  }
  const double foot = legend.empty() ? 4.0 : height_of_legend(legend) + 4.0;
  std::size_t most = 0;
  for (const DriverLine& line : drivers) most = std::max(most, quantities_of(line).size());
  const double block =
      above + static_cast<double>(most) * (height + heading_room) - heading_room + below;
  gp.begin("motion", foot + static_cast<double>(blocks) * block);
  const double width = (figure_width - 16.0) / static_cast<double>(columns) - 58.0;
  for (std::size_t k = 0; k < drivers.size(); ++k) {
    const DriverLine& line = drivers[k];
    const double left = 56.0 + static_cast<double>(k % columns) * (width + 58.0);
    const std::size_t row = k / columns;
    double top = gp.height() - static_cast<double>(row) * block - above;
    put_text(gp, fitted(line.name, width), {left - 44.0, top + 36.0});
    if (k == 0 && !legend.empty()) draw_legend(gp, legend, 2.0);
    const std::vector<Quantity> quantities = quantities_of(line);
    for (std::size_t j = 0; j < quantities.size(); ++j) {
      const bool last = j + 1 == quantities.size();
      gp << (last ? "set format x '%g'\n" : "set format x ''\n");
      draw_panel(gp, line, quantities[j], fmt::format("driver{}_{}", k, j),
                 {left, top - height, left + width, top}, instants, j == 0, last);
      top -= height + heading_room;
    }
  }
}

}  // namespace boxbeam::plot
