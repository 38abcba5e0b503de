#include "text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "boxbeam/core/code_points.hpp"

namespace boxbeam {
namespace {

constexpr std::uintmax_t largest_file = 8u << 20;

}  // namespace

FileText look_for_file(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::exists(path, error)) return {{}, FileText::Trouble::missing, "there is no such file"};
  if (fs::is_directory(path, error)) return {{}, FileText::Trouble::folder, "this is a folder"};
  return {};
}

FileText read_text_file(const std::string& path) {
  namespace fs = std::filesystem;
  using Trouble = FileText::Trouble;
  FileText absent = look_for_file(path);
  if (absent.trouble != Trouble::none) return absent;
  FileText too_large{{}, Trouble::too_large, "the file is over 8 MB"};
  std::error_code error;
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) > largest_file) {
    return too_large;
  }
  std::ifstream stream(path, std::ios::binary);
  FileText file;
  // Read in pieces and stop early: the path may also be a device or a pipe.
  for (char buffer[65536]; stream.read(buffer, sizeof buffer) || stream.gcount() > 0;) {
    file.text.append(buffer, static_cast<std::size_t>(stream.gcount()));
    if (file.text.size() > largest_file) return too_large;
  }
  if (!stream.eof()) {
    return {
        {}, Trouble::unreadable, fmt::format("the file cannot be read: {}", std::strerror(errno))};
  }
  return file;
}

FileText look_for_regular_file(const std::string& path) {
  FileText absent = look_for_file(path);
  if (absent.trouble != FileText::Trouble::none) return absent;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    return {{}, FileText::Trouble::unreadable, "this is a pipe or a device, no file"};
  }
  return {};
}

FileText read_regular_file(const std::string& path) {
  FileText absent = look_for_regular_file(path);
  return absent.trouble == FileText::Trouble::none ? read_text_file(path) : absent;
}

void unify_line_ends(std::string& text) {
  if (text.find('\n') == std::string::npos) std::replace(text.begin(), text.end(), '\r', '\n');
}

std::vector<std::string> split_lines(std::string text) {
  unify_line_ends(text);
  std::vector<std::string> lines;
  std::istringstream stream(std::move(text));
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(std::move(line));
  }
  return lines;
}

std::size_t find_not_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const CodePoint point = code_point_at(text, i);
    if (is_stray_byte(point.code)) return i;
    i += point.length;
  }
  return std::string_view::npos;
}

LineColumn position_of(std::string_view text, std::size_t at) {
  LineColumn position;
  for (std::size_t i = 0; i < at;) {
    if (text[i] == '\n') {
      ++position.line;
      position.column = 1;
    } else {
      ++position.column;
    }
    i += code_point_at(text, i).length;
  }
  return position;
}

}  // namespace boxbeam
