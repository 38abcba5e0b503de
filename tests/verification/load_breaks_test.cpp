// Extremes over time where loads bend or jump: at points of tables, ends of smooth steps, and where
// nobody said so before.

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/verification/load_history.hpp"
#include "catch.hpp"
#include "support/random_tree.hpp"

namespace load_breaks_test {

using namespace boxbeam;

namespace {

constexpr double pi = std::numbers::pi;

TaperedBeam metre_of_box() {
  const Section box{symmetric_box(0.1 * metre, 0.1 * metre, 0.005 * metre, 0.005 * metre), {}};
  TaperedBeam beam;
  beam.density = si<Density>(7850.0);
  beam.segments = {{"", Length{}, 1.0 * metre, box, box}};
  return beam;
}

double axial(const CutForces& cut) { return cut.N.value(); }

/// Ends pulled apart by a force over time.
template <class Function>
LoadHistory pulled(const TaperedBeam& beam, LoadSpan span, const Function& force) {
  return {span, [&beam, force](Time time) {
            BeamLoads loads;
            const double N = force(time.value());
            loads.points = {{Length{}, {-N, 0.0, 0.0}, Eigen::Vector3d::Zero()},
                            {beam.length(), {N, 0.0, 0.0}, Eigen::Vector3d::Zero()}};
            loads.lines = unloaded_lines(beam);
            return loads;
          }};
}

std::vector<Time> breaks_of_driver(const Driver& driver, double from, double length) {
  std::vector<Time> times;
  for (const Break& at : breaks_of(driver, from, from + length)) times.push_back(si<Time>(at.at));
  return times;
}

/// 5 to 12 points at random times from 0 to 1 s, the last as the first.
Driver random_table(test::Chance& chance, Interpolation interpolation, Beyond beyond) {
  std::vector<double> x{0.0}, y;
  const int count = 5 + chance.one_of(8);
  for (int i = 1; i < count; ++i) x.push_back(x.back() + 0.3 + 0.25 * (1.0 + chance.any()));
  for (double& at : x) at /= x.back();
  x.back() = 1.0;
  for (int i = 0; i < count; ++i) y.push_back(chance.any(10.0));
  y.back() = y.front();
  return TableDriver{TableCurve(x, y, interpolation, beyond)};
}

/// What the search says at a time is what the loads are then.
void check_agrees(const LoadHistory& loads, const StationHistory& history, const TurningPoint& turn,
                  const CutForceFunction& f, double size) {
  CHECK(f(history.at(turn.time)) == Approx(turn.value).margin(1e-9 * size));
  CHECK(f(loads.diagram_at(turn.time).at(history.station())) ==
        Approx(turn.value).margin(1e-9 * size));
}

}  // namespace

TEST_CASE("150 tables of straight lines: the largest and the turning points are the tables' own") {
  test::Chance chance(31);
  const TaperedBeam beam = metre_of_box();
  for (int i = 0; i < 150; ++i) {
    const bool closed = i % 2 == 0;
    const Driver driver =
        random_table(chance, Interpolation::linear, closed ? Beyond::periodic : Beyond::hold);
    const auto& curve = std::get<TableDriver>(driver).curve;
    const LoadSpan span{Time{}, 1.0 * second, 48, closed, breaks_of_driver(driver, 0.0, 1.0)};
    const LoadHistory loads =
        pulled(beam, span, [&](double t) { return driver_at(driver, t).value; });
    const StationHistory history(loads, {0.5 * metre});
    const double most = *std::max_element(curve.values().begin(), curve.values().end());
    const double least = *std::min_element(curve.values().begin(), curve.values().end());
    const TurningPoint highest = history.largest(axial);
    CHECK(highest.value == Approx(most).margin(1e-9));
    check_agrees(loads, history, highest, axial, 10.0);
    const TurningPoint lowest = history.largest([](const CutForces& c) { return -axial(c); });
    CHECK(-lowest.value == Approx(least).margin(1e-9));
    // Every inner point that is higher or lower than its neighbours is a turning point.
    std::vector<double> corners;
    for (std::size_t k = 1; k + 1 < curve.values().size(); ++k) {
      const double before = curve.values()[k] - curve.values()[k - 1];
      const double behind = curve.values()[k] - curve.values()[k + 1];
      if (before * behind > 0.0) corners.push_back(curve.values()[k]);
    }
    const auto turns = history.turning_points(axial);
    for (const double corner : corners) {
      CHECK(std::any_of(turns.begin(), turns.end(), [&](const TurningPoint& turn) {
        return std::abs(turn.value - corner) < 1e-8;
      }));
    }
    CHECK(turns.size() <= corners.size() + 2);
    for (const TurningPoint& turn : turns) check_agrees(loads, history, turn, axial, 10.0);
  }
}

TEST_CASE(
    "150 motion tables: a beam pushed to and fro bears its mass times the highest acceleration") {
  // The acceleration of a cubic spline is straight from point to point: largest at one of them.
  test::Chance chance(32);
  const TaperedBeam beam = metre_of_box();
  const MassProperties properties = mass_properties_of(beam);
  double without = 0.0;  // what instants alone would miss
  for (int i = 0; i < 150; ++i) {
    planar::Mechanism mechanism;
    Body body;
    body.name = "beam";
    body.mass = properties.mass.value();
    body.inertia = properties.inertia.value();
    mechanism.bodies = {body};
    planar::Slider slider;
    slider.point = {0, {-0.5, 0.0}};
    planar::Driven push;
    push.point = {0, {-0.5, 0.0}};
    push.driver = random_table(chance, Interpolation::cubic, Beyond::periodic);
    mechanism.joints = {{"guide", slider}, {"push", push}};
    const planar::Motion motion = planar::solve_motion(mechanism, 96);
    const auto finder = std::make_shared<planar::StateFinder>(mechanism, motion);
    const planar::BeamBody of = planar::beam_body_of(beam, 0);
    LoadSpan span{si<Time>(motion.begin), si<Time>(motion.period), motion.states.size(),
                  motion.closed, breaks_of_driver(push.driver, motion.begin, motion.period)};
    const LoadHistory loads(span, [&, finder](Time time) {
      return planar::beam_loads_of(mechanism, finder->at(time.value()), of);
    });
    double highest = -1e300;
    for (const double at : std::get<TableDriver>(push.driver).curve.points()) {
      highest = std::max(highest, -driver_at(push.driver, at).acceleration);
    }
    const double root = body.mass * highest;
    const StationHistory history(loads, {Length{}, Side::behind});
    const TurningPoint found = history.largest(axial);
    CHECK(found.value == Approx(root).epsilon(1e-9));
    check_agrees(loads, history, found, axial, std::abs(root));
    span.breaks.clear();
    double by_instants = -1e300;
    for (const planar::State& state : motion.states) {
      by_instants = std::max(by_instants, -body.mass * state.a[0]);
    }
    without = std::max(without, (root - by_instants) / std::abs(root));
  }
  CHECK(without > 1e-3);  // the peaks do lie between instants
}

TEST_CASE("150 tables turn a crank: the peaks of a slider-crank are those of dense samples") {
  test::Chance chance(33);
  const TaperedBeam beam = metre_of_box();
  const MassProperties properties = mass_properties_of(beam);
  for (int i = 0; i < 150; ++i) {
    planar::Mechanism mechanism;
    Body crank, rod;
    crank.name = "crank";
    rod.name = "rod";
    rod.mass = properties.mass.value();
    rod.inertia = properties.inertia.value();
    const double r = 0.2 + 0.1 * chance.any();
    rod.sketch.centre = {r + 0.5, 0.0};
    mechanism.bodies = {crank, rod};
    planar::Pin shaft, wrist;
    shaft.a = {0, {0.0, 0.0}};
    wrist.a = {0, {r, 0.0}};
    wrist.b = {1, {-0.5, 0.0}};
    planar::PinInSlot cross;
    cross.point = {1, {0.5, 0.0}};
    planar::Driven turn;
    turn.point = {0, {0.0, 0.0}};
    turn.coordinate = planar::Coordinate::angle;
    std::vector<double> x{0.0}, y;
    const int count = 5 + chance.one_of(6);
    for (int k = 1; k < count; ++k) x.push_back(x.back() + 1.0 + 0.4 * chance.any());
    for (double& at : x) at /= x.back();
    for (int k = 0; k < count; ++k) y.push_back(chance.any(0.7));
    y.back() = y.front();
    turn.driver = TableDriver{TableCurve(x, y, Interpolation::cubic, Beyond::periodic)};
    mechanism.joints = {{"shaft", shaft}, {"wrist", wrist}, {"cross", cross}, {"turn", turn}};
    const planar::Motion motion = planar::solve_motion(mechanism);
    const auto finder = std::make_shared<planar::StateFinder>(mechanism, motion);
    const planar::BeamBody of = planar::beam_body_of(beam, 1);
    const LoadSpan span{si<Time>(motion.begin), si<Time>(motion.period), motion.states.size(),
                        motion.closed, breaks_of_driver(turn.driver, motion.begin, motion.period)};
    const LoadHistory loads(span, [&, finder](Time time) {
      return planar::beam_loads_of(mechanism, finder->at(time.value()), of);
    });
    const Station station{0.5 * metre};
    const StationHistory history(loads, station);
    const auto moment = [](const CutForces& cut) { return cut.M_y.value(); };
    double high = -1e300, low = 1e300;
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
      constexpr int dense = 60;
      for (int j = 0; j <= dense; ++j) {
        const double t = x[k] + (x[k + 1] - x[k]) * j / dense;
        const double M = moment(loads.diagram_at(si<Time>(t)).at(station));
        high = std::max(high, M);
        low = std::min(low, M);
      }
    }
    const TurningPoint most = history.largest(moment);
    const TurningPoint least = history.largest([&](const CutForces& c) { return -moment(c); });
    const double size = std::max(std::abs(high), std::abs(low));
    CHECK(most.value >= high - 1e-7 * size);
    CHECK(-least.value <= low + 1e-7 * size);
    // And no higher than the curve between samples, whose sag is (pi/60)^2/8 of a wave.
    CHECK(most.value <= high + 2e-3 * size);
    CHECK(-least.value >= low - 2e-3 * size);
    check_agrees(loads, history, most, moment, size * 10.0);
  }
}

