#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Running the built program as a user does.
namespace test {

struct ProgramResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// The built program.
std::string program();

/// Runs the program with arguments; no shell is involved. `folder`: its working directory; that of
/// the project where none is given.
ProgramResult run_program(const std::vector<std::string>& arguments,
                          const std::filesystem::path& folder = {});

/// A folder under the system's temporary folder that is removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  /// Writes a file into the folder and returns its path.
  std::string write(const std::string& name, const std::string& content) const;

 private:
  std::filesystem::path path_;
};

std::string read_file(const std::filesystem::path& path);

/// The path of a file of the project, "sections/sledge-rig/rig.toml".
std::string project_file(const std::string& path);

}  // namespace test
