#pragma once

#include <string>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/signal_file.hpp"
#include "catch.hpp"
#include "support/program.hpp"

/// Files of signals in which something is wrong, and what is said of it.
namespace test {

inline bool has_part(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// What is found wrong when a file is read to its end; fails where nothing is.
inline boxbeam::Problem signal_problem_of(const boxbeam::SignalSource& source,
                                          const std::vector<boxbeam::WantedSignal>& wanted = {}) {
  try {
    boxbeam::read_signals(source, wanted, [](const boxbeam::SignalRows&) {});
  } catch (const boxbeam::InputError& error) {
    REQUIRE(error.problems().size() == 1);
    return error.problems().front();
  }
  FAIL("nothing was found wrong");
  return {};
}

struct BrokenSignals {
  std::string text;
  int line;
  const char* message;
  const char* hint;
  /// A given format, step or unit of the time; its path is that of the text.
  boxbeam::SignalSource besides = {};
  std::vector<boxbeam::WantedSignal> wanted = {};
};

/// Writes each as a file of a name and compares what is said of it.
inline void check_broken(const std::string& name, const std::vector<BrokenSignals>& rows) {
  const TemporaryFolder folder;
  for (const BrokenSignals& row : rows) {
    INFO(row.text.substr(0, 300));
    boxbeam::SignalSource source = row.besides;
    source.path = folder.write(name, row.text);
    const boxbeam::Problem problem = signal_problem_of(source, row.wanted);
    INFO(problem.line << ":" << problem.column << ": " << problem.message << " / " << problem.hint);
    CHECK(problem.file == source.path);
    CHECK(problem.line == row.line);
    CHECK(has_part(problem.message, row.message));
    CHECK(has_part(problem.hint, row.hint));
  }
}

}  // namespace test
