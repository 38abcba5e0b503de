#include "boxbeam/verification/vibrating_stress.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/section/section_properties.hpp"

namespace boxbeam {
namespace {

/// A range this small beside the stresses is none.
constexpr double round_off_of_range = 1e-11;

}  // namespace

std::vector<ComparedPlace> compared_places_of(const TaperedBeam& beam,
                                              const std::vector<Length>& joints) {
  constexpr double in_all = 32.0;
  std::vector<Length> at = places_of(beam);
  const std::vector<Length> named = at;
  for (const Length& s : joints) at.push_back(place_near(named, s));
  for (const Segment& segment : beam.segments) {
    const int pieces = std::max(2, static_cast<int>(in_all * segment.length / beam.length()));
    for (int k = 1; k < pieces; ++k)
      at.push_back(segment.start + segment.length * (static_cast<double>(k) / pieces));
  }
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end()), at.end());
  std::vector<ComparedPlace> places;
  std::optional<Section> last;
  SectionProperties of;
  for (const Length& s : at) {
    for (const Side side : {Side::before, Side::behind}) {
      if (side == Side::before ? s == at.front() : s == at.back()) continue;
      Section section = section_at(beam, {s, side});
      if (!last || !(section == *last)) {
        of = properties_of(section);
        last = std::move(section);
      }
      places.push_back({{s, side}, 1.0 / of.area.value(), 1.0 / of.W_y.value()});
    }
  }
  return places;
}

Eigen::ArrayXd fibre_stresses(const CutForceDiagram& diagram,
                              const std::vector<ComparedPlace>& places) {
  Eigen::ArrayXd stresses(2 * static_cast<Eigen::Index>(places.size()));
  Eigen::Index i = 0;
  for (const ComparedPlace& place : places) {
    const CutForces cut = diagram.at(place.station);
    const double axial = cut.N.value() * place.per_N;
    const double bending = cut.M_y.value() * place.per_M;
    stresses[i++] = axial + bending;
    stresses[i++] = axial - bending;
  }
  return stresses;
}

Eigen::MatrixXd stress_history(const LoadHistory& history,
                               const std::vector<ComparedPlace>& places) {
  Eigen::MatrixXd stresses(static_cast<Eigen::Index>(history.even_instants()),
                           2 * static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < history.even_instants(); ++i) {
    stresses.row(static_cast<Eigen::Index>(i)) =
        fibre_stresses(history.even_diagram(i), places).transpose();
  }
  return stresses;
}

double largest_range(const Eigen::MatrixXd& stresses) {
  const double range = (stresses.colwise().maxCoeff() - stresses.colwise().minCoeff()).maxCoeff();
  return range > round_off_of_range * stresses.cwiseAbs().maxCoeff() ? range : 0.0;
}

std::vector<double> missed_without(const Eigen::MatrixXd& parts, const Eigen::MatrixXd& stresses,
                                   double peak, double range) {
  // A harmonic that meets a frequency without damping has no bound.
  constexpr double no_bound = 1e6;
  const Eigen::Index modes = parts.cols();
  std::vector<double> missed(static_cast<std::size_t>(modes) + 1, 0.0);
  const Eigen::RowVectorXd sizes = parts.cwiseAbs().colwise().maxCoeff();
  const Eigen::RowVectorXd widths = parts.colwise().maxCoeff() - parts.colwise().minCoeff();
  Eigen::VectorXd sum(parts.rows());
  for (Eigen::Index j = modes; j-- > 0;) {
    if (!parts.col(j).allFinite()) {
      std::fill_n(missed.begin(), j + 1, no_bound);
      break;
    }
    const Eigen::Index others = modes - j;
    const Eigen::MatrixXd of_units = stresses.bottomRows(others).cwiseAbs();
    Eigen::RowVectorXd most = sizes.tail(others) * of_units,
                       widest = widths.tail(others) * of_units;
    double largest = 0.0, range_of = 0.0;
    const auto look_at = [&](Eigen::Index place) {
      sum.noalias() = parts.rightCols(others) * stresses.col(place).tail(others);
      const double high = sum.maxCoeff(), low = sum.minCoeff();
      largest = std::max({largest, high, -low});
      range_of = std::max(range_of, high - low);
      most[place] = widest[place] = 0.0;
    };
    Eigen::Index place = 0;
    while (most.maxCoeff(&place) > largest) look_at(place);
    while (range > 0.0 && widest.maxCoeff(&place) > range_of) look_at(place);
    if (range_of <= round_off_of_range * largest) range_of = 0.0;
    const double by_range = range > 0.0 ? range_of / range : 0.0;
    missed[static_cast<std::size_t>(j)] = std::min(no_bound, std::max(largest / peak, by_range));
  }
  return missed;
}

double VibratingStress::peak() const { return (constant.abs() + harmonic.abs()).maxCoeff(); }

double VibratingStress::amplitude() const { return harmonic.abs().maxCoeff(); }

VibratingStress vibrating_stress_of(const flexible::BeamResponse& response,
                                    const std::vector<ComparedPlace>& places) {
  const auto stresses = [&](const BeamLoads& loads) {
    return fibre_stresses(cut_forces_of(loads), places);
  };
  VibratingStress field;
  field.constant = stresses(response.constant);
  field.harmonic = Eigen::ArrayXcd::Zero(field.constant.size());
  if (response.frequency > 0.0) {
    field.harmonic.real() = stresses(response.sine);
    field.harmonic.imag() = stresses(response.cosine);
  }
  return field;
}

double difference_between(const VibratingStress& model, const VibratingStress& better) {
  VibratingStress difference;
  difference.constant = model.constant - better.constant;
  difference.harmonic = model.harmonic - better.harmonic;
  const double peak = better.peak();
  const double amplitude = better.amplitude();
  double largest = 0.0;
  if (peak > 0.0) largest = difference.peak() / peak;
  if (amplitude > 0.0) largest = std::max(largest, difference.amplitude() / amplitude);
  return largest;
}

}  // namespace boxbeam
