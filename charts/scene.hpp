#pragma once

#include <optional>
#include <string>

#include "boxbeam/project/project.hpp"

namespace boxbeam::charts {

/// What the experiments are done on: cases, where the topic is about one.
struct Scenes {
  std::optional<Project> planar;    ///< rigid bodies in the plane
  std::optional<Project> flexible;  ///< elastic links
  std::optional<Project> beam;      ///< whose beam, loads and sections are looked at
  /// The case that the user named is none of these kinds: why a topic that needs one has nothing.
  std::string missing;
};

/// The sledge rig and the drill truck, which are part of the program.
Scenes reference_scenes();

/// A case in the place of the reference scene of its kind. Topics that are about another kind of
/// mechanism have nothing to say of it.
Scenes scenes_of(Project project);

}  // namespace boxbeam::charts
