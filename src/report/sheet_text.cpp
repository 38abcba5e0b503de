#include "boxbeam/report/text_writer.hpp"

#include <fmt/format.h>

namespace boxbeam::report {
namespace {

constexpr std::size_t widest = 100;

std::string text_of(const Step& step) {
  std::string out;
  std::string line = fmt::format("    {:<11} ", step.symbol);
  const std::string margin(line.size(), ' ');
  bool first = true;
  for (const std::string& formula : step.formulas) {
    const bool fits = line.size() + formula.size() + 3 <= widest;
    if (!first && !fits) {
      out += line + "\n";
      line = margin;
    }
    line += (first || !fits ? "= " : " = ") + formula;
    first = false;
  }
  for (const std::string& note : step.notes) {
    // A short note stands beside a short step.
    const bool beside = &note == &step.notes.front() && line.size() + note.size() + 4 <= widest;
    if (beside) {
      line += "   (" + note + ")";
    } else {
      out += line + "\n";
      line = margin + "  (" + note + ")";
    }
  }
  return out + line + "\n";
}

}  // namespace

std::string text_of(const Sheet& sheet) {
  std::string out = fmt::format("  {}\n    {}\n", sheet.id, sheet.title);
  for (const Step& step : sheet.steps) out += text_of(step);
  return out + fmt::format("    {}\n    source: {}\n", sheet.result, sheet.source);
}

}  // namespace boxbeam::report
