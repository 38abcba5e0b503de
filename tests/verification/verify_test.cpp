// Properties of the whole verification on the rig: what must hold whatever the numbers are.

#include "boxbeam/verification/verify.hpp"

#include <cmath>

#include "catch.hpp"
#include "support/rig.hpp"

using namespace boxbeam;

namespace {

const Verification& rig() {
  static const Verification verification = verify(test::rig());
  return verification;
}

const StationEnvelope& envelope_at(const Verification& verification, const std::string& station) {
  for (const StationEnvelope& envelope : verification.stations) {
    if (to_text(envelope.station) == station) return envelope;
  }
  throw std::runtime_error("no station " + station);
}

/// The rig with every load twice as large: twice the density and all masses.
Project doubled() {
  Project project = test::rig();
  project.beam.density = 2.0 * project.beam.density;
  for (Body& body : project.mechanism.bodies) {
    body.mass *= 2.0;
    body.inertia *= 2.0;
  }
  return project;
}

}  // namespace

TEST_CASE("twice the loads halve every yield factor and, below the cut-off, every fatigue factor") {
  const Project heavy = doubled();
  const Verification twice = verify(heavy);
  REQUIRE(twice.checks.size() == rig().checks.size());
  for (std::size_t i = 0; i < twice.checks.size(); ++i) {
    const Check& a = twice.checks[i].check;
    for (const CheckResult& other : rig().checks) {
      if (other.check.id != a.id) continue;
      CHECK(a.safety_factor == Approx(0.5 * other.check.safety_factor).epsilon(1e-9));
    }
  }
}

TEST_CASE("the checks stand worst first and the verdict follows from them") {
  double before = 1e300;
  bool all_pass = true;
  for (const CheckResult& result : rig().checks) {
    CHECK(result.check.utilisation() <= before);
    before = result.check.utilisation();
    all_pass = all_pass && result.check.passes();
    CHECK(result.check.safety_factor ==
          Approx(result.check.resisting / result.check.acting).epsilon(1e-12));
  }
  CHECK((rig().verdict == Verdict::pass) == all_pass);
  Project tolerant = test::rig();
  tolerant.fatigue.required = 1.0;
  CHECK(verify(tolerant).verdict == Verdict::pass);
}

TEST_CASE("the jump of N and V at a joint is the force of the joint there") {
  for (const auto& [name, before, behind] :
       {std::tuple("C", "0-", "0+"), std::tuple("O", "3.2-", "3.2+"), std::tuple("B", "6.2-", "6.2+")}) {
    for (const BeamLoadRow& row : rig().loads) {
      if (row.name != name) continue;
      for (const CutForceLine& line : rig().lines) {
        if (line.time != row.time) continue;
        CutForces left{}, right{};
        for (std::size_t i = 0; i < line.stations.size(); ++i) {
          if (to_text(line.stations[i]) == before) left = line.values[i];
          if (to_text(line.stations[i]) == behind) right = line.values[i];
        }
        CHECK((left.N - right.N).value() == Approx(row.force.x()).margin(1e-6));
        CHECK((left.V_z - right.V_z).value() == Approx(row.force.z()).margin(1e-6));
        CHECK((left.M_y - right.M_y).value() == Approx(row.couple).margin(1e-6));
      }
    }
  }
}

TEST_CASE("nothing is cut outside the beam, and the free ends carry no moment") {
  for (const char* station : {"0-", "6.2+"}) {
    CHECK(envelope_at(rig(), station).N.largest.value == 0.0);
    CHECK(envelope_at(rig(), station).M.largest.value == 0.0);
  }
  CHECK(std::abs(envelope_at(rig(), "6.2-").M.largest.value) < 1e-6);
  CHECK(std::abs(envelope_at(rig(), "0+").M.smallest.value) < 1e-6);
}

