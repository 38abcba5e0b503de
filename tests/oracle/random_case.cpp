#include "random_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>

namespace oracle {
namespace {

/// Random numbers, alike on every machine.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed * 0x9E3779B97F4A7C15ULL + 1049) {
    engine_.discard(8);
  }

  double real(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
  }
  /// Small and large ones alike.
  double logarithmic(double low, double high) { return low * std::pow(high / low, real(0, 1)); }
  int whole(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double part) { return real(0, 1) < part; }
  template <class T>
  T one_of(std::initializer_list<T> of) {
    return *(of.begin() + whole(0, static_cast<int>(of.size()) - 1));
  }

 private:
  std::mt19937_64 engine_;
};

/// A length in millimetres, whole ones.
std::string mm(double metres) { return fmt::format("\"{:.0f} mm\"", metres * 1e3); }
double round_mm(double metres) { return std::round(metres * 1e3) * 1e-3; }
std::string m(double metres) { return fmt::format("\"{:.4g} m\"", metres); }
std::string kN(double newtons) { return fmt::format("\"{:.4g} kN\"", newtons * 1e-3); }

enum class Family { box, tube, round, plate, nested };

/// Writes the sections and the beam of a case.
class BeamWriter {
 public:
  BeamWriter(Draw& draw, double length, double size, bool space)
      : draw_(draw), length_(length), space_(space) {
    const double which = draw.real(0, 1);
    family_ = which < 0.5    ? Family::box
              : which < 0.65 ? Family::tube
              : which < 0.75 ? Family::round
              : which < 0.85 ? Family::plate
                             : Family::nested;
    width_ = round_mm(size * draw.real(0.5, 1.2));
    size_ = size;
    const double slender = draw.real(10.0, 30.0);
    top_ = round_mm(std::max(0.005, width_ / slender));
    bottom_ = draw.chance(0.4) ? round_mm(top_ * draw.real(0.7, 1.6)) : top_;
    left_ = round_mm(std::max(0.004, size * draw.real(0.03, 0.07)));
    right_ = draw.chance(0.25) ? round_mm(left_ * draw.real(0.7, 1.8)) : left_;
    if (draw.chance(0.1)) top_ = bottom_ = round_mm(draw.real(0.026, 0.045));
    bars_ = family_ == Family::box && draw.chance(0.25) ? draw.whole(1, 2) : 0;
    bar_on_web_ = draw.chance(0.3);
    throat_ =
        family_ == Family::box && draw.chance(0.4) ? round_mm(left_ * draw.real(0.4, 0.9)) : 0;
    write_segments();
  }

  std::string sections, segments;
  double modulus() const { return modulus_; }
  const std::vector<double>& borders() const { return borders_; }
  bool has_webs() const { return family_ != Family::round && family_ != Family::plate; }

  /// Holes in boxes and tubes, away from the ends.
  std::string holes() {
    if (family_ != Family::box && family_ != Family::tube) return "";
    if (bars_ > 0 || !draw_.chance(0.3)) return "";
    const double at = draw_.chance(0.3) && borders_.size() > 2
                          ? borders_[1]
                          : round_mm(length_ * draw_.real(0.1, 0.9));
    const bool webs = space_ ? draw_.chance(0.6) : draw_.chance(0.75);
    const double clear = webs ? least_height_ - top_ - bottom_ : width_ - left_ - right_;
    const double diameter = round_mm(clear * draw_.real(0.15, 0.4));
    if (diameter < 0.005) return "";
    const double level = webs && draw_.chance(0.3) ? round_mm(0.15 * clear) : 0.0;
    return fmt::format(
        "\n[[beam.holes]]\nname = \"access\"\ndiameter = {}\nstation = {}\nthrough = \"{}\"\n"
        "{} = [{}]\nconcentration = \"{}\"\n",
        mm(diameter), m(at), webs ? "webs" : "flanges", webs ? "levels" : "offsets", mm(level),
        webs ? "in-plane bending" : "membrane tension");
  }

 private:
  struct Profile {
    double height, width, top, bottom, left, right;
  };

