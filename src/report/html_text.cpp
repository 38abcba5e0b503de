#include "html_text.hpp"

#include <fmt/format.h>
#include <sha256.h>

#include <algorithm>
#include <cstdint>

#include "../project/text_file.hpp"

namespace boxbeam::report::html {
namespace {

/// The code point of a UTF-8 sequence.
char32_t code_point(std::string_view sequence) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(sequence[i]); };
  if (sequence.size() == 1) return byte(0);
  char32_t code = byte(0) & (0x7fU >> sequence.size());
  for (std::size_t i = 1; i < sequence.size(); ++i) code = (code << 6U) | (byte(i) & 0x3fU);
  return code;
}

/// Controls, which XML does not allow either.
bool is_control(char32_t code) {
  if (code == '\n' || code == '\t') return false;
  return code < 0x20 || (code >= 0x7f && code <= 0x9f);
}

/// Marks of direction, what has no width, and what is no character. Joiners stay: some scripts are
/// written with them.
bool is_invisible(char32_t code) {
  return code == 0x200b || code == 0x200e || code == 0x200f || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2060 && code <= 0x206f) || code == 0x061c || code == 0xfeff ||
         (code & 0xfffeU) == 0xfffe;
}

}  // namespace

std::string visible(std::string_view text) {
  const auto plain = [](char c) { return (c >= ' ' && c <= '~') || c == '\n' || c == '\t'; };
  if (std::all_of(text.begin(), text.end(), plain)) return std::string(text);
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) {
      out += fmt::format("\\x{:02X}", static_cast<unsigned char>(text[i]));
      ++i;
      continue;
    }
    const std::string_view sequence = text.substr(i, length);
    const auto code = static_cast<std::uint32_t>(code_point(sequence));
    if (is_control(code)) {
      out += fmt::format("\\x{:02X}", code);
    } else if (is_invisible(code)) {
      out += fmt::format("\\u{:04X}", code);
    } else {
      out += sequence;
    }
    i += length;
  }
  return out;
}

std::string escaped(std::string_view text) {
  std::string out;
  const std::string shown = visible(text);
  out.reserve(shown.size());
  for (std::string_view rest = shown; !rest.empty();) {
    const std::size_t plain = std::min(rest.find_first_of("&<>\"'"), rest.size());
    out += rest.substr(0, plain);
    rest.remove_prefix(plain);
    if (rest.empty()) break;
    switch (rest.front()) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += "&#39;";
    }
    rest.remove_prefix(1);
  }
  return out;
}

std::string base64(std::string_view bytes) {
  static constexpr char digits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out((bytes.size() + 2) / 3 * 4, '=');
  std::size_t at = 0;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t rest = bytes.size() - i;
    const auto byte = [&](std::size_t k) -> std::uint32_t {
      return k < rest ? static_cast<unsigned char>(bytes[i + k]) : 0U;
    };
    const std::uint32_t group = (byte(0) << 16U) | (byte(1) << 8U) | byte(2);
    out[at] = digits[(group >> 18U) & 63U];
    out[at + 1] = digits[(group >> 12U) & 63U];
    if (rest > 1) out[at + 2] = digits[(group >> 6U) & 63U];
    if (rest > 2) out[at + 3] = digits[group & 63U];
    at += 4;
  }
  return out;
}

std::string policy_hash(std::string_view script) {
  SHA2_CTX context;
  uint8_t digest[SHA256_DIGEST_LENGTH];
  SHA256Init(&context);
  SHA256Update(&context, reinterpret_cast<const uint8_t*>(script.data()), script.size());
  SHA256Final(digest, &context);
  return "'sha256-" + base64({reinterpret_cast<const char*>(digest), sizeof digest}) + "'";
}

}  // namespace boxbeam::report::html
