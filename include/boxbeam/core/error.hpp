#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace boxbeam {

/// One thing wrong in what the user wrote, with the place and what to write instead.
struct Problem {
  std::string file;
  int line = 0;             ///< 1-based; 0: the problem has no line (a missing file)
  int column = 0;           ///< 1-based
  std::string source_line;  ///< the line as written, without its end
  std::string message;      ///< what is wrong
  std::string hint;         ///< what to write; may be empty
};

/// "file:line:column: error: message", the line, a caret and the hint.
std::string to_text(const Problem& problem);

/// The input is wrong; carries every problem found, in the order of the file.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Problem> problems);
  /// A problem of the command line or of a whole file, without line.
  explicit InputError(const std::string& message, const std::string& hint = {});
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// What is known about an analysis that could not be done.
struct AnalysisFailure {
  std::string what;                       ///< what could not be done, and what to try
  std::string where;                      ///< joint, loop, body or station; may be empty
  std::optional<double> time = {};        ///< [s]
  std::optional<double> residual = {};    ///< of the equations that were to be solved, SI
  std::optional<double> condition = {};   ///< number of the matrix that failed
  std::vector<std::string> details = {};  ///< further lines: a closest position, a limiting value
};

/// The analysis cannot be done for this input. No partial result is ever reported with it.
class AnalysisError : public std::runtime_error {
 public:
  explicit AnalysisError(AnalysisFailure failure);
  const AnalysisFailure& failure() const { return failure_; }

 private:
  AnalysisFailure failure_;
};

/// A file could not be written or an external program failed.
class OutputError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace boxbeam
