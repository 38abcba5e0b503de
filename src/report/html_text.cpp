#include "html_text.hpp"

#include <sha256.h>

#include <algorithm>
#include <cstdint>

#include "boxbeam/core/code_points.hpp"

namespace boxbeam::report::html {

std::string escaped(std::string_view text) {
  std::string out;
  const std::string shown = visible(text, "\n\t");
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

std::string harmless(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    switch (c) {
      case '<': out += "\\u003c"; break;
      case '>': out += "\\u003e"; break;
      case '&': out += "\\u0026"; break;
      default: out += c;
    }
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
