#include "boxbeam/verification/vibration_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <unsupported/Eigen/FFT>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "strained_once.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t modes_looked_at = 3;
/// What begins suddenly excites high modes as well.
constexpr std::size_t modes_of_start = 6;
constexpr std::size_t postures_looked_at = 6;
constexpr double significant = 0.01;

using Spectrum = std::vector<std::complex<double>>;

Spectrum spectrum_of(const Eigen::VectorXd& samples) {
  Eigen::FFT<double> transform;
  const std::vector<double> values(samples.data(), samples.data() + samples.size());
  Spectrum spectrum;
  transform.fwd(spectrum, values);
  return spectrum;
}

Eigen::VectorXd samples_of(const Spectrum& spectrum) {
  Eigen::FFT<double> transform;
  std::vector<double> values;
  transform.inv(values, spectrum);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

[[noreturn]] void refuse(const char* what) {
  throw AnalysisError(
      {fmt::format("what vibration adds cannot be estimated: {}; look for a mass, an inertia or a "
                   "stiffness that cannot be meant",
                   what),
       "beam",
       {},
       {},
       {}});
}

/// M_y of a station at equal steps of a period.
Eigen::VectorXd bending_over_period(const LoadHistory& history, const Station& station) {
  Eigen::VectorXd moment(static_cast<Eigen::Index>(history.even_instants()));
  for (std::size_t i = 0; i < history.even_instants(); ++i) {
    moment[static_cast<Eigen::Index>(i)] = history.even_diagram(i).at(station).M_y.value();
  }
  return moment;
}

bool same_places(const std::vector<flexible::SpringElement>& a,
                 const std::vector<flexible::SpringElement>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const flexible::SpringElement& one, const flexible::SpringElement& other) {
                      return one.from == other.from && one.place == other.place &&
                             one.to == other.to;
                    });
}

/// The parts into which elastic bodies are divided, the beam's first.
using DividedBodies = std::vector<std::vector<flexible::SpringElement>>;

DividedBodies divided_in(const PostureModes& modes) {
  DividedBodies divided{modes.beam.link.springs};
  for (const PostureModes::Strained& other : modes.beside) divided.push_back(other.link.springs);
  return divided;
}

bool divided_alike(const DividedBodies& a, const DividedBodies& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_places);
}

/// What strains elastic bodies and joints: the mean cut forces of rigid ones over the parts of
/// bodies, and what joints do, three of each, as one column.
class StrainingCuts {
 public:
  StrainingCuts(const RigidMotion& rigid, const ElasticBody& elastic)
      : rigid_(&rigid), elastic_(&elastic), states_(*rigid.mechanism, *rigid.motion) {}

  Eigen::VectorXd at(double time, const DividedBodies& divided) {
    return at(time, cut_forces_of(rigid_->loads(si<Time>(time))), divided);
  }
  /// `beam`: of the beam then.
  Eigen::VectorXd at(double time, const CutForceDiagram& beam, const DividedBodies& divided) {
    Eigen::Index size = 0;
    for (const auto& springs : divided) size += 3 * static_cast<Eigen::Index>(springs.size());
    size += 3 * static_cast<Eigen::Index>(elastic_->joints.size());
    Eigen::VectorXd column(size);
    Eigen::Index from = 0;
    const auto put = [&](const CutForceDiagram& cut, std::size_t body) {
      const Eigen::Index rows = 3 * static_cast<Eigen::Index>(divided[body].size());
      column.segment(from, rows) = means_over(cut, divided[body]).reshaped();
      from += rows;
    };
    put(beam, 0);
    if (elastic_->alone()) return column;
    std::size_t body = 0;
    const planar::State state = states_.at(time);
    for (const BeamLoads& loads : loads_beside(*rigid_->mechanism, state, *elastic_))
      put(cut_forces_of(loads), ++body);
    for (const planar::ElasticJoint& joint : elastic_->joints) {
      column.segment<3>(from) = force_in(*rigid_->mechanism, state, *elastic_, joint);
      from += 3;
    }
    return column;
  }

