// Extremes in time, against functions whose extremes are known and against the exact motion.

#include "boxbeam/verification/load_history.hpp"

#include <cmath>
#include <deque>
#include <numbers>
#include <string>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "catch.hpp"
#include "support/rig.hpp"

namespace load_history_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;

TaperedBeam metre_of_tube() {
  const Section tube{RoundTube{0.1 * metre, 0.01 * metre}, {}};
  TaperedBeam beam;
  beam.segments = {{"", Length{}, 1.0 * metre, tube, tube}};
  return beam;
}

/// A beam pulled by f(t): N = f(t) all along.
template <class Function>
LoadHistory pulled(const TaperedBeam& beam, double period, std::size_t instants,
                   const Function& f) {
  return {{Time{}, si<Time>(period), instants}, [&beam, f](Time time) {
            BeamLoads loads;
            PointLoad first, last;
            last.s = beam.length();
            last.force.x() = f(time.value());
            first.force.x() = -last.force.x();
            loads.points = {first, last};
            loads.lines = unloaded_lines(beam);
            return loads;
          }};
}

double axial(const CutForces& cut) { return cut.N.value(); }

/// A bar AB of 1 m that is pushed along by its end A, one end (`led`) on a line through a pin of
/// the ground in the bar's slot; the pin stands in the bar's middle at first, and `stroke` nearer
/// to A in the end.
Project pushed_through(const std::string& stroke, const std::string& led) {
  return parse_project(
      "bar.toml",
      "[case]\nname = \"bar\"\nkind = \"planar\"\n"
      "[mechanism]\ngravity = [\"0 m/s^2\", \"-10 m/s^2\"]\n"
      "[bodies.bar]\npoints = { A = [\"0 m\", \"0 m\"], B = [\"1 m\", \"0 m\"] }\n"
      "sketch = { at = [\"-0.5 m\", \"0 m\"] }\n"
      "[joints.line]\nkind = \"pin in slot\"\npoint = \"bar." +
          led +
          "\"\nthrough = [\"0 m\", \"0 m\"]\n"
          "direction = \"0 deg\"\n"
          "[joints.slot]\nkind = \"pin in slot\"\npoint = \"ground\"\nat = [\"0 m\", \"0 m\"]\n"
          "guide = \"bar.A\"\ndirection = \"0 deg\"\n"
          "[drivers.push]\nkind = \"polynomial\"\npoint = \"bar.A\"\ncoordinate = \"x\"\n"
          "coefficients = [\"-0.5 m\", \"" +
          stroke +
          "/s\"]\n[motion]\nduration = \"1 s\"\n"
          "[sections.tube]\nkind = \"round tube\"\ndiameter = \"100 mm\"\nwall = \"5 mm\"\n"
          "[beam]\nbody = \"bar\"\ndensity = \"8000 kg/m^3\"\n"
          "[[beam.segments]]\nlength = \"1 m\"\nsection = \"tube\"\n"
          "[material]\nsteel = \"S355\"\n[strength]\nrequired = 1.0\n"
          "[fatigue]\ncategory = 100\ncycles = 1e6\nloading = \"spectrum\"\ngamma_Mf = 1.0\n"
          "required = 1.0\n");
}

}  // namespace

TEST_CASE("extremes between the instants: a sine out of step with them") {
  const TaperedBeam beam = metre_of_tube();
  const double phase = 0.123;
  const LoadHistory loads =
      pulled(beam, 2.0, 24, [&](double t) { return 3.0 + 7.0 * std::sin(pi * t + phase); });
  const StationHistory history(loads, {0.5 * metre});
  const auto turns = history.turning_points(axial);
  REQUIRE(turns.size() == 2);
  // By hand: the sine is 1 at pi t + phase = pi/2 and -1 at 3 pi/2.
  CHECK(turns[0].maximum);
  CHECK(turns[0].value == Approx(10.0).epsilon(1e-12));
  CHECK(turns[0].time.value() == Approx(0.5 - phase / pi).margin(1e-6));
  CHECK(turns[1].value == Approx(-4.0).epsilon(1e-12));
  CHECK(turns[1].time.value() == Approx(1.5 - phase / pi).margin(1e-6));
  CHECK(history.largest(axial).value == Approx(10.0).epsilon(1e-12));
}

