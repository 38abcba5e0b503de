#pragma once

#include <algorithm>
#include <numbers>
#include <set>
#include <vector>

#include "boxbeam/mechanism/frame/statics.hpp"
#include "boxbeam/section/torsion.hpp"
#include "support/space_frame.hpp"

namespace test {

/// A structure under loads as a `SpaceFrame`: members of solid, round and doubly symmetric box
/// sections. Tapered segments become so many prismatic pieces of the section in their middle.
class FrameByStiffness {
 public:
  /// Of a member at a node of it; at its ends one of the cuts is zero.
  struct Station {
    int member = 0;
    double s = 0.0;
    SpaceFrame::Vector6 motion, before, behind;
  };

  FrameByStiffness(const boxbeam::frame::Structure& of, const boxbeam::frame::ActingLoads& loads,
                   int pieces = 1)
      : structure_(of), frame_(of.plane) {
    for (std::size_t m = 0; m < of.members.size(); ++m)
      add_member(static_cast<int>(m), loads, pieces);
    for (const auto& load : loads.points)
      frame_.add_load(end_of(load.action.at), load.action.force, load.action.moment);
    for (std::size_t j = 0; j < of.joints.size(); ++j) {
      const boxbeam::frame::Joint& joint = of.joints[j];
      SpaceFrame::Vector6 shifted = SpaceFrame::Vector6::Zero();
      for (const auto& settlement : loads.settlements) {
        if (settlement.joint != static_cast<int>(j)) continue;
        shifted.head<3>() += joint.axes.transpose() * settlement.shift;
        shifted.tail<3>() += joint.axes.transpose() * settlement.turn;
      }
      frame_.add_joint(end_of(joint.a), end_of(joint.b), joint.axes, joint.stiffness, shifted);
    }
    solution_ = frame_.solve();
  }

  const SpaceFrame::Solution& solution() const { return solution_; }

  std::vector<Station> stations() const {
    std::vector<Station> result;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      Station of{nodes_[n].member, nodes_[n].s, solution_.nodes[n], {}, {}};
      of.before = of.behind = SpaceFrame::Vector6::Zero();
      for (std::size_t e = 0; e < elements_.size(); ++e) {
        if (elements_[e].second == n) of.before = solution_.cuts[e][1];
        if (elements_[e].first == n) of.behind = solution_.cuts[e][0];
      }
      result.push_back(of);
    }
    return result;
  }

 private:
  static constexpr double same_place = 1e-12;  ///< apart by round-off only [m]

  struct Node {
    int member = 0;
    double s = 0.0;
  };

  /// By hand but for the torsion of boxes, which has tests of its own.
  static SpaceFrame::Stiffness stiffness_of(const boxbeam::Section& section, double E, double G) {
    const double pi = std::numbers::pi;
    if (const auto* tube = std::get_if<boxbeam::RoundTube>(&section.outer)) {
      const double D = tube->diameter.value(), d = D - 2.0 * tube->wall.value();
      const double A = pi / 4.0 * (D * D - d * d),
                   I = pi / 64.0 * (std::pow(D, 4) - std::pow(d, 4));
      return {E * A, G * A * 2.0 / pi, G * A * 2.0 / pi, G * 2.0 * I, E * I, E * I};
    }
    if (const auto* box = std::get_if<boxbeam::Box>(&section.outer)) {
      const double b = box->width.value(), h = box->height.value();
      const double t_f = box->top_flange.value(), t_w = box->left_web.value();
      const double clear_b = b - 2.0 * t_w, clear_h = h - 2.0 * t_f;
      return {E * (b * h - clear_b * clear_h),
              G * 2.0 * t_f * b,
              G * 2.0 * t_w * h,
              G * boxbeam::torsion_constant_of_box(*box).value(),
              E * (b * h * h * h - clear_b * std::pow(clear_h, 3)) / 12.0,
              E * (h * b * b * b - clear_h * std::pow(clear_b, 3)) / 12.0};
    }
    const auto& plate = std::get<boxbeam::Plate>(section.outer);
    const double b = plate.width.value(), h = plate.height.value(), A = b * h;
    // Source: Timoshenko, Goodier, article 109, summed as it stands.
    const double thin = std::min(b, h), wide = std::max(b, h);
    double sum = 0.0;
    for (int n = 1; n < 600; n += 2) sum += std::tanh(0.5 * n * pi * wide / thin) / std::pow(n, 5);
    const double I_T =
        thin * thin * thin * wide * (1.0 / 3.0 - 64.0 / std::pow(pi, 5) * thin / wide * sum);
    return {E * A,   G * A * 5.0 / 6.0,        G * A * 5.0 / 6.0,
            G * I_T, E * b * h * h * h / 12.0, E * h * b * b * b / 12.0};
  }

