#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "boxbeam/fatigue/detail.hpp"

/// The built-in tables of details (sections/catalogue/details-en-1993-1-9.toml), read when they are
/// first asked for. Source: EN 1993-1-9:2005+AC:2009, tables 3.1, 8.1 to 8.7, 8.10 and B.1.
namespace boxbeam {

/// Something that can be known of a detail.
struct FactDefinition {
  enum class Kind { words, length, ratio };

  std::string name;
  Kind kind = Kind::words;
  std::vector<std::string> words;  ///< of a fact of words, all there are
  bool fixed = false;              ///< says what the detail is: no advice changes it
  std::string means;               ///< what the name does not say; may be empty
};

/// The word of the fact "stress" of rows for what is no stress of a section: what wheels press into
/// the web below a rail or bend in a plate over its ribs, the shear of a stud, the stress beside a
/// cut-out.
inline constexpr const char* local_stress = "local";

const std::vector<FactDefinition>& fact_definitions();
const std::vector<DetailRow>& detail_rows();
/// The rows of a number of a table, "8.4/7", without reading all others; none where it is not
/// there.
std::vector<DetailRow> detail_rows_of(std::string_view id);
std::vector<std::string> fixed_facts();

/// The curve of a row; of a row with an asterisk the raised one of 7.1, note 3, if that is wanted.
SnCurve curve_of(const DetailRow& row, bool raise_asterisk = false);

/// "stop_start = no: 8.2/1, 125".
std::string to_text(const Raise& raise);
/// "attachment_length up to 50 mm", "weld = butt or fillet".
std::string to_text(const FactChange& change);

/// How a structure is kept safe from fatigue, and what its failure would mean. Table 3.1.
enum class AssessmentMethod { damage_tolerant, safe_life };
enum class Consequence { low, high };

/// Recommended gamma_Mf, EN 1993-1-9:2005 table 3.1; a national annex may change it.
double recommended_gamma_Mf(AssessmentMethod method, Consequence consequence);

}  // namespace boxbeam
