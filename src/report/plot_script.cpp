#include "plot_script.hpp"

#include <fmt/format.h>

#include <gnuplot-iostream.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/format.hpp"
#include "gnuplot_process.hpp"

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

Script::~Script() {
  if (height_ > 0.0) out() << script_end << "\n";
}

std::ostream& Script::out() { return pipe_->gp; }

void Script::begin(const std::string& name, double height) {
  height_ = height;
  // The text of a page of A4 is so wide [in].
  constexpr double page = 6.5;
  constexpr double scale = page / figure_width;
  // Letters of 10 pt, as high as those of 9 pt in the other font: pdfcairo draws a third more than
  // is asked for.
  out() << std::setprecision(9)
        << fmt::format(
               "# Redraw in the folder above: gnuplot plots/{0}.gp; as PDF: gnuplot -e 'pdf = 1' "
               "plots/{0}.gp\n"
               "if (!exists('pdf')) pdf = 0\n"
               "if (pdf) {{\n"
               "  set terminal pdfcairo size {1:.4f},{2:.4f} enhanced font 'Latin Modern "
               "Sans,{3:g}' fontscale 1 linewidth 1.25 dashlength 1.5 pointscale 1.0 rounded\n"
               "  set output '{0}.pdf'\n"
               "}} else {{\n"
               "  set terminal svg size {4:g},{5:g} dynamic enhanced font 'DejaVu Sans,12' "
               "background '#ffffff' rounded\n"
               "  set output '{0}.svg'\n"
               "}}\n",
               name, page, height * scale, 7.5, figure_width, height)
        << "set encoding utf8\n"
           "set border 3 lc rgb '#606060'\n"
           "set tics out nomirror scale 0.5\n"
           "set xtics offset 0,0.4\n"
           "set grid lc rgb '#e4e4e4' lw 0.7 lt 1\n"
           "unset key\n"
           "set multiplot\n";
}

void Script::plot(const std::vector<std::string>& curves) {
  out() << "plot ";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    out() << (i == 0 ? "" : ", ") << curves[i] << " notitle";
  }
  out() << "\nunset label\nunset arrow\nunset object\n";
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
  static constexpr const char* colours[] = {"#0b5fa5", "#c8500a", "#00785a",
                                            "#a04f86", "#8a6d00", "#4a4a4a"};
  return colours[i % std::size(colours)];
}

const char* dashes(std::size_t i) {
  static constexpr const char* patterns[] = {"1", "(9,4)", "(3,3)", "(9,3,2,3)", "(14,4)", "(2,5)"};
  return patterns[i % std::size(patterns)];
}

std::string line_style(std::size_t i, double width) {
  // Where colours begin anew, dashes differ.
  return fmt::format("lw {} dt {} lc rgb '{}'", width, dashes(i + i / 6), colour(i));
}

std::string axis_title(const CutForceName& name) {
  std::string symbol = name.name;
  const std::size_t index = symbol.find('_');
  if (index != std::string::npos)
    symbol = symbol.substr(0, index) + "_{" + symbol.substr(index + 1) + "}";
  return symbol + (name.which < cut_force::T ? "  [kN]" : "  [kN m]");
}

std::string quoted(const std::string& text) {
  // gnuplot writes a quote within quotes as two, but takes several in a row wrongly: they stand in
  // strings of their own.
  std::string out;
  bool quotes = false;
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    if (out.empty())
      out += c == '\'' ? '"' : '\'';
    else if ((c == '\'') != quotes)
      out += quotes ? "\".'" : "'.\"";
    quotes = c == '\'';
    out += control ? ' ' : c;
  }
  if (out.empty()) return "''";
  return out + (quotes ? '"' : '\'');
}

std::string time_label(Time time, const std::string& situation) {
  return fmt::format("t = {}{}", text::seconds(time.value()),
                     situation.empty() ? "" : ", " + situation);
}

}  // namespace boxbeam::plot
