#pragma once

#include <functional>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/project/published_values.hpp"
#include "boxbeam/report/document.hpp"
#include "boxbeam/verification/any_motion_result.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam {

enum class Agreement {
  agrees,     ///< within the tolerance
  explained,  ///< not within, and the table says why
  differs,    ///< not within, and nothing is said
};

/// "agrees", "differs, explained", "differs".
const char* to_text(Agreement agreement);

/// A published value beside that of the program, SI.
struct ComparedValue {
  PublishedValue published;
  std::string key;   ///< in full
  std::string unit;  ///< SI unit of the numbers: "Pa", "1"
  double ours = 0.0;
  double difference = 0.0;  ///< ours - published
  double tolerance = 0.0;   ///< on its size
  Agreement agreement = Agreement::agrees;
};

/// The motion at these times [s]; of elastic links, which have no instants, without them.
using MotionAt = std::function<AnyMotionResult(const std::vector<double>& times)>;

struct Comparison {
  std::string path;                 ///< of the table
  std::vector<ComparedValue> rows;  ///< in its order
  std::string gate;                 ///< why no stress of the case counts; "" where they do

  std::size_t count(Agreement agreement) const;
  /// Whether no row differs without a reason.
  bool passes() const { return count(Agreement::differs) == 0; }
};

/// Published values beside the program's. A key is a path into what the program prints as JSON:
/// keys joined by ".", a part of a list in brackets by its name or number, "checks[yield/3.2-/A]";
/// of smallest and largest value "stations[3.2-].M.max", of vectors "x", "y", "z". Results of
/// `verify` as they stand in results.json ("beam." before stations may be left out); results of
/// `motion` at a time as "motion[1.071].bodies.4.x", with the time in seconds.
/// The motion is asked for where a key wants it, once, for all the times.
/// Throws InputError for keys that are no result, with the nearest one, and for units of another
/// dimension, and what `motion` throws.
Comparison compare(const Project& project, const Verification& verification,
                   const PublishedValues& published, const MotionAt& motion);

/// The table with differences first said in one line, plain text.
std::string comparison_text(const Project& project, const Comparison& comparison);

/// "boxbeam.comparison/1": SI units, key order fixed.
std::string comparison_json(const Project& project, const Comparison& comparison);

/// As a document of its own.
report::Document comparison_document(const Project& project, const Comparison& comparison);

}  // namespace boxbeam
