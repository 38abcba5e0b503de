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

namespace {

/// What of a mechanism the experiments on mechanisms can be done on, and why the others cannot.
struct SceneOf {
  const Project* project;
  Scenes* scenes;

  void operator()(const planar::Mechanism&) const {
    scenes->planar = *project;
    scenes->missing = "its mechanism is of rigid bodies, not of elastic links";
  }
  void operator()(const spatial::Mechanism&) const {
    scenes->missing = "its mechanism is a chain in space, whose motion is explicit";
  }
  void operator()(const flexible::Mechanism&) const {
    scenes->flexible = *project;
    scenes->missing = "its mechanism is of elastic links, not of rigid bodies in the plane";
  }
  void operator()(const frame::Structure&) const {
    scenes->missing = "its beam is at rest: nothing moves";
  }
  void operator()(const recorded::Loads&) const {
    scenes->missing = "its loads are given: no mechanism moves";
  }
};

}  // namespace

Scenes scenes_of(Project project) {
  Scenes scenes;
  std::visit(SceneOf{&project, &scenes}, project.mechanism);
  scenes.beam = std::move(project);
  return scenes;
}

}  // namespace boxbeam::charts
