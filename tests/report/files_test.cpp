// Files are written whole or not at all.

#include "boxbeam/report/files.hpp"

#include <filesystem>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace files_test {

using namespace boxbeam;
namespace fs = std::filesystem;

TEST_CASE("a file is written whole, in folders that are made, and nothing temporary stays") {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "new" / "deep" / "a.txt";
  write_file(path.string(), "first");
  write_file(path.string(), "second");
  CHECK(test::read_file(path) == "second");
  const fs::directory_iterator files(path.parent_path());
  CHECK(std::distance(begin(files), end(files)) == 1);
}

TEST_CASE("a link keeps its target and a device stays a device") {
  const test::TemporaryFolder folder;
  const std::string target = folder.write("target", "old");
  const fs::path link = folder.path() / "link";
  fs::create_symlink(target, link);
  write_file(link.string(), "new");
  CHECK(fs::is_symlink(link));
  CHECK(test::read_file(target) == "new");
  write_file("/dev/null", "gone");
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("what cannot be written is said, and what stood there stays") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("file", "kept");
  CHECK_THROWS_AS(write_file(file + "/below", "x"), OutputError);
  CHECK_THROWS_AS(write_file(folder.path().string(), "x"), OutputError);
  CHECK_THROWS_AS(write_file("/dev/full", "x"), OutputError);
  CHECK(test::read_file(file) == "kept");
}

}  // namespace files_test
