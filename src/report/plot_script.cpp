#include "plot_script.hpp"

#include <fmt/format.h>

#include <gnuplot-iostream.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/format.hpp"

namespace boxbeam::plot {
namespace {

std::FILE* opened(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr)
    throw OutputError(fmt::format("{} cannot be written: {}", path, std::strerror(errno)));
  return file;
}

}  // namespace

struct Script::Pipe {
  Gnuplot gp;  // closes its file

  template <class Rows>
  void block(const std::string& name, const Rows& rows) {
    gp << "$" << name << " << e\n";
    gp.send1d(rows);
  }
};

Script::Script(const std::string& path)
    : pipe_(std::unique_ptr<Pipe>(new Pipe{Gnuplot(opened(path))})) {}
Script::~Script() = default;

std::ostream& Script::out() { return pipe_->gp; }

void Script::begin(const std::string& name, int width, int height) {
  out() << std::setprecision(9) << "# Redraw with: gnuplot " << name << ".gp\n"
        << "set terminal svg size " << width << "," << height
        << " dynamic enhanced font 'DejaVu Sans,12' background '#ffffff'\n"
        << "set output '" << name << ".svg'\n"
        << "set encoding utf8\n"
        << "set border 3 lc rgb '#505050'\n"
        << "set tics out nomirror\n"
        << "set grid lc rgb '#e2e2e2' lw 0.7 lt 1\n"
        << "set key noenhanced samplen 2.5 spacing 1.2\n";
}

void Script::block(const std::string& name, const std::vector<Row2>& rows) {
  pipe_->block(name, rows);
}
void Script::block(const std::string& name, const std::vector<Row3>& rows) {
  pipe_->block(name, rows);
}
void Script::block(const std::string& name, const std::vector<Row4>& rows) {
  pipe_->block(name, rows);
}

const char* colour(std::size_t i) {
  static constexpr const char* colours[] = {"#1f5fa8", "#c8551b", "#3f8f4f",
                                            "#7a4fa0", "#8a6d1d", "#4a4a4a"};
  return colours[i % std::size(colours)];
}

namespace {

/// Entries that stand beside each other, and the width of one [pixel].
std::pair<std::size_t, int> columns_of(const std::vector<LegendEntry>& entries, int width) {
  std::size_t longest = 1;
  for (const LegendEntry& entry : entries) longest = std::max(longest, entry.title.size());
  const int one = 62 + static_cast<int>(8 * longest);
  const auto fit = static_cast<std::size_t>(std::max(1, (width - 40) / one));
  return {std::min(fit, entries.size()), one};
}

}  // namespace

void draw_legend(Script& gp, const std::vector<LegendEntry>& entries, int width, int height,
                 int above) {
  constexpr int row_height = 20;
  const auto [columns, one] = columns_of(entries, width);
  const std::size_t rows = rows_of_legend(entries, width);
  const double left = 0.5 * (width - one * static_cast<int>(columns));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t row = i / columns;
    const double x = left + one * static_cast<double>(i % columns);
    const double y = above + row_height * static_cast<double>(rows - 1 - row);
    gp << "set arrow " << 500 + i << " from screen " << x / width << "," << y / height
       << " to screen " << (x + 34.0) / width << "," << y / height << " nohead " << entries[i].style
       << "\nset label " << 500 + i << " " << quoted(entries[i].title) << " at screen "
       << (x + 42.0) / width << "," << y / height << " left noenhanced\n";
  }
}

std::size_t rows_of_legend(const std::vector<LegendEntry>& entries, int width) {
  const std::size_t columns = std::max<std::size_t>(1, columns_of(entries, width).first);
  return (entries.size() + columns - 1) / columns;
}

std::string axis_title(const CutForceName& name) {
  std::string symbol = name.name;
  const std::size_t index = symbol.find('_');
  if (index != std::string::npos)
    symbol = symbol.substr(0, index) + "_{" + symbol.substr(index + 1) + "}";
  return symbol + (name.which < cut_force::T ? "  [kN]" : "  [kN m]");
}

std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    out += c == '\'' ? std::string("''") : (c == '\n' ? " " : std::string(1, c));
  return out + "'";
}

std::string time_label(Time time, const std::string& situation) {
  return fmt::format("t = {}{}", text::seconds(time.value()),
                     situation.empty() ? "" : ", " + situation);
}

}  // namespace boxbeam::plot
