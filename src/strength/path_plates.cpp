#include "boxbeam/strength/path_plates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "stiffened_formulas.hpp"

namespace boxbeam {
namespace {

using Eigen::Vector2d;

/// What a wall that meets others at a node goes on as.
struct WallEnd {
  std::size_t wall = 0;
  bool at_from = true;
};

/// Walls in a row along one line, from node to node.
struct Row {
  std::vector<WallEnd> walls;  ///< each by the end that comes first
  std::vector<std::size_t> nodes;
  bool closed = false;  ///< it comes back to its first node
};

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The walls of a path and what meets at its nodes.
class PathWalls {
 public:
  PathWalls(const ThinWalled& path, const PlateMaterials& materials)
      : graph_(*wall_graph_of(Section{path, {}}, {})),
        materials_(&materials),
        given_nodes_(path.nodes.size()) {
    ends_.resize(graph_.nodes.size());
    for (std::size_t i = 0; i < graph_.walls.size(); ++i) {
      ends_[graph_.walls[i].from].push_back({i, true});
      ends_[graph_.walls[i].to].push_back({i, false});
      const bool stub = is_stub(i);
      numbers_.push_back(numbers_.empty() ? 1 : numbers_.back() + (stub ? 0 : 1));
    }
  }

  std::vector<PathPlate> plates() {
    std::vector<PathPlate> plates;
    for (const Row& row : rows()) {
      const std::vector<bool> holds = held_nodes_of(row);
      std::size_t from = 0;
      for (std::size_t k = 1; k <= row.walls.size(); ++k) {
        if (k < row.walls.size() && !holds[k]) continue;
        plates.push_back(plate_of(row, from, k));
        from = k;
      }
    }
    std::erase_if(plates, [](const PathPlate& of) { return !(of.high > of.low); });
    find_lips(plates);
    std::stable_sort(plates.begin(), plates.end(), [](const PathPlate& a, const PathPlate& b) {
      return first_wall_of(a) < first_wall_of(b);
    });
    return plates;
  }

 private:
  static std::size_t first_wall_of(const PathPlate& plate) {
    std::size_t first = plate.parts.front().wall;
    for (const PathPlate::Part& part : plate.parts) first = std::min(first, part.wall);
    return first;
  }

  /// What reaches beyond its node.
  bool is_stub(std::size_t wall) const { return graph_.walls[wall].to >= given_nodes_; }

  std::size_t node_of(const WallEnd& end) const {
    const Wall& wall = graph_.walls[end.wall];
    return end.at_from ? wall.from : wall.to;
  }
  static WallEnd other(const WallEnd& end) { return {end.wall, !end.at_from}; }
  /// From its node away.
  Vector2d direction_of(const WallEnd& end) const {
    const Wall& wall = graph_.walls[end.wall];
    return ((end.at_from ? 1.0 : -1.0) * (graph_.nodes[wall.to] - graph_.nodes[wall.from]))
        .normalized();
  }

  /// The wall that goes straight on where one ends; nothing where none does.
  const WallEnd* straight_on(const WallEnd& end) const {
    const double flat = std::cos(20.0 / 180.0 * std::numbers::pi) + 1e-9;
    const WallEnd* straightest = nullptr;
    double most = flat;
    for (const WallEnd& of : ends_[node_of(end)]) {
      const double along = -direction_of(end).dot(direction_of(of));
      if (of.wall == end.wall || along < most) continue;
      most = along;
      straightest = &of;
    }
    return straightest;
  }
  /// Likewise, where each of both is the straightest of the other.
  const WallEnd* next_of(const WallEnd& end) const {
    const WallEnd* const on = straight_on(end);
    if (on == nullptr) return nullptr;
    const WallEnd* const back = straight_on(*on);
    return back != nullptr && back->wall == end.wall ? on : nullptr;
  }