  Profile profile() {
    Profile of{round_mm(size_ * draw_.real(0.6, 1.7)), width_, top_, bottom_, left_, right_};
    if (draw_.chance(0.2)) of.width = round_mm(width_ * draw_.real(0.8, 1.2));
    // Plates of a growing thickness pass the steps of the yield strength.
    if (draw_.chance(0.1)) of.top = round_mm(top_ * draw_.real(0.8, 1.3));
    if (draw_.chance(0.1)) of.left = round_mm(left_ * draw_.real(0.8, 1.3));
    if (family_ == Family::plate) of.width = round_mm(std::max(0.012, size_ * 0.3));
    // Clear height between the flanges.
    of.height = std::max(of.height, 2.0 * (of.top + of.bottom));
    least_height_ = std::min(least_height_, of.height);
    return of;
  }

  std::string written(const std::string& name, const Profile& p) {
    std::string text = fmt::format("\n[sections.{}]\n", name);
    const double wall = std::max(p.left, 0.004);
    switch (family_) {
      case Family::box: {
        text += fmt::format(
            "kind = \"box\"\nwidth = {}\nheight = {}\ntop_flange = {}\nbottom_flange = {}\n"
            "left_web = {}\nright_web = {}\n",
            mm(p.width), mm(p.height), mm(p.top), mm(p.bottom), mm(p.left), mm(p.right));
        if (throat_ > 0.0) text += fmt::format("seam_throat = {}\n", mm(throat_));
        for (int i = 0; i < bars_; ++i) {
          const bool web = bar_on_web_ && i == 0;
          // No bar reaches another.
          const double room = std::min({0.2 * size_, 0.4 * (p.width - p.left - p.right) - left_,
                                        0.4 * (p.height - p.top - p.bottom)});
          const double depth = round_mm(std::min(std::max(0.012, 6.0 * left_), room));
          text += fmt::format(
              "[[sections.{}.stiffeners]]\non = \"{}\"\nat = {}\ndepth = {}\nthickness = {}\n",
              name, web ? "left web" : (i == 0 ? "top flange" : "bottom flange"),
              mm(web ? 0.1 * least_possible() : 0.0), mm(depth), mm(left_));
        }
        break;
      }
      case Family::tube:
        text += fmt::format("kind = \"rectangular tube\"\nwidth = {}\nheight = {}\nwall = {}\n",
                            mm(p.width), mm(p.height), mm(wall));
        break;
      case Family::round:
        text += fmt::format("kind = \"round tube\"\ndiameter = {}\nwall = {}\n", mm(p.height),
                            mm(wall));
        break;
      case Family::plate:
        text +=
            fmt::format("kind = \"plate\"\nwidth = {}\nheight = {}\n", mm(p.width), mm(p.height));
        break;
      case Family::nested: {
        text +=
            fmt::format("kind = \"nested\"\nouter = \"{0}_outer\"\ninner = \"{0}_inner\"\n", name);
        text += fmt::format(
            "\n[sections.{}_outer]\nkind = \"box\"\nwidth = {}\nheight = {}\ntop_flange = {}\n"
            "bottom_flange = {}\nleft_web = {}\nright_web = {}\n",
            name, mm(p.width), mm(p.height), mm(p.top), mm(p.bottom), mm(p.left), mm(p.right));
        const double room =
            std::min(p.width - p.left - p.right, p.height - p.top - p.bottom) - 0.012;
        text += fmt::format("\n[sections.{}_inner]\n", name);
        if (inner_round_) {
          text += fmt::format("kind = \"round tube\"\ndiameter = {}\nwall = {}\n", mm(0.8 * room),
                              mm(std::max(0.004, 0.06 * room)));
        } else {
          text += fmt::format("kind = \"box\"\nwidth = {}\nheight = {}\nflange = {}\nweb = {}\n",
                              mm(0.8 * room), mm(0.7 * room), mm(std::max(0.004, 0.06 * room)),
                              mm(std::max(0.004, 0.05 * room)));
        }
        break;
      }
    }
    return text;
  }

  double least_possible() const { return 0.6 * size_; }

