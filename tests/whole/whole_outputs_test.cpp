// A report in a folder is the old one or the new one, each whole, whatever ends the run; nothing
// temporary stays.
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "support/program.hpp"

namespace whole_outputs_test {

namespace fs = std::filesystem;

namespace {

const std::string rig = test::project_file("sections/sledge-rig/rig.toml");

/// All files of a folder, hidden ones too, with what is in them.
std::map<std::string, std::string> content_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).string();
    files[name] = entry.is_regular_file() ? test::read_file(entry.path()) : "";
  }
  return files;
}

/// Programs of another folder come before those of the path.
class Tools {
 public:
  Tools() : before_(std::getenv("PATH")) {
    ::setenv("PATH", (folder_.path().string() + ":" + before_).c_str(), 1);
  }
  ~Tools() { ::setenv("PATH", before_.c_str(), 1); }
  Tools(const Tools&) = delete;
  Tools& operator=(const Tools&) = delete;

  void write(const std::string& name, const std::string& script) const {
    fs::permissions(folder_.write(name, "#!/bin/sh\n" + script), fs::perms::owner_all);
  }

 private:
  test::TemporaryFolder folder_;
  std::string before_;
};

/// Starts the program; its output goes nowhere. `before`: a program that becomes this one.
pid_t start(const std::vector<std::string>& arguments, std::vector<std::string> before = {}) {
  std::vector<std::string> words = std::move(before);
  words.push_back(test::program());
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  // Where the tests run under nohup, what they start would not hear of a closed terminal either.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t heard;
  sigemptyset(&heard);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&heard, signal);
  posix_spawnattr_setsigdefault(&attributes, &heard);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t id = -1;
  REQUIRE(posix_spawn(&id, words.front().c_str(), &actions, &attributes, pointers.data(),
                      environ) == 0);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return id;
}

int status_of(pid_t id) {
  int status = 0;
  ::waitpid(id, &status, 0);
  return status;
}

