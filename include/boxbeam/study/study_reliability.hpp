#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/study/reliability.hpp"
#include "boxbeam/study/study.hpp"

namespace boxbeam {

/// A variable at a design point.
struct VariableAtPoint {
  std::string name, unit;
  double value = 0.0;  ///< in its unit
  double u = 0.0;      ///< of the independent normal variable behind it
  /// How the limit state falls with it, in its standard deviation, all squares together 1: above
  /// zero of what loads. Of independent variables u = beta alpha.
  double alpha = 0.0;
};

/// A study whose probability of failure was asked for.
struct StudyReliability {
  std::string name, study_file, case_file;
  std::string sha256;  ///< of the study, the case and its tables
  std::uint64_t seed = 0;
  std::vector<std::string> limit_state;  ///< "check fatigue", "r - s < 0"
  bool correlated = false;
  std::optional<double> years;
  ReliabilityResult result;
  std::vector<std::vector<VariableAtPoint>> points;  ///< of each design point
};

/// Standard normal variables as values of those of a study that scatter (Nataf's model).
class StudyTransformation {
 public:
  /// Looks at the study, which stays.
  explicit StudyTransformation(const Study& study);

  Eigen::Index dimension() const { return static_cast<Eigen::Index>(scattering_.size()); }
  /// Of the variables that scatter, in their order.
  std::vector<double> values_at(const Eigen::VectorXd& u) const;
  std::vector<VariableAtPoint> at(const DesignPoint& point) const;

 private:
  std::vector<const Variable*> scattering_;
  Eigen::MatrixXd factor_;  ///< of the correlation, lower triangular; empty without one
};

/// What the file and a finished result say; the hash is known outside.
StudyReliability study_reliability(const Study& study, ReliabilityResult result);

/// The limit state of a study without a case.
LimitState limit_state_of_variables(const Study& study, std::size_t threads);

}  // namespace boxbeam
