#pragma once

#include <string>

namespace boxbeam {

/// Writes a file whole or not at all: into a temporary file beside it, then renamed.
/// Creates missing folders. Throws OutputError.
void write_file(const std::string& path, const std::string& content);

}  // namespace boxbeam
