#include "elastic_motion_in_space.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>

#include "bent_in_space.hpp"
#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/spatial/rest.hpp"
#include "followed_modes.hpp"
#include "sliding_joints.hpp"
#include "vibrating_contacts.hpp"

namespace boxbeam {
namespace {

/// Which of the springs act in a state.
std::vector<bool> acting_springs(const spatial::Mechanism& mechanism, const spatial::State& state) {
  std::vector<bool> acting;
  for (const spatial::Spring& spring : mechanism.springs)
    acting.push_back(spatial::acts(spring, state));
  return acting;
}

/// What is known of the modes in a posture beside their equations, of k modes:
/// eta + K^-1 C eta' - K^-1 p times their loads, eta' times those by rate, and what is taken over.
struct LoadsOfModes {
  Eigen::MatrixXd viscous;     ///< K^-1 C of the material
  Eigen::VectorXd statically;  ///< K^-1 p
  Eigen::MatrixXd loads;       ///< a row for each mode
  Eigen::MatrixXd by_rate;     ///< likewise, of dampers, or of no rows
  Eigen::VectorXd taken_over;  ///< or nothing
  Eigen::MatrixXd gaps;        ///< a row for each mode

  /// Which of these there are.
  struct Kinds {
    bool damped = false, taken_over = false;
    Eigen::Index contacts = 0;
  };

  /// The largest gap, or what is none beside the motion of a mode.
  double largest_gap() const {
    constexpr double none = 1e-6;
    return gaps.size() > 0 ? std::max(none, gaps.maxCoeff()) : none;
  }

