#include "boxbeam/verification/any_motion_result.hpp"

namespace boxbeam {

AnyMotionResult any_motion_of(const Project& project, const std::vector<double>& times,
                              const std::string& axes) {
  struct OfKind {
    const Project& project;
    const std::vector<double>& times;
    const std::string& axes;

    AnyMotionResult operator()(const planar::Mechanism&) const { return motion_of(project, times); }
    AnyMotionResult operator()(const spatial::Mechanism&) const {
      return chain_motion_of(project, times, axes);
    }
    AnyMotionResult operator()(const flexible::Mechanism&) const {
      return flexible_motion_of(project);
    }
  };
  return std::visit(OfKind{project, times, axes}, project.mechanism);
}

}  // namespace boxbeam
