#pragma once

#include <string>
#include <vector>

#include "boxbeam/study/design_space.hpp"
#include "boxbeam/study/study_summary.hpp"
#include "program/design_trial.hpp"

namespace boxbeam::program {

/// The case of a study, as it is.
CaseOptions case_of(const Study& study);

/// The designs of a study, each verified to a row of its table. May be asked by several threads.
class StudyDesigns {
 public:
  /// Looks at the study, which stays. Throws InputError where a key or a column is none of the
  /// case.
  explicit StudyDesigns(const Study& study);

  std::size_t size() const { return space_.size(); }
  /// "design", the variables, the columns, "status".
  const std::vector<Column>& columns() const { return columns_; }
  /// Of the study, the case and its tables.
  const std::string& sha256() const { return sha256_; }

  struct Row {
    std::string text;  ///< with its end
    bool failed = false;
    bool kept = true;  ///< has a row of the table; one that failed always has
  };
  Row row(std::size_t index) const;

 private:
  void require_no_keys() const;
  void require_keys() const;
  void require_columns();
  std::vector<std::string> results_of_design(const std::vector<Setting>& design) const;
  bool keeps(const std::vector<std::string>& cells) const;

  const Study* study_;
  DesignSpace space_;
  DesignTrials trials_;
  std::vector<Column> columns_;
  std::vector<std::string> keep_names_;    ///< in the condition of the study
  std::vector<std::size_t> keep_columns_;  ///< of these, among all
  std::string sha256_;
};

}  // namespace boxbeam::program
