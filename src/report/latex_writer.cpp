#include "boxbeam/report/latex_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "boxbeam/report/formula.hpp"
#include "latex_parts.hpp"
#include "latex_text.hpp"

namespace boxbeam::report {
namespace {

/// Words of running text break where they are wider than this [em].
constexpr double text_limit = 12;

std::string running(const std::string& text) { return latex_breakable(text, text_limit); }

const char* colour_of(Mark mark) {
  switch (mark) {
    case Mark::passes: return "passes";
    case Mark::fails: return "fails";
    case Mark::not_applicable: return "unknown";
    case Mark::none: break;
  }
  return "plain";
}

const char* word_of(Mark mark) {
  switch (mark) {
    case Mark::passes: return "PASS";
    case Mark::fails: return "FAIL";
    case Mark::not_applicable: return "NOT APPLICABLE";
    case Mark::none: break;
  }
  return "";
}

std::string facts(const Facts& facts) {
  constexpr double least = 70;       // [pt]
  constexpr double most = 130;       // [pt]
  constexpr double small_em = 9.26;  // [pt]
  double width = least;
  for (const auto& [name, text] : facts.entries)
    width = std::max(width, std::min(most, latex_width(name) * small_em + 2));
  std::string out = "\\par\\vskip4pt{\\small\n";
  for (const auto& [name, text] : facts.entries) {
    out += fmt::format("\\fact{{{:.0f}pt}}{{{}}}{{{}}}\n", width,
                       latex_breakable(name, width / small_em), running(text));
  }
  return out + "}\n";
}

std::string step(const Step& step) {
  std::string out = fmt::format("\\symbolof{{{}}}\n", latex_of_formula(step.symbol));
  if (step.formulas.empty()) out += "\\beguntrue\n";
  for (const std::string& formula : step.formulas)
    out += fmt::format("\\formula{{{}}}\n", latex_of_formula(formula));
  for (const std::string& note : step.notes) out += fmt::format("\\note{{{}}}\n", running(note));
  return out + "\\laststep\n";
}

/// Length of the bar of a utilisation [mm]; 34 are 100 %, and no bar is longer than 51.
double bar_length(double utilisation) {
  return std::isfinite(utilisation) ? std::clamp(34 * utilisation, 0.0, 51.0) : 51.0;
}

std::string block(const Paragraph& paragraph) { return running(paragraph.text) + "\\par\n"; }

std::string block(const Subheading& heading) {
  return fmt::format("\\subsection{{{}}}\n", running(heading.text));
}

std::string block(const Table& table) { return latex_table(table); }

std::string block(const Facts& entries) { return facts(entries); }

/// Height of what comes with a picture [pt].
double height_with(const Picture& picture) {
  constexpr double line = 420;  // of its caption [pt]
  return 30 + 10 * std::ceil(latex_width(picture.caption) * 9 / line);
}

std::string block(const Picture& picture) {
  return fmt::format("\\takefigure{{{}}}{{{:.0f}pt}}{{{}}}\n", picture.name, height_with(picture),
                     running(picture.caption));
}

std::string block(const MovingPicture& /*on paper nothing moves*/) { return ""; }

std::string block(const DesignTable& /*nor is chosen*/) { return ""; }

std::string block(const Bullets& bullets) {
  std::string out;
  for (const std::string& item : bullets.items)
    out += fmt::format("\\bulletitem{{{}}}\n", running(item));
  return out;
}

std::string block(const Sheet& sheet) {
  std::string out = fmt::format("\\begin{{sheet}}{{{}}}\n", colour_of(sheet.mark));
  out += fmt::format("\\sheethead{{{}}}{{{}}}{{{}}}\n", running(sheet.title), running(sheet.id),
                     word_of(sheet.mark));
  for (const Step& step : sheet.steps)
    out += fmt::format("\\widest{{{}}}\n", latex_of_formula(step.symbol));
  for (const Step& each : sheet.steps) out += step(each);
  out += fmt::format("\\result{{{}}}{{{:.2f}}}{{{}}}\n", running(sheet.result),
                     bar_length(sheet.utilisation), running(sheet.source));
  return out + "\\end{sheet}\n";
}

std::string block(const Listing& listing) {
  std::string out = "{\\ttfamily\\scriptsize\n";
  std::string_view rest = listing.text;
  for (int number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    std::string_view line = rest.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    out += fmt::format("\\listingline{{{}}}{{{}}}\n", number, latex_typewriter(std::string(line)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return out + "}\n";
}

std::string contents(const std::vector<Chapter>& chapters) {
  std::string out = "\\need{100pt}\\vskip14pt{\\sffamily\\bfseries Contents\\par}{\\small\n";
  const auto entry = [&](std::size_t i) {
    if (i >= chapters.size()) return std::string();
    return fmt::format("\\contentsentry{{{}}}{{{}}}", i + 1,
                       latex_shortened(chapters[i].title, 18));
  };
  const std::size_t half = (chapters.size() + 1) / 2;
  for (std::size_t i = 0; i < half; ++i)
    out += fmt::format("\\hbox to\\linewidth{{{}\\hfil {}}}\n", entry(i), entry(half + i));
  return out + "}\n";
}

bool is_judged(const Document& document) { return !document.verdict.empty(); }

/// Of few chapters behind a verdict: it goes without contents, and its figures stand two abreast.
bool is_short_one(const Document& document) {
  return is_judged(document) && document.chapters.size() <= 5;
}

/// A verdict is signed for.
std::string sign_fields(const Document& document, bool is_short) {
  const auto field = [](const char* done, const std::string& by) {
    return fmt::format("\\signfield{{{}}}", by.empty() ? done : done + (": " + running(by)));
  };
  return fmt::format("\\need{{70pt}}\\vskip{}\\hbox to\\textwidth{{{}\\hfil{}\\hfil{}}}\n",
                     is_short ? "4pt" : "14pt", field("prepared", document.prepared_by),
                     field("checked", document.checked_by), field("approved", ""));
}

/// Two pictures beside each other, where the next two blocks are some; else "".
std::string pair_of_pictures(const std::vector<Block>& blocks, std::size_t i) {
  if (i + 1 >= blocks.size()) return "";
  const auto* left = std::get_if<Picture>(&blocks[i]);
  const auto* right = std::get_if<Picture>(&blocks[i + 1]);
  if (left == nullptr || right == nullptr) return "";
  return fmt::format("\\figurepair{{{}}}{{{}}}{{{}}}{{{}}}\n", left->name, running(left->caption),
                     right->name, running(right->caption));
}

using HasPicture = std::function<bool(const std::string& name)>;

/// What a chapter has for paper.
std::vector<Block> printed(const std::vector<Block>& blocks, const HasPicture& has_picture) {
  std::vector<Block> kept;
  for (const Block& each : blocks) {
    const auto* picture = std::get_if<Picture>(&each);
    const bool left_out = picture != nullptr ? !has_picture(picture->name)
                                             : std::holds_alternative<MovingPicture>(each) ||
                                                   std::holds_alternative<DesignTable>(each);
    if (!left_out) kept.push_back(each);
  }
  return kept;
}

/// What stands under the verdict, pictures abreast.
std::string opening(const Document& document, const HasPicture& has_picture) {
  const std::vector<Block> blocks = printed(document.opening, has_picture);
  std::string out;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (const std::string pair = pair_of_pictures(blocks, i); !pair.empty()) {
      out += pair;
      ++i;
    } else {
      out += std::visit([](const auto& each) { return block(each); }, blocks[i]);
    }
  }
  return out;
}

/// What stands on the first page: the verdict and what decides it first.
std::string title_page(const Document& document, const HasPicture& has_picture) {
  const bool is_short = is_short_one(document);
  std::string out = is_short ? "\\shorttrue\n" : "";
  out += fmt::format("{{\\raggedright\\sffamily\\bfseries\\huge\\hskip0pt {}\\par}}\n",
                     latex_breakable(document.title, 20));
  if (!document.subtitle.empty())
    out += fmt::format("{{\\raggedright\\large\\hskip0pt {}\\par}}\n", running(document.subtitle));
  if (is_judged(document)) {
    const VerdictParts parts = parts_of_verdict(document.verdict);
    std::string text = latex_breakable(parts.seen, 20);
    if (!parts.read.empty())
      text += "\\par\\vskip3pt{\\small\\mdseries\\noindent\\hskip0pt " +
              latex_breakable(parts.read, 20) + "\\par}";
    out += fmt::format("\\verdict{{{}}}{{{}}}\n", colour_of(document.mark), text);
    if (!document.sentence.empty())
      out += fmt::format("{{\\raggedright {}\\par}}\n", running(document.sentence));
    for (const std::string& reason : document.reasons) {
      out += fmt::format("\\bulletitem{{{}}}\n", running(reason));
    }
    out += latex_table(document.governing);
  }
  out += opening(document, has_picture);
  Facts all{{{"program", document.program}, {"date", document.date}}};
  if (!document.input_sha256.empty())
    all.entries.emplace_back("input sha256", document.input_sha256);
  all.entries.insert(all.entries.begin(), document.facts.entries.begin(),
                     document.facts.entries.end());
  out += facts(all);
  if (is_judged(document)) out += sign_fields(document, is_short);
  return is_short ? out : out + contents(document.chapters);
}

constexpr double no_page = 9999;  ///< higher than any [pt]

/// Height of words that may go over lines of this width, about [pt].
double height_of_words(const std::string& text, double width) {
  constexpr double em = 10;
  constexpr double line = 12;
  return line * std::ceil(1.02 * latex_width(text) * em / width);
}

/// Height of all of a block, about and rather too much [pt], a heading with what it heads;
/// `no_page` for what a picture cannot wait behind.
double height_of_all(const std::vector<Block>& blocks, std::size_t i) {
  if (i == blocks.size()) return 0;
  if (std::holds_alternative<Subheading>(blocks[i])) return 35 + height_of_all(blocks, i + 1);
  if (const auto* table = std::get_if<Table>(&blocks[i])) return latex_table_height(*table).all;
  if (const auto* paragraph = std::get_if<Paragraph>(&blocks[i]))
    return 6 + height_of_words(paragraph->text, 460);
  double height = 6;
  if (const auto* bullets = std::get_if<Bullets>(&blocks[i])) {
    for (const std::string& item : bullets->items) height += 5 + height_of_words(item, 450);
    return height;
  }
  if (const auto* entries = std::get_if<Facts>(&blocks[i])) {
    for (const auto& [name, text] : entries->entries) {
      height += 3 + std::max({12.0, height_of_words(name, 70), height_of_words(text, 330)});
    }
    return height;
  }
  return no_page;
}

/// Height that a block needs on its page [pt], what a heading heads included; the picture among
/// them is told, its height is known by TeX only.
struct Needed {
  double height = 0;
  const Picture* picture = nullptr;
  double instead = no_page;  ///< with what follows the picture, while that waits
};

Needed needed_by(const std::vector<Block>& blocks, std::size_t i, double heading) {
  if (i == blocks.size()) return {heading};
  if (std::holds_alternative<Subheading>(blocks[i])) return needed_by(blocks, i + 1, heading + 35);
  if (const auto* table = std::get_if<Table>(&blocks[i]))
    return {heading + latex_table_height(*table).together};
  if (std::holds_alternative<Sheet>(blocks[i])) return {heading + 130};
  if (const auto* picture = std::get_if<Picture>(&blocks[i])) {
    const double behind = i + 1 < blocks.size() ? height_of_all(blocks, i + 1) : no_page;
    return {heading + height_with(*picture), picture, std::min(no_page, heading + behind)};
  }
  return {heading + 28};
}

std::string room_for(const Needed& needed) {
  if (needed.picture == nullptr) return fmt::format("\\need{{{:.0f}pt}}\n", needed.height);
  return fmt::format("\\needfigure{{{}}}{{{:.0f}pt}}{{{:.0f}pt}}\n", needed.picture->name,
                     needed.height, needed.instead);
}

std::string latex_chapter(std::size_t number, const Chapter& chapter, bool abreast,
                          const HasPicture& has_picture) {
  constexpr double heading = 46;
  constexpr double pair_height = 270;
  const std::vector<Block> blocks = printed(chapter.blocks, has_picture);
  const bool begins_with_pair = abreast && !pair_of_pictures(blocks, 0).empty();
  std::string out =
      room_for(begins_with_pair ? Needed{heading + pair_height} : needed_by(blocks, 0, heading));
  out += fmt::format("\\chapterline{{{}}}{{{}}}{{{}}}\n", number, running(chapter.title),
                     latex_pdf_string(chapter.title));
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    out += fmt::format("\\beforeblock{{{:.0f}pt}}\n", height_of_all(blocks, i));
    if (const std::string pair = abreast ? pair_of_pictures(blocks, i) : ""; !pair.empty()) {
      out += pair;
      ++i;
      continue;
    }
    out += room_for(needed_by(blocks, i, 0));
    out += std::visit([](const auto& each) { return block(each); }, blocks[i]);
  }
  return out + fmt::format("\\beforeblock{{{:.0f}pt}}\n", no_page);
}

std::string head_and_foot(const Document& document) {
  std::string out = fmt::format("\\def\\headleft{{{}}}\n", latex_shortened(document.title, 36));
  out += document.input_sha256.empty()
             ? "\\def\\headright{}\n"
             : fmt::format("\\def\\headright{{input sha256 {}}}\n",
                           latex_escaped(document.input_sha256.substr(0, 12)));
  out += fmt::format("\\def\\footleft{{{}}}\n", latex_shortened(document.program, 36));
  out += fmt::format("\\pdfinfo{{/Title ({}) /Subject ({}) /Creator ({})}}\n",
                     latex_pdf_string(document.title), latex_pdf_string(document.subtitle),
                     latex_pdf_string(document.program));
  return out + "\\pdfcatalog{/PageMode /UseOutlines /Lang (en)}\n";
}

}  // namespace

std::string latex_of(const Document& document,
                     const std::function<bool(const std::string& name)>& has_picture) {
  std::string out = latex_preamble;
  out += head_and_foot(document);
  out += "\\begin{document}\n\\pagestyle{report}\n" + title_page(document, has_picture);
  for (std::size_t i = 0; i < document.chapters.size(); ++i)
    out += latex_chapter(i + 1, document.chapters[i], is_short_one(document), has_picture);
  return out + "\\end{document}\n";
}

}  // namespace boxbeam::report
