#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/study/roots.hpp"
#include "boxbeam/study/written_quantity.hpp"

namespace boxbeam {

/// A value of a key at which a result of the case is the wanted one, and what the case comes to
/// there.
struct SolvedValue {
  WrittenQuantity value;
  double result = 0.0;
  std::string verdict;       ///< of the whole case: "pass", "fail", "not applicable"
  std::string governing;     ///< id of the check that is used most
  double utilisation = 0.0;  ///< of it
  std::string gate;          ///< why the stresses there cannot be believed; "" where they can
};

/// What of a case makes one of its results what is wanted.
struct Solution {
  std::string case_file;
  std::string key;                     ///< of the case
  WrittenQuantity from, to;            ///< where it was looked for, in the unit of the case
  std::string result;                  ///< key of it
  std::string result_unit;             ///< SI
  double wanted = 0.0;                 ///< in it
  std::optional<WrittenQuantity> own;  ///< as the case has it
  std::optional<double> own_result;    ///< there
  std::vector<SolvedValue> values;     ///< ascending
  Roots search;                        ///< how they were found, in the unit of the case
  std::string reason;                  ///< why there is none; "" where there is one
};

/// Why a search found nothing, in a sentence or two.
std::string reason_of(const Solution& solution);

}  // namespace boxbeam
