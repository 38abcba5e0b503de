#include "working_instants.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <thread>
#include <vector>

#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/slender_path.hpp"
#include "boxbeam/verification/stress_points.hpp"
#include "boxbeam/verification/worst_place.hpp"
#include "mixed_stress.hpp"
#include "pressing_sums.hpp"

namespace boxbeam {
namespace {

/// Sums of channels whose extremes are looked for.
class Sums {
 public:
  explicit Sums(const recorded::OuterInstants& outer) : outer_(&outer) {}

  void add(const Eigen::VectorXd& sum) {
    const double norm = std::sqrt(sum.dot(outer_->metric * sum));
    if (!(norm > 0.0)) return;
    const Eigen::VectorXd along = sum / norm;
    // What differs by less has its extremes at the same instants.
    constexpr double alike = 1e-7;
    const Eigen::VectorXd weighted = outer_->metric * along;
    for (const Eigen::VectorXd& other : sums) {
      const double cosine = other.dot(weighted);
      if (1.0 - std::abs(cosine) < alike) return;
    }
    sums.push_back(along);
  }

  std::vector<Eigen::VectorXd> sums;

 private:
  const recorded::OuterInstants* outer_;
};

/// The cut forces of a station for a value of one of each channel, a row for each cut force.
Eigen::MatrixXd rows_at(const std::vector<CutForceDiagram>& units, const Station& station) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(cut_force::count),
                       static_cast<Eigen::Index>(units.size()));
  for (std::size_t k = 0; k < units.size(); ++k) {
    const CutForces cut = units[k].at(station);
    for (std::size_t c = 0; c < cut_force::count; ++c) {
      rows(static_cast<Eigen::Index>(c), static_cast<Eigen::Index>(k)) =
          value_of(cut, static_cast<cut_force::Index>(c));
    }
  }
  return rows;
}

void add_stresses(const StressInfluence& influence, const Eigen::MatrixXd& rows, Sums& sums) {
  const Eigen::Map<const Eigen::VectorXd> normal(influence.normal.data(), rows.rows());
  const Eigen::Map<const Eigen::VectorXd> shear(influence.shear.data(), rows.rows());
  const Eigen::VectorXd direct = rows.transpose() * normal, along = rows.transpose() * shear;
  // sqrt(a^2 + b^2) is the largest a cos + b sin of all angles.
  constexpr int angles = 8;
  for (int k = 0; k < angles; ++k) {
    const double angle = std::numbers::pi * k / angles;
    sums.add(std::cos(angle) * direct + std::numbers::sqrt3 * std::sin(angle) * along);
  }
}

void add_points(const Project& project, const Station& station, const Eigen::MatrixXd& rows,
                Sums& sums) {
  for (const StressPoint& point : stress_points_at(project, {}, station)) {
    if (point.stretch) {
      if (!project.in_space) continue;
      for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0})
        add_stresses(moved_along(point, part).influence, rows, sums);
      continue;
    }
    add_stresses(point.influence, rows, sums);
    constexpr std::size_t step = 10;
    for (std::size_t i = 0; i < point.edges.size(); i += step)
      add_stresses(point.edges[i].influence, rows, sums);
  }
}

CutForces only(cut_force::Index of, double value) {
  CutForces cut{};
  switch (of) {
    case cut_force::N: cut.N = si<Force>(value); break;
    case cut_force::V_y: cut.V_y = si<Force>(value); break;
    case cut_force::V_z: cut.V_z = si<Force>(value); break;
    case cut_force::T: cut.T = si<Moment>(value); break;
    case cut_force::M_y: cut.M_y = si<Moment>(value); break;
    case cut_force::M_z: cut.M_z = si<Moment>(value); break;
  }
  return cut;
}

/// What plates that buckle are used by where that is a sum: for each sense of N, M_y and M_z the
/// use by one alone times its size, which of a corner where all meet is its use, by itself and with
/// what V_y, V_z and T use of the plate that they use most. A plate that works less the more it is
/// compressed weighs N unlike the gross section.
void add_plates(const Project& project, const Station& station, const Eigen::MatrixXd& rows,
                Sums& sums) {
  using enum cut_force::Index;
  const auto box = slender_plates_at(project, {}, station);
  const auto path = box ? nullptr : slender_path_at(project, {}, station);
  if (!box && !path) return;
  const auto normal = [&](cut_force::Index of, double sense) {
    const CutForces cut = only(of, sense);
    return sense * (box ? box->box.worst_corner(cut).use : path->section.use(cut));
  };
  const auto sheared = [&](cut_force::Index of) {
    double most = 0.0;
    const auto look = [&](const auto& walls) {
      for (const ShearedWall& wall : walls) {
        const double use = wall.force_of(only(of, 1.0)) / wall.resists.resistance;
        most = std::max(most, use);
      }
    };
    if (box)
      look(box->sheared);
    else
      look(path->sheared);
    return most;
  };
  const std::array<double, 2> senses{-1.0, 1.0};
  const std::array shears{V_y, V_z, T};
  for (const double of_N : senses) {
    for (const double of_M_y : senses) {
      for (const double of_M_z : senses) {
        const Eigen::VectorXd sum = normal(N, of_N) * rows.row(N).transpose() +
                                    normal(M_y, of_M_y) * rows.row(M_y).transpose() +
                                    normal(M_z, of_M_z) * rows.row(M_z).transpose();
        sums.add(sum);
        for (const cut_force::Index shear : shears) {
          const Eigen::VectorXd more = sheared(shear) * rows.row(shear).transpose();
          sums.add(sum + more);
          sums.add(sum - more);
        }
      }
    }
  }
}

