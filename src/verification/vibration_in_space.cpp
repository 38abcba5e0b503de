#include "vibration_in_space.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/spatial/rest.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/section/torsion.hpp"
#include "boxbeam/verification/front_end.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "sliding_joints.hpp"
#include "strained_once.hpp"

namespace boxbeam {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t modes_estimated = 6, postures_estimated = 12;

/// Looks at postures over a motion, and around the lowest first frequency, which each of them
/// gives, where that changes. `lowest_at`: where it is so far; `now`: what is looked at.
template <class LookAt>
void look_over_motion(const LoadHistory& loads, const Time& lowest_at, double& now,
                      const LookAt& look_at) {
  const double begin = loads.begin().value(), period = loads.period().value();
  const bool closed = loads.closed();
  const std::size_t postures = closed ? postures_estimated : postures_estimated + 1;
  const double step = period / postures_estimated;
  std::vector<double> first;
  for (std::size_t k = 0; k < postures; ++k) {
    now = begin + step * static_cast<double>(k);
    first.push_back(look_at(now));
  }
  const auto [low, high] = std::minmax_element(first.begin(), first.end());
  // What hardly changes is known.
  if (*high > 1.001 * *low && std::isfinite(*high)) {
    double half = 0.5 * step;
    double middle = lowest_at.value();
    for (int round = 0; round < 4; ++round) {
      for (const double side : {middle - half, middle + half}) {
        now = closed ? begin + std::fmod(side - begin + period, period)
                     : std::clamp(side, begin, begin + period);
        look_at(now);
      }
      middle = lowest_at.value();
      half *= 0.5;
    }
  }
}

}  // namespace

std::vector<PlaceInSpace> places_in_space(const TaperedBeam& beam,
                                          const std::vector<Length>& joints) {
  std::vector<PlaceInSpace> places;
  for (const ComparedPlace& place : compared_places_of(beam, joints)) {
    const Section section = section_at(beam, place.station);
    const double A = 1.0 / place.per_N;
    const TorsionProperties torsion = torsion_properties_of(section);
    double per_T = 0.0;
    if (torsion.I_T) {
      const double open = torsion.enclosed.value() > 0.0 ? 1.0 : std::sqrt(3.0);
      per_T = std::sqrt(3.0) * open / std::sqrt(torsion.I_T->value() * A);
    }
    places.push_back(
        {place.station, place.per_N, place.per_M, 1.0 / properties_of(section).W_z.value(), per_T});
  }
  return places;
}

Eigen::RowVectorXd stresses_at(const CutForceDiagram& diagram,
                               const std::vector<PlaceInSpace>& places) {
  Eigen::RowVectorXd stresses(stresses_of_place * static_cast<Eigen::Index>(places.size()));
  Eigen::Index i = 0;
  for (const PlaceInSpace& place : places) {
    const CutForces cut = diagram.at(place.station);
    const double axial = cut.N.value() * place.per_N, y = cut.M_y.value() * place.per_M_y,
                 z = cut.M_z.value() * place.per_M_z;
    for (const double both : {y + z, y - z, -y + z, -y - z}) stresses[i++] = axial + both;
    stresses[i++] = cut.T.value() * place.per_T;
  }
  return stresses;
}

