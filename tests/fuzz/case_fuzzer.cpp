// Changes small and shipped cases at random, verifies them in process and says where a promise is
// broken.
//
//     case_fuzzer [--time SECONDS | --count N] [--seed S] [--jobs J] [--out DIR] [--origins]
//                 FOLDER...
//     case_fuzzer --one NUMBER FOLDER...      the case of a number, and how it ends
//
// FOLDER: cases to begin from; --origins says what became of those of each, and their time. Cases
// run in processes of their own, so that a crash ends one and not the run. Ends with 1 where
// something was found; each finding stands in DIR as a case file.
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "fuzz/case_mutator.hpp"
#include "fuzz/case_promises.hpp"

namespace {

using Clock = std::chrono::steady_clock;

constexpr int seconds_of_a_case = 60;       // of processor time: it hangs
constexpr std::uint64_t report_every = 16;  // cases
constexpr std::size_t kinds_of_answers = 1 << 16;
constexpr rlim_t memory = rlim_t{4} << 30;

struct Options {
  double time = 60.0;
  std::uint64_t count = ~std::uint64_t{0};
  std::uint64_t seed = 1;
  unsigned jobs = 1;
  std::string out = "findings";
  bool one = false;
  bool origins = false;
  std::vector<std::string> folders;
};

/// What became of the cases that were begun from an origin.
struct OfOrigin {
  std::atomic<std::uint64_t> executions{0};
  std::atomic<std::uint64_t> verified{0};      ///< neither refused nor impossible
  std::atomic<std::uint64_t> microseconds{0};  ///< of processor time
};
constexpr std::size_t most_origins = 256;

/// What the processes tell each other.
struct Shared {
  std::atomic<std::uint64_t> next{0};
  std::array<std::atomic<std::uint64_t>, 6> endings{};
  std::array<std::atomic<std::uint8_t>, kinds_of_answers> answers{};
  std::atomic<std::uint64_t> slowest_number{0};
  std::atomic<double> slowest{0.0};
  std::array<std::atomic<std::uint64_t>, 64> at_work{};  ///< case number + 1, by job
  std::array<OfOrigin, most_origins> origins{};
};

/// The words without numbers and names: what kind of answer it is.
std::size_t kind_of(const std::string& words) {
  std::size_t hash = 1469598103934665603U;
  bool quoted = false;
  for (const char c : words) {
    if (c == '"') quoted = !quoted;
    if (quoted || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '/') continue;
    if (c == '\n') break;
    hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
  }
  return hash % kinds_of_answers;
}

double processor_time() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

void keep(const Options& options, const fuzz::Mutant& mutant, std::uint64_t number,
          const std::string& what) {
  std::filesystem::create_directories(options.out);
  const std::string name = fmt::format("{}/finding-{}.toml", options.out, number);
  std::string comment = what.substr(0, 500);
  for (std::size_t at = comment.find('\n'); at != std::string::npos;
       at = comment.find('\n', at + 3)) {
    comment.replace(at, 1, "\n# ");
  }
  std::ofstream(name) << "# " << comment << "\n# begun from " << mutant.path << "\n" << mutant.text;
  fmt::print("finding: case {}, {}\n", number, what.substr(0, 300));
  std::fflush(stdout);
}

/// Takes numbers and runs their cases until there are no more, in a process of its own.
void work(const Options& options, const std::vector<fuzz::Origin>& origins, Shared& shared,
          unsigned job, Clock::time_point end) {
  const rlimit limit{memory, memory};
  ::setrlimit(RLIMIT_AS, &limit);
  while (Clock::now() < end) {
    const std::uint64_t index = shared.next.fetch_add(1);
    if (index >= options.count) return;
    const std::uint64_t number = options.seed + index;
    shared.at_work[job] = number + 1;
    const double begun = processor_time();
    const fuzz::Mutant mutant = fuzz::mutant_of(origins, number);
    itimerval timer{};
    timer.it_value.tv_sec = seconds_of_a_case;
    ::setitimer(ITIMER_VIRTUAL, &timer, nullptr);
    const fuzz::Outcome outcome = fuzz::outcome_of(mutant, number % report_every == 0);
    const double took = processor_time() - begun;
    if (took > shared.slowest) {
      shared.slowest = took;
      shared.slowest_number = number;
    }
    OfOrigin& of = shared.origins[mutant.origin];
    ++of.executions;
    of.microseconds += static_cast<std::uint64_t>(1e6 * took);
    if (outcome.ending >= fuzz::Ending::pass) ++of.verified;
    ++shared.endings[static_cast<std::size_t>(outcome.ending)];
    shared.answers[kind_of(outcome.words)] = 1;
    if (outcome.ending == fuzz::Ending::broken) keep(options, mutant, number, outcome.words);
  }
}

/// Why a process ended, "" where it came to its end.
std::string end_of(int status) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  if (WIFEXITED(status)) return fmt::format("exit {}", WEXITSTATUS(status));
  const int signal = WTERMSIG(status);
  if (signal == SIGVTALRM) return fmt::format("more than {} s", seconds_of_a_case);
  return fmt::format("crash: {}", ::strsignal(signal));
}

