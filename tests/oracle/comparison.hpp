#pragma once

#include <array>
#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"
#include "oracle.hpp"
#include "random_case.hpp"

namespace oracle {

/// How much more than what is reported the oracle may find: 0.1 %.
inline constexpr double allowed = 1e-3;

/// A criterion whose utilisation is larger somewhere than what is reported.
struct Miss {
  boxbeam::Criterion criterion;
  double reported = 0.0;
  Finding found;

  double excess() const { return found.utilisation / reported - 1.0; }
};

/// A verification beside what the oracle found.
struct Comparison {
  std::vector<Miss> misses;
  std::string verdict;  ///< why the verdict differs; "" where it does not
  /// The largest part, over the criteria, by which the report is above what the oracle found, and
  /// the criterion.
  double most_above = 0.0;
  std::string above;

  bool agrees() const { return misses.empty() && verdict.empty(); }
};

Comparison compare(const boxbeam::Verification& verification, const Findings& findings);

/// What a search might have wrong.
enum class Fault {
  side_dropped,        ///< places just before a station are not looked at
  detail_end_ignored,  ///< where a detail ends, nothing is cut
  grid_of_24,          ///< of every segment 24 equal steps are looked at and no more
};
inline constexpr std::array faults{Fault::side_dropped, Fault::detail_end_ignored,
                                   Fault::grid_of_24};
const char* to_text(Fault fault);

/// The verification without the checks that a faulty search would not have made.
boxbeam::Verification with_fault(const boxbeam::Verification& verification,
                                 const boxbeam::Project& project, Fault fault);

/// What became of a random case.
struct Outcome {
  enum class Kind {
    compared,
    refused,       ///< the case cannot be read: a fault of the generator
    not_analysed,  ///< a step of the analysis cannot be done
    not_covered,
  } kind = Kind::compared;
  std::string why;
  Comparison comparison;
  boxbeam::Verification verification;
  Findings findings;
  /// Of each fault, whether the comparison would show it: some criterion is then reported too low
  /// that is not without it.
  std::array<bool, faults.size()> shown{};
};

/// Writes a case into a folder, verifies it and looks everywhere, by the same runs.
Outcome examine(const RandomCase& of, const std::string& folder, const Density& density);

/// "fatigue: 1.234 at s = 0.05+, top 0.060 m; reported 0.986 (+25.2 %)"
std::string to_text(const Miss& miss);

}  // namespace oracle
