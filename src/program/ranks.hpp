#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>

namespace boxbeam::program {

/// The processes that work on one study, started by mpirun; one where there are no others. What
/// needs MPI is a library of its own, libboxbeam_mpi.so, which is loaded only then: the program
/// starts without MPI everywhere. Throws InputError where mpirun has started several and it is not
/// there, for each would do all the work.
class Ranks {
 public:
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  bool is_first() const { return index_ == 0; }
  std::size_t count() const { return count_; }

  /// Numbers from 0, each given to one asker of one process. May be asked by several threads.
  std::size_t next();
  /// All wait for each other.
  void meet();
  /// Does what the first process alone does while the others wait. Where that throws, it throws
  /// there, and EndedElsewhere in the others.
  void first_alone(const std::function<void()>& task);
  /// Whether any process says so; all wait for each other.
  bool any(bool here);
  /// Serves what the others ask; while waiting for something else.
  void serve();

 private:
  struct Library;

  std::unique_ptr<Library> library_;
  std::mutex mutex_;  ///< of the library, which is asked by one thread at a time
  std::size_t index_ = 0, count_ = 1;
  std::atomic<std::size_t> next_{0};
};

/// Another process has said why all end.
struct EndedElsewhere {};

}  // namespace boxbeam::program
