#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "../csv_text.hpp"
#include "byte_order.hpp"
#include "file_unit.hpp"
#include "signal_reader.hpp"
#include "text_lines.hpp"

namespace boxbeam {
namespace {

constexpr const char* outb_hint =
    "give a .outb file as OpenFAST writes it at the end of a run; or its text output, .out";

/// Ids: 1 times as integers, 2 equal steps, 3 equal steps and double precision, 4 as 2 with the
/// length of the names in the head. A value is (integer - offset)/scale.
/// Source: OpenFAST, WrBinFAST of the NWTC library; the reader of openfast_toolbox.
class OpenfastBinaryReader : public SignalReader {
 public:
  OpenfastBinaryReader(SignalBytes bytes, const SignalSource& source) : bytes_(std::move(bytes)) {
    head_.path = source.path;
    head_.format = SignalFormat::openfast_binary;
    refuse_time_step(*bytes_, source);
    read_counts();
    read_scales();
    read_names();
    look_at_size();
  }

  void read(const std::vector<std::size_t>& columns, RowBlock& block) override {
    look_at_scales(columns);
    const std::uint64_t row_bytes = channels_ * value_bytes();
    const std::uint64_t at_once =
        std::clamp<std::uint64_t>(block_bytes / row_bytes, 1, RowBlock::most_rows);
    std::vector<char> raw(static_cast<std::size_t>(at_once * row_bytes));
    std::vector<char> times(packed_time() ? static_cast<std::size_t>(4 * at_once) : 0);
    for (std::uint64_t row = 0; row < rows_; row += at_once) {
      const auto count = static_cast<std::size_t>(std::min(at_once, rows_ - row));
      bytes_->read_all(rows_at_ + row * row_bytes, raw.data(),
                       static_cast<std::size_t>(count * row_bytes));
      if (packed_time()) bytes_->read_all(times_at_ + 4 * row, times.data(), 4 * count);
      fill_time(block.time(), times.data(), row, count);
      for (std::size_t k = 0; k < columns.size(); ++k) {
        fill_column(block.column(k), raw.data(), columns[k], count);
      }
      if (const auto trouble = block.take_filled(count)) fail(*trouble, row, columns);
    }
  }

 private:
  static constexpr std::uint64_t block_bytes = std::uint64_t{4} << 20U;
  static constexpr std::size_t most_channels = 100'000;

  bool packed_time() const { return id_ == 1; }
  bool doubles() const { return id_ == 3; }
  std::uint64_t value_bytes() const { return doubles() ? sizeof(double) : sizeof(std::int16_t); }

  template <class Number>
  Number next_number(const char* what) {
    char bytes[sizeof(Number)];
    if (bytes_->size() < sizeof bytes || at_ > bytes_->size() - sizeof bytes) {
      bytes_->fail_at(at_, fmt::format("the file ends before {}", what), outb_hint);
    }
    bytes_->read_all(at_, bytes, sizeof bytes);
    at_ += sizeof bytes;
    return number_of_bytes<Number>(bytes, std::endian::little);
  }

  void read_counts() {
    id_ = next_number<std::int16_t>("its id");
    if (id_ < 1 || id_ > 4) {
      bytes_->fail_at(0, fmt::format("the id is {}, it can be 1 to 4", id_), outb_hint);
    }
    if (id_ == 4) name_length_ = next_number<std::int16_t>("the length of the names");
    if (name_length_ < 1 || name_length_ > 1000) {
      bytes_->fail_at(2, fmt::format("names of {} characters", name_length_), outb_hint);
    }
    const std::uint64_t counts_at = at_;
    const auto channels = next_number<std::int32_t>("the number of channels");
    const auto rows = next_number<std::int32_t>("the number of instants");
    if (channels < 1 || static_cast<std::size_t>(channels) > most_channels) {
      bytes_->fail_at(
          counts_at,
          fmt::format("the number of channels is {}, it can be 1 to {}", channels, most_channels),
          outb_hint);
    }
    if (rows < 1) {
      bytes_->fail_at(counts_at + 4, fmt::format("the number of instants is {}", rows), outb_hint);
    }
    channels_ = static_cast<std::uint64_t>(channels);
    rows_ = static_cast<std::uint64_t>(rows);
    const std::uint64_t time_at = at_;
    time_first_ = next_number<double>("the time");
    time_second_ = next_number<double>("the time");
    const bool good = std::abs(time_first_) <= largest_table_number &&
                      std::abs(time_second_) <= largest_table_number && time_second_ > 0.0;
    const bool good_packed =
        std::isfinite(time_first_) && time_first_ > 0.0 && std::isfinite(time_second_);
    if (packed_time() ? !good_packed : !good) {
      bytes_->fail_at(time_at,
                      packed_time()
                          ? fmt::format("the time has the scale {:g} and the offset {:g}",
                                        time_first_, time_second_)
                          : fmt::format("the time begins at {:g} s and has steps of {:g} s",
                                        time_first_, time_second_),
                      outb_hint);
    }
    if (!packed_time()) head_.time_step = time_second_;
    head_.rows = rows_;
  }

  void want_bytes(std::uint64_t count, const char* what) const {
    if (count > bytes_->size() - at_) {
      bytes_->fail_at(at_, fmt::format("the file ends before {}", what), outb_hint);
    }
  }

  void read_scales() {
    if (doubles()) return;
    scales_at_ = at_;
    want_bytes(8 * channels_, "the scales of the channels");
    std::vector<char> raw(static_cast<std::size_t>(8 * channels_));
    bytes_->read_all(at_, raw.data(), raw.size());
    at_ += raw.size();
    for (std::size_t i = 0; i < 2 * channels_; ++i) {
      const auto number = number_of_bytes<float>(&raw[4 * i], std::endian::little);
      (i < channels_ ? scale_ : offset_).push_back(static_cast<double>(number));
    }
  }

