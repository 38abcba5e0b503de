#include "boxbeam/verification/balance_defect.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <optional>
#include <unsupported/Eigen/FFT>

#include "bent_dynamics.hpp"
#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/planar/constraints.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"

namespace boxbeam {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Derivatives of periodic functions, a row for each instant.
struct Periodic {
  MatrixXd first, second;
};

/// Multiplies every harmonic of the columns: f(i omega).
template <class F>
MatrixXd filtered(const MatrixXd& samples, double rate, const F& f) {
  Eigen::FFT<double> transform;
  const Index n = samples.rows();
  MatrixXd result(n, samples.cols());
  std::vector<double> column(static_cast<std::size_t>(n));
  std::vector<std::complex<double>> spectrum;
  for (Index k = 0; k < samples.cols(); ++k) {
    VectorXd::Map(column.data(), n) = samples.col(k);
    transform.fwd(spectrum, column);
    for (Index h = 0; h < n; ++h) {
      const double harmonic = static_cast<double>(2 * h < n ? h : h - n);
      spectrum[static_cast<std::size_t>(h)] *=
          2 * h == n ? 0.0 : f(std::complex<double>(0.0, harmonic * rate));
    }
    transform.inv(column, spectrum);
    result.col(k) = VectorXd::Map(column.data(), n);
  }
  return result;
}

Periodic derivatives(const MatrixXd& samples, double rate) {
  using C = std::complex<double>;
  return {filtered(samples, rate, [](C s) { return s; }),
          filtered(samples, rate, [](C s) { return s * s; })};
}

/// A mechanism whose beam is bent as a model's loads strain it, and what balances it.
class Bending {
 public:
  Bending(const RigidMotion& rigid, const ElasticBody& elastic, const LoadHistory& model)
      : rigid_(&rigid),
        elastic_(&elastic),
        model_(&model),
        states_(&rigid.motion->states),
        axis_(*rigid.mechanism, elastic),
        elements_(axis_.elements()),
        s_(axis_.nodes()),
        straight_(axis_.straight()) {}

  std::optional<BalanceDefect> defect() {
    const auto n = static_cast<Index>(states_->size());
    const double rate = full_turn / rigid_->motion->period;
    const auto elements = static_cast<Index>(elements_.size());
    // What the model says, against the rigid bodies.
    std::vector<std::vector<ElementCut>> by_model;
    MatrixXd stressed(n, 3 * elements);
    for (Index i = 0; i < n; ++i) {
      const CutForceDiagram diagram = model_->even_diagram(static_cast<std::size_t>(i));
      by_model.push_back(cuts_of(diagram));
      for (Index k = 0; k < elements; ++k) {
        const DividedAxis::Element& element = elements_[static_cast<std::size_t>(k)];
        const ElementCut& cut = by_model.back()[static_cast<std::size_t>(k)];
        stressed.row(i).segment<3>(3 * k) << cut.N / element.EA, cut.V / element.GA,
            cut.couple() / element.EI;
      }
    }
    const double tau = elastic_->retardation;
    const MatrixXd strains =
        filtered(stressed, rate, [&](std::complex<double> s) { return 1.0 / (1.0 + tau * s); });

    // Where everything is when the beam is bent so.
    BalanceDefect result;
    std::vector<BentAxis> axes;
    const Index coordinates = rigid_->mechanism->coordinates();
    const int body = elastic_->body;
    MatrixXd apart(n, coordinates + 3 * elements);
    for (Index i = 0; i < n; ++i) {
      const planar::State& state = state_at(i);
      const VectorXd row = strains.row(i);
      axes.push_back(axis_.bent(DividedAxis::Strains::Map(row.data(), 3, elements)));
      const std::optional<VectorXd> q = assembled(axis_.with(axes.back()), state);
      if (!q) return std::nullopt;
      apart.row(i) << (*q - state.q).transpose(),
          (places_of(axes.back(), body, *q) - places_of(straight_, body, state.q)).transpose();
      measure(axes.back(), result);
    }
    const Periodic rates = derivatives(apart, rate);
    const BentDynamics dynamics(*rigid_->mechanism, body, axis_);
    for (Index i = 0; i < n; ++i) {
      const planar::State& state = state_at(i);
      const BentAxis& axis = axes[static_cast<std::size_t>(i)];
      planar::State moved = state;
      moved.q += apart.row(i).head(coordinates).transpose();
      moved.v += rates.first.row(i).head(coordinates).transpose();
      moved.a += rates.second.row(i).head(coordinates).transpose();
      const VectorXd rigid_accelerations = accelerations(state);
      const VectorXd moved_accelerations =
          rigid_accelerations + rates.second.row(i).tail(3 * elements).transpose();
      const std::vector<ElementCut> by_bent =
          dynamics.cuts_of(axis_.with(axis), moved, axis, moved_accelerations);
      // The same division of the rigid beam: what its lumped masses miss is in both.
      const std::vector<ElementCut> by_straight =
          dynamics.cuts_of(*rigid_->mechanism, state, straight_, rigid_accelerations);
      const BeamLoads loads = rigid_->loads(si<Time>(state.time));
      const std::vector<ElementCut> by_rigid = cuts_of(cut_forces_of(loads));
      std::vector<ElementCut> defect;
      for (std::size_t k = 0; k < elements_.size(); ++k) {
        defect.push_back((by_bent[k] - by_straight[k]) -
                         (by_model[static_cast<std::size_t>(i)][k] - by_rigid[k]));
      }
      result.loads.push_back(loads_of(defect, loads.lines));
    }
    return result;
  }

