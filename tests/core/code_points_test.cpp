#include "boxbeam/core/code_points.hpp"

#include "catch.hpp"

namespace code_points_test {

using namespace boxbeam;

TEST_CASE("code points of UTF-8 of one to four bytes", "[code_points]") {
  // Source: RFC 3629, 7, examples.
  CHECK(code_points_of("A\xE2\x89\xA2\xCE\x91.") == U"A\u2262\u0391.");
  CHECK(code_points_of("\xF0\xA3\x8E\xB4") == U"\U000233B4");
  CHECK(code_points_of(std::string_view("\0", 1)) == std::u32string(1, U'\0'));
}

TEST_CASE("bytes that are no UTF-8 stand apart from every text", "[code_points]") {
  // Overlong forms, a surrogate, above U+10FFFF, a form that breaks off: RFC 3629, 3 and 10.
  for (const std::string bytes : {"\xC0\x80", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                                  "\xE2\x89", "\x80", "\xFF"}) {
    const std::u32string points = code_points_of(bytes);
    REQUIRE(points.size() == bytes.size());
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      CHECK(points[i] == 0xDC00U + static_cast<unsigned char>(bytes[i]));
      CHECK(is_stray_byte(points[i]));
      CHECK(is_hidden(points[i]));
    }
  }
}

TEST_CASE("what would not be seen is shown in one spelling", "[code_points]") {
  CHECK(visible("a\x1b[31m\x07\x7f\xc2\x9b") == "a\\x1B[31m\\x07\\x7F\\x9B");
  CHECK(visible("\xe2\x80\xae\xe2\x81\xa6\xef\xbb\xbf") == "\\u202E\\u2066\\uFEFF");
  CHECK(visible("\n\r\t") == "\\n\\r\\t");
  CHECK(visible("\n\r\t", "\n\t") == "\n\\r\t");
  CHECK(visible("\xff") == "\\xFF");
  CHECK(visible(std::string_view("\0", 1), "\n\t") == "\\x00");
  const std::string seen = "\xC3\x84 \xE4\xB8\xAD \xF0\x9F\x98\x80 \xE2\x80\x8D ~";
  CHECK(visible(seen) == seen);
  const std::string once = visible("\x1b\n");
  CHECK(visible(once) == once);
}

TEST_CASE("capitals of ASCII are made small, and nothing else", "[code_points]") {
  CHECK(small_letters("kN m, MPa 42") == "kn m, mpa 42");
  CHECK(small_letters("\xC3\x84") == "\xC3\x84");
  CHECK(small_letters("").empty());
}

}  // namespace code_points_test
