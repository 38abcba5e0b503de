#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace oracle {

/// A case as a user would write it, and the tables that it reads.
struct RandomCase {
  std::string name;
  std::string text;
  std::vector<std::pair<std::string, std::string>> tables;  ///< file name, content

  /// Writes it into a folder; returns the path of the case file.
  std::string write(const std::string& folder) const;
};

/// The same case for the same number on every machine: a beam in a plane (a crank's lever, a lever
/// on which a load slides, a cantilever, a beam on two supports), in space (a jib) or of elastic
/// links, of boxes, tubes, plates or one profile in another, tapered and prismatic by turns, with
/// details by stretch, holes, stiffeners, pins, rods, a limit of deflection, forces on and off the
/// axis that are constant, harmonic or follow a table, and one or several situations.
RandomCase random_case(std::uint64_t number);

}  // namespace oracle
