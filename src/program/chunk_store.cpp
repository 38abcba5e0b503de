#include "program/chunk_store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/case_document.hpp"
#include "boxbeam/report/files.hpp"

namespace boxbeam::program {
namespace {

namespace fs = std::filesystem;

constexpr const char* manifest_name = "manifest.json";

std::optional<std::string> bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/// What is written is on the disk, not only on its way there.
void sync(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

std::string footer_of(const std::string& rows, std::size_t count) {
  return fmt::format("# {} rows, sha256 {}\n", count, sha256_of(rows));
}

}  // namespace

ChunkStore::ChunkStore(fs::path folder, std::string manifest)
    : folder_(std::move(folder)), manifest_(std::move(manifest)) {}

fs::path ChunkStore::file_of(std::size_t chunk) const {
  return folder_ / fmt::format("{:08}.csv", chunk);
}

bool ChunkStore::stands() const {
  std::error_code error;
  return fs::is_regular_file(folder_ / manifest_name, error);
}

void ChunkStore::require_same() const {
  if (manifest_in(folder_.parent_path()) != manifest_)
    throw InputError(
        fmt::format("{} holds designs of another study, or of this one as it was before",
                    folder_.string()),
        "give another --out, or remove the folder: what is there cannot be gone on with");
}

void ChunkStore::begin() const {
  write_file((folder_ / manifest_name).string(), manifest_);
  sync(folder_);
}

void ChunkStore::write(std::size_t chunk, const std::vector<std::string>& rows) const {
  std::string all;
  for (const std::string& row : rows) all += row;
  const fs::path file = file_of(chunk);
  write_file(file.string(), all + footer_of(all, rows.size()));
  sync(file);
  sync(folder_);
}

std::optional<std::string> ChunkStore::read(std::size_t chunk) const {
  std::optional<std::string> bytes = bytes_of(file_of(chunk));
  if (!bytes || bytes->size() < 2) return std::nullopt;
  const std::size_t end = bytes->rfind('\n', bytes->size() - 2);
  const std::size_t footer = end == std::string::npos ? 0 : end + 1;
  const std::string said = bytes->substr(footer);
  bytes->resize(footer);
  const auto count = static_cast<std::size_t>(std::count(bytes->begin(), bytes->end(), '\n'));
  if (said != footer_of(*bytes, count)) return std::nullopt;
  return bytes;
}

void ChunkStore::remove() const {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::optional<std::string> manifest_in(const fs::path& folder) {
  return bytes_of(folder / "chunks" / manifest_name);
}

}  // namespace boxbeam::program