/// The exit code where no file may grow beyond so many bytes: as a full disk.
int exit_code_with_room(std::uintmax_t room, const std::vector<std::string>& arguments) {
  const int status =
      status_of(start(arguments, {"/usr/bin/prlimit", "--fsize=" + std::to_string(room)}));
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("a tool that fails leaves the report of an earlier run as it was", "[outputs]") {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  REQUIRE(test::run_program({"verify", rig, "--no-plots", "--out", out}).exit_code == 1);
  const std::map<std::string, std::string> before = content_of(out);
  REQUIRE(before.count("report.pdf") == 1);
  const std::vector<std::string> other{"verify", rig,     "--no-plots",         "--out",
                                       out,      "--set", "strength.required=3"};
  {
    const Tools tools;
    tools.write("pdflatex", "echo '! no fonts today' > report.log\nexit 1\n");
    const test::ProgramResult result = test::run_program(other);
    INFO(result.err);
    CHECK(result.exit_code == 4);
    CHECK(result.err.find("stays as it was") != std::string::npos);
    // The log of the failure is beside it, where the message says.
    CHECK(result.err.find(out + "/report.log") != std::string::npos);
    std::map<std::string, std::string> behind = content_of(out);
    CHECK(behind.erase("report.log") == 1);
    CHECK(behind == before);
  }
  REQUIRE(test::run_program(other).exit_code == 1);
  const std::map<std::string, std::string> behind = content_of(out);
  CHECK(behind.at("results.json") != before.at("results.json"));
  CHECK(behind.count("report.log") == 0);
}

TEST_CASE("a pdflatex that ends well without a PDF is a failure of it", "[outputs]") {
  const Tools tools;
  for (const char* script :
       {"exit 0\n", ": > report.pdf\n", "echo '%PDF-1.5 half' > report.pdf\n"}) {
    CAPTURE(script);
    tools.write("pdflatex", script);
    const test::TemporaryFolder folder;
    const std::string out = (folder.path() / "out").string();
    const test::ProgramResult result =
        test::run_program({"verify", rig, "--no-plots", "--out", out});
    INFO(result.err);
    CHECK(result.exit_code == 4);
    CHECK(result.err.find("no PDF") != std::string::npos);
    CHECK_FALSE(fs::exists(out + "/report.pdf"));
    CHECK(fs::exists(out + "/results.json"));
  }
}

TEST_CASE("a terminal of the user's shell does not reach the figures", "[outputs]") {
  if (std::system("command -v gnuplot > /dev/null") != 0) return;
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  ::setenv("GNUTERM", "x11", 1);
  const test::ProgramResult result =
      test::run_program({"verify", rig, "--no-pdf", "--no-html", "--out", out});
  ::unsetenv("GNUTERM");
  INFO(result.err);
  CHECK(result.exit_code == 1);
  CHECK(fs::exists(out + "/sn.svg"));
}

TEST_CASE("where there is no more room the report of an earlier run stays", "[outputs]") {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  const std::vector<std::string> plain{"verify", rig, "--no-plots", "--no-pdf", "--out", out};
  REQUIRE(test::run_program(plain).exit_code == 1);
  const std::map<std::string, std::string> before = content_of(out);
  const auto whole = fs::file_size(out + "/report.html");
  for (const std::uintmax_t room : {std::uintmax_t{0}, std::uintmax_t{20000}, whole - 1000}) {
    CAPTURE(room);
    std::vector<std::string> other = plain;
    other.insert(other.end(), {"--set", "strength.required=3"});
    CHECK(exit_code_with_room(room, other) == 4);
    CHECK(content_of(out) == before);
  }
}

TEST_CASE("ended before its time a run leaves the report of an earlier run and nothing else",
          "[outputs]") {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  REQUIRE(test::run_program({"verify", rig, "--no-plots", "--no-pdf", "--out", out}).exit_code ==
          1);
  const std::map<std::string, std::string> before = content_of(out);
  const Tools tools;
  const std::string begun = (folder.path() / "begun").string();
  // It says when it is at work, and goes on writing: whoever removes its folder must end it first.
  tools.write("gnuplot", "touch '" + begun + "'\nwhile :; do echo more >> more; done\n");
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    CAPTURE(signal);
    fs::remove(begun);
    const pid_t id = start({"verify", rig, "--out", out, "--set", "strength.required=3"});
    for (int wait = 0; wait < 1000 && !fs::exists(begun); ++wait) ::usleep(10000);
    REQUIRE(fs::exists(begun));
    ::kill(id, signal);
    const int status = status_of(id);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK(content_of(out) == before);
  }
}

TEST_CASE("a new folder is gone again where nothing could be put into it", "[outputs]") {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "a" / "b").string();
  CHECK(exit_code_with_room(0, {"verify", rig, "--no-plots", "--no-pdf", "--out", out}) == 4);
  CHECK_FALSE(fs::exists(folder.path() / "a"));
}

TEST_CASE("a working folder that is gone is an error with a cause", "[outputs]") {
  const test::TemporaryFolder folder;
  const fs::path gone = folder.path() / "gone";
  const fs::path out = folder.path() / "out";
  const std::string program = test::program();
  const auto from_gone = [&](const std::string& arguments) {
    const std::string command = "mkdir '" + gone.string() + "' && cd '" + gone.string() +
                                "' && rmdir '" + gone.string() + "' && '" + program + "' verify '" +
                                rig + "' --quiet " + arguments + " > '" +
                                (folder.path() / "said").string() + "' 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  };
  CHECK(from_gone("--no-plots --no-pdf") == 4);
  CHECK(test::read_file(folder.path() / "said").find("cannot be made") != std::string::npos);
  // With a path from the root there is nothing in its way.
  CHECK(from_gone("--out '" + out.string() + "'") == 1);
  CHECK(fs::exists(out / "report.pdf"));
}

}  // namespace whole_outputs_test
