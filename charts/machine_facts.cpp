#include "charts/machine_facts.hpp"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <fstream>
#include <thread>

namespace boxbeam::report {
namespace {

/// As the kernel names it; by its architecture where it gives no name.
std::string processor(const utsname& system) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return system.machine;
}

std::string compiler() {
#if defined(__clang__)
  return fmt::format("Clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
  return fmt::format("GCC {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

constexpr bool optimised =
#ifdef __OPTIMIZE__
    true;
#else
    false;
#endif

}  // namespace

Facts machine_facts() {
  utsname system{};
  uname(&system);
  return {{{"processor",
            fmt::format("{}, {} threads", processor(system), std::thread::hardware_concurrency())},
           {"system", fmt::format("{} {}", system.sysname, system.machine)},
           {"compiler",
            compiler() + (optimised ? ", optimised" : ", not optimised: its times say nothing")}}};
}

}  // namespace boxbeam::report
