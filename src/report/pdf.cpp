#include "boxbeam/report/pdf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "boxbeam/core/error.hpp"
#include "boxbeam/report/files.hpp"
#include "boxbeam/report/latex_writer.hpp"
#include "process.hpp"

namespace boxbeam::report {
namespace {

namespace fs = std::filesystem;

/// Seconds since 1970 at which a report's day begins, "0" where its date is none.
std::string epoch_of(const std::string& date) {
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  if (std::sscanf(date.c_str(), "%d-%u-%u", &year, &month, &day) != 3) return "0";
  const std::chrono::year_month_day of{std::chrono::year(year), std::chrono::month(month),
                                       std::chrono::day(day)};
  if (!of.ok()) return "0";
  return std::to_string(
      std::chrono::sys_seconds(std::chrono::sys_days(of)).time_since_epoch().count());
}

/// One run over report.tex in a folder.
Command pdflatex(const fs::path& folder, const std::string& date, bool draft) {
  Command command{{"pdflatex", "-no-shell-escape", "-interaction=batchmode", "-halt-on-error"},
                  folder,
                  "terminal.log",
                  // Nothing of the user's own, nothing written but here, whatever is set outside.
                  {{"FORCE_SOURCE_DATE", "1"},
                   {"openin_any", "p"},
                   {"openout_any", "p"},
                   {"max_print_line", "1000"},
                   {"TEXINPUTS", ".:"},
                   {"TEXMFHOME", folder.string()},
                   {"TEXMFVAR", folder.string()},
                   {"TEXMFCONFIG", folder.string()}}};
  if (std::getenv("SOURCE_DATE_EPOCH") == nullptr)
    command.environment["SOURCE_DATE_EPOCH"] = epoch_of(date);
  if (draft) command.arguments.emplace_back("-draftmode");
  command.arguments.emplace_back("report.tex");
  return command;
}

/// What LaTeX says first of what went wrong.
std::string first_error_in(const fs::path& log) {
  std::ifstream in(log);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("!")) return line;
  return "it ended without a message";
}

/// Whether a file is a PDF from its first to its last bytes: on a full disk there may be a part.
bool is_whole_pdf(const std::string& content) {
  constexpr std::size_t tail = 64;
  return content.starts_with("%PDF-") &&
         content.find("%%EOF", content.size() - std::min(tail, content.size())) !=
             std::string::npos;
}

}  // namespace

void write_pdf(const Document& document, const std::string& figures, const std::string& path) {
  const fs::path target(path);
  const fs::path log = target.parent_path() / (target.stem().string() + ".log");
  const ScratchFolder scratch(target.has_parent_path() ? target.parent_path() : fs::path("."));
  const auto has_picture = [&](const std::string& name) {
    if (figures.empty()) return false;
    for (const char* extension : {".tex", ".pdf"}) {
      const fs::path figure = fs::path(figures) / (name + extension);
      std::error_code error;
      if (!fs::is_regular_file(figure, error)) continue;
      const fs::path from = fs::absolute(figure, error);
      // Of one of several beams it stands in a folder.
      if (!error) fs::create_directories((scratch.path() / name).parent_path(), error);
      if (!error) fs::create_symlink(from, scratch.path() / (name + extension), error);
      if (!error || error == std::errc::file_exists) return true;  // a picture may be shown twice
    }
    return false;
  };
  write_file((scratch.path() / "report.tex").string(), latex_of(document, has_picture));

  // Twice: the first run finds the numbers of the pages.
  for (const bool draft : {true, false}) {
    const std::optional<int> code =
        exit_code_of(start(pdflatex(scratch.path(), document.date, draft)));
    if (!code) {
      throw MissingTool(
          "no PDF: pdflatex is not installed (apt install texlive-latex-base "
          "texlive-latex-recommended lmodern); everything else is written");
    }
    if (*code != 0) {
      write_file(log.string(), content_of(scratch.path() / "report.log"));
      throw OutputError(fmt::format("no PDF: pdflatex failed: {}\n  its log: {}",
                                    first_error_in(scratch.path() / "report.log"), log.string()));
    }
  }
  const std::string pdf = content_of(scratch.path() / "report.pdf");
  if (!is_whole_pdf(pdf)) {
    throw OutputError(fmt::format("no PDF: pdflatex ended well, but what it wrote is {}",
                                  pdf.empty() ? "nothing" : "only a part of a PDF"));
  }
  write_file(path, pdf);
}

}  // namespace boxbeam::report