  Eigen::VectorXd packed() const {
    Eigen::VectorXd all(viscous.size() + statically.size() + loads.size() + by_rate.size() +
                        taken_over.size() + gaps.size());
    all << viscous.reshaped(), statically, loads.reshaped(), by_rate.reshaped(), taken_over,
        gaps.reshaped();
    return all;
  }
  static LoadsOfModes unpacked(const Eigen::VectorXd& all, Eigen::Index k, const Kinds& kinds) {
    const Eigen::Index left = all.size() - k * k - k - k * kinds.contacts,
                       rows = k * (kinds.damped ? 2 : 1) + (kinds.taken_over ? 1 : 0),
                       numbers = left / rows;
    Eigen::Index at = 0;
    const auto next = [&](Eigen::Index count, Eigen::Index columns) -> Eigen::MatrixXd {
      Eigen::MatrixXd part = all.segment(at, count * columns).reshaped(count, columns);
      at += part.size();
      return part;
    };
    LoadsOfModes of;
    of.viscous = next(k, k);
    of.statically = next(k, 1);
    of.loads = next(k, numbers);
    of.by_rate = next(kinds.damped ? k : 0, numbers);
    of.taken_over = next(kinds.taken_over ? numbers : 0, 1);
    of.gaps = next(k, kinds.contacts);
    return of;
  }
};

/// Modes of a motion that repeats go on all the time.
template <class ActingAt>
void refuse_changing_modes(const LoadSpan& span, const ActingAt& acting_at,
                           const std::string& otherwise) {
  std::vector<double> borders{span.begin.value()};
  for (const Time& at : span.breaks) borders.push_back(at.value());
  borders.push_back((span.begin + span.period).value());
  const std::vector<double> changes = changes_between(borders, acting_at);
  if (!changes.empty())
    refuse_vibration(
        "a stop or a cable begins or ends to act in a motion that repeats, and the modes of the "
        "beam change at once" +
            otherwise,
        changes.front());
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
  for (const spatial::ClosingJoint& joint : mechanism.closing) {
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
  for (const spatial::Spring& spring : mechanism.springs)
    if (spring.clearance)
      return fmt::format("joint {} has a clearance, in which it is held by no mode", spring.name);
  return "";
}

ElasticMotionInSpace::ElasticMotionInSpace(const Project& project, const spatial::Chain& chain,
                                           const LoadSpan& span, LoadsAt rigid, std::size_t modes,
                                           int parts, LoadsAt bent)
    : rigid_(std::move(rigid)),
      bent_(std::move(bent)),
      begin_(span.begin.value()),
      period_(span.period.value()) {
  const std::string otherwise =
      "; use --model rigid to have the loads of rigid bodies all the same";
  StoppedVibration stopped(project, chain, parts);
  if (const std::string why = obstacle_to_modes(chain.mechanism(), stopped.placements());
      !why.empty())
    refuse_vibration(why + otherwise);

  damped_ = stopped.is_damped();
  takes_over_ = !bent_ && stopped.takes_over();
  contacts_ = static_cast<Eigen::Index>(contacts_of(chain.mechanism()).size());
  numbers_ =
      LoadNumbers(joints_sliding_along(chain.mechanism(), stopped.placements().front().body));
  const spatial::StatesAround states(chain, {begin_, period_, span.closed, span.instants});
  const auto acting_at = [&](double time) {
    return acting_springs(chain.mechanism(), states.at(time));
  };
  const spatial::BeamBody body =
      spatial::beam_body_of(project.beam, stopped.placements().front(), chain.mechanism());
  FollowedModes followed(
      stopped, [&](double time) { return states.at(time); },
      [&](const spatial::State& state) {
        return rigid_cut_forces(chain, state, body, chain.joint_wrenches(state));
      },
      modes, takes_over_);
  const bool yields = project.model.retardation > 0.0;
  const auto posture_at = [&](double time) {
    ModesInMotion at = followed.at(time);
    Eigen::MatrixXd turn = followed.turn_of(at.shapes, time);
    return posture_of(std::move(at), std::move(turn), yields);
  };
  if (span.closed) {
    if (stopped.freedoms() > 0) refuse_vibration("forces decide a motion that repeats" + otherwise);
    refuse_changing_modes(span, acting_at, otherwise);
    followed.begin_at(begin_);
    const Eigen::Index stride = stride_of(span.instants, followed.count());
    solve_periodic(posture_at, static_cast<Eigen::Index>(span.instants) / stride);
    return;
  }
  OpenMotion motion = open_motion_of(chain, span);
  PassedOnce passed;
  // Steps that forces decide are short beside how its posture and its loads change.
  if (stopped.freedoms() > 0) passed.instants_to_a_piece = 32.0;
  passed.changes = followed.changes_over(motion, passed.instants_to_a_piece, acting_at);
  followed.begin_at(begin_);
  passed.turned_at = [&](double change) { return followed.turned_at(motion, change); };
  passed.resting = [&]() -> RestingModes {
    const double behind = motion.behind();
    const ModesInMotion at = followed.at(behind);
    Eigen::VectorXd frequencies(static_cast<Eigen::Index>(followed.count()));
    for (Eigen::Index j = 0; j < frequencies.size(); ++j)
      frequencies[j] = at.modes[static_cast<std::size_t>(j)].frequency;
    return {posture_at(behind).modal, std::move(frequencies),
            largest_stresses_in_space(at.modes, project.beam)};
  };
  solve_once(posture_at, motion, std::move(passed));
  const auto gaps_at = [&](double time, Eigen::Index k) {
    return LoadsOfModes::unpacked(once_->beside_at(time), k, {damped_, takes_over_, contacts_})
        .gaps;
  };
  check_contacts(chain, states, once_->response(), gaps_at, project.model.tolerance);
}

ElasticMotionInSpace::Posture ElasticMotionInSpace::posture_of(ModesInMotion at,
                                                               Eigen::MatrixXd turn, bool yields) {
  Posture posture;
  ModalPosture& modal = posture.modal;
  modal.turn = std::move(turn);
  const auto k = static_cast<Eigen::Index>(at.modes.size());
  modal.squares.resize(k);
  Eigen::MatrixXd numbers;
  for (Eigen::Index j = 0; j < k; ++j) {
    const frame::BeamMode& mode = at.modes[static_cast<std::size_t>(j)];
    modal.squares[j] = std::pow(full_turn * mode.frequency, 2);
    const Eigen::RowVectorXd of = numbers_.of(mode.loads);
    // What begins to act later stands behind the others.
    if (j == 0) numbers.resize(k, of.size());
    numbers.row(j) = of;
  }
  modal.force = std::move(at.force);
  modal.damping = std::move(at.damping);
  // Of a material without damping dampers would leave round-off, which no polynomial follows.
  modal.of_material = yields ? modal.damping : Eigen::MatrixXd::Zero(k, k);
  Eigen::MatrixXd by_rate = Eigen::MatrixXd::Zero(damped_ ? k : 0, numbers.cols());
  for (const frame::DampedTie& of : at.dampers) {
    if (yields) modal.of_material -= of.damping * of.gaps * of.gaps.transpose();
    by_rate += of.damping * of.gaps * numbers_.of(of.loads);
  }
  modal.of_rate = std::move(at.turning.of_rate);
  modal.of_size = std::move(at.turning.of_size);
  posture.loads = modal.turn.transpose() * numbers;
  if (damped_) posture.by_rate = modal.turn.transpose() * by_rate;
  if (takes_over_) posture.taken_over = numbers_.of(*at.taken_over).transpose();
  posture.gaps = modal.turn.transpose() * at.gaps.transpose();
  return posture;
}

void ElasticMotionInSpace::solve_periodic(const PostureAt& posture_at, Eigen::Index instants) {
  std::vector<ModalPosture> postures;
  std::vector<Eigen::MatrixXd> mode_loads, by_rate;
  std::vector<Eigen::VectorXd> taken_over;
  for (Eigen::Index i = 0; i < instants; ++i) {
    Posture at =
        posture_at(begin_ + period_ * static_cast<double>(i) / static_cast<double>(instants));
    lowest_ = std::min(lowest_, std::sqrt(at.modal.squares[0]) / full_turn);
    postures.push_back(std::move(at.modal));
    mode_loads.push_back(std::move(at.loads));
    by_rate.push_back(std::move(at.by_rate));
    taken_over.push_back(std::move(at.taken_over));
  }
  ModalMotion solved = solve_modal_motion(postures, period_);
  eta_ = std::move(solved.eta);
  dynamic_ = std::move(solved.dynamic);
  loads_ = Eigen::MatrixXd::Zero(instants, numbers_.arms().size());
  for (Eigen::Index i = 0; i < instants; ++i) {
    const Eigen::MatrixXd& of = mode_loads[static_cast<std::size_t>(i)];
    loads_.row(i).head(of.cols()) = dynamic_.row(i) * of;
    if (damped_)
      loads_.row(i).head(of.cols()) += solved.speed.row(i) * by_rate[static_cast<std::size_t>(i)];
    const Eigen::VectorXd& statically = taken_over[static_cast<std::size_t>(i)];
    loads_.row(i).head(statically.size()) += statically.transpose();
  }
}

void ElasticMotionInSpace::solve_once(const PostureAt& posture_at, const OpenMotion& motion,
                                      PassedOnce passed) {
  Eigen::Index k = 0;
  passed.posture_at = [&](double time) {
    Posture at = posture_at(time);
    const ModalPosture& modal = at.modal;
    k = modal.squares.size();
    const Eigen::MatrixXd& turn = modal.turn;
    const Eigen::VectorXd flexibility = flexibilities_of(modal.squares);
    const LoadsOfModes beside{
        turn.transpose() * flexibility.asDiagonal() * modal.of_material * turn,
        turn.transpose() * modal.force.cwiseProduct(flexibility),
        std::move(at.loads),
        std::move(at.by_rate),
        std::move(at.taken_over),
        std::move(at.gaps)};
    return PassedPosture{std::move(at.modal), beside.packed()};
  };
  passed.accuracy = [&](const Eigen::VectorXd& largest) { return allowed_of(largest, k); };
  once_ = std::make_shared<const ModalTransient>(motion, passed);
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
  const LoadsOfModes beside = LoadsOfModes::unpacked(largest.tail(largest.size() - 2 * k * k - k),
                                                     k, {damped_, takes_over_, contacts_});
  const Eigen::VectorXd arms = numbers_.arms();
  LoadsOfModes of_beside{Eigen::MatrixXd::Constant(k, k, part * beside.viscous.maxCoeff()),
                         valued(beside.statically),
                         Eigen::MatrixXd(k, arms.size()),
                         Eigen::MatrixXd(damped_ ? k : 0, arms.size()),
                         Eigen::VectorXd(),
                         Eigen::MatrixXd::Constant(k, contacts_, part * beside.largest_gap())};
  // Of every row a part of the most that it does, or, where that is nothing, of all.
  const auto of_rows = [&](const Eigen::MatrixXd& rows, Eigen::MatrixXd& errors) {
    constexpr double no_load = 1e-9;
    const Eigen::VectorXd most = (rows * arms.asDiagonal()).rowwise().maxCoeff();
    for (Eigen::Index j = 0; j < errors.rows(); ++j) {
      const bool loads = most[j] > no_load * most.maxCoeff();
      errors.row(j) =
          (part * (loads ? most[j] : hardly * most.maxCoeff()) * arms.cwiseInverse()).transpose();
    }
  };
  of_rows(beside.loads, of_beside.loads);
  if (damped_) of_rows(beside.by_rate, of_beside.by_rate);
  if (takes_over_) {
    // Where hardly anything is taken over a part of what modes do statically.
    const double most = std::max((beside.taken_over.cwiseProduct(arms)).maxCoeff(),
                                 (beside.loads * arms.asDiagonal())
                                     .rowwise()
                                     .maxCoeff()
                                     .cwiseProduct(beside.statically)
                                     .maxCoeff());
    of_beside.taken_over = part * most * arms.cwiseInverse();
  }
  const Eigen::VectorXd of_forces = valued(largest.segment(2 * k * k, k));
  const Eigen::MatrixXd of_damping = part * root * root.transpose(),
                        of_stiffness = part * omega * omega.transpose();
  Eigen::VectorXd allowed(largest.size());
  allowed << of_damping.reshaped(), of_stiffness.reshaped(), of_forces, of_beside.packed();
  return allowed;
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
  const LoadsOfModes of = LoadsOfModes::unpacked(once_->beside_at(time), state.eta.size(),
                                                 {damped_, takes_over_, contacts_});
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(numbers_.arms().size());
  numbers.head(of.loads.cols()) =
      of.loads.transpose() * (state.eta + of.viscous * state.speed - of.statically);
  if (damped_) numbers.head(of.by_rate.cols()) += of.by_rate.transpose() * state.speed;
  numbers.head(of.taken_over.size()) += of.taken_over;
  return numbers;
}

BeamLoads ElasticMotionInSpace::loads_at(Time time) const {
  BeamLoads loads = bent_ ? bent_(time) : rigid_(time);
  add_bending(numbers_.loads_of(vibrating_at(time.value()), loads), loads);
  return loads;
}

LoadHistory elastic_loads_in_space(const Project& project, const spatial::Chain& chain,
                                   const LoadSpan& span, const ElasticModel& model, LoadsAt rigid) {
  const auto bent = [&](int parts) {
    const auto states = std::make_shared<const spatial::StatesAround>(
        chain,
        spatial::Motion{span.begin.value(), span.period.value(), span.closed, span.instants});
    return bent_statically_in_space(
        project, chain, [states](double time) { return states->at(time); }, parts, rigid);
  };
  switch (model.level) {
    case ModelLevel::rigid: return {span, std::move(rigid)};
    case ModelLevel::quasi_static: return {span, bent(model.parts)};
    case ModelLevel::modal:
    case ModelLevel::flexible: break;
  }
  require_few_instants(span.instants);
  // By few parts modes are right, axial forces on the bent axis are not.
  constexpr int least_bent = 16;
  auto of = std::make_shared<const ElasticMotionInSpace>(
      project, chain, span, rigid, static_cast<std::size_t>(model.modes), model.parts,
      model.bends_twice ? bent(std::max(least_bent, model.parts)) : LoadsAt());
  return {of->span_of(span), [of](Time time) { return of->loads_at(time); }};
}

}  // namespace boxbeam
