// The deflection of the beam against closed forms of bending and shear (Timoshenko, Strength of
// Materials I) and against integrals of this file's own.

#include "boxbeam/verification/deflection.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/core/error.hpp"
#include "support/changed_rig.hpp"
#include "support/clamped_beam.hpp"
#include "support/rig.hpp"

namespace deflection_test {

using namespace boxbeam;

namespace {

constexpr double E = 210e9;
constexpr double G = 81e9;
constexpr double L = 4.0;

Section box(double height) {
  return {symmetric_box(si<Length>(0.2), si<Length>(height), si<Length>(0.02), si<Length>(0.01)),
          {}};
}

/// I_y of that box by hand.
double inertia_of(double h) { return (0.2 * h * h * h - 0.18 * std::pow(h - 0.04, 3)) / 12.0; }

/// Its webs carry the shear: EN 1993-1-1, 6.2.6(3).
double shear_area_of(double h) { return 2.0 * 0.01 * h; }

Project project_of(double height_from, double height_to, double from, double to) {
  Project project;
  Segment segment;
  segment.name = "S";
  segment.length = si<Length>(L);
  segment.from = box(height_from);
  segment.to = box(height_to);
  project.beam.segments = {segment};
  project.deflection = DeflectionInput{si<Length>(0.01), Chord{si<Length>(from), si<Length>(to)},
                                       "the chord",      false,
                                       si<Stress>(E),    si<Stress>(G)};
  return project;
}

struct Push {
  double at, size;  ///< [m], along +z [N]
};

/// Deflection by place; zero at the supports.
std::function<double(double)> deflected(const Project& project, const std::vector<Push>& forces,
                                        double line_load = 0.0) {
  BeamLoads loads;
  for (const Push& force : forces) {
    PointLoad load;
    load.s = si<Length>(force.at);
    load.force.z() = force.size;
    loads.points.push_back(load);
  }
  loads.lines = unloaded_lines(project.beam);
  for (LineLoad& line : loads.lines) line.force[2].c[0] = line_load;
  const DeflectedLine line =
      DividedBeam(deflection_model_of(project)).line_under(cut_forces_of(loads));
  return [line](double s) { return line.at(si<Length>(s))[1]; };
}

constexpr double h = 0.3;
const double EI = E * inertia_of(h);
const double GA = G * shear_area_of(h);
constexpr double P = 50e3;

}  // namespace

TEST_CASE("a force in the middle of two supports: P L^3/(48 E I) + P L/(4 G A_v)") {
  const auto w = deflected(project_of(h, h, 0.0, L), {{0.0, P / 2}, {L / 2, -P}, {L, P / 2}});
  CHECK(w(L / 2) == Approx(-(P * L * L * L / (48.0 * EI) + P * L / (4.0 * GA))).epsilon(1e-10));
  // At the quarter: P x (3 L^2 - 4 x^2)/(48 E I) + P x/(2 G A_v), x = L/4; the same on both sides.
  const double x = L / 4;
  const double quarter = -(P * x * (3 * L * L - 4 * x * x) / (48 * EI) + P * x / (2 * GA));
  CHECK(w(x) == Approx(quarter).epsilon(1e-10));
  CHECK(w(L - x) == Approx(quarter).epsilon(1e-10));
}

TEST_CASE("two cantilevers back to back: P l^3/(3 E I) + P l/(G A_v) at their tips") {
  // Held in the middle, pulled down by P at both ends: the middle stands above the line of the
  // tips.
  const double l = L / 2;
  const auto w = deflected(project_of(h, h, 0.0, L), {{0.0, -P}, {l, 2 * P}, {L, -P}});
  CHECK(w(l) == Approx(P * l * l * l / (3 * EI) + P * l / GA).epsilon(1e-10));
}

TEST_CASE("a cantilever against the line from its root to its tip") {
  // w(x) = P x^2 (3 L - x)/(6 E I) less x/L of the tip's P L^3/(3 E I); the shear's part is
  // straight.
  const Project project = project_of(h, h, 0.0, L);
  BeamLoads loads;
  PointLoad root, tip;
  root.force.z() = P;
  root.moment.y() = P * L;  // what a clamp gives, of either sense: fixed by balance below
  tip.s = si<Length>(L);
  tip.force.z() = -P;
  loads.points = {root, tip};
  loads.lines = unloaded_lines(project.beam);
  if (imbalance_of(loads).moment.norm() > 1.0) loads.points[0].moment.y() = -P * L;
  REQUIRE(imbalance_of(loads).moment.norm() < 1e-6);
  const DeflectedLine line =
      DividedBeam(deflection_model_of(project)).line_under(cut_forces_of(loads));
  for (int i = 1; i < 16; ++i) {
    const double x = i * L / 16.0;
    const double free = P * x * x * (3 * L - x) / (6 * EI);
    const double chord = x / L * P * L * L * L / (3 * EI);
    CHECK(line.at(si<Length>(x))[1] == Approx(chord - free).epsilon(1e-9));
  }
  // Its largest place is where x^2/2 - x + 1/3 = 0 in lengths of L, which is none of a grid.
  const LargestDeflection largest = largest_of(line);
  const double x = L * (1.0 - 1.0 / std::sqrt(3.0));
  CHECK(largest.at.value() == Approx(x).epsilon(1e-6));
  CHECK(
      largest.size.value() ==
      Approx(x / L * P * L * L * L / (3 * EI) - P * x * x * (3 * L - x) / (6 * EI)).epsilon(1e-6));
}

TEST_CASE("a load along the beam: 5 q L^4/(384 E I) + q L^2/(8 G A_v)") {
  const double q = 20e3;
  const auto w = deflected(project_of(h, h, 0.0, L), {{0.0, q * L / 2}, {L, q * L / 2}}, -q);
  CHECK(w(L / 2) ==
        Approx(-(5 * q * std::pow(L, 4) / (384 * EI) + q * L * L / (8 * GA))).epsilon(1e-10));
}

TEST_CASE("an overhang: P c^2 (l + c)/(3 E I) + P c (1 + c/l)/(G A_v) at its tip") {
  // Supports at 0 and l = 3 m, the force at the tip c = 1 m behind.
  const double l = 3.0;
  const double c = 1.0;
  const auto w =
      deflected(project_of(h, h, 0.0, l), {{0.0, -P * c / l}, {l, P * (1 + c / l)}, {L, -P}});
  CHECK(w(L) ==
        Approx(-(P * c * c * (l + c) / (3 * EI) + P * c * (1 + c / l) / GA)).epsilon(1e-10));
  // Between the supports it rises: at the middle P c l^2/(16 E I), the shear's part is straight.
  CHECK(w(l / 2) == Approx(P * c * l * l / (16 * EI)).epsilon(1e-10));
}

TEST_CASE("measured from another line the deflection differs by a straight line only") {
  const std::vector<Push> forces{{0.0, P / 2}, {L / 2, -P}, {L, P / 2}};
  const auto ends = deflected(project_of(h, h, 0.0, L), forces);
  const auto inner = deflected(project_of(h, h, 1.0, 3.0), forces);
  // By symmetry the inner line is level, at the height of the quarter points.
  for (const double s : {0.5, 1.5, 2.0, 2.5, 3.5}) {
    CHECK(inner(s) == Approx(ends(s) - ends(1.0)).epsilon(1e-9));
  }
}

TEST_CASE("a linear taper: the integral of M m/(E I) + V v/(G A_v), summed by Simpson's rule") {
  const double a = 0.2;
  const double b = 0.5;
  const auto w = deflected(project_of(a, b, 0.0, L), {{0.0, P / 2}, {L / 2, -P}, {L, P / 2}});
  // Of the force P and of a unit force, both in the middle: M = P x/2 and V = P/2 up to there.
  const auto f = [&](double s) {
    const double height = a + (b - a) * s / L;
    const double x = std::min(s, L - s);
    return 0.25 * P * x * x / (E * inertia_of(height)) + 0.25 * P / (G * shear_area_of(height));
  };
  constexpr int n = 4000;  // its middle, a corner of M, is a node
  double sum = f(0.0) + f(L);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(L * i / n);
  CHECK(w(L / 2) == Approx(-sum * L / n / 3.0).epsilon(1e-9));
}

TEST_CASE("a cantilever is measured from its clamp: P L^3/(3 E I) + P L/(G A_v) at its tip") {
  // The force that bends the tip by 20.7 mm. From the chord between root and tip the most is
  // 0.1925 of the bending's part, where x/L = 1 - 1/sqrt(3): less than a fifth.
  using namespace test::clamped;
  const double force = 0.0207 / tip_deflection(1.0);
  const std::string size = "size = \"" + std::to_string(force) + " N\"\n";
  const auto check_of = [&](const std::string& more, const std::string& joints = weld) {
    const Project project =
        test::clamped_beam(size, "[deflection]\nlimit = \"10 mm\"\n" + more, joints);
    return std::pair{check_deflection(project, run_situations(project))->check,
                     project.deflection->measured_from};
  };
  const auto is_of_the_tip = [](const Check& check) {
    CHECK(check.acting.value() == Approx(0.0207).epsilon(1e-6));
    CHECK(check.station.s.value() == Approx(4.0));
    CHECK(check.point == "from tangent at 0 m");
    CHECK_FALSE(check.passes());
  };
  const auto [by_supports, from] = check_of("");
  is_of_the_tip(by_supports);
  CHECK(from == "the tangent at s = 0 m, where joint root clamps the beam");
  CHECK(by_supports.source.find(from) != std::string::npos);
  is_of_the_tip(check_of("against = \"axis\"\n").first);
  is_of_the_tip(check_of("against = \"tangent\"\n").first);
  is_of_the_tip(check_of("against = \"tangent\"\nat = \"0 m\"\n").first);
  // Ends of a chord alone do not make it one.
  const auto [unsaid, told] = check_of("from = \"0 m\"\nto = \"4 m\"\n");
  is_of_the_tip(unsaid);
  CHECK(told.find("only with against = \"chord\"") != std::string::npos);
  // A pin whose angle is driven is a clamp as well.
  const std::string driven =
      "[joints.root]\nkind = \"pin\"\nconnect = [\"beam.A\", \"ground\"]\n"
      "at = [\"0 m\", \"0 m\"]\n[drivers.hold]\nkind = \"hold\"\npoint = \"beam.A\"\n"
      "coordinate = \"angle\"\nvalue = \"0 deg\"\n";
  is_of_the_tip(check_of("", driven).first);

  const auto [chord, name] = check_of("against = \"chord\"\nfrom = \"0 m\"\nto = \"4 m\"\n");
  const double bending = force * 64.0 / (3.0 * test::clamped::E * inertia());
  CHECK(chord.acting.value() == Approx(0.19245 * bending).epsilon(1e-4));
  CHECK(chord.acting.value() == Approx(0.0039).epsilon(0.02));
  CHECK(chord.passes());
  CHECK(chord.point == "from chord 0 to 4 m");
  CHECK(name == "the chord from s = 0 to 4 m");
}

TEST_CASE("situations that hold the beam unlike leave the line to be said") {
  const std::string situations =
      "[[situations]]\nname = \"work\"\n[[situations]]\nname = \"jacked\"\n"
      "set = { \"joints.root.connect\" = [\"beam.B\", \"ground\"], "
      "\"joints.root.at\" = [\"4 m\", \"0 m\"] }\n";
  const auto demand = [&](const std::string& more) {
    return "[deflection]\nlimit = \"10 mm\"\n" + more + situations;
  };
  test::check_refused(test::clamped_beam_text(test::clamped::steady, demand("")), "[deflection]",
                      "does not say from which line", "against = \"tangent\"");
  const Project said =
      test::clamped_beam(test::clamped::steady, demand("against = \"tangent\"\nat = \"0 m\"\n"));
  CHECK(said.deflection->measured_from == "the tangent at s = 0 m");
}

TEST_CASE("a beam on two supports is measured from the chord between them, its overhang too") {
  // Pins at 0 and 2.5 m, 10 kN at the tip 1.5 m behind: P c^2 (l + c)/(3 E I) + P c (1 + c/l)/(G
  // A).
  using namespace test::clamped;
  const std::string pins =
      "[joints.A]\nkind = \"pin\"\nconnect = [\"beam.A\", \"ground\"]\n"
      "at = [\"0 m\", \"0 m\"]\n"
      "[joints.M]\nkind = \"slider\"\npoint = \"block.M\"\nthrough = [\"0 m\", \"0 m\"]\n"
      "direction = \"0 deg\"\n"
      "[joints.B]\nkind = \"pin\"\nconnect = [\"beam.M\", \"block.M\"]\n"
      "[bodies.block]\nmass = \"0 kg\"\npoints = { M = [\"0 m\", \"0 m\"] }\n"
      "sketch = { at = [\"2.5 m\", \"0 m\"] }\n";
  const Project project =
      test::clamped_beam("size = \"10 kN\"\n", "[deflection]\nlimit = \"10 mm\"\n", pins);
  CHECK(project.deflection->measured_from ==
        "the chord from s = 0 to 2.5 m, between its supports, joints A and B");
  const Check check = check_deflection(project, run_situations(project))->check;
  const double force = 10e3, span = 2.5, c = 1.5;
  CHECK(check.station.s.value() == Approx(4.0));
  CHECK(check.acting.value() ==
        Approx(force * c * c * (span + c) / (3 * test::clamped::E * inertia()) +
               force * c * (1 + c / span) / (test::clamped::G * shear_area()))
            .epsilon(1e-9));
  // From the support to the tip the overhang would hide how far the tip comes down.
  const Project ends =
      test::clamped_beam("size = \"10 kN\"\n",
                         "[deflection]\nlimit = \"10 mm\"\nfrom = \"0 m\"\nto = \"4 m\"\n", pins);
  const Check same = check_deflection(ends, run_situations(ends))->check;
  CHECK(same.acting.value() == Approx(check.acting.value()).epsilon(1e-12));
  CHECK(ends.deflection->measured_from.find("only with against = \"chord\"") != std::string::npos);
}

TEST_CASE("from a tangent inside the beam both parts bend away as cantilevers") {
  // Of P at the tip, from the tangent at a = 1 m: the part behind, of length b = 3 m, bends by
  // P b^3/(3 E I) + P b/(G A_v); the root lies below by the moment P (L - x) over the first metre,
  // P a^2 (L/2 - a/3)/(E I), and above by the shear P a/(G A_v).
  Project project = project_of(h, h, 0.0, L);
  project.deflection->against = Tangent{si<Length>(1.0)};
  BeamLoads loads;
  PointLoad root, tip;
  root.force.z() = P;
  tip.s = si<Length>(L);
  tip.force.z() = -P;
  root.moment.y() = P * L;
  loads.points = {root, tip};
  loads.lines = unloaded_lines(project.beam);
  if (imbalance_of(loads).moment.norm() > 1.0) loads.points[0].moment.y() = -P * L;
  const DeflectedLine line =
      DividedBeam(deflection_model_of(project)).line_under(cut_forces_of(loads));
  CHECK(line.at(si<Length>(1.0))[1] == Approx(0.0).margin(1e-15));
  CHECK(line.at(si<Length>(L))[1] == Approx(-(P * 27.0 / (3 * EI) + P * 3.0 / GA)).epsilon(1e-9));
  // int_0^a x P (L - x)/(E I) dx = P (L a^2/2 - a^3/3)/(E I), downwards; the shear lifts it.
  CHECK(line.at(si<Length>(0.0))[1] ==
        Approx(-P * (L / 2.0 - 1.0 / 3.0) / EI + P / GA).epsilon(1e-9));
}

TEST_CASE("a load between two places of any grid: the corner of the moment is met exactly") {
  // P at a = 1.237 m: at the load P a^2 b^2/(3 L E I) + P a b/(L G A_v).
  const double a = 1.237;
  const double b = L - a;
  const auto w = deflected(project_of(h, h, 0.0, L), {{0.0, P * b / L}, {a, -P}, {L, P * a / L}});
  CHECK(w(a) == Approx(-(P * a * a * b * b / (3 * L * EI) + P * a * b / (L * GA))).epsilon(1e-10));
}

namespace {

/// A cantilever from s = 0, in space, pushed at its tip along y and z and halfway along y alone.
BeamLoads pushed_in_space(const Project& project, double along_y, double along_z, double halfway) {
  BeamLoads loads;
  PointLoad root, tip, middle;
  tip.s = si<Length>(L);
  tip.force = {0.0, along_y, along_z};
  middle.s = si<Length>(L / 2.0);
  middle.force.y() = halfway;
  root.force = -tip.force - middle.force;
  root.moment = -L * Eigen::Vector3d::UnitX().cross(tip.force) -
                L / 2.0 * Eigen::Vector3d::UnitX().cross(middle.force);
  loads.points = {root, middle, tip};
  loads.lines = unloaded_lines(project.beam);
  REQUIRE(imbalance_of(loads).moment.norm() < 1e-6);
  return loads;
}

}  // namespace

TEST_CASE("in space a cantilever bends along y and along z, each by its own inertia and walls") {
  Project project = project_of(h, h, 0.0, L);
  project.in_space = true;
  project.deflection->against = Tangent{si<Length>(0.0)};
  // Of the box on its side, and its flanges carry V_y.
  const double I_z = (h * 0.2 * 0.2 * 0.2 - (h - 0.04) * std::pow(0.18, 3)) / 12.0;
  const double A_y = 2.0 * 0.02 * 0.2;
  const double along_y = 0.7 * P, along_z = -P;
  const DeflectedLine line =
      DividedBeam(deflection_model_of(project))
          .line_under(cut_forces_of(pushed_in_space(project, along_y, along_z, 0.0)));
  const double y = along_y * (L * L * L / (3.0 * E * I_z) + L / (G * A_y));
  const double z = along_z * (L * L * L / (3.0 * EI) + L / GA);
  const Eigen::Vector2d tip = line.at(si<Length>(L));
  CHECK(tip.x() == Approx(y).epsilon(1e-9));
  CHECK(tip.y() == Approx(z).epsilon(1e-9));
  const LargestDeflection largest = largest_of(line);
  CHECK(largest.size.value() == Approx(std::hypot(y, z)).epsilon(1e-9));
  CHECK(largest.at.value() == L);
}

TEST_CASE("where both directions together are farthest off is found between the places of a grid") {
  Project project = project_of(h, 0.5 * h, 0.5, 3.7);
  project.in_space = true;
  const DeflectionModel model = deflection_model_of(project);
  for (int k = 0; k < 24; ++k) {
    const double angle = 0.26 * k;
    const DeflectedLine line = DividedBeam(model).line_under(cut_forces_of(pushed_in_space(
        project, P * std::cos(angle), P * std::sin(angle), -1.7 * P * std::cos(0.6 * k))));
    double most = 0.0;
    constexpr int places = 20000;
    for (int i = 0; i <= places; ++i)
      most = std::max(most, line.at(si<Length>(L * i / places)).norm());
    const double found = largest_of(line).size.value();
    CHECK(found >= most * (1.0 - 1e-14));
    CHECK(found <= most * (1.0 + 1e-6));
  }
}

TEST_CASE("a boom that gravity bends in space: q L^4/(8 E I) + q L^2/(2 G A_v) each way") {
  // Turned about its axis, so that gravity has a part along its y.
  for (const double turned : {0.0, 30.0, 90.0}) {
    const double roll = turned * std::acos(-1.0) / 180.0;
    const std::string text = fmt::format(
        R"([case]
name = "boom"
kind = "spatial"
[mechanism]
gravity = ["0 m/s^2", "{} m/s^2", "{} m/s^2"]
[bodies.boom]
points = {{ heel = ["0 m", "0 m", "0 m"] }}
[joints.heel]
kind = "fixed"
connect = ["ground", "boom.heel"]
at = ["0 m", "0 m", "0 m"]
[motion]
duration = "1 s"
[material]
steel = "S355"
[sections.box]
kind = "box"
width = "200 mm"
height = "300 mm"
flange = "20 mm"
web = "10 mm"
[beam]
body = "boom"
start = "heel"
axis = "x"
z = "z"
density = "7850 kg/m^3"
[[beam.segments]]
length = "4 m"
from = "box"
to = "box"
[strength]
required = 1.0
[deflection]
limit = "10 mm"
against = "tangent"
at = "0 m"
)",
        -9.81 * std::sin(roll), -9.81 * std::cos(roll));
    const Project project = parse_project("boom.toml", text);
    const auto result = check_deflection(project, run_situations(project));
    REQUIRE(result);
    const double A = 0.2 * 0.3 - 0.18 * 0.26;
    const double q = 7850.0 * 9.81 * A;
    const double I_z = (h * 0.2 * 0.2 * 0.2 - (h - 0.04) * std::pow(0.18, 3)) / 12.0;
    const auto tip = [&](double load, double inertia, double area) {
      return load * (std::pow(L, 4) / (8.0 * E * inertia) + L * L / (2.0 * G * area));
    };
    const double y = tip(q * std::sin(roll), I_z, 2.0 * 0.02 * 0.2);
    const double z = tip(q * std::cos(roll), inertia_of(h), shear_area_of(h));
    CHECK(result->check.acting.value() == Approx(std::hypot(y, z)).epsilon(1e-8));
    CHECK(result->check.station.s.value() == L);
  }
}

