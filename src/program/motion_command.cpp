#include "program/commands.hpp"

#include <memory>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/project.hpp"
#include "boxbeam/report/files.hpp"
#include "boxbeam/report/gltf.hpp"
#include "boxbeam/report/json.hpp"
#include "boxbeam/report/motion_csv.hpp"
#include "boxbeam/report/motion_text.hpp"
#include "boxbeam/verification/animation.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "program/exit_code.hpp"
#include "program/outputs.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {

int run_motion(const MotionOptions& options) {
  // The mechanism alone: where the beam's loads come from does not matter, so that a case made for
  // the chain can be moved as well.
  const Project project = read_case(options.of_case);
  require_file(options.json);
  require_file(options.gltf);
  require_file(options.csv);
  if (options.gltf == "-")
    throw InputError("a scene is written to a file", "give --gltf the name of one");
  if (options.csv == "-")
    throw InputError("comma-separated values are written to a file", "give --csv the name of one");
  if (options.assemblies && !(options.gltf.empty() && options.csv.empty())) {
    throw InputError("assemblies at an instant are no motion",
                     options.gltf.empty() ? "leave out --assemblies or --csv"
                                          : "leave out --assemblies or --gltf");
  }
  const std::unique_ptr<const FrontEnd> front_end = front_end_of(project);
  if (options.assemblies) {
    const double time = options.at.empty() ? 0.0 : options.at.front();
    const std::vector<AssemblyResult> assemblies = front_end->assemblies(time);
    put_result(options.json, assemblies_json(assemblies, time),
               assemblies_text(project, assemblies, time));
    return all_pass;
  }
  const AnyMotionResult motion = front_end->motion(options.at, options.axes);
  if (!options.gltf.empty())
    write_file(options.gltf, gltf_of(animation_of(project, options.axes), project));
  if (!options.csv.empty()) write_file(options.csv, motion_csv(motion));
  // Of many bodies each takes as long as the motion itself: made where it is asked for.
  put_result(options.json, options.json.empty() ? "" : motion_json(motion),
             options.json == "-" ? "" : motion_text(project, motion));
  return all_pass;
}

}  // namespace boxbeam::program