TEST_CASE("a force that jumps: both values at the jump count, and each is that of its time") {
  const TaperedBeam beam = metre_of_box();
  for (const bool closed : {true, false}) {
    const Driver steps =
        TableDriver{TableCurve({0.0, 0.31, 0.5, 0.77, 1.0}, {2.0, -5.0, 7.0, 1.0, 2.0},
                               Interpolation::step, closed ? Beyond::periodic : Beyond::hold)};
    const LoadSpan span{Time{}, 1.0 * second, 24, closed, breaks_of_driver(steps, 0.0, 1.0)};
    // On its way from 0.31 to 0.5 s the wave goes up by 3 sin(0.19 2 pi).
    const LoadHistory loads = pulled(beam, span, [&](double t) {
      return driver_at(steps, t).value + 3.0 * std::sin(2.0 * pi * (t - 0.31));
    });
    const StationHistory history(loads, {0.5 * metre});
    const TurningPoint most = history.largest(axial);
    CHECK(most.value == Approx(10.0).epsilon(1e-9));  // 7 + 3 at 0.31 + 0.25
    CHECK(most.time.value() == Approx(0.56).epsilon(1e-6));
    check_agrees(loads, history, most, axial, 10.0);
    const TurningPoint least = history.largest([](const CutForces& cut) { return -axial(cut); });
    CHECK(-least.value == Approx(-5.0).epsilon(1e-9));  // just behind 0.31 s
    CHECK(least.time.value() == Approx(0.31).epsilon(1e-9));
    check_agrees(loads, history, {least.time, -least.value, false}, axial, 10.0);
    // Just before 0.31 s the value is 2, before 0.77 s 7 + 3 sin(0.46 2 pi).
    const auto turns = history.turning_points(axial);
    const auto is_turn = [&](double value) {
      return std::any_of(turns.begin(), turns.end(), [&](const TurningPoint& turn) {
        return std::abs(turn.value - value) < 1e-6;
      });
    };
    CHECK(is_turn(10.0));
    CHECK(is_turn(-5.0));
  }
}

