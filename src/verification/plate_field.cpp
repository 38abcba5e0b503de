#include "boxbeam/verification/plate_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/section/normal_stress.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t across = 8;  ///< quads of a wall
constexpr std::size_t across_stiffener = 2;
constexpr int solid_part = 8;

/// The middle plane of a solid rectangle: its longer side.
std::array<Eigen::Vector2d, 2> middle_of(const Plate& plate) {
  const double y = 0.5 * plate.width.value(), z = 0.5 * plate.height.value();
  if (z >= y) return {Eigen::Vector2d(0.0, -z), Eigen::Vector2d(0.0, z)};
  return {Eigen::Vector2d(-y, 0.0), Eigen::Vector2d(y, 0.0)};
}

/// A line across the section that becomes a strip of quads.
struct Line {
  bool solid = false;
  std::size_t wall = 0;
  std::size_t pieces = across;
};

std::vector<Line> lines_of(const StressField& field) {
  std::vector<Line> lines;
  if (!field.flow) {
    if (std::holds_alternative<Plate>(field.section.outer)) lines.push_back({true, 0, across});
    return lines;
  }
  const std::vector<Wall>& walls = field.flow->at.graph.walls;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (length_of(walls[i]) <= 0.0) continue;
    lines.push_back({false, i, walls[i].part == WallPart::stiffener ? across_stiffener : across});
  }
  return lines;
}

class FieldBuilder {
 public:
  FieldBuilder(const Project& project, const CutForceDiagram& diagram)
      : project_(&project), diagram_(&diagram) {}

  PlateField build() {
    for (const BeamSteps& steps : steps_along(project_->beam, *diagram_, 0.25)) add(steps);
    return std::move(field_);
  }

 private:
  void add(const BeamSteps& steps) {
    std::vector<std::size_t> before;
    std::vector<double> thickness_before;
    for (std::size_t i = 0; i < steps.stations.size(); ++i) {
      const Station& station = steps.stations[i];
      const CutForces cut = diagram_->at(station);
      field_.axis.push_back({station, cut});
      const MidlineStress stress(*project_, station);
      const std::vector<Line> lines = lines_of(stress.field());
      if (i == 0 && lines.empty()) note_left_out(steps.segment);
      std::vector<std::size_t> first;
      std::vector<double> thickness;
      for (const Line& line : lines) {
        first.push_back(field_.nodes.size());
        thickness.push_back(add_line(stress, line, station, cut));
      }
      for (std::size_t k = 0; i > 0 && k < lines.size(); ++k) {
        const double mean = 0.5 * (thickness_before[k] + thickness[k]);
        add_quads(stress, lines[k], before[k], first[k], mean, steps.segment);
      }
      before = std::move(first);
      thickness_before = std::move(thickness);
    }
  }

  void note_left_out(std::size_t segment) {
    const Segment& of = project_->beam.segments[segment];
    std::string words = of.name + ": " + to_text(of.from.outer);
    if (std::find(field_.left_out.begin(), field_.left_out.end(), words) == field_.left_out.end())
      field_.left_out.push_back(std::move(words));
  }

  /// Adds the nodes of a line; returns its thickness.
  double add_line(const MidlineStress& stress, const Line& line, const Station& station,
                  const CutForces& cut) {
    for (std::size_t j = 0; j <= line.pieces; ++j) {
      const double fraction = static_cast<double>(j) / static_cast<double>(line.pieces);
      Eigen::Vector2d at;
      PointStress here;
      if (line.solid) {
        const auto [a, b] = middle_of(std::get<Plate>(stress.field().section.outer));
        at = a + fraction * (b - a);
        here = stress_at(point_in_solid(stress.field(), "", at.x(), at.y()).influence, cut);
      } else {
        at = point_on(stress.field().flow->at.graph.walls[line.wall], fraction);
        here = stress.on_wall(line.wall, fraction, cut);
      }
      field_.nodes.push_back({{station.s.value(), at.x(), at.y()}, here});
    }
    if (!line.solid) return stress.field().flow->at.graph.walls[line.wall].thickness;
    const auto& plate = std::get<Plate>(stress.field().section.outer);
    return std::min(plate.width, plate.height).value();
  }

