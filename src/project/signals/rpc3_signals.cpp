#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "../csv_text.hpp"
#include "byte_order.hpp"
#include "file_unit.hpp"
#include "signal_reader.hpp"
#include "text_lines.hpp"

namespace boxbeam {
namespace {

constexpr const char* rpc_hint = "give an RPC III file of a time history, as MTS or nCode write it";

/// A head of 512-byte blocks with records of a keyword (32 bytes) and a value (96 bytes), then
/// groups of PTS_PER_GROUP points, channel by channel.
///
///     value = integer SCALE INT_FULL_SCALE/32768
///
/// Source: MTS, RPC III file format; the reader rpc_reader. (Another one, rpc3-file, leaves
/// INT_FULL_SCALE out; with the usual 32752 that is 0.05 % more.)
class Rpc3Reader : public SignalReader {
 public:
  Rpc3Reader(SignalBytes bytes, const SignalSource& source) : bytes_(std::move(bytes)) {
    head_.path = source.path;
    head_.format = SignalFormat::rpc3;
    refuse_time_step(*bytes_, source);
    read_records();
    look_at_kind();
    read_counts();
    read_channels();
    look_at_size();
  }

  void read(const std::vector<std::size_t>& columns, RowBlock& block) override {
    std::vector<char> raw(RowBlock::most_rows * value_bytes_);
    for (std::uint64_t row = 0; row < rows_;) {
      const std::uint64_t in_group = row % group_points_;
      const auto count = static_cast<std::size_t>(
          std::min<std::uint64_t>({RowBlock::most_rows, group_points_ - in_group, rows_ - row}));
      for (std::size_t i = 0; i < count; ++i) {
        block.time()[i] = static_cast<double>(row + i) * *head_.time_step;
      }
      for (std::size_t k = 0; k < columns.size(); ++k) {
        bytes_->read_all(place_of(row, columns[k]), raw.data(), count * value_bytes_);
        fill_column(block.column(k), raw.data(), columns[k], count);
      }
      if (const auto trouble = block.take_filled(count)) fail(*trouble, row, columns);
      row += count;
    }
  }

 private:
  static constexpr std::uint64_t block_bytes = 512;
  static constexpr std::size_t key_bytes = 32, record_bytes = 128;
  static constexpr std::uint64_t most_blocks = 4096;

  struct Record {
    std::string value;
    std::uint64_t at = 0;
  };

  /// The record at a place, whose key must be as told where one is.
  void take_record(std::uint64_t index, std::string_view told = {}) {
    const std::uint64_t at = index * record_bytes;
    if (at + record_bytes > bytes_->size()) {
      bytes_->fail_at(bytes_->size(), "the file ends within its head", rpc_hint);
    }
    char raw[record_bytes];
    bytes_->read_all(at, raw, sizeof raw);
    const auto text = [](const char* from, std::size_t size) {
      const std::string_view all(from, size);
      return utf8_of(trimmed(all.substr(0, all.find('\0'))));
    };
    const std::string key = text(raw, key_bytes);
    const std::string value = text(raw + key_bytes, record_bytes - key_bytes);
    if (!told.empty() && key != told) {
      bytes_->fail_at(at, fmt::format("the keyword {} is due, here is \"{}\"", told, key),
                      rpc_hint);
    }
    if (!key.empty()) records_.insert_or_assign(key, Record{value, at + key_bytes});
  }

  void read_records() {
    take_record(0, "FORMAT");
    take_record(1, "NUM_HEADER_BLOCKS");
    take_record(2, "NUM_PARAMS");
    const std::uint64_t blocks = whole_number("NUM_HEADER_BLOCKS", 1, most_blocks);
    const std::uint64_t records = whole_number("NUM_PARAMS", 3, blocks * 4);
    data_at_ = blocks * block_bytes;
    if (data_at_ > bytes_->size()) {
      bytes_->fail_at(
          bytes_->size(),
          fmt::format("the head is to have {} bytes, the file has {}", data_at_, bytes_->size()),
          rpc_hint);
    }
    for (std::uint64_t i = 3; i < records; ++i) take_record(i);
  }

  const Record& record(const std::string& key) const {
    const auto found = records_.find(key);
    if (found == records_.end()) {
      bytes_->fail(fmt::format("the head has no {}", key), rpc_hint);
    }
    return found->second;
  }

  double number(const std::string& key) const {
    const Record& of = record(key);
    double value = 0.0;
    const char* const begin = of.value.data() + (of.value.starts_with('+') ? 1 : 0);
    const char* const end = of.value.data() + of.value.size();
    const auto [to, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || to != end || !std::isfinite(value)) {
      bytes_->fail_at(of.at, fmt::format("{} is \"{}\", no number", key, of.value), rpc_hint);
    }
    return value;
  }

  std::uint64_t whole_number(const std::string& key, std::uint64_t least,
                             std::uint64_t most) const {
    const double value = number(key);
    const bool inside = value >= static_cast<double>(least) && value <= static_cast<double>(most);
    if (!inside || value != std::floor(value)) {
      bytes_->fail_at(
          record(key).at,
          fmt::format("{} is {}, it can be {} to {}", key, record(key).value, least, most),
          rpc_hint);
    }
    return static_cast<std::uint64_t>(value);
  }

  /// A word of the head that must be one of a few.
  std::string word(const std::string& key, const std::vector<std::string>& known,
                   const std::string& fallback) const {
    std::string value = !fallback.empty() && !records_.contains(key) ? fallback : record(key).value;
    if (std::find(known.begin(), known.end(), value) != known.end()) return value;
    bytes_->fail_at(record(key).at,
                    fmt::format("{} is \"{}\", it can be {}", key, value, fmt::join(known, ", ")),
                    "convert the file to one of these");
  }

