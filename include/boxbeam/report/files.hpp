#pragma once

#include <string>

namespace boxbeam {

/// Writes a file whole or not at all: into a temporary file beside it, then renamed.
/// Creates missing folders. Throws OutputError.
void write_file(const std::string& path, const std::string& content);

/// All of a file; "" where it cannot be read.
std::string content_of(const std::string& path);

}  // namespace boxbeam
