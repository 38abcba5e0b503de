#include "boxbeam/mechanism/flexible/structure.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "catch.hpp"
#include "support/elastic_beams.hpp"

namespace structure_test {

using namespace boxbeam;
using namespace boxbeam::flexible;
using test::Bar;
using test::Chance;

namespace {

constexpr Element both[] = {Element::classical, Element::corrected};

/// Integral of a smooth function: Gauss's rule with 30 points.
template <class Function>
double integral(const Function& f, double from, double to) {
  return boost::math::quadrature::gauss<double, 30>::integrate(f, from, to);
}

const LinkStretch& stretch_at(const Link& link, double s) {
  for (const LinkStretch& stretch : link.stretches) {
    if (s < stretch.start + stretch.length) return stretch;
  }
  return link.stretches.back();
}

/// Integral of weight(s) times a property of a link, between two places.
template <class Property, class Weight>
double integral_of_link(const Link& link, Property property, Weight weight, double from,
                        double to) {
  double sum = 0.0;
  for (const LinkStretch& stretch : link.stretches) {
    const double a = std::max(from, stretch.start);
    const double b = std::min(to, stretch.start + stretch.length);
    if (b <= a) continue;
    sum +=
        integral([&](double s) { return weight(s) * property(stretch, s - stretch.start); }, a, b);
  }
  return sum;
}

struct Moments {
  double mass = 0.0, first = 0.0, second = 0.0;  ///< about the link's origin
};

Moments moments_of(const Link& link) {
  const auto mass = [](const LinkStretch& of, double x) { return of.mass(x); };
  const auto rotary = [](const LinkStretch& of, double x) { return of.rotary(x); };
  const auto power = [](int n) { return [n](double s) { return std::pow(s, n); }; };
  return {integral_of_link(link, mass, power(0), 0.0, link.length),
          integral_of_link(link, mass, power(1), 0.0, link.length),
          integral_of_link(link, mass, power(2), 0.0, link.length) +
              integral_of_link(link, rotary, power(0), 0.0, link.length)};
}

Moments moments_of(const DividedLink& divided) {
  Moments sum;
  for (const RigidElement& e : divided.elements) {
    const double S = e.first_moment.x();
    sum.mass += e.mass;
    sum.first += e.mass * e.node + S;
    sum.second += e.inertia + 2.0 * e.node * S + e.mass * e.node * e.node;
  }
  return sum;
}

Link random_elastic_link(Chance& chance) {
  Link link = test::random_link(chance);
  while (link.kind == LinkKind::rigid) link = test::random_link(chance);
  return link;
}

bool has_node(const DividedLink& divided, double s) {
  return std::any_of(divided.elements.begin(), divided.elements.end(),
                     [&](const RigidElement& e) { return std::abs(e.node - s) < 1e-12; });
}

}  // namespace

TEST_CASE("division keeps the mass and its static moment, tapers and stretches included") {
  Chance chance(61);
  for (int i = 0; i < 200; ++i) {
    const Link link = random_elastic_link(chance);
    const std::vector<double> nodes = {0.31 * link.length, 0.74 * link.length};
    const Moments exact = moments_of(link);
    for (const Element element : both) {
      for (const HeldEnds held : {HeldEnds{false, false}, HeldEnds{true, false},
                                  HeldEnds{false, true}, HeldEnds{true, true}}) {
        const Moments sum =
            moments_of(divide(link, i % 2 == 0 ? nodes : std::vector<double>{}, element, held));
        CAPTURE(i, static_cast<int>(element), held.start, held.end);
        CHECK(sum.mass == Approx(exact.mass).epsilon(1e-13));
        CHECK(sum.first == Approx(exact.first).epsilon(1e-12));
      }
    }
  }
}

TEST_CASE("classical elements keep the moment of inertia as well") {
  Chance chance(62);
  for (int i = 0; i < 50; ++i) {
    const Link link = random_elastic_link(chance);
    const double exact = moments_of(link).second;
    CHECK(moments_of(divide(link, {}, Element::classical)).second == Approx(exact).epsilon(1e-12));
  }
}

TEST_CASE("corrected elements keep it in a uniform link, but for what free ends need") {
  // Lumps keep mu D^3/3 of each part; a free end's mass mu D/2, D/6 inside, needs mu D^3/72 about
  // its node, where rho I D/2 is less.
  const double mu = 12.0, L = 2.0;
  for (const int n : {2, 5, 20}) {
    const double D = L / n;
    const Link link = test::link_of(Bar{L, 1.0, 1.0, 1.0, mu, 0.0}, n, LinkKind::bending);
    const double exact = mu * L * L * L / 3.0;
    const double end = mu * D * D * D / 72.0;
    CAPTURE(n);
    for (const HeldEnds held :
         {HeldEnds{false, false}, HeldEnds{true, false}, HeldEnds{true, true}}) {
      const double free = 2.0 - (held.start ? 1.0 : 0.0) - (held.end ? 1.0 : 0.0);
      CHECK(moments_of(divide(link, {}, Element::corrected, held)).second ==
            Approx(exact + free * end).epsilon(1e-13));
    }
    // A rod that does not bend turns as one.
    const Link rod = test::link_of(Bar{L, 1.0, 1.0, 1.0, mu, 0.0}, n, LinkKind::axial);
    CHECK(moments_of(divide(rod, {}, Element::corrected)).second == Approx(exact).epsilon(1e-13));
  }
  // Tapered and stepped ones to order two or better.
  Chance chance(69);
  for (int i = 0; i < 50; ++i) {
    Link link = random_elastic_link(chance);
    link.parts = 20;
    const double exact = moments_of(link).second;
    CHECK(moments_of(divide(link, {}, Element::corrected)).second == Approx(exact).epsilon(1e-3));
  }
}

TEST_CASE("no element that turns by itself has a mass that no body could have") {
  // Mass, static moment and inertia of a body with mass: J m >= S^2.
  Chance chance(63);
  for (int i = 0; i < 200; ++i) {
    const Link link = random_elastic_link(chance);
    if (link.kind == LinkKind::axial) continue;  // its elements turn as one
    for (const Element element : both) {
      for (const RigidElement& e : divide(link, {0.4 * link.length}, element).elements) {
        CAPTURE(i, static_cast<int>(element), e.node);
        CHECK(e.mass > 0.0);
        CHECK(e.inertia * e.mass >= e.first_moment.squaredNorm() * (1.0 - 1e-12));
      }
    }
  }
}

TEST_CASE("nodes where they must be, and at least as many parts as asked") {
  Chance chance(64);
  for (int i = 0; i < 200; ++i) {
    const Link link = random_elastic_link(chance);
    std::vector<double> nodes;
    for (int k = chance.one_of(5); k > 0; --k) {
      nodes.push_back(0.5 * link.length * (1.0 + chance.any()));
    }
    if (!nodes.empty()) nodes.push_back(nodes.front());  // twice the same
    if (i % 3 == 0) nodes.push_back(link.length);
    if (i % 3 == 1) nodes.push_back(link.stretches.back().start);
    for (const Element element : both) {
      const DividedLink divided = divide(link, nodes, element);
      CAPTURE(i);
      CHECK(static_cast<int>(divided.springs.size()) >= link.parts);
      REQUIRE(divided.elements.size() == divided.springs.size() + 1);
      for (const double s : nodes) CHECK(has_node(divided, s));
      CHECK(divided.elements.front().node == 0.0);
      CHECK(divided.elements.back().node == link.length);
      for (std::size_t k = 0; k < divided.springs.size(); ++k) {
        const SpringElement& spring = divided.springs[k];
        CHECK(spring.from == divided.elements[k].node);
        CHECK(spring.to == divided.elements[k + 1].node);
        CHECK(spring.to - spring.from > 0.0);
        CHECK(spring.place == Approx(0.5 * (spring.from + spring.to)).epsilon(1e-14));
      }
    }
  }
}

TEST_CASE("lumps at the border of two stretches have the mass of their own side") {
  // Borders that are the sum of lengths differ from nodes by round-off. Uniform stretches: S = mu
  // D^2/12 on either side, masses mu D/2.
  Chance chance(60);
  for (int i = 0; i < 200; ++i) {
    const double lengths[] = {0.7 + chance.any(0.3), 0.5 + chance.any(0.2)};
    Link link = test::link_of(Bar{lengths[0] + lengths[1]}, 2, LinkKind::bending);
    link.stretches.push_back(link.stretches[0]);
    link.stretches[0].length = lengths[0];
    link.stretches[1].start = lengths[0] * (1.0 + (i % 3 - 1) * 2e-16);
    link.stretches[1].length = lengths[1];
    link.stretches[1].mass.c[0] = 1000.0;
    const PartLumps before = lumps_of(link, 0.0, lengths[0]);
    const PartLumps after = lumps_of(link, lengths[0], link.length);
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      CHECK(before.mass[end] == Approx(lengths[0] / 2.0).epsilon(1e-12));
      CHECK(after.mass[end] == Approx(500.0 * lengths[1]).epsilon(1e-12));
    }
  }
}

