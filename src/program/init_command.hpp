#pragma once

#include <string>

namespace boxbeam::program {

struct InitOptions {
  std::string kind;     ///< or the file; "": planar, of a robot spatial
  std::string file;     ///< "": KIND.toml; "-": standard output
  bool schema = false;  ///< whether the schema that it names is written beside it
  std::string urdf;     ///< file of the robot with which the case begins; "": none
  std::string mjcf;     ///< the same as a MuJoCo model; one of both at most
  std::string beam;     ///< the robot's link that is the beam; "": its heaviest
};

/// Whether a word names a case file: it ends in ".toml".
bool is_case_file(const std::string& word);

/// `boxbeam init`: writes a commented case that runs as it is, or one begun from a robot.
/// Never overwrites a case; a schema beside it is the program's own and is brought up to date.
/// Returns the exit code.
int run_init(const InitOptions& options);

}  // namespace boxbeam::program
