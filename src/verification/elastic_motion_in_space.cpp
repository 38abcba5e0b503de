#include "elastic_motion_in_space.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

#include "boxbeam/core/angle.hpp"
#include "modal_motion.hpp"

namespace boxbeam {
namespace {

constexpr Eigen::Index numbers_of_piece = 8, numbers_of_point = 6;

/// So many modes that none is parted from those of nearly its frequency.
std::size_t whole_groups(const std::vector<frame::BeamMode>& modes, std::size_t asked) {
  constexpr double alike = 0.02;
  std::size_t count = std::min(asked, modes.size());
  while (count < modes.size() &&
         modes[count].frequency < (1.0 + alike) * modes[count - 1].frequency)
    ++count;
  return count;
}

bool slides_along(spatial::ClosingKind kind) {
  using Kind = spatial::ClosingKind;
  switch (kind) {
    case Kind::prismatic:
    case Kind::cylindrical:
    case Kind::planar:
    case Kind::slot:
    case Kind::screw: return true;
    case Kind::fixed:
    case Kind::revolute:
    case Kind::universal:
    case Kind::spherical:
    case Kind::distance:
    case Kind::gear:
    case Kind::rack: return false;
  }
  return false;
}

bool slides_along(spatial::JointKind kind) {
  switch (kind) {
    case spatial::JointKind::prismatic:
    case spatial::JointKind::screw: return true;
    case spatial::JointKind::fixed:
    case spatial::JointKind::revolute: return false;
  }
  return false;
}

/// Pieces without load that end where those of either end.
std::vector<LineLoad> pieces_of_both(const std::vector<LineLoad>& lines,
                                     const std::vector<LineLoad>& others) {
  std::vector<LineLoad> finer;
  std::vector<Length> ends;
  for (const std::vector<LineLoad>* of : {&lines, &others})
    for (const LineLoad& line : *of) ends.push_back(line.start + line.length);
  std::sort(ends.begin(), ends.end());
  constexpr double round_off = 1e-12;
  const Length close = round_off * ends.back();
  Length from;
  for (const Length& end : ends) {
    if (end - from <= close) continue;
    LineLoad& piece = finer.emplace_back();
    piece.start = from;
    piece.length = end - from;
    from = end;
  }
  return finer;
}

/// The load of the same name and place, a millionth of the beam apart at most; else a new one
/// there.
PointLoad& same_point(const PointLoad& load, Length beam, std::vector<PointLoad>& points) {
  const Length close = 1e-6 * beam;
  const auto same = std::find_if(points.begin(), points.end(), [&](const PointLoad& of) {
    const Length apart = of.s > load.s ? of.s - load.s : load.s - of.s;
    return of.name == load.name && apart <= close;
  });
  if (same != points.end()) return *same;
  PointLoad& added = points.emplace_back();
  added.s = load.s;
  added.at = load.at;
  added.name = load.name;
  return added;
}

/// Adds a load to one that may stand a little apart.
void add_carried(const PointLoad& load, PointLoad& sum) {
  const Eigen::Vector3d arm((load.s - sum.s).value(), 0.0, 0.0);
  sum.force += load.force;
  sum.moment += load.moment + arm.cross(load.force);
}

Length length_of(const std::vector<LineLoad>& lines) {
  return lines.back().start + lines.back().length;
}

}  // namespace

std::string obstacle_to_modes(const spatial::Mechanism& mechanism,
                              const std::vector<spatial::BeamPlacement>& beams) {
  /// In words, what is on this body; "" where that is no elastic beam.
  const auto beam_on = [&](int body) -> std::string {
    if (body == beams.front().body) return "the beam";
    const bool elastic =
        std::any_of(beams.begin(), beams.end(),
                    [&](const spatial::BeamPlacement& of) { return of.body == body; });
    if (!elastic) return "";
    return fmt::format("beam {}, which bends with it",
                       mechanism.bodies[static_cast<std::size_t>(body)].name);
  };
  const auto slides = [](const std::string& name, const std::string& beam) {
    return fmt::format("joint {} slides along {}, and modes hold it at one place", name, beam);
  };
  for (const spatial::Joint& joint : mechanism.joints) {
    const std::string beam = beam_on(joint.parent);
    if (!beam.empty() && slides_along(joint.kind)) return slides(joint.name, beam);
  }
  for (const spatial::ClosingJoint& joint : mechanism.closing) {
    const std::string beam = beam_on(joint.a.body);
    if (!beam.empty() && slides_along(joint.kind)) return slides(joint.name, beam);
    if (!spatial::has_teeth(joint.kind)) continue;
    for (const spatial::Mesh::Part& part : joint.mesh.parts) {
      std::string meshed = beam_on(static_cast<int>(part.joint));
      if (meshed.empty()) meshed = beam_on(mechanism.joints[part.joint].parent);
      if (!meshed.empty())
        return fmt::format(
            "the teeth of {} mesh on {}, and modes know their couples alone, not where they push",
            joint.name, meshed);
    }
  }
  return "";
}

ElasticMotionInSpace::ElasticMotionInSpace(const Project& project, const spatial::Chain& chain,
                                           const LoadSpan& span, LoadsAt rigid, std::size_t modes,
                                           int parts)
    : rigid_(std::move(rigid)), begin_(span.begin.value()), period_(span.period.value()) {
  if (!span.closed)
    refuse_vibration(
        "the motion does not repeat, and the beam's vibration is only computed in motions that do; "
        "use --model rigid to have the loads of rigid bodies all the same");
  const StoppedVibration stopped(project, chain, parts);
  if (const std::string why = obstacle_to_modes(chain.mechanism(), stopped.placements());
      !why.empty())
    refuse_vibration(why + "; use --model rigid to have the loads of rigid bodies all the same");

  Eigen::MatrixXd reference;
  std::size_t count = 0;
  const auto diagram_at = [&](double time) { return cut_forces_of(rigid_(si<Time>(time))); };
  /// Modes beyond those asked for, one of which may be alike.
  constexpr std::size_t more = 3;
  {
    const spatial::State state = chain.at(begin_);
    ModesInMotion first = stopped.modes_in_motion(state, diagram_at(begin_), modes + more);
    count = whole_groups(first.modes, modes);
    if (count == 0) refuse_vibration("without mass nothing vibrates; use --model rigid", begin_);
    reference = first.shapes.leftCols(static_cast<Eigen::Index>(count));
  }
  const Eigen::Index stride = stride_of(span.instants, count);
  const auto n = static_cast<Eigen::Index>(span.instants) / stride;
  const auto k = static_cast<Eigen::Index>(count);
  std::vector<ModalPosture> postures;
  std::vector<Eigen::MatrixXd> mode_loads;  // of the turned modes at the instants, a row for each
  lowest_ = 1e300;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double time = begin_ + period_ * static_cast<double>(i) / static_cast<double>(n);
    const spatial::State state = chain.at(time);
    const CutForceDiagram diagram = diagram_at(time);
    ModesInMotion at = stopped.modes_in_motion(state, diagram, count);
    if (at.modes.size() < count)
      refuse_vibration(
          fmt::format("the beam has {} modes here and {} at the begin of its motion; use --model "
                      "rigid to have the loads of rigid bodies all the same",
                      at.modes.size(), count),
          time);
    lowest_ = std::min(lowest_, at.modes.front().frequency);
    ModalPosture& posture = postures.emplace_back();
    posture.turn = turn_between(at.shapes, reference, time);
    posture.squares.resize(k);
    Eigen::MatrixXd numbers;
    for (Eigen::Index j = 0; j < k; ++j) {
      const frame::BeamMode& mode = at.modes[static_cast<std::size_t>(j)];
      posture.squares[j] = std::pow(full_turn * mode.frequency, 2);
      const Eigen::RowVectorXd of = numbers_of(mode.loads);
      // What begins to act later stands behind the others.
      if (j == 0) numbers.resize(k, of.size());
      numbers.row(j) = of;
    }
    posture.force = std::move(at.force);
    posture.damping = std::move(at.damping);
    posture.of_rate = std::move(at.turning.of_rate);
    posture.of_size = std::move(at.turning.of_size);
    mode_loads.push_back(posture.turn.transpose() * numbers);
  }
  ModalMotion solved = solve_modal_motion(postures, period_);
  eta_ = std::move(solved.eta);
  dynamic_ = std::move(solved.dynamic);
  loads_ = Eigen::MatrixXd::Zero(n, numbers_of(places_).size());
  for (Eigen::Index i = 0; i < n; ++i) {
    const Eigen::MatrixXd& of = mode_loads[static_cast<std::size_t>(i)];
    loads_.row(i).head(of.cols()) = dynamic_.row(i) * of;
  }
}