TEST_CASE("a spike between two instants is seen where its corners are known") {
  const TaperedBeam beam = metre_of_box();
  const Driver spike =
      TableDriver{TableCurve({0.0, 0.4990, 0.4995, 0.5000, 1.0}, {0.0, 0.0, 4.0, 0.0, 0.0},
                             Interpolation::linear, Beyond::hold)};
  const LoadSpan span{Time{}, 1.0 * second, 10, false, breaks_of_driver(spike, 0.0, 1.0)};
  const LoadHistory loads = pulled(beam, span, [&](double t) { return driver_at(spike, t).value; });
  const StationHistory history(loads, {0.5 * metre});
  CHECK(history.largest(axial).value == Approx(4.0).epsilon(1e-8));
  CHECK(history.largest(axial).time.value() == Approx(0.4995).epsilon(1e-9));
  // The instants at equal steps are still there, once each.
  REQUIRE(loads.even_instants() == 11);
  for (std::size_t k = 0; k < 11; ++k) {
    const double t = 0.1 * static_cast<double>(k);
    CHECK(axial(loads.even_diagram(k).at({0.5 * metre})) ==
          Approx(driver_at(spike, t).value).margin(1e-6));
  }
}

TEST_CASE("loads that bend or jump where nobody said so are found all the same") {
  const TaperedBeam beam = metre_of_box();
  test::Chance chance(34);
  for (int i = 0; i < 100; ++i) {
    const double corner = 0.5 + chance.any(0.3), slope = 2.0 + chance.any();
    const LoadSpan span{Time{}, 1.0 * second, 48, true};
    // A roof: highest at its corner, wherever the instants are.
    const LoadHistory roof = pulled(
        beam, span, [&](double t) { return 5.0 - slope * std::abs(std::sin(pi * (t - corner))); });
    const StationHistory history(roof, {0.5 * metre});
    const TurningPoint most = history.largest(axial);
    // What is left of a bend in a polynomial that passes for smooth: 3e-5 of the whole.
    CHECK(most.value == Approx(5.0).margin(3e-5 * 5.0));
    CHECK(most.time.value() == Approx(corner).margin(1e-4));
    check_agrees(roof, history, most, axial, 3e-5 * 5.0 / 1e-9);
    // A saw: it climbs and falls down at once.
    const LoadHistory saw = pulled(beam, span, [&](double t) {
      const double from = t - corner;
      return slope * (from - std::floor(from));
    });
    CHECK(StationHistory(saw, {0.5 * metre}).largest(axial).value == Approx(slope).epsilon(1e-4));
  }
}

