#include "support/corotational_mechanism.hpp"

#include <Eigen/QR>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/section/section_properties.hpp"

namespace test {
namespace {

using namespace boxbeam;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

struct Node {
  double s = 0.0;
  Index dof = 0;
};

struct Element {
  std::size_t from = 0;
  double length = 0.0, EA = 0.0, EI = 0.0, mass = 0.0;
  std::array<double, 2> area{}, W{};  // at its two ends, inside it
};

double wrapped(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi); }

Vector2d left(const Vector2d& v) { return {-v.y(), v.x()}; }

/// Where a joint holds: a node of the beam, a place of a rigid body, or the ground.
struct Place {
  Index dof = -1;  // -1: ground
  Vector2d arm = Vector2d::Zero();
};

struct Equation {
  enum class Kind { x, y, across, angle, driven } kind = Kind::x;
  Place a, b;
  double direction = 0.0;  // of a slider's line
  double offset = 0.0;     // of an angle
  const Driver* driver = nullptr;
};

class Model {
 public:
  Model(const Project& project, int elements) : mechanism_(planar_of(project)) {
    beam_ = static_cast<std::size_t>(project.beam_body);
    centre_ = mass_properties_of(project.beam).centre.value();
    tau_ = project.model.retardation;
    body_dof_.assign(mechanism_.bodies.size(), -1);
    for (std::size_t i = 0; i < mechanism_.bodies.size(); ++i) {
      if (i == beam_) continue;
      body_dof_[i] = size_;
      size_ += 3;
    }
    divide(project, elements);
    for (const planar::Joint& joint : mechanism_.joints) add(joint);
    for (const planar::AppliedForce& force : mechanism_.forces) {
      const auto* point = std::get_if<planar::PointForce>(&force.kind);
      if (point == nullptr || point->turns) throw std::invalid_argument("force not known");
      forces_.push_back({place_of(point->at), point});
    }
    gather_mass();
  }

  Index size() const { return size_; }
  Index equations() const { return static_cast<Index>(equations_.size()); }
  const Eigen::SparseMatrix<double>& mass() const { return mass_; }
  double stiff() const { return elements_.front().EA / elements_.front().length; }

  /// The rigid motion's positions or velocities as those of all coordinates.
  VectorXd positions(const planar::State& state) const {
    VectorXd q(size_);
    for (std::size_t i = 0; i < body_dof_.size(); ++i) {
      if (body_dof_[i] >= 0) q.segment<3>(body_dof_[i]) = state.q.segment<3>(3 * Index(i));
    }
    const Eigen::Vector3d at = state.q.segment<3>(3 * Index(beam_));
    for (const Node& node : nodes_) {
      const double x = node.s - centre_;
      q[node.dof] = at[0] + x * std::cos(at[2]);
      q[node.dof + 1] = at[1] + x * std::sin(at[2]);
      q[node.dof + 2] = at[2];
    }
    return q;
  }
  VectorXd velocities(const planar::State& state) const {
    VectorXd v(size_);
    for (std::size_t i = 0; i < body_dof_.size(); ++i) {
      if (body_dof_[i] >= 0) v.segment<3>(body_dof_[i]) = state.v.segment<3>(3 * Index(i));
    }
    const double angle = state.q[3 * Index(beam_) + 2];
    const Eigen::Vector3d at = state.v.segment<3>(3 * Index(beam_));
    for (const Node& node : nodes_) {
      const double x = node.s - centre_;
      v[node.dof] = at[0] - at[2] * x * std::sin(angle);
      v[node.dof + 1] = at[1] + at[2] * x * std::cos(angle);
      v[node.dof + 2] = at[2];
    }
    return v;
  }

  struct Forces {
    VectorXd internal;  // less the external ones
    std::vector<Eigen::Triplet<double>> stiffness, damping;
  };

