#pragma once

#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/verification/verify.hpp"
#include "program/case_options.hpp"

/// A case verified with other values of its keys.
namespace boxbeam::program {

/// Of all its beams, without figures and remedies. The case is read from its file once; designs
/// that differ in nothing that the choice of the model looks at have it made for them once. May be
/// asked by several threads at once.
class DesignTrials {
 public:
  explicit DesignTrials(CaseOptions options) : options_(std::move(options)) {}

  /// `set` as --set, behind that of the options. Throws InputError and AnalysisError.
  std::vector<VerifiedBeam> verify(const std::vector<std::string>& set) const;

 private:
  CaseOptions options_;
  mutable std::once_flag opened_;
  mutable std::optional<CaseSource> source_;
  mutable std::mutex mutex_;
  /// By what is set of what the choice looks at, the last few.
  mutable std::deque<std::pair<std::string, std::vector<ModelChoice>>> models_;
};

/// Does what may not be possible for a design: "", or the first thing that is wrong.
template <class Try>
std::string trouble_of(const Try& attempt);

std::string in_one_line(std::string text);

/// The first thing that is wrong, in one line.
std::string in_short(const InputError& error);
std::string in_short(const AnalysisError& error);

template <class Try>
std::string trouble_of(const Try& attempt) {
  try {
    attempt();
    return "";
  } catch (const InputError& error) {
    return in_short(error);
  } catch (const AnalysisError& error) {
    return in_short(error);
  } catch (const OutputError& error) {  // a result that is no number
    return in_one_line(error.what());
  }
}

}  // namespace boxbeam::program
