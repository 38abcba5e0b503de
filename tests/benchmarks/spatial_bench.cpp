// Times of bodies in space: positions, velocities, accelerations and joint forces of one instant.
// Items are bodies; read the medians of --benchmark_repetitions=9.

#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "boxbeam/mechanism/spatial/chain.hpp"
#include "support/random_tree.hpp"

namespace {

using namespace boxbeam;
using namespace boxbeam::spatial;

enum class Drivers { harmonic, polynomial };
enum class Work { motion, forces };
/// Where the bodies' origins lie: at their joints, as usual, or anywhere.
enum class Origins { at_joints, anywhere };

/// Bodies in a row, each with mass and a whole inertia tensor, on revolute joints about arbitrary
/// axes.
Mechanism row_of(std::int64_t bodies, Drivers drivers, Origins origins) {
  test::Chance chance(7);
  Mechanism row;
  row.gravity = {0.0, 0.0, -9.81};
  for (int i = 0; i < bodies; ++i) {
    row.bodies.push_back({"", 3.0, chance.vector(0.3), chance.inertia(3.0, 0.4), {}});
    Joint joint{"", JointKind::revolute, i - 1, chance.vector(), {}, chance.rotation()};
    if (origins == Origins::anywhere) joint.point = chance.vector(0.2);
    joint.axis = chance.direction();
    if (drivers == Drivers::harmonic) {
      joint.driver = HarmonicDriver{chance.any(), chance.any(), 2.0, chance.any(), {}};
    } else {
      joint.driver = PolynomialDriver{{chance.any(), chance.any(), chance.any()}};
    }
    row.joints.push_back(joint);
  }
  return row;
}

void chain(benchmark::State& bench, Drivers drivers, Work work,
           Origins origins = Origins::at_joints) {
  const Mechanism mechanism = row_of(bench.range(0), drivers, origins);
  const Chain chain(mechanism);
  State state;
  std::vector<Wrench> wrenches;
  std::int64_t instant = 0;
  for (auto _ : bench) {
    instant = (instant + 1) % 960;
    chain.at(0.01 * static_cast<double>(instant), state);
    if (work == Work::forces) chain.joint_wrenches(state, wrenches);
    benchmark::DoNotOptimize(state.bodies.data());
    benchmark::DoNotOptimize(wrenches.data());
    benchmark::ClobberMemory();
  }
  bench.SetItemsProcessed(bench.iterations() * bench.range(0));
  bench.counters["per body"] =
      benchmark::Counter(static_cast<double>(bench.iterations() * bench.range(0)),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  bench.SetComplexityN(bench.range(0));
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(4)->Arg(40)->Arg(400)->Complexity(benchmark::oN);
}

}  // namespace

BENCHMARK_CAPTURE(chain, harmonic, Drivers::harmonic, Work::forces)->Name("chain")->Apply(sizes);
BENCHMARK_CAPTURE(chain, polynomial, Drivers::polynomial, Work::forces)
    ->Name("chain/polynomial")
    ->Apply(sizes);
BENCHMARK_CAPTURE(chain, motion, Drivers::polynomial, Work::motion)
    ->Name("chain/motion")
    ->Apply(sizes);
BENCHMARK_CAPTURE(chain, shifted, Drivers::polynomial, Work::forces, Origins::anywhere)
    ->Name("chain/shifted")
    ->Apply(sizes);
