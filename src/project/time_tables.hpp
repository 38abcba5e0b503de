#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/project/table_reader.hpp"
#include "kept_files.hpp"

namespace boxbeam {

/// A value over time, from a text file beside the case.
struct TimeTable {
  std::vector<double> time;   ///< strictly ascending [s]
  std::vector<double> value;  ///< SI
  Place end;                  ///< its last row
};

/// The tables of numbers that a case names: files whose first line names two columns with their
/// units, `time [s], stroke [mm]`, or whose second line gives the units. Between columns stand
/// commas, semicolons or tabs, with the latter two the decimal sign may be a comma; names may stand
/// in quotation marks; behind "#" stands a comment. Every file becomes part of the document, whose
/// hash covers it.
class TimeTables {
 public:
  TimeTables(CaseDocument& document, KeptFiles& files) : document_(&document), files_(&files) {}

  /// The table in the file that a key names, its path taken from the folder of the case file; a
  /// problem and nothing where it cannot be read. `column` names the value in examples.
  std::optional<TimeTable> read(TableReader& table, std::string_view key,
                                const WantedDimension& wanted, const char* column);

  /// Path from the working folder of what a case writes from its own.
  std::string resolved(const std::string& written) const;

  /// Takes a file of signals, which others read, for the hash of the input.
  void add_signals(const std::string& written);

  KeptFiles& files() { return *files_; }

 private:
  /// The lines of a file, read once; nothing and a problem where it cannot be read.
  const std::vector<std::string>* lines_of(TableReader& table, std::string_view key,
                                           const std::string& written, const std::string& resolved);

  /// Whether the document has a file already.
  bool is_known(const std::string& resolved) const;

  CaseDocument* document_;
  KeptFiles* files_;
};

}  // namespace boxbeam