  void write_segments() {
    inner_round_ = draw_.chance(0.5);
    const int count = draw_.whole(1, 4);
    borders_ = {0.0};
    for (int i = 1; i < count; ++i)
      borders_.push_back(round_mm(length_ * (i + draw_.real(-0.3, 0.3)) / count));
    borders_.push_back(length_);
    int number = 0;
    const auto add = [&](const Profile& p) {
      const std::string name = fmt::format("A{}", ++number);
      sections += written(name, p);
      return name;
    };
    Profile at = profile();
    std::string name = add(at);
    for (int i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (i > 0 && draw_.chance(0.25)) {
        at = profile();
        name = add(at);
      }
      const Profile first = at;
      std::string end = name;
      if (draw_.chance(0.65)) {
        at = profile();
        end = add(at);
      }
      segments += fmt::format("\n[[beam.segments]]\nname = \"part {}\"\nlength = {}\n", i + 1,
                              mm(borders_[k + 1] - borders_[k]));
      segments += name == end ? fmt::format("section = \"{}\"\n", name)
                              : fmt::format("from = \"{}\"\nto = \"{}\"\n", name, end);
      name = end;
      for (const Profile& p : {first, at}) {
        const double W =
            family_ == Family::plate   ? p.width * p.height * p.height / 6.0
            : family_ == Family::round ? 0.78 * p.height * p.height * std::max(p.left, 0.004)
            : family_ == Family::tube
                ? p.height * std::max(p.left, 0.004) * (p.width + 0.33 * p.height)
                : p.height *
                      (0.5 * (p.top + p.bottom) * p.width + 0.17 * (p.left + p.right) * p.height);
        modulus_ = modulus_ == 0.0 ? W : 0.5 * (modulus_ + W);
      }
    }
  }

  Draw& draw_;
  double length_, size_ = 0.0, width_ = 0.0;
  bool space_;
  Family family_ = Family::box;
  double top_ = 0.0, bottom_ = 0.0, left_ = 0.0, right_ = 0.0, throat_ = 0.0;
  int bars_ = 0;
  bool bar_on_web_ = false, inner_round_ = false;
  double least_height_ = 1e9, modulus_ = 0.0;
  std::vector<double> borders_;
};

/// Material, strength and fatigue with its details.
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

/// A function of time for a force of a size [N], of a period [s]: constant, harmonic or a table.
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

/// Situations that change some key, and changes between and sequences of them.
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

/// Of a chord, or as the supports say.
std::string deflection(Draw& draw, double from, double to, bool chord) {
  if (!draw.chance(0.3)) return "";
  std::string text =
      fmt::format("\n[deflection]\nlimit = {}\n", mm((to - from) / draw.real(100, 600) + 0.001));
  if (chord) text += fmt::format("against = \"chord\"\nfrom = {}\nto = {}\n", m(from), m(to));
  if (draw.chance(0.3)) text += "load_factor = true\n";
  return text;
}

