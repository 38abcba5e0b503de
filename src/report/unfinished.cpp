#include "unfinished.hpp"

#include <pthread.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <system_error>
#include <thread>
#include <vector>

namespace boxbeam::report {
namespace {

struct Register {
  std::recursive_mutex mutex;
  std::vector<std::filesystem::path> paths;
  std::vector<pid_t> programs;
};

/// Never destroyed: a signal may come in the last moment.
Register& unfinished() {
  static auto* const all = new Register;
  return *all;
}

/// Ends what is at work, then removes what it has written into.
void clear_up() {
  const Register& all = unfinished();
  for (const pid_t id : all.programs) ::kill(id, SIGKILL);
  for (const pid_t id : all.programs) {
    // Its end is left to who waits for it; here it only must not write any more.
    siginfo_t ignored{};
    ::waitid(P_PID, static_cast<id_t>(id), &ignored, WEXITED | WNOWAIT);
  }
  for (const std::filesystem::path& path : all.paths) {
    std::error_code error;
    std::filesystem::remove_all(path, error);
  }
}

/// The signals that end a program and that nobody asked to ignore (nohup ignores SIGHUP).
sigset_t ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler != SIG_IGN) {
      sigaddset(&signals, signal);
    }
  }
  return signals;
}

}  // namespace

void clear_up_before_the_end() {
  // Signals are taken by a thread of their own, which may do what no handler may.
  static const sigset_t signals = ending_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  unfinished();
  std::thread([] {
    int signal = 0;
    if (sigwait(&signals, &signal) != 0) return;
    const Finishing whole;
    clear_up();
    std::signal(signal, SIG_DFL);
    sigset_t of;
    sigemptyset(&of);
    sigaddset(&of, signal);
    pthread_sigmask(SIG_UNBLOCK, &of, nullptr);
    ::raise(signal);
  }).detach();
}

UnfinishedPath::UnfinishedPath(std::filesystem::path path) : path_(std::move(path)) {
  const Finishing whole;
  // Another working folder, or none, is another path.
  std::error_code error;
  const std::filesystem::path absolute = std::filesystem::absolute(path_, error);
  unfinished().paths.push_back(error ? path_ : absolute);
}

UnfinishedPath::~UnfinishedPath() {
  const Finishing whole;
  std::error_code error;
  std::filesystem::remove_all(path_, error);
  const std::filesystem::path absolute = std::filesystem::absolute(path_, error);
  std::vector<std::filesystem::path>& paths = unfinished().paths;
  const auto found = std::find(paths.begin(), paths.end(), error ? path_ : absolute);
  if (found != paths.end()) paths.erase(found);
}

void note_program(pid_t id) {
  const Finishing whole;
  unfinished().programs.push_back(id);
}

void forget_program(pid_t id) {
  const Finishing whole;
  std::erase(unfinished().programs, id);
}

Finishing::Finishing() : lock_(unfinished().mutex) {}

}  // namespace boxbeam::report
