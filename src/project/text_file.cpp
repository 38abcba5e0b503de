#include "text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

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

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(std::move(line));
  }
  return lines;
}

std::size_t utf8_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[at + i]))
                                : 0U;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4) return 0;
  unsigned code = first & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  constexpr unsigned smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  if (code < smallest[length] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return 0;
  return length;
}

std::size_t find_not_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) return i;
    i += length;
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
    i += std::max<std::size_t>(1, utf8_length(text, i));
  }
  return position;
}

}  // namespace boxbeam
