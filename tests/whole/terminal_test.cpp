// What a terminal shows, completion and manual, and places that cannot be written.

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "catch.hpp"
#include "support/program.hpp"

namespace terminal_test {

namespace fs = std::filesystem;

namespace {

using Words = std::vector<std::string>;

const std::string rig = test::project_file("sections/sledge-rig/rig.toml");

/// What the program shows on a terminal of its own, both outputs together; 0 columns: of no size.
std::string on_terminal(const Words& arguments, const std::map<std::string, std::string>& set,
                        unsigned short columns = 0) {
  Words words{test::program()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  int terminal = -1;
  winsize size{};
  size.ws_col = columns;
  const pid_t pid = ::forkpty(&terminal, nullptr, nullptr, &size);
  REQUIRE(pid >= 0);
  if (pid == 0) {
    for (const char* name : {"NO_COLOR", "CLICOLOR", "CLICOLOR_FORCE"}) ::unsetenv(name);
    ::setenv("TERM", "xterm", 1);
    for (const auto& [name, value] : set) ::setenv(name.c_str(), value.c_str(), 1);
    ::execv(pointers[0], pointers.data());
    ::_exit(127);
  }
  // Held open here, for what a terminal still has when its last user goes can be lost.
  const int held = ::open(::ptsname(terminal), O_RDWR | O_NOCTTY);
  std::string shown;
  char buffer[4096];
  for (bool ended = false;;) {
    pollfd waiting{terminal, POLLIN, 0};
    constexpr int milliseconds = 20;
    if (::poll(&waiting, 1, milliseconds) > 0) {
      const ssize_t n = ::read(terminal, buffer, sizeof buffer);
      if (n <= 0) break;
      shown.append(buffer, static_cast<std::size_t>(n));
    } else if (ended) {
      break;
    } else {
      ended = ::waitpid(pid, nullptr, WNOHANG) == pid;
    }
  }
  if (held >= 0) ::close(held);
  ::close(terminal);
  ::waitpid(pid, nullptr, 0);
  return shown;
}

/// The same with a file that must not grow beyond so many bytes.
int exit_code_with_limit(const Words& arguments, rlim_t bytes, std::string& said) {
  const test::TemporaryFolder folder;
  const std::string err = (folder.path() / "err").string();
  Words words{test::program()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t pid = ::fork();
  REQUIRE(pid >= 0);
  if (pid == 0) {
    const int to = ::open(err.c_str(), O_WRONLY | O_CREAT, 0600);
    const int nowhere = ::open("/dev/null", O_WRONLY);
    ::dup2(nowhere, 1);
    ::dup2(to, 2);
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::execv(pointers[0], pointers.data());
    ::_exit(127);
  }
  int status = 0;
  ::waitpid(pid, &status, 0);
  said = test::read_file(err);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// What bash offers where the last word stands.
Words completed(const Words& words, const fs::path& folder) {
  const std::string script = (folder / "completion.bash").string();
  std::string line = "source '" + script + "'; COMP_WORDS=(boxbeam";
  for (const std::string& word : words) line += " '" + word + "'";
  line += "); COMP_CWORD=" + std::to_string(words.size()) +
          "; _boxbeam; printf '%s\\n' \"${COMPREPLY[@]}\"";
  const std::string file = (folder / "run.bash").string();
  const std::string out = (folder / "out").string();
  std::ofstream(file) << "cd '" << folder.string() << "'\n" << line << "\n";
  REQUIRE(std::system(("bash '" + file + "' > '" + out + "'").c_str()) == 0);
  std::istringstream stream(test::read_file(out));
  Words offered;
  for (std::string word; std::getline(stream, word);) {
    if (!word.empty()) offered.push_back(word);
  }
  std::sort(offered.begin(), offered.end());
  return offered;
}

Words options_in(const std::string& help) {
  Words options;
  const std::regex option("\n  (?:-[A-Za-z], )?(--[A-Za-z-]+)");
  for (std::sregex_iterator it(help.begin(), help.end(), option), end; it != end; ++it) {
    options.push_back((*it)[1]);
  }
  return options;
}

const Words commands{"init",        "validate", "verify", "explain",    "compare", "motion",
                     "section",     "fatigue",  "solve",  "sweep",      "merge",   "optimise",
                     "reliability", "chart",    "schema", "completion", "manual",  "help"};

std::string help_of(const std::string& command) {
  const test::ProgramResult result = test::run_program({command, "--help"});
  CHECK(result.exit_code == 0);
  return result.out;
}

}  // namespace

TEST_CASE("colour: only on a terminal that wants it, and never without the word", "[terminal]") {
  const test::TemporaryFolder folder;
  const Words verify{"verify",    rig,     "--no-plots",          "--no-pdf",
                     "--no-html", "--out", folder.path().string()};
  const std::string red = "\033[1;31mFAIL\033[0m";
  CHECK(on_terminal(verify, {}).find(red) != std::string::npos);
  for (const auto& [name, value] :
       std::map<std::string, std::string>{{"NO_COLOR", "1"}, {"CLICOLOR", "0"}, {"TERM", "dumb"}}) {
    INFO(name);
    const std::string shown = on_terminal(verify, {{name, value}});
    // Progress that is taken back from the line is no colour.
    CHECK_FALSE(std::regex_search(shown, std::regex("\033\\[[0-9;]*m")));
    CHECK(shown.find("FAIL") != std::string::npos);
  }
  CHECK(on_terminal(verify, {{"NO_COLOR", ""}}).find(red) != std::string::npos);
  CHECK(test::run_program(verify).out.find('\033') == std::string::npos);
  CHECK(on_terminal({"explain", "governing", rig}, {}).find(": \033[1;31mFAILS\033[0m") !=
        std::string::npos);
  ::setenv("CLICOLOR_FORCE", "1", 1);
  const std::string forced = test::run_program(verify).out;
  ::unsetenv("CLICOLOR_FORCE");
  CHECK(forced.find(red) != std::string::npos);
  // Apart from the colours it is the same text.
  CHECK(std::regex_replace(forced, std::regex("\033\\[[0-9;]*m"), "") ==
        test::run_program(verify).out);
}

TEST_CASE("progress: on a terminal what takes long is named, and gone at the end",
          "[terminal][unsanitized]") {
  const test::TemporaryFolder folder;
  const std::string slow = folder.write("gnuplot", "#!/bin/sh\nsleep 1\nexit 3\n");
  fs::permissions(slow, fs::perms::owner_all);
  const std::string out = (folder.path() / "out").string();
  const Words verify{"verify", rig, "--no-pdf", "--no-html", "--out", out};
  const std::string path = folder.path().string() + ":/bin:/usr/bin";
  const std::string said = "drawing the figures ...";
  const std::string shown = on_terminal(verify, {{"PATH", path}});
  const std::size_t at = shown.find(said);
  REQUIRE(at != std::string::npos);
  CHECK(shown.find("\r\033[K", at + said.size()) < shown.find("FAIL"));
  Words quiet = verify;
  quiet.emplace_back("--quiet");
  CHECK(on_terminal(quiet, {{"PATH", path}}).find(said) == std::string::npos);
  CHECK(on_terminal(verify, {{"PATH", path}, {"TERM", "dumb"}}).find(said) == std::string::npos);
}

TEST_CASE("quiet: one line with the verdict and the governing check", "[terminal]") {
  const test::TemporaryFolder folder;
  const test::ProgramResult result = test::run_program(
      {"verify", rig, "--no-plots", "--no-pdf", "--quiet", "--out", folder.path().string()});
  CHECK(result.exit_code == 1);
  CHECK(result.err.empty());
  CHECK(result.out.starts_with("FAIL; "));
  CHECK(result.out.ends_with("  sledge-rig: fatigue/4.2-/fibre+z, utilisation 165 %\n"));
  CHECK(std::count(result.out.begin(), result.out.end(), '\n') == 1);
}

TEST_CASE("help: every command says what it does, in lines of 100 signs", "[terminal]") {
  const std::string help = test::run_program({"--help"}).out;
  for (const std::string& command : commands) {
    CHECK(help.find("\n  " + command + " ") != std::string::npos);
    for (const std::string& text : {help, help_of(command)}) {
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 100);
    }
    CHECK(help_of(command).find("boxbeam " + command) != std::string::npos);
  }
  CHECK(test::run_program({"--version"}).out.starts_with("boxbeam "));
  CHECK(test::run_program({"-V"}).out == test::run_program({"--version"}).out);
  CHECK(test::run_program({"help"}).out == help);
  CHECK(test::run_program({"help", "verify"}).out == help_of("verify"));
  for (const char* both : {"-o, --out DIR", "-q, --quiet", "-h, --help"}) {
    CHECK(help_of("verify").find(both) != std::string::npos);
  }
}

TEST_CASE("width: on a terminal of 80 columns no line is broken by it", "[terminal]") {
  const test::TemporaryFolder folder;
  const std::string gear = test::project_file("sections/landing-gear/gear.toml");
  const std::string values = test::project_file("sections/landing-gear/published.csv");
  const std::string truck = test::project_file("sections/drill-truck/truck.toml");
  const std::string retraction = test::project_file("sections/landing-gear/retraction.toml");
  const std::string detailed = test::project_file("sections/sledge-rig/rig-detailed.toml");
  const std::string out = folder.path().string();
  const std::string history = folder.write("h.csv", "sigma [MPa], tau [MPa]\n0,1\n90,9\n0,1\n");
  const auto longest = [](const std::string& shown) {
    // Progress is taken back from its line.
    const std::string lasting = std::regex_replace(shown, std::regex("\r[^\r\n]*\033\\[K"), "");
    std::istringstream lines(std::regex_replace(lasting, std::regex("\033\\[[0-9;]*[mK]|\r"), ""));
    std::size_t most = 0;
    for (std::string line; std::getline(lines, line);) {
      // What a path makes long cannot be helped.
      if (line.find('/') == std::string::npos) most = std::max(most, line.size());
    }
    return most;
  };
  for (const Words& command :
       {Words{"--help"}, Words{"help", "fatigue"}, Words{"validate", detailed},
        Words{"verify", rig, "--no-plots", "--no-pdf", "--no-html", "--out", out},
        Words{"verify", retraction, "--no-plots", "--no-pdf", "--no-html", "--out", out},
        Words{"explain", "fatigue", rig}, Words{"motion", rig, "--at", "1"}, Words{"motion", gear},
        Words{"motion", truck}, Words{"motion", rig, "--assemblies"},
        Words{"section", "RHS 200x100x8"}, Words{"compare", gear, values},
        Words{"section", "box 600x1224 flange 12 web 8", "--forces",
              "N = -600 kN, M_y = 1500 kN m"},
        Words{"fatigue", history, "--detail", "71", "--shear-detail", "80"}}) {
    INFO(command[0] << " " << (command.size() > 1 ? command[1] : ""));
    const std::size_t narrow = longest(on_terminal(command, {{"COLUMNS", "80"}}));
    CHECK(narrow > 30);
    CHECK(narrow <= 80);
  }
  for (const std::string& command : commands) {
    INFO(command);
    CHECK(longest(on_terminal({command, "--help"}, {{"COLUMNS", "80"}})) <= 80);
  }
  // The terminal itself, where it has a size; a wide one is used.
  CHECK(longest(on_terminal({"motion", gear}, {}, 80)) <= 80);
  CHECK(longest(on_terminal({"motion", gear}, {{"COLUMNS", "80"}}, 140)) > 110);
}

TEST_CASE("manual: holds every command and every option", "[terminal]") {
  std::string manual = test::run_program({"manual"}).out;
  manual = std::regex_replace(manual, std::regex("\\\\-"), "-");
  CHECK(manual.starts_with(".TH BOXBEAM 1"));
  for (const std::string& command : commands) {
    INFO(command);
    CHECK(manual.find(".SS boxbeam " + command) != std::string::npos);
    for (const std::string& option : options_in(help_of(command))) {
      INFO(option);
      CHECK(manual.find("\\fB" + option + "\\fR") != std::string::npos);
    }
  }
  for (const char* name : {"NO_COLOR", "SOURCE_DATE_EPOCH", "EXIT STATUS", "results.json"}) {
    CHECK(manual.find(name) != std::string::npos);
  }
  if (std::system("command -v groff > /dev/null") == 0) {
    const test::TemporaryFolder folder;
    const std::string file = folder.write("boxbeam.1", test::run_program({"manual"}).out);
    const std::string said = (folder.path() / "said").string();
    CHECK(std::system(
              ("groff -man -Tascii -ww '" + file + "' > /dev/null 2> '" + said + "'").c_str()) ==
          0);
    CHECK(test::read_file(said).empty());
  }
}

TEST_CASE("completion: bash offers commands, options, values and files", "[terminal]") {
  const test::TemporaryFolder folder;
  const std::string script =
      folder.write("completion.bash", test::run_program({"completion", "bash"}).out);
  REQUIRE(std::system(("bash -n '" + script + "'").c_str()) == 0);
  static_cast<void>(folder.write("a case.toml", ""));
  static_cast<void>(folder.write("b.toml", ""));
  static_cast<void>(folder.write("c.csv", ""));
  fs::create_directory(folder.path() / "deep");
  const auto offers = [&](const Words& words) { return completed(words, folder.path()); };

  Words first = commands;
  first.insert(first.end(), {"--help", "--version"});
  std::sort(first.begin(), first.end());
  CHECK(offers({""}) == first);
  CHECK(offers({"ver"}) == Words{"verify"});
  for (const std::string& command : commands) {
    INFO(command);
    Words options = options_in(help_of(command));
    std::sort(options.begin(), options.end());
    CHECK(offers({command, "--"}) == options);
  }
  CHECK(offers({"verify", ""}) == Words{"a case.toml", "b.toml", "deep"});
  CHECK(offers({"fatigue", "c"}) == Words{"c.csv"});
  CHECK(offers({"verify", "--out", ""}) == Words{"deep"});
  CHECK(offers({"verify", "-o", ""}) == Words{"deep"});
  CHECK(offers({"verify", "--dynamics", ""}) == Words{"newton-chain", "rigorous"});
  // bash cuts --dynamics=rig into three words.
  CHECK(offers({"verify", "--dynamics", "=", "rig"}) == Words{"rigorous"});
  CHECK(offers({"verify", "--dynamics", "="}) == Words{"newton-chain", "rigorous"});
  CHECK(offers({"verify", "--dynamics", "rigorous", "b"}) == Words{"b.toml"});
  CHECK(offers({"verify", "--set", ""}).empty());
  CHECK(offers({"compare", "b.toml", ""}) == Words{"c.csv", "deep"});
  CHECK(offers({"init", ""}) == Words{"flexible", "loads", "planar", "spatial", "static"});
  CHECK(offers({"schema", "res"}) == Words{"results"});
  const std::string zsh = test::run_program({"completion", "zsh"}).out;
  CHECK(zsh.starts_with("#compdef boxbeam\n"));
  if (std::system("command -v zsh > /dev/null") == 0) {
    const std::string file = folder.write("_boxbeam", zsh);
    CHECK(std::system(("zsh -n '" + file + "'").c_str()) == 0);
  }
}

TEST_CASE("no space left: exit 4 with the reason, and nothing half-written", "[terminal]") {
  const test::TemporaryFolder folder;
  const std::string out = (folder.path() / "out").string();
  std::string said;
  const Words verify{"verify", rig, "--no-plots", "--no-pdf", "--out", out};
  for (const rlim_t bytes : {rlim_t{0}, rlim_t{1000}, rlim_t{50'000}}) {
    INFO(bytes);
    CHECK(exit_code_with_limit(verify, bytes, said) == 4);
    CHECK((bytes == 0 || said.find("File too large") != std::string::npos));
    CHECK((!fs::exists(out) || fs::is_empty(out)));
  }
  // The report of an earlier run stays whole where a new one cannot be written; with every sheet
  // the HTML is the largest.
  Words full = verify;
  full.insert(full.end(), {"--level", "full"});
  CHECK(test::run_program(full).exit_code == 1);
  const auto html = fs::file_size(out + "/report.html");
  REQUIRE(html > fs::file_size(out + "/results.json"));
  REQUIRE(html > fs::file_size(out + "/report.txt"));
  CHECK(exit_code_with_limit(full, html - 1, said) == 4);
  CHECK(said.find("report.html") != std::string::npos);
  CHECK(fs::file_size(out + "/report.html") == html);
  CHECK(test::read_file(out + "/report.txt").ends_with("\n"));
  CHECK(test::read_file(out + "/results.json").ends_with("}\n"));
}

TEST_CASE("a folder that cannot be one, or must not be written, ends with 4", "[terminal]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("file", "mine");
  const test::ProgramResult result = test::run_program({"verify", rig, "--out", file});
  CHECK(result.exit_code == 4);
  CHECK(result.err.find(file) != std::string::npos);
  CHECK(result.out.empty());  // nothing has been calculated for it
  CHECK(test::read_file(file) == "mine");
  const std::string html = file + "/comparison.html";
  CHECK(test::run_program({"motion", rig, "--json", html}).exit_code == 4);
  if (::geteuid() == 0) return;  // who may write everywhere
  fs::create_directory(folder.path() / "locked");
  fs::permissions(folder.path() / "locked", fs::perms::owner_read | fs::perms::owner_exec);
  CHECK(
      test::run_program({"verify", rig, "--out", (folder.path() / "locked").string()}).exit_code ==
      4);
}

}  // namespace terminal_test
