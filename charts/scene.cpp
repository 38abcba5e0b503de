#include "charts/scene.hpp"

#include <utility>

#include "reference_cases.hpp"

namespace boxbeam::charts {

Scenes reference_scenes() {
  Scenes scenes;
  scenes.planar = parse_project("sledge-rig/rig.toml", reference_cases::sledge_rig);
  scenes.flexible = parse_project("drill-truck/truck.toml", reference_cases::drill_truck);
  scenes.beam = scenes.planar;
  return scenes;
}

Scenes scenes_of(Project project) {
  Scenes scenes;
  if (std::holds_alternative<flexible::Mechanism>(project.mechanism)) {
    scenes.flexible = project;
    scenes.missing = "its mechanism is of elastic links, not of rigid bodies in the plane";
  } else if (project.in_space) {
    scenes.missing = "its mechanism is a chain in space, whose motion is explicit";
  } else {
    scenes.planar = project;
    scenes.missing = "its mechanism is of rigid bodies, not of elastic links";
  }
  scenes.beam = std::move(project);
  return scenes;
}

}  // namespace boxbeam::charts
