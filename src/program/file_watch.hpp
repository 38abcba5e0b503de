#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace boxbeam::program {

/// Looks several times a second whether files have changed since it last said so: their time, size
/// or being there. What changes while nobody waits is noticed by the next `wait`.
class FileWatch {
 public:
  explicit FileWatch(const std::vector<std::string>& files) { add(files); }

  /// Files that are known keep the stamp of when they were last looked at.
  void add(const std::vector<std::string>& files);

  /// Returns when one of them has changed and, for a tenth of a second, no longer does: editors
  /// write a file in several steps.
  void wait();

 private:
  struct Stamp {
    bool there = false;
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  static Stamp stamp_of(const std::string& file);
  bool look();

  std::map<std::string, Stamp> stamps_;
};

}  // namespace boxbeam::program