TEST_CASE("a frame in space bends away from its unloaded axis, what its supports turn included") {
  // Pinned at both ends, forks against twisting, P in the middle along y and along z; the axis
  // turns at its start.
  const std::string text = R"([case]
name = "girder"
kind = "static"
[frame]
space = true
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[sections.box]
kind = "box"
width = "200 mm"
height = "300 mm"
flange = "20 mm"
web = "10 mm"
[beam]
density = "7850 kg/m^3"
[[beam.segments]]
length = "4 m"
section = "box"
[supports.a]
kind = "pinned"
at = ["0 m", "0 m", "0 m"]
fork = true
[supports.z]
kind = "roller"
at = ["4 m", "0 m", "0 m"]
direction = "z"
fork = true
[supports.y]
kind = "roller"
at = ["4 m", "0 m", "0 m"]
direction = "y"
[loads.p]
kind = "force"
at = ["2 m", "0 m", "0 m"]
force = ["0 kN", "35 kN", "-50 kN"]
moment = ["0 N m", "0 N m", "0 N m"]
[material]
steel = "S355"
[strength]
required = 1.0
[deflection]
limit = "10 mm"
)";
  const Project project = parse_project("girder.toml", text);
  const auto result = check_deflection(project, run_situations(project));
  REQUIRE(result);
  const double I_z = (h * 0.2 * 0.2 * 0.2 - (h - 0.04) * std::pow(0.18, 3)) / 12.0;
  const auto middle = [](double force, double inertia, double area) {
    return force * (L * L * L / (48.0 * E * inertia) + L / (4.0 * G * area));
  };
  const double y = middle(35e3, I_z, 2.0 * 0.02 * 0.2);
  const double z = middle(50e3, inertia_of(h), shear_area_of(h));
  CHECK(result->check.acting.value() == Approx(std::hypot(y, z)).epsilon(1e-6));
  CHECK(result->check.station.s.value() == Approx(2.0));
}

