#include <Eigen/Geometry>
#include <algorithm>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "rigid_arms.hpp"

namespace boxbeam::frame {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector6 vector_of(const CutForces& cut) {
  Vector6 of;
  of << cut.N.value(), cut.V_y.value(), cut.V_z.value(), cut.T.value(), cut.M_y.value(),
      cut.M_z.value();
  return of;
}

Vector6 wrench_of(const PointLoad& load) {
  Vector6 of;
  of << load.force, load.moment;
  return of;
}

/// Strains of heat: a rise towards +z lengthens there, towards +y likewise.
Vector6 strain_of(const HeatAction& heat, double expansion) {
  Vector6 strain = Vector6::Zero();
  strain[0] = expansion * heat.mean;
  strain[4] = expansion * heat.along_z;
  strain[5] = -expansion * heat.along_y;
  return strain;
}

/// A load on a member at a place of it, from world axes.
PointLoad point_load(const Member& member, const Place& at, const Vector3d& force,
                     const Vector3d& moment, std::string_view name) {
  const Vector3d turned = member.axes.transpose() * force;
  const Vector3d arm(0.0, at.p.y(), at.p.z());
  return {si<Length>(at.p.x()), turned, member.axes.transpose() * moment + arm.cross(turned),
          arm.tail<2>(), name};
}

std::vector<double> borders_of(const CutForceDiagram& diagram) {
  std::vector<double> borders;
  for (const CutForcePiece& piece : diagram.pieces) borders.push_back(piece.start.value());
  return borders;
}

/// Integral of B^T (f c + e): how far the section at `to` is shifted and turned from where the one
/// at `from` would carry it, member axes; a column for each of those of c. Between `breaks`,
/// ascending, c is a polynomial.
template <int columns, class Cut>
Eigen::Matrix<double, 6, columns> strains_between(const FlexibilityProfile& profile, double from,
                                                  double to, const std::vector<double>& breaks,
                                                  const Cut& cut, const Vector6& heat) {
  // Along a prismatic segment the degree is that of the cut forces, 5, and of the arm.
  using Rule = boost::math::quadrature::gauss<double, 15>;
  using OfConstant = boost::math::quadrature::gauss<double, 7>;
  const std::vector<double>& pieces = profile.borders();
  Eigen::Matrix<double, 6, columns> sum = Eigen::Matrix<double, 6, columns>::Zero();
  for (std::size_t k = 0; k + 1 < pieces.size(); ++k) {
    const double first = std::max(from, pieces[k]), last = std::min(to, pieces[k + 1]);
    if (!(first < last)) continue;
    const auto add = [&](double s, double weight) {
      const Eigen::Matrix<double, 6, columns> forces = cut(s);
      const Flexibility f = profile.at(k, s);
      for (Index j = 0; j < columns; ++j)
        sum.col(j) += weight * carried_on(f * forces.col(j) + heat, to - s);
    };
    const auto integrate = [&](const auto& abscissae, const auto& weights, double low,
                               double high) {
      const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
      for (std::size_t i = 0; i < abscissae.size(); ++i) {
        const double u = abscissae[i], weight = half * weights[i];
        add(middle + half * u, weight);
        if (u > 0.0) add(middle - half * u, weight);
      }
    };
    double low = first;
    while (low < last) {
      const auto next = std::upper_bound(breaks.begin(), breaks.end(), low);
      const double high = next == breaks.end() ? last : std::min(last, *next);
      if (profile.is_constant(k))
        integrate(OfConstant::abscissa(), OfConstant::weights(), low, high);
      else
        integrate(Rule::abscissa(), Rule::weights(), low, high);
      low = high;
    }
  }
  return sum;
}

const Member& member_of(const Structure& structure, int member) {
  return structure.members[static_cast<std::size_t>(member)];
}

}  // namespace

std::vector<LineLoad> Statics::lines_on(int member, const ActingLoads& loads) const {
  const Member& of = member_of(*structure_, member);
  const Vector3d gravity = loads.weight * (of.axes.transpose() * structure_->gravity);
  std::vector<LineLoad> weight =
      loads.weight == 0.0
          ? unloaded_lines(of.beam)
          : weight_and_inertia(of.beam, masses_[static_cast<std::size_t>(member)], gravity, {});
  const double whole = of.beam.length().value();
  std::vector<double> ends;
  for (const LineAction& line : loads.lines) {
    if (line.member != member) continue;
    ends.insert(ends.end(), {std::clamp(line.from, 0.0, whole), std::clamp(line.to, 0.0, whole)});
  }
  if (ends.empty()) return weight;
  for (const LineLoad& line : weight) ends.push_back(line.start.value());
  ends.push_back(whole);
  std::sort(ends.begin(), ends.end());
  const double close = 1e-9 * whole;
  ends.erase(
      std::unique(ends.begin(), ends.end(), [&](double a, double b) { return b - a < close; }),
      ends.end());
  ends.back() = whole;  // also where a load ends just before
  std::vector<LineLoad> lines;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double from = ends[k], length = ends[k + 1] - from, middle = from + 0.5 * length;
    const auto under = std::find_if(weight.begin(), weight.end() - 1, [&](const LineLoad& line) {
      return middle < (line.start + line.length).value();
    });
    LineLoad& line = lines.emplace_back();
    line.start = si<Length>(from);
    line.length = si<Length>(length);
    const double by = from - under->start.value();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      line.force[axis] =
          interpolate<3>([&](double x) { return under->force[axis](by + x); }, length);
    }
    for (const LineAction& action : loads.lines) {
      if (action.member != member || middle < action.from || middle > action.to) continue;
      const Vector3d slope =
          of.axes.transpose() * (action.at_to - action.at_from) / (action.to - action.from);
      const Vector3d start = of.axes.transpose() * action.at_from + (from - action.from) * slope;
      add_from_outside(start, start + length * slope, line);
    }
  }
  return lines;
}

