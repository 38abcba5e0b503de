#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

#include "file_unit.hpp"
#include "loaded_library.hpp"
#include "signal_reader.hpp"

namespace boxbeam {
namespace {

constexpr const char* netcdf_hint =
    "give the .nc file that MBDyn writes with \"output results: netcdf\"";

/// What is used of libnetcdf for reading. Signatures and constants: netcdf.h 4, whose binary
/// interface has been the same since 4.0.
struct NetcdfLibrary : LoadedLibrary {
  static constexpr int read_only = 0, no_error = 0, longest_name = 256, most_dimensions = 1024;
  static constexpr int letters = 2, whole_32 = 4, doubles = 6, unsigned_32 = 9, whole_64 = 10,
                       unsigned_64 = 11;

  int (*open)(const char*, int, int*) = nullptr;
  int (*close)(int) = nullptr;
  const char* (*message)(int) = nullptr;
  int (*variable_of)(int, const char*, int*) = nullptr;
  int (*variables)(int, int*) = nullptr;
  int (*variable)(int, int, char*, int*, int*, int*, int*) = nullptr;
  int (*length)(int, int, std::size_t*) = nullptr;
  int (*attribute)(int, int, const char*, int*, std::size_t*) = nullptr;
  int (*text)(int, int, const char*, char*) = nullptr;
  int (*values)(int, int, const std::size_t*, const std::size_t*, double*) = nullptr;

  NetcdfLibrary() : LoadedLibrary(netcdf_names) {
    take(open, "nc_open");
    take(close, "nc_close");
    take(message, "nc_strerror");
    take(variable_of, "nc_inq_varid");
    take(variables, "nc_inq_nvars");
    take(variable, "nc_inq_var");
    take(length, "nc_inq_dimlen");
    take(attribute, "nc_inq_att");
    take(text, "nc_get_att_text");
    take(values, "nc_get_vara_double");
  }
};

const NetcdfLibrary& netcdf() {
  static const NetcdfLibrary library;
  return library;
}

/// Whether values of this type are numbers: not letters, strings or types of the file's own.
bool is_number(int type) {
  return type > 0 && type != NetcdfLibrary::letters && type <= NetcdfLibrary::unsigned_64;
}

/// A file of libnetcdf, closed at the end.
class NetcdfFile {
 public:
  explicit NetcdfFile(const FileBytes& bytes) : bytes_(&bytes) {
    if (!netcdf().is_there())
      bytes.fail("NetCDF files are read by libnetcdf, which is not installed here",
                 "install it (Debian: libnetcdf19), or give MBDyn's .jnt, .frc or .act file");
    // A path that could be taken for an address stays a file.
    const std::string path = std::filesystem::absolute(bytes.path()).string();
    check(netcdf().open(path.c_str(), NetcdfLibrary::read_only, &id_), "it is opened");
    open_ = true;
  }
  ~NetcdfFile() {
    if (open_ && netcdf().close != nullptr) netcdf().close(id_);
  }
  NetcdfFile(const NetcdfFile&) = delete;
  NetcdfFile& operator=(const NetcdfFile&) = delete;

  int id() const { return id_; }
  void check(int code, const std::string& when) const {
    if (code == NetcdfLibrary::no_error) return;
    bytes_->fail(fmt::format("libnetcdf says \"{}\" where {}", netcdf().message(code), when),
                 netcdf_hint);
  }

 private:
  const FileBytes* bytes_;
  int id_ = -1;
  bool open_ = false;
};

/// The bytes that a classic file must have, by its head: libnetcdf reads zeros beyond its end.
/// Source: NetCDF classic format specification, version 1.1.
class ClassicLength {
 public:
  explicit ClassicLength(const FileBytes& bytes) : bytes_(&bytes) {
    char magic[4] = {};
    bytes.read_some(0, magic, sizeof magic);
    wide_places_ = magic[3] != 1;
    wide_counts_ = magic[3] == 5;
  }

  std::uint64_t least() {
    at_ = 4;
    const std::uint64_t records = count();
    std::vector<std::uint64_t> lengths;
    for (std::uint64_t n = list(); n > 0; --n) {
      skip_name();
      lengths.push_back(count());
    }
    skip_attributes();
    std::uint64_t end = 0, record = 0, records_at = 0;
    bool records_there = false;
    std::uint64_t record_variables = 0, only_record = 0;
    for (std::uint64_t n = list(); n > 0; --n) {
      skip_name();
      std::uint64_t values = 1;
      bool over_records = false;
      for (std::uint64_t d = count(), i = 0; i < d; ++i) {
        const std::uint64_t dimension = count();
        if (dimension >= lengths.size()) return 0;
        over_records = over_records || lengths[dimension] == 0;
        if (lengths[dimension] > 0) values *= lengths[dimension];
      }
      skip_attributes();
      const std::uint64_t size = values * bytes_of_type(number(4));
      count();
      const std::uint64_t place = number(wide_places_ ? 8 : 4);
      if (!over_records) {
        end = std::max(end, place + size);
        continue;
      }
      records_at = records_there ? std::min(records_at, place) : place;
      records_there = true;
      ++record_variables;
      only_record = size;
      record += (size + 3) / 4 * 4;
    }
    if (record_variables == 1) record = only_record;
    return records_there ? std::max(end, records_at + records * record) : end;
  }

