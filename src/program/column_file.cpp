#include "program/column_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>

#include "boxbeam/core/error.hpp"
#include "project/signals/loaded_library.hpp"
#include "version.hpp"

namespace boxbeam::program {
namespace {

/// What is used of libnetcdf for writing. Signatures and constants: netcdf.h 4.
struct NetcdfWriting : LoadedLibrary {
  static constexpr int netcdf_4 = 0x1000, doubles = 6, whole_64 = 10, texts = 12, of_file = -1;

  int (*create)(const char*, int, int*) = nullptr;
  int (*close)(int) = nullptr;
  const char* (*message)(int) = nullptr;
  int (*dimension)(int, const char*, std::size_t, int*) = nullptr;
  int (*variable)(int, const char*, int, int, const int*, int*) = nullptr;
  int (*attribute)(int, int, const char*, std::size_t, const char*) = nullptr;
  int (*put_doubles)(int, int, const std::size_t*, const std::size_t*, const double*) = nullptr;
  int (*put_whole)(int, int, const std::size_t*, const std::size_t*, const long long*) = nullptr;
  int (*put_texts)(int, int, const std::size_t*, const std::size_t*, const char**) = nullptr;

  NetcdfWriting() : LoadedLibrary(netcdf_names) {
    take(create, "nc_create");
    take(close, "nc_close");
    take(message, "nc_strerror");
    take(dimension, "nc_def_dim");
    take(variable, "nc_def_var");
    take(attribute, "nc_put_att_text");
    take(put_doubles, "nc_put_vara_double");
    take(put_whole, "nc_put_vara_longlong");
    take(put_texts, "nc_put_vara_string");
  }
};

const NetcdfWriting& netcdf() {
  static const NetcdfWriting library;
  return library;
}

double cell_number(const std::string& cell) {
  double number = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(cell.data(), cell.data() + cell.size(), number);
  return number;
}

}  // namespace

void require_column_files() {
  if (netcdf().is_there()) return;
  throw InputError("--netcdf: NetCDF files are written by libnetcdf, which is not installed here",
                   "install it (Debian: libnetcdf19), or read rows.csv");
}

namespace {

class ColumnFile {
 public:
  ColumnFile(const std::string& path, const std::vector<Column>& columns,
             const StudySummary& summary)
      : path_(path) {
    require_column_files();
    check(netcdf().create(path.c_str(), NetcdfWriting::netcdf_4, &id_));
    open_ = true;
    put_text(NetcdfWriting::of_file, "title", summary.name);
    put_text(NetcdfWriting::of_file, "source", std::string("boxbeam ") + version);
    put_text(NetcdfWriting::of_file, "input_sha256", summary.sha256);
    int designs = 0;
    check(netcdf().dimension(id_, "design", summary.kept, &designs));
    for (const Column& column : columns) {
      const int type = column.name == "design"      ? NetcdfWriting::whole_64
                       : is_number(column, summary) ? NetcdfWriting::doubles
                                                    : NetcdfWriting::texts;
      int variable = 0;
      check(netcdf().variable(id_, column.name.c_str(), type, 1, &designs, &variable));
      if (!column.unit.empty()) put_text(variable, "units", column.unit);
      types_.push_back(type);
      variables_.push_back(variable);
    }
    cells_.resize(columns.size());
  }
  ~ColumnFile() {
    if (open_ && netcdf().close != nullptr) netcdf().close(id_);
  }
  ColumnFile(const ColumnFile&) = delete;
  ColumnFile& operator=(const ColumnFile&) = delete;

  void take(const std::vector<std::string>& cells) {
    for (std::size_t k = 0; k < cells_.size(); ++k) cells_[k].push_back(cells.at(k));
    constexpr std::size_t block = 4096;
    if (cells_.front().size() == block) flush();
  }

  void end() {
    flush();
    open_ = false;
    check(netcdf().close(id_));
  }

 private:
  static bool is_number(const Column& column, const StudySummary& summary) {
    return std::any_of(summary.statistics.begin(), summary.statistics.end(),
                       [&](const ColumnStatistics& of) { return of.column.name == column.name; });
  }

  void check(int code) const {
    if (code != 0)
      throw OutputError(fmt::format("{} cannot be written: {}", path_, netcdf().message(code)));
  }

  void put_text(int variable, const char* name, const std::string& text) const {
    check(netcdf().attribute(id_, variable, name, text.size(), text.c_str()));
  }

  void flush() {
    const std::size_t count = cells_.front().size();
    if (count == 0) return;
    for (std::size_t k = 0; k < cells_.size(); ++k) {
      if (types_[k] == NetcdfWriting::texts) {
        std::vector<const char*> texts;
        for (const std::string& cell : cells_[k]) texts.push_back(cell.c_str());
        check(netcdf().put_texts(id_, variables_[k], &rows_, &count, texts.data()));
      } else if (types_[k] == NetcdfWriting::whole_64) {
        std::vector<long long> numbers;
        for (const std::string& cell : cells_[k]) numbers.push_back(std::stoll(cell));
        check(netcdf().put_whole(id_, variables_[k], &rows_, &count, numbers.data()));
      } else {
        std::vector<double> numbers;
        for (const std::string& cell : cells_[k]) numbers.push_back(cell_number(cell));
        check(netcdf().put_doubles(id_, variables_[k], &rows_, &count, numbers.data()));
      }
      cells_[k].clear();
    }
    rows_ += count;
  }

  std::string path_;
  int id_ = -1;
  bool open_ = false;
  std::vector<int> types_, variables_;
  std::vector<std::vector<std::string>> cells_;  ///< of each column, not yet written
  std::size_t rows_ = 0;                         ///< written
};

}  // namespace

void write_column_file(const std::string& path, const std::string& rows,
                       const std::vector<Column>& columns, const StudySummary& summary) {
  ColumnFile file(path, columns, summary);
  std::ifstream from(rows, std::ios::binary);
  std::string row;
  std::getline(from, row);  // the names
  while (std::getline(from, row)) file.take(cells_in(row));
  file.end();
}

}  // namespace boxbeam::program