std::vector<MemberLoads> Statics::member_loads_of(const ActingLoads& loads) const {
  std::vector<MemberLoads> members(structure_->members.size());
  for (std::size_t m = 0; m < members.size(); ++m)
    members[m].loads.lines = lines_on(static_cast<int>(m), loads);
  for (const LineAction& line : loads.lines)
    members[static_cast<std::size_t>(line.member)].line_loaded = true;
  for (const auto& [name, action, part] : loads.points) {
    const Member& member = member_of(*structure_, action.at.member);
    PointLoad load = point_load(member, action.at, action.force, action.moment, name);
    load.part = part;
    const Node& node = nodes_[node_of(action.at)];
    if (std::abs(node.s - action.at.p.x()) < 1e-11 * member.beam.length().value())
      load.s = si<Length>(node.s);
    members[static_cast<std::size_t>(action.at.member)].loads.points.push_back(load);
  }
  for (const HeatAction& heat : loads.heat) {
    members[static_cast<std::size_t>(heat.member)].heat +=
        strain_of(heat, member_of(*structure_, heat.member).expansion);
  }
  return members;
}

Matrix6 Statics::flexibility_between(int member, double from, double to) const {
  const auto units = [&](double s) -> Matrix6 {
    return carry(Vector3d(to - s, 0.0, 0.0)).transpose();
  };
  return strains_between<6>(*profiles_[static_cast<std::size_t>(member)], from, to, {}, units,
                            Vector6::Zero());
}

Vector6 Statics::strain_to(std::size_t piece, double s, const Vector6& cut) const {
  const std::vector<Reached>& reached = reached_[piece];
  const Reached& known =
      *(std::upper_bound(reached.begin(), reached.end(), s,
                         [](double at, const Reached& of) { return at < of.s; }) -
        1);
  const double beyond = s - known.s;
  const auto before = [&](double at) { return carried_back(cut, s - at); };
  return carried_on(known.flexibility * carried_back(cut, beyond), beyond) +
         strains_between<1>(*profiles_[static_cast<std::size_t>(pieces_[piece].member)], known.s, s,
                            {}, before, Vector6::Zero());
}

Equilibrium Statics::solve(const ActingLoads& loads) const {
  Equilibrium result = balance(loads);
  for (MemberLoads& member : result.members) member.cut = cut_forces_of(member.loads);
  return result;
}