TEST_CASE("a second harmonic gives four turning points, and a maximum at t = 0 is not lost") {
  const TaperedBeam beam = metre_of_tube();
  const LoadHistory loads = pulled(beam, 1.0, 96, [](double t) {
    return std::cos(2.0 * pi * t) + 0.8 * std::cos(4.0 * pi * t);
  });
  const StationHistory history(loads, {0.5 * metre});
  const auto turns = history.turning_points(axial);
  REQUIRE(turns.size() == 4);
  // d/dt = 0 at sin = 0 and at cos(2 pi t) = -1/(4 0.8): values 1.8, -0.2 and -0.8 - 1/(8 0.8).
  CHECK(turns[0].time.value() == Approx(0.0).margin(1e-6));
  CHECK(turns[0].value == Approx(1.8).epsilon(1e-12));
  CHECK(turns[1].value == Approx(-0.8 - 1.0 / 6.4).epsilon(1e-11));
  CHECK(turns[2].value == Approx(-0.2).epsilon(1e-11));
}

TEST_CASE("a constant has one turning point and round-off has none") {
  const TaperedBeam beam = metre_of_tube();
  const LoadHistory constant = pulled(beam, 1.0, 24, [](double) { return 5.0; });
  const StationHistory history(constant, {0.5 * metre});
  CHECK(history.turning_points(axial).size() == 1);
  CHECK(history.largest(axial).value == 5.0);
  const LoadHistory noisy =
      pulled(beam, 1.0, 24, [](double t) { return 5.0 + 1e-12 * std::sin(40.0 * t); });
  const StationHistory quiet(noisy, {0.5 * metre});
  CHECK(quiet.turning_points(axial).size() == 1);
}

TEST_CASE("interpolated cut forces of the rig equal the mechanism solved anew") {
  const Project& project = test::rig();
  const planar::Motion motion = planar::solve_motion(planar_of(project));
  const planar::BeamBody body = planar::beam_body_of(project.beam, project.beam_body);
  planar::StateFinder finder(planar_of(project), motion);
  const LoadHistory loads({Time{}, si<Time>(motion.period), motion.states.size()}, [&](Time time) {
    return planar::beam_loads_of(planar_of(project), finder.at(time.value()), body);
  });
  const StationHistory history(loads, {4.2 * metre});
  for (int i = 0; i < 200; ++i) {
    const Time time = si<Time>(motion.period * (i + 0.37) / 200.0);
    const CutForces exact = loads.diagram_at(time).at({4.2 * metre});
    const CutForces interpolated = history.at(time);
    // Relative to the largest moment, 216 kN m, and force, 105 kN, of the station.
    CHECK(std::abs((exact.M_y - interpolated.M_y).value()) < 1e-10 * 2e5);
    CHECK(std::abs((exact.N - interpolated.N).value()) < 1e-10 * 1e5);
    CHECK(std::abs((exact.V_z - interpolated.V_z).value()) < 1e-10 * 1e5);
  }
}

