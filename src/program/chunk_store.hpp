#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace boxbeam::program {

/// The rows of a study in chunks of equal size, each a file of its own below DIR/chunks that is
/// there whole or not at all: its last line says how many rows it has and their SHA-256. A manifest
/// beside them says of which study they are.
class ChunkStore {
 public:
  /// `manifest`: what all chunks have in common, as it is written.
  ChunkStore(std::filesystem::path folder, std::string manifest);

  /// Whether chunks of an earlier run stand there.
  bool stands() const;
  /// Throws InputError where they are of another study.
  void require_same() const;
  /// Makes the folder, with the manifest. Throws OutputError.
  void begin() const;
  void write(std::size_t chunk, const std::vector<std::string>& rows) const;
  /// The rows of a chunk, each with its end; nothing where it is missing or not whole.
  std::optional<std::string> read(std::size_t chunk) const;
  /// Chunks and manifest are no longer needed.
  void remove() const;

  const std::string& manifest() const { return manifest_; }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path file_of(std::size_t chunk) const;

  std::filesystem::path folder_;  ///< DIR/chunks
  std::string manifest_;
};

/// The manifest of the chunks below a folder; nothing where there is none.
std::optional<std::string> manifest_in(const std::filesystem::path& folder);

}  // namespace boxbeam::program