 private:
  const planar::State& state_at(Index i) const { return (*states_)[static_cast<std::size_t>(i)]; }

  std::vector<ElementCut> cuts_of(const CutForceDiagram& diagram) const {
    std::vector<ElementCut> cuts;
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      const double from = s_[k], to = s_[k + 1];
      // Inside the element: at its ends it may jump.
      const double inside = 1e-7 * elastic_->length;
      const auto at = [&](double s) { return diagram.at({si<Length>(s), Side::both}); };
      const CutForces a = at(from + inside), b = at(to - inside);
      cuts.push_back({0.5 * (a.N + b.N).value(), 0.5 * (a.V_z + b.V_z).value(), -a.M_y.value(),
                      -b.M_y.value()});
    }
    return cuts;
  }

  /// Newton's method from the rigid position; none where it comes to no end.
  std::optional<VectorXd> assembled(const planar::Mechanism& mechanism,
                                    const planar::State& state) const {
    planar::ConstraintEquations equations(mechanism);
    equations.set_time(state.time);
    VectorXd q = state.q;
    VectorXd phi(equations.rows());
    std::vector<double> values(equations.pattern().entries());
    constexpr int most = 12;
    constexpr double closed = 1e-13;
    for (int pass = 0; pass < most; ++pass) {
      equations.set_position(q);
      equations.evaluate(phi, values);
      const VectorXd change = equations.pattern().dense(values).partialPivLu().solve(-phi);
      q += change;
      if (!q.allFinite()) break;
      if (change.cwiseAbs().maxCoeff() < closed * (1.0 + q.cwiseAbs().maxCoeff())) return q;
    }
    if (q.allFinite() && phi.cwiseAbs().maxCoeff() < 1e-9) return q;
    return std::nullopt;
  }

  /// Of the elements, as of `places_of`, in the rigid motion.
  VectorXd accelerations(const planar::State& state) const {
    const Index i = 3 * static_cast<Index>(elastic_->body);
    VectorXd result(3 * straight_.middle.cols());
    for (Index k = 0; k < straight_.middle.cols(); ++k) {
      result.segment<2>(3 * k) = planar::acceleration_of({elastic_->body, straight_.middle.col(k)},
                                                         state.q, state.v, state.a);
      result[3 * k + 2] = state.a[i + 2];
    }
    return result;
  }

  void measure(const BentAxis& axis, BalanceDefect& result) const {
    const Vector2d from = axis.node.col(axis_.held().first),
                   to = axis.node.col(axis_.held().second);
    const Vector2d along =
        (to - from).norm() > 0.0 ? Vector2d((to - from).normalized()) : Vector2d(Vector2d::UnitX());
    for (Index k = 0; k < axis.node.cols(); ++k) {
      const Vector2d d = axis.node.col(k) - from;
      result.deflection =
          std::max(result.deflection, std::abs(along.x() * d.y() - along.y() * d.x()));
    }
    result.turn = std::max(result.turn, axis.angle.maxCoeff() - axis.angle.minCoeff());
  }