TEST_CASE("the check takes the largest deflection of all instants; the load factor only if asked") {
  const std::string demand = "\n[deflection]\nlimit = \"5 mm\"\nfrom = \"0 m\"\nto = \"6.2 m\"\n";
  Project project = test::changed_rig({}, demand);
  REQUIRE(project.deflection);
  CHECK(project.deflection->youngs_modulus.value() == 210e9);
  CHECK(project.deflection->shear_modulus.value() == 81e9);
  const std::deque<SituationRun> runs = run_situations(project);
  const auto result = check_deflection(project, runs);
  REQUIRE(result);
  const Check& check = result->check;
  const DeflectionModel model = deflection_model_of(project);
  const LoadHistory& loads = runs.front().loads;
  double largest = 0.0;
  for (std::size_t i = 0; i < loads.instants(); ++i) {
    const DeflectedLine line = DividedBeam(model).line_under(loads.diagram(i));
    for (int j = 0; j <= 500; ++j) {
      largest = std::max(largest, std::abs(line.at(si<Length>(6.2 * j / 500.0))[1]));
    }
  }
  CHECK(check.acting.value() >= largest * (1.0 - 1e-12));
  CHECK(check.acting.value() == Approx(largest).epsilon(0.01));
  CHECK(check.resisting.value() == Approx(0.005));
  CHECK(check.safety_factor == Approx(0.005 / check.acting.value()).epsilon(1e-12));
  const double before = check.acting.value();
  // 0.9906 mm in the place of 0.9005 had a factor of 1.1 in it.
  for (const double factor : {0.9906 / 0.9005, 1.5}) {
    project.situations.front().load_factor = factor;
    CHECK(check_deflection(project, runs)->check.acting.value() == Approx(before).epsilon(1e-12));
  }
  project.deflection->load_factor = true;
  CHECK(check_deflection(project, runs)->check.acting.value() ==
        Approx(1.5 * before).epsilon(1e-12));
}

