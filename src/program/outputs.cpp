#include "program/outputs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "boxbeam/report/files.hpp"
#include "boxbeam/report/html_writer.hpp"

namespace boxbeam::program {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

void require_writing_in(const fs::path& folder, const std::string& what) {
  if (::access(folder.c_str(), W_OK | X_OK) == 0) return;
  throw OutputError(fmt::format("{}: nothing can be written in {}: {}", what, folder.string(),
                                std::strerror(errno)));
}

/// Makes a folder and takes it away again: what a file system refuses is known only then.
void require_making(const fs::path& path, const fs::path& there) {
  std::error_code error;
  if (fs::exists(path, error)) return;
  std::error_code trouble;
  fs::create_directories(path, trouble);
  for (fs::path made = path; made != there && !made.empty(); made = made.parent_path()) {
    if (made.has_filename()) fs::remove(made, error);  // "reports/"
    if (!made.has_parent_path() || made.parent_path() == made) break;
  }
  if (trouble)
    throw OutputError(
        fmt::format("the folder {} cannot be made: {}", path.string(), trouble.message()));
}

}  // namespace

void require_file(const std::string& path) {
  if (path.empty() || path == "-") return;
  std::error_code error;
  if (fs::is_directory(path, error)) throw OutputError(fmt::format("{} is a folder", path));
  const fs::path folder = folder_of(path);
  if (!fs::is_directory(folder, error)) {
    throw OutputError(fmt::format("there is no folder {} to write {} to", folder.string(),
                                  fs::path(path).filename().string()));
  }
  if (fs::exists(path, error)) {
    if (::access(path.c_str(), W_OK) == 0) return;
    throw OutputError(fmt::format("{} cannot be written: {}", path, std::strerror(errno)));
  }
  require_writing_in(folder, path);
}

void require_file_beside(const std::string& path, const std::string& folder) {
  if (path.empty() || path == "-") return;
  std::error_code error;
  const bool inside =
      fs::weakly_canonical(folder_of(path), error) == fs::weakly_canonical(folder, error);
  if (!inside || fs::exists(path, error)) require_file(path);
}

void require_folder(const std::string& path) {
  std::error_code error;
  // Where it is not there yet, what is there of the way to it.
  fs::path there = fs::path(path);
  if (!there.has_filename()) there = there.parent_path();  // "reports/"
  while (!fs::exists(fs::symlink_status(there, error))) {
    if (!there.has_parent_path()) {
      there = ".";
      break;
    }
    there = there.parent_path();
  }
  if (!fs::is_directory(there, error)) {
    throw OutputError(
        fmt::format("the folder {} cannot be made: {} is no folder", path, there.string()));
  }
  require_writing_in(there, path);
  require_making(path, there);
}

std::optional<std::string> svg_in(const std::string& folder, const std::string& name) {
  std::ifstream file(folder + "/" + name + ".svg", std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

std::string write_page(const std::string& name, const report::Document& document,
                       const std::string& folder) {
  write_file(folder + "/" + name, report::html_of(document, [&](const std::string& picture) {
               return svg_in(folder, picture);
             }));
  return name;
}

}  // namespace boxbeam::program