namespace {

Eigen::MatrixXd stresses_over(const LoadHistory& history, const std::vector<PlaceInSpace>& places) {
  Eigen::MatrixXd stresses(static_cast<Eigen::Index>(history.even_instants()),
                           stresses_of_place * static_cast<Eigen::Index>(places.size()));
  for (Eigen::Index i = 0; i < stresses.rows(); ++i)
    stresses.row(i) = stresses_at(history.even_diagram(static_cast<std::size_t>(i)), places);
  return stresses;
}

double friction_in(const spatial::Mechanism& mechanism) {
  double largest = 0.0;
  for (const spatial::Joint& joint : mechanism.joints)
    largest = std::max(largest, joint.friction.coulomb);
  for (const spatial::ClosingJoint& joint : mechanism.closing)
    largest = std::max(largest, joint.friction.coulomb);
  return largest;
}

/// M_y or M_z at a station over the period, the one with the larger stress.
Eigen::VectorXd bending_in_space(const LoadHistory& history, const PlaceInSpace& place) {
  const auto count = static_cast<Eigen::Index>(history.even_instants());
  Eigen::VectorXd y(count), z(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const CutForces cut = history.even_diagram(static_cast<std::size_t>(i)).at(place.station);
    y[i] = cut.M_y.value();
    z[i] = cut.M_z.value();
  }
  const bool about_y = place.per_M_y * (y.maxCoeff() - y.minCoeff()) >=
                       place.per_M_z * (z.maxCoeff() - z.minCoeff());
  return about_y ? y : z;
}

/// `StoppedVibration::rigid_cuts` of every even instant, a row for each.
Eigen::MatrixXd cuts_over(const LoadHistory& history, const spatial::Chain& chain,
                          const StoppedVibration& stopped) {
  const std::size_t count = history.even_instants();
  Eigen::MatrixXd cuts;
  for (std::size_t i = 0; i < count; ++i) {
    const Time time =
        history.begin() + history.period() * (static_cast<double>(i) / static_cast<double>(count));
    const Eigen::VectorXd at = stopped.rigid_cuts(chain.at(time.value()), history.even_diagram(i));
    if (i == 0) cuts.resize(static_cast<Eigen::Index>(count), at.size());
    cuts.row(static_cast<Eigen::Index>(i)) = at.transpose();
  }
  return cuts;
}

/// Of every cut force a part of its largest value, or of all forces or moments where it hardly
/// counts beside these.
Eigen::VectorXd allowed_in_cuts_of_space(const Eigen::VectorXd& largest) {
  constexpr double part = 1e-4, hardly = 1e-2;
  constexpr Eigen::Index kinds = 6;
  const auto every = [&](Eigen::Index kind) {
    return Eigen::seqN(kind, largest.size() / kinds, kinds);
  };
  Eigen::VectorXd of_kinds(kinds), allowed(largest.size());
  for (Eigen::Index k = 0; k < kinds; ++k) of_kinds[k] = largest(every(k)).maxCoeff();
  const double force = of_kinds.head<3>().maxCoeff(), moment = of_kinds.tail<3>().maxCoeff();
  for (Eigen::Index k = 0; k < kinds; ++k)
    allowed(every(k)).setConstant(part * std::max(of_kinds[k], hardly * (k < 3 ? force : moment)));
  return allowed;
}

/// Stresses of rigid loads, against which those beside them are weighed.
struct WeighedStresses {
  std::vector<PlaceInSpace> places;
  Eigen::MatrixXd stresses;
  double peak = 0.0, range = 0.0;

  WeighedStresses(const LoadHistory& history, const TaperedBeam& beam)
      : places(places_in_space(beam)), stresses(stresses_over(history, places)) {
    peak = stresses.cwiseAbs().maxCoeff();
    range = largest_range(stresses);
  }

  /// With none, one, ... of the modes counted. `parts`: of each mode over time, a column each.
  std::vector<double> missed(const std::vector<frame::BeamMode>& modes,
                             const Eigen::MatrixXd& parts) const {
    Eigen::MatrixXd of_modes(static_cast<Eigen::Index>(modes.size()), stresses.cols());
    for (Eigen::Index j = 0; j < of_modes.rows(); ++j)
      of_modes.row(j) = stresses_at(modes[static_cast<std::size_t>(j)].cut, places);
    return missed_without(parts, of_modes, peak, range);
  }

  std::vector<LoadHarmonic> harmonics(const LoadHistory& history) const {
    Eigen::Index governing = 0;
    (stresses.colwise().maxCoeff() - stresses.colwise().minCoeff()).maxCoeff(&governing);
    const auto place = static_cast<std::size_t>(governing / stresses_of_place);
    return harmonics_of(bending_in_space(history, places[place]), 1.0 / history.period().value());
  }
};

/// What the first modes of a posture, taken for the whole motion, are estimated to add.
class SpaceEstimate {
 public:
  SpaceEstimate(const LoadHistory& history, const spatial::Chain& chain,
                const StoppedVibration& stopped, const TaperedBeam& of)
      : history_(&history), weighed_(history, of), base_(1.0 / history.period().value()) {
    const bool steeper = spatial::time_span_of(chain.mechanism()).steeper;
    if (weighed_.peak == 0.0 || steeper) return;
    if (history.closed()) {
      cuts_ = cuts_over(history, chain, stopped);
      return;
    }
    const LoadSpan& span = history.span();
    const spatial::StatesAround states(
        chain, {span.begin.value(), span.period.value(), span.closed, span.instants});
    const auto cuts = [&](double time) {
      return stopped.rigid_cuts(states.at(time), history.diagram_at(si<Time>(time)));
    };
    once_.emplace(open_motion_of(chain, history.span()), cuts, allowed_in_cuts_of_space);
  }

  /// Whether what modes add is estimated.
  bool estimates() const { return cuts_.size() > 0 || once_; }

  bool loaded() const { return weighed_.peak > 0.0; }