TEST_CASE("a demand on deflection that cannot be is refused at its place") {
  const auto refused = [](const std::string& lines, const std::string& at,
                          const std::string& message, const std::string& hint) {
    test::check_refused(test::rig_text({}, "\n[deflection]\n" + lines), at, message, hint);
  };
  refused("limit = \"5 mm\"\nfrom = \"3 m\"\nto = \"3 m\" # here\n", "# here", "has no length",
          "\"from\" before \"to\"");
  refused("limit = \"0 mm\" # here\nfrom = \"0 m\"\nto = \"3 m\"\n", "# here",
          "\"limit\" must be above zero", "");
  refused("limit = \"5 mm\"\nfrom = \"0 m\"\nto = \"7 m\" # here\n", "# here",
          "lies behind the end of the beam", "from 0 to 6.2 m");
  refused("limit = \"5 mm\"\nfrom = \"0 m\" # here\n", "[deflection]", "has no \"to\"", "");
  refused("limit = \"5 mm\"\nagainst = \"tangent\"\nfrom = \"0 m\" # here\nto = \"3 m\"\n",
          "# here", "the ends of a chord", "against = \"chord\"");
  refused(
      "limit = \"5 mm\"\nagainst = \"chord\"\nfrom = \"0 m\"\nto = \"3 m\"\n"
      "at = \"0 m\" # here\n",
      "# here", "where a tangent touches the beam", "against = \"tangent\"");
  refused("limit = \"5 mm\"\nagainst = \"arc\" # here\n", "# here", "arc", "tangent");
  // The rig's beam is held at three places.
  refused("limit = \"5 mm\"\n", "[deflection]", "does not say from which line", "\"chord\"");
  refused("limit = \"5 mm\"\nagainst = \"axis\" # here\n", "# here", "does not say from which line",
          "\"tangent\"");
}

TEST_CASE("a deflection of a beam without segments is refused like the beam", "[bad_input]") {
  std::string text = test::read_file(test::project_file("sections/templates/planar.toml"));
  const std::size_t from = text.find("\n[[beam.segments]]");
  const std::size_t to = text.find("\n[material]");
  REQUIRE(from < to);
  text.replace(from, to - from, "\n[deflection]\nlimit = \"5 mm\"\n");
  CHECK_THROWS_AS(parse_project("case.toml", text), InputError);
}

}  // namespace deflection_test
