#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"

namespace boxbeam::program {

/// What an export has written, what it says of that (how well the case of loads stands for the
/// mechanism), and what is not there and why.
struct Exported {
  std::vector<std::string> written;
  std::vector<std::string> said;
  std::vector<std::string> left_out;
};

/// `boxbeam verify --export`: writes a verification for other programs into a folder, all files or
/// none. Throws OutputError.
Exported export_files(const Project& project, const Verification& verification,
                      const std::string& folder);

}  // namespace boxbeam::program
