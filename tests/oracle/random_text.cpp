#include "random_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace oracle {

std::string demands(Draw& draw, const BeamWriter& beam, double length, bool situations) {
  const auto category = [&] {
    return draw.one_of({160, 140, 125, 112, 100, 90, 80, 71, 63, 56, 50, 45, 40, 36});
  };
  const auto as_detail = [&](bool row) {
    return row ? std::string("row = \"8.3/5\"\n") : fmt::format("category = {}\n", category());
  };
  std::string text = fmt::format("\n[material]\nsteel = \"{}\"\n\n[strength]\nrequired = {:.3g}\n",
                                 draw.chance(0.7) ? "S355" : "S235", draw.real(1.0, 1.6));
  if (draw.chance(0.5)) text += "shear_lag = false\n";
  text += "\n[fatigue]\n" + as_detail(draw.chance(0.08));
  if (draw.chance(0.15)) text += "stress_relieved = true\n";
  if (!situations) text += fmt::format("cycles = {:.3g}\n", draw.logarithmic(1e4, 1e8));
  text += fmt::format("loading = \"{}\"\ngamma_Ff = 1.0\ngamma_Mf = {}\nrequired = 1.0\n",
                      draw.chance(0.7) ? "spectrum" : "constant amplitude",
                      draw.one_of({"1.0", "1.15", "1.35"}));
  const int count = draw.whole(0, 4);
  for (int i = 0; i < count; ++i) {
    double from = length * draw.real(0, 1), to = length * draw.real(0, 1);
    if (draw.chance(0.3)) from = 0.0;
    if (draw.chance(0.25)) to = from + 0.05;
    if (draw.chance(0.25)) {
      from = beam.borders()[static_cast<std::size_t>(
          draw.whole(0, static_cast<int>(beam.borders().size()) - 1))];
    }
    if (from > to) std::swap(from, to);
    to = std::min(to, length);
    text += fmt::format("\n[[fatigue.details]]\nname = \"detail {}\"\nfrom = {}\nto = {}\n", i + 1,
                        m(round_mm(from)), m(round_mm(to)));
    text += as_detail(draw.chance(0.15));
    if (draw.chance(0.25)) {
      const char* const on = draw.chance(0.5) ? "seams" : (draw.chance(0.6) ? "fibres" : "webs");
      text += fmt::format("on = \"{}\"\n", beam.has_webs() ? on : "fibres");
    }
    if (draw.chance(0.1)) text += fmt::format("stress_factor = {:.2f}\n", draw.real(1.0, 1.6));
    if (draw.chance(0.1)) text += "stress_relieved = true\n";
  }
  return text;
}

std::string law(Draw& draw, RandomCase& of, double size, double period, bool must_change) {
  const double which = must_change ? draw.real(0.3, 1.0) : draw.real(0, 1);
  if (which < 0.3) return fmt::format("size = {}\n", kN(size));
  if (which < 0.75) {
    return fmt::format(
        "law = {{ kind = \"harmonic\", mean = {}, amplitude = {}, frequency = \"{:.6g} Hz\", phase "
        "= \"{:.0f} deg\" }}\n",
        kN(size * draw.real(-0.6, 1.0)), kN(size * draw.real(0.3, 1.0)), 1.0 / period,
        draw.real(0, 360));
  }
  const int rows = draw.whole(8, 24);
  std::string table = "time [s], force [kN]\n";
  std::vector<double> values;
  // A few harmonics, so that no curve through the points swings far beyond them.
  const double a = draw.real(0, 1), b = draw.real(-0.5, 0.5), c = draw.real(-0.3, 0.3);
  for (int i = 0; i < rows; ++i) {
    const double x = 2.0 * std::numbers::pi * i / rows;
    values.push_back(
        size * (0.3 * a + 0.6 * std::sin(x) + b * std::sin(2.0 * x + 1.0) + c * std::cos(3.0 * x)));
  }
  values.push_back(values.front());
  for (int i = 0; i <= rows; ++i)
    table += fmt::format("{:.9g}, {:.6g}\n", period * i / rows,
                         1e-3 * values[static_cast<std::size_t>(i)]);
  const std::string file = fmt::format("{}-{}.csv", of.name, of.tables.size() + 1);
  of.tables.emplace_back(file, table);
  return fmt::format("law = {{ kind = \"table\", file = \"{}\", periodic = true }}\n", file);
}

std::string situations(Draw& draw, const std::string& key, const std::vector<std::string>& values) {
  std::string text;
  int number = 0;
  for (const std::string& value : values) {
    text += fmt::format("\n[[situations]]\nname = \"S{}\"\ncycles = {:.3g}\nload_factor = {:.3g}\n",
                        ++number, draw.logarithmic(1e3, 2e7), draw.real(1.0, 1.5));
    if (!value.empty()) text += fmt::format("set = {{ \"{}\" = {} }}\n", key, value);
  }
  if (draw.chance(0.5)) {
    text +=
        fmt::format("\n[[situations]]\nname = \"change\"\ncycles = {:.3g}\n{} = [\"S1\", \"S2\"]\n",
                    draw.logarithmic(1e3, 1e6), draw.chance(0.6) ? "between" : "sequence");
  }
  return text;
}

}  // namespace oracle
