#include <fmt/format.h>

#include <limits>

#include "boxbeam/core/code_points.hpp"
#include "boxbeam/report/text_writer.hpp"
#include "plain_text.hpp"

namespace boxbeam::report {
namespace {

/// Where a text that is too wide goes on below: a formula before a plus, minus or times outside of
/// its brackets, a note between words.
std::size_t break_of(const std::string& text, std::size_t room, bool formula, int deepest) {
  std::size_t at = std::string::npos;
  int depth = 0;
  for (std::size_t i = 0; i + 2 < text.size(); ++i) {
    if (text[i] == '(' || text[i] == '[') ++depth;
    if (text[i] == ')' || text[i] == ']') --depth;
    if (text[i] != ' ') continue;
    const char next = text[i + 1];
    const bool sign = (next == '+' || next == '-') && text[i + 2] == ' ' && depth <= deepest;
    if (formula && !sign) continue;
    if (i > room && at != std::string::npos) break;
    if (i > 0) at = i;
    if (i > room) break;
  }
  return at;
}

/// Lines of a step as they grow.
class StepLines {
 public:
  StepLines(const std::string& symbol, std::size_t widest)
      : widest_(widest), line_(fmt::format("    {:<11} ", symbol)), margin_(line_.size(), ' ') {}

  void add(const std::string& formula) {
    const bool fits = line_.size() + formula.size() + 3 <= widest_;
    if (!first_ && !fits) next();
    const bool beside = !first_ && fits;
    write((beside ? " = " : "= "), formula, true);
    first_ = false;
  }

  void note(const std::string& note, bool may_be_beside) {
    if (may_be_beside && line_.size() + note.size() + 5 <= widest_) {
      line_ += "   (" + note + ")";
      return;
    }
    next();
    write("  ", "(" + note + ")", false);
  }

  std::string text() const { return out_ + line_ + "\n"; }

 private:
  void next() {
    out_ += line_ + "\n";
    line_ = margin_;
  }

  void write(const std::string& before, std::string text, bool formula) {
    line_ += before;
    while (line_.size() + text.size() > widest_) {
      const std::size_t room = widest_ - line_.size();
      std::size_t at = break_of(text, room, formula, 0);
      // What stands wholly in brackets is broken inside of them.
      if (at == std::string::npos) {
        at = break_of(text, room, formula, std::numeric_limits<int>::max());
      }
      if (at == std::string::npos) break;
      line_ += text.substr(0, at);
      text.erase(0, at + 1);
      next();
      line_ += "   ";
    }
    line_ += text;
  }

  std::size_t widest_;
  std::string line_, margin_, out_;
  bool first_ = true;
};

std::string text_of(const Step& step, std::size_t widest) {
  StepLines lines(visible(step.symbol), widest);
  for (const std::string& formula : step.formulas) lines.add(visible(formula));
  for (const std::string& note : step.notes) {
    lines.note(visible(note), &note == &step.notes.front());
  }
  return lines.text();
}

}  // namespace

MarkedText text_of(const Sheet& sheet, std::size_t width) {
  constexpr std::size_t margin = 6;
  const std::size_t widest = width - margin;
  MarkedText marked(fmt::format("  {}\n", visible(sheet.id)));
  std::string& out = marked.text;
  const auto add = [&](const std::string& text) {
    std::string before = "    ";
    for (const std::string& line :
         plain_text::wrapped(text, widest - before.size() - 2, widest - before.size())) {
      out += before + line + "\n";
      before = "      ";
    }
  };
  add(sheet.title);
  for (const Step& step : sheet.steps) out += text_of(step, widest);
  add(sheet.result);
  // Its last word, which no line breaks.
  const std::size_t end = out.size() - 1;
  marked.words.push_back({end - std::string_view(to_text(sheet.mark)).size(), end, sheet.mark});
  std::string before = "    source: ";
  for (const std::string& line :
       plain_text::wrapped(sheet.source, widest - before.size(), widest - before.size())) {
    out += before + line + "\n";
    before.assign(before.size(), ' ');
  }
  return marked;
}

}  // namespace boxbeam::report