  std::vector<Row> rows() const {
    std::vector<Row> rows;
    std::vector<bool> taken(graph_.walls.size(), false);
    for (std::size_t i = 0; i < graph_.walls.size(); ++i) {
      if (taken[i]) continue;
      // Back to where the row begins, then along it.
      WallEnd begin{i, true};
      while (const WallEnd* const before = next_of(begin)) {
        if (before->wall == i) break;
        begin = other(*before);
      }
      Row row;
      for (WallEnd at = begin; !taken[at.wall];) {
        taken[at.wall] = true;
        row.walls.push_back(at);
        row.nodes.push_back(node_of(at));
        const WallEnd end = other(at);
        const WallEnd* const next = next_of(end);
        if (next == nullptr || taken[next->wall]) {
          row.nodes.push_back(node_of(end));
          break;
        }
        at = *next;
      }
      row.closed = row.nodes.front() == row.nodes.back();
      rows.push_back(std::move(row));
    }
    return rows;
  }

  static bool is_part(const Row& row, std::size_t wall) {
    return std::any_of(row.walls.begin(), row.walls.end(),
                       [&](const WallEnd& of) { return of.wall == wall; });
  }

  /// What stands on a row at one of its nodes.
  struct Standing {
    double reach = 0.0;    ///< how far from the row
    bool outstand = true;  ///< it is nothing but walls in one line, to a free end
  };
  Standing standing_at(const Row& row, std::size_t node) const {
    const Vector2d first = graph_.nodes[row.nodes.front()];
    const Vector2d along = (graph_.nodes[row.nodes.back()] - first).normalized();
    std::vector<bool> seen(graph_.nodes.size(), false);
    std::vector<std::size_t> open{node};
    std::optional<Vector2d> line;
    Standing of;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      of.reach = std::max(of.reach, std::abs(cross(along, graph_.nodes[at] - first)));
      for (const WallEnd& end : ends_[at]) {
        const std::size_t next = node_of(other(end));
        if (is_part(row, end.wall) || seen[next]) continue;
        const Vector2d direction = direction_of(end);
        if (!line) line = direction;
        const bool back = std::find(row.nodes.begin(), row.nodes.end(), next) != row.nodes.end();
        if (back || std::abs(cross(*line, direction)) > 1e-6) of.outstand = false;
        // Without coming back to the row.
        if (back) continue;
        seen[next] = true;
        open.push_back(next);
      }
    }
    return of;
  }

  /// At which of a row's nodes something holds it.
  std::vector<bool> held_nodes_of(const Row& row) const {
    const std::size_t count = row.nodes.size();
    if (row.closed || count < 3) return std::vector<bool>(count, !row.closed);
    constexpr double of_farthest = 0.5, of_row = 0.25;
    const double length = (graph_.nodes[row.nodes.back()] - graph_.nodes[row.nodes.front()]).norm();
    std::vector<Standing> standing;
    double most = 0.0;
    for (const std::size_t node : row.nodes) {
      standing.push_back(standing_at(row, node));
      most = std::max(most, standing.back().reach);
    }
    const auto reaches = [&](const Standing& of) {
      return of.reach > 0.0 && of.reach >= of_farthest * most;
    };
    std::vector<bool> holds;
    for (const Standing& of : standing)
      holds.push_back(reaches(of) && !of.outstand && of.reach >= of_row * length);
    const bool held = std::find(holds.begin(), holds.end(), true) != holds.end() ||
                      standing.front().reach > 0.0 || standing.back().reach > 0.0;
    // Otherwise what there is holds it: the stem of a T, the webs of a wide deck.
    for (std::size_t k = 0; !held && k < count; ++k) holds[k] = reaches(standing[k]);
    return holds;
  }

  /// How far the walls that meet a row at a node stand into its way.
  double face_at(const Row& row, std::size_t node, const Vector2d& along) const {
    constexpr double least_sine = 0.5;
    double face = 0.0;
    for (const WallEnd& of : ends_[node]) {
      if (is_part(row, of.wall)) continue;
      const double sine = std::abs(cross(along, direction_of(of)));
      face = std::max(face, 0.5 * graph_.walls[of.wall].thickness / std::max(least_sine, sine));
    }
    return face;
  }

