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

namespace boxbeam::planar {
namespace {

/// A scaled pivot at which no digit of a velocity is left: near a dead point pivots fall with the
/// root of the distance to it, and the error of velocities grows as round-off over that distance.
constexpr double no_digit_left = 1e-7;
/// The same for the smallest singular value of least squares, whose square ends in round-off.
constexpr double lost_in_squares = 3e-7;
constexpr double round_off = 1e-15;         ///< of a coordinate, relative
constexpr double still_closed = 1e-9;       ///< scaled residual of redundant equations that agree
constexpr double near_change_point = 1e-5;  ///< inverse of the condition next to one
constexpr double near_dead_point = 1e-6;    ///< a scaled pivot at a start that may be meant as one
constexpr int other_starts = 256;
constexpr int deepest_split = 24;  ///< halvings of a time step when a branch is followed
constexpr double smooth_enough = 0.02;

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

/// Between two states of a smooth motion: the polynomial of fifth degree that has the positions,
/// velocities and accelerations of both.
State interpolate(double time, const State& before, const State& behind) {
  const double h = behind.time - before.time;
  const double u = (time - before.time) / h;
  // In powers of u: q0 + v0 u + a0 u^2/2 + c3 u^3 + c4 u^4 + c5 u^5, times scaled by h.
  const Eigen::VectorXd v0 = h * before.v;
  const Eigen::VectorXd a0 = h * h * before.a;
  const Eigen::VectorXd q1 = behind.q - before.q - v0 - 0.5 * a0;
  const Eigen::VectorXd v1 = h * behind.v - v0 - a0;
  const Eigen::VectorXd a1 = h * h * behind.a - a0;
  const Eigen::VectorXd c3 = 10.0 * q1 - 4.0 * v1 + 0.5 * a1;
  const Eigen::VectorXd c4 = -15.0 * q1 + 7.0 * v1 - a1;
  const Eigen::VectorXd c5 = 6.0 * q1 - 3.0 * v1 + 0.5 * a1;
  State state;
  state.time = time;
  state.q = before.q + u * (v0 + u * (0.5 * a0 + u * (c3 + u * (c4 + u * c5))));
  state.v = (v0 + u * (a0 + u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5)))) / h;
  state.a = (a0 + u * (6.0 * c3 + u * (12.0 * c4 + u * 20.0 * c5))) / (h * h);
  return state;
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
         "mechanism",
         {},
         {},
         {}});
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
  Eigen::VectorXd velocity(count);
  Eigen::VectorXd column(mechanism_->equations());
  for (Eigen::Index j = 0; j < count; ++j) {
    const FrictionContact& contact = contacts_[static_cast<std::size_t>(j)];
    unit_friction(contact, state.q, step_);
    solve_transposed(step_, column);
    response.col(j) = column;
    velocity[j] = sliding_velocity_of(contact, state.q, state.v);
  }
  state.lambda += response * solve_friction(*mechanism_, contacts_, state.time, state.lambda,
                                            response, velocity);
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
    for (int e = pattern.row_start[static_cast<std::size_t>(r)];
         e < pattern.row_start[static_cast<std::size_t>(r) + 1]; ++e) {
      const auto entry = static_cast<std::size_t>(e);
      const double part = jacobian_[entry] * v[pattern.col[entry]];
      sum += part;
      size += std::abs(part);
    }
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
         "mechanism",
         time,
         state.residual,
         {}});
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
    for (int attempt = 1; !found && attempt <= other_starts; ++attempt) {
      const Assembly other = assembler.assemble(time, other_start(*mechanism_, sketch, attempt));
      found = other.closed && on_branch(*mechanism_, other.q);
      if (found) q = assemble(time, other.q);
    }
    if (!found) {
      throw AnalysisError({fmt::format("no assembly found on the wanted branch, from the sketch "
                                       "and {} other starts; change the sign asked for, or the "
                                       "sketch",
                                       other_starts),
                           off,
                           time,
                           {},
                           {}});
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
       "mechanism",
       time,
       {},
       {}});
}

// ---- following a branch ---------------------------------------------------------------------