  static double area_of(const boxbeam::Section& section) {
    return stiffness_of(section, 1.0, 1.0).EA;
  }

  void add_member(int m, const boxbeam::frame::ActingLoads& loads, int pieces) {
    using boxbeam::Segment;
    const boxbeam::frame::Member& member = structure_.members[static_cast<std::size_t>(m)];
    std::set<double> stations;
    const auto add = [&](double s) {
      const auto next = stations.lower_bound(s - same_place);
      if (next == stations.end() || *next > s + same_place) stations.insert(s);
    };
    // Where cut forces jump first: these places stay as they are written.
    for (const auto& joint : structure_.joints) {
      for (const auto* at : {&joint.a, &joint.b}) {
        if (at->member == m) add(at->p.x());
      }
    }
    for (const auto& load : loads.points) {
      if (load.action.at.member == m) add(load.action.at.p.x());
    }
    add(0.0);
    for (const Segment& segment : member.beam.segments) {
      add(segment.end().value());
      if (segment.from == segment.to) continue;
      for (int k = 1; k < pieces; ++k)
        add((segment.start + segment.length * (1.0 * k / pieces)).value());
    }
    for (const auto& line : loads.lines) {
      if (line.member != m) continue;
      add(line.from);
      add(line.to);
    }
    const auto first = static_cast<int>(nodes_.size());
    for (const double s : stations) {
      nodes_.push_back({m, s});
      frame_.add_node();
    }
    for (int node = first; node + 1 < static_cast<int>(nodes_.size()); ++node) {
      const double from = nodes_[static_cast<std::size_t>(node)].s;
      const double to = nodes_[static_cast<std::size_t>(node) + 1].s, middle = 0.5 * (from + to);
      const auto segment =
          std::find_if(member.beam.segments.begin(), member.beam.segments.end() - 1,
                       [&](const Segment& candidate) { return middle < candidate.end().value(); });
      const boxbeam::Section section = boxbeam::interpolate(
          segment->from, segment->to, (middle - segment->start.value()) / segment->length.value());
      const int element =
          frame_.add_element(node, node + 1, to - from, member.axes,
                             stiffness_of(section, member.youngs_modulus, member.shear_modulus));
      elements_.emplace_back(node, node + 1);
      Eigen::Vector3d start =
          loads.weight * member.beam.density.value() * area_of(section) * structure_.gravity;
      Eigen::Vector3d end = start;
      for (const auto& line : loads.lines) {
        if (line.member != m || middle < line.from || middle > line.to) continue;
        const auto at = [&](double s) -> Eigen::Vector3d {
          const double part = (s - line.from) / (line.to - line.from);
          return (1.0 - part) * line.at_from + part * line.at_to;
        };
        start += at(from);
        end += at(to);
      }
      frame_.add_line(element, start, end);
      for (const auto& heat : loads.heat) {
        if (heat.member != m) continue;
        frame_.add_heat(element, member.expansion * heat.mean, member.expansion * heat.along_y,
                        member.expansion * heat.along_z);
      }
    }
  }

  SpaceFrame::End end_of(const boxbeam::frame::Place& at) const {
    if (at.member == boxbeam::frame::ground) return {};
    const auto found = std::find_if(nodes_.begin(), nodes_.end(), [&](const Node& node) {
      return node.member == at.member && std::abs(node.s - at.p.x()) <= same_place;
    });
    const auto& axes = structure_.members[static_cast<std::size_t>(at.member)].axes;
    return {static_cast<int>(found - nodes_.begin()),
            axes * Eigen::Vector3d(0.0, at.p.y(), at.p.z())};
  }

  const boxbeam::frame::Structure& structure_;
  SpaceFrame frame_;
  std::vector<Node> nodes_;
  std::vector<std::pair<std::size_t, std::size_t>> elements_;
  SpaceFrame::Solution solution_;
};

}  // namespace test
