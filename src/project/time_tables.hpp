#pragma once

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "boxbeam/mechanism/recorded/channel_loads.hpp"
#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/project/table_reader.hpp"
#include "text_file.hpp"

namespace boxbeam {

/// A text file beside a case, as it was when it was first asked for.
struct KeptText {
  FileText file;
  std::vector<std::string> lines;
  std::string sha256;  ///< of its bytes
};

/// What the files hold that a case names, kept for the next time that the case is read. For several
/// threads at once.
class KeptFiles {
 public:
  /// Reads the file the first time; what cannot be read is looked for again the next time.
  std::shared_ptr<const KeptText> text_at(const std::string& path);

  /// Of a file of signals, which is not kept itself.
  std::optional<std::string> sha256_at(const std::string& path) const;
  void keep_sha256(const std::string& path, std::string sha256);

  /// Channels by all that they are made of; the last few that were kept.
  std::shared_ptr<const recorded::Channels> channels(const std::string& of) const;
  void keep_channels(std::string of, std::shared_ptr<const recorded::Channels> channels);

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const KeptText>> texts_;
  std::map<std::string, std::string> hashes_;
  std::deque<std::pair<std::string, std::shared_ptr<const recorded::Channels>>> channels_;
};

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
