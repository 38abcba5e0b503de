#include "boxbeam/study/study_reliability.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "boxbeam/core/error.hpp"
#include "boxbeam/study/design_space.hpp"
#include "boxbeam/study/named_expression.hpp"

namespace boxbeam {

StudyTransformation::StudyTransformation(const Study& study) {
  for (const Variable& variable : study.variables)
    if (variable.distribution) scattering_.push_back(&variable);
  if (study.correlation.size() > 0) factor_ = study.correlation.llt().matrixL();
}

std::vector<double> StudyTransformation::values_at(const Eigen::VectorXd& u) const {
  Eigen::VectorXd z = u;
  if (factor_.size() > 0) z = factor_.triangularView<Eigen::Lower>() * u;
  std::vector<double> values;
  for (std::size_t k = 0; k < scattering_.size(); ++k)
    values.push_back(scattering_[k]->distribution->value_at(z[static_cast<Eigen::Index>(k)]));
  return values;
}

std::vector<VariableAtPoint> StudyTransformation::at(const DesignPoint& point) const {
  // d g/d z = (d g/d u) L^-1, which does not hang on the order of the variables.
  Eigen::VectorXd alpha = point.alpha;
  if (factor_.size() > 0) {
    alpha = factor_.transpose().triangularView<Eigen::Upper>().solve(point.alpha).normalized();
  }
  const std::vector<double> values = values_at(point.u);
  std::vector<VariableAtPoint> all;
  for (std::size_t k = 0; k < scattering_.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    all.push_back({scattering_[k]->name, scattering_[k]->unit, values[k], point.u[i], alpha[i]});
  }
  return all;
}

StudyReliability study_reliability(const Study& study, ReliabilityResult result) {
  StudyReliability of;
  of.name = study.name;
  of.study_file = std::filesystem::path(study.path).filename().string();
  of.case_file = study.case_written;
  of.seed = study.seed;
  for (const std::string& check : study.reliability->checks)
    of.limit_state.push_back(check == "all" ? "any check" : "check " + check);
  for (const std::string& expression : study.reliability->expressions)
    of.limit_state.push_back(expression + " < 0");
  of.correlated = study.correlation.size() > 0;
  of.years = study.reliability->years;
  of.result = std::move(result);
  const StudyTransformation transformation(study);
  for (const DesignPoint& point : of.result.points) of.points.push_back(transformation.at(point));
  return of;
}

LimitState limit_state_of_variables(const Study& study, std::size_t threads) {
  const auto transformation = std::make_shared<const StudyTransformation>(study);
  const auto make = [transformation, &study]() -> LimitState::Function {
    std::vector<std::string> names;
    for (const Variable& variable : study.variables)
      if (variable.words.empty()) names.push_back(variable.name);
    const auto expressions = std::make_shared<std::vector<NamedExpression>>();
    for (const std::string& text : study.reliability->expressions)
      expressions->emplace_back(text, names);
    return [transformation, expressions, &study](const Eigen::VectorXd& u) {
      Response response;
      try {
        const std::vector<Setting> design = design_of(study, transformation->values_at(u));
        std::vector<double> numbers;
        for (std::size_t i = 0; i < design.size(); ++i)
          if (study.variables[i].words.empty()) numbers.push_back(design[i].number);
        response.g = std::numeric_limits<double>::infinity();
        for (NamedExpression& expression : *expressions) {
          const double g = expression.at(numbers);
          response.g = g < response.g || std::isnan(g) ? g : response.g;
          if (std::isnan(g)) break;
        }
      } catch (const AnalysisError& error) {
        response.trouble = error.failure().what;
      } catch (const std::invalid_argument& error) {
        response.trouble = error.what();
      }
      return response;
    };
  };
  constexpr std::size_t worth_a_thread = 500;
  return LimitState(transformation->dimension(), make, threads, worth_a_thread);
}

}  // namespace boxbeam
