#include "boxbeam/fatigue/damage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "boxbeam/fatigue/reduced_range.hpp"

namespace boxbeam {

namespace {

Stress largest_range_of(std::span<const Cycle> cycles) {
  Stress largest;
  for (const Cycle& cycle : cycles) largest = std::max(largest, cycle.range);
  return largest;
}

/// A channel prepared for many evaluations.
struct Prepared {
  std::span<const Cycle> cycles;
  const SnLine* line = nullptr;
  double largest = 0.0;  ///< range [Pa]

  double damage(const FatigueDemand& demand, double factor) const {
    const double scale = demand.gamma_Ff * demand.gamma_Mf * factor;
    const Loading loading = scale * largest > line->limit() ? Loading::spectrum : demand.loading;
    double damage = 0.0;
    for (const Cycle& cycle : cycles) {
      damage += cycle.count / line->cycles_to_failure(scale * cycle.range.value(), loading);
    }
    return damage;
  }
};

Prepared prepare(std::span<const Cycle> cycles, const SnLine& line) {
  return {cycles, &line, largest_range_of(cycles).value()};
}

double count_of(std::span<const Cycle> cycles) {
  double count = 0.0;
  for (const Cycle& cycle : cycles) count += cycle.count;
  return count;
}

/// A factor and the damage it does.
struct Tried {
  double factor = 0.0, damage = 0.0;
};

/// Factors at which the damage is below and above 1 by more than its sum is rounded: as it grows
/// with the factor, it is so below the one and above the other as well.
class Bracket {
 public:
  Bracket(const Tried& low, const Tried& high)
      : lives(low.factor),
        fails(high.factor),
        damage_below_(low.damage),
        damage_above_(high.damage) {}

  double lives, fails;

  void take(double factor, double damage) {
    constexpr double clear = 1e-12;
    if (damage <= 1.0 - clear && factor > lives) {
      lives = factor;
      damage_below_ = damage;
    }
    if (damage >= 1.0 + clear && factor < fails) {
      fails = factor;
      damage_above_ = damage;
    }
  }
  /// Just below a factor and just above.
  template <class Damage>
  void take_beside(double factor, const Damage& damage) {
    for (const double at : {factor * (1.0 - aside), factor * (1.0 + aside)}) take(at, damage(at));
  }
  bool holds(double factor) const { return factor > lives * (1.0 - aside) && factor < fails; }
  bool is_close() const { return fails < lives * (1.0 + 4.0 * aside); }

  /// Narrower around where the chord of a close bracket has the damage 1, if it is 1 there: it
  /// grows at least as the factor does, so that what lies farther aside is clear of 1.
  template <class Damage>
  void narrow(const Damage& damage) {
    constexpr double clear = 2e-14;
    const double part = (1.0 - damage_below_) / (damage_above_ - damage_below_);
    const double crossing = lives + part * (fails - lives);
    if (!(std::abs(damage(crossing) - 1.0) <= clear)) return;
    lives = std::max(lives, crossing * (1.0 - clear));
    fails = std::min(fails, crossing * (1.0 + clear));
  }

 private:
  static constexpr double aside = 4e-12;
  double damage_below_, damage_above_;
};

/// Where a range passes the limit or the cut-off of its curve the damage may jump past 1.
template <class Damage>
void look_at_jumps(std::span<const Prepared> channels, double gamma, const Damage& damage,
                   Bracket& bracket) {
  constexpr std::size_t most = 8;
  std::size_t cycles = 0;
  for (const Prepared& channel : channels) cycles += channel.cycles.size();
  if (cycles > most) return;
  for (const Prepared& channel : channels) {
    for (const Cycle& cycle : channel.cycles) {
      for (const double strength : {channel.line->cut_off(), channel.line->limit()}) {
        const double at = strength / (gamma * cycle.range.value());
        if (!(at > bracket.lives && at < bracket.fails)) continue;
        bracket.take_beside(at, damage);
      }
    }
  }
}

/// As close as secants come in logarithmic axes, in which a branch of a curve is a straight line:
/// mostly at once.
template <class Damage>
void look_between(const Damage& damage, const Tried& low, const Tried& high, Bracket& bracket) {
  constexpr int most = 12;
  constexpr double near = 1e-5;
  Tried at = low, before = high;
  for (int i = 0; i < most && !bracket.is_close(); ++i) {
    const double exponent =
        std::log(at.damage / before.damage) / std::log(at.factor / before.factor);
    double next = at.factor * std::pow(at.damage, -1.0 / exponent);
    if (!bracket.holds(next))
      next = std::sqrt(bracket.lives * bracket.fails);
    else if (std::abs(next - at.factor) < near * at.factor)
      return bracket.take_beside(next, damage);
    before = at;
    at = {next, damage(next)};
    bracket.take(at.factor, at.damage);
  }
}

double largest_factor_of(std::span<const Prepared> channels, const FatigueDemand& demand) {
  // As many cycles of the largest range as there are cycles at all bound the factor of a channel
  // below; a share of the damage for each channel bounds that of all.
  double low = std::numeric_limits<double>::infinity();
  const auto share = static_cast<double>(channels.size());
  for (const Prepared& channel : channels) {
    const double strength =
        channel.line->strength_at(share * count_of(channel.cycles), demand.loading);
    low = std::min(low, strength / (demand.gamma_Ff * demand.gamma_Mf * channel.largest));
  }
  if (channels.size() == 1 && channels.front().cycles.size() == 1) return low;

  const auto damage = [&](double factor) {
    double sum = 0.0;
    for (const Prepared& channel : channels) sum += channel.damage(demand, factor);
    return sum;
  };
  // Damage grows with the factor, and jumps where a range passes the cut-off: bisect for the last
  // factor with damage <= 1.
  Tried below{low, damage(low)}, above{2.0 * low, damage(2.0 * low)};
  while (above.damage <= 1.0) {
    below = above;
    above.factor *= 2.0;
    above.damage = damage(above.factor);
  }
  Bracket known(below, above);
  look_at_jumps(channels, demand.gamma_Ff * demand.gamma_Mf, damage, known);
  if (!known.is_close()) look_between(damage, below, above, known);
  if (known.is_close()) known.narrow(damage);
  low = below.factor;
  double high = above.factor;
  while (high - low > 1e-15 * high) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    const bool lives = middle <= known.lives || (middle < known.fails && damage(middle) <= 1.0);
    (lives ? low : high) = middle;
  }
  return low;
}

}  // namespace

