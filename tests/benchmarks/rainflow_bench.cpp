// Cycle counting: samples per second, of random samples (two of three are turning points), a random
// walk, and a sine with noise. "plain" is the counter of the tests, vectors and branches, as most
// programs have it.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <random>
#include <string>
#include <vector>

#include "boxbeam/fatigue/rainflow.hpp"
#include "boxbeam/project/stress_history.hpp"
#include "fatigue/plain_rainflow.hpp"

namespace {

using namespace boxbeam;

constexpr std::size_t sample_count = 4'000'000;

enum Signal { uniform, walk, noisy_sine };

const std::vector<double>& samples_of(Signal signal) {
  static std::vector<double> made[3];
  std::vector<double>& samples = made[signal];
  if (!samples.empty()) return samples;
  std::mt19937_64 random(1049);
  std::uniform_real_distribution<double> noise(-1e8, 1e8);
  double sum = 0.0;
  for (std::size_t i = 0; i < sample_count; ++i) {
    const double step = noise(random);
    sum += step;
    const double sine = 1e8 * std::sin(0.05 * static_cast<double>(i));
    samples.push_back(signal == uniform ? step : signal == walk ? sum : sine + 0.02 * step);
  }
  return samples;
}

void count_samples(benchmark::State& bench) {
  bench.SetItemsProcessed(bench.iterations() * static_cast<std::int64_t>(sample_count));
}

/// From memory to memory, all ranges stored.
void memory(benchmark::State& bench, Signal signal, const RainflowKernels& kernels) {
  const std::vector<double>& samples = samples_of(signal);
  std::vector<double> ranges(samples.size());
  for (auto _ : bench) {
    double* end = ranges.data();
    RainflowCounter counter(
        {Counting::four_point},
        [&](const CycleBatch& batch) {
          end = std::copy(batch.range.begin(), batch.range.end(), end);
        },
        kernels);
    counter.push(samples);
    counter.finish();
    benchmark::DoNotOptimize(*ranges.data());
    benchmark::ClobberMemory();
  }
  count_samples(bench);
}

/// In chunks, nothing stored, each checked before: as a file is counted.
void stream(benchmark::State& bench, Signal signal) {
  constexpr std::size_t chunk = 100'000;
  const std::span<const double> samples = samples_of(signal);
  for (auto _ : bench) {
    double largest = 0.0;
    RainflowCounter counter(
        {}, [&](const CycleBatch& batch) { largest = std::max(largest, batch.range.front()); });
    for (std::size_t at = 0; at < samples.size(); at += chunk) {
      const auto part = samples.subspan(at, std::min(chunk, samples.size() - at));
      if (find_uncountable(part)) bench.SkipWithError("not countable");
      counter.push(part);
    }
    counter.finish();
    benchmark::DoNotOptimize(largest);
  }
  count_samples(bench);
}

void turning_points(benchmark::State& bench, Signal signal, const RainflowKernels& kernels) {
  constexpr std::size_t block = RainflowCounter::block_size;
  const std::span<const double> samples = samples_of(signal);
  std::vector<double> turns(block + kernel_slack);
  for (auto _ : bench) {
    Course course;
    for (std::size_t at = 0; at < samples.size(); at += block) {
      const auto part = samples.subspan(at, std::min(block, samples.size() - at));
      benchmark::DoNotOptimize(kernels.write_turns(part, course, turns.data()));
      benchmark::ClobberMemory();
    }
  }
  count_samples(bench);
}

void plain_count(benchmark::State& bench, Signal signal) {
  const std::vector<double>& samples = samples_of(signal);
  for (auto _ : bench) benchmark::DoNotOptimize(plain::four_point(samples));
  count_samples(bench);
}

/// A table of a million rows of random stresses, read and counted.
void table(benchmark::State& bench) {
  constexpr int rows = 1'000'000;
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / "boxbeam-bench-history.csv";
  {
    std::ofstream file(path);
    file << "sigma [MPa]\n" << std::fixed << std::setprecision(3);
    const std::vector<double>& samples = samples_of(uniform);
    for (std::size_t i = 0; i < rows; ++i) file << 1e-6 * samples[i] << '\n';
  }
  for (auto _ : bench) {
    double largest = 0.0;
    RainflowCounter counter(
        {}, [&](const CycleBatch& batch) { largest = std::max(largest, batch.range.front()); });
    read_stress_history({path.string(), std::nullopt},
                        [&](const StressSamples& samples) { counter.push(samples.normal); });
    counter.finish();
    benchmark::DoNotOptimize(largest);
  }
  std::filesystem::remove(path);
  bench.SetItemsProcessed(bench.iterations() * rows);
}

const int registered = [] {
  constexpr const char* names[] = {"uniform", "walk", "sine"};
  const auto add = [](const std::string& name, auto run) {
    benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
  };
  for (const Signal signal : {uniform, walk, noisy_sine}) {
    const std::string of = std::string("/") + names[signal];
    for (const bool fast : {true, false}) {
      const RainflowKernels& kernels = fast ? fastest_kernels() : plain_kernels;
      const std::string by = fast ? "" : "/plain-kernels";
      add("rainflow/memory" + of + by,
          [=, &kernels](benchmark::State& bench) { memory(bench, signal, kernels); });
      add("rainflow/turning_points" + of + by,
          [=, &kernels](benchmark::State& bench) { turning_points(bench, signal, kernels); });
    }
    add("rainflow/stream" + of, [=](benchmark::State& bench) { stream(bench, signal); });
    add("rainflow/plain" + of, [=](benchmark::State& bench) { plain_count(bench, signal); });
  }
  add("rainflow/table", table);
  return 0;
}();

}  // namespace
