#pragma once

#include <string>
#include <utility>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/gates.hpp"

namespace boxbeam {

/// What stands against the whole section of a station.
inline Gate section_gate_at(const Project& project, const Station& station, std::string finding,
                            bool blocks = true) {
  const std::size_t segment = segment_at(project.beam, station);
  return {project.beam.segments[segment].name, "", std::move(finding), blocks};
}

}  // namespace boxbeam
