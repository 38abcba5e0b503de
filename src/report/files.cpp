#include "boxbeam/report/files.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>

#include "boxbeam/core/error.hpp"
#include "unfinished.hpp"

namespace boxbeam {

void write_file(const std::string& path, const std::string& content) {
  namespace fs = std::filesystem;
  const fs::path target(path);
  std::error_code error;
  if (target.has_parent_path()) {
    fs::create_directories(target.parent_path(), error);
    if (error) {
      throw OutputError(fmt::format("the folder {} cannot be made: {}",
                                    target.parent_path().string(), error.message()));
    }
  }
  const auto fail = [&](const char* what, int code) {
    throw OutputError(fmt::format("{} cannot be {}: {}", path, what, std::strerror(code)));
  };
  // A device or a pipe is written to, not replaced; a link keeps its target.
  const bool special = fs::exists(target, error) && !fs::is_regular_file(target, error);
  const fs::path real =
      fs::is_symlink(target, error) ? fs::weakly_canonical(target, error) : target;
  const std::string temporary =
      special ? path : fmt::format("{}.{}.tmp", real.string(), ::getpid());
  std::optional<report::UnfinishedPath> unfinished;
  if (!special) unfinished.emplace(temporary);
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(temporary.c_str(), "wb"),
                                                       std::fclose);
  if (!file) fail("written", errno);
  const bool written =
      std::fwrite(content.data(), 1, content.size(), file.get()) == content.size() &&
      std::fflush(file.get()) == 0;
  const int write_error = errno;
  const bool closed = std::fclose(file.release()) == 0;
  if (!written || !closed) fail("written", written ? errno : write_error);
  if (!special && std::rename(temporary.c_str(), real.c_str()) != 0) fail("replaced", errno);
}

std::string content_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace boxbeam
