#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace boxbeam {

/// The bytes of a regular file, read where they are wanted.
class FileBytes {
 public:
  /// Throws InputError for what cannot be opened, and for pipes, devices and folders.
  explicit FileBytes(std::string path);
  ~FileBytes();
  FileBytes(const FileBytes&) = delete;
  FileBytes& operator=(const FileBytes&) = delete;

  const std::string& path() const { return path_; }
  std::uint64_t size() const { return size_; }

  /// Fills `to` as far as the file goes; returns how far.
  std::size_t read_some(std::uint64_t at, char* to, std::size_t count) const;
  /// Fills `to`, or fails: the file is shorter than it was when it was opened.
  void read_all(std::uint64_t at, char* to, std::size_t count) const;

  /// Of the file as a whole.
  [[noreturn]] void fail(std::string message, std::string hint) const;
  /// At a byte, counted from 0.
  [[noreturn]] void fail_at(std::uint64_t byte, const std::string& message, std::string hint) const;

 private:
  std::string path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace boxbeam
