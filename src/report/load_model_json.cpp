#include "json_parts.hpp"

#include "front_end_text.hpp"

namespace boxbeam::report {
namespace {

void put_force(Fields& to, const Field& field, const Eigen::Vector2d& force) {
  to.object(field, [&](Fields& of) {
    of.number("fx", "N", force.x());
    of.number("fy", "N", force.y());
  });
}

}  // namespace

std::string situation_name(const Project& project, std::size_t situation) {
  return situation < project.situations.size() ? project.situations[situation].name : "";
}

void put_mechanism(Fields& to, const Project& project) {
  to.object_or_null(
      {"mechanism", "rigid bodies; null for elastic links"},
      front_end_text_of(project)->rigid_bodies(), [](Fields& of, const RigidBodies& rigid) {
        of.numbers({"gravity", "x, y in the plane, x, y, z in space"}, "m/s^2", rigid.gravity,
                   {"x", "y", "z"}, 2);
        of.named(
            "bodies", rigid.bodies, [](const auto& body) { return body.name; },
            [](Fields& one, const RigidBodies::Body& body) {
              one.number("mass", "kg", body.mass);
              one.number_or_null({"inertia", "about the centre of mass; null in space"}, "kg m^2",
                                 body.inertia);
            });
      });
}

void put_freedom(Fields& to, const Verification& verification) {
  const ClosureSummary* closure = nullptr;
  if (!verification.motions.empty() && verification.motions.front().closure)
    closure = &*verification.motions.front().closure;
  to.object_or_null("freedom", closure, [](Fields& of, const ClosureSummary& at) {
    of.whole({"gruebler", "3 bodies less the equations of the joints"}, at.freedom.gruebler, "1");
    of.whole("by_rank", at.freedom.by_rank, "1");
  });
}

void put_equivalent_mass(Fields& to, const Project& project, const Verification& verification) {
  to.object_or_null(
      "equivalent_mass", verification.equivalent_mass,
      [&](Fields& of, const planar::EquivalentMass& mass) {
        of.number({"given", "that the mechanism feels like where it is driven"}, "kg", mass.given);
        of.number({"per_mass", "its increase per kg of the adjustable body"}, "1", mass.per_mass);
        of.number("wanted", "kg", [&] { return project.equivalent_mass->wanted.value(); });
        of.number({"needed", "of the adjustable body"}, "kg", mass.needed);
      });
}

void put_newton_chain(Fields& to, const Verification& verification) {
  to.object_or_null(
      {"newton_chain",
       "the chain's forces on the ends of the beam, world axes, and the reactions of the mechanism "
       "beside them"},
      verification.chain, [](Fields& of, const ChainComparison& chain) {
        of.number({"time", "of the largest bending moment"}, "s", chain.time.value());
        put_force(of, "first", chain.chain_first);
        put_force(of, "second", chain.chain_second);
        of.number("sought_mass", "kg", chain.chain_mass.value());
        of.number({"moment_gap", "left over at the pivot"}, "N m", chain.moment_gap.value());
        const bool both = !chain.rigorous_first.isZero() || !chain.rigorous_second.isZero();
        of.object_or_null("rigorous", both ? &chain : nullptr,
                          [](Fields& beside, const ChainComparison& at) {
                            put_force(beside, "first", at.rigorous_first);
                            put_force(beside, "second", at.rigorous_second);
                          });
      });
}

void put_loads(Fields& to, const Project& project, const Verification& verification) {
  to.list({"loads", "of joints and loads on the beam at the critical instants"}, "{by}@{time}",
          verification.pictures.loads, [&](Fields& of, const BeamLoadRow& row) {
            of.text({"by", "point, joint or load"}, row.name);
            of.text("situation", situation_name(project, row.situation));
            of.number("time", "s", row.time.value());
            of.number("s", "m", row.s.value());
            of.vector({"world", "force, world axes"}, "N", row.world);
            of.vector({"force", "beam axes"}, "N", row.force);
            of.vector({"moment", "about the axis point at s, beam axes"}, "N m", row.moment);
          });
}

}  // namespace boxbeam::report
