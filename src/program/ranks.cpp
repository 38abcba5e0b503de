#include "program/ranks.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "boxbeam/core/error.hpp"

namespace boxbeam::program {
namespace {

/// How many processes a launcher has started, by what it tells them: OpenMPI, MPICH and Intel.
std::size_t started_together() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* const text = std::getenv(name);
    if (text != nullptr) return std::strtoul(text, nullptr, 10);
  }
  return 1;
}

/// Beside the program, or where it is installed with it.
std::array<std::filesystem::path, 3> places() {
  std::error_code none;
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
  constexpr const char* name = "libboxbeam_mpi.so";
  return {folder / name, folder / "../lib/boxbeam" / name, folder / "../lib64/boxbeam" / name};
}

}  // namespace

struct Ranks::Library {
  int (*begin)(int*, int*) = nullptr;
  long long (*next)() = nullptr;
  void (*meet)() = nullptr;
  int (*any)(int) = nullptr;
  void (*serve)() = nullptr;
  void (*end)() = nullptr;

  explicit Library(const std::string& path) {
    // Its own libraries look for symbols of MPI among those that are loaded.
    void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
    if (library == nullptr)
      throw InputError(fmt::format("{} cannot be loaded: {}", path, ::dlerror()));
    const auto take = [&](auto& function, const char* name) {
      function = reinterpret_cast<std::decay_t<decltype(function)>>(::dlsym(library, name));
      if (function == nullptr)
        throw InputError(fmt::format("{} is of another version: it has no {}", path, name));
    };
    take(begin, "boxbeam_mpi_begin");
    take(next, "boxbeam_mpi_next");
    take(meet, "boxbeam_mpi_meet");
    take(any, "boxbeam_mpi_any");
    take(serve, "boxbeam_mpi_serve");
    take(end, "boxbeam_mpi_end");
  }
};

Ranks::Ranks() {
  const std::size_t started = started_together();
  if (started <= 1) return;
  for (const std::filesystem::path& path : places()) {
    std::error_code none;
    if (!std::filesystem::exists(path, none)) continue;
    library_ = std::make_unique<Library>(path.string());
    int index = 0, count = 1;
    if (library_->begin(&index, &count) != 0) throw InputError("MPI does not begin");
    index_ = static_cast<std::size_t>(index);
    count_ = static_cast<std::size_t>(count);
    // Each would take itself for the only one, and do all the work.
    if (count_ != started)
      throw InputError(
          fmt::format("{} processes were started together, of which MPI knows {}", started, count_),
          "start them by the mpirun of the MPI that boxbeam is built with");
    return;
  }
  throw InputError(
      fmt::format("{} processes were started together, but this program is built without MPI",
                  started),
      "build with -DBOXBEAM_MPI=ON, or run parts of the study by --shard and join them by boxbeam "
      "merge");
}

Ranks::~Ranks() {
  if (library_) library_->end();
}

std::size_t Ranks::next() {
  if (!library_) return next_++;
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(library_->next());
}

void Ranks::meet() {
  if (!library_) return;
  const std::lock_guard lock(mutex_);
  library_->meet();
}

bool Ranks::any(bool here) {
  if (!library_) return here;
  const std::lock_guard lock(mutex_);
  return library_->any(here ? 1 : 0) != 0;
}

void Ranks::first_alone(const std::function<void()>& task) {
  if (!is_first()) {
    if (any(false)) throw EndedElsewhere{};
    return;
  }
  try {
    task();
  } catch (...) {
    any(true);
    throw;
  }
  any(false);
}

void Ranks::serve() {
  if (!library_) return;
  const std::lock_guard lock(mutex_);
  library_->serve();
}

}  // namespace boxbeam::program