Eigen::RowVectorXd ElasticMotionInSpace::numbers_of(const BeamLoads& loads) {
  if (places_.lines.empty()) {
    for (const LineLoad& line : loads.lines) {
      LineLoad& piece = places_.lines.emplace_back();
      piece.start = line.start;
      piece.length = line.length;
    }
  }
  std::vector<PointLoad> points = places_.points;
  for (const PointLoad& load : loads.points)
    add_carried(load, same_point(load, length_of(places_.lines), points));
  const auto pieces = static_cast<Eigen::Index>(loads.lines.size()),
             count = static_cast<Eigen::Index>(points.size());
  Eigen::RowVectorXd numbers(numbers_of_piece * pieces + numbers_of_point * count);
  Eigen::Index at = 0;
  for (const LineLoad& line : loads.lines) {
    const auto& [x, y, z] = line.force;
    const auto& [about_x, about_y, about_z] = line.couple;
    for (const double number :
         {x.c[0], y.c[0], y.c[1], z.c[0], z.c[1], about_x.c[0], about_y.c[0], about_z.c[0]})
      numbers[at++] = number;
  }
  for (PointLoad& load : points) {
    numbers.segment<3>(at) = load.force.transpose();
    numbers.segment<3>(at + 3) = load.moment.transpose();
    at += numbers_of_point;
    load.force.setZero();
    load.moment.setZero();
  }
  places_.points = std::move(points);
  return numbers;
}