 private:
  const RigidMotion* rigid_;
  const ElasticBody* elastic_;
  planar::StatesAround states_;
};

/// Of every kind of cut force a part of its largest value.
Eigen::VectorXd allowed_in_cuts(const Eigen::VectorXd& largest) {
  constexpr double part = 1e-4;
  Eigen::VectorXd allowed(largest.size());
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto every = Eigen::seqN(k, largest.size() / 3, 3);
    allowed(every).setConstant(part * largest(every).maxCoeff());
  }
  return allowed;
}

/// The work of what strains the elastic bodies, a column of `StrainingCuts`, on modes, a row each.
Eigen::MatrixXd work_on(const PostureModes& modes) {
  Eigen::Index parts = static_cast<Eigen::Index>(modes.beam.strains.size());
  for (const PostureModes::Strained& other : modes.beside)
    parts += static_cast<Eigen::Index>(other.strains.size());
  parts += static_cast<Eigen::Index>(modes.gaps.size());
  Eigen::MatrixXd work(static_cast<Eigen::Index>(modes.frequencies.size()), 3 * parts);
  Eigen::Index from = 0;
  const auto put = [&](const PostureModes::Strained& of) {
    for (const Eigen::Matrix3Xd& strains : of.strains) {
      work.middleCols<3>(from) = strains.transpose();
      from += 3;
    }
  };
  put(modes.beam);
  for (const PostureModes::Strained& other : modes.beside) put(other);
  for (const Eigen::Matrix3Xd& gaps : modes.gaps) {
    work.middleCols<3>(from) = gaps.transpose();
    from += 3;
  }
  return work;
}

/// What strains the elastic bodies over a motion, and what modes do under it.
class Straining {
 public:
  Straining(const RigidMotion& rigid, const ElasticBody& elastic, const LoadHistory& history)
      : rigid_(&rigid), history_(&history), cuts_(rigid, elastic) {}
  // What strains over a motion that does not repeat is asked of the cuts when it is followed.
  Straining(const Straining&) = delete;
  Straining& operator=(const Straining&) = delete;

  /// eta + (C eta' - p)/omega^2 of modes that have these frequencies [Hz], a column each.
  Eigen::MatrixXd dynamic_parts(const PostureModes& modes, const Eigen::VectorXd& frequencies) {
    divide(divided_in(modes));
    const Eigen::MatrixXd work = work_on(modes);
    if (once_) return once_->dynamic_parts(work, frequencies, modes.damping.diagonal());
    Eigen::MatrixXd parts = straining_ * work.transpose();
    for (Eigen::Index j = 0; j < parts.cols(); ++j)
      parts.col(j) = dynamic_part(parts.col(j), frequencies[j], modes.damping(j, j),
                                  1.0 / rigid_->motion->period);
    return parts;
  }

 private:
  /// In most postures bodies are divided alike.
  void divide(DividedBodies anew) {
    if (divided_alike(divided_, anew)) return;
    divided_ = std::move(anew);
    const planar::Motion& motion = *rigid_->motion;
    if (!motion.closed) {
      once_.emplace(
          open_motion_of(*rigid_->mechanism, motion),
          [&](double time) { return cuts_.at(time, divided_); }, allowed_in_cuts);
      return;
    }
    const std::size_t instants = history_->even_instants();
    const double step = motion.period / static_cast<double>(instants);
    for (std::size_t i = 0; i < instants; ++i) {
      const Eigen::VectorXd column = cuts_.at(motion.begin + step * static_cast<double>(i),
                                              history_->even_diagram(i), divided_);
      if (i == 0) straining_.resize(static_cast<Eigen::Index>(instants), column.size());
      straining_.row(static_cast<Eigen::Index>(i)) = column.transpose();
    }
  }

