// Times of one instant of the sledge mechanism and of the whole verification. Run with
// --benchmark_repetitions=9 and read the medians.

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/kept_runs.hpp"
#include "chain.hpp"

namespace {

using namespace boxbeam;

std::string case_path(const char* name) {
  return std::string(BOXBEAM_SOURCE_DIR) + "/sections/sledge-rig/" + name;
}

/// Positions, velocities, accelerations and reactions of one instant, each from the one before at
/// 96 instants per period, into a state whose memory is used again.
void instants_of(benchmark::State& bench, const planar::Mechanism& mechanism,
                 planar::Elimination elimination, double period) {
  constexpr int count = 96;
  planar::InstantSolver solver(mechanism, elimination);
  planar::State state = solver.solve_from_sketch(0.0, planar::sketch_of(mechanism));
  planar::State next;
  std::int64_t i = 0;
  for (auto _ : bench) {
    solver.solve_near(period * static_cast<double>(++i) / count, state, next);
    std::swap(state, next);
    if (i == 1000 * count) {  // time loses digits where it grows for ever
      state.time = 0.0;
      i = 0;
    }
  }
  bench.counters["unknowns"] = static_cast<double>(mechanism.coordinates());
  bench.counters["entries"] = static_cast<double>(solver.equations().pattern().entries());
  bench.counters["flops/factor"] = static_cast<double>(solver.elimination().factor_operations());
  bench.counters["flops/solve"] = static_cast<double>(solver.elimination().solve_operations());
  bench.counters["reorderings"] = solver.reorderings();
}

void instant(benchmark::State& bench, const char* name, planar::Elimination elimination) {
  const Project project = read_project(case_path(name));
  instants_of(bench, planar_of(project), elimination,
              planar::time_span_of(planar_of(project)).length);
}

/// The same for chains of four-bars, sparse: time per instant against the number of four-bars.
void chain(benchmark::State& bench) {
  const planar::Mechanism mechanism = bench::chain_of_four_bars(static_cast<int>(bench.range(0)));
  instants_of(bench, mechanism, planar::Elimination::sparse,
              planar::time_span_of(mechanism).length);
  bench.SetComplexityN(bench.range(0));
}

/// Verifying a case that is read once, in one process that is already warm.
void verify_read_case(benchmark::State& bench) {
  const Project project = read_project(case_path("rig.toml"));
  for (auto _ : bench) benchmark::DoNotOptimize(verify(project));
}

/// The same of designs that differ in what resists alone, whose runs are kept.
void verify_kept_runs(benchmark::State& bench) {
  const Project project = read_project(case_path("rig.toml"));
  KeptRuns kept;
  for (auto _ : bench) {
    std::vector<Project> beams{project};
    benchmark::DoNotOptimize(kept.verify(std::move(beams)));
  }
}

/// Reading the case and verifying it, likewise.
void verify_in_process(benchmark::State& bench) {
  for (auto _ : bench) {
    const Project project = read_project(case_path("rig.toml"));
    benchmark::DoNotOptimize(verify(project));
  }
}

/// The program as a user runs it, text, HTML and JSON written, without plots and PDF: start of the
/// process to its end.
void verify_as_process(benchmark::State& bench) {
  namespace fs = std::filesystem;
  std::string pattern = (fs::temp_directory_path() / "boxbeam-bench-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  std::string words[] = {BOXBEAM_PROGRAM, "verify", case_path("rig.toml"), "--no-plots", "--no-pdf",
                         "--out",         pattern};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(),
                       words[4].data(), words[5].data(), words[6].data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  for (auto _ : bench) {
    pid_t pid = -1;
    if (::posix_spawn(&pid, BOXBEAM_PROGRAM, &actions, nullptr, arguments, environ) != 0) {
      throw std::runtime_error("the program cannot be started");
    }
    int status = 0;
    ::waitpid(pid, &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) > 1)
      throw std::runtime_error("the program failed");
  }
  posix_spawn_file_actions_destroy(&actions);
  fs::remove_all(pattern);
}

}  // namespace

BENCHMARK_CAPTURE(instant, rig_sparse, "rig.toml", boxbeam::planar::Elimination::sparse)
    ->Name("instant/sledge/sparse");
BENCHMARK_CAPTURE(instant, rig_dense, "rig.toml", boxbeam::planar::Elimination::dense)
    ->Name("instant/sledge/dense");
BENCHMARK_CAPTURE(instant, published_sparse, "published.toml", boxbeam::planar::Elimination::sparse)
    ->Name("instant/sledge-published/sparse");
BENCHMARK_CAPTURE(instant, published_dense, "published.toml", boxbeam::planar::Elimination::dense)
    ->Name("instant/sledge-published/dense");
BENCHMARK(chain)
    ->Name("instant/four-bars")
    ->Arg(1)
    ->Arg(10)
    ->Arg(100)
    ->Arg(1000)
    ->Complexity(benchmark::oN);
BENCHMARK(verify_in_process)->Name("verify/sledge")->Unit(benchmark::kMillisecond);
BENCHMARK(verify_read_case)->Name("verify/sledge/read")->Unit(benchmark::kMillisecond);
BENCHMARK(verify_kept_runs)->Name("verify/sledge/kept-runs")->Unit(benchmark::kMillisecond);
BENCHMARK(verify_as_process)
    ->Name("verify/sledge/process")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

BENCHMARK_MAIN();