  PathPlate plate_of(const Row& row, std::size_t begin, std::size_t end) const {
    PathPlate plate;
    plate.nodes = {row.nodes[begin], row.nodes[end]};
    plate.first = graph_.nodes[row.nodes[begin]];
    plate.direction = (graph_.nodes[row.nodes[end]] - plate.first).normalized();
    double along = 0.0, thinnest = std::numeric_limits<double>::infinity();
    std::vector<std::size_t> numbers;
    Stress least, most;
    bool known = true;
    for (std::size_t k = begin; k < end; ++k) {
      const WallEnd& of = row.walls[k];
      const Wall& wall = graph_.walls[of.wall];
      const double length = (graph_.nodes[wall.to] - graph_.nodes[wall.from]).norm();
      plate.parts.push_back(
          {of.wall, of.at_from ? along : along + length, of.at_from ? along + length : along});
      along += length;
      plate.straight =
          plate.straight && (length == 0.0 || direction_of(of).dot(plate.direction) > 1.0 - 1e-12);
      if (k > begin && ends_[row.nodes[k]].size() > 2) plate.ribbed = true;
      thinnest = std::min(thinnest, wall.thickness);
      numbers.push_back(numbers_[of.wall]);
      const auto yield =
          yield_strength_of(materials_->of(PlateKind::wall), si<Length>(wall.thickness));
      known = known && yield;
      if (!yield) continue;
      least = k == begin ? *yield : std::min(least, *yield);
      most = std::max(most, *yield);
    }
    if (known) {
      plate.yield_strength = least;
      plate.class_strength = most;
    }
    plate.thickness = si<Length>(thinnest);
    plate.name = name_of(plate, std::move(numbers));
    say_ends(row, begin, end, along, plate);
    return plate;
  }

  std::string name_of(const PathPlate& plate, std::vector<std::size_t> numbers) const {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    if (plate.parts.size() == 1 && is_stub(plate.parts.front().wall))
      return fmt::format("wall {} beyond its node", numbers.front());
    return fmt::format("{} {}", numbers.size() > 1 ? "walls" : "wall", fmt::join(numbers, ", "));
  }

  /// The clear width, and which ends are free.
  void say_ends(const Row& row, std::size_t begin, std::size_t end, double length,
                PathPlate& plate) const {
    const auto trim = [&](const WallEnd& at) {
      const Wall& wall = graph_.walls[at.wall];
      return ((at.at_from ? wall.start : wall.end) - graph_.nodes[node_of(at)]).norm();
    };
    const WallEnd first = row.walls[begin], last = other(row.walls[end - 1]);
    const auto face = [&](const WallEnd& at) {
      return std::max(trim(at), face_at(row, node_of(at), direction_of(at)));
    };
    plate.low = face(first);
    plate.high = length - face(last);
    const auto is_free = [&](const WallEnd& at) {
      return !row.closed && ends_[node_of(at)].size() == 1;
    };
    plate.ends = {is_free(first) ? PlateEnd::free : PlateEnd::held,
                  is_free(last) ? PlateEnd::free : PlateEnd::held};
  }

  /// Which ends are held by one outstand alone, and which of those too weakly.
  void find_lips(std::vector<PathPlate>& plates) const {
    for (std::size_t round = 0; round < plates.size(); ++round) {
      bool changed = false;
      for (PathPlate& plate : plates) {
        for (const std::size_t end : {0U, 1U}) {
          if (plate.ends[end] <= PlateEnd::weak) continue;
          const PlateEnd now = end_of(plates, plate, end);
          changed = changed || now != plate.ends[end];
          plate.ends[end] = now;
        }
      }
      if (!changed) return;
    }
  }

  /// What stands at an end of a plate: plates that end there, too, and whether one passes through.
  struct AtEnd {
    std::vector<const PathPlate*> plates;
    bool passes = false;

