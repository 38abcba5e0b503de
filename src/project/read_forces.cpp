#include <fmt/format.h>

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
  spring.stiffness = table.not_negative({"stiffness", "force per length"}, wanted::stiffness);
  spring.free_length = table.not_negative({"free_length", "without force"}, wanted::length, 0.0);
  spring.damping = table.not_negative({"damping", "force per velocity"}, wanted::damping, 0.0);
  refuse_idle(table, spring.stiffness, spring.damping, wanted::stiffness);
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

}  // namespace

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
