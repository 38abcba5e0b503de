#pragma once

#include <deque>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/verify.hpp"
#include "support/program.hpp"

/// The shipped cases, each read and verified once, for tests of reports.
namespace test {

struct ShippedCase {
  std::string path;  ///< "sections/sledge-rig/rig.toml"
  boxbeam::Project project;
  boxbeam::Verification verification;
};

inline const std::vector<std::string>& shipped_paths() {
  static const std::vector<std::string> paths{
      "sections/sledge-rig/rig.toml",           "sections/sledge-rig/published.toml",
      "sections/sledge-rig/rig-detailed.toml",  "sections/sledge-rig/friction.toml",
      "sections/sledge-rig/slender.toml",       "sections/landing-gear/gear.toml",
      "sections/landing-gear/retraction.toml",  "sections/drill-truck/truck.toml",
      "sections/four-bar-rocker/rocker.toml",   "sections/scissor-lift/lift.toml",
      "sections/slider-crank-press/press.toml", "sections/pump-jack/beam.toml",
      "sections/crane-girder/girder.toml",      "sections/jib-crane/jib.toml",
      "sections/excavator-boom/boom.toml"};
  return paths;
}

inline const std::deque<ShippedCase>& shipped_cases() {
  static const std::deque<ShippedCase> cases = [] {
    std::deque<ShippedCase> all;
    for (const std::string& path : shipped_paths()) {
      ShippedCase& of = all.emplace_back();
      of.path = path;
      of.project = boxbeam::read_project(project_file(path));
      of.verification = boxbeam::verify(of.project, boxbeam::Figures::with);
    }
    return all;
  }();
  return cases;
}

}  // namespace test