bool InstantSolver::smooth(const State& from, const State& to, double tolerance) const {
  // Source of the rule: Hermite's quadrature, exact for polynomials of the third degree.
  const double dt = to.time - from.time;
  double error = 0.0;
  double change = 1e-9;
  for (Eigen::Index i = 0; i < to.q.size(); ++i) {
    const double moved = to.q[i] - from.q[i];
    const double by_rates = dt * (0.5 * (from.v[i] + to.v[i]) + dt / 12.0 * (from.a[i] - to.a[i]));
    error = std::max(error, std::abs(moved - by_rates) * inverse_scale_[i]);
    const double largest =
        std::max(std::abs(moved), std::abs(dt) * std::max(std::abs(from.v[i]), std::abs(to.v[i])));
    change = std::max(change, largest * inverse_scale_[i]);
  }
  // Where few digits are left, positions differ by their round-off.
  return error <= tolerance * change + 10.0 * round_off / std::min(1.0, to.pivot);
}

InstantSolver::Outcome InstantSolver::step(double time, const State& known, State& result,
                                           double tolerance, bool crossing) {
  const double dt = time - known.time;
  equations_.set_time(time);
  result.time = time;
  result.q = known.q + dt * (known.v + 0.5 * dt * known.a);
  if (!correct(result.q)) return Outcome::no_convergence;
  if (!complete(result)) return Outcome::singular;
  if (!on_branch(*mechanism_, equations_)) return Outcome::off_branch;
  if (!crossing) {
    const bool comparable = known.assembly != 0 && result.assembly != 0;
    if (comparable && known.assembly != result.assembly) return Outcome::other_assembly;
    const bool comparable_minors = redundant_ && known.pivot > 0.0;
    if (comparable_minors && !on_same_side(known, result)) return Outcome::other_assembly;
  }
  return smooth(known, result, tolerance) ? Outcome::good : Outcome::not_smooth;
}

void InstantSolver::solve_near(double time, const State& known, State& result) {
  // At the known instant itself only the mechanism's masses can differ: the position holds.
  if (time == known.time) {
    result = solve_at(time, known.q);
    return;
  }
  const Outcome direct = step(time, known, result, smooth_enough, false);
  if (direct == Outcome::good) return;
  State reached = known;
  if (follow(time, known, result, reached, deepest_split) == Outcome::good) return;
  // A near miss of a dead point looks smooth from afar: a change point is singular where it is.
  const double condition = condition_of(*mechanism_, reached.q);
  const bool singular = condition == 0.0 || condition * near_change_point > 1.0;
  if (singular && pass_change_point(time, reached.time, known, result)) return;
  throw AnalysisError(failure_of_motion(*mechanism_, reached, time));
}

State InstantSolver::solve_near(double time, const State& known) {
  State result;
  solve_near(time, known, result);
  return result;
}

InstantSolver::Outcome InstantSolver::follow(double time, const State& known, State& result,
                                             State& reached, int splits) {
  const Outcome direct = step(time, known, result, smooth_enough, false);
  if (direct == Outcome::good) {
    reached = result;
    return direct;
  }
  if (splits == 0) return direct;
  State middle;
  const Outcome half =
      follow(known.time + 0.5 * (time - known.time), known, middle, reached, splits - 1);
  if (half != Outcome::good) return half;
  return follow(time, middle, result, reached, splits - 1);
}

bool InstantSolver::pass_change_point(double time, double place, const State& known,
                                      State& result) {
  // A step over the place where the Jacobian is singular, from far enough before it to far enough
  // behind it: on the smooth branch the rule of Hermite holds to a high order, on the other one
  // velocities jump.
  constexpr double smooth_branch = 1e-4;
  const double dt = time - known.time;
  State beyond;
  for (const double share : {1.0, 1.5, 2.0, 3.0}) {
    const double target = known.time + share * dt;
    if (step(target, known, beyond, smooth_branch, true) != Outcome::good) continue;
    if (!assembles_around(place, known, beyond)) return false;
    change_points_.push_back(place);
    if (share == 1.0) {
      result = beyond;
    } else if (step(time, beyond, result, smooth_branch, true) != Outcome::good) {
      interpolate_singular(time, known, beyond, result);
    }
    return true;
  }
  return false;
}

