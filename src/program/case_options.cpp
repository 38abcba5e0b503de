#include "program/case_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "boxbeam/core/error.hpp"
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

void keep_beam(const std::string& name, std::vector<Project>& beams) {
  std::vector<std::string> names;
  for (const Project& project : beams) names.push_back(project.beam_name);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    if (beams.size() == 1) throw InputError("the case has one beam only", "leave out --beam");
    throw InputError(fmt::format("the case has no beam \"{}\"", name),
                     fmt::format("one of {}", fmt::join(names, ", ")));
  }
  std::erase_if(beams, [&](const Project& project) { return project.beam_name != name; });
}

std::optional<Dynamics> dynamics_in(const CaseOptions& options) {
  if (options.dynamics.empty()) return std::nullopt;
  return options.dynamics == "rigorous" ? Dynamics::rigorous : Dynamics::newton_chain;
}

std::vector<Project> asked_for(const CaseOptions& options, std::vector<Project> beams) {
  if (!options.beam.empty()) keep_beam(options.beam, beams);
  for (Project& project : beams) take_model(options, project);
  return beams;
}

}  // namespace

std::vector<Project> read_beams_of(const CaseOptions& options) {
  return asked_for(options, read_beams(options.file, options.set, dynamics_in(options)));
}

std::vector<Project> read_beams_of(const CaseOptions& options, const CaseSource& source,
                                   const std::vector<std::string>& set) {
  std::vector<std::string> all = options.set;
  all.insert(all.end(), set.begin(), set.end());
  return asked_for(options, source.read_beams(all, dynamics_in(options)));
}

Project read_case(const CaseOptions& options) { return std::move(read_beams_of(options).front()); }

}  // namespace boxbeam::program
