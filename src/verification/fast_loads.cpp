#include "fast_loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"

namespace boxbeam {
namespace {

/// The lowest circular frequency of the beams with all that they could carry [1/s]; infinite of
/// what has no mass.
double lowest_of(const Project& project, const spatial::Mechanism& mechanism) {
  double mass = 0.0, length = 0.0, least = std::numeric_limits<double>::infinity();
  for (const spatial::Body& body : mechanism.bodies) mass += body.mass;
  const auto add = [&](const TaperedBeam& beam) {
    for (const Segment& segment : beam.segments) {
      double largest = 0.0;
      for (const Section& section : {segment.from, segment.to}) {
        const SectionProperties of = properties_of(section);
        least = std::min({least, of.I_y.value(), of.I_z.value()});
        largest = std::max(largest, of.area.value());
      }
      mass += beam.density.value() * largest * segment.length.value();
    }
    length += beam.length().value();
  };
  add(project.beam);
  for (const ElasticBeside& other : project.elastic_beside)
    if (std::holds_alternative<WholeBody>(other.place)) add(other.beam);
  return std::sqrt(3.0 * project.model.youngs_modulus * least / (mass * std::pow(length, 3)));
}

/// Bending stresses about both axes at the places of an instant [Pa].
Eigen::ArrayXd bending_at(const CutForceDiagram& diagram, const std::vector<ComparedPlace>& places,
                          const std::vector<double>& modulus_across) {
  Eigen::ArrayXd stresses(2 * static_cast<Eigen::Index>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k) {
    const CutForces cut = diagram.at(places[k].station);
    const auto i = 2 * static_cast<Eigen::Index>(k);
    stresses[i] = cut.M_y.value() * places[k].per_M;
    stresses[i + 1] = cut.M_z.value() / modulus_across[k];
  }
  return stresses;
}

}  // namespace

bool may_vibrate(const Project& project, const spatial::Mechanism& mechanism,
                 const LoadHistory& history) {
  const double omega = lowest_of(project, mechanism);
  if (!std::isfinite(omega)) return false;
  const std::vector<ComparedPlace> places = compared_places_of(project.beam);
  std::vector<double> across;
  for (const ComparedPlace& place : places)
    across.push_back(properties_of(section_at(project.beam, place.station)).W_z.value());
  const std::size_t count = history.instants();
  std::vector<double> times;
  std::vector<Eigen::ArrayXd> stresses;
  double largest = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double time = history.time_of(i).value();
    if (!times.empty() && time <= times.back()) continue;
    times.push_back(time);
    stresses.push_back(bending_at(history.diagram(i), places, across));
    largest = std::max(largest, stresses.back().abs().maxCoeff());
  }
  if (times.size() < 2 || largest == 0.0) return false;
  if (history.closed()) {
    const double period = history.period().value();
    if (times.back() < times.front() + (1.0 - 1e-12) * period) {
      times.push_back(times.front() + period);
      stresses.push_back(stresses.front());
    }
  }
  const Eigen::Index n = stresses.front().size();
  Eigen::ArrayXd beside = Eigen::ArrayXd::Zero(n), speed = beside, slope = beside;
  bool first = true;
  for (int round = 0; round < (history.closed() ? 3 : 1); ++round) {
    for (std::size_t i = 1; i < times.size(); ++i) {
      const double h = times[i] - times[i - 1], turn = omega * h;
      const Eigen::ArrayXd now = (stresses[i] - stresses[i - 1]) / h;
      if (!first) speed -= now - slope;
      first = false;
      slope = now;
      const Eigen::ArrayXd before = beside;
      beside = std::cos(turn) * before + std::sin(turn) / omega * speed;
      speed = std::cos(turn) * speed - omega * std::sin(turn) * before;
      const double size = (beside.square() + (speed / omega).square()).sqrt().maxCoeff();
      // Between a jump's two sides the speed is no vibration.
      if (turn > 1e-3 && size > project.model.tolerance * largest) return true;
    }
  }
  return false;
}

}  // namespace boxbeam