TEST_CASE("a load that slides along the beam: M peaks as it passes a station (influence line)") {
  // Simply supported, load P at s(t): M at s_0 is largest when P stands there, P s_0 (L - s_0)/L;
  // V jumps by P, from P (L - s_0)/L just behind the passage to -P s_0/L just before it.
  // Source: influence lines of the simple beam, any statics book.
  const TaperedBeam beam = metre_of_tube();
  const double L = beam.length().value();
  const double P = 700.0;
  const LoadHistory loads({Time{}, 2.0 * second, 40, false}, [&](Time time) {
    const double s = L * (0.07 + 0.43 * time.value());
    BeamLoads at;
    at.points = {{Length{}, {0.0, 0.0, P * (L - s) / L}, Eigen::Vector3d::Zero()},
                 {si<Length>(s), {0.0, 0.0, -P}, Eigen::Vector3d::Zero()},
                 {si<Length>(L), {0.0, 0.0, P * s / L}, Eigen::Vector3d::Zero()}};
    at.lines = unloaded_lines(beam);
    return at;
  });
  const auto bending = [](const CutForces& cut) { return cut.M_y.value(); };
  const auto shear = [](const CutForces& cut) { return cut.V_z.value(); };
  for (const double s_0 : {0.211 * L, 0.5 * L, 0.83 * L}) {
    const StationHistory history(loads, {si<Length>(s_0)});
    // The sign of M for this load: z up, the part before the cut is pushed up at its support.
    const double expected = P * s_0 * (L - s_0) / L;
    const double low = -history.largest([&](const CutForces& c) { return -bending(c); }).value;
    const double high = history.largest(bending).value;
    CHECK(std::max(std::abs(low), std::abs(high)) == Approx(expected).epsilon(1e-10));
    const double least = -history.largest([&](const CutForces& c) { return -shear(c); }).value;
    const double most = history.largest(shear).value;
    CHECK(std::max(std::abs(least), std::abs(most)) ==
          Approx(P * std::max(s_0, L - s_0) / L).epsilon(1e-10));
    // Both sides of the one passage, 1e-5 of a half step from it: there the moment is the largest
    // one, and V jumps by P.
    const std::vector<StationHistory::Passage> passages = history.passages();
    REQUIRE(passages.size() == 1);
    const StationHistory::Passage& passage = passages.front();
    CHECK(passage.time.value() == Approx((s_0 / L - 0.07) / 0.43).epsilon(1e-8));
    CHECK(std::abs(bending(passage.before)) == Approx(expected).epsilon(1e-6));
    CHECK(std::abs(bending(passage.behind)) == Approx(expected).epsilon(1e-6));
    const double sign = shear(passage.behind) > 0.0 ? 1.0 : -1.0;
    CHECK(sign * shear(passage.before) == Approx(-P * s_0 / L).epsilon(1e-6));
    CHECK(sign * shear(passage.behind) == Approx(P * (L - s_0) / L).epsilon(1e-6));
  }
}

TEST_CASE("a load at uneven speed is met with few instants more than one at even speed") {
  // M at s_0 is largest when P stands there, P s_0 (L - s_0)/L. By halvings alone, down to the last
  // bit of its time, each meeting took some 40 more, and three are looked for.
  const TaperedBeam beam = metre_of_tube();
  const double L = beam.length().value();
  constexpr double P = 700.0;
  const auto asked_with = [&](const auto& place_at) {
    int asked = 0;
    const LoadHistory loads({Time{}, 2.0 * second, 40, false}, [&](Time time) {
      ++asked;
      const double s = L * place_at(time.value());
      BeamLoads at;
      at.points = {{Length{}, {0.0, 0.0, P * (L - s) / L}, Eigen::Vector3d::Zero()},
                   {si<Length>(s), {0.0, 0.0, -P}, Eigen::Vector3d::Zero()},
                   {si<Length>(L), {0.0, 0.0, P * s / L}, Eigen::Vector3d::Zero()}};
      at.lines = unloaded_lines(beam);
      return at;
    });
    const double s_0 = 0.711 * L;
    const StationHistory history(loads, {si<Length>(s_0)});
    asked = 0;
    const auto bending = [](const CutForces& cut) { return cut.M_y.value(); };
    const double low = -history.largest([&](const CutForces& c) { return -bending(c); }).value;
    const double high = history.largest(bending).value;
    CHECK(std::max(std::abs(low), std::abs(high)) ==
          Approx(P * s_0 * (L - s_0) / L).epsilon(1e-10));
    return asked;
  };
  const int even = asked_with([](double t) { return 0.07 + 0.43 * t; });
  const int uneven = asked_with([](double t) { return 0.5 - 0.45 * std::cos(0.5 * pi * t); });
  INFO(even << " and " << uneven);
  CHECK(uneven < even + 60);
}