constexpr std::size_t at_once = 4096;

/// Where a sum is lowest and highest.
struct Extremes {
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  std::size_t low = 0, high = 0;

  /// Values from an instant on.
  void look_at(std::span<const double> values, std::size_t from) {
    const Ends ends = ends_of(values);
    const auto place_of = [&](double value) {
      return from + static_cast<std::size_t>(std::find(values.begin(), values.end(), value) -
                                             values.begin());
    };
    if (ends.lowest < lowest) {
      lowest = ends.lowest;
      low = place_of(lowest);
    }
    if (ends.highest > highest) {
      highest = ends.highest;
      high = place_of(highest);
    }
  }
};

/// Goes once through all instants, block by block, so that a block is near while all sums of it are
/// formed. `copy` gives values of a channel from an instant on.
template <class Copy>
void look_through(std::size_t instants, const Copy& copy, std::span<const Eigen::VectorXd> sums,
                  const Eigen::VectorXd& centre, std::span<Extremes> extremes) {
  const auto K = static_cast<std::size_t>(centre.size());
  std::vector<std::vector<double>> factors;
  for (const Eigen::VectorXd& sum : sums) {
    factors.push_back({-sum.dot(centre)});
    factors.back().insert(factors.back().end(), sum.begin(), sum.end());
  }
  std::vector<double> values(K * at_once), mixed(at_once);
  for (std::size_t from = 0; from < instants; from += at_once) {
    const std::size_t count = std::min(at_once, instants - from);
    for (std::size_t k = 0; k < K; ++k)
      copy(k, from, std::span<double>(values.data() + k * at_once, count));
    for (std::size_t j = 0; j < sums.size(); ++j) {
      mix_stress(factors[j], values.data(), at_once, {mixed.data(), count});
      extremes[j].look_at({mixed.data(), count}, from);
    }
  }
}

/// The instants of all at which sums are lowest and highest: among the outer ones where these prove
/// it, else among all.
std::vector<std::size_t> extreme_instants_of(const recorded::Record& record,
                                             const recorded::OuterInstants& outer,
                                             const std::vector<Eigen::VectorXd>& sums) {
  std::vector<Extremes> among(sums.size());
  const auto from_outer = [&](std::size_t k, std::size_t from, std::span<double> to) {
    std::copy_n(outer.values[k].begin() + static_cast<std::ptrdiff_t>(from), to.size(), to.begin());
  };
  look_through(outer.instants.size(), from_outer, sums, Eigen::VectorXd::Zero(outer.centre.size()),
               among);
  std::vector<std::size_t> instants;
  std::vector<Eigen::VectorXd> open;
  for (std::size_t j = 0; j < sums.size(); ++j) {
    if (outer.proves(sums[j], among[j].highest) && outer.proves(sums[j], -among[j].lowest)) {
      instants.push_back(outer.instants[among[j].low]);
      instants.push_back(outer.instants[among[j].high]);
    } else {
      open.push_back(sums[j]);
    }
  }
  // Each sum by one thread alone: the same however many there are.
  std::vector<Extremes> of_all(open.size());
  const std::size_t threads = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 8);
  const std::size_t share = (open.size() + threads - 1) / threads;
  {
    std::vector<std::jthread> running;
    for (std::size_t from = 0; from < open.size(); from += share) {
      const std::size_t count = std::min(share, open.size() - from);
      running.emplace_back([&, from, count] {
        const auto from_record = [&](std::size_t k, std::size_t at, std::span<double> to) {
          record.copy(k, at, to);
        };
        look_through(record.instants(), from_record, std::span(open).subspan(from, count),
                     outer.centre, std::span(of_all).subspan(from, count));
      });
    }
  }
  for (const Extremes& of : of_all) {
    instants.push_back(of.low);
    instants.push_back(of.high);
  }
  return instants;
}

