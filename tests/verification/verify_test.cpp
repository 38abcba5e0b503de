// Properties of the whole verification on the rig: what must hold whatever the numbers are.

#include "boxbeam/verification/verify.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <type_traits>
#include <utility>

#include "boxbeam/core/error.hpp"
#include "boxbeam/numerics/nine_digits.hpp"
#include "boxbeam/report/result_book.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "support/rig.hpp"

namespace verify_test {

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

/// The rig with every load twice as large: twice the density and all masses, and twice as stiff, so
/// that its natural frequencies and with them the model of its beam stay.
Project doubled() {
  Project project = test::rig();
  project.beam.density = 2.0 * project.beam.density;
  project.model.youngs_modulus *= 2.0;
  project.model.shear_modulus *= 2.0;
  for (Body& body : planar_of(project).bodies) {
    body.mass *= 2.0;
    body.inertia *= 2.0;
  }
  return project;
}

}  // namespace

TEST_CASE("twice the loads halve every yield factor and, below the cut-off, every fatigue factor") {
  const Project heavy = doubled();
  const Verification twice = verify(heavy);
  // What presses stout webs is listed from three tenths of what they bear on, and while they do.
  const auto listed = [](const Verification& of) {
    return std::count_if(of.checks.begin(), of.checks.end(), [](const CheckResult& result) {
      return !result.patch && !result.pressed;
    });
  };
  REQUIRE(listed(twice) == listed(rig()));
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
    // Of those that are alike but for round-off the first along the beam.
    const double use = nine_digits(result.check.utilisation());
    CHECK(use <= before);
    before = use;
    all_pass = all_pass && result.check.passes();
    // Two curves have no range in common: the amounts are the damage and 1, and no load factor.
    if (result.check.criterion == Criterion::combined_fatigue) {
      CHECK((result.check.acting.value() > 1.0) == (result.check.safety_factor < 1.0));
      continue;
    }
    CHECK(result.check.safety_factor ==
          Approx(result.check.resisting / result.check.acting).epsilon(1e-12));
  }
  CHECK((rig().verdict == Verdict::pass) == all_pass);
  Project tolerant = test::rig();
  tolerant.fatigue.required = 1.0;
  CHECK(verify(tolerant).verdict == Verdict::pass);
}

TEST_CASE("nine digits are the nearest, in order, and without round-off") {
  for (const double of : {1.0, 0.85127825, -3.3e-7, 4.2e11}) {
    CHECK(std::abs(nine_digits(of) - of) <= std::ldexp(1.0, -30) * std::abs(of));
    CHECK(nine_digits(2.0 * of) == 2.0 * nine_digits(of));
    CHECK(nine_digits(nine_digits(of)) == nine_digits(of));
    CHECK(nine_digits(nine_digits(of) * (1.0 + 1e-14)) == nine_digits(of));
    CHECK(nine_digits(of + 1e-8 * std::abs(of)) > nine_digits(of));
  }
  CHECK(nine_digits(0.0) == 0.0);
  const double unbounded = std::numeric_limits<double>::infinity();
  CHECK(nine_digits(unbounded) == unbounded);
}

TEST_CASE("which of two points that are used alike stands first does not hang on round-off") {
  const auto ids_of = [](const std::string& amplitude) {
    std::string text = test::read_file(test::project_file("sections/drill-truck/truck.toml"));
    const std::string written = "amplitude_force = [\"4 kN\"";
    const std::size_t at = text.find(written);
    REQUIRE(at != std::string::npos);
    text.replace(at, written.size(), "amplitude_force = [\"" + amplitude + "\"");
    const Verification verification = verify(parse_project("truck.toml", text));
    std::vector<std::string> ids;
    for (const CheckResult& result : verification.checks) ids.push_back(result.check.id);
    return ids;
  };
  const std::vector<std::string> ids = ids_of("4 kN");
  for (const std::string amplitude :
       {"4.0000000000000009 kN", "4.000000000000003 kN", "3.999999999999998 kN"})
    CHECK(ids_of(amplitude) == ids);
}

TEST_CASE("the jump of N and V at a joint is the force of the joint there") {
  for (const auto& [name, before, behind] :
       {std::tuple("C", "0-", "0+"), std::tuple("O", "3.2-", "3.2+"),
        std::tuple("B", "6.2-", "6.2+")}) {
    for (const BeamLoadRow& row : rig().pictures.loads) {
      if (row.name != name) continue;
      for (const CutForceLine& line : rig().pictures.lines) {
        if (line.time != row.time) continue;
        CutForces left{}, right{};
        for (std::size_t i = 0; i < line.stations.size(); ++i) {
          if (to_text(line.stations[i]) == before) left = line.values[i];
          if (to_text(line.stations[i]) == behind) right = line.values[i];
        }
        CHECK((left.N - right.N).value() == Approx(row.force.x()).margin(1e-6));
        CHECK((left.V_z - right.V_z).value() == Approx(row.force.z()).margin(1e-6));
        CHECK((left.M_y - right.M_y).value() == Approx(row.moment.y()).margin(1e-6));
      }
    }
  }
}

