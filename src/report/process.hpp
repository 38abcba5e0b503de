#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "unfinished.hpp"

namespace boxbeam::report {

/// A program that an output needs is not installed: all else can be had.
class MissingTool : public OutputError {
  using OutputError::OutputError;
};

/// A program to be run in a folder of its own, without a shell and without standard input.
struct Command {
  std::vector<std::string> arguments;              ///< the first is the program
  std::filesystem::path folder;                    ///< where it runs
  std::string log;                                 ///< file there that takes all it says
  std::map<std::string, std::string> environment;  ///< beside, and before, that of this program
};

/// A program that was started.
struct Process {
  pid_t id = -1;  ///< -1: it is not installed
};

/// Starts a program. Throws OutputError where it is installed but cannot be started.
Process start(const Command& command);

/// Waits for the end of a program: its exit code (128 + the signal that ended it), nothing where it
/// is not installed.
std::optional<int> exit_code_of(const Process& process);

/// A folder beside the outputs that goes away with all that is in it.
class ScratchFolder {
 public:
  /// Makes the folders above it where they are missing. Throws OutputError where it cannot be made.
  explicit ScratchFolder(const std::filesystem::path& beside);
  const std::filesystem::path& path() const { return path_.path(); }

 private:
  UnfinishedPath path_;
};

}  // namespace boxbeam::report
