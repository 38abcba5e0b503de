#include "boxbeam/report/latex_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "boxbeam/report/formula.hpp"
#include "latex_preamble.hpp"
#include "latex_table.hpp"
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
  if (step.formulas.empty()) out += "\\noindent\\box4\\par\n";
  std::size_t noted = 0;
  for (std::size_t i = 0; i < step.formulas.size(); ++i) {
    const std::string formula = latex_of_formula(step.formulas[i]);
    if (i > 0) out += "\\nextformula";
    if (i + 1 == step.formulas.size() && !step.notes.empty()) {
      out += fmt::format("\\notedformula{{{}}}{{{}}}\n", formula, running(step.notes[noted++]));
    } else {
      out += fmt::format("\\formula{{{}}}\n", formula);
    }
  }
  for (; noted < step.notes.size(); ++noted)
    out += fmt::format("\\note{{{}}}\n", running(step.notes[noted]));
  return out;
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

/// The figure itself has been taken when its room was looked for.
std::string block(const Picture& picture) {
  return fmt::format("\\showfigure{{{}}}\n", running(picture.caption));
}

std::string block(const MovingPicture& /*on paper nothing moves*/) { return ""; }

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
  for (std::size_t i = 0; i < chapters.size(); ++i)
    out +=
        fmt::format("\\contentsentry{{{}}}{{{}}}\n", i + 1, latex_shortened(chapters[i].title, 44));
  return out + "}\n";
}

/// What stands on the first page: the verdict and what decides it first.
std::string title_page(const Document& document) {
  std::string out = fmt::format("{{\\raggedright\\sffamily\\bfseries\\huge\\hskip0pt {}\\par}}\n",
                                latex_breakable(document.title, 20));
  if (!document.subtitle.empty())
    out += fmt::format("{{\\raggedright\\large\\hskip0pt {}\\par}}\n", running(document.subtitle));
  out += fmt::format("\\verdict{{{}}}{{{}}}\n", colour_of(document.mark),
                     latex_shortened(document.verdict, 20));
  out += latex_table(document.governing);
  Facts all{{{"program", document.program},
             {"date", document.date},
             {"input sha256", document.input_sha256}}};
  all.entries.insert(all.entries.begin(), document.facts.entries.begin(),
                     document.facts.entries.end());
  out += facts(all);
  out +=
      "\\need{70pt}\\vskip14pt\\hbox to\\textwidth{\\signfield{prepared}\\hfil"
      "\\signfield{checked}\\hfil\\signfield{approved}}\n";
  return out + contents(document.chapters);
}

/// Height that a block needs on its page [pt], what a heading heads included; the figure among them
/// is appended to `figure`, its height is known by TeX only.
double height_needed(const std::vector<Block>& blocks, std::size_t i, std::string& figure) {
  if (i == blocks.size()) return 0;
  if (std::holds_alternative<Subheading>(blocks[i]))
    return 35 + height_needed(blocks, i + 1, figure);
  if (const auto* table = std::get_if<Table>(&blocks[i])) return latex_table_height(*table);
  if (std::holds_alternative<Sheet>(blocks[i])) return 130;
  if (const auto* picture = std::get_if<Picture>(&blocks[i])) {
    constexpr double line = 420;  // of its caption [pt]
    figure = picture->name;
    return 30 + 10 * std::ceil(latex_width(picture->caption) * 9 / line);
  }
  return 28;
}

std::string room_for(double height, const std::string& figure) {
  if (figure.empty()) return fmt::format("\\need{{{:.0f}pt}}\n", height);
  return fmt::format(
      "\\takefigure{{{0}.pdf}}{{{1:.0f}pt}}\\need{{\\dimexpr{1:.0f}pt+\\ht\\figurebox\\relax}}\n",
      figure, height);
}

/// What a chapter has for paper.
std::vector<Block> printed(const std::vector<Block>& blocks,
                           const std::function<bool(const std::string&)>& has_picture) {
  std::vector<Block> kept;
  for (const Block& each : blocks) {
    const auto* picture = std::get_if<Picture>(&each);
    const bool left_out = picture != nullptr ? !has_picture(picture->name)
                                             : std::holds_alternative<MovingPicture>(each);
    if (!left_out) kept.push_back(each);
  }
  return kept;
}

std::string latex_chapter(std::size_t number, const Chapter& chapter,
                          const std::function<bool(const std::string&)>& has_picture) {
  const std::vector<Block> blocks = printed(chapter.blocks, has_picture);
  std::string figure;
  const double height = 50 + height_needed(blocks, 0, figure);
  std::string out = room_for(height, figure);
  out += fmt::format("\\chapterline{{{}}}{{{}}}{{{}}}\n", number, running(chapter.title),
                     latex_pdf_string(chapter.title));
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    figure.clear();
    const double needed = height_needed(blocks, i, figure);
    out += room_for(needed, figure);
    out += std::visit([](const auto& each) { return block(each); }, blocks[i]);
  }
  return out;
}

std::string head_and_foot(const Document& document) {
  std::string out = fmt::format("\\def\\headleft{{{}}}\n", latex_shortened(document.title, 36));
  out += fmt::format("\\def\\headright{{input sha256 {}}}\n",
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
  out += "\\begin{document}\n\\pagestyle{report}\n" + title_page(document);
  if (!document.chapters.empty()) out += "\\newpage\n";
  for (std::size_t i = 0; i < document.chapters.size(); ++i)
    out += latex_chapter(i + 1, document.chapters[i], has_picture);
  return out + "\\end{document}\n";
}

}  // namespace boxbeam::report