  Forces forces(const VectorXd& q, const VectorXd& v, double time, double more_damping) const {
    Forces result{VectorXd::Zero(size_), {}, {}};
    for (const Element& element : elements_) {
      const Index i = nodes_[element.from].dof;
      const Strain at = strain_of(element, q, v, tau_ * more_damping);
      result.internal.segment<6>(i) += at.B.transpose() * at.stress;
      const Matrix6 damping = tau_ * more_damping * at.B.transpose() * at.D * at.B;
      Matrix6 stiffness = at.B.transpose() * at.D * at.B;
      stiffness += at.stress[0] / at.length * at.z * at.z.transpose();
      stiffness += (at.stress[1] + at.stress[2]) / (at.length * at.length) *
                   (at.r * at.z.transpose() + at.z * at.r.transpose());
      for (Index row = 0; row < 6; ++row) {
        for (Index column = 0; column < 6; ++column) {
          result.stiffness.emplace_back(i + row, i + column, stiffness(row, column));
          result.damping.emplace_back(i + row, i + column, damping(row, column));
        }
      }
    }
    for (const auto& [place, force] : forces_) {
      const double size = driver_at(force->size, time).value;
      const Vector2d vector =
          size * Vector2d(std::cos(force->direction), std::sin(force->direction));
      if (place.dof < 0) continue;
      result.internal.segment<2>(place.dof) -= vector;
      const Vector2d arm = turned(q, place);
      result.internal[place.dof + 2] -= arm.x() * vector.y() - arm.y() * vector.x();
    }
    VectorXd acceleration = VectorXd::Zero(size_);
    for (Index dof = 0; dof < size_; dof += 3) acceleration.segment<2>(dof) = mechanism_.gravity;
    result.internal -= mass_ * acceleration;
    return result;
  }

  VectorXd gaps(const VectorXd& q, double time) const {
    VectorXd gap(equations());
    for (Index k = 0; k < equations(); ++k) {
      const Equation& of = equations_[static_cast<std::size_t>(k)];
      switch (of.kind) {
        case Equation::Kind::x: gap[k] = (where(q, of.a) - where(q, of.b)).x(); break;
        case Equation::Kind::y: gap[k] = (where(q, of.a) - where(q, of.b)).y(); break;
        case Equation::Kind::across:
          gap[k] = across(of).dot(where(q, of.a) - where(q, of.b));
          break;
        case Equation::Kind::angle:
          gap[k] = angle_at(q, of.a) - angle_at(q, of.b) - of.offset;
          break;
        case Equation::Kind::driven:
          gap[k] = q[of.a.dof + 2] - driver_at(*of.driver, time).value;
          break;
      }
    }
    return gap;
  }

  MatrixXd jacobian(const VectorXd& q) const {
    MatrixXd J = MatrixXd::Zero(equations(), size_);
    for (Index k = 0; k < equations(); ++k) {
      const Equation& of = equations_[static_cast<std::size_t>(k)];
      if (of.kind == Equation::Kind::angle || of.kind == Equation::Kind::driven) {
        if (of.a.dof >= 0) J(k, of.a.dof + 2) = 1.0;
        if (of.b.dof >= 0) J(k, of.b.dof + 2) = -1.0;
        continue;
      }
      const Vector2d n = normal(of);
      for (const auto& [place, sign] : {std::pair(&of.a, 1.0), std::pair(&of.b, -1.0)}) {
        if (place->dof < 0) continue;
        J.block<1, 2>(k, place->dof) += sign * n.transpose();
        J(k, place->dof + 2) += sign * n.dot(left(turned(q, *place)));
      }
    }
    return J;
  }

  /// The change of J^T lambda with the bodies' angles.
  void add_turning(const VectorXd& q, const VectorXd& lambda,
                   std::vector<Eigen::Triplet<double>>& stiffness) const {
    for (Index k = 0; k < equations(); ++k) {
      const Equation& of = equations_[static_cast<std::size_t>(k)];
      if (of.kind == Equation::Kind::angle || of.kind == Equation::Kind::driven) continue;
      for (const auto& [place, sign] : {std::pair(&of.a, 1.0), std::pair(&of.b, -1.0)}) {
        if (place->dof < 0) continue;
        stiffness.emplace_back(place->dof + 2, place->dof + 2,
                               -sign * lambda[k] * normal(of).dot(turned(q, *place)));
      }
    }
  }

  std::vector<double> places() const {
    std::vector<double> places;
    for (const Element& element : elements_) {
      places.push_back(nodes_[element.from].s);
      places.push_back(nodes_[element.from + 1].s);
    }
    return places;
  }

