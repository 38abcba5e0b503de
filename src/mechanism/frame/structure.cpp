#include "boxbeam/mechanism/frame/structure.hpp"

#include <algorithm>

namespace boxbeam::frame {

bool changes_over_time(const Action& action) {
  return std::holds_alternative<Wheels>(action.kind) ||
         std::holds_alternative<DrivenAction>(action.kind);
}

bool changes_over_time(const Structure& structure) {
  return std::any_of(structure.cases.begin(), structure.cases.end(), [](const LoadCase& of) {
    return std::any_of(of.actions.begin(), of.actions.end(),
                       [](const Action& action) { return changes_over_time(action); });
  });
}

std::vector<DriverUse> functions_of(const Structure& structure) {
  std::vector<DriverUse> uses;
  for (std::size_t k = 0; k < structure.cases.size(); ++k) {
    if (structure.factors[k] == 0.0) continue;
    for (const Action& action : structure.cases[k].actions) {
      const auto* driven = std::get_if<DrivenAction>(&action.kind);
      if (driven == nullptr) continue;
      uses.push_back({&driven->size, false,
                      driven->couple ? DriverUse::On::couple : DriverUse::On::force, action.name});
    }
  }
  return uses;
}

Eigen::Vector3d in_world(const Structure& structure, const Place& at) {
  if (at.member == ground) return at.p;
  const Member& member = structure.members[static_cast<std::size_t>(at.member)];
  return member.start + member.axes * at.p;
}

}  // namespace boxbeam::frame
