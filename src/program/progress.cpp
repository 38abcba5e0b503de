#include "program/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace boxbeam::program {
namespace {

using namespace std::chrono_literals;

/// A line that replaces itself needs a terminal that can move its cursor.
bool moves_cursor() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && std::string_view(terminal ? terminal : "dumb") != "dumb";
}

void show(const std::string& text) {
  fmt::print(stderr, "\r{}\033[K", text);
  std::fflush(stderr);
}

void clear() {
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
}

}  // namespace

Progress::Progress(bool wanted) {
  if (wanted && moves_cursor()) watcher_ = std::thread([this] { watch(); });
}

Progress::~Progress() {
  if (!watcher_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  change_.notify_one();
  watcher_.join();
}

void Progress::now(std::string what) {
  if (!watcher_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    what_ = std::move(what);
  }
  change_.notify_one();
}

void Progress::watch() {
  std::unique_lock lock(mutex_);
  if (change_.wait_for(lock, 500ms, [this] { return done_; })) return;
  std::string shown;
  while (!done_) {
    if (what_ != shown) {
      shown = what_;
      show(shown + " ...");
    }
    change_.wait(lock, [&] { return done_ || what_ != shown; });
  }
  if (!shown.empty()) clear();
}

SampleCount::SampleCount(bool wanted) : shown_(wanted && moves_cursor()) {}

SampleCount::~SampleCount() {
  if (drawn_) clear();
}

void SampleCount::at(std::uint64_t samples) {
  constexpr std::uint64_t step = 5'000'000;
  if (!shown_ || samples < next_) return;
  next_ = samples + step;
  drawn_ = true;
  show(fmt::format("{:.0f} million samples", static_cast<double>(samples) * 1e-6));
}

}  // namespace boxbeam::program