/// A lever that a crank swings, as in the template.
void write_lever(Draw& draw, RandomCase& of) {
  const double length = round_mm(draw.real(2.0, 3.0));
  const double pin = round_mm(draw.real(1.35, 1.6));
  BeamWriter beam(draw, length, draw.real(0.12, 0.3), false);
  // Whole parts of the motion's frequency are written alike for drivers and forces.
  const double rate = draw.one_of({15.0, 24.0, 30.0, 37.5, 48.0, 60.0});
  const double period = 60.0 / rate;
  const double mass = beam.modulus() * draw.real(2e7, 1.5e8) / 9.81 / length;
  std::string& text = of.text;
  text += fmt::format(
      "[case]\nname = \"{}\"\nkind = \"planar\"\n\n[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 "
      "m/s^2\"]\n\n[bodies.crank]\nmass = \"40 kg\"\nuniform_rod = \"0.3 m\"\npoints = {{ O = "
      "[\"-0.15 m\", \"0 m\"], A = [\"0.15 m\", \"0 m\"] }}\nsketch = {{ at = [\"0 m\", \"0.15 "
      "m\"], angle = \"90 deg\" }}\n\n[bodies.rod]\nmass = \"60 kg\"\nuniform_rod = \"2 m\"\n"
      "points = {{ A = [\"-1 m\", \"0 m\"], B = [\"1 m\", \"0 m\"] }}\nsketch = {{ at = [\"1 m\", "
      "\"0.3 m\"], angle = \"0 deg\" }}\n\n[bodies.lever]\npoints = {{ C = [\"0 m\", \"0 m\"], B = "
      "[{}, \"0 m\"], D = [{}, \"0 m\"] }}\nsketch = {{ at = [\"2 m\", \"-1.2 m\"], angle = \"90 "
      "deg\" }}\n\n[bodies.load]\nmass = \"{:.4g} kg\"\ninertia = \"{:.4g} kg m^2\"\npoints = {{ D "
      "= [\"0 m\", \"0 m\"] }}\nsketch = {{ at = [\"2 m\", \"{:.4g} m\"], angle = \"90 deg\" }}\n",
      of.name, m(pin), m(length), mass, 0.03 * mass, length - 1.2);
  text +=
      "\n[joints.O]\nkind = \"pin\"\nconnect = [\"crank.O\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
      "\n[joints.A]\nkind = \"pin\"\nconnect = [\"crank.A\", \"rod.A\"]\n"
      "\n[joints.B]\nkind = \"pin\"\nconnect = [\"rod.B\", \"lever.B\"]\n"
      "\n[joints.C]\nkind = \"pin\"\nconnect = [\"lever.C\", \"ground\"]\nat = [\"2 m\", \"-1.2 "
      "m\"]\n\n[joints.D]\nkind = \"rigid\"\nconnect = [\"lever.D\", \"load.D\"]\n"
      "\n[loops.rod]\nturn = [\"rod.A\", \"rod.B\", \"lever.C\"]\nsign = \"-\"\n";
  text += fmt::format(
      "\n[drivers.motor]\npoint = \"crank.O\"\ncoordinate = \"angle\"\nkind = \"constant "
      "rate\"\nstart = \"90 deg\"\nrate = \"{:.4g} rpm\"\n",
      rate);
  if (draw.chance(0.5)) {
    text += fmt::format(
        "\n[forces.pull]\nkind = \"force\"\npoint = \"lever.{}\"\ndirection = "
        "\"{:.0f} deg\"\n",
        draw.chance(0.5) ? "D" : "B", draw.real(-180, 180));
    text += law(draw, of, 5.0 * mass, period, false);
  }
  text += beam.sections;
  const bool several =
      draw.chance(0.4) && of.tables.empty() && text.find("frequency") == std::string::npos;
  if (draw.chance(0.4))
    text += "\n[sections.bar]\nkind = \"round tube\"\ndiameter = \"80 mm\"\nwall = \"8 mm\"\n";
  const bool rod = text.find("[sections.bar]") != std::string::npos;
  text += "\n[model]\ndemand = \"rigid\"\n";
  text += "\n[beam]\nbody = \"lever\"\ndensity = \"7850 kg/m^3\"\n" + beam.segments + beam.holes();
  text += demands(draw, beam, length, several);
  if (several) {
    text += situations(draw, "drivers.motor.rate",
                       {"", fmt::format("\"{:.4g} rpm\"", rate * draw.real(0.3, 1.4))});
  }
  if (rod) {
    text +=
        "\n[[rods]]\nname = \"rod\"\nfrom = \"rod.A\"\nto = \"rod.B\"\nsection = \"bar\"\n"
        "curve = \"c\"\n";
  }
  if (draw.chance(0.4)) {
    text += fmt::format(
        "\n[[pins]]\nname = \"hub\"\njoint = \"{}\"\ndiameter = {}\ninner_plate = \"40 mm\"\n"
        "outer_plate = \"20 mm\"\ngap = \"3 mm\"\n",
        draw.one_of({"A", "B", "C"}), mm(draw.real(0.02, 0.07)));
  }
  text += deflection(draw, 0.0, draw.chance(0.5) ? pin : length, true);
}

