#include "program/motion_command.hpp"

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/report/json.hpp"
#include "boxbeam/report/motion_text.hpp"
#include "boxbeam/verification/any_motion_result.hpp"
#include "program/exit_code.hpp"
#include "program/outputs.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {
namespace {

int run_assemblies(const Project& project, const MotionOptions& options) {
  if (in_space(project)) {
    throw InputError("a mechanism in space is a chain, which has one assembly only",
                     "leave out --assemblies");
  }
  const double time = options.at.empty() ? 0.0 : options.at.front();
  const std::vector<AssemblyResult> assemblies = assemblies_of(project, time);
  put_result(options.json, assemblies_json(assemblies, time),
             assemblies_text(project, assemblies, time));
  return all_pass;
}

/// What the motion of a kind of mechanism cannot be asked for.
void refuse_what_is_not_there(const Project& project, const MotionOptions& options) {
  if (is_flexible(project)) {
    if (!options.at.empty())
      throw InputError("elastic links vibrate about one posture: there are no instants to choose",
                       "leave out --at");
    if (options.assemblies)
      throw InputError("elastic links are placed by the case, which is their only assembly",
                       "leave out --assemblies");
    if (!options.axes.empty())
      throw InputError("the motion of elastic links is given in world axes only",
                       "leave out --axes");
  } else if (!in_space(project) && !options.assemblies && !options.axes.empty()) {
    throw InputError("the motion of a planar case is given in world axes only", "leave out --axes");
  }
}

}  // namespace

int run_motion(const MotionOptions& options) {
  // The mechanism alone: where the beam's loads come from does not matter, so that a case made for
  // the chain can be moved as well.
  const Project project = read_case(options.of_case);
  require_file(options.json);
  refuse_what_is_not_there(project, options);
  if (options.assemblies) return run_assemblies(project, options);
  const AnyMotionResult motion =
      any_motion_of(project, options.at, options.axes.empty() ? "world" : options.axes);
  put_result(options.json, motion_json(motion), motion_text(project, motion));
  return all_pass;
}

}  // namespace boxbeam::program
