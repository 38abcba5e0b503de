#include "pulling_panels.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "plate_panels.hpp"

namespace boxbeam {

const std::vector<ShearedWall>& PullingPanels::walls_at(const Station& station) {
  const auto [known, is_new] = walls_.try_emplace({station.s.value(), station.side});
  std::vector<ShearedWall>& walls = known->second;
  if (!is_new) return walls;
  if (const auto path = slender_path_at(*project_, *zones_, station)) return walls = path->sheared;
  const auto box = slender_plates_at(*project_, *zones_, station);
  if (!box) return walls;
  for (const ShearedPlate& plate : box->sheared) {
    walls.push_back(plate);
    walls.back().name = to_text(plate.plate);
  }
  // Of webs that are stressed alike the left one is there for both.
  using enum BoxPlate;
  const auto of = [&](BoxPlate plate) {
    return std::find_if(box->sheared.begin(), box->sheared.end(),
                        [&](const ShearedPlate& at) { return at.plate == plate; });
  };
  if (of(right_web) == box->sheared.end() && of(left_web) != box->sheared.end()) {
    walls.push_back(*of(left_web));
    walls.back().name = to_text(right_web);
  }
  return walls;
}

void PullingPanels::add_side(const Station& station, std::vector<Panel>& panels) {
  const Supports supports = supports_around(project_->beam, station);
  if (!supports.before || !supports.behind) return;
  const bool onward = station.side == Side::behind;
  const Side inward = onward ? Side::before : Side::behind;
  const Length far = onward ? *supports.behind : *supports.before, length = far - station.s;
  const bool here = !walls_at(station).empty();
  for (const ShearedWall& wall : walls_at(here ? station : Station{far, inward})) {
    const double half = std::min(0.5, 0.5 * wall.panel.depth.value() / std::abs(length.value()));
    for (const double part : {half, 1.0 - half}) {
      const Station at{station.s + part * length, inward};
      const std::vector<ShearedWall>& walls = walls_at(at);
      const auto there = std::find_if(walls.begin(), walls.end(),
                                      [&](const ShearedWall& of) { return of.name == wall.name; });
      // Where the walls of a path are others its own one is as good.
      const ShearedWall& of = there == walls.end() ? wall : *there;
      if (of.may_buckle && of.panel.length) panels.push_back({of, at});
    }
  }
}

const std::vector<PullingPanels::Panel>& PullingPanels::beside(Length s) {
  const auto [known, is_new] = beside_.try_emplace(s.value());
  if (!is_new) return known->second;
  for (const Side side : {Side::before, Side::behind}) {
    if (side == Side::before ? s > Length{} : s < project_->beam.length())
      add_side({s, side}, known->second);
  }
  return known->second;
}

}  // namespace boxbeam
