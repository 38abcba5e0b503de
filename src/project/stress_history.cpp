#include "boxbeam/project/stress_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <string_view>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "csv_text.hpp"
#include "decimal_number.hpp"
#include "text_file.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 20U;
constexpr std::size_t chunk_samples = 16384;
constexpr const char* header_hint =
    "the first line reads for example: time [s], sigma [MPa], tau [MPa]; below it numbers";

/// A file or standard input, read in blocks.
class ByteSource {
 public:
  explicit ByteSource(const std::string& path)
      : name_(path == "-" ? "standard input" : path), file_(open(path)) {}

  const std::string& name() const { return name_; }

  /// Fills `to` as far as bytes come; fewer only at the end.
  std::size_t read(char* to, std::size_t size) {
    const std::size_t got = std::fread(to, 1, size, file_.get());
    if (got < size && std::ferror(file_.get()) != 0) {
      fail(fmt::format("the file cannot be read: {}", std::strerror(errno)), {});
    }
    return got;
  }

  /// Of the file as a whole.
  [[noreturn]] void fail(std::string message, std::string hint) const {
    throw InputError({{name_, 0, 0, {}, std::move(message), std::move(hint)}});
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const {
      if (file != stdin) std::fclose(file);
    }
  };
  using File = std::unique_ptr<std::FILE, Close>;

  File open(const std::string& path) const {
    if (path == "-") return File(stdin);
    const FileText absent = look_for_regular_file(path);
    if (absent.trouble == FileText::Trouble::unreadable)
      fail(absent.why, "write - and give it to standard input");
    if (absent.trouble != FileText::Trouble::none) fail(absent.why, "give the path of a history");
    File file(std::fopen(path.c_str(), "rb"));
    if (!file) fail(fmt::format("the file cannot be read: {}", std::strerror(errno)), {});
    // The blocks are large enough.
    std::setvbuf(file.get(), nullptr, _IONBF, 0);
    return file;
  }

  std::string name_;
  File file_;
};

/// Hands samples on in chunks.
class ChunkWriter {
 public:
  ChunkWriter(StressHistory& history, const StressSink& sink) : history_(&history), sink_(&sink) {
    normal_.reserve(chunk_samples);
    shear_.reserve(chunk_samples);
  }

  void add_normal(double stress) { normal_.push_back(stress); }
  void add_shear(double stress) { shear_.push_back(stress); }
  bool is_full() const { return normal_.size() >= chunk_samples; }

  void deliver() {
    if (normal_.empty()) return;
    history_->samples += normal_.size();
    (*sink_)({normal_, shear_});
    normal_.clear();
    shear_.clear();
  }

 private:
  StressHistory* history_;
  const StressSink* sink_;
  std::vector<double> normal_;
  std::vector<double> shear_;
};

/// Reads a table line by line up to the first thing that is wrong.
class HistoryTableReader {
 public:
  HistoryTableReader(ByteSource& bytes, const StressSink& sink)
      : bytes_(&bytes), chunk_(history_, sink) {}

  StressHistory read() {
    // One more for the end of the last line.
    // Not filled: of a short history most of it is never touched.
    const auto block = std::make_unique_for_overwrite<char[]>(block_bytes + 1);
    std::size_t filled = 0;
    bool last = false;
    while (!last) {
      const std::size_t wanted = block_bytes - filled;
      const std::size_t got = bytes_->read(block.get() + filled, wanted);
      unify_line_ends(block.get() + filled, got);
      filled += got;
      last = got < wanted;
      if (last) block[filled++] = '\n';
      const std::string_view text(block.get(), filled);
      const std::size_t whole_lines = text.rfind('\n') + 1;
      if (whole_lines == 0) {
        bytes_->fail("a line is over 1 MB", "give a table of numbers, a line for each instant");
      }
      take_lines(text.substr(0, whole_lines));
      filled -= whole_lines;
      std::memmove(block.get(), block.get() + whole_lines, filled);
    }
    if (columns_.empty() && !head_.columns().empty()) take_columns();
    chunk_.deliver();
    if (history_.samples == 0) {
      bytes_->fail(columns_.empty() ? "the file is empty" : "the table has no rows", header_hint);
    }
    return history_;
  }

 private:
  enum class Kind { time, normal, shear };
  struct Column {
    Kind kind;
    double factor;  ///< to SI
  };

  /// Ends lines with LF where the first one ends with CR alone.
  void unify_line_ends(char* text, std::size_t size) {
    if (!only_returns_) {
      const char* const end =
          std::find_if(text, text + size, [](char c) { return c == '\r' || c == '\n'; });
      if (end == text + size) return;
      only_returns_ = *end == '\r' && (end + 1 == text + size || end[1] != '\n');
    }
    if (*only_returns_) std::replace(text, text + size, '\r', '\n');
  }

