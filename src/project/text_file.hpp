#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Text files as the user writes them: their bytes, their lines, their encoding.
namespace boxbeam {

/// What a file holds, or why it cannot be read.
struct FileText {
  enum class Trouble { none, missing, folder, too_large, unreadable };

  std::string text;
  Trouble trouble = Trouble::none;
  std::string why;  ///< of the trouble: "there is no such file"
};

/// The trouble with a path that names no file at all; no trouble otherwise.
FileText look_for_file(const std::string& path);

/// The same where only a file will do: who opens a pipe may wait for ever for its writer.
FileText look_for_regular_file(const std::string& path);

/// Reads a file, a device or a pipe of at most 8 MB.
FileText read_text_file(const std::string& path);

/// The same where only a file will do.
FileText read_regular_file(const std::string& path);

/// Ends lines with LF where they end with CR alone.
void unify_line_ends(std::string& text);

/// The lines of a text without their ends: LF, CR LF, or CR alone in a text without LF.
std::vector<std::string> split_lines(std::string text);

/// The place of the first byte that is not UTF-8, or npos.
std::size_t find_not_utf8(std::string_view text);

/// Counted from 1; columns in characters.
struct LineColumn {
  int line = 1;
  int column = 1;
};

LineColumn position_of(std::string_view text, std::size_t at);

}  // namespace boxbeam
