#include "program/case_options.hpp"

#include "boxbeam/core/error.hpp"

namespace boxbeam::program {
namespace {

/// Takes over which model is asked for.
void take_model(const CaseOptions& options, Project& project) {
  if (options.tolerance) project.model.tolerance = *options.tolerance;
  if (options.model.empty()) return;
  project.model.demand = options.model == "auto"    ? ModelDemand::automatic
                         : options.model == "rigid" ? ModelDemand::rigid
                                                    : ModelDemand::flexible;
  if (project.model.demand != ModelDemand::flexible) return;
  if (in_space(project)) {
    throw InputError("the bodies of a mechanism in space are rigid; there is no flexible model",
                     "use --model auto or --model rigid");
  }
  if (project.dynamics == Dynamics::newton_chain) {
    throw InputError("the published Newton chain is one of rigid bodies",
                     "use --model auto or --model rigid, or --dynamics rigorous");
  }
}

}  // namespace

Project read_case(const CaseOptions& options) {
  std::optional<Dynamics> dynamics;
  if (!options.dynamics.empty()) {
    dynamics = options.dynamics == "rigorous" ? Dynamics::rigorous : Dynamics::newton_chain;
  }
  Project project = read_project(options.file, options.set, dynamics);
  take_model(options, project);
  return project;
}

}  // namespace boxbeam::program
