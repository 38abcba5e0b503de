#include "boxbeam/verification/whole_life.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "whole_life_parts.hpp"

namespace boxbeam {
namespace {

/// The curve whose reference is 1 Pa.
SnCurve shape_of(const SnCurve& curve) {
  SnCurve shape = scaled(curve, 1.0 / curve.reference.value());
  shape.name = shape.code = shape.source = "";
  return shape;
}

bool same_shape(const SnCurve& a, const SnCurve& b) {
  const auto same = [](const SnBranch& x, const SnBranch& y) {
    return x.slope == y.slope && x.until == y.until;
  };
  return a.reference_cycles == b.reference_cycles &&
         a.constant_amplitude_limit == b.constant_amplitude_limit && a.cut_off == b.cut_off &&
         std::equal(a.branches.begin(), a.branches.end(), b.branches.begin(), b.branches.end(),
                    same);
}

}  // namespace

WholeLife::WholeLife(const Project& project, const std::deque<SituationRun>& runs)
    : project_(&project) {
  std::size_t first = 0;
  for (const SituationRun& run : runs) {
    Part part;
    part.situation = index_of(project, *run.situation);
    part.channels = run.loads.recorded_channels();
    part.record = part.channels->record;
    part.first = first;
    const auto K = static_cast<Eigen::Index>(part.channels->values.size());
    first += static_cast<std::size_t>(K) + 1;
    if (!part.record) {
      std::vector<recorded::RecordColumn> columns;
      for (const std::vector<double>& values : part.channels->values)
        columns.push_back({values, 0.0});
      if (columns.empty())
        columns.push_back({std::vector<double>(part.channels->times.size()), 0.0});
      part.record = std::make_shared<const recorded::Record>(0.0, 0.0, part.channels->times,
                                                             std::move(columns));
    }
    if (part.channels->outer) {
      part.centre = part.channels->outer->centre;
      part.metric = part.channels->outer->metric;
    } else {
      const auto n = static_cast<Eigen::Index>(part.channels->times.size());
      Eigen::MatrixXd values(n, K);
      for (Eigen::Index k = 0; k < K; ++k) {
        values.col(k) = Eigen::Map<const Eigen::VectorXd>(
            part.channels->values[static_cast<std::size_t>(k)].data(), n);
      }
      part.centre = values.colwise().mean().transpose();
      values.rowwise() -= part.centre.transpose();
      part.metric = values.transpose() * values / static_cast<double>(n);
    }
    summary.instants += part.record->instants();
    parts_.push_back(std::move(part));
  }
}

WholeLife::~WholeLife() = default;

std::size_t WholeLife::instants() const { return summary.instants; }

WholePlace WholeLife::place_of(std::span<const std::vector<CutForces>> unit_cuts,
                               const std::array<double, cut_force::count>& influence, double factor,
                               bool compression_reduced) const {
  WholePlace place{{}, compression_reduced};
  for (const std::vector<CutForces>& cuts : unit_cuts) {
    for (const CutForces& cut : cuts) {
      double sum = 0.0;
      for (std::size_t k = 0; k < influence.size(); ++k)
        sum += influence[k] * value_of(cut, static_cast<cut_force::Index>(k));
      place.factors.push_back(factor * sum);
    }
  }
  return place;
}

double WholeLife::product(const WholePlace& a, const WholePlace& b) const {
  double sum = 0.0;
  for (const Part& part : parts_) {
    const auto K = part.centre.size();
    const Eigen::Map<const Eigen::VectorXd> x(a.factors.data() + part.first + 1, K);
    const Eigen::Map<const Eigen::VectorXd> y(b.factors.data() + part.first + 1, K);
    sum += x.dot(part.metric * y);
    // Where compression counts less the mean has a say.
    if (a.compression_reduced) {
      sum += (a.factors[part.first] + x.dot(part.centre)) *
             (b.factors[part.first] + y.dot(part.centre));
    }
  }
  return sum;
}

/// The square of the sine of the angle between them.
double WholeLife::unlikeness(const WholePlace& a, double norm_a, const Counted& b) const {
  const double cosine = product(a, b.place) / (norm_a * b.norm);
  if (a.compression_reduced && cosine < 0.0) return 1.0;
  return std::max(0.0, (1.0 - cosine) * (1.0 + cosine));
}

std::pair<const WholeLife::Counted*, double> WholeLife::parallel_to(const WholePlace& place) const {
  const double norm = std::sqrt(product(place, place));
  for (const Counted& of : counted_) {
    if (of.place.compression_reduced != place.compression_reduced) continue;
    if (unlikeness(place, norm, of) < 1e-12) return {&of, norm / of.norm};
  }
  return {nullptr, 0.0};
}

bool WholeLife::is_counted(const WholePlace& place) const {
  return parallel_to(place).first != nullptr;
}

std::vector<WholePlace> WholeLife::unlike(const std::vector<WholePlace>& places,
                                          const std::vector<double>& strengths,
                                          std::size_t most) const {
  std::vector<WholePlace> chosen;
  std::vector<double> norms, apart;
  for (std::size_t i = 0; i < places.size(); ++i) {
    norms.push_back(std::sqrt(product(places[i], places[i])));
    apart.push_back(norms[i] > 0.0 ? 1.0 : 0.0);
    for (const Counted& of : counted_) {
      if (apart[i] == 0.0 || of.place.compression_reduced != places[i].compression_reduced)
        continue;
      apart[i] = std::min(apart[i], unlikeness(places[i], norms[i], of));
    }
  }
  while (chosen.size() < most) {
    std::size_t best = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      constexpr double alike = 1e-5;
      if (apart[i] < alike) continue;
      const double value = norms[i] / strengths[i] * std::sqrt(apart[i]);
      if (value <= largest) continue;
      largest = value;
      best = i;
    }
    if (largest == 0.0) break;
    chosen.push_back(places[best]);
    const Counted of{places[best], norms[best], {}, {}, {}, {}};
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (apart[i] == 0.0 || places[i].compression_reduced != of.place.compression_reduced)
        continue;
      apart[i] = std::min(apart[i], unlikeness(places[i], norms[i], of));
    }
    apart[best] = 0.0;
  }
  return chosen;
}