  void look_at_kind() {
    const std::string format =
        word("FORMAT", {"BINARY_IEEE_LITTLE_END", "BINARY_IEEE_BIG_END", "BINARY"}, {});
    order_ = format == "BINARY_IEEE_BIG_END" ? std::endian::big : std::endian::little;
    word("FILE_TYPE", {"TIME_HISTORY"}, "TIME_HISTORY");
    word("HALF_FRAMES", {"0"}, "0");
    floats_ =
        word("DATA_TYPE", {"SHORT_INTEGER", "FLOATING_POINT"}, "SHORT_INTEGER") == "FLOATING_POINT";
    value_bytes_ = floats_ ? sizeof(float) : sizeof(std::int16_t);
  }

  void read_counts() {
    constexpr std::uint64_t most_channels = 100'000;
    // So many values at most are in the file.
    const std::uint64_t most = std::max<std::uint64_t>(bytes_->size() / value_bytes_, 1);
    channels_ = whole_number("CHANNELS", 1, most_channels);
    group_points_ = whole_number("PTS_PER_GROUP", 1, most);
    const std::uint64_t frame_points = whole_number("PTS_PER_FRAME", 1, group_points_);
    if (group_points_ % frame_points != 0) {
      bytes_->fail_at(record("PTS_PER_GROUP").at,
                      fmt::format("PTS_PER_GROUP is {}, no multiple of PTS_PER_FRAME, {}",
                                  group_points_, frame_points),
                      rpc_hint);
    }
    rows_ = frame_points * whole_number("FRAMES", 1, most / frame_points);
    if (records_.contains("SAMPLES")) rows_ = whole_number("SAMPLES", 1, rows_);
    const double step = number("DELTA_T");
    if (!(step > 0.0 && step <= 1e9)) {
      bytes_->fail_at(record("DELTA_T").at, fmt::format("the time step is {:g} s", step), rpc_hint);
    }
    head_.rows = rows_;
    head_.time_step = step;
  }

  void read_channels() {
    constexpr double standard_full_scale = 32768.0;
    const double full_scale = floats_ ? standard_full_scale : number("INT_FULL_SCALE");
    if (!(full_scale >= 1.0 && full_scale <= standard_full_scale)) {
      bytes_->fail_at(record("INT_FULL_SCALE").at,
                      fmt::format("INT_FULL_SCALE is {:g}, it can be 1 to 32768", full_scale),
                      rpc_hint);
    }
    for (std::uint64_t i = 1; i <= channels_; ++i) {
      const auto text = [&](const char* key) {
        const std::string& value = record(fmt::format("{}.CHAN_{}", key, i)).value;
        const bool quoted = value.size() >= 2 && value.starts_with('"') && value.ends_with('"');
        return quoted ? value.substr(1, value.size() - 2) : value;
      };
      head_.channels.push_back(
          {text("DESC"), std::string(without_unit_brackets(text("UNITS"))), true});
      if (floats_) continue;
      const std::string key = fmt::format("SCALE.CHAN_{}", i);
      const double scale = number(key);
      if (scale == 0.0) bytes_->fail_at(record(key).at, fmt::format("{} is 0", key), rpc_hint);
      scale_.push_back(scale * (full_scale / standard_full_scale));
    }
  }

  void look_at_size() const {
    const std::uint64_t groups = (rows_ + group_points_ - 1) / group_points_;
    const std::uint64_t have = (bytes_->size() - data_at_) / value_bytes_;
    // The counts are at most those of the file's bytes; divided, nothing overflows.
    const std::uint64_t group_values = group_points_ * channels_;
    if (groups <= have / group_values) return;
    bytes_->fail_at(bytes_->size(),
                    fmt::format("{} groups of {} points of {} channels are due, the file ends in "
                                "group {}",
                                groups, group_points_, channels_, have / group_values + 1),
                    rpc_hint);
  }

  std::uint64_t place_of(std::uint64_t row, std::size_t channel) const {
    const std::uint64_t group = row / group_points_;
    return data_at_ +
           ((group * channels_ + channel) * group_points_ + row % group_points_) * value_bytes_;
  }

  void fill_column(double* to, const char* raw, std::size_t channel, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
      const char* const from = raw + i * value_bytes_;
      to[i] = floats_ ? static_cast<double>(number_of_bytes<float>(from, order_))
                      : number_of_bytes<std::int16_t>(from, order_) * scale_[channel];
    }
  }

  [[noreturn]] void fail(const RowTrouble& trouble, std::uint64_t first,
                         const std::vector<std::size_t>& columns) const {
    const std::uint64_t row = first + trouble.row;
    const bool time = trouble.value == RowTrouble::time;
    const std::size_t channel = time ? 0 : columns[trouble.value];
    bytes_->fail_at(place_of(row, channel),
                    fmt::format("\"{}\" at point {}: {}", head_.channels[channel].name, row + 1,
                                trouble.message),
                    trouble.hint);
  }

  SignalBytes bytes_;
  std::map<std::string, Record> records_;
  std::endian order_ = std::endian::little;
  bool floats_ = false;
  std::size_t value_bytes_ = sizeof(std::int16_t);
  std::uint64_t data_at_ = 0, channels_ = 0, group_points_ = 0, rows_ = 0;
  std::vector<double> scale_;
};

}  // namespace

OpenedSignals open_rpc3_signals(SignalBytes bytes, const SignalSource& source) {
  return std::make_unique<Rpc3Reader>(std::move(bytes), source);
}

}  // namespace boxbeam
