#include "support/latex.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "catch.hpp"
#include "support/program.hpp"

namespace test {
namespace {

/// Of a program that says its version; no text of a test comes near the shell.
bool is_installed(const std::string& program, const std::string& package) {
  if (std::system((program + " --version >/dev/null 2>&1 </dev/null").c_str()) == 0) return true;
  if (std::system((program + " -v >/dev/null 2>&1 </dev/null").c_str()) == 0) return true;
  WARN("not tested: " << program << " is not installed (apt install " << package << ")");
  return false;
}

}  // namespace

bool has_pdflatex() { return is_installed("pdflatex", "texlive-latex-recommended lmodern"); }

bool has_pdftotext() { return is_installed("pdftotext", "poppler-utils"); }

LatexRun run_latex(const std::string& document) {
  const TemporaryFolder folder;
  folder.write("report.tex", document);
  const std::string command =
      "cd '" + folder.path().string() +
      "' && max_print_line=1000 openin_any=p pdflatex -no-shell-escape -interaction=batchmode "
      "-halt-on-error -draftmode report.tex >/dev/null 2>&1 </dev/null";
  LatexRun run;
  run.exit_code = std::system(command.c_str());
  std::ifstream log(folder.path() / "report.log");
  for (std::string line; std::getline(log, line);) {
    if (line.starts_with("!") && run.first_error.empty()) run.first_error = line;
    if (!line.starts_with("Overfull")) continue;
    const std::size_t bracket = line.find('(');
    if (std::strtod(line.c_str() + bracket + 1, nullptr) > 2.0) run.too_wide.push_back(line);
  }
  return run;
}

std::string text_of_pdf(const std::string& path) {
  const std::filesystem::path out = path + ".txt";
  if (std::system(("pdftotext -layout '" + path + "' '" + out.string() + "'").c_str()) != 0) {
    return "";
  }
  return read_file(out);
}

std::string without_spaces(const std::string& text) {
  std::string out;
  std::copy_if(text.begin(), text.end(), std::back_inserter(out),
               [](unsigned char c) { return std::isspace(c) == 0; });
  return out;
}

}  // namespace test
