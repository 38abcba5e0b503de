#include "charts/topics.hpp"

#include <algorithm>
#include <array>

namespace boxbeam::charts {
namespace {

constexpr std::array all{
    Topic{"verdict", "The whole verification", verdict},
    Topic{"kinematics", "Positions, velocities and accelerations", kinematics},
    Topic{"precision", "Precision of the arithmetic", precision},
    Topic{"reactions", "Reactions of the joints", reactions},
    Topic{"integration", "Motions that forces decide", integration},
    Topic{"cut-forces", "Cut forces along the beam", cut_forces},
    Topic{"critical-instants", "Extremes over time", critical_instants},
    Topic{"section", "Section properties", sections},
    Topic{"rainflow", "Cycle counting", rainflow},
    Topic{"rfem", "Rigid finite elements", rigid_elements},
    Topic{"response", "Harmonic response", response},
    Topic{"model", "As much model as the scene needs", model},
    Topic{"stability", "Where methods fail", stability},
};

}  // namespace

std::span<const Topic> topics() { return all; }

const Topic* topic_named(std::string_view name) {
  const auto* const found =
      std::find_if(all.begin(), all.end(), [&](const Topic& topic) { return name == topic.name; });
  return found == all.end() ? nullptr : found;
}

TopicResult stability(const Scenes& scenes, const Effort& effort) {
  TopicResult result;
  if (scenes.planar) result.maps.push_back(toggle_map(scenes, effort));
  result.maps.push_back(stiff_joint_map(scenes, effort));
  result.maps.push_back(resonance_map(scenes, effort));
  result.maps.push_back(thin_section_map(scenes, effort));
  result.maps.push_back(taper_map(scenes, effort));
  return result;
}

}  // namespace boxbeam::charts
