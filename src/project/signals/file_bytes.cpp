#include "file_bytes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "../text_file.hpp"
#include "boxbeam/core/error.hpp"

namespace boxbeam {

FileBytes::FileBytes(std::string path) : path_(std::move(path)) {
  const char* const hint = "give the path of a file of signals";
  const FileText absent = look_for_file(path_);
  if (absent.trouble != FileText::Trouble::none) fail(absent.why, hint);
  // Who opens a pipe without O_NONBLOCK waits for its writer.
  descriptor_ = ::open(path_.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) fail(fmt::format("the file cannot be read: {}", std::strerror(errno)), {});
  struct stat status {};
  const bool regular = ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
  if (!regular) {
    ::close(descriptor_);
    fail("this is a pipe or a device, no file", hint);
  }
  size_ = static_cast<std::uint64_t>(status.st_size);
}

FileBytes::~FileBytes() { ::close(descriptor_); }

std::size_t FileBytes::read_some(std::uint64_t at, char* to, std::size_t count) const {
  std::size_t done = 0;
  while (done < count) {
    const ssize_t got =
        ::pread(descriptor_, to + done, count - done, static_cast<off_t>(at + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(fmt::format("the file cannot be read: {}", std::strerror(errno)), {});
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

void FileBytes::read_all(std::uint64_t at, char* to, std::size_t count) const {
  const std::size_t got = read_some(at, to, count);
  if (got < count) fail_at(at + got, "the file ends here while it is read", "wait for its writer");
}

void FileBytes::fail(std::string message, std::string hint) const {
  throw InputError({{path_, 0, 0, {}, std::move(message), std::move(hint)}});
}

void FileBytes::fail_at(std::uint64_t byte, const std::string& message, std::string hint) const {
  fail(fmt::format("byte {}: {}", byte, message), std::move(hint));
}

}  // namespace boxbeam
