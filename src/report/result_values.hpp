#pragma once

#include <string>
#include <vector>

#include "json_number.hpp"

namespace boxbeam {

/// A number that a document holds, and the key by which it is asked for.
struct ResultValue {
  std::string key;   ///< "beam.stations[3.2-].M.max"
  std::string unit;  ///< SI: "N m"; "1" without
  double value = 0.0;
};

/// All numbers with a unit in a document, with their units, in its order. The document's schema
/// says how they are called: keys are joined by "."; entries of lists stand in brackets by the name
/// that "x-key" builds of their members, and also by their place from 0; the numbers of a list that
/// has "x-names" by these.
std::vector<ResultValue> values_in(const Json& document, const Json& schema,
                                   const std::string& prefix = {});

}  // namespace boxbeam