  void read_names() {
    const std::uint64_t length_at = at_;
    const auto description = next_number<std::int32_t>("its description");
    if (description < 0) {
      bytes_->fail_at(length_at, fmt::format("a description of {} characters", description),
                      outb_hint);
    }
    want_bytes(static_cast<std::uint64_t>(description), "the end of its description");
    at_ += static_cast<std::uint64_t>(description);
    const auto length = static_cast<std::size_t>(name_length_);
    const std::size_t count = static_cast<std::size_t>(channels_) + 1;
    want_bytes(2 * length * count, "the names and units of the channels");
    std::string raw(2 * length * count, ' ');
    bytes_->read_all(at_, raw.data(), raw.size());
    const auto word = [&](std::size_t i) {
      const std::string text = raw.substr(i * length, length);
      return utf8_of(trimmed(std::string_view(text).substr(0, text.find('\0'))));
    };
    const std::string time_unit(without_unit_brackets(word(count)));
    const auto unit = parse_file_unit(time_unit);
    const auto* quantity = std::get_if<ParsedQuantity>(&unit);
    if (quantity == nullptr || !is_of(quantity->exponents, wanted::time)) {
      bytes_->fail_at(at_ + length * count,
                      fmt::format("the unit of the time is \"{}\", no unit of a time", time_unit),
                      outb_hint);
    }
    time_factor_ = quantity->value;
    if (head_.time_step) *head_.time_step *= time_factor_;
    for (std::size_t i = 1; i < count; ++i) {
      const std::string text = word(count + i);
      head_.channels.push_back(
          {word(i), std::string(without_unit_brackets(text)), !doubles() && fits_float(i - 1)});
    }
    at_ += raw.size();
  }

  /// A float has 24 bits. Far from zero, as seen from the width of an integer's step, it would blur
  /// the steps, on whose differences fatigue rests.
  bool fits_float(std::size_t channel) const {
    constexpr double farthest = 1048576.0;  // 2^20 steps
    return std::abs(offset_[channel]) + 32768.0 <= farthest;
  }

  void look_at_size() {
    times_at_ = at_;
    rows_at_ = at_ + (packed_time() ? 4 * rows_ : 0);
    // Both counts are below 2^31: nothing overflows.
    const std::uint64_t end = rows_at_ + rows_ * channels_ * value_bytes();
    if (end == bytes_->size()) return;
    bytes_->fail_at(std::min(end, bytes_->size()),
                    fmt::format("{} instants of {} channels want {} bytes, the file has {}", rows_,
                                channels_, end, bytes_->size()),
                    outb_hint);
  }

  void look_at_scales(const std::vector<std::size_t>& columns) const {
    if (doubles()) return;
    for (const std::size_t channel : columns) {
      const double scale = scale_[channel];
      if (std::isfinite(scale) && scale != 0.0 && std::isfinite(offset_[channel])) continue;
      bytes_->fail_at(scales_at_ + 4 * channel,
                      fmt::format("\"{}\" has the scale {:g} and the offset {:g}",
                                  head_.channels[channel].name, scale, offset_[channel]),
                      outb_hint);
    }
  }

  void fill_time(double* to, const char* packed, std::uint64_t row, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
      const double time =
          packed_time() ? (number_of_bytes<std::int32_t>(packed + 4 * i, std::endian::little) -
                           time_second_) /
                              time_first_
                        : time_first_ + static_cast<double>(row + i) * time_second_;
      to[i] = time * time_factor_;
    }
  }

  void fill_column(double* to, const char* raw, std::size_t channel, std::size_t count) const {
    const auto step = static_cast<std::size_t>(channels_ * value_bytes());
    const char* from = raw + channel * static_cast<std::size_t>(value_bytes());
    if (doubles()) {
      for (std::size_t i = 0; i < count; ++i, from += step) {
        to[i] = number_of_bytes<double>(from, std::endian::little);
      }
      return;
    }
    const double scale = scale_[channel];
    const double offset = offset_[channel];
    for (std::size_t i = 0; i < count; ++i, from += step) {
      to[i] = (number_of_bytes<std::int16_t>(from, std::endian::little) - offset) / scale;
    }
  }

  [[noreturn]] void fail(const RowTrouble& trouble, std::uint64_t first,
                         const std::vector<std::size_t>& columns) const {
    const std::uint64_t row = first + trouble.row;
    if (trouble.value == RowTrouble::time) {
      bytes_->fail_at(
          packed_time() ? times_at_ + 4 * row : rows_at_ + row * channels_ * value_bytes(),
          fmt::format("instant {}: {}", row + 1, trouble.message), trouble.hint);
    }
    const std::size_t channel = columns[trouble.value];
    bytes_->fail_at(rows_at_ + (row * channels_ + channel) * value_bytes(),
                    fmt::format("\"{}\" at instant {}: {}", head_.channels[channel].name, row + 1,
                                trouble.message),
                    trouble.hint);
  }

  SignalBytes bytes_;
  std::uint64_t at_ = 0;
  int id_ = 0;
  int name_length_ = 10;
  std::uint64_t channels_ = 0, rows_ = 0;
  double time_first_ = 0.0;   ///< its scale (id 1) or the first instant
  double time_second_ = 0.0;  ///< its offset (id 1) or the step
  double time_factor_ = 1.0;  ///< to s
  std::uint64_t scales_at_ = 0, times_at_ = 0, rows_at_ = 0;
  std::vector<double> scale_, offset_;
};

}  // namespace

OpenedSignals open_openfast_binary(SignalBytes bytes, const SignalSource& source) {
  return std::make_unique<OpenfastBinaryReader>(std::move(bytes), source);
}

}  // namespace boxbeam
