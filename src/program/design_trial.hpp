#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/verification/kept_runs.hpp"
#include "program/case_options.hpp"

/// A case verified with other values of its keys.
namespace boxbeam::program {

/// What a design comes to.
struct VerifiedDesign {
  std::shared_ptr<const void> rests_on;  ///< what the beams look at; not behind the trials
  std::vector<VerifiedBeam> beams;
};

/// Of all its beams, without figures and remedies. The case is read from its file once; of designs
/// that differ in what resists alone one runs, for each thread. Where no two in a row of designs
/// were such, nothing is kept until two are again: keeping costs a fifth of a small design. May be
/// asked by several threads at once.
class DesignTrials {
 public:
  explicit DesignTrials(CaseOptions options) : options_(std::move(options)) {}

  /// `set` as --set, behind that of the options. Throws InputError and AnalysisError.
  VerifiedDesign verify(const std::vector<std::string>& set) const;

 private:
  CaseOptions options_;
  mutable std::once_flag opened_;
  mutable std::optional<CaseSource> source_;
  /// Runs by what is set of what they depend on.
  struct Kept {
    std::string looked_at;
    std::unique_ptr<KeptRuns> runs;
  };
  std::optional<Kept> take(std::string looked_at) const;
  void put_back(Kept kept) const;
  bool is_worth_keeping(const std::string& looked_at) const;

  mutable std::mutex mutex_;
  mutable std::deque<Kept> idle_;         ///< the last first
  mutable std::deque<std::string> seen_;  ///< what the last designs set of it, the last first
  mutable std::size_t unlike_ = 0;        ///< designs in a row that were like none of these
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