  /// N/A + M/W and N/A - M/W at the ends of all elements. N of an element is that of its middle.
  VectorXd stresses(const VectorXd& q, const VectorXd& v, double more_damping) const {
    std::vector<Eigen::Vector3d> of;
    for (const Element& element : elements_) {
      of.push_back(strain_of(element, q, v, tau_ * more_damping).stress);
    }
    VectorXd stresses(4 * Index(elements_.size()));
    const auto jumps = [&](std::size_t node) { return node == 0 || jump_[node]; };
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
        const std::size_t node = k + end;
        const bool last = end == 1 && k + 1 == elements_.size();
        double N = of[k][0];
        const std::size_t beyond = end == 0 ? k - 1 : k + 1;
        if (!last && !jumps(node)) {
          N = 0.5 * (N + of[beyond][0]);
        } else {  // extrapolated from within
          const std::size_t within = end == 0 ? k + 1 : k - 1;
          const bool inside = within < elements_.size() && !(end == 0 ? jumps(k + 1) : jumps(k));
          if (inside) N += 0.5 * (N - of[within][0]);
        }
        const double M = end == 0 ? -of[k][1] : of[k][2];
        const Index row = 4 * Index(k) + 2 * Index(end);
        stresses[row] = N / elements_[k].area[end] + M / elements_[k].W[end];
        stresses[row + 1] = N / elements_[k].area[end] - M / elements_[k].W[end];
      }
    }
    return stresses;
  }

 private:
  struct Strain {
    Eigen::Vector3d stress;  // N, M_1, M_2
    Eigen::Matrix<double, 3, 6> B;
    Eigen::Matrix3d D;
    Vector6 r, z;
    double length = 0.0;
  };

  static Strain strain_of(const Element& element, const VectorXd& q, const VectorXd& v, double tau,
                          Index i) {
    Strain at;
    const Vector2d d = q.segment<2>(i + 3) - q.segment<2>(i);
    at.length = d.norm();
    const double c = d.x() / at.length, s = d.y() / at.length;
    const double beta = std::atan2(d.y(), d.x());
    at.r << -c, -s, 0, c, s, 0;
    at.z << s, -c, 0, -s, c, 0;
    at.B.row(0) = at.r.transpose();
    at.B.row(1) = -at.z.transpose() / at.length;
    at.B.row(2) = at.B.row(1);
    at.B(1, 2) += 1.0;
    at.B(2, 5) += 1.0;
    at.D.setZero();
    at.D(0, 0) = element.EA / element.length;
    at.D(1, 1) = at.D(2, 2) = 4.0 * element.EI / element.length;
    at.D(1, 2) = at.D(2, 1) = 2.0 * element.EI / element.length;
    // (l^2 - l_0^2)/(l + l_0) keeps the digits of a small stretch.
    const double stretch =
        (d.squaredNorm() - element.length * element.length) / (at.length + element.length);
    const Eigen::Vector3d strain(stretch, wrapped(q[i + 2] - beta), wrapped(q[i + 5] - beta));
    at.stress = at.D * (strain + tau * (at.B * v.segment<6>(i)));
    return at;
  }
  Strain strain_of(const Element& element, const VectorXd& q, const VectorXd& v, double tau) const {
    return strain_of(element, q, v, tau, nodes_[element.from].dof);
  }

  void divide(const Project& project, int count) {
    const TaperedBeam& beam = project.beam;
    const double length = beam.length().value();
    std::vector<double> fixed{0.0, length};
    for (const Segment& segment : beam.segments) fixed.push_back(segment.start.value());
    std::vector<double> loaded;
    const auto keep = [&](const planar::Attachment& at) {
      if (at.body == static_cast<int>(beam_)) loaded.push_back(at.p.x() + centre_);
    };
    for (const planar::Joint& joint : mechanism_.joints) {
      const auto [a, b] = planar::ends_of(joint);
      keep(a);
      keep(b);
    }
    fixed.insert(fixed.end(), loaded.begin(), loaded.end());
    std::sort(fixed.begin(), fixed.end());
    const double near = 1e-9 * length;
    fixed.erase(
        std::unique(fixed.begin(), fixed.end(), [&](double a, double b) { return b - a < near; }),
        fixed.end());
    const auto add_node = [&](double s) {
      nodes_.push_back({s, size_});
      size_ += 3;
      jump_.push_back(std::any_of(loaded.begin(), loaded.end(),
                                  [&](double at) { return std::abs(at - s) < near; }) ||
                      std::any_of(beam.segments.begin(), beam.segments.end(), [&](const auto& of) {
                        return std::abs(of.start.value() - s) < near;
                      }));
    };
    add_node(fixed.front());
    for (std::size_t k = 1; k < fixed.size(); ++k) {
      const double gap = fixed[k] - fixed[k - 1];
      const int parts = std::max(2, static_cast<int>(std::ceil(count * gap / length - 1e-6)));
      for (int i = 1; i <= parts; ++i) {
        const double from = nodes_.back().s;
        add_node(i == parts ? fixed[k] : fixed[k - 1] + gap * i / parts);
        const double to = nodes_.back().s;
        const SectionProperties middle = at(beam, 0.5 * (from + to), Side::both);
        Element& element = elements_.emplace_back();
        element.from = nodes_.size() - 2;
        element.length = to - from;
        element.EA = project.model.youngs_modulus * middle.area.value();
        element.EI = project.model.youngs_modulus * middle.I_y.value();
        element.mass = beam.density.value() * middle.area.value() * element.length;
        for (const auto& [end, s, side] :
             {std::tuple(0, from, Side::behind), std::tuple(1, to, Side::before)}) {
          const SectionProperties there = at(beam, s, side);
          element.area[static_cast<std::size_t>(end)] = there.area.value();
          element.W[static_cast<std::size_t>(end)] = there.W_y.value();
        }
      }
    }
  }

  static SectionProperties at(const TaperedBeam& beam, double s, Side side) {
    Length place = si<Length>(s);
    for (const Segment& segment : beam.segments) {
      if (std::abs(segment.start.value() - s) < 1e-9) place = segment.start;
      if (std::abs(segment.end().value() - s) < 1e-9) place = segment.end();
    }
    return properties_of(section_at(beam, {place, side}));
  }

  Place place_of(const planar::Attachment& at) const {
    if (at.body == planar::ground) return {-1, at.p};
    const auto body = static_cast<std::size_t>(at.body);
    if (body != beam_) return {body_dof_[body], at.p};
    if (std::abs(at.p.y()) > 1e-9) throw std::invalid_argument("a joint beside the beam's axis");
    for (const Node& node : nodes_) {
      if (std::abs(node.s - at.p.x() - centre_) < 1e-7) return {node.dof, Vector2d::Zero()};
    }
    throw std::invalid_argument("a joint between nodes");
  }

  void add(const planar::Joint& joint) {
    using Kind = Equation::Kind;
    if (const auto* pin = std::get_if<planar::Pin>(&joint.kind)) {
      equations_.push_back({Kind::x, place_of(pin->a), place_of(pin->b)});
      equations_.push_back({Kind::y, place_of(pin->a), place_of(pin->b)});
    } else if (const auto* rigid = std::get_if<planar::Rigid>(&joint.kind)) {
      equations_.push_back({Kind::x, place_of(rigid->a), place_of(rigid->b)});
      equations_.push_back({Kind::y, place_of(rigid->a), place_of(rigid->b)});
      equations_.push_back(
          {Kind::angle, place_of(rigid->a), place_of(rigid->b), 0.0, rigid->angle});
    } else if (const auto* slider = std::get_if<planar::Slider>(&joint.kind)) {
      if (slider->guide.body != planar::ground) throw std::invalid_argument("a guide that moves");
      equations_.push_back(
          {Kind::across, place_of(slider->point), place_of(slider->guide), slider->direction});
      equations_.push_back({Kind::angle, place_of(slider->point), {}, 0.0, slider->angle});
    } else if (const auto* driven = std::get_if<planar::Driven>(&joint.kind)) {
      if (driven->coordinate != planar::Coordinate::angle || driven->other.body != planar::ground) {
        throw std::invalid_argument("a driver of something else than an angle");
      }
      equations_.push_back({Kind::driven, place_of(driven->point), {}, 0.0, 0.0, &driven->driver});
    } else {
      throw std::invalid_argument("a joint that is not known");
    }
  }

  static Vector2d across(const Equation& of) {
    return {-std::sin(of.direction), std::cos(of.direction)};
  }
  static Vector2d normal(const Equation& of) {
    if (of.kind == Equation::Kind::x) return Vector2d::UnitX();
    if (of.kind == Equation::Kind::y) return Vector2d::UnitY();
    return across(of);
  }
  static double angle_at(const VectorXd& q, const Place& place) {
    return place.dof < 0 ? 0.0 : q[place.dof + 2];
  }
  static Vector2d turned(const VectorXd& q, const Place& place) {
    const double c = std::cos(q[place.dof + 2]), s = std::sin(q[place.dof + 2]);
    return {c * place.arm.x() - s * place.arm.y(), s * place.arm.x() + c * place.arm.y()};
  }
  static Vector2d where(const VectorXd& q, const Place& place) {
    if (place.dof < 0) return place.arm;
    return q.segment<2>(place.dof) + turned(q, place);
  }

  void gather_mass() {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < body_dof_.size(); ++i) {
      const Index dof = body_dof_[i];
      if (dof < 0) continue;
      entries.emplace_back(dof, dof, mechanism_.bodies[i].mass);
      entries.emplace_back(dof + 1, dof + 1, mechanism_.bodies[i].mass);
      entries.emplace_back(dof + 2, dof + 2, mechanism_.bodies[i].inertia);
    }
    for (const Element& element : elements_) {
      const Index a = nodes_[element.from].dof, b = nodes_[element.from + 1].dof;
      for (const Index axis : {0, 1}) {
        entries.emplace_back(a + axis, a + axis, element.mass / 3);
        entries.emplace_back(b + axis, b + axis, element.mass / 3);
        entries.emplace_back(a + axis, b + axis, element.mass / 6);
        entries.emplace_back(b + axis, a + axis, element.mass / 6);
      }
    }
    mass_.resize(size_, size_);
    mass_.setFromTriplets(entries.begin(), entries.end());
  }

  const planar::Mechanism& mechanism_;
  std::size_t beam_ = 0;
  double centre_ = 0.0, tau_ = 0.0;
  Index size_ = 0;
  std::vector<Index> body_dof_;
  std::vector<Node> nodes_;
  std::vector<bool> jump_;
  std::vector<Element> elements_;
  std::vector<Equation> equations_;
  std::vector<std::pair<Place, const planar::PointForce*>> forces_;
  Eigen::SparseMatrix<double> mass_;
};

