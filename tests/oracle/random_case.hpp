#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace oracle {

/// How the load cases of a frame combine, in numbers of the case's own.
struct Combining {
  struct LoadCase {
    std::string name;
    bool permanent = false;
    double psi_0 = 0.0;
  };
  bool by_ab = false;  ///< 6.10a and b; else 6.10 (EN 1990, 6.4.3.2)
  double gamma_G = 1.35, gamma_G_inf = 1.0, gamma_Q = 1.5, xi = 0.85;
  std::vector<LoadCase>
      cases;  ///< each acts alone in a situation "unit NAME"; none: nothing combines
};

/// A case as a user would write it, and the tables that it reads.
struct RandomCase {
  std::string name;
  std::string text;
  std::vector<std::pair<std::string, std::string>> tables;  ///< file name, content
  Combining combining = {};

  /// Writes it into a folder; returns the path of the case file.
  std::string write(const std::string& folder) const;
};

/// The same case for the same number on every machine: a beam in a plane (a crank's lever, a lever
/// on which a load slides, a cantilever, a beam on two supports), in space (a jib, a boom that
/// luffs) or of elastic links, of boxes, tubes, plates or one profile in another, tapered and
/// prismatic by turns, with details by stretch, holes, stiffeners, pins, their plates, rods, a
/// limit of deflection, forces on and off the axis that are constant, harmonic or follow a table,
/// and one or several situations; under forces of a file; under load cases that combine; with
/// diaphragms, restraints, plates of other steels and partial factors.
RandomCase random_case(std::uint64_t number);

}  // namespace oracle
