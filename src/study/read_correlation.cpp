#include "read_correlation.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

namespace boxbeam {

void read_correlation(TableReader& root, Study& study) {
  if (!root.has({"correlation", "of variables that scatter: \"A,B\" = 0.3"})) return;
  TableReader table = root.table("correlation");
  std::vector<const Variable*> scattering;
  for (const Variable& variable : study.variables)
    if (variable.distribution) scattering.push_back(&variable);
  const auto count = static_cast<Eigen::Index>(scattering.size());
  const auto index_of = [&](std::string name) -> Eigen::Index {
    name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
    for (Eigen::Index i = 0; i < count; ++i)
      if (scattering[static_cast<std::size_t>(i)]->name == name) return i;
    return -1;
  };
  table.accept_all();
  study.correlation = Eigen::MatrixXd::Identity(count, count);
  std::set<std::pair<Eigen::Index, Eigen::Index>> said;
  for (const Node::Member& member : table.members("correlation of the two")) {
    const std::size_t comma = member.key.find(',');
    const Eigen::Index a = comma == std::string::npos ? -1 : index_of(member.key.substr(0, comma));
    const Eigen::Index b = comma == std::string::npos ? -1 : index_of(member.key.substr(comma + 1));
    if (a < 0 || b < 0 || a == b) {
      table.problem(member.key,
                    fmt::format("\"{}\" are not two variables that scatter", member.key),
                    "write \"A,B\" = 0.3 with names of variables that have a distribution");
      continue;
    }
    if (!said.insert(std::minmax(a, b)).second) {
      table.problem(member.key, fmt::format("the correlation of \"{}\" is said twice", member.key),
                    "write that of each pair once");
      continue;
    }
    const double rho = member.value.number;
    if (member.value.kind != Node::Kind::number || !(std::abs(rho) < 1.0)) {
      table.problem(member.key, "a correlation is a number between -1 and 1", "write 0.3");
      continue;
    }
    try {
      study.correlation(a, b) = study.correlation(b, a) =
          normal_correlation(*scattering[static_cast<std::size_t>(a)]->distribution,
                             *scattering[static_cast<std::size_t>(b)]->distribution, rho);
    } catch (const std::domain_error&) {
      table.problem(member.key,
                    fmt::format("two such distributions cannot have the correlation {}", rho),
                    "write one nearer to zero");
    }
  }
  if (count > 0 && table.problems().empty()) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(study.correlation,
                                                               Eigen::EigenvaluesOnly);
    if (eigen.eigenvalues().minCoeff() <= 1e-12)
      root.problem("correlation", "no variables have all these correlations at once",
                   "their matrix is not positive definite: write smaller ones");
  }
}

}  // namespace boxbeam