/// The generalised-alpha method with constraints of Arnold and Brüls.
class Integration {
 public:
  Integration(const Model& model, double step, const planar::State& start)
      : model_(&model), h_(step), q_(model.positions(start)), v_(model.velocities(start)) {
    rate_ = a_ = VectorXd::Zero(model.size());
    lambda_ = VectorXd::Zero(model.equations());
  }

  void step(double time, double more_damping) {
    constexpr double radius = 0.7;  // at infinite frequency
    constexpr double alpha_m = (2.0 * radius - 1.0) / (radius + 1.0);
    constexpr double alpha_f = radius / (radius + 1.0);
    constexpr double gamma = 0.5 + alpha_f - alpha_m;
    constexpr double beta = 0.25 * (gamma + 0.5) * (gamma + 0.5);
    q_ += h_ * v_ + h_ * h_ * (0.5 - beta) * a_;
    v_ += h_ * (1.0 - gamma) * a_;
    a_ = (alpha_f * rate_ - alpha_m * a_) / (1.0 - alpha_m);
    q_ += h_ * h_ * beta * a_;
    v_ += h_ * gamma * a_;
    rate_.setZero();
    const double of_rate = (1.0 - alpha_m) / (h_ * h_ * beta * (1.0 - alpha_f));
    const double of_velocity = gamma / (h_ * beta);
    const Index n = model_->size(), m = model_->equations();
    const double scale = model_->stiff();
    for (int pass = 0; pass < 12; ++pass) {
      Model::Forces forces = model_->forces(q_, v_, time, more_damping);
      const MatrixXd J = model_->jacobian(q_);
      VectorXd residual(n + m);
      residual.head(n) = model_->mass() * rate_ + forces.internal + J.transpose() * lambda_;
      residual.tail(m) = scale * model_->gaps(q_, time);
      model_->add_turning(q_, lambda_, forces.stiffness);
      std::vector<Eigen::Triplet<double>> entries = std::move(forces.stiffness);
      for (const auto& entry : forces.damping) {
        entries.emplace_back(entry.row(), entry.col(), of_velocity * entry.value());
      }
      for (Index column = 0; column < n; ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator it(model_->mass(), column); it; ++it) {
          entries.emplace_back(it.row(), it.col(), of_rate * it.value());
        }
        for (Index row = 0; row < m; ++row) {
          if (J(row, column) == 0.0) continue;
          entries.emplace_back(n + row, column, scale * J(row, column));
          entries.emplace_back(column, n + row, scale * J(row, column));
        }
      }
      Eigen::SparseMatrix<double> system(n + m, n + m);
      system.setFromTriplets(entries.begin(), entries.end());
      if (!analysed_) solver_.analyzePattern(system);
      analysed_ = true;
      solver_.factorize(system);
      if (solver_.info() != Eigen::Success) throw std::runtime_error("singular");
      const VectorXd change = -solver_.solve(residual);
      q_ += change.head(n);
      v_ += of_velocity * change.head(n);
      rate_ += of_rate * change.head(n);
      lambda_ += scale * change.tail(m);
      if (!q_.allFinite()) throw std::runtime_error("no solution");
      if (change.head(n).cwiseAbs().maxCoeff() < 1e-10) break;
    }
    a_ += (1.0 - alpha_f) / (1.0 - alpha_m) * rate_;
  }

  const VectorXd& q() const { return q_; }
  const VectorXd& v() const { return v_; }
  VectorXd state() const {
    VectorXd all(4 * q_.size());
    all << q_, v_, a_, rate_;
    return all;
  }
  void set_state(const VectorXd& all) {
    const Index n = q_.size();
    q_ = all.head(n);
    v_ = all.segment(n, n);
    a_ = all.segment(2 * n, n);
    rate_ = all.tail(n);
  }

 private:
  const Model* model_;
  double h_;
  VectorXd q_, v_, a_, rate_, lambda_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver_;
  bool analysed_ = false;
};

