// Times of one elastic link: static and harmonic response together, the link divided beforehand.
// Items are rigid elements; read the medians of --benchmark_repetitions=9.

#include <benchmark/benchmark.h>

#include <cstdint>

#include "boxbeam/mechanism/flexible/response.hpp"
#include "support/elastic_beams.hpp"

namespace {

using namespace boxbeam::flexible;

/// A full link of steel, clamped at its start, under its weight and a harmonic force at its end.
Mechanism link_of(std::int64_t elements, double retardation) {
  Mechanism mechanism =
      test::cantilever_of(test::steel_bar(4.0, 0.3, 0.2), static_cast<int>(elements - 1),
                          Element::corrected, LinkKind::full);
  mechanism.links[0].retardation = retardation;
  mechanism.gravity = {0.0, -9.81};
  mechanism.loads = {test::load_at(4.0, {0.0, -12000.0, 0.0}, {4000.0, 1500.0, 500.0})};
  mechanism.frequency = 25.0;
  return mechanism;
}

void count(benchmark::State& bench, std::int64_t elements) {
  bench.SetItemsProcessed(bench.iterations() * elements);
  bench.counters["per element"] =
      benchmark::Counter(static_cast<double>(bench.iterations() * elements),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void response(benchmark::State& bench, std::int64_t elements, double retardation) {
  const Mechanism mechanism = link_of(elements, retardation);
  const Structure structure = structure_of(mechanism);
  for (auto _ : bench) {
    const Response response = response_of(structure);
    benchmark::DoNotOptimize(response.harmonic.joints.data());
    benchmark::ClobberMemory();
  }
  count(bench, elements);
}

/// Dividing it.
void division(benchmark::State& bench, std::int64_t elements) {
  const Mechanism mechanism = link_of(elements, 0.0);
  for (auto _ : bench) {
    const Structure structure = structure_of(mechanism);
    benchmark::DoNotOptimize(structure.links.data());
    benchmark::ClobberMemory();
  }
  count(bench, elements);
}

}  // namespace

BENCHMARK_CAPTURE(response, n, 1000, 0.0)->Name("rfem/link/1000")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(response, n, 10000, 0.0)->Name("rfem/link/10000")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(response, n, 100000, 0.0)
    ->Name("rfem/link/100000")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(response, damped, 10000, 1e-5)
    ->Name("rfem/link/10000/damped")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(division, n, 10000)
    ->Name("rfem/link/10000/division")
    ->Unit(benchmark::kMillisecond);