 private:
  static std::uint64_t bytes_of_type(std::uint64_t type) {
    constexpr std::uint64_t sizes[] = {0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8};
    return type < std::size(sizes) ? sizes[type] : 0;
  }
  std::uint64_t number(std::size_t size) {
    unsigned char raw[8] = {};
    bytes_->read_some(at_, reinterpret_cast<char*>(raw), size);
    at_ += size;
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8U | raw[i];
    return value;
  }
  std::uint64_t count() { return number(wide_counts_ ? 8 : 4); }
  /// How many there are in a list; a list that is not there is two zeros. libnetcdf has found the
  /// head whole.
  std::uint64_t list() {
    number(4);
    return count();
  }
  void skip(std::uint64_t size) { at_ += (size + 3) / 4 * 4; }
  void skip_name() { skip(count()); }
  void skip_attributes() {
    for (std::uint64_t n = list(); n > 0; --n) {
      skip_name();
      const std::uint64_t type = number(4);
      skip(count() * bytes_of_type(type));
    }
  }

  const FileBytes* bytes_;
  std::uint64_t at_ = 0;
  bool wide_places_ = false, wide_counts_ = false;
};

/// Variables over the dimension of "time": numbers, and vectors, whose components are channels
/// "elem.joint.2.F.x", .y, .z, or .1, .2 .. where they are not three.
/// Source: MBDyn 1.7.3, input manual, section on NetCDF output.
class NetcdfReader : public SignalReader {
 public:
  NetcdfReader(SignalBytes bytes, const SignalSource& source)
      : bytes_(std::move(bytes)), file_(*bytes_) {
    head_.path = source.path;
    head_.format = SignalFormat::netcdf;
    refuse_time_step(*bytes_, source);
    refuse_truncated();
    read_time(source);
    read_variables();
    head_.rows = rows_;
  }

  void read(const std::vector<std::size_t>& columns, RowBlock& block) override {
    for (std::uint64_t row = 0; row < rows_; row += RowBlock::most_rows) {
      const auto count =
          static_cast<std::size_t>(std::min<std::uint64_t>(RowBlock::most_rows, rows_ - row));
      read_column({time_, 0}, row, count, block.time());
      for (std::size_t i = 0; i < count; ++i) block.time()[i] *= time_unit_;
      for (std::size_t k = 0; k < columns.size(); ++k)
        read_column(columns_[columns[k]], row, count, block.column(k));
      if (const auto trouble = block.take_filled(count)) fail(*trouble, row, columns);
    }
  }

 private:
  static constexpr std::size_t most_channels = 100'000;

  struct Column {
    int variable = 0;
    std::size_t component = 0;
  };

  void refuse_truncated() const {
    char first = 0;
    bytes_->read_some(0, &first, 1);
    if (first != 'C') return;  // HDF5 looks itself
    const std::uint64_t least = ClassicLength(*bytes_).least();
    if (bytes_->size() >= least) return;
    bytes_->fail_at(bytes_->size(),
                    fmt::format("the file is truncated: by its head it has {} bytes, here are {}",
                                least, bytes_->size()),
                    "copy it again");
  }

  struct Variable {
    std::string name;
    int type = 0;
    std::vector<int> dimensions;
  };

  Variable variable(int index) const {
    Variable of;
    int count = 0;
    std::vector<int> dimensions(NetcdfLibrary::most_dimensions);
    char name[NetcdfLibrary::longest_name + 1] = {};
    file_.check(
        netcdf().variable(file_.id(), index, name, &of.type, &count, dimensions.data(), nullptr),
        "its variables are looked at");
    of.name = name;
    of.dimensions.assign(dimensions.begin(), dimensions.begin() + count);
    return of;
  }

  std::size_t length_of(int dimension) const {
    std::size_t length = 0;
    file_.check(netcdf().length(file_.id(), dimension, &length), "its dimensions are looked at");
    return length;
  }