TEST_CASE("nodes that nearly coincide make no part that nothing can be computed of") {
  const Link link = test::link_of(test::steel_bar(2.0, 0.1, 0.05), 4, LinkKind::full);
  for (const double gap : {1e-16, 1e-14, 1e-12}) {
    const DividedLink divided = divide(link, {0.7, 0.7 + gap, gap, 2.0 - gap}, Element::corrected);
    CAPTURE(gap);
    for (const SpringElement& spring : divided.springs) CHECK(spring.to - spring.from > 1e-9);
    CHECK(divided.springs.size() < 8);
  }
}

TEST_CASE("parts in proportion to their stretches") {
  const Bar bar{3.0};
  Link link = test::link_of(bar, 6, LinkKind::bending);
  const DividedLink divided = divide(link, {1.0}, Element::classical);
  REQUIRE(divided.springs.size() == 6);
  for (const SpringElement& spring : divided.springs) {
    CHECK(spring.to - spring.from == Approx(0.5).epsilon(1e-14));
  }
}

TEST_CASE("classical springs: D/EA, D/GA, D/EI with the values in the part's middle") {
  Chance chance(65);
  for (int i = 0; i < 100; ++i) {
    Link link = random_elastic_link(chance);
    link.kind = LinkKind::full;
    const DividedLink divided = divide(link, {0.37 * link.length}, Element::classical);
    for (const SpringElement& spring : divided.springs) {
      const double D = spring.to - spring.from;
      const LinkStretch& stretch = stretch_at(link, spring.place);
      const double x = spring.place - stretch.start;
      CHECK(spring.axial == Approx(D / stretch.EA(x)).epsilon(1e-12));
      CHECK(spring.bending(0, 0) == Approx(D / stretch.GA(x)).epsilon(1e-12));
      CHECK(spring.bending(1, 1) == Approx(D / stretch.EI(x)).epsilon(1e-12));
      CHECK(spring.bending(0, 1) == 0.0);
      CHECK(spring.bending(1, 0) == 0.0);
    }
  }
}