std::vector<double> cycles_to_failure_in(const FatigueLoad& load, const FatigueDemand& demand,
                                         double factor) {
  const double scale = demand.gamma_Ff * demand.gamma_Mf * factor;
  const SnLine& line = *load.line;
  const bool limit_exceeded = scale * largest_range_of(load.cycles).value() > line.limit();
  const Loading loading = limit_exceeded ? Loading::spectrum : demand.loading;
  std::vector<double> endured;
  endured.reserve(load.cycles.size());
  for (const Cycle& cycle : load.cycles)
    endured.push_back(line.cycles_to_failure(scale * cycle.range.value(), loading));
  return endured;
}

double damage_of(const FatigueLoad& load, const FatigueDemand& demand, double factor) {
  return prepare(load.cycles, *load.line).damage(demand, factor);
}

double damage_of(const std::vector<Cycle>& cycles, const SnCurve& curve,
                 const FatigueDemand& demand, double factor) {
  return prepare(cycles, SnLine(curve)).damage(demand, factor);
}

double largest_factor(std::span<const FatigueLoad> channels, const FatigueDemand& demand) {
  // Direct stress and shear are no more than two.
  std::array<Prepared, 2> few;
  std::vector<Prepared> many(channels.size() > few.size() ? channels.size() : 0);
  const std::span<Prepared> room = many.empty() ? std::span(few) : std::span(many);
  std::size_t count = 0;
  for (const FatigueLoad& channel : channels) {
    const Prepared ready = prepare(channel.cycles, *channel.line);
    if (ready.largest > 0.0) room[count++] = ready;
  }
  if (count == 0) return std::numeric_limits<double>::infinity();
  return largest_factor_of(room.first(count), demand);
}

double largest_factor(std::span<const FatigueChannel> channels, const FatigueDemand& demand) {
  std::vector<SnLine> lines;
  lines.reserve(channels.size());
  std::vector<FatigueLoad> loads;
  for (const FatigueChannel& channel : channels)
    loads.push_back({channel.cycles, &lines.emplace_back(channel.curve)});
  return largest_factor(loads, demand);
}

double largest_factor(const std::vector<Cycle>& cycles, const SnCurve& curve,
                      const FatigueDemand& demand) {
  const SnLine line(curve);
  const FatigueLoad load{cycles, &line};
  return largest_factor({&load, 1}, demand);
}

Stress equivalent_range(double damage, const SnCurve& curve, const FatigueDemand& demand,
                        double cycles) {
  const double m = curve.branches.front().slope;
  return si<Stress>(sn::equivalent_from(curve.reference.value(),
                                        damage * curve.reference_cycles / cycles, m,
                                        demand.gamma_Ff * demand.gamma_Mf));
}

std::vector<Cycle> compression_reduced(std::vector<Cycle> cycles) {
  for (Cycle& cycle : cycles) {
    const double highest = (cycle.mean + 0.5 * cycle.range).value();
    const double lowest = (cycle.mean - 0.5 * cycle.range).value();
    cycle.range = si<Stress>(reduced_range(highest, lowest, highest - lowest));
  }
  return cycles;
}

}  // namespace boxbeam