  std::vector<double> missed_by(const std::vector<frame::BeamMode>& modes) const {
    return weighed_.missed(modes, once_ ? parts_once(modes) : parts_over_period(modes));
  }

  /// What static loads beside those of rigid bodies add, some in each of these postures.
  double missed_statically(const std::vector<BeamLoads>& loads) const {
    Eigen::MatrixXd stresses(static_cast<Eigen::Index>(loads.size()), weighed_.stresses.cols());
    for (Eigen::Index i = 0; i < stresses.rows(); ++i)
      stresses.row(i) =
          stresses_at(cut_forces_of(loads[static_cast<std::size_t>(i)]), weighed_.places);
    const double of_peak = stresses.cwiseAbs().maxCoeff() / weighed_.peak;
    if (weighed_.range == 0.0) return of_peak;
    return std::max(of_peak, largest_range(stresses) / weighed_.range);
  }

  std::vector<LoadHarmonic> harmonics() const { return weighed_.harmonics(*history_); }

 private:
  Eigen::MatrixXd parts_over_period(const std::vector<frame::BeamMode>& modes) const {
    Eigen::MatrixXd parts(cuts_.rows(), static_cast<Eigen::Index>(modes.size()));
    Eigen::Index j = 0;
    for (const frame::BeamMode& mode : modes)
      parts.col(j++) = dynamic_part(cuts_ * mode.work, mode.frequency, mode.damping, base_);
    return parts;
  }
  Eigen::MatrixXd parts_once(const std::vector<frame::BeamMode>& modes) const {
    const auto count = static_cast<Eigen::Index>(modes.size());
    Eigen::MatrixXd work(count, modes.front().work.size());
    Eigen::VectorXd frequencies(count), damping(count);
    for (Eigen::Index j = 0; j < count; ++j) {
      const frame::BeamMode& mode = modes[static_cast<std::size_t>(j)];
      work.row(j) = mode.work.transpose();
      frequencies[j] = mode.frequency;
      damping[j] = mode.damping;
    }
    return once_->dynamic_parts(work, frequencies, damping);
  }

  const LoadHistory* history_;
  WeighedStresses weighed_;
  double base_;
  Eigen::MatrixXd cuts_;
  std::optional<StrainedOnce> once_;  ///< of a motion that does not repeat
};

}  // namespace

Eigen::MatrixXd stress_history_in_space(const LoadHistory& history, const TaperedBeam& beam) {
  return stresses_over(history, places_in_space(beam));
}

Eigen::MatrixXd stress_history_in_space(const LoadHistory& history, const TaperedBeam& beam,
                                        const LoadSpan& span) {
  const std::vector<PlaceInSpace> places = places_in_space(beam);
  const auto rows = static_cast<Eigen::Index>(span.instants + (span.closed ? 0 : 1));
  Eigen::MatrixXd stresses(rows, stresses_of_place * static_cast<Eigen::Index>(places.size()));
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(span.instants);
    stresses.row(i) = stresses_at(history.diagram_at(span.begin + part * span.period), places);
  }
  return stresses;
}

MissedInSpace missed_in_space(const LoadHistory& history, const TaperedBeam& beam,
                              const std::vector<frame::BeamMode>& modes,
                              const Eigen::MatrixXd& parts) {
  const WeighedStresses weighed(history, beam);
  if (weighed.peak == 0.0) return {};
  return {weighed.missed(modes, parts),
          history.closed() ? weighed.harmonics(history) : std::vector<LoadHarmonic>{}};
}

Eigen::VectorXd largest_stresses_in_space(const std::vector<frame::BeamMode>& modes,
                                          const TaperedBeam& beam) {
  const std::vector<PlaceInSpace> places = places_in_space(beam);
  Eigen::VectorXd largest(static_cast<Eigen::Index>(modes.size()));
  for (Eigen::Index j = 0; j < largest.size(); ++j)
    largest[j] = stresses_at(modes[static_cast<std::size_t>(j)].cut, places).cwiseAbs().maxCoeff();
  return largest;
}

double strained_part_of(const frame::BeamMode& mode) {
  return mode.energy[0] + mode.energy[1] + mode.energy[2] + mode.energy[3] + mode.energy[5];
}

std::string shape_of(const frame::BeamMode& mode) {
  constexpr const char* words[] = {"stretching",
                                   "bending about y",
                                   "bending about z",
                                   "torsion",
                                   "springs and joints beside the beam",
                                   "other beams and rods"};
  return words[std::max_element(mode.energy.begin(), mode.energy.end()) - mode.energy.begin()];
}