  const RigidMotion* rigid_;
  const LoadHistory* history_;
  StrainingCuts cuts_;
  DividedBodies divided_;
  Eigen::MatrixXd straining_;  ///< a row for each even instant
  std::optional<StrainedOnce> once_;
};

/// The first mode that turning couples with others. Where forces move the mechanism `may` of them,
/// no faster than twice the turning, move whole bodies.
std::size_t first_coupled(const std::vector<double>& frequencies, double turning, std::size_t may) {
  constexpr double faster = 2.0;
  std::size_t first = 0;
  while (first < may && first + 1 < frequencies.size() &&
         full_turn * frequencies[first] <= faster * turning)
    ++first;
  return first;
}

/// The beam and the bodies that turn with it at all times: seen from it they move in a mode always
/// in the same direction, so that the terms of its turning hold for them as they do for itself.
/// What forces move may turn otherwise with its vibration, and there it is the beam alone.
std::vector<int> bodies_that_turn_with(int beam, const planar::Motion& motion, double fastest) {
  constexpr double round_off = 1e-9;
  const auto turning_of = [](const planar::State& state, int body) {
    return state.v[3 * static_cast<Eigen::Index>(body) + 2];
  };
  std::vector<int> bodies;
  const auto count = static_cast<int>(motion.states.front().v.size() / 3);
  for (int body = 0; body < count; ++body) {
    const auto alike = [&](const planar::State& state) {
      return std::abs(turning_of(state, body) - turning_of(state, beam)) <= round_off * fastest;
    };
    if (body == beam || (motion.freedom.undriven == 0 &&
                         std::all_of(motion.states.begin(), motion.states.end(), alike)))
      bodies.push_back(body);
  }
  return bodies;
}

/// The part of the mass of a mode that is in some bodies.
double mass_of_mode_in(const PostureModes& modes, std::size_t mode,
                       const std::vector<int>& bodies) {
  const auto j = static_cast<Eigen::Index>(mode);
  double mass = 0.0;
  for (const int body : bodies) mass += modes.shifting[static_cast<std::size_t>(body)](j, j);
  return mass;
}

/// The largest coefficient of dry friction in a mechanism.
double largest_friction(const planar::Mechanism& mechanism) {
  double largest = 0.0;
  for (const planar::FrictionContact& contact : planar::friction_contacts_of(mechanism)) {
    largest = std::max(largest, contact.law.coulomb);
  }
  return largest;
}

}  // namespace

Eigen::VectorXd dynamic_part(const Eigen::VectorXd& p, double frequency, double damping,
                             double base) {
  const double omega = full_turn * frequency;
  Spectrum spectrum = spectrum_of(p);
  const std::size_t n = spectrum.size();
  for (std::size_t h = 0; h < n; ++h) {
    const double harmonic =
        h <= n / 2 ? static_cast<double>(h) : static_cast<double>(h) - static_cast<double>(n);
    const double r = harmonic * base / frequency;
    const std::complex<double> dynamic(1.0 - r * r, damping * r / omega);
    spectrum[h] *= r * r / dynamic / (omega * omega);
  }
  return samples_of(spectrum);
}

std::vector<LoadHarmonic> harmonics_of(const Eigen::VectorXd& moment, double base) {
  const Spectrum spectrum = spectrum_of(moment);
  const double largest = moment.cwiseAbs().maxCoeff();
  std::vector<LoadHarmonic> harmonics;
  for (std::size_t h = 1; h <= spectrum.size() / 2; ++h) {
    const double share =
        2.0 * std::abs(spectrum[h]) / (static_cast<double>(spectrum.size()) * largest);
    if (share > significant) harmonics.push_back({static_cast<double>(h) * base, share});
  }
  return harmonics;
}

