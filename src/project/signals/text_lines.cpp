#include "text_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <utility>

#include "../text_file.hpp"
#include "boxbeam/core/error.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20U;
constexpr std::size_t text_block = std::size_t{1} << 20U;

void append_utf8(char*& to, char32_t code) {
  const auto put = [&](char32_t byte) { *to++ = static_cast<char>(byte); };
  if (code < 0x80U) {
    put(code);
  } else if (code < 0x800U) {
    put(0xC0U | code >> 6U);
    put(0x80U | (code & 0x3FU));
  } else if (code < 0x10000U) {
    put(0xE0U | code >> 12U);
    put(0x80U | (code >> 6U & 0x3FU));
    put(0x80U | (code & 0x3FU));
  } else {
    put(0xF0U | code >> 18U);
    put(0x80U | (code >> 12U & 0x3FU));
    put(0x80U | (code >> 6U & 0x3FU));
    put(0x80U | (code & 0x3FU));
  }
}

}  // namespace

std::string utf8_of(std::string_view text) {
  if (find_not_utf8(text) == std::string_view::npos) return std::string(text);
  std::string converted(2 * text.size(), '\0');
  char* to = converted.data();
  for (const char c : text) append_utf8(to, static_cast<unsigned char>(c));
  converted.resize(static_cast<std::size_t>(to - converted.data()));
  return converted;
}

TextLines::TextLines(SignalBytes bytes) : bytes_(std::move(bytes)) {
  // Of a small file no more than it needs; one more for the end of the last line.
  const std::uint64_t all = 2 * bytes_->size() + 16;
  text_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(all, longest_line + text_block)));
  look_for_encoding();
}

void TextLines::look_for_encoding() {
  char first[4] = {1, 1, 1, 1};
  const std::size_t got = bytes_->read_some(0, first, sizeof first);
  const std::string_view mark(first, got);
  if (mark.starts_with("\xEF\xBB\xBF")) {
    at_ = 3;
  } else if (mark.starts_with("\xFF\xFE") || mark.starts_with("\xFE\xFF")) {
    encoding_ = mark[0] == '\xFF' ? Encoding::utf16_little : Encoding::utf16_big;
    at_ = 2;
  } else if (first[1] == '\0' && first[3] == '\0' && first[0] != '\0') {
    encoding_ = Encoding::utf16_little;
  } else if (first[0] == '\0' && first[2] == '\0' && first[1] != '\0') {
    encoding_ = Encoding::utf16_big;
  }
}

bool TextLines::next() {
  std::size_t searched = begin_;
  while (true) {
    const void* const found = std::memchr(text_.data() + searched, '\n', end_ - searched);
    if (found != nullptr) {
      const auto end = static_cast<std::size_t>(static_cast<const char*>(found) - text_.data());
      line_ = {text_.data() + begin_, end - begin_};
      if (line_.ends_with('\r')) line_.remove_suffix(1);
      begin_ = end + 1;
      ++number_;
      return true;
    }
    if (end_ - begin_ > longest_line) {
      ++number_;
      line_ = {};
      fail(1, "a line is over 1 MB", "give a table of numbers, a line for each instant");
    }
    searched = end_ - begin_;
    std::memmove(text_.data(), text_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    if (read_on()) {
      // Where CR ends lines, it may have become LF in what had been searched.
      if (searched > 0) --searched;
      continue;
    }
    if (end_ == 0) return false;
    text_[end_++] = '\n';
  }
}

bool TextLines::read_on() {
  const std::size_t room = text_.size() - end_ - 1;
  std::size_t got = 0;
  if (encoding_ == Encoding::bytes) {
    got = bytes_->read_some(at_, text_.data() + end_, room);
    at_ += got;
  } else {
    got = read_utf16(room);
  }
  const std::size_t from = end_;
  end_ += got;
  if (got > 0) unify_line_ends(from);
  return got > 0;
}

std::size_t TextLines::read_utf16(std::size_t room) {
  // Two bytes become three at most.
  raw_.resize(std::max<std::size_t>(room / 3 * 2, 4));
  const std::size_t got = bytes_->read_some(at_, raw_.data(), std::min(raw_.size(), room / 3 * 2));
  const bool last = at_ + got >= bytes_->size();
  const auto unit_at = [&](std::size_t i) {
    const auto a = static_cast<unsigned char>(raw_[i]);
    const auto b = static_cast<unsigned char>(i + 1 < got ? raw_[i + 1] : '\0');
    return static_cast<char32_t>(encoding_ == Encoding::utf16_little ? a | b << 8U : b | a << 8U);
  };
  constexpr char32_t replacement = 0xFFFD;
  char* to = text_.data() + end_;
  std::size_t i = 0;
  while (i < got) {
    const char32_t unit = unit_at(i);
    const bool high = unit >= 0xD800 && unit < 0xDC00;
    if (high && i + 3 >= got && !last) break;  // its other half comes with the next block
    const char32_t low = high && i + 3 < got ? unit_at(i + 2) : 0;
    if (low >= 0xDC00 && low < 0xE000) {
      append_utf8(to, 0x10000 + ((unit - 0xD800) << 10U) + (low - 0xDC00));
      i += 4;
      continue;
    }
    append_utf8(to, unit >= 0xD800 && unit < 0xE000 ? replacement : unit);
    i += 2;
  }
  at_ += std::min(i, got);
  return static_cast<std::size_t>(to - text_.data()) - end_;
}

void TextLines::unify_line_ends(std::size_t from) {
  char* const begin = text_.data();
  char* const end = begin + end_;
  if (!only_returns_) {
    const char* const first =
        std::find_if(begin + begin_, end, [](char c) { return c == '\r' || c == '\n'; });
    if (first == end) return;
    // A CR at the very end may still be followed by its LF.
    const bool at_end = first + 1 == end;
    if (*first == '\r' && at_end && at_ < bytes_->size()) return;
    only_returns_ = *first == '\r' && (at_end || first[1] != '\n');
    from = begin_;
  }
  if (*only_returns_) std::replace(begin + from, end, '\r', '\n');
}

void TextLines::fail(int column, std::string message, std::string hint) const {
  const auto number =
      static_cast<int>(std::min<std::int64_t>(number_, std::numeric_limits<int>::max()));
  // Of a line that is no table only its beginning is shown.
  constexpr std::size_t shown = 1000;
  throw InputError({{bytes_->path(), number, column, utf8_of(line_.substr(0, shown)),
                     std::move(message), std::move(hint)}});
}

void TextLines::fail_at(std::string_view part, std::string message, std::string hint) const {
  const bool inside = part.data() >= line_.data() && part.data() <= line_.data() + line_.size();
  const auto before = inside ? static_cast<std::size_t>(part.data() - line_.data()) : 0;
  const std::string text = utf8_of(line_.substr(0, before));
  fail(position_of(text, text.size()).column, std::move(message), std::move(hint));
}

}  // namespace boxbeam