TEST_CASE("corrected springs: the flexibility of their part about its middle") {
  // A force V across and a couple C in the middle of a part bend it with C - x V, x from the
  // middle; virtual work gives shift and turn.
  Chance chance(66);
  for (int i = 0; i < 100; ++i) {
    Link link = random_elastic_link(chance);
    link.kind = LinkKind::full;
    // Gauss's rule with 7 points: parts in which the stiffness changes many times over have 5
    // digits, shorter ones all.
    if (i % 2 == 0) link.parts = 60;
    const double digits = i % 2 == 0 ? 1e-12 : 1e-5;
    const DividedLink divided = divide(link, {0.37 * link.length}, Element::corrected);
    for (const SpringElement& spring : divided.springs) {
      const auto of = [&](auto property, int power) {
        return integral_of_link(
            link, property, [&](double s) { return std::pow(s - spring.place, power); },
            spring.from, spring.to);
      };
      const auto axial = [](const LinkStretch& s, double x) { return 1.0 / s.EA(x); };
      const auto shear = [](const LinkStretch& s, double x) { return 1.0 / s.GA(x); };
      const auto turn = [](const LinkStretch& s, double x) { return 1.0 / s.EI(x); };
      const double D = spring.to - spring.from;
      CAPTURE(i, D / link.length);
      CHECK(spring.axial == Approx(of(axial, 0)).epsilon(digits));
      CHECK(spring.bending(0, 0) == Approx(of(shear, 0) + of(turn, 2)).epsilon(digits));
      CHECK(spring.bending(0, 1) == Approx(-of(turn, 1)).margin(digits * D * of(turn, 0)));
      CHECK(spring.bending(1, 0) == spring.bending(0, 1));
      CHECK(spring.bending(1, 1) == Approx(of(turn, 0)).epsilon(digits));
    }
  }
  // Uniform, by hand: D/EA, D/GA + D^3/(12 EI), D/EI.
  const Bar bar{1.2, 3e7, 2e6, 5e4};
  const DividedLink divided = divide(test::link_of(bar, 4, LinkKind::full), {}, Element::corrected);
  REQUIRE(divided.springs.size() == 4);
  const double D = 0.3;
  CHECK(divided.springs[1].axial == Approx(D / 3e7).epsilon(1e-14));
  CHECK(divided.springs[1].bending(0, 0) == Approx(D / 2e6 + D * D * D / 6e5).epsilon(1e-14));
  CHECK(divided.springs[1].bending(1, 1) == Approx(D / 5e4).epsilon(1e-14));
}

