#include "read_elasticity.hpp"

#include <fmt/format.h>

#include <limits>

namespace boxbeam::readers {
namespace {

/// A damper beside no spring moves nothing.
void check_spring_of_joint(TableReader& table, const char* stiffness, const char* damping) {
  if (!table.has(damping) || table.has(stiffness)) return;
  table.problem(damping,
                fmt::format("\"{}\" damps what gives way, and without \"{}\" nothing does", damping,
                            stiffness),
                fmt::format("write \"{}\" as well, or remove it", stiffness));
}

}  // namespace

GivesWay read_elasticity(TableReader& table, const CanGiveWay& gives_way) {
  constexpr double rigid = std::numeric_limits<double>::infinity();
  GivesWay of{rigid, 0.0, rigid, 0.0};
  if (gives_way.place) {
    const Key key{"stiffness",
                  "where it keeps a place or a distance, in elastic models alone; rigid where not "
                  "said"};
    if (table.has(key)) of.stiffness = table.positive(key, wanted::stiffness);
    of.damping = table.not_negative({"damping", "beside that stiffness"}, wanted::damping, 0.0);
    check_spring_of_joint(table, "stiffness", "damping");
  }
  if (gives_way.angle) {
    const Key key{"turning_stiffness",
                  "where it keeps an angle, in elastic models alone; rigid where not said"};
    if (table.has(key)) of.turning_stiffness = table.positive(key, wanted::torsional_stiffness);
    of.turning_damping = table.not_negative({"turning_damping", "beside that stiffness"},
                                            wanted::torsional_damping, 0.0);
    check_spring_of_joint(table, "turning_stiffness", "turning_damping");
  }
  return of;
}

}  // namespace boxbeam::readers