TEST_CASE("an extreme at a passage is found though an instant before it stands higher") {
  // The right support bears P s/L = g(t), a wave that dips at the instant before the passage and is
  // higher there than at the instants before; V is that until the load has passed.
  const TaperedBeam beam = metre_of_tube();
  const double L = beam.length().value(), step = 0.05, crest = 1.0;
  const auto g = [&](double t) {
    const double steps = (t - crest) / step;
    return 700.0 * (1.0 + 0.05 * std::cos(2.0 * pi * steps / 1.6) + 0.02 * steps);
  };
  const auto place = [&](double t) { return L * (0.07 + 0.43 * t); };
  const LoadHistory loads({Time{}, 2.0 * second, 40, false}, [&](Time time) {
    const double s = place(time.value()), right = g(time.value());
    BeamLoads at;
    at.points = {{Length{}, {0.0, 0.0, right * (L - s) / s}, Eigen::Vector3d::Zero()},
                 {si<Length>(s), {0.0, 0.0, -right * L / s}, Eigen::Vector3d::Zero()},
                 {si<Length>(L), {0.0, 0.0, right}, Eigen::Vector3d::Zero()}};
    at.lines = unloaded_lines(beam);
    return at;
  });
  const double passes = crest + 1.5 * step;
  REQUIRE(g(crest) > g(crest + step));
  REQUIRE(g(passes) > g(crest));
  const StationHistory history(loads, {si<Length>(place(passes))});
  const auto shear = [](const CutForces& cut) { return std::abs(cut.V_z.value()); };
  const TurningPoint largest = history.largest(shear);
  CHECK(largest.value == Approx(g(passes)).epsilon(1e-6));
  CHECK(largest.time.value() == Approx(passes).epsilon(1e-6));
  double highest = 0.0;
  for (const TurningPoint& of : history.turning_points(shear)) {
    // On either side of the passage, too, the loads at the time said are those of the value said.
    CHECK(shear(history.at(of.time)) == Approx(of.value).epsilon(1e-9));
    if (of.maximum) highest = std::max(highest, of.value);
  }
  CHECK(highest == Approx(g(passes)).epsilon(1e-6));
}

TEST_CASE("a joint that slides along the beam bears on it, beyond either end it is an error") {
  // The pin stands where the bar was pushed to, s = 0.5 m - stroke. At s = 0.1 m weight W and both
  // bearings balance: W 0.5/0.1 on the pin, the rest at A.
  const Project held = pushed_through("0.4 m", "A");
  const std::deque<SituationRun> runs = run_situations(held);
  const BeamLoads loads = runs.front().loads.loads_at(1.0 * second);
  const double W = 8000.0 * 10.0 * pi / 4.0 * (0.1 * 0.1 - 0.09 * 0.09);
  bool found = false;
  for (const PointLoad& load : loads.points) {
    if (load.s.value() < 0.05) continue;
    found = true;
    CHECK(load.s.value() == Approx(0.1).epsilon(1e-9));
    CHECK(load.force.z() == Approx(5.0 * W).epsilon(1e-9));
  }
  CHECK(found);
  // Led by the far end, since nothing holds a bar that is led where the pin stands.
  for (const auto& [stroke, led] : {std::pair("0.6 m", "B"), {"-0.6 m", "A"}}) {
    const Project off = pushed_through(stroke, led);
    CAPTURE(stroke);
    try {
      run_situations(off);
      FAIL("the joint has left the beam");
    } catch (const AnalysisError& error) {
      CHECK(error.failure().what.find("a joint slides off the beam") != std::string::npos);
      CHECK(error.failure().what.find("the beam goes from 0 to 1 m") != std::string::npos);
      CHECK(error.failure().where == "beam");
      // The way to either end is 0.5 m, at 0.6 m/s.
      REQUIRE(error.failure().time);
      CHECK(*error.failure().time > 0.5 / 0.6);
    }
  }
}

TEST_CASE("an open history may have its extreme at its end") {
  const TaperedBeam beam = metre_of_tube();
  const LoadHistory loads({Time{}, 1.0 * second, 10, false}, [&](Time time) {
    BeamLoads at;
    const double N = 3.0 + time.value() * time.value();
    at.points = {{Length{}, {-N, 0.0, 0.0}, Eigen::Vector3d::Zero()},
                 {beam.length(), {N, 0.0, 0.0}, Eigen::Vector3d::Zero()}};
    at.lines = unloaded_lines(beam);
    return at;
  });
  const StationHistory history(loads, {0.5 * metre});
  const TurningPoint most = history.largest(axial);
  CHECK(most.value == Approx(4.0).epsilon(1e-12));
  CHECK(most.time.value() == Approx(1.0).epsilon(1e-12));
  double low = 1e300;
  double high = -1e300;
  for (const TurningPoint& turn : history.turning_points(axial)) {
    low = std::min(low, turn.value);
    high = std::max(high, turn.value);
  }
  CHECK(low == Approx(3.0).epsilon(1e-12));
  CHECK(high == Approx(4.0).epsilon(1e-12));
}

}  // namespace load_history_test