int run(const Options& options) {
  const std::vector<fuzz::Origin> origins = fuzz::origins_in(options.folders);
  if (origins.empty() || origins.size() > most_origins) {
    fmt::print(stderr, "{} cases to begin from, 1 to {} can be\n", origins.size(), most_origins);
    return 2;
  }
  void* const memory_of_all =
      ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory_of_all == MAP_FAILED) return 2;
  Shared& shared = *new (memory_of_all) Shared;
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(options.time));
  std::uint64_t killed = 0;
  std::vector<pid_t> workers(options.jobs, -1);
  const auto start = [&](unsigned job) {
    const pid_t id = ::fork();
    if (id == 0) {
      work(options, origins, shared, job, end);
      std::fflush(stdout);
      ::_exit(0);
    }
    workers[job] = id;
  };
  for (unsigned job = 0; job < options.jobs; ++job) start(job);
  for (std::size_t running = options.jobs; running > 0;) {
    int status = 0;
    const pid_t id = ::wait(&status);
    if (id < 0) break;
    const auto job =
        static_cast<unsigned>(std::find(workers.begin(), workers.end(), id) - workers.begin());
    const std::string why = end_of(status);
    if (why.empty()) {
      --running;
      continue;
    }
    ++killed;
    const std::uint64_t number = shared.at_work[job] - 1;
    keep(options, fuzz::mutant_of(origins, number), number, why);
    if (Clock::now() < end)
      start(job);
    else
      --running;
  }
  for (std::size_t i = 0; options.origins && i < origins.size(); ++i) {
    const OfOrigin& of = shared.origins[i];
    fmt::print("{}: {} executions, {} verified, {:.1f} s\n", origins[i].path, of.executions.load(),
               of.verified.load(), 1e-6 * static_cast<double>(of.microseconds));
  }
  const auto ended = [&](fuzz::Ending ending) {
    return shared.endings[static_cast<std::size_t>(ending)].load();
  };
  std::uint64_t executions = killed;
  for (const auto& count : shared.endings) executions += count;
  const std::uint64_t findings = killed + ended(fuzz::Ending::broken);
  fmt::print(
      "case fuzzer: {} executions from seed {}: {} refused, {} impossible, {} pass, {} fail, {} "
      "not "
      "applicable; {} kinds of answers; slowest {:.1f} s (case {}); {} findings\n",
      executions, options.seed, ended(fuzz::Ending::refused), ended(fuzz::Ending::impossible),
      ended(fuzz::Ending::pass), ended(fuzz::Ending::fail), ended(fuzz::Ending::not_applicable),
      std::count_if(shared.answers.begin(), shared.answers.end(),
                    [](const auto& answer) { return answer != 0; }),
      shared.slowest.load(), shared.slowest_number.load(), findings);
  return findings == 0 ? 0 : 1;
}

int run_one(const Options& options) {
  const fuzz::Mutant mutant = fuzz::mutant_of(fuzz::origins_in(options.folders), options.seed);
  fmt::print("# begun from {}\n{}", mutant.path, mutant.text);
  std::fflush(stdout);
  const fuzz::Outcome outcome = fuzz::outcome_of(mutant, true);
  fmt::print("# ending {}, {}\n", static_cast<int>(outcome.ending), outcome.words);
  return outcome.ending == fuzz::Ending::broken ? 1 : 0;
}

template <class Number>
Number number_of(const std::string& text) {
  Number number{};
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const std::string value = i + 1 < argc ? argv[i + 1] : "";
    if (!word.starts_with("--")) {
      options.folders.push_back(word);
      continue;
    }
    if (word == "--origins") {
      options.origins = true;
      continue;
    }
    ++i;
    if (word == "--time") {
      options.time = number_of<double>(value);
    } else if (word == "--count") {
      options.count = number_of<std::uint64_t>(value);
      options.time = 1e9;
    } else if (word == "--seed") {
      options.seed = number_of<std::uint64_t>(value);
    } else if (word == "--jobs") {
      options.jobs = std::clamp(number_of<unsigned>(value), 1U, 64U);
    } else if (word == "--out") {
      options.out = value;
    } else if (word == "--one") {
      options.seed = number_of<std::uint64_t>(value);
      options.one = true;
    } else {
      fmt::print(stderr, "unknown: {}\n", word);
      return 2;
    }
  }
  return options.one ? run_one(options) : run(options);
}
