#include "elastic_motion_in_space.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

#include "bent_in_space.hpp"
#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/spatial/rest.hpp"

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

/// The load of the same name and place, a millionth of the beam apart at most, for one without name
/// any there; else a new one there.
PointLoad& same_point(const PointLoad& load, Length beam, std::vector<PointLoad>& points) {
  const Length close = 1e-6 * beam;
  const auto same = std::find_if(points.begin(), points.end(), [&](const PointLoad& of) {
    const Length apart = of.s > load.s ? of.s - load.s : load.s - of.s;
    return (load.name.empty() || of.name == load.name) && apart <= close;
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

/// Which of the springs act in a state.
std::vector<bool> acting_springs(const spatial::Mechanism& mechanism, const spatial::State& state) {
  std::vector<bool> acting;
  for (const spatial::Spring& spring : mechanism.springs)
    acting.push_back(spatial::acts(spring, state));
  return acting;
}

/// What is known of the modes in a posture beside their equations, of k modes:
/// eta + K^-1 C eta' - K^-1 p times their loads.
struct LoadsOfModes {
  Eigen::MatrixXd viscous;     ///< K^-1 C
  Eigen::VectorXd statically;  ///< K^-1 p
  Eigen::MatrixXd loads;       ///< a row for each mode

  Eigen::VectorXd packed() const {
    Eigen::VectorXd all(viscous.size() + statically.size() + loads.size());
    all << viscous.reshaped(), statically, loads.reshaped();
    return all;
  }
  static LoadsOfModes unpacked(const Eigen::VectorXd& all, Eigen::Index k) {
    const Eigen::Index numbers = all.size() / k - k - 1;
    return {all.head(k * k).reshaped(k, k), all.segment(k * k, k),
            all.tail(k * numbers).reshaped(k, numbers)};
  }
};

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
  const std::string otherwise =
      "; use --model rigid to have the loads of rigid bodies all the same";
  StoppedVibration stopped(project, chain, parts);
  if (const std::string why = obstacle_to_modes(chain.mechanism(), stopped.placements());
      !why.empty())
    refuse_vibration(why + otherwise);

  const spatial::StatesAround states(chain, {begin_, period_, span.closed, span.instants});
  std::optional<OpenMotion> once;
  if (!span.closed) once = open_motion_of(chain, span);
  std::vector<double> borders{begin_};
  if (once) {
    borders = once->borders;
  } else {
    for (const Time& at : span.breaks) borders.push_back(at.value());
    borders.push_back(begin_ + period_);
  }
  const std::vector<double> changes = changes_between(
      borders, [&](double time) { return acting_springs(chain.mechanism(), states.at(time)); });
  if (!once && !changes.empty())
    refuse_vibration(
        "a stop or a cable begins or ends to act in a motion that repeats, and the modes of the "
        "beam change at once" +
            otherwise,
        changes.front());
  const auto diagram_at = [&](double time) { return cut_forces_of(rigid_(si<Time>(time))); };
  Eigen::MatrixXd reference;
  std::size_t count = 0;
  /// The modes that are followed from here on.
  const auto begin_at = [&](double time) {
    /// Modes beyond those asked for, one of which may be alike.
    constexpr std::size_t more = 3;
    const std::size_t asked = stopped.freedoms() + modes;
    ModesInMotion first = stopped.modes_in_motion(states.at(time), diagram_at(time), asked + more);
    count = whole_groups(first.modes, asked);
    if (count == 0) refuse_vibration("without mass nothing vibrates; use --model rigid", time);
    first.modes.resize(count);
    reference = first.shapes.leftCols(static_cast<Eigen::Index>(count));
    return first;
  };
  begin_at(begin_);
  const auto modes_at = [&](double time, const CutForceDiagram& diagram) {
    const spatial::State state = states.at(time);
    ModesInMotion at = stopped.modes_in_motion(state, diagram, count);
    if (at.modes.size() < count)
      refuse_vibration(fmt::format("the beam has {} modes here and {} at the begin of its motion",
                                   at.modes.size(), count) +
                           otherwise,
                       time);
    return at;
  };
  const auto posture_at = [&](double time) {
    const CutForceDiagram diagram = diagram_at(time);
    ModesInMotion at = modes_at(time, diagram);
    Posture posture;
    ModalPosture& modal = posture.modal;
    modal.turn = turn_between(at.shapes, reference, time);
    const auto k = static_cast<Eigen::Index>(count);
    modal.squares.resize(k);
    Eigen::MatrixXd numbers;
    for (Eigen::Index j = 0; j < k; ++j) {
      const frame::BeamMode& mode = at.modes[static_cast<std::size_t>(j)];
      modal.squares[j] = std::pow(full_turn * mode.frequency, 2);
      const Eigen::RowVectorXd of = numbers_of(mode.loads);
      // What begins to act later stands behind the others.
      if (j == 0) numbers.resize(k, of.size());
      numbers.row(j) = of;
    }
    modal.force = std::move(at.force);
    modal.damping = std::move(at.damping);
    modal.of_rate = std::move(at.turning.of_rate);
    modal.of_size = std::move(at.turning.of_size);
    posture.loads = modal.turn.transpose() * numbers;
    return posture;
  };
  if (span.closed) {
    const Eigen::Index stride = stride_of(span.instants, count);
    solve_periodic(posture_at, static_cast<Eigen::Index>(span.instants) / stride);
    return;
  }
  const auto resting = [&]() -> RestingModes {
    const double behind = once->behind();
    const ModesInMotion at = modes_at(behind, diagram_at(behind));
    Eigen::VectorXd frequencies(static_cast<Eigen::Index>(count));
    for (Eigen::Index j = 0; j < frequencies.size(); ++j)
      frequencies[j] = at.modes[static_cast<std::size_t>(j)].frequency;
    return {posture_at(behind).modal, std::move(frequencies),
            largest_stresses_in_space(at.modes, project.beam)};
  };
  const auto turned_at = [&](double change) -> Eigen::MatrixXd {
    // So near that nothing has moved, and so far that only round-off is nearer.
    const auto border = std::lower_bound(borders.begin(), borders.end(), change);
    const double beside = 1e-6 * std::min(change - *(border - 1), *(border + 1) - change);
    const ModesInMotion ahead = modes_at(change - beside, diagram_at(change - beside));
    const Eigen::MatrixXd turn = turn_between(ahead.shapes, reference, change);
    const ModesInMotion from_here = begin_at(change + beside);
    const frame::VibratingScene scene =
        stopped.scene_in(states.at(change + beside), diagram_at(change + beside));
    return frame::masses_between(scene, from_here.modes, ahead.modes) * turn;
  };
  solve_once(posture_at, std::move(*once), {changes, turned_at}, resting);
}

void ElasticMotionInSpace::solve_periodic(const PostureAt& posture_at, Eigen::Index instants) {
  std::vector<ModalPosture> postures;
  std::vector<Eigen::MatrixXd> mode_loads;
  for (Eigen::Index i = 0; i < instants; ++i) {
    Posture at =
        posture_at(begin_ + period_ * static_cast<double>(i) / static_cast<double>(instants));
    lowest_ = std::min(lowest_, std::sqrt(at.modal.squares[0]) / full_turn);
    postures.push_back(std::move(at.modal));
    mode_loads.push_back(std::move(at.loads));
  }
  ModalMotion solved = solve_modal_motion(postures, period_);
  eta_ = std::move(solved.eta);
  dynamic_ = std::move(solved.dynamic);
  loads_ = Eigen::MatrixXd::Zero(instants, arms_of_numbers().size());
  for (Eigen::Index i = 0; i < instants; ++i) {
    const Eigen::MatrixXd& of = mode_loads[static_cast<std::size_t>(i)];
    loads_.row(i).head(of.cols()) = dynamic_.row(i) * of;
  }
}

void ElasticMotionInSpace::solve_once(const PostureAt& posture_at, OpenMotion motion,
                                      Changes changes,
                                      const std::function<RestingModes()>& resting) {
  Eigen::Index k = 0;
  PassedOnce passed;
  passed.posture_at = [&](double time) {
    Posture at = posture_at(time);
    const ModalPosture& modal = at.modal;
    k = modal.squares.size();
    const Eigen::MatrixXd& turn = modal.turn;
    const Eigen::VectorXd flexibility = flexibilities_of(modal.squares);
    const LoadsOfModes beside{turn.transpose() * flexibility.asDiagonal() * modal.damping * turn,
                              turn.transpose() * modal.force.cwiseProduct(flexibility),
                              std::move(at.loads)};
    return PassedPosture{std::move(at.modal), beside.packed()};
  };
  passed.accuracy = [&](const Eigen::VectorXd& largest) { return allowed_of(largest, k); };
  passed.resting = resting;
  passed.changes = std::move(changes.at);
  passed.turned_at = std::move(changes.turned);
  once_ = std::make_shared<const ModalTransient>(std::move(motion), passed);
  lowest_ = once_->lowest_frequency();
}

/// Of K between two modes a part of the mean of their own, of C of what that damps critically, of p
/// and its deflection of their largest value, or of all where it hardly counts beside the others;
/// of what a mode does to the beam a part of the largest moment that it can make.
Eigen::VectorXd ElasticMotionInSpace::allowed_of(const Eigen::VectorXd& largest,
                                                 Eigen::Index k) const {
  constexpr double part = 1e-4, hardly = 1e-2;
  const Eigen::VectorXd stiffness = largest.segment(k * k, k * k).reshaped(k, k).diagonal();
  // What moves without force is to be right beside the others.
  constexpr double slow = 1e-6;
  const Eigen::VectorXd omega = stiffness.cwiseMax(slow * stiffness.maxCoeff()).cwiseSqrt(),
                        root = omega.cwiseSqrt();
  const auto valued = [&](const Eigen::VectorXd& of) -> Eigen::VectorXd {
    return part * of.cwiseMax(hardly * of.maxCoeff());
  };
  const LoadsOfModes beside =
      LoadsOfModes::unpacked(largest.tail(largest.size() - 2 * k * k - k), k);
  const Eigen::VectorXd arms = arms_of_numbers();
  LoadsOfModes of_beside{Eigen::MatrixXd::Constant(k, k, part * beside.viscous.maxCoeff()),
                         valued(beside.statically), Eigen::MatrixXd(k, arms.size())};
  constexpr double no_load = 1e-9;
  const double largest_load = (beside.loads * arms.asDiagonal()).maxCoeff();
  for (Eigen::Index j = 0; j < k; ++j) {
    double most = beside.loads.row(j).transpose().cwiseProduct(arms).maxCoeff();
    if (most <= no_load * largest_load) most = hardly * largest_load;
    of_beside.loads.row(j) = (part * most * arms.cwiseInverse()).transpose();
  }
  const Eigen::VectorXd of_forces = valued(largest.segment(2 * k * k, k));
  const Eigen::MatrixXd of_damping = part * root * root.transpose(),
                        of_stiffness = part * omega * omega.transpose();
  Eigen::VectorXd allowed(largest.size());
  allowed << of_damping.reshaped(), of_stiffness.reshaped(), of_forces, of_beside.packed();
  return allowed;
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

Eigen::VectorXd ElasticMotionInSpace::arms_of_numbers() const {
  const double length = length_of(places_.lines).value();
  const auto pieces = static_cast<Eigen::Index>(places_.lines.size()),
             points = static_cast<Eigen::Index>(places_.points.size());
  Eigen::VectorXd arms(numbers_of_piece * pieces + numbers_of_point * points);
  Eigen::Index at = 0;
  for (const LineLoad& line : places_.lines) {
    const double h = line.length.value(), force = h * length;
    for (const double arm : {force, force, force * h, force, force * h, h, h, h}) arms[at++] = arm;
  }
  for (Eigen::Index i = 0; i < points; ++i) {
    arms.segment<3>(at).setConstant(length);
    arms.segment<3>(at + 3).setOnes();
    at += numbers_of_point;
  }
  return arms;
}

const TransientResponse* ElasticMotionInSpace::transient() const {
  return once_ ? &once_->response() : nullptr;
}

LoadSpan ElasticMotionInSpace::span_of(const LoadSpan& rigid) const {
  return once_ ? once_->span_of(rigid) : rigid;
}

/// The numbers of what the modes' inertia does to the beam.
Eigen::VectorXd ElasticMotionInSpace::vibrating_at(double time) const {
  if (!once_) return trigonometric_at(loads_, (time - begin_) / period_);
  const ModalState state = once_->response().at(time);
  const LoadsOfModes of = LoadsOfModes::unpacked(once_->beside_at(time), state.eta.size());
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(arms_of_numbers().size());
  numbers.head(of.loads.cols()) =
      of.loads.transpose() * (state.eta + of.viscous * state.speed - of.statically);
  return numbers;
}

BeamLoads ElasticMotionInSpace::loads_at(Time time) const {
  BeamLoads loads = rigid_(time);
  add_bending(loads_of(vibrating_at(time.value())), loads);
  return loads;
}

void add_bending(const BeamLoads& bending, BeamLoads& loads) {
  const Length beam = length_of(bending.lines);
  for (const PointLoad& load : bending.points) {
    if (load.force.isZero(0.0) && load.moment.isZero(0.0)) continue;
    add_carried(load, same_point(load, beam, loads.points));
  }
  const std::vector<LineLoad> pieces = pieces_of_both(loads.lines, bending.lines);
  loads.lines = on_stretches_of(loads.lines, pieces);
  add_lines(loads.lines, 1.0, on_stretches_of(bending.lines, pieces));
}

LoadHistory elastic_loads_in_space(const Project& project, const spatial::Chain& chain,
                                   const LoadSpan& span, const ElasticModel& model, LoadsAt rigid) {
  const auto states = [&chain, &span] {
    return std::make_shared<const spatial::StatesAround>(
        chain,
        spatial::Motion{span.begin.value(), span.period.value(), span.closed, span.instants});
  };
  switch (model.level) {
    case ModelLevel::rigid: return {span, std::move(rigid)};
    case ModelLevel::quasi_static:
      return {span, bent_statically_in_space(
                        project, chain, [of = states()](double time) { return of->at(time); },
                        model.parts, std::move(rigid))};
    case ModelLevel::modal:
    case ModelLevel::flexible: break;
  }
  require_few_instants(span.instants);
  auto of = std::make_shared<const ElasticMotionInSpace>(
      project, chain, span, std::move(rigid), static_cast<std::size_t>(model.modes), model.parts);
  return {of->span_of(span), [of](Time time) { return of->loads_at(time); }};
}

}  // namespace boxbeam
