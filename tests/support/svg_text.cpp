#include "svg_text.hpp"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <regex>

#include "catch.hpp"

namespace test {
namespace {

/// Width of a text in ems: advance widths of DejaVu Sans from the font's own table, U+0020 to
/// U+007E, in 2048ths of an em; other characters as wide as an m.
double ems_of(const std::string& text) {
  static constexpr std::array<int, 95> widths{
      651,  821,  942,  1716, 1303, 1946, 1597, 563,  799,  799,  1024, 1716, 651,  739,
      651,  690,  1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 1303, 690,  690,
      1716, 1716, 1716, 1087, 2048, 1401, 1405, 1430, 1577, 1294, 1178, 1587, 1540, 604,
      604,  1343, 1141, 1767, 1532, 1612, 1235, 1612, 1423, 1300, 1251, 1499, 1401, 2025,
      1403, 1251, 1403, 799,  690,  799,  1716, 1024, 1024, 1255, 1300, 1126, 1300, 1260,
      721,  1300, 1298, 569,  569,  1186, 569,  1995, 1298, 1253, 1300, 1300, 842,  1067,
      803,  1298, 1212, 1675, 1212, 1212, 1075, 1303, 690,  1303, 1716};
  double width = 0.0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && byte < 0xC0) continue;
    width += byte < 0x20 || byte > 0x7e ? 1995.0 : widths[byte - 0x20U];
  }
  return width / 2048.0;
}

std::string unescaped(std::string text) {
  const std::pair<const char*, const char*> entities[] = {{"&lt;", "<"},     {"&gt;", ">"},
                                                          {"&quot;", "\""},  {"&#39;", "'"},
                                                          {"\xC2\xA0", " "}, {"&amp;", "&"}};
  for (const auto& [entity, character] : entities) {
    for (std::size_t at = text.find(entity); at != std::string::npos;
         at = text.find(entity, at + 1)) {
      text.replace(at, std::string(entity).size(), character);
    }
  }
  return text;
}

}  // namespace

std::vector<SvgText> texts_of(const std::string& svg) {
  static const std::regex element(
      "<text x=\"([0-9.-]+)\" y=\"([0-9.-]+)\"( text-anchor=\"(\\w+)\")? "
      "fill=\"[^\"]*\"(?: xml:space=\"preserve\")?>(.*?)</text>");
  static const std::regex span(
      "<tspan dy=\"[^\"]*\" font-size=\"([0-9.]+)\">([^<]*)</tspan>|[^<]+");
  constexpr double usual = 12.0;
  std::vector<SvgText> texts;
  for (std::sregex_iterator at(svg.begin(), svg.end(), element), end; at != end; ++at) {
    SvgText text;
    text.size = usual;
    double width = 0.0;
    const std::string inside = (*at)[5];
    for (std::sregex_iterator part(inside.begin(), inside.end(), span); part != end; ++part) {
      const bool smaller = (*part)[1].matched;
      const std::string piece = unescaped(smaller ? (*part)[2] : (*part)[0]);
      text.text += piece;
      width += (smaller ? std::stod((*part)[1]) : usual) * ems_of(piece);
    }
    if (text.text.find_first_not_of(' ') == std::string::npos) continue;
    const double x = std::stod((*at)[1]);
    const double y = std::stod((*at)[2]);
    const std::string anchor = (*at)[4];
    text.left = anchor.empty() ? x : (anchor == "end" ? x - width : x - 0.5 * width);
    text.right = text.left + width;
    text.top = y - 0.73 * text.size;  // as high as capitals
    text.bottom = y + 0.1 * text.size;
    texts.push_back(text);
  }
  // None is written in another way, as upright.
  static const std::regex any("<text");
  CHECK(std::distance(std::sregex_iterator(svg.begin(), svg.end(), any), {}) ==
        std::distance(std::sregex_iterator(svg.begin(), svg.end(), element), {}));
  CHECK(svg.find("rotate") == std::string::npos);
  return texts;
}

bool has(const std::vector<SvgText>& texts, const std::string& part) {
  return std::any_of(texts.begin(), texts.end(), [&](const SvgText& text) {
    return text.text.find(part) != std::string::npos;
  });
}

void check_legible(const std::string& svg) {
  std::smatch box;
  REQUIRE(std::regex_search(svg, box, std::regex("viewBox=\"0 0 ([0-9.]+) ([0-9.]+)\"")));
  const double width = std::stod(box[1]);
  const double height = std::stod(box[2]);
  const std::vector<SvgText> texts = texts_of(svg);
  REQUIRE(texts.size() > 2);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const SvgText& text = texts[i];
    CAPTURE(text.text);
    CHECK(text.left >= 0.0);
    CHECK(text.right <= width);
    CHECK(text.top >= 0.0);
    CHECK(text.bottom <= height);
    // On a page of A4 the figure is 6.5 inches wide, 468 pt.
    CHECK(text.size / width * 468.0 >= 9.0);
    for (std::size_t j = i + 1; j < texts.size(); ++j) {
      const SvgText& other = texts[j];
      const bool apart = text.right <= other.left || other.right <= text.left ||
                         text.bottom <= other.top || other.bottom <= text.top;
      CAPTURE(other.text);
      CHECK(apart);
    }
  }
}

std::string words_of_gnuplot(const std::filesystem::path& folder, const std::string& name) {
  const std::string command = "cd '" + folder.string() + "' && gnuplot plots/" + name + ".gp 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::string words;
  std::array<char, 256> part{};
  while (std::fgets(part.data(), static_cast<int>(part.size()), pipe) != nullptr)
    words += part.data();
  CHECK(pclose(pipe) == 0);
  return words;
}

}  // namespace test
