#include "boxbeam/mechanism/planar/instant_solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>
#include <cmath>
#include <map>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/planar/assembly.hpp"
#include "boxbeam/mechanism/planar/branch.hpp"
#include "boxbeam/mechanism/planar/degrees_of_freedom.hpp"
#include "boxbeam/mechanism/planar/reach.hpp"
#include "solver_limits.hpp"

namespace boxbeam::planar {

using namespace limits;

namespace {

/// A fixed sequence of keys without pattern. Source: Steele, Lea, Flood, Fast Splittable
/// Pseudorandom Number Generators (2014).
std::uint64_t key_of(std::uint64_t number) {
  std::uint64_t z = (number + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

/// Whether a permutation is odd. `order[i]` are distinct numbers.
bool is_odd(const std::vector<int>& order) {
  std::vector<int> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  std::map<int, std::size_t> rank;
  for (std::size_t i = 0; i < sorted.size(); ++i) rank[sorted[i]] = i;
  std::vector<char> seen(order.size(), 0);
  bool odd = false;
  for (std::size_t i = 0; i < order.size(); ++i) {
    for (std::size_t k = i; seen[k] == 0; k = rank[order[k]]) {
      seen[k] = 1;
      if (rank[order[k]] != i) odd = !odd;
    }
  }
  return odd;
}

}  // namespace

InstantSolver::InstantSolver(const Mechanism& mechanism, Elimination elimination)
    : mechanism_(&mechanism),
      kind_(elimination),
      equations_(mechanism),
      contacts_(friction_contacts_of(mechanism)),
      mass_(mechanism.coordinates()),
      weight_(mechanism.coordinates()),
      inverse_scale_(equations_.col_scale().cwiseInverse()),
      phi_(mechanism.equations()),
      right_(mechanism.equations()),
      step_(mechanism.coordinates()) {
  if (mechanism.equations() < mechanism.coordinates()) {
    throw AnalysisError(
        {fmt::format("the motion is not determined: {} equations of joints and "
                     "drivers for {} coordinates of {} bodies",
                     mechanism.equations(), mechanism.coordinates(), mechanism.bodies.size()),
         "mechanism"});
  }
  Eigen::Index i = 0;
  for (const Body& body : mechanism.bodies) {
    mass_.segment<3>(i) << body.mass, body.mass, body.inertia;
    weight_.segment<3>(i) << body.mass * mechanism.gravity, 0.0;
    i += 3;
  }
  change_points_.reserve(16);
  if (mechanism.equations() > mechanism.coordinates()) {
    redundant_.emplace(equations_.pattern(), equations_.row_scale(), equations_.col_scale());
  }
}

// ---- linear systems -------------------------------------------------------------------------

void InstantSolver::order_anew() {
  const Eigen::Index rank = sparse_.analyse(equations_.pattern(), jacobian_, equations_.row_scale(),
                                            equations_.col_scale());
  if (ordered_) ++reorderings_;
  ordered_ = rank == mechanism_->coordinates();
  if (!ordered_) return;
  // Irreducible blocks: pivots that depend on each other in a circle.
  const std::size_t n = sparse_.pivots();
  std::vector<std::size_t> pivot_of_col(n);
  for (std::size_t k = 0; k < n; ++k) {
    pivot_of_col[static_cast<std::size_t>(sparse_.pivot_col(k))] = k;
  }
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS>;
  Graph graph(n);
  const SparsePattern& pattern = equations_.pattern();
  for (std::size_t k = 0; k < n; ++k) {
    const auto row = static_cast<std::size_t>(sparse_.pivot_row(k));
    for (int e = pattern.row_start[row]; e < pattern.row_start[row + 1]; ++e) {
      const int col = pattern.col[static_cast<std::size_t>(e)];
      boost::add_edge(k, pivot_of_col[static_cast<std::size_t>(col)], graph);
    }
  }
  std::vector<int> block(n);
  const auto blocks = static_cast<std::size_t>(boost::strong_components(
      graph,
      boost::make_iterator_property_map(block.begin(), boost::get(boost::vertex_index, graph))));
  // Each block has a key of its own, and a sign from the order of its rows against its columns.
  std::vector<int> first_col(blocks, static_cast<int>(n));
  std::vector<std::vector<std::pair<int, int>>> members(blocks);
  for (std::size_t k = 0; k < n; ++k) {
    const auto b = static_cast<std::size_t>(block[k]);
    first_col[b] = std::min(first_col[b], sparse_.pivot_col(k));
    members[b].emplace_back(sparse_.pivot_row(k), sparse_.pivot_col(k));
  }
  block_key_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const int first = first_col[static_cast<std::size_t>(block[k])];
    block_key_[k] = key_of(static_cast<std::uint64_t>(first));
  }
  parity_key_ = 1;  // so that no assembly is "not known"
  for (std::size_t b = 0; b < blocks; ++b) {
    std::sort(members[b].begin(), members[b].end());
    std::vector<int> cols;
    for (const auto& [row, col] : members[b]) cols.push_back(col);
    if (is_odd(cols)) parity_key_ ^= key_of(static_cast<std::uint64_t>(first_col[b]));
  }
}

bool InstantSolver::factor_at_position() {
  if (redundant_) {
    return redundant_->factor(jacobian_) && redundant_->smallest_singular_value() > lost_in_squares;
  }
  if (kind_ == Elimination::dense) {
    dense_matrix_ = equations_.pattern().dense(jacobian_);
    dense_.compute(dense_matrix_);
    return dense_.matrixLU().diagonal().cwiseAbs().minCoeff() > no_digit_left;
  }
  if (!ordered_) order_anew();
  if (!ordered_) return false;
  bool fits = sparse_.factor(jacobian_);
  if (!fits) {
    order_anew();
    fits = ordered_ && sparse_.factor(jacobian_);
  }
  return fits && ordered_ && sparse_.smallest_pivot() > no_digit_left;
}

void InstantSolver::solve(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  if (redundant_) {
    redundant_->solve(b, x);
  } else if (kind_ == Elimination::sparse) {
    sparse_.solve(b, x);
  } else {
    x = dense_.solve(b);
  }
}

void InstantSolver::solve_transposed(const Eigen::VectorXd& b, Eigen::VectorXd& y) {
  if (redundant_) {
    redundant_->solve_transposed(b, y);
  } else if (kind_ == Elimination::sparse) {
    sparse_.solve_transposed(b, y);
  } else {
    y = dense_.transpose().solve(b);
  }
}

double InstantSolver::smallest_pivot() const {
  if (kind_ == Elimination::dense) return 1.0;
  return redundant_ ? redundant_->smallest_singular_value() : sparse_.smallest_pivot();
}

std::uint64_t InstantSolver::assembly_of_factors() const {
  if (redundant_ || kind_ == Elimination::dense) return 0;
  std::uint64_t assembly = parity_key_;
  for (std::size_t k = 0; k < block_key_.size(); ++k) {
    assembly ^= sparse_.pivot(k) < 0.0 ? block_key_[k] : 0U;
  }
  return assembly;
}

// ---- one instant ----------------------------------------------------------------------------

bool InstantSolver::correct(Eigen::VectorXd& q) {
  constexpr int most = 12;
  constexpr double too_far = 0.3;
  double last = 0.0;
  bool renew = true;
  equations_.set_position(q);
  for (int iteration = 0; iteration < most; ++iteration) {
    if (iteration > 0) equations_.move_position(q);
    if (renew) {
      equations_.evaluate(phi_, jacobian_);
      if (!factor_at_position()) return false;
    } else {
      equations_.evaluate(phi_);
    }
    solve(phi_, step_);
    double step = 0.0;
    double size = 1.0;
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      step = std::max(step, std::abs(step_[i]) * inverse_scale_[i]);
      size = std::max(size, std::abs(q[i]) * inverse_scale_[i]);
    }
    if (!(step < too_far)) return false;
    q -= step_;
    // Near a dead point a step is never smaller than round-off over the smallest pivot.
    const double enough = round_off * size * std::max(1.0, 0.01 / smallest_pivot());
    if (step <= enough) break;
    if (iteration > 0) {
      const double rate = step / last;
      if (rate > 0.25 && step > 1e2 * enough) return false;  // this is no neighbour
      // Converging as fast as measured, the next step is round-off; or this one was.
      if (step * rate <= enough || (rate > 0.25 && step <= 1e2 * enough)) break;
      renew = rate > 1e-3;
    } else {
      renew = step > 1e-3;
    }
    last = step;
  }
  equations_.move_position(q);
  return true;
}

void InstantSolver::solve_multipliers(State& state) {
  step_ = weight_;
  if (!mechanism_->forces.empty()) {
    add_applied_forces(*mechanism_, state.time, state.q, state.v, step_);
  }
  step_ -= mass_.cwiseProduct(state.a);
  solve_transposed(step_, state.lambda);
  if (contacts_.empty()) return;
  const auto count = static_cast<Eigen::Index>(contacts_.size());
  Eigen::MatrixXd response(mechanism_->equations(), count);
  Eigen::VectorXd column(mechanism_->equations());
  for (Eigen::Index j = 0; j < count; ++j) {
    const FrictionContact& contact = contacts_[static_cast<std::size_t>(j)];
    unit_friction(contact, state.q, step_);
    solve_transposed(step_, column);
    response.col(j) = column;
  }
  state.friction =
      solve_friction(*mechanism_, contacts_, state.time, {},
                     friction_response_of(contacts_, state.q, state.v, state.lambda, response));
  state.lambda += response * state.friction;
}

bool InstantSolver::complete(State& state) {
  equations_.evaluate(phi_, jacobian_);
  state.residual = phi_.cwiseProduct(equations_.row_scale()).lpNorm<Eigen::Infinity>();
  state.v.resize(mechanism_->coordinates());
  state.a.resize(mechanism_->coordinates());
  state.lambda.resize(mechanism_->equations());
  // Joints that repeat each other here and now may contradict each other elsewhere.
  if (redundant_ && state.residual > still_closed) return false;
  if (!factor_at_position()) return false;
  equations_.velocity_right_side(right_);
  solve(right_, state.v);
  if (redundant_ && contradicts(state.v)) return false;
  equations_.acceleration_right_side(state.v, right_);
  solve(right_, state.a);
  solve_multipliers(state);
  state.assembly = assembly_of_factors();
  state.pivot = smallest_pivot();
  return true;
}

bool InstantSolver::contradicts(const Eigen::VectorXd& v) const {
  // Equations that agree in a position may ask for different velocities.
  const SparsePattern& pattern = equations_.pattern();
  double largest = 0.0;
  double open = 0.0;
  for (Eigen::Index r = 0; r < pattern.rows; ++r) {
    double sum = -right_[r];
    double size = std::abs(right_[r]);
    pattern.in_row(r, [&](std::size_t entry, int column) {
      const double part = jacobian_[entry] * v[column];
      sum += part;
      size += std::abs(part);
    });
    open = std::max(open, std::abs(sum) * equations_.row_scale()[r]);
    largest = std::max(largest, size * equations_.row_scale()[r]);
  }
  return open > 1e-7 * largest;
}

State InstantSolver::solve_at(double time, const Eigen::VectorXd& q) {
  State state;
  state.time = time;
  state.q = q;
  equations_.set_time(time);
  equations_.set_position(q);
  if (!complete(state)) {
    throw AnalysisError(
        {"velocities, accelerations and reactions are not determined: the Jacobian is singular (a "
         "dead point, or fewer independent joints and drivers than the motion needs), or joints "
         "and drivers that repeat each other ask for different motions",
         "mechanism", time, state.residual});
  }
  return state;
}

Eigen::VectorXd InstantSolver::assemble(double time, const Eigen::VectorXd& start) {
  Assembly assembly = Assembler(*mechanism_).assemble(time, start);
  if (!assembly.closed) throw AnalysisError(failure_of_assembly(*mechanism_, time, assembly));
  // Least squares leave the root of round-off near a dead point: Newton's steps do not.
  Eigen::VectorXd polished = assembly.q;
  equations_.set_time(time);
  at_dead_point_ = !correct(polished);
  return at_dead_point_ ? assembly.q : polished;
}

State InstantSolver::solve_from_sketch(double time, const Eigen::VectorXd& sketch) {
  Eigen::VectorXd q = assemble(time, sketch);
  if (!on_branch(*mechanism_, q)) {
    Assembler assembler(*mechanism_);
    const std::string off = loops_off_branch(*mechanism_, q);
    bool found = false;
    bool dead = false;
    for (int attempt = 1; attempt <= other_starts && (!found || dead); ++attempt) {
      const Assembly other = assembler.assemble(time, other_start(*mechanism_, sketch, attempt));
      if (!other.closed || !on_branch(*mechanism_, other.q)) continue;
      const Eigen::VectorXd candidate = assemble(time, other.q);
      // One with a loop stretched or folded may be nobody's wish: only where there is no other.
      if (found && at_dead_point_) continue;
      q = candidate;
      found = true;
      dead = at_dead_point_;
    }
    at_dead_point_ = dead;
    if (!found) {
      throw AnalysisError({fmt::format("no assembly found on the wanted branch, from the sketch "
                                       "and {} other starts; change the sign asked for, or the "
                                       "sketch",
                                       other_starts),
                           off, time});
    }
  }
  // Where a coupling or a driver counts turns, an angle must stay as it is.
  const Eigen::VectorXd shown = unwound(q, sketch);
  equations_.set_time(time);
  equations_.set_position(shown);
  equations_.evaluate(phi_);
  const bool same = phi_.cwiseProduct(equations_.row_scale()).lpNorm<Eigen::Infinity>() < 1e-11;
  State state;
  state.time = time;
  state.q = same ? shown : q;
  equations_.set_position(state.q);
  const bool regular = !at_dead_point_ && complete(state);
  if (regular && state.pivot > near_dead_point) return state;
  // A sketch of a change point rarely meets it to the last digit.
  State smooth_start;
  if (start_at_change_point(time, sketch, smooth_start)) return smooth_start;
  if (regular) return state;
  throw AnalysisError(
      {redundant_
           ? "the motion does not start: the mechanism stands at a dead point, or joints and "
             "drivers that repeat each other ask for different motions"
           : "the mechanism starts at a dead point, where its velocities are not determined; "
             "begin a little before or behind it (the phase of the driver)",
       "mechanism", time});
}

}  // namespace boxbeam::planar
