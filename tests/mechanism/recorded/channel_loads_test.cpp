// Loads that are given: what must hold of any of them.

#include "boxbeam/mechanism/recorded/channel_loads.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "boxbeam/verification/load_history.hpp"
#include "catch.hpp"

namespace channel_loads_test {

using namespace boxbeam;
using recorded::SixForces;

namespace {

TaperedBeam two_segments() {
  TaperedBeam beam;
  const Section section{Box{si<Length>(0.15),
                            si<Length>(0.3),
                            si<Length>(0.012),
                            si<Length>(0.012),
                            si<Length>(0.008),
                            si<Length>(0.008),
                            {}},
                        {}};
  beam.segments.push_back({"a", Length{}, si<Length>(1.3), section, section});
  beam.segments.push_back({"b", si<Length>(1.3), si<Length>(2.1), section, section});
  beam.density = si<Density>(7850.0);
  return beam;
}

double between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

SixForces six_of(const CutForces& cut) {
  return {cut.N.value(), cut.V_y.value(), cut.V_z.value(),
          cut.T.value(), cut.M_y.value(), cut.M_z.value()};
}

BeamLoads random_loads(std::mt19937_64& random, const TaperedBeam& beam) {
  BeamLoads loads{{}, unloaded_lines(beam)};
  for (const double s : {0.0, 0.7, 2.2, 3.4}) {
    PointLoad& load = loads.points.emplace_back();
    load.s = si<Length>(s);
    for (int k = 0; k < 3; ++k) {
      load.force[k] = between(random, -1e4, 1e4);
      load.moment[k] = between(random, -1e4, 1e4);
    }
  }
  for (LineLoad& line : loads.lines) {
    for (std::size_t k = 0; k < 3; ++k) {
      for (double& c : line.force[k].c) c = between(random, -1e3, 1e3);
      for (double& c : line.couple[k].c) c = between(random, -1e3, 1e3);
    }
  }
  return loads;
}

}  // namespace

TEST_CASE("given cut forces are met at their stations and linear between them", "[recorded]") {
  const TaperedBeam beam = two_segments();
  std::mt19937_64 random(5);
  const std::vector<double> stations{0.0, 0.4, 1.3, 2.0, 3.4};
  for (int repeat = 0; repeat < 20; ++repeat) {
    std::vector<SixForces> values(stations.size());
    for (SixForces& at : values) {
      for (double& value : at) value = between(random, -1e5, 1e5);
    }
    const BeamLoads loads = recorded::loads_of_cuts(beam, stations, values);
    const Imbalance open = imbalance_of(loads);
    CHECK(open.force.norm() < 1e-9 * 1e5);
    CHECK(open.moment.norm() < 1e-9 * 1e5);
    const CutForceDiagram diagram = cut_forces_of(loads);
    for (std::size_t j = 0; j + 1 < stations.size(); ++j) {
      for (const double part : {1e-6, 0.3, 0.5, 1.0 - 1e-6}) {
        const double s = stations[j] + part * (stations[j + 1] - stations[j]);
        const SixForces found = six_of(diagram.at({si<Length>(s), Side::both}));
        for (std::size_t k = 0; k < found.size(); ++k) {
          const double expected = values[j][k] + part * (values[j + 1][k] - values[j][k]);
          CHECK(found[k] == Approx(expected).margin(1e-8 * 1e5));
        }
      }
    }
  }
}

TEST_CASE("what balances loads leaves nothing over, wherever it acts", "[recorded]") {
  const TaperedBeam beam = two_segments();
  std::mt19937_64 random(6);
  for (const double s : {0.0, 0.9, 1.3, 3.4}) {
    BeamLoads loads = random_loads(random, beam);
    loads.points.push_back(recorded::balance_at(si<Length>(s), loads));
    const Imbalance open = imbalance_of(loads);
    CHECK(open.force.norm() < 1e-10 * 1e5);
    CHECK(open.moment.norm() < 1e-10 * 1e5);
  }
}

TEST_CASE("a recorded history has the cut forces of its loads at every time", "[recorded]") {
  const TaperedBeam beam = two_segments();
  std::mt19937_64 random(7);
  recorded::ChannelLoads loads;
  loads.constant = random_loads(random, beam);
  auto channels = std::make_shared<recorded::Channels>();
  channels->times = {0.0, 0.1, 0.35, 0.5, 1.0};
  for (int k = 0; k < 3; ++k) {
    loads.units.push_back(random_loads(random, beam));
    std::vector<double>& of = channels->values.emplace_back();
    for (std::size_t i = 0; i < channels->times.size(); ++i)
      of.push_back(between(random, -2.0, 2.0));
  }
  loads.channels = channels;
  const LoadHistory history(loads);
  REQUIRE(history.instants() == 5);
  const Station station{si<Length>(2.2), Side::before};
  const StationHistory at(history, station);
  const auto close = [](const SixForces& a, const SixForces& b) {
    for (std::size_t k = 0; k < a.size(); ++k) CHECK(a[k] == Approx(b[k]).margin(1e-6));
  };
  for (std::size_t i = 0; i < history.instants(); ++i) {
    const Time time = history.time_of(i);
    const SixForces whole = six_of(cut_forces_of(history.loads_at(time)).at(station));
    close(six_of(history.diagram(i).at(station)), whole);
    close(six_of(at.samples()[i]), whole);
    close(six_of(at.at(time)), whole);
  }
  for (const double time : {0.05, 0.2, 0.77}) {
    const SixForces whole = six_of(cut_forces_of(history.loads_at(si<Time>(time))).at(station));
    close(six_of(history.diagram_at(si<Time>(time)).at(station)), whole);
    close(six_of(at.at(si<Time>(time))), whole);
  }
  // A stress is largest at an instant, wherever it is looked for.
  const auto stress = [](const CutForces& cut) { return cut.N.value() * 3.0 + cut.M_y.value(); };
  double largest = -1e300;
  for (const CutForces& cut : at.samples()) largest = std::max(largest, stress(cut));
  CHECK(at.largest(stress).value == largest);
  for (const TurningPoint& turn : at.turning_points(stress)) {
    const bool is_instant = std::find(channels->times.begin(), channels->times.end(),
                                      turn.time.value()) != channels->times.end();
    CHECK(is_instant);
  }
}

TEST_CASE("inertia from channels is that of the motion, in any direction", "[recorded]") {
  TaperedBeam beam = two_segments();
  beam.rotary_inertia = true;
  std::mt19937_64 random(8);
  recorded::MotionChannels motion;
  recorded::Channels channels{{0.0, 1.0, 2.0}, {}};
  for (auto* series : {&motion.acceleration, &motion.omega, &motion.alpha}) {
    for (std::vector<double>& of : *series) {
      for (int i = 0; i < 3; ++i) of.push_back(between(random, -5.0, 5.0));
    }
  }
  recorded::ChannelLoads loads;
  loads.constant = {{}, unloaded_lines(beam)};
  recorded::add_inertia(beam, motion, channels, loads);
  const auto three = [](const std::array<std::vector<double>, 3>& of, std::size_t i) {
    return Eigen::Vector3d(of[0][i], of[1][i], of[2][i]);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    BeamLoads sum = loads.constant;
    for (std::size_t k = 0; k < loads.units.size(); ++k)
      add(sum, channels.values[k][i], loads.units[k]);
    const std::vector<LineLoad> whole = weight_and_inertia(
        beam, mass_distribution_of(beam), Eigen::Vector3d::Zero(),
        {three(motion.acceleration, i), three(motion.omega, i), three(motion.alpha, i)});
    for (std::size_t j = 0; j < whole.size(); ++j) {
      for (const double x : {0.0, 0.7, 1.2}) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          CHECK(sum.lines[j].force[axis](x) == Approx(whole[j].force[axis](x)).margin(1e-9));
          CHECK(sum.lines[j].couple[axis](x) == Approx(whole[j].couple[axis](x)).margin(1e-9));
        }
      }
    }
  }
}

TEST_CASE("a path of the second degree gives its acceleration exactly", "[recorded]") {
  const std::vector<double> times{0.0, 0.3, 0.4, 1.0, 1.7};
  std::vector<double> x, z, angle;
  for (const double t : times) {
    x.push_back(1.0 + 2.0 * t - 3.0 * t * t);
    z.push_back(0.5 * t * t);
    angle.push_back(0.2 + 0.7 * t);
  }
  const recorded::MotionChannels motion = recorded::motion_of_path(times, x, z, angle, 10.0);
  for (std::size_t i = 0; i < times.size(); ++i) {
    // In the world: (-6, 1 + 10), turned back by the angle.
    const double c = std::cos(angle[i]), s = std::sin(angle[i]);
    CHECK(motion.acceleration[0][i] == Approx(-6.0 * c + 11.0 * s));
    CHECK(motion.acceleration[2][i] == Approx(6.0 * s + 11.0 * c));
    CHECK(motion.omega[1][i] == Approx(-0.7));
    CHECK(motion.alpha[1][i] == Approx(0.0).margin(1e-12));
  }
}

}  // namespace channel_loads_test
