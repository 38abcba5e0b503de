#include "boxbeam/report/text_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "boxbeam/core/code_points.hpp"
#include "plain_text.hpp"
#include "text_table.hpp"

namespace boxbeam::report {
namespace {

using plain_text::columns_of;
using plain_text::wrapped;

/// Text in lines that begin with `first`, then with `rest`.
std::string hanging(const std::string& first, const std::string& rest, const std::string& text,
                    std::size_t width) {
  std::string out;
  for (const std::string& line :
       wrapped(text, width - columns_of(rest), width - columns_of(first))) {
    out += out.empty() ? first : rest;
    out += line;
    out += '\n';
  }
  return out;
}

std::string heading(const std::string& text, char line) {
  const std::string title = visible(text);
  return fmt::format("{}\n{}\n", title, std::string(columns_of(title), line));
}

std::string facts_text(const Facts& facts, std::size_t width) {
  std::size_t longest = 0;
  for (const auto& [name, text] : facts.entries) longest = std::max(longest, columns_of(name));
  const std::size_t beside = std::min<std::size_t>(longest, 30) + 4;
  std::string out;
  for (const auto& [name, text] : facts.entries) {
    std::string first = "  " + visible(name);
    first.resize(
        first.size() + std::max<std::size_t>(2, beside - std::min(beside, columns_of(first))), ' ');
    out += hanging(first, std::string(beside, ' '), text, width);
  }
  return out;
}

/// One line after the other, tabs and all, each behind two spaces.
std::string listing_text(const std::string& text) {
  std::string out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = visible(std::string_view(text).substr(begin, end - begin), "\n\t");
    out += line.empty() ? "\n" : "  " + line + "\n";
    begin = end + 1;
  }
  return out;
}

struct BlockText {
  std::size_t width;
  std::size_t* figures;  ///< that have come so far

  std::string operator()(const Paragraph& paragraph) const {
    return hanging("  ", "  ", paragraph.text, width);
  }
  std::string operator()(const Bullets& bullets) const {
    std::string out;
    for (const std::string& item : bullets.items) out += hanging("  - ", "    ", item, width);
    return out;
  }
  std::string operator()(const Facts& facts) const { return facts_text(facts, width); }
  std::string operator()(const Table& table) const {
    const std::string caption =
        table.caption.empty() ? "" : hanging("  ", "  ", table.caption, width);
    return caption + table_text(table, width).text;
  }
  std::string operator()(const Picture& picture) const {
    return hanging("  ", "  ",
                   fmt::format("Figure {} [{}.svg]: {}", ++*figures, picture.name, picture.caption),
                   width);
  }
  std::string operator()(const Sheet& sheet) const { return text_of(sheet, width).text; }
  std::string operator()(const Listing& listing) const { return listing_text(listing.text); }
  std::string operator()(const MovingPicture&) const { return ""; }
  std::string operator()(const DesignTable&) const { return ""; }
  std::string operator()(const Subheading& subheading) const {
    return "  " + visible(subheading.text) + "\n";
  }
};

}  // namespace

std::string text_of(const Document& document, std::size_t width) {
  std::string out = fmt::format("{}: {}, {}\n", visible(document.program), visible(document.title),
                                visible(document.date));
  out += hanging("", "", document.subtitle, width);
  out += "\n";
  if (!document.verdict.empty()) {
    out += hanging("VERDICT: ", "         ", document.verdict, width);
    for (const std::string& reason : document.reasons)
      out += hanging("  - ", "    ", reason, width);
    if (!document.sentence.empty()) out += "\n" + hanging("  ", "  ", document.sentence, width);
    out += "\n";
  }
  if (!document.verdict.empty() && !document.governing.rows.empty()) {
    out += table_text(with_results(document.governing), width).text + "\n";
  }
  std::size_t figures = 0;
  for (const Block& block : document.opening) {
    const std::string text = std::visit(BlockText{width, &figures}, block);
    if (!text.empty()) out += text + "\n";
  }
  Facts facts = document.facts;
  if (!document.input_sha256.empty())
    facts.entries.emplace_back("input sha256", document.input_sha256);
  out += facts_text(facts, width);
  std::size_t number = 0;
  for (const Chapter& chapter : document.chapters) {
    out += "\n" + heading(fmt::format("{} {}", ++number, chapter.title), '-');
    bool directly = true;  // below a heading
    for (const Block& block : chapter.blocks) {
      const std::string text = std::visit(BlockText{width, &figures}, block);
      if (text.empty()) continue;
      if (!directly) out += '\n';
      out += text;
      directly = std::holds_alternative<Subheading>(block);
    }
  }
  return out;
}

}  // namespace boxbeam::report
