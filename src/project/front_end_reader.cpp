#include "front_end_reader.hpp"

#include <fmt/format.h>

#include <array>

namespace boxbeam::readers {

std::unique_ptr<FrontEndReader> front_end_reader(Kind kind, const Sections& sections,
                                                 TimeTables& tables, Project& project) {
  switch (kind) {
    case Kind::planar: return planar_reader(sections, tables, project);
    case Kind::spatial: return spatial_reader(sections, tables, project);
    case Kind::flexible: return flexible_reader(sections, tables, project);
  }
  return {};
}

Changeable changeable_of_bodies(const std::string& beam_body) {
  static constexpr std::array parts{"mechanism", "bodies", "joints", "drivers",
                                    "forces",    "loops",  "motion"};
  return {parts, "drivers.exciter.frequency", beam_body};
}

void refuse_planar_parts(TableReader& root, const char* kind) {
  for (const char* key :
       {"loops", "newton_chain", "equivalent_mass", "pins", "rods", "deflection"}) {
    if (!root.has_misplaced(key)) continue;
    root.problem(key, fmt::format("\"{}\" is known for rigid mechanisms in the plane only", key),
                 fmt::format("remove it from this case of kind = \"{}\"", kind));
  }
}

}  // namespace boxbeam::readers
