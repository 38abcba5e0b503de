#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam::program {

/// What an export has written, and what it says of it: what is not there and why, and how well the
/// case of loads stands for the mechanism.
struct Exported {
  std::vector<std::string> written;
  std::vector<std::string> said;
};

/// `boxbeam verify --export`: writes a verification for other programs into a folder, all files or
/// none. Throws OutputError.
Exported export_files(const Project& project, const Verification& verification,
                      const std::string& folder);

}  // namespace boxbeam::program
