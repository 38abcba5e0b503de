#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/quantity_text.hpp"

namespace boxbeam {

/// How far a published value may be from the program's: SI, or a fraction of the published value.
struct PublishedTolerance {
  double value = 0.0;
  bool relative = false;
  std::string written;  ///< "1 %", "0.05 mm"
};

/// A value of another calculation: which result it is, how exact it is, and why it may differ.
struct PublishedValue {
  std::string key;  ///< "governing.fatigue.safety_factor", "motion[1.071].bodies.4.x"
  ParsedQuantity value;
  std::string written;  ///< as it stands in the file: "16.3 MPa"
  std::string unit;     ///< of that: "MPa", "" without
  double scale = 1.0;   ///< SI value of one of it
  int digits = 0;       ///< of the number, without leading zeros
  PublishedTolerance tolerance;
  std::string reason;  ///< why it differs; "" where it is meant to agree
  std::string source;  ///< where it is published
  // For messages:
  int line = 0, key_column = 0, value_column = 0;  ///< from 1
  std::string source_line;
};

struct PublishedValues {
  std::string path;
  std::vector<PublishedValue> rows;  ///< in the order of the file, at least one
};

/// Reads a table of published values, comma-separated, of which the first line names the columns:
///
///     result,published,tolerance,reason,source
///     beam.mass,4.95 t,1 %,,"table 3"
///
/// The columns reason and source may be missing; their order does not matter. Parts may stand in
/// quotes ("" is a quote in quotes); lines that begin with "#" are comments. A number has a unit
/// where its result has one; a tolerance is "1 %" of the published value, or absolute. A result may
/// stand more than once where the sources differ.
/// Throws InputError with all problems and their places.
PublishedValues read_published(const std::string& path);

}  // namespace boxbeam
