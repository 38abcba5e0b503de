#include "process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "boxbeam/core/error.hpp"

namespace boxbeam::report {
namespace {

namespace fs = std::filesystem;

/// Pointers to texts as C takes them.
std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> environment_with(const std::map<std::string, std::string>& own) {
  std::vector<std::string> all;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    if (own.count(text.substr(0, text.find('='))) == 0) all.push_back(text);
  }
  for (const auto& [name, value] : own) all.push_back(fmt::format("{}={}", name, value));
  return all;
}

}  // namespace

Process start(const Command& command) {
  std::vector<std::string> arguments = command.arguments;
  std::vector<std::string> environment = environment_with(command.environment);
  const std::vector<char*> argument_pointers = pointers_to(arguments);
  const std::vector<char*> environment_pointers = pointers_to(environment);
  const std::string log = (command.folder / command.log).string();

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  posix_spawn_file_actions_addchdir_np(&actions, command.folder.c_str());
  // What this program keeps from itself until all is cleared up must reach that one.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  Process process;
  const Finishing whole;
  const int error = posix_spawnp(&process.id, arguments.front().c_str(), &actions, &attributes,
                                 argument_pointers.data(), environment_pointers.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error == 0) note_program(process.id);
  if (error == ENOENT) return {};
  if (error != 0) {
    throw OutputError(
        fmt::format("{} cannot be started: {}", command.arguments.front(), std::strerror(error)));
  }
  return process;
}

std::optional<int> exit_code_of(const Process& process) {
  if (process.id < 0) return std::nullopt;
  int status = 0;
  while (::waitpid(process.id, &status, 0) < 0 && errno == EINTR) {
  }
  forget_program(process.id);
  if (WIFSIGNALED(status)) return 128 + WTERMSIG(status);
  if (WEXITSTATUS(status) == 127) return std::nullopt;
  return WEXITSTATUS(status);
}

namespace {

fs::path new_folder_in(const fs::path& beside) {
  std::error_code error;
  fs::create_directories(beside, error);
  std::string pattern = (beside / ".boxbeam-XXXXXX").string();
  if (::mkdtemp(pattern.data()) == nullptr) {
    throw OutputError(
        fmt::format("{} cannot be written: {}", beside.string(), std::strerror(errno)));
  }
  return pattern;
}

}  // namespace

ScratchFolder::ScratchFolder(const fs::path& beside) : path_(new_folder_in(beside)) {}

}  // namespace boxbeam::report
