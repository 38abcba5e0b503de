#include "boxbeam/verification/shell_model.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>

#include "mid_lines.hpp"

namespace boxbeam {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The length of an element along the beam, of the section's height.
constexpr double part_of_height = 0.2;

/// A profile at a section of the model, and its nodes by position.
struct Ring {
  MidLines lines;
  std::vector<std::size_t> nodes;
};

/// What of the loads a section takes.
struct Wrench {
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();  ///< about the axis there
};

/// A section that takes loads: its profiles, each node once.
struct LoadedSection {
  double s = 0.0;
  std::vector<Ring> rings;
  Wrench wrench;
};

/// The loads of a node of a section, of one kind each.
struct NodeShare {
  Vector2d place = Vector2d::Zero();
  double area = 0.0, along_y = 0.0, along_z = 0.0;
  Vector2d flow = Vector2d::Zero();  ///< of each ring times its share of the torque
};

class ShellBuilder {
 public:
  ShellBuilder(const Project& project, const BeamLoads& loads, const CutForceDiagram& diagram)
      : project_(&project), loads_(&loads), diagram_(&diagram) {}

  ShellModel build() {
    for (const BeamSteps& steps : steps_along(project_->beam, *diagram_, part_of_height))
      add(steps);
    share_loads();
    for (const LoadedSection& section : sections_) spread(section);
    hold();
    note_simplified();
    return std::move(model_);
  }

 private:
  Ring new_ring(const MidLines& lines, double s, bool middle) {
    Ring ring{lines, std::vector<std::size_t>(lines.count(), 0)};
    for (std::size_t p = 0; p < lines.count(); p += middle ? 2 : 1) {
      const Vector2d at = lines.at(p);
      ring.nodes[p] = model_.nodes.size();
      model_.nodes.emplace_back(s, at.x(), at.y());
    }
    return ring;
  }

  /// The first rings of a stretch: those of the stretch before where the profile goes on, else new
  /// ones, and the whole section moves as one body.
  std::vector<Ring> first_rings(const std::vector<MidLines>& profiles, double s) {
    if (sections_.empty()) {
      LoadedSection& first = sections_.emplace_back();
      first.s = s;
      for (const MidLines& lines : profiles) first.rings.push_back(new_ring(lines, s, false));
      return first.rings;
    }
    LoadedSection& border = sections_.back();
    std::vector<Ring> rings;
    std::vector<bool> used(border.rings.size(), false);
    bool broken = profiles.size() != border.rings.size();
    const std::size_t before = border.rings.size();
    for (const MidLines& lines : profiles) {
      std::size_t k = 0;
      while (k < before && (used[k] || !same_corners(border.rings[k].lines, lines))) ++k;
      if (k < before) {
        used[k] = true;
        rings.push_back({lines, border.rings[k].nodes});
        continue;
      }
      broken = true;
      rings.push_back(new_ring(lines, s, false));
      border.rings.push_back(rings.back());
    }
    if (!broken) return rings;
    std::vector<std::size_t>& body = model_.rigid.emplace_back();
    for (const Ring& ring : border.rings)
      body.insert(body.end(), ring.nodes.begin(), ring.nodes.end());
    return rings;
  }

  void add(const BeamSteps& steps) {
    const TaperedBeam& beam = project_->beam;
    std::vector<Ring> before;
    for (std::size_t i = 0; i < steps.stations.size(); ++i) {
      const Station& station = steps.stations[i];
      const double s = station.s.value();
      const std::vector<MidLines> profiles = mid_lines_of(section_at(beam, station));
      if (i == 0) {
        before = first_rings(profiles, s);
        continue;
      }
      const Length middle = 0.5 * (steps.stations[i - 1].s + station.s);
      const std::vector<MidLines> halfway = mid_lines_of(section_at(beam, {middle, Side::both}));
      LoadedSection& section = sections_.emplace_back();
      section.s = s;
      const Station centre{middle, Side::both};
      const MidlineStress stress(*project_, centre);
      const CutForces cut = diagram_->at(centre);
      for (std::size_t k = 0; k < profiles.size(); ++k) {
        const Ring between = new_ring(halfway[k], middle.value(), true);
        if (!first_between_) first_between_ = between;
        if (k == 0) last_between_ = between;
        section.rings.push_back(new_ring(profiles[k], s, false));
        add_elements(before[k], between, section.rings.back(), steps.segment, centre, stress, cut);
      }
      before = section.rings;
    }
  }

  std::size_t set_of(std::size_t segment, const MidLines& lines, std::size_t plate) {
    const bool inner = lines.inner;
    const Segment& of = project_->beam.segments[segment];
    const auto thickness_in = [&](const Section& section) {
      return mid_lines_of(section)[inner ? 1 : 0].plates[plate].thickness;
    };
    std::string name = fmt::format("SEG{}_{}", segment + 1, inner ? "INNER_" : "");
    for (const char c : std::string(
             part_names[lines.closed ? static_cast<std::size_t>(lines.plates[plate].part) + 1 : 8]))
      name += c == ' ' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (thickness_in(of.from) != thickness_in(of.to))
      name += fmt::format("_STEP{}", sections_.size() - 1);
    const auto [found, is_new] = set_index_.try_emplace(name, model_.sets.size());
    if (is_new) model_.sets.push_back({name, lines.plates[plate].thickness});
    return found->second;
  }

