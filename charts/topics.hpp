#pragma once

#include <span>
#include <string_view>

#include "charts/chart.hpp"
#include "charts/scene.hpp"
#include "charts/stopwatch.hpp"

namespace boxbeam::charts {

/// A question about accuracy and cost, with the experiments that answer it.
struct Topic {
  const char* name;   ///< "cut-forces"
  const char* title;  ///< "Cut forces along the beam"
  TopicResult (*run)(const Scenes& scenes, const Effort& effort);
};

/// All of them, in the order of the calculation.
std::span<const Topic> topics();

/// nullptr where there is none of that name.
const Topic* topic_named(std::string_view name);

// The topics, each in a file of its own.
TopicResult verdict(const Scenes& scenes, const Effort& effort);
TopicResult kinematics(const Scenes& scenes, const Effort& effort);
TopicResult reactions(const Scenes& scenes, const Effort& effort);
TopicResult cut_forces(const Scenes& scenes, const Effort& effort);
TopicResult critical_instants(const Scenes& scenes, const Effort& effort);
TopicResult rigid_elements(const Scenes& scenes, const Effort& effort);
TopicResult response(const Scenes& scenes, const Effort& effort);
TopicResult integration(const Scenes& scenes, const Effort& effort);
TopicResult rainflow(const Scenes& scenes, const Effort& effort);
TopicResult sections(const Scenes& scenes, const Effort& effort);
TopicResult precision(const Scenes& scenes, const Effort& effort);
TopicResult model(const Scenes& scenes, const Effort& effort);
TopicResult stability(const Scenes& scenes, const Effort& effort);

// The maps of the topic `stability`.
Map toggle_map(const Scenes& scenes, const Effort& effort);
Map stiff_joint_map(const Scenes& scenes, const Effort& effort);
Map resonance_map(const Scenes& scenes, const Effort& effort);
Map thin_section_map(const Scenes& scenes, const Effort& effort);
Map taper_map(const Scenes& scenes, const Effort& effort);

}  // namespace boxbeam::charts