bool InstantSolver::assembles_around(double place, const State& before, const State& behind) const {
  // Where a driver leads out of reach and back, there is nothing to pass over: then the mechanism
  // cannot be assembled somewhere in between.
  Assembler assembler(*mechanism_);
  const double width = behind.time - before.time;
  for (int k = 3; k <= 24; k += 3) {
    for (const double sign : {-1.0, 1.0}) {
      const double time = place + sign * width * std::ldexp(1.0, -k);
      const double inside = (time - before.time) / width;
      if (inside <= 0.0 || inside >= 1.0) continue;
      if (!assembler.assemble(time, interpolate(time, before, behind).q).closed) return false;
    }
  }
  return true;
}

void InstantSolver::interpolate_singular(double time, const State& before, const State& behind,
                                         State& result) {
  result = interpolate(time, before, behind);
  equations_.set_time(time);
  equations_.set_position(result.q);
  equations_.evaluate(phi_);
  result.residual = phi_.cwiseProduct(equations_.row_scale()).lpNorm<Eigen::Infinity>();
  result.assembly = 0;
  // At a change point nothing but inertia leads the mechanism across: unless it asks for no force,
  // reactions grow without bound towards it.
  State nearer;
  const double half_way = 0.5 * (time + before.time);
  const bool known = step(half_way, before, nearer, smooth_enough, true) == Outcome::good;
  const double far = before.lambda.lpNorm<Eigen::Infinity>();
  if (!known || nearer.lambda.lpNorm<Eigen::Infinity>() > 1.5 * far + 1e-12) {
    throw AnalysisError(
        {"reactions grow without bound: at a change point the mechanism can go over to another "
         "branch, and only inertia keeps it on this one; guide it (a second crank, a gear), or ask "
         "for an instant beside it",
         "mechanism",
         time,
         {},
         {}});
  }
  const double share = (time - before.time) / (behind.time - before.time);
  result.lambda = (1.0 - share) * before.lambda + share * behind.lambda;
}

bool InstantSolver::start_at_change_point(double time, const Eigen::VectorXd& sketch,
                                          State& state) {
  // The states a little later and a little earlier on a smooth motion through this position. Of two
  // that cross here, the sketch decides.
  const double h = 1e-3 * time_span_of(*mechanism_).length;
  State later, earlier;
  later.time = time + h;
  Assembly assembly = Assembler(*mechanism_).assemble(later.time, sketch);
  if (!assembly.closed) return false;
  equations_.set_time(later.time);
  if (!correct(assembly.q)) return false;
  later.q = unwound(assembly.q, sketch);
  equations_.set_position(later.q);
  if (!complete(later) || later.residual > still_closed) return false;
  if (!on_branch(*mechanism_, later.q)) return false;
  if (step(time - h, later, earlier, 1e-4, true) != Outcome::good) return false;
  if (!assembles_around(time, earlier, later)) return false;
  // A regular position near a dead point is a start like any other.
  if (step(time, later, state, smooth_enough, false) == Outcome::good) return true;
  interpolate_singular(time, earlier, later, state);
  change_points_.push_back(time);
  return true;
}

bool InstantSolver::on_same_side(const State& known, const State& result) {
  // All minors of the Jacobian change their sign together at a change point, and only there; by the
  // formula of Cauchy and Binet the sum of their products is this determinant.
  const auto scaled = [&](const State& at) -> Eigen::MatrixXd {
    equations_.set_time(at.time);
    equations_.set_position(at.q);
    equations_.evaluate(phi_, jacobian_);
    return equations_.row_scale().asDiagonal() * equations_.pattern().dense(jacobian_) *
           equations_.col_scale().asDiagonal();
  };
  const Eigen::MatrixXd before = scaled(known);
  const Eigen::MatrixXd product = before.transpose() * scaled(result);
  return Eigen::PartialPivLU<Eigen::MatrixXd>(product).determinant() > 0.0;
}

}  // namespace boxbeam::planar
