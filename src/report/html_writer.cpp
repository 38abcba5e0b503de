#include "boxbeam/report/html_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "boxbeam/report/formula.hpp"
#include "html_figures.hpp"
#include "html_text.hpp"
#include "report_assets.hpp"
#include "table_columns.hpp"

namespace boxbeam::report {
namespace {

using html::escaped;

/// Its class in the style sheet.
const char* style_of(Mark mark) {
  switch (mark) {
    case Mark::passes: return "passes";
    case Mark::fails: return "fails";
    case Mark::not_applicable: return "unclear";
    case Mark::none: break;
  }
  return "";
}

std::string badge(Mark mark) {
  if (mark == Mark::none) return "";
  return fmt::format("<span class=\"badge {}\">{}</span>", style_of(mark), to_text(mark));
}

class Writer {
 public:
  Writer(const Document& document, const Pictures& pictures)
      : document_(document), pictures_(pictures) {
    for (const Chapter& chapter : document.chapters) {
      for (const Block& block : chapter.blocks) {
        const auto* sheet = std::get_if<Sheet>(&block);
        if (sheet != nullptr) sheets_.try_emplace(sheet->id, sheets_.size() + 1);
        const auto* moving = std::get_if<MovingPicture>(&block);
        moves_ = moves_ || moving != nullptr;
        in_space_ = in_space_ || (moving != nullptr && html::has_scene(*moving));
        explores_ = explores_ || std::holds_alternative<DesignTable>(block);
      }
    }
  }

  std::string page() {
    head();
    contents();
    out_ += "<main id=\"top\">\n";
    title();
    for (std::size_t i = 0; i < document_.chapters.size(); ++i) chapter(i);
    const std::string input =
        document_.input_sha256.empty() ? "" : " · input " + escaped(document_.input_sha256);
    out_ += fmt::format("</main>\n</div>\n<footer><p>{} · {}{}</p></footer>\n",
                        escaped(document_.title), escaped(document_.program), input);
    for (const std::string& script : scripts_) out_ += "<script>" + script + "</script>\n";
    out_ += "</body>\n</html>\n";
    return std::move(out_);
  }

 private:
  void head() {
    // What looks like markup to an XML reader is set apart in a way that HTML takes for a comment.
    const auto apart = [](const char* text) {
      return fmt::format("/*<![CDATA[*/\n{}/*]]>*/", text);
    };
    scripts_.push_back(apart(report_assets::script));
    if (in_space_) scripts_.push_back(apart(report_assets::scene_script));
    if (moves_) scripts_.push_back(apart(report_assets::cycle_script));
    if (explores_) scripts_.push_back(apart(report_assets::designs_script));
    std::string allowed;
    for (const std::string& script : scripts_) allowed += " " + html::policy_hash(script);
    out_ += fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
        "style-src 'unsafe-inline'; script-src{}; base-uri 'none'; form-action 'none'\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
        "<meta name=\"generator\" content=\"{}\"/>\n<link rel=\"icon\" href=\"data:,\"/>\n"
        "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n"
        "<a class=\"skip\" href=\"#top\">Skip to the {}</a>\n<div class=\"page\">\n",
        allowed, escaped(document_.program),
        escaped(is_judged() ? document_.title + ": " + document_.verdict : document_.title),
        apart(report_assets::style) + (explores_ ? apart(report_assets::designs_style) : ""),
        is_judged() ? "verdict" : "report");
  }

  void contents() {
    out_ += "<nav aria-label=\"Contents\">\n<h2>Contents</h2>\n<ol>\n";
    for (std::size_t i = 0; i < document_.chapters.size(); ++i) {
      out_ += fmt::format("<li><a href=\"#chapter-{}\">{}</a></li>\n", i + 1,
                          escaped(document_.chapters[i].title));
    }
    out_ += "</ol>\n</nav>\n";
  }

  void title() {
    out_ +=
        fmt::format("<header>\n<p class=\"program\">{} · {}</p>\n<h1>{}</h1>\n",
                    escaped(document_.program), escaped(document_.date), escaped(document_.title));
    if (!document_.subtitle.empty()) {
      out_ += fmt::format("<p class=\"subtitle\">{}</p>\n", escaped(document_.subtitle));
    }
    out_ += "</header>\n";
    if (is_judged()) verdict();
    opening();
    Facts block = document_.facts;
    if (!document_.input_sha256.empty())
      block.entries.emplace_back("input sha256", document_.input_sha256);
    block.entries.emplace_back("program", document_.program);
    block.entries.emplace_back("date", document_.date);
    write(block);
  }

