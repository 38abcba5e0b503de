#include "number_rows.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "../decimal_number.hpp"

namespace boxbeam {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

std::vector<Field> signal_fields(std::string_view line, char separator) {
  if (separator != ' ') return fields_of(line, separator);
  std::vector<Field> fields;
  for (std::size_t at = 0; at < line.size();) {
    if (is_blank(line[at])) {
      ++at;
      continue;
    }
    std::size_t to = at + 1;
    const bool quoted = line[at] == '"';
    if (quoted) {
      to = std::min(line.find('"', at + 1), line.size() - 1) + 1;
    } else {
      while (to < line.size() && !is_blank(line[to])) ++to;
    }
    std::string_view text = line.substr(at, to - at);
    if (quoted && text.size() >= 2 && text.ends_with('"')) text = text.substr(1, text.size() - 2);
    fields.push_back({text, static_cast<int>(at) + 1});
    at = to;
  }
  return fields;
}

bool begins_with_number(std::string_view line) {
  std::string_view text = trimmed(line);
  if (text.starts_with('"')) text.remove_prefix(1);
  const std::size_t end = text.find_first_of(",; \t\"");
  std::string_view word = text.substr(0, end);
  if (word.empty()) return !text.empty() && text.find_first_of("0123456789") == 1;  // ",5"
  if (word.front() == '+' || word.front() == '-') word.remove_prefix(1);
  double value = 0.0;
  const auto [to, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error != std::errc::invalid_argument && to == word.data() + word.size();
}

void read_numbers(const TextLines& lines, std::string_view part, std::size_t count, double* to,
                  const char* hint) {
  const char* at = part.data();
  const char* const end = at + part.size();
  const auto skip_blanks = [&] {
    while (at != end && is_blank(*at)) ++at;
  };
  skip_blanks();
  for (std::size_t i = 0; i < count && at != end; ++i) {
    const char* behind = parse_short_decimal(at, '.', to[i]);
    if (behind == nullptr) {
      const auto [from_chars_end, error] = std::from_chars(at, end, to[i]);
      behind = error == std::errc{} ? from_chars_end : nullptr;
    }
    const bool whole = behind != nullptr && (behind == end || is_blank(*behind));
    if (!whole) break;
    at = behind;
    skip_blanks();
    if (i + 1 == count && at == end) return;
  }
  const std::vector<Field> words = signal_fields(part, ' ');
  if (words.size() != count) {
    lines.fail_at(trimmed(part).empty() ? part : trimmed(part),
                  fmt::format("{} {} expected here, there {} {}", count,
                              count == 1 ? "number is" : "numbers are",
                              words.size() == 1 ? "is" : "are", words.size()),
                  hint);
  }
  TableForm form{' ', '.'};
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = number_in_table(words[i].text, form);
    if (const auto* trouble = std::get_if<FieldTrouble>(&number)) {
      lines.fail_at(words[i].text, utf8_of(trouble->message), trouble->hint);
    }
    to[i] = std::get<double>(number);
  }
}

NumberRows::NumberRows(const TextLines& lines, const TableForm& form, std::size_t width,
                       const std::vector<std::size_t>& wanted, const Time& time, RowBlock& block)
    : lines_(&lines),
      form_(form),
      width_(width),
      time_(time),
      block_(&block),
      slot_of_column_(width, none),
      column_of_wanted_(wanted),
      values_(wanted.size()) {
  const auto slot_of = [&](std::size_t column) {
    std::size_t& slot = slot_of_column_[column];
    if (slot == none) {
      slot = slots_.size();
      slots_.push_back(0.0);
    }
    return slot;
  };
  if (time_.column) slot_of(*time_.column);
  for (const std::size_t column : wanted) slot_of_wanted_.push_back(slot_of(column));
}

void NumberRows::take(std::string_view line) {
  if (!read_quickly(line)) read_unusual(line);
  const double time = time_.column ? slots_[slot_of_column_[*time_.column]] * time_.factor
                                   : static_cast<double>(rows_) * time_.step;
  for (std::size_t k = 0; k < values_.size(); ++k) values_[k] = slots_[slot_of_wanted_[k]];
  if (const auto trouble = block_->take(time, values_.data())) fail(line, *trouble);
  ++rows_;
}

/// Numbers and separators and nothing else, as nearly all rows are; false for another one. Behind
/// the line stands a character that belongs to no number.
bool NumberRows::read_quickly(std::string_view line) {
  const char* at = line.data();
  const char* const end = at + line.size();
  const bool between_blanks = form_.separator == ' ';
  const auto skip_blanks = [&] {
    while (at != end && is_blank(*at) && *at != form_.separator) ++at;
    if (between_blanks) {
      while (at != end && is_blank(*at)) ++at;
    }
  };
  skip_blanks();
  for (std::size_t column = 0; column < width_; ++column) {
    if (column > 0 && !between_blanks) {
      if (at == end || *at != form_.separator) return false;
      ++at;
      skip_blanks();
    }
    if (at == end) return false;
    const char* const from = at;
    if (const std::size_t slot = slot_of_column_[column]; slot != none) {
      at = parse_short_decimal(from, form_.decimal_sign, slots_[slot]);
      if (at == nullptr) {
        if (form_.decimal_sign != '.') return false;
        const auto [to, error] = std::from_chars(from, end, slots_[slot]);
        if (error != std::errc{}) return false;
        at = to;
      }
      if (at > end || !std::isfinite(slots_[slot])) return false;
    } else {
      while (at != end && !is_blank(*at) && *at != form_.separator && *at != '"') ++at;
      if (at != end && *at == '"') return false;
    }
    if (between_blanks && at == from) return false;
    const char* const behind = at;
    skip_blanks();
    if (between_blanks && at == behind && at != end) return false;
  }
  return at == end;
}

/// Quotation marks, long numbers with a decimal comma, or something that is wrong.
void NumberRows::read_unusual(std::string_view line) {
  const std::vector<Field> fields = signal_fields(line, form_.separator);
  if (fields.size() != width_) {
    lines_->fail_at(
        trimmed(line).empty() ? line : trimmed(line),
        fmt::format("the head names {} {}, here {} {}", width_, width_ == 1 ? "column" : "columns",
                    fields.size() == 1 ? "is" : "are", fields.size()),
        fmt::format(
            "write a number for each column, {} between them{}", form_.separators(),
            form_.separator == ',' ? "; a decimal comma wants semicolons, tabs or blanks" : ""));
  }
  for (std::size_t column = 0; column < width_; ++column) {
    const std::size_t slot = slot_of_column_[column];
    if (slot == none) continue;
    const auto number = number_in_table(fields[column].text, form_);
    if (const auto* trouble = std::get_if<FieldTrouble>(&number)) {
      lines_->fail_at(fields[column].text, utf8_of(trouble->message), trouble->hint);
    }
    slots_[slot] = std::get<double>(number);
  }
}

void NumberRows::fail(std::string_view line, const RowTrouble& trouble) const {
  const std::size_t column = trouble.value == RowTrouble::time ? time_.column.value_or(0)
                                                               : column_of_wanted_[trouble.value];
  const std::vector<Field> fields = signal_fields(line, form_.separator);
  lines_->fail_at(column < fields.size() ? fields[column].text : line, trouble.message,
                  trouble.hint);
}

}  // namespace boxbeam