    /// Nothing but outstands that end there.
    bool outstands() const {
      return !passes && std::all_of(plates.begin(), plates.end(),
                                    [](const PathPlate* of) { return of->outstand(); });
    }
  };
  AtEnd at_end(const std::vector<PathPlate>& plates, const PathPlate& plate,
               std::size_t end) const {
    const std::size_t node = plate.nodes[end];
    AtEnd at;
    for (const PathPlate& of : plates) {
      if (&of == &plate) continue;
      const bool meets = std::any_of(of.parts.begin(), of.parts.end(), [&](const auto& part) {
        return graph_.walls[part.wall].from == node || graph_.walls[part.wall].to == node;
      });
      if (of.nodes[0] == node || of.nodes[1] == node)
        at.plates.push_back(&of);
      else if (meets)
        at.passes = true;
    }
    return at;
  }

  PlateEnd end_of(const std::vector<PathPlate>& plates, const PathPlate& plate,
                  std::size_t end) const {
    const AtEnd here = at_end(plates, plate, end), opposite = at_end(plates, plate, 1 - end);
    // Only a stub within the wall that it stands on.
    if (!here.passes && here.plates.empty()) return PlateEnd::weak;
    if (!here.outstands()) return PlateEnd::held;
    if (!holds(here.plates, plate)) return PlateEnd::weak;
    if (here.plates.size() > 1) return PlateEnd::held;
    const bool otherwise = plate.ends[1 - end] > PlateEnd::weak &&
                           (opposite.plates.size() > 1 || !opposite.outstands());
    constexpr double least_lip = 0.2;
    const bool narrow = here.plates.front()->clear() < least_lip * plate.clear();
    return otherwise && narrow ? PlateEnd::weak : PlateEnd::lip;
  }

  /// Outstands at one end of a plate, as one edge stiffener of all their widths.
  static bool holds(const std::vector<const PathPlate*>& outstands, const PathPlate& plate) {
    if (!(plate.class_strength > Stress{})) return false;
    const double S = 1.28 * std::sqrt((stiffened::youngs_modulus / plate.class_strength).value());
    const double t = plate.thickness.value();
    const double slender = plate.clear().value() / t / S;
    constexpr double needs_none = 0.328;
    if (slender <= needs_none) return true;
    const double wanted =
        std::pow(t, 4) * std::min(399.0 * std::pow(slender - needs_none, 3), 115.0 * slender + 5.0);
    double width = 0.0, thinnest = std::numeric_limits<double>::infinity();
    for (const PathPlate* const of : outstands) {
      const double sine = std::abs(cross(plate.direction, of->direction));
      // Whatever lies in the plate's own line does not stiffen it.
      if (sine < 1e-6) continue;
      width += of->clear().value() * std::pow(sine, 2.0 / 3.0);
      thinnest = std::min(thinnest, of->thickness.value());
    }
    return width > 0.0 && std::pow(width, 3) * thinnest / 12.0 >= wanted;
  }

  WallGraph graph_;
  const PlateMaterials* materials_;
  std::size_t given_nodes_;
  std::vector<std::vector<WallEnd>> ends_;  ///< by node
  std::vector<std::size_t> numbers_;        ///< of the path's walls, by wall of the graph
};

}  // namespace

std::vector<PathPlate> plates_of(const ThinWalled& path, const PlateMaterials& materials) {
  return PathWalls(path, materials).plates();
}

std::string width_obstacle(const PathPlate& plate) {
  const auto ends_by = [&](PlateEnd by) {
    return static_cast<int>(plate.ends[0] == by) + static_cast<int>(plate.ends[1] == by);
  };
  if (!plate.straight) return plate.name + ": a fold below 20 deg makes it neither one nor two";
  if (plate.ribbed) return plate.name + ": a rib stands on it (4.5 is for boxes)";
  if (ends_by(PlateEnd::weak) > 0)
    return plate.name + ": the outstand at its edge is too weak to hold it (EN 1993-1-3, 5.5.3)";
  if (ends_by(PlateEnd::free) == 2) return plate.name + ": nothing holds it";
  if (ends_by(PlateEnd::lip) == 1 && ends_by(PlateEnd::held) == 1) {
    return plate.name +
           ": a lip alone holds its edge, which may buckle with it (EN 1993-1-3, 5.5.3)";
  }
  return "";
}

}  // namespace boxbeam
