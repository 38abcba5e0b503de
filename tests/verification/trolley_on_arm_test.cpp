// Vibration of an arm along which a mass runs, against the sum of its own modes under a moving
// mass.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "support/space_arm.hpp"
#include "support/space_elements.hpp"

namespace trolley_on_arm_test {

using namespace boxbeam;
using namespace test::space_arm;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr double g = 9.81;

/// A mass m that runs along an arm whose heel is shaken, w = h + sum of phi_i q_i, phi of the arm
/// alone on a heel that stands:
///
///     q_i'' + w_i^2 q_i = -(h'' + g) b_i - F phi_i(s),
///     F = m (g + h'' + sum of phi_i q_i'' + 2 s' phi_i' q_i' + (s'' phi_i' + s'^2 phi_i'') q_i)
///
/// Source: Fryba, Vibration of Solids and Structures under Moving Loads (1999), chapter 8, the
/// whole acceleration of the mass.
class Trolley {
 public:
  Trolley(const TaperedBeam& beam, double mass, Driver heel, Driver along)
      : mass_(mass),
        heel_(std::move(heel)),
        along_(std::move(along)),
        whole_(test::space_elements::assembled(beam, 1e-6, Vector3d::Zero(),
                                               1e-6 * Eigen::Matrix3d::Identity())) {
    const Index size = whole_.K.rows();
    const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(
        whole_.K.bottomRightCorner(size - 6, size - 6),
        whole_.M.bottomRightCorner(size - 6, size - 6));
    // Those that shift in z.
    std::vector<VectorXd> shapes;
    std::vector<double> squares;
    for (Index i = 0; shapes.size() < 14; ++i) {
      VectorXd shape = VectorXd::Zero(size);
      shape.tail(size - 6) = solver.eigenvectors().col(i);
      double z = 0.0, beside = 0.0;
      for (Index node = 0; node < size / 6; ++node) {
        z += std::pow(shape[6 * node + 2], 2);
        beside += std::pow(shape[6 * node], 2) + std::pow(shape[6 * node + 1], 2) +
                  std::pow(shape[6 * node + 3], 2);
      }
      if (z < beside) continue;
      shapes.push_back(shape);
      squares.push_back(solver.eigenvalues()[i]);
    }
    shapes_.resize(size, static_cast<Index>(shapes.size()));
    for (std::size_t i = 0; i < shapes.size(); ++i) shapes_.col(static_cast<Index>(i)) = shapes[i];
    squares_ = VectorXd::Map(squares.data(), static_cast<Index>(squares.size()));
    up_ = VectorXd::Zero(size);
    for (Index i = 2; i < size; i += 6) up_[i] = 1.0;
    by_mass_ = shapes_.transpose() * (whole_.M * up_);
    h_ = beam.length().value() / 60.0;
  }

  struct At {
    VectorXd q, speed;
  };
  At resting() const {
    const VectorXd phi = shape_at(driver_at(along_, 0.0).value, 0);
    return {-g * (by_mass_ + mass_ * phi).cwiseQuotient(squares_), VectorXd::Zero(phi.size())};
  }
  VectorXd acceleration(double t, const At& at) const {
    const DriverState heel = driver_at(heel_, t), s = driver_at(along_, t);
    const VectorXd phi = shape_at(s.value, 0), slope = shape_at(s.value, 1),
                   curve = shape_at(s.value, 2);
    const double borne =
        mass_ * (g + heel.acceleration + 2.0 * s.rate * slope.dot(at.speed) +
                 s.acceleration * slope.dot(at.q) + s.rate * s.rate * curve.dot(at.q));
    const MatrixXd moved =
        MatrixXd::Identity(phi.size(), phi.size()) + mass_ * phi * phi.transpose();
    return moved.ldlt().solve(-squares_.cwiseProduct(at.q) - (heel.acceleration + g) * by_mass_ -
                              borne * phi);
  }
  void step(double t, double h, At& at) const {
    const auto go = [&](double by, const VectorXd& v, const VectorXd& a) {
      return At{at.q + by * v, at.speed + by * a};
    };
    const VectorXd a = acceleration(t, at);
    const At two = go(0.5 * h, at.speed, a);
    const VectorXd b = acceleration(t + 0.5 * h, two);
    const At three = go(0.5 * h, two.speed, b);
    const VectorXd c = acceleration(t + 0.5 * h, three);
    const At four = go(h, three.speed, c);
    const VectorXd d = acceleration(t + h, four);
    at.q += h / 6.0 * (at.speed + 2.0 * two.speed + 2.0 * three.speed + four.speed);
    at.speed += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
  }
  /// What bends the arm at its heel, by the sum of the modes' strains.
  double heel_moment(const At& at) const {
    const VectorXd y = shapes_ * at.q;
    const auto element = test::space_elements::element(section_, h_, density_);
    return -(element.K * y.head<12>())[4];
  }
  void of(const Section& section, double density) {
    section_ = section;
    density_ = density;
  }

