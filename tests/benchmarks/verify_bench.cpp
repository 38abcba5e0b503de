// Times of one instant of the sledge mechanism and of the whole verification. Run with
// --benchmark_repetitions=9 and read the medians.

#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/verify.hpp"

namespace {

using namespace boxbeam;

std::string case_path(const char* name) {
  return std::string(BOXBEAM_SOURCE_DIR) + "/sections/sledge-rig/" + name;
}

/// Positions, velocities, accelerations and reactions of one instant, each from the one before at
/// 96 instants per period; dense Jacobian.
void instant(benchmark::State& bench, const char* name) {
  const Project project = read_project(case_path(name));
  planar::InstantSolver solver(project.mechanism);
  const planar::Motion motion = planar::solve_motion(project.mechanism, 96);
  std::size_t i = 0;
  for (auto _ : bench) {
    const std::size_t next = (i + 1) % motion.states.size();
    planar::State from = motion.states[i];
    if (next == 0) from.time -= motion.period;
    benchmark::DoNotOptimize(solver.solve_near(motion.states[next].time, from));
    i = next;
  }
  bench.counters["unknowns"] = static_cast<double>(project.mechanism.coordinates());
}

/// Reading the case and verifying it, in one process that is already warm.
void verify_in_process(benchmark::State& bench) {
  for (auto _ : bench) {
    const Project project = read_project(case_path("rig.toml"));
    benchmark::DoNotOptimize(verify(project));
  }
}

/// The program as a user runs it, text and JSON written, without plots: start of the process to
/// its end.
void verify_as_process(benchmark::State& bench) {
  namespace fs = std::filesystem;
  std::string pattern = (fs::temp_directory_path() / "boxbeam-bench-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  std::string words[] = {BOXBEAM_PROGRAM, "verify", case_path("rig.toml"),
                         "--no-plots",    "--out",  pattern};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(),
                       words[4].data(), words[5].data(), nullptr};
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

BENCHMARK_CAPTURE(instant, rig, "rig.toml")->Name("instant/sledge/dense");
BENCHMARK_CAPTURE(instant, published, "published.toml")->Name("instant/sledge-published/dense");
BENCHMARK(verify_in_process)->Name("verify/sledge")->Unit(benchmark::kMillisecond);
BENCHMARK(verify_as_process)
    ->Name("verify/sledge/process")
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

BENCHMARK_MAIN();
