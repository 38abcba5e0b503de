#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "readers.hpp"

namespace boxbeam::readers {
namespace {

using planar::Attachment;
using planar::Mechanism;

constexpr FunctionOf force{wanted::force, "N", "force", "the force does not change"};
constexpr FunctionOf moment{wanted::moment, "N m", "moment", "the couple does not change"};

planar::Spring read_spring(TableReader& table, const Mechanism& mechanism) {
  planar::Spring spring;
  std::tie(spring.a, spring.b) = ends_in(
      table, {{"connect", "its ends, \"body.point\", or \"ground\" for one of them"}, "a spring"},
      mechanism);
  read_spring_law(table, spring);
  return spring;
}

planar::TorsionSpring read_torsion_spring(TableReader& table, const Mechanism& mechanism) {
  planar::TorsionSpring spring;
  std::tie(spring.a, spring.b) =
      ends_in(table,
              {{"points", "the two bodies, \"body.point\", or \"ground\" for one of them"},
               "a torsion spring",
               false},
              mechanism);
  const TorsionOf of = read_torsion(table);
  spring.stiffness = of.stiffness;
  spring.free_angle = of.free_angle;
  spring.damping = of.damping;
  return spring;
}

planar::PointForce read_point_force(TableReader& table, const Mechanism& mechanism,
                                    TimeTables& tables) {
  planar::PointForce point;
  point.at = attachment_of(table, {"point", "where it acts, \"body.point\""}, mechanism);
  point.direction = table.quantity({"direction", "of the force"}, wanted::angle);
  point.turns = table.boolean({"turns_with_body", "the direction turns with the body"}, false);
  point.size = read_size(table, force, tables);
  return point;
}

/// On one point, against the ground; or on two, the opposite on the second.
planar::Couple read_couple(TableReader& table, const Mechanism& mechanism, TimeTables& tables) {
  planar::Couple couple;
  const std::size_t before = table.problems().size();
  const std::size_t count =
      table.texts({"points", "the body, or two: the opposite acts on the second"}, true).size();
  if (count == 1) {
    couple.a = attachments_of(table, "points", 1, mechanism).front();
  } else if (table.problems().size() == before) {
    std::tie(couple.a, couple.b) = ends_in(table, {"points", "a couple", false}, mechanism);
  }
  couple.size = read_size(table, moment, tables);
  return couple;
}

planar::ForceKind read_kind(TableReader& table, std::size_t kind, const Mechanism& mechanism,
                            TimeTables& tables) {
  switch (kind) {
    case 0: return read_spring(table, mechanism);
    case 1: return read_torsion_spring(table, mechanism);
    case 2: return read_point_force(table, mechanism, tables);
    default: return read_couple(table, mechanism, tables);
  }
}

/// Exponent and restitution; makes a stiffness at a depth that of the law.
Impact read_impact(TableReader& table, double& stiffness) {
  Impact impact;
  const std::size_t before = table.problems().size();
  impact.restitution =
      table.any_number({"restitution", "velocity after a free impact over that before, 0.05 to 1"});
  if (table.problems().size() == before &&
      !(impact.restitution >= least_restitution && impact.restitution <= 1.0)) {
    table.problem("restitution",
                  fmt::format("\"restitution\" goes from {} to 1", least_restitution),
                  "write 1 where nothing is lost, 0.5 to 0.9 of steel on steel; what sticks where "
                  "it falls is not computed");
    impact.restitution = 1.0;
  }
  impact.exponent = table.any_number(
      {"exponent", "of the depth in the contact force: 1, or 1.5 of round bodies (Hertz)"}, 1.0);
  if (impact.exponent != 1.0 && impact.exponent != 1.5) {
    table.problem("exponent", "\"exponent\" is 1 or 1.5", "leave it out for 1");
    impact.exponent = 1.0;
  }
  const Key depth_of{"stiffness_at",
                     "where \"exponent\" is 1.5: the depth at which the stiffness is the force "
                     "over the depth"};
  if (impact.exponent != 1.0) {
    const double depth = table.positive(depth_of, wanted::length);
    if (depth > 0.0) stiffness /= std::pow(depth, impact.exponent - 1.0);
  } else if (table.has_quantity(depth_of, wanted::length)) {
    table.problem("stiffness_at", "with an exponent of 1 the stiffness is that of any depth",
                  "remove it, or write exponent = 1.5");
  }
  return impact;
}

}  // namespace

ActingOf read_acting(TableReader& spring, double& stiffness, double damping) {
  ActingOf of;
  of.acts = static_cast<Acts>(spring.choice(
      {"acts",
       "a cable only pulls, and that where it is longer than free_length; a stop or a "
       "tyre only pushes, where it is shorter; stiffness and damping together: none "
       "where their sum would do the other"},
      {"both ways", "pulling", "pushing"}, 0));
  const bool lost = spring.has_number({"restitution",
                                       "instead of damping: velocity after a free impact over that "
                                       "before, 0.05 to 1"});
  if (!lost) {
    for (const char* key : {"exponent", "stiffness_at"}) {
      if (spring.is_there(key) && spring.has_misplaced(key))
        spring.problem(key, fmt::format("\"{}\" is of what parts again after it touches", key),
                       "write restitution = 0.8 as well, 1 where nothing is lost");
    }
    return of;
  }
  const bool stiff = stiffness > 0.0;
  of.impact = read_impact(spring, stiffness);
  if (of.acts == Acts::both) {
    spring.problem("restitution", "a spring that acts both ways touches nothing",
                   "write acts = \"pushing\" of a stop, \"pulling\" of a cable");
  }
  if (damping != 0.0) {
    spring.problem("restitution", "what an impact loses is said twice",
                   "write restitution, or damping");
  }
  if (!stiff) {
    spring.problem("restitution", "what parts again after it touches has a stiffness",
                   "write for example stiffness = \"200 kN/m\"");
  }
  return of;
}

std::optional<ClearanceOf> read_clearance(TableReader& joint) {
  const Key clearance_of{
      "clearance",
      "radius of the bearing less that of the pin or ball: the joint is a contact, and "
      "forces move what it leaves free"};
  if (!joint.has_quantity(clearance_of, wanted::length)) {
    for (const char* key : {"contact_stiffness", "restitution", "exponent", "stiffness_at"}) {
      if (joint.is_there(key) && joint.has_misplaced(key))
        joint.problem(key, fmt::format("\"{}\" is of a joint with clearance", key),
                      "write clearance = \"0.2 mm\" as well, or remove it");
    }
    return std::nullopt;
  }
  ClearanceOf of;
  of.clearance = joint.positive(clearance_of, wanted::length);
  if (joint.has_quantity({"contact_stiffness", "force over depth of the contact"},
                         wanted::stiffness)) {
    of.stiffness = joint.positive("contact_stiffness", wanted::stiffness);
  } else {
    joint.problem(
        "", "a joint with clearance wants the stiffness of its contact, which has no default",
        "write contact_stiffness: of a steel pin about pi E* L/9, L its length in the bearing and "
        "E* = E/(2 (1 - nu^2)); of a ball exponent = 1.5 with 4/3 E* sqrt(R d) at the depth d "
        "(Johnson, Contact Mechanics, 1985, chapters 4 and 5); less where a link, E A/l, gives way "
        "more");
  }
  of.impact = read_impact(joint, of.stiffness);
  return of;
}

TorsionOf read_torsion(TableReader& table) {
  TorsionOf of;
  of.stiffness = table.not_negative({"stiffness", "moment per angle"}, wanted::torsional_stiffness);
  of.free_angle = table.quantity({"free_angle", "without moment"}, wanted::angle, 0.0);
  of.damping = table.not_negative({"damping", "moment per angular velocity"},
                                  wanted::torsional_damping, 0.0);
  refuse_idle(table, of.stiffness, of.damping, wanted::torsional_stiffness);
  return of;
}

void refuse_idle(TableReader& table, double stiffness, double damping,
                 const WantedDimension& of_stiffness) {
  if (stiffness != 0.0 || damping != 0.0) return;
  table.problem("stiffness", "the spring has neither stiffness nor damping",
                fmt::format("write for example stiffness = {}", of_stiffness.example));
}

Driver read_size(TableReader& table, const FunctionOf& of, TimeTables& tables) {
  if (!table.says_one_of({{{"size"}}, {{"law"}}})) {
    table.problem("", fmt::format("[{}] wants either \"size\" or \"law\"", table.name()),
                  fmt::format("size = {} for a constant, law = {{ kind = \"harmonic\", ... }} for "
                              "a function of time",
                              of.value.example));
    return PolynomialDriver{{0.0}};
  }
  if (table.has("size")) return PolynomialDriver{{table.quantity({"size", "constant"}, of.value)}};
  TableReader law = table.table({"law", "a function of time instead"});
  const std::optional<Driver> function = read_function(law, of, tables);
  if (function) law.finish();
  return function.value_or(PolynomialDriver{{0.0}});
}

void read_forces(TableReader& root, Mechanism& mechanism, TimeTables& tables) {
  TableReader forces = root.table({"forces", "springs, forces and couples"}, false);
  for (auto& [name, table] : forces.named_tables()) {
    check_name(table, name, "force", mechanism);
    planar::AppliedForce applied{name, planar::Spring{}};
    const std::size_t before = table.problems().size();
    const std::size_t kind =
        table.kind({"kind", "of force"}, {"spring", "torsion spring", "force", "couple"});
    // Where the kind is not known, neither is what the other keys mean.
    if (table.problems().size() == before) {
      applied.kind = read_kind(table, kind, mechanism, tables);
      table.finish();
    }
    mechanism.forces.push_back(std::move(applied));
  }
}

}  // namespace boxbeam::readers