TEST_CASE("a load that grows while it slides over a station is largest where dense samples say") {
  const TaperedBeam beam = metre_of_box();
  const double L = 1.0;
  test::Chance chance(35);
  for (int i = 0; i < 20; ++i) {
    const double phase = chance.any(3.0), station = 0.5 + chance.any(0.35);
    const LoadHistory loads({Time{}, 2.0 * second, 32, false}, [&](Time time) {
      const double s = L * (0.07 + 0.43 * time.value());
      const double P = 700.0 + 500.0 * std::sin(9.0 * time.value() + phase);
      BeamLoads at;
      at.points = {{Length{}, {0.0, 0.0, P * (L - s) / L}, Eigen::Vector3d::Zero()},
                   {si<Length>(s), {0.0, 0.0, -P}, Eigen::Vector3d::Zero()},
                   {si<Length>(L), {0.0, 0.0, P * s / L}, Eigen::Vector3d::Zero()}};
      at.lines = unloaded_lines(beam);
      return at;
    });
    const Station at{si<Length>(station)};
    const StationHistory history(loads, at);
    for (const auto& f : {CutForceFunction([](const CutForces& c) { return c.V_z.value(); }),
                          CutForceFunction([](const CutForces& c) { return -c.V_z.value(); }),
                          CutForceFunction([](const CutForces& c) { return c.M_y.value(); }),
                          CutForceFunction([](const CutForces& c) { return -c.M_y.value(); })}) {
      double dense = -1e300;
      for (int k = 0; k <= 4000; ++k) {
        dense = std::max(dense, f(loads.diagram_at(si<Time>(2.0 * k / 4000.0)).at(at)));
      }
      const double found = history.largest(f).value;
      CHECK(found >= dense - 1e-3);
      CHECK(found <= dense + 5.0);  // slope times the step of the samples
    }
  }
}

}  // namespace load_breaks_test