  void add_elements(const Ring& a, const Ring& middle, const Ring& b, std::size_t segment,
                    const Station& centre, const MidlineStress& stress, const CutForces& cut) {
    const MidLines& lines = middle.lines;
    for (std::size_t plate = 0; plate < lines.plates.size(); ++plate) {
      const std::size_t set = set_of(segment, lines, plate);
      for (std::size_t j = 0; j < columns_across; ++j) {
        const std::size_t p = plate * positions_of_plate + 2 * j;
        const std::size_t half = lines.next(p, 1), end = lines.next(p, 2);
        ShellElement element;
        element.nodes = {a.nodes[p],      b.nodes[p],    b.nodes[end],      a.nodes[end],
                         middle.nodes[p], b.nodes[half], middle.nodes[end], a.nodes[half]};
        element.set = set;
        element.centre = centre;
        const Vector2d at = lines.at(half);
        element.y = at.x();
        element.z = at.y();
        element.part = lines.closed ? static_cast<int>(lines.plates[plate].part) + 1 : 8;
        element.stress = stress.near(lines.plates[plate].part, lines.inner, at.x(), at.y(), cut);
        const Vector2d along = lines.at(end) - lines.at(p);
        const Vector2d moved = b.lines.at(half) - a.lines.at(half);
        const double step = (model_.nodes[b.nodes[half]] - model_.nodes[a.nodes[half]]).x();
        const bool upright = std::abs(along.y()) > std::abs(along.x());
        element.shear_in_section =
            element.stress.shear + (upright ? moved.y() : moved.x()) / step * element.stress.normal;
        model_.elements.push_back(element);
      }
    }
  }

  /// Gives every load to the sections beside it, with parts that keep its force and its moment.
  void share_loads() {
    const auto give = [&](double s, const Vector3d& force, const Vector3d& moment) {
      std::size_t k = 0;
      while (k + 2 < sections_.size() && sections_[k + 1].s <= s) ++k;
      const double from = sections_[k].s, to = sections_[k + 1].s;
      const double part = std::clamp((s - from) / (to - from), 0.0, 1.0);
      sections_[k].wrench.force += (1.0 - part) * force;
      sections_[k].wrench.moment += (1.0 - part) * moment;
      sections_[k + 1].wrench.force += part * force;
      sections_[k + 1].wrench.moment += part * moment;
    };
    for (const PointLoad& load : loads_->points) give(load.s.value(), load.force, load.moment);
    // Gauss' rule of four points in every stretch between sections: exact.
    constexpr std::array place{0.3399810435848563, 0.8611363115940526};
    constexpr std::array weight{0.6521451548625461, 0.3478548451374538};
    for (const LineLoad& line : loads_->lines) {
      const double start = line.start.value(), end = start + line.length.value();
      for (std::size_t k = 0; k + 1 < sections_.size(); ++k) {
        const double from = std::max(start, sections_[k].s);
        const double to = std::min(end, sections_[k + 1].s);
        if (to <= from) continue;
        for (std::size_t g = 0; g < 4; ++g) {
          const double xi = (g % 2 == 0 ? 1.0 : -1.0) * place[g / 2];
          const double s = 0.5 * (from + to) + 0.5 * (to - from) * xi;
          const double w = 0.5 * (to - from) * weight[g / 2];
          Vector3d force, moment;
          for (std::size_t c = 0; c < 3; ++c) {
            force[static_cast<Eigen::Index>(c)] = w * line.force[c](s - start);
            moment[static_cast<Eigen::Index>(c)] = w * line.couple[c](s - start);
          }
          give(s, force, moment);
        }
      }
    }
  }

  /// Spreads a section's load over its nodes.
  void spread(const LoadedSection& section) {
    std::map<std::size_t, NodeShare> shares;
    double cells = 0.0;  // sum of squares of twice the enclosed areas
    for (const Ring& ring : section.rings) {
      const double enclosed = twice_enclosed(ring.lines);
      cells += enclosed * enclosed;
      for (std::size_t plate = 0; plate < ring.lines.plates.size(); ++plate)
        take_plate(ring, plate, enclosed, shares);
    }
    Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
    double along_y = 0.0, along_z = 0.0;
    for (const auto& [node, share] : shares) {
      const Vector3d one(1.0, share.place.x(), share.place.y());
      sums += share.area * one * one.transpose();
      along_y += share.along_y;
      along_z += share.along_z;
    }
    const Wrench& load = section.wrench;
    // Of a plate in the plane nothing acts across it.
    if (along_y == 0.0) sums(1, 1) = 1.0;
    const Vector3d plane =
        sums.fullPivLu().solve(Vector3d(load.force.x(), -load.moment.z(), load.moment.y()));
    double torque = load.moment.x();
    std::map<std::size_t, Vector3d> forces;
    for (const auto& [node, share] : shares) {
      Vector3d& force = forces[node];
      force.x() = share.area * plane.dot(Vector3d(1.0, share.place.x(), share.place.y()));
      if (along_y > 0.0) force.y() = load.force.y() * share.along_y / along_y;
      force.z() = load.force.z() * share.along_z / along_z;
      torque -= share.place.x() * force.z() - share.place.y() * force.y();
    }
    for (auto& [node, force] : forces) {
      if (cells > 0.0) {
        force.y() += torque / cells * shares[node].flow.x();
        force.z() += torque / cells * shares[node].flow.y();
      }
      if (!force.isZero(0.0)) model_.forces.push_back({node, force});
    }
  }