  bool is_judged() const { return !document_.verdict.empty(); }

  void verdict() {
    const VerdictParts parts = parts_of_verdict(document_.verdict);
    out_ += fmt::format(
        "<section class=\"verdict {}\" aria-labelledby=\"verdict\">\n"
        "<h2 id=\"verdict\"><span>Verdict</span> <strong>{}</strong> <small>{}</small></h2>\n",
        style_of(document_.mark), escaped(parts.seen), escaped(parts.read));
    if (!document_.sentence.empty())
      out_ += fmt::format("<p class=\"sentence\">{}</p>\n", escaped(document_.sentence));
    if (!document_.reasons.empty()) write(Bullets{document_.reasons});
    if (!document_.governing.rows.empty()) write(document_.governing, true);
    out_ += "</section>\n";
  }

  void opening() {
    if (document_.opening.empty()) return;
    out_ += "<section class=\"opening\" aria-label=\"At a glance\">\n";
    for (const Block& block : document_.opening)
      std::visit([&](const auto& one) { write(one); }, block);
    out_ += "</section>\n";
  }

  void chapter(std::size_t i) {
    const Chapter& of = document_.chapters[i];
    heading_ = &of.title;
    out_ += fmt::format(
        "<section class=\"chapter\" id=\"chapter-{0}\" aria-labelledby=\"title-{0}\">\n"
        "<h2 id=\"title-{0}\"><span class=\"number\">{0}</span> {1}</h2>\n",
        i + 1, escaped(of.title));
    for (const Block& block : of.blocks) {
      std::visit([&](const auto& one) { write(one); }, block);
    }
    out_ += "</section>\n";
  }

  void write(const Paragraph& paragraph) {
    out_ += fmt::format("<p>{}</p>\n", escaped(paragraph.text));
  }

  void write(const Subheading& heading) {
    out_ += fmt::format("<h3>{}</h3>\n", escaped(heading.text));
  }

  void write(const Bullets& bullets) {
    out_ += "<ul>\n";
    for (const std::string& item : bullets.items) {
      out_ += fmt::format("<li>{}</li>\n", escaped(item));
    }
    out_ += "</ul>\n";
  }

  void write(const Facts& facts) {
    if (facts.entries.empty()) return;
    out_ += "<dl>\n";
    for (const auto& [name, text] : facts.entries) {
      out_ += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(name), escaped(text));
    }
    out_ += "</dl>\n";
  }

  /// `named`: every cell says of what it is, for where there is no room for a header.
  void write(const Table& table, bool named = false) {
    const std::string caption = escaped(table.caption);
    const std::string name = caption.empty() ? escaped(*heading_) : caption;
    if (table.folded) {
      out_ += fmt::format("<details>\n<summary>{} <span>{} rows</span></summary>\n", name,
                          table.rows.size());
    } else if (!caption.empty()) {
      out_ += fmt::format("<p class=\"caption\">{}</p>\n", caption);
    }
    out_ += fmt::format(
        "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{0}\">\n"
        "<table class=\"data\" aria-label=\"{0}\">\n<thead><tr>",
        name);
    const std::vector<const char*> sides = sides_of(table);
    if (!table.marks.empty()) out_ += "<th scope=\"col\">result</th>";
    for (std::size_t c = 0; c < table.header.size(); ++c) {
      out_ += fmt::format("<th scope=\"col\"{}>{}</th>", sides[c], escaped(table.header[c]));
    }
    out_ += "</tr></thead>\n<tbody>\n";
    for (std::size_t r = 0; r < table.rows.size(); ++r) row(table, r, sides, named);
    out_ += "</tbody>\n</table>\n</div>\n";
    if (table.folded) out_ += "</details>\n";
  }

  /// The class of every column.
  static std::vector<const char*> sides_of(const Table& table) {
    std::vector<const char*> sides;
    for (std::size_t c = 0; c < table.header.size(); ++c) {
      sides.push_back(holds_numbers(table, c) ? " class=\"right\"" : "");
    }
    return sides;
  }