TEST_CASE("a kind of link is rigid where it does not deform") {
  const Bar bar{2.0, 3e7, 2e6, 5e4};
  for (const Element element : both) {
    for (const SpringElement& spring :
         divide(test::link_of(bar, 3, LinkKind::bending), {}, element).springs) {
      CHECK(spring.axial == 0.0);
      CHECK(spring.bending(1, 1) > 0.0);
    }
    for (const SpringElement& spring :
         divide(test::link_of(bar, 3, LinkKind::axial), {}, element).springs) {
      CHECK(spring.axial > 0.0);
      CHECK(spring.bending.norm() == 0.0);
    }
  }
}

TEST_CASE("masses of a uniform link, by hand") {
  const double mu = 12.0, rho_I = 0.3, D = 0.5;
  const Bar bar{2.0, 3e7, 2e6, 5e4, mu, rho_I};
  const Link link = test::link_of(bar, 4, LinkKind::full);
  // Classical: pieces D/2, D, D, D, D/2; a piece of length l about its own middle has mu l^3/12 +
  // rho I l, the end's middle is D/4 from its node.
  const DividedLink classical = divide(link, {}, Element::classical);
  CHECK(classical.elements[0].mass == Approx(mu * D / 2.0));
  CHECK(classical.elements[0].first_moment.x() == Approx(mu * D / 2.0 * D / 4.0));
  CHECK(classical.elements[0].inertia == Approx(mu * D * D * D / 24.0 + rho_I * D / 2.0));
  CHECK(classical.elements[4].first_moment.x() == Approx(-mu * D * D / 8.0));
  CHECK(classical.elements[2].mass == Approx(mu * D));
  CHECK(classical.elements[2].first_moment.x() == Approx(0.0).margin(1e-14));
  CHECK(classical.elements[2].inertia == Approx(mu * D * D * D / 12.0 + rho_I * D));
  // Corrected: mu D in the nodes, at the ends mu D/2, D/6 inside.
  const DividedLink corrected = divide(link, {}, Element::corrected);
  CHECK(corrected.elements[2].mass == Approx(mu * D));
  CHECK(corrected.elements[2].first_moment.x() == Approx(0.0).margin(1e-14));
  CHECK(corrected.elements[0].mass == Approx(mu * D / 2.0));
  CHECK(corrected.elements[0].first_moment.x() == Approx(mu * D * D / 12.0));
  CHECK(corrected.elements[4].first_moment.x() == Approx(-mu * D * D / 12.0));
}

TEST_CASE("a rigid link is one element with the mass that it has") {
  Link link;
  link.kind = LinkKind::rigid;
  link.length = 3.0;
  link.rigid = {9000.0, {0.3, 1.0}, 18000.0};
  for (const Element element : both) {
    const DividedLink divided = divide(link, {1.0, 2.0}, element);
    REQUIRE(divided.elements.size() == 1);
    CHECK(divided.springs.empty());
    const RigidElement& e = divided.elements[0];
    const Eigen::Vector2d centre = e.first_moment / e.mass + Eigen::Vector2d(e.node, 0.0);
    CHECK(e.mass == 9000.0);
    CHECK((centre - Eigen::Vector2d(0.3, 1.0)).norm() < 1e-14);
    CHECK(e.inertia - e.first_moment.squaredNorm() / e.mass == Approx(18000.0));
  }
}

