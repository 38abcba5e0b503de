// The deflection of the beam against closed forms of bending and shear (Timoshenko, Strength of
// Materials I) and against integrals of this file's own.

#include "boxbeam/verification/deflection.hpp"

#include <cmath>
#include <functional>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "support/changed_rig.hpp"
#include "support/rig.hpp"

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
  project.deflection = DeflectionInput{si<Length>(0.01), si<Length>(from), si<Length>(to),
                                       si<Stress>(E), si<Stress>(G)};
  return project;
}

struct Push {
  double at, size;  ///< [m], along +z [N]
};

/// Deflection at the places of the model, by place; zero at the supports.
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
  const DeflectionModel model = deflection_model_of(project);
  const std::vector<double> values = deflections_of(model, cut_forces_of(loads));
  return [model, values](double s) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::abs(model.influences[i].at.value() - s) < 1e-9) return values[i];
    }
    return std::nan("");
  };
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
  const DeflectionModel model = deflection_model_of(project);
  const std::vector<double> values = deflections_of(model, cut_forces_of(loads));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double x = model.influences[i].at.value();
    const double free = P * x * x * (3 * L - x) / (6 * EI);
    const double chord = x / L * P * L * L * L / (3 * EI);
    CHECK(values[i] == Approx(chord - free).epsilon(1e-9));
  }
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

TEST_CASE("the check takes the largest deflection of all instants, times the load factor") {
  Project project =
      test::changed_rig({}, "\n[deflection]\nlimit = \"5 mm\"\nfrom = \"0 m\"\nto = \"6.2 m\"\n");
  REQUIRE(project.deflection);
  CHECK(project.deflection->youngs_modulus.value() == 210e9);
  CHECK(project.deflection->shear_modulus.value() == 81e9);
  const std::deque<SituationRun> runs = run_situations(project);
  const auto check = check_deflection(project, runs);
  REQUIRE(check);
  const DeflectionModel model = deflection_model_of(project);
  const LoadHistory& loads = runs.front().loads;
  double largest = 0.0;
  for (std::size_t i = 0; i < loads.instants(); ++i) {
    for (const double value : deflections_of(model, loads.diagram(i))) {
      largest = std::max(largest, std::abs(value));
    }
  }
  CHECK(check->acting.value() >= largest * (1.0 - 1e-12));
  CHECK(check->acting.value() == Approx(largest).epsilon(0.01));
  CHECK(check->resisting.value() == Approx(0.005));
  CHECK(check->safety_factor == Approx(0.005 / check->acting.value()).epsilon(1e-12));
  const double before = check->acting.value();
  project.situations.front().load_factor = 1.5;
  CHECK(check_deflection(project, runs)->acting.value() == Approx(1.5 * before).epsilon(1e-12));
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
}