/// A lever that a crank swings by a pin in its slot: the load slides along the beam.
void write_quick_return(Draw& draw, RandomCase& of) {
  const double length = round_mm(draw.real(1.9, 2.6));
  BeamWriter beam(draw, length, draw.real(0.12, 0.3), false);
  const double radius = round_mm(draw.real(0.2, 0.5));
  const double mass = beam.modulus() * draw.real(2e7, 1.5e8) / 9.81 / length;
  std::string& text = of.text;
  text += fmt::format(
      "[case]\nname = \"{}\"\nkind = \"planar\"\n\n[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 "
      "m/s^2\"]\n\n[bodies.crank]\nmass = \"40 kg\"\ninertia = \"1 kg m^2\"\npoints = {{ O = "
      "[\"0 m\", \"0 m\"], A = [{}, \"0 m\"] }}\nsketch = {{ at = [\"0 m\", \"0 m\"], angle = \"90 "
      "deg\" }}\n\n[bodies.lever]\npoints = {{ C = [\"0 m\", \"0 m\"], D = [{}, \"0 m\"] "
      "}}\nsketch = {{ at = [\"0 m\", \"-1.2 m\"], angle = \"90 deg\" }}\n\n[bodies.load]\nmass = "
      "\"{:.4g} kg\"\ninertia = \"{:.4g} kg m^2\"\npoints = {{ D = [\"0 m\", \"0 m\"] }}\nsketch = "
      "{{ at = [\"0 m\", \"{:.4g} m\"], angle = \"90 deg\" }}\n",
      of.name, m(radius), m(length), mass, 0.03 * mass, length - 1.2);
  text += fmt::format(
      "\n[joints.O]\nkind = \"pin\"\nconnect = [\"crank.O\", \"ground\"]\nat = [\"0 m\", \"0 m\"]\n"
      "\n[joints.A]\nkind = \"pin in slot\"\npoint = \"crank.A\"\nguide = \"lever.C\"\ndirection "
      "= \"0 deg\"\n\n[joints.C]\nkind = \"pin\"\nconnect = [\"lever.C\", \"ground\"]\nat = [\"0 "
      "m\", \"-1.2 m\"]\n\n[joints.D]\nkind = \"rigid\"\nconnect = [\"lever.D\", \"load.D\"]\n"
      "\n[drivers.motor]\npoint = \"crank.O\"\ncoordinate = \"angle\"\nkind = \"constant "
      "rate\"\nstart = \"90 deg\"\nrate = \"{:.4g} rpm\"\n",
      draw.one_of({15.0, 24.0, 30.0, 37.5, 48.0}));
  text += beam.sections;
  text += "\n[model]\ndemand = \"rigid\"\n";
  text += "\n[beam]\nbody = \"lever\"\ndensity = \"7850 kg/m^3\"\n" + beam.segments + beam.holes();
  const bool several = draw.chance(0.3);
  text += demands(draw, beam, length, several);
  if (several) {
    text += situations(draw, "drivers.motor.rate",
                       {"", fmt::format("\"{:.4g} rpm\"", draw.real(10, 50))});
  }
}

/// A beam that stands still under forces that change: clamped, or on two supports.
void write_standing(Draw& draw, RandomCase& of) {
  const double length = round_mm(draw.real(1.5, 5.0));
  BeamWriter beam(draw, length, draw.real(0.12, 0.4), false);
  const bool clamped = draw.chance(0.5);
  const double support = round_mm(length * draw.real(0.6, 1.0));
  const double middle = round_mm(length * draw.real(0.15, 0.9));
  const double aside = draw.chance(0.3) ? round_mm(draw.real(-0.3, 0.3)) : 0.0;
  const double period = draw.one_of({0.5, 1.0, 2.0});
  const double size = beam.modulus() * draw.real(3e7, 2e8) / length * (clamped ? 1.0 : 3.0);
  std::string& text = of.text;
  text += fmt::format(
      "[case]\nname = \"{}\"\nkind = \"planar\"\n\n[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 "
      "m/s^2\"]\n\n[bodies.beam]\npoints = {{ A = [\"0 m\", \"0 m\"], B = [{}, \"0 m\"], E = [{}, "
      "{}], F = [{}, \"0 m\"] }}\nsketch = {{ at = [\"0 m\", \"0 m\"], angle = \"0 deg\" }}\n",
      of.name, m(support), m(middle), m(aside), m(length));
  if (clamped) {
    text +=
        "\n[joints.A]\nkind = \"rigid\"\nconnect = [\"beam.A\", \"ground\"]\nat = [\"0 m\", \"0 "
        "m\"]\nangle = \"0 deg\"\n";
  } else {
    text += fmt::format(
        "\n[joints.A]\nkind = \"pin\"\nconnect = [\"beam.A\", \"ground\"]\nat = [\"0 m\", \"0 "
        "m\"]\n"
        "\n[joints.B]\nkind = \"pin in slot\"\npoint = \"beam.B\"\nthrough = [{}, "
        "\"0 m\"]\ndirection = \"0 deg\"\n",
        m(support));
  }
  text += "\n[forces.end]\nkind = \"force\"\npoint = \"beam.F\"\ndirection = \"" +
          fmt::format("{:.0f}", draw.chance(0.7) ? -90.0 : draw.real(-180, 180)) + " deg\"\n";
  text += law(draw, of, size, period, true);
  if (draw.chance(0.6)) {
    text += fmt::format(
        "\n[forces.middle]\nkind = \"force\"\npoint = \"beam.E\"\ndirection = "
        "\"{:.0f} deg\"\n",
        draw.real(-180, 180));
    text += law(draw, of, size, period, false);
  }
  text += beam.sections;
  text += "\n[model]\ndemand = \"rigid\"\n";
  text += "\n[beam]\nbody = \"beam\"\ndensity = \"7850 kg/m^3\"\n" + beam.segments + beam.holes();
  const bool several = draw.chance(0.3);
  text += demands(draw, beam, length, several);
  if (several) text += situations(draw, "mechanism.gravity", {"", "[\"0 m/s^2\", \"0 m/s^2\"]"});
  text += deflection(draw, 0.0, clamped ? length : support, !clamped && draw.chance(0.5));
}

