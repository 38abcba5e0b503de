#include "boxbeam/verification/elastic_motion.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/project/link_profile.hpp"
#include "modal_motion.hpp"

namespace boxbeam {
namespace {

/// Adds what a mode does to a beam to its loads: at the same places, and on the mode's stretches,
/// which lie inside the beam's own.
void add_mode(BeamLoads& sum, double factor, const BeamLoads& mode) {
  for (const PointLoad& load : mode.points) {
    auto same = std::find_if(sum.points.begin(), sum.points.end(),
                             [&](const PointLoad& other) { return other.s == load.s; });
    if (same == sum.points.end() && load.force.isZero(0.0) && load.moment.isZero(0.0)) continue;
    if (same == sum.points.end()) {
      PointLoad empty;
      empty.s = load.s;
      same = sum.points.insert(same, empty);
    }
    same->force += factor * load.force;
    same->moment += factor * load.moment;
  }
  add_lines(sum.lines, factor, mode.lines);
}

/// Stops where a posture buckles.
LoadedPosture standing_posture(const RigidMotion& rigid, const ElasticBody& elastic,
                               const planar::State& state, const BeamLoads& loads,
                               const BeamLoads* axial = nullptr) {
  LoadedPosture posture =
      loaded_posture(*rigid.mechanism, state, elastic, *rigid.beam, loads, 1.0, axial);
  if (!stands(posture)) {
    refuse_vibration(
        "the beam buckles in the plane of motion under its axial force: no elastic loads exist; "
        "use --model rigid to see those of rigid bodies",
        state.time);
  }
  return posture;
}

/// Largest axial force over the motion, by the one that buckles a pinned beam of the least bending
/// stiffness.
double axial_part(const RigidMotion& rigid, const ElasticBody& elastic) {
  double least = 1e300;
  for (const flexible::LinkStretch& stretch : elastic.stretches) {
    least = std::min({least, stretch.EI(0.0), stretch.EI(stretch.length)});
  }
  constexpr std::size_t looked_at = 48;
  const std::vector<planar::State>& states = rigid.motion->states;
  double most = 0.0;
  for (std::size_t i = 0; i < states.size();
       i += std::max<std::size_t>(1, states.size() / looked_at)) {
    for (const CutForcePiece& piece : cut_forces_of(rigid.loads(si<Time>(states[i].time))).pieces) {
      most = std::max({most, std::abs(piece.N(0.0)), std::abs(piece.N(piece.length.value()))});
    }
  }
  return most * std::pow(elastic.length / std::numbers::pi, 2) / least;
}

}  // namespace

ElasticBody elastic_body_of(const Project& project, int parts) {
  const auto body_of = [&](const TaperedBeam& beam, int body) {
    ElasticBody elastic;
    elastic.body = body;
    elastic.centre = mass_properties_of(beam).centre.value();
    elastic.length = beam.length().value();
    elastic.stretches =
        link_stretches_of(beam, project.model.youngs_modulus, project.model.shear_modulus);
    elastic.retardation = project.model.retardation;
    elastic.parts = parts;
    return elastic;
  };
  ElasticBody elastic = body_of(project.beam, project.beam_body);
  for (const BeamBeside& other : project.beams_beside) {
    ElasticBody& beside = elastic.beside.emplace_back(body_of(other.beam, other.body));
    beside.laid_out = planar::beam_body_of(other.beam, other.body);
  }
  return elastic;
}

LoadsAt bent_statically(const RigidMotion& rigid, const ElasticBody& elastic, LoadsAt axial) {
  auto finder = std::make_shared<planar::StateFinder>(*rigid.mechanism, *rigid.motion);
  return [rigid, elastic, finder, axial = std::move(axial)](Time time) {
    BeamLoads loads = rigid.loads(time);
    const BeamLoads borne = axial ? axial(time) : loads;
    const BeamLoads bent =
        second_order_of(standing_posture(rigid, elastic, finder->at(time.value()), loads, &borne))
            .loads;
    loads.lines = on_stretches_of(loads.lines, bent.lines);
    add_mode(loads, 1.0, bent);
    return loads;
  };
}

ElasticMotion::ElasticMotion(RigidMotion rigid, ElasticBody elastic, std::size_t modes,
                             LoadsAt axial)
    : rigid_(std::move(rigid)),
      finder_(std::make_shared<planar::StateFinder>(*rigid_.mechanism, *rigid_.motion)),
      elastic_(std::move(elastic)),
      count_(modes),
      axial_(std::move(axial)) {
  const planar::Motion& motion = *rigid_.motion;
  if (!motion.closed || motion.freedom.undriven > 0) {
    refuse_vibration(
        "rigid bodies are not enough for this motion, and the beam's vibration is only computed in "
        "motions that drivers fix and that repeat; use --model rigid to have the loads of rigid "
        "bodies all the same");
  }
  const Eigen::Index stride = stride_of(motion.states.size(), modes);
  const Eigen::Index n = static_cast<Eigen::Index>(motion.states.size()) / stride;
  const auto k = static_cast<Eigen::Index>(modes);
  const planar::State& first = motion.states.front();
  reference_ =
      modes_in_posture(posture_at(first, rigid_.loads(si<Time>(first.time))), count_).shapes;

  std::vector<ModalPosture> postures;
  lowest_ = 1e300;
  for (Eigen::Index i = 0; i < n; ++i) {
    const planar::State& state = motion.states[static_cast<std::size_t>(i * stride)];
    const BeamLoads loads = rigid_.loads(si<Time>(state.time));
    const LoadedPosture loaded = posture_at(state, loads);
    auto [at, turn] = aligned_at(loaded, state.time);
    ModalPosture& posture = postures.emplace_back();
    posture.squares.resize(k);
    for (Eigen::Index j = 0; j < k; ++j) {
      posture.squares[j] = std::pow(full_turn * at.frequencies[static_cast<std::size_t>(j)], 2);
    }
    lowest_ = std::min(lowest_, at.frequencies.front());
    posture.force = modal_loads(at, loaded);
    FrameTerms frame = frame_terms(at, state);
    posture.of_rate = std::move(frame.of_rate);
    posture.of_size = std::move(frame.of_size);
    posture.damping = std::move(at.damping);
    posture.turn = std::move(turn);
  }
  ModalMotion solved = solve_modal_motion(postures, motion.period);
  eta_ = std::move(solved.eta);
  dynamic_ = std::move(solved.dynamic);
}

LoadedPosture ElasticMotion::posture_at(const planar::State& state, const BeamLoads& rigid) const {
  if (!axial_) return standing_posture(rigid_, elastic_, state, rigid);
  const BeamLoads axial = axial_(si<Time>(state.time));
  return standing_posture(rigid_, elastic_, state, rigid, &axial);
}

ElasticMotion::Aligned ElasticMotion::aligned_at(const LoadedPosture& posture, double time) const {
  PostureModes modes = modes_in_posture(posture, count_);
  Eigen::MatrixXd turn = turn_between(modes.shapes, reference_, time);
  return {std::move(modes), std::move(turn)};
}

Eigen::VectorXd ElasticMotion::dynamic_at(double time) const {
  return trigonometric_at(dynamic_, (time - rigid_.motion->begin) / rigid_.motion->period);
}

BeamLoads ElasticMotion::loads_at(Time time) const {
  BeamLoads loads = rigid_.loads(time);
  const LoadedPosture posture = posture_at(finder_->at(time.value()), loads);
  const auto [at, turn] = aligned_at(posture, time.value());
  const Eigen::VectorXd sizes = turn * dynamic_at(time.value());
  const BeamLoads bent = second_order_of(posture).loads;
  loads.lines = on_stretches_of(loads.lines, bent.lines);
  add_mode(loads, 1.0, bent);
  for (std::size_t j = 0; j < count_; ++j) {
    add_mode(loads, sizes[static_cast<Eigen::Index>(j)], at.loads[j]);
  }
  return loads;
}

LoadsAt elastic_loads_of(const Project& project, const planar::Mechanism& mechanism,
                         const planar::Motion& motion, const ElasticModel& model, LoadsAt rigid) {
  if (model.level == ModelLevel::rigid) return rigid;
  require_few_instants(motion.states.size());
  const RigidMotion bodies{&mechanism, &motion, &project.beam, std::move(rigid)};
  const ElasticBody elastic = elastic_body_of(project, model.parts);
  if (model.level == ModelLevel::quasi_static) return bent_statically(bodies, elastic);
  const auto modes = static_cast<std::size_t>(model.modes);
  auto first = std::make_shared<const ElasticMotion>(bodies, elastic, modes);
  // The vibrating part of an axial force that hardly counts does not count.
  constexpr double hardly = 0.02;
  if (axial_part(bodies, elastic) < hardly) {
    return [first](Time time) { return first->loads_at(time); };
  }
  const LoadsAt vibrating = [first](Time time) { return first->loads_at(time); };
  auto of = std::make_shared<const ElasticMotion>(bodies, elastic, modes, vibrating);
  return [of](Time time) { return of->loads_at(time); };
}

}  // namespace boxbeam