Eigen::VectorXd Statics::right_side(const ActingLoads& loads,
                                    const std::vector<MemberLoads>& members) const {
  const Structure& of = *structure_;
  const std::span<const Index> world = world_components(of), cuts = cut_components(of);
  // Of what acts along members alone; none where nothing does.
  std::vector<CutForceDiagram> along(members.size());
  for (std::size_t m = 0; m < along.size(); ++m) {
    const MemberLoads& acting = members[m];
    if (loads.weight != 0.0 || acting.line_loaded || !acting.heat.isZero(0.0))
      along[m] = cut_forces_of({{}, acting.loads.lines});
  }
  const auto shift_unit = [&](Index k) { return k < 3 ? length_ : 1.0; };
  const auto force_unit = [&](Index k) { return k < 3 ? force_ : force_ * length_; };

  Eigen::VectorXd right = Eigen::VectorXd::Zero(matrix_.rows());
  const auto load_node = [&](std::size_t node, const Vector6& load) {
    for (std::size_t k = 0; k < world.size(); ++k)
      right[row_of_node(node) + static_cast<Index>(k)] += load[world[k]] / force_unit(world[k]);
  };
  // What acts between the nodes of a piece is held at its beginning; what acts at a node is the
  // node's.
  for (std::size_t p = 0; p < pieces_.size(); ++p) {
    const Piece& piece = pieces_[p];
    const Member& member = member_of(of, piece.member);
    const MemberLoads& acting = members[static_cast<std::size_t>(piece.member)];
    const double from = nodes_[piece.from].s, to = nodes_[piece.to].s;
    Vector6 held = Vector6::Zero(), misfit = Vector6::Zero();
    for (const PointLoad& load : acting.loads.points) {
      const double s = load.s.value();
      if (!(s > from && s < to)) continue;
      const Vector6 wrench = wrench_of(load);
      held += carried_back(wrench, s - from);
      misfit += carried_on(strain_to(p, s, wrench), to - s);
    }
    const CutForceDiagram& diagram = along[static_cast<std::size_t>(piece.member)];
    if (!diagram.pieces.empty()) {
      const Vector6 last = vector_of(diagram.at({si<Length>(to), Side::before}));
      const auto cut = [&](double s) -> Vector6 {
        return vector_of(diagram.at({si<Length>(s), Side::behind})) - carried_back(last, to - s);
      };
      held += cut(from);
      misfit += strains_between<1>(*profiles_[static_cast<std::size_t>(piece.member)], from, to,
                                   borders_of(diagram), cut, acting.heat);
    }
    load_node(piece.from, rotation(member.axes) * held);
    for (std::size_t i = 0; i < cuts.size(); ++i)
      right[row_of_piece(p) + static_cast<Index>(i)] = misfit[cuts[i]] / shift_unit(cuts[i]);
  }
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    const Node& node = nodes_[n];
    for (const PointLoad& load : members[static_cast<std::size_t>(node.member)].loads.points) {
      if (load.s.value() != node.s) continue;
      load_node(n, rotation(member_of(of, node.member).axes) * wrench_of(load));
    }
  }
  for (const Settlement& settlement : loads.settlements) {
    const auto joint = static_cast<std::size_t>(settlement.joint);
    Vector6 shift;
    shift << of.joints[joint].axes.transpose() * settlement.shift,
        of.joints[joint].axes.transpose() * settlement.turn;
    for (std::size_t k = 0; k < world.size(); ++k) {
      const Index row = joint_rows_[joint * world.size() + k];
      if (row >= 0) right[row] -= shift[world[k]] / shift_unit(world[k]);
    }
  }
  return right;
}

Equilibrium Statics::balance(const ActingLoads& loads) const {
  const Structure& of = *structure_;
  const std::span<const Index> world = world_components(of);
  Equilibrium result;
  result.members = member_loads_of(loads);
  const Eigen::VectorXd right = right_side(loads, result.members);
  Eigen::VectorXd x = solver_.solve(right);
  x += solver_.solve(right - matrix_ * x);
  if (!x.allFinite()) throw AnalysisError({"the loads on the frame are too large", ""});

  for (std::size_t j = 0; j < of.joints.size(); ++j) {
    const Joint& joint = of.joints[j];
    Vector6 force = Vector6::Zero();
    for (std::size_t k = 0; k < world.size(); ++k) {
      const Index row = joint_rows_[j * world.size() + k];
      if (row >= 0) force[world[k]] = x[row] * (world[k] < 3 ? force_ : force_ * length_);
    }
    force = rotation(joint.axes) * force;
    result.joints.push_back(force);
    for (const auto& [at, sign] : {std::pair{&joint.a, 1.0}, {&joint.b, -1.0}}) {
      if (at->member == ground) continue;
      Place there = *at;
      there.p.x() = nodes_[node_of(*at)].s;
      result.members[static_cast<std::size_t>(at->member)].loads.points.push_back(
          point_load(member_of(of, at->member), there, sign * force.head<3>(),
                     sign * force.tail<3>(), joint.name));
    }
  }
  result.motion = x.head(row_of_node(nodes_.size()));
  return result;
}

Vector6 Statics::motion_at(int member, double s, const Equilibrium& of) const {
  const std::span<const Index> world = world_components(*structure_);
  // What is computed may miss the ends by round-off.
  s = std::clamp(s, 0.0, member_of(*structure_, member).beam.length().value());
  const auto piece = std::find_if(pieces_.begin(), pieces_.end(), [&](const Piece& candidate) {
    return candidate.member == member && s <= nodes_[candidate.to].s;
  });
  const double from = nodes_[piece->from].s;
  Vector6 start = Vector6::Zero();
  for (std::size_t k = 0; k < world.size(); ++k) {
    start[world[k]] = of.motion[row_of_node(piece->from) + static_cast<Index>(k)] *
                      (world[k] < 3 ? length_ : 1.0);
  }
  const MemberLoads& acting = of.members[static_cast<std::size_t>(member)];
  const auto cut = [&](double at) -> Vector6 {
    return vector_of(acting.cut.at({si<Length>(at), Side::behind}));
  };
  const Matrix6 outwards = rotation(member_of(*structure_, member).axes);
  const Vector6 strain = strains_between<1>(*profiles_[static_cast<std::size_t>(member)], from, s,
                                            borders_of(acting.cut), cut, acting.heat);
  return outwards * (carried_on(outwards.transpose() * start, s - from) + strain);
}

}  // namespace boxbeam::frame
