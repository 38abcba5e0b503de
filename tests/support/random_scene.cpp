#include "support/random_scene.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace test {
namespace {

using Eigen::Vector2d;
constexpr double pi = std::numbers::pi;

class Chance {
 public:
  explicit Chance(unsigned seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  /// Logarithmically.
  double around(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
  int one_of(int count) { return static_cast<int>(between(0.0, count)); }

 private:
  std::mt19937 engine_;
};

Vector2d along(double angle, double length) {
  return length * Vector2d(std::cos(angle), std::sin(angle));
}

double angle_of(const Vector2d& v) { return std::atan2(v.y(), v.x()); }

std::string place(double x, double y) { return fmt::format("[\"{} m\", \"{} m\"]", x, y); }
std::string place(const Vector2d& p) { return place(p.x(), p.y()); }

struct Point {
  std::string name;
  double at = 0.0;
};

/// A body whose points lie on a line, from a place in a direction.
std::string body(const std::string& name, const std::vector<Point>& points, const Vector2d& from,
                 double angle, double mass = 0.0) {
  std::string list;
  double length = 0.0;
  for (const Point& point : points) {
    list += fmt::format("{}{} = {}", list.empty() ? "" : ", ", point.name, place(point.at, 0.0));
    length = std::max(length, point.at);
  }
  std::string text = fmt::format("[bodies.{}]\n", name);
  if (mass > 0.0) {
    text += fmt::format("mass = \"{} kg\"\ninertia = \"{} kg m^2\"\ncentre = {}\n", mass,
                        mass * length * length / 10.0, place(0.45 * length, 0.0));
  }
  return text + fmt::format("points = {{ {} }}\nsketch = {{ at = {}, angle = \"{} rad\" }}\n", list,
                            place(from), angle);
}

std::string pin(const std::string& name, const std::string& a, const std::string& b) {
  return fmt::format("[joints.{}]\nkind = \"pin\"\nconnect = [\"{}\", \"{}\"]\n", name, a, b);
}

std::string bearing(const std::string& name, const std::string& a, const Vector2d& at) {
  return pin(name, a, "ground") + "at = " + place(at) + "\n";
}

/// Where a link from one place and a link from another meet, to the left of the first to the other.
Vector2d meeting(const Vector2d& a, double from_a, const Vector2d& b, double from_b) {
  const Vector2d d = b - a;
  const double along_d = (from_a * from_a - from_b * from_b + d.squaredNorm()) / (2.0 * d.norm());
  const double across = std::sqrt(std::max(0.0, from_a * from_a - along_d * along_d));
  return a + along_d / d.norm() * d + across / d.norm() * Vector2d(-d.y(), d.x());
}

struct Beam {
  std::string body;
  double length = 0.0;
};

std::string beam_text(Chance& chance, const Beam& beam) {
  const double slender = chance.around(18.0, 60.0);
  const double height = beam.length / slender;
  std::string text;
  const double at = chance.between(0.35, 0.65);
  const auto section = [&](const std::string& name, double size) {
    const double h = height * size;
    text += fmt::format(
        "[sections.{}]\nkind = \"box\"\nheight = \"{} m\"\nwidth = \"{} m\"\nflange = \"{} m\"\n"
        "web = \"{} m\"\n",
        name, h, 0.8 * h, 0.07 * h, 0.07 * h);
  };
  section("a", chance.between(0.7, 1.3));
  section("b", chance.between(0.7, 1.3));
  section("c", chance.between(0.7, 1.3));
  text += fmt::format(
      "[beam]\nbody = \"{}\"\ndensity = \"7800 kg/m^3\"\nrotary_inertia = false\n"
      "[[beam.segments]]\nlength = \"{} m\"\nfrom = \"a\"\nto = \"b\"\n"
      "[[beam.segments]]\nlength = \"{} m\"\nfrom = \"b\"\nto = \"c\"\n",
      beam.body, at * beam.length, (1.0 - at) * beam.length);
  // f_1 of a pinned box of this height, roughly, and the damping of 2 to 4 % of it.
  const double f_1 = 0.5 * pi * 5190.0 * 0.39 * height / (beam.length * beam.length);
  return text +
         fmt::format(
             "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.5\nshear_lag = false\n"
             "[fatigue]\ncategory = 80\ncycles = 1e7\nloading = \"spectrum\"\ngamma_Mf = 1.35\n"
             "required = 1.0\n[model]\ndamping = \"{} s\"\nshear_modulus = \"1e6 GPa\"\n",
             chance.between(0.02, 0.04) / (pi * f_1)) +
         fmt::format("# f_1 {} Hz\n", f_1);
}

/// The rate of a drive: the beam's frequency, roughly, over 5 to 40.
double drive_rate(Chance& chance, double length) {
  const double f_1 = 0.5 * pi * 5190.0 * 0.39 / (35.0 * length);
  return 2.0 * pi * f_1 / chance.around(6.0, 40.0);
}

const char* head =
    "[case]\nname = \"scene\"\nkind = \"planar\"\n"
    "[mechanism]\ngravity = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n";

std::string turning_drive(double start, double rate) {
  return fmt::format(
      "[drivers.motor]\ncoordinate = \"angle\"\npoint = \"crank.O\"\nkind = \"constant rate\"\n"
      "start = \"{} rad\"\nrate = \"{} rad/s\"\n",
      start, rate);
}

RandomScene slider_crank(Chance& chance) {
  const double rod = chance.between(0.6, 2.0);
  const double crank = rod * chance.between(0.1, 0.3);
  const double turn = chance.between(0.0, 2.0 * pi);
  const Vector2d A = along(turn, crank);
  const Vector2d P(A.x() + std::sqrt(rod * rod - A.y() * A.y()), 0.0);
  std::string text = head;
  text += body("crank", {{"O", 0.0}, {"A", crank}}, Vector2d::Zero(), turn, 5.0);
  text += body("rod", {{"A", 0.0}, {"P", rod}}, A, angle_of(P - A));
  text += fmt::format(
      "[bodies.slide]\nmass = \"{} kg\"\npoints = {{ P = [\"0 m\", \"0 m\"] }}\n"
      "sketch = {{ at = {}, angle = \"0 rad\" }}\n",
      chance.around(0.5, 30.0), place(P));
  text += bearing("O", "crank.O", Vector2d::Zero()) + pin("A", "crank.A", "rod.A") +
          pin("P", "rod.P", "slide.P");
  text +=
      "[joints.guide]\nkind = \"slider\"\npoint = \"slide.P\"\nthrough = [\"0 m\", \"0 m\"]\n"
      "direction = \"0 deg\"\n";
  text += turning_drive(turn, drive_rate(chance, rod));
  return {"slider-crank, rod", text + beam_text(chance, {"rod", rod})};
}

RandomScene four_bar(Chance& chance, bool coupler_bends) {
  const double coupler = chance.between(0.6, 1.5);
  const double rocker = coupler * chance.between(0.7, 1.3);
  const double ground = coupler * chance.between(0.9, 1.3);
  // Short enough to turn, and away from toggles.
  const double crank = chance.between(0.15, 0.35) * std::min({coupler, rocker, ground}) *
                       std::min(1.0, (rocker + coupler - ground) / coupler);
  const double turn = chance.between(0.0, 2.0 * pi);
  const Vector2d A = along(turn, crank);
  const Vector2d C(ground, 0.0);
  const Vector2d B = meeting(A, coupler, C, rocker);
  const double overhang = chance.between(0.0, 0.25);
  std::string text = head;
  text += body("crank", {{"O", 0.0}, {"A", crank}}, Vector2d::Zero(), turn, 5.0);
  Beam beam;
  if (coupler_bends) {
    beam = {"coupler", coupler * (1.0 + overhang)};
    text += body("coupler", {{"A", 0.0}, {"B", coupler}, {"T", beam.length}}, A, angle_of(B - A));
    text +=
        body("rocker", {{"C", 0.0}, {"B", rocker}}, C, angle_of(B - C), chance.around(2.0, 60.0));
  } else {
    beam = {"rocker", rocker * (1.0 + overhang)};
    text +=
        body("coupler", {{"A", 0.0}, {"B", coupler}}, A, angle_of(B - A), chance.around(2.0, 60.0));
    text += body("rocker", {{"C", 0.0}, {"B", rocker}, {"T", beam.length}}, C, angle_of(B - C));
  }
  text += bearing("O", "crank.O", Vector2d::Zero()) + pin("A", "crank.A", "coupler.A") +
          pin("B", "coupler.B", "rocker.B") + bearing("C", "rocker.C", C);
  text += turning_drive(turn, drive_rate(chance, beam.length));
  return {coupler_bends ? "four-bar, coupler" : "four-bar, rocker", text + beam_text(chance, beam)};
}

/// A rocker C-B-D that a crank swings by its coupler at B; its end D drives a link and a rocker.
RandomScene lever(Chance& chance) {
  const double length = chance.between(0.8, 1.6);
  const double at_B = length * chance.between(0.35, 0.65);
  const double turn = chance.between(0.3, 1.2);
  const Vector2d C = Vector2d::Zero();
  const Vector2d B = along(turn, at_B);
  const Vector2d D = along(turn, length);
  const Vector2d A = B + along(turn + chance.between(1.2, 1.9), chance.between(0.4, 0.8));
  const Vector2d O = A + along(angle_of(B - A) + chance.between(1.2, 1.9), 0.25);
  const Vector2d E = D + along(turn - chance.between(1.1, 2.0), length * chance.between(0.4, 0.9));
  const Vector2d F =
      E + along(angle_of(D - E) + chance.between(1.2, 1.9), chance.between(0.4, 0.8));
  std::string text = head;
  const double crank = angle_of(A - O);
  text += body("crank", {{"O", 0.0}, {"A", 0.25}}, O, crank, 5.0);
  text += body("coupler", {{"A", 0.0}, {"B", (B - A).norm()}}, A, angle_of(B - A),
               chance.around(1.0, 20.0));
  text += body("lever", {{"C", 0.0}, {"B", at_B}, {"D", length}}, C, turn);
  text += body("link", {{"D", 0.0}, {"E", (E - D).norm()}}, D, angle_of(E - D),
               chance.around(0.5, 10.0));
  text += body("out", {{"F", 0.0}, {"E", (E - F).norm()}}, F, angle_of(E - F),
               chance.around(2.0, 40.0));
  text += bearing("O", "crank.O", O) + pin("A", "crank.A", "coupler.A") +
          pin("B", "coupler.B", "lever.B") + bearing("C", "lever.C", C) +
          pin("D", "lever.D", "link.D") + pin("E", "link.E", "out.E") + bearing("F", "out.F", F);
  text += fmt::format(
      "[drivers.motor]\ncoordinate = \"angle\"\npoint = \"crank.O\"\nkind = \"harmonic\"\n"
      "mean = \"{} rad\"\namplitude = \"{} rad\"\nangular_frequency = \"{} rad/s\"\n",
      crank, chance.between(0.1, 0.35), 0.5 * drive_rate(chance, length));
  return {"lever with three joints", text + beam_text(chance, {"lever", length})};
}

}  // namespace

RandomScene random_scene(unsigned seed) {
  Chance chance(seed);
  switch (chance.one_of(4)) {
    case 0: return slider_crank(chance);
    case 1: return four_bar(chance, true);
    case 2: return four_bar(chance, false);
    default: return lever(chance);
  }
}

}  // namespace test