 private:
  /// Of every mode the shift in z at a place, its slope or its curvature, by the cubic of a node's
  /// neighbours.
  VectorXd shape_at(double s, int derivative) const {
    const auto element = std::min<Index>(59, static_cast<Index>(s / h_));
    const double u = s / h_ - static_cast<double>(element);
    Eigen::Vector4d of;
    switch (derivative) {
      case 0:
        of << 1 - 3 * u * u + 2 * u * u * u, h_ * (u - 2 * u * u + u * u * u),
            3 * u * u - 2 * u * u * u, h_ * (u * u * u - u * u);
        break;
      case 1:
        of << (-6 * u + 6 * u * u) / h_, 1 - 4 * u + 3 * u * u, (6 * u - 6 * u * u) / h_,
            3 * u * u - 2 * u;
        break;
      default:
        of << (-6 + 12 * u) / (h_ * h_), (-4 + 6 * u) / h_, (6 - 12 * u) / (h_ * h_),
            (6 * u - 2) / h_;
    }
    // w' = -theta_y.
    return (of[0] * shapes_.row(6 * element + 2) - of[1] * shapes_.row(6 * element + 4) +
            of[2] * shapes_.row(6 * element + 8) - of[3] * shapes_.row(6 * element + 10))
        .transpose();
  }

  double mass_;
  Driver heel_, along_;
  test::space_elements::Assembled whole_;
  MatrixXd shapes_;
  VectorXd squares_, by_mass_, up_;
  double h_ = 0.0, density_ = 0.0;
  Section section_;
};

}  // namespace

// What moves with the mass is left out in the modes of each posture: (s'/(L w_1))^2.
TEST_CASE("a trolley runs along an arm that vibrates", "[elastic_by_forces]") {
  constexpr double mass = 60.0, duration = 1.2;
  const auto step = [](double from, double to, double end, const char* unit) {
    return fmt::format(
        "kind = \"smooth step\"\nfrom = \"{0:.15g} {3}\"\nto = \"{1:.15g} "
        "{3}\"\nend = \"{2:.15g} s\"\n",
        from, to, end, unit);
  };
  for (const double end : {2.4, 1.0}) {
    const std::string text =
        arm("[bodies.trolley]\nmass = \"60 kg\"\npoints = { c = [\"0 m\", \"0 m\", \"0 m\"] }\n"
            "[joints.fall]\nkind = \"prismatic\"\nconnect = [\"ground\", \"arm.heel\"]\nat = "
            "[\"0 m\", \"0 m\", \"0 m\"]\naxis = \"z\"\n[joints.run]\nkind = "
            "\"prismatic\"\nconnect = [\"arm.heel\", \"trolley.c\"]\naxis = \"x\"\n"
            "[drivers.fall]\njoint = \"fall\"\n" +
                step(0.0, 0.02, 0.15, "m") + "[drivers.run]\njoint = \"run\"\n" +
                step(1.0, 3.7, end, "m") +
                fmt::format("[motion]\nduration = \"{:.15g} s\"\n", duration),
            "density = \"7850 kg/m^3\"\n", "", g);
    const Moved moved(text);
    const ElasticMotionInSpace elastic = moved.by(4, 16);
    const std::vector<spatial::Joint>& joints = moved.chain().mechanism().joints;
    const auto driver_of = [&](const char* name) {
      return std::find_if(joints.begin(), joints.end(),
                          [&](const spatial::Joint& of) { return of.name == name; })
          ->driver;
    };
    Trolley trolley(moved.project.beam, mass, driver_of("fall"), driver_of("run"));
    trolley.of(moved.project.beam.segments[0].from, moved.project.beam.density.value());
    Trolley::At at = trolley.resting();
    double largest = 0.0, apart = 0.0, rigidly = 0.0, fastest = 0.0;
    constexpr int steps = 24000;
    for (int i = 0; i < steps; ++i) {
      const double t = duration * i / steps;
      if (i % 60 == 0) {
        const BeamLoads loads = elastic.loads_at(si<Time>(t));
        const double expected = trolley.heel_moment(at), found = cuts_of(loads, 0.0)[4];
        largest = std::max(largest, std::abs(expected));
        apart = std::max(apart, std::abs(found - expected));
        rigidly = std::max(
            rigidly, std::abs(cuts_of(moved.rigid().loads_at(si<Time>(t)), 0.0)[4] - expected));
        fastest = std::max(fastest, std::abs(driver_at(driver_of("run"), t).rate));
        CHECK(imbalance(loads, 4.0) < 1e-9);
      }
      trolley.step(t, duration / steps, at);
    }
    const double passing = fastest / (4.0 * 2.0 * std::numbers::pi * elastic.lowest_frequency());
    INFO("within " << end << " s: largest " << largest << ", apart " << apart
                   << ", of rigid bodies " << rigidly << ", passing " << passing);
    CHECK(apart < (5e-3 + passing * passing) * largest);
    CHECK(rigidly > 0.2 * largest);
  }
}

}  // namespace trolley_on_arm_test
