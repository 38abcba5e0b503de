#pragma once

#include <string>
#include <utility>
#include <vector>

#include "boxbeam/report/marked_text.hpp"
#include "boxbeam/study/design_rows.hpp"
#include "boxbeam/study/optimum.hpp"

namespace boxbeam {

/// A design of a front of two goals: neither can be less but for more of the other.
struct FrontPoint {
  std::vector<double> values;  ///< of the choices
  std::vector<double> goals;
};

/// What an optimum is said of.
struct OptimumReport {
  struct Named {
    std::string name, unit;  ///< "" without
  };

  std::string study;         ///< its file
  std::vector<Named> goals;  ///< one or two
  std::vector<Choice> choices;
  std::vector<std::string> units;                   ///< of the choices
  std::vector<std::pair<Named, double>> following;  ///< variables that are expressions of these
  std::size_t checks = 0;         ///< of the limits the first so many are criteria of the case
  Optimum optimum;                ///< of the first goal
  std::vector<FrontPoint> front;  ///< of two goals
  std::string verdict;            ///< of the case there; "" without a case
  std::string governing;          ///< id of the check that is used most
  double utilisation = 0.0;       ///< of it
  std::vector<std::string> not_judged;  ///< what the case asks for there without an answer
  DesignRows judged;                    ///< all designs that were looked at, or some of very many
};

/// What `boxbeam optimise` says to people.
report::MarkedText optimum_text(const OptimumReport& of);

/// "boxbeam.optimum/1": variables in the units of the study, results in SI.
std::string optimum_json(const OptimumReport& of);

/// Draws front.svg where there are two goals, and parallel.svg of the designs that were looked at.
/// Returns the names of the files.
std::vector<std::string> draw_optimum(const OptimumReport& of, const std::string& folder);

/// All that the command may write into a folder.
std::vector<std::string> files_of_optimum();

}  // namespace boxbeam
