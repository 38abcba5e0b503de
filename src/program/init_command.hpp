#pragma once

#include <string>

namespace boxbeam::program {

struct InitOptions {
  std::string kind = "planar";
  std::string file;  ///< "": KIND.toml; "-": standard output
};

/// `boxbeam init`: writes a commented case that runs as it is. Never overwrites. Returns the exit
/// code.
int run_init(const InitOptions& options);

}  // namespace boxbeam::program
