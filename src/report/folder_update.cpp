#include "folder_update.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "boxbeam/core/error.hpp"

namespace boxbeam::report {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const char* what, const std::error_code& error) {
  throw OutputError(fmt::format("{} cannot be {}: {}", path.string(), what, error.message()));
}

/// The folders on the way to one that are not there yet, from the outermost.
std::vector<fs::path> missing_folders(const fs::path& folder) {
  std::vector<fs::path> missing;
  std::error_code error;
  for (fs::path at = folder; !at.empty() && !fs::exists(at, error); at = at.parent_path()) {
    missing.insert(missing.begin(), at);
  }
  return missing;
}

/// Files of a folder and of those in it, by their names from there; hidden ones are nobody's.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder));
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// Changes of a folder that can be taken back.
class Changes {
 public:
  Changes(fs::path folder, fs::path kept) : folder_(std::move(folder)), kept_(std::move(kept)) {}

  ~Changes() {
    if (!done_) take_back();
  }
  Changes(const Changes&) = delete;
  Changes& operator=(const Changes&) = delete;

  void replace(const fs::path& name, const fs::path& by) {
    const fs::path target = folder_ / name;
    std::error_code error;
    fs::create_directories(target.parent_path(), error);
    if (error) fail(target.parent_path(), "made", error);
    const bool was_there = keep(name);
    fs::rename(by, target, error);
    if (error) fail(target, "replaced", error);
    changed_.emplace_back(name, was_there);
  }

  void remove(const fs::path& name) {
    if (!keep(name)) return;
    std::error_code error;
    fs::remove(folder_ / name, error);
    if (error) fail(folder_ / name, "removed", error);
    changed_.emplace_back(name, true);
  }

  void finish() { done_ = true; }

 private:
  /// Keeps what stands under a name; false where nothing does. A link to the same file where the
  /// file system knows these: at no moment is the name without its file.
  bool keep(const fs::path& name) {
    const fs::path target = folder_ / name;
    std::error_code error;
    if (!fs::exists(fs::symlink_status(target, error))) return false;
    fs::create_directories((kept_ / name).parent_path(), error);
    fs::create_hard_link(target, kept_ / name, error);
    if (error) {
      error.clear();
      fs::copy(target, kept_ / name, fs::copy_options::copy_symlinks, error);
    }
    if (error) fail(target, "replaced", error);
    return true;
  }

  void take_back() {
    std::error_code ignored;
    for (const auto& [name, was_there] : changed_) {
      if (was_there)
        fs::rename(kept_ / name, folder_ / name, ignored);
      else
        fs::remove(folder_ / name, ignored);
    }
  }

  fs::path folder_, kept_;
  std::vector<std::pair<fs::path, bool>> changed_;  ///< with whether something stood there
  bool done_ = false;
};

}  // namespace

FolderUpdate::FolderUpdate(fs::path folder)
    : folder_(std::move(folder)), made_(missing_folders(folder_)) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) {
    throw OutputError(
        fmt::format("the folder {} cannot be made: {}", folder_.string(), error.message()));
  }
  scratch_.emplace(folder_);
}

FolderUpdate::~FolderUpdate() {
  scratch_.reset();
  std::error_code ignored;
  for (auto at = made_.rbegin(); at != made_.rend(); ++at) fs::remove(*at, ignored);
}

std::string FolderUpdate::in_place(std::string text) const {
  const std::string from = path();
  const std::string to = folder_.string();
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

void FolderUpdate::publish(const std::vector<std::string>& earlier) {
  const ScratchFolder kept(folder_);
  const std::vector<fs::path> files = files_in(scratch_->path());
  const Finishing whole;
  Changes changes(folder_, kept.path());
  for (const fs::path& name : files) changes.replace(name, scratch_->path() / name);
  for (const std::string& name : earlier) {
    if (std::find(files.begin(), files.end(), fs::path(name)) == files.end()) changes.remove(name);
  }
  changes.finish();
}

void FolderUpdate::publish_beside(const std::string& name) {
  std::error_code ignored;
  fs::rename(scratch_->path() / name, folder_ / name, ignored);
}

}  // namespace boxbeam::report