  const char* skip_blanks(const char* at) const {
    while (*at == ' ' || (*at == '\t' && form_.separator != '\t')) ++at;
    return at;
  }

  /// `text` ends with the end of a line.
  void take_lines(std::string_view text) {
    const char* const end = text.data() + text.size();
    for (const char* at = text.data(); at != end;) {
      const char* const line = at;
      ++line_;
      if (line_ == 1 && text.starts_with("\uFEFF")) at += 3;
      at = skip_blanks(at);
      if (*at == '\n') {
        ++at;
        continue;
      }
      const bool empty = *at == '#' || (*at == '\r' && at[1] == '\n');
      const char* next = empty || columns_.empty() ? nullptr : take_row(at, end);
      if (next == nullptr) {
        next = static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
        if (!empty) take_unusual({line, static_cast<std::size_t>(next - line)});
        ++next;
      }
      at = next;
      if (chunk_.is_full()) chunk_.deliver();
    }
  }

  /// The end of a number, nullptr where there is none that can be read at once.
  const char* parse_number(const char* at, const char* end, double& value) const {
    const char* const behind = parse_short_decimal(at, form_.decimal_sign, value);
    if (behind != nullptr || form_.decimal_sign != '.') return behind;
    const auto [to, error] = std::from_chars(at, end, value);
    return error == std::errc{} ? to : nullptr;
  }

  /// A row of numbers and nothing else, as nearly all are: returns the beginning of the next line.
  /// Nothing for another one, of which nothing has been taken then.
  const char* take_row(const char* at, const char* end) {
    double numbers[most_columns] = {};
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      if (i > 0) {
        if (*at != form_.separator) return nullptr;
        at = skip_blanks(at + 1);
      }
      at = parse_number(at, end, numbers[i]);
      if (at == nullptr || !(std::abs(numbers[i]) <= largest_table_number)) return nullptr;
      at = skip_blanks(at);
    }
    if (*at == '\r') ++at;
    if (*at != '\n' || !take_numbers(numbers)) return nullptr;
    return at + 1;
  }

  /// False for a time that does not ascend.
  bool take_numbers(const double* numbers) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const double value = numbers[i] * columns_[i].factor;
      switch (columns_[i].kind) {
        case Kind::time:
          if (history_.last_time && !(value > *history_.last_time)) return false;
          if (!history_.first_time) history_.first_time = value;
          history_.last_time = value;
          break;
        case Kind::normal: chunk_.add_normal(value); break;
        case Kind::shear: chunk_.add_shear(value); break;
      }
    }
    return true;
  }

  /// The header, a row with a comment behind it or with long numbers with a decimal comma, or one
  /// in which something is wrong.
  void take_unusual(std::string_view whole) {
    if (line_ == 1 && whole.starts_with("\uFEFF")) whole.remove_prefix(3);
    if (whole.ends_with('\r')) whole.remove_suffix(1);
    source_line_ = whole;
    if (const std::size_t at = find_not_utf8(source_line_); at != std::string_view::npos) {
      fail({{}, position_of(source_line_, at).column}, "the file is not UTF-8 text",
           "save it with UTF-8 encoding, or give the unit of its raw doubles");
    }
    const std::string_view line = without_comment(source_line_);
    if (trimmed(line).empty()) return;
    if (!columns_.empty()) {
      take_unusual_row(line);
    } else if (!head_.wants_more_than(line, static_cast<int>(std::min(line_, largest_line)))) {
      take_columns();
    }
  }

  /// Reads what the columns are, once the head of the table is complete.
  void take_columns() {
    form_ = head_.form();
    std::size_t stresses = 0;
    for (const TableHead::Column& column : head_.columns()) {
      const auto unit = unit_of_column(column.name);
      if (const auto* trouble = std::get_if<std::string>(&unit)) {
        fail_in_head(column, *trouble, header_hint);
      }
      const auto& quantity = std::get<ParsedQuantity>(unit);
      const bool first = &column == &head_.columns().front();
      if (first && is_of(quantity.exponents, wanted::time)) {
        columns_.push_back({Kind::time, quantity.value});
        continue;
      }
      if (!is_of(quantity.exponents, wanted::stress)) {
        fail_in_head(column, wrong_dimension(column.name, quantity.exponents, wanted::stress),
                     header_hint);
      }
      if (++stresses > most_stresses) {
        fail_in_head(column, "a history has at most two stresses, normal and shear",
                     "give the columns of one place only");
      }
      columns_.push_back({stresses == 1 ? Kind::normal : Kind::shear, quantity.value});
    }
    if (stresses == 0) {
      fail_in_head(head_.columns().front(), "the table has no column of a stress", header_hint);
    }
    history_.has_shear = stresses == most_stresses;
  }

  void take_unusual_row(std::string_view line) {
    const std::vector<Field> fields = fields_of(line, form_.separator);
    if (fields.size() != columns_.size()) {
      fail(fields.front(),
           fmt::format("the first line names {}, here {} {}", columns_text(columns_.size()),
                       fields.size() == 1 ? "is" : "are", fields.size()),
           fmt::format("write as many numbers, {} between them{}", form_.separators(),
                       form_.separator == ',' ? "; a decimal comma wants semicolons" : ""));
    }
    double numbers[most_columns] = {};
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const auto number = number_in_table(fields[i].text, form_);
      if (const auto* trouble = std::get_if<FieldTrouble>(&number)) {
        fail(fields[i], trouble->message, trouble->hint);
      }
      numbers[i] = std::get<double>(number);
    }
    if (!take_numbers(numbers)) {
      fail(fields.front(),
           fmt::format("the time {} does not come after that of the row before",
                       fields.front().text),
           "write the rows in the order of time, each instant once");
    }
  }

  static std::string columns_text(std::size_t count) {
    return count == 1 ? "one column" : fmt::format("{} columns", count);
  }

  [[noreturn]] void fail(const Field& field, std::string message, std::string hint) const {
    throw InputError(
        {{bytes_->name(), static_cast<int>(std::min(line_, largest_line)), field.column,
          std::string(source_line_), std::move(message), std::move(hint)}});
  }

  /// Of the head, which may stand lines above.
  [[noreturn]] void fail_in_head(const TableHead::Column& column, std::string message,
                                 std::string hint) const {
    throw InputError({{bytes_->name(), head_.line_number(), column.column, head_.line(),
                       std::move(message), std::move(hint)}});
  }

  static constexpr std::size_t most_columns = 3;
  static constexpr std::size_t most_stresses = 2;
  static constexpr std::int64_t largest_line = std::numeric_limits<int>::max();

  ByteSource* bytes_;
  StressHistory history_;
  ChunkWriter chunk_;
  std::vector<Column> columns_;
  TableHead head_;
  TableForm form_;
  std::optional<bool> only_returns_;  ///< unknown until a line has ended
  std::int64_t line_ = 0;
  std::string_view source_line_;
};

