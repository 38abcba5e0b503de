#include "boxbeam/verification/whole_life.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <thread>

#include "boxbeam/fatigue/rainflow.hpp"
#include "boxbeam/fatigue/reduced_range.hpp"
#include "mixed_stress.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t block = RainflowCounter::block_size;

/// Cycles of one stress in classes of a part of an octave.
class RangeClasses {
 public:
  /// `size`: of the stress; ranges far from it have no class of their own.
  explicit RangeClasses(double size)
      : first_((std::bit_cast<std::uint64_t>(size) >> dropped) - below * parts),
        classes_((below + above) * parts) {}

  void add(double range, double mean, double count) {
    const std::uint64_t key = std::bit_cast<std::uint64_t>(range) >> dropped;
    const std::uint64_t index = key > first_ ? key - first_ : 0;
    Class& of = classes_[std::min<std::uint64_t>(index, classes_.size() - 1)];
    of.count += count;
    of.range += count * range;
    of.mean += count * mean;
  }

  std::vector<Cycle> cycles() const {
    std::vector<Cycle> cycles;
    for (const Class& of : classes_) {
      if (of.count == 0.0) continue;
      cycles.push_back({si<Stress>(of.range / of.count), si<Stress>(of.mean / of.count), of.count});
    }
    return cycles;
  }

 private:
  static constexpr unsigned dropped = 44;  ///< bits of a number behind the 8 of its class
  static constexpr std::uint64_t parts = 256, below = 27, above = 13;  ///< octaves
  struct Class {
    double count = 0.0, range = 0.0, mean = 0.0;
  };
  std::uint64_t first_;
  std::vector<Class> classes_;
};

/// Counts one stress over what comes.
class PlaceCounter {
 public:
  PlaceCounter(double size, bool reduced)
      : classes_(size),
        reduced_(reduced),
        counter_({Counting::periodic}, [this](const CycleBatch& batch) { take(batch); }) {}
  PlaceCounter(const PlaceCounter&) = delete;
  PlaceCounter& operator=(const PlaceCounter&) = delete;

  void push(std::span<const double> stresses) { counter_.push(stresses); }
  void finish() { counter_.finish(); }
  std::vector<Cycle> cycles() const { return classes_.cycles(); }
  /// From the lowest to the highest stress.
  const Cycle& outermost() const { return outermost_; }

 private:
  void take(const CycleBatch& batch) {
    for (std::size_t i = 0; i < batch.range.size(); ++i) {
      const double whole = batch.range[i], mean = batch.mean[i];
      if (whole > outermost_.range.value()) outermost_ = {si<Stress>(whole), si<Stress>(mean), 1.0};
      const double range =
          reduced_ ? reduced_range(mean + 0.5 * whole, mean - 0.5 * whole, whole) : whole;
      classes_.add(range, mean, batch.count);
    }
  }

  RangeClasses classes_;
  bool reduced_;
  Cycle outermost_{Stress{}, Stress{}, 1.0};
  RainflowCounter counter_;
};

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

/// A situation that runs.
struct WholeLife::Part {
  std::size_t situation = 0;
  std::shared_ptr<const recorded::Channels> channels;  ///< those looked at one by one
  std::shared_ptr<const recorded::Record> record;
  std::size_t first = 0;  ///< of its factors
  Eigen::VectorXd centre;
  Eigen::MatrixXd metric;
};

/// The life of a counted place on a curve of reference 1 Pa.
struct WholeLife::Life {
  static constexpr int nodes = 12;           ///< on either side of the factor
  double factor = 0.0;                       ///< at which the damage is 1
  std::array<double, 2 * nodes + 1> logs{};  ///< of the damage at factors a quarter octave apart

  /// Damage at so many times the factor.
  double damage(double times) const {
    const double at = std::clamp(4.0 * std::log2(times) + nodes, 0.0, 2.0 * nodes - 1e-9);
    const auto i = static_cast<std::size_t>(at);
    return std::exp(std::lerp(logs[i], logs[i + 1], at - static_cast<double>(i)));
  }
};

struct WholeLife::Counted {
  WholePlace place;
  double norm = 0.0;
  std::vector<SituationCycles> cycles;        ///< reduced and as often as the life has them
  std::vector<SituationCycles> few;           ///< the same in some classes
  std::vector<double> largest;                ///< range of the same situations, not reduced [Pa]
  mutable std::map<std::size_t, Life> lives;  ///< by the shape of the curve

  std::vector<Cycle> all() const {
    std::vector<Cycle> all;
    for (const SituationCycles& of : cycles)
      all.insert(all.end(), of.cycles.begin(), of.cycles.end());
    return all;
  }
};

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

