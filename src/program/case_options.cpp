#include "program/case_options.hpp"

#include "boxbeam/verification/front_end.hpp"

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
  front_end_of(project)->require_elastic_model();
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