/// The limit of states that follow each other from period to period, two vibrations dying away in
/// them, each a geometric series with a complex ratio, which the stresses of the periods show.
/// `states`: at the ends of these periods, a column each. Source: Sidi, Ford, Smith, SIAM Journal
/// on Numerical Analysis 23 (1986), minimal polynomial extrapolation.
VectorXd extrapolated(const MatrixXd& states, const std::vector<MatrixXd>& stresses) {
  const auto count = static_cast<Index>(stresses.size()) - 1;  // of differences
  MatrixXd differences(stresses.front().size(), count);
  for (Index i = 0; i < count; ++i) {
    const MatrixXd change =
        stresses[static_cast<std::size_t>(i) + 1] - stresses[static_cast<std::size_t>(i)];
    differences.col(i) = change.reshaped();
  }
  const VectorXd c = differences.leftCols(count - 1).colPivHouseholderQr().solve(
      VectorXd(-differences.col(count - 1)));
  const double sum = c.sum() + 1.0;
  constexpr double none = 1e-3;
  if (std::abs(sum) < none) return states.rightCols<1>();
  return (states.leftCols(count - 1) * c + states.col(count - 1)) / sum;
}

}  // namespace

double CorotationalStress::largest_at(double s) const {
  double most = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::abs(places[i] - s) < 1e-6) most = std::max(most, largest[i]);
  }
  return most;
}

