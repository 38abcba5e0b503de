#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "boxbeam/fatigue/size_effect.hpp"
#include "boxbeam/fatigue/sn_curve.hpp"

namespace boxbeam {

/// Where the stress of a detail is taken.
enum class StressPlace {
  gross,     ///< nominal stress of the full section
  net,       ///< nominal stress of the section less its holes; a bolt's stress area
  throat,    ///< of the weld, clause 5(6)
  hot_spot,  ///< structural stress at the weld toe, annex B
};

/// What is known about a detail: a word ("weld" is "butt"), or a number in SI units
/// ("attachment_length" is 0.04). What is not known is not there.
using FactValue = std::variant<std::string, double>;
using Facts = std::map<std::string, FactValue, std::less<>>;

/// A range of numbers; without an end it is open to that side.
struct FactRange {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
  bool with_from = true;  ///< whether `from` itself belongs to it
  bool with_to = true;

  friend bool operator==(const FactRange&, const FactRange&) = default;
};

/// The words, or the numbers, that a fact may have.
using Allowed = std::variant<std::vector<std::string>, FactRange>;

bool allows(const Allowed& allowed, const FactValue& value);

/// A category between two lines of a table: linear along the range that the row's conditions have
/// of a fact. Source: EN 1993-1-9:2005, table 8.7.
struct CategoryInterpolation {
  std::string fact;
  double from = 0.0, to = 0.0;  ///< categories at the ends of the range [MPa]
};

/// One entry of the tables of details: a row, or that part of a row which has one category.
struct DetailRow {
  std::string id;         ///< table and row, "8.2/6"
  double category = 0.0;  ///< strength at 2e6 cycles [MPa]
  bool asterisk = false;  ///< 36*, 45*, 50*: may be raised by 7.1, note 3
  StressKind kind = StressKind::direct;
  double slope = 0.0;  ///< of its line without bend, where its row gives one; 0: as its kind has it
  bool endless = false;  ///< that line has no cut-off
  /// Where the category grows with a fact; it is the least one until that fact is known.
  std::optional<CategoryInterpolation> interpolation = {};
  StressPlace where = StressPlace::gross;
  SizeEffect size_effect = SizeEffect::none;
  bool welded = true;
  bool unconfirmed = false;  ///< recalled, or read in sources that do not agree
  std::string what;          ///< the detail in a few words
  std::string workmanship;   ///< what its category asks of the shop; may be empty
  std::string note;
  std::map<std::string, Allowed, std::less<>> conditions;  ///< by fact: where the row applies
};

/// "36*" of a row with an asterisk, else "36".
std::string category_name_of(const DetailRow& row);

/// Factor on a row's strength by its size effect and the facts "thickness", "thicker_thickness",
/// "eccentricity" and "bolt_diameter" [m]; nothing where one that it needs is not known.
std::optional<double> size_factor_of(const DetailRow& row, const Facts& facts);

/// A fact to know or to change.
struct FactChange {
  std::string fact;
  Allowed to;

  friend bool operator==(const FactChange&, const FactChange&) = default;
};

/// What the tables say about a detail as far as it is known.
struct DetailAssessment {
  /// The rows that no fact excludes, the weakest first; that one governs. Empty where the facts fit
  /// no row.
  std::vector<DetailRow> candidates;
  /// Facts that are not known and can exclude what governs, but not all that is stronger.
  std::vector<std::string> deciding;
};

/// The rows for one kind of stress that the facts do not exclude. An unknown fact excludes nothing,
/// so that the less is known, the more rows stay and the lower the weakest of them is; where a
/// table leaves a gap or overlaps, the weaker of the neighbours governs likewise. Strength counts
/// with the size effect where the facts give the size, and interpolated where they give its fact.
DetailAssessment assess(const std::vector<DetailRow>& rows, StressKind kind, const Facts& facts);

/// What would give a detail a row of a higher category.
struct Raise {
  std::vector<FactChange> changes;  ///< at most `most_changes`
  DetailRow row;

  static constexpr std::size_t most_changes = 3;
};

/// The rows that are stronger than the governing one of the candidates and really govern once a few
/// facts are known or changed, the fewest changes first. No `fixed` fact is touched.
std::vector<Raise> raises_of(const std::vector<DetailRow>& rows,
                             const std::vector<DetailRow>& candidates, const Facts& facts,
                             const std::vector<std::string>& fixed);

/// What is known of a detail whose plate is not: the rows that it can be in one plate or another.
struct DetailInPlates {
  Facts facts;                  ///< all but the thickness
  std::vector<DetailRow> rows;  ///< that these facts do not exclude
  bool raise_asterisk = false;
  bool stress_relieved = false;
  bool named = false;  ///< in the case, else called after its row
};

/// A detail of a beam, ready for the verification.
struct Detail {
  std::string name;
  std::string row;  ///< that governs, "8.2/6"; "" where the category is given as such
  SnCurve curve;    ///< without size effect
  StressPlace where = StressPlace::gross;
  SizeEffect size_effect = SizeEffect::none;
  double size_factor = 1.0;          ///< on the curve's strengths
  bool compression_reduced = false;  ///< whether compression counts 60 %, clause 7.2.1
  bool unconfirmed = false;          ///< curve or row
  std::vector<DetailRow> candidates;
  std::vector<std::string> deciding;
  std::vector<Raise> raises;
  /// Where the plate that a point lies in gives the thickness; what stands above is then that of
  /// the thickest plate.
  std::optional<DetailInPlates> in_plates;
};

}  // namespace boxbeam