  void read_time(const SignalSource& source) {
    if (netcdf().variable_of(file_.id(), "time", &time_) != NetcdfLibrary::no_error)
      bytes_->fail("the file has no variable \"time\"", netcdf_hint);
    const Variable time = variable(time_);
    if (time.dimensions.size() != 1) {
      bytes_->fail(
          fmt::format("\"time\" has {} dimensions, it is to have one", time.dimensions.size()),
          netcdf_hint);
    }
    if (!is_number(time.type)) bytes_->fail("\"time\" holds no numbers", netcdf_hint);
    time_dimension_ = time.dimensions.front();
    rows_ = length_of(time_dimension_);
    if (rows_ == 0) bytes_->fail("the file holds no instant", netcdf_hint);
    const std::string unit = unit_of(time_);
    if (source.time_unit) time_unit_ = *source.time_unit;
    if (source.time_unit || unit.empty()) return;
    const auto parsed = parse_file_unit(unit);
    const auto* quantity = std::get_if<ParsedQuantity>(&parsed);
    if (quantity == nullptr || !is_of(quantity->exponents, wanted::time)) {
      bytes_->fail(
          fmt::format("the unit of \"time\" is \"{}\", which is no unit of time here", unit),
          "say what one of it is: time_unit = \"1 s\"");
    }
    time_unit_ = quantity->value;
  }

  void read_variables() {
    int count = 0;
    file_.check(netcdf().variables(file_.id(), &count), "its variables are counted");
    for (int index = 0; index < count; ++index) {
      if (index == time_) continue;
      const Variable of = variable(index);
      const std::size_t dimensions = of.dimensions.size();
      if (dimensions < 1 || dimensions > 2 || of.dimensions[0] != time_dimension_) continue;
      if (!is_number(of.type)) continue;
      const std::string unit = unit_of(index);
      const bool wide = of.type == NetcdfLibrary::doubles || of.type == NetcdfLibrary::whole_32 ||
                        of.type >= NetcdfLibrary::unsigned_32;
      if (dimensions == 1) {
        add(of.name, unit, !wide, {index, 0});
        continue;
      }
      const std::size_t length = length_of(of.dimensions[1]);
      if (length > most_channels) continue;
      for (std::size_t i = 0; i < length; ++i) {
        const std::string component =
            length == 3 ? std::string(1, "xyz"[i]) : std::to_string(i + 1);
        add(of.name + "." + component, unit, !wide, {index, i});
      }
    }
    if (columns_.empty()) bytes_->fail("the file has no numbers over its time", netcdf_hint);
  }

  void add(std::string name, const std::string& unit, bool single, const Column& column) {
    if (columns_.size() == most_channels)
      bytes_->fail(fmt::format("the file has more than {} channels", most_channels), netcdf_hint);
    head_.channels.push_back({std::move(name), unit, single});
    columns_.push_back(column);
  }

  /// "" where there is none.
  std::string unit_of(int variable) const {
    constexpr const char* name = "units";
    constexpr std::size_t longest = 1000;
    int type = 0;
    std::size_t length = 0;
    if (netcdf().attribute(file_.id(), variable, name, &type, &length) != NetcdfLibrary::no_error)
      return "";
    if (type != NetcdfLibrary::letters || length > longest) return "";
    std::string text(length, '\0');
    file_.check(netcdf().text(file_.id(), variable, name, text.data()), "a unit is read");
    return text.substr(0, text.find('\0'));
  }

  void read_column(const Column& column, std::uint64_t row, std::size_t count, double* to) const {
    const std::size_t start[2] = {static_cast<std::size_t>(row), column.component};
    const std::size_t counts[2] = {count, 1};
    file_.check(netcdf().values(file_.id(), column.variable, start, counts, to),
                fmt::format("instants from {} on are read", row + 1));
  }

  [[noreturn]] void fail(const RowTrouble& trouble, std::uint64_t row,
                         const std::vector<std::size_t>& columns) const {
    const std::string& name = trouble.value == RowTrouble::time
                                  ? std::string("time")
                                  : head_.channels[columns[trouble.value]].name;
    bytes_->fail(
        fmt::format("instant {}, \"{}\": {}", row + trouble.row + 1, name, trouble.message),
        trouble.hint);
  }

  SignalBytes bytes_;
  NetcdfFile file_;
  std::vector<Column> columns_;
  int time_ = -1, time_dimension_ = -1;
  double time_unit_ = 1.0;  // [s]
  std::uint64_t rows_ = 0;
};

}  // namespace

OpenedSignals open_netcdf_signals(SignalBytes bytes, const SignalSource& source) {
  return std::make_unique<NetcdfReader>(std::move(bytes), source);
}

}  // namespace boxbeam