void WholeLife::count(const std::vector<WholePlace>& places) {
  std::vector<Counted> fresh;
  for (const WholePlace& place : places) {
    const double norm = std::sqrt(product(place, place));
    if (!(norm > 0.0) || is_counted(place)) continue;
    const bool twice = std::any_of(fresh.begin(), fresh.end(), [&](const Counted& of) {
      return of.place.compression_reduced == place.compression_reduced &&
             unlikeness(place, norm, of) < 1e-12;
    });
    if (!twice) fresh.push_back({place, norm, {}, {}, {}, {}});
  }
  // Each place by one thread alone: the same however many there are.
  const std::size_t threads = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 8);
  std::vector<std::vector<Counted*>> shares(std::min(threads, fresh.size()));
  for (std::size_t i = 0; i < fresh.size(); ++i) shares[i % shares.size()].push_back(&fresh[i]);
  {
    std::vector<std::jthread> running;
    for (std::size_t t = 1; t < shares.size(); ++t)
      running.emplace_back([&, t] { count_in_one_thread(shares[t]); });
    if (!shares.empty()) count_in_one_thread(shares.front());
  }
  summary.counted += fresh.size();
  for (Counted& of : fresh) {
    // What the outermost cycle has over the working instants.
    for (std::size_t j = 0; j < of.cycles.size(); ++j) {
      const std::size_t index = of.cycles[j].situation;
      const Situation& situation = project_->situations[index];
      double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
      for (const Part& part : parts_) {
        const bool own = part.situation == index;
        if (!own && std::find(situation.between.begin(), situation.between.end(), part.situation) ==
                        situation.between.end())
          continue;
        for (std::size_t i = 0; i < part.channels->times.size(); ++i) {
          double stress = of.place.factors[part.first];
          for (std::size_t k = 0; k < part.channels->values.size(); ++k)
            stress += of.place.factors[part.first + 1 + k] * part.channels->values[k][i];
          lowest = std::min(lowest, stress);
          highest = std::max(highest, stress);
        }
      }
      if (of.largest[j] > 0.0) {
        summary.extreme_error =
            std::max(summary.extreme_error, 1.0 - (highest - lowest) / of.largest[j]);
      }
    }
    counted_.push_back(std::move(of));
  }
}

void WholeLife::count_in_one_thread(std::span<Counted*> places) const {
  std::size_t most = 0;
  for (const Part& part : parts_) most = std::max(most, part.record->channels());
  std::vector<double> values(most * block), stresses(block);
  for (std::size_t i = 0; i < project_->situations.size(); ++i) {
    const Situation& situation = project_->situations[i];
    if (situation.cycles == 0.0) continue;
    std::vector<std::size_t> of = situation.between;
    if (of.empty()) of.push_back(i);
    // Of a change: the extremes of its first situation.
    std::vector<std::pair<double, double>> first_extremes;
    std::deque<PlaceCounter> counters;
    for (const Counted* at : places) counters.emplace_back(at->norm, at->place.compression_reduced);
    for (const std::size_t index : of) {
      const auto found = std::find_if(parts_.begin(), parts_.end(),
                                      [&](const Part& part) { return part.situation == index; });
      assert(found != parts_.end());
      const Part& part = *found;
      const auto K = static_cast<std::size_t>(part.centre.size());
      for (std::size_t from = 0; from < part.record->instants(); from += block) {
        const std::size_t count = std::min(block, part.record->instants() - from);
        for (std::size_t k = 0; k < K; ++k)
          part.record->copy(k, from, {values.data() + k * block, count});
        for (std::size_t p = 0; p < places.size(); ++p) {
          const double* const factors = places[p]->place.factors.data() + part.first;
          mix_stress({factors, K + 1}, values.data(), block, {stresses.data(), count});
          counters[p].push({stresses.data(), count});
          if (!situation.is_change() || index != of.front()) continue;
          const auto [low, high] = std::minmax_element(
              stresses.begin(), stresses.begin() + static_cast<std::ptrdiff_t>(count));
          if (p == first_extremes.size()) first_extremes.emplace_back(*low, *high);
          first_extremes[p] = {std::min(first_extremes[p].first, *low),
                               std::max(first_extremes[p].second, *high)};
        }
      }
    }
    for (std::size_t p = 0; p < places.size(); ++p) {
      counters[p].finish();
      std::vector<Cycle> cycles;
      if (situation.is_change()) {
        const auto [low, high] = first_extremes[p];
        cycles = change_cycles(situation, counters[p].outermost(), si<Stress>(0.5 * (low + high)));
        if (places[p]->place.compression_reduced) cycles = compression_reduced(std::move(cycles));
      } else {
        cycles = counters[p].cycles();
        for (Cycle& cycle : cycles) cycle.count *= situation.cycles;
      }
      // Damage is of a power between 3 and 5: classes by that of the higher.
      std::vector<Cycle> few;
      constexpr double octave = 1.0 / 16.0;
      double border = 0.0, weight = 0.0;
      for (const Cycle& cycle : cycles) {
        if (few.empty() || cycle.range.value() > border) {
          few.push_back({Stress{}, Stress{}, 0.0});
          border = cycle.range.value() * std::exp2(octave);
          weight = 0.0;
        }
        Cycle& in = few.back();
        weight += cycle.count * std::pow(cycle.range.value(), 5.0);
        in.mean = (in.mean * in.count + cycle.mean * cycle.count) / (in.count + cycle.count);
        in.count += cycle.count;
        in.range = si<Stress>(std::pow(weight / in.count, 0.2));
      }
      places[p]->largest.push_back(counters[p].outermost().range.value());
      places[p]->few.push_back({i, std::move(few)});
      places[p]->cycles.push_back({i, std::move(cycles)});
    }
  }
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
