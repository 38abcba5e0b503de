#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

namespace boxbeam::program {

/// Says on standard error what is being done once that takes more than half a second; nothing where
/// standard error is no terminal. The line is gone at the end.
class Progress {
 public:
  explicit Progress(bool wanted = true);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// From now on this is done: "drawing the figures".
  void now(std::string what);

 private:
  void watch();

  std::string what_;
  std::mutex mutex_;
  std::condition_variable change_;
  std::thread watcher_;
  bool done_ = false;
};

/// How many samples of a history have been read, likewise.
class SampleCount {
 public:
  explicit SampleCount(bool wanted);
  ~SampleCount();
  SampleCount(const SampleCount&) = delete;
  SampleCount& operator=(const SampleCount&) = delete;

  void at(std::uint64_t samples);

 private:
  std::uint64_t next_ = 0;
  bool shown_ = false;
  bool drawn_ = false;
};

}  // namespace boxbeam::program
