#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "boxbeam/report/marked_text.hpp"
#include "boxbeam/study/design_rows.hpp"
#include "boxbeam/verification/cycle_figure.hpp"

/// A report as a value: what stands in it, in order. Text, HTML and PDF are written from it and add
/// nothing. All strings are UTF-8 as the user wrote them; each writer makes them safe for itself.
namespace boxbeam::report {

struct Paragraph {
  std::string text;
};

struct Bullets {
  std::vector<std::string> items;
};

/// Names with what is said of each: the title block, the inputs.
struct Facts {
  std::vector<std::pair<std::string, std::string>> entries;
};

struct Cell {
  std::string text;             ///< as it is shown, rounded
  std::optional<double> value;  ///< by which a column sorts where its text would sort wrongly
  Mark mark = Mark::none;       ///< where it says a result
};

struct Table {
  std::string caption;
  std::vector<std::string> header;  ///< with units: "s [m]"
  /// As many cells as the header. Columns of which every cell begins with a digit, a sign or "-"
  /// stand at the right.
  std::vector<std::vector<Cell>> rows;
  std::vector<Mark> marks;  ///< one per row, or none at all
  /// The id of the sheet that derives a row, "" for none; one per row, or none at all.
  std::vector<std::string> sheets = {};
  /// Whether a page that can unfold it shows its caption only at first.
  bool folded = false;
};

/// A figure that stands as NAME.svg beside the report.
struct Picture {
  std::string name;     ///< "cut-forces"
  std::string caption;  ///< one sentence that says what is to be seen
};

/// One step of a calculation, "symbol = formula = formula = value  (note)". Formulas are in the
/// notation of formula.hpp.
struct Step {
  std::string symbol;                 ///< "sigma_max"
  std::vector<std::string> formulas;  ///< "N/A_eff + M_y z/I_y,eff", then with values, then result
  std::vector<std::string> notes;     ///< "at t = 0.3571 s", plain text, a line each
};

/// The derivation of one check, which a reader can follow with a pocket calculator.
struct Sheet {
  std::string id;     ///< of the check: "yield/4.2/fibre+z"
  std::string title;  ///< "yield at s = 4.2 m, fibre +z"
  std::vector<Step> steps;
  std::string result;      ///< "factor 1.21, required 2.00, utilisation 165 %: FAILS"
  double utilisation = 0;  ///< drawn as a bar
  Mark mark = Mark::none;
  std::string source;  ///< standard, clause, equation
};

/// Text as it stands, line by line: the case file in the appendix.
struct Listing {
  std::string text;
};

/// The mechanism, its loads and the cut forces over the cycle, to be moved by the reader. Only HTML
/// shows it.
/// Situations of a case that a page with scripts shows by choice, moving.
struct MovingPicture {
  std::vector<CycleFigure> cycles;  ///< none: no picture
  std::size_t first = 0;            ///< which one it begins with
  std::string caption;
};

/// Designs that a page with scripts lets its reader look through: filtered, drawn against each
/// other, counted.
struct DesignTable {
  DesignRows rows;
  std::string caption;
  /// Names of columns that a diagram begins with; "" where the page chooses.
  std::string x = {}, y = {}, colour = {}, counted = {};
};

struct Subheading {
  std::string text;
};

using Block = std::variant<Paragraph, Bullets, Facts, Table, Picture, Sheet, Listing, MovingPicture,
                           DesignTable, Subheading>;

struct Chapter {
  std::string title;
  std::vector<Block> blocks;
};

struct Document {
  std::string title;          ///< name of the case
  std::string subtitle;       ///< its title
  std::string date;           ///< "2026-11-21"
  std::string program;        ///< "boxbeam 0.1.0"
  std::string input_sha256;   ///< "": of no single input
  std::string verdict;        ///< "PASS", "FAIL; rod hanger: no force"; "": nothing is judged
  std::string sentence = {};  ///< the verdict in one sentence that can stand alone
  std::string prepared_by = {}, checked_by = {};  ///< names of who signs, where known
  std::vector<std::string> reasons = {};          ///< of the verdict, where it is "NOT APPLICABLE"
  Mark mark = Mark::none;
  Facts facts;                      ///< the rest of the title block
  Table governing;                  ///< under the verdict: the worst check of every criterion
  std::vector<Block> opening = {};  ///< on the first page behind it: tables and pictures
  std::vector<Chapter> chapters;
};

/// What of a verdict is seen from afar: all of a short one, else its word; the rest is read.
struct VerdictParts {
  std::string seen, read;
};
inline VerdictParts parts_of_verdict(const std::string& verdict) {
  constexpr std::size_t short_one = 60;
  const std::size_t word = verdict.find("; ");
  if (verdict.size() <= short_one || word == std::string::npos) return {verdict, ""};
  return {verdict.substr(0, word), verdict.substr(word + 2)};
}

}  // namespace boxbeam::report
