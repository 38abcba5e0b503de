#pragma once

#include <string>
#include <vector>

/// Running pdflatex over a text, to see what it says of it.
namespace test {

struct LatexRun {
  int exit_code = -1;
  std::string first_error;
  std::vector<std::string> too_wide;  ///< what stands out by more than 2 pt, or too high
};

/// False, with a warning, where it is not installed; every CI machine has it.
bool has_pdflatex();
bool has_pdftotext();

/// One run over a document, in a folder of its own.
LatexRun run_latex(const std::string& document);

/// The text of a PDF, by poppler.
std::string text_of_pdf(const std::string& path);

std::string without_spaces(const std::string& text);

}  // namespace test