  void add_quads(const MidlineStress& stress, const Line& line, std::size_t before,
                 std::size_t behind, double thickness, std::size_t segment) {
    for (std::size_t j = 0; j < line.pieces; ++j) {
      PlateQuad quad;
      quad.nodes = {before + j, behind + j, behind + j + 1, before + j + 1};
      quad.thickness = thickness;
      quad.segment = segment + 1;
      quad.part = solid_part;
      if (!line.solid) {
        const Wall& wall = stress.field().flow->at.graph.walls[line.wall];
        quad.part = static_cast<int>(wall.part) + 1;
        quad.inner = wall.inner;
      }
      field_.quads.push_back(quad);
    }
  }

  const Project* project_;
  const CutForceDiagram* diagram_;
  PlateField field_;
};

}  // namespace

std::optional<ShownLoads> governing_loads(const Project& project,
                                          const std::deque<SituationRun>& runs,
                                          const Verification& verification) {
  const CheckResult* const check = first_by_cut_forces(verification.checks);
  if (check == nullptr || !check->basis) return std::nullopt;
  return ShownLoads{check, &run_of(runs, project.situations[check->basis->running]),
                    check->check.time};
}

MidlineStress::MidlineStress(const Project& project, const Station& station)
    : field_(stress_field_of(section_at(project.beam, station), {},
                             taper_at(project.beam, station))) {}

PointStress MidlineStress::on_wall(std::size_t wall, double fraction, const CutForces& cut) const {
  const Wall& of = field_.flow->at.graph.walls[wall];
  const Eigen::Vector2d at = point_on(of, fraction);
  StressInfluence influence = normal_influence(field_.sums, at.x(), at.y());
  const CutFactors flow = flow_at(*field_.flow, wall, fraction);
  for (std::size_t k = 0; k < cut_force::count; ++k)
    influence.shear[k] = flow[static_cast<Eigen::Index>(k)] / of.thickness;
  return stress_at(influence, cut);
}

PointStress MidlineStress::near(WallPart part, bool inner, double y, double z,
                                const CutForces& cut) const {
  if (!field_.flow) return stress_at(point_in_solid(field_, "", y, z).influence, cut);
  const Eigen::Vector2d at(y, z);
  std::size_t nearest = 0;
  double fraction = 0.0, least = std::numeric_limits<double>::infinity();
  const std::vector<Wall>& walls = field_.flow->at.graph.walls;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const Wall& wall = walls[i];
    if (wall.part != part || wall.inner != inner || length_of(wall) <= 0.0) continue;
    const Eigen::Vector2d along = wall.end - wall.start;
    const double here = std::clamp((at - wall.start).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double apart = (wall.start + here * along - at).norm();
    if (apart >= least) continue;
    least = apart;
    nearest = i;
    fraction = here;
  }
  PointStress stress = on_wall(nearest, fraction, cut);
  stress.normal = stress_at(normal_influence(field_.sums, y, z), cut).normal;
  return stress;
}

PlateField plate_field_of(const Project& project, const CutForceDiagram& diagram) {
  return FieldBuilder(project, diagram).build();
}

std::vector<BeamSteps> steps_along(const TaperedBeam& beam, const CutForceDiagram& diagram,
                                   double part_of_height) {
  std::vector<Length> borders;
  for (const Segment& segment : beam.segments) borders.push_back(segment.start);
  borders.push_back(beam.length());
  const std::vector<Length> known = places_of(beam);
  for (const CutForcePiece& piece : diagram.pieces)
    borders.push_back(place_near(known, piece.start));
  std::sort(borders.begin(), borders.end());
  const Length close = 1e-9 * beam.length();
  borders.erase(std::unique(borders.begin(), borders.end(),
                            [&](Length a, Length b) { return b - a <= close; }),
                borders.end());
  borders.back() = beam.length();
  std::vector<BeamSteps> all;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    const Length from = borders[i], to = borders[i + 1];
    BeamSteps steps;
    steps.segment = segment_at(beam, {from, Side::behind});
    const Length height = 0.5 * (height_of(section_at(beam, {from, Side::behind}).outer) +
                                 height_of(section_at(beam, {to, Side::before}).outer));
    constexpr int most = 400;
    const int count = std::clamp(
        static_cast<int>(std::ceil((to - from).value() / (part_of_height * height.value()))), 1,
        most);
    for (int k = 0; k <= count; ++k) {
      const Side side = k == 0 ? Side::behind : k == count ? Side::before : Side::both;
      const Length s = k == count ? to : from + (to - from) * (static_cast<double>(k) / count);
      steps.stations.push_back({s, side});
    }
    all.push_back(std::move(steps));
  }
  return all;
}

}  // namespace boxbeam