/// The factor to Pa of a unit that stands alone.
double factor_of_unit(const ByteSource& bytes, const std::string& unit) {
  const auto parsed = parse_quantity("1 " + unit);
  const auto* quantity = std::get_if<ParsedQuantity>(&parsed);
  if (quantity == nullptr || !is_of(quantity->exponents, wanted::stress)) {
    bytes.fail(fmt::format("\"{}\" is not the unit of a stress", unit), "give MPa, Pa or N/mm^2");
  }
  return quantity->value;
}

double from_little_endian(const char* bytes) {
  std::uint64_t bits = 0;
  for (unsigned i = 0; i < sizeof bits; ++i) {
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8U * i);
  }
  return std::bit_cast<double>(bits);
}

StressHistory read_raw_doubles(ByteSource& bytes, const std::string& unit, const StressSink& sink) {
  const double factor = factor_of_unit(bytes, unit);
  StressHistory history;
  ChunkWriter chunk(history, sink);
  std::vector<char> block(chunk_samples * sizeof(double));
  for (bool last = false; !last;) {
    const std::size_t got = bytes.read(block.data(), block.size());
    last = got < block.size();
    if (got % sizeof(double) != 0) {
      bytes.fail(fmt::format("the file has {} bytes, no multiple of 8",
                             history.samples * sizeof(double) + got),
                 "raw doubles are 8 bytes each, with nothing before or behind them");
    }
    for (std::size_t at = 0; at < got; at += sizeof(double)) {
      const double value = from_little_endian(block.data() + at);
      if (!(std::abs(value) <= largest_table_number)) {
        const std::uint64_t index = history.samples + at / sizeof(double);
        bytes.fail(fmt::format("sample {} (byte {}) is {:g}: not finite, or too large to be meant",
                               index + 1, index * sizeof(double), value),
                   "raw doubles are little-endian, with nothing before them");
      }
      chunk.add_normal(value * factor);
    }
    chunk.deliver();
  }
  if (history.samples == 0) bytes.fail("the file is empty", "give 8 bytes for each sample");
  return history;
}

}  // namespace

StressHistory read_stress_history(const StressHistorySource& source, const StressSink& sink) {
  ByteSource bytes(source.path);
  if (source.binary_unit) return read_raw_doubles(bytes, *source.binary_unit, sink);
  return HistoryTableReader(bytes, sink).read();
}

}  // namespace boxbeam
