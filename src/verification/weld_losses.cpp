#include "weld_losses.hpp"

#include <algorithm>
#include <array>

#include "boxbeam/verification/judged_section.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"

namespace boxbeam {
namespace {

constexpr std::array sides{Side::before, Side::behind};

/// Of a strength so small plates yield before they buckle; uses are in proportion to it.
constexpr double tiny = 1e-6;

FourWalls stout(FourWalls walls) {
  for (BoxWall& wall : walls.walls) {
    wall.yield_strength *= tiny;
    wall.class_strength *= tiny;
  }
  return walls;
}

PathSection stout(PathSection path) {
  for (PathPlate& plate : path.plates) {
    plate.yield_strength *= tiny;
    plate.class_strength *= tiny;
  }
  for (Stress& strength : path.yield_strengths) strength *= tiny;
  path.lag.clear();
  return path;
}

/// The largest ratio of the uses of two effective sections; below a billionth of the largest use
/// there is only round-off.
template <class Effective>
double largest_ratio(const Effective& effective, const Effective& whole,
                     const std::vector<SituationHistory>& histories) {
  const auto each = [&](const auto& look) {
    for (const SituationHistory& of : histories)
      for (const CutForces& cut : of.history.samples()) look(cut, tiny * whole.use(cut));
  };
  double most = 0.0, largest = 1.0;
  each([&](const CutForces&, double of_whole) { most = std::max(most, of_whole); });
  each([&](const CutForces& cut, double of_whole) {
    if (of_whole > 1e-9 * most) largest = std::max(largest, effective.use(cut) / of_whole);
  });
  return largest;
}

}  // namespace

WeldLoss lag_loss_at(const Project& project, const std::vector<BendingZone>& zones, Length s) {
  WeldLoss loss;
  for (const Side side : sides) {
    const Section section = section_inside(project.beam, {s, side});
    const ShearLags lags = shear_lags_at(zones, section, {s, side});
    if (!lags.count()) continue;
    const SectionProperties whole = properties_of(section);
    const SectionProperties left = effective_properties_of(section, {}, lags);
    loss.N = std::max(loss.N, (whole.area / left.area).value());
    loss.M_y = std::max(loss.M_y, (whole.I_y / left.I_y).value());
    loss.M_z = std::max(loss.M_z, (whole.I_z / left.I_z).value());
  }
  return loss;
}

double buckling_loss_at(const Project& project, const std::vector<BendingZone>& zones, Length s,
                        const std::vector<SituationHistory>& histories) {
  double largest = 1.0;
  for (const Side side : sides) {
    const Station station{s, side};
    if (const auto plates = slender_plates_at(project, zones, station)) {
      // Shear lag is counted beside it, elastic.
      const FourWalls& walls = plates->box.box();
      largest = std::max(largest,
                         largest_ratio(EffectiveBox(walls), EffectiveBox(stout(walls)), histories));
    } else if (const auto path = slender_path_at(project, zones, station)) {
      const EffectivePath whole(stout(path->section.path()));
      largest = std::max(largest, largest_ratio(path->section, whole, histories));
    }
  }
  return largest;
}

WeldLoss operator*(const WeldLoss& loss, double by) {
  return {loss.N * by, loss.M_y * by, loss.M_z * by};
}

SectionProperties less(SectionProperties of, const WeldLoss& loss) {
  of.area /= loss.N;
  of.I_y /= loss.M_y;
  of.I_z /= loss.M_z;
  of.I_yz /= std::max(loss.M_y, loss.M_z);
  of.W_y /= loss.M_y;
  of.W_z /= loss.M_z;
  return of;
}

}  // namespace boxbeam
