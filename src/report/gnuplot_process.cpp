#include "gnuplot_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <deque>
#include <fstream>
#include <iterator>
#include <string_view>
#include <thread>

#include "boxbeam/core/error.hpp"

namespace boxbeam {
namespace {

namespace fs = std::filesystem;

struct Process {
  pid_t pid = -1;
  Drawing drawing;
};

/// The environment of the program, but with names in UTF-8 wherever it runs, and one time zone.
std::vector<std::string> environment() {
  std::vector<std::string> variables{"TZ=UTC0", "LC_ALL=C.UTF-8"};
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    const bool replaced = text.starts_with("TZ=") || text.starts_with("LC_ALL=");
    if (!replaced) variables.emplace_back(text);
  }
  return variables;
}

/// Takes the time of drawing out of a PDF: the same input gives the same bytes. Cairo before 1.17
/// knows no other way.
void make_timeless(const fs::path& pdf) {
  std::fstream file(pdf, std::ios::in | std::ios::out | std::ios::binary);
  std::string content(std::istreambuf_iterator<char>(file), {});
  constexpr std::string_view entry = "/CreationDate (D:";
  const std::size_t at = content.rfind(entry);
  if (at == std::string::npos) return;
  file.clear();
  file.seekp(static_cast<std::streamoff>(at + entry.size()));
  file << "19700101000000";
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Starts gnuplot on a script in a folder; its messages go to a file of the drawing's name and
/// ".log" there.
Process start_gnuplot(const fs::path& folder, const Drawing& drawing) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const std::string log = (folder / (drawing.file() + ".log")).string();
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::vector<std::string> arguments{"gnuplot", "-d"};
  if (drawing.format == Drawing::pdf) {
    arguments.emplace_back("-e");
    arguments.emplace_back("pdf = 1");
  }
  arguments.push_back(drawing.name + ".gp");
  std::vector<std::string> variables = environment();
  Process process{-1, drawing};
  const int error = posix_spawnp(&process.pid, "gnuplot", &actions, nullptr,
                                 pointers_to(arguments).data(), pointers_to(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) {
    throw OutputError(
        "no plots: gnuplot is not installed (apt install gnuplot-nox); everything else is written");
  }
  if (error != 0)
    throw OutputError(fmt::format("no plots: gnuplot cannot be started: {}", std::strerror(error)));
  return process;
}

/// Whether a file ends with a text, empty lines apart: where the disk is full gnuplot leaves a part
/// and says nothing.
bool ends_with(const fs::path& path, std::string_view ending) {
  constexpr std::streamoff most = 64;
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) return false;
  file.seekg(-std::min<std::streamoff>(most, file.tellg()), std::ios::end);
  std::string tail(std::istreambuf_iterator<char>(file), {});
  while (!tail.empty() && tail.back() == '\n') tail.pop_back();
  return tail.ends_with(ending);
}

/// Waits for a gnuplot; what it said where it failed, "" where it did not.
std::string trouble_of(const fs::path& folder, const Process& process) {
  int status = 0;
  while (::waitpid(process.pid, &status, 0) < 0 && errno == EINTR) {
  }
  std::error_code error;
  const fs::path file = folder / process.drawing.file();
  const bool pdf = process.drawing.format == Drawing::pdf;
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && fs::exists(file, error)) {
    if (!ends_with(file, pdf ? "%%EOF" : "</svg>")) return "only a part could be written";
    if (pdf) make_timeless(file);
    return "";
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    return "gnuplot is not installed (apt install gnuplot-nox)";
  std::ifstream log(folder / (process.drawing.file() + ".log"));
  std::string words = "it ended without a message";
  for (std::string line; std::getline(log, line);) {
    if (line.find_first_not_of(" ^") == std::string::npos) continue;
    words = line;
    // What it only warns of did not stop it.
    if (line.find("warning:") == std::string::npos) break;
  }
  return words;
}

}  // namespace

void run_gnuplot(const fs::path& folder, const std::vector<Drawing>& drawings) {
  const std::size_t at_once = std::max(2U, std::thread::hardware_concurrency());
  for (const Drawing& drawing : drawings) {
    const fs::path script = folder / (drawing.name + ".gp");
    if (!ends_with(script, script_end))
      throw OutputError(fmt::format("no plots: {} could be written only in part", script.string()));
  }
  std::deque<Process> running;
  std::string troubles;
  const auto wait_for_first = [&] {
    const std::string trouble = trouble_of(folder, running.front());
    if (!trouble.empty())
      troubles += fmt::format("\n  {}: {}", running.front().drawing.file(), trouble);
    running.pop_front();
  };
  for (const Drawing& drawing : drawings) {
    if (running.size() == at_once) wait_for_first();
    running.push_back(start_gnuplot(folder, drawing));
  }
  while (!running.empty()) wait_for_first();
  if (!troubles.empty()) throw OutputError("gnuplot failed, no plots are written:" + troubles);
}

}  // namespace boxbeam
