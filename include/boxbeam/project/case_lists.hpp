#pragma once

#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// A section of a case under its name, a box.
struct NamedBox {
  std::string name;
  Box box;
};

/// Boxes that must have the same stiffeners.
struct AlikeBoxes {
  std::vector<NamedBox> boxes;
  std::vector<bool> segments;  ///< of the beam: which consist of them
};

/// The boxes at the ends of a segment, and all that taper into one of them along the beam. None
/// where one of them is no box that the case writes under a name that --set reaches.
AlikeBoxes alike_boxes_of(const Project& project, std::size_t segment);

/// The key of a beam's diaphragms as --set takes it: "beam.diaphragms", "beam.1.diaphragms".
std::string diaphragms_key_of(const Project& project);

/// Tables added to a list of a case, as --set takes them: "KEY=[..]" where the case has no such
/// list, else "KEY.3={..}" for each.
std::vector<std::string> added_to(const Project& project, const std::string& key,
                                  const std::vector<std::string>& tables);

}  // namespace boxbeam
