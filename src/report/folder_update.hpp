#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "process.hpp"

namespace boxbeam::report {

/// New files for a folder, gathered in a scratch folder inside it until all are there. Then they
/// take the place of those of an earlier run together, or none does: whatever ends the run, the
/// folder holds the old files or the new ones, each whole, and nothing else.
class FolderUpdate {
 public:
  /// Makes the folder where it is missing. Throws OutputError where it cannot be written.
  explicit FolderUpdate(std::filesystem::path folder);
  /// What was not published is gone, and so is the folder where it was made here and is empty.
  ~FolderUpdate();
  FolderUpdate(const FolderUpdate&) = delete;
  FolderUpdate& operator=(const FolderUpdate&) = delete;

  /// Where the new files are written.
  std::string path() const { return scratch_->path().string(); }
  /// A text in which paths of the new files are those that they will have.
  std::string in_place(std::string text) const;
  /// Puts the new files into their places and removes those of `earlier` (names in the folder) that
  /// are not among them. Throws OutputError where that cannot be done; the folder is as it was
  /// then.
  void publish(const std::vector<std::string>& earlier);
  /// Puts one of the new files, where it was written, into its place beside those of before.
  void publish_beside(const std::string& name);

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> made_;  ///< folders, from the outermost
  std::optional<ScratchFolder> scratch_;
};

}  // namespace boxbeam::report