CorotationalStress corotational_stress(const Project& project, const CorotationalOptions& options) {
  const Model model(project, options.elements);
  const planar::Motion motion = planar::solve_motion(planar_of(project));
  const double step = motion.period / options.steps;
  Integration integration(model, step, motion.states.front());
  CorotationalStress result;
  result.places = model.places();
  MatrixXd before, now;
  long count = 0;
  // What turns on with every period.
  const VectorXd turns = model.positions(motion.end) - model.positions(motion.states.front());
  constexpr std::size_t in_a_row = 6;
  std::vector<MatrixXd> row;
  MatrixXd states(4 * model.size(), Index(in_a_row));
  for (int period = 0; period < options.most_periods; ++period) {
    // What the start sets off dies away sooner under more damping.
    const double more_damping = period < 2 ? 8.0 : 1.0;
    now.resize(options.steps, 2 * Index(result.places.size()));
    for (int i = 0; i < options.steps; ++i) {
      integration.step(motion.begin + step * static_cast<double>(++count), more_damping);
      now.row(i) = model.stresses(integration.q(), integration.v(), more_damping).transpose();
    }
    result.periods = period + 1;
    if (period > 3 &&
        (now - before).cwiseAbs().maxCoeff() < options.tolerance * now.cwiseAbs().maxCoeff()) {
      result.settled = true;
      break;
    }
    before = now;
    if (period < 3) continue;
    states.col(Index(row.size())) = integration.state();
    states.col(Index(row.size())).head(model.size()) -= double(period) * turns;
    row.push_back(now);
    if (row.size() < in_a_row) continue;
    VectorXd limit = extrapolated(states, row);
    limit.head(model.size()) += double(period) * turns;
    integration.set_state(limit);
    row.clear();
  }
  for (std::size_t i = 0; i < result.places.size(); ++i) {
    result.largest.push_back(now.middleCols(2 * Index(i), 2).cwiseAbs().maxCoeff());
  }
  result.governing = now.cwiseAbs().maxCoeff();
  return result;
}

}  // namespace test