std::string obstacle_to_vibration_in_space(const std::deque<SituationRun>& rigid) {
  for (const SituationRun& run : rigid) {
    if (spatial::time_span_of(chain_of(run).mechanism()).steeper)
      return "the edges of a table of forces are steeper than the instants looked at";
  }
  return "";
}

double vibration_missed_in_space(const Project& project, const ModelChoice& model) {
  const bool frame = std::holds_alternative<frame::Structure>(project.mechanism);
  if (!frame && !std::holds_alternative<spatial::Mechanism>(project.mechanism)) return 0.0;
  if (model.chosen.level == ModelLevel::modal) return 0.0;
  if (model.weighed.empty()) return 0.0;
  const ModelEstimate& by_rigid = model.weighed.front();
  const SecondOrderEstimate& pressed = model.second_order;
  const double bending = pressed.whole ? pressed.change.value_or(0.0) : 0.0;
  return std::max({0.0, by_rigid.error - bending, by_rigid.found.value_or(0.0)});
}

VibrationInSpace estimate_vibration_in_space(const Project& project, const SituationRun& run,
                                             int parts, bool bends_known) {
  const spatial::Chain& chain = chain_of(run);
  StoppedVibration stopped(project, chain, parts);
  const SpaceEstimate of_loads(run.loads, chain, stopped, project.beam);
  VibrationInSpace result;
  VibrationEstimate& estimate = result.estimate;
  estimate.without_modes = {0.0};
  if (!of_loads.loaded()) return result;
  double fastest = 0.0, sliding = 0.0;
  double beside = 0.0;  // of the first mode's mass what is not the beam's
  const bool bends_beside = !bends_known && stopped.freedoms() == 0 && stopped.takes_over();
  std::vector<BeamLoads> statically;
  /// The first frequency in a posture, which is weighed; infinite without mass.
  const auto look_at = [&](double time) {
    const spatial::State state = chain.at(time);
    const std::vector<frame::BeamMode> modes =
        stopped.modes(state, run.loads.diagram_at(si<Time>(time)), modes_estimated);
    if (modes.empty()) return std::numeric_limits<double>::infinity();
    if (bends_beside)
      statically.push_back(stopped.taken_over(state, run.loads.diagram_at(si<Time>(time)), modes));
    for (const spatial::BeamPlacement& beam : stopped.placements())
      fastest = std::max(fastest, state.bodies[static_cast<std::size_t>(beam.body)].omega.norm());
    const std::vector<double> missed =
        of_loads.estimates() ? of_loads.missed_by(modes) : std::vector<double>{};
    sliding = std::max(sliding, sliding_along(chain.mechanism(), state, stopped.placements(),
                                              project.beam.length().value()));
    if (estimate.without_modes.size() < missed.size())
      estimate.without_modes.resize(missed.size(), 0.0);
    for (std::size_t k = 0; k < missed.size(); ++k)
      estimate.without_modes[k] = std::max(estimate.without_modes[k], missed[k]);
    beside = std::max(beside, std::clamp(1.0 - modes.front().own_mass, 0.0, 1.0));
    // Of postures that are alike the first.
    constexpr double lower = 1.0 - 1e-9;
    if (estimate.frequencies.empty() ||
        modes.front().frequency < lower * estimate.frequencies.front()) {
      estimate.frequencies.clear();
      for (const frame::BeamMode& mode : modes) estimate.frequencies.push_back(mode.frequency);
      result.lowest_at = si<Time>(time);
      result.shape = shape_of(modes.front());
    }
    return modes.front().frequency;
  };
  double now = 0.0;
  try {
    look_over_motion(run.loads, result.lowest_at, now, look_at);
  } catch (const AnalysisError& error) {
    result.obstacle = fmt::format("stopped at {:.4g} s, {}", now, error.failure().what);
    return result;
  }
  if (estimate.frequencies.empty() || !of_loads.estimates()) return result;
  const double lowest = full_turn * estimate.frequencies.front();
  const double turning = std::pow(fastest / lowest, 2);
  // Bodies beside the beam turn with axes of their own, and slide, against which modes change.
  const double coupled = turning * beside + std::pow(sliding / lowest, 2);
  for (std::size_t k = 1; k < estimate.without_modes.size(); ++k)
    estimate.without_modes[k] += coupled;
  estimate.without_modes.front() += turning;
  if (bends_beside) estimate.without_modes.front() += of_loads.missed_statically(statically);
  const double rubbed = friction_in(chain.mechanism()) * estimate.without_modes.front();
  for (double& error : estimate.without_modes) error += rubbed;
  estimate.left_out = coupled + rubbed;
  if (run.loads.closed()) estimate.harmonics = of_loads.harmonics();
  return result;
}

}  // namespace boxbeam