const WholeLife::Life& WholeLife::life_of(const Counted& counted, const SnCurve& shape) const {
  const auto known = std::find_if(shapes_.begin(), shapes_.end(),
                                  [&](const SnCurve& other) { return same_shape(other, shape); });
  const auto index = static_cast<std::size_t>(known - shapes_.begin());
  if (known == shapes_.end()) shapes_.push_back(shape);
  const auto found = counted.lives.find(index);
  if (found != counted.lives.end()) return found->second;
  Life life;
  const std::vector<Cycle> cycles = counted.all();
  const FatigueDemand& demand = project_->fatigue.demand;
  life.factor = largest_factor(cycles, shape, demand);
  for (int i = 0; i <= 2 * Life::nodes; ++i) {
    const double times = std::exp2(0.25 * (i - Life::nodes));
    const double damage = damage_of(cycles, shape, demand, life.factor * times);
    life.logs[static_cast<std::size_t>(i)] = std::log(std::max(damage, 1e-300));
  }
  return counted.lives.emplace(index, life).first->second;
}

/// The most similar counted life, and the factor on its stress that gives the life estimated.
std::pair<const WholeLife::Life*, double> WholeLife::estimate(const WholePlace& place,
                                                              const SnCurve& shape) const {
  const double norm = std::sqrt(product(place, place));
  double sum = 0.0, weights = 0.0, nearest = std::numeric_limits<double>::infinity();
  const Life* best = nullptr;
  for (const Counted& of : counted_) {
    if (of.place.compression_reduced != place.compression_reduced) continue;
    const double apart = unlikeness(place, norm, of);
    const Life& life = life_of(of, shape);
    if (!std::isfinite(life.factor)) continue;
    const double use = 1.0 / (life.factor * of.norm);
    if (apart < nearest) {
      nearest = apart;
      best = &life;
    }
    const double weight = 1.0 / ((apart + 1e-14) * (apart + 1e-14));
    sum += weight * use;
    weights += weight;
  }
  if (best == nullptr) return {nullptr, 0.0};
  return {best, best->factor * norm * sum / weights};
}

double WholeLife::factor_of(std::span<const std::pair<WholePlace, SnCurve>> channels) const {
  struct Use {
    const Life* life;
    double times;  ///< the factor that this channel alone allows is one over it
  };
  std::vector<Use> uses;
  double largest = 0.0;
  for (const auto& [place, curve] : channels) {
    const auto [life, scale] = estimate(place, shape_of(curve));
    if (life == nullptr) continue;
    uses.push_back({life, scale / (life->factor * curve.reference.value())});
    largest = std::max(largest, uses.back().times);
  }
  if (uses.empty()) return std::numeric_limits<double>::infinity();
  if (uses.size() == 1) return 1.0 / largest;
  double low = 0.25 / largest, high = 1.0 / largest;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    double damage = 0.0;
    for (const Use& use : uses) damage += use.life->damage(middle * use.times);
    (damage <= 1.0 ? low : high) = middle;
  }
  return low;
}

std::vector<SituationCycles> WholeLife::cycles_of(const WholePlace& place,
                                                  const SnCurve& curve) const {
  std::vector<SituationCycles> cycles;
  double scale = 0.0;
  if (const auto [counted, times] = parallel_to(place); counted != nullptr) {
    cycles = counted->cycles;
    scale = times;
  } else {
    const SnCurve shape = shape_of(curve);
    const auto [life, by] = estimate(place, shape);
    for (const Counted& of : counted_) {
      if (life == nullptr || of.place.compression_reduced != place.compression_reduced) continue;
      if (&life_of(of, shape) != life) continue;
      cycles = of.few;
      std::vector<Cycle> all;
      for (const SituationCycles& in : cycles)
        all.insert(all.end(), in.cycles.begin(), in.cycles.end());
      scale = by / life->factor * largest_factor(all, shape, project_->fatigue.demand);
      break;
    }
  }
  for (SituationCycles& of : cycles) {
    for (Cycle& cycle : of.cycles) {
      cycle.range *= scale;
      cycle.mean *= scale;
    }
  }
  return cycles;
}

WholeLife* whole_life_of(const std::deque<SituationRun>& runs) {
  return runs.empty() ? nullptr : runs.front().loads.whole().get();
}

WholeLife* whole_life_of(const std::vector<SituationHistory>& histories) {
  return histories.empty() ? nullptr : histories.front().history.loads().whole().get();
}

std::vector<std::vector<CutForces>> unit_cuts_of(const std::vector<SituationHistory>& histories) {
  std::vector<std::vector<CutForces>> cuts;
  for (const SituationHistory& at : histories)
    cuts.push_back(at.history.loads().unit_cuts_at(at.history.station()));
  return cuts;
}

}  // namespace boxbeam
