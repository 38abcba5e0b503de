#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "file_bytes.hpp"
#include "signal_reader.hpp"

namespace boxbeam {

/// UTF-8 of a text that is UTF-8 or, where it is not, Latin-1.
std::string utf8_of(std::string_view text);

/// The lines of a text file of any length, one after the other: UTF-8, Latin-1 or UTF-16, which
/// ends its lines with LF, CR LF or CR alone (the way of the first line).
class TextLines {
 public:
  explicit TextLines(SignalBytes bytes);

  /// Goes to the next line, the first one at first; false behind the last one.
  bool next();
  /// Without its end; behind it stands a character that belongs to no number. Bytes of Latin-1 stay
  /// as they are.
  std::string_view line() const { return line_; }
  /// From 1; that of the last line behind it.
  std::int64_t number() const { return number_; }
  const FileBytes& bytes() const { return *bytes_; }

  /// At a column of the line, from 1.
  [[noreturn]] void fail(int column, std::string message, std::string hint) const;
  /// At the column in which a part of the line begins.
  [[noreturn]] void fail_at(std::string_view part, std::string message, std::string hint) const;

 private:
  enum class Encoding { bytes, utf16_little, utf16_big };

  void look_for_encoding();
  /// Reads on behind what is there; false at the end of the file.
  bool read_on();
  std::size_t read_utf16(std::size_t room);
  void unify_line_ends(std::size_t from);

  SignalBytes bytes_;
  Encoding encoding_ = Encoding::bytes;
  std::uint64_t at_ = 0;  ///< of the file
  std::vector<char> text_, raw_;
  std::size_t begin_ = 0, end_ = 0;   ///< of what is not yet given
  std::optional<bool> only_returns_;  ///< unknown until a line has ended
  std::string_view line_;
  std::int64_t number_ = 0;
};

}  // namespace boxbeam