VibrationEstimate estimate_vibration(const RigidMotion& rigid, const ElasticBody& elastic,
                                     const LoadHistory& history, double slower) {
  const planar::Motion& motion = *rigid.motion;
  const std::vector<ComparedPlace> places = compared_places_of(*rigid.beam);
  const Eigen::MatrixXd stresses = stress_history(history, places);
  const double range = largest_range(stresses);
  const double peak = stresses.cwiseAbs().maxCoeff();
  const double base = 1.0 / motion.period;
  VibrationEstimate estimate;
  estimate.without_modes = {0.0};
  if (peak == 0.0) return estimate;
  if (!std::isfinite(peak)) refuse("the stresses under the loads of rigid bodies are no numbers");

  Straining straining(rigid, elastic, history);
  double fastest = 0.0;
  for (const planar::State& state : motion.states) {
    fastest = std::max(fastest, std::abs(state.v[3 * static_cast<Eigen::Index>(elastic.body) + 2]));
  }
  const auto may_move = static_cast<std::size_t>(motion.freedom.undriven);
  const std::vector<int> turning_alike = bodies_that_turn_with(elastic.body, motion, fastest);
  const double pressed = may_move > 0 ? 0.0 : 1.0;
  const std::size_t step = std::max<std::size_t>(1, motion.states.size() / postures_looked_at);
  for (std::size_t at = 0; at < motion.states.size(); at += step) {
    const planar::State& state = motion.states[at];
    const PostureModes modes =
        straining_modes_in(loaded_posture(*rigid.mechanism, state, elastic, *rigid.beam,
                                          rigid.loads(si<Time>(state.time)), pressed),
                           motion.closed ? modes_looked_at : modes_of_start, may_move);
    if (modes.frequencies.empty()) continue;  // without mass nothing vibrates
    if (!(modes.frequencies.front() > 0.0)) {
      refuse("the lowest natural frequency of the beam in its mechanism cannot be told from zero");
    }
    const auto count = static_cast<Eigen::Index>(modes.frequencies.size());
    const Eigen::VectorXd frequencies =
        slower * Eigen::VectorXd::Map(modes.frequencies.data(), count);
    const Eigen::MatrixXd parts = slower * slower * straining.dynamic_parts(modes, frequencies);
    const std::size_t coupled = first_coupled(modes.frequencies, fastest, may_move);
    const double turning = std::pow(fastest / (full_turn * modes.frequencies[coupled]), 2);
    const double of_others = 1.0 - mass_of_mode_in(modes, coupled, turning_alike);
    const double left_out = turning * std::clamp(of_others, 0.0, 1.0);
    estimate.left_out = std::max(estimate.left_out, left_out);
    const auto raise = [&](std::size_t counted, double error) {
      if (estimate.without_modes.size() <= counted) estimate.without_modes.resize(counted + 1, 0.0);
      estimate.without_modes[counted] =
          std::max(estimate.without_modes[counted], error + (counted == 0 ? turning : left_out));
    };
    Eigen::MatrixXd of_modes(count, stresses.cols());
    for (Eigen::Index j = 0; j < count; ++j)
      of_modes.row(j) = fibre_stresses(modes.diagrams[static_cast<std::size_t>(j)], places);
    const std::vector<double> missed = missed_without(parts, of_modes, peak, range);
    for (std::size_t counted = missed.size(); counted-- > 0;) raise(counted, missed[counted]);
    if (estimate.frequencies.empty() || modes.frequencies.front() < estimate.frequencies.front()) {
      estimate.frequencies = modes.frequencies;
    }
  }
  // Dry friction follows the pressure on its guide, whose elastic part is in no mode.
  const double rubbed = largest_friction(*rigid.mechanism) * estimate.without_modes.front();
  for (double& error : estimate.without_modes) error += rubbed;
  estimate.left_out += rubbed;
  Eigen::Index governing = 0;
  (stresses.colwise().maxCoeff() - stresses.colwise().minCoeff()).maxCoeff(&governing);
  const Station& station = places[static_cast<std::size_t>(governing / 2)].station;
  if (motion.closed) estimate.harmonics = harmonics_of(bending_over_period(history, station), base);
  return estimate;
}

}  // namespace boxbeam