TEST_CASE("nothing is cut outside the beam, and the free ends carry no moment") {
  for (const char* station : {"0-", "6.2+"}) {
    CHECK(envelope_at(rig(), station).of[cut_force::N].largest.value == 0.0);
    CHECK(envelope_at(rig(), station).of[cut_force::M_y].largest.value == 0.0);
  }
  CHECK(std::abs(envelope_at(rig(), "6.2-").of[cut_force::M_y].largest.value) < 1e-6);
  CHECK(std::abs(envelope_at(rig(), "0+").of[cut_force::M_y].smallest.value) < 1e-6);
}

TEST_CASE("a maximum inside a tapered segment is found") {
  // In S2 the bending moment grows linearly and the section modulus faster than linearly: the
  // stress range peaks inside. A weak detail makes it govern. The maximum found beats both its
  // neighbours 10 mm away.
  Project project = test::rig();
  BeamDetail weak = project.fatigue.beam;
  weak.from = si<Length>(1.6);
  weak.to = si<Length>(2.3);
  weak.detail.curve = en_1993_1_9_direct(36);
  project.fatigue.details.push_back(weak);
  const Verification verification = verify(project);
  const CheckResult* const governing = verification.governing(Criterion::fatigue);
  REQUIRE(governing != nullptr);
  const double found = governing->check.station.s.value();
  const double range = governing->check.acting.value();
  REQUIRE(found > 1.62);
  REQUIRE(found < 2.28);
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
  planar::Mechanism& mechanism = planar_of(mirror);
  const auto flip = [](Eigen::Vector2d& v) { v.x() = -v.x(); };
  for (planar::Joint& joint : mechanism.joints) {
    if (auto* slider = std::get_if<planar::Slider>(&joint.kind)) flip(slider->guide.p);
    if (auto* driven = std::get_if<planar::Driven>(&joint.kind)) {
      auto& driver = std::get<HarmonicDriver>(driven->driver);
      driver.mean = -driver.mean;
      driver.amplitude = -driver.amplitude;
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
  CHECK(factor(reflected, "fatigue/4.2-/fibre-z") ==
        Approx(factor(rig(), "fatigue/4.2-/fibre+z")).epsilon(1e-9));
  CHECK(factor(reflected, "yield/5.2+/fibre+z") ==
        Approx(factor(rig(), "yield/5.2+/fibre-z")).epsilon(1e-9));
}

TEST_CASE("the governing instants are half a period apart and at full stroke") {
  const CheckResult& fatigue = *rig().governing(Criterion::fatigue);
  const double period = 1.0 / 0.7;
  CHECK(fatigue.basis->lowest.time.value() == Approx(0.25 * period).margin(1e-6));
  CHECK(fatigue.basis->highest.time.value() == Approx(0.75 * period).margin(1e-6));
}

TEST_CASE("rotary inertia of the sections changes the governing range by a tenth of a percent") {
  // By an independent calculation: 31.66 -> 31.70 MPa, flanges in full.
  Project with = test::rig();
  with.beam.rotary_inertia = true;
  with.strength.shear_lag = false;
  const MassProperties properties = mass_properties_of(with.beam);
  planar_of(with).bodies[static_cast<std::size_t>(with.beam_body)].inertia =
      properties.inertia.value();
  const Verification verification = verify(with);
  CHECK(verification.motions.front().imbalance < 1e-12);
  CHECK(verification.governing(Criterion::fatigue)->check.acting.value() ==
        Approx(31.69566e6).epsilon(1e-6));
}

TEST_CASE("the chain yields its loads on the rig's beam as well") {
  Project chain = test::rig();
  chain.dynamics = Dynamics::newton_chain;
  const Verification verification = verify(chain);
  CHECK(verification.chain->chain_mass.value() == Approx(18627.0).epsilon(5e-3));
  CHECK(verification.motions.front().imbalance < 1e-12);
}

namespace {

BeamDetail detail(const std::string& name, double category, double from, double to) {
  BeamDetail on_beam;
  on_beam.from = si<Length>(from);
  on_beam.to = si<Length>(to);
  on_beam.detail.name = name;
  on_beam.detail.curve = en_1993_1_9_direct(category);
  return on_beam;
}

}  // namespace

TEST_CASE("a weak detail anywhere on the beam changes the verdict") {
  // Category 36 at a place where nothing else stands: it must be checked there.
  Project project = test::rig();
  project.fatigue.required = 1.0;
  REQUIRE(verify(project).verdict == Verdict::pass);
  project.fatigue.details.push_back(detail("bracket", 36, 3.9, 3.9));
  const Verification with_bracket = verify(project);
  CHECK(with_bracket.verdict == Verdict::fail);
  CHECK(with_bracket.governing(Criterion::fatigue)->check.station.s.value() == Approx(3.9));
}

TEST_CASE("of overlapping details the weakest counts, whatever their order") {
  for (const bool weak_first : {true, false}) {
    Project project = test::rig();
    const BeamDetail weak = detail("weak", 36, 5.0, 5.2);
    auto& details = project.fatigue.details;
    details.insert(weak_first ? details.begin() : details.end(), weak);
    const Verification verification = verify(project);
    // Category 36 over 100, on the 26.23 MPa of the tube at 5.2 m: 14.57/26.23 = 0.5555.
    CHECK(verification.governing(Criterion::fatigue)->check.safety_factor ==
          Approx(0.5555).epsilon(1e-3));
  }
}

TEST_CASE("a web hole under shear is seen: four times the nominal shear at 45 degrees") {
  // At s = 0.3 m there is little bending: V = 96.9 to 97.8 kN, V S/(I b) = 2.05 to 2.07 MPa, range
  // 4.12 MPa; around a hole of 145 mm in 500 mm at least four times that (Kirsch).
  Project project = test::rig();
  add_hole(project, {0.3 * metre,
                     {"port", 0.145 * metre, HoleWalls::webs, Length{}},
                     HoleCase::in_plane_bending,
                     {}});
  const Verification verification = verify(project);
  double range = 0.0;
  double beside = 0.0;
  for (const CheckResult& result : verification.checks) {
    if (result.check.id == "fatigue/0.3/hole-port-edge") range = result.check.acting.value();
    if (result.check.point == "beside hole port +z") beside = result.check.acting.value();
  }
  CHECK(range > 4.0 * 4.1e6);
  CHECK(range < 4.0 * 4.2e6 / (1.0 - 0.145 / 0.5) * 1.1);
  CHECK(beside > std::sqrt(3.0) * 2.0e6);
}

TEST_CASE("a beam that nothing loads is no verified beam") {
  Project project = test::rig();
  planar_of(project).gravity.setZero();
  for (Body& body : planar_of(project).bodies) body.mass = body.inertia = 0.0;
  project.beam.density = si<Density>(1e-9);
  CHECK_THROWS_AS(verify(project), AnalysisError);
}

TEST_CASE("a plate too slender for elastic stresses makes the verdict not applicable") {
  // Flanges of 5 mm on the lower segment: 300/5 = 60 > 34.2; the required factors do not fail.
  const Project project =
      read_project(test::project_file("sections/sledge-rig/rig.toml"),
                   {"sections.A2.flange=5 mm", "sections.A2.web=5 mm", "sections.A1.flange=5 mm",
                    "sections.A1.web=5 mm", "sections.tube.wall=20 mm", "strength.required=0.001",
                    "fatigue.required=0.001"});
  const Verification verification = verify(project);
  CHECK(verification.verdict == Verdict::not_applicable);
  CHECK(std::any_of(verification.gates.begin(), verification.gates.end(),
                    [](const Gate& gate) { return gate.blocks && gate.plate == "flange"; }));
}

TEST_CASE("every check has an id of its own") {
  std::set<std::string> ids;
  for (const CheckResult& result : rig().checks) ids.insert(result.check.id);
  CHECK(ids.size() == rig().checks.size());
}

TEST_CASE("numbers that are asked for are those of the whole results") {
  std::vector<Project> project{test::rig()};
  const std::vector<VerifiedBeam> beams = verify_beams(std::move(project));
  const ResultBook whole = results_of(beams);
  for (const char* key :
       {"governing.fatigue.safety_factor", "fatigue.safety_factor", "yield.acting", "beam.mass",
        "mass", "beam.stations[3.2-].M.max", "checks[0].utilisation", "model.frequencies[0]",
        "critical_instants[0].value", "search.evaluations"}) {
    const ResultBook few = results_of(beams, {key});
    const ResultValue* const value = whole.find(key);
    CAPTURE(key);
    if (value == nullptr) {
      CHECK(few.find(key) == nullptr);
      continue;
    }
    REQUIRE(few.find(key) != nullptr);
    CHECK(few.find(key)->key == value->key);
    CHECK(few.find(key)->unit == value->unit);
    CHECK(few.find(key)->value == value->value);
  }
  CHECK(results_of(beams, {"beam.mass"}).find("beam.mass") != nullptr);
  CHECK(results_of(beams, {"beam.mass"}).find("checks[0].utilisation") == nullptr);
  CHECK(results_of(beams, {"nothing"}).find("nothing") == nullptr);
}

TEST_CASE("what a check rests on is copied with it, and moved with it") {
  static_assert(std::is_nothrow_move_constructible_v<CheckResult>);
  CheckResult one;
  one.basis.emplace().damage = 0.5;
  CheckResult other = one;
  other.basis->damage = 0.25;
  CHECK(one.basis->damage == 0.5);
  const CheckBasis* const where = &*one.basis;
  const CheckResult moved = std::move(one);
  CHECK(&*moved.basis == where);
  other = moved;
  CHECK(other.basis->damage == 0.5);
  CHECK(&*other.basis != where);
}

}  // namespace verify_test
