#include "front_end_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace boxbeam::readers {

std::unique_ptr<FrontEndReader> front_end_reader(const Sections& sections, TimeTables& tables,
                                                 Project& project) {
  return std::visit(
      [&](const auto& mechanism) { return reader_for(mechanism, sections, tables, project); },
      project.mechanism);
}

Changeable changeable_of_bodies(const std::string& beam_body) {
  static constexpr std::array parts{"mechanism", "bodies", "joints", "drivers",
                                    "forces",    "loops",  "motion"};
  return {parts, "drivers.exciter.frequency", beam_body};
}

void refuse_other_joints(TableReader& root, bool other) {
  if (other)
    root.problem("joints", "the stiffness and damping of joints are those of all situations",
                 "change them in [joints] itself, for example by --set");
}

void refuse_planar_parts(TableReader& root, const Project& project, Known known) {
  for (const char* key :
       {"loops", "newton_chain", "equivalent_mass", "pins", "rods", "deflection"}) {
    const std::string_view name = key;
    const bool deflection = name == "deflection", neighbours = name == "pins" || name == "rods",
               loops = name == "loops";
    if ((known.deflection && deflection) || (known.neighbours && neighbours) ||
        (known.loops && loops) || !root.has_misplaced(key))
      continue;
    root.problem(
        key,
        fmt::format("\"{}\" is known for {}", key,
                    deflection            ? "rigid mechanisms, static and loads cases only"
                    : neighbours || loops ? "rigid mechanisms only"
                                          : "rigid mechanisms in the plane only"),
        fmt::format("remove it from this case of kind = \"{}\"", kind_word_of(project.mechanism)));
  }
}

}  // namespace boxbeam::readers