  void row(const Table& table, std::size_t r, const std::vector<const char*>& sides, bool named) {
    out_ += "<tr>";
    if (!table.marks.empty()) out_ += fmt::format("<td>{}</td>", badge(table.marks[r]));
    const auto sheet = table.sheets.empty() ? sheets_.end() : sheets_.find(table.sheets[r]);
    for (std::size_t c = 0; c < table.rows[r].size(); ++c) {
      const Cell& cell = table.rows[r][c];
      const bool heads = c == 0;
      out_ += fmt::format("<{}{}", heads ? "th scope=\"row\"" : "td", sides[c]);
      if (cell.value && std::isfinite(*cell.value)) {
        out_ += fmt::format(" data-value=\"{}\"", *cell.value);
      }
      if (named) out_ += fmt::format(" data-label=\"{}\"", escaped(table.header[c]));
      const std::string text = escaped(cell.text);
      if (heads && sheet != sheets_.end()) {
        out_ += fmt::format("><a href=\"#sheet-{}\">{}</a>", sheet->second, text);
      } else {
        out_ += ">" + text;
      }
      out_ += heads ? "</th>" : "</td>";
    }
    out_ += "</tr>\n";
  }

  void write(const Picture& picture) {
    const std::optional<std::string> svg = pictures_(picture.name);
    if (!svg) return;
    ++figures_;
    const std::string caption = escaped(picture.caption);
    out_ +=
        fmt::format("<figure id=\"figure-{}\">\n<img alt=\"{}\" src=\"data:image/svg+xml;base64,",
                    figures_, caption);
    out_ += html::base64(*svg);  // too large to be formatted
    out_ += fmt::format("\"/>\n<figcaption><b>Figure {}.</b> {}</figcaption>\n</figure>\n",
                        figures_, caption);
  }

  void write(const MovingPicture& picture) {
    if (picture.cycles.empty()) return;
    out_ += html::cycle_figure(picture);
  }

  void write(const DesignTable& table) { out_ += html::designs_figure(table); }

  void write(const Sheet& sheet) {
    const std::size_t number = sheets_.at(sheet.id);
    out_ += fmt::format(
        "<section class=\"sheet {0}\" id=\"sheet-{1}\" aria-labelledby=\"sheet-title-{1}\">\n"
        "<h3 id=\"sheet-title-{1}\">{2} {3}</h3>\n<table class=\"steps\">\n<tbody>\n",
        style_of(sheet.mark), number, escaped(sheet.title), badge(sheet.mark));
    for (const Step& step : sheet.steps) write(step);
    out_ += "</tbody>\n</table>\n";
    utilisation(sheet);
    out_ += fmt::format("<p class=\"source\">{} <code>{}</code></p>\n</section>\n",
                        escaped(sheet.source), escaped(sheet.id));
  }

  void write(const Step& step) {
    out_ += fmt::format("<tr><th scope=\"row\"><math>{}</math></th><td class=\"chain\">",
                        mathml_of_formula(step.symbol));
    for (const std::string& formula : step.formulas) {
      out_ += "<span>";
      const char* equals = "<mo form=\"infix\">=</mo>";
      for (const std::string& piece : mathml_pieces_of_formula(formula)) {
        out_ += fmt::format("<math displaystyle=\"true\">{}<mrow>{}</mrow></math> ", equals, piece);
        equals = "";
      }
      out_ += "</span> ";
    }
    out_ += "</td><td class=\"notes\">";
    for (const std::string& note : step.notes) out_ += fmt::format("<p>{}</p>", escaped(note));
    out_ += "</td></tr>\n";
  }

  /// The result with a bar from 0 to 200 %, whose middle is the limit.
  void utilisation(const Sheet& sheet) {
    const double part = std::clamp(sheet.utilisation, 0.0, 2.0) / 2.0;
    out_ += fmt::format(
        "<div class=\"result\"><p>{}</p><div class=\"bar {}{}\" aria-hidden=\"true\">"
        "<span style=\"width:{:.2f}%\"></span></div></div>\n",
        escaped(sheet.result), style_of(sheet.mark), sheet.utilisation > 2.0 ? " beyond" : "",
        100.0 * part);
  }

  void write(const Listing& listing) {
    out_ += "<pre class=\"listing\" tabindex=\"0\">";
    std::string_view rest = listing.text;
    while (!rest.empty()) {
      const std::size_t end = rest.find('\n');
      std::string_view line = rest.substr(0, end);
      if (line.ends_with('\r')) line.remove_suffix(1);
      out_ += fmt::format("<span>{}\n</span>", escaped(line));
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    out_ += "</pre>\n";
  }

  const Document& document_;
  const Pictures& pictures_;
  std::map<std::string, std::size_t> sheets_;  ///< number by id
  std::vector<std::string> scripts_;
  std::string out_;
  const std::string* heading_ = &document_.title;  ///< above what is being written
  std::size_t figures_ = 0;
  bool moves_ = false, in_space_ = false, explores_ = false;
};

}  // namespace

std::string html_of(const Document& document, const Pictures& pictures) {
  return Writer(document, pictures).page();
}

}  // namespace boxbeam::report
