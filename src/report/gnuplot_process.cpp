#include "gnuplot_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>
#include <thread>

#include "boxbeam/core/error.hpp"
#include "process.hpp"

namespace boxbeam {
namespace {

namespace fs = std::filesystem;

constexpr const char* not_installed = "gnuplot is not installed (apt install gnuplot-nox)";

/// A gnuplot at work.
struct Run {
  report::Process process;
  std::string name;  ///< of what it draws
};

std::string file_of(const std::string& name) { return name + ".svg"; }

std::string log_of(const std::string& name) { return file_of(name) + ".log"; }

/// Starts gnuplot on a script in a folder.
Run start_gnuplot(const fs::path& folder, const std::string& name) {
  // Names in UTF-8 wherever it runs, one time zone, and no terminal before the script's own: that
  // of the user's shell may need a display.
  const report::Command command{{"gnuplot", "-d", name + ".gp"},
                                folder,
                                log_of(name),
                                {{"LC_ALL", "C.UTF-8"}, {"TZ", "UTC0"}, {"GNUTERM", "unknown"}}};
  return {report::start(command), name};
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
std::string trouble_of(const fs::path& folder, const Run& run) {
  const std::optional<int> code = exit_code_of(run.process);
  if (!code) return not_installed;
  const fs::path file = folder / file_of(run.name);
  std::error_code error;
  if (*code == 0 && fs::exists(file, error))
    return ends_with(file, "</svg>") ? "" : "only a part could be written";
  std::ifstream log(folder / log_of(run.name));
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

void run_gnuplot(const fs::path& folder, const std::vector<std::string>& names) {
  const std::size_t at_once = std::max(2U, std::thread::hardware_concurrency());
  for (const std::string& name : names) {
    const fs::path script = folder / (name + ".gp");
    if (!ends_with(script, script_end))
      throw OutputError(fmt::format("no plots: {} could be written only in part", script.string()));
  }
  std::deque<Run> running;
  std::string troubles;
  const auto wait_for_first = [&] {
    const std::string trouble = trouble_of(folder, running.front());
    if (!trouble.empty())
      troubles += fmt::format("\n  {}: {}", file_of(running.front().name), trouble);
    running.pop_front();
  };
  for (const std::string& name : names) {
    if (running.size() == at_once) wait_for_first();
    running.push_back(start_gnuplot(folder, name));
    if (running.back().process.id < 0)
      throw report::MissingTool(
          fmt::format("no plots: {}; everything else is written", not_installed));
  }
  while (!running.empty()) wait_for_first();
  if (!troubles.empty()) throw OutputError("gnuplot failed, no plots are written:" + troubles);
}

}  // namespace boxbeam
