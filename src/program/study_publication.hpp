#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/study/study_summary.hpp"
#include "program/study_designs.hpp"

namespace boxbeam::program {

/// What all chunks of a study have in common.
struct Manifest {
  std::string name, study_file, case_file, sha256, version;
  std::uint64_t seed = 0;
  std::size_t designs = 0, chunk = 1;
  std::vector<Column> columns;       ///< of the table
  std::size_t variables = 0;         ///< of these, behind the number of the design
  bool scatters = false;             ///< designs are drawn as they scatter, and by nothing else
  std::optional<IndexPlan> indices;  ///< where they are asked for
  std::string keep;                  ///< which designs have a row; "": all

  std::size_t chunks() const { return (designs + chunk - 1) / chunk; }
  std::size_t rows_in(std::size_t of) const;
};

Manifest manifest_of(const Study& study, const StudyDesigns& designs, std::size_t chunk);
std::string to_json(const Manifest& of);
/// As it stands below a folder. Throws InputError where it is none.
Manifest manifest_in(const std::string& text, const std::string& folder);

/// The rows of a chunk as they are kept, from those of all its designs; where not all designs have
/// one, a line behind them that says what all come to.
class ChunkRows {
 public:
  explicit ChunkRows(const Manifest& manifest);

  void take(const StudyDesigns::Row& row);
  /// Each with its end.
  std::vector<std::string> lines() &&;

 private:
  bool filters_;
  StudyStatistics statistics_;
  std::vector<std::string> rows_;
};

/// The rows of a chunk, and the line behind them.
using RowsOfChunk = std::function<std::string(std::size_t)>;

/// What a study came to, and the names of its files.
struct PublishedStudy {
  StudySummary summary;
  std::vector<std::string> files;
};

/// Joins all chunks, asked for one after the other, into the files of a folder: rows.csv,
/// study.json, study.html with its figures, and rows.nc where it is wanted; statistics.json, what
/// all designs come to, where not all have a row. Throws OutputError.
PublishedStudy publish_study(const Manifest& manifest, const std::string& folder, bool netcdf,
                             const RowsOfChunk& rows_of);

/// Whether a folder holds the rows of this study, all of them and as they were written.
bool stands_whole(const Manifest& manifest, const std::string& folder);

/// Those rows, chunk by chunk.
RowsOfChunk rows_that_stand(const Manifest& manifest, const std::string& folder);

}  // namespace boxbeam::program
