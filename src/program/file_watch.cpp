#include "program/file_watch.hpp"

#include <chrono>
#include <system_error>
#include <thread>

namespace boxbeam::program {

FileWatch::Stamp FileWatch::stamp_of(const std::string& file) {
  Stamp stamp;
  std::error_code error;
  stamp.time = std::filesystem::last_write_time(file, error);
  if (error) return {};
  stamp.size = std::filesystem::file_size(file, error);
  stamp.there = !error;
  return stamp;
}

void FileWatch::add(const std::vector<std::string>& files) {
  for (const std::string& file : files) {
    if (stamps_.count(file) == 0) stamps_[file] = stamp_of(file);
  }
}

bool FileWatch::look() {
  bool changed = false;
  for (auto& [file, stamp] : stamps_) {
    const Stamp now = stamp_of(file);
    changed = changed || now != stamp;
    stamp = now;
  }
  return changed;
}

void FileWatch::wait() {
  constexpr std::chrono::milliseconds pause{100};
  while (!look()) std::this_thread::sleep_for(pause);
  do {
    std::this_thread::sleep_for(pause);
  } while (look());
}

}  // namespace boxbeam::program