  static double twice_enclosed(const MidLines& lines) {
    if (!lines.closed) return 0.0;
    double sum = 0.0;
    for (const PlateLine& plate : lines.plates) {
      const Vector2d a = lines.corners[plate.from], b = lines.corners[plate.to];
      sum += a.x() * b.y() - a.y() * b.x();
    }
    return sum;
  }

  /// The parts of a plate's nodes: of the edge of an element of eight nodes a sixth, four sixths, a
  /// sixth.
  static void take_plate(const Ring& ring, std::size_t plate, double enclosed,
                         std::map<std::size_t, NodeShare>& shares) {
    const MidLines& lines = ring.lines;
    const PlateLine& of = lines.plates[plate];
    const Vector2d edge = (lines.corners[of.to] - lines.corners[of.from]) / columns_across;
    const bool upright = std::abs(edge.y()) > std::abs(edge.x());
    for (std::size_t j = 0; j < columns_across; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t p = lines.next(plate * positions_of_plate + 2 * j, k);
        const double sixths = k == 1 ? 4.0 / 6.0 : 1.0 / 6.0;
        const double area = sixths * edge.norm() * of.thickness;
        NodeShare& share = shares[ring.nodes[p]];
        share.place = lines.at(p);
        share.area += area;
        (upright ? share.along_z : share.along_y) += area;
        share.flow += enclosed * sixths * edge;
      }
    }
  }

  /// Six freedoms of nodes that no load acts on, so that what they bear is their reaction.
  void hold() {
    const Ring &first = *first_between_, &last = *last_between_;
    for (const int direction : {0, 1, 2}) model_.held.push_back({first.nodes[0], direction});
    for (const int direction : {1, 2}) model_.held.push_back({last.nodes[0], direction});
    model_.held.push_back({first.nodes[positions_of_plate], first.lines.closed ? 2 : 1});
  }

  void note_simplified() {
    const auto any = [&](const auto& is) {
      return std::any_of(project_->beam.segments.begin(), project_->beam.segments.end(),
                         [&](const Segment& of) {
                           return is(of.from.outer) || (of.from.inner && is(*of.from.inner));
                         });
    };
    if (!project_->holes.empty()) model_.simplified.emplace_back("holes are left out");
    if (any([](const Profile& of) {
          const auto* box = std::get_if<Box>(&of);
          return box != nullptr && !box->stiffeners.empty();
        }))
      model_.simplified.emplace_back("stiffeners are left out");
    if (any([](const Profile& of) {
          const auto* tube = std::get_if<RectangularTube>(&of);
          return tube != nullptr && tube->outer_radius.value() > 0.0;
        }))
      model_.simplified.emplace_back("rounded corners are taken sharp");
    if (!model_.rigid.empty())
      model_.simplified.emplace_back(
          "sections where a profile begins, ends or jumps are held rigid");
  }

  const Project* project_;
  const BeamLoads* loads_;
  const CutForceDiagram* diagram_;
  ShellModel model_;
  std::vector<LoadedSection> sections_;
  std::map<std::string, std::size_t> set_index_;
  std::optional<Ring> first_between_, last_between_;  ///< halfway along the first and last elements
};

}  // namespace

std::string obstacle_to_shells(const Project& project) {
  for (const Segment& segment : project.beam.segments) {
    const auto words = [&](const Profile& profile) -> std::string {
      constexpr std::array names{"box",   "rectangular tube", "round tube",
                                 "plate", "polygon",          "thin-walled path"};
      if (std::holds_alternative<Plate>(profile))
        return project.in_space ? "plate in space" : "flat plate";
      return names[profile.index()];
    };
    const auto unknown = [&](const Profile& profile) {
      const std::optional<MidLines> lines = mid_lines_of(profile);
      return !lines || (project.in_space && !lines->closed);
    };
    if (unknown(segment.from.outer))
      return fmt::format("{} (segment {})", words(segment.from.outer), segment.name);
    if (segment.from.inner && unknown(*segment.from.inner))
      return fmt::format("{} inside (segment {})", words(*segment.from.inner), segment.name);
    if (unknown(segment.to.outer))
      return fmt::format("{} (segment {})", words(segment.to.outer), segment.name);
  }
  return "";
}

ShellModel shell_model_of(const Project& project, const BeamLoads& loads,
                          const CutForceDiagram& diagram) {
  assert(obstacle_to_shells(project).empty());
  return ShellBuilder(project, loads, diagram).build();
}

}  // namespace boxbeam
