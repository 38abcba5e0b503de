#pragma once

#include <stdexcept>
#include <string>

#include "boxbeam/verification/neighbours.hpp"
#include "boxbeam/verification/verify.hpp"
#include "support/held_bar.hpp"

namespace test {

/// The bar on a prop, or under a hanger, of the given section, which a force at its end pushes so
/// that the rod bears `size` beside the bar's own 400 N.
inline boxbeam::Project rod_under(bool from_above, const std::string& direction,
                                  const std::string& size, const std::string& section,
                                  const std::string& more = "") {
  const std::string flat = "kind = \"plate\"\nwidth = \"50 mm\"\nheight = \"100 mm\"\n";
  return held_bar(from_above, flat,
                  "[forces.push]\nkind = \"force\"\npoint = \"bar.B\"\ndirection = \"" + direction +
                      "\"\nsize = \"" + size + "\"\n[sections.strut]\n" + section +
                      "[[rods]]\nname = \"strut\"\nfrom = \"rod.P\"\nto = \"rod.Q\"\n"
                      "section = \"strut\"\ncurve = \"c\"\n" +
                      more);
}

inline boxbeam::NeighbourChecks rods_of(const boxbeam::Project& project) {
  return boxbeam::check_rods(project, boxbeam::run_situations(project));
}

/// The check of the only rod by a criterion.
inline boxbeam::NeighbourResult rod_result(const boxbeam::Project& project,
                                           boxbeam::Criterion criterion) {
  for (boxbeam::NeighbourResult& result : rods_of(project).results)
    if (result.check.criterion == criterion) return result;
  throw std::runtime_error(std::string("no check of ") + boxbeam::to_text(criterion));
}

inline boxbeam::NeighbourResult buckling_of(const boxbeam::Project& project) {
  return rod_result(project, boxbeam::Criterion::buckling);
}

inline boxbeam::CompressionResistance compression_of(const boxbeam::NeighbourResult& result) {
  return boxbeam::compression_resistance_of(std::get<boxbeam::PressedRod>(result.basis));
}

inline boxbeam::TensionResistance tension_of(const boxbeam::NeighbourResult& result) {
  return boxbeam::tension_resistance_of(std::get<boxbeam::PulledRod>(result.basis));
}

}  // namespace test