  /// Point loads with these cut forces, whose couple is linear along every group of elements.
  BeamLoads loads_of(const std::vector<ElementCut>& cuts, std::vector<LineLoad> lines) const {
    const std::vector<std::size_t>& groups = axis_.groups();
    BeamLoads loads;
    unload(lines);
    loads.lines = std::move(lines);
    Eigen::Vector3d before = Eigen::Vector3d::Zero();  // N, V_z, M_y
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const std::size_t from = groups[g];
      Eigen::Vector3d behind = Eigen::Vector3d::Zero();
      Eigen::Vector3d next = Eigen::Vector3d::Zero();
      if (g + 1 < groups.size()) {
        const std::size_t to = groups[g + 1];
        const double length = s_[to] - s_[from];
        double N = 0.0;
        for (std::size_t k = from; k < to; ++k) N += cuts[k].N * elements_[k].length / length;
        const double V = -(cuts[to - 1].to - cuts[from].from) / length;
        behind = {N, V, -cuts[from].from};
        next = {N, V, -cuts[to - 1].to};
      }
      const Eigen::Vector3d jump = before - behind;
      PointLoad& load = loads.points.emplace_back();
      load.s = si<Length>(s_[from]);
      load.force = {jump[0], 0.0, jump[1]};
      load.moment = {0.0, jump[2], 0.0};
      before = next;
    }
    return loads;
  }

  const RigidMotion* rigid_;
  const ElasticBody* elastic_;
  const LoadHistory* model_;
  const std::vector<planar::State>* states_;
  DividedAxis axis_;
  const std::vector<DividedAxis::Element>& elements_;
  const std::vector<double>& s_;
  const BentAxis& straight_;
};

}  // namespace

std::string obstacle_to_balance(const planar::Mechanism& mechanism, int beam) {
  for (const planar::Joint& joint : mechanism.joints) {
    if (planar::rubs(joint)) return "joint " + joint.name + " rubs";
  }
  return obstacle_to_bent_axis(mechanism, beam);
}

std::optional<BalanceDefect> balance_defect_of(const RigidMotion& rigid, const ElasticBody& elastic,
                                               const LoadHistory& model) {
  return Bending(rigid, elastic, model).defect();
}

double error_by_balance(const RigidMotion& rigid, const ElasticBody& elastic, std::size_t modes,
                        const LoadHistory& model) {
  const planar::Motion& motion = *rigid.motion;
  const std::optional<BalanceDefect> defect = balance_defect_of(rigid, elastic, model);
  if (!defect) return unknown_balance;
  const double step = motion.period / static_cast<double>(motion.states.size());
  RigidMotion by_defect = rigid;
  by_defect.loads = [&](Time time) {
    const double at = (time.value() - motion.begin) / step;
    return defect->loads[static_cast<std::size_t>(std::lround(at)) % defect->loads.size()];
  };
  const LoadsAt axial = [&](Time time) { return model.loads_at(time); };
  const LoadsAt response =
      modes == 0 ? bent_statically(by_defect, elastic, axial)
                 : [of = std::make_shared<const ElasticMotion>(by_defect, elastic, modes, axial)](
                       Time time) { return of->loads_at(time); };
  const std::vector<ComparedPlace> places = compared_places_of(*rigid.beam);
  const MatrixXd stresses = stress_history(model, places);
  MatrixXd change(stresses.rows(), stresses.cols());
  for (std::size_t i = 0; i < motion.states.size(); ++i) {
    const Time time = si<Time>(motion.states[i].time);
    change.row(static_cast<Index>(i)) =
        fibre_stresses(cut_forces_of(response(time)), places).transpose();
  }
  // Largest values do not show what is no number.
  if (!change.allFinite()) return unknown_balance;
  const double peak = stresses.cwiseAbs().maxCoeff();
  if (peak == 0.0) return 0.0;
  const double range = largest_range(stresses);
  const double apart = change.cwiseAbs().maxCoeff() / peak;
  const double first = range > 0.0 ? std::max(apart, largest_range(change) / range) : apart;
  // From 1 on nothing converges.
  return first < 0.9 ? first / (1.0 - first) : unknown_balance;
}

}  // namespace boxbeam
