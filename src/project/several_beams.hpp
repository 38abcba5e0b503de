#pragma once

#include "readers.hpp"

/// A case may have several beams, [[beam]] with a name each. It is read once for each of them, as a
/// case of that beam in which the others are bodies, links or members with mass and stiffness.
namespace boxbeam::readers {

/// The case as it is for one of its beams: what that beam says itself of its material, strength,
/// fatigue, points, welds and deflection goes before what the case says for all, key by key.
Node case_of_beam(const Node& root, std::size_t beam);

/// Whether a beam of several says itself of what material it is, or what is wanted of it: of what
/// is beside the beams, too, where that says nothing.
bool differ_in_demands(const Node& root);

/// Notes what stands along a beam and belongs to none where there are several, and names that are
/// missing or stand twice.
void check_beams(ProblemList& problems, const Node& root);

/// The table of one of the beams, whose name and own parts are read.
TableReader beam_table(TableReader& root, std::size_t beam);

/// The table of the project's beam.
TableReader beam_table(TableReader& root, const Project& project);

/// A beam of the case beside the one that is verified.
struct OtherBeam {
  std::string on;  ///< the body or link that it is
  TaperedBeam beam;
};

/// The other beams; `key`: by which each names its body or link.
std::vector<OtherBeam> read_other_beams(TableReader& root, const Key& key, const Sections& sections,
                                        const Project& project);

/// Names of the bodies or links that are beams: that of the verified one and of the others.
std::vector<std::string> names_of_beams(const std::string& verified,
                                        const std::vector<OtherBeam>& others);

}  // namespace boxbeam::readers
