#include "gnuplot_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "boxbeam/core/error.hpp"

namespace boxbeam {
namespace {

namespace fs = std::filesystem;

struct Process {
  pid_t pid = -1;
  std::string name;
};

/// Starts gnuplot on a script in a folder; its messages go to NAME.log there.
Process start_gnuplot(const fs::path& folder, const std::string& name) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const std::string log = (folder / (name + ".log")).string();
  const std::string script = name + ".gp";
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::string program = "gnuplot";
  std::string option = "-d";
  std::string argument = script;
  char* arguments[] = {program.data(), option.data(), argument.data(), nullptr};
  Process process{-1, name};
  const int error = posix_spawnp(&process.pid, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) {
    throw OutputError(
        "no plots: gnuplot is not installed (apt install gnuplot-nox); everything else is written");
  }
  if (error != 0)
    throw OutputError(fmt::format("no plots: gnuplot cannot be started: {}", std::strerror(error)));
  return process;
}

/// Waits for a gnuplot; what it said where it failed, "" where it did not.
std::string trouble_of(const fs::path& folder, const Process& process) {
  int status = 0;
  while (::waitpid(process.pid, &status, 0) < 0 && errno == EINTR) {
  }
  std::error_code error;
  const fs::path drawing = folder / (process.name + ".svg");
  const bool drawn = fs::exists(drawing, error) && fs::file_size(drawing, error) > 0;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && drawn) return "";
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    return "gnuplot is not installed (apt install gnuplot-nox)";
  std::ifstream log(folder / (process.name + ".log"));
  for (std::string line; std::getline(log, line);) {
    if (line.find_first_not_of(" ^") != std::string::npos) return line;
  }
  return "it ended without a message";
}

}  // namespace

ScratchFolder::ScratchFolder(const fs::path& beside) {
  std::string pattern = (beside / ".plots-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw OutputError(
        fmt::format("no plots: {} cannot be written: {}", beside.string(), std::strerror(errno)));
  }
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void run_gnuplot(const fs::path& folder, const std::vector<std::string>& names) {
  std::vector<Process> processes;
  processes.reserve(names.size());
  for (const std::string& name : names) processes.push_back(start_gnuplot(folder, name));
  std::string troubles;
  for (const Process& process : processes) {
    const std::string trouble = trouble_of(folder, process);
    if (!trouble.empty()) troubles += fmt::format("\n  {}: {}", process.name, trouble);
  }
  if (!troubles.empty()) throw OutputError("gnuplot failed, no plots are written:" + troubles);
}

}  // namespace boxbeam