/// The jib of a slewing crane.
void write_jib(Draw& draw, RandomCase& of) {
  const double length = round_mm(draw.real(2.0, 6.0));
  BeamWriter beam(draw, length, draw.real(0.12, 0.35), true);
  const double frequency = draw.one_of({0.04, 0.05, 0.08, 0.1, 0.125, 0.2});
  const double period = 1.0 / frequency;
  const double mass = beam.modulus() * draw.real(1e7, 8e7) / 9.81 / length;
  const double middle = round_mm(length * draw.real(0.1, 0.9));
  const bool off_axis = draw.chance(0.5);
  const double y = off_axis ? round_mm(draw.real(-0.1, 0.1)) : 0.0;
  const double z = off_axis ? round_mm(draw.real(-0.2, 0.2)) : 0.0;
  const double raised = std::round(draw.real(-20, 30));
  std::string& text = of.text;
  text += fmt::format(
      "[case]\nname = \"{0}\"\nkind = \"spatial\"\n\n[mechanism]\ngravity = [\"0 m/s^2\", \"0 "
      "m/s^2\", \"-9.81 m/s^2\"]\n\n[bodies.column]\nmass = \"500 kg\"\ncentre = [\"0 m\", \"0 "
      "m\", \"1.5 m\"]\ninertia = [\"380 kg m^2\", \"380 kg m^2\", \"12 kg m^2\"]\npoints = {{ A = "
      "[\"0 m\", \"0 m\", \"0 m\"], B = [\"0 m\", \"0 m\", \"3 m\"] }}\n\n[bodies.jib]\npoints = "
      "{{ B = [\"0 m\", \"0 m\", \"0 m\"], D = [{1}, \"0 m\", \"0 m\"], lug = [{2}, {3}, {4}] "
      "}}\n\n[bodies.load]\nmass = \"{5:.4g} kg\"\ncentre = [\"{6:.2f} m\", \"0 m\", \"{7:.2f} "
      "m\"]\ninertia = [\"15 kg m^2\", \"15 kg m^2\", \"10 kg m^2\"]\npoints = {{ D = [\"0 m\", "
      "\"0 m\", \"0 m\"] }}\n",
      of.name, m(length), m(middle), m(y), m(z), mass, draw.real(0, 0.6), draw.real(-0.8, 0.2));
  text += fmt::format(
      "\n[joints.slew]\nkind = \"revolute\"\nconnect = [\"ground\", \"column.A\"]\nat = [\"0 m\", "
      "\"0 m\", \"0 m\"]\naxis = \"z\"\n\n[joints.root]\nkind = \"fixed\"\nconnect = "
      "[\"column.B\", \"jib.B\"]\nturn = [\"y\", \"{:.0f} deg\"]\n\n[joints.end]\nkind = "
      "\"fixed\"\n"
      "connect = [\"jib.D\", \"load.D\"]\nturn = [\"y\", \"{:.0f} deg\"]\n\n[drivers.slewing]\n"
      "joint = \"slew\"\nkind = \"harmonic\"\nmean = \"0 deg\"\namplitude = \"{:.0f} "
      "deg\"\nfrequency = \"{:.4g} Hz\"\n",
      -raised, raised, draw.real(20, 150), frequency);
  const int forces = draw.whole(1, 2);
  for (int i = 0; i < forces; ++i) {
    text += fmt::format("\n[forces.F{}]\nkind = \"force\"\npoint = \"{}\"\n", i + 1,
                        i == 0 ? "jib.lug" : "load.D");
    text += fmt::format("direction = [{:.3f}, {:.3f}, {:.3f}]\n", draw.real(-1, 1),
                        draw.real(-1, 1), draw.real(-1, 1));
    if (draw.chance(0.6)) text += "axes = \"jib\"\n";
    text += law(draw, of, 12.0 * mass, period, false);
  }
  text += beam.sections;
  text +=
      "\n[beam]\nbody = \"jib\"\nstart = \"B\"\naxis = \"x\"\nz = \"z\"\ndensity = \"7850 "
      "kg/m^3\"\n" +
      beam.segments + beam.holes();
  const bool several = draw.chance(0.35);
  text += demands(draw, beam, length, several);
  if (several) {
    text += situations(draw, "drivers.slewing.amplitude",
                       {"", fmt::format("\"{:.0f} deg\"", draw.real(10, 170))});
  }
}

