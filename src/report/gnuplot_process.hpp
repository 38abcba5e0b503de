#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace boxbeam {

/// A folder beside the outputs that goes away with all that is in it.
class ScratchFolder {
 public:
  /// Throws OutputError where it cannot be made.
  explicit ScratchFolder(const std::filesystem::path& beside);
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Runs gnuplot on NAME.gp of a folder for every name, all at once; each must leave NAME.svg.
/// As a process of its own, not through a pipe: a pipe would hide that it failed.
/// Throws OutputError where gnuplot is missing (naming the package) or fails (its first words).
void run_gnuplot(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace boxbeam