TEST_CASE("a maximum inside a tapered segment is found") {
  // In S2 the bending moment grows linearly and the section modulus faster than linearly: the
  // stress range peaks inside. The maximum found beats both its neighbours 10 mm away.
  const Project& project = test::rig();
  double found = 0.0;
  double range = 0.0;
  for (const CheckResult& result : rig().checks) {
    const Check& check = result.check;
    const double s = check.station.s.value();
    if (check.criterion == Criterion::fatigue && s > 1.6 && s < 2.3 && check.acting.value() > range) {
      found = s;
      range = check.acting.value();
    }
  }
  REQUIRE(found > 0.0);
  for (const double offset : {-0.01, 0.01}) {
    Project marked = project;
    marked.points.push_back({"beside", si<Length>(found + offset), 0.0 * metre});
    const Verification with_point = verify(marked);
    for (const CheckResult& result : with_point.checks) {
      if (std::abs(result.check.station.s.value() - found - offset) > 1e-9) continue;
      if (result.check.criterion == Criterion::fatigue) CHECK(result.check.acting.value() < range);
    }
  }
}

TEST_CASE("the mechanism seen in a mirror gives the same factors on the other fibre") {
  // World x and all angles reflected: +z and -z of the beam change places.
  Project mirror = test::rig();
  planar::Mechanism& mechanism = mirror.mechanism;
  const auto flip = [](Eigen::Vector2d& v) { v.x() = -v.x(); };
  for (planar::Joint& joint : mechanism.joints) {
    if (auto* slider = std::get_if<planar::Slider>(&joint.kind)) flip(slider->through);
    if (auto* driven = std::get_if<planar::Driven>(&joint.kind)) {
      driven->driver.mean = -driven->driver.mean;
      driven->driver.amplitude = -driven->driver.amplitude;
    }
  }
  for (planar::Loop& loop : mechanism.loops) loop.sign = -loop.sign;
  for (Body& body : mechanism.bodies) {
    flip(body.sketch.centre);
    // A rod along x turns its local axis round, the upright beam keeps it.
    body.sketch.angle = 3.14159265358979323846 - body.sketch.angle;
  }
  // Blade and sledge keep angle 0 by their sliders.
  mechanism.bodies[2].sketch.angle = 0.0;
  mechanism.bodies[4].sketch.angle = 0.0;
  const Verification reflected = verify(mirror);
  const auto factor = [](const Verification& v, const std::string& id) {
    for (const CheckResult& result : v.checks) {
      if (result.check.id == id) return result.check.safety_factor;
    }
    return 0.0;
  };
  CHECK(factor(reflected, "fatigue/4.2/fibre-z") == Approx(factor(rig(), "fatigue/4.2/fibre+z")).epsilon(1e-9));
  CHECK(factor(reflected, "yield/5.2+/fibre+z") == Approx(factor(rig(), "yield/5.2+/fibre-z")).epsilon(1e-9));
}

TEST_CASE("the governing instants are half a period apart and at full stroke") {
  const CheckResult& fatigue = *rig().governing(Criterion::fatigue);
  const double period = 1.0 / 0.7;
  CHECK(fatigue.basis->lowest.time.value() == Approx(0.25 * period).margin(1e-6));
  CHECK(fatigue.basis->highest.time.value() == Approx(0.75 * period).margin(1e-6));
}

TEST_CASE("rotary inertia of the sections changes the governing range by a tenth of a percent") {
  // By an independent calculation: 31.66 -> 31.70 MPa.
  Project with = test::rig();
  with.beam.rotary_inertia = true;
  const MassProperties properties = mass_properties_of(with.beam);
  with.mechanism.bodies[static_cast<std::size_t>(with.beam_body)].inertia = properties.inertia.value();
  const Verification verification = verify(with);
  CHECK(verification.imbalance < 1e-12);
  CHECK(verification.governing(Criterion::fatigue)->check.acting.value() == Approx(31.69566e6).epsilon(1e-6));
}

TEST_CASE("the chain yields its loads on the rig's beam as well") {
  Project chain = test::rig();
  chain.dynamics = Dynamics::newton_chain;
  const Verification verification = verify(chain);
  CHECK(verification.chain->chain_mass == Approx(18627.0).epsilon(5e-3));
  CHECK(verification.imbalance < 1e-12);
}
