#pragma once

#include "boxbeam/mechanism/planar/beam_loads.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/project/project.hpp"
#include "support/program.hpp"

/// The shipped sledge rig, read once, for tests of the modules above the reader.
namespace test {

inline const boxbeam::Project& rig() {
  static const boxbeam::Project project =
      boxbeam::read_project(project_file("sections/sledge-rig/rig.toml"));
  return project;
}

/// The driver of a copy of its mechanism.
inline boxbeam::HarmonicDriver& exciter_of(boxbeam::planar::Mechanism& mechanism) {
  auto& driven = std::get<boxbeam::planar::Driven>(mechanism.joints.back().kind);
  return std::get<boxbeam::HarmonicDriver>(driven.driver);
}

inline boxbeam::planar::State rig_state(double time) {
  boxbeam::planar::InstantSolver solver(planar_of(rig()));
  return solver.solve_from_sketch(time, boxbeam::planar::sketch_of(planar_of(rig())));
}

}  // namespace test
