#include "boxbeam/verification/vibration_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/FFT>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t modes_looked_at = 3;
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

/// The mean cut forces over the parts of an elastic body as a rigid one, instant by instant: in
/// most postures it is divided alike.
class MeansOverTime {
 public:
  /// `diagram(i)`: of the instant i.
  template <class DiagramAt>
  const std::vector<Eigen::Matrix3Xd>& over(const std::vector<flexible::SpringElement>& springs,
                                            std::size_t instants, const DiagramAt& diagram) {
    if (same_places(divided_, springs)) return means_;
    divided_ = springs;
    means_.clear();
    for (std::size_t i = 0; i < instants; ++i) means_.push_back(means_over(diagram(i), springs));
    return means_;
  }

 private:
  std::vector<flexible::SpringElement> divided_;
  std::vector<Eigen::Matrix3Xd> means_;
};

/// Cut forces of the elastic bodies beside the beam as rigid ones, at the instants of a history.
std::vector<std::vector<CutForceDiagram>> cuts_beside(const RigidMotion& rigid,
                                                      const ElasticBody& elastic,
                                                      const LoadHistory& history) {
  std::vector<std::vector<CutForceDiagram>> cuts(elastic.beside.size());
  if (cuts.empty()) return cuts;
  planar::StateFinder finder(*rigid.mechanism, *rigid.motion);
  const double step = history.period().value() / static_cast<double>(history.even_instants());
  for (std::size_t i = 0; i < history.even_instants(); ++i) {
    const planar::State state = finder.at(history.begin().value() + step * static_cast<double>(i));
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      cuts[k].push_back(cut_forces_of(
          planar::beam_loads_of(*rigid.mechanism, state, elastic.beside[k].laid_out)));
    }
  }
  return cuts;
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
                                     const LoadHistory& history) {
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

  MeansOverTime means;
  const std::vector<std::vector<CutForceDiagram>> beside = cuts_beside(rigid, elastic, history);
  std::vector<MeansOverTime> means_beside(beside.size());
  double fastest = 0.0;
  for (const planar::State& state : motion.states) {
    fastest = std::max(fastest, std::abs(state.v[3 * static_cast<Eigen::Index>(elastic.body) + 2]));
  }
  const std::size_t step = std::max<std::size_t>(1, motion.states.size() / postures_looked_at);
  for (std::size_t at = 0; at < motion.states.size(); at += step) {
    const planar::State& state = motion.states[at];
    const PostureModes modes =
        modes_in_posture(loaded_posture(*rigid.mechanism, state, elastic, *rigid.beam,
                                        rigid.loads(si<Time>(state.time))),
                         modes_looked_at);
    if (modes.frequencies.empty()) continue;  // without mass nothing vibrates
    if (!(modes.frequencies.front() > 0.0)) {
      refuse("the lowest natural frequency of the beam in its mechanism cannot be told from zero");
    }
    const auto count = static_cast<Eigen::Index>(modes.frequencies.size());
    Eigen::MatrixXd p = Eigen::MatrixXd::Zero(stresses.rows(), count);
    const auto add_work = [&](const PostureModes::Strained& of, MeansOverTime& over,
                              const auto& diagram) {
      const std::vector<Eigen::Matrix3Xd>& of_instants =
          over.over(of.link.springs, history.even_instants(), diagram);
      for (std::size_t i = 0; i < of_instants.size(); ++i)
        p.row(static_cast<Eigen::Index>(i)) += modal_loads(of, of_instants[i]).transpose();
    };
    add_work(modes.beam, means,
             [&](std::size_t i) -> const CutForceDiagram& { return history.even_diagram(i); });
    for (std::size_t k = 0; k < beside.size(); ++k) {
      add_work(modes.beside[k], means_beside[k],
               [&](std::size_t i) -> const CutForceDiagram& { return beside[k][i]; });
    }
    const double turning = std::pow(fastest / (full_turn * modes.frequencies.front()), 2);
    const double of_others = 1.0 - modes.shifting[static_cast<std::size_t>(elastic.body)](0, 0);
    const double left_out = turning * std::clamp(of_others, 0.0, 1.0);
    estimate.left_out = std::max(estimate.left_out, left_out);
    const auto raise = [&](std::size_t counted, double error) {
      if (estimate.without_modes.size() <= counted) estimate.without_modes.resize(counted + 1, 0.0);
      estimate.without_modes[counted] =
          std::max(estimate.without_modes[counted], error + (counted == 0 ? turning : left_out));
    };
    Eigen::MatrixXd missed = Eigen::MatrixXd::Zero(stresses.rows(), stresses.cols());
    raise(static_cast<std::size_t>(count), 0.0);
    for (Eigen::Index j = count; j-- > 0;) {
      const auto mode = static_cast<std::size_t>(j);
      const double frequency = modes.frequencies[mode];
      const Eigen::VectorXd part = dynamic_part(p.col(j), frequency, modes.damping(j, j), base);
      missed += part * fibre_stresses(modes.diagrams[mode], places).matrix().transpose();
      const double of_range = range > 0.0 ? largest_range(missed) / range : 0.0;
      raise(mode, std::max(missed.cwiseAbs().maxCoeff() / peak, of_range));
    }
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
  estimate.harmonics = harmonics_of(bending_over_period(history, station), base);
  return estimate;
}

}  // namespace boxbeam
