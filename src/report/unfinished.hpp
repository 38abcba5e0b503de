#pragma once

#include <sys/types.h>

#include <filesystem>
#include <mutex>

/// What must not outlive a run that is ended before its time: scratch folders and files, and the
/// programs that write into them.
namespace boxbeam::report {

/// From here on SIGTERM, SIGINT and SIGHUP (where not ignored) end the program only after all that
/// is unfinished is gone. Call once, before anything is begun.
void clear_up_before_the_end();

/// A file or folder that goes away with all that is in it, at the end of this object's life or of
/// the program's, whichever is first.
class UnfinishedPath {
 public:
  explicit UnfinishedPath(std::filesystem::path path);
  ~UnfinishedPath();
  UnfinishedPath(const UnfinishedPath&) = delete;
  UnfinishedPath& operator=(const UnfinishedPath&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A program at work, from its start until somebody has waited for it.
void note_program(pid_t id);
void forget_program(pid_t id);

/// As long as it lives the program is not ended: what it guards happens wholly or not at all.
class Finishing {
 public:
  Finishing();

 private:
  std::lock_guard<std::recursive_mutex> lock_;
};

}  // namespace boxbeam::report
