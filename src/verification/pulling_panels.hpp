#pragma once

#include <map>
#include <utility>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/bending_zones.hpp"
#include "boxbeam/verification/sheared_plates.hpp"

namespace boxbeam {

/// The plates that may buckle in shear of the panels on both sides of diaphragms, at the places by
/// which what they pull at the diaphragm is judged: half a plate's depth from both edges of the
/// panel, of short panels in the middle. The larger of both is asked for, whichever edge is meant.
/// Source: EN 1993-1-5:2006, 9.3.3(3).
class PullingPanels {
 public:
  struct Panel {
    ShearedWall wall;  ///< of a box by the name of its plate
    Station at;
  };

  PullingPanels(const Project& project, const std::vector<BendingZone>& zones)
      : project_(&project), zones_(&zones) {}

  /// Of the diaphragm at a place; none of panels that it does not bound.
  const std::vector<Panel>& beside(Length s);

 private:
  const std::vector<ShearedWall>& walls_at(const Station& station);
  void add_side(const Station& station, std::vector<Panel>& panels);

  const Project* project_;
  const std::vector<BendingZone>* zones_;
  std::map<double, std::vector<Panel>> beside_;
  std::map<std::pair<double, Side>, std::vector<ShearedWall>> walls_;
};

}  // namespace boxbeam
