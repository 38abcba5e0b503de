#pragma once

#include <string>
#include <vector>

#include "boxbeam/verification/verify.hpp"

/// Remarks on parts of a case, each put behind those that are there.
namespace boxbeam::report {

// Details, holes and welds.
void add_details(const Project& project, std::vector<std::string>& remarks);
/// Rows that judge what forces press into webs.
void add_pressed(const Verification& verification, std::vector<std::string>& remarks);
/// Plates of pins of which the case does not say what their fatigue asks for.
void add_lugs(const Project& project, std::vector<std::string>& remarks);
void add_thin_welds(const Project& project, std::vector<std::string>& remarks);
void add_unsaid_welds(const Verification& verification, std::vector<std::string>& remarks);
void add_holes(const Project& project, std::vector<std::string>& remarks);
void add_short_lives(const Project& project, std::vector<std::string>& remarks);
/// Where one profile ends and another begins: a weld that nobody described carries what is cut.
void add_joined_profiles(const Project& project, std::vector<std::string>& remarks);

// Sections, their plates and their shape.
bool has_fillet_seams(const Project& project);
void add_slender_plates(const Project& project, const Verification& verification,
                        std::vector<std::string>& remarks);
void add_tapers(const Verification& verification, std::vector<std::string>& remarks);
void add_warping(const Project& project, std::vector<std::string>& remarks);
/// What is taken for granted of the shape of sections and their torsion.
std::string shape_text(const Project& project);
/// An inner profile and the outer one count as one section; what ties them together nobody
/// described.
void add_nested_profiles(const Project& project, std::vector<std::string>& remarks);

}  // namespace boxbeam::report
