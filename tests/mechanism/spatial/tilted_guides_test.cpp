// Slides that are pushed, or have their mass, beside their guide: they tilt, rub more, and jam.

#include <cmath>
#include <string>

#include "boxbeam/core/error.hpp"
#include "catch.hpp"
#include "mechanism/spatial/rubbing.hpp"
#include "support/spatial_balance.hpp"

namespace tilted_guides_test {

using namespace boxbeam;
using namespace boxbeam::spatial;
using namespace rubbing;
using Eigen::Vector3d;
using test::set_mass;

namespace {

/// A slide along x without weight, on a guide of 0.3 m, that a rod parallel to it, beside it by 0.2
/// m, pushes slowly against a force of 100 N through the guide.
Mechanism pushed_beside(double mu) {
  Mechanism mechanism;
  add(mechanism, "slide", JointKind::prismatic, ground, Vector3d::Zero(), Vector3d::UnitX(),
      MovedBy::loops);
  mechanism.joints[0].friction = {mu, 0.0, 1e-9, 0.3};
  const Vector3d beside(0.0, 0.12, 0.16);
  ClosingJoint rod;
  rod.name = "rod";
  rod.kind = ClosingKind::distance;
  rod.a = {ground, beside - 2.0 * Vector3d::UnitX()};
  rod.b = {0, beside};
  rod.length = PolynomialDriver{{2.0, 0.1}};
  rod.driver_name = "push";
  mechanism.closing = {rod};
  mechanism.loads = {{"load",
                      LoadKind::force,
                      0,
                      {0, {0.05, 0.0, 0.0}},
                      ground,
                      -Vector3d::UnitX(),
                      PolynomialDriver{{100.0}}}};
  mechanism.duration.length = 1.0;
  return mechanism;
}

}  // namespace

TEST_CASE("a slide pushed beside its guide needs F/(1 - 2 mu e/l), and jams at mu = l/(2 e)") {
  // By hand: the rod's couple R e is taken by R e/l at both ends, whose friction is mu 2 R e/l.
  const double jams = 0.3 / (2.0 * 0.2);
  for (const double mu : {0.1, 0.5, 0.99 * jams}) {
    const Mechanism mechanism = pushed_beside(mu);
    const Chain chain(mechanism);
    const State state = chain.at(0.4);
    const double R = 100.0 / (1.0 - mu / jams);
    CHECK(chain.joint_wrenches(state)[1].force.x() == Approx(R).epsilon(1e-10));
    CHECK(state.friction[0] == Approx(100.0 - R).epsilon(1e-9));
    test::check_balance(chain, 0.4);
  }
  const Mechanism locked = pushed_beside(1.01 * jams);
  const Chain chain(locked);
  try {
    static_cast<void>(chain.at(0.4));
    FAIL("must be refused");
  } catch (const AnalysisError& error) {
    CHECK(error.failure().where == "joint slide");
    CHECK(error.failure().what.find("locks") != std::string::npos);
    CHECK(error.failure().time == 0.4);
  }
}

TEST_CASE("a slide that a force beside its guide moves stands still from mu = l/(2 e) on") {
  // By hand: m a = F - mu 2 F e/l.
  const double jams = 0.3 / (2.0 * 0.2), F = 40.0, m = 2.0;
  for (const double mu : {0.5 * jams, 1.5 * jams}) {
    CAPTURE(mu);
    Mechanism mechanism = pushed_beside(mu);
    mechanism.closing.clear();
    mechanism.joints[0].moved_by = MovedBy::forces;
    mechanism.joints[0].friction.creep = 1e-3;
    set_mass(mechanism.bodies[0], m, Vector3d::Zero(), {0.0, 0.0, 0.0});
    mechanism.loads = {{"load",
                        LoadKind::force,
                        0,
                        {0, {0.0, 0.12, 0.16}},
                        ground,
                        Vector3d::UnitX(),
                        PolynomialDriver{{F}}}};
    mechanism.duration.length = 0.4;
    const Chain chain(mechanism);
    const State state = chain.at(0.4);
    if (mu < jams) {
      CHECK(state.coordinates[0].acceleration == Approx(F / m * (1.0 - mu / jams)).epsilon(1e-5));
    } else {
      // The share jams/mu of the friction holds it.
      CHECK(state.coordinates[0].rate == Approx(1e-3 / std::sqrt(1.5 * 1.5 - 1.0)).epsilon(1e-7));
    }
  }
}

TEST_CASE("a slide with its mass beside its guide brakes itself, and locks at mu = l/(2 e)") {
  // By hand: braked by F along the guide, m |a| e tilts it, and m |a| = F + mu 2 m |a| e/l.
  // Pushed ahead as fast, m a = F - mu 2 m a e/l. No acceleration is enough from mu = l/(2 e) on.
  const double jams = 0.3 / (2.0 * 0.2), F = 40.0, m = 2.0;
  const auto sliding = [&](double mu, double sense) {
    Mechanism mechanism = pushed_beside(mu);
    mechanism.closing.clear();
    mechanism.joints[0].moved_by = MovedBy::forces;
    mechanism.joints[0].start_rate = 1.0;
    set_mass(mechanism.bodies[0], m, {0.0, 0.12, 0.16}, {0.0, 0.0, 0.0});
    mechanism.loads[0].direction = sense * Vector3d::UnitX();
    mechanism.loads[0].size = PolynomialDriver{{F}};
    mechanism.duration.length = 0.01;
    return mechanism;
  };
  for (const double mu : {0.3 * jams, 0.9 * jams}) {
    const Mechanism braked = sliding(mu, -1.0), pushed = sliding(mu, 1.0);
    CHECK(Chain(braked).at(0.0).coordinates[0].acceleration ==
          Approx(-F / m / (1.0 - mu / jams)).epsilon(1e-9));
    CHECK(Chain(pushed).at(0.0).coordinates[0].acceleration ==
          Approx(F / m / (1.0 + mu / jams)).epsilon(1e-9));
    test::check_balance(Chain(braked), 0.001);
  }
  const Mechanism locked = sliding(1.2 * jams, -1.0);
  try {
    const Chain chain(locked);
    FAIL("must be refused");
  } catch (const AnalysisError& error) {
    CHECK(error.failure().where == "joint slide");
    CHECK(error.failure().what.find("locks") != std::string::npos);
  }
}

}  // namespace tilted_guides_test