/// A boom of elastic links on a jack.
void write_boom(Draw& draw, RandomCase& of) {
  const double length = 3.5;
  BeamWriter beam(draw, length, draw.real(0.14, 0.3), false);
  const double frequency = std::round(draw.real(3, 30));
  const double force = beam.modulus() * draw.real(3e6, 4e7) / length;
  std::string& text = of.text;
  text += fmt::format(
      "[case]\nname = \"{}\"\nkind = \"flexible\"\n\n[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 "
      "m/s^2\"]\n\n[motion]\nfrequency = \"{:.0f} Hz\"\n\n[model]\nyoungs_modulus = \"210 "
      "GPa\"\nshear_modulus = \"81 GPa\"\ndamping = {{ ratio = 0.03, at = \"25 Hz\" "
      "}}\n\n[links.boom]\nkind = \"bending\"\norigin = [\"0 m\", \"0 m\"]\nangle = \"20 "
      "deg\"\nparts = 8\npoints = {{ jack = [\"1.2 m\", \"-0.15 m\"] }}\n\n[links.jack]\nkind = "
      "\"axial\"\nfrom = [\"0.9 m\", \"-0.9 m\"]\nto = \"boom.jack\"\nparts = 3\nEA = \"90 "
      "MN\"\nmass_per_length = \"30 kg/m\"\n\n[links.tool]\nkind = \"rigid\"\norigin = "
      "\"boom.end\"\nangle = \"20 deg\"\npoints = {{ flange = [\"0 m\", \"0 m\"] }}\nmass = "
      "\"{:.0f} kg\"\ninertia = \"6 kg m^2\"\ncentre = [\"0.2 m\", \"0 m\"]\n",
      of.name, frequency, draw.real(50, 300));
  text +=
      "\n[joints.foot]\nkind = \"revolute\"\nconnect = [\"boom.start\", \"ground\"]\nstiffness = "
      "\"200 MN/m\"\n\n[joints.base]\nkind = \"revolute\"\nconnect = [\"jack.start\", "
      "\"ground\"]\nstiffness = \"200 MN/m\"\n\n[joints.jack]\nkind = \"revolute\"\nconnect = "
      "[\"jack.end\", \"boom.jack\"]\nstiffness = \"200 MN/m\"\n\n[joints.flange]\nkind = "
      "\"revolute\"\nconnect = [\"boom.end\", \"tool.flange\"]\nstiffness = "
      "\"rigid\"\nturning_stiffness = \"rigid\"\n";
  text += fmt::format("\n[loads.shaking]\non = \"tool.flange\"\namplitude_force = [{}, {}]\n",
                      kN(force * draw.real(-1, 1)), kN(force * draw.real(0.2, 1)));
  text += beam.sections;
  text += "\n[beam]\nlink = \"boom\"\ndensity = \"7850 kg/m^3\"\n" + beam.segments + beam.holes();
  const bool several = draw.chance(0.3);
  text += demands(draw, beam, length, several);
  if (several) {
    text += situations(draw, "motion.frequency",
                       {"", fmt::format("\"{:.0f} Hz\"", std::round(draw.real(3, 30)))});
  }
}

}  // namespace

RandomCase random_case(std::uint64_t number) {
  Draw draw(number);
  RandomCase of;
  of.name = fmt::format("random-{}", number);
  const double which = draw.real(0, 1);
  if (which < 0.28)
    write_standing(draw, of);
  else if (which < 0.5)
    write_lever(draw, of);
  else if (which < 0.6)
    write_quick_return(draw, of);
  else if (which < 0.92)
    write_jib(draw, of);
  else
    write_boom(draw, of);
  return of;
}

std::string RandomCase::write(const std::string& folder) const {
  namespace fs = std::filesystem;
  fs::create_directories(folder);
  for (const auto& [file, content] : tables) std::ofstream(fs::path(folder) / file) << content;
  const std::string path = (fs::path(folder) / (name + ".toml")).string();
  std::ofstream(path) << text;
  return path;
}

}  // namespace oracle
