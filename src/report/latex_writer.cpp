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
  std::string out = "{\\small\n";
  for (const auto& [name, text] : facts.entries) {
    out += fmt::format("\\fact{{{:.0f}pt}}{{{}}}{{{}}}\n", width,
                       latex_breakable(name, width / small_em), running(text));
  }
  return out + "}\n";
}

std::string step(const Step& step) {
  std::string out = fmt::format("\\symbolof{{{}}}\n", latex_of_formula(step.symbol));
  for (std::size_t i = 0; i < step.formulas.size(); ++i) {
    if (i > 0) out += "\\nextformula";
    out += fmt::format("\\formula{{{}}}\n", latex_of_formula(step.formulas[i]));
  }
  if (step.formulas.empty()) out += "\\noindent\\box4\\par\n";
  for (const std::string& note : step.notes) out += fmt::format("\\note{{{}}}\n", running(note));
  return out;
}

/// Length of the bar of a utilisation; 40 mm are 100 %, and no bar is longer than 60 mm.
double bar_length(double utilisation) {
  return std::isfinite(utilisation) ? std::clamp(40 * utilisation, 0.0, 60.0) : 60.0;
}

std::string block(const Paragraph& paragraph) { return running(paragraph.text) + "\\par\n"; }

std::string block(const Subheading& heading) {
  return fmt::format("\\need{{60pt}}\\subsection{{{}}}\n", running(heading.text));
}

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
  const auto written = [&](const Block& any) {
    if (const auto* table = std::get_if<Table>(&any)) return latex_table(*table);
    if (const auto* entries = std::get_if<Facts>(&any)) return facts(*entries);
    if (const auto* picture = std::get_if<Picture>(&any)) {
      if (!has_picture(picture->name)) return std::string();
      return fmt::format("\\shownfigure{{{}.pdf}}{{{}}}\n", picture->name,
                         running(picture->caption));
    }
    return std::visit(
        [](const auto& each) {
          if constexpr (requires { block(each); }) return block(each);
          return std::string();
        },
        any);
  };
  std::string out = latex_preamble;
  out += head_and_foot(document);
  out += "\\begin{document}\n\\pagestyle{report}\n" + title_page(document);
  if (!document.chapters.empty()) out += "\\newpage\n";
  for (std::size_t i = 0; i < document.chapters.size(); ++i) {
    const Chapter& chapter = document.chapters[i];
    out += fmt::format("\\chapterline{{{}}}{{{}}}{{{}}}\n", i + 1, running(chapter.title),
                       latex_pdf_string(chapter.title));
    for (const Block& any : chapter.blocks) out += written(any);
  }
  return out + "\\end{document}\n";
}

}  // namespace boxbeam::report