BeamLoads ElasticMotionInSpace::loads_of(const Eigen::VectorXd& numbers) const {
  BeamLoads loads = places_;
  Eigen::Index at = 0;
  for (LineLoad& line : loads.lines) {
    line.force[0] = {{numbers[at]}};
    line.force[1] = {{numbers[at + 1], numbers[at + 2]}};
    line.force[2] = {{numbers[at + 3], numbers[at + 4]}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      line.couple[axis] = {{numbers[at + 5 + static_cast<Eigen::Index>(axis)]}};
    at += numbers_of_piece;
  }
  for (PointLoad& load : loads.points) {
    load.force = numbers.segment<3>(at);
    load.moment = numbers.segment<3>(at + 3);
    at += numbers_of_point;
  }
  return loads;
}

BeamLoads ElasticMotionInSpace::loads_at(Time time) const {
  BeamLoads loads = rigid_(time);
  const BeamLoads vibrating = loads_of(trigonometric_at(loads_, (time.value() - begin_) / period_));
  const Length beam = length_of(vibrating.lines);
  for (const PointLoad& load : vibrating.points) {
    if (load.force.isZero(0.0) && load.moment.isZero(0.0)) continue;
    add_carried(load, same_point(load, beam, loads.points));
  }
  const std::vector<LineLoad> pieces = pieces_of_both(loads.lines, vibrating.lines);
  loads.lines = on_stretches_of(loads.lines, pieces);
  add_lines(loads.lines, 1.0, on_stretches_of(vibrating.lines, pieces));
  return loads;
}

LoadsAt elastic_loads_in_space(const Project& project, const spatial::Chain& chain,
                               const LoadSpan& span, const ElasticModel& model, LoadsAt rigid) {
  switch (model.level) {
    // Statically bent the rigid beam bears what it bears straight.
    case ModelLevel::rigid:
    case ModelLevel::quasi_static: return rigid;
    case ModelLevel::modal:
    case ModelLevel::flexible: break;
  }
  require_few_instants(span.instants);
  auto of = std::make_shared<const ElasticMotionInSpace>(
      project, chain, span, std::move(rigid), static_cast<std::size_t>(model.modes), model.parts);
  return [of](Time time) { return of->loads_at(time); };
}

}  // namespace boxbeam