TEST_CASE("joints and loads act in nodes, and grips carry an element's motion to the world") {
  Chance chance(67);
  for (int i = 0; i < 100; ++i) {
    test::RandomMechanism want;
    want.closed = true;
    want.element = i % 2 == 0 ? Element::classical : Element::corrected;
    const Mechanism mechanism = test::random_elastic(chance, want);
    const Structure structure = structure_of(mechanism);
    REQUIRE(structure.joints.size() == mechanism.joints.size());
    REQUIRE(structure.loads.size() == mechanism.loads.size());
    const auto check = [&](const Grip& grip, const Attachment& at) {
      CHECK(grip.link == at.link);
      if (at.link == ground) return;
      const auto k = static_cast<std::size_t>(at.link);
      const Link& link = mechanism.links[k];
      const double node = structure.links[k].elements.at(grip.element).node;
      if (link.kind != LinkKind::rigid) {
        CHECK(node == Approx(std::clamp(at.p.x(), 0.0, link.length)).margin(1e-12));
      }
      // A small motion of a rigid body: p + (u, w) + phi x (p - node).
      const Eigen::Vector3d q = chance.vector();
      const Eigen::Vector2d arm = at.p - Eigen::Vector2d(node, 0.0);
      const Eigen::Vector2d shift(q.x() - q.z() * arm.y(), q.y() + q.z() * arm.x());
      const Eigen::Vector2d world = Eigen::Rotation2Dd(link.angle) * shift;
      const Eigen::Vector3d expected(world.x(), world.y(), q.z());
      CHECK((grip.motion * q - expected).norm() < 1e-13);
    };
    for (std::size_t j = 0; j < mechanism.joints.size(); ++j) {
      check(structure.joints[j].a, mechanism.joints[j].a);
      check(structure.joints[j].b, mechanism.joints[j].b);
      const double c = std::cos(mechanism.joints[j].angle), s = std::sin(mechanism.joints[j].angle);
      Eigen::Matrix3d axes;
      axes << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
      CHECK((structure.joints[j].axes - axes).norm() < 1e-15);
    }
    for (std::size_t j = 0; j < mechanism.loads.size(); ++j) {
      check(structure.loads[j], mechanism.loads[j].at);
    }
    for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
      for (const LinkStretch& stretch : mechanism.links[k].stretches) {
        CHECK(has_node(structure.links[k], stretch.start));
      }
    }
    std::size_t elements = 0;
    for (const DividedLink& link : structure.links) elements += link.elements.size();
    CHECK(structure.elements() == elements);
  }
}

TEST_CASE("as in the source: equal parts, a joint takes the element that holds its place") {
  // Three parts of 1 m on a link of 3 m: elements to 0.5, 1.5, 2.5, 3 m.
  Mechanism mechanism;
  mechanism.nodes_at_joints = false;
  mechanism.element = Element::classical;
  mechanism.links = {test::link_of(Bar{3.0}, 3, LinkKind::bending)};
  const double places[] = {0.0, 0.49, 0.5, 0.51, 1.5, 1.6, 2.5, 2.7, 3.0};
  const std::size_t elements[] = {0, 0, 0, 1, 1, 2, 2, 3, 3};
  for (const double s : places) mechanism.loads.push_back(test::load_at(s, {0.0, 1.0, 0.0}));
  const Structure structure = structure_of(mechanism);
  REQUIRE(structure.links[0].springs.size() == 3);
  for (std::size_t i = 0; i < std::size(places); ++i) {
    CAPTURE(places[i]);
    CHECK(structure.loads[i].element == elements[i]);
    const double arm = places[i] - structure.links[0].elements[elements[i]].node;
    CHECK(structure.loads[i].motion(1, 2) == Approx(arm).margin(1e-14));
  }
}

TEST_CASE("a place in the world, and the mass of a link that is taken as rigid") {
  Mechanism mechanism;
  mechanism.links.resize(1);
  mechanism.links[0].origin = {1.0, 2.0};
  mechanism.links[0].angle = std::numbers::pi / 2.0;
  CHECK((in_world(mechanism, {0, {3.0, 0.5}}) - Eigen::Vector2d(0.5, 5.0)).norm() < 1e-15);
  CHECK((in_world(mechanism, {ground, {3.0, 0.5}}) - Eigen::Vector2d(3.0, 0.5)).norm() == 0.0);
  Chance chance(68);
  for (int i = 0; i < 50; ++i) {
    const Link link = random_elastic_link(chance);
    const Moments exact = moments_of(link);
    const RigidMass rigid = rigid_mass_of(link);
    CHECK(rigid.mass == Approx(exact.mass).epsilon(1e-13));
    CHECK(rigid.centre.x() == Approx(exact.first / exact.mass).epsilon(1e-13));
    CHECK(rigid.centre.y() == 0.0);
    CHECK(rigid.inertia ==
          Approx(exact.second - exact.first * exact.first / exact.mass).epsilon(1e-11));
  }
}

}  // namespace structure_test