/// The instants at which sums are lowest and highest while what is against them is so.
std::vector<std::size_t> opposed_instants_of(const recorded::Record& record,
                                             const std::vector<PressingSum>& sums) {
  const std::size_t K = record.channels(), n = record.instants();
  std::vector<Extremes> all(sums.size());
  const auto factors_of = [](const Eigen::VectorXd& sum, double constant) {
    std::vector<double> factors{constant};
    factors.insert(factors.end(), sum.begin(), sum.end());
    return factors;
  };
  const auto look = [&](std::size_t from, std::size_t to) {
    std::vector<double> values(K * at_once), mixed(at_once), against(at_once);
    for (std::size_t at = 0; at < n; at += at_once) {
      const std::size_t count = std::min(at_once, n - at);
      for (std::size_t k = 0; k < K; ++k)
        record.copy(k, at, std::span<double>(values.data() + k * at_once, count));
      for (std::size_t j = from; j < to; ++j) {
        mix_stress(factors_of(sums[j].of, 0.0), values.data(), at_once, {mixed.data(), count});
        mix_stress(factors_of(*sums[j].against, sums[j].constant), values.data(), at_once,
                   {against.data(), count});
        for (std::size_t i = 0; i < count; ++i)
          if (!(mixed[i] * against[i] < 0.0) || std::abs(against[i]) <= sums[j].least)
            mixed[i] = 0.0;
        all[j].look_at({mixed.data(), count}, at);
      }
    }
  };
  // Each sum by one thread alone: the same however many there are.
  const std::size_t threads = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, 8);
  const std::size_t share = (sums.size() + threads - 1) / threads;
  {
    std::vector<std::jthread> running;
    for (std::size_t from = 0; from < sums.size(); from += share)
      running.emplace_back(look, from, std::min(sums.size(), from + share));
  }
  std::vector<std::size_t> instants;
  for (const Extremes& of : all) {
    instants.push_back(of.low);
    instants.push_back(of.high);
  }
  return instants;
}

}  // namespace

std::shared_ptr<const recorded::Channels> working_instants(const Project& project,
                                                           const recorded::ChannelLoads& loads) {
  const recorded::Channels& channels = *loads.channels;
  const recorded::OuterInstants& outer = *channels.outer;
  std::vector<CutForceDiagram> units;
  for (const BeamLoads& unit : loads.units) units.push_back(cut_forces_of(unit));
  const auto K = static_cast<Eigen::Index>(units.size());
  Sums sums(outer);
  for (Eigen::Index k = 0; k < K; ++k) sums.add(Eigen::VectorXd::Unit(K, k));
  std::vector<Eigen::VectorXd> bending(6, Eigen::VectorXd::Zero(K));
  const double length = project.beam.length().value();
  for (const CutForcePiece& piece : units.front().pieces) {
    const Length middle = 0.5 * (piece.start + piece.end());
    for (const Station& station : {Station{piece.start, Side::behind}, Station{middle, Side::both},
                                   Station{piece.end(), Side::before}}) {
      const Eigen::MatrixXd rows = rows_at(units, station);
      for (Eigen::Index c = 0; c < rows.rows(); ++c) sums.add(rows.row(c).transpose());
      add_points(project, station, rows, sums);
      add_plates(project, station, rows, sums);
      const double share = (piece.end() - piece.start).value() / length;
      for (std::size_t power = 0; power < 3; ++power) {
        const double weight =
            share * std::pow(station.s.value() / length, static_cast<double>(power));
        bending[power] += weight * rows.row(cut_force::M_y).transpose();
        bending[3 + power] += weight * rows.row(cut_force::M_z).transpose();
      }
    }
  }
  for (const Eigen::VectorXd& sum : bending) sums.add(sum);
  for (std::size_t p = 0; p < loads.constant.points.size(); ++p) {
    Eigen::MatrixXd rows(6, K);
    for (Eigen::Index k = 0; k < K; ++k) {
      const PointLoad& load = loads.units[static_cast<std::size_t>(k)].points[p];
      rows.col(k) << load.force, load.moment;
    }
    for (Eigen::Index c = 0; c < 6; ++c) sums.add(rows.row(c).transpose());
  }
  std::vector<PressingSum> opposed;
  for (PressingSum& sum : pressing_sums_of(project, loads, units)) {
    if (sum.against)
      opposed.push_back(std::move(sum));
    else
      sums.add(sum.of);
  }

  std::vector<std::size_t> instants = extreme_instants_of(*channels.record, outer, sums.sums);
  for (const std::size_t instant : opposed_instants_of(*channels.record, opposed))
    instants.push_back(instant);
  // Those that the channels have already, by their times.
  const recorded::Record& record = *channels.record;
  for (const double time : channels.times) {
    std::size_t low = 0, high = record.instants();
    while (high - low > 1) {
      const std::size_t half = (low + high) / 2;
      (record.time_of(half) <= time ? low : high) = half;
    }
    instants.push_back(low);
  }
  recorded::Channels working = recorded::at_instants(channels.record, std::move(instants));
  working.outer = channels.outer;
  return std::make_shared<const recorded::Channels>(std::move(working));
}

}  // namespace boxbeam
