#include "combined_cases.hpp"

#include <algorithm>
#include <stdexcept>

namespace oracle {
namespace {

std::size_t run_of(const std::string& name, const Project& project,
                   const std::vector<Run>& sampled) {
  const auto found = std::find_if(sampled.begin(), sampled.end(), [&](const Run& run) {
    return project.situations[run.situation].name == "unit " + name;
  });
  if (found == sampled.end()) throw std::runtime_error("no situation of load case " + name);
  return static_cast<std::size_t>(found - sampled.begin());
}

}  // namespace

std::vector<Combination> combinations_of(const Combining& by, const Project& project,
                                         const std::vector<Run>& sampled) {
  std::vector<Combination> all;
  if (by.cases.empty()) return all;
  const std::size_t count = by.cases.size();
  // Every subset of the cases, as those that are unfavourable, with every leader or none.
  const auto add = [&](double most_permanent, bool leads) {
    for (std::size_t leader = 0; leader <= (leads ? count : 0); ++leader) {
      for (std::size_t subset = 0; subset < (std::size_t{1} << count); ++subset) {
        Combination& one = all.emplace_back();
        for (std::size_t k = 0; k < count; ++k) {
          const Combining::LoadCase& of = by.cases[k];
          const bool worse = (subset >> k & 1U) != 0;
          const double variable =
              worse ? by.gamma_Q * (leads && k == leader ? 1.0 : of.psi_0) : 0.0;
          one.emplace_back(run_of(of.name, project, sampled),
                           of.permanent ? (worse ? most_permanent : by.gamma_G_inf) : variable);
        }
      }
    }
  };
  if (by.by_ab) {
    add(by.gamma_G, false);
    add(by.xi * by.gamma_G, true);
  } else {
    add(by.gamma_G, true);
  }
  return all;
}

}  // namespace oracle
